//! Kitchens: fitted ones, or a run of single units along one or two walls, wall cabinets above it; a table if it fits.

use super::Furnisher;
use super::place::{Need, Spot};
use super::space::OFF_WALL;
use crate::area::{Area, Facing};
use crate::draft::Draft;
use crate::error::SpecificationError;
use crate::plan::RoomKind;

/// The depth and height of units, metres.
const DEPTH: f32 = 0.6;
const TOP: f32 = 0.9;

/// A unit of the run: its class, the widths to try, and whether the kitchen needs it.
struct Unit {
    class: &'static str,
    widths: &'static [f32],
    height: f32,
    required: bool,
}

/// The placed units: index in the list, spot and object.
type Run = Vec<(usize, Spot, Draft)>;

const fn unit(class: &'static str, widths: &'static [f32], required: bool) -> Unit {
    Unit { class, widths, height: TOP, required }
}

pub(super) fn furnish(s: &mut Furnisher<'_>) -> Result<(), SpecificationError> {
    if !s.fitted_kitchens || !super::fitted::furnish(s) {
        standing(s)?;
    }
    if s.kind() == RoomKind::Kitchen {
        if s.space.square_metres > 9.0 && s.rng.chance(0.6) {
            super::living::dining(s, 2);
        }
        s.first_against("trash_can", &[[0.3, 0.3, 0.6]], Need::default(), |_, spot| (0.4 - spot.corner).max(0.0));
    }
    Ok(())
}

/// Furnishes a kitchen with units that stand by themselves.
fn standing(s: &mut Furnisher<'_>) -> Result<(), SpecificationError> {
    let large = s.space.square_metres > 7.5 && s.kind() == RoomKind::Kitchen;
    let fridge = Unit { class: "fridge", widths: &[0.7, 0.6], height: s.rng.between(1.6, 1.95), required: true };
    let mut units =
        vec![fridge, unit("kitchen_cabinet", &[0.6, 0.45, 0.4], true), unit("kitchen_sink", &[0.8, 0.6], true)];
    if s.rng.chance(0.7) {
        units.push(unit("dishwasher", &[0.6, 0.45], false));
    }
    units.push(unit("kitchen_cabinet", &[0.8, 0.6, 0.45], true));
    units.push(unit("stove", &[0.6, 0.5], true));
    units.push(unit("kitchen_cabinet", &[0.6, 0.4, 0.3], large));
    if large {
        units.push(unit("kitchen_cabinet", &[0.8, 0.6], false));
        if s.rng.chance(0.2) {
            units.push(unit("washing_machine", &[0.6], false));
        }
        units.push(unit("kitchen_cabinet", &[0.9, 0.6], false));
    }
    if s.rng.chance(0.5) {
        // The same run in reverse order.
        units[1..].reverse();
    }
    let run = place_any(s, units)?;
    upper(s, &run);
    Ok(())
}

/// Places the whole run; if that fails, only the required units; if that fails, these in their
/// narrowest widths.
fn place_any(s: &mut Furnisher<'_>, mut units: Vec<Unit>) -> Result<Vec<usize>, SpecificationError> {
    if let Ok(run) = place_run(s, &units) {
        return Ok(run);
    }
    units.retain(|u| u.required);
    if let Ok(run) = place_run(s, &units) {
        return Ok(run);
    }
    let narrow = [
        ("fridge", &[0.6][..], 1.7),
        ("kitchen_sink", &[0.6], TOP),
        ("kitchen_cabinet", &[0.4, 0.3], TOP),
        ("stove", &[0.6, 0.5], TOP),
    ];
    let units: Vec<Unit> =
        narrow.into_iter().map(|(class, widths, height)| Unit { class, widths, height, required: true }).collect();
    place_run(s, &units)
}

/// Places the units side by side: along the wall that accommodates most of them, the rest along
/// others.
fn place_run(s: &mut Furnisher<'_>, units: &[Unit]) -> Result<Vec<usize>, SpecificationError> {
    let mut best: Option<Run> = None;
    let tries = s.space.sides.len() * 2;
    // Made once, because every attempt uses the same objects.
    let made: Vec<Vec<Draft>> = units
        .iter()
        .map(|u| u.widths.iter().filter_map(|&width| s.make(u.class, [DEPTH, width, u.height])).collect())
        .collect();
    for attempt in 0..tries {
        let beaten = best.as_ref().map_or(0, Run::len);
        if beaten == units.len() {
            break;
        }
        let Some(run) = lay_run(s, units, &made, attempt / 2, attempt % 2 == 1, beaten) else { continue };
        let areas: Vec<_> = run.iter().map(|(_, spot, _)| spot.area).collect();
        if s.space.walk.stays_open(&areas) {
            best = Some(run);
        }
    }
    let run = best.ok_or_else(|| s.missing("kitchen run"))?;
    let mut indices = Vec::new();
    for (_, spot, object) in run {
        let index = s.settle(&object, spot.area, spot.facing, Need::front(0.9));
        s.item(index).required = true;
        indices.push(index);
    }
    Ok(indices)
}

