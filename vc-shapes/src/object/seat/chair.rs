//! Chairs on four legs.

use vc_graph::portable::Portable;

use crate::material::*;
use crate::object::table::frame::{Four, Lean};
use crate::solid::{Axis, Build, Cut, SheetRow, at_least, curved_sheet, leg, ribbon};

/// A chair under construction: half depth, half width, height, and further dimensions.
pub(super) struct Chair {
    pub(super) x: f32,
    pub(super) y: f32,
    pub(super) h: f32,
    /// The height of the seat.
    pub(super) seat: f32,
    /// How far the back leans between seat and top.
    pub(super) rake: f32,
    /// The thickness of legs and posts.
    pub(super) post: f32,
    pub(super) wood: MaterialId,
    pub(super) cloth: MaterialId,
    pub(super) metal: MaterialId,
}

impl Chair {
    pub(super) fn new(b: &mut Build<'_>) -> Self {
        at_least(b, [0.14, 0.13, 0.25]);
        let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
        let seat = (h * 0.55).min(0.4 + 0.055 * h);
        let rake = b.vary(0.1, 0.22) * (h - seat);
        let kids = b.class == "kids_chair";
        let wood = if kids {
            b.choose(&[b.style.wood, WHITE, RED, YELLOW, SKY, GREEN])
        } else {
            b.choose(&[b.style.wood, b.style.wood, b.style.wood, BLACK, WHITE])
        };
        let cloth = b.choose(&[b.style.accent, b.style.upholstery, b.style.accent]);
        let post = (y * b.vary(0.13, 0.18)).max(0.012);
        Self { x, y, h, seat, rake: rake.min(x * 0.4), post, wood, cloth, metal: b.style.metal }
    }

    /// The X of the back's front at a height.
    pub(super) fn back(&self, z: f32) -> f32 {
        let k = ((z - self.seat) / (self.h - self.seat)).clamp(0.0, 1.0);
        self.post + self.rake * (1.0 - k) - self.x
    }

    /// A board across the back, from one height to another.
    fn slat(&self, b: &mut Build<'_>, name: &str, z: (f32, f32), y: (f32, f32), mat: MaterialId) {
        let (inset, t) = (self.post * 0.25, self.post * 0.45);
        let front = |z: f32| self.back(z) - inset;
        let outline = [(front(z.0), z.0), (front(z.1), z.1), (front(z.1) - t, z.1), (front(z.0) - t, z.0)];
        b.prism(name, Axis::Y, [0.0, y.0, 0.0], &outline, y.1 - y.0, mat);
    }

    /// Rear legs that continue as posts of the back.
    fn posts(&self, b: &mut Build<'_>) {
        let (d, foot) = (self.post, -self.x + self.rake * 0.35);
        let seat = self.rake - self.x;
        let outline = [
            (foot, 0.0),
            (foot + d * 0.8, 0.0),
            (seat + d, self.seat),
            (d - self.x, self.h),
            (-self.x, self.h),
            (seat, self.seat),
        ];
        for y in [-self.y, self.y - self.post] {
            b.prism("post", Axis::Y, [0.0, y, 0.0], &outline, self.post, self.wood);
        }
    }

    fn seat_surface(&self, b: &mut Build<'_>, z: f32) {
        let (from, to) = (self.back(z) + 0.02, self.x - 0.02);
        b.top("seat", [f32::midpoint(from, to), 0.0, z], ((to - from) / 2.0, self.y - self.post - 0.005));
    }
}

