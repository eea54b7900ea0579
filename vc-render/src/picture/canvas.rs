//! Pictures in memory.

/// A picture in sRGB colours, rows from the top. Drawing leaves out pixels that a picture lacks because its list is
/// shorter than its size says; encoding refuses such a picture.
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
        let own = self.pixels.chunks_exact_mut(self.width).take(self.height).skip(y);
        let others = other.pixels.chunks_exact(other.width).take(other.height);
        own.zip(others).for_each(|(to, from)| to[x..x + width].copy_from_slice(&from[..width]));
    }

    /// Whether it has as many pixels as its size says.
    pub(super) fn is_whole(&self) -> bool {
        self.width.checked_mul(self.height) == Some(self.pixels.len())
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
    /// Remaining pixels at the right and below are dropped, and so are rows that lack pixels. Linear in the pixels
    /// of the larger picture, in parallel.
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
        let rows = self.height.min(self.pixels.len() / self.width.max(1));
        let (width, height) = (self.width / times, rows / times);
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
        let across = (x..=right).flat_map(|column| [(column, y), (column, bottom)]);
        let down = (y..=bottom).flat_map(|row| [(x, row), (right, row)]);
        across.chain(down).for_each(|(x, y)| self.dot(x, y, colour));
    }

    /// Draws a pixel, if the picture has it.
    fn dot(&mut self, x: usize, y: usize, colour: [u8; 3]) {
        let row = self.pixels.chunks_mut(self.width.max(1)).take(self.height).nth(y);
        if let Some(pixel) = row.and_then(|row| row.get_mut(x)) {
            *pixel = colour;
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
            if x >= 0.0 && y >= 0.0 {
                self.dot(x as usize, y as usize, colour);
            }
        }
    }
}
