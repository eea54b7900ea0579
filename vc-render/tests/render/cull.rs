//! Things out of view are culled, and do not change the picture.

#![allow(clippy::unwrap_used)]

use crate::common;

use common::{Stage, block, pose};
use nalgebra::{Point3, Vector3};
use vc_graph::asset::Shape;
use vc_graph::{NodeId, Pose, Seed};
use vc_render::{Camera, Frame, Modality, Renderer, Shot};

/// Things in front of the camera; with `others`, also things beside the view, behind the camera and before its
/// near plane, and behind a wall that fills the view.
fn scene(others: bool) -> (Stage, Vec<NodeId>) {
    let mut stage = Stage::new();
    let mut chance = Seed(23).stream();
    for _ in 0..40 {
        let at = [chance.between(2.0, 5.0), chance.between(-1.5, 1.5), chance.between(-1.0, 1.0)];
        let turn = (chance.between(0.0, 6.0), chance.between(0.0, 3.0));
        stage.one("cup", Shape::Cylinder { radius: 0.1, half_height: 0.2 }, pose(at, turn.0, turn.1), 0);
    }
    stage.one("wall", block([0.1, 20.0, 20.0]), Pose::translation(6.0, 0.0, 0.0), 1);
    let mut added = Vec::new();
    for i in 0..if others { 400 } else { 0 } {
        let (x, far) = (chance.between(-8.0, 5.0), chance.between(0.5, 3.0));
        let (side, up) = (chance.between(-1.0, 1.0), if i % 2 == 0 { 1.0 } else { -1.0 });
        let at = match i % 4 {
            // Beyond the wall, behind the eye, beside the view, and above or below it.
            0 => [7.0 + far, 3.0 * side, 2.0 * side * up],
            1 => [-0.5 - far, side, 0.5 * side],
            2 => [x, up * (1.2 * x.max(0.0) + 0.6 + far), side],
            _ => [x, side, up * (1.0 * x.max(0.0) + 0.6 + far)],
        };
        added.push(stage.one("ball", Shape::Sphere { radius: 0.2 }, pose(at, side, far), (i % 2) as u32));
    }
    (stage, added)
}

#[test]
fn labels_are_the_same_with_things_out_of_view() {
    let eye = Point3::origin();
    let base = Camera::with_fov(160, 120, 1.0);
    let views = [base, Camera { near: 1.5, ..base }, Camera { centre: (60.0, 70.0), ..base }];
    let cameras = views.map(|c| c.looking(eye, eye + Vector3::new(1.0, 0.02, -0.01)));
    let wanted = Modality::Instance
        | Modality::Part
        | Modality::Depth
        | Modality::Normal
        | Modality::Position
        | Modality::Boxes
        | Modality::Masks
        | Modality::Amodal;
    for detail in [0.0, 0.25, 2.0] {
        let made = |others: bool| {
            let (stage, added) = scene(others);
            let mut renderer = Renderer::new().with_detail(detail);
            let snapshot = renderer.snapshot(&stage.build()).unwrap();
            let frames = cameras.map(|camera| {
                let mut frame = Frame::new();
                renderer.render(&Shot::new(&snapshot, &camera, wanted), &mut frame).unwrap();
                frame
            });
            (frames, added)
        };
        let ((alone, _), (among, added)) = (made(false), made(true));
        assert_eq!(added.len(), 400);
        for (a, b) in alone.iter().zip(&among) {
            assert!(!b.instance.iter().any(|n| added.contains(n)), "something out of view is seen");
            assert!(a.instance == b.instance && a.part == b.part && a.depth == b.depth);
            assert!(a.normal == b.normal && a.position == b.position);
            // Class numbers depend on the names in the scene.
            let boxes = |f: &Frame| f.boxes.iter().map(|b| (b.node, b.visible, b.amodal, b.area)).collect::<Vec<_>>();
            assert_eq!(boxes(a), boxes(b));
            let masks = |f: &Frame| f.masks().chain(f.amodal_masks()).map(|m| m.rle()).collect::<Vec<_>>();
            assert_eq!(masks(a), masks(b));
            assert!(a.boxes.len() > 15);
        }
    }
}
