//! Folded or hanging kitchen textiles, and rolls and papers from the drawer.

use super::super::pack::label::panel;
use crate::material::*;
use crate::solid::{Axis, Build, arch, dims, loft_columns, planar_tube};

/// A folded cloth: layers joined in a fold at the front, with stripes on top.
pub(super) fn folded(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let apron = b.class == "apron";
    let cloth = match b.class {
        "table_cloth" | "table_runner" => b.choose(&[b.style.linen, WHITE_COTTON, LINEN, b.style.accent]),
        "apron" => b.choose(&[DENIM, BLACK_FABRIC, GREEN_FABRIC, LINEN, RED_FABRIC]),
        _ => b.choose(&[WHITE_COTTON, BLUE_FABRIC, LINEN, GREEN_FABRIC, b.style.towel]),
    };
    let stripe = b.choose(&[b.style.accent, RED_FABRIC, NAVY_FABRIC, GREEN_FABRIC]);
    let layers = ((z / 0.008).round() as usize).clamp(2, 4);
    let pitch = z * 0.96 / layers as f32;
    for i in 0..layers {
        let (low, high) = (pitch * i as f32, pitch * (i as f32 + 1.04));
        let back = -hx + x * 0.02 * ((i * 7) % 3) as f32;
        let side = hy - y * 0.015 * ((i * 5) % 3) as f32;
        b.rounded_block(
            "fold",
            [back, -side, low],
            [hx - x * 0.01 * (i % 2) as f32, side, high.min(z * 0.97)],
            pitch * 0.4,
            cloth,
        );
    }
    let top = z * 0.97;
    let stripes = if apron { 0 } else { b.rng.count(1, 3) };
    for i in 0..stripes {
        let at = hy * (0.85 - 0.18 * i as f32);
        b.block("stripe", [-hx * 0.9, at - hy * 0.05, top - pitch * 0.2], [hx * 0.93, at + hy * 0.05, z], stripe);
    }
    if apron {
        b.rounded_block(
            "pocket",
            [-hx * 0.5, -hy * 0.4, top - pitch * 0.2],
            [hx * 0.2, hy * 0.4, z],
            pitch * 0.1,
            stripe,
        );
    }
    if matches!(b.class, "table_cloth" | "table_runner") {
        b.top("top", [0.0, -hy * 0.2, z], (hx * 0.85, hy * 0.55));
    }
}

/// An upright mitt with a thumb, or two of them one behind the other.
pub(super) fn oven_mitts(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (cloth, cuff) = (
        b.choose(&[b.style.accent, RED_FABRIC, NAVY_FABRIC, GREY_FABRIC, b.style.towel]),
        b.choose(&[WHITE_COTTON, BLACK_FABRIC, LINEN]),
    );
    let hy = y / 2.0;
    let outline = [
        (-0.75, 0.0),
        (0.55, 0.0),
        (0.6, 0.35),
        (0.85, 0.45),
        (1.0, 0.58),
        (0.95, 0.68),
        (0.8, 0.7),
        (0.58, 0.6),
        (0.55, 0.78),
        (0.38, 0.93),
        (0.0, 0.99),
        (-0.4, 0.96),
        (-0.75, 0.82),
        (-0.95, 0.6),
        (-0.85, 0.3),
    ];
    let pair = x > 0.03;
    let (count, t) = if pair { (2, x * 0.49) } else { (1, x) };
    for i in 0..count {
        let flip = if i == 0 { 1.0 } else { -1.0 };
        let base = -x / 2.0 + (x - t) * i as f32;
        let ring = |at: f32, k: f32| {
            outline
                .iter()
                .map(|p| [base + at, flip * p.0 * hy * k, z * (0.5 + (p.1 * 0.93 - 0.5) * k + 0.02)])
                .collect::<Vec<_>>()
        };
        let rings = [ring(0.0, 0.9), ring(t * 0.25, 1.0), ring(t * 0.75, 1.0), ring(t, 0.9)];
        loft_columns(b, "mitt", &rings, cloth);
        b.block("cuff", [base + t * 0.02, -hy * 0.78, 0.0], [base + t * 0.98, hy * 0.78, z * 0.12], cuff);
        let w = (t * 0.12).min(z * 0.01);
        let loop_ = arch([base + t / 2.0, -flip * hy * 0.1, z * 0.93], [0.0, hy * 0.12, 0.0], [0.0, 0.0, z * 0.07 - w]);
        planar_tube(b, "loop", &loop_, w, [1.0, 0.0, 0.0], cuff);
    }
}

/// A stack of conical paper filters.
pub(super) fn coffee_filter(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let paper = b.choose(&[WHITE_PAPER, CREAM_PAPER, CARDBOARD]);
    let hy = y / 2.0;
    if x > 0.05 {
        b.rounded_block("box", [-x / 2.0, -hy, 0.0], [x / 2.0 - 0.002, hy, z * 0.7], 0.001, GREEN_CARD);
        panel(b, x / 2.0 - 0.002, (0.0, hy * 0.8), (z * 0.1, z * 0.6), (WHITE_PAPER, RED_CARD));
    }
    let outline = [
        (-hy * 0.35, 0.0),
        (hy * 0.35, 0.0),
        (hy * 0.98, z * 0.9),
        (hy * 0.6, z),
        (-hy * 0.6, z),
        (-hy * 0.98, z * 0.9),
    ];
    let (count, depth) = (3, if x > 0.05 { x * 0.5 } else { x });
    let t = depth / count as f32;
    for i in 0..count {
        b.prism(
            "filter",
            Axis::X,
            [-depth / 2.0 + depth * i as f32 / count as f32, 0.0, z * 0.012 * (1.0 + 0.3 * i as f32)],
            &outline.map(|p| (p.0, p.1 * (0.98 - 0.01 * i as f32))),
            t,
            paper,
        );
    }
}

/// A long box with a roll of foil, film or paper; its lid has a toothed edge.
pub(super) fn roll_box(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0 - 0.0015, y / 2.0);
    let (card, print, sheet) = match b.class {
        "aluminum_foil" => (b.choose(&[BLUE_CARD, RED_CARD, BLACK_CARD]), WHITE_PAPER, ALUMINIUM),
        "plastic_wrap" => (b.choose(&[GREEN_CARD, YELLOW_CARD, TEAL_CARD]), WHITE_PAPER, CLEAR_PLASTIC),
        _ => (b.choose(&[CARDBOARD, ORANGE_CARD, GREEN_CARD]), BLACK_CARD, CREAM_PAPER),
    };
    b.block("box", [-hx, -hy * 0.992, 0.0], [hx, hy * 0.992, z * 0.9], card);
    b.block("lid", [-hx - 0.0007, -hy * 0.999, z * 0.62], [hx * 0.9, hy * 0.999, z * 0.97], card);
    panel(b, hx, (0.0, hy * 0.85), (z * 0.08, z * 0.5), (print, card));
    let rolled = b.rng.chance(0.6);
    if rolled {
        b.block("sheet", [hx * 0.55, -hy * 0.9, z * 0.95], [hx + 0.0005, hy * 0.9, z], sheet);
        b.block("sheet", [hx + 0.0002, -hy * 0.88, z * 0.55], [hx + 0.0014, hy * 0.88, z * 0.97], sheet);
    } else {
        b.block("print", [-hx * 0.8, -hy * 0.8, z * 0.96], [hx * 0.6, hy * 0.8, z], print);
    }
}
