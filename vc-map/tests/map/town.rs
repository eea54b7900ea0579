//! The hand-drawn town and small maps that other tests build upon.

use vc_map::osm::{ImportOptions, ImportReport, OsmData};
use vc_map::{Control, CrossSection, DrivingSide, JunctionId, MapDraft, RoadClass, StreetMap, Strip};

const RIVERSIDE: &str = include_str!("../../data/riverside.osm");

/// The example's own map.
pub(crate) fn riverside() -> (StreetMap, ImportReport) {
    import(RIVERSIDE)
}

/// The map of a text of OpenStreetMap's XML.
pub(crate) fn import(text: &str) -> (StreetMap, ImportReport) {
    let (draft, report) = OsmData::from_xml(text.as_bytes()).unwrap().draft(&ImportOptions::default()).unwrap();
    (draft.build().unwrap(), report)
}

/// Two lanes and pavements on both sides.
pub(crate) fn street(lanes: usize) -> CrossSection {
    let mut side = vec![Strip::driving(3.0, 13.9); lanes];
    side.push(Strip::pavement(2.4));
    CrossSection { forward: side.clone(), backward: side, median: 0.0 }
}

/// A crossroads of four arms of 100 m.
pub(crate) fn crossroads(control: Control, side: DrivingSide, lanes: usize) -> (StreetMap, JunctionId) {
    let mut draft = MapDraft::new("crossroads", 48.0, 11.0);
    draft.side = side;
    let middle = draft.junction([0.0, 0.0], control);
    for end in [[100.0, 0.0], [0.0, 100.0], [-100.0, 0.0], [0.0, -100.0]] {
        let end = draft.junction(end, Control::Edge);
        draft.road(end, middle, RoadClass::Secondary, street(lanes));
    }
    (draft.build().unwrap(), middle)
}

/// A grid of streets with lights at each junction, 100 m apart.
pub(crate) fn grid(size: usize) -> StreetMap {
    let mut draft = MapDraft::new("grid", 48.0, 11.0);
    let mut ids = Vec::new();
    for y in 0..size {
        for x in 0..size {
            ids.push(draft.junction([100.0 * x as f64, 100.0 * y as f64], Control::Signals));
        }
    }
    for y in 0..size {
        for x in 0..size {
            if x + 1 < size {
                draft.road(ids[y * size + x], ids[y * size + x + 1], RoadClass::Secondary, street(1));
            }
            if y + 1 < size {
                draft.road(ids[y * size + x], ids[(y + 1) * size + x], RoadClass::Residential, street(1));
            }
        }
    }
    draft.build().unwrap()
}

#[test]
fn the_town_has_what_it_was_drawn_with_and_nothing_is_wrong() {
    let (map, report) = riverside();
    assert_eq!(map.validate(), []);
    assert_eq!(map.signals().len(), 6);
    assert_eq!(map.walk_parts().len(), 1);
    assert!(map.roads().iter().any(|road| road.draft.roundabout));
    assert!(map.roads().iter().any(|road| road.draft.class == RoadClass::Tram));
    assert!(map.entrances().iter().all(|entrance| entrance.edge.is_some()));
    // A court.
    assert!(map.buildings().iter().any(|building| building.courts.len() == 1));
    assert!(report.to_string().lines().count() > 200);
}
