//! Building by proportion: positions are fractions of the object's size, X and Y from -1 to 1, Z
//! from 0 to 1; radii and thicknesses are in metres.

use std::f32::consts::TAU;

use nalgebra::{Isometry3, UnitQuaternion, Vector3};
use vc_graph::portable::Portable;

use super::super::build::{Axis, Build, P};
use crate::material::*;

/// Bright plastics.
pub(in crate::object) const BRIGHT: &[Mat] =
    &[RED_PLASTIC, BLUE_PLASTIC, GREEN_PLASTIC, YELLOW_PLASTIC, ORANGE_PLASTIC, PURPLE_PLASTIC, PINK_PLASTIC];
/// Paints of toys and machines.
pub(in crate::object) const PAINTS: &[Mat] = &[RED, BLUE, GREEN, YELLOW, ORANGE, SKY, DUSTY_ROSE, FOREST, NAVY];
/// Printed card.
pub(in crate::object) const CARDS: &[Mat] =
    &[RED_CARD, BLUE_CARD, GREEN_CARD, YELLOW_CARD, ORANGE_CARD, PURPLE_CARD, TEAL_CARD, PINK_CARD];
/// Bright fabrics.
pub(in crate::object) const CLOTHS: &[Mat] =
    &[RED_FABRIC, BLUE_FABRIC, GREEN_FABRIC, MUSTARD_FABRIC, TEAL_FABRIC, ROSE_FABRIC, PURPLE_FABRIC, NAVY_FABRIC];
/// Pale woods of toys.
pub(in crate::object) const TOY_WOODS: &[Mat] = &[BEECH, BIRCH, MAPLE, PINE];
/// The two sides of an axis.
pub(in crate::object) const SIDES: [f32; 2] = [-1.0, 1.0];
/// The corners of a rectangle.
pub(in crate::object) const CORNERS: [(f32, f32); 4] = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)];

/// A ring of a [skin](Scaled::skin): centre and half widths along the two other axes, in the order
/// X, Y, Z.
pub(in crate::object) type Ring = (P, f32, f32);

/// Parts whose positions are fractions of the size.
pub(in crate::object) trait Scaled {
    /// The position in metres.
    fn p(&self, at: P) -> P;
    /// The position in metres, moved so that a part extending `reach` around it stays within the
    /// size.
    fn held(&self, at: P, reach: Vector3<f32>) -> P;

    /// A box.
    fn slab(&mut self, name: &str, low: P, high: P, mat: Mat);
    /// A box with rounded edges.
    fn pad(&mut self, name: &str, low: P, high: P, radius: f32, mat: Mat);
    /// A straight cylinder.
    fn pole(&mut self, name: &str, from: P, to: P, radius: f32, mat: Mat);
    /// A bent round bar.
    fn tube(&mut self, name: &str, points: &[P], radius: f32, mat: Mat);
    /// A convex hull.
    fn chunk(&mut self, name: &str, points: &[P], mat: Mat);
    /// An outline in (x, z) extruded along Y.
    fn profile(&mut self, name: &str, y: (f32, f32), outline: &[(f32, f32)], mat: Mat);
    /// An outline in (x, y) extruded along Z.
    fn plan(&mut self, name: &str, z: (f32, f32), outline: &[(f32, f32)], mat: Mat);
    /// An outline in (y, z) extruded along X.
    fn facing(&mut self, name: &str, x: (f32, f32), outline: &[(f32, f32)], mat: Mat);
    /// An ellipsoid whose half widths are fractions as well.
    fn blob(&mut self, name: &str, centre: P, half: P, mat: Mat);
    /// A smooth surface over rings across an axis; a ring of zero width is a tip.
    fn skin(&mut self, name: &str, axis: Axis, rings: &[Ring], mat: Mat);
    /// A flat bar between two positions, level across; `section` is its width and thickness in
    /// metres.
    fn plank(&mut self, name: &str, from: P, to: P, section: (f32, f32), mat: Mat) {
        self.layer(name, from, to, section, 0.0, mat);
    }
    /// A plank raised by `lift` metres perpendicular to its face, for a plank that lies on another.
    fn layer(&mut self, name: &str, from: P, to: P, section: (f32, f32), lift: f32, mat: Mat);
    /// A wheel or disc: its centre, its radius and width in metres, its axle along an axis.
    fn disc(&mut self, name: &str, axis: Axis, centre: P, section: (f32, f32), mat: Mat);
    /// A torus: radii of the ring and of its section in metres.
    fn hoop(&mut self, name: &str, axis: Axis, centre: P, radii: (f32, f32), mat: Mat);
    /// A supporting surface with open space above.
    fn deck(&mut self, name: &str, centre: P, half: (f32, f32));
    /// A surface within walls; the clearance above it is a fraction too.
    fn hollow(&mut self, name: &str, centre: P, half: (f32, f32), clearance: f32);
    /// Builds within a part of the size as if it were the whole size.
    fn within(&mut self, low: P, high: P, build: impl FnOnce(&mut Self));
    /// Builds rotated around Z by a number of quarter turns.
    fn quarters(&mut self, count: usize, build: impl FnOnce(&mut Self));
}

