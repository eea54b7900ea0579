//! The motion of bodies during an action can be observed tick by tick, and ends in the action's result.

#![allow(clippy::unwrap_used, reason = "tests stop where something is wrong")]

use std::collections::BTreeMap;

use nalgebra::{Point3, Vector3};
use virtualcity::Environment;
use virtualcity::graph::clock::{Durations, Span};
use virtualcity::graph::{Action, NodeId, Place, Pose, Property, Relation, State, Verb};
use virtualcity::physics::{BodyRole, Hand, Posture};

/// Largest distance between the last shown pose and the final one, metres.
const SAME: f32 = 0.05;

fn home(seed: u64) -> (Environment, NodeId) {
    // Eating and sleeping take no longer than they are shown.
    let builder = Environment::builder(format!("apartment/{seed}"));
    let home = builder.durations(Durations::default()).make().unwrap();
    let me = home.agents()[0];
    (home, me)
}

/// Performs an action in real time, and describes a failing action.
fn show(home: &mut Environment, verb: Verb, things: &[NodeId], watch: impl FnMut(&Environment)) {
    let (me, action) = (home.agents()[0], Action::with(verb, things).unwrap());
    let words = action.describe(home.graph()).to_string();
    let done = home.set_action_in_time(me, action, Span(1), watch);
    assert!(done.is_ok(), "{words}: {}", done.unwrap_err());
}

fn act(home: &mut Environment, verb: Verb, things: &[NodeId]) {
    show(home, verb, things, |_| {});
}

/// The first of these objects for which an attempt in a copy of the home succeeds.
fn first(home: &Environment, things: &[NodeId], tried: impl Fn(&mut Environment, NodeId) -> bool) -> Option<NodeId> {
    things.iter().copied().find(|id| tried(&mut home.clone(), *id))
}

/// Walks up to an object and performs a verb on it, if possible.
fn can(home: &mut Environment, verb: Verb, thing: NodeId) -> bool {
    let me = home.agents()[0];
    let walk = home.set_action(me, Action::one(Verb::Walk, thing));
    walk.is_ok() && home.set_action(me, Action::one(verb, thing)).is_ok()
}

/// Walks up to the first object of a kind on which a verb can be performed, and returns it.
fn go_for(home: &mut Environment, verb: Verb, kind: impl Fn(&virtualcity::graph::Node) -> bool) -> NodeId {
    let things: Vec<NodeId> = home.graph().nodes().filter(|n| kind(n)).map(|n| n.id()).collect();
    let found = first(home, &things, |home, id| can(home, verb, id));
    let found = found.unwrap_or_else(|| panic!("{verb:?} can be done with none of {things:?}"));
    act(home, Verb::Walk, &[found]);
    found
}

fn is_loose(home: &Environment, id: NodeId) -> bool {
    home.world().role(id) == Some(BodyRole::Loose)
}

fn affords(property: Property) -> impl Fn(&virtualcity::graph::Node) -> bool {
    move |n| n.affords(property)
}

fn at(home: &Environment, id: NodeId) -> Point3<f32> {
    home.world().aabb(id).unwrap().centre()
}

/// The poses of all nodes except agents.
fn poses(home: &Environment) -> BTreeMap<NodeId, Pose> {
    home.world().poses().into_iter().filter(|(id, _)| !home.agents().contains(id)).collect()
}

fn places(home: &Environment, id: NodeId) -> Vec<Place> {
    let mut places: Vec<Place> = home.graph().places(id).collect();
    places.sort_unstable();
    places
}

