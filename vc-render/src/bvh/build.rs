//! Building of trees by the surface area heuristic over bins (Wald 2007).

use super::tree::{Bvh, EMPTY, LEAF, Leaf, Node, WIDE};
use crate::math::{self, three};

/// A triangle's corners.
pub(crate) type Corners = [[f32; 3]; 3];

/// Number of bins, at whose borders a set may be split.
const BINS: usize = 12;

/// From this depth on, sets are split into equal parts, so that a tree has few further levels whatever the
/// triangles.
const DEEP: usize = 16;

/// Greatest number of levels of a tree: below `DEEP`, each level has eighths of the set above it, and there are
/// fewer than 2^32 triangles.
pub(super) const LEVELS: usize = DEEP + 11;

#[derive(Clone, Copy)]
struct Bounds {
    low: [f32; 3],
    high: [f32; 3],
}

/// A triangle or box to be put into a leaf.
#[derive(Clone, Copy)]
struct Item {
    bounds: Bounds,
    middle: [f32; 3],
    number: u32,
}

const NOWHERE: Bounds = Bounds { low: [f32::INFINITY; 3], high: [f32::NEG_INFINITY; 3] };

impl Bounds {
    fn with(self, other: &Self) -> Self {
        Self { low: three(|i| self.low[i].min(other.low[i])), high: three(|i| self.high[i].max(other.high[i])) }
    }

    fn around(items: &[Item]) -> Self {
        items.iter().fold(NOWHERE, |all, item| all.with(&item.bounds))
    }

    fn area(&self) -> f32 {
        let [x, y, z] = three(|i| (self.high[i] - self.low[i]).max(0.0));
        x * y + y * z + z * x
    }
}

impl Bvh {
    /// Builds the tree of some triangles; a triangle's number is its index. Takes about a microsecond for each
    /// triangle.
    pub(crate) fn build(triangles: &[Corners]) -> Self {
        let mut leaves = Vec::new();
        let item = |(corners, number): (&Corners, u32)| {
            let around = |b: Bounds, p: &[f32; 3]| b.with(&Bounds { low: *p, high: *p });
            let bounds = corners.iter().fold(NOWHERE, around);
            let middle = three(|i| 0.5 * (bounds.low[i] + bounds.high[i]));
            Item { bounds, middle, number }
        };
        let mut items: Vec<Item> = triangles.iter().zip(0..).map(item).collect();
        let nodes = grown(&mut items, WIDE, |items| {
            leaves.push(Leaf::new(items, triangles));
            LEAF | (leaves.len() as u32 - 1)
        });
        Self { nodes, leaves }
    }
}

/// Builds nodes over boxes; a leaf holds the number given with its box.
pub(crate) fn over(boxes: impl Iterator<Item = (u32, math::Bounds)>) -> Vec<Node> {
    let item = |(number, around): (u32, math::Bounds)| {
        let (middle, half) = (around.centre, around.half);
        let side = |sign: f32| three(|i| middle[i] + sign * half[i]);
        Item { bounds: Bounds { low: side(-1.0), high: side(1.0) }, middle, number }
    };
    let mut items: Vec<Item> = boxes.map(item).collect();
    grown(&mut items, 1, |items| LEAF | items[0].number)
}

/// Builds nodes over items; `leaf` makes a leaf of at most `fill` of them.
fn grown(items: &mut [Item], fill: usize, leaf: impl FnMut(&[Item]) -> u32) -> Vec<Node> {
    let mut growth = Growth { nodes: Vec::new(), fill, leaf };
    if !items.is_empty() {
        growth.node(items, 0);
    }
    growth.nodes
}

/// A tree under construction.
struct Growth<F> {
    nodes: Vec<Node>,
    fill: usize,
    leaf: F,
}

