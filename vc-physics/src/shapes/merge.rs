//! Fewer pieces where an asset has too many.
//!
//! Of the pieces the two are joined whose common box wastes the least volume, until
//! few enough are left; that box is the joint piece. (A hull would be tighter, but of a
//! face with many corners the engine sees only four, and those side by side: what stands
//! on it sinks in.) No joint piece may reach into the free space above a surface
//! that holds things, so that shelves stay open.

use nalgebra::{Point3, Vector3};
use vc_graph::asset::Surface;

use super::hollow;
use super::piece::Piece;

/// Most pieces a moving link of an asset has.
pub(crate) const MOST: usize = 24;
/// Most pieces that are looked at for joining; of more, the smallest are left out.
const LOOKED_AT: usize = 256;

/// Least and largest corner.
pub(super) type Box3 = (Point3<f32>, Point3<f32>);

/// [`MOST`] pieces or little more; what is few enough stays as it is. Costs about
/// the square of the pieces.
pub(crate) fn merged(pieces: Vec<Piece>, surfaces: &[Surface]) -> Vec<Piece> {
    if pieces.len() <= MOST {
        return pieces;
    }
    let mut groups: Vec<Group> = pieces.into_iter().map(Group::of).collect();
    groups.sort_by(|a, b| b.volume.total_cmp(&a.volume));
    groups.truncate(LOOKED_AT);
    let mut pool = Pool::new(groups, surfaces.iter().filter_map(free_space).collect());
    while pool.groups.len() > MOST && pool.join_cheapest() {}
    // What still is too much are the smallest pieces.
    let mut groups = pool.groups;
    groups.sort_by(|a, b| b.volume.total_cmp(&a.volume));
    groups.truncate(MOST * 2);
    groups.into_iter().filter_map(Group::piece).collect()
}

/// Groups, for each the waste of its best partner and which that is, and the boxes
/// that must stay free.
struct Pool {
    groups: Vec<Group>,
    best: Vec<Option<(f32, usize)>>,
    free: Vec<Box3>,
}

impl Pool {
    fn new(groups: Vec<Group>, free: Vec<Box3>) -> Self {
        let mut pool = Self { best: vec![None; groups.len()], groups, free };
        (0..pool.groups.len()).for_each(|i| pool.find_best(i));
        pool
    }

    /// How much volume two groups waste together; `None` if their box reaches into a space that
    /// must stay free. That is looked at where it is less than some other waste only.
    fn waste(&self, a: usize, b: usize, less_than: f32) -> Option<f32> {
        let (a, b) = (&self.groups[a], &self.groups[b]);
        let joint = around(a.extent, b.extent);
        let waste = volume(joint) - a.volume - b.volume;
        (waste < less_than && !self.free.iter().any(|f| overlap(*f, joint))).then_some(waste)
    }

    /// The partner with which a group wastes the least volume, and how much that is.
    fn find_best(&mut self, of: usize) {
        let mut best: Option<(f32, usize)> = None;
        for i in (0..self.groups.len()).filter(|&i| i != of) {
            let least = best.map_or(f32::INFINITY, |(least, _)| least);
            best = self.waste(of, i, least).map(|waste| (waste, i)).or(best);
        }
        self.best[of] = best;
    }

    /// Joins the two that waste least; `false` if none may be joined.
    fn join_cheapest(&mut self) -> bool {
        let all = self.best.iter().enumerate().filter_map(|(i, b)| b.map(|(waste, j)| (waste, i, j)));
        let Some((_, a, b)) = all.min_by(|x, y| x.0.total_cmp(&y.0)) else { return false };
        let (keep, gone) = (a.min(b), a.max(b));
        let other = self.groups.swap_remove(gone);
        self.best.swap_remove(gone);
        self.groups[keep].join(&other);
        self.find_best(keep);
        for i in (0..self.groups.len()).filter(|&i| i != keep) {
            self.follow(i, keep, gone);
        }
        true
    }

    /// Sees to a group's partner after one group has grown by another, in whose place is the
    /// last one now. Who had no partner has none: what has grown is where each of the two was.
    fn follow(&mut self, of: usize, grown: usize, gone: usize) {
        let Some((least, partner)) = self.best[of] else { return };
        let lost = partner == grown || partner == gone;
        let least = if lost { least.next_up() } else { least };
        if let Some(waste) = self.waste(of, grown, least) {
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
    extent: Box3,
    volume: f32,
}

impl Group {
    fn of(piece: Piece) -> Self {
        let extent = piece.extent();
        Self { extent, volume: volume(extent), first: Some(piece) }
    }

    fn join(&mut self, other: &Self) {
        self.first = None;
        self.extent = around(self.extent, other.extent);
        self.volume = volume(self.extent);
    }

    fn piece(self) -> Option<Piece> {
        self.first.or_else(|| Piece::hull(&[self.extent.0, self.extent.1], &Vector3::z()))
    }
}

/// The middle of the space above a surface, a little in from its edges.
fn free_space(surface: &Surface) -> Option<Box3> {
    let (low, high) = hollow::space(surface)?;
    let size = high - low;
    let edge = Vector3::new(0.05 * size.x, 0.05 * size.y, 0.1 * size.z);
    Some((low + edge.inf(&Vector3::new(f32::INFINITY, f32::INFINITY, 0.01)), high - edge))
}

fn around(a: Box3, b: Box3) -> Box3 {
    (a.0.inf(&b.0), a.1.sup(&b.1))
}

fn volume((low, high): Box3) -> f32 {
    // A flat piece is not free of cost.
    (high - low).iter().map(|side| side.max(0.001)).product()
}

fn overlap(a: Box3, b: Box3) -> bool {
    (0..3).all(|i| a.0[i] < b.1[i] && b.0[i] < a.1[i])
}
