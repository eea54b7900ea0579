//! A home as pictures begin with it: its snapshot, and what of it can differ later.

use std::collections::BTreeSet;

use vc_graph::asset::Joint;
use vc_graph::{Node, NodeId, NodeKind, ObjectRole, Pose, Property, Relation, SceneGraph, State};
use vc_people::{Bone, clothes};
use vc_physics::BodyRole;
use vc_render::{Coat, RenderError, Renderer, Snapshot};

use super::light::{lit, switch};
use crate::Environment;
use crate::environment::position;

/// Which part of a home is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Extent {
    /// All of it.
    Whole,
    /// Its outside: floors, walls, doors, windows and what is drawn over them.
    Shell,
}

impl Extent {
    fn has(self, graph: &SceneGraph, id: NodeId) -> bool {
        let is_built_in = || graph.node(id).is_some_and(|node| node.role().is_built_in());
        self == Self::Whole || is_built_in() || graph.covers_windows(id)
    }
}

/// A home as it begins, or a part of it, for a renderer.
#[derive(Debug)]
pub(super) struct Stage {
    pub(super) snapshot: Snapshot,
    pub(super) poses: Vec<(NodeId, Pose)>,
    /// The nodes that can be seen.
    seen: Vec<NodeId>,
    /// Those of them that are not fixed.
    pub(super) loose: BTreeSet<NodeId>,
    pub(super) lit: Vec<NodeId>,
    /// Vessels, and whether something is in them.
    pub(super) vessels: Vec<(NodeId, bool)>,
    /// Nodes with moving parts.
    pub(super) jointed: Vec<NodeId>,
    /// Those of them that let light into rooms.
    pub(super) openings: Vec<NodeId>,
    /// Blinds, curtains and other things that are drawn over windows.
    pub(super) covers: Vec<NodeId>,
    /// The things that can light rooms.
    pub(super) lamps: Vec<NodeId>,
    /// Those who have come since the home was made, with what they carry, if light is made without them.
    pub(super) visitors: Vec<NodeId>,
}

impl Stage {
    pub(super) fn new(environment: &Environment, renderer: &mut Renderer, extent: Extent) -> Result<Self, RenderError> {
        let (graph, world) = environment.origin();
        let all = renderer.snapshot_with(graph, |id, joint| position(graph, world, id, joint))?;
        let snapshot = if extent == Extent::Whole { all } else { all.from_outside(|id| extent.has(graph, id)) };
        let body = |n: &&Node| n.kind() != NodeKind::Room;
        let poses = graph.nodes().filter(body).filter_map(|n| Some((n.id(), *n.pose()?)));
        let seen: Vec<NodeId> = snapshot.nodes().collect();
        let is_seen = |id: &NodeId| seen.binary_search(id).is_ok();
        let poses = poses.filter(|(id, _)| is_seen(id)).collect();
        let fixed = |id: &NodeId| world.role(*id) == Some(BodyRole::Fixed);
        let loose = seen.iter().copied().filter(|id| !fixed(id)).collect();
        let has_parts = |id: &NodeId| !world.parts(*id).all().is_empty() && is_seen(id);
        let jointed: Vec<NodeId> = world.nodes().into_iter().filter(has_parts).collect();
        let lets_in =
            |id: &NodeId| graph.node(*id).is_some_and(|n| matches!(n.role(), ObjectRole::Door | ObjectRole::Window));
        let openings = jointed.iter().copied().filter(lets_in).collect();
        let node = |id: &NodeId| graph.node(*id).filter(|n| n.affords(Property::Recipient));
        let vessels = seen.iter().filter_map(|id| Some((*id, node(id)?.contents().is_some()))).collect();
        let covers = seen.iter().copied().filter(|id| graph.covers_windows(*id)).collect();
        let lamps = snapshot.lamps().collect();
        let lit = lit(graph).into_iter().filter(is_seen).collect();
        let visitors = Vec::new();
        Ok(Self { lit, snapshot, poses, loose, vessels, jointed, openings, covers, lamps, visitors, seen })
    }

