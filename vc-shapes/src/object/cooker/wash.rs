//! Washing and drying machines.

use std::f32::consts::FRAC_PI_2;

use vc_graph::asset::JointKind;

use super::cool::{grille, steel_legs};
use super::fitting::*;
use super::heat::foot_row;
use crate::material::*;
use crate::object::joinery::{Fitted, Handle, Panel, Swing, gapped, panel, pull_out, swing};
use crate::solid::{Axis, Build, P, basket, case, collar, fit, floor_of, half_dims, pit, plate_with_hole};

/// A drop-down door in front of two baskets that slide out.
pub(super) fn dishwasher(b: &mut Build<'_>) {
    let u = fit(b, [0.448, 0.352, 0.64]);
    let built_in = b.rng.chance(0.4);
    let body = if built_in { b.style.front } else { b.choose(&[b.style.appliance, STEEL]) };
    let look = Fitted::any(b, body, 0.03 * u);
    dish_machine(b, u, built_in, &look);
}

/// A dishwasher with a door of a design: a panel, if it is built in, or its own front.
pub(super) fn dish_machine(b: &mut Build<'_>, u: f32, built_in: bool, look: &Fitted) {
    let (x, y, _) = half_dims(b);
    let (h, body) = (under_worktop(b, u), look.mat);
    let (feet, face, door) = (0.1 * u, x - RUN * u, 0.03 * u);
    let (back, wall) = (face - door, 0.02 * u);
    b.block("plinth", [-x + 0.02 * u, -y, 0.0], [back - 0.04 * u, y, feet], if built_in { body } else { BLACK_METAL });
    case(b, [-x, -y, feet], [back, y, h], wall, STEEL);
    let (low, high) = ([-x + wall, -y + wall, feet + wall], [back - 0.01 * u, y - wall, h - wall]);
    let half = (high[2] - low[2]) / 2.0;
    for i in 0..2 {
        let z = low[2] + half * i as f32 + 0.015 * u;
        let from = [low[0] + 0.01 * u, low[1] + 0.008 * u, z];
        let to = [high[0], high[1] - 0.008 * u, z + half * 0.45];
        dish_basket(b, &format!("rack_{}", i + 1), (from, to), half * 0.85, u);
    }
    b.cylinder("spray_arm", [(low[0] + high[0]) / 2.0, 0.0, low[2]], 0.03 * u, 0.012 * u, GREY_PLASTIC);
    let (dl, dh) = gapped([back, -y, feet], [face, y, h], 0.002 * u);
    let plain = b.rng.chance(0.5);
    // The open door is level, so that the baskets slide out above it.
    swing(b, Swing::Down, dl, dh, FRAC_PI_2, |b| {
        if built_in {
            panel(b, look.panel, "door", (dl, dh), body);
            grab(b, [face, 0.0, h - 0.07 * u], y * 1.2, false, 0.028 * u, look.metal);
            return;
        }
        let strip = h - 0.11 * u;
        b.block("door", dl, [dh[0], dh[1], strip], body);
        let head = if plain { body } else { BLACK_PLASTIC };
        b.block("controls", [dl[0], dl[1], strip], dh, head);
        display(b, face, (-y * 0.3, h - 0.075 * u), (y * 0.1, h - 0.045 * u), LED);
        for i in 0..4 {
            let cy = y * (0.3 + 0.14 * i as f32);
            b.rod(
                "button",
                [face - 0.001 * u, cy, h - 0.06 * u],
                [face + 0.003 * u, cy, h - 0.06 * u],
                0.008 * u,
                STEEL,
            );
        }
        grab(b, [face, 0.0, strip - 0.03 * u], y * 1.2, false, 0.028 * u, STEEL);
    });
}

