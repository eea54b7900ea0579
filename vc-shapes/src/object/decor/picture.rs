//! Pictures on screens, canvases, covers and cards, built from flat panels in layers.

use crate::material::*;
use crate::solid::{Axis, Build, P, ngon};

/// Half the width and height of a picture, and the distance between its layers.
#[derive(Debug, Clone, Copy)]
pub(in crate::object) struct Canvas {
    pub(in crate::object) half: (f32, f32),
    pub(in crate::object) step: f32,
}

/// The colours of a picture.
#[derive(Debug, Clone, Copy)]
pub(in crate::object) struct Inks {
    /// Background, land, accent, and dark parts.
    sky: MaterialId,
    land: MaterialId,
    sun: MaterialId,
    dark: MaterialId,
    /// The colours of faces, one of which is drawn, and of every second flower.
    faces: [MaterialId; 3],
    flower: MaterialId,
}

/// The colours of faces and flowers in pictures that are not on screens.
const FACES: [MaterialId; 3] = [SKIN, BROWN_SKIN, EGGSHELL];
const FLOWER: MaterialId = PETAL_PINK;

impl Inks {
    /// A picture on a screen, visible while the screen is on. All of it is dark when the screen is
    /// off.
    pub(in crate::object) fn screen() -> Self {
        let (sky, land, sun, dark) = (PICTURE_SKY, PICTURE_LAND, PICTURE_SUN, PICTURE_DARK);
        Self { sky, land, sun, dark, faces: [sun; 3], flower: sun }
    }

    /// Oil on canvas.
    pub(in crate::object) fn painted(b: &mut Build<'_>) -> Self {
        Self {
            sky: b.choose(&[SKY, CREAM, DUSTY_ROSE, MUSTARD, LIGHT_GREY, WALL_OCHRE, WHITE]),
            land: b.choose(&[SAGE, FOREST, GREEN, TERRACOTTA, NAVY, BLUE]),
            sun: b.choose(&[YELLOW, ORANGE, RED, WHITE, MUSTARD]),
            dark: b.choose(&[NAVY, BLACK, ANTHRACITE, FOREST, TERRACOTTA]),
            faces: FACES,
            flower: FLOWER,
        }
    }

    /// Ink on paper.
    pub(in crate::object) fn printed(b: &mut Build<'_>) -> Self {
        Self {
            sky: b.choose(&[WHITE_PAPER, CREAM_PAPER, PINK_CARD, YELLOW_CARD, SKY]),
            land: b.choose(&[GREEN_CARD, BLUE_CARD, TEAL_CARD, ORANGE_CARD]),
            sun: b.choose(&[YELLOW_CARD, ORANGE_CARD, RED_CARD, WHITE_PAPER]),
            dark: b.choose(&[BLACK_CARD, PURPLE_CARD, BLUE_CARD, RED_CARD]),
            faces: FACES,
            flower: FLOWER,
        }
    }

    /// A photograph.
    pub(in crate::object) fn photo() -> Self {
        Self { sky: WALL_BLUE, land: SAGE, sun: SKIN, dark: CHARCOAL_FABRIC, faces: FACES, flower: FLOWER }
    }
}

/// A picture under construction: points are in -1..1 of its half width and height.
struct Brush<'a, 'b> {
    b: &'a mut Build<'b>,
    canvas: Canvas,
    at: P,
}

impl Brush<'_, '_> {
    fn fill(&mut self, layer: usize, outline: &[(f32, f32)], mat: MaterialId) {
        let shrink = 1.0 - 0.006 * layer as f32;
        let (w, h) = (self.canvas.half.0 * shrink, self.canvas.half.1 * shrink);
        let outline: Vec<(f32, f32)> =
            outline.iter().map(|&(u, v)| (u.clamp(-1.0, 1.0) * w, v.clamp(-1.0, 1.0) * h)).collect();
        let step = self.canvas.step;
        let base = [self.at[0] + step * (layer as f32 - 0.3), self.at[1], self.at[2]];
        self.b.prism("picture", Axis::X, base, &outline, step * 1.3, mat);
    }

    fn bar(&mut self, layer: usize, (u0, u1): (f32, f32), (v0, v1): (f32, f32), mat: MaterialId) {
        self.fill(layer, &[(u0, v0), (u1, v0), (u1, v1), (u0, v1)], mat);
    }

    /// A disc; its radius is relative to the shorter half side.
    fn disc(&mut self, layer: usize, (u, v): (f32, f32), radius: f32, mat: MaterialId) {
        let (w, h) = self.canvas.half;
        let r = radius * w.min(h);
        let points: Vec<(f32, f32)> = ngon((r / w, r / h), 16).into_iter().map(|(a, c)| (u + a, v + c)).collect();
        self.fill(layer, &points, mat);
    }

    /// A ridge from side to side, filled down to the lower edge.
    fn ridge(&mut self, layer: usize, (low, high): (f32, f32), peaks: usize, mat: MaterialId) {
        let mut outline = vec![(1.0, -1.0), (-1.0, -1.0)];
        for i in 0..=peaks * 2 {
            let u = -1.0 + i as f32 / peaks as f32;
            let (a, c) = if i % 2 == 0 { (low, f32::midpoint(low, high)) } else { (f32::midpoint(low, high), high) };
            outline.push((u, self.b.vary(a, c)));
        }
        self.fill(layer, &outline, mat);
    }
}

