//! OpenEXR files of floats.

use crate::RenderError;

/// Encodes floats as an OpenEXR file: scan lines, no compression, 32 bits. Each channel has a name (`Z` for
/// depth, `forward.u` for flow) and `height * width` numbers, rows from the top.
///
/// Infinity and NaN are kept. The layout follows the documentation of the OpenEXR file format, version 2. The
/// cost is one pass over the numbers; the file has four bytes for each, 16 for each row and a header of some
/// hundred bytes.
///
/// # Errors
/// [`RenderError::Encoding`] if there are no channels, two have the same name, a name is empty or longer than
/// 31 bytes, or a channel does not have `width * height` numbers.
///
/// ```
/// let depth = [1.0_f32, 2.0, f32::INFINITY, 4.0, 5.0, 6.0];
/// let file = vc_render::format::exr(3, 2, &[("Z", &depth)])?;
/// assert_eq!(file[..4], [0x76, 0x2f, 0x31, 0x01]);
/// assert_eq!(file[file.len() - 4..], 6.0_f32.to_le_bytes());
/// assert!(vc_render::format::exr(3, 3, &[("Z", &depth)]).is_err());
/// # Ok::<(), vc_render::RenderError>(())
/// ```
pub fn exr(width: usize, height: usize, channels: &[(&str, &[f32])]) -> Result<Vec<u8>, RenderError> {
    let mut channels = channels.to_vec();
    // The format requires channels in alphabetical order.
    channels.sort_by_key(|c| c.0);
    check(width, height, &channels)?;
    let mut file = header(width as i32, height as i32, &channels);
    let line = 4 * width * channels.len();
    let first = file.len() + 8 * height;
    file.extend((0..height).flat_map(|y| ((first + y * (line + 8)) as u64).to_le_bytes()));
    for y in 0..height {
        file.extend((y as i32).to_le_bytes());
        file.extend((line as i32).to_le_bytes());
        for (_, numbers) in &channels {
            file.extend(numbers[y * width..(y + 1) * width].iter().flat_map(|v| v.to_le_bytes()));
        }
    }
    Ok(file)
}

fn check(width: usize, height: usize, channels: &[(&str, &[f32])]) -> Result<(), RenderError> {
    let name = |n: &str| !n.is_empty() && n.len() < 32 && !n.contains('\0');
    let wrong = match () {
        () if width == 0 || height == 0 || width.max(height) > 1 << 20 => "a side is zero or too long",
        () if channels.is_empty() => "there are no channels",
        () if channels.iter().any(|c| c.1.len() != width * height) => "a channel has another number of pixels",
        () if !channels.iter().all(|c| name(c.0)) => "a channel's name is empty or too long",
        () if channels.windows(2).any(|w| w[0].0 == w[1].0) => "two channels have one name",
        () => return Ok(()),
    };
    Err(RenderError::Encoding(format!("EXR: {wrong}")))
}

fn header(width: i32, height: i32, channels: &[(&str, &[f32])]) -> Vec<u8> {
    const FLOAT: i32 = 2;
    let numbers = |all: &[i32]| all.iter().flat_map(|v| v.to_le_bytes()).collect::<Vec<u8>>();
    let mut list = Vec::new();
    for (name, _) in channels {
        list.extend(name.bytes().chain([0]));
        // Pixel type, flag for perceptually linear values, and sampling of every pixel in x and y.
        list.extend(numbers(&[FLOAT, 0, 1, 1]));
    }
    list.push(0);
    let window = numbers(&[0, 0, width - 1, height - 1]);
    let one = 1.0_f32.to_le_bytes();
    let mut header = numbers(&[20_000_630, 2]);
    let mut attribute = |name: &str, kind: &str, value: &[u8]| {
        header.extend(name.bytes().chain([0]).chain(kind.bytes()).chain([0]));
        header.extend((value.len() as i32).to_le_bytes());
        header.extend(value);
    };
    attribute("channels", "chlist", &list);
    attribute("compression", "compression", &[0]);
    attribute("dataWindow", "box2i", &window);
    attribute("displayWindow", "box2i", &window);
    attribute("lineOrder", "lineOrder", &[0]);
    attribute("pixelAspectRatio", "float", &one);
    attribute("screenWindowCenter", "v2f", &[0; 8]);
    attribute("screenWindowWidth", "float", &one);
    header.push(0);
    header
}
