//! Tables and desks.

mod desk;
pub(super) mod frame;
pub(super) mod trolley;

use super::{Generator, indoor};
use crate::material::*;
use crate::solid::{Axis, Build, CORNERS, Cut, P, at_least, disc, ellipse, leg, rounded_by_radius};
use frame::{Four, baluster};

pub(super) const GENERATORS: &[Generator] = &[
    indoor("dining_table", 40, dining_table),
    indoor("kitchen_table", 16, dining_table),
    indoor("coffee_table", 27, coffee_table),
    indoor("low_table", 14, coffee_table),
    indoor("side_table", 20, side_table),
    indoor("high_table", 18, high_table),
    indoor("console_table", 14, console_table),
    indoor("kids_table", 8, kids_table),
    indoor("folding_table", 6, trolley::folding_table),
    indoor("serving_trolley", 6, trolley::serving_trolley),
    indoor("prep_table", 8, trolley::prep_table),
    indoor("workbench", 6, trolley::workbench),
    indoor("desk", 26, desk::desk),
    indoor("standing_desk", 6, desk::standing_desk),
    indoor("dressing_table", 8, desk::dressing_table),
    indoor("changing_table", 5, desk::changing_table),
    indoor("nightstand", 18, desk::nightstand),
];

/// The outline of a table top.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Outline {
    Rect,
    Rounded,
    Pill,
    Oval,
    Octagon,
}

/// The base of a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Base {
    /// Upright legs with aprons.
    Legs,
    /// Turned legs with aprons.
    Turned,
    /// Tapered splayed legs.
    Splayed,
    /// Bent wire legs.
    Hairpin,
    /// Two trestles and a stretcher.
    Trestle,
    /// Crossed planks at both ends.
    Crossed,
    /// A panel at each end.
    Slabs,
    /// A frame of metal tube at each end.
    Loops,
    /// One column on feet, or two under long tops.
    Column,
    /// One flared foot.
    Tulip,
    /// A drum.
    Drum,
}

/// A table under construction: half lengths, height and materials.
struct Table {
    x: f32,
    y: f32,
    h: f32,
    thickness: f32,
    outline: Outline,
    wood: MaterialId,
    top: MaterialId,
    metal: MaterialId,
}

impl Table {
    /// A table of the requested size, with one of the given outlines; square tables are often
    /// round.
    fn new(b: &mut Build<'_>, outlines: &[Outline]) -> Self {
        at_least(b, [0.13, 0.17, 0.13]);
        let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
        let square = x.max(y) < x.min(y) * 1.2;
        let outline = if square && b.rng.chance(0.55) { Outline::Oval } else { b.one_of(outlines) };
        let wood = if b.rng.chance(0.8) { b.style.wood } else { b.style.cabinet };
        let thickness = b.vary(0.022, 0.045).min(h * 0.08);
        Self { x, y, h, thickness, outline, wood, top: wood, metal: b.style.metal }
    }

    /// The half lengths of the largest useful rectangle on the top.
    fn free(&self) -> (f32, f32) {
        let m = 0.008;
        let cut = match self.outline {
            Outline::Rect => 0.0,
            Outline::Rounded => 0.02,
            Outline::Pill => self.x.min(self.y) * 0.293,
            Outline::Octagon => self.x.min(self.y) * 0.17,
            Outline::Oval => return (self.x * 0.7 - m, self.y * 0.7 - m),
        };
        (self.x - cut - m, self.y - cut - m)
    }

    /// The half lengths within which legs stand stably.
    fn stand(&self) -> (f32, f32) {
        match self.outline {
            Outline::Rect | Outline::Rounded => (self.x - 0.02, self.y - 0.02),
            Outline::Pill | Outline::Octagon => (self.x * 0.88, self.y - self.x.min(self.y) * 0.15),
            Outline::Oval => (self.x * 0.74, self.y * 0.74),
        }
    }

    /// The top with its surface.
    fn top(&self, b: &mut Build<'_>) {
        let (half, t) = ((self.x, self.y), self.thickness);
        let base = [0.0, 0.0, self.h - t];
        let outline = match self.outline {
            Outline::Rect => {
                b.rounded_block("top", [-self.x, -self.y, base[2]], [self.x, self.y, self.h], 0.005, self.top);
                Vec::new()
            }
            Outline::Oval if (self.x - self.y).abs() < 1e-3 => {
                disc(b, "top", [0.0, 0.0, self.h], self.x, t, self.top);
                Vec::new()
            }
            Outline::Rounded => rounded_by_radius(half, 0.07),
            Outline::Pill => rounded_by_radius(half, self.x.max(self.y)),
            Outline::Oval => ellipse(half),
            Outline::Octagon => {
                let c = self.x.min(self.y) * 0.58;
                let corner = |(sx, sy): (f32, f32)| {
                    let (p, q) = ((sx * self.x, sy * (self.y - c)), (sx * (self.x - c), sy * self.y));
                    if sx * sy > 0.0 { [p, q] } else { [q, p] }
                };
                CORNERS.into_iter().flat_map(corner).collect()
            }
        };
        if !outline.is_empty() {
            b.prism("top", Axis::Z, base, &outline, t, self.top);
        }
        b.top("top", [0.0, 0.0, self.h], self.free());
    }

