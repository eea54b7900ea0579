//! Things that are thrown over the parapets of galleries and balconies of buildings.

use std::error::Error;
use std::sync::Arc;

use virtualcity::graph::asset::Shape;
use virtualcity::graph::clock::Span;
use virtualcity::graph::space::{RegionId, Space};
use virtualcity::graph::{
    Action, Asset, AssetLibrary, Draft, NodeId, ObjectRole, Pose, SceneBuilder, SceneGraph, Seed, Verb,
};
use virtualcity::nalgebra::{Point3, Vector3};
use virtualcity::physics::BodyRole;
use virtualcity::procgen::Building;
use virtualcity::{City, RegionScenes};

use super::things::{asset, part};

const RADIUS: f32 = 0.06;

/// A building with a ball on the floor of a region, or in an open box there.
#[derive(Clone)]
struct WithBall {
    building: Arc<Building>,
    region: RegionId,
    at: Point3<f32>,
    boxed: bool,
}

/// An open box on its base.
fn open_box() -> Asset {
    let wall = |half: [f32; 3], at: [f32; 3]| part(Shape::Box { half: half.into() }, at);
    let [x, y] =
        [0.12, -0.12].map(|at| [wall([0.01, 0.13, 0.1], [at, 0.0, 0.1]), wall([0.11, 0.01, 0.1], [0.0, at, 0.1])]);
    asset([wall([0.13, 0.13, 0.01], [0.0, 0.0, 0.01])].into_iter().chain(x).chain(y).collect())
}

impl RegionScenes for WithBall {
    fn space(&self) -> &Arc<Space> {
        self.building.space()
    }

    fn scene(&self, region: RegionId) -> Result<SceneGraph, Box<dyn Error + Send + Sync>> {
        let made = self.building.scene(region)?;
        if region != self.region {
            return Ok(made);
        }
        let floor = made.of_role(ObjectRole::Floor).next().ok_or("no floor")?.id();
        let mut library = AssetLibrary::clone(made.assets());
        let ball = library.add(asset(vec![part(Shape::Sphere { radius: RADIUS }, [0.0; 3])]))?;
        let numbers = self.space().region(region).ok_or("no region")?.numbers;
        let mut scene = SceneBuilder::from_graph(made);
        let around = library.add(open_box())?;
        scene.assets(Arc::new(library)).numbers(numbers);
        let at = Pose::translation(self.at.x, self.at.y, self.at.z + RADIUS);
        if self.boxed {
            let at = Pose::translation(self.at.x, self.at.y, self.at.z);
            let around = scene.add_on(floor, Draft { asset: Some(around), ..Draft::new("box") }.at(at))?;
            let at = at * Pose::translation(0.0, 0.0, 0.02 + RADIUS);
            scene.add_in(around, Draft { asset: Some(ball), ..Draft::new("ball") }.at(at))?;
            return Ok(scene.build());
        }
        scene.add_on(floor, Draft { asset: Some(ball), ..Draft::new("ball") }.at(at))?;
        Ok(scene.build())
    }
}

/// A city with a ball at a place of a region, which lies still.
fn city(building: &Arc<Building>, region: RegionId, at: Point3<f32>) -> (City, NodeId) {
    let scenes = WithBall { building: building.clone(), region, at, boxed: false };
    let city = City::of(scenes).agents(0).make().unwrap();
    let ball = city.peek(region).unwrap().graph().of_class("ball")[0];
    (city, ball)
}

/// Gives a thing a speed, metres a second in the frame of its region.
fn throw(city: &mut City, thing: NodeId, speed: [f32; 3]) {
    let there = city.peek(city.region_of(thing).unwrap()).unwrap();
    let body = there.world().body(thing).unwrap();
    city.push(thing, Vector3::from(speed) * body.mass(), body.centre_of_mass()).unwrap();
}

/// Lets a thing come to rest; where it lies, and on what.
fn landed(city: &mut City, thing: NodeId) -> (RegionId, Vec<String>) {
    city.step(Span::from_seconds(30.0));
    let region = city.region_of(thing).unwrap();
    let there = city.peek(region).unwrap();
    let at = there.graph().places(thing).map(|place| there.graph().label(place.at).to_string());
    (region, at.collect())
}

