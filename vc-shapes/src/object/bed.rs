//! Beds: frame and mattress. Duvets and pillows are separate objects.

use super::table::frame::baluster;
use super::{Generator, indoor};
use crate::material::*;
use crate::object::joinery::{Front, front_panel};
use crate::solid::{Axis, Build, CORNERS, Cut, at_least, leg};

pub(super) const GENERATORS: &[Generator] = &[
    indoor("double_bed", 18, bed),
    indoor("single_bed", 12, bed),
    indoor("bed", 8, bed),
    indoor("kids_bed", 7, kids_bed),
    indoor("crib", 6, crib),
    indoor("bunk_bed", 5, bunk_bed),
    indoor("mattress", 5, mattress),
    indoor("air_mattress", 3, air_mattress),
];

/// The design of a bed's frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Design {
    /// A low platform on recessed legs, with a panel at the head.
    Platform,
    /// Posts, rails and boards of slats at both ends.
    Slatted,
    /// Framed or reeded panels between posts.
    Panelled,
    /// An upholstered box with a padded head.
    Upholstered,
    /// Rods of metal between posts.
    Metal,
    /// A box spring without a head.
    Divan,
}

/// A bed under construction: half depth, half width, height; X points from head to foot.
struct Bed {
    x: f32,
    y: f32,
    h: f32,
    /// The height of the mattress's upper side.
    top: f32,
    /// The thickness of the mattress.
    mattress: f32,
    wood: MaterialId,
    cloth: MaterialId,
    metal: MaterialId,
}

impl Bed {
    fn new(b: &mut Build<'_>) -> Self {
        at_least(b, [0.6, 0.3, 0.2]);
        let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
        let top = if h < 0.6 { h * 0.92 } else { b.vary(0.46, 0.58).min(h * 0.75) };
        let metal = b.choose(&[BLACK_METAL, WHITE_METAL, BRASS, b.style.metal]);
        let wood = b.choose(&[b.style.wood, b.style.wood, b.style.cabinet]);
        let cloth = b.choose(&[b.style.upholstery, b.style.accent, BEIGE_FABRIC]);
        Self { x, y, h, top, mattress: b.vary(0.18, 0.25).min(top * 0.5), wood, cloth, metal }
    }

    /// The mattress with its fitted sheet, between head and foot.
    fn mattress(&self, b: &mut Build<'_>, x: (f32, f32), half: f32) {
        let (low, linen) = (self.top - self.mattress, b.style.linen);
        b.rounded_block("mattress", [x.0, -half, low], [x.1, half, self.top], 0.05, linen);
        b.block(
            "seam",
            [x.0 + 0.02, -half - 0.002, low + self.mattress * 0.3],
            [x.1 - 0.02, half + 0.002, low + self.mattress * 0.36],
            WHITE_COTTON,
        );
        b.top("mattress", [f32::midpoint(x.0, x.1), 0.0, self.top], ((x.1 - x.0) / 2.0 - 0.04, half - 0.04));
    }

    /// Boards along the sides, and slats that carry the mattress.
    fn rails(&self, b: &mut Build<'_>, x: (f32, f32), half: f32, tall: f32, mat: MaterialId) {
        let (t, high) = (0.025, self.top - self.mattress * 0.75);
        for side in [-1.0_f32, 1.0] {
            let (a, c) = (side * half, side * (half - t));
            b.block("rail", [x.0, a.min(c), high - tall], [x.1, a.max(c), high], mat);
        }
        let z = self.top - self.mattress - 0.001;
        b.block("slats", [x.0 + 0.01, t - half, z - 0.02], [x.1 - 0.01, half - t, z], BIRCH);
        b.block("beam", [x.0, -0.03, z - 0.06], [x.1, 0.03, z - 0.019], mat);
    }
}

