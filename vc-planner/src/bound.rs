//! How much is at least left to do: a lower bound on the cost to the goal.
//!
//! Counted are: a put and a grab for each item still needed, an opening for each door
//! that must be gone through, closings and switches, and the walks. A spot must be
//! walked to at least once for every two items that go there or come from there,
//! since there are two hands.

use crate::packed::{ACTION, Door, MOST, Problem, State, Way, bit};

/// What is known to happen at each spot.
struct Traffic {
    into: [u8; 64],
    out: [u8; 64],
    /// Spots with any business at all.
    must: u64,
    doors: u64,
    actions: u32,
    /// Some spot of these must be visited.
    some: u64,
}

impl Problem {
    /// A lower bound on the cost of the rest, never too high.
    pub(crate) fn bound(&self, s: &State) -> u32 {
        let pending = self.pending(s);
        let mut t = Traffic { into: [0; 64], out: [0; 64], must: 0, doors: 0, actions: 0, some: 0 };
        self.count_needs(s, pending, &mut t);
        self.count_sources(s, pending, &mut t);
        self.count_doors(s, &mut t);
        let mut walks = 0;
        let mut rest = t.must;
        while rest != 0 {
            let spot = rest.trailing_zeros() as u8;
            rest &= rest - 1;
            walks += u32::from(self.visits(s, spot, &t));
        }
        if walks == 0 && t.some != 0 && t.some & s.at == 0 {
            walks = 1;
        }
        (t.actions + walks) * ACTION
    }

    fn visits(&self, s: &State, spot: u8, t: &Traffic) -> u8 {
        let (into, out) = (t.into[spot as usize], t.out[spot as usize]);
        if s.at & bit(spot) == 0 {
            return into.div_ceil(2).max(out.div_ceil(2)).max(1);
        }
        // What is in the hands can be put here now, and the hands filled.
        let held = s.hands.iter().filter(|&&h| h != 0).count() as u8;
        into.saturating_sub(held).div_ceil(2).max(out.saturating_sub(2).div_ceil(2))
    }

    fn count_needs(&self, s: &State, pending: u32, t: &mut Traffic) {
        let (mut puts, mut most) = (0u32, 0u32);
        for n in ones(pending) {
            let need = &self.needs[n];
            let number = s.needs[n];
            match need.ways.first() {
                Some(Way::Put { .. }) => {
                    (puts, most) = (puts + u32::from(number), most.max(u32::from(number)));
                    if need.spots.is_power_of_two() {
                        let spot = need.spots.trailing_zeros() as usize;
                        t.must |= need.spots;
                        let into = &mut t.into[spot];
                        if !need.local {
                            *into = if self.shared { (*into).max(number) } else { *into + number };
                        }
                        if let [Way::Put { door: Some(d), .. }] = need.ways[..] {
                            t.doors |= bit(d);
                        }
                    } else {
                        t.some |= need.spots;
                    }
                }
                Some(Way::Keep) | None => {}
                Some(_) => {
                    t.actions += u32::from(number);
                    if need.spots.is_power_of_two() && need.ways.len() == 1 {
                        t.must |= need.spots;
                    }
                    if let [Way::Use { door: Some(d), .. }] = need.ways[..] {
                        t.doors |= bit(d);
                    }
                }
            }
        }
        t.actions += if self.shared { most } else { puts };
    }

    /// What must still be grabbed, and from where.
    fn count_sources(&self, s: &State, pending: u32, t: &mut Traffic) {
        let full = (0..self.piles.len()).fold(0u32, |bits, p| bits | u32::from(s.piles[p] > 0) << p);
        let hands = [s.hands[0], s.hands[1], s.down[0], s.down[1]].map(|h| self.kind(h));
        let mut taken = [0u8; MOST];
        let (mut carried, mut from) = (0u32, 0u32);
        for n in ones(pending) {
            let need = &self.needs[n];
            let put = match need.ways.first() {
                Some(Way::Use { .. }) | None => continue,
                Some(Way::UseHeld { .. }) => false,
                Some(_) => true,
            };
            let number = u32::from(s.needs[n]) * u32::from(put);
            carried = if self.shared { carried.max(number) } else { carried + number };
            let in_hands = hands.iter().filter(|&&serves| serves & (1 << n) != 0).count() as u8;
            let short = s.needs[n].saturating_sub(in_hands);
            let piles = need.piles & full;
            if short == 0 || !piles.is_power_of_two() {
                continue;
            }
            let p = piles.trailing_zeros() as usize;
            let pile = &self.piles[p];
            t.must |= bit(pile.spot);
            // Two hands limit what leaves a spot, not what is moved or used there.
            if put && need.spots & bit(pile.spot) == 0 {
                (taken[p], from) = (taken[p].max(short), from | 1 << p);
            }
            if let Some(d) = pile.door {
                t.doors |= bit(d);
            }
        }
        for p in ones(from) {
            let out = &mut t.out[self.piles[p].spot as usize];
            *out = out.saturating_add(taken[p]);
        }
        let useful = hands[..2].iter().filter(|&&serves| serves & pending != 0).count() as u32;
        t.actions += carried.saturating_sub(useful);
    }

    fn count_doors(&self, s: &State, t: &mut Traffic) {
        let shut = t.doors & !s.open;
        let extra = self.wanted.closed & (s.open | t.doors) | self.wanted.open & !s.open & !t.doors;
        t.actions += shut.count_ones() + extra.count_ones();
        let mut rest = extra;
        while rest != 0 {
            t.must |= bit(self.doors[rest.trailing_zeros() as usize].spot);
            rest &= rest - 1;
        }
        let wrong = self.wanted.on & !s.on | self.wanted.off & s.on;
        if s.on | wrong == 0 {
            return;
        }
        for (i, switch) in self.switches.iter().enumerate() {
            let b = bit(i as u8);
            let bars = |(d, door): (usize, &Door)| door.unsafe_when_on == Some(i as u8) && shut & bit(d as u8) != 0;
            let barring = s.on & b != 0 && self.doors.iter().enumerate().any(bars);
            if wrong & b != 0 || barring {
                t.actions += 1 + u32::from(barring && switch.want == Some(true));
                t.must |= bit(switch.spot);
            }
        }
    }
}

/// The numbers of the bits that are set.
fn ones(mut bits: u32) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let lowest = (bits != 0).then(|| bits.trailing_zeros() as usize);
        bits &= bits.wrapping_sub(1);
        lowest
    })
}
