//! Saved states of a search: an environment and all that are restored from its state evolve alike.

use std::collections::{HashSet, VecDeque};

use vc_testkit::amount;
use virtualcity::graph::clock::Span;
use virtualcity::graph::{Action, NodeId, Place, Pose, Relation, Seed, State, Stream, Verb};
use virtualcity::nalgebra::Point2;
use virtualcity::physics::RestError;
use virtualcity::{Control, Environment, EnvironmentState, StateError, legal_action};

use super::{act, fresh, home};

/// The most bytes of a state.
const LIGHT: usize = 20_000;

/// Something that agents do, or that is done to the home; then all comes to rest, as far as it does within a minute.
fn stir(home: &mut Environment, rng: &mut Stream) {
    let agents = home.agents().to_vec();
    let agent = *rng.pick(&agents).unwrap();
    let things: Vec<NodeId> = home.graph().nodes().map(|n| n.id()).collect();
    match rng.below(12) {
        0 => {
            for agent in agents {
                home.give(agent, legal_action(home.graph(), agent, rng));
            }
            home.step_until_idle(Span::from_seconds(600.0));
        }
        1 => {
            home.give(agent, legal_action(home.graph(), agent, rng));
            drop(home.step(Span(rng.below(200) as u64)));
            home.interrupt(agent);
        }
        2 => drop(home.put(*rng.pick(&things).unwrap(), place(rng, &things))),
        3 => drop(home.spawn(["cup", "apple", "book"][rng.below(3)], place(rng, &things))),
        4 => drop(home.teleport(agent, Point2::new(rng.between(-8.0, 8.0), rng.between(-8.0, 8.0)))),
        5 => drop(home.step(Span(rng.below(5000) as u64))),
        _ => drop(home.set_action(agent, legal_action(home.graph(), agent, rng))),
    }
    home.agents().to_vec().into_iter().for_each(|agent| home.interrupt(agent));
    for _ in 0..60 {
        drop(home.step(Span(1)));
        if home.world().awake() == 0 {
            break;
        }
        drop(home.step(Span(60)));
    }
}

fn place(rng: &mut Stream, things: &[NodeId]) -> Place {
    let relation = if rng.below(2) == 0 { Relation::On } else { Relation::Inside };
    Place { relation, at: *rng.pick(things).unwrap() }
}

/// All that can be read of two homes is the same.
fn assert_same(one: &Environment, other: &Environment) {
    assert_eq!(one.graph(), other.graph());
    assert_eq!(one.graph().next_number(), other.graph().next_number());
    assert_eq!(one.history(), other.history());
    assert_eq!((one.tick(), one.day_time()), (other.tick(), other.day_time()));
    assert!(one.processes().eq(other.processes()));
    assert_eq!(one.digest(), other.digest());
    assert_eq!((one.world().poses(), one.world().digest()), (other.world().poses(), other.world().digest()));
    assert_eq!(one.relations().edges(), other.relations().edges());
    assert_eq!(one.relations().evidence(), other.relations().evidence());
    assert_eq!(one.floor().occupancy(), other.floor().occupancy());
    assert_eq!(one.changes(), other.changes());
    for &agent in one.agents() {
        let seen = |home: &Environment| format!("{:?}", home.observation(agent, 3.0));
        assert_eq!(seen(one), seen(other));
        assert_eq!(one.legal_actions(agent), other.legal_actions(agent));
    }
}

/// Saves a state; `None` where something moves for ever or the bodies do not bear to be built anew, which is said.
fn saved(home: &mut Environment) -> Option<EnvironmentState> {
    match home.save_state() {
        Ok(state) => Some(state),
        Err(StateError::Bodies(RestError::Moves(_) | RestError::Restless(_) | RestError::Stopped(_))) => None,
        Err(other) => panic!("{other}"),
    }
}

