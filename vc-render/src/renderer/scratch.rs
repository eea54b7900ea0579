//! Working memory of rendering, kept from picture to picture.

use std::ops::Range;
use std::sync::{Mutex, MutexGuard, PoisonError};

use crate::frame::{Frame, Strip};
use crate::labels::{Faces, Motions, Other, Run, Tally};
use crate::rasterization::Layers;
use crate::shading::{self, Openness, Smoother};

/// Working memory for one picture.
#[derive(Default)]
pub(super) struct Scratch {
    pub(super) bands: Bands,
    /// The moments after and before.
    pub(super) others: [Other; 2],
    /// A visibility buffer for one object at a time.
    pub(super) alone: Layers,
    pub(super) tallies: Vec<Tally>,
    pub(super) openness: Openness,
    pub(super) smoother: Smoother,
    /// Supersampled colours, before they are shrunk.
    pub(super) finer: Frame,
}

/// Working memory for a band of rows.
#[derive(Default)]
pub(super) struct Band {
    pub(super) rows: Range<i32>,
    pub(super) layers: Layers,
    pub(super) runs: Vec<Run>,
    pub(super) motion: Motions,
    pub(super) faces: Faces,
    pub(super) shading: shading::Scratch,
}

/// Bands of a picture, from the top; a picture of fewer bands leaves the memory of the others unused.
#[derive(Default)]
pub(super) struct Bands {
    all: Vec<Band>,
    count: usize,
}

impl Bands {
    /// Takes a number of bands into use.
    pub(super) fn prepare(&mut self, count: usize) {
        self.count = count;
        self.all.resize_with(count.max(self.all.len()), Band::default);
    }

    pub(super) fn in_use(&self) -> &[Band] {
        &self.all[..self.count]
    }

    pub(super) fn in_use_mut(&mut self) -> &mut [Band] {
        &mut self.all[..self.count]
    }
}

/// Splits a strip and its bands into an upper and a lower half, at a row where the grid of light samples may
/// start.
pub(super) fn halves<'a, 'b>(strip: Strip<'a>, bands: &'b mut [Band]) -> [(Strip<'a>, &'b mut [Band]); 2] {
    let middle = bands.len() / 2;
    let rows = strip.rows.len() * middle / bands.len() / shading::ALIGNED * shading::ALIGNED;
    let (upper, lower) = strip.split(rows as i32);
    let (first, last) = bands.split_at_mut(middle);
    [(upper, first), (lower, last)]
}

/// Working memory that no picture uses at the moment.
#[derive(Default)]
pub(super) struct Pool(Mutex<Vec<Scratch>>);

impl Pool {
    /// Runs work with working memory of its own.
    pub(super) fn with<R>(&self, work: impl FnOnce(&mut Scratch) -> R) -> R {
        let mut scratch = self.free().pop().unwrap_or_default();
        let result = work(&mut scratch);
        self.free().push(scratch);
        result
    }

    fn free(&self) -> MutexGuard<'_, Vec<Scratch>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl std::fmt::Debug for Pool {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Pool").finish_non_exhaustive()
    }
}
