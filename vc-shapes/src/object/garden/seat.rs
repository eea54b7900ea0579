//! Garden chairs, loungers and sofas.

use vc_graph::portable::Portable;

use crate::material::*;
use crate::solid::{Axis, Build, P, at_least, plate, spaced};

pub(super) const WOODS: &[MaterialId] = &[TEAK, OAK, PINE, GREY_OAK, WALNUT, WHITE];

pub(super) const METALS: &[MaterialId] = &[WHITE_METAL, IRON, ANTHRACITE, GREEN_METAL, GALVANISED];

pub(super) const CLOTHS: &[MaterialId] =
    &[NAVY_FABRIC, BEIGE_FABRIC, GREEN_FABRIC, GREY_FABRIC, RED_FABRIC, MUSTARD_FABRIC, WHITE_COTTON, TEAL_FABRIC];

/// A garden chair: wooden slats, a metal frame with cloth, wicker or plastic.
pub(super) fn chair(b: &mut Build<'_>) {
    at_least(b, [0.25, 0.25, 0.4]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let design = b.rng.below(4);
    let mat = match design {
        0 => b.one_of(WOODS),
        1 => b.one_of(METALS),
        2 => b.choose(&[WICKER, BROWN_PLASTIC, ANTHRACITE, WICKER]),
        _ => b.choose(&[WHITE_PLASTIC, GREEN_PLASTIC, GREY_PLASTIC, BROWN_PLASTIC]),
    };
    let seat = (h * 0.48).min(0.44);
    let leg = if design == 1 { 0.022 } else { 0.04 };
    let arms = b.rng.chance(0.75);
    let lean = x * b.vary(0.2, 0.4);
    let front = x - 0.01;
    let back = -x + lean;
    let side = y - if arms { leg + 0.005 } else { 0.0 };
    let arm = (seat + 0.2).min(h * 0.8);
    for s in [-1.0, 1.0] {
        let (y0, y1) = (s * y, s * (y - leg));
        let top = if arms { arm - 0.02 } else { seat - 0.01 };
        b.block("leg", [front - leg, y0.min(y1), 0.0], [front, y0.max(y1), top], mat);
        let outline = [
            (back - 0.02, 0.0),
            (back - 0.02 + leg, 0.0),
            (back + leg, seat),
            (-x + leg * 0.8, h - 0.01),
            (-x, h - 0.01),
            (back, seat),
        ];
        b.prism("leg", Axis::Y, [0.0, y0.min(y1), 0.0], &outline, leg, mat);
        if arms {
            let z = arm;
            let share = (z - seat) / (h - seat);
            let from = back + (-x - back) * share;
            b.rounded_block(
                "arm",
                [from + leg * 0.3, (s * (y - leg * 1.25)).min(y0), z - 0.025],
                [x, (s * (y - leg * 1.25)).max(y0), z],
                0.008,
                mat,
            );
        }
        let (outer, within) = (s * (y - 0.004), s * (y - leg - 0.01));
        b.block("rail", [back, outer.min(within), seat - 0.06], [front - leg, outer.max(within), seat - 0.016], mat);
    }
    let inner = y - leg;
    match design {
        0 => {
            for cx in spaced(6, back + 0.035, front - 0.03) {
                b.block("slat", [cx - 0.026, -side, seat - 0.018], [cx + 0.026, side, seat], mat);
            }
            b.block("apron", [front - leg + 0.005, -inner, seat - 0.07], [front - 0.008, inner, seat - 0.017], mat);
        }
        1 => {
            let cloth = b.one_of(CLOTHS);
            b.block("seat", [back + 0.02, -inner - 0.004, seat - 0.012], [front - 0.005, inner + 0.004, seat], cloth);
            b.rod(
                "rail",
                [front - leg / 2.0, -inner, seat - 0.03],
                [front - leg / 2.0, inner, seat - 0.03],
                leg / 2.0,
                mat,
            );
        }
        _ => b.rounded_block(
            "seat",
            [back - 0.01, -inner - 0.003, seat - 0.035],
            [front - 0.002, inner + 0.003, seat],
            0.012,
            mat,
        ),
    }
    b.rod("rail", [back + leg * 0.5, -inner, seat - 0.04], [back + leg * 0.5, inner, seat - 0.04], leg * 0.35, mat);
    let at = |share: f32| [back + (-x - back) * share + leg * 0.45, seat + (h - 0.01 - seat) * share];
    back_rest(b, &at, inner, (design, h), mat);
    b.top(
        "seat",
        [f32::midpoint(back + leg, front) + 0.01, 0.0, seat],
        ((front - back - leg) / 2.0 - 0.03, inner - 0.03),
    );
}

/// The filling of a chair's back between its two uprights; `at` gives a position for each share of
/// the height.
fn back_rest(b: &mut Build<'_>, at: &dyn Fn(f32) -> [f32; 2], inner: f32, (design, h): (usize, f32), mat: MaterialId) {
    let board = |b: &mut Build<'_>, name: &str, (s0, s1): (f32, f32), (y0, y1): (f32, f32), t: f32, mat: MaterialId| {
        let ([x0, z0], [x1, z1]) = (at(s0), at(s1));
        let quad = [[x0 + t / 2.0, y0, z0], [x0 + t / 2.0, y1, z0], [x1 + t / 2.0, y1, z1], [x1 + t / 2.0, y0, z1]];
        plate(b, name, quad, t, mat);
    };
    let wide = inner + 0.003;
    match design {
        0 => {
            board(b, "rail", (0.88, 0.985), (-wide, wide), 0.022, mat);
            board(b, "rail", (0.1, 0.18), (-wide, wide), 0.022, mat);
            let count = b.rng.count(4, 8);
            let half = inner / count as f32 * 0.6;
            for cy in spaced(count, -inner + half + 0.01, inner - half - 0.01) {
                board(b, "slat", (0.15, 0.92), (cy - half, cy + half), 0.012, mat);
            }
        }
        1 => {
            let cloth = b.one_of(CLOTHS);
            board(b, "back", (0.12, 0.95), (-wide, wide), 0.01, cloth);
            board(b, "rail", (0.955, 0.985), (-wide, wide), 0.02, mat);
        }
        2 => board(b, "back", (0.02, 0.98), (-wide, wide), (h * 0.03).max(0.012), mat),
        _ => {
            board(b, "rail", (0.75, 0.985), (-wide, wide), 0.02, mat);
            for i in 0..4 {
                let s = 0.1 + 0.16 * i as f32;
                board(b, "bar", (s, s + 0.09), (-wide, wide), 0.016, mat);
            }
        }
    }
}

