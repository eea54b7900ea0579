//! The next step while something is lacking: searching and delivering.
//!
//! This module turns the belief and the packed problem into a [`ObjectSearch`], and the search's best move back into a
//! step in the scene.

use vc_graph::{Action, NodeId, Place, Relation, SceneGraph, Verb};

use crate::Belief;
use crate::compile::{Compiled, anchor};
use crate::manners::Manners;
use crate::object_search::{
    Item, Lacking, MOST_LACKS, MOST_OBJECTS, MOST_ROOMS, MOST_SITES, Move, ObjectSearch, Site, SoughtObject, Target,
};
use crate::packed::Way;

/// The next step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum SearchStep {
    /// Walk up to a thing or into a room, to observe it.
    Visit(NodeId),
    /// Open a container and look into it.
    Open(NodeId),
    /// Handle a found thing.
    Do(Action),
}

/// The best step for the lacking and the found things; `None` if there is nothing left to look at.
pub(crate) fn best_search_step(
    belief: &Belief,
    me: NodeId,
    compiled: &Compiled,
    manners: Manners,
) -> Option<SearchStep> {
    let mut map = Map::new(belief, me, compiled, manners);
    map.see_to_found();
    map.seek();
    map.best()
}

/// Number of candidate instances of a lacking thing that a search considers, unless more are needed.
const INSTANCES: usize = 6;

/// A search, with the scene's meaning of its numbers.
struct Map<'a> {
    belief: &'a Belief,
    graph: &'a SceneGraph,
    me: NodeId,
    compiled: &'a Compiled,
    search: ObjectSearch,
    rooms: Vec<NodeId>,
    spots: Vec<NodeId>,
    /// The container that is opened to see a site, in the order of sites.
    shut: Vec<Option<NodeId>>,
    /// The site of each place of the belief.
    site_of: Vec<Option<u16>>,
    /// The things of the search's items, and the actions that put down the things in its hands.
    items: Vec<NodeId>,
    puts: Vec<Action>,
}

/// A site before it has a number.
struct Unseen {
    room: u8,
    shut: Option<NodeId>,
    spot: Option<NodeId>,
    value: f64,
    places: Vec<usize>,
}

impl<'a> Map<'a> {
    fn new(belief: &'a Belief, me: NodeId, compiled: &'a Compiled, manners: Manners) -> Self {
        let graph = belief.graph();
        let opening = if manners == Manners::Tidy { 2 } else { 1 };
        let mut map = Self {
            belief,
            graph,
            me,
            compiled,
            search: ObjectSearch { opening, ..ObjectSearch::default() },
            rooms: Vec::new(),
            spots: Vec::new(),
            shut: Vec::new(),
            site_of: vec![None; belief.places_known()],
            items: Vec::new(),
            puts: Vec::new(),
        };
        map.search.room = graph.room_of(me).and_then(|room| map.room(room)).unwrap_or(0);
        map.sites();
        map
    }

    fn room(&mut self, id: NodeId) -> Option<u8> {
        let known = self.rooms.iter().position(|&r| r == id);
        let number = known.unwrap_or(self.rooms.len());
        if known.is_none() {
            self.rooms.push(id);
        }
        (number < MOST_ROOMS).then_some(number as u8)
    }

    fn spot(&mut self, id: NodeId) -> u16 {
        let known = self.spots.iter().position(|&s| s == id);
        known.unwrap_or_else(|| {
            self.spots.push(id);
            if self.graph.near(self.me, id) {
                self.search.near.push(self.spots.len() as u16 - 1);
            }
            self.spots.len() - 1
        }) as u16
    }

