//! Rectangles on the floor in metres, and the four axis-aligned facing directions.

use vc_graph::portable::Portable;

use crate::plan::{Rect, metres};

/// A rectangle on the floor, metres.
///
/// ```
/// use vc_procgen::Area;
/// let table = Area { x0: 0.0, y0: 0.0, x1: 1.6, y1: 0.9 };
/// let chair = Area { x0: 0.5, y0: 0.9, x1: 1.0, y1: 1.4 };
/// assert!(!table.overlaps(&chair), "they touch along a line");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Area {
    /// West side.
    pub x0: f32,
    /// South side.
    pub y0: f32,
    /// East side.
    pub x1: f32,
    /// North side.
    pub y1: f32,
}

/// The tolerance of comparisons, metres.
const SLACK: f32 = 1e-4;

impl Area {
    pub(crate) fn from_rect(rect: &Rect) -> Self {
        Self { x0: metres(rect.x0), y0: metres(rect.y0), x1: metres(rect.x1), y1: metres(rect.y1) }
    }

    pub(crate) fn around(x: f32, y: f32, half_x: f32, half_y: f32) -> Self {
        Self { x0: x - half_x, y0: y - half_y, x1: x + half_x, y1: y + half_y }
    }

    /// Whether the two overlap by more than a line.
    pub fn overlaps(&self, other: &Self) -> bool {
        self.x0 < other.x1 - SLACK
            && other.x0 < self.x1 - SLACK
            && self.y0 < other.y1 - SLACK
            && other.y0 < self.y1 - SLACK
    }

    pub(crate) fn centre(&self) -> (f32, f32) {
        (f32::midpoint(self.x0, self.x1), f32::midpoint(self.y0, self.y1))
    }

    pub(crate) fn size(&self) -> (f32, f32) {
        (self.x1 - self.x0, self.y1 - self.y0)
    }

    pub(crate) fn grown(&self, by: f32) -> Self {
        Self { x0: self.x0 - by, y0: self.y0 - by, x1: self.x1 + by, y1: self.y1 + by }
    }

    /// The smallest rectangle with both in it.
    pub(crate) fn around_both(self, other: Self) -> Self {
        Self {
            x0: self.x0.min(other.x0),
            y0: self.y0.min(other.y0),
            x1: self.x1.max(other.x1),
            y1: self.y1.max(other.y1),
        }
    }

    /// The rectangle moved.
    pub(crate) fn moved(&self, (x, y): (f32, f32)) -> Self {
        Self { x0: self.x0 + x, y0: self.y0 + y, x1: self.x1 + x, y1: self.y1 + y }
    }

    /// The rectangle turned about the origin, by the turn from X to a direction.
    pub(crate) fn turned(&self, by: Facing) -> Self {
        let (a, b) = (by.turn((self.x0, self.y0)), by.turn((self.x1, self.y1)));
        Self { x0: a.0.min(b.0), y0: a.1.min(b.1), x1: a.0.max(b.0), y1: a.1.max(b.1) }
    }

    pub(crate) fn holds(&self, other: &Self) -> bool {
        other.x0 >= self.x0 - SLACK
            && other.y0 >= self.y0 - SLACK
            && other.x1 <= self.x1 + SLACK
            && other.y1 <= self.y1 + SLACK
    }

    pub(crate) fn square_metres(&self) -> f32 {
        (self.x1 - self.x0).max(0.0) * (self.y1 - self.y0).max(0.0)
    }

    /// The distance between the nearest points of both.
    pub(crate) fn distance(&self, other: &Self) -> f32 {
        let gap = |a0: f32, a1: f32, b0: f32, b1: f32| (b0 - a1).max(a0 - b1).max(0.0);
        gap(self.x0, self.x1, other.x0, other.x1).hypotenuse(gap(self.y0, self.y1, other.y0, other.y1))
    }
}

/// A facing direction along an axis: quarter turns from X, counter-clockwise.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Facing(pub u8);

impl Facing {
    /// The unit vector in this direction.
    pub(crate) fn step(self) -> (f32, f32) {
        [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)][usize::from(self.0 % 4)]
    }

    pub(crate) fn yaw(self) -> f32 {
        // Exact for all four directions.
        [0.0, std::f32::consts::FRAC_PI_2, std::f32::consts::PI, -std::f32::consts::FRAC_PI_2][usize::from(self.0 % 4)]
    }

    pub(crate) fn turned(self, quarters: u8) -> Self {
        Self((self.0 + quarters) % 4)
    }

    /// A point turned about the origin, by the turn from X to this direction.
    pub(crate) fn turn(self, (x, y): (f32, f32)) -> (f32, f32) {
        [(x, y), (-y, x), (-x, -y), (y, -x)][usize::from(self.0 % 4)]
    }

    pub(crate) fn is_along_x(self) -> bool {
        self.0.is_multiple_of(2)
    }

    /// The rectangle of an object with the given depth and width that faces this way, with the
    /// centre of its back at a point.
    pub(crate) fn area(self, back: (f32, f32), depth: f32, width: f32) -> Area {
        let (dx, dy) = self.step();
        let centre = (back.0 + dx * depth / 2.0, back.1 + dy * depth / 2.0);
        let (hx, hy) = if self.is_along_x() { (depth / 2.0, width / 2.0) } else { (width / 2.0, depth / 2.0) };
        Area::around(centre.0, centre.1, hx, hy)
    }

    /// The rectangle in front of an area that faces this way.
    pub(crate) fn before(self, area: &Area, depth: f32) -> Area {
        match self.0 % 4 {
            0 => Area { x0: area.x1, x1: area.x1 + depth, ..*area },
            1 => Area { y0: area.y1, y1: area.y1 + depth, ..*area },
            2 => Area { x0: area.x0 - depth, x1: area.x0, ..*area },
            _ => Area { y0: area.y0 - depth, y1: area.y0, ..*area },
        }
    }

    /// The area extended to its left and right.
    pub(crate) fn widened(self, area: &Area, left: f32, right: f32) -> Area {
        match self.0 % 4 {
            0 => Area { y0: area.y0 - right, y1: area.y1 + left, ..*area },
            1 => Area { x0: area.x0 - left, x1: area.x1 + right, ..*area },
            2 => Area { y0: area.y0 - left, y1: area.y1 + right, ..*area },
            _ => Area { x0: area.x0 - right, x1: area.x1 + left, ..*area },
        }
    }
}
