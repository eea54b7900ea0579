//! The physical role of a node: fixed, loose, hung, or no body at all.

use nalgebra::Point3;
use serde::{Deserialize, Serialize};
use vc_graph::asset::{HOOK_REACH, Hold};
use vc_graph::class::Class;
use vc_graph::{Node, NodeKind, Property, Relation, SceneGraph};

use crate::settings::{FixedThings, Settings, UnsupportedThings};
use crate::shapes::Form;

/// The role of a body in the simulation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum BodyRole {
    /// The body stays where it is: the building, heavy furniture.
    Fixed,
    /// The body moves freely.
    Loose,
    /// The body hangs where it is until it is taken or pushed off.
    Hung,
    /// An agent's hand, or something in a hand, carries the body.
    Carried,
    /// The body became non-finite, flew off or fell below everything, and was stopped.
    Stopped,
}

/// The scene data that decide the roles.
pub(crate) struct Roles<'a> {
    graph: &'a SceneGraph,
    settings: Settings,
    places_are_known: bool,
}

impl<'a> Roles<'a> {
    pub(crate) fn new(graph: &'a SceneGraph, settings: Settings) -> Self {
        let rests = |n: &Node| graph.places(n.id()).any(|p| matches!(p.relation, Relation::On | Relation::Inside));
        let asks = settings.unplaced == UnsupportedThings::Hangs;
        Self { graph, settings, places_are_known: asks && graph.nodes().any(rests) }
    }

    /// The role of a node; `mass` is that of its asset, kilograms. `None` for rooms and agents, whose bodies
    /// are not made from assets.
    pub(crate) fn role(&self, node: &Node, class: Option<&Class>, form: &Form, mass: f32) -> Option<BodyRole> {
        if node.kind() != NodeKind::Object {
            return None;
        }
        if node.role().is_built_in() || self.stays(node, class.is_some(), mass) {
            return Some(BodyRole::Fixed);
        }
        let rests = self.graph.places(node.id()).next().is_some();
        let hangs = self.places_are_known && (!rests || self.is_on_a_hook(node, form));
        Some(if hangs { BodyRole::Hung } else { BodyRole::Loose })
    }

    /// Whether a hook of a node's support reaches into the node's bounding box: a coat on a rack, a shirt on
    /// the rail of a wardrobe.
    fn is_on_a_hook(&self, node: &Node, form: &Form) -> bool {
        let at = self.graph.place(node.id()).and_then(|p| self.graph.node(p.at));
        let asset = at.and_then(|at| self.graph.assets().get(at.spec().asset?));
        let (Some(at), Some(asset)) = (at, asset) else { return false };
        let (Some(from), Some(to)) = (at.pose(), node.pose()) else { return false };
        let (low, high) = form.extent;
        let hooks = asset.surfaces.iter().filter(|s| s.hold == Hold::Hook);
        let mut spots = hooks.map(|s| to.inv_mul(from) * Point3::from(s.centre.coords.component_mul(&at.spec().scale)));
        spots.any(|p| (0..3).all(|i| low[i] - HOOK_REACH <= p[i] && p[i] <= high[i] + HOOK_REACH))
    }

    fn stays(&self, node: &Node, known: bool, mass: f32) -> bool {
        let carried = node.affords(Property::Graspable);
        // For an unknown class only the mass can decide.
        let moves = !known || carried || node.affords(Property::Movable) || node.affords(Property::Drivable);
        match self.settings.fixing {
            FixedThings::Structure => false,
            FixedThings::Immovable => !moves,
            FixedThings::Heavy => {
                !moves || (!carried && mass > self.settings.heavy && !node.affords(Property::Drivable))
            }
        }
    }
}
