//! The building as items: walls, floors, ceilings, doors, windows, railings.

use std::sync::Arc;

use nalgebra::{UnitQuaternion, Vector3};
use vc_graph::{Pose, Seed};
use vc_shapes::Style;
use vc_shapes::material::MaterialId;
use vc_shapes::object::{self, Object};

use crate::area::Facing;
use crate::item::{Item, Support};
use crate::plan::{FloorPlan, OpeningKind, PlanOpening, Rect, RoomKind, metres};
use crate::reach::doorway;
use crate::solids::Solids;

/// The thickness of floors and ceilings, metres.
const SLAB: f32 = 0.2;
/// The height and thickness of skirting boards, metres.
const SKIRTING: (f32, f32) = (0.07, 0.012);
/// The width of the casing around a door, metres.
const CASING: f32 = 0.06;

/// All items of the building, in the order walls, floors, ceilings, doors, windows.
pub(crate) fn build(plan: &FloorPlan, style: &Style, facade: Option<MaterialId>, seed: Seed) -> Vec<Item> {
    let drawn = Finishes::new(plan, style, seed);
    let finishes = Finishes { outside: facade.unwrap_or(drawn.outside), ..drawn };
    let mut items = walls(plan, &finishes);
    items.extend((0..plan.rooms.len()).map(|room| floor(plan, room, &finishes)));
    let roofed = (0..plan.rooms.len()).filter(|&r| plan.rooms[r].kind != RoomKind::Balcony);
    items.extend(roofed.map(|room| ceiling(plan, room, style)));
    items.extend(plan.openings.iter().enumerate().filter_map(|(i, o)| opening(plan, o, style, seed.nth(i as u64))));
    items
}

/// The number that the door or window of an opening has in the scene of a home; `None` for a passage.
pub(crate) fn number_of(plan: &FloorPlan, opening: usize) -> Option<u32> {
    let has_item = |opening: &&PlanOpening| opening.kind != OpeningKind::Passage;
    plan.openings.get(opening).filter(has_item)?;
    let before = plan.openings[..opening].iter().filter(has_item).count();
    let walls = walls(plan, &Finishes::new(plan, &Style::from_seed(Seed(0)), Seed(0))).len();
    let roofed = plan.rooms.iter().filter(|room| room.kind != RoomKind::Balcony).count();
    Some((2 * plan.rooms.len() + walls + roofed + before) as u32)
}

/// The materials of walls and floors by room.
struct Finishes {
    walls: Vec<MaterialId>,
    floors: Vec<MaterialId>,
    outside: MaterialId,
    joinery: MaterialId,
}

impl Finishes {
    fn new(plan: &FloorPlan, style: &Style, seed: Seed) -> Self {
        use vc_shapes::material::{BRICK, CONCRETE, PLASTER, SANDSTONE, WHITE_TILE};
        let mut rng = seed.child("looks").stream();
        let feature = rng.below(plan.rooms.len());
        let walls = plan.rooms.iter().enumerate().map(|(i, r)| match r.kind {
            RoomKind::Bathroom | RoomKind::Wc => style.tile,
            RoomKind::Balcony => WHITE_TILE,
            _ if i == feature || (r.kind == RoomKind::Kids && rng.chance(0.5)) => style.feature,
            _ => style.wall,
        });
        let walls = walls.collect();
        let floors = plan.rooms.iter().map(|r| match r.kind {
            RoomKind::Balcony => CONCRETE,
            kind if kind.is_wet() => style.tile,
            _ => style.floor,
        });
        let floors = floors.collect();
        let outside = [PLASTER, BRICK, SANDSTONE, CONCRETE][rng.below(4)];
        Self { walls, floors, outside, joinery: style.joinery }
    }
}

/// A rectangular piece of wall and its owner.
struct Piece {
    rect: Rect,
    /// The room whose side of the wall it is; for an outer piece, the adjacent room.
    room: usize,
    outside: bool,
}

