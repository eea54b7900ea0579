//! Foliage of potted plants.

use std::f32::consts::{PI, TAU};

use vc_graph::portable::Portable;

use super::pot;
use crate::material::*;
use crate::solid::{Axis, Build, MeshBuilder, P, half_dims, hoop, mix, oval, spline};

/// The space for leaves: half depth and width, heights of the soil and of the top.
#[derive(Clone, Copy)]
struct Crown {
    x: f32,
    y: f32,
    low: f32,
    high: f32,
}

impl Crown {
    /// A point at an angle, at given fractions of the radius and of the height.
    fn at(&self, turn: f32, out: f32, up: f32) -> P {
        let (s, c) = turn.sine_cosine();
        [self.x * out * c, self.y * out * s, self.low + (self.high - self.low) * up.min(0.995)]
    }
}

/// A leaf that is widest at a given fraction of its length.
fn blade(wide: f32, at: f32) -> impl Fn(f32) -> f32 {
    move |t| wide * if t < at { (t / at).sqrt().max(0.08) } else { (1.0 - ((t - at) / (1.0 - at)).raised(2)).max(0.02) }
}

/// A house plant; its species depends on its proportions and the seed.
pub(super) fn plant(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let narrow = x.min(y);
    let tall = h / (2.0 * narrow);
    let kind = if b.class == "cactus" {
        b.choose(&[0, 0, 0, 1, 2])
    } else if tall > 1.6 {
        b.rng.count(4, 8)
    } else {
        b.choose(&[3, 4, 6, 9, 10, 11, 8])
    };
    let bowl = matches!(kind, 0 | 2) && tall < 1.3;
    let share = if tall > 1.6 { 0.2 } else { b.vary(0.28, 0.36) };
    let (pot_radius, pot_height) = (narrow * if bowl { 0.7 } else { b.vary(0.42, 0.6) }, h * share);
    let pot_height = pot_height.min(pot_radius * 2.2);
    let earth = pot(b, pot_radius, pot_height);
    let crown = Crown { x: x * 0.97, y: y * 0.97, low: earth, high: h * 0.99 };
    match kind {
        0 => cactus(b, crown, pot_radius),
        1 | 2 => succulent(b, crown),
        3 => cushion(b, crown),
        4 => sword(b, crown, pot_radius),
        5 => tree(b, crown),
        6 => big_leaved(b, crown),
        7 => palm(b, crown),
        8 => rubber_tree(b, crown),
        9 => fern(b, crown),
        10 => hanging(b, crown, pot_radius),
        _ => flowering(b, crown),
    }
}

fn green(b: &mut Build<'_>) -> MaterialId {
    b.choose(&[LEAF, LEAF, DARK_LEAF, LIGHT_LEAF])
}

/// A ribbed column or ball with arms or a flower.
fn cactus(b: &mut Build<'_>, c: Crown, pot: f32) {
    let mat = b.choose(&[LEAF, DARK_LEAF, SAGE]);
    let tall = c.high - c.low;
    let r = (pot * 0.55).min(tall * 0.6);
    let ribs = 10;
    let ring = |z: f32, s: f32| -> Vec<P> {
        (0..ribs * 2)
            .map(|i| {
                let (sin, cos) = (TAU * i as f32 / (ribs * 2) as f32).sine_cosine();
                let s = r * s * if i % 2 == 0 { 1.0 } else { 0.84 };
                [s * cos, s * sin, c.low + tall * 0.94 * z]
            })
            .collect()
    };
    let mut body = MeshBuilder::default();
    body.loft(&[ring(-0.03, 0.7), ring(0.2, 0.95), ring(0.6, 1.0), ring(0.88, 0.8), ring(0.97, 0.45), ring(1.0, 0.1)]);
    if tall > 3.0 * r {
        let arms = b.rng.count(1, 3);
        for i in 0..arms {
            let turn = 1.4 + 2.3 * i as f32;
            let up = b.vary(0.3, 0.5);
            let out = (r * 2.1).min(c.x.min(c.y) * 0.9);
            let (s, k) = turn.sine_cosine();
            let point = |reach: f32, z: f32| [reach * k, reach * s, c.low + tall * z];
            body.tapered(&spline(&[point(r * 0.6, up), point(out, up + 0.05), point(out, up + 0.3)], 4), |t| {
                r * (0.42 - 0.1 * t)
            });
        }
    }
    body.put(b, "cactus", mat);
    let flower = b.choose(&[PETAL_PINK, PETAL_YELLOW, PETAL_RED]);
    let mut petals = MeshBuilder::default();
    for i in 0..6 {
        let (s, k) = (TAU * i as f32 / 6.0).sine_cosine();
        let tip = [r * 0.4 * k, r * 0.4 * s, c.high - tall * 0.003];
        petals.leaf(
            &[[0.0, 0.0, c.low + tall * 0.92], mix([0.0, 0.0, c.low + tall * 0.93], tip, 0.6), tip],
            |t| r * 0.12 * (1.0 - t * 0.8),
            0.0,
        );
    }
    petals.put(b, "flower", flower);
}

