//! The physics engine's sets, in one struct that can be cloned and serialised.

mod contact_completion;
mod contact_reduction;
mod moved;
mod prediction;
mod still;

use std::sync::OnceLock;

use nalgebra::Vector3;
use rapier3d::dynamics::{
    CCDSolver, ImpulseJointSet, IntegrationParameters, IslandManager, MultibodyJointSet, RigidBody, RigidBodyBuilder,
    RigidBodyHandle, RigidBodySet, SoftBodySet, SpringCoefficients,
};
use rapier3d::geometry::{BroadPhaseBvh, Collider, ColliderHandle, ColliderSet, NarrowPhase};
use rapier3d::math::{Pose as EnginePose, Rotation};
use rapier3d::pipeline::{PhysicsPipeline, QueryFilter, QueryPipeline};
use serde::{Deserialize, Deserializer, Serialize};

use crate::convert;
use moved::Moved;
pub(crate) use still::{resting_pose, same_rest};

/// The distance at which two bodies get contact points, metres. The engine's default of two centimetres is as
/// wide as a cup's foot: points that do not touch would crowd out those that do, and small things would rock
/// for ever.
const PREDICTION: f32 = 0.005;
/// The relative motion of two bodies after which their contact points are computed anew, metres.
const RECYCLED: f32 = 0.01;
/// Number of solver substeps per step. With two, stacks lean; the engine's default of four costs a fifth more.
const SUBSTEPS: usize = 3;
/// Damping ratio of contacts. With the engine's default of ten, a stack of ten cubes drifts twice as far before
/// it rests.
const DAMPING: f32 = 5.0;
/// How long a body has to be still before it falls asleep, seconds.
const STILL: f32 = 0.25;

/// The engine with all of its state.
#[derive(Clone, Serialize, Deserialize)]
pub(crate) struct Engine {
    pub(crate) bodies: RigidBodySet,
    pub(crate) colliders: ColliderSet,
    pub(crate) joints: ImpulseJointSet,
    islands: IslandManager,
    broad: BroadPhaseBvh,
    #[serde(deserialize_with = "with_dispatcher")]
    pub(crate) narrow: NarrowPhase,
    // Unused, but required by the engine's interface.
    multibodies: MultibodyJointSet,
    softs: SoftBodySet,
    parameters: IntegrationParameters,
    gravity: f32,
    /// Whether there has been a step. Until then the engine's own tree is empty, and the first step builds it
    /// from all bodies at once.
    started: bool,
    /// The tree for queries before the first step, built on demand.
    #[serde(skip)]
    early: OnceLock<BroadPhaseBvh>,
    #[serde(skip)]
    scratch: Scratch,
    /// Not saved: whoever restores an engine has read nothing of it.
    #[serde(skip)]
    moved: Moved,
}

/// Buffers whose content has no meaning between steps.
#[derive(Default)]
struct Scratch {
    pipeline: PhysicsPipeline,
    ccd: CCDSolver,
}

impl Clone for Scratch {
    fn clone(&self) -> Self {
        Self::default()
    }
}

impl Engine {
    pub(crate) fn new(dt: f32, gravity: f32) -> Self {
        Self {
            bodies: RigidBodySet::new(),
            colliders: ColliderSet::new(),
            joints: ImpulseJointSet::new(),
            islands: IslandManager::new(),
            broad: BroadPhaseBvh::new(),
            narrow: NarrowPhase::with_query_dispatcher(contact_reduction::dispatcher()),
            multibodies: MultibodyJointSet::new(),
            softs: SoftBodySet::new(),
            parameters: parameters(dt),
            gravity,
            started: false,
            early: OnceLock::new(),
            scratch: Scratch::default(),
            moved: Moved::default(),
        }
    }

    pub(crate) fn dt(&self) -> f32 {
        self.parameters.dt
    }

    /// Does one step; returns the bodies that became non-finite and were stopped.
    pub(crate) fn step(&mut self) -> &[RigidBodyHandle] {
        self.predict_contacts();
        self.advance(self.parameters.dt, self.gravity)
    }

    /// Does one step of some length, seconds, under some gravity.
    fn advance(&mut self, dt: f32, gravity: f32) -> &[RigidBodyHandle] {
        self.note_awake();
        (self.started, self.early) = (true, OnceLock::new());
        self.scratch.pipeline.step(
            convert::vector(Vector3::new(0.0, 0.0, -gravity)),
            &IntegrationParameters { dt, ..self.parameters },
            &mut self.islands,
            &mut self.broad,
            &mut self.narrow,
            &mut self.bodies,
            &mut self.colliders,
            &mut self.joints,
            &mut self.multibodies,
            &mut self.softs,
            &mut self.scratch.ccd,
            &(),
            &(),
        );
        self.note_awake();
        self.scratch.pipeline.quarantine().bodies()
    }

    /// Only these are moved by a step: those that it wakes are awake after it.
    fn note_awake(&mut self) {
        self.islands.active_bodies().for_each(|body| self.moved.add(body));
    }

