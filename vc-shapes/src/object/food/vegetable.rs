//! Vegetables with many parts: heads of leaves and florets, sticks, pods and mushrooms.

use std::f32::consts::TAU;

use vc_graph::portable::Portable;

use super::fruit::berry;
use crate::material::*;
use crate::solid::{Build, P, dims, lump, planar_tube, spun, sweep, turn};

/// Broccoli and cauliflower: florets on a stem.
pub(super) fn florets(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let white = b.class == "cauliflower";
    let (flower, stem) = if white { (CREAM_FOOD, LIGHT_LEAF) } else { (b.choose(&[DARK_LEAF, LEAF]), LIGHT_LEAF) };
    let (hx, hy) = (x / 2.0, y / 2.0);
    let low = if white { z * 0.25 } else { z * 0.45 };
    turn(b, "stem", [0.0; 3], (hx.min(hy) * 0.4, low * 1.5), &[(0.8, 0.0), (0.85, 0.4), (1.4, 1.0)], stem);
    let count = 13;
    for i in 0..count {
        let k = (i as f32 + 0.3) / count as f32;
        let (s, c) = (2.399_963 * i as f32).sine_cosine();
        let out = k.sqrt();
        let r = ((hx * hy).sqrt() * b.rng.between(0.32, 0.37)).min(hx * 0.8).min(hy * 0.8);
        let centre = [(hx - r) * out * c, (hy - r) * out * s, low + (z - low - r * 0.9) * (1.0 - 0.7 * k) + r * 0.1];
        lump(b, "floret", centre, [r, r, r * 0.85], 0.09, flower);
    }
    if white {
        leaves(b, (hx, hy), (0.0, z * 0.65), 8, LEAF);
    }
}

/// Leaves around a head, growing upwards and outwards from its base.
fn leaves(b: &mut Build<'_>, (hx, hy): (f32, f32), (low, high): (f32, f32), count: usize, mat: MaterialId) {
    for i in 0..count {
        let angle = TAU * i as f32 / count as f32 + b.vary(-0.1, 0.1);
        let half = TAU / count as f32 * 0.52;
        let (hx, hy) = if i % 2 == 0 { (hx, hy) } else { (hx * 0.97, hy * 0.97) };
        let at = |turn: f32, out: f32, z: f32| {
            let (s, c) = (angle + turn).sine_cosine();
            [hx * out * c, hy * out * s, low + (high - low) * z]
        };
        let points = [
            at(-0.4, 0.3, 0.0),
            at(0.4, 0.3, 0.0),
            at(-half, 0.9, 0.45),
            at(half, 0.9, 0.45),
            at(0.0, 0.99, 0.5),
            at(-half * 0.5, 0.95, 0.9),
            at(half * 0.5, 0.95, 0.9),
            at(0.0, 0.9, 1.0),
            at(0.0, 0.75, 0.6),
        ];
        b.hull("leaf", &points, mat);
    }
}

/// Cabbage and lettuce: a head within leaves.
pub(super) fn head(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let lettuce = b.class == "lettuce";
    let (core, leaf) = if lettuce {
        (LIGHT_LEAF, b.choose(&[LIGHT_LEAF, LEAF, GREEN_SKIN]))
    } else {
        (b.choose(&[LIGHT_LEAF, PURPLE_SKIN]), LEAF)
    };
    let leaf = if core == PURPLE_SKIN { PURPLE_SKIN } else { leaf };
    let (hx, hy) = (x / 2.0, y / 2.0);
    lump(b, "heart", [0.0, 0.0, z * 0.52], [hx * 0.88, hy * 0.88, z * 0.48], if lettuce { 0.1 } else { 0.04 }, core);
    if !lettuce {
        return leaves(b, (hx, hy), (0.0, z * 0.75), 6, leaf);
    }
    // Loose leaves are wavy shells around the heart.
    for i in 0..8 {
        let (s, c) = (TAU * i as f32 / 8.0).sine_cosine();
        let low = if i % 2 == 0 { 0.46 } else { 0.56 };
        let centre = [hx * 0.5 * c, hy * 0.5 * s, z * low];
        lump(b, "leaf", centre, [hx * 0.48, hy * 0.48, z * 0.42], 0.18, if i % 2 == 0 { leaf } else { core });
    }
}

