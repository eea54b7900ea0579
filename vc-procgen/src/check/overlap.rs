//! Finds overlapping items by testing the boxes of their parts.

use nalgebra::{Isometry3, Point3, Vector3};
use vc_graph::asset::Part;
use vc_graph::{Aabb, Pose};

use crate::item::{Item, Support};

/// The depth by which solids may overlap before they count as colliding, metres.
const TOUCH: f32 = 0.002;

/// Pairs of overlapping items. Pairs where one item rests on or in the other are left out: surfaces
/// keep them apart. Parts of the building may overlap.
///
/// Costs a sweep along X, and a test of parts where boxes overlap.
pub(super) fn collisions(items: &[Item]) -> Vec<(usize, usize)> {
    let boxes: Vec<(Point3<f32>, Point3<f32>)> = items.iter().map(Item::corners).collect();
    let mut order: Vec<usize> = (0..items.len()).collect();
    order.sort_by(|&a, &b| boxes[a].0.x.total_cmp(&boxes[b].0.x));
    let mut found = Vec::new();
    let mut active: Vec<usize> = Vec::new();
    for &index in &order {
        let (low, high) = boxes[index];
        active.retain(|&other| boxes[other].1.x > low.x + TOUCH);
        for &other in &active {
            let (low_other, high_other) = boxes[other];
            let apart = low_other.y > high.y - TOUCH
                || high_other.y < low.y + TOUCH
                || low_other.z > high.z - TOUCH
                || high_other.z < low.z + TOUCH;
            if !apart && !related(items, index, other) && solid(&items[index], &items[other]) {
                found.push((index.min(other), index.max(other)));
            }
        }
        active.push(index);
    }
    found.sort_unstable();
    found
}

/// Whether two items may overlap: one supports the other, or both are part of the building.
pub(super) fn related(items: &[Item], a: usize, b: usize) -> bool {
    let built = items[a].support == Support::Built && items[b].support == Support::Built;
    built || carries(items, a, b) || carries(items, b, a)
}

/// Whether an upright box overlaps a part of an item.
pub(crate) fn shares_space(place: &Aabb, item: &Item) -> bool {
    let middle = nalgebra::center(&place.min, &place.max);
    let half = ((place.max - place.min) / 2.0).map(|h| (h - TOUCH / 2.0).max(h * 0.5));
    share_space(&[Cuboid { pose: Isometry3::from(middle.coords), half }], item)
}

/// Whether one item supports another, directly or indirectly.
pub(crate) fn carries(items: &[Item], carrier: usize, mut item: usize) -> bool {
    while let Support::On(at, _) | Support::Inside(at, _) = items[item].support {
        if at == carrier {
            return true;
        }
        item = at;
    }
    false
}

/// Whether a part of one item overlaps a part of the other.
fn solid(a: &Item, b: &Item) -> bool {
    let own: Vec<Cuboid> = a.object.asset.parts.iter().map(|p| Cuboid::around(p, &a.pose)).collect();
    share_space(&own, b)
}

/// Whether any of some boxes overlaps a part of an item.
pub(super) fn share_space(boxes: &[Cuboid], item: &Item) -> bool {
    let others: Vec<(Cuboid, f32)> =
        item.object.asset.parts.iter().map(|p| Cuboid::around(p, &item.pose)).map(|c| (c, c.half.norm())).collect();
    boxes.iter().any(|own| {
        let reach = own.half.norm();
        let near = |c: &Cuboid, r: f32| (c.pose.translation.vector - own.pose.translation.vector).norm() < reach + r;
        others.iter().any(|(other, r)| near(other, *r) && own.meets(other))
    })
}

/// An oriented box, slightly shrunk.
#[derive(Clone, Copy)]
pub(super) struct Cuboid {
    pose: Isometry3<f32>,
    half: Vector3<f32>,
}

impl Cuboid {
    /// The box around a part of an item at a pose.
    pub(super) fn around(part: &Part, item: &Pose) -> Self {
        let (low, high) = part.shape.extent();
        let pose = item * part.pose * Isometry3::from(nalgebra::center(&low, &high).coords);
        let half = ((high - low) / 2.0).map(|h| (h - TOUCH / 2.0).max(h * 0.5));
        Self { pose, half }
    }

    /// The smallest and largest corner.
    pub(super) fn corners(&self) -> (Point3<f32>, Point3<f32>) {
        let reach = self.pose.rotation.to_rotation_matrix().into_inner().abs() * self.half;
        let middle = Point3::from(self.pose.translation.vector);
        (middle - reach, middle + reach)
    }

    /// The separating axis test (Gottschalk, Lin and Manocha 1996).
    fn meets(&self, other: &Self) -> bool {
        let relative = self.pose.inverse() * other.pose;
        let turn = relative.rotation.to_rotation_matrix().into_inner();
        let shift = relative.translation.vector;
        let reach = |m: &nalgebra::Matrix3<f32>| m.abs().add_scalar(1e-6);
        let abs = reach(&turn);
        let own = (0..3).all(|i| shift[i].abs() <= self.half[i] + (abs.row(i) * other.half)[0]);
        let theirs = (0..3).all(|j| shift.dot(&turn.column(j)).abs() <= other.half[j] + self.half.dot(&abs.column(j)));
        own && theirs
            && (0..3).all(|i| {
                (0..3).all(|j| {
                    let (i1, i2, j1, j2) = ((i + 1) % 3, (i + 2) % 3, (j + 1) % 3, (j + 2) % 3);
                    let ra = self.half[i1] * abs[(i2, j)] + self.half[i2] * abs[(i1, j)];
                    let rb = other.half[j1] * abs[(i, j2)] + other.half[j2] * abs[(i, j1)];
                    (shift[i2] * turn[(i1, j)] - shift[i1] * turn[(i2, j)]).abs() <= ra + rb
                })
            })
    }
}
