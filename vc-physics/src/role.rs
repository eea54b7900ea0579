//! Which part a node plays: fixed, loose, hung, or no body at all.

use nalgebra::Point3;
use serde::{Deserialize, Serialize};
use vc_graph::asset::Hold;
use vc_graph::class::{Category, Class};
use vc_graph::{Kind, Node, Property, Relation, SceneGraph};

use crate::settings::{Fixing, Settings, Unplaced};
use crate::shapes::Form;

/// How far from the box around a thing the hook may be that it hangs on, metres.
const HOOK: f32 = 0.05;

/// How a body takes part.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Role {
    /// It stays where it is: the building, heavy furniture.
    Fixed,
    /// It moves freely.
    Loose,
    /// It hangs where it is until it is taken or pushed off.
    Hung,
    /// An agent's hand, or something that one holds, carries it.
    Carried,
    /// It became non-finite, flew off or fell below everything, and was stopped.
    Stopped,
}

/// What deciding needs to know about the whole scene.
pub(crate) struct Roles<'a> {
    graph: &'a SceneGraph,
    settings: Settings,
    places_are_known: bool,
}

impl<'a> Roles<'a> {
    pub(crate) fn new(graph: &'a SceneGraph, settings: Settings) -> Self {
        let rests = |n: &Node| graph.places(n.id()).any(|p| matches!(p.relation, Relation::On | Relation::Inside));
        let asks = settings.unplaced == Unplaced::Hangs;
        Self { graph, settings, places_are_known: asks && graph.nodes().any(rests) }
    }

    /// The part a node plays; `mass` is what its asset has, kilograms. `None` for
    /// rooms and agents, whose bodies are not made of assets.
    pub(crate) fn of(&self, node: &Node, class: Option<&Class>, form: &Form, mass: f32) -> Option<Role> {
        if node.kind() != Kind::Object {
            return None;
        }
        if is_structure(node, class) || self.stays(node, class.is_some(), mass) {
            return Some(Role::Fixed);
        }
        let rests = self.graph.places(node.id()).next().is_some();
        let hangs = self.places_are_known && (!rests || self.is_on_a_hook(node, form));
        Some(if hangs { Role::Hung } else { Role::Loose })
    }

    /// Whether a hook of what a node is at reaches into the box around it: a coat on a
    /// rack, a shirt on the rail of a wardrobe.
    fn is_on_a_hook(&self, node: &Node, form: &Form) -> bool {
        let at = self.graph.place(node.id()).and_then(|p| self.graph.node(p.at));
        let asset = at.and_then(|at| self.graph.assets().get(at.spec().asset?));
        let (Some(at), Some(asset)) = (at, asset) else { return false };
        let (Some(from), Some(to)) = (at.pose(), node.pose()) else { return false };
        let (low, high) = form.extent;
        let hooks = asset.surfaces.iter().filter(|s| s.hold == Hold::Hook);
        let mut spots = hooks.map(|s| to.inv_mul(from) * Point3::from(s.centre.coords.component_mul(&at.spec().scale)));
        spots.any(|p| (0..3).all(|i| low[i] - HOOK <= p[i] && p[i] <= high[i] + HOOK))
    }

    fn stays(&self, node: &Node, known: bool, mass: f32) -> bool {
        let carried = node.affords(Property::Graspable);
        // Of a class nobody knows only the mass can tell.
        let moves = !known || carried || node.affords(Property::Movable) || node.affords(Property::Drivable);
        match self.settings.fixing {
            Fixing::Structure => false,
            Fixing::Immovable => !moves,
            Fixing::Heavy => !moves || (!carried && mass > self.settings.heavy && !node.affords(Property::Drivable)),
        }
    }
}

/// Whether a node is part of the building.
pub(crate) fn is_structure(node: &Node, class: Option<&Class>) -> bool {
    match class {
        Some(class) => matches!(class.category, Category::Structure | Category::Door | Category::Window),
        None => matches!(&*node.spec().category, "structure" | "door" | "window" | "Floors" | "Walls" | "Doors"),
    }
}
