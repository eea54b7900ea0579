//! Cabinets, sideboards and chests of drawers.

use super::case::{Cell, Column, Piece, Stand};
use crate::material::*;
use crate::object::joinery::{Front, Handle};
use crate::object::table::trolley::castor;
use crate::solid::{Build, CORNERS, at_least};

/// Gives a piece the home's style: body, fronts, handles, stand and top.
fn dressed(b: &mut Build<'_>, columns: Vec<Column>) -> Piece {
    let body = b.choose(&[b.style.wood, b.style.cabinet, b.style.cabinet]);
    let mut piece = Piece::new(columns, body);
    piece.front = b.choose(&[body, body, b.style.cabinet, b.style.wood]);
    piece.handle = Handle::any(b);
    piece.stand = b.choose(&[Stand::Plinth, Stand::Legs, Stand::Splayed, Stand::Tube]);
    piece.overhang = b.choose(&[0.0, 0.012, 0.018]);
    piece.lid = b.choose(&[body, body, b.style.wood, MARBLE]);
    piece
}

fn doors(look: Front, spaces: usize) -> Column {
    (1.0, vec![(1.0, Cell::Doors(look, spaces))])
}

fn drawers(count: usize) -> Column {
    (1.0, vec![(1.0, Cell::Drawers(count))])
}

/// The number of compartments of a usual height.
fn spaces(tall: f32) -> usize {
    (tall / 0.36).round().clamp(1.0, 7.0) as usize
}

/// A sideboard of doors, drawers and open spaces.
pub(super) fn sideboard(b: &mut Build<'_>) {
    at_least(b, [0.18, 0.5, 0.32]);
    let look = b.choose(&[Front::Flat, Front::Flat, Front::Framed, Front::Reeded, Front::Louvred, Front::Glass]);
    let count = (b.size.y / 0.5).round().clamp(2.0, 5.0) as usize;
    let mut columns: Vec<Column> = match b.rng.below(4) {
        0 => (0..count).map(|_| doors(look, 2)).collect(),
        1 => (0..count).map(|i| if i == count / 2 { drawers(3) } else { doors(look, 2) }).collect(),
        2 => (0..count).map(|_| (1.0, vec![(0.68, Cell::Doors(look, 1)), (0.32, Cell::Drawers(1))])).collect(),
        _ => (0..count).map(|i| if i == 0 { drawers(4) } else { doors(look, 2) }).collect(),
    };
    if b.rng.chance(0.25) {
        let at = b.rng.below(count);
        columns[at] = (0.8, vec![(1.0, Cell::Open(2))]);
    }
    dressed(b, columns).build(b);
}

/// A long low piece for a television: flaps, drawers and open compartments.
pub(super) fn tv_stand(b: &mut Build<'_>) {
    at_least(b, [0.16, 0.5, 0.18]);
    let look = Front::any(b);
    let flap: Column = (1.1, vec![(1.0, Cell::Flap(look))]);
    let open: Column = (1.0, vec![(1.0, Cell::Open(if b.size.z > 0.42 { 2 } else { 1 }))]);
    let columns: Vec<Column> = match b.rng.below(6) {
        0 => vec![flap.clone(), open, flap],
        1 => vec![drawers(2), open, drawers(2)],
        2 => vec![(1.0, vec![(0.5, Cell::Drawers(1)), (0.5, Cell::Open(1))]); 2],
        3 => vec![open.clone(), open],
        4 => vec![doors(look, 1), open.clone(), open, doors(look, 1)],
        _ => vec![(2.0, vec![(1.0, Cell::Open(1))]), drawers(2)],
    };
    let mut piece = dressed(b, columns);
    if b.rng.chance(0.3) {
        piece.lid = b.style.wood;
    }
    let lift = piece.stand.height(b).min(b.size.z * 0.25);
    piece.lifted(b, lift);
}

