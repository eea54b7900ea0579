//! Queries to bodies that change nothing: which things are reachable, and where there is room.

use vc_graph::{Action, NodeId, Place, Relation, State, Verb};
use vc_physics::{Floor, PhysicsWorld};

use super::execute::{Bodies, FreeSpot, Planner, Step};
use super::{Environment, NoRoom};

impl Environment {
    /// Whether an agent would find a path to a spot in the thing's room from which its hands reach the thing
    /// and, if the thing is inside a closed container, the container too. A lamp under the ceiling is switched
    /// at the wall, so it need only be near.
    ///
    /// Uses `Floor::standing_pose_where` from the agent's position. Costs a copy of the free floor and up to a millisecond.
    pub fn can_get_at(&self, agent: NodeId, id: NodeId) -> bool {
        let mut floor = self.floor.clone();
        floor.update(&self.world);
        let step = self.unchanged(agent, Action::one(Verb::Walk, id));
        self.gets_at(&mut Planner::new(&self.world, &mut floor, &self.start, &step), id)
    }

    fn gets_at(&self, planner: &mut Planner<'_>, id: NodeId) -> bool {
        self.graph.hidden_in(id).is_none_or(|container| planner.can_get_at(container)) && planner.can_get_at(id)
    }

    /// An action of which the rule is not asked.
    fn unchanged(&self, agent: NodeId, action: Action) -> Step {
        Step { before: self.graph.clone(), after: self.graph.clone(), agent, action, pushes: false, claims: Vec::new() }
    }

    /// Whether there are free spots for all of some things, each at one of several places. The things are
    /// placed one after the other as an agent places held things: containers are opened, cloth may be folded up
    /// to make room, and the present contents are pushed together. Each spot has to be within reach from
    /// somewhere in the room and let the container shut again, and each thing has to be reachable while the container it
    /// goes into stands open.
    ///
    /// Uses `PhysicsWorld::set_openness`, `SpotSearch` and `PhysicsWorld::place` on a copy of the
    /// bodies. Costs a millisecond, and some more for each thing.
    ///
    /// # Errors
    /// [`NoRoom`] with the first thing for which no place has room, or to which no path is left.
    pub fn has_room(&self, agent: NodeId, wants: &[(NodeId, Vec<Place>)]) -> Result<(), NoRoom> {
        let (mut world, mut floor) = (self.world.clone(), self.floor.clone());
        for (id, places) in wants {
            if !places.iter().any(|place| self.puts(&mut world, &mut floor, agent, (*id, *place)).is_some()) {
                return Err(NoRoom(self.graph.label(*id)));
            }
        }
        Ok(())
    }

    /// Puts a thing at a place in a copy of the bodies, if there is room that can be reached.
    fn puts(
        &self,
        world: &mut PhysicsWorld,
        floor: &mut Floor,
        agent: NodeId,
        (id, place): (NodeId, Place),
    ) -> Option<()> {
        let inside = place.relation == Relation::Inside;
        let step = self.unchanged(agent, Action::two(if inside { Verb::PutIn } else { Verb::Place }, id, place.at));
        let is_shut = self.graph.node(place.at).is_some_and(|n| n.is(State::Closed));
        if inside && is_shut && !world.set_openness(place.at, 1.0, &[]).ok()? {
            return None;
        }
        floor.update(world);
        if !self.gets_at(&mut Planner::new(world, floor, &self.start, &step), id) {
            return None;
        }
        let FreeSpot { spot, first } = Planner::new(world, floor, &self.start, &step).spot(id, place).ok()?;
        for motion in &first {
            Bodies { world, start: &self.start, before: &self.graph, agent }.perform(motion).ok()?;
        }
        let room = self.graph.room_of(place.at);
        let (_, spot) = Planner::new(world, floor, &self.start, &step).stand_for(room, id, place, spot).ok()??;
        // The spot is finite and the thing exists.
        world.place(id, spot).ok()
    }
}
