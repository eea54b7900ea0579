//! Meat, fish, cheese and other food in slabs and slices.

use vc_graph::portable::Portable;

use crate::material::*;
use crate::solid::{
    Axis, Build, P, boulder, dims, loft_columns, lump, planar_tube, rounded_by_share, spun, sweep, tub,
};

/// An irregular slab: an outline with rounded edges.
fn slab(b: &mut Build<'_>, name: &str, outline: &[(f32, f32)], centre: P, half: P, mat: MaterialId) {
    let ring = |k: f32, z: f32| {
        outline
            .iter()
            .map(|p| [centre[0] + p.0 * half[0] * k, centre[1] + p.1 * half[1] * k, centre[2] + z * half[2]])
            .collect::<Vec<P>>()
    };
    loft_columns(b, name, &[ring(0.9, -1.0), ring(1.0, -0.5), ring(1.0, 0.5), ring(0.88, 1.0)], mat);
}

const CUT: &[(f32, f32)] = &[
    (0.75, -0.95),
    (1.0, -0.5),
    (0.95, 0.0),
    (0.8, 0.45),
    (0.85, 0.8),
    (0.4, 1.0),
    (-0.2, 0.9),
    (-0.7, 0.95),
    (-1.0, 0.5),
    (-0.85, 0.0),
    (-1.0, -0.4),
    (-0.7, -0.85),
    (-0.1, -1.0),
    (0.4, -0.9),
];

/// Steaks, chops and cutlets: a slab with a rim of fat, a bone or crumbs.
pub(super) fn steak(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy, hz) = (x / 2.0, y / 2.0, z / 2.0);
    let outline: Vec<_> =
        CUT.iter().map(|p| (p.0 * b.rng.between(0.94, 1.0), p.1 * b.rng.between(0.95, 1.0))).collect();
    match b.class {
        "cutlets" => {
            let crumb = b.choose(&[CRUST, HAY, ORANGE_SKIN]);
            slab(b, "cutlet", &outline, [0.0, 0.0, hz], [hx, hy, hz], crumb);
            for i in 0..10 {
                let (s, c) = (2.4 * i as f32).sine_cosine();
                let k = 0.8 * (i as f32 / 10.0).sqrt();
                let (cx, cy) = (hx * c * k, hy * s * k);
                let w = hx * 0.07;
                b.hull(
                    "crumb",
                    &[[cx - w, cy, z * 0.9], [cx + w, cy, z * 0.9], [cx, cy + w, z * 0.9], [cx, cy, z]],
                    CRUST,
                );
            }
        }
        class => {
            let cooked = b.rng.chance(0.35);
            let (meat, fat) = if cooked { (COOKED_MEAT, CRUST) } else { (MEAT, PALE_FLESH) };
            slab(b, "fat", &outline, [0.0, 0.0, hz * 0.8], [hx, hy, hz * 0.8], fat);
            let inner: Vec<_> = outline.iter().map(|p| (p.0 * 0.93 - 0.03, p.1 * 0.95)).collect();
            slab(b, "meat", &inner, [0.0, 0.0, z * 0.535], [hx, hy, z * 0.435], meat);
            if class == "pork_chop" {
                planar_tube(
                    b,
                    "bone",
                    &[[hx * 0.6, -hy * 0.9, hz], [hx * 0.1, -hy * 0.45, hz], [hx * 0.2, hy * 0.1, hz]],
                    (hz * 0.6 + 0.0005).min(hy * 0.1),
                    [0.0, 0.0, 1.0],
                    WAX,
                );
                b.block("bone", [0.0, -hy * 0.5, hz], [hx * 0.14, -hy * 0.05, z], WAX);
            }
            for i in 0..if class == "pork_chop" {
                0
            } else if cooked {
                4
            } else {
                2
            } {
                let at = hy * (-0.5 + 0.3 * i as f32);
                b.block(
                    "mark",
                    [-hx * 0.55, at, z * 0.9],
                    [hx * 0.45, at + hy * 0.05, z],
                    if cooked { CHOCOLATE } else { PALE_FLESH },
                );
            }
        }
    }
}

