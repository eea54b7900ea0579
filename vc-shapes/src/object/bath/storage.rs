//! Bathroom cabinets, shelves, rails, baskets and mirrors.

use crate::material::*;
use crate::object::cooker::fitting::*;
use crate::object::joinery::{Fitted, Swing, cupboard_doors, drawers, gapped, pull_out, swing};
use crate::solid::{
    Axis, Build, P, case, fit, floor_of, half_dims, oblong, pit, plate_with_border, plate_with_hole, tiers,
};

/// The design of bathroom fronts.
fn bath_look(b: &mut Build<'_>, u: f32) -> Fitted {
    let mat = b.choose(&[b.style.cabinet, b.style.front, b.style.wood, WHITE]);
    let t = b.vary(0.016, 0.02) * u;
    Fitted::any(b, mat, t)
}

/// The X of the front plane, which leaves space for handles.
fn face(b: &Build<'_>, look: &Fitted) -> f32 {
    b.size.x / 2.0 - look.grip()
}

/// A cabinet under a top for a basin, on legs, on a plinth or hung on the wall.
pub(super) fn bathroom_vanity(b: &mut Build<'_>) {
    let u = fit(b, [0.352, 0.48, 0.64]);
    let (x, y, h) = half_dims(b);
    let look = bath_look(b, u);
    let (slab, t) = (b.vary(0.02, 0.04) * u, look.t);
    let stone = b.choose(&[MARBLE, WHITE, b.style.worktop, b.style.wood]);
    let front = face(b, &look);
    b.block("top", [-x, -y, h - slab], [x, y, h], stone);
    b.top("top", [0.0, 0.0, h], (x - 0.01 * u, y - 0.01 * u));
    let under = h - slab;
    let floor = stand(b, &look, (front, y - 0.01 * u), h, u);
    let (low, high) = ([-x, -y + 0.01 * u, floor], [front - t, y - 0.01 * u, under]);
    match b.rng.below(4) {
        0 => cupboard(b, &look, (low, high), 2, "shelf"),
        1 => {
            case(b, low, high, t, look.mat);
            let count = if under - floor > 0.4 { b.rng.count(2, 3) } else { 2 };
            drawers(b, &look, "drawer", ([low[0] + t, low[1], floor + t * 0.5], [front, high[1], under]), (count, 1.2));
        }
        2 => {
            let middle = high[1] - (high[1] - low[1]) * b.vary(0.3, 0.42);
            cupboard(b, &look, (low, [high[0], middle, under]), 2, "shelf");
            let side = [low[0], middle, floor];
            case(b, side, high, t, look.mat);
            drawers(b, &look, "drawer", ([low[0] + t, middle, floor + t * 0.5], [front, high[1], under]), (3, 1.3));
        }
        _ => {
            // Drawers above, an open shelf below.
            let split = floor + (under - floor) * 0.42;
            case(b, low, [high[0], high[1], split], t, look.mat);
            floor_of(b, "shelf", [low[0] + t, low[1] + t, floor + t], [high[0], high[1] - t, split - t]);
            case(b, [low[0], low[1], split], high, t, look.mat);
            drawers(b, &look, "drawer", ([low[0] + t, low[1], split + t * 0.5], [front, high[1], under]), (1, 1.0));
        }
    }
}

/// Legs, a plinth or side panels under a cabinet; returns the height of the cabinet's bottom.
fn stand(b: &mut Build<'_>, look: &Fitted, (front, y): (f32, f32), h: f32, u: f32) -> f32 {
    let x = b.size.x / 2.0;
    match b.rng.below(3) {
        0 => {
            let floor = h * b.vary(0.16, 0.24);
            let metal = b.choose(&[look.metal, look.mat]);
            for cx in [-x + 0.03 * u, front - 0.04 * u] {
                for cy in [-y + 0.03 * u, y - 0.03 * u] {
                    b.taper(
                        "leg",
                        [cx, cy, 0.0],
                        (0.011 * u, 0.011 * u),
                        (0.017 * u, 0.017 * u),
                        floor + 0.002 * u,
                        metal,
                    );
                }
            }
            floor
        }
        1 => {
            let floor = 0.09 * u;
            b.block("plinth", [-x + 0.01 * u, -y + 0.005 * u, 0.0], [front - 0.06 * u, y - 0.005 * u, floor], look.mat);
            floor
        }
        _ => {
            let floor = h * b.vary(0.2, 0.36);
            for cy in [(-y - 0.004 * u, -y + 0.016 * u), (y - 0.016 * u, y + 0.004 * u)] {
                b.block(
                    "side",
                    [-x + 0.004 * u, cy.0, 0.0],
                    [front - look.t - 0.003 * u, cy.1, floor + 0.002 * u],
                    look.mat,
                );
            }
            floor
        }
    }
}

