//! Hands as end effectors: they stop at what they hit, push, hold and let go.

#![allow(clippy::unwrap_used, reason = "tests stop where something is wrong")]

use nalgebra::{UnitQuaternion, Vector3};
use vc_graph::{NodeId, Pose};
use vc_physics::{AgentError, BodyPlan, BodyRole, Hand, HandGoal, PhysicsWorld, ShapeCache};
use vc_testkit::kitchen::{Kitchen, kitchen};

const QUARTER: f32 = std::f32::consts::FRAC_PI_2;

/// A kitchen at rest, in which somebody stands before the table.
fn at_the_table() -> (Kitchen, PhysicsWorld) {
    let home = kitchen();
    let mut world = PhysicsWorld::build(&home.graph, &ShapeCache::new(), Default::default()).unwrap();
    world.settle(300);
    world.teleport(home.person, Pose::translation(0.3, 0.0, 0.0)).unwrap();
    (home, world)
}

/// A pose ahead of the body, the fingers ahead, turned around them.
fn ahead(at: [f32; 3], roll: f32) -> Pose {
    Pose::from_parts(at.into(), UnitQuaternion::from_euler_angles(roll, 0.0, 0.0))
}

fn guide(world: &mut PhysicsWorld, me: NodeId, pose: Pose, grip: f32, steps: u32) {
    world.guide_hand(me, Hand::Right, HandGoal { pose, grip, ..HandGoal::default() }).unwrap();
    world.run(steps);
}

/// Takes the cup: the thumb on the near side of it for a hand whose fingers point ahead.
fn take_cup(world: &mut PhysicsWorld, home: &Kitchen) {
    let me = home.person;
    guide(world, me, ahead([0.45, 0.0, 0.8], QUARTER), 0.0, 60);
    guide(world, me, ahead([0.7, 0.0, 0.8], QUARTER), 0.0, 60);
    guide(world, me, ahead([0.7, 0.0, 0.8], QUARTER), 1.0, 40);
    assert_eq!(world.grasp(me, Hand::Right, &[]).unwrap(), (home.cup, None));
}

fn hand(world: &PhysicsWorld, me: NodeId) -> Vector3<f32> {
    world.agent(me).unwrap().guided(Hand::Right).unwrap().pose.translation.vector
}

fn position(world: &PhysicsWorld, id: NodeId) -> Vector3<f32> {
    world.pose(id).unwrap().translation.vector
}

#[test]
fn hands_go_where_they_are_guided() {
    let (home, mut world) = at_the_table();
    for goal in [ahead([0.4, -0.3, 1.2], 0.0), ahead([0.2, -0.5, 1.5], 1.0), ahead([0.5, 0.2, 1.0], -2.0)] {
        guide(&mut world, home.person, goal, 0.0, 90);
        let is = world.agent(home.person).unwrap().guided(Hand::Right).unwrap().pose;
        let wanted = world.pose(home.person).unwrap() * goal;
        assert!((is.translation.vector - wanted.translation.vector).norm() < 2e-3, "{is} {wanted}");
        assert!(is.rotation.angle_to(&wanted.rotation) < 0.01, "{is} {wanted}");
    }
    world.withdraw_hand(home.person, Hand::Right).unwrap();
    assert!(world.agent(home.person).unwrap().guided(Hand::Right).is_none());
    assert!(world.pass(60), "without hands all is at rest");
}

#[test]
fn a_hand_stops_at_a_table_top_from_all_sides() {
    let (home, mut world) = at_the_table();
    let me = home.person;
    guide(&mut world, me, ahead([0.5, -0.3, 1.0], 0.0), 0.0, 90);
    guide(&mut world, me, ahead([0.5, -0.3, 0.3], 0.0), 1.0, 120);
    let lowest = hand(&world, me).z;
    assert!((0.74..0.8).contains(&lowest), "{lowest}");
    // From below, fast.
    let (home, mut world) = at_the_table();
    guide(&mut world, me, ahead([0.2, -0.3, 0.4], 0.0), 0.0, 90);
    guide(&mut world, me, ahead([0.6, -0.3, 0.4], 0.0), 0.0, 90);
    guide(&mut world, me, ahead([0.6, -0.3, 1.5], 0.0), 0.0, 120);
    assert!(hand(&world, me).z < 0.7, "{}", hand(&world, me));
    assert!(world.agent(me).unwrap().guided(Hand::Right).unwrap().touches.contains(&home.table));
}

