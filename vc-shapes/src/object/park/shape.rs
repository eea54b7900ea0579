//! Geometry shared by plants and moulded objects: outlines, blobs, limbs, tubs, plates.

use std::f32::consts::TAU;

use nalgebra::Vector3;
use vc_graph::portable::Portable;

use crate::material::Mat;
use crate::object::build::{Build, P};

/// The point at an angle and a distance from the origin of a plane.
pub(crate) fn polar(angle: f32, radius: f32) -> (f32, f32) {
    let (sin, cos) = angle.sine_cosine();
    (cos * radius, sin * radius)
}

/// Corners of a regular polygon, the first one at `start` radians.
pub(crate) fn polygon(corners: usize, radius: f32, start: f32) -> Vec<(f32, f32)> {
    (0..corners).map(|i| polar(start + TAU * i as f32 / corners as f32, radius)).collect()
}

/// A star whose corners alternate between two radii.
pub(crate) fn star(points: usize, outer: f32, inner: f32) -> Vec<(f32, f32)> {
    let step = TAU / (2 * points) as f32;
    (0..2 * points).map(|i| polar(step * i as f32, if i % 2 == 0 { outer } else { inner })).collect()
}

/// The lathe profile of a torus: radius of the ring and radius of its section.
pub(crate) fn hoop(radius: f32, section: f32) -> Vec<(f32, f32)> {
    let mut profile: Vec<_> =
        polygon(10, section, 0.0).into_iter().map(|(r, z)| ((radius + r).max(0.0), z + section)).collect();
    profile.extend(profile.first().copied());
    profile
}

/// Interpolates between two points by `share`.
pub(crate) fn mix(from: P, to: P, share: f32) -> P {
    std::array::from_fn(|i| from[i] + (to[i] - from[i]) * share)
}

/// `count` numbers evenly spaced from `low` to `high`, both included; the midpoint if `count` is
/// one.
pub(crate) fn spaced(count: usize, low: f32, high: f32) -> impl Iterator<Item = f32> {
    let last = count.saturating_sub(1) as f32;
    (0..count).map(move |i| if last > 0.0 { low + (high - low) * i as f32 / last } else { f32::midpoint(low, high) })
}

/// Enlarges the build's size to at least `least`: an object far below the usual size of its class
/// would have no room for its boards and tubes.
pub(crate) fn grown(b: &mut Build<'_>, least: P) {
    b.size = b.size.sup(&Vector3::from(least));
}

/// Points spread over an ellipsoid, each pulled inwards by up to `jitter` of its distance.
pub(crate) fn blob(b: &mut Build<'_>, centre: P, radii: P, points: usize, jitter: f32) -> Vec<P> {
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
pub(crate) fn limb(from: P, to: P, start: f32, end: f32) -> Vec<P> {
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

/// A thin plate from the four corners of one face; the thickness extends to the side from which the
/// corners run clockwise.
pub(crate) fn plate(b: &mut Build<'_>, name: &str, quad: [P; 4], thickness: f32, mat: Mat) {
    let [p, q, r, s] = quad.map(Vector3::from);
    let normal = (r - p).cross(&(s - q)).try_normalize(1e-9).unwrap_or_else(Vector3::z) * thickness;
    let points: Vec<P> = [p, q, r, s].iter().flat_map(|&c| [c.into(), (c - normal).into()]).collect();
    b.hull(name, &points, mat);
}

/// An open box whose bottom and top rectangles differ; both are given by their outer half lengths.
#[allow(clippy::too_many_arguments)]
pub(crate) fn tub(
    b: &mut Build<'_>,
    name: &str,
    base: P,
    bottom: (f32, f32),
    top: (f32, f32),
    height: f32,
    wall: f32,
    mat: Mat,
) {
    let [x, y, z] = base;
    let corner = |(hx, hy): (f32, f32), i: usize, z: f32, inset: f32| {
        let (sx, sy) = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)][i % 4];
        [x + sx * (hx - inset), y + sy * (hy - inset), z]
    };
    for i in 0..4 {
        let points: Vec<P> = [i, i + 1]
            .into_iter()
            .flat_map(|i| [(bottom, z), (top, z + height)].map(|(half, z)| (i, half, z)))
            .flat_map(|(i, half, z)| [corner(half, i, z, 0.0), corner(half, i, z, wall)])
            .collect();
        b.hull(name, &points, mat);
    }
    let (fx, fy) = (bottom.0 - wall * 0.8, bottom.1 - wall * 0.8);
    b.block(name, [x - fx, y - fy, z + 0.001], [x + fx, y + fy, z + wall], mat);
}

/// A closed surface between two point grids of the same shape, such as a boat's hull: rows run
/// along X, each from the left rim under the keel to the right rim.
pub(crate) fn shell(b: &mut Build<'_>, name: &str, outer: &[Vec<P>], inner: &[Vec<P>], mat: Mat) {
    let (rows, columns) = (outer.len(), outer.first().map_or(0, Vec::len));
    let vertices: Vec<P> = outer.iter().chain(inner).flatten().copied().collect();
    let o = |i: usize, j: usize| (i * columns + j) as u32;
    let n = |i: usize, j: usize| o(rows + i, j);
    let (ends, rims) = (rows.saturating_sub(1), columns.saturating_sub(1));
    let mut quads = Vec::new();
    for i in 0..ends {
        for j in 0..rims {
            quads.push([o(i, j), o(i + 1, j), o(i + 1, j + 1), o(i, j + 1)]);
            quads.push([n(i, j), n(i, j + 1), n(i + 1, j + 1), n(i + 1, j)]);
        }
        quads.push([o(i, 0), n(i, 0), n(i + 1, 0), o(i + 1, 0)]);
        quads.push([o(i, rims), o(i + 1, rims), n(i + 1, rims), n(i, rims)]);
    }
    for j in 0..rims {
        quads.push([o(0, j), o(0, j + 1), n(0, j + 1), n(0, j)]);
        quads.push([o(ends, j + 1), o(ends, j), n(ends, j), n(ends, j + 1)]);
    }
    b.mesh(name, vertices, quads.into_iter().flat_map(|[p, q, r, s]| [[p, q, r], [p, r, s]]).collect(), mat);
}

/// Convex solids drawn at any scale, fitted into a box when built.
#[derive(Default)]
pub(crate) struct Sketch(Vec<(&'static str, Vec<P>, Mat)>);

impl Sketch {
    /// Adds a solid.
    pub(crate) fn add(&mut self, name: &'static str, points: Vec<P>, mat: Mat) {
        self.0.push((name, points, mat));
    }

    /// A point of an added solid; both indices start at zero.
    pub(crate) fn point(&self, solid: usize, index: usize) -> P {
        let points = self.0.get(solid).map_or(&[][..], |s| &s.1);
        points.get(index % points.len().max(1)).copied().unwrap_or_default()
    }

    /// The number of solids.
    pub(crate) fn len(&self) -> usize {
        self.0.len()
    }

    /// Builds all solids, stretched to fill the box between two corners.
    pub(crate) fn fit(self, b: &mut Build<'_>, low: P, high: P) {
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
    pub(crate) fn fill(self, b: &mut Build<'_>) {
        let (x, y, z) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
        self.fit(b, [-x, -y, 0.0], [x, y, z]);
    }
}
