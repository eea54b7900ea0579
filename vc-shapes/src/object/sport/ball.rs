//! Balls.

use std::f32::consts::{PI, TAU};

use vc_graph::portable::Portable;

use crate::material::*;
use crate::object::palette::*;
use crate::solid::{Build, CORNERS, P, SIDES, seam, zone};

/// Radius and centre of the ball that fits the size.
fn fit(b: &Build<'_>) -> (f32, P) {
    let r = b.size.min() / 2.0;
    (r, [0.0, 0.0, r])
}

/// A zone of the ball's surface between two angles from an axis.
fn mark(b: &mut Build<'_>, name: &str, towards: P, angles: (f32, f32), lift: f32, mat: MaterialId) {
    let (r, c) = fit(b);
    zone(b, name, (c, r * lift), towards, angles, mat);
}

/// A toy ball, a medicine ball, an exercise ball or a table tennis ball.
pub(super) fn plain(b: &mut Build<'_>) {
    let (r, c) = fit(b);
    match b.class {
        "table_tennis_ball" => {
            let mat = b.choose(&[WHITE_PLASTIC, WHITE_PLASTIC, ORANGE_PLASTIC]);
            b.ball("ball", c, r, mat);
        }
        "medicine_ball" => {
            let (mat, line) = (
                b.choose(&[BROWN_LEATHER, BLACK_LEATHER, RUBBER, TAN_LEATHER]),
                b.choose(&[RED_RUBBER, GREY_RUBBER, YELLOW_PLASTIC]),
            );
            b.ball("ball", c, r * 0.992, mat);
            for turn in [0.0, 1.047, 2.094] {
                let (s, k) = turn.sine_cosine();
                mark(b, "seam", [s, k, 0.0], (PI / 2.0 - 0.03, PI / 2.0 + 0.03), 1.0, line);
            }
            mark(b, "label", [0.0, 0.0, 1.0], (0.0, 0.4), 1.0, line);
        }
        "exercise_ball" => {
            let mat = b.one_of(BRIGHT);
            b.ball("ball", c, r * 0.994, mat);
            let rib = b.vary(0.14, 0.24);
            for i in 1..(PI / rib) as usize {
                let turn = rib * i as f32;
                if (turn - PI / 2.0).abs() < 0.9 {
                    mark(b, "rib", [0.0, 0.0, 1.0], (turn - 0.012, turn + 0.012), 1.0, mat);
                }
            }
        }
        _ => {
            let (mat, other) = (b.one_of(BRIGHT), b.choose(&[WHITE_PLASTIC, YELLOW_PLASTIC, BLUE_PLASTIC]));
            b.ball("ball", c, r * 0.95, mat);
            let towards = [0.5, 0.3, 0.8];
            let (stripe, cap) = (b.vary(0.16, 0.42), b.vary(0.22, 0.42));
            if b.rng.chance(0.5) {
                mark(b, "stripe", towards, (PI / 2.0 - stripe, PI / 2.0 + stripe), 0.996, other);
            } else {
                for turn in [0.0, PI / 3.0, PI * 2.0 / 3.0] {
                    let (s, k) = turn.sine_cosine();
                    mark(b, "stripe", [s, k, 0.0], (PI / 2.0 - 0.12, PI / 2.0 + 0.12), 0.992 + turn * 0.002, other);
                }
            }
            mark(b, "cap", [0.0, 0.0, 1.0], (0.0, cap), 1.0, other);
        }
    }
}

/// A basketball: orange with dark seams.
pub(super) fn basketball(b: &mut Build<'_>) {
    let (r, c) = fit(b);
    let skin = b.choose(&[ORANGE_PLASTIC, TERRACOTTA, RUST_FABRIC]);
    b.ball("ball", c, r * 0.993, skin);
    for towards in [[1.0, 0.0, 0.3], [0.0, 1.0, 0.0]] {
        mark(b, "seam", towards, (PI / 2.0 - 0.025, PI / 2.0 + 0.025), 1.0, BLACK_PLASTIC);
    }
    for y in SIDES {
        mark(b, "seam", [0.3, 0.0, -y], (0.86, 0.91), 1.0, BLACK_PLASTIC);
    }
}

/// A football of twelve dark patches on white.
pub(super) fn football(b: &mut Build<'_>) {
    let (r, c) = fit(b);
    let (skin, patch) = (WHITE_PLASTIC, b.choose(&[BLACK_PLASTIC, BLACK_PLASTIC, BLUE_PLASTIC, RED_PLASTIC]));
    b.ball("ball", c, r * 0.992, skin);
    let golden = 1.618;
    for (u, v) in CORNERS {
        for towards in [[0.0, u, v * golden], [u, v * golden, 0.0], [v * golden, 0.0, u]] {
            mark(b, "patch", towards, (0.0, 0.33), 1.0, patch);
        }
    }
}