/// A bed of one of six designs.
fn bed(b: &mut Build<'_>) {
    let bed = Bed::new(b);
    let high = bed.h > bed.top + 0.12;
    let designs: &[Design] = if high {
        &[Design::Platform, Design::Slatted, Design::Panelled, Design::Upholstered, Design::Metal, Design::Upholstered]
    } else {
        &[Design::Divan, Design::Platform]
    };
    match b.one_of(designs) {
        Design::Platform => platform(b, &bed, high),
        Design::Upholstered => upholstered(b, &bed),
        Design::Divan => divan(b, &bed),
        design => posted(b, &bed, design),
    }
}

fn platform(b: &mut Build<'_>, bed: &Bed, head: bool) {
    let t = if head { 0.035 } else { 0.0 };
    let deck = (bed.top - bed.mattress).max(0.1);
    let (x0, x1) = (-bed.x + t, bed.x);
    b.rounded_block("platform", [x0, -bed.y, deck - 0.07_f32.min(deck * 0.5)], [x1, bed.y, deck], 0.01, bed.wood);
    let (lx, ly, low) = (bed.x * 0.78, bed.y * 0.8, deck - 0.07_f32.min(deck * 0.5) + 0.002);
    for (sx, sy) in CORNERS {
        leg(b, "leg", ([sx * lx, sy * ly, 0.0], 0.028), ([sx * lx, sy * ly, low], 0.035), Cut::Square, bed.wood);
    }
    let m = 0.04;
    bed.mattress(b, (x0 + 0.01, x1 - m), bed.y - m);
    if head {
        let look = Front::any(b);
        let low = deck - 0.05_f32.min(deck * 0.4);
        front_panel(b, "headboard", [-bed.x, -bed.y, low], [x0 + 0.001, bed.y, bed.h], look, bed.wood);
    }
}

fn upholstered(b: &mut Build<'_>, bed: &Bed) {
    let (t, lift) = (0.1_f32.min(bed.x * 0.1), 0.08_f32.min(bed.top * 0.2));
    let rim = bed.top - bed.mattress * 0.55;
    for (sx, sy) in CORNERS {
        let (cx, cy) = (sx * (bed.x - 0.06), sy * (bed.y - 0.06));
        leg(b, "leg", ([cx, cy, 0.0], 0.016), ([cx, cy, lift + 0.004], 0.024), Cut::Round, bed.wood);
    }
    let (x0, w) = (-bed.x + t, 0.05);
    b.rounded_block("frame", [-bed.x + t * 0.5, -bed.y + 0.004, lift], [bed.x, w - bed.y, rim], 0.02, bed.cloth);
    b.rounded_block("frame", [-bed.x + t * 0.5, bed.y - w, lift], [bed.x, bed.y - 0.004, rim], 0.02, bed.cloth);
    b.rounded_block(
        "frame",
        [bed.x - w, -bed.y + 0.006, lift + 0.001],
        [bed.x - 0.001, bed.y - 0.006, rim - 0.001],
        0.02,
        bed.cloth,
    );
    b.block(
        "deck",
        [x0, w - bed.y - 0.005, lift + 0.05],
        [bed.x - w + 0.005, bed.y - w + 0.005, bed.top - bed.mattress],
        bed.cloth,
    );
    bed.mattress(b, (x0 + 0.005, bed.x - w - 0.003), bed.y - w - 0.004);
    b.rounded_block("headboard", [-bed.x, -bed.y, lift], [-bed.x + t * 0.6, bed.y, bed.h], 0.025, bed.cloth);
    // Padding in channels or squares.
    let channels = b.rng.chance(0.5);
    let (count, rows) = if channels { ((bed.y / 0.11) as usize, 1) } else { ((bed.y / 0.22) as usize, 2) };
    let (count, low) = (count.max(2), bed.top - 0.05);
    let pitch = (2.0 * bed.y - 0.03) / count as f32;
    let tall = (bed.h - 0.015 - low) / rows as f32;
    for (i, k) in (0..count).flat_map(|i| (0..rows).map(move |k| (i, k))) {
        let (y, z) = (0.015 - bed.y + pitch * i as f32, low + tall * k as f32);
        b.rounded_block(
            "padding",
            [-bed.x + t * 0.4, y + 0.001, z + 0.001],
            [x0 - 0.002, y + pitch - 0.001, z + tall - 0.001],
            0.024,
            bed.cloth,
        );
    }
}

