//! The thesis's random model.

use vc_graph::goal::Term;
use vc_graph::{Action, Goal, NodeId, Observation, SceneGraph, Stream};
use vc_tasks::WorldError;
use vc_tasks::library::THESIS_VERBS;

use super::{EpisodeStart, Policy, RefusalResponse};
use crate::{Decision, Learned, Plan};

/// The thesis's random model: a verb and objects of interest, each drawn uniformly;
/// what cannot be done is ignored, and counts as a step.
///
/// ```
/// use vc_graph::{Draft, SceneBuilder, Simulator};
/// use vc_planner::{RandomPolicy, run_episode};
/// use vc_tasks::Task;
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
/// let apple = scene.add_on(table, Draft::new("apple"))?;
/// let me = scene.add_in(kitchen, Draft::new("character"))?;
/// let mut world = Simulator::new(scene.build());
/// let mut task = Task::new("fetch", "Holds(apple)".parse()?);
/// task.step_limit = 5;
/// assert!(run_episode(&mut RandomPolicy::default(), &task, &mut world).steps <= 5);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Default)]
pub struct RandomPolicy {
    things: Vec<NodeId>,
    stream: Option<Stream>,
}

impl RandomPolicy {
    fn draw(&mut self) -> Option<Action> {
        let stream = self.stream.as_mut()?;
        // A verb of VirtualCity that takes more things than there are is drawn again.
        for _ in 0..64 {
            let verb = *stream.pick(&THESIS_VERBS)?;
            let things: Vec<NodeId> = (0..verb.arity()).filter_map(|_| stream.pick(&self.things).copied()).collect();
            if let Ok(action) = Action::with(verb, &things) {
                return Some(action);
            }
        }
        None
    }
}

/// The objects of interest of a goal in a scene: what it names, of each class all that
/// there are, and what these are in or on.
///
/// ```
/// use vc_graph::{Draft, SceneBuilder};
/// use vc_planner::objects_of_interest;
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
/// let apple = scene.add_on(table, Draft::new("apple"))?;
/// let me = scene.add_in(kitchen, Draft::new("character"))?;
/// let graph = scene.build();
/// assert!(objects_of_interest(&graph, &"Holds(apple)".parse()?).contains(&apple));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn objects_of_interest(scene: &SceneGraph, goal: &Goal) -> Vec<NodeId> {
    let mut found = Vec::new();
    for term in goal.expanded(scene.vocabulary()).terms() {
        match term {
            Term::Class(class) => found.extend(scene.of_class(&class)),
            Term::Node(_, id) => found.push(id),
            _ => {}
        }
    }
    let around: Vec<NodeId> = found.iter().filter_map(|&id| scene.place(id)).map(|p| p.at).collect();
    found.extend(around);
    found.sort_unstable();
    found.dedup();
    found
}

impl Policy for RandomPolicy {
    fn name(&self) -> &str {
        "random"
    }

    fn knows_when_to_stop(&self) -> bool {
        false
    }

    fn begin(&mut self, start: &EpisodeStart<'_>) {
        self.things = objects_of_interest(start.scene, &start.task.goal);
        self.stream = Some(start.seed.child("random policy").stream());
    }

    fn see(&mut self, _: &Observation) -> Learned {
        Learned::default()
    }

    fn decide(&mut self) -> Decision {
        self.draw().map_or(Decision::Done, |action| Decision::Act(action, Plan::default()))
    }

    fn did(&mut self, _: &Action) {}

    fn refused(&mut self, _: &Action, _: &WorldError) -> RefusalResponse {
        RefusalResponse::GoOn
    }
}
