//! Compiled goals compared with direct evaluation.
#![allow(clippy::unwrap_used)]

use crate::common;
use std::sync::Arc;

use common::{Room, flips, timeless};
use proptest::prelude::*;
use vc_graph::goal::{EpisodeTrace, Situation};
use vc_graph::{Action, Change, ChangeSet, Event, Goal, History, NodeId, SceneGraph};
use vc_tasks::compile::{CompileError, GoalProgram, Known, Monitor, Tracker, Verdict};
use vc_tasks::{GoalProgress, World, WorldError};
use vc_testkit::cases;
use vc_testkit::edits::{apply, plans};
use vc_testkit::goals::goal;
use vc_testkit::scenes::{scene, steps};

fn agree(program: &GoalProgram, goal: &Goal, now: &Situation<'_>) -> Result<(), TestCaseError> {
    let bits = program.read(now);
    prop_assert_eq!(program.holds(&bits), goal.holds(now), "{}", goal);
    for (head, part) in goal.conjuncts().iter().enumerate() {
        prop_assert_eq!(program.head_holds(&bits, head), part.holds(now), "{} of {}", part, goal);
    }
    Ok(())
}

proptest! {
    #![proptest_config(cases(2000))]

    #[test]
    fn a_program_holds_when_its_goal_does(goal in timeless(3), flips in flips(30)) {
        let room = Room::new(&flips);
        let program = GoalProgram::new(&goal, &room.now()).unwrap();
        agree(&program, &goal, &room.now())?;
    }

    #[test]
    fn a_tracker_says_what_a_new_look_would_say(goal in timeless(3), first in flips(20), then in flips(20)) {
        let mut room = Room::new(&first);
        let program = Arc::new(GoalProgram::new(&goal, &room.now()).unwrap());
        let mut tracker = Tracker::in_situation(program.clone(), &room.now());
        for flip in then {
            let changes = room.flip(flip);
            let holds = tracker.apply(&room.now(), &changes).unwrap();
            prop_assert_eq!(holds, goal.holds(&room.now()), "{}", goal);
            prop_assert_eq!(tracker.bits(), &program.read(&room.now()));
            for (head, part) in goal.conjuncts().iter().enumerate() {
                prop_assert_eq!(tracker.head_holds(head), part.holds(&room.now()), "{} of {}", part, goal);
            }
        }
    }

    #[test]
    fn what_is_unknown_does_not_matter_to_a_verdict(
        goal in timeless(2), flips in flips(30), mask in any::<u64>(), others in prop::collection::vec(any::<u64>(), 8)
    ) {
        let room = Room::new(&flips);
        let program = GoalProgram::new(&goal, &room.now()).unwrap();
        let bits = program.read(&room.now());
        let mut known = Known::nothing(&program);
        let hidden = |atom: usize| mask >> (atom % 64) & 1 != 0;
        (0..program.atoms().len()).filter(|&a| !hidden(a)).for_each(|a| known.learn(a, bits.has(a)));
        let verdict = program.verdict(&known);
        if mask == 0 {
            prop_assert_eq!(verdict, Verdict::from_bool(program.holds(&bits)));
        }
        for other in others {
            let mut completed = bits.clone();
            let unknown = (0..program.atoms().len()).filter(|&a| hidden(a));
            unknown.for_each(|a| completed.set(a, other >> (a % 64) & 1 != 0));
            if verdict != Verdict::Unknown {
                prop_assert_eq!(Verdict::from_bool(program.holds(&completed)), verdict, "{}", goal);
            }
        }
    }
}