/// A deck chair: two crossed frames and a sling of cloth.
pub(super) fn deck_chair(b: &mut Build<'_>) {
    at_least(b, [0.4, 0.27, 0.37]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (wood, cloth) = (b.choose(&[BEECH, TEAK, PINE, WHITE]), b.one_of(CLOTHS));
    let stripe = b.choose(&[WHITE_COTTON, BEIGE_FABRIC, cloth]);
    let w = 0.015;
    let (rear, front) = ([-x + 0.03, h - 0.02], [x - 0.03, h * b.vary(0.36, 0.44)]);
    let (toe, heel) = ([x * 0.72, 0.018], [-x * 0.7, 0.018]);
    let pivot = crossing([rear, toe], [heel, front]);
    let beam = |b: &mut Build<'_>, from: [f32; 2], to: [f32; 2], cy: f32| {
        let (dx, dz) = (to[0] - from[0], to[1] - from[1]);
        let long = dx.hypotenuse(dz).max(1e-3);
        let (nx, nz) = (-dz / long * 0.017, dx / long * 0.017);
        let outline = [
            (from[0] + nx, from[1] + nz),
            (from[0] - nx, from[1] - nz),
            (to[0] - nx, to[1] - nz),
            (to[0] + nx, to[1] + nz),
        ];
        b.prism("beam", Axis::Y, [0.0, cy - w, 0.0], &outline, 2.0 * w, wood);
    };
    for s in [-1.0, 1.0] {
        beam(b, rear, toe, s * (y - w));
        beam(b, heel, front, s * (y - 3.2 * w));
        beam(
            b,
            [rear[0] + (toe[0] - rear[0]) * 0.35, rear[1] + (toe[1] - rear[1]) * 0.35],
            [heel[0], heel[1]],
            s * (y - 5.2 * w),
        );
        b.rod("bolt", [pivot[0], s * (y - 4.2 * w), pivot[1]], [pivot[0], s * (y - 0.002), pivot[1]], 0.008, STEEL);
    }
    for [rx, rz] in [rear, front, toe, heel] {
        b.rod("rail", [rx, -y + 0.004, rz], [rx, y - 0.004, rz], 0.014, wood);
    }
    let inner = y - 6.6 * w;
    let sag = |t: f32| {
        let dip = h * 0.3 * (1.0 - (2.0 * t - 1.0).raised(2));
        [rear[0] + (front[0] - rear[0]) * t, rear[1] + (front[1] - rear[1]) * t - dip]
    };
    let strips = 5;
    for (i, cy) in spaced(strips, -inner * 0.8, inner * 0.8).enumerate() {
        let half = inner * 0.2 - 0.0005;
        let steps = 7;
        let upper: Vec<(f32, f32)> =
            (0..=steps).map(|k| sag(k as f32 / steps as f32)).map(|p| (p[0], p[1] + 0.004)).collect();
        let lower: Vec<(f32, f32)> = upper.iter().rev().map(|p| (p.0, p.1 - 0.006)).collect();
        let outline: Vec<(f32, f32)> = upper.into_iter().chain(lower).collect();
        b.prism("sling", Axis::Y, [0.0, cy - half, 0.0], &outline, 2.0 * half, if i % 2 == 0 { cloth } else { stripe });
    }
}

