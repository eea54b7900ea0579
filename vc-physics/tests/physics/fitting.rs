//! Getting things into containers: on their side, on what is there already, folded up small.

#![allow(clippy::unwrap_used, reason = "tests stop where something is wrong")]

use crate::common;

use common::{Scene, at, block, part, plain, surface};
use nalgebra::{Point3, Vector3};
use vc_graph::asset::{Hold, Shape};
use vc_graph::{Asset, NodeId, SceneGraph};
use vc_physics::{Hand, Packing, PhysicsWorld, ShapeCache, SpotFault, SpotOrder, SpotSearch, SpotWish};

/// A box without a lid, 0.5 m by 0.4 m by 0.3 m inside.
fn chest(scene: &mut Scene) -> NodeId {
    let w = scene.wood;
    let board = |half: [f32; 3], x: f32, y: f32, z: f32| part("board", block(half), at(x, y, z), w);
    let parts = vec![
        board([0.26, 0.21, 0.01], 0.0, 0.0, 0.01),
        board([0.01, 0.21, 0.15], 0.26, 0.0, 0.17),
        board([0.01, 0.21, 0.15], -0.26, 0.0, 0.17),
        board([0.25, 0.01, 0.15], 0.0, 0.21, 0.17),
        board([0.25, 0.01, 0.15], 0.0, -0.21, 0.17),
    ];
    let surfaces = vec![surface("inside", Hold::Inside, [0.0, 0.0, 0.02], (0.25, 0.2), Some(0.3))];
    let asset = scene.asset(Asset { name: "chest".into(), parts, surfaces, ..Asset::default() });
    scene.add("toy_box", asset, at(0.0, 0.0, 0.0))
}

fn within(world: &PhysicsWorld, id: NodeId, chest: NodeId) -> bool {
    let (thing, chest) = (world.aabb(id).unwrap(), world.aabb(chest).unwrap());
    let inside = |i: usize| thing.min[i] > chest.min[i] && thing.max[i] < chest.max[i];
    (0..3).all(inside)
}

#[test]
fn what_is_too_tall_is_laid_down() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let chest = chest(&mut scene);
    let tall = scene.solid("tall", block([0.05, 0.08, 0.22]), scene.wood);
    let tall = scene.add("toy", tall, at(1.0, 0.0, 0.22));
    let long = scene.solid("long", block([0.3, 0.3, 0.3]), scene.wood);
    let long = scene.add("toy", long, at(-1.0, 0.0, 0.3));
    let mut world = scene.world();
    let spot = SpotSearch::new(tall, chest, true).find(&world).unwrap().unwrap();
    assert!(world.overlaps(tall, &spot).unwrap().is_empty());
    world.place(tall, spot).unwrap();
    let report = world.settle(300);
    assert!(report.at_rest && within(&world, tall, chest), "{report:?}");
    assert_eq!(SpotSearch::new(long, chest, true).find(&world).unwrap(), None);
    // On top of things nothing is laid down: it stands there or not at all.
    let mut scene = Scene::default();
    let table = scene.table(at(0.0, 0.0, 0.0));
    let cube = scene.cube(0.05, at(2.0, 0.0, 1.0));
    let world = scene.world();
    let spot = SpotSearch::new(cube, table, false).find(&world).unwrap().unwrap();
    assert!(spot.rotation.angle() < 1e-6);
}

/// A stove of two burners: the second thing goes to the free one, though there is room beside the
/// first, and a third beside one of them.
#[test]
fn burners_are_taken_one_after_the_other() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let parts = vec![part("body", block([0.3, 0.3, 0.45]), at(0.0, 0.0, 0.45), scene.wood)];
    let burner = |x: f32| surface("burner", Hold::On, [x, 0.0, 0.9], (0.12, 0.12), None);
    let surfaces = vec![burner(-0.15), burner(0.15)];
    let asset = scene.asset(Asset { name: "stove".into(), parts, surfaces, ..Asset::default() });
    let stove = scene.add("stove", asset, at(0.0, 0.0, 0.0));
    let things: Vec<NodeId> = (0..3).map(|i| scene.cube(0.03, at(2.0 + 0.2 * i as f32, 0.0, 0.03))).collect();
    let mut world = scene.world();
    let mut middles = Vec::new();
    for &thing in &things {
        let spot = SpotSearch::new(thing, stove, false)
            .order(SpotOrder::Near(Point3::new(0.0, -1.0, 0.9)))
            .find(&world)
            .unwrap()
            .unwrap();
        world.place(thing, spot).unwrap();
        world.settle(60);
        middles.push(spot.translation.vector.xy());
    }
    let burners = [nalgebra::Vector2::new(-0.15, 0.0), nalgebra::Vector2::new(0.15, 0.0)];
    assert!((middles[0] - burners[0]).norm() < 1e-3 && (middles[1] - burners[1]).norm() < 1e-3, "{middles:?}");
    assert!(burners.iter().any(|b| (middles[2] - b).amax() < 0.12), "{middles:?}");
}

