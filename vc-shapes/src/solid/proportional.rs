//! The vocabulary in its proportional form, for things that keep their look in any size: positions are fractions of
//! the size to fill, X and Y from -1 to 1, Z from 0 to 1. Radii and thicknesses are metres, as in all of the
//! vocabulary, and a round part is moved so that it stays within the size.
//!
//! | here | in metres |
//! |---|---|
//! | `slab`, `pad`, `chunk` | [`Build::block`], [`Build::rounded_block`], [`Build::hull`] |
//! | `pole`, `bent_rod`, `wheel`, `torus` | [`Build::rod`], [`Build::pipe`], [`Build::rod`], [`Build::lathe_along`] |
//! | `front_outline`, `side_outline`, `plan_outline` | [`Build::prism`] along X, Y and Z |
//! | `skin`, `ellipsoid`; `plank`, `layer` | [`Build::mesh`] over rings; [`Build::hull`] of a flat bar |
//! | `deck`, `inner_floor` | [`Build::top`], [`Build::inside`] |

use std::f32::consts::TAU;

use nalgebra::{UnitQuaternion, Vector3};
use vc_graph::portable::Portable;

use super::build::{Axis, Build, P};
use super::skin::{heading, skinned};
use crate::material::MaterialId;

/// The two sides of an axis.
pub(crate) const SIDES: [f32; 2] = [-1.0, 1.0];

/// A ring of a [skin](Proportional::skin): centre and half widths along the two other axes, in the order
/// X, Y, Z.
pub(crate) type Ring = (P, f32, f32);

/// Parts whose positions are fractions of the size.
pub(crate) trait Proportional {
    /// The position in metres.
    fn p(&self, at: P) -> P;
    /// The position in metres, moved so that a part extending `reach` around it stays within the
    /// size.
    fn held(&self, at: P, reach: Vector3<f32>) -> P;

    /// A box.
    fn slab(&mut self, name: &str, low: P, high: P, mat: MaterialId);
    /// A box with rounded edges.
    fn pad(&mut self, name: &str, low: P, high: P, radius: f32, mat: MaterialId);
    /// A straight cylinder.
    fn pole(&mut self, name: &str, from: P, to: P, radius: f32, mat: MaterialId);
    /// A bent round bar.
    fn bent_rod(&mut self, name: &str, points: &[P], radius: f32, mat: MaterialId);
    /// A convex hull.
    fn chunk(&mut self, name: &str, points: &[P], mat: MaterialId);
    /// An outline in (x, z) extruded along Y.
    fn side_outline(&mut self, name: &str, y: (f32, f32), outline: &[(f32, f32)], mat: MaterialId);
    /// An outline in (x, y) extruded along Z.
    fn plan_outline(&mut self, name: &str, z: (f32, f32), outline: &[(f32, f32)], mat: MaterialId);
    /// An outline in (y, z) extruded along X.
    fn front_outline(&mut self, name: &str, x: (f32, f32), outline: &[(f32, f32)], mat: MaterialId);
    /// An ellipsoid whose half widths are fractions as well.
    fn ellipsoid(&mut self, name: &str, centre: P, half: P, mat: MaterialId);
    /// A smooth surface over rings across an axis; a ring of zero width is a tip.
    fn skin(&mut self, name: &str, axis: Axis, rings: &[Ring], mat: MaterialId);
    /// A flat bar between two positions, level across; `section` is its width and thickness in
    /// metres.
    fn plank(&mut self, name: &str, from: P, to: P, section: (f32, f32), mat: MaterialId) {
        self.layer(name, from, to, section, 0.0, mat);
    }
    /// A plank raised by `lift` metres perpendicular to its face, for a plank that lies on another.
    fn layer(&mut self, name: &str, from: P, to: P, section: (f32, f32), lift: f32, mat: MaterialId);
    /// A wheel or disc: its centre, its radius and width in metres, its axle along an axis.
    fn wheel(&mut self, name: &str, axis: Axis, centre: P, section: (f32, f32), mat: MaterialId);
    /// A torus: radii of the ring and of its section in metres.
    fn torus(&mut self, name: &str, axis: Axis, centre: P, radii: (f32, f32), mat: MaterialId);
    /// A supporting surface with open space above.
    fn deck(&mut self, name: &str, centre: P, half: (f32, f32));
    /// A surface within walls; the clearance above it is a fraction too.
    fn inner_floor(&mut self, name: &str, centre: P, half: (f32, f32), clearance: f32);
    /// Builds within a part of the size as if it were the whole size.
    fn within(&mut self, low: P, high: P, build: impl FnOnce(&mut Self));
    /// Builds rotated around Z by a number of quarter turns.
    fn quarters(&mut self, count: usize, build: impl FnOnce(&mut Self));
}

