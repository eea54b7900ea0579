//! Windows of generated homes are set into their walls without a gap.

#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use nalgebra::Point3;
use virtualcity::graph::asset::Part;
use virtualcity::graph::{Node, NodeId, SceneGraph, Seed, State};
use virtualcity::procgen::Apartment;
use virtualcity::render::{RayCaster, Renderer};

/// Depth behind the wall's inner face at which its outer leaf begins, metres.
const INNER: f32 = 0.05;
/// Rays to each side of a hole.
const RAYS: usize = 40;

/// Half the thickness, half the width and the height of the hole for a window.
fn hole(scene: &SceneGraph, window: &Node) -> [f32; 3] {
    let asset = scene.assets().get(window.spec().asset.unwrap()).unwrap();
    let parts = |name| asset.parts.iter().filter(move |p| &*p.name == name).map(Part::extent);
    let (_, frame) = parts("frame").reduce(|a, b| (a.0.inf(&b.0), a.1.sup(&b.1))).unwrap();
    // The ledge extends to the outside of the wall, whose middle is the window's.
    let outside = parts("outer_sill").map(|(low, _)| -low.x).fold(frame.x, f32::max);
    [outside, frame.y, frame.z]
}

/// The number of rays from a room to both sides and the top of a window's hole that end on the outer leaf of
/// the wall.
fn seen_outer(scene: &SceneGraph, caster: &RayCaster, window: NodeId) -> usize {
    let node = scene.node(window).unwrap();
    let ([half, wide, high], pose) = (hole(scene, node), node.pose().unwrap());
    let is_outer = |from: &Point3<f32>, to: &Point3<f32>| {
        let along = pose.rotation * (to - from);
        let hit = caster.first(&(pose * from), &along, 3.0);
        let wall = hit.filter(|hit| **scene.node(hit.node).unwrap().class() == *"wall");
        // Walls beside the window occlude it from some positions.
        wall.is_some_and(|hit| {
            let at = pose.inverse_transform_point(&hit.point);
            at.x < half - INNER - 0.002 && at.y.abs() < wide + 0.01 && at.z < high + 0.01
        })
    };
    let share = |i: usize| (i as f32 + 0.5) / RAYS as f32;
    let depth = |i: usize| half - (half - 0.03) * share(i * 7 % RAYS);
    let sides = [-1.0, 1.0].into_iter().flat_map(|side| {
        let to = move |i: usize| Point3::new(depth(i), side * wide, high * share(i));
        (0..RAYS).map(move |i| (Point3::new(half + 0.4, -0.5 * side * wide, 0.5 * high), to(i)))
    });
    let top = (0..RAYS).map(|i| {
        let to = Point3::new(depth(i), wide * (2.0 * share(i) - 1.0), high);
        (Point3::new(half + 0.4, 0.0, 0.3 * high), to)
    });
    sides.chain(top).filter(|(from, to)| is_outer(from, to)).count()
}

#[test]
fn no_outer_wall_is_seen_between_a_window_and_its_room() {
    let mut windows = 0;
    for seed in [3, 7, 12, 15, 42] {
        let scene = Apartment::from_seed(Seed(seed)).unwrap().scene();
        let caster = RayCaster::new(&Renderer::new().snapshot(&scene).unwrap());
        for window in scene.of_class("window") {
            let seen = seen_outer(&scene, &caster, window);
            assert_eq!(seen, 0, "seed {seed}: the outer wall is seen at {window}");
            windows += 1;
        }
    }
    assert!(windows > 20, "{windows} windows");
}

/// Level rays from a room through the window's hole, half a millimetre apart across the edges of its sashes, that end
/// beyond the wall.
fn passing(scene: &SceneGraph, caster: &RayCaster, window: NodeId) -> usize {
    let node = scene.node(window).unwrap();
    let ([half, wide, high], pose) = (hole(scene, node), node.pose().unwrap());
    let passes = |(y, z): (f32, f32)| {
        let from = pose * Point3::new(half + 0.3, y, z);
        let hit = caster.first(&from, &(pose.rotation * -nalgebra::Vector3::x()), 5.0);
        hit.is_none_or(|hit| pose.inverse_transform_point(&hit.point).x < -half - 0.01)
    };
    let steps = (0..200).map(|i| 0.0005 * (i as f32 + 0.5));
    let across = steps.flat_map(|off| {
        let upright = [wide - off, off - wide, off, -off].map(|y| (y, 0.4 * high));
        let level = [off, high - off].map(|z| (0.3 * wide, z));
        upright.into_iter().chain(level)
    });
    across.filter(|at| passes(*at)).count()
}

#[test]
fn no_light_passes_between_a_sash_and_its_frame() {
    let mut windows = 0;
    for seed in [3, 42] {
        let scene = Apartment::from_seed(Seed(seed)).unwrap().scene();
        let caster = RayCaster::new(&Renderer::new().snapshot(&scene).unwrap());
        let shut = |id: &&NodeId| !scene.node(**id).unwrap().is(State::Open);
        for window in scene.of_class("window").iter().filter(shut) {
            assert_eq!(passing(&scene, &caster, *window), 0, "seed {seed}: {window} has a slit");
            windows += 1;
        }
    }
    assert!(windows > 5, "{windows} windows");
}