/// A thing that is put on a table goes beside a sheet of paper there: on the sheet, it would not be on the table.
#[test]
fn a_sheet_of_paper_takes_up_room() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let table = scene.table(at(0.0, 0.0, 0.0));
    let cube = scene.cube(0.05, at(2.0, 0.0, 0.051));
    let sheet = scene.solid("sheet", block([0.25, 0.3, 0.0003]), scene.wood);
    let sheet = scene.add("document", sheet, at(0.0, 0.0, 0.7404));
    let mut world = scene.world();
    world.settle(60);
    let wish = |x, y| SpotWish { point: Some([x, y].into()), ..SpotWish::default() };
    let search = SpotSearch::new(cube, table, false);
    let found = |wish: SpotWish| search.wished(&world, &wish, |_| true).unwrap();
    assert_eq!(found(wish(0.1, 0.1)), Err(SpotFault::Taken(vec![sheet])));
    assert!(found(wish(0.1, 0.5)).is_ok() && found(SpotWish::default()).is_ok());
    for packing in [Packing::Apart, Packing::Close] {
        let mut world = world.clone();
        let spot = search.packing(packing).find(&world).unwrap().unwrap();
        world.place(cube, spot).unwrap();
        let report = world.settle(120);
        assert!(report.at_rest && world.supports(cube) == [table], "{packing:?}: {report:?}");
    }
}

/// A thing that is too tall to stand in the chest is laid on its side, but not with something on it.
#[test]
fn what_carries_something_is_not_tipped() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let chest = chest(&mut scene);
    let tall = scene.solid("tall", block([0.08, 0.08, 0.2]), scene.wood);
    let tall = scene.add("toy", tall, at(1.0, 0.0, 0.2));
    let on_it = scene.cube(0.04, at(1.0, 0.0, 0.441));
    let mut world = scene.world();
    world.settle(120);
    assert_eq!(SpotSearch::new(tall, chest, true).find(&world).unwrap(), None);
    world.place(on_it, at(-1.0, 0.0, 0.041)).unwrap();
    world.settle(120);
    assert!(SpotSearch::new(tall, chest, true).find(&world).unwrap().is_some());
}

/// Seventeen cubes are more than stand on the bottom of the chest, four by three of them.
#[test]
fn things_are_heaped_in_containers_up_to_the_rim() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let chest = chest(&mut scene);
    let cubes: Vec<NodeId> = (0..40).map(|i| scene.cube(0.06, at(2.0 + 0.2 * i as f32, 0.0, 0.06))).collect();
    let mut world = scene.world();
    world.settle(60);
    let mut put = 0;
    for &cube in &cubes {
        let flat = SpotSearch::new(cube, chest, true).find(&world).unwrap();
        let Some(spot) =
            flat.or_else(|| SpotSearch::new(cube, chest, true).packing(Packing::Heaped).find(&world).unwrap())
        else {
            break;
        };
        world.place(cube, spot).unwrap();
        world.settle(120);
        assert!(within(&world, cube, chest), "the {put}. is not in the chest");
        put += 1;
    }
    assert!((17..=36).contains(&put), "{put} cubes");
}