    /// Numbers the places that have not been seen.
    fn sites(&mut self) {
        let values = self.values();
        let here = self.graph.room_of(self.me);
        let mut unseen: Vec<Unseen> = Vec::new();
        for (index, place, room) in self.belief.sites() {
            let Some(room_id) = room.or_else(|| self.graph.room_of(place.at)) else { continue };
            let Some(room) = self.room(room_id) else { continue };
            let shut = box_at(self.graph, &place, Some(room_id) == here);
            if let Some(known) = unseen.iter_mut().find(|u| shut.is_some() && u.shut == shut) {
                known.value += values[index];
                known.places.push(index);
                continue;
            }
            let at = anchor(self.graph, place.at);
            // A thing on a floor is walked up to individually.
            let spot =
                (self.graph.node(at).is_some_and(|n| !crate::compile::is_ground(self.graph, n.id()))).then_some(at);
            unseen.push(Unseen { room, shut, spot, value: values[index], places: vec![index] });
        }
        unseen.sort_by(|a, b| {
            (a.room, a.shut.is_some()).cmp(&(b.room, b.shut.is_some())).then(b.value.total_cmp(&a.value))
        });
        unseen.truncate(MOST_SITES);
        for new in &unseen {
            let spot = new.spot.map(|id| self.spot(id));
            let number = self.search.sites.len() as u16;
            self.search.sites.push(Site { spot, shut: new.shut.is_some() });
            self.shut.push(new.shut);
            new.places.iter().for_each(|&p| self.site_of[p] = Some(number));
        }
        for room in 0..self.rooms.len().min(MOST_ROOMS) as u8 {
            let start = unseen.partition_point(|u| u.room < room) as u16;
            let shut = unseen.partition_point(|u| (u.room, u.shut.is_some()) < (room, true)) as u16;
            let end = unseen.partition_point(|u| u.room <= room) as u16;
            self.search.rooms.push((start..end, shut));
        }
    }

    /// For each place, the expected number of lacking things there.
    fn values(&self) -> Vec<f64> {
        let mut all = vec![0.0; self.belief.places_known()];
        for lack in self.compiled.lacks.iter().take(MOST_LACKS) {
            let Some(chances) = lack.subjects.first().and_then(|&id| self.belief.chances_of(id)) else { continue };
            for (index, _, _) in self.belief.sites() {
                all[index] += chances.at(index);
            }
        }
        all
    }

    /// Adds the known things that are wanted elsewhere, held or not.
    fn see_to_found(&mut self) {
        let (problem, start) = (&self.compiled.problem, &self.compiled.start);
        let mut left: Vec<usize> = problem.piles.iter().map(|p| p.items.len()).collect();
        let mut hands: Vec<(u32, NodeId)> =
            start.hands.iter().zip(problem.held).filter_map(|(&h, id)| Some((problem.kind(h), id?))).collect();
        for (n, need) in problem.needs.iter().enumerate() {
            let (mut wanted, way) = (problem.left(start, n) as usize, need.ways.first());
            let Some(way @ (Way::Put { .. } | Way::Keep | Way::UseHeld { .. })) = way else { continue };
            while let Some(hand) = hands.iter().position(|(serves, _)| wanted > 0 && serves & (1 << n) != 0) {
                let (_, id) = hands.remove(hand);
                wanted -= 1;
                match self.target(way) {
                    Some(target) => {
                        self.search.hands.push(target);
                        self.puts.extend(put(way, id));
                    }
                    None => self.search.blocked += 1,
                }
            }
            for (p, pile) in
                problem.piles.iter().enumerate().filter(|(_, p)| problem.kinds[p.kind as usize] & (1 << n) != 0)
            {
                let taken = wanted.min(left[p]);
                let from = pile.items.len() - left[p];
                for &id in pile.items[from..].iter().take(taken) {
                    self.found(id, problem.spots[pile.spot as usize].anchor, way);
                }
                (left[p], wanted) = (left[p] - taken, wanted - taken);
            }
        }
        self.search.blocked += hands.len() as u8;
    }

    fn found(&mut self, id: NodeId, spot: NodeId, way: &Way) {
        let Some(room) = self.graph.room_of(spot).and_then(|r| self.room_known(r)) else { return };
        let (spot, target) = (self.spot(spot), self.target(way));
        self.search.items.push(Item { spot, room, target });
        self.items.push(id);
    }

