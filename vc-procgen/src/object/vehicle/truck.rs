//! Lorries, buses and motorhomes: a cab, a chassis and a body that is hollow.

use std::f32::consts::{FRAC_PI_2, PI};

use vc_graph::portable::Portable;

use super::car::pane;
use super::wheel::{Rim, axled, wheel};
use crate::material::*;
use crate::object::build::{Axis, Build, P};
use crate::object::park::shape::{grown, spaced, tub};

const PAINTS: &[Mat] = &[WHITE_METAL, RED_METAL, BLUE_METAL, GREEN_METAL, YELLOW_METAL, SILVER_METAL, NAVY, ORANGE];

/// Measures of a lorry, metres.
struct Chassis {
    front: f32,
    half: f32,
    wheel: f32,
    /// Height of the frame's upper side.
    deck: f32,
    /// Where the cab ends.
    cab: f32,
    paint: Mat,
}

impl Chassis {
    /// The frame and its wheels: two axles, or three under long ones.
    fn build(&self, b: &mut Build<'_>) {
        let rear = -self.front;
        b.block(
            "frame",
            [rear + 0.1, -self.half * 0.45, self.deck - 0.22],
            [self.front - 0.3, self.half * 0.45, self.deck],
            IRON,
        );
        let axles = self.axles();
        let rim = Rim::plain(b);
        let width = self.half * 0.26;
        for (i, &x) in axles.iter().enumerate() {
            for (side, letter) in [(1.0, 'l'), (-1.0, 'r')] {
                let end = ["f", "r", "m"][i];
                let y = side * (self.half - 0.02 - width / 2.0);
                wheel(b, &format!("wheel_{end}{letter}"), [x, y, self.wheel], self.wheel, width, side, rim);
            }
            b.rod("axle", [x, -self.half * 0.8, self.wheel], [x, self.half * 0.8, self.wheel], self.wheel * 0.14, IRON);
            b.block(
                "spring",
                [x - 0.08, -self.half * 0.44, self.wheel - 0.05],
                [x + 0.08, self.half * 0.44, self.deck - 0.1],
                IRON,
            );
        }
    }

    fn axles(&self) -> Vec<f32> {
        let rear = -self.front * 0.6;
        let mut axles = vec![self.front - (self.front - self.cab) * 0.5 - self.wheel * 0.4, rear];
        if self.front > 4.3 {
            axles.push(rear + self.wheel * 2.3);
        }
        axles
    }

