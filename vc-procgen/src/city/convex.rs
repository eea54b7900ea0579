//! Convex polygons whose sides know what lies beyond them: cutting these stays exact and cannot fail.

use nalgebra::Vector2;
use vc_map::Point;

/// Points nearer than this are one, metres.
const SAME: f64 = 1e-6;

/// The ground beyond a side of a polygon.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Beyond {
    /// A street, by its position in [`CityPlan::streets`](super::CityPlan::streets).
    Street(usize),
    /// A neighbour: another parcel, or the house on it.
    Neighbour,
    /// A court or garden of the same parcel.
    Court,
    /// Another part of the same building.
    Inside,
}

impl Beyond {
    /// Whether a side has daylight.
    pub fn is_open(self) -> bool {
        matches!(self, Self::Street(_) | Self::Court)
    }
}

/// A convex polygon, counter-clockwise; side `i` goes from corner `i` to the next one.
///
/// ```
/// use vc_procgen::city::{Beyond, Convex};
/// let square = Convex::rectangle([0.0, 0.0], [4.0, 2.0], Beyond::Street(3));
/// assert_eq!((square.area(), square.corners().len()), (8.0, 4));
/// assert!(square.contains(&[1.0, 1.0].into(), 0.0));
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Convex {
    corners: Vec<Point>,
    beyond: Vec<Beyond>,
}

impl Convex {
    pub(crate) fn new(corners: Vec<Point>, beyond: Vec<Beyond>) -> Self {
        Self { corners, beyond }
    }

    /// The rectangle between two corners, metres, with the same beyond all sides.
    pub fn rectangle(low: [f64; 2], high: [f64; 2], beyond: Beyond) -> Self {
        let corners = [low, [high[0], low[1]], high, [low[0], high[1]]].map(Point::from);
        Self::new(corners.to_vec(), vec![beyond; 4])
    }

    /// Its corners, counter-clockwise.
    pub fn corners(&self) -> &[Point] {
        &self.corners
    }

