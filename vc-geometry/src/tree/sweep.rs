//! All pairs of overlapping boxes of a scene, found at once.

use vc_graph::Aabb;

use super::lanes::{Group, LANES, Probe, grouped};
use crate::order::sorted;

/// For each box of a scene, the later boxes that it overlaps or touches, by number.
///
/// ```
/// use nalgebra::Point3;
/// use vc_geometry::tree::OverlappingPairs;
/// use vc_graph::Aabb;
/// let cube = |x: f32| Aabb::around(&Point3::new(x, 0.0, 0.0), &Point3::new(x + 1.0, 1.0, 1.0));
/// let overlaps = OverlappingPairs::new(&[cube(0.0), cube(5.0), cube(0.5), cube(1.0)]);
/// assert_eq!((overlaps.partners(0), overlaps.partners(1), overlaps.partners(2)), (&[2, 3][..], &[][..], &[3][..]));
/// assert!(overlaps.partners(4).is_empty());
/// ```
#[derive(Debug)]
pub struct OverlappingPairs {
    /// End of each box's part of the list.
    ends: Vec<u32>,
    others: Vec<u32>,
}

impl OverlappingPairs {
    /// Compares each box with those that begin before it ends along the axis on which the scene is longest:
    /// sort and sweep (Baraff 1992). For boxes spread over a plane, these are about the square root of all.
    pub fn new(boxes: &[Aabb]) -> Self {
        let row = Row::new(boxes);
        let mut pairs = Vec::with_capacity(16 * boxes.len());
        for (place, &one) in row.order.iter().enumerate() {
            row.after(place, &boxes[one as usize], |other| pairs.push((one.min(other), one.max(other))));
        }
        Self::by_first(&pairs, boxes.len())
    }

    fn by_first(pairs: &[(u32, u32)], count: usize) -> Self {
        let mut ends = vec![0; count];
        pairs.iter().for_each(|p| ends[p.0 as usize] += 1);
        let mut sum = 0;
        for end in &mut ends {
            // While the lists are filled, this is the next free place of each.
            sum += std::mem::replace(end, sum);
        }
        let mut others = vec![0; pairs.len()];
        for &(one, other) in pairs {
            let end = &mut ends[one as usize];
            others[*end as usize] = other;
            *end += 1;
        }
        let mut overlaps = Self { ends, others };
        for one in 0..count {
            let range = overlaps.range(one);
            overlaps.others[range].sort_unstable();
        }
        overlaps
    }

    fn range(&self, one: usize) -> std::ops::Range<usize> {
        let end = |number: usize| self.ends.get(number).map_or(0, |&end| end as usize);
        one.checked_sub(1).map_or(0, end)..end(one)
    }

    /// The boxes after one that overlap it, sorted; none for a number beyond the last box.
    pub fn partners(&self, one: usize) -> &[u32] {
        self.others.get(self.range(one)).unwrap_or_default()
    }
}

/// Boxes sorted by their start along an axis.
struct Row {
    axis: usize,
    /// Their numbers.
    order: Vec<u32>,
    /// Their start coordinates.
    starts: Vec<f32>,
    groups: Vec<Group>,
}

impl Row {
    fn new(boxes: &[Aabb]) -> Self {
        let there = || (0..).zip(boxes).filter(|(_, b)| b.min.x <= b.max.x);
        let whole = there().fold(Aabb::EMPTY, |all, (_, b)| all.joined(b));
        let axis = (whole.max - whole.min).imax();
        let order = sorted(there().map(|(item, b)| (b.min[axis], item)));
        let starts = order.iter().map(|&item| boxes[item as usize].min[axis]).collect();
        let groups = grouped(order.iter().map(|&item| boxes[item as usize]));
        Self { axis, order, starts, groups }
    }

    /// Calls `found` with every box after a place that overlaps the one there.
    fn after(&self, place: usize, region: &Aabb, mut found: impl FnMut(u32)) {
        let probe = Probe::new(region);
        let own = place / LANES;
        for lane in self.groups[own].meeting(&probe).after(place % LANES) {
            found(self.order[own * LANES + lane]);
        }
        for group in own + 1..self.groups.len() {
            let start = group * LANES;
            if self.starts[start] > region.max[self.axis] {
                break;
            }
            self.groups[group].meeting(&probe).for_each(|lane| found(self.order[start + lane]));
        }
    }
}
