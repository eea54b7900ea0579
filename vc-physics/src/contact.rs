//! Contacts as plain data.

use std::collections::BTreeMap;

use nalgebra::{Point3, Vector3};
use rapier3d::dynamics::RigidBodyHandle;
use rapier3d::geometry::{ColliderHandle, Contact as EngineContact, ContactManifold, ContactPair};
use rapier3d::math::Pose as EnginePose;
use vc_graph::asset::JointKind;
use vc_graph::{NodeId, Pose};

use crate::state::Thing;
use crate::world::PhysicsWorld;
use crate::{BodyRole, convert, group};

/// Two bodies that touch, or are about to.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Contact {
    /// The node with the smaller number.
    pub a: NodeId,
    /// The other node.
    pub b: NodeId,
    /// The contact normal from `a` towards `b`, unit length: the mean over the contact points, weighted by
    /// impulse.
    pub normal: Vector3<f32>,
    /// The mean position of the contact points, metres.
    pub point: Point3<f32>,
    /// The largest penetration depth, metres; negative for a gap.
    pub depth: f32,
    /// The impulse with which `a` pushed `b` in the last step, newton seconds.
    pub impulse: f32,
}

/// The smallest cosine between a push from below and the vertical for which the push counts as support.
const CARRIES: f32 = 0.5;
/// The largest gap between touching bodies, metres: the engine leaves such a gap.
const TOUCHING: f32 = 0.005;

/// Height of a hop of a thing, metres.
const HOP: f32 = 0.01;

/// A point where two bodies touch.
pub(crate) struct Touch {
    /// From the pair's first body to its second.
    pub(crate) normal: Vector3<f32>,
    pub(crate) at: Point3<f32>,
    pub(crate) gap: f32,
    impulse: f32,
}

/// A weighted sum of contact points.
#[derive(Default)]
struct Sum {
    normal: Vector3<f32>,
    point: Vector3<f32>,
    weight: f32,
    depth: f32,
    impulse: f32,
}

impl Sum {
    /// Adds a point; `sign` is positive if its normal points from a to b.
    fn add(&mut self, point: &Touch, sign: f32) {
        // Points without impulse count a little, for pairs that have just met.
        let weight = point.impulse.max(0.0) + 1e-6;
        self.depth = if self.weight == 0.0 { -point.gap } else { self.depth.max(-point.gap) };
        self.normal += point.normal * (weight * sign);
        self.point += point.at.coords * weight;
        self.weight += weight;
        self.impulse += point.impulse;
    }

    fn contact(self, a: NodeId, b: NodeId) -> Option<Contact> {
        let normal = self.normal.try_normalize(1e-12)?;
        let point = Point3::from(self.point / self.weight);
        Some(Contact { a, b, normal, point, depth: self.depth, impulse: self.impulse })
    }
}

/// # Contacts and loads
impl PhysicsWorld {
    /// All contacts of the last step, sorted by node numbers; contacts between parts of one node are left out.
    pub fn contacts(&self) -> Vec<Contact> {
        self.gather(self.engine.narrow.contact_pairs())
    }

    /// The contacts of a node.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// world.settle(300);
    /// let contacts = world.contacts_of(home.cup);
    /// assert_eq!((contacts[0].a, contacts[0].b), (home.table, home.cup));
    /// assert!(contacts[0].normal.z > 0.99); // The table pushes the cup up.
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn contacts_of(&self, id: NodeId) -> Vec<Contact> {
        let Ok(thing) = self.thing(id) else { return Vec::new() };
        self.gather(thing.bodies().flat_map(|body| self.pairs_of(body)))
    }

    pub(crate) fn pairs_of(&self, body: RigidBodyHandle) -> impl Iterator<Item = &ContactPair> {
        let colliders = self.engine.bodies.get(body).map_or(&[][..], |b| b.colliders());
        colliders.iter().flat_map(|&c| self.engine.narrow.contact_pairs_with(c))
    }