/// The walls room by room: the ring between a room's gross and net area belongs to the room, the
/// wall outside all rooms to the building.
fn walls(plan: &FloorPlan, finishes: &Finishes) -> Vec<Item> {
    let pieces = pieces(plan);
    let mut skirtings = skirtings(plan);
    let mut items = Vec::new();
    for piece in &pieces {
        let balcony = plan.rooms[piece.room].kind == RoomKind::Balcony && !piece.outside;
        let mut solids = Solids::new(if balcony { "railing" } else { "wall" });
        let mat = if piece.outside { finishes.outside } else { finishes.walls[piece.room] };
        if balcony {
            solids.block(
                "railing",
                corner(piece.rect.x0, piece.rect.y0, 0.0),
                corner(piece.rect.x1, piece.rect.y1, 1.05),
                finishes.joinery,
            );
        } else {
            cut(plan, piece.rect, &plan.openings, &mut solids, mat);
            if !piece.outside {
                let here = |r: &[f32; 6], room: usize| room == piece.room && touches(r, &piece.rect);
                skirtings.retain(|(board, room)| {
                    let mine = here(board, *room);
                    if mine {
                        solids.block(
                            "skirting",
                            [board[0], board[1], board[2]],
                            [board[3], board[4], board[5]],
                            finishes.joinery,
                        );
                    }
                    !mine
                });
            }
        }
        items.extend(solids.item(piece.room));
    }
    items
}

fn corner(x: i32, y: i32, z: f32) -> [f32; 3] {
    [metres(x), metres(y), z]
}

fn touches(board: &[f32; 6], rect: &Rect) -> bool {
    let (x, y) = (f32::midpoint(board[0], board[3]), f32::midpoint(board[1], board[4]));
    let near = 0.03;
    x > metres(rect.x0) - near && x < metres(rect.x1) + near && y > metres(rect.y0) - near && y < metres(rect.y1) + near
}

/// A rectangle of wall from floor to ceiling, minus the openings in it.
fn cut(plan: &FloorPlan, rect: Rect, openings: &[PlanOpening], solids: &mut Solids, mat: MaterialId) {
    if rect.is_empty() {
        return;
    }
    let Some((first, rest)) = openings.split_first() else {
        solids.block("wall", corner(rect.x0, rect.y0, 0.0), corner(rect.x1, rect.y1, plan.ceiling), mat);
        return;
    };
    let hole = doorway(plan, first).shared(rect);
    if hole.is_empty() {
        return cut(plan, rect, rest, solids, mat);
    }
    if first.sill > 0.0 {
        solids.block("wall", corner(hole.x0, hole.y0, 0.0), corner(hole.x1, hole.y1, first.sill), mat);
    }
    solids.block("wall", corner(hole.x0, hole.y0, first.head), corner(hole.x1, hole.y1, plan.ceiling), mat);
    let sides = [
        Rect { x1: hole.x0, ..rect },
        Rect { x0: hole.x1, ..rect },
        Rect { x0: hole.x0, x1: hole.x1, y1: hole.y0, ..rect },
        Rect { x0: hole.x0, x1: hole.x1, y0: hole.y1, ..rect },
    ];
    sides.into_iter().for_each(|side| cut(plan, side, rest, solids, mat));
}

/// Decomposes all walls into rectangles, by a sweep over the coordinates at which they can change.
fn pieces(plan: &FloorPlan) -> Vec<Piece> {
    let inner: Vec<&crate::plan::Room> = plan.rooms.iter().collect();
    let nets: Vec<Vec<Rect>> = inner.iter().map(|r| r.net()).collect();
    let mut xs = Vec::new();
    let mut ys = Vec::new();
    for room in &inner {
        for r in &room.rects {
            let by = [0, 1, plan.shell];
            xs.extend(by.iter().flat_map(|b| [r.x0 - b, r.x0 + b, r.x1 - b, r.x1 + b]));
            ys.extend(by.iter().flat_map(|b| [r.y0 - b, r.y0 + b, r.y1 - b, r.y1 + b]));
        }
    }
    for list in [&mut xs, &mut ys] {
        list.sort_unstable();
        list.dedup();
    }
    let owner = |x: i32, y: i32| -> Option<(usize, bool)> {
        let at = Rect { x0: x, y0: y, x1: x + 1, y1: y + 1 };
        let home = |r: &Rect| r.overlaps(&at);
        let shell = |r: &Rect| r.grown(plan.shell).overlaps(&at);
        let near = || inner.iter().position(|r| r.kind != RoomKind::Balcony && r.rects.iter().any(shell));
        let Some(room) = inner.iter().position(|r| r.rects.iter().any(home)) else { return Some((near()?, true)) };
        if nets[room].iter().any(home) {
            return None;
        }
        // The edge of a balcony at the house is the house's wall.
        let house = if inner[room].kind == RoomKind::Balcony { near() } else { None };
        Some(house.map_or((room, false), |house| (house, true)))
    };
    let columns = xs.len() - 1;
    let mut grid: Vec<Option<(usize, bool)>> = Vec::with_capacity(columns * ys.len());
    for y in ys.windows(2) {
        grid.extend(xs.windows(2).map(|x| owner(x[0], y[0])));
    }
    merge(&grid, &xs, &ys)
}

