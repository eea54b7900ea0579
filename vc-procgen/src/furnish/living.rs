//! Living rooms: seats facing the television, a dining area, shelves.

use nalgebra::Vector3;
use vc_shapes::object::Object;

use super::Furnisher;
use super::place::{Need, Spot};
use super::space::Solid;
use crate::area::{Area, Facing};
use crate::draft::Draft;
use crate::error::SpecificationError;
use crate::item::Support;

pub(super) fn furnish(s: &mut Furnisher<'_>, open_kitchen: bool) -> Result<(), SpecificationError> {
    sitting(s)?;
    if open_kitchen || s.space.square_metres > 15.0 {
        dining(s, if s.space.square_metres > 24.0 { 6 } else { 4 });
    }
    if s.rng.chance(0.75) {
        super::bedroom::bookcase(s);
    }
    if s.rng.chance(0.5) && s.space.square_metres > 20.0 {
        let width = s.rng.between(1.2, 1.8);
        s.first_against("sideboard", &[[0.42, width, 0.8], [0.4, 1.2, 0.8]], Need::front(0.6), |_, _| 0.0);
    }
    if s.rng.chance(0.6) {
        s.first_against("armchair", &[[0.82, 0.8, 0.85]], Need::front(0.4), |_, spot| (0.8 - spot.corner).max(0.0));
    }
    table(s)?;
    floor_lamp(s);
    super::other::plant(s, 0.8);
    super::other::plant(s, 0.4);
    Ok(())
}

/// Furnishes a studio: bed, kitchen, table, and a sofa if it fits.
pub(super) fn furnish_studio(s: &mut Furnisher<'_>) -> Result<(), SpecificationError> {
    super::kitchen::furnish(s)?;
    super::bedroom::furnish(s)?;
    if sitting(s).is_err() {
        let chair = s.first_against("armchair", &[[0.8, 0.75, 0.85], [0.7, 0.65, 0.8]], Need::front(0.4), |_, _| 0.0);
        let chair = chair.ok_or_else(|| s.missing("seat"))?;
        s.item(chair).required = true;
        let table =
            s.first_against("side_table", &[[0.45, 0.45, 0.52], [0.38, 0.38, 0.5]], Need::default(), |_, _| 0.0);
        let table = table.ok_or_else(|| s.missing("table"))?;
        s.item(table).required = true;
    }
    dining(s, 2);
    table(s)?;
    super::other::plant(s, 0.5);
    Ok(())
}

/// Ensures that there is a table: a small one if none has been placed yet.
fn table(s: &mut Furnisher<'_>) -> Result<(), SpecificationError> {
    let tables = ["coffee_table", "side_table", "dining_table"];
    if let Some(at) = s.items.iter().position(|i| tables.contains(&i.object.class)) {
        s.items[at].required = true;
        return Ok(());
    }
    let table = s.first_against("side_table", &[[0.45, 0.45, 0.52], [0.36, 0.36, 0.5]], Need::default(), |_, _| 0.0);
    let table = table.ok_or_else(|| s.missing("table"))?;
    s.item(table).required = true;
    Ok(())
}

/// Places a sofa facing a television stand across a coffee table.
fn sitting(s: &mut Furnisher<'_>) -> Result<(), SpecificationError> {
    let square = s.space.square_metres;
    let widths: &[f32] = if square > 22.0 { &[2.3, 2.0, 1.7, 1.5] } else { &[1.9, 1.6, 1.4] };
    let depth = s.rng.between(0.86, 0.96);
    for &width in widths {
        let Some(sofa) = s.make("sofa", [depth, width, 0.82]) else { break };
        let stand_width = s.rng.between(1.2, 1.8).min(width);
        let Some(stand) = s.make("tv_stand", [0.4, stand_width, 0.5]) else { break };
        if group(s, &sofa, &stand).is_some() {
            return Ok(());
        }
    }
    // If the stand cannot face the sofa, each is placed where it fits.
    for width in [1.8, 1.5, 1.35] {
        let Some(sofa) = s.make("sofa", [0.86, width, 0.8]) else { break };
        if let Some(index) = s.against(&sofa, Need::front(0.5), |_, _| 0.0) {
            s.item(index).required = true;
            s.first_against("tv_stand", &[[0.38, 1.0, 0.5]], Need::front(0.4), |_, _| 0.0);
            let table =
                s.first_against("side_table", &[[0.42, 0.42, 0.5], [0.36, 0.36, 0.5]], Need::default(), |_, _| 0.0);
            let table = table.ok_or_else(|| s.missing("table"))?;
            s.item(table).required = true;
            return Ok(());
        }
    }
    Err(s.missing("sofa"))
}

