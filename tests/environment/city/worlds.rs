//! Worlds of several regions against single homes: where a region is, who has looked in and how often makes no
//! difference, and nothing is lost on the way.

use std::collections::BTreeMap;
use std::error::Error;
use std::sync::Arc;

use virtualcity::graph::asset::{Part, Shape};
use virtualcity::graph::clock::Span;
use virtualcity::graph::space::{Region, RegionFrame, RegionId, RegionKind, Space};
use virtualcity::graph::{
    Aabb, Action, Asset, Bounds, Draft, NodeId, ObjectRole, Pose, Relation, SceneBuilder, SceneGraph, Seed, State, Verb,
};
use virtualcity::nalgebra::{Point3, Vector3};
use virtualcity::procgen::{Apartment, Building, BuildingSpecification};
use virtualcity::{City, RegionScenes, legal_action};

use super::{House, YARD, house, house_of, landing, move_cup, of_class};

/// A home alone, somewhere in the world.
struct Alone(Arc<Space>);

impl RegionScenes for Alone {
    fn space(&self) -> &Arc<Space> {
        &self.0
    }

    fn scene(&self, _: RegionId) -> Result<SceneGraph, Box<dyn Error + Send + Sync>> {
        Ok(Apartment::from_seed(Seed(42))?.scene())
    }
}

fn home_at(frame: RegionFrame) -> City {
    let home = Region::new(RegionKind::Unit, "apartment/42").at(frame);
    City::of(Alone(Arc::new(Space::single(home).unwrap()))).make().unwrap()
}

/// Whether everything is tried, which takes minutes.
fn whole() -> bool {
    std::env::var_os("VC_WHOLE").is_some()
}

/// A home far from the origin and turned is, in its own frame, the same to the bit; in the world it is where it was put.
#[test]
fn a_home_elsewhere_in_the_world_is_the_same_but_for_its_frame() {
    let frame = RegionFrame::new([4000.0, -3000.0, 60.0], 37.0_f64.to_radians());
    let (mut here, mut there) = (home_at(RegionFrame::WORLD), home_at(frame));
    let me = here.agents().next().unwrap();
    let home = here.region_of(me).unwrap();
    let mut stream = Seed(42).child("a home elsewhere").stream();
    let (mut done, all) = (0, if whole() { 1000 } else { 100 });
    for _ in 0..all {
        let action = legal_action(here.environment(home).unwrap().graph(), me, &mut stream);
        let (one, other) = (here.set_action(me, action), there.set_action(me, action));
        assert_eq!(one.as_ref().ok(), other.as_ref().ok(), "{action}");
        done += usize::from(one.is_ok());
        let (one, other) = (here.environment(home).unwrap(), there.environment(home).unwrap());
        assert!(one.graph() == other.graph() && one.digest() == other.digest(), "{action}");
    }
    assert!(done > all / 2, "{done}");
    assert_ne!(here.digest(), there.digest(), "they are elsewhere");
    let feet = there.environment(home).unwrap().world().pose(me).unwrap();
    let at = there.frame(home).unwrap().pose(&feet).translation;
    let turned = RegionFrame::new([0.0; 3], 37.0_f64.to_radians()).pose(&feet).translation;
    let off = [at.x - turned.x - 4000.0, at.y - turned.y + 3000.0, at.z - turned.z - 60.0];
    assert!(off.iter().all(|metres| metres.abs() < 1e-6), "{off:?}");
}

/// All orders of some things.
fn orders(all: &[RegionId]) -> Vec<Vec<RegionId>> {
    if all.is_empty() {
        return vec![Vec::new()];
    }
    let first = |at: usize| {
        let rest: Vec<RegionId> = [&all[..at], &all[at + 1..]].concat();
        orders(&rest).into_iter().map(move |order| [vec![all[at]], order].concat()).collect::<Vec<_>>()
    };
    (0..all.len()).flat_map(first).collect()
}

