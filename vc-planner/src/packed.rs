//! The packed state of a planning problem: the relevant part of a scene in a few words.
//!
//! Without its irrelevant parts, a household goal is a pickup and delivery problem with two hands: items lie in
//! piles at spots, some behind doors, and are needed elsewhere. [`Problem`] is the constant part of it,
//! [`State`] the part that actions change, and an [`Op`] is a macro: the actions at one spot, with the walk and
//! the opening that they need.
//!
//! Numbers are stored in unary: a need of three is three bits, a pile of two is two bits. The remaining needs
//! and the remaining items are one word each, and counting is a population count.

mod apply;
mod index;
mod moves;

use vc_graph::{NodeId, Verb};

use crate::small_list::SmallList;

use index::Index;

/// Largest number of piles and of needs of a problem, and of units in all needs and in all piles; the rest of
/// larger goals is packed when the plan for these ends.
pub(crate) const MOST: usize = 32;
pub(crate) const UNITS: usize = 64;
/// Largest number of spots, doors, switches and uses: they are bits of a word.
pub(crate) const BITS: usize = 64;
/// Cost of an action. The lower bits break ties: a change of room, a thing left on the floor.
pub(crate) const ACTION: u32 = 1 << FINE;
pub(crate) const FINE: u32 = 4;

/// A thing that can be walked up to; its contents are then at hand.
#[derive(Debug, Clone)]
pub(crate) struct Spot {
    pub(crate) anchor: NodeId,
    pub(crate) room: Option<NodeId>,
    /// The spot itself and the spots at hand with it, as bits.
    pub(crate) reach: u64,
    /// Whether something can be put down here temporarily.
    pub(crate) surface: bool,
}

/// A container that opens.
#[derive(Debug, Clone)]
pub(crate) struct Door {
    pub(crate) node: NodeId,
    pub(crate) spot: u8,
    /// Its switch, if it must be off before the door opens.
    pub(crate) unsafe_when_on: Option<u8>,
    /// The wanted final state.
    pub(crate) wanted: Option<bool>,
}

/// A thing that is on or off.
#[derive(Debug, Clone)]
pub(crate) struct Switch {
    pub(crate) node: NodeId,
    pub(crate) spot: u8,
    pub(crate) door: Option<u8>,
    pub(crate) wanted: Option<bool>,
}

/// Interchangeable items at one spot.
#[derive(Debug, Clone)]
pub(crate) struct Pile {
    pub(crate) kind: u8,
    pub(crate) spot: u8,
    pub(crate) door: Option<u8>,
    /// One item for each bit.
    pub(crate) items: SmallList,
    pub(crate) units: u64,
}

/// One way to serve a need.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Way {
    /// An item of a serving kind is put at a place.
    Put { verb: Verb, at: NodeId, spot: u8, door: Option<u8> },
    /// An action is done to a thing at its place; `bit` records that it has been done.
    Use { verb: Verb, on: Option<NodeId>, spot: Option<u8>, door: Option<u8>, bit: u8 },
    /// An action is done with a held item.
    UseHeld { verb: Verb },
    /// An item is held at the end.
    Keep,
}

/// A need of as many items or uses as it has bits.
#[derive(Debug, Clone)]
pub(crate) struct Need {
    pub(crate) ways: Vec<Way>,
    pub(crate) units: u64,
    /// The spots of its ways.
    pub(crate) spots: u64,
}

/// The constant part of a problem.
#[derive(Debug, Clone, Default)]
pub(crate) struct Problem {
    pub(crate) spots: Vec<Spot>,
    pub(crate) doors: Vec<Door>,
    pub(crate) switches: Vec<Switch>,
    pub(crate) piles: Vec<Pile>,
    pub(crate) needs: Vec<Need>,
    /// For each kind of item, the needs it serves.
    pub(crate) kinds: Vec<u32>,
    /// The items held at first.
    pub(crate) held: [Option<NodeId>; 2],
    /// Whether one item can serve two needs at one place, so that sums would count it twice.
    pub(crate) shared: bool,
    /// Needs of holding something at the end.
    pub(crate) keeps: u32,
    /// The need, as its bits, that is served after everything else.
    pub(crate) last: u64,
    pub(crate) index: Index,
}

