//! Accelerations: everybody by those ahead, as they were at the end of the last step.

use crate::Traffic;
use crate::fleet::Go;
use crate::follow::HARDEST;
use crate::network::NONE;

/// Nobody looks further than this many links.
const LINKS: usize = 8;
/// A vehicle that turns off is in the way of the next as long as its rear is so near to where the ways part, metres.
pub(crate) const PARTS: f32 = 5.0;
/// Vehicles begin to slow down for a turn when that takes this deceleration, metres per second squared.
const FOR_TURN: f32 = 1.05;
/// One looks this much further than it has to, metres.
const FURTHER: f32 = 10.0;
/// Those who have to change lanes stop so far before the line, metres; those who let them in brake at most so hard, metres per second squared.
const TO_CHANGE: f32 = 15.0;
const COURTEOUS: f32 = 2.0;

impl Traffic {
    pub(crate) fn accelerate(&mut self) {
        let network = self.network.clone();
        let drivers = self.drivers.clone();
        let mut acceleration = std::mem::take(&mut self.fleet.acceleration);
        for link in self.roads.in_use() {
            let link = link as usize;
            let queue = &self.roads.queue[link];
            let mut ahead: Option<(f32, f32)> = None;
            let mut front = f32::NEG_INFINITY;
            let blocked = !self.blocks_on(link as u32).is_empty();
            for slot in queue {
                let i = *slot as usize;
                let (s, v) = (self.fleet.s[i], self.fleet.v[i]);
                let class = self.fleet.class[i] as usize;
                let driver = &drivers[class];
                let desired = (network.limit[link] * self.fleet.share[i]).min(self.classes[class].top_speed);
                let held = match ahead {
                    Some((rear, speed)) => driver.behind(v, rear - s, v - speed),
                    None => self.held_back(*slot, link as u32),
                };
                // Whoever is ahead may be over the line.
                let stop = network.stop.get(link).copied().unwrap_or(f32::INFINITY);
                let first = front > stop && s <= stop;
                let held = if first { held.max(self.held_back(*slot, link as u32)) } else { held };
                let held = if blocked { held.max(self.held_by_block(*slot, link as u32, s)) } else { held };
                front = s;
                acceleration[i] = (driver.free(v, desired) - held).max(-HARDEST);
                ahead = Some((s - driver.length, v));
            }
        }
        self.fleet.acceleration = acceleration;
        self.let_in();
        self.beside();
    }

    /// Those behind somebody who has to change to their lane make room.
    fn let_in(&mut self) {
        let network = self.network.clone();
        for (slot, target) in std::mem::take(&mut self.wanting) {
            let i = slot as usize;
            let lane = self.fleet.link[i];
            let gone = self.fleet.trip[i] == NONE
                || !network.is_lane(lane)
                || network.side[lane as usize] != network.side[target as usize];
            if gone || self.fleet.next[i] != NONE || self.fleet.beside[i] != NONE {
                continue;
            }
            self.wanting.push((slot, target));
            let station = network.across(self.fleet.s[i], lane, target);
            let rear = station - self.drivers[self.fleet.class[i] as usize].length;
            let place = self.roads.position(&self.fleet, target, rear);
            // One that is too near already goes on.
            let behind = self.roads.queue[target as usize].iter().skip(place);
            let mut behind =
                behind.skip_while(|other| rear - self.fleet.s[**other as usize] < crate::change::GAP + 0.1);
            let Some(other) = behind.next() else { continue };
            let j = *other as usize;
            let (class, v) = (self.fleet.class[j] as usize, self.fleet.v[j]);
            let desired = (network.limit[target as usize] * self.fleet.share[j]).min(self.classes[class].top_speed);
            let driver = &self.drivers[class];
            let held = driver.behind(v, rear - self.fleet.s[j], v - self.fleet.v[i]);
            let own = &mut self.fleet.acceleration[j];
            *own = own.min((driver.free(v, desired) - held).max(-COURTEOUS));
        }
    }

    /// By how much the first on a link is held back by what is ahead on its way, metres per second squared.
    fn held_back(&self, slot: u32, link: u32) -> f32 {
        let network = &self.network;
        let i = slot as usize;
        let v = self.fleet.v[i];
        let class = self.fleet.class[i] as usize;
        let (driver, users) = (&self.drivers[class], self.classes[class].users);
        let sight = driver.sight(v) + FURTHER;
        let mut held = 0.0_f32;
        let mut away = network.length[link as usize] - self.fleet.s[i];
        let mut leg = self.fleet.leg[i] as usize;
        let route = &self.routes[i];
        let mut lane = link;
        let mut first = true;
        if !network.is_lane(link) {
            let movement = network.movement(link);
            if self.fleet.go[i] == Go::Inside {
                return driver.behind(v, network.hold[movement] - self.fleet.s[i], v);
            }
            lane = network.to[movement];
            leg += 1;
            held = self.held_by_block(slot, lane, -away);
            if let Some((rear, speed)) = self.roads.tail(network, &self.fleet, &self.drivers, lane) {
                return held.max(driver.behind(v, away + rear, v - speed));
            }
            away += network.length[lane as usize];
            first = false;
        }
        for _ in 0..LINKS {
            if away > sight || leg + 1 >= route.len() {
                return held;
            }
            let next = if first { self.fleet.next[i] } else { self.choose(lane, route, leg, users) };
            let line = away - (network.length[lane as usize] - network.halt[lane as usize]);
            let aside = first && self.fleet.aside[i].abs() > crate::change::BESIDE;
            let goes = next != NONE
                && !aside
                && (network.free[network.movement(next)] || (first && self.fleet.go[i] != Go::No));
            if first {
                held = held.max(self.behind_who_turned_off(slot, lane, away));
            }
            if !goes {
                // One that has to change lanes keeps room to do so.
                let line = if first && next == NONE && line > TO_CHANGE { line - TO_CHANGE } else { line };
                return held.max(driver.behind(v, line.max(0.0) + driver.standing_gap, v));
            }
            let movement = network.movement(next);
            if first && self.fleet.go[i] == Go::Inside {
                held = held.max(driver.behind(v, away + network.hold[movement], v));
            }
            let turn = network.limit[next as usize] * self.fleet.share[i].min(1.0);
            if v > turn {
                let needed = (v * v - turn * turn) / (2.0 * away.max(0.5));
                if needed > FOR_TURN {
                    held = held.max(needed + driver.acceleration);
                }
            }
            held = held.max(self.held_by_block(slot, next, -away));
            if let Some((rear, speed)) = self.roads.tail(network, &self.fleet, &self.drivers, next) {
                return held.max(driver.behind(v, away + rear, v - speed));
            }
            away += network.length[next as usize];
            lane = network.to[movement];
            held = held.max(self.held_by_block(slot, lane, -away));
            if let Some((rear, speed)) = self.roads.tail(network, &self.fleet, &self.drivers, lane) {
                return held.max(driver.behind(v, away + rear, v - speed));
            }
            away += network.length[lane as usize];
            leg += 1;
            first = false;
        }
        held
    }

