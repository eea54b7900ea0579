//! A part as triangles in the asset's frame, with tests of its interior.

use std::collections::HashMap;

use nalgebra::{Isometry3, Point3, Vector3};
use vc_graph::TriangleMesh;
use vc_graph::asset::{Joint, Shape};
use vc_shapes::material::{Family, MaterialId};
use vc_shapes::object::Object;

pub(crate) type P = Point3<f64>;
pub(crate) type V = Vector3<f64>;

/// A part as triangles.
pub(crate) struct Solid {
    /// The index and name of the part.
    pub(crate) name: String,
    pub(crate) material: u32,
    /// Whether objects sink into it.
    pub(crate) liquid: bool,
    pub(crate) joint: Option<Joint>,
    pub(crate) closed: bool,
    /// Whether it is a sphere or a capsule.
    pub(crate) round: bool,
    /// The volume, cubic metres.
    pub(crate) volume: f32,
    pub(crate) triangles: Vec<[P; 3]>,
    pub(crate) low: P,
    pub(crate) high: P,
}

/// The parts of an object, tessellated finely enough for its size.
pub(crate) fn solids(object: &Object) -> Vec<Solid> {
    let tolerance = (object.size().norm() * 0.002).clamp(2e-4, 5e-3);
    let parts = object.asset.parts.iter().enumerate();
    parts
        .map(|(i, part)| {
            let mesh = part.shape.mesh(tolerance.min(part_size(part) * 0.02));
            let pose: Isometry3<f64> = part.pose.cast();
            let points: Vec<P> = mesh.positions.iter().map(|p| pose * p.cast()).collect();
            let empty = (P::from([f64::INFINITY; 3]), P::from([f64::NEG_INFINITY; 3]));
            let (low, high) = points.iter().fold(empty, |(l, h), p| (l.inf(p), h.sup(p)));
            Solid {
                name: format!("part {i} `{}`", part.name),
                material: part.material,
                liquid: MaterialId(part.material).family() == Some(Family::Liquid),
                joint: part.joint,
                closed: mesh.is_closed() || balanced(&mesh),
                round: matches!(part.shape, Shape::Capsule { .. } | Shape::Sphere { .. }),
                volume: mesh.volume(),
                triangles: mesh.triangles.iter().map(|t| t.map(|v| points[v as usize])).collect(),
                low,
                high,
            }
        })
        .collect()
}

/// Whether every edge has as many opposite edges: several closed solids in one mesh may touch at an
/// edge.
fn balanced(mesh: &TriangleMesh) -> bool {
    let mut edges: HashMap<_, i32> = HashMap::new();
    let place = |v: u32| mesh.positions[v as usize].coords.map(|x| (x + 0.0).to_bits());
    for [a, b, c] in mesh.triangles.iter().map(|t| t.map(|v| <[u32; 3]>::from(place(v)))) {
        for (from, to) in [(a, b), (b, c), (c, a)] {
            *edges.entry((from.min(to), from.max(to))).or_default() += if from < to { 1 } else { -1 };
        }
    }
    !edges.is_empty() && edges.values().all(|count| *count == 0)
}

fn part_size(part: &vc_graph::asset::Part) -> f32 {
    let (low, high) = part.shape.extent();
    (high - low).norm().max(1e-3)
}

impl Solid {
    /// The gap between the bounding boxes of two parts along the axis where it is widest.
    pub(crate) fn gap(&self, other: &Self) -> f64 {
        let (a, b) = (other.low - self.high, self.low - other.high);
        a.sup(&b).max()
    }

    /// Whether the surfaces of two parts are within `gap` of each other, or one part is inside the
    /// other.
    pub(crate) fn touches(&self, other: &Self, gap: f64) -> bool {
        if self.gap(other) > gap {
            return false;
        }
        let (mine, theirs) = (self.facing(other, gap), other.facing(self, gap));
        let inside = |a: &Self, b: &Self| a.triangles.first().is_some_and(|t| b.contains(&t[0]));
        let close = |a: &[&[P; 3]], b: &[&[P; 3]]| a.iter().any(|t| b.iter().any(|u| reaches(t, u, gap)));
        inside(self, other) || inside(other, self) || close(&mine, &theirs) || close(&theirs, &mine)
    }

    /// The triangles within the bounding box of another part, enlarged by `gap`.
    fn facing(&self, other: &Self, gap: f64) -> Vec<&[P; 3]> {
        let near = |t: &&[P; 3]| {
            let (low, high) = (t[0].inf(&t[1]).inf(&t[2]), t[0].sup(&t[1]).sup(&t[2]));
            (0..3).all(|k| low[k] <= other.high[k] + gap && high[k] >= other.low[k] - gap)
        };
        self.triangles.iter().filter(near).collect()
    }

    pub(crate) fn size(&self) -> V {
        self.high - self.low
    }

    /// Whether a point is in its bounding box, enlarged by `margin` on all sides.
    pub(crate) fn near(&self, p: &P, margin: f64) -> bool {
        (0..3).all(|k| p[k] > self.low[k] - margin && p[k] < self.high[k] + margin)
    }