    /// Boards below the top, from leg to leg.
    fn aprons(&self, b: &mut Build<'_>, half: (f32, f32), thick: f32) {
        let (under, drop) = (self.h - self.thickness, (self.h * 0.12).min(0.09));
        for side in [-1.0_f32, 1.0] {
            let (cx, cy) = (side * (half.0 - thick / 2.0), side * (half.1 - thick / 2.0));
            let (ax, ay) = (half.0 - thick * 0.7, half.1 - thick * 0.7);
            b.block("apron", [-ax, cy - 0.01, under - drop + 0.001], [ax, cy + 0.01, under], self.wood);
            b.block("apron", [cx - 0.01, -ay, under - drop], [cx + 0.01, ay, under], self.wood);
        }
    }

    /// Half the usual thickness of a leg.
    fn girth(&self) -> f32 {
        (0.028 + 0.012 * self.x.min(self.y)).min(self.x * 0.16)
    }

    /// The base that supports the top.
    fn base(&self, b: &mut Build<'_>, base: Base) {
        let (half, under) = (self.stand(), self.h - self.thickness);
        let girth = self.girth();
        match base {
            Base::Legs => {
                let r = b.vary(0.8, 1.15) * girth;
                let cut = b.choose(&[Cut::Square, Cut::Square, Cut::Round]);
                let foot = b.choose(&[1.0, 0.6]) * r;
                Four::upright(half, under, (foot, r), cut).build(b, self.wood);
                self.aprons(b, half, 2.0 * r);
            }
            Base::Turned => {
                let r = girth * 1.1;
                for (sx, sy) in CORNERS {
                    baluster(b, "leg", [sx * (half.0 - r), sy * (half.1 - r), 0.0], r, under, self.wood);
                }
                self.aprons(b, half, 2.0 * r);
            }
            Base::Splayed => {
                let inset = (under * 0.14).min(half.0 * 0.4).min(half.1 * 0.4);
                let heads = (half.0 - inset, half.1 - inset);
                let r = girth * 0.9;
                Four { feet: half, heads, height: under, radii: (r * 0.55, r), cut: Cut::Round }.build(b, self.wood);
                self.aprons(b, heads, 2.0 * r);
            }
            Base::Hairpin => self.hairpins(b, half, under),
            Base::Trestle => self.trestles(b, half, under, girth),
            Base::Crossed => self.crosses(b, half, under, girth),
            Base::Slabs => self.slabs(b, half, under),
            Base::Loops => self.loops(b, half, under),
            Base::Column => self.columns(b, half, under, girth),
            Base::Tulip => {
                let r = half.0.min(half.1);
                let (foot, neck) = (r * 0.75, (r * 0.13).max(0.02));
                let profile = [
                    (foot, 0.0),
                    (foot * 0.97, under * 0.02),
                    (foot * 0.5, under * 0.08),
                    (neck * 1.3, under * 0.2),
                    (neck, under * 0.5),
                    (neck * 1.3, under * 0.85),
                    (r * 0.45, under),
                ];
                b.lathe("foot", [0.0; 3], &profile, self.wood);
            }
            Base::Drum => {
                let r = half.0.min(half.1);
                let profile = [(r * 0.9, 0.0), (r, under * 0.12), (r, under * 0.88), (r * 0.9, under)];
                b.lathe("drum", [0.0; 3], &profile, self.wood);
            }
        }
    }

    fn hairpins(&self, b: &mut Build<'_>, half: (f32, f32), under: f32) {
        let (r, spread) = (0.006, (half.0.min(half.1) * 0.3).min(0.11));
        let wire = |b: &mut Build<'_>, foot: P, head: P| leg(b, "leg", (foot, r), (head, r), Cut::Round, self.metal);
        for (sx, sy) in CORNERS {
            let foot = [sx * (half.0 - r), sy * (half.1 - r), 0.0];
            let head = |dx: f32, dy: f32| [sx * (half.0 - 0.03 - dx), sy * (half.1 - 0.03 - dy), under];
            wire(b, foot, head(spread, 0.0));
            wire(b, foot, head(0.0, spread));
        }
    }

