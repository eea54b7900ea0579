//! Reading one body.

use nalgebra::{Point3, Vector3};
use vc_graph::{NodeId, Pose, Side};

use crate::cloth::folded_scale;
use crate::state::Thing;
use crate::world::PhysicsWorld;
use crate::{Contact, PhysicsError, SupportSurface, convert};

/// The body of a thing in its present state, as [`PhysicsWorld::body`] gives it. Its pose, its role, its box and its
/// supports are with the world: [`pose`](PhysicsWorld::pose), [`role`](PhysicsWorld::role),
/// [`aabb`](PhysicsWorld::aabb), [`supports`](PhysicsWorld::supports).
#[derive(Clone, Copy)]
pub struct BodyView<'w> {
    world: &'w PhysicsWorld,
    thing: &'w Thing,
}

/// # Reading one body
impl PhysicsWorld {
    /// The body of a thing, to read it; agents have an [`agent`](Self::agent) view.
    ///
    /// # Errors
    /// [`PhysicsError::NoBody`].
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// // A cup weighs at most 0.3 kg by the class table.
    /// assert_eq!(world.body(home.cup)?.mass(), 0.3);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn body(&self, id: NodeId) -> Result<BodyView<'_>, PhysicsError> {
        Ok(BodyView { world: self, thing: self.thing(id)? })
    }
}

/// # Motion and mass
impl BodyView<'_> {
    /// Velocity of its centre of mass, metres a second.
    pub fn velocity(&self) -> Vector3<f32> {
        self.world.velocity(self.thing)
    }

    /// Angular velocity, radians a second around each axis of the world.
    pub fn angular_velocity(&self) -> Vector3<f32> {
        self.world.base(self.thing).map_or_else(Vector3::zeros, |base| convert::vector3(base.angvel()))
    }

    /// Whether it sleeps: it lies still until something disturbs it. Fixed bodies always do.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// assert!(!world.body(home.cup)?.is_asleep());
    /// world.settle(300);
    /// assert!(world.body(home.cup)?.is_asleep());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn is_asleep(&self) -> bool {
        self.world.is_asleep(self.thing)
    }

    /// Mass, its moving parts with it, kilograms.
    pub fn mass(&self) -> f32 {
        self.thing.mass()
    }

    /// Mass as its asset is modelled, by parts and densities, kilograms. It differs from [`mass`](Self::mass) where no
    /// member of the class has such a mass and [`Settings::class_masses`](crate::Settings::class_masses) is on.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// // A solid cylinder of wood, 600 kg a cubic metre.
    /// let modelled = std::f32::consts::PI * 0.04 * 0.04 * 0.1 * 600.0;
    /// assert!((world.body(home.cup)?.modelled_mass() - modelled).abs() < 1e-3);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn modelled_mass(&self) -> f32 {
        self.thing.form.mass()
    }

    /// Centre of mass of its base, in the world's frame, metres.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// assert!((world.body(home.cup)?.centre_of_mass().z - 0.791).abs() < 1e-4);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn centre_of_mass(&self) -> Point3<f32> {
        self.world.centre_of_mass(self.thing).unwrap_or_else(Point3::origin)
    }
}

/// # Form
impl BodyView<'_> {
    /// The box around its shapes in its own frame, moving parts where its asset has them: its lowest and its highest
    /// corner, metres.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// let (low, high) = world.body(home.cup)?.local_bounds();
    /// assert!((high.z - low.z - 0.1).abs() < 1e-4);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn local_bounds(&self) -> (Point3<f32>, Point3<f32>) {
        self.thing.form.extent
    }

    /// The point of its shapes, moving parts with them, that is nearest to a point; the point itself where a shape is
    /// around it. `None` for a body without shapes.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// let nearest = world.body(home.table)?.nearest_point(nalgebra::Point3::new(1.0, 0.2, 2.0)).ok_or("no shape")?;
    /// assert!((nearest - nalgebra::Point3::new(1.0, 0.2, 0.74)).norm() < 1e-4);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn nearest_point(&self, to: Point3<f32>) -> Option<Point3<f32>> {
        self.world.nearest_point(self.thing, to)
    }

    /// The height of its lowest point, metres: exact, however it is turned, where the [box](PhysicsWorld::aabb) around it may
    /// reach lower. `None` for a body without shapes.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// assert!((world.body(home.table)?.lowest().ok_or("no shape")?).abs() < 1e-4);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn lowest(&self) -> Option<f32> {
        self.world.lowest(self.thing)
    }

    /// The middle of a side of the box around it, in the world's frame, metres, and the direction out of it.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// use vc_graph::Side;
    /// let (top, up) = world.body(home.cup)?.side(Side::Top);
    /// assert!(up.z > 0.999 && (top.z - 0.84).abs() < 2e-3);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn side(&self, side: Side) -> (Point3<f32>, Vector3<f32>) {
        self.world.side_of(self.thing, side)
    }

    /// The scale along its own axes if it were cloth folded to a flat bundle with the volume that its mass takes, for
    /// [`reshape`](PhysicsWorld::reshape). `None` if it would be no smaller.
    pub fn folded_scale(&self) -> Option<Vector3<f32>> {
        folded_scale(self.thing)
    }

    /// The fill level of a container, 0 to 1; 0 if nobody has filled it.
    pub fn level(&self) -> f32 {
        self.world.waters.level(self.thing.id)
    }
}

