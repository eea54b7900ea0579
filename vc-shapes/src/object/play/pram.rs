//! Strollers and prams.

use vc_graph::portable::Portable;

use crate::material::*;
use crate::solid::{Axis, Build, Proportional, SIDES, rounded_between};

/// A spoked or solid wheel that stands on the floor.
fn wheel(b: &mut Build<'_>, (x, y): (f32, f32), (r, w): (f32, f32), spoked: bool) {
    let at = [x, y, r / b.size.z];
    if spoked {
        b.torus("tyre", Axis::Y, at, (r - w / 2.0, w / 2.0), RUBBER);
        for turn in [0.0, std::f32::consts::FRAC_PI_4, std::f32::consts::FRAC_PI_2, 2.3562] {
            let (s, c) = turn.sine_cosine();
            let (dx, dz) = (c * (r - w) * 2.0 / b.size.x, s * (r - w) / b.size.z);
            b.pole("spoke", [x - dx, y, at[2] - dz], [x + dx, y, at[2] + dz], 0.0025, CHROME);
        }
        b.wheel("hub", Axis::Y, at, (w * 0.8, w * 1.2), CHROME);
    } else {
        b.wheel("tyre", Axis::Y, at, (r, w), RUBBER);
        b.wheel("hub", Axis::Y, at, (r * 0.62, w * 1.1), GREY_PLASTIC);
    }
}

/// A folding hood: the ribs of a fan around a pivot, from one angle to another, over a half circle
/// across; `reach` is its half depth and height.
fn hood(b: &mut Build<'_>, pivot: (f32, f32), reach: (f32, f32), y: (f32, f32), turns: (f32, f32), mat: MaterialId) {
    let ribs = 4;
    let step = (turns.1 - turns.0) / ribs as f32;
    let middle = (y.0 + y.1) / 2.0;
    let half = (y.1 - y.0) / 2.0;
    // Each rib is slightly narrower than the previous one.
    let rib = |turn: f32, share: f32, width: f32| {
        let (s, c) = turn.sine_cosine();
        let out = move |y: f32, r: f32| {
            [pivot.0 + reach.0 * c * r * share, middle + half * width * y * share, pivot.1 + reach.1 * s * r * share]
        };
        [
            out(-1.0, 0.0),
            out(-0.98, 0.62),
            out(-0.82, 0.9),
            out(-0.4, 1.0),
            out(0.4, 1.0),
            out(0.82, 0.9),
            out(0.98, 0.62),
            out(1.0, 0.0),
        ]
    };
    for i in 0..ribs {
        let (from, to) = (turns.0 + step * i as f32, turns.0 + step * (i + 1) as f32);
        let width = 1.0 - 0.006 * i as f32;
        let outer = [rib(from, 1.0, width), rib(to, 1.0, width)];
        let inner = [rib(from, 0.95, width), rib(to, 0.95, width)];
        for k in 0..7 {
            let corners: Vec<_> = outer.iter().chain(&inner).flat_map(|r| [r[k], r[k + 1]]).collect();
            b.chunk("hood", &corners, mat);
        }
    }
}