/// Places the stand at a wall and the sofa opposite, against its own wall or free in the room.
fn group(s: &mut Furnisher<'_>, sofa: &Draft, stand: &Draft) -> Option<usize> {
    let need = Need::front(0.5);
    let mut spots: Vec<Spot> = s.spots(stand, need);
    spots.retain(|spot| spot.sill.is_none());
    s.rng.shuffle(&mut spots);
    let mut best: Option<(f32, Spot, (f32, f32))> = None;
    for spot in spots.into_iter().take(24) {
        for distance in [1.9, 2.3, 2.7, 3.1, 3.5] {
            let Some((centre, value)) = sofa_place(s, sofa, &spot, distance) else { continue };
            let seat = Furnisher::around(centre, sofa.size(), spot.facing);
            let better = best.as_ref().is_none_or(|(b, ..)| value > *b);
            if better && s.space.walk.stays_open(&[spot.area, seat]) {
                best = Some((value, spot, centre));
            }
        }
    }
    let (_, spot, centre) = best?;
    let index = s.settle(stand, spot.area, spot.facing, need);
    s.item(index).required = true;
    let seat = s.at(sofa, centre, spot.facing.turned(2), Need::default())?;
    s.item(seat).required = true;
    let (sofa_area, facing) = (s.item(seat).area(), spot.facing.turned(2));
    let between = gap(&spot.area, &sofa_area, facing);
    coffee_table(s, &sofa_area, facing, between);
    beside(s, &sofa_area, facing);
    Some(seat)
}

/// The free depth between two areas that face each other.
fn gap(a: &Area, b: &Area, facing: Facing) -> f32 {
    if facing.is_along_x() { (b.x0 - a.x1).max(a.x0 - b.x1) } else { (b.y0 - a.y1).max(a.y0 - b.y1) }
}

/// The place of a sofa that faces a stand at a distance, with its score.
fn sofa_place(s: &Furnisher<'_>, sofa: &Draft, stand: &Spot, distance: f32) -> Option<((f32, f32), f32)> {
    let size = sofa.size();
    let (dx, dy) = stand.facing.step();
    let (sx, sy) = stand.area.centre();
    let (half_stand, half_sofa) = (stand.area.size(), size.x / 2.0);
    let half_stand = if stand.facing.is_along_x() { half_stand.0 } else { half_stand.1 } / 2.0;
    let reach = half_stand + distance + half_sofa;
    let centre = (sx + dx * reach, sy + dy * reach);
    let area = Furnisher::around(centre, size, stand.facing);
    let facing = stand.facing.turned(2);
    let view = facing.before(&area, distance);
    if !s.fits(area, 0.0, size.z, facing, Need::default()) || !s.space.is_clear(&view) {
        return None;
    }
    // Behind the sofa there must be a wall close by, or space to walk.
    let behind = facing.turned(2).before(&area, 0.8);
    let free = s.space.is_clear(&behind);
    let wall = behind_wall(s, &area, facing);
    match (free, wall) {
        (_, true) => Some((centre, 1.0 - 0.2 * (distance - 2.4).abs())),
        (true, false) => Some((centre, 0.3 - 0.2 * (distance - 2.4).abs())),
        _ => None,
    }
}

/// Whether a wall is within 25 cm behind an area that faces a direction.
fn behind_wall(s: &Furnisher<'_>, area: &Area, facing: Facing) -> bool {
    let probe = facing.turned(2).before(area, 0.25);
    !s.space.is_floor(&probe) && s.space.is_floor(&facing.turned(2).before(area, 0.015))
}

