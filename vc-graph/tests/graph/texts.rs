//! Goals, actions and labels print in a form that parses back equal.
#![allow(clippy::unwrap_used)]

use proptest::prelude::*;
use vc_graph::format::program::{self, Program};
use vc_graph::{Action, Draft, Goal, Label, NodeId, Relation, SceneBuilder, Scope, Simulator, State, Verb, Word};
use vc_testkit::cases;
use vc_testkit::goals::{goal, words};
use vc_testkit::scenes::{scene, steps};

fn action() -> impl Strategy<Value = Action> {
    (words::<Verb>(), any::<u32>(), any::<u32>()).prop_map(|(verb, x, y)| {
        let things = [NodeId(x), NodeId(y)];
        Action::with(verb, &things[..verb.arity()]).unwrap()
    })
}

proptest! {
    #![proptest_config(cases(500))]

    #[test]
    fn goals_read_back(goal in goal(0, 3)) {
        let text = goal.to_string();
        prop_assert_eq!(text.parse::<Goal>(), Ok(goal), "{}", text);
    }

    #[test]
    fn actions_read_back(action in action()) {
        prop_assert_eq!(action.to_string().parse::<Action>(), Ok(action));
    }

    #[test]
    fn labels_read_back(class in "[\\p{Alphabetic}0-9_-]{1,20}", id: u32) {
        let label = Label { class: class.into(), id: NodeId(id) };
        prop_assert_eq!(label.to_string().parse::<Label>(), Ok(label));
    }

    #[test]
    fn described_actions_and_virtualhome_notation_read_back(steps in steps(6), verb in words::<Verb>(), x: usize, y: usize) {
        let graph = scene(&steps, false);
        let ids: Vec<NodeId> = graph.nodes().map(|n| n.id()).collect();
        let things = [ids[x % ids.len()], ids[y % ids.len()]];
        let action = Action::with(verb, &things[..verb.arity()]).unwrap();
        prop_assert_eq!(action.describe(&graph).to_string().parse::<Action>(), Ok(action));
        match action.to_virtualhome(&graph) {
            Ok(text) => prop_assert_eq!(text.parse::<Action>(), Ok(action), "{}", text),
            Err(error) => prop_assert!(verb.virtualhome().is_none(), "{}", error),
        }
    }

    #[test]
    fn programs_read_back(actions in prop::collection::vec(action(), 0..8), titled: bool) {
        let actions: Vec<Action> = actions.into_iter().filter(|a| a.verb.virtualhome().is_some()).collect();
        let heading = if titled { vec!["Make coffee".to_owned(), "In the morning.".to_owned()] } else { Vec::new() };
        let program = Program { heading, ..Program::from_actions(actions) };
        let text = program::write(&program, &scene(&[], false)).unwrap();
        let again = program::read(&text).unwrap();
        prop_assert_eq!(&again.heading, &program.heading, "{}", text);
        prop_assert!(again.actions().eq(program.actions()) && again.steps.len() == program.steps.len(), "{}", text);
    }
}

#[test]
fn words_read_back_in_any_spelling() {
    fn check<W: Word + std::fmt::Display>() {
        for word in W::ALL {
            let spelled = [word.to_string(), word.as_str().to_uppercase(), word.as_str().replace('_', " ")];
            spelled.iter().for_each(|text| assert_eq!(W::parse(text).as_ref(), Ok(word)));
        }
    }
    check::<State>();
    check::<Relation>();
    check::<Verb>();
    check::<vc_graph::Property>();
    check::<vc_graph::class::Category>();
    check::<vc_graph::class::SlotKind>();
}

#[test]
fn virtualhome_names_are_its_own() {
    for verb in Verb::ALL {
        let Some(name) = verb.virtualhome() else { continue };
        assert_eq!(Verb::from_virtualhome(name), Some(*verb));
        assert_eq!(Verb::from_virtualhome(&name.to_lowercase()), Some(*verb));
    }
    assert_eq!(Verb::from_virtualhome("PUTBACK"), Some(Verb::Place));
    assert_eq!(Verb::from_virtualhome("RELEASE"), Some(Verb::Drop));
}

