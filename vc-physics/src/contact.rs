//! Contacts as plain data.

use std::collections::BTreeMap;

use nalgebra::{Point3, Vector3};
use rapier3d::dynamics::RigidBodyHandle;
use rapier3d::geometry::{ColliderHandle, Contact as EngineContact, ContactManifold, ContactPair};
use rapier3d::math::Pose as EnginePose;
use vc_graph::NodeId;

use crate::displaced::{Displaced, NONE};
use crate::state::Thing;
use crate::world::PhysicsWorld;
use crate::{convert, group};

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
pub(crate) const CARRIES: f32 = 0.5;
/// The largest gap between touching bodies, metres: the engine leaves such a gap.
const TOUCHING: f32 = 0.005;
/// How far the points of a contact may have slid apart since the engine found it, metres: a thing that has been moved along
/// by one of its supports touches the other no longer.
const SLID: f32 = 0.02;

/// A point where two bodies touch.
pub(crate) struct Touch {
    /// From the pair's first body to its second.
    pub(crate) normal: Vector3<f32>,
    pub(crate) at: Point3<f32>,
    pub(crate) gap: f32,
    slid: f32,
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

/// # Contacts
impl PhysicsWorld {
    /// All contacts of the last step, sorted by node numbers; contacts between parts of one node are left out.
    pub fn contacts(&self) -> Vec<Contact> {
        self.gather(self.engine.narrow.contact_pairs())
    }

    /// The contacts of a thing.
    pub(crate) fn contacts_of(&self, thing: &Thing) -> Vec<Contact> {
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
        self.touches_with(pair, &NONE)
    }

    /// As [`Self::touches`], where some bodies are displaced.
    pub(crate) fn touches_with<'a>(
        &'a self,
        pair: &'a ContactPair,
        displaced: &Displaced,
    ) -> impl Iterator<Item = Touch> + use<'a> {
        let place = |c: ColliderHandle| self.collider_pose(c, displaced);
        let both = place(pair.collider1).zip(place(pair.collider2));
        let points = |manifold: &'a ContactManifold| manifold.points.iter().map(move |p| (manifold, p));
        let all = both.into_iter().flat_map(move |both| {
            pair.solver_manifolds().iter().flat_map(points).map(move |(manifold, point)| (both, manifold, point))
        });
        let touch =
            |((first, second), manifold, point): ((EnginePose, EnginePose), &ContactManifold, &EngineContact)| {
                let on_first = manifold.subshape_pos1().map_or(first, |p| first * *p) * point.local_p1;
                let on_second = manifold.subshape_pos2().map_or(second, |p| second * *p) * point.local_p2;
                let (normal, between) = (manifold.data.normal, on_second - on_first);
                let gap = between.dot(normal);
                Touch {
                    normal: convert::vector3(normal),
                    at: convert::point3(on_first),
                    gap,
                    slid: (between - normal * gap).length(),
                    impulse: point.data.impulse,
                }
            };
        all.map(touch).filter(|t| t.gap <= TOUCHING && t.slid <= SLID)
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
        let contacts = self.thing(id).map_or_else(|_| Vec::new(), |thing| self.contacts_of(thing));
        let mut found: Vec<(NodeId, f32)> = contacts.iter().filter_map(below).collect();
        found.sort_by(|a, b| b.1.total_cmp(&a.1).then(a.0.cmp(&b.0)));
        found.into_iter().map(|(node, _)| node).collect()
    }
}
