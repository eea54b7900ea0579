//! Sights of a city through open portals: pictures, light, observations.

use virtualcity::graph::clock::Span;
use virtualcity::graph::space::RegionId;
use virtualcity::graph::{Action, Digest, Goal, NodeId, SceneBuilder, Seed, Verb};
use virtualcity::nalgebra::{Isometry3, Point3};
use virtualcity::procgen::{Building, BuildingStorey};
use virtualcity::render::{Adaptation, Camera, Frame, Modalities, Modality};
use virtualcity::{City, CityError, Environment, GoalScope, PictureOptions, Viewpoint};

use super::{CABIN, YARD, city, landing, of_class};

const SIZE: (u32, u32) = (96, 72);

fn looking(from: [f32; 3], to: [f32; 3]) -> Camera {
    Camera::with_fov(SIZE.0, SIZE.1, 1.1).looking(Point3::from(from), Point3::from(to))
}

fn labels() -> Modalities {
    Modality::Instance | Modality::Class | Modality::Depth | Modality::Normal
}

fn seen(city: &City, region: RegionId, camera: Camera) -> Frame {
    city.render((region, Viewpoint::Free(camera)), labels(), SIZE.0, SIZE.1).unwrap()
}

/// Whether two pictures have the same bits.
fn is_same(one: &Frame, other: &Frame) -> bool {
    let bits = |depth: &[f32]| depth.iter().map(|v| v.to_bits()).collect::<Vec<u32>>();
    one.rgb == other.rgb
        && one.instance == other.instance
        && one.class == other.class
        && bits(&one.depth) == bits(&other.depth)
        && one.normal == other.normal
}

/// The regions of which a picture shows something.
fn regions(city: &City, frame: &Frame) -> Vec<RegionId> {
    let mut regions: Vec<RegionId> = frame.instance.iter().filter_map(|id| city.region_of(*id)).collect();
    regions.sort_unstable();
    regions.dedup();
    regions
}

#[test]
fn a_single_region_is_drawn_as_its_environment() {
    let mut city = City::make("apartment/42", 1).unwrap();
    let me = city.agents().next().unwrap();
    let fridge = of_class(&city, RegionId(0), "fridge");
    city.set_action(me, Action::walk(fridge)).unwrap();
    let wanted = labels() | Modality::Rgb;
    let home = city.environment_of(me).unwrap();
    for view in [Viewpoint::Agent(me), Viewpoint::Room(home.graph().rooms()[0]), Viewpoint::Overhead] {
        let (own, all) = (home.render(view, wanted, 96, 72), city.render((RegionId(0), view), wanted, 96, 72));
        assert!(is_same(&own.unwrap(), &all.unwrap()), "{view:?}");
    }
    assert!(matches!(city.render(Viewpoint::Overhead, Modality::Depth, 96, 72), Err(CityError::NoRegion)));
}

/// The landing beyond the passage of the yard is seen where it stands, with its own numbers.
#[test]
fn what_is_beyond_a_passage_is_seen_where_it_is() {
    let city = city(1);
    let before: Digest = city.digest();
    let camera = looking([2.0, 2.5, 1.6], [7.0, 1.5, 0.4]);
    let frame = seen(&city, YARD, camera);
    let table = city.peek(landing(0)).unwrap().graph().of_class("table")[0];
    assert!(frame.instance.contains(&table) && city.region_of(table) == Some(landing(0)));
    assert_eq!(regions(&city, &frame)[..2], [YARD, landing(0)]);
    // The surface of the table, in the frame of the yard: 1.5 m into a landing that begins 5 m away, 0.7 m high.
    let (to, z) =
        (camera.project(&Point3::new(6.5, 1.0, 0.7)).unwrap(), camera.pose.inverse() * Point3::new(6.5, 1.0, 0.7));
    let at = to.y as usize * SIZE.0 as usize + to.x as usize;
    assert_eq!(frame.instance[at], table);
    assert!((frame.depth[at] - z.z).abs() < 0.1, "{} instead of {}", frame.depth[at], z.z);
    // Nobody has come there, and nothing has changed.
    assert_eq!((city.digest(), city.active().collect::<Vec<_>>()), (before, vec![YARD]));
    assert!(city.environment(landing(0)).is_none() && city.region_digest(landing(0)).is_none());
}

