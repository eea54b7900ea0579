//! Landings: the corridor, the way past the stairs to the lift, and the lobby; on the ground with the door to the street.

use std::f32::consts::FRAC_PI_2;

use nalgebra::{Translation3, UnitQuaternion, Vector3};
use vc_graph::{Pose, State};

use super::flat::Flat;
use super::measures::{EDGE, HALF, Height, LINING, Measures, SHAFT, SLAB, STREET_DOOR as ENTRANCE, WALL, WINDOW};
use super::wall::wall;
use crate::area::Area;
use crate::circulation::parts::{Block, Maker, P, block, floor, mounted, placed, solid};
use crate::circulation::rail::rail;
use crate::circulation::stairs::BANISTER;
use crate::circulation::{Looks, lift};
use crate::facade::Panel;
use crate::item::{Item, Support};

/// The places of some items among those of a landing; the street door is in the hall only.
pub(super) const LIFT_DOOR: usize = 1;
pub(super) const CALL: usize = 2;
pub(super) const STREET_DOOR: usize = 3;

/// The distance of a railing's line from the edge that it guards.
const INSET: f32 = 0.06;
/// How far the casing of a front door goes around its opening.
const CASING: f32 = 0.1;
/// The distance of lamps in the corridor.
const LAMPS: f32 = 6.0;

/// A landing as it is on one storey.
pub(super) struct Landing<'a> {
    pub(super) measures: &'a Measures,
    pub(super) storey: usize,
    pub(super) flats: &'a [Flat],
    pub(super) looks: &'a Looks,
    pub(super) maker: Maker<'a>,
}

/// The pose of the lift in the frame of a landing.
pub(super) fn lift_pose(measures: &Measures) -> Pose {
    let turn = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), FRAC_PI_2);
    Pose::from_parts(Translation3::new(SHAFT, measures.lift, 0.0), turn)
}

