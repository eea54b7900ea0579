//! The settings of a world.

use serde::{Deserialize, Serialize};
use vc_graph::clock::TICKS_PER_SECOND;

/// Which objects are fixed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[non_exhaustive]
pub enum FixedThings {
    /// The building, things that people neither carry nor move, and furniture of more than [`Settings::heavy`]
    /// kilograms.
    #[default]
    Heavy,
    /// The building, and things that people neither carry nor move.
    Immovable,
    /// Only the building: walls, floors, ceilings, doors, windows. As in the thesis.
    Structure,
}

/// The treatment of a thing without a support in a graph that states the supports of other things.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[non_exhaustive]
pub enum UnsupportedThings {
    /// The thing hangs, as a picture or a wall clock does, and stays until it is taken or pushed off.
    #[default]
    Hangs,
    /// The thing falls.
    Falls,
}

/// The settings by which a [`PhysicsWorld`](crate::PhysicsWorld) is built and stepped.
///
/// ```
/// let settings = vc_physics::Settings { substeps: 2, ..Default::default() };
/// assert_eq!(settings.dt, 1.0 / 60.0);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Settings {
    /// Time of one step, seconds; 1/60 by default.
    pub dt: f32,
    /// Number of engine steps in one step of the world, each of `dt / substeps`; 1 by default.
    pub substeps: u32,
    /// Acceleration of free fall, metres per second squared, downwards; 9.81 by default.
    pub gravity: f32,
    /// Which objects are fixed; [`FixedThings::Heavy`] by default.
    pub fixing: FixedThings,
    /// The mass from which on furniture is heavy, kilograms; 30 by default.
    pub heavy: f32,
    /// Whether things without a support hang or fall; they hang by default.
    pub unplaced: UnsupportedThings,
    /// Friction torque of hinges, newton metres for each kilogram that turns; 0.05 by default.
    pub hinge_friction: f32,
    /// Friction force of slides, newtons for each kilogram that slides; 1 by default.
    pub slide_friction: f32,
    /// Whether doors and lids stay where they are left, as if a spring or a counterweight held them; otherwise
    /// they fall shut or open. They stay by default.
    pub balanced: bool,
    /// Whether closed doors, lids and drawers stay closed until they are opened; they do by default.
    pub latches: bool,
    /// Whether masses outside the range of the node's class are clamped to that range. Assets are often
    /// modelled with too much or too little material. The range grows with the volume of a scaled node;
    /// [`BodyView::modelled_mass`](crate::BodyView::modelled_mass) returns the unclamped mass. They are clamped by default.
    pub class_masses: bool,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            dt: 1.0 / TICKS_PER_SECOND as f32,
            substeps: 1,
            gravity: 9.81,
            fixing: FixedThings::Heavy,
            heavy: 30.0,
            unplaced: UnsupportedThings::Hangs,
            hinge_friction: 0.05,
            slide_friction: 1.0,
            balanced: true,
            latches: true,
            class_masses: true,
        }
    }
}

impl Settings {
    /// The first invalid value.
    pub(crate) fn fault(&self) -> Option<&'static str> {
        let positive = |v: f32| v.is_finite() && v > 0.0;
        let least = |v: f32| v.is_finite() && v >= 0.0;
        let rules = [
            (positive(self.dt) && self.dt <= 0.1, "dt must be above 0 and at most 0.1 s"),
            ((1..=64).contains(&self.substeps), "substeps must be 1 to 64"),
            (self.gravity.is_finite() && self.gravity.abs() <= 1000.0, "gravity must be from -1000 to 1000 m/s^2"),
            (least(self.heavy), "heavy must be finite and not negative"),
            (least(self.hinge_friction) && least(self.slide_friction), "friction must be finite and not negative"),
        ];
        rules.iter().find(|(holds, _)| !holds).map(|(_, rule)| *rule)
    }
}
