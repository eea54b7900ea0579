//! Single actions with bodies: opening, fetching, putting down, and refusals.

use virtualcity::graph::clock::Span;
use virtualcity::graph::{Action, Node, NodeId, NodeKind, ParsedAction, Place, Pose, Relation, State, Verb};
use virtualcity::nalgebra::Point2;
use virtualcity::physics::{BodyRole, Hand};
use virtualcity::{ActionError, Environment, PhysicalRefusal};

use super::{act, home};

/// Plates, bowls and spoons move out and in with the racks.
#[test]
fn what_is_in_racks_comes_along() {
    let mut home = home(5, 1);
    let (me, dishwasher) = (home.agents()[0], home.graph().of_class("dishwasher")[0]);
    let inside = home.graph().carried_with(dishwasher);
    let things: Vec<NodeId> = inside.into_iter().filter(|id| *id != dishwasher).collect();
    assert!(things.len() > 3, "{things:?}");
    let places = |home: &Environment| things.iter().map(|id| home.world().pose(*id).unwrap()).collect::<Vec<_>>();
    let far = |a: &[Pose], b: &[Pose]| -> Vec<f32> {
        a.iter().zip(b).map(|(a, b)| (a.translation.vector - b.translation.vector).norm()).collect()
    };
    let shut = places(&home);
    act(&mut home, me, Verb::Walk, &[dishwasher]);
    act(&mut home, me, Verb::Open, &[dishwasher]);
    let open = places(&home);
    assert!(far(&shut, &open).iter().all(|d| *d > 0.3), "{:?}", far(&shut, &open));
    act(&mut home, me, Verb::Close, &[dishwasher]);
    let again = places(&home);
    assert!(far(&shut, &again).iter().all(|d| *d < 0.08), "{:?}", far(&shut, &again));
}

/// A refused action gives the reason and changes nothing.
#[test]
fn refusals_change_nothing() {
    let mut home = home(8, 1);
    let (me, before) = (home.agents()[0], home.digest());
    let far = home.graph().nodes().filter(|n| n.kind() == NodeKind::Object).map(|n| n.id());
    let far = far.filter(|id| !home.graph().near(me, *id)).last().unwrap();
    let refused = home.set_action(me, Action::one(Verb::Touch, far)).unwrap_err();
    assert!(matches!(&refused, ActionError::Refused(why) if !why.is_empty()), "{refused}");
    assert!(home.set_action(NodeId(u32::MAX), Action::zero(Verb::Dance)).is_err());
    assert!(home.set_action(me, Action::one(Verb::Grab, NodeId(u32::MAX))).is_err());
    let twice = home.set_actions(&[(me, Action::zero(Verb::Wave)), (me, Action::zero(Verb::Dance))]);
    assert!(twice.iter().all(|o| matches!(o, Err(ActionError::Twice(_)))));
    assert_eq!(home.digest(), before);
}

/// An object inside a container that opens, both in one home.
pub(crate) fn kept_thing(home: &Environment) -> Option<(NodeId, NodeId)> {
    let graph = home.graph();
    let moves = |id: NodeId| !home.world().parts(id).all().is_empty();
    let small = |id: &NodeId| home.world().role(*id) == Some(BodyRole::Loose);
    let inside = |at: NodeId| graph.relating(Relation::Inside, at).find(small).map(|id| (id, at));
    graph.nodes().filter(|n| n.hides_contents() && moves(n.id())).find_map(|n| inside(n.id()))
}

/// Fetching an object out of a closed container: the door really opens, the object is in the hand, and then
/// stands on a table at rest.
#[test]
fn a_thing_is_fetched_and_put_on_a_table() {
    let mut home = home(42, 1);
    let me = home.agents()[0];
    let (thing, cupboard) = kept_thing(&home).unwrap();
    act(&mut home, me, Verb::Walk, &[cupboard]);
    act(&mut home, me, Verb::Open, &[cupboard]);
    assert!(home.world().parts(cupboard).openness().unwrap() > 0.3);
    act(&mut home, me, Verb::Grab, &[thing]);
    assert_eq!(home.world().held(me, Hand::Right), Some(thing));
    let (body, held) = (home.world().pose(me).unwrap(), home.world().aabb(thing).unwrap().centre());
    let local = body.inverse_transform_point(&held);
    assert!(local.x > 0.2 && local.x < 0.8 && local.z > 0.7, "{local:?}");
    act(&mut home, me, Verb::Close, &[cupboard]);
    assert_eq!(home.world().parts(cupboard).state(), Some(State::Closed));
    let table = ["kitchen_table", "dining_table", "coffee_table", "desk"];
    let table = table.iter().find_map(|c| home.graph().of_class(c).first().copied()).unwrap();
    act(&mut home, me, Verb::Walk, &[table]);
    act(&mut home, me, Verb::Place, &[thing, table]);
    assert!(home.graph().places(thing).any(|p| p == Place { relation: Relation::On, at: table }));
    assert!(home.world().supports(thing).contains(&table) && home.world().body(thing).unwrap().is_asleep());
    assert_eq!(home.history().events().len(), 6);
    // Back to the start.
    let start = home.start().clone();
    home.reset(&start).unwrap();
    assert_eq!(home.graph(), &start);
    assert!(home.history().events().is_empty());
}

