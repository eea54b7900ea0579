//! The queue model: lanes that vehicles pass at the limit, wait at the ends of, and leave one by one, event by event.

use std::collections::VecDeque;
use std::sync::Arc;

use vc_map::{Control, Light, Users};

use super::TICKS;
use super::agenda::{Agenda, Event};
use super::log::Log;
use super::pace::Paces;
use super::step::Step;
use crate::VehicleClass;
use crate::lights;
use crate::network::{NONE, Network};

/// No time.
const NEVER: u32 = u32::MAX;
/// The time between two that leave a lane, and what the first in a green loses to get going; ticks.
const HEADWAY: u32 = 2 * 60;
const STARTS: f64 = 2.0;
/// One gives way to those who come within such a time, and keeps so far behind those who have crossed its way; ticks.
const GAP: u32 = 4 * 60;
const CLEAR: u32 = 60 + 30;
/// The time to stop at a sign; ticks.
const STOPS: u32 = 2 * 60;
/// The one that has waited longest goes before others who wait for each other, after this time; ticks.
const EQUAL: u32 = 4 * 60;
/// Nobody gives way for longer, and nobody waits longer for room, in a ring of lanes that are full for example; ticks.
const PATIENCE: u32 = 60 * 60;
const STUCK: u32 = 180 * 60;
/// One who waits looks again after so many ticks.
const LOOKS: u32 = 60;
/// Nobody pulls out with another nearer behind, metres.
const BEHIND: f64 = 3.0;

/// A lane as it is.
#[derive(Clone)]
struct Lane {
    /// Those on it, by the numbers of their drivers, the foremost first.
    queue: VecDeque<u32>,
    /// Those on it or on their way over the junction to it, and how many have room.
    count: u32,
    room: u32,
    /// When the next may leave, and since when the first has been the first.
    free: u32,
    first: u32,
    /// When the first is to look whether it may go.
    due: u32,
    speed: f64,
}

/// A vehicle on its way.
#[derive(Clone, Default)]
struct Car {
    route: Arc<[u32]>,
    leg: usize,
    /// Its present lane, when it can be at its end, and the number of its step there.
    lane: u32,
    ready: u32,
    step: u32,
    /// The movement to its next side of a road, the lane to which that leads, and the one from which it goes on.
    next: (u32, u32, u32),
    goal: (u32, f32),
}

/// All lanes of a map with those on them.
pub(super) struct Queues {
    network: Arc<Network>,
    paces: Arc<Paces>,
    /// A vehicle's length with the gap at a standstill, metres.
    space: f64,
    length: f64,
    lanes: Vec<Lane>,
    /// From when on the last who went by a movement is out of the way of others, and the movements that are in its way.
    clear: Vec<u32>,
    met: Vec<Vec<u32>>,
    cars: Vec<Car>,
    log: Log,
    /// How often somebody went where there was no room, or without a gap, as they had waited for too long.
    pub(super) squeezed: usize,
    pub(super) agenda: Agenda,
}

impl Queues {
    pub(super) fn new(network: &Arc<Network>, paces: &Arc<Paces>, class: &VehicleClass, people: usize) -> Self {
        let space = f64::from(class.length + class.standing_gap);
        let lane = |lane: usize| Lane {
            queue: VecDeque::new(),
            count: 0,
            room: ((f64::from(network.length[lane]) / space) as u32).max(1),
            free: 0,
            first: 0,
            due: NEVER,
            speed: paces.of(lane as u32),
        };
        let met = |movement: usize| {
            let junction = network.junction[movement] as usize;
            let (table, own) = (&network.map.junctions()[junction].conflicts, network.row[movement] as usize);
            let rows = network.rows[junction].iter().enumerate();
            rows.filter(|(row, _)| table.has(own, *row)).map(|(_, link)| network.movement(*link) as u32).collect()
        };
        let movements = network.from.len();
        Self {
            space,
            length: f64::from(class.length),
            lanes: (0..network.lanes).map(lane).collect(),
            clear: vec![0; movements],
            met: (0..movements).map(met).collect(),
            cars: vec![Car::default(); people],
            log: Log::default(),
            squeezed: 0,
            agenda: Agenda::default(),
            network: network.clone(),
            paces: paces.clone(),
        }
    }

