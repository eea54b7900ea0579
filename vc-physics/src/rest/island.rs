//! The question whether something rests, with all that it touches.

use std::collections::BTreeSet;

use rapier3d::dynamics::RigidBodyHandle;
use vc_graph::NodeId;

use crate::group;
use crate::world::PhysicsWorld;

impl PhysicsWorld {
    /// Whether some nodes rest, with what they touch and what that touches, up to whatever does not move by itself:
    /// all of it sleeps, no motor drives the nodes, and those of them that are agents neither walk nor fall. Nodes
    /// without a body rest.
    ///
    /// As of the last step: bodies that have been placed, pushed or opened since then are awake, but a thing that has
    /// lost its support by that learns so with the next step. Things that rest stay where they are, step after step,
    /// until something comes and touches them.
    ///
    /// Costs some hundred nanoseconds for each thing that is touched; what is awake elsewhere does not matter.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// world.settle(300);
    /// assert!(world.rests(&[home.cup, home.person]));
    /// world.drive(home.cabinet, 0, 1.0)?;
    /// world.step();
    /// assert!(world.rests(&[home.cup]) && !world.rests(&[home.cup, home.cabinet]));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn rests(&self, ids: &[NodeId]) -> bool {
        let moves = |id: &NodeId| self.is_driven(*id) || self.agents.get(id).is_some_and(|agent| !agent.is_still());
        if ids.iter().any(moves) {
            return false;
        }
        let mut open: Vec<RigidBodyHandle> = ids.iter().flat_map(|id| self.bodies_of(*id)).collect();
        // A table does not move, but what stands on it may.
        let around: Vec<RigidBodyHandle> = open.iter().flat_map(|body| self.bodies_touched(*body)).collect();
        open.extend(around);
        let mut seen = BTreeSet::new();
        while let Some(body) = open.pop() {
            let Some(rigid) = self.engine.bodies.get(body).filter(|b| b.is_dynamic()) else { continue };
            if !rigid.is_sleeping() {
                return false;
            }
            if seen.insert(body.into_raw_parts()) {
                open.extend(self.joined(body));
                open.extend(self.bodies_touched(body));
            }
        }
        true
    }

    fn bodies_of(&self, id: NodeId) -> Vec<RigidBodyHandle> {
        let agent = self.agents.get(&id).map(|agent| agent.body);
        self.thing(id).map_or_else(|_| agent.into_iter().collect(), |thing| thing.bodies().collect())
    }

    /// The base of a part; the parts of a base.
    fn joined(&self, body: RigidBodyHandle) -> Vec<RigidBodyHandle> {
        let mark = self.engine.bodies.get(body).map(|b| group::marked(b.user_data));
        let thing = mark.and_then(|(id, _)| self.thing(id).ok());
        match (thing, mark) {
            (Some(thing), Some((_, 0))) => thing.bodies().skip(1).collect(),
            (Some(thing), _) => vec![thing.state.base],
            _ => Vec::new(),
        }
    }
}
