//! Ways over the floor.

pub(crate) mod avoid;
mod bands;
mod cover;
mod occupancy;
pub(crate) mod outline;
mod raster;
mod search;
mod spans;
mod stand;

use nalgebra::Point2;
use vc_graph::NodeId;

use crate::world::World;
use bands::Bands;
use cover::Cover;
use outline::Outline;
use raster::Raster;

pub use occupancy::Occupancy;
pub use stand::Stand;

/// How doors between rooms count, and doors and drawers of furniture that stand open.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Doors {
    /// Whoever walks opens the ones and shuts the others: only what is locked is in the
    /// way.
    #[default]
    Opened,
    /// They are in the way as they stand.
    AsTheyAre,
}

/// Which floor, for whom.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FloorPlan {
    /// Height of the floor, metres.
    pub level: f32,
    /// What one walks over without a thought, metres: rugs, sills.
    pub step: f32,
    /// Height of who walks, metres: what hangs higher is not in the way.
    pub height: f32,
    /// Distance kept from everything, metres: the radius of the body and a little.
    pub radius: f32,
    /// Side of a cell, metres.
    pub cell: f32,
    /// How doors count.
    pub doors: Doors,
}

impl Default for FloorPlan {
    fn default() -> Self {
        Self { level: 0.0, step: 0.05, height: 1.8, radius: 0.25, cell: 0.05, doors: Doors::default() }
    }
}

/// A way over the floor.
#[derive(Debug, Clone, PartialEq)]
pub struct Route {
    /// Its corners, start and goal included, metres.
    pub points: Vec<Point2<f32>>,
    /// Its length, metres.
    pub length: f32,
    /// Doors it goes through, in order; those that are shut have to be opened. Furniture
    /// with them whose open doors or drawers are to be shut before.
    pub doors: Vec<NodeId>,
}

/// The floor one can walk on: cells that keep clear of everything in the way, and the
/// shortest ways over them.
///
/// What stands in the way is taken from the bodies as they are: every convex piece
/// between the floor and the walker's head, seen from above and grown by the radius. A
/// cell is free if its centre is, so every point of the free floor keeps at least
/// `radius - 0.71 * cell` away from everything.
///
/// A query gives the shortest way there is over the free cells, at any angle, in some
/// ten microseconds.
///
/// ```
/// use nalgebra::Point2;
/// use vc_physics::{Floor, FloorPlan};
/// let corner = |x: f32, y: f32| Point2::new(x, y);
/// let rectangle = |x0, y0, x1, y1| vec![corner(x0, y0), corner(x1, y0), corner(x1, y1), corner(x0, y1)];
/// let room = rectangle(0.0, 0.0, 4.0, 3.0);
/// let wall = rectangle(1.9, 0.0, 2.1, 2.0);
/// let floor = Floor::of_outlines(&[room], &[wall], FloorPlan::default());
/// let route = floor.route(corner(1.0, 0.5), corner(3.0, 0.5)).ok_or("no way")?;
/// assert!(route.points.len() > 3 && route.length > 4.0);
/// # Ok::<(), &str>(())
/// ```
#[derive(Debug, Clone)]
pub struct Floor {
    plan: FloorPlan,
    covers: Vec<Cover>,
    ground: Vec<Outline>,
    raster: Option<Raster>,
    bands: Bands,
}

/// How far from a free cell a start or a goal may be, metres.
const SNAP: f32 = 0.6;

impl Floor {
    /// The floor of a world as it is.
    pub fn of(world: &World, plan: FloorPlan) -> Self {
        let covers = cover::covers(world, &plan);
        let ground = cover::ground(world, &plan);
        Self::new(plan, covers, ground)
    }

    /// A floor from convex outlines, corners counter-clockwise, metres: what one
    /// stands on, and what is in the way.
    pub fn of_outlines(ground: &[Vec<Point2<f32>>], obstacles: &[Vec<Point2<f32>>], plan: FloorPlan) -> Self {
        let finite = |o: &&Vec<Point2<f32>>| o.iter().all(|p| p.x.abs() < 1e5 && p.y.abs() < 1e5);
        let cover = Cover::fixed(obstacles.iter().filter(finite).cloned().collect());
        Self::new(plan, vec![cover], ground.iter().filter(finite).cloned().collect())
    }

    fn new(plan: FloorPlan, covers: Vec<Cover>, ground: Vec<Outline>) -> Self {
        let corners = || ground.iter().flatten();
        let low = corners().copied().reduce(|a, b| a.inf(&b));
        let high = corners().copied().reduce(|a, b| a.sup(&b));
        let raster = low.zip(high).and_then(|(low, high)| Raster::over(low, high, plan.cell));
        let mut floor = Self { plan, covers, ground, raster, bands: Bands::default() };
        floor.paint();
        floor
    }

    /// Follows what has moved since: doors, chairs, things on the floor. Gives whether
    /// anything had. Costs about a microsecond for ten bodies if nothing has, else
    /// little less than making the floor anew.
    pub fn update(&mut self, world: &World) -> bool {
        let moved = cover::update(&mut self.covers, world, &self.plan);
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
            raster.paint(outline, self.plan.radius, false);
        }
        self.bands = Bands::of(raster);
    }

    /// The plan it was made by.
    pub fn plan(&self) -> &FloorPlan {
        &self.plan
    }

    /// Whether one can stand at a point.
    pub fn is_free(&self, point: Point2<f32>) -> bool {
        self.raster.as_ref().is_some_and(|r| r.holds(&point))
    }

    /// The free point nearest to a point within a distance, metres: itself, or the
    /// middle of a cell.
    pub fn nearest(&self, point: Point2<f32>, within: f32) -> Option<Point2<f32>> {
        self.raster.as_ref()?.nearest(&point, within)
    }

    /// Free area, square metres.
    pub fn area(&self) -> f32 {
        self.raster.as_ref().map_or(0.0, |r| r.count() as f32 * r.cell * r.cell)
    }

    /// Number of rectangles the free floor consists of.
    pub fn bands(&self) -> usize {
        self.bands.all.len()
    }

    /// The shortest way from one point to another; a point up to 0.6 m off the free
    /// floor (one who stands close to a table) is brought there first. `None` if there
    /// is no way.
    pub fn route(&self, from: Point2<f32>, to: Point2<f32>) -> Option<Route> {
        let (points, length) = self.corners(from, to)?;
        let doors = self.doors_on(&points);
        Some(Route { points, length, doors })
    }

    fn corners(&self, from: Point2<f32>, to: Point2<f32>) -> Option<(Vec<Point2<f32>>, f32)> {
        let raster = self.raster.as_ref()?;
        let (start, goal) = (raster.nearest(&from, SNAP)?, raster.nearest(&to, SNAP)?);
        let (corners, length) = search::shortest(&self.bands, raster.cells(&start), raster.cells(&goal))?;
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
        let length = (length * f64::from(raster.cell)) as f32 + (start - from).norm();
        Some((points, length))
    }

    /// What has to be opened or shut on a way, in order.
    fn doors_on(&self, points: &[Point2<f32>]) -> Vec<NodeId> {
        let mut found = Vec::new();
        for pair in points.windows(2) {
            let crossed = |c: &&Cover| c.gate.iter().any(|o| outline::crosses(o, &pair[0], &pair[1]));
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
