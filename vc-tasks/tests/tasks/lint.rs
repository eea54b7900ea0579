//! The findings of the linter.
#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use std::collections::{BTreeMap, BTreeSet};

use crate::behavior::activities_of_behavior_1k;
use vc_graph::{ClassTable, Condition, Draft, Edge, Goal, NodeId, ObjectRole, Relation, SceneBuilder, SceneGraph};
use vc_tasks::format::bddl::ActivityDefinition;
use vc_tasks::lint::{self, FindingKind};

/// The numbers of files in bddl 3.6.0 with each mistake, as found by a script that uses the package's own code,
/// and by z3, which checked all goals.
const FAULTS: &[(FindingKind, usize)] = &[
    (FindingKind::Unsatisfiable, 1),
    (FindingKind::TrueAtStart, 1),
    (FindingKind::ConstantInQuantifier, 28),
    (FindingKind::UnusedVariable, 11),
    (FindingKind::DuplicateObject, 1),
    (FindingKind::RepeatedFact, 5),
    (FindingKind::Stray, 1),
];

/// Remarks, with the file of each: in the pair `pen, table` only the pen occurs in the condition; one `pea_pod`
/// shadows another; a condition follows the goal's `and`, where the package does not read it.
const REMARKS: [(FindingKind, &str); 3] = [
    (FindingKind::UnusedInPair, "set_up_a_preschool_classroom-0"),
    (FindingKind::HiddenVariable, "clean_snap_peas-0"),
    (FindingKind::SecondCondition, "loading_the_car-0"),
];

#[test]
fn the_known_faults_of_behavior_1k_are_found_and_no_others() {
    let mut hits: BTreeMap<FindingKind, BTreeSet<String>> = BTreeMap::new();
    let files = activities_of_behavior_1k();
    for (file, text) in &files {
        let activity = ActivityDefinition::read(text).unwrap();
        for finding in lint::activity(&activity) {
            hits.entry(finding.kind).or_default().insert(activity.name().to_owned());
            assert_eq!(lint::activity(&activity), lint::activity(&activity), "{file}");
        }
    }
    if files.is_empty() {
        return;
    }
    assert_eq!(files.len(), 1016);
    let (remarks, faults): (Vec<_>, Vec<_>) = hits.iter().partition(|(kind, _)| kind.is_remark());
    let counts: Vec<(FindingKind, usize)> = faults.into_iter().map(|(kind, names)| (*kind, names.len())).collect();
    assert_eq!(counts, FAULTS, "{hits:#?}");
    let remarks: Vec<(FindingKind, &str)> =
        remarks.into_iter().flat_map(|(kind, names)| names.iter().map(|name| (*kind, name.as_str()))).collect();
    assert_eq!(remarks, REMARKS);
    assert!(hits[&FindingKind::Unsatisfiable].contains("stacking_wood-0"));
    assert!(hits[&FindingKind::TrueAtStart].contains("clean_a_stainless_steel_dishwasher-0"));
}

fn kinds(goal: &str) -> Vec<FindingKind> {
    let goal: Goal = goal.parse().unwrap();
    lint::goal(&goal, None).into_iter().map(|f| f.kind).collect()
}

#[test]
fn goals_of_our_own_are_looked_at_too() {
    assert_eq!(kinds("On(apple, table), 3"), []);
    assert_eq!(kinds("forall ?p: plate. Clean(cup)"), [FindingKind::UnusedVariable]);
    assert_eq!(
        kinds("forall ?p: plate. On(plate.3, table)"),
        [FindingKind::UnusedVariable, FindingKind::ConstantInQuantifier]
    );
    assert_eq!(kinds("exists ?p: plate. Clean(?p) & exists ?p: cup. Clean(?p)"), [FindingKind::HiddenVariable]);
    assert_eq!(kinds("pairs ?p: plate, ?c: cup. Clean(?p)"), [FindingKind::UnusedInPair]);
    assert_eq!(kinds("Open(door.1) & Closed(door.1)"), [FindingKind::Unsatisfiable]);
    assert_eq!(kinds("Open(door.1) | Closed(door.1)"), []);
    assert_eq!(kinds("Broken(cup)"), [FindingKind::NothingBringsAbout]);
    assert_eq!(kinds("!Broken(cup)"), []);
    assert_eq!(kinds("Broken(cup) => Clean(floor)"), []);
}

