//! From a description to a map: arms and cuts, lanes, movements, conflicts, crossings, the walkable network, signals.

mod arms;
mod bays;
mod check;
mod conflicts;
mod lanes;
mod movements;
mod rounded;
mod signals;
mod walk;
mod yields;

use std::sync::Arc;

use crate::index::PointIndex;
use crate::map::Inner;
use crate::{MapDraft, MapError, StreetMap, WalkEdgeId};

/// The most roads that can meet at a junction.
pub(crate) const MOST_ARMS: usize = 32;

impl MapDraft {
    /// The map of this description, whose numbers are kept to a tenth of a millimetre. Costs a few microseconds for each road.
    ///
    /// # Errors
    /// [`MapError`]: numbers that are not finite, roads without strips, ids that there are not.
    pub fn build(mut self) -> Result<StreetMap, MapError> {
        check::check(&self)?;
        rounded::rounded(&mut self);
        let lines = lanes::centre_lines(&self)?;
        let mut junctions = arms::junctions(&self, &lines)?;
        let cuts = arms::cuts(&self, &lines, &junctions);
        let (roads, mut lanes) = lanes::lanes(&self, lines, &cuts)?;
        let mut movements = movements::movements(&self, &mut junctions, &roads, &mut lanes);
        let walk = walk::network(&self, &mut junctions, &roads, &mut lanes);
        conflicts::tables(&mut junctions, &movements, &walk.crossings, &lanes);
        yields::yields(&self, &junctions, &roads, &lanes, &mut movements);
        let signals = signals::signals(&self, &mut junctions, &movements, &walk.crossings, &lanes);
        arms::outlines(&mut junctions, &roads);
        let bays = bays::bays(&lanes);
        let lane_index = PointIndex::new(lanes.iter().enumerate().map(|(id, lane)| (id as u32, &lane.line)));
        let walk_index = PointIndex::new(walk.edges.iter().enumerate().map(|(id, edge)| (id as u32, &edge.line)));
        let mut walk_at = vec![Vec::new(); walk.nodes.len()];
        for (id, edge) in walk.edges.iter().enumerate() {
            edge.ends.iter().for_each(|node| walk_at[node.index()].push(WalkEdgeId::of(id)));
        }
        let inner = Inner {
            draft: self,
            junctions,
            roads,
            lanes,
            movements,
            signals,
            crossings: walk.crossings,
            walk_nodes: walk.nodes,
            walk_edges: walk.edges,
            walk_at,
            entrances: Vec::new(),
            bays,
            stops: Vec::new(),
            lane_index,
            walk_index,
        };
        let mut map = StreetMap { inner: Arc::new(inner) };
        let (entrances, stops) = (bays::entrances(&map), bays::stops(&map));
        if let Some(inner) = Arc::get_mut(&mut map.inner) {
            (inner.entrances, inner.stops) = (entrances, stops);
        }
        Ok(map)
    }
}
