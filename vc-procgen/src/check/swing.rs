//! Leaves, lids and drawers that hit immovable objects.

use nalgebra::Point3;
use vc_graph::asset::Joint;
use vc_graph::{ClassTable, Property};

use super::overlap::{Cuboid, related, share_space};
use crate::item::{Item, Support};

/// The shares of a part's motion at which it is checked; it has to open as far as the last one.
const SHARES: [f32; 2] = [0.25, 0.5];

/// Items that cannot open, each with the first object that a part of it hits before it is half open: the
/// building, or furniture that cannot be pushed aside.
///
/// Doors and windows are left out because they have zones of their own; so are graspable items, such as books
/// on a shelf, which are opened in the hands.
pub(super) fn jams(items: &[Item]) -> Vec<(usize, usize)> {
    let table = ClassTable::builtin();
    let affords =
        |item: &Item, property| table.get(item.object.class).is_some_and(|c| c.affordances.contains(property));
    let stands = |item: &Item| !matches!(item.support, Support::Built) && !affords(item, Property::Graspable);
    let opens = |item: &Item| stands(item) && affords(item, Property::Openable);
    let stays = |item: &Item| {
        let fixed = matches!(item.support, Support::Built | Support::Floor | Support::Wall | Support::Ceiling);
        fixed && !affords(item, Property::Movable) && !affords(item, Property::Graspable)
    };
    let mut firm: Option<Vec<usize>> = None;
    let mut found = Vec::new();
    for (index, item) in items.iter().enumerate().filter(|(_, item)| moves(item) && opens(item)) {
        let firm = firm.get_or_insert_with(|| (0..items.len()).filter(|i| stays(&items[*i])).collect());
        let opened = opened(item);
        let around = hull(&opened);
        let meets = |other: &usize| {
            *other != index
                && overlap(&around, &items[*other].corners())
                && !related(items, index, *other)
                && share_space(&opened, &items[*other])
        };
        found.extend(firm.iter().copied().find(meets).map(|other| (index, other)));
    }
    found
}

fn moves(item: &Item) -> bool {
    item.object.asset.parts.iter().any(|p| p.joint.is_some())
}

/// The boxes of an item's moving parts at each checked share of their motion.
fn opened(item: &Item) -> Vec<Cuboid> {
    let moving = item.object.asset.parts.iter().filter_map(|part| Some((part, part.joint?)));
    let at = |joint: &Joint, share: f32| item.pose * joint.motion(widest(joint) * share);
    moving.flat_map(|(part, joint)| SHARES.map(|share| Cuboid::around(part, &at(&joint, share)))).collect()
}

/// The joint limit farther from the closed position.
fn widest(joint: &Joint) -> f32 {
    let (low, high) = joint.limits;
    if high.abs() >= low.abs() { high } else { low }
}

type Corners = (Point3<f32>, Point3<f32>);

/// The smallest and largest corner of all boxes.
fn hull(boxes: &[Cuboid]) -> Corners {
    let none = (Point3::from([f32::INFINITY; 3]), Point3::from([f32::NEG_INFINITY; 3]));
    boxes.iter().map(Cuboid::corners).fold(none, |all, one| (all.0.inf(&one.0), all.1.sup(&one.1)))
}

fn overlap(a: &Corners, b: &Corners) -> bool {
    (0..3).all(|i| a.0[i] < b.1[i] && b.0[i] < a.1[i])
}