#[test]
fn a_scene_tells_what_there_is() {
    let mut scene = SceneBuilder::new("flat");
    let kitchen = scene.add(Draft::new("kitchen")).unwrap();
    let table = scene.add_in(kitchen, Draft::new("kitchen_table")).unwrap();
    scene.add_on(table, Draft::new("apple")).unwrap();
    scene.add_in(kitchen, Draft::new("apple")).unwrap();
    scene.add_in(kitchen, Draft::new("character")).unwrap();
    let graph = scene.build();
    let kinds = |goal: &str| {
        let found = lint::goal(&goal.parse().unwrap(), Some(&graph));
        found.into_iter().map(|f| f.kind).collect::<Vec<_>>()
    };
    assert_eq!(kinds("On(apple, kitchen_table), 2"), []);
    // The scene has two apples.
    assert_eq!(kinds("On(apple, kitchen_table), 3"), [FindingKind::Obstacle, FindingKind::Unsatisfiable]);
    assert_eq!(kinds("On(apple, kitchen_table)"), [FindingKind::TrueAtStart]);
    assert_eq!(kinds("(exactly 1 ?a: apple. Clean(?a)) & forall ?a: apple. Clean(?a)"), [FindingKind::Unsatisfiable]);
}

#[test]
fn what_is_not_declared_is_said_with_its_place() {
    let text = "(define (problem p)\n (:objects a b - cup)\n (:init (ontop a c) (ontop a c))\n \
        (:goal (and (flies ?a) (forall (?x - dog) (ontop ?x ?a)))) junk)";
    let found = lint::activity(&ActivityDefinition::read(text).unwrap());
    let lines: Vec<String> = found.iter().map(ToString::to_string).collect();
    assert_eq!(
        lines,
        [
            "an unknown domain: no `(:domain ...)` is given; known are omnigibson and igibson",
            "line 3, column 9: not declared: object `c`",
            "line 3, column 21: a fact repeated: (ontop a c)",
            "line 3, column 21: not declared: object `c`",
            "line 4, column 14: not declared: predicate `flies`",
            "line 4, column 25: not declared: class `dog`",
            "line 4, column 61: a stray word: junk",
        ]
    );
}

#[test]
fn a_class_that_is_misspelt_gets_the_nearest_of_the_scene() {
    let mut scene = vc_graph::SceneBuilder::new("flat");
    let kitchen = scene.add(vc_graph::Draft::new("kitchen")).unwrap();
    let table = scene.add_in(kitchen, vc_graph::Draft::new("kitchen_table")).unwrap();
    scene.add_on(table, vc_graph::Draft::new("apple")).unwrap();
    let graph = scene.build();
    for (goal, told) in [
        ("On(aple, kitchen_table)", "`aple` (did you mean `apple`?), the scene has 0"),
        ("On(apple, kitchn tabel)", "`kitchn_tabel` (did you mean `kitchen_table`?)"),
        ("On(unicorn, kitchen_table)", "`unicorn`, the scene has 0"),
        ("On(pear, kitchen_table)", "`pear`, the scene has 0"),
    ] {
        let task = vc_tasks::Task::new("t", goal.parse().unwrap());
        let obstacles: Vec<String> = task.obstacles(&graph).iter().map(ToString::to_string).collect();
        assert!(obstacles.iter().any(|o| o.contains(told)), "{goal}: {obstacles:?}");
    }
}

fn of_activity(domain: &str, objects: &str, start: &str, goal: &str) -> Vec<(FindingKind, String)> {
    let text =
        format!("(define (problem p) (:domain {domain}) (:objects {objects}) (:init {start}) (:goal (and {goal})))");
    let found = lint::activity(&ActivityDefinition::read(&text).unwrap());
    found.into_iter().map(|f| (f.kind, f.part)).collect()
}

