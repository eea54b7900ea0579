//! The trajectory: JSON Lines.

use std::path::{Path, PathBuf};

use serde_json::{Value, json};
use vc_graph::NodeId;
use vc_planner::Summary;
use vc_tasks::Task;

use super::{RecordError, at};
use crate::{Environment, JsonLines};

/// The file of a trajectory until it is whole, and then.
pub(super) const FILES: [&str; 2] = ["trajectory.jsonl.part", "trajectory.jsonl"];

/// A line about the run, one for each action, and the result.
pub(super) struct Trajectory {
    lines: JsonLines,
    /// Where it is until it is whole, and then.
    paths: [PathBuf; 2],
}

impl Trajectory {
    pub(super) fn begin(folder: &Path, home: &Environment, agent: NodeId, task: &Task) -> Result<Self, RecordError> {
        let paths = FILES.map(|name| folder.join(name));
        let mut all = Self { lines: JsonLines::create(&paths[0])?, paths };
        all.line(&json!({
            "scene": home.graph().name(), "digest": home.digest().to_string(),
            "agent": home.graph().label(agent).to_string(), "task": task.title, "goal": task.goal,
        }))?;
        Ok(all)
    }

    /// An action that was done, or refused, in a round with its number, and what is known of the agent after it.
    pub(super) fn step(
        &mut self,
        home: &Environment,
        agent: NodeId,
        action: &str,
        (round, time): (usize, f64),
        refused: Option<&str>,
    ) -> Result<(), RecordError> {
        let graph = home.graph();
        let pose = graph.node(agent).and_then(|n| n.pose());
        let at = pose.map(|p| [p.translation.x, p.translation.y, p.translation.z]);
        let label = |id: NodeId| graph.label(id).to_string();
        let held: Vec<String> = graph.held(agent).map(label).collect();
        self.line(&json!({
            "round": round, "step": home.history().events().len(), "time": time, "agent": label(agent), "action": action,
            "refused": refused, "at": at, "room": graph.room_of(agent).map(label), "held": held,
            "digest": home.digest().to_string(),
        }))
    }

    /// A scene was put in force.
    pub(super) fn reset(&mut self, home: &Environment) -> Result<(), RecordError> {
        self.line(&json!({ "reset": home.graph().name(), "digest": home.digest().to_string() }))
    }

    pub(super) fn end(&mut self, summary: &Summary) -> Result<(), RecordError> {
        self.line(&json!(summary))?;
        let [part, whole] = &self.paths;
        std::fs::rename(part, whole).map_err(at(whole))
    }

    /// Each line is on the disk before the next action.
    fn line(&mut self, value: &Value) -> Result<(), RecordError> {
        Ok(self.lines.push(value)?)
    }
}
