//! Pets, facing the front.

use crate::material::*;
use crate::solid::{Axis, Build, MeshBuilder, P, half_dims, loft, mix, oval, spline};

/// Proportions of a standing animal, as fractions of its length, width and height.
struct Beast {
    /// Heights of belly and back.
    belly: f32,
    back: f32,
    /// Half the thickness of a leg, as a fraction of the half width.
    leg: f32,
    /// Length and height of the head; `muzzle` is the muzzle's length.
    head: (f32, f32),
    muzzle: f32,
    ears: Ears,
    tail: [(f32, f32); 3],
}

#[derive(Clone, Copy, PartialEq)]
enum Ears {
    Pointed,
    Hanging,
}

/// Colours of the coat, and of chest, paws and muzzle.
fn coats(b: &mut Build<'_>) -> (MaterialId, MaterialId) {
    b.choose(&[
        (FUR, WHITE_COTTON),
        (BLACK_FABRIC, WHITE_COTTON),
        (GREY_FABRIC, WHITE_COTTON),
        (RUST_FABRIC, WOOL),
        (BROWN_FABRIC, FUR),
        (WOOL, BEIGE_FABRIC),
        (CHARCOAL_FABRIC, GREY_FABRIC),
        (BLACK_FABRIC, FUR),
    ])
}

/// A cat: standing, sitting or lying.
pub(super) fn cat(b: &mut Build<'_>) {
    let (coat, trim) = coats(b);
    match b.rng.below(3) {
        0 => sitting(b, coat, trim),
        1 => lying(b, coat, trim),
        _ => {
            let tail = [(-0.8, 0.85), (-0.97, 0.95), (-0.9, 1.0)];
            let beast =
                Beast { belly: 0.38, back: 0.72, leg: 0.2, head: (0.2, 0.4), muzzle: 0.03, ears: Ears::Pointed, tail };
            standing(b, &beast, (coat, trim));
        }
    }
}

/// A dog: standing, sitting or lying, with pointed or hanging ears.
pub(super) fn dog(b: &mut Build<'_>) {
    let (coat, trim) = coats(b);
    let ears = b.choose(&[Ears::Pointed, Ears::Hanging, Ears::Hanging]);
    if b.rng.chance(0.25) {
        return sitting(b, coat, trim);
    }
    let tail = b.choose(&[[(-0.85, 0.75), (-0.96, 0.9), (-0.98, 1.0)], [(-0.9, 0.6), (-0.97, 0.45), (-0.98, 0.3)]]);
    let (belly, muzzle) = (b.vary(0.36, 0.48), b.vary(0.1, 0.15));
    let beast = Beast { belly, back: 0.76, leg: b.vary(0.2, 0.26), head: (0.2, 0.34), muzzle, ears, tail };
    standing(b, &beast, (coat, trim));
    if b.rng.chance(0.5) {
        let (x, y, h) = half_dims(b);
        let ring = oval(Axis::X, [x * 0.46, 0.0, h * 0.7], (y * 0.62, h * 0.17), 0, 16);
        let collar = b.choose(&[RED_FABRIC, BLUE_FABRIC, BROWN_LEATHER]);
        crate::solid::hoop(b, "collar", &ring, y * 0.07, collar);
    }
}