#[test]
fn older_virtualhome_numbers_name_the_instance_after_the_dot() {
    let action: Action = "<char0> [putin] <milk> (1.12) <fridge> (3)".parse().unwrap();
    assert_eq!(action, Action::two(Verb::PutIn, NodeId(12), NodeId(3)));
}

#[test]
fn deep_goals_read_back() {
    let text = "Open(door) & forall ?x. ".repeat(25) + "Open(?x)";
    let goal: Goal = text.parse().unwrap();
    assert_eq!(goal.to_string().parse(), Ok(goal));
}

#[test]
fn odd_classes_read_back() {
    for text in
        ["forall ?q. Inside(p, v ?q)", "On(ch #a.65, b)", "On(p *u, b)", "On(kitchen table, b)", "On(#pple?, b)"]
    {
        if let Ok(goal) = text.parse::<Goal>() {
            assert_eq!(goal.to_string().parse(), Ok(goal), "{text}");
        }
    }
}

#[test]
fn odd_variables_read_back() {
    for text in ["forall #12. Open(#12)", "forall *. Open(*)", "exists x.1. Open(x.1)", "exists ?. Open(?)"] {
        if let Ok(goal) = text.parse::<Goal>() {
            assert_eq!(goal.to_string().parse(), Ok(goal), "{text}");
        }
    }
}

#[test]
fn labels_are_held_against_their_nodes() {
    let mut scene = vc_graph::SceneBuilder::new("flat");
    let kitchen = scene.add(vc_graph::Draft::new("kitchen")).unwrap();
    let knife = scene.add_in(kitchen, vc_graph::Draft::new("cutleryknife")).unwrap();
    let odd = scene.add_in(kitchen, vc_graph::Draft::new("Odd_Thing").named("SM_Gizmo_3")).unwrap();
    let graph = scene.build();
    for (name, id) in [
        ("cutlery_knife", knife),
        ("CutleryKnife", knife),
        ("knife", knife),
        ("cutlery", knife),
        ("odd thing", odd),
        ("sm_gizmo_3", odd),
        ("milk", NodeId(99)),
    ] {
        assert_eq!(graph.check_name(name, id), Ok(()), "{name}");
    }
    for (name, id) in [("milk", knife), ("gizmo", odd), ("kitchen", knife), ("bread_knife", knife)] {
        let label = Label { class: name.into(), id };
        let told = graph.check_label(&label).unwrap_err().to_string();
        assert!(told.contains(&format!("`{label}` names")) && told.contains(&graph.label(id).to_string()), "{told}");
    }
}

/// The steps of a program: characters and actions.
fn steps_of(text: &str) -> Vec<Vec<(u32, String)>> {
    let program = program::read(text).unwrap_or_else(|e| panic!("{e}: {text}"));
    program.steps.iter().map(|s| s.iter().map(|d| (d.character, d.action.to_string())).collect()).collect()
}

#[test]
fn characters_act_alone_and_together() {
    let walk = |who| vec![(who, "walk #6".to_owned())];
    assert_eq!(steps_of("<char1> [walk] <waterglass> (6) [0]"), [walk(1)]);
    assert_eq!(steps_of("\u{feff}[walk] <waterglass> (6)\n# then nothing\n\n"), [walk(0)]);
    let both = "<char0> [walk] <waterglass> (6) | <char1> [switchon] <tablelamp> (11)";
    assert_eq!(steps_of(both), [[(0, "walk #6".to_owned()), (1, "switch_on #11".to_owned())]]);
    assert_eq!(steps_of(&format!("Two\n\n{both}\n{both}")).len(), 2);
    let program = program::read(both).unwrap();
    let written = program::write(&program, &scene(&[], false)).unwrap();
    assert_eq!(steps_of(&written), steps_of(both), "{written}");
    assert!("<char1> [STANDUP]".parse::<Action>().unwrap_err().to_string().contains("`<char1>`"));
}

