//! Low-level control: what hands bring about is what actions would have, in every tick alike.

use virtualcity::graph::clock::Span;
use virtualcity::graph::{Action, Edge, Node, NodeId, Place, Pose, Relation, SceneGraph, State, Verb, Violation, rule};
use virtualcity::nalgebra::{Matrix3, Point3, Rotation3, UnitQuaternion, Vector2, Vector3};
use virtualcity::physics::{AgentError, BodyRole, Hand, HandGoal, PhysicsError};
use virtualcity::{ActionError, Control, Environment, PhysicalRefusal};

use super::{act, home};

#[path = "../../examples/hands/target.rs"]
mod target;

use target::Target;

/// Homes with a spoon in a drawer that hands take it out of.
const DRAWERS: [u64; 3] = [8, 14, 21];

/// A home in which somebody stands before a glass on a table.
fn before_a_glass(agents: usize) -> (Environment, NodeId, NodeId, NodeId) {
    let mut home = home(42, agents);
    let me = home.agents()[0];
    let tables = ["dining_table", "kitchen_table", "desk", "coffee_table"];
    let table = tables.into_iter().find_map(|class| home.graph().first_of_class(class)).unwrap();
    let glass = home.spawn("water_glass", Place { relation: Relation::On, at: table }).unwrap();
    act(&mut home, me, Verb::Walk, &[glass]);
    (home, me, glass, table)
}

fn feet(home: &Environment, me: NodeId) -> Pose {
    home.world().pose(me).unwrap()
}

/// A control of one hand with a goal in the world.
fn guiding(home: &Environment, me: NodeId, hand: Hand, to: &Pose, grip: f32) -> Control {
    let goal = HandGoal { pose: feet(home, me).inverse() * to, grip, force: 80.0 };
    let mut hands = [None; 2];
    hands[hand as usize] = Some(goal);
    Control { hands, ..Control::default() }
}

/// Guides a hand until it does not move any more.
fn reach(home: &mut Environment, me: NodeId, hand: Hand, to: &Pose, grip: f32) {
    home.control(me, &guiding(home, me, hand, to, grip)).unwrap();
    let mut before = (Vector3::repeat(f32::NAN), f32::NAN);
    for _ in 0..200 {
        home.step(Span(3));
        let body = home.controlled_hand(me, hand).unwrap().body;
        let now = (body.pose.translation.vector, body.opening);
        if (now.0 - before.0).norm() < 5e-4 && (now.1 - before.1).abs() < 5e-4 {
            return;
        }
        before = now;
    }
}

/// The pose of a hand around a thing that stands: its fingers ahead, the thumb on the left.
fn around(home: &Environment, me: NodeId, thing: NodeId) -> Pose {
    let middle = home.world().aabb(thing).unwrap().centre();
    let shoulder = feet(home, me) * Point3::new(0.0, -0.2, middle.z);
    let ahead = (middle - shoulder).xy().push(0.0).normalize();
    let right = ahead.cross(&Vector3::z());
    let turn = Rotation3::from_matrix_unchecked(Matrix3::from_columns(&[ahead, Vector3::z(), right]));
    Pose::from_parts(middle.coords.into(), UnitQuaternion::from_rotation_matrix(&turn))
}

fn raised(pose: &Pose, up: f32) -> Pose {
    Pose::from_parts((pose.translation.vector + Vector3::z() * up).into(), pose.rotation)
}

/// Goes around a thing from above and behind, and closes.
fn take(home: &mut Environment, me: NodeId, hand: Hand, thing: NodeId) {
    let around = around(home, me, thing);
    let before = around * Pose::translation(-0.15, 0.0, 0.0);
    reach(home, me, hand, &raised(&before, 0.3), 0.0);
    reach(home, me, hand, &before, 0.0);
    reach(home, me, hand, &around, 0.0);
    reach(home, me, hand, &around, 1.0);
}