#[test]
fn a_hand_pushes_what_is_light() {
    let (home, mut world) = at_the_table();
    let before = position(&world, home.cup);
    guide(&mut world, home.person, ahead([0.4, 0.0, 0.8], 0.0), 1.0, 90);
    guide(&mut world, home.person, ahead([0.85, 0.0, 0.8], 0.0), 1.0, 60);
    let way = position(&world, home.cup) - before;
    assert!(way.x > 0.05 && way.z.abs() < 0.01, "{way}");
}

#[test]
fn a_cup_is_held_lifted_and_let_go() {
    let (home, mut world) = at_the_table();
    let me = home.person;
    take_cup(&mut world, &home);
    assert_eq!((world.held(me, Hand::Right), world.role(home.cup)), (Some(home.cup), Some(BodyRole::Carried)));
    guide(&mut world, me, ahead([0.5, 0.0, 1.2], QUARTER), 1.0, 60);
    assert!((position(&world, home.cup).z - 1.15).abs() < 0.03, "{}", position(&world, home.cup));
    // A held thing meets the table, too.
    guide(&mut world, me, ahead([0.7, 0.0, 0.5], QUARTER), 1.0, 90);
    assert!(position(&world, home.cup).z > 0.735, "{}", position(&world, home.cup));
    guide(&mut world, me, ahead([0.7, 0.0, 1.0], QUARTER), 1.0, 60);
    guide(&mut world, me, ahead([0.7, 0.0, 1.0], QUARTER), 0.0, 60);
    assert_eq!((world.held(me, Hand::Right), world.role(home.cup)), (None, Some(BodyRole::Loose)));
    assert!((position(&world, home.cup).z - 0.741).abs() < 0.1, "it fell: {}", position(&world, home.cup));
}

/// A hand that opens with fingers or thumb below a thing does not carry it on: it falls past them.
#[test]
fn what_an_open_hand_lets_go_falls_past_the_fingers() {
    for turn in [0.0, 2.0 * QUARTER] {
        let (home, mut world) = at_the_table();
        let (me, over) = (home.person, ahead([0.6, 0.0, 1.2], turn));
        take_cup(&mut world, &home);
        guide(&mut world, me, over, 1.0, 90);
        assert_eq!(world.held(me, Hand::Right), Some(home.cup));
        guide(&mut world, me, over, 0.0, 120);
        assert_eq!(world.held(me, Hand::Right), None);
        let cup = position(&world, home.cup);
        assert!(cup.z < 0.85, "{cup}");
        // It meets the cup again.
        guide(&mut world, me, ahead([0.4, 0.0, 1.2], 0.0), 1.0, 60);
        guide(&mut world, me, ahead([cup.x - 0.3, cup.y, 0.8], 0.0), 1.0, 90);
        guide(&mut world, me, ahead([cup.x + 0.1, cup.y, 0.8], 0.0), 1.0, 60);
        assert!((position(&world, home.cup) - cup).norm() > 0.05, "{cup}");
    }
}

#[test]
fn what_is_pulled_harder_than_the_grip_slips() {
    let (home, mut world) = at_the_table();
    let me = home.person;
    take_cup(&mut world, &home);
    // Three newtons weigh less than the grip holds, and one holds less.
    guide(&mut world, me, ahead([0.6, 0.0, 1.1], QUARTER), 1.0, 60);
    assert_eq!(world.held(me, Hand::Right), Some(home.cup));
    let weak = HandGoal { pose: ahead([0.6, 0.0, 1.1], QUARTER), grip: 1.0, force: 1.0 };
    world.guide_hand(me, Hand::Right, weak).unwrap();
    world.run(60);
    assert_eq!(world.held(me, Hand::Right), None);
    let nothing = world.grasp(me, Hand::Right, &[]);
    assert_eq!(nothing, Err(AgentError::NothingBetween(me)));
}

