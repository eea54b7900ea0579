//! The packed state of a planning problem: what matters of a scene, in a few words.
//!
//! A household goal is, after what does not matter is taken away, a pickup and
//! delivery problem with two hands: items lie in piles at spots, some behind doors,
//! and are needed elsewhere. [`Problem`] is the constant part of it, [`State`] the
//! part that actions change, and an [`Op`] is a macro: what is done at one spot,
//! with the walk and the opening that it takes.

use vc_graph::{NodeId, Verb};

/// Most piles, needs and bits of a problem; larger goals are planned in parts.
pub(crate) const MOST: usize = 32;
/// Most spots, doors, switches and uses: they are bits of a word.
pub(crate) const BITS: usize = 64;
/// What an action costs. The rest is for breaking ties: a change of room, a thing
/// left on the floor.
pub(crate) const ACTION: u32 = 16;
/// A walk into another room is a little worse than one within it.
const ROOM: u32 = 1;
/// Putting down is better manners than dropping.
const UNTIDY: u32 = 2;

/// A thing one walks up to; what rests on or in it is then at hand.
#[derive(Debug, Clone)]
pub(crate) struct Spot {
    pub(crate) anchor: NodeId,
    pub(crate) room: Option<NodeId>,
    /// Itself and what is at hand with it, as bits.
    pub(crate) reach: u64,
    /// Something can be put down here for a while without harm.
    pub(crate) surface: bool,
}

/// A container that opens.
#[derive(Debug, Clone)]
pub(crate) struct Door {
    pub(crate) node: NodeId,
    pub(crate) spot: u8,
    /// Its switch, if it must be off for it to open.
    pub(crate) unsafe_when_on: Option<u8>,
    /// How it is to be left.
    pub(crate) want: Option<bool>,
}

/// Something that is on or off.
#[derive(Debug, Clone)]
pub(crate) struct Switch {
    pub(crate) node: NodeId,
    pub(crate) spot: u8,
    pub(crate) door: Option<u8>,
    pub(crate) want: Option<bool>,
}

/// Interchangeable items at one spot.
#[derive(Debug, Clone)]
pub(crate) struct Pile {
    pub(crate) kind: u8,
    pub(crate) spot: u8,
    pub(crate) door: Option<u8>,
    pub(crate) items: Vec<NodeId>,
}

/// One way to serve a need.
#[derive(Debug, Clone)]
pub(crate) enum Way {
    /// An item of a serving kind is put there.
    Put { verb: Verb, at: NodeId, spot: u8, door: Option<u8> },
    /// Something is done to a thing where it is; `bit` says that it has been done.
    Use { verb: Verb, on: Option<NodeId>, spot: Option<u8>, door: Option<u8>, bit: u8 },
    /// Something is done with an item in the hand.
    UseHeld { verb: Verb },
    /// It is held in the end.
    Keep,
}

/// So many of something are needed.
#[derive(Debug, Clone)]
pub(crate) struct Need {
    pub(crate) number: u8,
    pub(crate) ways: Vec<Way>,
    /// The spots of its ways.
    pub(crate) spots: u64,
    /// Some item that serves it lies where it is needed, so that no trip is saved by
    /// a free hand.
    pub(crate) local: bool,
    /// The piles that serve it, as bits.
    pub(crate) piles: u32,
}

/// What is wanted of doors and switches, as bits.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Wanted {
    pub(crate) open: u64,
    pub(crate) closed: u64,
    pub(crate) on: u64,
    pub(crate) off: u64,
}

/// What is constant about a problem.
#[derive(Debug, Clone, Default)]
pub(crate) struct Problem {
    pub(crate) spots: Vec<Spot>,
    pub(crate) doors: Vec<Door>,
    pub(crate) switches: Vec<Switch>,
    pub(crate) piles: Vec<Pile>,
    pub(crate) needs: Vec<Need>,
    /// For each kind of item the needs it serves.
    pub(crate) kinds: Vec<u32>,
    /// What is in the hands at first.
    pub(crate) held: [Option<NodeId>; 2],
    /// One item can serve two needs at one place: sums would count twice.
    pub(crate) shared: bool,
    /// Needs that are about holding something in the end.
    pub(crate) keeps: u32,
    pub(crate) wanted: Wanted,
}

/// What actions change.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub(crate) struct State {
    /// Spots at hand.
    pub(crate) at: u64,
    /// Doors that are open.
    pub(crate) open: u64,
    /// Switches that are on.
    pub(crate) on: u64,
    /// Uses done.
    pub(crate) used: u64,
    pub(crate) piles: [u8; MOST],
    pub(crate) needs: [u8; MOST],
    /// Kind in each hand, plus one; the larger first, as hands are alike.
    pub(crate) hands: [u8; 2],
    /// Kinds put down for a while, plus one.
    pub(crate) down: [u8; 2],
    /// Those put down are still at hand.
    pub(crate) fresh: bool,
    pub(crate) room: u8,
}