/// A rosette of succulent leaves.
fn succulent(b: &mut Build<'_>, c: Crown) {
    let mat = b.choose(&[SAGE, LIGHT_LEAF, LEAF, GREEN_GLAZE]);
    let mut shell = MeshBuilder::default();
    for (ring, count) in [(0, 10), (1, 8), (2, 6), (3, 4)] {
        let level = ring as f32 / 3.0;
        for i in 0..count {
            let turn = TAU * (i as f32 + 0.5 * (ring % 2) as f32) / count as f32;
            let (out, up) = (0.97 - 0.24 * ring as f32, 0.25 + 0.72 * level);
            let line = [c.at(turn, 0.05, 0.0), c.at(turn, out * 0.6, up * 0.35), c.at(turn, out, up)];
            let wide = c.x.min(c.y) * (0.22 - 0.04 * ring as f32);
            shell.tapered(&line, |t| wide * (0.5 + 0.6 * t - 0.95 * t * t).max(0.04) * 0.8);
        }
    }
    shell.put(b, "leaf", mat);
}

/// A low dome of small round leaves.
fn cushion(b: &mut Build<'_>, c: Crown) {
    let mat = green(b);
    let other = b.choose(&[LIGHT_LEAF, LEAF, PURPLE_SKIN]);
    let mut shells = [MeshBuilder::default(), MeshBuilder::default()];
    let count = 70;
    for i in 0..count {
        let level = (i as f32 + 0.5) / count as f32;
        let turn = i as f32 * 2.399_963;
        let out = (1.0 - level * level).sqrt();
        let tip = c.at(turn, out * 0.97, 0.1 + 0.85 * level);
        let root = c.at(turn, out * 0.56, 0.05 + 0.62 * level);
        shells[i % 4 / 3].leaf(&[root, mix(root, tip, 0.5), tip], blade(c.x.min(c.y) * 0.13, 0.5), 0.2);
    }
    let [a, d] = shells;
    a.put(b, "leaf", mat);
    d.put(b, "leaf", other);
    let mut stems = MeshBuilder::default();
    let deep = ((c.high - c.low) * 0.62).min((c.low + (c.high - c.low) * 0.15) * 0.95);
    stems.egg(c.at(0.0, 0.0, 0.15), [c.x * 0.68, c.y * 0.68, deep]);
    stems.put(b, "shade", DARK_LEAF);
}

/// Upright sword-shaped leaves.
fn sword(b: &mut Build<'_>, c: Crown, pot: f32) {
    let mat = b.choose(&[DARK_LEAF, LEAF]);
    let other = b.choose(&[LIGHT_LEAF, LEAF, DARK_LEAF]);
    let mut shells = [MeshBuilder::default(), MeshBuilder::default()];
    let count = b.rng.count(9, 14);
    let wide = pot * b.vary(0.16, 0.24);
    for i in 0..count {
        let turn = i as f32 * 2.4;
        let (from, out) = (0.12 + 0.5 * (i as f32 / count as f32), b.vary(0.3, 0.95));
        let root = [pot * from * turn.cosine(), pot * from * turn.sine(), c.low - (c.high - c.low) * 0.004];
        let up = if i == 0 { 0.99 } else { b.vary(0.55, 0.97) };
        let tip = c.at(turn, out, up);
        let line = spline(&[root, mix(root, [root[0] * 1.6, root[1] * 1.6, tip[2]], 0.5), tip], 3);
        shells[i % 2].leaf(&line, blade(wide, 0.45), 0.25);
    }
    let [core, rest] = shells;
    core.put(b, "leaf", mat);
    rest.put(b, "leaf", other);
}

