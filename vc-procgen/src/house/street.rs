//! A house as one sees it from outside: the pavement around it, a facade with the windows of the rooms behind, shop fronts, string
//! courses between storeys, the roof.
//!
//! The facade is a skin before the outer walls of flats and landings, whose scenes need not be made to draw it. Windows of flats and
//! shops are dark panes, those of landings let light through.

use vc_shapes::Build;
use vc_shapes::material::CONCRETE;

use super::flat::Flat;
use super::measures::{HALF, Measures, SLAB, STREET_DOOR, WINDOW};
use crate::area::Area;
use crate::circulation::parts::{Maker, P, built};
use crate::city::{CityBuilding, Unit};
use crate::facade::{Facade, Level, Pane, PaneKind, Shell, Side, of_flat, of_unit, sides};
use crate::item::Item;

/// The height of the space before a house in which things belong to the street.
pub(super) const CLEAR: f32 = 3.0;
/// The width of the pavement, and how far the ground goes on unseen: farther than anybody throws.
const PAVEMENT: f32 = 4.0;
const BEYOND: f32 = 34.0;
/// A side so near to the facade is at it, metres.
const AT: f32 = 0.06;

/// The windows and doors of all units without a flat, each with its storey.
pub(super) fn fronts(house: &CityBuilding, is_flat: impl Fn(&Unit) -> bool, measures: &Measures) -> Vec<(usize, Pane)> {
    let units = (0..house.storeys).flat_map(|storey| house.units(storey)).filter(|unit| !is_flat(unit));
    units.flat_map(|unit| of_unit(&unit, |at| measures.local(at))).collect()
}

/// The pavement, and all items with it first.
pub(super) fn items(
    measures: &Measures,
    (flats, fronts): (&[Vec<Flat>], &[(usize, Pane)]),
    looks: &Facade,
    maker: Maker<'_>,
) -> (Area, Vec<Item>) {
    let levels = measures.heights.iter().map(|height| Level { floor: height.floor as f32, storey: height.storey });
    let shell = Shell { sides: sides(&measures.outline), front: 0, levels: levels.collect(), looks, recess: 0.0 };
    let front = shell.sides.iter().filter(|side| side.along.x < -0.5 && (side.from.y - measures.facade).abs() < AT);
    let ends = front.flat_map(|side| [side.from.x, (side.from + side.along * side.length).x]);
    let (x0, x1) = ends.fold((-HALF, HALF), |(low, high), x| (low.min(x), high.max(x)));
    let pavement = Area { x0, x1, y0: measures.facade, y1: measures.facade + PAVEMENT };
    let mut items = vec![built("floor", [0.0; 3], maker.style, |b| ground(b, measures, &pavement, &shell.sides))];
    for (storey, flats) in flats.iter().enumerate() {
        let others = fronts.iter().filter(|(at, _)| *at == storey).map(|(_, pane)| *pane);
        let of_flats = flats.iter().flat_map(|flat| of_flat(&flat.plan, &flat.frame));
        let panes: Vec<Pane> = of_flats.chain(others).chain(of_landing(measures, storey)).collect();
        let door = (storey == 0).then(|| door(measures));
        let wall = |side: &Side| {
            built("wall", [0.0; 3], maker.style, |b| shell.wall(b, side, storey, &panes, door.as_slice()))
        };
        items.extend(shell.sides.iter().map(wall));
    }
    items.push(built("ceiling", [0.0; 3], maker.style, |b| shell.roof(b, false)));
    (pavement, items)
}

/// The street door, whose leaf is the hall's.
fn door(measures: &Measures) -> Pane {
    let (width, height) = STREET_DOOR;
    Pane { at: (0.0, measures.facade), width, height: (0.0, height), kind: PaneKind::Door }
}

/// The windows of a landing.
fn of_landing(measures: &Measures, storey: usize) -> impl Iterator<Item = Pane> {
    let [half, sill, head] = WINDOW;
    let lobby = (storey > 0).then_some((0.0, measures.facade));
    let corridor = measures.corridor_windows().into_iter().map(|x| (x, 0.0));
    let pane = move |at| Pane { at, width: 2.0 * half, height: (sill, head), kind: PaneKind::Landing };
    corridor.chain(lobby).map(pane)
}

/// The pavement around the house, and unseen ground under all.
fn ground(b: &mut Build<'_>, measures: &Measures, pavement: &Area, sides: &[Side]) {
    for (side, [before, after]) in sides.iter().zip(beside(sides)) {
        let ends = [(0.0, before.out()), (side.length, after.out())].map(|(at, other)| {
            let corner = side.from + side.along * at;
            let out = (side.out() + other) / (1.0 + side.out().dot(&other)).max(0.2);
            [corner, corner + out * PAVEMENT]
        });
        let corners = ends.as_flattened().iter().flat_map(|at| [-SLAB, 0.0].map(|z| [at.x, at.y, z]));
        b.hull("pavement", &corners.collect::<Vec<P>>(), CONCRETE);
    }
    let ((x, y), (width, depth)) = (pavement.centre(), pavement.size());
    b.top("pavement", [x, y, 0.0], (width / 2.0, depth / 2.0));
    let all = measures.outline.iter().map(|&(x, y)| Area { x0: x, y0: y, x1: x, y1: y });
    let all = all.reduce(Area::around_both).unwrap_or_default();
    let Area { x0, y0, x1, y1 } = all.grown(BEYOND);
    b.collision_only(|b| b.block("ground", [x0, y0, -2.0 * SLAB], [x1, y1, -SLAB], CONCRETE));
}

/// The sides before and after each.
fn beside(sides: &[Side]) -> impl Iterator<Item = [Side; 2]> + '_ {
    (0..sides.len()).map(|at| [sides[(at + sides.len() - 1) % sides.len()], sides[(at + 1) % sides.len()]])
}
