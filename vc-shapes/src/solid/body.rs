//! Bent and lumpy bodies: sweeps along plane curves, handles, spindles and boulders.

use std::f32::consts::{PI, TAU};

use nalgebra::Vector3;
use vc_graph::portable::Portable;

use super::build::{Build, P};
use super::circle;
use super::curve::{arch, level_oval};
use crate::material::MaterialId;

/// Points around a bent or oval object: a multiple of four, and enough to look round.
const SIDES: usize = 12;

/// A closed surface over rings with equal numbers of points, from one end to the other. Its triangles are ordered
/// along the rings' points, those of [`loft`](super::loft) ring by ring.
pub(crate) fn loft_columns(b: &mut Build<'_>, name: &str, rings: &[Vec<P>], mat: MaterialId) {
    let n = rings.iter().map(Vec::len).min().unwrap_or(0);
    if n < 3 || rings.len() < 2 {
        return;
    }
    let mut vertices = Vec::with_capacity(rings.len() * n + 2);
    rings.iter().for_each(|r| vertices.extend_from_slice(&r[..n]));
    let last = rings.len().saturating_sub(1);
    let at = |row: usize, k: usize| (row * n + k % n) as u32;
    let middle = |row: usize| [0, 1, 2].map(|i| rings[row].iter().map(|p| p[i]).sum::<f32>() / n as f32);
    let (bottom, top) = (vertices.len() as u32, vertices.len() as u32 + 1);
    let mut triangles = Vec::with_capacity(2 * n * rings.len());
    for k in 0..n {
        for row in 0..last {
            let [a, b] = [at(row, k), at(row, k + 1)];
            let [c, d] = [at(row + 1, k + 1), at(row + 1, k)];
            triangles.extend([[a, b, c], [a, c, d]]);
        }
        triangles.extend([[bottom, at(0, k + 1), at(0, k)], [top, at(last, k), at(last, k + 1)]]);
    }
    for row in [0, last] {
        vertices.push(middle(row));
    }
    if volume(&vertices, &triangles) < 0.0 {
        triangles.iter_mut().for_each(|t| t.swap(1, 2));
    }
    b.mesh(name, vertices, triangles, mat);
}

fn volume(vertices: &[P], triangles: &[[u32; 3]]) -> f32 {
    let at = |v: u32| Vector3::from(vertices[v as usize]);
    triangles.iter().map(|&[a, b, c]| at(a).dot(&at(b).cross(&at(c)))).sum()
}

/// A tube along a path in a plane: each point has its half width along `side`, which is
/// perpendicular to that plane, and its half thickness within the plane.
pub fn sweep(b: &mut Build<'_>, name: &str, path: &[(P, f32, f32)], side: P, mat: MaterialId) {
    let side = Vector3::from(side).normalize();
    let at = |i: usize| Vector3::from(path[i.min(path.len() - 1)].0);
    let ring = |i: usize| {
        let (centre, width, thick) = (at(i), path[i].1, path[i].2);
        let way = at(i + 1) - at(i.saturating_sub(1));
        let up = way.cross(&side).try_normalize(1e-12).unwrap_or_else(Vector3::z);
        let point = move |k: usize| {
            let (s, c) = circle::part(k, SIDES);
            let mut p: P = (centre + side * (width * c) + up * (thick * s)).into();
            // Both ends are cut perpendicular to an axis so that they stay at the given positions.
            if i == 0 || i + 1 == path.len() {
                p[way.iamax()] = path[i].0[way.iamax()];
            }
            p
        };
        (0..SIDES).map(point).collect()
    };
    let rings: Vec<_> = (0..path.len()).map(ring).collect();
    loft_columns(b, name, &rings, mat);
}

/// A round tube through points of a plane perpendicular to `side`.
pub(crate) fn planar_tube(b: &mut Build<'_>, name: &str, points: &[P], radius: f32, side: P, mat: MaterialId) {
    let path: Vec<_> = points.iter().map(|&p| (p, radius, radius)).collect();
    sweep(b, name, &path, side, mat);
}

/// An ear-shaped handle, upright at the Y side of a vessel, from `y.0` out to `y.1`.
///
/// ```
/// # use vc_graph::{Seed, nalgebra::Vector3};
/// # use vc_shapes::{Build, Style};
/// # let style = Style::from_seed(Seed(1));
/// # let mut b = Build::new("thing", Vector3::new(1.0, 1.0, 1.0), &style, Seed(1).stream());
/// use vc_shapes::material::POTTERY;
/// use vc_shapes::solid::ear;
/// ear(&mut b, (0.04, 0.07), (0.02, 0.08), 0.004, POTTERY);
/// let (asset, _) = b.finish();
/// assert_eq!(&*asset.parts[0].name, "handle");
/// ```
pub fn ear(b: &mut Build<'_>, y: (f32, f32), z: (f32, f32), radius: f32, mat: MaterialId) {
    let r = radius.min((z.1 - z.0).abs() * 0.2).max(1e-4);
    let reach = (y.1 - y.0 - r).max(1e-4);
    let path = arch([0.0, y.0, f32::midpoint(z.0, z.1)], [0.0, 0.0, (z.1 - z.0) / 2.0 - r], [0.0, reach, 0.0]);
    planar_tube(b, "handle", &path, r, [1.0, 0.0, 0.0], mat);
}

