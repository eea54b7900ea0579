//! Unbound printed matter.

use std::f32::consts::TAU;

use vc_graph::portable::Portable;

use super::super::decor::picture::{Canvas, Inks, motif};
use super::title::entitle;
use crate::material::*;
use crate::solid::{Axis, Build, P, blocks, facing, half_dims, lying, sheet};

/// A magazine: glossy cover with picture, masthead and lines.
pub(super) fn magazine(b: &mut Build<'_>) {
    entitle(b);
    let (x, y, h) = half_dims(b);
    let relief = (h * 0.25).min(0.001);
    let body = h - relief;
    let curl = b.vary(0.0, 0.35);
    let cover =
        b.choose(&[RED_CARD, BLUE_CARD, TEAL_CARD, YELLOW_CARD, PINK_CARD, BLACK_CARD, ORANGE_CARD, GREEN_CARD]);
    b.block("pages", [-x * 0.995, -y * 0.995, 0.0], [x * 0.995, y * 0.99, body * 0.8], WHITE_PAPER);
    b.block("cover", [-x, -y, body * 0.75], [x, y - y * 0.02 * curl, body], cover);
    let inks = Inks::printed(b);
    let (px, half) = (x * b.vary(0.05, 0.2), (y * b.vary(0.6, 0.9), x * b.vary(0.55, 0.7)));
    lying(b, [px, 0.0, body], |b| motif(b, Canvas { half, step: relief / 3.0 }, [0.0; 3], inks));
    let ink = b.choose(&[WHITE_PAPER, YELLOW_CARD, BLACK_CARD]);
    let line = |a: f32, c: f32, y0: f32, y1: f32| ([a * x, y0 * y, body * 0.9], [c * x, y1 * y, h]);
    blocks(b, "masthead", &[line(-0.94, -0.76, -0.85, 0.6), line(-0.94, -0.9, 0.66, 0.9)], ink);
}

/// A newspaper: folded, with columns of print, a headline and a picture.
pub(super) fn newspaper(b: &mut Build<'_>) {
    entitle(b);
    let (x, y, h) = half_dims(b);
    let relief = (h * 0.2).min(0.001);
    let wave = b.vary(0.0, 6.0);
    let fold = h * 0.2;
    for i in 0..4 {
        let (z0, z1) = ((h - relief) * i as f32 / 4.0, (h - relief) * (i as f32 + 0.96) / 4.0);
        let inset = 0.006 * ((wave + 2.0 * i as f32).sine() + 1.0);
        b.rounded_block(
            "pages",
            [-x * (1.0 - inset), -y, z0],
            [x * (1.0 - inset), y * (1.0 - inset), z1],
            fold * 0.4,
            WHITE_PAPER,
        );
    }
    let top = h - relief;
    let line = |a: f32, c: f32, y0: f32, y1: f32| ([a * x, y0 * y, top - relief], [c * x, y1 * y, h]);
    let mut list = vec![line(-0.92, -0.78, -0.8, 0.8), line(-0.7, -0.64, -0.9, 0.3)];
    for (column, row) in (0..3).flat_map(|c| (0..11).map(move |r| (c, r))) {
        let (a, y0) = (-0.52 + 0.13 * row as f32, -0.92 + 0.64 * column as f32);
        if column < 2 || row > 6 {
            list.push(line(a, a + 0.05, y0, y0 + 0.52));
        }
    }
    blocks(b, "print", &list, GREY_PLASTIC);
    let inks = Inks::printed(b);
    let half = (y * 0.27, x * 0.38);
    lying(b, [-x * 0.14, y * 0.63, top], |b| motif(b, Canvas { half, step: relief / 3.0 }, [0.0; 3], inks));
}

/// A wall calendar: a picture above a grid of days, bound by a wire.
pub(super) fn calendar(b: &mut Build<'_>) {
    facing(b, |b, t, w, h| {
        let wire = (h * 0.02).min(t / 2.0);
        let (face, top) = (t * 0.15, h - wire);
        let sheet = if t > 0.003 { face } else { t * 0.4 };
        b.block("sheet", [-t / 2.0, -w / 2.0, 0.0], [sheet, w / 2.0, top], WHITE_PAPER);
        b.rod("wire", [0.0, -w * 0.45, top], [0.0, w * 0.45, top], wire * 0.9, BLACK_METAL);
        let step = (t / 2.0 - sheet) / 3.0;
        let inks = Inks::printed(b);
        motif(b, Canvas { half: (w * 0.47, h * 0.22), step }, [sheet, 0.0, h * 0.72], inks);
        let mut days: Vec<(P, P)> = vec![([0.0, -w * 0.3, h * 0.43], [sheet + step, w * 0.3, h * 0.465])];
        for (row, column) in (0..5).flat_map(|r| (0..7).map(move |c| (r, c))) {
            let (y0, z0) = (-w * 0.44 + w * 0.127 * column as f32, h * 0.05 + h * 0.072 * row as f32);
            days.push(([0.0, y0, z0], [sheet + step, y0 + w * 0.1, z0 + h * 0.05]));
        }
        let ink = b.choose(&[GREY_PLASTIC, BLUE_CARD, TEAL_CARD, RED_CARD]);
        blocks(b, "days", &days, ink);
    });
}

/// A folded map: pleats, green land and blue water on its front.
pub(super) fn map(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let relief = (h * 0.2).min(0.001);
    for i in 0..4 {
        let (z0, z1) = ((h - relief) * i as f32 / 4.0, (h - relief) * (i as f32 + 0.85) / 4.0);
        b.block("fold", [-x, -y, z0], [x, y, z1], if i == 3 { BLUE_CARD } else { WHITE_PAPER });
    }
    b.block("fold", [-x * 0.98, -y * 0.97, h * 0.05], [-x * 0.9, y * 0.97, h - relief * 3.0], WHITE_PAPER);
    let land: Vec<(f32, f32)> = (0..12)
        .map(|i| i as f32 / 12.0 * TAU)
        .map(|a| (a, b.vary(0.5, 0.9)))
        .map(|(a, r)| (x * r * a.cosine(), y * r * a.sine()))
        .collect();
    let base = h - relief * 2.0;
    b.prism("land", Axis::Z, [0.0, 0.0, base], &land, h - base, GREEN_CARD);
}

/// A bookmark with a ribbon.
pub(super) fn bookmark(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let card = b.choose(&[RED_CARD, BLUE_CARD, GREEN_CARD, TAN_LEATHER]);
    b.block("card", [-x, -y * 0.8, 0.0], [x, y, h * 0.7], card);
    b.block("stripe", [-x * 0.6, -y * 0.5, h * 0.3], [x * 0.6, y * 0.7, h], CREAM_PAPER);
    let wave = |u: f32, v: f32| {
        let (px, py) = (x * 0.15 * (2.0 * v - 1.0), -y + y * 0.25 * u);
        ([px, py, h * (0.6 + 0.3 * (u * 7.0).sine())], [px, py, h * 0.26])
    };
    sheet(b, "ribbon", (8, 1), wave, RED_FABRIC);
}
