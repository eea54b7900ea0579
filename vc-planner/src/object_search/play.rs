//! Rollouts of a search in one home.

use std::ops::Range;

use super::world::World;
use super::{
    FLOOR, Item, LONGEST, MOST_ITEMS, MOST_LACKS, MOST_ROOMS, MOST_SITES, MOST_TARGETS, Move, ObjectSearch, Outlook,
    Target,
};
use crate::packed::ones;

/// The state of a rollout.
#[derive(Debug, Clone, Copy)]
pub(super) struct Play {
    cost: u32,
    room: u8,
    /// The spot at hand; at first those that the search lists.
    at: Option<u16>,
    begun: bool,
    pub(super) entered: u64,
    seen: [u64; MOST_SITES / 64],
    found: u32,
    left: [u8; MOST_LACKS],
    /// The lacks that are still open, as bits.
    lacking: u8,
    items: [Item; MOST_ITEMS],
    known: u8,
    held: [Option<u8>; 2],
    hands: u8,
    /// The best look in each room, out of date for the `stale` rooms (bits).
    offers: [Option<(f64, Move)>; MOST_ROOMS],
    stale: u64,
}

impl Play {
    pub(super) fn start(search: &ObjectSearch) -> Self {
        let mut play = Self {
            cost: 0,
            room: search.room,
            at: None,
            begun: false,
            entered: 0,
            seen: [0; MOST_SITES / 64],
            found: 0,
            left: [0; MOST_LACKS],
            lacking: 0,
            items: [Item::default(); MOST_ITEMS],
            known: 0,
            held: [None; 2],
            hands: search.blocked,
            offers: [None; MOST_ROOMS],
            stale: every_room(search),
        };
        for (i, lack) in search.lacks.iter().enumerate().take(MOST_LACKS) {
            play.left[i] = lack.left;
            play.lacking |= u8::from(lack.left > 0) << i;
        }
        search.items.iter().for_each(|item| play.learn(*item));
        search.hands.iter().for_each(|&target| play.hold(Some(target)));
        let empty = |(range, shut): &(Range<u16>, u16)| range.start == *shut;
        (0..search.rooms.len()).filter(|&r| empty(&search.rooms[r])).for_each(|r| play.entered |= 1 << r);
        play.entered |= 1 << search.room;
        play
    }

    /// The cost of a move and of the rollout of the base policy after it.
    pub(super) fn played(mut self, search: &ObjectSearch, world: &World, first: Move) -> f64 {
        self.make(search, world, first);
        loop {
            self.at_once(search);
            if self.lacking == 0 || self.cost > LONGEST {
                return f64::from(self.cost + self.rest(search));
            }
            let next = if self.full() { self.delivery() } else { None };
            match next.or_else(|| self.next_observation(search)) {
                Some(next) => self.make(search, world, next),
                None => return f64::from(self.cost + self.rest(search)),
            }
        }
    }

    fn make(&mut self, search: &ObjectSearch, world: &World, next: Move) {
        match next {
            Move::Visit { room, spot } => self.go(search, world, room, spot),
            Move::Open(site) => self.open(search, world, site),
            Move::Fetch(i) => {
                let item = self.items[i as usize];
                if !self.at_hand(search, Some(item.spot)) {
                    self.go(search, world, item.room, Some(item.spot));
                }
                self.grab(i);
            }
            Move::Deliver(hand) => {
                let Some(target) = self.target(search, hand) else { return };
                if !self.at_hand(search, Some(target.spot)) {
                    self.go(search, world, target.room, Some(target.spot));
                }
                self.put(search, world, hand);
            }
        }
    }

    fn go(&mut self, search: &ObjectSearch, world: &World, room: u8, spot: Option<u16>) {
        // The former spots are no longer at hand.
        self.stale |= if self.begun { 1 << self.room | 1 << room } else { every_room(search) };
        (self.cost, self.room, self.at, self.begun) = (self.cost + 1, room, spot, true);
        if self.entered >> room & 1 == 0 {
            self.entered |= 1 << room;
            let (range, shut) = &search.rooms[room as usize];
            (range.start..*shut).for_each(|s| self.see_contents(search, world, s));
        }
    }

