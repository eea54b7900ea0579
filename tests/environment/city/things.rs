//! Things that go from region to region by themselves: they roll, slide, fall, and are pushed through portals.

use std::error::Error;
use std::f32::consts::FRAC_PI_2;
use std::sync::Arc;

use virtualcity::graph::asset::{Joint, JointKind, Material, Part, Shape};
use virtualcity::graph::clock::Span;
use virtualcity::graph::space::{Portal, PortalKind, Region, RegionFrame, RegionId, RegionKind, Space, SpaceBuilder};
use virtualcity::graph::{
    Action, Asset, AssetLibrary, Bounds, Draft, NodeId, Pose, Relation, SceneBuilder, SceneGraph, State, Verb,
};
use virtualcity::nalgebra::{Point3, Vector3};
use virtualcity::{City, CityError, CityViolation, RegionScenes};

use super::side;

const HALL: RegionId = RegionId(1);
const TERRACE: RegionId = RegionId(2);
/// The threshold of the hall.
const EDGE: f32 = 5.0;

/// A thing of the hall or of the terrace: its class, the half lengths of its box or its radius, where its middle is.
type Thing = (RegionId, &'static str, [f32; 3], [f32; 3]);

/// A hall and a terrace side by side, 5 by 5 m each, joined by an opening of 1.4 m, or by a door that swings out over the
/// terrace.
#[derive(Clone)]
struct Rooms {
    space: Arc<Space>,
    things: Vec<Thing>,
    door: bool,
}

/// Two rooms with things, the terrace turned and somewhere else in its own frame.
fn rooms(door: bool, things: &[Thing]) -> Rooms {
    let mut plan = SpaceBuilder::new();
    let house = Region::new(RegionKind::Building, "house").at(RegionFrame::new([400.0, -30.0, 6.0], 0.65));
    let house = plan.add(house).unwrap();
    let hall = Region::new(RegionKind::Yard, "hall").within(house).with_numbers(100);
    plan.add(hall).unwrap();
    let at = RegionFrame::new([10.0, 0.0, 0.0], f64::from(FRAC_PI_2));
    let terrace = Region::new(RegionKind::Yard, "terrace").within(house).at(at).with_numbers(100);
    plan.add(terrace).unwrap();
    let sides = [side(HALL, [EDGE, 2.5, 0.0], 0.0), side(TERRACE, [2.5, 5.0, 0.0], FRAC_PI_2)];
    let kind = if door { PortalKind::Door } else { PortalKind::Passage };
    let portal = Portal::new(kind, sides, 1.4, 2.1);
    let portal = if door { portal.with_leaf(NodeId(hall_number() + 2)) } else { portal };
    plan.join(portal).unwrap();
    Rooms { space: Arc::new(plan.build()), things: things.to_vec(), door }
}

/// The first number of the hall: that of its room; its floor and door follow.
fn hall_number() -> u32 {
    let mut plan = SpaceBuilder::new();
    let house = plan.add(Region::new(RegionKind::Building, "house")).unwrap();
    plan.add(Region::new(RegionKind::Yard, "hall").within(house).with_numbers(100)).unwrap();
    plan.build().region(HALL).unwrap().numbers.first
}

fn wood() -> Material {
    let (colour, emission) = ([0.6, 0.4, 0.2], [0.0; 3]);
    let (density, friction, restitution) = (300.0, 0.4, 0.2);
    let looks = (0.6, 0.0, 0.0);
    Material {
        name: "wood".into(),
        colour,
        density,
        friction,
        restitution,
        roughness: looks.0,
        metallic: looks.1,
        transmission: looks.2,
        emission,
        texture: None,
    }
}

pub(super) fn part(shape: Shape, at: [f32; 3]) -> Part {
    Part { name: "part".into(), shape, material: 0, pose: Pose::translation(at[0], at[1], at[2]), joint: None }
}

pub(super) fn asset(parts: Vec<Part>) -> Asset {
    Asset { name: "thing".into(), parts, ..Asset::default() }
}

/// A leaf of 1.4 m, whose hinge is at its right end as seen from the hall, and which opens over the terrace.
fn leaf() -> Asset {
    let anchor = Point3::new(0.0, -0.7, 0.0);
    let hinge = Joint { kind: JointKind::Hinge, anchor, axis: -Vector3::z(), limits: (0.0, 1.5) };
    let board = part(Shape::Box { half: Vector3::new(0.02, 0.68, 1.0) }, [0.0, 0.0, 1.05]);
    asset(vec![Part { joint: Some(hinge), ..board }])
}

impl RegionScenes for Rooms {
    fn space(&self) -> &Arc<Space> {
        &self.space
    }

    fn scene(&self, region: RegionId) -> Result<SceneGraph, Box<dyn Error + Send + Sync>> {
        let plan = self.space.region(region).ok_or("no region")?;
        let (mut scene, mut library) = (SceneBuilder::new(&*plan.name), AssetLibrary::default());
        scene.numbers(plan.numbers);
        library.add_material(wood())?;
        let room = Bounds::standing([5.0, 5.0, 2.5].into());
        let room = scene.add(Draft::new("hallway").bounds(room).at(Pose::translation(2.5, 2.5, 0.0)))?;
        let slab = Bounds::standing([5.0, 5.0, 0.1].into());
        let floor = scene.add_in(room, Draft::new("floor").bounds(slab).at(Pose::translation(2.5, 2.5, -0.1)))?;
        if self.door && region == HALL {
            let leaf = library.add(leaf())?;
            let door = Draft::new("door").at(Pose::translation(EDGE, 2.5, 0.0));
            scene.add_in(room, Draft { asset: Some(leaf), ..door })?;
        }
        let frame = |at: RegionId| self.space.region(at).ok_or("no region").map(|plan| plan.frame);
        let here = frame(HALL)?.to(&frame(region)?);
        for (_, class, half, at) in self.things.iter().filter(|(at, ..)| *at == region) {
            let shape = match class {
                &"ball" => Shape::Sphere { radius: half[0] },
                _ => Shape::Box { half: (*half).into() },
            };
            let legs = [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]];
            let parts = match class {
                &"table" => {
                    let leg = |[x, y]: [f32; 2]| {
                        let at = [x * (half[0] - 0.03), y * (half[1] - 0.03), -half[2] + 0.03];
                        part(Shape::Box { half: Vector3::new(0.03, 0.03, half[2] - 0.03) }, [at[0], at[1], -0.03])
                    };
                    let top =
                        part(Shape::Box { half: Vector3::new(half[0], half[1], 0.03) }, [0.0, 0.0, half[2] - 0.03]);
                    legs.map(leg).into_iter().chain([top]).collect()
                }
                _ => vec![part(shape, [0.0; 3])],
            };
            let draft = Draft { asset: Some(library.add(asset(parts))?), ..Draft::new(*class) };
            scene.add_on(floor, draft.at(here * Pose::translation(at[0], at[1], at[2])))?;
        }
        scene.assets(Arc::new(library));
        Ok(scene.build())
    }
}

