//! Stoves, hobs, ovens and the hood above them.

use super::fitting::*;
use crate::material::*;
use crate::object::joinery::{Fitted, Handle, Panel, Swing, gapped, pull_out, swing};
use crate::solid::{Axis, Build, CORNERS, P, case, collar, fit, floor_of, half_dims, plate_with_hole, tiers};

/// How a stove heats its cooktop.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Fire {
    Gas,
    Glass,
    Plates,
}

/// Burners on top, knobs in front, one or two ovens below, a drawer at the bottom.
pub(super) fn stove(b: &mut Build<'_>) {
    let u = fit(b, [0.56, 0.48, 0.8]);
    let (x, y, h) = half_dims(b);
    let trim = b.choose(&[STEEL, BLACK_METAL, b.style.appliance]);
    let fire = b.choose(&[Fire::Gas, Fire::Gas, Fire::Glass, Fire::Glass, Fire::Plates]);
    let top = h - 0.03 * u;
    cooktop(b, fire, ([-x, -y, top - 0.025 * u], [x - 0.004 * u, y, h]), u);
    let look = Fitted { panel: Panel::Slab, handle: Handle::None, mat: trim, metal: STEEL, t: 0.03 * u };
    range(b, u, (top - 0.025 * u, trim), &look);
}

/// A hob on a worktop over an oven, with a drawer of a design at the bottom.
pub(super) fn built_in_cooker(b: &mut Build<'_>, u: f32, look: &Fitted) {
    let (x, y, h) = half_dims(b);
    let trim = b.choose(&[STEEL, BLACK_METAL, BLACK_GLASS]);
    let fire = b.choose(&[Fire::Gas, Fire::Glass, Fire::Glass, Fire::Glass]);
    let under = h - 0.035 * u;
    b.block("worktop", [-x, -y, under], [x, y, h], b.style.worktop);
    let (back, front, side) = (0.055 * u, 0.05 * u, (y - 0.29 * u).max(0.012 * u));
    let rise = if fire == Fire::Gas { 0.036 } else { 0.006 };
    cooktop(b, fire, ([back - x, side - y, h], [x - front, y - side, h + rise * u]), u);
    let look = Fitted { t: 0.03 * u, ..*look };
    range(b, u, (under, trim), &look);
}

/// The part of a stove below its plate: controls up to `top`, one or two ovens, a drawer.
fn range(b: &mut Build<'_>, u: f32, (top, trim): (f32, MaterialId), look: &Fitted) {
    let (x, y, h) = half_dims(b);
    let (body, face, wall) = (b.style.appliance, x - RUN * u, 0.035 * u);
    let (sill, lintel) = (h * b.vary(0.22, 0.26), h * 0.83);
    let back = face - 0.03 * u;
    b.block("plinth", [-x, -y + 0.02 * u, 0.0], [back - 0.04 * u, y - 0.02 * u, 0.05 * u], BLACK_METAL);
    // The oven, between the drawer and the controls.
    let ovens = if y > 0.36 { 2 } else { 1 };
    let step = 2.0 * y / ovens as f32;
    for i in 0..ovens {
        let (y0, y1) = (-y + step * i as f32, -y + step * (i + 1) as f32);
        let name = if ovens == 2 && i == 1 { "side_rack" } else { "rack" };
        baking(b, name, ([-x, y0, sill], [back, y1, lintel]), wall, 2, body);
        let door = ([back, y0, sill], [face, y1, lintel]);
        glass_door(b, Swing::Down, door, (trim, BLACK_GLASS), 0.028 * u);
    }
    b.block("controls", [-x, -y, lintel], [face, y, top], trim);
    let radius = ((h - lintel - 0.055 * u) * 0.34).min(0.03 * u);
    let knob_mats = b.choose(&[(BLACK_PLASTIC, WHITE), (STEEL, BLACK), (WHITE_PLASTIC, BLACK)]);
    let z = f32::midpoint(lintel, top);
    let count = 4 + ovens + b.rng.below(2);
    let clock = b.rng.chance(0.5);
    let span = 1.8 * y;
    if clock {
        knobs(b, [face, -y * 0.58, z], span * 0.36, count.div_ceil(2), radius.min(y * 0.1), knob_mats);
        knobs(b, [face, y * 0.58, z], span * 0.36, count.div_ceil(2), radius.min(y * 0.1), knob_mats);
        let w = y * 0.16;
        display(b, face, (-w, z - w * 0.4), (w, z + w * 0.4), LED);
    } else {
        knobs(b, [face, 0.0, z], span, count, radius.min(y * 0.12), knob_mats);
    }
    // A drawer for trays at the bottom.
    case(b, [-x, -y, 0.05 * u], [back, y, sill], 0.015 * u, body);
    pull_out(b, look, "drawer", ([-x + 0.02 * u, -y, 0.05 * u], [face, y, sill]));
}

