//! Points, headings, seats, slots and sides of actions, with bodies: they are met, or refused with the reason.

use nalgebra::{Point2, Vector3};
use virtualcity::graph::clock::Span;
use virtualcity::graph::{
    Action, Node, NodeId, ObjectRole, Place, Pose, Property, Refusal, Relation, Seed, Side, State, Stream, Verb,
};
use virtualcity::physics::{BodyRole, Posture};
use virtualcity::{ActionError, Environment, PhysicalRefusal, SpotRefusal};

use super::{act, home};

/// How far from the point asked for something may be, metres, and from the heading, degrees.
const OFF: f32 = 0.01;
const TURNED: f32 = 2.0;

/// How far a pose is from a point, metres, and its heading from degrees.
fn off(pose: &Pose, (x, y): (f64, f64), degrees: f64) -> (f32, f32) {
    let far = (pose.translation.vector.xy() - nalgebra::Vector2::new(x as f32, y as f32)).norm();
    let asked = nalgebra::UnitQuaternion::from_axis_angle(&Vector3::z_axis(), (degrees as f32).to_radians());
    (far, pose.rotation.angle_to(&asked).to_degrees())
}

fn is_met(pose: &Pose, point: (f64, f64), degrees: f64) -> bool {
    let (far, turned) = off(pose, point, degrees);
    far <= OFF && turned <= TURNED
}

/// A random point of a node's box seen from above, and a heading.
fn anywhere(home: &Environment, id: NodeId, stream: &mut Stream) -> ((f64, f64), f64) {
    let aabb = home.graph().node(id).unwrap().aabb().unwrap();
    let mut within = |axis: usize| f64::from(stream.between(aabb.min[axis], aabb.max[axis]));
    let point = (within(0), within(1));
    (point, f64::from(stream.between(-180.0, 180.0)))
}

/// Does an action at once and in time, with the same outcome, if it can be done; its refusal changes nothing.
fn tried(home: &mut Environment, agent: NodeId, action: Action) -> Result<(), ActionError> {
    let before = home.digest();
    let words = action.describe(home.graph()).to_string();
    assert_eq!(words.parse::<Action>().unwrap(), action, "{words}");
    let (mut timed, mut at_once) = (home.clone(), home.clone());
    let done = at_once.set_action(agent, action).map(drop);
    if matches!(done, Err(ActionError::Refused(_))) {
        assert_eq!(at_once.digest(), before, "{words}: a refusal has changed something");
        return done;
    }
    timed.give(agent, action);
    let ending = timed.step_until_idle(Span(36_000)).remove(0);
    assert_eq!(ending.outcome.map(drop), done, "{words} in time");
    assert_eq!(timed.digest(), at_once.digest(), "{words} in time");
    if done.is_ok() {
        *home = at_once;
    }
    done
}

/// Small loose things that stand free, nearest to the agent first.
fn small_things(home: &Environment, agent: NodeId) -> Vec<NodeId> {
    let graph = home.graph();
    let is_small = |n: &&Node| {
        let size = n.spec().bounds.map_or(9.0, |b| b.size().max());
        n.affords(Property::Graspable) && size < 0.25 && home.world().role(n.id()) == Some(BodyRole::Loose)
    };
    let is_free = |id: &NodeId| graph.hidden_in(*id).is_none() && graph.resting_at(*id).next().is_none();
    let mut things: Vec<NodeId> = graph.nodes().filter(is_small).map(Node::id).filter(is_free).collect();
    let far = |id: NodeId| graph.distance(agent, id).unwrap_or(f32::INFINITY);
    things.sort_by(|a, b| far(*a).total_cmp(&far(*b)));
    things
}

/// Takes the first of some small things that can be taken.
fn take_any(home: &mut Environment, agent: NodeId) -> NodeId {
    let things = small_things(home, agent);
    let takes = |id: &&NodeId| {
        let walked = home.set_action(agent, Action::walk(**id)).is_ok();
        walked && home.set_action(agent, Action::grab(**id)).is_ok()
    };
    *things.iter().find(takes).unwrap()
}

fn tables(home: &Environment) -> Vec<NodeId> {
    let is_table = |n: &&Node| n.affords(Property::Surface) && n.class().ends_with("table") || &**n.class() == "desk";
    home.graph().nodes().filter(is_table).map(Node::id).collect()
}