/// A macro.
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
    /// Puts down at a spot, or drops where one stands.
    PutDown {
        hand: u8,
        spot: Option<u8>,
    },
    PickUp(u8),
}

pub(crate) fn bit(i: u8) -> u64 {
    1 << (i & 63)
}

impl State {
    pub(crate) fn sort_hands(&mut self) {
        if self.hands[0] < self.hands[1] {
            self.hands.swap(0, 1);
        }
    }

    fn free_hand(&self) -> bool {
        self.hands[1] == 0
    }

    fn is_open(&self, door: Option<u8>) -> bool {
        door.is_none_or(|d| self.open & bit(d) != 0)
    }
}

impl Problem {
    pub(crate) fn kind(&self, hand: u8) -> u32 {
        match hand {
            0 => 0,
            k => self.kinds.get(k as usize - 1).copied().unwrap_or(0),
        }
    }

    /// The needs that are still open, as bits; held ones are never closed.
    pub(crate) fn pending(&self, s: &State) -> u32 {
        let open = |i: &usize| s.needs[*i] > 0;
        (0..self.needs.len()).filter(open).fold(0, |bits, i| bits | (1 << i))
    }

    /// Whether everything needed is so.
    pub(crate) fn is_goal(&self, s: &State) -> bool {
        let served = (0..self.needs.len()).all(|i| s.needs[i] == 0 || self.keeps & (1 << i) != 0);
        served && self.keeps_held(s) && self.doors_left(s) == 0 && self.switches_left(s) == 0
    }

    /// Whether the hands hold what is to be held, each item for one need.
    fn keeps_held(&self, s: &State) -> bool {
        if self.keeps == 0 {
            return true;
        }
        let wanted: u32 =
            (0..self.needs.len()).filter(|i| self.keeps & (1 << i) != 0).map(|i| u32::from(s.needs[i])).sum();
        let serves = |hand: u8, need: usize| self.kind(hand) & self.keeps & (1 << need) != 0;
        let single = |need: usize| s.hands.iter().filter(|&&h| serves(h, need)).count() >= s.needs[need] as usize;
        let each = (0..self.needs.len()).filter(|i| self.keeps & (1 << i) != 0).all(single);
        let useful = s.hands.iter().filter(|&&h| self.kind(h) & self.keeps != 0).count() as u32;
        each && useful >= wanted
    }

    fn doors_left(&self, s: &State) -> u32 {
        (self.wanted.open & !s.open | self.wanted.closed & s.open).count_ones()
    }

    fn switches_left(&self, s: &State) -> u32 {
        (self.wanted.on & !s.on | self.wanted.off & s.on).count_ones()
    }

    /// Gathers what is asked for again and again into bits; when all else is there.
    pub(crate) fn index(&mut self) {
        let bits = |wanted: &mut dyn Iterator<Item = bool>| {
            (0..).zip(wanted).fold(0, |all, (i, w)| all | if w { bit(i) } else { 0 })
        };
        self.wanted = Wanted {
            open: bits(&mut self.doors.iter().map(|d| d.want == Some(true))),
            closed: bits(&mut self.doors.iter().map(|d| d.want == Some(false))),
            on: bits(&mut self.switches.iter().map(|w| w.want == Some(true))),
            off: bits(&mut self.switches.iter().map(|w| w.want == Some(false))),
        };
        for n in 0..self.needs.len() {
            let serves = |p: &Pile| self.kinds[p.kind as usize] & (1 << n) != 0;
            self.needs[n].piles = bits(&mut self.piles.iter().map(serves)) as u32;
        }
    }

    /// Walks to a spot unless it is at hand.
    fn go(&self, s: &mut State, spot: u8) -> u32 {
        if s.at & bit(spot) != 0 {
            return 0;
        }
        let room = self.rooms(spot);
        let other = u32::from(room != s.room) * ROOM;
        (s.at, s.room, s.fresh) = (self.spots[spot as usize].reach, room, false);
        ACTION + other
    }

    /// A number for the room of a spot.
    pub(crate) fn rooms(&self, spot: u8) -> u8 {
        self.spots[spot as usize].room.map_or(255, |r| (r.0 % 251) as u8)
    }

    fn open_door(&self, s: &mut State, door: Option<u8>) -> Option<u32> {
        let Some(d) = door.filter(|_| !s.is_open(door)) else { return Some(0) };
        let barred = self.doors[d as usize].unsafe_when_on.is_some_and(|w| s.on & bit(w) != 0);
        if barred || !s.free_hand() {
            return None;
        }
        s.open |= bit(d);
        Some(ACTION)
    }