/// Merges equal neighbouring cells into rectangles, rows first.
fn merge(grid: &[Option<(usize, bool)>], xs: &[i32], ys: &[i32]) -> Vec<Piece> {
    let columns = xs.len() - 1;
    let mut done = vec![false; grid.len()];
    let mut pieces = Vec::new();
    for row in 0..ys.len() - 1 {
        for column in 0..columns {
            let start = row * columns + column;
            let Some((room, outside)) = grid[start].filter(|_| !done[start]) else { continue };
            let same = |c: usize, r: usize, done: &[bool]| {
                c < columns && r < ys.len() - 1 && grid[r * columns + c] == grid[start] && !done[r * columns + c]
            };
            let mut right = column;
            while same(right, row, &done) {
                right += 1;
            }
            let mut top = row + 1;
            while (column..right).all(|c| same(c, top, &done)) {
                top += 1;
            }
            for r in row..top {
                done[r * columns + column..r * columns + right].fill(true);
            }
            let rect = Rect { x0: xs[column], x1: xs[right], y0: ys[row], y1: ys[top] };
            pieces.push(Piece { rect, room, outside });
        }
    }
    pieces
}

/// The skirting boards of all rooms, as boxes, with their rooms.
fn skirtings(plan: &FloorPlan) -> Vec<([f32; 6], usize)> {
    let mut boards = Vec::new();
    for (index, room) in plan.rooms.iter().enumerate().filter(|(_, r)| r.kind != RoomKind::Balcony && !r.kind.is_wet())
    {
        let net = crate::plan::Room { kind: room.kind, rects: room.net(), of: None };
        for edge in crate::plan::boundaries_of(std::slice::from_ref(&net)) {
            let (mut from, to) = (metres(edge.from), metres(edge.to));
            let mut gaps: Vec<(f32, f32)> = plan
                .openings
                .iter()
                .filter(|o| {
                    o.is_way() && o.touches(index) && o.vertical == edge.vertical && (o.at - edge.at).abs() <= 1
                })
                .map(|o| (metres(o.from) - CASING, metres(o.to) + CASING))
                .collect();
            gaps.sort_by(|a, b| a.0.total_cmp(&b.0));
            gaps.push((to, to));
            // At the corners, boards along Y leave space for those along X.
            let trim = if edge.vertical { SKIRTING.1 } else { 0.0 };
            from += trim;
            for (low, high) in gaps {
                let end = if high >= to { low.min(to - trim) } else { low };
                if end - from > 0.03 {
                    boards.push((board(&edge, from, end), index));
                }
                from = from.max(high);
            }
        }
    }
    boards
}

fn board(edge: &crate::plan::Boundary, from: f32, to: f32) -> [f32; 6] {
    let at = metres(edge.at);
    let (low, high) = if edge.high.is_some() { (at, at + SKIRTING.1) } else { (at - SKIRTING.1, at) };
    match edge.vertical {
        true => [low, from, 0.0, high, to, SKIRTING.0],
        false => [from, low, 0.0, to, high, SKIRTING.0],
    }
}

/// A room's floor, with the thresholds of its outer doors.
fn floor(plan: &FloorPlan, room: usize, finishes: &Finishes) -> Item {
    let mut solids = Solids::new("floor");
    let own = &plan.rooms[room];
    let mut rects = own.rects.clone();
    if own.kind != RoomKind::Balcony {
        let outer = plan.openings.iter().filter(|o| o.is_way() && o.touches(room));
        for way in outer.filter(|o| o.low.is_none() || o.high.is_none() || o.kind == OpeningKind::BalconyDoor) {
            let sill = doorway(plan, way);
            // The part within the outer wall; the room's own floor reaches the wall's centre line.
            let out = if way.vertical {
                if way.low == Some(room) { Rect { x0: way.at, ..sill } } else { Rect { x1: way.at, ..sill } }
            } else if way.low == Some(room) {
                Rect { y0: way.at, ..sill }
            } else {
                Rect { y1: way.at, ..sill }
            };
            // A balcony's own slab begins one cell before its net area.
            rects.push(if way.kind == OpeningKind::BalconyDoor { shorter(out, way, room) } else { out });
        }
    }
    for rect in &rects {
        solids.block("floor", corner(rect.x0, rect.y0, -SLAB), corner(rect.x1, rect.y1, 0.0), finishes.floors[room]);
    }
    for rect in own.net() {
        let middle = (metres(rect.x0 + rect.x1) / 2.0, metres(rect.y0 + rect.y1) / 2.0);
        solids.top("floor", middle, (metres(rect.width()) / 2.0, metres(rect.depth()) / 2.0));
    }
    solids.item(room).unwrap_or_else(|| unreachable_floor(room))
}

