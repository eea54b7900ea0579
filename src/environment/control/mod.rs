//! Low-level control of bodies: velocity and turn, the head, and both hands as end effectors.
//!
//! A control holds until it is changed. In every tick in which something moves, feet and hands [are moved](apply) by it;
//! then what hands hold and let go [enters the graph](hold), and what has moved is observed. A hand goes as far as the
//! figure's arm [reaches](reach).

mod apply;
mod hold;
mod reach;

use std::collections::BTreeMap;

use nalgebra::Vector2;
use serde::{Deserialize, Serialize};
use vc_graph::{NodeId, Refusal};
use vc_physics::{AgentError, GuidedHand, Hand, HandGoal, PhysicsError, Posture};

use super::{ActionError, Attempt, Environment, PhysicalRefusal};

/// The control input of a body, which holds until it is changed.
///
/// ```
/// use virtualcity::graph::Pose;
/// use virtualcity::nalgebra::Vector2;
/// use virtualcity::physics::HandGoal;
/// use virtualcity::Control;
/// // Slowly backwards, looking down, the right hand open before the chest.
/// let hand = HandGoal { pose: Pose::translation(0.4, -0.2, 1.2), ..HandGoal::default() };
/// let control = Control {
///     velocity: Vector2::new(-0.3, 0.0),
///     head: Some(Vector2::new(0.0, -0.5)),
///     hands: [Some(hand), None],
///     ..Control::default()
/// };
/// assert_eq!(control.turn, 0.0);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Control {
    /// The velocity of the body ahead and to the left, metres per second, in its own frame. A faster one than the body
    /// runs, 3 m/s by default ([`BodyPlan::run`](vc_physics::BodyPlan::run)), is cut to that speed in the same direction.
    pub velocity: Vector2<f32>,
    /// The rate at which it turns to the left, radians per second; more than 5 to either side is cut to 5.
    pub turn: f32,
    /// The direction of the head to the left and up from straight ahead, radians, as far as a neck turns: what
    /// is beyond 1.2 to a side or 1.4 up or down is cut to that. Without it the eyes follow a hand.
    pub head: Option<Vector2<f32>>,
    /// The goals of the hands, the right one first, in the body's frame. A hand without one does nothing, and carries what
    /// it holds.
    pub hands: [Option<HandGoal>; 2],
}

/// A hand under control, as it is now.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct ControlledHand {
    /// Its body: pose and opening, what it touches, and what it holds.
    pub body: GuidedHand,
    /// How far its goal is out of reach, metres: the hand goes as far as the arm does.
    pub short: f32,
    /// The reasons of the transition rule for which it does not hold what is between fingers and thumb; `body.fault` is
    /// that of bodies.
    pub refused: Vec<Refusal>,
}

/// The reason for which nobody is controlled or steered in an environment without bodies.
pub(super) const WITHOUT: &str = "bodies do nothing here: make the environment with `bodies(true)`";

/// The controls of all agents.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Controls {
    pub(super) all: BTreeMap<NodeId, Control>,
    /// Whether they have been changed since the last tick.
    pub(super) new: bool,
}

impl Controls {
    /// Whether there is nothing to do by them.
    pub(super) fn is_empty(&self) -> bool {
        self.all.is_empty() && !self.new
    }
}

