//! Paths on the floor, compared with a slow search over all corners.

#![allow(clippy::unwrap_used, reason = "tests stop where something is wrong")]

use crate::common;

use common::{Scene, at};
use nalgebra::{Point2, Vector2};
use vc_graph::{NodeId, Seed};
use vc_physics::{BodyPlan, DoorHandling, Floor, FloorOptions};

type Outline = Vec<Point2<f32>>;

fn rectangle(x0: f32, y0: f32, x1: f32, y1: f32) -> Outline {
    vec![Point2::new(x0, y0), Point2::new(x1, y0), Point2::new(x1, y1), Point2::new(x0, y1)]
}

fn turned(centre: Point2<f32>, half: (f32, f32), angle: f32) -> Outline {
    let (sin, cos) = angle.sin_cos();
    let corner = |x: f32, y: f32| centre + Vector2::new(x * cos - y * sin, x * sin + y * cos);
    vec![corner(-half.0, -half.1), corner(half.0, -half.1), corner(half.0, half.1), corner(-half.0, half.1)]
}

/// A floor of eight by six metres with boxes, some of them rotated.
fn random_floor(seed: u64) -> (Vec<Outline>, Vec<Outline>) {
    let mut rng = Seed(seed).stream();
    let mut obstacles: Vec<Outline> = (0..rng.count(4, 14))
        .map(|_| {
            let centre = Point2::new(rng.between(0.5, 7.5), rng.between(0.5, 5.5));
            let half = (rng.between(0.1, 0.7), rng.between(0.1, 0.7));
            let angle = if rng.chance(0.5) { 0.0 } else { rng.between(0.0, 1.5) };
            turned(centre, half, angle)
        })
        .collect();
    // The edges of the floor are walls.
    let walls = [(-0.1, -0.1, 8.1, 0.0), (-0.1, 6.0, 8.1, 6.1), (-0.1, -0.1, 0.0, 6.1), (8.0, -0.1, 8.1, 6.1)];
    obstacles.extend(walls.map(|(a, b, c, d)| rectangle(a, b, c, d)));
    (vec![rectangle(0.0, 0.0, 8.0, 6.0)], obstacles)
}

fn distance_to(p: Point2<f32>, outline: &Outline) -> f32 {
    let next = outline.iter().cycle().skip(1);
    let inside = outline.iter().zip(next.clone()).all(|(a, b)| (b - a).perp(&(p - a)) >= 0.0);
    if inside {
        return 0.0;
    }
    let edge = |(a, b): (&Point2<f32>, &Point2<f32>)| {
        let t = ((p - a).dot(&(b - a)) / (b - a).norm_squared()).clamp(0.0, 1.0);
        (p - (a + (b - a) * t)).norm()
    };
    outline.iter().zip(next).map(edge).fold(f32::MAX, f32::min)
}

/// Distance between a segment and a convex outline.
fn segment_distance(a: Point2<f32>, b: Point2<f32>, outline: &Outline) -> f32 {
    let side = |p: Point2<f32>, q: Point2<f32>, r: Point2<f32>| (q - p).perp(&(r - p));
    let next = outline.iter().cycle().skip(1);
    let cut = outline
        .iter()
        .zip(next)
        .any(|(&p, &q)| side(a, b, p) * side(a, b, q) < 0.0 && side(p, q, a) * side(p, q, b) < 0.0);
    if cut {
        return 0.0;
    }
    let line = vec![a, b, a];
    let corners = outline.iter().map(|p| distance_to_path(*p, &line)).fold(f32::MAX, f32::min);
    corners.min(distance_to(a, outline)).min(distance_to(b, outline))
}

fn distance_to_path(p: Point2<f32>, path: &[Point2<f32>]) -> f32 {
    let edge = |w: &[Point2<f32>]| {
        let way = w[1] - w[0];
        let t = if way.norm() > 0.0 { ((p - w[0]).dot(&way) / way.norm_squared()).clamp(0.0, 1.0) } else { 0.0 };
        (p - (w[0] + way * t)).norm()
    };
    path.windows(2).map(edge).fold(f32::MAX, f32::min)
}