impl Landing<'_> {
    fn is_ground(&self) -> bool {
        self.storey == 0
    }

    fn is_top(&self) -> bool {
        self.storey + 1 == self.measures.heights.len()
    }

    fn height(&self) -> Height {
        self.measures.heights[self.storey]
    }

    /// All its items; those with a place come first.
    pub(super) fn items(&self) -> Vec<Item> {
        let mut items = Vec::from_iter(self.floor());
        let lift = lift_pose(self.measures);
        let parts = lift::door(self.maker).into_iter().chain(lift::call_button(self.maker));
        items.extend(parts.map(|item| Item { pose: lift * item.pose, ..item }));
        items.extend(self.openings());
        let (top, roof) =
            if self.is_top() { (self.height().clear, Some(SLAB)) } else { (self.height().storey - SLAB, None) };
        let low = if self.is_ground() { 0.0 } else { -SLAB };
        items.extend(
            lift::shaft((low, top), roof, self.looks).into_iter().map(|item| Item { pose: lift * item.pose, ..item }),
        );
        items.extend(self.walls());
        items.extend(self.ceiling());
        items.extend(self.rails().iter().map(|line| rail("railing", line, self.looks.rail(), self.maker.style)));
        if !self.is_top() {
            items.extend(self.measures.stairs(self.storey).items(None, self.looks, self.maker.style));
        }
        items.extend(self.lamps());
        items
    }

    /// The corridor, the way past the stairs, and the lobby, within their walls.
    fn rooms(&self) -> [Area; 3] {
        let (corridor, shaft) = (self.measures.corridor, self.measures.shaft());
        let within = Area { x0: corridor.x0 + WALL, x1: corridor.x1 - WALL, y0: self.measures.behind(), y1: EDGE };
        let passage = Area { x0: SHAFT, x1: HALF - LINING, y0: EDGE, y1: shaft.y1 };
        [within, passage, Area { x0: LINING - HALF, y0: shaft.y1, y1: self.measures.facade - WALL, ..passage }]
    }

    /// The slab: under rooms and their linings, with thresholds; under the stairs on the ground only.
    fn floor(&self) -> Option<Item> {
        let [corridor, passage, lobby] = self.rooms();
        let behind = if self.measures.is_between { 0.0 } else { WALL };
        let mut areas =
            vec![Area { y0: behind, ..corridor }, Area { x1: HALF, ..passage }, Area { x0: -HALF, x1: HALF, ..lobby }];
        if self.is_ground() {
            areas.push(self.measures.well());
            areas.push(Area { x0: -ENTRANCE.0 / 2.0, x1: ENTRANCE.0 / 2.0, y0: lobby.y1, y1: self.measures.facade });
        }
        let sill = lift::sill();
        areas.push(Area {
            x0: SHAFT - sill.y1,
            x1: SHAFT,
            y0: self.measures.lift + sill.x0,
            y1: self.measures.lift + sill.x1,
        });
        let thresholds = self.flats.iter().map(|flat| {
            let ((x, y), half) = (flat.door.outside, flat.door.size.0 / 2.0);
            let (y0, y1) = if flat.door.is_north { (EDGE, y) } else { (y, 0.0) };
            Area { x0: x - half, x1: x + half, y0, y1 }
        });
        areas.extend(thresholds.filter(|area| area.y1 - area.y0 > 1e-4));
        let slab =
            |area: &Area| -> Block { block((area.x0, area.x1), (area.y0, area.y1), (-SLAB, 0.0), self.looks.floor) };
        floor(&areas.iter().map(slab).collect::<Vec<Block>>(), &self.rooms())
    }

    /// The street door, or the lobby's window, and the windows of the corridor.
    fn openings(&self) -> Vec<Item> {
        let y = self.measures.facade - WALL / 2.0;
        let window = |x: f32, y: f32, yaw: f32| {
            let [half, sill, head] = WINDOW;
            let window = self.maker.sized("window", [WALL, 2.0 * half, head - sill])?;
            Some(mounted(window, [x, y, sill], yaw))
        };
        let first = if self.is_ground() {
            let door = self.maker.sized("main_door", [WALL, ENTRANCE.0, ENTRANCE.1]);
            door.map(|door| mounted(door, [0.0, y, 0.0], -FRAC_PI_2))
        } else {
            window(0.0, y, -FRAC_PI_2)
        };
        let corridor = self.measures.corridor_windows().into_iter();
        first.into_iter().chain(corridor.filter_map(|x| window(x, WALL / 2.0, FRAC_PI_2))).collect()
    }

    /// Outer walls and linings.
    fn walls(&self) -> Vec<Item> {
        let (Area { x0, x1, .. }, facade, behind) =
            (self.measures.corridor, self.measures.facade, self.measures.behind());
        let Height { storey, clear, .. } = self.height();
        let inner = (0.0, storey - SLAB);
        let outer = (0.0, clear);
        let doors = |north: bool| -> Vec<Panel> {
            let here = self.flats.iter().filter(move |flat| flat.door.is_north == north);
            here.map(|flat| {
                let ((x, _), half) = (flat.door.outside, flat.door.size.0 / 2.0 + CASING);
                [(x - half, x + half), (0.0, flat.door.size.1 + CASING)]
            })
            .collect()
        };
        let [half, sill, head] = WINDOW;
        let hole: Panel = if self.is_ground() {
            [(-ENTRANCE.0 / 2.0, ENTRANCE.0 / 2.0), (0.0, ENTRANCE.1)]
        } else {
            [(-half, half), (sill, head)]
        };
        let mut behind_it = doors(false);
        behind_it.extend(self.measures.corridor_windows().iter().map(|x| [(x - half, x + half), (sill, head)]));
        let (well, north) = (self.measures.shaft().y1, facade - WALL);
        // No slab is above the walls of the well.
        let open = if self.is_top() { inner } else { (0.0, storey) };
        let (paint, lining) = (self.maker.style.wall, EDGE - LINING);
        let area = |x0, x1, y0, y1| Area { x0, y0, x1, y1 };
        let back = if self.measures.is_between { inner } else { outer };
        [
            wall(area(x0, x1, 0.0, behind), back, &behind_it, paint),
            wall(area(x0, x0 + WALL, behind, EDGE), outer, &[], paint),
            wall(area(x1 - WALL, x1, behind, EDGE), outer, &[], paint),
            wall(area(x0 + WALL, LINING - HALF, lining, EDGE), inner, &doors(true), paint),
            wall(area(HALF - LINING, x1 - WALL, lining, EDGE), inner, &doors(true), paint),
            wall(area(-HALF, LINING - HALF, EDGE, well), open, &[], paint),
            wall(area(-HALF, LINING - HALF, well, north), inner, &[], paint),
            wall(area(HALF - LINING, HALF, EDGE, north), inner, &[], paint),
            wall(area(-HALF, HALF, north, facade), outer, &[hole], paint),
        ]
        .into_iter()
        .flatten()
        .collect()
    }

    /// The ceiling of all rooms, on the last storey also that over the stairs.
    fn ceiling(&self) -> Option<Item> {
        let Height { clear, storey, .. } = self.height();
        let mut areas = self.rooms().to_vec();
        if self.is_top() {
            areas.push(Area { x0: LINING - HALF, ..self.measures.well() });
        }
        let slab =
            |area: &Area| block((area.x0, area.x1), (area.y0, area.y1), (clear, storey - SLAB), self.maker.style.wall);
        solid("ceiling", &areas.iter().map(slab).collect::<Vec<Block>>())
    }

    /// The lines of the railings: along the well of the stairs, open where flights begin and end.
    fn rails(&self) -> Vec<[P; 2]> {
        let (stairs, well) = (self.measures.stairs(self.storey), self.measures.well());
        let (x, y) = (SHAFT + INSET, EDGE - INSET);
        let mut lines = vec![[[x, y, 0.0], [x, well.y1, 0.0]]];
        if self.is_top() {
            lines.push([[LINING - HALF, y, 0.0], [stairs.back.0 - BANISTER, y, 0.0]]);
        }
        if self.is_ground() {
            lines.push([[stairs.up.1 + BANISTER, y, 0.0], [x, y, 0.0]]);
        }
        lines
    }

    fn lamps(&self) -> Vec<Item> {
        let [corridor, passage, lobby] = self.rooms();
        let ((x, y), length) = (corridor.centre(), corridor.size().0);
        let count = (length / LAMPS).ceil().max(1.0) as usize;
        let along = (0..count).map(|at| (x + length * ((at as f32 + 0.5) / count as f32 - 0.5), y));
        let lamp = |at: (f32, f32)| {
            let lamp = self.maker.sized("ceiling_lamp", [0.4, 0.4, 0.1])?;
            let up = self.height().clear - lamp.size().z;
            let item = placed(lamp, [at.0, at.1, up], 0.0, Support::Ceiling);
            Some(Item { states: vec![State::On], ..item })
        };
        along.chain([passage.centre(), lobby.centre()]).filter_map(lamp).collect()
    }
}
