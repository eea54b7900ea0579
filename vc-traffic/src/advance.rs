//! Movement: along links, from link to link, sideways, and off the road at the end.

use crate::Traffic;
use crate::fleet::Go;
use crate::network::NONE;
use crate::right_of_way::STANDING;
use crate::swept::is_long;
use crate::trip::{TrafficEvent, VehicleId};

/// One that has stood for so long is told, seconds, and one that stands in the wrong lane for so long goes where it leads.
pub(crate) const STUCK: f32 = 300.0;
const WRONG: f32 = 20.0;
/// One that finds no way to its destination is gone so far before the end of its lane, metres.
const LOST: f32 = 6.0;
/// Vehicles go sideways at this part of their speed, and at least and at most so fast, metres per second.
const SIDEWAYS: f32 = 0.2;
const SLOWEST: f32 = 0.25;
const FASTEST: f32 = 1.0;

impl Traffic {
    pub(crate) fn advance(&mut self) {
        self.integrate();
        let network = self.network.clone();
        for link in self.roads.in_use() {
            self.arrive(link);
            while let Some(slot) = self.roads.queue[link as usize].front().copied() {
                if self.fleet.s[slot as usize] < network.length[link as usize] || !self.pass(link, slot) {
                    break;
                }
                // Over short links one comes in a step.
                loop {
                    let on = self.fleet.link[slot as usize];
                    let first = self.roads.queue[on as usize].front() == Some(&slot);
                    let over = self.fleet.s[slot as usize] >= network.length[on as usize];
                    if !(first && over && self.pass(on, slot)) {
                        break;
                    }
                }
            }
        }
        self.clear();
    }

    /// Speeds and stations after a step.
    fn integrate(&mut self) {
        let dt = self.dt;
        let fleet = &mut self.fleet;
        for i in 0..fleet.s.len() {
            let (v, a) = (fleet.v[i], fleet.acceleration[i]);
            let faster = v + a * dt;
            let way = if faster > 0.0 { (v + faster) * 0.5 * dt } else { v * v / (-2.0 * a).max(1e-6) };
            fleet.v[i] = faster.max(0.0);
            fleet.s[i] += way;
            fleet.way[i] += way;
            fleet.stood[i] = if fleet.v[i] < STANDING { fleet.stood[i] + dt } else { 0.0 };
            let aside = fleet.aside[i];
            if aside != 0.0 {
                let most = (fleet.v[i] * SIDEWAYS).clamp(SLOWEST, FASTEST) * dt;
                fleet.aside[i] = if aside.abs() <= most { 0.0 } else { aside - most.copysign(aside) };
            }
        }
    }

    /// Takes those off the road who have arrived.
    fn arrive(&mut self, link: u32) {
        if !self.network.is_lane(link) {
            return;
        }
        let mut place = 0;
        while let Some(slot) = self.roads.queue[link as usize].get(place).copied() {
            let i = slot as usize;
            let to = &self.trips[self.fleet.trip[i] as usize].to;
            let last = self.fleet.leg[i] as usize + 1 == self.routes[i].len();
            let length = self.network.length[link as usize];
            let there = self.network.side[link as usize] == to.road.0 * 2 + u32::from(!to.forward);
            let end = if there { to.station.min(length - 0.5) } else { length - LOST };
            if last && self.fleet.s[i] >= end {
                self.remove(slot, there);
            } else {
                place += 1;
            }
        }
    }

    fn remove(&mut self, slot: u32, there: bool) {
        let i = slot as usize;
        let vehicle = VehicleId(self.fleet.trip[i]);
        let seconds = self.step as f32 * self.dt - self.fleet.since[i];
        self.events.push(if there {
            TrafficEvent::Arrived { vehicle, seconds, metres: self.fleet.way[i] }
        } else {
            TrafficEvent::Lost { vehicle }
        });
        self.slots.remove(&vehicle);
        self.off_the_road(slot);
    }