/// A slim trunk with a round head of leaves.
fn tree(b: &mut Build<'_>, c: Crown) {
    let bark = b.choose(&[BARK, PALE_BARK]);
    let tall = c.high - c.low;
    let fork = b.vary(0.35, 0.5);
    let sway = c.x * b.vary(-0.15, 0.15);
    let mut wood = MeshBuilder::default();
    let r = tall * 0.012;
    let head = [0.0, 0.0, c.low + tall * (fork + 1.0) / 2.0];
    wood.tapered(
        &spline(
            &[
                [0.0, 0.0, c.low - 0.003],
                [sway, sway * 0.5, c.low + tall * fork * 0.5],
                [0.0, 0.0, c.low + tall * fork],
                head,
            ],
            3,
        ),
        |t| r * (1.2 - 0.7 * t),
    );
    let mat = green(b);
    let mut shells = [MeshBuilder::default(), MeshBuilder::default()];
    let branches = b.rng.count(6, 9);
    let leaf = c.x.min(c.y) * b.vary(0.17, 0.24);
    for i in 0..branches {
        let turn = i as f32 * 2.4;
        let level = (i as f32 + 0.5) / branches as f32;
        let out = (0.35 + 0.5 * (level * PI).sine()) * b.vary(0.85, 1.0);
        let tip = c.at(turn, out, fork + (0.95 - fork) * level);
        let root = [0.0, 0.0, c.low + tall * (fork * 0.95 + 0.4 * (1.0 - fork) * level)];
        wood.tapered(&[root, mix(root, tip, 0.6), tip], |t| r * (0.6 - 0.4 * t));
        for k in 0..11 {
            let at = mix(root, tip, 0.3 + 0.7 * k as f32 / 10.0);
            let (s, q) = (k as f32 * 2.4 + turn).sine_cosine();
            let end = [
                (at[0] + leaf * 2.2 * q).max(-c.x).min(c.x),
                (at[1] + leaf * 2.2 * s).max(-c.y).min(c.y),
                (at[2] + leaf * (0.6 - 0.5 * (k % 3) as f32)).min(c.high * 0.998),
            ];
            shells[k % 2].leaf(&[at, mix(at, end, 0.5), end], blade(leaf * 0.75, 0.45), 0.15);
        }
    }
    wood.put(b, "trunk", bark);
    let [a, d] = shells;
    a.put(b, "leaf", mat);
    let other = green(b);
    d.put(b, "leaf", other);
}

/// Large split leaves on long stalks.
fn big_leaved(b: &mut Build<'_>, c: Crown) {
    let mat = b.choose(&[DARK_LEAF, LEAF]);
    let (mut stalks, mut leaves) = (MeshBuilder::default(), MeshBuilder::default());
    let count = b.rng.count(8, 13);
    let slits = b.rng.chance(0.6);
    for i in 0..count {
        let turn = i as f32 * 2.4 + b.vary(-0.2, 0.2);
        let level = (i as f32 + 0.7) / count as f32;
        let out = 0.6 * (1.0 - 0.45 * level);
        let knee = c.at(turn, out, 0.35 + 0.58 * level);
        let root = c.at(turn, 0.06, -0.01);
        let stalk = spline(&[root, c.at(turn, out * 0.35, 0.3 + 0.4 * level), knee], 4);
        stalks.tapered(&stalk, |_| (c.high - c.low) * 0.008);
        let tip = c.at(turn, 0.98 - 0.25 * level, 0.18 + 0.62 * level);
        let over = [
            f32::midpoint(knee[0], tip[0]),
            f32::midpoint(knee[1], tip[1]),
            (knee[2] + (knee[2] - tip[2]) * 0.12).min(c.high * 0.995),
        ];
        let wide = c.x.min(c.y) * (0.34 - 0.1 * level);
        let line = spline(&[knee, over, tip], 5);
        let shape = blade(wide, 0.35);
        leaves.leaf(
            &line,
            |t| shape(t) * if slits && ((t * 10.0) as usize) % 2 == 1 && t < 0.95 { 0.62 } else { 1.0 },
            0.18,
        );
    }
    stalks.put(b, "stalk", LEAF);
    leaves.put(b, "leaf", mat);
}

