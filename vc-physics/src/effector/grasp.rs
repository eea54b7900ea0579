//! Things that guided hands hold, and let go.

use nalgebra::Point3;
use rapier3d::dynamics::{GenericJoint, ImpulseJointHandle, JointAxesMask, RigidBodyHandle, RigidBodyType};
use rapier3d::geometry::{Collider, InteractionGroups};
use vc_graph::{NodeId, Pose};

use super::arm::pull;
use super::fingers::{Jaw, SPAN};
use crate::state::{Grasp, Hand};
use crate::world::PhysicsWorld;
use crate::{AgentError, BodyRole, PhysicsError, convert, group};

/// How far what is held slips in the hand before it is out of it, metres.
const SLIP: f32 = 0.03;
/// A hand that is wider than what it holds by so much lets go, metres.
const LOOSE: f32 = 0.005;

/// # Holding by contact
impl PhysicsWorld {
    /// Holds what is between the fingers and the thumb of a guided hand, [`GuidedHand::between`]: a loose thing as
    /// [`grab_with_load`](Self::grab_with_load) does, with the things of `load` that are on it or in it, but as it is in
    /// the hand, and as a body that goes on to meet others; or a door, lid or drawer by its handle. Returns the node, and
    /// the number of the part.
    ///
    /// [`GuidedHand::between`]: crate::GuidedHand::between
    ///
    /// # Errors
    /// [`AgentError::NothingBetween`]; for things as [`grab`](Self::grab), [`PhysicsError::Locked`] for parts.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// use nalgebra::UnitQuaternion;
    /// use vc_graph::Pose;
    /// use vc_physics::{Hand, HandGoal};
    /// world.settle(300);
    /// world.teleport(home.person, Pose::translation(0.3, 0.0, 0.0))?;
    /// // Around the cup, the thumb on this side of it.
    /// let turn = UnitQuaternion::from_euler_angles(std::f32::consts::FRAC_PI_2, 0.0, 0.0);
    /// let beside = Pose::from_parts([0.45, 0.0, 0.8].into(), turn);
    /// let around = Pose::from_parts([0.7, 0.0, 0.8].into(), turn);
    /// for (pose, grip) in [(beside, 0.0), (around, 0.0), (around, 1.0)] {
    ///     world.guide_hand(home.person, Hand::Right, HandGoal { pose, grip, ..HandGoal::default() })?;
    ///     world.run(60);
    /// }
    /// assert_eq!(world.grasp(home.person, Hand::Right, &[])?, (home.cup, None));
    /// assert_eq!(world.held(home.person, Hand::Right), Some(home.cup));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn grasp(&mut self, agent: NodeId, hand: Hand, load: &[NodeId]) -> Result<(NodeId, Option<usize>), AgentError> {
        self.agent_state(agent)?;
        let (id, link) = self.between(agent, hand).ok_or(AgentError::NothingBetween(agent))?;
        self.grasp_fault(agent, hand, (id, link)).map_or(Ok(()), Err)?;
        match self.part_body(id, link) {
            Some(body) => {
                self.loosen_part(id, link - 1)?;
                self.fasten_part(agent, hand, (id, link), body);
                Ok((id, Some(link - 1)))
            }
            None => {
                self.take_as_it_is(agent, hand, id, load)?;
                self.hold_as_it_is(agent, hand)?;
                Ok((id, None))
            }
        }
    }

    /// The reason for which a hand cannot hold something.
    pub(crate) fn grasp_fault(&self, agent: NodeId, hand: Hand, (id, link): (NodeId, usize)) -> Option<AgentError> {
        match self.part_body(id, link) {
            Some(_) if self.is_locked(id, link - 1) => Some(PhysicsError::Locked(id).into()),
            Some(_) => None,
            None => self.check_may_take(agent, hand, id).err(),
        }
    }

    /// The body of a moving part, if it has one of its own.
    pub(crate) fn part_body(&self, id: NodeId, link: usize) -> Option<RigidBodyHandle> {
        self.thing(id).ok()?.state.moving.get(link.checked_sub(1)?)?.body
    }

    /// Fastens a part where the hand is: it may turn about that point.
    fn fasten_part(&mut self, agent: NodeId, hand: Hand, (id, link): (NodeId, usize), part: RigidBodyHandle) {
        let Some((body, force)) = self.effectors.get(&(agent, hand)).map(|hand| (hand.body, hand.goal.force)) else {
            return;
        };
        let in_part = self.engine.pose(part).zip(self.engine.pose(body)).map(|(part, hand)| part.inverse() * hand);
        let mut data = GenericJoint::new(JointAxesMask::empty());
        data.set_local_frame2(convert::pose(&in_part.unwrap_or_else(Pose::identity))).set_contacts_enabled(false);
        pull(&mut data, force);
        let joint = self.engine.joints.insert(body, part, data, true);
        self.note_grasp(agent, hand, Grasp { id, link, joint });
    }

    /// Fastens the thing in a hand as it is, as a body that meets others.
    pub(super) fn hold_as_it_is(&mut self, agent: NodeId, hand: Hand) -> Result<(), AgentError> {
        let (Some(id), Some(effector)) = (self.held(agent, hand), self.effectors.get(&(agent, hand))) else {
            return Err(AgentError::HandEmpty(agent));
        };
        let (body, force, base) = (effector.body, effector.goal.force, self.thing(id)?.state.base);
        let in_hand = self.engine.pose(body).zip(self.engine.pose(base)).map(|(hand, thing)| hand.inverse() * thing);
        let mut data = GenericJoint::new(JointAxesMask::ANG_AXES);
        data.set_local_frame1(convert::pose(&in_hand.unwrap_or_else(Pose::identity))).set_contacts_enabled(false);
        pull(&mut data, force);
        let joint = self.engine.joints.insert(body, base, data, true);
        self.become_solid(base);
        self.note_grasp(agent, hand, Grasp { id, link: 0, joint });
        Ok(())
    }

    /// Lets a carried body meet others.
    fn become_solid(&mut self, base: RigidBodyHandle) {
        let Some(rigid) = self.engine.body_mut(base) else { return };
        rigid.set_body_type(RigidBodyType::Dynamic, true);
        for collider in rigid.colliders().to_vec() {
            if let Some(collider) = self.engine.colliders.get_mut(collider) {
                collider.set_collision_groups(group::hand());
            }
        }
    }

    fn note_grasp(&mut self, agent: NodeId, hand: Hand, grasp: Grasp) {
        if let Some(effector) = self.effectors.get_mut(&(agent, hand)) {
            effector.grasp = Some(grasp);
        }
    }

    /// Takes the joint of what a guided hand holds away.
    pub(crate) fn unfasten(&mut self, agent: NodeId, hand: Hand) -> Option<Grasp> {
        let effector = self.effectors.get_mut(&(agent, hand))?;
        let grasp = effector.grasp.take()?;
        // The engine has removed it with the body of a thing that is gone.
        self.engine.joints.remove(grasp.joint, true);
        Some(grasp)
    }

    /// Lets go of what a guided hand holds: it falls, or stays as far open as it is.
    pub(super) fn let_go(&mut self, agent: NodeId, hand: Hand) -> Result<(), AgentError> {
        match self.effectors.get(&(agent, hand)).and_then(|hand| hand.grasp) {
            Some(grasp) if grasp.link > 0 => {
                self.unfasten(agent, hand);
                Ok(self.leave_part(grasp.id, grasp.link - 1)?)
            }
            Some(_) if self.held(agent, hand).is_some() => {
                self.free_hand(agent, hand, None)?;
                self.join_groups(agent, hand, group::opened_hand());
                Ok(())
            }
            _ => Ok(()),
        }
    }

    /// Lets a hand that was opened meet loose things again, once nothing falls past its fingers any more.
    pub(super) fn meet_things_again(&mut self, agent: NodeId, hand: Hand) {
        let Some(effector) = self.effectors.get(&(agent, hand)) else { return };
        let groups = self.engine.colliders.get(effector.jaws[0]).map(Collider::collision_groups);
        if groups != Some(group::opened_hand()) {
            return;
        }
        let falls = |(id, _): (NodeId, usize)| self.role(id) == Some(BodyRole::Loose) && self.is_falling(id);
        let passes = |jaw: Jaw| self.in_way(effector, jaw.reach(effector.open[jaw as usize])).any(falls);
        if effector.grasp.is_some() || !Jaw::BOTH.into_iter().any(passes) {
            self.join_groups(agent, hand, group::hand());
        }
    }

    /// Whether a thing moves faster than one that has begun to fall in the last step.
    fn is_falling(&self, id: NodeId) -> bool {
        let begun = self.settings.gravity * self.settings.dt / 2.0;
        let base = self.thing(id).ok().and_then(|thing| self.engine.bodies.get(thing.state.base));
        begun > 0.0 && base.is_some_and(|base| base.linvel().length() > begun)
    }

    /// Gives the palm, the fingers and the thumb of a guided hand other collision groups.
    fn join_groups(&mut self, agent: NodeId, hand: Hand, groups: InteractionGroups) {
        let body = self.effectors.get(&(agent, hand)).and_then(|hand| self.engine.body_mut(hand.body));
        for collider in body.map_or_else(Vec::new, |body| body.colliders().to_vec()) {
            if let Some(collider) = self.engine.colliders.get_mut(collider) {
                collider.set_collision_groups(groups);
            }
        }
    }

    /// Lets the things in a hand that is guided no longer come to where hands carry things.
    pub(super) fn carry_again(&mut self, agent: NodeId, hand: Hand) -> Result<(), AgentError> {
        match self.effectors.get(&(agent, hand)).and_then(|hand| hand.grasp) {
            Some(grasp) if grasp.link == 0 => {
                self.unfasten(agent, hand);
                self.take_up(agent, hand)
            }
            _ => self.let_go(agent, hand),
        }
    }

    /// Whether a hand has been opened, or what it held has slipped out of it or is gone.
    pub(super) fn loses(&self, agent: NodeId, hand: Hand) -> bool {
        let Some(effector) = self.effectors.get(&(agent, hand)) else { return false };
        let Some(grasp) = &effector.grasp else { return false };
        let wide = (1.0 - effector.goal.grip) * SPAN > effector.opening() + LOOSE;
        wide || self.slip(grasp.joint).is_none_or(|far| far > SLIP)
    }

    /// Whether a thing is fastened to a guided hand.
    pub(crate) fn is_fastened(&self, id: NodeId) -> bool {
        self.effectors.values().any(|hand| hand.grasp.is_some_and(|grasp| grasp.link == 0 && grasp.id == id))
    }

    /// Notes where what a hand holds has come to; what is on it or in it goes along.
    pub(super) fn follow_held(&mut self, agent: NodeId, hand: Hand) {
        let Some(id) = self.held(agent, hand).filter(|id| self.is_fastened(*id)) else { return };
        let (Some(pose), Some(body)) = (self.pose(id), self.agents.get_mut(&agent)) else { return };
        let grip = (body.feet * body.lap()).inverse() * pose;
        let Some(held) = &mut body.hands[hand as usize] else { return };
        held.grip = grip;
        for (load, at) in held.load.iter().map(|load| (load.id, pose * load.at)).collect::<Vec<_>>() {
            if let Ok(base) = self.thing(load).map(|thing| thing.state.base)
                && self.engine.pose(base) != Some(at)
            {
                self.engine.place(base, convert::pose(&at));
            }
        }
    }

    /// How far what a joint pulls together is apart, metres.
    fn slip(&self, joint: ImpulseJointHandle) -> Option<f32> {
        let joint = self.engine.joints.get(joint)?;
        let (one, other) = (self.engine.bodies.get(joint.body1())?, self.engine.bodies.get(joint.body2())?);
        let at = |pose: rapier3d::math::Pose| Point3::from(convert::isometry(&pose).translation.vector);
        let (from, to) = (*one.position() * joint.data.local_frame1, *other.position() * joint.data.local_frame2);
        Some((at(to) - at(from)).norm())
    }
}
