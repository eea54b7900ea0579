//! The box around a node in the node's own frame, and parts cut from it.

use nalgebra::{Point3, Vector3};
use vc_graph::asset::{Hold, Part, Shape, Surface};
use vc_graph::{Aabb, BoundsFrame, Node, Pose};

/// Least half length of a part, metres: boxes of floors and pictures have none.
const LEAST: f32 = 0.001;
/// Sine of the tilt up to which a node stands upright.
const UPRIGHT: f32 = 0.02;
/// Sine of the turn against the world's axes up to which a node is along them.
const ALONG: f32 = 0.02;
/// Least difference of the squares of cosine and sine at which a turned box can be found from the
/// upright one around it.
const TURNED: f32 = 0.3;

/// Pieces of a box that are narrower are left out, metres.
const SLIVER: f32 = 0.005;

/// A box by its corners.
pub(crate) type Piece = (Vector3<f32>, Vector3<f32>);

/// A box in its node's frame, metres.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Block {
    pub(crate) low: Vector3<f32>,
    pub(crate) high: Vector3<f32>,
    /// Where the node is.
    pub(crate) pose: Pose,
}

impl Block {
    /// `None` if the node has no box or pose, or leans.
    pub(crate) fn new(node: &Node) -> Option<Self> {
        let (bounds, pose) = (node.spec().bounds?, *node.pose()?);
        let up = pose.rotation * Vector3::z();
        if up.z < 0.0 || up.xy().norm() > UPRIGHT {
            return None;
        }
        let (centre, half) = match bounds.frame {
            BoundsFrame::Object => (bounds.offset, bounds.half),
            BoundsFrame::World => (pose.rotation.inverse() * bounds.offset, own_half(&pose, bounds.half)),
        };
        let half = half.map(|h| h.abs().max(LEAST));
        Some(Self { low: centre - half, high: centre + half, pose })
    }

    pub(crate) fn size(&self) -> Vector3<f32> {
        self.high - self.low
    }

    /// An upright box of the world in this frame.
    pub(crate) fn local(&self, aabb: &Aabb) -> (Vector3<f32>, Vector3<f32>) {
        let corners = aabb.corners().map(|corner| self.pose.inverse_transform_point(&corner).coords);
        corners[1..].iter().fold((corners[0], corners[0]), |(low, high), c| (low.inf(c), high.sup(c)))
    }

    /// Whether its sides are along the world's axes.
    pub(crate) fn is_along(&self) -> bool {
        let front = self.pose.rotation * Vector3::x();
        front.x.abs().min(front.y.abs()) < ALONG
    }

    /// All of it as one part.
    pub(crate) fn whole(&self, name: &str) -> Part {
        part(name, self.low, self.high)
    }

    /// All of it up to a height.
    pub(crate) fn up_to(&self, name: &str, top: f32) -> Part {
        part(name, self.low, Vector3::new(self.high.x, self.high.y, top))
    }

    /// A level surface, inset from its sides.
    pub(crate) fn surface(&self, name: &str, hold: Hold, level: f32, inset: f32, clearance: Option<f32>) -> Surface {
        let (centre, half) = ((self.low + self.high) / 2.0, self.size() / 2.0);
        let inset = inset.min(half.x / 2.0).min(half.y / 2.0);
        Surface {
            name: name.into(),
            hold,
            centre: Point3::new(centre.x, centre.y, level),
            half: (half.x - inset, half.y - inset),
            clearance,
            joint: None,
        }
    }
}

/// Half the size of a box that is turned around the vertical, from the upright box around it; where
/// that does not determine it, half the size of a square box within.
fn own_half(pose: &Pose, half: Vector3<f32>) -> Vector3<f32> {
    let front = pose.rotation * Vector3::x();
    let (cos, sin) = (front.x.abs(), front.y.abs());
    if sin < ALONG {
        return half;
    }
    if cos < ALONG {
        return Vector3::new(half.y, half.x, half.z);
    }
    let squares = cos * cos - sin * sin;
    let (x, y) = ((cos * half.x - sin * half.y) / squares, (cos * half.y - sin * half.x) / squares);
    if squares.abs() > TURNED && x > 0.0 && y > 0.0 {
        return Vector3::new(x, y, half.z);
    }
    let least = half.x.min(half.y) / (cos + sin);
    Vector3::new(least, least, half.z)
}

/// A box between two corners.
pub(crate) fn part(name: &str, low: Vector3<f32>, high: Vector3<f32>) -> Part {
    let (centre, half) = ((low + high) / 2.0, ((high - low) / 2.0).map(|h| h.max(LEAST / 2.0)));
    let pose = Pose::translation(centre.x, centre.y, centre.z);
    Part { name: name.into(), shape: Shape::Box { half }, material: 0, pose, joint: None }
}

/// The pieces of a box that are left without another: beside it, above and below.
pub(crate) fn cut((low, high): Piece, (from, to): &Piece) -> Vec<Piece> {
    if (0..3).any(|i| from[i] >= high[i] || to[i] <= low[i]) {
        return vec![(low, high)];
    }
    let (mut rest, mut left) = ((low, high), Vec::new());
    for axis in 0..3 {
        if from[axis] > rest.0[axis] + SLIVER {
            let mut below = rest;
            below.1[axis] = from[axis];
            left.push(below);
            rest.0[axis] = from[axis];
        }
        if to[axis] < rest.1[axis] - SLIVER {
            let mut above = rest;
            above.0[axis] = to[axis];
            left.push(above);
            rest.1[axis] = to[axis];
        }
    }
    left
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_doorway_leaves_both_sides_and_the_lintel() {
        let wall = (Vector3::new(0.0, 0.0, 0.0), Vector3::new(0.1, 4.0, 2.5));
        let left = cut(wall, &(Vector3::new(-1.0, 1.0, 0.0), Vector3::new(1.0, 2.0, 2.0)));
        let volume: f32 = left.iter().map(|(low, high)| (high - low).product()).sum();
        assert_eq!(left.len(), 3);
        assert!((volume - (0.1 * 4.0 * 2.5 - 0.1 * 1.0 * 2.0)).abs() < 1e-5);
        assert_eq!(cut(wall, &(Vector3::repeat(5.0), Vector3::repeat(6.0))), [wall]);
    }
}
