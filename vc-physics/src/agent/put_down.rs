//! Putting down and letting go.

use vc_graph::{NodeId, Pose};

use crate::state::{Hand, Loaded};
use crate::world::PhysicsWorld;
use crate::{AgentError, BodyRole, PhysicsError, convert};

/// # Putting down
impl PhysicsWorld {
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

    /// Puts the thing in a hand, with its load, onto or into a thing that a hand carries, of the same agent or another
    /// one: from then on that hand carries it along. As [`Self::put`] if no hand carries that thing.
    ///
    /// # Errors
    /// As [`Self::put`].
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// use vc_graph::Pose;
    /// use vc_physics::Hand;
    /// world.teleport(home.person, Pose::translation(0.3, 0.0, 0.0))?;
    /// world.grab(home.person, Hand::Right, home.cup)?;
    /// let table = world.pose(home.table).ok_or("no table")? * Pose::translation(0.0, 0.0, 0.76);
    /// // The table is in no hand, so the cup is put down on it.
    /// world.put_with(home.person, Hand::Right, table, home.table)?;
    /// assert_eq!(world.held(home.person, Hand::Right), None);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn put_with(&mut self, agent: NodeId, hand: Hand, pose: Pose, at: NodeId) -> Result<NodeId, AgentError> {
        let Some((by, carrying)) = self.carrier(at).filter(|carrier| *carrier != (agent, hand)) else {
            return self.put(agent, hand, pose);
        };
        let own = self.agent_state(agent)?.hands[hand as usize].as_ref().ok_or(AgentError::HandEmpty(agent))?;
        let with: Vec<(NodeId, bool)> = own.load.iter().map(|loaded| (loaded.id, loaded.pinned)).collect();
        let id = self.put(agent, hand, pose)?;
        let held = self.held(by, carrying).and_then(|held| self.pose(held)).unwrap_or_else(Pose::identity);
        for (id, pinned) in with.into_iter().chain([(id, false)]) {
            let Some(pose) = self.pose(id) else { continue };
            self.set_role(id, BodyRole::Carried)?;
            if let Some(held_by) = self.agent_mut(by)?.hands[carrying as usize].as_mut() {
                held_by.load.push(Loaded { id, at: held.inverse() * pose, pinned });
            }
        }
        self.embody(by, true);
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
    pub(crate) fn free_hand(&mut self, agent: NodeId, hand: Hand, pose: Option<Pose>) -> Result<NodeId, AgentError> {
        self.unfasten(agent, hand);
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
