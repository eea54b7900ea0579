//! Shoes, in pairs, toes to the front.

use vc_graph::portable::Portable;

use crate::material::*;
use crate::solid::{Axis, Build, MeshBuilder, P, blocks, half_dims, loft, oval, spline};

/// One shoe: its centre across the pair, half length, half width and height.
#[derive(Clone, Copy)]
struct Last {
    at: f32,
    side: f32,
    x: f32,
    w: f32,
    h: f32,
}

impl Last {
    /// Half width of the sole at a position along its length (-1 heel, 1 toe).
    fn wide(&self, t: f32) -> f32 {
        let steps =
            [(-1.0, 0.45), (-0.9, 0.62), (-0.6, 0.7), (-0.2, 0.68), (0.3, 0.95), (0.6, 1.0), (0.85, 0.75), (1.0, 0.35)];
        let pair = steps.windows(2).find(|s| t <= s[1].0);
        self.w * pair.map_or(0.35, |s| s[0].1 + (s[1].1 - s[0].1) * ((t - s[0].0) / (s[1].0 - s[0].0)).max(0.0))
    }

    /// A ring of the upper between two heights, at a position along the shoe.
    fn ring(&self, t: f32, low: f32, high: f32, share: f32) -> Vec<P> {
        let at = [self.x * t, self.at, (low + high) / 2.0];
        oval(Axis::X, at, (self.wide(t) * share, (high - low) / 2.0), 1, 14)
    }

    /// The outline of the sole, enlarged by a fraction.
    fn sole(&self, grow: f32) -> Vec<(f32, f32)> {
        let steps = [-1.0, -0.9, -0.6, -0.2, 0.3, 0.6, 0.85, 1.0];
        let bend = |t: f32| self.side * self.w * 0.06 * (1.0 - t * t);
        let long = self.x * (0.7 + 0.3 * grow);
        let right = steps.iter().map(|&t| (long * t, self.at + bend(t) - self.wide(t) * grow));
        let left = steps.iter().rev().map(|&t| (long * t, self.at + bend(t) + self.wide(t) * grow));
        right.chain(left).collect()
    }
}

/// A pair of shoes of the object's class.
pub(super) fn pair(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let leather = match b.class {
        "sneakers" => b.choose(&[WHITE_LEATHER, RED_FABRIC, NAVY_FABRIC, BLACK_FABRIC, GREY_FABRIC, TEAL_FABRIC]),
        "slippers" => b.choose(&[GREY_FABRIC, ROSE_FABRIC, BROWN_FABRIC, NAVY_FABRIC, RED_FABRIC]),
        "high_heels" => b.choose(&[BLACK_LEATHER, RED_GLAZE, WHITE_LEATHER, NAVY, BLACK_GLAZE]),
        _ => b.choose(&[BLACK_LEATHER, BROWN_LEATHER, TAN_LEATHER, BROWN_LEATHER]),
    };
    let style = b.rng.below(3);
    let trim = match b.class {
        "shoes" => b.choose(&[BLACK_PLASTIC, BROWN_PLASTIC]),
        "boots" => b.choose(&[GREEN_PLASTIC, YELLOW_PLASTIC, NAVY]),
        _ => b.choose(&[WHITE_COTTON, BLACK_FABRIC, RED_FABRIC, MUSTARD_FABRIC]),
    };
    let gap = y * b.vary(0.02, 0.06);
    let w = (y - gap) / 2.0 / 1.06;
    let slip = x * b.vary(0.0, 0.06);
    for side in [-1.0_f32, 1.0] {
        let last = Last { at: side * (y - w * 1.06), side, x: x - slip, w, h };
        b.at([slip * side, 0.0, 0.0], 0.0, |b| match b.class {
            "sandals" => sandal(b, last, leather, style),
            "slippers" => slipper(b, last, (leather, trim)),
            "high_heels" => heel(b, last, leather),
            "boots" => boot(b, last, if style == 2 { trim } else { leather }, style),
            _ => shoe(b, last, (leather, trim), style),
        });
    }
}

/// A flat sole with a heel.
fn sole(b: &mut Build<'_>, last: Last, thick: f32, mat: MaterialId) {
    b.prism("sole", Axis::Z, [0.0; 3], &last.sole(1.0), thick, mat);
}