    /// Carries a macro out; `None` if it cannot be done. Returns its cost.
    pub(crate) fn apply(&self, s: &mut State, op: Op) -> Option<u32> {
        match op {
            Op::Start => Some(0),
            Op::Fetch(p) => self.fetch(s, p),
            Op::Deliver { hand, need, way } => self.deliver(s, hand, need, way),
            Op::Open(d) => {
                let walk = self.go(s, self.doors[d as usize].spot);
                Some(walk + self.open_door(s, Some(d))?)
            }
            Op::Close(d) => {
                let walk = self.go(s, self.doors[d as usize].spot);
                s.open &= !bit(d);
                Some(walk + ACTION)
            }
            Op::Flip(w) => {
                let switch = &self.switches[w as usize];
                let walk = self.go(s, switch.spot);
                let open = self.open_door(s, switch.door)?;
                s.on ^= bit(w);
                Some(walk + open + ACTION)
            }
            Op::Use { need, way } => {
                let Way::Use { spot, door, bit: b, .. } = self.needs[need as usize].ways[way as usize] else {
                    return None;
                };
                let walk = spot.map_or(0, |spot| self.go(s, spot));
                let open = self.open_door(s, door)?;
                s.used |= bit(b);
                s.needs[need as usize] -= 1;
                Some(walk + open + ACTION)
            }
            Op::UseHeld { need, .. } => {
                s.needs[need as usize] -= 1;
                Some(ACTION)
            }
            Op::PutDown { hand, spot } => self.put_down(s, hand, spot),
            Op::PickUp(slot) => {
                let walk = if s.fresh { 0 } else { ACTION };
                if !s.fresh {
                    s.at = 0;
                }
                s.hands[1] = s.down[slot as usize];
                s.down[slot as usize] = 0;
                s.down.sort_unstable_by(|a, b| b.cmp(a));
                s.sort_hands();
                Some(walk + ACTION)
            }
        }
    }

    fn fetch(&self, s: &mut State, p: u8) -> Option<u32> {
        let pile = &self.piles[p as usize];
        if !s.free_hand() || s.piles[p as usize] == 0 {
            return None;
        }
        let walk = self.go(s, pile.spot);
        let open = self.open_door(s, pile.door)?;
        s.piles[p as usize] -= 1;
        s.hands[1] = pile.kind + 1;
        s.sort_hands();
        Some(walk + open + ACTION)
    }

    fn deliver(&self, s: &mut State, hand: u8, need: u8, way: u8) -> Option<u32> {
        let Way::Put { at, spot, door, .. } = self.needs[need as usize].ways[way as usize] else { return None };
        let walk = self.go(s, spot);
        let open = self.open_door(s, door)?;
        let kind = self.kind(s.hands[hand as usize]);
        for (i, other) in self.needs.iter().enumerate() {
            let there = |w: &Way| {
                matches!(w, Way::Put { at: a, verb: v, .. } if *a == at
                && matches!(&self.needs[need as usize].ways[way as usize], Way::Put { verb, .. } if verb == v))
            };
            let served = i == need as usize || (self.shared && kind & (1 << i) != 0 && other.ways.iter().any(there));
            s.needs[i] -= u8::from(served && s.needs[i] > 0);
        }
        s.hands[hand as usize] = 0;
        s.sort_hands();
        Some(walk + open + ACTION)
    }

    fn put_down(&self, s: &mut State, hand: u8, spot: Option<u8>) -> Option<u32> {
        let untidy = if spot.is_some() { 0 } else { UNTIDY };
        let walk = spot.map_or(0, |spot| self.go(s, spot));
        let kind = s.hands[hand as usize];
        if self.kind(kind) != 0 {
            // A useful thing must be picked up again: there are two places for such.
            let slot = s.down.iter().position(|&d| d == 0)?;
            let other = s.down[1 - slot];
            if other != 0 && !s.fresh {
                return None;
            }
            s.down[slot] = kind;
            s.fresh = true;
            s.down.sort_unstable_by(|a, b| b.cmp(a));
        }
        s.hands[hand as usize] = 0;
        s.sort_hands();
        Some(walk + ACTION + untidy)
    }