    /// Lets somebody pull out to drive along some sides of roads, from a station of a lane to one of another; the number of the journey, or `None` if there
    /// is no room yet.
    pub(super) fn set_out(
        &mut self,
        now: u32,
        since: u32,
        person: u32,
        route: &Arc<[u32]>,
        ends: [(u32, f32); 2],
    ) -> Option<u32> {
        let [(kerb, begin), goal] = ends;
        let lane = self.lanes_to(route[0], route.get(1).copied(), kerb)?;
        let of = &self.lanes[lane as usize];
        let passed = || self.stations(now, lane).all(|(_, at)| at - self.length > f64::from(begin) + BEHIND);
        let late = now - since > STUCK;
        if !late && (of.count >= of.room || !passed()) {
            return None;
        }
        self.squeezed += usize::from(late);
        self.lanes[lane as usize].count += 1;
        let next = (NONE, kerb, lane);
        self.cars[person as usize] = Car { route: route.clone(), leg: 0, next, goal, ..Car::default() };
        let drive = self.log.new_drive();
        self.come(now, person, begin.min(self.network.length[lane as usize] - 1.0).max(0.0), drive);
        Some(drive)
    }

    /// The lane of a side from which one goes on that is nearest to the kerb's.
    fn lanes_to(&self, side: u32, after: Option<u32>, kerb: u32) -> Option<u32> {
        let lanes = self.network.sides[side as usize].iter().copied().filter(|lane| self.leads(*lane, after));
        lanes.min_by_key(|lane| (lane.abs_diff(kerb), *lane))
    }

    /// Whether cars use a lane, and go on from it to a side of a road.
    fn leads(&self, lane: u32, after: Option<u32>) -> bool {
        let network = &self.network;
        network.users[lane as usize].has(Users::CAR)
            && after.is_none_or(|side| network.towards(lane, side, Users::CAR).is_some())
    }

    /// Whether a route can be driven.
    pub(super) fn is_open(&self, route: &[u32]) -> bool {
        let open = |(leg, side): (usize, &u32)| {
            let after = route.get(leg + 1).copied();
            self.network.sides[*side as usize].iter().any(|lane| self.leads(*lane, after))
        };
        route.iter().enumerate().all(open)
    }

    /// Somebody comes to their next lane.
    pub(super) fn enter(&mut self, now: u32, person: u32) {
        self.cars[person as usize].leg += 1;
        let drive = self.log.drive(self.cars[person as usize].step);
        self.come(now, person, 0.0, drive);
    }

    fn come(&mut self, now: u32, person: u32, begin: f32, drive: u32) {
        let car = &self.cars[person as usize];
        let (movement, from, number) = car.next;
        let last = car.leg + 1 == car.route.len();
        let lane = &self.lanes[number as usize];
        let length = self.network.length[number as usize];
        let end = if last { car.goal.1.clamp(begin, length.max(begin)) } else { length };
        let takes = (f64::from(end - begin) / lane.speed).ceil() as u32;
        let stops = if self.network.stops[number as usize] && !last { STOPS } else { 0 };
        let ahead = lane.queue.back().map_or(NONE, |other| self.cars[*other as usize].step);
        let ready = now + takes + stops;
        let step = Step { movement, from, lane: number, enters: now, leaves: NEVER, begin, stands: end, end };
        let index = self.log.add(step, ahead, drive);
        let car = &mut self.cars[person as usize];
        (car.lane, car.ready, car.step) = (number, ready, index);
        let lane = &mut self.lanes[number as usize];
        lane.queue.push_back(person);
        if lane.queue.len() == 1 {
            lane.first = now;
            self.look(number, ready);
        }
        if last {
            self.agenda.push(ready, Event::Arrives(person));
        }
    }

    /// Has the first on a lane look whether it may go, at a tick or before.
    fn look(&mut self, lane: u32, at: u32) {
        let due = &mut self.lanes[lane as usize].due;
        if at < *due {
            *due = at;
            self.agenda.push(at, Event::Goes(lane));
        }
    }