/// Roasts: a thick roll of meat tied with string, on a layer of fat.
pub(super) fn roast(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy, hz) = (x / 2.0, y / 2.0, z / 2.0);
    let (meat, cut) = b.choose(&[(COOKED_MEAT, MEAT), (MEAT, MEAT), (CHOCOLATE, MEAT)]);
    let profile = [
        (0.0, 0.0),
        (0.75, 0.01),
        (0.9, 0.08),
        (0.97, 0.3),
        (1.0, 0.5),
        (0.97, 0.75),
        (0.85, 0.93),
        (0.5, 0.99),
        (0.0, 1.0),
    ];
    let (low, high) = ([-hx * 0.97, -hy * 0.985, z * 0.015], [hx * 0.97, hy, z * 0.985]);
    spun(b, "roast", (low, high), &profile, true, meat);
    b.rod("cut", [0.0, -hy, hz], [0.0, -hy * 0.9, hz], hx.min(hz) * 0.66, cut);
    for k in [0.22, 0.4, 0.58, 0.76] {
        let at = -hy + y * k;
        spun(
            b,
            "string",
            ([-hx, at - y * 0.008, 0.0], [hx, at + y * 0.008, z]),
            &[(0.99, 0.0), (1.0, 0.5), (0.99, 1.0)],
            true,
            WAX,
        );
    }
}

/// Poultry: plucked and raw or roasted, its legs towards +Y; or pieces of it.
pub(super) fn bird(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let mat = b.choose(&[CRUST, COOKED_MEAT, SKIN]);
    if z < 0.07 && b.class == "chicken" {
        return leg_pieces(b, mat);
    }
    let body =
        [(0.0, 0.0), (0.35, 0.01), (0.72, 0.12), (0.95, 0.35), (1.0, 0.55), (0.85, 0.8), (0.5, 0.96), (0.0, 1.0)];
    spun(b, "body", ([-hx * 0.72, -hy, 0.0], [hx * 0.72, hy * 0.65, z]), &body, true, mat);
    lump(b, "breast", [0.0, -hy * 0.1, z * 0.645], [hx * 0.5, hy * 0.5, z * 0.355], 0.02, mat);
    for side in [-1.0, 1.0] {
        let at = |k: f32, lift: f32, r: f32| {
            ([side * hx * (0.95 - r / hx * 0.9) * (1.0 - 0.45 * k), -hy * 0.1 + (hy * 1.02) * k, z * lift], r, r)
        };
        let (thigh, bone) = (hx * 0.3, hx * 0.07);
        sweep(
            b,
            "leg",
            &[
                at(0.0, 0.4, thigh * 0.5),
                at(0.12, 0.42, thigh * 0.9),
                at(0.35, 0.48, thigh),
                at(0.7, 0.6, thigh * 0.5),
                at(0.85, 0.65, bone * 1.5),
                at(0.98, 0.68, bone),
            ],
            [0.0, 0.0, 1.0],
            mat,
        );
        b.ball("knuckle", [at(0.97, 0.0, bone).0[0], (hy - bone * 1.5).min(hy * 0.92), z * 0.68], bone * 1.5, WAX);
        let wing =
            |k: f32, out: f32, r: f32| ([side * (hx - r * 1.25) * out, -hy * 0.75 + hy * 0.8 * k, z * 0.5], r, r * 1.2);
        sweep(
            b,
            "wing",
            &[
                wing(0.0, 0.62, hx * 0.1),
                wing(0.3, 1.0, hx * 0.12),
                wing(0.7, 1.0, hx * 0.1),
                wing(1.0, 0.8, hx * 0.05),
            ],
            [0.0, 0.0, 1.0],
            mat,
        );
    }
}

