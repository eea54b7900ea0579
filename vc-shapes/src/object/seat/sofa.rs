//! Sofas and armchairs: a base, arms, seat cushions and back cushions.

use crate::material::*;
use crate::object::table::frame::{Four, Lean, baluster};
use crate::solid::{Axis, Build, CORNERS, Cut, at_least, leg};

/// The design of arms.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Arm {
    /// An upright box.
    Box,
    /// A thick pad with round edges.
    Pad,
    /// A box under a roll.
    Roll,
    /// Lower in front than at the back.
    Slope,
    /// A frame of wood.
    Frame,
}

/// A sofa under construction: half depth, half width, height, and further dimensions.
struct Sofa {
    x: f32,
    y: f32,
    h: f32,
    /// The height of the seat.
    seat: f32,
    /// The thickness of cushions.
    cushion: f32,
    /// The height of legs.
    lift: f32,
    arm: Arm,
    /// The width and height of arms.
    arms: (f32, f32),
    /// The thickness of the back's frame.
    back: f32,
    tilt: f32,
    cloth: MaterialId,
    wood: MaterialId,
    tufted: bool,
    /// Whether the cushion is one piece instead of one for each seat.
    bench: bool,
}

impl Sofa {
    fn new(b: &mut Build<'_>) -> Self {
        at_least(b, [0.35, 0.32, 0.32]);
        let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
        let arm = b.choose(&[Arm::Box, Arm::Box, Arm::Pad, Arm::Pad, Arm::Roll, Arm::Slope, Arm::Frame]);
        let tufted = arm == Arm::Roll && b.rng.chance(0.6);
        let seat = (b.vary(0.4, 0.46)).min(h * 0.55);
        let lift = b.choose(&[0.03_f32, 0.07, 0.12, 0.16]).min(seat * 0.35);
        let wide = match arm {
            Arm::Frame => 0.05,
            Arm::Box => b.vary(0.09, 0.2),
            _ => b.vary(0.14, 0.22),
        };
        let high = if tufted { h * 0.92 } else { seat + b.vary(0.35, 0.6) * (h - seat) };
        let wood = b.choose(&[b.style.wood, b.style.wood, b.style.metal, BLACK]);
        Self {
            x,
            y,
            h,
            seat,
            cushion: b.vary(0.11, 0.17).min(seat * 0.38),
            lift: if arm == Arm::Frame { seat * 0.42 } else { lift },
            arm,
            arms: (wide.min(y * 0.22), high),
            back: b.vary(0.07, 0.13).min(x * 0.28),
            tilt: b.vary(0.1, 0.22).min(x * 0.5 / (h - seat)),
            cloth: b.style.upholstery,
            wood: if arm == Arm::Frame { b.style.wood } else { wood },
            tufted,
            bench: b.rng.chance(0.2),
        }
    }

    /// Builds everything, with `count` seats side by side.
    fn build(&self, b: &mut Build<'_>, count: usize) {
        self.legs(b);
        let inner = self.y - self.arms.0;
        self.base(b, inner);
        for side in [-1.0, 1.0] {
            self.arm(b, side);
        }
        self.cushions(b, (-inner, inner), count);
    }

    fn legs(&self, b: &mut Build<'_>) {
        let (r, lift) = (0.024_f32.min(self.x * 0.1), self.lift);
        if self.arm == Arm::Frame {
            return;
        }
        let inset = if lift > 0.1 { 0.03 } else { 0.0 };
        // Pads are round at the bottom, so legs stand further in.
        let margin = if self.arm == Arm::Pad { (self.arms.0 * 0.34 - 0.02).max(0.02) } else { 0.02 };
        let feet = (self.x - margin, self.y - margin);
        let heads = (feet.0 - inset, feet.1 - inset);
        if self.tufted || self.arm == Arm::Roll {
            for (sx, sy) in CORNERS {
                baluster(b, "leg", [sx * (heads.0 - r), sy * (heads.1 - r), 0.0], r * 1.3, lift + 0.004, self.wood);
            }
        } else {
            Four { feet, heads, height: lift + 0.004, radii: (r * 0.6, r), cut: Cut::Round }.build(b, self.wood);
        }
    }