/// Fronds of narrow leaflets, arching from a short trunk.
fn palm(b: &mut Build<'_>, c: Crown) {
    let mat = green(b);
    let trunk = b.vary(0.1, 0.35);
    let tall = c.high - c.low;
    let top = c.low + tall * trunk;
    b.lathe(
        "trunk",
        [0.0, 0.0, c.low - 0.003],
        &[(tall * 0.035, 0.0), (tall * 0.022, tall * trunk), (0.0, tall * trunk + 0.004)],
        BARK,
    );
    let (mut ribs, mut leaves) = (MeshBuilder::default(), MeshBuilder::default());
    let count = b.rng.count(8, 11);
    for i in 0..count {
        let turn = i as f32 * 2.4;
        let level = i as f32 / count as f32;
        let out = 0.98 - 0.45 * level;
        let end = c.at(turn, out, trunk + (0.55 + 0.42 * level) * (1.0 - trunk));
        let over = c.at(turn, out * 0.55, trunk + (0.62 + 0.37 * level) * (1.0 - trunk));
        let line = spline(&[[0.0, 0.0, top], c.at(turn, out * 0.22, trunk + 0.42 * (1.0 - trunk)), over, end], 4);
        ribs.tapered(&line, |t| tall * (0.006 - 0.004 * t));
        let (sin, cos) = turn.sine_cosine();
        for (k, p) in line.iter().enumerate().skip(5) {
            for side in [-1.0_f32, 1.0] {
                let long = c.x.min(c.y) * 0.36 * (1.3 - k as f32 / line.len() as f32);
                let ahead = long * 0.7;
                let tip = [
                    (p[0] + ahead * cos - side * long * sin).max(-c.x).min(c.x),
                    (p[1] + ahead * sin + side * long * cos).max(-c.y).min(c.y),
                    (p[2] - long * 0.35).max(c.low),
                ];
                leaves.leaf(&[*p, mix(*p, tip, 0.5), tip], blade(long * 0.15, 0.4), 0.1);
            }
        }
    }
    ribs.put(b, "rib", LEAF);
    leaves.put(b, "leaf", mat);
}

/// A rubber tree: thick leaves along upright stems.
fn rubber_tree(b: &mut Build<'_>, c: Crown) {
    let mat = b.choose(&[DARK_LEAF, DARK_LEAF, PURPLE_SKIN, LEAF]);
    let (mut stems, mut leaves) = (MeshBuilder::default(), MeshBuilder::default());
    let tall = c.high - c.low;
    let count = b.rng.count(1, 3);
    for i in 0..count {
        let turn = i as f32 * 2.3;
        let out = if count == 1 { 0.0 } else { 0.3 };
        let up = 0.9 - 0.2 * i as f32;
        let stem = spline(&[c.at(turn, out * 0.2, -0.01), c.at(turn, out, up * 0.5), c.at(turn, out * 0.8, up)], 5);
        stems.tapered(&stem, |t| tall * (0.012 - 0.005 * t));
        let leaves_count = (18.0 * up) as usize;
        for k in 0..leaves_count {
            let t = 0.18 + 0.82 * k as f32 / leaves_count as f32;
            let at = stem[((t * (stem.len() - 1) as f32) as usize).min(stem.len() - 1)];
            let (s, q) = (k as f32 * 2.4 + turn).sine_cosine();
            let long = c.x.min(c.y) * (1.0 - out) * b.vary(0.8, 0.97) * (1.15 - 0.45 * t).min(1.0);
            let tip = [at[0] + long * q, at[1] + long * s, (at[2] + tall * 0.09).min(c.high * 0.998)];
            let mid = [at[0] + long * 0.5 * q, at[1] + long * 0.5 * s, (at[2] + tall * 0.1).min(c.high * 0.998)];
            leaves.leaf(&[at, mix(at, mid, 0.5), mid, tip], blade(long * 0.26, 0.55), 0.12);
        }
    }
    stems.put(b, "stem", BARK);
    leaves.put(b, "leaf", mat);
}