impl Proportional for Build<'_> {
    fn p(&self, [x, y, z]: P) -> P {
        [x * self.size.x / 2.0, y * self.size.y / 2.0, z * self.size.z]
    }

    fn held(&self, at: P, reach: Vector3<f32>) -> P {
        let [x, y, z] = self.p(at);
        let within = |v: f32, low: f32, high: f32| if low < high { v.max(low).min(high) } else { (low + high) / 2.0 };
        let half = self.size / 2.0 - reach;
        [within(x, -half.x, half.x), within(y, -half.y, half.y), within(z, reach.z, self.size.z - reach.z)]
    }

    fn slab(&mut self, name: &str, low: P, high: P, mat: MaterialId) {
        let (low, high) = (self.p(low), self.p(high));
        self.block(name, low, high, mat);
    }

    fn pad(&mut self, name: &str, low: P, high: P, radius: f32, mat: MaterialId) {
        let (low, high) = (self.p(low), self.p(high));
        self.rounded_block(name, low, high, radius, mat);
    }

    fn pole(&mut self, name: &str, from: P, to: P, radius: f32, mat: MaterialId) {
        let radius = radius.min(self.size.min() / 2.0);
        let way = Vector3::from(self.p(to)) - Vector3::from(self.p(from));
        let round = round_reach(way, radius);
        let (from, to) = (self.held(from, round), self.held(to, round));
        self.rod(name, from, to, radius, mat);
    }

    fn bent_rod(&mut self, name: &str, points: &[P], radius: f32, mat: MaterialId) {
        let points: Vec<P> = points.iter().map(|&p| self.held(p, Vector3::repeat(radius))).collect();
        self.pipe(name, &points, radius, mat);
    }

    fn chunk(&mut self, name: &str, points: &[P], mat: MaterialId) {
        let points: Vec<P> = points.iter().map(|&p| self.p(p)).collect();
        self.hull(name, &points, mat);
    }

    fn side_outline(&mut self, name: &str, y: (f32, f32), outline: &[(f32, f32)], mat: MaterialId) {
        let (x, z) = (self.size.x / 2.0, self.size.z);
        let half = self.size.y / 2.0;
        self.prism(name, Axis::Y, [0.0, y.0 * half, 0.0], &stretched(outline, x, z), (y.1 - y.0) * half, mat);
    }

    fn plan_outline(&mut self, name: &str, z: (f32, f32), outline: &[(f32, f32)], mat: MaterialId) {
        let (x, y) = (self.size.x / 2.0, self.size.y / 2.0);
        let tall = self.size.z;
        self.prism(name, Axis::Z, [0.0, 0.0, z.0 * tall], &stretched(outline, x, y), (z.1 - z.0) * tall, mat);
    }

    fn front_outline(&mut self, name: &str, x: (f32, f32), outline: &[(f32, f32)], mat: MaterialId) {
        let (y, z) = (self.size.y / 2.0, self.size.z);
        let half = self.size.x / 2.0;
        self.prism(name, Axis::X, [x.0 * half, 0.0, 0.0], &stretched(outline, y, z), (x.1 - x.0) * half, mat);
    }

    fn ellipsoid(&mut self, name: &str, centre: P, half: P, mat: MaterialId) {
        let ring = |sine: f32, cosine: f32| {
            ([centre[0], centre[1], centre[2] + half[2] * sine], half[0] * cosine, half[1] * cosine)
        };
        let rings = [(-1.0, 0.0), (-0.866, 0.5), (-0.5, 0.866), (0.0, 1.0), (0.5, 0.866), (0.866, 0.5), (1.0, 0.0)];
        self.skin(name, Axis::Z, &rings.map(|(s, c)| ring(s, c)), mat);
    }

    fn skin(&mut self, name: &str, axis: Axis, rings: &[Ring], mat: MaterialId) {
        let (x, y, z) = (self.size.x / 2.0, self.size.y / 2.0, self.size.z);
        let (a, b) = match axis {
            Axis::X => (Vector3::y() * y, Vector3::z() * z),
            Axis::Y => (Vector3::x() * x, Vector3::z() * z),
            Axis::Z => (Vector3::x() * x, Vector3::y() * y),
        };
        let rings: Vec<_> = rings.iter().map(|&(c, u, v)| (Vector3::from(self.p(c)), a * u, b * v)).collect();
        let (vertices, triangles) = skinned(&rings, 12, heading(&rings, a.cross(&b)));
        self.mesh(name, vertices, triangles, mat);
    }

    fn layer(&mut self, name: &str, from: P, to: P, section: (f32, f32), lift: f32, mat: MaterialId) {
        let way = Vector3::from(self.p(to)) - Vector3::from(self.p(from));
        let across = way.cross(&Vector3::z()).try_normalize(1e-6).unwrap_or_else(Vector3::y);
        let up = across.cross(&way).try_normalize(1e-6).unwrap_or_else(Vector3::x);
        let (w, t) = (across * (section.0 / 2.0), up * (section.1 / 2.0));
        let round = w.abs() + t.abs();
        let (from, to) = (Vector3::from(self.held(from, round)), Vector3::from(self.held(to, round)));
        let ends = [from, to].map(|e| e + up * lift).into_iter();
        let ends = ends.flat_map(|e| [e + w + t, e + w - t, e - w + t, e - w - t]);
        self.hull(name, &ends.map(|v| [v.x, v.y, v.z]).collect::<Vec<P>>(), mat);
    }

    fn wheel(&mut self, name: &str, axis: Axis, centre: P, section: (f32, f32), mat: MaterialId) {
        let d = unit(axis) * (section.1 / 2.0);
        let c = Vector3::from(self.held(centre, round_reach(d, section.0) + d.abs()));
        self.rod(name, (c - d).into(), (c + d).into(), section.0, mat);
    }

    fn torus(&mut self, name: &str, axis: Axis, centre: P, radii: (f32, f32), mat: MaterialId) {
        let reach = round_reach(unit(axis), radii.0 + radii.1) + unit(axis) * radii.1;
        let c = Vector3::from(self.held(centre, reach));
        let round = |i: usize| (TAU * (i % 8) as f32 / 8.0).sine_cosine();
        let section: Vec<_> = (0..=8).map(round).map(|(s, c)| (radii.0 + radii.1 * c, radii.1 * s)).collect();
        self.lathe_along(name, c.into(), (c + unit(axis)).into(), &section, mat);
    }

    fn deck(&mut self, name: &str, centre: P, half: (f32, f32)) {
        let (at, x, y) = (self.p(centre), self.size.x / 2.0, self.size.y / 2.0);
        self.top(name, at, (half.0 * x, half.1 * y));
    }

    fn inner_floor(&mut self, name: &str, centre: P, half: (f32, f32), clearance: f32) {
        let (at, x, y) = (self.p(centre), self.size.x / 2.0, self.size.y / 2.0);
        let tall = self.size.z;
        self.inside(name, at, (half.0 * x, half.1 * y), clearance * tall);
    }

    fn within(&mut self, low: P, high: P, build: impl FnOnce(&mut Self)) {
        let (l, h) = (Vector3::from(self.p(low)), Vector3::from(self.p(high)));
        let outer = std::mem::replace(&mut self.size, h - l);
        self.at([(l.x + h.x) / 2.0, (l.y + h.y) / 2.0, l.z], 0.0, build);
        self.size = outer;
    }

    fn quarters(&mut self, count: usize, build: impl FnOnce(&mut Self)) {
        let outer = self.size;
        if count % 2 == 1 {
            self.size = Vector3::new(outer.y, outer.x, outer.z);
        }
        self.at([0.0; 3], count as f32 * TAU / 4.0, build);
        self.size = outer;
    }
}

fn stretched(outline: &[(f32, f32)], x: f32, y: f32) -> Vec<(f32, f32)> {
    outline.iter().map(|&(a, b)| (a * x, b * y)).collect()
}

fn unit(axis: Axis) -> Vector3<f32> {
    match axis {
        Axis::X => Vector3::x(),
        Axis::Y => Vector3::y(),
        Axis::Z => Vector3::z(),
    }
}

/// The extent of a cylinder's round side along each axis.
fn round_reach(way: Vector3<f32>, radius: f32) -> Vector3<f32> {
    let turn = UnitQuaternion::rotation_between(&Vector3::z(), &way).unwrap_or_default();
    let turn = turn.to_rotation_matrix();
    (turn.matrix().column(0).abs() + turn.matrix().column(1).abs()) * radius
}
