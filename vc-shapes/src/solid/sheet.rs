//! Boards and sheets: flat plates, boards along a line, doubly curved sheets, and legs.

use nalgebra::Vector3;
use vc_graph::portable::Portable;

use super::build::{Axis, Build, P};
use super::outline::CORNERS;
use crate::material::MaterialId;

/// A thin plate from the four corners of one face; the thickness extends to the side from which the
/// corners run clockwise.
///
/// ```
/// # use vc_graph::{Seed, nalgebra::Vector3};
/// # use vc_shapes::{Build, Style};
/// # let style = Style::from_seed(Seed(1));
/// # let mut b = Build::new("thing", Vector3::new(1.0, 1.0, 1.0), &style, Seed(1).stream());
/// use vc_shapes::material::OAK;
/// use vc_shapes::solid::plate;
/// let quad = [[0.1, 0.1, 0.5], [-0.1, 0.1, 0.5], [-0.1, -0.1, 0.5], [0.1, -0.1, 0.5]];
/// plate(&mut b, "lid", quad, 0.01, OAK);
/// let (_, bounds) = b.finish();
/// assert!((bounds.size() - Vector3::new(0.2, 0.2, 0.01)).norm() < 2e-3);
/// ```
pub fn plate(b: &mut Build<'_>, name: &str, quad: [P; 4], thickness: f32, mat: MaterialId) {
    let [p, q, r, s] = quad.map(Vector3::from);
    let normal = (r - p).cross(&(s - q)).try_normalize(1e-9).unwrap_or_else(Vector3::z) * thickness;
    let points: Vec<P> = [p, q, r, s].iter().flat_map(|&c| [c.into(), (c - normal).into()]).collect();
    b.hull(name, &points, mat);
}

/// The cross section of a leg.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Cut {
    /// Four sides along the axes.
    Square,
    /// Eight sides.
    Round,
}

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

/// A leg between two level ends, each given by its centre and half width.
///
/// ```
/// # use vc_graph::{Seed, nalgebra::Vector3};
/// # use vc_shapes::{Build, Style};
/// # let style = Style::from_seed(Seed(1));
/// # let mut b = Build::new("thing", Vector3::new(1.0, 1.0, 1.0), &style, Seed(1).stream());
/// use vc_shapes::material::OAK;
/// use vc_shapes::solid::{Cut, leg};
/// leg(&mut b, "leg", ([0.0; 3], 0.02), ([0.0, 0.0, 0.7], 0.03), Cut::Square, OAK);
/// let (_, bounds) = b.finish();
/// assert!((bounds.size() - Vector3::new(0.06, 0.06, 0.7)).norm() < 2e-3);
/// ```
pub fn leg(b: &mut Build<'_>, name: &str, foot: (P, f32), head: (P, f32), cut: Cut, mat: MaterialId) {
    let ring: &[(f32, f32)] = if cut == Cut::Square { &CORNERS } else { &OCTAGON };
    let end = |(at, r): (P, f32)| ring.iter().map(move |c| [at[0] + c.0 * r, at[1] + c.1 * r, at[2]]);
    let points: Vec<P> = end(foot).chain(end(head)).collect();
    b.hull(name, &points, mat);
}

/// A board that follows a line of (x, z), extruded from `y.0` to `y.1`. The line is the visible
/// side: if it runs from the front to the back and up, the board is below and behind it.
pub fn ribbon(b: &mut Build<'_>, name: &str, line: &[(f32, f32)], thickness: f32, y: (f32, f32), mat: MaterialId) {
    let ups = ups(line);
    let under = line.iter().zip(&ups).rev().map(|(p, up)| (p.0 - up.0 * thickness, p.1 - up.1 * thickness));
    let outline: Vec<(f32, f32)> = line.iter().copied().chain(under).collect();
    b.prism(name, Axis::Y, [0.0, y.0, 0.0], &outline, y.1 - y.0, mat);
}

/// One row of a curved sheet: its position, half its width and the rise of its edges.
#[derive(Debug, Clone, Copy)]
pub struct SheetRow {
    /// X and Z.
    pub at: (f32, f32),
    /// Half the width.
    pub half: f32,
    /// The rise of the edges above the centre, metres.
    pub rise: f32,
}

/// A doubly curved sheet, from its front edge to the back and up.
pub fn curved_sheet(b: &mut Build<'_>, name: &str, rows: &[SheetRow], thickness: f32, mat: MaterialId) {
    const ACROSS: u32 = 6;
    if rows.len() < 2 {
        return;
    }
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

/// A round board with softened edges, its upper side at `z`.
///
/// ```
/// # use vc_graph::{Seed, nalgebra::Vector3};
/// # use vc_shapes::{Build, Style};
/// # let style = Style::from_seed(Seed(1));
/// # let mut b = Build::new("thing", Vector3::new(1.0, 1.0, 1.0), &style, Seed(1).stream());
/// use vc_shapes::material::OAK;
/// use vc_shapes::solid::disc;
/// disc(&mut b, "top", [0.0, 0.0, 0.74], 0.4, 0.03, OAK);
/// let (_, bounds) = b.finish();
/// assert!((bounds.size() - Vector3::new(0.8, 0.8, 0.03)).norm() < 2e-3);
/// ```
pub fn disc(b: &mut Build<'_>, name: &str, at: P, radius: f32, thickness: f32, mat: MaterialId) {
    let e = (thickness * 0.3).min(0.006);
    let profile = [(radius - e, 0.0), (radius, e), (radius, thickness - e), (radius - e, thickness)];
    b.lathe(name, [at[0], at[1], at[2] - thickness], &profile, mat);
}

/// A closed surface between two point grids of the same shape, such as a boat's hull: rows run
/// along X, each from the left rim under the keel to the right rim.
pub(crate) fn hull_shell(b: &mut Build<'_>, name: &str, outer: &[Vec<P>], inner: &[Vec<P>], mat: MaterialId) {
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
