//! Hand tools for the garden, ladders and a wheelbarrow.

use std::f32::consts::FRAC_PI_2;

use nalgebra::{Isometry3, Vector3};
use vc_graph::portable::Portable;

use crate::material::*;
use crate::object::vehicle::wheel::{Rim, wheel};
use crate::solid::{Axis, Build, P, at_least, limb, spaced, tapered_tub};

/// A long-handled tool that cannot stand on its head: it lies with the head down.
pub(super) fn lying_tool(b: &mut Build<'_>) {
    let size = b.size;
    b.size = size.zyx();
    let pose = Isometry3::new(Vector3::new(-size.x / 2.0, 0.0, size.z / 2.0), Vector3::y() * FRAC_PI_2);
    b.posed(pose, hand_tool);
    b.size = size;
}

/// A long-handled tool, upright with its head at the bottom: shovel, spade, fork, hoe, rake, axe,
/// trowel.
pub(super) fn hand_tool(b: &mut Build<'_>) {
    at_least(b, [0.014, 0.03, 0.13]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let steel = b.choose(&[STEEL, IRON, GALVANISED, RUST, GREEN_METAL]);
    let wood = b.choose(&[ASH, BEECH, PINE, YELLOW, BLACK_PLASTIC]);
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
fn handled(b: &mut Build<'_>, (x, y, h): (f32, f32, f32), head: f32, r: f32, wood: MaterialId) {
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

fn shaft(b: &mut Build<'_>, x: f32, low: f32, top: f32, r: f32, wood: MaterialId) {
    b.lathe(
        "shaft",
        [x, 0.0, low],
        &[(r * 0.85, 0.0), (r, (top - low) * 0.5), (r * 0.9, top - low - r), (r * 0.6, top - low)],
        wood,
    );
}

/// A dished blade in three strips: pointed, or square for a spade.
fn blade(b: &mut Build<'_>, (x, y): (f32, f32), head: f32, square: bool, steel: MaterialId) {
    let t = (x * 0.12).min(0.004);
    let point = if square { b.vary(0.0, 0.06) } else { b.vary(0.2, 0.4) };
    let at = |u: f32, v: f32| {
        // `u` runs across from -1 to 1, `v` upwards from 0 to 1.
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

fn axe(b: &mut Build<'_>, (x, y, h): (f32, f32, f32), (steel, wood): (MaterialId, MaterialId)) {
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

fn rake(b: &mut Build<'_>, (x, y, h, r): (f32, f32, f32, f32), (steel, wood): (MaterialId, MaterialId)) {
    if b.rng.chance(0.5) {
        // A leaf rake: tines fan out and bend at their tips.
        let tines = b.rng.count(11, 19);
        let (root, bend) = (h * 0.28, 0.03_f32.min(x));
        shaft(b, -x + r, root * 0.9, h, r, wood);
        let mat = b.choose(&[steel, BAMBOO, GREEN_PLASTIC, ORANGE_PLASTIC]);
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

/// Secateurs, upright: blades at the top, sprung grips at the bottom.
pub(super) fn pruning_shears(b: &mut Build<'_>) {
    at_least(b, [0.008, 0.02, 0.08]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let grip = b.choose(&[RED_PLASTIC, ORANGE_PLASTIC, GREEN_PLASTIC, BLACK_PLASTIC]);
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

/// A pair of gloves, one on the other, flat and upright as if hanging.
pub(super) fn gloves(b: &mut Build<'_>) {
    at_least(b, [0.01, 0.05, 0.1]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (palm, cuff) = (
        b.choose(&[GREEN_FABRIC, TAN_LEATHER, RED_FABRIC, BLUE_FABRIC, MUSTARD_FABRIC]),
        b.choose(&[BEIGE_FABRIC, WHITE_COTTON, GREY_FABRIC, BLACK_FABRIC]),
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
            b.rounded_block(
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

/// An upright ladder: two stiles, rungs between them, sometimes a second section in front.
pub(super) fn ladder(b: &mut Build<'_>) {
    at_least(b, [0.035, 0.17, 0.5]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let mat = b.choose(&[ALUMINIUM, ALUMINIUM, PINE, OAK, ORANGE]);
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

/// A step ladder: treads in front, a support behind, spread over the full depth.
pub(super) fn step_ladder(b: &mut Build<'_>) {
    at_least(b, [0.06, 0.2, 0.4]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let mat = b.choose(&[ALUMINIUM, ALUMINIUM, PINE, WHITE_METAL, ORANGE]);
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
    b.rounded_block(
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
    at_least(b, [0.55, 0.27, 0.27]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let mat = b.choose(&[GREEN_METAL, GALVANISED, RED_METAL, BLUE_METAL, BLACK_PLASTIC, YELLOW_METAL]);
    let frame = b.choose(&[IRON, GALVANISED, PINE, RED_METAL]);
    let r = h * b.vary(0.23, 0.27);
    let axle = x - r;
    let rim = Rim::plain(b);
    wheel(b, "wheel", [axle, 0.0, r], r, r * 0.45, 1.0, rim);
    let (low, deep) = (2.0 * r + h * b.vary(0.03, 0.05), x * b.vary(0.5, 0.56));
    let middle = x - deep - r * 0.35;
    let shrink = b.vary(0.5, 0.65);
    tapered_tub(b, "tray", [middle, 0.0, low], (deep * shrink, y * shrink), (deep, y), h - low, 0.008, mat);
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
