//! The clock as text: what agents are in the middle of doing, and what goes on by itself.

use std::collections::{BTreeMap, BTreeSet};

use serde::{Deserialize, Serialize};
use vc_graph::clock::Running;
use vc_graph::format::native;
use vc_graph::hash::Digester;
use vc_graph::{Action, Change, ChangeSet, NodeId};
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
    running: BTreeMap<NodeId, Schedule>,
    truths: BTreeMap<NodeId, SavedTruth>,
    rest: RestProgress,
    stirred: bool,
    changed: Vec<NodeId>,
    unseen: bool,
    journal: Vec<Change>,
    processes: Running,
    noticed: bool,
    touched: Vec<NodeId>,
    carried: Option<BTreeSet<NodeId>>,
    positions: Vec<(NodeId, u32, f32)>,
    #[serde(default, skip_serializing_if = "Controls::is_empty")]
    controls: Controls,
}

/// A [`Truth`], its scenes as text.
#[derive(Serialize, Deserialize)]
struct SavedTruth {
    before: String,
    ruled: String,
    changes: Vec<Change>,
    next: u32,
    met: Vec<NodeId>,
    excused: Vec<NodeId>,
    put_back: bool,
}

impl SavedTruth {
    fn new(truth: &Truth) -> Self {
        let (before, ruled) = (native::write(&truth.before), native::write(&truth.ruled));
        let (met, excused, changes) = (truth.met.clone(), truth.excused.clone(), readable(&truth.changes));
        Self { before, ruled, changes, next: truth.before.next_number(), met, excused, put_back: truth.put_back }
    }
}

/// The changes that can be read back. A folded cloth is another node in the journal, which needs the class table; the
/// scene has it as it is now.
fn readable(changes: &ChangeSet) -> Vec<Change> {
    let is_node = |change: &&Change| matches!(change, Change::Add(_) | Change::Remove(_));
    changes.changes().iter().filter(|change| !is_node(change)).cloned().collect()
}

impl Environment {
    pub(in crate::environment) fn saved_clock(&self) -> Result<String, SaveError> {
        let (clock, evidence) = (self.clock.clone(), self.relations.evidence());
        let truth = |(agent, schedule): (&NodeId, &Schedule)| Some((*agent, SavedTruth::new(schedule.truth.as_ref()?)));
        let saved = SavedClock {
            zero: clock.zero,
            truths: clock.running.iter().filter_map(truth).collect(),
            given: clock.given,
            running: clock.running,
            rest: clock.rest,
            stirred: clock.stirred,
            changed: clock.changed,
            unseen: clock.unseen,
            journal: readable(&clock.journal),
            processes: clock.processes,
            noticed: clock.noticed,
            touched: clock.touched,
            carried: evidence.carried.clone(),
            positions: evidence.positions.iter().map(|((id, joint), at)| (*id, *joint, *at)).collect(),
            controls: clock.controls,
        };
        serde_json::to_string(&saved).map_err(|e| SaveError::Clock(e.to_string()))
    }

    /// Goes on with a saved clock; the scene and the bodies have been restored.
    pub(in crate::environment) fn restore_clock(&mut self, text: &str) -> Result<(), SaveError> {
        let mut saved: SavedClock = serde_json::from_str(text).map_err(|e| SaveError::Clock(e.to_string()))?;
        for (agent, truth) in saved.truths {
            let SavedTruth { before, ruled, changes, next, met, excused, put_back } = truth;
            let (before, ruled) = (self.read_scene(&before, next)?, self.read_scene(&ruled, next)?);
            if let Some(schedule) = saved.running.get_mut(&agent) {
                let changes = changes.into_iter().collect();
                schedule.truth = Some(Truth { before, ruled, changes, met, excused, put_back });
            }
        }
        let positions = saved.positions.into_iter().map(|(id, joint, at)| ((id, joint), at)).collect();
        self.relations
            .set_evidence(&self.graph, Evidence { carried: saved.carried, positions, ..Evidence::default() })?;
        self.clock = Clock {
            zero: saved.zero,
            given: saved.given,
            running: saved.running,
            rest: saved.rest,
            stirred: saved.stirred,
            changed: saved.changed,
            unseen: saved.unseen,
            endings: Vec::new(),
            journal: saved.journal.into_iter().collect(),
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
