//! A tree of boxes for finding what is in a region.

use nalgebra::Vector3;

/// A world-aligned box, metres.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Region {
    pub(crate) low: Vector3<f32>,
    pub(crate) high: Vector3<f32>,
}

impl Region {
    /// A box that nothing meets.
    pub(crate) const EMPTY: Self = Self {
        low: Vector3::new(f32::INFINITY, f32::INFINITY, f32::INFINITY),
        high: Vector3::new(f32::NEG_INFINITY, f32::NEG_INFINITY, f32::NEG_INFINITY),
    };

    #[inline]
    pub(crate) fn meets(&self, other: &Self) -> bool {
        self.meets_in_plan(other) && self.low.z <= other.high.z && self.high.z >= other.low.z
    }

    /// Whether some of one is above or below some of the other.
    #[inline]
    pub(crate) fn meets_in_plan(&self, other: &Self) -> bool {
        (self.low.x <= other.high.x)
            & (self.high.x >= other.low.x)
            & (self.low.y <= other.high.y)
            & (self.high.y >= other.low.y)
    }

    pub(crate) fn contains(&self, other: &Self) -> bool {
        (0..3).all(|i| self.low[i] <= other.low[i] && other.high[i] <= self.high[i])
    }

    /// The square of how far two are apart, square metres.
    #[inline]
    pub(crate) fn distance_squared(&self, other: &Self) -> f32 {
        let apart = |i: usize| (self.low[i] - other.high[i]).max(other.low[i] - self.high[i]).max(0.0);
        let (x, y, z) = (apart(0), apart(1), apart(2));
        x * x + y * y + z * z
    }

    pub(crate) fn joined(&self, other: &Self) -> Self {
        Self { low: self.low.inf(&other.low), high: self.high.sup(&other.high) }
    }

    pub(crate) fn grown(&self, sides: f32, up_and_down: f32) -> Self {
        let by = Vector3::new(sides, sides, up_and_down);
        Self { low: self.low - by, high: self.high + by }
    }
}

/// How many boxes a leaf has.
const LANES: usize = 8;

/// Boxes side by side, so that all are compared at once.
#[derive(Debug, Clone)]
struct Leaf {
    low: [[f32; LANES]; 3],
    high: [[f32; LANES]; 3],
    item: [u32; LANES],
}

impl Leaf {
    const EMPTY: Self =
        Self { low: [[f32::INFINITY; LANES]; 3], high: [[f32::NEG_INFINITY; LANES]; 3], item: [0; LANES] };

    fn put(&mut self, lane: usize, region: &Region) {
        for axis in 0..3 {
            self.low[axis][lane] = region.low[axis];
            self.high[axis][lane] = region.high[axis];
        }
    }

    /// Which of the boxes meet a region: not zero where they do. As wide as the numbers, so
    /// that compilers compare several at once.
    #[inline(always)]
    fn meeting(&self, region: &Region) -> [u32; LANES] {
        let mut meets = [u32::MAX; LANES];
        for axis in 0..3 {
            let (low, high) = (region.low[axis], region.high[axis]);
            for (lane, meets) in meets.iter_mut().enumerate() {
                *meets &= u32::from((self.low[axis][lane] <= high) & (self.high[axis][lane] >= low));
            }
        }
        meets
    }

    fn whole(&self) -> Region {
        let least = |axis: usize| self.low[axis].into_iter().fold(f32::INFINITY, f32::min);
        let most = |axis: usize| self.high[axis].into_iter().fold(f32::NEG_INFINITY, f32::max);
        Region { low: Vector3::new(least(0), least(1), least(2)), high: Vector3::new(most(0), most(1), most(2)) }
    }
}

/// A binary tree over boxes, kept as an array: node `i` has the children `2i + 1` and
/// `2i + 2`, the last ones are leaves of eight. Built once by halving at the median of the
/// widest axis; a box that moves keeps its leaf and its ancestors are measured again, so
/// that answers stay exact and only the speed suffers from long ways.
#[derive(Debug, Clone, Default)]
pub(crate) struct Tree {
    nodes: Vec<Region>,
    /// The largest number of a box below each node.
    last: Vec<u32>,
    leaves: Vec<Leaf>,
    /// In which leaf a box is, times [`LANES`], and in which of its lanes.
    slot: Vec<u32>,
}

