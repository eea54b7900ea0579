//! People on the map: their walks from door to door, and crossings, which they and vehicles leave to each other.

use std::collections::BTreeMap;
use std::sync::Arc;

use vc_graph::Seed;
use vc_map::route::{Leg, Mode, Router};
use vc_map::{CrossingId, DrivingSide, Light, Polyline, StreetMap, WalkKind};

use crate::Traffic;
use crate::advance::STUCK;
use crate::crossing::{KERB, TO_DOOR, is_off_the_road, widths};
use crate::crowd::{Crowd, RADIUS, Walker, Way};
use crate::network::NONE;
use crate::trip::{PersonId, TrafficEvent, Walk};

/// The speed of people with nobody around, its deviation, and its bounds, metres per second (Weidmann, 1993).
const SPEED: f32 = 1.34;
const DEVIATION: f32 = 0.26;
const SPEEDS: [f32; 2] = [0.6, 2.0];
/// Those who cross walk at least so fast, metres per second: lights give time for less.
const HURRY: f32 = 1.2;
/// Vehicles yield to whoever is so near to a crossing's kerb, and one begins to cross from so near, metres.
const CLAIMS: f32 = 2.0;
const BEGINS: f32 = 0.5;
/// Somebody has arrived who is so near to their door, metres; those who set out wait for room, and try once in so many seconds.
const THERE: f32 = 0.4;
const TRIES: f32 = 1.0;

/// A crossing on somebody's way, between two stations, metres.
#[derive(Debug, Clone, Copy)]
struct Passage {
    crossing: u32,
    from: f32,
    to: f32,
}

/// Somebody's way, as it is gone.
#[derive(Debug, Clone)]
struct Journey {
    passages: Vec<Passage>,
    next: usize,
    /// Whether they may cross the next, or do.
    on: bool,
    since: f32,
    speed: f32,
}

/// Those on foot, and the crossings.
#[derive(Clone)]
pub(crate) struct Foot {
    pub(crate) crowd: Crowd,
    walks: Arc<Vec<Walk>>,
    router: Option<Arc<Router>>,
    widths: Arc<Vec<f32>>,
    /// The walks in the order of their departure, and the next of these.
    order: Arc<Vec<u32>>,
    coming: usize,
    /// Those who wait for room at their door.
    pending: BTreeMap<PersonId, (Arc<Way>, Vec<Passage>)>,
    journeys: BTreeMap<PersonId, Journey>,
    /// For each crossing: the number of those who may cross or do, whether somebody is about to, and whether a vehicle has waited for too long.
    on: Vec<u16>,
    claimed: Vec<bool>,
    pub(crate) late: Vec<bool>,
    /// For each junction: whether one of its crossings is claimed.
    pub(crate) claims: Vec<bool>,
}

impl Foot {
    /// Nobody on foot.
    pub(crate) fn none(map: &StreetMap, step: f32) -> Self {
        let crowd = Crowd::new(step);
        let crossings = map.crossings().len();
        Self {
            crowd: if map.side() == DrivingSide::Left { crowd.keeping_left() } else { crowd },
            walks: Arc::default(),
            router: None,
            widths: Arc::default(),
            order: Arc::default(),
            coming: 0,
            pending: BTreeMap::new(),
            journeys: BTreeMap::new(),
            on: vec![0; crossings],
            claimed: vec![false; crossings],
            late: vec![false; crossings],
            claims: vec![false; map.junctions().len()],
        }
    }

    /// Sets the walks of those who are to come.
    pub(crate) fn set(&mut self, map: &StreetMap, walks: Vec<Walk>) {
        let mut order: Vec<u32> = (0..walks.len() as u32).collect();
        order.sort_by(|a, b| walks[*a as usize].departs.total_cmp(&walks[*b as usize].departs).then(a.cmp(b)));
        (self.walks, self.order) = (Arc::new(walks), Arc::new(order));
        self.router = Some(Arc::new(Router::new(map, Mode::Foot)));
        self.widths = Arc::new(widths(map));
    }

    /// The number of walks that have not begun.
    pub(crate) fn waiting(&self) -> usize {
        self.pending.len() + self.order.len() - self.coming
    }

