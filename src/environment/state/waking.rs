//! Bodies that sleep in a saved state until somebody asks for them.

use std::ops::{Deref, DerefMut};
use std::sync::{Arc, OnceLock};

use vc_graph::{Change, ChangeSet, NodeId, SceneGraph};
use vc_physics::{Floor, PhysicsWorld};
use vc_relations::{InputError, Relations};

use super::{EnvironmentState, StateError};
use crate::environment::{Start, observe};

/// The bodies of an environment, the relations and the walkable floor; or the state from which they are built when they
/// are first needed.
#[derive(Clone)]
pub(in crate::environment) enum Waking<T> {
    Awake(Box<T>),
    Asleep(Arc<Sleeper>),
}

/// A saved state, its scene, and what has been built from both.
pub(in crate::environment) struct Sleeper {
    state: EnvironmentState,
    graph: SceneGraph,
    awake: OnceLock<Awake>,
}

/// All that is built from a state.
pub(in crate::environment) struct Awake {
    world: PhysicsWorld,
    relations: Relations,
    floor: Floor,
}

/// The parts that can be built from a state.
pub(in crate::environment) trait Part: Clone {
    fn of(awake: &Awake) -> &Self;
}

impl Part for PhysicsWorld {
    fn of(awake: &Awake) -> &Self {
        &awake.world
    }
}

impl Part for Relations {
    fn of(awake: &Awake) -> &Self {
        &awake.relations
    }
}

impl Part for Floor {
    fn of(awake: &Awake) -> &Self {
        &awake.floor
    }
}

impl<T> Waking<T> {
    /// The state from which nothing has been changed yet.
    pub(in crate::environment) fn asleep(&self) -> Option<&EnvironmentState> {
        match self {
            Self::Awake(_) => None,
            Self::Asleep(sleeper) => Some(&sleeper.state),
        }
    }
}

impl<T: Part> Waking<T> {
    /// Something else of the environment is about to differ from its state, which stands for it no longer.
    pub(in crate::environment) fn differ(&mut self) {
        let _: &mut T = self;
    }
}

impl<T> From<T> for Waking<T> {
    fn from(awake: T) -> Self {
        Self::Awake(Box::new(awake))
    }
}

impl<T: Part> Deref for Waking<T> {
    type Target = T;

    fn deref(&self) -> &T {
        match self {
            Self::Awake(awake) => awake,
            Self::Asleep(sleeper) => T::of(sleeper.awake()),
        }
    }
}

impl<T: Part> DerefMut for Waking<T> {
    fn deref_mut(&mut self) -> &mut T {
        loop {
            match self {
                Self::Awake(awake) => return awake,
                Self::Asleep(sleeper) => *self = T::of(sleeper.awake()).clone().into(),
            }
        }
    }
}

impl Sleeper {
    pub(super) fn new(state: EnvironmentState, graph: SceneGraph) -> Self {
        Self { state, graph, awake: OnceLock::new() }
    }

    fn awake(&self) -> &Awake {
        let start = &self.state.0.start;
        // It could be built when it was recorded, and is built in the same way.
        self.awake.get_or_init(|| self.build().unwrap_or_else(|_| Awake::at(start)))
    }

    fn build(&self) -> Result<Awake, StateError> {
        let (start, saved) = (&self.state.0.start, &self.state.0);
        let named = |error: vc_physics::RestError| error.named(&|id| self.graph.label(id));
        let mut world = start.world.recorded(&saved.record).map_err(named)?;
        let (relations, floor, _) = read(start, &mut world, saved.clock.as_read(&self.graph))?;
        Ok(Awake { world, relations, floor })
    }
}

impl Awake {
    fn at(start: &Start) -> Self {
        Self { world: start.world.clone(), relations: start.relations.clone(), floor: start.floor.clone() }
    }
}

/// Reads relations and floor of a world that has just been built from its record, in a scene as relations see it; also
/// returns the nodes whose relations may differ from the start.
pub(super) fn read(
    start: &Start,
    world: &mut PhysicsWorld,
    seen: &SceneGraph,
) -> Result<(Relations, Floor, Vec<NodeId>), InputError> {
    let (mut relations, mut floor) = (start.relations.clone(), start.floor.clone());
    let met = relations.update_with(seen, &changed(&start.graph, seen), observe::evidence(world))?;
    floor.update(world);
    world.forget_moved();
    Ok((relations, floor, met))
}

/// The nodes of which relations may differ from those of another scene.
fn changed(start: &SceneGraph, now: &SceneGraph) -> Vec<NodeId> {
    let changes = ChangeSet::between(start, now);
    let moved = changes.changes().iter().filter_map(|change| match change {
        Change::Pose { id, .. } => Some(*id),
        _ => None,
    });
    moved.chain(changes.nodes()).collect()
}
