//! Equipment for darts, billiards and air hockey.

use std::f32::consts::TAU;

use vc_graph::portable::Portable;

use crate::material::*;
use crate::solid::{self, Build, MeshBuilder, P, Proportional, SIDES};

/// A dartboard: twenty sectors with double and triple fields around a bull.
pub(super) fn dartboard(b: &mut Build<'_>) {
    let (hx, hy, h) = solid::half_dims(b);
    let r = hy.min(h / 2.0);
    let deep = 2.0 * hx;
    let front = -hx + deep * 0.86;
    let rim = b.choose(&[BLACK_PLASTIC, BLACK_PLASTIC, RED_PLASTIC, BLUE_PLASTIC]);
    let field = r * b.vary(0.72, 0.78);
    let ring = |x: f32| [x, 0.0, h / 2.0];
    b.rod("rim", ring(-hx), ring(front), r, rim);
    b.rod("face", ring(front - 0.004), ring(front + deep * 0.02), field, CREAM_PAPER);
    let mut shells = [MeshBuilder::default(), MeshBuilder::default(), MeshBuilder::default(), MeshBuilder::default()];
    let mut piece = |shell: usize, i: usize, radii: (f32, f32), up: f32| {
        let corner = |x: f32| -> Vec<P> {
            let turns = [(0.0, radii.0), (0.0, radii.1), (1.0, radii.1), (1.0, radii.0)];
            let at = |(k, r): (f32, f32)| {
                let (s, c) = (TAU * (i as f32 + k - 0.5) / 20.0).sine_cosine();
                [x, r * s, h / 2.0 + r * c]
            };
            turns.map(at).to_vec()
        };
        shells[shell].loft(&[corner(front), corner(front + deep * up)]);
    };
    for i in 0..20 {
        if i % 2 == 0 {
            piece(0, i, (field * 0.06, field * 0.985), 0.035);
        }
        let colour = 1 + i % 2;
        piece(colour, i, (field * 0.55, field * 0.61), 0.06);
        piece(colour, i, (field * 0.94, field * 0.995), 0.06);
        piece(3, i, (r * 0.84, r * 0.88 + r * 0.05 * (i % 3) as f32 / 2.0), 0.03);
    }
    let [black, red, green, marks] = shells;
    black.put(b, "sector", BLACK_CARD);
    red.put(b, "field", RED_CARD);
    green.put(b, "field", GREEN_CARD);
    marks.put(b, "number", WHITE_PLASTIC);
    b.rod("outer_bull", ring(front), ring(front + deep * 0.08), field * 0.09, GREEN_CARD);
    b.rod("bull", ring(front), ring(front + deep * 0.1), field * 0.04, RED_CARD);
    let spider = solid::oval(crate::solid::Axis::X, ring(front + deep * 0.07), (field * 0.99, field * 0.99), 0, 24);
    solid::hoop(b, "wire", &spider, deep * 0.03, STEEL);
    b.rod("spike", ring(front), ring(hx), field * 0.012, STEEL);
}

/// Several darts side by side.
pub(super) fn darts(b: &mut Build<'_>) {
    let (hx, hy, h) = solid::half_dims(b);
    let barrel = b.choose(&[STEEL, BRASS, BLACK_METAL]);
    let flight = b.choose(&[RED_PLASTIC, BLUE_PLASTIC, GREEN_PLASTIC, BLACK_PLASTIC, YELLOW_PLASTIC]);
    let half = hx.min(h / 2.0) * 0.99;
    let count = ((hx / half) as usize).clamp(1, 3);
    let grooves = b.rng.count(2, 4);
    for i in 0..count {
        let x = (i as f32 - (count - 1) as f32 / 2.0) * 2.0 * half;
        let (tail, tip) = ([x, -hy, half], [x, hy, half]);
        let (long, r) = (2.0 * hy, (half * 0.35).min(0.0035));
        let at = |share: f32| [x, -hy + long * share, half];
        b.lathe_along("point", at(0.74), tip, &[(r * 0.5, 0.0), (r * 0.4, long * 0.2), (0.0, long * 0.26)], STEEL);
        b.lathe_along(
            "barrel",
            at(0.42),
            tip,
            &[(r * 0.6, 0.0), (r, long * 0.03), (r * 0.9, long * 0.3), (r * 0.5, long * 0.33)],
            barrel,
        );
        for k in 0..grooves {
            b.rod("grip", at(0.5 + 0.06 * k as f32), at(0.52 + 0.06 * k as f32), r * 1.15, BLACK_PLASTIC);
        }
        b.rod("shaft", tail, at(0.43), r * 0.55, BLACK_PLASTIC);
        let mut wings = MeshBuilder::default();
        let (y0, y1) = (-hy + 0.001, -hy + long * 0.2);
        wings.block([x - half, y0, half - 0.0004], [x + half, y1, half + 0.0004]);
        wings.block([x - 0.0004, y0, 0.0], [x + 0.0004, y1, 2.0 * half]);
        wings.put(b, "flight", flight);
    }
}