/// Four homes that somebody looks into, in every order, are as nobody had been there.
#[test]
fn homes_that_were_looked_into_are_as_they_were() {
    let wishes = BuildingSpecification { storeys: 2, ..Default::default() };
    let building = Building::generate(&wishes, Seed(5)).unwrap();
    let homes: Vec<RegionId> = building.storeys().iter().flat_map(|storey| storey.homes).collect();
    let yard = building.yard();
    let mut start = City::of(building).make().unwrap();
    let me = start.agents().next().unwrap();
    start.go(me, yard).unwrap();
    let orders = orders(&homes);
    assert_eq!(orders.len(), 24);
    for order in orders.into_iter().step_by(if whole() { 1 } else { 9 }) {
        let mut city = start.clone();
        for home in &order {
            city.go(me, *home).unwrap();
            assert!(city.environment(*home).is_some());
        }
        city.go(me, yard).unwrap();
        city.step(Span::from_seconds(30.0));
        assert_eq!(city.active().collect::<Vec<_>>(), [yard], "{order:?}");
        let left: Vec<_> = homes.iter().filter_map(|home| city.region_digest(*home)).collect();
        assert_eq!(left, [], "{order:?}");
    }
}

/// A building with a ball at a wall of the room behind each front door.
struct WithBalls(Building);

impl RegionScenes for WithBalls {
    fn space(&self) -> &Arc<Space> {
        self.0.space()
    }

    fn scene(&self, region: RegionId) -> Result<SceneGraph, Box<dyn Error + Send + Sync>> {
        let scene = RegionScenes::scene(&self.0, region)?;
        let plan = self.space().region(region).ok_or("no region")?;
        let mut doors = self.space().portals_of(region).filter_map(|portal| self.space().portal(portal));
        let side = doors.find_map(|plan| plan.side(region)).filter(|_| plan.kind == RegionKind::Unit);
        let Some(room) = side.and_then(|side| side.room) else { return Ok(scene) };
        let mut library = (**scene.assets()).clone();
        let shape = Shape::Sphere { radius: 0.08 };
        let part = Part { name: "ball".into(), shape, material: 0, pose: Pose::identity(), joint: None };
        let ball = library.add(Asset { name: "ball".into(), parts: vec![part], ..Asset::default() })?;
        let at = beside_a_wall(&scene, room).ok_or("no place for a ball")?;
        let mut scene = SceneBuilder::from_graph(scene);
        scene.assets(Arc::new(library)).add_in(room, Draft { asset: Some(ball), ..Draft::new("ball") }.at(at))?;
        Ok(scene.build())
    }
}

/// A place for a ball on the floor of a room, at a wall and away from doors and furniture.
fn beside_a_wall(scene: &SceneGraph, room: NodeId) -> Option<Pose> {
    let around = scene.node(room)?.aabb()?;
    let stands = |role| !matches!(role, ObjectRole::Room | ObjectRole::Floor | ObjectRole::Wall | ObjectRole::Ceiling);
    let boxes: Vec<(ObjectRole, Aabb)> =
        scene.nodes().filter(|node| stands(node.role())).filter_map(|node| Some((node.role(), node.aabb()?))).collect();
    let is_free = |at: &Point3<f32>| {
        boxes.iter().all(|(role, own)| own.distance(at) > if *role == ObjectRole::Door { 1.0 } else { 0.12 })
    };
    let along = |low: f32, high: f32| (0..20).map(move |k| low + 0.12 + (high - low - 0.24) * k as f32 / 19.0);
    let (low, high) = (around.min, around.max);
    let sides = along(low.x, high.x).flat_map(|x| [[x, low.y + 0.12], [x, high.y - 0.12]]);
    let ends = along(low.y, high.y).flat_map(|y| [[low.x + 0.12, y], [high.x - 0.12, y]]);
    let spot = sides.chain(ends).map(|[x, y]| Point3::new(x, y, 0.08)).find(is_free)?;
    Some(Pose::translation(spot.x, spot.y, spot.z))
}