/// A chair of one of eight designs.
pub(super) fn chair(b: &mut Build<'_>) {
    let chair = Chair::new(b);
    let designs: &[fn(&mut Build<'_>, &Chair)] = match b.class {
        "kitchen_chair" => &[joined, joined, windsor, moulded, tubular],
        "kids_chair" => &[joined, windsor, moulded],
        "dining_chair" => &[joined, joined, padded, padded, bucket, cantilever, windsor, moulded],
        _ => &[joined, joined, windsor, moulded, padded, cantilever, tubular, bucket],
    };
    b.one_of(designs)(b, &chair);
}

/// A chair of square timber: the rear legs continue into a back of slats, spindles, a splat or a
/// cross.
fn joined(b: &mut Build<'_>, c: &Chair) {
    let (r, under) = (c.post / 2.0, c.seat - 0.022);
    let foot = r * b.choose(&[1.0, 0.65]);
    for side in [-1.0, 1.0] {
        let (x, y) = (c.x - 0.006 - r, side * (c.y - 0.004 - r));
        leg(b, "leg", ([x, y, 0.0], foot), ([x, y, under], r), Cut::Square, c.wood);
    }
    c.posts(b);
    let (x0, y) = (c.back(c.seat) - c.post * 0.9, c.y - 0.001);
    if b.rng.chance(0.55) {
        b.rounded_block("seat", [x0, -y, under - 0.002], [c.x, y, c.seat], 0.008, c.wood);
        c.seat_surface(b, c.seat);
    } else {
        b.block("frame", [x0, c.post * 0.1 - y, under - 0.012], [c.x - 0.003, y - c.post * 0.1, under + 0.004], c.wood);
        let inset = c.post + 0.002;
        b.rounded_block(
            "cushion",
            [x0 + c.post, inset - y, under],
            [c.x - 0.004, y - inset, c.seat + 0.012],
            0.018,
            c.cloth,
        );
        c.seat_surface(b, c.seat + 0.012);
    }
    let (drop, rail) = (under - (c.seat * 0.13).min(0.06), c.post * 0.35);
    let (ax, ay) = (c.x - 0.006 - r, c.y - c.post * 0.5);
    for side in [-1.0_f32, 1.0] {
        let cy = side * ay;
        b.block("apron", [x0 + c.post * 0.5, cy - rail, drop], [ax, cy + rail, under], c.wood);
    }
    for cx in [ax, c.back(c.seat) - c.post * 0.5] {
        b.block("apron", [cx - rail, -ay, drop + 0.001], [cx + rail, ay, under - 0.001], c.wood);
    }
    if b.rng.chance(0.4) {
        let z = c.seat * 0.35;
        for side in [-1.0_f32, 1.0] {
            let cy = side * ay;
            b.block(
                "rung",
                [-c.x + c.rake + c.post * 0.5, cy - rail * 0.8, z],
                [ax, cy + rail * 0.8, z + rail * 2.5],
                c.wood,
            );
        }
        b.block("rung", [-rail * 0.8, -ay, z + rail * 0.4], [rail * 0.8, ay, z + rail * 2.2], c.wood);
    }
    back(b, c);
    if b.class == "dining_chair" && b.rng.chance(0.2) {
        arms(b, c);
    }
}

/// The filling between the posts of a back.
fn back(b: &mut Build<'_>, c: &Chair) {
    let (y, tall) = (c.y - c.post * 0.6, c.h - c.seat);
    let top = (c.h - tall * 0.16, c.h - tall * 0.01);
    let low = c.seat + tall * 0.22;
    c.slat(b, "rail", top, (-y, y), c.wood);
    match b.rng.below(5) {
        0 => {
            let count = b.rng.count(1, 4);
            let pitch = (top.0 - low) / count as f32;
            for i in 0..count {
                let z = low + pitch * i as f32;
                c.slat(b, "slat", (z, z + pitch.min(tall * 0.3) * 0.6), (-y, y), c.wood);
            }
        }
        1 => {
            c.slat(b, "rail", (low, low + tall * 0.08), (-y, y), c.wood);
            let (count, z0, z1) = (b.rng.count(3, 7), low + tall * 0.05, top.0 + tall * 0.04);
            for i in 0..count {
                let cy = y * (2.0 * (i as f32 + 1.0) / (count as f32 + 1.0) - 1.0);
                let x = |z: f32| c.back(z) - c.post * 0.47;
                b.rod("spindle", [x(z0), cy, z0], [x(z1), cy, z1], c.post * 0.17, c.wood);
            }
        }
        2 => {
            c.slat(b, "rail", (low - tall * 0.12, low - tall * 0.05), (-y, y), c.wood);
            let wide = y * b.vary(0.25, 0.45);
            c.slat(b, "splat", (low - tall * 0.05, top.0), (-wide, wide), c.wood);
        }
        3 => {
            c.slat(b, "rail", (low, low + tall * 0.08), (-y, y), c.wood);
            let (z0, z1, w) = (low + tall * 0.06, top.0 + tall * 0.02, c.post * 0.3);
            for (k, side) in [(0.0, -1.0), (1.0, 1.0)] {
                let ends = [(z0, -side), (z1, side)].map(|(z, s)| {
                    let x = c.back(z) - c.post * (0.35 + 0.15 * k);
                    [x, s * (y - w), z]
                });
                b.rod("brace", ends[0], ends[1], w * 0.75, c.wood);
            }
        }
        _ => {
            let (z0, z1) = (c.seat + tall * 0.18, top.0 - 0.004);
            c.slat(b, "panel", (z0, z1), (-y, y), c.wood);
            let lean = Lean {
                back: c.back(z1) - c.post * 0.3,
                z: (z0 + 0.01, z1 - 0.01),
                thickness: 0.03,
                tilt: (c.rake / tall).arc_tangent(),
            };
            lean.pad(b, "pad", (c.post - c.y + 0.006, c.y - c.post - 0.006), 0.012, c.cloth);
        }
    }
}

/// Armrests on posts above the front legs.
fn arms(b: &mut Build<'_>, c: &Chair) {
    let z = c.seat + (c.h - c.seat) * 0.42;
    let (r, x1) = (c.post / 2.0, c.x - 0.05);
    for side in [-1.0, 1.0] {
        let y = side * (c.y - r);
        b.rounded_block(
            "arm",
            [c.back(z) - c.post * 0.6, y - r, z - c.post * 0.7],
            [x1 + c.post, y + r, z],
            0.008,
            c.wood,
        );
        b.block("arm_post", [x1 - r, y - r * 0.8, c.seat - 0.01], [x1 + r, y + r * 0.8, z - c.post * 0.5], c.wood);
    }
}

/// A thick seat with splayed round legs and a fan of spindles under a bowed crest.
fn windsor(b: &mut Build<'_>, c: &Chair) {
    let t = (c.seat * 0.09).max(0.012);
    let (under, r) = (c.seat - t, c.post * 0.45);
    let rear = c.back(c.seat) - c.post;
    let mid = f32::midpoint(rear, c.x);
    let half = (c.x - rear) / 2.0;
    b.rounded_block("seat", [rear, -c.y, under], [c.x, c.y, c.seat], t * 0.45, c.wood);
    let (from, to) = (c.back(c.seat) + 0.015, c.x - 0.02);
    b.top("seat", [f32::midpoint(from, to), 0.0, c.seat], ((to - from) / 2.0, c.y - 0.03));
    b.at([mid, 0.0, 0.0], 0.0, |b| {
        let four = Four {
            feet: (half, c.y),
            heads: (half * 0.72, c.y * 0.72),
            height: under + 0.004,
            radii: (r * 0.7, r),
            cut: Cut::Round,
        };
        four.build(b, c.wood);
        let z = c.seat * 0.4;
        four.rung(b, 0, 1, z, r * 0.5, c.wood);
        four.rung(b, 2, 3, z, r * 0.5, c.wood);
        let (p, q) = (four.middle((1.0, 1.0), z), four.middle((-1.0, 1.0), z));
        let x = f32::midpoint(p[0], q[0]);
        b.rod("rung", [x, -p[1], z], [x, p[1], z], r * 0.5, c.wood);
    });
    let crest = (c.h - c.seat) * 0.14;
    let top = c.h - crest;
    let count = b.rng.count(5, 8);
    for i in 0..count {
        let k = 2.0 * i as f32 / (count - 1) as f32 - 1.0;
        let outer = i == 0 || i + 1 == count;
        let x0 = c.back(c.seat) - c.post * 0.45;
        let foot = [x0, k * c.y * 0.78, c.seat - 0.004];
        let head = [c.post * 0.45 - c.x, k * c.y * 0.92, top + crest * 0.4];
        b.rod("spindle", foot, head, if outer { r * 0.62 } else { r * 0.4 }, c.wood);
    }
    b.rounded_block("crest", [-c.x, -c.y, top], [c.post * 0.9 - c.x, c.y, c.h], crest * 0.4, c.wood);
}

/// A moulded shell on splayed wooden legs, wire or tube.
fn moulded(b: &mut Build<'_>, c: &Chair) {
    let colour = b.choose(&[WHITE_PLASTIC, BLACK_PLASTIC, GREY_PLASTIC, RED_PLASTIC, YELLOW_PLASTIC, c.cloth, c.wood]);
    let (s, w, tall) = (c.seat, c.y, c.h - c.seat);
    let rear = c.back(c.seat) - c.post;
    let row = |x: f32, z: f32, half: f32, rise: f32| SheetRow { at: (x, z), half: half * w, rise };
    let deep = (w * 0.22).min(tall * 0.16);
    // The seat's edges rise to form a pan, the back's are drawn forward; rising parts must stay
    // within the width, so the widest row is that of the seat.
    let rows = [
        row(c.x, s - tall * 0.05, 0.72, 0.0),
        row(c.x - 0.04, s, 0.94, deep * 0.1),
        row(0.0, s - tall * 0.02, 1.0, deep * 0.25),
        row(rear + c.rake * 0.3, s, 0.98, deep * 0.7),
        row(rear - c.rake * 0.1, s + tall * 0.18, 0.94, deep),
        row(rear - c.rake * 0.45, s + tall * 0.5, 0.9, deep * 0.7),
        row((rear - c.rake * 0.85).max(0.01 - c.x), s + tall * 0.9, 0.76, deep * 0.35),
        row(-c.x + 0.009, c.h - 0.004, 0.55, 0.0),
    ];
    curved_sheet(b, "shell", &rows, 0.008, colour);
    let z = s + 0.004;
    let (from, to) = (rear + c.rake * 0.3 + deep * 0.7 + 0.015, c.x - 0.05);
    b.top("seat", [f32::midpoint(from, to), 0.0, z], (((to - from) / 2.0).max(0.02), w * 0.33));
    let mid = f32::midpoint(rear, c.x);
    let half = (c.x - rear) / 2.0;
    let wooden = b.rng.chance(0.6);
    let (mat, r) = if wooden { (c.wood, c.post * 0.4) } else { (c.metal, 0.009) };
    b.at([mid, 0.0, 0.0], 0.0, |b| {
        let four = Four {
            feet: (half * 0.96, w),
            heads: (half * 0.55, w * 0.6),
            height: s - tall * 0.03,
            radii: (r * 0.65, r),
            cut: Cut::Round,
        };
        four.build(b, mat);
        for (p, q) in [(0, 2), (1, 3)] {
            four.rung(b, p, q, s * 0.72 + p as f32 * 0.006, 0.005, c.metal);
        }
        b.block(
            "mount",
            [-half * 0.5, -w * 0.5, s - tall * 0.03 - 0.016],
            [half * 0.5, w * 0.5, s - tall * 0.03 - 0.002],
            mat,
        );
    });
}

/// A padded seat and back on tapered legs.
fn padded(b: &mut Build<'_>, c: &Chair) {
    let (thick, r) = ((c.seat * 0.2).min(0.09), c.post * 0.55);
    let tilt = (c.rake / (c.h - c.seat)).arc_tangent();
    let lean = Lean { back: -c.x, z: (c.seat - thick * 0.3, c.h), thickness: (c.x * 0.3).min(0.06), tilt };
    let rear = lean.front(c.seat) - 0.02;
    lean.pad(b, "back", (-c.y * 0.97, c.y * 0.97), 0.022, c.cloth);
    b.rounded_block("seat", [rear - 0.03, -c.y, c.seat - thick], [c.x, c.y, c.seat], 0.025, c.cloth);
    let (from, to) = (lean.front(c.seat) + 0.012, c.x - 0.02);
    b.top("seat", [f32::midpoint(from, to), 0.0, c.seat], ((to - from) / 2.0, c.y - 0.025));
    let mid = f32::midpoint(-c.x, c.x);
    let inner = f32::midpoint(rear, c.x);
    let splay = b.rng.chance(0.6);
    let (cut, mat) = (b.choose(&[Cut::Square, Cut::Round]), b.choose(&[c.wood, c.wood, c.metal]));
    let under = c.seat - thick + 0.004;
    for (sx, sy) in [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)] {
        let head = [inner + sx * ((c.x - rear) / 2.0 - r - 0.015), sy * (c.y - r - 0.015), under];
        let reach = if splay { 0.04_f32.min(c.seat * 0.1) } else { 0.0 };
        let x = head[0] + sx * reach;
        let foot = [x.max(r + mid - c.x).min(c.x - r), (sy * (head[1].abs() + reach).min(c.y - r)), 0.0];
        leg(b, "leg", (foot, r * 0.55), (head, r), cut, mat);
    }
    if b.rng.chance(0.4) {
        // Seams divide the back into channels.
        lean.posed(b, |b, length, _| {
            for i in -1..=1 {
                let y = i as f32 * c.y * 0.48;
                b.block("seam", [-0.01, y - 0.003, length * 0.25], [0.0015, y + 0.003, length * 0.97], c.wood);
            }
        });
    }
}

