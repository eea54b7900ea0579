//! Precomputed words about a problem for frequent queries.

use super::{BITS, MOST, Pile, Problem, UNITS, Way, bit, ones};

/// The wanted final states of doors and switches, as bits.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Wanted {
    pub(crate) open: u64,
    pub(crate) closed: u64,
    pub(crate) on: u64,
    pub(crate) off: u64,
}

/// The known requirements of one unit of a need, whatever else is done.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Unit {
    /// Spots and doors of the only way to serve it.
    pub(crate) spot: u64,
    pub(crate) door: u64,
    /// Spots and doors of the only pile that contains it.
    pub(crate) from: u64,
    pub(crate) behind: u64,
    /// The number of actions at its spots: a grab and a put, or a use.
    pub(crate) actions: u32,
}

/// Words about a problem. Bits are units of needs unless stated otherwise.
#[derive(Debug, Clone)]
pub(crate) struct Index {
    /// Indexed by the kind in a hand.
    serves: [u64; BITS],
    pub(crate) need_of: [u8; UNITS],
    pub(crate) pile_of: [u8; UNITS],
    pub(crate) units: Vec<Unit>,
    /// For each spot, the units that can only be put there, and those that can only be taken from there.
    pub(crate) traffic: Vec<Traffic>,
    /// Spots to or from which more than two things go.
    pub(crate) busy: u64,
    /// For each door, the contents behind it (bits of piles), and the units that go through it.
    pub(crate) doors: Vec<Passage>,
    /// Switches that keep a door closed while they are on.
    pub(crate) bars: u64,
    pub(crate) wanted: Wanted,
    /// Units that are put or kept; units of actions on things at their places; units that are held at the end.
    pub(crate) carried: u64,
    pub(crate) uses: u64,
    pub(crate) keeps: u64,
    /// Needs of several items, and needs that several piles serve; for each need its piles (bits of piles).
    pub(crate) choosy: u64,
    pub(crate) from: [u64; MOST],
    /// Needs whose items are put at one of several spots.
    pub(crate) anywhere: u64,
}

/// The units that go to a spot, and those that leave it.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Traffic {
    pub(crate) into: u64,
    pub(crate) out: u64,
}

/// The contents behind a door (bits of piles), and the units that go through it.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Passage {
    pub(crate) behind: u64,
    pub(crate) through: u64,
}

impl Default for Index {
    fn default() -> Self {
        Self {
            serves: [0; BITS],
            need_of: [0; UNITS],
            pile_of: [0; UNITS],
            units: Vec::new(),
            traffic: Vec::new(),
            busy: 0,
            doors: Vec::new(),
            bars: 0,
            wanted: Wanted::default(),
            carried: 0,
            uses: 0,
            keeps: 0,
            choosy: 0,
            from: [0; MOST],
            anywhere: 0,
        }
    }
}

impl Index {
    /// The units that a held item serves; none if the hand is empty.
    pub(crate) fn serves(&self, hand: u8) -> u64 {
        self.serves[hand as usize % BITS]
    }
}

impl Problem {
    /// Fills in the index; called when the rest of the problem is complete.
    pub(crate) fn index(&mut self) {
        let mut index = std::mem::take(&mut self.index);
        index.traffic.resize(self.spots.len(), Traffic::default());
        index.doors.resize(self.doors.len(), Passage::default());
        index.units.reserve(self.needs.iter().map(|n| n.units.count_ones() as usize).sum());
        self.index_kinds(&mut index);
        self.index_wanted(&mut index);
        for n in 0..self.needs.len() {
            self.index_need(n, &mut index);
        }
        for (spot, traffic) in index.traffic.iter().enumerate() {
            let crowded = several(several(traffic.into)) | several(several(traffic.out));
            index.busy |= u64::from(crowded != 0) << spot;
        }
        self.index = index;
    }

