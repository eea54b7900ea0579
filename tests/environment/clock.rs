//! Actions that take time: how time is divided changes nothing, and agents in each other's way.

mod contested;
mod meeting;
mod passing;
mod pushed;
mod rule_alone;
mod saved;

use virtualcity::graph::clock::{Durations, Span, Tick};
use virtualcity::graph::{Action, NodeId, Place, Property, Relation, Seed, State, Verb};
use virtualcity::{ActionError, AlterError, Ending, Environment, Interruption, Spot, Steering, legal_action};

use super::act;

/// Longer than any action takes.
const LONG: Span = Span(3600);

/// A home in which actions take no longer than bodies need for them.
fn home(seed: u64, agents: usize) -> Environment {
    let builder = Environment::builder(format!("apartment/{seed}")).agents(agents);
    builder.durations(Durations::default()).make().unwrap()
}

/// Gives actions, each after a span, and lets time pass in steps of a length until all are done.
fn run(home: &Environment, orders: &[(Span, NodeId, Action)], step: Span) -> (Environment, Vec<Ending>) {
    let (mut home, begin, mut endings) = (home.clone(), home.tick(), Vec::new());
    let mut orders: Vec<_> = orders.to_vec();
    while home.tick() - begin < LONG && (home.is_busy() || !orders.is_empty()) {
        let now = home.tick() - begin;
        for (_, agent, action) in orders.extract_if(.., |order| order.0 <= now) {
            home.give(agent, action);
        }
        let next = orders.iter().map(|order| Span(order.0.0 - now.0)).min().unwrap_or(Span(LONG.0 - now.0));
        endings.extend(home.step(step.min(next)));
    }
    let rest = LONG.0.saturating_sub((home.tick() - begin).0);
    endings.extend(home.step(Span(rest)));
    (home, endings)
}

/// The outcome of some orders, which is the same however time is divided and in which order they are given.
fn outcome(home: &Environment, orders: &[(Span, NodeId, Action)]) -> (Environment, Vec<Ending>) {
    let (end, endings) = run(home, orders, LONG);
    let reversed: Vec<_> = orders.iter().rev().copied().collect();
    for (step, given) in [(1, &reversed[..]), (7, orders), (LONG.0, &reversed[..])] {
        let (other, told) = run(home, given, Span(step));
        assert_eq!(told, endings, "in steps of {step}");
        assert!(other.digest() == end.digest(), "in steps of {step} the homes differ");
        assert!(other.save().unwrap() == end.save().unwrap(), "in steps of {step} the bodies differ");
    }
    (end, endings)
}

fn now(agent: NodeId, action: Action) -> (Span, NodeId, Action) {
    (Span(0), agent, action)
}

fn interruption(ending: &Ending) -> Option<&Interruption> {
    match &ending.outcome {
        Err(ActionError::Interrupted { why, .. }) => Some(why),
        _ => None,
    }
}

/// The changes of actions lead from one scene to the next, with all that goes on meanwhile.
#[test]
fn changes_lead_from_scene_to_scene() {
    let mut home = Environment::make("apartment/8", 2).unwrap();
    let (mut last, mut stream, mut done) = (home.graph().clone(), Seed(5).stream(), 0);
    for _ in 0..vc_testkit::amount(30, 300) {
        let agent = *stream.pick(home.agents()).unwrap();
        let action = legal_action(home.graph(), agent, &mut stream);
        if let Ok(changes) = home.set_action(agent, action) {
            changes.apply(&mut last).unwrap();
            assert!(last == *home.graph(), "after {}", action.describe(home.graph()));
            done += 1;
        }
    }
    assert!(done > 20, "{done} were done");
}

/// Whoever walks to a walker goes after them, or hears that they walk away.
#[test]
fn walkers_are_followed() {
    let home = home(42, 2);
    let (a, b) = (home.agents()[0], home.agents()[1]);
    for (index, &room) in home.graph().rooms().iter().enumerate() {
        let orders = [now(a, Action::walk(b)), (Span(30 * index as u64), b, Action::walk(room))];
        let (end, endings) = run(&home, &orders, LONG);
        for ending in &endings {
            let left = matches!(interruption(ending), Some(Interruption::WalksAway(_)));
            assert!(ending.outcome.is_ok() || left, "{ending:?}");
        }
        let there = endings.iter().any(|ending| ending.agent == a && ending.outcome.is_ok());
        let together = end.graph().near(a, b) && end.graph().room_of(a) == end.graph().room_of(b);
        assert!(!there || endings[0].agent == a || together, "{endings:?}");
    }
}

