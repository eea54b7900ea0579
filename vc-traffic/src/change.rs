//! Lane changes: MOBIL (Kesting, Treiber and Helbing, Transportation Research Record 1999, 2007), and those that a way needs.

use crate::Traffic;
use crate::fleet::Go;
use crate::network::NONE;
use crate::trip::{TrafficEvent, VehicleId};

/// A vehicle that is nearer to the middle of its lane is in it, metres.
pub(crate) const BESIDE: f32 = 0.3;
/// Everybody looks for a better lane once in so many seconds.
const EACH: f32 = 1.0;
/// The share of others in a decision, the least gain, and the hardest braking that one brings upon others; metres, seconds.
const POLITE: f32 = 0.3;
const GAIN: f32 = 0.3;
const SAFE: f32 = 3.0;
/// Before a turn that needs another lane others brake so hard at last, and it is looked for from this distance on.
const URGENT: f32 = 5.0;
const FAR: f32 = 250.0;
/// No change begins nearer to the end of a lane, or to its start, metres.
const END: f32 = 6.0;
const START: f32 = 12.0;
/// One that has stood for so long in a lane from which no way leads to its destination goes where that leads, seconds.
const GIVES_UP: f32 = 60.0;
/// The least gap, metres; who is slower than this, metres per second, can stop within it.
pub(crate) const GAP: f32 = 1.0;
const CRAWLING: f32 = 2.0;

impl Traffic {
    pub(crate) fn change_lanes(&mut self) {
        let network = self.network.clone();
        let every = (EACH / self.dt).round().max(1.0) as u64;
        for slot in 0..self.fleet.s.len() as u32 {
            let i = slot as usize;
            if !(self.step + u64::from(slot)).is_multiple_of(every) || self.fleet.trip[i] == NONE {
                continue;
            }
            let link = self.fleet.link[i];
            let settled = self.fleet.beside[i] == NONE && self.fleet.aside[i] == 0.0 && self.fleet.go[i] == Go::No;
            if !network.is_lane(link) || !settled {
                continue;
            }
            self.change(slot, link);
        }
    }

    fn change(&mut self, slot: u32, lane: u32) {
        let network = self.network.clone();
        let i = slot as usize;
        let last = self.fleet.leg[i] as usize + 1 >= self.routes[i].len();
        let away = network.length[lane as usize] - self.fleet.s[i];
        let needed = self.fleet.next[i] == NONE && !last;
        if away < END && !needed {
            return;
        }
        if needed {
            if away < FAR
                && let Some(target) = self.way_to_lane(slot, lane)
            {
                self.wanting.retain(|(other, _)| *other != slot);
                if !self.move_over(slot, lane, target, true) {
                    self.wanting.push((slot, target));
                }
            }
            return;
        }
        let users = self.classes[self.fleet.class[i] as usize].users;
        let mut best: Option<(f32, u32)> = None;
        for target in [network.inner[lane as usize], network.outer[lane as usize]] {
            if target == NONE || !network.users[target as usize].has(users) {
                continue;
            }
            let leads = last || self.choose(target, &self.routes[i], self.fleet.leg[i] as usize, users) != NONE;
            if !leads {
                continue;
            }
            if let Some(gain) = self.gain(slot, lane, target, SAFE).filter(|gain| *gain > GAIN)
                && best.is_none_or(|(most, _)| gain > most)
            {
                best = Some((gain, target));
            }
        }
        if let Some((_, target)) = best {
            self.move_over(slot, lane, target, false);
        }
    }

    /// The lane beside it that leads to the nearest lane of its way.
    fn way_to_lane(&self, slot: u32, lane: u32) -> Option<u32> {
        let network = &self.network;
        let i = slot as usize;
        let users = self.classes[self.fleet.class[i] as usize].users;
        let leads = |lane: u32| self.choose(lane, &self.routes[i], self.fleet.leg[i] as usize, users) != NONE;
        let sides = [&network.inner, &network.outer].map(|beside| {
            let mut at = beside[lane as usize];
            let first = at;
            let mut steps = 1;
            while at != NONE && network.users[at as usize].has(users) {
                if leads(at) {
                    return Some((steps, first));
                }
                at = beside[at as usize];
                steps += 1;
            }
            None
        });
        sides.into_iter().flatten().min_by_key(|(steps, _)| *steps).map(|(_, first)| first)
    }

