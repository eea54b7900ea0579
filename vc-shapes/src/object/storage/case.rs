//! Case furniture: a box of boards divided into columns, each a stack of open compartments, doors
//! and drawers.

use std::f32::consts::FRAC_PI_2;

use crate::material::MaterialId;
use crate::object::joinery::{BOARD, Front, GAP, Handle, Swing, drawer, front_panel, gapped, handle, leaf};
use crate::object::table::frame::Four;
use crate::solid::{Build, Cut, P};

/// The kind of a compartment.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::object) enum Cell {
    /// Open in front, with this many spaces above each other.
    Open(usize),
    /// Behind doors, with this many spaces.
    Doors(Front, usize),
    /// This many drawers above each other.
    Drawers(usize),
    /// A rod under a shelf, behind doors.
    Hang(Front),
    /// A rod under a shelf, without doors of its own.
    Rod,
    /// Behind a front that folds down.
    Flap(Front),
}

impl Cell {
    fn has_front(self) -> bool {
        !matches!(self, Self::Open(_) | Self::Rod)
    }
}

/// A column: its share of the width, and its cells from bottom to top with their shares of the
/// height.
pub(in crate::object) type Column = (f32, Vec<(f32, Cell)>);

/// A case between two corners; its fronts are at the higher X.
pub(in crate::object) struct Case {
    /// The lowest corner.
    pub(in crate::object) low: P,
    /// The highest corner, without handles.
    pub(in crate::object) high: P,
    /// The columns, from the lower Y to the higher.
    pub(in crate::object) columns: Vec<Column>,
    /// The handles of doors and drawers.
    pub(in crate::object) handle: Handle,
    /// The material of boards.
    pub(in crate::object) body: MaterialId,
    /// The material of fronts.
    pub(in crate::object) front: MaterialId,
    /// The material of the upper board.
    pub(in crate::object) lid: MaterialId,
    /// The material of handles.
    pub(in crate::object) metal: MaterialId,
}

/// Counters for each kind of surface, used in their names.
#[derive(Default)]
pub(in crate::object) struct Tally {
    shelves: usize,
    drawers: usize,
    doors: usize,
    rods: usize,
}

fn next(prefix: &str, count: &mut usize) -> String {
    *count += 1;
    format!("{prefix}_{count}")
}

/// The clear space of a cell and the rectangle of its front, in Y and Z.
struct Space {
    low: P,
    high: P,
    front_y: (f32, f32),
    front_z: (f32, f32),
    /// The outer side, where a single door has its hinge.
    hinge: Swing,
}

/// The ends of spaces that share a length by weight, with gaps between them.
fn shares(from: f32, to: f32, gap: f32, weights: impl Iterator<Item = f32> + Clone) -> Vec<(f32, f32)> {
    let count = weights.clone().count();
    let free = to - from - gap * count.saturating_sub(1) as f32;
    let total: f32 = weights.clone().sum::<f32>().max(1e-6);
    let mut at = from;
    weights
        .map(|w| {
            let end = at + free * w / total;
            let space = (at, end);
            at = end + gap;
            space
        })
        .collect()
}

impl Case {
    /// Builds the case, its fronts and its surfaces.
    pub(in crate::object) fn build(&self, b: &mut Build<'_>) {
        self.counted(b, &mut Tally::default());
    }