/// Actions in real time and at once have the same result, and no agent walks faster than people do.
#[test]
fn time_changes_nothing_but_what_is_seen() {
    let (mut at_once, mut in_time) = (home(42, 2), home(42, 2));
    let agents = at_once.agents().to_vec();
    let (_, cupboard) = kept_thing(&at_once).unwrap();
    let room = at_once.graph().room_of(cupboard).unwrap();
    let both = [(agents[0], Action::one(Verb::Walk, cupboard)), (agents[1], Action::one(Verb::Walk, room))];
    let open = [(agents[0], Action::one(Verb::Open, cupboard)), (agents[1], Action::zero(Verb::Wave))];
    let mut ticks = 0;
    for actions in [both, open] {
        assert!(at_once.set_actions(&actions).iter().all(Result::is_ok));
        let mut last = in_time.world().pose(agents[0]).unwrap().translation.vector;
        let outcomes = in_time.set_actions_in_time(&actions, Span(1), |now| {
            let at = now.world().pose(agents[0]).unwrap().translation.vector;
            assert!((at - last).norm() < 0.1, "a leap of {} m", (at - last).norm());
            (last, ticks) = (at, ticks + 1);
        });
        assert!(outcomes.iter().all(Result::is_ok));
        assert_eq!(at_once.digest(), in_time.digest());
    }
    assert!(ticks > 100, "{ticks}");
}

/// Blinds hang higher than hands reach, but their cords hang down.
#[test]
fn blinds_are_let_down_by_their_cords() {
    let mut let_down = 0;
    for seed in 0..3 {
        let mut home = home(seed, 1);
        let me = home.agents()[0];
        for id in home.graph().of_class("blinds") {
            act(&mut home, me, Verb::Walk, &[id]);
            act(&mut home, me, Verb::Close, &[id]);
            assert!(home.graph().node(id).is_some_and(|n| n.is(State::Closed)));
            let_down += 1;
        }
    }
    assert!(let_down >= 3, "{let_down} blinds");
}

/// Bowls that hop on a rack come back with it.
#[test]
fn a_dishwasher_shuts_however_its_bowls_lie() {
    let mut home = Environment::make("apartment/5", 1).unwrap();
    let me = home.agents()[0];
    let dishwasher = home.graph().of_class("dishwasher")[0];
    let inside = |home: &Environment| {
        let mut all: Vec<NodeId> = home.graph().relating(Relation::Inside, dishwasher).collect();
        all.sort_unstable();
        all
    };
    let full = inside(&home);
    assert!(full.len() > 4, "{full:?}");
    let plate = home.graph().of_class("soup_plate")[0];
    let cabinet = home.graph().hidden_in(plate).unwrap();
    for (verb, thing) in [(Verb::Walk, dishwasher), (Verb::Open, cabinet), (Verb::Grab, plate)] {
        home.set_action(me, Action::one(verb, thing)).unwrap();
    }
    for _ in 0..3 {
        for verb in [Verb::Open, Verb::Close] {
            home.set_action(me, Action::one(verb, dishwasher)).unwrap();
            assert_eq!(inside(&home), full, "{verb:?}");
        }
    }
}

/// Wherever one drops a pillow or a blanket in a narrow kitchen, one gets past it, and so does everybody else.
#[test]
fn nobody_is_shut_in_by_what_is_dropped() {
    let mut home = home(42, 2);
    let (me, other) = (home.agents()[0], home.agents()[1]);
    let (kitchen, hall) = (home.graph().of_class("kitchen")[0], home.graph().of_class("living_room")[0]);
    let (low, high) = home.graph().node(kitchen).and_then(|n| n.aabb()).map(|b| (b.min, b.max)).unwrap();
    home.teleport(other, kitchen).unwrap();
    let mut dropped = 0;
    for class in ["pillow", "blanket"] {
        let thing = home.graph().of_class(class)[0];
        act(&mut home, me, Verb::Walk, &[thing]);
        act(&mut home, me, Verb::Grab, &[thing]);
        for step in 1..6 {
            let along = low + (high - low) * (step as f32 / 6.0);
            if home.teleport(me, Point2::new(along.x, 1.2)).is_err() {
                continue;
            }
            let put = home.set_action(me, Action::one(Verb::Drop, thing));
            match put {
                Ok(_) => dropped += 1,
                Err(ActionError::Impossible { why: PhysicalRefusal::ShutsIn { .. }, .. }) => continue,
                Err(other) => panic!("{other}"),
            }
            for agent in [me, other] {
                let out = home.can_do(agent, &Action::one(Verb::Walk, hall));
                assert!(out.is_ok(), "{class} dropped from {along}: {}", out.unwrap_err());
            }
            act(&mut home, me, Verb::Grab, &[thing]);
        }
        act(&mut home, me, Verb::Walk, &[hall]);
        act(&mut home, me, Verb::Drop, &[thing]);
    }
    assert!(dropped > 3, "{dropped}");
}

