//! Fruit and vegetables with a single round or long body and a stalk or leaves.

use std::f32::consts::TAU;

use vc_graph::portable::Portable;

use crate::material::*;
use crate::solid::{Build, P, boulder, dims, loft_columns, lump, planar_tube, spun, sweep};

type Profile = &'static [(f32, f32)];

const BALL: Profile = &[
    (0.0, 0.0),
    (0.4, 0.04),
    (0.72, 0.15),
    (0.93, 0.31),
    (1.0, 0.5),
    (0.93, 0.69),
    (0.72, 0.85),
    (0.4, 0.96),
    (0.0, 1.0),
];
const APPLE: Profile = &[
    (0.0, 0.07),
    (0.28, 0.0),
    (0.6, 0.05),
    (0.87, 0.26),
    (1.0, 0.54),
    (0.96, 0.77),
    (0.74, 0.94),
    (0.42, 1.0),
    (0.16, 0.93),
    (0.0, 0.86),
];
const SQUAT: Profile = &[
    (0.0, 0.05),
    (0.4, 0.0),
    (0.78, 0.14),
    (0.98, 0.4),
    (1.0, 0.58),
    (0.85, 0.85),
    (0.5, 1.0),
    (0.16, 0.95),
    (0.0, 0.9),
];
const PEAR: Profile = &[
    (0.0, 0.03),
    (0.4, 0.0),
    (0.82, 0.1),
    (1.0, 0.28),
    (0.91, 0.46),
    (0.64, 0.66),
    (0.48, 0.84),
    (0.3, 0.97),
    (0.0, 1.0),
];
const LEMON: Profile = &[
    (0.0, 0.0),
    (0.17, 0.01),
    (0.26, 0.07),
    (0.62, 0.15),
    (0.93, 0.33),
    (1.0, 0.5),
    (0.93, 0.67),
    (0.62, 0.85),
    (0.22, 0.95),
    (0.13, 1.0),
    (0.0, 1.0),
];
const OVAL: Profile = &[
    (0.0, 0.0),
    (0.45, 0.05),
    (0.78, 0.17),
    (0.96, 0.36),
    (1.0, 0.55),
    (0.9, 0.76),
    (0.62, 0.92),
    (0.3, 0.98),
    (0.0, 1.0),
];
const ONION: Profile = &[
    (0.0, 0.02),
    (0.15, 0.0),
    (0.2, 0.05),
    (0.7, 0.16),
    (1.0, 0.4),
    (0.9, 0.62),
    (0.5, 0.78),
    (0.2, 0.86),
    (0.12, 0.95),
    (0.18, 1.0),
    (0.0, 1.0),
];
const ROOT: Profile =
    &[(0.0, 0.0), (0.1, 0.06), (0.45, 0.24), (0.9, 0.5), (1.0, 0.68), (0.82, 0.88), (0.4, 0.98), (0.0, 1.0)];
const CONE: Profile =
    &[(0.0, 0.0), (0.15, 0.01), (0.45, 0.22), (0.75, 0.6), (0.95, 0.9), (1.0, 0.95), (0.8, 0.995), (0.0, 1.0)];
const LONG: Profile = &[
    (0.0, 0.0),
    (0.6, 0.01),
    (0.85, 0.05),
    (0.97, 0.15),
    (1.0, 0.5),
    (0.97, 0.85),
    (0.8, 0.95),
    (0.5, 0.99),
    (0.0, 1.0),
];
const CLUB: Profile =
    &[(0.0, 0.0), (0.6, 0.02), (0.9, 0.12), (1.0, 0.28), (0.9, 0.5), (0.68, 0.75), (0.5, 0.93), (0.4, 1.0), (0.0, 1.0)];
const BERRY: Profile = &[(0.0, 0.0), (0.25, 0.03), (0.6, 0.25), (0.92, 0.62), (1.0, 0.8), (0.75, 0.97), (0.0, 1.0)];
const EGG: Profile = &[
    (0.0, 0.0),
    (0.42, 0.03),
    (0.78, 0.14),
    (0.97, 0.32),
    (1.0, 0.44),
    (0.9, 0.66),
    (0.66, 0.85),
    (0.35, 0.96),
    (0.0, 1.0),
];
const BELL: Profile = &[
    (0.0, 0.06),
    (0.4, 0.0),
    (0.72, 0.05),
    (0.85, 0.3),
    (1.0, 0.7),
    (0.95, 0.88),
    (0.65, 1.0),
    (0.3, 0.96),
    (0.0, 0.9),
];