/// An oval ball with laces and white rings.
pub(super) fn american_football(b: &mut Build<'_>) {
    let (r, half) = (b.size.x.min(b.size.z) / 2.0, b.size.y / 2.0);
    let count = 12;
    let place = |i: usize| {
        let t = -1.0 + 2.0 * i as f32 / count as f32;
        (r * 0.985 * (1.0 - t.abs().power(1.9)).max(0.0).power(0.75), half * t)
    };
    let profile: Vec<_> = (0..=count).map(place).collect();
    b.lathe_along("ball", [0.0, 0.0, r], [0.0, 1.0, r], &profile, BROWN_LEATHER);
    for y in SIDES {
        let at = y * half * 0.56;
        b.rod("ring", [0.0, at - half * 0.03, r], [0.0, at + half * 0.03, r], r * 0.76, WHITE_LEATHER);
    }
    let top = 2.0 * r;
    b.block("lace", [-r * 0.04, -half * 0.3, top * 0.98], [r * 0.04, half * 0.3, top], WHITE_LEATHER);
    for i in 0..6 {
        let y = half * (-0.25 + 0.1 * i as f32);
        b.block(
            "stitch",
            [-r * 0.16, y - half * 0.015, top * 0.97],
            [r * 0.16, y + half * 0.015, top * 0.996],
            WHITE_LEATHER,
        );
    }
}

/// A volleyball with panels in three directions.
pub(super) fn volleyball(b: &mut Build<'_>) {
    let (r, c) = fit(b);
    let (skin, other) = (
        b.choose(&[WHITE_LEATHER, YELLOW_PLASTIC]),
        b.choose(&[BLUE_PLASTIC, RED_PLASTIC, WHITE_PLASTIC, GREEN_PLASTIC]),
    );
    b.ball("ball", c, r * 0.99, skin);
    for (i, towards) in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].into_iter().enumerate() {
        for sign in SIDES {
            let way = towards.map(|v| v * sign);
            mark(b, "panel", way, (0.0, 0.62), 0.997 + 0.001 * i as f32, other);
            mark(b, "seam", way, (0.3, 0.33), 1.0, GREY_PLASTIC);
        }
    }
}

/// A tennis ball or a baseball: one closed seam that winds around the ball twice.
pub(super) fn tennis(b: &mut Build<'_>) {
    let (r, c) = fit(b);
    let (skin, line, wide) =
        if b.class == "baseball" { (WHITE_LEATHER, RED, 0.012) } else { (LIGHT_LEAF, WHITE_PLASTIC, 0.015) };
    b.ball("ball", c, r * 0.99, skin);
    let place = |i: usize| {
        let t = TAU * i as f32 / 40.0;
        let (s, z) = (PI / 2.0 - (PI / 2.0 - 0.46) * t.cosine()).sine_cosine();
        let (y, x) = (t / 2.0 + 0.46 * (2.0 * t).sine()).sine_cosine();
        [x * s, y * s, z]
    };
    let half: Vec<P> = (0..40).map(place).collect();
    // The second half of the seam is the first half turned upside down.
    let other = half.iter().map(|p| [-p[0], -p[1], p[2]]);
    let curve: Vec<P> = half
        .iter()
        .copied()
        .chain(other)
        .map(|p| [p[0] * r * 0.985, p[1] * r * 0.985, c[2] + p[2] * r * 0.985])
        .collect();
    seam(b, "seam", c, &curve, r * wide, line);
}

/// A golf ball with dimples.
pub(super) fn golf(b: &mut Build<'_>) {
    let (r, c) = fit(b);
    b.ball("ball", c, r, WHITE_PLASTIC);
    let golden = PI * (3.0 - 5.0_f32.sqrt());
    for i in 0..30 {
        let z = 1.0 - (2.0 * i as f32 + 1.0) / 30.0;
        let (s, k) = (golden * i as f32).sine_cosine();
        let flat = (1.0 - z * z).sqrt();
        let way = [k * flat, s * flat, z];
        let at = |d: f32| [c[0] + way[0] * d, c[1] + way[1] * d, c[2] + way[2] * d];
        b.rod("dimple", at(r * 0.9), at(r * 0.998), r * 0.09, GREY_PLASTIC);
    }
}

/// A bowling ball with three holes on top.
pub(super) fn bowling(b: &mut Build<'_>) {
    let (r, c) = fit(b);
    let (skin, swirl) = (
        b.choose(&[BLACK_GLAZE, BLUE_GLAZE, RED_GLAZE, GREEN_GLAZE, PURPLE_PLASTIC]),
        b.choose(&[BLUE_GLAZE, YELLOW_GLAZE, GREY_PLASTIC]),
    );
    b.ball("ball", c, r * 0.99, skin);
    for (x, y, size) in [(0.3, 0.12, 0.09), (0.3, -0.12, 0.09), (-0.05, 0.0, 0.11)] {
        let z = (1.0_f32 - x * x - y * y).sqrt();
        mark(b, "hole", [x, y, z], (0.0, size), 1.0, BLACK_PLASTIC);
    }
    mark(b, "swirl", [0.2, 0.9, 0.3], (1.2, 1.26), 1.0, swirl);
    mark(b, "mark", [1.0, 0.0, 0.2], (0.0, 0.16), 1.0, swirl);
}
