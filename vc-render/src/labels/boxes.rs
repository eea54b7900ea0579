//! Boxes and masks of visible objects.

#![allow(clippy::needless_range_loop, reason = "lists of one length go side by side, as vectors do")]

use nalgebra::{Point2, Point3, Vector3};
use vc_graph::Pose;

use super::Run;
use crate::camera::Camera;
use crate::frame::{Box3, BoxLabel, Frame, PixelBox};
use crate::math::{self, Affine, Narrow, volume};
use crate::mesh::Mesh;
use crate::modality::Modality;
use crate::rasterization::{Frustum, refill};
use crate::scene::{Body, Instance, Snapshot};

/// The visible pixels of a body.
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
pub(crate) fn boxes<'a>(
    camera: &Camera,
    snapshot: &Snapshot,
    runs: impl Iterator<Item = &'a Run> + Clone,
    tallies: &mut Vec<Tally>,
    frame: &mut Frame,
) {
    let Frame { boxes, visible_masks, width, height, modalities, .. } = frame;
    refill(tallies, UNSEEN, snapshot.bodies.len());
    let body = |run: &Run| snapshot.instances[run.instance as usize].body as usize;
    for run in runs.clone() {
        tallies[body(run)].add(run);
    }
    // Amodal boxes and masks need the labels, too.
    let labelled = modalities.has(Modality::Boxes) || modalities.has(Modality::Amodal);
    let masked = modalities.has(Modality::Masks);
    if masked {
        visible_masks.begin(*width, *height);
    }
    let frustum = Frustum::new(camera, &(0..camera.height as i32));
    let seen = snapshot.bodies.iter().zip(tallies.iter_mut()).filter(|(_, t)| t.area > 0);
    for (number, (body, tally)) in seen.enumerate() {
        tally.label = number as u32;
        if labelled {
            boxes.push(label(camera, &frustum, snapshot, body, tally));
        }
        if masked {
            visible_masks.push(body.node, tally.within());
        }
    }
    if masked {
        for run in runs {
            visible_masks.set(tallies[body(run)].label as usize, run.y, run.from, run.to);
        }
    }
}

impl Tally {
    fn add(&mut self, run: &Run) {
        self.low = [self.low[0].min(run.from), self.low[1].min(run.y)];
        self.high = [self.high[0].max(run.to - 1), self.high[1].max(run.y)];
        self.area += (run.to - run.from) as u32;
    }

    /// The box around the visible pixels.
    fn within(&self) -> PixelBox {
        PixelBox::between(self.low, self.high)
    }
}

