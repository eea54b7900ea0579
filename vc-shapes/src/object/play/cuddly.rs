//! Animals: sitting soft toys, figures that stand on four legs, and ride-on animals.

use crate::material::*;
use crate::object::palette::*;
use crate::solid::{Axis, Build, CORNERS, P, Proportional, Ring, SIDES, band, coil, oval_outline};

/// A sitting soft toy: a bear or one of several other animals.
pub(super) fn cuddly(b: &mut Build<'_>) {
    let bear = b.class == "teddy_bear";
    let kind = if bear { 0 } else { b.rng.count(1, 5) };
    let fur = match kind {
        0 => b.choose(&[FUR, BROWN_FABRIC, BEIGE_FABRIC, WOOL, RUST_FABRIC]),
        4 => b.choose(&[BLACK_FABRIC, NAVY_FABRIC]),
        5 => b.choose(&[GREEN_FABRIC, TEAL_FABRIC]),
        _ => b.choose(&[GREY_FABRIC, WOOL, ROSE_FABRIC, BEIGE_FABRIC, FUR, MUSTARD_FABRIC]),
    };
    let pale = if fur == WOOL { ROSE_FABRIC } else { WOOL };
    let (plump, head) = (b.vary(0.52, 0.66), b.vary(0.48, 0.56));
    let crown = if kind == 1 { 0.70 } else { 0.96 };
    let tall = crown - 0.5;
    b.ellipsoid("body", [-0.35, 0.0, 0.3], [0.65, plump, 0.3], fur);
    b.ellipsoid("belly", [-0.11, 0.0, 0.28], [0.475, plump * 0.68, 0.215], pale);
    for y in SIDES {
        b.ellipsoid("arm", [0.0, y * 0.66, 0.42], [0.32, 0.34, 0.15], fur);
        b.ellipsoid("leg", [0.4, y * 0.5, 0.13], [0.58, 0.3, 0.13], fur);
        b.ellipsoid("sole", [0.93, y * 0.5, 0.13], [0.06, 0.2, 0.09], pale);
    }
    let low = 0.5 - tall * 0.05;
    b.within([-0.9, -head * 1.25, low], [0.7, head * 1.25, crown], |b| face(b, kind, (fur, pale)));
    if kind == 1 {
        for y in SIDES {
            let rings = [([-0.2, y * 0.16, 0.66], 0.0, 0.0), ([-0.2, y * 0.2, 0.82], 0.12, 0.14)];
            b.skin("ear", Axis::Z, &[rings[0], rings[1], ([-0.25, y * 0.26, 1.0], 0.0, 0.0)], fur);
        }
    }
    if b.rng.chance(0.4) {
        let bow = b.one_of(CLOTHS);
        for y in SIDES {
            b.ellipsoid("bow", [0.15, y * 0.2, 0.53], [0.13, 0.2, 0.055], bow);
        }
        b.ellipsoid("bow", [0.2, 0.0, 0.53], [0.13, 0.08, 0.04], bow);
    }
}