    /// All that decides on what follows, as numbers.
    pub(crate) fn words(&self) -> impl Iterator<Item = u64> {
        let journeys = self.journeys.values().map(|journey| journey.next as u64 * 2 + u64::from(journey.on));
        let pending = self.pending.keys().map(|id| u64::from(id.0));
        [self.crowd.digest().0, self.coming as u64].into_iter().chain(journeys).chain(pending)
    }

    /// The way of a walk, and the crossings on it; `None` where it leads over the carriageway.
    fn way(&self, traffic: &Traffic, walk: &Walk) -> Option<(Arc<Way>, Vec<Passage>)> {
        let map = traffic.map();
        let route = self.router.as_ref()?.between_entrances(walk.from, walk.to)?;
        let [from, to] = [map.entrance(walk.from)?, map.entrance(walk.to)?];
        let beside = |entrance: &vc_map::Entrance| {
            entrance.edge.and_then(|edge| map.walk_edge(edge)).map(|edge| edge.line.at(entrance.station))
        };
        let doors = [Polyline::new([from.door, beside(from)?]), Polyline::new([beside(to)?, to.door])];
        if !doors.iter().flatten().all(|line| is_off_the_road(map, line)) {
            return None;
        }
        let [first, last] = doors.map(|line| line.map(|line| (line, TO_DOOR)));
        let mut parts: Vec<(Polyline, f32)> = first.into_iter().collect();
        let mut passages = Vec::new();
        for (number, leg) in route.legs.iter().enumerate() {
            let Leg::Walk(id, forward) = leg else { return None };
            let edge = map.walk_edge(*id)?;
            let length = edge.line.length();
            let mut range = if *forward { [0.0, length] } else { [length, 0.0] };
            if number == 0 && from.edge == Some(*id) {
                range[0] = from.station;
            }
            if number + 1 == route.legs.len() && to.edge == Some(*id) {
                range[1] = to.station;
            }
            let width = self.widths.get(id.index()).copied().filter(|width| *width > 0.0)?;
            if let WalkKind::Crossing(crossing) = edge.kind {
                let [near, far] = traffic.network.crosswalks.get(crossing.index())?.kerbs;
                let [near, far] = if *forward { [near, far] } else { [length as f32 - far, length as f32 - near] };
                let station = parts.iter().map(|(line, _)| line.length()).sum::<f64>() as f32;
                passages.push(Passage { crossing: crossing.0, from: station + near, to: station + far });
            }
            let part = edge.line.part(range[0].min(range[1]), range[0].max(range[1]));
            parts.extend(part.map(|part| (if *forward { part } else { part.reversed() }, width)));
        }
        parts.extend(last);
        Some((Arc::new(Way::new(parts)?), passages))
    }
}

impl Traffic {
    /// People ask to cross, as they stand, and leave the crossings that are behind them.
    pub(crate) fn cross(&mut self) {
        if self.foot.crowd.is_empty() && !self.foot.claims.contains(&true) {
            return;
        }
        self.foot.claimed.fill(false);
        self.foot.claims.fill(false);
        let mut journeys = std::mem::take(&mut self.foot.journeys);
        for (journey, slot) in journeys.values_mut().zip(self.foot.crowd.slots()) {
            let Some(Passage { crossing, from, to }) = journey.passages.get(journey.next).copied() else { continue };
            let station = self.foot.crowd.station(slot);
            let walk = self.network.crosswalks[crossing as usize];
            let (junction, c) = (walk.junction as usize, crossing as usize);
            let light = self.light_of(junction, walk.row as usize);
            let lit = matches!(light, None | Some(Light::Green | Light::GreenYield));
            // One who has not come over the kerb yet waits.
            let begun = station + RADIUS > from + KERB;
            let mut leaves = false;
            if journey.on {
                leaves = station > to + RADIUS;
                if leaves || (!lit && !begun) {
                    journey.on = false;
                    self.foot.on[c] -= 1;
                }
                if leaves {
                    self.foot.crowd.keep(slot, to + RADIUS);
                }
            } else if lit && station > from - CLAIMS - RADIUS {
                (self.foot.claimed[c], self.foot.claims[junction]) = (true, true);
                let near = station > from - BEGINS - RADIUS;
                if near && !self.foot.late[c] && self.is_clear(junction, walk.row as usize, NONE) {
                    journey.on = true;
                    self.foot.on[c] += 1;
                }
            }
            journey.next += usize::from(leaves);
            self.roads.cross(junction, walk.row, self.foot.on[c] > 0);
            let ahead = journey.next + usize::from(journey.on);
            let stop = journey.passages.get(ahead).map_or(f32::INFINITY, |next| next.from);
            let speed = if journey.on { journey.speed.max(HURRY) } else { journey.speed };
            self.foot.crowd.lead_slot(slot, stop, speed);
        }
        self.foot.journeys = journeys;
    }

