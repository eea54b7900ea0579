//! Concave shapes as convex pieces: the fewest that keep hollows hollow and top surfaces in place, not a
//! faithful approximation.

use nalgebra::{Matrix3, Point3, Vector3};
use vc_geometry::order::{greater, lesser};
use vc_graph::portable::Portable;

use crate::solid::Round;
use crate::threshold::{AXIS_HOLE, COLUMNS, FULL_MESH, SLICES, STAVES, THIN_SLICE};

/// Extra width around a triangle, in columns, for the search of columns below or above it.
const BESIDE: f32 = 0.01;

type Put<'a> = &'a mut dyn FnMut(Vector3<f32>, Matrix3<f32>, Vector3<f32>, Round);

/// A lathe shape: discs where it is solid, rings of staves where it is hollow.
pub(crate) fn lathe(profile: &[(f32, f32)], put: Put<'_>) {
    for (low, high) in slices(profile.iter().map(|p| p.1)) {
        let (centre, half) = (f32::midpoint(low, high), (high - low) / 2.0);
        let cuts = crossings(profile, centre);
        let Some(&outer) = cuts.last() else { continue };
        // The profile is closed to the axis by flat discs: an odd number of crossings means a solid middle.
        let inner = if cuts.len() % 2 == 1 { 0.0 } else { cuts[0] };
        let at = Vector3::z() * centre;
        if inner < AXIS_HOLE * outer {
            put(at, Matrix3::identity(), Vector3::new(outer, outer, half), Round::Turned);
        } else {
            ring(at, inner, outer, half, put);
        }
    }
}

fn ring(at: Vector3<f32>, inner: f32, outer: f32, half: f32, put: Put<'_>) {
    let (middle, thick) = (f32::midpoint(inner, outer), (outer - inner) / 2.0);
    let long = outer * (std::f32::consts::PI / STAVES as f32).tangent();
    for stave in 0..STAVES {
        let (sin, cos) = (std::f32::consts::TAU * stave as f32 / STAVES as f32).sine_cosine();
        let axes = Matrix3::new(cos, -sin, 0.0, sin, cos, 0.0, 0.0, 0.0, 1.0);
        put(at + Vector3::new(cos, sin, 0.0) * middle, axes, Vector3::new(thick, long, half), Round::No);
    }
}

/// Heights at which a shape is sliced: its own levels, thinned out where there are many.
fn slices(levels: impl Iterator<Item = f32>) -> Vec<(f32, f32)> {
    let mut levels: Vec<f32> = levels.collect();
    levels.sort_by(f32::total_cmp);
    let Some((&low, &high)) = levels.first().zip(levels.last()) else { return Vec::new() };
    let least = (high - low) * THIN_SLICE;
    levels.dedup_by(|b, a| *b - *a < least);
    thin_out(&mut levels, SLICES + 1);
    levels.windows(2).map(|w| (w[0], w[1])).collect()
}

/// The crossings of a horizontal line at `height` with a path, whose second coordinate is the height.
fn crossings(path: &[(f32, f32)], height: f32) -> Vec<f32> {
    let edges = path.windows(2).map(|w| (w[0], w[1]));
    let mut cuts: Vec<f32> = edges.filter_map(|(a, b)| crossing(a, b, height)).collect();
    cuts.sort_by(f32::total_cmp);
    cuts
}

fn crossing(a: (f32, f32), b: (f32, f32), height: f32) -> Option<f32> {
    let crosses = (a.1 <= height) != (b.1 <= height);
    crosses.then(|| a.0 + (b.0 - a.0) * (height - a.1) / (b.1 - a.1))
}

/// An extruded outline as boxes over slices of the outline; exact for right-angled ones.
pub(crate) fn extrusion(outline: &[(f32, f32)], height: f32, put: Put<'_>) {
    let mut closed = outline.to_vec();
    closed.extend(outline.first());
    for (low, high) in slices(outline.iter().map(|p| p.1)) {
        let cuts = crossings(&closed, f32::midpoint(low, high));
        for pair in cuts.chunks_exact(2) {
            let centre = Vector3::new(f32::midpoint(pair[0], pair[1]), f32::midpoint(low, high), height / 2.0);
            let half = Vector3::new(pair[1] - pair[0], high - low, height) / 2.0;
            put(centre, Matrix3::identity(), half, Round::No);
        }
    }
}

