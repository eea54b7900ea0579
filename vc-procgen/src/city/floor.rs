//! Floors of wings: a stair in the middle, a corridor behind the units or between them, and units side by side.

use nalgebra::Vector2;

use super::convex::{Beyond, Convex, left};

/// The width of a core with stair and lift, and of a corridor, metres.
const CORE: f64 = 3.2;
const CORRIDOR: f64 = 1.6;
/// A wing that is deeper has units on both sides of its corridor, metres.
const DEEP: f64 = 14.5;
/// A unit is at least this wide, metres.
const LEAST: f64 = 2.6;
/// A unit has at least this length of facade, metres.
const FACADE: f64 = 2.4;

/// The floor of a wing.
pub(super) struct Floor {
    /// Stair and lift, and on the ground the hall to the street.
    pub(super) core: Option<Convex>,
    /// Its units, from left to right as seen from its main side, those at the front first.
    pub(super) units: Vec<Convex>,
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
    let depth = plan.length(&left(along));
    let between = |from: f64, to: f64, part: &Convex| slice(part, &along, from, to);
    let middle = (low + high) / 2.0;
    let core = [middle - CORE / 2.0, middle + CORE / 2.0];
    let bands = if depth > DEEP {
        let [near, far] = [(depth - CORRIDOR) / 2.0, (depth + CORRIDOR) / 2.0];
        [band(plan, main, 0.0, near), band(plan, main, far, depth)]
    } else {
        [band(plan, main, 0.0, depth - CORRIDOR), None]
    };
    let mut units = Vec::new();
    for part in bands.iter().flatten() {
        for [from, to] in [[low, core[0]], [core[1], high]] {
            let count = ((to - from) / width).round().max(1.0);
            let step = (to - from) / count;
            let pieces = (0..count as usize).map(|i| [from + step * i as f64, from + step * (i + 1) as f64]);
            units.extend(pieces.filter(|_| step > LEAST).filter_map(|[from, to]| between(from, to, part)));
        }
    }
    // A space without a facade is no room for anybody: stores, bicycles, plant.
    units.retain(|unit: &Convex| unit.sides().any(|(a, b, beyond)| beyond.is_open() && (b - a).norm() > FACADE));
    let core = bands[0].as_ref().and_then(|front| between(core[0], core[1], front));
    Floor { core, units }
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
