//! From a description to a map: arms and cuts, lanes, movements, conflicts, crossings, the walkable network, signals.

mod arms;
mod bays;
mod budget;
mod check;
mod conflicts;
mod crossing_rule;
mod lanes;
mod movements;
mod roundabout;
mod rounded;
mod signals;
mod stop_lines;
mod targets;
mod walk;
mod yields;

use std::sync::Arc;

use budget::Budget;

use crate::index::PointIndex;
use crate::map::Inner;
use crate::size::Holds;
use crate::{MapDraft, MapError, StreetMap, WalkEdgeId};

/// The most roads that can meet at a junction.
pub(crate) const MOST_ARMS: usize = 32;
/// A map may take this many bytes, and this many for each byte of its description, or of a file: with the work of building it
/// twenty. Maps of cities take four to ten, or less than one of XML and ten to sixteen of PBF.
const LEAST_BYTES: usize = 16 << 20;
const OF_DESCRIPTION: usize = 16;
const OF_FILE: usize = 18;

impl MapDraft {
    /// The map of this description, whose numbers are kept to a tenth of a millimetre. Costs a few microseconds for each
    /// road, and at most 16 MiB and 16 times the memory of the description.
    ///
    /// # Errors
    /// [`MapError`]: numbers that are not finite or out of their range, roads without strips, ids that there are not, parts
    /// that would make the map too large.
    pub fn build(self) -> Result<StreetMap, MapError> {
        let most = LEAST_BYTES.saturating_add(OF_DESCRIPTION.saturating_mul(self.bytes()));
        self.build_within(most)
    }

    /// As [`Self::build`], for a description that was read from a file of some bytes: the map takes at most 16 MiB and
    /// twenty times those.
    ///
    /// # Errors
    /// As [`Self::build`].
    pub fn build_of_file(self, bytes: usize) -> Result<StreetMap, MapError> {
        self.build_within(LEAST_BYTES.saturating_add(OF_FILE.saturating_mul(bytes)))
    }

    /// As [`Self::build`], with a limit of one's own to the bytes that the map may take; [`StreetMap::bytes`] tells how many
    /// a map takes.
    ///
    /// ```
    /// use vc_map::{MapDraft, MapError};
    /// let draft = MapDraft::new("empty", 48.1, 11.6);
    /// assert!(draft.clone().build_within(1 << 10).is_ok());
    /// assert!(matches!(draft.build_within(10), Err(MapError::TooLarge { .. })));
    /// ```
    ///
    /// # Errors
    /// As [`Self::build`].
    pub fn build_within(mut self, bytes: usize) -> Result<StreetMap, MapError> {
        check::check(&self)?;
        rounded::rounded(&mut self);
        let mut budget = Budget::new(bytes);
        budget.take("the description", std::slice::from_ref(&self))?;
        let points: usize = self.roads.iter().map(|road| road.line.len()).sum();
        // The line of each road, and one beside it.
        budget.has("the lines of roads", 2 * points * size_of::<[f64; 3]>())?;
        let mut map = StreetMap { inner: Arc::new(inner(self, &mut budget)?) };
        let (entrances, stops) = (bays::entrances(&map), bays::stops(&map));
        budget.take("the doors", &entrances)?;
        budget.take("the stops", &stops)?;
        if let Some(inner) = Arc::get_mut(&mut map.inner) {
            (inner.entrances, inner.stops) = (entrances, stops);
        }
        Ok(map)
    }
}

/// Everything but doors and stops, which are looked up in the map.
fn inner(draft: MapDraft, budget: &mut Budget) -> Result<Inner, MapError> {
    let lines = lanes::centre_lines(&draft)?;
    let mut junctions = arms::junctions(&draft, &lines)?;
    let cuts = arms::cuts(&draft, &lines, &junctions);
    let (roads, mut lanes) = lanes::lanes(&draft, lines, &cuts, budget)?;
    arms::outlines(&mut junctions, &roads);
    budget.take("the junctions", &junctions)?;
    let mut movements = movements::movements(&draft, &mut junctions, &roads, &mut lanes, budget)?;
    let mut walk = walk::network(&draft, &mut junctions, (&roads, &lanes, &movements), budget)?;
    stop_lines::signs(&draft, &roads, &mut lanes);
    stop_lines::stop_lines(&junctions, &walk.crossings, &roads, &mut lanes);
    conflicts::tables(&mut junctions, &movements, &walk.crossings, &lanes, budget)?;
    yields::yields(&draft, &junctions, &roads, &lanes, &mut movements, budget)?;
    let mut signals = signals::signals(&draft, &mut junctions, &movements, &walk.crossings, &lanes, budget)?;
    let lane_index = PointIndex::new(lanes.iter().enumerate().map(|(id, lane)| (id as u32, &lane.line)));
    let walk_index = PointIndex::new(walk.edges.iter().enumerate().map(|(id, edge)| (id as u32, &edge.line)));
    budget.take_bytes("the index", lane_index.bytes() + walk_index.bytes())?;
    let mut walk_at = vec![Vec::new(); walk.nodes.len()];
    for (id, edge) in walk.edges.iter().enumerate() {
        edge.ends.iter().for_each(|node| walk_at[node.index()].push(WalkEdgeId::of(id)));
    }
    lanes.shrink_to_fit();
    movements.shrink_to_fit();
    signals.shrink_to_fit();
    walk.shrink();
    Ok(Inner {
        draft,
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
        stops: Vec::new(),
        lane_index,
        walk_index,
    })
}