/// Arching fronds in all directions.
fn fern(b: &mut Build<'_>, c: Crown) {
    let mat = b.choose(&[LEAF, LIGHT_LEAF]);
    let mut leaves = MeshBuilder::default();
    let count = b.rng.count(22, 32);
    for i in 0..count {
        let turn = i as f32 * 2.4;
        let level = i as f32 / count as f32;
        let out = b.vary(0.8, 0.98) * (1.0 - 0.55 * level);
        let line = spline(
            &[
                c.at(turn, 0.05, 0.0),
                c.at(turn, out * 0.45, 0.55 + 0.42 * level),
                c.at(turn, out * 0.8, 0.5 + 0.4 * level),
                c.at(turn, out, 0.15 + 0.4 * level),
            ],
            5,
        );
        let wide = c.x.min(c.y) * 0.09;
        leaves.leaf(
            &line,
            |t| wide * (1.05 - t) * if ((t * 15.0) as usize).is_multiple_of(2) { 1.0 } else { 0.45 },
            0.2,
        );
    }
    leaves.put(b, "leaf", mat);
}

/// Vines that hang over the rim.
fn hanging(b: &mut Build<'_>, c: Crown, pot: f32) {
    let mat = b.choose(&[LEAF, LIGHT_LEAF, DARK_LEAF]);
    let (mut vines, mut leaves) = (MeshBuilder::default(), MeshBuilder::default());
    let count = b.rng.count(9, 14);
    for i in 0..count {
        let turn = i as f32 * 2.4;
        let (s, q) = turn.sine_cosine();
        let drop = c.low * b.vary(0.15, 0.8);
        let reach = (pot * 1.25).min(c.x.min(c.y) * 0.9);
        let line = spline(
            &[
                [0.0, 0.0, c.low],
                [reach * 0.5 * q, reach * 0.5 * s, c.low + (c.high - c.low) * b.vary(0.4, 0.95)],
                [reach * 0.95 * q, reach * 0.95 * s, c.low],
                [reach * q, reach * s, drop],
            ],
            4,
        );
        vines.tapered(&line, |_| pot * 0.02);
        for (k, p) in line.iter().enumerate().skip(2) {
            let side = if k % 2 == 0 { 1.0 } else { -1.0 };
            let size = c.x.min(c.y) * 0.16;
            let tip = [
                (p[0] + size * (q * 0.5 - side * s)).max(-c.x).min(c.x),
                (p[1] + size * (s * 0.5 + side * q)).max(-c.y).min(c.y),
                (p[2] - size * 0.3).max(0.0).min(c.high * 0.99),
            ];
            leaves.leaf(&[*p, mix(*p, tip, 0.5), tip], blade(size * 0.45, 0.3), 0.15);
        }
    }
    vines.put(b, "vine", LEAF);
    leaves.put(b, "leaf", mat);
}

/// Flowers on stems above leaves.
fn flowering(b: &mut Build<'_>, c: Crown) {
    let petal = b.choose(&[PETAL_RED, PETAL_WHITE, PETAL_PINK, PETAL_YELLOW, PETAL_BLUE]);
    let (mut leaves, mut stems, mut petals, mut hearts) =
        (MeshBuilder::default(), MeshBuilder::default(), MeshBuilder::default(), MeshBuilder::default());
    for i in 0..20 {
        let turn = i as f32 * 2.4;
        let out = b.vary(0.55, 0.97);
        let line = [c.at(turn, 0.05, 0.0), c.at(turn, out * 0.6, 0.35), c.at(turn, out, b.vary(0.05, 0.3))];
        leaves.leaf(&spline(&line, 3), blade(c.x.min(c.y) * 0.16, 0.55), 0.15);
    }
    let count = b.rng.count(5, 9);
    let size = c.x.min(c.y) * b.vary(0.18, 0.26);
    for i in 0..count {
        let turn = i as f32 * 2.4 + 0.5;
        let out = if i == 0 { 0.1 } else { b.vary(0.25, 0.68) };
        let head = c.at(turn, out, b.vary(0.7, 0.9));
        stems.tapered(&spline(&[c.at(turn, 0.05, 0.0), c.at(turn, out * 0.6, 0.45), head], 3), |_| size * 0.07);
        flower(&mut petals, &mut hearts, head, size, c.high);
    }
    leaves.put(b, "leaf", LEAF);
    stems.put(b, "stem", LEAF);
    petals.put(b, "petal", petal);
    hearts.put(b, "heart", PETAL_YELLOW);
}

