//! The orientation of an object in its box: which of its axes lies along which of the box's, and the
//! direction of its front.

use std::sync::Arc;

use nalgebra::{Isometry3, Matrix3, Point2, Rotation3, UnitQuaternion, Vector2, Vector3};
use vc_graph::{Aabb, Bounds, BoundsFrame, NodeId, ObjectRole, Pose, Property};
use vc_shapes::Generators;

use super::house::{House, is_seat};
use super::kind;
use crate::area::Facing;

/// The placement of an object: the class it is made as, its pose, and its box in its own axes.
pub(super) struct Place {
    /// The class whose generator makes it; the node's own class if there is none.
    pub(super) class: Arc<str>,
    pub(super) pose: Pose,
    pub(super) bounds: Bounds,
    /// The stretches of its width that other objects occupy, from its centre, metres.
    pub(super) taken: Vec<(f32, f32)>,
}

/// If the misfits of two rotations differ by more than this, the proportions decide, otherwise the
/// surroundings.
const DOUBT: f32 = 0.35;
/// An object that could stand is laid down if that reduces the misfit by more than this.
const LIES: f32 = 1.0;
/// An object that begins higher than this above the floor hangs on the wall, metres.
const HUNG: f32 = 0.3;

/// The kinds of objects that face each other, and the weight of this relative to free floor and walls.
const COMPANIONS: [(&str, &str); 3] = [("sofa", "television"), ("television", "sofa"), ("tv_stand", "sofa")];
const COMPANY: f32 = 0.5;

/// Determines the placement of an object.
pub(super) fn placed(house: &House, id: NodeId, pose: &Pose, bounds: &Bounds) -> Place {
    let known = !super::is_unturned(bounds);
    let box_ = bounds.aabb(pose);
    let size = if known { bounds.size() } else { box_.max - box_.min };
    let class = kind::generated_class(house, id, size, &box_);
    if known {
        return Place { class, pose: *pose, bounds: *bounds, taken: Vec::new() };
    }
    let lain = lain(house, id, &class, size);
    let front = front(house, id, &class, &box_, &lain);
    let turn = Facing(front).yaw();
    let rotation = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), turn) * lain.turn();
    let pose = Isometry3::from_parts(pose.translation, rotation);
    let half = lain.own(if front % 2 == 1 { Vector3::new(size.y, size.x, size.z) } else { size }) / 2.0;
    let half = grown(house.generators, &class, half);
    let offset = rotation.inverse() * bounds.offset;
    let bounds = Bounds { offset, half, frame: BoundsFrame::Object };
    let taken = taken(house, id, &box_, front);
    Place { class, pose, bounds, taken }
}

/// How an object is tipped before it is rotated.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Lain {
    Upright,
    /// On its side: its width is upright.
    Side,
    /// On its back: its depth is upright.
    Back,
}

impl Lain {
    /// Converts a size from the world's axes to the object's own.
    fn own(self, size: Vector3<f32>) -> Vector3<f32> {
        match self {
            Self::Upright => size,
            Self::Side => Vector3::new(size.x, size.z, size.y),
            Self::Back => Vector3::new(size.z, size.y, size.x),
        }
    }

    /// The exact rotation from its own axes to the world's.
    fn turn(self) -> UnitQuaternion<f32> {
        let (x, y, z) = (Vector3::x(), Vector3::y(), Vector3::z());
        let columns = match self {
            Self::Upright => return UnitQuaternion::identity(),
            Self::Side => [x, z, -y],
            Self::Back => [z, y, -x],
        };
        UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(Matrix3::from_columns(&columns)))
    }
}

/// Half a size with mistakes of the scene corrected: a dimension far below the class's usual range is
/// replaced by the least of that range.
fn grown(generators: &Generators, class: &str, half: Vector3<f32>) -> Vector3<f32> {
    const MISTAKEN: f32 = 3.0;
    let Some(ranges) = generators.usual_ranges(class) else { return half };
    Vector3::from_fn(|i, _| {
        let least = ranges[i].low / 2.0;
        if half[i] * MISTAKEN < least { least } else { half[i] }
    })
}

/// How far the proportions of a size are from those of a class: the sum over its dimensions of the
/// logarithmic distance from the usual range, after a common scaling.
fn misfit(generators: &Generators, class: &str, size: Vector3<f32>) -> f32 {
    use vc_graph::portable::Portable;
    let Some(ranges) = generators.usual_ranges(class) else { return 0.0 };
    let off = Vector3::from_fn(|i, _| {
        let size = size[i].max(1e-3);
        let fair = size.clamp(ranges[i].low, ranges[i].high.max(ranges[i].low));
        // The part beyond the range counts in full, the part within it with a small weight.
        (size / fair).logarithm() + 0.2 * (fair / ranges[i].middle()).logarithm()
    });
    off.map(|v| (v - off.mean()).abs()).sum()
}

