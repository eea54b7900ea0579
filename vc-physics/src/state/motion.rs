//! The motion of an agent's legs.

use nalgebra::{Point2, Vector2};
use serde::{Deserialize, Serialize};

/// Distance at which a waypoint counts as reached, metres.
const THERE: f32 = 0.03;

/// Number of steps without progress after which a walk is given up.
const PATIENCE: u32 = 90;

/// The smallest motion that counts as progress, metres per step.
const PROGRESS: f32 = 0.001;

/// The motion of an agent's legs.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) enum Motion {
    #[default]
    Still,
    /// At a velocity over the floor.
    Going([f32; 2]),
    /// Along points, the next one first, at a speed.
    Along {
        points: Vec<[f32; 2]>,
        next: usize,
        speed: f32,
        idle: u32,
    },
    Stuck,
    /// At a velocity ahead and to the left, turning at a rate, radians per second.
    Drifting {
        velocity: [f32; 2],
        spin: f32,
    },
}

impl Motion {
    /// The velocity that the motion asks for.
    pub(crate) fn wish(&self, at: Point2<f32>, dt: f32) -> Vector2<f32> {
        match self {
            Self::Still | Self::Stuck | Self::Drifting { .. } => Vector2::zeros(),
            Self::Going(v) => Vector2::new(v[0], v[1]),
            Self::Along { points, next, speed, .. } => {
                let Some(to) = points.get(*next) else { return Vector2::zeros() };
                let way = Point2::from(*to) - at;
                let last = *next + 1 == points.len();
                let fast = if last { speed.min(way.norm() / dt) } else { *speed };
                way.try_normalize(1e-6).map_or_else(Vector2::zeros, |d| d * fast)
            }
        }
    }

    /// The velocity that the motion asks for, ahead and to the left, and the turn in a step, radians.
    pub(crate) fn drift(&self, dt: f32) -> Option<(Vector2<f32>, f32)> {
        match self {
            Self::Drifting { velocity, spin } => Some(((*velocity).into(), spin * dt)),
            _ => None,
        }
    }

    /// Whether the body turns to where it goes.
    pub(crate) fn is_ahead(&self) -> bool {
        !matches!(self, Self::Drifting { .. })
    }

    /// Continues after a step to a point: on to the next waypoint, or the end.
    pub(crate) fn advance(&mut self, at: Point2<f32>, moved: f32) {
        let Self::Along { points, next, idle, .. } = self else { return };
        while points.get(*next).is_some_and(|p| (Point2::from(*p) - at).norm() <= THERE) {
            *next += 1;
        }
        *idle = if moved < PROGRESS { *idle + 1 } else { 0 };
        if *next >= points.len() {
            *self = Self::Still;
        } else if *idle > PATIENCE {
            *self = Self::Stuck;
        }
    }
}
