//! Parcels: blocks cut until each piece has the size that its buildings need, every one on a street.

use nalgebra::Vector2;
use vc_graph::Seed;

use super::convex::{Beyond, Convex, left};

/// A parcel has at least this length on a street, metres.
const LEAST_FRONT: f64 = 4.5;
/// The most cuts one below the other.
const DEEPEST: u32 = 12;

/// The parcels of a piece of land, with a width along the street and a depth that are aimed at, metres. They tile the land.
pub(super) fn parcels(land: &Convex, [width, depth]: [f64; 2], seed: Seed) -> Vec<Convex> {
    let mut found = Vec::new();
    divide(land.clone(), [width, depth], seed, 0, &mut found);
    found
}

fn divide(piece: Convex, wished: [f64; 2], seed: Seed, level: u32, found: &mut Vec<Convex>) {
    match cut(&piece, wished, seed).filter(|_| level < DEEPEST) {
        Some(parts) => {
            for (index, part) in parts.into_iter().enumerate() {
                divide(part, wished, seed.nth(index as u64), level + 1, found);
            }
        }
        None => found.push(piece),
    }
}

/// A piece in two: back to back if it is deep, else side by side.
fn cut(piece: &Convex, [width, depth]: [f64; 2], seed: Seed) -> Option<[Convex; 2]> {
    let (a, b, _) = piece.longest(|beyond| matches!(beyond, Beyond::Street(_)))?;
    let along = (b - a).normalize();
    let ratios = [piece.length(&along) / width, piece.length(&left(along)) / depth];
    let deep = ratios[1] > 1.5 && ratios[1] * depth > 0.6 * ratios[0] * width;
    let mut stream = seed.stream();
    let mut side_by_side = || {
        let pieces = ratios[0].round();
        let jitter = f64::from(stream.between(-0.12, 0.12)) / pieces.max(1.0);
        (ratios[0] > 1.4).then(|| part(piece, &along, (pieces / 2.0).floor() / pieces + jitter)).flatten()
    };
    if deep {
        return part(piece, &left(along), 0.5).or_else(side_by_side);
    }
    side_by_side().or_else(|| (ratios[1] > 1.5).then(|| part(piece, &left(along), 0.5)).flatten())
}

/// The parts before and behind a share of a piece's length along a direction, if both are on a street.
fn part(piece: &Convex, along: &Vector2<f64>, share: f64) -> Option<[Convex; 2]> {
    let [low, high] = piece.extent(along);
    let middle = piece.middle();
    let through = middle + along * (low + (high - low) * share - middle.coords.dot(along));
    let parts = piece.split(&through, &left(*along), Beyond::Neighbour)?;
    parts.iter().all(fits).then_some(parts)
}

fn fits(part: &Convex) -> bool {
    let front = part.longest(|beyond| matches!(beyond, Beyond::Street(_)));
    front.is_some_and(|(a, b, _)| (b - a).norm() >= LEAST_FRONT) && part.area() > 40.0
}
