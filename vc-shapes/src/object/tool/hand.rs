//! Hand tools, standing or lying along their longest side.

use vc_graph::portable::Portable;

use crate::material::*;
use crate::solid::{Axis, Build, MeshBuilder, P, blocks, half_dims, loft, longwise, oval, spline};

const GRIPS: [MaterialId; 6] =
    [RED_PLASTIC, YELLOW_PLASTIC, BLUE_PLASTIC, ORANGE_PLASTIC, BLACK_PLASTIC, GREEN_PLASTIC];

/// A hammer: claw, mallet or sledge, with the head on top.
pub(super) fn hammer(b: &mut Build<'_>) {
    longwise(b, |b, t, w, l| {
        let (x, y) = (t / 2.0, w / 2.0);
        let head = l * b.vary(0.1, 0.13);
        let grip = b.choose(&[OAK, BEECH, RED_RUBBER, RUBBER, BLUE_PLASTIC]);
        let ring = |z: f32, s: f32| oval(Axis::Z, [0.0, 0.0, l * z], (x * 0.8 * s, (y * 0.28 * s).min(x * s)), 0, 12);
        let mut shaft = MeshBuilder::default();
        shaft.loft(&[ring(0.0, 0.95), ring(0.03, 1.0), ring(0.3, 0.9), ring(0.5, 0.62), ring(0.97, 0.6)]);
        shaft.put(b, "handle", grip);
        let low = l - head;
        if b.rng.chance(0.3) {
            let mallet = b.choose(&[RUBBER, OAK, RED_RUBBER]);
            return b.rounded_block("head", [-x, -y, l - head * 1.4], [x, y, l], x * 0.3, mallet);
        }
        b.block("head", [-x * 0.75, -y * 0.35, low], [x * 0.75, y * 0.35, l], IRON);
        b.rod("face", [0.0, y * 0.3, low + head * 0.5], [0.0, y, low + head * 0.5], (head * 0.45).min(x), STEEL);
        let claw = [
            (-y * 0.3, l),
            (-y * 0.7, l - head * 0.1),
            (-y, l - head * 0.75),
            (-y * 0.75, l - head * 0.45),
            (-y * 0.3, l - head * 0.7),
        ];
        for side in [-1.0_f32, 1.0] {
            let from = if side > 0.0 { x * 0.12 } else { -x * 0.7 };
            b.prism("claw", Axis::X, [from, 0.0, 0.0], &claw, x * 0.58, IRON);
        }
    });
}

/// A screwdriver with a fluted grip.
pub(super) fn screwdriver(b: &mut Build<'_>) {
    longwise(b, |b, t, w, l| {
        let r = t.min(w) / 2.0;
        let grip = b.choose(&GRIPS);
        let split = l * b.vary(0.38, 0.48);
        let turned = [
            (r * 0.6, 0.0),
            (r * 0.95, l * 0.02),
            (r, split * 0.4),
            (r * 0.75, split * 0.75),
            (r * 0.95, split * 0.9),
            (r * 0.5, split),
        ];
        b.lathe("grip", [0.0; 3], &turned, grip);
        b.lathe("band", [0.0, 0.0, split * 0.62], &[(r * 0.9, 0.0), (r * 0.9, split * 0.08)], BLACK_PLASTIC);
        b.cylinder("shaft", [0.0, 0.0, split * 0.9], r * 0.2, l * 0.93 - split * 0.9, STEEL);
        b.taper("tip", [0.0, 0.0, l * 0.92], (r * 0.18, r * 0.18), (r * 0.05, r * 0.26), l * 0.08, STEEL);
    });
}