    /// The upholstered box below the cushions and the frame of the back.
    fn base(&self, b: &mut Build<'_>, inner: f32) {
        let top = self.seat - self.cushion;
        let y = inner + 0.004;
        if self.arm == Arm::Frame {
            let z = top - 0.05_f32.min(top * 0.3);
            b.block("frame", [0.02 - self.x, -y, z], [self.x - 0.012, y, top + 0.002], self.wood);
            return;
        }
        b.rounded_block("base", [0.002 - self.x, -y, self.lift], [self.x - 0.012, y, top + 0.004], 0.015, self.cloth);
        let high = if self.tufted { self.h } else { self.seat + (self.h - self.seat) * 0.82 };
        b.rounded_block(
            "back",
            [-self.x, -self.y + 0.014, self.lift + 0.01],
            [self.back - self.x, self.y - 0.014, high],
            0.03,
            self.cloth,
        );
        if self.tufted {
            let r = self.back * 0.62;
            b.rod(
                "roll",
                [r - self.x, 0.008 - self.y, high - r],
                [r - self.x, self.y - 0.008, high - r],
                r,
                self.cloth,
            );
        }
    }

    fn arm(&self, b: &mut Build<'_>, side: f32) {
        let (w, high) = self.arms;
        let (y0, y1) = ((side * self.y).min(side * (self.y - w)), (side * self.y).max(side * (self.y - w)));
        let (x0, x1, low) = (0.001 - self.x, self.x, self.lift + 0.001);
        match self.arm {
            Arm::Box => b.rounded_block("arm", [x0, y0, low], [x1, y1, high], 0.018, self.cloth),
            Arm::Pad => b.rounded_block("arm", [x0, y0, low], [x1, y1, high], w * 0.42, self.cloth),
            Arm::Roll => {
                let r = w * 0.5;
                b.rounded_block(
                    "arm",
                    [x0, y0 + r * 0.3, low],
                    [x1 - 0.03, y1 - r * 0.3, high - r * 0.6],
                    0.02,
                    self.cloth,
                );
                let y = f32::midpoint(y0, y1);
                b.rod("roll", [x0, y, high - r], [x1 - 0.008, y, high - r], r, self.cloth);
                b.rod("button", [x1 - 0.01, y, high - r], [x1, y, high - r], r * 0.55, self.wood);
            }
            Arm::Slope => {
                let back = high + (self.h - high) * 0.5;
                let outline =
                    [(x0, low), (x1, low), (x1, high * 0.9), (x1 - 0.05, high), (x0 + self.back, back), (x0, back)];
                b.prism("arm", Axis::Y, [0.0, y0, 0.0], &outline, w, self.cloth);
            }
            Arm::Frame => {
                let (r, y) = (w / 2.0, f32::midpoint(y0, y1));
                let lean = (self.h - self.seat) * self.tilt;
                leg(
                    b,
                    "leg",
                    ([x1 - r, y, 0.0], r * 0.7),
                    ([x1 - r - 0.03, y, high - 0.02], r * 0.8),
                    Cut::Square,
                    self.wood,
                );
                let top = (high + 0.1).min(self.h * 0.95);
                leg(b, "leg", ([x0 + r, y, 0.0], r * 0.7), ([x0 + r, y, top], r * 0.7), Cut::Square, self.wood);
                b.rounded_block("arm", [x0 + r * 0.5, y0, high - 0.03], [x1 - 0.02, y1, high], 0.01, self.wood);
                let z = self.seat - self.cushion;
                b.block("rail", [x0 + r, y - r * 0.4, z - 0.05], [x1 - 2.0 * r, y + r * 0.4, z], self.wood);
                b.block(
                    "rail",
                    [x0 + r, y - r * 0.3, z + lean.max(0.05)],
                    [x0 + r * 2.0, y + r * 0.3, z + lean.max(0.05) + 0.03],
                    self.wood,
                );
            }
        }
    }

