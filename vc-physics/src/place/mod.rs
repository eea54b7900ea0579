//! Placement: surfaces that hold things, free spots on them, overlaps, and things in one place.

mod close;
mod crowd;
mod former;
mod lower;
mod overlap;
mod raster;
mod search;
mod surface;
mod way;
mod wish;

use nalgebra::{Point3, UnitQuaternion, Vector3};
use vc_graph::asset::Hold;
use vc_graph::{NodeId, Pose, Seed};

use self::overlap::is_size;
use self::raster::{PITCH, spots};
use self::way::{HEAP, INTO, ONTO};
use crate::PhysicsError;
use crate::world::PhysicsWorld;

pub use surface::SupportSurface;
pub use wish::{SpotFault, SpotWish};

/// Gap that is left between a thing and its support, metres: the thing is at rest after a millimetre's fall.
const GAP: f32 = 0.001;
/// Clearance around a thing that is put down, metres: rims of plates do not touch, which are wider than the polygons
/// that stand for them here.
const AROUND: f32 = 0.015;
/// How far beside a surface the middle of a thing may be that is on it, metres.
const BESIDE: f32 = 0.005;

/// The order in which the spots of a surface are tried.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum SpotOrder {
    /// The middle first.
    Middle,
    /// Nearest to a point first.
    Near(Point3<f32>),
    /// At random, from a seed.
    Random(Seed),
}

/// # Free spots
impl PhysicsWorld {
    /// A pose at which a node stands free on a surface: within the surface's edges and clearance, clear of
    /// everything, turned by `yaw` radians against the surface. `None` if no spot is free.
    ///
    /// Spots are tried on a grid of four centimetres or coarser; each costs some microseconds.
    ///
    /// # Errors
    /// [`PhysicsError::NoBody`], [`PhysicsError::NoSuchSurface`],
    /// [`PhysicsError::NotFinite`].
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// use vc_physics::SpotOrder;
    /// let spot = world.free_spot(home.cup, home.table, 0, 0.0, SpotOrder::Middle)?.ok_or("the table is full")?;
    /// assert!(world.overlaps(home.cup, &spot)?.is_empty());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn free_spot(
        &self,
        id: NodeId,
        on: NodeId,
        surface: usize,
        yaw: f32,
        order: SpotOrder,
    ) -> Result<Option<Pose>, PhysicsError> {
        let thing = self.thing(id)?;
        let shelf = self.shelf(on, surface)?;
        let turn = turn(yaw, id)?;
        let free = |spot: &Pose| self.is_clear(thing, spot);
        Ok(spots(thing.form.extent, &shelf, &turn, (0.0, 0.0), PITCH, order).into_iter().find(free))
    }

    /// As [`Self::free_spot`], for a box with half lengths in metres instead of a node: the pose of its middle.
    ///
    /// # Errors
    /// [`PhysicsError::NoBody`], [`PhysicsError::NoSuchSurface`],
    /// [`PhysicsError::NotFinite`] of the yaw or of lengths that are not positive.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// let half = nalgebra::Vector3::new(0.1, 0.1, 0.1);
    /// let spot = world.free_spot_for(half, home.table, 0, 0.0, vc_physics::SpotOrder::Middle)?;
    /// assert!(spot.is_some_and(|spot| world.is_free(half, &spot)));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn free_spot_for(
        &self,
        half: Vector3<f32>,
        on: NodeId,
        surface: usize,
        yaw: f32,
        order: SpotOrder,
    ) -> Result<Option<Pose>, PhysicsError> {
        let shelf = self.shelf(on, surface)?;
        if !is_size(&half) {
            return Err(PhysicsError::NotFinite("the footprint", on));
        }
        let spots = spots((Point3::from(-half), Point3::from(half)), &shelf, &turn(yaw, on)?, (0.0, 0.0), PITCH, order);
        Ok(spots.into_iter().find(|spot| self.is_free(half, spot)))
    }

    /// As [`Self::free_spot`], on the first surface of a node that has a free spot: an inner one if `inside`,
    /// otherwise one on top. A thing that does not stand in a container is laid on its side; a thing that is wider
    /// than a surface is put on the middle of it and reaches over its edges. If no spot is left for the box around
    /// the thing, it is put [close](Self::packed_spot_where) to the things that are there.
    ///
    /// # Errors
    /// [`PhysicsError::NoBody`].
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// use vc_physics::SpotOrder;
    /// world.put_open(home.cabinet, 0, 1.0)?;
    /// let spot = world.free_spot_at(home.cup, home.cabinet, true, SpotOrder::Middle)?.ok_or("the drawer is full")?;
    /// world.place(home.cup, spot)?;
    /// assert!(world.is_at(home.cup, home.cabinet, true));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn free_spot_at(
        &self,
        id: NodeId,
        at: NodeId,
        inside: bool,
        order: SpotOrder,
    ) -> Result<Option<Pose>, PhysicsError> {
        self.free_spot_where(id, at, inside, order, |_| true)
    }

    /// As [`Self::free_spot_at`], at a spot that satisfies a condition, which is tested last.
    ///
    /// # Errors
    /// [`PhysicsError::NoBody`].
    pub fn free_spot_where(
        &self,
        id: NodeId,
        at: NodeId,
        inside: bool,
        order: SpotOrder,
        admits: impl Fn(&Pose) -> bool,
    ) -> Result<Option<Pose>, PhysicsError> {
        let apart = if inside {
            self.spot_by(&INTO, id, at, Hold::Inside, order, &admits)?
        } else {
            self.spot_by(&ONTO, id, at, Hold::On, order, &admits)?
        };
        if apart.is_some() { Ok(apart) } else { self.packed_spot_where(id, at, inside, order, admits) }
    }

    /// As [`Self::free_spot_where`], a little above the contents of a container: the thing is let down onto them.
    ///
    /// # Errors
    /// [`PhysicsError::NoBody`].
    pub fn heaped_spot_where(
        &self,
        id: NodeId,
        at: NodeId,
        order: SpotOrder,
        admits: impl Fn(&Pose) -> bool,
    ) -> Result<Option<Pose>, PhysicsError> {
        self.spot_by(&HEAP, id, at, Hold::Inside, order, &admits)
    }
}

/// A turn around the vertical.
fn turn(yaw: f32, of: NodeId) -> Result<UnitQuaternion<f32>, PhysicsError> {
    let sound = yaw.is_finite().then(|| UnitQuaternion::from_axis_angle(&Vector3::z_axis(), yaw));
    sound.ok_or(PhysicsError::NotFinite("the yaw", of))
}