/// A head that fills the size: bear, rabbit, cat, elephant, penguin, frog.
fn face(b: &mut Build<'_>, kind: usize, (fur, pale): (MaterialId, MaterialId)) {
    let top = if matches!(kind, 0 | 2 | 5) { 0.9 } else { 1.0 };
    b.ellipsoid("head", [-0.2, 0.0, top * 0.5], [0.75, 0.8, top * 0.5], fur);
    for y in SIDES {
        let eye = if kind == 5 { [0.0, y * 0.42, 0.88] } else { [0.42, y * 0.3, 0.62 * top] };
        if kind == 5 {
            b.ellipsoid("eye", [-0.1, y * 0.42, 0.84], [0.28, 0.24, 0.16], pale);
        }
        b.ellipsoid("pupil", [eye[0] + 0.1, eye[1], eye[2]], [0.1, 0.09, 0.07], BLACK_PLASTIC);
        match kind {
            0 => {
                b.ellipsoid("ear", [-0.25, y * 0.68, 0.85], [0.2, 0.28, 0.15], fur);
                b.ellipsoid("ear", [-0.12, y * 0.68, 0.84], [0.12, 0.17, 0.1], pale);
            }
            2 => {
                let (x, y0, y1) = (-0.25, y * 0.25, y * 0.72);
                let base = [[x - 0.15, y0, 0.8], [x + 0.15, y0, 0.8], [x - 0.15, y1, 0.62], [x + 0.15, y1, 0.62]];
                b.chunk("ear", &[base[0], base[1], base[2], base[3], [x, y * 0.62, 1.0]], fur);
            }
            3 => b.ellipsoid("ear", [-0.3, y * 0.78, 0.52], [0.12, 0.22, 0.34], pale),
            _ => {}
        }
    }
    match kind {
        3 => {
            let ring = |x: f32, z: f32, r: f32| ([x, 0.0, z], r, r * 0.6);
            let curl = [ring(0.4, 0.42, 0.24), ring(0.75, 0.3, 0.2), ring(0.98, 0.1, 0.14)];
            b.skin("trunk", Axis::X, &curl, fur);
        }
        4 => {
            b.ellipsoid("cheek", [0.1, 0.0, 0.42], [0.5, 0.6, 0.3], pale);
            b.chunk("beak", &[[0.5, 0.22, 0.45], [0.5, -0.22, 0.45], [0.5, 0.0, 0.32], [0.98, 0.0, 0.4]], ORANGE_SKIN);
        }
        5 => b.ellipsoid("mouth", [0.35, 0.0, 0.3], [0.3, 0.45, 0.06], pale),
        _ => {
            b.ellipsoid("muzzle", [0.5, 0.0, 0.34], [0.36, 0.36, 0.2], pale);
            b.ellipsoid("nose", [0.84, 0.0, 0.44], [0.14, 0.13, 0.08], BLACK_PLASTIC);
        }
    }
}

/// Proportions of an animal on four legs, as fractions of its size.
struct Beast {
    /// Height of the belly.
    legs: f32,
    /// X of the rear and of the chest.
    trunk: (f32, f32),
    /// Height of the back.
    back: f32,
    /// Half width of the trunk.
    girth: f32,
    /// Centre of the head, X and Z.
    head: (f32, f32),
    /// Half length, width and height of the head.
    skull: P,
    /// Half thickness of the neck.
    neck: f32,
    /// Radius of a leg, as a fraction of the width.
    leg: f32,
}

const COW: Beast = Beast {
    legs: 0.36,
    trunk: (-0.9, 0.5),
    back: 0.86,
    girth: 0.85,
    head: (0.7, 0.82),
    skull: [0.28, 0.42, 0.16],
    neck: 0.16,
    leg: 0.2,
};
const HORSE: Beast = Beast {
    legs: 0.42,
    trunk: (-0.88, 0.5),
    back: 0.74,
    girth: 0.8,
    head: (0.72, 0.86),
    skull: [0.28, 0.34, 0.1],
    neck: 0.13,
    leg: 0.16,
};
const PIG: Beast = Beast {
    legs: 0.24,
    trunk: (-0.9, 0.6),
    back: 0.96,
    girth: 0.95,
    head: (0.68, 0.66),
    skull: [0.3, 0.6, 0.24],
    neck: 0.24,
    leg: 0.24,
};
const ELEPHANT: Beast = Beast {
    legs: 0.34,
    trunk: (-0.95, 0.4),
    back: 0.98,
    girth: 0.85,
    head: (0.55, 0.76),
    skull: [0.3, 0.5, 0.22],
    neck: 0.2,
    leg: 0.3,
};
const GIRAFFE: Beast = Beast {
    legs: 0.36,
    trunk: (-0.85, 0.45),
    back: 0.6,
    girth: 0.8,
    head: (0.72, 0.9),
    skull: [0.27, 0.34, 0.06],
    neck: 0.09,
    leg: 0.16,
};
const SAUROPOD: Beast = Beast {
    legs: 0.22,
    trunk: (-0.45, 0.35),
    back: 0.62,
    girth: 0.85,
    head: (0.84, 0.93),
    skull: [0.16, 0.34, 0.07],
    neck: 0.09,
    leg: 0.26,
};
const TRICERATOPS: Beast = Beast {
    legs: 0.26,
    trunk: (-0.5, 0.4),
    back: 0.96,
    girth: 0.9,
    head: (0.6, 0.5),
    skull: [0.3, 0.5, 0.2],
    neck: 0.22,
    leg: 0.24,
};

