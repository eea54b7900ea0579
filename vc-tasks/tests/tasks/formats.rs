//! Reading and writing goals in the formats of others.
#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use vc_graph::goal::Situation;
use vc_graph::{Draft, Goal, History, NodeId, SceneBuilder, SceneGraph, State};
use vc_tasks::format::alfred::{Parameters, TaskType, Template};
use vc_tasks::format::{bddl, eai, json, thesis, watch_and_help};
use vc_tasks::{Task, household};

fn goal(text: &str) -> Goal {
    text.parse().unwrap_or_else(|e| panic!("{text}: {e}"))
}

#[test]
fn the_thesis_writes_what_it_can_and_it_reads_back_equal() {
    for text in ["On(apple, kitchentable), 3", "Sit(chair) & Eat(breakfast)", "Open(fridge.3) & In(milk, fridge.3), 2"]
    {
        let goal = goal(text);
        assert_eq!(thesis::read(&thesis::write(&goal).unwrap()).as_ref(), Ok(&goal), "{text}");
    }
    assert_eq!(
        thesis::write(&goal("Sit(kitchen_chair) & Eat(cake), 2")).unwrap(),
        "Sit(kitchen_chair), 1\nEat(cake), 2\n"
    );
    for text in ["On(a, b) | On(b, a)", "!Open(door)", "On(a, b), = 2", "forall ?x: cup. Clean(?x)"] {
        assert!(thesis::write(&goal(text)).is_err(), "{text}");
    }
    let error = thesis::read("On(a, b), 1\nOn(a b").unwrap_err();
    assert_eq!((error.line, error.column), (2, 7), "{error}");
    let error = thesis::read("On(a, b), 1\n!On(a, b)").unwrap_err();
    assert_eq!(
        error.to_string(),
        "line 2, column 1: thesis goal: expected a predicate and how often, \
        `On(a, b), 3`, found `!On(a, b)`"
    );
}

#[test]
fn dictionaries_of_watch_and_help_go_both_ways() {
    let text = r#"{"on_plate_kitchentable": 2, "inside_apple_93": 1, "holds_book_character": 1,
        "sit_1_95": 1, "turnOn_12_1": 1, "offOn_cup_7": 3, "on_fork_5": 0}"#;
    let read = watch_and_help::read(text).unwrap();
    let expected = "On(plate, kitchentable), 2 & Inside(apple, #93) & Holds(me, book) & SittingOn(#1, #95) \
        & SwitchedOn(#12) & On(cup, #7), <= 0 & On(fork, #5), 0";
    assert_eq!(read, goal(expected));
    assert_eq!(watch_and_help::read(&watch_and_help::write(&read).unwrap()).unwrap(), read);
    assert_eq!(watch_and_help::read(r#"{"on_plate_73": [2, true, 2]}"#).unwrap(), goal("On(plate, #73), 2"));
    assert!(watch_and_help::write(&goal("On(plate, coffee_table)")).is_err());
    assert!(watch_and_help::write(&goal("Open(fridge)")).is_err());
    let error = watch_and_help::read("{\"on_plate_73\": 1,\n \"sit_sofa\": 1}").unwrap_err();
    assert!(error.to_string().starts_with("line 2, column 2: Watch-And-Help goal: expected `on_A_B`"), "{error}");
    assert!(error.to_string().ends_with("found `sit_sofa`"), "{error}");
    let error = watch_and_help::read("{\"on_plate_73\": \"two\"}").unwrap_err();
    assert!(error.to_string().ends_with("expected a number, found `\"two\"`"), "{error}");
}

#[test]
fn every_alfred_template_is_found_again_in_its_goal() {
    for task_type in TaskType::ALL {
        for sliced in [false, true] {
            let word = |yes: bool, word: &str| if yes { word.to_owned() } else { String::new() };
            let about = Parameters {
                object: "Tomato".to_owned(),
                sliced,
                vessel: word(task_type == TaskType::PlaceWithVessel, "Bowl"),
                receptacle: word(task_type != TaskType::LookInLight, "CounterTop"),
                lamp: word(task_type == TaskType::LookInLight, "DeskLamp"),
            };
            let task = Template { task_type, about };
            assert_eq!(Template::from_goal(&task.to_goal()).as_ref(), Ok(&task));
            assert_eq!(Template::read(&task.write()).as_ref(), Ok(&task));
            assert_eq!(goal(&task.to_goal().to_string()), task.to_goal());
        }
    }
    assert!(Template::from_goal(&goal("On(apple, table)")).is_err());
    let missing = r#"{"task_type": "pick_and_place_simple", "pddl_params": {"object_target": "Mug"}}"#;
    let error = Template::read(missing).unwrap_err();
    assert!(error.to_string().ends_with("expected a class for `parent_target`, found none"), "{error}");
}

fn kitchen() -> (SceneGraph, NodeId) {
    let mut scene = SceneBuilder::new("flat");
    let kitchen = scene.add(Draft::new("kitchen")).unwrap();
    let counter = scene.add_in(kitchen, Draft::new("counter")).unwrap();
    let bowl = scene.add_on(counter, Draft::new("bowl")).unwrap();
    scene.add_on(counter, Draft::new("tomato").state(State::Hot)).unwrap();
    scene.add_on(counter, Draft::new("tomato").state(State::Hot)).unwrap();
    let egg = scene.add_in(kitchen, Draft::new("egg")).unwrap();
    let mut edit = scene.edit();
    edit.place(egg, vc_graph::Place { relation: vc_graph::Relation::Inside, at: bowl }).unwrap();
    edit.commit();
    let me = scene.add_in(kitchen, Draft::new("character")).unwrap();
    (scene.build(), me)
}

#[test]
fn alfred_tasks_hold_where_they_should() {
    let (graph, me) = kitchen();
    let history = History::default();
    let now = Situation::new(&graph, me, &history);
    let holds = |kind: &str, object: &str, vessel: &str| {
        let text = format!(
            r#"{{"task_type": "{kind}", "pddl_params": {{"object_target": "{object}", "parent_target": "Counter",
            "mrecep_target": "{vessel}"}}}}"#
        );
        Template::read(&text).unwrap().to_goal().holds(&now)
    };
    assert!(holds("pick_and_place_simple", "Tomato", ""));
    assert!(holds("pick_two_obj_and_place", "Tomato", ""));
    assert!(!holds("pick_two_obj_and_place", "Bowl", ""));
    assert!(holds("pick_heat_then_place_in_recep", "Tomato", ""));
    assert!(!holds("pick_cool_then_place_in_recep", "Tomato", ""));
    assert!(holds("pick_and_place_with_movable_recep", "Egg", "Bowl"));
    assert!(!holds("pick_and_place_with_movable_recep", "Tomato", "Bowl"));
}