/// Opens a door between rooms of an agent's home as far as it gets in some ticks, and switches a kettle on; how much of both
/// was done.
fn leave_things_going(city: &mut City, agent: NodeId) -> [bool; 2] {
    let home = city.region_of(agent).unwrap();
    let of = |city: &City, class: &str| city.environment(home).unwrap().graph().of_class(class).to_vec();
    let is = |city: &City, id: NodeId, state| city.environment(home).unwrap().graph().node(id).unwrap().is(state);
    let boils = of(city, "kettle").into_iter().any(|kettle| {
        let _ = city.set_action(agent, Action::walk(kettle));
        city.set_action(agent, Action::one(Verb::SwitchOn, kettle)).is_ok()
    });
    let shut: Vec<NodeId> = of(city, "door").into_iter().filter(|door| is(city, *door, State::Closed)).collect();
    let yard = city.space().regions().find(|(_, region)| &*region.name == "yard").unwrap().0;
    let ajar = shut.into_iter().any(|door| {
        let before = city.clone();
        if city.set_action(agent, Action::walk(door)).is_err()
            || city.give(agent, Action::one(Verb::Open, door)).is_err()
        {
            return false;
        }
        let open = |city: &City| city.environment(home).unwrap().world().parts(door).openness().unwrap();
        (0..300).any(|_| {
            city.step(Span(1));
            let now = city.environment(home).unwrap().moment();
            now.world().parts(door).openness().unwrap() > 0.5
        });
        city.interrupt(agent);
        city.step(Span(1));
        // Whoever has shut itself in behind a door leaves it as it was.
        let is_ajar = (0.1..0.9).contains(&open(city)) && city.clone().go(agent, yard).is_ok();
        if !is_ajar {
            *city = before;
        }
        is_ajar
    });
    [boils, ajar]
}

/// Four homes in each of which a ball rolls, a door is half open and a kettle is on, where possible: in whatever order
/// somebody looks into them, they come to the same; and if four do at the same time, so does the city, in whatever order
/// they are told to.
#[test]
fn homes_in_which_something_goes_on_are_the_same_whoever_looks_in_first() {
    let wishes = BuildingSpecification { storeys: 2, ..Default::default() };
    let building = Building::generate(&wishes, Seed(5)).unwrap();
    let homes: Vec<RegionId> = building.storeys().iter().flat_map(|storey| storey.homes).collect();
    let yard = building.yard();
    let mut start = City::of(WithBalls(building)).agents(4).make().unwrap();
    let agents: Vec<NodeId> = start.agents().collect();
    let balls: Vec<NodeId> = homes.iter().map(|home| of_class(&start, *home, "ball")).collect();
    let going: Vec<[bool; 2]> = agents.iter().map(|agent| leave_things_going(&mut start, *agent)).collect();
    assert!((0..2).all(|what| going.iter().any(|done| done[what])), "{going:?}");
    agents.iter().for_each(|agent| start.send(*agent, yard).unwrap());
    start.step_until_idle(Span::from_seconds(600.0));
    let push = |city: &mut City, at: usize| {
        let there = city.peek(homes[at]).unwrap();
        let body = there.world().body(balls[at]).unwrap();
        let (middle, mass) = (body.centre_of_mass(), body.mass());
        city.push(balls[at], Vector3::new(0.5, 0.3, 0.0) * mass, middle).unwrap();
    };
    let left = |city: &City| homes.iter().map(|home| city.region_digest(*home)).collect::<Vec<_>>();
    let (mut one_by_one, mut together) = (Vec::new(), Vec::new());
    let end = start.tick() + Span::from_seconds(900.0);
    for order in orders(&homes).into_iter().step_by(if whole() { 1 } else { 13 }) {
        let at = |home: &RegionId| homes.iter().position(|other| other == home).unwrap();
        let mut city = start.clone();
        order.iter().for_each(|home| push(&mut city, at(home)));
        for home in &order {
            city.go(agents[0], *home).unwrap();
        }
        city.go(agents[0], yard).unwrap();
        assert!(city.tick() < end);
        city.step(Span(end.0 - city.tick().0));
        assert_eq!(city.active().collect::<Vec<_>>(), [yard], "{order:?}");
        one_by_one.push(left(&city));

        let mut city = start.clone();
        for home in &order {
            push(&mut city, at(home));
            city.send(agents[at(home)], *home).unwrap();
        }
        city.step_until_idle(Span::from_seconds(600.0));
        assert!(agents.iter().zip(&homes).all(|(agent, home)| city.region_of(*agent) == Some(*home)));
        order.iter().for_each(|home| city.send(agents[at(home)], yard).unwrap());
        city.step(Span(end.0 - city.tick().0));
        assert_eq!(city.active().collect::<Vec<_>>(), [yard], "{order:?}");
        together.push((city.digest(), left(&city)));
    }
    assert!(one_by_one[0].iter().all(Option::is_some));
    assert!(one_by_one.iter().all(|digests| digests == &one_by_one[0]), "{one_by_one:?}");
    assert!(together.iter().all(|digests| digests == &together[0]), "{together:?}");
}

