//! Where on Earth a map lies.

use std::collections::BTreeSet;

use vc_map::DrivingSide;
use vc_map::osm::{Element, Reason};

use crate::town::import;

#[test]
fn tiny_ways_and_far_ones_do_not_refuse_the_file() {
    // Four millimetres, alone and between two streets.
    let at = |id: i64, east: f64| format!(r#"<node id="{id}" lat="69" lon="{:.7}"/>"#, 18.0 + east / 39_900.0);
    let nodes = at(1, 0.0) + &at(2, 0.004) + &at(3, 100.0) + &at(4, -100.0) + r#"<node id="5" lat="20" lon="18"/>"#;
    let way = |id: i64, refs: &[i64]| {
        let refs: String = refs.iter().map(|id| format!(r#"<nd ref="{id}"/>"#)).collect();
        let class = if id == 7 { "service" } else { "residential" };
        format!(r#"<way id="{id}">{refs}<tag k="highway" v="{class}"/></way>"#)
    };
    let ways = way(7, &[1, 2]) + &way(8, &[2, 3]) + &way(9, &[4, 1]) + &way(10, &[3, 5]);
    let (map, report) = import(&format!("<osm>{nodes}{ways}</osm>"));
    assert_eq!(map.roads().len(), 2);
    assert!(report.dropped.contains(&(Element::Way(7), Reason::WithinJunction)), "{report}");
    assert!(report.dropped.contains(&(Element::Way(10), Reason::TooFar)), "{report}");
    assert_eq!(map.walk_parts().len(), 1);
}

#[test]
fn a_street_over_the_date_line_is_no_longer_than_elsewhere() {
    for bounds in ["", r#"<bounds minlat="-17" minlon="179.99" maxlat="-16" maxlon="-179.99"/>"#] {
        let text = format!(
            r#"<osm>{bounds}<node id="1" lat="-16.5" lon="179.9995"/><node id="2" lat="-16.5" lon="-179.9995"/>
            <way id="1"><nd ref="1"/><nd ref="2"/><tag k="highway" v="residential"/></way></osm>"#
        );
        let (map, _) = import(&text);
        let length = map.roads()[0].line.length();
        assert!((length - 106.8).abs() < 0.5, "{length}");
        let degrees = vc_map::format::geojson::write(&map);
        assert!(
            degrees.contains("[179.999") && degrees.contains("[-179.999") && !degrees.contains("[180.000"),
            "{degrees}"
        );
    }
}

#[test]
fn a_node_far_away_does_not_bend_the_map() {
    let text = |rest: &str| {
        format!(
            r#"<osm><node id="1" lat="48" lon="11"/><node id="2" lat="48" lon="11.001"/><node id="3" lat="52.5" lon="11"/>{rest}
            <way id="1"><nd ref="1"/><nd ref="2"/><tag k="highway" v="residential"/></way></osm>"#
        )
    };
    let boundary = r#"<way id="2"><nd ref="2"/><nd ref="3"/><tag k="boundary" v="administrative"/></way>"#;
    for rest in ["", boundary] {
        let (map, _) = import(&text(rest));
        assert!((map.roads()[0].line.length() - 74.63).abs() < 0.05, "{}", map.roads()[0].line.length());
    }
}

#[test]
fn places_are_those_of_the_projection_that_other_programs_use() {
    // From PROJ, `+proj=tmerc +k=1 +ellps=WGS84` around the middle of the bounds.
    for (middle, at, expected) in [
        ([48.0, 11.0], [48.09, 11.1342], [9997.2904, 10015.9208]),
        ([53.8, -1.5], [53.7, -1.7], [-13209.2623, -11111.4535]),
        ([-16.5, 179.9], [-16.4, -179.9], [21363.8065, 11055.8097]),
        ([69.0, 18.0], [69.5, 19.5], [58644.7942, 56495.2914]),
    ] {
        let [lat, lon] = middle;
        let text = format!(
            r#"<osm><bounds minlat="{}" minlon="{lon}" maxlat="{}" maxlon="{lon}"/>
            <node id="1" lat="{}" lon="{}"/><node id="2" lat="{}" lon="{}"/>
            <way id="1"><nd ref="1"/><nd ref="2"/><tag k="highway" v="residential"/></way></osm>"#,
            lat - 1.0,
            lat + 1.0,
            at[0],
            at[1],
            at[0] + 0.001,
            at[1]
        );
        let (map, _) = import(&text);
        let found = map.roads()[0].draft.line[0];
        assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-3), "{found:?} {expected:?}");
        let features: serde_json::Value = serde_json::from_str(&vc_map::format::geojson::write(&map)).unwrap();
        let features = features["features"].as_array().unwrap();
        let back = features.iter().filter(|f| f["properties"]["kind"] == "junction").any(|f| {
            let place = &f["geometry"]["coordinates"];
            [(0, at[1]), (1, at[0])]
                .iter()
                .all(|(axis, degrees)| (place[axis].as_f64().unwrap() - degrees).abs() < 2e-7)
        });
        assert!(back, "{middle:?}");
    }
}

#[test]
fn the_side_is_known_at_places_all_over_the_world() {
    let left = [
        ("Leeds", 53.8, -1.55),
        ("Dover", 51.13, 1.31),
        ("Dublin", 53.35, -6.26),
        ("Jersey", 49.19, -2.11),
        ("Valletta", 35.9, 14.51),
        ("Nicosia", 35.17, 33.36),
        ("Tokyo", 35.68, 139.77),
        ("Sapporo", 43.06, 141.35),
        ("Naha", 26.21, 127.68),
        ("Hong Kong", 22.28, 114.16),
        ("Macau", 22.19, 113.55),
        ("Bangkok", 13.75, 100.5),
        ("Chiang Mai", 18.79, 98.98),
        ("Singapore", 1.35, 103.82),
        ("Kota Kinabalu", 5.98, 116.07),
        ("Jakarta", -6.2, 106.82),
        ("Delhi", 28.61, 77.21),
        ("Kathmandu", 27.72, 85.32),
        ("Lahore", 31.55, 74.34),
        ("Islamabad", 33.69, 73.05),
        ("Guwahati", 26.14, 91.74),
        ("Colombo", 6.93, 79.85),
        ("Sydney", -33.87, 151.21),
        ("Auckland", -36.85, 174.76),
        ("Port Moresby", -9.44, 147.18),
        ("Suva", -18.14, 178.44),
        ("Cape Town", -33.92, 18.42),
        ("Windhoek", -22.56, 17.08),
        ("Lusaka", -15.42, 28.28),
        ("Ndola", -12.97, 28.64),
        ("Nairobi", -1.29, 36.82),
        ("Kampala", 0.35, 32.58),
        ("Port Louis", -20.16, 57.5),
        ("Kingston", 17.97, -76.79),
        ("Port of Spain", 10.65, -61.51),
        ("Paramaribo", 5.85, -55.2),
        ("Georgetown", 6.8, -58.16),
        ("Nassau", 25.05, -77.35),
        ("Bridgetown", 13.1, -59.62),
    ];
    let right = [
        ("Munich", 48.14, 11.57),
        ("New York", 40.75, -73.98),
        ("Boulogne", 50.73, 1.61),
        ("Calais", 50.95, 1.86),
        ("Dieppe", 49.92, 1.08),
        ("Lhasa", 29.65, 91.1),
        ("Lubumbashi", -11.66, 27.48),
        ("Huambo", -12.78, 15.74),
        ("Kigali", -1.95, 30.06),
        ("Gitega", -3.43, 29.92),
        ("Vladivostok", 43.12, 131.9),
        ("Phnom Penh", 11.56, 104.92),
        ("Vientiane", 17.97, 102.63),
        ("Noumea", -22.27, 166.45),
        ("Port Vila", -17.73, 168.32),
        ("Busan", 35.18, 129.08),
        ("Taipei", 25.03, 121.57),
        ("Shenzhen", 22.54, 114.06),
        ("Manila", 14.6, 120.98),
        ("Hanoi", 21.03, 105.85),
        ("Luanda", -8.84, 13.23),
        ("Kinshasa", -4.32, 15.31),
        ("Antananarivo", -18.88, 47.51),
        ("Saint-Denis", -20.88, 55.45),
        ("Havana", 23.11, -82.37),
        ("Caracas", 10.48, -66.9),
        ("Miami", 25.76, -80.19),
        ("Cayenne", 4.92, -52.33),
        ("Boa Vista", 2.82, -60.67),
        ("Tehran", 35.69, 51.39),
        ("Yangon", 16.84, 96.17),
        ("Luang Prabang", 19.89, 102.13),
    ];
    let told = |(name, lat, lon): (&'static str, f64, f64)| {
        let text = format!(
            r#"<osm><node id="1" lat="{lat}" lon="{lon}"/><node id="2" lat="{}" lon="{lon}"/>
            <way id="1"><nd ref="1"/><nd ref="2"/><tag k="highway" v="residential"/></way></osm>"#,
            lat + 0.001
        );
        (name, import(&text).0.side())
    };
    let wrong = |place: &(&str, DrivingSide), side| place.1 != side;
    let lost: BTreeSet<_> =
        left.into_iter().map(told).filter(|place| wrong(place, DrivingSide::Left)).map(|(name, _)| name).collect();
    let more: BTreeSet<_> =
        right.into_iter().map(told).filter(|place| wrong(place, DrivingSide::Right)).map(|(name, _)| name).collect();
    assert_eq!((lost, more), (BTreeSet::new(), BTreeSet::new()));
}
