//! Sheets, pads, envelopes, cards and money.

use super::super::decor::picture::{Canvas, Inks, motif};
use crate::material::*;
use crate::solid::{Axis, Build, MeshBuilder, P, blocks, half_dims, lying};

/// A few slightly misaligned sheets of paper, printed or written.
pub(super) fn sheets(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let paper = match b.class {
        "banknote" => b.choose(&[GREEN_CARD, TEAL_CARD, ORANGE_CARD, PINK_CARD]),
        "notes" => b.choose(&[WHITE_PAPER, YELLOW_CARD, CREAM_PAPER]),
        "check" => CREAM_PAPER,
        _ => WHITE_PAPER,
    };
    let ink = (h * 0.25).min(0.0006);
    let single = matches!(b.class, "banknote" | "check" | "form") || h < 0.001;
    let count = if single { 1 } else { b.rng.count(2, 4) };
    let body = h - ink;
    for i in 0..count {
        let (sx, sy) = if single { (0.0, 0.0) } else { (b.vary(-0.03, 0.03) * x, b.vary(-0.04, 0.04) * y) };
        let (z0, z1) = (body * i as f32 / count as f32, body * (i as f32 + 0.98) / count as f32);
        let (dx, dy) = (x - sx.abs(), y - sy.abs());
        b.block("sheet", [sx - dx, sy - dy, z0], [sx + dx, sy + dy, z1], paper);
    }
    let line = |a: f32, c: f32, y0: f32, y1: f32| ([a * x, y0 * y, body * 0.7], [c * x, y1 * y, h]);
    let mut list: Vec<(P, P)> = Vec::new();
    match b.class {
        "banknote" => {
            list.extend([line(-0.85, -0.5, -0.9, -0.5), line(0.5, 0.85, 0.5, 0.9), line(-0.6, 0.6, -0.2, 0.4)])
        }
        "check" => list.extend([line(-0.5, -0.4, -0.9, 0.3), line(0.0, 0.06, -0.9, 0.5), line(-0.1, 0.2, 0.6, 0.9)]),
        "form" => {
            for i in 0..7 {
                let a = -0.6 + 0.2 * i as f32;
                list.extend([line(a, a + 0.1, -0.85, -0.3), line(a + 0.09, a + 0.1, -0.25, 0.85)]);
            }
        }
        _ => {
            let lines = b.rng.count(6, 16);
            list.push(line(-0.9, -0.84, -0.8, -0.2));
            for i in 0..lines {
                let a = -0.72 + 1.5 * i as f32 / lines as f32;
                let end = b.vary(0.3, 0.85);
                list.push(line(a, a + 0.4 / lines as f32, -0.82, end));
            }
        }
    }
    let mark = if b.class == "homework" { BLUE_CARD } else { b.choose(&[BLACK_CARD, GREY_PLASTIC]) };
    blocks(b, "print", &list, mark);
}

/// A pad of paper glued at its head, or a block of sticky notes.
pub(super) fn pad(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let sticky = b.class == "sticky_notes";
    let inks = [YELLOW_CARD, PINK_CARD, ORANGE_CARD, GREEN_CARD];
    let paper = if sticky { b.choose(&inks) } else { b.choose(&[WHITE_PAPER, YELLOW_CARD, CREAM_PAPER]) };
    let relief = (h * 0.1).min(0.001);
    let body = h - relief;
    let back = x - (x * 0.02).min(0.0005);
    b.block("back", [-back, -y * 0.99, 0.0], [x, y * 0.99, body * 0.15], if sticky { paper } else { CARDBOARD });
    b.block("pages", [-back, -y * 0.98, body * 0.15], [x * 0.99, y * 0.98, body], paper);
    if sticky {
        let tone = b.choose(&[BLUE_CARD, BLACK_CARD]);
        let line = |a: f32, w: f32| ([a * x, -0.7 * y, body * 0.9], [(a + 0.08) * x, w * y, h]);
        blocks(b, "print", &[line(-0.4, 0.5), line(-0.1, 0.7), line(0.2, 0.1)], tone);
    } else {
        let head = b.choose(&[RED_CARD, BLUE_CARD, BLACK_CARD]);
        b.block("head", [-x, -y, body * 0.1], [-x * 0.88, y, h], head);
        let rules: Vec<(P, P)> = (0..9)
            .map(|i| -0.75 + 0.18 * i as f32)
            .map(|a| ([a * x, -0.9 * y, body * 0.9], [(a + 0.02) * x, 0.9 * y, body + relief * 0.5]))
            .collect();
        blocks(b, "rule", &rules, SKY);
    }
}

