//! Real extracts of the shared data.

use std::collections::BTreeMap;
use std::io::Read;

use vc_map::format::{native, opendrive};
use vc_map::osm::{ImportOptions, ImportReport, OsmData};
use vc_map::{Control, DrivingSide, MapViolation, StreetMap, Users, WalkNodeId};
use vc_testkit::{data, skipped};

type Extract = (&'static str, DrivingSide, f64);

/// The extracts, with the side on which one drives there, and the kilometres of lanes for through traffic that netconvert 1.26
/// makes of them.
const EXTRACTS: [Extract; 3] = [
    ("munich_altstadt", DrivingSide::Right, 5.995),
    ("midtown", DrivingSide::Right, 14.403),
    ("leeds_cycleway", DrivingSide::Left, 8.222),
];

fn extracts() -> Vec<(StreetMap, ImportReport, Extract, Option<[f64; 2]>)> {
    let read = |extract: Extract| {
        let packed = std::fs::read(data::folder()?.join("osm").join(format!("{}.osm.gz", extract.0))).ok()?;
        let mut plain = Vec::new();
        flate2::read::GzDecoder::new(packed.as_slice()).read_to_end(&mut plain).unwrap();
        let osm = OsmData::from_xml(&plain).unwrap();
        assert!(osm.bytes() <= plain.len());
        let (draft, report) = osm.draft(&ImportOptions::default()).unwrap();
        let map = draft.build().unwrap();
        let half = half_extent(&String::from_utf8(plain).unwrap());
        Some((map, report, extract, half))
    };
    let found: Vec<_> = EXTRACTS.into_iter().filter_map(read).collect();
    if found.is_empty() {
        skipped("the extracts of the shared data are not there");
    }
    found
}

/// Half of the width and of the height of the bounds that a file names, metres: the middle of a map is theirs.
fn half_extent(text: &str) -> Option<[f64; 2]> {
    let (_, bounds) = text.split_once("<bounds ")?;
    let degrees = |key: &str| bounds.split_once(key)?.1.split('"').nth(1)?.parse::<f64>().ok();
    let [south, north] = [degrees("minlat")?, degrees("maxlat")?];
    let [west, east] = [degrees("minlon")?, degrees("maxlon")?];
    let metres = 6_371_000.0_f64.to_radians() / 2.0;
    Some([(east - west) * metres * south.to_radians().cos(), (north - south) * metres])
}

/// Whether a part of the walkable network goes on beyond the extract: it reaches the map's edge or lies over the bounds.
fn goes_on_beyond(map: &StreetMap, part: &[WalkNodeId], half: Option<[f64; 2]>) -> bool {
    part.iter().any(|id| {
        let node = &map.walk_nodes()[id.index()];
        let edge = map.junction(node.junction).is_some_and(|junction| junction.draft.control == Control::Edge);
        edge || half.is_some_and(|[x, y]| node.at.x.abs() > x || node.at.y.abs() > y)
    })
}

#[test]
fn lanes_are_as_long_as_netconvert_has_them_within_five_hundredths() {
    for (map, _, (name, side, kilometres), _) in extracts() {
        assert_eq!(map.side(), side, "{name}");
        let metres =
            map.length_of(|lane, road| lane.users.any(Users::CAR | Users::BUS) && road.draft.class.is_through());
        assert!((metres / 1000.0 / kilometres - 1.0).abs() < 0.05, "{name}: {metres}");
    }
}

#[test]
fn tables_are_whole_phases_safe_and_the_core_can_be_walked() {
    for (map, report, (name, ..), half) in extracts() {
        let mut kinds: BTreeMap<&str, usize> = BTreeMap::new();
        for violation in map.validate() {
            // Extracts are cut, people map crossings without marks at lights, houses over streets without saying how, doors
            // between houses, and bus stations lane by lane. Stubs of paths in Munich and pavements in Leeds end in junctions.
            let fine = matches!(
                violation,
                MapViolation::CutOff { .. }
                    | MapViolation::DeadLane { .. }
                    | MapViolation::WalkCutOff { .. }
                    | MapViolation::Unlit { .. }
                    | MapViolation::LostCrossing { .. }
                    | MapViolation::OnStreet { .. }
                    | MapViolation::Overlap { .. }
                    | MapViolation::DoorWalledIn { .. }
            );
            *kinds.entry(violation.kind()).or_default() += usize::from(!fine);
        }
        kinds.retain(|_, count| *count > 0);
        let known: &[(&str, usize)] = match name {
            "munich_altstadt" => &[("pavement in a lane", 6)],
            // Kerbs are mapped nearer to each other, or more to one side, than the lanes by rule are.
            "midtown" => &[("crossing ends in its road", 5)],
            "leeds_cycleway" => {
                &[("crossing ends in its road", 8), ("no crossing at lights", 1), ("pavement in a lane", 6)]
            }
            _ => &[],
        };
        assert_eq!(kinds, known.iter().copied().collect(), "{name}");
        // The core is in one piece but for ways that meet no other in the file: in Midtown flights of steps below the ground,
        // in Leeds an alley, a path through a building site and three metres between lanes for bicycles.
        let parts = map.walk_parts();
        let core: f64 = parts[0].1;
        let apart = parts[1..].iter().filter(|(nodes, _)| !goes_on_beyond(&map, nodes, half));
        let apart: f64 = apart.map(|(_, metres)| metres).sum();
        assert!(apart < 0.025 * core, "{name}: {apart} m beside {core} m");
        assert!(report.dropped.len() > 100 && report.guessed.len() > 100);
    }
}

#[test]
fn they_are_written_and_read_and_made_again_as_the_same() {
    for ((map, report, ..), (again, same, ..)) in extracts().into_iter().zip(extracts()) {
        assert!(map == again && report == same);
        let text = native::write(&map);
        assert!(map.bytes() < 20 * text.len());
        let read = native::read(&text).unwrap();
        assert!(read == map && native::write(&read) == text);
        assert_eq!(opendrive::write(&read), opendrive::write(&again));
    }
}
