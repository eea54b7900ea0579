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
        }
    }
}

/// Why a goal cannot be reached.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Unreachable {
    /// The scene lacks what a part of the goal is about.
    #[error("nothing in this scene can satisfy `{0}`")]
    NoInstance(String),
    /// No sequence of actions that was tried brings a part about.
    #[error("no actions were found that bring about any of: {0}")]
    NoPlan(String),
    /// What has been done cannot be undone.
    #[error("`{0}` has been done and cannot be undone")]
    Irrevocable(String),
    /// Every place has been searched more than once.
    #[error("everything has been searched {0} times and something is still missing")]
    Searched(usize),
}