    /// The number of a room in the search; a room without sites is added.
    fn room_known(&mut self, id: NodeId) -> Option<u8> {
        let room = self.room(id)?;
        while self.search.rooms.len() <= room as usize {
            let end = self.search.sites.len() as u16;
            self.search.rooms.push((end..end, end));
        }
        Some(room)
    }

    fn target(&mut self, way: &Way) -> Option<u8> {
        let Way::Put { spot, door, .. } = way else { return None };
        let anchor = self.compiled.problem.spots[*spot as usize].anchor;
        let room = self.graph.room_of(anchor).and_then(|r| self.room_known(r))?;
        let container = door.map(|d| self.compiled.problem.doors[d as usize].node);
        let door = container.and_then(|id| self.shut.iter().position(|s| *s == Some(id))).map(|s| s as u16);
        let target = Target { spot: self.spot(anchor), room, door };
        let known = self.search.targets.iter().position(|t| *t == target);
        let number = known.unwrap_or(self.search.targets.len());
        if known.is_none() {
            self.search.targets.push(target);
        }
        (number < crate::object_search::MOST_TARGETS).then_some(number as u8)
    }

    /// Adds the lacking things and their possible places.
    fn seek(&mut self) {
        for (number, lack) in self.compiled.lacks.iter().take(MOST_LACKS).enumerate() {
            let target = lack.ways.first().and_then(|way| self.target(way));
            let before = self.search.sought_objects.len();
            let wanted = lack.number.max(INSTANCES).min(MOST_OBJECTS.saturating_sub(self.search.sought_objects.len()));
            for &id in lack.subjects.iter().take(wanted) {
                let Some(chances) = self.belief.chances_of(id) else { continue };
                let mut by_site = vec![0.0; self.search.sites.len()];
                for (index, _, _) in self.belief.sites() {
                    if let Some(site) = self.site_of[index] {
                        by_site[site as usize] += chances.at(index);
                    }
                }
                self.search.sought_objects.push(SoughtObject { lack: number as u8, chances: by_site });
            }
            // Fixed things that merely have not been seen need not be searched.
            let left = lack.number.min(self.search.sought_objects.len() - before) as u8;
            self.search.lacks.push(Lacking { left, target });
        }
    }

    fn best(mut self) -> Option<SearchStep> {
        let look = match self.search.best()? {
            Move::Visit { room, spot } => {
                SearchStep::Visit(spot.map_or(self.rooms[room as usize], |s| self.spots[s as usize]))
            }
            Move::Open(site) => SearchStep::Open(self.shut[site as usize]?),
            Move::Fetch(item) => SearchStep::Do(Action::one(Verb::Grab, self.items[item as usize])),
            Move::Deliver(hand) => {
                let put = *self.puts.get(hand as usize)?;
                let away = |room| (put.verb == Verb::Drop && self.graph.room_of(self.me) != Some(room)).then_some(room);
                let room = self.rooms[self.search.targets[self.search.hands[hand as usize] as usize].room as usize];
                away(room).map_or(SearchStep::Do(put), SearchStep::Visit)
            }
        };
        Some(look)
    }
}

fn put(way: &Way, id: NodeId) -> Option<Action> {
    match *way {
        Way::Put { verb: Verb::Drop, .. } => Some(Action::one(Verb::Drop, id)),
        Way::Put { verb, at, .. } => Some(Action::two(verb, id, at)),
        _ => None,
    }
}

/// The container that must be opened to see a place; `None` if the place is visible from its room.
fn box_at(graph: &SceneGraph, place: &Place, here: bool) -> Option<NodeId> {
    let shut = |id: NodeId| graph.node(id).is_some_and(vc_graph::Node::hides_contents);
    if let Some(around) = graph.hidden_in(place.at) {
        return Some(around);
    }
    match place.relation {
        Relation::Inside if shut(place.at) || here => Some(place.at),
        _ => None,
    }
}