/// Places a table in front of the sofa, sometimes on a rug.
fn coffee_table(s: &mut Furnisher<'_>, sofa: &Area, facing: Facing, gap: f32) {
    let width = if facing.is_along_x() { sofa.size().1 } else { sofa.size().0 };
    let depth = (gap - 1.05).clamp(0.4, 0.65);
    let Some(table) = s.make("coffee_table", [depth, (width * 0.6).clamp(0.6, 1.2), 0.42]) else { return };
    let rug = s.rng.chance(0.6).then(|| s.make("rug", [(gap - 0.1).clamp(0.8, 2.0), width * 0.95, 0.012])).flatten();
    let size = table.size();
    let off = s.rng.between(0.36, 0.44);
    let before = facing.before(sofa, off * 2.0 + size.x);
    let mut z = 0.0;
    let mut support = Support::Floor;
    if let Some(rug) = rug {
        let deep = rug.size().x;
        let spot = facing.before(sofa, deep + 0.06);
        let (dx, dy) = facing.step();
        let centre = (spot.centre().0 + dx * 0.03, spot.centre().1 + dy * 0.03);
        let flat = rug.size();
        let solid = Solid { area: Furnisher::around(centre, flat, facing), low: 0.0, high: flat.z };
        let swing = s.space.ways.iter().any(|w| w.overlaps(&solid.area));
        if s.space.is_floor(&solid.area) && s.space.is_empty(&solid) && !swing {
            let index = s.add(&rug, centre, 0.0, facing, Support::Floor);
            let rug = s.real(index);
            let flat = rug.size();
            let under = solid.area.holds(&Area::around(
                before.centre().0,
                before.centre().1,
                size.x.max(size.y) / 2.0,
                size.x.max(size.y) / 2.0,
            ));
            if under {
                z = flat.z;
                support = surface_of(&rug).map_or(Support::Floor, |surface| Support::On(index, surface));
            }
        }
    }
    let centre = before.centre();
    let solid = Solid { area: Furnisher::around(centre, size, facing), low: z, high: z + size.z };
    if s.space.is_off_ways(&solid) && s.space.stays_open(&solid) {
        s.add(&table, centre, z, facing, support);
    }
}

/// The first surface of an object on which others can rest.
pub(super) fn surface_of(object: &Object) -> Option<usize> {
    object.asset.surfaces.iter().position(|s| s.hold == vc_graph::asset::Hold::On)
}

/// Places a side table next to the sofa.
fn beside(s: &mut Furnisher<'_>, sofa: &Area, facing: Facing) {
    let Some(table) = s.make("side_table", [0.45, 0.45, 0.52]) else { return };
    let size = table.size();
    let wide = size.y + 0.05;
    let sides = if s.rng.chance(0.5) { [true, false] } else { [false, true] };
    for left in sides {
        let spot = match left {
            true => facing.widened(sofa, wide + 0.02, -size_across(sofa, facing) - 0.05),
            false => facing.widened(sofa, -size_across(sofa, facing) - 0.05, wide + 0.02),
        };
        let centre = spot.centre();
        let area = Area::around(centre.0, centre.1, size.x.max(size.y) / 2.0, size.x.max(size.y) / 2.0);
        let solid = Solid { area, low: 0.0, high: size.z };
        if s.space.is_free(&solid) && s.space.stays_open(&solid) {
            s.add(&table, centre, 0.0, facing, Support::Floor);
            return;
        }
    }
}

fn size_across(area: &Area, facing: Facing) -> f32 {
    if facing.is_along_x() { area.size().1 } else { area.size().0 }
}

fn floor_lamp(s: &mut Furnisher<'_>) {
    if s.rng.chance(0.7) {
        s.first_against("floor_lamp", &[[0.4, 0.4, 1.6]], Need::default(), |_, spot| (0.5 - spot.corner).max(0.0));
    }
}

/// Places a table with chairs around it, free in the room or with one end at a wall.
pub(super) fn dining(s: &mut Furnisher<'_>, places: usize) {
    let options: &[(f32, f32, usize)] = match places {
        6 => &[(1.8, 0.9, 6), (1.6, 0.9, 6), (1.3, 0.8, 4), (0.8, 0.8, 2)],
        4 => &[(1.3, 0.8, 4), (1.2, 0.75, 4), (0.8, 0.75, 2)],
        _ => &[(0.8, 0.7, 2), (0.7, 0.6, 2)],
    };
    let class = if s.rng.chance(0.7) { "dining_chair" } else { "chair" };
    let Some(chair) = s.make(class, [0.5, 0.46, 0.88]) else { return };
    for &(length, depth, seats) in options {
        let Some(table) = s.make("dining_table", [depth, length, 0.75]) else { return };
        if dining_at(s, &table, &chair, seats) {
            return;
        }
    }
    at_wall(s, &chair);
}

