//! Bound books, lying flat with the spine (-Y) at the reader's left.

use std::f32::consts::FRAC_PI_2;

use super::super::decor::picture::{Canvas, Inks, motif};
use super::title::entitle;
use crate::material::*;
use crate::solid::{Axis, Build, MeshBuilder, P, arc, blocks, half_dims, lying};

const COVERS: [MaterialId; 14] = [
    RED_CARD,
    BLUE_CARD,
    GREEN_CARD,
    YELLOW_CARD,
    ORANGE_CARD,
    PURPLE_CARD,
    BLACK_CARD,
    TEAL_CARD,
    PINK_CARD,
    CREAM_PAPER,
    WHITE_PAPER,
    NAVY_FABRIC,
    RED_FABRIC,
    BROWN_LEATHER,
];

/// A book: boards, block of pages, spine with bands and title, picture or title on the front cover.
pub(super) fn book(b: &mut Build<'_>) {
    entitle(b);
    let (x, y, h) = half_dims(b);
    let cover = match b.class {
        "diary" | "photo_album" => {
            b.choose(&[BROWN_LEATHER, BLACK_LEATHER, TAN_LEATHER, NAVY_FABRIC, RED_FABRIC, LINEN])
        }
        _ => b.choose(&COVERS),
    };
    let ink = contrast(b, cover);
    let hard = b.rng.chance(0.55) || matches!(b.class, "photo_album" | "picture_book");
    let board = if hard { (h * 0.14).min(0.003) } else { (h * 0.05).min(0.0006) };
    let shelf = if hard { (x * 0.03).min(0.003) } else { 0.0 };
    let relief = (h * 0.15).min(0.0008);
    let (low, high) = (relief, h - relief);
    let back = spine(b, board, (low, high), cover);
    let end = x - (x * 0.02).min(0.0003);
    b.block("cover", [-end, back, low], [end, y, low + board], cover);
    let paper = b.choose(&[WHITE_PAPER, CREAM_PAPER, CREAM_PAPER]);
    let inset = shelf.max((x * 0.03).min(0.0008));
    b.block("pages", [-x + inset, back - board * 0.5, low + board], [x - inset, y - inset, high - board], paper);
    bands(b, (low, high), ink);
    b.hinge([0.0, back, high], [1.0, 0.0, 0.0], 2.8, |b| {
        b.block("cover", [-end, back, high - board], [end, y, high], cover);
        front(b, high, back, ink);
    });
    blocks(b, "label", &[([x * 0.4, -y * 0.3, 0.0], [x * 0.7, y * 0.5, low + board * 0.5])], ink);
}

/// The back of the book, flat or round; returns where the boards begin.
fn spine(b: &mut Build<'_>, board: f32, (low, high): (f32, f32), cover: MaterialId) -> f32 {
    let (x, y, _) = half_dims(b);
    let relief = (y * 0.02).min(0.001);
    let middle = f32::midpoint(low, high);
    let tuck = ((high - low) * 0.12).min(0.0006);
    let half = (high - low) / 2.0 - tuck;
    if b.rng.chance(0.5) {
        let bulge = (half * 0.5).min(y * 0.15);
        let at = [-x, -y + relief + bulge, middle];
        let curve = arc(Axis::X, at, (bulge, half), (FRAC_PI_2, 3.0 * FRAC_PI_2), 8);
        let outer = curve.iter().map(|p| (p[1], p[2]));
        let outline: Vec<(f32, f32)> =
            outer.chain([(at[1] + board, middle - half), (at[1] + board, middle + half)]).collect();
        b.prism("spine", Axis::X, [-x, 0.0, 0.0], &outline, 2.0 * x, cover);
        at[1] + board * 0.5
    } else {
        let thick = board.max(0.0004);
        b.block("spine", [-x, -y + relief, low + tuck], [x, -y + relief + thick, high - tuck], cover);
        -y + relief + thick * 0.9
    }
}

/// Bands and a title on the spine.
fn bands(b: &mut Build<'_>, (low, high): (f32, f32), ink: MaterialId) {
    let (x, y, _) = half_dims(b);
    let deep = (y * 0.3).min(0.008);
    let (z0, z1) = (low + (high - low) * 0.28, high - (high - low) * 0.28);
    let mut list: Vec<(P, P)> = Vec::new();
    let mut band = |a: f32, c: f32, z0: f32, z1: f32| list.push(([a * x, -y, z0], [c * x, -y + deep, z1]));
    let count = b.rng.count(0, 3);
    for i in 0..count {
        let a = 0.62 + 0.1 * i as f32;
        band(a, a + 0.03, z0, z1);
        band(-a - 0.03, -a, z0, z1);
    }
    let title = b.vary(0.3, 0.5);
    band(-title, title, z0 + (z1 - z0) * 0.25, z1);
    blocks(b, "title", &list, ink);
}

