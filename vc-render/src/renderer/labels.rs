//! Labels: the visibility buffer is drawn, and each modality read from it.

use super::Renderer;
use super::scratch::{Band, Scratch, halves};
use crate::frame::{Frame, Strip};
use crate::labels::{self, Other};
use crate::math::simd::widest;
use crate::modality::Modality;
use crate::rasterization::{Drawing, Frustum, Layers};
use crate::shot::{Shot, View};

/// Modalities that are written run by run: neighbouring pixels of a row that show one instance.
const RUNS: [Modality; 8] = [
    Modality::Instance,
    Modality::Class,
    Modality::FlowForward,
    Modality::FlowBackward,
    Modality::Occlusion,
    Modality::Boxes,
    Modality::Masks,
    Modality::Amodal,
];

impl Renderer {
    /// Draws a shot's visibility buffer, and fills in its labels.
    pub(super) fn labels(&self, shot: &Shot<'_>, frame: &mut Frame, scratch: &mut Scratch) {
        let View { snapshot, camera } = shot.view;
        let Scratch { bands, others, alone, tallies, .. } = scratch;
        if shot.modalities.has(Modality::Occlusion) {
            self.others([shot.after, shot.before], others);
        }
        bands.prepare(count(camera.height));
        self.bands(shot, Strip::whole(frame), bands.in_use_mut(), others);
        if [Modality::Boxes, Modality::Masks, Modality::Amodal].iter().any(|m| shot.modalities.has(*m)) {
            let runs = bands.in_use().iter().flat_map(|band| &band.runs);
            labels::boxes(camera, snapshot, runs, tallies, frame);
        }
        if shot.modalities.has(Modality::Amodal) {
            labels::amodal(camera, snapshot, self.store.detail, alone, frame);
        }
    }

    /// Renders bands of rows, splitting them in half recursively among the threads.
    fn bands(&self, shot: &Shot<'_>, strip: Strip<'_>, bands: &mut [Band], other: &[Other; 2]) {
        if let [band] = bands {
            return self.band(shot, strip, band, other);
        }
        let [(upper, first), (lower, last)] = halves(strip, bands);
        rayon::join(|| self.bands(shot, upper, first, other), || self.bands(shot, lower, last, other));
    }

    fn band(&self, shot: &Shot<'_>, mut strip: Strip<'_>, band: &mut Band, other: &[Other; 2]) {
        let View { snapshot, camera } = shot.view;
        let wanted = shot.modalities;
        // Colours need one more row, for the smoothing of edges.
        let rgb = wanted.has(Modality::Rgb);
        let last = if rgb { (strip.rows.end + 1).min(camera.height as i32) } else { strip.rows.end };
        let rows = strip.rows.start..last;
        band.rows = strip.rows.clone();
        self.draw(shot.view, rows, &mut band.layers, rgb);
        widest(
            #[inline(always)]
            || labels::depths(camera, &band.layers, &mut strip),
        );
        labels::normals(camera, snapshot, &band.layers, &mut strip);
        band.runs.clear();
        if RUNS.iter().any(|m| wanted.has(*m)) || wanted.has(Modality::Part) {
            labels::runs(&band.layers, strip.rows.clone(), &mut band.runs);
            labels::ids(snapshot, &band.layers, &band.runs, &mut strip);
        }
        flow(shot, &mut strip, band, other);
    }

    /// Draws all instances into some rows of an image.
    fn draw(&self, view: View<'_>, rows: std::ops::Range<i32>, layers: &mut Layers, apart: bool) {
        let View { snapshot, camera } = view;
        let frustum = Frustum::new(camera, &rows);
        let drawing = Drawing { instances: &snapshot.instances, frustum, detail: self.store.detail };
        let all = 0..snapshot.instances.len() as u32;
        layers.draw(&drawing, all, (camera.width as usize, rows), apart);
    }

    /// Draws the moments after and before, to find what is hidden there.
    fn others(&self, views: [Option<View<'_>>; 2], other: &mut [Other; 2]) {
        let draw = |other: &mut Other, view: Option<View<'_>>| {
            if let Some(view) = view {
                self.draw(view, 0..view.camera.height as i32, &mut other.layers, false);
            }
        };
        let ([after, before], [next, last]) = (views, other);
        rayon::join(|| draw(next, after), || draw(last, before));
    }
}

/// Computes a band's optical flow and its occlusion at the other moments.
fn flow(shot: &Shot<'_>, strip: &mut Strip<'_>, band: &mut Band, other: &[Other; 2]) {
    let Band { layers, runs, motion, faces, .. } = band;
    let (width, seen) = (strip.width, (&*layers, runs.as_slice()));
    let ways = [
        (shot.after, Modality::FlowForward, &mut *strip.flow_forward, &mut *strip.occluded_forward),
        (shot.before, Modality::FlowBackward, &mut *strip.flow_backward, &mut *strip.occluded_backward),
    ];
    for ((then, modality, flow, occluded), other) in ways.into_iter().zip(other) {
        let Some(then) = then else { continue };
        if shot.modalities.has(modality) {
            widest(
                #[inline(always)]
                || labels::flows(shot.view, then, seen, motion, (width, flow)),
            );
        }
        if shot.modalities.has(Modality::Occlusion) {
            labels::hidden(shot.view, then, seen, (motion, faces, other), (width, occluded));
        }
    }
}

/// Number of bands for an image: one on a single thread, and none lower than 32 rows.
fn count(height: u32) -> usize {
    let threads = rayon::current_num_threads();
    let most = if threads == 1 { 1 } else { 2 * threads };
    most.min(height as usize / 32).max(1)
}
