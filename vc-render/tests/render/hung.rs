//! Drawn blinds and curtains keep their heads, and clear window sills and the things that stand below.

#![allow(clippy::unwrap_used)]

use crate::common;

use common::{Stage, block, part, pose};
use nalgebra::{Point3, Vector3};
use vc_graph::asset::{Part, Shape};
use vc_graph::{NodeId, Pose};
use vc_render::{RayCaster, RayHit, Renderer, Snapshot};

/// The sill's front edge, which stands out into the room from x = 2, and the height of its upper side.
const SILL: [f32; 2] = [1.9, 0.92];

/// A window from z = 0.9 to 2.1 in a wall whose face is at x = 2, with a sill, and its covers.
fn hung(parts: Vec<Part>, places: &[[f32; 3]]) -> (Snapshot, NodeId, Vec<NodeId>) {
    hung_on(Stage::new(), parts, places)
}

fn hung_on(mut stage: Stage, parts: Vec<Part>, places: &[[f32; 3]]) -> (Snapshot, NodeId, Vec<NodeId>) {
    let window = vec![
        part("pane", block([0.003, 0.5, 0.6]), [0.0, 0.0, 0.6], 2),
        part("sill", block([0.1, 0.5, 0.01]), [-0.1, 0.0, 0.01], 0),
    ];
    let window = stage.asset(window);
    let window = stage.put("window", window, Pose::translation(2.1, 0.0, 0.9));
    let cover = stage.asset(parts);
    let class = if places.len() > 1 { "curtain" } else { "blinds" };
    // The covers face into the room.
    let covers = places.iter().map(|at| stage.put(class, cover, pose(*at, std::f32::consts::PI, 0.0))).collect();
    (Renderer::new().snapshot(&stage.build()).unwrap(), window, covers)
}

fn blinds() -> (Snapshot, NodeId, NodeId) {
    let roller = Shape::Cylinder { radius: 0.02, half_height: 0.5 };
    let mut roller = part("roller", roller, [0.0, 0.0, 0.278], 1);
    roller.pose.rotation = nalgebra::UnitQuaternion::from_axis_angle(&Vector3::x_axis(), std::f32::consts::FRAC_PI_2);
    let parts = vec![roller, part("cloth", block([0.002, 0.5, 0.14]), [0.017, 0.0, 0.14], 1)];
    let (mut snapshot, window, covers) = hung(parts, &[[1.95, 0.0, 1.85]]);
    snapshot.draw_cover(covers[0], true).unwrap();
    (snapshot, window, covers[0])
}

fn straight(snapshot: &Snapshot, from: [f32; 3], along: [f32; 3]) -> Option<RayHit> {
    RayCaster::new(snapshot).first(&Point3::from(from), &Vector3::from(along), 5.0)
}

#[test]
fn a_blind_comes_down_from_its_roller() {
    let (snapshot, window, blinds) = blinds();
    let at = |z: f32| straight(&snapshot, [0.0, 0.1, z], [1.0, 0.0, 0.0]);
    let seen = |z: f32| at(z).map(|hit| (hit.node, hit.part));
    assert_eq!(seen(2.16), None);
    for z in [2.11, 2.13, 2.145] {
        let hit = at(z).unwrap();
        assert!(hit.node == blinds && hit.point.x < 1.96, "nothing but the roller and its cloth at {z}: {hit:?}");
    }
    for z in [2.09, 1.8, 1.4, SILL[1] + 0.02] {
        assert_eq!(seen(z), Some((blinds, 1)), "cloth at {z}");
    }
    assert_eq!(seen(SILL[1] - 0.01), Some((window, 1)));
    // Seen from below, the roller is as thick as before.
    let below = straight(&snapshot, [1.96, 0.1, 0.95], [0.0, 0.0, 1.0]).unwrap();
    assert!(below.part == 0 && (below.point.z - 2.108).abs() < 0.01, "{below:?}");
}

#[test]
fn a_lowered_blind_ends_on_the_sill() {
    let (snapshot, window, blinds) = blinds();
    let below = straight(&snapshot, [1.933, 0.1, 0.1], [0.0, 0.0, 1.0]).unwrap();
    assert_eq!(below.node, window);
    let above = straight(&snapshot, [1.933, 0.1, SILL[1] + 0.001], [0.0, 0.0, 1.0]).unwrap();
    assert!(above.node == blinds && above.distance < 0.01, "{above:?}");
}

#[test]
fn curtains_are_drawn_before_the_sill() {
    for bottom in [0.02_f32, 0.7] {
        let high = 0.5 * (2.2 - bottom);
        let parts = vec![part("cloth", block([0.04, 0.14, high]), [0.0, 0.0, high], 1)];
        let places = [-1.0, 1.0].map(|side| [1.94, 0.66 * side, bottom]);
        let (mut snapshot, window, curtains) = hung(parts, &places);
        curtains.iter().for_each(|curtain| snapshot.draw_cover(*curtain, true).unwrap());
        for y in [-0.45, -0.2, 0.1, 0.3, 0.48] {
            let before = straight(&snapshot, [0.0, y, SILL[1] - 0.01], [1.0, 0.0, 0.0]).unwrap();
            assert!(curtains.contains(&before.node) && before.point.x < SILL[0], "{before:?}");
            // Rays up through the sill hit no cloth.
            for x in [SILL[0] + 0.002, 1.95, 1.98] {
                let below = straight(&snapshot, [x, y, 0.01], [0.0, 0.0, 1.0]).unwrap();
                assert_eq!((below.node, below.part), (window, 1), "at {x}, {y}");
            }
        }
    }
}