/// A built-in plate with burners for a worktop.
pub(super) fn hob(b: &mut Build<'_>) {
    let u = fit(b, [0.4, 0.448, 0.019]);
    let (x, y, h) = half_dims(b);
    let fire = b.choose(&[Fire::Gas, Fire::Glass, Fire::Glass]);
    if h < 0.03 || fire == Fire::Glass {
        let glass = (h * 0.3).min(0.008);
        if h >= 0.03 {
            b.taper("tray", [0.0; 3], (x - 0.03, y - 0.03), (x - 0.006 * u, y - 0.006 * u), h - glass, STEEL);
        }
        let low = if h >= 0.03 { h - glass } else { 0.0 };
        b.block("glass", [-x, -y, low], [x, y, h - 0.0012 * u], BLACK_GLASS);
        for (i, (cx, cy, r)) in spots(x * 0.82, y * 0.92, y > 0.37).into_iter().enumerate() {
            mark(b, [cx, cy, h - 0.0014 * u], r * 0.9);
            b.top(&format!("burner_{}", i + 1), [cx, cy, h], (r, r));
        }
        let w = y * 0.3;
        let touch = [x * 0.86, -w, h - 0.0013 * u];
        b.block("touch", touch, [x * 0.94, w, h - 0.0008 * u], SCREEN);
        for i in 0..4 {
            let cy = w * (-0.7 + 0.46 * i as f32);
            b.block("key", [x * 0.88, cy, h - 0.001 * u], [x * 0.92, cy + w * 0.1, h], PICTURE_SUN);
        }
        return;
    }
    cooktop(b, fire, ([-x, -y, 0.0], [x, y, h]), u);
    let mats = (BLACK_PLASTIC, WHITE);
    for i in 0..4 {
        let at = [x * 0.88, y * 0.16 * (i as f32 - 1.5), h - (0.03 * u).min(h * 0.6) - 0.001 * u];
        b.lathe("knob", at, &[(y * 0.06, 0.0), (y * 0.05, (h * 0.4).min(0.03 * u))], mats.0);
    }
}

/// A built-in oven: a front of glass and steel, racks inside.
pub(super) fn oven(b: &mut Build<'_>) {
    let u = fit(b, [0.48, 0.48, 0.4]);
    oven_box(b, u, 3, Swing::Down);
}

/// A steam oven: tall, with a digital front, its door hinged at the side or the bottom.
pub(super) fn steam_oven(b: &mut Build<'_>) {
    let u = fit(b, [0.48, 0.48, 0.48]);
    let tall = b.size.z > 0.7;
    let at = if tall { Swing::Right } else { b.choose(&[Swing::Down, Swing::Right]) };
    oven_box(b, u, if tall { 6 } else { 3 }, at);
}

fn oven_box(b: &mut Build<'_>, u: f32, racks: usize, at: Swing) {
    let (x, y, h) = half_dims(b);
    let body = b.choose(&[STEEL, STEEL, BLACK_METAL, WHITE_METAL]);
    let (face, feet) = (x - 0.032 * u, 0.02 * u);
    let back = face - 0.03 * u;
    let sill = feet + 0.03 * u;
    let lintel = h - b.vary(0.11, 0.14) * (h / 0.6).min(1.2);
    for (cx, cy) in [(-x * 0.8, -y * 0.85), (-x * 0.8, y * 0.85), (x * 0.6, -y * 0.85), (x * 0.6, y * 0.85)] {
        b.cylinder("foot", [cx, cy, 0.0], 0.02 * u, feet, BLACK_PLASTIC);
    }
    baking(b, "rack", ([-x, -y, feet], [back, y, lintel]), 0.03 * u, racks, body);
    b.block("head", [-x, -y, lintel], [back, y, h], body);
    b.block("sill", [back, -y, feet], [face, y, sill], body);
    glass_door(b, at, ([back, -y, sill], [face, y, lintel]), (body, BLACK_GLASS), 0.03 * u);
    let trim = b.choose(&[BLACK_GLASS, body]);
    b.block("controls", [back, -y, lintel], [face, y, h], trim);
    let (z, r) = (f32::midpoint(lintel, h), ((h - lintel) * 0.26).min(y * 0.12).min(0.03 * u));
    let light = b.choose(&[LED, COOL_BULB, SIGNAL_AMBER]);
    let w = y * b.vary(0.22, 0.34);
    display(b, face, (-w, z - r * 0.8), (w, z + r * 0.8), light);
    let count = b.rng.count(1, 2);
    for side in [-1.0, 1.0] {
        knobs(b, [face, side * y * 0.68, z], y * 0.4, count, r, (STEEL, BLACK));
    }
}