/// The true shortest path that keeps a distance from everything: corners are circles around the obstacles'
/// corners, as circumscribed polygons with many sides, and every pair of points is tested (Dijkstra on the
/// visibility graph).
fn brute_force(obstacles: &[Outline], radius: f32, from: Point2<f32>, to: Point2<f32>) -> Option<f32> {
    const SIDES: usize = 48;
    let clear = |p: Point2<f32>| obstacles.iter().all(|o| distance_to(p, o) >= radius - 1e-4);
    let mut points = vec![from, to];
    let outer = radius / (std::f32::consts::PI / SIDES as f32).cos() + 1e-4;
    for corner in obstacles.iter().flatten() {
        for i in 0..SIDES {
            let angle = std::f32::consts::TAU * i as f32 / SIDES as f32;
            let p = corner + Vector2::new(angle.cos(), angle.sin()) * outer;
            if clear(p) && p.x > 0.0 && p.x < 8.0 && p.y > 0.0 && p.y < 6.0 {
                points.push(p);
            }
        }
    }
    let free = |a: Point2<f32>, b: Point2<f32>| obstacles.iter().all(|o| segment_distance(a, b, o) >= radius - 1e-4);
    let mut best = vec![f32::INFINITY; points.len()];
    let mut done = vec![false; points.len()];
    best[0] = 0.0;
    loop {
        let open = (0..points.len()).filter(|&i| !done[i] && best[i].is_finite());
        let next =
            open.min_by(|&a, &b| (best[a] + (points[a] - to).norm()).total_cmp(&(best[b] + (points[b] - to).norm())))?;
        if next == 1 {
            return Some(best[1]);
        }
        done[next] = true;
        for i in 0..points.len() {
            let length = best[next] + (points[i] - points[next]).norm();
            if !done[i] && length < best[i] && free(points[next], points[i]) {
                best[i] = length;
            }
        }
    }
}

#[test]
fn ways_are_within_two_percent_of_the_shortest() {
    let plan = FloorOptions { radius: 0.25, ..FloorOptions::default() };
    let (mut compared, mut worst, mut only_one, mut tight) = (0, 0.0_f32, 0, 0);
    for seed in 0..100 {
        let (ground, obstacles) = random_floor(seed);
        let floor = Floor::from_outlines(&ground, &obstacles, plan);
        let mut rng = Seed(seed).child("ends").stream();
        let mut point = || loop {
            let p = Point2::new(rng.between(0.0, 8.0), rng.between(0.0, 6.0));
            // A little off the edge of the free floor, where both searches agree about free points.
            if obstacles.iter().all(|o| distance_to(p, o) > plan.radius + 0.05) && floor.is_free(p) {
                break p;
            }
        };
        let (from, to) = (point(), point());
        match (floor.route(from, to), brute_force(&obstacles, plan.radius, from, to)) {
            (Some(route), Some(shortest)) if shortest > 0.5 => {
                check(&route.points, &obstacles, plan.radius - 0.036);
                let mut ratio = route.length / shortest;
                if ratio > 1.02 {
                    // A gap with less than two centimetres to spare may be closed on the grid: then the
                    // shortest path of a body one centimetre wider is the reference.
                    let wider = brute_force(&obstacles, plan.radius + 0.01, from, to).unwrap();
                    tight += 1;
                    ratio = route.length / wider;
                }
                assert!(ratio > 0.98, "seed {seed}: {} shorter than the shortest {shortest}", route.length);
                worst = worst.max(ratio);
                compared += 1;
            }
            (Some(_), Some(_)) | (None, None) => {}
            // A gap as wide as the body may be open in one search and closed in the other.
            _ => only_one += 1,
        }
    }
    assert!(compared > 80 && only_one + tight <= 3, "{compared} compared, {only_one} disagree, {tight} tight");
    assert!(worst < 1.02, "the worst way is {worst} of the shortest");
}

fn check(points: &[Point2<f32>], obstacles: &[Outline], clearance: f32) {
    for pair in points.windows(2) {
        for obstacle in obstacles {
            let distance = segment_distance(pair[0], pair[1], obstacle);
            assert!(distance >= clearance, "{distance} m from an obstacle");
        }
    }
}