/// Spinach and herbs: layered leaves; herbs are tied in a bunch along Y.
pub(super) fn greens(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let bunch = b.class == "fresh_herbs";
    let count = if bunch { 16 } else { 26 };
    let mats = [LEAF, DARK_LEAF, if bunch { LIGHT_LEAF } else { LEAF }];
    for i in 0..count {
        let k = (i as f32 + 0.5) / count as f32;
        let (s, c) = (2.4 * i as f32).sine_cosine();
        let (w, l) = if bunch { (hx * 0.3, hy * 0.24) } else { (hx * 0.5, hy * 0.5) };
        let centre = if bunch {
            [(hx - w) * c * k.sqrt(), hy * 0.38 + hy * 0.36 * s * k.sqrt(), 0.0]
        } else {
            [(hx - w) * c * k.sqrt(), (hy - l) * s * k.sqrt(), 0.0]
        };
        let low = z * 0.75 * (1.0 - k) * b.rng.between(0.6, 1.0);
        let (t, tip) = (z * 0.06, z * b.vary(0.05, 0.18));
        let mat = mats[i % 3];
        let at = |dx: f32, dy: f32, dz: f32| {
            [
                (centre[0] + dx * w * c - dy * w * s * 0.6).max(-hx).min(hx),
                (centre[1] + dx * l * s * 0.6 + dy * l * c.abs().max(0.5)).max(-hy).min(hy),
                (low + dz).min(z),
            ]
        };
        b.hull(
            "leaf",
            &[
                at(-1.0, 0.0, tip),
                at(-0.3, 0.6, t),
                at(0.5, 0.5, 0.0),
                at(1.0, 0.0, tip),
                at(0.5, -0.5, t),
                at(-0.3, -0.6, 0.0),
                at(0.0, 0.0, tip + t),
            ],
            mat,
        );
        if bunch {
            b.rod(
                "stem",
                [centre[0], centre[1], low + t * 0.5],
                [hx * 0.15 * c * k, -hy * 0.98, z * (0.4 + 0.1 * k * s)],
                (z * 0.03).min(hx * 0.05),
                LIGHT_LEAF,
            );
        }
    }
    if bunch {
        b.rounded_block(
            "band",
            [-hx * 0.62, -hy * 0.35, z * 0.1],
            [hx * 0.62, -hy * 0.28, z * 0.75],
            z * 0.25,
            RED_RUBBER,
        );
    }
}