/// A case with shelves behind doors.
fn cupboard(b: &mut Build<'_>, look: &Fitted, (low, high): (P, P), spaces: usize, name: &str) {
    let (t, mat) = (look.t, look.mat);
    case(b, low, high, t, mat);
    let hollow = ([low[0] + t, low[1] + t, low[2] + t], [high[0] - 0.004, high[1] - t, high[2] - t]);
    tiers(b, name, hollow, spaces, t * 0.8, |b, l, h| b.block("shelf", l, h, mat));
    let front = ([high[0], low[1], low[2]], [high[0] + t, high[1], high[2]]);
    cupboard_doors(b, look, front, 0.5, low[2] > 1.0);
}

/// A low or hanging cabinet with doors and sometimes a drawer, its top free.
pub(super) fn bathroom_cabinet(b: &mut Build<'_>) {
    let u = fit(b, [0.224, 0.32, 0.448]);
    let (x, y, h) = half_dims(b);
    let look = bath_look(b, u);
    let front = face(b, &look) - 0.006 * u;
    let t = look.t;
    let top = h - 0.02 * u;
    let slab = b.choose(&[look.mat, MARBLE, WHITE]);
    b.block("top", [-x, -y, top], [front + 0.006 * u, y, h], slab);
    b.top("top", [(front - x) / 2.0, 0.0, h], ((front + x) / 2.0 - 0.01 * u, y - 0.01 * u));
    let inset = 0.006 * u;
    let floor = match b.rng.below(3) {
        0 => 0.0,
        _ => stand(b, &look, (front, y - inset), h * 0.6, u),
    };
    let (low, high) = ([-x, -y + inset, floor], [front - t, y - inset, top]);
    if b.rng.chance(0.5) {
        cupboard(b, &look, (low, high), if h > 0.65 { 3 } else { 2 }, "shelf");
        return;
    }
    let split = top - (top - floor) * 0.26;
    cupboard(b, &look, (low, [high[0], high[1], split]), 2, "shelf");
    let upper = [low[0], low[1], split];
    case(b, upper, high, t, look.mat);
    pull_out(b, &look, "drawer_1", ([low[0] + t, low[1], split + t * 0.4], [front, high[1], top]));
}

/// A tall, narrow cabinet: doors above and below, sometimes with open shelves between.
pub(super) fn towel_cabinet(b: &mut Build<'_>) {
    let u = fit(b, [0.24, 0.24, 1.12]);
    let (x, y, h) = half_dims(b);
    let look = bath_look(b, u);
    let (front, t) = (face(b, &look), look.t);
    let foot = h * b.vary(0.03, 0.06);
    b.block("plinth", [-x + 0.01 * u, -y + 0.005 * u, 0.0], [front - t - 0.02 * u, y - 0.005 * u, foot], look.mat);
    let (low, high) = ([-x, -y, foot], [front - t, y, h]);
    let (a, c) = (foot + (h - foot) * b.vary(0.36, 0.44), foot + (h - foot) * b.vary(0.58, 0.66));
    if b.rng.chance(0.3) {
        return cupboard(b, &look, (low, high), 5, "shelf");
    }
    cupboard(b, &look, (low, [high[0], high[1], a]), 2, "shelf");
    let (middle, mat) = ([low[0], low[1], a], look.mat);
    case(b, middle, [high[0], high[1], c], t, mat);
    let hollow = ([low[0] + t, low[1] + t, a + t], [high[0] - 0.004 * u, high[1] - t, c - t]);
    let open = b.rng.count(1, 2);
    tiers(b, "open_shelf", hollow, open, t, |b, l, h| b.block("shelf", l, h, mat));
    cupboard(b, &look, ([low[0], low[1], c], high), 2, "upper_shelf");
}