/// Things rest within a centimetre and two degrees of any point and heading at which they can be put, and the whole
/// history ends in the same bytes when it is done again, saved and restored.
#[test]
fn things_are_put_where_and_as_asked() {
    let (mut put, mut refused) = (0, 0);
    for seed in [3, 8, 42] {
        let (mut home, mut stream) = (home(seed, 1), Seed(seed).stream());
        let me = home.agents()[0];
        for table in tables(&home) {
            let thing = take_any(&mut home, me);
            for _ in 0..12 {
                let ((x, y), degrees) = anywhere(&home, table, &mut stream);
                // Beside it if one can stand there.
                if home.set_action(me, Action::walk(table)).is_err() {
                    break;
                }
                let place = Action::place(thing, table).at(x, y).unwrap().turned(degrees).unwrap();
                match tried(&mut home, me, place) {
                    Ok(()) => {
                        let pose = home.world().pose(thing).unwrap();
                        assert!(is_met(&pose, (x, y), degrees), "{place}: {:?}", off(&pose, (x, y), degrees));
                        assert_eq!(home.graph().node(thing).unwrap().pose(), Some(&pose));
                        act(&mut home, me, Verb::Grab, &[thing]);
                        put += 1;
                    }
                    Err(why) => {
                        refused += 1;
                        assert!(is_reason(&why), "{place}: {why}");
                    }
                }
            }
            act(&mut home, me, Verb::Drop, &[thing]);
        }
        same_again(&home, seed);
    }
    assert!(put > 30 && refused > 5, "{put} put, {refused} refused");
}

/// Whether an error says why a thing cannot be put to a point.
fn is_reason(why: &ActionError) -> bool {
    use PhysicalRefusal::{NoStand, NotAsAsked, OffAim};
    match why {
        ActionError::Refused(all) => all.iter().all(|r| {
            matches!(r, Refusal::PointOutOfReach { .. } | Refusal::PointElsewhere { .. } | Refusal::PointTaken { .. })
        }),
        ActionError::Impossible { why, .. } => matches!(why, NotAsAsked { .. } | OffAim { .. } | NoStand(_)),
        _ => false,
    }
}

/// A history ends in the same bytes when it is done again, and when it is restored.
fn same_again(done: &Environment, seed: u64) {
    let mut again = home(seed, done.agents().len());
    for event in done.history().events() {
        let line = event.action.to_string();
        again.set_action(event.agent, line.parse().unwrap()).unwrap();
    }
    assert_eq!(again.digest(), done.digest());
    let restored = home(seed, done.agents().len()).restore(&done.save().unwrap()).unwrap();
    assert_eq!((restored.digest(), restored.history()), (done.digest(), done.history()));
}

#[test]
fn spots_that_cannot_be_are_refused() {
    let mut home = home(42, 1);
    let me = home.agents()[0];
    let thing = take_any(&mut home, me);
    let table = tables(&home).into_iter().find(|id| home.set_action(me, Action::walk(*id)).is_ok()).unwrap();
    let aabb = home.graph().node(table).unwrap().aabb().unwrap();
    let (middle, half) = (aabb.centre(), (aabb.max - aabb.min) / 2.0);
    let at = |x: f32, y: f32| Action::place(thing, table).at(f64::from(x), f64::from(y)).unwrap();
    let why = tried(&mut home, me, at(middle.x + half.x + 0.1, middle.y)).unwrap_err();
    assert!(matches!(&why, ActionError::Refused(all) if matches!(all[0], Refusal::PointElsewhere { .. })), "{why}");
    // Over the edge: its middle is on the table, its sides are not.
    let near = home.world().pose(me).unwrap().translation.vector;
    let side = if (near.x - middle.x).abs() / half.x > (near.y - middle.y).abs() / half.y { 0 } else { 1 };
    let mut edge = middle;
    edge[side] += half[side] * (near[side] - middle[side]).signum();
    let why = tried(&mut home, me, at(edge.x, edge.y)).unwrap_err();
    let spot = |why: &ActionError| match why {
        ActionError::Impossible { why: PhysicalRefusal::NotAsAsked { why, .. }, .. } => why.clone(),
        other => panic!("{other}"),
    };
    assert!(matches!(spot(&why), SpotRefusal::WouldNotRest | SpotRefusal::OffSurface), "{why}");
    // Where another thing stands.
    let there = Action::place(thing, table).turned(20.0).unwrap();
    tried(&mut home, me, there).unwrap();
    let taken = home.world().pose(thing).unwrap().translation.vector;
    let other = take_any_but(&mut home, me, thing);
    act(&mut home, me, Verb::Walk, &[table]);
    let onto = Action::place(other, table).at(f64::from(taken.x), f64::from(taken.y)).unwrap();
    let ActionError::Refused(why) = tried(&mut home, me, onto).unwrap_err() else { panic!("the rule knows") };
    let stands = home.graph().label(thing);
    assert!(matches!(&why[..], [Refusal::PointTaken { by, .. }] if *by == stands), "{why:?}");
    // Beside its middle only bodies tell.
    let beside = Action::place(other, table).at(f64::from(taken.x) + 0.03, f64::from(taken.y)).unwrap();
    let why = tried(&mut home, me, beside).unwrap_err();
    assert!(matches!(spot(&why), SpotRefusal::Taken(by) if by.contains(&stands)), "{why}");
}

