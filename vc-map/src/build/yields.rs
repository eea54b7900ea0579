//! Right of way at junctions without lights.

use std::cmp::Ordering;

use super::budget::Budget;
use super::roundabout;
use crate::parts::{Junction, Lane, Movement, Road, Turn};
use crate::{Control, DrivingSide, JunctionId, MapDraft, MapError};

/// Those who come from directions with a product beyond these come towards each other, or side by side: the cosines of 135
/// degrees and of 17.
const ONCOMING: f64 = -0.7;
const BESIDE: f64 = 0.955;

/// Fills in to whom each movement gives way: to who conflicts and has no sign, comes along a roundabout, from rails, from a
/// road of a higher class, or from one that is no slip road. Among equals those who turn give way to oncoming traffic, and all
/// others to whom comes from the right. At a mini-roundabout one gives way to who goes around it.
pub(super) fn yields(
    draft: &MapDraft,
    junctions: &[Junction],
    roads: &[Road],
    lanes: &[Lane],
    movements: &mut [Movement],
    budget: &mut Budget,
) -> Result<(), MapError> {
    let rule = Rule { side: draft.side, roads, lanes };
    for (index, junction) in junctions.iter().enumerate() {
        let own = |position: usize| junction.movements[position].index();
        let count = junction.movements.len();
        for position in 0..count {
            let goes_first = |other: &usize| {
                let [one, two] = [*other, position].map(|position| &movements[own(position)]);
                let before = || rule.order(junction, one, two) == Ordering::Less;
                junction.conflicts.has(position, *other) && before()
            };
            let to: Vec<u32> = (0..count).filter(goes_first).map(|other| other as u32).collect();
            budget.take_bytes(JunctionId::of(index), to.capacity() * size_of::<u32>())?;
            movements[own(position)].yields = to;
        }
    }
    Ok(())
}

struct Rule<'a> {
    side: DrivingSide,
    roads: &'a [Road],
    lanes: &'a [Lane],
}

impl Rule<'_> {
    /// The order in which two movements of a junction go.
    fn order(&self, junction: &Junction, one: &Movement, other: &Movement) -> Ordering {
        if junction.draft.control == Control::MiniRoundabout {
            return roundabout::order(one, other, junction.at, self.side);
        }
        let [mine, theirs] = [one, other].map(|movement| movement.line.direction(0.0));
        let product = mine.dot(&theirs);
        let from_right = theirs.perp(&mine);
        let turns = || self.key(other.turn).cmp(&self.key(one.turn));
        let among_equals = || match () {
            () if one.turn == Turn::Back || other.turn == Turn::Back => turns(),
            () if !(ONCOMING..=BESIDE).contains(&product) => turns(),
            () if from_right > 0.0 => Ordering::Less,
            () => Ordering::Greater,
        };
        self.rank(other).cmp(&self.rank(one)).then_with(among_equals).then(one.from.cmp(&other.from))
    }

    /// How important the road is from which a movement comes.
    fn rank(&self, movement: &Movement) -> (bool, bool, u8, bool) {
        let lane = &self.lanes[movement.from.index()];
        let road = &self.roads[lane.road.index()].draft;
        let class = if road.class.is_rail() { u8::MAX } else { road.class.rank() };
        (lane.sign.is_none(), road.roundabout, class, !road.slip)
    }

    fn key(&self, turn: Turn) -> u8 {
        precedence(turn, self.side)
    }
}

/// Straight on before a turn on one's own side, before a turn over the other side.
pub(super) fn precedence(turn: Turn, side: DrivingSide) -> u8 {
    match turn {
        Turn::Through => 3,
        Turn::Back => 0,
        turn if turn.crosses_divider(side) => 1,
        _ => 2,
    }
}
