//! Subgoals, and the reasons why a goal may be unreachable.

use vc_graph::{Action, Condition, NodeId, Word};

/// A condition to be brought about.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum OpenCondition {
    /// A condition on the scene.
    Hold(Condition),
    /// An action that has to be done.
    Do(Action),
    /// A thing to be seen: the goal seems to hold of it, but only by a guess.
    See(NodeId),
    /// A container to be looked into: it may contain something that the goal forbids.
    LookInto(NodeId),
}

impl OpenCondition {
    /// Whether it is only an observation.
    pub(crate) fn is_observation(&self) -> bool {
        matches!(self, Self::See(_) | Self::LookInto(_))
    }
}

/// One open part of a goal; any of its options settles it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Subgoal {
    /// The options, cheapest first.
    pub(crate) options: Vec<OpenCondition>,
}

impl std::fmt::Display for OpenCondition {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Hold(Condition::Related(from, relation, to)) => write!(f, "{from} {} {to}", relation.as_str()),
            Self::Hold(condition) => write!(f, "{condition:?}"),
            Self::Do(action) => write!(f, "{action}"),
            Self::See(id) => write!(f, "see {id}"),
            Self::LookInto(id) => write!(f, "look into {id}"),
        }
    }
}

/// The reason why a goal cannot be reached. Running out of steps is not such a reason: it is an
/// [`Outcome`](vc_tasks::Outcome).
///
/// ```
/// use vc_graph::{Draft, SceneBuilder};
/// use vc_planner::{Planner, Unreachable};
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
/// let apple = scene.add_on(table, Draft::new("apple"))?;
/// let me = scene.add_in(kitchen, Draft::new("character"))?;
/// let mut graph = scene.build();
/// let goal = "On(mug, kitchen_table)".parse()?;
/// let why = Planner::default().plan(&mut graph, me, &goal, &[]).unwrap_err();
/// assert!(matches!(why, Unreachable::NoInstance(_)), "{why}");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Unreachable {
    /// A label in the goal names a class that differs from that of its node.
    #[error(transparent)]
    NameMismatch(#[from] vc_graph::NameMismatch),
    /// The scene lacks the things that a part of the goal is about.
    #[error("nothing in this scene can satisfy `{0}`")]
    NoInstance(String),
    /// The thing that would have to be moved cannot be picked up.
    #[error("`{0}`: nothing it is about can be picked up")]
    NotGraspable(String),
    /// Nothing can be put on the thing that a part of the goal names.
    #[error("`{0}`: nothing can be put on that")]
    NotASurface(String),
    /// Nothing can be put in the thing that a part of the goal names.
    #[error("`{0}`: nothing can be put in that")]
    NotAContainer(String),
    /// The thing that a part of the goal names cannot be opened.
    #[error("`{0}`: it does not open")]
    NotOpenable(String),
    /// The thing that a part of the goal names has no switch.
    #[error("`{0}`: it has no switch")]
    NotSwitchable(String),
    /// The action cannot be done to the thing that a part of the goal names.
    #[error("`{0}`: that cannot be done to it")]
    NotAfforded(String),
    /// A thing is in no room, so it cannot be reached.
    #[error("`{0}`: the things it is about are in no room and cannot be reached")]
    NoRoute(String),
    /// The parts of the goal need the same things, or undo each other.
    #[error("`{0}`: its parts conflict, with each other or with the rest of the goal")]
    Conflicting(String),
    /// All things that could serve are in containers that do not open.
    #[error("`{0}`: the things it is about are in containers that do not open")]
    Sealed(String),
    /// Other agents hold or wear the needed things.
    #[error("`{0}`: other agents hold the things it is about")]
    HeldByAnother(String),
    /// The search covered every relevant state.
    #[error("all {checked} states that matter were looked at, and `{goal}` holds in none")]
    SearchExhausted {
        /// The goal.
        goal: String,
        /// The number of states.
        checked: usize,
    },
    /// None of the action sequences tried brings a part about.
    #[error("no actions were found that bring about any of: {0}")]
    NoPlan(String),
    /// A past action cannot be undone.
    #[error("`{0}` has been done and cannot be undone")]
    Irrevocable(String),
    /// A part of the goal no longer holds, whatever is done from now on.
    #[error("{}", vc_tasks::Lost::Broken(.0.clone()))]
    Broken(String),
    /// Every way that was found breaks a part of the goal that must hold on the way.
    #[error("no way to `{goal}` was found that keeps `{part}`: `{action}` breaks it")]
    Breaks {
        /// The goal to be reached.
        goal: String,
        /// The part that would be broken.
        part: String,
        /// The action that would break it.
        action: String,
    },
    /// A part of the goal is reached only after its last step.
    #[error("`{part}`: the shortest way that was found reaches it at step {steps}, which is too late")]
    TooLate {
        /// The part.
        part: String,
        /// The step at which it would be reached.
        steps: usize,
    },
    /// Words of time stand in each other in a way that no agent here plans for.
    #[error(
        "`{0}`: the planner does not plan for words of time that stand in each other so; judge it with another policy"
    )]
    Beyond(String),
    /// A language model gave no usable answer.
    #[error("no usable answer: {0}")]
    NoAnswer(String),
    /// A missing thing can be nowhere: there are no rooms and no supports or containers.
    #[error("`{0}` is out of sight, and this scene has no room and no place where it could be")]
    Nowhere(String),
    /// A necessary action is refused repeatedly.
    #[error("`{0}` is refused whenever it is tried, and there is no other way")]
    Refused(String),
    /// Every place has been searched.
    #[error("everything has been searched {0} times and something is still missing")]
    Searched(usize),
}
