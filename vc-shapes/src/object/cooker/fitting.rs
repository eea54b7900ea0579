//! Elements of appliances and fitted units: hollow cases, basins, frames, racks, panelled fronts,
//! doors, drawers and knobs.
//!
//! Dimensions scale with [`fit`], so that an object smaller than usual for its class keeps its
//! proportions.

use std::f32::consts::FRAC_PI_2;

use vc_graph::asset::JointKind;

use crate::material::*;
use crate::object::joinery::{Handle, handle};
use crate::solid::{Build, P, basket, half_dims, plate_with_border};

/// A level rack of bars along X between two cross bars.
pub(in crate::object) fn rack(b: &mut Build<'_>, low: P, high: P, count: usize, mat: MaterialId) {
    let w = (high[0] - low[0]).min(high[1] - low[1]) * 0.02;
    b.block("rack", low, [low[0] + w, high[1], high[2]], mat);
    b.block("rack", [high[0] - w, low[1], low[2]], high, mat);
    let step = (high[1] - low[1] - w) / count.max(2).saturating_sub(1) as f32;
    for i in 0..count.max(2) {
        let y = low[1] + step * i as f32;
        b.block("rack", [low[0] + w, y, low[2]], [high[0] - w, y + w, high[2]], mat);
    }
}

/// A knob on a plane at X, with a pointer.
pub(in crate::object) fn knob(b: &mut Build<'_>, at: P, radius: f32, depth: f32, mats: (MaterialId, MaterialId)) {
    let [x, y, z] = at;
    b.lathe_along("knob", at, [x + 1.0, y, z], &[(radius, 0.0), (radius * 0.85, depth)], mats.0);
    let w = radius * 0.12;
    b.block("pointer", [x + depth * 0.9, y - w, z], [x + depth + 0.001, y + w, z + radius * 0.8], mats.1);
}

/// A row of knobs across a plane at X.
pub(in crate::object) fn knobs(
    b: &mut Build<'_>,
    at: P,
    span: f32,
    count: usize,
    radius: f32,
    mats: (MaterialId, MaterialId),
) {
    for i in 0..count {
        let y = at[1] + span * ((i as f32 + 0.5) / count as f32 - 0.5);
        knob(b, [at[0], y, at[2]], radius, (radius * 0.9).min(0.025), mats);
    }
}

/// A handle bar on two posts, level or upright, protruding by `depth` from a plane at X.
pub(in crate::object) fn grab(b: &mut Build<'_>, at: P, length: f32, upright: bool, depth: f32, mat: MaterialId) {
    let half = length / 2.0;
    let end = |k: f32, out: f32| {
        let along = half * k;
        [at[0] + out, at[1] + if upright { 0.0 } else { along }, at[2] + if upright { along } else { 0.0 }]
    };
    let r = depth * 0.22;
    for k in [-0.85, 0.85] {
        b.rod("handle", end(k, -r * 0.2), end(k, depth - r), r * 0.7, mat);
    }
    b.rod("handle", end(-1.0, depth - r), end(1.0, depth - r), r, mat);
}

/// A dark display with lit digits on a plane at X.
pub(in crate::object) fn display(b: &mut Build<'_>, x: f32, low: (f32, f32), high: (f32, f32), light: MaterialId) {
    b.block("display", [x - 0.001, low.0, low.1], [x + 0.0015, high.0, high.1], SCREEN);
    let (w, h) = (high.0 - low.0, high.1 - low.1);
    for i in 0..3 {
        let y = low.0 + w * (0.28 + 0.16 * i as f32);
        let (z0, z1) = (low.1 + h * 0.3, low.1 + h * 0.7);
        b.block("figure", [x, y, z0], [x + 0.0025, y + w * 0.09, z1], light);
    }
}

/// The edge of a front at which its hinge is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::object) enum Swing {
    /// The higher Y.
    Left,
    /// The lower Y.
    Right,
    /// The bottom.
    Down,
    /// The top.
    Up,
}

/// The parts built swing outwards about an edge of the front `low..high`.
pub(in crate::object) fn swing(
    b: &mut Build<'_>,
    at: Swing,
    low: P,
    high: P,
    most: f32,
    build: impl FnOnce(&mut Build<'_>),
) {
    let (y, z, axis) = match at {
        Swing::Left => (high[1], low[2], [0.0, 0.0, 1.0]),
        Swing::Right => (low[1], low[2], [0.0, 0.0, -1.0]),
        Swing::Down => (low[1], low[2], [0.0, 1.0, 0.0]),
        Swing::Up => (low[1], high[2], [0.0, -1.0, 0.0]),
    };
    b.hinge([high[0], y, z], axis, most, build);
}

/// The parts built open upwards about a line along Y through `anchor`, with the front edge rising.
pub(in crate::object) fn lid(b: &mut Build<'_>, anchor: P, most: f32, build: impl FnOnce(&mut Build<'_>)) {
    b.hinge(anchor, [0.0, -1.0, 0.0], most, build);
}

/// A front reduced by the gap to its neighbours.
pub(in crate::object) fn gapped(low: P, high: P, gap: f32) -> (P, P) {
    ([low[0], low[1] + gap, low[2] + gap], [high[0], high[1] - gap, high[2] - gap])
}

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
pub(in crate::object) struct Look {
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

impl Look {
    /// A look drawn from the style: fronts of `mat`, boards `t` thick.
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
    look: &Look,
    name: &str,
    (low, high): (P, P),
    at: Swing,
    high_up: bool,
) {
    let (low, high) = gapped(low, high, look.t * 0.08);
    let grip = match at {
        Swing::Left => low[1] + (high[1] - low[1]) * 0.1,
        Swing::Right => high[1] - (high[1] - low[1]) * 0.1,
        _ => f32::midpoint(low[1], high[1]),
    };
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
    look: &Look,
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
pub(in crate::object) fn pull_out(b: &mut Build<'_>, look: &Look, name: &str, (low, high): (P, P)) {
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
    look: &Look,
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

/// The distance of the front plane of doors and panels in a kitchen run behind the edge: handles
/// must not protrude beyond the worktop.
pub(in crate::object) const RUN: f32 = 0.03;

/// A worktop of the style, with its top at the full height and over the whole depth and width;
/// returns the height below it.
pub(in crate::object) fn worktop(b: &mut Build<'_>, u: f32) -> f32 {
    let (x, y, h) = half_dims(b);
    let t = 0.035 * u;
    b.block("worktop", [-x, -y, h - t], [x, y, h], b.style.worktop);
    b.top("worktop", [0.0, 0.0, h], (x - 0.01 * u, y - 0.005 * u));
    h - t
}

/// Whether it has the height of a kitchen run.
pub(in crate::object) fn in_run(b: &Build<'_>) -> bool {
    (0.88..=0.97).contains(&b.size.z)
}

/// Adds a worktop to an appliance with the height of a kitchen run; returns the height below it.
pub(in crate::object) fn under_worktop(b: &mut Build<'_>, u: f32) -> f32 {
    if in_run(b) { worktop(b, u) } else { b.size.z }
}