    /// Builds it as one of several in a piece, which share the counters of their surfaces.
    pub(in crate::object) fn counted(&self, b: &mut Build<'_>, tally: &mut Tally) {
        let (t, low, high) = (BOARD, self.low, self.high);
        let closed = self.columns.iter().flat_map(|c| &c.1).any(|c| c.1.has_front());
        let front = if closed { high[0] - t } else { high[0] - 0.002 };
        let (z0, z1) = (low[2] + t, high[2] - t);
        b.block("bottom", low, [high[0], high[1], z0], self.body);
        b.block("top", [low[0], low[1], z1], high, self.lid);
        b.block("side", [low[0], low[1], z0], [front, low[1] + t, z1], self.body);
        b.block("side", [low[0], high[1] - t, z0], [front, high[1], z1], self.body);
        b.block("back", [low[0] + 0.001, low[1] + t, z0], [low[0] + 0.008, high[1] - t, z1], self.body);
        let columns = shares(low[1] + t, high[1] - t, t, self.columns.iter().map(|c| c.0));
        let last = columns.len().saturating_sub(1);
        for (i, (y, column)) in columns.into_iter().zip(&self.columns).enumerate() {
            if i > 0 {
                b.block("divider", [low[0] + 0.008, y.0 - t, z0], [front - 0.001, y.0, z1], self.body);
            }
            let front_y =
                (if i == 0 { low[1] } else { y.0 - t / 2.0 }, if i == last { high[1] } else { y.1 + t / 2.0 });
            let hinge = if i == last { Swing::Left } else { Swing::Right };
            let stack = shares(z0, z1, t, column.1.iter().map(|c| c.0));
            let top = stack.len().saturating_sub(1);
            for (k, (z, &(_, cell))) in stack.into_iter().zip(&column.1).enumerate() {
                if k > 0 {
                    b.block("board", [low[0] + 0.008, y.0, z.0 - t], [front - 0.002, y.1, z.0], self.body);
                }
                let front_z = (if k == 0 { z.0 } else { z.0 - t / 2.0 }, if k == top { z.1 } else { z.1 + t / 2.0 });
                let (low, high) = ([low[0] + 0.008, y.0, z.0], [front, y.1, z.1]);
                self.cell(b, cell, &Space { low, high, front_y, front_z, hinge }, tally);
            }
        }
    }

    fn cell(&self, b: &mut Build<'_>, cell: Cell, space: &Space, tally: &mut Tally) {
        match cell {
            Cell::Open(count) => self.shelves(b, space, count, 0.004, tally),
            Cell::Doors(design, count) => {
                self.shelves(b, space, count, 0.02, tally);
                self.doors(b, space, design, tally);
            }
            Cell::Drawers(count) => self.drawers(b, space, count, tally),
            Cell::Hang(design) => {
                self.rod(b, space, tally);
                self.doors(b, space, design, tally);
            }
            Cell::Rod => self.rod(b, space, tally),
            Cell::Flap(design) => {
                self.shelves(b, space, 1, 0.02, tally);
                self.flap(b, space, design, tally);
            }
        }
    }

    fn shelves(&self, b: &mut Build<'_>, space: &Space, count: usize, set_back: f32, tally: &mut Tally) {
        let t = BOARD;
        let weights = std::iter::repeat_n(1.0, count.max(1));
        for (i, (z0, z1)) in shares(space.low[2], space.high[2], t, weights).into_iter().enumerate() {
            let (low, high) = (space.low, [space.high[0] - set_back, space.high[1], z1]);
            if i > 0 {
                b.block("shelf", [low[0], low[1], z0 - t], [high[0], high[1], z0], self.body);
            }
            self.floor(b, &next("shelf", &mut tally.shelves), [low[0], low[1], z0], high, z1 - z0 - 0.005);
        }
    }

    /// A surface that covers the bottom of a space.
    fn floor(&self, b: &mut Build<'_>, name: &str, low: P, high: P, clearance: f32) {
        let half = |i: usize| ((high[i] - low[i]) / 2.0 - 0.005).max(0.001);
        let centre = [f32::midpoint(low[0], high[0]), f32::midpoint(low[1], high[1]), low[2]];
        b.inside(name, centre, (half(0), half(1)), clearance.max(0.01));
    }