    fn gather<'a>(&self, pairs: impl Iterator<Item = &'a ContactPair>) -> Vec<Contact> {
        let mut sums: BTreeMap<(NodeId, NodeId), Sum> = BTreeMap::new();
        for pair in pairs.filter(|p| p.has_any_active_contact()) {
            let (Some(a), Some(b)) = (self.node_of(pair.collider1), self.node_of(pair.collider2)) else { continue };
            if a != b {
                let (key, sign) = if a < b { ((a, b), 1.0) } else { ((b, a), -1.0) };
                let sum = sums.entry(key).or_default();
                self.touches(pair).for_each(|t| sum.add(&t, sign));
            }
        }
        sums.into_iter().filter_map(|((a, b), sum)| sum.contact(a, b)).collect()
    }

    /// The points at which a pair touches. The engine keeps points while bodies move little, so their gaps are
    /// computed anew from the bodies' poses.
    pub(crate) fn touches<'a>(&'a self, pair: &'a ContactPair) -> impl Iterator<Item = Touch> + 'a {
        let place = |c: ColliderHandle| self.engine.colliders.get(c).map(|c| *c.position());
        let both = place(pair.collider1).zip(place(pair.collider2));
        let points = |manifold: &'a ContactManifold| manifold.points.iter().map(move |p| (manifold, p));
        let all = both.into_iter().flat_map(move |both| {
            pair.solver_manifolds().iter().flat_map(points).map(move |(manifold, point)| (both, manifold, point))
        });
        let touch =
            |((first, second), manifold, point): ((EnginePose, EnginePose), &ContactManifold, &EngineContact)| {
                let on_first = manifold.subshape_pos1().map_or(first, |p| first * *p) * point.local_p1;
                let on_second = manifold.subshape_pos2().map_or(second, |p| second * *p) * point.local_p2;
                let normal = manifold.data.normal;
                Touch {
                    normal: convert::vector3(normal),
                    at: convert::point3(on_first),
                    gap: (on_second - on_first).dot(normal),
                    impulse: point.data.impulse,
                }
            };
        all.map(touch).filter(|t| t.gap <= TOUCHING)
    }

    pub(crate) fn node_of(&self, collider: ColliderHandle) -> Option<NodeId> {
        self.engine.colliders.get(collider).map(|c| group::marked(c.user_data).0)
    }

    /// The supports of a node: the nodes that push it from below, the one that carries most first. As of the
    /// last step; a sleeping body keeps its supports.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// world.settle(300);
    /// assert_eq!(world.supports(home.cup), [home.table]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn supports(&self, id: NodeId) -> Vec<NodeId> {
        let below = |c: &Contact| {
            let (other, up) = if c.a == id { (c.b, -c.normal.z) } else { (c.a, c.normal.z) };
            (up > CARRIES).then_some((other, c.impulse * up))
        };
        let mut found: Vec<(NodeId, f32)> = self.contacts_of(id).iter().filter_map(below).collect();
        found.sort_by(|a, b| b.1.total_cmp(&a.1).then(a.0.cmp(&b.0)));
        found.into_iter().map(|(node, _)| node).collect()
    }

    /// The things that rest on a body, directly or through others: loose things, and things that are pinned to
    /// it.
    pub(crate) fn load_of(&self, body: RigidBodyHandle) -> Vec<NodeId> {
        let part = self.engine.bodies.get(body).map(|b| group::marked(b.user_data));
        part.map_or_else(Vec::new, |part| self.load_above(part, self.colliders_of(body)))
    }

    /// The things that a moving part carries: those on or in a body of its own; and on a part that moves with its
    /// base, if it is made to hold things, as a drawer is.
    pub(crate) fn load_of_part(&self, id: NodeId, part: usize) -> Vec<NodeId> {
        let Ok(thing) = self.thing(id) else { return Vec::new() };
        let (Some(moving), Some(link)) = (thing.state.moving.get(part), thing.form.links.get(part + 1)) else {
            return Vec::new();
        };
        let holds = || thing.form.surfaces.iter().any(|surface| surface.joint == link.joint);
        match moving.body {
            Some(body) => self.load_of(body),
            None if holds() => {
                let mark = group::mark(id, part + 1);
                let own = |c: &ColliderHandle| self.engine.colliders.get(*c).is_some_and(|c| c.user_data == mark);
                self.load_above((id, part + 1), self.colliders_of(thing.state.base).into_iter().filter(own).collect())
            }
            None => Vec::new(),
        }
    }

    fn colliders_of(&self, body: RigidBodyHandle) -> Vec<ColliderHandle> {
        self.engine.bodies.get(body).map_or_else(Vec::new, |body| body.colliders().to_vec())
    }

    /// The things that rest on some colliders of a node's link.
    fn load_above(&self, part: (NodeId, usize), colliders: Vec<ColliderHandle>) -> Vec<NodeId> {
        let (own, link) = part;
        let mut load = self.pinned_on(part);
        if link > 0 {
            load.extend(self.hovering_in(&colliders));
        }
        let base = |id: &NodeId| self.thing(*id).ok().map(|thing| thing.state.base);
        let mut open: Vec<_> = load.iter().filter_map(base).map(|body| self.colliders_of(body)).collect();
        open.push(colliders);
        while let Some(below) = open.pop() {
            let pinned = self.pinned_on_base(&below).into_iter();
            let loose = |id: &NodeId| self.role(*id) == Some(BodyRole::Loose);
            for above in pinned.chain(self.resting_on(&below).into_iter().filter(loose)) {
                if above != own && !load.contains(&above) {
                    load.push(above);
                    open.extend(base(&above).map(|body| self.colliders_of(body)));
                }
            }
        }
        load
    }

    /// The node and link on which a loose thing rests, directly or through others, if that link moves on a
    /// joint: a drawer, a rack, an open door.
    pub(crate) fn rides(&self, id: NodeId) -> Option<(NodeId, usize)> {
        let turns =
            |thing: &Thing, link: usize| thing.form.links[link].joint.is_some_and(|j| j.kind == JointKind::Hinge);
        let (mut seen, mut open) = (vec![id], vec![self.thing(id).ok()?.state.base]);
        while let Some(body) = open.pop() {
            let carriers = self.carriers(body);
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
        None
    }

    /// Things that fell asleep during a hop, a millimetre or two above their support: they touch nothing.
    fn hovering_in(&self, colliders: &[ColliderHandle]) -> Vec<NodeId> {
        let Some(around) = self.box_around(colliders.iter().copied()) else { return Vec::new() };
        let (low, high) = (around.min - Vector3::z() * HOP, around.max + Vector3::z() * HOP);
        let loose = self.things.iter().filter(|t| t.state.role == BodyRole::Loose && self.is_asleep(t.id));
        let above = |id: NodeId| {
            let own = self.aabb(id)?;
            let (centre, foot) = (own.centre(), own.min.z);
            let over = (low.x..=high.x).contains(&centre.x) && (low.y..=high.y).contains(&centre.y);
            Some(over && (low.z..=high.z).contains(&foot))
        };
        let touches = |base: RigidBodyHandle| self.pairs_of(base).any(|pair| pair.has_any_active_contact());
        loose.filter(|t| above(t.id) == Some(true) && !touches(t.state.base)).map(|t| t.id).collect()
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
    fn resting_on(&self, colliders: &[ColliderHandle]) -> Vec<NodeId> {
        let mut found = Vec::new();
        let pairs = colliders.iter().flat_map(|&c| self.engine.narrow.contact_pairs_with(c));
        for pair in pairs.filter(|p| p.has_any_active_contact()) {
            let first = colliders.contains(&pair.collider1);
            let sign = if first { 1.0 } else { -1.0 };
            let up = self.touches(pair).any(|t| t.normal.z * sign > CARRIES);
            let other = if first { pair.collider2 } else { pair.collider1 };
            found.extend(self.node_of(other).filter(|_| up));
        }
        found.sort_unstable();
        found
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
