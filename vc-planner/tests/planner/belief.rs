//! The belief of an agent: certain where it has looked, a guess elsewhere, and never based on more than it can
//! know.

#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use vc_graph::{Draft, NodeId, Place, Property, Relation, SceneBuilder, SceneGraph, Scope, Simulator, State, Verb};
use vc_planner::{Agent, Belief, Decision};

/// A flat of two rooms with closed cupboards; the apple is in the cupboard with a given number.
struct Flat {
    scene: SceneGraph,
    me: NodeId,
    apple: NodeId,
    kitchen: NodeId,
    cupboards: Vec<NodeId>,
}

fn flat(apple_in: usize) -> Flat {
    let mut scene = SceneBuilder::new("flat");
    let kitchen = scene.add(Draft::new("kitchen")).unwrap();
    let living = scene.add(Draft::new("living_room")).unwrap();
    for room in [kitchen, living] {
        scene.add_in(room, Draft::new("floor")).unwrap();
    }
    scene.add_in(kitchen, Draft::new("kitchen_table")).unwrap();
    let rooms = [kitchen, kitchen, living, living];
    let cupboards: Vec<NodeId> =
        rooms.iter().map(|&room| scene.add_in(room, Draft::new("kitchen_cabinet")).unwrap()).collect();
    let me = scene.add_in(living, Draft::new("character")).unwrap();
    let apple = scene.add_in(cupboards[apple_in], Draft::new("apple")).unwrap();
    Flat { scene: scene.build(), me, apple, kitchen, cupboards }
}

fn places(flat: &Flat) -> Vec<Place> {
    let open = |p: Property, id: NodeId| flat.scene.node(id).unwrap().affords(p);
    let all = flat.scene.nodes().map(vc_graph::Node::id);
    all.flat_map(|id| {
        let on = open(Property::Surface, id).then_some(Place { relation: Relation::On, at: id });
        let inside = open(Property::Container, id).then_some(Place { relation: Relation::Inside, at: id });
        on.into_iter().chain(inside)
    })
    .collect()
}

#[test]
fn chances_sum_to_one_and_are_equal() {
    let flat = flat(0);
    let belief = Belief::in_known_home(&flat.scene, flat.me, 1);
    let chances: Vec<f64> = places(&flat).iter().map(|&p| belief.probability(flat.apple, p)).collect();
    assert!((chances.iter().sum::<f64>() - 1.0).abs() < 1e-9, "{chances:?}");
    assert!(chances.iter().all(|&c| c == 0.0 || (c - chances[0].max(chances[1])).abs() < 1e-9), "{chances:?}");
}

#[test]
fn what_is_seen_empty_is_excluded_and_only_what_is_disproved_is_guessed_anew() {
    for seed in 0..20 {
        let flat = flat(0);
        let mut world = Simulator::new(flat.scene.clone());
        let mut belief = Belief::in_known_home(&flat.scene, flat.me, seed);
        belief.observe(&world.graph().observe(flat.me, Scope::Room));
        for cupboard in [flat.cupboards[2], flat.cupboards[3]] {
            let before = belief.graph().place(flat.apple);
            for verb in ["walk", "open"] {
                world.step(flat.me, &format!("{verb} {}", world.graph().label(cupboard)).parse().unwrap()).unwrap();
            }
            let learned = belief.observe(&world.graph().observe(flat.me, Scope::Room));
            let here = Place { relation: Relation::Inside, at: cupboard };
            assert_eq!(belief.probability(flat.apple, here), 0.0);
            let disproved = before == Some(here);
            assert_eq!(learned.disproved.contains(&flat.apple), disproved);
            assert_eq!(belief.graph().place(flat.apple) == before, !disproved);
        }
    }
}

#[test]
fn a_picture_shows_where_a_thing_can_be() {
    let flat = flat(2);
    let mut belief = Belief::in_known_home(&flat.scene, flat.me, 4);
    let places = belief.distribution(flat.apple).len();
    let fields = |svg: &str, colour: &str| svg.matches(&format!("fill='{colour}' fill-opacity")).count();
    let before = belief.to_svg(&[flat.apple, NodeId(u32::MAX)]);
    assert_eq!(fields(&before, "#1f6feb"), places, "a field for each place");
    assert_eq!(before.matches("<circle").count(), 1, "one of them is supposed");
    let open = {
        let mut scene = flat.scene.clone();
        let mut edit = scene.edit();
        edit.enter_state(flat.cupboards[2], State::Open).unwrap();
        edit.commit();
        scene
    };
    belief.observe(&open.observe(flat.me, Scope::Room));
    let after = belief.to_svg(&[flat.apple]);
    assert_eq!((fields(&after, "#1f6feb"), fields(&after, "#2da44e")), (0, 1), "it has been seen");
}