/// An asset states the rectangle within a round top. Four plates find room around a pie all the same, and stay
/// on the table.
#[test]
fn a_round_table_is_used_up_to_its_edge() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let disc = |radius: f32, half_height: f32| Shape::Cylinder { radius, half_height };
    let parts = vec![
        part("top", disc(0.4, 0.02), at(0.0, 0.0, 0.73), scene.wood),
        part("foot", disc(0.25, 0.355), at(0.0, 0.0, 0.355), scene.wood),
    ];
    let surfaces = vec![surface("top", Hold::On, [0.0, 0.0, 0.75], (0.26, 0.26), None)];
    let asset = scene.asset(Asset { name: "table".into(), parts, surfaces, ..Asset::default() });
    let table = scene.add("table", asset, at(0.0, 0.0, 0.0));
    let plate = scene.solid("plate", disc(0.125, 0.012), scene.wood);
    let plates: Vec<NodeId> = (0..5).map(|i| scene.add("plate", plate, at(2.0 + 0.4 * i as f32, 0.0, 0.012))).collect();
    let mut world = scene.world();
    world.place(plates[0], at(0.0, 0.0, 0.763)).unwrap();
    world.settle(60);
    for &plate in &plates[1..] {
        let spot = SpotSearch::new(plate, table, false)
            .order(SpotOrder::Near(Point3::new(0.0, -1.0, 0.75)))
            .find(&world)
            .unwrap()
            .unwrap();
        world.place(plate, spot).unwrap();
        let report = world.settle(120);
        assert!(report.at_rest && world.supports(plate) == [table], "{report:?}");
    }
    for (x, y) in [(0.5, 0.0), (0.5, 0.5)] {
        let near = SpotOrder::Near(Point3::new(x, y, 0.75));
        (0..5).for_each(|i| world.place(plates[i], at(2.0 + 0.4 * i as f32, 0.0, 0.012)).unwrap());
        let spot =
            SpotSearch::new(plates[0], table, false).order(near).packing(Packing::Close).find(&world).unwrap().unwrap();
        world.place(plates[0], spot).unwrap();
        world.settle(120);
        let far = world.pose(plates[0]).unwrap().translation.vector.xy().norm();
        assert!((0.28..0.36).contains(&far) && world.supports(plates[0]) == [table], "{far} m from the middle");
    }
}

/// A hanging shirt of 0.3 kg, beside the chest.
fn shirt() -> (SceneGraph, NodeId, NodeId, NodeId) {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let chest = chest(&mut scene);
    let cloth = scene.library.add_material(common::material("cotton", 20.0, 0.7, 0.0)).unwrap();
    let shirt = scene.solid("shirt", block([0.03, 0.26, 0.38]), cloth);
    let shirt = scene.add("shirt", shirt, at(0.6, 0.0, 0.4));
    let me = scene.agent(at(0.9, 0.3, 0.0));
    (scene.graph(), chest, shirt, me)
}

#[test]
fn cloth_is_folded_up_in_the_hand() {
    let (mut graph, chest, shirt, me) = shirt();
    let shapes = ShapeCache::new();
    let mut world = PhysicsWorld::build(&graph, &shapes, plain()).unwrap();
    assert_eq!(SpotSearch::new(shirt, chest, true).find(&world).unwrap(), None);
    world.grab(me, Hand::Right, shirt).unwrap();
    let (mass, by) = (world.body(shirt).unwrap().mass(), world.body(shirt).unwrap().folded_scale().unwrap());
    let mut edit = graph.edit();
    edit.set_scale(shirt, by).unwrap();
    edit.commit();
    world.reshape(&graph, shirt, &shapes).unwrap();
    assert_eq!(world.held(me, Hand::Right), Some(shirt));
    assert!((world.body(shirt).unwrap().mass() - mass).abs() < 1e-4 * mass, "folding takes nothing away");
    // So dense that seven kilograms fill a drum of sixty litres.
    let size = world.aabb(shirt).map(|b| b.max - b.min).unwrap();
    assert!((mass / size.product() - 115.0).abs() < 1.0, "{mass} kg in {size:?}");
    assert!(world.body(shirt).unwrap().folded_scale().is_none(), "it gets no smaller");
    let spot =
        SpotSearch::new(shirt, chest, true).order(SpotOrder::Near(Point3::origin())).find(&world).unwrap().unwrap();
    world.put(me, Hand::Right, spot).unwrap();
    let report = world.settle(300);
    assert!(report.at_rest && within(&world, shirt, chest), "{report:?}");
    // A world is written and read with it as it is now.
    let saved = world.save().unwrap();
    let again = PhysicsWorld::restore(&saved, &graph, &shapes).unwrap();
    assert_eq!((again.digest(), again.aabb(shirt)), (world.digest(), world.aabb(shirt)));
}

#[test]
fn what_has_moving_parts_is_not_reshaped() {
    let mut scene = Scene::default();
    let asset = scene.chest_asset();
    let chest = scene.add("dresser", asset, at(0.0, 0.0, 0.0));
    let mut graph = scene.graph();
    let shapes = ShapeCache::new();
    let mut world = PhysicsWorld::build(&graph, &shapes, plain()).unwrap();
    let mut edit = graph.edit();
    edit.set_scale(chest, Vector3::repeat(0.5)).unwrap();
    edit.commit();
    assert!(world.reshape(&graph, chest, &shapes).is_err());
    assert!(world.reshape(&graph, NodeId(999), &shapes).is_err());
    assert!(world.body(NodeId(999)).is_err());
}

