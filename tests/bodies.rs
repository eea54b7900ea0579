//! Generated apartments as worlds of bodies: they stay as they are, and every room can
//! be walked to.

#![allow(clippy::unwrap_used, reason = "tests stop where something is wrong")]

use nalgebra::Point2;
use virtualcity::graph::{NodeId, SceneGraph, Seed};
use virtualcity::physics::{Doors, Floor, FloorPlan, Settings, Shapes, World};
use virtualcity::procgen::Apartment;

fn home(seed: u64) -> Option<SceneGraph> {
    Apartment::from_seed(Seed(seed)).ok().map(|home| home.scene())
}

fn build(graph: &SceneGraph) -> World {
    World::build(graph, &Shapes::new(), Settings::default()).unwrap()
}

/// A generated home comes to rest in ten seconds but for a few things, and hardly one in
/// ten thousand falls: what stands on its edge, a rubber band that slips through.
#[test]
fn homes_come_to_rest() {
    let (mut things, mut fell) = (0, 0);
    for graph in (1..9).filter_map(home) {
        let mut world = build(&graph);
        let report = world.settle(600);
        assert!(report.stopped.is_empty(), "{report:?}");
        assert!(report.outside.is_empty(), "{:?}", report.outside);
        things += graph.len();
        fell += report.fell.len();
        assert!(world.awake() * 50 < graph.len(), "{} of {} awake", world.awake(), graph.len());
    }
    assert!(fell * 1000 < things, "{fell} of {things} things fell");
}

/// A free point of a room, the one nearest to its middle.
fn inside(graph: &SceneGraph, floor: &Floor, room: NodeId) -> Option<Point2<f32>> {
    let aabb = graph.node(room)?.aabb()?;
    let steps = |low: f32, high: f32| (0..=60).map(move |i| low + (high - low) * i as f32 / 60.0);
    let points =
        steps(aabb.min.x, aabb.max.x).flat_map(|x| steps(aabb.min.y, aabb.max.y).map(move |y| Point2::new(x, y)));
    let far = |p: &Point2<f32>| (p - aabb.centre().xy()).norm();
    points.filter(|p| floor.is_free(*p)).min_by(|a, b| far(a).total_cmp(&far(b)))
}

#[test]
fn every_room_can_be_walked_to() {
    for graph in (1..6).filter_map(home) {
        let world = build(&graph);
        let open = Floor::of(&world, FloorPlan::default());
        let places: Vec<Point2<f32>> = graph.rooms().iter().filter_map(|r| inside(&graph, &open, *r)).collect();
        assert_eq!(places.len(), graph.rooms().len(), "a room without floor in {}", graph.name());
        for (i, a) in places.iter().enumerate() {
            for (j, b) in places.iter().enumerate().skip(i + 1) {
                assert!(open.route(*a, *b).is_some(), "no way from room {i} to {j} in {}", graph.name());
            }
        }
        // Shut doors as they are leave fewer ways.
        let shut = Floor::of(&world, FloorPlan { doors: Doors::AsTheyAre, ..FloorPlan::default() });
        let ways = |floor: &Floor| places.iter().filter(|p| floor.route(places[0], **p).is_some()).count();
        assert!(ways(&shut) < ways(&open), "{}", graph.name());
    }
}
