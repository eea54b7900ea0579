//! Random walks of two and three who are stopped and sent elsewhere in any tick: the distances that they keep.

use nalgebra::Point2;
use virtualcity::graph::clock::Span;
use virtualcity::graph::{Action, Node, NodeId, NodeKind, Seed, State, Verb};
use virtualcity::{ActionError, Ending, Environment, Interruption};

use super::{home, interruption};

/// The nearest that two ever come, with shoulders turned, and the distance of two bodies as they are drawn, metres.
const LEAST: f32 = 0.29;
const BODIES: f32 = 0.55;
/// Ticks between two looks, and after which a run ends.
const EVERY: u64 = 3;
const LAST: u64 = 1500;

/// Orders after so many ticks: an action, or an interruption.
type Orders = Vec<(u64, NodeId, Option<Action>)>;

/// Orders for all agents between a few places, so that they meet; without interruptions each goes on when it has
/// arrived.
fn orders(home: &Environment, seed: Seed, interrupted: bool) -> Orders {
    let mut stream = seed.stream();
    let graph = home.graph();
    let doors = graph.nodes().filter(|n| n.is(State::Open) || n.is(State::Closed)).map(|n| n.id());
    let mut places: Vec<NodeId> = graph.rooms().iter().copied().chain(doors).collect();
    stream.shuffle(&mut places);
    places.truncate(3);
    let mut orders = Vec::new();
    for agent in home.agents() {
        let mut at = stream.below(60) as u64;
        while at < LAST / 2 {
            let verb = if stream.chance(0.2) { Verb::Run } else { Verb::Walk };
            let walk = Action::one(verb, *stream.pick(&places).unwrap());
            let stops = interrupted && stream.chance(0.3);
            let order = if stops { stream.chance(0.5).then_some(Action::zero(Verb::Wave)) } else { Some(walk) };
            orders.push((at, *agent, order));
            at += if interrupted { 20 + stream.below(160) as u64 } else { LAST };
        }
    }
    orders.sort_by_key(|(at, agent, _)| (*at, *agent));
    orders
}

fn gives(home: &mut Environment, (agent, order): (NodeId, Option<Action>)) {
    match order {
        Some(action) => home.give(agent, action),
        None => home.interrupt(agent),
    }
}

/// Lets a home go on with orders, in steps of at most a length. `watch` may change it between two steps.
fn play(
    mut home: Environment,
    orders: &Orders,
    step: u64,
    mut watch: impl FnMut(&mut Environment),
) -> (Environment, Vec<Ending>) {
    let (begin, mut left, mut endings) = (home.tick(), orders.clone(), Vec::new());
    loop {
        let now = (home.tick() - begin).0;
        watch(&mut home);
        left.extract_if(.., |order| order.0 <= now).for_each(|(_, agent, order)| gives(&mut home, (agent, order)));
        if now == LAST {
            return (home, endings);
        }
        let next = left.iter().map(|order| order.0).min().unwrap_or(LAST);
        endings.extend(home.step(Span(step.min(next - now))));
    }
}

fn feet(home: &Environment, agent: NodeId) -> Point2<f32> {
    home.world().pose(agent).unwrap().translation.vector.xy().into()
}

/// The distances that are seen between agents who meet.
#[derive(Default)]
struct Seen {
    before: Vec<Point2<f32>>,
    /// The nearest that two have come, metres, and in how many looks they were nearer than bodies are wide.
    least: f32,
    looks: usize,
    narrow: usize,
}

impl Seen {
    fn look(&mut self, home: &Environment) {
        let now = home.moment();
        let all: Vec<Point2<f32>> = home.agents().iter().map(|agent| feet(&now, *agent)).collect();
        let pairs = (0..all.len()).flat_map(|i| (0..i).map(move |j| (i, j)));
        let nearest = pairs.map(|(i, j)| (all[i] - all[j]).norm()).fold(f32::INFINITY, f32::min);
        self.least = self.least.min(nearest);
        self.looks += 1;
        self.narrow += usize::from(nearest < BODIES);
        for ((agent, at), was) in home.agents().iter().zip(&all).zip(&self.before) {
            let moved = (at - was).norm();
            assert!(moved < 3.1 * EVERY as f32 / 60.0 + 0.02, "{moved} m at once");
            if home.current_action(*agent).is_none() && moved > 0.0 {
                makes_way_through_no_door(&now, *agent);
            }
        }
        self.before = all;
    }
}

/// Whoever makes way does so in the open: it is never in a leaf that is shut.
fn makes_way_through_no_door(now: &Environment, agent: NodeId) {
    let there = now.world().standing(agent, &now.world().pose(agent).unwrap()).unwrap();
    let shut = |id: &NodeId| now.world().parts(*id).openness().is_some_and(|open| open < 0.01);
    assert_eq!(there.obstacles().into_iter().find(shut), None, "in a closed door");
}

