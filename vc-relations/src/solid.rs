//! Convex solids in the world, and separating-axis tests between two of them.

use nalgebra::{Matrix3, Vector3};
use vc_geometry::order::{greater, lesser};
use vc_graph::Aabb;

use crate::threshold::{BALL_SPOT, TRACE_SHRINK, UPRIGHT};

/// Shape of a solid within its box.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) enum Round {
    /// A box.
    #[default]
    No,
    /// A cylinder along the third axis, with an elliptic base.
    Turned,
    /// An ellipsoid.
    Ball,
}

/// A box, cylinder or ellipsoid in the world, metres.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Solid {
    pub(crate) centre: Vector3<f32>,
    /// Its own axes, of unit length, as columns.
    pub(crate) axes: Matrix3<f32>,
    pub(crate) half: Vector3<f32>,
    pub(crate) round: Round,
    /// Whether the third axis is vertical, which leaves fewer possible separating axes. A box's axes are
    /// reordered so that this holds if any of them is vertical.
    pub(crate) upright: bool,
    pub(crate) low: Vector3<f32>,
    pub(crate) high: Vector3<f32>,
}

impl Solid {
    pub(crate) fn new(centre: Vector3<f32>, axes: Matrix3<f32>, half: Vector3<f32>, round: Round) -> Self {
        let is_vertical = |axis: usize| axes[(2, axis)].abs() > 1.0 - 1e-6;
        let (axes, half) = match round {
            Round::No if is_vertical(0) => (turned_on(&axes, [1, 2, 0]), half.yzx()),
            Round::No if is_vertical(1) => (turned_on(&axes, [2, 0, 1]), half.zxy()),
            _ => (axes, half),
        };
        let upright = axes[(2, 2)].abs() > 1.0 - 1e-6;
        let mut solid = Self { centre, axes, half, round, upright, low: centre, high: centre };
        let reach = solid.box_reach();
        (solid.low, solid.high) = (centre - reach, centre + reach);
        solid
    }

    fn box_reach(&self) -> Vector3<f32> {
        match self.round {
            Round::No => self.axes.abs() * self.half,
            _ => Vector3::new(self.reach(&Vector3::x()), self.reach(&Vector3::y()), self.reach(&Vector3::z())),
        }
    }

    pub(crate) fn region(&self) -> Aabb {
        Aabb { min: self.low.into(), max: self.high.into() }
    }

    /// Whether its world-aligned box is within a margin of a region, metres.
    #[inline]
    pub(crate) fn meets(&self, region: &Aabb, margin: f32) -> bool {
        (0..3).all(|k| self.low[k] <= region.max[k] + margin && self.high[k] + margin >= region.min[k])
    }

    /// Half extent along a direction of unit length.
    #[inline]
    pub(crate) fn reach(&self, along: &Vector3<f32>) -> f32 {
        let own = self.axes.tr_mul(along).component_mul(&self.half);
        match self.round {
            Round::No => own.x.abs() + own.y.abs() + own.z.abs(),
            Round::Turned => own.xy().norm() + own.z.abs(),
            Round::Ball => own.norm(),
        }
    }

    /// Half extents of the two horizontal axes of an upright solid along a horizontal direction.
    #[inline]
    fn level(&self, along: &Vector3<f32>) -> (f32, f32) {
        let x = (self.axes[(0, 0)] * along.x + self.axes[(1, 0)] * along.y) * self.half.x;
        let y = (self.axes[(0, 1)] * along.x + self.axes[(1, 1)] * along.y) * self.half.y;
        (x, y)
    }

    /// Whether its outline is the same at every height.
    #[inline]
    pub(crate) fn is_prism(&self) -> bool {
        self.upright && self.round != Round::Ball
    }

    /// Vertical gap between two upright prisms, negative if they overlap.
    #[inline]
    pub(crate) fn rise(&self, other: &Self) -> f32 {
        (other.centre.z - self.centre.z).abs() - self.half.z - other.half.z
    }

    /// Gap between the outlines of two upright prisms; see [`gap`].
    #[inline]
    pub(crate) fn level_gap(&self, other: &Self, enough: f32) -> f32 {
        level_gap(self, other, enough)
    }

