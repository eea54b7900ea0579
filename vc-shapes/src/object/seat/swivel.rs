//! Swivel chairs on castors.

use crate::material::*;
use crate::object::table::frame::{Lean, STAR};
use crate::object::table::trolley::castor;
use crate::solid::{Build, Cut, SheetRow, at_least, curved_sheet, leg};

/// The dimensions and colours of a chair on a star base.
struct Swivel {
    x: f32,
    y: f32,
    h: f32,
    seat: f32,
    tilt: f32,
    dark: MaterialId,
    cloth: MaterialId,
}

impl Swivel {
    fn new(b: &mut Build<'_>) -> Self {
        at_least(b, [0.25, 0.25, 0.42]);
        let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
        let dark = b.choose(&[BLACK_PLASTIC, BLACK_PLASTIC, GREY_PLASTIC, WHITE_PLASTIC]);
        let cloth =
            b.choose(&[BLACK_FABRIC, CHARCOAL_FABRIC, GREY_FABRIC, b.style.accent, BLACK_LEATHER, BROWN_LEATHER]);
        Self { x, y, h, seat: (h * 0.46).min(0.4 + 0.07 * h), tilt: b.vary(0.12, 0.2).min(x * 0.8 / h), dark, cloth }
    }

    /// A star base of five arms on castors, and the gas spring.
    fn foot(&self, b: &mut Build<'_>, mat: MaterialId) {
        let wheel = 0.026_f32.min(self.seat * 0.08);
        let reach = self.x.min(self.y) - wheel * 0.6;
        let hub = self.seat * 0.24;
        for (dx, dy) in STAR {
            let end = [dx * (reach - wheel), dy * (reach - wheel), wheel * 2.2];
            leg(b, "arm", (end, wheel * 0.5), ([dx * 0.02, dy * 0.02, hub], wheel * 1.1), Cut::Round, mat);
            castor(b, end, wheel);
        }
        b.cylinder("hub", [0.0, 0.0, hub * 0.55], wheel * 1.85, hub * 0.6, mat);
        b.cylinder("spring", [0.0, 0.0, hub], wheel * 0.6, self.seat - 0.06 - hub, CHROME);
        b.cylinder("spring", [0.0, 0.0, hub], wheel, (self.seat - hub) * 0.45, BLACK_PLASTIC);
        let z = self.seat - 0.095_f32.min(self.seat * 0.3);
        b.block("mechanism", [-0.12, -0.08, z], [0.1, 0.08, z + 0.04], BLACK_PLASTIC);
    }

    /// Armrests on brackets that start below the seat.
    fn arms(&self, b: &mut Build<'_>, half: f32) {
        let (z, under) = (self.seat + (self.h - self.seat) * 0.32, self.seat - 0.07);
        for side in [-1.0, 1.0] {
            let (inner, y) = (side * half * 0.4, side * (self.y - 0.031));
            b.block("bracket", [-0.028, inner.min(y), under + 0.001], [0.028, inner.max(y), under + 0.02], self.dark);
            b.block("bracket", [-0.03, y - 0.012, under], [0.03, y + 0.012, z - 0.02], self.dark);
            b.rounded_block("armrest", [-0.13, y - 0.03, z - 0.03], [0.13, y + 0.03, z], 0.012, self.dark);
        }
    }

    /// The cushion, with its surface from the back's end forwards.
    fn cushion(&self, b: &mut Build<'_>, half: f32, x: (f32, f32), from: f32) {
        let t = 0.075_f32.min(self.seat * 0.25);
        b.rounded_block("seat", [x.0, -half, self.seat - t], [x.1, half, self.seat], 0.032, self.cloth);
        let (from, to) = (from + 0.012, x.1 - 0.03);
        let free = (((to - from) / 2.0).max(0.01), half - 0.04);
        b.top("seat", [f32::midpoint(from, to), 0.0, self.seat], free);
    }

    /// A bar from below the seat to behind the back, which it supports.
    fn spine(&self, b: &mut Build<'_>, rear: f32, upto: f32) {
        let (tall, r) = (self.h - self.seat, 0.02_f32.min(self.y * 0.1));
        let behind = -self.x + r + tall * (1.0 - upto) * self.tilt * 0.9;
        let head = [behind, 0.0, self.seat + tall * upto];
        let z = self.seat - 0.085_f32.min(self.seat * 0.28);
        let knee = [behind.min(rear) - r * 0.3, 0.0, z + r * 0.2];
        leg(b, "spine", (knee, r * 1.1), (head, r * 0.8), Cut::Square, self.dark);
        b.block("spine", [knee[0] - r, -r, z], [0.0, r, z + r * 1.6], self.dark);
    }
}