/// Runs in several homes: the home and its orders.
fn runs(runs: u64, interrupted: bool) -> Vec<(String, Environment, Orders)> {
    let mut all = Vec::new();
    for (index, agents) in [(42, 2), (7, 2), (8, 3), (113, 3)].into_iter() {
        let home = home(index, agents);
        for nth in 0..runs {
            let orders = orders(&home, Seed(index).nth(nth), interrupted);
            all.push((format!("home {index}, {agents} agents, run {nth}"), home.clone(), orders));
        }
    }
    all
}

/// Nobody walks into anybody; bodies overlap seldom; whoever is blocked is told by what.
fn keep_apart(amount: u64, interrupted: bool) {
    let (mut blocked, mut done, mut looks, mut narrow, mut bad) = (0, 0, 0, 0, Vec::new());
    for (name, home, orders) in runs(amount, interrupted) {
        let mut seen = Seen { least: f32::INFINITY, ..Seen::default() };
        let (_, endings) = play(home, &orders, EVERY, |home| seen.look(home));
        if seen.least < LEAST {
            bad.push(format!("{name}: {} m", seen.least));
        }
        (looks, narrow) = (looks + seen.looks, narrow + seen.narrow);
        for ending in endings {
            done += usize::from(ending.outcome.is_ok());
            if let Some(Interruption::Blocked { by }) = interruption(&ending) {
                assert!(!by.is_empty(), "{name}: {ending:?}");
                blocked += 1;
            }
        }
    }
    assert!(bad.is_empty(), "{bad:#?}");
    assert!(narrow * 20 < looks, "{narrow} of {looks} are narrow");
    assert!(done > blocked * 20, "{done} done, {blocked} blocked");
}

#[test]
fn walkers_keep_apart() {
    keep_apart(vc_testkit::amount(1, 40), false);
}

#[test]
fn those_who_are_stopped_are_not_walked_through() {
    keep_apart(vc_testkit::amount(2, 50), true);
}

/// However time is divided, and in whatever order the orders of one tick come, and when the home is saved and restored
/// in the middle, all comes to the same.
#[test]
fn stops_come_to_the_same() {
    for (name, home, orders) in runs(vc_testkit::amount(1, 40), true) {
        // Several are stopped in one tick.
        let mut orders: Orders = orders.into_iter().map(|(at, agent, order)| (at / 60 * 60, agent, order)).collect();
        orders.sort_by_key(|(at, agent, _)| (*at, *agent));
        orders.dedup_by_key(|(at, agent, _)| (*at, *agent));
        let (end, endings) = play(home.clone(), &orders, LAST, |_| {});
        let last = end.save().unwrap();
        let reversed: Orders = orders.iter().rev().copied().collect();
        let (other, _) = play(home.clone(), &reversed, 1, |_| {});
        assert!(other.save().unwrap() == last, "{name}: in single ticks");
        let mut ticks = 0;
        let (other, told) = play(home.clone(), &orders, 7, |home| {
            ticks += 1;
            if ticks % 5 == 0 {
                *home = home.restore(&home.save().unwrap()).unwrap();
            }
        });
        assert_eq!(told, endings, "{name}: saved in the middle");
        assert!(other.save().unwrap() == last, "{name}: saved in the middle");
    }
}

/// Several who walk to one thing, again and again, with pauses: nobody ends in anybody, and no outcome is told against
/// somebody who has only been passed, or kept a door from shutting.
#[test]
fn many_walk_to_one_thing() {
    for (number, agents) in [(29_939, 4), (87_033, 3), (84_210, 4), (42, 4)] {
        let mut home = home(number, agents);
        let all = home.agents().to_vec();
        let things: Vec<NodeId> = home.graph().nodes().filter(|n| n.kind() == NodeKind::Object).map(Node::id).collect();
        let mut stream = Seed(number).child("many walk").stream();
        for round in 0..vc_testkit::amount(4, 40) {
            let goal = *stream.pick(&things).unwrap();
            let mut endings = Vec::new();
            for agent in &all {
                home.give(*agent, Action::walk(goal));
                endings.extend(home.step(Span(if stream.chance(0.5) { 0 } else { stream.below(120) as u64 })));
            }
            endings.extend(home.step_until_idle(Span(20_000)));
            for ending in &endings {
                let error = ending.outcome.as_ref().err();
                let differs = matches!(error, Some(ActionError::Disagreement(_)));
                assert!(!differs, "home {number}, round {round}: {error:?}");
            }
            home.step(Span(60));
            let feet = |id: &NodeId| home.world().pose(*id).unwrap().translation.vector;
            for (i, one) in all.iter().enumerate() {
                for other in &all[..i] {
                    let far = (feet(one) - feet(other)).norm();
                    assert!(far > LEAST, "home {number}, round {round}: {one} and {other} are {far} m apart");
                }
            }
        }
    }
}
