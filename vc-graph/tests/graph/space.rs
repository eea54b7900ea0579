//! Regions and portals: what passes from one scene to another, and scenes that come and go.

#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use std::collections::{BTreeMap, BTreeSet};
use std::f32::consts::PI;

use proptest::prelude::*;
use vc_graph::nalgebra::{self, Isometry3, Point3, Vector3};
use vc_graph::space::{
    NumberBlock, PassError, Portal, PortalId, PortalKind, PortalSide, Region, RegionFrame, RegionGraphs, RegionId,
    RegionKind, Space, SpaceBuilder, SpaceError, WorldFileError,
};
use vc_graph::{ClassTable, Draft, Edge, NodeId, Pose, Relation, SceneBuilder, SceneGraph, State};
use vc_testkit::cases;
use vc_testkit::edits::{make, plans};
use vc_testkit::scenes::{scene, steps};

const REGIONS: u32 = 3;

fn side(region: u32, x: f32, heading: f32) -> PortalSide {
    let pose = Pose::translation(x, 0.0, 0.0) * Pose::rotation(Vector3::new(0.0, 0.0, heading));
    PortalSide { region: RegionId(region), pose, room: None }
}

/// Regions in a row, ten metres each, far from the origin and turned, with a passage between each and the next.
fn row() -> Space {
    let mut plan = SpaceBuilder::new();
    let house = Region::new(RegionKind::Building, "house").at(RegionFrame::new([4000.0, -3000.0, 60.0], 0.65));
    let house = plan.add(house).unwrap();
    for number in 0..REGIONS {
        let flat = Region::new(RegionKind::Unit, format!("flat {number}")).within(house).with_numbers(2000);
        plan.add(flat.shifted(10.0 * f64::from(number), 0.0, 0.0)).unwrap();
    }
    for number in 1..REGIONS {
        let sides = [side(number, 10.0, 0.0), side(number + 1, 0.0, PI)];
        plan.join(Portal::new(PortalKind::Passage, sides, 1.0, 2.0)).unwrap();
    }
    plan.build()
}

/// A random scene with the numbers of a region, an agent that stands in its first room, and a cup in its hand.
fn flat(space: &Space, region: RegionId, build: &[vc_testkit::scenes::Step]) -> SceneGraph {
    let mut built = SceneBuilder::from_graph(scene(build, true));
    let room = built.add(Draft::new("hallway").at(Pose::translation(5.0, 0.0, 0.0))).unwrap();
    let me = built.add_in(room, Draft::new("character").at(Pose::translation(9.0, 0.0, 0.0))).unwrap();
    let cup = built.add(Draft::new("cup").at(Pose::translation(9.2, 0.1, 1.0))).unwrap();
    let mut edit = built.edit();
    edit.hold(me, cup).unwrap();
    edit.commit();
    built.build().renumbered(space.region(region).unwrap().numbers).unwrap()
}

fn world(builds: &[Vec<vc_testkit::scenes::Step>]) -> (RegionGraphs, BTreeMap<RegionId, SceneGraph>) {
    let space = row();
    let scenes = (1..).map(RegionId).zip(builds);
    let made: BTreeMap<RegionId, SceneGraph> = scenes.map(|(id, build)| (id, flat(&space, id, build))).collect();
    let mut world = RegionGraphs::new(space.into());
    made.iter().for_each(|(id, scene)| world.insert(*id, scene.clone()).unwrap());
    (world, made)
}

/// All nodes with their states and poses in the world.
fn nodes(world: &RegionGraphs) -> BTreeMap<NodeId, (String, Option<Isometry3<f64>>)> {
    let frame = |region| world.space().region(region).unwrap().frame;
    let of = |region| {
        let nodes = world.graph(region).unwrap().nodes();
        nodes.map(move |node| {
            let pose = node.pose().map(|pose| frame(region).pose(pose));
            (node.id(), (format!("{} {}", node.class(), node.states()), pose))
        })
    };
    world.active().flat_map(of).collect()
}

fn edges(world: &RegionGraphs) -> BTreeSet<Edge> {
    world.active().flat_map(|region| world.graph(region).unwrap().edges().collect::<Vec<_>>()).collect()
}

