//! Bedrooms: the bed with its nightstands first, a wardrobe, then whatever else fits.

use super::Furnisher;
use super::place::{Need, Spot};
use super::space::Solid;
use crate::area::{Area, Facing};
use crate::draft::Draft;
use crate::error::SpecificationError;
use crate::item::Support;
use crate::plan::RoomKind;

pub(super) fn furnish(s: &mut Furnisher<'_>) -> Result<(), SpecificationError> {
    // In small rooms sometimes one, sometimes the other finds a place only if it comes first.
    if s.rng.chance(0.3) {
        wardrobe(s)?;
        bed(s)?;
    } else {
        bed(s)?;
        wardrobe(s)?;
    }
    if s.kind() == RoomKind::Kids {
        kids(s);
    } else {
        grown_ups(s);
    }
    Ok(())
}

fn bed(s: &mut Furnisher<'_>) -> Result<(), SpecificationError> {
    let bed = place_bed(s).ok_or_else(|| s.missing("bed"))?;
    s.item(bed).required = true;
    Ok(())
}

fn wardrobe(s: &mut Furnisher<'_>) -> Result<(), SpecificationError> {
    let widths: &[f32] =
        if s.space.square_metres > 13.0 { &[2.4, 2.0, 1.6, 1.2, 1.0, 0.8] } else { &[1.8, 1.5, 1.0, 0.8] };
    let skip = s.rng.below(2);
    let height = s.rng.between(2.0, 2.3);
    let sizes: Vec<[f32; 3]> = widths.iter().skip(skip).map(|&w| [0.6, w, height]).collect();
    let wardrobe = s.first_against("wardrobe", &sizes, Need::front(0.75), in_corner);
    let wardrobe = wardrobe.ok_or_else(|| s.missing("wardrobe"))?;
    s.item(wardrobe).required = true;
    Ok(())
}

/// Tall storage prefers corners away from windows.
pub(super) fn in_corner(s: &Furnisher<'_>, spot: &Spot) -> f32 {
    let door = s.space.door_distance(&spot.area).min(1.0);
    (0.6 - spot.corner).max(0.0) + 0.2 * door
}

/// Places the widest bed that fits, with its head against a wall without a window.
fn place_bed(s: &mut Furnisher<'_>) -> Option<usize> {
    let length = s.rng.between(2.02, 2.1);
    let height = s.rng.between(0.8, 1.15);
    let double = s.kind() == RoomKind::Bedroom;
    let wide: &[f32] = match (double, s.space.square_metres) {
        (true, a) if a > 15.0 => &[1.9, 1.7, 1.5],
        (true, a) if a > 10.5 => &[1.7, 1.5],
        (true, _) => &[1.5, 1.4],
        _ => &[],
    };
    for &width in wide {
        let object = s.make("double_bed", [length, width, height])?;
        let stand = s.make("nightstand", [0.42, 0.48, 0.55]);
        for (left, right) in [(0.62, 0.62), (0.55, 0.55), (0.6, 0.0), (0.0, 0.6)] {
            let need = Need { front: 0.6, left, right };
            if let Some(bed) = s.against(&object, need, bed_place) {
                night_stands(s, bed, stand.as_ref());
                return Some(bed);
            }
        }
    }
    let class = if double || s.rng.chance(0.5) { "single_bed" } else { "kids_bed" };
    let stand = s.make("nightstand", [0.38, 0.42, 0.5]);
    for width in [1.0, 0.92] {
        let object = s.make(class, [length, width, height * 0.9])?;
        for (left, right) in [(0.0, 0.6), (0.6, 0.0)] {
            let need = Need { front: 0.5, left, right };
            if let Some(bed) =
                s.against(&object, need, |s, spot| bed_place(s, spot) + (0.3 - spot.corner).max(0.0) * 3.0)
            {
                night_stands(s, bed, stand.as_ref());
                return Some(bed);
            }
        }
    }
    None
}

fn bed_place(s: &Furnisher<'_>, spot: &Spot) -> f32 {
    let window = if spot.sill.is_some() { -2.0 } else { 0.0 };
    let wall = s.space.sides[spot.side].length().min(5.0) * 0.1;
    // In the middle of its wall or in a corner, but not slightly off either.
    let middle = -0.3 * (spot.along - f32::midpoint(s.space.sides[spot.side].from, s.space.sides[spot.side].to)).abs();
    window + wall + middle + 0.5 * s.space.door_distance(&spot.area).min(1.5)
}

