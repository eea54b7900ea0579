//! The free space of a room: its floor, its walls with their openings, the objects in it and the
//! zones that must stay free.

use nalgebra::Vector3;
use smallvec::SmallVec;
use vc_geometry::grid::{ceiling, floor};

use super::walk::Walk;
use crate::area::{Area, Facing};
use crate::plan::{Boundary, FloorPlan, OpeningKind, Rect, Room, RoomKind, metres};

/// The distance of furniture from walls, which leaves space for the skirting, metres.
pub(super) const OFF_WALL: f32 = 0.02;

/// The height up to which reserved zones must be clear, metres.
const CLEAR: f32 = 1.7;

/// A solid: a rectangle on the floor and a range of heights, metres.
#[derive(Debug, Clone, Copy)]
pub(super) struct Solid {
    pub(super) area: Area,
    pub(super) low: f32,
    pub(super) high: f32,
}

impl Solid {
    pub(super) fn hits(&self, other: &Self) -> bool {
        self.low < other.high - 1e-4 && other.low < self.high - 1e-4 && self.area.overlaps(&other.area)
    }
}

/// The inner face of a straight piece of wall.
#[derive(Debug, Clone)]
pub(super) struct Side {
    /// The direction that a person with the wall at their back faces.
    pub(super) facing: Facing,
    /// Its X if it runs along Y, otherwise its Y, metres.
    pub(super) at: f32,
    pub(super) from: f32,
    pub(super) to: f32,
    /// The stretches with a door or passage.
    pub(super) ways: Vec<(f32, f32)>,
    /// The stretches with a window, each with the height of its sill.
    pub(super) windows: Vec<(f32, f32, f32)>,
}

impl Side {
    pub(super) fn length(&self) -> f32 {
        self.to - self.from
    }

    /// The point at a position along the face and a distance off it.
    pub(super) fn point(&self, along: f32, off: f32) -> (f32, f32) {
        let (dx, dy) = self.facing.step();
        if self.facing.is_along_x() { (self.at + dx * off, along) } else { (along, self.at + dy * off) }
    }

    /// The lowest sill over a stretch; `None` where there is no window.
    pub(super) fn sill(&self, from: f32, to: f32) -> Option<f32> {
        let over = self.windows.iter().filter(|w| w.0 < to && w.1 > from).map(|w| w.2);
        over.reduce(f32::min)
    }

    pub(super) fn has_way(&self, from: f32, to: f32) -> bool {
        self.ways.iter().any(|w| w.0 < to && w.1 > from)
    }
}

/// The usable space of a room.
#[derive(Debug, Clone)]
pub(super) struct Space {
    pub(super) kind: RoomKind,
    pub(super) net: Vec<Rect>,
    pub(super) sides: Vec<Side>,
    pub(super) solids: Vec<Solid>,
    /// The space of windows: sill board, frame and the depth to open a sash a little.
    pub(super) panes: Vec<Solid>,
    /// The rectangles in front of doors and under their leaves, where nothing may stand.
    pub(super) ways: Vec<Area>,
    /// The rectangles that pieces need free, except for objects that belong to them.
    pub(super) zones: Vec<Area>,
    pub(super) walk: Walk,
    pub(super) ceiling: f32,
    pub(super) square_metres: f32,
}

impl Space {
    pub(super) fn new(plan: &FloorPlan, index: usize) -> Self {
        let room = &plan.rooms[index];
        let net = room.net();
        let mut space = Self {
            kind: room.kind,
            sides: sides(plan, index, &net),
            walk: Walk::new(plan, index, &net),
            net,
            solids: Vec::new(),
            panes: panes(plan, index),
            ways: Vec::new(),
            zones: Vec::new(),
            ceiling: plan.ceiling,
            square_metres: room.area(),
        };
        for opening in plan.doors_of(index) {
            let high = opening.high == Some(index);
            let deep = match (opening.kind, room.kind) {
                (OpeningKind::Passage, _) => 16,
                // The zone begins behind the outer wall.
                (_, RoomKind::Balcony) => 12 + plan.shell,
                _ => 12,
            };
            space.ways.push(Area::from_rect(&opening.before(high, deep)));
            if let Some(swing) = opening.swing().filter(|_| opening.opens_high == high) {
                // Beyond the leaf's edge a small clearance is kept.
                space.ways.push(Area::from_rect(&swing).grown(0.03));
            }
        }
        space
    }

    /// Whether a rectangle lies on the room's floor.
    pub(super) fn is_floor(&self, area: &Area) -> bool {
        let out = |v: f32| ceiling(v * 20.0 - 1e-3);
        let low = |v: f32| floor(v * 20.0 + 1e-3);
        let rect = Rect { x0: low(area.x0), y0: low(area.y0), x1: out(area.x1), y1: out(area.y1) };
        self.net.iter().any(|n| rect.shared(*n) == rect) || (self.net.len() > 1 && crate::plan::covers(&self.net, rect))
    }

    /// Whether a box overlaps no solid.
    pub(super) fn is_empty(&self, solid: &Solid) -> bool {
        !self.solids.iter().any(|s| s.hits(solid))
    }