#[test]
fn lines_that_are_meant_as_actions_are_no_titles() {
    for (text, line, told) in [
        ("1. [WALK] <waterglass> (6)\n2. [GRAB] <waterglass> (6)", 1, "is not of the form"),
        ("- [WALK] <waterglass> (6)", 1, "is not of the form"),
        ("[WALK] <waterglass> (6) | [GRAB] <waterglass> (6)", 1, "`<char0>` does two things at once"),
        ("Title\n\n[WALK <waterglass> (6)", 3, "is not of the form"),
        ("<charx> [WALK] <waterglass> (6)", 1, "is not of the form"),
        ("wlak kitchen.1\ngrab cup.2", 1, "(did you mean `walk`?)"),
        ("dance\nwvae", 2, "(did you mean `wave`?)"),
        ("[WALK] <waterglass> (6) [x]", 1, "is not of the form"),
        ("WALK] <waterglass> (6)\n[GRAB] <waterglass> (6)", 1, "`<waterglass>` names no object"),
        ("STANDUP]\n[GRAB] <waterglass> (6)", 1, "program, line 1"),
        ("walk <waterglass> (6)\n[GRAB] <waterglass> (6)", 1, "`<waterglass>`"),
    ] {
        let error = program::read(text).unwrap_err();
        assert!(error.line == Some(line) && error.to_string().contains(told), "{error}: {text}");
    }
}

#[test]
fn titles_may_be_verbs() {
    for (text, heading, steps) in [
        ("Dance\n\n[WALK] <tablelamp> (11)\n", &["Dance"][..], 1),
        ("Sleep\nThe person sleeps.\n\n[WALK] <waterglass> (6)\n", &["Sleep", "The person sleeps."], 1),
        ("Make coffee (quick)\n\n\n[WALK] <waterglass> (6)\n", &["Make coffee (quick)"], 1),
        ("Make coffee\n\n\n", &["Make coffee"], 0),
        ("Turn on light\nGo [on].\n[WALK] <waterglass> (6)", &["Turn on light", "Go [on]."], 1),
        ("dance\nwave\n", &[], 2),
        ("stand\n\n", &[], 1),
        ("grab cup.2\n\nwalk kitchen.1", &[], 2),
        ("", &[], 0),
    ] {
        let program = program::read(text).unwrap_or_else(|e| panic!("{e}: {text}"));
        assert_eq!(
            (program.heading.as_slice(), program.steps.len()),
            (&heading.iter().map(|&l| l.to_owned()).collect::<Vec<_>>()[..], steps),
            "{text}"
        );
    }
}

/// A kitchen with a cup, and two people.
fn couple() -> vc_graph::SceneGraph {
    let mut scene = vc_graph::SceneBuilder::new("flat");
    let kitchen = scene.add(vc_graph::Draft::new("kitchen")).unwrap();
    for class in ["cup", "character", "character"] {
        scene.add_in(kitchen, vc_graph::Draft::new(class)).unwrap();
    }
    scene.build()
}

#[test]
fn programs_are_cast_with_who_and_what_there_is() {
    let graph = couple();
    let cast = |text: &str| program::read(text).unwrap().cast(&graph);
    let agents = |text: &str| -> Vec<u32> { cast(text).unwrap().concat().iter().map(|e| e.agent.0).collect() };
    assert_eq!(agents("[WALK] <cup> (2)\n<char1> [WALK] <mug> (99)"), [3, 4]);
    for (text, told) in [
        (
            "[WALK] <cup> (2)\n<char9> [WALK] <cup> (2)",
            "action 2: there is no `<char9>`, the scene has 2 characters, `<char0>` to `<char1>`",
        ),
        ("[WALK] <kitchen> (1)\n[WALK] <milk> (2)", "action 2: `milk.2` names a thing that is cup.2"),
        ("grab milk.2", "action 1: `milk.2` names a thing that is cup.2"),
    ] {
        let error = cast(text).unwrap_err().to_string();
        assert!(error.starts_with(told), "{error}");
    }
}