fn is_near(one: &Option<Isometry3<f64>>, other: &Option<Isometry3<f64>>) -> bool {
    match (one, other) {
        (Some(one), Some(other)) => {
            let turned = one.rotation.angle_to(&other.rotation);
            // Poses of random scenes are up to some hundred metres from their origins.
            (one.translation.vector - other.translation.vector).norm() < 1e-3 && turned < 1e-3
        }
        _ => one.is_none() && other.is_none(),
    }
}

proptest! {
    #![proptest_config(cases(100))]

    #[test]
    fn who_passes_takes_along_what_it_carries_and_nothing_else(
        builds in prop::collection::vec(steps(8), REGIONS as usize),
        moves in prop::collection::vec((any::<prop::sample::Index>(), 0..REGIONS - 1), 1..8),
        edit in plans(6),
    ) {
        let (mut world, _) = world(&builds);
        let mut past = Vec::new();
        for (which, portal) in moves {
            let before = world.clone();
            let (was, had) = (nodes(&before), edges(&before));
            let ids: Vec<NodeId> = was.keys().copied().collect();
            let node = ids[which.index(ids.len())];
            let Ok(crossing) = world.pass(node, PortalId(portal)) else {
                prop_assert!(world == before);
                continue;
            };
            // A slow and obvious version: the same nodes, those that went in another region, at the same places.
            let now = nodes(&world);
            prop_assert!(now.keys().eq(was.keys()));
            for (id, (said, at)) in &now {
                prop_assert_eq!(said, &was[id].0);
                prop_assert!(is_near(at, &was[id].1), "{}: {:?} {:?}", id, at, was[id].1);
            }
            let went: BTreeSet<NodeId> = crossing.nodes.iter().copied().collect();
            let expected: Vec<NodeId> = before.graph(crossing.from).unwrap().carried_with(node);
            prop_assert!(expected == crossing.nodes);
            for id in &ids {
                let at = if went.contains(id) { crossing.to } else { before.region_of(*id).unwrap() };
                prop_assert_eq!(world.region_of(*id), Some(at));
                prop_assert!(world.graph(at).unwrap().node(*id).is_some());
            }
            let room = world.graph(crossing.to).unwrap().rooms()[0];
            let stays = |edge: &Edge| went.contains(&edge.from) == went.contains(&edge.to);
            let mut kept: BTreeSet<Edge> = had.into_iter().filter(stays).collect();
            kept.extend(went.iter().map(|id| Edge::new(*id, Relation::InRoom, room)));
            prop_assert!(edges(&world) == kept);
            past.push((crossing, before));
        }
        // The scenes go on as any other.
        let after = world.clone();
        for (region, plan) in (1..=REGIONS).map(RegionId).cycle().zip(edit) {
            let mut change = world.edit(region).unwrap();
            make(&mut change, plan).unwrap();
            change.commit();
            prop_assert_eq!(world.graph(region).unwrap().validate(), []);
        }
        world = after;
        for (crossing, before) in past.into_iter().rev() {
            world.take_back(&crossing).unwrap();
            prop_assert!(world == before);
        }
    }

    #[test]
    fn regions_that_are_left_and_entered_again_in_any_order_are_as_before(
        builds in prop::collection::vec(steps(8), REGIONS as usize),
        plan in plans(12),
        order in Just([1, 2, 3]).prop_shuffle(),
        back in Just([1, 2, 3]).prop_shuffle(),
        (cut, hole) in (any::<prop::sample::Index>(), any::<prop::sample::Index>()),
    ) {
        let (mut world, made) = world(&builds);
        let me = world.graph(RegionId(1)).unwrap().agents().last().copied().unwrap();
        let _ = world.pass(me, PortalId(0));
        for (region, plan) in (1..=REGIONS).map(RegionId).cycle().zip(plan) {
            let mut change = world.edit(region).unwrap();
            make(&mut change, plan).unwrap();
            change.commit();
        }
        let before = world.clone();
        // Saved at this point and read, all goes on as it would have.
        let text = before.write();
        let scenes = |id: RegionId| made[&id].clone();
        let read = |text: &str| RegionGraphs::read(text, before.space().clone(), &ClassTable::builtin(), scenes);
        prop_assert!(read(&text).unwrap() == before);
        let mut next = read(&text).unwrap();
        let crossing = (next.pass(me, PortalId(0)), world.clone().pass(me, PortalId(0)));
        prop_assert_eq!(crossing.0, crossing.1);
        // A text that has been cut or changed is refused, or another world; it does no harm.
        let (at, to) = (cut.index(text.len()), hole.index(text.len()));
        let _ = read(&text[..at]);
        let _ = read(&format!("{}{}", &text[..at.min(to)], &text[at.max(to)..]));
        for _ in 0..3 {
            order.iter().for_each(|id| world.rest(RegionId(*id)).unwrap());
            prop_assert_eq!(world.active().count(), 0);
            for id in back.map(RegionId) {
                world.insert(id, made[&id].clone()).unwrap();
            }
            prop_assert!(world == before);
            for id in back.map(RegionId) {
                let (here, there) = (world.graph(id).unwrap(), before.graph(id).unwrap());
                prop_assert_eq!(here.digest(), there.digest());
                prop_assert_eq!(here.next_number(), there.next_number());
            }
        }
    }

    #[test]
    fn poses_go_from_frame_to_frame(
        [a, b] in prop::array::uniform2((prop::array::uniform3(-5000.0..5000.0_f64), -4.0..4.0_f64)),
        point in prop::array::uniform3(-20.0..20.0_f32),
    ) {
        let [a, b] = [a, b].map(|(origin, heading)| RegionFrame::new(origin, heading));
        let pose = Pose::translation(point[0], point[1], point[2]);
        let exact = b.pose(&Pose::identity()).inverse() * a.pose(&pose);
        let distance = (a.origin - b.origin).norm() as f32 + 20.0;
        let found = a.to(&b) * pose;
        let off = (found.translation.vector - exact.translation.vector.cast::<f32>()).norm();
        prop_assert!(off <= distance * 1e-6, "{} {}", off, distance);
        let own = a.to(&a) * pose;
        prop_assert!((own.translation.vector - pose.translation.vector).norm() < 1e-6);
        // Near each other it does not matter how far away both are.
        let beside = RegionFrame::new([a.origin.x + 3.0, a.origin.y, a.origin.z], a.heading);
        let off = a.to(&beside).inverse() * beside.to(&a).inverse();
        prop_assert!(off.translation.vector.norm() < 1e-5);
    }
}

