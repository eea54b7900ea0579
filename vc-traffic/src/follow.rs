//! Car following: the intelligent driver model (Treiber, Hennecke and Helbing, Physical Review E 62, 2000).

use crate::VehicleClass;

/// Nobody brakes harder, metres per second squared.
pub(crate) const HARDEST: f32 = 9.0;

/// A driver's numbers, ready for the formula.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Driver {
    pub(crate) time_gap: f32,
    pub(crate) standing_gap: f32,
    pub(crate) acceleration: f32,
    pub(crate) deceleration: f32,
    /// One over twice the root of acceleration times deceleration.
    pub(crate) brake: f32,
    pub(crate) length: f32,
}

impl Driver {
    pub(crate) fn new(class: &VehicleClass) -> Self {
        Self {
            time_gap: class.time_gap,
            standing_gap: class.standing_gap,
            acceleration: class.acceleration,
            deceleration: class.deceleration,
            brake: 0.5 / (class.acceleration * class.deceleration).sqrt(),
            length: class.length,
        }
    }

    /// The acceleration on a free road towards a desired speed.
    pub(crate) fn free(&self, speed: f32, desired: f32) -> f32 {
        let share = speed / desired;
        let square = share * share;
        (self.acceleration * (1.0 - square * square)).max(-self.deceleration)
    }

    /// By how much somebody ahead lowers it: at a gap in metres, who is slower by so many metres per second.
    pub(crate) fn behind(&self, speed: f32, gap: f32, slower: f32) -> f32 {
        let wanted = self.standing_gap + (speed * (self.time_gap + slower * self.brake)).max(0.0);
        let share = wanted / gap.max(0.05);
        self.acceleration * share * share
    }

    /// The gap that it keeps to somebody who stands, at which it begins to brake, metres.
    pub(crate) fn sight(&self, speed: f32) -> f32 {
        self.standing_gap + speed * (self.time_gap + speed * self.brake)
    }

    /// The way that it needs to stop in comfort, metres.
    pub(crate) fn stopping(&self, speed: f32) -> f32 {
        speed * speed / (2.0 * self.deceleration)
    }
}
