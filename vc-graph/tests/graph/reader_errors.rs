//! An invalid file is refused with line, field and expected form.
#![allow(clippy::unwrap_used)]

use vc_graph::format::{FormatError, FormatProblem, eai, native, program, read_scene, thesis, virtualhome};
use vc_graph::{ClassTable, EditError, NodeId};
use vc_testkit::documents::{CLASSES, NATIVE, PROGRAM, RECORD, TASKS, THESIS, VIRTUALHOME};

fn changed(document: &str, from: &str, to: &str) -> String {
    assert!(document.contains(from), "{from}");
    document.replacen(from, to, 1)
}

fn in_native(from: &str, to: &str) -> FormatError {
    native::read(&changed(NATIVE, from, to), &ClassTable::builtin()).unwrap_err()
}

fn in_thesis(from: &str, to: &str) -> FormatError {
    thesis::read(&changed(THESIS, from, to), &ClassTable::builtin()).unwrap_err()
}

fn in_virtualhome(from: &str, to: &str) -> FormatError {
    virtualhome::read(&changed(VIRTUALHOME, from, to), &ClassTable::builtin()).unwrap_err()
}

/// Line, field and text of an error.
fn check(error: &FormatError, line: usize, field: &str, text: &str) {
    assert_eq!((error.line, error.field.as_str()), (Some(line), field), "{error}");
    let place = format!("{}, line {line}, field `{field}`: ", error.format);
    assert!(error.to_string().starts_with(&place), "{error}");
    assert!(error.to_string().contains(text), "`{text}` is not in `{error}`");
}