/// The relations of a thing without those that go by distances.
fn bonds(graph: &SceneGraph, id: NodeId) -> Vec<Edge> {
    use Relation::{Facing, Near, NearBack, NearFront, NearLeft, NearRight, Touching, Under};
    let by_distance = [Facing, Near, NearBack, NearFront, NearLeft, NearRight, Touching, Under];
    let own = graph.edges().filter(|edge| edge.from == id || edge.to == id);
    let mut own: Vec<Edge> = own.filter(|edge| !by_distance.contains(&edge.relation)).collect();
    own.sort_unstable();
    own
}

fn states(graph: &SceneGraph) -> Vec<(NodeId, String)> {
    graph.nodes().map(|node| (node.id(), node.states().to_string())).collect()
}

#[track_caller]
fn same(by_hand: &Environment, by_action: &Environment, things: &[NodeId]) {
    assert_eq!(states(by_hand.graph()), states(by_action.graph()));
    for id in things {
        assert_eq!(bonds(by_hand.graph(), *id), bonds(by_action.graph(), *id));
        let near = |home: &Environment| home.graph().near(home.agents()[0], *id);
        assert_eq!(near(by_hand), near(by_action));
    }
    // Cutlery in a drawer that is pulled comes to lie on other cutlery, whoever pulls.
    let jumbled = |fault: &Violation| matches!(fault, Violation::NotASurface(..));
    let faults: Vec<Violation> = by_hand.graph().validate().into_iter().filter(|fault| !jumbled(fault)).collect();
    assert_eq!(faults, []);
}

/// A drawer that is pulled by its handle, and a spoon that is taken out of it, leave the graph as `open` and `grab` do.
#[test]
fn hands_bring_about_what_actions_do() {
    for seed in DRAWERS {
        let mut home = home(seed, 1);
        let me = home.agents()[0];
        let Target { spoon, cabinet, way, .. } = Target::find(&home).unwrap();
        let stand = Target::find(&home).unwrap().stand(&home).translation.vector.xy();
        let free = home.floor().nearest(stand.into(), 0.3).unwrap();
        home.teleport(me, free).unwrap();
        let target = Target::find(&home).unwrap();
        let turn = target.stand(&home).rotation;
        face(&mut home, me, &turn);
        let mut other = home.clone();

        let handle = target.handle(&home);
        reach(&mut home, me, Hand::Right, &(handle * Pose::translation(-0.1, 0.0, 0.0)), 0.0);
        reach(&mut home, me, Hand::Right, &handle, 0.0);
        reach(&mut home, me, Hand::Right, &handle, 1.0);
        let hand = home.controlled_hand(me, Hand::Right).unwrap();
        assert_eq!(hand.body.holds.map(|(id, _)| id), Some(cabinet), "{:?}", hand.refused);
        assert!(home.graph().node(cabinet).unwrap().is(State::Closed));
        reach(&mut home, me, Hand::Right, &(handle * Pose::translation(-way, 0.0, 0.0)), 1.0);
        let opened = home.changes().changes().len();
        assert!(opened > 0);
        act(&mut other, me, Verb::Open, &[cabinet]);
        same(&home, &other, &[cabinet, spoon]);
        shuts_as_by_action((home.clone(), other.clone()), me, cabinet, &handle);

        let out = handle * Pose::translation(-way - 0.08, 0.0, 0.0);
        reach(&mut home, me, Hand::Right, &out, 0.0);
        let spoon_at = target.around_spoon(&home);
        let high = out.translation.z + 0.25 - spoon_at.translation.z;
        let above = spoon_at * Pose::translation(-high, 0.0, 0.0);
        reach(&mut home, me, Hand::Right, &raised(&out, 0.25), 0.0);
        reach(&mut home, me, Hand::Right, &above, 0.0);
        reach(&mut home, me, Hand::Right, &spoon_at, 0.6);
        reach(&mut home, me, Hand::Right, &spoon_at, 1.0);
        reach(&mut home, me, Hand::Right, &above, 1.0);
        act(&mut other, me, Verb::Grab, &[spoon]);
        same(&home, &other, &[cabinet, spoon]);
        assert_eq!(home.world().held(me, Hand::Right), Some(spoon));
        lies_inside_as_by_action((home.clone(), other), me, (spoon, cabinet), (&spoon_at, &above));

        // Afterwards actions go on with it.
        home.interrupt(me);
        act(&mut home, me, Verb::PutBack, &[spoon]);
        assert!(home.graph().rests_at(spoon, cabinet));
    }
}