fn label(camera: &Camera, frustum: &Frustum, snapshot: &Snapshot, body: &Body, tally: &Tally) -> BoxLabel {
    let visible = tally.within();
    let instances = &snapshot.instances[body.instances.start as usize..body.instances.end as usize];
    let whole = crate::math::simd::widest(
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

/// Number of vertices processed together.
const LANES: usize = 8;

/// The least and the greatest image coordinates.
type Sides = [[f32; 2]; 2];

const NOWHERE: Sides = [[f32::INFINITY; 2], [f32::NEG_INFINITY; 2]];

/// The box around the projection of all meshes beyond the near plane.
#[inline(always)]
fn outline(frustum: &Frustum, instances: &[Instance]) -> Option<PixelBox> {
    let [mut low, mut high] = NOWHERE;
    for instance in instances {
        let map = frustum.map.after(&instance.world);
        let (whole, nearest) = around(&map.narrow(), &instance.link.levels[0]);
        let sides = if nearest >= frustum.near { whole } else { beyond(&map, frustum.near, instance) };
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

/// The extent of all vertices of a mesh in front of the eye, and the depth of the nearest.
#[inline(always)]
fn around(map: &Narrow, mesh: &Mesh) -> (Sides, f32) {
    let mut found = Found {
        low: [[f32::INFINITY; LANES]; 2],
        high: [[f32::NEG_INFINITY; LANES]; 2],
        nearest: [f32::INFINITY; LANES],
    };
    let [(xs, x), (ys, y), (zs, z)] = mesh.axes.each_ref().map(|axis| axis.as_chunks());
    for ((xs, ys), zs) in xs.iter().zip(ys).zip(zs) {
        found.add(map, [xs, ys, zs]);
    }
    if !x.is_empty() {
        // Missing lanes repeat the first remaining vertex.
        let [x, y, z] = [x, y, z].map(|rest| std::array::from_fn(|i| rest[if i < rest.len() { i } else { 0 }]));
        found.add(map, [&x, &y, &z]);
    }
    let least = |lanes: [f32; LANES]| lanes.into_iter().fold(f32::INFINITY, f32::min);
    let most = |lanes: [f32; LANES]| lanes.into_iter().fold(f32::NEG_INFINITY, f32::max);
    ([found.low.map(least), found.high.map(most)], least(found.nearest))
}

/// The extent of vertices, one for each lane and merged at the end, so that no lane waits for the one before
/// it.
struct Found {
    low: [[f32; LANES]; 2],
    high: [[f32; LANES]; 2],
    nearest: [f32; LANES],
}

impl Found {
    #[inline(always)]
    fn add(&mut self, map: &Narrow, [xs, ys, zs]: [&[f32; LANES]; 3]) {
        for i in 0..LANES {
            let [px, py, depth] = math::point(map, [xs[i], ys[i], zs[i]]);
            let over = 1.0 / depth;
            self.nearest[i] = if depth < self.nearest[i] { depth } else { self.nearest[i] };
            for (axis, v) in [px * over, py * over].into_iter().enumerate() {
                self.low[axis][i] = if v < self.low[axis][i] { v } else { self.low[axis][i] };
                self.high[axis][i] = if v > self.high[axis][i] { v } else { self.high[axis][i] };
            }
        }
    }
}

/// The extent of front-facing triangles, clipped at the near plane.
#[cold]
#[inline(never)]
fn beyond(map: &Affine, near: f32, instance: &Instance) -> Sides {
    let mesh = &*instance.link.levels[0];
    let mut sides = NOWHERE;
    let near = f64::from(near);
    for cluster in &mesh.clusters {
        for triangle in cluster.triangles.clone() {
            let corners = mesh.triangle(cluster, triangle as usize).map(|p| map.point(p.map(f64::from)));
            if faces_away(&corners, instance.mirrored) {
                continue;
            }
            for (i, a) in corners.iter().enumerate() {
                let b = &corners[(i + 1) % 3];
                if a[2] >= near {
                    extend(&mut sides, a);
                }
                if (a[2] >= near) != (b[2] >= near) {
                    let share = (near - a[2]) / (b[2] - a[2]);
                    extend(&mut sides, &[0, 1, 2].map(|k: usize| a[k] + share * (b[k] - a[k])));
                }
            }
        }
    }
    sides
}

/// Whether a triangle faces away from the eye, given its corners as pixels times depth, and depth.
fn faces_away([a, b, c]: &[[f64; 3]; 3], mirrored: bool) -> bool {
    // Corners are counter-clockwise seen from outside: the front faces the eye where the volume is negative.
    (volume(a, b, c) >= 0.0) != mirrored
}

fn extend([low, high]: &mut Sides, p: &[f64; 3]) {
    for axis in 0..2 {
        let v = (p[axis] / p[2]) as f32;
        low[axis] = low[axis].min(v);
        high[axis] = high[axis].max(v);
    }
}

fn oriented(camera: &Camera, body: &Body) -> Box3 {
    let pose = body.pose * Pose::translation(body.bounds.centre[0], body.bounds.centre[1], body.bounds.centre[2]);
    let mut made = Box3 { pose, half: Vector3::from(body.bounds.half), corners: [None; 8] };
    let seen = |p: Point3<f32>| camera.project(&p).map(|p| Point2::new(p.x, p.y));
    made.corners = [0, 1, 2, 3, 4, 5, 6, 7].map(|i: usize| seen(made.corner(i)));
    made
}
