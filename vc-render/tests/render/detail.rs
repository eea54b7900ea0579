//! Levels of detail: meshes are coarser far away, within the promised error; and many nodes share a mesh.

#![allow(clippy::unwrap_used)]

use crate::common;

use common::{Stage, crowded, material, pose};
use nalgebra::Point3;
use vc_graph::asset::{Material, Shape};
use vc_graph::{NodeId, Pose, SceneGraph};
use vc_render::{Camera, Daylight, Frame, Modality, NOTHING, Renderer, Shot};

const SIZE: (usize, usize) = (240, 180);

/// Ids, parts, depth and normals of a scene.
fn seen(graph: &SceneGraph, camera: &Camera, detail: Option<f32>) -> Frame {
    let mut renderer = detail.map_or_else(Renderer::new, |d| Renderer::new().with_detail(d));
    let snapshot = renderer.snapshot(graph).unwrap();
    let wanted = Modality::Instance | Modality::Part | Modality::Class | Modality::Depth | Modality::Normal;
    let mut frame = Frame::new();
    renderer.render(&Shot::new(&snapshot, camera, wanted), &mut frame).unwrap();
    frame
}

/// Shapes with curves at several distances, seen from the origin along X.
fn row(made: impl Fn(Shape) -> Shape) -> (SceneGraph, Vec<NodeId>) {
    let mut stage = Stage::new();
    let shapes = |r: f32| {
        [
            Shape::Sphere { radius: r },
            Shape::Cylinder { radius: r * 0.6, half_height: r },
            Shape::Lathe { profile: vec![(r, 0.0), (r, r), (r * 0.9, r), (r * 0.9, r * 0.1)] },
            Shape::Capsule { radius: r * 0.5, half_height: r },
        ]
    };
    let mut nodes = Vec::new();
    for (ring, x) in [0.5, 1.0, 2.0, 4.0, 8.0, 16.0].into_iter().enumerate() {
        for (i, shape) in shapes(0.12 * x).into_iter().enumerate() {
            let at = [x, (0.55 - 0.4 * i as f32 + 0.03 * ring as f32) * x, (0.4 - 0.16 * ring as f32) * x];
            nodes.push(stage.one("ball", made(shape), pose(at, 0.4 * i as f32, 0.7), 0));
        }
    }
    (stage.build(), nodes)
}

fn ahead() -> Camera {
    Camera::with_fov(SIZE.0 as u32, SIZE.1 as u32, 1.1).looking(Point3::origin(), Point3::new(1.0, 0.0, 0.0))
}

/// The pixel and its neighbours.
fn around(index: usize) -> impl Iterator<Item = usize> {
    let (x, y) = (index % SIZE.0, index / SIZE.0);
    let near = |at: usize, count: usize| at.saturating_sub(1)..(at + 2).min(count);
    near(y, SIZE.1).flat_map(move |y| near(x, SIZE.0).map(move |x| y * SIZE.0 + x))
}

#[test]
fn at_detail_zero_the_finest_mesh_is_drawn_whatever_its_distance() {
    let as_mesh = |shape: Shape| {
        let mesh = shape.mesh(0.0005);
        Shape::Mesh { vertices: mesh.positions, triangles: mesh.triangles, uvs: Vec::new() }
    };
    let ((curved, nodes), (cut, others)) = (row(|shape| shape), row(as_mesh));
    assert_eq!(nodes, others);
    let [a, b] = [&curved, &cut].map(|graph| seen(graph, &ahead(), Some(0.0)));
    assert!(nodes.iter().all(|node| a.instance.contains(node)), "all are seen");
    assert!(a.instance == b.instance && a.depth == b.depth, "the same triangles");
}

#[test]
fn outlines_are_off_by_less_than_a_pixel_and_ids_stay_what_they_are() {
    for (graph, camera) in [(row(|shape| shape).0, ahead()), (crowded(120), far())] {
        let (fine, usual) = (seen(&graph, &camera, Some(0.0)), seen(&graph, &camera, None));
        let (mut other, mut strays) = (0, 0);
        for i in 0..fine.instance.len() {
            if fine.instance[i] != usual.instance[i] {
                other += 1;
                let near = |frame: &Frame, id: NodeId| around(i).any(|k| frame.instance[k] == id);
                strays += usize::from(!near(&fine, usual.instance[i]) || !near(&usual, fine.instance[i]));
            } else if fine.instance[i] != NOTHING {
                assert_eq!(fine.class[i], usual.class[i]);
                // At outlines curves turn away from the eye.
                if !around(i).all(|k| fine.instance[k] == fine.instance[i] && fine.part[k] == fine.part[i]) {
                    continue;
                }
                let own = around(i).map(|k| fine.depth[k]);
                let [least, most] = own.fold([f32::INFINITY, 0.0], |[a, b], d| [d.min(a), d.max(b)]);
                let (slack, depth) = (0.25 * most / camera.focal.1, usual.depth[i]);
                assert!((least - slack..=most + slack).contains(&depth), "pixel {i}: {depth}, not {least} to {most}");
            }
        }
        let pixels = fine.instance.len();
        eprintln!("{other} of {pixels} ids differ, {strays} of them not at an outline");
        // A piece of a thing smaller than a pixel may be hit in only one of the two pictures.
        assert!(strays <= 2, "{strays} ids differ that are not at an outline");
        assert!(other * 200 < pixels, "{other} of {pixels} ids differ");
    }
}

