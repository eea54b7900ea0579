//! Handles of doors and drawers.

use crate::material::MaterialId;
use crate::solid::{Build, P};

/// The kinds of handle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::object) enum Handle {
    /// A bar on two posts.
    Bar,
    /// A round knob.
    Knob,
    /// No handle: the front is gripped at its edge or pushed.
    None,
}

impl Handle {
    pub(in crate::object) fn any(b: &mut Build<'_>) -> Self {
        b.choose(&[Self::Bar, Self::Bar, Self::Knob, Self::None])
    }

    /// How far it protrudes, metres.
    pub(in crate::object) fn depth(self) -> f32 {
        match self {
            Self::Bar => 0.03,
            Self::Knob => 0.025,
            Self::None => 0.0,
        }
    }
}

/// A handle in front of a plane at `x`, centred at (`y`, `z`), `length` long, upright or level.
pub(in crate::object) fn handle(b: &mut Build<'_>, kind: Handle, at: P, length: f32, upright: bool, mat: MaterialId) {
    let [x, y, z] = at;
    match kind {
        Handle::None => {}
        Handle::Knob => {
            b.rod("knob", [x, y, z], [x + 0.012, y, z], 0.006, mat);
            b.ball("knob", [x + 0.014, y, z], 0.011, mat);
        }
        Handle::Bar => {
            let half = length / 2.0;
            let (dy, dz) = if upright { (0.0, half) } else { (half, 0.0) };
            for side in [-0.8, 0.8] {
                let (py, pz) = (y + dy * side, z + dz * side);
                b.rod("handle", [x, py, pz], [x + 0.022, py, pz], 0.004, mat);
            }
            b.rod("handle", [x + 0.024, y - dy, z - dz], [x + 0.024, y + dy, z + dz], 0.006, mat);
        }
    }
}
