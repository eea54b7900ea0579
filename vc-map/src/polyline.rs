//! Lines with arc length: stations, headings, projection, offsets.

use std::ops::Range;

use nalgebra::{Point2, Vector2};
use vc_graph::portable::Portable;

/// A point of the plan, metres: X east, Y north.
pub type Point = Point2<f64>;

/// Points nearer than this are one, metres.
const SAME: f64 = 1e-3;

/// A line of straight pieces, with the arc length of each of its points. It has at least two points that differ.
///
/// ```
/// use vc_map::Polyline;
/// let line = Polyline::new([[0.0, 0.0], [10.0, 0.0], [10.0, 5.0]]).ok_or("too short")?;
/// assert_eq!(line.length(), 15.0);
/// assert_eq!(line.at(12.0), [10.0, 2.0].into());
/// let near = line.project(&[4.0, 1.0].into());
/// assert_eq!((near.station, near.left), (4.0, 1.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Polyline {
    points: Vec<Point>,
    /// The arc length at each point.
    stations: Vec<f64>,
}

/// The nearest point of a line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Projection {
    /// Arc length from the line's start, metres.
    pub station: f64,
    /// The signed distance from the line, metres; positive to its left.
    pub left: f64,
    /// The nearest point of the line.
    pub point: Point,
}

impl Polyline {
    /// The line through some points; repeated points count once. `None` if fewer than two differ, or one is not finite.
    pub fn new<P: Into<Point>>(points: impl IntoIterator<Item = P>) -> Option<Self> {
        let points = points.into_iter();
        let count = points.size_hint().0;
        let mut line = Self { points: Vec::with_capacity(count), stations: Vec::with_capacity(count) };
        for point in points {
            let point = point.into();
            if !(point.x.is_finite() && point.y.is_finite()) {
                return None;
            }
            line.push(point);
        }
        (line.points.len() > 1).then_some(line)
    }

    fn push(&mut self, point: Point) {
        let station = match (self.points.last(), self.stations.last()) {
            (Some(last), Some(station)) => {
                let step = (point - last).norm();
                if step < SAME {
                    return;
                }
                station + step
            }
            _ => 0.0,
        };
        self.points.push(point);
        self.stations.push(station);
    }

    /// Its points.
    pub fn points(&self) -> &[Point] {
        &self.points
    }

    /// Its length, metres.
    pub fn length(&self) -> f64 {
        self.stations.last().copied().unwrap_or(0.0)
    }

    /// Its first point.
    pub fn start(&self) -> Point {
        self.points[0]
    }

    /// Its last point.
    pub fn end(&self) -> Point {
        self.points[self.points.len() - 1]
    }

    /// The piece in which a station lies.
    fn piece(&self, station: f64) -> usize {
        let after = self.stations.partition_point(|at| *at <= station);
        after.clamp(1, self.points.len() - 1) - 1
    }

    /// The unit vector along a piece.
    pub(crate) fn along(&self, piece: usize) -> Vector2<f64> {
        (self.points[piece + 1] - self.points[piece]).normalize()
    }

    /// The point at a station, metres; stations beyond an end are that end. Costs the logarithm of the number of points.
    pub fn at(&self, station: f64) -> Point {
        let station = station.clamp(0.0, self.length());
        let piece = self.piece(station);
        self.points[piece] + self.along(piece) * (station - self.stations[piece])
    }

    /// The direction of the line at a station in metres, as a unit vector.
    pub fn direction(&self, station: f64) -> Vector2<f64> {
        self.along(self.piece(station.clamp(0.0, self.length())))
    }

    /// The heading at a station in metres, radians counter-clockwise from X.
    pub fn heading(&self, station: f64) -> f64 {
        let along = self.direction(station);
        along.y.angle_to(along.x)
    }

    /// The point of the line that is nearest to a point; the first of several. Costs one pass over the line.
    pub fn project(&self, point: &Point) -> Projection {
        self.project_on(point, 0..self.points.len())
    }

    /// The nearest point of some pieces, of which those count that there are.
    pub(crate) fn project_on(&self, point: &Point, pieces: Range<usize>) -> Projection {
        let mut best = (f64::INFINITY, 0, 0.0);
        for piece in pieces.start..pieces.end.min(self.points.len() - 1) {
            let along = self.along(piece);
            let length = self.stations[piece + 1] - self.stations[piece];
            let step = (point - self.points[piece]).dot(&along).clamp(0.0, length);
            let away = (point - (self.points[piece] + along * step)).norm_squared();
            if away < best.0 {
                best = (away, piece, step);
            }
        }
        let (away, piece, step) = best;
        let along = self.along(piece);
        let nearest = self.points[piece] + along * step;
        let side = along.perp(&(point - nearest));
        let left = if side < 0.0 { -away.sqrt() } else { away.sqrt() };
        Projection { station: self.stations[piece] + step, left, point: nearest }
    }

    /// The part between two stations in metres, or `None` if it is shorter than a millimetre.
    #[must_use]
    pub fn part(&self, from: f64, to: f64) -> Option<Self> {
        let [first, last] =
            [self.stations.partition_point(|at| *at <= from), self.stations.partition_point(|at| *at < to)];
        let inner = self.points.get(first..last).into_iter().flatten().copied();
        Self::new([self.at(from)].into_iter().chain(inner).chain([self.at(to)])).filter(|_| to - from >= SAME)
    }

    /// The same line from its end to its start.
    #[must_use]
    pub fn reversed(&self) -> Self {
        let length = self.length();
        Self {
            points: self.points.iter().rev().copied().collect(),
            stations: self.stations.iter().rev().map(|at| length - at).collect(),
        }
    }

    /// Two lines, the second from where the first ends.
    #[must_use]
    pub fn joined(mut self, other: &Self) -> Self {
        other.points.iter().for_each(|point| self.push(*point));
        self
    }