/// The part of a problem that actions change.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct State {
    /// Spots at hand.
    pub(crate) at: u64,
    /// Doors that are open.
    pub(crate) open: u64,
    /// Switches that are on.
    pub(crate) on: u64,
    /// Uses done.
    pub(crate) used: u64,
    /// The remaining units of piles and of needs.
    pub(crate) piles: u64,
    pub(crate) needs: u64,
    /// The kind in each hand plus one; the larger first, since hands are interchangeable.
    pub(crate) hands: [u8; 2],
    /// The kinds that are put down temporarily, plus one.
    pub(crate) down: [u8; 2],
    /// Whether the items put down are still at hand.
    pub(crate) fresh: bool,
    pub(crate) room: u8,
}

/// A macro action.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Op {
    Start,
    Fetch(u8),
    Deliver {
        hand: u8,
        need: u8,
        way: u8,
    },
    Open(u8),
    Close(u8),
    Flip(u8),
    Use {
        need: u8,
        way: u8,
    },
    UseHeld {
        hand: u8,
        need: u8,
    },
    /// Puts an item down at a spot or at the present position; on the floor if there is no surface.
    PutDown {
        hand: u8,
        spot: Option<u8>,
    },
    PickUp(u8),
}

pub(crate) fn bit(i: u8) -> u64 {
    1 << (i & 63)
}

/// The indices of the set bits.
pub(crate) fn ones(mut bits: u64) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let lowest = (bits != 0).then(|| bits.trailing_zeros() as usize);
        bits &= bits.wrapping_sub(1);
        lowest
    })
}

/// The next bits after those in use; fewer if not enough are left.
pub(crate) fn run_of(used: u64, number: usize) -> u64 {
    let free = used.leading_zeros();
    let number = number.min(free as usize) as u32;
    let all = u64::MAX.checked_shr(free - number).unwrap_or(0);
    all & !u64::MAX.checked_shr(free).unwrap_or(0)
}

impl State {
    pub(crate) fn sort_hands(&mut self) {
        if self.hands[0] < self.hands[1] {
            self.hands.swap(0, 1);
        }
    }

    pub(crate) fn free_hand(&self) -> bool {
        self.hands[1] == 0
    }

    pub(crate) fn is_open(&self, door: Option<u8>) -> bool {
        door.is_none_or(|d| self.open & bit(d) != 0)
    }
}

impl Problem {
    /// An empty problem with memory for the usual size of a number of demands.
    pub(crate) fn for_demands(number: usize) -> Self {
        let usual = 2 * number;
        Self {
            spots: Vec::with_capacity(usual),
            doors: Vec::with_capacity(number),
            piles: Vec::with_capacity(usual),
            needs: Vec::with_capacity(number),
            kinds: Vec::with_capacity(number),
            ..Self::default()
        }
    }

    /// The needs served by the kind in a hand; none for an empty hand.
    pub(crate) fn kind(&self, hand: u8) -> u32 {
        match hand {
            0 => 0,
            k => self.kinds.get(k as usize - 1).copied().unwrap_or(0),
        }
    }

    /// The remaining units of a need.
    pub(crate) fn left(&self, s: &State, need: usize) -> u32 {
        (s.needs & self.needs[need].units).count_ones()
    }

    /// Whether all needs are satisfied.
    pub(crate) fn is_goal(&self, s: &State) -> bool {
        s.needs & self.last == 0 && self.is_all_but_last(s)
    }

    /// Whether all needs but the last are satisfied.
    fn is_all_but_last(&self, s: &State) -> bool {
        s.needs & !self.index.keeps & !self.last == 0 && self.left_open(s) == 0 && self.keeps_held(s)
    }

    /// Whether the hands hold the things that are to be held, each item for one need.
    fn keeps_held(&self, s: &State) -> bool {
        if self.keeps == 0 {
            return true;
        }
        let keeps = || ones(u64::from(self.keeps));
        let serves = |hand: u8, need: usize| self.kind(hand) & (1 << need) != 0;
        let single = |need: usize| s.hands.iter().filter(|&&h| serves(h, need)).count() as u32 >= self.left(s, need);
        let useful = s.hands.iter().filter(|&&h| self.kind(h) & self.keeps != 0).count() as u32;
        keeps().all(single) && useful >= (s.needs & self.index.keeps).count_ones()
    }

    /// Doors and switches that are not in their wanted final state.
    fn left_open(&self, s: &State) -> u64 {
        let wanted = &self.index.wanted;
        wanted.open & !s.open | wanted.closed & s.open | wanted.on & !s.on | wanted.off & s.on
    }

    /// A number for the room of a spot.
    pub(crate) fn rooms(&self, spot: u8) -> u8 {
        self.spots[spot as usize].room.map_or(255, |r| (r.0 % 251) as u8)
    }
}
