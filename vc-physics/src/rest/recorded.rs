//! Worlds at rest as what differs from the world that they began as: light enough to keep a hundred thousand of them.
//!
//! An engine is megabytes, most of it contacts that can be found again. A world that is recorded is built anew from its
//! record, and whoever builds another from the same record gets the same world, bit for bit: *rest is a rebuild*.

use rapier3d::math::Pose as EnginePose;
use vc_graph::{NodeId, Pose};

use crate::engine::{resting_pose, same_rest};
use crate::state::{Agent, Moving, Spot, Thing, Waters};
use crate::world::PhysicsWorld;
use crate::{BodyRole, RestError, convert, group, joints};

/// A world at rest, as what differs from the world that it began as. [`PhysicsWorld::record`] makes it,
/// [`PhysicsWorld::recorded`] reads it.
///
/// It holds about three hundred bytes for each thing that is not where it was at the start.
#[derive(Clone)]
pub struct RestRecord {
    /// Sorted by node.
    pub(super) things: Vec<RecordedThing>,
    pub(super) removed: Vec<NodeId>,
    pub(super) agents: Box<[(NodeId, Agent)]>,
    pub(super) waters: Waters,
    pub(super) ticks: u64,
    pub(super) stopped: Vec<NodeId>,
    pub(super) skipped: Vec<NodeId>,
}

/// A thing that is not as it was at the start, and where its bodies are, its base first.
#[derive(Clone)]
pub(crate) struct RecordedThing {
    pub(crate) thing: Thing,
    pub(crate) poses: Vec<EnginePose>,
}

impl RecordedThing {
    /// The same, moved as a whole.
    pub(crate) fn shifted(&self, motion: &EnginePose) -> Self {
        Self { thing: self.thing.clone(), poses: self.poses.iter().map(|pose| *motion * *pose).collect() }
    }

    fn bytes(&self) -> usize {
        size_of::<Self>() + size_of_val(&*self.thing.state.moving) + size_of_val(&*self.poses)
    }
}

impl RestRecord {
    /// The nodes that differ from the start, by number: moved, turned, taken, or new.
    pub fn things(&self) -> impl Iterator<Item = NodeId> + '_ {
        self.things.iter().map(|recorded| recorded.thing.id)
    }

    /// The poses of these, of those that have a body, as [`PhysicsWorld::pose`] tells them.
    pub fn poses(&self) -> impl Iterator<Item = (NodeId, Pose)> + '_ {
        let pose = |recorded: &RecordedThing| Some((recorded.thing.id, convert::isometry(recorded.poses.first()?)));
        self.things.iter().filter_map(pose)
    }

    /// The [steps](PhysicsWorld::ticks) that the world had made.
    pub fn ticks(&self) -> u64 {
        self.ticks
    }

    /// About how many bytes it takes beside itself.
    pub fn bytes(&self) -> usize {
        let nodes = self.removed.len() + self.stopped.len() + self.skipped.len();
        let loads = self.agents.iter().flat_map(|(_, agent)| agent.hands.iter().flatten().map(|held| &held.load));
        self.things.iter().map(RecordedThing::bytes).sum::<usize>()
            + nodes * size_of::<NodeId>()
            + size_of_val(&*self.agents)
            + loads.map(|load| size_of_val(&**load)).sum::<usize>()
            + size_of_val(&*self.waters.all)
            + self.waters.levels.len() * size_of::<(NodeId, f32)>()
    }
}