    /// The cab: a block with a leaning screen, arches cut out, panes, lights, mirrors.
    fn cabin(&self, b: &mut Build<'_>, high: f32) {
        let (x0, x1, half) = (self.cab, self.front - 0.08, self.half * 0.96);
        let low = self.wheel * 0.75;
        let (arch, r) = (self.axles()[0], self.wheel * 1.15);
        let open = arch - r < x0 + 0.05;
        let belt = low + (high - low) * 0.48;
        let lean = (high - belt) * b.vary(0.05, 0.3);
        let mut outline =
            vec![(x0, if open { self.wheel + r } else { low }), (x0, high), (x1 - lean, high), (x1, belt), (x1, low)];
        let start = ((low - self.wheel) / r).arc_sine();
        let end = if open { PI * 0.5 } else { PI - start };
        outline.extend(
            (0..=8)
                .map(|i| start + (end - start) * i as f32 / 8.0)
                .map(|a| ((arch + r * a.cosine()).max(x0 + 0.01), self.wheel + r * a.sine())),
        );
        b.prism("cab", Axis::Y, [0.0, -half, 0.0], &outline, 2.0 * half, self.paint);
        let screen = [[x1, -half, belt], [x1, half, belt], [x1 - lean, half, high], [x1 - lean, -half, high]];
        pane(b, "windscreen", screen, (0.05, 0.95, 0.05, 0.88), BLACK_GLASS);
        for side in [1.0, -1.0] {
            let y = side * half;
            let (f, k) = ([x1 - lean * 0.5 - 0.05, y, belt], [x0 + (x1 - x0) * 0.2, y, belt]);
            let (ft, kt) = ([x1 - lean - 0.05, y, high], [k[0], y, high]);
            let face = if side > 0.0 { [f, k, kt, ft] } else { [k, f, ft, kt] };
            pane(b, "window", face, (0.04, 0.96, 0.05, 0.85), BLACK_GLASS);
            b.block(
                "seam",
                [k[0] - 0.05, y - 0.003, belt - (belt - low) * 0.5],
                [k[0] - 0.04, y + 0.003, high - 0.1],
                BLACK_PLASTIC,
            );
            b.block(
                "handle",
                [k[0] + 0.05, y - 0.02, belt - 0.14],
                [k[0] + 0.22, y + 0.02, belt - 0.11],
                BLACK_PLASTIC,
            );
            let my = side * (self.half - 0.005);
            b.block(
                "mirror",
                [x1 - 0.05, my.min(y - side * 0.02), belt + 0.1],
                [x1 + 0.05, my.max(y - side * 0.02), belt + (high - belt) * 0.65],
                BLACK_PLASTIC,
            );
            let lamp = side * half * 0.78;
            b.block(
                "headlight",
                [x1 - 0.02, lamp - 0.14, low + 0.12],
                [self.front - 0.03, lamp + 0.14, low + 0.28],
                COOL_BULB,
            );
            b.block(
                "tail_light",
                [-self.front + 0.09, lamp - 0.12, self.deck - 0.2],
                [-self.front + 0.12, lamp + 0.12, self.deck - 0.08],
                SIGNAL_RED,
            );
            b.block(
                "arm",
                [-self.front + 0.1, lamp - 0.05, self.deck - 0.18],
                [-self.front + 0.4, lamp + 0.05, self.deck - 0.1],
                IRON,
            );
            b.block(
                "arm",
                [-self.front + 0.3, (side * self.half * 0.4).min(lamp), self.deck - 0.17],
                [-self.front + 0.39, (side * self.half * 0.4).max(lamp), self.deck - 0.11],
                IRON,
            );
        }
        let bars = b.rng.count(2, 5);
        for z in spaced(bars, low + 0.36, belt - 0.12) {
            b.block("grille", [x1 - 0.01, -half * 0.55, z - 0.025], [x1 + 0.02, half * 0.55, z + 0.025], BLACK_PLASTIC);
        }
        b.soft("bumper", [x1 - 0.1, -half, low - 0.06], [self.front, half, low + 0.1], 0.03, b.style.appliance);
        b.block("plate", [self.front - 0.01, -0.26, low], [self.front + 0.0, 0.26, low + 0.08], WHITE_PLASTIC);
    }
}