/// The intersection of two lines in a plane, each given by two points.
fn crossing([a, c]: [[f32; 2]; 2], [p, q]: [[f32; 2]; 2]) -> [f32; 2] {
    let (u, v) = ([c[0] - a[0], c[1] - a[1]], [q[0] - p[0], q[1] - p[1]]);
    let across = u[0] * v[1] - u[1] * v[0];
    let share = ((p[0] - a[0]) * v[1] - (p[1] - a[1]) * v[0]) / if across.abs() < 1e-6 { 1.0 } else { across };
    [a[0] + u[0] * share, a[1] + u[1] * share]
}

/// A sun lounger: a slatted or cushioned bed whose head end is raised.
pub(super) fn lounger(b: &mut Build<'_>) {
    at_least(b, [0.9, 0.28, 0.14]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (frame, cloth) = (b.choose(&[TEAK, PINE, WHITE_PLASTIC, ANTHRACITE, WICKER, ALUMINIUM]), b.one_of(CLOTHS));
    let deck = h * b.vary(0.6, 0.72);
    let knee = -x * b.vary(0.25, 0.4);
    let (rise, t) = (h - deck, 0.03_f32.min(h * 0.12));
    let cushion = if b.rng.chance(0.6) { (h * 0.14).min(0.06) } else { 0.0 };
    let level = deck - cushion;
    for s in [-1.0, 1.0] {
        b.block(
            "rail",
            [-x + 0.02, s * (y - 0.02) - 0.02, level - 2.0 * t],
            [x, s * (y - 0.02) + 0.02, level - t * 0.3],
            frame,
        );
        for cx in [-x * 0.8, x * 0.75] {
            b.block(
                "leg",
                [cx - 0.025, s * (y - 0.025) - 0.022, 0.0],
                [cx + 0.025, s * (y - 0.025) + 0.022, level - 1.5 * t],
                frame,
            );
        }
    }
    let slats = b.rng.count(8, 14);
    let pitch = (x - knee) / slats as f32;
    for cx in spaced(slats, knee + pitch / 2.0, x - pitch / 2.0) {
        b.block("slat", [cx - pitch * 0.42, -y + 0.004, level - t], [cx + pitch * 0.42, y - 0.004, level], frame);
    }
    // The head section, hinged where the bed bends; it folds flat.
    let angle = (rise.max(0.03) / (x + knee).max(0.05)).arc_tangent();
    b.hinge([knee, 0.0, level], [0.0, -1.0, 0.0], angle, |b| {
        let top = h - if cushion > 0.0 { cushion * 1.1 } else { 0.0 };
        let at = |share: f32| [knee + (-x + 0.01 - knee) * share, level + (top - level) * share];
        let ([x0, z0], [x1, z1]) = (at(0.02), at(1.0));
        b.prism(
            "head",
            Axis::Y,
            [0.0, -y + 0.043, 0.0],
            &[(x0, z0), (x1, z1), (x1, z1 - t), (x0, z0 - t * 0.8)],
            2.0 * y - 0.086,
            frame,
        );
        if cushion > 0.0 {
            b.prism(
                "cushion",
                Axis::Y,
                [0.0, -y + 0.03, 0.0],
                &[
                    (x0 - 0.005, z0 + 0.001),
                    (x1 + 0.01, z1 + 0.001),
                    (x1 + 0.02, z1 + cushion),
                    (x0 - 0.005, z0 + cushion),
                ],
                2.0 * y - 0.06,
                cloth,
            );
        }
    });
    if cushion > 0.0 {
        b.rounded_block("cushion", [knee + 0.005, -y + 0.02, level], [x - 0.02, y - 0.02, deck], 0.02, cloth);
    }
    b.top("seat", [f32::midpoint(knee, x), 0.0, deck], ((x - knee) / 2.0 - 0.05, y - 0.06));
}

/// An adirondack chair: broad arms, a fan of boards leaning back.
pub(super) fn adirondack(b: &mut Build<'_>) {
    at_least(b, [0.4, 0.36, 0.45]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let mat = b.choose(&[TEAK, PINE, WHITE, RED, BLUE, GREEN, YELLOW, GREY_OAK]);
    let (front, rear) = (h * b.vary(0.36, 0.4), h * b.vary(0.24, 0.28));
    let (nose, knee) = (x - 0.07, -x * 0.25);
    let t = 0.02;
    let arm = h * b.vary(0.56, 0.6);
    let inner = y - 0.11_f32.min(y * 0.3);
    for s in [-1.0, 1.0] {
        let cy = s * inner;
        b.prism(
            "side",
            Axis::Y,
            [0.0, cy - 0.013, 0.0],
            &[
                (nose, front - 0.002),
                (nose, front - 0.09),
                (-x + 0.12, 0.0),
                (-x, 0.0),
                (-x, 0.06),
                (knee, rear - 0.002),
            ],
            0.026,
            mat,
        );
        b.block(
            "leg",
            [nose - 0.075, (cy + s * 0.012).min(cy + s * 0.038), 0.0],
            [nose + 0.02, (cy + s * 0.012).max(cy + s * 0.038), arm - t],
            mat,
        );
        let (from, to) = (s * (inner - 0.02), s * y);
        b.rounded_block("arm", [-x * 0.62, from.min(to), arm - t], [x, from.max(to), arm], 0.008, mat);
        b.block(
            "post",
            [-x * 0.6, (cy - 0.013).min(cy + 0.013), rear * 0.5],
            [-x * 0.6 + 0.06, cy + 0.013, arm - t + 0.001],
            mat,
        );
    }
    let slats = 6;
    let fall = (front - rear) / (nose - knee);
    let pitch = (nose - knee) / slats as f32;
    for cx in spaced(slats, knee + pitch / 2.0, nose - pitch / 2.0) {
        let z = |px: f32| front - (nose - px) * fall;
        let (x0, x1) = (cx - pitch * 0.46, cx + pitch * 0.46);
        b.prism(
            "slat",
            Axis::Y,
            [0.0, -inner - 0.013, 0.0],
            &[(x0, z(x0) - 0.004), (x1, z(x1) - 0.004), (x1, z(x1) + t), (x0, z(x0) + t)],
            2.0 * inner + 0.026,
            mat,
        );
    }
    b.block("apron", [nose - 0.002, -inner - 0.012, front - 0.1], [nose + 0.018, inner + 0.012, front - 0.005], mat);
    let boards = b.rng.below(2) * 2 + 5;
    let half = inner * 0.9 / boards as f32;
    for (i, cy) in spaced(boards, -inner + half * 1.2, inner - half * 1.2).enumerate() {
        let u = (2.0 * i as f32 / (boards - 1) as f32 - 1.0).abs();
        let top = h * (1.0 - 0.13 * u * u);
        let at = |z: f32| knee + 0.03 + (-x + 0.025 - knee - 0.03) * (z - rear) / (h - rear);
        let fan = cy * 0.08;
        let points = [
            [at(rear), cy - half, rear],
            [at(rear), cy + half, rear],
            [at(top), cy + fan - half * 1.05, top],
            [at(top), cy + fan + half * 1.05, top],
        ];
        b.hull("board", &points.iter().flat_map(|p| [*p, [p[0] - 0.018, p[1], p[2]]]).collect::<Vec<P>>(), mat);
    }
    let z = arm - t;
    let at = knee + 0.03 + (-x + 0.025 - knee - 0.03) * (z - rear) / (h - rear) - 0.018;
    b.block("brace", [at - 0.035, -inner - 0.03, z - 0.03], [at + 0.004, inner + 0.03, z + 0.001], mat);
    b.top(
        "seat",
        [f32::midpoint(knee, nose) + 0.1 * (nose - knee), 0.0, front + t - (front - rear) * 0.14],
        ((nose - knee) * 0.26, inner * 0.75),
    );
}

/// A garden sofa: a wicker, wooden or metal frame with cushions.
pub(super) fn sofa(b: &mut Build<'_>) {
    at_least(b, [0.34, 0.6, 0.32]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let wicker = b.rng.chance(0.5);
    let frame = if wicker {
        b.choose(&[WICKER, BROWN_PLASTIC, ANTHRACITE, WHITEWASHED])
    } else {
        b.choose(&[TEAK, OAK, ANTHRACITE, WHITE_METAL, GREY_OAK])
    };
    let cloth = b.choose(&[BEIGE_FABRIC, GREY_FABRIC, WHITE_COTTON, NAVY_FABRIC, GREEN_FABRIC, LINEN]);
    let seat = (h * 0.56).min(0.44);
    let pad = (seat * 0.3).min(0.14);
    let arm = seat + (h - seat) * b.vary(0.4, 0.7);
    let wide = b.vary(0.05, 0.13).min(y * 0.2);
    let deep = if wicker { 0.08 } else { 0.04 };
    let low = if wicker { 0.04 } else { seat - pad - 0.05 };
    let inner = y - wide;
    b.block("base", [-x + deep, -inner, low], [x - 0.01, inner, seat - pad], frame);
    b.block("back", [-x, -inner, low], [-x + deep, inner, h], frame);
    for s in [-1.0, 1.0] {
        let (from, to) = (s * inner, s * y);
        let (y0, y1) = (from.min(to), from.max(to));
        if wicker {
            b.block("arm", [-x, y0, 0.02], [x, y1, arm], frame);
            for cx in [-x + 0.05, x - 0.05] {
                b.block(
                    "foot",
                    [cx - 0.03, (y0 + y1) / 2.0 - 0.02, 0.0],
                    [cx + 0.03, (y0 + y1) / 2.0 + 0.02, 0.025],
                    BLACK_PLASTIC,
                );
            }
        } else {
            b.block("leg", [x - 0.06, y0, 0.0], [x, y1, arm - 0.03], frame);
            b.block("leg", [-x, y0, 0.0], [-x + 0.06, y1, arm - 0.03], frame);
            b.block("arm", [-x, y0, arm - 0.031], [x, y1, arm], frame);
            b.block(
                "rail",
                [-x + 0.06, (y0 + y1) / 2.0 - 0.012, seat - pad - 0.04],
                [x - 0.06, (y0 + y1) / 2.0 + 0.012, seat - pad],
                frame,
            );
        }
    }
    let seats = ((2.0 * inner / 0.62) as usize).clamp(1, 4);
    let half = inner / seats as f32;
    for cy in spaced(seats, -inner + half, inner - half) {
        b.rounded_block(
            "cushion",
            [-x + deep, cy - half + 0.004, seat - pad + 0.001],
            [x - 0.005, cy + half - 0.004, seat],
            0.04,
            cloth,
        );
        let lean = (x * 0.32).min(0.16);
        let points = [
            [-x + deep, seat + 0.002],
            [-x + deep + lean, seat + 0.002],
            [-x + deep + lean * 0.6, h - 0.01],
            [-x + deep, h - 0.01],
        ];
        let outline: Vec<(f32, f32)> = points.iter().map(|p| (p[0] + 0.002, p[1])).collect();
        b.prism("cushion", Axis::Y, [0.0, cy - half + 0.012, 0.0], &outline, 2.0 * half - 0.024, cloth);
    }
    let from = -x + deep + (x * 0.32).min(0.16) + 0.01;
    b.top("seat", [f32::midpoint(from, x - 0.02), 0.0, seat], ((x - 0.02 - from) / 2.0 - 0.01, inner - 0.03));
}