fn shorter(rect: Rect, way: &PlanOpening, room: usize) -> Rect {
    match (way.vertical, way.low == Some(room)) {
        (true, true) => Rect { x1: rect.x1 - 1, ..rect },
        (true, false) => Rect { x0: rect.x0 + 1, ..rect },
        (false, true) => Rect { y1: rect.y1 - 1, ..rect },
        (false, false) => Rect { y0: rect.y0 + 1, ..rect },
    }
}

/// The empty floor of a room without rectangles.
fn unreachable_floor(room: usize) -> Item {
    let bounds = vc_graph::Bounds::standing(Vector3::repeat(0.1));
    let object = Object::new("floor", vc_graph::Asset::default(), bounds);
    fixed(Arc::new(object), Pose::identity(), room)
}

fn ceiling(plan: &FloorPlan, room: usize, style: &Style) -> Item {
    let mut solids = Solids::new("ceiling");
    let mat = if style.wall == vc_shapes::material::WALL_CREAM { style.wall } else { vc_shapes::material::WALL_WHITE };
    for rect in &plan.rooms[room].rects {
        solids.block(
            "ceiling",
            corner(rect.x0, rect.y0, plan.ceiling),
            corner(rect.x1, rect.y1, plan.ceiling + SLAB),
            mat,
        );
    }
    solids.item(room).unwrap_or_else(|| unreachable_floor(room))
}

fn fixed(object: Arc<Object>, pose: Pose, room: usize) -> Item {
    Item { object, pose, support: Support::Built, room, states: Vec::new(), between: None, required: true }
}

impl Solids {
    fn item(self, room: usize) -> Option<Item> {
        let (object, at) = self.finish()?;
        Some(fixed(Arc::new(object), Pose::translation(at.x, at.y, at.z), room))
    }
}

/// A door or window in its opening.
fn opening(plan: &FloorPlan, opening: &PlanOpening, style: &Style, seed: Seed) -> Option<Item> {
    let class = match opening.kind {
        OpeningKind::Entrance => "main_door",
        OpeningKind::Door => "door",
        OpeningKind::BalconyDoor => "balcony_door",
        OpeningKind::Window => "window",
        OpeningKind::Passage => return None,
    };
    let hole = doorway(plan, opening);
    let (hole_x, hole_y) = (hole.width(), hole.depth());
    let thickness = metres(if opening.vertical { hole_x } else { hole_y });
    let size = Vector3::new(thickness, metres(opening.width()), opening.head - opening.sill);
    let mut made = object::generator(class)?.sized(size, style, seed.child("opening"));
    let inside = if opening.opens_high { opening.high } else { opening.low };
    let facing = match (opening.vertical, opening.opens_high) {
        (true, true) => Facing(0),
        (false, true) => Facing(1),
        (true, false) => Facing(2),
        (false, false) => Facing(3),
    };
    // It is generated with the hinge on its left, which is at the higher coordinate when it faces
    // along X, and at the lower one when it faces along Y.
    let hinge_high = matches!(facing.0, 0 | 3);
    if hinge_high == opening.hinge_low {
        made = made.mirrored();
    }
    let centre = Vector3::new(metres(hole.x0 + hole.x1) / 2.0, metres(hole.y0 + hole.y1) / 2.0, opening.sill);
    let turn = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), facing.yaw());
    let room = inside.or(opening.low).or(opening.high).unwrap_or(0);
    let mut item = fixed(Arc::new(made), Pose::from_parts(centre.into(), turn), room);
    item.between = opening.beyond(room);
    Some(item)
}