/// A desk chair: star base, padded or mesh back, often with armrests.
pub(super) fn office_chair(b: &mut Build<'_>) {
    let c = Swivel::new(b);
    let foot = b.choose(&[c.dark, CHROME, BLACK_PLASTIC]);
    c.foot(b, foot);
    let half = c.y * 0.74;
    let (rear, front) = (-c.x * 0.72, c.x * 0.9);
    let tall = c.h - c.seat;
    let lower = match b.rng.below(3) {
        0 => {
            let lean = Lean { back: -c.x, z: (c.seat + tall * 0.12, c.h), thickness: 0.07, tilt: c.tilt };
            lean.pad(b, "back", (-half * 0.95, half * 0.95), 0.034, c.cloth);
            c.spine(b, rear, 0.4);
            lean.front(c.seat)
        }
        1 => {
            // A mesh stretched in a frame, bulging at the lower back.
            let x = |k: f32| -c.x + 0.016 + (1.0 - k) * tall * c.tilt;
            let row = |k: f32, half: f32, rise: f32| {
                let bulge = 0.1 * (1.0 - k) * k * tall.min(0.6);
                SheetRow { at: (x(k) + bulge, c.seat + tall * (0.1 + 0.9 * k)), half, rise }
            };
            let w = half;
            let rows = [
                row(0.0, w * 0.7, 0.03),
                row(0.3, w, 0.05),
                row(0.7, w, 0.05),
                row(0.92, w * 0.9, 0.02),
                row(0.995, w * 0.7, 0.0),
            ];
            curved_sheet(b, "back", &rows, 0.012, c.dark);
            c.spine(b, rear, 0.42);
            x(0.0) + 0.06
        }
        _ => {
            // A manager's chair: stacked cushions and a headrest.
            let x = |k: f32| -c.x + (1.0 - k) * tall * c.tilt;
            let mut lower = 0.0;
            for (z0, z1, w) in [(0.72, 1.0, 0.8), (0.38, 0.74, 0.95), (0.02, 0.4, 0.98)] {
                let z = (c.seat + tall * z0, c.seat + tall * z1);
                let lean = Lean { back: x(z1), z, thickness: 0.09, tilt: c.tilt };
                lean.pad(b, "cushion", (-half * w, half * w), 0.042, c.cloth);
                lower = lean.front(c.seat);
            }
            c.spine(b, rear, 0.15);
            lower
        }
    };
    c.cushion(b, half, (rear, front), lower);
    if b.rng.chance(0.75) {
        c.arms(b, half);
    }
}

/// A racing seat on castors: high back with wings, stripes and two cushions.
pub(super) fn gaming_chair(b: &mut Build<'_>) {
    let mut c = Swivel::new(b);
    let stripe = b.choose(&[RED_FABRIC, BLUE_FABRIC, WHITE_LEATHER, PURPLE_FABRIC, GREEN_FABRIC, ROSE_FABRIC]);
    (c.cloth, c.dark) = (b.choose(&[BLACK_LEATHER, BLACK_FABRIC, CHARCOAL_FABRIC]), BLACK_PLASTIC);
    c.seat = c.h * 0.38;
    c.foot(b, BLACK_PLASTIC);
    let (half, rear, front) = (c.y * 0.74, -c.x * 0.6, c.x * 0.88);
    for side in [-1.0_f32, 1.0] {
        let (a, d) = (side * half * 0.8, side * half);
        b.rounded_block(
            "bolster",
            [rear + 0.03, a.min(d), c.seat - 0.08],
            [front - 0.03, a.max(d), c.seat + 0.02],
            0.03,
            stripe,
        );
    }
    let tilt = 0.16_f32.min(c.tilt * 1.2);
    let lean = Lean { back: -c.x, z: (c.seat - 0.02, c.h), thickness: 0.08, tilt };
    c.cushion(b, half * 0.82, (rear, front), lean.front(c.seat) + 0.05);
    lean.posed(b, |b, length, t| {
        b.rounded_block("back", [-t, -half * 0.72, 0.0], [0.0, half * 0.72, length], 0.038, c.cloth);
        for side in [-1.0_f32, 1.0] {
            for (low, high, w) in [(0.08, 0.5, 0.94), (0.5, 0.84, 1.0)] {
                let (a, d) = (side * half * 0.62, side * half * w);
                b.rounded_block(
                    "wing",
                    [-t * 0.85, a.min(d), length * low],
                    [0.025, a.max(d), length * high],
                    0.028,
                    c.cloth,
                );
            }
            let y = side * half * 0.42;
            b.block("stripe", [-0.01, y - 0.018, length * 0.1], [0.0025, y + 0.018, length * 0.94], stripe);
        }
        b.rounded_block(
            "pillow",
            [-0.01, -half * 0.42, length * 0.12],
            [0.045, half * 0.42, length * 0.32],
            0.028,
            stripe,
        );
        b.rounded_block(
            "pillow",
            [-0.01, -half * 0.4, length * 0.76],
            [0.04, half * 0.4, length * 0.92],
            0.028,
            c.cloth,
        );
    });
    c.arms(b, half);
}
