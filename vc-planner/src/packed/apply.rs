//! Effects and costs of macros on a packed state.

use super::{ACTION, Op, Problem, State, Way, bit, ones};

/// Cost of a walk into another room beyond that of a walk within a room.
const ROOM: u32 = 1;
/// Cost of dropping a thing beyond that of putting it down.
const UNTIDY: u32 = 2;

impl Problem {
    /// Applies a macro and returns its cost; `None` if it cannot be done.
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
            Op::Use { need, way } => self.make_use(s, need, way),
            Op::UseHeld { need, .. } => {
                self.serve(s, need as usize);
                Some(ACTION)
            }
            Op::PutDown { hand, spot } => self.put_down(s, hand, spot),
            Op::PickUp(slot) => Some(pick_up(s, slot)),
        }
    }

    /// Removes one unit of a need.
    fn serve(&self, s: &mut State, need: usize) {
        let left = s.needs & self.needs[need].units;
        s.needs ^= left & left.wrapping_neg();
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

    fn open_door(&self, s: &mut State, door: Option<u8>) -> Option<u32> {
        let Some(d) = door.filter(|_| !s.is_open(door)) else { return Some(0) };
        let barred = self.doors[d as usize].unsafe_when_on.is_some_and(|w| s.on & bit(w) != 0);
        if barred || !s.free_hand() {
            return None;
        }
        s.open |= bit(d);
        Some(ACTION)
    }

    fn fetch(&self, s: &mut State, p: u8) -> Option<u32> {
        let pile = &self.piles[p as usize];
        let left = s.piles & pile.units;
        if !s.free_hand() || left == 0 {
            return None;
        }
        let walk = self.go(s, pile.spot);
        let open = self.open_door(s, pile.door)?;
        s.piles ^= left & left.wrapping_neg();
        s.hands[1] = pile.kind + 1;
        s.sort_hands();
        Some(walk + open + ACTION)
    }

    fn deliver(&self, s: &mut State, hand: u8, need: u8, way: u8) -> Option<u32> {
        let how = &self.needs[need as usize].ways[way as usize];
        let Way::Put { spot, door, .. } = *how else { return None };
        let walk = self.go(s, spot);
        let open = self.open_door(s, door)?;
        if self.shared {
            let kind = u64::from(self.kind(s.hands[hand as usize]));
            let there = |n: &usize| self.needs[*n].ways.contains(how);
            ones(kind & !(1 << need)).filter(there).for_each(|n| self.serve(s, n));
        }
        self.serve(s, need as usize);
        s.hands[hand as usize] = 0;
        s.sort_hands();
        Some(walk + open + ACTION)
    }

    fn make_use(&self, s: &mut State, need: u8, way: u8) -> Option<u32> {
        let Way::Use { spot, door, bit: b, .. } = self.needs[need as usize].ways[way as usize] else { return None };
        let walk = spot.map_or(0, |spot| self.go(s, spot));
        let open = self.open_door(s, door)?;
        s.used |= bit(b);
        self.serve(s, need as usize);
        Some(walk + open + ACTION)
    }

    fn put_down(&self, s: &mut State, hand: u8, spot: Option<u8>) -> Option<u32> {
        let tidy = spot.is_some_and(|spot| self.spots[spot as usize].surface);
        let untidy = if tidy { 0 } else { UNTIDY };
        let walk = spot.map_or(0, |spot| self.go(s, spot));
        let kind = s.hands[hand as usize];
        if self.kind(kind) != 0 {
            // A useful item must be picked up again: there are two slots for such items.
            let slot = s.down.iter().position(|&d| d == 0)?;
            if s.down[1 - slot] != 0 && !s.fresh {
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
}

fn pick_up(s: &mut State, slot: u8) -> u32 {
    let walk = if s.fresh { 0 } else { ACTION };
    if !s.fresh {
        s.at = 0;
    }
    s.hands[1] = s.down[slot as usize];
    s.down[slot as usize] = 0;
    s.down.sort_unstable_by(|a, b| b.cmp(a));
    s.sort_hands();
    walk + ACTION
}