/// A standing animal on four legs.
fn standing(b: &mut Build<'_>, beast: &Beast, (coat, trim): (MaterialId, MaterialId)) {
    let (x, y, h) = half_dims(b);
    let Beast { belly, back, leg, head, muzzle, .. } = *beast;
    let (mid, deep) = (f32::midpoint(belly, back), (back - belly) / 2.0);
    let ring = |t: f32, w: f32, z: f32, s: f32| oval(Axis::X, [x * t, 0.0, h * z], (y * w, h * s), 0, 14);
    let rings = [
        ring(-0.9, 0.15, mid + deep * 0.4, deep * 0.2),
        ring(-0.82, 0.62, mid + deep * 0.1, deep * 0.75),
        ring(-0.6, 0.82, mid, deep * 0.98),
        ring(-0.2, 0.78, mid + deep * 0.1, deep * 0.85),
        ring(0.2, 0.88, mid - deep * 0.02, deep),
        ring(0.4, 0.74, mid + deep * 0.2, deep * 0.95),
        ring(0.55, 0.46, mid + deep * 0.9, deep * 0.75),
        ring(0.66, 0.3, mid + deep * 1.5, deep * 0.5),
    ];
    loft(b, "body", &rings, coat);
    let (mut legs, mut paws) = (MeshBuilder::default(), MeshBuilder::default());
    let stride = b.vary(-0.06, 0.06);
    for (px, side, knee) in [(-0.68, -1.0, -0.1), (-0.68, 1.0, -0.1), (0.3, -1.0, 0.02), (0.3, 1.0, 0.02)] {
        let (py, step) = (side * y * 0.52, stride * side);
        let foot = [x * (px + step), py, h * 0.03];
        let hip = [x * px, py * 0.9, h * mid];
        let bend = [x * (px + knee + step), py, h * belly * 0.5];
        let ankle = [foot[0], py, h * 0.08];
        legs.tapered(&[hip, bend, ankle, foot], |t| y * leg * (1.35 - 0.5 * t));
        paws.egg([foot[0] + y * leg * 0.4, py, h * 0.03], [y * leg * 1.3, y * leg * 1.05, h * 0.03]);
    }
    let way: Vec<P> = [(-0.8, back - 0.1)].iter().chain(&beast.tail).map(|&(t, z)| [x * t, 0.0, h * z]).collect();
    let thick = y * leg * 0.5;
    let way: Vec<P> = way.iter().map(|p| [p[0].max(-x + thick), p[1], p[2].min(h - thick)]).collect();
    legs.tapered(&spline(&way, 4), |t| thick * (1.0 - 0.5 * t));
    legs.put(b, "leg", coat);
    paws.put(b, "paw", trim);
    let size = [x * head.0, y * 0.58, (h * head.1 / 2.0).min(x * head.0 * 1.1)];
    let nose = if muzzle > 0.05 { x * muzzle * 2.0 } else { x * 0.05 };
    let at = [x - nose - size[0] * 0.8, 0.0, h - size[2] * 1.27];
    face(b, at, size, nose, (coat, trim), beast.ears);
}

/// A head: skull, muzzle, nose, eyes and ears.
fn face(b: &mut Build<'_>, at: P, size: P, nose: f32, (coat, trim): (MaterialId, MaterialId), ears: Ears) {
    let on = |u: f32, v: f32, w: f32| [at[0] + size[0] * u, at[1] + size[1] * v, at[2] + size[2] * w];
    let mut skull = MeshBuilder::default();
    skull.egg(at, size);
    for side in [-1.0, 1.0] {
        if ears == Ears::Pointed {
            let (root, tip) = (on(-0.1, side * 0.5, 0.6), on(-0.05, side * 0.68, 1.25));
            skull.tapered(&[root, mix(root, tip, 0.6), tip], |t| size[1] * 0.3 * (1.02 - t));
        } else {
            let (root, tip) = (on(-0.2, side * 0.75, 0.6), on(-0.2, side * 1.15, -0.6));
            skull.tapered(&[root, mix(root, tip, 0.5), tip], |t| size[1] * (0.12 + 0.18 * t - 0.2 * t * t));
        }
    }
    skull.put(b, "head", coat);
    let front = at[0] + size[0] * 0.8 + nose;
    let mut muzzle = MeshBuilder::default();
    let low = at[2] - size[2] * 0.32;
    muzzle.egg([front - nose, 0.0, low], [nose, size[1] * 0.48, size[2] * 0.42]);
    muzzle.put(b, "muzzle", trim);
    let mut dark = MeshBuilder::default();
    let dot = size[1] * 0.13;
    dark.egg([front - dot, 0.0, low + size[2] * 0.2], [dot, dot * 1.2, dot]);
    [-1.0, 1.0].iter().for_each(|s| dark.egg(on(0.72, s * 0.45, 0.28), [dot, dot, dot]));
    dark.put(b, "eye", BLACK_PLASTIC);
}

