//! The clock as text: what agents are in the middle of doing, and what goes on by itself.

use std::collections::{BTreeMap, BTreeSet};

use serde::{Deserialize, Serialize};
use vc_graph::clock::Running;
use vc_graph::format::native;
use vc_graph::hash::Digester;
use vc_graph::{Action, ChangeSet, NodeId, ObjectNames, SceneGraph};
use vc_physics::RestProgress;
use vc_relations::Evidence;

use super::Clock;
use super::schedule::{Schedule, Truth};
use crate::environment::control::Controls;
use crate::environment::{Environment, SaveError};

/// All of a clock but its endings, and the evidence with which relations were read last.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct SavedClock {
    zero: u64,
    given: BTreeMap<NodeId, Action>,
    /// The names by which these actions call their things: they are checked when the actions begin.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    called: BTreeMap<NodeId, ObjectNames>,
    running: BTreeMap<NodeId, Schedule>,
    truths: BTreeMap<NodeId, SavedTruth>,
    rest: RestProgress,
    stirred: bool,
    changed: Vec<NodeId>,
    unseen: bool,
    #[serde(default, skip_serializing_if = "BTreeSet::is_empty")]
    adrift: BTreeSet<NodeId>,
    read: Option<String>,
    journal: String,
    processes: Running,
    noticed: bool,
    touched: Vec<NodeId>,
    carried: Option<BTreeSet<NodeId>>,
    positions: Vec<(NodeId, u32, f32)>,
    #[serde(default, skip_serializing_if = "Controls::is_empty")]
    controls: Controls,
}

/// A [`Truth`]. A change set is text, as it takes the class table to read one; a scene is the changes that lead to it
/// from the present one.
#[derive(Serialize, Deserialize)]
struct SavedTruth {
    before: String,
    ruled: String,
    changes: String,
    met: Vec<NodeId>,
    excused: Vec<NodeId>,
    put_back: bool,
    moved: Option<(NodeId, NodeId)>,
}

fn json<T: Serialize>(value: &T) -> Result<String, SaveError> {
    serde_json::to_string(value).map_err(SaveError::Clock)
}

impl Environment {
    pub(in crate::environment) fn saved_clock(&self) -> Result<String, SaveError> {
        let (clock, evidence) = (self.clock.clone(), self.relations.evidence());
        let truths = clock.running.iter().filter_map(|(agent, schedule)| Some((*agent, schedule.truth.as_ref()?)));
        let truths = truths.map(|(agent, truth)| Ok((agent, self.saved_truth(truth)?)));
        let saved = SavedClock {
            zero: clock.zero,
            truths: truths.collect::<Result<_, SaveError>>()?,
            called: clock.given.iter().map(|(agent, action)| (*agent, action.called)).collect(),
            given: clock.given,
            running: clock.running,
            rest: clock.rest,
            stirred: clock.stirred,
            changed: clock.changed,
            unseen: clock.unseen,
            adrift: clock.adrift,
            read: clock.read.as_ref().map(|read| self.saved_scene(read)).transpose()?,
            journal: json(&clock.journal)?,
            processes: clock.processes,
            noticed: clock.noticed,
            touched: clock.touched,
            carried: evidence.carried.clone(),
            positions: evidence.positions.iter().map(|((id, joint), at)| (*id, *joint, *at)).collect(),
            controls: clock.controls,
        };
        json(&saved)
    }

    fn saved_truth(&self, truth: &Truth) -> Result<SavedTruth, SaveError> {
        let (before, ruled) = (self.saved_scene(&truth.before)?, self.saved_scene(&truth.ruled)?);
        let (met, excused) = (truth.met.clone(), truth.excused.clone());
        let (put_back, moved) = (truth.put_back, truth.moved);
        Ok(SavedTruth { before, ruled, changes: json(&truth.changes)?, met, excused, put_back, moved })
    }

    fn restored_truth(&self, saved: SavedTruth) -> Result<Truth, SaveError> {
        let (before, ruled) = (self.restored_scene(&saved.before)?, self.restored_scene(&saved.ruled)?);
        let changes = self.restored_changes(&saved.changes)?;
        let SavedTruth { met, excused, put_back, moved, .. } = saved;
        Ok(Truth { before, ruled, changes, met, excused, put_back, moved })
    }

    /// Another scene, by its difference from the present one.
    fn saved_scene(&self, scene: &SceneGraph) -> Result<String, SaveError> {
        json(&ChangeSet::between(&self.graph, scene))
    }

    fn restored_scene(&self, text: &str) -> Result<SceneGraph, SaveError> {
        let mut scene = self.graph.clone();
        self.restored_changes(text)?.apply(&mut scene).map_err(SaveError::Remembered)?;
        Ok(scene)
    }

    fn restored_changes(&self, text: &str) -> Result<ChangeSet, SaveError> {
        Ok(native::read_changes(text, self.graph.classes())?)
    }

    /// Goes on with a saved clock; the scene and the bodies have been restored.
    pub(in crate::environment) fn restore_clock(&mut self, text: &str) -> Result<(), SaveError> {
        let mut saved: SavedClock = serde_json::from_str(text).map_err(SaveError::Clock)?;
        for (agent, truth) in saved.truths {
            let truth = self.restored_truth(truth)?;
            if let Some(schedule) = saved.running.get_mut(&agent) {
                schedule.truth = Some(truth);
            }
        }
        for (agent, called) in saved.called {
            if let Some(action) = saved.given.get_mut(&agent) {
                action.called = called;
            }
        }
        let positions = saved.positions.into_iter().map(|(id, joint, at)| ((id, joint), at)).collect();
        let evidence = Evidence { carried: saved.carried, positions, ..Evidence::default() };
        let read = saved.read.map(|text| self.restored_scene(&text)).transpose()?;
        let seen = read.as_ref().unwrap_or(&self.graph);
        self.relations.rebuild(seen)?;
        self.relations.set_evidence(seen, evidence)?;
        self.clock = Clock {
            zero: saved.zero,
            given: saved.given,
            running: saved.running,
            rest: saved.rest,
            stirred: saved.stirred,
            changed: saved.changed,
            unseen: saved.unseen,
            held: Vec::new(),
            adrift: saved.adrift,
            endings: Vec::new(),
            read,
            journal: self.restored_changes(&saved.journal)?,
            processes: saved.processes,
            noticed: saved.noticed,
            touched: saved.touched,
            controls: saved.controls,
        };
        Ok(())
    }

    /// Adds to a digest what is going on.
    pub(in crate::environment) fn digest_clock(&self, hash: &mut Digester) {
        for since in self.processes() {
            hash.word(u64::from(since.node.0)).words(since.process.bytes().map(u64::from));
            hash.words([since.begin.0, since.after.0]);
        }
        if self.is_busy() || !self.clock.controls.is_empty() {
            // It is plain data, so it can be written.
            hash.words(self.saved_clock().unwrap_or_default().bytes().map(u64::from));
        }
    }
}