    /// The smallest distance between the two lines, metres. Costs the product of their points.
    pub fn distance(&self, other: &Self) -> f64 {
        if self.crosses(other) {
            return 0.0;
        }
        let to = |line: &Self, points: &[Point]| {
            points.iter().map(|p| line.project(p).left.abs()).fold(f64::INFINITY, f64::min)
        };
        to(self, &other.points).min(to(other, &self.points))
    }

    /// The box around it: lower left, upper right.
    pub(crate) fn bounds(&self) -> [Point; 2] {
        self.points.iter().fold([self.points[0]; 2], |[low, high], point| [low.inf(point), high.sup(point)])
    }

    /// The memory that its points take, bytes.
    pub(crate) fn bytes(&self) -> usize {
        self.points.capacity() * size_of::<Point>() + self.stations.capacity() * size_of::<f64>()
    }

    /// Whether the two lines have a point in common, other than by touching with their ends. Costs the product of their
    /// points.
    pub fn crosses(&self, other: &Self) -> bool {
        self.points
            .windows(2)
            .any(|ends| other.points.windows(2).any(|others| crossing((ends[0], ends[1]), (others[0], others[1]))))
    }

    /// Whether a straight way crosses some of its pieces, of which those count that there are.
    pub(crate) fn is_crossed_by(&self, pieces: Range<usize>, [from, to]: [Point; 2]) -> bool {
        let pieces = pieces.start..pieces.end.min(self.points.len() - 1);
        pieces.into_iter().any(|piece| crossing((self.points[piece], self.points[piece + 1]), (from, to)))
    }

    /// Whether two pieces of it cross, other than the first and last of a ring. Costs the pairs of pieces that overlap along
    /// X, and fewer where they cross.
    pub(crate) fn crosses_itself(&self) -> bool {
        let mut pieces: Vec<(f64, f64, usize)> = (0..self.points.len() - 1)
            .map(|i| (self.points[i].x.min(self.points[i + 1].x), self.points[i].x.max(self.points[i + 1].x), i))
            .collect();
        pieces.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.2.cmp(&b.2)));
        let ends = |piece: usize| (self.points[piece], self.points[piece + 1]);
        let closed = (self.start() - self.end()).norm() < SAME;
        let last = pieces.len() - 1;
        let apart = |one: usize, other: usize| one.abs_diff(other) > 1 && !(closed && one.abs_diff(other) == last);
        pieces.iter().enumerate().any(|(place, (_, right, one))| {
            let overlap = pieces[place + 1..].iter().take_while(|(left, ..)| left <= right);
            overlap.into_iter().any(|(.., other)| apart(*one, *other) && crossing(ends(*one), ends(*other)))
        })
    }
}

/// To the left of a direction.
pub(crate) fn normal(along: Vector2<f64>) -> Vector2<f64> {
    Vector2::new(-along.y, along.x)
}

/// Whether two pieces cross within both.
fn crossing((a, b): (Point, Point), (c, d): (Point, Point)) -> bool {
    let side = |p: Point, q: Point, r: Point| (q - p).perp(&(r - p));
    let (one, two) = (side(a, b, c), side(a, b, d));
    let (three, four) = (side(c, d, a), side(c, d, b));
    (one > 0.0) != (two > 0.0) && (three > 0.0) != (four > 0.0) && one != two && three != four
}

/// The quadratic curve from a point to a point whose tangents meet there in given directions, in eight straight pieces;
/// a straight line where the two directions do not meet ahead.
pub(crate) fn turn(from: Point, leaving: Vector2<f64>, to: Point, arriving: Vector2<f64>) -> Option<Polyline> {
    let across = leaving.perp(&arriving);
    let gap = to - from;
    let reach = if across.abs() < 0.05 { -1.0 } else { gap.perp(&arriving) / across };
    let left = if across.abs() < 0.05 { -1.0 } else { leaving.perp(&gap) / across };
    let longest = 3.0 * gap.norm();
    if reach > 0.0 && left > 0.0 && reach < longest && left < longest {
        let corner = from + leaving * reach;
        return Polyline::new((0..=8).map(|i| {
            let t = f64::from(i) / 8.0;
            Point::from(
                from.coords * ((1.0 - t) * (1.0 - t)) + corner.coords * (2.0 * t * (1.0 - t)) + to.coords * (t * t),
            )
        }));
    }
    // An S, or a turn back: a cubic with both tangents.
    let pull = 0.4 * gap.norm().max(1.0);
    let (one, two) = (from + leaving * pull, to - arriving * pull);
    Polyline::new((0..=8).map(|i| {
        let t = f64::from(i) / 8.0;
        let s = 1.0 - t;
        let sum = from.coords * (s * s * s)
            + one.coords * (3.0 * s * s * t)
            + two.coords * (3.0 * s * t * t)
            + to.coords * (t * t * t);
        Point::from(sum)
    }))
}

/// The area that a ring encloses, square metres; positive if it runs counter-clockwise.
pub(crate) fn area(ring: &[Point]) -> f64 {
    let pairs = ring.iter().zip(ring.iter().cycle().skip(1));
    pairs.map(|(a, b)| a.x * b.y - b.x * a.y).sum::<f64>() / 2.0
}

/// Whether a point is inside a ring, by the number of times that a ray crosses it.
pub(crate) fn inside(ring: &[Point], point: &Point) -> bool {
    let pairs = ring.iter().zip(ring.iter().cycle().skip(1));
    let hits = |(a, b): &(&Point, &Point)| {
        (a.y > point.y) != (b.y > point.y) && point.x < (b.x - a.x) * (point.y - a.y) / (b.y - a.y) + a.x
    };
    pairs.filter(hits).count() % 2 == 1
}
