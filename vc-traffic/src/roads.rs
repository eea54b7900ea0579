//! The state of links and junctions: who is on them, in order, and who may go.

use std::collections::VecDeque;

use crate::bytes::Writer;
use crate::fleet::Fleet;
use crate::follow::Driver;
use crate::network::{NONE, Network};

/// The end of a queue: the station of its last rear, metres, and its speed.
pub(crate) type Tail = (f32, f32);

/// Links and junctions as they are.
#[derive(Debug, Clone)]
pub(crate) struct Roads {
    /// The vehicles on each link, the foremost first.
    pub(crate) queue: Vec<VecDeque<u32>>,
    /// A bit for each link that may have vehicles.
    used: Vec<u64>,
    /// For each lane: those who are leaving it sideways.
    pub(crate) leaving: Vec<Vec<u32>>,
    /// For each lane: the last who went over the junction, and the room that is promised to those on their way to it, centimetres.
    pub(crate) last: Vec<u32>,
    pub(crate) promised: Vec<u32>,
    /// For each link: the last who left it at its end, with their trip and their way then, metres.
    pub(crate) left: Vec<(u32, u32, f32)>,
    /// For each movement: the number of those who may go or whose body is on it, and of those who wait on it.
    pub(crate) taken: Vec<u16>,
    pub(crate) waiting: Vec<u16>,
    /// For each junction: the rows of movements and crossings that are taken, as bits, and the number of those who wait within it.
    pub(crate) busy: Vec<Vec<u64>>,
    pub(crate) inside: Vec<u16>,
    /// For each movement the number of long ones among these, and for each junction the rows with such.
    long: Vec<u16>,
    pub(crate) long_on: Vec<Vec<u64>>,
    /// Those whose rear still covers a movement that their front has left: the movement, and the way after which it does not, metres.
    pub(crate) covers: Vec<(u32, u32, f32)>,
}

impl Roads {
    pub(crate) fn new(network: &Network) -> Self {
        let (lanes, links) = (network.lanes, network.length.len());
        Self {
            queue: vec![VecDeque::new(); links],
            used: vec![0; links.div_ceil(64)],
            leaving: vec![Vec::new(); lanes],
            last: vec![NONE; lanes],
            promised: vec![0; lanes],
            left: vec![(0, NONE, 0.0); links],
            taken: vec![0; links - lanes],
            waiting: vec![0; links - lanes],
            busy: network.map.junctions().iter().map(|of| vec![0; of.conflicts.size().div_ceil(64)]).collect(),
            inside: vec![0; network.rows.len()],
            long: vec![0; links - lanes],
            long_on: network.rows.iter().map(|rows| vec![0; rows.len().div_ceil(64)]).collect(),
            covers: Vec::new(),
        }
    }

    /// The links with vehicles, in their order.
    pub(crate) fn in_use(&mut self) -> Vec<u32> {
        let mut links = Vec::new();
        for (number, word) in self.used.iter_mut().enumerate() {
            let mut left = *word;
            while left != 0 {
                let bit = left.trailing_zeros();
                left &= left - 1;
                let link = number as u32 * 64 + bit;
                if self.queue[link as usize].is_empty() {
                    *word &= !(1 << bit);
                } else {
                    links.push(link);
                }
            }
        }
        links
    }

    /// Notes that one more waits within a junction, or one fewer.
    pub(crate) fn wait(&mut self, network: &Network, movement: usize, more: bool) {
        let (count, all) = (&mut self.waiting[movement], &mut self.inside[network.junction[movement] as usize]);
        if more {
            (*count, *all) = (*count + 1, *all + 1);
        } else {
            (*count, *all) = (*count - 1, *all - 1);
        }
    }

    /// Notes that one more may go over a junction, or is on the way.
    pub(crate) fn take(&mut self, network: &Network, link: u32, long: bool) {
        let movement = network.movement(link);
        self.taken[movement] += 1;
        self.mark(network, movement, true);
        if long {
            self.long[movement] += 1;
            self.mark_long(network, movement, true);
        }
    }

    /// Notes that one fewer is.
    pub(crate) fn give(&mut self, network: &Network, link: u32, long: bool) {
        let movement = network.movement(link);
        self.taken[movement] -= 1;
        if self.taken[movement] == 0 {
            self.mark(network, movement, false);
        }
        if long {
            self.long[movement] -= 1;
            self.mark_long(network, movement, self.long[movement] > 0);
        }
    }

    fn mark_long(&mut self, network: &Network, movement: usize, on: bool) {
        set(&mut self.long_on[network.junction[movement] as usize], network.row[movement], on);
    }

    fn mark(&mut self, network: &Network, movement: usize, on: bool) {
        self.cross(network.junction[movement] as usize, network.row[movement], on);
    }