/// Compares the end of a shown action with the result of performing it at once.
fn ends_as_shown(home: &mut Environment, verb: Verb, things: &[NodeId]) {
    let before = home.clone();
    let mut ticks: Vec<Environment> = Vec::new();
    show(home, verb, things, |now| {
        ticks.push(now.clone());
        if ticks.len() > 2 {
            ticks.remove(0);
        }
    });
    let [last, end] = &ticks[..] else { panic!("{verb:?} is not shown") };
    assert_eq!(end.digest(), home.digest(), "{verb:?}");
    let me = home.agents()[0];
    let far = |a: &Pose, b: &Pose| (a.translation.vector - b.translation.vector).norm();
    let feet = |e: &Environment| e.world().pose(me).unwrap();
    assert!(far(&feet(last), &feet(end)) < SAME, "{verb:?}: feet");
    assert_eq!(last.posture(me), end.posture(me), "{verb:?}");
    let (shown, real, was) = (poses(last), poses(end), poses(&before));
    for (id, pose) in &real {
        let label = home.graph().label(*id);
        assert!(far(&shown[id], pose) < SAME, "{verb:?}: {label} is {} m off", far(&shown[id], pose));
        if was.get(id).is_some_and(|was| far(was, pose) > 0.1) {
            assert_eq!(places(last, *id), places(end, *id), "{verb:?}: {label}");
        }
        let open = |e: &Environment| e.world().parts(*id).all().iter().map(|p| p.open).collect::<Vec<f32>>();
        let off = open(last).iter().zip(open(end)).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
        assert!(off < 0.02, "{verb:?}: a part of {label} is {off} of its way off");
        assert_eq!(last.graph().node(*id).unwrap().states(), end.graph().node(*id).unwrap().states(), "{label}");
    }
}

/// In a whole errand, the last shown state of each action equals its result: the bodies, the held objects, the
/// placements, the open parts.
#[test]
fn shows_end_as_actions_do() {
    let (mut home, me) = home(42);
    let moves = |home: &Environment, id: NodeId| !home.world().parts(id).all().is_empty();
    let kept = |home: &Environment, at: NodeId| {
        home.graph().relating(Relation::Inside, at).find(|id| is_loose(home, *id) && home.graph().node(*id).is_some())
    };
    let shut: Vec<NodeId> = home.graph().nodes().filter(|n| n.hides_contents()).map(|n| n.id()).collect();
    let cupboard = shut.into_iter().find(|id| moves(&home, *id) && kept(&home, *id).is_some()).unwrap();
    let thing = kept(&home, cupboard).unwrap();
    let table = home.graph().of_class("coffee_table")[0];
    ends_as_shown(&mut home, Verb::Walk, &[cupboard]);
    ends_as_shown(&mut home, Verb::Open, &[cupboard]);
    ends_as_shown(&mut home, Verb::Grab, &[thing]);
    assert_eq!(home.world().held(me, Hand::Right), Some(thing));
    ends_as_shown(&mut home, Verb::Close, &[cupboard]);
    ends_as_shown(&mut home, Verb::Walk, &[table]);
    ends_as_shown(&mut home, Verb::Place, &[thing, table]);
    ends_as_shown(&mut home, Verb::Wash, &[thing]);
    ends_as_shown(&mut home, Verb::Dance, &[]);
}

