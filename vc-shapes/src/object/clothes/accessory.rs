//! Hangers, umbrellas, glasses, keys, wallets, and shoe accessories.

use std::f32::consts::PI;

use vc_graph::portable::Portable;

use crate::material::*;
use crate::solid::{
    Axis, Build, MeshBuilder, P, arc, blocks, facing, half_dims, hoop, longwise, mix, oval, sheet, spline, tube,
    walled_tray,
};

/// Builds the hook of a hanger up to the top of the size and returns the height of the shoulders,
/// at least `least`.
pub(super) fn hook(b: &mut Build<'_>, least: f32) -> f32 {
    let (x, y, h) = half_dims(b);
    let neck = least.max(h - 0.08);
    let r = (x * 0.1).min(0.0022);
    let round = ((h - neck) * 0.3).min(y * 0.2).max(r * 1.2);
    let mut line = vec![[0.0, 0.0, neck * 0.98], [0.0, 0.0, h - 2.0 * round]];
    line.extend(arc(Axis::X, [0.0, 0.0, h - round - r], (round, round), (-PI * 0.45, PI), 10));
    tube(b, "hook", &line, r, STEEL);
    neck
}

/// Builds a hanger with clips above a garment held at its waist and returns the height of the
/// waist.
pub(super) fn clip_hanger(b: &mut Build<'_>, h: f32) -> f32 {
    let (x, y, _) = half_dims(b);
    let waist = hook(b, h * 0.92) - h * 0.005;
    let r = (x * 0.2).min(0.004);
    b.rod("bar", [0.0, -y * 0.62, waist + r], [0.0, y * 0.62, waist + r], r, STEEL);
    let clips =
        [-0.5, 0.5].map(|s| ([-x * 0.9, y * s - y * 0.05, waist * 0.97], [x * 0.9, y * s + y * 0.05, waist + 2.0 * r]));
    blocks(b, "clip", &clips, BLACK_PLASTIC);
    waist
}

/// A clothes hanger of wood, plastic or wire, facing the front.
pub(super) fn hanger(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let mat = b.choose(&[OAK, BEECH, BLACK_PLASTIC, STEEL, WHITE_PLASTIC, WALNUT]);
    let r = x.min(if mat == STEEL { 0.002 } else { 0.009 }).min(h * 0.06);
    let neck = h * 0.62;
    let round = (h - neck) * 0.28;
    let mut line = vec![[0.0, 0.0, neck * 0.97], [0.0, 0.0, h - 2.0 * round]];
    let wire = r.min(0.002);
    line.extend(arc(Axis::X, [0.0, 0.0, h - round - wire], (round, round), (-PI * 0.45, PI), 10));
    tube(b, "hook", &line, wire, STEEL);
    let mut body = MeshBuilder::default();
    let low = r;
    for s in [-1.0, 1.0] {
        let arm =
            [[0.0, 0.0, neck], [0.0, s * y * 0.35, neck * 0.85], [0.0, s * y * 0.75, h * 0.3], [0.0, s * (y - r), low]];
        body.tube(&spline(&arm, 4), r);
    }
    body.put(b, "arm", mat);
    b.hook("hook", [0.0, 0.0, neck], 1.5_f32.max(h));
}

/// A closed umbrella standing on its tip: folds, strap and a curved handle; or a short folding
/// umbrella.
pub(super) fn umbrella(b: &mut Build<'_>) {
    longwise(b, |b, t, w, h| {
        let (x, y) = (t / 2.0, w / 2.0);
        let cloth = b.choose(&[BLACK_FABRIC, RED_FABRIC, NAVY_FABRIC, YELLOW_PLASTIC, GREEN_FABRIC, b.style.accent]);
        let grip = b.choose(&[WALNUT, BLACK_PLASTIC, OAK, BROWN_LEATHER]);
        let r = x.min(y);
        let crook = h > 0.5;
        let (low, high) = if crook { (h * 0.08, h * 0.72) } else { (0.0, h * 0.78) };
        let ring = |z: f32, s: f32, phase: f32| -> Vec<P> {
            (0..16)
                .map(|i| {
                    let (sin, cos) = (i as f32 / 16.0 * 2.0 * PI + phase).sine_cosine();
                    let s = r * s * if i % 2 == 0 { 1.0 } else { 0.62 };
                    [s * cos, s * sin, low + (high - low) * z]
                })
                .collect()
        };
        let full = if crook { 0.55 } else { 0.95 };
        let mut canopy = MeshBuilder::default();
        canopy.loft(&[
            ring(0.0, full * 0.25, 0.0),
            ring(0.08, full * 0.5, 0.1),
            ring(0.7, full, 0.5),
            ring(0.97, full * 0.9, 0.7),
            ring(1.0, full * 0.5, 0.7),
        ]);
        canopy.put(b, "canopy", cloth);
        let tie = oval(Axis::Z, [0.0, 0.0, low + (high - low) * 0.6], (r * full * 0.86, r * full * 0.86), 0, 16);
        hoop(b, "strap", &tie, r * 0.08, cloth);
        if crook {
            b.rod("tip", [0.0; 3], [0.0, 0.0, low * 1.2], r * 0.1, STEEL);
            let bend = (y * 0.45).min(h * 0.08);
            let thick = r * 0.16;
            let top = h - thick - bend;
            let mut line = vec![[0.0, -bend, high * 0.98], [0.0, -bend, high + (top - high) * 0.6]];
            line[0][1] = 0.0;
            line.extend(arc(Axis::X, [0.0, 0.0, top], (bend, bend), (PI, -0.2), 10));
            tube(b, "grip", &line, thick, grip);
        } else {
            b.lathe(
                "grip",
                [0.0, 0.0, high * 0.98],
                &[(r * 0.4, 0.0), (r * 0.55, (h - high) * 0.5), (r * 0.5, h - high * 0.99), (r * 0.3, h - high * 0.98)],
                grip,
            );
        }
    });
}