/// Envelopes with address, stamp and flap; a stack of them if high.
pub(super) fn envelope(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let count = if h > 0.006 { b.rng.count(2, 3) } else { 1 };
    let relief = (h * 0.2).min(0.0008);
    let body = h - relief;
    for i in 0..count {
        let paper = b.choose(&[WHITE_PAPER, CREAM_PAPER, CARDBOARD, WHITE_PAPER]);
        let inset = if i == 0 { 0.0 } else { b.vary(0.03, 0.15) };
        let (z0, z1) = (body * i as f32 / count as f32, body * (i as f32 + 0.97) / count as f32);
        b.block(
            "envelope",
            [-x * (1.0 - inset), -y * (1.0 - inset), z0],
            [x * (1.0 - inset), y * (1.0 - inset), z1],
            paper,
        );
    }
    let line = |a: f32, c: f32, y0: f32, y1: f32| ([a * x, y0 * y, body * 0.9], [c * x, y1 * y, h]);
    let stamp = b.choose(&[RED_CARD, BLUE_CARD, GREEN_CARD]);
    if b.rng.chance(0.35) {
        let flap = [(-x * 0.84, -y * 0.84), (-x * 0.84, y * 0.84), (x * 0.1, y * 0.08), (x * 0.1, -y * 0.08)];
        b.prism("flap", Axis::Z, [0.0, 0.0, body * 0.9], &flap, h - body * 0.9, CREAM_PAPER);
        return;
    }
    blocks(
        b,
        "address",
        &[line(0.1, 0.16, -0.2, 0.5), line(0.28, 0.34, -0.2, 0.6), line(0.46, 0.52, -0.2, 0.3)],
        BLACK_CARD,
    );
    blocks(b, "stamp", &[line(-0.82, -0.45, 0.6, 0.82)], stamp);
}

/// A card: a greeting card with a picture, a stamp with perforations, or a credit card.
pub(super) fn card(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let relief = h * 0.66;
    let body = h - relief;
    match b.class {
        "credit_card" => {
            let colour = b.choose(&[BLUE_PLASTIC, BLACK_PLASTIC, RED_PLASTIC, GREY_PLASTIC]);
            b.rounded_block("card", [-x, -y, 0.0], [x, y, body], h, colour);
            b.block("chip", [-x * 0.25, -y * 0.7, body * 0.7], [x * 0.2, -y * 0.45, h], GOLD);
            b.block("number", [x * 0.35, -y * 0.7, body * 0.7], [x * 0.5, y * 0.7, h], SILVER_METAL);
        }
        class => {
            let stamp = class == "stamp";
            if stamp {
                let teeth: Vec<(P, P)> = (0..7)
                    .flat_map(|i| {
                        let t = -0.9 + 0.3 * i as f32;
                        let tooth = |a: f32, c: f32| {
                            (
                                [a * x - x * 0.07, c * y - y * 0.07, 0.0],
                                [a * x + x * 0.07, c * y + y * 0.07, body * 0.3],
                            )
                        };
                        [tooth(t * 0.98, 0.93), tooth(t * 0.98, -0.93), tooth(0.93, t * 0.98), tooth(-0.93, t * 0.98)]
                    })
                    .collect();
                blocks(b, "teeth", &teeth, WHITE_PAPER);
            }
            let edge = if stamp { 0.92 } else { 1.0 };
            let paper = if stamp { WHITE_PAPER } else { b.choose(&[WHITE_PAPER, CREAM_PAPER, PINK_CARD]) };
            b.block("card", [-x * edge, -y * edge, 0.0], [x * edge, y * edge, body], paper);
            let inks = Inks::printed(b);
            let canvas = Canvas { half: (y * 0.78, x * 0.78), step: relief / 3.0 };
            lying(b, [0.0, 0.0, body], |b| motif(b, canvas, [0.0; 3], inks));
        }
    }
}

/// A coin with a raised rim.
pub(super) fn coin(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let metal = b.choose(&[GOLD, COPPER, SILVER_METAL, BRASS]);
    let r = x.min(y);
    let rim = [(r, 0.0), (r, h), (r * 0.88, h), (r * 0.86, h * 0.85), (0.0, h * 0.85)];
    b.lathe("coin", [0.0; 3], &rim, metal);
    let mut head = MeshBuilder::default();
    head.egg([0.0, 0.0, h * 0.82], [r * 0.4, r * 0.3, h * 0.17]);
    head.put(b, "relief", metal);
}
