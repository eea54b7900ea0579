//! Processes that machines and matter go through by themselves, and how long actions take.
#![allow(clippy::unwrap_used)]

use proptest::prelude::*;
use vc_graph::clock::{ClockError, Durations, ProcessTable, Running, Span, Tick};
use vc_graph::{Action, ChangeSet, ClassTable, Draft, NodeId, SceneBuilder, SceneGraph, State, StateSet, Verb, Word};
use vc_testkit::cases;

fn text(name: &str) -> String {
    std::fs::read_to_string(format!("{}/data/{name}", env!("CARGO_MANIFEST_DIR"))).unwrap()
}

fn table(lines: &str) -> ProcessTable {
    ProcessTable::parse("test", lines, &ClassTable::builtin()).unwrap_or_else(|e| panic!("{e}"))
}

#[test]
fn builtin_texts_are_well_formed() {
    let classes = ClassTable::builtin();
    let processes = ProcessTable::parse("processes.txt", &text("processes.txt"), &classes);
    assert_eq!(processes.unwrap_or_else(|e| panic!("{e}")), *ProcessTable::builtin());
    let durations = Durations::parse("durations.txt", &text("durations.txt"), &classes);
    assert_eq!(durations.unwrap_or_else(|e| panic!("{e}")), *Durations::builtin());
    let names: Vec<String> = ProcessTable::builtin().names().map(str::to_owned).collect();
    assert!(names.len() >= 15, "{names:?}");
}

/// A thing in a place in a kitchen, both in further states.
fn thing_in(thing: (&str, &[State]), place: Option<(&str, &[State])>) -> (SceneGraph, NodeId) {
    let draft = |(class, states): (&str, &[State])| Draft { entering: states.to_vec(), ..Draft::new(class) };
    let mut scene = SceneBuilder::new("flat");
    let kitchen = scene.add(Draft::new("kitchen")).unwrap();
    let at = place.map_or(kitchen, |place| scene.add_in(kitchen, draft(place)).unwrap());
    let thing = scene.add_in(at, draft(thing)).unwrap();
    (scene.build(), thing)
}

#[test]
fn things_change_by_themselves_in_their_time() {
    type Case<'a> = ((&'a str, &'a [State]), Option<(&'a str, &'a [State])>, &'a str);
    let cases: [Case<'_>; 22] = [
        (("soup", &[State::Hot]), None, "cooling 40 min"),
        (("sandwich", &[State::Hot]), None, "cooling 30 min"),
        (("mug", &[State::Hot]), None, "cooling 20 min"),
        (("thermos", &[State::Hot]), None, "cooling 720 min"),
        (("mug", &[State::Hot]), Some(("microwave", &[State::On])), ""),
        (("mug", &[]), Some(("microwave", &[State::On])), "heating 2 min"),
        (("mug", &[]), Some(("microwave", &[State::Off])), ""),
        (("ice", &[]), None, "warming 60 min, melting 45 min"),
        (("ice_cream", &[]), Some(("freezer", &[State::On])), "freezing 240 min"),
        (("juice", &[]), Some(("fridge", &[State::On])), "chilling 180 min"),
        (("juice", &[]), Some(("fridge", &[])), ""),
        (("cake", &[State::Frozen]), Some(("fridge", &[State::On, State::Cold])), "chilling 120 min, thawing 1440 min"),
        (("cake", &[State::Frozen, State::Cold]), Some(("freezer", &[State::On])), ""),
        (("apple", &[State::Raw]), Some(("oven", &[State::On])), "heating 15 min, cooking 30 min"),
        (("egg", &[State::Raw]), Some(("microwave", &[State::On])), "heating 2 min, cooking 5 min"),
        (("pizza", &[State::Raw]), Some(("pizza_oven", &[State::On])), "heating 15 min, cooking 3 min"),
        (("shirt", &[State::Wet]), None, "drying 720 min"),
        (("shirt", &[State::Wet]), Some(("clothesline", &[])), "drying 360 min"),
        (("shirt", &[State::Wet]), Some(("washing_machine", &[])), ""),
        (("kettle", &[State::On]), None, ""),
        (("kettle", &[State::On, State::Filled]), None, "boiling 4.5 min"),
        (("tealight", &[State::On]), None, "burning 240 min"),
    ];
    for (thing, place, expected) in cases {
        let (graph, id) = thing_in(thing, place);
        let found = ProcessTable::builtin().processes(&graph);
        let of_it = found.iter().filter(|process| process.node == id);
        let found: Vec<String> = of_it.map(|p| format!("{} {} min", p.name, p.after.seconds() / 60.0)).collect();
        assert_eq!(found.join(", "), expected, "{thing:?} in {place:?}");
    }
}