#[test]
fn curtains_that_end_above_the_sill_hang_straight() {
    let parts = vec![part("cloth", block([0.04, 0.14, 0.6]), [0.0, 0.0, 0.6], 1)];
    let places = [-1.0, 1.0].map(|side| [1.94, 0.66 * side, 1.0]);
    let (mut snapshot, _, curtains) = hung(parts, &places);
    let at = |snapshot: &Snapshot, y: f32| straight(snapshot, [0.0, y, 1.5], [1.0, 0.0, 0.0]).unwrap();
    let open = at(&snapshot, 0.6);
    curtains.iter().for_each(|curtain| snapshot.draw_cover(*curtain, true).unwrap());
    let closed = at(&snapshot, 0.1);
    assert!(curtains.contains(&closed.node) && (closed.point.x - open.point.x).abs() < 1e-4);
}

/// A pair of drawn curtains that reach down to the floor, and a thing of a given height below the window whose
/// front is at a given distance from the wall.
fn before(high: f32, front: f32) -> (Snapshot, NodeId, Vec<NodeId>) {
    let mut stage = Stage::new();
    let half = [0.5 * (front - 0.02), 0.45, 0.5 * high];
    let at = Pose::translation(2.0 - 0.02 - half[0], 0.0, half[2]);
    let thing = stage.one("radiator", block(half), at, 0);
    let parts = vec![part("cloth", block([0.04, 0.14, 1.1]), [0.0, 0.0, 1.1], 1)];
    let places = [-1.0, 1.0].map(|side| [1.94, 0.66 * side, 0.02]);
    let (mut snapshot, _, curtains) = hung_on(stage, parts, &places);
    curtains.iter().for_each(|curtain| snapshot.draw_cover(*curtain, true).unwrap());
    (snapshot, thing, curtains)
}

#[test]
fn curtains_are_drawn_before_a_radiator() {
    let (snapshot, radiator, curtains) = before(0.6, 0.13);
    for y in [-0.4, -0.1, 0.2, 0.44] {
        let before = straight(&snapshot, [0.0, y, 0.3], [1.0, 0.0, 0.0]).unwrap();
        assert!(curtains.contains(&before.node) && before.point.x < 1.87, "{before:?}");
        let behind = straight(&snapshot, [1.868, y, 0.3], [1.0, 0.0, 0.0]).unwrap();
        assert!(behind.node == radiator && (behind.point.x - 1.87).abs() < 1e-4, "{behind:?}");
        // The curtains still reach down to the floor.
        assert!(straight(&snapshot, [0.0, y, 0.03], [1.0, 0.0, 0.0]).is_some_and(|hit| curtains.contains(&hit.node)));
    }
}

#[test]
fn curtains_end_above_a_desk() {
    let (snapshot, desk, curtains) = before(0.74, 0.7);
    for y in [-0.4, -0.1, 0.2, 0.44] {
        let down = straight(&snapshot, [1.94, y, 0.76], [0.0, 0.0, -1.0]).unwrap();
        assert!(down.node == desk && (down.point.z - 0.74).abs() < 1e-4, "no cloth within it: {down:?}");
        let above = straight(&snapshot, [0.0, y, 0.76], [1.0, 0.0, 0.0]).unwrap();
        assert!(curtains.contains(&above.node), "{above:?}");
    }
}

#[test]
fn tied_curtains_are_untied_where_they_are_drawn() {
    // Wide above the band, and narrow and to one side below it.
    let parts = vec![
        part("cloth", block([0.04, 0.14, 0.6]), [0.0, 0.0, 1.55], 1),
        part("cloth", block([0.04, 0.04, 0.5]), [0.0, 0.1, 0.5], 1),
        part("tie", block([0.05, 0.05, 0.03]), [0.0, 0.09, 0.97], 0),
    ];
    let places = [-1.0, 1.0].map(|side| [1.94, 0.66 * side, 0.02]);
    let (mut snapshot, _, curtains) = hung(parts, &places);
    let met = |snapshot: &Snapshot, y: f32, z: f32| {
        let hit = straight(snapshot, [0.0, y, z], [1.0, 0.0, 0.0]).unwrap();
        curtains.contains(&hit.node).then_some(hit.part)
    };
    let open = snapshot.clone();
    let window = || (0..64).map(|i| [-0.48 + 0.137 * (i % 8) as f32, 0.95 + 0.14 * (i / 8) as f32]);
    assert!(window().all(|[y, z]| met(&open, y, z).is_none()), "it leaves the window free");
    assert!([-1.0_f32, 1.0].iter().any(|side| met(&open, 0.57 * side, 0.99) == Some(2)), "tied");
    curtains.iter().for_each(|curtain| snapshot.draw_cover(*curtain, true).unwrap());
    for [y, z] in window() {
        assert_eq!(met(&snapshot, y, z), Some(0), "at {y}, {z}");
    }
    assert_ne!(open.triangles(), snapshot.triangles());
    curtains.iter().for_each(|curtain| snapshot.draw_cover(*curtain, false).unwrap());
    assert_eq!(open.triangles(), snapshot.triangles());
    assert!(window().all(|[y, z]| met(&snapshot, y, z).is_none()));
}