    fn trestles(&self, b: &mut Build<'_>, half: (f32, f32), under: f32, girth: f32) {
        let y = half.1 * 0.72;
        let (beam, r) = (0.06_f32.min(under * 0.15), girth * 0.8);
        for side in [-1.0, 1.0] {
            let cy = side * y;
            for sx in [-1.0, 1.0] {
                let (foot, head) = ([sx * (half.0 - r), cy, 0.0], [sx * half.0 * 0.35, cy, under - beam]);
                leg(b, "leg", (foot, r), (head, r), Cut::Square, self.wood);
            }
            b.block("beam", [-half.0 * 0.85, cy - r, under - beam], [half.0 * 0.85, cy + r, under], self.wood);
            let (low, z) = (half.0 * 0.8, under * 0.2);
            b.block("rung", [-low, cy - r * 0.6, z], [low, cy + r * 0.6, z + beam * 0.7], self.wood);
        }
        let z = under * 0.2 + beam * 0.2;
        b.block("stretcher", [-r * 0.6, -y, z], [r * 0.6, y, z + beam * 0.9], self.wood);
    }

    fn crosses(&self, b: &mut Build<'_>, half: (f32, f32), under: f32, girth: f32) {
        let (y, w, t) = (half.1 * 0.75, girth * 1.3, girth * 0.8);
        for side in [-1.0_f32, 1.0] {
            for (k, sx) in [(0.0, -1.0), (1.0, 1.0)] {
                let (a, c) = (sx * (half.0 - w), -sx * (half.0 - w));
                let outline = [(a - w, 0.0), (a + w, 0.0), (c + w, under), (c - w, under)];
                // The second leg lies behind the first and is half-lapped with it.
                let cy = side * (y - k * t * 0.4);
                b.prism("leg", Axis::Y, [0.0, cy - t / 2.0, 0.0], &outline, t, self.wood);
            }
        }
        b.block("stretcher", [-w * 0.6, -y, under / 2.0 - w * 0.6], [w * 0.6, y, under / 2.0 + w * 0.6], self.wood);
    }

    fn slabs(&self, b: &mut Build<'_>, half: (f32, f32), under: f32) {
        let t = self.thickness;
        for side in [-1.0_f32, 1.0] {
            let (a, c) = (side * half.1, side * (half.1 - t));
            b.block("panel", [-half.0, a.min(c), 0.0], [half.0, a.max(c), under], self.wood);
        }
        let z = under * 0.55;
        b.block(
            "stretcher",
            [-half.0 * 0.1 - 0.009, t - half.1, z],
            [0.009 - half.0 * 0.1, half.1 - t, under],
            self.wood,
        );
    }

    fn loops(&self, b: &mut Build<'_>, half: (f32, f32), under: f32) {
        let t = 0.035_f32.min(half.0 * 0.15);
        let y = half.1 - 0.01;
        Four::upright((half.0, y), under, (t / 2.0, t / 2.0), Cut::Square).build(b, self.metal);
        for side in [-1.0_f32, 1.0] {
            let (a, c) = (side * y, side * (y - t));
            for z in [0.0, under - t] {
                b.block("tube", [t - half.0, a.min(c), z], [half.0 - t, a.max(c), z + t], self.metal);
            }
            let x = side * (half.0 - t / 2.0);
            b.block("tube", [x - t / 2.0, t - y, under - t], [x + t / 2.0, y - t, under - 0.001], self.metal);
        }
    }

