//! Reset to the start, or to a scene that differs a little.

use vc_graph::{Node, NodeId, NodeKind, Pose, SceneGraph};

use crate::role::Roles;
use crate::shapes::ShapeCache;
use crate::state::Thing;
use crate::world::PhysicsWorld;
use crate::{BodyRole, PhysicsError, convert};

/// The result of a reset.
#[derive(Debug, Clone, PartialEq, Default)]
#[non_exhaustive]
pub struct Reset {
    /// Whether the world was built anew because too much differs.
    pub built: bool,
    /// Nodes that were moved.
    pub moved: Vec<NodeId>,
    /// Nodes that were inserted.
    pub inserted: Vec<NodeId>,
    /// Nodes that were removed.
    pub removed: Vec<NodeId>,
    /// Nodes whose doors, lids or drawers were opened or closed.
    pub turned: Vec<NodeId>,
}

/// The largest difference of two equal poses, metres and quaternion units.
const SAME: f32 = 1e-5;

/// # Reset
impl PhysicsWorld {
    /// A world for a scene that differs little from the one this world was built from: a copy of this world in
    /// which only the differing things are changed. Keep a settled world for each scene and reset from it.
    ///
    /// Things at the same pose in the graph as when this world was built stay where they have settled, asleep.
    /// Things at another pose are moved there, awake, and new things are inserted. Agents stand where the graph
    /// has them. If more than half of the scene differs, if a node has another shape than before, if the agents
    /// differ or anybody holds anything, the world is built anew.
    ///
    /// Costs a clone, and some microseconds for each difference.
    ///
    /// # Errors
    /// As [`PhysicsWorld::build`]; [`PhysicsError::Locked`] if a part that would have to open or close is locked.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// world.settle(300);
    /// let start = world.clone();
    /// world.place(home.cup, vc_graph::Pose::translation(0.0, 1.0, 1.0))?;
    /// let (fresh, report) = start.reset(&home.graph, &vc_physics::ShapeCache::new())?;
    /// assert!(!report.built && report.moved.is_empty());
    /// assert_eq!(fresh.digest(), start.digest());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn reset(&self, graph: &SceneGraph, shapes: &ShapeCache) -> Result<(Self, Reset), PhysicsError> {
        let Some(mut plan) = self.plan(graph) else {
            let world = Self::build(graph, shapes, self.settings)?;
            return Ok((world, Reset { built: true, ..Reset::default() }));
        };
        let mut world = self.clone();
        plan.removed.iter().try_for_each(|&id| world.remove(id))?;
        // Doors take along the things on them, of which the graph may say where they are then.
        for &id in &plan.turned {
            let open = graph.node(id).is_some_and(|n| n.is(vc_graph::State::Open));
            world.put_open(id, None, if open { 1.0 } else { 0.0 })?;
        }
        for &id in &plan.moved {
            if let Some(pose) = graph.node(id).and_then(Node::pose) {
                world.place(id, *pose)?;
                world.thing_mut(id)?.state.written = *pose;
            }
        }
        world.give_roles(graph, &plan.moved)?;
        for id in std::mem::take(&mut plan.inserted) {
            match world.insert(graph, id, shapes) {
                Ok(()) => plan.inserted.push(id),
                // A node with neither pose nor shape is skipped, as in building a world.
                Err(PhysicsError::NoBody(_)) => world.skipped.push(id),
                Err(error) => return Err(error),
            }
        }
        world.skipped.sort_unstable();
        for (&id, agent) in &self.agents {
            let stays = |p: &Pose| same(p, &agent.feet) || (same(p, &agent.written) && agent.has_only_landed());
            if let Some(pose) = graph.node(id).and_then(Node::pose).filter(|p| !stays(p))
                && world.teleport(id, *pose).is_err()
            {
                return Err(PhysicsError::NotFinite("the pose", id));
            }
        }
        for id in plan.moved.iter().chain(&plan.inserted) {
            world.thing_mut(*id)?.state.rests = graph.place(*id);
        }
        Ok((world, plan))
    }

    /// A moved thing may now hang where it lay before, or lie where it hung.
    fn give_roles(&mut self, graph: &SceneGraph, moved: &[NodeId]) -> Result<(), PhysicsError> {
        let roles = Roles::new(graph, self.settings);
        for &id in moved {
            let (Some(node), thing) = (graph.node(id), self.thing(id)?) else { continue };
            let class = graph.classes().get(node.class());
            let role = roles.role(node, class, &thing.form, thing.mass());
            if let Some(role) = role.filter(|r| *r != thing.state.role && thing.state.role != BodyRole::Stopped) {
                self.set_role(id, role)?;
            }
        }
        Ok(())
    }

    /// The differences; `None` if building anew is better.
    fn plan(&self, graph: &SceneGraph) -> Option<Reset> {
        let mut plan = Reset::default();
        let mut things = self.things.iter().peekable();
        for node in graph.nodes().filter(|n| n.kind() == NodeKind::Object) {
            while let Some(gone) = things.next_if(|t| t.id < node.id()) {
                plan.removed.push(gone.id);
            }
            match things.next_if(|t| t.id == node.id()) {
                Some(thing) => self.compare(thing, node, &mut plan)?,
                None if self.skipped.binary_search(&node.id()).is_ok() => {}
                None => plan.inserted.push(node.id()),
            }
        }
        plan.removed.extend(things.map(|t| t.id));
        let differs = plan.moved.len() + plan.inserted.len() + plan.removed.len();
        (differs * 2 <= self.things.len() && self.has_agents_of(graph)).then_some(plan)
    }

    /// Whether the graph has the same agents, and nobody holds anything, in the graph or here.
    fn has_agents_of(&self, graph: &SceneGraph) -> bool {
        let standing = graph.agents().iter().filter(|a| graph.node(**a).is_some_and(|n| n.pose().is_some()));
        let idle = self.agents.values().all(|a| a.hands.iter().all(Option::is_none));
        idle && standing.copied().eq(self.agents.keys().copied())
            && graph.agents().iter().all(|a| graph.held(*a).next().is_none())
    }

    fn compare(&self, thing: &Thing, node: &Node, plan: &mut Reset) -> Option<()> {
        let spec = node.spec();
        let scale = [spec.scale.x, spec.scale.y, spec.scale.z].map(f32::to_bits);
        if spec.asset != thing.state.asset || scale != thing.state.scale {
            return None;
        }
        match node.pose() {
            None => plan.removed.push(thing.id),
            Some(pose) if !convert::is_sound(pose) => return None,
            Some(pose) => {
                let near = |other: &Pose| same(pose, other);
                if !near(&thing.state.written) && !self.engine.pose(thing.state.base).is_some_and(|p| near(&p)) {
                    plan.moved.push(thing.id);
                }
                let open = self.open_state(thing.id).map(|s| s == vc_graph::State::Open);
                if open.is_some_and(|open| open != node.is(vc_graph::State::Open)) {
                    plan.turned.push(thing.id);
                }
            }
        }
        Some(())
    }
}

/// Whether two poses are the same.
fn same(a: &Pose, b: &Pose) -> bool {
    let turn = a.rotation.coords.dot(&b.rotation.coords).abs();
    (a.translation.vector - b.translation.vector).norm() < SAME && 1.0 - turn < SAME
}
