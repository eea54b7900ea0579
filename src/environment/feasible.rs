//! Queries to bodies that change nothing: which things are reachable, and where there is room.

use vc_graph::{Action, NodeId, Place, Relation, State, Verb};

use super::Environment;
use super::execute::Execution;
use super::step::{RetryOptions, Step};

impl Environment {
    /// Whether an agent would find a path to a spot in the thing's room from which its hands reach the thing
    /// and, if the thing is inside a closed container, the container too. A lamp under the ceiling is switched
    /// at the wall, so it need only be near.
    ///
    /// Uses `Floor::standing_pose_where` from the agent's position. Costs a copy of the bodies, a millisecond.
    pub fn can_get_at(&self, agent: NodeId, id: NodeId) -> bool {
        let (mut world, mut floor) = (self.world.clone(), self.floor.clone());
        floor.update(&world);
        let action = Action::one(Verb::Walk, id);
        let (before, after, care) = (self.graph.clone(), self.graph.clone(), RetryOptions::default());
        let step = Step { before, after, agent, action, care };
        self.gets_at(&mut Execution::new(&mut world, &mut floor, &self.start, &step), id)
    }

    fn gets_at(&self, execution: &mut Execution<'_>, id: NodeId) -> bool {
        self.graph.hidden_in(id).is_none_or(|container| execution.can_get_at(container)) && execution.can_get_at(id)
    }

    /// Whether there are free spots for all of some things, each at one of several places. The things are
    /// placed one after the other as an agent places held things: containers are opened, cloth may be folded up
    /// to make room, and the present contents are pushed together. Each spot has to be within reach from
    /// somewhere in the room and let the container shut again, and each thing has to be reachable while the container it
    /// goes into stands open.
    ///
    /// Uses `World::set_openness`, `World::free_spot_at` and `World::place` on a copy of the bodies. Costs a
    /// millisecond, and some more for each thing.
    ///
    /// # Errors
    /// The first thing for which no place has room, or to which no path is left.
    pub fn has_room(&self, agent: NodeId, wants: &[(NodeId, Vec<Place>)]) -> Result<(), NodeId> {
        let (mut world, mut floor) = (self.world.clone(), self.floor.clone());
        floor.update(&world);
        for (id, places) in wants {
            let spot = places.iter().find_map(|&place| {
                let verb = if place.relation == Relation::Inside { Verb::PutIn } else { Verb::Place };
                let action = Action::two(verb, *id, place.at);
                let (before, after, care) = (self.graph.clone(), self.graph.clone(), RetryOptions::default());
                let step = Step { before, after, agent, action, care };
                let is_shut = self.graph.node(place.at).is_some_and(|n| n.is(State::Closed));
                if place.relation == Relation::Inside && is_shut && !world.set_openness(place.at, 1.0).ok()? {
                    return None;
                }
                floor.update(&world);
                let mut execution = Execution::new(&mut world, &mut floor, &self.start, &step);
                if !self.gets_at(&mut execution, *id) {
                    return None;
                }
                let spot = execution.spot(*id, place).ok()?;
                let stand = execution.stand_for(self.graph.room_of(place.at), *id, place, spot).ok()?;
                stand.map(|(_, spot)| spot)
            });
            // The spot is finite and the thing exists.
            let put = spot.is_some_and(|spot| world.place(*id, spot).is_ok());
            if !put {
                return Err(*id);
            }
        }
        Ok(())
    }
}
