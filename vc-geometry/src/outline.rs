//! Convex outlines in the plane, such as the area that a body covers of the floor.
//!
//! ```
//! use nalgebra::Point2;
//! use vc_geometry::outline::{contains, crosses, hull, rectangle};
//! let corners = [(0.0, 0.0), (2.0, 0.0), (1.0, 0.5), (2.0, 1.0), (0.0, 1.0), (1.0, 0.0)];
//! let table = hull(corners.map(|(x, y)| Point2::new(x, y)));
//! assert_eq!(table, rectangle(&Point2::new(0.0, 0.0), &Point2::new(2.0, 1.0)));
//! assert!(contains(&table, &[Point2::new(1.0, 0.5)]));
//! assert!(crosses(&table, &Point2::new(1.0, -1.0), &Point2::new(1.0, 2.0)));
//! ```

use nalgebra::Point2;

/// A convex polygon, counter-clockwise; a point or a segment if it has no area.
pub type Outline = Vec<Point2<f32>>;

/// The convex hull of points (Andrew, "Another efficient algorithm for convex hulls in two dimensions", 1979). It
/// begins with the least X, and the least Y there; points between its corners are left out.
///
/// Costs about `n log n` for `n` points.
///
/// ```
/// use nalgebra::Point2;
/// let points = [(0.0, 0.0), (1.0, 0.0), (0.4, 0.2), (0.0, 1.0)].map(|(x, y)| Point2::new(x, y));
/// assert_eq!(vc_geometry::outline::hull(points), [points[0], points[1], points[3]]);
/// ```
pub fn hull(points: impl IntoIterator<Item = Point2<f32>>) -> Outline {
    let mut all: Outline = points.into_iter().collect();
    all.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    all.dedup();
    if all.len() < 3 {
        return all;
    }
    let mut chain: Outline = Vec::with_capacity(all.len() + 1);
    let mut least = 2;
    for p in all.iter().chain(all.iter().rev().skip(1)) {
        while chain.len() >= least && turn(&chain[chain.len() - 2], &chain[chain.len() - 1], p) <= 0.0 {
            chain.pop();
        }
        chain.push(*p);
        if *p == all[all.len() - 1] && least == 2 {
            least = chain.len() + 1;
        }
    }
    chain.pop();
    chain
}

/// Twice the area of a triangle; positive if its corners turn left, that is counter-clockwise.
///
/// ```
/// use nalgebra::Point2;
/// let (a, b, c) = (Point2::new(0.0, 0.0), Point2::new(2.0, 0.0), Point2::new(0.0, 1.0));
/// assert_eq!(vc_geometry::outline::turn(&a, &b, &c), 2.0);
/// assert_eq!(vc_geometry::outline::turn(&a, &c, &b), -2.0);
/// ```
pub fn turn(a: &Point2<f32>, b: &Point2<f32>, c: &Point2<f32>) -> f32 {
    (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)
}

/// The corners of the rectangle between two corners.
pub fn rectangle(low: &Point2<f32>, high: &Point2<f32>) -> Outline {
    vec![*low, Point2::new(high.x, low.y), *high, Point2::new(low.x, high.y)]
}

/// Whether one convex outline contains another. Costs each corner's test against each side.
///
/// ```
/// use nalgebra::Point2;
/// use vc_geometry::outline::{contains, rectangle};
/// let table = rectangle(&Point2::new(0.0, 0.0), &Point2::new(2.0, 1.0));
/// let plate = rectangle(&Point2::new(0.2, 0.2), &Point2::new(0.4, 0.4));
/// assert!(contains(&table, &plate) && !contains(&plate, &table));
/// ```
pub fn contains(outer: &[Point2<f32>], inner: &[Point2<f32>]) -> bool {
    let edges = || outer.iter().zip(outer.iter().cycle().skip(1));
    outer.len() > 2 && inner.iter().all(|p| edges().all(|(a, b)| turn(a, b, p) >= -1e-7))
}

/// Whether a segment touches a convex outline.
///
/// ```
/// use nalgebra::Point2;
/// use vc_geometry::outline::{crosses, rectangle};
/// let wall = rectangle(&Point2::new(1.0, 0.0), &Point2::new(1.1, 4.0));
/// assert!(crosses(&wall, &Point2::new(0.0, 2.0), &Point2::new(2.0, 2.0)));
/// assert!(!crosses(&wall, &Point2::new(0.0, 5.0), &Point2::new(2.0, 5.0)));
/// // A segment in line with a side is beyond it.
/// assert!(!crosses(&wall, &Point2::new(1.0, 5.0), &Point2::new(1.0, 7.0)));
/// ```
pub fn crosses(outline: &[Point2<f32>], from: &Point2<f32>, to: &Point2<f32>) -> bool {
    let next = outline.iter().cycle().skip(1);
    let edges = outline.iter().zip(next);
    let inside = outline.len() > 2 && edges.clone().all(|(a, b)| turn(a, b, from) >= 0.0);
    inside || edges.into_iter().any(|edge| meet((from, to), edge))
}

/// Whether two segments share a point: their boxes meet, and neither lies on one side of the other's line. The boxes
/// decide where all ends are on one line.
fn meet((from, to): (&Point2<f32>, &Point2<f32>), (a, b): (&Point2<f32>, &Point2<f32>)) -> bool {
    let apart = |p: f32, q: f32| (p > 0.0 && q > 0.0) || (p < 0.0 && q < 0.0);
    let overlap = |i: usize| from[i].min(to[i]) <= a[i].max(b[i]) && a[i].min(b[i]) <= from[i].max(to[i]);
    overlap(0) && overlap(1) && !apart(turn(from, to, a), turn(from, to, b)) && !apart(turn(a, b, from), turn(a, b, to))
}