    /// The same with everything where it was when the home was made, and light without those who have come since: so it
    /// does not matter when the first picture is asked for.
    pub(super) fn begun(mut self, home: &Environment) -> Result<Self, RenderError> {
        let start = home.start();
        for (id, pose) in &mut self.poses {
            let Some(first) = start.node(*id).and_then(|node| node.pose()) else {
                self.visitors.push(*id);
                continue;
            };
            if first != pose {
                let room = home.room_at(first.translation.vector.xy().into()).or_else(|| start.room_of(*id));
                self.snapshot.place(*id, first)?;
                self.snapshot.enter(*id, room)?;
                *pose = *first;
            }
        }
        for (id, full) in &mut self.vessels {
            let contents = start.node(*id).and_then(|node| node.contents());
            self.snapshot.fill(*id, contents.map(AsRef::as_ref))?;
            *full = contents.is_some();
        }
        for node in self.seen.iter().filter_map(|id| start.node(*id)) {
            self.snapshot.coat(node.id(), Coat::from_node(node))?;
        }
        Ok(self)
    }

    /// The things that are lit now and can be seen.
    pub(super) fn lit_now(&self, graph: &SceneGraph) -> Vec<NodeId> {
        lit(graph).into_iter().filter(|id| self.seen.binary_search(id).is_ok()).collect()
    }

    /// The home as it is now.
    pub(super) fn now(&self, home: &Environment) -> Result<Snapshot, RenderError> {
        let mut snapshot = self.snapshot.clone();
        for (id, was) in &self.poses {
            let now = home.graph().node(*id).and_then(|n| n.pose());
            if let Some(now) = now.filter(|now| *now != was) {
                snapshot.place(*id, now)?;
                snapshot.enter(*id, home.room_of_place(*id, now))?;
            }
        }
        switch(&mut snapshot, &self.lit, &self.lit_now(home.graph()))?;
        for node in self.seen.iter().filter_map(|id| home.graph().node(*id)) {
            // Dirt comes and goes.
            snapshot.coat(node.id(), Coat::from_node(node))?;
        }
        for (id, _) in &self.vessels {
            let contents = home.graph().node(*id).and_then(|n| n.contents());
            snapshot.fill(*id, contents.map(AsRef::as_ref))?;
        }
        for id in &self.covers {
            snapshot.draw_cover(*id, home.graph().node(*id).is_some_and(|n| n.is(State::Closed)))?;
        }
        for id in &self.jointed {
            snapshot.articulate(*id, |joint| position(home.graph(), home.world(), *id, joint))?;
        }
        let people = home.agents().iter().filter(|id| self.seen.binary_search(id).is_ok());
        people.copied().try_for_each(|agent| dress(&mut snapshot, home, agent))?;
        Ok(snapshot)
    }
}

/// Shows an agent in its posture and its clothes.
fn dress(snapshot: &mut Snapshot, home: &Environment, agent: NodeId) -> Result<(), RenderError> {
    if let Some(skeleton) = home.skeleton(agent) {
        snapshot.arrange(agent, |joint| Some(skeleton.motion(Bone::from_joint(joint)?)))?;
    }
    for worn in home.graph().relating(Relation::WornBy, agent).filter_map(|id| home.graph().node(id)) {
        let colour = clothes::colour(home.graph().assets(), worn).unwrap_or([0.5; 3]);
        let coat = Coat { colour, share: 1.0, roughness: 1.0 };
        let covered = clothes::covered(home.graph().classes(), worn.class());
        let on = |joint: &Joint| Bone::from_joint(joint).filter(|bone| covered.contains(bone)).map(|_| coat);
        snapshot.coat_links(agent, on)?;
        snapshot.hide(worn.id(), true)?;
    }
    Ok(())
}