/// A padded tub that wraps around the sitter.
fn bucket(b: &mut Build<'_>, c: &Chair) {
    let (s, tall, w) = (c.seat, c.h - c.seat, c.y);
    let t = (w * 0.14).min(0.035);
    let arm = s + tall * b.vary(0.3, 0.5);
    let rear = c.back(s) - c.post;
    let tilt = (c.rake / tall).arc_tangent();
    let lean = Lean { back: -c.x, z: (s - 0.05, c.h), thickness: t * 1.5, tilt };
    lean.pad(b, "back", (-w * 0.9, w * 0.9), t * 0.7, c.cloth);
    for side in [-1.0_f32, 1.0] {
        let y = side * (w - t);
        let line = [
            (c.x * 0.6, s - 0.05),
            (c.x * 0.55, arm),
            (lean.front(arm) - t, arm + tall * 0.15),
            (lean.front(s) - t, s - 0.05),
        ];
        b.prism("arm", Axis::Y, [0.0, y.min(y + side * t), 0.0], &line, t, c.cloth);
    }
    b.rounded_block("seat", [rear, 0.002 - w + t, s - 0.08_f32.min(s * 0.25)], [c.x, w - t - 0.002, s], 0.02, c.cloth);
    let (from, to) = (lean.front(s) + 0.012, c.x - 0.02);
    b.top("seat", [f32::midpoint(from, to), 0.0, s], ((to - from) / 2.0, w - t - 0.025));
    let mid = f32::midpoint(rear, c.x);
    let (half, r) = ((c.x - rear) / 2.0, c.post * 0.4);
    b.at([mid, 0.0, 0.0], 0.0, |b| {
        let four = Four {
            feet: (half, w),
            heads: (half * 0.75, w * 0.75),
            height: s - 0.07_f32.min(s * 0.2),
            radii: (r * 0.6, r),
            cut: Cut::Round,
        };
        let mat = b.choose(&[c.metal, c.wood]);
        four.build(b, mat);
    });
}