/// Drumsticks side by side.
fn leg_pieces(b: &mut Build<'_>, mat: MaterialId) {
    let (x, y, z) = dims(b);
    let r = (z / 2.0).min(x * 0.24);
    let count = ((x / (1.9 * r)).ceil() as usize).clamp(2, 6);
    for i in 0..count {
        let side = (x / 2.0 - r) * (2.0 * i as f32 / (count - 1) as f32 - 1.0);
        let at = |k: f32, w: f32| ([side, y * (k - 0.5), r], w, w);
        let flesh = [
            at(0.0, r * 0.4),
            at(0.06, r * 0.8),
            at(0.22, r),
            at(0.45, r * 0.8),
            at(0.68, r * 0.35),
            at(0.72, r * 0.25),
        ];
        sweep(b, "drumstick", &flesh, [0.0, 0.0, 1.0], mat);
        let bone = [at(0.7, r * 0.2), at(0.93, r * 0.2), at(0.97, r * 0.35), at(1.0, r * 0.25)];
        sweep(b, "bone", &bone, [0.0, 0.0, 1.0], WAX);
    }
}

/// Bacon, ham and fish fingers: overlapping slices or sticks in a row.
pub(super) fn slices(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    match b.class {
        "bacon" => {
            let count = 4;
            let w = hx * 0.26;
            for i in 0..count {
                let centre = (hx - w) * (2.0 * i as f32 / (count - 1) as f32 - 1.0);
                let t = z * 0.08;
                for (shift, wide, mat) in [(0.0, 1.0, MEAT), (-0.35, 0.16, CREAM_FOOD), (0.3, 0.2, CREAM_FOOD)] {
                    let wave = |k: usize| {
                        let up = (1.3 * k as f32 + 0.9 * i as f32).sine() * 0.5 + 0.5;
                        let extra = if shift == 0.0 { 0.0 } else { t * 0.5 };
                        (
                            [
                                centre + w * shift,
                                hy * (k as f32 / 3.5 - 1.0) * if shift == 0.0 { 1.0 } else { 0.985 },
                                t * 1.5 + (z - 3.0 * t) * up,
                            ],
                            w * wide,
                            t + extra,
                        )
                    };
                    let path: Vec<_> = (0..8).map(wave).collect();
                    sweep(b, "rasher", &path, [1.0, 0.0, 0.0], mat);
                }
            }
        }
        "ham" => {
            let count = 5;
            let t = z / (count as f32 + 1.0);
            for i in 0..count {
                let shift = hy * 0.3 * (i as f32 / (count - 1) as f32 - 0.5) * 2.0;
                let low = t * i as f32;
                let rim: Vec<_> = CUT.iter().map(|p| (p.0 * hx, p.1 * hy * 0.68)).collect();
                b.prism("rind", Axis::Z, [0.0, shift, low], &rim, t * 0.9, PALE_FLESH);
                let meat: Vec<_> = rim.iter().map(|p| (p.0 * 0.93, p.1 * 0.94)).collect();
                b.prism("ham", Axis::Z, [0.0, shift, low + t * 0.25], &meat, t * 0.9, PETAL_PINK);
            }
        }
        _ => {
            let (w, t) = (y / 6.0, z * 0.48);
            for i in 0..10 {
                let (row, k) = (i / 5, i % 5);
                let at = -hy + w * (k as f32 + 0.5) + w * 0.5 * row as f32 + w * 0.25;
                let low = t * 1.04 * row as f32;
                b.rounded_block(
                    "finger",
                    [-hx * 0.98, at - w * 0.44, low],
                    [hx * (0.98 - 0.04 * (k % 2) as f32), at + w * 0.44, low + t],
                    t * 0.25,
                    CRUST,
                );
            }
        }
    }
}