    fn lean(&self) -> Lean {
        let set_back = if self.arm == Arm::Frame { 0.03 } else { self.back * 0.75 };
        let thick = if self.tufted { 0.06 } else { 0.15_f32.min(self.x * 0.32) };
        let top = if self.tufted { self.h * 0.96 } else { self.h };
        Lean { back: set_back - self.x, z: (self.seat - 0.02, top), thickness: thick, tilt: self.tilt }
    }

    /// Cushions on the base and against the back, between two Y coordinates, and the surfaces of
    /// the seats.
    fn cushions(&self, b: &mut Build<'_>, y: (f32, f32), count: usize) {
        let (lean, low) = (self.lean(), self.seat - self.cushion);
        let count = count.max(1);
        let wide = (y.1 - y.0) / count as f32;
        let rear = (lean.front(self.seat) - 0.08).max(0.01 - self.x);
        let (first, last) = (lean.front(self.seat) + 0.012, self.x - 0.035);
        for i in 0..count {
            let (a, c) = (y.0 + wide * i as f32 + 0.002, y.0 + wide * (i + 1) as f32 - 0.002);
            if !self.bench {
                b.rounded_block(
                    "cushion",
                    [rear, a, low + 0.002],
                    [self.x, c, self.seat],
                    self.cushion * 0.36,
                    self.cloth,
                );
            }
            let name = if count == 1 { "seat".into() } else { format!("seat_{}", i + 1) };
            let half = ((last - first) / 2.0, wide / 2.0 - 0.035);
            b.top(
                &name,
                [f32::midpoint(first, last), f32::midpoint(a, c), self.seat],
                (half.0.max(0.02), half.1.max(0.02)),
            );
            if !self.tufted {
                lean.pad(b, "back_cushion", (a + 0.004, c - 0.004), lean.thickness * 0.42, self.cloth);
            }
        }
        if self.bench {
            b.rounded_block(
                "cushion",
                [rear, y.0 + 0.002, low + 0.002],
                [self.x, y.1 - 0.002, self.seat],
                self.cushion * 0.36,
                self.cloth,
            );
        }
        if self.tufted {
            lean.pad(b, "back_cushion", (y.0 + 0.003, y.1 - 0.003), 0.025, self.cloth);
            self.buttons(b, &lean, y);
        }
    }

    /// Buttons in staggered rows on the back.
    fn buttons(&self, b: &mut Build<'_>, lean: &Lean, y: (f32, f32)) {
        let count = ((y.1 - y.0) / 0.16).clamp(2.0, 14.0) as usize;
        let pitch = (y.1 - y.0) / count as f32;
        lean.posed(b, |b, length, _| {
            for row in 0..2 {
                for i in 0..count - row {
                    let cy = y.0 + pitch * (i as f32 + 0.5 + 0.5 * row as f32);
                    let z = length * (0.5 + 0.26 * row as f32);
                    b.rod("button", [-0.004, cy, z], [0.006, cy, z], 0.011, self.wood);
                }
            }
        });
    }

    /// The number of seats that fit side by side.
    fn count(&self) -> usize {
        (((self.y - self.arms.0) * 2.0) / 0.62).round().clamp(1.0, 5.0) as usize
    }
}

/// A sofa: boxed, padded, rolled and tufted, sloping, or in a wooden frame.
pub(super) fn sofa(b: &mut Build<'_>) {
    let sofa = Sofa::new(b);
    let count = sofa.count();
    sofa.build(b, count);
}