    /// All macros that may help.
    pub(crate) fn ops(&self, s: &State, ops: &mut Vec<Op>) {
        ops.clear();
        let pending = self.pending(s);
        if let Some(op) = self.forced(s, pending) {
            ops.push(op);
            return;
        }
        self.hand_ops(s, pending, ops);
        if s.free_hand() {
            for (p, pile) in self.piles.iter().enumerate() {
                if s.piles[p] > 0 && self.kinds[pile.kind as usize] & pending != 0 {
                    ops.push(Op::Fetch(p as u8));
                }
            }
            ops.extend((0..2).filter(|&i| s.down[i as usize] != 0).map(Op::PickUp));
        }
        self.place_ops(s, pending, ops);
    }

    /// What costs nothing to do at once: delivering what is at hand and serves nothing
    /// else.
    fn forced(&self, s: &State, pending: u32) -> Option<Op> {
        for hand in 0..2u8 {
            let serves = self.kind(s.hands[hand as usize]) & pending;
            if serves.count_ones() != 1 {
                continue;
            }
            let need = serves.trailing_zeros() as u8;
            for (way, how) in self.needs[need as usize].ways.iter().enumerate() {
                let Way::Put { spot, door, .. } = how else { continue };
                if s.at & bit(*spot) != 0 && s.is_open(*door) {
                    return Some(Op::Deliver { hand, need, way: way as u8 });
                }
            }
        }
        None
    }

    fn hand_ops(&self, s: &State, pending: u32, ops: &mut Vec<Op>) {
        for hand in 0..2u8 {
            let held = s.hands[hand as usize];
            if held == 0 || (hand == 1 && held == s.hands[0]) {
                continue;
            }
            let mut serves = self.kind(held) & pending;
            while serves != 0 {
                let need = serves.trailing_zeros() as u8;
                serves &= serves - 1;
                for (way, how) in self.needs[need as usize].ways.iter().enumerate() {
                    match how {
                        Way::Put { .. } => ops.push(Op::Deliver { hand, need, way: way as u8 }),
                        Way::UseHeld { .. } => ops.push(Op::UseHeld { hand, need }),
                        _ => {}
                    }
                }
            }
            if !s.free_hand() {
                self.put_down_ops(s, pending, hand, ops);
            }
        }
    }

    /// With both hands full: what is of no use is put down anywhere; what is, only where
    /// one stands and only if there is something to open.
    fn put_down_ops(&self, s: &State, pending: u32, hand: u8, ops: &mut Vec<Op>) {
        let useless = self.kind(s.hands[hand as usize]) & (pending | self.keeps) == 0;
        if useless {
            let surface = |i: &u8| self.spots[*i as usize].surface;
            ops.extend((0..self.spots.len() as u8).filter(surface).map(|spot| Op::PutDown { hand, spot: Some(spot) }));
        }
        let shut = |d: &u8| s.open & bit(*d) == 0;
        let wanted = |d: &u8| self.doors[*d as usize].want == Some(true) || self.leads_somewhere(s, *d, pending);
        if useless || (0..self.doors.len() as u8).filter(shut).any(|d| wanted(&d)) {
            ops.push(Op::PutDown { hand, spot: None });
        }
    }

    fn place_ops(&self, s: &State, pending: u32, ops: &mut Vec<Op>) {
        for (i, door) in self.doors.iter().enumerate() {
            let (d, open) = (i as u8, s.open & bit(i as u8) != 0);
            if !open && s.free_hand() && (door.want == Some(true) || self.leads_somewhere(s, d, pending)) {
                ops.push(Op::Open(d));
            }
            if open && door.want == Some(false) {
                ops.push(Op::Close(d));
            }
        }
        for (i, switch) in self.switches.iter().enumerate() {
            let wrong = switch.want.is_some_and(|on| on != (s.on & bit(i as u8) != 0));
            let bars = self.doors.iter().any(|d| d.unsafe_when_on == Some(i as u8)) && s.on & bit(i as u8) != 0;
            if wrong || bars {
                ops.push(Op::Flip(i as u8));
            }
        }
        for (n, need) in self.needs.iter().enumerate().filter(|(n, _)| pending & (1 << n) != 0) {
            for (w, way) in need.ways.iter().enumerate() {
                if matches!(way, Way::Use { bit: b, .. } if s.used & bit(*b) == 0) {
                    ops.push(Op::Use { need: n as u8, way: w as u8 });
                }
            }
        }
    }

    /// Whether something still needed goes through a door.
    fn leads_somewhere(&self, s: &State, d: u8, pending: u32) -> bool {
        let behind = |(p, pile): (usize, &Pile)| pile.door == Some(d) && s.piles[p] > 0;
        let into = |w: &Way| matches!(w, Way::Put { door: Some(x), .. } if *x == d);
        let target = |(n, need): (usize, &Need)| pending & (1 << n) != 0 && need.ways.iter().any(into);
        self.piles.iter().enumerate().any(behind) || self.needs.iter().enumerate().any(target)
    }
}
