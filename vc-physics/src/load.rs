//! Loads: the things that rest on others, and on what a thing rests.

use nalgebra::Vector3;
use rapier3d::dynamics::RigidBodyHandle;
use rapier3d::geometry::ColliderHandle;
use vc_graph::asset::JointKind;
use vc_graph::{NodeId, Pose};

use crate::contact::CARRIES;
use crate::displaced::{Displaced, NONE};
use crate::state::Thing;
use crate::world::PhysicsWorld;
use crate::{BodyRole, convert, group};

/// Height of a hop of a thing, metres, and its speed, metres per second.
const HOP: f32 = 0.01;
const HOPPING: f32 = 0.2;

impl PhysicsWorld {
    /// The things that rest on a body, directly or through others: loose things, and things that are pinned to
    /// it.
    pub(crate) fn load_of(&self, body: RigidBodyHandle) -> Vec<NodeId> {
        self.load_of_body(body, &NONE)
    }

    fn load_of_body(&self, body: RigidBodyHandle, displaced: &Displaced) -> Vec<NodeId> {
        let part = self.engine.bodies.get(body).map(|b| group::marked(b.user_data));
        part.map_or_else(Vec::new, |part| self.load_above(part, self.colliders_of(body), displaced))
    }

    /// The things that a moving part carries: those on or in a body of its own; and on a part that moves with its
    /// base, if it is made to hold things, as a drawer is.
    pub(crate) fn load_of_part(&self, id: NodeId, part: usize) -> Vec<NodeId> {
        self.load_of_part_with(id, part, &NONE)
    }

    /// As [`Self::load_of_part`], where some things are displaced.
    pub(crate) fn load_of_part_with(&self, id: NodeId, part: usize, displaced: &Displaced) -> Vec<NodeId> {
        let Ok(thing) = self.thing(id) else { return Vec::new() };
        let (Some(moving), Some(link)) = (thing.state.moving.get(part), thing.form.links.get(part + 1)) else {
            return Vec::new();
        };
        let holds = || thing.form.surfaces.iter().any(|surface| surface.joint == link.joint);
        match moving.body {
            Some(body) => self.load_of_body(body, displaced),
            None if holds() => {
                let mark = group::mark(id, part + 1);
                let own = |c: &ColliderHandle| self.engine.colliders.get(*c).is_some_and(|c| c.user_data == mark);
                let colliders = self.colliders_of(thing.state.base).into_iter().filter(own).collect();
                self.load_above((id, part + 1), colliders, displaced)
            }
            None => Vec::new(),
        }
    }

    fn colliders_of(&self, body: RigidBodyHandle) -> Vec<ColliderHandle> {
        self.engine.bodies.get(body).map_or_else(Vec::new, |body| body.colliders().to_vec())
    }

    /// The things that rest on some colliders of a node's link.
    fn load_above(&self, part: (NodeId, usize), colliders: Vec<ColliderHandle>, displaced: &Displaced) -> Vec<NodeId> {
        let (own, link) = part;
        let mut load = self.pinned_on(part);
        if link > 0 {
            load.extend(self.hovering_in(&colliders, displaced));
        }
        let base = |id: &NodeId| self.thing(*id).ok().map(|thing| thing.state.base);
        let mut open: Vec<_> = load.iter().filter_map(base).map(|body| self.colliders_of(body)).collect();
        open.push(colliders);
        while let Some(below) = open.pop() {
            let pinned = self.pinned_on_base(&below).into_iter();
            let loose = |id: &NodeId| self.role(*id) == Some(BodyRole::Loose);
            for above in pinned.chain(self.resting_on(&below, displaced).into_iter().filter(loose)) {
                if above != own && !load.contains(&above) {
                    load.push(above);
                    open.extend(base(&above).map(|body| self.colliders_of(body)));
                }
            }
        }
        load
    }

    /// The node and link on which a loose thing rests, directly or through others, if that link moves on a
    /// joint: a drawer, a rack, an open door. A thing that nothing carries from below, as it is jammed or has just been
    /// put there, is carried by the drawer in which it is.
    pub(crate) fn rides(&self, id: NodeId) -> Option<(NodeId, usize)> {
        let turns =
            |thing: &Thing, link: usize| thing.form.links[link].joint.is_some_and(|j| j.kind == JointKind::Hinge);
        let (mut seen, mut open, mut carried) = (vec![id], vec![self.thing(id).ok()?.state.base], false);
        while let Some(body) = open.pop() {
            let carriers = self.carriers(body);
            carried |= carriers.iter().any(|(below, _)| self.role(*below) != Some(BodyRole::Loose));
            // A thing on the top of a box stays there if a door below the top's edge opens.
            let stands = carriers.iter().any(|&(below, link)| link == 0 && self.role(below) == Some(BodyRole::Fixed));
            for (below, link) in carriers {
                let Ok(thing) = self.thing(below) else { continue };
                if link > 0 && !(stands && turns(thing, link)) {
                    return Some((below, link));
                }
                if thing.state.rides.is_some() {
                    return thing.state.rides;
                }
                if thing.state.role == BodyRole::Loose && !seen.contains(&below) {
                    seen.push(below);
                    open.push(thing.state.base);
                }
            }
        }
        if carried { None } else { seen.iter().find_map(|id| self.drawer_around(*id)) }
    }