/// A grid of squares of ten metres with passages between neighbours, some of them shut.
fn grid(side_length: u32) -> Space {
    let mut plan = SpaceBuilder::new();
    for number in 0..side_length * side_length {
        let (x, y) = (number % side_length, number / side_length);
        let square = Region::new(RegionKind::Street, "square").with_numbers(10);
        plan.add(square.shifted(10.0 * f64::from(x), 10.0 * f64::from(y), 0.0)).unwrap();
    }
    let facing = |region: u32, x: f32, y: f32, heading: f32| {
        let pose = Pose::translation(x, y, 0.0) * Pose::rotation(Vector3::new(0.0, 0.0, heading));
        PortalSide { region: RegionId(region), pose, room: None }
    };
    for number in 0..side_length * side_length {
        if number % side_length + 1 < side_length {
            let sides = [facing(number, 10.0, 5.0, 0.0), facing(number + 1, 0.0, 5.0, PI)];
            plan.join(Portal::new(PortalKind::Passage, sides, 3.0, 3.0)).unwrap();
        }
        if number / side_length + 1 < side_length {
            let sides = [facing(number, 5.0, 10.0, PI / 2.0), facing(number + side_length, 5.0, 0.0, -PI / 2.0)];
            plan.join(Portal::new(PortalKind::Passage, sides, 3.0, 3.0)).unwrap();
        }
    }
    plan.build()
}

