//! Questions to bodies that change nothing: what can be got at, and what there is room for.

use vc_graph::{Action, NodeId, Place, Relation, Verb};

use super::Environment;
use super::deed::Deed;
use super::undo::Step;

impl Environment {
    /// Whether an agent would find a way to a spot from which a thing is within reach of its
    /// hands, in the thing's room; if the thing is shut away, the container. What hangs under
    /// the ceiling is looked at, and switched at the wall: it need only be near.
    ///
    /// `Floor::stand_where` from where the agent is. Costs a copy of the bodies, a millisecond.
    pub fn can_get_at(&self, agent: NodeId, id: NodeId) -> bool {
        let id = self.graph.hidden_in(id).unwrap_or(id);
        let (mut world, mut floor) = (self.world.clone(), self.floor.clone());
        floor.update(&world);
        let action = Action::one(Verb::Walk, id);
        let step = Step { before: self.graph.clone(), after: self.graph.clone(), agent, action };
        Deed::new(&mut world, &mut floor, &self.start.shapes, &step).can_get_at(id)
    }

    /// Whether there is a free spot for a thing on or in another, as an agent puts a held thing
    /// there: cloth may be folded up for it, and what is there pushed together.
    pub fn has_room(&self, agent: NodeId, id: NodeId, place: Place) -> bool {
        let verb = if place.relation == Relation::Inside { Verb::PutIn } else { Verb::Place };
        let (mut world, mut floor) = (self.world.clone(), self.floor.clone());
        let action = Action::two(verb, id, place.at);
        let step = Step { before: self.graph.clone(), after: self.graph.clone(), agent, action };
        Deed::new(&mut world, &mut floor, &self.start.shapes, &step).spot(id, place).is_ok()
    }
}