impl Environment {
    /// Controls a body from the next tick of [`step`](Self::step) on, until the next control. Feet move as they are told
    /// to, along what they hit; hands are bodies of their own that go to their goals at most a metre a second and with at
    /// most 150 N, stop at what they hit and push what is light. Fingers that close hold what they touch from both sides:
    ///
    /// - a loose thing as `grab` would, if the transition rule allows that: it keeps its pose in the hand, meets other
    ///   things, slips out where more pulls at it than the force of the grip, and falls when the hand opens;
    /// - a door, lid or drawer by its handle, if the rule allows to open or close it: it follows the hand on its joint.
    ///
    /// The graph follows in each tick: hands and what they hold, doors and drawers, which are open from the same opening
    /// on as after the action `open`, rooms, nearness, and the places of things by their geometry. [`changes`](Self::changes)
    /// lists these. Control is no action: it is not in the history, and others act beside it. An agent under control is
    /// busy for actions and for [`steer`](Self::steer), until [`interrupt`](Self::interrupt) ends the control: hands come
    /// back, with what they hold.
    ///
    /// Uses `PhysicsWorld::drift`, `PhysicsWorld::guide_hand`, `PhysicsWorld::grasp` and `Relations::update_nodes`. Costs
    /// nothing itself; a tick costs a step of bodies and the relations of what moves, some tenths of a millisecond, and
    /// nothing once all rest.
    ///
    /// # Errors
    /// [`ActionError::Impossible`] if bodies do nothing here
    /// ([`EnvironmentBuilder::bodies`](crate::EnvironmentBuilder::bodies)), there is no such agent, it sits or lies and is
    /// to walk or turn, or a number is not finite or out of its range; [`ActionError::Busy`] while it acts. In these cases
    /// nothing has changed.
    ///
    /// ```
    /// use virtualcity::graph::{Pose, clock::Span};
    /// use virtualcity::physics::{Hand, HandGoal};
    /// use virtualcity::{Control, Environment};
    /// let mut home = Environment::make("apartment/42", 1)?;
    /// let me = home.agents()[0];
    /// // To the right, farther than the arm reaches.
    /// let far = HandGoal { pose: Pose::translation(0.2, -2.0, 1.2), ..HandGoal::default() };
    /// home.control(me, &Control { hands: [Some(far), None], ..Control::default() })?;
    /// home.step(Span(90));
    /// let hand = home.controlled_hand(me, Hand::Right).ok_or("not under control")?;
    /// assert!(hand.short > 1.0 && hand.body.holds.is_none());
    /// home.interrupt(me);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn control(&mut self, agent: NodeId, control: &Control) -> Result<(), ActionError> {
        if self.current_action(agent).is_some() {
            return Err(ActionError::Busy(self.graph.label(agent)));
        }
        let without = (!self.start.time.bodies).then_some(PhysicalRefusal::NotModelled(WITHOUT));
        let fault = || self.control_fault(agent, control).map(|why| PhysicalRefusal::from(why).in_scene(&self.graph));
        if let Some(why) = without.or_else(fault) {
            return Err(ActionError::Impossible { attempt: Attempt::named("control"), why });
        }
        self.stays_aside(agent);
        self.clock.controls.all.insert(agent, *control);
        self.clock.controls.new = true;
        Ok(())
    }

    /// The control of an agent, if it is under control.
    pub fn controlled(&self, agent: NodeId) -> Option<&Control> {
        self.clock.controls.all.get(&agent)
    }

    /// A hand that is under control, as it was after the last tick. Costs some microseconds.
    pub fn controlled_hand(&self, agent: NodeId, hand: Hand) -> Option<ControlledHand> {
        let goal = self.controlled(agent)?.hands[hand as usize]?;
        let body = self.world.agent(agent).ok()?.guided(hand)?;
        // As far as the body brings it: the goal that it has in physics.
        let short = (goal.pose.translation.vector - body.goal.pose.translation.vector).norm();
        let refused = body.between.map_or_else(Vec::new, |between| self.hold_refusals(agent, between));
        Some(ControlledHand { body, short, refused })
    }

    /// The reason why a body cannot do what a control says.
    fn control_fault(&self, agent: NodeId, control: &Control) -> Option<AgentError> {
        let Some(posture) = self.world.posture(agent) else { return Some(AgentError::NoSuchAgent(agent)) };
        let moves = control.velocity != Vector2::zeros() || control.turn != 0.0;
        let finite = |what: &'static str, all: &[f32]| {
            (!all.iter().all(|v| v.is_finite())).then_some(PhysicsError::NotFinite(what, agent).into())
        };
        let stands = posture == Posture::Standing || !moves;
        let seated = (!stands).then_some(AgentError::Posture { agent, posture: posture.as_str() });
        let head = control.head.unwrap_or_default();
        finite("the velocity", control.velocity.as_slice())
            .or_else(|| finite("the turn", &[control.turn]))
            .or_else(|| finite("the direction of the head", head.as_slice()))
            .or_else(|| control.hands.iter().flatten().find_map(|goal| goal.check(agent).err()))
            .or(seated)
    }
}