/// Whoever is fled from goes after them a few times, and then gives up, and is told so.
#[test]
fn whoever_is_fled_from_gives_up() {
    let gave_up = (40..60).any(|seed| {
        let mut home = home(seed, 2);
        let (a, b) = (home.agents()[0], home.agents()[1]);
        let rooms = home.graph().rooms().to_vec();
        let feet = |home: &Environment, agent| home.world().pose(agent).unwrap().translation.vector;
        home.give(a, Action::walk(b));
        while home.tick() < Tick(0) + Span(2 * LONG.0) {
            if home.current_action(b).is_none() {
                let (from, middle) = (feet(&home, a), |room| home.graph().node(room).and_then(|n| n.position()));
                let far = |room: &&NodeId| middle(**room).map_or(0.0, |at| (at.coords - from).norm());
                let away = *rooms.iter().max_by(|x, y| far(x).total_cmp(&far(y))).unwrap();
                home.give(b, Action::one(Verb::Run, away));
            }
            if let Some(ending) = home.step(Span(5)).into_iter().find(|ending| ending.agent == a) {
                let gone =
                    interruption(&ending).is_some_and(|why| matches!(why, Interruption::WalksAway(who) if who.id == b));
                assert!(gone || ending.outcome.is_ok(), "{ending:?}");
                return gone;
            }
        }
        false
    });
    assert!(gave_up);
}

/// A thing in a pot stays in it while somebody carries the pot, whatever others do meanwhile.
#[test]
fn what_is_carried_stays_where_it_is() {
    let mut home = home(42, 2);
    let (a, b) = (home.agents()[0], home.agents()[1]);
    let at = home.graph().of_class("kitchen_cabinet")[0];
    let place = Place { relation: Relation::On, at };
    let (pot, potato) = (home.spawn("pot", place).unwrap(), home.spawn("potato", place).unwrap());
    for action in [
        Action::walk(pot),
        Action::open(pot),
        Action::grab(potato),
        Action::put_in(potato, pot),
        Action::close(pot),
        Action::grab(pot),
    ] {
        home.set_action(a, action).unwrap();
    }
    home.give(a, Action::walk(home.graph().of_class("dining_table")[0]));
    while home.current_action(a).is_some() {
        home.give(b, Action::zero(Verb::Wave));
        for ending in home.step(Span(97)) {
            assert!(ending.outcome.is_ok(), "{ending:?}");
        }
        for home in [&home, &home.moment()] {
            assert!(home.graph().rests_at(potato, pot) && home.graph().rests_at(potato, a));
        }
    }
}

/// Nothing is lost when one puts a thing onto a table while the other takes one from it, whenever that is.
#[test]
fn two_use_one_table() {
    let mut home = home(42, 2);
    let (a, b) = (home.agents()[0], home.agents()[1]);
    let table = home.graph().of_class("coffee_table")[0];
    let place = Place { relation: Relation::On, at: table };
    let (mug, apple) = (home.spawn("mug", place).unwrap(), home.spawn("apple", place).unwrap());
    act(&mut home, a, Verb::Walk, &[mug]);
    act(&mut home, a, Verb::Grab, &[mug]);
    act(&mut home, b, Verb::Walk, &[apple]);
    for delay in (0..66).step_by(vc_testkit::amount(11, 1)) {
        let orders = [now(a, Action::place(mug, table)), (Span(delay), b, Action::grab(apple))];
        let (mut end, endings) = run(&home, &orders, LONG);
        assert!(end.world().aabb(mug).unwrap().min.z > 0.0, "after {delay} ticks: {endings:?}");
        for agent in [a, b] {
            assert_eq!(end.set_action(agent, Action::zero(Verb::Wave)).map(drop), Ok(()), "after {delay} ticks");
        }
    }
}

/// Random legal actions of two agents at once.
#[test]
fn how_time_is_divided_changes_nothing() {
    let (mut done, mut all) = (0, 0);
    for seed in [8, 42] {
        let (mut home, mut stream) = (home(seed, 2), Seed(seed).stream());
        for _ in 0..12 {
            let agents = home.agents().to_vec();
            let orders: Vec<_> =
                agents.iter().map(|agent| now(*agent, legal_action(home.graph(), *agent, &mut stream))).collect();
            let (end, endings) = outcome(&home, &orders);
            assert_eq!(endings.len(), 2, "{endings:?}");
            done += endings.iter().filter(|e| e.outcome.is_ok()).count();
            all += endings.len();
            home = end;
        }
    }
    assert!(done * 10 >= all * 9, "{done} of {all} were done");
}

