//! A search for things, small enough to be played to its end many times.
//!
//! What to do next, look somewhere or see to something already found, is settled by
//! playing on from each candidate in homes drawn from the belief, and taking the one
//! with the lowest mean number of actions: a rollout of a base policy (Bertsekas and
//! Castanon, *Rollout Algorithms for Stochastic Scheduling Problems*, 1999), which is
//! never worse than the base policy in expectation. The base policy looks by falling
//! chance over cost and delivers with both hands full. All candidates meet the same
//! homes, and the worse half of them is dropped as the homes become more (Karnin, Koren
//! and Somekh, *Almost Optimal Exploration in Multi-Armed Bandits*, 2013).

use std::ops::Range;

/// Most sites, rooms, wanted things and kinds of what is lacking: bits and small arrays.
pub(crate) const MOST_SITES: usize = 512;
pub(crate) const MOST_ROOMS: usize = 64;
pub(crate) const MOST_QUARRIES: usize = 24;
pub(crate) const MOST_LACKS: usize = 8;
const MOST_ITEMS: usize = 12;
pub(crate) const MOST_TARGETS: usize = 24;
/// Spots from here on are things lying on a floor: each is walked up to itself.
const FLOOR: u16 = 0x8000;
/// A thing that is not among the sites of a world.
const NOWHERE: u16 = u16::MAX;

/// A place not yet looked at.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Site {
    /// What is walked up to; nothing for the floor.
    pub(crate) spot: Option<u16>,
    /// It must be opened to be seen; else entering its room shows it.
    pub(crate) shut: bool,
}

/// Where something is to be put.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Target {
    pub(crate) spot: u16,
    pub(crate) room: u8,
    /// The site that is opened to put something there.
    pub(crate) door: Option<u16>,
}

/// So many things of a kind are lacking, and go to a target; if none, having one in
/// the hand is enough.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Lacking {
    pub(crate) left: u8,
    pub(crate) target: Option<u8>,
}

/// A thing that would do, with the chance that it is at each site.
#[derive(Debug, Clone)]
pub(crate) struct Quarry {
    pub(crate) lack: u8,
    pub(crate) chances: Vec<f64>,
}

/// A thing to be fetched, at a known spot.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Item {
    pub(crate) spot: u16,
    pub(crate) room: u8,
    pub(crate) target: Option<u8>,
}

/// What to do next.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Move {
    /// Walk to a spot in a room not seen yet; to the room itself if there is none.
    Visit { room: u8, spot: Option<u16> },
    /// Walk up to a shut site and open it.
    Open(u16),
    /// Fetch a known item.
    Fetch(u8),
    /// Bring what is in a hand to its target.
    Deliver(u8),
}

/// The whole search, as far as it is known.
#[derive(Debug, Clone, Default)]
pub(crate) struct Hunt {
    /// By room; in each those in view first, then those that are shut, likeliest first.
    pub(crate) sites: Vec<Site>,
    /// The sites of each room, and from where on they are shut.
    pub(crate) rooms: Vec<(Range<u16>, u16)>,
    pub(crate) targets: Vec<Target>,
    pub(crate) lacks: Vec<Lacking>,
    pub(crate) quarries: Vec<Quarry>,
    pub(crate) items: Vec<Item>,
    /// Targets of what is in the hands.
    pub(crate) hands: Vec<u8>,
    /// How many hands hold something else.
    pub(crate) blocked: u8,
    /// Where the agent is, and what is at hand at first.
    pub(crate) room: u8,
    pub(crate) near: Vec<u16>,
    /// What opening costs: one, or two where it is closed again.
    pub(crate) opening: u32,
    /// For each set of lacks (bits), and in it for each site, how many of them are to be
    /// expected there.
    pub(crate) values: Vec<f64>,
}

/// How many homes candidates are played in, at each stage of the contest.
const STAGES: [usize; 3] = [6, 18, 48];
/// At most so many homes are played in when these are all there are.
const ALL: usize = 72;
/// How many candidates are tried.
const CANDIDATES: usize = 10;
/// A play that takes so many actions is cut short.
const LONGEST: u32 = 2_000;

/// A home drawn: the site of each quarry, and the chance of it all.
type World = (f64, Vec<u16>);

