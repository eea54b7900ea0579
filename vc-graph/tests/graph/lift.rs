//! Stairs and lifts as portals: a building with a landing on each storey, stairs from each to the next, and a cabin that
//! moves.

#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use std::collections::BTreeMap;
use std::f32::consts::PI;

use nalgebra::{Point3, Vector3};
use proptest::prelude::*;
use vc_graph::space::{
    PassError, Portal, PortalId, PortalKind, PortalSide, Region, RegionFrame, RegionGraphs, RegionId, RegionKind,
    Space, SpaceBuilder, SpaceError,
};
use vc_graph::{ClassTable, Draft, NodeId, Place, Pose, Relation, SceneBuilder, SceneGraph, State};
use vc_testkit::cases;

const STOREYS: u32 = 8;
const HEIGHT: f64 = 3.0;
const CABIN: RegionId = RegionId(1 + STOREYS);

fn landing(storey: u32) -> RegionId {
    RegionId(1 + storey)
}

fn side(region: RegionId, x: f32, z: f32, heading: f32) -> PortalSide {
    let pose = Pose::translation(x, 0.0, z) * Pose::rotation(Vector3::new(0.0, 0.0, heading));
    PortalSide { region, pose, room: None }
}

/// Landings of ten by ten metres; stairs at their east end lead back over themselves, the lift is in the west.
fn building() -> Space {
    let mut plan = SpaceBuilder::new();
    let house = Region::new(RegionKind::Building, "house").at(RegionFrame::new([4000.0, -3000.0, 60.0], 0.65));
    let house = plan.add(house).unwrap();
    let frames: Vec<RegionFrame> =
        (0..STOREYS).map(|storey| RegionFrame::new([0.0, 0.0, HEIGHT * f64::from(storey)], 0.0)).collect();
    for frame in &frames {
        plan.add(Region::new(RegionKind::Corridor, "landing").within(house).at(*frame).with_numbers(100)).unwrap();
    }
    let stops: Vec<RegionFrame> =
        frames.iter().map(|frame| RegionFrame::new([-1.5, 0.0, frame.origin.z], 0.0)).collect();
    let cabin = Region::new(RegionKind::Stairwell, "cabin").within(house).moving(stops).with_numbers(100);
    assert_eq!(plan.add(cabin).unwrap(), CABIN);
    for storey in 0..STOREYS {
        let door = Portal::new(
            PortalKind::Landing,
            [side(landing(storey), 0.0, 0.0, PI), side(CABIN, 1.5, 0.0, 0.0)],
            0.9,
            2.1,
        );
        plan.join(door.with_leaf(leaf(storey)).at_stop(storey)).unwrap();
    }
    for storey in 1..STOREYS {
        let sides = [side(landing(storey - 1), 8.0, HEIGHT as f32, PI), side(landing(storey), 8.0, 0.0, 0.0)];
        let way = [(8.0, 0.0), (10.0, 1.5), (8.0, 3.0)].map(|(x, z)| Point3::new(x, 1.0, z));
        plan.join(Portal::new(PortalKind::Landing, sides, 1.1, 2.1).over_stairs(way)).unwrap();
    }
    plan.build()
}

/// The first node of each landing is the lift's door there.
fn leaf(storey: u32) -> NodeId {
    NodeId(100 * storey + 1)
}

fn scene(space: &Space, region: RegionId) -> SceneGraph {
    let mut scene = SceneBuilder::new("scene");
    scene.numbers(space.region(region).unwrap().numbers);
    if region != CABIN {
        scene.add(Draft::new("door").at(Pose::identity())).unwrap();
    }
    scene.add(Draft::new("hallway").at(Pose::translation(5.0, 0.0, 0.0))).unwrap();
    scene.build()
}