/// A thing in a home that both agents are near, after they have walked there.
fn both_near(home: &mut Environment, admits: impl Fn(&Environment, NodeId) -> bool) -> Option<NodeId> {
    let agents = home.agents().to_vec();
    let all: Vec<NodeId> = home.graph().nodes().map(|n| n.id()).collect();
    for id in all.into_iter().filter(|id| admits(home, *id)) {
        let mut tried = home.clone();
        let there = agents.iter().all(|agent| tried.set_action(*agent, Action::one(Verb::Walk, id)).is_ok());
        if there && agents.iter().all(|agent| tried.graph().near(*agent, id)) {
            *home = tried;
            return Some(id);
        }
    }
    None
}

fn on_furniture(home: &Environment, id: NodeId) -> bool {
    let graph = home.graph();
    let node = graph.node(id).unwrap();
    node.affords(Property::Graspable)
        && graph.related(id, Relation::On).any(|at| graph.node(at).unwrap().affords(Property::Surface))
        && graph.resting_at(id).next().is_none()
}

/// One of two has the thing, the other learns by whom it was taken, in the same tick.
#[test]
fn one_of_two_gets_a_thing() {
    let mut home = home(42, 2);
    let (a, b) = (home.agents()[0], home.agents()[1]);
    let thing = both_near(&mut home, on_furniture).unwrap();
    let grab = Action::one(Verb::Grab, thing);
    let (end, endings) = outcome(&home, &[now(a, grab), now(b, grab)]);
    let holder = end.graph().holder(thing).unwrap().at;
    let lost = endings.iter().find(|e| e.agent != holder).unwrap();
    let Some(Interruption::Taken { thing: taken, by }) = interruption(lost) else { panic!("{lost:?}") };
    assert_eq!((taken.id, by.id), (thing, holder));
    assert!(endings.iter().any(|e| e.agent == holder && e.outcome.is_ok()));
    // Half a second later it is no longer allowed from the beginning.
    let (_, endings) = outcome(&home, &[now(a, grab), (Span(120), b, grab)]);
    assert!(endings.iter().any(|e| e.agent == b && matches!(e.outcome, Err(ActionError::Refused(_)))), "{endings:?}");
}

/// Two press one switch; who comes second finds it pressed.
#[test]
fn a_switch_is_pressed_once() {
    let mut home = home(42, 2);
    let (a, b) = (home.agents()[0], home.agents()[1]);
    let off = |home: &Environment, id: NodeId| home.graph().node(id).unwrap().is(State::Off);
    let lamp = both_near(&mut home, |home, id| off(home, id) && home.world().aabb(id).is_some()).unwrap();
    let on = Action::one(Verb::SwitchOn, lamp);
    let (end, endings) = outcome(&home, &[now(a, on), now(b, on)]);
    assert!(end.graph().node(lamp).unwrap().is(State::On));
    assert_eq!(endings.iter().filter(|e| e.outcome.is_ok()).count(), 1, "{endings:?}");
}

/// An action ends when its agent is given something else, or is interrupted; the agent is then on its way.
#[test]
fn actions_are_replaced_and_interrupted() {
    let mut home = home(42, 1);
    let me = home.agents()[0];
    let here = home.graph().room_of(me);
    let far = home.graph().rooms().iter().copied().rfind(|room| Some(*room) != here).unwrap();
    let walk = Action::one(Verb::Walk, far);
    let from = home.world().pose(me).unwrap();
    let (end, endings) = outcome(&home, &[now(me, walk), (Span(45), me, Action::zero(Verb::Wave))]);
    assert!(matches!(interruption(&endings[0]), Some(Interruption::Replaced(_))), "{endings:?}");
    assert!(endings[1].outcome.is_ok() && endings[0].tick < endings[1].tick);
    let walked = (end.world().pose(me).unwrap().translation.vector - from.translation.vector).norm();
    assert!(walked > 0.3 && walked < 1.5, "{walked}");
    home.give(me, walk);
    home.step(Span(30));
    assert_eq!(home.current_action(me), Some(&walk));
    // Nothing else can be done to the walker meanwhile.
    assert!(matches!(home.steer(me, &Steering::default()), Err(ActionError::Busy(_))));
    assert!(matches!(home.teleport(me, Spot::Room(far)), Err(AlterError::Busy(_))));
    home.interrupt(me);
    let endings = home.step(Span(1));
    assert_eq!(interruption(&endings[0]), Some(&Interruption::Cancelled));
    assert!(home.current_action(me).is_none() && home.set_action(me, Action::zero(Verb::Wave)).is_ok());
    // The second of two actions that are given in one tick counts, and one that is taken back does not.
    home.give(me, walk);
    home.give(me, Action::zero(Verb::Wave));
    home.interrupt(me);
    let endings = home.step(Span(600));
    assert!(matches!(interruption(&endings[0]), Some(Interruption::Replaced(_))), "{endings:?}");
    assert!(interruption(&endings[1]) == Some(&Interruption::Cancelled) && endings.len() == 2);
}

