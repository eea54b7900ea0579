//! Merging of pieces if an asset has too many.
//!
//! Repeatedly, the two pieces whose common bounding box wastes the least volume are merged into that box, until
//! few enough are left. (A hull would be tighter, but the engine uses only four adjacent corners of a face with
//! many: things on it would sink in.) A merged piece never reaches into the free space above a surface that
//! holds things, so that shelves stay open.

use nalgebra::Vector3;
use vc_geometry::order::{greater, lesser};
use vc_graph::Aabb;
use vc_graph::asset::Surface;

use super::hollow;
use super::piece::Piece;

/// The largest number of pieces of an asset's moving link.
pub(crate) const MOST: usize = 24;
/// The largest number of pieces that are considered for merging; beyond it, the smallest are left out.
const LOOKED_AT: usize = 256;

/// The smallest side of a box in its volume, metres, so that flat pieces have a cost.
const THIN: f32 = 0.001;

/// [`MOST`] pieces or a few more; a smaller number stays as it is. Costs about the square of the number of
/// pieces.
pub(crate) fn merged(pieces: Vec<Piece>, surfaces: &[Surface]) -> Vec<Piece> {
    if pieces.len() <= MOST {
        return pieces;
    }
    let mut groups: Vec<Group> = pieces.into_iter().map(Group::of).collect();
    groups.sort_by(|a, b| b.volume.total_cmp(&a.volume));
    groups.truncate(LOOKED_AT);
    let mut pool = Pool::new(groups, surfaces.iter().filter_map(free_space).collect());
    while pool.groups.len() > MOST && pool.join_cheapest() {}
    // If there are still too many pieces, the smallest are dropped.
    let mut groups = pool.groups;
    groups.sort_by(|a, b| b.volume.total_cmp(&a.volume));
    groups.truncate(MOST * 2);
    groups.into_iter().filter_map(Group::piece).collect()
}

/// Groups, for each its best partner and the wasted volume, and the boxes that must stay free.
struct Pool {
    groups: Vec<Group>,
    boxes: Boxes,
    best: Vec<Option<(f32, usize)>>,
    free: Vec<Aabb>,
    /// The wasted volume of each group with the group under consideration.
    wastes: Vec<f32>,
}

/// The groups' boxes as a structure of arrays: the wasted volume with one box is computed for several boxes at
/// once.
#[derive(Default)]
struct Boxes {
    low: [Vec<f32>; 3],
    high: [Vec<f32>; 3],
    volume: Vec<f32>,
}

impl Boxes {
    fn push(&mut self, group: &Group) {
        for axis in 0..3 {
            self.low[axis].push(group.extent.min[axis]);
            self.high[axis].push(group.extent.max[axis]);
        }
        self.volume.push(group.volume);
    }

    fn set(&mut self, at: usize, group: &Group) {
        for axis in 0..3 {
            self.low[axis][at] = group.extent.min[axis];
            self.high[axis][at] = group.extent.max[axis];
        }
        self.volume[at] = group.volume;
    }

    fn swap_remove(&mut self, at: usize) {
        for of in self.low.iter_mut().chain(&mut self.high) {
            of.swap_remove(at);
        }
        self.volume.swap_remove(at);
    }

    /// The wasted volume of every group merged with a given one.
    fn wastes(&self, with: usize, wastes: &mut Vec<f32>) {
        wastes.clear();
        wastes.extend_from_slice(&self.volume);
        let own = self.volume[with];
        // In the order in which `volume` multiplies.
        let side = |axis: usize| {
            let (low, high) = (self.low[axis][with], self.high[axis][with]);
            let ends = self.low[axis].iter().zip(&self.high[axis]);
            ends.map(move |(l, h)| (greater(*h, high) - lesser(*l, low)).max(THIN))
        };
        for (((waste, x), y), z) in wastes.iter_mut().zip(side(0)).zip(side(1)).zip(side(2)) {
            *waste = x * y * z - (*waste + own);
        }
    }
}

impl Pool {
    fn new(groups: Vec<Group>, free: Vec<Aabb>) -> Self {
        let mut boxes = Boxes::default();
        groups.iter().for_each(|g| boxes.push(g));
        let mut pool = Self { best: vec![None; groups.len()], groups, boxes, free, wastes: Vec::new() };
        (0..pool.groups.len()).for_each(|i| pool.find_best(i));
        pool
    }