    fn columns(&self, b: &mut Build<'_>, half: (f32, f32), under: f32, girth: f32) {
        let long = half.1 > half.0 * 1.6;
        let spots: &[f32] = if long { &[-0.55, 0.55] } else { &[0.0] };
        let reach = (half.0, if long { half.0 } else { half.1 });
        let disc_foot = b.rng.chance(0.4);
        let r = girth * 1.2;
        for spot in spots {
            b.at([0.0, spot * half.1, 0.0], 0.0, |b| {
                let flat = reach.0.min(reach.1);
                if disc_foot {
                    let profile = [(flat * 0.75, 0.0), (flat * 0.75, 0.012), (r * 1.4, 0.04), (r, 0.06), (r, under)];
                    b.lathe("column", [0.0; 3], &profile, self.metal);
                } else {
                    baluster(b, "column", [0.0, 0.0, under * 0.1], r * 1.3, under * 0.9, self.wood);
                    for (dx, dy) in [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)] {
                        let foot =
                            [dx * (reach.0 * 0.9 - r), dy * (reach.1 * 0.9 - r) * if long { 0.7 } else { 1.0 }, 0.0];
                        let head = [dx * r * 0.3, dy * r * 0.3, under * 0.3];
                        leg(b, "foot", (foot, r * 0.45), (head, r * 0.6), Cut::Round, self.wood);
                    }
                }
                let (px, py) = (reach.0 * 0.6, reach.1 * 0.6);
                b.block("plate", [-px, -py.min(0.06), under - 0.02], [px, py.min(0.06), under], self.wood);
            });
        }
    }

    /// A shelf between upright legs.
    fn lower_shelf(&self, b: &mut Build<'_>, z: f32) {
        let (girth, thick) = (self.girth(), self.girth() * 2.4);
        let (half, under) = (self.stand(), self.h - self.thickness);
        let (x, y) = (half.0 - girth * 0.5, half.1 - girth * 0.5);
        b.block("shelf", [-x, -y, z - 0.018], [x, y, z], self.wood);
        let free = (half.0 - thick - 0.01, half.1 - thick - 0.01);
        b.ledge("shelf", [0.0, 0.0, z], free, under - (self.h * 0.12).min(0.09) - z - 0.005);
    }
}

const LONG: &[Outline] =
    &[Outline::Rect, Outline::Rect, Outline::Rect, Outline::Rounded, Outline::Pill, Outline::Oval, Outline::Octagon];

/// A base that suits an outline: bases with end panels need straight ends.
fn suited(b: &mut Build<'_>, table: &Table, straight: &[Base], curved: &[Base]) -> Base {
    match table.outline {
        Outline::Rect | Outline::Rounded => b.one_of(straight),
        _ => b.one_of(curved),
    }
}

/// A dining or kitchen table: planked, oval or round top, on legs, trestles, columns.
fn dining_table(b: &mut Build<'_>) {
    let mut table = Table::new(b, LONG);
    let straight = [
        Base::Legs,
        Base::Legs,
        Base::Legs,
        Base::Turned,
        Base::Splayed,
        Base::Trestle,
        Base::Crossed,
        Base::Slabs,
        Base::Loops,
        Base::Column,
    ];
    let curved = [Base::Splayed, Base::Column, Base::Column, Base::Trestle];
    let round = table.outline == Outline::Oval && table.y < table.x * 1.5;
    let base = if round && b.rng.chance(0.3) { Base::Tulip } else { suited(b, &table, &straight, &curved) };
    if base == Base::Tulip {
        (table.wood, table.top) = (WHITE, b.choose(&[WHITE, MARBLE]));
    } else if b.rng.chance(0.15) {
        table.top = b.choose(&[WHITE, MARBLE, CONCRETE, BLACK_GRANITE]);
    }
    table.top(b);
    table.base(b, base);
    if table.outline == Outline::Rect && table.top == table.wood && b.rng.chance(0.4) {
        breadboards(b, &table);
    }
}

/// Boards across the ends of the top, thicker than the top.
fn breadboards(b: &mut Build<'_>, table: &Table) {
    let (x, y, w) = (table.x - 0.002, table.y - 0.002, 0.08_f32.min(table.y * 0.2));
    let z = table.h - table.thickness - 0.004;
    for side in [-1.0_f32, 1.0] {
        let (a, c) = (side * y, side * (y - w));
        b.block("end_board", [-x, a.min(c), z], [x, a.max(c), table.h - 0.003], table.wood);
    }
}

/// A coffee table: wood, stone or glass on legs, loops, slabs, often with a shelf.
fn coffee_table(b: &mut Build<'_>) {
    let mut table = Table::new(b, LONG);
    table.top = match b.rng.below(8) {
        0 => MARBLE,
        1 => GLASS,
        2 => CONCRETE,
        3 => b.style.cabinet,
        _ => table.wood,
    };
    let straight = [Base::Legs, Base::Splayed, Base::Slabs, Base::Loops, Base::Hairpin, Base::Crossed];
    let curved = [Base::Splayed, Base::Column, Base::Hairpin, Base::Splayed];
    let base = suited(b, &table, &straight, &curved);
    if table.top == GLASS {
        table.thickness = table.thickness.min(0.012);
    }
    table.top(b);
    table.base(b, base);
    match base {
        Base::Legs | Base::Loops if b.rng.chance(0.6) => table.lower_shelf(b, table.h * 0.35),
        Base::Slabs => {
            let (half, t) = (table.stand(), table.thickness);
            let (x, y, z) = (half.0 - 0.004, half.1 - t, table.h * 0.18);
            b.block("shelf", [-x, -y, z - 0.018], [x, y, z], table.wood);
            let from = 0.015 - half.0 * 0.1;
            let clear = table.h - table.thickness - z - 0.005;
            b.ledge("shelf", [f32::midpoint(from, x), 0.0, z], ((x - from) / 2.0 - 0.01, y - 0.01), clear);
        }
        _ => {}
    }
}