/// The graph has an agent where its body is, whenever its walk is cut.
#[test]
fn a_cut_walk_is_read() {
    let home = home(42, 2);
    let (a, b) = (home.agents()[0], home.agents()[1]);
    let kitchen = home.graph().of_class("kitchen")[0];
    let fridge = home.graph().of_class("fridge")[0];
    for ticks in (20..400).step_by(if vc_testkit::amount(0, 1) == 1 { 20 } else { 95 }) {
        for end_by in [None, Some(Action::zero(Verb::Wave))] {
            let mut home = home.clone();
            home.give(a, Action::walk(kitchen));
            home.give(b, Action::open(fridge));
            home.step(Span(ticks));
            match end_by {
                Some(action) => home.give(a, action),
                None => home.interrupt(a),
            }
            home.step(Span(2));
            let feet = home.world().pose(a).unwrap();
            let seen = home.graph().node(a).unwrap().pose().unwrap();
            assert!((seen.translation.vector - feet.translation.vector).norm() < 0.01, "after {ticks} ticks");
            let room = home.room_at(feet.translation.vector.xy().into());
            assert_eq!(home.graph().room_of(a), room, "after {ticks} ticks");
            home.step_until_idle(LONG);
            for agent in [a, b] {
                assert_eq!(home.set_action(agent, Action::zero(Verb::Wave)).map(drop), Ok(()), "after {ticks} ticks");
            }
        }
    }
}

/// A door that is half open when the hand lets go of it is so in the graph too.
#[test]
fn a_cut_door_is_read() {
    let mut home = home(42, 1);
    let (me, fridge) = (home.agents()[0], home.graph().of_class("fridge")[0]);
    act(&mut home, me, Verb::Walk, &[fridge]);
    for ticks in [55, 80, 105, 130] {
        let mut home = home.clone();
        home.give(me, Action::open(fridge));
        home.step(Span(ticks));
        home.interrupt(me);
        home.step(Span(1));
        let state = home.world().parts(fridge).state().unwrap();
        assert!(
            home.graph().node(fridge).unwrap().is(state),
            "after {ticks} ticks: {:?}",
            home.world().parts(fridge).openness()
        );
        assert_eq!(home.set_action(me, Action::zero(Verb::Wave)).map(drop), Ok(()), "after {ticks} ticks");
    }
}

/// A home that is saved in the middle of actions goes on as if it had not been.
#[test]
fn overlapping_actions_are_saved() {
    let mut home = Environment::make("apartment/42", 2).unwrap();
    let (a, b) = (home.agents()[0], home.agents()[1]);
    let fridge = home.graph().of_class("fridge")[0];
    act(&mut home, a, Verb::Walk, &[fridge]);
    act(&mut home, a, Verb::Open, &[fridge]);
    let inside = home.graph().relating(Relation::Inside, fridge).find(|id| home.graph().near(a, *id)).unwrap();
    let table = home.graph().of_class("sofa")[0];
    home.give(a, Action::grab(inside));
    home.give(b, Action::walk(table));
    for _ in 0..vc_testkit::amount(12, 60) {
        home.step(Span(11));
        let mut again = home.restore(&home.save().unwrap()).unwrap();
        assert_eq!(again.digest(), home.digest(), "at {}", home.tick());
        let mut on = home.clone();
        let goes_on = |home: &mut Environment| {
            let mut endings = home.step_until_idle(LONG);
            home.give(a, Action::close(fridge));
            endings.extend(home.step_until_idle(LONG));
            endings
        };
        assert_eq!(goes_on(&mut again), goes_on(&mut on), "at {}", home.tick());
        assert_eq!(again.digest(), on.digest(), "at {}", home.tick());
        assert!(again.save().unwrap() == on.save().unwrap());
    }
}