/// A cabinet or cupboard of middle height: doors, with drawers below or above.
pub(super) fn cabinet(b: &mut Build<'_>) {
    at_least(b, [0.16, 0.28, 0.36]);
    let tall = b.size.z;
    let look = b.choose(&[Front::Flat, Front::Framed, Front::Framed, Front::Reeded, Front::Louvred]);
    let columns: Vec<Column> = match b.rng.below(if tall > 1.3 { 5 } else { 3 }) {
        0 => vec![doors(look, spaces(tall))],
        1 => vec![(1.0, vec![(0.74, Cell::Doors(look, spaces(tall * 0.74))), (0.26, Cell::Drawers(1))])],
        2 => vec![doors(look, spaces(tall)), (0.9, vec![(0.5, Cell::Drawers(3)), (0.5, Cell::Open(1))])],
        3 => vec![(1.0, vec![(0.3, Cell::Drawers(2)), (0.7, Cell::Doors(Front::Glass, spaces(tall * 0.7)))])],
        _ => vec![(1.0, vec![(0.45, Cell::Doors(look, 2)), (0.2, Cell::Open(1)), (0.35, Cell::Doors(look, 1))])],
    };
    let mut piece = dressed(b, columns);
    if b.class == "laundry_cabinet" {
        (piece.body, piece.front, piece.stand) = (WHITE, b.choose(&[WHITE, b.style.front]), Stand::Plinth);
    }
    piece.build(b);
}

/// Glass doors above, solid doors or drawers below: for china or for books.
pub(super) fn display(b: &mut Build<'_>) {
    at_least(b, [0.15, 0.33, 0.5]);
    let tall = b.size.z;
    let look = Front::any(b);
    let lower = b.choose(&[Cell::Doors(look, 1), Cell::Drawers(2), Cell::Doors(look, 2), Cell::Doors(Front::Glass, 2)]);
    let share = b.vary(0.28, 0.42);
    let stack = vec![(share, lower), (1.0 - share, Cell::Doors(Front::Glass, spaces(tall * (1.0 - share))))];
    let columns = if b.size.y > 1.25 { 2 } else { 1 };
    let mut piece = dressed(b, vec![(1.0, stack); columns]);
    piece.front = piece.body;
    piece.overhang = b.choose(&[0.0, 0.02, 0.025]);
    piece.lid = piece.body;
    if piece.stand == Stand::Tube {
        piece.stand = Stand::Plinth;
    }
    if piece.handle == Handle::None {
        piece.handle = Handle::Knob;
    }
    piece.carries = b.class == "glass_door_bookcase";
    piece.build(b);
}

/// A chest of drawers in one to three columns.
pub(super) fn dresser(b: &mut Build<'_>) {
    at_least(b, [0.19, 0.3, 0.33]);
    let kids = b.class == "kids_dresser";
    let rows = (b.size.z / b.vary(0.2, 0.27)).round().clamp(2.0, 6.0) as usize;
    let wide = b.size.y;
    let columns: Vec<Column> = if wide > 1.25 && b.rng.chance(0.5) {
        vec![drawers(rows), drawers(rows.saturating_sub(1).max(2)), drawers(rows)]
    } else if wide > 0.95 {
        vec![drawers(rows), drawers(rows)]
    } else {
        vec![(1.0, vec![(rows as f32 - 0.5, Cell::Drawers(rows.saturating_sub(1).max(1))), (0.9, Cell::Drawers(1))])]
    };
    let mut piece = dressed(b, columns);
    if kids {
        piece.body = b.choose(&[WHITE, b.style.wood, CREAM]);
        piece.front = b.choose(&[WHITE, SKY, DUSTY_ROSE, SAGE, YELLOW, b.style.accent]);
        (piece.handle, piece.lid) = (Handle::Knob, piece.body);
    }
    piece.build(b);
}

/// A tall cabinet for linen, provisions or brooms.
pub(super) fn tall_cabinet(b: &mut Build<'_>) {
    at_least(b, [0.17, 0.2, 0.6]);
    let (tall, wide) = (b.size.z, b.size.y);
    let look = b.choose(&[Front::Flat, Front::Framed, Front::Framed, Front::Louvred]);
    let columns: Vec<Column> = match b.class {
        "utility_cabinet" if wide > 0.5 => {
            vec![(0.8, vec![(1.0, Cell::Hang(look))]), (1.0, vec![(1.0, Cell::Doors(look, spaces(tall)))])]
        }
        "utility_cabinet" => vec![(1.0, vec![(0.75, Cell::Hang(look)), (0.25, Cell::Doors(look, 1))])],
        "pantry_cabinet" => match b.rng.below(3) {
            0 => vec![(1.0, vec![(0.3, Cell::Drawers(3)), (0.7, Cell::Doors(look, spaces(tall * 0.7)))])],
            1 => vec![(1.0, vec![(0.55, Cell::Doors(look, 3)), (0.45, Cell::Doors(look, 2))])],
            _ => vec![doors(look, spaces(tall) + 1)],
        },
        _ => match b.rng.below(3) {
            0 => vec![doors(look, spaces(tall))],
            1 => vec![(1.0, vec![(0.25, Cell::Drawers(2)), (0.75, Cell::Doors(look, spaces(tall * 0.75)))])],
            _ => vec![(1.0, vec![(0.5, Cell::Doors(look, 3)), (0.5, Cell::Doors(look, 2))])],
        },
    };
    let mut piece = dressed(b, columns);
    piece.stand = b.choose(&[Stand::Plinth, Stand::Plinth, Stand::Legs]);
    piece.carries = false;
    (piece.overhang, piece.lid) = (b.choose(&[0.0, 0.015]), piece.body);
    if b.class == "pantry_cabinet" {
        (piece.body, piece.front, piece.lid) = (b.style.front, b.style.front, b.style.front);
    }
    piece.build(b);
}

