//! Real extracts of the shared data, with lanes that are shorter than vehicles.

use std::io::Read;

use vc_graph::Seed;
use vc_map::StreetMap;
use vc_map::osm::{ImportOptions, OsmData};
use vc_testkit::{data, skipped};
use vc_traffic::{Traffic, TrafficEvent, TrafficOptions};

use crate::grid::{trips, walks};
use crate::people::{hit, overlap};

fn extract(name: &str) -> Option<StreetMap> {
    let packed = std::fs::read(data::folder()?.join("osm").join(format!("{name}.osm.gz"))).ok()?;
    let mut plain = Vec::new();
    flate2::read::GzDecoder::new(packed.as_slice()).read_to_end(&mut plain).unwrap();
    Some(OsmData::from_xml(&plain).unwrap().draft(&ImportOptions::default()).unwrap().0.build().unwrap())
}

#[test]
fn vehicles_and_people_arrive_in_real_streets() {
    for name in ["leeds_cycleway", "midtown"] {
        let Some(map) = extract(name) else { return skipped("the extracts of the shared data are not there") };
        let demand = trips(&map, 200, 1200.0, &[0, 0, 0, 1, 4], Seed(7));
        let traffic = Traffic::new(&map, demand, &TrafficOptions::default(), Seed(1)).unwrap();
        let mut traffic = traffic.with_walks(walks(&map, 100, 1200.0, Seed(3))).unwrap();
        let (mut ended, mut lost, mut walked, mut stuck) = (0, 0, 0, Vec::new());
        for step in 0..24_000 {
            traffic.step();
            assert_eq!(overlap(traffic.people().map(|walker| walker.at)), None, "{name}, step {step}");
            assert_eq!(hit(&traffic), None, "{name}, step {step}");
            // Where lanes of different junctions lie on each other, as in Leeds, vehicles do, too.
            if name == "midtown" && step % 10 == 0 {
                assert_eq!(traffic.overlaps(), [], "{name}, step {step}");
            }
            for event in traffic.events() {
                match event {
                    TrafficEvent::Arrived { .. } | TrafficEvent::NoWay { .. } => ended += 1,
                    TrafficEvent::Lost { .. } => lost += 1,
                    TrafficEvent::Reached { .. } => walked += 1,
                    TrafficEvent::Stuck { .. } | TrafficEvent::StuckOnFoot { .. } => stuck.push(*event),
                    _ => {}
                }
            }
        }
        assert!(stuck.is_empty() && lost < 4, "{name}: {lost} {stuck:?}");
        assert_eq!((ended + lost, walked), (200, 100), "{name}");
    }
}
