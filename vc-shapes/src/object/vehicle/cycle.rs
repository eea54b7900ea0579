//! Two-wheelers: bicycles, motorcycles and scooters.

use std::f32::consts::FRAC_PI_2;

use super::wheel::{fender, hub, nuts, spoked};
use crate::material::*;
use crate::solid::{Axis, Build, P, at_least, limb, mix, polar, tapered_tub};

const PAINTS: &[MaterialId] =
    &[RED_METAL, BLUE_METAL, BLACK_METAL, GREEN_METAL, WHITE_METAL, YELLOW_METAL, SILVER_METAL, ORANGE, NAVY, SAGE];

/// A bicycle: a sports or city bicycle, with a motor, or with a box in front.
pub(super) fn bicycle(b: &mut Build<'_>) {
    at_least(b, [0.8, 0.22, 0.48]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let cargo = b.class == "cargo_bike";
    let town = cargo || b.rng.chance(0.5);
    let frame = b.one_of(PAINTS);
    let tyre = (b.vary(0.012, 0.028) * h.min(1.2)).min(y * 0.1);
    let r = (h * b.vary(0.3, 0.325)).min(x * 0.38);
    let front_r = if cargo { r * 0.75 } else { r };
    let (rear, fore) = (-x + r, x - front_r);
    let rim = b.choose(&[ALUMINIUM, BLACK_METAL, STEEL]);
    spoked(b, "wheel_r", [rear, 0.0, r], r, tyre, false, rim);
    spoked(b, "wheel_f", [fore, 0.0, front_r], front_r, tyre, false, rim);
    // Points of the frame: bottom bracket, seat, head.
    let tube = (h * b.vary(0.015, 0.022)).max(0.006);
    let base = rear + (fore - rear) * if cargo { 0.27 } else { b.vary(0.4, 0.44) };
    let base = base.max(rear + r * 1.28 + tube);
    let pedal: P = [base, 0.0, r * 0.85];
    let saddle: P = [base - r * 0.45, 0.0, h * b.vary(0.86, 0.95)];
    let bar_z = h - 0.02;
    let box_end = fore - front_r * 1.5;
    let head: P =
        if cargo { [(base + r * 1.05).min(box_end - 0.28), 0.0, h * 0.78] } else { [fore - r * 0.62, 0.0, h * 0.84] };
    let rod = |b: &mut Build<'_>, name: &str, from: P, to: P, share: f32, mat: MaterialId| {
        b.rod(name, from, to, tube * share, mat)
    };
    let cluster = mix(pedal, saddle, if town { 0.62 } else { 0.78 });
    rod(b, "seat_tube", pedal, cluster, 1.0, frame);
    rod(b, "seat_post", cluster, saddle, 0.7, STEEL);
    let down = [head[0] + (if cargo { 0.0 } else { r * 0.06 }), 0.0, head[2] - r * 0.35];
    if town {
        let low = mix(pedal, saddle, b.vary(0.2, 0.4));
        rod(b, "top_tube", low, mix(head, down, 0.4), 0.9, frame);
    } else {
        rod(b, "top_tube", cluster, mix(head, down, 0.2), 0.9, frame);
    }
    rod(b, "down_tube", pedal, down, 1.15, frame);
    rod(b, "head_tube", head, down, 1.2, frame);
    let spread = hub(tyre, false) + tube * 0.7 + 0.002;
    for side in [-spread, spread] {
        rod(b, "stay", [pedal[0], side * 0.85, pedal[2]], [rear, side, r], 0.6, frame);
        rod(b, "stay", [cluster[0], side * 0.8, cluster[2]], [rear, side, r], 0.5, frame);
        let crown = if cargo {
            [fore - front_r * 0.35, side, front_r * 2.1]
        } else {
            [down[0] + r * 0.05, side, down[2] - 0.01]
        };
        rod(b, "fork", crown, [fore, side, front_r], 0.7, frame);
    }
    rod(b, "bridge", [cluster[0], -spread * 0.8, cluster[2]], [cluster[0], spread * 0.8, cluster[2]], 0.5, frame);
    let held = (hub(tyre, false) + 0.001, spread + tube);
    nuts(b, [rear, 0.0, r], held, tube * 0.5);
    nuts(b, [fore, 0.0, front_r], held, tube * 0.5);
    if cargo {
        cargo_bed(b, down, (fore, front_r, spread), r, frame);
    } else {
        rod(
            b,
            "crown",
            [down[0] + r * 0.03, -spread, down[2] - 0.01],
            [down[0] + r * 0.03, spread, down[2] - 0.01],
            0.8,
            frame,
        );
    }
    handlebar(b, head, (y, bar_z), tube, town);
    seat(b, saddle, (h * 0.13, (y * 0.42).min(0.08)), h);
    drive(b, pedal, [rear, 0.0, r], (r, y.min(0.17)), spread);
    for side in [-1.0, 1.0] {
        // A stand on each side keeps the bicycle upright.
        let top = mix([pedal[0], side * spread * 0.85, pedal[2]], [rear, side * spread, r], 0.15);
        kickstand(b, top, [top[0] - 0.06, side * (y * 0.75).min(0.16).max(spread * 1.3)], (tube * 0.5).max(0.004));
    }
    if town {
        fittings(b, rear, r, tyre, spread);
    }
    if b.class == "electric_bicycle" || (cargo && b.rng.chance(0.5)) {
        b.hull("battery", &limb(mix(pedal, down, 0.25), mix(pedal, down, 0.85), tube * 2.4, tube * 2.4), BLACK_PLASTIC);
        b.rod(
            "motor",
            [pedal[0], -spread * 1.4, pedal[2]],
            [pedal[0], spread * 1.4, pedal[2]],
            r * 0.22,
            BLACK_PLASTIC,
        );
        let low = [head[0] - tube, -0.034, bar_z - tube * 1.7 - 0.005];
        b.rounded_block("display", low, [head[0] + 0.044, 0.034, bar_z + 0.015], 0.005, SCREEN);
    }
}