    /// Whether somebody is about to cross where a row of a junction leads.
    pub(crate) fn is_claimed(&self, junction: usize, row: usize) -> bool {
        if !self.foot.claims[junction] {
            return false;
        }
        let of = &self.network.map.junctions()[junction];
        let met = |(place, id): (usize, &CrossingId)| {
            self.foot.claimed[id.index()] && of.conflicts.has(row, of.movements.len() + place)
        };
        of.crossings.iter().enumerate().any(met)
    }

    /// Nobody else begins to cross where a vehicle has waited for too long.
    pub(crate) fn keep_clear(&mut self, junction: usize, row: usize) {
        let of = &self.network.map.junctions()[junction];
        for (place, id) in of.crossings.iter().enumerate() {
            if of.conflicts.has(row, of.movements.len() + place) {
                self.foot.late[id.index()] = true;
            }
        }
    }

    /// A step on foot: people walk, arrive, and set out.
    pub(crate) fn walk(&mut self) {
        if self.foot.walks.is_empty() {
            return;
        }
        self.foot.crowd.step();
        let now = (self.step + 1) as f32 * self.dt;
        let stuck = |walker: &Walker| (STUCK..STUCK + self.dt).contains(&walker.stood);
        let stuck: Vec<PersonId> = self.foot.crowd.people().filter(stuck).map(|walker| walker.id).collect();
        self.events.extend(stuck.into_iter().map(|person| TrafficEvent::StuckOnFoot { person }));
        let there = |walker: &Walker| walker.station() > walker.way.length() - THERE;
        let arrived: Vec<Walker> = self.foot.crowd.people().filter(there).collect();
        for walker in arrived {
            self.foot.crowd.remove(walker.id);
            if let Some(journey) = self.foot.journeys.remove(&walker.id) {
                let (person, metres) = (walker.id, walker.way.length());
                self.events.push(TrafficEvent::Reached { person, seconds: now - journey.since, metres });
            }
        }
        self.set_off(now);
    }

    fn set_off(&mut self, now: f32) {
        while let Some(number) = self.foot.order.get(self.foot.coming).copied() {
            let walk = self.foot.walks[number as usize];
            if walk.departs > now {
                break;
            }
            self.foot.coming += 1;
            let person = PersonId(number);
            match self.foot.way(self, &walk) {
                Some(way) => _ = self.foot.pending.insert(person, way),
                None => self.events.push(TrafficEvent::NoWalk { person }),
            }
        }
        let every = (TRIES / self.dt).round().max(1.0) as u64;
        let seed: Seed = self.seed.child("people");
        let foot = &mut self.foot;
        let step = self.step;
        let trying = foot.pending.iter().filter(|(id, _)| (step + u64::from(id.0)).is_multiple_of(every));
        let trying: Vec<PersonId> = trying.map(|(id, _)| *id).collect();
        for id in trying {
            let Some((way, passages)) = foot.pending.remove(&id) else { continue };
            let speed = seed.nth(u64::from(id.0)).stream().normal(SPEED, DEVIATION).clamp(SPEEDS[0], SPEEDS[1]);
            let mut walker = Walker::new(id, way.clone(), 0.0, 0.0, speed);
            walker.stop = passages.first().map_or(f32::INFINITY, |passage| passage.from);
            if foot.crowd.add(walker) {
                foot.journeys.insert(id, Journey { passages, next: 0, on: false, since: now, speed });
                self.events.push(TrafficEvent::SetOff { person: id });
            } else {
                foot.pending.insert(id, (way, passages));
            }
        }
    }
}