/// A sitting cat or dog that fills the size.
pub(in crate::object) fn sitting(b: &mut Build<'_>, coat: MaterialId, trim: MaterialId) {
    let (x, y, h) = half_dims(b);
    let deep = x.min(h * 0.45);
    let ring =
        |t: f32, dx: f32, dy: f32, shift: f32| oval(Axis::Z, [deep * shift, 0.0, h * t], (deep * dx, y * dy), 0, 14);
    let rings = [
        ring(0.0, 0.6, 0.8, -0.25),
        ring(0.08, 0.7, 0.95, -0.2),
        ring(0.25, 0.6, 0.85, -0.15),
        ring(0.45, 0.44, 0.62, 0.05),
        ring(0.6, 0.3, 0.45, 0.15),
        ring(0.68, 0.2, 0.3, 0.15),
    ];
    loft(b, "body", &rings, coat);
    let (mut legs, mut paws) = (MeshBuilder::default(), MeshBuilder::default());
    let slim = y.min(h * 0.3);
    for side in [-1.0, 1.0] {
        let foot = [deep * 0.5, side * y * 0.35, h * 0.03];
        legs.tapered(&[[deep * 0.3, side * y * 0.35, h * 0.45], [deep * 0.45, side * y * 0.35, h * 0.2], foot], |t| {
            slim * (0.24 - 0.08 * t)
        });
        legs.egg([0.0, side * y * 0.68, h * 0.12], [deep * 0.5, y * 0.3, h * 0.12]);
        paws.egg([deep * 0.6, side * y * 0.35, h * 0.03], [deep * 0.2, y * 0.2, h * 0.03]);
        paws.egg([deep * 0.4, side * y * 0.75, h * 0.03], [deep * 0.25, y * 0.2, h * 0.03]);
    }
    let tail =
        [[-deep * 0.75, 0.0, slim * 0.15], [-deep * 0.85, y * 0.5, slim * 0.13], [-deep * 0.4, y * 0.82, slim * 0.13]];
    legs.tapered(&spline(&tail, 4), |t| slim * (0.13 - 0.04 * t));
    legs.put(b, "leg", coat);
    paws.put(b, "paw", trim);
    let size = [deep * 0.42, y * 0.6, h * 0.15];
    face(b, [deep * 0.3, 0.0, h - size[2] * 1.27], size, deep * 0.16, (coat, trim), Ears::Pointed);
}

/// An animal lying on its belly with its paws forward.
fn lying(b: &mut Build<'_>, coat: MaterialId, trim: MaterialId) {
    let (x, y, h) = half_dims(b);
    let high = h.min(x * 0.8);
    let back = high * 0.56;
    let ring = |t: f32, w: f32, z: f32| oval(Axis::X, [x * t, 0.0, back * z / 2.0], (y * w, back * z / 2.0), 0, 14);
    let rings = [
        ring(-0.98, 0.35, 0.5),
        ring(-0.85, 0.85, 0.85),
        ring(-0.55, 1.0, 1.0),
        ring(-0.1, 0.85, 0.9),
        ring(0.25, 0.8, 0.98),
        ring(0.45, 0.62, 1.05),
        ring(0.58, 0.35, 0.9),
    ];
    loft(b, "body", &rings, coat);
    let (mut legs, mut paws) = (MeshBuilder::default(), MeshBuilder::default());
    let r = (high * 0.08).min(y * 0.1);
    for side in [-1.0, 1.0] {
        let py = side * y * 0.45;
        legs.tapered(&[[x * 0.2, py, high * 0.2], [x * 0.45, py, r], [x * 0.85, py, r]], |t| r * (1.5 - 0.6 * t));
        paws.egg([x * 0.9, py, r], [x * 0.1, y * 0.2, r]);
        legs.egg([-x * 0.5, side * y * 0.75, high * 0.17], [x * 0.3, y * 0.24, high * 0.17]);
        paws.egg([-x * 0.2, side * y * 0.8, r], [x * 0.12, y * 0.18, r]);
    }
    let tail = [[-x * 0.85, 0.0, high * 0.15], [-x * 0.92, y * 0.6, r], [-x * 0.55, y * 0.9, r]];
    legs.tapered(&spline(&tail, 4), |t| r * (0.9 - 0.4 * t));
    legs.put(b, "leg", coat);
    paws.put(b, "paw", trim);
    let size = [x * 0.2, y * 0.58, high * 0.2];
    let skull = [x * 0.6, 0.0, high - size[2] * 1.27];
    let mut neck = MeshBuilder::default();
    neck.tapered(&[[x * 0.4, 0.0, back * 0.6], skull], |_| y * 0.4);
    neck.put(b, "neck", coat);
    face(b, skull, size, x * 0.07, (coat, trim), Ears::Pointed);
}

