//! Garden tools, by hand and by motor, and what comes in bags.

use std::f32::consts::{FRAC_PI_2, TAU};

use crate::material::*;
use crate::object::build::{Axis, Build, P};
use crate::object::park::shape::{blob, grown, limb, polar, polygon, spaced, star, tub};
use crate::object::vehicle::wheel::{Rim, wheel};
use vc_graph::portable::Portable;

/// A long-handled tool, upright, its head below: shovel, spade, fork, hoe, rake, axe,
/// trowel.
pub(super) fn hand_tool(b: &mut Build<'_>) {
    grown(b, [0.014, 0.03, 0.13]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let steel = b.one(&[STEEL, IRON, GALVANISED, RUST, GREEN_METAL]);
    let wood = b.one(&[ASH, BEECH, PINE, YELLOW, BLACK_PLASTIC]);
    let r = (h * 0.013).clamp(0.008, 0.017).min(x * 0.8);
    match b.class {
        "axe" => axe(b, (x, y, h), (steel, wood)),
        "rake" => rake(b, (x, y, h, r), (steel, wood)),
        "hoe" => {
            let low = (h * 0.1).min(0.12);
            shaft(b, -x + r, low * 0.9, h, r, wood);
            let neck = [-x + r, 0.0, low];
            b.rod("neck", neck, [x * 0.4, 0.0, low * 0.8], r * 0.6, steel);
            let blade = [
                [x * 0.4, -y, low * 0.85],
                [x * 0.4, y, low * 0.85],
                [x, -y * 0.9, 0.0],
                [x, y * 0.9, 0.0],
                [x * 0.4 + 0.004, -y * 0.7, low],
                [x * 0.4 + 0.004, y * 0.7, low],
                [x - 0.004, 0.0, 0.0],
            ];
            b.hull("blade", &blade, steel);
        }
        "garden_fork" => {
            let head = (h * b.vary(0.22, 0.3)).min(0.32);
            handled(b, (x, y, h), head, r, wood);
            let tines = b.rng.count(3, 5);
            b.block("yoke", [-x * 0.25, -y * 0.92, head - 0.02], [x * 0.15, y * 0.92, head], steel);
            for cy in spaced(tines, -y * 0.92, y * 0.92) {
                let t = (y * 0.08).min(0.006);
                let tine = limb([0.0, cy, head - 0.01], [x * 0.75, cy, head * 0.35], t, t * 0.9);
                b.hull("tine", &tine, steel);
                let tip = limb([x * 0.75, cy, head * 0.36], [x * 0.2, cy, 0.0], t * 0.9, t * 0.3);
                b.hull("tine", &tip.into_iter().map(|p| [p[0], p[1], p[2].max(0.0)]).collect::<Vec<P>>(), steel);
            }
        }
        class => {
            let head = match class {
                "trowel" => h * b.vary(0.45, 0.52),
                _ => (h * b.vary(0.24, 0.3)).min(0.34),
            };
            handled(b, (x, y, h), head, if class == "trowel" { (x * 0.7).min(0.014) } else { r }, wood);
            blade(b, (x, y), head, class == "spade", steel);
        }
    }
}

/// A shaft with a grip across its end, or a plain one.
fn handled(b: &mut Build<'_>, (x, y, h): (f32, f32, f32), head: f32, r: f32, wood: Mat) {
    let grip = b.class != "trowel" && b.rng.chance(0.6);
    let top = if grip { h - 0.12_f32.min(h * 0.12) } else { h };
    shaft(b, 0.0, head * 0.9, top, r, wood);
    if grip {
        let wide = (y * 0.75).min(0.055);
        for side in [-1.0, 1.0] {
            b.rod("yoke", [0.0, 0.0, top - 0.01], [0.0, side * wide, h - r], r * 0.6, wood);
        }
        b.rod("grip", [0.0, -wide - 0.008, h - r], [0.0, wide + 0.008, h - r], r.min(x), wood);
    }
}

fn shaft(b: &mut Build<'_>, x: f32, low: f32, top: f32, r: f32, wood: Mat) {
    b.lathe(
        "shaft",
        [x, 0.0, low],
        &[(r * 0.85, 0.0), (r, (top - low) * 0.5), (r * 0.9, top - low - r), (r * 0.6, top - low)],
        wood,
    );
}

/// A dished blade in three strips: pointed, or square for a spade.
fn blade(b: &mut Build<'_>, (x, y): (f32, f32), head: f32, square: bool, steel: Mat) {
    let t = (x * 0.12).min(0.004);
    let point = if square { b.vary(0.0, 0.06) } else { b.vary(0.2, 0.4) };
    let at = |u: f32, v: f32| {
        // Across from -1 to 1, up from 0 to 1.
        let half = y * (1.0 - 0.24 * v);
        let z = head * (v + point * u * u * (1.0 - v).max(0.0));
        [x * 0.9 - x * 1.5 * (1.0 - u * u) * 0.6 - x * 0.5 * v, half * u, z]
    };
    for pair in [-1.0_f32, -0.35, 0.35, 1.0].windows(2) {
        let corners = [at(pair[0], 0.0), at(pair[1], 0.0), at(pair[0], 1.0), at(pair[1], 1.0)];
        let points: Vec<P> = corners.iter().flat_map(|p| [*p, [p[0] + t, p[1], p[2]]]).collect();
        b.hull("blade", &points, steel);
    }
    let neck = at(0.0, 0.95);
    b.hull(
        "socket",
        &limb([neck[0], 0.0, head * 0.75], [0.0, 0.0, head * 1.25], x * 0.25, (x * 0.45).min(0.016)),
        steel,
    );
    if square {
        b.block("tread", [neck[0] - 0.01, -y * 0.9, head - 0.004], [neck[0] + 0.014, y * 0.9, head + 0.003], steel);
    }
}

fn axe(b: &mut Build<'_>, (x, y, h): (f32, f32, f32), (steel, wood): (Mat, Mat)) {
    let head = h * b.vary(0.14, 0.2);
    let (grip, middle) = (x * 0.65, h - head / 2.0);
    let back = -y + y * b.vary(0.2, 0.35);
    let deep = (y * 0.17).max(0.008);
    let handle = [
        (back - deep, 0.0),
        (back + deep * 1.6, 0.0),
        (back + deep, h * 0.3),
        (back + deep * 0.8, h),
        (back - deep * 0.8, h),
        (back - deep, h * 0.3),
    ];
    b.prism("handle", Axis::X, [-grip, 0.0, 0.0], &handle, 2.0 * grip, wood);
    let top = middle + head * 0.35;
    let cheek = back + deep * 1.2;
    let bit: Vec<P> = [(-x, 1.0), (x, 1.0)]
        .into_iter()
        .flat_map(|(px, _)| {
            [
                [px, back - deep * 1.3, middle - head * 0.22],
                [px, back - deep * 1.3, top],
                [px, cheek, middle - head * 0.22],
                [px, cheek, top],
            ]
        })
        .chain([[0.0, y, middle - head * 0.5], [0.0, y, top]])
        .collect();
    b.hull("head", &bit, steel);
}

fn rake(b: &mut Build<'_>, (x, y, h, r): (f32, f32, f32, f32), (steel, wood): (Mat, Mat)) {
    if b.rng.chance(0.5) {
        // A leaf rake: tines fan out and bend at their tips.
        let tines = b.rng.count(11, 19);
        let (root, bend) = (h * 0.28, 0.03_f32.min(x));
        shaft(b, -x + r, root * 0.9, h, r, wood);
        let mat = b.one(&[steel, BAMBOO, GREEN_PLASTIC, ORANGE_PLASTIC]);
        for cy in spaced(tines, -y + 0.004, y - 0.004) {
            let low = bend * 0.6 + (1.0 - (cy / y).raised(2)) * 0.001;
            b.hull("tine", &limb([-x + r, cy * 0.05, root], [x * 0.2, cy, low], 0.003, 0.003), mat);
            b.hull("tip", &limb([x * 0.2, cy, low], [x - 0.003, cy, 0.003], 0.003, 0.002), mat);
        }
        let cx = -x + r + (1.2 * x - r) * 0.5 * (root - 0.02) / (root - bend * 0.6);
        b.block("bridge", [cx - 0.005, -y * 0.5, root * 0.5], [cx + 0.005, y * 0.5, root * 0.5 + 0.02], mat);
    } else {
        let tines = b.rng.count(10, 16);
        let low = (x * 0.9).min(h * 0.08);
        shaft(b, -x + r, low, h, r, wood);
        b.block("bar", [-x * 0.7, -y, low - 0.01], [-x * 0.7 + 0.014, y, low + 0.01], steel);
        for cy in spaced(tines, -y + 0.006, y - 0.006) {
            b.hull("tine", &limb([-x * 0.7 + 0.007, cy, low], [x * 0.8, cy, 0.002], 0.005, 0.002), steel);
        }
        b.rod("neck", [-x + r, 0.0, low + 0.04], [-x * 0.65, 0.0, low], r * 0.7, steel);
    }
}

/// Secateurs, upright: blades above, sprung grips below.
pub(super) fn pruning_shears(b: &mut Build<'_>) {
    grown(b, [0.008, 0.02, 0.08]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let grip = b.one(&[RED_PLASTIC, ORANGE_PLASTIC, GREEN_PLASTIC, BLACK_PLASTIC]);
    let pivot = h * b.vary(0.6, 0.66);
    let open = b.vary(0.75, 1.0);
    for side in [-1.0, 1.0] {
        let shape = [
            (0.0, pivot + 0.012),
            (side * y * 0.3, pivot),
            (side * y * open, h * 0.3),
            (side * y * open * 0.9, 0.0),
            (side * y * open * 0.6, 0.0),
            (side * y * open * 0.65, h * 0.3),
            (-side * y * 0.2, pivot - 0.012),
        ];
        let (from, depth) = (if side > 0.0 { -x * 0.75 } else { -x * 0.65 }, x * 1.4);
        b.prism("grip", Axis::X, [from, 0.0, 0.0], &shape, depth, grip);
        let edge = [
            (-side * y * 0.25, pivot - 0.01),
            (side * y * 0.3, pivot),
            (side * y * 0.55, h * 0.82),
            (side * y * 0.1, h),
            (-side * y * 0.1, h * 0.8),
        ];
        b.prism("blade", Axis::X, [if side > 0.0 { 0.0005 } else { -0.0035 }, 0.0, 0.0], &edge, 0.003, STEEL);
    }
    b.rod("pivot", [-x, 0.0, pivot], [x, 0.0, pivot], y * 0.15, STEEL);
}

/// A pair of gloves, one on the other, flat and upright like a thing that hangs.
pub(super) fn gloves(b: &mut Build<'_>) {
    grown(b, [0.01, 0.05, 0.1]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (palm, cuff) = (
        b.one(&[GREEN_FABRIC, TAN_LEATHER, RED_FABRIC, BLUE_FABRIC, MUSTARD_FABRIC]),
        b.one(&[BEIGE_FABRIC, WHITE_COTTON, GREY_FABRIC, BLACK_FABRIC]),
    );
    let spread = b.vary(0.16, 0.22);
    for (from, side, share) in [(-x, 1.0, 1.0), (0.0008, -1.0, 0.96)] {
        let t = x * 0.98;
        let wide = y * 0.72;
        b.prism(
            "palm",
            Axis::X,
            [from, -side * y * 0.14, 0.0],
            &[(-wide * 0.75, h * 0.24), (wide * 0.75, h * 0.24), (wide * 0.95, h * 0.6), (-wide * 0.95, h * 0.6)],
            t,
            palm,
        );
        b.prism(
            "cuff",
            Axis::X,
            [from - 0.0002 * side, -side * y * 0.14, 0.0],
            &[(-wide * 0.9, 0.0), (wide * 0.9, 0.0), (wide * 0.77, h * 0.26), (-wide * 0.77, h * 0.26)],
            t,
            cuff,
        );
        for (i, top) in [0.93, 1.0, 0.97, 0.88].into_iter().enumerate() {
            let cy = -side * y * 0.14 + wide * (i as f32 - 1.5) * 0.48;
            b.soft(
                "finger",
                [from + 0.0003, cy - y * spread, h * 0.55],
                [from + t - 0.0003, cy + y * spread * 0.9, h * top * share],
                t * 0.4,
                palm,
            );
        }
        let thumb = side * y * 0.97;
        b.hull(
            "thumb",
            &[
                [from, side * wide * 0.5, h * 0.3],
                [from + t, side * wide * 0.5, h * 0.3],
                [from, side * wide * 0.5, h * 0.48],
                [from + t, side * wide * 0.5, h * 0.48],
                [from, thumb, h * 0.6],
                [from + t, thumb, h * 0.6],
                [from, thumb * 0.8, h * 0.68],
                [from + t, thumb * 0.8, h * 0.68],
            ],
            palm,
        );
    }
}

/// A full bag with a label: soil, charcoal, fertiliser.
pub(super) fn bag(b: &mut Build<'_>) {
    grown(b, [0.03, 0.05, 0.11]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (mats, labels): (&[Mat], &[Mat]) = match b.class {
        "charcoal_bag" => (&[BROWN_SKIN, CARDBOARD, BLACK_PLASTIC, RED_CARD], &[RED, YELLOW, BLACK, ORANGE]),
        "potting_soil" => {
            (&[GREEN_PLASTIC, BROWN_PLASTIC, BLACK_PLASTIC, PURPLE_PLASTIC], &[YELLOW, LIGHT_LEAF, WHITE, ORANGE])
        }
        _ => (&[WHITE_PLASTIC, GREEN_PLASTIC, YELLOW_PLASTIC, BLUE_PLASTIC], &[GREEN, RED, BLUE, ORANGE]),
    };
    let (mat, label, second) = (b.one(mats), b.one(labels), b.one(labels));
    if b.class == "fertilizer" && b.rng.chance(0.4) {
        return bottle(b, (x.min(y), h), mat, label);
    }
    let neck = h * b.vary(0.86, 0.93);
    let (belly, slump) = (h * b.vary(0.25, 0.45), b.vary(0.82, 0.95));
    let ring = |sx: f32, sy: f32, z: f32| {
        [
            [sx, sy * 0.9, z],
            [sx * 0.6, sy, z],
            [-sx * 0.6, sy, z],
            [-sx, sy * 0.9, z],
            [-sx, -sy * 0.9, z],
            [-sx * 0.6, -sy, z],
            [sx * 0.6, -sy, z],
            [sx, -sy * 0.9, z],
        ]
    };
    let body = [
        ring(x * 0.85, y * 0.9, 0.0),
        ring(x, y, belly * 0.5),
        ring(x * 0.97, y * 0.98, belly),
        ring(x * 0.7, y * slump, neck * 0.85),
        ring(x * 0.2, y * slump, neck),
    ]
    .concat();
    b.hull("bag", &body, mat);
    b.block("seam", [-x * 0.08, -y * slump, neck - 0.005], [x * 0.08, y * slump, h], mat);
    // Labels lie on the front, which leans back above the belly.
    let front = |z: f32| if z < belly { x } else { x - (x * 0.3) * (z - belly) / (neck * 0.85 - belly) };
    for (low, high, wide, mat, out) in
        [(0.3, 0.62, 0.62, label, 0.003), (0.42, 0.52, 0.5, second, 0.005), (0.68, 0.74, 0.45, label, 0.003)]
    {
        let (z0, z1) = (h * low, h * high);
        let points: Vec<P> = [-1.0, 1.0]
            .into_iter()
            .flat_map(|s| [z0, z1].map(|z| (s, z)))
            .flat_map(|(s, z)| [[(front(z) + out).min(x + 0.0009), s * y * wide, z], [front(z) * 0.8, s * y * wide, z]])
            .collect();
        b.hull("label", &points, mat);
    }
}

/// A bottle with a screw cap and a label.
fn bottle(b: &mut Build<'_>, (r, h): (f32, f32), mat: Mat, label: Mat) {
    let body = r - 0.0008;
    b.lathe(
        "bottle",
        [0.0; 3],
        &[(r * 0.9, 0.0), (body, h * 0.03), (body, h * 0.65), (r * 0.4, h * 0.82), (r * 0.4, h * 0.88)],
        mat,
    );
    b.cylinder("label", [0.0, 0.0, h * 0.15], r, h * 0.4, label);
    b.jointed(vc_graph::asset::JointKind::Hinge, [0.0; 3], [0.0, 0.0, 1.0], (0.0, TAU), |b| {
        b.cylinder("cap", [0.0, 0.0, h * 0.86], r * 0.46, h * 0.14, label)
    });
}

/// A packet of seeds with a flower on its front.
pub(super) fn seed_packet(b: &mut Build<'_>) {
    grown(b, [0.001, 0.03, 0.05]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let paper = b.one(&[WHITE_PAPER, CREAM_PAPER, GREEN_CARD, YELLOW_CARD]);
    let petal = b.one(&[PETAL_RED, PETAL_YELLOW, PETAL_PINK, PETAL_BLUE, RED_SKIN, ORANGE_SKIN]);
    let flap = h * b.vary(0.08, 0.15);
    b.block("packet", [-x * 0.7, -y, 0.0], [0.0, y, h - flap * 0.3], paper);
    let lid = [(-y, h - flap), (-y * 0.8, h), (y * 0.8, h), (y, h - flap)];
    b.prism("flap", Axis::X, [-x, 0.0, 0.0], &lid, x * 0.8, paper);
    b.block("title", [-x * 0.1, -y * 0.8, h * 0.72], [x * 0.4, y * 0.8, h * 0.82], b.style.accent);
    let points = b.rng.count(5, 8);
    let (size, z) = (y * b.vary(0.55, 0.75), h * b.vary(0.36, 0.46));
    b.prism("flower", Axis::X, [-x * 0.1, 0.0, z], &star(points, size, size * 0.4), x * 0.75, petal);
    b.prism("flower", Axis::X, [0.0, 0.0, z], &polygon(10, size * 0.3, 0.0), x, PETAL_YELLOW);
    b.block("stem", [-x * 0.1, -y * 0.04, h * 0.05], [x * 0.3, y * 0.04, z], LEAF);
}

/// A ladder, upright: two stiles, rungs between, perhaps a second part before it.
pub(super) fn ladder(b: &mut Build<'_>) {
    grown(b, [0.035, 0.17, 0.5]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let mat = b.one(&[ALUMINIUM, ALUMINIUM, PINE, OAK, ORANGE]);
    let double = x > 0.055 && b.rng.chance(0.6);
    let deep = if double { x * 0.5 } else { x };
    for (i, cx) in if double { vec![-x + deep, x - deep] } else { vec![0.0] }.into_iter().enumerate() {
        let (inset, top) = (0.024 * i as f32, h - if i == 1 { b.vary(0.0, 0.15) * h } else { 0.0 });
        let w = 0.012;
        for side in [-1.0, 1.0] {
            let cy = side * (y - w - inset);
            b.block(
                "stile",
                [cx - deep + 0.001, cy - w, if i == 1 { 0.04 } else { 0.0 }],
                [cx + deep - 0.001, cy + w, top],
                mat,
            );
        }
        let rungs = ((top / b.vary(0.25, 0.3)) as usize).clamp(3, 10);
        for z in spaced(rungs, top * 0.08 + 0.04, top - 0.08) {
            b.rod("rung", [cx, -y + w + inset, z], [cx, y - w - inset, z], (deep * 0.55).min(0.016), mat);
        }
    }
    for side in [-1.0, 1.0] {
        let cy = side * (y - 0.013);
        b.block("foot", [-x, cy - 0.013, 0.0], [x, cy + 0.013, 0.03], RUBBER);
    }
}

/// A step ladder: treads in front, a support behind, both parted as far as it is
/// deep.
pub(super) fn step_ladder(b: &mut Build<'_>) {
    grown(b, [0.06, 0.2, 0.4]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let mat = b.one(&[ALUMINIUM, ALUMINIUM, PINE, WHITE_METAL, ORANGE]);
    let top = (x * 0.5).min(0.12).max(x * 0.12);
    let rail = h * if x > 0.25 { b.vary(0.7, 0.85) } else { 0.93 };
    let apex = -x * 0.15;
    let w = 0.012;
    let leg = |b: &mut Build<'_>, foot: f32, cy: f32| {
        let d = 0.022_f32.min(x * 0.4);
        let way = if foot > 0.0 { -1.0 } else { 1.0 };
        let outline = [(foot, 0.0), (foot + way * d * 1.4, 0.0), (apex + way * d * 0.4, rail), (apex - way * d, rail)];
        b.prism("leg", Axis::Y, [0.0, cy - w, 0.0], &outline, 2.0 * w, mat);
    };
    for side in [-1.0, 1.0] {
        leg(b, x, side * (y - w));
        leg(b, -x, side * (y - w - 0.026));
    }
    let steps = ((rail / 0.25) as usize).clamp(2, 7);
    for z in spaced(steps + 1, 0.0, rail).skip(1).take(steps - 1) {
        let cx = x - 0.022 + (apex - x) * z / rail;
        let deep = 0.04_f32.min(x * 0.35);
        b.block("tread", [cx - deep, -y + w, z - 0.025], [(cx + deep).min(x), y - w, z], mat);
        if z < rail * 0.7 {
            let bx = -x + (apex + x) * z / rail + 0.01;
            b.rod("brace", [bx, -y + 0.04, z], [bx, y - 0.04, z], 0.008, mat);
        }
    }
    b.soft(
        "platform",
        [(apex - top).max(-x), -y, rail - 0.01],
        [(apex + top).min(x), y, rail + 0.022_f32.min(h - rail)],
        0.006,
        RED_PLASTIC,
    );
    let room = ((apex + top).min(x) - (apex - top).max(-x)) / 2.0;
    let level = rail + 0.022_f32.min(h - rail);
    let centre = f32::midpoint((apex + top).min(x), (apex - top).max(-x));
    if h - rail > 0.1 {
        let back = (apex - top).max(-x) + 0.016;
        for side in [-1.0, 1.0] {
            b.rod("rail", [back, side * (y - 0.03), rail], [back, side * (y - 0.03), h - 0.012], 0.01, mat);
        }
        b.rod("rail", [back, -y + 0.02, h - 0.012], [back, y - 0.02, h - 0.012], 0.012, mat);
        b.top("platform", [centre + 0.014, 0.0, level], (room - 0.02, y - 0.05));
    } else {
        b.top("platform", [centre, 0.0, level], (room - 0.005, y - 0.01));
    }
}

/// A wheelbarrow: a tray on a wheel and two legs.
pub(super) fn wheelbarrow(b: &mut Build<'_>) {
    grown(b, [0.55, 0.27, 0.27]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let mat = b.one(&[GREEN_METAL, GALVANISED, RED_METAL, BLUE_METAL, BLACK_PLASTIC, YELLOW_METAL]);
    let frame = b.one(&[IRON, GALVANISED, PINE, RED_METAL]);
    let r = h * b.vary(0.23, 0.27);
    let axle = x - r;
    let rim = Rim::plain(b);
    wheel(b, "wheel", [axle, 0.0, r], r, r * 0.45, 1.0, rim);
    let (low, deep) = (2.0 * r + h * b.vary(0.03, 0.05), x * b.vary(0.5, 0.56));
    let middle = x - deep - r * 0.35;
    let shrink = b.vary(0.5, 0.65);
    tub(b, "tray", [middle, 0.0, low], (deep * shrink, y * shrink), (deep, y), h - low, 0.008, mat);
    let grip = (low + 0.05).min(h * 0.85);
    for side in [-1.0, 1.0] {
        let (near, far) = (side * r * 0.32, side * (y - 0.03));
        b.rod("frame", [axle, near, r], [middle - deep * shrink, far * 0.72, low - 0.004], 0.016, frame);
        b.rod("frame", [middle - deep * shrink, far * 0.72, low - 0.004], [-x + 0.08, far * 0.85, grip], 0.016, frame);
        b.rod("grip", [-x + 0.1, far * 0.843, grip - 0.004], [-x + 0.004, far * 0.862, grip + 0.01], 0.02, RUBBER);
        let knee = [middle - deep * 0.45, side * y * 0.6, low];
        b.rod("leg", knee, [knee[0] - 0.06, side * y * 0.6, 0.012], 0.014, frame);
        b.rod("leg", [knee[0] - 0.1, side * y * 0.6, 0.012], [knee[0] + 0.02, side * y * 0.6, 0.012], 0.012, frame);
        b.rod("strut", [axle, near, r], [middle + deep * 0.5, side * y * shrink * 0.5, low + 0.003], 0.01, frame);
    }
    for (from, to) in [(-0.4, -0.16), (0.15, 0.4)] {
        b.rod("axle", [axle, from * r, r], [axle, to * r, r], 0.012, STEEL);
    }
    b.rod(
        "brace",
        [middle - deep * 0.45, -y * 0.6, low - 0.012],
        [middle - deep * 0.45, y * 0.6, low - 0.012],
        0.012,
        frame,
    );
    b.inside("basin", [middle, 0.0, low + 0.008], (deep * shrink - 0.02, y * shrink - 0.02), h - low);
}

/// A watering can with spout, rose and handles.
pub(super) fn watering_can(b: &mut Build<'_>) {
    grown(b, [0.07, 0.17, 0.12]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let mat = b.one(&[GREEN_PLASTIC, GALVANISED, BLUE_PLASTIC, RED_METAL, COPPER, YELLOW_PLASTIC, GREY_PLASTIC]);
    let r = x.min(y * 0.5);
    let body = h * b.vary(0.62, 0.75);
    let cy = -y + r + y * b.vary(0.02, 0.2);
    let t = 0.004;
    let waist = b.vary(0.85, 1.0);
    let profile = [
        (r, 0.0),
        (r * waist, body * 0.9),
        (r * waist * 0.85, body),
        (r * waist * 0.85 - t, body),
        (r * waist - t, body * 0.9),
        (r - t, t),
        (0.0, t),
    ];
    b.lathe("body", [0.0, cy, 0.0], &profile, mat);
    let tip = [0.0, y - h * 0.07, h - h * 0.1];
    let spout = limb([0.0, cy + r * 0.8, body * 0.25], tip, r * 0.2, r * 0.1);
    b.hull("spout", &spout, mat);
    let rose = h * 0.06;
    b.hull(
        "rose",
        &limb(
            [0.0, tip[1] - rose * 0.3, tip[2] - rose * 0.25],
            [0.0, y - rose, h - rose * 0.95],
            rose * 0.3,
            rose * 0.95,
        ),
        b.style.metal,
    );
    let thin = (r * 0.1).clamp(0.004, 0.012);
    let (back, top) = (cy - r * waist * 0.8, h - thin * 1.3);
    if b.rng.chance(0.5) {
        let outer = (-y + thin * 1.6).min(cy - r);
        b.pipe(
            "handle",
            &[
                [0.0, cy + r * 0.5, body * 0.97],
                [0.0, cy + r * 0.2, top],
                [0.0, back, top],
                [0.0, outer, body * 0.75],
                [0.0, cy - r * 0.96, body * 0.3],
            ],
            thin,
            mat,
        );
    } else {
        b.pipe(
            "handle",
            &[
                [0.0, cy + r * 0.75, body * 0.95],
                [0.0, cy + r * 0.4, top],
                [0.0, cy - r * 0.4, top],
                [0.0, back, body * 0.95],
            ],
            thin,
            mat,
        );
        let low = body * 0.3;
        let outer = (-y + thin * 1.6).max(cy - r * 1.6).min(cy - r * 0.99);
        b.pipe(
            "handle",
            &[
                [0.0, cy - r * 0.93, body * 0.75],
                [0.0, outer, body * 0.65],
                [0.0, outer, low + 0.03],
                [0.0, cy - r * 0.96, low],
            ],
            thin,
            mat,
        );
    }
    let strut = (cy + r * waist * 0.8, body * 0.98);
    b.rod(
        "strut",
        [0.0, strut.0, strut.1 - 0.01],
        [0.0, f32::midpoint(strut.0, tip[1]), f32::midpoint(body * 0.25, tip[2])],
        thin * 0.5,
        mat,
    );
}

/// A coiled hose with its nozzle.
pub(super) fn garden_hose(b: &mut Build<'_>) {
    grown(b, [0.17, 0.17, 0.06]);
    let (r, h) = (b.size.x.min(b.size.y) / 2.0, b.size.z);
    let mat = b.one(&[GREEN_PLASTIC, YELLOW_PLASTIC, ORANGE_PLASTIC, BLUE_PLASTIC, BLACK_PLASTIC, GREY_PLASTIC]);
    let rings = b.rng.count(1, 2);
    let layers = if rings == 1 { b.rng.count(4, 6) } else { b.rng.count(3, 4) };
    let tube = (h * 0.97 / (2.0 * layers as f32)).min(0.016);
    for layer in 0..layers {
        for ring in 0..rings {
            let out = r - tube * (1.0 + 2.1 * ring as f32) - b.vary(0.0, 0.5) * tube;
            let (dx, dy) = polar(b.vary(0.0, TAU), tube * 0.3);
            let out = (out - tube * 0.3).max(tube * 2.0);
            b.lathe("hose", [dx, dy, layer as f32 * tube * 1.96], &coil(out, tube), mat);
        }
    }
    let z = tube * 1.96 * layers as f32 - tube;
    let out = r - 3.0 * tube;
    let start = b.vary(-0.6, 0.6);
    let at = |a: f32, d: f32| {
        let (px, py) = polar(start + a, d);
        [px, py, z.min(h - tube)]
    };
    b.bar("hose", at(0.4, out), at(0.0, out * 0.4), tube, mat);
    b.hull("nozzle", &limb(at(0.0, out * 0.42), at(2.6, out * 0.35), tube * 1.2, tube * 1.5), b.style.metal);
    let tip = at(2.6, out * 0.33);
    b.hull("nozzle", &limb(tip, [tip[0] * 1.4, tip[1] * 1.4, tip[2]], tube * 1.4, tube * 0.7), ORANGE_PLASTIC);
    if z + 2.0 * tube < h {
        b.pipe("hose", &[at(3.4, out), [0.0, 0.0, h - tube * 1.2], at(5.6, out)], tube, mat);
    }
}

/// The profile of a ring of hose, with fewer corners than a hoop's.
fn coil(radius: f32, section: f32) -> Vec<(f32, f32)> {
    let corners = (0..=7).map(|i| polar(TAU * (i % 7) as f32 / 7.0, section));
    corners.map(|(r, z)| ((radius + r).max(0.0), z + section)).collect()
}

/// A hose on a reel: a frame, a drum with hose, a crank, wheels on tall ones.
pub(super) fn hose_reel(b: &mut Build<'_>) {
    grown(b, [0.17, 0.2, 0.22]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (frame, hose) = (
        b.one(&[GREY_PLASTIC, ANTHRACITE, GREEN_METAL, GALVANISED]),
        b.one(&[GREEN_PLASTIC, YELLOW_PLASTIC, ORANGE_PLASTIC, BLUE_PLASTIC]),
    );
    let r = (x * 0.88).min(h * 0.36);
    let axle = (r + 0.04).max(h * 0.36);
    let inner = y - 0.06;
    b.hinge([0.0, 0.0, axle], [0.0, 1.0, 0.0], TAU * 8.0, |b| {
        for side in [-1.0, 1.0] {
            b.rod("flange", [0.0, side * (inner - 0.03), axle], [0.0, side * (inner - 0.016), axle], r, frame);
        }
        b.rod("drum", [0.0, -inner + 0.02, axle], [0.0, inner - 0.02, axle], r * 0.5, frame);
        let coils = b.rng.count(5, 9);
        let step = (2.0 * inner - 0.07) / coils as f32;
        let full = r * b.vary(0.7, 0.9);
        for cy in spaced(coils, -inner + 0.035 + step / 2.0, inner - 0.035 - step / 2.0) {
            b.rod("hose", [0.0, cy - step * 0.47, axle], [0.0, cy + step * 0.47, axle], full, hose);
        }
        b.rod("axle", [0.0, -y + 0.034, axle], [0.0, inner + 0.018, axle], 0.012, frame);
        b.rod("crank", [0.0, -y + 0.034, axle], [r * 0.55, -y + 0.034, axle], 0.009, frame);
        b.rod("crank", [r * 0.55, -y + 0.044, axle], [r * 0.55, -y, axle], 0.012, BLACK_PLASTIC);
    });
    let tube = 0.011;
    for side in [-1.0, 1.0] {
        let cy = side * (inner + 0.002);
        // The axle turns in a ring that the tubes end at.
        let ring = [(0.022, -0.012), (0.022, 0.012), (0.0125, 0.012), (0.0125, -0.012), (0.022, -0.012)];
        b.lathe_along("bearing", [0.0, cy, axle], [0.0, cy + 1.0, axle], &ring, frame);
        for (fx, fz) in [(-x + tube, tube), (x - tube, tube), (-x * 0.75, h - tube)] {
            let short = 0.02 / fx.hypotenuse(fz - axle).max(0.04);
            b.rod("frame", [fx, cy, fz], [fx * short, cy, axle + (fz - axle) * short], tube, frame);
        }
    }
    b.rod("handle", [-x * 0.75, -inner, h - tube], [-x * 0.75, inner, h - tube], tube, frame);
    for foot in [-x + tube, x - tube] {
        b.rod("foot", [foot, -inner - 0.02, tube], [foot, inner + 0.02, tube], tube, frame);
    }
}

/// A lawn sprinkler: spinning arms, an oscillating bar, or a spike with a head.
pub(super) fn sprinkler(b: &mut Build<'_>) {
    grown(b, [0.06, 0.07, 0.035]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (mat, second) = (
        b.one(&[GREEN_PLASTIC, YELLOW_PLASTIC, ORANGE_PLASTIC, BLUE_PLASTIC]),
        b.one(&[BLACK_PLASTIC, GREY_PLASTIC, BRASS]),
    );
    if y > 0.14 {
        let (bow, end) = ((h * 0.09).max(0.005), y - 0.0125);
        for side in [-1.0, 1.0] {
            b.block("foot", [-x, side * end - 0.012, 0.0], [x, side * end + 0.012, 0.02_f32.min(h * 0.3)], second);
            b.block("post", [-0.012, side * end - 0.011, 0.005], [0.012, side * end + 0.011, h * 0.55], second);
        }
        b.block("rail", [-0.01, -end, 0.004], [0.01, end, 0.016_f32.min(h * 0.25)], second);
        let points: Vec<P> = spaced(7, -1.0, 1.0)
            .map(|s| [0.0, s * (end - 0.008 - bow), h * 0.5 + (h * 0.48 - 2.0 * bow) * (1.0 - s * s)])
            .collect();
        b.jointed(vc_graph::asset::JointKind::Hinge, [0.0, 0.0, h * 0.5], [0.0, 1.0, 0.0], (-1.0, 1.0), |b| {
            b.pipe("bow", &points, bow, mat)
        });
        b.rod("coupling", [0.0, end, h * 0.3], [x * 0.6, end, h * 0.3], (bow * 1.6).min(0.0105), ORANGE_PLASTIC);
    } else {
        let r = x.min(y);
        b.lathe("base", [0.0; 3], &[(r, 0.0), (r, h * 0.08), (r * 0.35, h * 0.2), (r * 0.2, h * 0.7)], second);
        let arms = b.rng.count(2, 4);
        b.jointed(vc_graph::asset::JointKind::Hinge, [0.0; 3], [0.0, 0.0, 1.0], (-1e4, 1e4), |b| {
            b.lathe("head", [0.0, 0.0, h * 0.68], &[(r * 0.28, 0.0), (r * 0.28, h * 0.18), (r * 0.12, h * 0.32)], mat);
            for i in 0..arms {
                let (px, py) = polar(TAU * i as f32 / arms as f32, r * 0.9);
                b.rod("arm", [0.0, 0.0, h * 0.78], [px, py, h * 0.84], r * 0.08, mat);
            }
        });
    }
}

/// A mower to push: deck, motor, bag, handle, four wheels.
pub(super) fn lawnmower(b: &mut Build<'_>) {
    grown(b, [0.6, 0.21, 0.42]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (paint, r) =
        (b.one(&[RED_METAL, GREEN_METAL, ORANGE, YELLOW_METAL, BLACK_PLASTIC, BLUE_METAL]), h * b.vary(0.085, 0.11));
    let deck = x * b.vary(0.5, 0.58);
    let (rear, fore) = (x - 2.0 * deck + r, x - r - 0.01);
    let rim = Rim::plain(b);
    for (name, wx, side) in
        [("wheel_fl", fore, 1.0), ("wheel_fr", fore, -1.0), ("wheel_rl", rear, 1.0), ("wheel_rr", rear, -1.0)]
    {
        wheel(b, name, [wx, side * (y - y * 0.09), r], r, y * 0.16, side, rim);
    }
    for wx in [rear, fore] {
        b.rod("axle", [wx, -y * 0.85 - 0.002, r], [wx, y * 0.85 + 0.002, r], r * 0.15, IRON);
    }
    let (low, top) = (r * 0.45, r * 1.9);
    let (middle, half) = ((rear + fore) / 2.0, (fore - rear) / 2.0);
    b.taper("deck", [middle, 0.0, low], (half + r * 0.5, y * 0.8), (half, y * 0.7), top - low, paint);
    let motor = top + h * b.vary(0.1, 0.16);
    if b.rng.chance(0.5) {
        b.soft(
            "motor",
            [middle - half * 0.45, -y * 0.45, top - 0.02],
            [middle + half * 0.6, y * 0.45, motor],
            0.03,
            paint,
        );
    } else {
        b.lathe(
            "motor",
            [middle + half * 0.1, 0.0, top - 0.01],
            &[(y * 0.5, 0.0), (y * 0.5, (motor - top) * 0.6), (y * 0.35, motor - top + 0.01)],
            BLACK_PLASTIC,
        );
        b.block(
            "tank",
            [middle - half * 0.3, y * 0.2, top - 0.01],
            [middle + half * 0.4, y * 0.62, motor * 0.93],
            RED_PLASTIC,
        );
    }
    let cloth = b.one(&[BLACK_FABRIC, GREY_FABRIC, GREEN_PLASTIC]);
    let bag = [
        [rear - r * 0.9, 0.55, r * 1.1],
        [rear - r * 0.9, 0.5, motor],
        [rear - x * 0.5, 0.5, r * 0.8],
        [rear - x * 0.55, 0.45, motor * 1.05],
    ];
    b.hull(
        "bag",
        &bag.iter().flat_map(|p| [[p[0].max(-x), p[1] * y, p[2]], [p[0].max(-x), -p[1] * y, p[2]]]).collect::<Vec<P>>(),
        cloth,
    );
    b.block("chute", [rear - r * 1.0, -y * 0.45, r * 1.2], [rear + r * 0.5, y * 0.45, top * 1.1], BLACK_PLASTIC);
    let (tube, wide) = (0.012, y * 0.82);
    let grip = [-x + tube * 1.5, h - tube * 1.5];
    for side in [-1.0, 1.0] {
        b.bar(
            "handle",
            [rear, side * wide * 0.85, top * 0.8],
            [grip[0] + 0.08, side * wide, grip[1] - 0.02],
            tube,
            IRON,
        );
        b.bar(
            "handle",
            [grip[0] + 0.08, side * wide, grip[1] - 0.02],
            [grip[0], side * wide * 0.9, grip[1]],
            tube,
            IRON,
        );
    }
    b.rod("grip", [grip[0], -wide * 0.9, grip[1]], [grip[0], wide * 0.9, grip[1]], tube * 1.3, RUBBER);
    b.rod(
        "lever",
        [grip[0] + 0.05, -wide * 0.97, grip[1] - 0.026],
        [grip[0] + 0.05, wide * 0.97, grip[1] - 0.026],
        0.006,
        RED_PLASTIC,
    );
    let stay = [f32::midpoint(rear, grip[0] + 0.08), f32::midpoint(top * 0.8, grip[1] - 0.02)];
    b.rod("stay", [stay[0], -wide * 0.93, stay[1]], [stay[0], wide * 0.93, stay[1]], 0.009, IRON);
}

/// A mower to ride: bonnet, seat, steering wheel, deck between the axles.
pub(super) fn ride_on_mower(b: &mut Build<'_>) {
    grown(b, [0.85, 0.45, 0.5]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let paint = b.one(&[GREEN_METAL, RED_METAL, ORANGE, YELLOW_METAL, BLUE_METAL]);
    let (big, small) = (h * b.vary(0.24, 0.27), h * b.vary(0.17, 0.19));
    let (rear, fore) = (-x + big + 0.02, x - small - 0.03);
    let rim = Rim::plain(b);
    for (name, wx, r, side) in [
        ("wheel_fl", fore, small, 1.0),
        ("wheel_fr", fore, small, -1.0),
        ("wheel_rl", rear, big, 1.0),
        ("wheel_rr", rear, big, -1.0),
    ] {
        let width = (r * 0.8).min(y * 0.4);
        wheel(b, name, [wx, side * (y * 0.86 - width / 2.0), r], r, width, side, rim);
    }
    for (wx, r) in [(rear, big), (fore, small)] {
        let end = y * 0.86 - (r * 0.8).min(y * 0.4) * 0.875 + 0.003;
        b.rod("axle", [wx, -end, r], [wx, end, r], 0.025, IRON);
    }
    let half = y * 0.42;
    let belt = big * 1.5;
    b.block("frame", [rear - big * 0.6, -half * 0.8, small], [fore + small * 0.5, half * 0.8, belt * 0.75], IRON);
    let dash = rear + (fore - rear) * 0.55;
    let hood: Vec<P> = [1.0, -1.0]
        .into_iter()
        .flat_map(|s| {
            [
                [dash, s * half, belt * 0.7],
                [dash, s * half * 0.95, h * 0.68],
                [x - 0.06, s * half * 0.85, h * 0.56],
                [x - 0.01, s * half * 0.8, small * 1.4],
                [x - 0.005, s * half * 0.75, h * 0.42],
            ]
        })
        .collect();
    b.hull("bonnet", &hood, paint);
    for side in [-1.0, 1.0] {
        b.block(
            "headlight",
            [x - 0.08, side * half * 0.5 - 0.05, h * 0.42],
            [x - 0.012, side * half * 0.5 + 0.05, h * 0.48],
            COOL_BULB,
        );
        let guard = [
            [rear - big * 0.9, belt],
            [rear - big * 0.5, big * 2.12],
            [rear + big * 0.7, big * 2.12],
            [rear + big * 1.15, belt],
        ];
        let (a, c) = (side * half * 0.7, side * y * 0.88);
        b.hull(
            "mudguard",
            &guard
                .iter()
                .flat_map(|p| [[p[0], a, p[1] + 0.03], [p[0], c, p[1] + 0.03], [p[0], a, p[1] + 0.05]])
                .filter(|p| p[2] > big * 2.0)
                .chain([[rear - big * 0.5, a, big * 2.1], [rear + big * 0.7, a, big * 2.1]])
                .collect::<Vec<P>>(),
            paint,
        );
    }
    b.block("base", [rear - big * 0.7, -half * 0.75, belt * 0.7], [rear + big * 0.8, half * 0.75, big * 2.14], paint);
    let seat = (big * 2.14 + 0.02).max(h * 0.55);
    b.block("post", [rear - 0.06, -0.1, big * 2.1], [rear + 0.1, 0.1, seat - 0.02], IRON);
    b.soft(
        "seat",
        [rear - big * 0.3, -half * 0.75, seat - 0.03],
        [rear + big * 0.85, half * 0.75, seat + 0.05],
        0.04,
        BLACK_LEATHER,
    );
    b.soft("back", [rear - big * 0.55, -half * 0.7, seat], [rear - big * 0.2, half * 0.7, h], 0.05, BLACK_LEATHER);
    let hub = [dash - 0.12, 0.0, h * 0.82];
    let hold = ((h * 0.18 - 0.02) / 0.6).clamp(0.03, 0.15);
    let room = (big * 0.7).min(hub[0] - hold - 0.02 - rear).max(0.04);
    b.top("seat", [rear + room / 2.0, 0.0, seat + 0.05], (room / 2.0, half * 0.55));
    b.rod("column", [dash + 0.02, 0.0, h * 0.62], hub, 0.018, IRON);
    b.lathe_along(
        "steering_wheel",
        hub,
        [hub[0] - 0.6, hub[1], hub[2] + 0.8],
        &[(hold, 0.0), (hold, 0.02), (hold * 0.8, 0.02), (hold * 0.8, 0.0), (hold, 0.0)],
        BLACK_PLASTIC,
    );
    let across = hold * 0.87;
    b.rod("steering_wheel", [hub[0], -across, hub[2]], [hub[0], across, hub[2]], 0.01, BLACK_PLASTIC);
    let (d0, d1) = (rear + big * 1.05, fore - small * 1.1);
    b.taper(
        "deck",
        [(d0 + d1) / 2.0, 0.0, small * 0.45],
        ((d1 - d0) / 2.0, y),
        ((d1 - d0) / 2.0 * 0.85, y * 0.85),
        small * 0.7,
        paint,
    );
    b.block("footplate", [d0, -y * 0.8, small * 1.16], [d1, y * 0.8, small * 1.26], GREY_RUBBER);
    b.block("link", [d0, -half * 0.7, small * 1.1], [d1, half * 0.7, belt * 0.72], IRON);
}

/// A robot mower: a rounded shell on wheels.
pub(super) fn robot_mower(b: &mut Build<'_>) {
    grown(b, [0.25, 0.18, 0.1]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (paint, r) =
        (b.one(&[GREY_PLASTIC, ORANGE_PLASTIC, GREEN_PLASTIC, WHITE_PLASTIC, BLACK_PLASTIC]), h * b.vary(0.36, 0.42));
    let rim = Rim::plain(b);
    let rear = -x + r + x * 0.15;
    for (name, side) in [("wheel_l", 1.0), ("wheel_r", -1.0)] {
        wheel(b, name, [rear, side * (y - y * 0.1), r], r, y * 0.2, side, rim);
    }
    b.rod("axle", [rear, -y * 0.85, r], [rear, y * 0.85, r], 0.012, IRON);
    let low = h * 0.16;
    b.taper("body", [0.0, 0.0, low], (x * 0.9, y * 0.76), (x * 0.85, y * 0.72), h * 0.4, BLACK_PLASTIC);
    let rows = [(0.98, 0.76, 0.42), (1.0, 0.78, 0.55), (0.8, 0.66, 0.85), (0.45, 0.45, 0.97)];
    let shell: Vec<P> = rows
        .into_iter()
        .flat_map(|(sx, sy, z)| {
            polygon(12, 1.0, 0.26)
                .into_iter()
                .map(move |(px, py)| [(px * 1.0353 * x * sx).clamp(-x, x), py * 1.0353 * y * sy, h * z])
        })
        .collect();
    b.hull("shell", &shell, paint);
    b.rod("button", [x * 0.05, 0.0, h * 0.95], [x * 0.05, 0.0, h], 0.035_f32.min(y * 0.25), SIGNAL_RED);
    b.block("panel", [-x * 0.35, -y * 0.25, h * 0.95], [-x * 0.1, y * 0.25, h * 0.982], SCREEN);
    for side in [-1.0, 1.0] {
        let at = [x * 0.65, side * y * 0.4, low];
        b.ball("caster", [at[0], at[1], low * 0.75], low * 0.75, RUBBER);
        b.cylinder("caster", [at[0], at[1], low * 0.8], 0.012, low, IRON);
    }
}

/// A hedge trimmer, upright on its handles: a motor and a toothed bar.
pub(super) fn hedge_trimmer(b: &mut Build<'_>) {
    grown(b, [0.07, 0.09, 0.4]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let paint = b.one(&[ORANGE_PLASTIC, GREEN_PLASTIC, RED_PLASTIC, BLUE_PLASTIC, YELLOW_PLASTIC]);
    let body = h * b.vary(0.36, 0.42);
    let thin = (y * 0.12).min(0.016);
    b.soft("motor", [-x * 0.75, -y * 0.45, h * 0.16], [x * 0.75, y * 0.45, body], 0.03, paint);
    b.pipe(
        "rear_grip",
        &[
            [-x * 0.6, 0.0, h * 0.18],
            [-x + thin * 1.3, 0.0, thin * 1.5],
            [x - thin * 1.3, 0.0, thin * 1.5],
            [x * 0.6, 0.0, h * 0.18],
        ],
        thin,
        BLACK_PLASTIC,
    );
    let z = body * 0.92;
    b.pipe(
        "front_grip",
        &[
            [x * 0.3, -y * 0.4, z],
            [x * 0.3, -y + thin * 1.4, z + 0.02],
            [x - thin * 1.5, -y + thin * 1.4, z + 0.03],
            [x - thin * 1.5, y - thin * 1.4, z + 0.03],
            [x * 0.3, y - thin * 1.4, z + 0.02],
            [x * 0.3, y * 0.4, z],
        ],
        thin,
        BLACK_PLASTIC,
    );
    b.block("bar", [-0.006, -0.016, body - 0.01], [0.006, 0.016, h], STEEL);
    let teeth = b.rng.count(10, 16);
    for tz in spaced(teeth, body + 0.05, h - 0.012) {
        b.block("tooth", [-0.004, -y * 0.42, tz - 0.005], [0.004, y * 0.42, tz + 0.005], STEEL);
    }
    b.block("shield", [-x * 0.6, -y * 0.85, body * 0.98], [-x * 0.6 + 0.006, y * 0.85, body * 1.15], CLEAR_PLASTIC);
    b.block("link", [-x * 0.61, -0.02, body * 0.9], [0.0, 0.02, body * 1.02], BLACK_PLASTIC);
}

/// A strimmer, upright on its head: a guard, a shaft, a loop, a motor on top.
pub(super) fn grass_trimmer(b: &mut Build<'_>) {
    grown(b, [0.1, 0.11, 0.5]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let paint = b.one(&[ORANGE_PLASTIC, GREEN_PLASTIC, RED_PLASTIC, YELLOW_PLASTIC]);
    let r = x.min(y);
    let cut: Vec<(f32, f32)> = (0..=10)
        .map(|i| FRAC_PI_2 * (1.0 + 0.2 * i as f32))
        .map(|a| polar(a, r * 0.98))
        .chain([(0.0, -r * 0.98), (0.02, 0.0)])
        .collect();
    b.prism("guard", Axis::Z, [0.0, 0.0, 0.03], &cut, 0.02, BLACK_PLASTIC);
    b.cylinder("spool", [0.0; 3], r * 0.35, 0.055, BLACK_PLASTIC);
    b.rod("line", [0.0, 0.0, 0.012], [x - 0.004, 0.0, 0.012], 0.0015, ORANGE_PLASTIC);
    let (top, thin) = (h * b.vary(0.8, 0.86), 0.012);
    let back = -x * 0.35;
    b.bar("shaft", [0.0, 0.0, 0.06], [back, 0.0, top], thin, ALUMINIUM);
    b.soft("motor", [back - x * 0.45, -y * 0.4, top - 0.03], [back + x * 0.45, y * 0.4, h], 0.03, paint);
    let z = h * b.vary(0.5, 0.62);
    let at = back * z / top;
    let loop_r = (y * 0.8).min(0.11);
    b.pipe(
        "loop",
        &[
            [at, -0.01, z],
            [at + x * 0.2, -loop_r, z + 0.02],
            [at + x * 0.55, -loop_r * 0.8, z + 0.1],
            [at + x * 0.55, loop_r * 0.8, z + 0.1],
            [at + x * 0.2, loop_r, z + 0.02],
            [at, 0.01, z],
        ],
        thin * 0.8,
        BLACK_PLASTIC,
    );
    b.rod("grip", [back * 0.88, 0.0, top * 0.86], [back, 0.0, top], thin * 1.6, RUBBER);
}

/// A leaf blower, upright on its tube's mouth.
pub(super) fn leaf_blower(b: &mut Build<'_>) {
    grown(b, [0.07, 0.09, 0.4]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let paint = b.one(&[ORANGE_PLASTIC, GREEN_PLASTIC, RED_PLASTIC, BLUE_PLASTIC, YELLOW_PLASTIC]);
    let body = h * b.vary(0.6, 0.66);
    let tube = x.min(y) * b.vary(0.32, 0.42);
    let at = x - tube * 1.35;
    b.lathe("tube", [at, 0.0, 0.0], &[(tube * 1.3, 0.0), (tube, h * 0.12), (tube * 1.1, body + 0.03)], BLACK_PLASTIC);
    b.rod(
        "housing",
        [at - x * 0.4, -y * 0.8, body + (h - body) * 0.4],
        [at - x * 0.4, y * 0.6, body + (h - body) * 0.4],
        ((h - body) * 0.4).min(x * 0.58),
        paint,
    );
    b.rod(
        "grille",
        [at - x * 0.4, y * 0.59, body + (h - body) * 0.4],
        [at - x * 0.4, y, body + (h - body) * 0.4],
        ((h - body) * 0.28).min(x * 0.4),
        BLACK_PLASTIC,
    );
    b.soft("motor", [at - x * 0.3, -y * 0.5, body], [at + tube * 0.7, y * 0.4, body + (h - body) * 0.75], 0.02, paint);
    let thin = (tube * 0.4).min(0.016);
    b.pipe(
        "handle",
        &[
            [at, 0.0, body + (h - body) * 0.7],
            [at, 0.0, h - thin * 1.1],
            [at - x * 0.7, 0.0, h - thin * 1.1],
            [at - x * 0.7, 0.0, body + (h - body) * 0.55],
        ],
        thin,
        BLACK_PLASTIC,
    );
}

/// A chainsaw lying on its base, its bar along Y.
pub(super) fn chainsaw(b: &mut Build<'_>) {
    grown(b, [0.1, 0.3, 0.11]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let paint = b.one(&[ORANGE, RED_METAL, YELLOW_METAL, GREEN_METAL]);
    let split = -y + 2.0 * y * b.vary(0.46, 0.52);
    let back = -y + 2.0 * y * 0.2;
    b.soft("motor", [-x * 0.85, back, 0.0], [x * 0.6, split, h * 0.72], 0.03, paint);
    b.block("cover", [x * 0.58, back + 0.03, h * 0.08], [x * 0.85, split + 0.02, h * 0.5], BLACK_PLASTIC);
    let (z, half) = (h * 0.33, h * b.vary(0.13, 0.17));
    let bar = [
        (split - 0.02, z - half),
        (y - half, z - half),
        (y - half * 0.35, z - half * 0.7),
        (y, z),
        (y - half * 0.35, z + half * 0.7),
        (y - half, z + half),
        (split - 0.02, z + half),
    ];
    let chain: Vec<(f32, f32)> =
        bar.iter().map(|&(py, pz)| ((py - if py > split { half * 0.16 } else { 0.0 }), z + (pz - z) * 0.82)).collect();
    b.prism("chain", Axis::X, [x * 0.66, 0.0, 0.0], &bar, 0.006, IRON);
    b.prism("bar", Axis::X, [x * 0.66 - 0.002, 0.0, 0.0], &chain, 0.01, STEEL);
    let thin = (h * 0.05).min(0.014);
    b.pipe(
        "front_grip",
        &[
            [-x * 0.7, split - 0.05, h * 0.2],
            [-x + thin * 1.3, split - 0.05, h * 0.6],
            [-x * 0.6, split - 0.03, h - thin * 1.1],
            [x * 0.45, split - 0.02, h - thin * 1.1],
            [x * 0.5, split - 0.03, h * 0.6],
        ],
        thin,
        BLACK_PLASTIC,
    );
    b.pipe(
        "rear_grip",
        &[
            [0.0, back + 0.02, h * 0.62],
            [0.0, -y + thin * 2.0, h * 0.5],
            [0.0, -y + thin * 1.3, h * 0.1 + thin],
            [0.0, back + 0.02, h * 0.1 + thin],
        ],
        thin * 1.1,
        BLACK_PLASTIC,
    );
    b.block("hand_guard", [-x * 0.7, split + 0.006, h * 0.6], [x * 0.45, split + 0.014, h * 0.92], BLACK_PLASTIC);
    b.block("hand_guard", [-x * 0.3, split - 0.02, h * 0.55], [x * 0.2, split + 0.012, h * 0.66], BLACK_PLASTIC);
    let points = blob(b, [0.0, back + 0.05, h * 0.72], [x * 0.25, 0.03, h * 0.05], 12, 0.1);
    b.hull("cap", &points, BLACK_PLASTIC);
}
