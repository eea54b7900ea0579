//! Board games, boxed or as open boards.

use crate::material::*;
use crate::object::palette::CARDS;
use crate::solid::{self, Axis, Build, CORNERS, MeshBuilder, P, Proportional, SIDES, oval_outline};

/// A box with a lid and a printed picture.
pub(super) fn boxed(b: &mut Build<'_>) {
    let lid = match b.class {
        "monopoly" => b.choose(&[RED_CARD, WHITE_PAPER]),
        "scrabble" => b.choose(&[GREEN_CARD, RED_CARD, TEAL_CARD]),
        _ => b.one_of(CARDS),
    };
    let tray = b.choose(&[WHITE_PAPER, BLACK_CARD, CARDBOARD]);
    let seam = b.vary(0.1, 0.35);
    b.slab("tray", [-0.985, -0.985, 0.0], [0.985, 0.985, 0.6], tray);
    b.slab("lid", [-1.0, -1.0, seam], [1.0, 1.0, 0.965], lid);
    let print = loop_free(b, lid);
    match b.class {
        "ludo" => cross(b, print),
        "memory_game" => grid(b, 4),
        "jigsaw_puzzle" => landscape(b),
        "scrabble" => letters(b),
        _ => emblem(b, print),
    }
    b.slab("label", [0.99, -0.6, seam + 0.12], [1.0 + 0.001 / b.size.x, 0.6, 0.85], print);
    b.deck("lid", [0.0, 0.0, 1.0], (0.9, 0.9));
}

/// A colour that differs from the lid's.
fn loop_free(b: &mut Build<'_>, lid: MaterialId) -> MaterialId {
    let print = b.choose(&[YELLOW_CARD, WHITE_PAPER, ORANGE_CARD, BLUE_CARD]);
    if print == lid { BLACK_CARD } else { print }
}

/// A flat shape on the lid at layer `level` from 0 to 2.
fn flat(b: &mut Build<'_>, low: (f32, f32), high: (f32, f32), level: usize, mat: MaterialId) {
    b.slab("print", [low.0, low.1, 0.95], [high.0, high.1, 0.984 + 0.0155 * level as f32], mat);
}

/// A title band and shapes.
fn emblem(b: &mut Build<'_>, mat: MaterialId) {
    let title = b.vary(0.1, 0.4);
    flat(b, (title, -0.85), (title + 0.35, 0.85), 0, mat);
    flat(b, (title + 0.1, -0.7), (title + 0.25, 0.7), 1, BLACK_CARD);
    let count = b.rng.count(3, 6);
    for i in 0..count {
        let colour = b.one_of(CARDS);
        let (x, y) = (-0.45 + 0.2 * (i % 2) as f32, -0.7 + 1.4 * i as f32 / (count - 1) as f32);
        let size = b.vary(0.1, 0.13);
        b.plan_outline("print", (0.95, 0.992), &oval_outline((x, y), (size * 1.3, size), 10), colour);
    }
}

/// The cross of a ludo board.
fn cross(b: &mut Build<'_>, mat: MaterialId) {
    flat(b, (-0.9, -0.9), (0.9, 0.9), 0, if mat == WHITE_PAPER { CREAM_PAPER } else { WHITE_PAPER });
    for ((x, y), colour) in CORNERS.into_iter().zip([RED_CARD, BLUE_CARD, YELLOW_CARD, GREEN_CARD]) {
        flat(b, (0.58 * x - 0.26, 0.58 * y - 0.26), (0.58 * x + 0.26, 0.58 * y + 0.26), 1, colour);
    }
    b.plan_outline("print", (0.95, 0.9985), &oval_outline((0.0, 0.0), (0.2, 0.2), 4), BLACK_CARD);
}

/// Rows of picture cards.
fn grid(b: &mut Build<'_>, count: usize) {
    let step = 1.7 / count as f32;
    for (i, j) in (0..count).flat_map(|i| (0..count).map(move |j| (i, j))) {
        let (x, y) = (-0.85 + step * i as f32, -0.85 + step * j as f32);
        let colour = b.one_of(CARDS);
        flat(b, (x + step * 0.08, y + step * 0.08), (x + step * 0.92, y + step * 0.92), 0, WHITE_PAPER);
        flat(b, (x + step * 0.25, y + step * 0.25), (x + step * 0.75, y + step * 0.75), 1, colour);
    }
}