impl Tree {
    pub(crate) fn new(boxes: &[Region]) -> Self {
        let leaves = boxes.len().div_ceil(LANES).next_power_of_two();
        let mut tree = Self {
            nodes: vec![Region::EMPTY; 2 * leaves - 1],
            last: vec![0; 2 * leaves - 1],
            leaves: vec![Leaf::EMPTY; leaves],
            slot: vec![0; boxes.len()],
        };
        let middle = |(item, b): (usize, &Region)| (b.low + b.high, item as u32);
        let mut order: Vec<_> = boxes.iter().enumerate().map(middle).collect();
        tree.place(boxes, &mut order, 0, leaves);
        for node in (0..tree.first()).rev() {
            tree.measure(node);
            tree.last[node] = tree.last[2 * node + 1].max(tree.last[2 * node + 2]);
        }
        tree
    }

    /// Number of the first leaf among the nodes.
    fn first(&self) -> usize {
        self.leaves.len().saturating_sub(1)
    }

    /// Puts boxes, each with its middle, into as many leaves from `start` on, halving both.
    fn place(&mut self, boxes: &[Region], order: &mut [(Vector3<f32>, u32)], start: usize, leaves: usize) {
        if leaves == 1 {
            for (lane, &(_, item)) in order.iter().enumerate() {
                self.leaves[start].put(lane, &boxes[item as usize]);
                self.leaves[start].item[lane] = item;
                self.slot[item as usize] = (start * LANES + lane) as u32;
            }
            let node = self.first() + start;
            self.nodes[node] = self.leaves[start].whole();
            self.last[node] = order.iter().map(|o| o.1).max().unwrap_or(0);
            return;
        }
        let half = order.len().div_ceil(2);
        if half < order.len() {
            let axis = widest(order);
            order.select_nth_unstable_by(half, |a, b| a.0[axis].total_cmp(&b.0[axis]).then(a.1.cmp(&b.1)));
        }
        let (left, right) = order.split_at_mut(half);
        self.place(boxes, left, start, leaves / 2);
        self.place(boxes, right, start + leaves / 2, leaves / 2);
    }

    fn measure(&mut self, node: usize) {
        self.nodes[node] = self.nodes[2 * node + 1].joined(&self.nodes[2 * node + 2]);
    }

    /// A box has moved.
    pub(crate) fn set(&mut self, item: usize, to: Region) {
        let slot = self.slot[item] as usize;
        let leaf = slot / LANES;
        self.leaves[leaf].put(slot % LANES, &to);
        let mut node = self.first() + leaf;
        self.nodes[node] = self.leaves[leaf].whole();
        while node > 0 {
            node = (node - 1) / 2;
            self.measure(node);
        }
    }

    /// Calls `found` with every box that meets a region, in no useful order.
    #[inline]
    pub(crate) fn each(&self, region: &Region, found: impl FnMut(usize)) {
        self.each_from(0, region, found);
    }

    /// The same for boxes from a number on.
    #[inline]
    pub(crate) fn each_from(&self, from: usize, region: &Region, mut found: impl FnMut(usize)) {
        // A path is at most 32 deep and leaves one sibling at each depth.
        let mut stack = [0_u32; 40];
        let mut top = usize::from(!self.nodes.is_empty());
        let first = self.first();
        while top > 0 {
            top -= 1;
            let node = stack[top] as usize;
            if (self.last[node] as usize) < from || !self.nodes[node].meets(region) {
                continue;
            }
            if node >= first {
                let leaf = &self.leaves[node - first];
                let meets = leaf.meeting(region);
                let items = (0..LANES).filter(|&lane| meets[lane] != 0).map(|lane| leaf.item[lane] as usize);
                items.filter(|&item| item >= from).for_each(&mut found);
                continue;
            }
            stack[top] = 2 * node as u32 + 2;
            stack[top + 1] = 2 * node as u32 + 1;
            top += 2;
        }
    }
}

/// The axis along which middles are spread most. Those of nodes without a place are no
/// numbers: comparisons pass them over.
fn widest(order: &[(Vector3<f32>, u32)]) -> usize {
    let (mut low, mut high) = (Region::EMPTY.low, Region::EMPTY.high);
    for (middle, _) in order {
        for axis in 0..3 {
            low[axis] = if middle[axis] < low[axis] { middle[axis] } else { low[axis] };
            high[axis] = if middle[axis] > high[axis] { middle[axis] } else { high[axis] };
        }
    }
    (high - low).imax()
}