/// A small table beside a sofa: round, square, a drum, a tulip base or a C-shaped tube.
fn side_table(b: &mut Build<'_>) {
    let mut table = Table::new(b, &[Outline::Rect, Outline::Rounded, Outline::Octagon]);
    if b.rng.chance(0.2) {
        table.top = b.choose(&[MARBLE, GLASS, BRASS]);
    }
    let straight = [Base::Legs, Base::Splayed, Base::Loops, Base::Slabs, Base::Turned, Base::Hairpin];
    let curved = [Base::Splayed, Base::Column, Base::Tulip, Base::Drum, Base::Hairpin, Base::Splayed];
    let base = suited(b, &table, &straight, &curved);
    if base == Base::Tulip {
        (table.wood, table.top) = (WHITE, b.choose(&[WHITE, MARBLE]));
    }
    table.thickness = table.thickness.min(0.028);
    table.top(b);
    table.base(b, base);
    if matches!(base, Base::Legs | Base::Loops | Base::Turned) && b.rng.chance(0.6) {
        table.lower_shelf(b, table.h * 0.3);
    }
}

/// A bar table on a column, on loops or on tall legs with a footrest.
fn high_table(b: &mut Build<'_>) {
    let mut table = Table::new(b, &[Outline::Rect, Outline::Rect, Outline::Rounded, Outline::Pill]);
    let straight = [Base::Legs, Base::Legs, Base::Loops, Base::Trestle, Base::Slabs, Base::Splayed];
    let base = suited(b, &table, &straight, &[Base::Column, Base::Column, Base::Splayed]);
    if b.rng.chance(0.25) {
        table.top = b.choose(&[WHITE, BLACK, MARBLE]);
    }
    table.top(b);
    table.base(b, base);
    if matches!(base, Base::Legs | Base::Loops | Base::Slabs) {
        let (half, z) = (table.stand(), (table.h * 0.25).min(0.3));
        for side in [-1.0_f32, 1.0] {
            let x = side * (half.0 - 0.03_f32.min(half.0 * 0.2));
            b.rod("footrest", [x, 0.025 - half.1, z], [x, half.1 - 0.025, z], 0.012, table.metal);
        }
    }
}

/// A narrow table along a wall, with a shelf or drawers.
fn console_table(b: &mut Build<'_>) {
    let mut table = Table::new(b, &[Outline::Rect, Outline::Rect, Outline::Rounded, Outline::Pill]);
    let straight = [Base::Legs, Base::Legs, Base::Turned, Base::Loops, Base::Splayed, Base::Crossed, Base::Hairpin];
    let base = suited(b, &table, &straight, &[Base::Splayed, Base::Hairpin, Base::Loops]);
    if b.rng.chance(0.25) {
        table.top = b.choose(&[MARBLE, GLASS]);
    }
    let drawers = matches!(base, Base::Legs | Base::Turned) && b.rng.chance(0.5);
    if drawers {
        desk::drawers_below(b, (table.x - 0.02, table.y - 0.02), (table.h, table.thickness), table.wood);
        table.top(b);
        let half = (table.x - 0.02, table.y - 0.02);
        let height = table.h - table.thickness - 0.13;
        let r = (table.x * 0.13).min(0.025);
        Four::upright((half.0 - 0.024, half.1), height, (r * 0.7, r), Cut::Square).build(b, table.wood);
        return;
    }
    table.top(b);
    table.base(b, base);
    if matches!(base, Base::Legs | Base::Loops | Base::Turned) && b.rng.chance(0.7) {
        table.lower_shelf(b, table.h * 0.2);
    }
}

/// A children's play table in bright colours.
fn kids_table(b: &mut Build<'_>) {
    let mut table = Table::new(b, &[Outline::Rect, Outline::Rounded, Outline::Pill]);
    table.top = b.choose(&[WHITE, SKY, YELLOW, table.wood, RED, GREEN]);
    let base = suited(b, &table, &[Base::Legs, Base::Splayed, Base::Legs], &[Base::Splayed]);
    table.top(b);
    table.base(b, base);
}
