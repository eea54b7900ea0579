//! Agents who leave a world for another, with the things in their hands.

use vc_graph::{AssetId, NodeId, Pose};

use crate::rest::RecordedThing;
use crate::state::Agent;
use crate::world::PhysicsWorld;
use crate::{AgentError, Hand, PhysicsError, Posture, convert};

/// An agent that has left a world, with the things in its hands. [`PhysicsWorld::depart`] makes it,
/// [`PhysicsWorld::arrive`] lets it enter another world.
#[derive(Clone)]
pub struct Traveller {
    id: NodeId,
    agent: Agent,
    things: Vec<RecordedThing>,
}

impl Traveller {
    /// The agent.
    pub fn agent(&self) -> NodeId {
        self.id
    }

    /// The things in its hands, and those on and in them.
    pub fn things(&self) -> impl Iterator<Item = NodeId> + '_ {
        self.things.iter().map(|carried| carried.thing.id)
    }

    /// The same where the shapes of things have other numbers.
    #[must_use]
    pub fn with_assets(mut self, asset: impl Fn(NodeId) -> Option<AssetId>) -> Self {
        self.things.iter_mut().for_each(|carried| carried.thing.state.asset = asset(carried.thing.id));
        self
    }
}

/// # Agents who come and go
impl PhysicsWorld {
    /// Takes an agent that stands out of the world, with the things in its hands and all that is on and in them, as they are:
    /// with opened lids and pinned loads. Still water is left out.
    ///
    /// # Errors
    /// [`AgentError::NoSuchAgent`], [`AgentError::Posture`] unless it stands; nothing has changed then.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// use vc_graph::Pose;
    /// use vc_physics::Hand;
    /// let mut other = world.clone();
    /// other.remove(home.cup)?;
    /// other.depart(home.person)?;
    /// world.teleport(home.person, Pose::translation(0.3, 0.0, 0.0))?;
    /// world.grab(home.person, Hand::Right, home.cup)?;
    /// let traveller = world.depart(home.person)?;
    /// assert_eq!((world.pose(home.person), world.pose(home.cup)), (None, None));
    /// other.arrive(&traveller, Pose::translation(0.3, 0.1, 0.0))?;
    /// assert_eq!(other.held(home.person, Hand::Right), Some(home.cup));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn depart(&mut self, agent: NodeId) -> Result<Traveller, AgentError> {
        let state = self.agent_state(agent)?;
        if state.posture != Posture::Standing {
            return Err(AgentError::Posture { agent, posture: state.posture.as_str() });
        }
        for hand in
            Hand::BOTH.into_iter().filter(|hand| self.effectors.contains_key(&(agent, *hand))).collect::<Vec<_>>()
        {
            self.withdraw_hand(agent, hand)?;
        }
        let carried: Vec<NodeId> = self.agent_state(agent)?.holdings().into_iter().map(|(id, _)| id).collect();
        let things = carried.iter().filter_map(|id| Some(self.recorded_thing(self.thing(*id).ok()?))).collect();
        for id in carried {
            self.take_out(id);
            self.driven.retain(|(driven, _)| *driven != id);
            self.drain(id);
        }
        self.stopped.retain(|id| *id != agent);
        let state = self.agents.remove(&agent).ok_or(AgentError::NoSuchAgent(agent))?;
        self.engine.remove(state.body);
        Ok(Traveller { id: agent, agent: state, things })
    }

    /// Lets an agent that has left another world stand in this one, its feet at a pose of which only the rotation around the
    /// vertical counts. It holds the same things in the same way.
    ///
    /// # Errors
    /// [`PhysicsError::Duplicate`] if the agent or one of its things is here already, [`PhysicsError::NotFinite`]; nothing has
    /// changed then.
    pub fn arrive(&mut self, traveller: &Traveller, feet: Pose) -> Result<(), PhysicsError> {
        let Traveller { id, agent, things } = traveller;
        if let Some(here) = traveller.things().find(|thing| self.index(*thing).is_ok()) {
            return Err(PhysicsError::Duplicate(here));
        }
        self.add_agent(*id, agent.plan, feet)?;
        let Some(own) = self.agents.get_mut(id) else { return Ok(()) };
        let before = convert::pose(&agent.feet);
        let motion = convert::pose(&own.feet) * before.inverse();
        own.hands.clone_from(&agent.hands);
        things.iter().for_each(|carried| self.put_in(&carried.shifted(&motion)));
        self.embody(*id, true);
        Ok(())
    }
}
