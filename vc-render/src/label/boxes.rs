//! Boxes and masks of what is seen.

use nalgebra::{Point2, Point3, Vector3};
use vc_graph::Pose;

use super::Run;
use crate::affine;
use crate::camera::Camera;
use crate::frame::{Box3, BoxLabel, Frame, Masks, PixelBox};
use crate::modality::Modality;
use crate::raster::{Frustum, refill};
use crate::scene::{Body, Instance, Snapshot};

/// Where a body is seen.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Tally {
    low: [i32; 2],
    high: [i32; 2],
    area: u32,
    /// Position of its label, once it has one.
    label: u32,
}

const UNSEEN: Tally = Tally { low: [i32::MAX; 2], high: [i32::MIN; 2], area: 0, label: 0 };

/// Fills in boxes and visible masks from the runs of all bands.
pub(crate) fn boxes(camera: &Camera, snapshot: &Snapshot, frame: &mut Frame) {
    let Frame { memory, boxes, visible_masks, width, height, holds, .. } = frame;
    let tally = &mut memory.tally;
    refill(tally, UNSEEN, snapshot.bodies.len());
    let body = |run: &Run| snapshot.instances[run.instance as usize].body as usize;
    for run in memory.bands.iter().flat_map(|b| &b.runs) {
        tally[body(run)].add(run);
    }
    let frustum = Frustum::new(camera, &(0..camera.height as i32));
    for (body, tally) in snapshot.bodies.iter().zip(tally.iter_mut()).filter(|(_, t)| t.area > 0) {
        tally.label = boxes.len() as u32;
        boxes.push(label(camera, &frustum, snapshot, body, tally));
    }
    if holds.has(Modality::Masks) {
        masks(visible_masks, boxes, (*width, *height));
        for run in memory.bands.iter().flat_map(|b| &b.runs) {
            visible_masks.set(memory.tally[body(run)].label as usize, run.y, run.from, run.to);
        }
    }
    // Made for the masks alone.
    if !holds.has(Modality::Boxes) && !holds.has(Modality::Amodal) {
        boxes.clear();
    }
}

fn masks(masks: &mut Masks, boxes: &[BoxLabel], (width, height): (usize, usize)) {
    masks.begin(width, height);
    boxes.iter().for_each(|b| masks.push(b.node, b.visible));
}

impl Tally {
    fn add(&mut self, run: &Run) {
        self.low = [self.low[0].min(run.from), self.low[1].min(run.y)];
        self.high = [self.high[0].max(run.to - 1), self.high[1].max(run.y)];
        self.area += (run.to - run.from) as u32;
    }
}

fn label(camera: &Camera, frustum: &Frustum, snapshot: &Snapshot, body: &Body, tally: &Tally) -> BoxLabel {
    let visible = PixelBox::between(tally.low, tally.high);
    let instances = &snapshot.instances[body.instances.start as usize..body.instances.end as usize];
    let whole = crate::simd::widest(
        #[inline(always)]
        || outline(frustum, instances),
    );
    BoxLabel {
        node: body.node,
        class: body.class,
        visible,
        amodal: whole.map_or(visible, |w| w.joined(&visible)),
        area: tally.area,
        visible_fraction: None,
        oriented: oriented(camera, body),
    }
}

/// The box around all vertices, those before the near plane left out.
#[inline(always)]
fn outline(frustum: &Frustum, instances: &[Instance]) -> Option<PixelBox> {
    let (mut low, mut high) = ([f32::INFINITY; 2], [f32::NEG_INFINITY; 2]);
    for instance in instances {
        let map = frustum.map.after(&instance.world).narrow();
        let [xs, ys, zs] = &instance.link.levels[0].axes;
        let mut sides = [[f32::INFINITY; 2], [f32::NEG_INFINITY; 2]];
        for ((x, y), z) in xs.iter().zip(ys).zip(zs) {
            let [px, py, depth] = affine::point(&map, [*x, *y, *z]);
            let over = 1.0 / depth;
            let seen = depth >= frustum.near;
            for (axis, v) in [px * over, py * over].into_iter().enumerate() {
                let v = [if seen { v } else { f32::INFINITY }, if seen { v } else { f32::NEG_INFINITY }];
                sides[0][axis] = if v[0] < sides[0][axis] { v[0] } else { sides[0][axis] };
                sides[1][axis] = if v[1] > sides[1][axis] { v[1] } else { sides[1][axis] };
            }
        }
        low = [0, 1].map(|i: usize| low[i].min(sides[0][i]));
        high = [0, 1].map(|i: usize| high[i].max(sides[1][i]));
    }
    (low[0] <= high[0]).then(|| {
        // Pixels whose centres are inside.
        let first = low.map(|v| (v - 0.5).ceil().max(-1e9) as i32);
        let last = high.map(|v| (v - 0.5).floor().min(1e9) as i32);
        PixelBox::between(first, [0, 1].map(|i: usize| last[i].max(first[i])))
    })
}

fn oriented(camera: &Camera, body: &Body) -> Box3 {
    let pose = body.pose * Pose::translation(body.bounds.centre[0], body.bounds.centre[1], body.bounds.centre[2]);
    let mut made = Box3 { pose, half: Vector3::from(body.bounds.half), corners: [None; 8] };
    let seen = |p: Point3<f32>| camera.project(&p).map(|p| Point2::new(p.x, p.y));
    made.corners = [0, 1, 2, 3, 4, 5, 6, 7].map(|i: usize| seen(made.corner(i)));
    made
}
