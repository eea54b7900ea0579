//! Saves: the state of traffic as bytes, and back.

use std::collections::{BTreeMap, BTreeSet, VecDeque};

use thiserror::Error;
use vc_graph::hash::Digester;

use crate::Traffic;
use crate::bytes::{Reader, Writer};
use crate::fleet::{Fleet, Go};
use crate::network::NONE;
use crate::roads::Roads;

const MAGIC: u64 = u64::from_le_bytes(*b"vctraff1");

/// Bytes that are no save, or not one of this traffic.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum SaveError {
    /// They do not begin as a save does.
    #[error("these bytes are no save of traffic, or one of another version: save anew")]
    NotASave,
    /// It belongs to another map, other trips, walks, options or another seed.
    #[error(
        "the save is of other traffic: restore it where map, trips, walks, options and seed are those that it was made with"
    )]
    OfAnother,
    /// They end early.
    #[error("the save ends early: take one that is whole")]
    Ends,
    /// They go on behind the end.
    #[error("{0} bytes follow the end of the save: take one that is whole")]
    Follows(usize),
    /// They were changed.
    #[error("the save was damaged: its sum does not fit, take one that is whole")]
    Damaged,
    /// Something in it cannot be.
    #[error("the save is not one of a state that can be: its {0} cannot be so")]
    Wrong(&'static str),
}

type Read<T> = Result<T, SaveError>;

/// Whether something holds of a save.
fn ensure(holds: bool, name: &'static str) -> Read<()> {
    if holds { Ok(()) } else { Err(SaveError::Wrong(name)) }
}