/// Predicates have the right number of arguments, objects do not rest on themselves or in a cycle, and the
/// domain is known.
#[test]
fn predicates_take_so_many_things_and_things_do_not_rest_in_cycles() {
    let in_home = |start, goal| of_activity("omnigibson", "p_1 p_2 p_3 - p", start, goal);
    assert_eq!(in_home("(ontop p_1 p_2)", "(not (ontop ?p_1 ?p_2)) (stained ?p_2)"), []);
    assert_eq!(
        in_home("(dusty p_1 p_2)", "(stained ?p_1 ?p_2) (not (ontop ?p_1)) (inroom ?p_3)")[..4],
        [
            (FindingKind::WrongArity, "(dusty p_1 p_2): `dusty` takes 1, 2 given".to_owned()),
            (FindingKind::WrongArity, "(stained ?p_1 ?p_2): `stained` takes 1, 2 given".to_owned()),
            (FindingKind::WrongArity, "(ontop ?p_1): `ontop` takes 2, 1 given".to_owned()),
            (FindingKind::WrongArity, "(inroom ?p_3): `inroom` takes 2, 1 given".to_owned()),
        ]
    );
    assert_eq!(in_home("", "(nextto ?p_1 ?p_1)"), [(FindingKind::WithItself, "(nextto ?p_1 ?p_1)".to_owned())]);
    let cycle = |part: &str| (FindingKind::Cycle, part.to_owned());
    let start = "(ontop p_3 p_1) (ontop p_1 p_2) (inside p_2 p_1)";
    assert_eq!(in_home(start, "(stained ?p_1)"), [cycle("(ontop p_1 p_2)")]);
    assert_eq!(in_home("", "(ontop ?p_1 ?p_2) (and (inside ?p_2 ?p_1))"), [cycle("(ontop ?p_1 ?p_2)")]);
    assert_eq!(in_home("", "(or (ontop ?p_1 ?p_2) (inside ?p_2 ?p_1))"), []);
    let unknown = of_activity("mydomain", "p_1 - p", "", "(dusty ?p_1)");
    assert_eq!(unknown, [(FindingKind::UnknownDomain, "mydomain; known are omnigibson and igibson".to_owned())]);
}

#[test]
fn goals_of_our_own_are_not_of_cycles_either() {
    assert_eq!(kinds("On(plate.4, plate.4)"), [FindingKind::WithItself]);
    assert_eq!(kinds("exists ?p: plate. On(?p, ?p)"), [FindingKind::WithItself]);
    assert_eq!(kinds("On(plate, plate)"), []);
    assert_eq!(kinds("On(cup.1, plate.2) & Inside(plate.2, box.3) & On(#3, #1)"), [FindingKind::Cycle]);
    assert_eq!(kinds("On(cup.1, plate.2) | On(plate.2, cup.1)"), []);
    assert_eq!(kinds("Cold(tomato.3) & Dirty(plate.1) & Dry(towel.2)"), []);
}

#[test]
fn a_scene_tells_what_it_lacks() {
    let mut scene = SceneBuilder::new("flat");
    let kitchen = scene.add(Draft::new("kitchen")).unwrap();
    let table = scene.add_in(kitchen, Draft::new("kitchen_table")).unwrap();
    for class in ["water_glass", "water_glass", "knife"] {
        scene.add_on(table, Draft::new(class)).unwrap();
    }
    scene.add_in(kitchen, Draft::new("character")).unwrap();
    let graph = scene.build();
    let found = |goal: &str| {
        let found = lint::goal(&goal.parse().unwrap(), Some(&graph));
        found.into_iter().map(|f| f.to_string()).collect::<Vec<_>>()
    };
    for (goal, told) in [
        ("On(unicorn, kitchen_table)", "the scene has 0"),
        ("SwitchedOn(unicorn)", "the scene has 0"),
        ("Open(water_glass)", "to be openable"),
        ("On(#999, kitchen_table)", "there is no node #999"),
        ("Inside(water_glass, knife)", "to be a container"),
        ("Holds(water_glass), 3", "needs 3 of `water_glass`, the scene has 2"),
        ("Holds(knife.3)", "a thing called what it is not: `knife.3` names a thing that is water_glass.3"),
    ] {
        assert!(found(goal).iter().any(|f| f.contains(told)), "{goal}: {:?}", found(goal));
    }
    assert_eq!(found("Holds(glass.3) & On(knife, table)"), Vec::<String>::new());
}

/// A class in no class table is found without a scene, anywhere in a goal; so is a goal that always holds.
#[test]
fn unknown_classes_and_goals_that_always_hold_are_found() {
    let found = |goal: &str| {
        let found = lint::goal(&goal.parse().unwrap(), None);
        found.into_iter().map(|f| (f.kind, f.part)).collect::<Vec<_>>()
    };
    for goal in ["On(mugg, table)", "!On(mugg, table)", "forall ?m: mugg. Clean(?m)", "Holds(mugg.3)"] {
        assert_eq!(found(goal), [(FindingKind::UnknownClass, "`mugg` (did you mean `mug`?)".to_owned())], "{goal}");
    }
    for goal in ["On(mug, kitchen table)", "On(DishTable, kitchentable) | Holds(apple)", "Eat(me) & Holds(#3)"] {
        assert!(!found(goal).iter().any(|(kind, _)| *kind == FindingKind::UnknownClass), "{goal}");
    }
    assert_eq!(found("Holds(apple), 0")[0].0, FindingKind::TrueAtStart);
    // A class that the scene has is known there; a class that an obstacle reports is not reported twice.
    let mut scene = vc_graph::SceneBuilder::new("flat");
    let kitchen = scene.add(vc_graph::Draft::new("kitchen")).unwrap();
    scene.add_in(kitchen, vc_graph::Draft::new("flooble")).unwrap();
    let graph = scene.build();
    let kinds =
        |goal: &str| lint::goal(&goal.parse().unwrap(), Some(&graph)).iter().map(|f| f.kind).collect::<Vec<_>>();
    assert!(!kinds("Clean(flooble)").contains(&FindingKind::UnknownClass));
    assert!(
        kinds("Clean(floo)").contains(&FindingKind::Obstacle)
            && !kinds("Clean(floo)").contains(&FindingKind::UnknownClass)
    );
    assert!(kinds("!Clean(floo)").contains(&FindingKind::UnknownClass));
}