proptest! {
    #![proptest_config(cases(400))]

    #[test]
    fn in_scenes_of_all_kinds(goal in goal(0, 2), steps in steps(12), posed: bool, plans in plans(8)) {
        let mut graph = scene(&steps, posed);
        let (agent, history) = (graph.agents()[0], History::default());
        let program = match GoalProgram::new(&goal, &Situation::new(&graph, agent, &history)) {
            Ok(program) => Arc::new(program),
            Err(error) => {
                prop_assert!(goal.is_temporal() && matches!(error, CompileError::Temporal(_)), "{}: {}", goal, error);
                return Ok(());
            }
        };
        agree(&program, &goal, &Situation::new(&graph, agent, &history))?;
        let mut tracker = Tracker::in_situation(program, &Situation::new(&graph, agent, &history));
        for plan in plans {
            let changes = apply(&mut graph, plan);
            let now = Situation::new(&graph, agent, &history);
            let stale = changes.changes().iter().any(|c| matches!(c, Change::Add(_) | Change::Remove(_)));
            match tracker.apply(&now, &changes) {
                Ok(holds) => prop_assert_eq!(holds, goal.holds(&now), "{} after {:?}", goal, changes),
                Err(_) => {
                    prop_assert!(stale);
                    tracker = Tracker::in_situation(Arc::new(GoalProgram::new(&goal, &now).unwrap()), &now);
                }
            }
        }
    }
}

/// A trace of a room with the given flips and actions, step by step.
fn course(first: &[common::Flip], then: &[(common::Flip, usize)]) -> (Room, EpisodeTrace) {
    let mut room = Room::new(first);
    let mut trace = EpisodeTrace::new(room.graph.clone(), room.me);
    for &(flip, chosen) in then {
        room.flip(flip);
        let lines = ["", "grab #2", "grab #5", "eat #3", "place #2 #5"];
        let action = lines[chosen % lines.len()].parse::<vc_graph::Action>();
        trace.push(room.graph.clone(), action.map(|action| Event { agent: room.me, action }));
    }
    (room, trace)
}

proptest! {
    #![proptest_config(cases(3000))]

    #[test]
    fn a_monitor_says_what_a_reading_of_the_trace_would(
        goal in common::temporal(3), first in flips(20), then in prop::collection::vec((common::flip(), 0_usize..5), 0..7)
    ) {
        let (room, trace) = course(&first, &then);
        let start = Situation { events: &[], ..trace.situation(0).unwrap() };
        let mut monitor = Monitor::new(&goal, &start).unwrap();
        let mut held = vec![None; goal.conjuncts().len()];
        for step in 0..=trace.steps() {
            if step > 0 {
                monitor.push(&trace.situation(step).unwrap());
            }
            prop_assert_eq!(monitor.steps(), step);
            prop_assert_eq!(monitor.holds(), goal.holds_by(&trace, step), "{} by step {}", goal, step);
            for (head, part) in goal.conjuncts().iter().enumerate() {
                prop_assert_eq!(monitor.heads()[head], part.holds_by(&trace, step), "{} by step {}", part, step);
                held[head] = held[head].or_else(|| monitor.heads()[head].then_some(step));
            }
        }
        prop_assert_eq!(monitor.holds(), goal.holds_on(&trace));
        prop_assert_eq!(monitor.first_held(), &held[..]);
        prop_assert_eq!(vc_tasks::first_held(&goal, &trace), held);
        prop_assert!(goal.is_temporal() || GoalProgram::new(&goal, &room.now()).is_ok());
    }
}

/// A world to which anything can happen.
struct Shown {
    room: Room,
}

impl World for Shown {
    fn graph(&self) -> &SceneGraph {
        &self.room.graph
    }

    fn history(&self) -> &History {
        &self.room.history
    }

    fn step(&mut self, _: NodeId, _: &Action) -> Result<ChangeSet, WorldError> {
        Err(WorldError::Failed("it is shown".into()))
    }

    fn reset(&mut self, _: &SceneGraph) -> Result<(), WorldError> {
        Ok(())
    }
}

proptest! {
    #![proptest_config(cases(1000))]

    #[test]
    fn progress_says_what_a_reading_of_the_trace_would(
        goal in common::temporal(3), first in flips(20), then in prop::collection::vec((common::flip(), 0_usize..4), 0..7),
        adds in 0_usize..9
    ) {
        let mut world = Shown { room: Room::new(&first) };
        let me = world.room.me;
        let mut progress = GoalProgress::new(&goal, &world, me);
        let mut trace = EpisodeTrace::new(world.room.graph.clone(), me);
        for (number, (flip, chosen)) in then.into_iter().enumerate() {
            world.room.flip(flip);
            if number == adds {
                let mut edit = world.room.graph.edit();
                edit.add(vc_graph::Draft::new("cup")).unwrap();
                edit.commit();
            }
            let action = ["grab #2", "grab #5", "eat #3", "place #2 #5"][chosen].parse().unwrap();
            let event = Event { agent: me, action };
            world.room.history.push(event);
            trace.push(world.room.graph.clone(), [event]);
            progress.note(&world);
            prop_assert_eq!(progress.holds(&world), goal.holds_on(&trace), "{}", goal);
            prop_assert_eq!(progress.score(&world), goal.score_on(&trace), "{}", goal);
        }
    }
}

