//! A home of modules for benches and random edits: rooms of 4 by 4 m with 25 objects each, with the support and
//! the container of every object.

use super::Named;

/// Ground truth about an object: its name, its support, its container.
#[derive(Debug)]
pub(crate) struct Truth {
    pub(crate) name: String,
    pub(crate) on: String,
    pub(crate) inside: Option<String>,
}

/// A home with at least `objects` objects, and its ground truth.
pub(crate) fn home(objects: usize) -> (Named, Vec<Truth>) {
    home_with(objects, &[])
}

/// The same home with more things in it.
pub(crate) fn home_with(objects: usize, more: &[&str]) -> (Named, Vec<Truth>) {
    let modules = objects.div_ceil(25);
    let side = (modules as f32).sqrt().ceil() as usize;
    let (mut lines, mut truth) = (Vec::new(), Vec::new());
    for module in 0..modules {
        let (x, y) = ((module % side) as f32 * 4.2, (module / side) as f32 * 4.2);
        room(module, x, y, &mut lines, &mut truth);
    }
    let scene = super::scene(lines.iter().map(String::as_str).chain(more.iter().copied()));
    (scene, truth)
}

fn room(m: usize, x: f32, y: f32, lines: &mut Vec<String>, truth: &mut Vec<Truth>) {
    let at = |dx: f32, dy: f32, z: f32| format!("@ {} {} {z}", x + dx, y + dy);
    lines.push(format!("room{m} = room 4 4 {}", at(0.0, 0.0, 0.0)));
    lines.push(format!("floor{m} = floor 4 4 {}", at(0.0, 0.0, 0.0)));
    lines.push(format!("floor{m} in room{m}"));
    lines.push(format!("wall{m} = wall 0.1 4 2.5 {}", at(2.05, 0.0, 0.0)));
    lines.push(format!("wallb{m} = wall 4 0.1 2.5 {}", at(0.0, 2.05, 0.0)));
    let mut put = |name: &str, shape: &str, place: String, on: &str, inside: Option<&str>| {
        lines.push(format!("{name}{m} = {shape} {place}"));
        let (on, inside) = (format!("{on}{m}"), inside.map(|c| format!("{c}{m}")));
        truth.push(Truth { name: format!("{name}{m}"), on, inside });
    };
    put("rug", "rug 1.6 2.2 0.01", at(0.0, 0.0, 0.0), "floor", None);
    put("table", "table! 0.8 1.2 0.75", at(0.0, 0.0, 0.01), "rug", None);
    put("chair_a", "chair", at(0.55, 0.0, 0.01) + " r 0 0 180", "rug", None);
    put("chair_b", "chair", at(-0.55, 0.0, 0.01), "rug", None);
    put("shelf", "shelf! 0.3 0.9 1.6 4", at(-1.8, 0.0, 0.0), "floor", None);
    for i in 0..4 {
        let place = at(-1.78, -0.3 + 0.032 * i as f32, 0.415);
        put(&format!("upright{i}_"), "book 0.2 0.03 0.25", place, "shelf", Some("shelf"));
    }
    for i in 0..4 {
        let on = if i == 0 { "shelf".to_owned() } else { format!("lying{}_", i - 1) };
        let place = at(-1.78, 0.1, 0.81 + 0.0305 * i as f32);
        put(&format!("lying{i}_"), "book 0.2 0.25 0.03", place, &on, Some("shelf"));
    }
    put("cup_a", "mug! 0.08 0.1", at(0.2, 0.3, 0.761), "table", None);
    put("cup_b", "mug! 0.08 0.1", at(-0.2, -0.3, 0.7595), "table", None);
    for i in 0..3 {
        let on = if i == 0 { "table".to_owned() } else { format!("plate{}_", i - 1) };
        put(&format!("plate{i}_"), "plate 0.26", at(0.1, -0.05, 0.76 + 0.008 * i as f32), &on, None);
    }
    put("bowl", "bowl! 0.24 0.09", at(-0.15, 0.3, 0.76), "table", None);
    put("apple", "ball 0.08", at(-0.15, 0.3, 0.765), "bowl", Some("bowl"));
    put("fridge", "cupboard! 0.6 0.6 1.8 4", at(1.65, -1.6, 0.0), "floor", None);
    put("milk", "can 0.08 0.2", at(1.65, -1.6, 0.466), "fridge", Some("fridge"));
    put("basket", "basket! 0.35 0.45 0.3", at(1.4, 1.4, 0.0), "floor", None);
    put("toy", "box 0.15 0.15 0.12", at(1.4, 1.4, 0.0105), "basket", Some("basket"));
    put("ball", "ball 0.2", at(0.2, 0.1, 0.01), "rug", None);
}