    /// Takes a vehicle off its link, and off the junctions that its rear still covers.
    pub(crate) fn off_the_road(&mut self, slot: u32) {
        let network = self.network.clone();
        self.roads.leave(self.fleet.link[slot as usize], slot);
        let covered: Vec<u32> = self.roads.covers.iter().filter(|(other, ..)| *other == slot).map(|of| of.1).collect();
        let long = self.is_long(slot);
        covered.into_iter().for_each(|movement| self.roads.give(&network, movement, long));
        self.roads.covers.retain(|(other, ..)| *other != slot);
        self.stop_leaving(slot);
        self.fleet.remove(slot);
    }

    /// Ends a change of lanes.
    fn stop_leaving(&mut self, slot: u32) {
        let i = slot as usize;
        if self.fleet.beside[i] != NONE {
            self.roads.leaving[self.fleet.beside[i] as usize].retain(|other| *other != slot);
            self.fleet.beside[i] = NONE;
        }
    }

    /// Moves the first of a link on to the next one; false if it has to stop.
    fn pass(&mut self, link: u32, slot: u32) -> bool {
        let i = slot as usize;
        let network = self.network.clone();
        let length = network.length[link as usize];
        if network.is_lane(link) {
            let next = self.fleet.next[i];
            if next == NONE || !(network.free[network.movement(next)] || self.fleet.go[i] != Go::No) {
                self.fleet.way[i] -= self.fleet.s[i] - (length - 0.01);
                (self.fleet.s[i], self.fleet.v[i]) = (length - 0.01, 0.0);
                return false;
            }
            self.stop_leaving(slot);
            self.roads.queue[link as usize].pop_front();
            self.roads.last[link as usize] = slot;
            self.roads.leaves(&network, &self.fleet, link, slot);
            if network.free[network.movement(next)] {
                self.roads.take(&network, next, self.is_long(slot));
            }
            self.fleet.s[i] -= length;
            self.roads.enter(&mut self.fleet, next, slot);
            return true;
        }
        let movement = network.movement(link);
        let to = network.to[movement];
        self.roads.queue[link as usize].pop_front();
        if !network.free[movement] {
            self.roads.promised[to as usize] -= self.room(slot);
        }
        self.fleet.behind[i] = link;
        self.roads.leaves(&network, &self.fleet, link, slot);
        self.fleet.go[i] = Go::No;
        self.fleet.leg[i] += 1;
        self.fleet.s[i] -= length;
        let left = self.drivers[self.fleet.class[i] as usize].length - self.fleet.s[i];
        self.roads.covers.push((slot, link, self.fleet.way[i] + left + network.clear[movement]));
        self.roads.enter(&mut self.fleet, to, slot);
        let users = self.classes[self.fleet.class[i] as usize].users;
        self.fleet.next[i] = self.choose(to, &self.routes[i], self.fleet.leg[i] as usize, users);
        true
    }

    /// Frees junctions and lanes that vehicles have left, and looks after those who stand for long.
    fn clear(&mut self) {
        let network = self.network.clone();
        let mut covers = std::mem::take(&mut self.roads.covers);
        covers.retain(|(slot, movement, until)| {
            let covered = self.fleet.way[*slot as usize] < *until;
            if !covered {
                self.roads.give(&network, *movement, is_long(self.length(*slot)));
            }
            covered
        });
        self.roads.covers = covers;
        for slot in 0..self.fleet.s.len() as u32 {
            let i = slot as usize;
            if self.fleet.trip[i] == NONE {
                continue;
            }
            if self.fleet.beside[i] != NONE && self.fleet.aside[i].abs() < crate::change::BESIDE {
                self.stop_leaving(slot);
            }
            let stood = self.fleet.stood[i];
            if stood >= WRONG && self.reroutes(slot) {
                continue;
            }
            if stood >= STUCK && stood < STUCK + self.dt {
                let reason = self.reason(slot);
                self.events.push(TrafficEvent::Stuck { vehicle: VehicleId(self.fleet.trip[i]), reason });
            }
        }
    }
}
