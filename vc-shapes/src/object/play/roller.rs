//! Toys on wheels: boards, skates, scooters and small cycles.

use crate::material::*;
use crate::object::palette::*;
use crate::solid::{Axis, Build, CORNERS, Proportional, SIDES, arc_outline, band, rounded_between};

/// A self-balancing board: two wheels, two foot plates, lamps.
pub(super) fn hoverboard(b: &mut Build<'_>) {
    let (case, trim) =
        (b.choose(&[BLACK_PLASTIC, RED_PLASTIC, BLUE_PLASTIC, WHITE_PLASTIC, PURPLE_PLASTIC]), GREY_RUBBER);
    let r = (b.size.z * 0.46).min(b.size.x * 0.48);
    let z = r / b.size.z;
    for y in SIDES {
        b.wheel("wheel", Axis::Y, [0.0, y * 0.88, z], (r, b.size.y * 0.11), RUBBER);
        b.wheel("hub", Axis::Y, [0.0, y * 0.89, z], (r * 0.6, b.size.y * 0.109), ALUMINIUM);
        let guard: Vec<_> = arc_outline((0.0, z), (1.0, 1.0 - z), (0.15, 2.99), 9);
        let inner = arc_outline((0.0, z), (0.94, 0.94 - z), (2.99, 0.15), 9);
        let fender = [guard, inner].concat();
        b.side_outline("fender", (y * 0.87 - 0.12, y * 0.87 + 0.12), &fender, case);
        let crown = z + (0.97 - z) * 0.95;
        b.slab("fender_plate", [-0.3, y * 0.765 - 0.02, z], [0.3, y * 0.765 + 0.02, crown], case);
        let (a, c) = ((y * 0.1).min(y * 0.8), (y * 0.1).max(y * 0.8));
        let shape =
            [(-0.7, z * 0.62), (0.7, z * 0.62), (0.86, z * 0.95), (0.7, z * 1.2), (-0.7, z * 1.2), (-0.86, z * 0.95)];
        b.side_outline("deck", (a, c), &shape, case);
        b.plan_outline(
            "tread",
            (z * 1.18, z * 1.25),
            &rounded_between((-0.6, y * 0.43 - 0.27), (0.6, y * 0.43 + 0.27), (0.12, 0.04)),
            trim,
        );
        b.slab("lamp", [0.76, y * 0.45 - 0.12, z * 0.82], [0.88, y * 0.45 + 0.12, z * 0.98], COOL_BULB);
    }
    b.pole("joint", [0.0, -0.16, z * 0.92], [0.0, 0.16, z * 0.92], r * 0.34, GREY_PLASTIC);
}

/// A skateboard, a longboard or a small cruiser.
pub(super) fn skateboard(b: &mut Build<'_>) {
    let (deck, wheel) = (
        b.choose(&[MAPLE, BLACK, RED, BLUE, GREEN, YELLOW_PLASTIC]),
        b.choose(&[WHITE_PLASTIC, ORANGE_PLASTIC, GREEN_PLASTIC]),
    );
    let r = (b.size.z * b.vary(0.24, 0.3)).min(0.036);
    let long = b.size.y > 0.85;
    let (t, lift) = ((0.012 / b.size.z).min(0.15), if long { 0.88 } else { 0.72 });
    let nose = if long { 0.6 } else { 0.72 };
    let outline: Vec<_> = [
        arc_outline((0.0, nose), (1.0, 1.0 - nose), (0.0, std::f32::consts::PI), 9),
        arc_outline((0.0, -nose), (1.0, 1.0 - nose), (std::f32::consts::PI, std::f32::consts::TAU), 9),
    ]
    .concat();
    if long {
        b.plan_outline("deck", (1.0 - 2.0 * t, 1.0 - t * 0.3), &outline, deck);
        let grip: Vec<_> = outline.iter().map(|&(x, y)| (x * 0.93, y * 0.97)).collect();
        b.plan_outline("grip", (1.0 - t, 1.0), &grip, CHARCOAL_FABRIC);
    } else {
        b.slab("deck", [-1.0, -nose, lift - t], [1.0, nose, lift], deck);
        b.slab("grip", [-0.95, -nose, lift - t * 0.5], [0.95, nose, lift + 0.012], BLACK_FABRIC);
        for y in SIDES {
            let tip = |z: f32| {
                arc_outline((0.0, y * nose), (0.99, y * (0.99 - nose)), (0.0, std::f32::consts::PI), 9).into_iter().map(
                    move |(x, v)| {
                        let rise = ((v * y - nose) / (1.0 - nose)).max(0.0);
                        [x, v, z + rise * (1.0 - lift)]
                    },
                )
            };
            let points: Vec<_> = tip(lift).chain(tip(lift - t)).collect();
            b.chunk("tip", &points, deck);
        }
    }
    let z = r / b.size.z;
    let side = 1.0 - 0.034 / b.size.x;
    let (truck, below) = if long { (0.72, 1.0 - 2.0 * t) } else { (0.55, lift - t) };
    for y in SIDES.map(|s| s * truck) {
        b.pole("axle", [-side, y, z], [side, y, z], 0.005, STEEL);
        b.chunk(
            "truck",
            &[
                [-0.3, y - 0.05, below],
                [0.3, y - 0.05, below],
                [-0.3, y + 0.05, below],
                [0.3, y + 0.05, below],
                [-0.5, y, z - 0.06],
                [0.5, y, z - 0.06],
                [-0.5, y, z + 0.1],
                [0.5, y, z + 0.1],
            ],
            ALUMINIUM,
        );
        for x in SIDES {
            b.wheel("wheel", Axis::X, [x * side, y, z], (r, 0.032), wheel);
        }
    }
}