/// The end piece on top of a body.
#[derive(Clone, Copy, PartialEq)]
enum Top {
    Bare,
    /// A dot in place of the stalk.
    Dot,
    /// A short stalk, with or without a leaf.
    Stalk,
    /// A green star.
    Star,
    /// A tuft of long leaves.
    Tuft,
    /// A thick green cut end towards +Y.
    Cap,
}

/// The outline, colours and end piece of a body, and whether it lies along Y.
fn sort(class: &str) -> (Profile, &'static [MaterialId], bool, Top) {
    match class {
        "apple" => (APPLE, &[RED_SKIN, RED_SKIN, GREEN_SKIN, YELLOW_SKIN], false, Top::Stalk),
        "orange" => (BALL, &[ORANGE_SKIN], false, Top::Dot),
        "mandarin" => (SQUAT, &[ORANGE_SKIN], false, Top::Star),
        "grapefruit" => (BALL, &[YELLOW_SKIN, ORANGE_SKIN], false, Top::Dot),
        "lemon" => (LEMON, &[YELLOW_SKIN], true, Top::Bare),
        "lime" => (LEMON, &[GREEN_SKIN, LIGHT_LEAF], true, Top::Bare),
        "pear" => (PEAR, &[GREEN_SKIN, YELLOW_SKIN, LIGHT_LEAF], false, Top::Stalk),
        "peach" => (APPLE, &[ORANGE_SKIN, PETAL_PINK, TERRACOTTA], false, Top::Stalk),
        "plum" => (OVAL, &[PURPLE_SKIN, RED_SKIN], false, Top::Stalk),
        "apricot" => (SQUAT, &[ORANGE_SKIN], false, Top::Dot),
        "kiwi" => (OVAL, &[BROWN_SKIN], false, Top::Dot),
        "mango" => (OVAL, &[GREEN_SKIN, ORANGE_SKIN, RED_SKIN], true, Top::Bare),
        "pineapple" => (OVAL, &[MUSTARD, BROWN_SKIN], false, Top::Tuft),
        "melon" => (BALL, &[LIGHT_LEAF, YELLOW_SKIN, HAY], true, Top::Bare),
        "watermelon" => (OVAL, &[DARK_LEAF, LEAF], true, Top::Bare),
        "coconut" => (OVAL, &[BROWN_SKIN, BARK], true, Top::Bare),
        "avocado" => (PEAR, &[DARK_LEAF, BARK], false, Top::Dot),
        "strawberry" => (BERRY, &[RED_SKIN], false, Top::Star),
        "tomato" => (SQUAT, &[RED_SKIN, RED_SKIN, ORANGE_SKIN], false, Top::Star),
        "onion" => (ONION, &[BROWN_SKIN, CRUST, PURPLE_SKIN, PETAL_WHITE], false, Top::Bare),
        "garlic" => (ONION, &[PETAL_WHITE, PALE_FLESH], false, Top::Bare),
        "beetroot" => (ROOT, &[PURPLE_SKIN], false, Top::Tuft),
        "radish" => (SQUAT, &[RED_SKIN, PETAL_PINK], false, Top::Tuft),
        "bell_pepper" => (BELL, &[RED_SKIN, YELLOW_SKIN, GREEN_SKIN, ORANGE_SKIN], false, Top::Stalk),
        "cucumber" => (LONG, &[DARK_LEAF, LEAF], true, Top::Bare),
        "zucchini" => (LONG, &[DARK_LEAF, LEAF], true, Top::Cap),
        "eggplant" => (CLUB, &[PURPLE_SKIN], true, Top::Cap),
        "carrot" => (CONE, &[ORANGE_SKIN], true, Top::Tuft),
        "sweet_potato" => (LEMON, &[TERRACOTTA, CRUST], true, Top::Bare),
        "egg" => (EGG, &[EGGSHELL, PETAL_WHITE, EGGSHELL], false, Top::Bare),
        _ => (BALL, &[GREEN_SKIN], false, Top::Bare),
    }
}

