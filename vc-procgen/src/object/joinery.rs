//! What cabinet makers build everything from: carcasses, doors, drawers, legs and
//! handles. Used by furniture, kitchens and bathrooms alike.

use super::build::{Build, P};
use crate::material::Mat;

/// Thickness of boards, metres.
pub(super) const BOARD: f32 = 0.018;

/// Gap between fronts, metres.
pub(super) const GAP: f32 = 0.003;

/// Kinds of handle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Handle {
    /// A bar on two posts.
    Bar,
    /// A round knob.
    Knob,
    /// None: the front is gripped at its edge or pushed.
    None,
}

impl Handle {
    pub(super) fn any(b: &mut Build<'_>) -> Self {
        b.one(&[Self::Bar, Self::Bar, Self::Knob, Self::None])
    }

    /// How far it stands out, metres.
    pub(super) fn depth(self) -> f32 {
        match self {
            Self::Bar => 0.03,
            Self::Knob => 0.025,
            Self::None => 0.0,
        }
    }
}

/// A handle in front of a plane at `x`, centred at (`y`, `z`), `length` long,
/// upright or level.
pub(super) fn handle(b: &mut Build<'_>, kind: Handle, at: P, length: f32, upright: bool, mat: Mat) {
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

/// Which way a door's hinge is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Side {
    /// At the higher Y: the left one of somebody inside looking out.
    Left,
    /// At the lower Y.
    Right,
}

/// A drawer that fills the space `low..high`: its front at the high X, its tray
/// behind; it slides out by three quarters of its depth.
pub(super) fn drawer(b: &mut Build<'_>, name: &str, low: P, high: P, kind: Handle, mats: (Mat, Mat, Mat)) {
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

fn shrunk(low: P, high: P) -> (P, P) {
    let g = GAP / 2.0;
    ([low[0], low[1] + g, low[2] + g], [high[0], high[1] - g, high[2] - g])
}