/// Leeks, spring onions and celery along Y: white at one end, leaves at the other.
pub(super) fn stalks(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy, mid) = (x / 2.0, y / 2.0, z / 2.0);
    let count = match b.class {
        "leek" => 1,
        "celery" => 6,
        _ => b.rng.count(3, 5),
    };
    let white = if b.class == "celery" { LIGHT_LEAF } else { PETAL_WHITE };
    for i in 0..count {
        let (s, c) = (TAU * i as f32 / count as f32).sine_cosine();
        let r = if count == 1 { hx.min(mid) } else { hx.min(mid) * 0.42 };
        let off = if count == 1 { [0.0, 0.0] } else { [(hx - r) * c, (mid - r) * s] };
        let at = |k: f32, r: f32, thin: f32| {
            ([off[0] * (0.75 + 0.25 * k), -hy + y * k, mid + off[1] * (0.75 + 0.25 * k)], r, r * thin)
        };
        sweep(
            b,
            "shaft",
            &[
                at(0.004 * (i % 3) as f32, r * 0.6, 1.0),
                at(0.02, r * 0.85, 1.0),
                at(0.08, r * 0.75, 1.0),
                at(0.56, r * 0.72, 1.0),
            ],
            [1.0, 0.0, 0.0],
            white,
        );
        sweep(
            b,
            "leaf",
            &[
                at(0.53 + 0.005 * (i % 6) as f32, r * 0.8, 1.0),
                at(0.75, r * 0.9, 0.7),
                at(0.92, r * 0.7, 0.35),
                at(1.0, r * 0.15, 0.2),
            ],
            [1.0, 0.0, 0.0],
            if b.class == "celery" { LEAF } else { DARK_LEAF },
        );
        if count == 1 {
            for side in [-1.0, 1.0] {
                let fan = |k: f32, out: f32, w: f32| ([side * (hx - w) * out, -hy + y * k, mid], w, r * 0.15);
                sweep(
                    b,
                    "leaf",
                    &[fan(0.55, 0.3, r * 0.4), fan(0.75, 0.7, r * 0.35), fan(0.95, 1.0, r * 0.1)],
                    [1.0, 0.0, 0.0],
                    LEAF,
                );
            }
        }
    }
    if count > 1 {
        let r = hx.min(mid);
        b.rod("band", [0.0, -hy * 0.3, mid], [0.0, -hy * 0.27, mid], r * 0.88, RED_RUBBER);
    }
}

/// Peas and beans: pods side by side and stacked.
pub(super) fn pods(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let peas = b.class == "peas";
    let count = 9;
    let r = (z * 0.31).min(x * 0.2);
    for i in 0..count {
        let tier = [0, 1, 2, 1][i % 4];
        let across = (hx - 1.5 * r) * (i as f32 / (count - 1) as f32 * 2.0 - 1.0);
        let (low, bow) = (r + (z - 2.0 * r) * tier as f32 / 2.0, hx * b.vary(-0.03, 0.03));
        let at = |k: f32, w: f32| {
            let way = (2.0 * k - 1.0) * hy * (1.0 - 0.06 * tier as f32);
            ([(across + bow * (1.0 - (2.0 * k - 1.0).raised(2))).max(-hx + r * 1.3).min(hx - r * 1.3), way, low], w, r)
        };
        let wide = if peas { r * 1.3 } else { r * 0.8 };
        sweep(
            b,
            "pod",
            &[at(0.0, r * 0.1), at(0.12, wide * 0.8), at(0.5, wide), at(0.88, wide * 0.8), at(1.0, r * 0.1)],
            [1.0, 0.0, 0.0],
            if i % 2 == 0 { LEAF } else { GREEN_SKIN },
        );
        if peas && tier == 2 {
            for k in [0.3, 0.45, 0.6] {
                let c = at(k, 0.0).0;
                berry(b, [c[0], c[1], c[2] - r * 0.1], r * 1.05, LIGHT_LEAF);
            }
        }
    }
}

/// A mushroom: a cap on a stem.
pub(super) fn mushroom(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let cap = b.choose(&[PETAL_WHITE, BROWN_SKIN, PALE_FLESH]);
    let low = z * b.vary(0.35, 0.5);
    let stem = x.min(y) * b.vary(0.16, 0.22);
    turn(b, "stem", [0.0; 3], (stem, low + z * 0.1), &[(1.0, 0.0), (0.85, 0.4), (0.9, 1.0)], PALE_FLESH);
    let profile = [(0.0, 0.15), (0.75, 0.12), (0.97, 0.0), (1.0, 0.2), (0.86, 0.6), (0.5, 0.92), (0.0, 1.0)];
    spun(b, "cap", ([-x / 2.0, -y / 2.0, low], [x / 2.0, y / 2.0, z]), &profile, false, cap);
}