/// Both walk to one thing at once, and stand apart.
#[test]
fn walkers_keep_apart() {
    let home = home(42, 2);
    let (a, b) = (home.agents()[0], home.agents()[1]);
    let fridge = home.graph().of_class("fridge")[0];
    let walk = Action::one(Verb::Walk, fridge);
    let (end, endings) = outcome(&home, &[now(a, walk), now(b, walk)]);
    assert!(endings.iter().all(|e| e.outcome.is_ok()), "{endings:?}");
    let feet = |agent| end.world().pose(agent).unwrap().translation.vector.xy();
    assert!((feet(a) - feet(b)).norm() > 0.5);
    assert!(endings.iter().all(|e| e.tick > Tick(60)));
}

/// One of two sits when both sit down on one chair.
#[test]
fn a_seat_is_taken_once() {
    let mut home = home(42, 2);
    let (a, b) = (home.agents()[0], home.agents()[1]);
    let chair = both_near(&mut home, |home, id| {
        home.graph().node(id).unwrap().affords(Property::Sittable) && home.world().body(id).unwrap().seats().len() == 1
    })
    .unwrap();
    let sit = Action::one(Verb::Sit, chair);
    let (end, endings) = outcome(&home, &[now(a, sit), now(b, sit)]);
    assert_eq!(endings.iter().filter(|e| e.outcome.is_ok()).count(), 1, "{endings:?}");
    assert_eq!(end.graph().relating(Relation::SittingOn, chair).count(), 1);
}

/// One shuts the fridge while the other is about to take something out of it.
#[test]
fn a_door_shuts_before_a_hand() {
    let mut home = home(42, 2);
    let (a, b) = (home.agents()[0], home.agents()[1]);
    let fridge = home.graph().of_class("fridge")[0];
    act(&mut home, a, Verb::Walk, &[fridge]);
    act(&mut home, a, Verb::Open, &[fridge]);
    act(&mut home, b, Verb::Walk, &[fridge]);
    let inside = home.graph().relating(Relation::Inside, fridge).find(|id| home.graph().near(b, *id)).unwrap();
    let orders = [now(a, Action::one(Verb::Close, fridge)), (Span(20), b, Action::one(Verb::Grab, inside))];
    let (end, endings) = outcome(&home, &orders);
    assert_eq!(endings.len(), 2, "{endings:?}");
    // It was in time, and then nothing was in the way of the door; or the door was.
    let held = end.graph().holder(inside).is_some_and(|place| place.at == b);
    let taken = endings.iter().find(|e| e.agent == b).unwrap();
    assert_eq!(taken.outcome.is_ok(), held, "{endings:?}");
}

/// Machines and matter go on while time passes, however it is divided; actions take their time.
#[test]
fn processes_go_on() {
    let mut home = Environment::make("apartment/42", 1).unwrap();
    let me = home.agents()[0];
    let tables: Vec<NodeId> = home.graph().nodes().filter(|n| n.class().ends_with("table")).map(|n| n.id()).collect();
    let mut stand = |at: NodeId| home.spawn("coffee_maker", Place { relation: Relation::On, at }).ok();
    let machine = tables.into_iter().find_map(&mut stand).unwrap();
    act(&mut home, me, Verb::Walk, &[machine]);
    let hour = home.day_time().hour();
    home.give(me, Action::one(Verb::SwitchOn, machine));
    let begin = home.tick();
    let endings = home.step(LONG);
    // The switch takes a second, besides what the body needs.
    assert!(endings[0].outcome.is_ok() && endings[0].tick - begin >= Span(60), "{endings:?}");
    assert!(home.processes().any(|p| p.node == machine && &*p.process == "brewing"));
    let is = |home: &Environment, state| home.graph().node(machine).unwrap().is(state);
    assert!(is(&home, State::On) && !is(&home, State::Hot));
    let mut slow = home.clone();
    home.step(Span::from_seconds(360.0));
    assert!(is(&home, State::Off) && is(&home, State::Hot));
    for part in 0..3600 {
        slow.step(Span(6));
        if part % 1000 == 0 {
            // Processes that go on are saved too.
            slow = slow.restore(&slow.save().unwrap()).unwrap();
        }
    }
    assert!(slow.digest() == home.digest() && slow.save().unwrap() == home.save().unwrap());
    home.step(Span::from_seconds(3600.0));
    assert!(!is(&home, State::Hot) && home.processes().all(|p| p.node != machine));
    assert!((home.day_time().hour() - hour - 1.12).abs() < 0.02, "{}", home.day_time().hour() - hour);
}