/// A spanner: an open end and a ring end; or an adjustable one.
pub(super) fn wrench(b: &mut Build<'_>) {
    longwise(b, |b, t, w, l| {
        let (x, y) = (t / 2.0, w / 2.0);
        let mat = b.choose(&[STEEL, CHROME, IRON]);
        let r = y;
        let jaw: Vec<(f32, f32)> = vec![
            (-y * 0.35, l - r * 2.0),
            (y * 0.35, l - r * 2.0),
            (y, l - r * 1.2),
            (y * 0.9, l - r * 0.1),
            (y * 0.5, l),
            (y * 0.42, l - r * 0.9),
            (-y * 0.42, l - r * 0.9),
            (-y * 0.5, l),
            (-y * 0.9, l - r * 0.1),
            (-y, l - r * 1.2),
        ];
        b.prism("jaw", Axis::X, [-x, 0.0, 0.0], &jaw, 2.0 * x, mat);
        b.block("shaft", [-x * 0.6, -y * 0.36, r * 0.9], [x * 0.6, y * 0.36, l - r * 1.9], mat);
        let ring: Vec<Vec<P>> = oval(Axis::X, [0.0, 0.0, r * 0.85], (y * 0.65, r * 0.65), 0, 20)
            .iter()
            .map(|p| {
                let out = [p[1] * 0.31, (p[2] - r * 0.85) * 0.31];
                [(-1.0, 1.0), (1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)]
                    .map(|(s, o): (f32, f32)| [s * x * 0.8, p[1] + o * out[0], p[2] + o * out[1]])
                    .to_vec()
            })
            .collect();
        let mut shell = MeshBuilder::default();
        shell.torus(&ring);
        shell.put(b, "ring", mat);
    });
}

/// Pliers: two crossed arms with soft grips.
pub(super) fn pliers(b: &mut Build<'_>) {
    longwise(b, |b, t, w, l| {
        let (x, y) = (t / 2.0, w / 2.0);
        let grip = b.choose(&GRIPS);
        let pivot = l * 0.68;
        let nose = b.vary(0.12, 0.45);
        let mut grips = MeshBuilder::default();
        for side in [-1.0_f32, 1.0] {
            let jaw = [
                (side * 0.01 * y, pivot),
                (side * y * 0.6, pivot),
                (side * y * 0.45, pivot + (l - pivot) * 0.5),
                (side * y * nose, l),
                (side * 0.01 * y, l),
            ];
            b.prism("jaw", Axis::X, [-x * 0.7, 0.0, 0.0], &jaw, x * 1.4, STEEL);
            let r = (x * 0.95).min(y * 0.27);
            let way = [
                [0.0, side * (y * 0.4), pivot * 0.9],
                [0.0, side * (y - r * 1.25), pivot * 0.5],
                [0.0, side * (y - r * 1.25), pivot * 0.25],
                [0.0, side * (y * 0.55), r * 0.3],
            ];
            grips.tapered(&spline(&way, 4), |t| r * (0.7 + 0.3 * (t * 3.1).sine()));
        }
        grips.put(b, "grip", grip);
        b.rod("pivot", [-x, 0.0, pivot], [x, 0.0, pivot], y * 0.3, IRON);
        b.block("neck", [-x * 0.65, -y * 0.5, pivot * 0.85], [x * 0.65, y * 0.5, pivot * 1.05], STEEL);
    });
}

/// A drill standing on its battery with its chuck to the left.
pub(super) fn drill(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let colour = b.choose(&[YELLOW_PLASTIC, BLUE_PLASTIC, GREEN_PLASTIC, RED_PLASTIC, ORANGE_PLASTIC]);
    let foot = h * 0.2;
    let r = x.min(h * 0.16);
    let axis = h - r;
    let grip = -y * 0.35;
    b.rounded_block(
        "battery",
        [-x * 0.9, grip - y * 0.4, 0.0],
        [x * 0.9, grip + y * 0.45, foot],
        foot * 0.2,
        BLACK_PLASTIC,
    );
    let ring =
        |z: f32, s: f32, shift: f32| oval(Axis::Z, [0.0, grip + shift * y, z], (x * 0.55 * s, y * 0.22 * s), 1, 14);
    loft(
        b,
        "grip",
        &[ring(foot * 0.9, 1.3, 0.02), ring(h * 0.35, 1.0, 0.0), ring(h * 0.6, 1.0, 0.05), ring(axis, 1.2, 0.1)],
        colour,
    );
    b.lathe_along(
        "body",
        [0.0, -y, axis],
        [0.0, y, axis],
        &[(r * 0.8, 0.0), (r, y * 0.1), (r, y * 0.9), (r * 0.8, y * 1.1)],
        colour,
    );
    b.lathe_along(
        "collar",
        [0.0, 0.0, axis],
        [0.0, y, axis],
        &[(r * 0.82, 0.0), (r * 0.8, y * 0.3), (r * 0.6, y * 0.35)],
        BLACK_PLASTIC,
    );
    b.lathe_along(
        "chuck",
        [0.0, y * 0.3, axis],
        [0.0, y, axis],
        &[(r * 0.62, 0.0), (r * 0.55, y * 0.25), (r * 0.25, y * 0.35)],
        IRON,
    );
    b.rod("bit", [0.0, y * 0.6, axis], [0.0, y, axis], r * 0.12, STEEL);
    b.block("trigger", [-x * 0.2, grip + y * 0.2, h * 0.55], [x * 0.2, grip + y * 0.38, h * 0.68], BLACK_PLASTIC);
    let vents: Vec<(P, P)> = (0..4)
        .map(|i| -y * 0.85 + y * 0.12 * i as f32)
        .map(|v| ([-r * 1.002, v, axis - r * 0.3], [r * 1.002, v + y * 0.05, axis + r * 0.3]))
        .collect();
    blocks(b, "vent", &vents, BLACK_PLASTIC);
}