impl Hunt {
    /// The best thing to do next; `None` if there is nothing to look at or to see to.
    pub(crate) fn best(&mut self) -> Option<Move> {
        if self.lacks.iter().all(|l| l.left == 0) {
            return None;
        }
        self.sum_chances();
        let mut moves = self.moves();
        if moves.len() <= 1 {
            return moves.pop();
        }
        let (worlds, all) = self.worlds();
        let mut costs = vec![0.0; moves.len()];
        let start = Play::start(self);
        let mut played = 0;
        for end in STAGES.map(|n| if all { worlds.len() } else { n }) {
            for (cost, &candidate) in costs.iter_mut().zip(&moves) {
                let each =
                    worlds[played..end].iter().map(|(chance, world)| chance * start.played(self, world, candidate));
                *cost += each.sum::<f64>();
            }
            played = end;
            if played < worlds.len() {
                halve(&mut moves, &mut costs);
            }
        }
        let least = (0..moves.len()).min_by(|&a, &b| costs[a].total_cmp(&costs[b]).then(a.cmp(&b)));
        least.map(|i| moves[i])
    }

    fn sum_chances(&mut self) {
        let number = self.sites.len();
        let mut chances = vec![[0.0; MOST_LACKS]; number];
        for quarry in &self.quarries {
            for (sums, chance) in chances.iter_mut().zip(&quarry.chances) {
                let sum = &mut sums[quarry.lack as usize];
                // That at least one is there.
                *sum = 1.0 - (1.0 - *sum) * (1.0 - chance);
            }
        }
        self.values = vec![0.0; number << self.lacks.len()];
        for set in 1..1usize << self.lacks.len() {
            let last = set.ilog2() as usize;
            let (less, rest) = self.values.split_at_mut(set * number);
            let without = &less[(set ^ 1 << last) * number..][..number];
            for ((value, less), chance) in rest.iter_mut().zip(without).zip(&chances) {
                *value = less + chance[last];
            }
        }
        for (range, shut) in &self.rooms {
            debug_assert!(self.sites[range.start as usize..*shut as usize].iter().all(|s| !s.shut));
            debug_assert!(self.sites[*shut as usize..range.end as usize].iter().all(|s| s.shut));
        }
    }

    /// What to try: the base policy's choice first.
    fn moves(&self) -> Vec<Move> {
        let start = Play::start(self);
        let full = start.full();
        let mut looks: Vec<(f64, Move)> = Vec::new();
        for room in 0..self.rooms.len() as u8 {
            self.looks(&start, room, full, &mut looks);
        }
        looks.sort_by(|a, b| b.0.total_cmp(&a.0));
        looks.truncate(CANDIDATES);
        let mut moves: Vec<Move> = looks.into_iter().map(|(_, m)| m).collect();
        let mut spots: Vec<u16> = Vec::new();
        for (i, item) in self.items.iter().enumerate().filter(|_| !full).take(CANDIDATES) {
            if !spots.contains(&item.spot) {
                spots.push(item.spot);
                moves.push(Move::Fetch(i as u8));
            }
        }
        moves.extend((0..self.hands.len() as u8).map(Move::Deliver));
        moves
    }

    /// The looks at a room, with what they are worth.
    fn looks(&self, play: &Play, room: u8, full: bool, looks: &mut Vec<(f64, Move)>) {
        let (range, shut) = &self.rooms[room as usize];
        let fresh = play.entered >> room & 1 == 0;
        let surfaces = if fresh { (range.start..*shut).map(|s| play.value(self, s)).sum() } else { 0.0 };
        let (mut chance, mut cost, mut best) = (surfaces, 0.0, 0.0);
        let mut boxes = (*shut..range.end).filter(|&s| !play.has_seen(s));
        for s in boxes.clone() {
            let at_hand = play.at_hand(self, self.sites[s as usize].spot);
            (chance, cost) =
                (chance + play.value(self, s), cost + f64::from(self.opening) + f64::from(u8::from(!at_hand)));
            best = f64::max(best, chance / cost);
        }
        let first = boxes.next();
        if fresh && surfaces > 0.0 {
            let worth = f64::max(surfaces, best);
            looks.push((worth, Move::Visit { room, spot: self.likeliest_surface(play, room) }));
            if let Some(spot) = first.and_then(|s| self.sites[s as usize].spot) {
                looks.push((worth * 0.999, Move::Visit { room, spot: Some(spot) }));
            }
            let targets = self.targets.iter().filter(|t| t.room == room);
            looks.extend(targets.map(|t| (worth * 0.998, Move::Visit { room, spot: Some(t.spot) })));
        }
        if full {
            return;
        }
        for s in (*shut..range.end).filter(|&s| !play.has_seen(s)) {
            let at_hand = play.at_hand(self, self.sites[s as usize].spot);
            let own = play.value(self, s) / f64::from(self.opening);
            if at_hand {
                looks.push((own, Move::Open(s)));
            } else if Some(s) == first {
                looks.push((best * 0.9995, Move::Open(s)));
            } else if !fresh {
                looks.push((own / 2.0, Move::Open(s)));
            }
        }
    }

