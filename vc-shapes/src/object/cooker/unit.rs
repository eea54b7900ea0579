//! Kitchen units: base and wall cabinets, counters, islands.

use super::fitting::*;
use crate::material::*;
use crate::object::joinery::{
    Fitted, Panel, Swing, cupboard_door, cupboard_doors, drawers, gapped, panel, pull_out, swing,
};
use crate::solid::{Axis, Build, P, case, fit, half_dims, plate_with_hole, tiers};

/// The height of the toe-kick.
const KICK: f32 = 0.10;

/// A base unit under a worktop, with doors, with drawers or with both.
pub(super) fn kitchen_cabinet(b: &mut Build<'_>) {
    let u = fit(b, [0.3, 0.25, 0.5]);
    let (x, y, _) = half_dims(b);
    let look = unit_look(b, u);
    let under = worktop(b, u);
    let (low, high) = ([-x, -y, KICK * u], [x - RUN * u - look.t, y, under]);
    plinth(b, low, high, u);
    fill(b, &look, low, high, u);
}

/// A unit that hangs on a wall: doors, glazed doors, a flap or open shelves.
pub(super) fn kitchen_wall_cabinet(b: &mut Build<'_>) {
    let u = fit(b, [0.2, 0.25, 0.3]);
    let (x, y, h) = half_dims(b);
    let mut look = unit_look(b, u);
    let design = b.rng.below(6);
    if design == 0 {
        look.panel = Panel::Glazed;
    }
    let high = [x - RUN * u - look.t, y, h];
    shelved(b, &look, ([-x, -y, 0.0], high));
    let front = ([high[0], -y, 0.0], [high[0] + look.t, y, h]);
    match design {
        1 if y * 2.0 > 0.45 => flap(b, &look, front),
        2 => front_rail(b, &look, front),
        _ => cupboard_doors(b, &look, front, 0.5, true),
    }
}

/// A case on a wall with shelves in it.
pub(super) fn shelved(b: &mut Build<'_>, look: &Fitted, (low, high): (P, P)) {
    case(b, low, high, look.t, look.mat);
    let spaces = ((high[2] - low[2]) / 0.3).round().clamp(1.0, 4.0) as usize;
    let mat = look.mat;
    tiers(b, "shelf", inner(low, high, look.t), spaces, look.t, |b, l, h| {
        b.block("shelf", l, [h[0] - 0.004, h[1], h[2]], mat);
    });
}

/// A length of worktop on side panels, legs or brackets, sometimes with a splashback.
pub(super) fn kitchen_counter(b: &mut Build<'_>) {
    let u = fit(b, [0.3, 0.5, 0.4]);
    let (x, y, h) = half_dims(b);
    let under = worktop(b, u);
    let (t, mat) = (0.03 * u, b.style.cabinet);
    let (front, side) = (x - 0.04 * u, y - 0.02 * u);
    let panels = (y * 2.0 / 1.3).ceil().clamp(1.0, 4.0) as usize;
    let legs = b.rng.chance(0.35);
    for i in 0..=panels {
        let cy = -side + (2.0 * side - t) * i as f32 / panels as f32;
        if legs {
            let r = 0.022 * u;
            for cx in [-x + 0.05 * u, front - 0.04 * u] {
                b.rod("leg", [cx, cy + t / 2.0, 0.0], [cx, cy + t / 2.0, under], r, STEEL);
            }
        } else {
            b.block("panel", [-x + 0.01 * u, cy, 0.0], [front, cy + t, under], mat);
        }
    }
    let rail = if legs { STEEL } else { mat };
    let depth = b.vary(0.06, 0.12) * u;
    b.block("rail", [-x + 0.02 * u, -side + t, under - depth], [-x + 0.04 * u, side - t, under], rail);
    if b.rng.chance(0.5) {
        let z = h * b.vary(0.2, 0.35);
        let pitch = (2.0 * side - t) / panels as f32;
        for i in 0..panels {
            let (y0, y1) = (-side + pitch * i as f32 + t, -side + pitch * (i + 1) as f32);
            b.block("shelf", [-x + 0.042 * u, y0, z], [front - 0.02 * u, y1, z + 0.02 * u], mat);
            let half = ((front + x) / 2.0 - 0.075 * u, (y1 - y0) / 2.0 - 0.05 * u);
            let centre = [(front - x) / 2.0, f32::midpoint(y0, y1), z + 0.02 * u];
            b.ledge(&format!("shelf_{}", i + 1), centre, half, (under - z - depth - 0.03 * u).max(0.0));
        }
    }
}