/// Mudguards, a rack, a lamp and reflectors of city bicycles.
fn fittings(b: &mut Build<'_>, rear: f32, r: f32, tyre: f32, spread: f32) {
    let z = 2.0 * r + tyre * 0.6 + 0.015;
    for side in [-1.0, 1.0] {
        b.rod("rack", [rear, side * spread, r], [rear - r * 0.4, side * spread * 1.8, z], 0.005, STEEL);
        b.rod(
            "rack",
            [rear - r * 0.75, side * spread * 1.8, z],
            [rear + r * 0.5, side * spread * 1.8, z],
            0.005,
            STEEL,
        );
    }
    for dx in [-0.7, -0.2, 0.4] {
        b.rod("rack", [rear + r * dx, -spread * 1.8, z], [rear + r * dx, spread * 1.8, z], 0.004, STEEL);
    }
    let back = rear - r * 0.7;
    b.block("reflector", [back - 0.02, -0.025, z - 0.05], [back - 0.002, 0.025, z + 0.003], SIGNAL_RED);
}

fn handlebar(b: &mut Build<'_>, head: P, (y, z): (f32, f32), tube: f32, town: bool) {
    let thin = tube * 0.7;
    let (y, z) = (y - thin * 1.1, z - thin);
    let stem = [head[0] - tube, 0.0, z - tube];
    b.bar("stem", head, stem, thin, STEEL);
    let grip = b.choose(&[RUBBER, BROWN_LEATHER, BLACK_PLASTIC]);
    for side in [-1.0, 1.0] {
        let (bend, tip) = if town {
            ([head[0] + 0.05, side * y * 0.55, z], [head[0] - 0.12, side * y, z - 0.02])
        } else {
            ([head[0] + 0.04, side * y * 0.5, z], [head[0] + 0.03, side * y, z])
        };
        b.pipe("handlebar", &[stem, bend, tip], thin * 0.8, STEEL);
        b.rod("grip", mix(bend, tip, 0.45), tip, thin * 1.1, grip);
        let lever = mix(bend, tip, 0.4);
        b.rod("brake", lever, [lever[0] + 0.05, side * y * 0.9, z - 0.02], 0.005, IRON);
    }
    b.rod(
        "headlight",
        [head[0] + tube * 0.5, 0.0, head[2]],
        [head[0] + tube + 0.05, 0.0, head[2]],
        0.025_f32.min(tube * 2.0),
        COOL_BULB,
    );
}