/// The length of the shortest way by trying all (Bellman and Ford), over the thresholds of portals.
fn shortest(space: &Space, from: RegionId, to: RegionId, middle: Point3<f32>, open: &[bool]) -> Option<f64> {
    let world = |region: RegionId, point: &Point3<f32>| space.region(region).unwrap().frame.point(&point.cast());
    let mut best: BTreeMap<(RegionId, PortalId), f64> = BTreeMap::new();
    let threshold = |region: RegionId, portal: PortalId| {
        let side = *space.portal(portal).unwrap().side(region).unwrap();
        world(region, &Point3::from(side.pose.translation.vector))
    };
    let is_open = |portal: &PortalId| open[portal.0 as usize % open.len()];
    for _ in 0..space.len() * 2 {
        let known = best.clone();
        for (region, portal) in space.regions().flat_map(|(id, _)| space.portals_of(id).map(move |portal| (id, portal)))
        {
            if !is_open(&portal) {
                continue;
            }
            let beyond = space.portal(portal).unwrap().across(region).unwrap().region;
            let at = threshold(beyond, portal);
            let first = (region == from).then(|| nalgebra::distance(&world(from, &middle), &at));
            let entered = known.iter().filter(|((id, _), _)| *id == region);
            let later = entered.map(|((id, by), walked)| walked + nalgebra::distance(&threshold(*id, *by), &at));
            if let Some(length) = first.into_iter().chain(later).min_by(f64::total_cmp) {
                let known = best.entry((beyond, portal)).or_insert(f64::INFINITY);
                *known = known.min(length);
            }
        }
    }
    let ends = best.iter().filter(|((region, _), _)| *region == to);
    let last = |((region, portal), walked): (&(RegionId, PortalId), &f64)| {
        walked + nalgebra::distance(&threshold(*region, *portal), &world(to, &middle))
    };
    ends.map(last).min_by(f64::total_cmp)
}

proptest! {
    #![proptest_config(cases(60))]

    #[test]
    fn a_route_is_as_short_as_any(from in 0_u32..16, to in 0_u32..16, open in prop::collection::vec(prop::bool::weighted(0.7), 24)) {
        let space = grid(4);
        let (from, to, middle) = (RegionId(from), RegionId(to), Point3::new(4.0, 5.0, 0.0));
        prop_assume!(from != to);
        let is_open = |portal: PortalId| open[portal.0 as usize % open.len()];
        let route = space.route((from, middle), (to, middle), is_open);
        let length = shortest(&space, from, to, middle, &open);
        prop_assert_eq!(route.is_some(), length.is_some());
        let (Some(route), Some(length)) = (route, length) else { return Ok(()) };
        prop_assert!(route.iter().all(|portal| is_open(*portal)));
        let world = |region: RegionId, point: &Point3<f32>| space.region(region).unwrap().frame.point(&point.cast());
        let (mut region, mut at, mut walked) = (from, world(from, &middle), 0.0);
        for portal in &route {
            let side = space.portal(*portal).unwrap().across(region).unwrap();
            let next = world(side.region, &Point3::from(side.pose.translation.vector));
            walked += nalgebra::distance(&at, &next);
            (region, at) = (side.region, next);
        }
        prop_assert_eq!(region, to);
        walked += nalgebra::distance(&at, &world(to, &middle));
        prop_assert!((walked - length).abs() < 1e-9, "{} {}", walked, length);
    }
}

#[test]
fn a_plan_that_makes_no_sense_is_refused() {
    let mut plan = SpaceBuilder::new();
    let lost = Region::new(RegionKind::Unit, "flat").within(RegionId(7));
    assert!(matches!(plan.add(lost), Err(SpaceError::NoSuchParent { parent: RegionId(7), .. })));
    let nowhere = Region::new(RegionKind::Unit, "flat").shifted(f64::NAN, 0.0, 0.0);
    assert!(matches!(plan.add(nowhere), Err(SpaceError::NotFinite(_))));
    let vast = Region::new(RegionKind::City, "city").with_numbers(u32::MAX);
    assert!(matches!(plan.add(vast), Err(SpaceError::NumbersExhausted { .. })));
    for number in 0..2 {
        plan.add(Region::new(RegionKind::Unit, "flat").shifted(f64::from(number) * 10.0, 0.0, 0.0).with_numbers(10))
            .unwrap();
    }
    let group = plan.add(Region::new(RegionKind::Storey, "storey")).unwrap();
    let join = |plan: &mut SpaceBuilder, sides, width| plan.join(Portal::new(PortalKind::Door, sides, width, 2.0));
    assert!(matches!(join(&mut plan, [side(0, 0.0, 0.0), side(group.0, 0.0, PI)], 1.0), Err(SpaceError::NoScene(_))));
    assert!(matches!(join(&mut plan, [side(0, 0.0, 0.0), side(0, 0.0, PI)], 1.0), Err(SpaceError::JoinsItself(_))));
    assert!(matches!(join(&mut plan, [side(0, 10.0, 0.0), side(1, 0.0, PI)], -1.0), Err(SpaceError::NoOpening(..))));
    assert!(matches!(join(&mut plan, [side(0, 8.0, 0.0), side(1, 0.0, PI)], 1.0), Err(SpaceError::SidesApart(..))));
    assert!(matches!(join(&mut plan, [side(0, 10.0, 0.0), side(1, 0.0, 0.0)], 1.0), Err(SpaceError::SidesApart(..))));
    let nan = PortalSide { pose: Pose::translation(f32::NAN, 0.0, 0.0), ..side(1, 0.0, PI) };
    assert!(matches!(join(&mut plan, [side(0, 10.0, 0.0), nan], 1.0), Err(SpaceError::NotFinite(_))));
    assert_eq!(join(&mut plan, [side(0, 10.0, 0.0), side(1, 0.0, PI)], 1.0), Ok(PortalId(0)));
    let space = plan.build();
    assert_eq!(space.portals_of(RegionId(1)).collect::<Vec<_>>(), [PortalId(0)]);
    assert_eq!(space.made_in(NodeId(11)), Some(RegionId(1)));
    assert_eq!(space.made_in(NodeId(21)), None);
}