/// An agent that walks through the home and its doors pushes nothing over or along; doors swing open in front
/// of it, and are as before behind it.
#[test]
fn walks_push_nothing_and_doors_swing() {
    let (mut swung, mut walked) = (0, 0.0_f32);
    for seed in [8, 42] {
        let (mut home, me) = home(seed);
        let doors: Vec<NodeId> = home.graph().of_class("door").to_vec();
        for room in home.graph().rooms().to_vec() {
            let open = |home: &Environment, id: NodeId| home.world().parts(id).openness().unwrap_or(0.0);
            let before = poses(&home);
            let was: Vec<f32> = doors.iter().map(|id| open(&home, *id)).collect();
            let mut widest = was.clone();
            let mut feet = home.world().pose(me).unwrap().translation.vector;
            show(&mut home, Verb::Walk, &[room], |now| {
                for (door, widest) in doors.iter().zip(&mut widest) {
                    *widest = (*widest).max(open(now, *door));
                }
                for (id, pose) in poses(now) {
                    let (a, b) = (pose.translation.vector, before[&id].translation.vector);
                    let lean = (pose.rotation * Vector3::z()).dot(&(before[&id].rotation * Vector3::z()));
                    assert!((a - b).norm() < 0.02 && lean > 0.98, "{} moves", now.graph().label(id));
                }
                let here = now.world().pose(me).unwrap().translation.vector;
                walked += (here - feet).norm();
                feet = here;
            });
            let is: Vec<f32> = doors.iter().map(|id| open(&home, *id)).collect();
            assert!(was.iter().zip(&is).all(|(a, b)| (a - b).abs() < 0.02), "{was:?}, then {is:?}");
            swung += was.iter().zip(&widest).filter(|(a, b)| **b > **a + 0.5).count();
        }
    }
    assert!(swung >= 4 && walked > 20.0, "{swung} doors swung in {walked} m");
}

/// An agent sits and lies on objects, is where the seat is, has the state, and gets up again beside the seat.
#[test]
fn one_sits_lies_sleeps_and_gets_up() {
    let (mut home, me) = home(42);
    for (verb, property, state) in
        [(Verb::Sit, Property::Sittable, State::Sitting), (Verb::Lie, Property::Lieable, State::Lying)]
    {
        let seat = go_for(&mut home, verb, affords(property));
        let standing = home.world().pose(me).unwrap().translation.vector;
        glide(&mut home, verb, &[seat]);
        assert!(home.graph().node(me).unwrap().is(state));
        let (pose, bounds) = (home.world().pose(me).unwrap().translation.vector, home.world().aabb(seat).unwrap());
        let off = bounds.nearest(&Point3::from(pose)) - Point3::from(pose);
        assert!(off.norm() < 0.15, "{verb:?}: {} m from {}", off.norm(), home.graph().label(seat));
        let rests = |p: Option<Posture>| match verb {
            Verb::Sit => matches!(p, Some(Posture::Sitting(on, _)) if on == seat),
            _ => matches!(p, Some(Posture::Lying(on, _)) if on == seat),
        };
        assert!(rests(home.posture(me)), "{:?}", home.posture(me));
        act(&mut home, Verb::Sleep, &[]);
        assert!(home.graph().node(me).unwrap().is(State::Asleep));
        act(&mut home, Verb::WakeUp, &[]);
        glide(&mut home, Verb::Stand, &[]);
        assert_eq!(home.posture(me), Some(Posture::Standing));
        assert!(!home.graph().node(me).unwrap().is(state));
        let up = home.world().pose(me).unwrap().translation.vector;
        assert!((up.z - standing.z).abs() < 0.05 && (up - standing).norm() < 2.5, "{up:?} after {standing:?}");
    }
}

#[cfg(feature = "render")]
/// Performs an action during which the eyes never jump.
fn glide(home: &mut Environment, verb: Verb, things: &[NodeId]) {
    let (mut last, mut most, mut ticks) = (eyes(home), 0.0_f32, 0);
    show(home, verb, things, |now| {
        most = most.max((eyes(now) - last).norm());
        (last, ticks) = (eyes(now), ticks + 1);
    });
    assert!(most < 0.08 && ticks > 30, "{verb:?}: the eyes leap {most} m in one of {ticks} ticks");
}

fn eyes(home: &Environment) -> Point3<f32> {
    let camera = home.camera(virtualcity::Viewpoint::Agent(home.agents()[0]), 8, 8).unwrap();
    Point3::from(camera.pose.translation.vector)
}

/// The smallest distance of an object from a point that may move, while an action is shown.
fn nearest(
    home: &mut Environment,
    verb: Verb,
    things: &[NodeId],
    thing: NodeId,
    to: impl Fn(&Environment) -> Point3<f32>,
) -> f32 {
    let mut best = f32::INFINITY;
    show(home, verb, things, |now| best = best.min((at(now, thing) - to(now)).norm()));
    best
}

