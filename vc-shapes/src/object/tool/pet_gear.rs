//! Cages, bowls, carriers and leashes.

use vc_graph::portable::Portable;

use super::workshop::risen;
use crate::material::*;
use crate::solid::{Axis, Build, MeshBuilder, P, arc, blocks, half_dims, hoop, loft, oval, tube};

/// A wire cage on a tray with a door, a perch and a cup; a bird cage is domed.
pub(super) fn cage(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let wire = b.choose(&[WHITE_METAL, IRON, BRASS, SILVER_METAL]);
    let tray = b.choose(&[BLUE_PLASTIC, GREY_PLASTIC, BLACK_PLASTIC, PINK_PLASTIC]);
    let (tall, r) = (h * 0.13, 0.0016_f32.min(x * 0.01));
    let ring = |z: f32, s: f32| oval(Axis::Z, [0.0, 0.0, z], (x * s, y * s), 2, 24);
    loft(b, "tray", &[ring(0.0, 0.94), ring(tall, 1.0), ring(tall, 0.97), ring(h * 0.015, 0.91)], tray);
    b.inside("compartment", [0.0, 0.0, h * 0.015], (x * 0.8, y * 0.8), h * 0.3);
    let domed = b.rng.chance(0.5);
    let eave = if domed { h * 0.7 } else { h - r };
    let (wx, wy) = (x * 0.955, y * 0.97);
    let door = (y * 0.3, tall + (eave - tall) * 0.12, tall + (eave - tall) * 0.62);
    let mut bars = MeshBuilder::default();
    let (nx, ny) = (8, 10);
    let top = |px: f32| if domed { h - r - (h - eave) * (px / wx).raised(2) } else { eave };
    for i in 0..=nx {
        let px = wx * (2.0 * i as f32 / nx as f32 - 1.0);
        for py in [-wy, wy] {
            bars.tube(&[[px, py, tall * 0.8], [px, py, top(px)]], r);
        }
        bars.tube(&[[px, -wy, top(px) - r], [px, wy, top(px) - r]], r);
    }
    for i in 1..ny {
        let py = wy * (2.0 * i as f32 / ny as f32 - 1.0);
        bars.tube(&[[-wx, py, tall * 0.8], [-wx, py, eave]], r);
        if py.abs() > door.0 {
            bars.tube(&[[wx, py, tall * 0.8], [wx, py, eave]], r);
        } else {
            bars.tube(&[[wx, py, tall * 0.8], [wx, py, door.1]], r);
            bars.tube(&[[wx, py, door.2], [wx, py, eave]], r);
        }
    }
    for i in (0..=ny).step_by(2) {
        let py = wy * (2.0 * i as f32 / ny as f32 - 1.0);
        let line: Vec<P> =
            (0..=nx).map(|k| wx * (2.0 * k as f32 / nx as f32 - 1.0)).map(|px| [px, py, top(px) - 2.0 * r]).collect();
        bars.tube(&line, r);
    }
    for z in [eave - 2.0 * r, tall + r] {
        bars.hoop(&[[wx, wy, z], [-wx, wy, z], [-wx, -wy, z], [wx, -wy, z]], r * 1.3);
    }
    bars.put(b, "wire", wire);
    b.hinge([wx, -door.0, door.1], [0.0, 0.0, -1.0], 1.9, |b| {
        let mut leaf = MeshBuilder::default();
        let out = wx + 2.5 * r;
        leaf.hoop(
            &[[out, -door.0, door.1], [out, door.0, door.1], [out, door.0, door.2], [out, -door.0, door.2]],
            r * 1.2,
        );
        for i in 1..6 {
            let py = door.0 * (i as f32 / 3.0 - 1.0);
            leaf.tube(&[[out, py, door.1], [out, py, door.2]], r);
        }
        leaf.put(b, "door", wire);
    });
    b.rod("perch", [0.0, -wy, h * 0.42], [0.0, wy, h * 0.42], 0.006_f32.min(x * 0.04), PINE);
    if !domed {
        let (px, r) = (-wx * 0.5, r * 2.0);
        hoop(b, "wheel", &oval(Axis::Y, [px, wy * 0.6, h * 0.62], (x * 0.3, h * 0.15), 0, 18), r, YELLOW_PLASTIC);
        b.rod("axle", [px, wy, h * 0.62], [px, wy * 0.55, h * 0.62], r, wire);
        b.block("spoke", [px - r, wy * 0.6 - r * 0.5, h * 0.47], [px + r, wy * 0.6 + r * 0.5, h * 0.77], wire);
    }
}