/// A stroller with one seat or two side by side: hood, basket, handle, four wheels.
pub(super) fn stroller(b: &mut Build<'_>) {
    let seats = if b.class == "double_stroller" { 2 } else { 1 };
    let (cloth, trim) =
        (b.choose(&[CHARCOAL_FABRIC, NAVY_FABRIC, GREY_FABRIC, RED_FABRIC, TEAL_FABRIC, BLACK_FABRIC]), b.style.accent);
    let frame = b.choose(&[ALUMINIUM, BLACK_METAL, WHITE_METAL]);
    let (front, back) = (b.vary(0.08, 0.1), b.vary(0.09, 0.14));
    let tube = 0.012;
    let rear = -1.0 + 2.0 * back / b.size.x + 0.12;
    let ahead = 1.0 - 2.0 * front / b.size.x;
    let (fz, bz) = (front / b.size.z, back / b.size.z);
    let width = 0.04;
    let side = 1.0 - width / b.size.y * 1.2;
    let bowed = b.rng.chance(0.5);
    for y in SIDES {
        wheel(b, (ahead, y * side), (front, width), false);
        wheel(b, (rear, y * side), (back, width), false);
        let grip = y * (side - 0.06);
        b.pole("frame", [ahead, grip, fz], [-0.45, grip, 0.62], tube, frame);
        b.pole("frame", [rear, grip, bz], [0.1, grip, 0.52], tube, frame);
        b.pole("frame", [-0.45, grip, 0.62], [-0.92, grip, 0.95], tube, frame);
        if !bowed {
            b.pole("grip", [-0.86, grip, 0.93], [-0.97, grip, 0.975], tube * 1.5, BLACK_PLASTIC);
        }
    }
    b.pole("axle", [rear, -side, bz], [rear, side, bz], tube * 0.8, frame);
    b.pole("axle", [ahead - 0.06, -side, fz * 1.4], [ahead - 0.06, side, fz * 1.4], tube * 0.8, frame);
    if bowed {
        b.pole("handle", [-0.92, 0.06 - side, 0.95], [-0.92, side - 0.06, 0.95], tube * 1.4, BLACK_PLASTIC);
    }
    let (low, high) = (bz * 1.3, 0.3);
    for (x, z) in [(-0.45, 0.62), (-0.05, 0.45)] {
        b.pole("crossbar", [x, 0.06 - side, z], [x, side - 0.06, z], tube, frame);
    }
    basket(b, (rear + 0.12, 0.4), side - 0.07, (low, high), cloth);
    let pitch = 2.0 * (side - 0.12) / seats as f32;
    for i in 0..seats {
        let y = -(side - 0.12) + pitch * (i as f32 + 0.5);
        b.within([-1.0, y - pitch * 0.49, 0.0], [1.0, y + pitch * 0.49, 1.0], |b| seat(b, cloth, trim, frame));
    }
}

/// An open basket of cloth under the seats.
fn basket(b: &mut Build<'_>, x: (f32, f32), y: f32, z: (f32, f32), mat: MaterialId) {
    let t = 0.02;
    b.slab("basket", [x.0, -y, z.0], [x.1, y, z.0 + 0.012], mat);
    for s in SIDES {
        b.slab("basket_side", [x.0, s * (y - t) - t, z.0 + 0.012], [x.1, s * (y - t) + t, z.1.max(z.0 + 0.06)], mat);
    }
    b.slab("basket_back", [x.0, -y + 2.0 * t, z.0 + 0.012], [x.0 + t, y - 2.0 * t, (z.1 * 0.9).max(z.0 + 0.05)], mat);
    b.slab("basket_front", [x.1 - t, -y + 2.0 * t, z.0 + 0.012], [x.1, y - 2.0 * t, (z.1 * 0.9).max(z.0 + 0.05)], mat);
    let middle = (x.0 + x.1) / 2.0;
    b.inner_floor(
        "basket",
        [middle, 0.0, z.0 + 0.012],
        ((x.1 - x.0) / 2.0 - 2.0 * t, y - 3.0 * t),
        (0.4 - z.0 - 0.03).max(0.02),
    );
}

/// A reclined seat with leg rest, straps, bumper bar and hood.
fn seat(b: &mut Build<'_>, cloth: MaterialId, trim: MaterialId, frame: MaterialId) {
    let w = b.size.y * 0.92;
    b.plank("seat", [-0.34, 0.0, 0.43], [0.34, 0.0, 0.47], (w, 0.035), cloth);
    b.plank("backrest", [-0.3, 0.0, 0.43], [-0.66, 0.0, 0.86], (w, 0.035), cloth);
    b.plank("leg_rest", [0.32, 0.0, 0.47], [0.56, 0.0, 0.28], (w * 0.9, 0.025), cloth);
    b.slab("footrest", [0.5, -0.7, 0.25], [0.74, 0.7, 0.275], BLACK_PLASTIC);
    b.layer("liner", [-0.33, 0.0, 0.466], [-0.62, 0.0, 0.812], (w * 0.6, 0.03), 0.028, trim);
    for y in SIDES {
        let (low, high) = ([-0.34, y * 0.25, 0.478], [-0.6, y * 0.25, 0.788]);
        b.layer("strap", low, high, (0.025, 0.008), 0.045, BLACK_FABRIC);
        b.plank("side", [-0.55, y * 0.92, 0.56], [0.1, y * 0.92, 0.56], (0.014, b.size.z * 0.15), cloth);
    }
    b.bent_rod("bumper", &[[0.0, -0.94, 0.6], [0.3, -0.9, 0.64], [0.3, 0.9, 0.64], [0.0, 0.94, 0.6]], 0.014, frame);
    let (from, to) = (b.vary(0.75, 1.1), b.vary(2.4, 2.6));
    hood(b, (-0.42, 0.7), (0.42, 0.3), (-0.98, 0.98), (from, to), cloth);
}

