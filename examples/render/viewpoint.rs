//! Where to stand to see a room.

use std::collections::BTreeSet;

use nalgebra::Point3;
use virtualcity::graph::{NodeId, SceneGraph};
use virtualcity::render::{Camera, Frame, Modality, Renderer, Shot, Snapshot};

use crate::support::Complaint;

/// The camera in a room, at eye height, that sees most of what is in it.
pub(crate) fn best(
    renderer: &Renderer,
    snapshot: &Snapshot,
    scene: &SceneGraph,
    class: &str,
    (width, height): (u32, u32),
) -> Result<Camera, Complaint> {
    let room = room(scene, class)?;
    let small = Camera::with_fov(80, 80 * height / width.max(1), 1.15);
    let mut frame = Frame::new();
    let mut best: Option<(f32, Camera)> = None;
    for camera in candidates(scene, room, small) {
        let shot = Shot::new(snapshot, &camera, Modality::Instance | Modality::Depth);
        renderer.render(&shot, &mut frame).map_err(Complaint::new)?;
        let score = score(scene, room, &frame);
        if best.is_none_or(|b| score > b.0) {
            best = Some((score, camera));
        }
    }
    let (_, camera) = best.ok_or_else(|| Complaint::new(format!("the {class} has no extent")))?;
    Ok(Camera { pose: camera.pose, ..Camera::with_fov(width, height, 1.15) })
}

/// The first room of a class.
fn room(scene: &SceneGraph, class: &str) -> Result<NodeId, Complaint> {
    scene.of_class(class).first().copied().ok_or_else(|| {
        let names: Vec<String> = scene.rooms().iter().map(|r| scene.label(*r).class.to_string()).collect();
        Complaint::new(format!("the home has no {class}; it has {}", names.join(", ")))
    })
}

/// Along the walls and in the corners, looking across.
fn candidates(scene: &SceneGraph, room: NodeId, camera: Camera) -> Vec<Camera> {
    let Some(bounds) = scene.node(room).and_then(|n| n.aabb()) else { return Vec::new() };
    let (low, high, middle) = (bounds.min, bounds.max, bounds.centre());
    let place = |share: f32, low: f32, high: f32| low + 0.3 + share * (high - low - 0.6).max(0.0);
    let mut all = Vec::new();
    for (i, j) in (0..5).flat_map(|i| (0..5).map(move |j| (i, j))).filter(|(i, j)| i % 4 == 0 || j % 4 == 0) {
        let eye = Point3::new(place(i as f32 / 4.0, low.x, high.x), place(j as f32 / 4.0, low.y, high.y), low.z + 1.55);
        for pull in [0.0, 0.35] {
            let target = middle + (eye - middle) * -pull;
            all.push(camera.looking(eye, Point3::new(target.x, target.y, low.z + 0.95)));
        }
    }
    all
}

/// Things of the room that are seen, less what stands in the way.
fn score(scene: &SceneGraph, room: NodeId, frame: &Frame) -> f32 {
    let mine = |n: &NodeId| scene.node(*n).is_some() && scene.room_of(*n) == Some(room);
    let seen: BTreeSet<NodeId> = frame.instance.iter().copied().filter(mine).collect();
    let pixels = frame.depth.len() as f32;
    let share = |of: fn(f32) -> bool| frame.depth.iter().filter(|d| of(**d)).count() as f32 / pixels;
    let foreign = frame.instance.iter().filter(|n| !mine(n)).count() as f32 / pixels;
    seen.len() as f32 - 60.0 * share(|d| d < 0.7) - 15.0 * share(|d| d < 1.3) - 25.0 * foreign
}
