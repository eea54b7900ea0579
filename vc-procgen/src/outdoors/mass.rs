//! Buildings from outside.

use vc_graph::portable::Portable;
use vc_graph::space::RegionFrame;

use super::{Outdoors, Place};
use crate::circulation::parts::built;
use crate::city::{Beyond, BuildingType, Wing};
use crate::facade::{Facade, Level, Pane, PaneKind, Shell, of_flat, of_unit, sides};
use crate::item::Item;

/// Windows of buildings that are farther lie flat on the wall, metres: a reveal has one pixel there.
const NEAR: f64 = 60.0;
/// How deep windows lie in the wall, metres.
const RECESS: f32 = 0.12;
/// Doors of buildings: width and height, and those of halls; windows over them: width, sill, head.
const DOOR: (f32, f32) = (1.2, 2.5);
const WIDE_DOOR: (f32, f32) = (2.4, 2.7);
const LANDING: [f32; 3] = [1.4, 0.9, 2.1];
/// The depth of walls below the ground, metres.
const BELOW: f32 = 0.4;

/// A building: one thing for each of its wings.
pub(super) fn items(outdoors: &Outdoors<'_>, place: &Place, number: usize) -> Vec<Item> {
    let house = &outdoors.city.buildings()[number];
    let looks = Facade::of(outdoors.city, number);
    let corners = || house.wings.iter().flat_map(|wing| wing.plan.corners());
    let away = house.wings.iter().map(|wing| wing.plan.distance(&place.at)).fold(f64::INFINITY, f64::min);
    let is_near = away < NEAR;
    let anchor = house.doors().first().map(|door| door.at).or_else(|| corners().next().copied()).unwrap_or(place.at);
    let own = Place { at: anchor, reach: place.reach };
    let panes = panes(outdoors, &own, number, is_near);
    let wing = |wing: &Wing| {
        let outline: Vec<(f32, f32)> = wing.plan.corners().iter().map(|at| own.local(at)).collect();
        let front = wing.plan.sides().position(|(.., beyond)| matches!(beyond, Beyond::Street(_))).unwrap_or(0);
        let floor = |storey: usize| (0..storey).map(|below| house.storey_height(below)).sum::<f64>() as f32;
        let level = |storey| Level { floor: floor(storey), storey: house.storey_height(storey) as f32 };
        let levels: Vec<Level> = (wing.from..wing.to).map(level).collect();
        let shell = Shell { sides: sides(&outline), front, levels, looks: &looks, recess: RECESS };
        let (x, y) = place.local(&anchor);
        built("building", [x, y, 0.0], &outdoors.style, |b| {
            for (level, storey) in (wing.from..wing.to).enumerate() {
                let here: Vec<Pane> = panes.iter().filter(|(at, _)| *at == storey).map(|(_, pane)| *pane).collect();
                for side in &shell.sides {
                    if is_near {
                        shell.wall(b, side, level, &here, &[]);
                    } else {
                        shell.plain_wall(b, side, level, &here);
                    }
                }
            }
            shell.base(b, BELOW);
            shell.roof(b, house.kind == BuildingType::Row);
        })
    };
    house.wings.iter().map(wing).collect()
}

/// All windows and doors of a building, each with its storey.
fn panes(outdoors: &Outdoors<'_>, own: &Place, number: usize, is_near: bool) -> Vec<(usize, Pane)> {
    let city = outdoors.city;
    let house = &city.buildings()[number];
    let mut panes: Vec<(usize, Pane)> = Vec::new();
    for unit in (0..house.storeys).flat_map(|storey| house.units(storey)) {
        match is_near.then(|| city.flat(number, &unit)).flatten() {
            Some(flat) => {
                let (x, y) = own.local(&flat.at);
                let heading = flat.along.y.angle_to(flat.along.x);
                let frame = RegionFrame::new([f64::from(x), f64::from(y), 0.0], heading);
                panes.extend(of_flat(&flat.plan, &frame).map(|pane| (unit.storey, pane)));
            }
            None => panes.extend(of_unit(&unit, |at| own.local(at))),
        }
    }
    let (width, height) = if house.kind == BuildingType::Hall { WIDE_DOOR } else { DOOR };
    for door in house.doors() {
        let at = own.local(&door.at);
        panes.push((0, Pane { at, width, height: (0.0, height), kind: PaneKind::Door }));
        if !house.kind.is_whole() {
            let [width, sill, head] = LANDING;
            let landing = Pane { at, width, height: (sill, head), kind: PaneKind::Landing };
            panes.extend((1..house.storeys).map(|storey| (storey, landing)));
        }
    }
    panes
}
