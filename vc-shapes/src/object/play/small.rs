//! Small toys: handheld, bath and beach toys.

use vc_graph::portable::Portable;

use crate::material::*;
use crate::object::palette::*;
use crate::solid::{Axis, Build, CORNERS, Proportional, SIDES, pitched, rounded_between};

/// A free-standing spinning top on its tip: a humming top or a plain one.
pub(super) fn top(b: &mut Build<'_>) {
    let (paint, trim) = (b.one_of(PAINTS), b.one_of(PAINTS));
    let (r, h) = (b.size.x.min(b.size.y) / 2.0, b.size.z);
    let waist = b.vary(0.35, 0.5);
    let low = [(0.0, 0.0), (r * 0.12, h * 0.06), (r * 0.7, h * (waist - 0.1)), (r, h * waist)];
    let high = [(r * 0.8, h * (waist + 0.1)), (r * 0.2, h * (waist + 0.18))];
    b.lathe("body", [0.0; 3], &[low.as_slice(), &high].concat(), paint);
    let band = [(r * 0.75, h * (waist - 0.04)), (r * 1.0, h * (waist + 0.01)), (r * 0.85, h * (waist + 0.07))];
    b.lathe("band", [0.0, 0.0, h * 0.01], &band, trim);
    b.cylinder("stem", [0.0, 0.0, h * (waist + 0.15)], r * 0.1, h * (0.78 - waist), BEECH);
    let knob = r * 0.16;
    b.lathe("knob", [0.0, 0.0, h * 0.9], &[(knob * 0.6, 0.0), (knob, h * 0.05), (knob * 0.6, h * 0.1)], trim);
}

/// A yo-yo: two discs on an axle with a string and its loop.
pub(super) fn yo_yo(b: &mut Build<'_>) {
    let (paint, cap) = (b.one_of(BRIGHT), b.choose(&[YELLOW_PLASTIC, WHITE_PLASTIC, CHROME]));
    let (r, half) = (b.size.y.min(b.size.z) / 2.0, b.size.x / 2.0);
    let middle = [0.0, 0.0, r];
    for x in SIDES {
        let shape = [(r * 0.35, half * 0.1), (r, half * 0.3), (r, half * 0.6), (r * 0.75, half * 0.95)];
        b.lathe_along("half", middle, [x, 0.0, r], &shape, paint);
        b.rod("cap", middle, [x * half, 0.0, r], r * 0.5, cap);
    }
    b.rod("string", [-half * 0.12, 0.0, r], [half * 0.12, 0.0, r], r * 0.7, WHITE_COTTON);
}

/// A rattle: a handle with a ball, rings or a drum full of beads.
pub(super) fn rattle(b: &mut Build<'_>) {
    let (paint, trim) = (b.one_of(BRIGHT), b.one_of(BRIGHT));
    let r = b.size.x.min(b.size.y) / 2.0;
    let grip = r * 0.36;
    let (h, head) = (b.size.z, b.size.z - r);
    b.lathe(
        "handle",
        [0.0; 3],
        &[(grip, 0.0), (grip * 1.2, h * 0.03), (grip * 0.7, h * 0.12), (grip * 0.7, head)],
        trim,
    );
    if b.rng.chance(0.5) {
        b.ball("head", [0.0, 0.0, head], r * 0.98, paint);
        b.lathe("band", [0.0, 0.0, head - r * 0.12], &[(r, 0.0), (r, r * 0.24)], trim);
    } else {
        b.rod("drum", [-b.size.x * 0.46, 0.0, head], [b.size.x * 0.46, 0.0, head], r * 0.95, CLEAR_PLASTIC);
        for x in SIDES {
            b.rod("rim", [x * b.size.x * 0.5, 0.0, head], [x * b.size.x * 0.38, 0.0, head], r, paint);
        }
    }
    let out = 0.3 + grip / b.size.y;
    for (i, y) in [(0, out), (1, -out)] {
        b.ellipsoid("ring", [0.0, y, 0.3 + 0.08 * i as f32], [0.5, 0.3, 0.04], BRIGHT[i]);
    }
}

