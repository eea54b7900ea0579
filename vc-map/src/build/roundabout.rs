//! Mini-roundabouts: the way around their middle, and who goes first there.

use std::cmp::Ordering;
use std::f64::consts::TAU;

use nalgebra::Vector2;
use vc_graph::portable::Portable;

use crate::parts::{Movement, Turn};
use crate::{DrivingSide, Point, Polyline};

/// Arms are cut back by at least this, and vehicles go around the middle at this distance, metres.
pub(super) const CUT: f64 = 9.0;
const RING: f64 = 4.5;
/// The angle between two points of the way, and that between an arm and the ring, radians.
const STEP: f64 = 0.3;
const LEAD: f64 = 0.4;

/// The part of the ring between two points, in the direction of travel.
struct Arc {
    begin: f64,
    sweep: f64,
    sign: f64,
}

fn angle(v: Vector2<f64>) -> f64 {
    v.y.angle_to(v.x)
}

/// An angle as one of a whole turn.
fn whole(angle: f64) -> f64 {
    angle.rem_euclid(TAU)
}

impl Arc {
    fn new(from: Point, to: Point, middle: Point, side: DrivingSide) -> Self {
        let (begin, sign) = (angle(from - middle), side.sign());
        Self { begin, sweep: whole(sign * (angle(to - middle) - begin)), sign }
    }

    /// How far on the entry of another is.
    fn gap(&self, other: &Self) -> f64 {
        whole(self.sign * (other.begin - self.begin))
    }

    fn passes(&self, other: &Self) -> bool {
        self.gap(other) < self.sweep
    }
}

/// The way around the middle; `None` between arms that are so near to each other that it would be one around everything.
pub(super) fn around(from: Point, to: Point, turn: Turn, middle: Point, side: DrivingSide) -> Option<Polyline> {
    let arc = Arc::new(from, to, middle, side);
    if turn != Turn::Back && arc.sweep > TAU - LEAD {
        return None;
    }
    let radius = RING.min((from - middle).norm()).min((to - middle).norm());
    let lead = LEAD.min(arc.sweep / 4.0);
    let steps = ((arc.sweep - 2.0 * lead) / STEP).ceil().max(1.0) as u32;
    let on_ring = (0..=steps).map(|step| {
        let gone = lead + (arc.sweep - 2.0 * lead) * f64::from(step) / f64::from(steps);
        let (sine, cosine) = (arc.begin + arc.sign * gone).sine_cosine();
        middle + Vector2::new(cosine, sine) * radius
    });
    Polyline::new(std::iter::once(from).chain(on_ring).chain([to]))
}

/// The order of two movements: whoever passes the other's arm goes first, or of two who do, who comes to it sooner.
pub(super) fn order(one: &Movement, other: &Movement, middle: Point, side: DrivingSide) -> Ordering {
    let arc = |movement: &Movement| Arc::new(movement.line.start(), movement.line.end(), middle, side);
    let (mine, theirs) = (arc(one), arc(other));
    let sooner = || mine.gap(&theirs).total_cmp(&theirs.gap(&mine));
    theirs.passes(&mine).cmp(&mine.passes(&theirs)).then_with(sooner).then(one.from.cmp(&other.from))
}