    fn open(&mut self, search: &ObjectSearch, world: &World, site: u16) {
        let spot = search.sites[site as usize].spot;
        if !self.at_hand(search, spot) {
            self.go(search, world, search.room_of[site as usize], spot);
        }
        self.cost += search.opening;
        self.see_contents(search, world, site);
    }

    fn see_contents(&mut self, search: &ObjectSearch, world: &World, site: u16) {
        self.seen[site as usize / 64] |= 1 << (site % 64);
        self.stale |= 1 << search.room_of[site as usize];
        let new = world.things_at(site) & !self.found;
        self.found |= new;
        for i in ones(u64::from(new)) {
            let lack = search.sought_objects[i].lack as usize;
            if self.left[lack] == 0 {
                continue;
            }
            self.left[lack] -= 1;
            if self.left[lack] == 0 {
                self.lacking &= !(1 << lack);
                self.stale = every_room(search);
            }
            let spot = search.sites[site as usize].spot.unwrap_or(FLOOR | i as u16);
            let room = search.room_of[site as usize];
            // A thing that already lies at its target is done.
            let target = search.lacks[lack].target;
            if target.is_none_or(|t| search.targets[t as usize].spot != spot) {
                self.learn(Item { spot, room, target });
            }
        }
    }

    fn learn(&mut self, item: Item) {
        if (self.known as usize) < MOST_ITEMS {
            self.items[self.known as usize] = item;
            self.known += 1;
        }
    }

    fn hold(&mut self, target: Option<u8>) {
        if self.hands < 2 && target.is_some() {
            let free = self.held.iter().position(Option::is_none).unwrap_or(0);
            self.held[free] = target;
            self.hands += 1;
        }
    }

    fn grab(&mut self, i: u8) {
        let item = self.items[i as usize];
        self.known -= 1;
        self.items[i as usize] = self.items[self.known as usize];
        self.cost += 1;
        self.hold(item.target);
    }

    fn put(&mut self, search: &ObjectSearch, world: &World, hand: u8) {
        let Some(target) = self.target(search, hand) else { return };
        if let Some(site) = target.door.filter(|s| !self.has_seen(*s)) {
            // A full hand is emptied first and filled again afterwards.
            self.cost += 1 + 2 * u32::from(self.full());
            self.see_contents(search, world, site);
        }
        self.cost += 1;
        (self.held[hand as usize], self.hands) = (None, self.hands - 1);
    }

    /// Does everything that needs no walk: puts down held things wanted at hand, takes wanted things at hand.
    fn at_once(&mut self, search: &ObjectSearch) {
        for hand in 0..2 {
            let open = |t: &Target| t.door.is_none_or(|s| self.has_seen(s));
            if self.target(search, hand).is_some_and(|t| self.at_hand(search, Some(t.spot)) && open(&t)) {
                self.put(search, &World::default(), hand);
            }
        }
        let mut i = 0;
        while i < self.known && !self.full() {
            if self.at_hand(search, Some(self.items[i as usize].spot)) {
                self.grab(i);
            } else {
                i += 1;
            }
        }
    }

    fn target(&self, search: &ObjectSearch, hand: u8) -> Option<Target> {
        self.held.get(hand as usize).copied().flatten().map(|t| search.targets[t as usize])
    }

    fn delivery(&self) -> Option<Move> {
        self.held.iter().position(Option::is_some).map(|hand| Move::Deliver(hand as u8))
    }

