//! The layers of a drawing, from the ground up.

use super::legend::{
    BRIDGE, BUILDING, BUS, CYCLE, DOOR, GREEN, LOT, PARKING, PATH, PAVEMENT, RAIL, ROAD, SQUARE, STEPS, STOP, TUNNEL,
    WALL, WATER,
};
use super::{Colour, Drawing, Paint, Shape, marks};
use crate::parts::{Lane, Movement, Road};
use crate::{
    AreaKind, LaneId, Point, RoadClass, RoadDraft, RoadId, StreetMap, StripKind, Structure, Users, WalkEdgeId,
    WalkKind, WalkNodeId,
};

/// The width at which corners are drawn where nothing tells that of what they join, metres.
const CORNER: f64 = 2.0;

pub(super) fn draw(map: &StreetMap, drawing: &mut Drawing) {
    let markings = map.markings();
    areas(map, drawing);
    let mut roads: Vec<usize> = (0..map.roads().len()).collect();
    roads.sort_by_key(|index| (map.roads()[*index].draft.layer, *index));
    let below = roads.iter().filter(|index| map.roads()[**index].draft.layer < 0);
    below.for_each(|index| road(map, drawing, RoadId::of(*index)));
    corners(map, drawing, |layer| layer < 0);
    buildings(map, drawing);
    corners(map, drawing, |layer| layer >= 0);
    let mut layer = None;
    let above: Vec<usize> = roads.iter().copied().filter(|index| map.roads()[*index].draft.layer >= 0).collect();
    for (position, index) in above.iter().enumerate() {
        road(map, drawing, RoadId::of(*index));
        let this = map.roads()[*index].draft.layer;
        let last = above.get(position + 1).is_none_or(|next| map.roads()[*next].draft.layer != this);
        if last && layer != Some(this) {
            junctions(map, drawing, this);
            marks::painted(drawing, &markings, Some(this));
            layer = Some(this);
        }
    }
    marks::painted(drawing, &markings, None);
    marks::unmarked(map, drawing);
    marks::signals(map, drawing);
    points(map, drawing);
    marks::names(map, drawing);
}

/// The corners of junctions whose highest way lies on some layers, like paths where only paths meet.
fn corners(map: &StreetMap, drawing: &mut Drawing, on: impl Fn(i8) -> bool) {
    for edge in map.walk_edges() {
        let WalkKind::Corner(id) = edge.kind else { continue };
        let arms = map.junction(id).into_iter().flat_map(|junction| &junction.arms);
        let roads: Vec<&RoadDraft> = arms.filter_map(|arm| map.road(arm.road)).map(|road| &road.draft).collect();
        if roads.iter().map(|road| road.layer).max().is_some_and(&on) {
            let street = roads.iter().any(|road| road.class.is_street());
            let width = edge.ends.iter().filter_map(|node| width(map, *node)).reduce(f64::min);
            drawing.line(if street { PAVEMENT } else { PATH }, width.unwrap_or(CORNER), edge.line.points());
        }
    }
}

/// The width of the pavement or path that ends at a node, metres.
fn width(map: &StreetMap, node: WalkNodeId) -> Option<f64> {
    let lane = |id: &WalkEdgeId| match map.walk_edge(*id)?.kind {
        WalkKind::Lane(lane) => map.lane(lane),
        _ => None,
    };
    let lane = map.walk_edges_at(node).iter().find_map(lane)?;
    let section = &map.road(lane.road)?.draft.section;
    // Both directions of a path are one strip; each pavement is its own.
    let walked = section.strips().filter(|(_, strip)| strip.users.has(Users::FOOT));
    Some(if lane.kind == StripKind::Pavement { lane.width } else { walked.map(|(_, strip)| strip.width).sum() })
}

fn ring(points: &[[f64; 2]]) -> Vec<Point> {
    points.iter().map(|point| Point::from(*point)).collect()
}

fn areas(map: &StreetMap, drawing: &mut Drawing) {
    let order =
        [AreaKind::Lot, AreaKind::Green, AreaKind::Square, AreaKind::Parking, AreaKind::Platform, AreaKind::Water];
    for kind in order {
        let colour = match kind {
            AreaKind::Green => GREEN,
            AreaKind::Water => WATER,
            AreaKind::Lot => LOT,
            _ => SQUARE,
        };
        for area in map.areas().iter().filter(|area| area.kind == kind) {
            let paths = std::iter::once(&area.outline).chain(&area.holes).map(|points| ring(points)).collect();
            drawing.fill(colour, paths);
        }
    }
}