#[test]
fn the_last_line_of_a_name_counts_and_users_add_lines() {
    let (graph, soup) = thing_in(("soup", &[State::Hot]), None);
    let quick = "cooling | food | hot | | | -hot | | | 1 min\nsmelling | soup | hot | | | dirty | | | 1 s";
    let table = ProcessTable::builtin().extended("mine.txt", quick, &ClassTable::builtin()).unwrap();
    let found = table.processes(&graph);
    let after: Vec<(&str, f64)> = found.iter().map(|p| (&*p.name, p.after.seconds())).collect();
    assert_eq!(after, [("cooling", 60.0), ("smelling", 1.0)]);
    assert_eq!(found[1].changes, [(soup, StateSet::from_words(&[State::Raw, State::Hot, State::Dirty]))]);
    // A line that changes nothing switches those before it off.
    let never = table.extended("never.txt", "cooling | soup | | | | hot | | | 1 min", &ClassTable::builtin()).unwrap();
    assert_eq!(never.processes(&graph).len(), 1);
}

#[test]
fn kinds_of_a_users_class_count() {
    let line = "gizmo | food | | appliance | container switchable | 0.1 0.1 0.1 | 0.2 | off | | kitchen:1";
    let classes = std::sync::Arc::new(ClassTable::builtin().extended("mine.txt", line).unwrap());
    let mut scene = SceneBuilder::with_classes("flat", classes.clone());
    let gizmo = scene.add(Draft::new("gizmo").state(State::Hot)).unwrap();
    let graph = scene.build();
    assert_eq!(ProcessTable::builtin().processes(&graph)[0].node, gizmo, "a kind of food cools");
    let blinking = "blinking | category:appliance | hot -on | | | on | | | 1 s\nhumming | gizmo | | | | wet | | | 1 s";
    let found = ProcessTable::parse("mine.txt", blinking, &classes).unwrap().processes(&graph);
    assert_eq!(found.len(), 2);
}

#[test]
fn errors_say_where_and_what_to_do() {
    let cases = [
        ("a | * | hot", "process", "9 columns"),
        (" | * | hot | | | -hot | | | 1 s", "process", "name is missing"),
        ("a b | * | hot | | | -hot | | | 1 s", "process", "name is missing"),
        ("a | | hot | | | -hot | | | 1 s", "things", "`*` for all things"),
        ("a | mugg | hot | | | -hot | | | 1 s", "things", "did you mean `mug`"),
        ("a | category:fod | hot | | | -hot | | | 1 s", "things", "did you mean `food`"),
        ("a | affords:wash | hot | | | -hot | | | 1 s", "things", "unknown property `wash`"),
        ("a | * | hott | | | -hot | | | 1 s", "while", "did you mean `hot`"),
        ("a | * | hot cold | | | -hot | | | 1 s", "while", "`hot cold` exclude each other"),
        ("a | * | running | | | -hot | | | 1 s", "while", "of a place only"),
        ("a | * | hot | fridge | | -hot | | | 1 s", "place", "`in fridge`"),
        ("a | * | hot | near fridge | | -hot | | | 1 s", "place", "`in fridge`"),
        ("a | * | hot | in fridg | | -hot | | | 1 s", "place", "did you mean `fridge`"),
        ("a | * | hot | | on | -hot | | | 1 s", "place is", "no place"),
        ("a | * | hot | in fridge | onn | -hot | | | 1 s", "place is", "unknown state `onn`"),
        ("a | * | hot | | | | | | 1 s", "becomes", "nothing becomes of it"),
        ("a | * | hot | | | hot -hot | | | 1 s", "becomes", "keep one of them"),
        ("a | * | hot | | | -hot | * | | 1 s", "inside becomes", "together or not at all"),
        ("a | * | hot | | | -hot | | wet | 1 s", "inside", "together or not at all"),
        ("a | * | hot | | | -hot | | | soon", "after", "`45 min`"),
        ("a | * | hot | | | -hot | | | 0.001 s", "after", "less than a tick"),
    ];
    for (line, column, message) in cases {
        let text = format!("# a comment\n\nfine | * | hot | | | -hot | | | 1 s\n{line}");
        let error = ProcessTable::parse("mine.txt", &text, &ClassTable::builtin()).unwrap_err();
        assert_eq!((&*error.file, error.line, error.column), ("mine.txt", 4, column), "{line}: {error}");
        assert!(error.to_string().contains(message), "{line}: {error}");
    }
    let durations = |text| Durations::parse("mine.txt", text, &ClassTable::builtin()).map(|_| ());
    let column = |text| durations(text).map_err(|error: ClockError| error.column);
    let found = ["eat | *", "eet | * | 1 s", "eat | aple | 1 s", "eat | * | 0 s", "eat | apple | 1 s"].map(column);
    assert_eq!(found, [Err("verb"), Err("verb"), Err("things"), Err("takes"), Ok(())]);
}

