//! Lights, bumpers, mirrors, doors, and painted markings on the sides.

use super::{Car, Tail};
use crate::material::*;
use crate::solid::{Build, P};

/// Lights, grille, mirrors, door outlines and handles.
pub(super) fn details(b: &mut Build<'_>, car: &Car) {
    let nose = car.belt(0.045);
    let (z, tall) = (car.low + (nose - car.low) * 0.62, (nose - car.low) * b.vary(0.12, 0.22));
    let wide = car.half * b.vary(0.18, 0.28);
    let tail_top = car.tail_top();
    for side in [-1.0, 1.0] {
        let y = |share: f32| side * car.half * share;
        let (outer, inner) = (y(0.86), y(0.86) - side * wide);
        let (back, front) = (car.front - 0.08, car.front - 0.004);
        let lamp = [
            [back, outer, z],
            [back, outer, z + tall],
            [front, inner, z],
            [front, inner, z + tall],
            [front, outer * 0.96, z],
            [front, outer * 0.96, z + tall],
            [back, inner, z + tall * 0.5],
        ];
        b.hull("headlight", &lamp.map(|p| [p[0] + 0.004, p[1], p[2]]), COOL_BULB);
        b.block(
            "fog_light",
            [car.front - 0.05, y(0.7) - 0.05, car.low + (nose - car.low) * 0.3],
            [car.front - 0.006, y(0.7) + 0.05, car.low + (nose - car.low) * 0.38],
            SIGNAL_AMBER,
        );
        if car.shape.tail != Tail::Doors {
            let rear = -car.front;
            let (z0, z1) = (car.low + (tail_top - car.low) * 0.6, car.low + (tail_top - car.low) * 0.85);
            let lamp = [outer, inner].into_iter().flat_map(|y| {
                [[rear + 0.001, y, z0], [rear + 0.001, y, z1 - 0.02], [rear + 0.06, y, z1], [rear + 0.06, y, z0]]
            });
            b.hull("tail_light", &lamp.collect::<Vec<P>>(), SIGNAL_RED);
        } else {
            b.block(
                "tail_light",
                [car.x(car.ends().1) - 0.02, y(0.915).min(y(0.985)), car.low + 0.2],
                [car.x(car.ends().1) + 0.02, y(0.915).max(y(0.985)), car.low + 0.45],
                SIGNAL_RED,
            );
        }
        mirror(b, car, side);
        doors(b, car, side);
    }
    let grille = car.half * b.vary(0.3, 0.5);
    if b.class != "electric_car" {
        b.block(
            "grille",
            [car.front - 0.06, -grille, z - tall * 0.8],
            [car.front - 0.001, grille, z + tall * 0.7],
            BLACK_PLASTIC,
        );
    }
    b.block(
        "plate",
        [car.front - 0.05, -0.26_f32.max(-car.half * 0.3), car.low + (nose - car.low) * 0.36],
        [car.front, 0.26_f32.min(car.half * 0.3), car.low + (nose - car.low) * 0.46],
        WHITE_PLASTIC,
    );
}

fn mirror(b: &mut Build<'_>, car: &Car, side: f32) {
    let share = car.cowl() + 0.06;
    let z = car.belt(share);
    let (x, y) = (car.x(share), side * b.size.y / 2.0);
    let (near, far) = (y.min(side * car.half * 0.985), y.max(side * car.half * 0.985));
    let (a, c) = if side > 0.0 { (near - 0.005, y) } else { (y, far + 0.005) };
    b.rounded_block("mirror", [x - 0.05, a.min(c), z - 0.02], [x + 0.05, a.max(c), z + 0.1], 0.025, car.paint);
    b.block(
        "mirror",
        [x - 0.02, side * car.half * 0.9 - 0.05, z - 0.03],
        [x + 0.02, side * car.half * 0.9 + 0.05, z + 0.02],
        BLACK_PLASTIC,
    );
}