    /// The moving part in whose hollow a thing is.
    fn drawer_around(&self, id: NodeId) -> Option<(NodeId, usize)> {
        let thing = self.thing(id).ok()?;
        let drawers = self.things.iter().filter(|around| around.id != id && !around.state.moving.is_empty());
        let link = |around: &Thing| around.form.link_with(self.shelf_of(thing, around.id, true)?.surface);
        drawers.into_iter().find_map(|around| Some((around.id, link(around).filter(|link| *link > 0)?)))
    }

    /// Things that fell asleep during a hop, a millimetre or two above their support, or that have just been moved with it
    /// or put there and begin to fall: nothing carries them.
    fn hovering_in(&self, colliders: &[ColliderHandle], displaced: &Displaced) -> Vec<NodeId> {
        let Some(around) = self.box_around(colliders.iter().copied()) else { return Vec::new() };
        let (low, high) = (around.min - Vector3::z() * HOP, around.max + Vector3::z() * HOP);
        let still = |t: &Thing| self.is_asleep(t) || self.velocity(t).norm() < HOPPING;
        let hops = |t: &Thing| still(t) && displaced.get(t.state.base).is_none();
        let loose = self.things.iter().filter(|t| t.state.role == BodyRole::Loose && hops(t));
        let above = |id: NodeId| {
            let own = self.aabb(id)?;
            let (centre, foot) = (own.centre(), own.min.z);
            let over = (low.x..=high.x).contains(&centre.x) && (low.y..=high.y).contains(&centre.y);
            Some(over && (low.z..=high.z).contains(&foot))
        };
        let falls = |t: &&Thing| self.carriers(t.state.base).is_empty();
        loose.filter(|t| above(t.id) == Some(true)).filter(falls).map(|t| t.id).collect()
    }

    /// The things that were pinned to a node's link.
    pub(crate) fn pinned_on(&self, part: (NodeId, usize)) -> Vec<NodeId> {
        self.things.iter().filter(|t| t.state.rides == Some(part)).map(|t| t.id).collect()
    }

    /// The things that are pinned to the node whose base has some colliders.
    fn pinned_on_base(&self, colliders: &[ColliderHandle]) -> Vec<NodeId> {
        let body = colliders.first().and_then(|c| self.engine.colliders.get(*c)?.parent());
        let part = body.and_then(|body| self.engine.bodies.get(body)).map(|b| group::marked(b.user_data));
        part.filter(|(_, link)| *link == 0).map_or_else(Vec::new, |part| self.pinned_on(part))
    }

    /// The nodes and links that push a body from below.
    fn carriers(&self, body: RigidBodyHandle) -> Vec<(NodeId, usize)> {
        let mut found = Vec::new();
        for pair in self.pairs_of(body).filter(|p| p.has_any_active_contact()) {
            let first = self.engine.colliders.get(pair.collider1).and_then(|c| c.parent()) == Some(body);
            let sign = if first { -1.0 } else { 1.0 };
            let up = self.touches(pair).any(|t| t.normal.z * sign > CARRIES);
            let other = if first { pair.collider2 } else { pair.collider1 };
            found.extend(self.engine.colliders.get(other).map(|c| group::marked(c.user_data)).filter(|_| up));
        }
        found
    }

    /// The nodes that some colliders of a body push from below.
    fn resting_on(&self, colliders: &[ColliderHandle], displaced: &Displaced) -> Vec<NodeId> {
        let mut found = Vec::new();
        let pairs = colliders.iter().flat_map(|&c| self.engine.narrow.contact_pairs_with(c));
        for pair in pairs.filter(|p| p.has_any_active_contact()) {
            let first = colliders.contains(&pair.collider1);
            let sign = if first { 1.0 } else { -1.0 };
            let up = self.touches_with(pair, displaced).any(|t| t.normal.z * sign > CARRIES);
            let other = if first { pair.collider2 } else { pair.collider1 };
            found.extend(self.node_of(other).filter(|_| up));
        }
        found.sort_unstable();
        found
    }

    /// The things that are pinned to moving parts which may move in this step, the bodies of these parts, and their poses.
    pub(crate) fn ridden(&self, awake: &[RigidBodyHandle]) -> Vec<(NodeId, RigidBodyHandle, Pose)> {
        if awake.is_empty() {
            return Vec::new();
        }
        let rider = |thing: &Thing| {
            let (id, link) = thing.state.rides.filter(|(_, link)| *link > 0)?;
            let body = self.part_body(id, link).filter(|body| awake.contains(body))?;
            Some((thing.id, body, self.engine.pose(body)?))
        };
        self.things.iter().filter_map(rider).collect()
    }

    /// Moves things that are pinned to moving parts along with these.
    pub(crate) fn take_riders_along(&mut self, ridden: Vec<(NodeId, RigidBodyHandle, Pose)>) {
        for (id, body, before) in ridden {
            if let Some(now) = self.engine.pose(body).filter(|now| *now != before) {
                self.carry_along(&[id], &(now * before.inverse()));
            }
        }
    }

    /// Moves things together, by a motion in the world's frame.
    pub(crate) fn carry_along(&mut self, load: &[NodeId], motion: &Pose) {
        for &id in load {
            let Some(base) = self.thing(id).ok().map(|t| t.state.base) else { continue };
            if let Some(pose) = self.engine.pose(base) {
                self.engine.place(base, convert::pose(&(motion * pose)));
            }
        }
    }
}
