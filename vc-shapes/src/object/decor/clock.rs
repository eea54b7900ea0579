//! Clocks with dials and with digits.

use std::f32::consts::TAU;

use vc_graph::portable::Portable;

use crate::material::*;
use crate::solid::{Axis, Build, MeshBuilder, P, blocks, half_dims, hoop, ngon, oval, tube};

/// A dial facing +X: plate, marks and hands, protruding by `depth`.
pub(in crate::object) fn dial(b: &mut Build<'_>, at: P, r: f32, depth: f32, mats: (MaterialId, MaterialId)) {
    let (plate, ink) = mats;
    b.prism("dial", Axis::X, at, &ngon((r, r), 32), depth * 0.35, plate);
    let mut marks = MeshBuilder::default();
    for i in 0..12 {
        let (s, c) = (TAU * i as f32 / 12.0).sine_cosine();
        let half = r * if i % 3 == 0 { 0.05 } else { 0.03 };
        let m = [at[1] + r * 0.84 * s, at[2] + r * 0.84 * c];
        marks.block([at[0] + depth * 0.2, m[0] - half, m[1] - half], [at[0] + depth * 0.7, m[0] + half, m[1] + half]);
    }
    marks.put(b, "marks", ink);
    let time = b.vary(0.0, 12.0);
    for (turn, long, wide, z) in [(time / 12.0, 0.5, 0.05, 0.55), (time.fract(), 0.74, 0.035, 0.78)] {
        let (s, c) = (TAU * turn).sine_cosine();
        let (l, w) = (r * long, r * wide);
        let point = |a: f32, o: f32| (a * s * l + o * c * w, a * c * l - o * s * w);
        let hand = [point(-0.2, 1.0), point(-0.2, -1.0), point(1.0, -0.5), point(1.0, 0.5)];
        b.prism("hand", Axis::X, [at[0] + depth * (z - 0.2), at[1], at[2]], &hand, depth * 0.2, ink);
    }
    b.prism("hub", Axis::X, [at[0] + depth * 0.3, at[1], at[2]], &ngon((r * 0.075, r * 0.075), 10), depth * 0.7, ink);
}

/// The materials of a clock's dial and hands.
fn faces(b: &mut Build<'_>) -> (MaterialId, MaterialId) {
    b.choose(&[
        (WHITE_PAPER, BLACK_PLASTIC),
        (CREAM_PAPER, BLACK_PLASTIC),
        (BLACK_PLASTIC, WHITE_PLASTIC),
        (OAK, BLACK_PLASTIC),
        (NAVY, GOLD),
        (WHITE_PAPER, RED_PLASTIC),
    ])
}

/// A wall clock: round with a rim, square, or a sunburst.
pub(super) fn wall(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let r = y.min(h / 2.0);
    let rim = b.choose(&[b.style.wood, b.style.metal, BLACK_PLASTIC, WHITE_PLASTIC, RED_PLASTIC, BRASS]);
    let mats = faces(b);
    let at = [0.0, 0.0, h / 2.0];
    let depth = 2.0 * x;
    match b.rng.below(4) {
        0 => {
            b.rounded_block("case", [-x, -y, 0.0], [x * 0.3, y, h], x, rim);
            dial(b, [x * 0.25, 0.0, h / 2.0], r * 0.9, depth * 0.3, mats);
        }
        1 => {
            let mut rays = MeshBuilder::default();
            let count = b.choose(&[12, 16, 20]);
            for i in 0..count {
                let (s, c) = (TAU * i as f32 / count as f32).sine_cosine();
                let long = if i % 2 == 0 { 0.985 } else { 0.8 };
                let to = |f: f32| [-x * 0.5, r * f * s, h / 2.0 + r * f * c];
                rays.tapered(&[to(0.4), to(long)], |t| r * (0.03 - 0.02 * t));
            }
            rays.put(b, "ray", rim);
            b.prism("case", Axis::X, [-x, 0.0, h / 2.0], &ngon((r * 0.55, r * 0.55), 32), depth * 0.7, rim);
            dial(b, [x * 0.38, 0.0, h / 2.0], r * 0.48, depth * 0.28, mats);
        }
        _ => {
            let ring = (r * 0.07).min(x);
            b.prism("case", Axis::X, [-x, 0.0, h / 2.0], &ngon((r - ring, r - ring), 36), depth * 0.6, rim);
            hoop(b, "rim", &oval(Axis::X, at, (r - ring, r - ring), 0, 40), ring, rim);
            dial(b, [x * 0.15, 0.0, h / 2.0], r - ring * 1.2, depth * 0.35, mats);
        }
    }
}

