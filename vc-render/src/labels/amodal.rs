//! Amodal masks: whole objects as if nothing occluded them.

use crate::camera::Camera;
use crate::frame::{Frame, PixelBox};
use crate::rasterization::{Drawing, Frustum, Layers, NONE};
use crate::scene::Snapshot;

/// Draws every labelled body alone, and fills in its mask and visible fraction.
pub(crate) fn amodal(camera: &Camera, snapshot: &Snapshot, detail: f32, layers: &mut Layers, frame: &mut Frame) {
    let (width, height) = (frame.width, frame.height);
    let Frame { boxes, whole_masks, .. } = frame;
    let frustum = Frustum::new(camera, &(0..height as i32));
    let drawing = Drawing { instances: &snapshot.instances, frustum, detail };
    whole_masks.begin(width, height);
    layers.front.reset(width, 0..height as i32);
    for label in boxes {
        let Some(body) = snapshot.body_of(label.node) else { continue };
        // One pixel more on every side allows for rounding.
        let PixelBox { x, y, width: w, height: h } = label.amodal;
        let roomy = PixelBox {
            x: x.saturating_sub(1),
            y: y.saturating_sub(1),
            width: w.saturating_add(2),
            height: h.saturating_add(2),
        };
        let Some(within) = roomy.within(width, height) else { continue };
        layers.front.erase(within.x..within.x + within.width, within.y..within.y + within.height);
        layers.visible.clear();
        layers.add(&drawing, body.instances.clone(), false);
        let index = whole_masks.iter().len();
        whole_masks.push(label.node, within);
        let area = copy(layers, within, |y, from, to| whole_masks.set(index, y, from, to));
        layers.front.erase(within.x..within.x + within.width, within.y..within.y + within.height);
        label.visible_fraction = Some(label.area as f32 / area.max(label.area) as f32);
    }
}

/// Passes on the runs of covered pixels, and counts these pixels.
fn copy(layers: &Layers, within: PixelBox, mut set: impl FnMut(i32, i32, i32)) -> u32 {
    let mut area = 0;
    for y in within.y..within.y + within.height {
        let row = &layers.front.triangle_row(y)[within.x as usize..(within.x + within.width) as usize];
        let mut column = within.x;
        for same in row.chunk_by(|a, b| (*a == NONE) == (*b == NONE)) {
            let (from, to) = (column, column + same.len() as i32);
            column = to;
            if same[0] != NONE {
                set(y, from, to);
                area += same.len() as u32;
            }
        }
    }
    area
}
