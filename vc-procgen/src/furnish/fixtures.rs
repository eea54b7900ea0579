//! Fixtures on walls, windows and ceilings: radiators, curtains, lamps, pictures, switches and
//! sockets.

use super::Furnisher;
use super::other::hang_somewhere;
use super::space::{Side, Solid};
use crate::area::{Area, Facing};
use crate::draft::Draft;
use crate::item::Support;
use crate::plan::{FloorPlan, OpeningKind, RoomKind, metres};

/// Adds the fixtures that fit beside the room's furniture.
pub(super) fn fix(s: &mut Furnisher<'_>, plan: &FloorPlan) {
    if s.kind() == RoomKind::Balcony {
        return;
    }
    ceiling_lamp(s, plan);
    switches(s, plan);
    for side in 0..s.space.sides.len() {
        for window in 0..s.space.sides[side].windows.len() {
            let (from, to, sill) = s.space.sides[side].windows[window];
            let head = plan.openings.iter().find(|o| {
                o.kind == OpeningKind::Window
                    && o.touches(s.room)
                    && (metres(o.from) - from).abs() < 1e-3
                    && (metres(o.to) - to).abs() < 1e-3
            });
            let head = head.map_or(2.2, |o| o.head);
            radiator(s, side, (from, to), sill);
            dress_window(s, side, (from, to), (sill, head));
        }
    }
    sockets(s);
    pictures(s);
}

/// Hangs one lamp from the ceiling of every room, several in rooms of several rectangles.
fn ceiling_lamp(s: &mut Furnisher<'_>, plan: &FloorPlan) {
    let class = match s.kind() {
        RoomKind::Living | RoomKind::Kids | RoomKind::Bedroom if s.rng.chance(0.5) => "pendant_lamp",
        _ => "ceiling_lamp",
    };
    let Some(lamp) = (match class {
        "pendant_lamp" => s.make(class, [0.4, 0.4, 0.4]),
        _ => s.make(class, [0.36, 0.36, 0.12]),
    }) else {
        return;
    };
    let flat = if class == "pendant_lamp" { s.make("ceiling_lamp", [0.36, 0.36, 0.12]) } else { None };
    let ceiling = plan.ceiling;
    for rect in plan.rooms[s.room].rects.clone() {
        let area = Area::from_rect(&rect);
        let small = area.square_metres() < 3.0 && s.items.iter().any(|i| i.support == Support::Ceiling);
        let centre = area.centre();
        // A low lamp would collide with the doors of a wardrobe.
        let low = s.space.zones.iter().any(|z| z.overlaps(&Area::around(centre.0, centre.1, 0.25, 0.25)));
        let lamp = flat.as_ref().filter(|_| low).unwrap_or(&lamp);
        let (height, half) = (lamp.size().z, lamp.size().x.max(lamp.size().y) / 2.0);
        let solid = Solid { area: Area::around(centre.0, centre.1, half, half), low: ceiling - height, high: ceiling };
        if !small && s.space.is_floor(&solid.area) && s.space.is_empty(&solid) {
            s.add(lamp, centre, ceiling - height - 0.001, Facing(0), Support::Ceiling);
        }
    }
}

/// Adds a switch at the latch side of every door, inside the room.
fn switches(s: &mut Furnisher<'_>, plan: &FloorPlan) {
    let Some(switch) = s.make("lightswitch", [0.012, 0.08, 0.08]) else { return };
    let doors: Vec<_> = plan.doors_of(s.room).filter(|o| o.has_leaf()).copied().collect();
    for door in doors.iter().filter(|o| o.kind != OpeningKind::BalconyDoor).take(2) {
        let (from, to) = (metres(door.from) - 0.18, metres(door.to) + 0.18);
        let order = if door.hinge_low { [to, from] } else { [from, to] };
        let high = door.high == Some(s.room);
        let side = s.space.sides.iter().position(|w| {
            let near = (w.at - metres(door.at)).abs() < 0.06;
            let faces = if door.vertical {
                w.facing.0 == if high { 0 } else { 2 }
            } else {
                w.facing.0 == if high { 1 } else { 3 }
            };
            near && faces && w.from < metres(door.to) && w.to > metres(door.from)
        });
        let Some(side) = side else { continue };
        order.into_iter().find_map(|along| s.hang(&switch, side, along, 1.05));
    }
}

/// Adds a radiator below a window if the space is free.
fn radiator(s: &mut Furnisher<'_>, side: usize, window: (f32, f32), sill: f32) {
    if sill < 0.7 || s.kind() == RoomKind::Kitchen {
        return;
    }
    let width = (window.1 - window.0 - 0.05).clamp(0.4, 1.6);
    let Some(radiator) = s.make("radiator", [0.1, width, 0.6]) else { return };
    let along = f32::midpoint(window.0, window.1);
    let wall = &s.space.sides[side];
    let size = radiator.size();
    let solid = Solid { area: wall.facing.area(wall.point(along, 0.016), size.x, size.y), low: 0.0, high: size.z };
    let mut kept = s.space.ways.iter().chain(&s.space.zones);
    let free = s.space.is_empty(&solid) && s.space.is_floor(&solid.area) && !kept.any(|w| w.overlaps(&solid.area));
    if free && s.space.stays_open(&solid) {
        let (facing, centre) = (wall.facing, solid.area.centre());
        s.add(&radiator, centre, 0.0, facing, Support::Floor);
    }
}

