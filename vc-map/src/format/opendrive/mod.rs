//! OpenDRIVE 1.7 (ASAM): roads with lanes, junctions with connecting roads, signals.
//!
//! Centre lines are straight pieces, as they are in the map. A road's number is its own plus one; the movements of junctions
//! are the roads that follow, and junctions are numbered on their own. Lost are phases, lights of people, layers (all
//! is flat), the walkable network but for pavements and crossings, bays, stops, buildings and areas.

mod junctions;
mod roads;

use std::fmt::Display;

use super::xml::Xml;
use crate::{MovementId, Origin, Polyline, RoadId, StreetMap};

/// Writes a map as OpenDRIVE, in metres, radians and metres per second. Costs one pass over the map.
///
/// ```
/// use vc_map::format::opendrive;
/// use vc_map::{Control, CrossSection, MapDraft, RoadClass, Strip};
/// let mut draft = MapDraft::new("street", 0.0, 0.0);
/// let ends = [[0.0, 0.0], [100.0, 0.0]].map(|at| draft.junction(at, Control::Priority));
/// let section = CrossSection { forward: vec![Strip::driving(3.0, 8.3)], ..CrossSection::default() };
/// draft.road(ends[0], ends[1], RoadClass::Residential, section);
/// let text = opendrive::write(&draft.build()?);
/// assert!(text.contains("<road name=\"\" length=\"100.0000\" id=\"1\" junction=\"-1\""));
/// # Ok::<(), vc_map::MapError>(())
/// ```
pub fn write(map: &StreetMap) -> String {
    let mut xml = Xml::new("OpenDRIVE", &[]);
    header(map, &mut xml);
    for index in 0..map.roads().len() {
        roads::road(map, &mut xml, RoadId::of(index));
    }
    for index in 0..map.movements().len() {
        junctions::connecting_road(map, &mut xml, MovementId::of(index));
    }
    junctions::controllers(map, &mut xml);
    junctions::junctions(map, &mut xml);
    xml.finish()
}

fn header(map: &StreetMap, xml: &mut Xml) {
    let bounds = map.bounds().unwrap_or_default();
    let [south, north, west, east] = [bounds[0].y, bounds[1].y, bounds[0].x, bounds[1].x].map(Fixed);
    let name = map.name();
    let attributes: [(&str, &dyn Display); 8] = [
        ("revMajor", &1),
        ("revMinor", &7),
        ("name", &name),
        ("version", &"1.00"),
        ("north", &north),
        ("south", &south),
        ("east", &east),
        ("west", &west),
    ];
    xml.open("header", &attributes);
    let Origin { latitude, longitude } = map.origin();
    xml.text(
        "geoReference",
        &[],
        &format!("+proj=tmerc +lat_0={latitude} +lon_0={longitude} +k=1 +x_0=0 +y_0=0 +datum=WGS84 +units=m +no_defs"),
    );
    xml.close();
}

/// The number of a road in the file.
fn road_number(id: RoadId) -> usize {
    id.index() + 1
}

/// The number of a movement's connecting road in the file.
fn connecting_number(map: &StreetMap, id: MovementId) -> usize {
    map.roads().len() + 1 + id.index()
}

/// A reference line as straight pieces.
fn plan_view(xml: &mut Xml, line: &Polyline) {
    xml.open("planView", &[]);
    let mut station = 0.0;
    for pair in line.points().windows(2) {
        let length = (pair[1] - pair[0]).norm();
        let heading = line.heading(station + length / 2.0);
        let (s, x, y, hdg, length_text) =
            (Fixed(station), Fixed(pair[0].x), Fixed(pair[0].y), Fine(heading), Fixed(length));
        xml.open("geometry", &[("s", &s), ("x", &x), ("y", &y), ("hdg", &hdg), ("length", &length_text)]);
        xml.tag("line", &[]);
        xml.close();
        station += length;
    }
    xml.close();
}

/// Metres to a tenth of a millimetre.
struct Fixed(f64);

impl Display for Fixed {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{:.4}", self.0)
    }
}

/// Radians.
struct Fine(f64);

impl Display for Fine {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{:.8}", self.0)
    }
}