/// A basket of wire on a slide.
fn dish_basket(b: &mut Build<'_>, name: &str, (low, high): (P, P), room: f32, u: f32) {
    let w = 0.005 * u;
    // It is supported by runners on the walls.
    for y in [(low[1] - 0.014 * u, low[1] + w), (high[1] - w, high[1] + 0.014 * u)] {
        b.block("runner", [low[0], y.0, low[2] - w], [high[0], y.1, low[2] - 0.0005 * u], STEEL);
    }
    b.jointed(JointKind::Slide, low, [1.0, 0.0, 0.0], (0.0, (high[0] - low[0]) * 0.85), |b| {
        rack(b, low, [high[0], high[1], low[2] + w], 9, WHITE_PLASTIC);
        // A perforated bottom keeps cutlery from falling through.
        b.block(
            "bottom",
            [low[0] + w, low[1] + w, low[2] + w * 0.4],
            [high[0] - w, high[1] - w, low[2] + w],
            WHITE_PLASTIC,
        );
        for z in [f32::midpoint(low[2], high[2]), high[2]] {
            plate_with_hole(
                b,
                "wire",
                Axis::Z,
                ([low[0], low[1], z - w], [high[0], high[1], z]),
                ((low[0] + w, low[1] + w), (high[0] - w, high[1] - w)),
                WHITE_PLASTIC,
            );
        }
        for (cx, cy) in [(low[0], low[1]), (low[0], high[1] - w), (high[0] - w, low[1]), (high[0] - w, high[1] - w)] {
            b.block("post", [cx, cy, low[2] + w], [cx + w, cy + w, high[2] - w], WHITE_PLASTIC);
        }
        floor_of(b, name, [low[0] + w, low[1] + w, low[2] + w], [high[0] - w, high[1] - w, low[2] + room]);
    });
}

/// A hood over a basket on a steel table, or a low machine with a door.
pub(super) fn commercial_dishwasher(b: &mut Build<'_>) {
    let u = fit(b, [0.48, 0.48, 0.64]);
    let (x, y, h) = half_dims(b);
    let feet = 0.1 * u;
    steel_legs(b, (x * 0.8, y * 0.85), feet, false, u);
    if h < 1.1 {
        low_dishwasher(b, u, feet);
        return;
    }
    let table = h * b.vary(0.5, 0.56);
    let face = x - 0.035 * u;
    b.block("base", [-x, -y, feet], [face, y, table - 0.04 * u], STEEL);
    grille(b, face, (-y * 0.7, feet + 0.05 * u), (y * 0.7, feet + 0.15 * u), 3);
    display(b, face, (-y * 0.4, table - 0.17 * u), (y * 0.1, table - 0.1 * u), SIGNAL_GREEN);
    pit(b, "tub", [-x + 0.06 * u, -y, table - 0.04 * u], [face, y, table], 0.012 * u, STEEL);
    let low = [-x + 0.1 * u, -y + 0.03 * u, table - 0.028 * u];
    let high = [face - 0.03 * u, y - 0.03 * u, table + 0.06 * u];
    for cy in [-y + 0.03 * u, y - 0.03 * u - 0.02 * u] {
        b.block("mast", [-x, cy, table - 0.04 * u], [-x + 0.04 * u, cy + 0.02 * u, h - 0.06 * u], STEEL);
    }
    b.block("beam", [-x, -y + 0.03 * u, h - 0.06 * u], [-x + 0.04 * u, y - 0.03 * u, h], STEEL);
    let lift = (h - table) * 0.45;
    let tray = BLUE_PLASTIC;
    basket(b, "rack_1", low, [high[0], high[1], table + 0.05 * u], 0.008 * u, tray);
    // The hood rises along the masts and uncovers the basket.
    let hood = ([-x + 0.05 * u, -y, table + 0.003 * u], [face, y, h - lift - 0.01 * u]);
    b.jointed(JointKind::Slide, hood.0, [0.0, 0.0, 1.0], (0.0, lift), |b| {
        let t = 0.012 * u;
        b.block("hood", [hood.0[0], hood.0[1], hood.1[2] - t], hood.1, STEEL);
        let hole = ((hood.0[0] + t, -y + t), (face - t, y - t));
        plate_with_hole(b, "hood", Axis::Z, (hood.0, [face, y, hood.1[2] - t]), hole, STEEL);
        b.block(
            "arm",
            [-x + 0.01 * u, -0.03 * u, hood.1[2] - 0.1 * u],
            [hood.0[0] + t * 0.5, 0.03 * u, hood.1[2] - 0.05 * u],
            STEEL,
        );
        grab(b, [face, 0.0, table + 0.08 * u], y * 1.6, false, 0.034 * u, STEEL);
    });
}

