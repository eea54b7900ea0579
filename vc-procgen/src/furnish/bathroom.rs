//! Bathrooms: shower or bath, toilet and basin, then whatever else fits.

use super::Furnisher;
use super::place::{Need, Spot};
use super::space::Solid;
use crate::area::Area;
use crate::draft::Draft;
use crate::error::SpecificationError;
use crate::item::Support;
use crate::plan::RoomKind;

/// The number of attempts to place the fittings.
const TRIES: usize = 40;

pub(super) fn furnish(s: &mut Furnisher<'_>) -> Result<(), SpecificationError> {
    let bath = s.kind() == RoomKind::Bathroom;
    let mut fittings: Vec<Vec<(Draft, Need)>> = Vec::new();
    if bath {
        let long = s.space.square_metres > 4.3 && s.rng.chance(0.5);
        let mut wet = Vec::new();
        if long {
            wet.extend(s.make("bathtub", [0.75, 1.7, 0.56]).map(|o| (o, Need::front(0.55))));
            wet.extend(s.make("bathtub", [0.7, 1.5, 0.56]).map(|o| (o, Need::front(0.55))));
        }
        for side in [0.9, 0.8, 0.75] {
            wet.extend(s.make("shower", [side, side, 2.0]).map(|o| (o, Need::front(0.5))));
        }
        fittings.push(wet);
    }
    let toilet = s.make("toilet", [0.66, 0.38, 0.8]);
    let sides = Need { front: 0.5, left: 0.12, right: 0.12 };
    fittings.push(toilet.into_iter().map(|o| (o, sides)).collect());
    let mut basins = Vec::new();
    if s.space.square_metres > 3.6 && s.rng.chance(0.6) {
        basins.extend(s.make("bathroom_vanity", [0.46, 0.8, 0.82]).map(|o| (o, Need::front(0.5))));
    }
    basins.extend(s.make("washbasin", [0.45, 0.55, 0.85]).map(|o| (o, Need::front(0.5))));
    basins.extend(s.make("washbasin", [0.36, 0.42, 0.85]).map(|o| (o, Need::front(0.45))));
    fittings.push(basins);
    let placed = place_all(s, &fittings)
        .ok_or_else(|| s.missing(if bath { "bath, toilet and basin" } else { "toilet and basin" }))?;
    let basin = placed.last().copied();
    if let Some(basin) = basin {
        above_basin(s, basin);
    }
    if bath {
        extras(s);
    }
    Ok(())
}

/// Places one of each list of alternatives, retrying until all fit.
fn place_all(s: &mut Furnisher<'_>, fittings: &[Vec<(Draft, Need)>]) -> Option<Vec<usize>> {
    let (solids, zones) = (s.space.solids.len(), s.space.zones.len());
    for attempt in 0..TRIES {
        let mut spots: Vec<(Draft, Spot, Need)> = Vec::new();
        for options in fittings {
            // Later attempts begin with smaller fittings.
            let skip = (attempt * options.len() / TRIES).min(options.len().saturating_sub(1));
            let found = options.iter().skip(skip).find_map(|(object, need)| {
                let mut all = s.spots(object, *need);
                let corners = matches!(object.class, "shower" | "bathtub");
                all.retain(|spot| !corners || spot.corner < 0.03);
                s.rng.pick(&all).map(|spot| (object.clone(), *spot, *need))
            });
            let Some((object, spot, need)) = found else { break };
            s.space.solids.push(Solid { area: spot.area, low: 0.0, high: object.size().z });
            s.space.zones.extend(need.zones(&spot.area, spot.facing).into_iter().take(1));
            spots.push((object, spot, need));
        }
        s.space.solids.truncate(solids);
        s.space.zones.truncate(zones);
        let areas: Vec<Area> = spots.iter().map(|(_, spot, _)| spot.area).collect();
        if spots.len() == fittings.len() && s.space.walk.stays_open(&areas) {
            return Some(spots.into_iter().map(|(object, spot, need)| commit(s, &object, &spot, need)).collect());
        }
    }
    None
}

fn commit(s: &mut Furnisher<'_>, object: &Draft, spot: &Spot, need: Need) -> usize {
    let index = s.settle(object, spot.area, spot.facing, need);
    s.item(index).required = true;
    index
}

/// Adds a bowl on a vanity, and the mirror.
fn above_basin(s: &mut Furnisher<'_>, basin: usize) {
    let (area, facing, class, height) = {
        let item = s.item(basin);
        (item.area(), item.facing(), item.object.class, item.corners().1.z)
    };
    if class == "bathroom_vanity" {
        let object = s.real(basin);
        let bowl = s.make("washbasin", [0.36, 0.42, 0.14]);
        if let (Some(bowl), Some(surface)) = (bowl, super::living::surface_of(&object)) {
            let top = s.item(basin).pose * object.asset.surfaces[surface].centre;
            s.add(&bowl, (top.x, top.y), top.z, facing, Support::On(basin, surface));
        }
    }
    let Some(side) = super::kitchen::side_behind(s, &area, facing) else { return };
    let (cx, cy) = area.centre();
    let along = if facing.is_along_x() { cy } else { cx };
    let mirror = if s.rng.chance(0.5) {
        s.make("bathroom_mirror", [0.03, 0.55, 0.7])
    } else {
        s.make("medicine_cabinet", [0.14, 0.5, 0.6])
    };
    if let Some(mirror) = mirror {
        s.hang(&mirror, side, along, (height + 0.3).max(1.2));
    }
}

fn extras(s: &mut Furnisher<'_>) {
    let free = s.space.square_metres;
    if free > 5.0 && s.rng.chance(0.4) {
        s.first_against("washing_machine", &[[0.6, 0.6, 0.85]], Need::front(0.6), |_, _| 0.0);
    }
    if s.rng.chance(0.5) {
        s.first_against("bathroom_cabinet", &[[0.32, 0.4, 1.6], [0.3, 0.35, 0.85]], Need::front(0.45), |_, spot| {
            (0.3 - spot.corner).max(0.0)
        });
    }
    s.first_against("wastebasket", &[[0.2, 0.2, 0.26]], Need::default(), |_, spot| (0.4 - spot.corner).max(0.0));
    super::other::basket(s, "laundry_hamper", 0.4);
    let towel = s.make("towel_rack", [0.1, 0.55, 0.1]);
    super::other::hang_somewhere(s, towel, 1.2);
    let mat = s.make("bath_mat", [0.5, 0.7, 0.012]);
    bath_mat(s, mat);
}

/// Adds a mat in front of the shower or bath.
fn bath_mat(s: &mut Furnisher<'_>, mat: Option<Draft>) {
    let Some(mat) = mat else { return };
    let wet = s.items.iter().find(|i| matches!(i.object.class, "shower" | "bathtub"));
    let Some((area, facing)) = wet.map(|i| (i.area(), i.facing())) else { return };
    let size = mat.size();
    let (cx, cy) = facing.before(&area, size.x + 0.1).centre();
    let (hx, hy) = if facing.is_along_x() { (size.x, size.y) } else { (size.y, size.x) };
    let solid = Solid { area: Area::around(cx, cy, hx / 2.0, hy / 2.0), low: 0.0, high: size.z };
    let swing = s.space.ways.iter().any(|w| w.overlaps(&solid.area));
    if s.space.is_floor(&solid.area) && s.space.is_empty(&solid) && !swing {
        s.add(&mat, (cx, cy), 0.0, facing, Support::Floor);
    }
}