/// A seat and a back on a bent tube that has no rear legs.
fn cantilever(b: &mut Build<'_>, c: &Chair) {
    let r = (c.post * 0.35).min(0.0125);
    let steel = b.choose(&[CHROME, STEEL, BLACK_METAL]);
    let rear = c.back(c.seat) - c.post;
    for side in [-1.0, 1.0] {
        let y = side * (c.y - r);
        let z = c.seat - 0.03;
        let line = [
            [-c.x + r, y, r],
            [c.x - 0.03, y, r],
            [c.x - r - 0.004, y, 0.03],
            [c.x - r - 0.004, y, z - 0.02],
            [c.x - 0.03, y, z],
        ];
        b.pipe("tube", &line, r, steel);
        b.pipe("tube", &[[c.x - 0.03, y, z], [rear, y, z], [1.5 * r - c.x, y, c.h - 1.5 * r]], r, steel);
    }
    b.bar("tube", [-c.x + r, r - c.y, r], [-c.x + r, c.y - r, r], r, steel);
    let (t, w) = (0.03, c.y - 2.0 * r - 0.001);
    let pad = b.choose(&[c.cloth, BLACK_LEATHER, TAN_LEATHER, WICKER]);
    b.rounded_block("seat", [rear + 0.02, -w, c.seat - t], [c.x - 0.008, w, c.seat], 0.012, pad);
    let tilt = (c.rake / (c.h - c.seat)).arc_tangent();
    let low = c.seat + (c.h - c.seat) * 0.3;
    Lean { back: -c.x, z: (low, c.h - 0.01), thickness: t * 0.8, tilt }.pad(b, "back", (-w, w), 0.01, pad);
    let (from, to) = (rear + 0.06, c.x - 0.03);
    b.top("seat", [f32::midpoint(from, to), 0.0, c.seat], ((to - from) / 2.0, w - 0.015));
}

