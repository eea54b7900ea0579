//! The mean appearance of each pattern.

use super::Pattern;

/// Mean tint and roughness of each pattern. They are constants because indirect light needs only these, and
/// tiles take long to make.
#[rustfmt::skip]
pub(super) const MEANS: [([f32; 3], f32); 13] = [
    ([1.0, 1.0, 1.0], 1.0), // plain
    ([0.9064, 0.8859, 0.8721], 1.0042), // grain
    ([0.8742, 0.8466, 0.8282], 1.0182), // boards
    ([0.9513, 0.9513, 0.9513], 1.0), // weave
    ([0.96, 0.96, 0.96], 0.9571), // leather
    ([0.9435, 0.9435, 0.9435], 1.0926), // tiles
    ([0.9406, 0.9893, 1.0059], 1.1875), // bricks
    ([0.8626, 0.8626, 0.8626], 1.0), // speckle
    ([0.9404, 0.9404, 0.9404], 0.5938), // marble
    ([0.9816, 0.9816, 0.9816], 1.0), // rough
    ([1.0008, 1.0008, 1.0008], 0.846), // brushed
    ([0.9944, 0.9944, 0.9944], 1.0), // paper
    ([0.9821, 0.9821, 0.9821], 1.0), // wall
];

/// The mean tint of a pattern, and its mean roughness.
pub(crate) fn mean_of(pattern: Pattern) -> ([f32; 3], f32) {
    MEANS[pattern as usize]
}