fn divan(b: &mut Build<'_>, bed: &Bed) {
    let lift = 0.06_f32.min(bed.top * 0.15);
    for (sx, sy) in CORNERS {
        b.cylinder("foot", [sx * (bed.x - 0.08), sy * (bed.y - 0.08), 0.0], 0.025, lift + 0.003, bed.metal);
    }
    b.rounded_block("box", [-bed.x, -bed.y, lift], [bed.x, bed.y, bed.top - bed.mattress], 0.02, bed.cloth);
    bed.mattress(b, (0.004 - bed.x, bed.x - 0.004), bed.y - 0.006);
}

/// Beds with posts at the corners: slats, panels or rods between them.
fn posted(b: &mut Build<'_>, bed: &Bed, design: Design) {
    let metal = design == Design::Metal;
    let (mat, r) = if metal { (bed.metal, 0.018) } else { (bed.wood, 0.032) };
    let foot = bed.top + b.choose(&[-0.1_f32, 0.0, 0.15]).min((bed.h - bed.top) * 0.5);
    let round = b.rng.chance(0.5);
    for (sx, high) in [(-1.0, bed.h), (1.0, foot)] {
        let cx = sx * (bed.x - r);
        for sy in [-1.0, 1.0] {
            let cy = sy * (bed.y - r);
            if metal {
                b.cylinder("post", [cx, cy, 0.0], r * 0.8, high - 1.6 * r, mat);
                b.ball("knob", [cx, cy, high - r], r, mat);
            } else if round && sx > 0.0 {
                baluster(b, "post", [cx, cy, 0.0], r, high, mat);
            } else {
                b.block("post", [cx - r, cy - r, 0.0], [cx + r, cy + r, high - 0.001], mat);
            }
        }
        let low = bed.top - bed.mattress * 0.9;
        let y = bed.y - r;
        match design {
            Design::Slatted => {
                b.block("rail", [cx - r * 0.6, -y, high - 0.08], [cx + r * 0.6, y, high - 0.012], mat);
                b.block("rail", [cx - r * 0.6, -y, low - 0.1], [cx + r * 0.6, y, low], mat);
                let count = (y / 0.06).clamp(3.0, 16.0) as usize;
                for i in 0..count {
                    let cy = y * (2.0 * (i as f32 + 0.5) / count as f32 - 1.0);
                    let w = y / count as f32 * 0.45;
                    b.block("slat", [cx - r * 0.3, cy - w, low - 0.002], [cx + r * 0.3, cy + w, high - 0.078], mat);
                }
            }
            Design::Metal => {
                for z in [high - 0.08, low] {
                    b.rod("bar", [cx, -y, z], [cx, y, z], r * 0.6, mat);
                }
                let count = (y / 0.07).clamp(3.0, 14.0) as usize;
                for i in 0..count {
                    let cy = y * (2.0 * (i as f32 + 0.5) / count as f32 - 1.0);
                    b.rod("bar", [cx, cy, low], [cx, cy, high - 0.08], 0.007, mat);
                }
            }
            _ => {
                let look = b.choose(&[Front::Framed, Front::Reeded, Front::Louvred]);
                b.block("cap", [cx - r * 0.9, -y - 0.001, high - 0.04], [cx + r * 0.9, y + 0.001, high - 0.003], mat);
                front_panel(b, "board", [cx - 0.014, -y, low - 0.12], [cx + 0.014, y, high - 0.039], look, mat);
            }
        }
    }
    let inner = (-bed.x + 2.0 * r + 0.004, bed.x - 2.0 * r - 0.004);
    let rail: f32 = if metal { 0.05 } else { 0.14 };
    bed.rails(b, (inner.0 - 0.02, inner.1 + 0.02), bed.y - 0.012, rail.min(bed.top * 0.3), mat);
    bed.mattress(b, inner, bed.y - 0.012 - 0.027);
}

