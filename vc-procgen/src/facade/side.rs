//! Sides of the outline of a building.

use nalgebra::{Point2, Vector2};
use vc_shapes::Build;
use vc_shapes::material::MaterialId;

use super::{Pane, Panel};

/// A pane so near to a side is at it, metres.
const AT: f32 = 0.06;

/// A side of an outline, counter-clockwise.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Side {
    pub(crate) from: Point2<f32>,
    pub(crate) along: Vector2<f32>,
    pub(crate) length: f32,
}

/// The sides of an outline.
pub(crate) fn sides(outline: &[(f32, f32)]) -> Vec<Side> {
    let corners: Vec<Point2<f32>> = outline.iter().map(|&(x, y)| Point2::new(x, y)).collect();
    let ends = corners.iter().zip(corners.iter().cycle().skip(1));
    ends.map(|(a, b)| Side { from: *a, along: (b - a).normalize(), length: (b - a).norm() }).collect()
}

impl Side {
    /// The direction out of the building.
    pub(crate) fn out(&self) -> Vector2<f32> {
        Vector2::new(self.along.y, -self.along.x)
    }

    /// The part of it that a pane takes, if it is at it.
    pub(crate) fn taken(&self, pane: &Pane) -> Option<Panel> {
        let by = Point2::new(pane.at.0, pane.at.1) - self.from;
        let (at, half) = (by.dot(&self.along), pane.width / 2.0);
        let is_at = by.dot(&self.out()).abs() < AT && at > half && at < self.length - half;
        is_at.then_some([(at - half, at + half), pane.height])
    }

    /// A point of it, so far out of it and so high.
    pub(crate) fn point(&self, along: f32, out: f32, z: f32) -> [f32; 3] {
        let at = self.from + self.along * along + self.out() * out;
        [at.x, at.y, z]
    }

    /// A plate from so far out of the side inwards to so deep behind it.
    pub(crate) fn plate(
        &self,
        b: &mut Build<'_>,
        [(from, to), (low, high)]: Panel,
        (out, deep): (f32, f32),
        material: MaterialId,
    ) {
        let ends = [from, to].map(|at| [out, -deep].map(|out| [low, high].map(|z| self.point(at, out, z))));
        b.hull("wall", ends.as_flattened().as_flattened(), material);
    }
}