/// Trunk, neck, head, eyes and four legs.
fn beast(b: &mut Build<'_>, shape: &Beast, coat: MaterialId, hoof: MaterialId) {
    let &Beast { legs, trunk: (tail, chest), back, girth, head, skull, neck, leg } = shape;
    let (mid, half) = ((legs + back) / 2.0, (back - legs) / 2.0);
    let ring = |x: f32, share: f32| ([x, 0.0, mid], girth * share, half * share);
    let long = chest - tail;
    let trunk = [
        ([tail, 0.0, mid], 0.0, 0.0),
        ring(tail + long * 0.05, 0.6),
        ring(tail + long * 0.2, 0.95),
        ring(tail + long * 0.5, 0.96),
        ring(tail + long * 0.8, 1.0),
        ring(tail + long * 0.96, 0.6),
        ([chest, 0.0, mid], 0.0, 0.0),
    ];
    b.skin("body", Axis::X, &trunk, coat);
    let (from, to) = ((chest - long * 0.16, mid + half * 0.4), (head.0 - skull[0] * 0.3, head.1));
    let place = |t: f32| ([from.0 + (to.0 - from.0) * t, 0.0, from.1 + (to.1 - from.1) * t], neck);
    let thick = |t: f32, share: f32| (place(t).0, neck * share, girth * 0.5 * share);
    let rings: Vec<Ring> = [(0.0, 1.3), (0.3, 1.1), (0.65, 0.9), (1.0, 0.85)].map(|(t, s)| thick(t, s)).into();
    if to.1 > from.1 + 0.05 {
        let turned: Vec<Ring> = rings.iter().map(|&(c, x, y)| (c, x * 1.2, y)).collect();
        b.skin("neck", Axis::Z, &turned, coat);
    }
    b.ellipsoid("head", [head.0, 0.0, head.1], skull, coat);
    let muzzle = [head.0 + skull[0] * 0.62, 0.0, head.1 - skull[2] * 0.3];
    b.ellipsoid("muzzle", muzzle, [skull[0] * 0.36, skull[1] * 0.7, skull[2] * 0.66], hoof);
    let radius = leg * b.size.y / 2.0;
    for (x, y) in CORNERS {
        let at = if x > 0.0 { chest - long * 0.17 } else { tail + long * 0.17 };
        let reach = radius / b.size.y * 2.0;
        let side = (girth * 0.9 - reach).max(0.0) * y;
        b.pole("leg", [at, side, 0.0], [at, side, mid], radius, coat);
        let foot = b.p([at, side, 0.0]);
        b.cylinder("hoof", foot, radius * 1.12, b.size.z * legs * 0.2, hoof);
    }
    for y in SIDES {
        let eye = [head.0 + skull[0] * 0.3, y * skull[1] * 0.8, head.1 + skull[2] * 0.35];
        b.ellipsoid("eye", eye, [skull[0] * 0.13, skull[1] * 0.16, skull[2] * 0.2], BLACK_PLASTIC);
    }
}

/// Two ears, horns or knobs on a head.
fn ears(b: &mut Build<'_>, shape: &Beast, half: P, mat: MaterialId) {
    let (head, skull) = (shape.head, shape.skull);
    for y in SIDES {
        let at = [head.0 - skull[0] * 0.45, y * (skull[1] * 0.75), head.1 + skull[2] * 0.75];
        b.ellipsoid("ear", at, half, mat);
    }
}

/// A thin hanging tail with a tuft.
fn tail(b: &mut Build<'_>, shape: &Beast, mat: MaterialId) {
    let (x, z) = (shape.trunk.0, shape.back - 0.12);
    let end = (x - 0.06).max(-0.98);
    let hang = [([end, 0.0, shape.legs], 0.05, 0.12), ([end, 0.0, shape.legs + 0.1], 0.035, 0.07)];
    b.skin("tail", Axis::Z, &[hang[0], hang[1], ([x + 0.06, 0.0, z], 0.04, 0.1)], mat);
}

