//! Points of convex solids: blobs and limbs, and sketches that are fitted into a box.

use std::f32::consts::TAU;

use nalgebra::Vector3;

use super::build::{Build, P};
use super::outline::{polar, polygon};
use crate::material::MaterialId;

/// Points spread over an ellipsoid, each pulled inwards by up to `jitter` of its distance.
pub fn blob(b: &mut Build<'_>, centre: P, radii: P, points: usize, jitter: f32) -> Vec<P> {
    let start = b.vary(0.0, TAU);
    let spread = |b: &mut Build<'_>, i: usize| {
        let z = 1.0 - 2.0 * (i as f32 + 0.5) / points as f32;
        let (x, y) = polar(start + 2.399_963 * i as f32, (1.0 - z * z).max(0.0).sqrt());
        let r = 1.0 - b.vary(0.0, jitter);
        [centre[0] + r * x * radii[0], centre[1] + r * y * radii[1], centre[2] + r * z * radii[2]]
    };
    (0..points).map(|i| spread(b, i)).collect()
}

/// Points of a tapered limb with a hexagonal section between two points.
///
/// ```
/// use vc_shapes::solid::limb;
/// let points = limb([0.0; 3], [0.0, 0.0, 1.0], 0.1, 0.05);
/// assert_eq!(points.len(), 12);
/// ```
pub fn limb(from: P, to: P, start: f32, end: f32) -> Vec<P> {
    let (a, c) = (Vector3::from(from), Vector3::from(to));
    let way = (c - a).try_normalize(1e-9).unwrap_or_else(Vector3::z);
    let other = if way.z.abs() > 0.9 { Vector3::x() } else { Vector3::z() };
    let u = way.cross(&other).normalize();
    let v = way.cross(&u);
    let ring = |centre: Vector3<f32>, radius: f32| {
        polygon(6, radius, 0.3).into_iter().map(move |(x, y)| (centre + u * x + v * y).into())
    };
    ring(a, start).chain(ring(c, end)).collect()
}

/// Convex solids drawn at any scale, fitted into a box when built.
///
/// ```
/// # use vc_graph::{Seed, nalgebra::Vector3};
/// # use vc_shapes::{Build, Style};
/// # let style = Style::from_seed(Seed(1));
/// # let mut b = Build::new("thing", Vector3::new(1.0, 1.0, 1.0), &style, Seed(1).stream());
/// use vc_shapes::material::OAK;
/// use vc_shapes::solid::{Sketch, limb};
/// let mut sketch = Sketch::default();
/// sketch.add("trunk", limb([0.0, 0.0, 0.0], [0.0, 0.0, 5.0], 1.0, 0.5), OAK);
/// // Drawn at any scale, built to fill the size.
/// sketch.fill(&mut b);
/// let (_, bounds) = b.finish();
/// assert!((bounds.size() - Vector3::new(1.0, 1.0, 1.0)).norm() < 2e-3);
/// ```
#[derive(Default)]
pub struct Sketch(Vec<(&'static str, Vec<P>, MaterialId)>);

impl Sketch {
    /// Adds a solid.
    pub fn add(&mut self, name: &'static str, points: Vec<P>, mat: MaterialId) {
        self.0.push((name, points, mat));
    }

    /// A point of an added solid; both indices start at zero.
    pub fn point(&self, solid: usize, index: usize) -> P {
        let points = self.0.get(solid).map_or(&[][..], |s| &s.1);
        points.get(index % points.len().max(1)).copied().unwrap_or_default()
    }

    /// The number of solids.
    pub fn count(&self) -> usize {
        self.0.len()
    }

    /// Builds all solids, stretched to fill the box between two corners.
    pub fn fit(self, b: &mut Build<'_>, low: P, high: P) {
        let all = || self.0.iter().flat_map(|s| &s.1);
        let least: P = std::array::from_fn(|i| all().map(|p| p[i]).fold(f32::INFINITY, f32::min));
        let most: P = std::array::from_fn(|i| all().map(|p| p[i]).fold(f32::NEG_INFINITY, f32::max));
        let scale: P = std::array::from_fn(|i| (high[i] - low[i]) / (most[i] - least[i]).max(1e-6));
        for (name, points, mat) in &self.0 {
            let place = |p: &P| std::array::from_fn(|i| low[i] + (p[i] - least[i]) * scale[i]);
            b.hull(name, &points.iter().map(place).collect::<Vec<P>>(), *mat);
        }
    }

    /// Builds all solids to fill a box of the build's size with its base at zero.
    pub fn fill(self, b: &mut Build<'_>) {
        let (x, y, z) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
        self.fit(b, [-x, -y, 0.0], [x, y, z]);
    }
}