/// Sausages: bent and plump ones, or a salami with its skin and cut end.
pub(super) fn sausage(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let salami = b.class == "salami";
    let mat = if salami {
        b.choose(&[RED_SKIN, PALE_FLESH, COOKED_MEAT])
    } else {
        b.choose(&[COOKED_MEAT, CRUST, MEAT, SKIN])
    };
    let full = (z / 2.0).min(x * 0.5);
    // Strings wrap around a salami.
    let r = if salami { full * 0.97 } else { full };
    let bow = (x / 2.0 - full).max(0.0);
    let at = |k: f32, r: f32| ([bow * (1.0 - 2.0 * (2.0 * k - 1.0).raised(2)), y * (k - 0.5), z / 2.0], r, r);
    let end = if salami { 0.97 } else { 0.25 };
    let path = [
        at(if salami { 0.006 } else { 0.0 }, r * end),
        at(0.03, r * end.max(0.7)),
        at(0.1, r),
        at(0.35, r),
        at(0.65, r),
        at(0.9, r),
        at(0.97, r * 0.7),
        at(1.0, r * 0.25),
    ];
    sweep(b, "sausage", &path, [0.0, 0.0, 1.0], mat);
    if salami {
        let (face, inner) = (at(0.0, 0.0).0, at(0.01, 0.0).0);
        b.rod("cut", [inner[0], face[1], z / 2.0], [inner[0], inner[1], z / 2.0], r * 0.85, RED_SKIN);
        for k in [0.3, 0.6, 0.88] {
            let ring = at(k, 0.0).0;
            b.rod(
                "string",
                [ring[0], ring[1] - y * 0.006, z / 2.0],
                [ring[0], ring[1] + y * 0.006, z / 2.0],
                full,
                WAX,
            );
        }
    } else {
        for i in 0..4 {
            let p = at(0.25 + 0.16 * i as f32, 0.0).0;
            b.block("mark", [p[0] - r * 0.5, p[1], z * 0.88], [p[0] + r * 0.5, p[1] + y * 0.015, z * 0.985], CHOCOLATE);
        }
    }
}

/// Minced meat: strands in a tray.
pub(super) fn mince(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let tray = b.choose(&[BLACK_PLASTIC, WHITE_PLASTIC]);
    tub(b, "tray", &[(0.0, hx * 0.85, hy * 0.88), (z * 0.75, hx, hy)], 0.25, z * 0.05, tray);
    b.rounded_block("mince", [-hx * 0.84, -hy * 0.87, z * 0.03], [hx * 0.84, hy * 0.87, z * 0.75], z * 0.2, MEAT);
    for i in 0..9 {
        let at = hx * 0.75 * (i as f32 / 4.0 - 1.0);
        let r = hx * 0.09;
        let wave = |k: usize| {
            [
                at + r * 0.5 * (1.7 * k as f32 + i as f32).sine(),
                hy * (0.8 - 0.02 * (i % 3) as f32) * (k as f32 / 3.0 - 1.0),
                (z * 0.8 + z * 0.06 * (2.1 * k as f32 + i as f32).cosine()).min(z - r),
            ]
        };
        let points: Vec<P> = (0..7).map(wave).collect();
        planar_tube(b, "strand", &points, r, [0.0, 0.0, 1.0], if i % 3 == 0 { PETAL_PINK } else { MEAT });
    }
}

/// A ball of meat.
pub(super) fn meatball(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let mat = b.choose(&[COOKED_MEAT, COOKED_MEAT, CHOCOLATE]);
    boulder(b, "meatball", ([0.0, 0.0, z / 2.0], [x / 2.0, y / 2.0, z / 2.0]), 0.05, (20, 12), mat);
}

