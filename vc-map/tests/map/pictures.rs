//! Drawings.

use vc_map::picture::{Drawing, Paint};

use crate::town::riverside;

#[test]
fn a_drawing_has_all_parts_and_a_legend() {
    let (map, _) = riverside();
    let drawing = Drawing::of(&map);
    let svg = drawing.svg(2.0);
    for text in ["Station Avenue", "Quay Street", "pavement", "50 m"] {
        assert!(svg.contains(text), "{text}");
    }
    assert!(
        drawing.shapes.iter().filter(|shape| matches!(shape.paint, Paint::Fill(_))).count() >= map.buildings().len()
    );
    let part = Drawing::within(&map, [[0.0, 0.0].into(), [100.0, 100.0].into()]);
    assert!(part.shapes.len() < drawing.shapes.len() / 4);
    // A legend explains what is there, and no more.
    let explains = |drawing: &Drawing, meaning: &str| drawing.legend.iter().any(|entry| entry.meaning == meaning);
    assert!(explains(&drawing, "water") && explains(&drawing, "tram, rail"));
    let dry = Drawing::within(&map, [[600.0, 600.0].into(), [620.0, 620.0].into()]);
    assert!(!explains(&dry, "water"));
    assert_eq!(part.svg(2.0), Drawing::within(&map, [[0.0, 0.0].into(), [100.0, 100.0].into()]).svg(2.0));
}

#[test]
fn names_cannot_break_out_of_a_file() {
    let mut draft = riverside().0.draft().clone();
    draft.roads.iter_mut().for_each(|road| road.name = Some("<a href=\"x\">&\u{1}".to_owned()));
    let map = draft.build().unwrap();
    for text in [
        Drawing::of(&map).svg(1.0),
        vc_map::format::opendrive::write(&map),
        vc_map::format::sumo::write(&map, "x").edges,
    ] {
        assert!(text.contains("&lt;a href=&quot;x&quot;&gt;&amp; ") && !text.contains("<a "));
    }
}