/// Whatever is thrown over the railing of a gallery lands in the yard or on the gallery below, and is a thing of the region
/// where it lies.
#[test]
fn what_is_thrown_over_a_railing_lands_below() {
    let building = Arc::new(Building::from_seed(Seed(7)).unwrap());
    let mut in_yard = 0;
    for (storey, speed) in [
        (2, [0.2, -1.6, 6.0]),
        (1, [0.6, -1.4, 6.0]),
        (0, [-0.4, -1.5, 6.0]),
        (2, [-1.5, -0.2, 6.0]),
        (1, [1.5, -0.2, 6.0]),
        (0, [1.5, -0.2, 6.0]),
    ] {
        let gallery = building.storeys()[storey].gallery;
        let start = Point3::new(if speed[0] < 0.0 { -2.9 } else { 2.9 }, 0.6, 0.0);
        let (mut city, ball) = city(&building, gallery, start);
        let made = city.clone();
        throw(&mut city, ball, speed);
        city.step(Span(50));
        let mut restored = made.restore(&city.save().unwrap()).unwrap();
        let (region, at) = landed(&mut city, ball);
        assert_eq!(city.validate().unwrap(), [], "{storey} {speed:?}");
        assert!(region != gallery && !at.is_empty(), "{storey} {speed:?}: still in {region}, at {at:?}");
        in_yard += usize::from(region == building.yard());
        assert_eq!(landed(&mut restored, ball), (region, at));
        assert_eq!(restored.digest(), city.digest());
    }
    assert!(in_yard >= 4, "{in_yard}");
}

/// Somebody who walks about meanwhile has no part in it: the thing lies where it has landed.
#[test]
fn what_lands_before_somebody_who_acts_stays_there() {
    let building = Arc::new(Building::from_seed(Seed(7)).unwrap());
    let gallery = building.storeys()[0].gallery;
    let scenes = WithBall { building: building.clone(), region: gallery, at: Point3::new(0.0, 0.7, 0.0), boxed: false };
    let mut city = City::of(scenes).agents(1).make().unwrap();
    let (me, ball) = (city.agents().next().unwrap(), city.peek(gallery).unwrap().graph().of_class("ball")[0]);
    city.go(me, building.yard()).unwrap();
    let bush = city.peek(building.yard()).unwrap().graph().of_class("bush")[0];
    city.give(me, Action::walk(bush)).unwrap();
    throw(&mut city, ball, [1.2, -1.6, 6.0]);
    let (region, at) = landed(&mut city, ball);
    assert!(region == building.yard() && !at.is_empty(), "{region}, {at:?}");
    let there = city.peek(region).unwrap();
    let (middle, role) = (there.world().body(ball).unwrap().centre_of_mass(), there.world().role(ball));
    assert!(middle.z < 1.0 && role == Some(BodyRole::Loose), "{middle}, {role:?}, at {at:?}");
    assert_eq!(city.validate().unwrap(), []);
}

/// An action that ends while something flies has no part in it, wherever that is by then.
#[test]
fn what_flies_while_an_action_ends_falls_on() {
    let building = Arc::new(Building::from_seed(Seed(7)).unwrap());
    let gallery = building.storeys()[2].gallery;
    let scenes =
        WithBall { building: building.clone(), region: gallery, at: Point3::new(-0.5, 0.6, 0.0), boxed: false };
    let mut made = City::of(scenes).agents(1).make().unwrap();
    let (me, ball) = (made.agents().next().unwrap(), made.peek(gallery).unwrap().graph().of_class("ball")[0]);
    made.go(me, building.yard()).unwrap();
    for wait in [20, 28] {
        let mut city = made.clone();
        city.give(me, Action::zero(Verb::Wave)).unwrap();
        let mut endings = city.step(Span(wait));
        throw(&mut city, ball, [0.0, -1.6, 6.0]);
        endings.extend(city.step(Span::from_seconds(30.0)));
        assert!(endings.len() == 1 && endings[0].outcome.is_ok(), "after {wait} ticks: {endings:?}");
        let region = city.region_of(ball).unwrap();
        let there = city.peek(region).unwrap();
        let (middle, role) = (there.world().body(ball).unwrap().centre_of_mass(), there.world().role(ball));
        assert!(region == building.yard() && middle.z < 1.0, "after {wait} ticks: in {region} at {middle}, {role:?}");
        assert_eq!(city.validate().unwrap(), []);
    }
}

