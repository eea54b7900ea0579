//! Goals that put things into or onto what is itself carried about: it has to be found first.

#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use vc_graph::{Draft, NodeId, SceneBuilder, Simulator};
use vc_planner::{EpisodeOptions, PlannerPolicy, Policy};
use vc_tasks::{Outcome, Task};

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