/// A low, wide oven with a stone floor, of steel or with a dome of brick.
pub(super) fn pizza_oven(b: &mut Build<'_>) {
    let u = fit(b, [0.4, 0.448, 0.224]);
    let (x, y, h) = half_dims(b);
    let body = b.choose(&[STEEL, BLACK_METAL, RED_METAL, STEEL]);
    let (feet, face) = (0.04 * u, x - 0.035 * u);
    let back = face - 0.025 * u;
    for cx in [-x * 0.8, x * 0.7] {
        for cy in [-y * 0.85, y * 0.85] {
            b.cylinder("foot", [cx, cy, 0.0], 0.02 * u, feet, BLACK_PLASTIC);
        }
    }
    let dome = b.rng.chance(0.4);
    let lintel = h * if dome { 0.72 } else { 0.86 };
    let side = y * if dome { 1.0 } else { 0.78 };
    let wall = 0.03 * u;
    case(b, [-x, -y, feet], [back, side, lintel], wall, body);
    let hollow = ([-x + wall, -y + wall, feet + wall], [back - 0.01 * u, side - wall, lintel - wall]);
    let stone = [hollow.0[0], hollow.0[1], hollow.0[2] + 0.012 * u];
    b.block("stone", hollow.0, [hollow.1[0], hollow.1[1], stone[2]], SANDSTONE);
    floor_of(b, "rack_1", stone, hollow.1);
    glass_door(b, Swing::Down, ([back, -y, feet], [face, side, lintel]), (body, BLACK_GLASS), 0.033 * u);
    if dome {
        let mid = (h - lintel) * 0.7;
        b.taper(
            "vault",
            [(back - x) / 2.0, 0.0, lintel],
            ((back + x) / 2.0, y),
            ((back + x) * 0.42, y * 0.82),
            mid,
            body,
        );
        let roof = ((back + x) * 0.42, y * 0.82);
        b.taper(
            "vault",
            [(back - x) / 2.0, 0.0, lintel + mid],
            roof,
            (roof.0 * 0.6, roof.1 * 0.6),
            h - lintel - mid,
            body,
        );
    } else {
        b.block("roof", [-x, -y, lintel], [back, y, h], body);
        b.block("column", [-x, side, feet], [back, y, lintel], body);
        let z = (lintel - feet) / 3.0;
        for i in 0..3 {
            knob(
                b,
                [back, f32::midpoint(side, y), feet + z * (i as f32 + 0.5)],
                y * 0.08,
                0.02 * u,
                (BLACK_PLASTIC, WHITE),
            );
        }
    }
}

/// A box with a door at the left and controls at the right.
pub(super) fn microwave(b: &mut Build<'_>) {
    let u = fit(b, [0.288, 0.352, 0.224]);
    let (x, y, h) = half_dims(b);
    let body = b.choose(&[b.style.appliance, STEEL, BLACK_METAL]);
    let (feet, face) = (0.012 * u, x - 0.03 * u);
    let back = face - 0.025 * u;
    let split = y - y * b.vary(0.42, 0.52);
    foot_row(b, (x * 0.75, y * 0.8), 0.015 * u, feet);
    let wall = 0.018 * u;
    case(b, [-x, -y, feet], [back, split, h], wall, body);
    let hollow = ([-x + wall, -y + wall, feet + wall], [back - 0.008 * u, split - wall, h - wall]);
    let (cx, cy) = (f32::midpoint(hollow.0[0], hollow.1[0]), f32::midpoint(hollow.0[1], hollow.1[1]));
    let plate = (hollow.1[0] - cx).min(hollow.1[1] - cy) * 0.92;
    let disc = 0.01 * u;
    b.cylinder("turntable", [cx, cy, hollow.0[2]], plate, disc, GLASS);
    let half = plate * 0.7;
    b.inside("compartment_1", [cx, cy, hollow.0[2] + disc], (half, half), h - 2.0 * wall - feet - disc - 0.004 * u);
    b.block("electronics", [-x, split, feet], [back, y, h], body);
    glass_door(b, Swing::Right, ([back, -y, feet], [face, split, h]), (body, BLACK_GLASS), 0.028 * u);
    let panel_mat = b.choose(&[BLACK_GLASS, body]);
    b.block("controls", [back, split, feet], [face, y, h], panel_mat);
    keypad(b, face, (split, feet), (y, h), u);
    b.top("top", [(back - x) / 2.0, 0.0, h], ((back + x) / 2.0 - 0.01 * u, y - 0.01 * u));
}

