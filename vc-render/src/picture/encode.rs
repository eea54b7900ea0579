//! PNG and animated PNG.

use png::{BitDepth, ColorType, Compression, Encoder};

use super::Picture;
use crate::RenderError;

/// A picture as PNG: RGB, eight bits a channel. Linear in its pixels; deflating takes nearly all of the time.
///
/// # Errors
/// [`RenderError::Encoding`] for an empty picture.
///
/// ```
/// use vc_render::picture::{self, Picture};
/// let file = picture::png(&Picture::new(4, 2, [200, 30, 30]))?;
/// assert!(file.starts_with(b"\x89PNG"));
/// assert!(picture::png(&Picture::new(0, 0, [0; 3])).is_err());
/// # Ok::<(), vc_render::RenderError>(())
/// ```
pub fn png(picture: &Picture) -> Result<Vec<u8>, RenderError> {
    encoded(std::slice::from_ref(picture), None)
}

/// Pictures of one size as animated PNG, which repeats for ever, so many of them `per_second` (one at least). Each
/// costs as much as [`png()`] of it.
///
/// # Errors
/// [`RenderError::Encoding`] for no pictures, empty ones, or pictures of different size.
///
/// ```
/// use vc_render::picture::{self, Picture};
/// let blinking = [[0; 3], [255; 3]].map(|colour| Picture::new(4, 2, colour));
/// let file = picture::apng(&blinking, 10)?;
/// assert!(file.windows(4).any(|word| word == b"acTL")); // it is animated
/// assert!(picture::apng(&[], 10).is_err());
/// # Ok::<(), vc_render::RenderError>(())
/// ```
pub fn apng(pictures: &[Picture], per_second: u16) -> Result<Vec<u8>, RenderError> {
    encoded(pictures, Some(per_second))
}

fn encoded(pictures: &[Picture], per_second: Option<u16>) -> Result<Vec<u8>, RenderError> {
    let first = pictures.first().ok_or_else(|| RenderError::Encoding("no pictures".into()))?;
    if pictures.iter().any(|p| (p.width, p.height) != (first.width, first.height)) {
        return Err(RenderError::Encoding("pictures of different size".into()));
    }
    let failed = |e: png::EncodingError| RenderError::Encoding(e.to_string());
    let mut bytes = Vec::new();
    let mut encoder = Encoder::new(&mut bytes, first.width as u32, first.height as u32);
    encoder.set_color(ColorType::Rgb);
    encoder.set_depth(BitDepth::Eight);
    encoder.set_compression(Compression::Balanced);
    if let Some(rate) = per_second {
        encoder.set_animated(pictures.len() as u32, 0).map_err(failed)?;
        encoder.set_frame_delay(1, rate.max(1)).map_err(failed)?;
    }
    let mut writer = encoder.write_header().map_err(failed)?;
    for picture in pictures {
        writer.write_image_data(picture.pixels.as_flattened()).map_err(failed)?;
    }
    writer.finish().map_err(failed)?;
    Ok(bytes)
}