/// A small low bed with guards at its head end, some with arched ends, in various colours.
fn kids_bed(b: &mut Build<'_>) {
    let mut bed = Bed::new(b);
    let wood = b.choose(&[b.style.wood, WHITE, SKY, DUSTY_ROSE, b.style.cabinet, RED]);
    bed.top = (bed.h * 0.6).min(0.4);
    bed.mattress = (bed.top * 0.35).min(0.12);
    let (x, y, h, t) = (bed.x, bed.y, bed.h, 0.022);
    let foot = bed.top + (h - bed.top) * b.vary(0.2, 0.6);
    let arched = b.rng.chance(0.5);
    for (cx, high) in [(-x, h), (x - t, foot)] {
        let mut outline =
            vec![(-y, 0.0), (-y + 0.09, 0.0), (-y + 0.1, 0.05), (y - 0.1, 0.05), (y - 0.09, 0.0), (y, 0.0)];
        if arched {
            let drop = (high - bed.top) * 0.6;
            let arc = [
                (1.0, 1.0),
                (0.85, 0.45),
                (0.6, 0.15),
                (0.25, 0.02),
                (0.0, 0.0),
                (-0.25, 0.02),
                (-0.6, 0.15),
                (-0.85, 0.45),
                (-1.0, 1.0),
            ];
            outline.extend(arc.map(|(k, d)| (k * y, high - d * drop)));
        } else {
            outline.extend([(y, high - 0.04), (y - 0.04, high), (0.04 - y, high), (-y, high - 0.04)]);
        }
        b.prism("end", Axis::X, [cx, 0.0, 0.0], &outline, t, wood);
    }
    let guard = f32::midpoint(bed.top, foot);
    let rail = bed.top - bed.mattress * 0.5;
    for side in [-1.0_f32, 1.0] {
        let (a, c) = (side * (y - 0.004), side * (y - 0.004 - t));
        b.block("rail", [t - x, a.min(c), rail - 0.11_f32.min(rail * 0.6)], [x - t, a.max(c), rail], wood);
        let y0 = a.min(c);
        let outline = [(t - x, rail - 0.01), (x * 0.1, rail - 0.01), (0.0, guard), (t - x, guard)];
        b.prism("guard", Axis::Y, [0.0, y0 + 0.001, 0.0], &outline, t - 0.002, wood);
    }
    let low = bed.top - bed.mattress;
    b.block("slats", [t - x, t - y + 0.004, low - 0.018], [x - t, y - t - 0.004, low - 0.001], BIRCH);
    bed.mattress(b, (t - x + 0.004, x - t - 0.004), y - t - 0.009);
}