/// On the same cells the path is exactly the shortest: compared with a search over all corners of the free
/// cells.
#[test]
fn ways_are_the_shortest_over_the_cells() {
    let plan = FloorOptions { radius: 0.2, cell: 0.2, ..FloorOptions::default() };
    for seed in 0..60 {
        let (ground, obstacles) = random_floor(1000 + seed);
        let floor = Floor::from_outlines(&ground, &obstacles, plan);
        let mut rng = Seed(seed).child("cells").stream();
        let mut point = || {
            (0..200).find_map(|_| {
                let p = Point2::new(rng.between(0.0, 8.0), rng.between(0.0, 6.0));
                floor.is_free(p).then_some(p)
            })
        };
        let (Some(from), Some(to)) = (point(), point()) else { continue };
        let ours = floor.route(from, to).map(|r| r.length);
        let slow = over_cells(&floor, plan.cell, from, to);
        match (ours, slow) {
            (Some(a), Some(b)) => assert!((a - b).abs() < 2e-3, "seed {seed}: {a}, should be {b}"),
            (a, b) => assert_eq!(a.is_some(), b.is_some(), "seed {seed}"),
        }
    }
}

/// Points of an ellipse, rotated; some of them repeated.
fn around(centre: Point2<f32>, half: (f32, f32), corners: usize, angle: f32, twice: bool) -> Outline {
    let corner = |i: usize| {
        let (sin, cos) = (i as f32 / corners as f32 * std::f32::consts::TAU).sin_cos();
        let (x, y) = (half.0 * cos, half.1 * sin);
        centre + Vector2::new(x * angle.cos() - y * angle.sin(), x * angle.sin() + y * angle.cos())
    };
    (0..corners).flat_map(|i| std::iter::repeat_n(corner(i), if twice && i % 2 == 0 { 2 } else { 1 })).collect()
}

#[test]
fn cells_are_free_whose_middles_keep_clear() {
    let ground = rectangle(0.0, 0.0, 4.0, 3.0);
    let (mut free, mut taken) = (0, 0);
    for seed in 0..400 {
        let mut rng = Seed(seed).child("clear").stream();
        let plan =
            FloorOptions { radius: rng.between(0.0, 0.5), cell: rng.between(0.02, 0.2), ..FloorOptions::default() };
        let mut one = || {
            let centre = Point2::new(rng.between(-0.5, 4.5), rng.between(-0.5, 3.5));
            let half = (rng.between(0.02, 0.8), rng.between(0.02, 0.8));
            // Rectangles along the axes are included.
            let angle = if rng.chance(0.4) { 0.0 } else { rng.between(0.0, 3.0) };
            around(centre, half, rng.count(1, 17), angle, rng.chance(0.2))
        };
        let obstacles = [one(), one()];
        let floor = Floor::from_outlines(std::slice::from_ref(&ground), &obstacles, plan);
        for (row, column) in (0..15).flat_map(|r| (0..20).map(move |c| (r, c))) {
            let whole = |i: i32, of: i32, length: f32| (i as f32 / of as f32 * length / plan.cell).floor() + 0.5;
            let p = Point2::new(whole(column, 20, 4.0), whole(row, 15, 3.0)) * plan.cell;
            let edge = |o: &Outline| {
                o.iter().zip(o.iter().cycle().skip(1)).map(|(a, b)| to_segment(p, *a, *b)).fold(f32::MAX, f32::min)
            };
            let clear = obstacles.iter().map(edge).fold(f32::MAX, f32::min);
            let covered = obstacles.iter().any(|o| o.len() > 2 && distance_to(p, o) == 0.0);
            // Within rounding of the radius or of the floor's edge either result is correct.
            if (clear - plan.radius).abs() < 1e-4 || p.x > 3.999 || p.y > 2.999 {
                continue;
            }
            let expected = !covered && clear > plan.radius;
            assert_eq!(floor.is_free(p), expected, "seed {seed}, {p}: {clear} m from {obstacles:?}, {plan:?}");
            if expected { free += 1 } else { taken += 1 }
        }
    }
    assert!(free > 10_000 && taken > 10_000, "{free} free, {taken} taken");
}

fn to_segment(p: Point2<f32>, a: Point2<f32>, b: Point2<f32>) -> f32 {
    let way = b - a;
    let t = if way.norm_squared() > 0.0 { ((p - a).dot(&way) / way.norm_squared()).clamp(0.0, 1.0) } else { 0.0 };
    (p - (a + way * t)).norm()
}

