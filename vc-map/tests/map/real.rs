//! Real extracts of the shared data.

use std::io::Read;

use vc_map::format::{native, opendrive};
use vc_map::osm::{ImportOptions, ImportReport, OsmData};
use vc_map::{DrivingSide, MapViolation, StreetMap, Users};
use vc_testkit::{data, skipped};

type Extract = (&'static str, DrivingSide, f64, f64);

/// The extracts, with the side on which one drives there, the kilometres of lanes for through traffic that netconvert 1.26
/// makes of them, and the least share of what can be walked that is in one piece.
const EXTRACTS: [Extract; 3] = [
    ("munich_altstadt", DrivingSide::Right, 5.995, 0.97),
    ("midtown", DrivingSide::Right, 14.403, 0.88),
    ("leeds_cycleway", DrivingSide::Left, 8.110, 0.97),
];

fn extracts() -> Vec<(StreetMap, ImportReport, Extract)> {
    let read = |extract: Extract| {
        let packed = std::fs::read(data::folder()?.join("osm").join(format!("{}.osm.gz", extract.0))).ok()?;
        let mut plain = Vec::new();
        flate2::read::GzDecoder::new(packed.as_slice()).read_to_end(&mut plain).unwrap();
        let osm = OsmData::from_xml(&plain).unwrap();
        assert!(osm.bytes() <= plain.len());
        let (draft, report) = osm.draft(&ImportOptions::default()).unwrap();
        Some((draft.build().unwrap(), report, extract))
    };
    let found: Vec<_> = EXTRACTS.into_iter().filter_map(read).collect();
    if found.is_empty() {
        skipped("the extracts of the shared data are not there");
    }
    found
}

#[test]
fn lanes_are_as_long_as_netconvert_has_them_within_five_hundredths() {
    for (map, _, (name, side, kilometres, _)) in extracts() {
        assert_eq!(map.side(), side, "{name}");
        let metres =
            map.length_of(|lane, road| lane.users.any(Users::CAR | Users::BUS) && road.draft.class.is_through());
        assert!((metres / 1000.0 / kilometres - 1.0).abs() < 0.05, "{name}: {metres}");
    }
}

#[test]
fn tables_are_whole_phases_safe_and_the_core_can_be_walked() {
    for (map, report, (name, _, _, share)) in extracts() {
        for violation in map.validate() {
            // Extracts are cut, and people map crossings without marks at lights.
            let fine = matches!(
                violation,
                MapViolation::CutOff { .. }
                    | MapViolation::DeadLane { .. }
                    | MapViolation::WalkCutOff { .. }
                    | MapViolation::Unlit { .. }
            );
            assert!(fine, "{name}: {violation}");
        }
        let parts = map.walk_parts();
        let all: f64 = parts.iter().map(|(_, metres)| metres).sum();
        assert!(parts[0].1 > share * all, "{name}: {} of {all}", parts[0].1);
        assert!(report.dropped.len() > 100 && report.guessed.len() > 100);
    }
}

#[test]
fn they_are_written_and_read_and_made_again_as_the_same() {
    for ((map, report, _), (again, same, _)) in extracts().into_iter().zip(extracts()) {
        assert!(map == again && report == same);
        let text = native::write(&map);
        assert!(map.bytes() < 20 * text.len());
        let read = native::read(&text).unwrap();
        assert!(read == map && native::write(&read) == text);
        assert_eq!(opendrive::write(&read), opendrive::write(&again));
    }
}