/// A sofa that unfolds: its base pulls out to the front.
pub(super) fn sofa_bed(b: &mut Build<'_>) {
    let mut sofa = Sofa::new(b);
    if matches!(sofa.arm, Arm::Frame | Arm::Roll) {
        sofa.arm = Arm::Box;
    }
    (sofa.tufted, sofa.lift) = (false, 0.04);
    sofa.arms.1 = sofa.arms.1.min(sofa.h * 0.85);
    let inner = sofa.y - sofa.arms.0;
    let low = sofa.seat - sofa.cushion;
    sofa.legs(b);
    for side in [-1.0, 1.0] {
        sofa.arm(b, side);
    }
    let high = sofa.seat + (sofa.h - sofa.seat) * 0.82;
    b.rounded_block(
        "back",
        [-sofa.x, 0.006 - sofa.y, sofa.lift],
        [sofa.back - sofa.x, sofa.y - 0.006, high],
        0.03,
        sofa.cloth,
    );
    let rear = sofa.back - sofa.x + 0.005;
    let middle = low - 0.1_f32.min(low * 0.35);
    b.block("base", [rear, 0.002 - inner, middle + 0.003], [sofa.x - 0.03, inner - 0.002, low], sofa.cloth);
    b.slide([1.0, 0.0, 0.0], (2.0 * sofa.x - 0.2).clamp(0.1, 0.75), |b| {
        b.rounded_block(
            "bed",
            [rear + 0.02, 0.006 - inner, sofa.lift + 0.005],
            [sofa.x - 0.012, inner - 0.006, middle],
            0.01,
            sofa.cloth,
        );
        b.block("pull", [sofa.x - 0.014, -0.08, middle - 0.06], [sofa.x - 0.002, 0.08, middle - 0.03], sofa.wood);
    });
    let count = sofa.count();
    sofa.cushions(b, (-inner, inner), count);
}

/// A sofa with one end extended to the front, on the left or on the right.
pub(super) fn corner_sofa(b: &mut Build<'_>) {
    at_least(b, [0.7, 1.0, 0.32]);
    let (full_x, full_y) = (b.size.x / 2.0, b.size.y / 2.0);
    let deep = (full_x * 2.0 * 0.62).min(0.98);
    let side = b.choose(&[-1.0, 1.0]);
    b.size.x = deep;
    let mut sofa = Sofa::new(b);
    if matches!(sofa.arm, Arm::Frame | Arm::Slope) {
        sofa.arm = Arm::Box;
    }
    (sofa.tufted, sofa.bench) = (false, false);
    sofa.arms.1 = sofa.arms.1.min(sofa.h * 0.85);
    let inner = sofa.y - sofa.arms.0;
    let (low, wide) = (sofa.seat - sofa.cushion, (full_y * 0.7).min(0.95));
    let split = inner - wide;
    let corner = b.rng.chance(0.45);
    b.at([deep / 2.0 - full_x, 0.0, 0.0], 0.0, |b| {
        sofa.base(b, inner);
        sofa.arm(b, -side);
        let seats = ((inner + split) / 0.65).round().clamp(1.0, 4.0) as usize;
        let rest = if side > 0.0 { (-inner, split) } else { (-split, inner) };
        sofa.cushions(b, rest, seats);
    });
    // The extended part, from the back frame to the front.
    let (y0, y1) = if side > 0.0 { (split, inner) } else { (-inner, -split) };
    let lean = sofa.lean();
    let shift = deep / 2.0 - full_x;
    let front = lean.front(sofa.seat) + shift;
    let from = deep - full_x - 0.02;
    b.rounded_block(
        "base",
        [from, y0 + 0.001, sofa.lift],
        [full_x - 0.012, y1 + 0.003, low + 0.003],
        0.015,
        sofa.cloth,
    );
    b.rounded_block(
        "cushion",
        [front - 0.08, y0 + 0.002, low + 0.002],
        [full_x, y1 - 0.002, sofa.seat],
        sofa.cushion * 0.36,
        sofa.cloth,
    );
    b.at([shift, 0.0, 0.0], 0.0, |b| {
        lean.pad(b, "back_cushion", (y0 + 0.006, y1 - 0.006), lean.thickness * 0.42, sofa.cloth)
    });
    let high = if corner { sofa.seat + (sofa.h - sofa.seat) * 0.82 } else { sofa.arms.1 };
    let (a, c) = (side * sofa.y, side * inner);
    let end = if corner { full_x } else { from + 0.02 };
    b.rounded_block("arm", [0.001 - full_x, a.min(c), sofa.lift + 0.001], [end, a.max(c), high], 0.02, sofa.cloth);
    let mut pad = 0.0;
    if corner {
        // A second row of back cushions along the side.
        pad = 0.14_f32.min(wide * 0.2);
        let (a, c) = (c, c - side * pad);
        let x0 = front + 0.03;
        let half = f32::midpoint(x0, full_x - 0.02);
        for (x0, x1) in [(x0, half - 0.002), (half + 0.002, full_x - 0.02)] {
            b.rounded_block(
                "back_cushion",
                [x0, a.min(c), sofa.seat - 0.02],
                [x1, a.max(c), sofa.h * 0.985],
                0.05,
                sofa.cloth,
            );
        }
    }
    let (first, last) = (front + 0.04, full_x - 0.035);
    let (y0, y1) = if side > 0.0 { (y0 + 0.04, y1 - pad - 0.04) } else { (y0 + pad + 0.04, y1 - 0.04) };
    b.top(
        "lie",
        [f32::midpoint(first, last), f32::midpoint(y0, y1), sofa.seat],
        ((last - first) / 2.0, (y1 - y0) / 2.0),
    );
    corner_legs(b, &sofa, (full_x, full_y), deep, (side, split));
}