/// A mesh as its box if it nearly fills that, otherwise as columns over a grid.
pub(crate) fn mesh(vertices: &[Point3<f32>], triangles: &[[u32; 3]], put: Put<'_>) {
    let Some(first) = vertices.first() else { return };
    let (low, high) = vertices.iter().fold((*first, *first), |(l, h), v| (l.inf(v), h.sup(v)));
    let size = high - low;
    let whole = |put: Put<'_>| put((low.coords + high.coords) / 2.0, Matrix3::identity(), size / 2.0, Round::No);
    let corner = |i: u32| vertices.get(i as usize).copied();
    let mut corners: Vec<[Point3<f32>; 3]> = Vec::with_capacity(triangles.len());
    corners.extend(triangles.iter().filter_map(|t| Some([corner(t[0])?, corner(t[1])?, corner(t[2])?])));
    let volume: f32 = corners.iter().map(|[a, b, c]| (a - low).dot(&(b - low).cross(&(c - low))) / 6.0).sum();
    if corners.is_empty() || volume.abs() > FULL_MESH * size.x * size.y * size.z {
        return whole(put);
    }
    let step = Vector3::new(size.x, size.y, 0.0) / COLUMNS as f32;
    let middle = |cell: usize| {
        low.coords
            + Vector3::new((cell % COLUMNS) as f32 + 0.5, (cell / COLUMNS) as f32 + 0.5, 0.0).component_mul(&step)
    };
    let mut found = false;
    let crossings = crossings_of_columns(&corners, &low, &step, middle);
    for column in crossings.chunk_by(|a, b| a.0 == b.0) {
        let at = middle(column[0].0);
        for (bottom, top) in column.chunks_exact(2).map(|p| (p[0].1, p[1].1)).filter(|(a, b)| b > a) {
            found = true;
            let centre = Vector3::new(at.x, at.y, f32::midpoint(bottom, top));
            put(centre, Matrix3::identity(), Vector3::new(step.x, step.y, top - bottom) / 2.0, Round::No);
        }
    }
    if !found {
        whole(put);
    }
}

/// Heights at which the vertical lines through the centres of all columns cross a mesh, by column and from
/// below. Each triangle is tested only against columns within its bounding box.
fn crossings_of_columns(
    corners: &[[Point3<f32>; 3]],
    low: &Point3<f32>,
    step: &Vector3<f32>,
    middle: impl Fn(usize) -> Vector3<f32>,
) -> Vec<(usize, f32)> {
    let mut found = Vec::with_capacity(4 * COLUMNS * COLUMNS);
    let per = step.map(|s| 1.0 / s.max(f32::MIN_POSITIVE));
    for triangle in corners {
        // The column centres within its bounds, and a little more to allow for rounding.
        let range = |axis: usize| {
            let [a, b, c] = triangle.map(|p| (p[axis] - low[axis]) * per[axis]);
            let first = (lesser(lesser(a, b), c) + (0.5 - BESIDE)).max(0.0) as usize;
            first..((greater(greater(a, b), c) + (0.5 + BESIDE)) as usize).min(COLUMNS)
        };
        let columns = range(0);
        if columns.is_empty() {
            continue;
        }
        for row in range(1) {
            for cell in columns.clone().map(|column| row * COLUMNS + column) {
                let at = middle(cell);
                found.extend(height_over(triangle, at.x, at.y).map(|height| (cell, height)));
            }
        }
    }
    found.sort_unstable_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
    found
}

fn height_over([a, b, c]: &[Point3<f32>; 3], x: f32, y: f32) -> Option<f32> {
    let cross = |p: &Point3<f32>, q: &Point3<f32>| (p.x - x) * (q.y - y) - (q.x - x) * (p.y - y);
    let (u, v, w) = (cross(b, c), cross(c, a), cross(a, b));
    let sum = u + v + w;
    let within = (u >= 0.0) == (v >= 0.0) && (v >= 0.0) == (w >= 0.0) && sum.abs() > 0.0;
    within.then(|| (u * a.z + v * b.z + w * c.z) / sum)
}

/// Removes planes where they are densest until at most `most` are left; both ends stay.
pub(crate) fn thin_out(planes: &mut Vec<f32>, most: usize) {
    while planes.len() > most.max(2) {
        let width = |i: &usize| planes[i + 1] - planes[i - 1];
        let densest = (1..planes.len() - 1).min_by(|i, j| width(i).total_cmp(&width(j)));
        planes.remove(densest.unwrap_or(1));
    }
}