/// Whatever has happened, a home that was saved and all that are restored from the state are the same and stay so, also
/// where they are saved again at other times.
#[test]
fn saved_and_restored_homes_evolve_alike() {
    let mut states = 0;
    for seed in 0..amount(6, 100) {
        let (mut home, mut rng) =
            ([home(7, 1), home(42, 1), home(42, 2)][seed as usize % 3].clone(), Seed(seed).stream());
        let origin = home.clone();
        (0..rng.below(8)).for_each(|_| stir(&mut home, &mut rng));
        let Some(state) = saved(&mut home) else { continue };
        states += 1;
        assert!(state.bytes() < LIGHT, "{state:?}");
        let mut restored = [origin.restore_state(&state).unwrap(), home.restore_state(&state).unwrap()];
        for action in 0..20 {
            restored.iter().for_each(|other| assert_same(&home, other));
            let futures = [rng.clone(), rng.clone()];
            stir(&mut home, &mut rng);
            restored.iter_mut().zip(futures).for_each(|(other, mut rng)| stir(other, &mut rng));
            if action % 7 == 6 && saved(&mut home).is_some() {
                let own = saved(&mut restored[0]).unwrap();
                saved(&mut restored[1]).unwrap();
                restored[1] = restored[1].restore_state(&own).unwrap();
            }
        }
        restored.iter().for_each(|other| assert_same(&home, other));
    }
    assert!(states > 3, "{states}");
}

/// In which order states are saved, restored and gone on from does not matter, nor in which thread.
#[test]
fn the_order_of_restoring_does_not_matter() {
    let (mut home, mut rng) = (home(42, 2), Seed(5).stream());
    let mut states = Vec::new();
    while states.len() < 4 {
        stir(&mut home, &mut rng);
        states.extend(saved(&mut home));
    }
    let future = |at: usize| {
        let mut restored = home.restore_state(&states[at]).unwrap();
        let mut rng = Seed(at as u64).stream();
        (0..4).for_each(|_| stir(&mut restored, &mut rng));
        (restored.digest(), saved(&mut restored).map(|state| state.bytes()))
    };
    let forth: Vec<_> = (0..4).map(future).collect();
    let back: Vec<_> = (0..4).rev().map(future).collect();
    let beside: Vec<_> = std::thread::scope(|scope| {
        let all: Vec<_> = (0..4).map(|at| scope.spawn(move || future(at))).collect();
        all.into_iter().map(|thread| thread.join().unwrap()).collect()
    });
    assert!(forth.iter().eq(back.iter().rev()) && forth == beside, "{forth:?} {back:?} {beside:?}");
}

/// To save and restore again and again changes nothing.
#[test]
fn a_hundred_states_of_one_moment_are_the_same() {
    let (mut home, mut rng) = (home(42, 1), Seed(8).stream());
    (0..4).for_each(|_| stir(&mut home, &mut rng));
    let first = home.save_state().unwrap();
    let (digest, bytes) = (home.digest(), first.bytes());
    let mut state = first;
    for turn in 0..100 {
        let mut next = home.restore_state(&state).unwrap();
        if turn % 3 == 0 {
            // It is woken, and a camera that comes and goes makes it another state.
            let camera = next.add_camera("eye", virtualcity::Mount::Fixed(Pose::identity()), Default::default());
            next.remove_camera(camera.unwrap()).unwrap();
        }
        state = next.save_state().unwrap();
        assert_eq!((next.digest(), state.bytes()), (digest, bytes));
    }
    assert_same(&home, &home.restore_state(&state).unwrap());
}

/// A state that nobody has stepped needs no bodies: what the rule says of it, it says at once.
#[test]
fn a_restored_home_is_observed_while_bodies_sleep() {
    let mut home = home(42, 1);
    let (me, fridge) = (home.agents()[0], home.graph().of_class("fridge")[0]);
    act(&mut home, me, Verb::Walk, &[fridge]);
    let state = home.save_state().unwrap();
    let mut restored = home.restore_state(&state).unwrap();
    assert_eq!(restored.observation(me, 2.0).len(), home.observation(me, 2.0).len());
    assert_eq!(restored.tick(), home.tick());
    assert!(restored.set_action(me, Action::one(Verb::Grab, fridge)).is_err());
    assert_eq!(restored.save_state().unwrap().bytes(), state.bytes());
    assert_same(&home, &restored);
}