/// A bowl for food or water, with a bone on its side.
pub(super) fn bowl(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let r = x.min(y);
    let mat = b.choose(&[STEEL, RED_PLASTIC, BLUE_PLASTIC, PORCELAIN, STONEWARE, GREEN_PLASTIC]);
    let slope = b.vary(0.72, 0.86);
    let foot = if b.rng.chance(0.5) { (r * 0.97, r * slope) } else { (r * slope, r) };
    let inner = foot.1.min(r * 0.9) * 0.92;
    b.lathe(
        "bowl",
        [0.0; 3],
        &[(foot.0, 0.0), (foot.1, h), (inner, h), (inner * 0.85, h * 0.3), (inner * 0.7, h * 0.2)],
        mat,
    );
    let fill = b.choose(&[WATER, COOKED_MEAT, BROWN_SKIN]);
    if b.rng.chance(0.6) {
        b.cylinder("food", [0.0, 0.0, h * 0.201], inner * 0.82, h * 0.4, fill);
    }
    if foot.0 > r * 0.9 {
        b.lathe("band", [0.0; 3], &[(r, h * 0.01), (r, h * 0.06)], RUBBER);
    }
}

/// A pet carrier: two shells, a wire door in front, a handle on top.
pub(super) fn carrier(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let (lower, upper) = b.choose(&[
        (GREY_PLASTIC, BLUE_PLASTIC),
        (BLACK_PLASTIC, GREY_PLASTIC),
        (WHITE_PLASTIC, RED_PLASTIC),
        (BROWN_PLASTIC, WHITE_PLASTIC),
    ]);
    let (grip, t) = (h * 0.1, 0.006_f32.min(y * 0.06));
    let (top, seam) = (h - grip - t, h * 0.42);
    let front = x - t;
    let half = |z0: f32, z1: f32, y: f32, x: f32| {
        [
            ([-x, -y, z0], [front, -y + t, z1]),
            ([-x, y - t, z0], [front, y, z1]),
            ([-x, -y + t * 0.9, z0], [-x + t, y - t * 0.9, z1]),
        ]
    };
    blocks(b, "shell", &half(0.0, seam, y, x), lower);
    b.block("floor", [-x + t * 0.9, -y + t * 0.9, 0.0], [front - t * 0.3, y - t * 0.9, t], lower);
    blocks(b, "shell", &half(seam, top, y * 0.98, x * 0.99), upper);
    b.block("roof", [-x * 0.98, -y * 0.97, top - h * 0.001], [front - t * 0.4, y * 0.97, top + t], upper);
    b.inside("compartment", [0.0, 0.0, t], (x - 3.0 * t, y - 3.0 * t), top - 3.0 * t);
    let slots: Vec<(P, P)> = (0..5)
        .flat_map(|i| {
            let px = -x * 0.7 + x * 0.3 * i as f32;
            [-1.0_f32, 1.0].map(|s| {
                let (a, c) = (s * y * 0.96, s * y * 0.99);
                ([px, a.min(c), seam + (top - seam) * 0.3], [px + x * 0.15, a.max(c), seam + (top - seam) * 0.75])
            })
        })
        .collect();
    blocks(b, "vent", &slots, BLACK_PLASTIC);
    b.hinge([front, -y + t, 0.0], [0.0, 0.0, -1.0], 1.9, |b| {
        let mut door = MeshBuilder::default();
        let r = t * 0.3;
        let (w, z0, z1) = (y - 2.0 * t, t * 2.0, top - t * 2.0);
        let px = front + r;
        door.hoop(&[[px, -w, z0], [px, w, z0], [px, w, z1], [px, -w, z1]], r * 1.5);
        (1..8)
            .for_each(|i| door.tube(&[[px, w * (i as f32 / 4.0 - 1.0), z0], [px, w * (i as f32 / 4.0 - 1.0), z1]], r));
        (1..4).for_each(|i| {
            door.tube(&[[px, -w, z0 + (z1 - z0) * i as f32 / 4.0], [px, w, z0 + (z1 - z0) * i as f32 / 4.0]], r)
        });
        door.put(b, "door", STEEL);
    });
    let r = t * 0.9;
    let handle = [[-x * 0.4, 0.0, top], [-x * 0.3, 0.0, h - r * 1.4], [x * 0.3, 0.0, h - r * 1.4], [x * 0.4, 0.0, top]];
    tube(b, "handle", &handle, r, lower);
}

/// A leash: a coiled strap with a snap hook, or a reel with a grip.
pub(super) fn leash(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let strap = b.choose(&[RED_FABRIC, BLACK_FABRIC, BROWN_LEATHER, BLUE_FABRIC]);
    let r = (h / 4.0).min(x * 0.25).min(y * 0.2);
    let turns = ((h - 2.0 * r) / (2.0 * r)).clamp(2.0, 7.0).round();
    let count = turns as usize * 16;
    let coil: Vec<P> = (0..=count)
        .map(|i| {
            let t = i as f32 / count as f32;
            let (s, c) = (t * turns * std::f32::consts::TAU).sine_cosine();
            let shrink = 1.0 - 0.15 * t;
            [(x - r) * c * shrink, (y - r) * s * shrink, r + (h - 2.0 * r) * risen(t, turns)]
        })
        .chain([[x * 0.35, 0.0, h - r]])
        .collect();
    tube(b, "strap", &coil, r, strap);
    let hook = arc(Axis::Z, [0.0, 0.0, h - r], (x * 0.35, y * 0.35), (0.0, 5.6), 12);
    tube(b, "hook", &hook, r * 0.5, STEEL);
}
