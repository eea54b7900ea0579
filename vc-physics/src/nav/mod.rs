//! Navigation on the floor.

mod cover;
mod occupancy;
mod open;
mod stand;

use nalgebra::Point2;
use vc_geometry::grid::Raster;
use vc_geometry::outline::{Outline, crosses};
use vc_geometry::walk::{Bands, shortest};
use vc_graph::{Anthropometry, NodeId};

use crate::world::PhysicsWorld;
use cover::Cover;

pub use occupancy::Occupancy;
pub use stand::StandingPose;

/// The treatment of doors between rooms, and of open doors and drawers of furniture.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum DoorHandling {
    /// Walkers open doors between rooms, and close open doors and drawers of furniture: only locked ones are
    /// obstacles.
    #[default]
    Opened,
    /// They are obstacles in their present state.
    AsTheyAre,
}

/// The parameters of a floor and of its walkers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FloorOptions {
    /// Height of the floor, metres.
    pub level: f32,
    /// Height that is walked over without effort, metres: rugs, sills.
    pub step: f32,
    /// Height of the walker, metres: things that hang higher are not obstacles.
    pub height: f32,
    /// Clearance from all obstacles, metres: the body's radius and a little more.
    pub radius: f32,
    /// Side of a grid cell, metres.
    pub cell: f32,
    /// The treatment of doors.
    pub doors: DoorHandling,
}

impl Default for FloorOptions {
    fn default() -> Self {
        let Anthropometry { walked_over: step, headroom: height, clearance: radius, .. } = Anthropometry::ADULT;
        Self { level: 0.0, step, height, radius, cell: 0.05, doors: DoorHandling::default() }
    }
}

/// A path on the floor.
#[derive(Debug, Clone, PartialEq)]
pub struct Route {
    /// The path's corners, start and goal included, metres.
    pub points: Vec<Point2<f32>>,
    /// The path's length, metres.
    pub length: f32,
    /// The doors on the path, in order; closed ones have to be opened. The list includes furniture whose open
    /// doors or drawers have to be closed first.
    pub doors: Vec<NodeId>,
}

/// The walkable floor: the cells with enough clearance from all obstacles, and shortest paths over them.
///
/// Obstacles are taken from the bodies in their present state: every convex piece between the floor and the
/// walker's head, projected onto the floor and grown by the radius. A cell is free if its centre is, so every
/// point of the free floor keeps at least `radius - 0.71 * cell` away from everything.
///
/// A query returns the shortest any-angle path over the free cells, in some ten microseconds.
///
/// ```
/// use nalgebra::Point2;
/// use vc_physics::{Floor, FloorOptions};
/// let corner = |x: f32, y: f32| Point2::new(x, y);
/// let rectangle = |x0, y0, x1, y1| vec![corner(x0, y0), corner(x1, y0), corner(x1, y1), corner(x0, y1)];
/// let room = rectangle(0.0, 0.0, 4.0, 3.0);
/// let wall = rectangle(1.9, 0.0, 2.1, 2.0);
/// let floor = Floor::from_outlines(&[room], &[wall], FloorOptions::default());
/// let route = floor.route(corner(1.0, 0.5), corner(3.0, 0.5)).ok_or("no way")?;
/// assert!(route.points.len() > 3 && route.length > 4.0);
/// # Ok::<(), &str>(())
/// ```
#[derive(Debug, Clone)]
pub struct Floor {
    options: FloorOptions,
    covers: Vec<Cover>,
    ground: Vec<Outline>,
    raster: Option<Raster>,
    bands: Bands,
}

/// The largest distance of a start or a goal from a free cell, metres.
const SNAP: f32 = 0.6;