/// A cabinet behind doors, open at the top for the pipes.
pub(super) fn under_sink_cabinet(b: &mut Build<'_>) {
    let u = fit(b, [0.32, 0.4, 0.432]);
    let (x, y, h) = half_dims(b);
    let look = bath_look(b, u);
    let (front, t, kick) = (face(b, &look), look.t, 0.06 * u);
    let high = [front - t, y, h];
    b.block("plinth", [-x + 0.01 * u, -y, 0.0], [front - 0.05 * u, y, kick], look.mat);
    let low = [-x, -y, kick];
    // There is no top board: the bowl hangs into the cabinet.
    b.block("bottom", low, [high[0], y, kick + t], look.mat);
    for cy in [(-y, -y + t), (y - t, y)] {
        b.block("side", [-x, cy.0, kick + t], [high[0], cy.1, h], look.mat);
    }
    for cx in [-x, high[0] - t] {
        b.block("rail", [cx, -y + t, h - 0.09 * u], [cx + t, y - t, h], look.mat);
    }
    let space = ([-x + t, -y + t, kick + t], [high[0] - t * 1.4, y - t, h - 0.095 * u]);
    let (mat, half) = (look.mat, f32::midpoint(space.0[0], space.1[0]));
    if b.rng.chance(0.5) {
        // A half shelf at one side leaves space for the drain.
        let (z, cy) = (f32::midpoint(kick, h), y * 0.2);
        b.block("shelf", [space.0[0] - t, cy, z - t * 0.8], [half, y - t, z], mat);
        b.block("shelf_side", [space.0[0] - t, cy - t * 0.8, kick + t], [half, cy, z], mat);
        floor_of(b, "shelf_1", [space.0[0], cy, z], [half, y - t, space.1[2]]);
        floor_of(b, "compartment_1", space.0, [space.1[0], cy - t, space.1[2]]);
    } else {
        floor_of(b, "compartment_1", space.0, space.1);
    }
    cupboard_doors(b, &look, ([high[0], -y, kick], [front, y, h]), 0.45, false);
}

/// Wall shelves: a ladder of shelves, or one board with a rim.
pub(super) fn bathroom_shelf(b: &mut Build<'_>) {
    let u = fit(b, [0.096, 0.24, 0.04]);
    let (x, y, h) = half_dims(b);
    let (metal, wood) = (b.style.tap, b.choose(&[b.style.wood, WHITE, GLASS, BAMBOO]));
    let t = (0.012 * u).min(h * 0.4);
    if h < 0.25 {
        // One board on brackets, with a rail so that nothing falls off.
        let z = h * 0.35;
        b.block("shelf_1", [-x, -y, z], [x, y, z + t], wood);
        b.ledge("shelf_1", [0.0, 0.0, z + t], (x - 0.015 * u, y - 0.015 * u), 0.4);
        for side in [-0.7, 0.7] {
            let cy = y * side;
            b.prism(
                "bracket",
                Axis::Y,
                [-x, cy - 0.004 * u, z],
                &[(0.0, 0.0), (x * 1.4, 0.0), (0.0, -z)],
                0.008 * u,
                metal,
            );
        }
        if h - z - t > 0.01 {
            let r = 0.004 * u;
            let points =
                [[-x + r, -y + r, h - r], [x - r, -y + r, h - r], [x - r, y - r, h - r], [-x + r, y - r, h - r]];
            b.pipe("rail", &points, r, metal);
            for p in points {
                b.rod("post", [p[0], p[1], z + t - 0.001 * u], p, r * 0.9, metal);
            }
        }
        return;
    }
    let count = (h / 0.26).round().clamp(2.0, 6.0) as usize;
    let ladder = h > 0.9 && b.rng.chance(0.4);
    let bottom = if h > 0.9 { h * 0.08 } else { 0.0 };
    let pitch = (h - t - bottom - if h > 0.9 { h * 0.12 } else { h * 0.06 }) / (count - 1) as f32;
    let solid = b.rng.chance(0.5);
    let post = if solid { 0.016 * u } else { 0.018 * u };
    for i in 0..count {
        let z = bottom + pitch * i as f32;
        let depth = if ladder { 1.0 - 0.45 * i as f32 / count as f32 } else { 1.0 };
        let front = -x + 2.0 * x * depth;
        b.block("shelf", [-x, -y + post, z], [front, y - post, z + t], wood);
        let room = if i + 1 == count { (h - z - t).max(0.2) } else { pitch - t - 0.003 * u };
        b.ledge(
            &format!("shelf_{}", i + 1),
            [(front - x) / 2.0, 0.0, z + t],
            ((front + x) / 2.0 - 0.01 * u, y - post - 0.01 * u),
            room,
        );
    }
    for cy in [(-y, -y + post), (y - post, y)] {
        if ladder {
            let outline = [(-x, 0.0), (x, 0.0), (x, 0.03), (-x + x * 0.9, h), (-x, h)];
            b.prism("side", Axis::Y, [0.0, cy.0, 0.0], &outline, post, b.style.wood);
        } else if solid {
            b.block("side", [-x, cy.0, 0.0], [x, cy.1, h], wood_or(b, wood));
        } else {
            for cx in [(-x, -x + post), (x - post, x)] {
                b.block("post", [cx.0, cy.0, 0.0], [cx.1, cy.1, h], metal);
            }
        }
    }
}

