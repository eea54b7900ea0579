//! Shelving for kitchens, store rooms and garages.

use crate::material::*;
use crate::object::table::frame::Four;
use crate::object::table::trolley::castor;
use crate::solid::{Build, CORNERS, Cut, at_least};

/// The design of a rack's shelves.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Deck {
    /// A board.
    Board,
    /// Wires from side to side.
    Wire,
    /// A sheet with a folded rim.
    Sheet,
    /// Slats of wood.
    Slats,
}

/// Posts, with shelves between two heights.
struct Rack {
    x: f32,
    y: f32,
    /// The heights of the lowest and the uppermost shelf.
    z: (f32, f32),
    levels: usize,
    post: f32,
    deck: Deck,
    frame: MaterialId,
    board: MaterialId,
}

impl Rack {
    fn decks(&self, b: &mut Build<'_>) {
        let pitch = (self.z.1 - self.z.0) / (self.levels.max(2) - 1) as f32;
        for i in 0..self.levels {
            let z = self.z.0 + pitch * i as f32;
            self.deck(b, z);
            let free = (self.x - self.post * 2.0 - 0.006, self.y - self.post * 2.0 - 0.006);
            let name = format!("shelf_{}", i + 1);
            if i + 1 == self.levels {
                b.top(&name, [0.0, 0.0, z], free);
            } else {
                b.inside(&name, [0.0, 0.0, z], free, pitch - 0.06);
            }
        }
    }

    /// One shelf with its upper side at `z`.
    fn deck(&self, b: &mut Build<'_>, z: f32) {
        let (x, y, p) = (self.x - 0.001, self.y - 0.001, self.post * 2.0);
        let band = 0.035;
        match self.deck {
            Deck::Board => {
                b.block("shelf", [0.004 - x, 0.004 - y, z - 0.012], [x - 0.004, y - 0.004, z], self.board);
                for side in [-1.0_f32, 1.0] {
                    let (cx, cy) = (side * (x - 0.006), side * (y - 0.006));
                    b.block("beam", [cx - 0.005, p - y, z - 0.05], [cx + 0.005, y - p, z - 0.011], self.frame);
                    b.block("beam", [p - x, cy - 0.005, z - 0.05], [x - p, cy + 0.005, z - 0.011], self.frame);
                }
            }
            Deck::Sheet => {
                b.block("shelf", [0.002 - x, 0.002 - y, z - 0.004], [x - 0.002, y - 0.002, z], self.board);
                for side in [-1.0_f32, 1.0] {
                    let (cx, cy) = (side * (x - 0.0052), side * (y - 0.0052));
                    b.block("rim", [cx - 0.002, p - y, z - band], [cx + 0.002, y - p, z - 0.003], self.board);
                    b.block("rim", [p - x, cy - 0.002, z - band], [x - p, cy + 0.002, z - 0.003], self.board);
                }
            }
            Deck::Wire => {
                for side in [-1.0_f32, 1.0] {
                    let (cx, cy) = (side * (x - 0.006), side * (y - 0.006));
                    for low in [z - band, z - 0.009] {
                        b.block("wire", [cx - 0.003, p - y, low], [cx + 0.003, y - p, low + 0.006], self.frame);
                        b.block("wire", [p - x, cy - 0.003, low], [x - p, cy + 0.003, low + 0.006], self.frame);
                    }
                }
                // A mat on the wires, so that small objects can stand.
                let count = (y / 0.045).clamp(4.0, 10.0) as usize;
                for i in 0..count {
                    let cy = (y - p) * (2.0 * (i as f32 + 0.5) / count as f32 - 1.0);
                    let (low, high) = (z - 0.0065, z - 0.0025);
                    b.block("wire", [0.008 - x, cy - 0.002, low], [x - 0.008, cy + 0.002, high], self.frame);
                }
                b.block("mat", [0.012 - x, p - y, z - 0.003], [x - 0.012, y - p, z], CLEAR_PLASTIC);
            }
            Deck::Slats => {
                let count = (x / 0.04).clamp(2.0, 7.0) as usize;
                let pitch = 2.0 * (x - 0.004) / count as f32;
                for i in 0..count {
                    let x0 = 0.004 - x + pitch * i as f32;
                    b.block("slat", [x0, 0.004 - y, z - 0.016], [x0 + pitch - 0.003, y - 0.004, z], self.board);
                }
                for side in [-1.0_f32, 1.0] {
                    let cy = side * (y - p - 0.012);
                    b.block(
                        "batten",
                        [0.006 - x, cy - 0.012, z - 0.04],
                        [x - 0.006, cy + 0.012, z - 0.015],
                        self.board,
                    );
                }
            }
        }
    }

    fn posts(&self, b: &mut Build<'_>, from: f32, height: f32, cut: Cut) {
        b.at([0.0, 0.0, from], 0.0, |b| {
            Four::upright((self.x, self.y), height - from, (self.post, self.post), cut).build(b, self.frame);
        });
    }
}

