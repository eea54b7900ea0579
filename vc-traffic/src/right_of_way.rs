//! Right of way at junctions: lights, signs, who gives way to whom, and whether there is room behind.

use std::cmp::Ordering;

use vc_map::Light;

use crate::Traffic;
use crate::fleet::Go;
use crate::network::NONE;
use crate::swept::is_long;

/// A vehicle that comes to a line asks to go this much before it would begin to brake, metres.
const AHEAD: f32 = 6.0;
/// The deceleration with which one stops at yellow if that is enough, metres per second squared.
const AT_YELLOW: f32 = 3.0;
/// One that has waited this long is let go first, and one that has waited that long at equal rights goes, seconds.
const PATIENCE: f32 = 60.0;
const EQUAL: f32 = 4.0;
/// One that has yielded to people for so long goes before the next of them, seconds. One that may go yields to them if it stops within
/// the way for comfort, and this time to react, seconds.
const YIELDS: f32 = 30.0;
const REACTS: f32 = 0.5;
/// A vehicle that goes at this speed behind a junction makes room, metres per second, for so many seconds.
const MOVING: f32 = 3.0;
const MAKES_ROOM: f32 = 2.5;
/// A vehicle this slow has stopped, metres per second, at a line that is this near, metres.
pub(crate) const STANDING: f32 = 0.2;
const AT_LINE: f32 = 6.0;

/// Somebody who asks to go.
struct Candidate {
    slot: u32,
    link: u32,
    row: usize,
    /// Whether it gives way to others in its green, or at all where there are no lights.
    yields: bool,
    /// The time to the line, seconds.
    away: f32,
    stood: f32,
}

impl Candidate {
    /// Those who wait for too long come first, then those who do not give way, then those who are nearer.
    fn order(&self, other: &Self) -> Ordering {
        let late = |candidate: &Self| candidate.stood > PATIENCE;
        late(other)
            .cmp(&late(self))
            .then(self.yields.cmp(&other.yields))
            .then(self.away.total_cmp(&other.away))
            .then(self.link.cmp(&other.link))
    }
}

impl Traffic {
    /// Decides for each junction who may go. Junctions do not depend on each other.
    pub(crate) fn right_of_way(&mut self) {
        let network = self.network.clone();
        self.foot.late.fill(false);
        let mut asking = Vec::new();
        for junction in 0..network.rows.len() {
            if network.ways_in[junction].is_empty() {
                continue;
            }
            self.finish(junction);
            asking.clear();
            for lane in &network.ways_in[junction] {
                asking.extend(self.asks(*lane));
            }
            if asking.is_empty() {
                continue;
            }
            asking.sort_by(Candidate::order);
            let mut kept: Vec<(usize, bool)> = Vec::new();
            for position in 0..asking.len() {
                let given = self.decide(junction, &asking, position, &kept);
                if !given && asking[position].stood > PATIENCE {
                    kept.push((asking[position].row, self.is_long(asking[position].slot)));
                }
            }
        }
    }

    /// Lets those go on who wait within a junction, as soon as nobody is in their way.
    fn finish(&mut self, junction: usize) {
        if self.roads.inside[junction] == 0 {
            return;
        }
        let network = self.network.clone();
        for link in &network.rows[junction] {
            let movement = network.movement(*link);
            if self.roads.waiting[movement] == 0 {
                continue;
            }
            let lane = network.from[movement];
            let on = self.roads.queue[*link as usize].front().copied();
            let waits = |slot: &u32| {
                let i = *slot as usize;
                self.fleet.go[i] == Go::Inside && (self.fleet.link[i] == *link || self.fleet.next[i] == *link)
            };
            let before = || self.roads.queue[lane as usize].iter().copied().find(waits);
            let Some(slot) = on.filter(waits).or_else(before) else { continue };
            let long = self.is_long(slot);
            if self.is_clear(junction, network.row[movement] as usize, *link, long) {
                self.fleet.go[slot as usize] = Go::Over;
                self.roads.wait(&network, movement, false);
                self.roads.take(&network, *link, long);
            }
        }
    }