/// With processes at once what begins in a tick has ended with the next step, however time is divided.
#[test]
fn processes_end_at_once() {
    let mut home = Environment::builder("apartment/42").processes_at_once().make().unwrap();
    let me = home.agents()[0];
    let tables: Vec<NodeId> = home.graph().nodes().filter(|n| n.class().ends_with("table")).map(|n| n.id()).collect();
    let mut stand = |at: NodeId| home.spawn("coffee_maker", Place { relation: Relation::On, at }).ok();
    let machine = tables.into_iter().find_map(&mut stand).unwrap();
    act(&mut home, me, Verb::Walk, &[machine]);
    let is = |home: &Environment, state| home.graph().node(machine).unwrap().is(state);
    assert!(is(&home, State::Off) && !is(&home, State::Hot));
    let mut slow = home.clone();
    for home in [&mut home, &mut slow] {
        home.give(me, Action::one(Verb::SwitchOn, machine));
    }
    let (mut on, mut hot) = (0, 0);
    for _ in 0..LONG.0 {
        slow.step(Span(1));
        on += u32::from(is(&slow, State::On));
        hot += u32::from(is(&slow, State::Hot));
    }
    let endings = home.step(LONG);
    assert!(on == 1 && hot > 0 && endings.iter().all(|ending| ending.outcome.is_ok()), "{on} {hot} {endings:?}");
    assert!(is(&home, State::Off) && home.processes().all(|process| process.node != machine));
    assert!(slow.digest() == home.digest() && slow.save().unwrap() == home.save().unwrap());
}

/// Prints how many random actions of two agents at once are done, why others are not, and their cost against the same
/// actions one after the other; `HOMES`, `ROUNDS` and `FROM` set the range.
#[test]
#[ignore = "takes minutes: proofs/clock"]
#[allow(clippy::print_stdout, reason = "it is a report")]
fn random_actions_at_once() {
    let number =
        |name: &str, otherwise: u64| std::env::var(name).ok().and_then(|s| s.parse().ok()).unwrap_or(otherwise);
    for seed in number("FROM", 40)..number("FROM", 40) + number("HOMES", 1) {
        let (mut done, mut all, mut costs) = (0, 0, Vec::new());
        let (mut home, mut stream) = (Environment::make(&format!("apartment/{seed}"), 2).unwrap(), Seed(seed).stream());
        for _ in 0..number("ROUNDS", 20) {
            let agents = home.agents().to_vec();
            let orders: Vec<_> =
                agents.iter().map(|agent| (*agent, legal_action(home.graph(), *agent, &mut stream))).collect();
            let (mut in_turn, start) = (home.clone(), cpu_time::ThreadTime::now());
            let told: Vec<_> = orders.iter().map(|(agent, action)| in_turn.set_action(*agent, *action)).collect();
            let (turns, start) = (start.elapsed(), cpu_time::ThreadTime::now());
            orders.iter().for_each(|(agent, action)| home.give(*agent, *action));
            let endings = home.step_until_idle(Span(LONG.0 * 60 * 24));
            let clock = start.elapsed();
            let failed: Vec<&Ending> = endings.iter().filter(|e| e.outcome.is_err()).collect();
            (all, done) = (all + endings.len(), done + endings.len() - failed.len());
            if failed.is_empty() && told.iter().all(Result::is_ok) {
                costs.push(clock.as_secs_f64() / turns.as_secs_f64());
            }
            for ending in failed {
                let alone = orders.iter().position(|o| o.0 == ending.agent).map(|i| told[i].is_ok());
                let alone = if alone == Some(true) { "done in turn" } else { "not done in turn either" };
                println!("home {seed}: {}; {alone}", ending.outcome.as_ref().unwrap_err());
            }
        }
        costs.sort_by(f64::total_cmp);
        let median = costs.get(costs.len() / 2).copied().unwrap_or_default();
        println!("home {seed}, {done} of {all} were done, median cost against the same in turn {median:.2}");
    }
}