    /// Whether a point is inside: a ray from it leaves more often than it enters.
    pub(crate) fn contains(&self, p: &P) -> bool {
        if !self.near(p, 0.0) {
            return false;
        }
        // A direction that is unlikely to lie in the plane of any face.
        let way = V::new(0.113_71, 0.071_93, 1.0);
        let crossing = |t: &[P; 3]| hit(t, p, &way).filter(|(at, _)| *at > 0.0).map_or(0, |(_, leaves)| leaves);
        self.triangles.iter().map(crossing).sum::<i32>() > 0
    }

    /// Whether a point is inside by more than a depth in all directions.
    pub(crate) fn contains_deep(&self, p: &P, depth: f64) -> bool {
        let sides = || (0..6).map(|i| V::ith(i / 2, if i % 2 == 0 { depth } else { -depth }));
        sides().all(|s| self.near(&(p + s), 0.0)) && self.contains(p) && sides().all(|s| self.contains(&(p + s)))
    }

    /// Whether it blocks the segment from one point to another.
    pub(crate) fn blocks(&self, from: &P, to: &P) -> bool {
        let (low, high) = (from.inf(to), from.sup(to));
        if (0..3).any(|k| high[k] < self.low[k] || low[k] > self.high[k]) {
            return false;
        }
        let way = to - from;
        let between = |t: &[P; 3]| hit(t, from, &way).is_some_and(|(at, _)| (0.0..=1.0).contains(&at));
        self.triangles.iter().any(between) || self.contains(from)
    }

    /// Points spread over its surface, at most some hundreds.
    pub(crate) fn samples(&self) -> Vec<P> {
        let mut points: Vec<P> = self.triangles.iter().flatten().copied().collect();
        points.sort_by(|a, b| a.coords.as_slice().partial_cmp(b.coords.as_slice()).unwrap());
        points.dedup();
        let pitch = (self.size().max() / 8.0).max(0.01);
        for [a, b, c] in &self.triangles {
            let longest = (b - a).norm().max((c - b).norm()).max((a - c).norm());
            let n = (longest / pitch).ceil() as usize;
            for (i, j) in (0..n).flat_map(|i| (0..n - i).map(move |j| (i, j))) {
                let (u, v) = ((i as f64 + 1.0 / 3.0) / n as f64, (j as f64 + 1.0 / 3.0) / n as f64);
                points.push(a + (b - a) * u + (c - a) * v);
            }
        }
        let step = points.len().div_ceil(400);
        points.into_iter().step_by(step.max(1)).collect()
    }
}

/// Whether a corner or an edge of `t` is within `gap` of `u`, or an edge passes through it.
fn reaches(t: &[P; 3], u: &[P; 3], gap: f64) -> bool {
    let edges = |t: &[P; 3]| [(t[0], t[1]), (t[1], t[2]), (t[2], t[0])];
    let over = |p: &P| {
        let normal = (u[1] - u[0]).cross(&(u[2] - u[0])).try_normalize(1e-12).unwrap_or_else(V::zeros);
        hit(u, p, &normal).is_some_and(|(at, _)| at.abs() <= gap)
    };
    let through = |(a, b): &(P, P)| hit(u, a, &(b - a)).is_some_and(|(at, _)| (0.0..=1.0).contains(&at));
    let along = |a: &(P, P)| edges(u).iter().any(|b| between(*a, *b) <= gap);
    t.iter().any(over) || edges(t).iter().any(|e| through(e) || along(e))
}

/// The shortest distance between two line segments (Ericson, Real-Time Collision Detection, 5.1.9).
fn between((a, b): (P, P), (c, d): (P, P)) -> f64 {
    let (m, n, r) = (b - a, d - c, a - c);
    let (mm, nn, mn, mr, nr) = (m.dot(&m), n.dot(&n), m.dot(&n), m.dot(&r), n.dot(&r));
    let share = |v: f64| if v.is_finite() { v.clamp(0.0, 1.0) } else { 0.0 };
    let first = share((mn * nr - mr * nn) / (mm * nn - mn * mn));
    let second = share((mn * first + nr) / nn);
    let first = share((mn * second - mr) / mm);
    (r + m * first - n * second).norm()
}

/// The intersection of a ray and a triangle, in lengths of `way`, and 1 where the ray leaves the
/// solid or -1 where it enters (Möller and Trumbore 1997).
fn hit([a, b, c]: &[P; 3], from: &P, way: &V) -> Option<(f64, i32)> {
    let (ab, ac) = (b - a, c - a);
    let cross = way.cross(&ac);
    let turn = ab.dot(&cross);
    if turn.abs() < 1e-18 {
        return None;
    }
    let to = from - a;
    let u = to.dot(&cross) / turn;
    let other = to.cross(&ab);
    let v = way.dot(&other) / turn;
    let inside = u >= 0.0 && v >= 0.0 && u + v <= 1.0;
    inside.then(|| (ac.dot(&other) / turn, if turn < 0.0 { 1 } else { -1 }))
}
