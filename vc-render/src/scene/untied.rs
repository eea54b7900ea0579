//! Curtains that are tied to one side: when they are drawn, they hang straight.

use std::f32::consts::TAU;

use nalgebra::Point3;
use vc_graph::asset::{Part, Shape};
use vc_graph::portable::Portable;
use vc_graph::{Asset, Pose};

/// Names of parts: the band, and the cloth that it ties.
const BAND: &str = "tie";
const CLOTH: &str = "cloth";
/// Width of a pleat and thickness of the cloth, metres; corners of the outline for each pleat.
const PLEAT: f32 = 0.07;
const THICK: f32 = 0.004;
const CORNERS: usize = 12;

/// A tied curtain's cloth without its band.
pub(super) struct Untied {
    pub(super) cloth: Part,
    /// Index of the tied cloth's part.
    pub(super) index: usize,
    /// Points inside the band and inside the hanging cloth: the hidden one of the two is shrunk to a speck
    /// inside the other.
    pub(super) hidden: [[f64; 3]; 2],
}

impl Untied {
    /// None if the asset is not tied.
    pub(super) fn new(asset: &Asset) -> Option<Self> {
        let named = |name: &str| asset.parts.iter().position(|part| &*part.name == name);
        let (band, index) = (&asset.parts[named(BAND)?], named(CLOTH)?);
        let ((low, high), (from, to)) = (asset.extent()?, band.extent());
        let (middle, size) = (nalgebra::center(&low, &high), high - low);
        let pleats = (size.y / PLEAT).round().max(2.0) as usize;
        let outline = pleated(0.5 * size.x, size.y, pleats);
        let within = Point3::new(middle.x, low.y + size.y * (pleats / 2) as f32 / pleats as f32, middle.z);
        let cloth = Part {
            shape: Shape::Extrusion { outline, height: size.z },
            pose: Pose::translation(middle.x, low.y, low.z),
            joint: None,
            ..asset.parts[index].clone()
        };
        let hidden = [nalgebra::center(&from, &to), within].map(|at| at.coords.map(f64::from).into());
        Some(Self { cloth, index, hidden })
    }
}

/// The counter-clockwise outline of pleated cloth along Y from zero; pleats reach `deep` to both sides.
fn pleated(deep: f32, wide: f32, pleats: usize) -> Vec<(f32, f32)> {
    let half = (0.5 * THICK).min(0.3 * deep);
    let steps = pleats * CORNERS;
    let at = |step: usize, side: f32| {
        let wave = (TAU * (step % CORNERS) as f32 / CORNERS as f32).sine() * (deep - half);
        (wave + side * half, wide * step as f32 / steps as f32)
    };
    (0..=steps).map(|step| at(step, 1.0)).chain((0..=steps).rev().map(|step| at(step, -1.0))).collect()
}