    /// The acceleration that a change gains, others included; `None` if it is not safe.
    fn gain(&self, slot: u32, lane: u32, target: u32, safe: f32) -> Option<f32> {
        let (network, fleet) = (&self.network, &self.fleet);
        let i = slot as usize;
        let driver = &self.drivers[fleet.class[i] as usize];
        let (v, station) = (fleet.v[i], network.across(fleet.s[i], lane, target));
        let rear = station - driver.length;
        let stops = station + driver.stopping(v) + driver.standing_gap;
        if rear < START || !self.is_unblocked(target, rear, stops) {
            return None;
        }
        let queue = &self.roads.queue[target as usize];
        let place = self.roads.position(fleet, target, station);
        let length = |j: usize| self.drivers[fleet.class[j] as usize].length;
        let wish = |j: usize, link: u32| {
            let class = fleet.class[j] as usize;
            let desired = (network.limit[link as usize] * fleet.share[j]).min(self.classes[class].top_speed);
            self.drivers[class].free(fleet.v[j], desired)
        };
        for other in &self.roads.leaving[target as usize] {
            let j = *other as usize;
            let at = network.across(fleet.s[j], fleet.link[j], target);
            if at + 2.0 * GAP > rear && at - length(j) < station + 2.0 * GAP {
                return None;
            }
        }
        let mut own = wish(i, target);
        if let Some(before) = place.checked_sub(1).and_then(|place| queue.get(place)) {
            let j = *before as usize;
            let gap = fleet.s[j] - length(j) - station;
            if gap < GAP {
                return None;
            }
            own -= driver.behind(v, gap, v - fleet.v[j]);
        }
        let mut others = 0.0;
        if let Some(after) = queue.get(place) {
            let j = *after as usize;
            let gap = rear - fleet.s[j];
            if gap < GAP {
                return None;
            }
            let theirs =
                wish(j, target) - self.drivers[fleet.class[j] as usize].behind(fleet.v[j], gap, fleet.v[j] - v);
            if theirs < -safe && fleet.v[j] > CRAWLING {
                return None;
            }
            others = theirs - fleet.acceleration[j];
        } else {
            // Somebody may come over the junction behind.
            let coming = network.before[target as usize].iter().filter_map(|link| {
                let j = *self.roads.queue[*link as usize].front()? as usize;
                Some((j, rear + network.length[*link as usize] - fleet.s[j]))
            });
            for (j, gap) in coming {
                let theirs =
                    wish(j, target) - self.drivers[fleet.class[j] as usize].behind(fleet.v[j], gap, fleet.v[j] - v);
                if theirs < -safe && fleet.v[j] > CRAWLING {
                    return None;
                }
            }
            if self.roads.promised[target as usize] > 0 && rear < 3.0 * START {
                return None;
            }
        }
        (own >= -safe || v < CRAWLING).then(|| own - fleet.acceleration[i] + POLITE * others)
    }

    /// Changes to a lane beside, if that is safe.
    fn move_over(&mut self, slot: u32, lane: u32, target: u32, needed: bool) -> bool {
        let network = self.network.clone();
        let i = slot as usize;
        let away = network.length[lane as usize] - self.fleet.s[i];
        let safe = if needed { SAFE + (URGENT - SAFE) * (1.0 - away / FAR).clamp(0.0, 1.0) } else { SAFE };
        if self.gain(slot, lane, target, safe).is_none() {
            return false;
        }
        let left = (network.inner[lane as usize] == target) == (network.map.side() == vc_map::DrivingSide::Right);
        let width = |lane: u32| network.map.lanes()[lane as usize].width as f32;
        let metres = (width(lane) + width(target)) / 2.0;
        self.roads.leave(lane, slot);
        self.fleet.s[i] = network.across(self.fleet.s[i], lane, target);
        self.fleet.aside[i] = if left { -metres } else { metres };
        self.fleet.beside[i] = lane;
        self.roads.leaving[lane as usize].push(slot);
        self.roads.enter(&mut self.fleet, target, slot);
        // Whoever was to go over the junction next is behind now.
        let behind = self.roads.queue[target as usize].iter().copied().skip_while(|other| *other != slot).nth(1);
        behind.into_iter().for_each(|other| self.refuse(other));
        let users = self.classes[self.fleet.class[i] as usize].users;
        self.fleet.next[i] = self.choose(target, &self.routes[i], self.fleet.leg[i] as usize, users);
        true
    }

    /// The movement by which a route goes on from a lane; of several the one whose lane leads on, too.
    pub(crate) fn choose(&self, lane: u32, route: &[u32], leg: usize, users: vc_map::Users) -> u32 {
        let network = &self.network;
        let Some(side) = route.get(leg + 1) else { return NONE };
        let mut found = NONE;
        for link in &network.next[lane as usize] {
            let to = network.to[network.movement(*link)];
            if network.side[to as usize] != *side || !network.users[*link as usize].has(users) {
                continue;
            }
            let leads = route.get(leg + 2).is_none_or(|after| network.towards(to, *after, users).is_some());
            if leads {
                return *link;
            }
            if found == NONE {
                found = *link;
            }
        }
        found
    }

    /// Lets somebody who stands at the end of a lane that does not lead where it wants go where the lane leads.
    pub(crate) fn reroutes(&mut self, slot: u32) -> bool {
        let network = self.network.clone();
        let i = slot as usize;
        let lane = self.fleet.link[i];
        let last = self.fleet.leg[i] as usize + 1 >= self.routes[i].len();
        if !network.is_lane(lane) || self.fleet.next[i] != NONE || last {
            return false;
        }
        let users = self.classes[self.fleet.class[i] as usize].users;
        let trip = self.trips[self.fleet.trip[i] as usize];
        let ways = network.next[lane as usize].iter().copied().filter(|link| network.users[*link as usize].has(users));
        let ways: Vec<u32> = ways.collect();
        let on = |link: u32| network.to[network.movement(link)];
        let found = ways.iter().find_map(|link| {
            let to = on(*link);
            Some((*link, self.way(to, network.length[to as usize] * 0.5, &trip.to)?))
        });
        // Where no way leads there it goes where the lane leads at last.
        if found.is_none() && self.fleet.stood[i] < GIVES_UP {
            return false;
        }
        let found = found.or_else(|| ways.first().map(|link| (*link, vec![network.side[on(*link) as usize]])));
        if let Some((link, mut route)) = found {
            let gone = self.fleet.leg[i] as usize + 1;
            self.routes[i].truncate(gone);
            self.routes[i].append(&mut route);
            self.fleet.next[i] = link;
            self.events.push(TrafficEvent::Rerouted { vehicle: VehicleId(self.fleet.trip[i]) });
            return true;
        }
        // A dead end.
        self.routes[i].truncate(self.fleet.leg[i] as usize + 1);
        true
    }
}