/// A picture of hills.
fn landscape(b: &mut Build<'_>) {
    let (sky, hill) =
        (b.choose(&[BLUE_CARD, TEAL_CARD, ORANGE_CARD]), b.choose(&[GREEN_CARD, PURPLE_CARD, YELLOW_CARD]));
    flat(b, (-0.85, -0.9), (0.85, 0.9), 0, sky);
    let (left, right) = (b.vary(0.0, 0.5), b.vary(-0.2, 0.3));
    b.plan_outline(
        "print",
        (0.95, 0.996),
        &[(0.84, -0.89), (left - 0.1, -0.89), (left, -0.2), (right, 0.4), (0.3, 0.89), (0.84, 0.89)],
        hill,
    );
    let y = b.vary(-0.5, 0.5);
    b.plan_outline("print", (0.95, 0.9995), &oval_outline((-0.55, y), (0.15, 0.13), 12), YELLOW_CARD);
}

/// A row of letter tiles.
fn letters(b: &mut Build<'_>) {
    let count = b.rng.count(6, 8);
    let step = 1.7 / count as f32;
    for i in 0..count {
        let y = -0.85 + step * i as f32;
        let x = b.vary(-0.03, 0.03);
        flat(b, (x - 0.15, y + step * 0.08), (x + 0.15, y + step * 0.92), 0, CREAM_PAPER);
        flat(b, (x - 0.07, y + step * 0.35), (x + 0.07, y + step * 0.65), 1, BLACK_CARD);
    }
}

/// A board of light and dark squares; a draughts board has its pieces on it.
pub(super) fn chequered(b: &mut Build<'_>) {
    let (light, dark) = b.choose(&[(MAPLE, WALNUT), (BIRCH, MAHOGANY), (CREAM, BLACK), (BEECH, WENGE)]);
    let draughts = b.class == "checkers";
    let (hx, hy, h) = solid::half_dims(b);
    let top = if draughts { (h * 0.6).min(h - 0.004).max(h * 0.5) } else { h };
    let edge = b.vary(0.07, 0.13);
    let frame = if b.rng.chance(0.5) { dark } else { light };
    b.rounded_block("board", [-hx, -hy, 0.0], [hx, hy, top - 0.0012], h * 0.1, frame);
    let (fx, fy) = (hx * (1.0 - edge), hy * (1.0 - edge));
    b.block("field", [-fx, -fy, top * 0.5], [fx, fy, top - 0.0006], if frame == light { dark } else { light });
    let mut squares = MeshBuilder::default();
    let cell = |i: usize, f: f32| f * (i as f32 / 4.0 - 1.0);
    for (i, j) in (0..8).flat_map(|i| (0..8).map(move |j| (i, j))).filter(|(i, j)| (i + j) % 2 == 0) {
        squares.block([cell(i, fx), cell(j, fy), top * 0.6], [cell(i + 1, fx), cell(j + 1, fy), top]);
    }
    squares.put(b, "square", if frame == light { light } else { frame });
    let rows = if draughts { 0.24 } else { 0.98 };
    if draughts {
        pieces(b, (fx, fy), (top, h));
    }
    b.top("field", [0.0, 0.0, top], (fx * rows, fy * 0.98));
}

/// Twelve pieces on each side.
fn pieces(b: &mut Build<'_>, (fx, fy): (f32, f32), (low, high): (f32, f32)) {
    let mut sides = [MeshBuilder::default(), MeshBuilder::default()];
    let r = fx.min(fy) / 8.0 * 0.8;
    for (i, j) in (0..8_usize).flat_map(|i| (0..8_usize).map(move |j| (i, j))).filter(|(i, j)| (i + j) % 2 == 0) {
        let side = match i {
            0..=2 => 0,
            5..=7 => 1,
            _ => continue,
        };
        let at = |z: f32| [fx * ((i as f32 + 0.5) / 4.0 - 1.0), fy * ((j as f32 + 0.5) / 4.0 - 1.0), z];
        let ring = |z: f32, r: f32| solid::oval(Axis::Z, at(z), (r, r), 0, 12);
        sides[side].loft(&[ring(low - 0.001, r), ring(high - (high - low) * 0.2, r), ring(high, r * 0.85)]);
    }
    let [white, black] = sides;
    white.put(b, "pieces", CREAM);
    black.put(b, "pieces", BLACK);
}