/// Controls of a microwave: a display over keys, or two knobs.
fn keypad(b: &mut Build<'_>, face: f32, low: (f32, f32), high: (f32, f32), u: f32) {
    let (w, tall) = (high.0 - low.0, high.1 - low.1);
    let light = b.choose(&[LED, COOL_BULB]);
    display(b, face, (low.0 + w * 0.12, high.1 - tall * 0.22), (high.0 - w * 0.12, high.1 - tall * 0.08), light);
    if b.rng.chance(0.5) {
        let r = (w * 0.28).min(tall * 0.14);
        for z in [0.25, 0.58] {
            knob(b, [face, low.0 + w / 2.0, low.1 + tall * z], r, 0.018 * u, (STEEL, BLACK));
        }
        return;
    }
    for row in 0..4 {
        for column in 0..3 {
            let (cy, cz) = (low.0 + w * (0.14 + 0.26 * column as f32), low.1 + tall * (0.12 + 0.15 * row as f32));
            let to = [face + 0.002 * u, cy + w * 0.2, cz + tall * 0.1];
            b.block("key", [face - 0.001 * u, cy, cz], to, GREY_PLASTIC);
        }
    }
}

/// A small countertop oven: glass door in front, knobs at the side.
pub(super) fn toaster_oven(b: &mut Build<'_>) {
    let u = fit(b, [0.24, 0.304, 0.176]);
    let (x, y, h) = half_dims(b);
    let body = b.choose(&[STEEL, BLACK_METAL, RED_METAL, b.style.appliance]);
    let (feet, face) = (0.015 * u, x - 0.028 * u);
    let back = face - 0.015 * u;
    let split = y * b.vary(0.48, 0.6);
    foot_row(b, (x * 0.75, y * 0.85), 0.012 * u, feet);
    baking(b, "rack", ([-x, -y, feet], [back, split, h]), 0.014 * u, 2, body);
    glass_door(b, Swing::Down, ([back, -y, feet], [face, split, h]), (body, BROWN_GLASS), 0.026 * u);
    b.block("controls", [-x, split, feet], [face - 0.004 * u, y, h], body);
    let count = b.rng.count(2, 3);
    let tall = (h - feet) / count as f32;
    for i in 0..count {
        let r = (tall * 0.3).min((y - split) * 0.3);
        let z = feet + tall * (i as f32 + 0.5);
        knob(b, [face - 0.004 * u, f32::midpoint(split, y), z], r, 0.016 * u, (BLACK_PLASTIC, WHITE));
    }
    b.top("top", [(back - x) / 2.0, 0.0, h], ((back + x) / 2.0 - 0.01 * u, y - 0.01 * u));
}