#[test]
fn what_is_held_stays_in_the_hand_when_guidance_begins_and_ends() {
    let (home, mut world) = at_the_table();
    let me = home.person;
    world.grab(me, Hand::Right, home.cup).unwrap();
    let carried = world.pose(home.cup).unwrap();
    guide(&mut world, me, ahead([0.5, -0.2, 1.2], 0.0), 1.0, 60);
    assert_eq!(world.held(me, Hand::Right), Some(home.cup));
    world.withdraw_hand(me, Hand::Right).unwrap();
    assert_eq!(world.held(me, Hand::Right), Some(home.cup));
    let now = world.pose(home.cup).unwrap();
    assert!((now.translation.vector - carried.translation.vector).norm() < 1e-3, "{now} {carried}");
    world.drop(me, Hand::Right).unwrap();
}

#[test]
fn hands_go_on_alike_after_a_snapshot() {
    let (home, mut world) = at_the_table();
    take_cup(&mut world, &home);
    guide(&mut world, home.person, ahead([0.5, 0.1, 1.2], 0.3), 1.0, 20);
    let mut copy = PhysicsWorld::restore(&world.save().unwrap(), &home.graph, &ShapeCache::new()).unwrap();
    let mut clone = world.clone();
    for world in [&mut world, &mut copy, &mut clone] {
        world.drift(home.person, nalgebra::Vector2::new(-0.3, 0.2), 0.7).unwrap();
        world.run(60);
    }
    assert_eq!([copy.digest(), clone.digest()], [world.digest(); 2]);
    assert_eq!(copy.held(home.person, Hand::Right), Some(home.cup));
}

#[test]
fn bad_goals_are_refused() {
    let (home, mut world) = at_the_table();
    let good = HandGoal::default();
    let nowhere = HandGoal { pose: Pose::translation(f32::NAN, 0.0, 0.0), ..good };
    for bad in [nowhere, HandGoal { grip: 1.5, ..good }, HandGoal { force: f32::INFINITY, ..good }] {
        let refused = world.guide_hand(home.person, Hand::Left, bad);
        assert!(matches!(refused, Err(AgentError::BadGoal { .. })), "{refused:?}");
    }
    assert!(world.agent(home.person).unwrap().guided(Hand::Left).is_none());
    assert!(world.guide_hand(home.cup, Hand::Left, good).is_err());
}

#[test]
fn a_hand_at_its_goal_sleeps() {
    let (home, mut world) = at_the_table();
    guide(&mut world, home.person, ahead([0.4, -0.3, 1.2], 0.3), 0.3, 240);
    assert_eq!(world.awake(), 0);
    assert!(world.pass(60));
    // Another grip wakes it.
    guide(&mut world, home.person, ahead([0.4, -0.3, 1.2], 0.3), 1.0, 1);
    assert_eq!(world.awake(), 1);
    take_cup(&mut world, &home);
    guide(&mut world, home.person, ahead([0.5, 0.0, 1.2], QUARTER), 1.0, 240);
    assert_eq!((world.held(home.person, Hand::Right), world.awake()), (Some(home.cup), 0));
}

#[test]
fn bodies_tell_why_they_cannot_hold() {
    let home = kitchen();
    let mut world = PhysicsWorld::build(&home.graph, &ShapeCache::new(), Default::default()).unwrap();
    let weak = BodyPlan { carries: 0.01, ..BodyPlan::default() };
    let me = NodeId(1000);
    world.teleport(home.person, Pose::translation(0.0, -1.5, 0.0)).unwrap();
    world.add_agent(me, weak, Pose::translation(0.3, 0.0, 0.0)).unwrap();
    world.settle(300);
    for (at, grip) in [([0.45, 0.0, 0.8], 0.0), ([0.7, 0.0, 0.8], 0.0), ([0.7, 0.0, 0.8], 1.0)] {
        guide(&mut world, me, ahead(at, QUARTER), grip, 60);
    }
    let hand = world.agent(me).unwrap().guided(Hand::Right).unwrap();
    assert_eq!(hand.between, Some((home.cup, None)));
    assert!(matches!(hand.fault, Some(AgentError::TooHeavy { .. })), "{hand:?}");
    assert_eq!(world.grasp(me, Hand::Right, &[]).err(), hand.fault);
    assert_eq!(world.held(me, Hand::Right), None);
}