fn shoe(b: &mut Build<'_>, last: Last, (leather, trim): (MaterialId, MaterialId), style: usize) {
    let sporty = b.class == "sneakers";
    let thick = last.h * if sporty { 0.22 } else { 0.14 };
    let rubber = if sporty { WHITE_PLASTIC } else { trim };
    sole(b, last, thick, rubber);
    let (low, h) = (thick * 0.8, last.h);
    let collar = if sporty && style == 0 { 0.99 } else { 0.93 };
    let r = |t: f32, top: f32, share: f32| last.ring(t, low, h * top, share);
    let rings = [
        r(-0.97, 0.7, 0.75),
        r(-0.9, collar * 0.97, 0.9),
        r(-0.6, collar, 0.86),
        r(-0.25, collar * 0.96, 0.84),
        r(0.05, collar * 0.84, 0.86),
        r(0.4, 0.62, 0.93),
        r(0.7, 0.5, 0.94),
        r(0.9, 0.42, 0.88),
        r(0.985, 0.3, 0.7),
    ];
    loft(b, "upper", &rings, leather);
    let mut inside = MeshBuilder::default();
    inside.egg([-last.x * 0.55, last.at, h * collar * 0.955], [last.x * 0.33, last.w * 0.46, h * 0.043]);
    inside.put(b, "lining", if leather == BLACK_FABRIC { GREY_FABRIC } else { BLACK_FABRIC });
    if sporty || style > 0 {
        laces(b, last, collar, if sporty { WHITE_COTTON } else { BLACK_FABRIC });
    }
    if sporty {
        let marks: Vec<(P, P)> = [-0.15, 0.05, 0.22]
            .iter()
            .flat_map(|&t| {
                [-1.0_f32, 1.0].map(|s| {
                    let (a, c) = (last.at + s * last.wide(t) * 0.7, last.at + s * last.wide(t) * 0.93);
                    ([last.x * t, a.min(c), thick], [last.x * (t + 0.08), a.max(c), h * 0.52])
                })
            })
            .collect();
        blocks(b, "stripe", &marks, trim);
    } else if style == 0 {
        loft(b, "strap", &[r(0.02, 0.9, 0.92), r(0.22, 0.79, 0.94)], leather);
    }
}

/// Laces across the instep.
fn laces(b: &mut Build<'_>, last: Last, collar: f32, mat: MaterialId) {
    let mut shell = MeshBuilder::default();
    let r = last.w * 0.06;
    for i in 0..4 {
        let t = -0.12 + 0.13 * i as f32;
        let z = last.h * (collar * 0.9 - (collar * 0.9 - 0.66) * i as f32 / 3.0);
        let reach = last.w * 0.45;
        shell.tube(
            &[
                [last.x * t, last.at - reach, z - r],
                [last.x * (t + 0.04), last.at, z + r],
                [last.x * t, last.at + reach, z - r],
            ],
            r,
        );
    }
    for s in [-1.0, 1.0] {
        let top = [-last.x * 0.14, last.at, last.h * collar * 0.9];
        let bow = [
            top,
            [top[0], last.at + s * last.w * 0.5, top[2] + r],
            [top[0] + last.x * 0.12, last.at + s * last.w * 0.55, top[2] - last.h * 0.08],
            [top[0] + last.x * 0.06, last.at, top[2]],
        ];
        shell.tube(&spline(&bow, 3), r * 0.7);
    }
    shell.put(b, "lace", mat);
}

fn boot(b: &mut Build<'_>, last: Last, leather: MaterialId, style: usize) {
    let rubber = style == 2;
    let thick = (last.h * 0.1).min(0.03);
    sole(b, last, thick, if rubber { leather } else { BLACK_PLASTIC });
    let foot = (last.h * 0.5).min(last.x * 0.62);
    let r = |t: f32, top: f32, share: f32| last.ring(t, thick * 0.8, foot * top, share);
    loft(
        b,
        "foot",
        &[
            r(-0.97, 0.9, 0.7),
            r(-0.85, 1.0, 0.92),
            r(-0.3, 1.05, 0.9),
            r(0.1, 0.95, 0.88),
            r(0.45, 0.72, 0.93),
            r(0.8, 0.58, 0.92),
            r(0.985, 0.36, 0.7),
        ],
        leather,
    );
    let ring = |z: f32, s: f32, shift: f32| {
        oval(Axis::Z, [last.x * shift, last.at, z], (last.x * 0.42 * s, last.w * 0.72 * s), 0, 16)
    };
    let (top, wall) = (last.h, 0.88);
    let low = foot * 0.6;
    let shaft = [
        ring(low, 0.95, -0.45),
        ring(foot * 1.1, 0.95, -0.46),
        ring(top * 0.75, 1.08, -0.5),
        ring(top, 1.12, -0.5),
        ring(top, 1.12 * wall, -0.5),
        ring(top - last.h * 0.12, 1.08 * wall, -0.5),
    ];
    loft(b, "shaft", &shaft, leather);
    b.prism(
        "lining",
        Axis::Z,
        [0.0, 0.0, top - last.h * 0.13],
        &ring(0.0, 0.9, -0.5).iter().map(|p| (p[0], p[1])).collect::<Vec<_>>(),
        last.h * 0.02,
        BLACK_FABRIC,
    );
    if style == 0 {
        laces(b, Last { h: foot * 1.02, ..last }, 1.0, BLACK_FABRIC);
    }
    let band = |z: f32| oval(Axis::Z, [-last.x * 0.5, last.at, z], (last.x * 0.48, last.w * 0.82), 0, 16);
    if style == 1 {
        loft(b, "strap", &[band(top * 0.9), band(top * 0.95)], leather);
    }
}

