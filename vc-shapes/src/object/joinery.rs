//! Cabinet-making elements: doors, drawers, legs and handles, used by furniture, kitchens and
//! bathrooms alike.

use std::f32::consts::FRAC_PI_2;

use crate::material::MaterialId;
use crate::solid::{Build, CORNERS, P};

/// The thickness of boards, metres.
pub(super) const BOARD: f32 = 0.018;

/// The gap between fronts, metres.
pub(super) const GAP: f32 = 0.003;

/// The kinds of handle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Handle {
    /// A bar on two posts.
    Bar,
    /// A round knob.
    Knob,
    /// No handle: the front is gripped at its edge or pushed.
    None,
}

impl Handle {
    pub(super) fn any(b: &mut Build<'_>) -> Self {
        b.choose(&[Self::Bar, Self::Bar, Self::Knob, Self::None])
    }

    /// How far it protrudes, metres.
    pub(super) fn depth(self) -> f32 {
        match self {
            Self::Bar => 0.03,
            Self::Knob => 0.025,
            Self::None => 0.0,
        }
    }
}

/// A handle in front of a plane at `x`, centred at (`y`, `z`), `length` long, upright or level.
pub(super) fn handle(b: &mut Build<'_>, kind: Handle, at: P, length: f32, upright: bool, mat: MaterialId) {
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

/// The side of a door's hinge.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Side {
    /// At the higher Y: on the left, seen from inside.
    Left,
    /// At the lower Y.
    Right,
}

/// A hinged front that fills the rectangle `low..high` (its thickness along X) with a gap around
/// it; it opens outwards by up to about 100 degrees.
pub(super) fn door(
    b: &mut Build<'_>,
    name: &str,
    low: P,
    high: P,
    side: Side,
    kind: Handle,
    mats: (MaterialId, MaterialId),
) {
    let (low, high) = shrunk(low, high);
    let (hinge, grip, turn) = match side {
        Side::Left => (high[1], low[1] + 0.04, 1.0),
        Side::Right => (low[1], high[1] - 0.04, -1.0),
    };
    let anchor = [high[0], hinge, low[2]];
    b.hinge(anchor, [0.0, 0.0, turn], FRAC_PI_2 * 1.1, |b| {
        b.block(name, low, high, mats.0);
        let tall = high[2] - low[2];
        let length = (tall * 0.35).min(0.16);
        // Low units have the handle at the top, high ones at the bottom, tall ones in the middle.
        let z = if tall > 1.1 {
            f32::midpoint(low[2], high[2])
        } else if low[2] > 1.2 {
            low[2] + length * 0.5 + 0.04
        } else {
            high[2] - length * 0.5 - 0.04
        };
        handle(b, kind, [high[0], grip, z], length, true, mats.1);
    });
}

/// A drawer that fills the space `low..high`: its front at the high X, its tray behind; it slides
/// out by three quarters of its depth.
pub(super) fn drawer(
    b: &mut Build<'_>,
    name: &str,
    low: P,
    high: P,
    kind: Handle,
    mats: (MaterialId, MaterialId, MaterialId),
) {
    let (front, tray, metal) = mats;
    let (fl, fh) = shrunk([high[0] - BOARD, low[1], low[2]], high);
    let t = 0.012;
    let (x0, x1) = (low[0] + 0.02, high[0] - BOARD);
    let (y0, y1) = (low[1] + 0.022, high[1] - 0.022);
    let (z0, z1) = (low[2] + 0.012, high[2] - 0.03);
    b.slide([1.0, 0.0, 0.0], (x1 - x0) * 0.75, |b| {
        b.block(name, fl, fh, front);
        b.block("tray", [x0, y0, z0], [x1, y1, z0 + t], tray);
        b.block("tray", [x0, y0, z0 + t], [x1, y0 + t, z1], tray);
        b.block("tray", [x0, y1 - t, z0 + t], [x1, y1, z1], tray);
        b.block("tray", [x0, y0 + t, z0 + t], [x0 + t, y1 - t, z1], tray);
        let length = ((fh[1] - fl[1]) * 0.4).min(0.2);
        handle(b, kind, [fh[0], f32::midpoint(fl[1], fh[1]), f32::midpoint(fl[2], fh[2])], length, false, metal);
        let centre = [(x0 + t + x1) / 2.0, (y0 + y1) / 2.0, z0 + t];
        let half = ((x1 - x0 - t) / 2.0 - 0.005, (y1 - y0) / 2.0 - t - 0.005);
        b.inside(name, centre, half, (high[2] - z0 - t - 0.02).max(0.0));
    });
}

/// Four straight legs under a rectangle of half lengths `half`, from the floor to `height`, square
/// or round, inside the edges.
pub(super) fn legs(b: &mut Build<'_>, half: (f32, f32), height: f32, thickness: f32, round: bool, mat: MaterialId) {
    let (x, y) = (half.0 - thickness / 2.0, half.1 - thickness / 2.0);
    let r = thickness / 2.0;
    for (sx, sy) in CORNERS {
        let (cx, cy) = (sx * x, sy * y);
        if round {
            b.lathe("leg", [cx, cy, 0.0], &[(r * 0.7, 0.0), (r, height * 0.9), (r, height)], mat);
        } else {
            b.block("leg", [cx - r, cy - r, 0.0], [cx + r, cy + r, height], mat);
        }
    }
}

fn shrunk(low: P, high: P) -> (P, P) {
    let g = GAP / 2.0;
    ([low[0], low[1] + g, low[2] + g], [high[0], high[1] - g, high[2] - g])
}