/// A farm or zoo animal of plastic or wood.
pub(super) fn animal(b: &mut Build<'_>) {
    match b.rng.below(5) {
        0 => {
            beast(b, &COW, WHITE_PLASTIC, PINK_PLASTIC);
            ears(b, &COW, [0.06, 0.28, 0.05], BLACK_PLASTIC);
            tail(b, &COW, BLACK_PLASTIC);
            b.ellipsoid("patch", [-0.45, 0.0, 0.68], [0.3, 0.86, 0.14], BLACK_PLASTIC);
            b.ellipsoid("patch", [0.15, 0.0, 0.72], [0.2, 0.83, 0.12], BLACK_PLASTIC);
        }
        1 => {
            let coat = b.choose(&[BROWN_PLASTIC, BLACK_PLASTIC, WHITE_PLASTIC, BEECH]);
            beast(b, &HORSE, coat, BLACK_PLASTIC);
            ears(b, &HORSE, [0.05, 0.12, 0.06], coat);
            tail(b, &HORSE, CHOCOLATE);
            b.chunk("mane", &mane(&HORSE), CHOCOLATE);
        }
        2 => {
            let wool = b.rng.chance(0.5);
            let (coat, dark) = if wool { (WOOL, BLACK_PLASTIC) } else { (PINK_PLASTIC, DUSTY_ROSE) };
            beast(b, &PIG, coat, dark);
            ears(b, &PIG, [0.07, 0.16, 0.1], dark);
        }
        3 => elephant(b, GREY_PLASTIC),
        _ => {
            beast(b, &GIRAFFE, YELLOW_PLASTIC, BROWN_PLASTIC);
            ears(b, &GIRAFFE, [0.04, 0.1, 0.05], BROWN_PLASTIC);
            tail(b, &GIRAFFE, BROWN_PLASTIC);
            for (x, z) in [(-0.55, 0.52), (-0.2, 0.5), (0.15, 0.53)] {
                b.ellipsoid("spot", [x, 0.0, z], [0.11, 0.82, 0.04], BROWN_PLASTIC);
            }
        }
    }
}

/// Corners of a mane along the back of the neck.
fn mane(shape: &Beast) -> Vec<P> {
    let (x, z) = (shape.trunk.1 - 0.35, shape.back - 0.06);
    let (hx, hz) = (shape.head.0 - shape.skull[0] * 0.8, shape.head.1 + shape.skull[2]);
    let line = [(x, z), (x + 0.2, z), (hx - 0.02, hz), (hx + 0.2, hz)];
    SIDES.iter().flat_map(|y| line.map(|(x, z)| [x, y * 0.1, z])).collect()
}

fn elephant(b: &mut Build<'_>, skin: MaterialId) {
    beast(b, &ELEPHANT, skin, LIGHT_GREY);
    let (x, z) = (ELEPHANT.head.0, ELEPHANT.head.1);
    let ring = |x: f32, z: f32, r: f32| ([x, 0.0, z], r, r * 2.0);
    b.skin("trunk", Axis::Z, &[ring(0.93, 0.2, 0.07), ring(0.88, 0.45, 0.08), ring(x + 0.2, z, 0.12)], skin);
    for y in SIDES {
        b.ellipsoid("ear", [x - 0.1, y * 0.62, z], [0.24, 0.1, 0.2], skin);
        let tusk = [([x + 0.2, y * 0.35, z - 0.15], 0.08, 0.03), ([1.0, y * 0.35, z - 0.2], 0.0, 0.0)];
        b.skin("tusk", Axis::X, &tusk, WHITE_PLASTIC);
    }
}

/// A dinosaur: a tyrannosaur on two legs, a long-necked one or a horned one.
pub(super) fn dinosaur(b: &mut Build<'_>) {
    let skin = b.choose(&[GREEN_PLASTIC, ORANGE_PLASTIC, BROWN_PLASTIC, BLUE_PLASTIC, PURPLE_PLASTIC, GREY_PLASTIC]);
    let pale = b.choose(&[YELLOW_PLASTIC, CREAM]);
    let kind = b.rng.below(3);
    if kind == 0 {
        tyrannosaur(b, skin, pale);
        return;
    }
    let shape = if kind == 1 { &SAUROPOD } else { &TRICERATOPS };
    beast(b, shape, skin, pale);
    let mid = (shape.legs + shape.back) / 2.0;
    let ring = |x: f32, z: f32, share: f32| ([x, 0.0, z], share * shape.girth, share * (shape.back - shape.legs) / 2.0);
    b.skin("tail", Axis::X, &[ring(-0.3, mid, 0.85), ring(-0.65, mid * 0.8, 0.4), ([-1.0, 0.0, 0.12], 0.0, 0.0)], skin);
    if kind == 2 {
        let crest = oval_outline((0.0, 0.62), (0.85, 0.36), 12);
        b.front_outline("frill", (0.3, 0.4), &crest, pale);
        for (y, z, x) in [(-0.3, 0.68, 0.95), (0.3, 0.68, 0.95), (0.0, 0.52, 1.0)] {
            b.skin("horn", Axis::X, &[([0.6, y, z - 0.1], 0.12, 0.05), ([x, y, z], 0.0, 0.0)], WHITE_PLASTIC);
        }
    } else {
        for i in 0..5 {
            let x = -0.4 + 0.17 * i as f32;
            b.ellipsoid("stripe", [x, 0.0, shape.back - 0.1], [0.05, 0.5, 0.1], pale);
        }
    }
}

