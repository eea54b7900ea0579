//! Raster images, and PNG files of them.

/// An image: rows from the top, three bytes (sRGB) per pixel.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Image {
    /// The width in pixels.
    pub width: usize,
    /// The height in pixels.
    pub height: usize,
    /// Red, green, blue of each pixel.
    pub rgb: Vec<u8>,
}

/// The reason why an image cannot be made.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum PictureError {
    /// A side is zero, or larger than 32,767 pixels.
    #[error("a picture cannot be {width} by {height} pixels")]
    Size {
        /// The width in pixels.
        width: usize,
        /// The height in pixels.
        height: usize,
    },
    /// The encoder failed.
    #[error("png: {0}")]
    Encode(String),
}

impl Image {
    /// An image of one colour (sRGB bytes).
    pub fn new(width: usize, height: usize, colour: [u8; 3]) -> Self {
        Self { width, height, rgb: colour.repeat(width * height) }
    }

    /// The colour of a pixel, counted from the top left; `None` outside the image.
    pub fn pixel(&self, x: usize, y: usize) -> Option<[u8; 3]> {
        let at = 3 * (y * self.width + x);
        let inside = x < self.width && y < self.height;
        inside.then(|| self.rgb.get(at..at + 3)?.try_into().ok()).flatten()
    }

    /// Copies another image into this one, its top left pixel to (`left`, `top`); parts that do not
    /// fit are clipped.
    ///
    /// ```
    /// use vc_procgen::picture::Image;
    /// let mut sheet = Image::new(4, 4, [255; 3]);
    /// sheet.paste(2, 2, &Image::new(9, 9, [0; 3]));
    /// assert_eq!((sheet.pixel(1, 1), sheet.pixel(3, 3)), (Some([255; 3]), Some([0; 3])));
    /// ```
    pub fn paste(&mut self, left: usize, top: usize, other: &Self) {
        let wide = other.width.min(self.width.saturating_sub(left)) * 3;
        for y in 0..other.height.min(self.height.saturating_sub(top)) {
            let from = y * other.width * 3;
            let to = ((top + y) * self.width + left) * 3;
            self.rgb[to..to + wide].copy_from_slice(&other.rgb[from..from + wide]);
        }
    }

    /// The image as a PNG file.
    ///
    /// ```
    /// use vc_procgen::picture::Image;
    /// assert!(Image::new(2, 2, [0; 3]).to_png()?.starts_with(b"\x89PNG"));
    /// # Ok::<(), vc_procgen::picture::PictureError>(())
    /// ```
    ///
    /// # Errors
    /// [`PictureError`] if it has no pixels, or a number of pixels that contradicts its size.
    pub fn to_png(&self) -> Result<Vec<u8>, PictureError> {
        let fail = |e: png::EncodingError| PictureError::Encode(e.to_string());
        let mut file = Vec::new();
        let mut encoder = png::Encoder::new(&mut file, self.width as u32, self.height as u32);
        encoder.set_color(png::ColorType::Rgb);
        let mut writer = encoder.write_header().map_err(fail)?;
        writer.write_image_data(&self.rgb).map_err(fail)?;
        writer.finish().map_err(fail)?;
        Ok(file)
    }
}
