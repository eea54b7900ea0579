//! PNG, animated PNG, GIF and JPEG files.

use png::{BitDepth, ColorType, Compression, Encoder};
use rayon::prelude::*;

use super::Picture;
use crate::RenderError;

/// Encodes a picture as PNG: RGB, eight bits for each channel. Linear in its pixels; compression takes nearly
/// all of the time.
///
/// # Errors
/// [`RenderError::Encoding`] for an empty picture, or one with more or fewer pixels than its size says.
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

/// Encodes pictures of one size as animated PNG, which repeats forever, at `per_second` pictures a second (at
/// least one). Each costs as much as [`png()`] of it.
///
/// # Errors
/// [`RenderError::Encoding`] as for [`png()`], for no pictures, or for pictures of different size.
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

/// Encodes pictures of one size as GIF, which repeats forever, at `per_second` pictures a second; GIF rounds
/// the time of a picture to hundredths of a second. Each picture has its own palette of 256 colours. Costs some
/// 0.2 microseconds for each pixel, in parallel; the bytes do not depend on the number of threads.
///
/// # Errors
/// [`RenderError::Encoding`] as for [`png()`], for no pictures, pictures of different size, or of more than 65,535
/// pixels along a side.
///
/// ```
/// use vc_render::picture::{self, Picture};
/// let blinking = [[0; 3], [255; 3]].map(|colour| Picture::new(4, 2, colour));
/// assert!(picture::gif(&blinking, 10)?.starts_with(b"GIF89a"));
/// assert!(picture::gif(&[], 10).is_err());
/// # Ok::<(), vc_render::RenderError>(())
/// ```
pub fn gif(pictures: &[Picture], per_second: u16) -> Result<Vec<u8>, RenderError> {
    let first = of_one_size(pictures)?;
    let (width, height) = short_sides(first)?;
    let delay = (100 + per_second / 2) / per_second.max(1);
    let frame = |picture: &Picture| {
        let pixels = picture.pixels.as_flattened();
        gif::Frame { delay, ..gif::Frame::from_rgb_speed(width, height, pixels, GIF_SPEED) }
    };
    let frames: Vec<gif::Frame<'static>> = pictures.par_iter().map(frame).collect();
    let failed = |e: gif::EncodingError| RenderError::Encoding(e.to_string());
    let mut encoder = gif::Encoder::new(Vec::new(), width, height, &[]).map_err(failed)?;
    encoder.set_repeat(gif::Repeat::Infinite).map_err(failed)?;
    frames.iter().try_for_each(|frame| encoder.write_frame(frame)).map_err(failed)?;
    encoder.into_inner().map_err(|e| RenderError::Encoding(e.to_string()))
}

/// Encodes a picture as JPEG of a `quality` from 1 to 100. Linear in its pixels.
///
/// # Errors
/// [`RenderError::Encoding`] as for [`png()`], or for a picture of more than 65,535 pixels along a side.
///
/// ```
/// use vc_render::picture::{self, Picture};
/// let file = picture::jpeg(&Picture::new(4, 2, [200, 30, 30]), 90)?;
/// assert!(file.starts_with(&[0xff, 0xd8]));
/// assert!(picture::jpeg(&Picture::new(0, 0, [0; 3]), 90).is_err());
/// # Ok::<(), vc_render::RenderError>(())
/// ```
pub fn jpeg(picture: &Picture, quality: u8) -> Result<Vec<u8>, RenderError> {
    whole(picture)?;
    let (width, height) = short_sides(picture)?;
    let mut bytes = Vec::new();
    let encoder = jpeg_encoder::Encoder::new(&mut bytes, quality.clamp(1, 100));
    let written = encoder.encode(picture.pixels.as_flattened(), width, height, jpeg_encoder::ColorType::Rgb);
    written.map_err(|e| RenderError::Encoding(e.to_string()))?;
    Ok(bytes)
}

/// Speed setting of the GIF encoder, 1 to 30: higher is coarser, but at 10 colours still look as good as at 1.
const GIF_SPEED: i32 = 10;

/// Width and height of a nonempty picture, for formats with sixteen bits for each.
fn short_sides(picture: &Picture) -> Result<(u16, u16), RenderError> {
    let short = |side: usize| u16::try_from(side).ok().filter(|side| *side > 0);
    let sides = short(picture.width).zip(short(picture.height));
    sides.ok_or_else(|| {
        let (width, height) = (picture.width, picture.height);
        RenderError::Encoding(format!("a picture of {width} by {height} pixels: sides are 1 to 65535"))
    })
}

/// The first picture, if all have its size and are whole.
fn of_one_size(pictures: &[Picture]) -> Result<&Picture, RenderError> {
    let first = pictures.first().ok_or_else(|| RenderError::Encoding("no pictures".into()))?;
    if pictures.iter().any(|p| (p.width, p.height) != (first.width, first.height)) {
        return Err(RenderError::Encoding("pictures of different size".into()));
    }
    pictures.iter().try_for_each(whole)?;
    Ok(first)
}

/// Refuses a picture that has not as many pixels as its size says.
fn whole(picture: &Picture) -> Result<(), RenderError> {
    let Picture { width, height, pixels } = picture;
    let wrong = || format!("a picture of {width} by {height} pixels has {} of them", pixels.len());
    picture.is_whole().then_some(()).ok_or_else(|| RenderError::Encoding(wrong()))
}

fn encoded(pictures: &[Picture], per_second: Option<u16>) -> Result<Vec<u8>, RenderError> {
    let first = of_one_size(pictures)?;
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
