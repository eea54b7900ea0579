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
        self.low.x <= other.high.x
            && self.high.x >= other.low.x
            && self.low.y <= other.high.y
            && self.high.y >= other.low.y
            && self.low.z <= other.high.z
            && self.high.z >= other.low.z
    }

    pub(crate) fn joined(&self, other: &Self) -> Self {
        Self { low: self.low.inf(&other.low), high: self.high.sup(&other.high) }
    }

    pub(crate) fn grown(&self, sides: f32, up_and_down: f32) -> Self {
        let by = Vector3::new(sides, sides, up_and_down);
        Self { low: self.low - by, high: self.high + by }
    }
}

/// A binary tree over boxes, kept as an array: node `i` has the children `2i + 1` and
/// `2i + 2`. Built once by halving at the median of the widest axis; a box that moves
/// keeps its leaf and its ancestors are measured again, so that answers stay exact and
/// only the speed suffers from long ways.
#[derive(Debug, Clone, Default)]
pub(crate) struct Tree {
    nodes: Vec<Region>,
    /// Which box is at a leaf, and which leaf has a box.
    item: Vec<u32>,
    leaf: Vec<u32>,
    /// Number of the first leaf.
    first: usize,
}

impl Tree {
    pub(crate) fn new(boxes: &[Region]) -> Self {
        let first = boxes.len().next_power_of_two() - 1;
        let mut tree = Self {
            nodes: vec![Region::EMPTY; 2 * first + 1],
            item: vec![u32::MAX; first + 1],
            leaf: vec![0; boxes.len()],
            first,
        };
        let mut order: Vec<u32> = (0..boxes.len() as u32).collect();
        tree.place(boxes, &mut order, 0, first + 1);
        for node in (0..first).rev() {
            tree.measure(node);
        }
        tree
    }

    /// Puts boxes into the leaves from `start` on, halving both.
    fn place(&mut self, boxes: &[Region], order: &mut [u32], start: usize, room: usize) {
        if order.len() <= 1 || room == 1 {
            for (slot, &item) in order.iter().enumerate() {
                self.item[start + slot] = item;
                self.leaf[item as usize] = (start + slot) as u32;
                self.nodes[self.first + start + slot] = boxes[item as usize];
            }
            return;
        }
        let middle = |i: u32| boxes[i as usize].low + boxes[i as usize].high;
        let spread = order.iter().fold(Region::EMPTY, |r, &i| {
            let at = middle(i);
            r.joined(&Region { low: at, high: at })
        });
        let axis = (spread.high - spread.low).imax();
        let half = order.len().div_ceil(2);
        order.select_nth_unstable_by(half - 1, |&a, &b| middle(a)[axis].total_cmp(&middle(b)[axis]).then(a.cmp(&b)));
        let (left, right) = order.split_at_mut(half);
        self.place(boxes, left, start, room / 2);
        self.place(boxes, right, start + room / 2, room / 2);
    }

    fn measure(&mut self, node: usize) {
        self.nodes[node] = self.nodes[2 * node + 1].joined(&self.nodes[2 * node + 2]);
    }

    /// A box has moved.
    pub(crate) fn set(&mut self, item: usize, to: Region) {
        let mut node = self.first + self.leaf[item] as usize;
        self.nodes[node] = to;
        while node > 0 {
            node = (node - 1) / 2;
            self.measure(node);
        }
    }

    /// Calls `found` with every box that meets a region, in no useful order.
    #[inline]
    pub(crate) fn each(&self, region: &Region, mut found: impl FnMut(usize)) {
        // A path is at most 32 deep and leaves one sibling at each depth.
        let mut stack = [0_u32; 40];
        let mut top = usize::from(!self.nodes.is_empty());
        while top > 0 {
            top -= 1;
            let node = stack[top] as usize;
            if !self.nodes[node].meets(region) {
                continue;
            }
            if node >= self.first {
                let item = self.item[node - self.first];
                if item != u32::MAX {
                    found(item as usize);
                }
                continue;
            }
            stack[top] = 2 * node as u32 + 2;
            stack[top + 1] = 2 * node as u32 + 1;
            top += 2;
        }
    }
}
