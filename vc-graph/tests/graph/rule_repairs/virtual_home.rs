//! VirtualHome's own rule beside VirtualCity's: one case for each row of the table of differences that a
//! program can show.

use vc_graph::format::virtualhome;
use vc_graph::{Action, ClassTable, Edge, NodeId, Property, Relation, SceneGraph, Semantics, Simulator, State};

/// Two rooms in VirtualHome's format, with node numbers that the programs below use.
const HOME: &str = r#"{"nodes": [
    {"id": 1, "class_name": "kitchen", "category": "Rooms"},
    {"id": 2, "class_name": "bedroom", "category": "Rooms"},
    {"id": 3, "class_name": "character", "category": "Characters"},
    {"id": 4, "class_name": "table", "category": "Furniture", "properties": ["SURFACES"]},
    {"id": 5, "class_name": "plate", "category": "Props", "properties": ["GRABBABLE", "SURFACES"]},
    {"id": 6, "class_name": "bread", "category": "Food", "properties": ["GRABBABLE", "EATABLE", "CUTTABLE"]},
    {"id": 7, "class_name": "glass", "category": "Props", "properties": ["GRABBABLE", "RECIPIENT"]},
    {"id": 8, "class_name": "juice", "category": "Food", "properties": ["GRABBABLE", "POURABLE", "DRINKABLE"]},
    {"id": 9, "class_name": "teeth", "category": "Props", "properties": ["BODY_PART"]},
    {"id": 10, "class_name": "shirt", "category": "Props", "properties": ["GRABBABLE", "CLOTHES"], "states": ["CLEAN"]},
    {"id": 11, "class_name": "chair", "category": "Furniture", "properties": ["SITTABLE"]},
    {"id": 12, "class_name": "pillow", "category": "Props", "properties": ["GRABBABLE"]},
    {"id": 13, "class_name": "kettle", "category": "Props", "properties": ["HAS_PLUG", "HAS_SWITCH"],
        "states": ["ON", "PLUGGED_IN"]},
    {"id": 14, "class_name": "desk", "category": "Furniture", "properties": ["SURFACES"], "states": ["CLOSED"]},
    {"id": 15, "class_name": "bed", "category": "Furniture", "properties": ["LIEABLE", "SITTABLE"]},
    {"id": 16, "class_name": "knife", "category": "Props", "properties": ["GRABBABLE"]},
    {"id": 17, "class_name": "water", "category": "Food", "properties": ["DRINKABLE", "POURABLE"]},
    {"id": 18, "class_name": "hands_both", "category": "Props", "properties": ["BODY_PART"]},
    {"id": 19, "class_name": "box", "category": "Props", "properties": ["GRABBABLE", "CAN_OPEN", "CONTAINERS"],
        "states": ["OPEN"]},
    {"id": 20, "class_name": "fork", "category": "Props", "properties": ["GRABBABLE"]}],
    "edges": [
    {"from_id": 3, "relation_type": "INSIDE", "to_id": 2}, {"from_id": 4, "relation_type": "INSIDE", "to_id": 1},
    {"from_id": 5, "relation_type": "INSIDE", "to_id": 1}, {"from_id": 5, "relation_type": "ON", "to_id": 4},
    {"from_id": 6, "relation_type": "INSIDE", "to_id": 1}, {"from_id": 6, "relation_type": "ON", "to_id": 5},
    {"from_id": 7, "relation_type": "INSIDE", "to_id": 1}, {"from_id": 7, "relation_type": "ON", "to_id": 4},
    {"from_id": 8, "relation_type": "INSIDE", "to_id": 1}, {"from_id": 8, "relation_type": "ON", "to_id": 4},
    {"from_id": 9, "relation_type": "INSIDE", "to_id": 1}, {"from_id": 10, "relation_type": "INSIDE", "to_id": 1},
    {"from_id": 10, "relation_type": "ON", "to_id": 3}, {"from_id": 11, "relation_type": "INSIDE", "to_id": 1},
    {"from_id": 12, "relation_type": "ON", "to_id": 11}, {"from_id": 12, "relation_type": "INSIDE", "to_id": 1},
    {"from_id": 13, "relation_type": "INSIDE", "to_id": 1}, {"from_id": 13, "relation_type": "ON", "to_id": 4},
    {"from_id": 14, "relation_type": "INSIDE", "to_id": 2}, {"from_id": 15, "relation_type": "INSIDE", "to_id": 2},
    {"from_id": 16, "relation_type": "INSIDE", "to_id": 1}, {"from_id": 16, "relation_type": "ON", "to_id": 4},
    {"from_id": 17, "relation_type": "INSIDE", "to_id": 1}, {"from_id": 18, "relation_type": "INSIDE", "to_id": 1},
    {"from_id": 19, "relation_type": "INSIDE", "to_id": 1}, {"from_id": 19, "relation_type": "ON", "to_id": 4},
    {"from_id": 20, "relation_type": "INSIDE", "to_id": 1}, {"from_id": 20, "relation_type": "INSIDE", "to_id": 19}]}"#;