/// A free-standing block of units: drawers and doors in front; an overhang, open shelves or a plain
/// panel behind.
pub(super) fn kitchen_island(b: &mut Build<'_>) {
    let u = fit(b, [0.5, 0.7, 0.6]);
    let (x, y, _) = half_dims(b);
    let mut look = unit_look(b, u);
    if look.panel == Panel::Boards {
        look.panel = Panel::Framed;
    }
    let under = worktop(b, u);
    let bar = if b.rng.chance(0.5) && x > 0.36 { b.vary(0.2, 0.28) } else { 0.03 * u };
    let side = y - 0.03 * u;
    let (low, high) = ([-x + bar, -side, KICK * u], [x - RUN * u - look.t, side, under]);
    plinth(b, low, high, u);
    let count = (side * 2.0 / 0.65).round().clamp(1.0, 4.0);
    let step = 2.0 * side / count;
    for i in 0..count as usize {
        let from = -side + step * i as f32;
        let name = format!("unit_{}", i + 1);
        b.at([0.0, from + step / 2.0, 0.0], 0.0, |b| {
            fill_named(b, &look, [low[0], -step / 2.0, low[2]], [high[0], step / 2.0, high[2]], (u, &name));
        });
    }
    if bar > 0.1 {
        for cy in [-side + 0.1 * u, side - 0.1 * u] {
            b.prism(
                "bracket",
                Axis::Y,
                [low[0], cy - 0.01 * u, under],
                &[(0.0, 0.0), (-bar * 0.8, 0.0), (0.0, -0.16 * u)],
                0.02 * u,
                look.mat,
            );
        }
    } else {
        let from = [low[0] - 0.02 * u, -side, 0.0];
        panel(b, Panel::Slab, "back_panel", (from, [low[0], side, under]), look.mat);
    }
}

/// A plain worktop for a bathroom on a cabinet's sides, with a shelf below.
pub(in crate::object) fn bathroom_counter(b: &mut Build<'_>) {
    let u = fit(b, [0.3, 0.4, 0.5]);
    let (x, y, h) = half_dims(b);
    let under = worktop(b, u);
    let (t, mat, front) = (0.025 * u, b.style.wood, x - 0.02 * u);
    let frame = b.rng.chance(0.4);
    for cy in [-y + 0.02 * u, y - 0.02 * u - t] {
        if frame {
            rim_y(b, [-x + 0.01 * u, cy, 0.0], [front, cy + t, under], 0.03 * u, b.style.metal);
        } else {
            b.block("side", [-x + 0.01 * u, cy, 0.0], [front, cy + t, under], mat);
        }
    }
    let inside = y - 0.02 * u - t;
    for (i, z) in [h * b.vary(0.12, 0.2), h * b.vary(0.5, 0.56)].into_iter().enumerate().take(b.rng.count(1, 2)) {
        b.block("shelf", [-x + 0.02 * u, -inside, z], [front - 0.015 * u, inside, z + t], mat);
        let room = if i == 0 { h * 0.28 } else { under - z - t - 0.01 * u };
        b.ledge(&format!("shelf_{}", i + 1), [0.0, 0.0, z + t], (x - 0.03 * u, inside - 0.01 * u), room);
    }
    b.block("rail", [-x + 0.012 * u, -inside, under - 0.1 * u], [-x + 0.02 * u, inside, under], mat);
}

fn rim_y(b: &mut Build<'_>, low: P, high: P, w: f32, mat: MaterialId) {
    plate_with_hole(b, "frame", Axis::Y, (low, high), ((low[0] + w, low[2] + w), (high[0] - w, high[2] - w)), mat);
}