/// Seams and handles of the doors on a side.
fn doors(b: &mut Build<'_>, car: &Car, side: f32) {
    let y = side * car.half;
    let sill = car.low + 0.06;
    let seams: &[f32] = match car.shape.tail {
        Tail::Doors => &[0.2, 0.41, 0.62],
        _ if car.shape.panes > 1 => &[0.32, 0.53, 0.7],
        _ => &[0.36, 0.64],
    };
    let block = |b: &mut Build<'_>, name: &str, low: [f32; 2], high: [f32; 2], out: f32, mat: MaterialId| {
        b.block(
            name,
            [low[0], y.min(y + side * out) - 0.004, low[1]],
            [high[0], y.max(y + side * out) + 0.004, high[1]],
            mat,
        );
    };
    let clear = |x: f32| car.axles.iter().map(|a| (x - a).abs() - car.wheel * 1.13).fold(f32::INFINITY, f32::min);
    for pair in seams.windows(2) {
        for &share in pair {
            let x = car.x(share);
            let low = if clear(x) < 0.01 { car.wheel * 2.2 } else { sill };
            block(b, "seam", [x - 0.004, low], [x + 0.004, car.belt(share) - 0.02], -0.002, BLACK_PLASTIC);
        }
        let x = car.x(pair[1]) + 0.06;
        let z = car.belt(pair[1]) - (car.belt(pair[1]) - car.low) * 0.18;
        block(b, "handle", [x, z], [x + 0.16_f32.min(car.front * 0.08), z + 0.025], 0.012, car.paint);
    }
    let (f, r) = (car.axles[0] - car.wheel * 1.2, car.axles[1] + car.wheel * 1.2);
    block(b, "sill", [r, car.low + 0.003], [f, sill - 0.01], 0.0, ANTHRACITE);
}

/// The markings of a taxi, a police car and an ambulance.
pub(super) fn livery(b: &mut Build<'_>, car: &Car) {
    let roof = car.x((car.shape.stations[1] + car.shape.stations[2].min(0.7)) / 2.0);
    let top = b.size.z;
    let stripe = |b: &mut Build<'_>, z0: f32, z1: f32, mat: MaterialId| {
        for side in [-1.0, 1.0] {
            let y = side * car.half;
            let (from, to) = (car.axles[1] + car.wheel * 1.25, car.axles[0] - car.wheel * 1.25);
            b.block("stripe", [from, y - 0.003, z0], [to, y + 0.003, z1], mat);
        }
    };
    let waist = car.low + (car.belt(0.5) - car.low) * 0.5;
    match b.class {
        "taxi" => {
            b.taper(
                "sign",
                [roof, 0.0, car.roof - 0.005],
                (0.08, car.half * 0.3),
                (0.05, car.half * 0.28),
                top - car.roof + 0.005,
                WARM_BULB,
            );
            let stripes = b.choose(&[BLACK, WHITE, car.paint]);
            stripe(b, waist, waist + 0.06, stripes);
        }
        "police_car" => {
            beacons(b, car, roof, top);
            let colour = b.choose(&[BLUE, NAVY, GREEN, BLACK]);
            stripe(b, waist - 0.06, waist + 0.1, colour);
            stripe_text(b, car, waist);
        }
        "ambulance" => {
            beacons(b, car, car.x(0.34), top);
            stripe(b, waist - 0.1, waist + 0.12, RED);
            for side in [-1.0, 1.0] {
                let (x, y, z) = (car.x(0.7), side * car.half * (1.0 - 2.0 * car.shape.tuck), car.roof * 0.75);
                let out = car.half * 0.97;
                let face = (y.abs() + out) / 2.0 * side;
                let r = car.roof * 0.1;
                for (dx, dz, t) in [(r, r * 0.33, 0.022), (r * 0.33, r, 0.024)] {
                    b.block("cross", [x - dx, face - t, z - dz], [x + dx, face + t, z + dz], RED);
                }
            }
        }
        _ => {}
    }
}

/// A bar of blue lights on the roof.
fn beacons(b: &mut Build<'_>, car: &Car, x: f32, top: f32) {
    let half = car.half * 0.6;
    b.block("bar", [x - 0.1, -half, car.roof - 0.005], [x + 0.1, half, car.roof + 0.02], BLACK_PLASTIC);
    for (from, to, mat) in [(-0.98, -0.3, BLUE_PLASTIC), (-0.3, 0.3, WHITE_PLASTIC), (0.3, 0.98, BLUE_PLASTIC)] {
        b.rounded_block("beacon", [x - 0.09, half * from, car.roof + 0.015], [x + 0.09, half * to, top], 0.02, mat);
    }
}

/// White lettering on the doors.
fn stripe_text(b: &mut Build<'_>, car: &Car, z: f32) {
    for side in [-1.0, 1.0] {
        let y = side * car.half;
        for i in 0..6 {
            let x = car.x(0.38 + 0.03 * i as f32);
            b.block("letter", [x - 0.03, y - 0.005, z - 0.02], [x + 0.03, y + 0.005, z + 0.06], WHITE);
        }
    }
}
