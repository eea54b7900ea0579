//! Table, desk and floor lamps.

use super::{bulb, shade, shade_at, shade_mat, stand_mat};
use crate::material::*;
use crate::solid::{Build, P, fit, half_dims};

/// A base and a body under a shade: turned, a block, a ball, a tripod; or a mushroom lamp.
pub(super) fn table_lamp(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let r = x.min(y);
    if b.rng.chance(0.15) {
        return mushroom(b, r, h);
    }
    let (tall, design) = (h * b.vary(0.38, 0.5), b.choose(&[0, 1, 2, 2, 3]));
    let neck = h - tall;
    let body =
        b.choose(&[b.style.wood, b.style.crockery, STONEWARE, BLUE_GLAZE, GREEN_GLAZE, BRASS, MARBLE, BLACK_METAL]);
    let wide = r * b.vary(0.45, 0.62);
    match b.rng.below(5) {
        0 => {
            let profile = [
                (0.62, 0.0),
                (0.7, 0.05),
                (0.3, 0.12),
                (0.42, 0.3),
                (1.0, 0.55),
                (0.85, 0.78),
                (0.3, 0.95),
                (0.2, 1.0),
            ];
            let points = profile.map(|(a, z)| (a * wide, z * neck));
            b.lathe("body", [0.0; 3], &points, body);
        }
        1 => {
            let half = (wide * 0.8, wide * 0.8);
            let top = (half.0 * b.vary(0.5, 1.0), half.1 * 0.7);
            b.taper("body", [0.0; 3], half, top, neck * 0.92, body);
            b.cylinder("neck", [0.0, 0.0, neck * 0.9], wide * 0.2, neck * 0.12, BRASS);
        }
        2 => {
            let foot = neck * 0.06;
            b.cylinder("foot", [0.0; 3], wide, foot, body);
            let metal = stand_mat(b);
            b.cylinder("stem", [0.0, 0.0, foot], wide * 0.13, neck - foot, metal);
        }
        3 => {
            let ball = wide.min(neck * 0.3);
            b.cylinder("foot", [0.0; 3], ball * 0.7, neck * 0.06, BRASS);
            for i in 0..((neck / (ball * 1.9)).clamp(1.0, 3.0) as usize) {
                b.ball("body", [0.0, 0.0, ball * (1.0 + 1.8 * i as f32) + neck * 0.03], ball, body);
            }
            b.cylinder("stem", [0.0, 0.0, neck * 0.05], ball * 0.2, neck * 0.95, BRASS);
        }
        _ => tripod(b, wide * 1.3, neck, body),
    }
    topped(b, design, (r, tall), neck, h);
}

/// A shade with its bulb on a stand that ends at `neck`.
fn topped(b: &mut Build<'_>, design: usize, (r, tall): (f32, f32), neck: f32, h: f32) {
    let cloth = shade_mat(b);
    let base = h - tall;
    shade(b, design, [0.0, 0.0, base], (r, tall), cloth);
    let lamp = (r * 0.2).min(tall * 0.16);
    bulb(b, [0.0, 0.0, base + tall * 0.42], lamp, false);
    b.cylinder(
        "socket",
        [0.0, 0.0, neck * 0.98],
        lamp * 0.45,
        base + tall * 0.42 - lamp * 1.2 - neck * 0.98,
        BLACK_PLASTIC,
    );
    // The shade rests on a cross of wire.
    let spread = shade_at(design, 0.36, r);
    let z = base + tall * 0.36;
    let wire = r * 0.012;
    b.rod("wire", [-spread, 0.0, z], [spread, 0.0, z], wire, BRASS);
    b.rod("wire", [0.0, -spread, z + wire], [0.0, spread, z + wire], wire, BRASS);
}

/// A glass dome on a thick stem.
fn mushroom(b: &mut Build<'_>, r: f32, h: f32) {
    let mat = b.choose(&[WHITE_METAL, MUSTARD, TERRACOTTA, BLACK_METAL, b.style.wood]);
    b.lathe("stem", [0.0; 3], &[(r * 0.6, 0.0), (r * 0.5, h * 0.05), (r * 0.26, h * 0.3), (r * 0.24, h * 0.66)], mat);
    b.lathe(
        "head",
        [0.0, 0.0, h * 0.62],
        &[(r, 0.0), (r * 0.95, h * 0.12), (r * 0.75, h * 0.26), (r * 0.4, h * 0.35), (r * 0.1, h * 0.38)],
        WARM_BULB,
    );
}

