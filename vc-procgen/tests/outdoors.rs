//! Streets of generated cities as scenes.

#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use std::collections::BTreeSet;

use nalgebra::Vector3;
use vc_graph::asset::Shape;
use vc_graph::{NodeId, SceneGraph, Seed, State};
use vc_map::Point;
use vc_procgen::city::{BuildingType, CityBuilding, CityPlan, CitySpecification, ParkFeature};
use vc_procgen::plan::{CELLS, OpeningKind};
use vc_procgen::{Outdoors, OutdoorsError};
use vc_shapes::object::generator;

fn small(seed: u64) -> CityPlan {
    CityPlan::generate(&CitySpecification { area: 0.2, ..CitySpecification::default() }, Seed(seed)).unwrap()
}

/// The middle of a street.
fn middle(city: &CityPlan, street: usize) -> Point {
    let street = &city.streets()[street % city.streets().len()];
    let road = city.map().road(street.roads[street.roads.len() / 2]).unwrap();
    road.line.at(road.line.length() / 2.0)
}

/// The places of the nodes of some classes on the map, in millimetres.
fn places(scene: &SceneGraph, at: &Point, classes: &[&str]) -> BTreeSet<[i64; 2]> {
    let nodes = classes.iter().flat_map(|class| scene.of_class(class));
    let place = |id: NodeId| {
        let around = scene.node(id).unwrap().aabb().unwrap().centre();
        [f64::from(around.x) + at.x, f64::from(around.y) + at.y].map(|metres| (metres * 100.0).round() as i64)
    };
    nodes.map(place).collect()
}

/// Every class that a plan puts outdoors can be made: nothing is left out in silence.
#[test]
fn everything_of_a_plan_is_there() {
    for seed in 1..4 {
        let city = small(seed);
        for class in city.items().iter().map(|item| item.class).chain(city.cars().iter().map(|car| car.class)) {
            assert!(class == "bench" || generator(class).is_some(), "{class}");
        }
        let at = middle(&city, 5);
        let scene = Outdoors::of(&city).scene(&at, 150.0).unwrap();
        assert_eq!(scene.validate(), []);
        let near = |place: &Point| (place - at).norm() <= 150.0;
        let count = |classes: &[&str]| classes.iter().map(|class| scene.of_class(class).len()).sum::<usize>();
        let cars = city.cars().iter().filter(|car| near(&car.at)).count();
        let kinds: BTreeSet<&str> = city.cars().iter().map(|car| car.class).collect();
        assert_eq!(count(&kinds.into_iter().collect::<Vec<_>>()), cars, "{seed}");
        let tall = city.items().iter().filter(|item| near(&item.at) && item.class == "street_lamp").count();
        assert!(count(&["street_lamp"]) >= tall, "{seed}: parks have more");
        let trees = city.trees().iter().chain(city.parks().iter().flat_map(|park| &park.trees));
        let trees = trees.chain(city.items().iter().filter(|item| item.class == "tree").map(|item| &item.at));
        // Oaks and all others are kinds of trees.
        assert_eq!(scene.of_class("tree").len(), trees.filter(|at| near(at)).count(), "{seed}");
        let wings = city.buildings().iter().filter(|house| {
            house.wings.iter().flat_map(|wing| wing.plan.corners()).any(|corner| (corner - at).norm() < 140.0)
        });
        assert!(count(&["building"]) >= wings.map(|house| house.wings.len()).sum(), "{seed}");
    }
}

/// It is the same whoever looks first, and from wherever.
#[test]
fn the_same_things_stand_there_from_wherever_one_looks() {
    let city = small(7);
    let outdoors = Outdoors::of(&city);
    let at = middle(&city, 2);
    let other = Point::new(at.x + 31.7, at.y - 18.2);
    let first = outdoors.scene(&at, 60.0).unwrap();
    let from_there = outdoors.scene(&other, 110.0).unwrap();
    let again = Outdoors::of(&small(7)).scene(&at, 60.0).unwrap();
    assert_eq!(first.digest(), again.digest());
    let classes = ["hatchback", "sedan", "suv", "street_lamp", "tree", "oak_tree", "birch_tree", "street_bin"];
    let (near, all) = (places(&first, &at, &classes), places(&from_there, &other, &classes));
    let is_there = |place: &&[i64; 2]| {
        let around = |by: [i64; 2]| [place[0] + by[0], place[1] + by[1]];
        [-1, 0, 1].iter().any(|x| [-1, 0, 1].iter().any(|y| all.contains(&around([*x, *y]))))
    };
    assert_eq!(near.iter().filter(is_there).count(), near.len());
    assert!(near.len() > 20);
}