/// Fruit, roots and vegetables with a single body.
pub(super) fn single(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (profile, skins, lying, top) = sort(b.class);
    let skin = b.one_of(skins);
    let share = match (b.class, top) {
        ("pineapple", _) => b.vary(0.55, 0.65),
        ("carrot", _) => b.vary(0.75, 0.95),
        ("beetroot" | "radish", _) => b.vary(0.6, 0.75),
        (_, Top::Stalk) => 0.88,
        (_, Top::Star) => 0.94,
        (_, Top::Cap) => 0.86,
        _ => 1.0,
    };
    let plump = b.vary(0.88, 1.12);
    let profile: Vec<_> = profile.iter().map(|p| (p.0.power(plump), p.1)).collect();
    let (hx, hy) = (x / 2.0, y / 2.0);
    let (low, high, end): (P, P, P) = if lying {
        let end = -hy + y * share;
        ([-hx, -hy, 0.0], [hx, end, z], [0.0, end, z / 2.0])
    } else {
        let high = z * share;
        let last = profile.last().map_or(high, |p| p.1 * high);
        ([-hx, -hy, 0.0], [hx, hy, high], [0.0, 0.0, last])
    };
    let name = if b.class == "egg" { "shell" } else { "flesh" };
    spun(b, name, (low, high), &profile, lying, skin);
    match b.class {
        "pineapple" => knobs(b, (hx, hy), high[2]),
        "watermelon" => stripes(b, (low, high), &profile),
        "garlic" => cloves(b, (hx, hy), high[2]),
        "pumpkin" => {}
        _ => {}
    }
    crown(b, top, end, lying, skin);
}

/// Builds the end piece of a fruit at `end`.
fn crown(b: &mut Build<'_>, top: Top, end: P, lying: bool, skin: MaterialId) {
    let (x, y, z) = dims(b);
    let r = x.min(if lying { z } else { y }) / 2.0;
    match top {
        Top::Bare => {}
        Top::Dot => {
            let up = end[2] - r * 0.04;
            b.cylinder("stalk", [0.0, 0.0, up], r * 0.1, r * 0.04, if skin == BROWN_SKIN { BARK } else { LEAF });
        }
        Top::Stalk => {
            let lean = r * b.vary(-0.15, 0.15);
            let thick = r * if b.class == "bell_pepper" { 0.14 } else { 0.055 };
            let mat = if b.class == "bell_pepper" { LEAF } else { BARK };
            planar_tube(
                b,
                "stalk",
                &[[0.0, 0.0, end[2] - r * 0.05], [lean * 0.3, 0.0, f32::midpoint(end[2], z)], [lean, 0.0, z]],
                thick,
                [0.0, 1.0, 0.0],
                mat,
            );
            if b.class == "apple" && b.rng.chance(0.5) {
                let at = z * 0.97;
                b.hull(
                    "leaf",
                    &[
                        [lean, 0.0, at - r * 0.05],
                        [r * 0.3, -r * 0.15, at],
                        [r * 0.55, 0.0, at - r * 0.1],
                        [r * 0.3, r * 0.15, at],
                        [r * 0.3, 0.0, at - r * 0.03],
                    ],
                    LEAF,
                );
            }
        }
        Top::Star => {
            let reach = r * if b.class == "strawberry" { 0.75 } else { 0.45 };
            for i in 0..5 {
                b.at([0.0, 0.0, 0.0], TAU * i as f32 / 5.0, |b| {
                    let base = end[2].min(z * 0.94);
                    b.hull(
                        "sepal",
                        &[
                            [0.0, -r * 0.1, base],
                            [0.0, r * 0.1, base],
                            [reach, 0.0, base + r * 0.02],
                            [reach * 0.4, 0.0, base + r * 0.1],
                            [0.0, 0.0, base + r * 0.06],
                        ],
                        LEAF,
                    );
                });
            }
            b.rod("stalk", [0.0, 0.0, z * 0.85], [0.0, 0.0, z], r * 0.06, LEAF);
        }
        Top::Cap => {
            let (from, to) = (end[1] - y * 0.09, y / 2.0);
            let path = [
                ([0.0, from, z / 2.0], r * 0.5, r * 0.5),
                ([0.0, end[1] - y * 0.02, z / 2.0], r * 0.48, r * 0.48),
                ([0.0, end[1] + y * 0.02, z / 2.0], r * 0.25, r * 0.25),
                ([0.0, to, z / 2.0], r * 0.18, r * 0.18),
            ];
            sweep(b, "stalk", &path, [1.0, 0.0, 0.0], LEAF);
        }
        Top::Tuft => tuft(b, end, lying, r),
    }
}

