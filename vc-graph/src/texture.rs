//! Textures: images on surfaces.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

/// An image that modulates a material's colour. A [mesh](crate::asset::Shape::Mesh) has the texture coordinates
/// of its corners; beyond its sides the texture repeats.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Texture {
    /// Its name, `label`.
    pub name: Arc<str>,
    /// Width, pixels.
    pub width: u32,
    /// Height, pixels.
    pub height: u32,
    /// Red, green and blue in sRGB encoding, rows from the top. In JSON six hexadecimal digits per pixel.
    #[serde(with = "digits")]
    pub pixels: Vec<[u8; 3]>,
}

impl Texture {
    /// Whether it has pixels, exactly width times height of them.
    pub(crate) fn is_sound(&self) -> bool {
        let count = u64::from(self.width) * u64::from(self.height);
        count > 0 && count == self.pixels.len() as u64
    }
}

/// `#[serde(with)]` for pixels: two digits per byte.
mod digits {
    use serde::de::Error;
    use serde::{Deserialize, Deserializer, Serializer};

    const DIGITS: &[u8; 16] = b"0123456789abcdef";

    pub(super) fn serialize<S: Serializer>(pixels: &[[u8; 3]], s: S) -> Result<S::Ok, S::Error> {
        let digit = |half: u8| char::from(DIGITS[usize::from(half)]);
        let text: String = pixels.iter().flatten().flat_map(|byte| [digit(byte >> 4), digit(byte & 15)]).collect();
        s.serialize_str(&text)
    }

    pub(super) fn deserialize<'de, D: Deserializer<'de>>(d: D) -> Result<Vec<[u8; 3]>, D::Error> {
        let text = String::deserialize(d)?;
        let (pixels, rest) = text.as_bytes().as_chunks::<6>();
        let pixel = |digits: &[u8; 6]| {
            let byte = |i: usize| Some(16 * half(digits[i])? + half(digits[i + 1])?);
            Some([byte(0)?, byte(2)?, byte(4)?])
        };
        let read: Option<Vec<[u8; 3]>> = pixels.iter().map(pixel).collect();
        let refusal = || D::Error::custom("pixels are six hexadecimal digits each");
        read.filter(|_| rest.is_empty()).ok_or_else(refusal)
    }

    fn half(digit: u8) -> Option<u8> {
        char::from(digit).to_digit(16).map(|d| d as u8)
    }
}
