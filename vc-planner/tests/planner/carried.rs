//! Goals that put things into or onto what is itself carried about: it has to be found first, and to be opened.

#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use vc_graph::{Action, ChangeSet, Draft, History, NodeId, Relation, SceneBuilder, SceneGraph, Simulator, Verb};
use vc_planner::{EpisodeOptions, PlannerPolicy, Policy};
use vc_tasks::{Outcome, Task, World, WorldError};

/// Where the item and its holder may be: two floors, a piece of furniture in each room, a closet.
const PLACES: usize = 5;

/// A kitchen, where the agent is, and a bedroom, both with floors.
fn home(item: &str, at: usize, holder: &str, holder_at: usize) -> Simulator {
    let mut scene = SceneBuilder::new("flat");
    let [kitchen, bedroom] = ["kitchen", "bedroom"].map(|room| scene.add(Draft::new(room)).unwrap());
    let [near, far] = [kitchen, bedroom].map(|room| scene.add_in(room, Draft::new("floor")).unwrap());
    let table = scene.add_in(kitchen, Draft::new("kitchen_table")).unwrap();
    let desk = scene.add_in(bedroom, Draft::new("desk")).unwrap();
    let closet = scene.add_in(bedroom, Draft::new("closet")).unwrap();
    let mut put = |class: &str, place: usize| -> NodeId {
        match [near, far, table, desk].get(place) {
            Some(&at) => scene.add_on(at, Draft::new(class)),
            None => scene.add_in(closet, Draft::new(class)),
        }
        .unwrap()
    };
    put(item, at);
    put(holder, holder_at);
    scene.add_in(kitchen, Draft::new("character")).unwrap();
    Simulator::new(scene.build())
}

/// Neither has been seen: one cannot be near both where they are guessed, but what is held is at hand anywhere.
#[test]
fn what_is_carried_about_is_filled_wherever_the_two_are() {
    let goals = [("button", "laundry_basket", "Inside"), ("yarn", "storage_box", "Inside"), ("apple", "tray", "On")];
    for (item, holder, relation) in goals {
        let task = Task::new("fill", format!("{relation}({item}, {holder})").parse().unwrap());
        for (at, holder_at) in (0..PLACES).flat_map(|at| (0..PLACES).map(move |other| (at, other))) {
            for mut policy in [PlannerPolicy::best(), PlannerPolicy::faithful(), PlannerPolicy::in_unknown_home()] {
                let mut world = home(item, at, holder, holder_at);
                let episode = EpisodeOptions::seeded(1).episode(&mut policy, &task, &mut world, &mut |_| {});
                let case = format!("{}: {item} at {at}, {holder} at {holder_at}", policy.name());
                assert_eq!(episode.outcome, Outcome::Won, "{case}: {:?}", episode.reason);
                assert!(episode.steps <= 16, "{case}: {} steps", episode.steps);
            }
        }
    }
}

/// A world in which nothing that is inside something opens: there is no room for its lid.
struct Cramped(Simulator);

impl World for Cramped {
    fn graph(&self) -> &SceneGraph {
        World::graph(&self.0)
    }

    fn history(&self) -> &History {
        World::history(&self.0)
    }

    fn step(&mut self, agent: NodeId, action: &Action) -> Result<ChangeSet, WorldError> {
        let opens = action.object.filter(|_| action.verb == Verb::Open);
        let place = opens.and_then(|id| self.0.graph().place(id));
        if place.is_some_and(|place| place.relation == Relation::Inside) {
            return Err(WorldError::Failed("it stays 0% open".into()));
        }
        World::step(&mut self.0, agent, action)
    }

    fn reset(&mut self, graph: &SceneGraph) -> Result<(), WorldError> {
        World::reset(&mut self.0, graph)
    }
}

#[test]
fn a_box_that_has_no_room_to_open_is_taken_out() {
    for surface in [Some("desk"), None] {
        let mut scene = SceneBuilder::new("flat");
        let bedroom = scene.add(Draft::new("bedroom")).unwrap();
        let closet = scene.add_in(bedroom, Draft::new("closet")).unwrap();
        let shut_in = scene.add_in(closet, Draft::new("storage_box")).unwrap();
        scene.add_in(closet, Draft::new("yarn")).unwrap();
        surface.map(|class| scene.add_in(bedroom, Draft::new(class)).unwrap());
        scene.add_in(bedroom, Draft::new("character")).unwrap();
        let scene = scene.build();
        let task = Task::new("stow", "Inside(yarn, storage_box)".parse().unwrap());
        let policies: [Box<dyn Policy>; 2] = [Box::new(PlannerPolicy::oracle()), Box::new(PlannerPolicy::best())];
        for mut policy in policies {
            let mut world = Cramped(Simulator::new(scene.clone()));
            let episode = EpisodeOptions::seeded(1).episode(policy.as_mut(), &task, &mut world, &mut |_| {});
            assert_eq!(episode.outcome, Outcome::Won, "{}: {episode:?}", policy.name());
            assert!(World::graph(&world).place(shut_in).is_none_or(|place| place.at != closet), "{}", policy.name());
        }
    }
}