    /// The point of its box nearest to a point.
    pub(crate) fn nearest(&self, point: &Vector3<f32>) -> Vector3<f32> {
        let own = self.axes.tr_mul(&(point - self.centre));
        self.centre + self.axes * own.zip_map(&self.half, |at, half| lesser(greater(at, -half), half))
    }

    /// Whether a segment from a point crosses its box, by the parameters at which it enters and leaves each
    /// pair of faces.
    pub(crate) fn is_crossed(&self, from: &Vector3<f32>, way: &Vector3<f32>) -> bool {
        let (at, way) = (self.axes.tr_mul(&(from - self.centre)), self.axes.tr_mul(way));
        let (mut enters, mut leaves) = (0.0_f32, 1.0_f32);
        for axis in 0..3 {
            let (at, way, half) = (at[axis], way[axis], self.half[axis]);
            if way.abs() > 1e-9 {
                let (one, other) = ((-half - at) / way, (half - at) / way);
                enters = greater(enters, lesser(one, other));
                leaves = lesser(leaves, greater(one, other));
            } else if at.abs() > half {
                return false;
            }
        }
        enters <= leaves
    }

    /// The eight corners of the box, scaled to a share of the half size.
    pub(crate) fn corners(&self, share: f32) -> [Vector3<f32>; 8] {
        let half = self.half * share;
        let own = Aabb { min: (-half).into(), max: half.into() };
        own.corners().map(|corner| self.centre + self.axes * corner.coords)
    }

    /// The shape swept by a vertical trace: the middle plane if the solid is nearly upright, otherwise the
    /// solid a little shrunk.
    pub(crate) fn core(&self) -> Self {
        let vertical = self.axes.row(2).abs().transpose().imax();
        let flat = self.axes[(2, vertical)].abs() >= UPRIGHT;
        let spot = if self.round == Round::Ball { BALL_SPOT } else { 1.0 };
        let mut half = self.half.map(|h| (h - TRACE_SHRINK.min(h / 2.0)) * spot);
        if flat {
            half[vertical] = 0.0;
        }
        Self::new(self.centre, self.axes, half, self.round)
    }

    pub(crate) fn moved(mut self, by: Vector3<f32>) -> Self {
        self.centre += by;
        self.low += by;
        self.high += by;
        self
    }
}

/// The same axes in another order.
fn turned_on(axes: &Matrix3<f32>, order: [usize; 3]) -> Matrix3<f32> {
    Matrix3::from_columns(&order.map(|axis| axes.column(axis)))
}

/// The hit of a trace.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Strike {
    /// Distance that the trace went, metres; negative if the two overlapped at the start.
    pub(crate) way: f32,
    /// Unit normal of the contact, towards the traced solid.
    pub(crate) normal: Vector3<f32>,
}

/// Calls `visit` with directions, at least one of which separates the two if they are apart. Exact for two
/// boxes (Gottschalk, Lin and Manocha 1996), for upright cylinders with boxes and with each other, and for
/// balls; otherwise distances come out a little too small.
#[inline]
fn each_axis(a: &Solid, b: &Solid, mut visit: impl FnMut(Vector3<f32>) -> bool) -> bool {
    let both_upright = a.upright && b.upright;
    if both_upright {
        if !visit(Vector3::z()) {
            return false;
        }
        for solid in [a, b] {
            if !visit(solid.axes.column(0).into()) || !visit(solid.axes.column(1).into()) {
                return false;
            }
        }
    } else {
        for i in 0..3 {
            if !visit(a.axes.column(i).into()) || !visit(b.axes.column(i).into()) {
                return false;
            }
        }
        for i in 0..9 {
            let cross = a.axes.column(i / 3).cross(&b.axes.column(i % 3));
            let length = cross.norm_squared();
            if length > 1e-6 && !visit(cross / length.sqrt()) {
                return false;
            }
        }
    }
    (a.round == Round::No && b.round == Round::No) || round_axes(a, b, visit)
}