/// Petals around a centre, facing up.
fn flower(petals: &mut MeshBuilder, hearts: &mut MeshBuilder, at: P, size: f32, high: f32) {
    for k in 0..6 {
        let (s, q) = (TAU * k as f32 / 6.0).sine_cosine();
        let point = |out: f32, up: f32| [at[0] + size * out * q, at[1] + size * out * s, (at[2] + size * up).min(high)];
        petals.leaf(
            &[at, point(0.5, 0.22), point(1.0, 0.2)],
            |t| size * 0.3 * (0.35 + 1.4 * t - 1.55 * t * t).max(0.05),
            0.1,
        );
    }
    hearts.egg(
        [at[0], at[1], (at[2] + size * 0.12).min(high - size * 0.13).max(size * 0.13)],
        [size * 0.2, size * 0.2, size * 0.13],
    );
}

/// An orchid: strap leaves, arching stems with a row of blossoms.
pub(super) fn orchid(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let pot_height = (h * 0.26).min(x.min(y) * 1.3);
    let earth = pot(b, x.min(y) * 0.5, pot_height);
    let c = Crown { x, y, low: earth, high: h };
    let petal = b.choose(&[PETAL_WHITE, PETAL_PINK, PETAL_WHITE, PURPLE_PLASTIC, PETAL_YELLOW]);
    let heart = b.choose(&[PETAL_YELLOW, PETAL_RED, PURPLE_SKIN]);
    let (mut leaves, mut stems, mut petals, mut hearts) =
        (MeshBuilder::default(), MeshBuilder::default(), MeshBuilder::default(), MeshBuilder::default());
    for i in 0..6 {
        let turn = i as f32 * 2.4;
        let out = b.vary(0.7, 0.96);
        let line = [c.at(turn, 0.04, 0.0), c.at(turn, out * 0.5, 0.16), c.at(turn, out, b.vary(0.02, 0.1))];
        leaves.leaf(&spline(&line, 4), blade(x.min(y) * 0.2, 0.55), 0.2);
    }
    let count = b.rng.count(1, 2);
    for i in 0..count {
        let side = if i == 0 { 1.0 } else { -1.0 };
        let tall = 0.93 - 0.14 * i as f32;
        let line = spline(
            &[
                [0.0, 0.0, c.low],
                [0.0, side * y * 0.08, c.low + (h - c.low) * 0.5],
                [x * 0.1, side * y * 0.3, c.low + (h - c.low) * tall],
                [x * 0.25, side * y * 0.75, c.low + (h - c.low) * (tall - 0.14)],
            ],
            6,
        );
        stems.tapered(&line, |t| x * (0.025 - 0.01 * t));
        let size = x.min(y) * 0.3;
        for (k, p) in line.iter().enumerate().skip(9).step_by(3) {
            let size = size * (1.1 - 0.4 * k as f32 / line.len() as f32);
            blossom(
                &mut petals,
                &mut hearts,
                [p[0] + size * 0.05, p[1], (p[2] - size * 0.12).min(h - size * 0.85)],
                size,
                c,
            );
        }
    }
    leaves.put(b, "leaf", DARK_LEAF);
    stems.put(b, "stem", LEAF);
    petals.put(b, "petal", petal);
    hearts.put(b, "heart", heart);
    let tie = oval(Axis::Z, [0.0, 0.0, c.low + (h - c.low) * 0.25], (x * 0.03, x * 0.03), 0, 8);
    hoop(b, "clip", &tie, x * 0.012, PINK_PLASTIC);
}

/// Five petals and a lip, facing the front.
fn blossom(petals: &mut MeshBuilder, hearts: &mut MeshBuilder, at: P, size: f32, c: Crown) {
    for (k, long) in [1.0, 0.95, 0.75, 0.75, 0.95].into_iter().enumerate() {
        let (s, q) = (TAU * k as f32 / 5.0).sine_cosine();
        let point = |out: f32, ahead: f32| {
            [
                (at[0] + size * ahead).min(c.x),
                (at[1] + size * out * s).max(-c.y).min(c.y),
                (at[2] + size * out * q).min(c.high),
            ]
        };
        let (mid, tip) = (point(0.5 * long, 0.12), point(0.85 * long, 0.06));
        petals.tapered(&[at, mid, tip], |t| size * 0.28 * (0.3 + 1.6 * t - 1.75 * t * t).max(0.06));
    }
    hearts.egg(
        [
            (at[0] + size * 0.15).min(c.x - size * 0.15),
            at[1].max(size * 0.15 - c.y).min(c.y - size * 0.15),
            at[2] - size * 0.1,
        ],
        [size * 0.15, size * 0.15, size * 0.2],
    );
}
