//! A policy that does the actions of a script.

use vc_graph::{Action, Observation};

use super::{EpisodeStart, Policy};
use crate::{Decision, Learned, Plan};

/// Does what is written, whatever it sees.
///
/// ```
/// use vc_graph::{Draft, SceneBuilder, Simulator};
/// use vc_planner::{ScriptedPolicy, run_episode};
/// use vc_tasks::{Outcome, Task};
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
/// let apple = scene.add_on(table, Draft::new("apple"))?;
/// let me = scene.add_in(kitchen, Draft::new("character"))?;
/// let mut world = Simulator::new(scene.build());
/// let mut script = ScriptedPolicy::new(vec!["walk apple.3".parse()?, "grab apple.3".parse()?]);
/// let task = Task::new("fetch", "Holds(apple)".parse()?);
/// assert_eq!(run_episode(&mut script, &task, &mut world).outcome, Outcome::Won);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Default)]
pub struct ScriptedPolicy {
    script: Vec<Action>,
    next: usize,
}

impl ScriptedPolicy {
    /// A policy that does these actions in turn.
    pub fn new(script: Vec<Action>) -> Self {
        Self { script, next: 0 }
    }
}

impl Policy for ScriptedPolicy {
    fn name(&self) -> &str {
        "script"
    }

    fn begin(&mut self, _: &EpisodeStart<'_>) {
        self.next = 0;
    }

    fn see(&mut self, _: &Observation) -> Learned {
        Learned::default()
    }

    fn decide(&mut self) -> Decision {
        match self.script.get(self.next) {
            Some(&action) => {
                Decision::Act(action, Plan { actions: self.script[self.next..].to_vec(), ..Plan::default() })
            }
            None => Decision::Done,
        }
    }

    fn did(&mut self, _: &Action) {
        self.next += 1;
    }
}