/// Leaves that spread from the end of a root or a pineapple.
fn tuft(b: &mut Build<'_>, end: P, lying: bool, r: f32) {
    let (_, y, z) = dims(b);
    let length = if lying { y / 2.0 - end[1] } else { z - end[2] };
    let count = if b.class == "pineapple" { 14 } else { 5 };
    let mat = b.choose(&[LEAF, DARK_LEAF]);
    for i in 0..count {
        let (s, c) = (2.4 * i as f32).sine_cosine();
        let spread = r * 0.85 * (i as f32 / count as f32).sqrt();
        let reach = length * (1.0 - 0.45 * i as f32 / count as f32);
        let w = r * 0.14;
        // `k` runs along the axis, `m` sideways.
        let at = |k: f32, m: f32, turn: f32| {
            let (u, v) = (m * c - turn * s, m * s + turn * c);
            if lying { [u, end[1] - r * 0.1 + k, (z / 2.0 + v).max(0.0).min(z)] } else { [u, v, end[2] - r * 0.1 + k] }
        };
        let reach = reach + r * 0.1;
        let points = [
            at(0.0, r * 0.1, -w),
            at(0.0, r * 0.1, w),
            at(reach * 0.5, spread * 0.5 + w * 0.3, -w),
            at(reach * 0.5, spread * 0.5 + w * 0.3, w),
            at(reach * 0.5, spread * 0.5 - w * 0.2, 0.0),
            at(reach, spread, 0.0),
        ];
        b.hull("leaf", &points, mat);
    }
}

/// The scales of a pineapple.
fn knobs(b: &mut Build<'_>, (hx, hy): (f32, f32), high: f32) {
    for row in 0..6 {
        let k = 0.17 + 0.13 * row as f32;
        let r = (1.0 - (2.0 * k - 1.05).raised(2) * 0.42).max(0.0).sqrt() * 0.97;
        for i in 0..9 {
            let angle = TAU * (i as f32 + 0.5 * (row % 2) as f32) / 9.0;
            let at = |turn: f32, up: f32, out: f32| {
                let (s, c) = (angle + turn).sine_cosine();
                [hx * r * out * c, hy * r * out * s, high * (k + up)]
            };
            let points = [
                at(-0.3, 0.0, 0.96),
                at(0.3, 0.0, 0.96),
                at(0.0, 0.065, 0.95),
                at(0.0, -0.065, 0.95),
                at(0.0, 0.0, 1.035_f32.min(1.0 / r)),
            ];
            b.hull("scale", &points, if (row + i) % 2 == 0 { MUSTARD } else { BROWN_SKIN });
        }
    }
}

/// The light stripes of a watermelon: thin shells slightly outside its skin.
fn stripes(b: &mut Build<'_>, (low, high): (P, P), profile: &[(f32, f32)]) {
    let half = [0, 1, 2].map(|i| (high[i] - low[i]) / 2.0);
    for i in 0..7 {
        let angle = TAU * i as f32 / 7.0;
        let side = |turn: f32, k: f32| -> Vec<P> {
            let (s, c) = (angle + turn).sine_cosine();
            let inner: Vec<_> = profile[1..profile.len() - 1].to_vec();
            inner
                .iter()
                .map(|p| {
                    [half[0] * p.0 * c * k, half[1] * (2.0 * p.1 - 1.0) * k.min(1.0), half[2] + half[2] * p.0 * s * k]
                })
                .collect()
        };
        let rings = [side(-0.13, 1.003), side(0.0, 1.004), side(0.13, 1.003), side(0.0, 0.9)];
        strip(b, &rings);
    }
}

/// A strip along a body: four lines of points around the axis.
fn strip(b: &mut Build<'_>, lines: &[Vec<P>; 4]) {
    let n = lines[0].len();
    let rings: Vec<Vec<P>> = (0..n).map(|i| lines.iter().map(|l| l[i]).collect()).collect();
    loft_columns(b, "stripe", &rings, LIGHT_LEAF);
}

/// The cloves of a garlic bulb.
fn cloves(b: &mut Build<'_>, (hx, hy): (f32, f32), high: f32) {
    for i in 0..6 {
        let (s, c) = (TAU * i as f32 / 6.0).sine_cosine();
        let centre = [hx * 0.55 * c, hy * 0.55 * s, high * 0.36];
        lump(b, "clove", centre, [hx * 0.44, hy * 0.44, high * 0.33], 0.02, PETAL_WHITE);
    }
}

/// Lumpy potatoes and ginger.
pub(super) fn root(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let skin = b.choose(&[BROWN_SKIN, CRUST, HAY]);
    if b.class == "potato" {
        return boulder(b, "potato", ([0.0, 0.0, z / 2.0], [x / 2.0, y / 2.0, z / 2.0]), 0.1, (20, 12), skin);
    }
    lump(b, "root", [0.0, 0.0, z / 2.0], [x * 0.3, y / 2.0, z / 2.0], 0.12, skin);
    lump(b, "knob", [x * 0.24, y * 0.2, z * 0.45], [x * 0.25, y * 0.14, z * 0.38], 0.1, skin);
    lump(b, "knob", [-x * 0.24, -y * 0.12, z * 0.42], [x * 0.25, y * 0.16, z * 0.36], 0.1, skin);
}

