//! Folding of cloth, which takes whatever form there is room for.

use nalgebra::Vector3;
use vc_graph::portable::Portable;
use vc_graph::{NodeId, SceneGraph};

use crate::shapes::ShapeCache;
use crate::state::Thing;
use crate::world::PhysicsWorld;
use crate::{PhysicsError, group};

/// Density of loosely folded cloth, kilograms per cubic metre: that of a full drum of laundry, 7 kg in 60
/// litres.
const LOOSE: f32 = 115.0;
/// The sides of a bundle, relative to the longest.
const FLAT: Vector3<f32> = Vector3::new(1.0, 1.0, 0.5);

/// The scale along a thing's own axes if it were cloth folded to a flat bundle with the volume that its mass takes.
/// `None` if it would be no smaller.
pub(crate) fn folded_scale(thing: &Thing) -> Option<Vector3<f32>> {
    let (low, high) = thing.form.extent;
    let size = (high - low).map(|v| v.max(1e-4));
    let volume = thing.mass() / LOOSE;
    let bundle = FLAT * (volume / FLAT.product()).cube_root();
    let smaller = volume > 0.0 && bundle.max() < size.max();
    smaller.then(|| bundle.component_div(&size))
}

/// # Cloth
impl PhysicsWorld {
    /// Gives a node the shape that the graph has for it now, at another scale, at its pose or in the hand that
    /// holds it. It keeps its mass. [`BodyView::folded_scale`](crate::BodyView::folded_scale) gives the scale of folded
    /// cloth.
    ///
    /// # Errors
    /// [`PhysicsError::NoSuchNode`], [`PhysicsError::NoBody`]; [`PhysicsError::NotFree`] for a node with moving
    /// parts.
    pub fn reshape(&mut self, graph: &SceneGraph, id: NodeId, shapes: &ShapeCache) -> Result<(), PhysicsError> {
        let node = graph.node(id).ok_or(PhysicsError::NoSuchNode(id))?;
        if self.thing(id)?.form.links.len() > 1 {
            return Err(PhysicsError::NotFree(id));
        }
        let form = shapes.session(graph.assets(), |session| session.form(graph, node));
        let form = form.filter(|f| f.links.len() == 1 && f.is_of_this_world()).ok_or(PhysicsError::NoBody(id))?;
        let mass = self.thing(id)?.mass();
        let spec = node.spec();
        let thing = self.thing_mut(id)?;
        thing.state.mass_factor = if form.mass() > 0.0 { mass / form.mass() } else { 1.0 };
        (thing.state.asset, thing.state.scale) = (spec.asset, spec.scale.map(f32::to_bits).into());
        thing.form = form;
        let (form, role, base, factor) =
            (thing.form.clone(), thing.state.role, thing.state.base, thing.state.mass_factor);
        self.engine.strip(base);
        if let Some((shape, at)) = &form.links[0].solid {
            let collider = form.links[0].collider(shape, at, factor).collision_groups(group::base(role));
            self.engine.add_collider(collider.user_data(group::mark(id, 0)).build(), base);
        }
        self.engine.refresh(base);
        Ok(())
    }
}
