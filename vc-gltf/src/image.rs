//! Images in a file: PNG and JPEG are read, PNG is written.

use std::borrow::Cow;
use std::io::Cursor;
use std::sync::Arc;

use vc_graph::asset::Texture;
use zune_jpeg::JpegDecoder;
use zune_jpeg::zune_core::bytestream::ZCursor;
use zune_jpeg::zune_core::colorspace::ColorSpace;
use zune_jpeg::zune_core::options::DecoderOptions;

use super::GltfError;
use super::access::slice;
use super::buffers::{Buffers, inline};
use super::document::{Document, Image};

/// The greatest number of pixels of all images of a file together.
const MOST: usize = 1 << 27;
/// The greatest number of pixels along a side.
const LONGEST: usize = 1 << 14;

/// Width, height, and the red, green and blue of each pixel.
type Pixels = (usize, usize, Vec<[u8; 3]>);

/// Decodes images up to a total number of pixels.
pub(super) struct Decoder {
    left: usize,
}

impl Decoder {
    pub(super) fn new() -> Self {
        Self { left: MOST }
    }

    /// The image with an index in the document.
    pub(super) fn texture(
        &mut self,
        document: &Document,
        buffers: &Buffers<'_>,
        index: usize,
    ) -> Result<Arc<Texture>, GltfError> {
        let image = document.images.get(index).ok_or(GltfError::missing("image", index))?;
        let own = [&image.name, image.uri.as_ref().filter(|u| !u.starts_with("data:")).unwrap_or(&image.name)];
        let name = own.into_iter().find(|n| !n.is_empty()).cloned().unwrap_or_else(|| format!("image_{index}"));
        let refuse = |reason: String| GltfError::BadImage { name: name.clone(), reason };
        let bytes =
            bytes(document, buffers, image)?.ok_or_else(|| refuse("is not in the file: export as .glb".into()))?;
        let (width, height, pixels) = self.pixels(&bytes).map_err(refuse)?;
        self.left -= pixels.len();
        Ok(Arc::new(Texture { name: name.into(), width: width as u32, height: height as u32, pixels }))
    }

    fn pixels(&self, bytes: &[u8]) -> Result<Pixels, String> {
        match bytes {
            [0x89, b'P', b'N', b'G', ..] => self.png(bytes),
            [0xff, 0xd8, ..] => self.jpeg(bytes),
            _ => Err("is neither PNG nor JPEG: export it as one of these".into()),
        }
    }

    /// Whether an image of this size is within the limits.
    fn check(&self, width: usize, height: usize) -> Result<(), String> {
        if width > LONGEST || height > LONGEST {
            return Err(format!("is {width} by {height} pixels: at most {LONGEST} along a side are read"));
        }
        let enough = width * height <= self.left;
        enough.then_some(()).ok_or_else(|| format!("is too much: all pictures together may have {MOST} pixels"))
    }

    fn png(&self, bytes: &[u8]) -> Result<Pixels, String> {
        let broken = |e: png::DecodingError| format!("cannot be decoded: {e}");
        let mut decoder = png::Decoder::new(Cursor::new(bytes));
        decoder.set_transformations(png::Transformations::EXPAND | png::Transformations::STRIP_16);
        let mut reader = decoder.read_info().map_err(broken)?;
        let (width, height) = (reader.info().width as usize, reader.info().height as usize);
        self.check(width, height)?;
        let mut all = vec![0; reader.output_buffer_size().ok_or("cannot be decoded: it is too large")?];
        let info = reader.next_frame(&mut all).map_err(broken)?;
        let pixels = match info.color_type.samples() {
            // Grey, with and without alpha; otherwise colours.
            samples @ (1 | 2) => all.chunks_exact(samples).map(|p| [p[0]; 3]).collect(),
            samples => all.chunks_exact(samples).map(|p| [p[0], p[1], p[2]]).collect(),
        };
        Ok((width, height, pixels))
    }

    fn jpeg(&self, bytes: &[u8]) -> Result<Pixels, String> {
        let options = DecoderOptions::default().jpeg_set_out_colorspace(ColorSpace::RGB);
        let mut decoder = JpegDecoder::new_with_options(ZCursor::new(bytes), options);
        let broken = |e| format!("cannot be decoded: {e}");
        decoder.decode_headers().map_err(broken)?;
        let info = decoder.info().ok_or("cannot be decoded: it has no size")?;
        let (width, height) = (usize::from(info.width), usize::from(info.height));
        self.check(width, height)?;
        let all = decoder.decode().map_err(broken)?;
        let pixels = all.as_chunks::<3>().0.to_vec();
        let whole = pixels.len() == width * height && !pixels.is_empty();
        whole.then_some((width, height, pixels)).ok_or_else(|| "cannot be decoded: pixels are missing".into())
    }
}

/// The bytes of an image; `None` if they are in another file.
fn bytes<'a>(document: &Document, buffers: &'a Buffers<'_>, image: &Image) -> Result<Option<Cow<'a, [u8]>>, GltfError> {
    match image.buffer_view {
        Some(view) => Ok(Some(slice(document, buffers, view)?.into())),
        None => Ok(image.uri.as_deref().and_then(inline).map(Cow::Owned)),
    }
}

/// A texture as PNG.
pub(super) fn png(texture: &Texture) -> Result<Vec<u8>, GltfError> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, texture.width, texture.height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    let written = encoder.write_header().and_then(|mut w| w.write_image_data(texture.pixels.as_flattened()));
    let refuse = |e| GltfError::BadImage { name: texture.name.to_string(), reason: format!("cannot be written: {e}") };
    written.map_err(refuse)?;
    Ok(bytes)
}