fn home() -> SceneGraph {
    virtualhome::read(HOME, &ClassTable::builtin()).unwrap()
}

/// The result of a program: the scene, or the refused line.
fn run(semantics: Semantics, program: &str) -> Result<SceneGraph, String> {
    let mut world = Simulator::with(home(), semantics);
    for line in program.lines().map(str::trim).filter(|l| !l.is_empty()) {
        let action: Action = line.parse().unwrap();
        let foreseen = world.refusals(NodeId(3), &action);
        let done = world.step(NodeId(3), &action);
        assert_eq!(done.as_ref().err(), Some(&foreseen).filter(|f| !f.is_empty()), "{line}");
        done.map_err(|refusals| format!("{line}: {}", refusals[0]))?;
    }
    Ok(world.into_graph())
}

fn both(program: &str) -> [Result<SceneGraph, String>; 2] {
    [Semantics::VirtualCity, Semantics::VirtualHome].map(|semantics| run(semantics, program))
}

/// Whether an edge exists after a program, by VirtualCity's and by VirtualHome's rule.
fn edge(program: &str, from: u32, relation: Relation, to: u32) -> [bool; 2] {
    both(program).map(|scene| scene.unwrap().has(Edge::new(NodeId(from), relation, NodeId(to))))
}

/// Whether a program is executable, by VirtualCity's and by VirtualHome's rule.
fn done(program: &str) -> [bool; 2] {
    both(program).map(|scene| scene.is_ok())
}

#[test]
fn contents_stay_behind_and_liquids_vanish() {
    let (ours, both_do) = ([true, false], [true, true]);
    assert_eq!(edge("walk plate.5\n grab plate.5", 6, Relation::On, 5), ours);
    assert_eq!(edge("walk box.19\n grab box.19", 20, Relation::Inside, 19), ours);
    let poured = "walk juice.8\n grab juice.8\n pour juice.8 glass.7";
    assert_eq!(edge(&format!("{poured}\n grab glass.7"), 3, Relation::HoldsLeft, 7), both_do);
    assert_eq!(edge(poured, 8, Relation::PouredInto, 7), ours);
    assert_eq!(edge(poured, 8, Relation::Inside, 7), [false, true]);
    assert_eq!(edge(&format!("{poured}\n walk bed.15"), 8, Relation::PouredInto, 7), ours);
    assert_eq!(edge(&format!("{poured}\n walk bed.15"), 8, Relation::Inside, 7), [false, false]);
}

#[test]
fn what_is_held_keeps_its_room_and_what_is_put_down_all_its_rooms() {
    let carried = "walk glass.7\n grab glass.7\n walk bed.15";
    assert_eq!(edge(carried, 7, Relation::InRoom, 1), [false, true]);
    assert_eq!(edge(carried, 7, Relation::InRoom, 2), [true, false]);
    let dropped = format!("{carried}\n drop glass.7");
    assert_eq!(edge(&dropped, 7, Relation::InRoom, 1), [false, true]);
    assert_eq!(edge(&dropped, 7, Relation::InRoom, 2), [true, true]);
    assert_eq!(edge("walk glass.7\n grab glass.7\n grab glass.7", 3, Relation::HoldsLeft, 7), [false, true]);
}

