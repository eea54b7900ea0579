//! A policy of your own: it walks from room to room and opens whatever is closed, until it sees what it wants.
//!
//! `cargo run --release --example own_policy` runs it beside the planner on the same goal in the same home.

#[path = "support/no_options.rs"]
mod no_options;
mod support;

use std::collections::{BTreeSet, VecDeque};

use support::{Complaint, say};
use virtualcity::graph::{
    Action, Draft, Node, NodeId, Observation, Property, SceneBuilder, Seed, Simulator, State, Verb,
};
use virtualcity::planner::{
    Decision, EpisodeStart, Learned, Plan, PlannerPolicy, Policy, RefusalResponse, Unreachable, run_episode,
};
use virtualcity::procgen::Apartment;
use virtualcity::tasks::{Outcome, Task, WorldError};

/// Takes the first object of a class that it sees.
struct Sweep {
    class: &'static str,
    rooms: VecDeque<NodeId>,
    opened: BTreeSet<NodeId>,
    /// Actions that are decided already.
    next: VecDeque<Action>,
    holds: bool,
}

impl Sweep {
    fn new(class: &'static str) -> Self {
        Self { class, rooms: VecDeque::new(), opened: BTreeSet::new(), next: VecDeque::new(), holds: false }
    }
}

impl Policy for Sweep {
    fn name(&self) -> &str {
        "sweep"
    }

    fn begin(&mut self, brief: &EpisodeStart<'_>) {
        *self = Self::new(self.class);
        // The plan of the home is known, its contents are not.
        self.rooms = brief.scene.rooms().iter().copied().collect();
    }

    fn see(&mut self, seen: &Observation) -> Learned {
        if self.next.is_empty() {
            let wanted = seen.nodes().find(|n| **n.class() == *self.class);
            let closed = |n: &&Node| n.is(State::Closed) && n.affords(Property::Openable);
            let shut = seen.nodes().filter(closed).find(|n| !self.opened.contains(&n.id()));
            self.next = match (wanted, shut) {
                (Some(node), _) => [Action::one(Verb::Walk, node.id()), Action::one(Verb::Grab, node.id())].into(),
                (None, Some(node)) => {
                    self.opened.insert(node.id());
                    [Action::one(Verb::Walk, node.id()), Action::one(Verb::Open, node.id())].into()
                }
                (None, None) => self.rooms.pop_front().map(|room| Action::one(Verb::Walk, room)).into_iter().collect(),
            };
        }
        Learned::default()
    }

    fn decide(&mut self) -> Decision {
        match self.next.front() {
            _ if self.holds => Decision::Done,
            Some(action) => Decision::Act(*action, Plan::default()),
            None => Decision::GiveUp(Unreachable::NoInstance(self.class.to_owned())),
        }
    }

    fn did(&mut self, action: &Action) {
        self.next.pop_front();
        self.holds |= action.verb == Verb::Grab;
    }

    fn refused(&mut self, _: &Action, _: &WorldError) -> RefusalResponse {
        self.next.clear();
        RefusalResponse::GoOn
    }
}

fn main() -> Result<(), Complaint> {
    no_options::no_options();
    let mut scene = SceneBuilder::from_graph(Apartment::from_seed(Seed(9))?.scene());
    let room = scene.graph().rooms()[0];
    scene.add_in(room, Draft::new("character"))?;
    let graph = scene.build();
    let task = Task::new("fetch a mug", "Holds(mug)".parse()?);
    let policies: [&mut dyn Policy; 2] = [&mut Sweep::new("mug"), &mut PlannerPolicy::best()];
    for policy in policies {
        let episode = run_episode(policy, &task, &mut Simulator::new(graph.clone()));
        say!("{}: {:?} after {} steps", policy.name(), episode.outcome, episode.steps);
        if episode.outcome != Outcome::Won {
            return Err(Complaint::new(format!("{} has no mug: {:?}", policy.name(), episode.reason)));
        }
    }
    Ok(())
}
