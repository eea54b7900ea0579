//! The skeleton of places: streets, parks, buildings and their doors as a scene, which the thesis's JSON can carry.
//!
//! Streets and parks are rooms; buildings, doors and stops of buses and trams are things in the nearest of them. Poses are those
//! of the map, so that only maps of a few kilometres are as exact as a centimetre in them.

use vc_graph::format::thesis;
use vc_graph::nalgebra::Vector3;
use vc_graph::{Bounds, BoundsFrame, Draft, EditError, NodeId, Pose, SceneBuilder, SceneGraph};

use crate::index::PointIndex;
use crate::{AreaKind, Building, Point, StopKind, StreetMap};

/// The scene of a map's places: a room for each named street and each green area, in them the buildings with their doors,
/// and stops of buses and trams; for those of trains there is no class. A map without named streets has one room. Costs a
/// look-up among the rooms for each thing.
///
/// ```
/// use vc_map::format::skeleton;
/// use vc_map::{Building, MapDraft};
/// let mut draft = MapDraft::new("house", 48.1, 11.6);
/// draft.buildings.push(Building::new(vec![[0.0, 0.0], [10.0, 0.0], [10.0, 8.0], [0.0, 8.0]], 2));
/// let scene = skeleton::scene(&draft.build()?)?;
/// assert_eq!(scene.nodes().map(|node| node.label().to_string()).collect::<Vec<_>>(), ["street.1", "building.2"]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`EditError`] if the numbers of nodes are used up.
pub fn scene(map: &StreetMap) -> Result<SceneGraph, EditError> {
    let mut scene = SceneBuilder::new(map.name());
    let rooms = Rooms::new(rooms(map, &mut scene)?);
    let mut add =
        |at: &Point, draft: Draft| rooms.nearest(at).map_or(Ok(()), |room| scene.add_in(room, draft).map(drop));
    for building in map.buildings() {
        let (at, draft) = block(building);
        add(&at, draft)?;
    }
    for entrance in map.entrances() {
        add(&entrance.door, Draft::new("door").at(pose(&entrance.door, 0.0)))?;
    }
    // A shelter beside the street is of one class, whether for buses or for trams.
    for stop in map.stops().iter().filter(|stop| stop.kind != StopKind::Train) {
        add(&stop.at, named(Draft::new("bus_stop").at(pose(&stop.at, 0.0)), stop.name.as_ref()))?;
    }
    Ok(scene.build())
}

/// A building as a box, and its middle.
fn block(building: &Building) -> (Point, Draft) {
    let (middle, half) = middle(&building.outline);
    let height = (building.height - building.base).max(0.0) as f32;
    let bounds = Bounds {
        offset: Vector3::new(0.0, 0.0, height / 2.0),
        half: Vector3::new(half[0] as f32, half[1] as f32, height / 2.0),
        frame: BoundsFrame::Object,
    };
    let draft = Draft::new("building").at(pose(&middle, building.base)).bounds(bounds);
    (middle, named(draft, building.name.as_ref().or(building.address.as_ref())))
}

fn named(draft: Draft, name: Option<&String>) -> Draft {
    match name {
        Some(name) => draft.named(name.as_str()),
        None => draft,
    }
}

/// Rooms by their places.
struct Rooms {
    rooms: Vec<(Point, NodeId)>,
    index: PointIndex,
}

impl Rooms {
    fn new(rooms: Vec<(Point, NodeId)>) -> Self {
        let index = PointIndex::of_points(rooms.iter().map(|(at, _)| at));
        Self { rooms, index }
    }

    /// The room that is nearest to a point, the first of several.
    fn nearest(&self, at: &Point) -> Option<NodeId> {
        let mut best: Option<(f64, u32)> = None;
        self.index.around(at, f64::INFINITY, |room| {
            let found = ((self.rooms[room as usize].0 - at).norm(), room);
            best = Some(best.filter(|known| *known <= found).unwrap_or(found));
            best.map_or(f64::INFINITY, |(away, _)| away)
        });
        best.map(|(_, room)| self.rooms[room as usize].1)
    }
}

/// The skeleton as the thesis's scene JSON.
///
/// # Errors
/// As [`scene`].
pub fn write(map: &StreetMap) -> Result<String, EditError> {
    Ok(thesis::write(&scene(map)?))
}

/// A room for each street name, in the middle of its longest road, and for each green area.
fn rooms(map: &StreetMap, scene: &mut SceneBuilder) -> Result<Vec<(Point, NodeId)>, EditError> {
    let mut rooms = Vec::new();
    for (name, road) in map.named() {
        let at = road.line.at(road.line.length() / 2.0);
        rooms.push((at, scene.add(Draft::new("street").named(name).at(pose(&at, 0.0)))?));
    }
    for area in map.areas().iter().filter(|area| area.kind == AreaKind::Green) {
        let (at, _) = middle(&area.outline);
        rooms.push((at, scene.add(named(Draft::new("garden").at(pose(&at, 0.0)), area.name.as_ref()))?));
    }
    if rooms.is_empty() {
        rooms.push((Point::origin(), scene.add(Draft::new("street"))?));
    }
    Ok(rooms)
}

fn pose(at: &Point, z: f64) -> Pose {
    Pose::translation(at.x as f32, at.y as f32, z as f32)
}

/// The middle of the box around a ring, and half its sides.
fn middle(ring: &[[f64; 2]]) -> (Point, [f64; 2]) {
    let ends = [0, 1].map(|axis| {
        let values = || ring.iter().map(|point| point[axis]);
        (values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max))
    });
    let [(left, right), (low, high)] = ends;
    (Point::new((left + right) / 2.0, (low + high) / 2.0), [(right - left) / 2.0, (high - low) / 2.0])
}