/// A pram with a carrycot, or a doll's pram: tub, hood, cover, big wheels, handle.
pub(super) fn pram(b: &mut Build<'_>) {
    let cloth = if b.class == "pram" {
        b.choose(&[NAVY_FABRIC, BLACK_FABRIC, GREY_FABRIC, BEIGE_FABRIC, GREEN_FABRIC])
    } else {
        b.choose(&[ROSE_FABRIC, PURPLE_FABRIC, RED_FABRIC, TEAL_FABRIC, WICKER])
    };
    let (lining, frame) = (WHITE_COTTON, b.choose(&[CHROME, WHITE_METAL, BLACK_METAL]));
    let spoked = b.rng.chance(0.6);
    let r = (b.size.z * b.vary(0.16, 0.2)).min(b.size.x * 0.2);
    let (w, tube) = (r * 0.22, r * 0.08);
    let (rear, ahead) = (-0.52, 1.0 - 2.0 * r / b.size.x);
    let z = r / b.size.z;
    let side = 1.0 - w * 1.3 / b.size.y;
    for y in SIDES {
        wheel(b, (rear, y * side), (r, w), spoked);
        wheel(b, (ahead, y * side), (r, w), spoked);
        let inner = y * (side - 0.12);
        b.pole("strut", [rear, inner, z], [ahead - 0.1, inner, 0.44], tube, frame);
        b.pole("strut", [ahead, inner, z], [rear + 0.1, inner, 0.44], tube, frame);
        b.bent_rod("handle", &[[-0.42, inner, 0.43], [-0.88, inner, 0.9], [-0.95, inner, 0.93]], tube, frame);
    }
    b.pole("handle", [-0.95, -side + 0.14, 0.93], [-0.95, side - 0.14, 0.93], tube * 1.5, BLACK_PLASTIC);
    for x in [rear, ahead] {
        b.pole("axle", [x, -side, z], [x, side, z], tube, frame);
    }
    for x in [rear + 0.1, ahead - 0.1] {
        b.pole("cradle", [x, 0.12 - side, 0.43], [x, side - 0.12, 0.43], tube, frame);
    }
    let (low, rim, y) = (0.42, 0.68, 0.72);
    bassinet(b, (low, rim), y, cloth);
    b.inner_floor("cot", [0.12, 0.0, low + 0.08], (0.5, y * 0.7), rim - low - 0.1);
    b.pad("mattress", [-0.45, -y * 0.8, low + 0.03], [0.72, y * 0.8, low + 0.079], 0.01, lining);
    if b.rng.chance(0.6) {
        b.plan_outline(
            "cover",
            (rim, rim + 0.025),
            &rounded_between((0.25, -y - 0.05), (0.98, y + 0.05), (0.2, 0.3)),
            cloth,
        );
    }
    hood(b, (-0.12, rim - 0.02), (0.62, 0.33), (-y - 0.03, y + 0.03), (1.2, 2.95), cloth);
}

/// A tub wider at the top than at the bottom, open at the top.
fn bassinet(b: &mut Build<'_>, (low, rim): (f32, f32), y: f32, mat: MaterialId) {
    b.slab("bottom", [-0.5, -y * 0.85, low], [0.78, y * 0.85, low + 0.03], mat);
    let (inner, outer) = ((-0.52, 0.8, y * 0.86), (-0.72, 0.98, y));
    let wall = |b: &mut Build<'_>, a: [f32; 4]| {
        let [x0, y0, x1, y1] = a;
        let corner = |x: f32, y: f32| {
            let at = |t: f32, z: f32| {
                let ends = if x > 0.0 { (inner.1, outer.1) } else { (inner.0, outer.0) };
                let x = ends.0 + (ends.1 - ends.0) * t;
                let side = inner.2 + (outer.2 - inner.2) * t;
                [x, y * side, z]
            };
            [at(0.0, low), at(1.0, rim)]
        };
        let skin: Vec<_> = [corner(x0, y0), corner(x1, y1)].concat();
        let lining = skin.iter().map(|p| [p[0] - 0.03 * p[0].signum(), p[1] - 0.04 * p[1].signum(), p[2] - 0.002]);
        let all: Vec<_> = skin.iter().copied().chain(lining).collect();
        b.chunk("tub", &all, mat);
    };
    for edge in [[1.0, 1.0, -1.0, 1.0], [1.0, -1.0, -1.0, -1.0], [1.0, 1.0, 1.0, -1.0], [-1.0, 1.0, -1.0, -1.0]] {
        wall(b, edge);
    }
}