/// A flat cabinet whose flaps tilt out, or a deeper one with doors.
pub(super) fn shoe_cabinet(b: &mut Build<'_>) {
    at_least(b, [0.085, 0.27, 0.4]);
    let look = Front::any(b);
    let rows = (b.size.z / 0.4).round().clamp(1.0, 4.0) as usize;
    let across = if b.size.y > 0.8 { 2 } else { 1 };
    let columns: Vec<Column> = if b.size.x > 0.3 && b.rng.chance(0.5) {
        vec![doors(look, spaces(b.size.z) + 1); across]
    } else {
        vec![(1.0, vec![(1.0, Cell::Flap(look)); rows]); across]
    };
    let mut piece = dressed(b, columns);
    piece.overhang = piece.overhang.min(b.size.x * 0.05);
    if b.size.x < 0.24 {
        piece.stand = b.choose(&[Stand::None, Stand::Plinth]);
    }
    piece.build(b);
}

/// Drawers of steel or board below or beside a desk.
pub(super) fn office_drawers(b: &mut Build<'_>) {
    at_least(b, [0.21, 0.17, 0.25]);
    let filing = b.class == "filing_cabinet";
    let rows = if filing { (b.size.z / 0.33).round().clamp(1.0, 5.0) as usize } else { 3 };
    let stack = match b.rng.below(3) {
        0 if !filing => vec![(0.5, Cell::Drawers(1)), (0.5, Cell::Drawers(2))],
        _ => vec![(1.0, Cell::Drawers(rows))],
    };
    let body = if filing {
        b.choose(&[LIGHT_GREY, GREY, WHITE, BLACK, BLUE, b.style.cabinet])
    } else {
        b.choose(&[WHITE, b.style.wood, LIGHT_GREY, b.style.cabinet])
    };
    let mut piece = Piece::new(vec![(1.0, stack)], body);
    piece.handle = b.choose(&[Handle::Bar, Handle::Bar, Handle::Knob]);
    piece.front = b.choose(&[body, body, WHITE]);
    let wheels = !filing && b.rng.chance(0.6);
    piece.stand = if wheels { Stand::None } else { Stand::Plinth };
    let (x, y) = (b.size.x / 2.0 - 0.06, b.size.y / 2.0 - 0.05);
    if !wheels {
        return piece.lifted(b, 0.05);
    }
    piece.lifted(b, 0.06);
    for (sx, sy) in CORNERS {
        castor(b, [sx * x, sy * y, 0.062], 0.025);
    }
}

/// A mechanic's tool chest of shallow drawers on castors, with a rim around its top.
pub(super) fn tool_cabinet(b: &mut Build<'_>) {
    at_least(b, [0.2, 0.3, 0.42]);
    let body = b.choose(&[RED_METAL, BLUE_METAL, BLACK_METAL, GREEN_METAL, YELLOW_METAL]);
    let rows = b.rng.count(4, 6);
    let columns: Vec<Column> = match b.rng.below(3) {
        0 => vec![drawers(rows)],
        1 => vec![drawers(rows), doors(Front::Flat, 2)],
        _ => vec![(1.0, vec![(0.35, Cell::Drawers(1)), (0.65, Cell::Drawers(rows))])],
    };
    let mut piece = Piece::new(columns, body);
    (piece.handle, piece.stand, piece.front) = (Handle::Bar, Stand::None, b.choose(&[body, body, GREY]));
    piece.carries = false;
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (rim, lift) = (0.03, 0.12);
    b.size.z = h - rim;
    piece.lifted(b, lift);
    b.size.z = h;
    for (sx, sy) in CORNERS {
        castor(b, [sx * (x - 0.08), sy * (y - 0.06), lift + 0.002], 0.05);
    }
    let front = x - Handle::Bar.depth();
    let z = h - rim;
    b.block("mat", [0.016 - x, 0.016 - y, z], [front - 0.016, y - 0.016, z + 0.004], RUBBER);
    for side in [-1.0_f32, 1.0] {
        let (a, c) = (side * y, side * (y - 0.014));
        b.block("rim", [-x, a.min(c), z], [front, a.max(c), h], BLACK_PLASTIC);
    }
    b.block("rim", [-x, 0.014 - y, z], [-x + 0.014, y - 0.014, h], BLACK_PLASTIC);
    b.block("rim", [front - 0.014, 0.014 - y, z], [front, y - 0.014, h], BLACK_PLASTIC);
    let half = ((front + x) / 2.0 - 0.02, y - 0.02);
    b.top("top", [f32::midpoint(-x, front), 0.0, z + 0.004], half);
}