    fn rod(&self, b: &mut Build<'_>, space: &Space, tally: &mut Tally) {
        let (low, high) = (space.low, [space.high[0] - 0.02, space.high[1], space.high[2]]);
        let tall = high[2] - low[2];
        let upper = (tall * 0.2).clamp(0.05, 0.35);
        let shelf = high[2] - upper;
        b.block("shelf", [low[0], low[1], shelf - BOARD], [high[0], high[1], shelf], self.body);
        self.floor(b, &next("shelf", &mut tally.shelves), [low[0], low[1], shelf], high, upper - 0.005);
        let (x, z) = (f32::midpoint(low[0], high[0]), shelf - BOARD - 0.05);
        b.rod("rod", [x, low[1], z], [x, high[1], z], 0.0125, self.metal);
        let shoes = (tall * 0.15).min(0.25);
        self.floor(b, &next("shelf", &mut tally.shelves), low, high, shoes);
        let wide = high[1] - low[1];
        let count = ((wide - 0.08) / 0.09).clamp(1.0, 8.0) as usize;
        for i in 0..count {
            let y = low[1] + wide * (i as f32 + 0.5) / count as f32;
            b.hook(&next("rod", &mut tally.rods), [x, y, z - 0.0125], (z - low[2] - shoes - 0.03).max(0.05));
        }
    }

    fn doors(&self, b: &mut Build<'_>, space: &Space, design: Front, tally: &mut Tally) {
        let (y0, y1) = space.front_y;
        let middle = f32::midpoint(y0, y1);
        let pair = [(y0, middle, Swing::Right), (middle, y1, Swing::Left)];
        let single = [(y0, y1, space.hinge)];
        for &(y0, y1, side) in if y1 - y0 > 0.62 { &pair[..] } else { &single[..] } {
            let (low, high) = ([space.high[0], y0, space.front_z.0], [self.high[0], y1, space.front_z.1]);
            let name = next("door", &mut tally.doors);
            leaf(b, &name, (low, high), side, (design, self.handle), (self.front, self.metal));
        }
    }

    fn drawers(&self, b: &mut Build<'_>, space: &Space, count: usize, tally: &mut Tally) {
        // A drawer lower than a hand is only a blind front.
        let tall = space.front_z.1 - space.front_z.0;
        let weights = std::iter::repeat_n(1.0, count.min((tall / 0.085) as usize).max(1));
        for (z0, z1) in shares(space.front_z.0, space.front_z.1, 0.0, weights) {
            let (low, high) = ([space.low[0], space.front_y.0, z0], [self.high[0], space.front_y.1, z1]);
            if tall < 0.062 {
                b.block("front", [space.high[0], low[1], z0], high, self.front);
                continue;
            }
            let name = next("drawer", &mut tally.drawers);
            drawer(b, &name, low, high, self.handle, (self.front, self.body, self.metal));
        }
    }

    fn flap(&self, b: &mut Build<'_>, space: &Space, design: Front, tally: &mut Tally) {
        let ((y0, y1), (z0, z1)) = (space.front_y, space.front_z);
        let (low, high) = gapped([space.high[0], y0, z0], [self.high[0], y1, z1], GAP / 2.0);
        b.hinge([high[0], 0.0, low[2]], [0.0, 1.0, 0.0], FRAC_PI_2, |b| {
            front_panel(b, &next("door", &mut tally.doors), low, high, design, self.front);
            let z = (high[2] - 0.05).max(f32::midpoint(low[2], high[2]));
            let length = ((y1 - y0) * 0.4).min(0.2);
            handle(b, self.handle, [high[0], f32::midpoint(y0, y1), z], length, false, self.metal);
        });
    }
}

/// The stand of a case.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::object) enum Stand {
    /// Its own bottom, or the wall it hangs on.
    None,
    /// A base recessed in front.
    Plinth,
    /// Upright legs.
    Legs,
    /// Round splayed legs.
    Splayed,
    /// A frame of square tube.
    Tube,
}

impl Stand {
    /// How high it lifts the case, metres.
    pub(in crate::object) fn height(self, b: &mut Build<'_>) -> f32 {
        match self {
            Self::None => 0.0,
            Self::Plinth => b.vary(0.05, 0.09),
            Self::Legs | Self::Tube => b.vary(0.1, 0.18),
            Self::Splayed => b.vary(0.13, 0.2),
        }
    }

