//! Pictures of generated homes show what is in them.

#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use nalgebra::Point3;
use virtualcity::graph::Seed;
use virtualcity::procgen::Apartment;
use virtualcity::render::{Camera, Daylight, Frame, Modality, Renderer, Shot};

/// The brightness that half of the pixels have, 0 to 255, of a view across each bathroom of a home
/// at noon, all ceiling lamps on.
fn bathrooms(seed: u64) -> Vec<u8> {
    let scene = Apartment::from_seed(Seed(seed)).unwrap().scene();
    let mut renderer = Renderer::new();
    let mut snapshot = renderer.snapshot(&scene).unwrap();
    for lamp in scene.of_class("ceiling_lamp").iter().copied() {
        snapshot.switch(lamp, true).unwrap();
    }
    let lighting = renderer.light(&snapshot, &Daylight::noon());
    let rooms = scene.of_class("bathroom").to_vec().into_iter().filter_map(|room| scene.node(room)?.aabb());
    let view = |(low, high): (Point3<f32>, Point3<f32>)| {
        let eye = Point3::new(low.x + 0.3, low.y + 0.3, low.z + 1.6);
        let camera = Camera::with_fov(48, 36, 1.2).looking(eye, Point3::new(high.x, high.y, low.z + 0.8));
        let mut frame = Frame::new();
        let shot = Shot { lighting: Some(&lighting), ..Shot::new(&snapshot, &camera, Modality::Rgb) };
        renderer.render(&shot, &mut frame).unwrap();
        let mut levels: Vec<u8> = frame.rgb.iter().map(|c| c.iter().copied().max().unwrap_or(0)).collect();
        levels.sort_unstable();
        levels[levels.len() / 2]
    };
    rooms.map(|b| view((b.min, b.max))).collect()
}

#[test]
fn rooms_without_windows_are_exposed_for_their_lamps() {
    // Some lie within the box of a hall with corners, beside a living room full of sun.
    for seed in [3, 7, 12] {
        for level in bathrooms(seed) {
            assert!((30..=245).contains(&level), "home {seed}: half of a bathroom's picture is below {level}");
        }
    }
}