/// A cob of corn with rows of grains and some husk.
pub(super) fn corn(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let rows = 11;
    let mut profile = vec![(0.3, 0.0)];
    for i in 0..rows {
        let k = (i as f32 + 0.1) / rows as f32;
        let r = if k < 0.15 { 0.55 + 2.0 * k } else { 0.88 - 0.2 * (k - 0.4).abs() };
        profile.extend([(r * 0.93, k), (r, k + 0.03), (r, k + 0.06)]);
    }
    profile.push((0.35, 1.0));
    // The tip is at +Y, the husk at -Y.
    spun(b, "grains", ([-hx * 0.9, -hy * 0.85, z * 0.05], [hx * 0.9, hy, z * 0.95]), &profile, true, YELLOW_SKIN);
    for i in 0..5 {
        let (s, c) = (TAU * i as f32 / 5.0 + 0.5).sine_cosine();
        let at = |k: f32, out: f32, w: f32| {
            ([(hx - w * c.abs()) * out * c * 0.98, -hy + y * k, z / 2.0 + (z / 2.0) * out * s * 0.96], w, x * 0.012)
        };
        let side = if c.abs() < 0.6 { [1.0, 0.0, 0.0] } else { [0.0, 0.0, 1.0] };
        let path = [
            at(0.0, 0.2, x * 0.08),
            at(0.12, 0.75, x * 0.14),
            at(0.4, 0.95, x * 0.12),
            at(b.rng.between(0.55, 0.75), 0.97, x * 0.02),
        ];
        sweep(b, "husk", &path, side, LIGHT_LEAF);
    }
    planar_tube(
        b,
        "stalk",
        &[[0.0, -hy * 0.985, z / 2.0], [0.0, -hy * 0.8, z / 2.0]],
        hx * 0.3,
        [1.0, 0.0, 0.0],
        LIGHT_LEAF,
    );
}

/// A ribbed pumpkin with a stalk.
pub(super) fn pumpkin(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy, h) = (x / 2.0, y / 2.0, z * 0.85);
    let mat = b.choose(&[ORANGE_SKIN, ORANGE_SKIN, MUSTARD, DARK_LEAF]);
    let ribs = b.rng.count(8, 10);
    for i in 0..ribs {
        let (s, c) = (TAU * i as f32 / ribs as f32).sine_cosine();
        let r = 0.42;
        let centre: P = [hx * (1.0 - r) * c, hy * (1.0 - r) * s, h / 2.0];
        lump(b, "rib", centre, [hx * r, hy * r, h / 2.0], 0.01, mat);
    }
    let lean = hx * b.vary(-0.15, 0.15);
    b.cylinder("core", [0.0, 0.0, h * 0.1], hx.min(hy) * 0.4, h * 0.75, mat);
    planar_tube(
        b,
        "stalk",
        &[[0.0, 0.0, h * 0.75], [lean * 0.2, 0.0, h * 0.98], [lean, 0.0, z]],
        hx * 0.09,
        [0.0, 1.0, 0.0],
        BARK,
    );
}

/// A chili: a bent cone with a green cap.
pub(super) fn chili(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let mat = b.choose(&[RED_SKIN, GREEN_SKIN, RED_SKIN, ORANGE_SKIN]);
    let r = (z / 2.0).min(x * 0.4);
    let bow = (x / 2.0 - r).max(0.0);
    let at = |k: f32, r: f32| ([bow * (2.0 * (2.0 * k - 1.0).raised(2) - 1.0), y * (0.5 - k), z / 2.0], r, r);
    sweep(
        b,
        "pod",
        &[at(0.12, r * 0.7), at(0.18, r), at(0.4, r * 0.95), at(0.75, r * 0.55), at(1.0, r * 0.08)],
        [0.0, 0.0, 1.0],
        mat,
    );
    sweep(
        b,
        "stalk",
        &[at(0.0, r * 0.2), at(0.1, r * 0.2), at(0.12, r * 0.75), at(0.17, r * 0.9)],
        [0.0, 0.0, 1.0],
        LEAF,
    );
}
