//! Street lamps, hydrants, posts, meters, racks, shelters, booths and kerbs.

use std::f32::consts::{FRAC_PI_2, PI, TAU};

use vc_graph::portable::Portable;

use crate::material::*;
use crate::object::build::{Axis, Build, P};
use crate::object::park::shape::{grown, polar, polygon, spaced};

use super::sign::poster;

/// A street lamp: an arm over the road, or a lantern, globe or disc on the post.
pub(super) fn street_lamp(b: &mut Build<'_>) {
    grown(b, [0.08, 0.08, 1.5]);
    let metal = b.one(&[ANTHRACITE, IRON, GREEN_METAL, GALVANISED, BLACK_METAL]);
    if b.size.x > 0.75 { arm_lamp(b, metal) } else { post_lamp(b, metal) }
}

/// A tapering mast on a foot, and how high it is.
fn mast(b: &mut Build<'_>, at: f32, radius: f32, top: f32, metal: Mat) {
    let foot = top * b.vary(0.1, 0.2);
    let profile = match b.rng.below(3) {
        0 => vec![(radius, 0.0), (radius, foot), (radius * 0.7, foot * 1.05), (radius * 0.45, top)],
        1 => vec![(radius, 0.0), (radius * 0.5, top)],
        _ => vec![
            (radius, 0.0),
            (radius, foot * 0.3),
            (radius * 0.75, foot * 0.4),
            (radius * 0.7, foot * 0.9),
            (radius * 0.9, foot * 0.95),
            (radius * 0.55, foot * 1.1),
            (radius * 0.5, top),
        ],
    };
    b.lathe("mast", [at, 0.0, 0.0], &profile, metal);
}

fn arm_lamp(b: &mut Build<'_>, metal: Mat) {
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let radius = (0.05 + h * 0.008).min(y);
    let base = -x + radius;
    let (arm, bulb) = (radius * 0.45, b.one(&[WARM_BULB, COOL_BULB]));
    let head = (x * b.vary(0.35, 0.55)).clamp(0.12, 0.4);
    let wide = y.min(head * 0.5);
    let tip = x - 2.0 * head;
    let curved = b.rng.chance(0.6);
    let bend = (2.0 * x * 0.5).min(h * 0.2);
    let top = if curved { h - bend } else { h - 0.12 };
    mast(b, base, radius, top, metal);
    let level = h - arm - 0.016;
    if curved {
        let steps = 4;
        let points: Vec<P> = (0..=steps)
            .map(|i| FRAC_PI_2 * i as f32 / steps as f32)
            .map(|a| [base + (tip - base) * (1.0 - a.cosine()), 0.0, top - 0.02 + (level - top + 0.02) * a.sine()])
            .collect();
        b.pipe("arm", &points, arm, metal);
    } else {
        b.pipe("arm", &[[base, 0.0, top - 0.08], [tip, 0.0, level]], arm, metal);
        b.rod(
            "brace",
            [base, 0.0, top - 0.5_f32.min(h * 0.1)],
            [base + (tip - base) * 0.5, 0.0, (top + level) / 2.0 - 0.03],
            arm * 0.6,
            metal,
        );
    }
    let lamp = [x - head, 0.0, level];
    match b.rng.below(3) {
        0 => {
            b.taper(
                "head",
                [lamp[0], 0.0, level - 0.05],
                (head, wide),
                (head * 0.7, wide * 0.6),
                0.05 + arm * 0.9,
                metal,
            );
            b.block(
                "lamp",
                [x - 1.8 * head, -wide * 0.7, level - 0.062],
                [x - 0.2 * head, wide * 0.7, level - 0.045],
                bulb,
            );
        }
        1 => {
            b.soft("head", [x - 2.0 * head, -wide, level - 0.035], [x, wide, level + arm], 0.015, metal);
            b.block(
                "lamp",
                [x - 1.7 * head, -wide * 0.75, level - 0.042],
                [x - 0.3 * head, wide * 0.75, level - 0.033],
                bulb,
            );
        }
        _ => {
            let r = head.min(wide * 1.5).min(y);
            b.lathe(
                "head",
                [x - r, 0.0, level - 0.1],
                &[(r, 0.0), (r * 0.7, 0.06), (r * 0.25, 0.1 + arm * 0.9)],
                metal,
            );
            b.lathe(
                "lamp",
                [x - r, 0.0, level - 0.1 - r * 0.4],
                &[(r * 0.1, 0.0), (r * 0.5, r * 0.1), (r * 0.7, r * 0.405)],
                bulb,
            );
            b.bar("arm", [tip, 0.0, level], [x - r, 0.0, level], arm, metal);
        }
    }
}