/// A lump: an ellipsoid with bumps of up to a fraction of its size.
///
/// ```
/// # use vc_graph::{Seed, nalgebra::Vector3};
/// # use vc_shapes::{Build, Style};
/// # let style = Style::from_seed(Seed(1));
/// # let mut b = Build::new("thing", Vector3::new(1.0, 1.0, 1.0), &style, Seed(1).stream());
/// use vc_shapes::material::POTTERY;
/// use vc_shapes::solid::lump;
/// lump(&mut b, "potato", [0.0, 0.0, 0.04], [0.05, 0.04, 0.04], 0.2, POTTERY);
/// assert!(b.finish().1.size().x <= 0.1);
/// ```
pub fn lump(b: &mut Build<'_>, name: &str, centre: P, half: P, bump: f32, mat: MaterialId) {
    boulder(b, name, (centre, half), bump, (SIDES, 7), mat);
}

/// A lump with the given numbers of sides and rows: many for a single lump, few in a heap.
pub fn boulder(
    b: &mut Build<'_>,
    name: &str,
    (centre, half): (P, P),
    bump: f32,
    (sides, rows): (usize, usize),
    mat: MaterialId,
) {
    let phases = [b.vary(0.0, TAU), b.vary(0.0, TAU), b.vary(0.0, TAU)];
    // Terms that are equal in all rows.
    let around = |k: usize| {
        let angle = TAU * k as f32 / sides as f32;
        (angle, (3.0 * angle + phases[1]).cosine(), (phases[2] + 2.0 * angle).cosine(), circle::part(k, sides))
    };
    let around: Vec<_> = (0..sides).map(around).collect();
    let ring = |i: usize| {
        let (rise, level) = (PI * (i as f32 / rows as f32 - 0.5)).sine_cosine();
        let point = |k: usize| {
            let (angle, ripple, lean, (s, c)) = around[k];
            let wave = (2.0 * angle + phases[0] + 3.0 * rise).cosine() + ripple;
            let size = (1.0 + bump * 0.5 * wave) / (1.0 + bump);
            let tilt = bump * 0.4 * lean * level;
            [
                centre[0] + half[0] * level * size * c,
                centre[1] + half[1] * level * size * s,
                centre[2] + half[2] * (rise - tilt * rise.abs()).clamp(-1.0, 1.0),
            ]
        };
        (0..sides).map(point).collect()
    };
    let rings: Vec<_> = (0..=rows).map(ring).collect();
    loft_columns(b, name, &rings, mat);
}

/// A profile with an extra point between each pair, on a Catmull-Rom curve through them.
fn smoothed(profile: &[(f32, f32)]) -> Vec<(f32, f32)> {
    let last = profile.len().saturating_sub(1);
    let between = |i: usize| {
        let [a, b, c, d] = [i.saturating_sub(1), i, i + 1, (i + 2).min(last)].map(|k| profile[k]);
        let curve = |a: f32, b: f32, c: f32, d: f32| ((9.0 * (b + c) - a - d) / 16.0).clamp(0.0, 1.0);
        (curve(a.0, b.0, c.0, d.0), curve(a.1, b.1, c.1, d.1))
    };
    let pairs = (0..last).flat_map(|i| [profile[i], between(i)]);
    pairs.chain(profile.last().copied()).collect()
}

/// A body of elliptical sections between two corners: a profile as fractions of its half width and
/// length, upright or, if `lying`, along Y.
pub(crate) fn spun(
    b: &mut Build<'_>,
    name: &str,
    (low, high): (P, P),
    profile: &[(f32, f32)],
    lying: bool,
    mat: MaterialId,
) {
    let centre = [0, 1, 2].map(|i| f32::midpoint(low[i], high[i]));
    let half = [0, 1, 2].map(|i| (high[i] - low[i]) / 2.0);
    let ring = |&(r, k): &(f32, f32)| {
        let across = if lying { half[2] } else { half[1] };
        let turned = level_oval([0.0; 3], (half[0] * r, across * r)).into_iter();
        let place = |p: P| {
            let rise = 2.0 * k - 1.0;
            let [y, z] = if lying { [half[1] * rise, p[1]] } else { [p[1], half[2] * rise] };
            [centre[0] + p[0], centre[1] + y, centre[2] + z]
        };
        turned.map(place).collect()
    };
    // Profiles with many points have intended edges.
    let profile = if profile.len() < 14 { smoothed(profile) } else { profile.to_vec() };
    let rings: Vec<_> = profile.iter().map(ring).collect();
    loft_columns(b, name, &rings, mat);
}

/// A lathe body whose profile is given as fractions of a radius and a height.
pub fn turn(b: &mut Build<'_>, name: &str, base: P, (r, h): (f32, f32), profile: &[(f32, f32)], mat: MaterialId) {
    let profile: Vec<_> = profile.iter().map(|p| (p.0 * r, p.1 * h)).collect();
    b.lathe(name, base, &profile, mat);
}

/// A flat ring between two radii.
///
/// ```
/// # use vc_graph::{Seed, nalgebra::Vector3};
/// # use vc_shapes::{Build, Style};
/// # let style = Style::from_seed(Seed(1));
/// # let mut b = Build::new("thing", Vector3::new(1.0, 1.0, 1.0), &style, Seed(1).stream());
/// use vc_shapes::material::STEEL;
/// use vc_shapes::solid::flat_ring;
/// flat_ring(&mut b, "washer", (0.0, 0.002), (0.005, 0.01), STEEL);
/// assert!((b.finish().1.size().x - 0.02).abs() < 1e-3);
/// ```
pub fn flat_ring(b: &mut Build<'_>, name: &str, z: (f32, f32), (inner, outer): (f32, f32), mat: MaterialId) {
    let profile = [(outer, z.0), (outer, z.1), (inner, z.1), (inner, z.0), (outer, z.0)];
    b.lathe(name, [0.0; 3], &profile, mat);
}