fn tyrannosaur(b: &mut Build<'_>, skin: MaterialId, pale: MaterialId) {
    let ring = |x: f32, z: f32, y: f32, h: f32| ([x, 0.0, z], y, h);
    let trunk = [
        ([-1.0, 0.0, 0.34], 0.0, 0.0),
        ring(-0.6, 0.4, 0.28, 0.07),
        ring(-0.25, 0.48, 0.6, 0.16),
        ring(0.05, 0.52, 0.72, 0.2),
        ring(0.3, 0.64, 0.55, 0.16),
        ring(0.42, 0.78, 0.38, 0.12),
        ([0.5, 0.0, 0.86], 0.0, 0.0),
    ];
    b.skin("body", Axis::X, &trunk, skin);
    b.ellipsoid("head", [0.6, 0.0, 0.88], [0.34, 0.5, 0.115], skin);
    b.chunk("jaw", &jaw(0.86, 0.82), skin);
    b.chunk("teeth", &jaw(0.81, 0.79), WHITE_PLASTIC);
    b.chunk("jaw", &jaw(0.785, 0.74), pale);
    for y in SIDES {
        b.ellipsoid("eye", [0.62, y * 0.4, 0.94], [0.06, 0.1, 0.035], BLACK_PLASTIC);
        b.ellipsoid("thigh", [-0.1, y * 0.66, 0.36], [0.24, 0.3, 0.18], skin);
        b.chunk("shin", &limb([-0.15, y * 0.7, 0.28], [-0.02, y * 0.7, 0.04], 0.09), skin);
        b.ellipsoid("foot", [0.08, y * 0.7, 0.04], [0.26, 0.28, 0.04], pale);
        b.chunk("arm", &limb([0.32, y * 0.5, 0.62], [0.55, y * 0.5, 0.5], 0.05), skin);
    }
    for i in 0..6 {
        let t = i as f32 / 5.0;
        let (x, z) = (-0.7 + t * 0.95, 0.44 + t * t * 0.32);
        b.chunk(
            "spine",
            &[[x - 0.07, 0.05, z], [x - 0.07, -0.05, z], [x + 0.07, 0.0, z], [x - 0.05, 0.0, z + 0.1]],
            pale,
        );
    }
}

fn jaw(top: f32, bottom: f32) -> Vec<P> {
    let outline = [(0.45, 0.4), (0.9, 0.34), (0.98, 0.15)];
    let sides = outline.iter().flat_map(|&(x, y)| [[x, y, top], [x, -y, top], [x, y, bottom], [x, -y, bottom]]);
    sides.collect()
}

/// Corners of a square limb between two positions.
fn limb(from: P, to: P, half: f32) -> Vec<P> {
    let ends = [(from, half), (to, half * 0.8)];
    ends.iter().flat_map(|&(e, h)| CORNERS.map(|(x, y)| [e[0] + h * x, e[1] + h * y * 1.6, e[2]])).collect()
}

/// A horse on two curved runners, with saddle and grips.
pub(super) fn rocking_horse(b: &mut Build<'_>) {
    let wooden = b.rng.chance(0.5);
    let (coat, dark) =
        if wooden { (b.one_of(TOY_WOODS), WALNUT) } else { (b.choose(&[FUR, BROWN_FABRIC, WOOL]), BROWN_LEATHER) };
    let runner = if wooden { coat } else { b.style.wood };
    let curve: Vec<_> = (0..9).map(|i| i as f32 / 4.0 - 1.0).map(|x| (x, 0.16 * x * x)).collect();
    for y in SIDES {
        let edge = (y * 0.9 - 0.1, y * 0.9 + 0.1);
        b.side_outline("runner", edge, &band(&curve, (0.0, 0.07)), runner);
    }
    for x in [-0.48, 0.33] {
        b.slab("crossbar", [x - 0.07, -0.9, 0.075], [x + 0.07, 0.9, 0.115], runner);
    }
    b.within([-0.78, -0.9, 0.11], [0.98, 0.9, 1.0], |b| mount(b, coat, dark));
}

