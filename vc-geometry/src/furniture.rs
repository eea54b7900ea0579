//! Furniture and things that are carried: boards, surfaces, hollows.

use nalgebra::Vector3;
use vc_graph::asset::{Hold, Part};
use vc_graph::class::SlotKind;
use vc_graph::{Anthropometry, Asset, Node, Property, SceneGraph};

use crate::block::{Block, part};
use crate::form::{self, Form};
use crate::level::{self, Level, Load};

/// Thickness of boards, metres, and as a part of the least side at most.
const BOARD: f32 = 0.02;
const SLIM: f32 = 0.1;
/// Least thickness of a board, metres: where a drawer is full.
const THIN: f32 = 0.002;
/// Width of legs, metres, and thickness of the backs of seats.
const LEG: f32 = 0.05;
const BACK: f32 = 0.08;
/// How far below the top of a thing's box its surface may be, metres: taps, rims and pillows are part
/// of the box.
const SUNK: f32 = 0.25;
/// Height between shelves where nothing stands, metres.
const SHELF: f32 = 0.4;
/// The greatest number of shelves: in a case of more than 25 metres they are farther apart.
const SHELVES: f32 = 64.0;
/// A level this far above a board is on that board, metres.
const LOW: f32 = 0.08;
/// Room above the things on the highest shelf, metres.
const HEADROOM: f32 = 0.05;

/// Builds the form that a node's class and its load ask for.
pub(crate) fn build(graph: &SceneGraph, node: &Node, block: &Block, asset: &mut Asset) {
    let loads = level::loads(graph, node, block);
    let (form, level) = form::form_of(graph, node).unwrap_or_else(|| (by_affordance(node, &loads), None));
    let carries = node.affords(Property::Surface) || loads.iter().any(|l| !l.inside);
    let top = || level::top(&loads, block.high.z - SUNK.min(block.size().z / 2.0)).unwrap_or(block.high.z);
    match form {
        Form::Solid if carries => slab(block, top().min(block.high.z), asset),
        Form::Solid => asset.parts.push(block.whole("body")),
        Form::Table => table(block, &loads, top().min(block.high.z), asset),
        Form::Slab => slab(block, seat_level(block, &loads, level), asset),
        Form::Seat => seat(block, seat_level(block, &loads, level), asset),
        Form::Basin => basin(block, asset),
        Form::Case => case(block, &loads, top().min(block.high.z), carries, asset),
    }
}

/// The form of a node whose class the table does not have.
fn by_affordance(node: &Node, loads: &[Load]) -> Form {
    let holds = |kind: SlotKind| node.spec().slots.iter().any(|s| s.kind == kind);
    let carried = node.affords(Property::Graspable);
    let laden = loads.iter().any(|l| !l.inside) && !loads.iter().any(|l| l.inside);
    let contains = node.affords(Property::Container);
    let vessel = contains || node.affords(Property::Recipient) && !node.affords(Property::Surface);
    match (carried, contains) {
        (true, _) if vessel && !laden => Form::Basin,
        (false, true) if holds(SlotKind::Basin) => Form::Basin,
        (false, true) => Form::Case,
        _ => Form::Solid,
    }
}

/// The height at which one sits or lies: that at which things lie on it, else the class's, metres.
fn seat_level(block: &Block, loads: &[Load], level: Option<f32>) -> f32 {
    let most = block.high.z.min(block.low.z + level.unwrap_or(f32::INFINITY));
    let lowest = loads.iter().map(|l| l.bottom).find(|b| *b > block.low.z + 0.5 * (most - block.low.z));
    lowest.map_or(most, |b| b.min(block.high.z))
}

fn thickness(block: &Block) -> f32 {
    BOARD.min(SLIM * block.size().min())
}

/// A box up to a level.
fn slab(block: &Block, level: f32, asset: &mut Asset) {
    asset.parts.push(block.up_to("body", level));
    asset.surfaces.push(block.surface("top", Hold::On, level, 0.0, None));
}

/// A board between two corners of the block, its top at a height.
fn board(block: &Block, name: &str, top: f32, thick: f32) -> Part {
    let low = (top - thick).max(block.low.z);
    part(name, Vector3::new(block.low.x, block.low.y, low), Vector3::new(block.high.x, block.high.y, top))
}

/// Four legs up to a height.
fn legs(block: &Block, top: f32) -> Vec<Part> {
    let wide = LEG.min(block.size().x / 4.0).min(block.size().y / 4.0);
    let leg = |(right, back): (bool, bool)| {
        let (mut low, mut high) = (block.low, block.high);
        if right {
            low.x = high.x - wide
        } else {
            high.x = low.x + wide
        }
        if back {
            low.y = high.y - wide
        } else {
            high.y = low.y + wide
        }
        high.z = top;
        part("leg", low, high)
    };
    let corners = [(false, false), (false, true), (true, false), (true, true)];
    if top - block.low.z < BOARD { Vec::new() } else { corners.map(leg).to_vec() }
}

/// A board on legs, and boards below where things stand there.
fn table(block: &Block, loads: &[Load], top: f32, asset: &mut Asset) {
    let thick = (2.0 * BOARD).min((top - block.low.z) / 4.0);
    asset.parts.extend(legs(block, top - thick));
    asset.parts.push(board(block, "top", top, thick));
    asset.surfaces.push(block.surface("top", Hold::On, top, 0.0, None));
    let mut roof = top - thick;
    for Level { at, inside } in level::levels(loads, block.low.z, roof - LOW).into_iter().rev() {
        let hold = if inside { Hold::Inside } else { Hold::On };
        asset.surfaces.push(block.surface("shelf", hold, at, 0.0, Some(roof - at)));
        asset.parts.push(board(block, "shelf", at, thickness(block)));
        roof = at - thickness(block);
    }
}

