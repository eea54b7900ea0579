//! Legs, bent boards, shells and outlines: supports and backs of furniture.

use nalgebra::{Isometry3, Vector3};
use vc_graph::portable::Portable;

use crate::material::Mat;
use crate::object::build::{Axis, Build, P};

/// The cross section of a leg.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::object) enum Cut {
    /// Four sides along the axes.
    Square,
    /// Eight sides.
    Round,
}

const SQUARE: [(f32, f32); 4] = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)];
const EIGHTH: f32 = 0.414_213_57;
const OCTAGON: [(f32, f32); 8] = [
    (1.0, EIGHTH),
    (EIGHTH, 1.0),
    (-EIGHTH, 1.0),
    (-1.0, EIGHTH),
    (-1.0, -EIGHTH),
    (-EIGHTH, -1.0),
    (EIGHTH, -1.0),
    (1.0, -EIGHTH),
];

/// The four corners of a rectangle around the origin, as signs of X and Y.
pub(in crate::object) const CORNERS: [(f32, f32); 4] = SQUARE;

/// The directions of a five-armed base.
pub(in crate::object) const STAR: [(f32, f32); 5] =
    [(1.0, 0.0), (0.309_017, 0.951_057), (-0.809_017, 0.587_785), (-0.809_017, -0.587_785), (0.309_017, -0.951_057)];

/// Enlarges the size to a minimum, because it cannot be thinner than its boards.
pub(in crate::object) fn at_least(b: &mut Build<'_>, size: P) {
    b.size = b.size.sup(&size.into());
}

/// A leg between two level ends, each given by its centre and half width.
pub(in crate::object) fn leg(b: &mut Build<'_>, name: &str, foot: (P, f32), head: (P, f32), cut: Cut, mat: Mat) {
    let ring: &[(f32, f32)] = if cut == Cut::Square { &SQUARE } else { &OCTAGON };
    let end = |(at, r): (P, f32)| ring.iter().map(move |c| [at[0] + c.0 * r, at[1] + c.1 * r, at[2]]);
    let points: Vec<P> = end(foot).chain(end(head)).collect();
    b.hull(name, &points, mat);
}

/// Four legs whose feet and heads stay within rectangles of the given half lengths.
pub(in crate::object) struct Four {
    /// The half lengths of the rectangle around the feet.
    pub(in crate::object) feet: (f32, f32),
    /// The half lengths of the rectangle around the heads.
    pub(in crate::object) heads: (f32, f32),
    /// The height of their upper ends.
    pub(in crate::object) height: f32,
    /// The half widths at the floor and at the top.
    pub(in crate::object) radii: (f32, f32),
    /// The cross section.
    pub(in crate::object) cut: Cut,
}

impl Four {
    /// Upright legs in the corners of a rectangle.
    pub(in crate::object) fn upright(half: (f32, f32), height: f32, radii: (f32, f32), cut: Cut) -> Self {
        let foot = (half.0 - radii.1 + radii.0, half.1 - radii.1 + radii.0);
        Self { feet: foot, heads: half, height, radii, cut }
    }

    /// Builds the legs.
    pub(in crate::object) fn build(&self, b: &mut Build<'_>, mat: Mat) {
        let (r0, r1) = self.radii;
        for (sx, sy) in CORNERS {
            let foot = [sx * (self.feet.0 - r0), sy * (self.feet.1 - r0), 0.0];
            let head = [sx * (self.heads.0 - r1), sy * (self.heads.1 - r1), self.height];
            leg(b, "leg", (foot, r0), (head, r1), self.cut, mat);
        }
    }

    /// The centre of a leg at a height; the signs give its corner.
    pub(in crate::object) fn middle(&self, corner: (f32, f32), z: f32) -> P {
        let k = z / self.height;
        let mix = |foot: f32, head: f32| (foot - self.radii.0) * (1.0 - k) + (head - self.radii.1) * k;
        [corner.0 * mix(self.feet.0, self.heads.0), corner.1 * mix(self.feet.1, self.heads.1), z]
    }

    /// A rod between two legs at a height.
    pub(in crate::object) fn rung(&self, b: &mut Build<'_>, from: usize, to: usize, z: f32, radius: f32, mat: Mat) {
        b.rod("rung", self.middle(CORNERS[from], z), self.middle(CORNERS[to], z), radius, mat);
    }
}