/// A drawer that a hand pushes shut by its handle is as shut as after `close`.
fn shuts_as_by_action((mut home, mut other): (Environment, Environment), me: NodeId, cabinet: NodeId, handle: &Pose) {
    reach(&mut home, me, Hand::Right, handle, 1.0);
    reach(&mut home, me, Hand::Right, handle, 0.0);
    reach(&mut home, me, Hand::Right, &(handle * Pose::translation(-0.1, 0.0, 0.0)), 0.0);
    act(&mut other, me, Verb::Close, &[cabinet]);
    assert!(home.graph().node(cabinet).unwrap().is(State::Closed));
    same(&home, &other, &[cabinet]);
}

/// A thing that a hand lets go inside a drawer is as in it as after `put_in`.
fn lies_inside_as_by_action(
    (mut home, mut other): (Environment, Environment),
    me: NodeId,
    (thing, cabinet): (NodeId, NodeId),
    (inside, above): (&Pose, &Pose),
) {
    reach(&mut home, me, Hand::Right, inside, 1.0);
    reach(&mut home, me, Hand::Right, inside, 0.0);
    reach(&mut home, me, Hand::Right, above, 0.0);
    home.interrupt(me);
    home.step(Span(120));
    act(&mut other, me, Verb::PutIn, &[thing, cabinet]);
    assert!(home.graph().related(thing, Relation::Inside).any(|id| id == cabinet));
    same(&home, &other, &[cabinet, thing]);
}

/// Turns somebody on the spot by control alone.
fn face(home: &mut Environment, me: NodeId, to: &UnitQuaternion<f32>) {
    for _ in 0..200 {
        let aside = (feet(home, me).rotation.inverse() * to * Vector3::x()).xy();
        let turn = (6.0 * aside.y.atan2(aside.x)).clamp(-2.0, 2.0);
        home.control(me, &Control { turn, ..Control::default() }).unwrap();
        home.step(Span(2));
        if turn.abs() < 0.01 {
            break;
        }
    }
    home.interrupt(me);
    home.step(Span(1));
}

/// A glass that is taken, carried and put down by either hand is where `grab` and `place` have it.
#[test]
fn a_glass_is_taken_and_put_down_as_by_actions() {
    for hand in Hand::BOTH {
        let (mut home, me, glass, table) = before_a_glass(1);
        if hand == Hand::Left {
            // Actions take with the right hand first.
            let apple = home.spawn("apple", Place { relation: Relation::On, at: table }).unwrap();
            act(&mut home, me, Verb::Walk, &[apple]);
            act(&mut home, me, Verb::Grab, &[apple]);
            act(&mut home, me, Verb::Walk, &[glass]);
        }
        let mut other = home.clone();
        take(&mut home, me, hand, glass);
        let held = home.controlled_hand(me, hand).unwrap();
        assert_eq!(held.body.holds, Some((glass, None)), "{held:?}");
        assert_eq!(home.graph().holder(glass), Some(Place { relation: hand.relation(), at: me }));
        act(&mut other, me, Verb::Grab, &[glass]);
        assert_eq!(other.graph().holder(glass), home.graph().holder(glass));
        same(&home, &other, &[glass, table, me]);
        let there = home.controlled_hand(me, hand).unwrap().body.pose;
        reach(&mut home, me, hand, &raised(&there, 0.3), 1.0);
        assert!(home.world().aabb(glass).unwrap().min.z > home.world().aabb(table).unwrap().max.z + 0.2);
        reach(&mut home, me, hand, &raised(&there, 0.01), 1.0);
        reach(&mut home, me, hand, &raised(&there, 0.01), 0.0);
        assert_eq!(home.graph().holder(glass), None);
        home.interrupt(me);
        home.step(Span(120));
        act(&mut other, me, Verb::Place, &[glass, table]);
        same(&home, &other, &[glass, table]);
    }
}