/// A narrow locker of steel: vents in its doors, a shelf and a rod.
pub(super) fn locker(b: &mut Build<'_>) {
    at_least(b, [0.18, 0.15, 0.6]);
    let body = b.choose(&[LIGHT_GREY, BLUE, GREY, GREEN, RED, YELLOW]);
    let two = b.rng.chance(0.35);
    let cell = Cell::Hang(Front::Vented);
    let stack = if two { vec![(0.5, cell), (0.5, cell)] } else { vec![(1.0, cell)] };
    let mut piece = Piece::new(vec![(1.0, stack)], LIGHT_GREY);
    (piece.front, piece.handle, piece.carries) = (body, Handle::Knob, false);
    piece.lifted(b, 0.08);
}

/// A steel box with a thick door, a dial or keys, and a bar.
pub(super) fn safe(b: &mut Build<'_>) {
    at_least(b, [0.125, 0.15, 0.1]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let body = b.choose(&[GREY, BLACK, ANTHRACITE, FOREST]);
    let (t, thick, grip) = (0.02_f32.min(h * 0.1), 0.03, 0.04);
    let front = x - grip;
    let (low, high) = ([-x, -y, 0.0], [front, y, h]);
    let (z0, z1) = (t, h - t);
    b.block("bottom", low, [high[0], y, z0], body);
    b.block("top", [-x, -y, z1], high, body);
    b.block("side", [-x, -y, z0], [front, -y + t, z1], body);
    b.block("side", [-x, y - t, z0], [front, y, z1], body);
    b.block("back", [-x, t - y, z0], [-x + t, y - t, z1], body);
    let centre = [f32::midpoint(-x + t, front - thick), 0.0, z0];
    let half = ((front - thick + x - t) / 2.0 - 0.006, y - t - 0.006);
    let shelf = h > 0.35;
    let middle = h * 0.52;
    b.inside("shelf_1", centre, half, if shelf { middle - 0.008 - z0 } else { z1 - z0 - 0.006 });
    if shelf {
        b.block("shelf", [t - x, t - y, middle - 0.004], [centre[0] + half.0, y - t, middle], GREY);
        b.inside("shelf_2", [centre[0], 0.0, middle], half, z1 - middle - 0.006);
    }
    let g = 0.002;
    let wheel = b.rng.chance(0.5);
    b.hinge([front, y - t - g, 0.0], [0.0, 0.0, 1.0], 1.7, |b| {
        b.block("door_1", [front - thick, t + g - y, z0 + g], [front - 0.001, y - t - g, z1 - g], body);
        b.block("inlay", [front - 0.003, -y * 0.8, h * 0.14], [front + 0.001, y * 0.8, h * 0.86], GREY);
        let r = 0.03_f32.min(h * 0.16);
        if wheel {
            b.rod("dial", [front, y * 0.2, h * 0.6], [front + grip * 0.5, y * 0.2, h * 0.6], r, CHROME);
            b.rod("dial", [front + 0.01, y * 0.2, h * 0.6], [front + grip * 0.6, y * 0.2, h * 0.6], r * 0.5, BLACK);
        } else {
            b.block("keypad", [front, 0.0, h * 0.5], [front + 0.012, y * 0.45, h * 0.76], BLACK_PLASTIC);
            b.block("light", [front + 0.011, y * 0.05, h * 0.7], [front + 0.013, y * 0.1, h * 0.72], SIGNAL_RED);
        }
        b.rod("handle", [front, -y * 0.45, h * 0.5], [front + grip * 0.8, -y * 0.45, h * 0.5], 0.01, CHROME);
        b.rod(
            "handle",
            [front + grip - 0.009, -y * 0.45, h * 0.36],
            [front + grip - 0.009, -y * 0.45, h * 0.64],
            0.008,
            CHROME,
        );
    });
}
