//! Fronts of case furniture: doors, flaps, headboards.

use crate::material::{BLACK, GLASS, MIRROR, MaterialId};
use crate::solid::{Axis, Build, P};

/// The design of a front.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::object) enum Front {
    /// A plain board.
    Flat,
    /// A frame around a recessed panel.
    Framed,
    /// A frame around glass.
    Glass,
    /// A board with a mirror on it.
    Mirror,
    /// A frame with slanting slats.
    Louvred,
    /// Upright strips on a board.
    Reeded,
    /// Sheet metal with rows of slots.
    Vented,
}

impl Front {
    /// Draws a design of solid fronts.
    pub(in crate::object) fn any(b: &mut Build<'_>) -> Self {
        b.choose(&[Self::Flat, Self::Flat, Self::Framed, Self::Framed, Self::Reeded])
    }
}

/// A front between two corners, facing X.
pub(in crate::object) fn front_panel(b: &mut Build<'_>, name: &str, low: P, high: P, design: Front, mat: MaterialId) {
    let (wide, tall, thick) = (high[1] - low[1], high[2] - low[2], high[0] - low[0]);
    let w = 0.055_f32.min(wide.min(tall) * 0.22);
    let inner = |x0: f32, x1: f32| ([x0, low[1] + w, low[2] + w], [x1, high[1] - w, high[2] - w]);
    match design {
        Front::Flat => b.block(name, low, high, mat),
        Front::Framed => {
            frame(b, name, low, high, w, mat);
            let (l, h) = inner(low[0] + 0.001, high[0] - thick * 0.4);
            b.block("panel", l, h, mat);
        }
        Front::Glass => {
            frame(b, name, low, high, w, mat);
            let (l, h) = inner(low[0] + thick * 0.4, low[0] + thick * 0.7);
            b.block("pane", l, h, GLASS);
        }
        Front::Mirror => {
            let face = high[0] - thick * 0.2;
            b.block(name, low, [face, high[1], high[2]], mat);
            let rim = 0.01_f32.min(w);
            b.block("mirror", [face, low[1] + rim, low[2] + rim], [high[0], high[1] - rim, high[2] - rim], MIRROR);
        }
        Front::Louvred => {
            frame(b, name, low, high, w, mat);
            // A thin panel behind the slats hides the contents.
            let (l, h) = inner(low[0] + 0.001, low[0] + thick * 0.2);
            b.block("panel", l, h, mat);
            let count = ((tall - 2.0 * w) / 0.055).clamp(2.0, 14.0) as usize;
            let pitch = (tall - 2.0 * w) / count as f32;
            for i in 0..count {
                let z = low[2] + w + pitch * i as f32;
                let (x0, x1) = (low[0] + thick * 0.2 - 0.0005, high[0] - 0.002);
                let outline = [(x0, z + pitch * 0.55), (x1, z), (x1, z + pitch * 0.4), (x0, z + pitch * 0.95)];
                b.prism("slat", Axis::Y, [0.0, low[1] + w, 0.0], &outline, wide - 2.0 * w, mat);
            }
        }
        Front::Vented => {
            let face = high[0] - 0.001;
            b.block(name, low, [face, high[1], high[2]], mat);
            for (i, end) in (0..4).flat_map(|i| [(i, high[2] - w), (i, low[2] + w + 0.06)]) {
                let z = end - 0.018 * i as f32;
                b.block(
                    "vent",
                    [face - 0.002, low[1] + wide * 0.3, z - 0.006],
                    [high[0], high[1] - wide * 0.3, z],
                    BLACK,
                );
            }
        }
        Front::Reeded => {
            let face = high[0] - thick * 0.4;
            b.block(name, low, [face, high[1], high[2]], mat);
            let count = (wide / 0.045).clamp(3.0, 14.0) as usize;
            let pitch = wide / count as f32;
            for i in 0..count {
                let y = low[1] + pitch * i as f32;
                b.block("reed", [face, y + pitch * 0.2, low[2]], [high[0], y + pitch * 0.8, high[2]], mat);
            }
        }
    }
}

/// Four boards around a rectangle, `w` wide.
pub(in crate::object) fn frame(b: &mut Build<'_>, name: &str, low: P, high: P, w: f32, mat: MaterialId) {
    b.block(name, low, [high[0], low[1] + w, high[2]], mat);
    b.block(name, [low[0], high[1] - w, low[2]], high, mat);
    b.block(name, [low[0], low[1] + w, low[2]], [high[0], high[1] - w, low[2] + w], mat);
    b.block(name, [low[0], low[1] + w, high[2] - w], [high[0], high[1] - w, high[2]], mat);
}
