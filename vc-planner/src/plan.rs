//! Plans, and how far they reach.

use vc_graph::Action;

use crate::open_condition::OpenCondition;

/// How far ahead to plan.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Horizon {
    /// Until the next subgoal is met: enough to know what to do now.
    NextSubgoal,
    /// Until the goal is met.
    Goal,
}

/// The actions to be done, in order. Empty when the goal is known to hold.
///
/// ```
/// use vc_graph::{Draft, History, SceneBuilder};
/// use vc_planner::plan;
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
/// let apple = scene.add_on(table, Draft::new("apple"))?;
/// let me = scene.add_in(kitchen, Draft::new("character"))?;
/// let mut graph = scene.build();
/// let plan = plan(&mut graph, me, &"Holds(apple)".parse()?, &History::default())?;
/// assert_eq!(plan.actions.iter().map(|action| action.to_string()).collect::<Vec<_>>(), ["walk #2", "grab #3"]);
/// assert!(plan.proved, "no plan is shorter");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Plan {
    /// The actions.
    pub actions: Vec<Action>,
    /// The conditions that the actions bring about, each with the number of its actions, in order; only plans by
    /// regression have them.
    pub conditions: Vec<(OpenCondition, usize)>,
    /// No plan of the packed problem is shorter. Where the goal has parts beyond it,
    /// nothing is proved.
    pub proved: bool,
}
