//! Floating car data as SUMO writes them.

use std::fmt::Write;

use vc_graph::portable::Portable;
use vc_map::format::sumo;

use crate::{Pose, Traffic};

/// All vehicles and people on their way, step by step, as the XML that SUMO writes with `--fcd-output`: places of front bumpers in metres, angles in degrees
/// clockwise from north, speeds in metres per second, and stations on lanes. Edges and lanes have the names that they have in SUMO's files of the map
/// ([`vc_map::format::sumo`]). Ways over junctions are `:j7_3_0` by junction and position there, not by netconvert's own count.
///
/// ```
/// # use vc_graph::Seed;
/// # use vc_map::{Control, CrossSection, MapDraft, RoadClass, RoadId, Strip};
/// use vc_traffic::{Fcd, Kerb, Traffic, TrafficOptions, Trip};
/// # let mut draft = MapDraft::new("street", 48.1, 11.6);
/// # let ends = [[0.0, 0.0], [200.0, 0.0]].map(|at| draft.junction(at, Control::Priority));
/// # let section = CrossSection { forward: vec![Strip::driving(3.0, 13.9)], ..CrossSection::default() };
/// # draft.road(ends[0], ends[1], RoadClass::Residential, section);
/// # let map = draft.build()?; // a one-way street along X
/// # let kerb = |station| Kerb { road: RoadId(0), forward: true, station };
/// # let trips = vec![Trip { class: 0, departs: 0.0, from: kerb(20.0), to: kerb(150.0) }];
/// let mut traffic = Traffic::new(&map, trips, &TrafficOptions::default(), Seed(7))?;
/// let mut fcd = Fcd::new();
/// for _ in 0..20 {
///     traffic.step();
///     fcd.add(&traffic);
/// }
/// let xml = fcd.finish();
/// assert!(xml.contains(r#"<timestep time="2.00">"#) && xml.contains(r#"type="car""#) && xml.contains(r#"lane="r0_0""#));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct Fcd {
    text: String,
}

impl Default for Fcd {
    fn default() -> Self {
        Self::new()
    }
}

impl Fcd {
    /// Without steps.
    pub fn new() -> Self {
        Self { text: "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<fcd-export>\n".to_owned() }
    }

    /// Adds a step: who is on their way now. Costs some 150 bytes for each.
    pub fn add(&mut self, traffic: &Traffic) {
        // Writing to a string does not fail.
        let text = &mut self.text;
        _ = writeln!(text, "    <timestep time=\"{:.2}\">", traffic.seconds());
        for (id, pose) in traffic.vehicles() {
            let class = &traffic.classes[usize::from(pose.class)].name;
            let front = pose.front();
            let angle = degrees(pose.heading);
            let lane = lane(traffic, &pose);
            _ = writeln!(
                text,
                "        <vehicle id=\"{}\" x=\"{:.2}\" y=\"{:.2}\" angle=\"{angle:.2}\" type=\"{}\" speed=\"{:.2}\" pos=\"{:.2}\" lane=\"{lane}\" slope=\"0.00\"/>",
                id.0,
                front.x,
                front.y,
                escaped(class),
                pose.speed,
                pose.station
            );
        }
        for walker in traffic.people() {
            let ([x, y], [east, north]) = (walker.at, walker.velocity);
            let (speed, angle) = (east.hypotenuse(north), degrees(f64::from(north).angle_to(f64::from(east))));
            _ = writeln!(
                text,
                "        <person id=\"p{}\" x=\"{x:.2}\" y=\"{y:.2}\" angle=\"{angle:.2}\" speed=\"{speed:.2}\" pos=\"{:.2}\" edge=\"\" slope=\"0.00\"/>",
                walker.id.0,
                walker.station()
            );
        }
        text.push_str("    </timestep>\n");
    }

    /// The bytes so far, without the end; what is written already can be taken out by and by.
    pub fn take(&mut self) -> String {
        std::mem::take(&mut self.text)
    }

    /// The end of the document after what has not been taken.
    pub fn finish(mut self) -> String {
        self.text.push_str("</fcd-export>\n");
        self.text
    }
}

/// A heading in degrees clockwise from north.
fn degrees(heading: f64) -> f64 {
    (90.0 - heading.to_degrees()).rem_euclid(360.0)
}

fn lane(traffic: &Traffic, pose: &Pose) -> String {
    let map = traffic.map();
    let name = pose.lane.and_then(|lane| sumo::lane_name(map, lane));
    name.or_else(|| {
        let id = pose.movement?;
        let junction = map.movement(id)?.junction;
        let row = map.junction(junction)?.movements.iter().position(|other| *other == id)?;
        Some(format!(":j{}_{row}_0", junction.0))
    })
    .unwrap_or_default()
}

/// A name within an attribute.
fn escaped(name: &str) -> String {
    name.replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;")
}
