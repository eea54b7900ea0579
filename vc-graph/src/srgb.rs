//! sRGB's transfer function (IEC 61966-2-1), with the same bits on every machine.
//!
//! ```
//! use vc_graph::srgb::{from_linear, to_linear};
//! assert!((from_linear(0.214) - 0.5).abs() < 1e-3);
//! assert!((to_linear(from_linear(0.3)) - 0.3).abs() < 1e-6);
//! ```

use crate::portable::Portable;

/// Encodes a linear value, 0 to 1.
pub fn from_linear(value: f32) -> f32 {
    if value <= 0.003_130_8 { 12.92 * value } else { 1.055 * value.power(1.0 / 2.4) - 0.055 }
}

/// Decodes a value to linear, 0 to 1.
pub fn to_linear(value: f32) -> f32 {
    if value <= 0.040_45 { value / 12.92 } else { ((value + 0.055) / 1.055).power(2.4) }
}
