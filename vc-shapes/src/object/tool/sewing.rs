//! Equipment for sewing, knitting and laundry.

use vc_graph::portable::Portable;

use crate::material::*;
use crate::solid::{Axis, Build, MeshBuilder, P, blocks, half_dims, hoop, longwise, oval, tube, walled_tray};

const THREADS: [MaterialId; 7] =
    [RED_FABRIC, BLUE_FABRIC, MUSTARD_FABRIC, WHITE_COTTON, GREEN_FABRIC, PURPLE_FABRIC, ROSE_FABRIC];

/// A needle with an eye.
pub(super) fn needle(b: &mut Build<'_>) {
    longwise(b, |b, t, w, l| {
        let r = t.min(w) / 2.0;
        b.lathe("needle", [0.0; 3], &[(0.0, 0.0), (r * 0.8, l * 0.15), (r * 0.9, l * 0.85)], STEEL);
        let eye = oval(Axis::X, [0.0, 0.0, l * 0.92], (r * 0.7, l * 0.075), 0, 10);
        hoop(b, "eye", &eye, r * 0.3, STEEL);
    });
}

/// A reel of thread.
pub(super) fn thread(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let r = x.min(y);
    let (colour, reel) = (b.choose(&THREADS), b.choose(&[BEECH, WHITE_PLASTIC, PINE]));
    let spool = [
        (r, 0.0),
        (r, h * 0.06),
        (r * 0.5, h * 0.14),
        (r * 0.5, h * 0.86),
        (r, h * 0.94),
        (r, h),
        (r * 0.2, h),
        (r * 0.2, h * 0.9),
    ];
    b.lathe("reel", [0.0; 3], &spool, reel);
    let full = b.vary(0.75, 0.95);
    let turns = 9;
    let mut profile = vec![(r * 0.5, h * 0.12)];
    for i in 0..turns {
        let z = h * (0.12 + 0.76 * i as f32 / turns as f32);
        profile.extend([(r * full * 0.96, z + h * 0.01), (r * full, z + h * 0.045), (r * full * 0.96, z + h * 0.08)]);
    }
    profile.push((r * 0.5, h * 0.88));
    b.lathe("thread", [0.0; 3], &profile, colour);
}

/// A button with a rim and four holes.
pub(super) fn button(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let r = x.min(y);
    let mat = b.choose(&[WHITE_PLASTIC, BLACK_PLASTIC, RED_PLASTIC, BROWN_PLASTIC, BLUE_PLASTIC, BRASS]);
    b.lathe(
        "button",
        [0.0; 3],
        &[(r * 0.85, 0.0), (r, h * 0.4), (r, h * 0.8), (r * 0.9, h), (r * 0.75, h * 0.9), (r * 0.7, h * 0.6)],
        mat,
    );
    let hole =
        |sx: f32, sy: f32| ([r * (sx - 0.09), r * (sy - 0.09), h * 0.3], [r * (sx + 0.09), r * (sy + 0.09), h * 0.82]);
    blocks(b, "hole", &[hole(0.25, 0.25), hole(-0.25, 0.25), hole(0.25, -0.25), hole(-0.25, -0.25)], SCREEN);
}

/// A sewing box with a hinged lid, a pin cushion on it and reels inside.
pub(super) fn kit(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let case = b.choose(&[b.style.wood, ROSE_FABRIC, TEAL_FABRIC, PINK_PLASTIC, WICKER]);
    let t = (x * 0.05).min(0.006);
    let rim = h * 0.68;
    walled_tray(b, (x, y), (0.0, rim), t, case);
    let inner = (x - 1.5 * t, y - 1.5 * t);
    b.block("divider", [-inner.0, y * 0.3, t * 0.8], [inner.0, y * 0.3 + t * 0.5, rim * 0.8], PINE);
    b.inside("compartment", [0.0, -y * 0.34, t], (inner.0, inner.1 * 0.62), rim - t);
    let r = (y * 0.14).min(x * 0.3).min(rim * 0.35);
    for (i, px) in [-0.5, 0.4].into_iter().enumerate() {
        let colour = THREADS[i * 2];
        b.cylinder("reel", [x * px, y * 0.65, t * 0.9], r, rim * 0.6, colour);
    }
    b.hinge([-x, 0.0, rim], [0.0, -1.0, 0.0], 1.8, |b| {
        b.rounded_block("lid", [-x, -y, rim + h * 0.002], [x, y, h * 0.88], (h - rim) * 0.2, case);
        let mut cushion = MeshBuilder::default();
        cushion.egg([0.0, 0.0, h * 0.87], [x * 0.55, y * 0.45, h * 0.13]);
        cushion.put(b, "cushion", RED_FABRIC);
    });
}

