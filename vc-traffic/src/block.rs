//! Parts of links that people or other things take up, for which vehicles wait; and whether vehicles leave room for people to step on one.

use crate::Traffic;
use crate::ground::Span;

/// Vehicles stop for those who wait for them if that takes at most this deceleration, metres per second squared.
const COURTEOUS: f32 = 4.0;
/// Somebody steps on the road if each vehicle that comes has so much time to react, seconds, and stops so far before them, metres.
const REACTS: f32 = 1.0;
const BEFORE: f32 = 1.0;
/// A body is so far from who crosses, metres.
const APART: f32 = 0.3;
/// Vehicles are looked for so far, metres, over so many links.
const FAR: f32 = 80.0;
const LINKS: usize = 4;
/// One that has stood for so long, seconds, goes before the next who wants to cross so near before it, metres.
const PATIENCE: f32 = 30.0;
const NEAR: f32 = 8.0;

/// A part of a link that is taken up, or that somebody waits for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Block {
    pub(crate) span: Span,
    /// Whether it is taken up.
    pub(crate) firm: bool,
}

impl Traffic {
    /// The blocks of a link.
    pub(crate) fn blocks_on(&self, link: u32) -> &[Block] {
        let from = self.blocks.partition_point(|block| block.span.link < link);
        let to = from + self.blocks[from..].partition_point(|block| block.span.link == link);
        &self.blocks[from..to]
    }

    /// The gap to the nearest block of a link that a vehicle heeds, metres: one whose front is at a station of the link, a negative one if it
    /// is before that.
    pub(crate) fn gap_to_block(&self, slot: u32, link: u32, station: f32) -> Option<f32> {
        let gap = |block: &Block| block.span.from - station;
        let heeds = |block: &&Block| block.span.to > station && (block.firm || self.waits_for(slot, gap(block)));
        self.blocks_on(link).iter().filter(heeds).map(|block| gap(block).max(0.0)).reduce(f32::min)
    }

    /// Whether a vehicle stops for somebody who waits so far ahead, metres.
    fn waits_for(&self, slot: u32, away: f32) -> bool {
        let (v, stood) = (self.fleet.v[slot as usize], self.fleet.stood[slot as usize]);
        stood < PATIENCE && away > v * v / (2.0 * COURTEOUS)
    }

    /// Whether a vehicle does not go on a link because somebody is there, or waits to be, and it does not yet for too long.
    pub(crate) fn leaves_to_people(&self, slot: u32, link: u32) -> bool {
        self.blocks_on(link).iter().any(|block| block.firm || self.fleet.stood[slot as usize] < PATIENCE)
    }

    /// Whether a part of a link between two stations is free of blocks.
    pub(crate) fn is_unblocked(&self, link: u32, from: f32, to: f32) -> bool {
        self.blocks_on(link).iter().all(|block| block.span.to < from || block.span.from > to)
    }

    /// Whether no vehicle is on any of some parts of links.
    pub(crate) fn is_empty_on(&self, spans: &[Span]) -> bool {
        spans.iter().all(|span| {
            let gone = self.roads.rear_beyond(&self.network, &self.fleet, &self.drivers, span.link);
            let off = |slot: u32| {
                let front = self.station_on(slot, span.link);
                front <= span.from - APART || front - self.length(slot) > span.to + APART
            };
            gone.is_none_or(|(rear, _)| rear > span.to + APART) && self.on(span.link).all(off)
        })
    }

    /// The same, and all that come can stop.
    pub(crate) fn is_open(&self, spans: &[Span]) -> bool {
        let stop = |span: &Span| {
            let comes = |slot: &u32| self.station_on(*slot, span.link) <= span.from - APART;
            let mut coming = self.on(span.link).filter(comes);
            coming.all(|slot| self.stops(slot as usize, span.from - self.station_on(slot, span.link)))
                && !self.comes(span.link, span.from, LINKS)
        };
        self.is_empty_on(spans) && spans.iter().all(stop)
    }

    /// The vehicles on a link, with those who are leaving it sideways.
    pub(crate) fn on(&self, link: u32) -> impl Iterator<Item = u32> {
        let beside = self.roads.leaving.get(link as usize).into_iter().flatten();
        self.roads.queue[link as usize].iter().chain(beside).copied()
    }

    /// The station of a vehicle's front on its link, or on one beside it, metres.
    pub(crate) fn station_on(&self, slot: u32, link: u32) -> f32 {
        self.network.on_or_across(self.fleet.s[slot as usize], self.fleet.link[slot as usize], link)
    }

    /// Whether a vehicle comes towards the start of a link that cannot stop so far beyond it, metres, or does not want to.
    fn comes(&self, link: u32, away: f32, links: usize) -> bool {
        let (network, fleet) = (&self.network, &self.fleet);
        if away > FAR || links == 0 {
            return false;
        }
        let lane = network.is_lane(link);
        let own = [if lane { link } else { network.from[network.movement(link)] }];
        let before: &[u32] = if lane { &network.before[link as usize] } else { &own };
        before.iter().any(|before| {
            let length = network.length[*before as usize];
            let turns = |slot: &&u32| lane || fleet.next[**slot as usize] == link;
            let mut queue = self.roads.queue[*before as usize].iter().filter(turns);
            queue.any(|slot| !self.stops(*slot as usize, away + length - fleet.s[*slot as usize]))
                || self.comes(*before, away + length, links - 1)
        })
    }

    /// Whether a vehicle can stop for somebody so far ahead, metres, and has not done so for too long.
    fn stops(&self, i: usize, away: f32) -> bool {
        let (fleet, v) = (&self.fleet, self.fleet.v[i]);
        let impatient = fleet.stood[i] > PATIENCE && away < NEAR;
        !impatient && away > v * REACTS + self.drivers[fleet.class[i] as usize].stopping(v) + BEFORE
    }
}
