//! Amodal boxes and masks of things that reach behind the eye, compared with a slow computation.

#![allow(clippy::unwrap_used)]

use crate::common;

use common::caster::Caster;
use common::{Stage, block, cameras, furnished, pose};
use nalgebra::Point3;
use vc_graph::asset::Shape;
use vc_graph::{NodeId, SceneGraph};
use vc_render::{Camera, Frame, Modality, PixelBox, Renderer, Shot};

/// A long table in front of the eye and behind it, a mat on it, a tall box in front, and a ring around the eye.
fn long() -> (SceneGraph, Vec<Camera>) {
    let mut stage = Stage::new();
    stage.one("table", block([4.0, 0.5, 0.02]), pose([0.5, 0.1, 0.7], 0.2, 0.03), 0);
    stage.one("mat", Shape::Cylinder { radius: 0.6, half_height: 0.01 }, pose([0.2, 0.0, 0.75], 0.0, 0.0), 1);
    stage.one("box", block([0.2, 0.3, 0.5]), pose([1.5, 0.2, 1.2], 0.4, 0.0), 1);
    let profile = vec![(1.2, 0.0), (1.3, 0.0), (1.3, 0.4), (1.2, 0.4)];
    stage.one("ring", Shape::Lathe { profile }, pose([0.0, 0.0, 1.0], 0.0, 0.0), 0);
    stage.one("ball", Shape::Sphere { radius: 0.4 }, pose([0.0, 0.35, 1.25], 0.0, 0.0), 1);
    let look = |eye: [f32; 3], at: [f32; 3], near: f32| {
        Camera { near, ..Camera::with_fov(120, 90, 1.2) }.looking(Point3::from(eye), Point3::from(at))
    };
    let cameras = vec![
        look([0.0, 0.0, 1.3], [2.0, 0.3, 0.8], 0.01),
        look([0.0, 0.0, 1.3], [0.3, 0.2, 0.7], 0.01),
        look([-0.2, -0.1, 1.0], [2.0, 0.5, 0.75], 0.1),
        look([0.3, 0.1, 0.9], [0.3, 1.0, 0.9], 0.2),
        look([0.1, -0.9, 1.1], [0.3, 1.0, 0.7], 0.4),
    ];
    (stage.build(), cameras)
}

/// Bounds of the front-facing triangles of a node, clipped at the near plane, in pixels without rounding.
fn slow(caster: &Caster, camera: &Camera, node: NodeId) -> Option<[[f64; 2]; 2]> {
    let back = camera.pose.cast::<f64>().inverse();
    let near = f64::from(camera.near);
    let mut ends: Option<[[f64; 2]; 2]> = None;
    for corners in caster.of(node) {
        let own = corners.map(|p| back * p);
        if (own[1] - own[0]).cross(&(own[2] - own[0])).dot(&own[0].coords) >= 0.0 {
            continue;
        }
        // Corners beyond the near plane count, and intersections of edges with it.
        for i in 0..3 {
            let (a, b) = (own[i], own[(i + 1) % 3]);
            let cut = if (a.z < near) == (b.z < near) { 0.0 } else { (near - a.z) / (b.z - a.z) };
            for share in [0.0, cut, 1.0] {
                let p = a + (b - a) * share;
                if p.z < near - 1e-9 {
                    continue;
                }
                let f = |focal: f32, centre: f32, v: f64| f64::from(focal) * v / p.z + f64::from(centre);
                let at = [f(camera.focal.0, camera.centre.0, p.x), f(camera.focal.1, camera.centre.1, p.y)];
                let [low, high] = ends.get_or_insert([at; 2]);
                for k in 0..2 {
                    (low[k], high[k]) = (low[k].min(at[k]), high[k].max(at[k]));
                }
            }
        }
    }
    ends
}

/// Checks that a box covers the pixels whose centres lie between two points, up to a pixel and a thousandth.
fn assert_around(found: PixelBox, [low, high]: [[f64; 2]; 2], what: &str) {
    let own = [[found.x, found.x + found.width], [found.y, found.y + found.height]];
    for axis in 0..2 {
        for (own, wanted) in own[axis].into_iter().zip([low[axis], high[axis]]) {
            let wanted = wanted.clamp(-1e9, 1e9);
            assert!(
                (f64::from(own) - wanted).abs() < 1.0 + 1e-3 * wanted.abs(),
                "{what}: {found:?}, not {low:?} to {high:?}"
            );
        }
    }
}

fn check(graph: &SceneGraph, cameras: &[Camera]) -> usize {
    let caster = Caster::new(graph, 0.0005);
    let mut renderer = Renderer::new().with_detail(0.0);
    let snapshot = renderer.snapshot(graph).unwrap();
    let (mut frame, mut behind) = (Frame::new(), 0);
    for (number, camera) in cameras.iter().enumerate() {
        renderer.render(&Shot::new(&snapshot, camera, Modality::Boxes | Modality::Amodal), &mut frame).unwrap();
        let (width, height) = (camera.width as i32, camera.height as i32);
        for (label, mask) in frame.boxes.iter().zip(frame.amodal_masks()) {
            let what = format!("{} from camera {number}", label.node);
            let back = camera.pose.cast::<f64>().inverse();
            behind +=
                usize::from(caster.of(label.node).any(|t| t.iter().any(|p| (back * p).z < f64::from(camera.near))));
            assert_around(label.amodal, slow(&caster, camera, label.node).unwrap(), &what);
            let alone = caster.only(label.node);
            let wrong = (0..width * height).filter(|i| {
                let hit = alone.cast(camera, f64::from(i % width) + 0.5, f64::from(i / width) + 0.5);
                hit.is_some() != mask.has(i % width, i / width)
            });
            assert!(wrong.count() <= 3, "{what}");
        }
    }
    behind
}

#[test]
fn what_reaches_behind_the_eye_is_cut_at_the_near_plane() {
    let (graph, cameras) = long();
    assert!(check(&graph, &cameras) >= 8, "few things reach behind the eye");
}

#[test]
fn what_is_in_front_is_as_it_was() {
    check(&furnished(), &cameras(80, 60)[..2]);
}