/// A hand stops at a table top, and pushes a glass along it.
#[test]
fn hands_are_solid() {
    let (mut home, me, glass, table) = before_a_glass(1);
    let (top, around) = (home.world().aabb(table).unwrap().max.z, around(&home, me, glass));
    let beside = around * Pose::translation(-0.12, 0.0, 0.0);
    reach(&mut home, me, Hand::Right, &raised(&beside, 0.3), 1.0);
    for down in [0.0, 0.1, 0.4] {
        reach(&mut home, me, Hand::Right, &Pose::from_parts(raised(&beside, -down).translation, around.rotation), 1.0);
        let hand = home.controlled_hand(me, Hand::Right).unwrap();
        assert!(hand.body.pose.translation.z > top, "{down}: {hand:?}");
    }
    let hand = home.controlled_hand(me, Hand::Right).unwrap();
    assert!(hand.body.touches.contains(&table), "{hand:?}");
    let before = home.world().pose(glass).unwrap();
    reach(&mut home, me, Hand::Right, &beside, 1.0);
    reach(&mut home, me, Hand::Right, &(around * Pose::translation(0.05, 0.0, 0.0)), 1.0);
    let moved = home.world().pose(glass).unwrap().translation.vector - before.translation.vector;
    assert!(moved.xy().norm() > 0.03, "{moved}");
    assert!(home.graph().rests_at(glass, table));
    assert_eq!(home.graph().node(glass).and_then(Node::pose), home.world().pose(glass).as_ref());
}

/// Heavy things stay, however hard they are pushed; and a target out of reach is approached.
#[test]
fn force_and_reach_are_limited() {
    let mut home = home(42, 1);
    let (me, fridge) = (home.agents()[0], home.graph().first_of_class("fridge").unwrap());
    act(&mut home, me, Verb::Walk, &[fridge]);
    let before = home.world().pose(fridge).unwrap();
    let through = feet(&home, me) * Pose::translation(1.5, 0.0, 1.2);
    reach(&mut home, me, Hand::Right, &through, 1.0);
    let hand = home.controlled_hand(me, Hand::Right).unwrap();
    assert!(hand.body.touches.contains(&fridge) && hand.short > 0.3, "{hand:?}");
    assert_eq!(home.world().pose(fridge), Some(before));
    let aside = feet(&home, me) * Pose::translation(0.0, -3.0, 1.4);
    reach(&mut home, me, Hand::Right, &aside, 0.0);
    let hand = home.controlled_hand(me, Hand::Right).unwrap();
    assert!((1.5..2.8).contains(&hand.short), "{hand:?}");
}

/// A course of controls that differs from tick to tick, of two agents in either order.
fn course(home: &mut Environment, me: NodeId, glass: NodeId, order: [usize; 2], every: u64) {
    let target = around(home, me, glass);
    let agents = home.agents().to_vec();
    for (i, forward) in [-0.2, 0.0, 0.0, 0.02, 0.3].into_iter().enumerate() {
        let grip = if i > 1 { 1.0 } else { 0.0 };
        let mine =
            guiding(home, me, Hand::Right, &(target * Pose::translation(forward, 0.0, 0.1 - 0.02 * i as f32)), grip);
        let theirs = Control { velocity: Vector2::new(0.2, -0.1), turn: 0.5, hands: mine.hands, ..Control::default() };
        for at in order {
            home.control(agents[at], if agents[at] == me { &mine } else { &theirs }).unwrap();
        }
        for _ in 0..60 / every {
            home.step(Span(every));
        }
    }
}

/// The same controls give the same bytes, however ticks are divided, in whatever order they are given, in any thread,
/// and when the home is saved in the middle.
#[test]
fn control_is_deterministic() {
    let (start, me, glass, _) = before_a_glass(2);
    let mut whole = start.clone();
    course(&mut whole, me, glass, [0, 1], 60);
    let mut divided = start.clone();
    course(&mut divided, me, glass, [1, 0], 1);
    assert_eq!(divided.digest(), whole.digest());
    assert_eq!(divided.graph(), whole.graph());
    let mut copy = start.clone();
    let elsewhere = std::thread::spawn(move || {
        course(&mut copy, me, glass, [0, 1], 20);
        copy.digest()
    });
    assert_eq!(elsewhere.join().unwrap(), whole.digest());

    let mut restored = start.restore(&whole.save().unwrap()).unwrap();
    assert_eq!(restored.digest(), whole.digest());
    assert_eq!(restored.save().unwrap(), whole.save().unwrap());
    for home in [&mut restored, &mut whole] {
        home.step(Span(45));
        course(home, me, glass, [0, 1], 30);
    }
    assert_eq!(restored.digest(), whole.digest());
    assert_eq!(restored.graph(), whole.graph());
}

