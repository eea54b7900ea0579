//! Rackets, bats, clubs and sticks.

use vc_graph::portable::Portable;

use crate::material::*;
use crate::solid::{Axis, Build, P, Proportional, SIDES, oval_outline, seam};

/// A strung racket standing on its grip: tennis, squash or badminton.
pub(super) fn racket(b: &mut Build<'_>) {
    let light = b.class == "badminton_racket" || (b.class == "racket" && b.rng.chance(0.5));
    let (frame, grip) =
        (b.choose(&[BLACK, RED, BLUE, WHITE, ORANGE, GREEN]), b.choose(&[BLACK_LEATHER, WHITE_LEATHER, BLUE_FABRIC]));
    let r = b.size.x / 2.0;
    let rim = (r * 0.8).min(if light { 0.0045 } else { 0.009 });
    let head = if light { 0.36 } else { 0.47 };
    let (y, z) = (1.0 - 2.0 * rim / b.size.y, 1.0 - head / 2.0 - rim / b.size.z * 0.5);
    let half = (head / 2.0) - rim / b.size.z * 0.5;
    let curve: Vec<P> = oval_outline((0.0, z), (y, half), 28).iter().map(|&(y, z)| b.p([0.0, y, z])).collect();
    let middle = b.p([0.0, 0.0, z]);
    seam(b, "frame", middle, &curve, rim, frame);
    let string = (rim * 0.16).max(0.0006);
    for i in 0..9 {
        let t = -0.8 + 0.2 * i as f32;
        let reach = (1.0 - t * t).sqrt();
        string_between(b, [0.0, t * y, z - half * reach], [0.0, t * y, z + half * reach], (string, 0.9));
        string_between(b, [0.0, -y * reach, z + t * half], [0.0, y * reach, z + t * half], (string, -0.9));
    }
    let low = z - half;
    if light {
        b.pole("shaft", [0.0, 0.0, 0.2], [0.0, 0.0, low], rim * 0.8, frame);
    } else {
        for s in SIDES {
            b.plank(
                "throat",
                [0.0, s * y * 0.5, low + head * 0.06],
                [0.0, s * 0.06, 0.34],
                (rim * 1.8, rim * 1.5),
                frame,
            );
        }
    }
    let thick = r.min(if light { 0.013 } else { 0.016 });
    let top = if light { 0.26 } else { 0.36 };
    b.pole("grip", [0.0, 0.0, 0.0], [0.0, 0.0, top], thick * 0.92, grip);
    b.pole("butt", [0.0, 0.0, 0.0], [0.0, 0.0, 0.03], thick, BLACK_PLASTIC);
}

/// A straight string; `section` is half its thickness, and its offset to the front as a multiple of that.
fn string_between(b: &mut Build<'_>, from: P, to: P, (half, front): (f32, f32)) {
    let (low, high) = (b.p(from), b.p(to));
    let corner = |p: P, by: f32| [p[0] + half * front + by, p[1] + by, p[2] + by];
    b.block("string", corner(low, -half), corner(high, half), WHITE_PLASTIC);
}

/// A table tennis bat, red on one side and black on the other.
pub(super) fn paddle(b: &mut Build<'_>) {
    let wood = b.choose(&[BEECH, MAPLE, BIRCH]);
    let blade = oval_outline((0.0, 0.67), (1.0, 0.33), 24);
    b.front_outline("blade", (-0.25, 0.25), &blade, wood);
    let rubber: Vec<_> =
        blade.iter().map(|&(y, z)| (y * 0.985, 0.67 + (z - 0.67) * 0.985)).filter(|p| p.1 > 0.41).collect();
    b.front_outline("rubber", (0.24, 0.6), &rubber, RED_RUBBER);
    b.front_outline("rubber", (-0.6, -0.24), &rubber, RUBBER);
    b.pad("handle", [-1.0, -0.18, 0.0], [1.0, 0.18, 0.4], 0.008, wood);
    b.front_outline("neck", (-0.24, 0.24), &[(-0.17, 0.3), (0.17, 0.3), (0.6, 0.5), (-0.6, 0.5)], wood);
}

