//! The light of an environment, made again when what it depends on changes.

use vc_graph::asset::{Joint, Part};
use vc_graph::{Node, NodeId, Pose, SceneGraph, State};
use vc_render::{Daylight, Lighting, RenderError, Snapshot};

use super::Base;
use crate::Environment;

/// How far open what lets light in counts as open, 0 to 1.
const AJAR: f32 = 0.5;
/// How many lights are kept.
const LIGHTS: usize = 8;

/// What the light depends on.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Lit {
    /// What is on.
    on: Vec<NodeId>,
    /// What of the building stands open: doors and windows.
    open: Vec<NodeId>,
    /// Blinds and curtains that are drawn.
    drawn: Vec<NodeId>,
}

impl Environment {
    /// The light as it is: `Renderer::light`, in which mirrors show what there is now. It depends on
    /// nothing that was rendered before.
    pub(super) fn lighting(&self, now: &Snapshot) -> Result<Lighting, RenderError> {
        let mut lighting = self.first_light()?;
        lighting.follow(now)?;
        Ok(lighting)
    }

    /// The light of the home as it began, with what is on and open now.
    fn first_light(&self) -> Result<Lighting, RenderError> {
        let base = self.base()?;
        let stands_open = |id: &NodeId| self.world().openness(*id).is_some_and(|open| open >= AJAR);
        let open = base.openings.iter().copied().filter(stands_open).collect();
        let closed = |id: &NodeId| self.graph().node(*id).is_some_and(|n| n.is(State::Closed));
        let drawn = base.covers.iter().copied().filter(closed).collect();
        let lit = Lit { on: lit(self.graph()), open, drawn };
        // A thread that panicked left nothing half done here.
        let mut made = self.sight().light.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        if let Some(known) = made.iter().position(|(known, _)| *known == lit) {
            made[..=known].rotate_right(1);
            return Ok(made[0].1.clone());
        }
        let mut lighting = base.renderer.light(&base.as_lit(&lit)?, &Daylight::noon());
        // Whatever may move counts as moved from now on, so that it does not matter what moved when.
        lighting.follow(&base.stirred(&lit)?)?;
        made.insert(0, (lit, lighting.clone()));
        made.truncate(LIGHTS);
        Ok(lighting)
    }
}

impl Base {
    /// The home as it begins, with this light: what moves is where it stood, and either shut or open.
    fn as_lit(&self, lit: &Lit) -> Result<Snapshot, RenderError> {
        let mut snapshot = self.snapshot.clone();
        for &id in &self.jointed {
            let end = usize::from(lit.open.contains(&id));
            snapshot.articulate(id, |joint| Some(ends(joint)[end]))?;
        }
        self.covers.iter().try_for_each(|id| snapshot.draw(*id, lit.drawn.contains(id)))?;
        switch(&mut snapshot, &self.lit, &lit.on)?;
        Ok(snapshot)
    }

    /// The same with everything that may move a little elsewhere.
    fn stirred(&self, lit: &Lit) -> Result<Snapshot, RenderError> {
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
        self.covers.iter().try_for_each(|id| snapshot.draw(*id, !lit.drawn.contains(id)))?;
        self.vessels.iter().try_for_each(|(id, full)| snapshot.fill(*id, (!full).then_some("water")))?;
        Ok(snapshot)
    }
}

/// What is on and glows: of a dishwasher nobody sees that it runs.
pub(super) fn lit(graph: &SceneGraph) -> Vec<NodeId> {
    let on = graph.nodes().filter(|n| n.is(State::On) && n.pose().is_some());
    on.filter(|n| glows(graph, n)).map(Node::id).collect()
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