/// An undercounter glass washer.
fn low_dishwasher(b: &mut Build<'_>, u: f32, feet: f32) {
    let (x, y, h) = half_dims(b);
    let (face, wall) = (x - 0.035 * u, 0.03 * u);
    let back = face - 0.04 * u;
    let (sill, lintel) = (feet + (h - feet) * 0.35, h - 0.12 * u);
    b.block("base", [-x, -y, feet], [face, y, sill], STEEL);
    b.block("head", [-x, -y, lintel], [face, y, h], STEEL);
    display(b, face, (-y * 0.5, h - 0.09 * u), (-y * 0.1, h - 0.04 * u), SIGNAL_GREEN);
    knobs(b, [face, y * 0.45, h - 0.06 * u], y * 0.5, 2, 0.022 * u, (BLACK_PLASTIC, WHITE));
    case(b, [-x, -y, sill], [back, y, lintel], wall, STEEL);
    let low = [-x + wall + 0.01 * u, -y + wall + 0.01 * u, sill + wall + 0.01 * u];
    dish_basket(
        b,
        "rack_1",
        (low, [back - 0.02 * u, y - wall - 0.01 * u, low[2] + 0.1 * u]),
        lintel - wall - low[2] - 0.01 * u,
        u,
    );
    let (dl, dh) = gapped([back, -y, sill], [face, y, lintel], 0.002 * u);
    swing(b, Swing::Down, dl, dh, 1.5, |b| {
        b.block("door", dl, dh, STEEL);
        grab(b, [face, 0.0, lintel - 0.06 * u], y * 1.4, false, 0.034 * u, STEEL);
    });
}

/// A washing machine: a drum behind a round door, a detergent drawer, a dial.
pub(super) fn washing_machine(b: &mut Build<'_>) {
    drum_machine(b, true);
}

/// A dryer: a drum behind a round door, a drawer for water, a dial.
pub(super) fn dryer(b: &mut Build<'_>) {
    drum_machine(b, false);
}