    fn likeliest_surface(&self, play: &Play, room: u8) -> Option<u16> {
        let (range, shut) = &self.rooms[room as usize];
        let value = |s: &u16| play.value(self, *s);
        let spots = (range.start..*shut).filter(|&s| self.sites[s as usize].spot.is_some());
        let best = spots.max_by(|a, b| value(a).total_cmp(&value(b)).then(b.cmp(a)));
        best.and_then(|s| self.sites[s as usize].spot)
    }

    /// Homes to play in, and whether these are all there are: else they are a sample.
    fn worlds(&self) -> (Vec<World>, bool) {
        let supports: Vec<usize> =
            self.quarries.iter().map(|q| q.chances.iter().filter(|c| **c > 0.0).count()).collect();
        let number = supports.iter().try_fold(1usize, |all, &n| all.checked_mul(n));
        match number {
            Some(n) if n <= ALL => (self.all_worlds(), true),
            _ => ((0..STAGES[2]).map(|i| (1.0, self.draw(i))).collect(), false),
        }
    }

    fn all_worlds(&self) -> Vec<World> {
        let mut worlds: Vec<World> = vec![(1.0, Vec::new())];
        for quarry in &self.quarries {
            let possible: Vec<(u16, f64)> =
                (0u16..).zip(quarry.chances.iter().copied()).filter(|(_, c)| *c > 0.0).collect();
            let with = |(chance, world): &World, &(s, c): &(u16, f64)| (chance * c, [world.as_slice(), &[s]].concat());
            worlds = worlds.iter().flat_map(|w| possible.iter().map(|p| with(w, p)).collect::<Vec<_>>()).collect();
        }
        worlds
    }

    /// The home of a number: for each quarry the points of a Kronecker sequence, which
    /// fall more evenly than random ones.
    fn draw(&self, number: usize) -> Vec<u16> {
        let site = |(i, quarry): (usize, &Quarry)| {
            let step = f64::from(PRIMES[i % PRIMES.len()]).sqrt().fract();
            let mut left = (0.5 + (number + 1) as f64 * step).fract() * quarry.chances.iter().sum::<f64>();
            let mut last = NOWHERE;
            for (s, &chance) in (0u16..).zip(&quarry.chances).filter(|(_, c)| **c > 0.0) {
                last = s;
                left -= chance;
                if left < 0.0 {
                    break;
                }
            }
            last
        };
        self.quarries.iter().enumerate().map(site).collect()
    }
}

const PRIMES: [u8; MOST_QUARRIES] =
    [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53, 59, 61, 67, 71, 73, 79, 83, 89];

/// Keeps the better half of the candidates, the base policy's choice among them, in order.
fn halve(moves: &mut Vec<Move>, costs: &mut Vec<f64>) {
    let mut order: Vec<usize> = (0..moves.len()).collect();
    order.sort_by(|&a, &b| costs[a].total_cmp(&costs[b]).then(a.cmp(&b)));
    order.truncate(moves.len().div_ceil(2).max(2));
    order.sort_unstable();
    *moves = order.iter().map(|&i| moves[i]).collect();
    *costs = order.iter().map(|&i| costs[i]).collect();
}

/// A search being played.
#[derive(Debug, Clone, Copy)]
struct Play {
    cost: u32,
    room: u8,
    /// The spot at hand; at first those the hunt says.
    at: Option<u16>,
    begun: bool,
    entered: u64,
    seen: [u64; MOST_SITES / 64],
    found: u32,
    left: [u8; MOST_LACKS],
    /// The lacks of which something is left, as bits.
    lacking: u8,
    items: [Item; MOST_ITEMS],
    known: u8,
    held: [Option<u8>; 2],
    hands: u8,
}

