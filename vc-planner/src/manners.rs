//! How a home is to be left.

use vc_graph::{Action, NodeId, SceneGraph, State, Verb};

/// How a home is to be left.
///
/// ```
/// use vc_graph::{Draft, SceneBuilder, Simulator, State};
/// use vc_planner::{Manners, Resident, run_episode};
/// use vc_tasks::{Outcome, Task};
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let fridge = scene.add_in(kitchen, Draft::new("fridge"))?;
/// scene.add_in(fridge, Draft::new("milk"))?;
/// scene.add_in(kitchen, Draft::new("character"))?;
/// let (scene, task) = (scene.build(), Task::new("milk", "Holds(milk)".parse()?));
/// for (manners, left) in [(Manners::GoalOnly, State::Open), (Manners::Tidy, State::Closed)] {
///     let mut world = Simulator::new(scene.clone());
///     let episode = run_episode(&mut Resident::default().mannered(manners), &task, &mut world);
///     assert_eq!(episode.outcome, Outcome::Won);
///     assert!(world.graph().node(fridge).is_some_and(|n| n.is(left)));
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
pub enum Manners {
    /// Only the goal counts.
    #[default]
    GoalOnly,
    /// What was closed is closed again and what was off switched off, unless the goal
    /// wants it otherwise; what was open or on is left so, too.
    Tidy,
}

/// How doors and switches are to be left, beside what the goal says.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Leave<'a> {
    /// What has been touched, for those who put it back.
    pub(crate) tidy: Option<&'a Touched>,
    /// To these another is bringing something: they are neither closed nor switched.
    pub(crate) awaited: &'a [NodeId],
    /// What others hold they see to.
    pub(crate) in_company: bool,
}

/// Doors and switches that have been touched, each with the state it was in at first.
#[derive(Debug, Clone, Default)]
pub(crate) struct Touched(Vec<(NodeId, State)>);

impl Touched {
    /// Takes note of an action that was done.
    pub(crate) fn note(&mut self, action: &Action) {
        let (Some(id), Some(was)) = (action.object, before(action.verb)) else { return };
        let same = |(other, state): &(NodeId, State)| *other == id && is_door(*state) == is_door(was);
        if !self.0.iter().any(same) {
            self.0.push((id, was));
        }
    }

    /// Those that are not as they were, the last touched first.
    pub(crate) fn amiss(&self, graph: &SceneGraph) -> impl Iterator<Item = (NodeId, State)> {
        self.0.iter().rev().copied().filter(|(id, was)| graph.node(*id).is_some_and(|n| !n.is(*was)))
    }
}

/// What a thing must have been before a verb could be done to it.
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