#[test]
fn states_of_others_are_refused() {
    let state = home(42, 1).save_state().unwrap();
    for other in [home(7, 1), home(42, 2), fresh(42, 1)] {
        let refused = other.restore_state(&state).unwrap_err();
        assert!(matches!(refused, StateError::OtherStart), "{refused}");
        assert!(refused.to_string().contains("another environment"), "{refused}");
    }
}

/// An apple that is falling, agents that act, and endings that nobody has read: the refusal names them.
#[test]
fn what_is_in_motion_is_not_saved() {
    let mut home = home(42, 1);
    let (me, table) = (home.agents()[0], home.graph().of_class("coffee_table")[0]);
    let apple = home.spawn("apple", Place { relation: Relation::On, at: table }).unwrap();
    act(&mut home, me, Verb::Walk, &[apple]);
    act(&mut home, me, Verb::Grab, &[apple]);
    home.give(me, Action::one(Verb::Drop, apple));
    let labels = |ids: &[NodeId]| ids.iter().map(|id| home.graph().label(*id)).collect::<Vec<_>>();
    let (agent, thing) = (labels(&[me]), labels(&[apple]));
    assert_eq!(home.save_state().unwrap_err(), StateError::Busy(agent));
    while home.world().awake() == 0 {
        assert!(home.step(Span(1)).is_empty());
    }
    home.interrupt(me);
    assert_eq!(home.save_state().unwrap_err(), StateError::Unread(1));
    assert_eq!(home.step(Span(0)).len(), 1);
    let before = home.digest();
    let moving = home.save_state().unwrap_err();
    assert_eq!(moving, StateError::Bodies(RestError::Moves(thing)));
    assert!(moving.to_string().starts_with(&format!("apple.{} moves still", apple.0)), "{moving}");
    assert_eq!(home.digest(), before);
    drop(home.step(Span::from_seconds(20.0)));
    assert!(home.save_state().is_ok());
}

/// Each state of a breadth-first search is light, and most are much lighter.
#[test]
fn states_of_a_search_are_light() {
    let most = amount(200, 1_000);
    let mut home = home(42, 1);
    let me = home.agents()[0];
    let first = home.save_state().unwrap();
    let (mut seen, mut open, mut bytes) = (HashSet::from([home.graph().digest()]), VecDeque::from([first]), Vec::new());
    while let Some(state) = open.pop_front().filter(|_| bytes.len() < most) {
        bytes.push(state.bytes());
        let parent = home.restore_state(&state).unwrap();
        for action in parent.legal_actions(me).into_iter().step_by(5) {
            if bytes.len() + open.len() > most {
                break;
            }
            let mut child = parent.clone();
            if child.set_action(me, action).is_ok() && seen.insert(child.graph().digest()) {
                open.extend(saved(&mut child));
            }
        }
    }
    assert_eq!(bytes.len(), most);
    assert!(bytes.iter().all(|bytes| *bytes <= LIGHT), "{:?}", bytes.iter().max());
    assert!(bytes.iter().sum::<usize>() < most * LIGHT / 2);
}

/// Whatever is done to an environment that was just restored is in its next state.
#[test]
fn a_restored_environment_that_changes_has_another_state() {
    let mut first = home(42, 1);
    let me = first.agents()[0];
    first.set_action(me, Action::zero(Verb::Dance)).unwrap();
    let state = first.save_state().unwrap();
    let same = |mut home: Environment| {
        let again = home.save_state().unwrap();
        assert_eq!(home.restore_state(&again).unwrap().digest(), home.digest());
        again
    };
    let mut lit = first.restore_state(&state).unwrap();
    let lamps = lit.switch_lamps(true).unwrap();
    let is_on = |home: &Environment| lamps.iter().all(|lamp| home.graph().node(*lamp).unwrap().is(State::On));
    assert!(is_on(&first.restore_state(&same(lit)).unwrap()));
    let mut anew = first.restore_state(&state).unwrap();
    anew.reset(&anew.graph().clone()).unwrap();
    assert!(first.restore_state(&same(anew)).unwrap().history().events().is_empty());
    let mut held = first.restore_state(&state).unwrap();
    held.control(me, &Control::default()).unwrap();
    held.interrupt(me);
    held.step(Span(60));
    same(held);
}