/// Glass shelves have sides of metal.
fn wood_or(b: &Build<'_>, mat: MaterialId) -> MaterialId {
    if mat == GLASS { b.style.tap } else { mat }
}

/// A shallow wall cabinet with mirror doors.
pub(super) fn medicine_cabinet(b: &mut Build<'_>) {
    let u = fit(b, [0.096, 0.32, 0.432]);
    let (x, y, h) = half_dims(b);
    let body = b.choose(&[WHITE, b.style.cabinet, ALUMINIUM]);
    let t = 0.014 * u;
    let light = b.rng.chance(0.4);
    let roof = if light { h - 0.045 * u } else { h };
    let front = x - 0.022 * u;
    let (low, high) = ([-x, -y, 0.0], [front - 0.018 * u, y, roof]);
    case(b, low, high, t, body);
    let hollow = ([-x + t, -y + t, t], [high[0] - 0.006 * u, y - t, roof - t]);
    tiers(b, "shelf", hollow, 3, 0.006 * u, |b, l, h| b.block("shelf", l, h, GLASS));
    let doors = if y > 0.3 { b.rng.count(2, 3) } else { 1 };
    let step = 2.0 * y / doors as f32;
    let knobs = b.rng.chance(0.5);
    for i in 0..doors {
        let (dl, dh) = gapped([high[0], -y + step * i as f32, 0.0], [front, -y + step * (i + 1) as f32, roof], 0.001);
        let at = if i * 2 < doors { Swing::Right } else { Swing::Left };
        let grip = if at == Swing::Right { dh[1] - 0.025 * u } else { dl[1] + 0.025 * u };
        swing(b, at, dl, dh, 1.75, |b| {
            plate_with_border(b, "door", dl, dh, 0.012 * u, body);
            let w = 0.012 * u;
            b.block(
                "mirror",
                [dl[0] + 0.003 * u, dl[1] + w, dl[2] + w],
                [dh[0] - 0.002 * u, dh[1] - w, dh[2] - w],
                MIRROR,
            );
            if knobs {
                b.rod(
                    "knob",
                    [front - 0.003 * u, grip, h * 0.2],
                    [front + 0.018 * u, grip, h * 0.2],
                    0.009 * u,
                    CHROME,
                );
            }
        });
    }
    if light {
        b.block("canopy", [-x, -y, roof], [front, y, roof + 0.02 * u], body);
        b.rod(
            "tube",
            [front * 0.4, -y * 0.9, h - 0.016 * u],
            [front * 0.4, y * 0.9, h - 0.016 * u],
            0.014 * u,
            COOL_BULB,
        );
    }
    if x > 0.05 {
        b.rod("pull", [front - 0.002 * u, y * 0.06, 0.025 * u], [x, y * 0.06, 0.025 * u], 0.006 * u, CHROME);
    }
}

