//! Going through a portal, with everything that one carries.

use std::sync::Arc;

use super::{Load, PassError, PortalId, RegionGraphs, RegionId};
use crate::{ChangeMismatch, ChangeSet, NodeId, Pose};

/// A passage through a portal: [`RegionGraphs::take_back`] undoes it.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Crossing {
    /// The portal.
    pub portal: PortalId,
    /// The region that was left.
    pub from: RegionId,
    /// The region that was entered.
    pub to: RegionId,
    /// The nodes that went, the one that was asked for first.
    pub nodes: Vec<NodeId>,
    /// The changes of the scene that was left.
    pub left: ChangeSet,
    /// The changes of the scene that was entered.
    pub entered: ChangeSet,
}

impl RegionGraphs {
    /// Takes a node that stands free, with everything that it carries, through an open portal into the region beyond.
    ///
    /// It stays where it is in the world, and the relations among those who go stay. Those to what is left behind end: where
    /// a held thing was taken from is forgotten. In the new scene all are in the room of the portal's side. Costs what is
    /// carried.
    ///
    /// # Errors
    /// [`PassError`]; nothing has changed then.
    pub fn pass(&mut self, node: NodeId, portal: PortalId) -> Result<Crossing, PassError> {
        let (from, to, into) = self.way(node, portal)?;
        let (left, entered) = match (self.graph(from), self.graph(to)) {
            (Some(left), Some(entered)) => (left, entered),
            (None, _) => return Err(PassError::NoSuchNode(node)),
            (_, None) => return Err(PassError::NotActive(to)),
        };
        let is_room = |id: &NodeId| entered.rooms().contains(id);
        let room = into.or_else(|| entered.rooms().first().copied()).filter(is_room).ok_or(PassError::NoRoom(to))?;
        let frames = self.frame(from).zip(self.frame(to));
        let shift = frames.map_or_else(Pose::identity, |(from, to)| from.to(&to));
        let load = Load::new(left, node, from)?;
        let (library, arrival) = load.entering((entered, to), &shift, room)?;
        let crossing =
            Crossing { portal, from, to, left: load.leaving(), entered: arrival, nodes: load.ids().collect() };
        self.change(&crossing.left, &crossing.entered, from, to).map_err(|mismatch| PassError::Taken(mismatch.node))?;
        if let Some(active) = self.active.get_mut(&to) {
            active.graph.assets = library;
        }
        self.settle(&crossing.nodes, to);
        Ok(crossing)
    }

    /// Undoes a passage.
    ///
    /// # Errors
    /// [`PassError::NotActive`] if one of the two regions is dormant, [`PassError::Changed`] if its scene has changed
    /// since; nothing has changed then.
    pub fn take_back(&mut self, crossing: &Crossing) -> Result<(), PassError> {
        if let Some(region) = [crossing.from, crossing.to].into_iter().find(|region| self.graph(*region).is_none()) {
            return Err(PassError::NotActive(region));
        }
        let undone = self.change(&crossing.left.inverse(), &crossing.entered.inverse(), crossing.from, crossing.to);
        undone.map_err(|mismatch| PassError::Changed(Box::new(mismatch)))?;
        self.settle(&crossing.nodes, crossing.from);
        Ok(())
    }

    fn way(&self, node: NodeId, portal: PortalId) -> Result<(RegionId, RegionId, Option<NodeId>), PassError> {
        let plan = self.space().portal(portal).ok_or(PassError::NoSuchPortal(portal))?;
        let region = self.region_of(node).filter(|_| self.node(node).is_some()).ok_or(PassError::NoSuchNode(node))?;
        let elsewhere = || PassError::Elsewhere { node: self.label(node), region, portal };
        let across = plan.across(region).ok_or_else(elsewhere)?;
        let passable = self.portal(portal).is_some_and(|state| state.passable);
        if passable { Ok((region, across.region, across.room)) } else { Err(PassError::Shut(portal)) }
    }

    /// Writes the changes of two scenes, or none.
    fn change(
        &mut self,
        here: &ChangeSet,
        there: &ChangeSet,
        from: RegionId,
        to: RegionId,
    ) -> Result<(), ChangeMismatch> {
        let before = self.graph(from).cloned();
        if let Some(active) = self.active.get_mut(&from) {
            here.apply(&mut active.graph)?;
        }
        let Some(active) = self.active.get_mut(&to) else { return Ok(()) };
        let result = there.apply(&mut active.graph);
        if let (Err(_), Some(active), Some(before)) = (&result, self.active.get_mut(&from), before) {
            active.graph = before;
        }
        result
    }

    /// Notes where nodes are.
    fn settle(&mut self, nodes: &[NodeId], region: RegionId) {
        for id in nodes {
            let at_home = self.made_in(*id) == Some(region);
            let moved = Arc::make_mut(&mut self.moved);
            if at_home {
                moved.remove(id)
            } else {
                moved.insert(*id, region)
            };
        }
    }
}
