//! Boats.

use vc_graph::portable::Portable;

use crate::material::*;
use crate::solid::{Axis, Build, P, at_least, hull_shell, mix, spaced};

/// Shape of a hull: fullness of its ends (front and rear), bend of its section, forward rise of the
/// sheer.
struct Lines {
    bow: f32,
    stern: f32,
    bend: f32,
    sheer: f32,
    rocker: f32,
    skin: f32,
}

impl Lines {
    /// Half width, keel and rim at a position from -1 (stern) to 1 (bow), for a hull of half width
    /// `y` whose highest rim is `h`.
    fn at(&self, s: f32, y: f32, h: f32) -> (f32, f32, f32) {
        let full = if s > 0.0 { 1.0 - s.power(self.bow) } else { 1.0 - (1.0 - self.stern) * s.raised(4).min(1.0) };
        let rise = if s > 0.0 { s * s } else { s * s * 0.4 };
        let rim = h * (1.0 - self.sheer + self.sheer * rise);
        let keel = h * self.rocker * if s > 0.0 { s.raised(4) } else { 0.3 * s.raised(4) };
        ((y * full).max(y * 0.03), keel, rim)
    }

    fn build(&self, b: &mut Build<'_>, (x, y, h): (f32, f32, f32), mat: MaterialId) {
        let (mut outer, mut inner) = (Vec::new(), Vec::new());
        for s in [-1.0_f32, -0.8, -0.5, -0.2, 0.1, 0.35, 0.58, 0.78, 0.92, 1.0] {
            let (half, keel, rim) = self.at(s, y, h);
            let t = self.skin.min(half * 0.5);
            let row = |half: f32, keel: f32, x: f32| -> Vec<P> {
                let across = (0..=8).map(|j| 1.0 - j as f32 / 4.0);
                across
                    .map(|u: f32| {
                        [x, half * u.signum() * u.abs().power(0.75), keel + (rim - keel) * u.abs().power(self.bend)]
                    })
                    .collect()
            };
            outer.push(row(half, keel, x * s));
            let end = (x - self.skin) / x;
            inner.push(row(half - t, (keel + self.skin).min(rim - 0.005), x * s * end));
        }
        // The transom, if the stern is wide enough for one.
        if self.stern > 0.4 {
            let board: Vec<(f32, f32)> =
                outer.first().iter().flat_map(|row| row.iter().map(|p| (p[1], p[2]))).collect();
            b.prism("transom", Axis::X, [-x + 0.001, 0.0, 0.0], &board, self.skin - 0.002, mat);
        }
        hull_shell(b, "hull", &outer, &inner, mat);
    }

    /// A level board across the hull at the fractions `x`, at height `z`, up to its skin.
    fn across(&self, s: f32, z: f32, (y, h): (f32, f32)) -> f32 {
        let (half, keel, rim) = self.at(s, y, h);
        let up = ((z - keel) / (rim - keel).max(1e-3)).clamp(0.05, 1.0);
        half * up.power(1.0 / self.bend).power(0.75)
    }
}

const PAINTS: &[MaterialId] = &[WHITE, NAVY, RED, FOREST, SKY, YELLOW, CREAM, TEAK];

/// A rowing boat: floorboards, thwarts and a pair of oars.
pub(super) fn rowing_boat(b: &mut Build<'_>) {
    at_least(b, [1.1, 0.6, 0.2]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0 - 0.01, b.size.z);
    let lines = Lines {
        bow: b.vary(2.0, 3.2),
        stern: b.vary(0.6, 0.85),
        bend: b.vary(1.6, 2.6),
        sheer: b.vary(0.1, 0.3),
        rocker: 0.3,
        skin: 0.02,
    };
    let mat = b.one_of(PAINTS);
    lines.build(b, (x, y, h), mat);
    let wood = b.choose(&[PINE, OAK, TEAK, MAHOGANY]);
    let floor = h * 0.2;
    let wide = lines.across(0.35, floor, (y, h)).min(lines.across(-0.6, floor, (y, h))) - 0.01;
    b.block("floor", [-x * 0.6, -wide, floor - 0.02], [x * 0.35, wide, floor], wood);
    b.block("keelson", [-x * 0.6, -0.05, 0.012], [x * 0.35, 0.05, floor - 0.01], wood);
    let level = h * (1.0 - lines.sheer) * 0.68;
    let seats = b.rng.count(2, 3);
    for (i, s) in spaced(seats, -0.72, 0.45).enumerate() {
        let half = lines.across(s - 0.08, level - 0.03, (y, h)).min(lines.across(s + 0.08, level - 0.03, (y, h)));
        b.block("thwart", [x * s - 0.1, -half, level - 0.03], [x * s + 0.1, half, level], wood);
        b.top(&format!("seat_{}", i + 1), [x * s, 0.0, level], (0.09, half * 0.4));
    }
    let gap = 1.17 / (seats - 1) as f32 * x;
    let middle = -0.72 * x + gap / 2.0;
    b.inside(
        "compartment",
        [middle.max(-0.5 * x), 0.0, floor],
        ((gap / 2.0 - 0.12).max(0.03).min(0.3 * x), wide * 0.8),
        level - floor - 0.005,
    );
    oars(b, &lines, (x, y, h), wood);
}