#[test]
fn whoever_cannot_pass_is_told_why() {
    let (mut world, _) = world(&[vec![], vec![], vec![]]);
    let graph = world.graph(RegionId(1)).unwrap();
    let (room, me) = (graph.rooms()[0], *graph.agents().last().unwrap());
    let cup = graph.held(me).next().unwrap();
    assert!(matches!(world.pass(room, PortalId(0)), Err(PassError::IsRoom(_))));
    assert!(matches!(world.pass(cup, PortalId(0)), Err(PassError::Resting { at, .. }) if at.id == me));
    assert!(matches!(world.pass(me, PortalId(1)), Err(PassError::Elsewhere { region: RegionId(1), .. })));
    assert!(matches!(world.pass(me, PortalId(9)), Err(PassError::NoSuchPortal(_))));
    assert!(matches!(world.pass(NodeId(1999), PortalId(0)), Err(PassError::NoSuchNode(_))));
    world.rest(RegionId(2)).unwrap();
    assert_eq!(world.pass(me, PortalId(0)), Err(PassError::NotActive(RegionId(2))));
}

#[test]
fn a_passage_is_taken_back_only_where_both_regions_are_active_and_as_they_were() {
    let (mut world, made) = world(&[vec![], vec![], vec![]]);
    let me = *world.graph(RegionId(1)).unwrap().agents().last().unwrap();
    let crossing = world.pass(me, PortalId(0)).unwrap();
    for region in [RegionId(1), RegionId(2)] {
        world.rest(region).unwrap();
        let before = world.clone();
        assert_eq!(world.take_back(&crossing), Err(PassError::NotActive(region)));
        assert!(world == before);
        world.insert(region, made[&region].clone()).unwrap();
    }
    let mut edit = world.edit(RegionId(2)).unwrap();
    edit.enter_state(me, State::Dirty).unwrap();
    edit.commit();
    let before = world.clone();
    assert!(matches!(world.take_back(&crossing), Err(PassError::Changed(_))));
    assert!(world == before);
}

#[test]
fn one_enters_a_room_of_the_scene_beyond_that_knows_ones_words() {
    let space = |room: Option<NodeId>| {
        let mut plan = SpaceBuilder::new();
        for x in [0.0, 10.0] {
            plan.add(Region::new(RegionKind::Unit, "flat").with_numbers(50).shifted(x, 0.0, 0.0)).unwrap();
        }
        let sides = [side(0, 10.0, 0.0), PortalSide { room, ..side(1, 0.0, PI) }];
        plan.join(Portal::new(PortalKind::Passage, sides, 1.0, 2.0)).unwrap();
        plan.build()
    };
    let flat = |first: u32, words: &str| {
        let words = vc_graph::Vocabulary::parse("words.txt", words).unwrap();
        let classes = ClassTable::builtin().with_vocabulary(words);
        let mut scene = SceneBuilder::with_classes("flat", classes.into());
        scene.numbers(NumberBlock { first, count: 50 });
        let hall = scene.add(Draft::new("hallway")).unwrap();
        scene.add_in(hall, Draft::new("table")).unwrap();
        scene.add_in(hall, Draft::new("character")).unwrap();
        scene.build()
    };
    let world = |room, words: &str| {
        let mut world = RegionGraphs::new(space(room).into());
        world.insert(RegionId(0), flat(1, words)).unwrap();
        world.insert(RegionId(1), flat(51, "")).unwrap();
        world
    };
    assert!(world(Some(NodeId(51)), "").pass(NodeId(3), PortalId(0)).is_ok());
    for no_room in [NodeId(52), NodeId(77), NodeId(1)] {
        let refused = world(Some(no_room), "").pass(NodeId(3), PortalId(0));
        assert_eq!(refused, Err(PassError::NoRoom(RegionId(1))));
    }
    let mut world = world(None, "state enlightened");
    let mut edit = world.edit(RegionId(0)).unwrap();
    edit.enter_state(NodeId(3), "enlightened".parse().unwrap()).unwrap();
    edit.commit();
    assert!(matches!(world.pass(NodeId(3), PortalId(0)), Err(PassError::Lacks { word: "enlightened", .. })));
}

