//! The interface that tasks need of an environment.

use std::error::Error;
use std::fmt;
use std::sync::Arc;

use vc_graph::goal::Situation;
use vc_graph::{Action, ChangeSet, History, NodeId, Refusal, SceneGraph, Simulator};

/// A place where agents act: the symbolic [`Simulator`], or an environment with
/// bodies.
///
/// It is object-safe: policies, runners and the makers of initial environments take
/// `&mut dyn World`.
///
/// ```
/// use vc_graph::{Draft, SceneBuilder, Simulator};
/// use vc_tasks::World;
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let apple = scene.add_in(kitchen, Draft::new("apple"))?;
/// let me = scene.add_in(kitchen, Draft::new("character"))?;
/// let graph = scene.build();
///
/// let mut simulator = Simulator::new(graph.clone());
/// let world: &mut dyn World = &mut simulator;
/// world.step(me, &format!("walk apple.{}", apple.0).parse()?)?;
/// world.reset(&graph)?;
/// assert_eq!(world.graph(), &graph);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub trait World {
    /// The scene as it is.
    fn graph(&self) -> &SceneGraph;

    /// The history of the actions executed since the last reset.
    fn history(&self) -> &History;

    /// The present state and the history, as goals of an agent are judged on.
    fn situation(&self, agent: NodeId) -> Situation<'_> {
        Situation::new(self.graph(), agent, self.history())
    }

    /// Executes an agent's action.
    ///
    /// # Errors
    /// [`WorldError::Refused`] with every reason why the agent cannot do it; [`WorldError::Failed`]
    /// if executing it went wrong in the world. After a refusal nothing has changed.
    fn step(&mut self, agent: NodeId, action: &Action) -> Result<ChangeSet, WorldError>;

    /// Executes the actions of several agents, each to its end; the outcomes are in their order. A world with a
    /// [clock](World::has_clock) does them side by side, others one after the other.
    fn step_together(&mut self, actions: &[(NodeId, Action)]) -> Vec<Result<ChangeSet, WorldError>> {
        actions.iter().map(|(agent, action)| self.step(*agent, action)).collect()
    }

    /// Whether actions take time in this world, so that several agents act at the same time.
    fn has_clock(&self) -> bool {
        false
    }

    /// Replaces the world's scene and clears the history.
    ///
    /// A world with bodies lets them come to rest, so that [`World::graph`] may afterwards differ
    /// from the scene given.
    ///
    /// # Errors
    /// [`WorldError::Failed`] if the world cannot take the scene; then nothing has changed.
    fn reset(&mut self, graph: &SceneGraph) -> Result<(), WorldError>;
}

/// The reason why a world did not execute a request.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum WorldError {
    /// The transition rules forbid the action, for these reasons.
    #[error("refused: {}", listed(.0))]
    Refused(Vec<Refusal>),
    /// The world could not do what the rules allow.
    #[error(transparent)]
    Failed(#[from] WorldFailure),
}

impl WorldError {
    /// A failure of a world, for the given reason.
    ///
    /// ```
    /// use vc_graph::EditError;
    /// use vc_tasks::WorldError;
    /// let error = WorldError::failed(EditError::NumbersExhausted);
    /// assert_eq!(error.to_string(), "all node numbers are used up");
    /// let WorldError::Failed(failure) = error else { return };
    /// assert_eq!(failure.downcast_ref(), Some(&EditError::NumbersExhausted));
    /// ```
    pub fn failed(reason: impl Into<Box<dyn Error + Send + Sync>>) -> Self {
        Self::Failed(WorldFailure(Arc::from(reason.into())))
    }
}

/// The reason why a world failed: an error of the world's own type, such as one of the physics engine.
///
/// It is displayed as that error, and its source is that of the error. Two failures are equal if they read the same.
#[derive(Debug, Clone)]
pub struct WorldFailure(Arc<dyn Error + Send + Sync>);

impl WorldFailure {
    /// The world's error, if it is of type `E`.
    pub fn downcast_ref<E: Error + 'static>(&self) -> Option<&E> {
        self.0.downcast_ref()
    }
}

impl From<&str> for WorldFailure {
    fn from(reason: &str) -> Self {
        Self(Arc::from(<Box<dyn Error + Send + Sync>>::from(reason)))
    }
}

impl fmt::Display for WorldFailure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl Error for WorldFailure {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        self.0.source()
    }
}

impl PartialEq for WorldFailure {
    fn eq(&self, other: &Self) -> bool {
        self.to_string() == other.to_string()
    }
}

fn listed(refusals: &[Refusal]) -> String {
    refusals.iter().map(Refusal::to_string).collect::<Vec<_>>().join("; ")
}

impl World for Simulator {
    fn graph(&self) -> &SceneGraph {
        Simulator::graph(self)
    }

    fn history(&self) -> &History {
        Simulator::history(self)
    }

    fn step(&mut self, agent: NodeId, action: &Action) -> Result<ChangeSet, WorldError> {
        Simulator::step(self, agent, action).map_err(WorldError::Refused)
    }

    fn reset(&mut self, graph: &SceneGraph) -> Result<(), WorldError> {
        *self = Simulator::with(graph.clone(), self.semantics());
        Ok(())
    }
}