/// A ball of wool, wound in all directions, with a loose end.
pub(super) fn yarn(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let colour = b.choose(&THREADS);
    let r = x.min(y).min(h / 2.0);
    let at = [0.0, 0.0, r];
    b.ball("ball", at, r * 0.93, colour);
    let mut strands = MeshBuilder::default();
    let thick = r * 0.07;
    for i in 0..7 {
        let (s, c) = (i as f32 * 0.9).sine_cosine();
        let (tilt_s, tilt_c) = (i as f32 * 1.3).sine_cosine();
        let ring: Vec<P> = oval(Axis::Z, [0.0; 3], (r - thick, r - thick), 0, 18)
            .iter()
            .map(|p| {
                let q = [p[0], p[1] * tilt_c, p[1] * tilt_s];
                [at[0] + q[0] * c - q[1] * s, at[1] + q[0] * s + q[1] * c, at[2] + q[2]]
            })
            .collect();
        strands.hoop(&ring, thick);
    }
    strands.put(b, "strand", colour);
    if b.rng.chance(0.5) && y > r * 1.1 {
        let tip = [0.0, (y - thick).min(r * 1.8), thick];
        tube(b, "end", &[[0.0, r * 0.5, r * 0.4], [r * 0.2, r * 0.95, thick], tip], thick, colour);
    }
}

/// A tape measure in its case, with the end of the tape visible.
pub(super) fn tape_measure(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let case = b.choose(&[YELLOW_PLASTIC, RED_PLASTIC, BLACK_PLASTIC, ORANGE_PLASTIC]);
    let tongue = y * 0.12;
    let wide = y - tongue / 2.0;
    b.at([0.0, -tongue / 2.0, 0.0], 0.0, |b| {
        let outline: Vec<(f32, f32)> =
            oval(Axis::X, [0.0, 0.0, h / 2.0], (wide, h / 2.0), 1, 20).iter().map(|p| (p[1], p[2])).collect();
        b.prism("case", Axis::X, [-x * 0.9, 0.0, 0.0], &outline, x * 1.8, case);
        for side in [-1.0_f32, 1.0] {
            b.rod(
                "plate",
                [side * x * 0.85, 0.0, h / 2.0],
                [side * x, 0.0, h / 2.0],
                (h * 0.33).min(wide * 0.7),
                BLACK_PLASTIC,
            );
        }
        b.block("base", [-x * 0.85, 0.0, 0.0], [x * 0.85, wide, h * 0.14], case);
        b.block("tape", [-x * 0.6, wide * 0.9, h * 0.06], [x * 0.6, wide + tongue * 0.85, h * 0.08], YELLOW_CARD);
        b.block("hook", [-x * 0.7, wide + tongue * 0.75, 0.0], [x * 0.7, wide + tongue, h * 0.12], STEEL);
    });
}

/// A clothes peg: two legs and a spring.
pub(super) fn clothespin(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let mat = b.choose(&[PINE, BEECH, BLUE_PLASTIC, RED_PLASTIC, YELLOW_PLASTIC]);
    for side in [-1.0_f32, 1.0] {
        let leg = [
            (side * 0.02 * y, h),
            (side * y * 0.45, h * 0.97),
            (side * y * 0.5, h * 0.5),
            (side * y, 0.0),
            (side * y * 0.6, 0.0),
            (side * 0.02 * y, h * 0.5),
        ];
        b.prism("leg", Axis::X, [-x * 0.8, 0.0, 0.0], &leg, x * 1.6, mat);
    }
    b.rod("spring", [-x, 0.0, h * 0.55], [x, 0.0, h * 0.55], y * 0.28, STEEL);
}