#[test]
fn acting_together_is_done_whole_or_not_at_all() {
    let mut world = vc_graph::Simulator::new(couple());
    let cast = |text: &str| program::read(text).unwrap().cast(&couple()).unwrap().concat();
    world.step_together(&cast("<char0> [WALK] <cup> (2) | <char1> [WALK] <cup> (2)")).unwrap();
    let before = world.clone();
    let (event, refusals) =
        world.step_together(&cast("<char0> [GRAB] <cup> (2) | <char1> [GRAB] <cup> (2)")).unwrap_err();
    assert_eq!((event.agent, refusals[0].to_string()), (NodeId(4), "character.3 holds cup.2".to_owned()));
    assert!(world == before);
}

#[test]
fn misspelt_words_get_the_nearest() {
    for (error, told) in [
        ("garb cup.2".parse::<Action>().unwrap_err().to_string(), "unknown verb `garb` (did you mean `grab`?)"),
        ("[SWICHON] <lamp> (2)".parse::<Action>().unwrap_err().to_string(), "(did you mean `switch_on`?)"),
        ("Opne(fridge)".parse::<Goal>().unwrap_err().to_string(), "`Opne` (did you mean `open`?)"),
        ("Insid(milk, fridge)".parse::<Goal>().unwrap_err().to_string(), "(did you mean `inside`?)"),
        ("teleport cup.2".parse::<Action>().unwrap_err().to_string(), "unknown verb `teleport`; use one of"),
    ] {
        assert!(error.contains(told), "{error}");
    }
    let classes = vc_graph::ClassTable::builtin();
    assert_eq!(classes.nearest("refridgerator"), ["refrigerator"]);
    assert_eq!(classes.nearest("aple"), ["apple"]);
    assert!(classes.nearest("unicorn").is_empty());
    assert!(vc_graph::nearest("", ["a", "on"]).is_empty());
}

/// An action with labels is not performed on other nodes; plain numbers say nothing about classes.
#[test]
fn actions_are_done_to_what_they_name() {
    use vc_graph::{Draft, Refusal, SceneBuilder, rule};
    let mut scene = SceneBuilder::new("flat");
    let kitchen = scene.add(Draft::new("kitchen")).unwrap();
    let table = scene.add_in(kitchen, Draft::new("kitchen_table")).unwrap();
    let apple = scene.add_on(table, Draft::new("apple")).unwrap();
    let me = scene.add_in(kitchen, Draft::new("character")).unwrap();
    let graph = scene.build();
    let refusals = |text: &str| rule::refusals(&graph, me, &text.parse().unwrap());
    let label = graph.label(table);
    for good in ["walk kitchen_table.2", "walk KitchenTable.2", "walk table.2", "walk #2", "[WALK] <kitchentable> (2)"]
    {
        assert_eq!(refusals(good), [], "{good}");
    }
    for wrong in ["touch apple.2", "walk apple.2", "find milk.2", "[TOUCH] <apple> (2)", "grab apple.2"] {
        assert_eq!(refusals(wrong), [Refusal::Misnamed(label.clone())], "{wrong}");
        assert!(!rule::allows(&graph, me, &wrong.parse().unwrap()), "{wrong}");
    }
    let second = format!("place apple.{} apple.{}", apple.0, table.0);
    assert_eq!(refusals(&second), [Refusal::Misnamed(label)]);
    // It compares equal to the plain action, and prints as the plain action does.
    let (named, plain): (Action, Action) = ("grab apple.3".parse().unwrap(), Action::one(Verb::Grab, apple));
    assert_eq!((named, named.to_string()), (plain, "grab #3".to_owned()));
}