/// Portals let things through where they are, not all that is in line with them: front doors, the lift; and what lies on a flight of
/// stairs is a thing of the gallery from which that leads up.
#[test]
fn what_is_thrown_in_line_with_a_portal_is_where_it_lies() {
    let building = Arc::new(Building::from_seed(Seed(7)).unwrap());
    for (storey, at, speed) in [
        (0, [1.7, 0.6], [0.0, -1.5, 6.0]),
        (0, [2.5, 0.6], [0.0, -1.5, 6.0]),
        (0, [2.0, 0.6], [0.0, -1.5, 6.0]),
        (2, [-1.2, 2.3], [0.0, 3.0, 4.5]),
    ] {
        let gallery = building.storeys()[storey].gallery;
        let (mut city, ball) = city(&building, gallery, Point3::new(at[0], at[1], 0.0));
        throw(&mut city, ball, speed);
        let (region, on) = landed(&mut city, ball);
        let lies = city.peek(region).unwrap().world().body(ball).unwrap().centre_of_mass();
        let below = if storey == 0 { building.yard() } else { building.storeys()[storey - 1].gallery };
        let is_there = region == below && !on.is_empty();
        assert!(is_there, "{storey} {at:?} {speed:?}: in {region} at {lies}, on {on:?}");
        assert_eq!(city.validate().unwrap(), [], "{storey} {at:?} {speed:?}");
    }
}

/// A ball that has left a box does not go along when the box is thrown over the railing.
#[test]
fn what_has_spilled_does_not_go_along() {
    let building = Arc::new(Building::from_seed(Seed(7)).unwrap());
    let gallery = building.storeys()[2].gallery;
    let boxed = WithBall { building: building.clone(), region: gallery, at: Point3::new(-0.5, 0.6, 0.0), boxed: true };
    let made = City::of(boxed).agents(0).make().unwrap();
    let [around, ball] = ["box", "ball"].map(|class| made.peek(gallery).unwrap().graph().of_class(class)[0]);
    let mut over = 0;
    for wait in [20, 26, 32] {
        let mut city = made.clone();
        throw(&mut city, ball, [0.0, 0.5, 4.0]);
        city.step(Span(wait));
        throw(&mut city, around, [0.0, -1.8, 6.2]);
        for tick in 0..600 {
            city.step(Span(1));
            assert!(city.region_of(ball).unwrap() != building.yard(), "{tick} ticks after {wait}");
        }
        over += usize::from(landed(&mut city, around).0 == building.yard());
        assert_eq!(city.validate().unwrap(), []);
    }
    assert_eq!(over, 3, "the box has stayed on the gallery");
}

/// What is in a box goes along with it, and what flies far lies on the ground there.
#[test]
fn what_is_in_a_box_goes_along_and_what_flies_far_lies_there() {
    let building = Arc::new(Building::from_seed(Seed(7)).unwrap());
    let gallery = building.storeys()[2].gallery;
    let boxed = WithBall { building: building.clone(), region: gallery, at: Point3::new(2.9, 0.6, 0.0), boxed: true };
    let mut whole = City::of(boxed).agents(0).make().unwrap();
    let things = ["box", "ball"].map(|class| whole.peek(gallery).unwrap().graph().of_class(class)[0]);
    things.iter().for_each(|thing| throw(&mut whole, *thing, [0.2, -1.6, 6.0]));
    for thing in things {
        let (region, at) = landed(&mut whole, thing);
        assert!(region == building.yard() && !at.is_empty(), "{thing} in {region}, {at:?}");
    }
    assert_eq!(whole.validate().unwrap(), []);
    for speed in [-6.0, -9.0] {
        let (mut city, ball) = city(&building, building.yard(), Point3::new(0.0, -7.0, 0.0));
        throw(&mut city, ball, [0.0, speed, 6.0]);
        let (region, at) = landed(&mut city, ball);
        assert!(region == building.yard() && !at.is_empty(), "{region}, {at:?}");
        assert_eq!(city.validate().unwrap(), []);
    }
}

