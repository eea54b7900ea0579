//! Scenes as worlds of bodies: generated apartments keep their layout, every room can be reached on foot, and
//! relations use the supports found by physics.

#![allow(clippy::unwrap_used, reason = "tests stop where something is wrong")]

mod dropped;

use nalgebra::{Point2, UnitQuaternion, Vector3};
use vc_testkit::amount;
use virtualcity::graph::{Bounds, Draft, NodeId, Pose, Relation, SceneBuilder, SceneGraph, Seed};
use virtualcity::physics::{DoorHandling, Floor, FloorOptions, MovingPart, PhysicsWorld, Settings, ShapeCache};
use virtualcity::procgen::Apartment;
use virtualcity::relations::{ContactEvidence, Evidence, RelationRule, Relations, SupportKind};

fn home(seed: u64) -> Option<SceneGraph> {
    Apartment::from_seed(Seed(seed)).ok().map(|home| home.scene())
}

fn build(graph: &SceneGraph) -> PhysicsWorld {
    PhysicsWorld::build(graph, &ShapeCache::new(), Settings::default()).unwrap()
}

/// A generated home comes to rest within ten seconds except for a few objects, and hardly one in ten thousand
/// falls: an object standing on its edge, a rubber band that slips through.
#[test]
fn homes_come_to_rest() {
    let (mut things, mut fell) = (0, 0);
    for graph in (1..amount(4, 9)).filter_map(home) {
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

/// The free point of a room that is nearest to its middle.
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
    for graph in (1..amount(3, 6)).filter_map(home) {
        let world = build(&graph);
        let open = Floor::new(&world, FloorOptions::default());
        let places: Vec<Point2<f32>> = graph.rooms().iter().filter_map(|r| inside(&graph, &open, *r)).collect();
        assert_eq!(places.len(), graph.rooms().len(), "a room without floor in {}", graph.name());
        for (i, a) in places.iter().enumerate() {
            for (j, b) in places.iter().enumerate().skip(i + 1) {
                assert!(open.route(*a, *b).is_some(), "no way from room {i} to {j} in {}", graph.name());
            }
        }
        // With closed doors fewer routes exist.
        let shut = Floor::new(&world, FloorOptions { doors: DoorHandling::AsTheyAre, ..FloorOptions::default() });
        let ways = |floor: &Floor| places.iter().filter(|p| floor.route(places[0], **p).is_some()).count();
        assert!(ways(&shut) < ways(&open), "{}", graph.name());
    }
}

/// The contacts of a world as evidence for relations: physics gives magnitude and direction, relations need the
/// impulse on the second of the two bodies.
fn told(world: &PhysicsWorld) -> Evidence {
    let contacts = world.contacts().into_iter();
    let contact =
        |c: virtualcity::physics::Contact| ContactEvidence { between: (c.a, c.b), impulse: c.normal * c.impulse };
    Evidence { contacts: contacts.map(contact).collect(), ..Evidence::default() }
}

/// A plank on two tables and a ladder leaning on a wall, slightly above their rest positions.
fn leaning() -> (SceneGraph, [NodeId; 6]) {
    let mut scene = SceneBuilder::new("workshop");
    let mut put = |class: &str, size: [f32; 3], pose: Pose| {
        scene.add(Draft::new(class).bounds(Bounds::standing(size.into())).at(pose)).unwrap()
    };
    let floor = put("floor", [8.0, 8.0, 0.1], Pose::translation(0.0, 0.0, -0.1));
    let wall = put("wall", [0.1, 4.0, 2.5], Pose::translation(2.05, 0.0, 0.0));
    let tables = [-0.8, 0.8].map(|y| put("kitchen_table", [0.6, 0.6, 0.75], Pose::translation(0.0, y, 0.0)));
    let plank = put("plank", [0.2, 2.2, 0.04], Pose::translation(0.0, 0.1, 0.752));
    let tilt = UnitQuaternion::from_axis_angle(&Vector3::y_axis(), 20.0_f32.to_radians());
    let foot = Vector3::new(1.285, 0.0, 0.0125);
    let ladder = put("ladder", [0.06, 0.4, 2.0], Pose::from_parts(foot.into(), tilt));
    (scene.build(), [floor, wall, tables[0], tables[1], plank, ladder])
}

#[test]
fn contacts_of_bodies_tell_relations_what_rests_where() {
    let (mut graph, [floor, wall, left, right, plank, ladder]) = leaning();
    let mut world = build(&graph);
    let report = world.settle(900);
    assert!(report.fell.is_empty() && report.stopped.is_empty(), "{report:?}");
    let mut edit = graph.edit();
    world.poses().into_iter().for_each(|(id, pose)| edit.set_pose(id, Some(pose)).unwrap());
    edit.commit();
    let relations = Relations::new(&graph, RelationRule::Contacts, told(&world)).unwrap();
    for (id, expected) in [(plank, vec![left, right]), (ladder, vec![floor])] {
        let supports = relations.supports(id);
        assert!(supports.iter().all(|s| s.kind == SupportKind::Contact), "{supports:?}");
        let mut by: Vec<NodeId> = supports.iter().map(|s| s.by).collect();
        let mut physical = world.supports(id);
        by.sort_unstable();
        physical.sort_unstable();
        assert_eq!(by, expected, "{supports:?}");
        assert_eq!(physical, expected);
    }
    // The plank lies a little more on the right table.
    let share = |by| relations.supports(plank).iter().find(|s| s.by == by).unwrap().share;
    assert!(share(left) > 0.3 && share(right) > share(left), "{:?}", relations.supports(plank));
    // The wall pushes the ladder, but not up.
    assert!(world.body(ladder).unwrap().contacts().iter().any(|c| (c.a, c.b) == (wall, ladder) && c.impulse > 0.0));
    let leans = relations.between(ladder, wall);
    assert!(leans.contains(&Relation::Touching) && !leans.contains(&Relation::On), "{leans:?}");
}

/// A plan says of every piece of furniture how far it opens, shuts, or that it does not; the world stays as it is.
#[test]
fn plans_of_openness_come_true_in_homes() {
    let (mut opened, mut stuck) = (0, 0);
    for graph in (1..amount(2, 4)).filter_map(home) {
        let mut world = build(&graph);
        world.settle(300);
        let past: Vec<NodeId> = graph.agents().to_vec();
        let before = world.digest();
        for id in world.nodes().into_iter().filter(|id| !world.parts(*id).all().is_empty()).collect::<Vec<_>>() {
            let mut copy = world.clone();
            for open in [1.0, 0.3, 0.0] {
                let plan = copy.parts(id).plan(open, &past).unwrap();
                let did = copy.set_openness(id, open, &past).unwrap();
                assert_eq!(plan.is_some(), did, "{} of {}, {open}", graph.label(id), graph.name());
                let now = copy.parts(id).all();
                let far = |(plan, part): (&f32, &MovingPart)| (plan - part.open).abs();
                let most = plan.iter().flatten().zip(&now).map(far).fold(0.0, f32::max);
                assert!(most < 1e-3, "{} of {}, {open}: {plan:?}, {now:?}", graph.label(id), graph.name());
                (opened, stuck) = (opened + usize::from(did), stuck + usize::from(!did));
            }
            assert_eq!(world.parts(id).plan(1.0, &past).map(drop), Ok(()));
        }
        assert_eq!(world.digest(), before);
    }
    assert!(opened > amount(30, 100), "{opened} opened or shut, {stuck} stuck");
}