/// Glasses: two rims, a bridge and temples that are open or folded.
pub(super) fn spectacles(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let frame = b.choose(&[BLACK_PLASTIC, BROWN_PLASTIC, GOLD, STEEL, RED_PLASTIC]);
    let lens = if b.class == "sunglasses" { b.choose(&[BLACK_GLASS, BROWN_GLASS]) } else { GLASS };
    let r = (h * 0.06).min(x * 0.2).min(0.003);
    let front = x - r;
    let half = (y * 0.44 - r, h / 2.0 - r);
    let square = b.rng.below(3).min(1);
    for s in [-1.0_f32, 1.0] {
        let at = [front, s * (y * 0.56 - r), h / 2.0];
        hoop(b, "rim", &oval(Axis::X, at, half, square, 20), r, frame);
        let glass: Vec<(f32, f32)> = oval(Axis::Z, [0.0; 3], half, square, 20).iter().map(|p| (p[0], p[1])).collect();
        b.prism("lens", Axis::X, [front - r * 0.2, at[1], at[2]], &glass, r * 0.4, lens);
        let hinge = [front, s * (y - r * 2.0), h * 0.68];
        let line = if x > 0.025 {
            [
                hinge,
                [0.0, s * (y - r * 1.5), h * 0.68],
                [-x * 0.55, s * (y - r * 1.5), h * 0.66],
                [-x + r, s * (y - r * 2.0), r * 1.2],
            ]
        } else {
            let back = front - r * (2.2 + 1.8 * (s + 1.0) / 2.0);
            [
                hinge,
                [back.max(r - x), s * y * 0.88, h * 0.68],
                [back.max(r - x), 0.0, h * 0.66],
                [back.max(r - x), -s * y * 0.8, h * 0.4],
            ]
        };
        let mut temple = MeshBuilder::default();
        temple.tube(&spline(&line, 4), r * 0.8);
        temple.put(b, "temple", frame);
    }
    let bridge = [[front, -y * 0.13, h * 0.62], [front, 0.0, h * 0.7], [front, y * 0.13, h * 0.62]];
    tube(b, "bridge", &spline(&bridge, 3), r * 0.8, frame);
}

/// A hanging bunch of keys on a ring.
pub(super) fn keys(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let ring = (h * 0.16).min(y * 0.8);
    let thin = (x * 0.12).min(ring * 0.1);
    hoop(b, "ring", &oval(Axis::X, [0.0, 0.0, h - ring], (ring - thin, ring - thin), 0, 20), thin, STEEL);
    b.rod("pin", [-x * 0.75, 0.0, h - 2.0 * ring + thin], [x * 0.75, 0.0, h - 2.0 * ring + thin], thin * 1.3, STEEL);
    let count = b.rng.count(2, 3);
    for i in 0..count {
        let metal = b.choose(&[BRASS, STEEL, SILVER_METAL]);
        let lean = (i as f32 / (count - 1) as f32 * 2.0 - 1.0) * 0.55;
        let px = x * (-0.6 + 1.2 * i as f32 / (count - 1) as f32);
        let top = [y * lean * 0.25, h - ring * 1.7];
        let foot = [y * lean, if i == 1 { h * 0.0 } else { h * 0.08 }];
        let way = |t: f32, side: f32| {
            let (dy, dz) = (foot[0] - top[0], foot[1] - top[1]);
            let long = (dy * dy + dz * dz).sqrt().max(1e-6);
            (top[0] + dy * t - dz / long * side, top[1] + dz * t + dy / long * side)
        };
        let wide = y * 0.26;
        let outline: Vec<(f32, f32)> = [
            (0.0, 0.5),
            (0.05, 1.0),
            (0.25, 1.0),
            (0.33, 0.35),
            (0.97, 0.35),
            (0.97, -0.3),
            (0.9, -0.7),
            (0.82, -0.3),
            (0.75, -0.75),
            (0.66, -0.3),
            (0.33, -0.35),
            (0.25, -1.0),
            (0.05, -1.0),
            (0.0, -0.5),
        ]
        .map(|(t, s)| way(t, s * wide))
        .to_vec();
        let low = outline.iter().map(|p| p.1).fold(h, f32::min);
        let outline: Vec<(f32, f32)> = outline.iter().map(|p| (p.0, p.1 - low)).collect();
        let thick = (x * 0.25).min(0.0025);
        b.prism("key", Axis::X, [px - thick / 2.0, 0.0, 0.0], &outline, thick, metal);
    }
    if b.rng.chance(0.5) {
        let tag = b.choose(&[RED_PLASTIC, BLUE_PLASTIC, BROWN_LEATHER, YELLOW_PLASTIC]);
        b.rod("tag", [-x, 0.0, h - ring * 2.0], [x, 0.0, h - ring * 2.0], ring * 0.5, tag);
    }
}