/// Oars laid along the thwarts, and their rowlocks.
fn oars(b: &mut Build<'_>, lines: &Lines, (x, y, h): (f32, f32, f32), wood: MaterialId) {
    let level = h * (1.0 - lines.sheer) * 0.68 + 0.022;
    for side in [-1.0, 1.0] {
        let lane = |s: f32| side * lines.across(s, level, (y, h)) * 0.8;
        let (from, to) = ([-x * 0.8, lane(-0.8), level], [x * 0.55, lane(0.55), level]);
        let flat = 0.07_f32.min(y * 0.12);
        b.rod("oar", from, to, 0.02, wood);
        let blade = mix(from, to, 0.82);
        b.hull(
            "blade",
            &[
                [blade[0], blade[1] - 0.02, level - 0.01],
                [blade[0], blade[1] + 0.02, level + 0.01],
                [to[0], to[1] - flat, level - 0.01],
                [to[0], to[1] + flat, level - 0.01],
                [to[0], to[1] + flat, level + 0.01],
                [to[0], to[1] - flat, level + 0.01],
            ],
            wood,
        );
        let (half, _, rim) = lines.at(0.0, y, h);
        let (top, z) = ((h - 0.005).min(rim + 0.06), rim - 0.04);
        b.cylinder("lock", [0.0, side * (half - 0.014), z], 0.009, top - z, BRASS);
    }
}