/// A lorry with a closed box, an open bed or a tipper.
pub(super) fn truck(b: &mut Build<'_>) {
    grown(b, [3.0, 1.1, 1.3]);
    let (l, h) = (b.size.x, b.size.z);
    let cab = b.size.x / 2.0 - (l * b.vary(0.17, 0.25)).clamp(1.0, 2.6);
    let paint = b.one(PAINTS);
    let chassis = lorry(b, cab, paint);
    let high = match b.rng.below(3) {
        0 => h * b.vary(0.82, 0.98),
        1 => h,
        _ => h * b.vary(0.75, 0.9),
    };
    chassis.cabin(b, high);
    let (low, end, top) = ([-chassis.front, -chassis.half, chassis.deck], chassis.cab - 0.12, h);
    let mat = b.one(&[WHITE_METAL, SILVER_METAL, chassis.paint, BLUE, GREEN_METAL]);
    if high < h * 0.99 || b.rng.chance(0.4) {
        cargo_box(b, low, [end, chassis.half, top], mat);
    } else if b.rng.chance(0.5) {
        let (half, wall) = ((end - low[0]) / 2.0, 0.05);
        let middle = (low[0] + end) / 2.0;
        tub(
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

fn lorry(b: &mut Build<'_>, cab: f32, paint: Mat) -> Chassis {
    let (front, half) = (b.size.x / 2.0, b.size.y / 2.0);
    let wheel = (b.size.z * b.vary(0.135, 0.15)).clamp(0.15, 0.55);
    let chassis = Chassis { front, half, wheel, deck: wheel * 2.15, cab, paint };
    chassis.build(b);
    chassis
}

/// A hollow box with two doors behind.
fn cargo_box(b: &mut Build<'_>, low: P, high: P, mat: Mat) {
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

/// An open bed with low boards; the one behind folds down.
fn flatbed(b: &mut Build<'_>, low: P, high: P, mat: Mat) {
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

/// A garbage truck: a rounded body and a hopper behind.
pub(super) fn garbage_truck(b: &mut Build<'_>) {
    grown(b, [4.0, 1.2, 1.6]);
    let (l, h) = (b.size.x, b.size.z);
    let cab = l / 2.0 - l * b.vary(0.19, 0.23);
    let paint = b.one(&[ORANGE, GREEN_METAL, WHITE_METAL, YELLOW_METAL, BLUE_METAL]);
    let chassis = lorry(b, cab, paint);
    let cab_top = h * b.vary(0.8, 0.92);
    chassis.cabin(b, cab_top);
    let mat = b.one(&[paint, paint, SILVER_METAL, WHITE_METAL]);
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
    // Above the wheels, which stand where the hopper begins.
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
    grown(b, [3.5, 1.2, 1.5]);
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
        b.soft(
            "beacon",
            [front - 0.15, cy - wide, roof - 0.01],
            [front + 0.15, cy + wide, roof + 0.14_f32.min(h - roof)],
            0.03,
            BLUE_PLASTIC,
        );
    }
}

/// A bus: glass all around, seats within, a door on the right that opens.
pub(super) fn bus(b: &mut Build<'_>) {
    grown(b, [4.0, 1.2, 1.4]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let paint = b.one(PAINTS);
    let second = b.one(&[WHITE_METAL, paint, YELLOW_METAL, ANTHRACITE]);
    let wheel = h * b.vary(0.145, 0.16);
    let (low, floor) = (h * 0.1, h * b.vary(0.17, 0.24));
    let (sill, head) = (floor + (h - floor) * b.vary(0.26, 0.34), h * b.vary(0.86, 0.9));
    let axles = [x * b.vary(0.5, 0.62), -x * b.vary(0.48, 0.58)];
    let hinge = (x * 0.97).min(x - 0.13);
    let door = (hinge - 1.1_f32.min(x * 0.25), hinge);
    let side_half = y - 0.03;
    let t = 0.05;
    for side in [-1.0, 1.0] {
        // The lower wall, cut out over the wheels and at the door.
        let end = if side < 0.0 { door.0 } else { x - 0.03 };
        let mut outline = vec![(-x + 0.03, low), (-x + 0.03, sill), (end, sill), (end, low)];
        let r = wheel * 1.13;
        let start = ((low - wheel) / r).arc_sine();
        for c in axles {
            let from = if c + r > end { continue } else { start };
            outline.extend(
                (0..=8)
                    .map(|i| from + (PI - 2.0 * from) * i as f32 / 8.0)
                    .map(|a| (c + r * a.cosine(), wheel + r * a.sine())),
            );
        }
        let cy = side * (side_half - t / 2.0);
        b.prism("wall", Axis::Y, [0.0, cy - t / 2.0, 0.0], &outline, t, paint);
        let panes = b.rng.count(5, 8);
        let step = (end + x - 0.1) / panes as f32;
        for cx in spaced(panes, -x + 0.05 + step / 2.0, end - 0.05 - step / 2.0) {
            b.block(
                "window",
                [cx - step / 2.0 + 0.03, cy - 0.008, sill],
                [cx + step / 2.0 - 0.03, cy + 0.008, head],
                GLASS,
            );
        }
        for cx in spaced(panes + 1, -x + 0.06, end - 0.06) {
            b.block("pillar", [cx - 0.04, cy - t * 0.4, sill], [cx + 0.04, cy + t * 0.4, head], ANTHRACITE);
        }
        b.block(
            "stripe",
            [-x + 0.1, cy - t / 2.0 - 0.004, sill - 0.16],
            [end - 0.1, cy + t / 2.0 + 0.004, sill - 0.06],
            second,
        );
        for (axle, letter) in axles.into_iter().zip(["f", "r"]) {
            let rim = Rim::plain(b);
            let name = format!("wheel_{letter}{}", if side > 0.0 { 'l' } else { 'r' });
            let at = [axle, side * (side_half - 0.02 - y * 0.11), wheel];
            axled(b, &name, at, (wheel, y * 0.22), side, rim, (side_half - t) * 0.72 - 0.002);
        }
        let (near, far) = (side * (y - 0.035), side * y);
        b.block("mirror", [x - 0.1, near.min(far), head - 0.4], [x - 0.02, near.max(far), head + 0.03], BLACK_PLASTIC);
    }
    // Floor between the wheels, higher where they are.
    let inner = side_half - t;
    b.block("floor", [-x + 0.04, -inner * 0.72, low], [x - 0.08, inner * 0.72, floor], GREY_RUBBER);
    for (from, to) in [(-x + 0.04, axles[1] - wheel * 1.2), (axles[1] + wheel * 1.2, axles[0] - wheel * 1.2)] {
        for side in [-1.0, 1.0] {
            let (a, c) = (side * inner * 0.72, side * inner);
            b.block("floor", [from, a.min(c), floor - 0.08], [to, a.max(c), floor - 0.001], GREY_RUBBER);
        }
    }
    b.block("rear", [-x, -side_half, low], [-x + 0.06, side_half, h - 0.06], paint);
    b.block(
        "rear_window",
        [-x - 0.0 + 0.0, -side_half * 0.75, sill],
        [-x + 0.063, side_half * 0.75, head],
        BLACK_GLASS,
    );
    b.block("front", [x - 0.1, -side_half, low], [x - 0.02, side_half, sill], paint);
    b.block("windscreen", [x - 0.07, -side_half + 0.02, sill - 0.005], [x - 0.05, side_half - 0.02, head], GLASS);
    b.block("destination", [x - 0.09, -y * 0.7, head - 0.01], [x - 0.012, y * 0.7, h - 0.08], SCREEN);
    b.block("destination", [x - 0.03, -y * 0.5, head + 0.02], [x - 0.008, y * 0.4, h - 0.12], SIGNAL_AMBER);
    b.soft("roof", [-x + 0.005, -side_half, head], [x - 0.02, side_half, h - 0.02], 0.05, second);
    b.block("vent", [-x * 0.5, -y * 0.4, h - 0.05], [-x * 0.1, y * 0.4, h], second);
    for side in [-1.0, 1.0] {
        let cy = side * side_half * 0.75;
        b.block("headlight", [x - 0.05, cy - 0.16, low + 0.15], [x - 0.005, cy + 0.16, low + 0.3], COOL_BULB);
        b.block("tail_light", [-x - 0.0 + 0.002, cy - 0.1, low + 0.2], [-x + 0.062, cy + 0.1, low + 0.5], SIGNAL_RED);
    }
    b.block("bumper", [x - 0.1, -side_half, low - 0.04], [x, side_half, low + 0.12], ANTHRACITE);
    let dy = -(side_half - t / 2.0);
    b.hinge([door.1, dy, 0.0], [0.0, 0.0, 1.0], FRAC_PI_2, |b| {
        b.block("door", [door.0 + 0.005, dy - 0.012, low + 0.05], [door.1, dy + 0.012, head - 0.01], GLASS);
        for dx in [door.0 + 0.033, (door.0 + door.1) / 2.0, door.1 - 0.04] {
            b.block("door", [dx - 0.03, dy - 0.02, low + 0.02], [dx + 0.03, dy + 0.02, head - 0.02], ANTHRACITE);
        }
    });
    let rows = ((axles[0] - axles[1] - 2.2 * wheel) / 0.85) as usize;
    let cloth = b.one(&[BLUE_FABRIC, RED_FABRIC, GREEN_FABRIC, GREY_FABRIC]);
    let last = (axles[0] - wheel * 2.2).min(axles[0] - wheel * 1.2 - 0.42);
    for cx in spaced(rows.clamp(2, 7), axles[1] + wheel * 1.4, last) {
        for side in [-1.0, 1.0] {
            let (a, c) = (side * inner * 0.34, side * inner * 0.96);
            b.block("seat", [cx, a.min(c), floor - 0.005], [cx + 0.4, a.max(c), floor + 0.42], cloth);
            b.block(
                "seat",
                [cx - 0.08, a.min(c), floor],
                [cx + 0.02, a.max(c), floor + 1.0_f32.min((h - floor) * 0.45)],
                cloth,
            );
        }
    }
    b.inside(
        "compartment",
        [(axles[0] + axles[1]) / 2.0, 0.0, floor],
        ((axles[0] - axles[1]) / 2.0, inner * 0.3),
        head - floor - 0.03,
    );
}

/// A motorhome: a van's nose under a box with an alcove, windows, a door at the side.
pub(super) fn camper_van(b: &mut Build<'_>) {
    grown(b, [2.7, 1.0, 1.25]);
    let (l, h) = (b.size.x, b.size.z);
    let (x, y) = (l / 2.0, b.size.y / 2.0);
    let (paint, wheel) = (b.one(&[WHITE_METAL, CREAM, SILVER_METAL, WHITE_METAL]), h * 0.12);
    let chassis =
        Chassis { front: x, half: y * 0.94, wheel, deck: wheel * 2.2, cab: x - l * b.vary(0.27, 0.32), paint };
    chassis.build(b);
    let nose = h * b.vary(0.66, 0.72);
    let low = wheel * 0.8;
    let (front, half) = (x - 0.06, y * 0.9);
    let (bonnet, scuttle) = (front - l * 0.11, low + (nose - low) * 0.52);
    let (arch, r) = (chassis.axles()[0], wheel * 1.15);
    let start = ((low - wheel) / r).arc_sine();
    let mut outline = vec![
        (chassis.cab, low),
        (chassis.cab, nose),
        (bonnet - (nose - scuttle) * 0.7, nose),
        (bonnet, scuttle),
        (front, scuttle * 0.84),
        (front, low),
    ];
    outline.extend(
        (0..=8)
            .map(|i| start + (PI - 2.0 * start) * i as f32 / 8.0)
            .map(|a| ((arch + r * a.cosine()).max(chassis.cab + 0.01), wheel + r * a.sine())),
    );
    b.prism("cab", Axis::Y, [0.0, -half, 0.0], &outline, 2.0 * half, paint);
    let top = bonnet - (nose - scuttle) * 0.7;
    let screen = [[bonnet, -half, scuttle], [bonnet, half, scuttle], [top, half, nose], [top, -half, nose]];
    pane(b, "windscreen", screen, (0.06, 0.94, 0.06, 0.9), BLACK_GLASS);
    for side in [1.0, -1.0] {
        let cy = side * half;
        let (f, k, t) = ([bonnet - 0.1, cy, scuttle], [chassis.cab + 0.1, cy, scuttle], [top - 0.05, cy, nose]);
        let kt = [k[0], cy, nose];
        let face = if side > 0.0 { [f, k, kt, t] } else { [k, f, t, kt] };
        pane(b, "window", face, (0.05, 0.9, 0.05, 0.85), BLACK_GLASS);
        b.block(
            "headlight",
            [front - 0.05, cy * 0.75 - 0.12, low + 0.2],
            [front + 0.02, cy * 0.75 + 0.12, low + 0.34],
            COOL_BULB,
        );
        b.block(
            "tail_light",
            [-x + 0.003, cy * 0.85 - 0.08, h * 0.28],
            [-x + 0.05, cy * 0.85 + 0.08, h * 0.4],
            SIGNAL_RED,
        );
        b.block(
            "mirror",
            [bonnet - 0.2, (side * y * 0.99).min(cy), scuttle + 0.02],
            [bonnet - 0.1, (side * y * 0.99).max(cy), scuttle + 0.25],
            BLACK_PLASTIC,
        );
    }
    b.block("bumper", [front - 0.1, -half, low - 0.02], [x, half, low + 0.16], GREY);
    b.block("grille", [front - 0.02, -half * 0.4, low + 0.2], [front + 0.015, half * 0.4, low + 0.32], BLACK_PLASTIC);
    living_box(b, &chassis, nose, y);
}

/// The hollow living space, its alcove over the cab, door, windows and awning.
fn living_box(b: &mut Build<'_>, chassis: &Chassis, nose: f32, y: f32) {
    let (x0, x1, h, t) = (-chassis.front + 0.02, chassis.cab + 0.05, b.size.z - 0.06, 0.04);
    let (low, paint, side) = (chassis.deck - 0.05_f32.min(chassis.wheel * 0.12), chassis.paint, y * 0.97);
    let stripe = b.one(&[BLUE, RED, GREY, TERRACOTTA, FOREST]);
    let door = (x0 + (x1 - x0) * b.vary(0.5, 0.62), 0.62_f32.min((x1 - x0) * 0.2));
    let alcove = b.vary(0.6, 1.0) * (chassis.front - x1) * 0.55;
    b.block("floor", [x0 + t, -side + t, low], [x1, side - t, low + 0.07], OAK);
    b.block("roof", [x0, -side, h - t], [x1, side, h], paint);
    b.block("rear", [x0, -side, low], [x0 + t, side, h - t], paint);
    b.block("wall", [x0 + t, side - t, low], [x1, side, h - t], paint);
    b.block("front", [x1 - t, -side + t, nose - 0.01], [x1, side - t, h - t], paint);
    let door_top = low + 0.05 + (h - low) * 0.78;
    for (from, to, z) in [(x0 + t, door.0, low), (door.0 + door.1, x1, low), (door.0, door.0 + door.1, door_top)] {
        b.block("wall", [from, -side, z], [to, -side + t, h - t], paint);
    }
    b.taper(
        "alcove",
        [x1 + alcove / 2.0 - 0.02, 0.0, nose - 0.002],
        (alcove / 2.0, side * 0.98),
        (alcove / 2.0 * 0.7, side * 0.96),
        h - nose,
        paint,
    );
    b.hinge([door.0, -side, 0.0], [0.0, 0.0, -1.0], FRAC_PI_2 * 1.5, |b| {
        b.block(
            "door",
            [door.0 + 0.004, -side, low + 0.01],
            [door.0 + door.1 - 0.004, -side + t * 0.9, door_top - 0.004],
            CREAM,
        );
        b.block(
            "window",
            [door.0 + door.1 * 0.25, -side - 0.004, door_top - 0.7_f32.min(h * 0.3)],
            [door.0 + door.1 * 0.75, -side + 0.01, door_top - 0.15],
            BLACK_GLASS,
        );
        b.block(
            "handle",
            [door.0 + door.1 * 0.8, -side - 0.015, h * 0.5],
            [door.0 + door.1 * 0.92, -side + 0.005, h * 0.53],
            BLACK_PLASTIC,
        );
    });
    let (z0, z1) = (low + (h - low) * 0.48, low + (h - low) * 0.75);
    for (cx, sy) in [(x0 + (x1 - x0) * 0.25, -1.0), (x0 + (x1 - x0) * 0.25, 1.0), (x0 + (x1 - x0) * 0.7, 1.0)] {
        let wide = (x1 - x0) * 0.13;
        b.block("window", [cx - wide, sy * side - 0.008, z0], [cx + wide, sy * side + 0.008, z1], BLACK_GLASS);
    }
    b.block("window", [x0 - 0.008, -side * 0.5, z0], [x0 + 0.01, side * 0.5, z1], BLACK_GLASS);
    for sy in [-1.0, 1.0] {
        let z = low + (h - low) * 0.3;
        let from = if sy < 0.0 { door.0 - 0.05 } else { x1 - 0.1 };
        b.block("stripe", [x0 + 0.1, sy * side - 0.004, z], [from, sy * side + 0.004, z + 0.12], stripe);
    }
    b.rod(
        "awning",
        [x0 + (x1 - x0) * 0.2, -y + 0.05, h - 0.12],
        [x1 - 0.2, -y + 0.05, h - 0.12],
        0.045_f32.min(y * 0.04),
        WHITE,
    );
    b.block("rooflight", [x0 + 0.6, -0.3, h - 0.005], [x0 + 1.2, 0.3, b.size.z], FROSTED_GLASS);
    let centre = [(x0 + x1) / 2.0, 0.0, low + 0.07];
    b.inside("compartment", centre, ((x1 - x0) / 2.0 - 0.1, side - t - 0.03), h - low - 0.07 - t - 0.02);
}
