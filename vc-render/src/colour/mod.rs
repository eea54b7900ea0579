//! Colours: sRGB, the tone curve from light to display, and downsampling.

mod shrink;
mod srgb;
mod tone;

pub(crate) use shrink::shrink;
pub(crate) use srgb::{decoded, encoded, luminance};
pub(crate) use tone::{colours, displayed, night};