/// A place on a balcony at its open side, and the way out there.
fn parapet(scene: &SceneGraph) -> Option<(Point3<f32>, Vector3<f32>)> {
    let room = |id: &NodeId| scene.node(*id)?.aabb();
    let balcony = scene.of_class("balcony").iter().find_map(room)?;
    let rooms: Vec<_> = scene.rooms().iter().filter_map(room).collect();
    let ways = [Vector3::x(), -Vector3::x(), Vector3::y(), -Vector3::y()];
    let half = (balcony.max - balcony.min) / 2.0;
    let edge = |way: &Vector3<f32>| balcony.centre() + way.component_mul(&half);
    let is_open = |way: &&Vector3<f32>| {
        let ahead = [0.3, 1.0, 2.0, 3.0].map(|far| edge(way) + *way * far);
        !ahead.iter().any(|at| rooms.iter().any(|room| room.contains(at)))
    };
    let way = ways.iter().find(is_open)?;
    let at = edge(way) - 0.35 * way;
    Some((Point3::new(at.x, at.y, balcony.min.z), *way))
}

/// So does what is thrown over the parapet of a balcony, unless it lies on the roof of a larger home below.
#[test]
fn what_is_thrown_off_a_balcony_lands_below() {
    let (mut in_yard, mut over) = (0, 0);
    for seed in 0..3 {
        let building = Arc::new(Building::from_seed(Seed(seed)).unwrap());
        for home in building.storeys().iter().flat_map(|storey| storey.homes) {
            let Some((at, way)) = parapet(&building.scene(home).unwrap()) else { continue };
            let (mut city, ball) = city(&building, home, at);
            let speed: Vector3<f32> = 1.1 * way + Vector3::new(0.0, 0.0, 6.0);
            throw(&mut city, ball, speed.into());
            let (region, at) = landed(&mut city, ball);
            // One that hit something before the parapet has come back.
            over += usize::from(region != home);
            in_yard += usize::from(region == building.yard());
            let is_on_roof = region != home && region != building.yard();
            assert!(is_on_roof || city.validate().unwrap().is_empty(), "{seed} {home}: in {region}, at {at:?}");
        }
    }
    assert!(over > 2 && 2 * in_yard > over, "{in_yard} of {over}");
}

/// Whatever rolls or slides to the head of stairs is a thing of the gallery on whose floor it lies, or of the one from which the stairs
/// lead up.
#[test]
fn what_comes_to_the_head_of_stairs_is_where_it_lies() {
    let building = Arc::new(Building::from_seed(Seed(7)).unwrap());
    let storey = |region: RegionId| building.storeys().iter().position(|storey| storey.gallery == region);
    for (boxed, speed) in [
        (false, 0.6),
        (false, 0.9),
        (false, 1.3),
        (false, 1.9),
        (true, 1.8),
        (true, 2.1),
        (true, 2.25),
        (true, 2.4),
        (true, 2.6),
    ] {
        let gallery = building.storeys()[2].gallery;
        let scenes = WithBall { building: building.clone(), region: gallery, at: Point3::new(-1.3, 2.3, 0.0), boxed };
        let mut city = City::of(scenes).agents(0).make().unwrap();
        let class = if boxed { "box" } else { "ball" };
        let thing = city.peek(gallery).unwrap().graph().of_class(class)[0];
        throw(&mut city, thing, [0.0, speed, 0.0]);
        let (mut before, mut crossings) = (gallery, 0);
        for tick in 0..400 {
            city.step(Span(1));
            let region = city.region_of(thing).unwrap();
            crossings += usize::from(region != before);
            before = region;
            let at = city.environment(region).map(|there| there.world().body(thing).unwrap().centre_of_mass());
            // The floor of the next gallery is 3.2 m above, and a flight of stairs leads up to it.
            let is_here = at.is_none_or(|at| at.z > -0.3 && at.z < 3.2 + 0.4);
            assert!(storey(region).is_some() && is_here, "{class}, {speed}: in {region} at {at:?} after {tick} ticks");
        }
        assert!(crossings < 2, "{class}, {speed}: to and fro {crossings} times");
        let (region, on) = landed(&mut city, thing);
        assert!(!on.is_empty(), "{class}, {speed}: in {region}, on nothing");
        assert_eq!(city.validate().unwrap(), [], "{class}, {speed}");
    }
}

/// A building with some things on the floor of a region.
#[derive(Clone)]
struct WithThings {
    building: Arc<Building>,
    region: RegionId,
    things: Vec<(&'static str, Asset, Point3<f32>)>,
}

impl RegionScenes for WithThings {
    fn space(&self) -> &Arc<Space> {
        self.building.space()
    }