    /// A body, to be changed; it counts as moved from then on.
    pub(crate) fn body_mut(&mut self, body: RigidBodyHandle) -> Option<&mut RigidBody> {
        self.moved.add(body);
        self.bodies.get_mut(body)
    }

    /// Notes that something of a body has changed that the engine knows nothing of.
    pub(crate) fn note(&mut self, body: RigidBodyHandle) {
        self.moved.add(body);
    }

    /// The bodies that may have moved since [`Self::forget_moved`]; at first all.
    pub(crate) fn moved(&self) -> Vec<&RigidBody> {
        match self.moved.indexes() {
            Some(indexes) => indexes.filter_map(|i| self.bodies.get_unknown_gen(i)).map(|(body, _)| body).collect(),
            None => self.bodies.iter().map(|(_, body)| body).collect(),
        }
    }

    /// Starts anew to note which bodies move.
    pub(crate) fn forget_moved(&mut self) {
        self.moved.clear();
    }

    /// Number of bodies that are awake and free to move.
    pub(crate) fn awake(&self) -> usize {
        self.awake_bodies().filter(|b| self.bodies.get(*b).is_some_and(|b| b.is_dynamic() && !b.is_sleeping())).count()
    }

    /// Whether all bodies that are free to move sleep.
    pub(crate) fn is_at_rest(&self) -> bool {
        let moves = |b: RigidBodyHandle| self.bodies.get(b).is_some_and(|b| b.is_dynamic() && !b.is_sleeping());
        !self.awake_bodies().any(moves)
    }

    /// Whether all bodies that are free to move sleep, those with them that have been disturbed since the last step:
    /// only the next step counts them among the active ones.
    pub(crate) fn is_still(&self) -> bool {
        let sleeps = |b: &RigidBody| !b.is_dynamic() || b.is_sleeping() || !b.is_enabled();
        self.is_at_rest() && self.bodies.iter().all(|(_, body)| sleeps(body))
    }

    /// Moves a kinematic body to a pose in the course of the next step. A body that is there already is left
    /// alone, so that it can sleep.
    pub(crate) fn carry(&mut self, body: RigidBodyHandle, pose: EnginePose) {
        if self.bodies.get(body).is_some_and(|b| *b.position() != pose)
            && let Some(rigid) = self.body_mut(body)
        {
            rigid.set_next_kinematic_position(pose);
        }
    }

    /// Adds a body.
    pub(crate) fn add_body(&mut self, body: RigidBodyBuilder) -> RigidBodyHandle {
        let handle = self.bodies.insert(body);
        if let Some(rigid) = self.body_mut(handle) {
            rigid.activation_mut().time_until_sleep = STILL;
        }
        handle
    }

