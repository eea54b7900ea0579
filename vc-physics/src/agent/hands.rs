//! Two hands: taking, carrying, putting down.

use nalgebra::{Point3, Vector2, Vector3};
use serde::{Deserialize, Serialize};
use vc_graph::{NodeId, Pose, Relation};

use super::{ADULT, Agent, BodyPlan, Posture};
use crate::world::PhysicsWorld;
use crate::{AgentError, BodyRole, PhysicsError, convert};

/// How low a shoulder comes when one bends, as a share of the height.
const BENT: f32 = 0.3;
/// How high the shoulders come when it stands on its toes, metres above where they are.
const TIPTOE: f32 = 0.08;
/// Parts of the way one can lean that are tried.
const LEANS: [f32; 4] = [1.0, 0.7, 0.35, 0.0];

/// Least distance of what is held from the body, metres.
const BEFORE: f32 = 0.02;
/// Where hands hold things: how far ahead of the body and to its side, metres, and how high, as a part of the height:
/// before the chest, so that the eyes have it in view.
const AHEAD: f32 = 0.3;
const ASIDE: f32 = 0.2;
const CHEST: f32 = 0.74;
/// How far below the eyes the top of what is held is at least, as a part of how far its far side is ahead: one looks
/// over it.
const BELOW: f32 = 0.5;
/// How far above the floor what is held is at least, metres.
const OFF: f32 = 0.05;

/// A hand.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub enum Hand {
    /// The right one, which is used first.
    Right,
    /// The left one.
    Left,
}

impl Hand {
    /// Both, the right one first.
    pub const BOTH: [Self; 2] = [Self::Right, Self::Left];

    /// The relation of a holder to what this hand holds.
    pub fn relation(self) -> Relation {
        match self {
            Self::Right => Relation::HoldsRight,
            Self::Left => Relation::HoldsLeft,
        }
    }

    fn side(self) -> f32 {
        match self {
            Self::Right => -1.0,
            Self::Left => 1.0,
        }
    }
}

/// What a hand holds.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct Held {
    pub(crate) id: NodeId,
    /// Where it is against the agent's feet while it stands.
    #[serde(with = "crate::serial::pose")]
    grip: Pose,
    /// What lies on it or in it, and where against it.
    load: Vec<Loaded>,
}

#[derive(Clone, Debug, Serialize, Deserialize)]
struct Loaded {
    id: NodeId,
    #[serde(with = "crate::serial::pose")]
    at: Pose,
    /// Whether it was pinned there, and is so again when the whole is put down.
    pinned: bool,
}

impl Agent {
    /// Everything carried, and where it is now.
    pub(super) fn holdings(&self) -> Vec<(NodeId, Pose)> {
        let held = self.hands.iter().flatten();
        let each = |held: &Held| {
            let at = self.feet * self.lap() * held.grip;
            let load: Vec<_> = held.load.iter().map(|l| (l.id, at * l.at)).collect();
            std::iter::once((held.id, at)).chain(load)
        };
        held.flat_map(each).collect()
    }

    /// Where hands that hold things go when the agent sits or lies, against where they are when it
    /// stands: before its chest still.
    fn lap(&self) -> Pose {
        match self.posture {
            Posture::Standing => Pose::identity(),
            Posture::Sitting(..) => Pose::translation(0.05, 0.0, -0.44 * self.plan.height),
            Posture::Lying(..) => Pose::translation(-0.5, 0.0, -0.44 * self.plan.height),
        }
    }

    /// Where a hand is against the feet: before the chest.
    fn hand(&self, hand: Hand) -> Point3<f32> {
        Point3::new(self.plan.radius + AHEAD, ASIDE * hand.side(), CHEST * self.plan.height)
    }
}

impl PhysicsWorld {
    /// What a hand holds.
    pub fn held(&self, agent: NodeId, hand: Hand) -> Option<NodeId> {
        self.agents.get(&agent)?.hands[hand as usize].as_ref().map(|h| h.id)
    }

