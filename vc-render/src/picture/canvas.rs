//! Pictures in memory.

/// A picture in sRGB colours, rows from the top.
///
/// ```
/// use vc_render::picture::Picture;
/// let mut flag = Picture::new(4, 2, [255; 3]);
/// flag.paste(&Picture::new(2, 2, [200, 0, 0]), 2, 0);
/// assert_eq!(flag.pixels[..4], [[255; 3], [255; 3], [200, 0, 0], [200, 0, 0]]);
/// // A contact sheet of three, with a white line around each.
/// let sheet = Picture::sheet(&[flag.clone(), flag.clone(), flag], 3, 1);
/// assert_eq!((sheet.width, sheet.height), (3 * 5 + 1, 2 + 2));
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Picture {
    /// Pixels across.
    pub width: usize,
    /// Pixels down.
    pub height: usize,
    /// `height * width` colours.
    pub pixels: Vec<[u8; 3]>,
}

impl Picture {
    /// A picture of one colour.
    pub fn new(width: usize, height: usize, colour: [u8; 3]) -> Self {
        Self { width, height, pixels: vec![colour; width * height] }
    }

    /// Pastes another picture in, with its upper left corner at a pixel; parts outside are cut off. Costs a
    /// copy of the pasted pixels.
    pub fn paste(&mut self, other: &Self, x: usize, y: usize) {
        let width = other.width.min(self.width.saturating_sub(x));
        if width == 0 {
            return;
        }
        for row in 0..other.height.min(self.height.saturating_sub(y)) {
            let to = (y + row) * self.width + x;
            self.pixels[to..to + width].copy_from_slice(&other.pixels[row * other.width..][..width]);
        }
    }

    /// Arranges pictures of one size in a grid of `columns` columns, with white margins of `margin` pixels. The
    /// first picture determines the size: larger ones are partly covered by the next or cut off. Costs a copy
    /// of all pixels.
    pub fn sheet(pictures: &[Self], columns: usize, margin: usize) -> Self {
        let (columns, first) = (columns.max(1), pictures.first());
        let (width, height) = first.map_or((0, 0), |p| (p.width, p.height));
        let rows = pictures.len().div_ceil(columns);
        let mut all = Self::new(columns * (width + margin) + margin, rows * (height + margin) + margin, [255; 3]);
        for (i, picture) in pictures.iter().enumerate() {
            all.paste(picture, margin + (i % columns) * (width + margin), margin + (i / columns) * (height + margin));
        }
        all
    }

    /// The picture shrunk by a factor along each side; each pixel becomes the mean light of a square of pixels.
    /// With colours rendered at a larger size, seams and bars thinner than a pixel do not look dashed.
    /// Remaining pixels at the right and below are dropped. Linear in the pixels of the larger picture, in
    /// parallel.
    ///
    /// ```
    /// use vc_render::picture::Picture;
    /// let mut board = Picture::new(4, 2, [0; 3]);
    /// board.pixels[0] = [255; 3];
    /// let small = board.shrunk(2);
    /// assert_eq!((small.width, small.height), (2, 1));
    /// // A quarter of the light, in sRGB.
    /// assert_eq!(small.pixels, [[137; 3], [0; 3]]);
    /// ```
    #[must_use]
    pub fn shrunk(&self, times: usize) -> Self {
        let times = times.max(1);
        let (width, height) = (self.width / times, self.height / times);
        let mut whole = Self::new(width * times, height * times, [0; 3]);
        whole.paste(self, 0, 0);
        let mut small = Self { width, height, pixels: Vec::new() };
        if width > 0 {
            crate::colour::shrink(&whole.pixels, times, (width, &mut small.pixels));
        }
        small
    }

    /// Draws the outline of a pixel box.
    pub(super) fn outline(&mut self, of: &crate::PixelBox, colour: [u8; 3]) {
        let Some(within) = of.within(self.width, self.height) else { return };
        let (x, y) = (within.x as usize, within.y as usize);
        let (right, bottom) = (x + within.width as usize - 1, y + within.height as usize - 1);
        for column in x..=right {
            self.pixels[y * self.width + column] = colour;
            self.pixels[bottom * self.width + column] = colour;
        }
        for row in y..=bottom {
            self.pixels[row * self.width + x] = colour;
            self.pixels[row * self.width + right] = colour;
        }
    }

    /// Draws a line between two points, pixels.
    pub(super) fn line(&mut self, from: [f32; 2], to: [f32; 2], colour: [u8; 3]) {
        let far = |p: [f32; 2]| !(p[0].abs() < 1e5 && p[1].abs() < 1e5);
        if far(from) || far(to) {
            return;
        }
        let steps = (to[0] - from[0]).abs().max((to[1] - from[1]).abs()).ceil().max(1.0);
        for i in 0..=steps as usize {
            let at = |axis: usize| from[axis] + (to[axis] - from[axis]) * i as f32 / steps;
            let (x, y) = (at(0), at(1));
            if x >= 0.0 && y >= 0.0 && (x as usize) < self.width && (y as usize) < self.height {
                self.pixels[y as usize * self.width + x as usize] = colour;
            }
        }
    }
}