impl Traffic {
    /// The state as bytes: what [`Self::restore`] takes. They hold no map, trips or walks. Costs a look at each vehicle, person and link.
    ///
    /// ```
    /// # use vc_graph::Seed;
    /// # use vc_map::{Control, CrossSection, MapDraft, RoadClass, RoadId, Strip};
    /// # use vc_traffic::{Kerb, Traffic, TrafficOptions, Trip};
    /// # let mut draft = MapDraft::new("street", 48.1, 11.6);
    /// # let ends = [[0.0, 0.0], [200.0, 0.0], [400.0, 0.0]].map(|at| draft.junction(at, Control::Priority));
    /// # let side = vec![Strip::driving(3.0, 13.9)];
    /// # for pair in ends.windows(2) {
    /// #     let section = CrossSection { forward: side.clone(), backward: side.clone(), median: 0.0 };
    /// #     draft.road(pair[0], pair[1], RoadClass::Residential, section);
    /// # }
    /// # let map = draft.build()?; // a street of two roads along X
    /// # let kerb = |road, station| Kerb { road: RoadId(road), forward: true, station };
    /// # let trips = vec![Trip { class: 0, departs: 0.0, from: kerb(0, 20.0), to: kerb(1, 150.0) }];
    /// let new = || Traffic::new(&map, trips.clone(), &TrafficOptions::default(), Seed(7));
    /// let mut traffic = new()?;
    /// (0..100).for_each(|_| traffic.step());
    /// let bytes = traffic.save();
    /// // Elsewhere, with the same map and trips.
    /// let mut other = new()?;
    /// other.restore(&bytes)?;
    /// for traffic in [&mut traffic, &mut other] {
    ///     (0..100).for_each(|_| traffic.step());
    /// }
    /// assert_eq!(traffic.digest(), other.digest());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn save(&self) -> Vec<u8> {
        let mut to = Writer::default();
        to.long(MAGIC);
        to.long(self.fingerprint());
        to.long(self.step);
        to.word(self.coming as u32);
        to.list(self.pending.iter(), |to, (side, trips)| {
            to.word(*side);
            to.list(trips.iter(), |to, trip| to.word(*trip));
        });
        self.fleet.save(&mut to, &self.routes);
        self.roads.save(&mut to);
        to.list(self.wanting.iter(), |to, (slot, lane)| {
            to.word(*slot);
            to.word(*lane);
        });
        self.foot.save(&mut to);
        self.save_obstacles(&mut to);
        to.long(sum(&to.0));
        to.0
    }

    /// Goes on from a save of traffic with the same map, trips, walks, options and seed: bit for bit as that did. Events are none. Costs a
    /// look at each number, and the search of a way for each person.
    ///
    /// # Errors
    /// [`SaveError`]: the bytes are no save, one of other traffic, or damaged. Nothing has changed then.
    pub fn restore(&mut self, bytes: &[u8]) -> Result<(), SaveError> {
        let mut restored = self.clone();
        restored.read(bytes)?;
        *self = restored;
        Ok(())
    }

    fn read(&mut self, bytes: &[u8]) -> Read<()> {
        let (body, tail) = bytes.split_last_chunk::<8>().ok_or(SaveError::NotASave)?;
        let from = &mut Reader(body);
        if from.long().ok() != Some(MAGIC) {
            return Err(SaveError::NotASave);
        }
        if u64::from_le_bytes(*tail) != sum(body) {
            return Err(SaveError::Damaged);
        }
        if from.long()? != self.fingerprint() {
            return Err(SaveError::OfAnother);
        }
        self.step = from.long()?;
        self.coming = from.below(self.order.len() + 1, "next trip")? as usize;
        let network = self.network.clone();
        let trips = self.trips.len();
        let pending = from.list(|from| {
            let side = from.below(network.sides.len(), "side of a road")?;
            Ok((side, VecDeque::from(from.list(|from| from.below(trips, "trip"))?)))
        })?;
        let sides = pending.len();
        self.pending = BTreeMap::from_iter(pending);
        ensure(self.pending.len() == sides && self.pending.values().all(|trips| !trips.is_empty()), "list of trips")?;
        self.read_vehicles(from)?;
        self.roads = Roads::new(&network);
        self.read_roads(from)?;
        let slots = self.fleet.s.len();
        self.wanting = from.list(|from| Ok((from.below(slots, "vehicle")?, from.below(network.lanes, "lane")?)))?;
        self.read_foot(from)?;
        self.read_obstacles(from)?;
        (self.events, self.blocks) = (Vec::new(), Vec::new());
        if from.0.is_empty() { Ok(()) } else { Err(SaveError::Follows(from.0.len())) }
    }

    /// A number of everything that a save does not hold.
    fn fingerprint(&self) -> u64 {
        let mut hasher = Digester::new();
        hasher.word(self.seed.0).reals([self.dt]);
        hasher.reals(self.network.length.iter().copied());
        hasher.reals(self.classes.iter().flat_map(crate::VehicleClass::numbers));
        for trip in self.trips.iter() {
            let ends = [trip.from, trip.to];
            hasher.words(ends.map(|kerb| u64::from(kerb.road.0) << 1 | u64::from(kerb.forward)));
            hasher.word(u64::from(trip.class)).reals([trip.departs, trip.from.station, trip.to.station]);
        }
        for walk in self.foot.walks.iter() {
            hasher.words([walk.from, walk.to].map(|door| u64::from(door.0))).reals([walk.departs]);
        }
        hasher.digest().0
    }

    fn read_vehicles(&mut self, from: &mut Reader) -> Read<()> {
        let network = self.network.clone();
        (self.fleet, self.routes) = (Fleet::default(), Vec::new());
        self.slots.clear();
        let mut seen: BTreeSet<u32> = self.pending.values().flatten().copied().collect();
        let links = network.length.len();
        for slot in 0..from.word()? {
            let trip = from.below_or_none(self.trips.len(), "trip")?;
            if trip == NONE {
                self.fleet.push_slot();
                self.routes.push(Vec::new());
                continue;
            }
            ensure(seen.insert(trip), "trip")?;
            let i = slot as usize;
            let class = self.trips[trip as usize].class;
            let [s, v, acceleration, aside, share, stood, since, way] = from.reals("number of a vehicle")?;
            self.fleet.push_slot();
            let fleet = &mut self.fleet;
            (fleet.trip[i], fleet.class[i], fleet.share[i]) = (trip, class, share);
            (fleet.s[i], fleet.v[i], fleet.acceleration[i], fleet.aside[i]) = (s, v, acceleration, aside);
            (fleet.stood[i], fleet.since[i], fleet.way[i]) = (stood, since, way);
            fleet.link[i] = from.below(links, "link")?;
            fleet.next[i] = from.below_or_none(links, "next link")?;
            fleet.behind[i] = from.below_or_none(links, "link behind")?;
            fleet.beside[i] = from.below_or_none(network.lanes, "lane beside")?;
            fleet.go[i] = [Go::No, Go::Inside, Go::Over][from.below(3, "promise")? as usize];
            let leg = from.word()?;
            let route = from.list(|from| from.below(network.sides.len(), "side of a road"))?;
            ensure((leg as usize) < route.len(), "place in a route")?;
            fleet.leg[i] = leg;
            ensure(s >= 0.0 && v >= 0.0 && share > 0.0, "number of a vehicle")?;
            ensure(fleet.behind[i] == NONE || !network.is_lane(fleet.behind[i]), "link behind")?;
            let (link, next) = (fleet.link[i], fleet.next[i]);
            let leads = match network.is_lane(link) {
                true => next == NONE || (!network.is_lane(next) && network.from[network.movement(next)] == link),
                false => next == link,
            };
            ensure(leads, "next link")?;
            let free = next == NONE || network.free[network.movement(next)];
            let asked = network.is_lane(link) || fleet.go[i] != Go::No;
            ensure(if free { fleet.go[i] == Go::No } else { asked }, "promise")?;
            self.routes.push(route);
            self.slots.insert(crate::VehicleId(trip), slot);
        }
        let free = from.list(|from| from.word())?;
        ensure(self.fleet.set_free(free), "list of slots")
    }

    fn read_roads(&mut self, from: &mut Reader) -> Read<()> {
        let network = self.network.clone();
        let (links, slots) = (network.length.len(), self.fleet.s.len());
        let mut queued = vec![false; slots];
        for _ in 0..from.word()? {
            let link = from.below(links, "link")?;
            let queue = from.list(|from| from.below(slots, "vehicle"))?;
            for slot in &queue {
                let i = *slot as usize;
                let here = self.fleet.trip[i] != NONE && self.fleet.link[i] == link;
                ensure(here && !std::mem::replace(&mut queued[i], true), "queue")?;
            }
            self.roads.set_queue(link, queue);
        }
        ensure((0..slots).all(|i| queued[i] == (self.fleet.trip[i] != NONE)), "queue")?;
        let mut beside = 0;
        for _ in 0..from.word()? {
            let lane = from.below(network.lanes, "lane")?;
            let leaving = from.list(|from| from.below(slots, "vehicle"))?;
            let here =
                |slot: &u32| self.fleet.trip[*slot as usize] != NONE && self.fleet.beside[*slot as usize] == lane;
            ensure(
                leaving.iter().all(here) && leaving.iter().collect::<BTreeSet<_>>().len() == leaving.len(),
                "lane beside",
            )?;
            beside += leaving.len();
            self.roads.leaving[lane as usize] = leaving;
        }
        let on = |i: &usize| self.fleet.trip[*i] != NONE && self.fleet.beside[*i] != NONE;
        ensure((0..slots).filter(on).count() == beside, "lane beside")?;
        for _ in 0..from.word()? {
            let lane = from.below(network.lanes, "lane")?;
            self.roads.last[lane as usize] = from.below(slots, "vehicle")?;
        }
        for _ in 0..from.word()? {
            let link = from.below(links, "link")?;
            let (slot, trip) = (from.below(slots, "vehicle")?, from.below(self.trips.len(), "trip")?);
            let [way] = from.reals("way of a vehicle")?;
            self.roads.left[link as usize] = (slot, trip, way);
        }
        self.roads.covers = from.list(|from| {
            let slot = from.below(slots, "vehicle")?;
            let link = from.below(links, "link")?;
            let [until] = from.reals("way of a vehicle")?;
            ensure(self.fleet.trip[slot as usize] != NONE && !network.is_lane(link), "movement")?;
            Ok((slot, link, until))
        })?;
        ensure(slots + self.roads.covers.len() < usize::from(u16::MAX), "number of vehicles")?;
        self.promise_all();
        Ok(())
    }

    /// Takes the movements, and the room behind them, of all who may go or are on them.
    fn promise_all(&mut self) {
        let network = self.network.clone();
        let covers: Vec<(u32, bool)> =
            self.roads.covers.iter().map(|(slot, link, _)| (*link, self.is_long(*slot))).collect();
        covers.into_iter().for_each(|(link, long)| self.roads.take(&network, link, long));
        let slots: Vec<u32> = self.slots.values().copied().collect();
        slots.into_iter().for_each(|slot| self.promise(slot));
    }

    /// Takes the movement, and the room behind it, that a vehicle may take or is on.
    pub(crate) fn promise(&mut self, slot: u32) {
        let network = self.network.clone();
        let i = slot as usize;
        let next = self.fleet.next[i];
        match self.fleet.go[i] {
            // On a movement that is always free.
            Go::No if !network.is_lane(self.fleet.link[i]) => {
                return self.roads.take(&network, next, self.is_long(slot));
            }
            Go::No => return,
            Go::Inside => self.roads.wait(&network, network.movement(next), true),
            Go::Over => self.roads.take(&network, next, self.is_long(slot)),
        }
        self.roads.promised[network.to[network.movement(next)] as usize] += self.room(slot);
    }
}

/// A number of some bytes.
fn sum(bytes: &[u8]) -> u64 {
    let mut hasher = Digester::new();
    hasher.bytes(bytes);
    hasher.digest().0
}
