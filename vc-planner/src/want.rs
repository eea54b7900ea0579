//! What there is to bring about, and why it may not be possible.

use vc_graph::{Action, Condition, NodeId, Word};

/// Something to bring about.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Want {
    /// A condition on the scene.
    Hold(Condition),
    /// An action to have been done.
    Do(Action),
    /// A thing to be seen: the goal seems to hold of it, but only by guess.
    See(NodeId),
    /// A container to be looked into: there may be something the goal forbids.
    LookInto(NodeId),
}

impl Want {
    /// Whether it is only to see what is so.
    pub(crate) fn is_look(&self) -> bool {
        matches!(self, Self::See(_) | Self::LookInto(_))
    }
}

/// One open part of a goal: any of its options settles it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Subgoal {
    /// What settles it, cheapest first.
    pub options: Vec<Want>,
}

impl std::fmt::Display for Want {
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

/// Why a goal cannot be reached. Running out of steps is no such reason: it is an
/// [`Outcome`](vc_tasks::Outcome).
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Unreachable {
    /// A label of the goal is of another class than its node.
    #[error(transparent)]
    Misnomer(#[from] vc_graph::Misnomer),
    /// The scene lacks what a part of the goal is about.
    #[error("nothing in this scene can satisfy `{0}`")]
    NoInstance(String),
    /// What would have to be moved cannot be picked up.
    #[error("`{0}`: nothing it is about can be picked up")]
    NotGraspable(String),
    /// Nothing can be put on what a part of the goal names.
    #[error("`{0}`: nothing can be put on that")]
    NotASurface(String),
    /// Nothing can be put in what a part of the goal names.
    #[error("`{0}`: nothing can be put in that")]
    NotAContainer(String),
    /// What a part of the goal names does not open.
    #[error("`{0}`: it does not open")]
    NotOpenable(String),
    /// What a part of the goal names has no switch.
    #[error("`{0}`: it has no switch")]
    NotSwitchable(String),
    /// That cannot be done to what a part of the goal names.
    #[error("`{0}`: that cannot be done to it")]
    NotAfforded(String),
    /// A thing is in no room: one cannot go there.
    #[error("`{0}`: there is no way there")]
    NoRoute(String),
    /// The parts of the goal need the same things, or each undoes another.
    #[error("`{0}`: its parts conflict, with each other or with the rest of the goal")]
    Conflicting(String),
    /// All that could serve is shut in something that does not open.
    #[error("`{0}`: what it is about is shut in and cannot be got out")]
    Sealed(String),
    /// Others have in their hands what is needed, or wear it.
    #[error("`{0}`: others hold what it is about")]
    HeldByAnother(String),
    /// Every state that matters was looked at.
    #[error("all {checked} states that matter were looked at, and `{goal}` holds in none")]
    SearchExhausted {
        /// The goal.
        goal: String,
        /// How many states.
        checked: usize,
    },
    /// No sequence of actions that was tried brings a part about.
    #[error("no actions were found that bring about any of: {0}")]
    NoPlan(String),
    /// What has been done cannot be undone.
    #[error("`{0}` has been done and cannot be undone")]
    Irrevocable(String),
    /// A part of the goal no longer holds, whatever is done from now on.
    #[error("`{0}` does not hold any more, and nothing that is done can change that")]
    Broken(String),
    /// Every way that was found breaks a part of the goal that must hold on the way.
    #[error("no way to `{goal}` was found that keeps `{part}`: `{action}` breaks it")]
    Breaks {
        /// What is to be reached.
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
    /// A language model gave no answer that could be used.
    #[error("no usable answer: {0}")]
    NoAnswer(String),
    /// A missing thing can be nowhere: there are no rooms and nothing that holds or carries.
    #[error("`{0}` is out of sight, and this scene has no room and no place where it could be")]
    Nowhere(String),
    /// An action without which there is no way is refused again and again.
    #[error("`{0}` is refused whenever it is tried, and there is no other way")]
    Refused(String),
    /// Every place has been searched.
    #[error("everything has been searched {0} times and something is still missing")]
    Searched(usize),
}