#[test]
fn eai_formulas_are_written_as_they_are_read() {
    let texts = [
        "(exists x0. (TOUCH(x0)) then NEXT_TO(character.1, cat.1000))",
        "(ON(light.411) and PLUGGED_IN(light.411))",
        "forall x. (not OPEN(x))",
        "(exists x0. (WATCH(x0) or LOOKAT(x0)) then HOLDS_RH(character.1, novel.1000))",
        "forn 2. x. (ONTOP(x, table.3))",
    ];
    for text in texts {
        let goal = eai::read_formula(text).unwrap();
        assert_eq!(eai::formula(&goal).as_deref(), Ok(text));
    }
    assert!(eai::formula(&goal("On(cup, table), 2")).is_err());
    assert!(eai::formula(&goal("eventually Open(door.1)")).is_err());
    let error = eai::read_formula("(ON(light.1)\n and UP(light.1))").unwrap_err();
    assert_eq!((error.line, error.column), (2, 6), "{error}");
}

#[test]
fn our_own_file_keeps_tasks_as_they_are() {
    let tasks = household();
    assert_eq!(json::read(&json::write(&tasks)).unwrap(), tasks);
    let error = json::read("{\"virtualcity_tasks\": 2, \"tasks\": []}").unwrap_err();
    assert!(error.to_string().ends_with("expected a version up to 1, found version 2"), "{error}");
    let error =
        json::read("{\"virtualcity_tasks\": 1,\n \"tasks\": [{\"title\": 3, \"goal\": \"true\"}]}").unwrap_err();
    assert_eq!((error.line, error.expected.as_str()), (2, "a string"), "{error}");
    let error =
        json::read("{\"virtualcity_tasks\": 1, \"tasks\": [{\"title\": \"a\", \"goal\": \"On(\"}]}").unwrap_err();
    assert!(error.to_string().contains("expected"), "{error}");
    let _: Task = tasks[0].clone();
}

