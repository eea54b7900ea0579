//! Rest: things come to rest and fall asleep, or are put to sleep where they are known to be at rest.

mod damping;
mod island;
mod progress;
mod recorded;
mod sleep;
mod written;

use rapier3d::dynamics::RigidBodyHandle;
use vc_graph::{NodeId, Pose};

use crate::world::PhysicsWorld;
use crate::{BodyRole, PhysicsError, convert, group};

pub use progress::RestProgress;
pub(crate) use recorded::RecordedThing;
pub use recorded::RestRecord;

/// # Rest
impl PhysicsWorld {
    /// Puts everything to sleep in its present state, for a scene that is known to be at rest: one step passes,
    /// which finds the contacts, and then nothing moves until it is disturbed. (Bodies inserted asleep would
    /// have no contacts.)
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// world.rest();
    /// assert_eq!(world.awake(), 0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn rest(&mut self) {
        self.step();
        self.sleep(&[]);
    }

    /// Puts all to sleep where it is that has been stepped since it was moved last, but some things.
    fn sleep(&mut self, but: &[NodeId]) {
        let spared = |world: &Self, body: &RigidBodyHandle| {
            let rigid = world.engine.bodies.get(*body);
            rigid.is_some_and(|rigid| but.contains(&group::marked(rigid.user_data).0))
        };
        let all: Vec<RigidBodyHandle> = self.engine.awake_bodies().filter(|body| !spared(self, body)).collect();
        self.engine.put_to_sleep(&all);
        self.record_sleepers(&all);
    }

    /// Puts things to sleep at poses at which they are known to be at rest, and lets agents stand at them; everything
    /// else [rests](Self::rest) where it is.
    ///
    /// The poses hold to the bit until the next step. The engine takes a pose that is written for a change by the user
    /// and wakes what is near, so that most loose things differ in their last bits a step later.
    ///
    /// # Errors
    /// As [`Self::place`].
    pub fn rest_at(&mut self, poses: &[(NodeId, Pose)]) -> Result<(), PhysicsError> {
        self.put_at(poses)?;
        self.rest();
        self.write_at_rest(poses)
    }

    /// Puts things to poses; those on what moves with others stay so. Agents stay where they are. A step later they can be
    /// [held](Self::hold_still) there.
    ///
    /// # Errors
    /// As [`Self::place`]; nothing has moved then.
    pub fn put_at(&mut self, poses: &[(NodeId, Pose)]) -> Result<(), PhysicsError> {
        for (id, pose) in poses {
            if !self.agents.contains_key(id) && self.thing(*id)?.state.role == BodyRole::Carried {
                return Err(PhysicsError::NotFree(*id));
            }
            if !convert::is_sound(pose) {
                return Err(PhysicsError::NotFinite("the pose", *id));
            }
        }
        for (id, pose) in poses.iter().filter(|(id, _)| !self.agents.contains_key(id)).collect::<Vec<_>>() {
            let rides = self.thing(*id)?.state.rides;
            self.place(*id, *pose)?;
            self.thing_mut(*id)?.state.rides = rides;
        }
        Ok(())
    }

    /// Holds still what has been put to poses before the last step, exactly there, and all else where it is but some things that are in
    /// flight.
    ///
    /// # Errors
    /// [`PhysicsError::NoBody`].
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// use vc_graph::Pose;
    /// let in_the_air = Pose::translation(1.0, 0.3, 1.2);
    /// world.place(home.cup, in_the_air)?;
    /// world.step();
    /// world.hold_still(&[(home.cup, in_the_air)], &[])?;
    /// assert_eq!((world.awake(), world.pose(home.cup)), (0, Some(in_the_air)));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn hold_still(&mut self, poses: &[(NodeId, Pose)], but: &[NodeId]) -> Result<(), PhysicsError> {
        self.sleep(but);
        self.write_at_rest(poses)
    }

    /// Writes poses without waking anything.
    fn write_at_rest(&mut self, poses: &[(NodeId, Pose)]) -> Result<(), PhysicsError> {
        for (id, pose) in poses {
            let body = match self.agents.get_mut(id) {
                Some(agent) => {
                    agent.feet = *pose;
                    agent.body
                }
                None => self.thing(*id)?.state.base,
            };
            if let Some(rigid) = self.engine.body_mut(body) {
                rigid.set_position(convert::pose(pose), false);
            }
            self.engine.refresh(body);
        }
        Ok(())
    }
}
