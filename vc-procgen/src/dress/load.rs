//! The objects that rest on another in the scene, and how well the surfaces of its asset support them.

use nalgebra::{Isometry3, Vector3};
use vc_graph::asset::{Hold, Surface};
use vc_graph::{Aabb, Anthropometry, Asset, NodeId, Relation};

use super::house::House;

/// The distances that a surface may be inside an object it supports, and below it, metres.
const SUNK: f32 = 0.02;
const HOVERS: f32 = 0.15;

/// The bounding box of a supported object, in a frame at the centre of the supporting one's box.
#[derive(Debug, Clone, Copy)]
pub(super) struct Load {
    low: Vector3<f32>,
    high: Vector3<f32>,
    inside: bool,
}

/// The objects that rest on or in another, whose box has its centre and axes at a pose.
pub(super) fn resting_on(house: &House, id: NodeId, middle: &Isometry3<f32>) -> Vec<Load> {
    let related = |relation| house.graph.relating(relation, id).map(move |load| (load, relation == Relation::Inside));
    let all = related(Relation::On).chain(related(Relation::Inside));
    all.filter_map(|(load, inside)| Some(Load::new(&house.graph.node(load)?.aabb()?, middle, inside))).collect()
}

impl Load {
    fn new(around: &Aabb, middle: &Isometry3<f32>, inside: bool) -> Self {
        let corners = around.corners().map(|corner| middle.inverse_transform_point(&corner).coords);
        let (low, high) = corners[1..].iter().fold((corners[0], corners[0]), |(l, h), c| (l.inf(c), h.sup(c)));
        Self { low, high, inside }
    }

    /// How badly surfaces support it: zero if it stands on one, one if nothing is below it or a board passes
    /// through it.
    fn off(&self, levels: &[Level]) -> f32 {
        let over = || levels.iter().filter(|l| l.is_below(self));
        let cut = |l: &Level| l.at > self.low.z + SUNK && l.at < self.high.z - SUNK;
        let gap = over().map(|l| self.low.z - l.at).filter(|gap| *gap >= -SUNK).fold(HOVERS, f32::min);
        if over().any(cut) { 1.0 } else { gap.max(0.0) / HOVERS }
    }
}

/// A surface in the frame at the centre of its object, scaled as the object is.
struct Level {
    middle: Vector3<f32>,
    half: (f32, f32),
    at: f32,
}

impl Level {
    fn new(surface: &Surface, origin: &Vector3<f32>, stretch: &Vector3<f32>) -> Self {
        let middle = (surface.centre.coords - origin).component_mul(stretch);
        Self { middle, half: (surface.half.0 * stretch.x, surface.half.1 * stretch.y), at: middle.z }
    }

    /// Whether it is below the centre of a load.
    fn is_below(&self, load: &Load) -> bool {
        let off = (load.low + load.high) / 2.0 - self.middle;
        off.x.abs() <= self.half.0 && off.y.abs() <= self.half.1
    }
}

/// How badly an asset supports loads, from zero to one, if its box has its centre at `origin` and is scaled.
pub(super) fn off(asset: &Asset, origin: &Vector3<f32>, stretch: &Vector3<f32>, loads: &[Load]) -> f32 {
    let levels: Vec<Level> = asset.surfaces.iter().map(|s| Level::new(s, origin, stretch)).collect();
    let sum: f32 = loads.iter().map(|load| load.off(&levels)).sum();
    if loads.is_empty() { 0.0 } else { sum / loads.len() as f32 }
}

/// Marks the boards of open shelves that carry objects in the scene as surfaces to put objects on, and
/// likewise a convenient one if the top is out of reach; the other boards keep objects inside.
pub(super) fn lay_on_boards(asset: &mut Asset, origin: &Vector3<f32>, stretch: &Vector3<f32>, loads: &[Load]) {
    if asset.parts.iter().any(|part| part.joint.is_some()) || loads.iter().all(|load| load.inside) {
        return;
    }
    let levels: Vec<Level> = asset.surfaces.iter().map(|s| Level::new(s, origin, stretch)).collect();
    let votes = |level: &Level| {
        let here = |l: &&Load| level.is_below(l) && (-SUNK..HOVERS).contains(&(l.low.z - level.at));
        loads.iter().filter(here).map(|l| if l.inside { -1 } else { 1 }).sum::<i32>()
    };
    let votes: Vec<i32> = levels.iter().map(votes).collect();
    for (surface, votes) in asset.surfaces.iter_mut().zip(&votes) {
        if surface.hold == Hold::Inside && *votes > 0 {
            surface.hold = Hold::On;
        }
    }
    let bottom = asset.extent().map_or(0.0, |(low, _)| (low.z - origin.z) * stretch.z);
    let in_reach = |s: &Surface, level: &Level| s.hold == Hold::On && level.at - bottom < Anthropometry::ADULT.shelf;
    if !asset.surfaces.iter().zip(&levels).any(|(s, level)| in_reach(s, level)) {
        let far = |i: &usize| (levels[*i].at - bottom - Anthropometry::ADULT.handy).abs();
        let empty = (0..levels.len()).filter(|i| votes[*i] == 0 && asset.surfaces[*i].hold == Hold::Inside);
        if let Some(handy) = empty.min_by(|a, b| far(a).total_cmp(&far(b))) {
            asset.surfaces[handy].hold = Hold::On;
        }
    }
}
