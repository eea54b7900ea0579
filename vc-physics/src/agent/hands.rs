//! Two hands: grabbing, carrying, putting down.

use nalgebra::{Point3, Vector3};
use vc_graph::{NodeId, Pose, Side};

use super::side::side_middle;
use crate::state::{Agent, Hand, Held, Loaded};
use crate::world::PhysicsWorld;
use crate::{AgentError, BodyRole, PhysicsError, convert};

/// Smallest distance of a held thing from the body, metres.
const BEFORE: f32 = 0.02;
/// Smallest distance of a held thing's top below the eyes, as a share of the distance of its far side: the agent
/// looks over it.
const BELOW: f32 = 0.5;
/// Smallest height of a held thing above the floor, metres.
const OFF: f32 = 0.05;

/// # Hands
impl PhysicsWorld {
    /// The thing in a hand.
    pub fn held(&self, agent: NodeId, hand: Hand) -> Option<NodeId> {
        self.agents.get(&agent)?.hands[hand as usize].as_ref().map(|h| h.id)
    }

    /// The agent that holds a thing, and its hand.
    pub fn holder(&self, id: NodeId) -> Option<(NodeId, Hand)> {
        let all = self.agents.keys().flat_map(|&a| Hand::BOTH.map(|h| (a, h)));
        all.into_iter().find(|&(a, h)| self.held(a, h) == Some(id))
    }

    /// The agent and the hand that carry a thing: that hold it, or what it is on or in.
    pub(crate) fn carrier(&self, id: NodeId) -> Option<(NodeId, Hand)> {
        let carries = |held: &Held| held.id == id || held.load.iter().any(|loaded| loaded.id == id);
        let all = self.agents.iter().flat_map(|(agent, body)| Hand::BOTH.map(|hand| (*agent, hand, body)));
        let mut all = all.filter(|(_, hand, body)| body.hands[*hand as usize].as_ref().is_some_and(carries));
        all.next().map(|(agent, hand, _)| (agent, hand))
    }

    /// Whether a thing may be taken: it is loose, or on or in what a hand holds.
    fn is_takeable(&self, id: NodeId) -> bool {
        match self.role(id) {
            Some(BodyRole::Loose | BodyRole::Hung) => true,
            Some(BodyRole::Carried) => self.holder(id).is_none() && self.carrier(id).is_some(),
            _ => false,
        }
    }

    /// Whether a hand holds a thing with something on it or in it.
    pub(crate) fn is_held_with_load(&self, id: NodeId) -> bool {
        let mut held = self.agents.values().flat_map(|a| a.hands.iter().flatten());
        held.any(|h| h.id == id && !h.load.is_empty())
    }