/// The directions in which curved sides are nearest to the other solid.
fn round_axes(a: &Solid, b: &Solid, mut visit: impl FnMut(Vector3<f32>) -> bool) -> bool {
    let mut toward = |round: &Solid, other: &Solid| {
        let goal = if other.round == Round::No { other.nearest(&round.centre) } else { other.centre };
        let mut way = goal - round.centre;
        if round.round == Round::Turned {
            let axis = round.axes.column(2);
            way -= axis * axis.dot(&way);
        }
        let length = way.norm();
        length < 1e-6 || visit(way / length)
    };
    (a.round == Round::No || toward(a, b)) && (b.round == Round::No || toward(b, a))
}

/// Gap between the outlines of two upright prisms; see [`gap`].
#[inline]
fn level_gap(a: &Solid, b: &Solid, enough: f32) -> f32 {
    let way = b.centre - a.centre;
    let reach = |s: &Solid, axis: &Vector3<f32>| match (s.round, s.level(axis)) {
        (Round::No, (x, y)) => x.abs() + y.abs(),
        (_, (x, y)) => (x * x + y * y).sqrt(),
    };
    let mut most = f32::NEG_INFINITY;
    let mut visit = |axis: Vector3<f32>| {
        most = greater(most, (way.x * axis.x + way.y * axis.y).abs() - reach(a, &axis) - reach(b, &axis));
        most <= enough
    };
    let faces = |s: &Solid, i: usize| s.axes.column(i).into();
    let near =
        visit(faces(a, 0)) && visit(faces(a, 1)) && (a.axes == b.axes || (visit(faces(b, 0)) && visit(faces(b, 1))));
    if near && (a.round != Round::No || b.round != Round::No) {
        round_axes(a, b, visit);
    }
    most
}

/// Gap between two solids along the direction that separates them most; negative if they overlap. The search
/// stops once the gap exceeds `enough`.
pub(crate) fn gap(a: &Solid, b: &Solid, enough: f32) -> f32 {
    let way = b.centre - a.centre;
    if a.is_prism() && b.is_prism() {
        let rise = a.rise(b);
        return if rise > enough { rise } else { greater(rise, level_gap(a, b, enough)) };
    }
    let mut most = f32::NEG_INFINITY;
    each_axis(a, b, |axis| {
        most = greater(most, way.dot(&axis).abs() - a.reach(&axis) - b.reach(&axis));
        most <= enough
    });
    most
}

/// [`sweep`] straight up (1) or down (-1); upright prisms collide if their outlines overlap.
#[inline]
pub(crate) fn sweep_upright(a: &Solid, b: &Solid, up: f32, limit: f32) -> Option<Strike> {
    let along = Vector3::z() * up;
    if !a.is_prism() || !b.is_prism() {
        return sweep(a, b, &along, limit);
    }
    let (way, reach) = ((b.centre.z - a.centre.z) * up, a.half.z + b.half.z);
    let meets = way - reach <= limit && way + reach >= 0.0 && level_gap(a, b, 0.0) <= 0.0;
    meets.then_some(Strike { way: way - reach, normal: -along })
}

/// Moves `a` in a direction of unit length until it hits `b`. Exact for boxes, by the intervals in which each
/// axis does not separate them. `None` if it passes by, if `b` lies behind, or beyond `limit` metres.
pub(crate) fn sweep(a: &Solid, b: &Solid, along: &Vector3<f32>, limit: f32) -> Option<Strike> {
    let way = b.centre - a.centre;
    let mut strike = Strike { way: f32::NEG_INFINITY, normal: -along };
    let mut leaves = f32::INFINITY;
    let meets = each_axis(a, b, |axis| {
        let (distance, speed) = (way.dot(&axis), along.dot(&axis));
        let reach = a.reach(&axis) + b.reach(&axis);
        if speed.abs() < 1e-6 {
            return distance.abs() <= reach;
        }
        let (distance, speed, axis) = if speed < 0.0 { (-distance, -speed, -axis) } else { (distance, speed, axis) };
        let enters = (distance - reach) / speed;
        leaves = lesser(leaves, (distance + reach) / speed);
        if enters > strike.way {
            strike = Strike { way: enters, normal: -axis };
        }
        strike.way <= leaves && strike.way <= limit && leaves >= 0.0
    });
    meets.then_some(strike)
}