/// Feet below every corner of an L.
fn corner_legs(b: &mut Build<'_>, s: &Sofa, full: (f32, f32), deep: f32, end: (f32, f32)) {
    let r = 0.024;
    let (x, y) = (full.0 - 0.05, full.1 - 0.05);
    let (side, split) = end;
    let spots = [
        (-x, -y),
        (-x, y),
        (deep - full.0 - 0.06, -side * y),
        (x, side * (full.1 - s.arms.0 - 0.05)),
        (x, side * (split + 0.05)),
    ];
    for (cx, cy) in spots {
        leg(b, "leg", ([cx, cy, 0.0], r * 0.7), ([cx, cy, s.lift + 0.004], r), Cut::Round, s.wood);
    }
}

/// A chair with arms and upholstery: like a sofa for one, a wing chair, a tub chair or a wooden
/// lounge chair.
pub(super) fn armchair(b: &mut Build<'_>) {
    let mut sofa = Sofa::new(b);
    sofa.bench = false;
    sofa.cloth = b.choose(&[b.style.upholstery, b.style.accent]);
    match b.rng.below(6) {
        0 => wing_chair(b, &mut sofa),
        1 => tub_chair(b, &sofa),
        2 => {
            (sofa.arm, sofa.tufted, sofa.tilt) = (Arm::Frame, false, 0.28);
            (sofa.arms.0, sofa.lift, sofa.wood) = (0.05_f32.min(sofa.y * 0.15), sofa.seat * 0.5, b.style.wood);
            sofa.arms.1 = sofa.seat + 0.2_f32.min((sofa.h - sofa.seat) * 0.5);
            sofa.build(b, 1);
        }
        _ => sofa.build(b, 1),
    }
}

/// A high back with wings at its sides.
fn wing_chair(b: &mut Build<'_>, s: &mut Sofa) {
    (s.arm, s.tufted) = (Arm::Roll, b.rng.chance(0.4));
    s.arms = (0.14_f32.min(s.y * 0.25), s.seat + (s.h - s.seat) * 0.32);
    s.lift = (s.seat * 0.3).min(0.14);
    s.build(b, 1);
    let (x0, z0) = (0.004 - s.x, s.arms.1 - 0.05);
    let deep = s.back + 0.16_f32.min(s.x * 0.35);
    let outline = [
        (x0, z0),
        (x0 + deep * 1.5, z0),
        (x0 + deep * 1.2, z0 + (s.h - z0) * 0.35),
        (x0 + deep, s.h * 0.97),
        (x0 + deep * 0.8, s.h),
        (x0, s.h),
    ];
    let t = 0.06_f32.min(s.y * 0.12);
    for side in [-1.0_f32, 1.0] {
        let y = side * (s.y - 0.01 - t / 2.0);
        b.prism("wing", Axis::Y, [0.0, y - t / 2.0, 0.0], &outline, t, s.cloth);
    }
    b.rounded_block("back", [x0, -s.y + 0.02, s.seat], [x0 + s.back, s.y - 0.02, s.h - 0.003], 0.03, s.cloth);
}