/// A mirror, framed or not, square or rounded, sometimes with a light or a shelf.
pub(super) fn bathroom_mirror(b: &mut Build<'_>) {
    let u = fit(b, [0.016, 0.32, 0.4]);
    let (x, y, h) = half_dims(b);
    let depth = (2.0 * x).max(0.004);
    match b.rng.below(5) {
        0 => {
            let frame = b.choose(&[b.style.wood, b.style.tap, WHITE, BLACK]);
            let w = b.vary(0.025, 0.05) * u;
            plate_with_border(b, "frame", [-x, -y, 0.0], [x, y, h], w, frame);
            b.block("mirror", [-x, -y + w, w], [x - depth * 0.3, y - w, h - w], MIRROR);
        }
        1 => {
            b.block("back", [-x, -y * 0.9, h * 0.05], [x - depth * 0.25, y * 0.9, h * 0.95], ALUMINIUM);
            b.block("glow", [-x, -y * 0.93, h * 0.04], [x - depth * 0.5, y * 0.93, h * 0.96], COOL_BULB);
            b.block("mirror", [x - depth * 0.25, -y, 0.0], [x, y, h], MIRROR);
        }
        2 => {
            let outline = oblong((y, h / 2.0), y.min(h / 2.0) * b.vary(0.2, 0.98));
            let rim = b.choose(&[b.style.tap, BLACK_METAL, b.style.wood]);
            let inner: Vec<_> = outline.iter().map(|p| (p.0 * 0.96, p.1 * 0.97)).collect();
            b.prism("frame", Axis::X, [-x, 0.0, h / 2.0], &outline, depth * 0.7, rim);
            b.prism("mirror", Axis::X, [x - depth * 0.31, 0.0, h / 2.0], &inner, depth * 0.31, MIRROR);
        }
        3 => {
            let low = h * 0.06;
            b.block("mirror", [-x, -y, low], [-x + depth * 0.4, y, h], MIRROR);
            b.block("shelf", [-x, -y, 0.0], [x, y, low], b.style.tap);
        }
        _ => {
            let w = y * 0.1;
            b.block("mirror", [-x, -y, 0.0], [x - depth * 0.2, y, h], MIRROR);
            for cy in [-y + w * 1.2, y - w * 1.2] {
                b.block("light", [x - depth * 0.21, cy - w * 0.4, h * 0.1], [x, cy + w * 0.4, h * 0.9], COOL_BULB);
            }
        }
    }
}

/// The length of the cloth that hangs from a bar on a wall, metres.
const OVER_BAR: f32 = 0.6;

/// Bars on the wall: one, two, a shelf of bars over hooks, or a ladder.
pub(super) fn towel_rack(b: &mut Build<'_>) {
    let u = fit(b, [0.048, 0.352, 0.048]);
    let (x, y, h) = half_dims(b);
    let tap = b.style.tap;
    let r = (0.009 * u).min(h * 0.3).min(x * 0.4);
    if h > 0.3 {
        return ladder(b, r);
    }
    let bars = if x > 0.06 { b.rng.count(2, 3) } else { 1 };
    let z = h - r;
    let arm = (z - r * 1.2).max(r * 1.6);
    for cy in [-y + r * 1.6, y - r * 1.6] {
        b.lathe_along("rosette", [-x, cy, arm], [x, cy, arm], &[(r * 1.6, 0.0), (r * 1.4, r)], tap);
        b.rod("arm", [-x, cy, arm], [x - r, cy, arm], r * 0.8, tap);
        if h > 0.1 {
            b.rod("arm", [-x + r, cy, r], [-x + r, cy, z], r * 0.8, tap);
        }
    }
    for i in 0..bars {
        let cx = x - r - 2.0 * (x - r) * 0.8 * i as f32 / bars as f32;
        b.rod("bar", [cx, -y, z], [cx, y, z], r, tap);
    }
    let deep = x * 0.7;
    let (cx, deep) = if bars > 1 { (x - deep - r * 0.2, deep) } else { (x - r, r) };
    b.top("bars", [cx, 0.0, h], (deep, y - r * 4.0));
    for (name, side) in [("bar_left", -y / 2.0), ("bar_right", y / 2.0)] {
        b.hook(name, [x - r, side, z - r], OVER_BAR);
    }
    if h > 0.1 {
        let low = r;
        b.rod("bar", [-x + r, -y, low], [-x + r, y, low], r, tap);
        for i in 0..3 {
            let cy = y * 0.5 * (i as f32 - 1.0);
            b.bar("hook", [-x + r, cy, low + r * 0.5], [-x + r * 4.0, cy, low + r * 1.2], r * 0.5, tap);
            b.hook(&format!("hook_{}", i + 1), [-x + r * 4.0, cy, low], 0.5);
        }
    }
}

