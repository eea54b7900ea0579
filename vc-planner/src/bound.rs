//! A lower bound on the remaining cost to the goal.
//!
//! The bound counts a put and a grab for each item still needed, an opening for each door on the way to an item
//! or a target, closings and switches, and the walks. Since there are two hands, a spot must be walked to at
//! least once for every two items that are brought there or taken from there.

use crate::packed::{ACTION, BITS, MOST, Need, Problem, State, ones};

/// The necessary work, whatever the plan.
struct Must {
    /// Spots at which there is anything to do.
    spots: u64,
    doors: u64,
    actions: u32,
    /// Items taken from each spot for which several piles could have served.
    out: [u8; BITS],
    /// Spots that `out` covers.
    chosen: u64,
}

impl Problem {
    /// A lower bound on the cost of the rest; it is admissible.
    pub(crate) fn bound(&self, s: &State) -> u32 {
        let index = &self.index;
        let hands = index.serves(s.hands[0]) | index.serves(s.hands[1]);
        let down = index.serves(s.down[0]) | index.serves(s.down[1]);
        let short = s.needs & !hands & !down;
        let mut must = Must { spots: 0, doors: 0, actions: 0, out: [0; BITS], chosen: 0 };
        for unit in ones(s.needs) {
            let u = &index.units[unit];
            let lacking = (short >> unit & 1).wrapping_neg();
            must.spots |= u.spot | u.from & lacking;
            must.doors |= u.door | u.behind & lacking;
            must.actions += u.actions;
        }
        if self.shared {
            must.actions = self.fewest_actions(s);
        }
        let useful = s.hands.iter().filter(|&&h| index.serves(h) & s.needs & index.carried != 0).count() as u32;
        must.actions = must.actions.saturating_sub(useful);
        if s.needs & index.choosy != 0 {
            self.count_choosy(s, &mut must);
        }
        self.count_doors(s, &mut must);
        (must.actions + self.walks(s, short, &must)) * ACTION
    }

    /// The actions that are needed at least. Where one item can serve two needs, one grab and put may serve all
    /// needs: then only the largest of the carried needs counts.
    fn fewest_actions(&self, s: &State) -> u32 {
        let all = |n: &Need| ones(n.units & s.needs).map(|unit| self.index.units[unit].actions).sum::<u32>();
        let carried = |n: &&Need| n.units & self.index.carried != 0;
        let done: u32 = self.needs.iter().filter(|n| !carried(n)).map(all).sum();
        done + self.needs.iter().filter(carried).map(all).max().unwrap_or(0)
    }

    /// The number of things for some units. Where one item can serve two needs, it is at most the largest of
    /// the needs.
    fn tally(&self, units: u64) -> u32 {
        if !self.shared {
            return ones(units).count() as u32;
        }
        self.needs.iter().map(|n| (n.units & units).count_ones()).max().unwrap_or(0)
    }

    /// Counts needs of several items, and needs that several piles can serve: where only one pile is left, its
    /// spot must be visited.
    fn count_choosy(&self, s: &State, must: &mut Must) {
        let carried = [s.hands[0], s.hands[1], s.down[0], s.down[1]].map(|h| self.kind(h));
        let mut taken = [0u8; MOST];
        let mut rest = s.needs & self.index.choosy;
        while rest != 0 {
            let n = self.index.need_of[rest.trailing_zeros() as usize] as usize;
            let need = &self.needs[n];
            rest &= !need.units;
            let in_hands = carried.iter().filter(|&&serves| serves & (1 << n) != 0).count() as u32;
            let short = self.left(s, n).saturating_sub(in_hands);
            let left = s.piles & self.index.from[n];
            if short == 0 || left == 0 {
                continue;
            }
            let p = self.index.pile_of[left.trailing_zeros() as usize] as usize;
            let pile = &self.piles[p];
            if left & !pile.units != 0 {
                continue;
            }
            let spot = 1 << pile.spot;
            must.spots |= spot;
            must.doors |= pile.door.map_or(0, |d| 1 << d);
            // Two hands limit the number of items that leave a spot, but not moves and uses within the spot.
            if need.units & self.index.carried != 0 && need.spots & spot == 0 && taken[p] < short as u8 {
                must.out[pile.spot as usize] += short as u8 - taken[p];
                taken[p] = short as u8;
                must.chosen |= spot;
            }
        }
    }

    fn walks(&self, s: &State, short: u64, must: &Must) -> u32 {
        let index = &self.index;
        let crowded = index.busy | must.chosen | s.at;
        let mut walks = (must.spots & !crowded).count_ones();
        let held = s.hands.iter().filter(|&&h| h != 0).count() as u32;
        for spot in ones(must.spots & crowded) {
            let into = self.tally(s.needs & index.traffic[spot].into);
            let out = ones(short & index.traffic[spot].out).count() as u32 + u32::from(must.out[spot]);
            walks += if s.at >> spot & 1 == 0 {
                into.div_ceil(2).max(out.div_ceil(2)).max(1)
            } else {
                // The held items can be put down here now, and the hands filled.
                into.saturating_sub(held).div_ceil(2).max(out.saturating_sub(2).div_ceil(2))
            };
        }
        if walks == 0 && s.needs & index.anywhere != 0 {
            let spots = self.needs.iter().filter(|n| n.units & s.needs & index.anywhere != 0);
            walks = u32::from(spots.fold(0, |all, n| all | n.spots) & s.at == 0);
        }
        walks
    }

    fn count_doors(&self, s: &State, must: &mut Must) {
        let wanted = &self.index.wanted;
        let shut = must.doors & !s.open;
        let extra = wanted.closed & (s.open | must.doors) | wanted.open & !s.open & !must.doors;
        must.actions += ones(shut).count() as u32;
        for d in ones(extra) {
            must.actions += 1;
            must.spots |= 1 << self.doors[d].spot;
        }
        let wrong = wanted.on & !s.on | wanted.off & s.on;
        for w in ones(wrong | s.on & self.index.bars) {
            let barring = s.on >> w & 1 != 0 && ones(shut).any(|d| self.doors[d].unsafe_when_on == Some(w as u8));
            if wrong >> w & 1 != 0 || barring {
                must.actions += 1 + u32::from(barring && self.switches[w].wanted == Some(true));
                must.spots |= 1 << self.switches[w].spot;
            }
        }
    }
}
