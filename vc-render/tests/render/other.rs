//! Things that do not belong together, and numbers that are not finite, are refused.

#![allow(clippy::unwrap_used)]

use crate::common;

use common::{Stage, block, cameras, crowded, furnished, material, pose};
use nalgebra::{Isometry3, Quaternion, Translation3, Unit, Vector3};
use vc_graph::{Draft, NodeId, Pose, SceneBuilder, State};
use vc_render::{Daylight, Frame, Modalities, Modality, PathTracing, RayCaster, RenderError, Renderer, Shot, Snapshot};

/// The thing named in an error about another scene.
fn other<T>(result: Result<T, RenderError>) -> &'static str {
    match result {
        Err(RenderError::OtherScene { what, here, there }) if here != there => what,
        Err(e) => panic!("another complaint: {e}"),
        Ok(_) => panic!("no complaint"),
    }
}

#[test]
fn light_and_moments_of_another_scene_are_refused() {
    let mut renderer = Renderer::new();
    let [small, large] = [5, 60].map(|count| renderer.snapshot(&crowded(count)).unwrap());
    let day = Daylight::noon();
    let camera = cameras(48, 36)[0];
    let mut frame = Frame::new();
    for (one, two) in [(&small, &large), (&large, &small)] {
        let light = renderer.light(two, &day);
        let colours = Shot::new(one, &camera, Modality::Rgb).lit(&light);
        assert_eq!(other(renderer.render(&colours, &mut frame)), "light");
        assert_eq!(other(renderer.render(&colours.supersampled(2), &mut frame)), "light");
        // Light that is not requested does not matter.
        renderer.render(&Shot::new(one, &camera, Modality::Depth).lit(&light), &mut frame).unwrap();
        let flow = Modality::FlowForward | Modality::FlowBackward | Modality::Occlusion;
        let shot = Shot::new(one, &camera, flow);
        assert_eq!(other(renderer.render(&shot.after(two, &camera).before(one, &camera), &mut frame)), "next moment");
        assert_eq!(other(renderer.render(&shot.after(one, &camera).before(two, &camera), &mut frame)), "moment before");
        renderer.render(&shot.after(one, &camera).before(one, &camera), &mut frame).unwrap();
        let mut lighting = renderer.light(one, &day);
        assert_eq!(other(renderer.relight(&mut lighting, two)), "snapshot to follow");
        assert_eq!(other(RayCaster::new(one).follow(two)), "snapshot to follow");
        assert_eq!(other(lighting.follow(two)), "snapshot to follow");
    }
}

#[test]
fn snapshots_of_the_same_scene_made_one_after_the_other_go_together() {
    // With assets, and with nodes of which only the box is known.
    let mut boxes = SceneBuilder::new("boxes");
    let room = boxes.add(Draft::new("kitchen")).unwrap();
    let size = vc_graph::Bounds::standing(Vector3::new(0.6, 0.6, 1.8));
    boxes.add_in(room, Draft::new("fridge").at(Pose::translation(2.0, 0.0, 0.0)).bounds(size)).unwrap();
    for scene in [boxes.build(), crowded(3)] {
        let mut renderer = Renderer::new();
        let [one, two] = [(); 2].map(|()| renderer.snapshot(&scene).unwrap());
        let mut light = renderer.light(&one, &Daylight::noon());
        let camera = cameras(32, 24)[0];
        let shot = Shot::new(&two, &camera, Modalities::SIX).lit(&light).after(&one, &camera);
        renderer.render(&shot, &mut Frame::new()).unwrap();
        renderer.relight(&mut light, &two).unwrap();
    }
}

/// A snapshot with that many materials, and its renderer.
fn many(materials: usize) -> (Renderer, Snapshot) {
    let mut stage = Stage::new();
    for i in 0..materials {
        let share = i as f32 / materials as f32;
        let number = stage.library.add_material(material("plain", [share, 0.3, 0.2])).unwrap();
        stage.one("box", block([0.1; 3]), pose([0.3 * i as f32, 0.0, 1.0], 0.0, 0.0), number);
    }
    let mut renderer = Renderer::new();
    let snapshot = renderer.snapshot(&stage.build()).unwrap();
    (renderer, snapshot)
}

#[test]
fn what_another_renderer_made_is_refused() {
    let ((few, _), (lots, snapshot)) = (many(1), many(40));
    let camera = cameras(32, 24)[2];
    let mut frame = Frame::new();
    let light = lots.light(&snapshot, &Daylight::noon());
    let shot = Shot::new(&snapshot, &camera, Modalities::SIX.without(Modality::FlowForward)).lit(&light);
    lots.render(&shot, &mut frame).unwrap();
    assert_eq!(few.render(&shot, &mut frame), Err(RenderError::OtherRenderer("snapshot")));
    let strange = few.light(&snapshot, &Daylight::noon());
    assert_eq!(lots.render(&shot.lit(&strange), &mut frame), Err(RenderError::OtherRenderer("light")));
    let how = PathTracing { samples: 1, ..PathTracing::default() };
    assert!(lots.reference_picture(&light, &camera, &how, |_| true).is_ok());
    let refused = few.reference_picture(&light, &camera, &how, |_| true);
    assert_eq!(refused, Err(RenderError::OtherRenderer("light")));
    assert_eq!(few.relight(&mut light.clone(), &snapshot), Err(RenderError::OtherRenderer("light")));
}