/// A ladder of bars in front of the wall, whose top bars form a shelf.
fn ladder(b: &mut Build<'_>, r: f32) {
    let (x, y, h) = half_dims(b);
    let mat = b.choose(&[b.style.tap, b.style.wood, IRON]);
    for cy in [-y + r, y - r] {
        b.block("side", [x - 3.0 * r, cy - r, 0.0], [x - r, cy + r, h - r * 0.5], mat);
        for z in [h * 0.12, h - r * 2.0] {
            b.rod("mount", [-x, cy, z], [x - 2.0 * r, cy, z], r * 0.8, mat);
        }
    }
    let count = (h / 0.18).round().clamp(2.0, 5.0) as usize;
    for i in 0..count {
        let z = h * (0.12 + 0.8 * i as f32 / count as f32);
        b.rod("bar", [x - r * 0.9, -y, z], [x - r * 0.9, y, z], r * 0.9, mat);
        let drop = if i == 0 { z } else { h * 0.8 / count as f32 } - 2.5 * r;
        b.hook(&format!("bar_{}", i + 1), [x - r * 0.9, 0.0, z - r], drop);
    }
    for i in 0..3 {
        let cx = -x + r + (2.0 * x - 3.0 * r) * i as f32 / 2.0;
        b.rod("bar", [cx, -y + r, h - r], [cx, y - r, h - r], r * 0.9, mat);
    }
    b.top("bars", [0.0, 0.0, h], ((x - r).max(r), y - r * 3.0));
}

/// Horizontal tubes between two upright ones, in groups, with a valve below.
pub(super) fn heated_towel_rail(b: &mut Build<'_>) {
    let u = fit(b, [0.064, 0.32, 0.56]);
    let (x, y, h) = half_dims(b);
    let mat = b.choose(&[CHROME, WHITE_METAL, BLACK_METAL, CHROME]);
    let flat = b.rng.chance(0.4);
    let r = 0.012 * u;
    let post = 0.016 * u;
    // Towel bars protrude in front of the rungs.
    let front = x - 0.03 * u;
    for cy in [-y + post, y - post] {
        b.block("post", [front - 2.0 * post, cy - post, 0.02 * u], [front - r * 0.2, cy + post, h], mat);
        for z in [h * 0.12, h * 0.88] {
            b.rod("mount", [-x, cy, z], [front - post, cy, z], 0.012 * u, mat);
        }
        b.rod("valve", [front - post, cy, 0.0], [front - post, cy, 0.03 * u], 0.011 * u, CHROME);
    }
    let rungs = (h / 0.06).clamp(6.0, 22.0) as usize;
    let group = b.rng.count(4, 6);
    let step = (h - 0.08 * u) / rungs as f32;
    for i in (0..rungs).filter(|i| i % (group + 1) != group) {
        let z = 0.06 * u + step * i as f32;
        if flat {
            b.block("rung", [front - r * 0.4, -y + 0.002 * u, z - r], [front + r, y - 0.002 * u, z + r], mat);
        } else {
            b.rod("rung", [front, -y + 0.002 * u, z], [front, y - 0.002 * u, z], r, mat);
        }
    }
    for i in 0..3 {
        let z = 0.06 * u + step * (group + (group + 1) * i) as f32;
        if z < h - step {
            let (out, wide, thin) = (x - 0.0065 * u, y * 0.7, 0.006 * u);
            let bar = [[front - r, -wide, z], [out, -wide, z], [out, wide, z], [front - r, wide, z]];
            b.pipe("bar", &bar, thin, mat);
            for cy in [-wide, wide] {
                b.block("stem", [front - post, cy - thin, z - step], [front - r * 0.3, cy + thin, z + step], mat);
            }
            b.hook(
                &format!("rod_{}", i + 1),
                [out, 0.0, z - thin],
                (z - 0.02 * u).min(step * (group + 1) as f32) - 0.02 * u,
            );
        }
    }
    let last = (0..rungs).rev().find(|i| i % (group + 1) != group).unwrap_or(0);
    b.top("rod", [front, 0.0, 0.06 * u + step * last as f32 + r], (r * 0.6, y - post * 2.2));
}

