//! Batches of environments, stepped on all cores.

use rayon::prelude::*;
use vc_graph::{Action, ChangeSet, NodeId, Observation};

use crate::environment::{ActionError, Environment, MakeError};

/// Environments that are stepped side by side. Each runs in one thread at a time, so outcomes do not depend on
/// the number of threads or on which finishes first.
///
/// ```no_run
/// use virtualcity::Batch;
/// let mut batch = Batch::make((0..16).map(|seed| format!("apartment/{seed}")), 1)?;
/// let everybody: Vec<_> = batch.environments().iter().map(|e| e.agents()[0]).collect();
/// let dance = "dance".parse()?;
/// let actions: Vec<_> = everybody.iter().map(|agent| vec![(*agent, dance)]).collect();
/// let outcomes = batch.set_actions(&actions);
/// assert!(outcomes.iter().flatten().all(Result::is_ok));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct Batch {
    environments: Vec<Environment>,
}

impl Batch {
    /// Makes environments by name, each as [`Environment::make`] makes it.
    ///
    /// # Errors
    /// [`MakeError`] of the first environment that cannot be made.
    pub fn make(names: impl IntoIterator<Item = String>, agents: usize) -> Result<Self, MakeError> {
        let names: Vec<String> = names.into_iter().collect();
        let made: Vec<_> = names.par_iter().map(|name| Environment::make(name, agents)).collect();
        Ok(Self { environments: made.into_iter().collect::<Result<_, _>>()? })
    }

    /// A batch of existing environments. Clones of one environment share its constant data.
    pub fn new(environments: Vec<Environment>) -> Self {
        Self { environments }
    }

    /// The environments.
    pub fn environments(&self) -> &[Environment] {
        &self.environments
    }

    /// The environments, mutable.
    pub fn environments_mut(&mut self) -> &mut [Environment] {
        &mut self.environments
    }

    /// Applies a list of actions to each environment: `Environment::set_actions` in all of them at once.
    /// Environments without a list do nothing. The outcomes are in the order of the lists; the actions of a list for
    /// which there is no environment are refused with [`ActionError::NoEnvironment`].
    pub fn set_actions(&mut self, actions: &[Vec<(NodeId, Action)>]) -> Vec<Vec<Result<ChangeSet, ActionError>>> {
        let of = self.environments.len();
        let pairs = self.environments.par_iter_mut().zip(actions);
        let mut outcomes: Vec<_> = pairs.map(|(environment, actions)| environment.set_actions(actions)).collect();
        let nobody =
            |index: usize| actions[index].iter().map(|_| Err(ActionError::NoEnvironment { index, of })).collect();
        outcomes.extend((of..actions.len()).map(nobody));
        outcomes
    }

    /// The room observation of one agent in each environment: `Environment::room_observation`. There are as many as
    /// there are both agents and environments.
    pub fn room_observations(&self, agents: &[NodeId]) -> Vec<Observation> {
        let pairs = self.environments.par_iter().zip(agents);
        pairs.map(|(environment, agent)| environment.room_observation(*agent)).collect()
    }
}
