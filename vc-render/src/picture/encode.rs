//! PNG and animated PNG.

use png::{BitDepth, ColorType, Compression, Encoder};

use super::Picture;
use crate::RenderError;

/// A picture as PNG.
///
/// # Errors
/// [`RenderError::Encoding`] for an empty picture.
pub fn png(picture: &Picture) -> Result<Vec<u8>, RenderError> {
    encoded(std::slice::from_ref(picture), None)
}

/// Pictures of one size as animated PNG, which repeats for ever.
///
/// # Errors
/// [`RenderError::Encoding`] for no pictures, or pictures of different size.
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