/// A hood on the wall: a chimney over a canopy, a slanted glass, or a flat box.
pub(super) fn extractor(b: &mut Build<'_>) {
    let u = fit(b, [0.24, 0.448, 0.24]);
    let (x, y, h) = half_dims(b);
    let body = b.choose(&[STEEL, STEEL, BLACK_METAL, b.style.appliance]);
    let brim = (0.05 * u).min(h * 0.3);
    let design = if h < 0.4 { 2 } else { b.rng.below(2) };
    // All designs have filters and lights on the underside.
    plate_with_hole(
        b,
        "brim",
        Axis::Z,
        ([-x, -y, 0.0], [x, y, brim]),
        ((-x * 0.8, -y * 0.9), (x * 0.8, y * 0.9)),
        body,
    );
    for side in [-1.0, 1.0] {
        let cy = side * y * 0.45;
        b.block("filter", [-x * 0.8, cy - y * 0.44, brim * 0.4], [x * 0.45, cy + y * 0.44, brim], ALUMINIUM);
        b.cylinder("light", [x * 0.63, cy, brim * 0.3], (x * 0.12).min(y * 0.1), brim * 0.69, WARM_BULB);
    }
    b.block("underside", [x * 0.45, -y * 0.9, brim * 0.5], [x * 0.8, y * 0.9, brim], body);
    for i in 0..4 {
        let cy = y * 0.09 * (i as f32 - 1.5);
        b.rod(
            "button",
            [x - 0.002 * u, cy, brim * 0.5],
            [x + 0.0005 * u, cy, brim * 0.5],
            (brim * 0.22).min(y * 0.03),
            BLACK_PLASTIC,
        );
    }
    let (flue_x, flue_y) = (x * b.vary(0.5, 0.62), y * b.vary(0.34, 0.42));
    match design {
        0 => {
            let rise = h * b.vary(0.22, 0.35);
            let base = ([-x, -y], [x, y]);
            let neck = ([-x, -flue_y], [-x + 2.0 * flue_x, flue_y]);
            frustum(b, "canopy", (base, brim), (neck, brim + rise), body);
            b.block("chimney", [-x, -flue_y, brim + rise], [-x + 2.0 * flue_x, flue_y, h], body);
        }
        1 => {
            let glass = b.choose(&[GLASS, BLACK_GLASS]);
            b.block("body", [-x, -y * 0.7, brim], [x * 0.3, y * 0.7, brim + h * 0.14], body);
            let t = 0.012 * u;
            let outline = [(x * 0.3, 0.0), (x, 0.0), (x, t), (x * 0.3, h * 0.14)];
            b.prism("shade", Axis::Y, [0.0, -y, brim], &outline, 2.0 * y, glass);
            b.block("chimney", [-x, -flue_y, brim + h * 0.14], [-x + 2.0 * flue_x, flue_y, h], body);
        }
        _ => {
            let outline = [(-x, 0.0), (x, 0.0), (x * 0.92, (h - brim) * 0.4), (x * 0.4, h - brim), (-x, h - brim)];
            b.prism("body", Axis::Y, [0.0, -y, brim], &outline, 2.0 * y, body);
        }
    }
}

/// The hull of two level rectangles.
pub(super) fn frustum(
    b: &mut Build<'_>,
    name: &str,
    (below, z0): (([f32; 2], [f32; 2]), f32),
    (above, z1): (([f32; 2], [f32; 2]), f32),
    mat: MaterialId,
) {
    let corners =
        |(l, h): ([f32; 2], [f32; 2]), z: f32| [[l[0], l[1], z], [h[0], l[1], z], [h[0], h[1], z], [l[0], h[1], z]];
    let points: Vec<P> = corners(below, z0).into_iter().chain(corners(above, z1)).collect();
    b.hull(name, &points, mat);
}

/// The cavity of an oven with racks, open in front.
fn baking(b: &mut Build<'_>, name: &str, (low, high): (P, P), wall: f32, racks: usize, mat: MaterialId) {
    case(b, low, high, wall, mat);
    let hollow =
        ([low[0] + wall, low[1] + wall, low[2] + wall], [high[0] - wall * 0.4, high[1] - wall, high[2] - wall]);
    tiers(b, name, hollow, racks, wall * 0.2, |b, l, h| rack(b, l, h, 6, STEEL));
}

/// A framed pane that opens, with a handle bar.
pub(super) fn glass_door(b: &mut Build<'_>, at: Swing, (low, high): (P, P), mats: (MaterialId, MaterialId), grip: f32) {
    let t = high[0] - low[0];
    let (low, high) = gapped(low, high, t * 0.06);
    let (width, tall) = (high[1] - low[1], high[2] - low[2]);
    let w = width.min(tall) * 0.14;
    let down = at == Swing::Down;
    swing(b, at, low, high, if down { 1.5 } else { 1.75 }, |b| {
        let edge = if down { tall * 0.2 } else { w };
        let hole = ((low[1] + w, low[2] + w), (high[1] - w, high[2] - edge));
        plate_with_hole(b, "door", Axis::X, (low, high), hole, mats.0);
        b.block("pane", [low[0] + t * 0.2, hole.0.0, hole.0.1], [high[0] - t * 0.12, hole.1.0, hole.1.1], mats.1);
        let (cy, cz) = (f32::midpoint(low[1], high[1]), f32::midpoint(low[2], high[2]));
        match at {
            Swing::Down | Swing::Up => grab(b, [high[0], cy, high[2] - edge * 0.5], width * 0.8, false, grip, STEEL),
            Swing::Left => grab(b, [high[0], low[1] + w * 0.5, cz], tall * 0.7, true, grip, STEEL),
            Swing::Right => grab(b, [high[0], high[1] - w * 0.5, cz], tall * 0.7, true, grip, STEEL),
        }
    });
}