/// Shelving of steel, wire, plastic or rough timber.
pub(super) fn storage_shelf(b: &mut Build<'_>) {
    at_least(b, [0.17, 0.4, 0.5]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let garage = b.class == "garage_shelf";
    let (deck, frame, board, post, cut) = match b.rng.below(4) {
        0 => (Deck::Wire, CHROME, CHROME, 0.012, Cut::Round),
        1 => (Deck::Slats, PINE, PINE, 0.02, Cut::Square),
        2 if !garage => (Deck::Sheet, GREY_PLASTIC, GREY_PLASTIC, 0.025, Cut::Round),
        _ => {
            let frame = b.choose(&[GALVANISED, BLUE_METAL, BLACK_METAL, GREY]);
            let (deck, board) = b.choose(&[(Deck::Board, PINE), (Deck::Sheet, GALVANISED), (Deck::Board, GREY_OAK)]);
            (deck, frame, board, 0.018, Cut::Square)
        }
    };
    let levels = ((h / b.vary(0.4, 0.5)).round() as usize).clamp(2, 6);
    let top = h - b.choose(&[0.004, 0.02]);
    let rack = Rack { x, y, z: (0.12, top), levels, post, deck, frame, board };
    rack.posts(b, 0.0, h, cut);
    rack.decks(b);
    if deck != Deck::Slats && b.rng.chance(0.6) {
        let (z, xb) = (0.2, post * 0.6 - x);
        b.rod("brace", [xb, post - y, z], [xb, y - post, h * 0.85], 0.003, frame);
        b.rod("brace", [xb + 0.007, y - post, z], [xb + 0.007, post - y, h * 0.85], 0.003, frame);
    }
}

/// A rack for a kitchen: shelves of wire, steel or wood, on castors, with hooks.
pub(super) fn kitchen_rack(b: &mut Build<'_>) {
    at_least(b, [0.15, 0.3, 0.35]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (deck, frame, board) = b.choose(&[
        (Deck::Wire, CHROME, CHROME),
        (Deck::Wire, BLACK_METAL, BLACK_METAL),
        (Deck::Sheet, STEEL, STEEL),
        (Deck::Sheet, STEEL, STEEL),
        (Deck::Board, BLACK_METAL, OAK),
        (Deck::Slats, BEECH, BEECH),
    ]);
    let wheels = deck != Deck::Slats && b.rng.chance(0.4);
    let lift = if wheels { 0.08 } else { 0.0 };
    let levels = ((h / b.vary(0.34, 0.48)).round() as usize).clamp(2, 5);
    let hang = h > 1.3 && b.rng.chance(0.6);
    let post = 0.014_f32.min(x * 0.1);
    let set = if hang { 0.03 } else { 0.0 };
    b.at([-set / 2.0, 0.0, 0.0], 0.0, |b| {
        let rack = Rack { x: x - set / 2.0, y, z: (lift + 0.1, h - 0.005), levels, post, deck, frame, board };
        rack.posts(b, lift, h, if deck == Deck::Slats { Cut::Square } else { Cut::Round });
        rack.decks(b);
        for (sx, sy) in CORNERS.into_iter().filter(|_| wheels) {
            castor(b, [sx * (rack.x - 0.032), sy * (y - 0.018), lift + 0.01], 0.03);
        }
    });
    if hang {
        // A rail in front of the uppermost shelf supports hooks.
        let (rx, z) = (x - 0.008, h - 0.05);
        b.rod("rail", [rx, post - y, z], [rx, y - post, z], 0.005, frame);
        for side in [-1.0, 1.0] {
            let cy = side * (y - post);
            b.rod("rail", [rx, cy, z], [x - set - post, cy, z], 0.005, frame);
        }
        let count = (y / 0.09).clamp(3.0, 8.0) as usize;
        for i in 0..count {
            let cy = (y - 0.05) * (2.0 * (i as f32 + 0.5) / count as f32 - 1.0);
            b.pipe("hook", &[[rx, cy, z], [rx, cy, z - 0.045], [rx + 0.004, cy, z - 0.05]], 0.003, frame);
            b.hook(&format!("hook_{}", i + 1), [rx, cy, z - 0.05], 0.3);
        }
    }
}

/// A cart of steel with runners for sheet pans.
pub(super) fn plate_rack_cart(b: &mut Build<'_>) {
    at_least(b, [0.28, 0.23, 0.6]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (post, lift) = (0.013, 0.13);
    b.at([0.0, 0.0, lift], 0.0, |b| {
        Four::upright((x, y), h - lift, (post, post), Cut::Square).build(b, ALUMINIUM);
    });
    for (sx, sy) in CORNERS {
        castor(b, [sx * (x - 0.05), sy * (y - 0.03), lift + 0.01], 0.05);
    }
    for z in [lift + 0.002, h - 0.026] {
        for side in [-1.0_f32, 1.0] {
            let (cx, cy) = (side * (x - post), side * (y - post));
            b.block("rail", [cx - 0.012, 2.0 * post - y, z], [cx + 0.012, y - 2.0 * post, z + 0.024], ALUMINIUM);
            b.block("rail", [2.0 * post - x, cy - 0.012, z], [x - 2.0 * post, cy + 0.012, z + 0.024], ALUMINIUM);
        }
    }
    let count = ((h - lift - 0.1) / b.vary(0.08, 0.13)).clamp(4.0, 20.0) as usize;
    let pitch = (h - lift - 0.08) / count as f32;
    let pans = b.rng.chance(0.5);
    for i in 0..count {
        let z = lift + 0.05 + pitch * i as f32;
        for side in [-1.0_f32, 1.0] {
            let (a, c) = (side * (y - 2.0 * post), side * (y - 2.0 * post - 0.035));
            b.block("runner", [0.01 - x, a.min(c), z], [x - 0.01, a.max(c), z + 0.002], ALUMINIUM);
        }
        // Some pans stay in the cart and serve as its shelves.
        if i % 4 == 0 || (pans && i % 2 == 0) {
            let (px, py) = (x - 0.02, y - 2.0 * post - 0.004);
            b.block("pan", [-px, -py, z + 0.003], [px, py, z + 0.008], STEEL);
            let next = if pans { 2 } else { 4 };
            let clear = (pitch * next as f32).min(h - 0.03 - z) - 0.03;
            let top = (px - 0.01, py - 0.04);
            b.inside(
                &format!("rack_{}", i + 1),
                [0.0, 0.0, z + 0.008],
                top,
                clear.min(pitch * next as f32 - 0.01).max(0.01),
            );
        }
    }
}