    /// Whether an object may stand in a box: on the floor, outside all solids and zones.
    pub(super) fn is_free(&self, solid: &Solid) -> bool {
        !self.zones.iter().any(|z| z.overlaps(&solid.area)) && self.is_off_ways(solid)
    }

    /// The same for an object that may stand in a zone, such as a chair at its desk.
    pub(super) fn is_off_ways(&self, solid: &Solid) -> bool {
        let off = !self.ways.iter().any(|z| z.overlaps(&solid.area)) && !self.panes.iter().any(|p| p.hits(solid));
        off && self.is_floor(&solid.area) && self.is_empty(solid)
    }

    /// Whether all doorways and objects stay reachable with one more solid in the room.
    pub(super) fn stays_open(&self, solid: &Solid) -> bool {
        !crate::reach::is_in_the_way((solid.low, solid.high)) || self.walk.stays_open(&[solid.area])
    }

    /// Whether a zone is floor without objects on it.
    pub(super) fn is_clear(&self, zone: &Area) -> bool {
        let solid = Solid { area: *zone, low: 0.0, high: CLEAR };
        let sills = || self.panes.iter().any(|p| p.hits(&solid));
        zone.square_metres() < 1e-4 || (self.is_floor(zone) && self.is_empty(&solid) && !sills())
    }

    /// The stretches along a wall in which an object of a size that needs the given depth in front
    /// certainly has no space, by the position of its centre. A quick test that excludes most
    /// occupied spots before the exact one.
    pub(super) fn taken(&self, side: &Side, size: Vector3<f32>, front: f32) -> SmallVec<[(f32, f32); 32]> {
        // Objects that merely touch are left to the exact test.
        const SURE: f32 = 1e-3;
        let back = side.point(f32::midpoint(side.from, side.to), OFF_WALL);
        let strip = side.facing.area(back, size.x, side.length());
        let body = Solid { area: strip.grown(-SURE), low: 0.0, high: size.z };
        let before = Solid { area: side.facing.before(&strip, front).grown(-SURE), low: 0.0, high: CLEAR };
        let half = size.y / 2.0 - SURE;
        let mut taken = SmallVec::new();
        let mut take = |area: &Area| {
            let (from, to) = if side.facing.is_along_x() { (area.y0, area.y1) } else { (area.x0, area.x1) };
            taken.push((from - half, to + half));
        };
        for area in [&self.zones, &self.ways].into_iter().flatten().filter(|area| area.overlaps(&body.area)) {
            take(area);
        }
        for solid in [&self.solids, &self.panes].into_iter().flatten() {
            if solid.hits(&body) || (front > SURE && solid.hits(&before)) {
                take(&solid.area);
            }
        }
        taken
    }

    /// The distance from a rectangle to the nearest door's zone.
    pub(super) fn door_distance(&self, area: &Area) -> f32 {
        self.ways.iter().map(|z| z.distance(area)).fold(f32::INFINITY, f32::min)
    }
}

fn panes(plan: &FloorPlan, index: usize) -> Vec<Solid> {
    let windows = plan.openings.iter().filter(|o| o.kind == OpeningKind::Window && o.touches(index));
    let pane = |o: &crate::plan::PlanOpening| Solid {
        area: Area::from_rect(&o.before(o.high == Some(index), 4)).grown(0.07),
        low: o.sill - 0.07,
        high: o.head + 0.07,
    };
    windows.map(pane).collect()
}

/// The inner faces of a room's walls; for a balcony its railings and the house.
fn sides(plan: &FloorPlan, index: usize, net: &[Rect]) -> Vec<Side> {
    let inner = Room { kind: plan.rooms[index].kind, rects: net.to_vec(), of: None };
    let edges = crate::plan::boundaries_of(&[inner]);
    edges.iter().map(|e| side(plan, index, e)).collect()
}

fn side(plan: &FloorPlan, index: usize, edge: &Boundary) -> Side {
    let inwards_high = edge.high.is_some();
    let facing = match (edge.vertical, inwards_high) {
        (true, true) => Facing(0),
        (false, true) => Facing(1),
        (true, false) => Facing(2),
        (false, false) => Facing(3),
    };
    // Openings are stored with the wall's centre line, one cell behind its face; the house wall of
    // a balcony is thicker.
    let thick = if plan.rooms[index].kind == RoomKind::Balcony { plan.shell } else { 1 };
    let behind = if inwards_high { edge.at - thick } else { edge.at + thick };
    let here = plan.openings.iter().filter(|o| {
        o.touches(index) && o.vertical == edge.vertical && o.at == behind && o.from < edge.to && o.to > edge.from
    });
    let (mut ways, mut windows) = (Vec::new(), Vec::new());
    for opening in here {
        let (from, to) = (metres(opening.from), metres(opening.to));
        match opening.kind {
            OpeningKind::Window => windows.push((from, to, opening.sill)),
            _ => ways.push((from, to)),
        }
    }
    let (at, from, to) = (metres(edge.at), metres(edge.from), metres(edge.to));
    Side { facing, at, from, to, ways, windows }
}
