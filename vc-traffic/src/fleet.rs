//! The vehicles on the roads, as one list for each of their numbers.

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

impl Fleet {
    /// A slot for a vehicle.
    pub(crate) fn add(&mut self, trip: u32, class: u8, share: f32) -> u32 {
        let slot = self.free.pop().unwrap_or_else(|| {
            let slot = self.s.len() as u32;
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
            for list in
                [&mut self.link, &mut self.leg, &mut self.next, &mut self.behind, &mut self.beside, &mut self.trip]
            {
                list.push(NONE);
            }
            self.class.push(0);
            self.go.push(Go::No);
            slot
        });
        let i = slot as usize;
        (self.v[i], self.acceleration[i], self.aside[i], self.stood[i], self.way[i]) = (0.0, 0.0, 0.0, 0.0, 0.0);
        (self.behind[i], self.beside[i], self.next[i], self.leg[i]) = (NONE, NONE, NONE, 0);
        (self.trip[i], self.class[i], self.share[i], self.go[i]) = (trip, class, share, Go::No);
        slot
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
