//! Surfaces look as their materials say: patterns, roughness and metal, in fast pictures and in reference pictures.

#![allow(clippy::unwrap_used)]

mod common;

use common::{Stage, block, material, part};
use nalgebra::{Point3, Vector3};
use vc_graph::asset::{Material, Shape};
use vc_graph::portable::Portable;
use vc_graph::{NodeId, Pose};
use vc_render::{Camera, Daylight, Exposure, Frame, Modality, Renderer, Shot};

/// A pattern: the name of a material and of a part that have it, and how many metres of it to look at.
const PATTERNS: [(&str, &str, f32); 13] = [
    ("plain", "body", 0.5),
    ("oak", "body", 0.6),
    ("oak", "floor", 1.2),
    ("linen", "body", 0.015),
    ("leather", "body", 0.05),
    ("tile", "body", 0.6),
    ("brick", "body", 0.5),
    ("granite", "body", 0.1),
    ("marble", "body", 0.6),
    ("concrete", "body", 0.75),
    ("steel", "body", 0.1),
    ("paper", "body", 0.1),
    ("wall_paint", "body", 0.4),
];

/// Those so faint that in even light they are as good as plain.
const FAINT: [&str; 3] = ["plain", "paper", "wall_paint"];

fn even() -> Daylight {
    let one = Vector3::repeat(1.0);
    Daylight { sun: Vector3::zeros(), zenith: one, horizon: one, ground: one, ..Daylight::noon() }
}

/// A board of three metres at x = 0 that faces -x.
fn board() -> Shape {
    let corner = |y: f32, z: f32| Point3::new(0.0, 1.5 * y, 1.5 * z);
    let vertices = vec![corner(1.0, -1.0), corner(-1.0, -1.0), corner(-1.0, 1.0), corner(1.0, 1.0)];
    Shape::Mesh { vertices, triangles: vec![[0, 1, 2], [0, 2, 3]], uvs: Vec::new() }
}

/// A fast picture and a reference picture of a pattern.
fn pictures((name, role, metres): (&str, &str, f32)) -> [Vec<[u8; 3]>; 2] {
    let mut stage = Stage::new();
    let metal = name == "steel";
    let (metallic, roughness) = if metal { (1.0, 0.4) } else { (0.0, 0.8) };
    let made = Material { metallic, roughness, ..material(name, [0.5, 0.4, 0.3]) };
    let number = stage.library.add_material(made).unwrap();
    let asset = stage.asset(vec![part(role, board(), [0.0; 3], number)]);
    stage.put("painting", asset, Pose::identity());
    let mut renderer = Renderer::new();
    let snapshot = renderer.snapshot(&stage.build()).unwrap();
    let lighting = renderer.light(&snapshot, &even());
    let away = metres / (2.0 * 0.2_f32.tangent());
    let target = Point3::new(0.0, 0.13, 0.07);
    let camera = Camera::with_fov(64, 48, 0.4).looking(target - away * Vector3::x(), target);
    let mut frame = Frame::new();
    renderer.render(&Shot::new(&snapshot, &camera, Modality::Rgb).lit(&lighting), &mut frame).unwrap();
    let how = Exposure { samples: 8, bounces: 1, denoise: false, ..Exposure::default() };
    let reference = renderer.photograph(&lighting, &camera, &how, |_| true).unwrap().picture();
    [frame.rgb, reference.pixels]
}

fn mean<'a>(pixels: impl Iterator<Item = &'a [u8; 3]>, channel: usize) -> f32 {
    let (sum, count) = pixels.fold((0.0, 0), |(sum, n), p| (sum + f32::from(p[channel]), n + 1));
    sum / count as f32
}

/// How far greens are from their mean.
fn leant(pixels: &[[u8; 3]]) -> Vec<f32> {
    let mean = mean(pixels.iter(), 1);
    pixels.iter().map(|p| f32::from(p[1]) - mean).collect()
}

/// The standard deviation of numbers whose mean is zero.
fn spread(leant: &[f32]) -> f32 {
    (leant.iter().map(|v| v * v).sum::<f32>() / leant.len() as f32).sqrt()
}