/// The print on the front cover: a title and a picture, a frame or a label.
fn front(b: &mut Build<'_>, z: f32, back: f32, ink: MaterialId) {
    let (x, y, h) = half_dims(b);
    let middle = f32::midpoint(back, y);
    let wide = (y - back) / 2.0;
    let step = h - z;
    let bar = |a: f32, c: f32, w: f32| ([a * x, middle - w * wide, z - step], [c * x, middle + w * wide, h]);
    let pictured = match b.class {
        "picture_book" | "cookbook" => 1.0,
        "diary" => 0.0,
        _ => 0.45,
    };
    if b.rng.chance(pictured) {
        let at = [x * b.vary(-0.05, 0.25), middle, z];
        let canvas = Canvas { half: (wide * 0.8, x * 0.5), step: step / 3.0 };
        let inks = Inks::printed(b);
        lying(b, at, |b| motif(b, canvas, [0.0; 3], inks));
        blocks(b, "title", &[bar(-0.86, -0.72, 0.7)], ink);
        return;
    }
    match b.rng.below(3) {
        0 => blocks(b, "title", &[bar(-0.7, -0.58, 0.7), bar(-0.52, -0.44, 0.5), bar(0.7, 0.76, 0.4)], ink),
        1 => {
            let side = |w: f32| {
                let at = middle + w * wide;
                ([-0.84 * x, at - 0.02 * wide, z - step], [0.84 * x, at + 0.02 * wide, h])
            };
            let list = [bar(-0.88, -0.84, 0.84), bar(0.84, 0.88, 0.84), side(-0.8), side(0.8), bar(-0.4, -0.25, 0.5)];
            blocks(b, "title", &list, ink);
        }
        _ => blocks(b, "label", &[bar(-0.6, -0.1, 0.55)], ink),
    }
}

/// A colour that is visible on a cover.
fn contrast(b: &mut Build<'_>, cover: MaterialId) -> MaterialId {
    if [YELLOW_CARD, CREAM_PAPER, WHITE_PAPER, PINK_CARD, LINEN, ORANGE_CARD].contains(&cover) {
        b.choose(&[BLACK_CARD, RED_CARD, BLUE_CARD])
    } else {
        b.choose(&[GOLD, WHITE_PAPER, CREAM_PAPER, YELLOW_CARD])
    }
}

/// A notebook with a wire spiral or an elastic band.
pub(super) fn notebook(b: &mut Build<'_>) {
    entitle(b);
    let (x, y, h) = half_dims(b);
    let cover = b.choose(&[BLACK_CARD, RED_CARD, BLUE_CARD, TEAL_CARD, YELLOW_CARD, BROWN_LEATHER, CARDBOARD]);
    let spiral = b.rng.chance(0.5);
    let board = (h * 0.1).min(0.0015);
    let relief = (h * 0.1).min(0.001);
    let (back, low, high) = if spiral { (-y + h * 0.3, 0.0, h * 0.88) } else { (-y, 0.0, h - relief) };
    let end = x - (x * 0.02).min(0.0004);
    b.block("cover", [-end, back, low], [end, y, low + board], cover);
    b.block("pages", [-x * 0.98, back + 0.001, low + board], [x * 0.98, y * 0.98, high - board], WHITE_PAPER);
    if spiral {
        let r = (h / 2.0).min(y * 0.2);
        let mut wire = MeshBuilder::default();
        for i in 0..12 {
            let px = x * (-0.9 + 1.8 * i as f32 / 11.0);
            let ring = arc(Axis::X, [px, -y + r, h / 2.0], (r * 0.94, h * 0.43), (0.0, 5.76), 11);
            wire.hoop(&ring, r * 0.06);
        }
        wire.put(b, "spiral", STEEL);
    } else {
        b.block("spine", [-x, -y, low + board * 0.9], [x, -y + board, high - board * 0.9], cover);
    }
    let ink = contrast(b, cover);
    b.hinge([0.0, back, high], [1.0, 0.0, 0.0], 2.8, |b| {
        b.block("cover", [-end, back, high - board], [end, y, high], cover);
        b.block("label", [-x * 0.6, -y * 0.3, high - board * 0.5], [-x * 0.25, y * 0.5, (high + relief).min(h)], ink);
        if !spiral {
            b.block("elastic", [-x, y * 0.72, high - board], [x, y * 0.78, h], BLACK_FABRIC);
        }
    });
}

/// A passport with a crest on its cover.
pub(super) fn passport(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let cover = b.choose(&[RED_CARD, BLUE_CARD, GREEN_CARD, BLACK_CARD]);
    let relief = h * 0.12;
    let (leaf, top) = (h * 0.25, h - relief);
    let edge = y * 0.99;
    b.block("back", [-x, -edge, 0.0], [x, y, leaf], cover);
    b.block("pages", [-x * 0.98, -y * 0.99, leaf * 0.9], [x * 0.98, y * 0.97, top - leaf], WHITE_PAPER);
    b.block("spine", [-x * 0.99, -y, leaf * 0.5], [x * 0.99, -y * 0.98, top - leaf], cover);
    b.hinge([0.0, -edge, top], [1.0, 0.0, 0.0], 2.8, |b| {
        b.block("cover", [-x, -edge, top - leaf], [x, y, top], cover);
        b.cylinder("crest", [0.0, 0.0, top - leaf * 0.5], x * 0.3, relief + leaf * 0.5, GOLD);
        b.block("title", [-x * 0.75, -y * 0.5, top - leaf * 0.5], [-x * 0.62, y * 0.5, h], GOLD);
    });
}
