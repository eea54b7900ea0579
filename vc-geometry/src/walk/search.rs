//! The shortest any-angle path over bands.
//!
//! Polyanya (Cui, Harabor and Grastien, "Compromise-free pathfinding on a navigation mesh", IJCAI 2017) on a
//! mesh of rectangles that are connected only upwards and downwards. A search node is an interval of a
//! horizontal line that is visible from a root: the last corner at which the path has turned. The path found is
//! a shortest one.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use super::bands::Bands;

/// A point in units of cells.
pub type CellPoint = (f64, f64);

/// A part of a horizontal line that is visible from a root.
#[derive(Clone, Copy)]
struct Node {
    root: CellPoint,
    /// Length of the path to the root.
    cost: f64,
    y: f64,
    left: f64,
    right: f64,
    /// The band that the node leads into, and the one it comes from.
    into: u32,
    from: u32,
    up: bool,
    parent: u32,
    /// The number of the root's corner, for finding cheaper paths to it; none for the start.
    corner: u32,
}

/// An entry of the open list: the smallest estimate first, then the oldest.
struct Open {
    estimate: f64,
    node: u32,
    /// Whether it is the goal itself, reached from the node.
    goal: bool,
}

impl PartialEq for Open {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Open {}

impl PartialOrd for Open {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Open {
    fn cmp(&self, other: &Self) -> Ordering {
        other.estimate.total_cmp(&self.estimate).then(self.goal.cmp(&other.goal)).then(other.node.cmp(&self.node))
    }
}

const NONE: u32 = u32::MAX;
/// Smaller differences of lengths do not count, cells.
const TINY: f64 = 1e-9;

struct Search<'a> {
    bands: &'a Bands,
    goal: CellPoint,
    goal_band: u32,
    nodes: Vec<Node>,
    open: BinaryHeap<Open>,
    /// The cheapest path so far to each band's four corners.
    best: Vec<f64>,
}

/// The corners of the shortest path between two points, both included, and its length in cells; `None` if there
/// is none. Both points have to be in free cells.
///
/// Costs some ten microseconds in a home: each gate is met a few times.
///
/// ```
/// use vc_geometry::grid::BitGrid;
/// use vc_geometry::walk::{Bands, shortest};
/// let mut free = BitGrid::new(20, 10);
/// free.fill((0, 9), (0, 10), true);
/// free.fill((11, 20), (0, 10), true);
/// assert!(shortest(&Bands::new(&free), (2.0, 2.0), (15.0, 2.0)).is_none()); // There is no way across.
/// ```
pub fn shortest(bands: &Bands, start: CellPoint, goal: CellPoint) -> Option<(Vec<CellPoint>, f64)> {
    let band = |p: CellPoint| bands.at(p.0.max(0.0) as usize, p.1.max(0.0) as usize);
    let (start_band, goal_band) = (band(start)?, band(goal)?);
    if start_band == goal_band {
        return Some((vec![start, goal], distance(start, goal)));
    }
    let best = vec![f64::INFINITY; bands.all.len() * 4];
    let mut search = Search { bands, goal, goal_band, nodes: Vec::with_capacity(256), open: BinaryHeap::new(), best };
    search.begin(start, start_band);
    while let Some(next) = search.open.pop() {
        if next.goal {
            return Some((search.way(next.node, start), next.estimate));
        }
        search.expand(next.node);
    }
    None
}

impl Search<'_> {
    fn begin(&mut self, start: CellPoint, band: u32) {
        for up in [false, true] {
            for gate in self.bands.gates(band, up) {
                let node = Node {
                    root: start,
                    cost: 0.0,
                    y: self.side(band, up),
                    left: f64::from(gate.from),
                    right: f64::from(gate.to),
                    into: gate.band,
                    from: band,
                    up,
                    parent: NONE,
                    corner: NONE,
                };
                self.push(node);
            }
        }
    }

    /// The height of a band's upper or lower side.
    fn side(&self, band: u32, up: bool) -> f64 {
        let band = &self.bands.all[band as usize];
        f64::from(if up { band.y1 } else { band.y0 })
    }

    fn push(&mut self, node: Node) {
        if node.corner != NONE {
            let best = &mut self.best[node.corner as usize];
            if node.cost > *best + TINY {
                return;
            }
            *best = best.min(node.cost);
        }
        let estimate = node.cost + estimate(&node, self.goal);
        self.nodes.push(node);
        self.open.push(Open { estimate, node: self.nodes.len() as u32 - 1, goal: false });
    }

    fn expand(&mut self, index: u32) {
        let node = self.nodes[index as usize];
        if node.corner != NONE && node.cost > self.best[node.corner as usize] + TINY {
            return;
        }
        if node.into == self.goal_band {
            let (_, length) = through(&node, self.goal);
            self.open.push(Open { estimate: node.cost + length, node: index, goal: true });
            return;
        }
        self.go_on(index, &node);
        self.turn_back(index, &node);
    }