impl Play {
    fn start(hunt: &Hunt) -> Self {
        let mut play = Self {
            cost: 0,
            room: hunt.room,
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
            hands: hunt.blocked,
        };
        for (i, lack) in hunt.lacks.iter().enumerate().take(MOST_LACKS) {
            play.left[i] = lack.left;
            play.lacking |= u8::from(lack.left > 0) << i;
        }
        hunt.items.iter().for_each(|item| play.learn(*item));
        hunt.hands.iter().for_each(|&target| play.hold(Some(target)));
        let empty = |(range, shut): &(Range<u16>, u16)| range.start == *shut;
        (0..hunt.rooms.len()).filter(|&r| empty(&hunt.rooms[r])).for_each(|r| play.entered |= 1 << r);
        play.entered |= 1 << hunt.room;
        play
    }

    /// The cost of a move and of all that comes after it by the base policy.
    fn played(mut self, hunt: &Hunt, world: &[u16], first: Move) -> f64 {
        self.make(hunt, world, first);
        loop {
            self.at_once(hunt);
            if self.lacking == 0 || self.cost > LONGEST {
                return f64::from(self.cost + self.rest(hunt));
            }
            let next = if self.full() { self.delivery() } else { None };
            match next.or_else(|| self.look(hunt)) {
                Some(next) => self.make(hunt, world, next),
                None => return f64::from(self.cost + self.rest(hunt)),
            }
        }
    }

    fn make(&mut self, hunt: &Hunt, world: &[u16], next: Move) {
        match next {
            Move::Visit { room, spot } => self.go(hunt, world, room, spot),
            Move::Open(site) => self.open(hunt, world, site),
            Move::Fetch(i) => {
                let item = self.items[i as usize];
                if !self.at_hand(hunt, Some(item.spot)) {
                    self.go(hunt, world, item.room, Some(item.spot));
                }
                self.grab(i);
            }
            Move::Deliver(hand) => {
                let Some(target) = self.target(hunt, hand) else { return };
                if !self.at_hand(hunt, Some(target.spot)) {
                    self.go(hunt, world, target.room, Some(target.spot));
                }
                self.put(hunt, world, hand);
            }
        }
    }

    fn go(&mut self, hunt: &Hunt, world: &[u16], room: u8, spot: Option<u16>) {
        (self.cost, self.room, self.at, self.begun) = (self.cost + 1, room, spot, true);
        if self.entered >> room & 1 == 0 {
            self.entered |= 1 << room;
            let (range, shut) = &hunt.rooms[room as usize];
            (range.start..*shut).for_each(|s| self.reveal(hunt, world, s));
        }
    }

    fn open(&mut self, hunt: &Hunt, world: &[u16], site: u16) {
        let spot = hunt.sites[site as usize].spot;
        if !self.at_hand(hunt, spot) {
            let room = hunt.rooms.iter().position(|(range, _)| range.contains(&site)).unwrap_or(0);
            self.go(hunt, world, room as u8, spot);
        }
        self.cost += hunt.opening;
        self.reveal(hunt, world, site);
    }