/// Others act beside somebody under control; who is under control is busy until that ends.
#[test]
fn control_and_actions_go_beside_each_other() {
    let (mut home, me, glass, _) = before_a_glass(2);
    let you = home.agents()[1];
    let around = around(&home, me, glass);
    let control = guiding(&home, me, Hand::Right, &around, 0.0);
    home.control(me, &control).unwrap();
    let fridge = home.graph().first_of_class("fridge").unwrap();
    home.set_action(you, Action::walk(fridge)).unwrap();
    assert!(home.graph().near(you, fridge));
    for refused in [home.set_action(me, Action::grab(glass)), home.steer(me, &virtualcity::Steering::default())] {
        assert!(matches!(refused, Err(ActionError::Busy(ref label)) if label.id == me), "{refused:?}");
    }
    assert!(home.teleport(you, home.graph().rooms()[0]).is_err());
    home.interrupt(me);
    home.step(Span(1));
    home.give(me, Action::grab(glass));
    assert!(matches!(home.control(me, &control), Err(ActionError::Busy(_))));
    let endings = home.step_until_idle(Span(1000));
    assert!(endings.iter().all(|ending| ending.outcome.is_ok()), "{endings:?}");
    // Control goes on with what an action has taken.
    home.control(me, &guiding(&home, me, Hand::Right, &raised(&around, 0.5), 1.0)).unwrap();
    home.step(Span(60));
    assert_eq!((home.world().held(me, Hand::Right), home.graph().holder(glass).map(|p| p.at)), (Some(glass), Some(me)));
}

/// A thing that the rule does not allow to be taken is not held: the reason is told.
#[test]
fn hands_hold_what_the_rule_lets_them() {
    let mut home = home(42, 1);
    let (me, room) = (home.agents()[0], home.graph().first_of_class("livingroom").unwrap());
    let rack = home.spawn("coat_rack", Place { relation: Relation::InRoom, at: room }).unwrap();
    act(&mut home, me, Verb::Walk, &[rack]);
    assert_eq!(home.world().role(rack), Some(BodyRole::Loose));
    take(&mut home, me, Hand::Right, rack);
    let hand = home.controlled_hand(me, Hand::Right).unwrap();
    assert_eq!(hand.body.between, Some((rack, None)), "{hand:?}");
    assert_eq!(hand.body.holds, None);
    assert_eq!(hand.refused, rule::refusals(home.graph(), me, &Action::grab(rack)));
    assert!(!hand.refused.is_empty());
}

/// A body moves in its own frame, and turns its head.
#[test]
fn bodies_move_in_their_own_frame() {
    let mut home = home(42, 1);
    let me = home.agents()[0];
    let (before, eyes) = (feet(&home, me), head(&home, me));
    let control = Control { turn: 0.5, head: Some(Vector2::new(0.6, -0.3)), ..Control::default() };
    home.control(me, &control).unwrap();
    home.step(Span(60));
    let after = feet(&home, me);
    assert!((before.rotation.angle_to(&after.rotation) - 0.5).abs() < 0.01);
    assert!((eyes.angle_to(&head(&home, me))) > 0.5);
    home.control(me, &Control { velocity: Vector2::new(-0.3, 0.0), ..Control::default() }).unwrap();
    home.step(Span(30));
    let way = after.inverse_transform_vector(&(feet(&home, me).translation.vector - after.translation.vector));
    assert!(way.x < -0.1 && way.y.abs() < 0.05, "{way}");
    assert_eq!(home.graph().node(me).and_then(Node::pose), Some(&feet(&home, me)));
    home.interrupt(me);
    home.step(Span(2));
    let stands = feet(&home, me);
    home.step(Span(60));
    assert_eq!(feet(&home, me), stands);
}