fn seat(b: &mut Build<'_>, at: P, (long, half): (f32, f32), h: f32) {
    let leather = b.choose(&[BLACK_LEATHER, BROWN_LEATHER, TAN_LEATHER]);
    let z = at[2].min(h - 0.01);
    let points = [
        [at[0] - long, half, z - 0.02],
        [at[0] - long, -half, z - 0.02],
        [at[0] - long * 0.9, half * 0.8, z + 0.01],
        [at[0] - long * 0.9, -half * 0.8, z + 0.01],
        [at[0] + long, half * 0.25, z - 0.02],
        [at[0] + long, -half * 0.25, z - 0.02],
        [at[0] + long * 0.8, 0.0, z + 0.005],
        [at[0] - long * 0.5, 0.0, z - 0.06],
    ];
    b.hull("saddle", &points, leather);
    b.top("saddle", [at[0] - long * 0.5, 0.0, z + 0.01], (long * 0.35, half * 0.7));
}

/// Chainring, chain, cranks and pedals.
fn drive(b: &mut Build<'_>, pedal: P, hub: P, (r, y): (f32, f32), spread: f32) {
    let at = -spread * 1.1;
    b.rod("chainring", [pedal[0], at - 0.004, pedal[2]], [pedal[0], at + 0.004, pedal[2]], r * 0.27, STEEL);
    b.rod("sprocket", [hub[0], at - 0.004, hub[2]], [hub[0], at + 0.004, hub[2]], r * 0.13, STEEL);
    for side in [-1.0, 1.0] {
        let rise = if side > 0.0 { r * 0.27 } else { r * 0.13 };
        b.rod(
            "chain",
            [pedal[0], at, pedal[2] + rise * if side > 0.0 { 0.95 } else { -1.9 }],
            [hub[0], at, hub[2] + side * r * 0.12],
            0.004,
            IRON,
        );
        let (cy, dx) = (side * spread * 1.7, side * r * 0.5);
        b.rod("crank", [pedal[0], cy, pedal[2]], [pedal[0] + dx, cy, pedal[2]], 0.009, ALUMINIUM);
        let out = side * (y - 0.005);
        b.block(
            "pedal",
            [pedal[0] + dx - 0.035, out.min(cy), pedal[2] - 0.012],
            [pedal[0] + dx + 0.035, out.max(cy), pedal[2] + 0.012],
            BLACK_PLASTIC,
        );
    }
    b.rod("bracket", [pedal[0], -spread * 1.8, pedal[2]], [pedal[0], spread * 1.8, pedal[2]], 0.016, ALUMINIUM);
}

/// A kickstand with a flat foot.
fn kickstand(b: &mut Build<'_>, top: P, [x, y]: [f32; 2], r: f32) {
    b.rod("stand", top, [x, y, r * 0.6 + 0.003], r, IRON);
    b.block("foot", [x - r * 2.0, y - r * 1.5, 0.0], [x + r * 2.0, y + r * 1.5, r + 0.004], IRON);
}