fn city(door: bool, things: &[Thing], agents: usize) -> City {
    let mut city = City::of(rooms(door, things)).agents(0).make().unwrap();
    (0..agents).for_each(|_| _ = city.add_agent(HALL).unwrap());
    city
}

/// The things of a class, wherever they were made, in the order of their numbers.
fn all(city: &City, class: &str) -> Vec<NodeId> {
    let of = |region| city.peek(region).unwrap().graph().of_class(class).to_vec();
    [HALL, TERRACE].into_iter().flat_map(of).collect()
}

/// The middle of a thing in the frame of the hall.
fn middle(city: &City, thing: NodeId) -> Point3<f32> {
    let region = city.region_of(thing).unwrap();
    let shift = city.frame(region).unwrap().to(&city.frame(HALL).unwrap());
    shift * city.peek(region).unwrap().world().body(thing).unwrap().centre_of_mass()
}

/// Pushes a thing along an axis of the hall's frame, so that it would have a speed alone, metres a second.
fn push(city: &mut City, thing: NodeId, velocity: [f32; 3]) {
    let region = city.region_of(thing).unwrap();
    let turn = city.frame(HALL).unwrap().to(&city.frame(region).unwrap()).rotation;
    let there = city.peek(region).unwrap();
    let body = there.world().body(thing).unwrap();
    let impulse = turn * Vector3::from(velocity) * body.mass();
    city.push(thing, impulse, body.centre_of_mass()).unwrap();
}

