//! Things that are thrown over the parapets of galleries and balconies of buildings.

use std::error::Error;
use std::sync::Arc;

use virtualcity::graph::asset::Shape;
use virtualcity::graph::clock::Span;
use virtualcity::graph::space::{RegionId, Space};
use virtualcity::graph::{AssetLibrary, Draft, NodeId, ObjectRole, Pose, SceneBuilder, SceneGraph, Seed};
use virtualcity::nalgebra::{Point3, Vector3};
use virtualcity::procgen::Building;
use virtualcity::{City, RegionScenes};

use super::things::{asset, part};

const RADIUS: f32 = 0.06;

/// A building with a ball on the floor of a region.
#[derive(Clone)]
struct WithBall {
    building: Arc<Building>,
    region: RegionId,
    at: Point3<f32>,
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
        scene.assets(Arc::new(library)).numbers(numbers);
        let at = Pose::translation(self.at.x, self.at.y, self.at.z + RADIUS);
        scene.add_on(floor, Draft { asset: Some(ball), ..Draft::new("ball") }.at(at))?;
        Ok(scene.build())
    }
}

/// A city with a ball at a place of a region, which lies still.
fn city(building: &Arc<Building>, region: RegionId, at: Point3<f32>) -> (City, NodeId) {
    let scenes = WithBall { building: building.clone(), region, at };
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