/// The design of units in this kitchen.
pub(super) fn unit_look(b: &mut Build<'_>, u: f32) -> Fitted {
    let mat = b.style.front;
    let t = b.vary(0.018, 0.021) * u;
    Fitted::any(b, mat, t)
}

/// The toe-kick: a board recessed under a unit whose bottom is at `low[2]`.
pub(super) fn plinth(b: &mut Build<'_>, low: P, high: P, u: f32) {
    let set = (high[0] - low[0]) * 0.1;
    b.block("plinth", [low[0] + 0.02 * u, low[1], 0.0], [high[0] - set, high[1], low[2]], b.style.front);
}

/// The interior of a case with walls `t` thick.
pub(in crate::object) fn inner(low: P, high: P, t: f32) -> (P, P) {
    ([low[0] + t, low[1] + t, low[2] + t], [high[0] - 0.002, high[1] - t, high[2] - t])
}

fn fill(b: &mut Build<'_>, look: &Fitted, low: P, high: P, u: f32) {
    fill_named(b, look, low, high, (u, ""));
}

/// A case with one of three fillings: doors in front of shelves, drawers, or a drawer above doors.
fn fill_named(b: &mut Build<'_>, look: &Fitted, low: P, high: P, (u, name): (f32, &str)) {
    let (t, tall) = (look.t, high[2] - low[2]);
    case(b, low, high, t, look.mat);
    let front = ([high[0], low[1], low[2]], [high[0] + t, high[1], high[2]]);
    let (hollow_low, hollow_high) = inner(low, high, t);
    let mat = look.mat;
    let shelf = move |b: &mut Build<'_>, l: P, h: P| b.block("shelf", l, [h[0] - 0.02 * u, h[1], h[2]], mat);
    let named = |what: &str| if name.is_empty() { what.to_owned() } else { format!("{name}_{what}") };
    match b.rng.below(5) {
        0 | 1 => {
            tiers(b, &named("shelf"), (hollow_low, hollow_high), if tall > 0.45 { 2 } else { 1 }, t, shelf);
            cupboard_doors(b, look, front, 0.6, false);
        }
        2 => {
            let split = high[2] - tall * 0.25;
            let divider = [hollow_low[0], hollow_low[1], split - t];
            b.block("divider", divider, [hollow_high[0], hollow_high[1], split], mat);
            tiers(b, &named("shelf"), (hollow_low, [hollow_high[0], hollow_high[1], split - t]), 1, t, shelf);
            cupboard_doors(b, look, (front.0, [front.1[0], front.1[1], split]), 0.6, false);
            pull_out(b, look, &named("drawer"), ([low[0] + t, low[1], split], front.1));
        }
        _ => {
            let count = b.rng.count(2, 4).min((tall / 0.12).max(1.0) as usize);
            let deep = b.vary(1.0, 1.8);
            drawers(b, look, &named("drawer"), ([low[0] + t, low[1], low[2] + t * 0.5], front.1), (count, deep));
        }
    }
}

/// A front that opens upwards.
fn flap(b: &mut Build<'_>, look: &Fitted, (low, high): (P, P)) {
    let (low, high) = gapped(low, high, look.t * 0.08);
    swing(b, Swing::Up, low, high, 1.5, |b| {
        panel(b, look.panel, "flap", (low, high), look.mat);
        let (y, z) = ((high[1] - low[1]) * 0.2, low[2] + (high[2] - low[2]) * 0.08);
        b.rod("handle", [high[0] + 0.008, -y, z], [high[0] + 0.008, y, z], 0.009 * look.t / 0.018, look.metal);
    });
}

/// Half the front closed by a door, the rest open shelves.
fn front_rail(b: &mut Build<'_>, look: &Fitted, (low, high): (P, P)) {
    let split = low[1] + (high[1] - low[1]) * b.vary(0.4, 0.55);
    cupboard_door(b, look, "door", (low, [high[0], split, high[2]]), Swing::Right, true);
}

/// The covering of a wall over a worktop: tiles of the style, or a slab of the worktop's stone.
pub(super) fn backsplash(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let mat = b.choose(&[b.style.tile, b.style.tile, b.style.worktop, WHITE_TILE]);
    b.block("tiles", [-x, -y, 0.0], [x, y, h], mat);
}