fn sandal(b: &mut Build<'_>, last: Last, leather: MaterialId, style: usize) {
    let thick = last.h * 0.35;
    sole(b, last, thick * 0.6, BLACK_PLASTIC);
    b.prism("bed", Axis::Z, [0.0, 0.0, thick * 0.55], &last.sole(0.97), thick * 0.45, CORK);
    let mut straps = MeshBuilder::default();
    let bow = |t: f32, z: f32| {
        let (w, at) = (last.wide(t) * 0.9, last.x * t);
        [
            [at, last.at - w, thick * 0.8],
            [at, last.at - w * 0.7, z * 0.85],
            [at, last.at, z],
            [at, last.at + w * 0.7, z * 0.85],
            [at, last.at + w, thick * 0.8],
        ]
    };
    let band = last.x * 0.09;
    if style == 0 {
        let toe = [last.x * 0.62, last.at, thick];
        for s in [-1.0, 1.0] {
            let end = [-last.x * 0.05, last.at + s * last.wide(0.0) * 0.9, thick];
            straps.tube(
                &spline(&[toe, [last.x * 0.45, last.at + s * last.w * 0.25, last.h * 0.8], end], 4),
                last.w * 0.09,
            );
        }
    } else {
        for t in [0.5, 0.15] {
            straps.leaf(&spline(&bow(t, last.h * 0.93), 3), |_| band, 0.0);
        }
        if style == 2 {
            straps.leaf(&spline(&bow(-0.7, last.h * 0.93), 3), |_| band * 0.6, 0.0);
        }
    }
    straps.put(b, "strap", leather);
}

fn slipper(b: &mut Build<'_>, last: Last, (cloth, trim): (MaterialId, MaterialId)) {
    let thick = last.h * 0.22;
    sole(b, last, thick, BROWN_PLASTIC);
    b.prism("bed", Axis::Z, [0.0, 0.0, thick * 0.9], &last.sole(0.94), last.h * 0.1, WOOL);
    let r = |t: f32, top: f32, share: f32| last.ring(t, thick * 0.8, last.h * top, share);
    loft(
        b,
        "cap",
        &[
            r(-0.08, 0.96, 0.97),
            r(0.0, 1.0, 0.98),
            r(0.35, 0.88, 0.97),
            r(0.7, 0.68, 0.95),
            r(0.92, 0.5, 0.86),
            r(0.985, 0.36, 0.6),
        ],
        cloth,
    );
    let mut hole = MeshBuilder::default();
    hole.egg([-last.x * 0.09, last.at, last.h * 0.6], [last.x * 0.02, last.w * 0.5, last.h * 0.26]);
    hole.put(b, "lining", BLACK_FABRIC);
    let fluff = [
        [-last.x * 0.06, last.at - last.w * 0.62, last.h * 0.5],
        [-last.x * 0.03, last.at - last.w * 0.3, last.h * 0.86],
        [-last.x * 0.03, last.at + last.w * 0.3, last.h * 0.86],
        [-last.x * 0.06, last.at + last.w * 0.62, last.h * 0.5],
    ];
    let mut rim = MeshBuilder::default();
    rim.tube(&spline(&fluff, 4), last.h * 0.06);
    rim.put(b, "rim", trim);
}

fn heel(b: &mut Build<'_>, last: Last, leather: MaterialId) {
    let lift = last.h * 0.66;
    let z = |t: f32| {
        if t > 0.35 {
            0.0
        } else {
            lift * ((0.35 - t) / 1.2).min(1.0).raised(2) * (3.0 - 2.0 * ((0.35 - t) / 1.2).min(1.0))
        }
    };
    let thick = last.h * 0.05;
    let mut plate = MeshBuilder::default();
    let steps = [-0.97, -0.8, -0.5, -0.2, 0.1, 0.35, 0.6, 0.85, 0.99];
    let rings: Vec<Vec<P>> = steps.iter().map(|&t| last.ring(t, z(t), z(t) + thick, 0.9)).collect();
    plate.loft(&rings);
    plate.put(b, "sole", BEIGE_FABRIC);
    let mut upper = MeshBuilder::default();
    let toe: Vec<Vec<P>> = [(0.22, 0.38), (0.4, 0.36), (0.65, 0.3), (0.88, 0.22), (0.97, 0.12)]
        .iter()
        .map(|&(t, top)| last.ring(t, z(t) + thick * 0.3, z(t) + last.h * top, 0.96))
        .collect();
    upper.loft(&toe);
    let back: Vec<Vec<P>> = [(-0.99, 0.24), (-0.9, 0.34), (-0.6, 0.22)]
        .iter()
        .map(|&(t, top)| last.ring(t, z(t) + thick * 0.3, (z(t) + last.h * top).min(last.h), 1.0))
        .collect();
    upper.loft(&back);
    upper.tapered(
        &[[-last.x * 0.8, last.at, lift * 0.95], [-last.x * 0.86, last.at, lift * 0.4], [-last.x * 0.84, last.at, 0.0]],
        |t| last.w.min(last.x * 0.3) * (0.5 - 0.34 * t),
    );
    upper.put(b, "upper", leather);
}
