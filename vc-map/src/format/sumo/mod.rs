//! SUMO's plain XML: files from which netconvert makes a network.
//!
//! Nodes, edges, connections and traffic lights follow SUMO's documentation ("Plain XML Network Descriptions"). Edges are
//! `r3` along a road's line and `-r3` against it; lanes are counted from the outer edge; signals are `t7` at node `j7`.

mod connections;
mod edges;
mod lights;

use std::fmt::Display;

use vc_graph::portable::Portable;

use super::xml::Xml;
use crate::parts::Junction;
use crate::{Control, DrivingSide, JunctionId, LaneId, RoadDraft, SignKind, StreetMap};

/// The files of a network for netconvert.
///
/// ```
/// use vc_map::format::sumo;
/// use vc_map::{Control, CrossSection, MapDraft, RoadClass, Strip};
/// let mut draft = MapDraft::new("street", 0.0, 0.0);
/// let ends = [[0.0, 0.0], [100.0, 0.0]].map(|at| draft.junction(at, Control::Priority));
/// let section = CrossSection { forward: vec![Strip::driving(3.0, 8.3)], ..CrossSection::default() };
/// draft.road(ends[0], ends[1], RoadClass::Residential, section);
/// let files = sumo::write(&draft.build()?, "street");
/// assert!(files.edges.contains(r#"<edge id="r0" from="j0" to="j1""#));
/// # Ok::<(), vc_map::MapError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct SumoFiles {
    /// `NAME.nod.xml`.
    pub nodes: String,
    /// `NAME.edg.xml`.
    pub edges: String,
    /// `NAME.con.xml`: connections and crossings.
    pub connections: String,
    /// `NAME.tll.xml`: traffic lights.
    pub lights: String,
    /// `NAME.netccfg`: `netconvert -c NAME.netccfg` makes `NAME.net.xml` of the others.
    pub config: String,
}