impl<F: FnMut(&[Item]) -> u32> Growth<F> {
    fn node(&mut self, items: &mut [Item], depth: usize) -> u32 {
        let fill = self.fill;
        let at = self.nodes.len();
        // No ray hits a box whose end is before its start.
        let (low, high) = ([f32::INFINITY; WIDE], [f32::NEG_INFINITY; WIDE]);
        self.nodes.push(Node { bounds: [low, low, low, high, high, high], children: [EMPTY; WIDE] });
        let mut sets: Vec<&mut [Item]> = vec![items];
        while sets.len() < WIDE {
            let size = |s: &&mut [Item]| match s.len() {
                few if few <= fill => -1.0,
                many if depth >= DEEP => many as f32,
                _ => Bounds::around(s).area(),
            };
            let widest = (0..sets.len()).max_by(|a, b| size(&sets[*a]).total_cmp(&size(&sets[*b])));
            let Some(widest) = widest.filter(|w| sets[*w].len() > fill) else { break };
            let set = sets.swap_remove(widest);
            let (low, high) = if depth < DEEP { cut(set) } else { set.split_at_mut(set.len() / 2) };
            sets.extend([low, high]);
        }
        for (lane, set) in sets.into_iter().enumerate() {
            let bounds = Bounds::around(set);
            let child = if set.len() <= fill { (self.leaf)(set) } else { self.node(set, depth + 1) };
            let node = &mut self.nodes[at];
            node.children[lane] = child;
            for axis in 0..3 {
                node.bounds[axis][lane] = bounds.low[axis];
                node.bounds[axis + 3][lane] = bounds.high[axis];
            }
        }
        at as u32
    }
}

impl Leaf {
    fn new(items: &[Item], triangles: &[Corners]) -> Self {
        // No ray hits a triangle of NaN.
        let none = [[f32::NAN; WIDE]; 3];
        let mut leaf = Self { corner: none, edges: [none; 2], numbers: [EMPTY; WIDE] };
        for (lane, item) in items.iter().enumerate() {
            let [a, b, c] = triangles[item.number as usize];
            leaf.numbers[lane] = item.number;
            for axis in 0..3 {
                leaf.corner[axis][lane] = a[axis];
                leaf.edges[0][axis][lane] = b[axis] - a[axis];
                leaf.edges[1][axis][lane] = c[axis] - a[axis];
            }
        }
        leaf
    }
}

/// Splits a set where the surface areas of both sides, weighted by their numbers of leaves, cost least.
fn cut(items: &mut [Item]) -> (&mut [Item], &mut [Item]) {
    let middles = items.iter().fold(NOWHERE, |b, i| b.with(&Bounds { low: i.middle, high: i.middle }));
    let best = (0..3).filter_map(|axis| best_cut(items, &middles, axis)).min_by(|a, b| a.0.total_cmp(&b.0));
    let count = match best {
        Some((_, axis, bin)) => partition(items, |i| bin_of(&middles, axis, i) < bin),
        None => items.len() / 2,
    };
    items.split_at_mut(count)
}

fn bin_of(middles: &Bounds, axis: usize, item: &Item) -> usize {
    let (low, high) = (middles.low[axis], middles.high[axis]);
    (((item.middle[axis] - low) / (high - low) * BINS as f32) as usize).min(BINS - 1)
}

/// Cost, axis and first bin of the second side of the best split.
fn best_cut(items: &[Item], middles: &Bounds, axis: usize) -> Option<(f32, usize, usize)> {
    if middles.high[axis] <= middles.low[axis] {
        return None;
    }
    let mut bins = [(NOWHERE, 0_usize); BINS];
    for item in items {
        let bin = &mut bins[bin_of(middles, axis, item)];
        *bin = (bin.0.with(&item.bounds), bin.1 + 1);
    }
    let side = |part: &[(Bounds, usize)]| {
        let all = part.iter().fold((NOWHERE, 0), |a, b| (a.0.with(&b.0), a.1 + b.1));
        (all.1 > 0).then(|| all.0.area() * all.1.div_ceil(WIDE) as f32)
    };
    (1..BINS)
        .filter_map(|at| Some((side(&bins[..at])? + side(&bins[at..])?, axis, at)))
        .min_by(|a, b| a.0.total_cmp(&b.0))
}

/// Moves the items that satisfy a condition to the front, and returns their number.
fn partition(items: &mut [Item], first: impl Fn(&Item) -> bool) -> usize {
    let mut count = 0;
    for i in 0..items.len() {
        if first(&items[i]) {
            items.swap(i, count);
            count += 1;
        }
    }
    count
}