#[test]
fn what_is_near_is_said_by_the_graph() {
    assert_eq!(done("touch teeth.9"), [true, false], "one's own teeth");
    assert_eq!(done("walk bed.15\n touch teeth.9"), [true, true]);
    assert_eq!(edge("walk kitchen.1", 3, Relation::Near, 1), [false, true]);
    assert_eq!(edge("walk table.4", 3, Relation::Near, 7), [true, true]);
    // An object on an object on the table is near by both rules, although no edge says so.
    assert_eq!(edge("walk plate.5\n grab plate.5", 3, Relation::Near, 4), [true, true]);
    assert_eq!(done("walk table.4\n grab bread.6"), [true, true]);
}

#[test]
fn postures_and_clothes_are_theirs() {
    let stood = "walk bed.15\n sit bed.15\n stand";
    assert_eq!(edge(stood, 3, Relation::On, 15), [false, true]);
    assert_eq!(done("walk chair.11\n sit chair.11"), [true, false], "a pillow takes the seat");
    let bare = "walk table.4\n take_off shirt.10";
    assert_eq!(edge(bare, 3, Relation::HoldsRight, 10), [true, false]);
    // Hands full of clothes: in VirtualHome they are empty.
    assert_eq!(edge(&format!("{bare}\n grab glass.7"), 3, Relation::HoldsRight, 7), [false, true]);
    let [ours, theirs] = both("walk bed.15\n sit bed.15\n sleep").map(|scene| scene.unwrap());
    let asleep = |scene: &SceneGraph| scene.node(NodeId(3)).unwrap().is(State::Asleep);
    assert!(asleep(&ours) && !asleep(&theirs));
}

#[test]
fn what_needs_sense_is_possible() {
    assert_eq!(done("walk kettle.13\n plug_out kettle.13"), [false, true]);
    assert_eq!(done("walk table.4\n grab glass.7\n place glass.7 bread.6"), [false, true]);
    assert_eq!(done("walk box.19\n grab box.19\n put_in box.19 box.19"), [false, true]);
    assert_eq!(done("walk desk.14\n open desk.14"), [true, true]);
    assert_eq!(done("dance"), [true, false]);
    let why = run(Semantics::VirtualHome, "walk table.4\n cook bread.6").unwrap_err();
    assert!(why.contains("VirtualHome's simulator has no action `cook`"), "{why}");
    let cut = "walk table.4\n grab knife.16\n cut bread.6";
    let [ours, theirs] = both(cut).map(|scene| scene.unwrap());
    let sliced = |scene: &SceneGraph| scene.node(NodeId(6)).unwrap().is(State::Sliced);
    assert!(sliced(&ours) && !sliced(&theirs));
}