    fn reveal(&mut self, hunt: &Hunt, world: &[u16], site: u16) {
        self.seen[site as usize / 64] |= 1 << (site % 64);
        for (i, &at) in world.iter().enumerate() {
            if at != site || self.found >> i & 1 == 1 {
                continue;
            }
            self.found |= 1 << i;
            let lack = hunt.quarries[i].lack as usize;
            if self.left[lack] == 0 {
                continue;
            }
            self.left[lack] -= 1;
            self.lacking &= !(u8::from(self.left[lack] == 0) << lack);
            let spot = hunt.sites[site as usize].spot.unwrap_or(FLOOR | i as u16);
            let room = hunt.rooms.iter().position(|(range, _)| range.contains(&site)).unwrap_or(0) as u8;
            // What already lies where it is to be is done.
            let target = hunt.lacks[lack].target;
            if target.is_none_or(|t| hunt.targets[t as usize].spot != spot) {
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

    fn put(&mut self, hunt: &Hunt, world: &[u16], hand: u8) {
        let Some(target) = self.target(hunt, hand) else { return };
        if let Some(site) = target.door.filter(|s| !self.has_seen(*s)) {
            // A full hand is put down and taken up again.
            self.cost += 1 + 2 * u32::from(self.full());
            self.reveal(hunt, world, site);
        }
        self.cost += 1;
        (self.held[hand as usize], self.hands) = (None, self.hands - 1);
    }

    /// What takes no walk: putting down what is wanted at hand, taking what is.
    fn at_once(&mut self, hunt: &Hunt) {
        for hand in 0..2 {
            let open = |t: &Target| t.door.is_none_or(|s| self.has_seen(s));
            if self.target(hunt, hand).is_some_and(|t| self.at_hand(hunt, Some(t.spot)) && open(&t)) {
                self.put(hunt, &[], hand);
            }
        }
        let mut i = 0;
        while i < self.known && !self.full() {
            if self.at_hand(hunt, Some(self.items[i as usize].spot)) {
                self.grab(i);
            } else {
                i += 1;
            }
        }
    }

    fn target(&self, hunt: &Hunt, hand: u8) -> Option<Target> {
        self.held.get(hand as usize).copied().flatten().map(|t| hunt.targets[t as usize])
    }

    fn delivery(&self) -> Option<Move> {
        self.held.iter().position(Option::is_some).map(|hand| Move::Deliver(hand as u8))
    }

    /// Where the base policy looks next.
    fn look(&self, hunt: &Hunt) -> Option<Move> {
        let mut best: Option<(f64, Move)> = None;
        let mut offer = |worth: f64, next: Move| {
            if worth > best.map_or(0.0, |(most, _)| most) {
                best = Some((worth, next));
            }
        };
        for (room, (range, shut)) in (0u8..).zip(&hunt.rooms) {
            let fresh = self.entered >> room & 1 == 0;
            let surfaces: f64 = if fresh { (range.start..*shut).map(|s| self.value(hunt, s)).sum() } else { 0.0 };
            if surfaces > 0.0 {
                offer(surfaces, Move::Visit { room, spot: hunt.likeliest_surface(self, room) });
            }
            let (mut chance, mut cost, mut first) = (surfaces, 0.0, None);
            for s in (*shut..range.end).filter(|&s| !self.has_seen(s)) {
                let own = self.value(hunt, s);
                let open = f64::from(hunt.opening);
                // The likeliest come first: from here on none makes it more worth while.
                if cost > 0.0 && own * cost < chance * open {
                    break;
                }
                let walk = if self.at_hand(hunt, hunt.sites[s as usize].spot) { 0.0 } else { 1.0 };
                if walk == 0.0 {
                    offer(own / open, Move::Open(s));
                }
                (chance, cost) = (chance + own, cost + walk + open);
                offer(chance / cost, Move::Open(*first.get_or_insert(s)));
            }
        }
        best.map(|(_, next)| next)
    }

    /// How much is at least left to do with what is known: every spot and target is
    /// walked to once for two things.
    fn rest(&self, hunt: &Hunt) -> u32 {
        let items = &self.items[..self.known as usize];
        let mut into = [0u8; MOST_TARGETS];
        let mut cost = 0;
        for (i, item) in items.iter().enumerate() {
            let before = items[..i].iter().filter(|other| other.spot == item.spot).count();
            let walk = before % 2 == 0 && (before > 0 || !self.at_hand(hunt, Some(item.spot)));
            cost += 1 + u32::from(walk);
        }
        for target in items.iter().map(|i| i.target).chain(self.held).flatten() {
            into[target as usize % MOST_TARGETS] += 1;
        }
        for (target, &n) in hunt.targets.iter().zip(&into).filter(|(_, n)| **n > 0) {
            let shut = target.door.is_some_and(|s| !self.has_seen(s));
            cost += u32::from(n) + u32::from(n.div_ceil(2)) + u32::from(shut);
        }
        cost
    }

    /// Whether both hands are full and one can be emptied where it is wanted.
    fn full(&self) -> bool {
        self.hands >= 2 && self.held != [None; 2]
    }

    fn has_seen(&self, site: u16) -> bool {
        self.seen[site as usize / 64] >> (site % 64) & 1 == 1
    }

    fn at_hand(&self, hunt: &Hunt, spot: Option<u16>) -> bool {
        let Some(spot) = spot else { return false };
        if self.begun { self.at == Some(spot) } else { hunt.near.contains(&spot) }
    }

    /// How many of what is lacking are to be expected at a site.
    fn value(&self, hunt: &Hunt, site: u16) -> f64 {
        hunt.values[self.lacking as usize * hunt.sites.len() + site as usize]
    }
}