#[test]
fn daylight_that_cannot_be_is_refused() {
    let mut renderer = Renderer::new();
    let snapshot = renderer.snapshot(&crowded(3)).unwrap();
    let camera = cameras(32, 24)[0];
    let noon = Daylight::noon();
    let mut frame = Frame::new();
    let mut days = vec![Daylight::clear(f32::NAN, 0.0), Daylight::clear(0.3, f32::INFINITY)];
    for v in [f32::NAN, f32::INFINITY, -1.0, 1e30] {
        let v = Vector3::new(1.0, v, 1.0);
        days.extend([
            Daylight { sun: v, ..noon },
            Daylight { zenith: v, ..noon },
            Daylight { horizon: v, ..noon },
            Daylight { ground: v, ..noon },
            Daylight { towards_sun: v, ..noon },
        ]);
    }
    days.push(Daylight { towards_sun: Vector3::zeros(), ..noon });
    for day in days {
        let mut light = renderer.light(&snapshot, &day);
        assert!(light.sources().iter().all(|s| !format!("{s:?}").contains("NaN")), "{day:?}");
        let bad = |result: Result<(), RenderError>| matches!(result, Err(RenderError::BadDaylight(_)));
        let shot = Shot::new(&snapshot, &camera, Modality::Rgb).lit(&light);
        assert!(bad(renderer.render(&shot, &mut frame)), "{day:?}");
        assert!(
            bad(renderer.reference_picture(&light, &camera, &PathTracing::default(), |_| false).map(|_| ())),
            "{day:?}"
        );
        assert!(bad(renderer.relight(&mut light, &snapshot)), "{day:?}");
    }
}

#[test]
fn poses_that_cannot_be_are_refused_and_change_nothing() {
    let scene = furnished();
    let mut renderer = Renderer::new();
    let mut snapshot = renderer.snapshot(&scene).unwrap();
    let ball = scene.of_class("ball")[0];
    let dresser = scene.nodes().find(|n| n.is(State::Open)).unwrap().id();
    let camera = cameras(64, 48)[0];
    let picture = |renderer: &Renderer, snapshot: &Snapshot| {
        let mut frame = Frame::new();
        let wanted = Modality::Depth | Modality::Instance | Modality::Boxes | Modality::Amodal;
        renderer.render(&Shot::new(snapshot, &camera, wanted), &mut frame).unwrap();
        (frame.depth, frame.instance, frame.boxes)
    };
    let before = picture(&renderer, &snapshot);
    for value in [f32::NAN, f32::INFINITY, 1e30] {
        let turned = Unit::new_unchecked(Quaternion::new(1.0, value, 0.0, 0.0));
        let poses = [Pose::translation(0.0, value, 0.0), Isometry3::from_parts(Translation3::identity(), turned)];
        for bad in poses {
            assert_eq!(snapshot.place(ball, &bad), Err(RenderError::BadPose(ball)), "{bad}");
            assert_eq!(snapshot.arrange(dresser, |_| Some(bad)), Err(RenderError::BadPose(dresser)), "{bad}");
        }
        assert_eq!(snapshot.articulate(dresser, |_| Some(value)), Err(RenderError::BadPose(dresser)), "{value}");
    }
    assert_eq!(snapshot.place(NodeId(9999), &Pose::identity()), Err(RenderError::NoBody(NodeId(9999))));
    assert!(picture(&renderer, &snapshot) == before);
    // If a joint's position is not finite when the snapshot is taken, the node's state decides.
    let again = renderer.snapshot_with(&scene, |_, _| Some(f32::NAN)).unwrap();
    assert!(picture(&renderer, &again) == before);
}

#[test]
fn scenes_with_things_that_are_nowhere_are_refused() {
    let scene = |x: f32, scale: f32| {
        let mut stage = Stage::new();
        let asset = stage.asset(vec![common::part("box", block([0.1; 3]), [0.0; 3], 0)]);
        let mut draft = Draft::new("box").at(Pose::translation(x, 0.0, 0.0));
        (draft.asset, draft.scale) = (Some(asset), Some(Vector3::new(1.0, scale, 1.0)));
        let node = stage.builder.add_in(stage.room, draft).unwrap();
        (stage.build(), node)
    };
    let mut renderer = Renderer::new();
    for (x, scale) in [(1e30, 1.0), (-1e30, 1.0), (2.0, f32::NAN), (2.0, f32::INFINITY), (2.0, 1e30)] {
        let (graph, node) = scene(x, scale);
        let refused = renderer.snapshot(&graph).map(|_| ());
        assert_eq!(refused, Err(RenderError::BadPose(node)), "at {x}, scaled by {scale}");
    }
    // Flat things are not visible, and the renderer still works.
    let camera = vc_render::Camera::with_fov(32, 24, 1.0);
    let mut frame = Frame::new();
    for (scale, seen) in [(0.0, false), (1.0, true)] {
        let snapshot = renderer.snapshot(&scene(2.0, scale).0).unwrap();
        renderer.render(&Shot::new(&snapshot, &camera, Modality::Depth), &mut frame).unwrap();
        assert_eq!(frame.depth.iter().any(|d| d.is_finite()), seen, "scaled by {scale}");
    }
}
