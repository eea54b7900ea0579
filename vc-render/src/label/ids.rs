//! Nodes, classes and parts.

use crate::frame::{NO_LABEL, Strip};
use crate::raster::{Layers, NONE};
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

/// The runs of some rows, one after the other.
pub(crate) fn runs(layers: &Layers, rows: std::ops::Range<i32>, runs: &mut Vec<Run>) {
    runs.clear();
    for y in rows {
        let mut column = 0;
        let mut last = NONE;
        for same in layers.front.triangle_row(y).chunk_by(|a, b| a == b) {
            let (from, to) = (column, column + same.len() as i32);
            column = to;
            let triangle = same[0];
            let instance = if triangle == NONE { NONE } else { layers.visible[triangle as usize].instance };
            if instance != NONE && instance == last {
                if let Some(run) = runs.last_mut() {
                    run.to = to;
                }
            } else if instance != NONE {
                runs.push(Run { instance, y, from, to });
            }
            last = instance;
        }
    }
}

/// Writes what is asked for of nodes, classes and parts.
pub(crate) fn ids(snapshot: &Snapshot, layers: &Layers, runs: &[Run], strip: &mut Strip<'_>) {
    strip.instance.fill(crate::frame::NOTHING);
    strip.class.fill(NO_LABEL);
    for run in runs {
        let body = &snapshot.bodies[snapshot.instances[run.instance as usize].body as usize];
        let row = strip.row(run.y).start;
        let pixels = row + run.from as usize..row + run.to as usize;
        if let Some(instance) = strip.instance.get_mut(pixels.clone()) {
            instance.fill(body.node);
        }
        if let Some(class) = strip.class.get_mut(pixels) {
            class.fill(body.class);
        }
    }
    if !strip.part.is_empty() {
        parts(snapshot, layers, strip);
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