fn take_any_but(home: &mut Environment, agent: NodeId, not: NodeId) -> NodeId {
    let things = small_things(home, agent);
    let takes = |id: &&NodeId| {
        **id != not && {
            let mut tried = home.clone();
            let walked = tried.set_action(agent, Action::walk(**id)).is_ok();
            walked && tried.set_action(agent, Action::grab(**id)).is_ok()
        }
    };
    let thing = *things.iter().find(takes).unwrap();
    act(home, agent, Verb::Walk, &[thing]);
    act(home, agent, Verb::Grab, &[thing]);
    thing
}

/// One stands at any point where one can, turned as asked; at others something is, or no way leads there.
#[test]
fn one_goes_to_points() {
    let (mut stood, mut refused) = (0, 0);
    for seed in [8, 42] {
        let (mut home, mut stream) = (home(seed, 2), Seed(seed).stream());
        let me = home.agents()[0];
        let rooms = home.graph().rooms().to_vec();
        for room in rooms.iter().cycle().take(40) {
            let ((x, y), degrees) = anywhere(&home, *room, &mut stream);
            let walk = Action::zero(Verb::Walk).at(x, y).unwrap().turned(degrees).unwrap();
            match tried(&mut home, me, walk) {
                Ok(()) => {
                    let feet = home.world().pose(me).unwrap();
                    assert!(is_met(&feet, (x, y), degrees), "{walk}: {:?}", off(&feet, (x, y), degrees));
                    let room = home.room_at(Point2::new(x as f32, y as f32));
                    assert_eq!(home.graph().room_of(me), room, "{walk}");
                    stood += 1;
                }
                Err(ActionError::Impossible {
                    why: PhysicalRefusal::PointTaken { .. } | PhysicalRefusal::NoWay(_),
                    ..
                }) => {
                    refused += 1;
                }
                Err(ActionError::Refused(why)) => assert!(matches!(why[..], [Refusal::OutsideRooms(_)]), "{why:?}"),
                Err(why) => panic!("{walk}: {why}"),
            }
        }
        same_again(&home, seed);
    }
    assert!(stood > 15 && refused > 15, "{stood} stood, {refused} refused");
}

#[test]
fn nobody_goes_into_what_is_there() {
    let mut home = home(42, 2);
    let (me, other) = (home.agents()[0], home.agents()[1]);
    let at = |home: &Environment, id: NodeId| {
        let centre = home.graph().node(id).unwrap().aabb().unwrap().centre();
        Action::zero(Verb::Walk).at(f64::from(centre.x), f64::from(centre.y)).unwrap()
    };
    let wall = home.graph().nodes().find(|n| n.role() == ObjectRole::Wall).unwrap().id();
    for id in [tables(&home)[0], wall, other] {
        let walk = at(&home, id);
        match tried(&mut home, me, walk).unwrap_err() {
            ActionError::Impossible { why: PhysicalRefusal::PointTaken { by, .. }, .. } => {
                assert!(by.contains(&home.graph().label(id)), "{by:?}");
            }
            // Walls are between rooms.
            ActionError::Refused(why) => {
                assert!(id == wall && matches!(why[..], [Refusal::OutsideRooms(_)]), "{why:?}")
            }
            why => panic!("{walk}: {why}"),
        }
    }
    act(&mut home, me, Verb::TurnTo, &[other]);
    for degrees in [0.0, 90.0, -135.0] {
        tried(&mut home, me, Action::zero(Verb::TurnTo).turned(degrees).unwrap()).unwrap();
        let feet = home.world().pose(me).unwrap();
        assert!(off(&feet, (0.0, 0.0), degrees).1 < 0.1);
    }
    // Pointing turns to the place; a thing may come along to one.
    let feet = home.world().pose(me).unwrap().translation.vector;
    let up = Action::zero(Verb::PointAt).at_height(f64::from(feet.x) - 2.0, f64::from(feet.y), 1.8).unwrap();
    let mut shown = 0;
    home.set_action_in_time(me, up, Span(1), |_| shown += 1).unwrap();
    assert!(shown > 30 && off(&home.world().pose(me).unwrap(), (0.0, 0.0), 180.0).1 < 0.1);
    let fridge = home.graph().of_class("fridge")[0];
    act(&mut home, me, Verb::Walk, &[fridge]);
    let feet = home.world().pose(me).unwrap().translation.vector;
    let beside = Action::walk(fridge).at(f64::from(feet.x), f64::from(feet.y)).unwrap();
    tried(&mut home, me, beside).unwrap();
    tried(&mut home, me, Action::walk(fridge).turned(45.0).unwrap()).unwrap();
    assert!(off(&home.world().pose(me).unwrap(), (0.0, 0.0), 45.0).1 < 0.1);
}