/// A bent plywood seat and back on a frame of tube, as in schools and canteens.
fn tubular(b: &mut Build<'_>, c: &Chair) {
    let (r, w) = ((c.post * 0.35).min(0.011), c.y);
    let rear = c.back(c.seat) - c.post;
    let steel = b.choose(&[CHROME, BLACK_METAL, GREY, c.metal]);
    let ply = b.choose(&[c.wood, BEECH, BIRCH, c.cloth]);
    let under = c.seat - 0.009;
    for side in [-1.0, 1.0] {
        let y = side * (w - r);
        let (front, z) = (c.x - 0.06_f32.min(c.x * 0.3), under - r);
        let mut tube = |name: &str, from: (f32, f32), to: (f32, f32)| {
            leg(b, name, ([from.0, y, from.1], r), ([to.0, y, to.1], r), Cut::Round, steel);
        };
        tube("leg", (c.x - r, 0.0), (front, z));
        tube("leg", (r - c.x * 0.98, 0.0), (rear + 0.03, z));
        tube("post", (rear + 0.02, z - r), (r - c.x, c.h - (c.h - c.seat) * 0.2));
        b.rod("rail", [front, y, z], [rear + 0.02, y, z], r, steel);
        // The back is screwed to the posts.
        let high = c.h - (c.h - c.seat) * 0.3;
        let share = (high - z + r) / (c.h - (c.h - c.seat) * 0.2 - z + r);
        let x = rear + 0.02 + (r - c.x - rear - 0.02) * share;
        b.rod("screw", [x, y, high], [c.back(high) - c.post * 0.6 + w * 0.1, y * 0.95, high], r * 0.6, steel);
    }
    let t = 0.011;
    let seat =
        [(c.x, c.seat - 0.022), (c.x - 0.02, c.seat - 0.006), (c.x - 0.05, c.seat), (rear + 0.03, c.seat - 0.002)];
    ribbon(b, "seat", &seat, t, (-w * 0.96, w * 0.96), ply);
    let tall = c.h - c.seat;
    let row = |x: f32, z: f32, half: f32| SheetRow { at: (x, z), half: half * w, rise: w * 0.12 };
    let at = |z: f32| (c.back(z) - c.post * 0.6).max(t + 0.001 - c.x);
    let (z0, z1) = (c.seat + tall * 0.5, c.h - 0.004 - w * 0.12 * (c.rake / tall));
    let rows =
        [row(at(z0), z0, 0.92), row(at(f32::midpoint(z0, z1)), f32::midpoint(z0, z1), 0.97), row(at(z1), z1, 0.9)];
    curved_sheet(b, "back", &rows, t, ply);
    let (from, to) = (rear + 0.045, c.x - 0.055);
    b.top("seat", [f32::midpoint(from, to), 0.0, c.seat], ((to - from) / 2.0, w * 0.9));
}
