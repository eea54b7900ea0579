//! Why a state is not saved or restored.

use vc_graph::{ChangeMismatch, EditError, Label};
use vc_physics::RestError;
use vc_relations::InputError;

use crate::environment::PhysicalRefusal;
use crate::environment::error::in_a_row;

/// Why an environment's state was not saved, or not restored. The environment goes on as before.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum StateError {
    /// Agents act or are under control.
    #[error(
        "{} at it still, and a state is of an environment at rest: `interrupt` ends actions and control, `step_until_idle` waits for actions",
        busy(.0)
    )]
    Busy(Vec<Label>),
    /// Endings of actions have not been asked for, and would be lost.
    #[error("{0} endings of actions have not been read: `step(Span(0))` returns them")]
    Unread(usize),
    /// Bodies move, or are such that records do not know them.
    #[error("{0}; `save` keeps such an environment, and things that move come to rest by `step`")]
    Bodies(#[from] RestError<Label>),
    /// The state is of an environment that began otherwise.
    #[error(
        "the state is of another environment: restore it in the one that it was saved in, or in a clone of that one; `save` writes one for others"
    )]
    OtherStart,
    /// The scene came by `reset` and is another one than at the start.
    #[error(
        "the scene has another name, other classes or other numbers than at the start: make an environment of it, and search in that"
    )]
    OtherScene,
    /// The scene of the state does not follow from the start.
    #[error("the scene: {0}")]
    Scene(#[from] ChangeMismatch),
    /// The bodies' places cannot be written into the scene.
    #[error(transparent)]
    Edit(#[from] EditError),
    /// The bodies' places cannot be read.
    #[error(transparent)]
    Poses(#[from] PhysicalRefusal),
    /// The scene's geometry cannot be read.
    #[error(transparent)]
    Relations(#[from] InputError),
}

fn busy(labels: &[Label]) -> String {
    format!("{} {}", in_a_row(labels), if labels.len() == 1 { "is" } else { "are" })
}