/// Four small feet.
pub(super) fn foot_row(b: &mut Build<'_>, half: (f32, f32), radius: f32, height: f32) {
    for (sx, sy) in CORNERS {
        b.cylinder("foot", [sx * half.0, sy * half.1, 0.0], radius, height, RUBBER);
    }
}

/// The centres and radii of burners on a plate of half lengths `x` and `y`.
fn spots(x: f32, y: f32, five: bool) -> Vec<(f32, f32, f32)> {
    let (dx, dy) = (x * 0.52, y * if five { 0.64 } else { 0.5 });
    let r = (dx.min(dy) * 0.78).min(y - dy);
    let mut spots = vec![(dx, dy, r), (-dx, dy, r * 0.82), (-dx, -dy, r), (dx, -dy, r * 0.82)];
    if five {
        spots.push((0.0, 0.0, (dy - r).min(r)));
    }
    spots.iter_mut().for_each(|s| s.0 -= x * 0.06);
    spots
}

/// The printed circle of a cooking zone, a millimetre high.
fn mark(b: &mut Build<'_>, at: P, radius: f32) {
    let [x, y, z] = at;
    collar(b, "zone", (at, [x, y, z + 0.001]), (radius * 0.93, radius), GREY_PLASTIC);
}

/// The top of a stove within `low..high`: a plate with burners.
fn cooktop(b: &mut Build<'_>, fire: Fire, (low, high): (P, P), u: f32) {
    let plate = if fire == Fire::Gas { b.choose(&[STEEL, BLACK_METAL, BLACK_GLASS]) } else { BLACK_GLASS };
    let (x, y) = ((high[0] - low[0]) / 2.0, (high[1] - low[1]) / 2.0);
    let (cx, h) = (f32::midpoint(low[0], high[0]), high[2]);
    let rise = match fire {
        Fire::Gas => 0.03 * u,
        Fire::Glass => 0.001,
        Fire::Plates => 0.012 * u,
    }
    .min((h - low[2]) * 0.6);
    b.block("cooktop", low, [high[0], high[1], h - rise], plate);
    for (i, (dx, cy, r)) in spots(x, y, y > 0.37).into_iter().enumerate() {
        let at = [cx + dx, cy, h - rise];
        match fire {
            Fire::Glass => mark(b, [at[0], cy, h - rise - 0.0002 * u], r * 0.9),
            Fire::Plates => b.lathe("plate", at, &[(r * 0.9, 0.0), (r * 0.86, rise)], IRON),
            Fire::Gas => gas_burner(b, at, r, rise),
        }
        b.top(&format!("burner_{}", i + 1), [at[0], cy, h], (r, r));
    }
}

/// A burner's cap under a cross of iron bars on feet.
fn gas_burner(b: &mut Build<'_>, at: P, r: f32, rise: f32) {
    let [x, y, z] = at;
    b.lathe("burner", at, &[(r * 0.4, 0.0), (r * 0.4, rise * 0.4), (r * 0.3, rise * 0.6)], IRON);
    let (w, top) = (r * 0.07, z + rise);
    let low = z + rise * 0.62;
    b.block("grate", [x - r, y - w, low], [x + r, y + w, top], IRON);
    b.block("grate", [x - w, y - r, low], [x + w, y - w, top], IRON);
    b.block("grate", [x - w, y + w, low], [x + w, y + r, top], IRON);
    for (dx, dy) in [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)] {
        let (fx, fy) = (x + dx * (r - w), y + dy * (r - w));
        b.block("grate", [fx - w * 0.8, fy - w * 0.8, z], [fx + w * 0.8, fy + w * 0.8, low + 0.001], IRON);
    }
}
