//! Reading doors, lids and drawers.

use vc_graph::{NodeId, Pose, State};

use crate::world::PhysicsWorld;
use crate::{MovingPart, PhysicsError};

/// The moving parts of a node in their present state, as [`PhysicsWorld::parts`] gives them. A node without a body
/// has none.
#[derive(Clone, Copy)]
pub struct PartsView<'w> {
    world: &'w PhysicsWorld,
    id: NodeId,
}

/// # Reading doors, lids and drawers
impl PhysicsWorld {
    /// The moving parts of a node: doors, lids and drawers, to read them.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// use vc_graph::State;
    /// assert_eq!(world.parts(home.cabinet).state(), Some(State::Closed));
    /// assert_eq!(world.parts(home.table).state(), None);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn parts(&self, id: NodeId) -> PartsView<'_> {
        PartsView { world: self, id }
    }
}

impl PartsView<'_> {
    /// All of them, in the asset's order; empty if there are none.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// let parts = world.parts(home.cabinet).all();
    /// assert_eq!((parts.len(), &*parts[0].name, parts[0].limits), (1, "drawer", (0.0, 0.3)));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn all(&self) -> Vec<MovingPart> {
        self.world.moving_parts(self.id)
    }

    /// The pose of a part in the world's frame: that of its asset's origin, moved as the part has moved. Numbers are
    /// those of [`all`](Self::all).
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// world.put_open(home.cabinet, Some(0), 1.0)?;
    /// let drawer = world.parts(home.cabinet).pose(0).ok_or("no such part")?;
    /// assert!((drawer.translation.x - -1.2).abs() < 1e-4); // The cabinet is at -1.5, and the drawer slides out 0.3 m.
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn pose(&self, part: usize) -> Option<Pose> {
        self.world.part_pose(self.id, part)
    }

    /// The opening of the most open part, 0 to 1; `None` if there are no parts.
    pub fn openness(&self) -> Option<f32> {
        self.world.openness(self.id)
    }

    /// The state of the parts in the graph's terms: open, closed, or `None` if there are no parts.
    pub fn state(&self) -> Option<State> {
        self.world.open_state(self.id)
    }

    /// Whether a motor drives a part.
    pub fn is_driven(&self) -> bool {
        self.world.is_driven(self.id)
    }

    /// The openness that [`set_openness`](PhysicsWorld::set_openness) would give each part, 0 to 1, in the order of
    /// [`all`](Self::all), while the world stays as it is; `None` where that would return false. A node without moving
    /// parts has nothing to open: an empty list.
    ///
    /// The motions follow each other in the plan: a drawer behind a door is tested with the door and its contents out
    /// of the way. Costs some ten microseconds for each part; the world is not copied.
    ///
    /// # Errors
    /// As [`PhysicsWorld::drive`].
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// assert_eq!(world.parts(home.cabinet).plan(1.0, &[])?, Some(vec![1.0]));
    /// // The person would be in the way of the drawer, unless they are ignored.
    /// world.teleport(home.person, vc_graph::Pose::translation(-1.0, 0.0, 0.0))?;
    /// let drawer = world.parts(home.cabinet);
    /// assert_eq!(drawer.plan(1.0, &[])?, None);
    /// assert_eq!(drawer.plan(1.0, &[home.person])?, Some(vec![1.0]));
    /// assert_eq!(drawer.openness(), Some(0.0));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn plan(&self, open: f32, ignored: &[NodeId]) -> Result<Option<Vec<f32>>, PhysicsError> {
        self.world.plan_openness(self.id, open, ignored)
    }

    /// The nodes that block the parts on the way to a fraction of their range, 0 to 1, sorted by number: the first
    /// obstacles of the parts and of the things they carry. Empty if the way is free.
    ///
    /// # Errors
    /// As [`PhysicsWorld::drive`].
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// world.teleport(home.person, vc_graph::Pose::translation(-1.0, 0.0, 0.0))?;
    /// assert_eq!(world.parts(home.cabinet).blockers(1.0)?, [home.person]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn blockers(&self, open: f32) -> Result<Vec<NodeId>, PhysicsError> {
        self.world.blockers(self.id, open)
    }

    /// The nodes into which the parts reach when they are shut, by more than some metres, sorted by number.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// let drawer = world.pose(home.cabinet).ok_or("no cabinet")?;
    /// assert!(world.parts(home.cabinet).reach_into_when_shut(0.01).is_empty());
    /// world.place(home.cup, drawer * vc_graph::Pose::translation(0.0, 0.0, 0.16))?;
    /// assert_eq!(world.parts(home.cabinet).reach_into_when_shut(0.01), [home.cup]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn reach_into_when_shut(&self, deeper: f32) -> Vec<NodeId> {
        self.world.met_when_shut(self.id, deeper)
    }

    /// Whether a thing at a pose would keep the parts from being shut: if it stands on a drawer or a rack, on the way
    /// in, and otherwise where the open parts have to go. Nothing keeps open what is shut, or has no parts that move.
    ///
    /// Costs some microseconds for each open part.
    ///
    /// # Errors
    /// [`PhysicsError::NoBody`].
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// use vc_physics::SpotSearch;
    /// world.put_open(home.cabinet, None, 1.0)?;
    /// let spot = SpotSearch::new(home.cup, home.cabinet, true).find(&world)?.ok_or("the drawer is full")?;
    /// assert!(!world.parts(home.cabinet).are_kept_open_by(home.cup, &spot)?);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn are_kept_open_by(&self, id: NodeId, pose: &Pose) -> Result<bool, PhysicsError> {
        self.world.keeps_open(id, self.id, pose)
    }
}
