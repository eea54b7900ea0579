//! Smoothing: colours are mixed where edges cross pixels.

use crate::colour::{decoded, encoded};
use crate::math::three;
use crate::rasterization::refill;

/// An edge between two pixels of a picture.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Edge {
    /// The pixel into which the other's surface reaches, and that other pixel.
    pub(super) into: u32,
    pub(super) from: u32,
    /// Share of the pixel that the other's surface covers.
    pub(super) share: f32,
    /// The pixel with the nearer body, if they show two bodies.
    pub(super) before: Option<u32>,
}

/// Mixes colours at edges, and keeps its memory.
#[derive(Debug, Default, Clone)]
pub(crate) struct Smoother {
    edges: Vec<Edge>,
    /// Mixing weights of the edges.
    shares: Vec<f32>,
    changes: Vec<[f32; 3]>,
    /// For each column, the last edge across it.
    above: Vec<u32>,
}

impl Edge {
    /// The upper or left one of its pixels.
    fn first(&self) -> u32 {
        self.into.min(self.from)
    }

    /// Share of a pixel that the other's surface covers; negative if it reaches into the other itself.
    fn lost(&self, pixel: u32) -> f32 {
        if self.into == pixel { self.share } else { -self.share }
    }
}

impl Smoother {
    /// Mixes neighbours' colours into pixels, in a picture of this width.
    pub(crate) fn smooth<'a>(&mut self, edges: impl Iterator<Item = &'a [Edge]>, width: usize, rgb: &mut [[u8; 3]]) {
        self.edges.clear();
        self.shares.clear();
        self.changes.clear();
        refill(&mut self.above, u32::MAX, width);
        edges.flatten().for_each(|edge| self.add(*edge, width as u32));
        self.changes.extend(self.edges.iter().zip(&self.shares).map(|(edge, share)| {
            let (own, other) = (decoded(rgb[edge.into as usize]), decoded(rgb[edge.from as usize]));
            three(|i| share * (other[i] - own[i]))
        }));
        for (Edge { into, .. }, change) in self.edges.iter().zip(&self.changes) {
            let own = decoded(rgb[*into as usize]);
            rgb[*into as usize] = encoded(three(|i| (own[i] + change[i]).max(0.0)));
        }
    }

    /// Adds an edge, and looks for the one on the other side of its first pixel.
    fn add(&mut self, edge: Edge, width: u32) {
        let number = self.edges.len();
        self.edges.push(edge);
        self.shares.push(edge.share);
        let step = edge.into.abs_diff(edge.from);
        let before = if step == width {
            std::mem::replace(&mut self.above[(edge.into % width) as usize], number as u32) as usize
        } else {
            number.wrapping_sub(1)
        };
        if let Some(other) = self.edges.get(before)
            && (other.first() + step, other.into.abs_diff(other.from)) == (edge.first(), step)
            && [edge.before, other.before].iter().all(|before| *before != Some(edge.first()))
        {
            self.fade(edge.first(), [before, number]);
        }
    }

    /// Fades a pixel between two edges.
    ///
    /// A feature thinner than a pixel (a groove or bevel on a thing, or a gap between things) is hit by some
    /// pixels and missed by others, and would look like a row of dots. Thin things in front are kept, as they
    /// have labels.
    fn fade(&mut self, pixel: u32, edges: [usize; 2]) {
        let lost = edges.map(|at| self.edges[at].lost(pixel));
        let wide = 1.0 - lost[0] - lost[1];
        if wide >= 1.0 {
            return;
        }
        let kept = (2.0 * wide - 1.0).max(0.0);
        let given = lost.map(|v| v.max(0.0));
        let all = given[0] + given[1];
        for (at, given) in edges.into_iter().zip(given) {
            let more = (1.0 - kept) * (1.0 - all).max(0.0) * given / all;
            self.shares[at] = if given > 0.0 { self.shares[at] + more } else { kept * self.shares[at] };
        }
    }
}