    /// Who holds a thing, and in which hand.
    pub fn holder(&self, id: NodeId) -> Option<(NodeId, Hand)> {
        let all = self.agents.keys().flat_map(|&a| Hand::BOTH.map(|h| (a, h)));
        all.into_iter().find(|&(a, h)| self.held(a, h) == Some(id))
    }

    /// Whether a hand holds a thing with something on it or in it.
    pub(crate) fn is_held_with_load(&self, id: NodeId) -> bool {
        let mut held = self.agents.values().flat_map(|a| a.hands.iter().flatten());
        held.any(|h| h.id == id && !h.load.is_empty())
    }

    /// How far a thing is from an agent's shoulder, to its nearest point, metres. An
    /// agent bends down for what is low, leans towards what is far, and stands on its toes.
    ///
    /// # Errors
    /// [`AgentError::NoSuchAgent`], [`PhysicsError::NoBody`].
    pub fn reach_to(&self, agent: NodeId, id: NodeId) -> Result<f32, AgentError> {
        let body = self.agent(agent)?;
        let arm = match body.posture {
            Posture::Standing => self.arm(&body.plan, body.feet.translation.vector.into(), id)?,
            _ => body.shoulder(),
        };
        Ok(self.distance_to(id, arm)?)
    }

    /// How far from an agent's shoulder a thing would be put down at a pose by an agent with its
    /// feet somewhere: to the middle of the thing, less half its size, metres.
    ///
    /// # Errors
    /// [`AgentError::NoSuchAgent`], [`PhysicsError::NoBody`].
    pub fn reach_to_put(&self, agent: NodeId, feet: &Pose, id: NodeId, pose: &Pose) -> Result<f32, AgentError> {
        let body = self.agent(agent)?;
        let (low, high) = self.thing(id)?.form.extent;
        let middle = pose * nalgebra::center(&low, &high);
        let arm = match body.posture {
            Posture::Standing => leaning(&body.plan, feet.translation.vector.into(), middle),
            _ => body.shoulder(),
        };
        Ok((middle - arm).norm() - (high - low).norm() / 2.0)
    }

    /// Where the shoulder of a body is that reaches for a thing.
    pub(crate) fn arm(&self, plan: &BodyPlan, feet: Point3<f32>, id: NodeId) -> Result<Point3<f32>, PhysicsError> {
        let middle = self.aabb(id).ok_or(PhysicsError::NoBody(id))?.centre();
        Ok(leaning(plan, feet, middle))
    }

    /// Distance of a point from the nearest point of a thing.
    pub(crate) fn distance_to(&self, id: NodeId, point: Point3<f32>) -> Result<f32, PhysicsError> {
        let thing = self.thing(id)?;
        let bodies = thing.bodies().filter_map(|b| self.engine.bodies.get(b));
        let colliders = bodies.flat_map(|b| b.colliders()).filter_map(|&c| self.engine.colliders.get(c));
        let each = colliders.map(|c| c.shape().distance_to_point(c.position(), convert::point(point), true));
        each.reduce(f32::min).ok_or(PhysicsError::NoBody(id))
    }

    /// What an agent's hands can get at from where it is: the nodes people can carry
    /// within reach of its shoulder, nearest first, with the distance. Whether a door
    /// is in between is not looked at; see [`can_see`](Self::can_see).
    ///
    /// # Errors
    /// [`AgentError::NoSuchAgent`].
    pub fn in_reach(&self, agent: NodeId) -> Result<Vec<(NodeId, f32)>, AgentError> {
        let body = self.agent(agent)?;
        let feet = Point3::from(body.feet.translation.vector);
        // Whatever it bends for is within this of its middle.
        let middle = feet + Vector3::z() * (0.5 * body.plan.height);
        let near = self.within(middle, body.plan.stretch() + 0.5 * body.plan.height);
        let carried =
            |id: &NodeId| self.thing(*id).is_ok_and(|t| t.state.graspable && t.state.role != BodyRole::Carried);
        let mut found = Vec::new();
        for (id, _) in near.into_iter().filter(|(id, _)| carried(id)) {
            let distance = self.reach_to(agent, id)?;
            if distance <= body.plan.reach {
                found.push((id, distance));
            }
        }
        found.sort_by(|a, b| a.1.total_cmp(&b.1).then(a.0.cmp(&b.0)));
        Ok(found)
    }