/// A board that follows a line of (x, z), extruded from `y.0` to `y.1`. The line is the visible
/// side: if it runs from the front to the back and up, the board is below and behind it.
pub(in crate::object) fn ribbon(
    b: &mut Build<'_>,
    name: &str,
    line: &[(f32, f32)],
    thickness: f32,
    y: (f32, f32),
    mat: Mat,
) {
    let ups = ups(line);
    let under = line.iter().zip(&ups).rev().map(|(p, up)| (p.0 - up.0 * thickness, p.1 - up.1 * thickness));
    let outline: Vec<(f32, f32)> = line.iter().copied().chain(under).collect();
    b.prism(name, Axis::Y, [0.0, y.0, 0.0], &outline, y.1 - y.0, mat);
}

/// One row of a shell: its position, half its width and how far its edges rise.
#[derive(Debug, Clone, Copy)]
pub(in crate::object) struct Row {
    /// X and Z.
    pub(in crate::object) at: (f32, f32),
    /// Half the width.
    pub(in crate::object) half: f32,
    /// How far the edges rise above the centre.
    pub(in crate::object) rise: f32,
}

/// A doubly curved sheet, from its front edge to the back and up.
pub(in crate::object) fn shell(b: &mut Build<'_>, name: &str, rows: &[Row], thickness: f32, mat: Mat) {
    const ACROSS: u32 = 6;
    let line: Vec<(f32, f32)> = rows.iter().map(|r| r.at).collect();
    let ups = ups(&line);
    let layer = |lower: f32| {
        rows.iter().zip(&ups).flat_map(move |(row, up)| {
            (0..=ACROSS).map(move |j| {
                let v = 2.0 * j as f32 / ACROSS as f32 - 1.0;
                let lift = row.rise * v * v - lower;
                [row.at.0 + up.0 * lift, row.half * v, row.at.1 + up.1 * lift]
            })
        })
    };
    let vertices: Vec<P> = layer(0.0).chain(layer(thickness)).collect();
    let (last, wide) = (rows.len() as u32 - 1, ACROSS + 1);
    let under = rows.len() as u32 * wide;
    let mut triangles = Vec::new();
    for (i, j) in (0..last).flat_map(|i| (0..ACROSS).map(move |j| (i, j))) {
        let [p, q, r, s] = [(i, j), (i, j + 1), (i + 1, j + 1), (i + 1, j)].map(|(i, j)| i * wide + j);
        triangles.extend([[p, q, r], [p, r, s]]);
        triangles.extend([[p, r, q], [p, s, r]].map(|t| t.map(|v| v + under)));
    }
    let rim = (0..ACROSS).chain((0..last).map(|i| i * wide + ACROSS));
    let rim = rim.chain((1..wide).rev().map(|j| last * wide + j)).chain((1..=last).rev().map(|i| i * wide));
    let rim: Vec<u32> = rim.collect();
    for (&p, &q) in rim.iter().zip(rim.iter().cycle().skip(1)) {
        triangles.extend([[p + under, q + under, q], [p + under, q, p]]);
    }
    b.mesh(name, vertices, triangles, mat);
}

/// The normal of the upper side at each point of a line.
fn ups(line: &[(f32, f32)]) -> Vec<(f32, f32)> {
    let steps: Vec<(f32, f32)> = line.windows(2).map(|w| unit((w[1].1 - w[0].1, w[0].0 - w[1].0))).collect();
    let at = |i: usize| steps.get(i).copied().unwrap_or_default();
    (0..line.len())
        .map(|i| {
            let (a, c) = (if i > 0 { at(i - 1) } else { at(0) }, if i < steps.len() { at(i) } else { at(i - 1) });
            unit((a.0 + c.0, a.1 + c.1))
        })
        .collect()
}

fn unit(v: (f32, f32)) -> (f32, f32) {
    let length = v.0.hypotenuse(v.1).max(1e-6);
    (v.0 / length, v.1 / length)
}

/// A padded board that leans back, given by its rearmost X, its heights, its thickness and its
/// tilt.
pub(in crate::object) struct Lean {
    /// The least X.
    pub(in crate::object) back: f32,
    /// The heights of its lower and its upper front edge.
    pub(in crate::object) z: (f32, f32),
    /// The distance from its front to its back.
    pub(in crate::object) thickness: f32,
    /// The angle from upright, radians.
    pub(in crate::object) tilt: f32,
}

