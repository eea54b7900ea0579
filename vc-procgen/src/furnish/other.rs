//! Halls, studies, laundries, stores and balconies; plants and baskets everywhere.

use super::Furnisher;
use super::bedroom::{bookcase, desk, in_corner};
use super::place::Need;
use super::space::Solid;
use crate::draft::Draft;
use crate::error::SpecificationError;
use crate::plan::RoomKind;

pub(super) fn furnish(s: &mut Furnisher<'_>) -> Result<(), SpecificationError> {
    match s.kind() {
        RoomKind::Hall => hall(s),
        RoomKind::Study => return study(s),
        RoomKind::Laundry => return laundry(s),
        RoomKind::Storage => return storage(s),
        _ => balcony(s),
    }
    Ok(())
}

/// Furnishes a hall with a shoe cabinet, coat hooks and a mirror, as long as one can pass.
fn hall(s: &mut Furnisher<'_>) {
    let pass = Need::front(0.72);
    let width = s.rng.between(0.6, 1.0);
    s.first_against("shoe_cabinet", &[[0.3, width, 0.9], [0.2, 0.7, 0.9]], pass, |_, _| 0.0);
    hooks(s);
    if s.rng.chance(0.5) {
        let mirror = s.make("mirror", [0.03, 0.45, 1.1]);
        hang_somewhere(s, mirror, 0.7);
    }
    if s.rng.chance(0.3) {
        s.first_against("console_table", &[[0.3, 0.9, 0.8]], pass, |_, _| 0.0);
    }
    if s.rng.chance(0.3) {
        s.first_against("umbrella_stand", &[[0.22, 0.22, 0.5]], Need::front(0.7), |_, spot| {
            (0.3 - spot.corner).max(0.0)
        });
    }
}

/// Hangs a coat rack where there is space for the coats and to pass them.
fn hooks(s: &mut Furnisher<'_>) {
    let Some(rack) = s.make("wall_hook_rack", [0.08, 0.6, 0.15]) else { return };
    let width = rack.size().y;
    for _ in 0..24 {
        let side = s.rng.below(s.space.sides.len());
        let Some(wall) = s.space.sides.get(side) else { return };
        let along = s.rng.between(wall.from, wall.to);
        let facing = wall.facing;
        let coats = facing.area(wall.point(along, 0.0), 0.3, width);
        let solid = Solid { area: coats, low: 0.0, high: 1.7 };
        let pass = facing.before(&coats, 0.72);
        let free = s.space.is_free(&solid) && s.space.is_clear(&pass) && s.space.stays_open(&solid);
        if free && s.hang(&rack, side, along, 1.65).is_some() {
            s.space.walk.put(&coats, (solid.low, solid.high), false);
            s.space.solids.push(solid);
            s.space.zones.push(pass);
            return;
        }
    }
}

fn study(s: &mut Furnisher<'_>) -> Result<(), SpecificationError> {
    let index = desk(s, 1.2).ok_or_else(|| s.missing("desk"))?;
    s.item(index).required = true;
    bookcase(s);
    if s.rng.chance(0.6) {
        bookcase(s);
    }
    if s.rng.chance(0.4) {
        s.first_against("filing_cabinet", &[[0.5, 0.42, 0.7]], Need::front(0.6), in_corner);
    }
    if s.rng.chance(0.4) {
        s.first_against("armchair", &[[0.8, 0.78, 0.85]], Need::front(0.4), |_, spot| (0.5 - spot.corner).max(0.0));
    }
    basket(s, "wastebasket", 0.9);
    plant(s, 0.5);
    Ok(())
}

fn laundry(s: &mut Furnisher<'_>) -> Result<(), SpecificationError> {
    let washer =
        s.first_against("washing_machine", &[[0.6, 0.6, 0.85], [0.5, 0.58, 0.85]], Need::front(0.55), in_corner);
    let washer = washer.ok_or_else(|| s.missing("washing machine"))?;
    s.item(washer).required = true;
    if s.rng.chance(0.7) {
        s.first_against("dryer", &[[0.6, 0.6, 0.85]], Need::front(0.55), in_corner);
    }
    s.first_against("shelf", &[[0.32, 0.8, 1.7], [0.3, 0.5, 1.5]], Need::front(0.5), in_corner);
    basket(s, "laundry_hamper", 0.8);
    if s.rng.chance(0.5) {
        s.first_against("drying_rack", &[[0.5, 0.9, 0.95]], Need::front(0.4), |_, _| 0.0);
    }
    Ok(())
}

fn storage(s: &mut Furnisher<'_>) -> Result<(), SpecificationError> {
    let sizes = [[0.4, 1.0, 1.8], [0.35, 0.8, 1.7], [0.3, 0.6, 1.6], [0.28, 0.5, 1.5]];
    let shelf = s.first_against("storage_shelf", &sizes, Need::front(0.5), in_corner);
    let shelf = shelf.ok_or_else(|| s.missing("shelf"))?;
    s.item(shelf).required = true;
    s.first_against("storage_shelf", &sizes, Need::front(0.5), in_corner);
    if s.rng.chance(0.5) {
        s.first_against("vacuum_cleaner", &[[0.3, 0.3, 1.1]], Need::front(0.3), in_corner);
    }
    Ok(())
}

fn balcony(s: &mut Furnisher<'_>) {
    if s.rng.chance(0.7) {
        s.first_against("bistro_table", &[[0.55, 0.55, 0.72]], Need::default(), in_corner);
        for _ in 0..2 {
            s.first_against("garden_chair", &[[0.55, 0.52, 0.85]], Need::front(0.25), |_, _| 0.0);
        }
    }
    for _ in 0..3 {
        if s.rng.chance(0.6) {
            s.first_against("planter", &[[0.3, 0.6, 0.4], [0.25, 0.3, 0.35]], Need::default(), in_corner);
        }
    }
}

/// Places a plant in a corner or by a window, with a probability.
pub(super) fn plant(s: &mut Furnisher<'_>, chance: f32) {
    if s.rng.chance(chance) {
        let (side, height) = (s.rng.between(0.3, 0.5), s.rng.between(0.6, 1.5));
        s.first_against("houseplant", &[[side, side, height]], Need::default(), |_, spot| {
            (0.5 - spot.corner).max(0.0) + if spot.sill.is_some() { 0.3 } else { 0.0 }
        });
    }
}

/// Places a small basket or bin in a corner, with a probability.
pub(super) fn basket(s: &mut Furnisher<'_>, class: &str, chance: f32) {
    if s.rng.chance(chance) {
        s.first_against(class, &[[0.36, 0.4, 0.5], [0.28, 0.28, 0.35]], Need::front(0.35), |_, spot| {
            (0.4 - spot.corner).max(0.0)
        });
    }
}

/// Hangs an object on a wall at a height, at the first free one of several random positions.
pub(super) fn hang_somewhere(s: &mut Furnisher<'_>, object: Option<Draft>, z: f32) -> Option<usize> {
    let object = object?;
    (0..24).find_map(|_| {
        let side = s.rng.below(s.space.sides.len());
        let wall = s.space.sides.get(side)?;
        let along = s.rng.between(wall.from, wall.to);
        s.hang(&object, side, along, z)
    })
}
