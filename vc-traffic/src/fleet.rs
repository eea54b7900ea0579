//! The vehicles on the roads, as one list for each of their numbers.

use crate::bytes::Writer;
use crate::network::NONE;

/// Whether a vehicle may go over the junction ahead.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Go {
    /// It stops at the line.
    No,
    /// As far as the place where it waits within the junction.
    Inside,
    /// All of the way.
    Over,
}

/// All vehicles by slot. A slot is used again when its vehicle has arrived.
#[derive(Debug, Clone, Default)]
pub(crate) struct Fleet {
    /// The station of its front on its link, speed, acceleration and offset to the left of its lane's middle; metres, seconds.
    pub(crate) s: Vec<f32>,
    pub(crate) v: Vec<f32>,
    pub(crate) acceleration: Vec<f32>,
    pub(crate) aside: Vec<f32>,
    /// The desired speed as a share of the limit.
    pub(crate) share: Vec<f32>,
    pub(crate) class: Vec<u8>,
    /// The link on which its front is.
    pub(crate) link: Vec<u32>,
    /// The position in its route, and the movement at the end of its lane; `NONE` in a lane that does not lead there.
    pub(crate) leg: Vec<u32>,
    pub(crate) next: Vec<u32>,
    pub(crate) go: Vec<Go>,
    /// For how long it has stood, seconds.
    pub(crate) stood: Vec<f32>,
    /// The movement by which it came to its lane, and the lane that it is leaving sideways.
    pub(crate) behind: Vec<u32>,
    pub(crate) beside: Vec<u32>,
    pub(crate) trip: Vec<u32>,
    /// When it set out, seconds, and its way since, metres.
    pub(crate) since: Vec<f32>,
    pub(crate) way: Vec<f32>,
    free: Vec<u32>,
}

/// A vehicle as it is in a slot.
#[derive(Debug, Clone)]
pub(crate) struct Vehicle {
    pub(crate) s: f32,
    pub(crate) v: f32,
    acceleration: f32,
    aside: f32,
    share: f32,
    pub(crate) class: u8,
    pub(crate) link: u32,
    leg: u32,
    pub(crate) next: u32,
    pub(crate) go: Go,
    stood: f32,
    pub(crate) behind: u32,
    pub(crate) beside: u32,
    trip: u32,
    since: f32,
    pub(crate) way: f32,
}

impl Fleet {
    /// The vehicle in a slot.
    pub(crate) fn vehicle(&self, slot: u32) -> Vehicle {
        let i = slot as usize;
        Vehicle {
            s: self.s[i],
            v: self.v[i],
            acceleration: self.acceleration[i],
            aside: self.aside[i],
            share: self.share[i],
            class: self.class[i],
            link: self.link[i],
            leg: self.leg[i],
            next: self.next[i],
            go: self.go[i],
            stood: self.stood[i],
            behind: self.behind[i],
            beside: self.beside[i],
            trip: self.trip[i],
            since: self.since[i],
            way: self.way[i],
        }
    }

    /// Puts a vehicle into a slot.
    pub(crate) fn put(&mut self, of: &Vehicle) -> u32 {
        let slot = self.add(of.trip, of.class, of.share);
        let i = slot as usize;
        (self.s[i], self.v[i], self.acceleration[i], self.aside[i]) = (of.s, of.v, of.acceleration, of.aside);
        (self.link[i], self.leg[i], self.next[i], self.go[i]) = (of.link, of.leg, of.next, of.go);
        (self.stood[i], self.behind[i], self.beside[i]) = (of.stood, of.behind, of.beside);
        (self.since[i], self.way[i]) = (of.since, of.way);
        slot
    }

    /// A slot for a vehicle.
    pub(crate) fn add(&mut self, trip: u32, class: u8, share: f32) -> u32 {
        let slot = self.free.pop().unwrap_or_else(|| {
            self.push_slot();
            self.s.len() as u32 - 1
        });
        let i = slot as usize;
        (self.v[i], self.acceleration[i], self.aside[i], self.stood[i], self.way[i]) = (0.0, 0.0, 0.0, 0.0, 0.0);
        (self.behind[i], self.beside[i], self.next[i], self.leg[i]) = (NONE, NONE, NONE, 0);
        (self.trip[i], self.class[i], self.share[i], self.go[i]) = (trip, class, share, Go::No);
        slot
    }

    /// One more slot.
    pub(crate) fn push_slot(&mut self) {
        for list in [
            &mut self.s,
            &mut self.v,
            &mut self.acceleration,
            &mut self.aside,
            &mut self.share,
            &mut self.stood,
            &mut self.since,
            &mut self.way,
        ] {
            list.push(0.0);
        }
        for list in [&mut self.link, &mut self.leg, &mut self.next, &mut self.behind, &mut self.beside, &mut self.trip]
        {
            list.push(NONE);
        }
        self.class.push(0);
        self.go.push(Go::No);
    }

    /// Sets the slots without vehicles, in the order in which they came free; false if they are not these.
    pub(crate) fn set_free(&mut self, free: Vec<u32>) -> bool {
        let mut sorted = free.clone();
        sorted.sort_unstable();
        self.free = free;
        let empty = (0..self.s.len() as u32).filter(|slot| self.trip[*slot as usize] == NONE);
        empty.eq(sorted)
    }

    /// Writes all vehicles with their routes.
    pub(crate) fn save(&self, to: &mut Writer, routes: &[Vec<u32>]) {
        to.list(0..self.s.len(), |to, i| {
            to.word(self.trip[i]);
            if self.trip[i] == NONE {
                return;
            }
            to.reals([self.s[i], self.v[i], self.acceleration[i], self.aside[i]]);
            to.reals([self.share[i], self.stood[i], self.since[i], self.way[i]]);
            [self.link[i], self.next[i], self.behind[i], self.beside[i]].into_iter().for_each(|link| to.word(link));
            to.word(self.go[i] as u32);
            to.word(self.leg[i]);
            to.list(routes[i].iter(), |to, side| to.word(*side));
        });
        to.list(self.free.iter(), |to, slot| to.word(*slot));
    }

    /// Frees a slot.
    pub(crate) fn remove(&mut self, slot: u32) {
        self.trip[slot as usize] = NONE;
        self.free.push(slot);
    }

    /// The number of vehicles.
    pub(crate) fn len(&self) -> usize {
        self.s.len() - self.free.len()
    }
}