    /// The first on a lane before its line, if it comes to that and has to ask. One that may go and can still stop loses that at red.
    fn asks(&mut self, lane: u32) -> Option<Candidate> {
        // Those beyond the line go over the junction already.
        let stop = self.network.stop[lane as usize];
        let gone = |slot: &u32| self.fleet.s[*slot as usize] > stop && self.fleet.go[*slot as usize] != Go::No;
        let slot = self.roads.queue[lane as usize].iter().copied().find(|slot| !gone(slot))?;
        let i = slot as usize;
        // Nobody goes whom somebody from the same lane keeps up who waits within the junction.
        if self.is_kept_up(lane, slot) {
            if self.fleet.s[i] <= stop {
                self.refuse(slot);
            }
            return None;
        }
        let network = &self.network;
        let link = self.fleet.next[i];
        if link == NONE || network.free[network.movement(link)] {
            return None;
        }
        let movement = network.movement(link);
        let light = self.light(movement);
        let v = self.fleet.v[i];
        let away = network.stop[lane as usize] - self.fleet.s[i];
        let stops = matches!(light, Some(Light::Red | Light::Yellow)) && away > v * v / (2.0 * AT_YELLOW);
        if self.fleet.go[i] != Go::No {
            let row = network.row[movement] as usize;
            let driver = &self.drivers[self.fleet.class[i] as usize];
            let can_yield = away > driver.stopping(v) + v * REACTS;
            let yields = can_yield && self.is_claimed(network.junction[movement] as usize, row);
            if (stops || yields) && away > 0.0 {
                self.refuse(slot);
            }
            return None;
        }
        let driver = &self.drivers[self.fleet.class[i] as usize];
        // Beside its lane nobody goes over a junction.
        let aside = self.fleet.aside[i].abs() > crate::change::BESIDE;
        if stops || light == Some(Light::Red) || aside || away > driver.sight(v) + AHEAD {
            return None;
        }
        if network.stops[lane as usize] && light.is_none() && (v > STANDING || away > AT_LINE) {
            return None;
        }
        // Nobody waits on a junction for who crosses beyond.
        if self.leaves_to_people(slot, link) {
            return None;
        }
        let row = network.row[movement] as usize;
        let yields = match light {
            Some(light) => light == Light::GreenYield,
            None => !network.map.movements()[movement].yields.is_empty(),
        };
        Some(Candidate { slot, link, row, yields, away: away.max(0.0) / v.max(1.0), stood: self.fleet.stood[i] })
    }

    /// Whether somebody who waits within the junction, or is to, stands before the first of a lane.
    fn is_kept_up(&self, lane: u32, slot: u32) -> bool {
        let (network, fleet) = (&self.network, &self.fleet);
        let mut ahead = self.roads.queue[lane as usize].iter().take_while(|other| **other != slot);
        if ahead.any(|other| fleet.go[*other as usize] == Go::Inside) {
            return true;
        }
        let last = self.roads.last[lane as usize];
        if last == NONE || fleet.trip[last as usize] == NONE || fleet.go[last as usize] != Go::Inside {
            return false;
        }
        let i = last as usize;
        let on = !network.is_lane(fleet.link[i]) && network.from[network.movement(fleet.link[i])] == lane;
        on && fleet.s[i] - self.drivers[fleet.class[i] as usize].length <= crate::drive::PARTS
    }

    /// Takes a promise back.
    pub(crate) fn refuse(&mut self, slot: u32) {
        let i = slot as usize;
        let network = self.network.clone();
        let movement = network.movement(self.fleet.next[i]);
        match self.fleet.go[i] {
            Go::No => return,
            Go::Inside => self.roads.wait(&network, movement, false),
            Go::Over => self.roads.give(&network, self.fleet.next[i], self.is_long(slot)),
        }
        self.fleet.go[i] = Go::No;
        self.roads.promised[network.to[movement] as usize] -= self.room(slot);
    }

    /// Lets one who asks go, or not.
    fn decide(&mut self, junction: usize, asking: &[Candidate], position: usize, kept: &[(usize, bool)]) -> bool {
        let network = self.network.clone();
        let one = &asking[position];
        let movement = network.movement(one.link);
        let table = &network.map.junctions()[junction].conflicts;
        // None of those who have waited for too long keeps another one from going.
        let long = self.is_long(one.slot);
        let meets = |(row, other): &(usize, bool)| {
            table.has(one.row, *row)
                || ((long || *other) && self.swept.as_ref().is_some_and(|swept| swept.meet(junction, one.row, *row)))
        };
        let waits = one.stood <= PATIENCE && kept.iter().any(meets);
        if waits || !self.has_room(one.slot, movement) {
            return false;
        }
        let lit = network.map.junctions()[junction].signal.is_some();
        if !lit && self.gives_way(junction, asking, position) {
            return false;
        }
        if one.stood > YIELDS {
            self.keep_clear(junction, one.row);
        } else if self.is_claimed(junction, one.row) {
            return false;
        }
        let go = if self.is_clear(junction, one.row, one.link, long) {
            self.roads.take(&network, one.link, long);
            Go::Over
        } else if self.can_wait_inside(one) {
            self.roads.wait(&network, movement, true);
            Go::Inside
        } else {
            return false;
        };
        self.fleet.go[one.slot as usize] = go;
        self.roads.promised[network.to[movement] as usize] += self.room(one.slot);
        true
    }

