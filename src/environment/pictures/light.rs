//! The light of an environment, made again when what it depends on changes.

use std::sync::MutexGuard;

use vc_graph::asset::{Joint, Part};
use vc_graph::{Label, Node, NodeId, Pose, SceneGraph, State};
use vc_render::{Daylight, Lighting, RenderError, Snapshot};

use super::{Base, Stage};
use crate::Environment;

/// How far open what lets light in counts as open, 0 to 1.
const AJAR: f32 = 0.25;
/// How many lights are kept.
pub(super) const LIGHTS: usize = 8;

/// How far a lamp has to be moved to count as moved, metres.
const ASIDE: f32 = 0.05;

/// Everything on which indirect light depends.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Lit {
    daylight: Daylight,
    /// Things that are on.
    on: Vec<NodeId>,
    /// Lamps that are on and stand elsewhere than at first: pose and room.
    moved: Vec<(NodeId, Pose, Option<NodeId>)>,
    /// Doors and windows that stand open.
    open: Vec<NodeId>,
    /// Blinds and curtains that are drawn.
    drawn: Vec<NodeId>,
}

impl Environment {
    /// The light as it is: `Renderer::light` of the home as it begins, then `Renderer::follow`. As `follow` makes the
    /// same shadows as `light`, the result does not depend on earlier pictures.
    pub(super) fn lighting(&self, daylight: &Daylight, now: &Snapshot) -> Result<Lighting, RenderError<Label>> {
        let base = self.base()?;
        let lit = self.lit(&base.stage, daylight);
        let known = self.lights().iter().find(|(known, _)| *known == lit).map(|(_, lighting)| lighting.clone());
        let mut lighting = known.map_or_else(|| base.made(&lit), Ok)?;
        base.renderer.follow(&mut lighting, now)?;
        // The lock is not held meanwhile: a thread that waits for others may be given a picture to make.
        let mut made = self.lights();
        made.retain(|(known, _)| *known != lit);
        made.insert(0, (lit, lighting.clone()));
        made.truncate(LIGHTS);
        Ok(lighting)
    }

    /// Light that was made. A thread that panicked left nothing half done there.
    fn lights(&self) -> MutexGuard<'_, Vec<(Lit, Lighting)>> {
        self.picture_cache().light.lock().unwrap_or_else(std::sync::PoisonError::into_inner)
    }

    pub(super) fn lit(&self, stage: &Stage, daylight: &Daylight) -> Lit {
        let stands_open = |id: &NodeId| self.world().parts(*id).openness().is_some_and(|open| open >= AJAR);
        let open = stage.openings.iter().copied().filter(stands_open).collect();
        let closed = |id: &NodeId| self.graph().node(*id).is_some_and(|n| n.is(State::Closed));
        let drawn = stage.covers.iter().copied().filter(closed).collect();
        let on = stage.lit_now(self.graph());
        let elsewhere = |id: &NodeId| {
            let was = stage.poses.binary_search_by_key(id, |(id, _)| *id).ok().map(|at| stage.poses[at].1)?;
            let now = *self.graph().node(*id)?.pose()?;
            let off = (now.translation.vector - was.translation.vector).norm();
            (off > ASIDE).then(|| (*id, now, self.room_of_place(*id, &now)))
        };
        let moved = on.iter().filter(|id| stage.lamps.contains(id)).filter_map(elsewhere).collect();
        Lit { daylight: *daylight, on, moved, open, drawn }
    }
}

impl Base {
    fn made(&self, lit: &Lit) -> Result<Lighting, RenderError> {
        let mut lighting = self.renderer.light(&self.stage.as_lit(lit)?, &lit.daylight);
        // Whatever may move counts as moved from now on, so that it does not matter what moved when.
        lighting.follow(&self.stage.stirred(lit)?)?;
        Ok(lighting)
    }
}

impl Stage {
    /// The home as it begins, with this light: what moves is where it stood, and either shut or open.
    pub(super) fn as_lit(&self, lit: &Lit) -> Result<Snapshot, RenderError> {
        let mut snapshot = self.snapshot.clone();
        for &id in &self.jointed {
            let end = usize::from(lit.open.contains(&id));
            snapshot.articulate(id, |joint| Some(ends(joint)[end]))?;
        }
        self.covers.iter().try_for_each(|id| snapshot.draw_cover(*id, lit.drawn.contains(id)))?;
        for (id, pose, room) in &lit.moved {
            snapshot.place(*id, pose)?;
            snapshot.enter(*id, *room)?;
        }
        switch(&mut snapshot, &self.lit, &lit.on)?;
        self.visitors.iter().try_for_each(|id| snapshot.hide(*id, true))?;
        Ok(snapshot)
    }

    /// The same with everything that may move a little elsewhere.
    pub(super) fn stirred(&self, lit: &Lit) -> Result<Snapshot, RenderError> {
        let mut snapshot = self.as_lit(lit)?;
        for &id in &self.jointed {
            let other = usize::from(!lit.open.contains(&id));
            snapshot.articulate(id, |joint| Some(ends(joint)[other]))?;
        }
        for (id, pose) in &self.poses {
            if self.loose.contains(id) {
                snapshot.place(*id, &(Pose::translation(0.0, 0.0, 1e-3) * pose))?;
            }
        }
        self.covers.iter().try_for_each(|id| snapshot.draw_cover(*id, !lit.drawn.contains(id)))?;
        self.vessels.iter().try_for_each(|(id, full)| snapshot.fill(*id, (!full).then_some("water")))?;
        Ok(snapshot)
    }
}

/// The things that are lit and glow: nobody sees from outside that a dishwasher runs.
pub(super) fn lit(graph: &SceneGraph) -> Vec<NodeId> {
    let lit = graph.nodes().filter(|n| n.pose().is_some() && graph.is_lit(n.id()));
    lit.filter(|n| glows(graph, n)).map(Node::id).collect()
}

fn glows(graph: &SceneGraph, node: &Node) -> bool {
    let library = graph.assets();
    let glowing = |part: &Part| library.material(part.material).is_some_and(|m| m.emission != [0.0; 3]);
    node.spec().asset.and_then(|id| library.get(id)).is_some_and(|asset| asset.parts.iter().any(glowing))
}

/// Switches in a snapshot what is on now and was not before, and the other way round.
pub(super) fn switch(snapshot: &mut Snapshot, before: &[NodeId], now: &[NodeId]) -> Result<(), RenderError> {
    let off = before.iter().filter(|id| !now.contains(id)).map(|id| (*id, false));
    let on = now.iter().filter(|id| !before.contains(id)).map(|id| (*id, true));
    off.chain(on).try_for_each(|(id, on)| snapshot.switch(id, on).map(drop))
}

/// Where a joint is shut and where it is open: shut is the end nearer to where the asset has it.
fn ends(joint: &Joint) -> [f32; 2] {
    let (low, high) = joint.limits;
    if low.abs() <= high.abs() { [low, high] } else { [high, low] }
}
