//! Floors of wings: a stair in the middle, a corridor behind the units or between them, and units side by side.

use nalgebra::{Point2, Vector2};

use super::convex::{Beyond, Convex, left};

/// The width of a core with stair and lift, and of a corridor, metres.
pub(crate) const CORE: f64 = 4.0;
pub(crate) const CORRIDOR: f64 = 1.6;
/// A wing that is deeper has units on both sides of its corridor, metres.
const DEEP: f64 = 14.5;
/// A unit is at least this wide, metres.
const LEAST: f64 = 2.6;
/// Corners nearer to a side than this are on it, metres.
const SAME: f64 = 1e-3;
/// A unit has at least this length of facade, metres.
const FACADE: f64 = 2.4;

/// The floor of a wing.
pub(super) struct Floor {
    /// Stair and lift, and on the ground the hall to the street.
    pub(super) core: Option<Convex>,
    /// Its units, from left to right as seen from its main side, those at the front first.
    pub(super) units: Vec<Convex>,
}

/// Where stair, lift and corridor of a wing are.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Core {
    /// The middle of the core at the main side.
    pub(crate) at: Point2<f64>,
    /// The direction of the main side, the wing on its left.
    pub(crate) along: Vector2<f64>,
    /// The distance from the main side to the corridor, metres.
    pub(crate) depth: f64,
    /// Where the corridor begins and ends along the main side, metres from the middle of the core.
    pub(crate) corridor: [f64; 2],
    /// Whether there are units on both sides of it.
    pub(crate) is_between: bool,
}

impl Core {
    /// That of a wing with a main side.
    pub(crate) fn of(plan: &Convex) -> Option<Self> {
        let main = main_side(plan)?;
        let along = (main.1 - main.0).normalize();
        let (across, middle) = (left(along), plan.extent(&along).iter().sum::<f64>() / 2.0);
        let whole = plan.length(&across);
        let is_between = whole > DEEP;
        let depth = if is_between { (whole - CORRIDOR) / 2.0 } else { whole - CORRIDOR };
        // As wide as it is at both of its sides.
        let [[low, high], [from, to]] =
            [depth, depth + CORRIDOR - SAME].map(|deep| chord(plan, &along, main.0.coords.dot(&across) + deep));
        let corridor = [low.max(from) - middle, high.min(to) - middle];
        let at = main.0 + along * (middle - main.0.coords.dot(&along));
        Some(Self { at, along, depth, corridor, is_between })
    }
}

/// The stations between which a line across a plan is in it; the first is greater if it is nowhere.
fn chord(plan: &Convex, along: &Vector2<f64>, at: f64) -> [f64; 2] {
    let across = left(*along);
    let crossing = |(a, b, _): (Point2<f64>, Point2<f64>, Beyond)| {
        let [from, to] = [a, b].map(|corner| corner.coords.dot(&across) - at);
        let share = (from * to <= 0.0 && from != to).then(|| from / (from - to))?;
        Some((a + (b - a) * share).coords.dot(along))
    };
    let ends = plan.sides().filter_map(crossing);
    ends.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], station| [low.min(station), high.max(station)])
}

/// The main side of a wing: its longest to a street, else to a court.
pub(super) fn main_side(plan: &Convex) -> Option<(nalgebra::Point2<f64>, nalgebra::Point2<f64>, Beyond)> {
    plan.longest(|beyond| matches!(beyond, Beyond::Street(_))).or_else(|| plan.longest(Beyond::is_open))
}

/// Divides a floor into units of a width in metres.
pub(super) fn floor(plan: &Convex, width: f64) -> Floor {
    let Some(main) = main_side(plan) else { return Floor { core: None, units: vec![plan.clone()] } };
    let along = (main.1 - main.0).normalize();
    let [low, high] = plan.extent(&along);
    let whole = plan.length(&left(along));
    let between = |from: f64, to: f64, part: &Convex| slice(part, &along, from, to);
    let middle = (low + high) / 2.0;
    let core = [middle - CORE / 2.0, middle + CORE / 2.0];
    let bands = if whole > DEEP {
        let [near, far] = [(whole - CORRIDOR) / 2.0, (whole + CORRIDOR) / 2.0];
        [band(plan, main, 0.0, near), band(plan, main, far, whole)]
    } else {
        [band(plan, main, 0.0, whole - CORRIDOR), None]
    };
    let mut units = Vec::new();
    for part in bands.iter().flatten() {
        // Units are equally wide where the band is a rectangle; what is beyond its ends goes to those at the ends.
        let [first, last] = straight(part, &along);
        for ([from, to], [begin, end]) in [([first, core[0]], [low, core[0]]), ([core[1], last], [core[1], high])] {
            let count = ((to - from) / width).round().max(1.0);
            let step = (to - from) / count;
            let at = |i: usize| match i {
                0 => begin,
                _ if i == count as usize => end,
                _ => from + step * i as f64,
            };
            let pieces = (0..count as usize).map(|i| [at(i), at(i + 1)]);
            units.extend(pieces.filter(|_| step > LEAST).filter_map(|[from, to]| between(from, to, part)));
        }
    }
    // A space without a facade is no room for anybody: stores, bicycles, plant.
    units.retain(|unit: &Convex| unit.sides().any(|(a, b, beyond)| beyond.is_open() && (b - a).norm() > FACADE));
    let core = bands[0].as_ref().and_then(|front| between(core[0], core[1], front));
    Floor { core, units }
}

/// The stations between which a band is a rectangle: those that both of its long sides have, or all if there are none.
fn straight(part: &Convex, along: &Vector2<f64>) -> [f64; 2] {
    let across = left(*along);
    let whole = part.extent(along);
    let shared = part.extent(&across).into_iter().fold(whole, |[low, high], edge| {
        let on = |corner: &&nalgebra::Point2<f64>| (corner.coords.dot(&across) - edge).abs() < SAME;
        let stations = || part.corners().iter().filter(on).map(|corner| corner.coords.dot(along));
        [stations().fold(f64::INFINITY, f64::min).max(low), stations().fold(f64::NEG_INFINITY, f64::max).min(high)]
    });
    if shared[1] - shared[0] > LEAST { shared } else { whole }
}

/// The part of a wing between two distances from its main side.
fn band(
    plan: &Convex,
    main: (nalgebra::Point2<f64>, nalgebra::Point2<f64>, Beyond),
    from: f64,
    to: f64,
) -> Option<Convex> {
    let along = (main.1 - main.0).normalize();
    let near =
        if from > 0.0 { plan.cut(&(main.0 + left(along) * from), &along, Beyond::Inside)? } else { plan.clone() };
    near.cut(&(main.0 + left(along) * to), &-along, Beyond::Inside)
}

/// The part between two stations along a direction.
fn slice(part: &Convex, along: &Vector2<f64>, from: f64, to: f64) -> Option<Convex> {
    let [low, high] = part.extent(along);
    let at = |station: f64| nalgebra::Point2::from(along * station);
    let part = if from > low + 1e-6 { part.cut(&at(from), &-left(*along), Beyond::Inside)? } else { part.clone() };
    if to < high - 1e-6 { part.cut(&at(to), &left(*along), Beyond::Inside) } else { Some(part) }
}