/// A state that neither an action nor a process brings about is an obstacle unless enough things are in it already.
#[test]
fn states_that_nothing_brings_about_are_obstacles() {
    let mut scene = SceneBuilder::new("flat");
    let kitchen = scene.add(Draft::new("kitchen")).unwrap();
    scene.add_in(kitchen, Draft::new("fridge")).unwrap();
    scene.add_in(kitchen, Draft::new("mug")).unwrap();
    scene.add_in(kitchen, Draft::new("mug").state(vc_graph::State::Wet)).unwrap();
    scene.add_in(kitchen, Draft::new("character")).unwrap();
    let graph = scene.build();
    let told = |goal: &str| {
        let task = vc_tasks::Task::new("t", goal.parse().unwrap());
        task.obstacles(&graph).iter().map(ToString::to_string).collect::<Vec<_>>().join("; ")
    };
    let no = |part: &str, thing: &str, state: &str| {
        format!("`{part}` needs `{thing}` to be {state}, which it is not here, and no action or process makes it so")
    };
    for (goal, thing, state) in [
        ("Frozen(mug)", "mug", "frozen"),
        ("Wet(mug), 2", "mug", "wet"),
        ("Wet(mug.3)", "mug.3", "wet"),
        ("Broken(mug)", "mug", "broken"),
        ("OnFire(me)", "me", "on_fire"),
        ("Dusty(fridge)", "fridge", "dusty"),
    ] {
        assert_eq!(told(goal), no(&goal.parse::<Goal>().unwrap().to_string(), thing, state), "{goal}");
    }
    for goal in ["Wet(mug)", "Wet(mug.4)", "!Frozen(mug)", "Frozen(mug) | Clean(mug)", "Dirty(mug)", "Filled(mug)"] {
        assert_eq!(told(goal), "", "{goal}");
    }
    assert!(told("Hot(fridge)").contains("to be graspable") && told("PluggedIn(mug)").contains("with a plug"));
    assert!(told("SittingOn(mug, fridge)").contains("to be a person"));
    assert!(told("WornBy(mug, me)").contains("to be wearable"));
}

fn obstacles(goal: &str, graph: &SceneGraph) -> String {
    let task = vc_tasks::Task::new("t", goal.parse().unwrap_or_else(|e| panic!("{goal}: {e}")));
    task.obstacles(graph).iter().map(ToString::to_string).collect::<Vec<_>>().join("; ")
}

/// Parts that never hold together are an obstacle, and the goal is lost at once; where two things can serve them it is not.
#[test]
fn parts_that_exclude_each_other() {
    let one = kitchen(&["fridge", "kitchen_table", "mug"]);
    let two = kitchen(&["fridge", "fridge", "kitchen_table", "mug"]);
    let lost = |goal: &str, graph: &SceneGraph| vc_tasks::Task::new("t", goal.parse().unwrap()).lost(graph);
    for (goal, of_one, of_two) in [
        ("On(mug, kitchen_table) & !On(mug, kitchen_table)", true, true),
        ("!On(mug, kitchen_table) & Clean(mug) & On(mug, kitchen_table)", true, true),
        ("Open(fridge) & Closed(fridge)", true, false),
        ("Closed(fridge.3) & Open(fridge.3)", true, true),
        ("SittingOn(me, fridge) & LyingOn(me, mug)", true, true),
        ("Sitting(me) & LyingOn(me, mug)", true, true),
        ("SittingOn(me, mug) & Open(fridge)", false, false),
        ("Open(fridge) & Clean(fridge)", false, false),
        ("Open(fridge) & !Open(mug)", false, false),
        ("Open(fridge) | Closed(fridge)", false, false),
        ("eventually Open(fridge) & eventually Closed(fridge)", false, false),
    ] {
        for (graph, excluded) in [(&one, of_one), (&two, of_two)] {
            let told = "never hold at the same time";
            assert_eq!(obstacles(goal, graph).contains(told), excluded, "{goal}: {}", obstacles(goal, graph));
            assert_eq!(lost(goal, graph).is_some_and(|lost| lost.to_string().contains(told)), excluded, "{goal}");
        }
    }
}