#[test]
fn what_is_seen_is_certain() {
    let flat = flat(2);
    let mut world = Simulator::new(flat.scene.clone());
    let mut belief = Belief::in_known_home(&flat.scene, flat.me, 4);
    for verb in ["walk", "open"] {
        world.step(flat.me, &format!("{verb} {}", world.graph().label(flat.cupboards[2])).parse().unwrap()).unwrap();
    }
    let learned = belief.observe(&world.graph().observe(flat.me, Scope::Room));
    assert!(learned.found.contains(&flat.apple));
    assert_eq!(belief.graph().place(flat.apple), world.graph().place(flat.apple));
    assert_eq!(belief.probability(flat.apple, world.graph().place(flat.apple).unwrap()), 1.0);
    assert!(belief.graph().node(flat.cupboards[2]).unwrap().is(State::Open));
}

#[test]
fn when_everything_is_disproved_the_belief_widens() {
    let flat = flat(0);
    let mut world = Simulator::new(flat.scene.clone());
    let mut belief = Belief::in_known_home(&flat.scene, flat.me, 9);
    // All cupboards are opened while somebody carries the apple in front of the agent.
    for (index, &cupboard) in flat.cupboards.iter().enumerate().rev() {
        if index == 0 {
            let mut scene = world.graph().clone();
            let mut edit = scene.edit();
            edit.place(flat.apple, Place { relation: Relation::Inside, at: flat.cupboards[3] }).unwrap();
            edit.enter_state(flat.cupboards[3], State::Closed).unwrap();
            edit.commit();
            world = Simulator::new(scene);
        }
        for verb in ["walk", "open"] {
            world.step(flat.me, &format!("{verb} {}", world.graph().label(cupboard)).parse().unwrap()).unwrap();
        }
        belief.observe(&world.graph().observe(flat.me, Scope::Room));
    }
    assert_eq!(belief.widened(), 1);
    assert!(belief.is_missing(flat.apple));
    assert!(belief.possible_places().count() > 0);
}

/// In two homes that differ only in hidden things the agent does the same until it sees the difference.
#[test]
fn agents_know_no_more_than_they_can_see() {
    for seed in 0..10 {
        let runs: Vec<Vec<String>> = [0, 1].iter().map(|&at| trail(&flat(at), seed)).collect();
        let length = runs[0].iter().zip(&runs[1]).take_while(|(a, b)| a == b).count();
        assert!(length >= 1, "{runs:?}");
        // The first difference arises when one of the kitchen's cupboards is open.
        assert!(runs[0][..length].iter().any(|a| a.starts_with("open kitchen_cabinet")), "{runs:?}");
    }
}

fn trail(flat: &Flat, seed: u64) -> Vec<String> {
    let mut world = Simulator::new(flat.scene.clone());
    let goal = "On(apple, kitchen_table)".parse().unwrap();
    let mut agent = Agent::in_known_home(&flat.scene, flat.me, goal, seed);
    let mut done = Vec::new();
    loop {
        agent.see(&world.graph().observe(flat.me, Scope::Room));
        let Decision::Act(action, _) = agent.decide() else { break };
        world.step(flat.me, &action).unwrap();
        agent.did(&action);
        done.push(action.describe(&flat.scene).to_string());
    }
    assert_eq!(world.graph().room_of(flat.apple), Some(flat.kitchen));
    done
}

/// A tidy home: dishes in the kitchen's cupboards, the living room in its usual state.
fn tidy() -> (SceneGraph, NodeId) {
    let mut scene = SceneBuilder::new("tidy");
    let rooms = ["living_room", "bathroom", "kitchen", "bedroom", "hallway"];
    let [living, bathroom, kitchen, bedroom, hallway] = rooms.map(|r| scene.add(Draft::new(r)).unwrap());
    for room in [living, bathroom, kitchen, bedroom, hallway] {
        scene.add_in(room, Draft::new("floor")).unwrap();
    }
    for class in ["toilet", "bathtub", "bathroom_counter", "bathroom_cabinet", "bathroom_shelf", "washing_machine"] {
        scene.add_in(bathroom, Draft::new(class)).unwrap();
    }
    for class in ["bed", "nightstand", "dresser", "closet"] {
        scene.add_in(bedroom, Draft::new(class)).unwrap();
    }
    for class in ["sofa", "tv_stand", "shoe_rack"] {
        scene.add_in(living, Draft::new(class)).unwrap();
    }
    let coffee_table = scene.add_in(living, Draft::new("coffee_table")).unwrap();
    for _ in 0..3 {
        for class in ["mug", "remote_control", "magazine"] {
            scene.add_on(coffee_table, Draft::new(class)).unwrap();
        }
    }
    scene.add_in(kitchen, Draft::new("dishwasher")).unwrap();
    scene.add_in(kitchen, Draft::new("kitchen_counter")).unwrap();
    let cupboards = [0; 10].map(|_| scene.add_in(kitchen, Draft::new("kitchen_cabinet")).unwrap());
    for cupboard in [cupboards[8], cupboards[9]] {
        scene.add_in(cupboard, Draft::new("plate")).unwrap();
    }
    let me = scene.add_in(living, Draft::new("character")).unwrap();
    (scene.build(), me)
}

