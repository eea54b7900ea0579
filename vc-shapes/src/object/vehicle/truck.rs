//! Lorries: a cab, a chassis and a hollow body.

use std::f32::consts::{FRAC_PI_2, PI};

use super::chassis::{Chassis, PAINTS};
use crate::material::*;
use crate::solid::{Axis, Build, P, at_least, spaced, tapered_tub};

/// A lorry with a closed box, an open bed or a tipper.
pub(super) fn truck(b: &mut Build<'_>) {
    at_least(b, [3.0, 1.1, 1.3]);
    let (l, h) = (b.size.x, b.size.z);
    let cab = b.size.x / 2.0 - (l * b.vary(0.17, 0.25)).clamp(1.0, 2.6);
    let paint = b.one_of(PAINTS);
    let chassis = lorry(b, cab, paint);
    let high = match b.rng.below(3) {
        0 => h * b.vary(0.82, 0.98),
        1 => h,
        _ => h * b.vary(0.75, 0.9),
    };
    chassis.cabin(b, high);
    let (low, end, top) = ([-chassis.front, -chassis.half, chassis.deck], chassis.cab - 0.12, h);
    let mat = b.choose(&[WHITE_METAL, SILVER_METAL, chassis.paint, BLUE, GREEN_METAL]);
    if high < h * 0.99 || b.rng.chance(0.4) {
        cargo_box(b, low, [end, chassis.half, top], mat);
    } else if b.rng.chance(0.5) {
        let (half, wall) = ((end - low[0]) / 2.0, 0.05);
        let middle = (low[0] + end) / 2.0;
        tapered_tub(
            b,
            "tipper",
            [middle, 0.0, low[2]],
            (half - 0.15, chassis.half - 0.1),
            (half, chassis.half),
            (h - low[2]) * 0.55,
            wall,
            mat,
        );
        b.inside("compartment", [middle, 0.0, low[2] + wall], (half - 0.3, chassis.half - 0.25), h - low[2]);
    } else {
        flatbed(b, low, [end, chassis.half, top], mat);
    }
}

fn lorry(b: &mut Build<'_>, cab: f32, paint: MaterialId) -> Chassis {
    let (front, half) = (b.size.x / 2.0, b.size.y / 2.0);
    let wheel = (b.size.z * b.vary(0.135, 0.15)).clamp(0.15, 0.55);
    let chassis = Chassis { front, half, wheel, deck: wheel * 2.15, cab, paint };
    chassis.build(b);
    chassis
}

/// A hollow box with two doors at the rear.
fn cargo_box(b: &mut Build<'_>, low: P, high: P, mat: MaterialId) {
    let t = 0.04;
    let (x0, x1, y, z0, z1) = (low[0] + 0.02, high[0], high[1], low[2] + 0.002, high[2]);
    b.block("floor", [x0 + t, -y, z0], [x1, y, z0 + 0.1], b.style.metal);
    b.block("roof", [x0 + t, -y, z1 - t], [x1, y, z1], mat);
    b.block("front", [x1 - t, -y + t, z0 + 0.1], [x1, y - t, z1 - t], mat);
    for side in [-1.0, 1.0] {
        let cy = side * (y - t / 2.0);
        b.block("side", [x0 + t, cy - t / 2.0, z0 + 0.1], [x1, cy + t / 2.0, z1 - t], mat);
        b.hinge([x0, side * y, 0.0], [0.0, 0.0, -side], FRAC_PI_2 * 1.8, |b| {
            let (from, to) = (side * 0.004, side * y);
            b.block("door", [x0, from.min(to), z0], [x0 + t - 0.002, from.max(to), z1], mat);
            for share in [0.15, 0.5] {
                b.rod(
                    "bar",
                    [x0 - 0.008, side * y * share, z0 + 0.05],
                    [x0 - 0.008, side * y * share, z1 - 0.05],
                    0.012,
                    GALVANISED,
                );
            }
        });
    }
    let centre = [(x0 + x1) / 2.0, 0.0, z0 + 0.1];
    b.inside("compartment", centre, ((x1 - x0) / 2.0 - 2.0 * t, y - t - 0.02), z1 - z0 - 0.1 - t - 0.01);
}

