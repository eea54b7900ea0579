//! Wheels: tyred ones on hinges for motor vehicles, spoked ones for cycles.

use std::f32::consts::PI;

use crate::material::*;
use crate::solid::{Axis, Build, P, polar, polygon, star, torus_profile};
use vc_graph::asset::JointKind;
use vc_graph::portable::Portable;

/// The joint range of a wheel, which is effectively unlimited.
const FREE: (f32, f32) = (-1e4, 1e4);

/// The gap between a tyre and its guard, and the guard's thickness, metres.
const GAP: f32 = 0.012;
const THICK: f32 = 0.012;

/// Designs of a rim.
#[derive(Clone, Copy)]
pub(crate) struct Rim {
    spokes: usize,
    star: f32,
    mat: MaterialId,
    tyre: f32,
}

impl Rim {
    pub(crate) fn any(b: &mut Build<'_>) -> Self {
        let mat = b.choose(&[ALUMINIUM, STEEL, ALUMINIUM, ANTHRACITE, CHROME, BLACK_METAL]);
        Self { spokes: b.rng.count(4, 10), star: b.vary(0.25, 0.6), mat, tyre: b.vary(0.58, 0.74) }
    }

    /// Plain steel discs of commercial vehicles.
    pub(crate) fn plain(b: &mut Build<'_>) -> Self {
        let mat = b.choose(&[SILVER_METAL, WHITE_METAL, GALVANISED, ANTHRACITE]);
        Self { spokes: b.rng.count(6, 10), star: 0.8, mat, tyre: b.vary(0.55, 0.62) }
    }
}

/// A tyred wheel centred at a point, with its outer face towards `side` (1 is left), on its own
/// hinge.
pub(crate) fn wheel(b: &mut Build<'_>, name: &str, at: P, radius: f32, width: f32, side: f32, rim: Rim) {
    turning(b, at, |b| tyred(b, name, at, (radius, width), side, rim));
}

/// A tyred wheel with an axle end that rotates with it and ends at the distance `end` from the
/// vehicle's centre plane, where it meets the body.
pub(super) fn axled(b: &mut Build<'_>, name: &str, at: P, (radius, width): (f32, f32), side: f32, rim: Rim, end: f32) {
    turning(b, at, |b| {
        tyred(b, name, at, (radius, width), side, rim);
        let inner = at[1].abs() - width * 0.3;
        b.rod("axle", [at[0], side * inner.max(end + 0.002), at[2]], [at[0], side * end, at[2]], radius * 0.12, IRON);
    });
}

fn turning(b: &mut Build<'_>, at: P, build: impl FnOnce(&mut Build<'_>)) {
    b.jointed(JointKind::Hinge, at, [0.0, 1.0, 0.0], FREE, build);
}

fn tyred(b: &mut Build<'_>, name: &str, at: P, (radius, width): (f32, f32), side: f32, rim: Rim) {
    let (half, inner) = (width / 2.0, radius * rim.tyre);
    let shoulder = radius * 0.93;
    let profile = [
        (inner, -half * 0.8),
        (shoulder, -half),
        (radius, -half * 0.7),
        (radius, half * 0.7),
        (shoulder, half),
        (inner, half * 0.8),
        (inner, -half * 0.8),
    ];
    b.lathe_along(name, at, [at[0], at[1] + 1.0, at[2]], &profile, RUBBER);
    let y = at[1] + side * half * 0.35;
    let low = |a: f32, c: f32| [at[0], a.min(c), at[2]];
    // A dark drum behind a star of spokes.
    b.rod("rim", [at[0], at[1] - side * half * 0.75, at[2]], [at[0], y, at[2]], inner * 1.01, IRON);
    let face = y + side * half * 0.25;
    b.prism(
        "rim",
        Axis::Y,
        low(y - side * 0.002, face),
        &star(rim.spokes, inner * 1.005, inner * rim.star),
        (face - y).abs() + 0.002,
        rim.mat,
    );
    let cap = face + side * half * 0.1;
    b.prism("hub", Axis::Y, low(y, cap), &polygon(10, inner * 0.22, 0.0), (cap - y).abs(), rim.mat);
}

/// Half the length of the hub of a spoked wheel; the fork or frame stays outside it.
pub(super) fn hub(tyre: f32, cast: bool) -> f32 {
    tyre * if cast { 1.2 } else { 1.6 }
}

/// The nuts that hold a hub on both sides, between the distances `from` and `to` from the centre
/// plane.
pub(super) fn nuts(b: &mut Build<'_>, [x, _, z]: P, (from, to): (f32, f32), radius: f32) {
    for side in [-1.0, 1.0] {
        b.rod("axle", [x, side * from, z], [x, side * to, z], radius, STEEL);
    }
}

/// A mudguard that follows the tyre from one angle to another (from the front upwards), at the
/// distance `GAP`.
pub(super) fn fender(b: &mut Build<'_>, at: P, (radius, half): (f32, f32), (from, to): (f32, f32), mat: MaterialId) {
    let (inner, outer) = (radius + GAP, radius + GAP + THICK);
    let arc = |r: f32| (0..=8).map(move |i| polar(from + (to - from) * i as f32 / 8.0, r)).collect::<Vec<_>>();
    let outline = [arc(inner / (PI / 16.0).cosine()), arc(outer).into_iter().rev().collect()].concat();
    b.prism("mudguard", Axis::Y, [at[0], at[1] - half, at[2]], &outline, 2.0 * half, mat);
}

/// A wheel with wire spokes, or cast spokes if `cast`; its axle lies along Y on a hinge.
pub(super) fn spoked(b: &mut Build<'_>, name: &str, at: P, radius: f32, tyre: f32, cast: bool, rim: MaterialId) {
    turning(b, at, |b| {
        let to = [at[0], at[1] + 1.0, at[2]];
        let section =
            |r: f32, s: f32| -> Vec<(f32, f32)> { torus_profile(r, s).into_iter().map(|(r, z)| (r, z - s)).collect() };
        b.lathe_along(name, at, to, &section(radius - tyre, tyre), RUBBER);
        let (out, half) = (radius - 1.7 * tyre, tyre * 0.7);
        let ring =
            [(out, -half), (out, half), (out - tyre * 0.9, half * 0.6), (out - tyre * 0.9, -half * 0.6), (out, -half)];
        b.lathe_along("rim", at, to, &ring, rim);
        let hub = hub(tyre, cast);
        b.rod(
            "hub",
            [at[0], at[1] - hub, at[2]],
            [at[0], at[1] + hub, at[2]],
            radius * if cast { 0.16 } else { 0.06 },
            rim,
        );
        if cast {
            b.prism(
                "spokes",
                Axis::Y,
                [at[0], at[1] - half * 0.5, at[2]],
                &star(6, out - tyre * 0.4, radius * 0.14),
                half,
                rim,
            );
        } else {
            let spoke = out - tyre * 0.5;
            for i in 0..7 {
                let (sin, cos) = (PI * i as f32 / 7.0).sine_cosine();
                let lean = if i % 2 == 0 { tyre * 0.4 } else { -tyre * 0.4 };
                let end = |s: f32| [at[0] + s * cos * spoke, at[1] + lean, at[2] + s * sin * spoke];
                b.rod("spoke", end(-1.0), end(1.0), 0.0015 + radius * 0.002, STEEL);
            }
        }
    });
}