/// Places a small table with its long side against a wall and chairs at the other side.
fn at_wall(s: &mut Furnisher<'_>, chair: &Draft) {
    for (depth, length) in [(0.75, 1.2), (0.65, 0.8)] {
        let Some(table) = s.make("dining_table", [depth, length, 0.75]) else { return };
        let need = Need::front(chair.size().x + 0.35);
        let Some(index) = s.against(&table, need, |_, _| 0.0) else { continue };
        let (area, facing) = (s.item(index).area(), s.item(index).facing());
        for along in [-0.26, 0.26].map(|v| v * length) {
            super::bedroom::seat(s, chair, &area, facing, along);
        }
        return;
    }
}

/// Places a table with chairs along both long sides, and with space to walk behind them.
fn dining_at(s: &mut Furnisher<'_>, table: &Draft, chair: &Draft, seats: usize) -> bool {
    let size = table.size();
    let need = chair.size().x + 0.1 + 0.25;
    let Some((centre, facing)) = table_place(s, size, need) else { return false };
    let index = s.add(table, centre, 0.0, facing, Support::Floor);
    let area = s.item(index).area();
    let per_side = seats / 2;
    for side in [facing, facing.turned(2)] {
        s.space.zones.push(side.before(&area, need));
        let step = size.y / per_side as f32;
        for i in 0..per_side {
            let along = step * (i as f32 + 0.5) - size.y / 2.0;
            super::bedroom::seat(s, chair, &area, side, along);
        }
    }
    true
}

/// The centre and facing of a table with free floor of a depth before both long sides, the farthest from doors of
/// those drawn.
fn table_place(s: &mut Furnisher<'_>, size: Vector3<f32>, need: f32) -> Option<((f32, f32), Facing)> {
    let mut best: Option<(f32, (f32, f32), Facing)> = None;
    let hull = s.space.net.iter().map(Area::from_rect).reduce(|a, b| Area {
        x0: a.x0.min(b.x0),
        y0: a.y0.min(b.y0),
        x1: a.x1.max(b.x1),
        y1: a.y1.max(b.y1),
    })?;
    for _ in 0..60 {
        let centre = (s.rng.between(hull.x0, hull.x1), s.rng.between(hull.y0, hull.y1));
        let facing = Facing(s.rng.below(2) as u8);
        let area = Furnisher::around(centre, size, facing);
        if !s.space.is_floor(&area) {
            continue;
        }
        let area = snapped(s, area, facing);
        let solid = Solid { area, low: 0.0, high: size.z };
        if !has_free_sides(s, &solid, facing, need) {
            continue;
        }
        let value = s.space.door_distance(&area).min(1.5);
        if best.as_ref().is_none_or(|(b, ..)| value > *b) && s.space.stays_open(&solid) {
            best = Some((value, area.centre(), facing));
        }
    }
    best.map(|(_, centre, facing)| (centre, facing))
}

/// Whether a table and the floor before its long sides are free, and no door or passage needs that floor.
fn has_free_sides(s: &Furnisher<'_>, table: &Solid, facing: Facing, need: f32) -> bool {
    let sides = [facing, facing.turned(2)].map(|side| side.before(&table.area, need));
    let needed = |area: &Area| s.space.zones.iter().chain(&s.space.ways).any(|zone| zone.overlaps(area));
    s.space.is_free(table) && sides.iter().all(|side| s.space.is_clear(side) && !needed(side))
}

/// Moves a table against a wall at one of its ends if it is close to it.
fn snapped(s: &Furnisher<'_>, area: Area, facing: Facing) -> Area {
    for end in [facing.turned(1), facing.turned(3)] {
        let probe = end.before(&area, 0.6);
        if !s.space.is_floor(&probe) {
            let mut moved = area;
            let (dx, dy) = end.step();
            for _ in 0..12 {
                let next = Area {
                    x0: moved.x0 + dx * 0.05,
                    x1: moved.x1 + dx * 0.05,
                    y0: moved.y0 + dy * 0.05,
                    y1: moved.y1 + dy * 0.05,
                };
                if !s.space.is_floor(&next.grown(0.02)) {
                    break;
                }
                moved = next;
            }
            return moved;
        }
    }
    area
}