fn lain(house: &House, id: NodeId, class: &str, size: Vector3<f32>) -> Lain {
    let carried = house.graph.node(id).is_some_and(|n| n.affords(Property::Graspable));
    let fit = |lain: Lain| {
        let swapped = Vector3::new(size.y, size.x, size.z);
        misfit(house.generators, class, lain.own(size)).min(misfit(house.generators, class, lain.own(swapped)))
    };
    let best = [Lain::Side, Lain::Back].into_iter().min_by(|a, b| fit(*a).total_cmp(&fit(*b)));
    best.filter(|l| carried && fit(*l) + LIES < fit(Lain::Upright)).unwrap_or(Lain::Upright)
}

/// The number of quarter turns from the world's X to an object's front.
fn front(house: &House, id: NodeId, class: &str, around: &Aabb, lain: &Lain) -> u8 {
    let there = Surroundings { house, id, around, level: house.level(around) };
    if is_seat(house.graph.classes(), class)
        && let Some(way) = to_table(house, around)
    {
        return there.best(class, lain, |k| step(k).dot(&way));
    }
    match holder_front(house, id) {
        Some(of_holder) => there.best(class, lain, |k| step(k).dot(&step(of_holder))),
        None => there.front(class, lain),
    }
}

fn step(k: u8) -> Vector2<f32> {
    let (x, y) = Facing(k).step();
    Vector2::new(x, y)
}

/// The front of the piece of furniture that an object is on or in, directly or indirectly.
fn holder_front(house: &House, id: NodeId) -> Option<u8> {
    let furniture = |&h: &NodeId| {
        let node = house.graph.node(h)?;
        let carries =
            ![ObjectRole::Floor, ObjectRole::Wall, ObjectRole::Ceiling, ObjectRole::Rug].contains(&node.role());
        Some((node, *node.pose()?, node.spec().bounds?)).filter(|_| carries)
    };
    let (holder, pose, bounds) = house.holders_of(id).iter().rev().find_map(furniture)?;
    if !super::is_unturned(&bounds) {
        let way = (pose.rotation * Vector3::x()).xy();
        return (0..4).max_by(|&a, &b| step(a).dot(&way).total_cmp(&step(b).dot(&way)));
    }
    let around = bounds.aabb(&pose);
    let class = kind::generated_class(house, holder.id(), around.max - around.min, &around);
    let alone = Surroundings { house, id: holder.id(), around: &around, level: house.level(&around) };
    Some(alone.front(&class, &Lain::Upright))
}

/// The direction from a seat to the table that it is drawn up to.
fn to_table(house: &House, seat: &Aabb) -> Option<Vector2<f32>> {
    const DRAWN_UP: f32 = 0.7;
    let centre = seat.centre();
    let gap = |b: &Aabb| (0..2).map(|i| (b.min[i] - seat.max[i]).max(seat.min[i] - b.max[i]).max(0.0)).sum::<f32>();
    let low = |b: &Aabb| b.max.z - b.min.z > 0.6;
    let tables = house.of_kind("table").map(|(_, _, b)| b).filter(|b| low(b) && gap(b) < DRAWN_UP);
    let nearest = tables.min_by(|a, b| gap(a).total_cmp(&gap(b)))?;
    let at = nearest.nearest(&centre);
    let way = (at - centre).xy();
    let way = if way.norm() > 0.05 { way } else { (nearest.centre() - centre).xy() };
    way.try_normalize(1e-3)
}

/// The surroundings of an object.
struct Surroundings<'h, 'g> {
    house: &'h House<'g>,
    id: NodeId,
    around: &'h Aabb,
    level: f32,
}

impl Surroundings<'_, '_> {
    /// The front of an object of a class if only its surroundings determine it.
    fn front(&self, class: &str, lain: &Lain) -> u8 {
        let hung = self.around.min.z > self.level + HUNG;
        let company = self.company(class);
        self.best(class, lain, |k| self.score(k, hung) + company.map_or(0.0, |way| COMPANY * step(k).dot(&way)))
    }

    /// The direction from a screen to the nearest sofa in its room, and from a sofa to the nearest screen.
    fn company(&self, class: &str) -> Option<Vector2<f32>> {
        let graph = self.house.graph;
        let is_a = |kind: &str| graph.classes().is_a(class, kind);
        let (_, wanted) = COMPANIONS.iter().find(|(of, _)| is_a(of))?;
        let room = graph.room_of(self.id);
        let way = |b: Aabb| (b.centre() - self.around.centre()).xy();
        let others = self.house.of_kind(wanted).filter(|(id, ..)| graph.room_of(*id) == room);
        let nearest = others.map(|(_, _, b)| way(b)).min_by(|a, b| a.norm().total_cmp(&b.norm()));
        nearest?.try_normalize(0.3)
    }