/// The glass of a building as one sees it from near is that of the windows of its flats: as many panes, at the same places.
#[test]
fn windows_are_those_of_the_flats_behind() {
    let city = small(7);
    let flats = |number: usize, storey: usize| {
        let units = city.buildings()[number].units(storey);
        units.iter().filter_map(|unit| city.flat(number, unit)).collect::<Vec<_>>()
    };
    let number = (0..city.buildings().len())
        .find(|number| city.buildings()[*number].wings.len() == 1 && flats(*number, 1).len() > 2)
        .unwrap();
    let house = &city.buildings()[number];
    let door = house.doors()[0];
    let at = door.at + door.out * 8.0;
    let scene = Outdoors::of(&city).scene(&at, 12.0).unwrap();
    let glass = vc_shapes::material::BLACK_GLASS.name();
    // All corners of glass on the map, with their heights.
    let mut corners: Vec<[f64; 3]> = Vec::new();
    for id in scene.of_class("building") {
        let node = scene.node(id).unwrap();
        let (asset, pose) = (scene.assets().get(node.spec().asset.unwrap()).unwrap(), node.pose().unwrap());
        for part in
            asset.parts.iter().filter(|part| scene.assets().material(part.material).unwrap().name.as_ref() == glass)
        {
            let points: Vec<nalgebra::Point3<f32>> = match &part.shape {
                Shape::Hull { points } => points.to_vec(),
                Shape::Mesh { vertices, .. } => vertices.to_vec(),
                _ => Vec::new(),
            };
            corners.extend(points.iter().map(|point| {
                let point = pose * part.pose * point;
                [f64::from(point.x) + at.x, f64::from(point.y) + at.y, f64::from(point.z)]
            }));
        }
    }
    let mut windows = 0;
    for flat in flats(number, 1) {
        for window in flat.plan.openings.iter().filter(|opening| opening.kind == OpeningKind::Window) {
            let place = |along: i32| {
                let line = f64::from(window.at) / f64::from(CELLS);
                let along = f64::from(along) / f64::from(CELLS);
                if window.vertical { flat.place(line, along) } else { flat.place(along, line) }
            };
            for end in [window.from, window.to] {
                let at = place(end);
                let is_near = |corner: &&[f64; 3]| {
                    let sill = flat.floor + f64::from(window.sill);
                    (corner[2] - sill).abs() < 0.02 && (at - Point::new(corner[0], corner[1])).norm() < 0.45
                };
                assert!(corners.iter().any(|corner| is_near(&corner)), "no glass at {at}");
            }
            windows += 1;
        }
    }
    assert!(windows > 4, "{windows}");
}

/// Lamps are off at first, and on where that is asked for.
#[test]
fn lamps_are_switched() {
    let city = small(3);
    let at = middle(&city, 1);
    for on in [false, true] {
        let scene = Outdoors::of(&city).lamps(on).scene(&at, 60.0).unwrap();
        assert_eq!(scene.validate(), []);
        let lamps: Vec<bool> =
            scene.of_class("street_lamp").iter().map(|id| scene.node(*id).unwrap().is(State::On)).collect();
        assert!(lamps.len() > 2 && lamps.iter().all(|is_on| *is_on == on));
    }
}

/// Cars stand on the carriageway, all else on the pavement or the land.
#[test]
fn everything_stands_on_its_ground() {
    let city = small(5);
    let at = middle(&city, 4);
    let scene = Outdoors::of(&city).scene(&at, 90.0).unwrap();
    for node in scene.nodes() {
        let (Some(around), class) = (node.aabb(), node.class().as_ref()) else { continue };
        let foot = around.min.z;
        match class {
            "hatchback" | "sedan" | "suv" | "station_wagon" | "minivan" | "van" | "electric_car" => {
                assert!((foot + 0.12).abs() < 0.02, "{class}: {foot}");
            }
            "street_lamp" | "tree" | "oak_tree" | "street_bin" | "hydrant" | "park_bench" => {
                assert!(foot.abs() < 0.02, "{class}: {foot}");
            }
            _ => {}
        }
    }
    let bounds = scene
        .nodes()
        .filter_map(|node| node.aabb())
        .fold(Vector3::zeros(), |most: Vector3<f32>, around| most.sup(&around.max.coords));
    assert!(bounds.z < 120.0);
}

/// Parks have benches along their paths and things to play with; gardens have hedges or fences, and the way to each door is free.
#[test]
fn parks_and_gardens_are_furnished() {
    let city = small(7);
    let outdoors = Outdoors::of(&city);
    let park = city.parks().iter().find(|park| park.features.iter().any(|(kind, _)| *kind == ParkFeature::Playground));
    let scene = outdoors.scene(&park.unwrap().middle, 90.0).unwrap();
    assert!(["swing_set", "slide", "sandbox", "park_bench"].iter().all(|class| !scene.of_class(class).is_empty()));
    let (mut fronts, mut doors) = (0, 0);
    let has_garden = |house: &&CityBuilding| matches!(house.kind, BuildingType::Detached | BuildingType::Row);
    for house in city.buildings().iter().filter(has_garden).take(12) {
        let door = house.doors()[0];
        let scene = outdoors.scene(&door.at, 20.0).unwrap();
        let out = Vector3::new(door.out.x as f32, door.out.y as f32, 0.0);
        for id in ["hedge", "fence"].iter().flat_map(|class| scene.of_class(class)) {
            let around = scene.node(id).unwrap().aabb().unwrap();
            let is_clear = (0..40).all(|step| around.distance(&(out * 0.2 * step as f32).into()) > 0.3);
            assert!(is_clear, "{}", scene.label(id));
            fronts += 1;
        }
        doors += 1;
    }
    assert!(doors > 3 && fronts > 3, "{fronts} of {doors}");
}

#[test]
fn what_is_no_place_is_refused() {
    let city = small(1);
    let outdoors = Outdoors::of(&city);
    for reach in [0.0, -1.0, f64::NAN, f64::INFINITY, 2_001.0] {
        assert!(matches!(outdoors.scene(&Point::origin(), reach), Err(OutdoorsError::Reach(_))), "{reach}");
    }
    for x in [f64::NAN, f64::INFINITY, 1e9] {
        let refused = outdoors.scene(&Point::new(x, 0.0), 50.0);
        assert!(matches!(refused, Err(OutdoorsError::Place(..))), "{x}");
    }
    // Beyond the city there is country.
    let country = outdoors.scene(&Point::new(50_000.0, 0.0), 50.0).unwrap();
    assert!(country.of_class("building").is_empty() && !country.of_class("lawn").is_empty());
}