/// A goldfish with flowing fins.
pub(super) fn goldfish(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let scales = b.choose(&[ORANGE_SKIN, ORANGE_PLASTIC, RED_SKIN, PETAL_WHITE]);
    let mid = h * 0.48;
    let ring = |t: f32, s: f32| oval(Axis::X, [x * t, 0.0, mid], (y * s, h * 0.36 * s), 0, 12);
    let rings = [
        ring(-0.42, 0.15),
        ring(-0.2, 0.5),
        ring(0.15, 0.95),
        ring(0.45, 1.0),
        ring(0.75, 0.75),
        ring(0.93, 0.4),
        ring(1.0, 0.1),
    ];
    loft(b, "body", &rings, scales);
    let thin = y * 0.08;
    let fin = |outline: &[(f32, f32)]| -> Vec<(f32, f32)> { outline.iter().map(|&(u, v)| (x * u, h * v)).collect() };
    let tail = fin(&[(-0.38, 0.48), (-0.7, 0.9), (-1.0, 0.98), (-0.85, 0.5), (-1.0, 0.05), (-0.7, 0.12)]);
    b.prism("tail", Axis::Y, [0.0, -thin, 0.0], &tail, 2.0 * thin, scales);
    b.prism(
        "fin",
        Axis::Y,
        [0.0, -thin * 0.8, 0.0],
        &fin(&[(0.5, 0.8), (0.2, 1.0), (-0.15, 0.85), (-0.1, 0.68)]),
        1.6 * thin,
        scales,
    );
    b.prism(
        "fin",
        Axis::Y,
        [0.0, -thin * 0.8, 0.0],
        &fin(&[(0.6, 0.2), (0.5, 0.0), (0.05, 0.0), (-0.15, 0.06), (-0.05, 0.26)]),
        1.6 * thin,
        scales,
    );
    let mut eyes = MeshBuilder::default();
    [-1.0, 1.0].iter().for_each(|s| eyes.egg([x * 0.72, s * y * 0.72, h * 0.56], [x * 0.06, y * 0.12, x * 0.06]));
    eyes.put(b, "eye", BLACK_PLASTIC);
}

/// A hamster or guinea pig: a ball of fur.
pub(super) fn hamster(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let (coat, trim) = b.choose(&[
        (FUR, WHITE_COTTON),
        (WHITE_COTTON, WOOL),
        (GREY_FABRIC, WHITE_COTTON),
        (RUST_FABRIC, WHITE_COTTON),
    ]);
    let ring = |t: f32, w: f32, z: f32| oval(Axis::X, [x * t, 0.0, h * 0.46 * z], (y * w, h * 0.44 * w), 0, 14);
    loft(
        b,
        "body",
        &[
            ring(-1.0, 0.15, 0.8),
            ring(-0.85, 0.65, 1.0),
            ring(-0.4, 1.0, 1.05),
            ring(0.1, 0.9, 1.0),
            ring(0.5, 0.62, 1.0),
        ],
        coat,
    );
    let mut paws = MeshBuilder::default();
    for (px, side) in [(-0.4, -1.0), (-0.4, 1.0), (0.4, -1.0), (0.4, 1.0)] {
        paws.egg([x * px, side * y * 0.42, h * 0.08], [x * 0.14, y * 0.2, h * 0.08]);
    }
    paws.put(b, "paw", SKIN);
    face(b, [x * 0.58, 0.0, h * 0.56], [x * 0.32, y * 0.62, h * 0.34], x * 0.14, (coat, trim), Ears::Pointed);
}