impl Floor {
    /// The floor of a world in its present state.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// use nalgebra::Point2;
    /// use vc_physics::{Floor, FloorOptions};
    /// let floor = Floor::new(&world, FloorOptions::default());
    /// assert!(floor.is_free(Point2::new(0.0, 0.0)) && !floor.is_free(Point2::new(1.0, 0.0)));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn new(world: &PhysicsWorld, options: FloorOptions) -> Self {
        let covers = cover::covers(world, &options);
        let ground = cover::ground(world, &options);
        Self::from_covers(options, covers, ground)
    }

    /// A floor from convex outlines, corners counter-clockwise, metres: the ground and the obstacles.
    pub fn from_outlines(ground: &[Vec<Point2<f32>>], obstacles: &[Vec<Point2<f32>>], options: FloorOptions) -> Self {
        let finite = |o: &&Vec<Point2<f32>>| o.iter().all(|p| p.x.abs() < 1e5 && p.y.abs() < 1e5);
        let cover = Cover::fixed(obstacles.iter().filter(finite).cloned().collect());
        Self::from_covers(options, vec![cover], ground.iter().filter(finite).cloned().collect())
    }

    fn from_covers(options: FloorOptions, covers: Vec<Cover>, ground: Vec<Outline>) -> Self {
        let corners = || ground.iter().flatten();
        let low = corners().copied().reduce(|a, b| a.inf(&b));
        let high = corners().copied().reduce(|a, b| a.sup(&b));
        let raster = low.zip(high).and_then(|(low, high)| Raster::over(low, high, options.cell));
        let mut floor = Self { options, covers, ground, raster, bands: Bands::default() };
        floor.paint();
        floor
    }

    /// Updates the floor to the things that have moved since: doors, chairs, things on the floor. Returns
    /// whether any had moved. Costs about a microsecond for ten bodies if none has moved, otherwise little less
    /// than making the floor anew.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// use nalgebra::Point2;
    /// let mut floor = vc_physics::Floor::new(&world, vc_physics::FloorOptions::default());
    /// world.place(home.chair, vc_graph::Pose::translation(0.0, -1.5, 0.0))?;
    /// assert!(floor.update(&world));
    /// assert!(floor.is_free(Point2::new(0.0, 1.3)) && !floor.is_free(Point2::new(0.0, -1.5)));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn update(&mut self, world: &PhysicsWorld) -> bool {
        let moved = cover::update(&mut self.covers, world, &self.options);
        if moved {
            self.paint();
        }
        moved
    }

    fn paint(&mut self) {
        let Some(raster) = &mut self.raster else { return };
        raster.clear();
        self.ground.iter().for_each(|o| raster.paint(o, 0.0, true));
        for outline in self.covers.iter().flat_map(|c| &c.outlines) {
            raster.paint(outline, self.options.radius, false);
        }
        self.bands = Bands::new(raster.cells());
    }

    /// The options from which the floor was made.
    pub fn options(&self) -> &FloorOptions {
        &self.options
    }

    /// Whether a walker can stand at a point.
    pub fn is_free(&self, point: Point2<f32>) -> bool {
        self.raster.as_ref().is_some_and(|r| r.holds(&point))
    }

    /// The free point nearest to a point within a distance, metres: the point itself, or the centre of a cell.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// let floor = vc_physics::Floor::new(&world, vc_physics::FloorOptions::default());
    /// let beside = floor.nearest(nalgebra::Point2::new(0.5, 0.0), 0.5).ok_or("no free floor")?;
    /// assert!(floor.is_free(beside) && beside.x < 0.5);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn nearest(&self, point: Point2<f32>, within: f32) -> Option<Point2<f32>> {
        self.raster.as_ref()?.nearest(&point, within)
    }

    /// Free area, square metres.
    pub fn area(&self) -> f32 {
        self.raster.as_ref().map_or(0.0, |r| r.cells().count() as f32 * r.cell() * r.cell())
    }

    /// The shortest path from one point to another. A point up to 0.6 m off the free floor (a person close to a
    /// table) is moved there first. `None` if there is no path.
    pub fn route(&self, from: Point2<f32>, to: Point2<f32>) -> Option<Route> {
        self.corners(from, to).map(|(points, length)| self.with_doors(points, length))
    }

    /// As [`route`](Self::route), but outside some circles of the floor, middles and radii in metres: people who stand
    /// there. The way may touch a circle by a cell of the floor's raster, and like `route` it ends up to 0.6 m off a point
    /// that is within one. The floor is cut up anew for that, which costs about a millisecond.
    ///
    /// ```
    /// use nalgebra::Point2;
    /// use vc_physics::{Floor, FloorOptions};
    /// let corner = |x: f32, y: f32| Point2::new(x, y);
    /// let room = vec![corner(0.0, 0.0), corner(4.0, 0.0), corner(4.0, 3.0), corner(0.0, 3.0)];
    /// let floor = Floor::from_outlines(&[room], &[], FloorOptions::default());
    /// let (from, to, middle) = (corner(1.0, 1.5), corner(3.0, 1.5), corner(2.0, 1.5));
    /// let round = floor.route_around(from, to, &[(middle, 0.5)]).ok_or("no way")?;
    /// assert!(round.length > 2.1 && round.points.iter().all(|p| (p - middle).norm() > 0.45));
    /// assert!(floor.route_around(from, to, &[(middle, 1.6)]).is_none());
    /// # Ok::<(), &str>(())
    /// ```
    pub fn route_around(&self, from: Point2<f32>, to: Point2<f32>, circles: &[(Point2<f32>, f32)]) -> Option<Route> {
        let mut raster = self.raster.clone()?;
        circles.iter().for_each(|(middle, radius)| raster.paint(&[*middle], *radius, false));
        let (points, length) = corners(&raster, &Bands::new(raster.cells()), from, to)?;
        Some(self.with_doors(points, length))
    }

    fn with_doors(&self, points: Vec<Point2<f32>>, length: f32) -> Route {
        let doors = self.doors_on(&points);
        Route { points, length, doors }
    }

    fn corners(&self, from: Point2<f32>, to: Point2<f32>) -> Option<(Vec<Point2<f32>>, f32)> {
        corners(self.raster.as_ref()?, &self.bands, from, to)
    }

    /// The doors that have to be opened or closed on a path, in order.
    fn doors_on(&self, points: &[Point2<f32>]) -> Vec<NodeId> {
        let mut found = Vec::new();
        for pair in points.windows(2) {
            let crossed = |c: &&Cover| c.gate.iter().any(|o| crosses(o, &pair[0], &pair[1]));
            let mut here: Vec<(f32, NodeId)> = self
                .covers
                .iter()
                .filter(crossed)
                .map(|c| (c.gate.first().map_or(0.0, |o| (o[0] - pair[0]).norm()), c.id))
                .collect();
            here.sort_by(|a, b| a.0.total_cmp(&b.0));
            found.extend(here.into_iter().map(|(_, id)| id));
        }
        found.dedup();
        found
    }
}

/// The corners of the shortest path over free cells, and its length, metres.
fn corners(raster: &Raster, bands: &Bands, from: Point2<f32>, to: Point2<f32>) -> Option<(Vec<Point2<f32>>, f32)> {
    let (start, goal) = (raster.nearest(&from, SNAP)?, raster.nearest(&to, SNAP)?);
    let (corners, length) = shortest(bands, raster.in_cells(&start), raster.in_cells(&goal))?;
    let mut points: Vec<Point2<f32>> = corners.into_iter().map(|c| raster.point(c)).collect();
    if let Some(first) = points.first_mut() {
        *first = start;
    }
    if let Some(last) = points.last_mut() {
        *last = goal;
    }
    if start != from {
        points.insert(0, from);
    }
    let length = (length * f64::from(raster.cell())) as f32 + (start - from).norm();
    Some((points, length))
}