/// A kitchen with a person and things of some classes on its floor.
fn kitchen(classes: &[&str]) -> SceneGraph {
    let mut scene = SceneBuilder::new("flat");
    let kitchen = scene.add(Draft::new("kitchen")).unwrap();
    scene.add_in(kitchen, Draft::new("character")).unwrap();
    for class in classes {
        scene.add_in(kitchen, Draft::new(*class)).unwrap();
    }
    scene.build()
}

/// Things can be put on and into what the transition rule says, and on and into nothing else.
#[test]
fn obstacles_are_those_of_the_rule_for_all_classes() {
    for class in ClassTable::builtin().iter().filter(|class| class.role() != ObjectRole::Person) {
        let mut scene = SceneBuilder::from_graph(kitchen(&["apple"]));
        let id = scene.add(Draft::new(&*class.name)).unwrap();
        let graph = scene.build();
        let (me, name) = (graph.agents()[0], &class.name);
        let met = |need: fn(NodeId) -> Condition| {
            graph.of_class(name).into_iter().any(|id| need(id).check(&graph, me).is_ok())
        };
        for (goal, allowed) in [
            (format!("On(apple, {name})"), met(Condition::Carries)),
            (
                format!("Inside(apple, {name})"),
                graph.rooms().contains(&id) || met(Condition::Encloses) || met(Condition::Receives),
            ),
            (format!("Holds({name})"), met(Condition::Graspable)),
        ] {
            assert_eq!(obstacles(&goal, &graph).is_empty(), allowed, "{goal}: {}", obstacles(&goal, &graph));
        }
    }
    let graph = kitchen(&["apple", "bowl", "spoon", "mug", "bookmark", "novel", "stove"]);
    for goal in ["On(apple, bowl)", "On(spoon, mug)", "On(bookmark, novel)", "On(mug, stove)", "Inside(spoon, mug)"] {
        assert_eq!(obstacles(goal, &graph), "", "{goal}");
    }
    assert!(obstacles("On(mug, apple)", &graph).contains("to be a surface"));
}

/// A relation that holds already is no obstacle, though nothing could bring it about.
#[test]
fn parts_that_hold_already_are_no_obstacles() {
    let mut scene = SceneBuilder::from_graph(kitchen(&["wall", "painting", "painting", "dresser"]));
    let graph = scene.graph();
    let [wall, painting] = ["wall", "painting"].map(|class| graph.of_class(class)[0]);
    scene.link_all(&[Edge::new(painting, Relation::On, wall)]).unwrap();
    let graph = scene.build();
    for goal in ["On(painting, wall)", "Inside(dresser, kitchen)", "On(painting, wall) & Open(dresser)"] {
        assert_eq!(obstacles(goal, &graph), "", "{goal}");
    }
    assert!(obstacles("On(dresser, wall)", &graph).contains("to be graspable"));
}

/// The machines of a scene bring states about in their time.
#[test]
fn states_that_processes_bring_about_are_no_obstacles() {
    let graph = kitchen(&["freezer", "juice", "wine", "shirt", "washing_machine", "stove", "fridge", "coffee_maker"]);
    for goal in ["Frozen(juice)", "Wet(shirt)", "Hot(coffee_maker)", "Cold(fridge)", "Frozen(juice) & Wet(shirt)"] {
        let told = obstacles(goal, &graph);
        assert_eq!(told.is_empty(), goal != "Cold(fridge)", "{goal}: {told}");
    }
    assert!(obstacles("Frozen(wine)", &graph).contains("no action or process"), "a freezer does not freeze it");
    assert!(obstacles("Frozen(fridge)", &graph).contains("no action or process"));
    assert!(obstacles("Frozen(juice), 2", &graph).contains("the scene has 1"));
    assert!(obstacles("Frozen(juice)", &kitchen(&["juice", "fridge"])).contains("no action or process"));
    assert!(obstacles("Wet(shirt)", &kitchen(&["shirt"])).contains("no action or process"));
    let kinds =
        |goal: &str, graph| lint::goal(&goal.parse().unwrap(), graph).iter().map(|f| f.kind).collect::<Vec<_>>();
    assert_eq!(kinds("Frozen(juice)", None), []);
    assert_eq!(kinds("Frozen(juice)", Some(&graph)), []);
    assert_eq!(kinds("Frozen(juice)", Some(&kitchen(&["juice"]))), [FindingKind::Obstacle]);
}