    /// The first on a lane goes, if it may.
    pub(super) fn go(&mut self, now: u32, lane: u32) {
        // Another look came first.
        if self.lanes[lane as usize].due != now {
            return;
        }
        self.lanes[lane as usize].due = NEVER;
        let Some(person) = self.lanes[lane as usize].queue.front().copied() else { return };
        match self.may_go(now, lane, person) {
            Ok((movement, to)) => self.over(now, person, movement, to),
            Err(NEVER) => {}
            Err(at) => self.look(lane, at.max(now + 1)),
        }
    }

    /// The movement and the lane to which the first on a lane may go; or when it is to look again.
    fn may_go(&mut self, now: u32, lane: u32, person: u32) -> Result<(u32, u32), u32> {
        let (car, of) = (&self.cars[person as usize], &self.lanes[lane as usize]);
        let ready = car.ready.max(of.free);
        if ready > now {
            return Err(ready);
        }
        let waited = now - of.first.max(car.ready);
        let Some((link, to)) = self.choose(lane, car) else { return Err(NEVER) };
        let movement = self.network.movement(link);
        let (junction, row) = (self.network.junction[movement] as usize, self.network.row[movement] as usize);
        let signal = self.network.map.junctions()[junction].signal.and_then(|id| self.network.map.signal(id));
        let seconds = f64::from(now) / TICKS;
        let mut yields = true;
        if let Some(signal) = signal {
            let wait = lights::wait(signal, row, seconds).unwrap_or(0.0);
            if wait > 0.0 {
                return Err(now + (wait * TICKS).ceil() as u32);
            }
            let green = lights::since(signal, row, seconds).unwrap_or(f64::INFINITY);
            if green < STARTS && f64::from(now - car.ready) >= green * TICKS {
                return Err(now + ((STARTS - green) * TICKS).ceil() as u32);
            }
            yields = lights::light(signal, lights::phase(signal, seconds).0, row) == Some(Light::GreenYield);
        }
        let keeps = self.met[movement].iter().any(|other| self.clear[*other as usize] > now);
        if keeps && waited < STUCK {
            return Err(now + LOOKS / 2);
        }
        if yields && waited < PATIENCE && self.gives_way(now, lane, movement) {
            return Err(now + LOOKS);
        }
        if self.lanes[to as usize].count >= self.lanes[to as usize].room {
            if waited < STUCK {
                return Err(now + LOOKS);
            }
            self.squeezed += 1;
        }
        Ok((link, to))
    }

    /// The movement from a lane to the next side of somebody's route, and the lane there from which they go on: the emptiest, and rather one to which
    /// the movement leads. `None` if they arrive on this lane.
    fn choose(&self, lane: u32, car: &Car) -> Option<(u32, u32)> {
        let network = &self.network;
        let side = *car.route.get(car.leg + 1)?;
        let after = car.route.get(car.leg + 2).copied();
        let links = network.next[lane as usize].iter().copied();
        let links = links.filter(|link| {
            network.side[network.to[network.movement(*link)] as usize] == side
                && network.users[*link as usize].has(Users::CAR)
        });
        let fits = |to: &u32| match after {
            Some(_) => self.leads(*to, after),
            None => *to == car.goal.0,
        };
        let to = || network.sides[side as usize].iter().copied().filter(fits);
        let both = links.flat_map(|link| to().map(move |to| (link, to)));
        both.min_by_key(|(link, to)| {
            let aside = u32::from(network.to[network.movement(*link)] != *to);
            (self.lanes[*to as usize].count + 2 * aside, *to, *link)
        })
    }

    /// Whether the first on a lane gives way to the first on another.
    fn gives_way(&self, now: u32, lane: u32, movement: usize) -> bool {
        let network = &self.network;
        let junction = &network.map.junctions()[network.junction[movement] as usize];
        let signal = junction.signal.and_then(|id| network.map.signal(id));
        let first = match junction.draft.control {
            // All of them stop, and go in the order in which they have come.
            Control::AllWayStop => &self.met[movement],
            _ if signal.is_some() => &self.met[movement],
            _ => {
                return self.before(
                    now,
                    lane,
                    network.map.movements()[movement].yields.iter().filter_map(|row| {
                        let link = network.rows[network.junction[movement] as usize].get(*row as usize)?;
                        Some(network.movement(*link) as u32)
                    }),
                );
            }
        };
        let seconds = f64::from(now) / TICKS;
        let green = |other: &u32| {
            let phase = signal.map(|signal| (signal, lights::phase(signal, seconds).0));
            let light =
                phase.map(|(signal, phase)| lights::light(signal, phase, network.row[*other as usize] as usize));
            light.is_none_or(|light| light == Some(Light::Green))
        };
        self.before(now, lane, first.iter().copied().filter(green))
    }

