//! Fronts, doors and drawers of fitted units and appliances: kitchens, bathrooms, fridges. Dimensions scale with the
//! unit.

use std::f32::consts::FRAC_PI_2;

use vc_graph::asset::JointKind;

use super::door::opposite;
use super::{Handle, Swing, gapped, handle, swing};
use crate::material::{GLASS, MaterialId, WHITE};
use crate::solid::{Build, P, basket, plate_with_border};

/// The design of a unit's fronts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::object) enum Panel {
    /// Flat.
    Slab,
    /// A frame around a recessed panel.
    Framed,
    /// Boards side by side.
    Boards,
    /// A frame around glass.
    Glazed,
}

/// The common properties of all fronts of a unit.
#[derive(Debug, Clone, Copy)]
pub(in crate::object) struct Fitted {
    /// The design of fronts.
    pub(in crate::object) panel: Panel,
    /// The kind of handle.
    pub(in crate::object) handle: Handle,
    /// The material of fronts.
    pub(in crate::object) mat: MaterialId,
    /// The material of handles.
    pub(in crate::object) metal: MaterialId,
    /// The thickness of fronts and boards.
    pub(in crate::object) t: f32,
}

impl Fitted {
    /// Properties drawn from the style: fronts of `mat`, boards `t` thick.
    pub(in crate::object) fn any(b: &mut Build<'_>, mat: MaterialId, t: f32) -> Self {
        let panel = b.choose(&[Panel::Slab, Panel::Slab, Panel::Framed, Panel::Framed, Panel::Boards]);
        Self { panel, handle: Handle::any(b), mat, metal: b.style.metal, t }
    }

    /// How far handles protrude from the front.
    pub(in crate::object) fn grip(&self) -> f32 {
        self.handle.depth()
    }

    /// A handle on the plane at X, scaled to the front.
    fn grip_at(&self, b: &mut Build<'_>, at: P, length: f32, upright: bool) {
        // Posts start inside the front, because its panel may be recessed there.
        let into = if self.panel == Panel::Slab { 0.0 } else { self.t * 0.36 };
        handle(b, self.handle, [at[0] - into, at[1], at[2]], length, upright, self.metal);
    }
}

/// A front of the rectangle `low..high`.
pub(in crate::object) fn panel(b: &mut Build<'_>, how: Panel, name: &str, (low, high): (P, P), mat: MaterialId) {
    let t = high[0] - low[0];
    let (width, tall) = (high[1] - low[1], high[2] - low[2]);
    let w = (width.min(tall) * 0.28).min(0.07);
    let back = [high[0] - t * 0.35, high[1], high[2]];
    match how {
        Panel::Slab => b.block(name, low, high, mat),
        Panel::Framed | Panel::Glazed => {
            plate_with_border(b, name, low, high, w, mat);
            let (glass, depth) = if how == Panel::Glazed { (GLASS, 0.6) } else { (mat, 0.3) };
            let from = [low[0] + t * 0.2, low[1] + w, low[2] + w];
            b.block("infill", from, [high[0] - t * depth, high[1] - w, high[2] - w], glass);
        }
        Panel::Boards => {
            b.block(name, low, back, mat);
            let count = (width / 0.09).clamp(2.0, 8.0).round();
            let step = width / count;
            for i in 0..count as usize {
                let y = low[1] + step * i as f32;
                b.block("board", [back[0], y + step * 0.03, low[2]], [high[0], y + step * 0.97, high[2]], mat);
            }
        }
    }
}

/// A hinged front with its handle that fills `low..high` except for a gap.
pub(in crate::object) fn cupboard_door(
    b: &mut Build<'_>,
    look: &Fitted,
    name: &str,
    (low, high): (P, P),
    at: Swing,
    high_up: bool,
) {
    let (low, high) = gapped(low, high, look.t * 0.08);
    let grip = opposite(at, (low, high), (high[1] - low[1]) * 0.1);
    let tall = high[2] - low[2];
    let length = (tall * 0.35).min(0.16);
    let z = match (tall > 1.1, high_up) {
        (true, _) => f32::midpoint(low[2], high[2]),
        (_, true) => low[2] + length * 0.5 + tall * 0.06,
        _ => high[2] - length * 0.5 - tall * 0.06,
    };
    swing(b, at, low, high, FRAC_PI_2 * 1.1, |b| {
        panel(b, look.panel, name, (low, high), look.mat);
        look.grip_at(b, [high[0], grip, z], length, true);
    });
}

/// One door, or two where one would be wider than `widest`.
pub(in crate::object) fn cupboard_doors(
    b: &mut Build<'_>,
    look: &Fitted,
    (low, high): (P, P),
    widest: f32,
    high_up: bool,
) {
    if high[1] - low[1] <= widest {
        let at = b.choose(&[Swing::Left, Swing::Right]);
        cupboard_door(b, look, "door", (low, high), at, high_up);
    } else {
        let middle = f32::midpoint(low[1], high[1]);
        cupboard_door(b, look, "door_right", (low, [high[0], middle, high[2]]), Swing::Right, high_up);
        cupboard_door(b, look, "door_left", ([low[0], middle, low[2]], high), Swing::Left, high_up);
    }
}

/// A drawer in the space `low..high` between boards: front, tray and surface inside.
pub(in crate::object) fn pull_out(b: &mut Build<'_>, look: &Fitted, name: &str, (low, high): (P, P)) {
    let t = look.t;
    let (from, to) = gapped([high[0] - t, low[1], low[2]], high, t * 0.08);
    let depth = high[0] - t - low[0];
    // Its own anchor distinguishes its joint from that of the drawer below.
    b.jointed(JointKind::Slide, low, [1.0, 0.0, 0.0], (0.0, depth * 0.72), |b| {
        panel(b, look.panel, name, (from, to), look.mat);
        let length = ((to[1] - from[1]) * 0.4).min(0.2);
        look.grip_at(b, [to[0], f32::midpoint(to[1], from[1]), f32::midpoint(to[2], from[2])], length, false);
        let tall = high[2] - low[2];
        let tray = [low[0] + depth * 0.05, low[1] + t * 1.2, low[2] + tall * 0.06];
        let rim = [high[0] - t, high[1] - t * 1.2, low[2] + tall * 0.8];
        basket(b, name, tray, rim, t * 0.6, WHITE);
    });
}

/// Drawers one above the other, the lowest `deep` times as tall as the others.
pub(in crate::object) fn drawers(
    b: &mut Build<'_>,
    look: &Fitted,
    name: &str,
    (low, high): (P, P),
    (count, deep): (usize, f32),
) {
    let share = (high[2] - low[2]) / (count.max(1) as f32 - 1.0 + deep);
    let mut z = low[2];
    for i in 0..count.max(1) {
        let tall = if i == 0 { share * deep } else { share };
        let space = ([low[0], low[1], z], [high[0], high[1], z + tall]);
        pull_out(b, look, &format!("{name}_{}", i + 1), space);
        z += tall;
    }
}
