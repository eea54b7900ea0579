//! GeoJSON (RFC 7946), out only: lanes, junctions, crossings, buildings, doors and areas as features with degrees of
//! longitude and latitude.

use serde_json::{Value, json};

use crate::geo::Frame;
use crate::{Point, StreetMap};

/// Writes a map as a collection of features; each has a property `kind`. Costs one pass over the map.
///
/// ```
/// use vc_map::format::geojson;
/// use vc_map::{Building, MapDraft};
/// let mut draft = MapDraft::new("house", 48.1, 11.6);
/// draft.buildings.push(Building::new(vec![[0.0, 0.0], [10.0, 0.0], [10.0, 8.0], [0.0, 8.0]], 2));
/// let text = geojson::write(&draft.build()?);
/// assert!(text.contains(r#""kind":"building""#) && text.contains(r#""type":"Polygon""#));
/// # Ok::<(), vc_map::MapError>(())
/// ```
pub fn write(map: &StreetMap) -> String {
    let frame = Frame::new(map.origin());
    let features = lanes(map, &frame).chain(junctions(map, &frame)).chain(crossings(map, &frame));
    let features = features.chain(areas(map, &frame)).chain(buildings(map, &frame)).chain(entrances(map, &frame));
    let lines: Vec<String> = features.map(|feature| feature.to_string()).collect();
    format!("{{\"type\":\"FeatureCollection\",\"features\":[\n{}\n]}}\n", lines.join(",\n"))
}

/// Longitude and latitude, to a centimetre.
fn place(frame: &Frame, point: &Point) -> [f64; 2] {
    let [latitude, longitude] = frame.degrees(point);
    [longitude, latitude].map(|degrees| (degrees * 1e7).round() / 1e7)
}

fn feature(kind: &str, coordinates: Value, properties: Value) -> Value {
    json!({"type": "Feature", "geometry": {"type": kind, "coordinates": coordinates}, "properties": properties})
}

fn line(frame: &Frame, points: &[Point]) -> Value {
    points.iter().map(|point| place(frame, point)).collect()
}

/// Rings closed, as GeoJSON wants them.
fn rings(frame: &Frame, outline: &[[f64; 2]], holes: &[Vec<[f64; 2]>]) -> Value {
    let ring = |points: &[[f64; 2]]| -> Value {
        points.iter().chain(points.first()).map(|point| place(frame, &(*point).into())).collect()
    };
    std::iter::once(ring(outline)).chain(holes.iter().map(|hole| ring(hole))).collect()
}

fn lanes<'a>(map: &'a StreetMap, frame: &'a Frame) -> impl Iterator<Item = Value> + 'a {
    map.lanes().iter().enumerate().filter_map(move |(id, lane)| {
        let road = &map.road(lane.road)?.draft;
        let users: Vec<_> = lane.users.words().collect();
        let mut properties = json!({
            "kind": "lane", "id": id, "road": lane.road, "class": road.class, "name": road.name, "strip": lane.kind,
            "users": users, "width": lane.width, "limit": lane.limit, "layer": road.layer, "source": road.source,
        });
        if let Some(sign) = lane.sign {
            properties["sign"] = json!(sign);
        }
        Some(feature("LineString", line(frame, lane.line.points()), properties))
    })
}

fn junctions<'a>(map: &'a StreetMap, frame: &'a Frame) -> impl Iterator<Item = Value> + 'a {
    map.junctions()
        .iter()
        .enumerate()
        .filter(|(_, junction)| junction.arms.len() != 2 || junction.signal.is_some())
        .map(move |(id, junction)| {
            let properties = json!({
                "kind": "junction", "id": id, "control": junction.draft.control, "arms": junction.arms.len(), "streets": streets(map, junction),
                "movements": junction.movements.len(), "source": junction.draft.source,
            });
            feature("Point", json!(place(frame, &junction.at)), properties)
        })
}

/// The number of streets that meet.
fn streets(map: &StreetMap, junction: &crate::Junction) -> usize {
    let is_street = |arm: &&crate::Arm| map.road(arm.road).is_some_and(|road| road.draft.class.is_street());
    junction.arms.iter().filter(is_street).count()
}

fn crossings<'a>(map: &'a StreetMap, frame: &'a Frame) -> impl Iterator<Item = Value> + 'a {
    map.crossings().iter().enumerate().map(move |(id, crossing)| {
        let properties = json!({"kind": "crossing", "id": id, "marks": crossing.kind, "width": crossing.width});
        feature("LineString", line(frame, crossing.line.points()), properties)
    })
}

fn areas<'a>(map: &'a StreetMap, frame: &'a Frame) -> impl Iterator<Item = Value> + 'a {
    map.areas().iter().map(move |area| {
        let properties = json!({"kind": area.kind, "name": area.name, "source": area.source});
        feature("Polygon", rings(frame, &area.outline, &area.holes), properties)
    })
}

fn buildings<'a>(map: &'a StreetMap, frame: &'a Frame) -> impl Iterator<Item = Value> + 'a {
    map.buildings().iter().enumerate().map(move |(id, building)| {
        let properties = json!({
            "kind": "building", "id": id, "use": building.kind, "name": building.name, "address": building.address,
            "height": building.height, "base": building.base, "storeys": building.storeys, "source": building.source,
        });
        feature("Polygon", rings(frame, &building.outline, &building.courts), properties)
    })
}

fn entrances<'a>(map: &'a StreetMap, frame: &'a Frame) -> impl Iterator<Item = Value> + 'a {
    map.entrances().iter().enumerate().map(move |(id, entrance)| {
        let properties =
            json!({"kind": "entrance", "id": id, "building": entrance.building, "guessed": entrance.guessed});
        feature("Point", json!(place(frame, &entrance.door)), properties)
    })
}