/// Paints a picture facing +X, centred at a point of the plane behind it. It protrudes by at most
/// three steps.
pub(in crate::object) fn motif(b: &mut Build<'_>, canvas: Canvas, at: P, inks: Inks) {
    let kind = b.rng.below(8);
    let mut brush = Brush { b, canvas, at };
    brush.bar(0, (-1.0, 1.0), (-1.0, 1.0), inks.sky);
    match kind {
        0 | 1 => landscape(&mut brush, inks),
        2 => sea(&mut brush, inks),
        3 => fields(&mut brush, inks),
        4 => portrait(&mut brush, inks),
        5 => flowers(&mut brush, inks),
        6 => city(&mut brush, inks),
        _ => shapes(&mut brush, inks),
    }
}

fn landscape(p: &mut Brush<'_, '_>, inks: Inks) {
    let sun = (p.b.vary(-0.6, 0.6), p.b.vary(0.35, 0.6));
    p.disc(1, sun, 0.22, inks.sun);
    let (far, near) = (p.b.vary(-0.2, 0.25), p.b.vary(-0.7, -0.35));
    let peaks = p.b.rng.count(2, 4);
    p.ridge(1, (far - 0.35, far), peaks, inks.dark);
    p.ridge(2, (near - 0.2, near), 2, inks.land);
}

fn sea(p: &mut Brush<'_, '_>, inks: Inks) {
    let (line, u) = (p.b.vary(-0.35, 0.0), p.b.vary(-0.4, 0.4));
    p.disc(1, (-u, line + 0.55), 0.18, inks.sun);
    p.bar(1, (-1.0, 1.0), (-1.0, line), inks.dark);
    p.fill(
        2,
        &[(u - 0.25, line - 0.05), (u - 0.15, line - 0.2), (u + 0.2, line - 0.2), (u + 0.28, line - 0.05)],
        inks.land,
    );
    p.fill(2, &[(u, line), (u + 0.22, line), (u, line + 0.55)], inks.sun);
    p.bar(2, (-0.9, -0.4), (-0.75, -0.7), inks.sky);
    p.bar(2, (0.2, 0.8), (-0.88, -0.83), inks.sky);
}

fn fields(p: &mut Brush<'_, '_>, inks: Inks) {
    let (a, c) = (p.b.vary(-0.3, 0.3), p.b.vary(-0.3, 0.3));
    p.bar(1, (-0.85, a), (c, 0.85), inks.land);
    p.bar(1, (a + 0.08, 0.85), (c - 0.3, 0.85), inks.dark);
    p.bar(1, (-0.85, a - 0.1), (-0.85, c - 0.1), inks.sun);
    p.disc(2, (a, c - 0.1), 0.3, inks.sky);
}

fn portrait(p: &mut Brush<'_, '_>, inks: Inks) {
    let skin = p.b.choose(&inks.faces);
    p.fill(1, &[(-0.75, -1.0), (0.75, -1.0), (0.6, -0.5), (0.25, -0.3), (-0.25, -0.3), (-0.6, -0.5)], inks.land);
    p.disc(1, (0.0, 0.22), 0.46, inks.dark);
    p.disc(2, (0.0, 0.12), 0.38, skin);
}

fn flowers(p: &mut Brush<'_, '_>, inks: Inks) {
    p.bar(1, (-1.0, 1.0), (-1.0, -0.6), inks.land);
    p.fill(2, &[(-0.25, -0.85), (0.25, -0.85), (0.35, -0.3), (0.18, -0.1), (-0.18, -0.1), (-0.35, -0.3)], inks.dark);
    for (i, u) in [-0.55, -0.2, 0.2, 0.55].into_iter().enumerate() {
        let v = p.b.vary(0.15, 0.65);
        p.fill(1, &[(u * 0.2 - 0.02, -0.15), (u * 0.2 + 0.02, -0.15), (u + 0.02, v), (u - 0.02, v)], inks.land);
        p.disc(2, (u, v), 0.17, if i % 2 == 0 { inks.sun } else { inks.flower });
    }
}

fn city(p: &mut Brush<'_, '_>, inks: Inks) {
    p.disc(1, (0.5, 0.6), 0.2, inks.sun);
    let count = p.b.rng.count(4, 7);
    let pitch = 2.0 / count as f32;
    for i in 0..count {
        let (u, v) = (-1.0 + pitch * i as f32, p.b.vary(-0.4, 0.3));
        p.bar(1, (u, u + pitch), (-1.0, v), inks.dark);
        p.bar(2, (u + pitch * 0.3, u + pitch * 0.7), (v - 0.3, v - 0.12), inks.sun);
    }
    p.bar(2, (-1.0, 1.0), (-1.0, -0.8), inks.land);
}

fn shapes(p: &mut Brush<'_, '_>, inks: Inks) {
    let (u, v) = (p.b.vary(-0.4, 0.4), p.b.vary(-0.4, 0.4));
    p.disc(1, (u, v), 0.55, inks.land);
    p.fill(2, &[(-0.8, -0.8), (u, -0.8), (-0.8, v)], inks.dark);
    p.disc(2, (0.6, 0.6), 0.2, inks.sun);
    p.bar(2, (0.2, 0.85), (-0.6, -0.5), inks.sun);
}