impl SumoFiles {
    /// The files with the ends of their names.
    pub fn all(&self) -> [(&'static str, &str); 5] {
        let Self { nodes, edges, connections, lights, config } = self;
        [("nod.xml", nodes), ("edg.xml", edges), ("con.xml", connections), ("tll.xml", lights), ("netccfg", config)]
    }
}

/// Writes a map for netconvert, into files of a name. Lost are buildings, areas, stops, bays, verges, heights and the lines of
/// movements other than those around a mini-roundabout: netconvert makes its own, and works out from classes, slip roads and the
/// kind of a junction who gives way; where signs or a mini-roundabout tell, it is told.
/// Private roads are open to vehicles that SUMO calls private and to deliveries, and closed to passenger cars. Costs one pass over
/// the map; [`SumoFiles`] has an example.
pub fn write(map: &StreetMap, name: &str) -> SumoFiles {
    SumoFiles {
        nodes: nodes(map),
        edges: edges::edges(map),
        connections: connections::connections(map),
        lights: lights::lights(map),
        config: config(map, name),
    }
}

/// The name of a lane in a network that was made of these files: `r3_0`, counted from the outer edge. `None` for lanes that are not written. Costs a look
/// at the lanes of its road.
///
/// ```
/// # use vc_map::format::sumo;
/// # use vc_map::{Control, CrossSection, LaneId, MapDraft, RoadClass, Strip};
/// # let mut draft = MapDraft::new("street", 0.0, 0.0);
/// # let ends = [[0.0, 0.0], [100.0, 0.0]].map(|at| draft.junction(at, Control::Priority));
/// # let side = vec![Strip::driving(3.0, 8.3), Strip::pavement(2.0)];
/// # draft.road(ends[0], ends[1], RoadClass::Residential, CrossSection { forward: side.clone(), backward: side, median: 0.0 });
/// # let map = draft.build()?; // a street with a lane and a pavement each way
/// let names = [0, 1, 2, 3].map(|lane| sumo::lane_name(&map, LaneId(lane)).unwrap_or_default());
/// assert_eq!(names, ["r0_1", "r0_0", "-r0_1", "-r0_0"]);
/// # Ok::<(), vc_map::MapError>(())
/// ```
pub fn lane_name(map: &StreetMap, lane: LaneId) -> Option<String> {
    let (road, forward, number) = edges::number(map, lane)?;
    Some(format!("{}_{number}", edges::name(road, forward)))
}

fn nodes(map: &StreetMap) -> String {
    let mut xml = Xml::new("nodes", &[]);
    for (index, junction) in map.junctions().iter().enumerate().filter(|(_, junction)| !junction.arms.is_empty()) {
        let id = JunctionId::of(index);
        let (x, y) = (Metres(junction.at.x), Metres(junction.at.y));
        let kind = match junction.draft.control {
            Control::Signals if junction.signal.is_some() => "traffic_light",
            Control::AllWayStop => "allway_stop",
            // Vehicles that wait for each other in a ring go on at a junction of this kind, whoever gives way to whom.
            Control::MiniRoundabout => "right_before_left",
            Control::Priority if stops(map, junction) => "priority_stop",
            Control::Priority if is_equal(map, junction) => "right_before_left",
            _ => "priority",
        };
        let name = NodeName(id);
        let mut attributes: Vec<(&str, &dyn Display)> = vec![("id", &name), ("x", &x), ("y", &y), ("type", &kind)];
        let light = LightName(id);
        if kind == "traffic_light" {
            attributes.push(("tl", &light));
        }
        let shape = (junction.draft.control == Control::MiniRoundabout).then(|| circle(map, junction));
        attributes.extend(shape.as_ref().map(|shape| ("shape", shape as &dyn Display)));
        xml.tag("node", &attributes);
    }
    xml.finish()
}

/// A circle as far around a junction as its nearest arm ends: netconvert makes a junction too small for those who go around.
fn circle(map: &StreetMap, junction: &Junction) -> String {
    let roads = junction.arms.iter().filter_map(|arm| Some((arm, map.road(arm.road)?)));
    let cut = roads.map(|(arm, road)| road.cuts[usize::from(!arm.start)]).fold(f64::INFINITY, f64::min);
    let corner = |step: u8| {
        let (sine, cosine) = (f64::from(step) * std::f64::consts::TAU / 16.0).sine_cosine();
        format!("{},{}", Metres(junction.at.x + cut * cosine), Metres(junction.at.y + cut * sine))
    };
    (0..16).map(corner).collect::<Vec<_>>().join(" ")
}

/// The signs at a junction.
fn signs<'a>(map: &'a StreetMap, junction: &'a Junction) -> impl Iterator<Item = SignKind> + 'a {
    let lanes = junction.movements.iter().filter_map(|id| map.lane(map.movement(*id)?.from));
    lanes.filter_map(|lane| lane.sign)
}

/// Whether all who have to give way at a junction have to stop.
fn stops(map: &StreetMap, junction: &Junction) -> bool {
    signs(map, junction).min() == Some(SignKind::Stop)
}

/// Whether the streets that meet are equal, so that one gives way to the right. SUMO has the rule for traffic on the right.
fn is_equal(map: &StreetMap, junction: &Junction) -> bool {
    let roads = junction.arms.iter().filter_map(|arm| map.road(arm.road));
    let streets: Vec<&RoadDraft> = roads.map(|road| &road.draft).filter(|road| road.class.is_street()).collect();
    let equal = |pair: &[&RoadDraft]| {
        (pair[0].class, pair[0].slip, pair[0].roundabout) == (pair[1].class, pair[1].slip, pair[1].roundabout)
    };
    map.side() == DrivingSide::Right && streets.len() > 2 && streets.windows(2).all(equal)
}

fn config(map: &StreetMap, name: &str) -> String {
    let mut xml = Xml::new("configuration", &[]);
    let mut value = |key: &str, value: &str| xml.tag(key, &[("value", &value)]);
    value("node-files", &format!("{name}.nod.xml"));
    value("edge-files", &format!("{name}.edg.xml"));
    value("connection-files", &format!("{name}.con.xml"));
    value("tllogic-files", &format!("{name}.tll.xml"));
    value("output-file", &format!("{name}.net.xml"));
    // Our connections are all that there are.
    value("no-turnarounds", "true");
    value("offset.disable-normalization", "true");
    if map.side() == DrivingSide::Left {
        value("lefthand", "true");
    }
    xml.finish()
}

/// Metres to the centimetre.
struct Metres(f64);

impl Display for Metres {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{:.2}", self.0)
    }
}

/// The name of a node.
struct NodeName(JunctionId);

impl Display for NodeName {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "j{}", self.0.0)
    }
}

/// The name of a traffic light.
struct LightName(JunctionId);

impl Display for LightName {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "t{}", self.0.0)
    }
}