/// A pair of skates, with four wheels in a row or in pairs.
pub(super) fn skates(b: &mut Build<'_>) {
    let (boot, trim) =
        (b.choose(&[BLACK_LEATHER, WHITE_LEATHER, BLUE_PLASTIC, PINK_PLASTIC, GREY_PLASTIC]), b.one_of(BRIGHT));
    let inline = b.rng.chance(0.5);
    for y in SIDES {
        let (low, high) = (y * 0.54 - 0.45, y * 0.54 + 0.45);
        b.within([-1.0, low, 0.0], [1.0, high, 1.0], |b| {
            if inline {
                chassis(b, trim)
            } else {
                trucks(b, trim)
            }
            super::super::sport::boot(b, 0.3, boot, trim);
        });
    }
}

fn chassis(b: &mut Build<'_>, trim: MaterialId) {
    let r = (b.size.z * 0.11).min(b.size.x * 0.11);
    for i in 0..4 {
        let x = (-1.0 + (2.0 * r / b.size.x) * (1.0 + i as f32 * 2.0)).min(0.8);
        b.wheel("wheel", Axis::Y, [x * 0.96, 0.0, r / b.size.z], (r, b.size.y * 0.2), trim);
    }
    for y in SIDES {
        let side = (y * 0.22 - 0.06, y * 0.22 + 0.06);
        b.side_outline("frame", side, &[(-0.8, 0.1), (0.7, 0.1), (0.8, 0.3), (-0.85, 0.3)], ALUMINIUM);
    }
}

fn trucks(b: &mut Build<'_>, trim: MaterialId) {
    let r = (b.size.z * 0.1).min(b.size.x * 0.11);
    b.slab("plate", [-0.85, -0.5, 0.24], [0.8, 0.5, 0.3], ALUMINIUM);
    for (x, y) in CORNERS {
        b.wheel("wheel", Axis::Y, [x * 0.55, y * 0.72, r / b.size.z], (r, b.size.y * 0.24), trim);
    }
    for x in [-0.55, 0.55] {
        b.pole("axle", [x, -0.8, r / b.size.z], [x, 0.8, r / b.size.z], r * 0.25, STEEL);
        b.slab("truck", [x - 0.12, -0.25, 0.1], [x + 0.12, 0.25, 0.25], ALUMINIUM);
    }
    b.pole("stopper", [0.86, 0.0, 0.1], [0.86, 0.0, 0.28], b.size.y * 0.18, RED_RUBBER);
}