/// A rubber duck.
pub(super) fn duck(b: &mut Build<'_>) {
    let coat = b.choose(&[YELLOW_PLASTIC, YELLOW_PLASTIC, PINK_PLASTIC, BLUE_PLASTIC]);
    b.ellipsoid("body", [-0.1, 0.0, 0.28], [0.85, 0.98, 0.28], coat);
    b.pad("base", [-0.5, -0.42, 0.0], [0.35, 0.42, 0.08], 0.002, coat);
    b.chunk("tail", &[[-0.6, 0.4, 0.3], [-0.6, -0.4, 0.3], [-0.7, 0.0, 0.15], [-1.0, 0.0, 0.56]], coat);
    b.ellipsoid("head", [0.35, 0.0, 0.74], [0.46, 0.52, 0.26], coat);
    b.ellipsoid("bill", [0.83, 0.0, 0.68], [0.17, 0.26, 0.05], ORANGE_PLASTIC);
    for y in SIDES {
        b.ellipsoid("wing", [-0.2, y * 0.85, 0.34], [0.45, 0.13, 0.15], coat);
        b.ellipsoid("eye", [0.66, y * 0.28, 0.82], [0.09, 0.1, 0.05], BLACK_PLASTIC);
    }
}

/// Tubs of modelling dough, one or four.
pub(super) fn dough(b: &mut Build<'_>) {
    let count = (b.size.y / b.size.x).round().clamp(1.0, 3.0);
    let r = (b.size.y / count).min(b.size.x) / 2.0;
    let (h, tub) = (b.size.z, b.choose(&[YELLOW_PLASTIC, WHITE_PLASTIC]));
    for i in 0..count as usize {
        let y = (i as f32 + 0.5) / count * b.size.y - b.size.y / 2.0;
        let mat = BRIGHT[(i + b.rng.below(3)) % BRIGHT.len()];
        b.lathe("tub", [0.0, y, 0.0], &[(r * 0.84, 0.0), (r * 0.9, h * 0.85)], tub);
        b.cylinder("label", [0.0, y, h * 0.2], r * 0.93, h * 0.4, mat);
        b.lathe("lid", [0.0, y, h * 0.78], &[(r, 0.0), (r, h * 0.18), (r * 0.85, h * 0.22)], mat);
    }
}

/// A toy telephone: a dial telephone with a face, or a mobile phone.
pub(super) fn phone(b: &mut Build<'_>) {
    let (paint, trim) = (b.one_of(BRIGHT), b.choose(&[WHITE_PLASTIC, YELLOW_PLASTIC, RED_PLASTIC]));
    let flat = b.size.z / b.size.x < 0.45;
    if flat {
        b.pad("case", [-0.98, -0.98, 0.0], [0.98, 0.98, 0.9], b.size.z * 0.4, paint);
        b.slab("screen", [0.25, -0.75, 0.88], [0.85, 0.75, 0.94], PICTURE_SKY);
        for (i, j) in (0..3).flat_map(|i| (0..3).map(move |j| (i, j))) {
            let (x, y) = (-0.7 + 0.33 * i as f32, -0.55 + 0.55 * j as f32);
            b.pad("key", [x - 0.12, y - 0.2, 0.86], [x + 0.12, y + 0.2, 1.0], 0.003, BRIGHT[(i + j) % BRIGHT.len()]);
        }
        return;
    }
    let wheel = b.size.z * 0.14;
    let base = [(-0.9, 0.14), (0.95, 0.14), (0.95, 0.3), (-0.2, 0.72), (-0.9, 0.72)];
    b.side_outline("case", (-0.72, 0.72), &base, paint);
    for (x, y) in CORNERS {
        b.wheel("wheel", Axis::Y, [x * 0.6, y * 0.8, 0.14], (wheel.min(b.size.x * 0.18), b.size.y * 0.1), trim);
    }
    b.posed(pitched(b.p([0.4, 0.0, 0.5]), 0.62), |b| {
        let r = b.size.y.min(b.size.x) * 0.2;
        b.cylinder("dial", [0.0, 0.0, 0.0], r, b.size.z * 0.06, trim);
        for i in 0..8 {
            let (s, c) = (i as f32 * 0.7).sine_cosine();
            b.cylinder("hole", [r * 0.7 * c, r * 0.7 * s, 0.0], r * 0.15, b.size.z * 0.068, BRIGHT[i % BRIGHT.len()]);
        }
    });
    b.slab("cradle", [-0.75, -0.35, 0.7], [-0.35, 0.35, 0.82], paint);
    b.pole("handset", [-0.55, -0.8, 0.87], [-0.55, 0.8, 0.87], b.size.z * 0.06, trim);
    for y in SIDES {
        b.ellipsoid("earpiece", [-0.55, y * 0.8, 0.86], [0.3, 0.2, 0.14], trim);
    }
}