    /// Takes a thing into a hand, together with the things on it and in it. From then on it follows the hand and
    /// collides with nothing.
    ///
    /// # Errors
    /// [`AgentError::HandFull`], [`AgentError::OutOfReach`],
    /// [`AgentError::TooHeavy`], [`AgentError::Held`], [`AgentError::Occupied`],
    /// [`PhysicsError::NotFree`] for what is fixed.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// use vc_physics::Hand;
    /// world.teleport(home.person, vc_graph::Pose::translation(0.3, 0.0, 0.0))?;
    /// world.grab(home.person, Hand::Right, home.cup)?;
    /// assert_eq!(world.held(home.person, Hand::Right), Some(home.cup));
    /// assert_eq!(world.holder(home.cup), Some((home.person, Hand::Right)));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn grab(&mut self, agent: NodeId, hand: Hand, id: NodeId) -> Result<(), AgentError> {
        self.check_reach(agent, id)?;
        let load = self.load_on(id);
        self.take(agent, hand, id, &load, None)
    }

    /// As [`Self::grab`], but exactly the things of `load` come along, even those that do not touch the grabbed thing,
    /// such as one that a scene has in a bowl through whose side it sticks. Nodes without a body are passed over.
    ///
    /// # Errors
    /// As [`Self::grab`].
    pub fn grab_with_load(&mut self, agent: NodeId, hand: Hand, id: NodeId, load: &[NodeId]) -> Result<(), AgentError> {
        self.check_reach(agent, id)?;
        let load = self.load_among(id, load);
        self.take(agent, hand, id, &load, None)
    }

    /// Those of some nodes that come along with a thing: what rests on it, and what is free beside it.
    pub(super) fn load_among(&self, id: NodeId, load: &[NodeId]) -> Vec<NodeId> {
        let resting = self.load_on(id);
        let free = |load: &&NodeId| self.is_takeable(**load) && **load != id;
        let apart = load.iter().filter(|load| !resting.contains(load)).filter(free);
        resting.iter().filter(|resting| load.contains(resting)).chain(apart).copied().collect()
    }

    /// Takes a thing from any distance, with exactly the things of a load; other things on it are left behind. The hand
    /// is at a side of it, or at its middle.
    pub(super) fn take(
        &mut self,
        agent: NodeId,
        hand: Hand,
        id: NodeId,
        load: &[NodeId],
        side: Option<Side>,
    ) -> Result<(), AgentError> {
        self.check_may_take(agent, hand, id)?;
        let grip = self.grip_of((agent, hand), side, id)?;
        self.take_by((agent, hand), id, load, grip)
    }

    /// Takes a thing as it is, with those of some nodes that come along with it.
    pub(crate) fn take_as_it_is(
        &mut self,
        agent: NodeId,
        hand: Hand,
        id: NodeId,
        load: &[NodeId],
    ) -> Result<(), AgentError> {
        self.check_may_take(agent, hand, id)?;
        let (body, pose) = (self.agent_state(agent)?, self.engine.pose(self.thing(id)?.state.base));
        let grip = (body.feet * body.lap()).inverse() * pose.unwrap_or_else(Pose::identity);
        let load = self.load_among(id, load);
        self.take_by((agent, hand), id, &load, grip)
    }

    /// Brings the thing in a hand to where hands carry things.
    pub(crate) fn take_up(&mut self, agent: NodeId, hand: Hand) -> Result<(), AgentError> {
        let id = self.held(agent, hand).ok_or(AgentError::HandEmpty(agent))?;
        self.set_role(id, BodyRole::Carried)?;
        let grip = self.grip_of((agent, hand), None, id)?;
        self.agent_mut(agent)?.hands[hand as usize].as_mut().ok_or(AgentError::HandEmpty(agent))?.grip = grip;
        self.embody(agent, true);
        Ok(())
    }

    /// The pose in which a hand carries a thing, turned as it is now.
    fn grip_of(&self, (agent, hand): (NodeId, Hand), side: Option<Side>, id: NodeId) -> Result<Pose, AgentError> {
        let (body, thing) = (self.agent_state(agent)?, self.thing(id)?);
        let pose = self.engine.pose(thing.state.base).unwrap_or_else(Pose::identity);
        Ok(grip(body, (hand, side), &pose, thing.form.extent))
    }

    fn take_by(
        &mut self,
        (agent, hand): (NodeId, Hand),
        id: NodeId,
        load: &[NodeId],
        grip: Pose,
    ) -> Result<(), AgentError> {
        let pose = self.engine.pose(self.thing(id)?.state.base).unwrap_or_else(Pose::identity);
        let pinned = |load: NodeId| self.role(load) == Some(BodyRole::Hung);
        let at = |load: NodeId| Some(Loaded { id: load, at: pose.inverse() * self.pose(load)?, pinned: pinned(load) });
        let left: Vec<NodeId> = self.load_on(id).into_iter().filter(|resting| !load.contains(resting)).collect();
        let load: Vec<Loaded> = load.iter().copied().filter_map(at).collect();
        for carried in load.iter().map(|l| l.id).chain([id]) {
            // Another hand may have carried it along.
            let held = self.agents.values_mut().flat_map(|agent| agent.hands.iter_mut().flatten());
            held.for_each(|held| held.load.retain(|loaded| loaded.id != carried));
            self.set_role(carried, BodyRole::Carried)?;
        }
        left.into_iter().try_for_each(|id| self.wake(id))?;
        self.agent_mut(agent)?.hands[hand as usize] = Some(Held { id, grip, load });
        self.embody(agent, true);
        Ok(())
    }

    /// Whether a hand is free and the agent may take a thing: it is loose, light enough, and nobody sits on it.
    pub(crate) fn check_may_take(&self, agent: NodeId, hand: Hand, id: NodeId) -> Result<(), AgentError> {
        let body = self.agent_state(agent)?;
        if let Some(held) = &body.hands[hand as usize] {
            return Err(AgentError::HandFull { agent, held: held.id });
        }
        let thing = self.thing(id)?;
        match thing.state.role {
            _ if self.is_takeable(id) => {}
            BodyRole::Loose | BodyRole::Hung | BodyRole::Carried => return Err(AgentError::Held(id)),
            BodyRole::Fixed | BodyRole::Stopped => return Err(PhysicsError::NotFree(id).into()),
        }
        let (mass, limit) = (thing.mass(), body.plan.carries);
        if mass > limit {
            return Err(AgentError::TooHeavy { id, mass, limit });
        }
        let sits = |agent: &Agent| agent.posture.seat().is_some_and(|(seat, _)| seat == id);
        match self.agents.iter().find(|(_, agent)| sits(agent)) {
            Some((&by, _)) => Err(AgentError::Occupied { seat: id, by }),
            None => Ok(()),
        }
    }

    /// The things that rest on a thing, directly or through others; nothing where it has no body.
    pub(crate) fn load_on(&self, id: NodeId) -> Vec<NodeId> {
        self.thing(id).map_or_else(|_| Vec::new(), |thing| self.load_of(thing.state.base))
    }

    /// Changes the pose of the thing in a hand relative to the agent's feet: before the mouth, over a pan. The thing is
    /// there at once, with its load, and collides with nothing.
    ///
    /// # Errors
    /// [`AgentError::NoSuchAgent`], [`AgentError::HandEmpty`], [`PhysicsError::NotFinite`].
    pub fn regrip(&mut self, agent: NodeId, hand: Hand, grip: Pose) -> Result<(), AgentError> {
        if !convert::is_sound(&grip) {
            return Err(PhysicsError::NotFinite("the grip", agent).into());
        }
        let body = self.agent_mut(agent)?;
        let grip = body.lap().inverse() * grip;
        body.hands[hand as usize].as_mut().ok_or(AgentError::HandEmpty(agent))?.grip = grip;
        self.embody(agent, true);
        Ok(())
    }
}

/// The pose in which a thing is held: upright as it was, turned with the agent, its middle or the middle of a side in
/// the hand; large things are farther ahead, clear of the body, and tall ones lower.
fn grip(
    agent: &Agent,
    (hand, side): (Hand, Option<Side>),
    pose: &Pose,
    (low, high): (Point3<f32>, Point3<f32>),
) -> Pose {
    let turn = agent.feet.rotation.inverse() * pose.rotation;
    let (middle, half) = (nalgebra::center(&low, &high), (high - low) / 2.0);
    let along = |axis: Vector3<f32>| (turn.inverse() * axis).abs().dot(&half);
    let (deep, tall) = (along(Vector3::x()), along(Vector3::z()));
    let off = side.map_or_else(Vector3::zeros, |side| turn * (side_middle((low, high), side) - middle));
    let mut at = agent.hand(hand).coords - off;
    at.x = at.x.max(agent.plan.radius + BEFORE + deep);
    let top = agent.plan.eye() - BELOW * (at.x + deep - agent.plan.radius);
    at.z = at.z.min(top - tall).max(tall + OFF);
    Pose::from_parts((at - turn * middle.coords).into(), turn)
}