/// Actions at the end are undone, and other ones done; whether that was noted in between does not matter.
#[derive(Debug, Clone)]
struct Turn {
    undone: usize,
    noted: bool,
    flip: common::Flip,
    chosen: usize,
}

fn turn() -> impl Strategy<Value = Turn> {
    let all = (0_usize..3, any::<bool>(), common::flip(), 0_usize..4);
    all.prop_map(|(undone, noted, flip, chosen)| Turn { undone, noted, flip, chosen })
}

proptest! {
    #![proptest_config(cases(1000))]

    #[test]
    fn what_is_undone_counts_no_more(
        goal in common::temporal(3), first in flips(20), earlier: bool, turns in prop::collection::vec(turn(), 0..7)
    ) {
        let mut world = Shown { room: Room::new(&first) };
        let me = world.room.me;
        let event = |chosen: usize| {
            let action = ["grab #2", "grab #5", "eat #3", "place #2 #5"][chosen % 4].parse().unwrap();
            Event { agent: me, action }
        };
        if earlier {
            world.room.history.push(event(0));
        }
        let mut progress = GoalProgress::new(&goal, &world, me);
        let start = world.room.graph.clone();
        let mut done: Vec<(Event, SceneGraph)> = Vec::new();
        for Turn { undone, noted, flip, chosen } in turns {
            let kept = done.len() - undone.min(done.len());
            let other = done.get(kept).map(|(event, _)| *event);
            for _ in done.drain(kept..) {
                world.room.history.pop();
            }
            world.room.graph = done.last().map_or(&start, |(_, graph)| graph).clone();
            if noted {
                progress.note(&world);
            }
            world.room.flip(flip);
            let next = if Some(event(chosen)) == other { event(chosen + 1) } else { event(chosen) };
            world.room.history.push(next);
            done.push((next, world.room.graph.clone()));
            progress.note(&world);
            let mut trace = EpisodeTrace::new(start.clone(), me);
            done.iter().for_each(|(event, graph)| trace.push(graph.clone(), [*event]));
            prop_assert_eq!(progress.holds(&world), goal.holds_on(&trace), "{}", goal);
            prop_assert_eq!(progress.score(&world), goal.score_on(&trace), "{}", goal);
        }
    }
}

fn program(text: &str, room: &Room) -> GoalProgram {
    GoalProgram::new(&text.parse().unwrap(), &room.now()).unwrap()
}

#[test]
fn equal_parts_are_one() {
    let room = Room::new(&[]);
    let part = "exists ?p: plate. Covered(?c, ?p)";
    let one = program(&format!("forall ?c: cup. {part}"), &room);
    let two = program(&format!("(forall ?c: cup. {part}) & (forall ?c: cup. ({part}) | Dusty(?c))"), &room);
    assert_eq!(one.atoms().len(), 9);
    assert_eq!((one.size().0, two.size().0), (4, 9), "three gates are shared");
}

#[test]
fn a_goal_that_is_true_in_many_ways_stays_small() {
    let room = Room::new(&[]);
    let text = "forall ?c: cup. exists ?p: plate. exists ?q: plate. (Covered(?c, ?p) | Draped(?c, ?q)) & (Dusty(?p) | Stained(?q))";
    let (gates, inputs) = program(text, &room).size();
    assert!(gates < 100 && inputs < 200, "{gates} {inputs}");
}

