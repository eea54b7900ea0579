//! Whether objects fit on and in others.

use crate::class::SlotKind;
use crate::node::Node;
use crate::{Property, Relation, SceneGraph};

/// The reason why an object does not fit on or in another, if the sizes of both are known. A container with a
/// lid must take the object in some orientation, together with its contents; objects may stick out of a
/// container that is open at the top, and overhang the edge of a surface. A book supports only paper objects of
/// no larger size.
pub(super) fn misfit(graph: &SceneGraph, thing: &Node, target: &Node) -> Option<&'static str> {
    if thing.id() == target.id() || graph.rests_at(target.id(), thing.id()) {
        return Some("rests on or in it");
    }
    let inside = || graph.relating(Relation::Inside, target.id()).filter(|&n| n != thing.id());
    let slots = target.slots(SlotKind::Slot);
    if slots > 0 && inside().count() >= slots as usize {
        return Some("has no free slot");
    }
    let leaves = target.is_leaves();
    if leaves && !thing.affords(Property::Paper) {
        return Some("carries only what is of paper");
    }
    let (size, space) = (thing.spec().bounds?, target.spec().bounds?);
    if leaves {
        let ([_, a, b], [_, width, length]) = (sorted(size.size()), sorted(space.size()));
        return (a > width + SLACK || b > length + SLACK).then_some("is too small");
    }
    if target.affords(Property::Surface) || !target.affords(Property::Openable) {
        return None;
    }
    if sorted(size.size()).iter().zip(sorted(space.size())).any(|(s, room)| *s > room + SLACK) {
        return Some("is too small");
    }
    let taken = inside().filter_map(|n| graph.node(n)?.spec().bounds).map(|b| b.volume()).sum::<f32>();
    (taken + size.volume() > space.volume()).then_some("is full")
}

/// Tolerance by which a box may exceed the space and still fit, since the shape is smaller than its box,
/// metres.
const SLACK: f32 = 0.02;

fn sorted(size: nalgebra::Vector3<f32>) -> [f32; 3] {
    let mut all = [size.x, size.y, size.z];
    all.sort_unstable_by(f32::total_cmp);
    all
}
