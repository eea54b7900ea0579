//! Coincident faces: faces of two parts in the same plane that face the same way and overlap, so
//! that the visible one would be arbitrary.

use std::collections::HashMap;

use crate::cases::{Case, Rule};
use crate::solid::{P, Solid, V};

/// The distance below which planes count as the same, metres; a fifth of the object's thickness
/// where that is less.
const SAME: f64 = 2e-4;

struct Face<'a> {
    at: &'a [P; 3],
    normal: V,
}

pub(crate) fn check(case: &Case, say: &mut dyn FnMut(Rule, String)) {
    let faces: Vec<_> = case.solids.iter().map(by_normal).collect();
    let same = SAME.min(f64::from(case.object.size().min()) * 0.2);
    for (j, other) in case.solids.iter().enumerate() {
        for (i, solid) in case.solids[..j].iter().enumerate().filter(|(_, s)| s.gap(other) <= same) {
            // Two bars of a pipe share the sphere at its bend.
            let joint = solid.round && other.round && solid.material == other.material;
            let found = if joint { None } else { shared(&faces[i], &faces[j], (solid, other), case, same) };
            if let Some((at, normal)) = found {
                let alike = if solid.material == other.material { " of the same material" } else { "" };
                let (at, way) = (rounded(at.coords), rounded(normal));
                say(
                    Rule::Faces,
                    format!("{} and {}{alike} share a plane at {at} facing {way}", solid.name, other.name),
                );
            }
        }
    }
}

fn rounded(v: V) -> String {
    format!("({:.3}, {:.3}, {:.3})", v.x, v.y, v.z)
}

type Faces<'a> = HashMap<[i32; 3], Vec<Face<'a>>>;

/// The triangles, grouped by rounded normal.
fn by_normal(solid: &Solid) -> Faces<'_> {
    let mut faces = Faces::new();
    for at in &solid.triangles {
        let Some(normal) = (at[1] - at[0]).cross(&(at[2] - at[0])).try_normalize(1e-12) else { continue };
        let key = <[f64; 3]>::from(normal).map(|v| (v * 64.0).round() as i32);
        faces.entry(key).or_default().push(Face { at, normal });
    }
    faces
}

/// A point where two parts share a plane and nothing else covers it.
fn shared(a: &Faces<'_>, b: &Faces<'_>, pair: (&Solid, &Solid), case: &Case, same: f64) -> Option<(P, V)> {
    let mut keys: Vec<_> = a.keys().filter(|k| b.contains_key(*k)).collect();
    keys.sort();
    for key in keys {
        let reaches = |face: &&Face<'_>, s: &Solid| {
            let (low, high) =
                (face.at[0].inf(&face.at[1]).inf(&face.at[2]), face.at[0].sup(&face.at[1]).sup(&face.at[2]));
            (0..3).all(|k| low[k] <= s.high[k] + same && high[k] >= s.low[k] - same)
        };
        let others: Vec<_> = b[key].iter().filter(|f| reaches(f, pair.0)).collect();
        for (f, g) in a[key].iter().filter(|f| reaches(f, pair.1)).flat_map(|f| others.iter().map(move |g| (f, *g))) {
            let Some(middle) = overlap(f, g, same) else { continue };
            let normal = f.normal;
            let underneath = normal.z < -0.999 && middle.z < 1e-3 && pair.0.material == pair.1.material;
            let above = middle + normal * 3.0 * same;
            let covered = case.solids.iter().any(|s| s.contains(&above));
            if !underneath && !covered {
                return Some((middle, normal));
            }
        }
    }
    None
}

/// The centre of the overlap of two triangles, if they are in one plane and the overlap is wider
/// than a hair.
fn overlap(f: &Face<'_>, g: &Face<'_>, same: f64) -> Option<P> {
    let distance = |p: &P| (p - f.at[0]).dot(&f.normal);
    if f.normal.dot(&g.normal) < 0.9999 || g.at.iter().all(|p| distance(p).abs() > same) {
        return None;
    }
    let mut shape: Vec<P> = g.at.to_vec();
    for k in 0..3 {
        let (from, to) = (f.at[k], f.at[(k + 1) % 3]);
        let inwards = f.normal.cross(&(to - from));
        shape = clipped(&shape, |p| (p - from).dot(&inwards));
    }
    let first = *shape.first()?;
    let middle = first + shape.iter().map(|p| p - first).sum::<V>() / shape.len() as f64;
    let next = || shape.iter().zip(shape.iter().cycle().skip(1));
    let area = next().map(|(p, q)| (p - first).cross(&(q - first))).sum::<V>().norm() / 2.0;
    let around: f64 = next().map(|(p, q)| (q - p).norm()).sum();
    let wide = area > 1e-6 && 2.0 * area / around > 3e-4;
    (wide && distance(&middle).abs() <= same).then_some(middle)
}

/// The part of a convex shape where `side` is not negative (Sutherland and Hodgman).
fn clipped(shape: &[P], side: impl Fn(&P) -> f64) -> Vec<P> {
    let mut kept = Vec::with_capacity(shape.len() + 1);
    for (p, q) in shape.iter().zip(shape.iter().cycle().skip(1)) {
        let (a, b) = (side(p), side(q));
        if a >= 0.0 {
            kept.push(*p);
        }
        if (a < 0.0) != (b < 0.0) {
            kept.push(p + (q - p) * (a / (a - b)));
        }
    }
    kept
}
