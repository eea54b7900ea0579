//! OpenDRIVE, read again by its own rules.

use proptest::prelude::*;
use quick_xml::events::{BytesStart, Event};
use vc_map::format::opendrive;
use vc_map::{Control, CrossSection, DrivingSide, MapDraft, RoadClass, StreetMap, Strip, StripKind, Users};
use vc_testkit::cases;

use crate::town::crossroads;

fn number(tag: &BytesStart<'_>, name: &str) -> Option<f64> {
    let value = tag.try_get_attribute(name).unwrap()?;
    Some(value.value.parse().unwrap())
}

/// The lanes of the first road in a file: number, distance of the middle to the left of the reference line, and width, as
/// the standard lays them out: from lane 0, which lies at the offset, outward.
fn lanes(text: &str) -> Vec<(i64, f64, f64)> {
    let mut reader = quick_xml::Reader::from_str(text);
    let (mut offset, mut own, mut widths) = (0.0, 0, Vec::new());
    loop {
        match reader.read_event().unwrap() {
            Event::Start(tag) | Event::Empty(tag) => match tag.name().as_ref() {
                "laneOffset" => offset = number(&tag, "a").unwrap(),
                "lane" => own = number(&tag, "id").unwrap() as i64,
                "width" => widths.push((own, number(&tag, "a").unwrap())),
                _ => {}
            },
            Event::End(tag) if tag.name().as_ref() == "laneSection" => break,
            _ => {}
        }
    }
    let placed = |(id, width): &(i64, f64)| {
        let nearer = widths.iter().filter(|(other, _)| other * id > 0 && other.abs() < id.abs());
        let out = nearer.map(|(_, width)| width).sum::<f64>() + width / 2.0;
        (*id, offset + out * id.signum() as f64, *width)
    };
    widths.iter().map(placed).collect()
}

fn strip() -> impl Strategy<Value = Strip> {
    let kinds = [StripKind::Driving, StripKind::Cycle, StripKind::Parking, StripKind::Verge, StripKind::Pavement];
    (0usize..5, 0.5..5.0).prop_map(move |(kind, width)| {
        let users = [Users::TRAFFIC, Users::BICYCLE, Users::NONE, Users::NONE, Users::FOOT][kind];
        Strip::new(kinds[kind], width, users, 10.0)
    })
}

fn road(section: CrossSection, side: DrivingSide) -> StreetMap {
    let mut draft = MapDraft::new("road", 48.0, 11.0);
    draft.side = side;
    let ends = [[0.0, 0.0], [60.0, 80.0]].map(|at| draft.junction(at, Control::Edge));
    draft.road(ends[0], ends[1], RoadClass::Secondary, section);
    draft.build().unwrap()
}

proptest! {
    #![proptest_config(cases(200))]

    #[test]
    fn lanes_lie_where_the_map_has_them(
        forward in prop::collection::vec(strip(), 0..5),
        backward in prop::collection::vec(strip(), 0..5),
        median in prop_oneof![Just(0.0), 0.1..8.0],
        left: bool,
    ) {
        prop_assume!(!(forward.is_empty() && backward.is_empty()));
        let side = if left { DrivingSide::Left } else { DrivingSide::Right };
        let map = road(CrossSection { forward, backward, median }, side);
        let written = lanes(&opendrive::write(&map));
        let line = &map.roads()[0].line;
        for lane in map.lanes() {
            let t = line.project(&lane.line.at(lane.line.length() / 2.0)).left;
            let right = lane.forward != left;
            let there = written.iter().filter(|(id, at, width)| {
                (*id < 0) == right && (at - t).abs() < 1e-3 && (width - lane.width).abs() < 1e-3
            });
            prop_assert_eq!(there.count(), 1, "{} {:?}", t, written);
        }
    }
}

#[test]
fn links_of_a_road_with_a_median_name_the_lanes_beyond_it() {
    for side in [DrivingSide::Right, DrivingSide::Left] {
        let (map, _) = crossroads(Control::Signals, side, 1);
        let mut draft = map.draft().clone();
        draft.roads.iter_mut().for_each(|road| road.section.median = 3.0);
        let text = opendrive::write(&draft.build().unwrap());
        let sign = if side == DrivingSide::Right { "" } else { "-" };
        let (to, from) = if sign.is_empty() { ("-2", "2") } else { ("2", "-2") };
        assert_eq!(text.matches(&format!("<laneLink from=\"{to}\"")).count(), 12, "{side:?}");
        assert!(!text.contains(&format!("<laneLink from=\"{from}\"")));
        assert_eq!(text.matches("type=\"median\"").count(), 8);
        assert_eq!(text.matches("type=\"crosswalk\"").count(), map.crossings().len());
    }
}