    /// Builds the stand under a rectangle.
    pub(in crate::object) fn build(self, b: &mut Build<'_>, low: P, high: P, mat: MaterialId, metal: MaterialId) {
        let (x, y, h) = ((high[0] - low[0]) / 2.0, (high[1] - low[1]) / 2.0, low[2]);
        let centre = [f32::midpoint(low[0], high[0]), f32::midpoint(low[1], high[1]), 0.0];
        let thick = 0.018_f32.min(x * 0.2);
        b.at(centre, 0.0, |b| match self {
            Self::None => {}
            Self::Plinth if h < 0.003 => {}
            Self::Plinth => b.block("plinth", [-x + 0.002, -y + 0.002, 0.0], [x * 0.88, y - 0.002, h], mat),
            Self::Legs => Four::upright((x - 0.01, y - 0.01), h, (thick, thick * 1.3), Cut::Square).build(b, mat),
            Self::Splayed => {
                let (feet, heads) = ((x - 0.012, y - 0.03), (x - 0.05_f32.min(x * 0.3), y - 0.12_f32.min(y * 0.3)));
                let four = Four { feet, heads, height: h, radii: (thick * 0.65, thick * 1.2), cut: Cut::Round };
                four.build(b, mat);
            }
            Self::Tube => {
                let t = 0.022_f32.min(x * 0.2);
                let (x, y) = (x - 0.02, y - 0.03);
                Four::upright((x, y), h, (t / 2.0, t / 2.0), Cut::Square).build(b, metal);
                for side in [-1.0_f32, 1.0] {
                    let (a, c) = (side * y, side * (y - t));
                    b.block("tube", [-x + t, a.min(c), 0.0], [x - t, a.max(c), t], metal);
                }
            }
        });
    }
}

/// A piece of case furniture that fills the requested size.
pub(in crate::object) struct Piece {
    /// See [`Case::columns`].
    pub(in crate::object) columns: Vec<Column>,
    /// The handles.
    pub(in crate::object) handle: Handle,
    /// The stand.
    pub(in crate::object) stand: Stand,
    /// The material of boards.
    pub(in crate::object) body: MaterialId,
    /// The material of fronts.
    pub(in crate::object) front: MaterialId,
    /// The material of the top.
    pub(in crate::object) lid: MaterialId,
    /// How far the top protrudes over sides and fronts.
    pub(in crate::object) overhang: f32,
    /// Whether the top is a surface for objects.
    pub(in crate::object) carries: bool,
}

impl Piece {
    /// A piece of one material that stands on a plinth.
    pub(in crate::object) fn new(columns: Vec<Column>, body: MaterialId) -> Self {
        Self {
            columns,
            handle: Handle::None,
            stand: Stand::Plinth,
            body,
            front: body,
            lid: body,
            overhang: 0.0,
            carries: true,
        }
    }

    /// Builds it on its stand, with a height that the stand draws.
    pub(in crate::object) fn build(self, b: &mut Build<'_>) {
        let lift = self.stand.height(b).min(b.size.z * 0.3);
        self.lifted(b, lift);
    }

    /// Builds it, lifted by a height.
    pub(in crate::object) fn lifted(self, b: &mut Build<'_>, lift: f32) {
        let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
        let metal = b.style.metal;
        let closed = self.columns.iter().flat_map(|c| &c.1).any(|c| c.1.has_front());
        let grip = if closed { self.handle.depth() } else { 0.0 };
        let o = self.overhang;
        let (slab, front) = (if o > 0.0 { 0.022 } else { 0.0 }, x - grip.max(o));
        let (low, high) = ([-x, -y + o, lift], [front, y - o, h - slab]);
        self.stand.build(b, low, [front - if closed { BOARD } else { 0.0 }, high[1], high[2]], self.body, metal);
        if o > 0.0 {
            b.rounded_block("lid", [-x, -y, h - slab], [front + o, y, h], 0.005, self.lid);
        }
        let Self { columns, handle, body, front: face, lid, .. } = self;
        let lid = if o > 0.0 { body } else { lid };
        Case { low, high, columns, handle, body, front: face, lid, metal }.build(b);
        if self.carries {
            b.top("top", [f32::midpoint(-x, front), 0.0, h], ((front + x) / 2.0 - 0.01, y - 0.01));
        }
    }
}