/// A single banana or several of a bunch, bent and lying on their side.
pub(super) fn banana(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let skin = b.choose(&[YELLOW_SKIN, YELLOW_SKIN, PETAL_YELLOW, GREEN_SKIN]);
    let r = (z / 2.0).min(x * 0.24);
    let count = ((x / (r * 2.6)).floor() as usize).clamp(1, 4);
    let pitch = (x - r * 3.1) / count.max(2) as f32 * if count > 1 { 1.0 } else { 0.0 };
    for i in 0..count {
        let shift = pitch * (i as f32 - (count as f32 - 1.0) / 2.0);
        let bow = if count == 1 { (x - 2.0 * r).max(r * 0.2).min(y * 0.23) } else { r * 1.1 };
        let at = |k: f32, r: f32| {
            let bend = 4.0 * k * (1.0 - k);
            let pull = shift * (0.25 + 0.75 * (k * 1.6).min(1.0));
            ([pull + bow * (bend - 0.5), y * (0.5 - k), z / 2.0], r, r)
        };
        let path = [
            at(0.0, r * 0.22),
            at(0.1, r * 0.25),
            at(0.2, r * 0.8),
            at(0.35, r),
            at(0.6, r),
            at(0.8, r * 0.85),
            at(0.93, r * 0.45),
            at(0.98, r * 0.2),
        ];
        sweep(b, "banana", &path, [0.0, 0.0, 1.0], skin);
        let (tip, before) = (at(1.0, 0.0).0, at(0.96, 0.0).0);
        planar_tube(b, "tip", &[before, tip], r * 0.2, [0.0, 0.0, 1.0], BARK);
    }
}

/// Grapes and other berries: heaped balls, on stalks or in the shape of a bowl.
pub(super) fn cluster(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (mat, taper): (&[MaterialId], bool) = match b.class {
        "grapes" => (&[PURPLE_SKIN, GREEN_SKIN, LIGHT_LEAF], true),
        "blueberries" => (&[PURPLE_SKIN, NAVY], false),
        _ => (&[RED_SKIN], false),
    };
    let mat = b.one_of(mat);
    let cherries = b.class == "cherries";
    let count = if cherries { 9 } else { 15 };
    let (wide, room) = (x.min(y) / 2.0, (x * y / count as f32).sqrt());
    let r = if cherries { room * 0.34 } else { room * 0.52 }.min(z * 0.36).min(wide * 0.45);
    let (hx, hy) = (x / 2.0 - r, y / 2.0 - r);
    let lift = if cherries { 0.0 } else { z - 2.0 * r };
    if !cherries {
        // Filler under the visible berries.
        let narrow = if taper { 0.75 } else { 0.95 };
        lump(b, "berries", [0.0, 0.0, r + lift * 0.35], [hx * narrow, hy, r + lift * 0.35], 0.05, mat);
    }
    for i in 0..count {
        let k = (i as f32 + 0.5) / count as f32;
        let (s, c) = (2.399_963 * i as f32).sine_cosine();
        let out = k.sqrt();
        let narrow = if taper { 1.0 - 0.3 * (s * out + 1.0) / 2.0 } else { 1.0 };
        let rise = lift * (1.0 - k).max(0.0) * b.rng.between(0.8, 1.0);
        let at = [hx * out * c * narrow, hy * out * s, r + rise];
        berry(b, at, r, mat);
        if cherries {
            // Berries hang in pairs, and all pairs on one stem.
            let far = [0.0, 0.0, z - r * 0.1];
            b.rod("stalk", [at[0], at[1], at[2] + r * 0.8], far, r * 0.07, LEAF);
        }
    }
    if taper {
        let w = r * 0.2;
        planar_tube(
            b,
            "stalk",
            &[[0.0, -hy * 0.5, z * 0.55], [0.0, -hy * 0.9, z * 0.7], [0.0, -y / 2.0, z * 0.75]],
            w,
            [1.0, 0.0, 0.0],
            BARK,
        );
    }
}

/// A small ball with few faces.
pub(in crate::object) fn berry(b: &mut Build<'_>, centre: P, r: f32, mat: MaterialId) {
    let profile: Vec<_> = [(0.0, -1.0), (0.62, -0.78), (0.95, -0.3), (0.95, 0.3), (0.62, 0.78), (0.0, 1.0)]
        .iter()
        .map(|p| (p.0 * r, p.1 * r))
        .collect();
    b.lathe("berry", centre, &profile, mat);
}
