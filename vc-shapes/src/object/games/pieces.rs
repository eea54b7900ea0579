//! Small pieces: tiles, blocks, cards, dice and chips.

use nalgebra::Vector3;
use vc_graph::Asset;
use vc_graph::asset::{Part, Shape};

use crate::material::*;
use crate::object::palette::TOY_WOODS;
use crate::solid::{self, Axis, Build, CORNERS, MeshBuilder, P, Proportional, SIDES};

/// Tiles in rows in a wooden tray: dominoes or mahjong tiles.
pub(super) fn tiles(b: &mut Build<'_>) {
    let (hx, hy, h) = solid::half_dims(b);
    let mahjong = b.class == "mahjong";
    let wood = b.choose(&[WALNUT, BEECH, MAHOGANY, OAK, BLACK_LEATHER]);
    let (body, mark) = if mahjong {
        (WHITE_PLASTIC, b.choose(&[GREEN_PLASTIC, BLUE_PLASTIC, BAMBOO]))
    } else {
        b.choose(&[(WHITE_PLASTIC, BLACK_PLASTIC), (BLACK_PLASTIC, WHITE_PLASTIC), (BIRCH, BLACK_PLASTIC)])
    };
    let t = (hx.min(hy) * 0.08).min(h * 0.2);
    let rim = h * 0.8;
    b.block("floor", [-hx, -hy, 0.0], [hx, hy, t], wood);
    for side in SIDES {
        let (x0, x1) = ((hx * side).min((hx - t) * side), (hx * side).max((hx - t) * side));
        b.block("wall", [x0, -hy, t], [x1, hy, rim], wood);
        let (y0, y1) = ((hy * side).min((hy - t) * side), (hy * side).max((hy - t) * side));
        b.block("wall", [-hx + t, y0, t], [hx - t, y1, rim], wood);
    }
    let (rows, columns) = if mahjong { (b.rng.count(6, 8), b.rng.count(10, 13)) } else { (2, b.rng.count(6, 9)) };
    let (fx, fy) = ((hx - t) * 0.98, (hy - t) * 0.98);
    let (mut bodies, mut faces) = (MeshBuilder::default(), MeshBuilder::default());
    for (i, j) in (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j))) {
        let (dx, dy) = (2.0 * fx / rows as f32, 2.0 * fy / columns as f32);
        let (x, y) = (-fx + dx * (i as f32 + 0.5), -fy + dy * (j as f32 + 0.5));
        let top = h - 0.001 - h * 0.08 * ((i * 5 + j * 3) % 4) as f32 / 4.0;
        bodies.block([x - dx * 0.46, y - dy * 0.46, t * 0.7], [x + dx * 0.46, y + dy * 0.46, top]);
        let mut pip = |a: f32, c: f32, u: f32, v: f32| {
            faces.block(
                [x + dx * (a - u), y + dy * (c - v), top - 0.001],
                [x + dx * (a + u), y + dy * (c + v), top + 0.0008],
            );
        };
        if mahjong {
            pip(0.0, 0.0, 0.2, 0.07 + 0.04 * ((i + j) % 3) as f32);
        } else {
            pip(0.0, 0.0, 0.02, 0.38);
            for k in 0..(i + 2 * j) % 4 + 1 {
                let side = SIDES[k % 2];
                pip(0.24 * side, if k < 2 { -0.2 } else { 0.2 }, 0.05, 0.1);
            }
        }
    }
    bodies.put(b, "tiles", body);
    faces.put(b, "marks", mark);
}

/// Eighteen layers of three blocks, some pulled out.
pub(super) fn tower(b: &mut Build<'_>) {
    let (hx, hy, h) = solid::half_dims(b);
    let woods = [b.one_of(TOY_WOODS), b.choose(&[BEECH, OAK]), b.choose(&[PINE, ASH])];
    let mut shells = [MeshBuilder::default(), MeshBuilder::default(), MeshBuilder::default()];
    let layers = 18;
    let tall = h / layers as f32;
    for i in 0..layers {
        let gone = if i > 2 && i < layers - 1 && b.rng.chance(0.25) { b.rng.below(3) } else { 3 };
        for k in (0..3).filter(|k| *k != gone) {
            let shift = b.vary(-0.03, 0.03);
            let low = (k as f32 - 1.5) * 0.64 + 0.02;
            let (z0, z1) = (tall * i as f32, tall * (i + 1) as f32 - 0.0002);
            let (across, along) = ((low, low + 0.6), (-0.96 + shift, 0.96 + shift));
            let (x, y) = if i % 2 == 0 { (across, along) } else { (along, across) };
            // All blocks of the lowest and of the highest layers have the layer's own wood.
            let wood = if (3..layers - 3).contains(&i) { i + k * 2 } else { i };
            shells[wood % 3].block([x.0 * hx, y.0 * hy, z0], [x.1 * hx, y.1 * hy, z1]);
        }
    }
    for (shell, wood) in shells.into_iter().zip(woods) {
        shell.put(b, "blocks", wood);
    }
}