/// The box of a cargo bike between the handlebar and the front wheel, and the beam that supports
/// the box and rises behind the wheel to the fork.
fn cargo_bed(b: &mut Build<'_>, down: P, (fore, front_r, spread): (f32, f32, f32), r: f32, frame: MaterialId) {
    let y = b.size.y / 2.0;
    let (low, x0) = (r * 0.55, down[0] + 0.06);
    let x1 = (fore - front_r * 1.5).max(x0 + 0.1);
    let (middle, half) = ((x0 + x1) / 2.0, (x1 - x0) / 2.0);
    let tall = (b.size.z * b.vary(0.32, 0.42)).max(0.1);
    let mat = b.choose(&[BIRCH, OAK, PINE, BLACK_PLASTIC, frame]);
    let wide = (y * 0.82, y * 0.95);
    tapered_tub(b, "box", [middle, 0.0, low], (half * 0.85, wide.0), (half, wide.1), tall, 0.015, mat);
    b.inside("compartment", [middle, 0.0, low + 0.015], (half * 0.85 - 0.03, wide.0 - 0.03), tall + 0.2);
    let beam = 0.02_f32.min(front_r * 0.08);
    let under = low - beam * 0.5;
    let crown: P = [fore - front_r * 0.35, 0.0, front_r * 2.1];
    let knee: P = [fore - front_r * 1.4, 0.0, front_r * 1.35];
    b.pipe("beam", &[down, [down[0] + 0.02, 0.0, under], [knee[0], 0.0, under], knee, crown], beam, frame);
    b.rod("crown", [crown[0], -spread, crown[2]], [crown[0], spread, crown[2]], beam, frame);
}