    /// The bodies that are awake.
    pub(crate) fn awake_bodies(&self) -> impl Iterator<Item = RigidBodyHandle> + '_ {
        self.islands.active_bodies()
    }

    /// Those of some bodies that are fixed, with their poses.
    pub(crate) fn fixed_among(&self, bodies: &[RigidBodyHandle]) -> Vec<(RigidBodyHandle, EnginePose)> {
        let fixed = bodies.iter().filter_map(|&b| Some((b, self.bodies.get(b).filter(|b| b.is_fixed())?)));
        fixed.map(|(handle, body)| (handle, *body.position())).collect()
    }

    /// Puts fixed bodies back: a body that was pinned while it was awake stays among those that the engine integrates,
    /// and its rotation creeps by rounding. A body put back wakes what it touches, so it gets a rotation that stays.
    pub(crate) fn keep(&mut self, fixed: &[(RigidBodyHandle, EnginePose)]) {
        for (handle, pose) in fixed {
            if let Some(body) = self.body_mut(*handle).filter(|b| b.is_fixed() && b.position() != pose) {
                body.set_position(EnginePose { rotation: steady(pose.rotation), ..*pose }, false);
            }
        }
    }

    /// Queries about shapes in space, in the present state.
    pub(crate) fn queries<'a>(&'a self, filter: QueryFilter<'a>) -> QueryPipeline<'a> {
        self.tree().as_query_pipeline(self.narrow.query_dispatcher(), &self.bodies, &self.colliders, filter)
    }

    /// As `queries`, for the vehicle controller, which pushes bodies.
    pub(crate) fn queries_mut<'a>(&'a mut self, filter: QueryFilter<'a>) -> rapier3d::pipeline::QueryPipelineMut<'a> {
        self.tree();
        let tree = self.early.get().unwrap_or(&self.broad);
        tree.as_query_pipeline_mut(self.narrow.query_dispatcher(), &mut self.bodies, &mut self.colliders, filter)
    }

    fn tree(&self) -> &BroadPhaseBvh {
        let of_all = || {
            let mut tree = BroadPhaseBvh::new();
            for (handle, collider) in self.colliders.iter() {
                tree.set_aabb(&self.parameters, handle, collider.compute_aabb());
            }
            tree
        };
        if self.started { &self.broad } else { self.early.get_or_init(of_all) }
    }

    pub(crate) fn add_collider(&mut self, collider: Collider, to: RigidBodyHandle) -> ColliderHandle {
        self.early.take();
        let handle = self.colliders.insert_with_parent(collider, to, &mut self.bodies);
        self.moved.add(to);
        // Otherwise a body has no mass before its first step.
        if let Some(body) = self.bodies.get_mut(to) {
            body.recompute_mass_properties_from_colliders(&self.colliders);
        }
        handle
    }

    /// Moves a body at once, without velocity and awake; queries see it there.
    pub(crate) fn place(&mut self, body: RigidBodyHandle, pose: EnginePose) {
        let Some(rigid) = self.body_mut(body) else { return };
        rigid.set_position(pose, true);
        rigid.set_linvel(rapier3d::math::Vector::ZERO, true);
        rigid.set_angvel(rapier3d::math::Vector::ZERO, true);
        if rigid.is_kinematic() {
            rigid.set_next_kinematic_position(pose);
        }
        self.refresh(body);
    }

    /// Updates a body's pose in the query tree before the next step does.
    pub(crate) fn refresh(&mut self, body: RigidBodyHandle) {
        let Some(rigid) = self.bodies.get(body) else { return };
        for &handle in rigid.colliders() {
            let Some(collider) = self.colliders.get_mut(handle) else { continue };
            let local = collider.position_wrt_parent().copied().unwrap_or_default();
            collider.set_position(*rigid.position() * local);
            if self.started {
                let aabb = collider.compute_aabb();
                self.broad.set_aabb(&self.parameters, handle, aabb);
            }
        }
        self.early.take();
    }

    /// Enables a body that the engine has disabled because it became non-finite, or lets one take part no longer.
    pub(crate) fn set_enabled(&mut self, body: RigidBodyHandle, enabled: bool) {
        let Some(rigid) = self.body_mut(body).filter(|b| b.is_enabled() != enabled) else { return };
        rigid.set_enabled(enabled);
        let colliders = rigid.colliders().to_vec();
        for collider in colliders {
            if let Some(collider) = self.colliders.get_mut(collider) {
                collider.set_enabled(enabled);
            }
        }
    }

    /// Removes all colliders of a body.
    pub(crate) fn strip(&mut self, body: RigidBodyHandle) {
        self.early.take();
        let colliders = self.bodies.get(body).map(|b| b.colliders().to_vec()).unwrap_or_default();
        for collider in colliders {
            self.colliders.remove(collider, &mut self.islands, &mut self.bodies, &mut self.softs, true);
        }
    }

    /// Removes a body with its colliders and joints.
    pub(crate) fn remove(&mut self, body: RigidBodyHandle) {
        self.early.take();
        self.bodies.remove(
            body,
            &mut self.islands,
            &mut self.colliders,
            &mut self.joints,
            &mut self.multibodies,
            &mut self.softs,
            true,
        );
    }

    /// The pose of a body; of one that sleeps that in which it would be built anew, so that nobody can tell whether it was.
    pub(crate) fn pose(&self, body: RigidBodyHandle) -> Option<vc_graph::Pose> {
        let body = self.bodies.get(body)?;
        Some(convert::isometry(&if body.is_sleeping() { resting_pose(body.position()) } else { *body.position() }))
    }
}

/// The query dispatcher is not serialised with the contacts.
fn with_dispatcher<'de, D: Deserializer<'de>>(from: D) -> Result<NarrowPhase, D::Error> {
    let mut narrow = NarrowPhase::deserialize(from)?;
    narrow.set_query_dispatcher(contact_reduction::dispatcher());
    Ok(narrow)
}

fn damped(contacts: SpringCoefficients<f32>) -> SpringCoefficients<f32> {
    SpringCoefficients { damping_ratio: DAMPING, ..contacts }
}

fn parameters(dt: f32) -> IntegrationParameters {
    IntegrationParameters {
        dt,
        normalized_prediction_distance: PREDICTION,
        normalized_contact_recycle_distance: RECYCLED,
        num_solver_iterations: SUBSTEPS,
        contact_softness: damped(SpringCoefficients::contact_defaults()),
        static_contact_softness: damped(SpringCoefficients::contact_static_defaults()),
        // The engine's clustering would keep four points of all points in a plane, whether or not they carry
        // the load; `contact_reduction` checks this.
        contact_clustering: false,
        ..IntegrationParameters::default()
    }
}

/// A rotation next to a given one that is the same to the bit when it is normalized, as the engine does in each step.
pub(crate) fn steady(rotation: Rotation) -> Rotation {
    let components = rotation.to_array();
    let largest = (0..4).max_by(|&i, &j| components[i].abs().total_cmp(&components[j].abs())).unwrap_or_default();
    let nudged = |by: i32| {
        let mut near = components;
        near[largest] = f32::from_bits(near[largest].to_bits().wrapping_add_signed(by));
        Rotation::from_array(near)
    };
    [0, 1, -1, 2, -2, 3, -3].map(nudged).into_iter().find(|near| near.normalize() == *near).unwrap_or(rotation)
}