/// Three legs that meet under `top`.
fn tripod(b: &mut Build<'_>, spread: f32, top: f32, mat: MaterialId) {
    for (c, s) in [(1.0, 0.0), (-0.5, 0.866), (-0.5, -0.866)] {
        let r = spread * 0.07;
        b.bar(
            "leg",
            [c * (spread - r * 1.5), s * (spread - r * 1.5), r * 1.45],
            [c * spread * 0.12, s * spread * 0.12, top - r],
            r,
            mat,
        );
    }
    b.cylinder("hub", [0.0, 0.0, top * 0.93], spread * 0.2, top * 0.07, mat);
}

/// A base, jointed arms, and a head that shines down.
pub(super) fn desk_lamp(b: &mut Build<'_>) {
    let u = fit(b, [0.112, 0.112, 0.272]);
    let (x, y, h) = half_dims(b);
    let mat = b.choose(&[BLACK_METAL, WHITE_METAL, RED_METAL, STEEL, YELLOW_METAL, BLUE_METAL, b.style.metal]);
    let foot_r = (y * 0.92).min(x * 0.6);
    let foot = [-x + foot_r, 0.0];
    let foot_h = 0.03 * u;
    if b.rng.chance(0.6) {
        b.lathe("foot", [foot[0], 0.0, 0.0], &[(foot_r, 0.0), (foot_r, foot_h * 0.6), (foot_r * 0.9, foot_h)], mat);
    } else {
        b.rounded_block("foot", [-x, -y * 0.9, 0.0], [-x + 2.0 * foot_r, y * 0.9, foot_h], 0.006 * u, mat);
    }
    let r = 0.007 * u;
    match b.rng.below(3) {
        0 => {
            // Two arms and a bell-shaped head.
            let head = (y * 0.8).min(h * 0.16);
            let elbow: P = [-x + 0.03 * u, 0.0, h * 0.56];
            let wrist: P = [x - head * 1.4, 0.0, h - 0.03 * u];
            for cy in [-0.012 * u, 0.012 * u] {
                b.rod("arm", [foot[0], cy, foot_h], [elbow[0], cy, elbow[2]], r * 0.6, mat);
                b.rod("arm", [elbow[0], cy, elbow[2]], [wrist[0], cy, wrist[2]], r * 0.6, mat);
            }
            for p in [[foot[0], 0.0, foot_h], elbow, wrist] {
                b.rod("joint", [p[0], -0.018 * u, p[2]], [p[0], 0.018 * u, p[2]], r * 1.5, BLACK_PLASTIC);
            }
            let cx = x - head;
            let low = h * 0.68;
            shade(b, 3, [cx, 0.0, low], (head, h * 0.22), mat);
            bulb(b, [cx, 0.0, low + h * 0.08], head * 0.4, true);
            b.bar("neck", wrist, [cx, 0.0, low + h * 0.2], r * 1.2, mat);
            b.cylinder("cap", [cx, 0.0, low + h * 0.2], head * 0.46, h * 0.025, mat);
            b.rod("stem", [cx, 0.0, low + h * 0.09], [cx, 0.0, low + h * 0.22], head * 0.3, mat);
        }
        1 => {
            // A bent arm with a flat light bar.
            let top = h - 0.012 * u;
            b.pipe(
                "arm",
                &[[foot[0], 0.0, foot_h], [-x + 0.02 * u, 0.0, top * 0.9], [-x + 0.06 * u, 0.0, top]],
                r * 1.3,
                mat,
            );
            b.rounded_block("head", [-x + 0.04 * u, -0.022 * u, h - 0.02 * u], [x, 0.022 * u, h], 0.006 * u, mat);
            b.block("light", [-x + x, -0.016 * u, h - 0.022 * u], [x * 0.96, 0.016 * u, h - 0.019 * u], COOL_BULB);
        }
        _ => {
            // A banker's lamp: a stem and a long green shade.
            let (low, tall) = (h * 0.72, h * 0.22);
            let stem = -x + foot_r;
            b.cylinder("stem", [stem, 0.0, foot_h * 0.9], r * 1.3, low - foot_h + tall * 0.6, BRASS);
            let glass = b.choose(&[GREEN_METAL, mat, BLUE_METAL]);
            let deep = (x * 0.6).min(y * 0.9);
            let outline = [
                (-deep, 0.0),
                (-deep * 0.8, tall * 0.7),
                (-deep * 0.3, tall),
                (deep * 0.3, tall),
                (deep * 0.8, tall * 0.7),
                (deep, 0.0),
                (deep * 0.9, 0.0),
                (deep * 0.7, tall * 0.62),
                (deep * 0.25, tall * 0.88),
                (-deep * 0.25, tall * 0.88),
                (-deep * 0.7, tall * 0.62),
                (-deep * 0.9, 0.0),
            ];
            b.prism("shade", crate::solid::Axis::Y, [stem.max(-x + deep), -y, low], &outline, 2.0 * y, glass);
            b.rod(
                "light",
                [stem.max(-x + deep), -y * 0.8, low + tall * 0.4],
                [stem.max(-x + deep), y * 0.8, low + tall * 0.4],
                deep * 0.18,
                WARM_BULB,
            );
            b.rod("arm", [stem - r, 0.0, low + tall * 0.5], [stem.max(-x + deep) + r, 0.0, low + tall * 0.5], r, BRASS);
            b.block("switch", [stem + r, -r * 0.4, low * 0.8], [stem + r * 2.5, r * 0.4, low * 0.83], BRASS);
            b.cylinder("finial", [stem, 0.0, low + tall * 0.6], r * 1.3, h - low - tall * 0.6, BRASS);
        }
    }
}

