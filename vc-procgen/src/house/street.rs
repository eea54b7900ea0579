//! A house as one sees it from outside: the pavement around it, a facade with the windows of the rooms behind, shop fronts, string
//! courses between storeys, the roof.
//!
//! The facade is a skin before the outer walls of flats and landings, whose scenes need not be made to draw it. Windows of flats and
//! shops are dark panes, those of landings let light through.

use nalgebra::{Point2, Point3, Vector2};
use vc_shapes::Build;
use vc_shapes::material::{BLACK_GLASS, FROSTED_GLASS, MaterialId};

use super::Facade;
use super::flat::Flat;
use super::measures::{HALF, Measures, SLAB, STREET_DOOR, WALL, WINDOW};
use super::wall::{Panel, around};
use crate::area::Area;
use crate::circulation::parts::{Maker, P, built};
use crate::city::{CityBuilding, Unit, UnitPlace};
use crate::item::Item;
use crate::plan::{OpeningKind, metres};
use crate::reach::doorway;

/// The height of the space before a house in which things belong to the street.
pub(super) const CLEAR: f32 = 3.0;
/// The width of the pavement, and how far the ground goes on unseen: farther than anybody throws.
const PAVEMENT: f32 = 4.0;
const BEYOND: f32 = 34.0;
/// What is so near to a side is at it.
const AT: f32 = 0.06;
/// How far the skin of the facade stands out of the outer walls, string courses, with their height, and ledges.
const SKIN: f32 = 0.03;
const COURSE: (f32, f32) = (0.06, 0.14);
const LEDGE: f32 = 0.1;
/// The width of frames of windows.
const FRAME: f32 = 0.06;
/// The height of the parapet above the roof.
const PARAPET: f32 = 0.4;
/// The width and height of the doors of shops.
const SHOP_DOOR: (f32, f32) = (1.1, 2.3);

type Q = Point2<f32>;

/// A window or glass door as one sees it from outside, in the frame of the house.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Pane {
    at: (f32, f32),
    width: f32,
    height: (f32, f32),
    glass: MaterialId,
}

/// The windows and doors of a unit without interior, by the storeys on which they are.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Front {
    storey: usize,
    pane: Pane,
}

impl Front {
    /// Those of all units without a flat.
    pub(super) fn all(house: &CityBuilding, is_flat: impl Fn(&Unit) -> bool, measures: &Measures) -> Vec<Self> {
        let units = (0..house.storeys).flat_map(|storey| house.units(storey)).filter(|unit| !is_flat(unit));
        let of = |unit: Unit| {
            let door = || Pane {
                at: measures.local(&unit.door),
                width: SHOP_DOOR.0,
                height: (0.0, SHOP_DOOR.1),
                glass: BLACK_GLASS,
            };
            let door = (unit.kind.place() == UnitPlace::Shop).then(|| Self { storey: unit.storey, pane: door() });
            let windows = unit.windows.iter().map(|window| {
                let height = (window.sill as f32, (window.sill + window.size[1]) as f32);
                let pane =
                    Pane { at: measures.local(&window.at), width: window.size[0] as f32, height, glass: BLACK_GLASS };
                Self { storey: window.storey, pane }
            });
            door.into_iter().chain(windows).collect::<Vec<Self>>()
        };
        units.flat_map(of).collect()
    }
}

/// A side of the outline.
#[derive(Clone, Copy)]
struct Side {
    from: Q,
    along: Vector2<f32>,
    length: f32,
}

impl Side {
    fn out(&self) -> Vector2<f32> {
        Vector2::new(self.along.y, -self.along.x)
    }

    /// The part of it that a pane takes, if it is at it.
    fn taken(&self, pane: &Pane) -> Option<Panel> {
        let by = Q::new(pane.at.0, pane.at.1) - self.from;
        let (at, half) = (by.dot(&self.along), pane.width / 2.0);
        let is_at = by.dot(&self.out()).abs() < AT && at > half && at < self.length - half;
        is_at.then_some([(at - half, at + half), pane.height])
    }