fn drum_machine(b: &mut Build<'_>, washes: bool) {
    let u = fit(b, [0.448, 0.48, 0.672]);
    let (x, y, _) = half_dims(b);
    let h = under_worktop(b, u);
    if !in_run(b) {
        b.top("top", [-0.02 * u, 0.0, h], (x - 0.05 * u, y - 0.01 * u));
    }
    let body = b.choose(&[WHITE_METAL, WHITE_METAL, b.style.appliance, SILVER_METAL]);
    let (feet, face, wall) = (0.015 * u, x - 0.05 * u, 0.015 * u);
    foot_row(b, (x * 0.75, y * 0.85), 0.02 * u, feet);
    let strip = h - b.vary(0.11, 0.13) * u;
    let (middle, radius) = (feet + (strip - feet) * 0.53, (y * 0.55).min((strip - feet) * 0.36));
    let plate = face - 0.02 * u;
    // The case, its front with a hole in front of the drum.
    case(b, [-x, -y, feet], [plate, y, strip], wall, body);
    let side = radius * 0.86;
    let front = ([plate, -y, feet], [face, y, strip]);
    plate_with_hole(b, "front", Axis::X, front, ((-side, middle - side), (side, middle + side)), body);
    let bezel = b.choose(&[CHROME, WHITE_PLASTIC, GREY_PLASTIC, BLACK_PLASTIC]);
    collar(
        b,
        "bezel",
        ([face - 0.001 * u, 0.0, middle], [face + 0.008 * u, 0.0, middle]),
        (radius * 0.84, radius * 1.24),
        body,
    );
    let drum = radius.max(y * 0.75).min((strip - feet) * 0.46);
    let depth = (plate + x - 0.08 * u).max(0.02);
    let start = [plate - 0.002 * u - depth, 0.0, middle];
    let t = 0.008 * u;
    let profile = [
        (drum, 0.0),
        (drum, depth * 0.95),
        (radius * 0.86, depth),
        (radius * 0.86 - t, depth),
        (drum - t, depth * 0.95 - t),
        (drum - t, t),
    ];
    b.lathe_along("drum", start, [plate, 0.0, middle], &profile, STEEL);
    let floor = [start[0] + depth * 0.48, 0.0, middle - drum * 0.78];
    b.inside("compartment_1", floor, (depth * 0.42, drum * 0.58), drum * 1.4);
    drum_door(b, [face + 0.009 * u, 0.0, middle], radius, bezel, u);
    // Controls above.
    let head = b.choose(&[body, body, BLACK_GLASS]);
    b.block("back_panel", [-x, -y, strip], [-x + wall, y, h - wall], body);
    b.block("top", [-x, -y, h - wall], [face, y, h], body);
    let drawer_end = -y * 0.35;
    plate_with_hole(
        b,
        "controls",
        Axis::X,
        ([plate, -y, strip], [face, y, h - wall]),
        ((-y * 0.97, strip + wall * 0.4), (drawer_end, h - wall * 1.4)),
        head,
    );
    b.block("side", [-x + wall, -y, strip], [plate, -y + wall * 0.9, h - wall], body);
    b.block("side", [-x + wall, y - wall * 0.9, strip], [plate, y, h - wall], body);
    let look = Fitted { panel: Panel::Slab, handle: Handle::None, mat: body, metal: body, t: 0.016 * u };
    let tray =
        ([face - (x * 0.9).min(0.3), -y * 0.97, strip + wall * 0.4], [face + 0.004 * u, drawer_end, h - wall * 1.4]);
    let name = if washes { "soap_drawer" } else { "water_drawer" };
    pull_out(b, &look, name, tray);
    let z = f32::midpoint(strip, h - wall);
    let dial = y * b.vary(-0.1, 0.05);
    knob(b, [face, dial, z], (h - strip) * 0.3, 0.025 * u, (bezel, BLACK));
    let light = b.choose(&[LED, COOL_BULB, SIGNAL_AMBER]);
    display(b, face, (y * 0.32, z - 0.02 * u), (y * 0.62, z + 0.02 * u), light);
    for i in 0..3 {
        let cy = y * (0.7 + 0.09 * i as f32);
        b.rod("button", [face - 0.001 * u, cy, z], [face + 0.004 * u, cy, z], 0.008 * u, bezel);
    }
}

/// A round door of glass in a ring, hinged at the lower Y.
fn drum_door(b: &mut Build<'_>, at: P, radius: f32, rim: MaterialId, u: f32) {
    let [x, y, z] = at;
    let r = radius * 1.12;
    let t = 0.03 * u;
    swing(b, Swing::Right, [x, y - r, z - r], [x + t, y + r, z + r], 2.0, |b| {
        collar(b, "door", (at, [x + t, y, z]), (r * 0.72, r), rim);
        let glass = r * 0.73;
        let depth = t * 0.6;
        b.lathe_along(
            "glass",
            at,
            [x + 1.0, y, z],
            &[(glass, 0.0), (glass, depth), (glass * 0.6, depth * 1.3)],
            BLACK_GLASS,
        );
        b.block(
            "grip",
            [x + t - 0.002 * u, y + r * 0.76, z - r * 0.18],
            [x + t + 0.006 * u, y + r * 0.95, z + r * 0.18],
            rim,
        );
    });
}