/// A rounded shell around one thick cushion.
fn tub_chair(b: &mut Build<'_>, s: &Sofa) {
    let (r, t) = (s.x.min(s.y), 0.09_f32.min(s.y * 0.2));
    let low = s.lift.max(0.04);
    let four = Four {
        feet: (r * 0.8, r * 0.8),
        heads: (r * 0.7, r * 0.7),
        height: low + 0.01,
        radii: (0.014, 0.02),
        cut: Cut::Round,
    };
    four.build(b, s.wood);
    // The shell: segments of a horseshoe, higher at the back.
    let arm = s.seat + (s.h - s.seat) * 0.4;
    let segments = [
        (1.0, 0.0, arm),
        (0.55, 0.0, arm + (s.h - arm) * 0.15),
        (0.0, 0.0, arm + (s.h - arm) * 0.5),
        (-0.55, 0.2, arm + (s.h - arm) * 0.9),
        (-0.92, 0.62, s.h),
        (-1.0, 1.0, s.h),
    ];
    let outer = |k: (f32, f32, f32)| (k.0 * s.x, (1.0 - k.1) * s.y);
    for pair in segments.windows(2) {
        let ((ax, ay), (cx, cy)) = (outer(pair[0]), outer(pair[1]));
        let inset = |x: f32, y: f32| (x + if x < -0.3 * s.x { t } else { 0.0 }, (y - t).max(0.0));
        let ((ex, ey), (fx, fy)) = (inset(ax, ay), inset(cx, cy));
        for side in [-1.0, 1.0] {
            let column = |x: f32, y: f32, top: f32| [[x, side * y, low], [x, side * y, top]];
            let points: Vec<_> = [
                column(ax, ay, pair[0].2),
                column(cx, cy, pair[1].2),
                column(ex, ey, pair[0].2),
                column(fx, fy, pair[1].2),
            ]
            .concat();
            b.hull("shell", &points, s.cloth);
        }
    }
    let y = s.y - t - 0.004;
    let rear = -s.x * 0.55;
    b.rounded_block(
        "base",
        [rear - 0.1 * s.x, -y * 0.98, low],
        [s.x * 0.96, y * 0.98, s.seat - s.cushion],
        0.02,
        s.cloth,
    );
    b.rounded_block("cushion", [rear, -y, s.seat - s.cushion - 0.004], [s.x, y, s.seat], s.cushion * 0.4, s.cloth);
    let tilt = 0.15;
    let lean = Lean { back: t * 0.8 - s.x, z: (s.seat - 0.02, s.h * 0.94), thickness: 0.1_f32.min(s.x * 0.25), tilt };
    lean.pad(b, "back_cushion", (-y * 0.62, y * 0.62), 0.045, s.cloth);
    // The shell narrows at the back.
    let (first, last) = ((lean.front(s.seat) + 0.012).max(-0.28 * s.x), s.x - 0.05);
    let half = (s.y * 0.86 - t - 0.015).max(0.02);
    b.top("seat", [f32::midpoint(first, last), 0.0, s.seat], ((last - first) / 2.0, half));
}