#[test]
fn every_pattern_is_seen_and_is_its_own() {
    let seen: Vec<[Vec<[u8; 3]>; 2]> = PATTERNS.into_iter().map(pictures).collect();
    let leant: Vec<Vec<f32>> = seen.iter().map(|[fast, _]| leant(fast)).collect();
    let plain = spread(&leant[0]);
    assert!(plain < 1.0, "plain paint is spread by {plain}");
    for ((name, role, _), leant) in PATTERNS.iter().zip(&leant) {
        let own = spread(leant);
        eprintln!("{name} of a {role}: spread by {own:.2}");
        if FAINT.contains(name) {
            assert!(own < 4.0, "{name} is spread by {own}");
        } else {
            assert!(own > 0.5 + 2.0 * plain, "{name} of a {role} is spread by {own}, plain paint by {plain}");
        }
    }
    let strong: Vec<usize> = (0..PATTERNS.len()).filter(|i| !FAINT.contains(&PATTERNS[*i].0)).collect();
    for (a, b) in strong.iter().flat_map(|a| strong.iter().map(move |b| (*a, *b))).filter(|(a, b)| a < b) {
        let other: f32 = leant[a].iter().zip(&leant[b]).map(|(a, b)| (a - b).abs()).sum();
        let (mean, least) = (other / leant[a].len() as f32, spread(&leant[a]).min(spread(&leant[b])));
        assert!(mean > 0.3 * least, "{:?} and {:?} differ by {mean} only", PATTERNS[a], PATTERNS[b]);
    }
    // Both ways to make pictures have the same patterns.
    for ((name, role, _), [fast, reference]) in PATTERNS.iter().zip(&seen) {
        let share = if *name == "steel" { 0.1 } else { 0.05 };
        for c in 0..3 {
            let (own, wanted) = (mean(fast.iter(), c), mean(reference.iter(), c));
            assert!((own - wanted).abs() < 2.0 + share * wanted, "{name} of a {role}: {own}, not {wanted}");
        }
    }
}

#[test]
fn balls_of_any_roughness_and_metal_are_nearly_as_bright_as_in_the_reference() {
    let mut stage = Stage::new();
    let ground = Material { roughness: 1.0, ..material("plain", [0.5; 3]) };
    let ground = stage.library.add_material(ground).unwrap();
    stage.one("floor", block([4.0, 4.0, 0.05]), Pose::translation(0.0, 0.0, -0.05), ground);
    let mut balls: Vec<(NodeId, f32, f32)> = Vec::new();
    for (metallic, z) in [(0.0, 0.32), (1.0, 1.1)] {
        for (i, roughness) in [0.1, 0.3, 0.5, 0.75, 1.0].into_iter().enumerate() {
            // Lacquer has no pattern.
            let made = Material { metallic, roughness, ..material("lacquer", [0.7, 0.35, 0.15]) };
            let number = stage.library.add_material(made).unwrap();
            let at = Pose::translation(0.0, 1.4 - 0.7 * i as f32, z);
            balls.push((stage.one("ball", Shape::Sphere { radius: 0.3 }, at, number), metallic, roughness));
        }
    }
    let mut renderer = Renderer::new();
    let snapshot = renderer.snapshot(&stage.build()).unwrap();
    let lighting = renderer.light(&snapshot, &Daylight::overcast());
    let camera = Camera::with_fov(96, 48, 0.46).looking(Point3::new(-4.0, 0.0, 1.2), Point3::new(0.0, 0.0, 0.7));
    let mut frame = Frame::new();
    let wanted = Modality::Rgb | Modality::Instance;
    renderer.render(&Shot::new(&snapshot, &camera, wanted).lit(&lighting), &mut frame).unwrap();
    let how = Exposure { samples: 48, ..Exposure::default() };
    let reference = renderer.photograph(&lighting, &camera, &how, |_| true).unwrap().picture();
    let mut levels = Vec::new();
    for (node, metallic, roughness) in balls {
        let own = |pixels: &[[u8; 3]]| -> Vec<[u8; 3]> {
            pixels.iter().zip(&frame.instance).filter(|(_, n)| **n == node).map(|(p, _)| *p).collect()
        };
        let (fast, wanted) = (own(&frame.rgb), own(&reference.pixels));
        assert!(fast.len() > 100, "{} pixels of a ball", fast.len());
        let [fast, wanted] = [fast, wanted].map(|pixels| [0, 1, 2].map(|c: usize| mean(pixels.iter(), c)));
        eprintln!("metal {metallic}, roughness {roughness}: {fast:.0?}, reference {wanted:.0?}");
        let most = if metallic > 0.0 { 24.0 } else { 14.0 };
        assert!(
            (0..3).all(|c| (fast[c] - wanted[c]).abs() < most),
            "metal {metallic}, roughness {roughness}: {fast:?}, not {wanted:?} within {most} of 255"
        );
        levels.push(fast[0]);
    }
    // Balls are told from what is around them, and metal from paint.
    assert!(levels.iter().all(|v| *v > 20.0), "{levels:?}");
    assert!(levels[..5].iter().zip(&levels[5..]).all(|(a, b)| (a - b).abs() > 1.0), "{levels:?}");
}