/// A hand saw: a long blade with teeth and a closed grip.
pub(super) fn saw(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let wood = b.choose(&[BEECH, OAK, RED_PLASTIC, YELLOW_PLASTIC, BLUE_PLASTIC]);
    let grip = -y + y * 0.5;
    let teeth = 26;
    let mut blade = vec![(grip - y * 0.05, h * 0.92), (y, h * 0.4), (y, h * 0.12)];
    for i in 0..=teeth * 2 {
        let t = 1.0 - i as f32 / (teeth * 2) as f32;
        let base = h * (0.1 - 0.05 * t);
        blade.push((grip + (y - grip) * t * 0.995, base - if i % 2 == 0 { 0.0 } else { h * 0.05 }));
    }
    let thin = (x * 0.15).min(0.0015);
    b.prism("blade", Axis::X, [-thin, 0.0, 0.0], &blade, 2.0 * thin, STEEL);
    let line = [
        [0.0, grip + y * 0.02, h * 0.85],
        [0.0, -y * 0.75, h * 0.9],
        [0.0, -y * 0.93, h * 0.75],
        [0.0, -y * 0.82, h * 0.45],
        [0.0, -y * 0.9, h * 0.2],
        [0.0, -y * 0.7, h * 0.1],
        [0.0, grip, h * 0.14],
        [0.0, grip + y * 0.05, h * 0.5],
    ];
    let mut shell = MeshBuilder::default();
    shell.hoop(&line, x.min(h * 0.09).min(y * 0.06));
    shell.put(b, "grip", wood);
}

/// A utility knife with a sliding blade.
pub(super) fn knife(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let grip = b.choose(&GRIPS);
    let body = [
        (-y, h * 0.15),
        (-y * 0.9, 0.0),
        (y * 0.6, 0.0),
        (y * 0.8, h * 0.3),
        (y * 0.8, h * 0.75),
        (-y * 0.8, h),
        (-y, h * 0.7),
    ];
    b.prism("grip", Axis::X, [-x * 0.9, 0.0, 0.0], &body, x * 1.8, grip);
    b.block("rail", [-x, -y * 0.6, h * 0.55], [x, y * 0.6, h * 0.68], STEEL);
    b.slide([0.0, 1.0, 0.0], y * 0.6, |b| {
        let blade = [(y * 0.1, h * 0.4), (y * 0.85, h * 0.4), (y, h * 0.7), (y * 0.1, h * 0.7)];
        b.prism("blade", Axis::X, [-x * 0.08, 0.0, 0.0], &blade, x * 0.16, STEEL);
        b.block("slider", [x * 0.5, -y * 0.2, h * 0.7], [x, y * 0.1, h * 0.8], BLACK_PLASTIC);
    });
}

/// A nail, or a screw with its thread, standing on its head.
pub(super) fn nail(b: &mut Build<'_>) {
    longwise(b, |b, t, w, l| {
        let r = t.min(w) / 2.0;
        let metal = b.choose(&[STEEL, GALVANISED, BRASS]);
        if b.class == "nail" {
            return b.lathe(
                "nail",
                [0.0; 3],
                &[(r, 0.0), (r, l * 0.03), (r * 0.45, l * 0.05), (r * 0.45, l * 0.92), (0.0, l)],
                metal,
            );
        }
        let mut profile = vec![(r, 0.0), (r * 0.5, l * 0.12)];
        for i in 0..10 {
            let z = l * (0.3 + 0.06 * i as f32);
            profile.extend([(r * 0.4, z), (r * 0.62, z + l * 0.03)]);
        }
        profile.extend([(r * 0.4, l * 0.92), (0.0, l)]);
        b.lathe("screw", [0.0; 3], &profile, metal);
    });
}
