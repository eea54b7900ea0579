//! The things to carry: held things, and piles of things.

use vc_graph::goal::largest_matching;
use vc_graph::{Edge, Node, NodeId, NodeKind, Property, Relation};

use super::site::Standing;
use super::{Compiler, SPARE};
use crate::packed::{MOST, Need, Pile, Spot, Way, ones, run_of};
use crate::small_list::SmallList;

impl Compiler<'_> {
    /// Adds the held things.
    pub(super) fn hands(&mut self) {
        let held: Vec<NodeId> = self.graph().held(self.now.agent).take(2).collect();
        for (hand, &id) in held.iter().enumerate() {
            let serves = self.items.iter().find(|(item, _)| *item == id).map_or(0, |(_, serves)| *serves);
            self.out.problem.held[hand] = Some(id);
            let kind = self.kind(serves);
            self.out.start.hands[hand] = kind + 1;
        }
        self.items.retain(|(id, _)| !held.contains(id));
        if held.len() == 2 {
            self.table_at_hand();
        }
        let [a, b] = self.out.start.hands;
        if a < b {
            self.out.start.hands.swap(0, 1);
            self.out.problem.held.swap(0, 1);
        }
    }

    /// Records a surface at hand on which a full hand can be emptied.
    fn table_at_hand(&mut self) {
        let graph = self.now.graph;
        let steady = |n: &Node| n.affords(Property::Surface) && !n.affords(Property::Graspable);
        let mut near = graph.related(self.now.agent, Relation::Near);
        if let Some(table) = near.find(|&id| graph.node(id).is_some_and(steady) && graph.hidden_in(id).is_none()) {
            self.spot(table);
        }
    }

    pub(super) fn kind(&mut self, serves: u32) -> u8 {
        let kinds = &mut self.out.problem.kinds;
        let known = kinds.iter().position(|&k| k == serves);
        known.unwrap_or_else(|| {
            kinds.push(serves);
            kinds.len() - 1
        }) as u8
    }

    /// Gathers items into piles, the most useful first if there are more than enough.
    pub(super) fn piles(&mut self) {
        let items = std::mem::take(&mut self.items);
        let mut piles: Vec<Lot> = Vec::with_capacity(items.len().min(MOST));
        for (id, serves) in items {
            // Things that another agent holds or wears are left to it.
            if self.is_held_by_another(id) {
                continue;
            }
            let at = self.standing(id);
            match piles.iter_mut().find(|p| p.at == at && p.serves == serves) {
                Some(pile) => pile.items.push(id),
                None => piles.push(Lot { at, serves, items: SmallList::One(id) }),
            }
        }
        if piles.len() > SPARE {
            self.rank(&mut piles);
        }
        if piles.len() > MOST {
            piles = self.needed_first(piles);
        }
        let mut kept = [0usize; MOST];
        let mut crowded = false;
        for lot in piles {
            let wanted = |n: usize| self.out.problem.needs[n].units.count_ones() as usize;
            if ones(u64::from(lot.serves)).all(|n| kept[n] >= wanted(n) + SPARE) {
                continue;
            }
            ones(u64::from(lot.serves)).for_each(|n| kept[n] += 1);
            crowded |= self.pile(lot).is_none();
        }
        if crowded {
            self.leave_unserved();
        }
    }

    /// Where an item stands. An item beside a thing that is visited anyway is at hand there, and needs no walk
    /// of its own.
    fn standing(&self, id: NodeId) -> Standing {
        let (graph, standing) = (self.now.graph, Standing::new(self.now.graph, id));
        if standing.anchor != id || graph.near(self.now.agent, id) {
            return standing;
        }
        let fixed = |at: NodeId| {
            graph.node(at).is_some_and(|n| n.kind() == NodeKind::Object && !n.affords(Property::Graspable))
        };
        let beside = |spot: &&Spot| {
            graph.has(Edge::new(id, Relation::Near, spot.anchor))
                && fixed(spot.anchor)
                && graph.room_of(id) == spot.room
        };
        let spot = self.out.problem.spots.iter().find(beside);
        spot.map_or(standing, |spot| Standing { anchor: spot.anchor, ..standing })
    }

    /// The piles that are needed, before those that could serve as alternatives.
    fn needed_first(&self, piles: Vec<Lot>) -> Vec<Lot> {
        let mut short = [0usize; MOST];
        let needs = self.out.problem.needs.iter().map(|need| need.units.count_ones() as usize);
        short.iter_mut().zip(needs).for_each(|(short, wanted)| *short = wanted);
        let (mut needed, spare): (Vec<Lot>, Vec<Lot>) = piles.into_iter().partition(|lot| {
            let serves = || ones(u64::from(lot.serves));
            let is_needed = serves().any(|n| short[n] > 0);
            serves().for_each(|n| short[n] = short[n].saturating_sub(lot.items.len()));
            is_needed
        });
        needed.extend(spare);
        needed
    }

    /// Defers the units for which too few items were packed.
    fn leave_unserved(&mut self) {
        let items = self.out.items();
        let carried = |need: &Need| !matches!(need.ways.first(), Some(Way::Use { .. }) | None);
        let mut rows: Vec<Vec<usize>> = Vec::new();
        for (n, need) in self.out.problem.needs.iter().enumerate() {
            for unit in ones(need.units).filter(|_| carried(need)) {
                rows.push((0..items.len()).filter(|&i| items[i] >> n & 1 != 0).collect());
                if largest_matching(&rows, items.len()) < rows.len() {
                    rows.pop();
                    self.out.start.needs &= !(1 << unit);
                    (self.out.more, self.out.rest) = (true, true);
                }
            }
        }
    }

    /// Sorts piles by preference: spots that are visited anyway, several things, no door to open, the present
    /// room.
    fn rank(&self, piles: &mut [Lot]) {
        let graph = self.now.graph;
        let here = graph.room_of(self.now.agent);
        let mut spots: Vec<NodeId> = piles.iter().map(|p| p.at.anchor).collect();
        spots.sort_unstable();
        let several = |at: NodeId| {
            let first = spots.partition_point(|s| *s < at);
            spots.get(first + 1) == Some(&at)
        };
        piles.sort_by_cached_key(|lot| {
            let at = lot.at.anchor;
            let busy = self.spot_number(at).is_some() || several(at);
            let shut = lot.at.inside.is_some();
            (!busy, std::cmp::Reverse(lot.items.len().min(2)), shut, graph.room_of(at) != here, at)
        });
    }

    /// Makes a pile of the items of a lot; `None` if there is no room for all of it.
    fn pile(&mut self, lot: Lot) -> Option<()> {
        if self.out.problem.piles.len() == MOST {
            return None;
        }
        let spot = self.spot(lot.at.anchor)?;
        let Some(door) = self.door_of(&lot.at, spot) else {
            self.out.rest = true;
            return None;
        };
        let (kind, mut items) = (self.kind(lot.serves), lot.items);
        // More items than can serve any need are useless.
        let number = |n: usize| self.out.problem.needs[n].units.count_ones() as usize;
        let useful = items.len().min(ones(u64::from(lot.serves)).map(number).sum());
        let units = run_of(self.out.start.piles, useful);
        let room = units.count_ones() as usize;
        items.truncate(room);
        self.out.start.piles |= units;
        self.out.problem.piles.push(Pile { kind, spot, door, items, units });
        (room == useful).then_some(())
    }
}

/// Things that serve the same needs and stand at the same place.
struct Lot {
    at: Standing,
    serves: u32,
    items: SmallList,
}
