//! Parks: paths from gates to the middle, and what lies between them.

use vc_graph::Seed;
use vc_map::Point;

use super::convex::{Beyond, Convex, left};

/// The width of a path, metres.
const PATH: f64 = 3.0;
/// The distance of features from paths and streets, metres.
const CLEAR: f64 = 4.0;
/// A basketball court with the ground around it, and a playground: sides in metres.
const COURT: [f64; 2] = [32.0, 19.0];
const PLAYGROUND: [f64; 2] = [22.0, 14.0];
/// The share of a lawn's size that a pond has.
const POND: f64 = 0.62;
/// Trees stand about this far apart, metres.
const TREES: f64 = 9.0;

/// Something in a park.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum ParkFeature {
    /// Water with a bank.
    Pond,
    /// A fenced ground with swings and slides.
    Playground,
    /// A court for basketball.
    Court,
}

/// A park, which is a whole block.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Park {
    /// Its block, by its position in [`CityPlan::blocks`](super::CityPlan::blocks).
    pub block: usize,
    /// Where its paths begin, on the building line of a street.
    pub gates: Vec<Point>,
    /// Its middle, where its paths meet.
    pub middle: Point,
    /// The width of its paths, metres.
    pub path: f64,
    /// The things in it, with their outlines, counter-clockwise.
    pub features: Vec<(ParkFeature, Vec<Point>)>,
    /// Its trees.
    pub trees: Vec<Point>,
}

pub(super) fn park(block: usize, land: &Convex, seed: Seed) -> Park {
    let middle = land.middle();
    let gates: Vec<(usize, Point)> = land
        .sides()
        .enumerate()
        .filter(|(_, (a, b, _))| (b - a).norm() > 24.0)
        .map(|(side, (a, b, _))| (side, nalgebra::center(&a, &b)))
        .collect();
    let mut lawns: Vec<Convex> =
        (0..gates.len()).filter_map(|i| lawn(land, middle, gates[i], gates[(i + 1) % gates.len()])).collect();
    lawns.sort_by(|a, b| b.area().total_cmp(&a.area()));
    let mut features = Vec::new();
    let mut wanted = vec![ParkFeature::Court, ParkFeature::Playground, ParkFeature::Pond];
    seed.child("order").stream().shuffle(&mut wanted[1..]);
    for lawn in &lawns {
        if let Some(place) = (0..wanted.len()).find(|i| feature(wanted[*i], lawn).is_some()) {
            let kind = wanted.remove(place);
            features.extend(feature(kind, lawn).map(|ring| (kind, ring)));
        }
    }
    let trees = trees(&lawns, &features, seed);
    Park { block, gates: gates.into_iter().map(|(_, gate)| gate).collect(), middle, path: PATH, features, trees }
}

/// The lawn between two paths: from the middle to a gate, along the edge, and back; clear of all.
fn lawn(land: &Convex, middle: Point, from: (usize, Point), to: (usize, Point)) -> Option<Convex> {
    let part = land.cut(&middle, &(from.1 - middle).normalize(), Beyond::Court)?;
    let part = part.cut(&middle, &(middle - to.1).normalize(), Beyond::Court)?;
    part.inset(None, |beyond| if beyond == Beyond::Court { PATH / 2.0 + CLEAR } else { CLEAR })
}

/// The outline of a feature on a lawn, if there is room for it.
fn feature(kind: ParkFeature, lawn: &Convex) -> Option<Vec<Point>> {
    match kind {
        ParkFeature::Pond => {
            let middle = lawn.middle();
            let small = lawn.corners().iter().map(|corner| middle + (corner - middle) * POND).collect();
            let pond = Convex::new(small, vec![Beyond::Court; lawn.corners().len()]);
            (pond.area() > 150.0).then(|| pond.rounded(|_| 14.0))
        }
        ParkFeature::Court => rectangle(lawn, COURT),
        ParkFeature::Playground => rectangle(lawn, PLAYGROUND),
    }
}

/// A rectangle about the middle of a lawn, along its longest side, if it fits.
fn rectangle(lawn: &Convex, [long, short]: [f64; 2]) -> Option<Vec<Point>> {
    let (a, b, _) = lawn.longest(|_| true)?;
    let along = (b - a).normalize();
    let (u, v) = (along * (long / 2.0), left(along) * (short / 2.0));
    let middle = lawn.middle();
    let ring = vec![middle - u - v, middle + u - v, middle + u + v, middle - u + v];
    ring.iter().all(|corner| lawn.contains(corner, 0.0)).then_some(ring)
}

/// Trees on lawns, clear of features.
fn trees(lawns: &[Convex], features: &[(ParkFeature, Vec<Point>)], seed: Seed) -> Vec<Point> {
    let rings: Vec<Convex> =
        features.iter().map(|(_, ring)| Convex::new(ring.clone(), vec![Beyond::Court; ring.len()])).collect();
    let mut found = Vec::new();
    for (index, lawn) in lawns.iter().enumerate() {
        let mut stream = seed.child("trees").nth(index as u64).stream();
        let [[left, right], [low, high]] =
            [nalgebra::Vector2::x(), nalgebra::Vector2::y()].map(|axis| lawn.extent(&axis));
        let cells = |from: f64, to: f64| ((to - from) / TREES) as usize + 1;
        for (x, y) in (0..cells(left, right)).flat_map(|x| (0..cells(low, high)).map(move |y| (x, y))) {
            let mut place = |i: usize| (i as f64 + f64::from(stream.between(0.2, 0.8))) * TREES;
            let at = Point::new(left + place(x), low + place(y));
            let free = rings.iter().all(|ring| ring.distance(&at) > 2.5);
            if stream.chance(0.75) && lawn.contains(&at, 0.5) && free {
                found.push(at);
            }
        }
    }
    found
}