    /// By how much a block on a link ahead holds one back, metres per second squared; whose front is at a station of the link, or before it.
    fn held_by_block(&self, slot: u32, link: u32, station: f32) -> f32 {
        let (v, class) = (self.fleet.v[slot as usize], self.fleet.class[slot as usize] as usize);
        self.gap_to_block(slot, link, station).map_or(0.0, |gap| self.drivers[class].behind(v, gap, v))
    }

    /// By how much one is held back by who went before it from the same lane another way, and whose rear is still near.
    fn behind_who_turned_off(&self, slot: u32, lane: u32, away: f32) -> f32 {
        let last = self.roads.last[lane as usize];
        if last == NONE || last == slot || self.fleet.trip[last as usize] == NONE {
            return 0.0;
        }
        let Some(front) = self.beyond_end(last, lane) else { return 0.0 };
        let rear = front - self.length(last);
        if rear > PARTS {
            return 0.0;
        }
        let own = slot as usize;
        let driver = &self.drivers[self.fleet.class[own] as usize];
        driver.behind(self.fleet.v[own], away + rear, self.fleet.v[own] - self.fleet.v[last as usize])
    }

    /// How far beyond the end of a lane the front of a vehicle is that came from there, metres, as long as it is on the junction or just beyond.
    pub(crate) fn beyond_end(&self, slot: u32, lane: u32) -> Option<f32> {
        let network = &self.network;
        let (s, link, behind) =
            (self.fleet.s[slot as usize], self.fleet.link[slot as usize], self.fleet.behind[slot as usize]);
        let on = |movement: u32| {
            movement != NONE && !network.is_lane(movement) && network.from[network.movement(movement)] == lane
        };
        match () {
            () if on(link) => Some(s),
            () if on(behind) => Some(s + network.length[behind as usize]),
            () => None,
        }
    }

    /// A vehicle that changes lanes and those in the lane that it leaves heed each other until it has left.
    fn beside(&mut self) {
        let network = self.network.clone();
        for lane in 0..network.lanes as u32 {
            let leaving = &self.roads.leaving[lane as usize];
            if leaving.is_empty() {
                continue;
            }
            let station = |slot: u32| network.across(self.fleet.s[slot as usize], self.fleet.link[slot as usize], lane);
            let mut pairs: Vec<(u32, u32)> = Vec::new();
            for slot in leaving {
                let own = station(*slot);
                let place = self.roads.position(&self.fleet, lane, own);
                let queue = &self.roads.queue[lane as usize];
                pairs.extend(place.checked_sub(1).and_then(|place| queue.get(place)).map(|other| (*slot, *other)));
                pairs.extend(queue.get(place).map(|other| (*other, *slot)));
                // Those who leave it on its other side.
                let others = leaving.iter().filter(|other| *other != slot && station(**other) >= own);
                pairs.extend(others.map(|other| (*slot, *other)));
            }
            let held: Vec<(u32, f32)> = pairs.into_iter().map(|pair| self.held_by(pair, lane)).collect();
            for (slot, acceleration) in held {
                let own = &mut self.fleet.acceleration[slot as usize];
                *own = own.min(acceleration);
            }
        }
    }

    /// The acceleration of somebody behind another in a lane that one of them is leaving.
    fn held_by(&self, (behind, before): (u32, u32), lane: u32) -> (u32, f32) {
        let (network, fleet) = (&self.network, &self.fleet);
        let [b, f] = [behind, before].map(|slot| slot as usize);
        let at = |i: usize| network.across(fleet.s[i], fleet.link[i], lane);
        let driver = &self.drivers[fleet.class[b] as usize];
        let rear = at(f) - self.drivers[fleet.class[f] as usize].length;
        let held = driver.behind(fleet.v[b], rear - at(b), fleet.v[b] - fleet.v[f]);
        let class = fleet.class[b] as usize;
        let desired = (network.limit[fleet.link[b] as usize] * fleet.share[b]).min(self.classes[class].top_speed);
        (behind, (driver.free(fleet.v[b], desired) - held).max(-HARDEST))
    }
}
