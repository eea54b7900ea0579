//! Ways on which people walk: lines with widths.

use nalgebra::{Point2, Vector2};
use vc_map::Polyline;

/// A way with a smaller sine between two pieces has no bend there; the line across a sharp one leans by at most so much.
const BEND: f32 = 0.2;
const MOST_LEAN: f32 = 1.5;

/// A straight part of a way.
#[derive(Debug, Clone, Copy)]
pub(super) struct Piece {
    pub(super) from: Point2<f32>,
    pub(super) along: Vector2<f32>,
    pub(super) length: f32,
    /// The station at which it begins, metres.
    pub(super) station: f32,
    /// Half its width, metres.
    pub(super) half: f32,
    /// The direction across the line at which one goes on with the next.
    gate: Vector2<f32>,
}

impl Piece {
    /// How far along it a point is, and how far to its left, metres.
    pub(super) fn place(&self, at: &Point2<f32>) -> (f32, f32) {
        let from = at - self.from;
        (from.dot(&self.along), self.along.perp(&from))
    }

    /// To its left.
    pub(super) fn left(&self) -> Vector2<f32> {
        Vector2::new(-self.along.y, self.along.x)
    }

    /// Whether a point is beyond its end.
    pub(super) fn is_behind(&self, at: &Point2<f32>) -> bool {
        (at - self.from - self.along * self.length).dot(&self.gate) >= 0.0
    }
}

/// A way for people on foot: a line with a width, which may change. People keep to it, and beside each other on it.
///
/// ```
/// use vc_map::Polyline;
/// use vc_traffic::Way;
/// // Ten metres of pavement, then a crossing.
/// let line = |points| Polyline::new(points).ok_or("too short");
/// let way = Way::new([(line([[0.0, 0.0], [10.0, 0.0]])?, 2.0), (line([[10.0, 0.0], [10.0, 8.0]])?, 4.0)]).ok_or("no way")?;
/// assert_eq!((way.length(), way.at(4.0, 0.5)), (18.0, [4.0, 0.5]));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct Way {
    pub(super) pieces: Vec<Piece>,
}

impl Way {
    /// The way along some lines, each from where the last one ends, with their widths in metres. `None` without a line.
    pub fn new(parts: impl IntoIterator<Item = (Polyline, f32)>) -> Option<Self> {
        let mut pieces: Vec<Piece> = Vec::new();
        for (line, width) in parts {
            for ends in line.points().windows(2) {
                let [from, to] = [ends[0], ends[1]].map(|point| point.map(|metres| metres as f32));
                let length = (to - from).norm();
                if length < 1e-3 {
                    continue;
                }
                let along = (to - from) / length;
                let station = pieces.last().map_or(0.0, |last| last.station + last.length);
                pieces.push(Piece { from, along, length, station, half: width / 2.0, gate: along });
            }
        }
        for next in 1..pieces.len() {
            let both = pieces[next - 1].along + pieces[next].along;
            // One who turns back goes to the end first.
            pieces[next - 1].gate = both.try_normalize(0.1).unwrap_or(pieces[next - 1].along);
        }
        (!pieces.is_empty()).then_some(Self { pieces })
    }

    /// Its length, metres.
    pub fn length(&self) -> f32 {
        self.pieces.last().map_or(0.0, |last| last.station + last.length)
    }

    /// The point at a station, and so far to the left of its line, metres.
    pub fn at(&self, station: f32, left: f32) -> [f32; 2] {
        let piece = &self.pieces[self.piece(station)];
        let at = piece.from + piece.along * (station - piece.station) + piece.left() * left;
        [at.x, at.y]
    }

    /// The stations about each bend between which it depends on the side where one walks how far one has come, metres.
    pub(crate) fn bends(&self) -> impl Iterator<Item = [f32; 2]> {
        self.pieces.windows(2).filter_map(|pair| {
            let (sine, cosine) = (pair[0].along.perp(&pair[1].along).abs(), pair[0].along.dot(&pair[1].along));
            let reach = pair[0].half.max(pair[1].half) * (sine / (1.0 + cosine).max(0.3)).min(MOST_LEAN);
            (sine > BEND).then(|| [pair[1].station - reach, pair[1].station + reach])
        })
    }

    /// The number of the piece at a station.
    pub(super) fn piece(&self, station: f32) -> usize {
        self.pieces.partition_point(|piece| piece.station <= station).max(1) - 1
    }
}