/// A kick scooter with two wheels, or three for small children.
pub(super) fn kick_scooter(b: &mut Build<'_>) {
    let (frame, trim) = (b.choose(&[ALUMINIUM, BLACK_METAL, BLUE_METAL, RED_METAL]), b.one_of(BRIGHT));
    let r = (b.size.z * b.vary(0.08, 0.12)).min(b.size.x * 0.11);
    let (z, edge) = (r / b.size.z, 1.0 - 2.0 * r / b.size.x);
    let three = b.size.z < 0.85 && b.rng.chance(0.7);
    b.wheel("wheel", Axis::Y, [-edge, 0.0, z], (r, 0.026), trim);
    if three {
        for y in SIDES {
            b.wheel("wheel", Axis::Y, [edge, y * 0.55, z], (r, 0.026), trim);
        }
        b.pole("axle", [edge, -0.55, z], [edge, 0.55, z], 0.012, frame);
        b.pole("bracket", [edge, 0.0, z], [edge - 0.07, 0.0, z * 1.35], 0.016, frame);
    } else {
        b.wheel("wheel", Axis::Y, [edge, 0.0, z], (r, 0.026), trim);
        b.pole("axle", [edge, -0.14, z], [edge, 0.14, z], 0.007, STEEL);
        for y in SIDES {
            b.plank("fork", [edge, y * 0.1, z], [edge - 0.09, y * 0.1, z * 2.4], (0.008, 0.02), frame);
        }
    }
    b.pad("deck", [-edge + 0.02, -0.28, z * 0.9], [edge - 0.42, 0.28, z * 0.9 + 0.03], 0.008, frame);
    b.slab("grip_tape", [-edge + 0.2, -0.24, z], [edge - 0.46, 0.24, z * 0.9 + 0.034], BLACK_FABRIC);
    b.plank("neck", [edge - 0.46, 0.0, z], [edge - 0.11, 0.0, z * 2.6], (0.04, 0.025), frame);
    b.pole("column", [edge - 0.06, 0.0, z * 1.2], [edge - 0.205, 0.0, 0.975], 0.017, frame);
    b.pole("bar", [edge - 0.205, -0.98, 0.975], [edge - 0.205, 0.98, 0.975], 0.013, frame);
    for y in SIDES {
        b.pole("grip", [edge - 0.205, y * 0.98, 0.975], [edge - 0.205, y * 0.64, 0.975], 0.018, RUBBER);
    }
    let guard = arc_outline((-edge, z), (1.0 - edge, z * 1.15), (1.2, 2.8), 6);
    b.side_outline("mudguard", (-0.07, 0.07), &band(&guard, (0.0, 0.012)), trim);
}

/// Saddle and handlebars of a child's cycle with their stems.
fn cockpit(b: &mut Build<'_>, seat: (f32, f32), bar: (f32, f32), mat: MaterialId) {
    let (r, grip) = (0.014, b.one_of(BRIGHT));
    let pad = [
        ([seat.0 - 0.2, 0.0, seat.1], 0.38, 0.03),
        ([seat.0, 0.0, seat.1 + 0.01], 0.34, 0.035),
        ([seat.0 + 0.22, 0.0, seat.1], 0.12, 0.025),
    ];
    b.skin("saddle", Axis::X, &pad, BLACK_PLASTIC);
    b.pole("bar", [bar.0, -0.96, bar.1], [bar.0, 0.96, bar.1], r, mat);
    for y in SIDES {
        b.pole("grip", [bar.0, y, bar.1], [bar.0, y * 0.66, bar.1], r * 1.4, grip);
    }
}

