//! Labels of nodes, classes and parts.

use pulp::{Simd, WithSimd};
use vc_graph::NodeId;

use crate::frame::Strip;
use crate::modality::{NO_LABEL, NOTHING};
use crate::rasterization::{Layers, NONE};
use crate::scene::Snapshot;

/// Neighbouring pixels of a row that show one instance.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Run {
    pub(crate) instance: u32,
    pub(crate) y: i32,
    /// First column, and the one after the last.
    pub(crate) from: i32,
    pub(crate) to: i32,
}

/// Finds the runs of some rows, one row after the other.
pub(crate) fn runs(layers: &Layers, rows: std::ops::Range<i32>, runs: &mut Vec<Run>) {
    crate::math::simd::dispatch(Find { layers, rows, runs });
}

/// The search for runs, compiled for the processor's vectors.
struct Find<'a> {
    layers: &'a Layers,
    rows: std::ops::Range<i32>,
    runs: &'a mut Vec<Run>,
}

impl WithSimd for Find<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let Self { layers, rows, runs } = self;
        runs.clear();
        for y in rows {
            let mut last = NONE;
            crate::math::simd::runs(
                simd,
                layers.front.triangle_row(y),
                #[inline(always)]
                |triangle, from, to| {
                    let instance = layers.visible.get(triangle as usize).map_or(NONE, |v| v.instance);
                    match runs.last_mut() {
                        Some(run) if instance != NONE && instance == last => run.to = to as i32,
                        _ if instance != NONE => runs.push(Run { instance, y, from: from as i32, to: to as i32 }),
                        _ => {}
                    }
                    last = instance;
                },
            );
        }
    }
}

/// Writes nodes, classes and parts, as far as they are requested.
pub(crate) fn ids(snapshot: &Snapshot, layers: &Layers, runs: &[Run], strip: &mut Strip<'_>) {
    let mut from = 0;
    for run in runs {
        let body = &snapshot.bodies[snapshot.instances[run.instance as usize].body as usize];
        let row = strip.row(run.y).start;
        let (start, to) = (row + run.from as usize, row + run.to as usize);
        fill(strip, from..start, (NOTHING, NO_LABEL));
        fill(strip, start..to, (body.node, body.class));
        from = to;
    }
    let end = strip.width * strip.rows.len();
    fill(strip, from..end, (NOTHING, NO_LABEL));
    if !strip.part.is_empty() {
        parts(snapshot, layers, strip);
    }
}

/// Writes the node and class of some pixels, as far as they are requested.
#[inline(always)]
fn fill(strip: &mut Strip<'_>, pixels: std::ops::Range<usize>, (node, class): (NodeId, u16)) {
    if let Some(instance) = strip.instance.get_mut(pixels.clone()) {
        instance.fill(node);
    }
    if let Some(classes) = strip.class.get_mut(pixels) {
        classes.fill(class);
    }
}

fn parts(snapshot: &Snapshot, layers: &Layers, strip: &mut Strip<'_>) {
    for y in strip.rows.clone() {
        let row = strip.row(y);
        for (part, &triangle) in strip.part[row].iter_mut().zip(layers.front.triangle_row(y)) {
            *part = NO_LABEL;
            if let Some(visible) = layers.visible.get(triangle as usize) {
                *part = visible.mesh(&snapshot.instances).faces[visible.index()].part;
            }
        }
    }
}