/// A seat on legs and a back, its front along X.
fn seat(block: &Block, level: f32, asset: &mut Asset) {
    let thick = (2.0 * LEG).min((level - block.low.z) / 2.0);
    asset.parts.extend(legs(block, level - thick));
    asset.parts.push(board(block, "seat", level, thick));
    let mut before = *block;
    if block.high.z - level > LEG {
        let depth = BACK.min(block.size().x / 4.0);
        before.low.x += depth;
        let (low, high) = (block.low, Vector3::new(before.low.x, block.high.y, block.high.z));
        asset.parts.push(part("back", Vector3::new(low.x, low.y, level), high));
    }
    asset.surfaces.push(before.surface("seat", Hold::On, level, 0.0, None));
}

/// A floor and four walls.
fn basin(block: &Block, asset: &mut Asset) {
    let wall = thickness(block);
    let floor = block.low.z + wall;
    asset.parts.push(block.up_to("floor", floor));
    asset.parts.extend((0..4).map(|side| wall_of(block, side, wall, floor, block.high.z)));
    asset.surfaces.push(block.surface("floor", Hold::Inside, floor, wall, Some(block.high.z - floor)));
}

/// One of the four walls of a block: at -X, +X, -Y, +Y.
fn wall_of(block: &Block, side: usize, thick: f32, from: f32, to: f32) -> Part {
    let (axis, upper) = (side / 2, side % 2 == 1);
    let (mut low, mut high) = (block.low, block.high);
    if upper {
        low[axis] = high[axis] - thick
    } else {
        high[axis] = low[axis] + thick
    }
    (low.z, high.z) = (from, to);
    part("wall", low, high)
}

/// Boards around a hollow with shelves, open at its front.
fn case(block: &Block, loads: &[Load], top: f32, carries: bool, asset: &mut Asset) {
    let thick = thickness(block);
    let contents = || loads.iter().filter(|l| l.inside);
    // Walls are as thin as the contents ask for.
    let side = contents().map(|l| l.margin).fold(thick, f32::min).max(THIN);
    let lowest = contents().map(|l| l.bottom - THIN).fold(block.low.z + thick, f32::min);
    let floor = lowest.max(block.low.z + THIN);
    let highest = contents().map(|l| l.top + THIN).fold(top - thick, f32::max);
    let roof = highest.min(top - THIN).max(floor);
    asset.parts.extend([block.up_to("floor", floor), board(block, "top", top, top - roof)]);
    asset.parts.extend([0, 2, 3].map(|at| wall_of(block, at, side, floor, roof)));
    let base = block.pose.translation.z;
    if carries {
        asset.surfaces.push(block.surface("top", Hold::On, top, 0.0, None));
    }
    let levels = shelves(loads, floor, roof, carries && base + top > Anthropometry::ADULT.shelf, base);
    for (index, Level { at, inside }) in levels.iter().enumerate() {
        let next = levels.get(index + 1).map_or(roof, |next| next.at - thick);
        let hold = if *inside { Hold::Inside } else { Hold::On };
        asset.surfaces.push(block.surface("shelf", hold, *at, side, Some((next - at).max(THIN))));
        if index > 0 {
            asset.parts.push(board(block, "shelf", *at, thick));
        }
    }
    // Surfaces at a handy height come first.
    let far = |z: f32| (base + z - Anthropometry::ADULT.handy).abs();
    asset.surfaces.sort_by(|a, b| far(a.centre.z).total_cmp(&far(b.centre.z)));
}

/// The levels of a case, the floor first: where things stand, and where there is room for a shelf.
/// If the top is out of reach, things that are put on the case go on one shelf that is empty.
fn shelves(loads: &[Load], floor: f32, roof: f32, high: bool, base: f32) -> Vec<Level> {
    let on_floor = loads.iter().filter(|l| l.bottom < floor + LOW);
    let inside = loads.iter().all(|l| l.inside) || on_floor.clone().any(|l| l.inside) || on_floor.count() == 0;
    let mut found = vec![Level { at: floor, inside }];
    found.extend(level::levels(loads, floor + LOW, roof - HEADROOM));
    let free = |z: f32| loads.iter().all(|l| z < l.bottom - LOW || z > l.top + HEADROOM);
    let count = ((roof - floor) / SHELF).round().clamp(1.0, SHELVES);
    for step in 1..count as usize {
        let at = floor + (roof - floor) * step as f32 / count;
        if free(at) && found.iter().all(|l| (l.at - at).abs() > SHELF / 2.0) {
            found.push(Level { at, inside: true });
        }
    }
    found.sort_by(|a, b| a.at.total_cmp(&b.at));
    let empty = |l: &Level| l.inside && !loads.iter().any(|load| load.inside && (load.bottom - l.at).abs() < LOW);
    if high && found.iter().all(|l| l.inside) && found.len() > 1 {
        let far = |l: &Level| (base + l.at - Anthropometry::ADULT.handy).abs();
        let handy = found.iter_mut().filter(|l| empty(l)).min_by(|a, b| far(a).total_cmp(&far(b)));
        if let Some(level) = handy {
            level.inside = false;
        }
    }
    found
}