/// A toy teapot with cups on a tray.
pub(super) fn tea_set(b: &mut Build<'_>) {
    let (pot, trim) = (b.choose(&[PORCELAIN, PINK_PLASTIC, BLUE_PLASTIC, BEECH, WHITE_PLASTIC]), b.one_of(PAINTS));
    let r = (b.size.x * 0.225).min(b.size.y * 0.2);
    let h = b.size.z;
    b.plan_outline("tray", (0.0, 0.05), &rounded_between((-1.0, -1.0), (1.0, 1.0), (0.15, 0.15)), trim);
    let at = b.p([-0.3, 0.0, 0.045]);
    let body = [(r * 0.6, 0.0), (r * 0.95, h * 0.2), (r, h * 0.4), (r * 0.6, h * 0.65), (r * 0.4, h * 0.7)];
    b.lathe("teapot", at, &body, pot);
    b.lathe("lid", [at[0], at[1], h * 0.72], &[(r * 0.46, 0.0), (r * 0.3, h * 0.1), (r * 0.1, h * 0.13)], trim);
    b.ball("knob", [at[0], at[1], h * 0.92], h * 0.07, trim);
    b.bar("spout", [at[0] + r * 0.8, 0.0, h * 0.28], [at[0] + r * 1.4, 0.0, h * 0.6], r * 0.16, pot);
    let back = at[0] - r * 0.9;
    let grip =
        [[back, 0.0, h * 0.58], [back - r * 0.5, 0.0, h * 0.5], [back - r * 0.4, 0.0, h * 0.3], [back, 0.0, h * 0.24]];
    b.pipe("handle", &grip, r * 0.1, trim);
    for (x, y) in [(0.62, 0.6), (0.62, -0.6), (-0.55, 0.72), (-0.55, -0.72)] {
        let at = b.p([x, y, 0.05]);
        cup(b, at, (r * 0.5, h * 0.34), (pot, trim));
    }
}

/// A cup on a saucer.
fn cup(b: &mut Build<'_>, at: [f32; 3], (r, h): (f32, f32), (mat, trim): (MaterialId, MaterialId)) {
    b.lathe("saucer", at, &[(r * 0.7, 0.0), (r * 1.3, h * 0.16), (r * 0.6, h * 0.1)], trim);
    let bowl = [(r * 0.55, 0.0), (r * 0.9, h * 0.9), (r * 0.8, h * 0.9), (r * 0.45, h * 0.1)];
    b.lathe("cup", [at[0], at[1], at[2] + h * 0.1], &bowl, mat);
}

/// A toy tool box with hammer, saw and spanner.
pub(super) fn tool_set(b: &mut Build<'_>) {
    let (case, tool) = (b.choose(&[RED_PLASTIC, BLUE_PLASTIC, YELLOW_PLASTIC, BEECH]), b.one_of(BRIGHT));
    let tall = 0.5;
    b.slab("bottom", [-0.95, -0.95, 0.0], [0.95, 0.95, 0.06], case);
    for s in SIDES {
        b.slab("wall", [s * 0.9 - 0.07, -0.95, 0.06], [s * 0.9 + 0.07, 0.95, tall], case);
        let gable = [(-0.83, 0.06), (0.83, 0.06), (0.83, tall), (0.2, 0.98), (-0.2, 0.98), (-0.83, tall)];
        b.within([-1.0, s * 0.92 - 0.05, 0.0], [1.0, s * 0.92 + 0.05, 1.0], |b| {
            b.side_outline("gable", (-1.0, 1.0), &gable, case)
        });
    }
    b.pole("handle", [0.0, -0.93, 0.9], [0.0, 0.93, 0.9], b.size.z * 0.06, BEECH);
    let r = b.size.z * 0.05;
    b.pole("hammer", [0.45, -0.55, 0.04], [0.45, -0.4, 0.8], r, BEECH);
    b.slab("hammer", [0.2, -0.52, 0.72], [0.75, -0.28, 0.86], tool);
    b.side_outline("saw", (0.25, 0.29), &[(-0.6, 0.05), (-0.3, 0.05), (-0.25, 0.7), (-0.65, 0.7)], STEEL);
    b.pad("saw", [-0.72, 0.18, 0.66], [-0.18, 0.36, 0.86], 0.004, BRIGHT[2]);
    b.pole("screwdriver", [0.45, 0.5, 0.05], [0.45, 0.5, 0.6], r * 0.5, STEEL);
    b.pole("screwdriver", [0.45, 0.5, 0.5], [0.45, 0.5, 0.84], r * 1.3, BRIGHT[3]);
    b.slab("spanner", [-0.5, -0.6, 0.05], [-0.4, -0.45, 0.7], STEEL);
    b.slab("spanner", [-0.62, -0.62, 0.68], [-0.28, -0.43, 0.82], STEEL);
}

