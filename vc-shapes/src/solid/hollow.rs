//! Hollow bodies: tubs, trays, cases, vessels, and plates with holes.

use vc_graph::portable::Portable;

use super::body::loft_columns;
use super::build::{Axis, Build, P};
use super::curve::rounded_ring;
use super::mesh::blocks;
use super::outline::CORNERS;
use super::profile::vessel_profile;
use crate::material::MaterialId;

/// Half the side of the smallest placement surface, metres.
const LEAST: f32 = 0.0042;

/// A hollow vessel whose plan is a rounded rectangle. `outside` is its outer (height, half depth,
/// half width) from the bottom up; `t` is the wall thickness.
pub fn tub(b: &mut Build<'_>, name: &str, outside: &[(f32, f32, f32)], round: f32, t: f32, mat: MaterialId) {
    let floor = outside.first().map_or(0.0, |s| s.0) + t;
    let thin = |v: f32| (v - t).max(v * 0.3);
    let outer = outside.iter().map(|&(z, x, y)| rounded_ring(z, (x, y), round));
    let inner = outside.iter().rev().map(|&(z, x, y)| rounded_ring(z.max(floor), (thin(x), thin(y)), round));
    let rings: Vec<_> = outer.chain(inner).collect();
    loft_columns(b, name, &rings, mat);
}