/// An open bed with low side boards; the rear board folds down.
fn flatbed(b: &mut Build<'_>, low: P, high: P, mat: MaterialId) {
    let (x0, x1, y, z) = (low[0] + 0.03, high[0], high[1], low[2] + 0.002);
    let side = (high[2] - z) * b.vary(0.18, 0.3);
    b.block("bed", [x0, -y, z], [x1, y, z + 0.1], b.style.wood);
    b.block("front", [x1 - 0.05, -y, z + 0.1], [x1, y, z + side * 1.8], mat);
    for s in [-1.0, 1.0] {
        let cy = s * (y - 0.02);
        b.block("board", [x0, cy - 0.018, z + 0.1], [x1 - 0.05, cy + 0.018, z + side], mat);
    }
    b.hinge([x0 - 0.025, 0.0, z + 0.05], [0.0, -1.0, 0.0], PI * 0.9, |b| {
        b.block("flap", [x0 - 0.025, -y + 0.04, z + 0.05], [x0 - 0.002, y - 0.04, z + side], mat);
    });
    let centre = [(x0 + x1) / 2.0, 0.0, z + 0.1];
    b.inside("compartment", centre, ((x1 - x0) / 2.0 - 0.06, y - 0.05), high[2] - z);
}

/// A garbage truck: a rounded body and a hopper at the rear.
pub(super) fn garbage_truck(b: &mut Build<'_>) {
    at_least(b, [4.0, 1.2, 1.6]);
    let (l, h) = (b.size.x, b.size.z);
    let cab = l / 2.0 - l * b.vary(0.19, 0.23);
    let paint = b.choose(&[ORANGE, GREEN_METAL, WHITE_METAL, YELLOW_METAL, BLUE_METAL]);
    let chassis = lorry(b, cab, paint);
    let cab_top = h * b.vary(0.8, 0.92);
    chassis.cabin(b, cab_top);
    let mat = b.choose(&[paint, paint, SILVER_METAL, WHITE_METAL]);
    let (y, z0) = (chassis.half, chassis.deck + 0.002);
    let hopper = -chassis.front + l * b.vary(0.18, 0.23);
    let section: Vec<(f32, f32)> =
        vec![(-y * 0.9, z0), (y * 0.9, z0), (y * 0.98, h * 0.6), (y * 0.75, h), (-y * 0.75, h), (-y * 0.98, h * 0.6)];
    b.prism("body", Axis::X, [hopper, 0.0, 0.0], &section, chassis.cab - 0.15 - hopper, mat);
    for x in spaced(5, hopper + 0.2, chassis.cab - 0.4) {
        for side in [-1.0, 1.0] {
            let (foot, top) = ([x, side * y * 0.9, z0 + 0.05], [x, side * y * 0.96, h * 0.59]);
            b.rod("rib", foot, top, 0.04_f32.min(y * 0.035), mat);
        }
    }
    let (rear, sill) = (-chassis.front, z0 + (h - z0) * 0.18);
    // The hopper's sides start above the wheels, which stand at its front end.
    let under = z0 - 0.1_f32.min(chassis.wheel * 0.1);
    let cheek = [
        (hopper + 0.02, under),
        (hopper + 0.02, h * 0.985),
        (rear + (hopper - rear) * 0.45, h * 0.985),
        (rear, h * 0.62),
        (rear, under),
    ];
    for side in [-1.0, 1.0] {
        let cy = side * y * 0.9;
        let (near, far) = (side * (y * 0.9 - 0.1), side * (y * 0.9 + 0.02));
        b.prism("cheek", Axis::Y, [0.0, cy - 0.04, 0.0], &cheek, 0.08, mat);
        b.block(
            "beacon",
            [hopper - 0.3, near.min(far), h * 0.94],
            [hopper - 0.15, near.max(far), h * 0.995],
            SIGNAL_AMBER,
        );
    }
    b.block("hopper", [rear + 0.01, -y * 0.87, under + 0.005], [hopper + 0.01, y * 0.87, z0 + 0.05], mat);
    b.block("sill", [rear + 0.01, -y * 0.87, z0 + 0.04], [rear + 0.09, y * 0.87, sill], mat);
    let hood = [
        (hopper + 0.01, h * 0.97),
        (rear + (hopper - rear) * 0.45, h * 0.97),
        (rear + 0.01, h * 0.61),
        (rear + 0.08, h * 0.6),
        (rear + (hopper - rear) * 0.5, h * 0.93),
        (hopper + 0.01, h * 0.93),
    ];
    b.hinge([rear + (hopper - rear) * 0.45, 0.0, h * 0.97], [0.0, 1.0, 0.0], 0.6, |b| {
        b.prism("tailgate", Axis::Y, [0.0, -y * 0.85, 0.0], &hood, y * 1.7, GREY);
    });
    b.block("lifter", [rear + 0.002, -y * 0.6, sill - 0.12], [rear + 0.03, y * 0.6, sill + 0.02], IRON);
    let centre = [(rear + 0.1 + hopper) / 2.0, 0.0, z0 + 0.05];
    b.inside("compartment", centre, ((hopper - rear - 0.1) / 2.0 - 0.03, y * 0.84), h * 0.55 - z0);
    b.block("stripe", [hopper + 0.1, -y * 0.985, h * 0.6 - 0.06], [chassis.cab - 0.25, y * 0.985, h * 0.6], WHITE);
}