    /// Whether an agent's eyes see a thing: a ray to its middle or to a corner of its
    /// box, a little in, meets nothing else first. Ways to look are not considered.
    ///
    /// # Errors
    /// [`AgentError::NoSuchAgent`], [`PhysicsError::NoBody`].
    pub fn can_see(&self, agent: NodeId, id: NodeId) -> Result<bool, AgentError> {
        let body = self.agent(agent)?;
        let rise = body.plan.eye() - body.plan.shoulder();
        let eye = body.shoulder() + Vector3::z() * rise;
        let mut past = vec![agent];
        past.extend(body.holdings().into_iter().map(|(id, _)| id));
        Ok(self.sees(eye, id, &past)?)
    }

    pub(crate) fn sees(&self, eye: Point3<f32>, id: NodeId, past: &[NodeId]) -> Result<bool, PhysicsError> {
        self.thing(id)?;
        let aabb = self.aabb(id).ok_or(PhysicsError::NoBody(id))?;
        let (centre, half) = (aabb.centre(), (aabb.max - aabb.min) * 0.45);
        let corner = |i: u32| {
            let sign = |bit: u32| if i >> bit & 1 == 0 { -1.0 } else { 1.0 };
            centre + Vector3::new(sign(0) * half.x, sign(1) * half.y, sign(2) * half.z)
        };
        let clear = |to: Point3<f32>| match self.ray(eye, to, past) {
            None => true,
            Some((met, _)) => met == id,
        };
        Ok(std::iter::once(centre).chain((0..8).map(corner)).any(clear))
    }

    /// Takes a thing into a hand, with what lies on it or in it. From now on it
    /// follows the hand and touches nothing.
    ///
    /// # Errors
    /// [`AgentError::HandFull`], [`AgentError::OutOfReach`],
    /// [`AgentError::TooHeavy`], [`AgentError::Held`], [`AgentError::Occupied`],
    /// [`PhysicsError::NotFree`] for what is fixed.
    pub fn grab(&mut self, agent: NodeId, hand: Hand, id: NodeId) -> Result<(), AgentError> {
        self.grab_with(agent, hand, id, |_| true)
    }

    /// As [`Self::grab`]; of what lies on the thing, only that comes along which a condition
    /// admits. The rest is left behind, and falls if nothing else carries it.
    ///
    /// # Errors
    /// As [`Self::grab`].
    pub fn grab_with(
        &mut self,
        agent: NodeId,
        hand: Hand,
        id: NodeId,
        comes: impl Fn(NodeId) -> bool,
    ) -> Result<(), AgentError> {
        self.check_reach(agent, id)?;
        let load: Vec<NodeId> = self.load_on(id).into_iter().filter(|load| comes(*load)).collect();
        self.take(agent, hand, id, &load)
    }

    /// As [`Self::grab`], but exactly the things of `load` come along, even those that do not touch the grabbed thing,
    /// such as one that a scene has in a bowl through whose side it sticks. Nodes without a body are passed over.
    ///
    /// # Errors
    /// As [`Self::grab`].
    pub fn grab_all(&mut self, agent: NodeId, hand: Hand, id: NodeId, load: &[NodeId]) -> Result<(), AgentError> {
        self.check_reach(agent, id)?;
        let resting = self.load_on(id);
        let free = |load: &&NodeId| matches!(self.role(**load), Some(BodyRole::Loose | BodyRole::Hung)) && **load != id;
        let apart = load.iter().filter(|load| !resting.contains(load)).filter(free);
        let all: Vec<NodeId> = resting.iter().filter(|resting| load.contains(resting)).chain(apart).copied().collect();
        self.take(agent, hand, id, &all)
    }