/// Leaving and coming back moves nothing.
#[test]
fn a_hundred_leavings_move_no_pose() {
    let mut city = City::of(house()).make().unwrap();
    let me = city.agents().next().unwrap();
    let cup = move_cup(&mut city, me);
    let poses = |city: &City| -> BTreeMap<NodeId, [u32; 7]> {
        let there = city.environment(landing(0)).unwrap();
        let things = there.graph().nodes().map(|node| node.id()).filter(|id| *id != me);
        let bits = |pose: Pose| {
            let turn = pose.rotation.coords;
            let at = pose.translation.vector;
            [at.x, at.y, at.z, turn.x, turn.y, turn.z, turn.w].map(f32::to_bits)
        };
        things.filter_map(|id| Some((id, bits(there.world().pose(id)?)))).collect()
    };
    let before = poses(&city);
    assert!(before.contains_key(&cup) && before.len() > 2);
    for leaving in 0..100 {
        city.go(me, YARD).unwrap();
        city.step(Span::from_seconds(3.0));
        assert!(city.environment(landing(0)).is_none());
        city.go(me, landing(0)).unwrap();
        assert_eq!(poses(&city), before, "{leaving}");
    }
}

/// The house with a tray of three cups on the table of its yard.
struct WithTray(House);

impl RegionScenes for WithTray {
    fn space(&self) -> &Arc<Space> {
        self.0.space()
    }

    fn scene(&self, region: RegionId) -> Result<SceneGraph, Box<dyn Error + Send + Sync>> {
        let scene = self.0.scene(region)?;
        if region != YARD {
            return Ok(scene);
        }
        let table = scene.of_class("table")[0];
        let mut scene = SceneBuilder::from_graph(scene);
        let standing = |size: [f32; 3]| Bounds::standing(size.into());
        let tray = Draft::new("tray").bounds(standing([0.3, 0.4, 0.03]));
        let tray = scene.add_on(table, tray.at(Pose::translation(1.5, 0.9, 0.7)))?;
        for at in [0.78, 0.9, 1.02] {
            let cup = Draft::new("cup").bounds(standing([0.07, 0.07, 0.09]));
            scene.add_on(tray, cup.at(Pose::translation(1.5, at, 0.73)))?;
        }
        Ok(scene.build())
    }
}

/// Rides between eight storeys with a full tray: nothing falls, nothing is lost, and it arrives where it was sent.
#[test]
fn a_full_tray_rides_between_eight_storeys() {
    let rides = if whole() { 1000 } else { 10 };
    let mut city = City::of(WithTray(house_of(8))).make().unwrap();
    let me = city.agents().next().unwrap();
    let tray = of_class(&city, YARD, "tray");
    let cups: Vec<NodeId> = city.environment(YARD).unwrap().graph().relating(Relation::On, tray).collect();
    assert_eq!(cups.len(), 3);
    city.set_action(me, Action::walk(tray)).unwrap();
    city.set_action(me, Action::grab(tray)).unwrap();
    city.go(me, landing(0)).unwrap();
    city.set_ways(me, |plan| plan.stairs.is_empty());
    let (mut stream, mut storey) = (Seed(8).child("rides").stream(), 0);
    for ride in 0..rides {
        storey = (storey + 1 + stream.below(7) as u32) % 8;
        city.go(me, landing(storey)).unwrap();
        let there = city.environment(landing(storey)).unwrap();
        assert!(there.graph().held(me).eq([tray]), "{ride}");
        let mut on_it: Vec<NodeId> = there.graph().relating(Relation::On, tray).collect();
        on_it.sort_unstable();
        assert_eq!(on_it, cups, "{ride}");
        let at = |id: NodeId| there.world().pose(id).unwrap().translation.vector;
        for cup in &cups {
            let off = at(*cup) - at(tray);
            assert!(off.xy().norm() < 0.2 && (0.0..0.1).contains(&off.z), "{ride}: {off}");
        }
        assert_eq!(there.graph().validate(), [], "{ride}");
    }
}