/// Food and drink come to the mouth, reading matter in front of the eyes, standing and seated; the object stays
/// in the hand.
#[cfg(feature = "render")]
#[test]
fn one_eats_drinks_and_reads() {
    let (home, me) = home(42);
    for (verb, property) in
        [(Verb::Eat, Property::Eatable), (Verb::Drink, Property::Drinkable), (Verb::Read, Property::Readable)]
    {
        let mut home = home.clone();
        let thing = go_for(&mut home, Verb::Grab, affords(property));
        act(&mut home, Verb::Grab, &[thing]);
        let rest = (at(&home, thing) - eyes(&home)).norm();
        let near = nearest(&mut home, verb, &[thing], thing, eyes);
        assert!(near < 0.45 && near < rest - 0.05, "{verb:?}: {near} m from the eyes, {rest} m at rest");
        assert_eq!(home.world().held(me, Hand::Right), Some(thing));
        let seat = go_for(&mut home, Verb::Sit, affords(Property::Sittable));
        act(&mut home, Verb::Sit, &[seat]);
        let seated = nearest(&mut home, verb, &[thing], thing, eyes);
        assert!(seated < 0.45, "{verb:?}, seated: {seated} m from the eyes");
    }
}

/// A poured object comes above the target and fills it; a filled object is full.
#[test]
fn one_pours_and_fills() {
    let (mut home, me) = home(42);
    let drink = go_for(&mut home, Verb::Grab, |n| n.affords(Property::Drinkable) && n.affords(Property::Pourable));
    act(&mut home, Verb::Grab, &[drink]);
    let vessel = go_for(&mut home, Verb::Touch, |n| n.affords(Property::Recipient) && n.id() != drink);
    let above = |now: &Environment| {
        let bounds = now.world().aabb(vessel).unwrap();
        Point3::new(bounds.centre().x, bounds.centre().y, bounds.max.z)
    };
    let near = nearest(&mut home, Verb::Pour, &[drink, vessel], drink, above);
    assert!(near < 0.3, "{near} m above the vessel");
    assert!(home.graph().node(vessel).unwrap().contents().is_some());
    assert!(home.world().body(vessel).unwrap().level() > 0.5);
    assert_eq!(home.world().held(me, Hand::Right), Some(drink));
}

/// A wiped or washed object becomes clean, and the cloth moves to it.
#[test]
fn one_wipes() {
    let (mut home, _) = home(42);
    let cloth = go_for(&mut home, Verb::Grab, |n| n.affords(Property::Foldable) && n.affords(Property::Washable));
    act(&mut home, Verb::Grab, &[cloth]);
    let table = go_for(&mut home, Verb::Wipe, |n| n.class().ends_with("table"));
    let on_it = |now: &Environment| now.world().aabb(table).unwrap().nearest(&at(now, cloth));
    let near = nearest(&mut home, Verb::Wipe, &[table], cloth, on_it);
    assert!(near < 0.12, "{near} m from the table");
    assert!(home.graph().node(table).unwrap().is(State::Clean));
}

/// A taken object moves with the hand from its place, and one that is put down moves with the hand to its
/// place: nothing jumps.
#[test]
fn what_hands_move_does_not_leap() {
    let (mut home, _) = home(42);
    let thing = go_for(&mut home, Verb::Grab, |n| n.affords(Property::Readable) && n.affords(Property::Graspable));
    let mut last = at(&home, thing);
    let mut watch = |now: &Environment| {
        let here = at(now, thing);
        assert!((here - last).norm() < 0.1, "a leap of {} m", (here - last).norm());
        last = here;
    };
    show(&mut home, Verb::Grab, &[thing], &mut watch);
    show(&mut home, Verb::PutBack, &[thing], &mut watch);
}