/// A shuttlecock standing on its feathers with the cork up.
pub(super) fn shuttlecock(b: &mut Build<'_>) {
    let (r, h) = (b.size.x.min(b.size.y) / 2.0, b.size.z);
    let cork = r * 0.42;
    let skirt = [(r * 0.96, 0.0), (cork * 0.85, h * 0.7), (cork * 0.78, h * 0.7), (r * 0.9, 0.0), (r * 0.96, 0.0)];
    b.lathe("feathers", [0.0; 3], &skirt, WHITE_PAPER);
    for i in 0..12 {
        let (s, c) = (std::f32::consts::TAU * i as f32 / 12.0).sine_cosine();
        b.hull("quill", &quill((s, c), r, cork, h), WHITE_PLASTIC);
    }
    for z in [0.3, 0.45] {
        b.torus("thread", Axis::Z, [0.0, 0.0, z], (r * (0.96 - z * 0.78), r * 0.03), GREEN_PLASTIC);
    }
    b.lathe(
        "cork",
        [0.0, 0.0, h * 0.68],
        &[(cork, 0.0), (cork, h * 0.14), (cork * 0.8, h * 0.26), (cork * 0.4, h * 0.315), (0.0, h * 0.32)],
        CORK,
    );
    b.cylinder("band", [0.0, 0.0, h * 0.7], cork * 1.03, h * 0.05, GREEN_PLASTIC);
}

fn quill((s, c): (f32, f32), r: f32, cork: f32, h: f32) -> Vec<P> {
    let at = |out: f32, side: f32, z: f32| [out * c - side * s, out * s + side * c, z];
    let w = r * 0.03;
    vec![
        at(r * 0.99, w, 0.0),
        at(r * 0.99, -w, 0.0),
        at(r * 0.9, 0.0, 0.0),
        at(cork * 0.9, w, h * 0.7),
        at(cork * 0.9, -w, h * 0.7),
        at(cork * 0.7, 0.0, h * 0.7),
    ]
}

/// A baseball bat standing on its knob.
pub(super) fn bat(b: &mut Build<'_>) {
    let (mat, grip) =
        (b.choose(&[ASH, MAPLE, BLACK, ALUMINIUM, CHERRY]), b.choose(&[BLACK_LEATHER, WHITE_LEATHER, RED_FABRIC]));
    let (r, h) = (b.size.x.min(b.size.y) / 2.0, b.size.z);
    let thin = r * 0.4;
    let shape = [
        (thin * 1.7, 0.0),
        (thin * 1.8, h * 0.012),
        (thin, h * 0.035),
        (thin, h * 0.35),
        (r * 0.72, h * 0.58),
        (r * 0.96, h * 0.75),
        (r, h * 0.9),
        (r * 0.95, h * 0.97),
        (r * 0.7, h * 0.995),
        (0.0, h),
    ];
    b.lathe("bat", [0.0; 3], &shape, mat);
    b.cylinder("grip", [0.0, 0.0, h * 0.04], thin * 1.1, h * 0.28, grip);
    b.cylinder("label", [0.0, 0.0, h * 0.77], r * 1.0, h * 0.02, grip);
}

/// A golf club standing on its head: iron, driver or putter.
pub(super) fn golf_club(b: &mut Build<'_>) {
    let kind = b.rng.below(3);
    let heel = (0.0, -0.7);
    b.pole("shaft", [-0.3, heel.1, 0.004], [-0.3, heel.1, 0.78], 0.0055, STEEL);
    b.pole("grip", [-0.3, heel.1, 0.74], [-0.3, heel.1, 1.0], 0.011_f32.min(b.size.x * 0.15), RUBBER);
    b.pole("ferrule", [-0.3, heel.1, 0.04], [-0.3, heel.1, 0.1], 0.008, BLACK_PLASTIC);
    match kind {
        0 => {
            let face = [(-0.8, 0.0), (0.85, 0.0), (1.0, 0.07), (0.8, 0.085), (-0.8, 0.045)];
            let tall = 0.09 / b.size.z.max(0.2);
            let face: Vec<_> = face.iter().map(|&(y, z)| (y, z * tall / 0.085)).collect();
            b.front_outline("head", (-0.6, -0.1), &face, CHROME);
            b.slab("sole", [-0.95, -0.75, 0.0], [0.1, 0.85, 0.012], STEEL);
        }
        1 => {
            b.ellipsoid("head", [0.0, 0.1, 0.03], [0.98, 0.9, 0.03], BLACK);
            b.slab("face", [-0.3, 0.0, 0.012], [0.3, 0.98, 0.045], CHROME);
        }
        _ => b.pad("head", [-0.55, -0.9, 0.0], [0.2, 1.0, 0.03], 0.004, STEEL),
    }
    b.slab("base", [-0.4, -0.85, 0.0], [1.0, -0.55, 0.006], BLACK_PLASTIC);
}