/// A fire truck: a crew cab, shuttered lockers, a ladder on the roof, blue lights.
pub(super) fn fire_truck(b: &mut Build<'_>) {
    at_least(b, [3.5, 1.2, 1.5]);
    let (l, h) = (b.size.x, b.size.z);
    let cab = l / 2.0 - l * b.vary(0.27, 0.33);
    let chassis = lorry(b, cab, RED_METAL);
    let roof = h * b.vary(0.84, 0.88);
    chassis.cabin(b, roof);
    let (low, high) =
        ([-chassis.front, -chassis.half * 0.97, chassis.deck], [chassis.cab + 0.01, chassis.half * 0.97, roof]);
    cargo_box(b, low, high, RED_METAL);
    let lockers = b.rng.count(3, 5);
    let step = (chassis.cab + chassis.front - 0.3) / lockers as f32;
    for side in [-1.0, 1.0] {
        let y = side * chassis.half * 0.97;
        for x in spaced(lockers, -chassis.front + 0.15 + step / 2.0, chassis.cab - 0.15 - step / 2.0) {
            b.block(
                "shutter",
                [x - step * 0.45, y - 0.012, chassis.deck + 0.12],
                [x + step * 0.45, y + 0.012, roof * 0.86],
                GALVANISED,
            );
            b.block(
                "handle",
                [x - step * 0.2, y - 0.02_f32.min(chassis.half * 0.025), chassis.deck + 0.16],
                [x + step * 0.2, y + 0.02_f32.min(chassis.half * 0.025), chassis.deck + 0.2],
                BLACK_PLASTIC,
            );
        }
        b.block(
            "stripe",
            [-chassis.front + 0.1, y - 0.008, roof * 0.88],
            [chassis.cab, y + 0.008, roof * 0.94],
            YELLOW,
        );
    }
    b.block(
        "stripe",
        [chassis.cab + 0.02, -chassis.half * 0.966, roof * 0.4],
        [chassis.front - 0.3, chassis.half * 0.966, roof * 0.45],
        WHITE,
    );
    let half = chassis.half * b.vary(0.2, 0.3);
    let (x0, x1, z) =
        (-chassis.front + 0.15, chassis.cab + (chassis.front - chassis.cab) * b.vary(-0.3, 0.6), h - 0.12);
    for cy in [-half, half] {
        b.block("ladder", [x0, cy - 0.03, z], [x1, cy + 0.03, h], SILVER_METAL);
    }
    let rungs = ((x1 - x0) / 0.4) as usize;
    for x in spaced(rungs.clamp(3, 20), x0 + 0.1, x1 - 0.1) {
        b.rod("rung", [x, -half, z + 0.06], [x, half, z + 0.06], 0.025, SILVER_METAL);
    }
    for x in [x0 + 0.4, chassis.cab - 0.4] {
        b.block("rest", [x - 0.06, -half * 1.2, roof - 0.01], [x + 0.06, half * 1.2, z + 0.005], IRON);
    }
    let front = chassis.cab + (chassis.front - chassis.cab) * 0.35;
    for side in [-1.0, 1.0] {
        let (cy, wide) = (side * chassis.half * 0.6, 0.25_f32.min(chassis.half * 0.35));
        b.rounded_block(
            "beacon",
            [front - 0.15, cy - wide, roof - 0.01],
            [front + 0.15, cy + wide, roof + 0.14_f32.min(h - roof)],
            0.03,
            BLUE_PLASTIC,
        );
    }
}