#[test]
fn conditions_are_written_as_they_are_read() {
    let objects = ["cup_1", "cup_2", "table_1", "stain_1"];
    let text = |condition: &str| {
        format!(
            "(define (problem p) (:domain d) (:objects cup_1 cup_2 - cup table_1 - table stain_1 - stain)
            (:init) (:goal {condition}))"
        )
    };
    let conditions = [
        "(and (ontop ?cup_1 ?table_1) (or (not (open ?cup_2)) (imply (real ?cup_1) (hot ?cup_2))))",
        "(forn (2) (?c - cup) (exists (?t - table) (nextto ?c ?t)))",
        "(forpairs (?c - cup) (?t - table) (inside ?c ?t))",
        "(fornpairs (1) (?c - cup) (?t - table) (inside ?c ?t))",
        "(forall (?c - cup) (not (covered ?c ?stain_1)))",
        "(or)",
    ];
    for condition in conditions {
        let goal = bddl::ActivityDefinition::read(&text(condition)).unwrap().to_goal().unwrap();
        let written = bddl::condition(&goal, &objects).unwrap();
        assert_eq!(written, condition);
        assert_eq!(bddl::ActivityDefinition::read(&text(&written)).unwrap().to_goal().unwrap(), goal);
    }
    for refused in [
        "On(cup, table)",
        "On(cup.1, cup.9)",
        "at least 2 ?c: cup. Hot(?c)",
        "eventually Hot(cup.1)",
        "marginal pairs ?c: cup, ?d: cup. Near(?c, ?d)",
        "exists ?c. Hot(?c)",
        "did eat(cup.1)",
        "Holds(me, cup.1)",
        "exists ?C: cup. Hot(?C)",
    ] {
        assert!(bddl::condition(&goal(refused), &objects).is_err(), "{refused}");
    }
}

/// A flat with two cups, a table and a person.
fn flat() -> (SceneGraph, [NodeId; 4]) {
    let mut scene = SceneBuilder::new("flat");
    let [hall, kitchen] = ["hallway", "kitchen"].map(|room| scene.add(Draft::new(room)).unwrap());
    scene.add_in(hall, Draft::new("kitchen_table")).unwrap();
    let table = scene.add_in(kitchen, Draft::new("kitchen_table")).unwrap();
    let cups = [(); 2].map(|()| scene.add_on(table, Draft::new("cup")).unwrap());
    let me = scene.add_in(kitchen, Draft::new("character")).unwrap();
    (scene.build(), [table, cups[0], cups[1], me])
}

fn activity(objects: &str, goal: &str) -> bddl::ActivityDefinition {
    let init = "(inroom table.n.02_1 kitchen)";
    let text = format!("(define (problem p-0) (:objects {objects}) (:init {init}) (:goal {goal}))");
    bddl::ActivityDefinition::read(&text).unwrap()
}

#[test]
fn activities_are_bound_to_things_of_a_scene() {
    let (scene, [table, first, second, me]) = flat();
    let objects = "cup.n.01_1 cup.n.01_2 - cup.n.01 table.n.02_1 - table.n.02 agent.n.01_1 - agent.n.01";
    let history = History::default();
    let now = Situation::new(&scene, me, &history);
    for (condition, holds) in [
        ("(forall (?c - cup.n.01) (ontop ?c ?table.n.02_1))", true),
        ("(exists (?c - cup.n.01) (not (ontop ?c ?table.n.02_1)))", false),
        ("(forn (2) (?c - cup.n.01) (ontop ?c ?table.n.02_1))", true),
        ("(forn (1) (?c - cup.n.01) (ontop ?c ?table.n.02_1))", false),
        ("(forpairs (?c - cup.n.01) (?t - table.n.02) (ontop ?c ?t))", true),
        ("(fornpairs (2) (?c - cup.n.01) (?t - table.n.02) (ontop ?c ?t))", false),
    ] {
        let bound = activity(objects, condition).bind(&scene).unwrap();
        let things: Vec<NodeId> = bound.objects.iter().map(|(_, thing)| *thing).collect();
        assert_eq!(things, [first, second, table, me], "{condition}");
        assert_eq!(bound.goal.holds(&now), holds, "{condition}: {}", bound.goal);
        assert!(
            bound.goal.name_mismatches(&scene).is_empty() && Task::new("t", bound.goal).obstacles(&scene).is_empty()
        );
    }
    // All objects that find nothing are named.
    let more = "cup.n.01_1 cup.n.01_2 cup.n.01_3 - cup.n.01 table.n.02_1 - table.n.02 harp.n.01_1 - harp.n.01";
    let error = activity(more, "(ontop ?cup.n.01_1 ?table.n.02_1)").bind(&scene).unwrap_err();
    let bddl::BindError::Missing(missing) = &error else { panic!("{error}") };
    assert_eq!(missing.iter().map(|(name, _)| &**name).collect::<Vec<_>>(), ["cup.n.01_3", "harp.n.01_1"]);
    assert!(error.to_string().contains("`harp.n.01_1` of class `harp.n.01`"), "{error}");
}