    /// Whether somebody gives way at a junction without lights to another who comes to it, too.
    fn gives_way(&self, junction: usize, asking: &[Candidate], position: usize) -> bool {
        let one = &asking[position];
        let yields = &self.network.map.movements()[self.network.movement(one.link)].yields;
        // Nobody waits for who cannot go.
        let could = |other: &Candidate| {
            self.fleet.go[other.slot as usize] == Go::No
                && self.has_room(other.slot, self.network.movement(other.link))
                && self.is_clear(junction, other.row, other.link, self.is_long(other.slot))
        };
        let others = asking.iter().enumerate().filter(|(other, _)| *other != position).map(|(_, other)| other);
        others.filter(|other| yields.contains(&(other.row as u32)) && could(other)).any(|other| {
            // Where all wait for each other the one that has waited longest goes, and of several the first.
            let both = one.stood > EQUAL && other.stood > 0.0;
            let before = one.stood > other.stood + 0.5 || (one.stood > 2.0 * EQUAL && one.link < other.link);
            !(both && before)
        })
    }

    /// Whether a vehicle is so long that it cuts corners.
    pub(crate) fn is_long(&self, slot: u32) -> bool {
        is_long(self.length(slot))
    }

    /// Whether nobody is in the way of a movement, of a long vehicle or another.
    pub(crate) fn is_clear(&self, junction: usize, row: usize, link: u32, long: bool) -> bool {
        let network = &self.network;
        let table = &network.map.junctions()[junction].conflicts;
        if !table.free(row, &self.roads.busy[junction]) {
            return false;
        }
        let others = if long { &self.roads.busy } else { &self.roads.long_on };
        let swept = self.swept.as_ref().is_some_and(|swept| !swept.is_free(junction, row, &others[junction]));
        // A long one waits for all who are within the junction.
        if swept || (long && self.roads.inside[junction] > u16::from(self.waits_on(link))) {
            return false;
        }
        if self.roads.inside[junction] == 0 {
            return true;
        }
        // Those who wait within the junction are in the way of those who pass the place.
        network.rows[junction].iter().enumerate().all(|(other, theirs)| {
            let movement = network.movement(*theirs);
            *theirs == link
                || self.roads.waiting[movement] == 0
                || !table.has(row, other)
                || network.beyond[movement].get(row).copied().unwrap_or(false)
        })
    }

    /// Whether one can go as far as the place within the junction where one waits for others: all in the way are beyond it.
    fn can_wait_inside(&self, one: &Candidate) -> bool {
        let network = &self.network;
        let movement = network.movement(one.link);
        if self.is_long(one.slot) {
            return false;
        }
        if network.hold[movement] == 0.0
            || self.roads.waiting[movement] > 0
            || self.roads.taken[movement] > 0
            || !self.roads.queue[one.link as usize].is_empty()
        {
            return false;
        }
        self.can_wait_on(one.link)
    }

    /// Whether somebody waits on a movement within a junction.
    fn waits_on(&self, link: u32) -> bool {
        link != NONE && self.roads.waiting[self.network.movement(link)] > 0
    }

    /// Whether nobody is in the way of who waits on a movement within a junction.
    pub(crate) fn can_wait_on(&self, link: u32) -> bool {
        let network = &self.network;
        let movement = network.movement(link);
        let (junction, own) = (network.junction[movement] as usize, network.row[movement] as usize);
        let table = &network.map.junctions()[junction].conflicts;
        let there = |row: usize| {
            let waits = |link: &u32| self.roads.waiting[network.movement(*link)] > 0;
            self.roads.is_busy(junction, row) || network.rows[junction].get(row).is_some_and(waits)
        };
        let beyond = |row: usize| network.beyond[movement].get(row).copied().unwrap_or(false);
        (0..table.size()).all(|row| !table.has(own, row) || beyond(row) || !there(row))
    }

    /// The length of a vehicle, metres.
    pub(crate) fn length(&self, slot: u32) -> f32 {
        self.drivers[self.fleet.class[slot as usize] as usize].length
    }

    /// The room that a vehicle takes behind a junction, centimetres.
    pub(crate) fn room(&self, slot: u32) -> u32 {
        let driver = &self.drivers[self.fleet.class[slot as usize] as usize];
        ((driver.length + driver.standing_gap) * 100.0).ceil() as u32
    }

    /// Whether a vehicle finds room behind a junction.
    pub(crate) fn has_room(&self, slot: u32, movement: usize) -> bool {
        let network = &self.network;
        let to = network.to[movement];
        let [needs, promised] = [self.room(slot), self.roads.promised[to as usize]].map(|room| room as f32 / 100.0);
        let length = network.length[to as usize];
        // Where there is room for that nobody stands on a crossing.
        let needs = needs + if length > needs + network.clear[movement] { network.clear[movement] } else { 0.0 };
        let tail = self.roads.tail(network, &self.fleet, &self.drivers, to);
        let Some((rear, speed)) = tail else { return promised == 0.0 || length - promised >= needs };
        let moves = if speed > MOVING { speed * MAKES_ROOM } else { 0.0 };
        rear + moves - promised >= needs
    }
}
