//! Strips along lines on the ground.

use vc_map::{Point, Polyline};
use vc_shapes::Build;
use vc_shapes::material::MaterialId;

use super::Place;
use crate::city::left;

/// A strip of a width along a line, metres, flat at a height.
pub(super) fn strip(
    b: &mut Build<'_>,
    place: &Place,
    line: &[Point],
    (width, z): (f64, f32),
    name: &str,
    material: MaterialId,
) {
    let (mut corners, mut triangles) = (Vec::new(), Vec::new());
    for ends in edges(line, width).windows(2) {
        let first = corners.len() as u32;
        corners.extend([ends[0][1], ends[1][1], ends[1][0], ends[0][0]].map(|at| place.point(&at, z)));
        triangles.extend([[first, first + 1, first + 2], [first, first + 2, first + 3]]);
    }
    if !triangles.is_empty() {
        b.mesh(name, corners, triangles, material);
    }
}

/// Solid pieces of a strip, from a height to another.
pub(super) fn slabs(
    b: &mut Build<'_>,
    place: &Place,
    line: &[Point],
    (width, low, high): (f64, f32, f32),
    name: &str,
    material: MaterialId,
) {
    for ends in edges(line, width).windows(2) {
        let corners = ends.as_flattened().iter().flat_map(|at| [low, high].map(|z| place.point(at, z)));
        b.hull(name, &corners.collect::<Vec<[f32; 3]>>(), material);
    }
}

/// The left and right edges of a strip at each point of its line; bends are mitred.
fn edges(line: &[Point], width: f64) -> Vec<[Point; 2]> {
    let direction = |i: usize| (line[i + 1] - line[i]).try_normalize(1e-9).unwrap_or_default();
    (0..line.len())
        .filter(|_| line.len() > 1)
        .map(|i| {
            let (before, after) =
                (direction(i.saturating_sub(1).min(line.len() - 2)), direction(i.min(line.len() - 2)));
            let mid = (before + after).try_normalize(1e-9).unwrap_or(after);
            let out = left(mid) * (width / 2.0 / mid.dot(&after).max(0.5));
            [line[i] + out, line[i] - out]
        })
        .collect()
}

/// The dashes of a line.
pub(super) fn dashes(line: &[Point], [dash, gap]: [f64; 2]) -> Vec<Vec<Point>> {
    let Some(line) = Polyline::new(line.iter().copied()) else { return Vec::new() };
    let count = ((line.length() + gap) / (dash + gap)).floor().max(0.0) as usize;
    // They lie in the middle of the line.
    let first = (line.length() - (count as f64 * (dash + gap) - gap)) / 2.0;
    let part = |i: usize| {
        let from = first + i as f64 * (dash + gap);
        line.part(from, from + dash).map(|part| part.points().to_vec())
    };
    (0..count).filter_map(part).collect()
}