    /// Its sides: where each begins and ends, and what lies beyond.
    pub fn sides(&self) -> impl Iterator<Item = (Point, Point, Beyond)> + '_ {
        let ends = self.corners.iter().zip(self.corners.iter().cycle().skip(1));
        ends.zip(&self.beyond).map(|((a, b), beyond)| (*a, *b, *beyond))
    }

    /// The longest side for which something holds of what lies beyond.
    pub(crate) fn longest(&self, of: impl Fn(Beyond) -> bool) -> Option<(Point, Point, Beyond)> {
        let longer =
            |a: &(Point, Point, Beyond), b: &(Point, Point, Beyond)| (a.1 - a.0).norm().total_cmp(&(b.1 - b.0).norm());
        self.sides().filter(|side| of(side.2)).max_by(longer)
    }

    /// Its area, square metres.
    pub fn area(&self) -> f64 {
        area(&self.corners)
    }

    /// The middle of its area.
    pub fn middle(&self) -> Point {
        let origin = self.corners[0];
        let weighted = self.sides().fold((Vector2::zeros(), 0.0), |(sum, total), (a, b, _)| {
            let (a, b) = (a - origin, b - origin);
            let twice = a.perp(&b);
            (sum + (a + b) * (twice / 3.0), total + twice)
        });
        if weighted.1.abs() < SAME { origin } else { origin + weighted.0 / weighted.1 }
    }

    /// The least and the greatest station of its corners along a direction, metres from the origin.
    pub(crate) fn extent(&self, along: &Vector2<f64>) -> [f64; 2] {
        let stations = self.corners.iter().map(|corner| corner.coords.dot(along));
        stations.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], at| [low.min(at), high.max(at)])
    }

    /// Its length along a direction, metres.
    pub(crate) fn length(&self, along: &Vector2<f64>) -> f64 {
        let [low, high] = self.extent(along);
        high - low
    }

    /// Whether a point is inside, and at least so many metres from every side.
    pub fn contains(&self, point: &Point, within: f64) -> bool {
        self.sides().all(|(a, b, _)| (b - a).perp(&(point - a)) >= within * (b - a).norm())
    }

    /// The part on the left of a line through a point; the new side has `cut` beyond. `None` if nothing of an area is left.
    pub(crate) fn cut(&self, through: &Point, along: &Vector2<f64>, cut: Beyond) -> Option<Self> {
        let left = |p: &Point| along.perp(&(p - through));
        let mut kept =
            Self::new(Vec::with_capacity(self.corners.len() + 1), Vec::with_capacity(self.corners.len() + 1));
        for (a, b, beyond) in self.sides() {
            let (from, to) = (left(&a), left(&b));
            if from >= -SAME {
                let leaves = from <= SAME && to < -SAME;
                kept.push(a, if leaves { cut } else { beyond });
            }
            if (from > SAME && to < -SAME) || (from < -SAME && to > SAME) {
                kept.push(a + (b - a) * (from / (from - to)), if to < 0.0 { cut } else { beyond });
            }
        }
        kept.tidy().filter(|part| part.area() > 1e-3)
    }

    fn push(&mut self, corner: Point, beyond: Beyond) {
        self.corners.push(corner);
        self.beyond.push(beyond);
    }

    /// Without sides that have no length.
    fn tidy(self) -> Option<Self> {
        let mut kept = Self::new(Vec::new(), Vec::new());
        for (a, b, beyond) in self.sides() {
            if (b - a).norm() > 10.0 * SAME {
                kept.push(a, beyond);
            }
        }
        (kept.corners.len() > 2).then_some(kept)
    }

    /// The two parts on the left and on the right of a line.
    pub(crate) fn split(&self, through: &Point, along: &Vector2<f64>, cut: Beyond) -> Option<[Self; 2]> {
        Some([self.cut(through, along, cut)?, self.cut(through, &-along, cut)?])
    }

    /// The part that keeps a distance from each side, by what lies beyond it, metres. Sides keep what is beyond them, or have
    /// `rim` beyond where they moved.
    pub(crate) fn inset(&self, rim: Option<Beyond>, distance: impl Fn(Beyond) -> f64) -> Option<Self> {
        self.sides().try_fold(self.clone(), |part, (a, b, beyond)| {
            let away = distance(beyond);
            if away <= 0.0 {
                return Some(part);
            }
            let along = (b - a).normalize();
            part.cut(&(a + left(along) * away), &along, rim.unwrap_or(beyond))
        })
    }

    /// The same polygon with something else beyond its sides.
    pub(crate) fn relabelled(mut self, beyond: impl Fn(Beyond) -> Beyond) -> Self {
        self.beyond.iter_mut().for_each(|side| *side = beyond(*side));
        self
    }

    /// The part within a distance of one of its sides' lines, and the rest.
    pub(crate) fn strip(
        &self,
        (a, b, _): (Point, Point, Beyond),
        depth: f64,
        cuts: [Beyond; 2],
    ) -> (Option<Self>, Option<Self>) {
        let along = (b - a).normalize();
        let at = a + left(along) * depth;
        (self.cut(&at, &-along, cuts[0]), self.cut(&at, &along, cuts[1]))
    }

    /// The distance of a point from it, metres; zero within.
    pub(crate) fn distance(&self, at: &Point) -> f64 {
        if self.contains(at, 0.0) {
            return 0.0;
        }
        let near = |(a, b, _): (Point, Point, Beyond)| {
            let (along, gap) = (b - a, at - a);
            (gap - along * (gap.dot(&along) / along.norm_squared()).clamp(0.0, 1.0)).norm()
        };
        self.sides().map(near).fold(f64::INFINITY, f64::min)
    }

    /// The area that two polygons share, square metres.
    pub(crate) fn shared(&self, other: &Self) -> f64 {
        let part =
            other.sides().try_fold(self.clone(), |part, (a, b, beyond)| part.cut(&a, &(b - a).normalize(), beyond));
        part.map_or(0.0, |part| part.area())
    }

    /// Its corners rounded to arcs of a radius in metres, less where sides are short. Arcs have straight pieces of 30 degrees at most.
    pub(crate) fn rounded(&self, radius: impl Fn(usize) -> f64) -> Vec<Point> {
        let count = self.corners.len();
        let mut ring = Vec::with_capacity(count * 4);
        for i in 0..count {
            let (before, at, after) =
                (self.corners[(i + count - 1) % count], self.corners[i], self.corners[(i + 1) % count]);
            let (back, on) = (before - at, after - at);
            let (one, two) = (back.normalize(), on.normalize());
            // The tangent of half the corner's angle.
            let half = ((1.0 - one.dot(&two)) / (1.0 + one.dot(&two)).max(1e-9)).sqrt();
            let reach = (radius(i) / half).min(0.45 * back.norm().min(on.norm()));
            let (start, end) = (at + one * reach, at + two * reach);
            let pieces = if reach < 0.05 { 0 } else { 4 };
            if pieces == 0 {
                ring.push(at);
            }
            // A quadratic curve lies within 3 % of the arc.
            ring.extend((0..=pieces).filter(|_| pieces > 0).map(|k| {
                let t = f64::from(k) / f64::from(pieces);
                Point::from(
                    start.coords * ((1.0 - t) * (1.0 - t)) + at.coords * (2.0 * t * (1.0 - t)) + end.coords * (t * t),
                )
            }));
        }
        ring
    }
}

/// To the left of a direction.
pub(crate) fn left(along: Vector2<f64>) -> Vector2<f64> {
    Vector2::new(-along.y, along.x)
}

/// The area that a ring encloses, square metres; positive if it runs counter-clockwise.
pub(crate) fn area(ring: &[Point]) -> f64 {
    let pairs = ring.iter().zip(ring.iter().cycle().skip(1));
    pairs.map(|(a, b)| a.x * b.y - b.x * a.y).sum::<f64>() / 2.0
}