    /// A plate of a thickness inwards from the side, which it may stand out of.
    fn plate(
        &self,
        b: &mut Build<'_>,
        [(from, to), (low, high)]: Panel,
        (out, thick): (f32, f32),
        material: MaterialId,
    ) {
        let corner = |along: f32, deep: f32, z: f32| {
            let at = self.from + self.along * along + self.out() * (out - deep);
            [at.x, at.y, z]
        };
        let ends = [from, to].map(|at| [0.0, out + thick].map(|deep| [low, high].map(|z| corner(at, deep, z))));
        b.hull("wall", ends.as_flattened().as_flattened(), material);
    }
}

fn sides(measures: &Measures) -> Vec<Side> {
    let corners: Vec<Q> = measures.outline.iter().map(|&(x, y)| Q::new(x, y)).collect();
    let ends = corners.iter().zip(corners.iter().cycle().skip(1));
    ends.map(|(a, b)| Side { from: *a, along: (b - a).normalize(), length: (b - a).norm() }).collect()
}

/// The pavement, and all items with it first.
pub(super) fn items(
    measures: &Measures,
    (flats, fronts): (&[Vec<Flat>], &[Front]),
    looks: &Facade,
    maker: Maker<'_>,
) -> (Area, Vec<Item>) {
    let sides = sides(measures);
    let front = sides.iter().filter(|side| side.along.x < -0.5 && (side.from.y - measures.facade).abs() < AT);
    let ends = front.flat_map(|side| [side.from.x, (side.from + side.along * side.length).x]);
    let (x0, x1) = ends.fold((-HALF, HALF), |(low, high), x| (low.min(x), high.max(x)));
    let pavement = Area { x0, x1, y0: measures.facade, y1: measures.facade + PAVEMENT };
    let mut items = vec![built("floor", [0.0; 3], maker.style, |b| ground(b, measures, &pavement, looks))];
    for (storey, flats) in flats.iter().enumerate() {
        let others = fronts.iter().filter(|front| front.storey == storey).map(|front| front.pane);
        let panes: Vec<Pane> =
            flats.iter().flat_map(windows).chain(others).chain(of_landing(measures, storey)).collect();
        items.extend(sides.iter().map(|side| wall(side, measures, storey, &panes, (looks, maker))));
    }
    items.push(built("wall", [0.0; 3], maker.style, |b| parapet(b, &sides, measures, looks)));
    items.push(built("ceiling", [0.0; 3], maker.style, |b| {
        let top = top(measures);
        let roof = measures.outline.iter().flat_map(|&(x, y)| [top - SLAB, top].map(|z| [x, y, z]));
        b.hull("roof", &roof.collect::<Vec<P>>(), looks.roof);
    }));
    (pavement, items)
}

/// The windows of a flat.
fn windows(flat: &Flat) -> impl Iterator<Item = Pane> + '_ {
    let windows = flat.plan.openings.iter().filter(|opening| opening.kind == OpeningKind::Window);
    windows.map(|window| {
        let hole = doorway(&flat.plan, window);
        let (middle, at) = (f32::midpoint(metres(window.from), metres(window.to)), |cells| metres(cells));
        let is_high = window.high.is_none();
        let edge = match (window.vertical, is_high) {
            (true, true) => (at(hole.x1), middle),
            (true, false) => (at(hole.x0), middle),
            (false, true) => (middle, at(hole.y1)),
            (false, false) => (middle, at(hole.y0)),
        };
        let place = flat.frame.point(&Point3::new(f64::from(edge.0), f64::from(edge.1), 0.0));
        Pane {
            at: (place.x as f32, place.y as f32),
            width: metres(window.width()),
            height: (window.sill, window.head),
            glass: BLACK_GLASS,
        }
    })
}

/// The windows of a landing.
fn of_landing(measures: &Measures, storey: usize) -> impl Iterator<Item = Pane> {
    let [half, sill, head] = WINDOW;
    let lobby = (storey > 0).then_some((0.0, measures.facade));
    let corridor = measures.corridor_windows().into_iter().map(|x| (x, 0.0));
    corridor.chain(lobby).map(move |at| Pane { at, width: 2.0 * half, height: (sill, head), glass: FROSTED_GLASS })
}

fn top(measures: &Measures) -> f32 {
    measures.heights.last().map_or(0.0, |last| last.floor as f32 + last.storey)
}