/// Whether all regions are sound, and everything is in the region where its middle is.
fn check(city: &City, things: &[NodeId]) {
    for region in [HALL, TERRACE] {
        let there = city.peek(region).unwrap();
        assert_eq!(there.graph().validate(), [], "{region}");
        assert!(there.world().outside().is_empty() && there.world().stopped().is_empty());
    }
    for thing in things {
        let (at, own) = (middle(city, *thing), city.region_of(*thing).unwrap());
        let there = city.peek(own).unwrap();
        let is_thing = |id: NodeId| things.contains(&id);
        let region = if at.x > EDGE { TERRACE } else { HALL };
        let goes_along = there.graph().places(*thing).any(|place| is_thing(place.at));
        assert!(goes_along || (at.x - EDGE).abs() < 0.03 || own == region, "{thing} at {at}");
        assert!(at.z > 0.0, "{thing} at {at}");
    }
}

/// A ball rolls through an opening, is a thing of the next region then, and rolls on at its speed.
#[test]
fn a_ball_rolls_into_the_next_region() {
    let ball: Thing = (HALL, "ball", [0.1; 3], [3.5, 2.5, 0.1]);
    let mut city = city(false, &[ball], 1);
    let ball = all(&city, "ball")[0];
    assert!(city.environment(TERRACE).is_none());
    push(&mut city, ball, [1.5, 0.0, 0.0]);
    let mut speeds = Vec::new();
    for _ in 0..600 {
        city.step(Span(1));
        let region = city.region_of(ball).unwrap();
        speeds.push((
            region,
            city.peek(region).unwrap().world().body(ball).unwrap().velocity().norm(),
            middle(&city, ball),
        ));
    }
    let crossing = speeds.iter().position(|(region, ..)| *region == TERRACE).expect("it comes through");
    let [before, after] = [crossing - 1, crossing + 3].map(|at| speeds[at].1);
    assert!(after > before * 0.95 && before > 0.5, "{before} m/s before, {after} after");
    assert!((speeds[crossing].2.x - EDGE).abs() < 0.06);
    let rise = speeds.iter().map(|(.., at)| at.z).fold(0.0, f32::max);
    assert!(rise < 0.105, "it hops to {rise}");
    city.step(Span::from_seconds(20.0));
    check(&city, &[ball]);
    assert!(middle(&city, ball).x > EDGE + 0.5);
    let terrace = city.peek(TERRACE).unwrap();
    assert!(terrace.graph().room_of(ball).is_some() && city.peek(HALL).unwrap().graph().node(ball).is_none());
    assert!(city.environment(TERRACE).is_none(), "it sleeps again, and keeps the ball");
}

/// However time is divided, saved and restored in between: the same city.
#[test]
fn a_ball_on_its_way_is_saved_and_divided() {
    let ball: Thing = (HALL, "ball", [0.1; 3], [4.0, 2.5, 0.1]);
    let start = city(false, &[ball], 1);
    let ball = all(&start, "ball")[0];
    let rolled = |steps: &[u64]| {
        let mut city = start.clone();
        push(&mut city, ball, [1.2, 0.1, 0.0]);
        for ticks in steps {
            city.step(Span(*ticks));
            city = start.restore(&city.save().unwrap()).unwrap();
        }
        assert_eq!(city.region_of(ball), Some(TERRACE));
        city.digest()
    };
    let whole = rolled(&[420]);
    assert_eq!(rolled(&[60; 7]), whole);
    assert_eq!(rolled(&[30, 15, 7, 3, 1, 1, 1, 1, 1, 360]), whole);
}

/// A ball that hits an equal one beyond the threshold gives it its momentum, though that is a thing of a region where
/// nobody is.
#[test]
fn what_is_hit_beyond_a_threshold_gives_way() {
    let hit = |region: RegionId, [left, right]: [f32; 2]| {
        let at = |x: f32| [x - left, 2.5 - right, 0.1];
        let balls: [Thing; 2] = [(HALL, "ball", [0.1; 3], at(4.2)), (region, "ball", [0.1; 3], at(5.25))];
        let mut city = city(false, &balls, 1);
        let [one, other] = all(&city, "ball")[..] else { panic!("two balls") };
        push(&mut city, one, [2.0, 0.0, 0.0]);
        let mut fastest = 0.0_f32;
        for _ in 0..90 {
            city.step(Span(1));
            let there = city.peek(city.region_of(other).unwrap()).unwrap();
            fastest = fastest.max(there.world().body(other).unwrap().velocity().norm());
        }
        (fastest, city, [one, other])
    };
    let (speed, mut city, [one, other]) = hit(TERRACE, [0.0; 2]);
    let (within, ..) = hit(HALL, [2.5, 1.6]);
    assert!(within > 0.5 && (speed - within).abs() < 0.2 * within, "{speed} m/s, within a region {within}");
    city.step(Span::from_seconds(20.0));
    check(&city, &[one, other]);
    let apart = (middle(&city, one) - middle(&city, other)).norm();
    assert!(apart > 0.19, "{apart}");
}