    /// Notes whether somebody is on a movement, or on a crossing.
    pub(crate) fn cross(&mut self, junction: usize, row: u32, on: bool) {
        set(&mut self.busy[junction], row, on);
    }

    /// Whether somebody is on a movement or a crossing of a junction.
    pub(crate) fn is_busy(&self, junction: usize, row: usize) -> bool {
        self.busy[junction][row / 64] >> (row % 64) & 1 == 1
    }

    /// The last rear on a link, be its front further on, with those who are leaving it sideways.
    pub(crate) fn tail(&self, network: &Network, fleet: &Fleet, drivers: &[Driver], link: u32) -> Option<Tail> {
        let length = |i: usize| drivers[fleet.class[i] as usize].length;
        let last = self.queue[link as usize].back().map(|slot| *slot as usize);
        let last = last.map(|i| (fleet.s[i] - length(i), fleet.v[i]));
        let last = last.or_else(|| self.rear_beyond(network, fleet, drivers, link));
        let Some(leaving) = self.leaving.get(link as usize).filter(|leaving| !leaving.is_empty()) else { return last };
        let aside = leaving.iter().map(|slot| {
            let i = *slot as usize;
            (network.across(fleet.s[i], fleet.link[i], link) - length(i), fleet.v[i])
        });
        aside.chain(last).min_by(|a, b| a.0.total_cmp(&b.0))
    }

    /// The rear of the last who left a link at its end, if it is still on it.
    pub(crate) fn rear_beyond(&self, network: &Network, fleet: &Fleet, drivers: &[Driver], link: u32) -> Option<Tail> {
        let (slot, trip, way) = self.left[link as usize];
        let i = Some(slot as usize).filter(|i| trip != NONE && fleet.trip[*i] == trip)?;
        let beyond = fleet.way[i] - way - drivers[fleet.class[i] as usize].length;
        (beyond < 0.0).then(|| (network.length[link as usize] + beyond, fleet.v[i]))
    }

    /// The position in a link's queue of the first who is behind a station.
    pub(crate) fn position(&self, fleet: &Fleet, link: u32, station: f32) -> usize {
        self.queue[link as usize].partition_point(|slot| fleet.s[*slot as usize] >= station)
    }

    /// Puts somebody into the queue of a link by their station.
    pub(crate) fn enter(&mut self, fleet: &mut Fleet, link: u32, slot: u32) {
        fleet.link[slot as usize] = link;
        let position = self.position(fleet, link, fleet.s[slot as usize]);
        self.used[link as usize / 64] |= 1 << (link % 64);
        self.queue[link as usize].insert(position, slot);
    }

    /// Sets the queue of a link.
    pub(crate) fn set_queue(&mut self, link: u32, queue: Vec<u32>) {
        self.used[link as usize / 64] |= 1 << (link % 64);
        self.queue[link as usize] = queue.into();
    }

    /// Writes all that does not follow from the vehicles.
    pub(crate) fn save(&self, to: &mut Writer) {
        fn some<T>(list: &[T], to: &mut Writer, has: impl Fn(&T) -> bool, write: impl Fn(&mut Writer, &T)) {
            let items: Vec<_> = list.iter().enumerate().filter(|(_, item)| has(item)).collect();
            to.list(items.into_iter(), |to, (number, item)| {
                to.word(number as u32);
                write(to, item);
            });
        }
        some(&self.queue, to, |queue| !queue.is_empty(), |to, queue| to.list(queue.iter(), |to, slot| to.word(*slot)));
        some(&self.leaving, to, |list| !list.is_empty(), |to, list| to.list(list.iter(), |to, slot| to.word(*slot)));
        some(&self.last, to, |slot| *slot != NONE, |to, slot| to.word(*slot));
        some(
            &self.left,
            to,
            |left| left.1 != NONE,
            |to, left| {
                to.word(left.0);
                to.word(left.1);
                to.reals([left.2]);
            },
        );
        to.list(self.covers.iter(), |to, (slot, link, until)| {
            to.word(*slot);
            to.word(*link);
            to.reals([*until]);
        });
    }

    /// Notes that somebody, so far along, leaves a link at its end.
    pub(crate) fn leaves(&mut self, network: &Network, fleet: &Fleet, link: u32, slot: u32) {
        let i = slot as usize;
        let way = fleet.way[i] - (fleet.s[i] - network.length[link as usize]);
        self.left[link as usize] = (slot, fleet.trip[i], way);
    }

    /// Takes somebody out of the queue of a link.
    pub(crate) fn leave(&mut self, link: u32, slot: u32) {
        self.queue[link as usize].retain(|other| *other != slot);
    }
}

/// Sets a bit of a list, or clears it.
fn set(words: &mut [u64], row: u32, on: bool) {
    let word = &mut words[row as usize / 64];
    let bit = 1 << (row % 64);
    *word = if on { *word | bit } else { *word & !bit };
}
