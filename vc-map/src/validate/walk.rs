//! The walkable network: one part, and crossings at lights.

use petgraph::unionfind::UnionFind;

use super::MapViolation;
use crate::{Control, CrossingId, CrossingKind, JunctionId, RoadClass, StreetMap, StripKind, Users, WalkNodeId};

pub(super) fn violations(map: &StreetMap) -> Vec<MapViolation> {
    let mut found = cut_off(map);
    for (index, junction) in map.junctions().iter().enumerate() {
        if junction.draft.control == Control::Signals {
            found.extend(no_crossing(map, JunctionId::of(index)));
        }
        let differs = |id: &&CrossingId| {
            map.crossing(**id).is_some_and(|c| (c.kind == CrossingKind::Signals) != junction.signal.is_some())
        };
        found.extend(
            junction.crossings.iter().filter(differs).map(|crossing| MapViolation::Unlit { crossing: *crossing }),
        );
    }
    found
}

fn cut_off(map: &StreetMap) -> Vec<MapViolation> {
    map.walk_parts()
        .into_iter()
        .skip(1)
        .map(|(nodes, metres)| {
            let node = nodes.first().copied().unwrap_or(WalkNodeId(0));
            MapViolation::WalkCutOff { node, nodes: nodes.len(), metres }
        })
        .collect()
}

fn no_crossing(map: &StreetMap, id: JunctionId) -> Vec<MapViolation> {
    let Some(junction) = map.junction(id) else { return Vec::new() };
    let paved = |road: &crate::Road| {
        let sides = [true, false].map(|side| {
            road.draft.section.side(side).iter().any(|s| s.kind == StripKind::Pavement && s.users.has(Users::FOOT))
        });
        sides == [true; 2] && road.draft.class != RoadClass::Motorway
    };
    let crossed = |road| {
        let over = |id: &CrossingId| map.crossing(*id).is_some_and(|crossing| crossing.roads.contains(&road));
        junction.crossings.iter().any(over)
    };
    let streets =
        junction.arms.iter().filter(|arm| map.road(arm.road).is_some_and(|road| road.draft.class.is_street()));
    let alone = streets.count() <= 2;
    let lost = junction.arms.iter().filter(|arm| !alone && map.road(arm.road).is_some_and(paved) && !crossed(arm.road));
    let lost = lost.map(|arm| MapViolation::NoCrossing { junction: id, road: arm.road });
    lost.collect()
}

impl StreetMap {
    /// The parts of the walkable network that are not joined with each other, the longest first: nodes and metres. Costs one
    /// pass over the network.
    ///
    /// ```
    /// # use vc_map::{Control, CrossSection, MapDraft, RoadClass, Strip};
    /// # let mut draft = MapDraft::new("street", 48.1, 11.6);
    /// # let ends = [[0.0, 0.0], [100.0, 0.0]].map(|at| draft.junction(at, Control::Edge));
    /// # let side = vec![Strip::driving(3.0, 15.0), Strip::pavement(2.0)];
    /// # let section = CrossSection { forward: side.clone(), backward: side, median: 0.0 };
    /// # draft.road(ends[0], ends[1], RoadClass::Primary, section);
    /// # let map = draft.build()?; // a fast street of 100 m that leaves the map at both ends: nobody crosses it
    /// assert_eq!(map.walk_parts().iter().map(|(_, metres)| *metres).collect::<Vec<_>>(), [100.0, 100.0]);
    /// # Ok::<(), vc_map::MapError>(())
    /// ```
    pub fn walk_parts(&self) -> Vec<(Vec<WalkNodeId>, f64)> {
        let mut sets = UnionFind::<usize>::new(self.walk_nodes().len());
        for edge in self.walk_edges() {
            sets.union(edge.ends[0].index(), edge.ends[1].index());
        }
        let mut parts: std::collections::BTreeMap<usize, (Vec<WalkNodeId>, f64)> = std::collections::BTreeMap::new();
        for node in 0..self.walk_nodes().len() {
            parts.entry(sets.find_mut(node)).or_default().0.push(WalkNodeId::of(node));
        }
        for edge in self.walk_edges() {
            parts.entry(sets.find_mut(edge.ends[0].index())).or_default().1 += edge.line.length();
        }
        let mut parts: Vec<_> = parts.into_values().collect();
        parts.sort_by(|a, b| b.1.total_cmp(&a.1).then(a.0.cmp(&b.0)));
        parts
    }
}