    fn check_reach(&self, agent: NodeId, id: NodeId) -> Result<(), AgentError> {
        let distance = self.reach_to(agent, id)?;
        let reach = self.agent(agent)?.plan.reach;
        if distance > reach { Err(AgentError::OutOfReach { agent, id, distance, reach }) } else { Ok(()) }
    }

    /// Takes a thing from any distance, with exactly the things of a load: what rests on it besides is left behind.
    pub(crate) fn take(&mut self, agent: NodeId, hand: Hand, id: NodeId, load: &[NodeId]) -> Result<(), AgentError> {
        self.check_may_take(agent, hand, id)?;
        let (body, thing) = (self.agent(agent)?, self.thing(id)?);
        let pose = self.engine.pose(thing.state.base).unwrap_or_else(Pose::identity);
        let grip = grip(body, hand, &pose, thing.form.extent);
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
        let body = self.agent(agent)?;
        if let Some(held) = &body.hands[hand as usize] {
            return Err(AgentError::HandFull { agent, held: held.id });
        }
        match self.thing(id)?.state.role {
            BodyRole::Loose | BodyRole::Hung => {}
            BodyRole::Carried => return Err(AgentError::Held(id)),
            BodyRole::Fixed | BodyRole::Stopped => return Err(PhysicsError::NotFree(id).into()),
        }
        let (mass, limit) = (self.mass(id).unwrap_or(0.0), body.plan.carries);
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

    /// Where a hand holds what it holds: its pose against the agent's feet, or its seat.
    pub fn grip(&self, agent: NodeId, hand: Hand) -> Option<Pose> {
        let body = self.agents.get(&agent)?;
        body.hands[hand as usize].as_ref().map(|h| body.lap() * h.grip)
    }

    /// Holds what a hand holds elsewhere against the agent's feet: before the mouth, over a pan.
    /// It is there at once, with what lies on it, and touches nothing.
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

    /// Puts down at a pose what a hand holds, at rest; look for one with
    /// [`free_spot`](Self::free_spot). The pose has to be free, and within reach of
    /// the shoulder.
    ///
    /// # Errors
    /// [`AgentError::HandEmpty`], [`AgentError::OutOfReach`],
    /// [`PhysicsError::Overlap`], [`PhysicsError::NotFinite`].
    pub fn put(&mut self, agent: NodeId, hand: Hand, pose: Pose) -> Result<NodeId, AgentError> {
        let body = self.agent(agent)?;
        let id = body.hands[hand as usize].as_ref().ok_or(AgentError::HandEmpty(agent))?.id;
        if let Some(&other) = self.overlaps(id, &pose)?.first() {
            return Err(PhysicsError::Overlap { id, other }.into());
        }
        let (distance, reach) = (self.reach_to_put(agent, &body.feet, id, &pose)?, body.plan.reach);
        if distance > reach {
            return Err(AgentError::OutOfReach { agent, id, distance, reach });
        }
        self.free_hand(agent, hand, Some(pose))
    }

    /// Puts what a hand holds back to where it was in another moment of this world, which need not be free: it is held
    /// there as a part of the thing that it was on or in, or of the part of that which carried it. Look for the pose
    /// with [`spot_as`](Self::spot_as).
    ///
    /// # Errors
    /// [`AgentError::HandEmpty`], [`AgentError::OutOfReach`], [`PhysicsError::NoBody`].
    pub fn put_as(
        &mut self,
        then: &Self,
        (agent, hand): (NodeId, Hand),
        pose: Pose,
        at: NodeId,
    ) -> Result<NodeId, AgentError> {
        let body = self.agent(agent)?;
        let id = body.hands[hand as usize].as_ref().ok_or(AgentError::HandEmpty(agent))?.id;
        let (distance, reach) = (self.reach_to_put(agent, &body.feet, id, &pose)?, body.plan.reach);
        if distance > reach {
            return Err(AgentError::OutOfReach { agent, id, distance, reach });
        }
        self.free_hand(agent, hand, Some(pose))?;
        self.pin_to(id, at)?;
        self.thing_mut(id)?.state.rides = Some((at, then.link_below(id, at)));
        Ok(id)
    }

    /// Lets go of what a hand holds: it falls from where it is, or from the nearest
    /// free place before the agent.
    ///
    /// # Errors
    /// [`AgentError::HandEmpty`]; [`PhysicsError::Overlap`] where there is no room to
    /// let it go.
    pub fn drop(&mut self, agent: NodeId, hand: Hand) -> Result<NodeId, AgentError> {
        let body = self.agent(agent)?;
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

    /// Opens a hand; what it held is at a pose, at rest, with its load.
    fn free_hand(&mut self, agent: NodeId, hand: Hand, pose: Option<Pose>) -> Result<NodeId, AgentError> {
        let held = self.agent_mut(agent)?.hands[hand as usize].take().ok_or(AgentError::HandEmpty(agent))?;
        let pose = pose.or_else(|| self.pose(held.id)).unwrap_or_else(Pose::identity);
        let load = held.load.iter().map(|l| (l.id, pose * l.at, l.pinned));
        for (id, at, pinned) in std::iter::once((held.id, pose, false)).chain(load) {
            // What was taken out of the world meanwhile is not put down.
            if self.set_role(id, BodyRole::Loose).is_ok() {
                self.place(id, at)?;
                if pinned {
                    self.pin_to(id, held.id)?;
                }
            }
        }
        Ok(held.id)
    }

    /// Makes sure that no hand holds a thing, and that it is in nobody's load.
    pub(crate) fn let_go_of(&mut self, id: NodeId) {
        if let Some((agent, hand)) = self.holder(id) {
            let _ = self.free_hand(agent, hand, None);
        }
        for held in self.agents.values_mut().flat_map(|a| a.hands.iter_mut().flatten()) {
            held.load.retain(|l| l.id != id);
        }
    }
}

/// Where a thing is held: upright as it was, turned with the agent, its middle in the
/// hand; large things as much farther ahead as keeps them out of the body, tall ones lower.
fn grip(agent: &Agent, hand: Hand, pose: &Pose, (low, high): (Point3<f32>, Point3<f32>)) -> Pose {
    let turn = agent.feet.rotation.inverse() * pose.rotation;
    let (middle, half) = (nalgebra::center(&low, &high), (high - low) / 2.0);
    let along = |axis: Vector3<f32>| (turn.inverse() * axis).abs().dot(&half);
    let (deep, tall) = (along(Vector3::x()), along(Vector3::z()));
    let mut at = agent.hand(hand).coords;
    at.x = at.x.max(agent.plan.radius + BEFORE + deep);
    let top = agent.plan.eye() - BELOW * (at.x + deep - agent.plan.radius);
    at.z = at.z.min(top - tall).max(tall + OFF);
    Pose::from_parts((at - turn * middle.coords).into(), turn)
}

/// Where the shoulder of a standing body is that reaches for a point: leant towards it and
/// bent down as far as that brings it nearer.
fn leaning(plan: &BodyPlan, feet: Point3<f32>, to: Point3<f32>) -> Point3<f32> {
    let shoulders = LEANS.map(|share| leant(plan, feet, to, share * ADULT.lean));
    let nearer = |a: Point3<f32>, b: Point3<f32>| if (b - to).norm() < (a - to).norm() { b } else { a };
    shoulders.into_iter().fold(shoulders[0], nearer)
}

/// Where the shoulder is that comes forward so far: as high as what it reaches for, but no lower
/// than one can bend and no higher than a leaning body comes.
fn leant(plan: &BodyPlan, feet: Point3<f32>, to: Point3<f32>, most: f32) -> Point3<f32> {
    let way = (to - feet).xy();
    let forward = way.norm().min(most);
    let torso = ADULT.torso * plan.height;
    let sunk = torso - (torso * torso - forward * forward).max(0.0).sqrt();
    let rise = (to.z - feet.z).clamp(BENT * plan.height, (plan.shoulder() + TIPTOE - sunk).max(BENT * plan.height));
    let ahead = way.try_normalize(1e-6).map_or_else(Vector2::zeros, |w| w * forward);
    feet + Vector3::new(ahead.x, ahead.y, rise)
}