/// A thing lands on the floor where it is let go.
#[test]
fn things_are_dropped_at_points() {
    let mut home = home(42, 1);
    let me = home.agents()[0];
    let thing = take_any(&mut home, me);
    let (mut stream, mut dropped) = (Seed(5).stream(), 0);
    for _ in 0..20 {
        let feet = home.world().pose(me).unwrap().translation.vector;
        let mut near = |at: f32| f64::from(at + stream.between(-1.0, 1.0));
        let (x, y, degrees) = (near(feet.x), near(feet.y), 30.0);
        let drop = Action::drop(thing).at(x, y).unwrap().turned(degrees).unwrap();
        if tried(&mut home, me, drop).is_ok() {
            let pose = home.world().pose(thing).unwrap();
            assert!(is_met(&pose, (x, y), degrees), "{drop}: {:?}", off(&pose, (x, y), degrees));
            act(&mut home, me, Verb::Grab, &[thing]);
            dropped += 1;
        }
    }
    assert!(dropped > 3, "{dropped}");
}

#[test]
fn one_sits_on_the_seat_asked_for() {
    let mut home = home(42, 2);
    let (me, other) = (home.agents()[0], home.agents()[1]);
    let sofas = home.graph().nodes().filter(|n| n.affords(Property::Sittable)).map(Node::id).collect::<Vec<_>>();
    let sofa = sofas.into_iter().find(|id| home.world().body(*id).unwrap().seats().len() > 1).unwrap();
    let (seats, label) = (home.world().body(sofa).unwrap().seats(), home.graph().label(sofa));
    for agent in [me, other] {
        act(&mut home, agent, Verb::Walk, &[sofa]);
    }
    let mut sat = 0;
    for (index, seat) in (0..).zip(&seats) {
        let sit = Action::sit(sofa).on_seat(index + 1);
        if let Err(why) = tried(&mut home, me, sit) {
            // A thing may lie on it, in which case it is named.
            assert!(why.to_string().contains(&format!("is in the way on {label}")), "{why}");
            continue;
        }
        assert_eq!(home.posture(me), Some(Posture::Sitting(sofa, u32::from(index))));
        let far = (home.world().pose(me).unwrap().translation.vector - seat.translation.vector).norm();
        assert!(far < OFF, "{far}");
        let taken = tried(&mut home, other, sit).unwrap_err().to_string();
        assert!(taken.contains(&format!("sits on seat {} of {label}", index + 1)), "{taken}");
        act(&mut home, me, Verb::Stand, &[]);
        sat += 1;
    }
    assert!(sat > 0);
    let none = tried(&mut home, me, Action::sit(sofa).on_seat(9)).unwrap_err();
    assert!(matches!(&none, ActionError::Refused(why) if matches!(why[..], [Refusal::NoSuchPart { .. }])), "{none}");
}

/// A thing hangs from the hand by the side by which it is taken.
#[test]
fn things_are_taken_by_a_side() {
    let home = home(42, 1);
    let me = home.agents()[0];
    let (mut taken, mut hung) = (0, 0);
    for thing in small_things(&home, me).into_iter().take(12) {
        let mut there = home.clone();
        if there.set_action(me, Action::walk(thing)).is_err() {
            continue;
        }
        let middle = |home: &Environment| {
            let (low, high) = home.world().body(thing).unwrap().local_bounds();
            let feet = home.world().pose(me).unwrap();
            feet.inverse_transform_point(&(home.world().pose(thing).unwrap() * nalgebra::center(&low, &high)))
        };
        for side in [Side::Front, Side::Back, Side::Left, Side::Right, Side::Top] {
            let (mut plain, mut by_side) = (there.clone(), there.clone());
            let (at, out) = there.world().body(thing).unwrap().side(side);
            let half = (at - there.world().aabb(thing).unwrap().centre()).norm();
            match tried(&mut by_side, me, Action::grab(thing).by_side(side)) {
                Ok(()) if plain.set_action(me, Action::grab(thing)).is_ok() => {
                    let (grabbed, grabbed_by_side) = (middle(&plain), middle(&by_side));
                    if out.z > 0.99 {
                        // Its middle is below the hand.
                        let below = grabbed.z - grabbed_by_side.z;
                        assert!((below - half).abs() < 0.01, "{side}: {below} {half}");
                        hung += 1;
                    }
                    taken += 1;
                }
                Ok(()) => {}
                Err(ActionError::Impossible { .. } | ActionError::Refused(_)) => {}
                Err(why) => panic!("{why}"),
            }
        }
    }
    assert!(taken > 10 && hung > 3, "{taken} {hung}");
}

