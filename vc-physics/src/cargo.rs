//! Things that leave a world for another as they move.

use rapier3d::dynamics::RigidBody;
use rapier3d::math::Vector;
use vc_graph::{AssetId, NodeId, Pose};

use crate::rest::RecordedThing;
use crate::world::PhysicsWorld;
use crate::{BodyRole, PhysicsError, convert};

/// Things that have left a world, with their velocities. [`PhysicsWorld::take_away`] makes it, [`PhysicsWorld::bring`] lets
/// them enter another world.
#[derive(Clone)]
pub struct Cargo(Vec<(RecordedThing, Vec<Motion>)>);

/// The velocity and the spin of a body; none while it sleeps.
type Motion = Option<(Vector, Vector)>;

impl Cargo {
    /// The same where the shapes of things have other numbers.
    #[must_use]
    pub fn with_assets(mut self, asset: impl Fn(NodeId) -> Option<AssetId>) -> Self {
        self.0.iter_mut().for_each(|(recorded, _)| recorded.thing.state.asset = asset(recorded.thing.id));
        self
    }
}

/// # Things that come and go
impl PhysicsWorld {
    /// Takes things out of the world as they are: with opened lids, pinned loads, and velocities; what
    /// sleeps goes on sleeping. Still water is left out.
    ///
    /// # Errors
    /// [`PhysicsError::NoBody`]; [`PhysicsError::NotFree`] for what is fixed or carried. Nothing has changed then.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// use nalgebra::Vector3;
    /// let mut other = world.clone();
    /// other.remove(home.cup)?;
    /// world.set_velocity(home.cup, Vector3::new(0.2, 0.0, 0.0), Vector3::zeros())?;
    /// let cargo = world.take_away(&[home.cup])?;
    /// other.bring(&cargo, &vc_graph::Pose::translation(0.0, 0.0, 0.1))?;
    /// assert_eq!(world.pose(home.cup), None);
    /// assert_eq!(other.body(home.cup)?.velocity(), Vector3::new(0.2, 0.0, 0.0));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn take_away(&mut self, ids: &[NodeId]) -> Result<Cargo, PhysicsError> {
        for id in ids {
            if !matches!(self.thing(*id)?.state.role, BodyRole::Loose | BodyRole::Hung) {
                return Err(PhysicsError::NotFree(*id));
            }
        }
        let recorded = |id: &NodeId| {
            let thing = self.thing(*id).ok()?;
            let bodies = thing.bodies().filter_map(|body| self.engine.bodies.get(body));
            let motion = |body: &RigidBody| (!body.is_sleeping()).then(|| (body.linvel(), body.angvel()));
            let motions = bodies.map(motion).collect();
            Some((self.recorded_thing(thing), motions))
        };
        let cargo = Cargo(ids.iter().filter_map(recorded).collect());
        for id in ids {
            self.take_out(*id);
            self.driven.retain(|(driven, _)| driven != id);
            self.drain(*id);
        }
        Ok(cargo)
    }

    /// Lets things that have left another world enter this one, moved as a whole by a transformation, and go on as they
    /// moved.
    ///
    /// # Errors
    /// [`PhysicsError::Duplicate`] if one of them is here already; nothing has changed then.
    pub fn bring(&mut self, cargo: &Cargo, shift: &Pose) -> Result<(), PhysicsError> {
        let ids = || cargo.0.iter().map(|(recorded, _)| recorded.thing.id);
        if let Some(here) = ids().find(|id| self.index(*id).is_ok()) {
            return Err(PhysicsError::Duplicate(here));
        }
        let shift = convert::pose(shift);
        for (recorded, motions) in &cargo.0 {
            self.put_in(&recorded.shifted(&shift));
            let bodies: Vec<_> = self.thing(recorded.thing.id)?.bodies().collect();
            for (body, motion) in bodies.into_iter().zip(motions) {
                if let Some(rigid) = self.engine.body_mut(body).filter(|rigid| rigid.is_dynamic()) {
                    match motion {
                        Some((velocity, spin)) => {
                            rigid.set_linvel(shift.rotation * *velocity, true);
                            rigid.set_angvel(shift.rotation * *spin, true);
                        }
                        None => rigid.sleep(),
                    }
                }
                self.engine.refresh(body);
            }
        }
        Ok(())
    }
}