    /// Whether the common box of two groups leaves the required spaces free.
    fn may_join(&self, a: usize, b: usize) -> bool {
        let joint = self.groups[a].extent.joined(&self.groups[b].extent);
        !self.free.iter().any(|f| overlap(f, &joint))
    }

    /// The partner with which a group wastes the least volume, and that volume. Whether two groups may be
    /// merged is tested only where they waste less than others.
    fn find_best(&mut self, of: usize) {
        let mut wastes = std::mem::take(&mut self.wastes);
        self.boxes.wastes(of, &mut wastes);
        let mut best = (f32::INFINITY, None);
        for (i, &waste) in wastes.iter().enumerate() {
            if waste < best.0 && i != of && self.may_join(of, i) {
                best = (waste, Some(i));
            }
        }
        self.best[of] = best.1.map(|i| (best.0, i));
        self.wastes = wastes;
    }

    /// Merges the two groups that waste the least; `false` if none may be merged.
    fn join_cheapest(&mut self) -> bool {
        let all = self.best.iter().enumerate().filter_map(|(i, b)| b.map(|(waste, j)| (waste, i, j)));
        let Some((_, a, b)) = all.min_by(|x, y| x.0.total_cmp(&y.0)) else { return false };
        let (keep, gone) = (a.min(b), a.max(b));
        let other = self.groups.swap_remove(gone);
        self.best.swap_remove(gone);
        self.boxes.swap_remove(gone);
        self.groups[keep].join(&other);
        self.boxes.set(keep, &self.groups[keep]);
        self.find_best(keep);
        let mut wastes = Vec::with_capacity(self.groups.len());
        self.boxes.wastes(keep, &mut wastes);
        for i in (0..self.groups.len()).filter(|&i| i != keep) {
            self.follow(i, keep, gone, wastes[i]);
        }
        true
    }

    /// Updates a group's partner after one group has grown by another, whose index is now that of the last
    /// group. A group without a partner still has none: the grown group contains both of its predecessors.
    fn follow(&mut self, of: usize, grown: usize, gone: usize, waste: f32) {
        let Some((least, partner)) = self.best[of] else { return };
        let lost = partner == grown || partner == gone;
        let least = if lost { least.next_up() } else { least };
        if waste < least && self.may_join(of, grown) {
            self.best[of] = Some((waste, grown));
        } else if lost {
            self.find_best(of);
        } else if partner == self.groups.len() {
            self.best[of] = Some((least, gone));
        }
    }
}

/// Pieces that become one.
struct Group {
    first: Option<Piece>,
    extent: Aabb,
    volume: f32,
}

impl Group {
    fn of(piece: Piece) -> Self {
        let (min, max) = piece.extent();
        let extent = Aabb { min, max };
        Self { extent, volume: volume(&extent), first: Some(piece) }
    }

    fn join(&mut self, other: &Self) {
        self.first = None;
        self.extent = self.extent.joined(&other.extent);
        self.volume = volume(&self.extent);
    }

    fn piece(self) -> Option<Piece> {
        self.first.or_else(|| Piece::hull(&[self.extent.min, self.extent.max], &Vector3::z()))
    }
}

/// The middle of the space above a surface, a little inside its edges.
fn free_space(surface: &Surface) -> Option<Aabb> {
    let Aabb { min: low, max: high } = hollow::space(surface)?;
    let size = high - low;
    let edge = Vector3::new(0.05 * size.x, 0.05 * size.y, 0.1 * size.z);
    let lifted = edge.inf(&Vector3::new(f32::INFINITY, f32::INFINITY, 0.01));
    Some(Aabb { min: low + lifted, max: high - edge })
}

fn volume(of: &Aabb) -> f32 {
    (of.max - of.min).iter().map(|side| side.max(THIN)).product()
}

/// Whether two boxes have some volume in common.
fn overlap(a: &Aabb, b: &Aabb) -> bool {
    (0..3).all(|i| a.min[i] < b.max[i] && b.min[i] < a.max[i])
}
