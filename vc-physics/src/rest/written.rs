//! Records of rest as bytes.

use rapier3d::math::{Pose as EnginePose, Rotation, Vector};
use serde::{Deserialize, Serialize};
use vc_graph::{NodeId, SceneGraph};

use super::recorded::{RecordedThing, RestRecord};
use crate::shapes::ShapeCache;
use crate::state::{Agent, Places, Thing, ThingState, Waters};
use crate::{SnapshotError, convert};

/// The content of a record. Forms are those of the scene.
#[derive(Serialize, Deserialize)]
struct Content {
    things: Vec<(NodeId, ThingState, Vec<[f32; 7]>)>,
    removed: Vec<NodeId>,
    agents: Vec<(NodeId, Agent)>,
    waters: Waters,
    ticks: u64,
    stopped: Vec<NodeId>,
    skipped: Vec<NodeId>,
}

impl RestRecord {
    /// The record as bytes, for [`read`](Self::read): about 150 for each thing that is not where it was at the start.
    ///
    /// # Errors
    /// [`SnapshotError::Unwritable`].
    pub fn write(&self) -> Result<Vec<u8>, SnapshotError> {
        let thing = |recorded: &RecordedThing| {
            let poses = recorded.poses.iter().map(numbers).collect();
            (recorded.thing.id, recorded.thing.state.clone(), poses)
        };
        let content = Content {
            things: self.things.iter().map(thing).collect(),
            removed: self.removed.clone(),
            agents: self.agents.to_vec(),
            waters: self.waters.clone(),
            ticks: self.ticks,
            stopped: self.stopped.clone(),
            skipped: self.skipped.clone(),
        };
        postcard::to_allocvec(&content).map_err(|why| SnapshotError::Unwritable(why.to_string()))
    }

    /// Reads a record of things of a scene. The same holds of forged bytes as for
    /// [`PhysicsWorld::restore`](crate::PhysicsWorld::restore).
    ///
    /// # Errors
    /// [`SnapshotError::Damaged`], [`SnapshotError::OtherScene`].
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// use vc_physics::{RestRecord, ShapeCache};
    /// world.settle(300);
    /// let start = world.clone();
    /// world.place(home.cup, vc_graph::Pose::translation(0.8, 0.3, 0.741))?;
    /// world.settle(300);
    /// let bytes = world.record(&start)?.write()?;
    /// assert!(bytes.len() < 400, "a cup, and somebody who stands there: {}", bytes.len());
    /// let other = start.recorded(&RestRecord::read(&bytes, &home.graph, &ShapeCache::new())?)?;
    /// assert_eq!(other.digest(), world.digest());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn read(bytes: &[u8], graph: &SceneGraph, shapes: &ShapeCache) -> Result<Self, SnapshotError> {
        let content: Content = postcard::from_bytes(bytes).map_err(|_| SnapshotError::Damaged)?;
        let other = |id: NodeId| SnapshotError::OtherScene(graph.label(id));
        let things = shapes.session(graph.assets(), |session| {
            let form = |(id, state, poses): (NodeId, ThingState, Vec<[f32; 7]>)| {
                let node = graph.node(id).ok_or_else(|| other(id))?;
                let form = session.form(graph, node).filter(|form| form.links.len() == state.moving.len() + 1);
                let poses: Vec<EnginePose> = poses.into_iter().map(pose).collect();
                if poses.is_empty() || !poses.iter().all(|pose| convert::is_sound(&convert::isometry(pose))) {
                    return Err(SnapshotError::Damaged);
                }
                let thing = Thing { id, form: form.ok_or_else(|| other(id))?, places: Places::new(node), state };
                Ok(RecordedThing { thing, poses })
            };
            content.things.into_iter().map(form).collect::<Result<Vec<RecordedThing>, SnapshotError>>()
        })?;
        Ok(Self {
            things,
            removed: content.removed,
            agents: content.agents.into(),
            waters: content.waters,
            ticks: content.ticks,
            stopped: content.stopped,
            skipped: content.skipped,
        })
    }
}

fn numbers(pose: &EnginePose) -> [f32; 7] {
    let ([x, y, z], [i, j, k, w]) = (pose.translation.to_array(), pose.rotation.to_array());
    [x, y, z, i, j, k, w]
}

/// The rotation is not normalised, so that its bits stay the same.
fn pose([x, y, z, i, j, k, w]: [f32; 7]) -> EnginePose {
    EnginePose::from_parts(Vector::new(x, y, z), Rotation::from_array([i, j, k, w]))
}