/// A cube with coloured stickers, scrambled to a varying degree.
pub(super) fn cube(b: &mut Build<'_>) {
    let s = b.size.min() / 2.0;
    let colours = [WHITE_PLASTIC, YELLOW_PLASTIC, RED_PLASTIC, ORANGE_PLASTIC, BLUE_PLASTIC, GREEN_PLASTIC];
    let core = b.choose(&[BLACK_PLASTIC, BLACK_PLASTIC, GREY_PLASTIC]);
    let mixed = b.vary(0.0, 1.0);
    let skin = s * 0.985;
    b.rounded_block("core", [-skin, -skin, s - skin], [skin, skin, s + skin], s * 0.04, core);
    let mut shells: [MeshBuilder; 6] = std::array::from_fn(|_| MeshBuilder::default());
    let third = s * 0.655;
    for face in 0..6_usize {
        let (axis, side) = (face / 2, SIDES[face % 2]);
        for (i, j) in [-1.0, 0.0, 1.0].into_iter().flat_map(|i| [-1.0, 0.0, 1.0].map(|j| (i, j))) {
            let colour = if b.rng.chance(mixed) { b.rng.below(6) } else { face };
            let (out, inner) = (side * s, side * skin * 0.97);
            let half = s * 0.28;
            let mut corners = [[0.0_f32; 3]; 2];
            for (corner, sign) in corners.iter_mut().zip(SIDES) {
                corner[axis] = if sign < 0.0 { out.min(inner) } else { out.max(inner) };
                corner[(axis + 1) % 3] = third * i + half * sign;
                corner[(axis + 2) % 3] = third * j + half * sign;
            }
            let lift = |p: P| [p[0], p[1], p[2] + s];
            shells[colour].block(lift(corners[0]), lift(corners[1]));
        }
    }
    for (shell, mat) in shells.into_iter().zip(colours) {
        shell.put(b, "stickers", mat);
    }
}

/// A pack of cards in its box.
pub(super) fn deck(b: &mut Build<'_>) {
    let mat = b.choose(&[RED_CARD, BLUE_CARD, BLACK_CARD, GREEN_CARD]);
    let print = b.choose(&[WHITE_PAPER, YELLOW_CARD, CREAM_PAPER]);
    let step = (0.0008 / b.size.x).min(0.06) * 2.0;
    b.slab("box", [-0.94, -1.0, 0.0], [1.0 - 2.0 * step, 1.0, 0.985], mat);
    let high = b.vary(0.72, 0.8);
    b.slab("flap", [0.8, -0.9, high], [1.0 - step, 0.9, 0.98], mat);
    b.slab("seal", [0.8, -0.25, high - 0.06], [1.0, 0.25, high + 0.04], WHITE_PAPER);
    b.slab("seam", [-0.9, -0.97, 0.93], [0.9, 0.97, 1.0], print);
    let r = b.vary(0.3, 0.45);
    for side in SIDES {
        let x = (0.93 * side, 0.985 * side);
        let shape = [(0.0, 0.36 - r / 2.0), (r, 0.36), (0.0, 0.36 + r / 2.0), (-r, 0.36)];
        b.front_outline("print", (x.0.min(x.1), x.0.max(x.1)), &shape, print);
    }
}

/// Cards in a spread, face up.
pub(super) fn cards(b: &mut Build<'_>) {
    let (hx, hy, h) = solid::half_dims(b);
    let count = b.rng.count(4, 7);
    let suits = [RED_CARD, BLACK_CARD];
    let first = b.rng.below(2);
    let wide = (hx * 1.3).min(2.0 * hy * 0.8);
    // The upper cards must not extend far beyond the first.
    let hy = hy.min(wide * 0.9);
    let thick = h / (count as f32 + 0.6);
    let (mut faces, mut pips) = (MeshBuilder::default(), [MeshBuilder::default(), MeshBuilder::default()]);
    for i in 0..count {
        let t = i as f32 / (count - 1) as f32;
        let y = -hy + (2.0 * hy - wide) * t;
        let slip = hx * b.vary(0.0, 0.06);
        let (z0, z1) = (thick * i as f32, thick * (i as f32 + 0.93));
        let (x0, x1) = (-hx + slip, hx - hx * 0.06 + slip);
        faces.block([x0, y, (z0 - thick * 0.5).max(0.0)], [x1, y + wide, z1]);
        let mut pip = |x: f32, at: f32, size: f32| {
            let at = y + wide * at;
            pips[(i + first) % 2]
                .block([x - size, at - size, z1 - thick * 0.3], [x + size, at + size, z1 + thick * 0.4]);
        };
        let strip = ((2.0 * hy - wide) / (count - 1) as f32 / wide).min(0.2);
        pip(x0 + wide * 0.12, strip * 0.5, wide * strip * 0.3);
        if i + 1 == count {
            let (mid, half) = ((x0 + x1) / 2.0, (x1 - x0) / 2.0);
            CORNERS.into_iter().for_each(|(a, c)| pip(mid + a * half * 0.5, 0.5 + 0.2 * c, wide * 0.08));
        }
    }
    faces.put(b, "card", WHITE_PAPER);
    for (shell, mat) in pips.into_iter().zip(suits) {
        shell.put(b, "pip", mat);
    }
}