fn post_lamp(b: &mut Build<'_>, metal: Mat) {
    let (r, h) = (b.size.x.min(b.size.y) / 2.0, b.size.z);
    let bulb = b.one(&[WARM_BULB, COOL_BULB]);
    let foot = r.min(0.04 + h * 0.014);
    let design = b.rng.below(4);
    let tall = (r * b.vary(2.2, 3.0)).max(0.2).min(h * 0.2);
    let top = h - tall;
    mast(b, 0.0, foot, top + 0.01, metal);
    match design {
        0 => {
            // A four-sided lantern: widening panes under a roof.
            b.taper("base", [0.0, 0.0, top], (r * 0.3, r * 0.3), (r * 0.5, r * 0.5), tall * 0.1, metal);
            b.taper(
                "pane",
                [0.0, 0.0, top + tall * 0.1],
                (r * 0.45, r * 0.45),
                (r * 0.8, r * 0.8),
                tall * 0.52,
                FROSTED_GLASS,
            );
            for (sx, sy) in [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)] {
                let at = |share: f32, z: f32| [sx * r * share, sy * r * share, top + tall * z];
                b.rod("corner", at(0.46, 0.1), at(0.81, 0.62), 0.008, metal);
            }
            b.cylinder("lamp", [0.0, 0.0, top + tall * 0.11], r * 0.2, tall * 0.4, bulb);
            b.taper(
                "roof",
                [0.0, 0.0, top + tall * 0.62],
                (r * 0.98, r * 0.98),
                (r * 0.25, r * 0.25),
                tall * 0.25,
                metal,
            );
            b.cone("finial", [0.0, 0.0, top + tall * 0.86], r * 0.16, tall * 0.14, metal);
        }
        1 => {
            let globe = r.min(tall * 0.48);
            let cup = h - 1.8 * globe - top;
            let profile = [(globe * 0.35, 0.0), (globe * 0.6, cup), (globe * 0.2, cup)];
            b.lathe("cup", [0.0, 0.0, top], &profile, metal);
            b.ball("lamp", [0.0, 0.0, h - globe], globe, bulb);
        }
        2 => {
            b.cylinder("neck", [0.0, 0.0, top], r * 0.22, tall * 0.75, metal);
            b.cylinder("lamp", [0.0, 0.0, top + tall * 0.15], r * 0.55, tall * 0.55, bulb);
            b.lathe("disc", [0.0, 0.0, h - tall * 0.3], &[(r, 0.0), (r, tall * 0.06), (r * 0.4, tall * 0.3)], metal);
        }
        _ => {
            b.cylinder("lamp", [0.0, 0.0, top], r * 0.8, tall * 0.8, bulb);
            for i in 0..4 {
                let z = top + tall * (0.1 + 0.2 * i as f32);
                b.cylinder("fin", [0.0, 0.0, z], r * 0.97, tall * 0.03, metal);
            }
            b.lathe("cap", [0.0, 0.0, top + tall * 0.79], &[(r, 0.0), (r, tall * 0.1), (r * 0.5, tall * 0.21)], metal);
        }
    }
}