/// A wall rack for six cues: a back, a shelf and clips.
pub(super) fn cue_rack(b: &mut Build<'_>) {
    let wood = b.choose(&[MAHOGANY, WALNUT, OAK, CHERRY, BLACK]);
    let clip = b.choose(&[BRASS, CHROME, BLACK_METAL]);
    let broad = b.rng.chance(0.5);
    if broad {
        b.slab("back", [-1.0, -0.98, 0.03], [-0.9, 0.98, 1.0], wood);
    } else {
        for s in SIDES {
            b.slab("side", [-1.0, 0.88 * s - 0.1, 0.03], [-0.9, 0.88 * s + 0.1, 1.0], wood);
        }
    }
    b.slab("shelf", [-0.995, -1.0, 0.0], [1.0, 1.0, 0.05], wood);
    b.slab("lip", [0.9, -0.995, 0.04], [0.995, 0.995, 0.075], wood);
    let high = b.vary(0.72, 0.9);
    b.slab("rail", [-0.95, -0.97, high], [-0.35, 0.97, high + 0.04], wood);
    for i in 0..=6 {
        let y = -0.93 + 1.86 * i as f32 / 6.0;
        b.slab("clip", [-0.4, y - 0.035, high + 0.008], [0.7, y + 0.035, high + 0.03], clip);
    }
    let half = (b.size.x * 0.25, b.size.y * 0.06);
    for i in 0..6 {
        let y = -0.775 + 1.55 * i as f32 / 5.0;
        let at = b.p([0.25, y, 0.05]);
        let clearance = b.size.z * 0.94;
        b.inside(&format!("rack_{}", i + 1), at, half, clearance);
    }
}

/// A cue: butt, shaft, ferrule and tip.
pub(super) fn cue(b: &mut Build<'_>) {
    solid::longwise(b, |b, x, y, h| {
        let r = x.min(y) / 2.0;
        let butt = b.choose(&[WENGE, MAHOGANY, BLACK, WALNUT]);
        let wrap = b.choose(&[BLACK_LEATHER, WHITE_COTTON, RUBBER, GREEN_FABRIC]);
        let (joint, grip) = (h * b.vary(0.48, 0.56), h * b.vary(0.09, 0.14));
        b.lathe("bumper", [0.0; 3], &[(r * 0.8, 0.0), (r * 0.95, h * 0.005), (r * 0.95, h * 0.012)], RUBBER);
        b.lathe("butt", [0.0, 0.0, h * 0.01], &[(r, 0.0), (r * 0.9, h * 0.07), (r * 0.72, joint - h * 0.01)], butt);
        b.lathe("wrap", [0.0, 0.0, grip], &[(r * 0.95, 0.0), (r * 0.87, h * 0.2)], wrap);
        b.lathe("collar", [0.0, 0.0, joint - 0.012], &[(r * 0.8, 0.0), (r * 0.78, 0.02)], BRASS);
        b.lathe("shaft", [0.0, 0.0, joint], &[(r * 0.71, 0.0), (r * 0.44, h * 0.978 - joint)], MAPLE);
        b.lathe("ferrule", [0.0, 0.0, h * 0.978], &[(r * 0.46, 0.0), (r * 0.45, h * 0.017)], WHITE_PLASTIC);
        b.lathe(
            "tip",
            [0.0, 0.0, h * 0.994],
            &[(r * 0.42, 0.0), (r * 0.4, h * 0.003), (r * 0.2, h * 0.006)],
            BLUE_FABRIC,
        );
    });
}