/// Adds to the last part a collision cube with half side `half` around its centre.
fn solid_cube(asset: &mut Asset, half: f32) {
    if let Some(part) = asset.parts.last() {
        let cube = Part { shape: Shape::Box { half: Vector3::repeat(half) }, ..part.clone() };
        asset.collision.push(cube);
    }
}

/// One die, or two side by side.
pub(super) fn dice(b: &mut Build<'_>) {
    let (hx, hy, h) = solid::half_dims(b);
    let (body, mark) = b.choose(&[
        (WHITE_PLASTIC, BLACK_PLASTIC),
        (RED_PLASTIC, WHITE_PLASTIC),
        (BLACK_PLASTIC, WHITE_PLASTIC),
        (BLUE_PLASTIC, WHITE_PLASTIC),
    ]);
    let s = hx.min(h / 2.0).min(hy);
    let (s, count) = if hy > 1.9 * s { (s.min(hy / 2.02), 2) } else { (s, 1) };
    let round = s * b.vary(0.12, 0.3);
    let mut pips = MeshBuilder::default();
    for apart in SIDES.iter().take(count) {
        let y = if count == 2 { (hy - s) * apart } else { 0.0 };
        let c = s * 0.93;
        b.rounded_block("die", [-c, y - c, s - c], [c, y + c, s + c], round, body);
        // The collision shape rests on a face, not on the paint of the pips.
        solid_cube(b.asset(), s);
        let turn = b.rng.below(3);
        for face in 0..6_usize {
            let (axis, side) = ((face / 2 + turn) % 3, SIDES[face % 2]);
            for &(u, v) in spots([1, 6, 2, 5, 3, 4][face]) {
                let mut centre = [0.0, y, s];
                let (a, d) = ((axis + 1) % 3, (axis + 2) % 3);
                centre[a] += u * s * 0.5;
                centre[d] += v * s * 0.5;
                let (mut low, mut high) = (centre, centre);
                for k in [a, d] {
                    low[k] -= s * 0.13;
                    high[k] += s * 0.13;
                }
                let (near, far) = (centre[axis] + side * s * 0.9, centre[axis] + side * s);
                (low[axis], high[axis]) = (near.min(far), near.max(far));
                pips.block(low, high);
            }
        }
    }
    pips.put(b, "pips", mark);
    if count == 2 {
        let gap = [[0.0, -hy + s, s * 0.03], [0.0, hy - s, s * 0.03]];
        b.rod("felt", gap[0], gap[1], s * 0.03, body);
    }
}

/// The positions of the pips of a number.
fn spots(number: usize) -> &'static [(f32, f32)] {
    const SPOTS: [(f32, f32); 6] = [(-1.0, -1.0), (1.0, 1.0), (-1.0, 1.0), (1.0, -1.0), (-1.0, 0.0), (1.0, 0.0)];
    const ODD: [(f32, f32); 5] = [(0.0, 0.0), (-1.0, -1.0), (1.0, 1.0), (-1.0, 1.0), (1.0, -1.0)];
    if number % 2 == 1 { &ODD[..number.min(5)] } else { &SPOTS[..number.min(6)] }
}

/// Chips lying in the rows of a case.
pub(super) fn chips(b: &mut Build<'_>) {
    let case = b.choose(&[SILVER_METAL, BLACK_LEATHER, WALNUT, BLACK_PLASTIC]);
    let (hx, hy, h) = solid::half_dims(b);
    let rows = b.rng.count(4, 6);
    let r = ((hx * 0.94) / rows as f32).min(h * 0.48);
    b.rounded_block("case", [-hx, -hy, 0.0], [hx, hy, h - r], h * 0.06, case);
    b.block("tray", [-hx * 0.96, -hy * 0.96, h * 0.1], [hx * 0.96, hy * 0.96, h - r * 0.9], BLACK_FABRIC);
    let colours = [RED_PLASTIC, BLUE_PLASTIC, GREEN_PLASTIC, BLACK_PLASTIC, WHITE_PLASTIC, PURPLE_PLASTIC];
    let segments = b.rng.count(4, 6);
    let mut shells: [MeshBuilder; 6] = std::array::from_fn(|_| MeshBuilder::default());
    for row in 0..rows {
        let x = -hx * 0.94 + (hx * 0.94 * 2.0) * (row as f32 + 0.5) / rows as f32;
        for k in 0..segments {
            let at = |t: f32| [x, hy * 0.9 * (2.0 * t / segments as f32 - 1.0), h - r];
            let ring = |t: f32| solid::oval(Axis::Y, at(t), (r * 0.97, r * 0.98), 0, 14);
            shells[(row + k / 2) % 6].loft(&[ring(k as f32 + 0.02), ring(k as f32 + 0.97)]);
        }
    }
    for (shell, mat) in shells.into_iter().zip(colours) {
        shell.put(b, "chips", mat);
    }
    let grip = b.vary(0.25, 0.4);
    b.pole("handle", [0.985, -grip, 0.3], [0.985, grip, 0.3], 0.006, STEEL);
}
