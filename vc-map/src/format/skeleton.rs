//! The skeleton of places: streets, parks, buildings and their doors as a scene, which the thesis's JSON can carry.
//!
//! Streets and parks are rooms; buildings, doors and stops are things in the nearest of them. Poses are those of the map, so
//! that only maps of a few kilometres are as exact as a centimetre in them.

use std::collections::BTreeMap;

use vc_graph::format::thesis;
use vc_graph::nalgebra::Vector3;
use vc_graph::{Bounds, BoundsFrame, Draft, EditError, NodeId, Pose, SceneBuilder, SceneGraph};

use crate::{AreaKind, Point, StopKind, StreetMap};

/// The scene of a map's places: a room for each named street and each green area, in them the buildings with their doors,
/// and stops. A map without named streets has one room.
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
    let rooms = rooms(map, &mut scene)?;
    let nearest = |at: &Point| {
        let by = |(other, _): &&(Point, NodeId)| (other - at).norm();
        rooms.iter().min_by(|a, b| by(a).total_cmp(&by(b))).map(|(_, id)| *id)
    };
    let mut nodes = Vec::new();
    for building in map.buildings() {
        let (middle, half) = middle(&building.outline);
        let height = (building.height - building.base) as f32;
        let mut draft = Draft::new("building").at(pose(&middle, building.base)).bounds(Bounds {
            offset: Vector3::new(0.0, 0.0, height / 2.0),
            half: Vector3::new(half[0] as f32, half[1] as f32, height / 2.0),
            frame: BoundsFrame::Object,
        });
        if let Some(name) = building.name.as_ref().or(building.address.as_ref()) {
            draft = draft.named(name.as_str());
        }
        let street = nearest(&middle);
        nodes.push(match street {
            Some(room) => scene.add_in(room, draft)?,
            None => scene.add(draft)?,
        });
    }
    for entrance in map.entrances() {
        if let Some(room) = nearest(&entrance.door) {
            scene.add_in(room, Draft::new("door").at(pose(&entrance.door, 0.0)))?;
        }
    }
    for stop in map.stops().iter().filter(|stop| stop.kind == StopKind::Bus) {
        if let Some(room) = nearest(&stop.at) {
            scene.add_in(room, Draft::new("bus_stop").at(pose(&stop.at, 0.0)))?;
        }
    }
    Ok(scene.build())
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
    let mut streets: BTreeMap<&str, &crate::Road> = BTreeMap::new();
    for road in map.roads() {
        let Some(name) = road.draft.name.as_deref() else { continue };
        let longest = streets.entry(name).or_insert(road);
        if road.line.length() > longest.line.length() {
            *longest = road;
        }
    }
    let mut rooms = Vec::new();
    for (name, road) in streets {
        let at = road.line.at(road.line.length() / 2.0);
        rooms.push((at, scene.add(Draft::new("street").named(name).at(pose(&at, 0.0)))?));
    }
    for area in map.areas().iter().filter(|area| area.kind == AreaKind::Green) {
        let (at, _) = middle(&area.outline);
        let draft = Draft::new("garden").at(pose(&at, 0.0));
        rooms.push((
            at,
            scene.add(match &area.name {
                Some(name) => draft.named(name.as_str()),
                None => draft,
            })?,
        ));
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