/// A motorcycle: engine, tank, seat, fork, exhaust; a locker under the seat.
pub(super) fn motorcycle(b: &mut Build<'_>) {
    at_least(b, [1.0, 0.38, 0.52]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let paint = b.one_of(PAINTS);
    let r = (h * b.vary(0.25, 0.275)).min(x * 0.36);
    let tyre = (r * b.vary(0.17, 0.23)).min(y * 0.17);
    let cast = b.rng.chance(0.6);
    let (rear, fore) = (-x + r + 0.02, x - r);
    let rim = b.choose(&[ALUMINIUM, BLACK_METAL, CHROME]);
    spoked(b, "wheel_r", [rear, 0.0, r], r, tyre, cast, rim);
    spoked(b, "wheel_f", [fore, 0.0, r], r, tyre * 0.85, cast, rim);
    let head: P = [fore - r * b.vary(0.7, 0.95), 0.0, h * 0.82];
    let held = (hub(tyre * 0.85, cast), hub(tyre, cast));
    let (fork, arm) = (held.0 + 0.022 * h + 0.003, held.1 + 0.024 * h + 0.003);
    let waist = h * 0.66;
    let deep = waist - 2.0 * r - 0.022;
    let shock = waist - deep - 0.012 * h;
    for side in [-1.0, 1.0] {
        let (f, a) = (side * fork, side * arm);
        b.rod("fork", [head[0], f, head[2]], [fore, f, r], 0.022 * h, CHROME);
        b.rod("swing_arm", [rear + r * 1.3, a, r * 1.05], [rear, a, r], 0.024 * h, IRON);
        b.rod("shock", [rear + r * 0.3, a, r * 1.1], [rear + r * 0.75, a * 0.95, shock], 0.018 * h, CHROME);
    }
    b.rod("mount", [rear + r * 0.75, -arm, shock], [rear + r * 0.75, arm, shock], 0.014 * h, IRON);
    b.rod("yoke", [head[0], -fork, head[2] - 0.02], [head[0], fork, head[2] - 0.02], 0.03 * h, IRON);
    nuts(b, [fore, 0.0, r], (held.0 + 0.001, fork + 0.024 * h), 0.012);
    nuts(b, [rear, 0.0, r], (held.1 + 0.001, arm + 0.026 * h), 0.012);
    let (mid0, mid1) = (rear + r * 1.15, fore - r * 1.2);
    let motor = (waist * 0.82).min(waist - deep - 0.005);
    b.rounded_block("engine", [mid0, -y * 0.4, r * 0.45], [mid1, y * 0.4, motor], 0.04, GALVANISED);
    for i in 0..4 {
        let z = motor * (0.62 + 0.09 * i as f32);
        b.block("fin", [mid0 + (mid1 - mid0) * 0.35, -y * 0.46, z], [mid1 - 0.02, y * 0.46, z + 0.015], ALUMINIUM);
    }
    let tank = [(mid0 + mid1) / 2.0 - r * 0.2, head[0] - 0.02];
    let top = h * b.vary(0.76, 0.82);
    let outline: Vec<P> = [1.0, -1.0]
        .into_iter()
        .flat_map(|s| {
            [
                [tank[0], s * y * 0.25, waist],
                [tank[1], s * y * 0.3, waist + 0.06],
                [tank[0], s * y * 0.22, waist + 0.09],
                [tank[1] - 0.05, s * y * 0.36, top - 0.06],
                [tank[1] - 0.1, s * y * 0.18, top],
                [tank[1], s * y * 0.12, top - 0.04],
            ]
        })
        .collect();
    b.hull("tank", &outline, paint);
    b.rod("frame", [tank[0] + 0.035 * h, 0.0, waist], [head[0], 0.0, head[2] - 0.04], 0.035 * h, IRON);
    let post = tank[0] + 0.04 * h;
    b.rod("frame", [post, 0.0, motor - 0.02], [post, 0.0, waist + 0.03], 0.03 * h, IRON);
    b.rod("frame", [mid1, 0.0, r * 0.6], [head[0], 0.0, head[2] - 0.08], 0.028 * h, IRON);
    locker_seat(b, (rear - r * 0.3, tank[0] - 0.003), (waist, y * 0.32), deep, paint);
    fender(b, [fore, 0.0, r], (r, held.0 + 0.004), (0.7, 2.6), paint);
    fender(b, [rear, 0.0, r], (r, tyre * 1.1), (1.0, 2.7), paint);
    let lamp = 0.085 * h;
    b.lathe_along(
        "headlight",
        [head[0] + 0.02, 0.0, head[2]],
        [head[0] + 1.0, 0.0, head[2]],
        &[(lamp * 0.5, 0.0), (lamp, lamp * 0.8)],
        IRON,
    );
    b.rod(
        "headlight",
        [head[0] + 0.02 + lamp * 0.8, 0.0, head[2]],
        [head[0] + 0.03 + lamp * 0.8, 0.0, head[2]],
        lamp * 0.9,
        COOL_BULB,
    );
    bars(b, head, y, h);
    if b.rng.chance(0.5) {
        let screen = [
            [head[0] + 0.05, -y * 0.3, head[2] + 0.05],
            [head[0] + 0.05, y * 0.3, head[2] + 0.05],
            [head[0] - 0.02, y * 0.2, h - 0.002],
            [head[0] - 0.02, -y * 0.2, h - 0.002],
        ];
        let points: Vec<P> = screen.iter().flat_map(|p| [*p, [p[0] - 0.008, p[1], p[2]]]).collect();
        b.hull("windshield", &points, CLEAR_PLASTIC);
    }
    for side in [-1.0, 1.0] {
        let cy = side * y * 0.48;
        b.lathe_along(
            "exhaust",
            [mid1, cy, r * 0.5],
            [rear - r * 0.5, cy, r * 0.75],
            &[(0.02, 0.0), (0.02, (mid1 - rear) * 0.5), (0.045 * h, (mid1 - rear) * 0.55), (0.04 * h, mid1 - rear)],
            CHROME,
        );
        b.rod("peg", [mid0 + 0.05, side * y * 0.3, r * 0.6], [mid0 + 0.05, side * y * 0.62, r * 0.6], 0.015, RUBBER);
        kickstand(b, [mid0 + 0.02, side * y * 0.3, r * 0.6], [mid0 - 0.01, side * y * 0.55], 0.012);
    }
}

/// A seat that is the lid of a small locker.
fn locker_seat(b: &mut Build<'_>, (x0, x1): (f32, f32), (z, half): (f32, f32), deep: f32, paint: MaterialId) {
    let thick = b.size.z * 0.055;
    let (low, t) = (z - deep, 0.008);
    let middle = (x0 + x1) / 2.0;
    tapered_tub(
        b,
        "locker",
        [middle, 0.0, low],
        ((x1 - x0) / 2.0 * 0.85, half * 0.8),
        ((x1 - x0) / 2.0 * 0.95, half * 0.9),
        deep - 0.002,
        t,
        paint,
    );
    b.inside(
        "compartment",
        [middle, 0.0, low + t],
        (((x1 - x0) / 2.0 * 0.85 - 0.025).max(0.01), (half * 0.8 - 0.025).max(0.01)),
        deep - t - 0.006,
    );
    let leather = b.choose(&[BLACK_LEATHER, BROWN_LEATHER, BLACK_LEATHER]);
    b.hinge([x1, 0.0, z + thick], [0.0, 1.0, 0.0], FRAC_PI_2 * 0.9, |b| {
        b.rounded_block("seat", [x0, -half, z - 0.0035], [x1, half, z + thick], 0.02, leather);
        b.top("seat", [middle, 0.0, z + thick], ((x1 - x0) / 2.0 * 0.8, half * 0.8));
    });
    let inset = (x1 - x0) * 0.06;
    b.block("tail_light", [x0 - 0.02, -half * 0.5, z - 0.05], [x0 + inset, half * 0.5, z - 0.01], SIGNAL_RED);
}

/// Handlebar with grips, mirrors and a dial.
fn bars(b: &mut Build<'_>, head: P, y: f32, h: f32) {
    let z = (head[2] + 0.05).min(h - 0.06);
    let tip = y - 0.02;
    for side in [-1.0, 1.0] {
        b.pipe(
            "handlebar",
            &[
                [head[0], 0.0, head[2]],
                [head[0] - 0.02, side * tip * 0.4, z],
                [head[0] - 0.08, side * tip * 0.95, z - 0.01],
            ],
            0.012,
            IRON,
        );
        b.rod(
            "grip",
            [head[0] - 0.045, side * tip * 0.65, z - 0.005],
            [head[0] - 0.09, side * tip, z - 0.012],
            0.018,
            RUBBER,
        );
        b.rod(
            "mirror",
            [head[0] - 0.03, side * tip * 0.55, z],
            [head[0] - 0.02, side * tip * 0.75, h - 0.05],
            0.006,
            IRON,
        );
        b.rounded_block(
            "mirror",
            [head[0] - 0.03, side * tip * 0.75 - 0.05, h - 0.06],
            [head[0] - 0.01, side * tip * 0.75 + 0.05, h],
            0.008,
            BLACK_PLASTIC,
        );
        b.ball("indicator", [head[0] + 0.03, side * tip * 0.3, head[2]], 0.022, SIGNAL_AMBER);
    }
    b.rod("yoke", [head[0] + 0.03, -tip * 0.3, head[2]], [head[0] + 0.03, tip * 0.3, head[2]], 0.008, IRON);
}

/// A motor scooter: leg shield, footboard, a locker under the seat.
pub(super) fn scooter(b: &mut Build<'_>) {
    at_least(b, [0.85, 0.32, 0.52]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (paint, r) = (b.one_of(PAINTS), (h * b.vary(0.18, 0.21)).min(x * 0.28));
    let tyre = r * 0.24;
    let (rear, fore) = (-x + r + 0.04, x - r);
    spoked(b, "wheel_r", [rear, 0.0, r], r, tyre, true, ALUMINIUM);
    spoked(b, "wheel_f", [fore, 0.0, r], r, tyre, true, ALUMINIUM);
    let head: P = [fore - r * 1.2, 0.0, h * 0.83];
    let held = hub(tyre, true);
    let leg = 0.018_f32.min(r * 0.08);
    let fork = held + leg + 0.003;
    for side in [-fork, fork] {
        b.rod("fork", [head[0] + 0.06, side, h * 0.42], [fore, side, r], leg, STEEL);
    }
    nuts(b, [fore, 0.0, r], (held + 0.001, fork + leg), 0.012);
    b.rod("column", [head[0], 0.0, head[2]], [head[0] + 0.08, 0.0, h * 0.38], 0.03, paint);
    fender(b, [fore, 0.0, r], (r, fork), (0.5, 2.5), paint);
    let (floor, back) = (r * 1.05, rear + (fore - rear) * 0.46);
    let shield: Vec<P> = [1.0, -1.0]
        .into_iter()
        .flat_map(|s| {
            [
                [head[0] - 0.06, s * y * 0.5, floor],
                [head[0] - 0.02, s * y * 0.5, floor],
                [head[0] - 0.01, s * y * 0.72, h * 0.55],
                [head[0] + 0.04, s * y * 0.7, h * 0.55],
                [head[0] + 0.02, s * y * 0.35, head[2] - 0.03],
                [head[0] + 0.1, s * y * 0.2, h * 0.5],
            ]
        })
        .collect();
    b.hull("shield", &shield, paint);
    b.rounded_block("footboard", [back - 0.05, -y * 0.62, floor - 0.07], [head[0], y * 0.62, floor], 0.02, GREY_RUBBER);
    let seat_z = h * b.vary(0.6, 0.66);
    let deep = b.size.z * 0.1;
    let under = seat_z - deep - 0.004;
    for side in [-1.0, 1.0] {
        // A side panel on either side of the wheel.
        let (inner, outer) = (side * (held + 0.002), side * y * 0.62);
        let tail = [
            [back, inner, floor - 0.06],
            [back, inner, under],
            [-x + 0.02, inner, under],
            [-x + 0.1, inner, r * 1.4],
            [rear, inner, r * 0.85],
            [back, side * y * 0.45, floor - 0.06],
            [back, side * y * 0.4, under],
            [-x + 0.02, side * y * 0.3, under],
            [-x + 0.1, outer, r * 1.4],
            [back - 0.1, outer, r * 1.1],
            [rear, outer, r * 2.05],
        ];
        b.hull("tail", &tail, paint);
    }
    let above = (2.0 * r + 0.012).min(under - 0.01);
    b.block("tail", [-x + 0.06, -held - 0.01, above], [back - 0.003, held + 0.01, under + 0.003], paint);
    b.block(
        "tail",
        [(rear + r + 0.015).min(back - 0.02), -held - 0.01, floor - 0.05],
        [back - 0.002, held + 0.01, under],
        paint,
    );
    locker_seat(b, (-x + 0.06, back), (seat_z, y * 0.42), deep, paint);
    let lamp = 0.06 * h;
    b.rounded_block(
        "head",
        [head[0] - 0.06, -y * 0.35, head[2] - 0.05],
        [head[0] + 0.09, y * 0.35, head[2] + 0.07],
        0.04,
        paint,
    );
    b.rod("headlight", [head[0] + 0.07, 0.0, head[2]], [head[0] + 0.1, 0.0, head[2]], lamp, COOL_BULB);
    bars(b, head, y, h);
    for side in [-1.0, 1.0] {
        kickstand(b, [back - 0.03, side * y * 0.35, floor - 0.04], [back - 0.06, side * y * 0.5], 0.012);
    }
    b.lathe_along(
        "exhaust",
        [back - 0.1, -y * 0.6, r * 1.1],
        [-x + 0.1, -y * 0.6, r * 1.25],
        &[(0.02, 0.0), (0.05, 0.08), (0.05, (rear - -x) + 0.1), (0.02, (rear - -x) + 0.12)],
        CHROME,
    );
}

/// An electric scooter: a deck, a folding column and a bar.
pub(super) fn electric_scooter(b: &mut Build<'_>) {
    at_least(b, [0.5, 0.2, 0.5]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let paint = b.choose(&[BLACK_METAL, ANTHRACITE, WHITE_METAL, GREEN_METAL, ORANGE, SILVER_METAL]);
    let r = x * b.vary(0.17, 0.21);
    let tyre = r * 0.24;
    let (rear, fore) = (-x + r, x - r);
    spoked(b, "wheel_r", [rear, 0.0, r], r, tyre, true, ANTHRACITE);
    spoked(b, "wheel_f", [fore, 0.0, r], r, tyre, true, ANTHRACITE);
    let (deck, wide) = (r * 1.05, (y * 0.42).min(0.09));
    b.rounded_block("deck", [rear + r * 1.2, -wide, deck - r * 0.5], [fore - r * 1.3, wide, deck], 0.015, paint);
    b.block(
        "grip_tape",
        [rear + r * 1.4, -wide * 0.8, deck - 0.004],
        [fore - r * 1.5, wide * 0.8, deck + 0.002],
        RUBBER,
    );
    let (held, leg) = (hub(tyre, true), 0.014_f32.min(r * 0.13));
    let fork = held + leg + 0.003;
    let steer = fore - r * 0.6;
    fender(b, [rear, 0.0, r], (r, fork), (-0.2, 2.2), paint);
    fender(b, [fore, 0.0, r], (r, fork), (1.2, 2.5), paint);
    for side in [-fork, fork] {
        b.rod("fork", [steer, side, r * 2.4], [fore, side, r], leg, paint);
        b.rod("arm", [rear + r * 1.4, side, deck - r * 0.25], [rear, side, r], leg, paint);
    }
    for x in [rear, fore] {
        nuts(b, [x, 0.0, r], (held + 0.001, fork + leg * 1.2), leg * 0.8);
    }
    b.rod("neck", [fore - r * 1.6, 0.0, deck - r * 0.25], [steer, 0.0, r * 2.45], r * 0.18, paint);
    b.rod("crown", [steer, -fork, r * 2.4], [steer, fork, r * 2.4], r * 0.17, paint);
    let top: P = [steer - r * 0.4, 0.0, h - 0.02];
    let (tip, thick, fold) = (y - 0.004, 0.02, r * 2.7);
    b.cylinder("clamp", [steer, 0.0, r * 2.4], thick * 1.15, r * 0.3 - 0.001, BLACK_PLASTIC);
    // The column folds back to the deck over the edge of the clamp.
    b.hinge([steer - thick * 1.2, 0.0, fold], [0.0, -1.0, 0.0], 1.25, |b| {
        b.rod("column", [steer, 0.0, fold + 0.001], top, thick, paint);
        b.rod("handlebar", [top[0], -tip, top[2]], [top[0], tip, top[2]], 0.013, IRON);
        for side in [-1.0, 1.0] {
            b.rod("grip", [top[0], side * tip * 0.55, top[2]], [top[0], side * tip, top[2]], 0.018, RUBBER);
            b.rod(
                "brake",
                [top[0], side * tip * 0.5, top[2]],
                [top[0] + 0.04, side * tip * 0.85, top[2] - 0.01],
                0.005,
                STEEL,
            );
        }
        b.rounded_block(
            "display",
            [top[0] - 0.02, -0.03, top[2] - 0.012],
            [top[0] + 0.035, 0.03, top[2] + 0.02],
            0.008,
            SCREEN,
        );
        b.rod("headlight", [top[0] + 0.01, 0.0, top[2] - 0.09], [top[0] + 0.045, 0.0, top[2] - 0.09], 0.02, COOL_BULB);
    });
    let (dx, dz) = polar(2.05, r + 0.02);
    let light: P = [rear + dx, 0.0, r + dz];
    b.block("tail_light", [light[0] - 0.01, -0.02, light[2] - 0.008], [light[0], 0.02, light[2] + 0.012], SIGNAL_RED);
    kickstand(b, [0.0, wide * 0.8, deck - r * 0.4], [-0.03, (y * 0.8).min(0.16)], tyre.min(0.008));
    b.prism(
        "plug",
        Axis::Y,
        [fore - r * 1.5, wide - 0.004, deck - r * 0.35],
        &[(0.0, 0.0), (0.03, 0.0), (0.03, 0.02), (0.0, 0.02)],
        0.008,
        RUBBER,
    );
}