proptest! {
    #![proptest_config(cases(300))]

    #[test]
    fn no_text_is_too_odd(text in "([a-z* :|#\\-0-9é]|\\| |hot|in |food|1 s|\n){0,60}") {
        let classes = ClassTable::builtin();
        let _ = ProcessTable::parse("odd", &text, &classes);
        let _ = Durations::parse("odd", &text, &classes);
    }
}

fn minutes(n: f64) -> Span {
    Span::from_seconds(60.0 * n)
}

fn enter(graph: &mut SceneGraph, id: NodeId, state: State) {
    let mut edit = graph.edit();
    edit.enter_state(id, state).unwrap();
    edit.commit();
}

#[test]
fn a_machine_that_is_stopped_begins_anew() {
    let (mut graph, shirt) = thing_in(("shirt", &[State::Dirty]), Some(("washing_machine", &[State::On])));
    let machine = graph.first_of_class("washing_machine").unwrap();
    let (table, mut running) = (ProcessTable::builtin(), Running::default());
    let is = |graph: &SceneGraph, state| graph.node(shirt).unwrap().is(state);
    assert!(running.advance(&table, &mut graph, minutes(80.0)).unwrap().is_empty());
    enter(&mut graph, machine, State::Off);
    assert!(running.advance(&table, &mut graph, minutes(20.0)).unwrap().is_empty());
    enter(&mut graph, machine, State::On);
    assert!(running.advance(&table, &mut graph, minutes(90.0) + Span(0)).unwrap().changes().len() == 2);
    assert!(is(&graph, State::Clean) && is(&graph, State::Wet) && graph.node(machine).unwrap().is(State::Off));
    assert_eq!(running.tick(), Tick(0) + minutes(190.0));
    assert_eq!(running.next_due(), None, "nothing dries in there");
}

#[test]
fn what_lies_on_a_machine_is_not_washed() {
    let (mut graph, _) = thing_in(("shirt", &[State::Dirty]), Some(("washing_machine", &[State::On])));
    let machine = graph.first_of_class("washing_machine").unwrap();
    let mut edit = graph.edit();
    let towel = edit.add(Draft::new("towel").state(State::Dirty)).unwrap();
    edit.place(towel, vc_graph::Place { relation: vc_graph::Relation::On, at: machine }).unwrap();
    edit.commit();
    Running::default().advance(&ProcessTable::builtin(), &mut graph, minutes(90.0)).unwrap();
    assert!(graph.node(towel).unwrap().is(State::Dirty));
}

#[test]
fn a_process_of_another_duration_begins_anew() {
    let (mut graph, egg) = thing_in(("egg", &[State::Hot]), Some(("oven", &[State::On])));
    let oven = graph.place(egg).unwrap().at;
    let mut edit = graph.edit();
    let microwave = edit.add(Draft::new("microwave")).unwrap();
    edit.commit();
    let (table, mut running) = (ProcessTable::builtin(), Running::default());
    running.advance(&table, &mut graph, minutes(9.0)).unwrap();
    let mut edit = graph.edit();
    edit.place(egg, vc_graph::Place { relation: vc_graph::Relation::Inside, at: microwave }).unwrap();
    edit.enter_state(microwave, State::On).unwrap();
    edit.commit();
    running.advance(&table, &mut graph, minutes(4.0)).unwrap();
    assert!(graph.node(egg).unwrap().is(State::Raw));
    running.advance(&table, &mut graph, minutes(1.0)).unwrap();
    assert!(graph.node(egg).unwrap().is(State::Cooked));
    assert!(graph.node(oven).unwrap().is(State::On));
}