/// A clock on a shelf: a house with a dial, a cube, a mantel arch or a glass bell.
pub(super) fn clock(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let case = b.choose(&[b.style.wood, WALNUT, BRASS, WHITE, BLACK, MARBLE]);
    let mats = faces(b);
    let depth = (x * 0.2).min(0.012);
    let front = x - depth;
    let foot = h * 0.06;
    b.block("foot", [-x, -y, 0.0], [front, y, foot], case);
    let outline: Vec<(f32, f32)> = match b.rng.below(3) {
        0 => vec![(-y * 0.9, 0.0), (y * 0.9, 0.0), (y * 0.9, h * 0.6), (0.0, h - foot), (-y * 0.9, h * 0.6)],
        1 => {
            let round = (h - foot) * 0.55;
            let curve = (0..=16)
                .map(|i| i as f32 / 16.0 * std::f32::consts::PI)
                .map(|a| (y * 0.9 * a.cosine(), h - foot - round + round * a.sine()));
            [(-y * 0.9, 0.0), (y * 0.9, 0.0)].into_iter().chain(curve).collect()
        }
        _ => vec![(-y * 0.92, 0.0), (y * 0.92, 0.0), (y * 0.92, h - foot), (-y * 0.92, h - foot)],
    };
    b.prism("case", Axis::X, [-x * 0.9, 0.0, foot], &outline, front + x * 0.9, case);
    let r = (y * 0.75).min((h - foot) * 0.38);
    let at = [front, 0.0, foot + (h - foot) * 0.45];
    dial(b, [front - depth * 0.1, at[1], at[2]], r, depth, mats);
    hoop(b, "bezel", &oval(Axis::X, at, (r, r), 0, 32), depth * 0.5, BRASS);
}

/// An alarm clock: with two bells, with digits, or a rounded one.
pub(super) fn alarm(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    if y > 1.3 * h || b.rng.chance(0.35) {
        return digital(b);
    }
    let mats = faces(b);
    let case = b.choose(&[RED_METAL, BLUE_METAL, BRASS, BLACK_METAL, GREEN_METAL, CHROME, WHITE_PLASTIC, PINK_PLASTIC]);
    let r = y.min(h * 0.38);
    let bells = b.rng.chance(0.6);
    let r = if bells { r } else { y.min(h * 0.47) };
    let centre = [0.0, 0.0, r + h * 0.06];
    let depth = (x * 0.3).min(0.02);
    b.prism("case", Axis::X, [-x, 0.0, centre[2]], &ngon((r, r), 32), 2.0 * x - depth, case);
    dial(b, [x - depth * 1.05, 0.0, centre[2]], r * 0.9, depth, mats);
    let mut feet = MeshBuilder::default();
    for (side, fx) in [(-1.0, -0.7), (-1.0, 0.6), (1.0, -0.7), (1.0, 0.6)] {
        let (hip, toe) = ([x * fx * 0.8, side * r * 0.5, centre[2] - r * 0.75], [x * fx, side * r * 0.8, h * 0.02]);
        feet.tapered(&[hip, toe], |t| (r * (0.11 - 0.04 * t)).min(x * 0.3));
    }
    feet.put(b, "foot", case);
    if !bells {
        b.cylinder("button", [0.0, 0.0, centre[2] + r * 0.97], r * 0.3, h - centre[2] - r * 0.97, mats.1);
        return;
    }
    let crown = centre[2] + r;
    let dome = (h - crown) * 0.55;
    for side in [-1.0, 1.0] {
        b.lathe(
            "bell",
            [0.0, side * r * 0.5, crown - dome * 0.15],
            &[(r * 0.4, 0.0), (r * 0.36, dome * 0.5), (r * 0.2, dome * 0.9), (0.0, dome)],
            CHROME,
        );
    }
    let top = h - r * 0.05;
    tube(
        b,
        "grip",
        &[
            [0.0, -r * 0.5, crown + dome * 0.8],
            [0.0, -r * 0.4, top],
            [0.0, r * 0.4, top],
            [0.0, r * 0.5, crown + dome * 0.8],
        ],
        r * 0.05,
        CHROME,
    );
    b.rod("hammer", [0.0, 0.0, crown - 0.1 * r], [0.0, 0.0, crown + dome * 0.7], r * 0.06, CHROME);
}

