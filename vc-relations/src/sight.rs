//! Facing: agents and seats that look at things.

use vc_graph::portable::Portable;

use crate::body::Body;
use crate::explanation::{Sight, TraceOutcome};
use crate::threshold::{FACING_COSINE, FACING_REACH};
use crate::walls::Walls;

/// Agents and seats face things; all others have a front but do not look anywhere.
pub(crate) fn can_face(body: &Body) -> bool {
    body.traits.agent || body.traits.sittable
}

/// Whether a body faces another, or why it does not.
pub(crate) fn outcome(body: &Body, target: &Body, walls: &Walls) -> TraceOutcome {
    let front = Front::new(body, target);
    if !can_face(body) || !target.traits.lookable {
        TraceOutcome::Unfit
    } else if front.far > FACING_REACH || !body.region.grown(FACING_REACH, FACING_REACH).meets(&target.region) {
        TraceOutcome::TooFar
    } else if !front.is_towards() {
        TraceOutcome::Aside
    } else if walls.between(body, target) {
        TraceOutcome::Walled
    } else {
        TraceOutcome::Counts
    }
}

/// The verdict with its figures.
pub(crate) fn sight(body: &Body, target: &Body, walls: &Walls) -> Sight {
    let front = Front::new(body, target);
    Sight { angle: front.angle(), distance: front.far, outcome: outcome(body, target, walls) }
}

/// The direction to another thing and a body's front, in plan.
struct Front {
    /// Dot product of the two, and the perpendicular component times the length of the front.
    along: f32,
    across: f32,
    /// Length of the direction, metres, and of the front, which is less than one if it is tilted.
    far: f32,
    length: f32,
}

impl Front {
    fn new(body: &Body, target: &Body) -> Self {
        let way = (target.whole.centre - body.whole.centre).xy();
        let front = body.heading.column(0).xy();
        Self { along: way.dot(&front), across: front.perp(&way), far: way.norm(), length: front.norm() }
    }

    /// Whether the front has a horizontal component.
    fn is_level(&self) -> bool {
        self.length > 1e-3
    }

    fn is_towards(&self) -> bool {
        self.is_level() && self.along >= FACING_COSINE * self.far * self.length
    }

    fn angle(&self) -> f32 {
        if self.is_level() { self.across.abs().angle_to(self.along) } else { std::f32::consts::PI }
    }
}