/// One of two boards on a tray is said to come along; the other is left where it was, and falls.
#[test]
fn what_does_not_come_along_is_left_behind() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    scene.table(at(0.7, 0.0, 0.0));
    let tray = scene.solid("tray", block([0.15, 0.2, 0.01]), scene.wood);
    let tray = scene.add("tray", tray, at(0.5, 0.0, 0.751));
    let (one, other) = (scene.cube(0.04, at(0.5, 0.1, 0.802)), scene.cube(0.04, at(0.5, -0.1, 0.802)));
    let me = scene.agent(at(0.0, 0.0, 0.0));
    let mut world = scene.world();
    world.settle(200);
    let before = world.pose(other).unwrap().translation.vector;
    world.grab_with_load(me, Hand::Right, tray, &[one]).unwrap();
    world.settle(200);
    let after = world.pose(other).unwrap().translation.vector;
    assert!((before - after).xy().norm() < 0.05 && (0.015..0.025).contains(&(before - after).z), "{after:?}");
    assert!(world.pose(one).unwrap().translation.z > 0.9);
}

/// A thing that is deeper than the room on a seat is turned so that it reaches over the front edge as little as possible.
#[test]
fn what_is_deeper_than_a_seat_reaches_over_it_little() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let w = scene.wood;
    let parts = vec![
        part("seat", block([0.25, 0.9, 0.2]), at(0.0, 0.0, 0.2), w),
        part("back", block([0.075, 0.9, 0.4]), at(-0.175, 0.0, 0.6), w),
    ];
    let surfaces = vec![surface("seat", Hold::On, [0.0, 0.0, 0.4], (0.25, 0.9), None)];
    let sofa = scene.asset(Asset { name: "sofa".into(), parts, surfaces, ..Asset::default() });
    let sofa = scene.add("sofa", sofa, at(0.0, 0.0, 0.0));
    // Turned by a quarter it reaches over the edge less.
    let pillow = scene.solid("pillow", block([0.3, 0.26, 0.06]), w);
    let pillow = scene.add("pillow", pillow, at(2.0, 0.0, 0.06));
    let mut world = scene.world();
    let spot = SpotSearch::new(pillow, sofa, false).find(&world).unwrap().unwrap();
    world.place(pillow, spot).unwrap();
    let over = world.aabb(pillow).unwrap().max.x - 0.25;
    assert!(over < 0.22, "{over} m over the edge");
}

/// A bowl with a slanted rim of a millimetre and a half takes up no more room than it has: the pieces of the rim stay
/// within the circle.
#[test]
fn thin_rings_are_as_wide_as_they_are() {
    let mut scene = Scene::default();
    let profile = vec![(0.06, 0.0), (0.1, 0.06), (0.09, 0.0615), (0.05, 0.006), (0.0, 0.006), (0.0, 0.0)];
    let bowl = scene.solid("bowl", Shape::Lathe { profile }, scene.wood);
    let bowl = scene.add("bowl", bowl, at(0.0, 0.0, 1.0));
    let (low, high) = scene.world().body(bowl).unwrap().local_bounds();
    let wide = [low.x, low.y, high.x, high.y].map(f32::abs).into_iter().fold(0.0, f32::max);
    assert!((0.094..0.1005).contains(&wide), "{wide} m");
}

/// Where a spot is asked for without a point, the reason says what does not fit, not that others are in the way.
#[test]
fn what_does_not_fit_is_told_why() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let chest = chest(&mut scene);
    let parts = vec![part("board", block([0.26, 0.21, 0.01]), at(0.0, 0.0, 0.01), scene.wood)];
    let surfaces = vec![surface("board", Hold::Inside, [0.0, 0.0, 0.02], (0.2, 0.15), Some(0.1))];
    let low = scene.asset(Asset { name: "low".into(), parts, surfaces, ..Asset::default() });
    let low = scene.add("dresser", low, at(2.0, 0.0, 0.0));
    let wide = scene.solid("board", block([0.5, 0.5, 0.05]), scene.wood);
    let (wide, cube) = (scene.add("toy", wide, at(0.0, 3.0, 0.05)), scene.cube(0.08, at(0.0, -3.0, 0.08)));
    let world = scene.world();
    let why = |id, at| SpotSearch::new(id, at, true).wished(&world, &SpotWish::default(), |_| true).unwrap();
    assert_eq!(why(cube, low), Err(SpotFault::TooLow));
    assert_eq!(why(wide, chest), Err(SpotFault::Unsupported));
}
