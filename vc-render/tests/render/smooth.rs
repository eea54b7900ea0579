//! Edges of colours are smooth without supersampling; labels are not mixed.

#![allow(clippy::unwrap_used)]

use crate::common;

use common::caster::Caster;
use common::{Stage, block, material};
use nalgebra::{Point3, UnitQuaternion, Vector3};
use vc_graph::Pose;
use vc_graph::asset::Material;
use vc_render::picture::{self, Picture};
use vc_render::{Camera, Daylight, Frame, Modality, Renderer, Shot};

/// Supersampling factor along each side of the picture to compare with.
const FINER: usize = 8;
const SIZE: (usize, usize) = (64, 48);

#[test]
fn edges_have_colours_by_how_much_of_a_pixel_they_cover_and_labels_have_one() {
    let mut stage = Stage::new();
    let mut matt = |share: f32| {
        let made = Material { roughness: 1.0, ..material("plain", [share; 3]) };
        stage.library.add_material(made).unwrap()
    };
    let [white, black] = [matt(0.9), matt(0.01)];
    let wall = stage.one("wall", block([0.1, 5.0, 5.0]), Pose::translation(3.1, 0.0, 0.0), black);
    let turn = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), 0.3);
    let board = Pose::from_parts(Vector3::new(2.0, 0.03, 0.02).into(), turn);
    let bright = stage.one("board", block([0.02, 0.5, 0.35]), board, white);
    let graph = stage.build();
    let caster = Caster::new(&graph, 0.0005);
    let mut renderer = Renderer::new();
    let snapshot = renderer.snapshot(&graph).unwrap();
    let lighting = renderer.light(&snapshot, &Daylight::overcast());
    let camera =
        Camera::with_fov(SIZE.0 as u32, SIZE.1 as u32, 0.8).looking(Point3::origin(), Point3::new(1.0, 0.0, 0.0));
    let large = camera.resized((FINER * SIZE.0) as u32, (FINER * SIZE.1) as u32);
    let rendered = |camera: &Camera| {
        let mut frame = Frame::new();
        let wanted = Modality::Rgb | Modality::Instance | Modality::Depth | Modality::Normal;
        renderer.render(&Shot::new(&snapshot, camera, wanted).lit(&lighting), &mut frame).unwrap();
        frame
    };
    let (own, fine) = (rendered(&camera), rendered(&large));
    let wanted: Picture = picture::rgb(&fine).shrunk(FINER);
    // Share of a pixel that the board covers.
    let cover = |i: usize| {
        let (x, y) = (i % SIZE.0 * FINER, i / SIZE.0 * FINER);
        let inside = |k: &usize| fine.instance[(y + k / FINER) * FINER * SIZE.0 + x + k % FINER] == bright;
        (0..FINER * FINER).filter(inside).count() as f32 / (FINER * FINER) as f32
    };
    let (dark, light) = (f32::from(own.rgb[0][1]), f32::from(own.rgb[SIZE.1 / 2 * SIZE.0 + SIZE.0 / 2][1]));
    let range = light - dark;
    assert!(range > 100.0, "{dark} and {light}");
    let (mut crossed, mut half, mut between) = (0, 0, 0);
    // Errors relative to the fine picture, of the rendered colours and of colours without smoothing.
    let (mut off, mut hard, mut worst) = (0.0_f32, 0.0_f32, 0.0_f32);
    for i in 0..SIZE.0 * SIZE.1 {
        let (share, colour, truth) = (cover(i), f32::from(own.rgb[i][1]), f32::from(wanted.pixels[i][1]));
        if share > 0.0 && share < 1.0 {
            crossed += 1;
            off += (colour - truth).abs();
            worst = worst.max((colour - truth).abs());
            if (colour - truth).abs() > 25.0 {
                eprintln!("XX {} {} share {share} colour {colour} truth {truth}", i % SIZE.0, i / SIZE.0);
            }
            let unmixed = if own.instance[i] == bright { light } else { dark };
            hard += (unmixed - truth).abs();
        }
        if (0.2..0.8).contains(&share) {
            half += 1;
            between += usize::from(colour > dark + 0.1 * range && colour < light - 0.1 * range);
        }
    }
    let (off, hard) = (off / crossed as f32, hard / crossed as f32);
    eprintln!("{crossed} pixels are off by {off}, {worst} at worst, of {range}; {hard} if they were not smoothed");
    assert!(crossed > 60 && half > 30, "{crossed} pixels at edges, {half} of them about halfway");
    assert!(10 * between >= 8 * half, "{between} of {half} pixels are between the colours");
    // Corners are worst: a pixel there is known from one edge only.
    assert!(off < 0.03 * range && worst < 0.6 * range && 8.0 * off < hard, "off by {off}, {hard} if not smoothed");
    // Labels are those at the pixel's centre, never a mixture.
    let mut foreign = 0;
    for (i, node) in own.instance.iter().enumerate() {
        assert!([wall, bright].contains(node));
        let hit = caster.cast(&camera, (i % SIZE.0) as f64 + 0.5, (i / SIZE.0) as f64 + 0.5).unwrap();
        if hit.node != *node {
            foreign += 1;
            continue;
        }
        assert!((f64::from(own.depth[i]) / hit.depth - 1.0).abs() < 1e-4, "pixel {i}: {}", own.depth[i]);
        assert!((Vector3::from(own.normal[i]) - hit.normal.cast::<f32>()).norm() < 1e-3, "pixel {i}");
    }
    assert!(foreign <= 2, "{foreign} pixels");
}