fn head(home: &Environment, me: NodeId) -> UnitQuaternion<f32> {
    let camera = home.camera(virtualcity::Viewpoint::Agent(me), 64, 48).unwrap();
    feet(home, me).rotation.inverse() * camera.body().rotation
}

/// Control that makes no sense is refused, and changes nothing.
#[test]
fn bad_controls_are_refused() {
    let mut home = home(42, 1);
    let (me, before) = (home.agents()[0], home.digest());
    let hand = |goal: HandGoal| Control { hands: [Some(goal), None], ..Control::default() };
    let nan = f32::NAN;
    let bad = [
        Control { velocity: Vector2::new(nan, 0.0), ..Control::default() },
        Control { turn: f32::INFINITY, ..Control::default() },
        Control { head: Some(Vector2::new(0.0, nan)), ..Control::default() },
        hand(HandGoal { pose: Pose::translation(nan, 0.0, 0.0), ..HandGoal::default() }),
        hand(HandGoal { pose: Pose::translation(1e30, 0.0, 0.0), ..HandGoal::default() }),
        hand(HandGoal { grip: -0.1, ..HandGoal::default() }),
        hand(HandGoal { force: 1e9, ..HandGoal::default() }),
    ];
    for control in bad {
        let refused = home.control(me, &control).unwrap_err();
        let ActionError::Impossible { why: PhysicalRefusal::Agent(why), .. } = &refused else { panic!("{refused}") };
        let told = matches!(why, AgentError::BadGoal { .. } | AgentError::World(PhysicsError::NotFinite(..)));
        assert!(told && refused.to_string().contains("character"), "{refused}");
    }
    let fridge = home.graph().first_of_class("fridge").unwrap();
    home.control(fridge, &Control::default()).unwrap_err();
    assert_eq!(home.digest(), before);
    let mut without = Environment::builder("apartment/42").bodies(false).make().unwrap();
    assert!(matches!(without.control(me, &Control::default()), Err(ActionError::Impossible { .. })));
    // Far away is only out of reach.
    home.control(me, &hand(HandGoal { pose: Pose::translation(1e5, 0.0, 0.0), ..HandGoal::default() })).unwrap();
    home.step(Span(60));
    assert!(home.controlled_hand(me, Hand::Right).unwrap().body.pose.translation.vector.norm() < 100.0);
    let sofa = home.graph().first_of_class("sofa").unwrap();
    home.interrupt(me);
    home.step(Span(1));
    act(&mut home, me, Verb::Walk, &[sofa]);
    act(&mut home, me, Verb::Sit, &[sofa]);
    let walks = home.control(me, &Control { velocity: Vector2::new(1.0, 0.0), ..Control::default() });
    assert!(matches!(walks, Err(ActionError::Impossible { .. })), "{walks:?}");
    // Hands can be guided there.
    home.control(me, &hand(HandGoal { pose: Pose::translation(0.4, -0.2, 0.5), ..HandGoal::default() })).unwrap();
    home.step(Span(90));
    let hand = home.controlled_hand(me, Hand::Right).unwrap();
    let own = feet(&home, me).inverse() * hand.body.pose;
    assert!((own.translation.vector - Vector3::new(0.4, -0.2, 0.5)).norm() < 0.05, "{own}");
}

/// A reset ends control, wherever hands are; watching changes nothing.
#[test]
fn a_reset_ends_control() {
    let mut home = home(42, 1);
    let (me, start) = (home.agents()[0], home.start().clone());
    home.reset(&start).unwrap();
    let before = home.digest();
    let goal = HandGoal { pose: Pose::translation(0.4, -0.2, 1.1), ..HandGoal::default() };
    home.control(me, &Control { hands: [Some(goal), Some(goal)], ..Control::default() }).unwrap();
    home.step(Span(200));
    let under = home.digest();
    home.moment();
    assert_eq!(home.digest(), under);
    assert_ne!(under, before);
    home.reset(&home.graph().clone()).unwrap();
    assert!(home.controlled(me).is_none() && home.world().agent(me).unwrap().guided(Hand::Right).is_none());
    home.reset(&start).unwrap();
    assert_eq!(home.digest(), before);
}