/// A thing is put on the shelf, or into the drawer, that is asked for.
#[test]
fn things_are_put_into_slots() {
    let mut home = home(42, 1);
    let me = home.agents()[0];
    let thing = take_any(&mut home, me);
    let inner = |home: &Environment, id: NodeId| {
        let all = home.world().body(id).unwrap().support_surfaces();
        all.into_iter().filter(|s| s.hold == virtualcity::graph::asset::Hold::Inside).collect::<Vec<_>>()
    };
    let shelved = |n: &&Node| n.affords(Property::Container) && inner(&home, n.id()).len() > 2;
    let containers: Vec<NodeId> = home.graph().nodes().filter(shelved).map(Node::id).collect();
    let mut put = 0;
    for at in containers {
        let mut home = home.clone();
        if home.set_action(me, Action::walk(at)).is_err()
            || home.graph().node(at).unwrap().is(State::Closed) && home.set_action(me, Action::open(at)).is_err()
        {
            continue;
        }
        for (index, shelf) in (1..).zip(inner(&home, at)) {
            let mut home = home.clone();
            if tried(&mut home, me, Action::put_in(thing, at).in_slot(index)).is_ok() {
                let own = shelf.pose.inverse_transform_point(&home.world().aabb(thing).unwrap().centre());
                assert!(
                    own.x.abs() < shelf.half.0 && own.y.abs() < shelf.half.1 && own.z > 0.0 && own.z < 0.3,
                    "{own}"
                );
                assert!(home.graph().related(thing, Relation::Inside).any(|id| id == at));
                put += 1;
            }
        }
        let none = tried(&mut home, me, Action::put_in(thing, at).in_slot(99)).unwrap_err();
        assert!(
            matches!(&none, ActionError::Refused(why) if matches!(why[..], [Refusal::NoSuchPart { .. }])),
            "{none}"
        );
    }
    assert!(put > 3, "{put}");
}

/// An action that is shown ends as the same one done at once.
#[test]
fn aims_are_shown() {
    let mut home = home(42, 1);
    let me = home.agents()[0];
    let thing = take_any(&mut home, me);
    let table = tables(&home).into_iter().find(|id| home.set_action(me, Action::walk(*id)).is_ok()).unwrap();
    let place = Action::place(thing, table).turned(120.0).unwrap();
    let feet = home.world().pose(me).unwrap().translation.vector;
    let walk = Action::zero(Verb::Walk).at(f64::from(feet.x), f64::from(feet.y)).unwrap().turned(10.0).unwrap();
    for action in [place, walk, Action::grab(thing).by_side(Side::Top)] {
        let mut at_once = home.clone();
        let (shown, done) = (home.set_action_in_time(me, action, Span(1), |_| {}), at_once.set_action(me, action));
        assert_eq!(shown.is_ok(), done.is_ok(), "{action}");
        assert_eq!(home.digest(), at_once.digest(), "{action}");
    }
}

/// Cloth that is too large for a drawer as it is, is folded into the one that is asked for.
#[test]
fn cloth_is_folded_into_a_drawer() {
    let (mut put, mut asked) = (0, 0);
    for seed in [112, 2711, 42, 7] {
        let mut home = home(seed, 1);
        let me = home.agents()[0];
        let Some(dresser) = home.graph().first_of_class("dresser") else { continue };
        let room = home.graph().room_of(dresser).unwrap();
        let Ok(shirt) = home.spawn("shirt", Place { relation: Relation::InRoom, at: room }) else { continue };
        for action in [Action::walk(shirt), Action::grab(shirt), Action::walk(dresser), Action::open(dresser)] {
            home.set_action(me, action).unwrap();
        }
        for slot in 1..=4 {
            let action = Action::two(Verb::PutIn, shirt, dresser).in_slot(slot);
            asked += 1;
            put += usize::from(home.clone().set_action(me, action).is_ok());
        }
    }
    assert!(asked > 3 && put * 2 > asked, "{put} of {asked}");
}
