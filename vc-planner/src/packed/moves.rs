//! The macros that may help in a packed state.

use super::{Op, Problem, State, Way, bit, ones};

impl Problem {
    /// Lists all macros that may help.
    pub(crate) fn ops(&self, s: &State, ops: &mut Vec<Op>) {
        ops.clear();
        if let Some(op) = self.forced(s) {
            ops.push(op);
            return;
        }
        self.hand_ops(s, ops);
        if s.free_hand() {
            let mut rest = s.piles;
            while rest != 0 {
                let p = self.index.pile_of[rest.trailing_zeros() as usize];
                let pile = &self.piles[p as usize];
                rest &= !pile.units;
                if self.index.serves(pile.kind + 1) & s.needs != 0 {
                    ops.push(Op::Fetch(p));
                }
            }
            ops.extend((0..2).filter(|&i| s.down[i as usize] != 0).map(Op::PickUp));
        }
        self.door_ops(s, ops);
        self.switch_ops(s, ops);
        self.use_ops(s, ops);
    }

    /// A macro that can be done at once without loss: delivering a held item that serves only one need, at a spot
    /// at hand.
    fn forced(&self, s: &State) -> Option<Op> {
        for hand in 0..2u8 {
            let serves = self.index.serves(s.hands[hand as usize]) & s.needs;
            if serves == 0 {
                continue;
            }
            let need = self.index.need_of[serves.trailing_zeros() as usize];
            let body = &self.needs[need as usize];
            if serves & !body.units != 0 || body.spots & s.at == 0 {
                continue;
            }
            for (way, how) in (0..).zip(&body.ways) {
                let Way::Put { spot, door, .. } = how else { continue };
                if s.at & bit(*spot) != 0 && s.is_open(*door) {
                    return Some(Op::Deliver { hand, need, way });
                }
            }
        }
        None
    }

    fn hand_ops(&self, s: &State, ops: &mut Vec<Op>) {
        for hand in 0..2u8 {
            let held = s.hands[hand as usize];
            if held == 0 || (hand == 1 && held == s.hands[0]) {
                continue;
            }
            let mut serves = self.index.serves(held) & s.needs;
            while serves != 0 {
                let need = self.index.need_of[serves.trailing_zeros() as usize];
                let body = &self.needs[need as usize];
                serves &= !body.units;
                ops.extend((0..).zip(&body.ways).filter_map(|(way, how)| match how {
                    Way::Put { .. } => Some(Op::Deliver { hand, need, way }),
                    Way::UseHeld { .. } => Some(Op::UseHeld { hand, need }),
                    _ => None,
                }));
            }
            if !s.free_hand() {
                self.put_down_ops(s, hand, ops);
            }
        }
    }

    /// Lists the ways to put an item down with both hands full. A useless item is put down anywhere; a useful
    /// one only if there is something to open, and then at the present position or, if all held items are to go
    /// through closed doors, in front of a door.
    fn put_down_ops(&self, s: &State, hand: u8, ops: &mut Vec<Op>) {
        let useless = self.index.serves(s.hands[hand as usize]) & (s.needs | self.index.keeps) == 0;
        if useless {
            let surface = |i: &u8| self.spots[*i as usize].surface;
            ops.extend((0..self.spots.len() as u8).filter(surface).map(|spot| Op::PutDown { hand, spot: Some(spot) }));
        }
        let worth = self.worth_opening(s);
        if useless || worth != 0 {
            ops.push(Op::PutDown { hand, spot: None });
        }
        if !useless && worth != 0 && !s.hands.iter().any(|&held| self.can_be_delivered(s, held)) {
            let before = ones(worth).map(|d| self.doors[d].spot).filter(|spot| s.at & bit(*spot) == 0);
            ops.extend(before.map(|spot| Op::PutDown { hand, spot: Some(spot) }));
        }
    }

    /// Whether a held item can be delivered without opening a door.
    fn can_be_delivered(&self, s: &State, held: u8) -> bool {
        let open = |way: &Way| matches!(way, Way::Put { door, .. } if s.is_open(*door));
        let needs = ones(self.index.serves(held) & s.needs).map(|unit| self.index.need_of[unit]);
        needs.into_iter().any(|need| self.needs[need as usize].ways.iter().any(open))
    }

    /// Closed doors that are to be open at the end or have something needed behind them.
    fn worth_opening(&self, s: &State) -> u64 {
        let mut worth = self.index.wanted.open & !s.open;
        for (d, passage) in self.index.doors.iter().enumerate() {
            let leads = (s.piles & passage.behind) | (s.needs & passage.through) != 0;
            worth |= (u64::from(leads) << d) & !s.open;
        }
        worth
    }

    fn door_ops(&self, s: &State, ops: &mut Vec<Op>) {
        if s.free_hand() {
            ops.extend(ones(self.worth_opening(s)).map(|d| Op::Open(d as u8)));
        }
        ops.extend(ones(s.open & self.index.wanted.closed).map(|d| Op::Close(d as u8)));
    }

    fn switch_ops(&self, s: &State, ops: &mut Vec<Op>) {
        let wanted = &self.index.wanted;
        let wrong = wanted.on & !s.on | wanted.off & s.on;
        ops.extend(ones(wrong | self.index.bars & s.on).map(|w| Op::Flip(w as u8)));
    }

    fn use_ops(&self, s: &State, ops: &mut Vec<Op>) {
        let mut rest = s.needs & self.index.uses;
        while rest != 0 {
            let need = self.index.need_of[rest.trailing_zeros() as usize];
            let body = &self.needs[need as usize];
            rest &= !body.units;
            if body.units & self.last != 0 && !self.is_all_but_last(s) {
                continue;
            }
            let open = |way: &Way| matches!(way, Way::Use { bit: b, .. } if s.used & bit(*b) == 0);
            ops.extend((0..).zip(&body.ways).filter(|(_, w)| open(w)).map(|(way, _)| Op::Use { need, way }));
        }
    }
}