/// Adds curtains or a blind, as the room and the furniture below allow.
fn dress_window(s: &mut Furnisher<'_>, side: usize, window: (f32, f32), heights: (f32, f32)) {
    let (sill, head) = heights;
    let blind = matches!(s.kind(), RoomKind::Kitchen | RoomKind::Bathroom | RoomKind::Study) || s.rng.chance(0.2);
    if blind {
        let width = window.1 - window.0 + 0.06;
        let blinds = s.make("blinds", [0.06, width, 0.3]);
        if let Some(blinds) = blinds {
            hang_over(s, &blinds, side, f32::midpoint(window.0, window.1), head + 0.02);
        }
        return;
    }
    let bundle = 0.28;
    let top = head + 0.08;
    for (along, long) in [(window.0 - bundle / 2.0 - 0.07, true), (window.1 + bundle / 2.0 + 0.07, true)] {
        // To the floor where nothing is in the way, otherwise to the sill.
        for low in [if long { 0.02 } else { sill }, sill - 0.12] {
            let Some(curtain) = s.make("curtain", [0.09, bundle, top - low]) else { return };
            if hang_over(s, &curtain, side, along, low).is_some() {
                break;
            }
        }
    }
    let rod = s.make("curtain_rod", [0.08, window.1 - window.0 + 2.0 * bundle, 0.05]);
    if let Some(rod) = rod {
        hang_over(s, &rod, side, f32::midpoint(window.0, window.1), top + 0.005);
    }
}

/// Hangs an object on a wall where it may cover a window.
fn hang_over(s: &mut Furnisher<'_>, object: &Draft, side: usize, along: f32, z: f32) -> Option<usize> {
    let wall: &Side = &s.space.sides[side];
    let size = object.size();
    // Farther off the wall than the sill board's joint and the skirting.
    let area = wall.facing.area(wall.point(along, 0.02), size.x, size.y);
    let solid = Solid { area, low: z, high: z + size.z };
    let inside =
        along - size.y / 2.0 > wall.from && along + size.y / 2.0 < wall.to && z + size.z < s.space.ceiling - 0.01;
    let door = wall.has_way(along - size.y / 2.0 - 0.06, along + size.y / 2.0 + 0.06)
        || s.space.ways.iter().any(|w| z < 2.1 && w.overlaps(&area));
    let facing = wall.facing;
    let free = inside && !door && s.space.is_empty(&solid) && s.space.stays_open(&solid);
    free.then(|| s.add(object, area.centre(), z, facing, Support::Wall))
}

fn sockets(s: &mut Furnisher<'_>) {
    let count = match s.kind() {
        RoomKind::Living | RoomKind::Kitchen => 4,
        RoomKind::Bedroom | RoomKind::Kids | RoomKind::Study => 3,
        _ => 1,
    };
    let Some(socket) = s.make("powersocket", [0.012, 0.08, 0.08]) else { return };
    let z = if s.kind() == RoomKind::Kitchen { 1.1 } else { 0.3 };
    for _ in 0..count {
        hang_somewhere(s, Some(socket.clone()), z);
    }
}

/// Hangs pictures, a clock and shelves where the wall is free.
fn pictures(s: &mut Furnisher<'_>) {
    let (most, shelves) = match s.kind() {
        RoomKind::Living => (4, 0.4),
        RoomKind::Bedroom | RoomKind::Kids | RoomKind::Study => (2, 0.35),
        RoomKind::Hall | RoomKind::Kitchen => (1, 0.1),
        _ => (0, 0.0),
    };
    if s.rng.chance(shelves) {
        let width = s.rng.between(0.6, 1.1);
        let shelf = s.make("wall_shelf", [0.22, width, 0.2]);
        hang_somewhere(s, shelf, 1.45);
    }
    if matches!(s.kind(), RoomKind::Kitchen | RoomKind::Living | RoomKind::Study) && s.rng.chance(0.5) {
        let clock = s.make("wall_clock", [0.05, 0.3, 0.3]);
        hang_somewhere(s, clock, 1.9);
    }
    let count = s.rng.count(0, most);
    for _ in 0..count {
        let (width, height) = (s.rng.between(0.3, 1.0), s.rng.between(0.3, 0.7));
        let class = if s.kind() == RoomKind::Kids { "poster" } else { "painting" };
        let picture = s.make(class, [0.035, width, height]);
        hang_somewhere(s, picture, 1.55 - height / 2.0);
    }
}
