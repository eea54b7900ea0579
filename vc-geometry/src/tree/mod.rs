//! Overlaps among many boxes: a tree for one box against many, and a sweep for all pairs of a scene at once.
//!
//! Boxes are compared eight at a time. Pictures have a tree of their own (`vc-render`): it holds triangles, and is
//! descended by bundles of rays.

mod lanes;
mod sweep;

use vc_graph::Aabb;

use crate::order::sorted;
use lanes::{Group, LANES, Probe, grouped};
pub use sweep::OverlappingPairs;

/// A tree over boxes in which every node has eight children, except the last one of a level. A box that moves
/// keeps its place, and the nodes above it are measured again, so that answers stay exact and only the speed
/// suffers if it moves far.
///
/// ```
/// use nalgebra::Point3;
/// use vc_geometry::tree::BoxTree;
/// use vc_graph::Aabb;
/// let cube = |x: f32| Aabb::around(&Point3::new(x, 0.0, 0.0), &Point3::new(x + 1.0, 1.0, 1.0));
/// let mut tree = BoxTree::new(&(0..100).map(|i| cube(2.0 * i as f32)).collect::<Vec<_>>());
/// tree.set(50, cube(0.5));
/// let mut met = Vec::new();
/// tree.for_each(&cube(0.2), |item| met.push(item));
/// met.sort_unstable();
/// assert_eq!(met, [0, 50]);
/// ```
#[derive(Debug, Clone, Default)]
pub struct BoxTree {
    /// Groups of the boxes themselves, then groups of the groups' boxes, up to a single group.
    levels: Vec<Vec<Group>>,
    /// Number of the box at each place of the lowest level.
    items: Vec<u32>,
    /// Place of each box there.
    places: Vec<u32>,
}

impl BoxTree {
    /// The tree of some boxes; a box's number is its index. Takes time as for sorting them.
    pub fn new(boxes: &[Aabb]) -> Self {
        let items = in_tiles(boxes);
        let mut places = vec![0; items.len()];
        items.iter().enumerate().for_each(|(place, &item)| places[item as usize] = place as u32);
        let mut levels = vec![grouped(items.iter().map(|&item| boxes[item as usize]))];
        while let Some(last) = levels.last().filter(|l| l.len() > 1) {
            levels.push(grouped(last.iter().map(Group::whole)));
        }
        Self { levels, items, places }
    }

    /// Updates a box that has moved, in as many steps as the tree has levels.
    pub fn set(&mut self, item: usize, to: Aabb) {
        let Some(&place) = self.places.get(item) else { return };
        let (mut place, mut region) = (place as usize, to);
        for level in &mut self.levels {
            let group = &mut level[place / LANES];
            group.put(place % LANES, &region);
            (place, region) = (place / LANES, group.whole());
        }
    }

    /// Calls `found` with every box that overlaps or touches a region, in unspecified order.
    #[inline]
    pub fn for_each(&self, region: &Aabb, mut found: impl FnMut(usize)) {
        if !self.items.is_empty() {
            self.descend(self.levels.len() - 1, 0, &Probe::new(region), &mut found);
        }
    }

    fn descend(&self, level: usize, group: usize, probe: &Probe, found: &mut impl FnMut(usize)) {
        for lane in self.levels[level][group].meeting(probe) {
            let below = group * LANES + lane;
            if level == 0 {
                found(self.items[below] as usize);
            } else {
                self.descend(level - 1, below, probe, found);
            }
        }
    }
}

/// Orders boxes so that every eight, and every eight of those, are close together: strips along X, each sorted
/// along Y (sort-tile-recursive; Leutenegger, Edgington and Lopez 1997).
fn in_tiles(boxes: &[Aabb]) -> Vec<u32> {
    let middle = |item: u32, axis: usize| boxes[item as usize].min[axis] + boxes[item as usize].max[axis];
    let by = |items: &mut dyn Iterator<Item = u32>, axis: usize| sorted(items.map(|item| (middle(item, axis), item)));
    let strips = (boxes.len().div_ceil(LANES) as f32).sqrt().ceil() as usize;
    let long = boxes.len().div_ceil(LANES).div_ceil(strips.max(1)) * LANES;
    let along_x = by(&mut (0..boxes.len() as u32), 0);
    along_x.chunks(long.max(1)).flat_map(|strip| by(&mut strip.iter().copied(), 1)).collect()
}