#[test]
fn malformed_json() {
    check(&in_native(r#""id": 2,"#, r#""id": two,"#), 4, "nodes[1].id", "expected ident");
    check(&in_thesis(r#""id": 2,"#, r#""id": two,"#), 4, "Apartment_0[1].id", "expected ident");
    check(&in_virtualhome(r#""id": 12,"#, r#""id": "twelve","#), 4, "nodes[1].id", "invalid type: string");
    let nothing = native::read("", &ClassTable::builtin()).unwrap_err();
    assert_eq!(nothing.to_string(), "virtualcity scene, line 1: EOF while parsing a value");
}

#[test]
fn missing_and_unknown_fields() {
    check(&in_native(r#""class": "cup","#, ""), 9, "nodes[3]", "missing field `class`");
    check(&in_native(r#""contents""#, r#""content""#), 8, "nodes[3].content", "unknown field `content`");
    check(&in_virtualhome(r#""class_name": "fridge", "#, ""), 7, "nodes[1]", "missing field `class_name`");
}

#[test]
fn numbers_that_occur_twice() {
    let error = in_native(r#""id": 3"#, r#""id": 2"#);
    assert_eq!(*error.problem, FormatProblem::Edit(EditError::Duplicate(NodeId(2))));
    check(&error, 7, "nodes[2].id", "node #2 exists already");
    check(&in_thesis(r#""id": 7"#, r#""id": 1"#), 6, "Apartment_0[2].id", "node #1 exists already");
    check(&in_virtualhome(r#""id": 1,"#, r#""id": 12,"#), 8, "nodes[2].id", "node #12 exists already");
}

#[test]
fn edges_that_lead_nowhere() {
    let error = in_native(r#"[4, "on", 2]"#, r#"[4, "on", 99]"#);
    assert_eq!(*error.problem, FormatProblem::Edit(EditError::NoSuchNode(NodeId(99))));
    check(&error, 13, "edges[2]", "there is no node #99");
    check(&in_virtualhome(r#""to_id": 12}"#, r#""to_id": 99}"#), 11, "edges[1]", "there is no node #99");
    check(
        &in_thesis("supported by SM_L_Table", "supported by SM_Bench"),
        6,
        "Apartment_0[2].relation",
        "no object is called `SM_Bench`",
    );
}

#[test]
fn words_that_are_none() {
    check(
        &in_native(r#"["sitting"]"#, r#"["siting"]"#),
        7,
        "nodes[2].states[0]",
        "unknown state `siting` (did you mean `sitting`?); use one of: open closed",
    );
    check(&in_native(r#""on", 2"#, r#""onto", 2"#), 13, "edges[2][1]", "unknown relation `onto`");
    check(&in_virtualhome(r#"["CLOSED"]"#, r#"["CLOSED", "AJAR"]"#), 4, "nodes[1].states[1]", "unknown state `AJAR`");
    check(
        &in_virtualhome(r#"["CAN_OPEN","#, r#"["CAN_FLY","#),
        4,
        "nodes[1].properties[0]",
        "unknown property `CAN_FLY`",
    );
    check(
        &in_virtualhome(r#""CLOSE", "to"#, r#""ONTOP", "to"#),
        11,
        "edges[1].relation_type",
        "unknown variant `ONTOP`",
    );
    check(&in_thesis(r#"["Clean"]"#, r#"["Cleanish"]"#), 6, "Apartment_0[2].state", "unknown state `Cleanish`");
    check(
        &in_thesis("supported by", "hovers over"),
        6,
        "Apartment_0[2].relation",
        "expected a relation such as `A supported by B`",
    );
    check(
        &in_thesis("SM_Glass supported", "SM_Cup supported"),
        6,
        "Apartment_0[2].relation",
        "expected a relation of SM_Glass",
    );
}

#[test]
fn numbers_that_are_none() {
    check(&in_native("[1.5, 2, 0.75]", "[1.5, 1e39, 0.75]"), 4, "nodes[1].pose", "is not a finite number");
    check(&in_native("[0, 0, 0, 1]}", "[0, 0, 0, 0]}"), 4, "nodes[1].pose", "");
    check(&in_native("[0.5, 0.5, 0.4]", "[0.5, -0.5, 0.4]"), 4, "nodes[1].bounds", "");
    check(&in_native("[1, 2, 1]", "[1, -1e39, 1]"), 4, "nodes[1].scale", "");
    check(&in_native("[1.5, 2, 0.75]", "[1.5, 1e400, 0.75]"), 5, "nodes[1].pose.position[1]", "number out of range");
    check(&in_virtualhome("[0.7, 1.8, 0.7]", "[0.7, 1e39, 0.7]"), 4, "nodes[1].bounding_box", "is not a finite number");
    check(&in_virtualhome("[1, 0, 2.5]", "[1, 1e39, 2.5]"), 4, "nodes[1].obj_transform", "");
    for bad in ["X=NaN", "X=1e39", "X=1e400", "X=", "X=a", "Z=120", "120"] {
        let wanted = "expected `X=0 Y=0 Z=0`, found `";
        check(&in_thesis("X=120 Y=-40 ", &format!("{bad} Y=-40 ")), 6, "Apartment_0[2].transform", wanted);
    }
    for bad in ["-1, 1, 1", "1e39, 1, 1"] {
        let more = format!(r#""id": 7, "virtualcity": {{"bounds": {{"offset": [0, 0, 0], "half": [{bad}]}}}}"#);
        check(&in_thesis(r#""id": 7"#, &more), 6, "Apartment_0[2].virtualcity", "is not a finite number");
    }
    check(&in_thesis("P=0 Y=90 R=-10", "P=0 Y=90 R=-10 Q=1"), 6, "Apartment_0[2].transform", "expected `P=0 Y=0 R=0`");
    check(&in_native(r#""id": 4"#, r#""id": 4294967296"#), 8, "nodes[3].id", "invalid value");
    check(&in_native(r#""id": 4"#, r#""id": -1"#), 8, "nodes[3].id", "invalid value");
}

#[test]
fn shapes_that_are_none() {
    check(&in_native(r#""radius": 0.04"#, r#""radius": 0"#), 16, "assets[0]", "part `body` has a measure");
    check(&in_native(r#""material": 0"#, r#""material": 7"#), 16, "assets[0]", "uses material 7, the library has 1");
    check(&in_native(r#""axis": [0, 0, 1]"#, r#""axis": [0, 0, 0]"#), 16, "assets[0]", "a joint without axis");
}

#[test]
fn shapes_without_end() {
    let cylinder = r#"{"cylinder": {"radius": 0.04, "half_height": 0.05}}"#;
    for shape in [
        r#"{"lathe": {"profile": [[1e39, 0], [1, 1]]}}"#,
        r#"{"extrusion": {"outline": [[0, 0], [1e39, 0], [0, 1]], "height": 1}}"#,
        r#"{"capsule": {"radius": 1, "half_height": 1e39}}"#,
        r#"{"hull": {"points": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1e39]]}}"#,
    ] {
        let read = native::read(&changed(NATIVE, cylinder, shape), &ClassTable::builtin());
        assert!(read.is_err(), "{shape} is read");
    }
    check(&in_native(r#""limits": [0, 1.5]"#, r#""limits": [0, 1e39]"#), 16, "assets[0]", "");
}

#[test]
fn materials_that_are_none() {
    for (from, to) in
        [("[0.4, 0.3", "[1e39, 0.3"), ("700", "1e39"), ("700", "-1e39"), (r#""friction": 0.5"#, r#""friction": 1e39"#)]
    {
        check(&in_native(from, to), 14, "materials[0]", "");
    }
}

#[test]
fn newer_versions() {
    let error = in_native(r#""virtualcity": 1"#, r#""virtualcity": 2"#);
    assert_eq!(*error.problem, FormatProblem::Version(2, 1));
    assert_eq!(
        error.to_string(),
        "virtualcity scene, field `virtualcity`: version 2 is newer than this program, which reads up to 1"
    );
}

#[test]
fn a_thesis_file_has_one_environment() {
    let classes = ClassTable::builtin();
    let wanted = "thesis scene: expected one key, the environment's name, over a list of objects; found";
    assert_eq!(thesis::read("{}", &classes).unwrap_err().to_string(), format!("{wanted} 0 keys"));
    let two = r#"{"A": [], "B": []}"#;
    assert_eq!(thesis::read(two, &classes).unwrap_err().to_string(), format!("{wanted} 2 keys"));
    assert!(thesis::read(r#"{"A": [{"id": 1}], "A": []}"#, &classes).is_err());
    assert!(thesis::read(r#"{"A": [], "A": []}"#, &classes).is_err(), "the same key twice is no one key");
}

#[test]
fn read_scene_answers_as_the_format_it_looks_like() {
    let classes = ClassTable::builtin();
    for (text, format) in [
        (r#"{"virtualcity": 9}"#, "virtualcity scene"),
        (r#"{"nodes": 9}"#, "VirtualHome graph"),
        (r#"{"Flat": 9}"#, "thesis scene"),
    ] {
        assert_eq!(read_scene(text, &classes).unwrap_err().format, format);
    }
    for (text, fault) in [("# A title\n", "no scene in any known format"), ("", "empty"), (" \n", "empty")] {
        let error = read_scene(text, &classes).unwrap_err().to_string();
        assert!(error.starts_with(&format!("scene: the text is {fault}")), "{error}");
    }
}

#[test]
fn programs_say_the_line() {
    for (from, to, line, text) in [
        ("[WALK] <kitchen> (11)", "[WALK] <kitchen> (x)", 4, "is not of the form `[VERB] <class> (number)`"),
        ("[WALK] <kitchen> (11)", "[HOVER] <kitchen> (11)", 4, "unknown verb `HOVER`"),
        (
            "[SLEEP]",
            "[GRAB]",
            7,
            "`grab` takes one thing, none is given: write its class and number, as in `grab cup.12`",
        ),
        ("[SLEEP]", "sleep well", 7, "`well` names no object"),
    ] {
        let error = program::read(&changed(PROGRAM, from, to)).unwrap_err();
        assert_eq!((error.line, error.field.as_str()), (Some(line), ""));
        let shown = error.to_string();
        assert!(shown.starts_with(&format!("program, line {line}: ")) && shown.contains(text), "{shown}");
    }
}

#[test]
fn eai_data_says_the_field() {
    let record = |from, to| eai::read_record(&changed(RECORD, from, to)).unwrap_err();
    let error = record("[OPEN] <fridge> (12)", "[OPEN] <fridge>");
    assert_eq!(error.field, "program[1]");
    assert!(error.to_string().contains("`[OPEN] <fridge>` is not of the form `[VERB] <class> (number)`"), "{error}");
    check(&record(r#""from_id": 12"#, r#""from_id": -12"#), 3, "init_graph.edges[0].from_id", "invalid value");
    let task = |from, to| eai::read_tasks(&changed(TASKS, from, to)).unwrap_err();
    for (from, to, field, text) in [
        ("TOUCH|PUSH", "TOUCH|FLY", "file1_1.vh_goal", "unknown verb `FLY`"),
        (r#""state": "CLOSED""#, r#""state": "AJAR""#, "file1_1.vh_goal", "unknown state `AJAR`"),
        ("TOUCH(x0)", "TOUCH(x0, x0)", "file1_1.tl_goal", "`TOUCH` takes one thing, two are given"),
    ] {
        let error = task(from, to);
        assert_eq!(error.field, field);
        assert!(error.to_string().contains(text), "{error}");
    }
}

#[test]
fn class_tables_say_line_and_column() {
    ClassTable::parse("mine.txt", CLASSES).unwrap();
    let error = ClassTable::parse("mine.txt", &changed(CLASSES, "hook:6", "hook:0")).unwrap_err();
    assert_eq!(error.to_string(), "mine.txt, line 3, column `slots`: `hook:0` is no slot such as `drawer:3`");
}

/// A change that cannot be read is named, and what is wrong with it.
#[test]
fn changes_say_what_is_wrong() {
    let told = |text: &str| native::read_changes(text, &ClassTable::builtin()).unwrap_err().to_string();
    for (text, field, word) in [
        (r#"[{"link": {"from": 1, "relation": "onn", "to": 2}}]"#, "[0]", "onn"),
        (r#"[{"unlink": {"from": 1, "relation": "on", "to": 2}}, {"add": {"id": 3}}]"#, "[1]", "missing field"),
        (r#"[{"lnik": 3}]"#, "[0]", "lnik"),
    ] {
        let told = told(text);
        assert!(told.contains(field) && told.contains(word), "{told}");
    }
}
