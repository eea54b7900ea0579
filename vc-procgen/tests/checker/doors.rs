//! Doors and lids swing freely, and fronts of cupboards and drawers have space in front.

use nalgebra::Isometry3;
use vc_graph::asset::JointKind;

use super::thing::{Piece, Thing, hull};
use super::{House, Rule};

/// The angle by which a door must open: 80 degrees.
const OPEN: f32 = 1.397;
/// The free depth in front of fronts.
const FRONT: f64 = 0.3;
/// The tolerance, for a joint's play and trims.
const SLACK: f64 = 0.01;
/// The depth by which objects may protrude at the sides: a picture frame beside a wardrobe.
const BESIDE: f64 = 0.05;

pub(super) fn look(house: &mut House<'_>) {
    let mut found = Vec::new();
    for door in house.things.iter().filter(|t| t.is_door()) {
        found.extend(swing(house, door).into_iter().map(|(group, text)| (Rule::BlockedDoor, group, text)));
    }
    let stands = |t: &&Thing| !t.is_building() && t.carriers.iter().all(|c| is_floor(house, *c));
    for thing in house.things.iter().filter(stands) {
        found.extend(front(house, thing).into_iter().map(|(group, text)| (Rule::BlockedFront, group, text)));
        found.extend(lid(house, thing).into_iter().map(|(group, text)| (Rule::BlockedFront, group, text)));
    }
    found.into_iter().for_each(|(rule, group, text)| house.note(rule, group, text));
}

fn is_floor(house: &House<'_>, id: vc_graph::NodeId) -> bool {
    house.at.get(&id).is_some_and(|&i| house.things[i].class == "floor")
}

/// The objects that the leaf of a door hits on its way, with the first and deepest contact of each.
fn swing(house: &House<'_>, door: &Thing) -> Vec<(String, String)> {
    let leaf: Vec<&Piece> = door.pieces.iter().filter(|p| p.joint.is_some()).collect();
    if leaf.is_empty() {
        return vec![(door.class.clone(), format!("{} has no leaf that moves", door.label))];
    }
    let others = house.things.iter().filter(|t| t.id != door.id && !matches!(&*t.class, "wall" | "floor" | "ceiling"));
    others.filter_map(|other| Some((format!("{} / {}", door.class, other.class), met(door, &leaf, other)?))).collect()
}

fn met(door: &Thing, leaf: &[&Piece], other: &Thing) -> Option<String> {
    // No part of the leaf moves farther from its place than twice its width.
    let (low, high) = hull(leaf.iter().map(|p| (p.low, p.high)));
    let reach = 2.0 * (high - low).xy().max();
    if (0..2).any(|k| other.low[k] > high[k] + reach || other.high[k] < low[k] - reach) {
        return None;
    }
    (0..=10).find_map(|step| {
        let share = step as f32 / 10.0;
        leaf.iter().find_map(|piece| {
            let moved = piece.moved(&motion(door, piece, share)?);
            let hit = other.pieces.iter().find_map(|p| Some((p, moved.penetration(p)?)));
            let (part, (depth, at)) = hit?;
            let (angle, mm) = (share * OPEN.to_degrees(), depth * 1e3);
            let place = format!("({:.3}, {:.3}, {:.3})", at.x, at.y, at.z);
            let (door, leaf) = (&door.label, &piece.name);
            Some(format!(
                "{door} ({leaf}) at {angle:.0} deg hits {} ({}) by {mm:.1} mm at {place}",
                other.label, part.name
            ))
        })
    })
}

/// The parts of the building that a lid hits while it opens by half: the wall behind a bin.
fn lid(house: &House<'_>, thing: &Thing) -> Vec<(String, String)> {
    let is_lid = |p: &&Piece| p.joint.is_some_and(|j| j.kind == JointKind::Hinge && j.axis.y.abs() > 0.9);
    let lids: Vec<&Piece> = thing.pieces.iter().filter(is_lid).collect();
    let building = house.things.iter().filter(|t| t.is_building() && !thing.carriers.contains(&t.id));
    let hits = |other: &Thing| {
        let opened = lids.iter().flat_map(|p| [0.25, 0.5].map(|share| Some(p.moved(&motion(thing, p, share)?))));
        opened.flatten().any(|lid| other.pieces.iter().any(|p| lid.penetration(p).is_some()))
    };
    let hit = building.filter(|other| hits(other));
    hit.map(|other| {
        (format!("{} / {}", thing.class, other.class), format!("{}'s lid hits {}", thing.label, other.label))
    })
    .collect()
}

/// The motion of a part in the world at a share of its range.
fn motion(thing: &Thing, piece: &Piece, share: f32) -> Option<Isometry3<f64>> {
    let joint = piece.joint?;
    let most =
        if joint.kind == JointKind::Hinge { OPEN.copysign(joint.limits.0 + joint.limits.1) } else { joint.limits.1 };
    let local: Isometry3<f64> = joint.motion(most * share).cast();
    Some(thing.pose * local * thing.pose.inverse())
}

/// The objects that stand close in front of the moving front of a piece of furniture.
fn front(house: &House<'_>, thing: &Thing) -> Vec<(String, String)> {
    let back = thing.pose.inverse();
    let own: Vec<(super::shape::P, super::shape::P)> = thing.pieces.iter().map(|p| within(&back, p)).collect();
    let (low, high) = hull(own.iter().copied());
    let middle = (low.x + high.x) / 2.0;
    let fronts = thing.pieces.iter().zip(&own).filter(|(p, b)| opens(p) && (b.0.x + b.1.x) / 2.0 > middle);
    let (from, to) = hull(fronts.map(|(_, b)| *b));
    if from.x > to.x || to.x < high.x - 0.1 {
        return Vec::new();
    }
    let beside = nalgebra::Vector3::new(0.0, BESIDE, SLACK);
    let zone = (from + beside, to - beside);
    let fixed = |t: &&Thing| t.id != thing.id && !t.sits && !matches!(&*t.class, "floor" | "ceiling" | "rug" | "door");
    let stands = |t: &&Thing| t.carriers.iter().all(|c| is_floor(house, *c));
    let others = house.things.iter().filter(fixed).filter(stands);
    let mut found = Vec::new();
    for other in others {
        let gap = other.pieces.iter().map(|p| within(&back, p)).filter(|b| {
            let beside = (1..3).all(|k| b.0[k] < zone.1[k] && b.1[k] > zone.0[k]);
            beside && b.1.x > high.x + SLACK && b.0.x > high.x - 0.1 && b.0.x < high.x + FRONT
        });
        let gap = gap.map(|b| b.0.x - high.x).fold(f64::INFINITY, f64::min);
        if gap < FRONT - SLACK {
            let text = format!("{} has {gap:.2} m before its front, then {}", thing.label, other.label);
            found.push((format!("{} / {}", thing.class, other.class), text));
        }
    }
    found
}

/// Whether a part is a drawer that slides forwards, or a door that hinges on an upright or level
/// axis.
fn opens(piece: &Piece) -> bool {
    piece.joint.is_some_and(|j| match j.kind {
        JointKind::Slide => j.axis.x > 0.9,
        JointKind::Hinge => j.axis.z.abs() > 0.9 || j.axis.y.abs() > 0.9,
    })
}

/// The bounding box of a part in a frame.
fn within(frame: &Isometry3<f64>, piece: &Piece) -> (super::shape::P, super::shape::P) {
    hull(piece.points.iter().map(|p| frame * p).map(|p| (p, p)))
}