/// A folded wallet, standing on its edge or lying.
pub(super) fn wallet(b: &mut Build<'_>) {
    facing(b, |b, t, w, h| {
        let leather = b.choose(&[BROWN_LEATHER, BLACK_LEATHER, TAN_LEATHER, RED_FABRIC, NAVY_FABRIC]);
        let (x, y) = (t / 2.0, w / 2.0);
        let leaf = t * 0.1;
        let edge = y * 0.98;
        b.block("back", [-x, -edge, 0.0], [-x + leaf, y, h], leather);
        b.block("spine", [-x + leaf * 0.5, -y, h * 0.02], [x - leaf, -y + (w * 0.04).min(leaf), h * 0.98], leather);
        b.block("card", [-x + leaf * 0.9, -y * 0.8, h * 0.2], [-x + leaf * 1.3, y * 0.9, h * 0.94], GREEN_CARD);
        b.block("fold", [-x + leaf * 0.9, -y * 0.97, h * 0.01], [x - leaf * 1.1, y * 0.97, h * 0.04], leather);
        b.inside("pocket", [leaf * 0.15, 0.0, h * 0.04], (t * 0.38, y * 0.85), h * 0.9);
        b.hinge([x - leaf, -edge, 0.0], [0.0, 0.0, -1.0], 1.6, |b| {
            b.block("cover", [x - leaf, -edge, 0.0], [x - leaf * 0.3, y, h], leather);
            b.block("stitch", [x - leaf * 0.5, -y * 0.9, h * 0.9], [x, y * 0.9, h * 0.93], BEIGE_FABRIC);
        });
    });
}

/// A shoe horn: a curved blade with a grip.
pub(super) fn shoe_horn(b: &mut Build<'_>) {
    longwise(b, |b, t, w, h| {
        let mat = b.choose(&[STEEL, BROWN_PLASTIC, WALNUT, BLACK_PLASTIC]);
        let (x, y) = (t / 2.0, w / 2.0);
        let blade = |u: f32, v: f32| {
            let side = 2.0 * v - 1.0;
            let wide = y * (1.0 - 0.55 * u) * (u * 6.0 + 0.5).min(1.0);
            let px = x * (1.8 * side * side - 0.9) * (1.0 - u * 0.5);
            let z = (h - y * 0.7).max(h * 0.5) * u;
            ([px + x * 0.1, wide * side, z], [px - x * 0.1, wide * side, z])
        };
        sheet(b, "blade", (10, 8), blade, mat);
        let ring = oval(Axis::X, [0.0, 0.0, h - y * 0.45], (y * 0.36, y * 0.36), 0, 12);
        hoop(b, "ring", &ring, y * 0.09, mat);
    });
}

/// A box for shoe polish: lid, brush and tin.
pub(super) fn shoe_shine_kit(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let wood = b.choose(&[OAK, WALNUT, BLACK_PLASTIC]);
    let t = (x * 0.06).min(0.008);
    let rim = h * 0.6;
    walled_tray(b, (x, y), (0.0, rim), t, wood);
    b.block("tin", [-x * 0.6, -y * 0.7, t * 0.9], [x * 0.6, -y * 0.1, rim * 0.6], RED_METAL);
    b.block("cloth", [-x * 0.6, y * 0.1, t * 0.9], [x * 0.6, y * 0.8, rim * 0.5], MUSTARD_FABRIC);
    b.hinge([-x, 0.0, rim], [0.0, -1.0, 0.0], 1.8, |b| {
        b.block("lid", [-x, -y, rim + h * 0.002], [x, y, rim + t], wood);
        let brush = mix([0.0, 0.0, rim + t], [0.0, 0.0, h], 0.4);
        b.block("bristles", [-x * 0.35, -y * 0.55, rim + t * 0.9], [x * 0.35, y * 0.55, brush[2]], BLACK_FABRIC);
        b.rounded_block("brush", [-x * 0.42, -y * 0.65, brush[2] - 0.001], [x * 0.42, y * 0.65, h], h * 0.08, BEECH);
    });
}