/// The pavement around the house, and unseen ground under all.
fn ground(b: &mut Build<'_>, measures: &Measures, pavement: &Area, looks: &Facade) {
    let sides = sides(measures);
    for (side, [before, after]) in sides.iter().zip(beside(&sides)) {
        let ends = [(0.0, before.out()), (side.length, after.out())].map(|(at, other)| {
            let corner = side.from + side.along * at;
            let out = (side.out() + other) / (1.0 + side.out().dot(&other)).max(0.2);
            [corner, corner + out * PAVEMENT]
        });
        let corners = ends.as_flattened().iter().flat_map(|at| [-SLAB, 0.0].map(|z| [at.x, at.y, z]));
        b.hull("pavement", &corners.collect::<Vec<P>>(), looks.pavement);
    }
    let ((x, y), (width, depth)) = (pavement.centre(), pavement.size());
    b.top("pavement", [x, y, 0.0], (width / 2.0, depth / 2.0));
    let all = measures.outline.iter().map(|&(x, y)| Area { x0: x, y0: y, x1: x, y1: y });
    let all = all.reduce(Area::around_both).unwrap_or_default();
    let Area { x0, y0, x1, y1 } = all.grown(BEYOND);
    b.collision_only(|b| b.block("ground", [x0, y0, -2.0 * SLAB], [x1, y1, -SLAB], looks.pavement));
}

/// The sides before and after each.
fn beside(sides: &[Side]) -> impl Iterator<Item = [Side; 2]> + '_ {
    (0..sides.len()).map(|at| [sides[(at + sides.len() - 1) % sides.len()], sides[(at + 1) % sides.len()]])
}

/// The skin of a storey along a side, from floor to floor, with its windows and a string course.
fn wall(side: &Side, measures: &Measures, storey: usize, panes: &[Pane], (looks, maker): (&Facade, Maker<'_>)) -> Item {
    let height = measures.heights[storey];
    let floor = height.floor as f32;
    let up = |[along, (low, high)]: Panel| [along, (floor + low, floor + high)];
    let glazed: Vec<(Panel, MaterialId)> =
        panes.iter().filter_map(|pane| Some((side.taken(pane)?, pane.glass))).collect();
    let door =
        Pane { at: (0.0, measures.facade), width: STREET_DOOR.0, height: (0.0, STREET_DOOR.1), glass: BLACK_GLASS };
    let door = side.taken(&door).filter(|_| storey == 0);
    let holes: Vec<Panel> = glazed.iter().map(|(panel, _)| *panel).chain(door).collect();
    let all = (0.0, side.length);
    built("wall", [0.0; 3], maker.style, |b| {
        for part in around([all, (0.0, height.storey)], &holes) {
            side.plate(b, up(part), (SKIN, 0.0), looks.wall);
        }
        let longer = (-COURSE.0, side.length + COURSE.0);
        side.plate(b, up([longer, (height.storey - COURSE.1, height.storey)]), (COURSE.0, 0.0), looks.trim);
        for (panel, glass) in &glazed {
            side.plate(b, up(*panel), (0.01, 0.0), *glass);
            frame(*panel).into_iter().for_each(|part| side.plate(b, up(part), (SKIN, 0.0), looks.frame));
            let [(from, to), (sill, _)] = *panel;
            if sill > 0.3 {
                side.plate(b, up([(from - 0.06, to + 0.06), (sill - 0.06, sill)]), (LEDGE, 0.0), looks.trim);
            }
        }
    })
}

/// The frame of a window, with a mullion in the middle of a wide one.
fn frame([(from, to), (low, high)]: Panel) -> Vec<Panel> {
    let (x, middle) = (FRAME, f32::midpoint(from, to));
    let mut parts = vec![
        [(from, from + x), (low, high)],
        [(to - x, to), (low, high)],
        [(from + x, to - x), (low, low + x)],
        [(from + x, to - x), (high - x, high)],
    ];
    if to - from > 1.0 {
        parts.push([(middle - x / 2.0, middle + x / 2.0), (low + x, high - x)]);
    }
    parts
}

/// The parapet around the roof.
fn parapet(b: &mut Build<'_>, sides: &[Side], measures: &Measures, looks: &Facade) {
    let top = top(measures);
    for side in sides {
        side.plate(b, [(0.0, side.length), (top, top + PARAPET)], (SKIN, WALL), looks.wall);
        let longer = (-COURSE.0, side.length + COURSE.0);
        side.plate(b, [longer, (top + PARAPET, top + PARAPET + 0.06)], (COURSE.0, WALL + 0.04), looks.trim);
    }
}