/// # Places on it
impl BodyView<'_> {
    /// Its surfaces in the present state: those of a drawer move with it.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// let top = &world.body(home.table)?.support_surfaces()[0];
    /// assert!((top.pose.translation.z - 0.74).abs() < 1e-5);
    /// assert_eq!(top.half, (0.4, 0.7));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn support_surfaces(&self) -> Vec<SupportSurface> {
        self.world.surfaces(self.thing)
    }

    /// Places to sit on it, in the world's frame, metres: the middle of each seat, with X towards its front. Their
    /// number is that of the node's slots, at least one. They are distributed over the asset's level surfaces at the
    /// height of seats, or side by side on its box.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// let seats = world.body(home.chair)?.seats();
    /// assert_eq!(seats.len(), 1);
    /// assert!((seats[0].translation.z - 0.45).abs() < 1e-5);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn seats(&self) -> Vec<Pose> {
        self.world.places_on(self.thing, false)
    }

    /// Places to lie on it, in the world's frame, metres: the middle of each, with X along the body towards the feet.
    /// Their number is that of the node's slots, at least one.
    pub fn beds(&self) -> Vec<Pose> {
        self.world.places_on(self.thing, true)
    }
}

/// # Its place among others
impl BodyView<'_> {
    /// Its contacts as of the last step.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// world.settle(300);
    /// let contacts = world.body(home.cup)?.contacts();
    /// assert_eq!((contacts[0].a, contacts[0].b), (home.table, home.cup));
    /// assert!(contacts[0].normal.z > 0.99); // The table pushes the cup up.
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn contacts(&self) -> Vec<Contact> {
        self.world.contacts_of(self.thing)
    }

    /// Whether it is on one of another thing's surfaces (and not on things there), or inside the other: the middle of
    /// its box is over the surface or clearly in the space above it, and half of its corners are inside too.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// let cup = world.body(home.cup)?;
    /// assert!(cup.is_at(home.table, false) && !cup.is_at(home.cabinet, false));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn is_at(&self, at: NodeId, inside: bool) -> bool {
        self.world.shelf_of(self.thing, at, inside).is_some()
    }

    /// Whether it is among the things that are [outside](PhysicsWorld::outside).
    pub fn is_outside(&self) -> bool {
        self.world.is_outside(self.thing)
    }

    /// The things that leave no room for a hand at one of its sides.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// use vc_graph::Side;
    /// assert!(world.body(home.cup)?.things_at_side(Side::Left).is_empty());
    /// assert_eq!(world.body(home.table)?.things_at_side(Side::Top), [home.cup]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn things_at_side(&self, side: Side) -> Vec<NodeId> {
        self.world.things_at_side(self.thing, side)
    }

    /// Whether it would leave room for what opens if it were at a pose: no part of another node meets it between shut
    /// and open, and its own parts meet nothing fixed until they are half open.
    ///
    /// Costs some microseconds, and some ten for each part nearby.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// let cup = world.pose(home.cup).ok_or("no cup")?;
    /// assert!(world.body(home.cup)?.leaves_openings_free(&cup)); // No door opens over the table.
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn leaves_openings_free(&self, pose: &Pose) -> bool {
        self.world.leaves_openings_free(self.thing, pose)
    }

    /// The pose that it had in another moment of this world, moved along with its support or container since, or with
    /// the moving part of it that carried the thing. `None` if it would overlap anything there that it did not overlap
    /// then, or if the other thing had no body.
    ///
    /// # Errors
    /// [`PhysicsError::NoBody`] in the other moment, [`PhysicsError::NotFinite`].
    pub fn former_spot(&self, then: &PhysicsWorld, at: NodeId) -> Result<Option<Pose>, PhysicsError> {
        self.world.former_spot(then, self.thing.id, at)
    }
}