/// A cot with barred sides and a small mattress.
fn crib(b: &mut Build<'_>) {
    at_least(b, [0.5, 0.3, 0.4]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let wood = b.choose(&[b.style.wood, WHITE, b.style.cabinet]);
    let (t, low, rail) = (0.03, h * 0.22, 0.05_f32.min(h * 0.08));
    for (sx, sy) in CORNERS {
        let (cx, cy) = (sx * (x - t / 2.0), sy * (y - t / 2.0));
        b.block("post", [cx - t / 2.0, cy - t / 2.0, 0.0], [cx + t / 2.0, cy + t / 2.0, h], wood);
    }
    let solid = b.rng.chance(0.4);
    for side in [-1.0, 1.0] {
        let (cx, cy) = (side * (x - t / 2.0), side * (y - t / 2.0));
        for z in [low, h - rail - 0.004] {
            b.block("rail", [t - x, cy - 0.01, z], [x - t, cy + 0.01, z + rail], wood);
            b.block("rail", [cx - 0.01, t - y, z], [cx + 0.01, y - t, z + rail], wood);
        }
        let (z0, z1) = (low + rail - 0.003, h - rail - 0.001);
        let count = ((x - t) / 0.045).clamp(4.0, 14.0) as usize;
        for i in 0..count {
            let bar = (x - t) * (2.0 * (i as f32 + 0.5) / count as f32 - 1.0);
            b.block("bar", [bar - 0.008, cy - 0.006, z0], [bar + 0.008, cy + 0.006, z1], wood);
        }
        if solid {
            b.block("end", [cx - 0.007, t - y - 0.001, z0], [cx + 0.007, y - t + 0.001, z1], wood);
            continue;
        }
        let count = ((y - t) / 0.045).clamp(3.0, 8.0) as usize;
        for i in 0..count {
            let bar = (y - t) * (2.0 * (i as f32 + 0.5) / count as f32 - 1.0);
            b.block("bar", [cx - 0.006, bar - 0.008, z0], [cx + 0.006, bar + 0.008, z1], wood);
        }
    }
    let (deck, half) = (low + rail * 0.5, (x - t - 0.004, y - t - 0.004));
    let reach = (x - t * 0.5 - 0.009, y - t * 0.5 - 0.009);
    b.block("deck", [-reach.0, -reach.1, deck - 0.015], [reach.0, reach.1, deck], wood);
    let thick = 0.1_f32.min(h * 0.12);
    let sheet = b.choose(&[WHITE_COTTON, b.style.linen, SKY, CREAM]);
    b.rounded_block("mattress", [-half.0, -half.1, deck], [half.0, half.1, deck + thick], 0.025, sheet);
    b.top("mattress", [0.0, 0.0, deck + thick], (half.0 - 0.03, half.1 - 0.03));
}

/// Two beds above each other, with guards above and a ladder at the side.
fn bunk_bed(b: &mut Build<'_>) {
    let bed = Bed::new(b);
    let (x, y, h) = (bed.x, bed.y, bed.h);
    let metal = b.rng.chance(0.35);
    let (mat, r) = if metal { (bed.metal, 0.02) } else { (b.choose(&[bed.wood, WHITE, PINE]), 0.033) };
    let (step, thick) = (0.05, bed.mattress.min(h * 0.09).min(0.15));
    let inset = if metal { 0.03 } else { 0.045 };
    let half = y - inset;
    for (sx, sy) in CORNERS {
        let (cx, cy) = (sx * (x - r), sy * (half - r));
        if metal {
            b.cylinder("post", [cx, cy, 0.0], r, h, mat);
        } else {
            b.block("post", [cx - r, cy - r, 0.0], [cx + r, cy + r, h], mat);
        }
    }
    for (i, top) in [h * 0.3, h * 0.8].into_iter().enumerate() {
        let deck = top - thick;
        let (in_x, in_y) = (x - 2.0 * r, half - 2.0 * r);
        for side in [-1.0_f32, 1.0] {
            let (cx, cy) = (side * (x - r), side * (half - r));
            b.block("rail", [-in_x, cy - 0.013, deck - 0.06], [in_x, cy + 0.013, deck + 0.04], mat);
            b.block("rail", [cx - 0.013, -in_y, deck - 0.06], [cx + 0.013, in_y, deck + 0.04], mat);
            for z in [deck + (h - top).min(h * 0.2) * 0.45 + thick, (top + h * 0.2).min(h - 0.04)] {
                b.block("board", [cx - 0.01, -in_y, z - 0.035], [cx + 0.01, in_y, z + 0.035], mat);
                if i == 1 {
                    let from = if side > 0.0 { -in_x * 0.55 } else { -in_x };
                    b.block("guard", [from, cy - 0.01, z - 0.03], [in_x, cy + 0.01, z + 0.03], mat);
                }
            }
        }
        // Where the guard leaves a gap, a short post holds its end.
        let gap = -in_x * 0.55;
        if i == 1 {
            let cy = half - r;
            b.block(
                "guard_post",
                [gap + 0.001, cy - 0.012, deck + 0.039],
                [gap + 0.03, cy + 0.012, (top + h * 0.2).min(h - 0.04) + 0.029],
                mat,
            );
        }
        let reach = half - r - 0.012;
        b.block("slats", [-in_x, -reach, deck - 0.02], [in_x, reach, deck - 0.001], BIRCH);
        let linen = b.style.linen;
        b.rounded_block("mattress", [-in_x, -in_y, deck], [in_x, in_y, top], 0.03, linen);
        let (centre, free) = ([0.0, 0.0, top], (in_x - 0.03, in_y - 0.03));
        if i == 0 {
            b.ledge("lower", centre, free, h * 0.5 - thick - 0.08);
        } else {
            b.top("upper", centre, free);
        }
    }
    // The ladder, at the left side near the head.
    let (lx, end, cy) = (-x + 2.0 * r + 0.02, -(x - 2.0 * r) * 0.55, y - inset * 0.5);
    let w = (inset * 0.5).min(0.02);
    for cx in [lx, end - 0.03] {
        b.block("ladder", [cx, cy - w * 0.9, 0.0], [cx + 0.03, y, h * 0.93], mat);
        let z = h * 0.8 - thick;
        b.block("hook", [cx + 0.002, half - r, z - 0.03], [cx + 0.028, cy, z + 0.01], mat);
    }
    let rungs = (h / 0.3).clamp(3.0, 7.0) as usize;
    for i in 1..rungs {
        let z = h * 0.8 * i as f32 / rungs as f32;
        b.block("rung", [lx + 0.029, cy - w * 0.7, z - step * 0.3], [end - 0.029, cy + w * 0.7, z + step * 0.3], mat);
    }
}

/// A mattress with piped edges and buttons or quilting.
fn mattress(b: &mut Build<'_>) {
    at_least(b, [0.4, 0.2, 0.06]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let side = b.choose(&[GREY_FABRIC, WHITE_COTTON, BEIGE_FABRIC, BLUE_FABRIC]);
    let r = h * b.vary(0.2, 0.35);
    b.rounded_block("mattress", [0.004 - x, 0.004 - y, 0.0], [x - 0.004, y - 0.004, h], r, WHITE_COTTON);
    b.block("border", [r - x, -y, h * 0.28], [x - r, y, h * 0.72], side);
    b.block("border", [-x, r - y, h * 0.28 + 0.001], [x, y - r, h * 0.72 - 0.001], side);
    b.top("mattress", [0.0, 0.0, h], (x - 0.05, y - 0.05));
    let (rows, across) = (b.rng.count(3, 5), (y / 0.2).clamp(1.0, 5.0) as usize);
    for (i, j) in (0..rows).flat_map(|i| (0..across).map(move |j| (i, j))) {
        let spot = |half: f32, k: usize, of: usize| half * (2.0 * (k as f32 + 0.5) / of as f32 - 1.0);
        b.cylinder("button", [spot(x, i, rows), spot(y, j, across), h - 0.01], 0.012, 0.0095, side);
    }
}

/// An inflated bed: tubes of air under a flocked top, with a valve.
fn air_mattress(b: &mut Build<'_>) {
    at_least(b, [0.4, 0.2, 0.06]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (body, top) =
        (b.choose(&[BLUE_PLASTIC, GREY_PLASTIC, BLACK_PLASTIC]), b.choose(&[NAVY_FABRIC, BLUE_FABRIC, GREY_FABRIC]));
    let rows = if h > 0.32 { 2 } else { 1 };
    let tall = h / rows as f32;
    for i in 0..rows {
        let z = tall * i as f32;
        let mat = if i + 1 == rows { top } else { body };
        b.rounded_block("chamber", [-x, -y, z], [x, y, z + tall - 0.003], tall * 0.42, mat);
    }
    let count = ((2.0 * y - 0.2) / 0.17).clamp(1.0, 9.0) as usize;
    let pitch = (2.0 * y - 0.2).max(0.1) / count as f32;
    for i in 0..count {
        let cy = pitch * (i as f32 - (count - 1) as f32 / 2.0);
        b.rounded_block("rib", [0.1 - x, cy - pitch * 0.46, h - 0.03], [x - 0.1, cy + pitch * 0.46, h], 0.014, top);
    }
    b.rod("valve", [x * 0.9, y - 0.012, tall * 0.5], [x * 0.9, y - 0.001, tall * 0.5], 0.018, WHITE_PLASTIC);
    b.top("mattress", [0.0, 0.0, h], (x - 0.12, y - 0.11));
}