/// A water pistol or a long pump gun with a tank.
pub(super) fn water_gun(b: &mut Build<'_>) {
    let (paint, trim) = (b.one_of(BRIGHT), b.one_of(BRIGHT));
    let long = b.size.x > b.size.z * 1.6;
    let barrel = (b.size.z * 0.11).min(b.size.y * 0.3);
    let grip = if long { (-0.55, -0.2) } else { (-0.85, -0.25) };
    b.side_outline(
        "grip",
        (-0.5, 0.5),
        &[(grip.0 - 0.1, 0.0), (grip.1 - 0.1, 0.0), (grip.1 + 0.05, 0.5), (grip.0 + 0.05, 0.5)],
        paint,
    );
    let body = [(-0.95, 0.5), (0.4, 0.45), (0.5, 0.55), (0.45, 0.72), (-0.9, 0.74)];
    b.side_outline("body", (-0.7, 0.7), &body, paint);
    b.pole("barrel", [0.4, 0.0, 0.6], [0.92, 0.0, 0.6], barrel, trim);
    b.pole("nozzle", [0.9, 0.0, 0.6], [1.0, 0.0, 0.6], barrel * 0.6, ORANGE_PLASTIC);
    b.ellipsoid("tank", [-0.25, 0.0, 0.84], [0.5, 0.9, 0.155], CLEAR_PLASTIC);
    b.torus("trigger_guard", Axis::Y, [grip.1 + 0.12, 0.0, 0.42], (b.size.z * 0.09, b.size.z * 0.018), paint);
    b.slab("trigger", [grip.1 + 0.06, -0.12, 0.36], [grip.1 + 0.14, 0.12, 0.5], trim);
    if long {
        b.pole("pump", [0.3, 0.0, 0.36], [0.72, 0.0, 0.36], barrel * 1.2, trim);
        b.pole("rail", [0.25, 0.0, 0.44], [0.95, 0.0, 0.44], barrel * 0.5, BLACK_PLASTIC);
    }
}

/// A bottle of soap bubbles with its ring.
pub(super) fn bubble_wand(b: &mut Build<'_>) {
    let (paint, trim) = (b.one_of(BRIGHT), b.one_of(BRIGHT));
    let (r, h) = (b.size.x.min(b.size.y) / 2.0, b.size.z);
    let body = (0.45 * h).max(h - r * 6.0).min(h * 0.7);
    b.lathe(
        "bottle",
        [0.0; 3],
        &[(r * 0.9, 0.0), (r * 0.95, body * 0.1), (r * 0.95, body * 0.85), (r * 0.6, body)],
        paint,
    );
    b.cylinder("label", [0.0, 0.0, body * 0.25], r, body * 0.4, WHITE_PAPER);
    b.cylinder("cap", [0.0, 0.0, body * 0.98], r * 0.7, h * 0.08, trim);
    b.cylinder("stick", [0.0, 0.0, body], r * 0.15, h - body - r * 1.5, trim);
    let ring = (r * 0.75, r * 0.13);
    b.torus("ring", Axis::X, [0.0, 0.0, 1.0 - (ring.0 + ring.1) / h], ring, trim);
}

