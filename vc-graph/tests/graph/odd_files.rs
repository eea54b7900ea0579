//! Files that are valid but odd: their content is preserved and found.
#![allow(clippy::unwrap_used)]

use vc_graph::format::{eai, native, program, read_scene, thesis, virtualhome};
use vc_graph::{ClassTable, Draft, NodeId, NodeKind, Pose, Relation, SceneBuilder};
use vc_testkit::documents::{CLASSES, GOAL, NATIVE, PROGRAM, RECORD, TASKS, THESIS, VIRTUALHOME};

#[test]
fn an_object_of_the_category_of_rooms_stays_an_object() {
    let classes = ClassTable::builtin();
    let text = NATIVE
        .replace(r#""class": "cup", "category": "prop""#, r#""class": "cup", "category": "room", "kind": "object""#);
    let graph = native::read(&text, &classes).unwrap();
    assert_eq!(graph.node(NodeId(4)).unwrap().kind(), NodeKind::Object);
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

/// A cup and a table with given names, written and read in the thesis's format.
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

#[test]
fn a_byte_order_mark_is_no_part_of_a_text() {
    let classes = ClassTable::builtin();
    let marked = |text: &str| format!("\u{feff}{text}");
    for text in [NATIVE, THESIS, VIRTUALHOME] {
        assert_eq!(read_scene(&marked(text), &classes), read_scene(text, &classes));
    }
    assert_eq!(native::read(&marked(NATIVE), &classes), native::read(NATIVE, &classes));
    assert_eq!(thesis::read(&marked(THESIS), &classes), thesis::read(THESIS, &classes));
    assert_eq!(virtualhome::read(&marked(VIRTUALHOME), &classes), virtualhome::read(VIRTUALHOME, &classes));
    assert_eq!(program::read(&marked(PROGRAM)), program::read(PROGRAM));
    assert_eq!(eai::read_record(&marked(RECORD)), eai::read_record(RECORD));
    assert_eq!(eai::read_tasks(&marked(TASKS)), eai::read_tasks(TASKS));
    assert_eq!(marked(GOAL).parse::<vc_graph::Goal>(), GOAL.parse());
    assert_eq!(
        ClassTable::parse("mine", &marked(CLASSES)).unwrap().len(),
        ClassTable::parse("mine", CLASSES).unwrap().len()
    );
}

/// The same document with the keys of its objects in alphabetical order.
fn sorted(text: &str) -> String {
    serde_json::from_str::<serde_json::Value>(text).unwrap().to_string()
}

#[test]
fn scenes_are_told_by_their_structure() {
    let classes = ClassTable::builtin();
    let read = |text: &str| read_scene(text, &classes).unwrap_or_else(|e| panic!("{e}: {text}"));
    let long = NATIVE.replace("\"name\": \"cup_1\"", &format!("\"name\": \"{}\"", "x".repeat(5000)));
    for text in [NATIVE, THESIS, VIRTUALHOME, &long] {
        assert_eq!(read(&sorted(text)), read(text));
    }
    for name in ["nodes", "edges", "virtualcity", "init_graph", "class_name"] {
        let graph = read(&THESIS.replace("Apartment_0", name));
        assert_eq!((graph.name(), graph.len()), (name, 3));
    }
    let graph = read(&NATIVE.replace("\"name\": \"flat\"", "\"name\": \"nodes\""));
    assert_eq!(graph.name(), "nodes");
}

#[test]
fn graphs_before_and_after_are_scenes() {
    let classes = ClassTable::builtin();
    let whole = virtualhome::read(VIRTUALHOME, &classes).unwrap();
    let empty = r#"{"nodes": [], "edges": []}"#;
    for text in [
        format!(r#"{{"init_graph": {VIRTUALHOME}, "final_graph": {empty}}}"#),
        format!(r#"{{"final_graph": {VIRTUALHOME}, "graph_state_list": []}}"#),
        format!(
            r#"{{"id": "file1_1", "program": ["[STANDUP]"], "final_graph": {empty}, "init_graph": {VIRTUALHOME}}}"#
        ),
    ] {
        assert_eq!(read_scene(&text, &classes).unwrap(), whole);
    }
    let error = read_scene(&RECORD.replace(r#""CLOSED""#, r#""AJAR""#), &classes).unwrap_err();
    assert_eq!(error.field, "init_graph.nodes[1].states[0]");
}

#[test]
fn what_is_odd_in_virtualhome_is_mended_or_refused() {
    let classes = ClassTable::builtin();
    let changed = |from: &str, to: &str| {
        assert!(VIRTUALHOME.contains(from), "{from}");
        virtualhome::read(&VIRTUALHOME.replace(from, to), &classes).unwrap()
    };
    let turn = r#""rotation": [0, 0.707107, 0, 0.707107]"#;
    let none = changed(turn, r#""rotation": [0, 0, 0, 0]"#);
    assert_eq!(none.node(NodeId(12)).unwrap().pose().unwrap().rotation.angle(), 0.0);
    let long = changed(turn, r#""rotation": [0, 1e6, 0, 1e6]"#);
    assert!(
        (long.node(NodeId(12)).unwrap().pose().unwrap().rotation.angle() - std::f32::consts::FRAC_PI_2).abs() < 1e-3
    );
    let small = changed("[0.7, 1.8, 0.7]", "[-0.7, 1.8, -0.7]");
    assert_eq!(
        small.node(NodeId(12)).unwrap().aabb(),
        virtualhome::read(VIRTUALHOME, &classes).unwrap().node(NodeId(12)).unwrap().aabb()
    );
    let bare = changed(r#", "scale": [1, 1, 1]"#, "");
    assert_eq!(bare, virtualhome::read(VIRTUALHOME, &classes).unwrap());
    for graph in
        [none, long, small, bare, changed("[1, 1, 1]", "[-2, 0, 1e9]"), changed("[1, 0, 2.5]", "[1, 9e6, 2.5]")]
    {
        assert_eq!(native::read(&native::write(&graph), &classes).unwrap(), graph);
        virtualhome::read(&virtualhome::write(&graph), &classes).unwrap();
        thesis::read(&thesis::write(&graph), &classes).unwrap();
    }
}

#[test]
fn what_is_odd_in_the_thesis_reads_everywhere() {
    let classes = ClassTable::builtin();
    for (from, to) in [
        ("X=1 Y=1 Z=1", "X=1e8 Y=-1 Z=0"),
        ("X=1 Y=1 Z=1", "X=1e9 Y=-1e9 Z=1e9"),
        ("X=120 Y=-40.5 Z=0", "X=9.99999999e8 Y=-1e9 Z=0"),
        ("P=0 Y=90 R=0", "P=1e9 Y=-1e9 R=1e9"),
    ] {
        let graph = thesis::read(&THESIS.replace(from, to), &classes).unwrap();
        native::read(&native::write(&graph), &classes).unwrap_or_else(|e| panic!("{e}: {to}"));
        virtualhome::read(&virtualhome::write(&graph), &classes).unwrap_or_else(|e| panic!("{e}: {to}"));
        thesis::read(&thesis::write(&graph), &classes).unwrap_or_else(|e| panic!("{e}: {to}"));
    }
}

#[test]
fn classes_of_signs_alone_are_told_apart() {
    let mut scene = SceneBuilder::new("signs");
    let ids = ["🍎", "🍐", "***"].map(|sign| scene.add(Draft::new(sign)).unwrap());
    let graph = scene.build();
    for (sign, id) in ["🍎", "🍐", "***"].into_iter().zip(ids) {
        assert_eq!(graph.of_class(sign), [id], "{sign}");
        assert_eq!(graph.label(id).to_string().parse::<vc_graph::Label>().unwrap(), graph.label(id));
    }
    let again = native::read(&native::write(&graph), &ClassTable::builtin()).unwrap();
    assert_eq!(again, graph);
}