/// A world in which all is active, and somebody with a tray of glasses on the ground.
fn world() -> (RegionGraphs, NodeId) {
    let space = building();
    let mut world = RegionGraphs::new(space.clone().into());
    for region in (0..STOREYS).map(landing).chain([CABIN]) {
        world.insert(region, scene(&space, region)).unwrap();
    }
    let mut edit = world.edit(landing(0)).unwrap();
    let room = edit.graph().rooms()[0];
    let me = edit.add(Draft::new("character").at(Pose::translation(0.5, 0.0, 0.0))).unwrap();
    edit.move_to_room(me, room).unwrap();
    let tray = edit.add(Draft::new("tray").at(Pose::translation(0.8, 0.1, 1.0))).unwrap();
    edit.hold(me, tray).unwrap();
    for glass in 0..4_u8 {
        let at = Pose::translation(0.8, 0.1 * f32::from(glass), 1.02);
        let glass = edit.add(Draft::new("water_glass").at(at)).unwrap();
        edit.place(glass, Place { relation: Relation::On, at: tray }).unwrap();
    }
    edit.commit();
    (world, me)
}

fn door(storey: u32) -> PortalId {
    PortalId(storey)
}

fn open(world: &mut RegionGraphs, storey: u32, is_open: bool) {
    let mut edit = world.edit(landing(storey)).unwrap();
    edit.enter_state(leaf(storey), if is_open { State::Open } else { State::Closed }).unwrap();
    edit.commit();
}

/// Where everything that somebody carries is, from there on.
fn load(world: &RegionGraphs, me: NodeId) -> BTreeMap<NodeId, Vector3<f32>> {
    let graph = world.graph(world.region_of(me).unwrap()).unwrap();
    let at = |id: NodeId| graph.node(id).and_then(|node| node.position()).unwrap();
    graph.carried_with(me).into_iter().map(|id| (id, at(id) - at(me))).collect()
}

#[test]
fn a_lift_lets_through_only_where_it_stops_and_with_its_door_open() {
    let (mut world, me) = world();
    let state = |world: &RegionGraphs, storey| world.portal(door(storey)).unwrap().passable;
    assert!(!state(&world, 0), "the door is shut");
    (0..STOREYS).for_each(|storey| open(&mut world, storey, true));
    assert!(state(&world, 0) && !state(&world, 5), "doors are open, and the cabin is on the ground");
    assert_eq!(
        world.pass(me, door(5)),
        Err(PassError::Elsewhere { node: world.label(me), region: landing(0), portal: door(5) })
    );
    world.pass(me, door(0)).unwrap();
    world.stop_at(CABIN, 5).unwrap();
    assert_eq!((world.stop_of(CABIN), state(&world, 0), state(&world, 5)), (Some(5), false, true));
    assert_eq!(world.pass(me, door(0)), Err(PassError::Shut(door(0))));
    let between = RegionFrame::new([4000.0, -3000.0, 70.0], 0.65);
    world.move_between(CABIN, between).unwrap();
    assert_eq!((world.stop_of(CABIN), world.frame(CABIN), state(&world, 5)), (None, Some(between), false));
    world.stop_at(CABIN, 7).unwrap();
    world.pass(me, door(7)).unwrap();
    assert_eq!(world.region_of(me), Some(landing(7)));
}