/// A view from outside of the room, through its open side, in which the crowd is small.
fn far() -> Camera {
    Camera { near: 9.0, ..Camera::with_fov(SIZE.0 as u32, SIZE.1 as u32, 0.4) }
        .looking(Point3::new(-12.0, 0.0, 1.5), Point3::new(0.0, 0.0, 1.2))
}

#[test]
fn coarser_meshes_are_drawn_far_away_and_the_finest_close_up() {
    let (graph, nodes) = row(|shape| shape);
    let fine = seen(&graph, &ahead(), Some(0.0));
    let count = |frame: &Frame, node: NodeId| {
        let own = (0..frame.depth.len()).filter(|i| frame.instance[*i] == node && fine.instance[*i] == node);
        own.filter(|i| frame.depth[*i] != fine.depth[*i]).count()
    };
    // At the second level a curve is up to a millimetre off its chords: with a tolerance of a tenth of a pixel,
    // that level starts at a metre and a half here.
    let usual = seen(&graph, &ahead(), Some(0.1));
    let other: Vec<usize> = nodes.chunks(4).map(|ring| ring.iter().map(|n| count(&usual, *n)).sum()).collect();
    assert!(other[0] == 0 && other[1] == 0, "{other:?} pixels of each ring differ");
    assert!(other[4] > 100 && other[5] > 100, "{other:?} pixels of each ring differ");
    // The greater the tolerance, the coarser the mesh.
    let off = |detail: f32| {
        let frame = seen(&graph, &ahead(), Some(detail));
        let same = (0..frame.depth.len()).filter(|i| frame.instance[*i] == fine.instance[*i] && fine.depth[*i] < 1e9);
        same.map(|i| f64::from((frame.depth[i] / fine.depth[i] - 1.0).abs())).sum::<f64>()
    };
    let errors = [0.0, 0.1, 0.5, 4.0].map(off);
    assert!(errors[0] == 0.0 && errors.is_sorted() && errors[3] > 2.0 * errors[1], "{errors:?}");
}

#[test]
fn a_detail_that_cannot_be_draws_the_finest_mesh() {
    let graph = row(|shape| shape).0;
    let fine = seen(&graph, &ahead(), Some(0.0));
    for detail in [f32::NAN, -1.0, f32::NEG_INFINITY] {
        let own = seen(&graph, &ahead(), Some(detail));
        assert!(own.instance == fine.instance && own.depth == fine.depth && own.normal == fine.normal, "{detail}");
    }
    // With an infinite tolerance the coarsest mesh is drawn, which is still visible.
    let coarse = seen(&graph, &ahead(), Some(f32::INFINITY));
    let count = |frame: &Frame| frame.instance.iter().filter(|n| **n != NOTHING).count();
    assert!(coarse.depth != fine.depth && 10 * count(&coarse) > 8 * count(&fine));
}

/// Balls and cups in a row, with an asset each or two assets for all; and a floor, for their shadows.
fn twins(count: usize, shared: bool) -> SceneGraph {
    let mut stage = Stage::new();
    stage.one("floor", common::block([3.0, 3.0, 0.05]), Pose::translation(2.0, 0.0, -0.6), 1);
    let red = Material { roughness: 0.3, ..material("red_plastic", [0.6, 0.1, 0.1]) };
    let red = stage.library.add_material(red).unwrap();
    let shapes = [Shape::Sphere { radius: 0.1 }, Shape::Lathe { profile: vec![(0.1, 0.0), (0.12, 0.2), (0.1, 0.02)] }];
    let part = |i: usize| common::part("body", shapes[i % 2].clone(), [0.0; 3], red);
    let own: Vec<_> = (0..2).map(|i| stage.asset(vec![part(i)])).collect();
    for i in 0..count {
        let asset = if shared { own[i % 2] } else { stage.asset(vec![part(i)]) };
        let at = [1.6 + 0.3 * (i / 8) as f32, -0.9 + 0.25 * (i % 8) as f32, -0.3];
        stage.put("ball", asset, pose(at, i as f32, 0.3 * i as f32));
    }
    stage.build()
}

#[test]
fn nodes_that_share_an_asset_share_its_mesh() {
    let size = |count: usize, shared: bool| {
        let mut renderer = Renderer::new();
        renderer.snapshot(&twins(count, shared)).unwrap();
        renderer.size()
    };
    assert_eq!(size(2, true), size(200, true));
    assert!(size(200, false).0 > 50 * size(200, true).0);
}

#[test]
fn pictures_are_the_same_whether_meshes_are_shared_or_not() {
    let of = |shared: bool| {
        let mut renderer = Renderer::new();
        let snapshot = renderer.snapshot(&twins(24, shared)).unwrap();
        let lighting = renderer.light(&snapshot, &Daylight::noon());
        let mut frame = Frame::new();
        let wanted = vc_render::Modalities::SIX | Modality::Normal | Modality::Part;
        let camera = ahead();
        renderer
            .render(&Shot::new(&snapshot, &camera, wanted).lit(&lighting).after(&snapshot, &camera), &mut frame)
            .unwrap();
        frame
    };
    let (a, b) = (of(true), of(false));
    // Empty pixels are NaN, so bits are compared.
    let flow = |frame: &Frame| frame.flow_forward.as_flattened().iter().map(|v| v.to_bits()).collect::<Vec<u32>>();
    assert!(a.instance.iter().filter(|id| **id != NOTHING).count() > 3000);
    assert!(a.instance == b.instance && a.class == b.class && a.part == b.part && a.depth == b.depth);
    assert!(a.normal == b.normal && a.rgb == b.rgb && flow(&a) == flow(&b) && a.boxes == b.boxes);
}