/// Dijkstra over all corners of cells, with finely sampled lines of sight.
fn over_cells(floor: &Floor, cell: f32, from: Point2<f32>, to: Point2<f32>) -> Option<f32> {
    let free = |x: f32, y: f32| floor.is_free(Point2::new(x, y));
    let mut points = vec![from, to];
    let half = cell / 2.0;
    for i in 0..=45 {
        for j in 0..=35 {
            let (x, y) = (i as f32 * cell, j as f32 * cell);
            let around = [(-half, -half), (half, -half), (half, half), (-half, half)].map(|(a, b)| free(x + a, y + b));
            if around.iter().filter(|f| !**f).count() == 1 {
                points.push(Point2::new(x, y));
            }
        }
    }
    let sees = |a: Point2<f32>, b: Point2<f32>| {
        let steps = ((b - a).norm() / (cell * 0.02)).ceil().max(1.0);
        let side = (b - a).try_normalize(1e-9).map_or_else(Vector2::zeros, |d| Vector2::new(-d.y, d.x)) * 1e-3;
        // A line along an edge is free if one side of it is.
        let along = |side: Vector2<f32>| {
            (1..steps as usize).all(|k| {
                let p = a + (b - a) * (k as f32 / steps);
                free(p.x, p.y) || free(p.x + side.x, p.y + side.y)
            })
        };
        along(side) || along(-side)
    };
    let mut best = vec![f32::INFINITY; points.len()];
    let mut done = vec![false; points.len()];
    best[0] = 0.0;
    loop {
        let next = (0..points.len())
            .filter(|&i| !done[i] && best[i].is_finite())
            .min_by(|&a, &b| best[a].total_cmp(&best[b]))?;
        if next == 1 {
            return Some(best[1]);
        }
        done[next] = true;
        for i in 0..points.len() {
            let length = best[next] + (points[i] - points[next]).norm();
            if !done[i] && length < best[i] && sees(points[next], points[i]) {
                best[i] = length;
            }
        }
    }
}

/// Three rooms in a row, with doors between them.
fn rooms() -> (Scene, Vec<NodeId>) {
    let mut scene = Scene::default();
    scene.floor(6.0, 0.5);
    for (low, high) in
        [([-6.0, -2.1], [6.0, -2.0]), ([-6.0, 2.0], [6.0, 2.1]), ([-6.1, -2.0], [-6.0, 2.0]), ([6.0, -2.0], [6.1, 2.0])]
    {
        scene.wall([low[0], low[1], 0.0], [high[0], high[1], 2.6]);
    }
    let door = scene.door_asset();
    let mut doors = Vec::new();
    for x in [-2.0, 2.0] {
        scene.wall([x - 0.05, -2.0, 0.0], [x + 0.05, -0.42, 2.6]);
        scene.wall([x - 0.05, 0.42, 0.0], [x + 0.05, 2.0, 2.6]);
        doors.push(scene.add("door", door, at(x, 0.0, 0.0)));
    }
    (scene, doors)
}

#[test]
fn doors_block_and_open() {
    let (scene, doors) = rooms();
    let mut world = scene.world();
    let (left, right) = (Point2::new(-4.0, -1.0), Point2::new(4.0, 1.0));
    let as_they_are = FloorOptions { doors: DoorHandling::AsTheyAre, ..FloorOptions::default() };
    let mut floor = Floor::new(&world, as_they_are);
    let mut any = Floor::new(&world, FloorOptions::default());
    assert_eq!(floor.route(left, right), None, "they are shut");
    let route = any.route(left, right).unwrap();
    assert_eq!(route.doors, doors, "they can be opened");
    let straight = (right - left).norm();
    assert!(route.length >= straight && route.length < straight * 1.1);
    for &door in &doors {
        world.put_open(door, Some(0), 1.0).unwrap();
    }
    assert!(floor.update(&world) && !floor.update(&world));
    let open = floor.route(left, right).unwrap();
    assert!((open.length / route.length - 1.0).abs() < 0.05, "the leaf leaves room");
    world.put_open(doors[1], Some(0), 0.0).unwrap();
    world.lock(doors[1], 0, true).unwrap();
    assert!(any.update(&world));
    assert_eq!(any.route(left, right), None, "one is locked");
    assert!(any.route(left, Point2::new(0.0, 0.0)).is_some());
}