    /// The next observation of the base policy. Only rooms in which something has changed are evaluated again.
    fn next_observation(&mut self, search: &ObjectSearch) -> Option<Move> {
        for room in ones(self.stale) {
            self.offers[room] = self.best_in(search, room as u8);
        }
        self.stale = 0;
        let mut best: Option<(f64, Move)> = None;
        for &(worth, next) in self.offers[..search.rooms.len()].iter().flatten() {
            if best.is_none_or(|(most, _)| worth > most) {
                best = Some((worth, next));
            }
        }
        best.map(|(_, next)| next)
    }

    /// The best look in a room.
    fn best_in(&self, search: &ObjectSearch, room: u8) -> Option<(f64, Move)> {
        let (range, shut) = &search.rooms[room as usize];
        let mut best: Option<(f64, Move)> = None;
        let mut offer = |worth: f64, next: Move| {
            if worth > best.map_or(0.0, |(most, _)| most) {
                best = Some((worth, next));
            }
        };
        let fresh = self.entered >> room & 1 == 0;
        let outlook = if fresh { self.outlook(search, room) } else { Outlook::default() };
        offer(outlook.value, Move::Visit { room, spot: outlook.spot });
        let (mut chance, mut cost, mut first) = (outlook.value, 0.0, None);
        let open = f64::from(search.opening);
        for s in (*shut..range.end).filter(|&s| !self.has_seen(s)) {
            let own = self.value(search, s);
            // The likeliest sites come first: no later site can be better.
            if cost > 0.0 && own * cost < chance * open {
                break;
            }
            let walk = if self.at_hand(search, search.sites[s as usize].spot) { 0.0 } else { 1.0 };
            if walk == 0.0 {
                offer(own / open, Move::Open(s));
            }
            (chance, cost) = (chance + own, cost + walk + open);
            offer(chance / cost, Move::Open(*first.get_or_insert(s)));
        }
        best
    }

    /// A lower bound on the remaining work for the known things: every spot and target is visited once per two
    /// things.
    fn rest(&self, search: &ObjectSearch) -> u32 {
        let items = &self.items[..self.known as usize];
        let mut into = [0u8; MOST_TARGETS];
        let mut cost = 0;
        for (i, item) in items.iter().enumerate() {
            let before = items[..i].iter().filter(|other| other.spot == item.spot).count();
            let walk = before % 2 == 0 && (before > 0 || !self.at_hand(search, Some(item.spot)));
            cost += 1 + u32::from(walk);
        }
        for target in items.iter().map(|i| i.target).chain(self.held).flatten() {
            into[target as usize % MOST_TARGETS] += 1;
        }
        for (target, &n) in search.targets.iter().zip(&into).filter(|(_, n)| **n > 0) {
            let shut = target.door.is_some_and(|s| !self.has_seen(s));
            cost += u32::from(n) + u32::from(n.div_ceil(2)) + u32::from(shut);
        }
        cost
    }

    /// Whether both hands are full and one can be emptied at a target.
    pub(super) fn full(&self) -> bool {
        self.hands >= 2 && self.held != [None; 2]
    }

    pub(super) fn has_seen(&self, site: u16) -> bool {
        self.seen[site as usize / 64] >> (site % 64) & 1 == 1
    }

    pub(super) fn at_hand(&self, search: &ObjectSearch, spot: Option<u16>) -> bool {
        let Some(spot) = spot else { return false };
        if self.begun { self.at == Some(spot) } else { search.near.contains(&spot) }
    }

    /// The expected number of lacking things at a site.
    pub(super) fn value(&self, search: &ObjectSearch, site: u16) -> f64 {
        search.values[self.lacking as usize * search.sites.len() + site as usize]
    }

    pub(super) fn outlook(&self, search: &ObjectSearch, room: u8) -> Outlook {
        search.outlooks[self.lacking as usize * search.rooms.len() + room as usize]
    }
}

/// All rooms, as bits.
fn every_room(search: &ObjectSearch) -> u64 {
    u64::MAX.checked_shr((MOST_ROOMS - search.rooms.len().min(MOST_ROOMS)) as u32).unwrap_or(0)
}