/// A pile on the threshold stands, each thing in the region of what it stands on, and falls over into both.
#[test]
fn a_stack_on_a_threshold_stands_and_falls() {
    let at = |storey: u32| [EDGE - 0.01, 2.5, 0.15 + 0.3 * storey as f32];
    let boxes: Vec<Thing> = (0..5).map(|storey| (HALL, "box", [0.15; 3], at(storey))).collect();
    let mut city = city(false, &boxes, 1);
    let boxes = all(&city, "box");
    let before: Vec<_> = boxes.iter().map(|id| middle(&city, *id)).collect();
    city.step(Span::from_seconds(10.0));
    for (id, before) in boxes.iter().zip(&before) {
        assert!((middle(&city, *id) - before).norm() < 0.01, "{id} stands");
    }
    push(&mut city, boxes[4], [3.0, 0.0, 0.0]);
    push(&mut city, boxes[3], [4.0, 0.0, 0.0]);
    city.step(Span::from_seconds(20.0));
    assert!(city.environment(HALL).unwrap().world().awake() == 0, "all rests");
    check(&city, &boxes);
    let over = boxes.iter().filter(|id| city.region_of(**id) == Some(TERRACE)).count();
    assert!(over >= 1, "none has fallen over the threshold");
    let digest = city.digest();
    assert_eq!(city.clone().digest(), digest);
}

/// A table across the threshold stands on both floors; pushed on, it goes over with what is on it.
#[test]
fn a_table_goes_across_with_its_cups() {
    let mut things: Vec<Thing> = vec![(HALL, "table", [0.5, 0.4, 0.36], [4.6, 2.5, 0.36])];
    things.extend([-0.2, 0.0, 0.2].map(|y| (HALL, "box", [0.04; 3], [4.6, 2.5 + y, 0.76])));
    let mut city = city(false, &things, 1);
    let (table, cups) = (all(&city, "table")[0], all(&city, "box"));
    let level = middle(&city, table).z;
    for _ in 0..30 {
        push(&mut city, table, [0.6, 0.0, 0.0]);
        city.step(Span::from_seconds(1.5));
        assert!((middle(&city, table).z - level).abs() < 0.02, "it does not tilt: {}", middle(&city, table));
        if middle(&city, table).x > EDGE + 0.7 {
            break;
        }
    }
    assert_eq!(city.region_of(table), Some(TERRACE));
    check(&city, &[&[table][..], &cups].concat());
    let terrace = city.peek(TERRACE).unwrap();
    for cup in &cups {
        assert!(terrace.graph().relating(Relation::On, table).any(|id| id == *cup), "{cup} is on the table");
    }
}

/// A shut door keeps things out on its far side, where it is no thing; an open one lets them in.
#[test]
fn a_shut_door_stops_a_ball() {
    let ball: Thing = (TERRACE, "ball", [0.1; 3], [6.0, 2.6, 0.1]);
    let mut city = city(true, &[ball], 1);
    let (me, ball) = (city.agents().next().unwrap(), all(&city, "ball")[0]);
    let door = all(&city, "door")[0];
    push(&mut city, ball, [-2.0, 0.0, 0.0]);
    city.step(Span::from_seconds(10.0));
    assert_eq!(city.region_of(ball), Some(TERRACE));
    assert!(middle(&city, ball).x > EDGE);
    // Out of the way of the leaf.
    push(&mut city, ball, [0.8, 0.0, 0.0]);
    city.step(Span::from_seconds(10.0));
    city.set_action(me, Action::walk(door)).unwrap();
    city.set_action(me, Action::one(Verb::Open, door)).unwrap();
    city.set_action(me, "walk at 1 1".parse().unwrap()).unwrap();
    let there = middle(&city, ball);
    assert!(city.region_of(ball) == Some(TERRACE) && there.x > EDGE + 0.5, "{there}");
    let to = Vector3::new(EDGE - 1.0, 2.5, there.z) - there.coords;
    push(&mut city, ball, (to.normalize() * 1.6).into());
    city.step(Span::from_seconds(15.0));
    assert_eq!(city.region_of(ball), Some(HALL), "{}", middle(&city, ball));
    check(&city, &[ball]);
}