/// A kayak: decked at both ends, with one or two cockpits and a paddle on deck.
pub(super) fn kayak(b: &mut Build<'_>) {
    at_least(b, [1.3, 0.3, 0.14]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let lines = Lines {
        bow: b.vary(1.5, 2.2),
        stern: b.vary(0.05, 0.25),
        bend: b.vary(1.8, 3.0),
        sheer: b.vary(0.1, 0.25),
        rocker: 0.5,
        skin: 0.012,
    };
    let mat = b.choose(&[RED_PLASTIC, YELLOW_PLASTIC, ORANGE_PLASTIC, BLUE_PLASTIC, GREEN_PLASTIC, WHITE_PLASTIC]);
    lines.build(b, (x, y, h * 0.93), mat);
    let pit = if x > 1.8 && b.rng.chance(0.5) { (-0.45, 0.35) } else { (-0.28, 0.2) };
    let top = h * 0.93;
    for (from, to) in [(pit.1, 1.0), (-1.0, pit.0)] {
        let mut points = Vec::new();
        for s in spaced(6, from, to) {
            let (half, _, rim) = lines.at(s, y, top);
            let crown = rim + (h - rim).min(0.06) * (1.0 - s.abs()).max(0.0);
            let (px, half) = (x * s * 0.995, (half - 0.004).max(0.004));
            points.extend([
                [px, half, rim - 0.002],
                [px, -half, rim - 0.002],
                [px, 0.0, crown.min(h)],
                [px, 0.0, rim - 0.02],
            ]);
        }
        b.hull("deck", &points, mat);
    }
    let seats = if pit.1 - pit.0 > 0.6 { 2 } else { 1 };
    for s in spaced(seats, pit.0 + 0.14, pit.0 + 0.14 + 0.42 * (seats as f32 - 1.0)) {
        let z = h * 0.22;
        let half = lines.across(s, z, (y, top)) * 0.85;
        b.block("seat", [x * s - 0.16, -half, z - 0.03], [x * s + 0.16, half, z + 0.02], BLACK_PLASTIC);
        b.block("back", [x * s - 0.19, -half * 0.9, z - 0.02], [x * s - 0.15, half * 0.9, top * 0.9], BLACK_PLASTIC);
        b.block("post", [x * s - 0.14, -half * 0.4, 0.012], [x * s + 0.1, half * 0.4, z], BLACK_PLASTIC);
    }
    let (s0, s1) = (pit.0 + 0.16 + 0.42 * (seats as f32 - 1.0), pit.1);
    let start = x * (s0 - 0.02) + 0.17;
    let (end, floor) = ((x * s1 - 0.03).max(start + 0.06), (h * 0.08).max(0.03));
    let half = lines.across(0.1, floor, (y, top)).min(lines.across(s1, floor, (y, top))) * 0.65;
    b.block("mat", [start - 0.02, -half, 0.012], [end, half, floor], GREY_RUBBER);
    b.inside("compartment", [(start + end) / 2.0, 0.0, floor], ((end - start) / 2.0 - 0.005, half * 0.9), h * 0.6);
    for side in [-1.0, 1.0] {
        let at = |s: f32| [x * s, side * lines.at(s, y, top).0 * 0.93, top * (1.0 - lines.sheer * 0.97)];
        b.rod("coaming", at(pit.0), at((pit.0 + pit.1) / 2.0), 0.012, BLACK_PLASTIC);
        b.rod("coaming", at((pit.0 + pit.1) / 2.0), at(pit.1), 0.012, BLACK_PLASTIC);
    }
    let z = (top * (1.0 - lines.sheer) + 0.02).min(h - 0.01);
    let (from, to) = ([x * (pit.1 + 0.05), y * 0.3, z], [x * 0.75, y * 0.05, z]);
    b.rod("paddle", from, to, 0.012, BLACK_PLASTIC);
}

/// A motorboat: a front deck, windscreen, seats and an outboard motor.
pub(super) fn motorboat(b: &mut Build<'_>) {
    at_least(b, [2.2, 0.9, 0.6]);
    let (h, y) = (b.size.z, b.size.y / 2.0);
    let tail = (b.size.x * 0.09).min(0.5);
    let x = (b.size.x - tail) / 2.0;
    let lines = Lines {
        bow: b.vary(1.9, 2.8),
        stern: b.vary(0.85, 0.95),
        bend: b.vary(1.3, 1.9),
        sheer: b.vary(0.1, 0.25),
        rocker: 0.45,
        skin: 0.04,
    };
    let rim = h * b.vary(0.62, 0.72);
    let mat = b.choose(&[WHITE_METAL, NAVY, RED_METAL, CREAM, SKY]);
    b.at([tail / 2.0, 0.0, 0.0], 0.0, |b| {
        lines.build(b, (x, y - 0.01, rim), mat);
        let size = (y - 0.01, rim);
        let floor = rim * 0.35;
        let wide = lines.across(-0.6, floor, size).min(lines.across(0.15, floor, size));
        b.block("floor", [-x * 0.93, -wide, floor - 0.04], [x * 0.2, wide, floor], TEAK);
        b.block("keelson", [-x * 0.9, -0.08, 0.03], [x * 0.2, 0.08, floor - 0.02], mat);
        let mut deck = Vec::new();
        for s in spaced(6, 0.2, 0.995) {
            let (half, _, top) = lines.at(s, size.0, rim);
            deck.extend([
                [x * s, half - 0.005, top - 0.003],
                [x * s, -half + 0.005, top - 0.003],
                [x * s, 0.0, top + 0.05],
                [x * s, 0.0, top - 0.06],
            ]);
        }
        b.hull("deck", &deck, WHITE_PLASTIC);
        let (front, top) = (x * 0.2, rim * (1.0 - lines.sheer * 0.95));
        let half = lines.at(0.2, size.0, rim).0;
        let glass = [
            [front + 0.25, -half * 0.4, top + 0.02],
            [front + 0.25, half * 0.4, top + 0.02],
            [front, half * 0.85, top],
            [front, -half * 0.85, top],
        ];
        let lean: Vec<P> = glass.iter().flat_map(|p| [*p, [p[0] - (h - top) * 0.4, p[1] * 0.92, h]]).collect();
        for pair in [[0, 1], [1, 2], [3, 0]] {
            let points: Vec<P> = pair
                .iter()
                .flat_map(|&i| [lean[2 * i], lean[2 * i + 1]])
                .flat_map(|p| [p, [p[0] - 0.012, p[1] * 0.99, p[2]]])
                .collect();
            b.hull("screen", &points, BLUE_GLASS);
        }
        b.block("dashboard", [front - 0.12, -half * 0.8, floor - 0.01], [front + 0.05, half * 0.8, top], mat);
        let hub = [front - 0.2, half * 0.4, top - 0.06];
        b.rod("column", [front - 0.1, hub[1], hub[2]], hub, 0.02, IRON);
        b.lathe_along(
            "steering_wheel",
            hub,
            [hub[0] - 1.0, hub[1], hub[2] + 0.3],
            &[(0.16, 0.0), (0.16, 0.025), (0.0, 0.025)],
            BLACK_LEATHER,
        );
        let leather = b.choose(&[WHITE_LEATHER, TAN_LEATHER, BLACK_LEATHER]);
        let deep = x * 0.16;
        for side in [-1.0, 1.0] {
            let cy = side * wide * 0.52;
            let sx = -x * 0.18;
            b.rounded_block(
                "seat",
                [sx, cy - wide * 0.3, floor - 0.005],
                [sx + deep, cy + wide * 0.3, floor + rim * 0.3],
                0.04,
                leather,
            );
            b.rounded_block(
                "back",
                [sx - 0.08, cy - wide * 0.3, floor],
                [sx + 0.04, cy + wide * 0.3, floor + rim * 0.75],
                0.04,
                leather,
            );
        }
        let chest = (-x * 0.9, -x * 0.9 + x * 0.28);
        let stern = lines.across(-0.92, floor, size) - 0.03;
        storage_bench(b, chest, (stern.min(wide * 0.95) * 0.94, floor, floor + rim * 0.32), leather);
    });
    outboard(b, tail, x, rim);
}

/// A bench across the stern; its cushion is the lid of a storage chest.
fn storage_bench(b: &mut Build<'_>, (x0, x1): (f32, f32), (half, low, high): (f32, f32, f32), leather: MaterialId) {
    let t = 0.02;
    for (from, to) in [
        ([x0, -half], [x0 + t, half]),
        ([x1 - t, -half], [x1, half]),
        ([x0 + t, -half], [x1 - t, -half + t]),
        ([x0 + t, half - t], [x1 - t, half]),
    ] {
        b.block("chest", [from[0], from[1], low - 0.005], [to[0], to[1], high - 0.05], WHITE_PLASTIC);
    }
    b.hinge([x0, 0.0, high - 0.05], [0.0, -1.0, 0.0], 1.3, |b| {
        b.rounded_block("bench", [x0, -half, high - 0.05], [x1, half, high], 0.02, leather);
        b.top("bench", [(x0 + x1) / 2.0, 0.0, high], ((x1 - x0) / 2.0 * 0.9, half * 0.9));
    });
    let centre = [(x0 + x1) / 2.0, 0.0, low];
    b.inside("compartment", centre, ((x1 - x0) / 2.0 - t - 0.01, half - t - 0.01), high - low - 0.06);
}

fn outboard(b: &mut Build<'_>, tail: f32, x: f32, rim: f32) {
    let stern = tail / 2.0 - x;
    let end = stern - tail;
    let mat = b.choose(&[BLACK_PLASTIC, WHITE_PLASTIC, GREY_PLASTIC]);
    let half = 0.17_f32.min(b.size.y * 0.12);
    b.rounded_block("motor", [end, -half, rim * 0.72], [stern - tail * 0.2, half, rim * 1.12], 0.05, mat);
    b.block("bracket", [stern - tail * 0.25, -half * 0.6, rim * 0.55], [stern + 0.06, half * 0.6, rim * 0.85], IRON);
    b.prism(
        "leg",
        Axis::Y,
        [0.0, -half * 0.25, 0.0],
        &[
            (end + tail * 0.2, rim * 0.73),
            (end + tail * 0.6, rim * 0.73),
            (end + tail * 0.55, rim * 0.1),
            (end + tail * 0.3, rim * 0.1),
        ],
        half * 0.5,
        mat,
    );
    b.rod("gearbox", [end + tail * 0.2, 0.0, rim * 0.17], [end + tail * 0.75, 0.0, rim * 0.17], half * 0.35, mat);
    for (dy, dz) in [(1.0, 0.0), (-0.5, 0.87), (-0.5, -0.87)] {
        let r = (rim * 0.15).min(half);
        let at = [end + tail * 0.17, 0.0, rim * 0.17];
        b.rod("propeller", at, [at[0] - 0.01, dy * r, at[2] + dz * r], 0.02, STEEL);
    }
}