/// # Records of rest
impl PhysicsWorld {
    /// Records this world, which is at rest, as what differs from the world `start`, from which it has come by steps and
    /// calls, and builds it anew from the record: from then on it evolves as every other world that is built from it.
    /// Nothing moves by that: a thing that sleeps [has](Self::pose) the pose in which it is built anew, by some units in the last place
    /// beside the engine's. Things that would not stay, one in thousands, are [pinned](Self::pin).
    ///
    /// Costs a clone of `start`, about as much as an insertion for each thing that differs, and some steps of what these
    /// touch.
    ///
    /// # Errors
    /// [`RestError`]; then nothing has changed.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// world.settle(300);
    /// let start = world.clone();
    /// world.place(home.cup, vc_graph::Pose::translation(0.8, 0.3, 0.741))?;
    /// world.settle(300);
    /// let record = world.record(&start)?;
    /// assert_eq!(record.things().collect::<Vec<_>>(), [home.cup]);
    /// let mut other = start.recorded(&record)?;
    /// for world in [&mut world, &mut other] {
    ///     world.push(home.cup, nalgebra::Vector3::new(0.06, 0.0, 0.0), nalgebra::Point3::new(0.8, 0.3, 0.8))?;
    ///     world.run(60);
    /// }
    /// assert_eq!(world.digest(), other.digest());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn record(&mut self, start: &Self) -> Result<RestRecord, RestError> {
        self.check_rest(start)?;
        let mut record = self.difference(start);
        loop {
            match start.recorded(&record) {
                Ok(world) => {
                    *self = world;
                    return Ok(record);
                }
                Err(RestError::Restless(ids)) if self.pins(&ids, &mut record) => {}
                Err(error) => return Err(error),
            }
        }
    }

    /// Pins things in a record; whether all of them could be, and at least one was not yet.
    fn pins(&self, ids: &[NodeId], record: &mut RestRecord) -> bool {
        for id in ids {
            let Ok(thing) = self.thing(*id) else { return false };
            let at = record.things.partition_point(|recorded| recorded.thing.id < *id);
            if record.things.get(at).is_none_or(|recorded| recorded.thing.id != *id) {
                record.things.insert(at, self.recorded_thing(thing));
            }
            let state = &mut record.things[at].thing.state;
            if state.role != BodyRole::Loose {
                return false;
            }
            (state.role, state.rides) = (BodyRole::Hung, self.rides(*id));
        }
        !ids.is_empty()
    }

    /// The world that was recorded as its difference from this one.
    ///
    /// # Errors
    /// [`RestError::Restless`] if things do not stay where they were recorded: then the record is of another world.
    pub fn recorded(&self, record: &RestRecord) -> Result<Self, RestError> {
        let mut world = self.clone();
        let differ = record.removed.iter().copied().chain(record.things());
        differ.collect::<Vec<NodeId>>().into_iter().for_each(|id| world.take_out(id));
        record.things.iter().for_each(|recorded| world.put_in(recorded));
        for (id, agent) in &record.agents {
            world.stand_in(*id, agent);
        }
        world.waters = record.waters.clone();
        (world.ticks, world.stopped, world.skipped) = (record.ticks, record.stopped.clone(), record.skipped.clone());
        let rest = world.engine.free_bodies();
        // Contacts are found by a step only; without them things would fall through what they stand on.
        world.engine.step();
        if !world.engine.still_at(&rest) {
            let moved = |(body, pose): &(_, EnginePose)| {
                let body = world.engine.bodies.get(*body)?;
                (!same_rest(body.position(), pose)).then(|| group::marked(body.user_data).0)
            };
            return Err(RestError::Restless(rest.iter().filter_map(moved).collect()));
        }
        world.find_bottom();
        Ok(world)
    }

    fn check_rest(&self, start: &Self) -> Result<(), RestError> {
        let awake = self.loose().filter(|thing| !self.is_asleep(thing)).map(|thing| thing.id);
        let walking = self.agents.iter().filter(|(_, agent)| !agent.is_still()).map(|(id, _)| *id);
        let moving: Vec<NodeId> = awake.chain(walking).chain(self.driven.iter().map(|(id, _)| *id)).collect();
        if !moving.is_empty() || !self.engine.is_still() {
            return Err(RestError::Moves(moving));
        }
        if let Some((agent, _)) = self.effectors.keys().next() {
            return Err(RestError::Guided(*agent));
        }
        let drives = |id: &&NodeId| self.differs(start, id).unwrap_or(true) || !start.vehicles.contains_key(id);
        if let Some(id) = self.vehicles.keys().find(drives) {
            return Err(RestError::Vehicle(*id));
        }
        if self.agents.keys().ne(start.agents.keys()) {
            return Err(RestError::OtherWorld);
        }
        match self.stopped.iter().find(|id| !start.stopped.contains(id)) {
            Some(id) => Err(RestError::Stopped(*id)),
            None => Ok(()),
        }
    }

    fn difference(&self, start: &Self) -> RestRecord {
        let differs = |thing: &&Thing| self.differs(start, &thing.id).unwrap_or(true);
        let things = self.things.iter().filter(differs).map(|thing| self.recorded_thing(thing)).collect();
        let gone = |thing: &&Thing| self.index(thing.id).is_err();
        RestRecord {
            things,
            removed: start.things.iter().filter(gone).map(|thing| thing.id).collect(),
            agents: self.agents.iter().map(|(id, agent)| (*id, agent.clone())).collect(),
            waters: self.waters.clone(),
            ticks: self.ticks,
            stopped: self.stopped.clone(),
            skipped: self.skipped.clone(),
        }
    }

    pub(crate) fn recorded_thing(&self, thing: &Thing) -> RecordedThing {
        let mut thing = thing.clone();
        let poses: Vec<EnginePose> = self.rest_of(&thing).collect();
        thing.state.moving.iter_mut().for_each(|moving| (moving.target, moving.patience) = (None, 0));
        (thing.state.watch, thing.state.slept) = (Default::default(), poses.first().map(Spot::new));
        RecordedThing { thing, poses }
    }

    /// Where the bodies of a thing rest.
    fn rest_of<'a>(&'a self, thing: &'a Thing) -> impl Iterator<Item = EnginePose> + 'a {
        thing.bodies().filter_map(|body| self.engine.bodies.get(body)).map(|body| resting_pose(body.position()))
    }

    /// Whether a thing is another, or elsewhere, than at the start; `None` if it was not there.
    fn differs(&self, start: &Self, id: &NodeId) -> Option<bool> {
        let (now, was) = (self.thing(*id).ok()?, start.thing(*id).ok()?);
        let is = |t: &Thing| (t.state.role, t.state.rides, t.state.asset, t.state.scale, t.state.rests);
        let fastened = |(a, b): (&Moving, &Moving)| {
            (a.locked, a.latched, a.body.is_some()) == (b.locked, b.latched, b.body.is_some())
                && (a.body.is_some() || a.position == b.position)
        };
        let parts = now.state.moving.len() == was.state.moving.len()
            && now.state.moving.iter().zip(&was.state.moving).all(fastened);
        Some(is(now) != is(was) || !parts || !self.rest_of(now).eq(start.rest_of(was)))
    }

    pub(crate) fn take_out(&mut self, id: NodeId) {
        let Ok(index) = self.index(id) else { return };
        let thing = self.things.remove(index);
        thing.bodies().for_each(|body| self.engine.remove(body));
    }

    pub(crate) fn put_in(&mut self, recorded: &RecordedThing) {
        let RecordedThing { thing, poses } = recorded;
        let (Some(base), mut thing) = (poses.first(), thing.clone()) else { return };
        let ground = thing.state.ground;
        let deepened = if ground > 0.0 { thing.form.links[0].deepened(ground) } else { None };
        thing.state.base = self.add_base(&thing, deepened, base);
        joints::add_again(&mut self.engine, &mut thing, &self.settings, &poses[1..]);
        let at = self.things.partition_point(|other| other.id < thing.id);
        let parts = thing.state.moving.len();
        self.things.insert(at, thing);
        for part in 0..parts {
            // Where it is by its body, not where somebody once set it.
            let position = self.part_position(&self.things[at], part);
            let moving = &mut self.things[at].state.moving[part];
            moving.position = position.unwrap_or(moving.position);
            self.hold_part(at, part);
        }
    }

    /// Lets an agent stand, sit or lie as another does, with the same things in its hands.
    fn stand_in(&mut self, id: NodeId, recorded: &Agent) {
        let Some(own) = self.agents.get_mut(&id) else { return };
        let elsewhere = (own.feet, own.posture) != (recorded.feet, recorded.posture);
        *own = Agent { body: own.body, ..recorded.clone() };
        if elsewhere {
            self.embody(id, true);
        }
    }
}