#[test]
fn numbers_that_no_node_can_have_are_errors() {
    for text in ["On(#4294967296, a)", "Holds(apple.99999999999)", "Holds(apple.1x)", "Eat(#x)", "Eat(#)"] {
        let error = text.parse::<Goal>().unwrap_err().to_string();
        assert!(error.contains("expected the number of a node"), "{text}: {error}");
    }
    for text in ["[GRAB] <cup> (1.6.7)", "[GRAB] <cup> (a.7)", "[GRAB] <cup> (4294967296)", "[GRAB] <cup> (1.)"] {
        assert!(text.parse::<Action>().is_err(), "{text}");
    }
    assert_eq!("[GRAB] <cup> (1.7)".parse::<Action>().unwrap(), Action::one(Verb::Grab, NodeId(7)));
}

/// Names of numbers and symbols are classes of their own, and their labels are read back.
#[test]
fn names_of_symbols_are_distinct() {
    let names = ["-1", "1", "_1", "😀_1", "😀1", "😀", "1😀", "!?"];
    let mut scene = vc_graph::SceneBuilder::new("odd");
    let ids = names.map(|name| scene.add(vc_graph::Draft::new(name)).unwrap());
    let graph = scene.build();
    let classes: std::collections::BTreeSet<&str> = graph.nodes().map(|n| &**n.class()).collect();
    assert_eq!(classes.len(), names.len(), "{classes:?}");
    for id in ids {
        let label = graph.label(id);
        assert_eq!(label.to_string().parse::<vc_graph::Label>().unwrap(), label);
    }
}

#[test]
fn actions_by_name_are_those_of_the_text() {
    let (x, y) = (NodeId(12), NodeId(3));
    for (action, text) in [
        (Action::walk(x), "walk #12"),
        (Action::find(x), "find #12"),
        (Action::grab(x), "grab #12"),
        (Action::place(x, y), "place #12 #3"),
        (Action::put_in(x, y), "put_in #12 #3"),
        (Action::put_back(x), "put_back #12"),
        (Action::drop(x), "drop #12"),
        (Action::open(x), "open #12"),
        (Action::close(x), "close #12"),
        (Action::switch_on(x), "switch_on #12"),
        (Action::switch_off(x), "switch_off #12"),
        (Action::sit(x), "sit #12"),
        (Action::lie(x), "lie #12"),
        (Action::stand(), "stand"),
        (Action::eat(x), "eat #12"),
        (Action::drink(x), "drink #12"),
        (Action::pour(x, y), "pour #12 #3"),
        (Action::wash(x), "wash #12"),
        (Action::wear(x), "wear #12"),
        (Action::take_off(x), "take_off #12"),
    ] {
        assert_eq!(text.parse(), Ok(action));
        assert_eq!(action.things().count(), action.verb.arity(), "{text}");
    }
}

#[test]
fn what_a_simulator_returns_is_written_as_json() {
    let mut scene = SceneBuilder::new("flat");
    let kitchen = scene.add(Draft::new("kitchen")).unwrap();
    let fridge = scene.add_in(kitchen, Draft::new("fridge")).unwrap();
    scene.add_in(fridge, Draft::new("milk")).unwrap();
    let me = scene.add_in(kitchen, Draft::new("character")).unwrap();
    let mut home = Simulator::new(scene.build());
    let seen = home.graph().observe(me, Scope::Room);
    assert!(
        serde_json::to_string(&seen)
            .unwrap()
            .starts_with(r#"{"agent":4,"scope":"room","room":1,"objects":[{"id":2,"class":"fridge","#)
    );
    let refused = home.step(me, &Action::open(fridge)).unwrap_err();
    assert_eq!(serde_json::to_string(&refused).unwrap(), r#"[{"not_near":{"thing":"fridge.2","distance":null}}]"#);
    let changes = home.step(me, &Action::walk(fridge)).unwrap().then(home.step(me, &Action::open(fridge)).unwrap());
    let text = serde_json::to_string(&changes).unwrap();
    assert!(text.contains(r#"{"link":{"from":"#), "{text}");
    assert!(text.contains(r#"{"states":{"id":2,"before":["#), "{text}");
}