    /// Continues across the far side of the band: the part that the root sees, and the parts around the corners
    /// at the ends of the interval.
    fn go_on(&mut self, index: u32, node: &Node) {
        let far = self.side(node.into, node.up);
        let (seen_left, seen_right) = self.seen(node, far);
        let (left, right) = (self.corner_at(node, true), self.corner_at(node, false));
        for gate in self.bands.gates(node.into, node.up) {
            let (from, to) = (f64::from(gate.from), f64::from(gate.to));
            let next = |l: f64, r: f64, root: CellPoint, cost: f64, corner: u32| Node {
                root,
                cost,
                y: far,
                left: l,
                right: r,
                into: gate.band,
                from: node.into,
                up: node.up,
                parent: index,
                corner,
            };
            let (l, r) = (from.max(seen_left), to.min(seen_right));
            if l < r {
                self.push(next(l, r, node.root, node.cost, node.corner));
            }
            if let Some((root, corner)) = left.filter(|_| from < seen_left) {
                self.push(next(from, to.min(seen_left), root, node.cost + distance(node.root, root), corner));
            }
            if let Some((root, corner)) = right.filter(|_| to > seen_right) {
                self.push(next(from.max(seen_right), to, root, node.cost + distance(node.root, root), corner));
            }
        }
    }

    /// The part of a horizontal line that the root sees through the interval.
    fn seen(&self, node: &Node, far: f64) -> (f64, f64) {
        let band = &self.bands.all[node.into as usize];
        let (x0, x1) = (f64::from(band.x0), f64::from(band.x1));
        let rise = node.y - node.root.1;
        if rise.abs() < TINY {
            // The root is on the line, at an end of the interval, and sees everything.
            return (x0, x1);
        }
        let at = |x: f64| node.root.0 + (x - node.root.0) * ((far - node.root.1) / rise);
        (at(node.left).clamp(x0, x1), at(node.right).clamp(x0, x1))
    }

    /// The end of an interval as a turning corner: there one of the two adjacent bands ends, and the other does
    /// not.
    fn corner_at(&self, node: &Node, left: bool) -> Option<(CellPoint, u32)> {
        let (from, into) = (&self.bands.all[node.from as usize], &self.bands.all[node.into as usize]);
        let (a, b, end) = if left { (from.x0, into.x0, node.left) } else { (from.x1, into.x1, node.right) };
        let shorter = if left { a > b } else { a < b };
        let at = f64::from(if shorter { a } else { b });
        let number = if shorter { corner(node.from, left, node.up) } else { corner(node.into, left, !node.up) };
        (a != b && end == at).then_some(((at, node.y), number))
    }

    /// Turns back across the near side, around the obstacle between two bands: along the line to the near end
    /// of another gate.
    fn turn_back(&mut self, index: u32, node: &Node) {
        for left in [true, false] {
            let Some((turn, _)) = self.corner_at(node, left) else { continue };
            let cost = node.cost + distance(node.root, turn);
            for gate in self.bands.gates(node.into, !node.up) {
                let (from, to) = (f64::from(gate.from), f64::from(gate.to));
                let end = if left { to } else { from };
                if gate.band == node.from || (left && end > turn.0) || (!left && end < turn.0) {
                    continue;
                }
                self.push(Node {
                    root: (end, node.y),
                    cost: cost + (end - turn.0).abs(),
                    y: node.y,
                    left: from,
                    right: to,
                    into: gate.band,
                    from: node.into,
                    up: !node.up,
                    parent: index,
                    corner: corner(gate.band, !left, node.up),
                });
            }
        }
    }

    /// The corners of the path that ends with a node.
    fn way(&self, last: u32, start: CellPoint) -> Vec<CellPoint> {
        let mut corners = vec![self.goal];
        let mut index = last;
        if let (Some(turn), _) = through(&self.nodes[last as usize], self.goal) {
            corners.push(turn);
        }
        while index != NONE {
            let node = &self.nodes[index as usize];
            // A path back along a line turns at both of its ends.
            let parent = self.nodes.get(node.parent as usize);
            for point in std::iter::once(node.root).chain(parent.and_then(|p| self.bend(p, node))) {
                if corners.last() != Some(&point) {
                    corners.push(point);
                }
            }
            index = node.parent;
        }
        if corners.last() != Some(&start) {
            corners.push(start);
        }
        corners.reverse();
        corners
    }

    /// Where the path from a node's root to the next root turns at the interval.
    fn bend(&self, node: &Node, next: &Node) -> Option<CellPoint> {
        let back = next.up != node.up;
        back.then_some((if next.root.0 <= node.left { node.left } else { node.right }, node.y))
    }
}

/// The number of a corner of a band.
fn corner(band: u32, left: bool, up: bool) -> u32 {
    band * 4 + u32::from(left) * 2 + u32::from(up)
}

/// A lower bound on the path from a node's root through its interval to the goal. A goal on the root's side is
/// mirrored at the line.
fn estimate(node: &Node, goal: CellPoint) -> f64 {
    let behind = if node.up { goal.1 < node.y } else { goal.1 > node.y };
    let target = if behind { (goal.0, 2.0 * node.y - goal.1) } else { goal };
    through(node, target).1
}

/// The path from a node's root through its interval to a point beyond: its turning point, if any, and its
/// length.
fn through(node: &Node, to: CellPoint) -> (Option<CellPoint>, f64) {
    let rise = to.1 - node.root.1;
    let x = if rise.abs() < TINY { to.0 } else { node.root.0 + (to.0 - node.root.0) * ((node.y - node.root.1) / rise) };
    if node.left <= x && x <= node.right {
        return (None, distance(node.root, to));
    }
    let turn = (x.clamp(node.left, node.right), node.y);
    (Some(turn), distance(node.root, turn) + distance(turn, to))
}

fn distance(a: CellPoint, b: CellPoint) -> f64 {
    let (x, y) = (a.0 - b.0, a.1 - b.1);
    (x * x + y * y).sqrt()
}