    /// Whether somebody comes who goes first by one of some movements.
    fn before(&self, now: u32, lane: u32, first: impl Iterator<Item = u32>) -> bool {
        let network = &self.network;
        let mut first = first.filter(|other| network.from[*other as usize] != lane);
        let own = &self.lanes[lane as usize];
        first.any(|other| {
            let from = network.from[other as usize];
            let theirs = &self.lanes[from as usize];
            let Some(car) = theirs.queue.front().map(|person| &self.cars[*person as usize]) else { return false };
            let side = network.side[network.to[other as usize] as usize];
            let comes = car.route.get(car.leg + 1) == Some(&side) && car.ready.max(theirs.free) <= now + GAP;
            // One who has waited for long cannot go either: of these the one goes that came first.
            let waits = car.ready.max(theirs.first) + EQUAL < now;
            comes && !(waits && (own.first, lane) < (theirs.first, from))
        })
    }

    /// Somebody goes over a junction.
    fn over(&mut self, now: u32, person: u32, link: u32, to: u32) {
        let network = self.network.clone();
        let Car { lane, ready, .. } = self.cars[person as usize];
        let stood = now > ready + HEADWAY / 2;
        self.clear[network.movement(link)] = now + CLEAR;
        self.cars[person as usize].next = (link, network.to[network.movement(link)], to);
        self.lanes[to as usize].count += 1;
        self.lanes[lane as usize].free = now + HEADWAY;
        self.leave(now, person);
        let pace = if stood { self.paces.out_of_queue(link) } else { self.paces.of(link) };
        let takes = (f64::from(network.length[link as usize]) / pace).ceil() as u32;
        self.agenda.push(now + takes.max(1), Event::Enters(person));
    }

    /// Somebody leaves their lane.
    fn leave(&mut self, now: u32, person: u32) {
        let Car { lane, step, .. } = self.cars[person as usize];
        self.log.leave(step, now);
        let of = &mut self.lanes[lane as usize];
        let first = of.queue.front() == Some(&person);
        of.queue.retain(|other| *other != person);
        of.count -= 1;
        if let Some(next) = of.queue.front().copied().filter(|_| first) {
            of.first = now;
            let at = of.free.max(self.cars[next as usize].ready);
            self.look(lane, at.max(now));
        }
    }

    /// Somebody arrives, if those ahead have let them come so far; they try again if not.
    pub(super) fn arrive(&mut self, now: u32, person: u32) -> bool {
        let car = &self.cars[person as usize];
        let end = f64::from(self.log.step(car.step).end);
        let there =
            self.stations(now, car.lane).find(|(other, _)| *other == person).is_none_or(|(_, at)| at > end - 0.5);
        if there {
            self.leave(now, person);
        } else {
            self.agenda.push(now + LOOKS, Event::Arrives(person));
        }
        there
    }

    /// Those on a lane with their stations, as far as one knows by now, metres, the foremost first.
    fn stations(&self, now: u32, lane: u32) -> impl Iterator<Item = (u32, f64)> {
        let of = &self.lanes[lane as usize];
        let mut ahead = f64::INFINITY;
        of.queue.iter().map(move |person| {
            let step = self.log.step(self.cars[*person as usize].step);
            let free = f64::from(step.begin) + of.speed * f64::from(now - step.enters);
            ahead = free.min(ahead - self.space).min(f64::from(step.end)).max(f64::from(step.begin));
            (*person, ahead)
        })
    }

    /// The steps of all journeys, one journey after the other, and where each begins.
    pub(super) fn finish(self) -> (Vec<Step>, Vec<u32>) {
        self.log.finish(&self.network, &self.paces, self.space)
    }
}