/// Wire baskets one below the other, to hang in a shower.
pub(super) fn shower_caddy(b: &mut Build<'_>) {
    let u = fit(b, [0.096, 0.192, 0.128]);
    let (x, y, h) = half_dims(b);
    let metal = b.choose(&[CHROME, STEEL, BLACK_METAL, WHITE_METAL]);
    let w = 0.005 * u;
    let count = (h / 0.24).round().clamp(1.0, 3.0) as usize;
    let tall = (h * 0.5).min(0.06);
    let room = if count > 1 { (h * 0.9 - tall) / (count - 1) as f32 } else { h };
    let plate = b.rng.chance(0.4);
    for i in 0..count {
        let z = room * i as f32 * 0.9;
        let (low, high) = ([-x, -y, z], [x, y, z + tall]);
        if plate {
            pit(b, "basket", low, high, w, metal);
        } else {
            rack(b, low, [x, y, z + w], 9, metal);
            for top in [z + tall * 0.5, z + tall] {
                plate_with_hole(
                    b,
                    "wire",
                    Axis::Z,
                    ([-x, -y, top - w], [x, y, top]),
                    ((-x + w, -y + w), (x - w, y - w)),
                    metal,
                );
            }
            for (cx, cy) in [(-x, -y), (-x, y - w), (x - w, -y), (x - w, y - w), (x - w, -w / 2.0)] {
                b.block("post", [cx, cy, z + w], [cx + w, cy + w, z + tall - w], metal);
            }
        }
        let clear = if i + 1 < count { room * 0.9 - w - 0.004 * u } else { (h - z - w).max(0.1) };
        let ledge = if i + 1 == count { 0.02 * u } else { 0.0 };
        let middle = [-ledge / 2.0, 0.0, z + w];
        b.inside(&format!("shelf_{}", i + 1), middle, (x - w * 2.0 - ledge / 2.0, y - w * 2.0), clear);
        if i + 1 == count {
            // A soap ledge along the front.
            b.block("ledge", [x - ledge, -y + w * 0.5, z + tall - w], [x - w * 0.1, y - w * 0.5, z + tall], metal);
            b.top("rim", [x - ledge / 2.0, 0.0, z + tall], (ledge / 2.0, y * 0.8));
        }
    }
    if h > tall * 1.5 {
        for cy in [-y * 0.4, y * 0.4] {
            b.rod("hanger", [-x + w * 0.6, cy, 0.0], [-x + w * 0.6, cy * 0.5, h * 0.94], w * 0.4, metal);
        }
        b.rod("hanger", [-x + w * 0.6, -y * 0.22, h * 0.94], [-x + w * 0.6, y * 0.22, h * 0.94], w * 0.6, metal);
        b.bar("hook", [-x + w, 0.0, h * 0.94], [-x + w, 0.0, h - w], w, metal);
    }
    for side in [-0.6, 0.6] {
        b.bar("hook", [x - w, y * side, w * 1.5], [x - w, y * side, w * 0.9], w * 0.7, metal);
        b.hook(if side < 0.0 { "hook_1" } else { "hook_2" }, [x - w, y * side, 0.0], 0.3);
    }
}
