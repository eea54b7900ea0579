//! Viewing directions: from a position into a room, and into an open thing.

use nalgebra::{Point2, Point3, Translation3, UnitQuaternion, Vector2, Vector3};
use vc_graph::portable::Portable;
use vc_graph::{NodeId, Pose, SceneGraph};
use vc_physics::PhysicsWorld;

/// Number of directions that are compared, and number of neighbours on each side that are in view with one.
const WAYS: i32 = 32;
const BESIDE: i32 = 3;
/// Heights of the viewing rays, metres: above tables, and below hanging things.
const HEIGHTS: [f32; 2] = [0.9, 1.5];
/// Largest viewing distance, metres.
const FAR: f32 = 4.0;
/// Weight of a thing in view, as metres of free sight.
const THING: f32 = 1.0;
/// Sample points inside a thing along each axis, as fractions of its size.
const INSIDE: [f32; 3] = [0.25, 0.5, 0.75];

/// The rotation with which an agent at a point of a room sees most of it: free floor and things.
pub(super) fn into_room(
    world: &PhysicsWorld,
    graph: &SceneGraph,
    room: NodeId,
    (agent, feet): (NodeId, Point3<f32>),
) -> UnitQuaternion<f32> {
    let ways: Vec<Vector2<f32>> = (0..WAYS).map(way).collect();
    let open: Vec<f32> = ways.iter().map(|way| free_sight(world, agent, &feet, way)).collect();
    let here: Point2<f32> = feet.xy();
    let middles = graph.in_room(room).filter_map(|id| Some(world.aabb(id)?.centre().xy()));
    let things: Vec<Vector2<f32>> = middles.filter_map(|at| (at - here).try_normalize(0.3)).collect();
    let narrow = way(BESIDE).x;
    let seen = |i: i32| {
        let free: f32 = (-BESIDE..=BESIDE).map(|by| open[(i + by).rem_euclid(WAYS) as usize]).sum();
        free + THING * things.iter().filter(|to| to.dot(&ways[i as usize]) >= narrow).count() as f32
    };
    let best = (0..WAYS).max_by(|a, b| seen(*a).total_cmp(&seen(*b)).then(b.cmp(a))).unwrap_or(0);
    super::execute::towards(ways[best as usize])
}

fn way(number: i32) -> Vector2<f32> {
    let (sine, cosine) = (std::f32::consts::TAU * number as f32 / WAYS as f32).sine_cosine();
    Vector2::new(cosine, sine)
}

/// The free viewing distance in a direction, metres, summed over all heights.
fn free_sight(world: &PhysicsWorld, agent: NodeId, feet: &Point3<f32>, way: &Vector2<f32>) -> f32 {
    let far = |height: f32| {
        let eye = feet + Vector3::z() * height;
        let met = world.ray(eye, eye + Vector3::new(way.x, way.y, 0.0) * FAR, &[agent]);
        met.map_or(FAR, |(_, at)| (at - eye).norm())
    };
    HEIGHTS.into_iter().map(far).sum()
}

/// How many of twenty-seven points inside a thing are visible from a given eye height above the feet, in a
/// world in which the thing stands open; its contents occlude nothing. `closed` is the bounding box of the
/// closed thing.
pub(super) fn into_thing(
    opened: &PhysicsWorld,
    graph: &SceneGraph,
    (id, closed): (NodeId, &vc_graph::Aabb),
    (feet, eye): (&Pose, f32),
) -> usize {
    let eye = feet * Translation3::new(0.0, 0.0, eye) * Point3::origin();
    let size = closed.max - closed.min;
    let at = |x: f32, y: f32, z: f32| closed.min + size.component_mul(&Vector3::new(x, y, z));
    let points = INSIDE.into_iter().flat_map(|x| INSIDE.into_iter().flat_map(move |y| INSIDE.map(|z| (x, y, z))));
    let agents: Vec<NodeId> = opened.agents().collect();
    let free = |to: Point3<f32>| match opened.ray(eye, to, &agents) {
        None => true,
        Some((met, _)) => met != id && graph.rests_at(met, id),
    };
    points.filter(|(x, y, z)| free(at(*x, *y, *z))).count()
}