/// A fire hydrant: a capped pillar with outlets; its spindle turns.
pub(super) fn hydrant(b: &mut Build<'_>) {
    grown(b, [0.15, 0.15, 0.3]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let mat = b.one(&[RED_METAL, RED_METAL, YELLOW_METAL, BLUE_METAL, GREEN_METAL]);
    let cap = b.one(&[mat, SILVER_METAL, WHITE_METAL, YELLOW_METAL]);
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
fn outlet(b: &mut Build<'_>, way: P, z: f32, (from, to, r): (f32, f32, f32), (mat, cap): (Mat, Mat)) {
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

/// A traffic cone with bright bands on a square foot.
pub(super) fn cone(b: &mut Build<'_>) {
    grown(b, [0.1, 0.1, 0.12]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let foot = h * b.vary(0.04, 0.07);
    let base = b.one(&[ORANGE_PLASTIC, RUBBER, ORANGE_PLASTIC]);
    let bevel = x.min(y) * b.vary(0.1, 0.3);
    let corner: Vec<(f32, f32)> = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)]
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
    grown(b, [0.05, 0.05, 0.3]);
    let (r, h) = (b.size.x.min(b.size.y) / 2.0, b.size.z);
    let band = h * b.vary(0.7, 0.85);
    match b.rng.below(5) {
        0 => {
            let iron = b.one(&[IRON, ANTHRACITE, GREEN_METAL]);
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
            let steel = b.one(&[STEEL, GALVANISED, ANTHRACITE]);
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
            let wood = b.one(&[OAK, PINE, TEAK]);
            b.block("post", [-r, -r, 0.0], [r, r, h * 0.93], wood);
            b.taper("cap", [0.0, 0.0, h * 0.93], (r, r), (r * 0.5, r * 0.5), h * 0.07, wood);
            b.block("reflector", [r * 0.9, -r * 0.5, band * 0.9], [r + 0.001, r * 0.5, band], RED_PLASTIC);
        }
        _ => {
            let (main, second) = (b.one(&[WHITE, YELLOW, RED]), b.one(&[RED, BLACK]));
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
    grown(b, [0.1, 0.1, 0.6]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let mat = b.one(&[ANTHRACITE, SILVER_METAL, BLUE_METAL, GREEN_METAL, GALVANISED]);
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
        b.soft("case", [-x * 0.9, -y * 0.9, 0.025], [x * 0.9, y * 0.9, h * 0.9], 0.03, mat);
        b.taper("roof", [0.0, 0.0, h * 0.895], (x, y), (x * 0.4, y * 0.6), h * 0.05, b.style.metal);
        b.block("solar", [-x * 0.35, -y * 0.55, h * 0.94], [x * 0.35, y * 0.55, h], BLACK_GLASS);
        face(b, x * 0.9, [0.0, h * 0.62, h * 0.22, y * 0.65], x * 0.1);
        b.block("sign", [x * 0.89, -y * 0.3, h * 0.2], [x * 0.91, y * 0.3, h * 0.42], BLUE_PLASTIC);
    }
}

/// Screen, keys and slot on a front at `x`: middle, low end, height and half width.
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

/// A charging station: a pillar, or a box for the wall, with cable and plug.
pub(super) fn charging_station(b: &mut Build<'_>) {
    grown(b, [0.08, 0.1, 0.15]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let mat = b.one(&[WHITE_METAL, ANTHRACITE, SILVER_METAL, BLACK_METAL, GREEN_METAL]);
    let front = -x + 2.0 * x * b.vary(0.55, 0.7);
    let low = if h > 0.8 { 0.0 } else { h * 0.12 };
    let (deep, wide) = (x - front, y * 0.8);
    if low == 0.0 {
        b.block("foot", [-x, -y, 0.0], [front + 0.01, y, 0.04], CONCRETE);
    }
    b.soft("case", [-x, -wide, low], [front, wide, h], 0.02_f32.min(x * 0.3), mat);
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

/// A bus shelter: glass walls, a roof, a bench, a poster and the stop's sign.
pub(super) fn bus_stop(b: &mut Build<'_>) {
    grown(b, [0.6, 1.25, 1.15]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let metal = b.one(&[ANTHRACITE, GALVANISED, GREEN_METAL, SILVER_METAL]);
    let (roof, post) = (b.vary(0.06, 0.14), 0.035);
    let under = h - roof;
    if b.rng.chance(0.5) {
        b.block("roof", [-x, -y, under], [x, y, h], metal);
    } else {
        let arc: Vec<(f32, f32)> = (0..=8)
            .map(|i| PI * i as f32 / 8.0)
            .map(|a| (x * a.cosine(), roof * (0.3 + 0.7 * a.sine())))
            .chain([(-x, 0.0), (x, 0.0)])
            .collect();
        b.prism("roof", Axis::Y, [0.0, -y, under], &arc, 2.0 * y, metal);
    }
    let (back, depth) = (-x + 0.12, x * b.vary(0.1, 0.6));
    let bays = ((2.0 * y / 1.3) as usize).clamp(2, 4);
    for cy in spaced(bays + 1, -y + 0.1, y - 0.1) {
        b.block("post", [back - post, cy - post, 0.0], [back + post, cy + post, under], metal);
    }
    let step = (2.0 * y - 0.2) / bays as f32;
    for cy in spaced(bays, -y + 0.1 + step / 2.0, y - 0.1 - step / 2.0) {
        b.block(
            "glass",
            [back - 0.006, cy - step / 2.0 + post, 0.15],
            [back + 0.006, cy + step / 2.0 - post, under - 0.1],
            GLASS,
        );
    }
    let poster_side = if b.rng.chance(0.5) { 1.0 } else { -1.0 };
    for side in [-1.0, 1.0] {
        let cy = side * (y - 0.1);
        b.block("post", [depth - post, cy - post, 0.0], [depth + post, cy + post, under], metal);
        let thick = if side == poster_side { 0.05 } else { 0.006 };
        let mat = if side == poster_side { metal } else { GLASS };
        b.block("side", [back + post, cy - thick, 0.15], [depth - post, cy + thick, under - 0.15], mat);
    }
    let wide = (depth - back) / 2.0 - 0.15;
    b.at([(back + depth) / 2.0, poster_side * (y - 0.15), under * 0.5], -poster_side * FRAC_PI_2, |b| {
        poster(b, [0.0; 3], (wide.max(0.1), under * 0.38), 0.02);
    });
    let (seat, reach) = (0.45, y * b.vary(0.35, 0.6));
    let wood = b.one(&[b.style.wood, STEEL, GALVANISED, TEAK]);
    b.soft("seat", [back + post - 0.004, -reach, seat - 0.04], [back + 0.45_f32.min(x * 0.7), reach, seat], 0.01, wood);
    for cy in [-reach * 0.8, reach * 0.8] {
        b.block(
            "leg",
            [back + 0.2_f32.min(x * 0.4), cy - 0.03, 0.0],
            [back + 0.27_f32.min(x * 0.5), cy + 0.03, seat - 0.035],
            metal,
        );
    }
    let room = under - seat - 0.02;
    b.ledge("seat", [back + 0.04 + 0.225_f32.min(x * 0.35), 0.0, seat], (0.15_f32.min(x * 0.2), reach * 0.95), room);
    let cy = -poster_side * (y - 0.04);
    b.cylinder("pole", [x - 0.06, cy, 0.0], 0.025, under + 0.01, GALVANISED);
    b.prism(
        "sign",
        Axis::X,
        [x - 0.045, cy - cy.signum() * 0.16, under - 0.3],
        &polygon(20, 0.16, 0.0),
        0.01,
        b.style.metal,
    );
    b.prism("sign", Axis::X, [x - 0.038, cy - cy.signum() * 0.16, under - 0.3], &polygon(20, 0.13, 0.0), 0.005, YELLOW);
    b.block(
        "timetable",
        [x - 0.036, cy - 0.12_f32.min(0.03), 1.2_f32.min(under * 0.5)],
        [x - 0.03, cy + 0.03, 1.6_f32.min(under * 0.7)],
        WHITE_PAPER,
    );
}

/// A rack for bicycles: hoops, or slots for front wheels.
pub(super) fn bicycle_rack(b: &mut Build<'_>) {
    grown(b, [0.17, 0.4, 0.12]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let metal = b.one(&[GALVANISED, STEEL, ANTHRACITE, GREEN_METAL, IRON]);
    let r = (x * 0.08).clamp(0.008, 0.025);
    let count = ((2.0 * y / b.vary(0.45, 0.75)) as usize).clamp(2, 6);
    let hoops = h > 0.5 || b.rng.chance(0.4);
    for side in [-1.0, 1.0] {
        b.block("rail", [side * (x - r) - r, -y, 0.0], [side * (x - r) + r, y, 2.0 * r * 0.9], metal);
    }
    let gap = (2.0 * y - 2.0 * r) / (count - 1) as f32;
    let slim = if hoops { 0.0 } else { (gap * 0.12).min(0.03) };
    let round = b.rng.chance(0.5);
    for cy in spaced(count, -y + r + slim, y - r - slim) {
        let offsets: &[f32] = if hoops { &[0.0] } else { &[-1.0, 1.0] };
        for side in offsets {
            let cy = cy + side * slim;
            let points: Vec<P> = if round {
                let arc = (0..=6).map(|i| PI * i as f32 / 6.0);
                arc.map(|a| [(x - 2.0 * r) * a.cosine(), cy, r + (h - 2.5 * r) * a.sine()]).collect()
            } else {
                let (e, t) = (x - 1.2 * r, h - 1.5 * r);
                let cut = (x * 0.35).min(h * 0.35);
                vec![[e, cy, r], [e, cy, t - cut], [e - cut, cy, t], [-e + cut, cy, t], [-e, cy, t - cut], [-e, cy, r]]
            };
            b.pipe("hoop", &points, r, metal);
        }
    }
    b.block("plate", [-x + 2.0 * r, -y + 0.02, 0.0], [x - 2.0 * r, y - 0.02, 0.006], metal);
    for (i, cy) in spaced(count - 1, -y + r + gap / 2.0, y - r - gap / 2.0).enumerate() {
        let half = gap / 2.0 - r - 2.0 * slim - 0.012;
        b.inside(&format!("rack_{}", i + 1), [0.0, cy, 0.006], (x - 2.0 * r - 0.01, half.max(0.02)), h);
    }
}

/// A phone booth: a kiosk of small panes with a crowned roof, or a plain glass one.
pub(super) fn phone_booth(b: &mut Build<'_>) {
    grown(b, [0.42, 0.42, 1.1]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let classic = b.rng.chance(0.6);
    let mat = b.one(if classic {
        &[RED_METAL, RED_METAL, GREEN_METAL, BLACK_METAL]
    } else {
        &[SILVER_METAL, BLUE_METAL, ANTHRACITE, YELLOW_METAL]
    });
    let (roof, floor, w) = (h * b.vary(0.1, 0.15), 0.06, 0.035);
    let top = h - roof;
    b.block("floor", [-x, -y, 0.0], [x, y, floor], CONCRETE);
    for (sx, sy) in [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)] {
        let (cx, cy) = (sx * (x - w - 0.012), sy * (y - w - 0.012));
        b.block("post", [cx - w, cy - w, floor], [cx + w, cy + w, top], mat);
    }
    let rows = if classic { b.rng.count(5, 8) } else { b.rng.count(0, 2) };
    let edge = y - 0.012 - 2.0 * w;
    let pane = |b: &mut Build<'_>, half: f32, low: f32| {
        b.block("glass", [-0.004, -half, low], [0.004, half, top - 0.02], GLASS);
        b.block("rail", [-0.018, -half, floor], [0.018, half, low], mat);
        b.block("rail", [-0.018, -half, top - 0.07], [0.018, half, top - 0.002], mat);
        for z in spaced(rows + 2, low, top - 0.07).skip(1).take(rows) {
            b.block("bar", [-0.011, -half, z - 0.01], [0.011, half, z + 0.01], mat);
        }
        if classic {
            for cy in [-half * 0.6, half * 0.6] {
                b.block("bar", [-0.009, cy - 0.009, low], [0.009, cy + 0.009, top - 0.05], mat);
            }
        }
    };
    let low = floor + (top - floor) * b.vary(0.06, 0.3);
    for side in [-1.0, 1.0] {
        b.at([0.0, side * (y - 0.012 - w), 0.0], FRAC_PI_2, |b| pane(b, x - 0.012 - 2.0 * w, low));
    }
    let solid = -x + 0.012 + w;
    b.block("back", [solid - 0.015, -edge, floor], [solid + 0.015, edge, top - 0.002], mat);
    let front = x - 0.012 - w;
    b.hinge([front + 0.02, edge, 0.0], [0.0, 0.0, 1.0], FRAC_PI_2, |b| {
        b.at([front, 0.0, 0.0], 0.0, |b| pane(b, edge - 0.004, low));
        b.rod("handle", [front + 0.033, -edge * 0.8, h * 0.4], [front + 0.033, -edge * 0.8, h * 0.5], 0.01, STEEL);
        b.block("plate", [front - 0.003, -edge * 0.85, h * 0.44], [front + 0.036, -edge * 0.75, h * 0.46], STEEL);
    });
    b.block("lintel", [-x, -y, top - 0.003], [x - 0.006, y, top + roof * 0.45], mat);
    b.block("sign", [x - 0.01, -edge, top + roof * 0.08], [x, edge, top + roof * 0.38], WHITE_PLASTIC);
    if classic {
        b.taper("roof", [0.0, 0.0, top + roof * 0.44], (x * 0.95, y * 0.95), (x * 0.6, y * 0.6), roof * 0.55, mat);
    } else {
        b.block("roof", [-x * 0.95, -y * 0.95, top + roof * 0.44], [x * 0.95, y * 0.95, h], mat);
    }
    let (face, z) = (solid + 0.014, h * 0.52);
    b.soft("phone", [face, -0.12, z], [face + 0.1, 0.12, z + 0.32], 0.015, BLACK_PLASTIC);
    b.bar("handset", [face + 0.12, -0.16, z + 0.1], [face + 0.12, -0.16, z + 0.26], 0.025, BLACK_PLASTIC);
    b.block("cradle", [face + 0.05, -0.17, z + 0.16], [face + 0.12, -0.11, z + 0.2], BLACK_PLASTIC);
    let half = ((front - face - 0.2) / 2.0, edge - 0.03);
    b.inside("compartment", [face + 0.16 + half.0, 0.0, floor], half, top - floor - 0.02);
}

/// A manhole cover: an iron disc with a pattern, or a grate, in its frame.
pub(super) fn manhole_cover(b: &mut Build<'_>) {
    grown(b, [0.25, 0.25, 0.02]);
    let (r, h) = (b.size.x.min(b.size.y) / 2.0, b.size.z);
    let rim = r * b.vary(0.82, 0.9);
    let iron = b.one(&[IRON, IRON, RUST, GALVANISED]);
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

/// A kerb: stones in a row, square, bevelled or rounded, perhaps with a gully.
pub(super) fn curb(b: &mut Build<'_>) {
    grown(b, [0.06, 0.3, 0.05]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let stone = b.one(&[CONCRETE, GRANITE, GRAVEL, SANDSTONE]);
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
        let mat = if painted && i % 2 == 0 { b.one(&[YELLOW, RED]) } else { stone };
        b.prism("stone", Axis::Y, [0.0, cy - half, 0.0], &section, 2.0 * half - gap, mat);
    }
    b.top("top", [-bevel / 2.0, 0.0, h], (x - bevel / 2.0 - 0.005, y - 0.01));
}

/// A dog's chain in a heap: links, a snap hook and a leather loop.
pub(super) fn dog_chain(b: &mut Build<'_>) {
    grown(b, [0.025, 0.05, 0.015]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let steel = b.one(&[STEEL, GALVANISED, IRON]);
    let wire = (h * 0.09).min(0.004);
    let link = (x * 0.34).min(y * 0.22);
    // The chain lies in an oval between the loop for the hand, which stands, and the hook.
    let loop_r = (h * 0.5).min(y * 0.35);
    let (low, high) = (-y + loop_r, y * 0.4);
    let (a, c, middle) = (x - link - wire, (high - low) / 2.0, f32::midpoint(low, high));
    let around = oval(a, c, 1.85 * link);
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

/// Points around an ellipse, as evenly as whole steps of about `step` allow.
fn oval(a: f32, c: f32, step: f32) -> Vec<(f32, f32)> {
    const FINE: usize = 96;
    let at = |i: usize| {
        let (x, y) = polar(TAU * i as f32 / FINE as f32, 1.0);
        (x * a, y * c)
    };
    let mut walked = vec![0.0_f32];
    for i in 0..FINE {
        let ((x0, y0), (x1, y1)) = (at(i), at(i + 1));
        walked.push(walked[i] + (x1 - x0).hypotenuse(y1 - y0));
    }
    let count = (walked[FINE] / step).ceil().clamp(3.0, 24.0) as usize;
    let place = |k: usize| walked.partition_point(|w| *w < walked[FINE] * k as f32 / count as f32);
    (0..count).map(|k| at(place(k))).collect()
}