/// The segments of a digit: upper and lower right and left, then top, middle, bottom.
const DIGITS: [[bool; 7]; 10] = {
    const fn bits(v: u8) -> [bool; 7] {
        [v & 64 > 0, v & 32 > 0, v & 16 > 0, v & 8 > 0, v & 4 > 0, v & 2 > 0, v & 1 > 0]
    }
    [
        bits(0b111_1101),
        bits(0b110_0000),
        bits(0b101_0111),
        bits(0b110_0111),
        bits(0b110_1010),
        bits(0b010_1111),
        bits(0b011_1111),
        bits(0b110_0100),
        bits(0b111_1111),
        bits(0b110_1111),
    ]
};

/// A time in glowing digits, facing +X, in a rectangle of half width and height.
pub(in crate::object) fn digits(b: &mut Build<'_>, at: P, (w, h): (f32, f32), depth: f32, mat: MaterialId) {
    let time = [b.rng.below(3), b.rng.below(4), b.rng.below(6), b.rng.below(10)];
    let dw = w * 0.17;
    let bar = (h * 0.1).min(dw * 0.3);
    let mut list: Vec<(P, P)> = Vec::new();
    let mut bit = |y0: f32, y1: f32, z0: f32, z1: f32| {
        list.push(([at[0], at[1] + y0, at[2] + z0], [at[0] + depth, at[1] + y1, at[2] + z1]));
    };
    for (i, digit) in time.into_iter().enumerate() {
        let y = w * [-0.76, -0.3, 0.3, 0.76][i];
        let [ur, lr, ll, ul, top, mid, low] = DIGITS[digit];
        for (lit, z) in [(top, h), (mid, bar), (low, bar * 2.0 - h)] {
            if lit {
                bit(y - dw + bar, y + dw - bar, z - bar * 1.9, z - bar * 0.1);
            }
        }
        for (lit, side, z) in [(ur, 1.0, bar), (lr, 1.0, -h), (ll, -1.0, -h), (ul, -1.0, bar)] {
            let edge = y + side * dw;
            if lit {
                bit(edge - bar, edge + bar, z, z + h - bar);
            }
        }
    }
    bit(-bar, bar, h * 0.3, h * 0.55);
    bit(-bar, bar, -h * 0.55, -h * 0.3);
    blocks(b, "digits", &list, mat);
}

/// A clock radio: a slanted box with digits and buttons.
fn digital(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let case = b.choose(&[BLACK_PLASTIC, WHITE_PLASTIC, GREY_PLASTIC, b.style.wood]);
    let relief = (x * 0.06).min(0.003);
    let key = (h * 0.08).min(0.006);
    let (front, top) = (x - relief, h - key);
    b.rounded_block("case", [-x, -y, 0.0], [front, y, top], h * 0.12, case);
    let half = (y * 0.8, top * 0.32);
    b.block("screen", [front - 0.002, -y * 0.9, top * 0.1], [front + relief * 0.4, y * 0.9, top * 0.9], SCREEN);
    let glow = b.choose(&[SIGNAL_RED, LED, COOL_BULB, SIGNAL_AMBER]);
    digits(b, [front, 0.0, top / 2.0], half, relief, glow);
    let list = [-0.7, -0.4, 0.1, 0.5].map(|s| ([-x * 0.4, y * s, top - key * 0.5], [x * 0.2, y * (s + 0.2), h]));
    blocks(b, "button", &list, GREY_PLASTIC);
}
