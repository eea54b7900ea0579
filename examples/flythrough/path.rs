//! The path of the camera.

use nalgebra::{Point2, Point3};
use virtualcity::graph::{NodeId, SceneGraph, State};
use virtualcity::physics::{DoorHandling, Floor, FloorOptions, PhysicsWorld, Route, Settings, ShapeCache};
use virtualcity::render::Camera;

use crate::support::Complaint;

/// Height of the eye, metres.
const EYE: f32 = 1.5;
/// A path over the floor.
pub(crate) struct Walk {
    points: Vec<Point2<f32>>,
    pub(crate) rooms: usize,
}

/// Distances kept from everything, metres: the smaller one where open doors leave no wider way.
const RADII: [f32; 2] = [0.3, 0.15];

/// The path through the rooms; doors on it are opened, and it goes around their leaves.
pub(crate) fn through(scene: &mut SceneGraph) -> Result<Walk, Complaint> {
    let mut world = PhysicsWorld::build(scene, &ShapeCache::new(), Settings::default()).map_err(Complaint::new)?;
    let wanted = FloorOptions { radius: RADII[0], ..FloorOptions::default() };
    let first =
        Tour::longest(scene, &Floor::new(&world, wanted)).ok_or_else(|| Complaint::new("no room has free floor"))?;
    let mut edit = scene.edit();
    for door in &first.doors {
        edit.enter_state(*door, State::Open).map_err(Complaint::new)?;
        world.put_open(*door, None, 1.0).map_err(Complaint::new)?;
    }
    edit.commit();
    let around = RADII.map(|radius| FloorOptions { radius, doors: DoorHandling::AsTheyAre, ..FloorOptions::default() });
    let tours = around.iter().filter_map(|plan| Tour::longest(scene, &Floor::new(&world, *plan)));
    // A tour that reaches fewer rooms because a leaf is in its way is no better than one through the leaf.
    let best = tours.chain([first]).reduce(|a, b| if b.rooms > a.rooms { b } else { a });
    let Tour { points, rooms, .. } = best.ok_or_else(|| Complaint::new("no room has free floor"))?;
    Ok(Walk { points, rooms })
}

/// A tour of the rooms.
struct Tour {
    points: Vec<Point2<f32>>,
    doors: Vec<NodeId>,
    rooms: usize,
}

impl Tour {
    /// From the middle of the room from which most rooms can be reached.
    fn longest(scene: &SceneGraph, floor: &Floor) -> Option<Self> {
        let middle = |room: &NodeId| {
            let around = scene.node(*room)?.aabb()?.centre();
            floor.nearest(Point2::new(around.x, around.y), 1.5)
        };
        let middles: Vec<Point2<f32>> = scene.rooms().iter().filter_map(middle).collect();
        let tours = (0..middles.len()).map(|first| Self::from(floor, &middles, first));
        tours.reduce(|a, b| if b.rooms > a.rooms { b } else { a })
    }

    /// Goes to the nearest unvisited room each time, as long as one can be reached.
    fn from(floor: &Floor, middles: &[Point2<f32>], first: usize) -> Self {
        let mut left = middles.to_vec();
        let mut tour = Self { points: vec![left.swap_remove(first)], doors: Vec::new(), rooms: 1 };
        while let Some(route) = nearest(floor, tour.points[tour.points.len() - 1], &mut left) {
            tour.points.extend_from_slice(&route.points[1..]);
            tour.doors.extend(route.doors);
            tour.rooms += 1;
        }
        tour
    }
}

/// The shortest route to one of the remaining places, which it removes from them.
fn nearest(floor: &Floor, from: Point2<f32>, left: &mut Vec<Point2<f32>>) -> Option<Route> {
    let ways = left.iter().enumerate().filter_map(|(i, to)| floor.route(from, *to).map(|r| (i, r)));
    let (index, route) = ways.min_by(|a, b| a.1.length.total_cmp(&b.1.length))?;
    left.swap_remove(index);
    Some(route)
}

impl Walk {
    /// Length, metres.
    pub(crate) fn length(&self) -> f32 {
        self.points.windows(2).map(|p| (p[1] - p[0]).norm()).sum()
    }

    /// Cameras along the path, `step` metres apart, at most `most`; a longer path has longer steps.
    pub(crate) fn cameras(&self, camera: Camera, step: f32, most: usize) -> Vec<Camera> {
        let way: Vec<Point3<f32>> = self.points.iter().map(|p| Point3::new(p.x, p.y, EYE)).collect();
        camera.along(&way, ((self.length() / step) as usize + 1).clamp(2, most))
    }
}