/// A whole fish lying on its side, or a fillet with lines of fat.
pub(super) fn fish(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy, hz) = (x / 2.0, y / 2.0, z / 2.0);
    if b.class == "salmon" || b.rng.chance(0.25) {
        let flesh = if b.class == "salmon" { ORANGE_SKIN } else { PALE_FLESH };
        let outline = [
            (0.5, -1.0),
            (0.9, -0.7),
            (1.0, -0.2),
            (0.95, 0.4),
            (0.7, 0.9),
            (0.2, 1.0),
            (-0.5, 0.95),
            (-0.85, 0.6),
            (-1.0, 0.0),
            (-0.95, -0.5),
            (-0.6, -0.95),
            (0.0, -1.0),
        ];
        slab(b, "skin", &outline, [0.0, 0.0, hz * 0.3], [hx, hy, hz * 0.3], FISH_SKIN);
        slab(b, "flesh", &outline, [0.0, 0.0, hz * 1.15], [hx * 0.97, hy * 0.98, hz * 0.83], flesh);
        for i in 0..6 {
            let at = hy * (-0.7 + 0.26 * i as f32);
            let points =
                [[-hx * 0.7, at + hy * 0.15, z * 0.99], [0.0, at, z * 0.99], [hx * 0.7, at + hy * 0.15, z * 0.99]];
            planar_tube(b, "line", &points, z * 0.01, [0.0, 0.0, 1.0], CREAM_FOOD);
        }
        return;
    }
    let skin = b.choose(&[FISH_SKIN, FISH_SKIN, SILVER_METAL, GREY]);
    let body =
        [(0.0, 0.0), (0.3, 0.02), (0.62, 0.12), (0.8, 0.28), (0.82, 0.45), (0.62, 0.7), (0.25, 0.92), (0.15, 1.0)];
    let tail = hy * 0.62;
    spun(b, "body", ([-hx, -hy, 0.0], [hx, tail, z]), &body, true, skin);
    b.hull(
        "tail",
        &[
            [hx * 0.1, tail - hy * 0.08, hz * 0.8],
            [-hx * 0.1, tail - hy * 0.08, hz * 0.8],
            [hx * 0.95, hy, hz],
            [-hx * 0.95, hy, hz],
            [0.0, hy * 0.85, hz * 1.2],
            [0.0, tail, hz * 1.3],
        ],
        skin,
    );
    b.hull(
        "fin",
        &[
            [hx * 0.7, -hy * 0.2, hz * 0.9],
            [hx, 0.0, hz],
            [hx * 0.95, hy * 0.15, hz],
            [hx * 0.5, hy * 0.2, hz * 0.9],
            [hx * 0.7, 0.0, hz * 1.15],
        ],
        skin,
    );
    b.hull(
        "fin",
        &[
            [-hx * 0.6, hy * 0.05, hz * 0.9],
            [-hx * 0.9, hy * 0.3, hz],
            [-hx * 0.45, hy * 0.25, hz * 0.9],
            [-hx * 0.5, hy * 0.2, hz * 1.15],
        ],
        skin,
    );
    b.cylinder("eye", [hx * 0.15, -hy * 0.78, hz], hx * 0.1, z * 0.28, BLACK_PLASTIC);
}

/// Shrimps in a heap: bent bodies with tails.
pub(super) fn shrimp(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let mat = b.choose(&[PETAL_PINK, ORANGE_SKIN, TERRACOTTA]);
    let r = (z * 0.3).min(x * 0.13);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let under = b.choose(&[LEAF, LIGHT_LEAF]);
    slab(b, "leaf", CUT, [0.0, 0.0, z * 0.06], [hx * 0.95, hy * 0.95, z * 0.06], under);
    for i in 0..7 {
        let (s, c) = (2.4 * i as f32).sine_cosine();
        let k = (i as f32 / 7.0).sqrt();
        let reach = hx.min(hy) * 0.52;
        let centre = [(hx - reach) * c * k, (hy - reach) * s * k, r + (z - 2.0 * r) * (1.0 - k)];
        let turn = 1.7 * i as f32;
        let at = |j: usize, w: f32| {
            let (s, c) = (turn + 0.75 * j as f32).sine_cosine();
            ([centre[0] + (reach - r) * c, centre[1] + (reach - r) * s, centre[2]], w, w)
        };
        let path = [at(0, r * 0.4), at(1, r), at(2, r * 0.95), at(3, r * 0.8), at(4, r * 0.55), at(5, r * 0.3)];
        sweep(b, "shrimp", &path, [0.0, 0.0, 1.0], mat);
        let end = |j: usize| at(j, 0.0).0;
        planar_tube(b, "tail", &[end(5), end(6)], r * 0.3, [0.0, 0.0, 1.0], RED_SKIN);
    }
}