/// A board with nineteen lines in each direction, on feet if thick.
pub(super) fn go(b: &mut Build<'_>) {
    let wood = b.choose(&[BAMBOO, BEECH, OAK, PINE]);
    let (hx, hy, h) = solid::half_dims(b);
    let feet = if h > 0.07 { h * 0.35 } else { 0.0 };
    for (x, y) in CORNERS.into_iter().filter(|_| feet > 0.0) {
        let r = hx.min(hy) * 0.13;
        let at = [x * (hx - r * 1.3), y * (hy - r * 1.3), 0.0];
        b.lathe("foot", at, &[(r * 0.5, 0.0), (r, feet * 0.5), (r * 0.7, feet + 0.002)], wood);
    }
    b.rounded_block("board", [-hx, -hy, feet], [hx, hy, h - 0.0006], 0.003, wood);
    let (fx, fy) = (hx * 0.92, hy * 0.92);
    let mut lines = MeshBuilder::default();
    let thin = 0.0007;
    for i in 0..19 {
        let t = i as f32 / 9.0 - 1.0;
        lines.block([fx * t - thin, -fy, h - 0.003], [fx * t + thin, fy, h]);
        lines.block([-fx, fy * t - thin, h - 0.003], [fx, fy * t + thin, h - 0.0001]);
    }
    for (i, j) in [-1.0, 0.0, 1.0].into_iter().flat_map(|i| [-1.0, 0.0, 1.0].map(|j| (i, j))) {
        let (x, y, r) = (fx * i * 2.0 / 3.0, fy * j * 2.0 / 3.0, 0.003);
        lines.block([x - r, y - r, h - 0.003], [x + r, y + r, h - 0.00005]);
    }
    lines.put(b, "lines", BLACK_CARD);
    b.top("field", [0.0, 0.0, h], (fx, fy));
}

/// A folding case with long triangles inside.
pub(super) fn backgammon(b: &mut Build<'_>) {
    let case = b.choose(&[BROWN_LEATHER, BLACK_LEATHER, WALNUT, MAHOGANY, TAN_LEATHER]);
    let felt = b.choose(&[GREEN_FABRIC, BEIGE_FABRIC, NAVY_FABRIC]);
    let (hx, hy, h) = solid::half_dims(b);
    let (hx, t, mid) = (hx - 0.002, h * 0.12, h / 2.0);
    half(b, (hx, hy), (0.0, mid - 0.0005), t, case);
    b.block("felt", [-hx + t, -hy + t, t * 0.5], [hx - t, hy - t, t + 0.001], felt);
    let mut points = [MeshBuilder::default(), MeshBuilder::default()];
    let step = (hy - t) / 6.0;
    for i in 0..12_usize {
        let y = -hy + t + step * i as f32;
        for (k, side) in SIDES.into_iter().enumerate() {
            let ring = |z: f32| {
                vec![[side * (hx - t), y, z], [side * (hx - t), y + step, z], [side * hx * 0.12, y + step / 2.0, z]]
            };
            points[(i + k) % 2].loft(&[ring(t), ring(t + 0.002)]);
        }
    }
    let [white, red] = points;
    white.put(b, "points", CREAM_PAPER);
    red.put(b, "points", RED_CARD);
    b.inside("compartment_1", [0.0, 0.0, t + 0.002], (hx - t - 0.006, hy - t - 0.006), h - 2.0 * t - 0.004);
    b.hinge([-hx - 0.001, 0.0, mid], [0.0, -1.0, 0.0], 2.6, |b| {
        half(b, (hx, hy), (h, mid + 0.0005), -t, case);
        b.top("lid", [0.0, 0.0, h], (hx * 0.95, hy * 0.95));
        for side in SIDES {
            b.block(
                "latch",
                [hx - 0.001, hy * 0.6 * side - 0.012, mid + 0.001],
                [hx + 0.002, hy * 0.6 * side + 0.012, mid + h * 0.3],
                BRASS,
            );
        }
    });
}

/// A tray between its floor and its rim; the walls are as thick as the floor.
fn half(b: &mut Build<'_>, (hx, hy): (f32, f32), (floor, rim): (f32, f32), t: f32, mat: MaterialId) {
    let thick = t.abs();
    let inner = floor + t;
    let mut put = |name: &str, low: P, high: P| {
        let (z0, z1) = (low[2].min(high[2]), low[2].max(high[2]));
        b.block(name, [low[0], low[1], z0], [high[0], high[1], z1], mat);
    };
    put("floor", [-hx, -hy, floor], [hx, hy, inner]);
    for side in SIDES {
        let (x0, x1) = ((hx * side).min((hx - thick) * side), (hx * side).max((hx - thick) * side));
        put("wall", [x0, -hy, inner], [x1, hy, rim]);
        let (y0, y1) = ((hy * side).min((hy - thick) * side), (hy * side).max((hy - thick) * side));
        put("wall", [-hx + thick, y0, inner], [hx - thick, y1, rim]);
    }
}