/// An open drawer is closed in passing, and listed; under `AsTheyAre` it is an obstacle.
#[test]
fn open_drawers_are_shut_in_passing() {
    let (mut scene, _) = rooms();
    let chest = scene.chest_asset();
    let chest = scene.add("kitchen_cabinet", chest, at(4.0, 0.0, 0.0));
    scene.wall([4.75, -2.0, 0.0], [4.85, 2.0, 2.6]);
    let mut world = scene.world();
    world.put_open(chest, Some(0), 1.0).unwrap();
    let (a, b) = (Point2::new(4.5, -1.5), Point2::new(4.5, 1.5));
    let straight = FloorOptions { radius: 0.15, ..FloorOptions::default() };
    let route = Floor::new(&world, straight).route(a, b).unwrap();
    assert!(route.length < 3.01 && route.doors == [chest], "{route:?}");
    let as_it_is = Floor::new(&world, FloorOptions { doors: DoorHandling::AsTheyAre, ..straight });
    assert!(as_it_is.route(a, b).is_some_and(|r| r.length > 3.2 && r.doors.is_empty()));
}

#[test]
fn chairs_in_the_way() {
    let (mut scene, _) = rooms();
    let crate_ = scene.cube(0.45, at(4.5, 0.0, 0.45));
    let mut world = scene.world();
    let mut floor = Floor::new(&world, FloorOptions::default());
    let (a, b) = (Point2::new(0.0, 0.0), Point2::new(5.5, 0.0));
    let round = floor.route(a, b).unwrap();
    assert!(round.length > 5.6 && round.points.len() > 2);
    world.place(crate_, at(4.5, -1.5, 0.45)).unwrap();
    assert!(floor.update(&world));
    assert!((floor.route(a, b).unwrap().length - 5.5).abs() < 0.01);
    // Carried things are not obstacles.
    world.remove(crate_).unwrap();
    assert!(floor.update(&world));
}

/// A thing in a doorway shuts in whoever is on either side of it; one in a corner nobody.
#[test]
fn ways_stay_open_or_do_not() {
    let (mut scene, _) = rooms();
    let crate_ = scene.cube(0.2, at(4.5, 1.5, 2.0));
    let world = scene.world();
    let floor = Floor::new(&world, FloorOptions::default());
    let open = |x: f32, y: f32, from: &[Point2<f32>]| floor.stays_open(&world, crate_, &at(x, y, 0.2), from).unwrap();
    let (left, middle) = (Point2::new(-4.0, -1.0), Point2::new(0.0, 0.0));
    assert!(!open(-2.0, 0.0, &[left]) && !open(-1.5, 0.0, &[middle]));
    assert!(open(-2.0, 0.0, &[]), "nobody is there");
    assert!(open(0.0, 1.7, &[left, middle]) && open(-3.5, 0.0, &[left]), "there is a way around it");
    assert!(floor.stays_open(&world, crate_, &at(-2.0, 0.0, 2.2), &[left]).unwrap(), "one walks below it");
    assert!(floor.stays_open(&world, NodeId(999), &at(0.0, 0.0, 0.2), &[left]).is_err());
}

/// Things on a table are not obstacles; things that jut out over its edge are.
#[test]
fn things_on_tables_are_not_in_the_way() {
    let (mut scene, _) = rooms();
    let table = scene.table(at(4.0, 0.0, 0.0));
    let cup = scene.cube(0.05, at(4.0, 0.0, 0.79));
    let mut edit = scene.builder.edit();
    edit.place(cup, vc_graph::Place { relation: vc_graph::Relation::On, at: table }).unwrap();
    edit.commit();
    let mut world = scene.world();
    let mut floor = Floor::new(&world, FloorOptions::default());
    let area = floor.area();
    world.place(cup, at(4.2, 0.1, 0.79)).unwrap();
    floor.update(&world);
    assert_eq!(floor.area(), area);
    world.place(cup, at(4.45, 0.0, 0.79)).unwrap();
    floor.update(&world);
    assert!(floor.area() < area && !floor.is_free(Point2::new(4.72, 0.0)));
}