/// A camera of the world shows the same from whichever region it is asked for.
#[test]
fn regions_agree_on_what_a_camera_sees() {
    let city = city(1);
    let (yard, there) = (city.frame(YARD).unwrap(), city.frame(landing(0)).unwrap());
    let camera = looking([2.0, 2.0, 1.6], [8.0, 2.0, 0.3]);
    let moved: Isometry3<f32> = yard.to(&there) * camera.pose;
    let here = seen(&city, YARD, camera);
    let other = seen(&city, landing(0), Camera { pose: moved, ..camera });
    let is_alike = |i: usize| {
        let depth = |frame: &Frame| frame.depth[i].min(1e3);
        let turned = here.normal[i].iter().zip(&other.normal[i]).any(|(a, b)| (a - b).abs() > 1e-3);
        here.instance[i] == other.instance[i]
            && here.class[i] == other.class[i]
            && (depth(&here) - depth(&other)).abs() < 1e-3 * depth(&here)
            && !turned
    };
    let pixels = here.instance.len();
    let alike = (0..pixels).filter(|i| is_alike(*i)).count();
    // Edges fall on one pixel or the next.
    assert!(alike > pixels * 98 / 100, "{alike} of {pixels} pixels are alike");
    assert_eq!(regions(&city, &here), regions(&city, &other));
}

/// From the passage one sees back into the yard, what is in line with the opening and near enough.
#[test]
fn observations_reach_through_portals() {
    let mut city = city(1);
    let me = city.agents().next().unwrap();
    let there = city.peek(landing(0)).unwrap();
    let [beyond, room] = [there.graph().of_class("table")[0], there.graph().rooms()[0]];
    let seen = city.observation(me, 30.0).unwrap();
    assert!(seen.ids().eq(city.environment_of(me).unwrap().observation(me, 30.0).ids()));
    let first = &seen.beyond()[0];
    assert_eq!((first.region, first.portals.len()), (landing(0), 1));
    assert!(first.seen.sees(room) && !first.seen.sees(beyond), "the table there is beside the opening");
    let table = of_class(&city, YARD, "table");
    let cup = of_class(&city, YARD, "cup");
    city.go(me, landing(0)).unwrap();
    let before = city.digest();
    let seen = city.observation(me, 30.0).unwrap();
    let back = seen.beyond().iter().find(|other| other.region == YARD).unwrap();
    assert!(back.seen.sees(table) && back.seen.sees(cup));
    assert!(seen.references().any(|(region, node)| region == YARD && node.id() == cup));
    assert!(seen.references().any(|(region, node)| region == landing(0) && node.id() == beyond));
    let near = city.observation(me, 2.0).unwrap();
    assert!(near.beyond().iter().all(|other| !other.seen.sees(cup)), "it is farther away");
    let rooms = city.room_observation(me).unwrap();
    assert!(rooms.sees(beyond) && rooms.beyond().iter().any(|other| other.seen.sees(cup)));
    assert_eq!(city.digest(), before);
}

