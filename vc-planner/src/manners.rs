//! The state in which an agent leaves a home.

use vc_graph::{Action, NodeId, SceneGraph, State, Verb};

/// The rule for the state in which an agent leaves a home.
///
/// ```
/// use vc_graph::{Draft, SceneBuilder, Simulator, State};
/// use vc_planner::{Manners, PlannerPolicy, run_episode};
/// use vc_tasks::{Outcome, Task};
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let fridge = scene.add_in(kitchen, Draft::new("fridge"))?;
/// scene.add_in(fridge, Draft::new("milk"))?;
/// scene.add_in(kitchen, Draft::new("character"))?;
/// let (scene, task) = (scene.build(), Task::new("milk", "Holds(milk)".parse()?));
/// for (manners, left) in [(Manners::GoalOnly, State::Open), (Manners::Tidy, State::Closed)] {
///     let mut world = Simulator::new(scene.clone());
///     let episode = run_episode(&mut PlannerPolicy::oracle().with_manners(manners), &task, &mut world);
///     assert_eq!(episode.outcome, Outcome::Won);
///     assert!(world.graph().node(fridge).is_some_and(|n| n.is(left)));
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
#[non_exhaustive]
pub enum Manners {
    /// Only the goal counts.
    #[default]
    GoalOnly,
    /// Things that were closed are closed again and things that were off are switched off, unless the goal
    /// wants it otherwise; things that were open or on are left so, too.
    Tidy,
}

/// The requirements on doors and switches besides the goal.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Leave<'a> {
    /// The touched doors and switches, for agents that restore them.
    pub(crate) tidy: Option<&'a Touched>,
    /// Containers to which another agent is bringing something: they are neither closed nor switched.
    pub(crate) awaited: &'a [NodeId],
    /// Whether others pursue the goal, too: they handle the things they hold.
    pub(crate) in_company: bool,
}

/// The doors and switches that have been touched, each with its original state.
#[derive(Debug, Clone, Default)]
pub(crate) struct Touched(Vec<(NodeId, State)>);

impl Touched {
    /// Records an action that was done.
    pub(crate) fn note(&mut self, action: &Action) {
        let (Some(id), Some(was)) = (action.object, before(action.verb)) else { return };
        let same = |(other, state): &(NodeId, State)| *other == id && is_door(*state) == is_door(was);
        if !self.0.iter().any(same) {
            self.0.push((id, was));
        }
    }

    /// The touched nodes that are not in their original state, the last touched first.
    pub(crate) fn amiss(&self, graph: &SceneGraph) -> impl Iterator<Item = (NodeId, State)> {
        self.0.iter().rev().copied().filter(|(id, was)| graph.node(*id).is_some_and(|n| !n.is(*was)))
    }
}

/// The state that a thing must have had before a verb was applied to it.
fn before(verb: Verb) -> Option<State> {
    match verb {
        Verb::Open => Some(State::Closed),
        Verb::Close => Some(State::Open),
        Verb::SwitchOn => Some(State::Off),
        Verb::SwitchOff => Some(State::On),
        _ => None,
    }
}

fn is_door(state: State) -> bool {
    matches!(state, State::Open | State::Closed)
}