/// A fat armchair whose footrest swings up.
pub(super) fn recliner(b: &mut Build<'_>) {
    let mut s = Sofa::new(b);
    s.cloth = b.choose(&[s.cloth, BROWN_LEATHER, BLACK_LEATHER, GREY_FABRIC]);
    (s.arm, s.tufted, s.bench, s.lift) = (b.choose(&[Arm::Pad, Arm::Box]), false, false, 0.05);
    s.arms = (0.19_f32.min(s.y * 0.32), s.seat + (s.h - s.seat) * 0.34);
    s.tilt = 0.2;
    let front = s.x;
    s.x -= 0.03;
    b.at([-0.03, 0.0, 0.0], 0.0, |b| {
        s.legs(b);
        let inner = s.y - s.arms.0;
        s.base(b, inner);
        for side in [-1.0, 1.0] {
            s.arm(b, side);
        }
        let low = s.seat - s.cushion;
        let lean = s.lean();
        // Stacked cushions: small of the back, shoulders, head.
        lean.posed(b, |b, length, t| {
            for (z0, z1, k) in [(0.0, 0.38, 1.0), (0.36, 0.72, 0.98), (0.7, 1.0, 0.94)] {
                b.rounded_block(
                    "back_cushion",
                    [-t, -inner * k + 0.004, length * z0],
                    [-0.012 * (1.0 - k), inner * k - 0.004, length * z1],
                    t * 0.45,
                    s.cloth,
                );
            }
        });
        let (first, last) = (lean.front(s.seat) + 0.012, s.x - 0.04);
        b.rounded_block(
            "cushion",
            [lean.front(s.seat) - 0.08, 0.003 - inner, low],
            [s.x, inner - 0.003, s.seat],
            0.05,
            s.cloth,
        );
        b.top(
            "seat",
            [f32::midpoint(first, last), 0.0, s.seat],
            (((last - first) / 2.0).max(0.02), (inner - 0.04).max(0.02)),
        );
        let z = low - 0.01;
        let reach = front + 0.03;
        b.hinge([s.x - 0.008, 0.0, z], [0.0, -1.0, 0.0], 1.45, |b| {
            b.rounded_block(
                "footrest",
                [s.x - 0.008, 0.006 - inner, s.lift + 0.02],
                [reach, inner - 0.006, z],
                0.025,
                s.cloth,
            );
        });
        let y = s.y - s.arms.0 * 0.5;
        b.rod("lever", [s.x - 0.2, y, s.seat * 0.5], [s.x - 0.2, s.y - 0.001, s.seat * 0.5], 0.012, s.wood);
    });
}

/// A long seat to lie on, with a raised end and half an arm at one side.
pub(super) fn chaise_longue(b: &mut Build<'_>) {
    at_least(b, [0.7, 0.3, 0.32]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (cloth, wood) = (b.choose(&[b.style.upholstery, b.style.accent]), b.choose(&[b.style.wood, b.style.metal]));
    let (seat, lift) = ((h * 0.52).min(0.42), (h * 0.2).min(0.14));
    let four = Four {
        feet: (x - 0.02, y - 0.02),
        heads: (x - 0.06, y - 0.06),
        height: lift + 0.004,
        radii: (0.014, 0.024),
        cut: Cut::Round,
    };
    four.build(b, wood);
    let middle = f32::midpoint(lift, seat);
    b.rounded_block("base", [-x + 0.004, -y + 0.004, lift], [x - 0.01, y - 0.004, middle + 0.01], 0.018, cloth);
    let lean = Lean { back: -x, z: (seat - 0.04, h), thickness: 0.16_f32.min(x * 0.2), tilt: b.vary(0.25, 0.5) };
    b.rounded_block("cushion", [lean.front(seat) - 0.12, -y, middle], [x, y, seat], 0.05, cloth);
    lean.pad(b, "back", (-y * 0.99, y * 0.99), 0.06, cloth);
    let wedge = [
        (-x + 0.006, middle),
        (lean.front(seat), middle),
        (lean.back + lean.thickness, h * 0.72),
        (-x + 0.006, h * 0.72),
    ];
    b.prism("support", Axis::Y, [0.0, -y * 0.94, 0.0], &wedge, y * 1.88, cloth);
    let side = b.choose(&[-1.0_f32, 0.0, 1.0]);
    let mut room = (-y + 0.05, y - 0.05);
    if side != 0.0 {
        let t = 0.1_f32.min(y * 0.3);
        let (a, c) = (side * (y - 0.001), side * (y - t));
        let arm = seat + (h - seat) * 0.6;
        b.rounded_block("arm", [-x + 0.05, a.min(c), middle], [x * 0.15, a.max(c), arm], 0.045, cloth);
        room = if side > 0.0 { (room.0, c - 0.01) } else { (c + 0.01, room.1) };
    } else if b.rng.chance(0.6) {
        let r = 0.07_f32.min(y * 0.2);
        let at = lean.front(seat + r) + r + 0.005;
        b.rod("bolster", [at, -y * 0.8, seat + r - 0.004], [at, y * 0.8, seat + r - 0.004], r, cloth);
    }
    let (first, last) = (lean.front(seat) + 0.16, x - 0.06);
    b.top(
        "seat",
        [f32::midpoint(first, last), f32::midpoint(room.0, room.1), seat],
        ((last - first) / 2.0, (room.1 - room.0) / 2.0),
    );
}