impl Scaled for Build<'_> {
    fn p(&self, [x, y, z]: P) -> P {
        [x * self.size.x / 2.0, y * self.size.y / 2.0, z * self.size.z]
    }

    fn held(&self, at: P, reach: Vector3<f32>) -> P {
        let [x, y, z] = self.p(at);
        let within = |v: f32, low: f32, high: f32| if low < high { v.max(low).min(high) } else { (low + high) / 2.0 };
        let half = self.size / 2.0 - reach;
        [within(x, -half.x, half.x), within(y, -half.y, half.y), within(z, reach.z, self.size.z - reach.z)]
    }

    fn slab(&mut self, name: &str, low: P, high: P, mat: Mat) {
        let (low, high) = (self.p(low), self.p(high));
        self.block(name, low, high, mat);
    }

    fn pad(&mut self, name: &str, low: P, high: P, radius: f32, mat: Mat) {
        let (low, high) = (self.p(low), self.p(high));
        self.soft(name, low, high, radius, mat);
    }

    fn pole(&mut self, name: &str, from: P, to: P, radius: f32, mat: Mat) {
        let radius = radius.min(self.size.min() / 2.0);
        let way = Vector3::from(self.p(to)) - Vector3::from(self.p(from));
        let round = round_reach(way, radius);
        let (from, to) = (self.held(from, round), self.held(to, round));
        self.rod(name, from, to, radius, mat);
    }

    fn tube(&mut self, name: &str, points: &[P], radius: f32, mat: Mat) {
        let points: Vec<P> = points.iter().map(|&p| self.held(p, Vector3::repeat(radius))).collect();
        self.pipe(name, &points, radius, mat);
    }

    fn chunk(&mut self, name: &str, points: &[P], mat: Mat) {
        let points: Vec<P> = points.iter().map(|&p| self.p(p)).collect();
        self.hull(name, &points, mat);
    }

    fn profile(&mut self, name: &str, y: (f32, f32), outline: &[(f32, f32)], mat: Mat) {
        let (x, z) = (self.size.x / 2.0, self.size.z);
        let half = self.size.y / 2.0;
        self.prism(name, Axis::Y, [0.0, y.0 * half, 0.0], &stretched(outline, x, z), (y.1 - y.0) * half, mat);
    }

    fn plan(&mut self, name: &str, z: (f32, f32), outline: &[(f32, f32)], mat: Mat) {
        let (x, y) = (self.size.x / 2.0, self.size.y / 2.0);
        let tall = self.size.z;
        self.prism(name, Axis::Z, [0.0, 0.0, z.0 * tall], &stretched(outline, x, y), (z.1 - z.0) * tall, mat);
    }

    fn facing(&mut self, name: &str, x: (f32, f32), outline: &[(f32, f32)], mat: Mat) {
        let (y, z) = (self.size.y / 2.0, self.size.z);
        let half = self.size.x / 2.0;
        self.prism(name, Axis::X, [x.0 * half, 0.0, 0.0], &stretched(outline, y, z), (x.1 - x.0) * half, mat);
    }

    fn blob(&mut self, name: &str, centre: P, half: P, mat: Mat) {
        let ring = |sine: f32, cosine: f32| {
            ([centre[0], centre[1], centre[2] + half[2] * sine], half[0] * cosine, half[1] * cosine)
        };
        let rings = [(-1.0, 0.0), (-0.866, 0.5), (-0.5, 0.866), (0.0, 1.0), (0.5, 0.866), (0.866, 0.5), (1.0, 0.0)];
        self.skin(name, Axis::Z, &rings.map(|(s, c)| ring(s, c)), mat);
    }

    fn skin(&mut self, name: &str, axis: Axis, rings: &[Ring], mat: Mat) {
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

    fn layer(&mut self, name: &str, from: P, to: P, section: (f32, f32), lift: f32, mat: Mat) {
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

    fn disc(&mut self, name: &str, axis: Axis, centre: P, section: (f32, f32), mat: Mat) {
        let d = unit(axis) * (section.1 / 2.0);
        let c = Vector3::from(self.held(centre, round_reach(d, section.0) + d.abs()));
        self.rod(name, (c - d).into(), (c + d).into(), section.0, mat);
    }

    fn hoop(&mut self, name: &str, axis: Axis, centre: P, radii: (f32, f32), mat: Mat) {
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

    fn hollow(&mut self, name: &str, centre: P, half: (f32, f32), clearance: f32) {
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

/// An ellipse with `count` corners around a centre.
pub(in crate::object) fn oval(centre: (f32, f32), half: (f32, f32), count: usize) -> Vec<(f32, f32)> {
    arc(centre, half, (0.0, TAU * (1.0 - 1.0 / count as f32)), count)
}

/// Part of an ellipse, from one angle to another.
pub(in crate::object) fn arc(
    centre: (f32, f32),
    half: (f32, f32),
    angles: (f32, f32),
    count: usize,
) -> Vec<(f32, f32)> {
    let turn = |i: usize| angles.0 + (angles.1 - angles.0) * i as f32 / (count.max(2) - 1) as f32;
    (0..count).map(|i| turn(i).sine_cosine()).map(|(s, c)| (centre.0 + half.0 * c, centre.1 + half.1 * s)).collect()
}

/// A rectangle from `low` to `high` with its corners rounded by `by`.
pub(in crate::object) fn rounded(low: (f32, f32), high: (f32, f32), by: (f32, f32)) -> Vec<(f32, f32)> {
    let quarter = TAU / 4.0;
    let (x0, x1, y0, y1) = (low.0 + by.0, high.0 - by.0, low.1 + by.1, high.1 - by.1);
    let centres = [(x1, y1), (x0, y1), (x0, y0), (x1, y0)];
    let turns = centres.iter().enumerate();
    turns.flat_map(|(i, &c)| arc(c, by, (i as f32 * quarter, (i + 1) as f32 * quarter), 4)).collect()
}

/// A band along a curve: the curve followed by the same curve, reversed and shifted by `by`.
pub(in crate::object) fn band(curve: &[(f32, f32)], by: (f32, f32)) -> Vec<(f32, f32)> {
    let back = curve.iter().rev().map(|&(x, y)| (x + by.0, y + by.1));
    curve.iter().copied().chain(back).collect()
}

/// A frame rotated around Y: a positive pitch tips the front down.
pub(in crate::object) fn pitched(at: P, pitch: f32) -> vc_graph::Pose {
    Isometry3::new(Vector3::from(at), Vector3::y() * pitch)
}

/// A frame rotated around X: a positive roll tips the left side up.
pub(in crate::object) fn rolled(at: P, roll: f32) -> vc_graph::Pose {
    Isometry3::new(Vector3::from(at), Vector3::x() * roll)
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

type Skin = (Vector3<f32>, Vector3<f32>, Vector3<f32>);

/// Whether consecutive rings follow `normal` (1) or run against it (-1).
fn heading(rings: &[Skin], normal: Vector3<f32>) -> f32 {
    match (rings.first(), rings.last()) {
        (Some(first), Some(last)) => (last.0 - first.0).dot(&normal).signum(),
        _ => 1.0,
    }
}

/// The closed surface over rings; `way` is negative if the rings run against their normals.
fn skinned(rings: &[Skin], n: u32, way: f32) -> (Vec<P>, Vec<[u32; 3]>) {
    let (mut vertices, mut triangles): (Vec<P>, Vec<[u32; 3]>) = (Vec::new(), Vec::new());
    let mut before: Option<(u32, u32)> = None;
    let last = rings.len().saturating_sub(1);
    for (i, &(centre, a, b)) in rings.iter().enumerate() {
        let tip = a.norm() < 1e-7 || b.norm() < 1e-7;
        let mut ring = (vertices.len() as u32, if tip { 1 } else { n });
        if tip {
            vertices.push(centre.into());
        } else {
            let turns = (0..n).map(|k| (TAU * k as f32 / n as f32).sine_cosine());
            vertices.extend(turns.map(|(s, c)| P::from(centre + a * c + b * s)));
        }
        let cap = |vertices: &mut Vec<P>| {
            vertices.push(centre.into());
            (vertices.len() as u32 - 1, 1)
        };
        if i == 0 && !tip {
            let pole = cap(&mut vertices);
            join(&mut triangles, pole, ring, n);
        }
        if let Some(below) = before {
            join(&mut triangles, below, ring, n);
        }
        if i == last && !tip {
            let pole = cap(&mut vertices);
            join(&mut triangles, ring, pole, n);
            ring = pole;
        }
        before = Some(ring);
    }
    if way < 0.0 {
        triangles.iter_mut().for_each(|t| t.swap(1, 2));
    }
    (vertices, triangles)
}

/// Triangles between two rings, each given by its first vertex and its vertex count.
fn join(triangles: &mut Vec<[u32; 3]>, below: (u32, u32), above: (u32, u32), n: u32) {
    let at = |ring: (u32, u32), k: u32| ring.0 + if ring.1 == 1 { 0 } else { k % n };
    for k in 0..n {
        let [a, b, c, d] = [at(below, k), at(below, k + 1), at(above, k + 1), at(above, k)];
        if a != b {
            triangles.push([a, b, c]);
        }
        if c != d {
            triangles.push([a, c, d]);
        }
    }
}

/// Reserves a margin for round parts: reduces every side and the top by the given metres, but keeps
/// at least six tenths of the size.
pub(in crate::object) fn spare(b: &mut Build<'_>, x: f32, y: f32, z: f32) {
    let least = b.size * 0.6;
    b.size = (b.size - Vector3::new(2.0 * x, 2.0 * y, z)).sup(&least);
}

/// A zone of a sphere between two angles from an axis through its `centre`.
pub(in crate::object) fn zone(
    b: &mut Build<'_>,
    name: &str,
    (centre, radius): (P, f32),
    towards: P,
    angles: (f32, f32),
    mat: Mat,
) {
    let way = Vector3::from(towards).try_normalize(1e-6).unwrap_or_else(Vector3::z);
    let across = way.cross(&Vector3::x()).try_normalize(0.1).unwrap_or_else(|| way.cross(&Vector3::y()).normalize());
    let other = way.cross(&across);
    let steps = ((angles.1 - angles.0) / 0.16).ceil().max(1.0) as usize;
    let n = match angles.1 {
        most if most < 0.5 => 12,
        most if most < 0.7 => 24,
        _ => 36,
    };
    let ring = |i: usize| {
        let (s, c) = (angles.0 + (angles.1 - angles.0) * i as f32 / steps as f32).sine_cosine();
        (Vector3::from(centre) + way * (radius * c), across * (radius * s), other * (radius * s))
    };
    let rings: Vec<Skin> = (0..=steps).map(ring).collect();
    let (vertices, triangles) = skinned(&rings, n, -1.0);
    b.mesh(name, vertices, triangles, mat);
}

/// A coil spring standing on `base`: radii of the coil and of its wire, height.
pub(in crate::object) fn coil(b: &mut Build<'_>, name: &str, base: P, radii: (f32, f32), height: f32, mat: Mat) {
    let (turns, steps) = (5, 14);
    let count = turns * steps;
    let rise = (height - 2.0 * radii.1).max(height * 0.5);
    let ring = |i: usize| {
        let (s, c) = (TAU * (i % steps) as f32 / steps as f32).sine_cosine();
        let out = Vector3::new(c, s, 0.0);
        let up = Vector3::z() * ((height - rise) / 2.0 + rise * i as f32 / count as f32);
        (Vector3::from(base) + out * radii.0 + up, out * radii.1, Vector3::z() * radii.1)
    };
    let rings: Vec<Skin> = (0..=count).map(ring).collect();
    let (vertices, triangles) = skinned(&rings, 8, -1.0);
    b.mesh(name, vertices, triangles, mat);
}

/// A line along a closed curve of positions in metres, raised away from `centre`, such as a ball's
/// seam.
pub(in crate::object) fn seam(b: &mut Build<'_>, name: &str, centre: P, curve: &[P], half: f32, mat: Mat) {
    let n = curve.len();
    let (middle, at) = (Vector3::from(centre), |i: usize| Vector3::from(curve[i % n]));
    let mut vertices = Vec::with_capacity(n * 4);
    for i in 0..n {
        let out = (at(i) - middle).try_normalize(1e-9).unwrap_or_else(Vector3::z);
        let way = at(i + 1) - at(i + n - 1);
        let side = out.cross(&way).try_normalize(1e-9).unwrap_or_else(Vector3::x) * half;
        let up = out * half;
        vertices.extend([up, side, -up, -side].map(|d| P::from(at(i) + d)));
    }
    let (n, mut triangles) = (n as u32, Vec::with_capacity(n * 8));
    for (i, k) in (0..n).flat_map(|i| (0..4).map(move |k| (i, k))) {
        let (next, turn) = ((i + 1) % n * 4, (k + 1) % 4);
        let [a, c, d, e] = [i * 4 + k, next + k, next + turn, i * 4 + turn];
        triangles.extend([[a, c, d], [a, d, e]]);
    }
    b.mesh(name, vertices, triangles, mat);
}