/// Places nightstands at the head of the bed, where there is space.
fn night_stands(s: &mut Furnisher<'_>, bed: usize, stand: Option<&Draft>) {
    let Some(stand) = stand else { return };
    let (area, facing) = (s.item(bed).area(), s.item(bed).facing());
    let size = stand.size();
    for left in [true, false] {
        let beside =
            if left { facing.widened(&area, size.y + 0.05, 0.0) } else { facing.widened(&area, 0.0, size.y + 0.05) };
        let (hx, hy) = if facing.is_along_x() { (size.x / 2.0, size.y / 2.0) } else { (size.y / 2.0, size.x / 2.0) };
        // The corner of the widened rectangle at the bed's head.
        let x = match (facing.0, left) {
            (0, _) => beside.x0 + hx,
            (2, _) => beside.x1 - hx,
            (1, true) | (3, false) => beside.x0 + hx,
            _ => beside.x1 - hx,
        };
        let y = match (facing.0, left) {
            (1, _) => beside.y0 + hy,
            (3, _) => beside.y1 - hy,
            (0, true) | (2, false) => beside.y1 - hy,
            _ => beside.y0 + hy,
        };
        // It may stand in the bed's own zone: people get up beyond it.
        let spot = Area::around(x, y, hx, hy);
        let solid = Solid { area: spot, low: 0.0, high: size.z };
        if s.space.is_off_ways(&solid) && s.space.stays_open(&solid) {
            s.add(stand, (x, y), 0.0, facing, Support::Floor);
        }
    }
}

fn grown_ups(s: &mut Furnisher<'_>) {
    let width = s.rng.between(0.8, 1.4);
    if s.rng.chance(0.6) {
        s.first_against("dresser", &[[0.46, width, 0.85], [0.45, 0.8, 0.8]], Need::front(0.75), |_, _| 0.0);
    }
    if s.rng.chance(0.35) {
        desk(s, 1.1);
    }
    if s.rng.chance(0.4) && s.space.square_metres > 14.0 {
        s.first_against("armchair", &[[0.8, 0.78, 0.85]], Need::front(0.4), |_, spot| (0.6 - spot.corner).max(0.0));
    }
    if s.rng.chance(0.3) {
        bookcase(s);
    }
    if s.rng.chance(0.25) {
        s.first_against("standing_mirror", &[[0.35, 0.5, 1.6]], Need::front(0.5), |_, _| 0.0);
    }
    super::other::plant(s, 0.3);
    super::other::basket(s, "laundry_basket", 0.5);
}

fn kids(s: &mut Furnisher<'_>) {
    desk(s, 1.0);
    if s.rng.chance(0.8) {
        s.first_against("low_bookcase", &[[0.3, 1.0, 0.85], [0.3, 0.7, 0.85]], Need::front(0.5), |_, _| 0.0);
    } else {
        bookcase(s);
    }
    if s.rng.chance(0.8) {
        s.first_against("toy_box", &[[0.42, 0.8, 0.45], [0.4, 0.6, 0.42]], Need::front(0.4), |_, _| 0.0);
    }
    if s.rng.chance(0.4) {
        s.first_against("dresser", &[[0.45, 0.8, 0.8]], Need::front(0.7), |_, _| 0.0);
    }
    super::other::basket(s, "wastebasket", 0.5);
}

pub(super) fn bookcase(s: &mut Furnisher<'_>) -> Option<usize> {
    let (width, height) = (s.rng.between(0.6, 1.2), s.rng.between(1.6, 2.1));
    s.first_against("bookshelf", &[[0.3, width, height], [0.28, 0.6, height]], Need::front(0.5), in_corner)
}

/// Places a desk with its chair, near a window if possible.
pub(super) fn desk(s: &mut Furnisher<'_>, width: f32) -> Option<usize> {
    let chair_class = if s.rng.chance(0.75) { "office_chair" } else { "chair" };
    let chair = s.make(chair_class, [0.58, 0.58, 0.95])?;
    let depth = chair.size().x;
    for (w, d) in [(width + 0.4, 0.7), (width, 0.6), (1.0, 0.55)] {
        let desk = s.make("desk", [d, w, 0.74])?;
        let need = Need::front(depth + 0.35);
        let near_window = |_: &Furnisher<'_>, spot: &Spot| if spot.sill.is_some() { 0.4 } else { 0.0 };
        if let Some(index) = s.against(&desk, need, near_window) {
            let (area, facing) = (s.item(index).area(), s.item(index).facing());
            seat(s, &chair, &area, facing, 0.0);
            return Some(index);
        }
    }
    None
}

/// Places a chair in front of an area, facing it, offset along its edge.
pub(super) fn seat(s: &mut Furnisher<'_>, chair: &Draft, area: &Area, facing: Facing, along: f32) -> Option<usize> {
    let size = chair.size();
    let gap = s.rng.between(0.02, 0.08);
    let before = facing.before(area, size.x + gap);
    let (dx, dy) = facing.step();
    let (cx, cy) = before.centre();
    let centre = (cx + dx * gap / 2.0 - dy * along, cy + dy * gap / 2.0 + dx * along);
    let spot = Furnisher::around(centre, size, facing);
    let solid = Solid { area: spot, low: 0.0, high: size.z };
    (s.space.is_off_ways(&solid) && s.space.stays_open(&solid))
        .then(|| s.add(chair, centre, 0.0, facing.turned(2), Support::Floor))
}
