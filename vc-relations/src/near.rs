//! Distance between two boxes, and the sides of each other at which they are.

use nalgebra::{Matrix2, Vector2, Vector3};
use vc_geometry::order::{greater, lesser};
use vc_graph::Relation;

use crate::body::Body;
use crate::distance::distance;
use crate::solid::Solid;
use crate::threshold::{NEAR_REACH, SIDE_SHARE, TRACE_START};

/// A side of a thing, by its own axes: X is front, Y is left.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum NearSide {
    /// Towards its +X.
    Front,
    /// Towards its -X.
    Back,
    /// Towards its +Y.
    Left,
    /// Towards its -Y.
    Right,
}

impl NearSide {
    /// The relation of being near at this side.
    pub(crate) fn relation(self) -> Relation {
        match self {
            Self::Front => Relation::NearFront,
            Self::Back => Relation::NearBack,
            Self::Left => Relation::NearLeft,
            Self::Right => Relation::NearRight,
        }
    }
}

/// Two boxes within reach of each other.
pub(crate) struct Beside {
    /// Metres.
    pub(crate) distance: f32,
    /// The side of the first at which the second is, and the side of the second at which the first is.
    pub(crate) sides: [Option<NearSide>; 2],
}

/// Measures the boxes of two bodies; `None` if they are too far apart.
pub(crate) fn beside(a: &Body, b: &Body) -> Option<Beside> {
    let rise = greater(a.whole.low.z - b.whole.high.z, b.whole.low.z - a.whole.high.z);
    let plan = (a.whole.upright && b.whole.upright).then(|| Plan::new(&a.whole, &b.whole));
    let distance = match &plan {
        Some(plan) => {
            let up = greater(rise, 0.0);
            (up * up + plan.distance_squared(&a.whole, &b.whole)).sqrt()
        }
        None => distance(&a.whole, &b.whole),
    };
    let seen = match plan {
        Some(plan) if a.level && b.level => plan.seen,
        _ => [Seen::turned(a, b), Seen::turned(b, a)],
    };
    (distance <= NEAR_REACH).then(|| Beside { distance, sides: [seen[0].side(rise), seen[1].side(rise)] })
}

/// Another box in a box's own X and Y: the position of its centre, and the sum of the half extents of the two,
/// metres.
#[derive(Clone, Copy)]
struct Seen {
    at: Vector2<f32>,
    reach: Vector2<f32>,
}

impl Seen {
    fn turned(a: &Body, b: &Body) -> Self {
        let axis = |i: usize| -> Vector3<f32> { a.heading.column(i).into() };
        let way = b.whole.centre - a.whole.centre;
        let reach = |i: usize| a.whole.reach(&axis(i)) + b.whole.reach(&axis(i));
        Self { at: Vector2::new(way.dot(&axis(0)), way.dot(&axis(1))), reach: Vector2::new(reach(0), reach(1)) }
    }

    fn gaps(&self) -> Vector2<f32> {
        self.at.abs() - self.reach
    }

    /// The side at which the other is: the one along which they are farthest apart; if they overlap, the one
    /// towards which its centre is displaced. None if it is above or below rather than beside.
    fn side(&self, rise: f32) -> Option<NearSide> {
        let gaps = self.gaps();
        let apart = greater(gaps.x, gaps.y);
        if rise > greater(apart, -TRACE_START) {
            return None;
        }
        let share = |i: usize| self.at[i].abs() / greater(self.reach[i], 1e-6);
        let along_x = if apart > 0.0 { gaps.x >= gaps.y } else { share(0) >= share(1) };
        let axis = usize::from(!along_x);
        let side = match (along_x, self.at[axis] >= 0.0) {
            (true, true) => NearSide::Front,
            (true, false) => NearSide::Back,
            (false, true) => NearSide::Left,
            (false, false) => NearSide::Right,
        };
        (share(axis) >= SIDE_SHARE).then_some(side)
    }
}

/// Two upright boxes in plan view.
struct Plan {
    seen: [Seen; 2],
    /// The second's axes relative to the first's.
    turn: Matrix2<f32>,
}

impl Plan {
    fn new(a: &Solid, b: &Solid) -> Self {
        let axes = |s: &Solid| Matrix2::new(s.axes[(0, 0)], s.axes[(0, 1)], s.axes[(1, 0)], s.axes[(1, 1)]);
        let (a_axes, b_axes) = (axes(a), axes(b));
        let turn = a_axes.tr_mul(&b_axes);
        let way = (b.centre - a.centre).xy();
        let (a_half, b_half, share) = (a.half.xy(), b.half.xy(), turn.abs());
        let first = Seen { at: a_axes.tr_mul(&way), reach: a_half + share * b_half };
        let second = Seen { at: b_axes.tr_mul(&-way), reach: b_half + share.tr_mul(&a_half) };
        Self { seen: [first, second], turn }
    }

    /// Squared distance between the two footprints.
    fn distance_squared(&self, a: &Solid, b: &Solid) -> f32 {
        let [first, second] = self.seen.map(|s| s.gaps().map(|gap| greater(gap, 0.0)));
        let cosine = self.turn[(0, 0)].abs();
        if !(1e-4..=0.999_999).contains(&cosine) {
            return first.norm_squared();
        }
        if first.x + first.y + second.x + second.y == 0.0 {
            return 0.0;
        }
        // For rotated rectangles the distance is that of a corner of one from the other.
        let back = self.turn.transpose();
        lesser(corner_distance(&self.seen[0], &self.turn, b, a), corner_distance(&self.seen[1], &back, a, b))
    }
}

/// Squared least distance of a footprint's corners from the footprint that `seen` refers to.
fn corner_distance(seen: &Seen, turn: &Matrix2<f32>, corners_of: &Solid, from: &Solid) -> f32 {
    let (x, y) = (turn.column(0) * corners_of.half.x, turn.column(1) * corners_of.half.y);
    let outside = |p: Vector2<f32>| (p.abs() - from.half.xy()).map(|gap| greater(gap, 0.0)).norm_squared();
    let squared = [x + y, x - y, -x + y, -x - y].map(|c| outside(seen.at + c));
    squared.into_iter().fold(f32::INFINITY, lesser)
}
