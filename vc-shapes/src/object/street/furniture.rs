//! Hydrants, posts, meters, covers and kerbs.

use std::f32::consts::{PI, TAU};

use vc_graph::portable::Portable;

use crate::material::*;
use crate::solid::{Axis, Build, CORNERS, P, at_least, evenly_spaced_ellipse, polar, polygon, spaced};

/// A fire hydrant: a capped pillar with outlets; its spindle rotates.
pub(super) fn hydrant(b: &mut Build<'_>) {
    at_least(b, [0.15, 0.15, 0.3]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let mat = b.choose(&[RED_METAL, RED_METAL, YELLOW_METAL, BLUE_METAL, GREEN_METAL]);
    let cap = b.choose(&[mat, SILVER_METAL, WHITE_METAL, YELLOW_METAL]);
    let out = x.min(y);
    let r = out * b.vary(0.55, 0.65);
    let bonnet = h * b.vary(0.7, 0.78);
    let dome: Vec<(f32, f32)> = match b.rng.below(3) {
        0 => vec![(r * 1.1, 0.0), (r * 1.1, 0.03), (r * 0.95, h * 0.08), (r * 0.6, h * 0.14), (r * 0.2, h * 0.16)],
        1 => vec![(r * 1.15, 0.0), (r * 1.15, h * 0.03), (r * 0.9, h * 0.05), (r * 0.35, h * 0.15)],
        _ => vec![(r * 1.05, 0.0), (r * 1.05, h * 0.1), (r * 0.8, h * 0.16)],
    };
    let body = [
        (r * 1.3, 0.0),
        (r * 1.3, h * 0.04),
        (r * 0.9, h * 0.05),
        (r * 0.85, h * 0.2),
        (r, h * 0.22),
        (r * 0.95, bonnet),
    ];
    b.lathe("body", [0.0; 3], &body, mat);
    b.lathe("bonnet", [0.0, 0.0, bonnet - 0.004], &dome, cap);
    let bolts = b.rng.count(6, 8);
    for i in 0..bolts {
        let (px, py) = polar(TAU * i as f32 / bolts as f32, r * 1.12);
        b.cylinder("bolt", [px, py, h * 0.04], r * 0.08, h * 0.025, cap);
    }
    let level = h * b.vary(0.5, 0.6);
    let front = b.rng.chance(0.7);
    for side in [-1.0, 1.0] {
        outlet(b, [0.0, side, 0.0], level, (r, out, out * 0.2), (mat, cap));
    }
    if front {
        outlet(b, [1.0, 0.0, 0.0], level - h * 0.05, (r, out, out * 0.32), (mat, cap));
    }
    let tip = bonnet + dome.last().map_or(0.0, |d| d.1) - 0.012;
    b.hinge([0.0, 0.0, tip], [0.0, 0.0, 1.0], TAU * 2.0, |b| {
        b.prism("spindle", Axis::Z, [0.0, 0.0, tip], &polygon(5, r * 0.2, 0.0), (h - tip).max(0.01), cap);
    });
}

/// A capped outlet that points along `way`.
fn outlet(b: &mut Build<'_>, way: P, z: f32, (from, to, r): (f32, f32, f32), (mat, cap): (MaterialId, MaterialId)) {
    let at = |d: f32| [way[0] * d, way[1] * d, z];
    let span = to - from * 0.7;
    b.lathe_along(
        "outlet",
        at(from * 0.7),
        at(to),
        &[(r * 0.8, 0.0), (r * 0.8, span * 0.5), (r, span * 0.5), (r, span * 0.62)],
        mat,
    );
    b.lathe_along(
        "cap",
        at(from * 0.7),
        at(to),
        &[(r * 1.05, span * 0.6), (r * 0.95, span * 0.85), (r * 0.35, span * 0.86), (r * 0.3, span)],
        cap,
    );
}

/// A traffic cone with bright bands on a square base.
pub(super) fn cone(b: &mut Build<'_>) {
    at_least(b, [0.1, 0.1, 0.12]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let foot = h * b.vary(0.04, 0.07);
    let base = b.choose(&[ORANGE_PLASTIC, RUBBER, ORANGE_PLASTIC]);
    let bevel = x.min(y) * b.vary(0.1, 0.3);
    let corner: Vec<(f32, f32)> = CORNERS
        .into_iter()
        .flat_map(|(sx, sy): (f32, f32)| {
            let cut = [(sx * x, sy * (y - bevel)), (sx * (x - bevel), sy * y)];
            if sx * sy > 0.0 { cut } else { [cut[1], cut[0]] }
        })
        .collect();
    b.prism("foot", Axis::Z, [0.0; 3], &corner, foot, base);
    let (wide, tip) = (x.min(y) * b.vary(0.7, 0.8), x.min(y) * b.vary(0.12, 0.2));
    let at = |t: f32| wide + (tip - wide) * t;
    b.lathe(
        "cone",
        [0.0, 0.0, foot - 0.002],
        &[(wide, 0.0), (tip, h - foot), (tip * 0.5, h - foot + 0.002)],
        ORANGE_PLASTIC,
    );
    let bands = b.rng.count(1, 3);
    for i in 0..bands {
        let (t0, t1) = (0.3 + 0.26 * i as f32, 0.43 + 0.26 * i as f32);
        let (z0, z1) = ((h - foot) * t0, (h - foot) * t1);
        b.lathe("band", [0.0, 0.0, foot], &[(at(t0) + 0.002, z0), (at(t1) + 0.002, z1)], WHITE_PLASTIC);
    }
}

/// A bollard: turned iron, a steel tube, a concrete block or a wooden post.
pub(super) fn bollard(b: &mut Build<'_>) {
    at_least(b, [0.05, 0.05, 0.3]);
    let (r, h) = (b.size.x.min(b.size.y) / 2.0, b.size.z);
    let band = h * b.vary(0.7, 0.85);
    match b.rng.below(5) {
        0 => {
            let iron = b.choose(&[IRON, ANTHRACITE, GREEN_METAL]);
            let waist = r * b.vary(0.55, 0.7);
            let profile = [
                (r, 0.0),
                (r, h * 0.1),
                (waist, h * 0.14),
                (waist * 0.85, h * 0.75),
                (waist * 1.2, h * 0.78),
                (waist * 0.8, h * 0.82),
                (waist * 1.15, h * 0.9),
                (waist * 0.8, h * 0.97),
                (waist * 0.2, h),
            ];
            b.lathe("post", [0.0; 3], &profile, iron);
        }
        1 => {
            let steel = b.choose(&[STEEL, GALVANISED, ANTHRACITE]);
            b.lathe(
                "post",
                [0.0; 3],
                &[(r, 0.0), (r, 0.01), (r * 0.8, 0.012), (r * 0.8, h - r * 0.3), (r * 0.5, h)],
                steel,
            );
            b.cylinder("band", [0.0, 0.0, band], r * 0.82, h * 0.06, YELLOW_PLASTIC);
        }
        2 => {
            b.taper("post", [0.0; 3], (r, r), (r * 0.75, r * 0.75), h * 0.9, CONCRETE);
            b.taper("cap", [0.0, 0.0, h * 0.9], (r * 0.75, r * 0.75), (r * 0.1, r * 0.1), h * 0.1, CONCRETE);
        }
        3 => {
            let wood = b.choose(&[OAK, PINE, TEAK]);
            b.block("post", [-r, -r, 0.0], [r, r, h * 0.93], wood);
            b.taper("cap", [0.0, 0.0, h * 0.93], (r, r), (r * 0.5, r * 0.5), h * 0.07, wood);
            b.block("reflector", [r * 0.9, -r * 0.5, band * 0.9], [r + 0.001, r * 0.5, band], RED_PLASTIC);
        }
        _ => {
            let (main, second) = (b.choose(&[WHITE, YELLOW, RED]), b.choose(&[RED, BLACK]));
            b.cylinder("post", [0.0; 3], r * 0.9, h - r * 0.9, main);
            for i in 0..3 {
                b.cylinder("band", [0.0, 0.0, h * (0.15 + 0.27 * i as f32)], r * 0.92, h * 0.12, second);
            }
            b.cylinder("foot", [0.0; 3], r, 0.02, IRON);
            b.ball("top", [0.0, 0.0, h - r * 0.9], r * 0.9, main);
        }
    }
}

/// A parking meter on a post, or a pay station.
pub(super) fn parking_meter(b: &mut Build<'_>) {
    at_least(b, [0.1, 0.1, 0.6]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let mat = b.choose(&[ANTHRACITE, SILVER_METAL, BLUE_METAL, GREEN_METAL, GALVANISED]);
    if b.rng.chance(0.5) {
        let (low, r) = (h * 0.72, (y * 0.7).min(0.13));
        b.lathe(
            "post",
            [0.0; 3],
            &[(x.min(y) * 0.8, 0.0), (x.min(y) * 0.8, 0.02), (0.03, 0.025), (0.03, low + 0.01)],
            mat,
        );
        let heads = if y > 0.17 && b.rng.chance(0.5) { 2 } else { 1 };
        if heads == 2 {
            b.block("yoke", [-0.03, -y * 0.6, low - 0.03], [0.03, y * 0.6, low + 0.01], mat);
        }
        for cy in spaced(heads, -y * 0.52, y * 0.52) {
            let half = if heads == 2 { y * 0.46 } else { r };
            let tall = h - low;
            let mut outline = vec![(-half, 0.0), (half, 0.0)];
            outline.extend(
                (0..=10)
                    .map(|i| PI * i as f32 / 10.0)
                    .map(|a| (half * a.cosine(), tall - half.min(tall * 0.5) * (1.0 - a.sine()))),
            );
            b.prism("head", Axis::X, [-x * 0.7, cy, low], &outline, x * 1.4, mat);
            face(b, x * 0.7, [cy, low + tall * 0.08, tall * 0.8, half * 0.75], x * 0.25);
        }
    } else {
        b.block("foot", [-x, -y, 0.0], [x, y, 0.03], CONCRETE);
        b.rounded_block("case", [-x * 0.9, -y * 0.9, 0.025], [x * 0.9, y * 0.9, h * 0.9], 0.03, mat);
        b.taper("roof", [0.0, 0.0, h * 0.895], (x, y), (x * 0.4, y * 0.6), h * 0.05, b.style.metal);
        b.block("solar", [-x * 0.35, -y * 0.55, h * 0.94], [x * 0.35, y * 0.55, h], BLACK_GLASS);
        face(b, x * 0.9, [0.0, h * 0.62, h * 0.22, y * 0.65], x * 0.1);
        b.block("sign", [x * 0.89, -y * 0.3, h * 0.2], [x * 0.91, y * 0.3, h * 0.42], BLUE_PLASTIC);
    }
}

/// Screen, keys and slot on a front at `x`: centre, lower end, height and half width.
fn face(b: &mut Build<'_>, x: f32, [cy, low, tall, half]: [f32; 4], deep: f32) {
    let deep = deep.min(0.02);
    b.block(
        "screen",
        [x - 0.003, cy - half, low + tall * 0.45],
        [x + deep * 0.4, cy + half, low + tall * 0.85],
        SCREEN,
    );
    b.block("text", [x, cy - half * 0.8, low + tall * 0.6], [x + deep * 0.55, cy + half * 0.5, low + tall * 0.7], LED);
    b.block(
        "slot",
        [x - 0.003, cy - half * 0.8, low + tall * 0.15],
        [x + deep * 0.3, cy - half * 0.1, low + tall * 0.25],
        BLACK,
    );
    for dy in [0.2, 0.6] {
        b.rod(
            "key",
            [x - 0.003, cy + half * dy, low + tall * 0.2],
            [x + deep, cy + half * dy, low + tall * 0.2],
            half * 0.15,
            GREEN,
        );
    }
}

/// A charging station: a pillar or a wall box, with cable and plug.
pub(super) fn charging_station(b: &mut Build<'_>) {
    at_least(b, [0.08, 0.1, 0.15]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let mat = b.choose(&[WHITE_METAL, ANTHRACITE, SILVER_METAL, BLACK_METAL, GREEN_METAL]);
    let front = -x + 2.0 * x * b.vary(0.55, 0.7);
    let low = if h > 0.8 { 0.0 } else { h * 0.12 };
    let (deep, wide) = (x - front, y * 0.8);
    if low == 0.0 {
        b.block("foot", [-x, -y, 0.0], [front + 0.01, y, 0.04], CONCRETE);
    }
    b.rounded_block("case", [-x, -wide, low], [front, wide, h], 0.02_f32.min(x * 0.3), mat);
    let (z, tall) = (low + (h - low) * 0.6, (h - low) * 0.3);
    b.block("screen", [front - 0.004, -wide * 0.6, z + tall * 0.45], [front + 0.004, wide * 0.6, z + tall], SCREEN);
    b.block("light", [front - 0.004, -wide * 0.9, z + tall * 0.3], [front + 0.003, wide * 0.9, z + tall * 0.36], LED);
    let r = (wide * 0.25).min(0.035);
    b.rod("plug", [front - 0.005, 0.0, z], [front + deep * 0.6, 0.0, z], r, BLACK_PLASTIC);
    b.rod("grip", [front + deep * 0.5, 0.0, z], [front + deep * 0.6, 0.0, z - tall * 0.5], r * 0.5, BLACK_PLASTIC);
    let cable = (deep * 0.16).clamp(0.003, 0.012);
    let (top, bottom) = (z - tall * 0.45, (low + (h - low) * 0.12).max(cable));
    let out = front + deep * 0.6;
    let side = y - 1.6 * cable;
    let points: Vec<P> = (0..=6)
        .map(|i| PI * i as f32 / 6.0)
        .map(|a| [out, side * 0.5 * (1.0 - a.cosine()), top - (top - bottom) * a.sine()])
        .collect();
    b.pipe("cable", &points, cable, RUBBER);
    b.pipe("cable", &[[out, side, top], [front - 0.02, wide * 0.9, top]], cable, RUBBER);
}

/// A manhole cover: an iron disc with a pattern, or a grate, in its frame.
pub(super) fn manhole_cover(b: &mut Build<'_>) {
    at_least(b, [0.25, 0.25, 0.02]);
    let (r, h) = (b.size.x.min(b.size.y) / 2.0, b.size.z);
    let rim = r * b.vary(0.82, 0.9);
    let iron = b.choose(&[IRON, IRON, RUST, GALVANISED]);
    let frame = [(r, 0.0), (r, h - 0.004), (rim + 0.005, h - 0.003), (rim + 0.005, 0.0), (r, 0.0)];
    b.lathe("frame", [0.0; 3], &frame, iron);
    b.cylinder("cover", [0.0; 3], rim, h - 0.005, iron);
    let rings = b.rng.count(1, 4);
    for i in 0..rings {
        let at = rim * (0.92 - 0.8 * i as f32 / rings as f32);
        let (from, z0, z1) = (at - rim * 0.05, h - 0.007, h - 0.001);
        b.lathe("ring", [0.0; 3], &[(at, z0), (at, z1), (from, z1), (from, z0), (at, z0)], iron);
    }
    let spokes = b.rng.count(6, 20);
    let inner = rim * b.vary(0.1, 0.5);
    for i in 0..spokes {
        b.at([0.0; 3], TAU * i as f32 / spokes as f32, |b| {
            b.block("rib", [inner, -rim * 0.02, h - 0.008], [rim * 0.88, rim * 0.02, h - 0.0005], iron);
        });
    }
    for side in [-1.0, 1.0] {
        b.block(
            "key",
            [-0.012, side * rim * 0.75 - 0.02, h - 0.006],
            [0.012, side * rim * 0.75 + 0.02, h],
            BLACK_METAL,
        );
    }
    b.top("top", [0.0, 0.0, h], (rim * 0.6, rim * 0.6));
}

/// A kerb: stones in a row, square, bevelled or rounded, sometimes with a gully.
pub(super) fn curb(b: &mut Build<'_>) {
    at_least(b, [0.06, 0.3, 0.05]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let stone = b.choose(&[CONCRETE, GRANITE, GRAVEL, SANDSTONE]);
    let bevel = (x * 0.5).min(h * 0.4) * b.vary(0.2, 1.0);
    let mut section = vec![(-x, 0.0), (x, 0.0)];
    match b.rng.below(3) {
        0 => section.extend([(x, h)]),
        1 => section.extend([(x, h - bevel), (x - bevel, h)]),
        _ => section.extend([(x, h - bevel), (x - bevel * 0.3, h - bevel * 0.3), (x - bevel, h)]),
    }
    section.push((-x, h));
    let stones = ((2.0 * y / b.vary(0.5, 1.2)) as usize).clamp(1, 20);
    let half = y / stones as f32;
    let painted = b.rng.chance(0.25);
    for (i, cy) in spaced(stones, -y + half, y - half).enumerate() {
        let gap = if i + 1 < stones { 0.004 } else { 0.0 };
        let mat = if painted && i % 2 == 0 { b.choose(&[YELLOW, RED]) } else { stone };
        b.prism("stone", Axis::Y, [0.0, cy - half, 0.0], &section, 2.0 * half - gap, mat);
    }
    b.top("top", [-bevel / 2.0, 0.0, h], (x - bevel / 2.0 - 0.005, y - 0.01));
}

/// A dog's chain in a heap: links, a snap hook and a leather loop.
pub(super) fn dog_chain(b: &mut Build<'_>) {
    at_least(b, [0.025, 0.05, 0.015]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let steel = b.choose(&[STEEL, GALVANISED, IRON]);
    let wire = (h * 0.09).min(0.004);
    let link = (x * 0.34).min(y * 0.22);
    // The chain lies in an oval between the upright hand loop and the hook.
    let loop_r = (h * 0.5).min(y * 0.35);
    let (low, high) = (-y + loop_r, y * 0.4);
    let (a, c, middle) = (x - link - wire, (high - low) / 2.0, f32::midpoint(low, high));
    let around = evenly_spaced_ellipse((a, c), 1.85 * link);
    let turns = if around.len() > 7 { 1 } else { 2 };
    let section = [(0.0, wire), (wire, 0.0), (0.0, -wire), (-wire, 0.0), (0.0, wire)];
    let ring: Vec<(f32, f32)> = section.iter().map(|p| (link + p.0, wire + p.1)).collect();
    for turn in 0..turns {
        for (dx, dy) in &around {
            b.lathe("link", [*dx, middle + dy, 1.8 * wire * turn as f32], &ring, steel);
        }
    }
    let (tip, z) = (y - 2.0 * wire, wire * 2.0);
    let hook = [[0.0, high, z], [x * 0.3, tip * 0.75, z], [0.0, tip, z], [-x * 0.3, tip * 0.75, z]];
    b.pipe("hook", &hook, wire, BRASS);
    let (inner, wide) = (loop_r * 0.9, x * 0.25);
    let strap = [(loop_r, -wide), (loop_r, wide), (inner, wide), (inner, -wide), (loop_r, -wide)];
    let centre = [0.0, -y + loop_r, loop_r];
    b.lathe_along("loop", centre, [1.0, centre[1], centre[2]], &strap, BROWN_LEATHER);
}