fn buildings(map: &StreetMap, drawing: &mut Drawing) {
    for building in map.buildings().iter().filter(|building| building.base < 2.5) {
        let paths: Vec<Vec<Point>> =
            std::iter::once(&building.outline).chain(&building.courts).map(|points| ring(points)).collect();
        for path in &paths {
            let closed: Vec<Point> = path.iter().chain(path.first()).copied().collect();
            drawing.line(WALL, 0.6, &closed);
        }
        drawing.fill(BUILDING, paths);
    }
}

/// A road strip by strip.
fn road(map: &StreetMap, drawing: &mut Drawing, id: RoadId) {
    let Some(road) = map.road(id) else { return };
    // Undergrounds would hide the streets above.
    if road.draft.class.is_rail() && road.draft.structure == Structure::Tunnel {
        return;
    }
    let section = &road.draft.section;
    let width = section.surface();
    if road.draft.structure == Structure::Bridge {
        // The middle of everything, pavements included, lies aside from that of the carriageway.
        let aside = (section.side_width(true) - section.side_width(false)) / 2.0 - section.shift();
        drawing.line(BRIDGE, section.width() + 1.2, road.line.offset(-map.side().sign() * aside).points());
    }
    if road.draft.class.is_street() {
        let colour = if road.draft.structure == Structure::Tunnel { TUNNEL } else { ROAD };
        let middle = road.line.part(road.cuts[0] * 0.8, road.line.length() - road.cuts[1] * 0.8);
        drawing.line(colour, width, middle.as_ref().unwrap_or(&road.line).points());
    }
    for lane in road.lanes.iter().filter_map(|id| map.lane(*id)) {
        if let Some(colour) = colour(road, lane) {
            drawing.line(colour, lane.width, lane.line.points());
        }
    }
}

/// The colour of a lane; lanes for all vehicles have that of the carriageway.
fn colour(road: &Road, lane: &Lane) -> Option<Colour> {
    match lane.kind {
        StripKind::Driving if lane.users.has(Users::CAR) => None,
        StripKind::Driving => Some(BUS),
        StripKind::Cycle => Some(CYCLE),
        StripKind::Parking => Some(PARKING),
        StripKind::Pavement => Some(PAVEMENT),
        StripKind::Verge => Some(GREEN),
        StripKind::Track => Some(RAIL),
        StripKind::Path => Some(match road.draft.class {
            RoadClass::Steps => STEPS,
            RoadClass::Cycleway => CYCLE,
            _ => PATH,
        }),
    }
}

/// The surfaces of junctions whose highest way lies on a layer: the ways over them, rails on top.
fn junctions(map: &StreetMap, drawing: &mut Drawing, layer: i8) {
    let level = |id: LaneId| map.lane(id).and_then(|lane| map.road(lane.road)).map(|road| road.draft.layer);
    let here = |movement: &&Movement| level(movement.from).max(level(movement.to)) == Some(layer);
    for (users, colour, edge) in [(Users::CAR | Users::BUS, ROAD, 0.4), (Users::TRAM, RAIL, 0.0)] {
        for movement in map.movements().iter().filter(here).filter(|movement| movement.users.any(users)) {
            let width = map.lane(movement.from).map_or(0.0, |lane| lane.width) + edge;
            let paint = Paint::Line { colour, width, dash: None, round: true };
            drawing.shapes.push(Shape { paths: vec![movement.line.points().to_vec()], paint });
        }
    }
}

fn points(map: &StreetMap, drawing: &mut Drawing) {
    for entrance in map.entrances() {
        drawing.fill(DOOR, vec![square(&entrance.door, 0.8)]);
    }
    for stop in map.stops() {
        drawing.fill(STOP, vec![square(&stop.at, 1.6)]);
    }
}

/// A square around a point.
pub(super) fn square(at: &Point, half: f64) -> Vec<Point> {
    [[-half, -half], [half, -half], [half, half], [-half, half]].map(|[x, y]| Point::new(at.x + x, at.y + y)).to_vec()
}