/// An open box whose bottom and top rectangles differ; both are given by their outer half lengths.
#[allow(clippy::too_many_arguments)]
pub fn tapered_tub(
    b: &mut Build<'_>,
    name: &str,
    base: P,
    bottom: (f32, f32),
    top: (f32, f32),
    height: f32,
    wall: f32,
    mat: MaterialId,
) {
    let [x, y, z] = base;
    let corner = |(hx, hy): (f32, f32), i: usize, z: f32, inset: f32| {
        let (sx, sy) = CORNERS[i % 4];
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

/// An open box: four walls and a bottom of thickness `t`.
pub(crate) fn walled_tray(b: &mut Build<'_>, (x, y): (f32, f32), (low, high): (f32, f32), t: f32, mat: MaterialId) {
    let (mid, foot) = (t * 0.5, low + t * 0.3);
    b.block("bottom", [mid - x, mid - y, low], [x - mid, y - mid, low + t], mat);
    let list = [
        ([-x, -y, foot], [x, -y + t, high]),
        ([-x, y - t, foot], [x, y, high]),
        ([-x, -y + t * 0.9, foot], [-x + t, y - t * 0.9, high]),
        ([x - t, -y + t * 0.9, foot], [x, y - t * 0.9, high]),
    ];
    blocks(b, "wall", &list, mat);
}

/// A box with walls `t` thick, open above.
pub(crate) fn pit(b: &mut Build<'_>, name: &str, low: P, high: P, t: f32, mat: MaterialId) {
    b.block(name, low, [high[0], high[1], low[2] + t], mat);
    let walls = ([low[0], low[1], low[2] + t], high);
    plate_with_hole(b, name, Axis::Z, walls, ((low[0] + t, low[1] + t), (high[0] - t, high[1] - t)), mat);
}

/// An open box whose bottom is a surface inside.
///
/// ```
/// # use vc_graph::{Seed, nalgebra::Vector3};
/// # use vc_shapes::{Build, Style};
/// # let style = Style::from_seed(Seed(1));
/// # let mut b = Build::new("thing", Vector3::new(1.0, 1.0, 1.0), &style, Seed(1).stream());
/// use vc_shapes::material::OAK;
/// use vc_shapes::solid::basket;
/// basket(&mut b, "crate", [-0.2, -0.3, 0.0], [0.2, 0.3, 0.25], 0.01, OAK);
/// let (asset, bounds) = b.finish();
/// assert_eq!(asset.surfaces.len(), 1);
/// assert!((bounds.size() - Vector3::new(0.4, 0.6, 0.25)).norm() < 2e-3);
/// ```
pub fn basket(b: &mut Build<'_>, name: &str, low: P, high: P, t: f32, mat: MaterialId) {
    pit(b, name, low, high, t, mat);
    floor_of(b, name, [low[0] + t, low[1] + t, low[2] + t], [high[0] - t, high[1] - t, high[2]]);
}

/// A box with walls `t` thick, open towards X.
///
/// ```
/// # use vc_graph::{Seed, nalgebra::Vector3};
/// # use vc_shapes::{Build, Style};
/// # let style = Style::from_seed(Seed(1));
/// # let mut b = Build::new("thing", Vector3::new(1.0, 1.0, 1.0), &style, Seed(1).stream());
/// use vc_shapes::material::OAK;
/// use vc_shapes::solid::case;
/// case(&mut b, [-0.2, -0.3, 0.0], [0.2, 0.3, 0.9], 0.02, OAK);
/// let (_, bounds) = b.finish();
/// assert!((bounds.size() - Vector3::new(0.4, 0.6, 0.9)).norm() < 2e-3);
/// ```
pub fn case(b: &mut Build<'_>, low: P, high: P, t: f32, mat: MaterialId) {
    b.block("back", low, [low[0] + t, high[1], high[2]], mat);
    plate_with_border(b, "case", [low[0] + t, low[1], low[2]], high, t, mat);
}

/// A plate with a rectangular hole through `axis`. The corners of the hole are given in the other
/// two axes, in their order.
///
/// ```
/// # use vc_graph::{Seed, nalgebra::Vector3};
/// # use vc_shapes::{Build, Style};
/// # let style = Style::from_seed(Seed(1));
/// # let mut b = Build::new("thing", Vector3::new(1.0, 1.0, 1.0), &style, Seed(1).stream());
/// use vc_shapes::material::OAK;
/// use vc_shapes::solid::{Axis, plate_with_hole};
/// let (low, high) = ([-0.3, -0.3, 0.0], [0.3, 0.3, 0.03]);
/// plate_with_hole(&mut b, "top", Axis::Z, (low, high), ((-0.1, -0.1), (0.1, 0.1)), OAK);
/// assert_eq!(b.finish().0.parts.len(), 4);
/// ```
pub fn plate_with_hole(
    b: &mut Build<'_>,
    name: &str,
    axis: Axis,
    (low, high): (P, P),
    hole: ((f32, f32), (f32, f32)),
    mat: MaterialId,
) {
    let (u, v) = match axis {
        Axis::X => (1, 2),
        Axis::Y => (0, 2),
        Axis::Z => (0, 1),
    };
    let ((u0, v0), (u1, v1)) = hole;
    let pieces =
        [(low[u], high[u], low[v], v0), (low[u], high[u], v1, high[v]), (low[u], u0, v0, v1), (u1, high[u], v0, v1)];
    for (ua, ub, va, vb) in pieces.into_iter().filter(|p| p.1 - p.0 > 1e-5 && p.3 - p.2 > 1e-5) {
        let (mut from, mut to) = (low, high);
        (from[u], to[u], from[v], to[v]) = (ua, ub, va, vb);
        b.block(name, from, to, mat);
    }
}

/// A plate in the plane of X with a border `w` wide around its hole.
pub(crate) fn plate_with_border(b: &mut Build<'_>, name: &str, low: P, high: P, w: f32, mat: MaterialId) {
    plate_with_hole(b, name, Axis::X, (low, high), ((low[1] + w, low[2] + w), (high[1] - w, high[2] - w)), mat);
}

/// A ring revolved about the line from one point to another.
pub fn collar(b: &mut Build<'_>, name: &str, (from, to): (P, P), radii: (f32, f32), mat: MaterialId) {
    let length = (0..3).map(|i| (to[i] - from[i]).raised(2)).sum::<f32>().sqrt();
    let (inner, outer) = radii;
    let profile = [(inner, 0.0), (outer, 0.0), (outer, length), (inner, length), (inner, 0.0)];
    b.lathe_along(name, from, to, &profile, mat);
}

/// A closed strip between two outlines with equal numbers of corners.
pub fn ring_wall(
    b: &mut Build<'_>,
    name: &str,
    [outer, inner]: [&[(f32, f32)]; 2],
    (low, high): (f32, f32),
    mat: MaterialId,
) {
    let n = outer.len() as u32;
    let level = |outline: &[(f32, f32)], z: f32| -> Vec<P> { outline.iter().map(|p| [p.0, p.1, z]).collect() };
    let vertices = [level(outer, low), level(outer, high), level(inner, low), level(inner, high)].concat();
    let mut triangles = Vec::new();
    let mut quad = |a: u32, c: u32, d: u32, e: u32| triangles.extend([[a, c, d], [a, d, e]]);
    for i in 0..n {
        let j = (i + 1) % n;
        quad(i, j, n + j, n + i);
        quad(2 * n + j, 2 * n + i, 3 * n + i, 3 * n + j);
        quad(n + i, n + j, 3 * n + j, 3 * n + i);
        quad(2 * n + i, 2 * n + j, j, i);
    }
    b.mesh(name, vertices, triangles, mat);
}

/// A hollow round vessel; its outline is given as fractions of a radius and a height. Its content
/// is inside.
///
/// ```
/// # use vc_graph::{Seed, nalgebra::Vector3};
/// # use vc_shapes::{Build, Style};
/// # let style = Style::from_seed(Seed(1));
/// # let mut b = Build::new("thing", Vector3::new(1.0, 1.0, 1.0), &style, Seed(1).stream());
/// use vc_shapes::material::POTTERY;
/// use vc_shapes::solid::vessel;
/// // The outline from foot to rim, as fractions of the radius and the height.
/// vessel(&mut b, "vase", (0.08, 0.25), &[(0.6, 0.0), (1.0, 0.4), (0.7, 1.0)], 0.005, POTTERY);
/// let (asset, bounds) = b.finish();
/// assert!((bounds.size().z - 0.25).abs() < 1e-3 && asset.surfaces.len() == 1);
/// ```
pub fn vessel(b: &mut Build<'_>, name: &str, (r, h): (f32, f32), outside: &[(f32, f32)], t: f32, mat: MaterialId) {
    let outside: Vec<_> = outside.iter().map(|p| (p.0 * r, p.1 * h)).collect();
    let profile = vessel_profile(&outside, t);
    let narrowest = profile[outside.len()..].iter().fold(r, |least, p| least.min(p.0));
    b.lathe(name, [0.0; 3], &profile, mat);
    let floor = profile.last().map_or(t, |p| p.1);
    b.inside(
        "inside",
        [0.0, 0.0, floor],
        ((narrowest * 0.66).max(LEAST), (narrowest * 0.66).max(LEAST)),
        (h - floor).max(0.0),
    );
}

/// A solid through level loops with equal numbers of points, from the outer bottom edge over the
/// rim to the inner bottom; the first and the last are closed by flat faces. Loops are convex and
/// counter-clockwise seen from above.
pub(crate) fn loft_levels(b: &mut Build<'_>, name: &str, loops: &[(Vec<(f32, f32)>, f32)], mat: MaterialId) {
    let Some(n) = loops.first().map(|l| l.0.len() as u32).filter(|n| *n > 2) else { return };
    let vertices: Vec<P> = loops.iter().flat_map(|(points, z)| points.iter().map(|p| [p.0, p.1, *z])).collect();
    let mut triangles = Vec::new();
    for level in 0..loops.len() as u32 - 1 {
        let (a, c) = (level * n, level * n + n);
        for i in 0..n {
            let k = (i + 1) % n;
            triangles.extend([[a + i, a + k, c + k], [a + i, c + k, c + i]]);
        }
    }
    let last = (loops.len() as u32 - 1) * n;
    for i in 1..n - 1 {
        triangles.extend([[0, i + 1, i], [last, last + i, last + i + 1]]);
    }
    b.mesh(name, vertices, triangles, mat);
}

/// The bottom of the hollow `low..high` as a surface inside.
pub(crate) fn floor_of(b: &mut Build<'_>, name: &str, low: P, high: P) {
    let centre = [f32::midpoint(low[0], high[0]), f32::midpoint(low[1], high[1]), low[2]];
    let half = |i: usize| ((high[i] - low[i]) * 0.48).max(0.0);
    b.inside(name, centre, (half(0), half(1)), (high[2] - low[2] - 0.002).max(0.0));
}

/// The bottom of a round vessel as a surface inside.
pub(crate) fn round_floor(b: &mut Build<'_>, name: &str, at: P, radius: f32, clearance: f32) {
    let half = radius * 0.68;
    b.inside(name, at, (half, half), clearance.max(0.0));
}

/// Divides the hollow `low..high` into `count` compartments one above the other, each with a
/// surface inside; `floor` builds the boards between them, `t` thick.
///
/// ```
/// # use vc_graph::{Seed, nalgebra::Vector3};
/// # use vc_shapes::{Build, Style};
/// # let style = Style::from_seed(Seed(1));
/// # let mut b = Build::new("thing", Vector3::new(1.0, 1.0, 1.0), &style, Seed(1).stream());
/// use vc_shapes::material::OAK;
/// use vc_shapes::solid::tiers;
/// let hollow = ([-0.2, -0.3, 0.0], [0.2, 0.3, 0.9]);
/// tiers(&mut b, "shelf", hollow, 3, 0.02, |b, low, high| b.block("board", low, high, OAK));
/// let (asset, _) = b.finish();
/// assert_eq!((asset.parts.len(), asset.surfaces.len()), (2, 3));
/// ```
pub fn tiers(
    b: &mut Build<'_>,
    name: &str,
    (low, high): (P, P),
    count: usize,
    t: f32,
    floor: impl Fn(&mut Build<'_>, P, P),
) {
    let pitch = (high[2] - low[2] + t) / count.max(1) as f32;
    for i in 0..count.max(1) {
        let z = low[2] + pitch * i as f32;
        if i > 0 {
            floor(b, [low[0], low[1], z - t], [high[0], high[1], z]);
        }
        floor_of(b, &format!("{name}_{}", i + 1), [low[0], low[1], z], [high[0], high[1], z + pitch - t]);
    }
}