impl Lean {
    fn length(&self) -> f32 {
        (self.z.1 - self.z.0) / self.tilt.cosine()
    }

    /// The X of its front at a height.
    pub(in crate::object) fn front(&self, z: f32) -> f32 {
        self.back + self.thickness * self.tilt.cosine() + (self.z.1 - z) * self.tilt.tangent()
    }

    /// Builds one with rounded edges from `y.0` to `y.1`.
    pub(in crate::object) fn pad(&self, b: &mut Build<'_>, name: &str, y: (f32, f32), radius: f32, mat: Mat) {
        self.posed(b, |b, length, thickness| b.soft(name, [-thickness, y.0, 0.0], [0.0, y.1, length], radius, mat));
    }

    /// Builds in its frame: Z along it, X forward from its front.
    pub(in crate::object) fn posed(&self, b: &mut Build<'_>, build: impl FnOnce(&mut Build<'_>, f32, f32)) {
        let at = Vector3::new(self.front(self.z.0), 0.0, self.z.0);
        let (length, thickness) = (self.length(), self.thickness);
        b.posed(Isometry3::new(at, Vector3::y() * -self.tilt), |b| build(b, length, thickness));
    }
}

/// An outline with rounded corners around the origin, for prisms along Z. Large radii give a
/// stadium or a circle.
pub(in crate::object) fn rounded(half: (f32, f32), radius: f32) -> Vec<(f32, f32)> {
    let r = radius.min(half.0 * 0.999).min(half.1 * 0.999);
    turned(6, (r, r)).into_iter().map(|(c, p)| (p.0 + c.0 * (half.0 - r), p.1 + c.1 * (half.1 - r))).collect()
}

/// The outline of an ellipse.
pub(in crate::object) fn ellipse(half: (f32, f32)) -> Vec<(f32, f32)> {
    let mut points: Vec<_> = turned(8, half).into_iter().map(|(_, p)| p).collect();
    points.dedup_by(|a, b| (a.0 - b.0).abs() + (a.1 - b.1).abs() < 1e-5);
    points.pop();
    points
}

/// Four quarters of an ellipse, each including both ends, as pairs of the quarter's corner and a
/// point.
fn turned(steps: usize, half: (f32, f32)) -> Vec<((f32, f32), (f32, f32))> {
    let arc = (0..=steps).map(move |i| {
        // Tangents of half angles give points of a circle without a sine; the correction by the
        // tangent of an eighth turn spaces them evenly.
        let k = i as f32 / steps as f32;
        let t = k * (1.0 + k * 0.2) / 1.2;
        ((1.0 - t * t) / (1.0 + t * t), 2.0 * t / (1.0 + t * t))
    });
    let arc: Vec<(f32, f32)> = arc.collect();
    let quarter = |q: usize| {
        let corner = CORNERS[q];
        arc.clone().into_iter().map(move |(c, s)| {
            let (x, y) = [(c, s), (-s, c), (-c, -s), (s, -c)][q];
            (corner, (x * half.0, y * half.1))
        })
    };
    (0..4).flat_map(quarter).collect()
}

/// A round board with softened edges, its upper side at `z`.
pub(in crate::object) fn disc(b: &mut Build<'_>, name: &str, at: P, radius: f32, thickness: f32, mat: Mat) {
    let e = (thickness * 0.3).min(0.006);
    let profile = [(radius - e, 0.0), (radius, e), (radius, thickness - e), (radius - e, thickness)];
    b.lathe(name, [at[0], at[1], at[2] - thickness], &profile, mat);
}

/// A turned leg with beads and a vase shape, with radius `r` at its widest.
pub(in crate::object) fn baluster(b: &mut Build<'_>, name: &str, base: P, r: f32, height: f32, mat: Mat) {
    const PROFILE: [(f32, f32); 13] = [
        (0.55, 0.0),
        (0.7, 0.04),
        (0.45, 0.09),
        (0.5, 0.12),
        (0.85, 0.35),
        (0.9, 0.5),
        (0.6, 0.66),
        (0.5, 0.7),
        (0.9, 0.73),
        (0.9, 0.77),
        (0.55, 0.8),
        (1.0, 0.83),
        (1.0, 1.0),
    ];
    let profile = PROFILE.map(|(x, z)| (x * r, z * height));
    b.lathe(name, base, &profile, mat);
}
