//! Things that go from environment to environment by themselves, and how nodes come and go.

use vc_graph::space::{Load, RegionId};
use vc_graph::{Action, ChangeSet, NodeId, Pose, Verb};
use vc_physics::{BodyRole, Cargo};

use super::{Environment, PhysicalRefusal, TravelError, observe};

/// How near a thing is to what it lies on or in, metres.
const TOUCHING: f32 = 0.05;

/// Things that have left an environment, with their bodies.
#[derive(Clone)]
pub(crate) struct Freight {
    cargo: Cargo,
    load: Load,
}

impl Freight {
    /// The thing and all that is on or in it.
    pub(crate) fn nodes(&self) -> impl Iterator<Item = NodeId> + '_ {
        self.load.ids()
    }
}

impl Environment {
    /// Takes a loose thing out of the environment of a region, with all that is on or in it, as it moves. Where it has been
    /// is forgotten: what it lies on beyond is nothing of this region.
    pub(crate) fn send_off(&mut self, thing: NodeId, region: RegionId) -> Result<Freight, TravelError> {
        self.catch_up();
        let mut graph = self.graph.clone();
        let mut edit = graph.edit();
        let gone = |id: &NodeId| *id == thing || self.carrier(*id) != thing;
        for id in self.graph.carried_with(thing).into_iter().filter(gone) {
            // It is no room, and nobody holds what is loose. Whatever was on or in the thing and flies elsewhere stays here.
            let _ = edit.detach(id);
        }
        let left = edit.commit();
        let load = Load::new(&graph, thing, region)?;
        let nodes: Vec<NodeId> = load.ids().filter(|id| self.world.role(*id).is_some()).collect();
        let cargo = self.world.take_away(&nodes).map_err(|why| PhysicalRefusal::from(why).in_scene(&self.graph))?;
        self.clock.about_to_change(&self.graph);
        self.graph = graph;
        self.clock.note(left);
        self.let_go(&load)?;
        Ok(Freight { cargo, load })
    }

    /// Lets things enter a room of this region, poses and velocities taken over by a transformation.
    pub(crate) fn take_in(
        &mut self,
        freight: &Freight,
        (region, room): (RegionId, NodeId),
        shift: &Pose,
    ) -> Result<(), TravelError> {
        self.catch_up();
        self.clock.about_to_change(&self.graph);
        let changes = freight.load.enter((&mut self.graph, region), shift, room)?;
        let asset = |id| self.graph.node(id).and_then(|node| node.spec().asset);
        let cargo = freight.cargo.clone().with_assets(asset);
        self.world.bring(&cargo, shift).map_err(PhysicalRefusal::from)?;
        self.let_in(&freight.load, &changes)
    }

    /// The loose thing on or in which a thing is, directly or through others, if it is not itself: what goes where that goes.
    /// The scene may be late: what has fallen off is no longer on it.
    pub(crate) fn carrier(&self, thing: NodeId) -> NodeId {
        let touches = |one: NodeId, other: NodeId| {
            self.world.aabb(one).zip(self.world.aabb(other)).is_some_and(|(one, other)| one.gap(&other) < TOUCHING)
        };
        let holds = |id: NodeId, at: NodeId| self.world.role(at) == Some(BodyRole::Loose) && touches(id, at);
        let above = |id: &NodeId| self.graph.places(*id).map(|place| place.at).find(|at| holds(*id, *at));
        let all = std::iter::successors(Some(thing), above).take(self.graph.len());
        all.last().unwrap_or(thing)
    }

    /// Lets a threshold be barred, or not.
    pub(crate) fn set_barred(&mut self, bar: NodeId, barred: bool) {
        if self.world.is_barred(bar) != barred {
            self.world.set_barred(bar, barred);
        }
    }

    /// Whether somebody is opening or shutting a thing, or about to, or it is pushed on against others.
    pub(crate) fn is_moved_by_hand(&self, leaf: NodeId) -> bool {
        let moves = |action: &Action| matches!(action.verb, Verb::Open | Verb::Close) && action.object == Some(leaf);
        self.world.parts(leaf).is_driven()
            || self.agents().iter().any(|agent| self.current_action(*agent).is_some_and(moves))
    }

    /// Reads what has moved, before nodes come or go: so that it is known on what things rest, and with whom they go.
    pub(crate) fn catch_up(&mut self) {
        // Whatever fell out of here is elsewhere in the city.
        drop(self.read_moved());
    }

    /// Takes nodes out of the scene whose bodies have gone.
    pub(super) fn let_go(&mut self, load: &Load) -> Result<(), TravelError> {
        let nodes: Vec<NodeId> = load.ids().collect();
        self.clock.about_to_change(&self.graph);
        let changes = load.leave(&mut self.graph)?;
        self.excuse(&nodes);
        self.clock.note(changes);
        Ok(self.read_anew(&nodes)?)
    }

    /// Takes note of nodes that have come, by their changes of the scene.
    pub(super) fn let_in(&mut self, load: &Load, changes: &ChangeSet) -> Result<(), TravelError> {
        let nodes: Vec<NodeId> = load.ids().collect();
        self.clock.note(changes.clone());
        let moving: Vec<NodeId> = nodes.iter().copied().filter(|id| !self.world.rests(&[*id])).collect();
        self.set_adrift(&moving);
        self.excuse(&nodes);
        Ok(self.read_anew(&nodes)?)
    }

    /// Reads relations anew, since nodes have come or gone. Whatever has moved before is [read](Self::catch_up) by then.
    fn read_anew(&mut self, nodes: &[NodeId]) -> Result<(), PhysicalRefusal> {
        let here: Vec<NodeId> = nodes.iter().copied().filter(|id| self.graph.node(*id).is_some()).collect();
        let (_, poses) = observe::write_poses(&mut self.graph, &self.world)?;
        self.clock.note(poses);
        self.relations.set_evidence(&self.graph, observe::evidence(&self.world))?;
        self.relations.rebuild(&self.graph)?;
        let (graph, world) = (&mut self.graph, &mut self.world);
        let (_, seen) = observe::look_again(graph, &self.start, world, &mut self.relations, &here)?;
        self.clock.note(seen);
        self.clock.scene_changed();
        self.clock.stirred = true;
        self.look_anew();
        Ok(())
    }
}