#[test]
fn absurd_numbers_are_refused() {
    let vast = RegionFrame::new([1e308, 0.0, 0.0], 0.0);
    let mut plan = SpaceBuilder::new();
    let outer = plan.add(Region::new(RegionKind::City, "city").at(vast)).unwrap();
    let inner = Region::new(RegionKind::Unit, "flat").within(outer).at(vast);
    assert!(matches!(plan.add(inner), Err(SpaceError::NotFinite(_))));
    let nowhere = Region::new(RegionKind::Unit, "flat").shifted(f64::NAN, 0.0, 0.0);
    assert!(matches!(Space::single(nowhere), Err(SpaceError::NotFinite(_))));
    let space = row();
    let (here, nowhere) = (Point3::new(1.0, 1.0, 0.0), Point3::new(f32::NAN, f32::INFINITY, 0.0));
    for (from, to) in [(here, nowhere), (nowhere, here)] {
        assert_eq!(space.route((RegionId(1), from), (RegionId(3), to), |_| true), None);
    }
    let mut plan = SpaceBuilder::new();
    for x in [0.0, 10.0] {
        plan.add(Region::new(RegionKind::Unit, "flat").with_numbers(10).shifted(x, 0.0, 0.0)).unwrap();
    }
    let upside_down = PortalSide { pose: Pose::rotation(Vector3::new(0.0, PI, 0.0)), ..side(1, 0.0, PI) };
    let joined = plan.join(Portal::new(PortalKind::Passage, [side(0, 10.0, 0.0), upside_down], 1.0, 2.0));
    assert!(matches!(joined, Err(SpaceError::SidesApart(..))));
    let door = Portal::new(PortalKind::Door, [side(0, 10.0, 0.0), side(1, 0.0, PI)], 1.0, 2.0);
    assert!(matches!(plan.join(door.with_leaf(NodeId(40))), Err(SpaceError::ForeignLeaf { .. })));
    let mut scene = SceneBuilder::new("flat");
    for _ in 0..2 {
        scene.add(Draft::new("kitchen")).unwrap();
    }
    assert!(scene.build().renumbered(NumberBlock { first: u32::MAX, count: u32::MAX }).is_none());
    let mut one = SceneBuilder::new("one");
    one.add_with_id(NodeId(u32::MAX), Draft::new("kitchen")).unwrap();
    one.numbers(NumberBlock::ALL);
    let one = one.build();
    assert!(one.renumbered(NumberBlock { first: 5, count: 0 }).is_none());
    assert_eq!(one.renumbered(NumberBlock { first: 5, count: 1 }).unwrap().rooms(), [NodeId(5)]);
}

#[test]
fn the_only_region_of_a_plan_goes_on_with_other_numbers_too() {
    let mut plan = SpaceBuilder::new();
    let flat = plan.add(Region::new(RegionKind::Unit, "flat").with_numbers(10)).unwrap();
    let mut world = RegionGraphs::new(plan.build().into());
    let mut scene = SceneBuilder::new("flat");
    scene.add(Draft::new("hallway")).unwrap();
    world.insert(flat, scene.build()).unwrap();
    let mut edit = world.edit(flat).unwrap();
    let me = edit.add(Draft::new("character")).unwrap();
    edit.commit();
    assert!(NumberBlock::OVERFLOW.has(me));
    assert_eq!(world.region_of(me), Some(flat));
    assert!(world.step(me, &vc_graph::Action::zero(vc_graph::Verb::Wave)).is_ok());
}

