//! Things that are pushed while somebody acts: no action answers for them, so none puts them back.

use nalgebra::{Point3, Vector3};
use virtualcity::Environment;
use virtualcity::graph::clock::Span;
use virtualcity::graph::{Action, NodeId, Property, Verb};
use virtualcity::physics::BodyRole;

use super::home;

/// Things as near as that to the agent or to what it acts on are left alone, metres.
const CLEAR: f32 = 1.2;
/// The speed of what is pushed, up and aside, metres a second: it flies for half a second or more.
const SPEED: [f32; 3] = [0.5, 0.0, 2.5];
/// The share of an action after which something is pushed: before its effects hold, and after.
const SHARES: [f32; 4] = [0.1, 0.4, 0.7, 0.95];

fn middle(home: &Environment, id: NodeId) -> Point3<f32> {
    home.world().body(id).unwrap().centre_of_mass()
}

/// Ticks until nobody acts.
fn ticks(mut home: Environment) -> u64 {
    let begin = home.tick();
    while home.is_busy() {
        home.step(Span(1));
    }
    (home.tick() - begin).0
}

/// Whatever flies while an action ends, or begins and ends, comes down where it would without the action.
#[test]
fn what_flies_while_somebody_acts_is_not_put_back() {
    let mut pushed = 0;
    for seed in 0..vc_testkit::amount(4, 60) as u64 {
        let mut home = home(seed, 1);
        let me = home.agents()[0];
        let fridge = home.graph().of_class("fridge")[0];
        home.set_action(me, Action::one(Verb::Walk, fridge)).unwrap();
        let at = |id: NodeId| home.world().pose(id).unwrap().translation.vector;
        let is_far = |id: &NodeId| [me, fridge].iter().all(|other| (at(*id) - at(*other)).norm() > CLEAR);
        let graspable = home.graph().nodes().filter(|node| node.affords(Property::Graspable)).map(|node| node.id());
        let loose = graspable.filter(|id| home.world().role(*id) == Some(BodyRole::Loose));
        let things: Vec<NodeId> = loose.filter(is_far).collect();
        let mut acting = home.clone();
        acting.give(me, Action::one(Verb::Open, fridge));
        acting.step(Span(1));
        let last = ticks(acting.clone());
        for (thing, share) in things.into_iter().step_by(9).zip(SHARES.into_iter().cycle()).take(8) {
            let [mut still, mut acts] = [&home, &acting].map(Environment::clone);
            still.step(Span(1));
            let mut endings = Vec::new();
            for home in [&mut still, &mut acts] {
                endings.extend(home.step(Span((last as f32 * share) as u64)));
                let body = home.world().body(thing).unwrap();
                home.push(thing, Vector3::from(SPEED) * body.mass(), body.centre_of_mass()).unwrap();
            }
            let mut saved = acting.restore(&acts.save().unwrap()).unwrap();
            let mut twin = acts.clone();
            for _ in 0..900 {
                endings.extend(twin.step(Span(1)));
            }
            for home in [&mut still, &mut acts, &mut saved] {
                home.step(Span(900));
            }
            let name = home.graph().label(thing);
            assert!(endings.iter().all(|ending| ending.outcome.is_ok()) && endings.len() == 1, "{name}: {endings:?}");
            assert!(acts.digest() == twin.digest() && acts.digest() == saved.digest(), "{seed}: {name}");
            let apart = (middle(&still, thing) - middle(&acts, thing)).norm();
            assert!(apart < 0.05, "{seed}: {name} came down {apart} m away, pushed after {share}");
            let read = acts.graph().node(thing).unwrap().pose().unwrap().translation.vector;
            let is = acts.world().pose(thing).unwrap().translation.vector;
            assert!((read - is).norm() < 1e-4, "{seed}: {name} is at {is:?}, and read at {read:?}");
            pushed += usize::from((middle(&home, thing) - middle(&acts, thing)).norm() > 0.05);
        }
    }
    assert!(pushed >= 10, "{pushed}");
}

/// So does what is hit by that, or loses its support: it is not put back, nor held in the air.
#[test]
fn what_is_hit_while_somebody_acts_is_not_put_back() {
    let mut hit = 0;
    for seed in 0..vc_testkit::amount(3, 40) as u64 {
        let home = home(40 + seed, 1);
        let me = home.agents()[0];
        let graspable = home.graph().nodes().filter(|node| node.affords(Property::Graspable)).map(|node| node.id());
        let loose: Vec<NodeId> = graspable.filter(|id| home.world().role(*id) == Some(BodyRole::Loose)).collect();
        let beside = |one: NodeId| {
            let near = |other: &NodeId| *other != one && (middle(&home, one) - middle(&home, *other)).norm() < 0.15;
            loose.iter().copied().filter(|_| middle(&home, one).z > 0.6).find(near)
        };
        let pairs = loose.iter().filter_map(|one| Some((*one, beside(*one)?))).step_by(4).take(16);
        for (one, other) in pairs.collect::<Vec<_>>() {
            let aim = 3.0 * (middle(&home, other) - middle(&home, one)).normalize() + Vector3::new(0.0, 0.0, 0.4);
            let thrown = |acts: bool, wait: u64| {
                let mut home = home.clone();
                if acts {
                    home.give(me, Action::zero(Verb::Wave));
                }
                home.step(Span(wait));
                let body = home.world().body(one).unwrap();
                home.push(one, aim * body.mass(), body.centre_of_mass()).unwrap();
                let endings = home.step(Span(900));
                assert!(endings.iter().all(|ending| ending.outcome.is_ok()), "{endings:?}");
                home
            };
            for wait in [60, 95] {
                let [still, acts] = [false, true].map(|acts| thrown(acts, wait));
                let label = home.graph().label(other);
                let apart = (middle(&still, other) - middle(&acts, other)).norm();
                assert!(apart < 0.05, "{seed}: {label} is {apart} m from where it comes down while nobody acts");
                assert_eq!(acts.world().role(other), Some(BodyRole::Loose), "{seed}: {label}");
                hit += usize::from((middle(&home, other) - middle(&acts, other)).norm() > 0.3);
            }
        }
    }
    assert!(hit >= 4, "{hit}");
}