/// Lays the units out from one end of a wall, temporarily reserving their space in the room; `None`
/// as soon as a required unit has no place or the run cannot have more than `beaten` units.
fn lay_run(
    s: &mut Furnisher<'_>,
    units: &[Unit],
    made: &[Vec<Draft>],
    first: usize,
    backwards: bool,
    beaten: usize,
) -> Option<Run> {
    let (solids, zones) = (s.space.solids.len(), s.space.zones.len());
    let mut run = Run::new();
    let mut order: Vec<usize> = (0..s.space.sides.len()).collect();
    order.sort_by(|&a, &b| s.space.sides[b].length().total_cmp(&s.space.sides[a].length()));
    order.retain(|&side| side != first);
    order.insert(0, first);
    let (mut wall, mut reached) = (0, 0.0);
    let mut wanting = false;
    for (index, unit) in units.iter().enumerate() {
        let placed = made[index].iter().find_map(|object| {
            order.iter().enumerate().skip(wall).find_map(|(step, &side)| {
                let from = if step == wall { reached } else { 0.0 };
                next_spot(s, side, from, object, backwards).map(|(spot, end)| (step, end, spot, object))
            })
        });
        if let Some((step, end, spot, object)) = placed {
            (wall, reached) = (step, end);
            s.space.solids.push(super::space::Solid { area: spot.area, low: 0.0, high: object.size().z });
            s.space.zones.push(spot.facing.before(&spot.area, 0.9));
            run.push((index, spot, object.clone()));
        }
        let to_come = units.len() - index - 1;
        wanting = (placed.is_none() && unit.required) || run.len() + to_come <= beaten;
        if wanting {
            break;
        }
    }
    s.space.solids.truncate(solids);
    s.space.zones.truncate(zones);
    (!wanting).then_some(run)
}

/// The first free spot along a wall from a distance on, and its end.
fn next_spot(s: &Furnisher<'_>, side: usize, from: f32, object: &Draft, backwards: bool) -> Option<(Spot, f32)> {
    let wall = &s.space.sides[side];
    let size = object.size();
    let need = Need::front(0.9);
    let taken = s.space.taken(wall, size, need.front);
    let mut at = from.max(OFF_WALL);
    while at + size.y + OFF_WALL <= wall.length() {
        let along = if backwards { wall.to - at - size.y / 2.0 } else { wall.from + at + size.y / 2.0 };
        let (low, high) = (along - size.y / 2.0, along + size.y / 2.0);
        let area = wall.facing.area(wall.point(along, OFF_WALL), size.x, size.y);
        let sill = wall.sill(low, high);
        // A hob must not be under a window, nor an object taller than the sill.
        let window = sill.is_some_and(|v| size.z > v - 0.02 || object.class == "stove");
        let room = taken.iter().all(|&(from, to)| along <= from || along >= to);
        if room && !window && !wall.has_way(low, high) && s.fits(area, 0.0, size.z, wall.facing, need) {
            let corner = (low - wall.from).min(wall.to - high);
            return Some((Spot { side, facing: wall.facing, along, area, corner, sill }, at + size.y + 0.002));
        }
        at += 0.1;
    }
    None
}

/// Hangs wall cabinets and the hood above the run.
fn upper(s: &mut Furnisher<'_>, run: &[usize]) {
    let bottom = s.rng.between(1.42, 1.5);
    let height = (s.space.ceiling - bottom - 0.25).clamp(0.5, 0.75);
    for &index in run {
        let (area, facing, class) = {
            let item = s.item(index);
            (item.area(), item.facing(), item.object.class)
        };
        let width = if facing.is_along_x() { area.size().1 } else { area.size().0 };
        let made = match class {
            "fridge" | "washing_machine" => None,
            "stove" => s.make("extractor", [0.45, width.min(0.6), 0.55]).map(|o| (o, 1.6)),
            _ => s.make("kitchen_wall_cabinet", [0.35, width, height]).map(|o| (o, bottom)),
        };
        let Some((object, z)) = made else { continue };
        let Some(side) = side_behind(s, &area, facing) else { continue };
        let (cx, cy) = area.centre();
        let along = if facing.is_along_x() { cy } else { cx };
        s.hang(&object, side, along, z);
    }
}

/// The wall that an area stands against.
pub(super) fn side_behind(s: &Furnisher<'_>, area: &Area, facing: Facing) -> Option<usize> {
    let (cx, cy) = area.centre();
    let along = if facing.is_along_x() { cy } else { cx };
    let back = facing.turned(2).before(area, 0.0).centre();
    s.space.sides.iter().position(|w| {
        let at = if facing.is_along_x() { back.0 } else { back.1 };
        w.facing == facing && along > w.from && along < w.to && (w.at - at).abs() < 0.1
    })
}