#[test]
fn regions_stop_only_where_they_can() {
    let (mut world, _) = world();
    let none = |region, stop, stops| Err(SpaceError::StopUnknown { region, stop, stops });
    assert_eq!(world.stop_at(CABIN, STOREYS), none(CABIN, STOREYS, STOREYS as usize));
    assert_eq!(world.stop_at(landing(2), 0), none(landing(2), 0, 0));
    assert_eq!(world.move_between(landing(2), RegionFrame::WORLD), none(landing(2), 0, 0));
    let nowhere = RegionFrame::new([0.0, f64::NAN, 0.0], 0.0);
    assert!(matches!(world.move_between(CABIN, nowhere), Err(SpaceError::NotFinite(_))));
    assert_eq!(world.stop_of(landing(2)), None);

    let mut plan = SpaceBuilder::new();
    let [one, two] = [0, 1].map(|n| {
        let room = Region::new(RegionKind::Corridor, "landing").with_numbers(9);
        plan.add(room.shifted(f64::from(n), 0.0, 0.0)).unwrap()
    });
    let sides = [side(one, 1.0, 0.0, 0.0), side(two, 0.0, 0.0, PI)];
    let portal = Portal::new(PortalKind::Landing, sides, 1.0, 2.0);
    assert_eq!(plan.join(portal.clone().at_stop(1)), Err(SpaceError::NoStop { regions: [one, two], stop: 1 }));
    let way = [Point3::new(0.0, f32::INFINITY, 0.0)];
    assert!(matches!(plan.join(portal.clone().over_stairs(way)), Err(SpaceError::NotFinite(_))));
    plan.join(portal).unwrap();
    let moving = Region::new(RegionKind::Stairwell, "cabin").moving([RegionFrame::WORLD, nowhere]);
    assert!(matches!(plan.add(moving), Err(SpaceError::NotFinite(_))));
}

#[test]
fn a_way_up_takes_the_lift_or_else_the_stairs() {
    let space = building();
    let ends = ((landing(0), Point3::new(4.0, 0.0, 0.0)), (landing(3), Point3::new(4.0, 0.0, 0.0)));
    assert_eq!(space.route(ends.0, ends.1, |_| true), Some(vec![door(0), door(3)]));
    let is_lift = |portal: PortalId| portal.0 < STOREYS;
    let stairs: Vec<PortalId> = (0..3).map(|storey| PortalId(STOREYS + storey)).collect();
    assert_eq!(space.route(ends.0, ends.1, |portal| !is_lift(portal)), Some(stairs.clone()));
    assert_eq!(space.route(ends.1, ends.0, |portal| !is_lift(portal)), Some(stairs.into_iter().rev().collect()));
    assert!((space.portal(PortalId(STOREYS)).unwrap().climb() - 5.0).abs() < 1e-5);
    // Close to the stairs, one storey of five metres of stairs is shorter than to go to the lift and back.
    let near = |storey| (landing(storey), Point3::new(8.0, 1.0, 0.0));
    assert_eq!(space.route(near(0), near(1), |_| true), Some(vec![PortalId(STOREYS)]));
}

proptest! {
    #![proptest_config(cases(40))]

    #[test]
    fn rides_lose_nothing(storeys in prop::collection::vec(0..STOREYS, 1..12), saved in 0..12_usize) {
        let (mut world, me) = world();
        let before = load(&world, me);
        let mut here = 0;
        for (ride, there) in storeys.into_iter().enumerate() {
            world.stop_at(CABIN, here).unwrap();
            open(&mut world, here, true);
            world.pass(me, door(here)).unwrap();
            open(&mut world, here, false);
            world.stop_at(CABIN, there).unwrap();
            open(&mut world, there, true);
            if ride == saved {
                let space = world.space().clone();
                let made = |region| scene(&space, region);
                let again = RegionGraphs::read(&world.write(), space.clone(), &ClassTable::builtin(), made).unwrap();
                prop_assert!(again == world);
                world = again;
            }
            world.pass(me, door(there)).unwrap();
            open(&mut world, there, false);
            prop_assert_eq!(world.region_of(me), Some(landing(there)));
            here = there;
        }
        let after = load(&world, me);
        prop_assert_eq!(before.len(), 6);
        prop_assert_eq!(before.keys().collect::<Vec<_>>(), after.keys().collect::<Vec<_>>());
        for (id, at) in &before {
            prop_assert!((at - after[id]).norm() < 1e-4);
        }
        let position = world.node(me).and_then(|node| node.position()).unwrap();
        prop_assert!((position - Point3::new(0.5, 0.0, 0.0)).norm() < 1e-4, "{}", position);
    }
}