/// A floor lamp: a shade on a pole or on three legs, an arc lamp, an uplighter, or spots.
pub(super) fn floor_lamp(b: &mut Build<'_>) {
    let u = fit(b, [0.192, 0.192, 1.12]);
    let (x, y, h) = half_dims(b);
    let r = x.min(y);
    let metal = stand_mat(b);
    let foot = r * b.vary(0.55, 0.75);
    let pole = 0.012 * u;
    match b.rng.below(5) {
        0 | 1 => {
            let tall = h * b.vary(0.15, 0.24);
            let neck = h - tall;
            b.lathe("foot", [0.0; 3], &[(foot, 0.0), (foot, 0.015 * u), (pole * 2.0, 0.03 * u)], metal);
            b.cylinder("pole", [0.0, 0.0, 0.01 * u], pole, neck - 0.01 * u, metal);
            let design = b.choose(&[0, 1, 2, 3]);
            topped(b, design, (r, tall), neck, h);
        }
        2 => {
            let tall = h * b.vary(0.17, 0.24);
            let wood = b.choose(&[b.style.wood, b.style.wood, metal]);
            tripod(b, r * 0.98, h - tall, wood);
            let design = b.choose(&[0, 2]);
            topped(b, design, (r * 0.85, tall), h - tall, h);
        }
        3 => {
            b.lathe("foot", [0.0; 3], &[(foot, 0.0), (foot, 0.015 * u), (pole * 2.0, 0.03 * u)], metal);
            let bowl = h * 0.07;
            b.cylinder("pole", [0.0, 0.0, 0.01 * u], pole, h - bowl - 0.005 * u, metal);
            let wall = 0.006 * u;
            let profile = [
                (pole * 1.5, 0.0),
                (r * 0.7, bowl * 0.4),
                (r, bowl),
                (r - wall, bowl),
                (r * 0.68, bowl * 0.5),
                (pole, wall),
            ];
            b.lathe("bowl", [0.0, 0.0, h - bowl], &profile, metal);
            b.cylinder("light", [0.0, 0.0, h - bowl * 0.55], r * 0.6, bowl * 0.2, WARM_BULB);
        }
        _ => {
            // An arc that holds its shade forward.
            let cx = -x + foot.min(x);
            b.cylinder("foot", [cx, 0.0, 0.0], foot.min(y).min(x), 0.035 * u, MARBLE);
            let head = (x * 0.55).min(y);
            let tip = x - head;
            let points: [P; 6] = [
                [cx, 0.0, 0.03 * u],
                [cx - x * 0.05, 0.0, h * 0.6],
                [cx + (tip - cx) * 0.12, 0.0, h * 0.88],
                [cx + (tip - cx) * 0.5, 0.0, h - pole * 1.4],
                [cx + (tip - cx) * 0.85, 0.0, h * 0.96],
                [tip, 0.0, h * 0.9],
            ];
            b.pipe("pole", &points, pole * 0.8, metal);
            shade(b, 4, [tip, 0.0, h * 0.78], (head, h * 0.11), metal);
            bulb(b, [tip, 0.0, h * 0.81], head * 0.3, true);
            b.rod("neck", [tip, 0.0, h * 0.82], [tip, 0.0, h * 0.9], head * 0.24, metal);
        }
    }
}