/// A standing parrot: bright wings, hooked beak, long tail.
pub(super) fn parrot(b: &mut Build<'_>) {
    let plumage = b.choose(&[
        (GREEN_PLASTIC, YELLOW_PLASTIC, RED_PLASTIC),
        (RED_PLASTIC, BLUE_PLASTIC, BLACK_PLASTIC),
        (BLUE_PLASTIC, YELLOW_PLASTIC, BLACK_PLASTIC),
        (GREY_FABRIC, RED_FABRIC, BLACK_PLASTIC),
        (YELLOW_PLASTIC, GREEN_PLASTIC, ORANGE_PLASTIC),
    ]);
    let high = b.size.z;
    bird(b, [0.0; 3], high, plumage);
}

/// A standing bird of height `high`: body, wings and beak.
pub(in crate::object) fn bird(
    b: &mut Build<'_>,
    at: P,
    high: f32,
    (body, wing, beak): (MaterialId, MaterialId, MaterialId),
) {
    let (x, y, _) = half_dims(b);
    let (x, y) = (x.min(high * 0.5), y.min(high * 0.35));
    let on = |u: f32, v: f32, w: f32| [at[0] + x * u, at[1] + y * v, at[2] + high * w];
    let ring = |w: f32, u: f32, s: f32, f: f32| oval(Axis::Z, on(u, 0.0, w), (x * s, y * f), 0, 12);
    let rings = [
        ring(0.02, -0.9, 0.06, 0.15),
        ring(0.12, -0.62, 0.14, 0.3),
        ring(0.26, -0.2, 0.42, 0.75),
        ring(0.45, 0.05, 0.52, 0.9),
        ring(0.62, 0.2, 0.42, 0.72),
        ring(0.74, 0.28, 0.32, 0.55),
        ring(0.86, 0.32, 0.36, 0.6),
        ring(0.96, 0.28, 0.24, 0.4),
        ring(1.0, 0.25, 0.06, 0.1),
    ];
    loft(b, "body", &rings, body);
    let mut wings = MeshBuilder::default();
    for side in [-1.0, 1.0] {
        let points = [on(0.2, side * 0.72, 0.64), on(-0.1, side * 0.8, 0.42), on(-0.5, side * 0.6, 0.2)];
        wings.tapered(&spline(&points, 3), |t| y.min(x) * 0.26 * (0.35 + t - 1.2 * t * t).max(0.05));
    }
    wings.put(b, "wing", wing);
    let mut hook = MeshBuilder::default();
    let bill = [on(0.55, 0.0, 0.88), on(0.85, 0.0, 0.86), on(0.92, 0.0, 0.77)];
    hook.tapered(&spline(&bill, 3), |t| x.min(y) * 0.24 * (1.02 - t));
    for side in [-1.0, 1.0] {
        hook.tapered(&[on(0.15, side * 0.35, 0.3), on(0.2, side * 0.35, 0.05)], |_| x.min(y) * 0.09);
        hook.egg(on(0.15, side * 0.35, 0.02), [x * 0.4, y * 0.14, high * 0.02]);
    }
    hook.put(b, "beak", beak);
    let mut eyes = MeshBuilder::default();
    let dot = x.min(y) * 0.1;
    [-1.0, 1.0].iter().for_each(|s| eyes.egg(on(0.45, s * 0.52, 0.9), [dot, dot * 0.6, dot]));
    eyes.put(b, "eye", BLACK_PLASTIC);
}