/// A goal is about what is in its scope: the home and what is carried, a place, the world.
#[test]
fn goals_have_a_scope() {
    let mut city = city(1);
    let me = city.agents().next().unwrap();
    assert_eq!(city.home(me), Some(YARD));
    let goal = |text: &str| -> Goal { text.parse().unwrap() };
    let holds = |city: &City, text: &str, scope| city.holds(&goal(text), me, scope).unwrap();
    assert!(holds(&city, "On(cup, table)", GoalScope::Home));
    let cup = super::take_cup(&mut city, me);
    city.go(me, landing(0)).unwrap();
    // It is not at home, and carries the cup.
    assert!(holds(&city, "Holds(cup)", GoalScope::Home) && !holds(&city, "On(cup, table)", GoalScope::Home));
    assert!(!holds(&city, "On(cup, table), 2", GoalScope::Place(landing(0))));
    let table = of_class(&city, landing(0), "table");
    city.set_action(me, Action::walk(table)).unwrap();
    city.set_action(me, Action::place(cup, table)).unwrap();
    city.go(me, YARD).unwrap();
    city.step(Span::from_seconds(5.0));
    let (digest, active) = (city.digest(), city.active().collect::<Vec<RegionId>>());
    assert!(holds(&city, "On(cup, table), 2", GoalScope::Place(landing(0))));
    assert!(holds(&city, "On(cup, table), 2", GoalScope::Place(RegionId(0))), "the house has it, too");
    assert!(
        holds(&city, "On(cup, table), 2", GoalScope::World) && !holds(&city, "On(cup, table), 3", GoalScope::World)
    );
    assert!(holds(&city, &format!("On({}, {})", city.label(cup), city.label(table)), GoalScope::World));
    assert!(!holds(&city, "On(cup, table)", GoalScope::Home));
    assert_eq!(city.score(&goal("On(cup, table), 4"), me, GoalScope::World).unwrap(), 0.5);
    assert_eq!((city.digest(), city.active().collect::<Vec<RegionId>>()), (digest, active));
    let again = super::city(1).restore(&city.save().unwrap()).unwrap();
    assert_eq!(again.home(me), Some(YARD));
}

/// A lift is seen into where its cabin stands with open doors, and there only.
#[test]
fn a_lift_is_seen_into_while_its_doors_are_open() {
    let mut city = city(1);
    let me = city.agents().next().unwrap();
    let into = looking([2.0, 2.5, 1.6], [5.5, 2.5, 1.0]);
    assert!(!regions(&city, &seen(&city, landing(2), into)).contains(&CABIN));
    city.go(me, landing(2)).unwrap();
    assert!(regions(&city, &seen(&city, landing(2), into)).contains(&CABIN));
    let out = looking([1.2, 0.0, 1.6], [-3.0, -1.0, 0.6]);
    let frame = seen(&city, CABIN, out);
    assert!(regions(&city, &frame).contains(&landing(2)), "the landing is behind the open doors");
    city.step(Span::from_seconds(20.0));
    assert!(!regions(&city, &seen(&city, landing(2), into)).contains(&CABIN));
}

fn building() -> (City, Vec<BuildingStorey>) {
    let building = Building::from_seed(Seed(7)).unwrap();
    let storeys = building.storeys().to_vec();
    (City::of(building).make().unwrap(), storeys)
}

/// The front door of the first home, and a camera that looks at it from within.
fn front_door(city: &City, storeys: &[BuildingStorey]) -> (NodeId, Camera) {
    let portal = city.space().portal(storeys[0].front_doors[0]).unwrap();
    let side = portal.side(storeys[0].homes[0]).unwrap().pose;
    let [eye, to] = [[-1.6, 0.3, 1.6], [1.0, 0.0, 1.3]].map(|at| side * Point3::from(at));
    (portal.leaf.unwrap(), Camera::with_fov(SIZE.0, SIZE.1, 1.1).looking(eye, to))
}

/// Mean brightness of the pixels of a picture that show something of a region.
fn brightness(city: &City, frame: &Frame, region: RegionId) -> f32 {
    let own = (0..frame.instance.len()).filter(|i| city.region_of(frame.instance[*i]) == Some(region));
    let (sum, count) = own.fold((0.0, 0), |(sum, count), i| {
        (sum + frame.rgb[i].iter().map(|v| f32::from(*v)).sum::<f32>() / 3.0, count + 1)
    });
    sum / count.max(1) as f32
}