#[test]
fn places_to_stand() {
    let (mut scene, _) = rooms();
    scene.table(at(4.0, 0.0, 0.0));
    let near = scene.cube(0.05, at(4.3, 0.5, 0.79));
    let floor_toy = scene.cube(0.05, at(-4.0, 1.5, 0.05));
    let high = scene.wall([5.7, -0.3, 2.2], [6.0, 0.3, 2.25]);
    let out_of_reach = scene.cube(0.05, at(5.9, 0.0, 3.2));
    let world = scene.world();
    let floor = Floor::new(&world, FloorOptions::default());
    let plan = BodyPlan::default();
    let from = Point2::new(0.0, 0.0);
    for id in [near, floor_toy] {
        let stand = floor.standing_pose(&world, &plan, from, id).unwrap().unwrap();
        let feet: Point2<f32> = stand.feet.translation.vector.xy().into();
        assert!(floor.is_free(feet));
        let thing = world.pose(id).unwrap().translation.vector.xy();
        assert!((thing - feet.coords).norm() < plan.stretch() + 0.05);
        let front = (stand.feet.rotation * nalgebra::Vector3::x()).xy();
        assert!(front.dot(&(thing - feet.coords).normalize()) > 0.99, "it faces the thing");
        assert!((stand.route.points.last().unwrap() - feet).norm() < 1e-3);
    }
    assert_eq!(floor.standing_pose(&world, &plan, from, out_of_reach).unwrap(), None);
    assert!(floor.standing_pose(&world, &plan, from, NodeId(999)).is_err());
    let _ = high;
}

/// The standing position is the nearest, by path length, from which a thing is within reach and visible: not
/// behind the board that hides it.
#[test]
fn the_nearest_place_to_stand() {
    let mut scene = Scene::default();
    scene.floor(6.0, 0.5);
    // A stand, and a board in front of its near side.
    scene.wall([-0.15, -0.15, 0.0], [0.15, 0.15, 0.74]);
    scene.wall([-0.19, -0.4, 0.0], [-0.17, 0.4, 2.2]);
    let cup = scene.cube(0.05, at(0.0, 0.0, 0.79));
    let me = scene.agent(at(-3.0, 0.2, 0.0));
    let mut world = scene.world();
    world.run(5);
    let floor = Floor::new(&world, FloorOptions::default());
    let (plan, from) = (BodyPlan::default(), Point2::new(-3.0, 0.2));
    let stand = floor.standing_pose(&world, &plan, from, cup).unwrap().unwrap();
    let length = |spot: Point2<f32>| floor.route(from, spot).map(|r| r.length);
    // All spots of a fine grid where the agent could stand, tested as for the agent there.
    let mut best = f32::MAX;
    for (i, k) in (0..70).flat_map(|i| (0..70).map(move |k| (i, k))) {
        let spot = Point2::new(-1.4 + 0.04 * i as f32, -1.4 + 0.04 * k as f32);
        let feet = at(spot.x, spot.y, 0.0);
        if floor.is_free(spot) && length(spot).is_some_and(|l| l < best) {
            world.teleport(me, feet).unwrap();
            let reach =
                world.agent(me).unwrap().in_reach().iter().any(|(id, far)| *id == cup && *far < plan.reach - 0.06);
            if reach && floor.sees(&world, &plan, &feet, cup) {
                best = length(spot).unwrap();
            }
        }
    }
    let feet: Point2<f32> = stand.feet.translation.vector.xy().into();
    assert!(feet.x > -0.2 || feet.y.abs() > 0.4, "not where the board hides it: {feet}");
    assert!(stand.route.length < best + 0.15, "{} m, where {best} m are enough", stand.route.length);
}

#[test]
fn odd_floors() {
    let plan = FloorOptions::default();
    let p = Point2::new(1.0, 1.0);
    for (ground, obstacles) in [
        (vec![], vec![]),
        (vec![vec![]], vec![vec![]]),
        (vec![rectangle(0.0, 0.0, 0.0, 0.0)], vec![]),
        (vec![vec![Point2::new(f32::NAN, 0.0), p, p]], vec![]),
    ] {
        let floor = Floor::from_outlines(&ground, &obstacles, plan);
        assert_eq!(floor.route(p, p), None);
        assert!(!floor.is_free(p) && floor.area() == 0.0);
    }
    let huge = Floor::from_outlines(&[rectangle(-9000.0, -9000.0, 9000.0, 9000.0)], &[], plan);
    assert!(huge.route(Point2::new(-8000.0, 0.0), Point2::new(8000.0, 10.0)).is_some());
    let point_obstacle = Floor::from_outlines(&[rectangle(0.0, 0.0, 2.0, 2.0)], &[vec![p]], plan);
    assert!(!point_obstacle.is_free(p) && point_obstacle.is_free(Point2::new(1.0, 1.4)));
    assert_eq!(point_obstacle.route(Point2::new(f32::NAN, 0.0), p), None);
}
