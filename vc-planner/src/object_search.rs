//! A search for things, small enough for many rollouts.
//!
//! The next move, looking somewhere or handling a found thing, is chosen by rollouts: each candidate is played
//! to the end in homes sampled from the belief, and the candidate with the lowest mean number of actions wins.
//! This is a rollout of a base policy (Bertsekas and Castanon, *Rollout Algorithms for Stochastic Scheduling
//! Problems*, 1999), which in expectation is never worse than the base policy. The base policy looks in the
//! order of decreasing probability over cost and delivers once both hands are full. All candidates are played
//! in the same homes, and the worse half is dropped as the number of homes grows (Karnin, Koren and Somekh,
//! *Almost Optimal Exploration in Multi-Armed Bandits*, 2013).

mod play;
mod world;

use std::ops::Range;

use play::Play;

/// Largest numbers of sites, rooms, wanted things and kinds of lacking things: they are bits and small arrays.
pub(crate) const MOST_SITES: usize = 512;
pub(crate) const MOST_ROOMS: usize = 64;
pub(crate) const MOST_OBJECTS: usize = 24;
pub(crate) const MOST_LACKS: usize = 8;
const MOST_ITEMS: usize = 12;
pub(crate) const MOST_TARGETS: usize = 24;
/// Spots from this number on are things on a floor: each is walked up to individually.
const FLOOR: u16 = 0x8000;

/// A place that has not been looked at.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Site {
    /// The spot to walk up to; `None` for the floor.
    pub(crate) spot: Option<u16>,
    /// Whether it must be opened to be seen; otherwise entering its room shows it.
    pub(crate) shut: bool,
}

/// A place where something is to be put.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Target {
    pub(crate) spot: u16,
    pub(crate) room: u8,
    /// The site that must be opened to put something there.
    pub(crate) door: Option<u16>,
}

/// A number of lacking things of one kind, and their target; without a target, holding one is enough.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Lacking {
    pub(crate) left: u8,
    pub(crate) target: Option<u8>,
}

/// A thing that would serve, with the probability that it is at each site.
#[derive(Debug, Clone)]
pub(crate) struct SoughtObject {
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

/// A move of the search.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Move {
    /// Walk to a spot in a room not seen yet; to the room itself if there is no spot.
    Visit { room: u8, spot: Option<u16> },
    /// Walk up to a closed site and open it.
    Open(u16),
    /// Fetch a known item.
    Fetch(u8),
    /// Bring a held thing to its target.
    Deliver(u8),
}

/// The whole search, as far as it is known.
#[derive(Debug, Clone, Default)]
pub(crate) struct ObjectSearch {
    /// Sorted by room; in each room the visible sites first, then the closed ones, likeliest first.
    pub(crate) sites: Vec<Site>,
    /// The sites of each room, and the index from which on they are closed.
    pub(crate) rooms: Vec<(Range<u16>, u16)>,
    pub(crate) targets: Vec<Target>,
    pub(crate) lacks: Vec<Lacking>,
    pub(crate) sought_objects: Vec<SoughtObject>,
    pub(crate) items: Vec<Item>,
    /// Targets of the held things.
    pub(crate) hands: Vec<u8>,
    /// The number of hands that hold something else.
    pub(crate) blocked: u8,
    /// The agent's room, and the spots that are at hand at first.
    pub(crate) room: u8,
    pub(crate) near: Vec<u16>,
    /// Cost of opening: one, or two where the container is closed again.
    pub(crate) opening: u32,
    /// For each set of lacks (bits) and each site, the expected number of these things there.
    pub(crate) values: Vec<f64>,
    /// For each set of lacks and each room, the expected result of entering the room.
    pub(crate) outlooks: Vec<Outlook>,
    /// The room of each site.
    pub(crate) room_of: Vec<u8>,
}

/// The expected result of entering a room.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Outlook {
    /// The expected number of lacking things in view.
    value: f64,
    /// The likeliest spot that can be walked up to, if there is any.
    spot: Option<u16>,
}

/// Number of homes for the rollouts at each stage of the contest.
const STAGES: [usize; 3] = [6, 18, 48];
/// Largest number of homes if all of them are enumerated.
const ALL: usize = 72;
/// Number of candidates that are tried.
const CANDIDATES: usize = 10;
/// A rollout of this many actions is cut short.
const LONGEST: u32 = 2_000;

impl ObjectSearch {
    /// The best next move; `None` if there is nothing to look at or to handle.
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
                let each = worlds[played..end].iter().map(|world| world.chance * start.played(self, world, candidate));
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
        for object in &self.sought_objects {
            for (sums, chance) in chances.iter_mut().zip(&object.chances) {
                let sum = &mut sums[object.lack as usize];
                // The probability that at least one is there.
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
        self.room_of = vec![0; number];
        for (room, (range, _)) in (0u8..).zip(&self.rooms) {
            self.room_of[range.start as usize..range.end as usize].fill(room);
        }
        let sets = 0..1usize << self.lacks.len();
        let search = &*self;
        let outlooks = sets.flat_map(|set| search.rooms.iter().map(move |room| search.look_into(set, room))).collect();
        self.outlooks = outlooks;
        for (range, shut) in &self.rooms {
            debug_assert!(self.sites[range.start as usize..*shut as usize].iter().all(|s| !s.shut));
            debug_assert!(self.sites[*shut as usize..range.end as usize].iter().all(|s| s.shut));
        }
    }

    /// The candidate moves, the base policy's choice first.
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

    /// Collects the looks in a room with their values.
    fn looks(&self, play: &Play, room: u8, full: bool, looks: &mut Vec<(f64, Move)>) {
        let (range, shut) = &self.rooms[room as usize];
        let fresh = play.entered >> room & 1 == 0;
        let outlook = if fresh { play.outlook(self, room) } else { Outlook::default() };
        let surfaces = outlook.value;
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
            looks.push((worth, Move::Visit { room, spot: outlook.spot }));
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

    /// The expected result of entering a room for a set of lacks.
    fn look_into(&self, set: usize, (range, shut): &(Range<u16>, u16)) -> Outlook {
        let value = |s: &u16| self.values[set * self.sites.len() + *s as usize];
        let spots = (range.start..*shut).filter(|&s| self.sites[s as usize].spot.is_some());
        let best = spots.max_by(|a, b| value(a).total_cmp(&value(b)).then(b.cmp(a)));
        let value = (range.start..*shut).map(|s| value(&s)).sum();
        Outlook { value, spot: best.and_then(|s| self.sites[s as usize].spot) }
    }
}

/// Keeps the better half of the candidates, always including the base policy's choice, in order.
fn halve(moves: &mut Vec<Move>, costs: &mut Vec<f64>) {
    let mut order: Vec<usize> = (0..moves.len()).collect();
    order.sort_by(|&a, &b| costs[a].total_cmp(&costs[b]).then(a.cmp(&b)));
    order.truncate(moves.len().div_ceil(2).max(2));
    order.sort_unstable();
    *moves = order.iter().map(|&i| moves[i]).collect();
    *costs = order.iter().map(|&i| costs[i]).collect();
}
