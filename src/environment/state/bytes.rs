//! Environments at rest as bytes: what differs from their start, and nothing of the engine.

use std::sync::Arc;

use vc_graph::format::native;
use vc_graph::{AssetLibrary, Change, ChangeSet, Edge, NodeId, Place, SceneBuilder, SceneGraph};
use vc_physics::{Floor, PhysicsWorld, RestRecord, SnapshotError};
use vc_relations::Relations;

use super::StateError;
use super::waking::read;
use crate::environment::{Environment, SaveError, Start, observe};
use crate::parts::{self, Magic};

/// The bytes with which environments at rest begin.
const MAGIC: &Magic = b"VCREST1\n";

/// Why an environment at rest is not written.
#[derive(Debug, thiserror::Error)]
pub(crate) enum RestFault {
    #[error(transparent)]
    State(#[from] StateError),
    #[error(transparent)]
    Save(#[from] SaveError),
    #[error(transparent)]
    Record(#[from] SnapshotError),
    #[error(transparent)]
    Json(#[from] serde_json::Error),
}

impl Environment {
    /// The state of this environment, which is at rest, as bytes for [`restore_rest`](Self::restore_rest). From then on it evolves
    /// as all that are read from them, as by [`save_state`](Self::save_state).
    pub(crate) fn save_rest(&mut self) -> Result<Vec<u8>, RestFault> {
        let state = self.save_state()?;
        let is_at_its_body = |id: NodeId| self.start.time.bodies && self.world.pose(id).is_some();
        let told = told(&ChangeSet::between(&self.start.graph, &self.graph), is_at_its_body);
        let library = (self.graph.assets().clone(), self.graph.next_number());
        let again = Reread::of(&self.start, &mut self.world.clone(), (&told, library))?;
        let untold = ChangeSet::between(&again.graph, &self.graph);
        let (changes, others) = (serde_json::to_string(&told)?, serde_json::to_string(&untold)?);
        let (shapes, history, clock) = (self.own_shapes(), self.written_history(), self.saved_clock()?);
        let (cameras, next) = (self.saved_cameras().unwrap_or_default(), self.graph.next_number().to_le_bytes());
        let record = state.0.record.write()?;
        let texts = [&changes, &others, &shapes, &history, &clock, &cameras].map(|text| text.as_bytes());
        let all: Vec<&[u8]> = [next.as_slice(), &record].into_iter().chain(texts).collect();
        Ok(parts::joined(MAGIC, &all))
    }

    /// Whether bytes are those of an environment at rest.
    pub(crate) fn is_rest(bytes: &[u8]) -> bool {
        bytes.starts_with(MAGIC)
    }

    /// The environment that was written at rest; `self` has to have been made in the same way.
    pub(crate) fn restore_rest(&self, bytes: &[u8]) -> Result<Self, SaveError> {
        let parts: [&[u8]; 8] = parts::split(MAGIC, bytes)?.try_into().map_err(|_| SaveError::NotSaved)?;
        let [next, record, changes, others, shapes, history, clock, cameras] = parts;
        let text = |bytes| std::str::from_utf8(bytes).map_err(|_| SaveError::NotSaved);
        let read_changes = |bytes| Ok::<_, SaveError>(native::read_changes(text(bytes)?, self.start.graph.classes())?);
        let next = next.try_into().map(u32::from_le_bytes).map_err(|_| SaveError::NotSaved)?;
        let (told, library) = (read_changes(changes)?, (self.read_shapes(text(shapes)?)?, next));
        let known = with(&self.start.graph, &told, library.clone()).map_err(SaveError::Remembered)?;
        let record = RestRecord::read(record, &known, &self.start.shapes)?;
        let mut world = self.start.world.recorded(&record).map_err(|_| SaveError::Damaged)?;
        let again = Reread::of(&self.start, &mut world, (&told, library)).map_err(|_| SaveError::Damaged)?;
        let mut graph = again.graph;
        read_changes(others)?.apply(&mut graph).map_err(SaveError::Remembered)?;
        self.resumed((graph, world, again.relations, again.floor), [clock, cameras, history])
    }
}

/// A scene of which only that is known which geometry does not tell, its relations read anew.
struct Reread {
    graph: SceneGraph,
    relations: Relations,
    floor: Floor,
}

impl Reread {
    fn of(
        start: &Start,
        world: &mut PhysicsWorld,
        (told, library): (&ChangeSet, (Arc<AssetLibrary>, u32)),
    ) -> Result<Self, StateError> {
        let mut graph = with(&start.graph, told, library)?;
        if start.time.bodies {
            observe::write_poses(&mut graph, world)?;
        }
        let (relations, floor, met) = read(start, world, &graph)?;
        let places = |graph: &SceneGraph, id: NodeId| Some(graph.places(id).collect::<Vec<Place>>());
        relations.write_except(&mut graph, &met, places)?;
        Ok(Self { graph, relations, floor })
    }
}

/// A scene after some changes, with its shapes and the next number.
fn with(
    start: &SceneGraph,
    changes: &ChangeSet,
    (shapes, next): (Arc<AssetLibrary>, u32),
) -> Result<SceneGraph, vc_graph::ChangeMismatch> {
    let mut graph = start.clone();
    changes.apply(&mut graph)?;
    let mut builder = SceneBuilder::from_graph(graph);
    builder.assets(shapes).number_from(next);
    Ok(builder.build())
}

/// The changes that neither bodies nor geometry tell; whatever goes leaves all.
fn told(changes: &ChangeSet, is_at_its_body: impl Fn(NodeId) -> bool) -> ChangeSet {
    let gone = |change: &Change| match change {
        Change::Remove(node) => Some(node.id()),
        _ => None,
    };
    let gone: Vec<NodeId> = changes.changes().iter().filter_map(gone).collect();
    let leaves = |edge: &Edge| gone.contains(&edge.from) || gone.contains(&edge.to);
    let is_told = |change: &&Change| match change {
        Change::Link(edge) => !Relations::reads(edge.relation),
        Change::Unlink(edge) => !Relations::reads(edge.relation) || leaves(edge),
        Change::Pose { id, .. } => !is_at_its_body(*id),
        _ => true,
    };
    changes.changes().iter().filter(is_told).cloned().collect()
}