/// A door that swings out into a region where nobody is pushes what stands there out of its way.
#[test]
fn a_leaf_pushes_what_stands_beyond() {
    let crate_: Thing = (TERRACE, "box", [0.2; 3], [5.55, 2.7, 0.2]);
    let mut city = city(true, &[crate_], 1);
    let (me, door, thing) = (city.agents().next().unwrap(), all(&city, "door")[0], all(&city, "box")[0]);
    let before = middle(&city, thing);
    city.set_action(me, Action::walk(door)).unwrap();
    city.set_action(me, Action::one(Verb::Open, door)).unwrap();
    city.step(Span::from_seconds(5.0));
    assert!(city.peek(HALL).unwrap().graph().node(door).unwrap().is(State::Open));
    assert_eq!(city.region_of(thing), Some(TERRACE), "it has come back");
    let moved = (middle(&city, thing) - before).norm();
    assert!(moved > 0.05, "it moved {moved} m");
    check(&city, &[thing]);
}

/// Whoever shuts a door with something on its line pushes it away, or the door stays open; it is never in the shut leaf.
#[test]
fn a_leaf_is_shut_through_nothing() {
    let mut kept_open = 0;
    for (class, half, y) in [("ball", [0.1; 3], 2.5), ("box", [0.2; 3], 2.2), ("box", [0.35, 0.35, 0.6], 2.6)] {
        // It stands inside, and is pushed onto the line while the door is open.
        let thing: Thing = (HALL, class, half, [4.3, y, half[2]]);
        let mut city = city(true, &[thing], 1);
        let (me, door, thing) = (city.agents().next().unwrap(), all(&city, "door")[0], all(&city, class)[0]);
        city.set_action(me, Action::walk(door)).unwrap();
        city.set_action(me, Action::one(Verb::Open, door)).unwrap();
        city.set_action(me, "walk at 3 4".parse().unwrap()).unwrap();
        for _ in 0..40 {
            if middle(&city, thing).x > EDGE - 0.05 {
                break;
            }
            push(&mut city, thing, [0.4, 0.0, 0.0]);
            city.step(Span::from_seconds(1.5));
        }
        let on_line = middle(&city, thing);
        assert!((on_line.x - EDGE).abs() < 0.3, "{class} at {on_line}");
        let _ = city.set_action(me, Action::walk(door));
        let shut = city.set_action(me, Action::one(Verb::Close, door));
        city.step(Span::from_seconds(10.0));
        let is_shut = city.peek(HALL).unwrap().graph().node(door).unwrap().is(State::Closed);
        assert_eq!(city.validate().unwrap(), [], "{class} {half:?}, shut: {is_shut}");
        assert!(is_shut || shut.is_err());
        kept_open += usize::from(!is_shut);
    }
    assert!(kept_open < 3, "nothing was pushed away");
}

/// Whatever reaches over the edge of the floor and down is below it before it is outside.
#[test]
fn what_falls_off_the_edge_is_listed() {
    let thing: Thing = (TERRACE, "box", [0.2; 3], [9.7, 2.5, 0.2]);
    let mut city = city(false, &[thing], 1);
    let thing = all(&city, "box")[0];
    assert_eq!(city.validate().unwrap(), []);
    push(&mut city, thing, [2.5, 0.0, 0.0]);
    let is_below = |violation: &CityViolation| matches!(violation, CityViolation::BelowFloor { thing: low, .. } if low.id == thing);
    let listed = (0..300).any(|_| {
        city.step(Span(1));
        city.validate().unwrap().iter().any(is_below)
    });
    assert!(listed && middle(&city, thing).z > -1.0, "{}", middle(&city, thing));
}

/// Numbers of nothing are told as such, and change nothing.
#[test]
fn what_is_nowhere_is_told() {
    let mut city = city(false, &[], 1);
    let (before, nobody) = (city.digest(), NodeId(4_000_000_000));
    let pushed = city.push(nobody, Vector3::z(), Point3::origin()).unwrap_err();
    assert!(matches!(pushed, CityError::NoSuchThing(id) if id == nobody), "{pushed}");
    assert!(pushed.to_string().contains("4000000000"), "{pushed}");
    city.interrupt(nobody);
    assert_eq!(city.digest(), before);
}