#[test]
fn what_ends_in_one_tick_ends_together() {
    // Each needs what the other takes away.
    let both = "a | * | hot | | | -hot wet | | | 1 s\nb | * | hot | | | dirty | | | 1 s";
    let (mut graph, mug) = thing_in(("mug", &[State::Hot]), None);
    Running::default().advance(&table(both), &mut graph, Span::from_seconds(1.0)).unwrap();
    assert_eq!(graph.node(mug).unwrap().states(), StateSet::from_words(&[State::Dirty, State::Wet]));
}

#[test]
fn time_ends_even_if_something_blinks() {
    let blinking = table("a | * | on | | | off | | | 1 s\nb | * | off | | | on | | | 1 s");
    let (mut graph, _) = thing_in(("table_lamp", &[State::On]), None);
    let mut running = Running::new(Tick(u64::MAX - 150));
    let changes = running.advance(&blinking, &mut graph, Span::MAX).unwrap();
    assert_eq!((changes.changes().len(), running.tick()), (3, Tick(u64::MAX)));
}

#[test]
fn saved_processes_go_on_and_odd_ones_do_no_harm() {
    let table = ProcessTable::builtin();
    let (mut graph, _) = thing_in(("soup", &[State::Hot]), None);
    let mut running = Running::default();
    running.advance(&table, &mut graph, minutes(39.0)).unwrap();
    let saved = serde_json::to_string(&running).unwrap();
    let mut restored: Running = serde_json::from_str(&saved).unwrap();
    assert_eq!(restored, running);
    let mut copy = graph.clone();
    let changes = restored.advance(&table, &mut copy, minutes(1.0)).unwrap();
    assert_eq!(changes, running.advance(&table, &mut graph, minutes(1.0)).unwrap());
    assert!(!changes.is_empty() && copy == graph);

    let soup = copy.first_of_class("soup").unwrap().0;
    let odd =
        [(soup, "cooling", u64::MAX, 144_000), (soup, "cooling", 0, 0), (9999, "cooling", 0, 1), (soup, "?", 5, 1)];
    for (node, process, begin, after) in odd {
        let entry = format!(r#"{{"node": {node}, "process": "{process}", "begin": {begin}, "after": {after}}}"#);
        let odd = format!(r#"{{"tick": 7, "running": [{entry}]}}"#);
        let mut running: Running = serde_json::from_str(&odd).unwrap();
        running.advance(&table, &mut copy.clone(), minutes(50.0)).unwrap();
        assert_eq!(running.tick(), Tick(7) + minutes(50.0));
    }
}

/// A flat with machines and things in them.
fn small_flat() -> (SceneGraph, Vec<NodeId>) {
    let mut scene = SceneBuilder::new("flat");
    let kitchen = scene.add(Draft::new("kitchen")).unwrap();
    let machines =
        ["stove", "fridge", "washing_machine", "kettle"].map(|class| scene.add_in(kitchen, Draft::new(class)).unwrap());
    let mut things = machines.to_vec();
    for (class, at) in [("soup", machines[0]), ("juice", machines[1]), ("shirt", machines[2]), ("mug", kitchen)] {
        things.push(scene.add_in(at, Draft::new(class)).unwrap());
    }
    (scene.build(), things)
}

/// Random lines; each word is one that fits its column.
fn any_line() -> impl Strategy<Value = String> {
    let of = |words: &'static [&'static str]| prop::sample::select(words);
    let place = of(&["| ", "at stove | on", "away stove | ", "in affords:cooler | running", "at * | -hot"]);
    let inside = of(&["| ", "* | wet", "affords:washable | clean -wet"]);
    (
        of(&["a", "b", "c"]),
        of(&["*", "food", "affords:washable", "appliance", "kettle mug"]),
        of(&["", "hot", "-hot", "on", "off", "-wet", "cold -dirty"]),
        place,
        of(&["hot", "-hot", "cold", "off", "on", "wet", "-wet dirty"]),
        inside,
        of(&["0.02 s", "0.1 s", "0.25 s", "0.5 s", "1 s"]),
    )
        .prop_map(|(name, things, states, place, becomes, inside, after)| {
            format!("{name} | {things} | {states} | {place} | {becomes} | {inside} | {after}")
        })
}

proptest! {
    #![proptest_config(cases(150))]

    #[test]
    fn a_jump_is_as_good_as_single_ticks(
        lines in prop::collection::vec(any_line(), 1..7),
        steps in prop::collection::vec((0..8_usize, 0..10_usize, 1..70_u64), 1..8),
    ) {
        let table = table(&lines.join("\n"));
        let (mut jumped, things) = small_flat();
        let mut ticked = jumped.clone();
        let (mut jump, mut tick) = (Running::default(), Running::default());
        for (thing, state, span) in steps {
            enter(&mut jumped, things[thing], State::ALL[state]);
            enter(&mut ticked, things[thing], State::ALL[state]);
            let before = jumped.clone();
            let at_once = jump.advance(&table, &mut jumped, Span(span)).unwrap();
            let mut one_by_one = ChangeSet::default();
            for _ in 0..span {
                one_by_one = one_by_one.then(tick.advance(&table, &mut ticked, Span(1)).unwrap());
            }
            prop_assert_eq!(&at_once, &one_by_one);
            prop_assert_eq!(&jumped, &ticked);
            prop_assert_eq!(&jump, &tick);
            prop_assert!(jumped.nodes().all(|node| node.states().conflicts().next().is_none()));
            let mut undone = jumped.clone();
            at_once.undo(&mut undone).unwrap();
            prop_assert_eq!(undone, before);
        }
    }
}

#[test]
fn every_verb_is_timed_by_the_table_a_motion_or_a_process() {
    let (graph, mug) = thing_in(("mug", &[]), None);
    let action = |verb: Verb| Action::with(verb, &[mug, mug][..verb.arity()]).unwrap();
    let takes = |verb: Verb| Durations::builtin().takes(&graph, &action(verb));
    let others: Vec<&str> = Verb::ALL.iter().filter(|verb| takes(**verb).is_none()).map(|verb| verb.as_str()).collect();
    let motions = "walk run find turn_to grab place put_in put_back drop open close sit lie stand";
    let vehicles = "enter leave drive";
    assert_eq!(others.join(" "), format!("{motions} cook {vehicles} heat cool"));
}

#[test]
fn an_action_takes_as_long_as_its_last_line_says() {
    let (graph, bread) = thing_in(("bread_slice", &[]), None);
    let line = "eat | bread | 30 s\nsleep | * | 20 min";
    let mine = Durations::builtin().extended("mine.txt", line, &ClassTable::builtin()).unwrap();
    let seconds = |table: &Durations, action: Action| table.takes(&graph, &action).map(Span::seconds);
    let (eat, sleep) = (Action::one(Verb::Eat, bread), Action::zero(Verb::Sleep));
    assert_eq!((seconds(&Durations::builtin(), eat), seconds(&mine, eat)), (Some(120.0), Some(30.0)));
    assert_eq!((seconds(&Durations::builtin(), sleep), seconds(&mine, sleep)), (Some(28_800.0), Some(1200.0)));
}

proptest! {
    #![proptest_config(cases(40))]

    /// To take note of changes gives the same as to look at the whole scene.
    #[test]
    fn changes_are_noticed_as_the_whole_scene_is(
        steps in vc_testkit::scenes::steps(24),
        plans in vc_testkit::edits::plans(24),
    ) {
        let (table, mut graph) = (ProcessTable::builtin(), vc_testkit::scenes::scene(&steps, false));
        let mut whole = Running::default();
        whole.notice(&table, &graph);
        let mut part = whole.clone();
        for plan in plans {
            let changes = vc_testkit::edits::apply(&mut graph, plan);
            let nodes: Vec<NodeId> = changes.nodes().collect();
            part.notice_changed(&table, &graph, &nodes);
            whole.notice(&table, &graph);
            prop_assert_eq!(&part, &whole);
            let mut other = graph.clone();
            let by = Span(30 * 60 * 60);
            prop_assert_eq!(part.pass(&table, &mut graph, by).unwrap(), whole.advance(&table, &mut other, by).unwrap());
            prop_assert_eq!(&part, &whole);
            prop_assert_eq!(&graph, &other);
        }
    }
}