/// A diamond kite on its spars, with bows on its tail.
pub(super) fn kite(b: &mut Build<'_>) {
    let (a, c) = (b.one_of(CLOTHS), b.one_of(CLOTHS));
    let (r, cross) = ((b.size.x * 0.15).min(0.004), 0.68);
    let quarter = |y: f32, z: f32| [(0.0, cross), (y * 0.98, cross), (0.0, z)];
    for (y, z, mat) in [(1.0, 0.995, a), (-1.0, 0.995, c), (1.0, 0.18, c), (-1.0, 0.18, a)] {
        b.front_outline("sail", (0.0, 0.12), &quarter(y, z), mat);
    }
    b.pole("spar", [-0.1, 0.0, 0.15], [-0.1, 0.0, 0.99], r, BEECH);
    b.pole("spar", [-0.1, -0.97, cross], [-0.1, 0.97, cross], r, BEECH);
    let tail: Vec<_> = (0..5).map(|i| [0.0, if i % 2 == 0 { 0.04 } else { -0.04 }, 0.19 - 0.045 * i as f32]).collect();
    b.bent_rod("tail", &tail, r * 0.6, WHITE_COTTON);
    for (i, at) in tail.iter().enumerate().skip(1) {
        b.ellipsoid("bow", [0.0, at[1], at[2] + 0.005], [0.4, 0.07, 0.013], CLOTHS[i]);
    }
    b.pad("reel", [-0.5, -0.07, 0.0], [0.5, 0.07, 0.05], 0.01, b.style.wood);
}

/// A bucket for sand with a handle.
pub(super) fn bucket(b: &mut Build<'_>) {
    let (paint, trim) = (b.one_of(BRIGHT), b.one_of(BRIGHT));
    let (r, h) = (b.size.x.min(b.size.y) / 2.0, b.size.z);
    (b.size.x, b.size.y) = (2.0 * r, 2.0 * r);
    let (foot, lip, t) = (r * b.vary(0.62, 0.72), r * 0.94, 0.003_f32.min(r * 0.1));
    let wall = [(foot, 0.0), (lip, h * 0.97), (r, h * 0.97), (r, h), (lip - t, h), (foot - t, t)];
    b.lathe("bucket", [0.0; 3], &wall, paint);
    b.inside("inside", [0.0, 0.0, t], ((foot - t) * 0.68, (foot - t) * 0.68), h * 0.9);
    let bow = (0..9).map(|i| (i as f32 * std::f32::consts::PI / 8.0).sine_cosine());
    let down: Vec<_> = bow.map(|(s, c)| [0.97 * s, 0.97 * c, 0.98 - 0.48 * s]).collect();
    b.bent_rod("handle", &down, r * 0.03, trim);
    for i in 0..4 {
        let (s, c) = (i as f32 * std::f32::consts::FRAC_PI_2 + 0.5).sine_cosine();
        let out = (foot + lip) / 2.0;
        b.ball("star", [out * c * 0.97, out * s * 0.97, h * 0.5], r * 0.09, trim);
    }
}

/// A sand spade standing on its blade, in the leaning pose.
pub(super) fn shovel(b: &mut Build<'_>) {
    let (paint, shaft) = (b.one_of(BRIGHT), b.choose(&[BEECH, YELLOW_PLASTIC, RED_PLASTIC]));
    let blade = [(-0.7, 0.36), (-0.95, 0.3), (-0.85, 0.1), (0.0, 0.0), (0.85, 0.1), (0.95, 0.3), (0.7, 0.36)];
    b.front_outline("blade", (-0.3, 0.0), &blade, paint);
    for y in SIDES {
        b.chunk(
            "side",
            &[
                [-0.3, y * 0.98, 0.3],
                [-0.3, y * 0.8, 0.3],
                [0.9, y * 0.98, 0.3],
                [-0.3, y * 0.88, 0.1],
                [0.7, y * 0.9, 0.12],
                [0.9, y * 0.86, 0.3],
            ],
            paint,
        );
    }
    let r = (b.size.x * 0.14).min(b.size.y * 0.12);
    b.pole("shaft", [-0.15, 0.0, 0.28], [-0.15, 0.0, 0.86], r, shaft);
    let grip = [
        [-0.15, 0.0, 0.82],
        [-0.15, 0.6, 0.9],
        [-0.15, 0.6, 0.96],
        [-0.15, -0.6, 0.96],
        [-0.15, -0.6, 0.9],
        [-0.15, 0.0, 0.82],
    ];
    b.bent_rod("grip", &grip, r * 0.8, paint);
}