#[test]
fn a_plate_is_not_looked_for_in_a_bathroom() {
    for seed in 0..20 {
        let (scene, me) = tidy();
        let goal = "Inside(plate, dishwasher) & Closed(dishwasher) & SwitchedOn(dishwasher)".parse().unwrap();
        let mut agent = Agent::in_known_home(&scene, me, goal, seed);
        let mut world = Simulator::new(scene);
        for _ in 0..4 {
            agent.see(&world.graph().observe(me, Scope::Room));
            let Decision::Act(action, _) = agent.decide() else { break };
            world.step(me, &action).unwrap();
            agent.did(&action);
            let room = world.graph().room_of(me).map(|r| world.graph().label(r).to_string());
            let sensible = ["living_room.1", "kitchen.3"].map(str::to_owned);
            assert!(room.as_ref().is_some_and(|r| sensible.contains(r)), "{seed}: {action} in {room:?}");
        }
        let plate = world.graph().of_class("plate")[0];
        let at = |class: &str, relation| Place { relation, at: world.graph().of_class(class)[0] };
        let belief = agent.belief();
        let (toilet, bedroom) = (at("toilet", Relation::Inside), at("nightstand", Relation::On));
        let all: f64 = belief.distribution(plate).iter().map(|(_, chance)| chance).sum();
        assert!((all - 1.0).abs() < 1e-9, "{all}");
        assert!(belief.probability(plate, toilet) < 0.01 && belief.probability(plate, bedroom) < 0.01, "{belief}");
    }
}

/// In an artificial world where plates are kept in bookshelves: once one plate has been found in a bookshelf,
/// the others are searched in bookshelves, after at most two other looks.
#[test]
fn where_one_was_found_the_others_are_looked_for() {
    for seed in 0..10 {
        let mut scene = SceneBuilder::new("odd");
        let [living, kitchen] = ["living_room", "kitchen"].map(|r| scene.add(Draft::new(r)).unwrap());
        let table = scene.add_in(kitchen, Draft::new("kitchen_table")).unwrap();
        for class in ["fridge", "dishwasher", "stove", "microwave"] {
            scene.add_in(kitchen, Draft::new(class)).unwrap();
        }
        for _ in 0..6 {
            scene.add_in(kitchen, Draft::new("kitchen_cabinet")).unwrap();
        }
        let shelves = [0; 5].map(|_| scene.add_in(living, Draft::new("bookshelf")).unwrap());
        for (i, &shelf) in shelves.iter().enumerate() {
            let mut edit = scene.edit();
            edit.enter_state(shelf, State::Closed).unwrap();
            edit.commit();
            if i % 2 == 0 {
                scene.add_in(shelf, Draft::new("plate")).unwrap();
            }
        }
        let me = scene.add_in(kitchen, Draft::new("character")).unwrap();
        let mut world = Simulator::new(scene.build());
        let mut agent = Agent::in_known_home(world.graph(), me, "On(plate, kitchen_table), 3".parse().unwrap(), seed);
        let plates = world.graph().of_class("plate");
        let mut wrong = 0;
        loop {
            agent.see(&world.graph().observe(me, Scope::Room));
            let Decision::Act(action, _) = agent.decide() else { break };
            let opened = action.object.filter(|_| action.verb == Verb::Open);
            let elsewhere = opened.filter(|id| &**world.graph().node(*id).unwrap().class() != "bookshelf");
            let found = plates.iter().any(|id| !agent.belief().is_missing(*id));
            wrong += usize::from(found && elsewhere.is_some());
            world.step(me, &action).unwrap();
            agent.did(&action);
        }
        let laid = plates.iter().filter(|id| world.graph().rests_at(**id, table)).count();
        assert_eq!(laid, 3, "{seed}");
        assert!(wrong <= 2, "{seed}: {wrong} looks elsewhere");
    }
}