/// Behind an open front door is the gallery, as bright as a day; behind a shut one nothing is drawn.
#[test]
fn an_open_front_door_shows_the_gallery() {
    let (mut city, storeys) = building();
    let me = city.agents().next().unwrap();
    let (home, gallery) = (storeys[0].homes[0], storeys[0].gallery);
    let (door, camera) = front_door(&city, &storeys);
    let view = (home, Viewpoint::Free(camera));
    let wanted = Modality::Rgb | Modality::Instance;
    let shut = city.render(view, wanted, SIZE.0, SIZE.1).unwrap();
    assert_eq!(regions(&city, &shut), [home]);
    city.set_action(me, Action::walk(door)).unwrap();
    city.set_action(me, Action::one(Verb::Open, door)).unwrap();
    let before = (city.digest(), city.active().collect::<Vec<RegionId>>());
    let open = city.render(view, wanted, SIZE.0, SIZE.1).unwrap();
    assert!(regions(&city, &open).contains(&gallery));
    let (inside, outside) = (brightness(&city, &open, home), brightness(&city, &open, gallery));
    assert!(outside > 60.0 && inside > 20.0, "{outside} outside, {inside} inside");
    // From the gallery one sees the shut door of the other home, and what is in the hall of this one.
    let other = city.space().portal(storeys[0].front_doors[1]).unwrap();
    let side = other.side(gallery).unwrap().pose;
    let [eye, to] = [[-2.0, 0.0, 1.6], [0.5, 0.0, 1.0]].map(|at| side * Point3::from(at));
    let camera = Camera::with_fov(SIZE.0, SIZE.1, 1.1).looking(eye, to);
    let frame = city.render((gallery, Viewpoint::Free(camera)), Modality::Instance, SIZE.0, SIZE.1).unwrap();
    assert!(frame.instance.contains(&other.leaf.unwrap()));
    assert_eq!((city.digest(), city.active().collect::<Vec<RegionId>>()), before);
    // A copy that has drawn nothing draws the same, in another order, and after somebody has moved as well.
    let copy = |city: &City| building().0.restore(&city.save().unwrap()).unwrap();
    let again = copy(&city);
    let _ = again.render((gallery, Viewpoint::Free(camera)), Modality::Instance, SIZE.0, SIZE.1).unwrap();
    assert!(is_same(&again.render(view, wanted, SIZE.0, SIZE.1).unwrap(), &open));
    let sofa = of_class(&city, home, "sofa");
    city.set_action(me, Action::walk(sofa)).unwrap();
    let later = city.render(view, wanted, SIZE.0, SIZE.1).unwrap();
    assert!(is_same(&copy(&city).render(view, wanted, SIZE.0, SIZE.1).unwrap(), &later));
}

/// By one exposure: daylight falls through an open front door onto the floor of the hall.
#[test]
fn light_falls_through_an_open_front_door() {
    let dim_and_bright = |seed: u64| {
        let building = Building::from_seed(Seed(seed)).unwrap();
        let storey = building.storeys()[0].clone();
        let adapts = Some(Adaptation { from: [1.0; 3], share: 0.0 });
        let settings = Environment::builder_from_scene(SceneBuilder::new("").build());
        let settings = settings.pictures(PictureOptions { adapts, ..PictureOptions::default() });
        let mut city = City::of(building).settings(settings).make().unwrap();
        let me = city.agents().next().unwrap();
        let portal = city.space().portal(storey.front_doors[0]).unwrap();
        let (door, side) = (portal.leaf.unwrap(), portal.side(storey.homes[0]).unwrap().pose);
        // Nobody stands in the picture.
        let [eye, to] = [[-2.0, 0.0, 1.5], [-0.9, 0.0, 0.0]].map(|at| side * Point3::from(at));
        let floor = (storey.homes[0], Viewpoint::Free(Camera::with_fov(32, 32, 0.4).looking(eye, to)));
        let wanted = Modality::Rgb | Modality::Instance;
        let shut = city.render(floor, wanted, 32, 32).unwrap();
        city.set_action(me, Action::walk(door)).unwrap();
        city.set_action(me, Action::one(Verb::Open, door)).unwrap();
        let sofa = of_class(&city, storey.homes[0], "sofa");
        city.set_action(me, Action::walk(sofa)).unwrap();
        let open = city.render(floor, wanted, 32, 32).unwrap();
        let same = |i: &usize| open.instance[*i] == shut.instance[*i];
        let mean = |frame: &Frame| {
            let all: Vec<f32> = (0..frame.instance.len()).filter(same).map(|i| f32::from(frame.rgb[i][1])).collect();
            assert!(all.len() > 500);
            all.iter().sum::<f32>() / all.len() as f32
        };
        (mean(&shut), mean(&open))
    };
    for seed in [3, 7] {
        let (dim, bright) = dim_and_bright(seed);
        assert!(bright > 1.2 * dim, "building {seed}: {bright} with the door open, {dim} shut");
    }
}