/// A tricycle with a saddle, pedals and sometimes a push bar with a basket.
pub(super) fn tricycle(b: &mut Build<'_>) {
    let (frame, trim) = (
        b.choose(&[RED_METAL, BLUE_METAL, GREEN_METAL, YELLOW_METAL]),
        b.choose(&[WHITE_PLASTIC, YELLOW_PLASTIC, GREY_PLASTIC]),
    );
    let (big, small) = ((b.size.z * 0.26).min(b.size.x * 0.22), (b.size.z * 0.18).min(b.size.x * 0.15));
    let (fz, bz) = (big / b.size.z, small / b.size.z);
    let (front, back) = (1.0 - 2.0 * big / b.size.x, 2.0 * small / b.size.x - 1.0);
    b.wheel("wheel", Axis::Y, [front, 0.0, fz], (big, 0.04), RUBBER);
    b.wheel("hub", Axis::Y, [front, 0.0, fz], (big * 0.7, 0.044), trim);
    for y in SIDES {
        b.wheel("wheel", Axis::Y, [back, y * 0.88, bz], (small, 0.04), RUBBER);
        b.wheel("hub", Axis::Y, [back, y * 0.88, bz], (small * 0.7, 0.044), trim);
        b.plank("fork", [front, y * 0.13, fz], [front - 0.16, y * 0.13, 0.66], (0.01, 0.025), frame);
        b.pole("crank", [front, 0.0, fz], [front, y * 0.42, fz], 0.009, STEEL);
        b.slab(
            "pedal",
            [front - 0.1, y * 0.38 - 0.14, fz - 0.025],
            [front + 0.1, y * 0.38 + 0.14, fz + 0.025],
            BLACK_PLASTIC,
        );
    }
    b.pole("axle", [back, -0.9, bz], [back, 0.9, bz], 0.012, frame);
    let seat = (-0.25, 0.6);
    b.pole("frame", [front - 0.17, 0.0, 0.6], [seat.0, 0.0, bz * 1.6], 0.02, frame);
    b.pole("frame", [seat.0, 0.0, bz * 1.6], [back, 0.0, bz], 0.02, frame);
    b.pole("post", [seat.0, 0.0, bz * 1.5], [seat.0, 0.0, seat.1], 0.016, frame);
    b.pole("stem", [front - 0.16, 0.0, 0.6], [front - 0.24, 0.0, 0.96], 0.015, frame);
    b.slab("fork_crown", [front - 0.22, -0.15, 0.62], [front - 0.1, 0.15, 0.68], frame);
    b.slab("step", [back - 0.12, -0.6, bz * 1.12], [back + 0.14, 0.6, bz * 1.12 + 0.025], trim);
    cockpit(b, seat, (front - 0.24, 0.965), frame);
}

/// A balance bike: two wheels, a low frame, no pedals.
pub(super) fn balance_bike(b: &mut Build<'_>) {
    let wooden = b.rng.chance(0.4);
    let frame = if wooden { b.one_of(TOY_WOODS) } else { b.choose(&[RED_METAL, BLUE_METAL, WHITE_METAL, GREEN_METAL]) };
    let r = (b.size.z * 0.28).min(b.size.x * 0.2);
    let (z, edge) = (r / b.size.z, 1.0 - 2.0 * r / b.size.x);
    for x in [-edge, edge] {
        b.torus("tyre", Axis::Y, [x, 0.0, z], (r * 0.86, r * 0.14), RUBBER);
        b.wheel("rim", Axis::Y, [x, 0.0, z], (r * 0.8, r * 0.1), if wooden { frame } else { WHITE_PLASTIC });
        b.pole("hub", [x, -0.18, z], [x, 0.18, z], r * 0.16, STEEL);
    }
    let head = edge - 0.28;
    for y in SIDES {
        b.plank("fork", [edge, y * 0.16, z], [head, y * 0.16, 0.74], (0.012, 0.03), frame);
        b.plank("stay", [-edge, y * 0.16, z], [-0.12, y * 0.12, 0.48], (0.012, 0.03), frame);
    }
    b.slab("crown", [head - 0.06, -0.2, 0.7], [head + 0.08, 0.2, 0.76], frame);
    b.plank("tube", [-0.2, 0.0, 0.46], [head + 0.02, 0.0, 0.7], (0.035, 0.05), frame);
    b.pole("post", [-0.2, 0.0, 0.44], [-0.26, 0.0, 0.68], 0.014, STEEL);
    b.pole("stem", [head, 0.0, 0.72], [head - 0.06, 0.0, 0.96], 0.015, frame);
    b.slab("stand", [-0.26, 0.2, 0.0], [-0.2, 0.3, 0.5], STEEL);
    b.slab("stand", [-0.26, -0.3, 0.0], [-0.2, -0.2, 0.5], STEEL);
    b.slab("stand", [-0.26, -0.3, 0.44], [-0.2, 0.3, 0.475], STEEL);
    cockpit(b, (-0.28, 0.68), (head - 0.06, 0.965), frame);
}
