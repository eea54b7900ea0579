//! Rectangles on the plan's grid.

use serde::Serialize;
use smallvec::SmallVec;

use super::{Room, metres};

/// A rectangle in cells of five centimetres: `x0..x1` by `y0..y1`.
///
/// ```
/// use vc_procgen::plan::Rect;
/// let rect = Rect { x0: 0, y0: 0, x1: 40, y1: 60 };
/// assert_eq!((rect.width(), rect.depth(), rect.area()), (40, 60, 6.0));
/// ```
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
pub struct Rect {
    /// West side.
    pub x0: i32,
    /// South side.
    pub y0: i32,
    /// East side.
    pub x1: i32,
    /// North side.
    pub y1: i32,
}

impl Rect {
    /// A rectangle from its south-west corner and its side lengths.
    pub fn sized(x0: i32, y0: i32, width: i32, depth: i32) -> Self {
        Self { x0, y0, x1: x0 + width, y1: y0 + depth }
    }

    /// The length along X, cells.
    pub fn width(&self) -> i32 {
        self.x1 - self.x0
    }

    /// The length along Y, cells.
    pub fn depth(&self) -> i32 {
        self.y1 - self.y0
    }

    /// The shorter side, cells.
    pub(crate) fn short(&self) -> i32 {
        self.width().min(self.depth())
    }

    /// The area in square metres.
    pub fn area(&self) -> f32 {
        metres(self.width()) * metres(self.depth())
    }

    /// Whether it has no area.
    pub(crate) fn is_empty(&self) -> bool {
        self.x0 >= self.x1 || self.y0 >= self.y1
    }

    /// The rectangle enlarged by a number of cells on every side.
    #[must_use]
    pub(crate) fn grown(&self, by: i32) -> Self {
        Self { x0: self.x0 - by, y0: self.y0 - by, x1: self.x1 + by, y1: self.y1 + by }
    }

    /// The rectangle translated.
    #[must_use]
    pub(crate) fn moved(&self, dx: i32, dy: i32) -> Self {
        Self { x0: self.x0 + dx, y0: self.y0 + dy, x1: self.x1 + dx, y1: self.y1 + dy }
    }

    /// The bounding rectangle of both.
    #[must_use]
    pub(crate) fn around(self, other: Self) -> Self {
        Self {
            x0: self.x0.min(other.x0),
            y0: self.y0.min(other.y0),
            x1: self.x1.max(other.x1),
            y1: self.y1.max(other.y1),
        }
    }

    /// The intersection; may be empty.
    #[must_use]
    pub(crate) fn shared(self, other: Self) -> Self {
        Self {
            x0: self.x0.max(other.x0),
            y0: self.y0.max(other.y0),
            x1: self.x1.min(other.x1),
            y1: self.y1.min(other.y1),
        }
    }

    /// Whether the rectangles overlap.
    pub(crate) fn overlaps(&self, other: &Self) -> bool {
        !self.shared(*other).is_empty()
    }

    /// Whether a point in cells is inside or on the border.
    pub(crate) fn holds(&self, x: f32, y: f32) -> bool {
        x >= self.x0 as f32 && x <= self.x1 as f32 && y >= self.y0 as f32 && y <= self.y1 as f32
    }

    /// The rectangle that spans the seam where two rectangles touch along a side: it reaches far
    /// into both, so that it connects their net areas after it is shrunk by a wall.
    pub(super) fn seam(&self, other: &Self) -> Option<Self> {
        let both = self.shared(*other);
        let hull = self.around(*other);
        if both.x0 == both.x1 && both.y1 > both.y0 {
            Some(Self { x0: hull.x0, x1: hull.x1, ..both })
        } else if both.y0 == both.y1 && both.x1 > both.x0 {
            Some(Self { y0: hull.y0, y1: hull.y1, ..both })
        } else {
            None
        }
    }
}

/// A short list of rectangles: enough for most rooms without a heap allocation.
pub(super) type Rects = SmallVec<[Rect; 16]>;

/// The area of the union of several rectangles, square metres.
pub(super) fn union_area(rects: &[Rect]) -> f32 {
    if let [one] = rects {
        return if one.is_empty() { 0.0 } else { one.area() };
    }
    let mut xs: SmallVec<[i32; 32]> = rects.iter().flat_map(|r| [r.x0, r.x1]).collect();
    xs.sort_unstable();
    xs.dedup();
    let strips = xs.windows(2).map(|x| {
        let mut spans: SmallVec<[(i32, i32); 16]> =
            rects.iter().filter(|r| r.x0 <= x[0] && r.x1 >= x[1]).map(|r| (r.y0, r.y1)).collect();
        spans.sort_unstable();
        let (mut covered, mut end) = (0, i32::MIN);
        for (low, high) in spans {
            covered += (high - low.max(end)).max(0);
            end = end.max(high);
        }
        metres(x[1] - x[0]) * metres(covered)
    });
    strips.sum()
}

/// A rectangle in one of the eight orientations (rotations and mirrorings) about the origin.
pub(super) fn turned(r: Rect, way: usize) -> Rect {
    let r = if way & 1 != 0 { Rect { x0: -r.x1, x1: -r.x0, ..r } } else { r };
    let r = if way & 2 != 0 { Rect { y0: -r.y1, y1: -r.y0, ..r } } else { r };
    if way & 4 != 0 { Rect { x0: r.y0, y0: r.x0, x1: r.y1, y1: r.x1 } } else { r }
}

/// Brings a plan into one of the eight orientations, with its south-west corner back at the origin.
pub(super) fn turn(rooms: &mut [Room], facades: &mut [bool; 4], way: usize) {
    rooms.iter_mut().flat_map(|r| &mut r.rects).for_each(|r| *r = turned(*r, way));
    if way & 1 != 0 {
        facades.swap(0, 1);
    }
    if way & 2 != 0 {
        facades.swap(2, 3);
    }
    if way & 4 != 0 {
        *facades = [facades[2], facades[3], facades[0], facades[1]];
    }
    let hull = rooms.iter().map(Room::hull).reduce(Rect::around).unwrap_or_default();
    rooms.iter_mut().flat_map(|r| &mut r.rects).for_each(|r| *r = r.moved(-hull.x0, -hull.y0));
}

/// Whether several rectangles together cover another.
pub(crate) fn covers(by: &[Rect], what: Rect) -> bool {
    let shared = by.iter().map(|r| r.shared(what)).filter(|r| !r.is_empty());
    shared.clone().any(|r| r == what) || union_area(&shared.collect::<Rects>()) >= what.area() - 1e-4
}