/// Fifteen billiard balls in a triangle.
pub(super) fn balls(b: &mut Build<'_>) {
    let (hx, hy, h) = solid::half_dims(b);
    let frame = b.choose(&[MAHOGANY, WALNUT, BLACK_PLASTIC, OAK]);
    let r = (h / 2.0).min(hx.min(hy) / 6.4);
    let step = r * 3f32.sqrt();
    let colours = [
        YELLOW_PLASTIC,
        BLUE_PLASTIC,
        RED_PLASTIC,
        PURPLE_PLASTIC,
        ORANGE_PLASTIC,
        GREEN_PLASTIC,
        BROWN_PLASTIC,
        BLACK_PLASTIC,
    ];
    let mut shells: [MeshBuilder; 8] = std::array::from_fn(|_| MeshBuilder::default());
    let mut bands = MeshBuilder::default();
    let turn = b.rng.below(7);
    let first = -8.0 / 3.0 * step;
    for n in 0..15_usize {
        let row = (0..5).find(|k| n < (k + 1) * (k + 2) / 2).unwrap_or(4);
        let k = n - row * (row + 1) / 2;
        let at = [first + step * row as f32, (2.0 * k as f32 - row as f32) * r, r];
        shells[if n == 4 { 7 } else { (n + turn) % 7 }].egg(at, [r * 0.998; 3]);
        if n % 2 == 1 {
            bands.egg([at[0], at[1], at[2] + r * 0.4], [r * 0.86, r * 0.86, r * 0.6]);
        }
    }
    for (shell, mat) in shells.into_iter().zip(colours) {
        shell.put(b, "balls", mat);
    }
    bands.put(b, "stripes", WHITE_PLASTIC);
    // The triangle's sides touch the outer balls.
    let (low, high, t) = (h * 0.12, h * 0.75, r * 0.3);
    let (back, tip, wide) = (3.309 * r, -6.618 * r, 5.732 * r);
    let mut bar = |from: [f32; 2], to: [f32; 2], out: [f32; 2]| {
        let ends = [from, to, [to[0] + out[0] * t, to[1] + out[1] * t], [from[0] + out[0] * t, from[1] + out[1] * t]];
        let points: Vec<P> = [low, high].into_iter().flat_map(|z| ends.map(|e| [e[0], e[1], z])).collect();
        b.hull("rack", &points, frame);
    };
    bar([back, -wide], [back, wide], [1.0, 0.0]);
    bar([tip, 0.0], [back, wide], [-0.5, 0.866]);
    bar([tip, 0.0], [back, -wide], [-0.5, -0.866]);
}

/// An air hockey mallet: a broad base with a felt sole and a knob.
pub(super) fn mallet(b: &mut Build<'_>) {
    let (hx, hy, h) = solid::half_dims(b);
    let r = hx.min(hy);
    let mat = b.choose(&[RED_PLASTIC, BLUE_PLASTIC, GREEN_PLASTIC, BLACK_PLASTIC, ORANGE_PLASTIC]);
    let (knob, rim) = (r * b.vary(0.36, 0.46), h * b.vary(0.28, 0.4));
    b.lathe("sole", [0.0; 3], &[(r * 0.9, 0.0), (r * 0.9, h * 0.05)], GREY_FABRIC);
    let dip = [
        (r, h * 0.03),
        (r, rim),
        (r * 0.9, rim),
        (r * 0.82, h * 0.16),
        (knob, h * 0.2),
        (knob, h * 0.85),
        (knob * 0.8, h * 0.97),
        (knob * 0.4, h),
    ];
    b.lathe("mallet", [0.0; 3], &dip, mat);
}