/// A ride-on horse with saddle, mane and grips.
fn mount(b: &mut Build<'_>, coat: MaterialId, dark: MaterialId) {
    const MOUNT: Beast = Beast {
        legs: 0.34,
        trunk: (-0.9, 0.5),
        back: 0.64,
        girth: 0.55,
        head: (0.68, 0.86),
        skull: [0.31, 0.26, 0.1],
        neck: 0.16,
        leg: 0.15,
    };
    beast(b, &MOUNT, coat, dark);
    ears(b, &MOUNT, [0.06, 0.1, 0.06], coat);
    b.chunk("mane", &mane(&MOUNT), dark);
    tail(b, &MOUNT, dark);
    let cloth = b.one_of(CLOTHS);
    b.ellipsoid("saddle", [-0.3, 0.0, 0.62], [0.36, 0.6, 0.06], cloth);
    let grip = b.size.z * 0.018;
    b.pole("grip", [0.56, -0.75, 0.78], [0.56, 0.75, 0.78], grip, b.style.wood);
}

/// A ride-on spring toy with an animal or a flat cut-out of one.
pub(super) fn spring_rider(b: &mut Build<'_>) {
    let paint = b.one_of(PAINTS);
    let other = b.choose(&[YELLOW, WHITE, RED, GREEN]);
    let r = (b.size.y * 0.3).min(b.size.x * 0.2);
    b.slab("plate", [-0.3, -0.6, 0.0], [0.3, 0.6, 0.02], GALVANISED);
    let base = b.p([0.0, 0.0, 0.018]);
    coil(b, "spring", base, (r * 0.8, r * 0.12), b.size.z * 0.319, IRON);
    b.slab("plate", [-0.35, -0.5, 0.335], [0.35, 0.5, 0.36], GALVANISED);
    if b.rng.chance(0.5) {
        b.within([-1.0, -0.9, 0.2], [1.0, 0.9, 1.0], |b| mount_flat(b, paint, other));
        return;
    }
    for y in SIDES {
        let edge = (y * 0.5 - 0.06, y * 0.5 + 0.06);
        let outline = [(-0.95, 0.42), (-0.6, 0.355), (0.5, 0.355), (0.8, 0.5), (0.95, 0.8), (0.75, 0.98), (0.45, 0.95)];
        let back = [(0.3, 0.62), (-0.3, 0.56), (-0.7, 0.68), (-0.95, 0.6)];
        b.side_outline("side", edge, &[outline.as_slice(), &back].concat(), paint);
        b.wheel("eye", Axis::Y, [0.66, y * 0.57, 0.86], (b.size.z * 0.03, 0.006), WHITE);
    }
    b.pad("seat", [-0.62, -0.56, 0.52], [0.2, 0.56, 0.565], 0.01, other);
    b.pole("grip", [0.45, -0.95, 0.8], [0.45, 0.95, 0.8], 0.014, IRON);
    b.pole("footrest", [0.2, -0.95, 0.42], [0.2, 0.95, 0.42], 0.014, IRON);
}

/// The plump body of a duck or fish with a dip for the seat.
fn mount_flat(b: &mut Build<'_>, paint: MaterialId, beak: MaterialId) {
    b.ellipsoid("body", [-0.15, 0.0, 0.38], [0.83, 0.7, 0.2], paint);
    b.ellipsoid("head", [0.5, 0.0, 0.78], [0.36, 0.55, 0.2], paint);
    b.skin("neck", Axis::Z, &[([0.4, 0.0, 0.4], 0.25, 0.45), ([0.46, 0.0, 0.7], 0.22, 0.4)], paint);
    b.ellipsoid("beak", [0.85, 0.0, 0.74], [0.15, 0.3, 0.05], beak);
    b.chunk("tail", &[[-0.7, 0.4, 0.44], [-0.7, -0.4, 0.44], [-1.0, 0.0, 0.7], [-0.8, 0.0, 0.3]], paint);
    b.pad("seat", [-0.55, -0.4, 0.54], [0.1, 0.4, 0.61], 0.01, beak);
    for y in SIDES {
        b.ellipsoid("eye", [0.66, y * 0.42, 0.86], [0.07, 0.12, 0.04], BLACK);
    }
    b.pole("grip", [0.45, -1.05, 0.66], [0.45, 1.05, 0.66], 0.014, IRON);
    b.pole("footrest", [0.2, -1.05, 0.24], [0.2, 1.05, 0.24], 0.014, IRON);
}