/// VirtualCity's rule follows common sense where programs of others rely on it.
#[test]
fn common_sense_decides_what_others_leave_open() {
    let read = |nodes: &str, edges: &str| {
        let text = format!(
            r#"{{"nodes": [{{"id": 1, "class_name": "bedroom", "category": "Rooms"}},
                {{"id": 2, "class_name": "character", "category": "Characters"}}, {nodes}],
                "edges": [{{"from_id": 2, "relation_type": "INSIDE", "to_id": 1}}, {edges}]}}"#
        );
        virtualhome::read(&text, &ClassTable::builtin()).unwrap()
    };
    let inside = |id: u32| format!(r#"{{"from_id": {id}, "relation_type": "INSIDE", "to_id": 1}}"#);
    let act = |scene: SceneGraph, program: &[&str]| -> Result<SceneGraph, String> {
        let mut world = Simulator::new(scene);
        for line in program {
            world.step(NodeId(2), &line.parse().unwrap()).map_err(|r| format!("{line}: {}", r[0]))?;
        }
        Ok(world.into_graph())
    };
    // A bookmark lies on a novel.
    let novel = r#"{"id": 3, "class_name": "novel", "category": "Props",
        "properties": ["GRABBABLE", "READABLE", "CAN_OPEN", "HAS_PAPER", "CUTTABLE"], "states": ["CLOSED"]},
        {"id": 4, "class_name": "bookmark", "category": "Props", "properties": ["GRABBABLE"]},
        {"id": 5, "class_name": "fork", "category": "Props", "properties": ["GRABBABLE"]}"#;
    let scene = read(novel, &[inside(3), inside(4), inside(5)].join(","));
    let after = act(scene.clone(), &["walk bookmark.4", "grab bookmark.4", "walk novel.3", "place bookmark.4 novel.3"]);
    assert!(after.unwrap().has(Edge::new(NodeId(4), Relation::On, NodeId(3))));
    assert!(
        act(scene, &["walk fork.5", "grab fork.5", "walk novel.3", "open novel.3", "put_in fork.5 novel.3"]).is_err()
    );
    // A closed desk opens; a door frame does not.
    let desk = r#"{"id": 3, "class_name": "desk", "category": "Furniture", "properties": ["SURFACES"], "states": ["CLOSED"]},
        {"id": 4, "class_name": "doorjamb", "category": "Doors", "properties": [], "states": ["CLOSED"]}"#;
    let scene = read(desk, &[inside(3), inside(4)].join(","));
    let opened = act(scene.clone(), &["walk desk.3", "open desk.3"]).unwrap();
    assert!(opened.node(NodeId(3)).unwrap().is(State::Open));
    assert!(!scene.node(NodeId(4)).unwrap().affords(Property::Openable));
    // A closed basket that is inside itself by the relations opens, and can be taken.
    let basket = r#"{"id": 3, "class_name": "basket", "category": "Props",
        "properties": ["GRABBABLE", "CAN_OPEN", "CONTAINERS"], "states": ["CLOSED"]}"#;
    let itself = r#"{"from_id": 3, "relation_type": "INSIDE", "to_id": 3}"#;
    let scene = read(basket, &[inside(3), itself.into()].join(","));
    let taken = act(scene, &["walk basket.3", "open basket.3", "grab basket.3"]).unwrap();
    assert_eq!(taken.held(NodeId(2)).collect::<Vec<_>>(), [NodeId(3)]);
    // Water is poured over hands, and is then in them.
    let water = r#"{"id": 3, "class_name": "water", "category": "Food", "properties": ["DRINKABLE", "POURABLE"]},
        {"id": 4, "class_name": "hands_both", "category": "Props", "properties": ["BODY_PART"]}"#;
    let scene = read(water, &[inside(3), inside(4)].join(","));
    let poured = act(scene, &["walk water.3", "grab water.3", "pour water.3 hands_both.4"]).unwrap();
    assert!(poured.has(Edge::new(NodeId(3), Relation::Inside, NodeId(4))));
    // Clothes that are taken off are in the hand: with two of them nothing more can be grabbed.
    let clothes = r#"{"id": 3, "class_name": "shirt", "category": "Props", "properties": ["GRABBABLE", "CLOTHES"]},
        {"id": 4, "class_name": "jacket", "category": "Props", "properties": ["GRABBABLE", "CLOTHES"]},
        {"id": 5, "class_name": "towel", "category": "Props", "properties": ["GRABBABLE"]}"#;
    let worn = |id: u32| format!(r#"{{"from_id": {id}, "relation_type": "ON", "to_id": 2}}"#);
    let scene = read(clothes, &[inside(5), worn(3), worn(4)].join(","));
    let off = ["walk towel.5", "take_off shirt.3", "take_off jacket.4", "grab towel.5"];
    assert!(act(scene.clone(), &off).unwrap_err().contains("no free hand"));
    assert!(act(scene, &[&off[..3], &["drop shirt.3", "grab towel.5"]].concat()).is_ok());
}