#[test]
fn derived_predicates_are_compiled_as_their_definitions() {
    let words = "predicate messy ?x | is: Dusty(?x) | Stained(?x)\npredicate under_wraps ?x ?y | is: Covered(?x, ?y) & messy(?y)";
    let mut room = Room::new(&[(0, 0, 0), (1, 3, 0), (2, 0, 3), (3, 1, 4)]);
    room.graph.set_vocabulary(vc_graph::Vocabulary::parse("words.txt", words).unwrap());
    let pairs = [
        ("Messy(cup)", "Dusty(cup) | Stained(cup)"),
        ("forall ?p: plate. Messy(?p)", "forall ?p: plate. Dusty(?p) | Stained(?p)"),
        (
            "UnderWraps(cup, plate), 2",
            "at least 2 ?c: cup. exists ?p: plate. Covered(?c, ?p) & (Dusty(?p) | Stained(?p))",
        ),
    ];
    for (short, long) in pairs {
        let (goal, same): (Goal, Goal) = (short.parse().unwrap(), long.parse().unwrap());
        let program = GoalProgram::new(&goal, &room.now()).unwrap();
        let bits = program.read(&room.now());
        assert_eq!(program.holds(&bits), same.holds(&room.now()), "{short}");
        assert_eq!(goal.holds(&room.now()), same.holds(&room.now()), "{short}");
    }
    let parts = vc_tasks::explain(&"Messy(cup) & UnderWraps(cup, plate)".parse().unwrap(), &room.now()).unwrap();
    assert_eq!(parts.iter().map(|part| part.holds).collect::<Vec<_>>(), [true, true]);
    assert_eq!(parts[0].goal.to_string(), "Messy(cup)");
    // Over time: it was messy at first and no longer is.
    let mut trace = EpisodeTrace::new(room.graph.clone(), room.me);
    room.flip((0, 0, 0));
    trace.push(room.graph.clone(), []);
    let goal: Goal = "eventually Messy(cup.2) & !Messy(cup.2)".parse().unwrap();
    assert!(goal.holds_on(&trace) && Monitor::from_trace(&goal, &trace).unwrap().holds());
}

#[test]
fn what_cannot_be_compiled_says_why() {
    let room = Room::new(&[]);
    let error = GoalProgram::new(&"Dusty(cup) & eventually Dusty(plate)".parse().unwrap(), &room.now()).unwrap_err();
    assert_eq!(error.to_string(), "`eventually Dusty(plate)` is about several steps; follow it with a `Monitor`");
    let wide: Goal =
        "forall ?a. forall ?b. forall ?c. forall ?d. forall ?e. forall ?f. forall ?g. forall ?h. Covered(?a, ?h)"
            .parse()
            .unwrap();
    assert!(GoalProgram::new(&wide, &room.now()).is_ok_and(|p| p.size().0 > 0));
}

#[test]
fn goals_that_range_over_too_much_are_refused_and_others_take_no_time() {
    let room = Room::new(&[(0, 0, 0)]);
    let quantified =
        |word: &str, depth: usize| -> String { (0..depth).map(|i| format!("{word} ?v{i}. ")).collect::<String>() };
    let all: Vec<String> = (0..8).map(|i| format!("Dusty(?v{i})")).collect();
    let wide: Goal = format!("{}({})", quantified("forall", 8), all.join(" & ")).parse().unwrap();
    assert!(matches!(GoalProgram::new(&wide, &room.now()), Err(CompileError::TooLarge(_))));
    assert!(matches!(Monitor::new(&wide, &room.now()), Err(CompileError::TooLarge(_))));
    // A subgoal that does not depend on the variables is stored once, however often it counts.
    for word in ["forall", "exists", "at least 2", "exactly 3"] {
        let goal: Goal = format!("{}Dusty(cup)", quantified(word, 20)).parse().unwrap();
        let program = GoalProgram::new(&goal, &room.now()).unwrap();
        let bits = program.read(&room.now());
        assert_eq!(program.verdict(&Known::nothing(&program)), Verdict::Unknown, "{word}");
        let credit = program.credit(&bits);
        assert!(!credit.exact || (credit.value() == 1.0) == program.holds(&bits), "{word}");
        assert!(program.unmet(&bits, 3).sets.len() <= 3);
    }
}
