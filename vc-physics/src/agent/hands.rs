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
        let free = |load: &&NodeId| matches!(self.role(**load), Some(BodyRole::Loose | BodyRole::Hung)) && **load != id;
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
        let (body, thing) = (self.agent_state(agent)?, self.thing(id)?);
        let pose = self.engine.pose(thing.state.base).unwrap_or_else(Pose::identity);
        let grip = grip(body, (hand, side), &pose, thing.form.extent);
        let pinned = |load: NodeId| self.role(load) == Some(BodyRole::Hung);
        let at = |load: NodeId| Some(Loaded { id: load, at: pose.inverse() * self.pose(load)?, pinned: pinned(load) });
        let left: Vec<NodeId> = self.load_on(id).into_iter().filter(|resting| !load.contains(resting)).collect();
        let load: Vec<Loaded> = load.iter().copied().filter_map(at).collect();
        for carried in load.iter().map(|l| l.id).chain([id]) {
            self.set_role(carried, BodyRole::Carried)?;
        }
        left.into_iter().try_for_each(|id| self.wake(id))?;
        self.agent_mut(agent)?.hands[hand as usize] = Some(Held { id, grip, load });
        self.embody(agent, true);
        Ok(())
    }

    /// Whether a hand is free and the agent may take a thing: it is loose, light enough, and nobody sits on it.
    fn check_may_take(&self, agent: NodeId, hand: Hand, id: NodeId) -> Result<(), AgentError> {
        let body = self.agent_state(agent)?;
        if let Some(held) = &body.hands[hand as usize] {
            return Err(AgentError::HandFull { agent, held: held.id });
        }
        let thing = self.thing(id)?;
        match thing.state.role {
            BodyRole::Loose | BodyRole::Hung => {}
            BodyRole::Carried => return Err(AgentError::Held(id)),
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

    /// Puts the thing in a hand down at a pose, at rest; [`SpotSearch`](crate::SpotSearch) finds one. The pose has to be
    /// free, and within reach of the shoulder.
    ///
    /// # Errors
    /// [`AgentError::HandEmpty`], [`AgentError::OutOfReach`],
    /// [`PhysicsError::Overlap`], [`PhysicsError::NotFinite`].
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// use vc_physics::{Hand, SpotOrder, SpotSearch};
    /// world.teleport(home.person, vc_graph::Pose::translation(0.3, 0.0, 0.0))?;
    /// world.grab(home.person, Hand::Right, home.cup)?;
    /// let near = SpotOrder::Near(nalgebra::Point3::new(0.7, 0.0, 0.74));
    /// let spot = SpotSearch::new(home.cup, home.table, false).order(near).find(&world)?.ok_or("the table is full")?;
    /// world.put(home.person, Hand::Right, spot)?;
    /// assert_eq!(world.held(home.person, Hand::Right), None);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn put(&mut self, agent: NodeId, hand: Hand, pose: Pose) -> Result<NodeId, AgentError> {
        let body = self.agent_state(agent)?;
        let id = body.hands[hand as usize].as_ref().ok_or(AgentError::HandEmpty(agent))?.id;
        if let Some(&other) = self.overlaps(id, &pose)?.first() {
            return Err(PhysicsError::Overlap { id, other }.into());
        }
        let (distance, reach) = (self.put_distance(body, &body.feet, self.thing(id)?, &pose), body.plan.reach);
        if distance > reach {
            return Err(AgentError::OutOfReach { agent, id, distance, reach });
        }
        self.free_hand(agent, hand, Some(pose))
    }

    /// Puts the thing in a hand back to its pose in another moment of this world, which need not be free: the thing is
    /// pinned there to its former support or container, or to the moving part that carried it.
    /// [`former_spot`](crate::BodyView::former_spot) finds the pose.
    ///
    /// # Errors
    /// [`AgentError::HandEmpty`], [`AgentError::OutOfReach`], [`PhysicsError::NoBody`], [`PhysicsError::NotFinite`].
    pub fn put_back(
        &mut self,
        then: &Self,
        (agent, hand): (NodeId, Hand),
        pose: Pose,
        at: NodeId,
    ) -> Result<NodeId, AgentError> {
        self.thing(at)?;
        let body = self.agent_state(agent)?;
        let id = body.hands[hand as usize].as_ref().ok_or(AgentError::HandEmpty(agent))?.id;
        if !convert::is_sound(&pose) {
            return Err(PhysicsError::NotFinite("the pose", id).into());
        }
        let (distance, reach) = (self.put_distance(body, &body.feet, self.thing(id)?, &pose), body.plan.reach);
        if distance > reach {
            return Err(AgentError::OutOfReach { agent, id, distance, reach });
        }
        self.free_hand(agent, hand, Some(pose))?;
        self.pin(id, Some(at))?;
        self.thing_mut(id)?.state.rides = Some((at, then.link_below(id, at)));
        Ok(id)
    }

    /// Lets go of the thing in a hand: it falls from its present pose, or from the nearest free one before the
    /// agent.
    ///
    /// # Errors
    /// [`AgentError::HandEmpty`]; [`PhysicsError::Overlap`] where there is no room to
    /// let it go.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// use vc_physics::Hand;
    /// world.teleport(home.person, vc_graph::Pose::translation(0.3, 0.0, 0.0))?;
    /// world.grab(home.person, Hand::Left, home.cup)?;
    /// assert_eq!(world.drop(home.person, Hand::Left)?, home.cup);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn drop(&mut self, agent: NodeId, hand: Hand) -> Result<NodeId, AgentError> {
        let body = self.agent_state(agent)?;
        let held = body.hands[hand as usize].as_ref().ok_or(AgentError::HandEmpty(agent))?;
        let (id, feet, grip) = (held.id, body.feet, body.lap() * held.grip);
        let mut blocked = None;
        for (ahead, up) in [(0.0, 0.0), (0.1, 0.0), (0.0, 0.2), (0.2, 0.1), (-0.1, 0.0), (0.0, -0.2), (0.1, 0.4)] {
            let spot = feet * Pose::translation(ahead, 0.0, up) * grip;
            match self.overlaps(id, &spot)?.first() {
                None => return self.free_hand(agent, hand, Some(spot)),
                Some(&other) => blocked = blocked.or(Some(other)),
            }
        }
        Err(PhysicsError::Overlap { id, other: blocked.unwrap_or(agent) }.into())
    }

    /// Opens a hand; the thing in it is then at a pose, at rest, with its load.
    fn free_hand(&mut self, agent: NodeId, hand: Hand, pose: Option<Pose>) -> Result<NodeId, AgentError> {
        let held = self.agent_mut(agent)?.hands[hand as usize].take().ok_or(AgentError::HandEmpty(agent))?;
        let pose = pose.or_else(|| self.pose(held.id)).unwrap_or_else(Pose::identity);
        let load = held.load.iter().map(|l| (l.id, pose * l.at, l.pinned));
        for (id, at, pinned) in std::iter::once((held.id, pose, false)).chain(load) {
            // A thing that was removed from the world meanwhile is not put down.
            if self.set_role(id, BodyRole::Loose).is_ok() {
                self.place(id, at)?;
                if pinned {
                    self.pin(id, Some(held.id))?;
                }
            }
        }
        Ok(held.id)
    }

    /// Makes sure that no hand holds a thing, and that it is in no hand's load.
    pub(crate) fn let_go_of(&mut self, id: NodeId) {
        if let Some((agent, hand)) = self.holder(id) {
            let _ = self.free_hand(agent, hand, None);
        }
        for held in self.agents.values_mut().flat_map(|a| a.hands.iter_mut().flatten()) {
            held.load.retain(|l| l.id != id);
        }
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