    fn scene(&self, region: RegionId) -> Result<SceneGraph, Box<dyn Error + Send + Sync>> {
        let made = self.building.scene(region)?;
        if region != self.region {
            return Ok(made);
        }
        let floor = made.of_role(ObjectRole::Floor).next().ok_or("no floor")?.id();
        let mut library = AssetLibrary::clone(made.assets());
        let numbers = self.space().region(region).ok_or("no region")?.numbers;
        let ids = self.things.iter().map(|(_, asset, _)| library.add(asset.clone())).collect::<Result<Vec<_>, _>>()?;
        let mut scene = SceneBuilder::from_graph(made);
        scene.assets(Arc::new(library)).numbers(numbers);
        for ((class, _, at), asset) in self.things.iter().zip(ids) {
            let at = Pose::translation(at.x, at.y, at.z);
            scene.add_on(floor, Draft { asset: Some(asset), ..Draft::new(*class) }.at(at))?;
        }
        Ok(scene.build())
    }
}

/// A thing that leans over the edge of a gallery stays there, whatever lies behind it, and nothing goes to and fro between the storeys.
#[test]
fn what_lies_behind_what_leans_over_the_edge_stays() {
    let building = Arc::new(Building::from_seed(Seed(7)).unwrap());
    let gallery = building.storeys()[1].gallery;
    let flat = |half: [f32; 3]| asset(vec![part(Shape::Box { half: half.into() }, [0.0, 0.0, half[2]])]);
    for (rod, plate, wait) in [(2.26, 3.94, 20), (2.72, 4.46, 40), (2.46, 4.13, 100)] {
        let things = vec![
            ("tray", flat([0.6, 0.02, 0.02]), Point3::new(-1.2, 2.5, 0.0)),
            ("plate", flat([0.13, 0.13, 0.01]), Point3::new(-1.2, 2.03, 0.0)),
        ];
        let scenes = WithThings { building: building.clone(), region: gallery, things };
        let mut city = City::of(scenes).agents(0).make().unwrap();
        let [first, second] = ["tray", "plate"].map(|class| city.peek(gallery).unwrap().graph().of_class(class)[0]);
        let mut crossings = 0;
        throw(&mut city, first, [0.0, rod, 0.1]);
        city.step(Span(wait));
        throw(&mut city, second, [0.0, plate, 0.1]);
        let mut before = [first, second].map(|thing| city.region_of(thing));
        for _ in 0..900 {
            city.step(Span(1));
            let now = [first, second].map(|thing| city.region_of(thing));
            crossings += before.iter().zip(&now).filter(|(before, now)| before != now).count();
            before = now;
        }
        assert!(crossings < 10, "{rod}, {plate}: to and fro {crossings} times");
        for thing in [first, second] {
            let (region, on) = landed(&mut city, thing);
            assert!(!on.is_empty(), "{rod}, {plate}: {thing} in {region}, on nothing");
        }
    }
}

/// What lies somewhere is read however somebody or something comes there meanwhile.
#[test]
fn what_lies_in_the_yard_is_read_when_somebody_comes() {
    let building = Arc::new(Building::from_seed(Seed(7)).unwrap());
    let (gallery, yard) = (building.storeys()[0].gallery, building.yard());
    let boxed = WithBall { building: building.clone(), region: gallery, at: Point3::new(-2.2, 0.6, 0.0), boxed: true };
    let mut made = City::of(boxed).agents(1).make().unwrap();
    let me = made.agents().next().unwrap();
    made.go(me, gallery).unwrap();
    let things = ["box", "ball"].map(|class| made.peek(gallery).unwrap().graph().of_class(class)[0]);
    for wait in [0, 40, 80, 120] {
        let mut city = made.clone();
        city.send(me, yard).unwrap();
        city.step(Span(wait));
        throw(&mut city, things[1], [-0.3, -1.9, 6.5]);
        city.step(Span(20));
        throw(&mut city, things[0], [0.2, -1.6, 6.0]);
        city.step(Span::from_seconds(40.0));
        for thing in things {
            let region = city.region_of(thing).unwrap();
            let there = city.peek(region).unwrap();
            let around = |id: NodeId| there.world().aabb(id).unwrap();
            let on: Vec<NodeId> = there.graph().places(thing).map(|place| place.at).collect();
            let is_near = on.iter().all(|at| around(thing).gap(&around(*at)) < 0.05);
            assert!(!on.is_empty() && is_near, "{wait}: {thing} of {region} is on {on:?}");
        }
        assert_eq!(city.validate().unwrap(), []);
    }
}