#[test]
fn a_door_lets_through_what_its_leaf_lets_through_also_while_its_region_is_dormant() {
    let mut plan = SpaceBuilder::new();
    let home = Region::new(RegionKind::Unit, "home").with_numbers(100);
    plan.add(home).unwrap();
    plan.add(Region::new(RegionKind::Corridor, "gallery").with_numbers(100).shifted(5.0, 0.0, 0.0)).unwrap();
    let door = Portal::new(PortalKind::Door, [side(0, 5.0, 0.0), side(1, 0.0, PI)], 0.9, 2.0).with_leaf(NodeId(2));
    let door = plan.join(door).unwrap();
    let mut world = RegionGraphs::new(plan.build().into());
    let passable = |world: &RegionGraphs| world.portal(door).unwrap().passable;
    assert!(!passable(&world), "nobody has been there");
    let mut scene = SceneBuilder::new("home");
    let hall = scene.add(Draft::new("hallway")).unwrap();
    scene.add_in(hall, Draft::new("door").state(State::Open)).unwrap();
    let made = scene.build();
    world.insert(RegionId(0), made.clone()).unwrap();
    assert!(passable(&world));
    world.rest(RegionId(0)).unwrap();
    assert!(passable(&world) && world.changes(RegionId(0)).unwrap().is_empty());
    world.insert(RegionId(0), made.clone()).unwrap();
    let mut edit = world.edit(RegionId(0)).unwrap();
    edit.enter_state(NodeId(2), State::Closed).unwrap();
    edit.commit();
    world.rest(RegionId(0)).unwrap();
    assert!(!passable(&world));
    // A generator that makes another home is refused.
    let mut other = made.clone();
    let mut edit = other.edit();
    edit.enter_state(NodeId(2), State::Closed).unwrap();
    edit.commit();
    let refused = world.insert(RegionId(0), other);
    assert!(matches!(refused, Err(SpaceError::MadeOtherwise { region: RegionId(0), .. })));
    world.insert(RegionId(0), made).unwrap();
    assert!(!passable(&world));
}

#[test]
fn a_saved_world_belongs_to_its_plan() {
    let (mut world, made) = world(&[vec![], vec![], vec![]]);
    world.rest(RegionId(2)).unwrap();
    let text = world.write();
    let read = |space: Space, text: &str| {
        RegionGraphs::read(text, space.into(), &ClassTable::builtin(), |id| made[&id].clone())
    };
    assert!(read(row(), &text).unwrap() == world);
    assert!(matches!(read(grid(2), &text), Err(WorldFileError::OtherPlan { .. })));
    assert!(matches!(read(row(), "{}"), Err(WorldFileError::Json(_))));
    let newer = text.replace("\"virtualcity_world\":1", "\"virtualcity_world\":2");
    assert!(matches!(read(row(), &newer), Err(WorldFileError::Version(2, 1))));
    let elsewhere = text.replace("\"active\":[1,3]", "\"active\":[1,77]");
    assert!(matches!(read(row(), &elsewhere), Err(WorldFileError::NoSuchRegion(RegionId(77)))));
}

#[test]
fn a_region_whose_numbers_are_used_up_goes_on_with_those_of_the_world() {
    let (mut world, made) = world(&[vec![], vec![], vec![]]);
    let mut ids = BTreeSet::new();
    for round in 0..5000 {
        let region = RegionId(1 + round % 2);
        let mut edit = world.edit(region).unwrap();
        let id = edit.add(Draft::new("apple")).unwrap();
        edit.commit();
        assert!(ids.insert(id));
        assert_eq!(world.region_of(id), Some(region));
    }
    assert!(ids.iter().any(|id| NumberBlock::OVERFLOW.has(*id)));
    let before = world.clone();
    world.rest(RegionId(1)).unwrap();
    world.insert(RegionId(1), made[&RegionId(1)].clone()).unwrap();
    assert!(world == before);
    let id = world.edit(RegionId(1)).unwrap().add(Draft::new("apple")).unwrap();
    assert!(!ids.contains(&id));
}

#[test]
fn a_region_of_the_plan_is_small() {
    assert!(
        size_of::<Region>() <= 120 && size_of::<Portal>() <= 160,
        "{} {}",
        size_of::<Region>(),
        size_of::<Portal>()
    );
}