/// A golf bag: a tube with dividers, pockets, a strap and clubs.
pub(super) fn golf_bag(b: &mut Build<'_>) {
    let (cloth, trim) =
        (b.choose(&[BLACK_FABRIC, NAVY_FABRIC, RED_FABRIC, WHITE_LEATHER, GREEN_FABRIC]), b.style.accent);
    let rim = 0.72;
    let r = (b.size.y * 0.42).min(b.size.x * 0.36);
    let at = [-b.size.x / 2.0 + r + 0.01, 0.0, 0.0];
    let h = b.size.z;
    let wall = [
        (r * 0.9, 0.0),
        (r * 0.95, h * 0.06),
        (r * 0.9, h * 0.1),
        (r * 0.92, h * 0.62),
        (r, h * rim),
        (r * 0.9, h * rim),
        (r * 0.82, h * 0.6),
        (r * 0.8, h * 0.03),
    ];
    b.lathe("bag", at, &wall, cloth);
    b.inside("inside", [at[0], at[1], h * 0.03], (r * 0.5, r * 0.2), h * 0.6);
    b.lathe(
        "rim",
        [at[0], at[1], h * (rim - 0.04)],
        &[(r * 0.9, 0.0), (r * 1.03, 0.0), (r * 1.03, h * 0.045), (r * 0.9, h * 0.045), (r * 0.9, 0.0)],
        trim,
    );
    let front = (at[0] + r * 0.6) / b.size.x * 2.0;
    let deep = (0.98 - front).min(r * 1.6 / b.size.x * 2.0);
    b.pad("pocket", [front, -0.55, 0.002], [front + deep, 0.55, 0.3], 0.03, trim);
    b.pad("pocket", [front, -0.5, 0.36], [front + deep * 0.7, 0.5, 0.58], 0.03, cloth);
    let ax = at[0] / b.size.x * 2.0;
    let (near, far) = (1.8 * r / b.size.y, 2.26 * r / b.size.y);
    let strap = [[ax, near, 0.3], [ax, far, 0.42], [ax, far, 0.56], [ax, near, 0.66]];
    for pair in strap.windows(2) {
        b.plank("strap", pair[0], pair[1], (0.04, 0.01), BLACK_FABRIC);
    }
    for (i, (x, y)) in [(0.3, 0.5), (-0.3, 0.55), (0.4, -0.4), (-0.35, -0.5), (0.0, 0.62)].into_iter().enumerate() {
        let top = h * (0.82 + 0.035 * i as f32);
        let foot = [at[0] + x * r, y * r, h * 0.028];
        b.rod("club", foot, [foot[0], foot[1], top], 0.005, STEEL);
        if i % 2 == 0 {
            b.block(
                "iron",
                [foot[0] - 0.012, foot[1] - 0.01, top - 0.01],
                [foot[0] + 0.012, foot[1] + 0.05, top + h * 0.03],
                CHROME,
            );
        } else {
            b.lathe(
                "wood",
                [foot[0], foot[1], top - 0.01],
                &[(0.01, 0.0), (0.03, h * 0.02), (0.028, h * 0.035), (0.0, h * 0.04)],
                BLACK,
            );
        }
    }
}

/// An ice hockey stick standing on its blade.
pub(super) fn hockey_stick(b: &mut Build<'_>) {
    let mat = b.choose(&[ASH, BLACK, RED, BLUE]);
    let w = (b.size.x * 0.35).min(0.012);
    let blade = 0.075 / b.size.z.max(0.3);
    b.plank("shaft", [0.0, -0.6, blade * 0.5], [0.0, -0.9, 1.0 - 0.012 / b.size.z], (w, 0.026), mat);
    b.chunk(
        "blade",
        &[
            [-0.4, -0.75, 0.0],
            [0.4, -0.75, 0.0],
            [-0.4, -0.65, blade],
            [0.4, -0.65, blade],
            [0.1, 1.0, 0.0],
            [0.9, 1.0, 0.0],
            [0.1, 1.0, blade * 0.9],
            [0.9, 1.0, blade * 0.9],
        ],
        BLACK_FABRIC,
    );
    b.plank("tape", [0.0, -0.85, 0.84], [0.0, -0.899, 0.995], (w * 1.25, 0.029), WHITE_COTTON);
}
