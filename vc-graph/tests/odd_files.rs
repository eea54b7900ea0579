//! Files that are valid and odd: what they say is kept and found.
#![allow(clippy::unwrap_used)]

mod shared;

use shared::documents::{NATIVE, THESIS, VIRTUALHOME};
use vc_graph::format::{native, thesis, virtualhome};
use vc_graph::{ClassTable, Draft, Kind, NodeId, Pose, Relation, SceneBuilder};

#[test]
fn an_object_of_the_category_of_rooms_stays_an_object() {
    let classes = ClassTable::builtin();
    let text = NATIVE
        .replace(r#""class": "cup", "category": "prop""#, r#""class": "cup", "category": "room", "kind": "object""#);
    let graph = native::read(&text, &classes).unwrap();
    assert_eq!(graph.node(NodeId(4)).unwrap().kind(), Kind::Object);
    assert_eq!(native::read(&native::write(&graph), &classes).unwrap(), graph);
}

#[test]
fn a_class_written_by_hand_is_found() {
    let classes = ClassTable::builtin();
    for (spelled, asked) in [
        ("KitchenTable", "kitchen_table"),
        ("kitchentable", "table"),
        ("Odd_Thing", "Odd_Thing"),
        ("Odd_Thing", "odd thing"),
    ] {
        let text = NATIVE.replace(r#""class": "kitchen_table""#, &format!(r#""class": "{spelled}""#));
        let graph = native::read(&text, &classes).unwrap();
        assert_eq!(graph.of_class(asked), [NodeId(2)], "{spelled}, asked for as {asked}");
    }
}

#[test]
fn sitting_survives_without_the_state() {
    let classes = ClassTable::builtin();
    let text = VIRTUALHOME.replace(r#""states": ["SITTING"]"#, r#""states": []"#);
    let text = text.replace(r#""relation_type": "CLOSE""#, r#""relation_type": "SITTING""#);
    let graph = virtualhome::read(&text, &classes).unwrap();
    assert!(graph.related(NodeId(1), Relation::SittingOn).eq([NodeId(12)]));
    let again = virtualhome::read(&virtualhome::write(&graph), &classes).unwrap();
    assert!(again.edges().eq(graph.edges()));
}

#[test]
fn a_scale_survives_virtualhome() {
    let classes = ClassTable::builtin();
    let text =
        VIRTUALHOME.replace("[1, 0, 2.5]", "[1, 0.9, 2.5]").replace("[0, 0.707107, 0, 0.707107]", "[0, 0, 0, 1]");
    let text = text.replace(r#""scale": [1, 1, 1]"#, r#""scale": [2, 3, 4]"#);
    let graph = virtualhome::read(&text, &classes).unwrap();
    let again = virtualhome::read(&virtualhome::write(&graph), &classes).unwrap();
    assert_eq!(again.node(NodeId(12)).unwrap().spec().scale, graph.node(NodeId(12)).unwrap().spec().scale);
}

#[test]
fn a_thing_is_in_the_room_that_was_found_for_its_support() {
    // The table is in the kitchen by its box; the glass on its edge is not.
    let text = THESIS.replace(r#"["SM_L_Table inside Kitchen"]"#, "[]").replace("X=120 Y=-40 ", "X=240 Y=-40 ");
    let graph = thesis::read(&text, &ClassTable::builtin()).unwrap();
    assert_eq!(graph.room_of(NodeId(2)), Some(NodeId(1)));
    assert_eq!(graph.room_of(NodeId(7)), Some(NodeId(1)));
}

/// A cup of some name on a table of some name, by way of the thesis's format.
fn thesis_names(cup: &str, table: &str) -> Result<(), String> {
    let mut scene = SceneBuilder::new("names");
    let kitchen = scene.add(Draft::new("kitchen").at(Pose::identity())).unwrap();
    let below = scene.add_in(kitchen, Draft::new("table").named(table).at(Pose::identity())).unwrap();
    let above = scene.add_on(below, Draft::new("cup").named(cup).at(Pose::identity())).unwrap();
    let text = thesis::write(&scene.build());
    let again = thesis::read(&text, &ClassTable::builtin()).map_err(|e| e.to_string())?;
    let place = again.place(above).map(|p| p.at);
    if place == Some(below) { Ok(()) } else { Err(format!("on {place:?}")) }
}

#[test]
fn the_thesis_keeps_odd_names_apart() {
    let names = [
        ("cup", "table"),
        ("SM_Cup.2", "SM_Cup"),
        ("cup near sink", "table"),
        ("cup", "table inside hall"),
        (" cup ", "table"),
        ("a cup", "a table"),
        ("cup", "cup"),
        ("cup.3", "cup"),
        ("cup", "cup.3"),
    ];
    let failed: Vec<_> = names.iter().filter_map(|(a, b)| Some((a, b, thesis_names(a, b).err()?))).collect();
    assert!(failed.is_empty(), "{failed:#?}");
}