    fn index_kinds(&self, index: &mut Index) {
        for (k, needs) in self.kinds.iter().enumerate().take(BITS - 1) {
            index.serves[k + 1] = ones(u64::from(*needs)).fold(0, |all, n| all | self.needs[n].units);
        }
        for (p, pile) in self.piles.iter().enumerate() {
            ones(pile.units).for_each(|unit| index.pile_of[unit] = p as u8);
            if let Some(d) = pile.door {
                index.doors[d as usize].behind |= pile.units;
            }
        }
    }

    fn index_wanted(&self, index: &mut Index) {
        let wanted = &mut index.wanted;
        for (d, door) in self.doors.iter().enumerate() {
            index.bars |= door.unsafe_when_on.map_or(0, bit);
            match door.wanted {
                Some(true) => wanted.open |= 1 << d,
                Some(false) => wanted.closed |= 1 << d,
                None => {}
            }
        }
        for (w, switch) in self.switches.iter().enumerate() {
            match switch.wanted {
                Some(true) => wanted.on |= 1 << w,
                Some(false) => wanted.off |= 1 << w,
                None => {}
            }
        }
    }

    fn index_need(&self, n: usize, index: &mut Index) {
        let need = &self.needs[n];
        let units = need.units;
        for way in &need.ways {
            if let Way::Put { door: Some(d), .. } = way {
                index.doors[*d as usize].through |= units;
            }
        }
        let mut one = Unit::default();
        let (actions, carried) = match need.ways.first() {
            Some(Way::Put { .. }) => (2, true),
            Some(Way::Keep) => (1, true),
            Some(_) => (1, false),
            None => (0, false),
        };
        one.actions = actions;
        index.carried |= if carried { units } else { 0 };
        match need.ways.first() {
            Some(Way::Keep) => index.keeps |= units,
            Some(Way::Use { .. }) => index.uses |= units,
            _ => {}
        }
        if let [Way::Put { door, .. } | Way::Use { door, .. }] = need.ways[..] {
            one.door = door.map_or(0, bit);
        }
        self.index_places(n, actions == 2, &mut one, index);
        self.index_sources(n, carried, &mut one, index);
        for unit in ones(units) {
            index.need_of[unit] = n as u8;
            // Units are assigned in the order of needs.
            index.units.push(one);
        }
    }

    fn serving(&self, n: usize) -> impl Iterator<Item = &Pile> {
        self.piles.iter().filter(move |p| self.kinds[p.kind as usize] & (1 << n) != 0)
    }

    fn index_places(&self, n: usize, put: bool, one: &mut Unit, index: &mut Index) {
        let need = &self.needs[n];
        if need.spots.is_power_of_two() && (put || need.ways.len() == 1) {
            one.spot = need.spots;
            // If some item already lies at the target, a free hand saves no trip.
            let local = self.serving(n).any(|p| need.spots & bit(p.spot) != 0);
            if put && !local {
                index.traffic[one.spot.trailing_zeros() as usize].into |= need.units;
            }
        } else if put {
            index.anywhere |= need.units;
        }
    }

    fn index_sources(&self, n: usize, carried: bool, one: &mut Unit, index: &mut Index) {
        let need = &self.needs[n];
        index.from[n] = self.serving(n).fold(0, |all, p| all | p.units);
        let mut piles = self.serving(n);
        match (piles.next(), piles.next()) {
            (Some(pile), None) if need.units.is_power_of_two() && self.serves_one(pile) => {
                (one.from, one.behind) = (bit(pile.spot), pile.door.map_or(0, bit));
                // Two hands limit the number of items that leave a spot, but not moves and uses within the
                // spot.
                if carried && need.spots & one.from == 0 {
                    index.traffic[pile.spot as usize].out |= need.units;
                }
            }
            (Some(_), _) if index.uses & need.units == 0 => index.choosy |= need.units,
            _ => {}
        }
    }

    fn serves_one(&self, pile: &Pile) -> bool {
        self.kinds[pile.kind as usize].is_power_of_two()
    }
}

/// All bits but the lowest: nonzero if there are several.
fn several(bits: u64) -> u64 {
    bits & bits.wrapping_sub(1)
}