/// Plates that come to rest in a rack only after a second attempt ride on it into the dishwasher.
#[test]
fn plates_ride_into_the_dishwasher() {
    let mut home = home(97232, 1);
    let (me, dishwasher) = (home.agents()[0], home.graph().of_class("dishwasher")[0]);
    let program = "walk kitchen_cabinet.167; open kitchen_cabinet.168; open dishwasher.172; open kitchen_cabinet.169; \
                   open kitchen_cabinet.171; open kitchen_wall_cabinet.181; open kitchen_wall_cabinet.176; \
                   open kitchen_wall_cabinet.177; grab soup_plate.445; put_in soup_plate.445 dishwasher.172; \
                   open kitchen_wall_cabinet.182; grab dessert_plate.469; put_in dessert_plate.469 dishwasher.172; \
                   close dishwasher.172";
    for line in program.split("; ") {
        home.set_action(me, line.parse::<ParsedAction>().unwrap().action).unwrap();
    }
    let around = home.graph().node(dishwasher).and_then(Node::aabb).unwrap();
    for id in home.graph().carried_with(dishwasher).into_iter().filter(|id| *id != dishwasher) {
        let middle = home.graph().node(id).and_then(Node::aabb).unwrap().centre();
        let within = (0..3).all(|i| (around.min[i]..=around.max[i]).contains(&middle[i]));
        assert!(within, "{} is before the dishwasher", home.graph().label(id));
    }
}

/// Contents of a bowl that is put into a cupboard are in both, and the rule and the bodies agree.
#[test]
fn a_full_bowl_is_put_into_a_cupboard() {
    let mut home = home(42, 1);
    let program = "walk kitchen_cabinet.138; open kitchen_cabinet.138; walk teaspoon.384; grab teaspoon.384; \
                   walk spice_rack.307; put_in teaspoon.384 spice_rack.307; grab spice_rack.307; walk kitchen_cabinet.131; \
                   open kitchen_cabinet.131; put_in spice_rack.307 kitchen_cabinet.131; close kitchen_cabinet.131";
    for line in program.split("; ") {
        home.set_action(home.agents()[0], line.parse::<ParsedAction>().unwrap().action).unwrap();
    }
    assert!(home.graph().hidden_in(NodeId(384)).is_some());
}

/// A thing of a class that an agent has fetched from where it could be put.
fn fetched(home: &mut Environment, agent: NodeId, class: &str) -> Option<NodeId> {
    let tables = ["nightstand", "coffee_table", "desk", "dining_table", "kitchen_table"];
    let tables: Vec<NodeId> = tables.iter().flat_map(|class| home.graph().of_class(class)).collect();
    tables.into_iter().find_map(|at| {
        let thing = home.spawn(class, Place { relation: Relation::On, at }).ok()?;
        home.set_action(agent, Action::walk(thing)).ok()?;
        home.set_action(agent, Action::grab(thing)).ok()?;
        Some(thing)
    })
}

/// What is put onto a tray in a hand, one's own or somebody else's, is carried along on it, and can be taken from it.
#[test]
fn what_is_put_onto_a_tray_in_a_hand_is_carried_along() {
    for seed in [42, 8, 32_784] {
        let mut home = home(seed, 2);
        let (a, b) = (home.agents()[0], home.agents()[1]);
        let tray = fetched(&mut home, a, "tray").unwrap();
        let apple = fetched(&mut home, a, "apple").unwrap();
        act(&mut home, a, Verb::Place, &[apple, tray]);
        let plum = fetched(&mut home, b, "plum").unwrap();
        act(&mut home, b, Verb::Walk, &[a]);
        act(&mut home, b, Verb::Place, &[plum, tray]);
        let room = home.graph().room_of(home.graph().first_of_class("bed").unwrap()).unwrap();
        act(&mut home, a, Verb::Walk, &[room]);
        let at = |id: NodeId| home.world().aabb(id).unwrap();
        for fruit in [apple, plum] {
            assert!(home.graph().rests_at(fruit, tray), "{seed}: {:?}", home.graph().place(fruit));
            assert!(at(tray).gap(&at(fruit)) < 0.01 && home.graph().room_of(fruit) == Some(room));
        }
        act(&mut home, a, Verb::Grab, &[plum]);
        assert!(home.graph().rests_at(apple, tray) && home.graph().holder(plum).is_some_and(|by| by.at == a));
    }
}
