//! Hands as end effectors: they are guided to poses, touch and push things, and hold what they close around.
//!
//! A guided hand is a body of its own: a palm, fingers and a thumb that open and close. The [arm](arm) pulls it to its
//! goal with the force of a person; what it hits stops it, what is light gives way. [Fingers](fingers) close until they
//! meet something. A thing between them can be [held](grasp): a loose thing by a joint that keeps it as it is in the
//! hand, a moving part by a joint about which it turns, as a handle does in a hand; either slips out where more pulls at
//! it than the force of the grip. Arms have no body.

mod arm;
mod fingers;
mod grasp;

use nalgebra::UnitQuaternion;
use rapier3d::dynamics::{MassProperties, RigidBodyBuilder};
use rapier3d::geometry::ColliderBuilder;
use rapier3d::math::Vector;
use vc_graph::{NodeId, Pose};

use crate::state::{Effector, Hand, HandGoal};
use crate::world::PhysicsWorld;
use crate::{AgentError, convert, group};

/// Mass of a hand with what of the arm moves with it, kilograms, and its inertia, kilograms square metres.
const MASS: f32 = 2.0;
const INERTIA: f32 = 0.01;
/// Friction of skin.
const FRICTION: f32 = 0.8;

/// # Hands as end effectors
impl PhysicsWorld {
    /// Guides a hand to a goal, until it gets another: at most a metre a second, with at most 150 N along each axis, as
    /// far as nothing stops it. A hand that was not guided before gets a body at the side, or where it holds something;
    /// from then on the thing collides with others. The goal is not held against the length of the arm.
    ///
    /// A hand lets go of what it holds once its grip is wider than the thing by some millimetres.
    ///
    /// # Errors
    /// [`AgentError::NoSuchAgent`], [`AgentError::BadGoal`].
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// use vc_graph::Pose;
    /// use vc_physics::{Hand, HandGoal};
    /// world.teleport(home.person, Pose::translation(0.3, 0.0, 0.0))?;
    /// // Above the table, which is 0.74 m high, then down through it.
    /// for height in [1.0, 0.5] {
    ///     let goal = HandGoal { pose: Pose::translation(0.4, -0.2, height), ..HandGoal::default() };
    ///     world.guide_hand(home.person, Hand::Right, goal)?;
    ///     world.run(90);
    /// }
    /// let hand = world.agent(home.person)?.guided(Hand::Right).ok_or("not guided")?;
    /// assert!(hand.pose.translation.z > 0.74 && hand.touches.contains(&home.table));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn guide_hand(&mut self, agent: NodeId, hand: Hand, goal: HandGoal) -> Result<(), AgentError> {
        self.agent_state(agent)?;
        goal.check(agent)?;
        let rotation = UnitQuaternion::new_normalize(goal.pose.rotation.into_inner());
        let goal = HandGoal { pose: Pose::from_parts(goal.pose.translation, rotation), ..goal };
        let Some(effector) = self.effectors.get_mut(&(agent, hand)) else {
            return self.make_effector(agent, hand, goal);
        };
        if std::mem::replace(&mut effector.goal, goal) != goal
            && let Some(body) = self.engine.body_mut(effector.body)
        {
            body.wake_up(true);
        }
        Ok(())
    }

    /// Ends the guidance of a hand, if it is guided: it has no body any more. A thing in it comes to where hands carry
    /// things, and a moving part is let go.
    ///
    /// # Errors
    /// [`AgentError::NoSuchAgent`].
    pub fn withdraw_hand(&mut self, agent: NodeId, hand: Hand) -> Result<(), AgentError> {
        self.agent_state(agent)?;
        if let Some(effector) = self.effectors.get(&(agent, hand)) {
            let bodies = [effector.body, effector.anchor];
            self.carry_again(agent, hand)?;
            self.effectors.remove(&(agent, hand));
            bodies.into_iter().for_each(|body| self.engine.remove(body));
        }
        Ok(())
    }

    /// Pulls guided hands on, opens and closes them.
    pub(crate) fn work_hands(&mut self) {
        for (agent, hand) in self.guided() {
            self.meet_things_again(agent, hand);
            if self.loses(agent, hand) {
                // It holds something.
                let _ = self.let_go(agent, hand);
            }
            self.pull_hand(agent, hand);
            self.work_fingers(agent, hand);
        }
    }

    /// Notes where guided hands have come to, with what they hold and what is on that.
    pub(crate) fn follow_hands(&mut self) {
        for (agent, hand) in self.guided() {
            let Some(feet) = self.agents.get(&agent).map(|agent| agent.feet) else { continue };
            if let Some(effector) = self.effectors.get_mut(&(agent, hand)) {
                effector.at = self.engine.pose(effector.body).map_or(effector.at, |pose| feet.inverse() * pose);
            }
            self.follow_held(agent, hand);
        }
    }

    fn guided(&self) -> Vec<(NodeId, Hand)> {
        self.effectors.keys().copied().collect()
    }

    fn make_effector(&mut self, id: NodeId, hand: Hand, goal: HandGoal) -> Result<(), AgentError> {
        let agent = self.agent_state(id)?;
        let holds = agent.hands[hand as usize].is_some();
        let at = if holds { agent.hand_pose(hand) } else { agent.arm_down(hand) };
        let place = agent.feet * at;
        let mass = MassProperties::new(Vector::ZERO, MASS, Vector::splat(INERTIA));
        let builder = RigidBodyBuilder::dynamic().pose(convert::pose(&place)).gravity_scale(0.0);
        let builder = builder.additional_mass_properties(mass).ccd_enabled(true);
        let body = self.engine.add_body(builder.user_data(group::mark(id, 0)));
        let add = |world: &mut Self, (shape, pose): fingers::Piece| {
            let collider = ColliderBuilder::new(shape).position(convert::pose(&pose)).density(0.0).friction(FRICTION);
            let collider = collider.collision_groups(group::hand()).user_data(group::mark(id, 0));
            world.engine.add_collider(collider.build(), body)
        };
        add(self, fingers::palm());
        let open = [fingers::NEAR; 2];
        let jaws = fingers::Jaw::BOTH.map(|jaw| add(self, jaw.piece(open[jaw as usize])));
        let anchor = self.engine.bodies.insert(RigidBodyBuilder::fixed().user_data(group::mark(id, 0)));
        let arm = self.engine.joints.insert(anchor, body, arm::joint(&place), true);
        self.engine.refresh(body);
        let effector = Effector { goal, body, anchor, arm, set_point: at, at, jaws, open, closed: false, grasp: None };
        self.effectors.insert((id, hand), effector);
        if holds { self.hold_as_it_is(id, hand) } else { Ok(()) }
    }

    /// Moves guided hands along with an agent that is put elsewhere at once.
    pub(crate) fn take_hands_along(&mut self, id: NodeId, feet: &Pose) {
        for hand in Hand::BOTH {
            if let Some(effector) = self.effectors.get(&(id, hand)) {
                self.engine.place(effector.body, convert::pose(&(feet * effector.at)));
            }
        }
    }
}