/// A block of tofu in its dish.
pub(super) fn tofu(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    b.rounded_block("tofu", [-x * 0.49, -y / 2.0, 0.0], [x * 0.49, y / 2.0, z * 0.98], z * 0.08, CREAM_FOOD);
    let cut = b.vary(0.1, 0.3);
    b.block("cut", [-x * 0.5, y * cut, z * 0.2], [x * 0.5, y * cut + y * 0.008, z], PALE_FLESH);
}

/// Cheese: a wedge with holes, a round with a wedge cut out, or a block with a rind.
pub(super) fn cheese(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let paste = b.choose(&[CHEESE, CHEESE, YELLOW_SKIN, CREAM_FOOD, ORANGE_SKIN]);
    let rind = b.choose(&[MUSTARD, RED_SKIN, CREAM_FOOD, BROWN_SKIN, BLACK]);
    match b.rng.below(3) {
        0 => {
            b.prism(
                "paste",
                Axis::Z,
                [0.0, 0.0, z * 0.02],
                &[(-hx, -hy * 0.9), (hx, -hy * 0.9), (0.0, hy)],
                z * 0.95,
                paste,
            );
            b.block("rind", [-hx, -hy, 0.0], [hx, -hy * 0.88, z], rind);
            for (k, u, r) in [(0.1, 0.3, 0.16), (-0.5, 0.6, 0.2), (0.45, 0.55, 0.12), (-0.2, 0.25, 0.1)] {
                // Holes are visible on the cut that faces +X.
                let (px, py) = (hx * (0.5 - 0.5 * k), hy * (0.05 + 0.95 * k));
                let n = [hy * 1.9, hx];
                let length = (n[0] * n[0] + n[1] * n[1]).sqrt().max(1e-6);
                let (nx, ny) = (n[0] / length * z * 0.02, n[1] / length * z * 0.02);
                b.rod(
                    "hole",
                    [px - nx * 3.0, py - ny * 3.0, z * u],
                    [px + nx * 0.5, py + ny * 0.5, z * u],
                    z * r,
                    MUSTARD,
                );
            }
        }
        1 => {
            let sector: Vec<_> = (0..=18)
                .map(|i| {
                    let (s, c) = (0.6 + 5.1 * i as f32 / 18.0).sine_cosine();
                    (hx * c, hy * s)
                })
                .chain([(0.0, 0.0)])
                .collect();
            b.prism("rind", Axis::Z, [0.0; 3], &sector, z * 0.97, rind);
            let inner: Vec<_> = sector.iter().map(|p| (p.0 * 0.93, p.1 * 0.93)).collect();
            b.prism("paste", Axis::Z, [hx * 0.015, 0.0, z * 0.04], &inner, z * 0.96, paste);
        }
        _ => {
            b.rounded_block("paste", [-hx, -hy, 0.0], [hx, hy * 0.62, z], z * 0.06, paste);
            let count = 3;
            for i in 0..count {
                let at = hy * (0.68 + 0.125 * i as f32);
                let slice: Vec<_> = rounded_by_share((hx * 0.99, hy * 0.062), 0.1);
                b.prism("slice", Axis::Z, [0.0, at, 0.0], &slice, z * (0.97 - 0.02 * i as f32), paste);
            }
        }
    }
}