    /// The best facing direction among those that the proportions of the box allow.
    fn best(&self, class: &str, lain: &Lain, score: impl Fn(u8) -> f32) -> u8 {
        let size = self.around.max - self.around.min;
        let fit =
            [size, Vector3::new(size.y, size.x, size.z)].map(|s| misfit(self.house.generators, class, lain.own(s)));
        let allowed: &[u8] = match fit[0] - fit[1] {
            d if d < -DOUBT => &[0, 2],
            d if d > DOUBT => &[1, 3],
            _ => &[0, 1, 2, 3],
        };
        let ranked = allowed.iter().map(|&k| (score(k) - 0.3 * fit[usize::from(k % 2)], k));
        ranked.reduce(|p, q| if q.0 > p.0 + 1e-4 { q } else { p }).map_or(0, |(_, k)| k)
    }

    /// The score of a facing direction: free floor in front, a wall behind.
    fn score(&self, k: u8, hung: bool) -> f32 {
        let (front, back) = (k, (k + 2) % 4);
        let walls = self.backing(back) - 0.7 * self.backing(front);
        if hung { 2.0 * walls + 0.3 * self.free(front) } else { walls + 1.2 * self.free(front) - 0.6 * self.free(back) }
    }

    /// The share of the floor in front of a side that is free.
    fn free(&self, k: u8) -> f32 {
        const ROWS: [f32; 4] = [0.12, 0.3, 0.5, 0.75];
        let (ahead, along) = (step(k), step(k + 1));
        let half = (self.around.max - self.around.min).xy() / 2.0;
        let (deep, wide) = if k.is_multiple_of(2) { (half.x, half.y) } else { (half.y, half.x) };
        let at = |row: f32, i: i32| -> Point2<f32> {
            self.around.centre().xy() + ahead * (deep + row) + along * (wide * 0.3 * i as f32)
        };
        let spots = ROWS.into_iter().flat_map(|row| (-3..=3).map(move |i| (row, i)));
        let free = spots.filter(|&(row, i)| self.house.is_free(at(row, i), self.level, self.id)).count();
        free as f32 / (7 * ROWS.len()) as f32
    }

    /// How near a wall is to a side: one where it touches, zero from half a metre on.
    fn backing(&self, k: u8) -> f32 {
        const FAR: f32 = 0.5;
        let (deep, wide) = if k.is_multiple_of(2) { (0, 1) } else { (1, 0) };
        let plus = k % 4 < 2;
        let own = self.around;
        let beside = |w: &Aabb| {
            let shared = w.max[wide].min(own.max[wide]) - w.min[wide].max(own.min[wide]);
            let stands = w.max.z > own.min.z && w.min.z < own.max.z;
            stands && shared > 0.3 * (own.max[wide] - own.min[wide])
        };
        let centre = own.centre()[deep];
        let gap = |w: &Aabb| {
            let (face, edge, beyond) = if plus {
                (w.min[deep], own.max[deep], w.max[deep] > centre)
            } else {
                (-w.max[deep], -own.min[deep], w.min[deep] < centre)
            };
            beyond.then_some((face - edge).max(0.0))
        };
        // A wall that runs across this direction is not behind this side.
        let thin = |w: &Aabb| w.max[deep] - w.min[deep] < w.max[wide] - w.min[wide];
        let nearest = self.house.walls.iter().filter(|w| thin(w) && beside(w)).filter_map(gap).reduce(f32::min);
        nearest.map_or(0.0, |d| (1.0 - d / FAR).max(0.0))
    }
}

/// The stretches of a counter's width, from its centre, that appliances within its box occupy.
fn taken(house: &House, id: NodeId, around: &Aabb, front: u8) -> Vec<(f32, f32)> {
    let wide = if front.is_multiple_of(2) { 1 } else { 0 };
    let way = step(front + 1)[if front.is_multiple_of(2) { 1 } else { 0 }];
    let centre = around.centre()[wide];
    let inner = Aabb { min: around.min.map(|v| v + 0.02), max: around.max.map(|v| v - 0.02) };
    let meets = |b: &Aabb| (0..3).all(|i| b.min[i] < inner.max[i] && inner.min[i] < b.max[i]);
    let large = |b: &Aabb| (b.max - b.min).min() > 0.4;
    let appliances = house.of_kind("appliance").filter(|(other, _, b)| *other != id && large(b) && meets(b));
    let stretch = |b: Aabb| {
        let (a, c) = ((b.min[wide] - centre) * way, (b.max[wide] - centre) * way);
        (a.min(c), a.max(c))
    };
    let mut all: Vec<(f32, f32)> = appliances.map(|(_, _, b)| stretch(b)).collect();
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    all
}
