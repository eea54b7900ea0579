//! Roofs: flat ones with a parapet, and pitched ones with a ridge.

use nalgebra::{Point2, Vector2};
use vc_graph::portable::Portable;
use vc_shapes::Build;
use vc_shapes::material::BRICK;

use super::shell::SKIN;
use super::{Shell, Side};

/// The thickness of a roof and of its parapet, and the parapet's height with its coping.
const SLAB: f32 = 0.2;
const PARAPET: (f32, f32) = (0.4, 0.06);
/// How far the eaves stand out.
const EAVES: f32 = 0.35;
/// The part of half its depth by which the ridge of a free house is shorter at each end.
const HIP: f32 = 0.55;
/// A chimney: half its width, and its height above the ridge.
const CHIMNEY: (f32, f32) = (0.28, 0.7);

impl Shell<'_> {
    /// The roof; that of a house between others ends with it.
    pub(crate) fn roof(&self, b: &mut Build<'_>, is_between: bool) {
        if self.looks.pitch > 0.0 {
            self.pitched(b, is_between);
        } else {
            self.flat(b);
        }
    }

    fn flat(&self, b: &mut Build<'_>) {
        let (top, high) = (self.top(), PARAPET.0);
        let roof = self.sides.iter().flat_map(|side| [top - SLAB, top].map(|z| side.point(0.0, 0.0, z)));
        b.hull("roof", &roof.collect::<Vec<[f32; 3]>>(), self.looks.roof);
        for side in &self.sides {
            side.plate(b, [(0.0, side.length), (top, top + high)], (SKIN, SLAB), self.looks.wall);
            let coping = [(-0.06, side.length + 0.06), (top + high, top + high + PARAPET.1)];
            side.plate(b, coping, (0.06, SLAB + 0.04), self.looks.trim);
        }
    }

    fn pitched(&self, b: &mut Build<'_>, is_between: bool) {
        let Some(front) = self.sides.iter().max_by(|a, b| a.length.total_cmp(&b.length)) else { return };
        // Houses in a row have their ridge along the street, which may be their shorter side.
        let side = if is_between { self.front() } else { *front };
        let extent = |axis: &Vector2<f32>| {
            let stations = self.sides.iter().map(|side| side.from.coords.dot(axis));
            stations.fold((f32::INFINITY, f32::NEG_INFINITY), |(low, high), at| (low.min(at), high.max(at)))
        };
        let (along, across) = (side.along, Vector2::new(-side.along.y, side.along.x));
        let ((x0, x1), (y0, y1)) = (extent(&along), extent(&across));
        let (half, top) = ((y1 - y0) / 2.0, self.top());
        let eaves = if is_between { 0.0 } else { EAVES };
        let rise = half * self.looks.pitch.sine() / self.looks.pitch.cosine();
        let short = if is_between { 0.0 } else { (half * HIP).min((x1 - x0) / 2.0 - 0.1) };
        let place = |x: f32, y: f32, z: f32| {
            let at = along * x + across * y;
            [at.x, at.y, z]
        };
        let middle = f32::midpoint(y0, y1);
        let mut points = vec![place(x0 + short, middle, top + rise), place(x1 - short, middle, top + rise)];
        let centre = self.sides.iter().fold(Vector2::zeros(), |sum, side| sum + side.from.coords)
            / self.sides.len().max(1) as f32;
        for side in &self.sides {
            let corner: Point2<f32> = side.from;
            let out = (corner.coords - centre).try_normalize(1e-3).unwrap_or_default() * (eaves * 1.4);
            points.extend([-0.12, 0.02].map(|z| [corner.x + out.x, corner.y + out.y, top + z]));
        }
        b.hull("roof", &points, self.looks.roof);
        let (wide, tall) = CHIMNEY;
        let [x, y, z] = place(x0 + (x1 - x0) * 0.68, middle, top + rise);
        b.block("chimney", [x - wide, y - wide, top], [x + wide, y + wide, z + tall], BRICK);
    }

    /// The side with the door, else the first.
    fn front(&self) -> Side {
        self.sides[self.front.min(self.sides.len() - 1)]
    }
}
