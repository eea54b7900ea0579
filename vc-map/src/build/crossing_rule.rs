//! Where people cross: as the map says, else by rule.

use std::collections::BTreeMap;

use crate::parts::Junction;
use crate::{Control, CrossingKind, JunctionId, MapDraft, Point, RoadClass, RoadDraft, RoadId};

/// People cross without marks where the carriageway is narrower than this, metres, and the limit lower, metres per second.
const NARROW: f64 = 12.0;
const SLOW: f64 = 14.0;

/// The most carriageways in one crossing: two of a road and a slip road, and rails between them. Over more one comes in several.
const MOST: usize = 3;
const MOST_WITH_RAILS: usize = 5;

/// A road that begins so far from the middle of its junction begins at its crossing if it has one, metres.
const OUTSIDE: f64 = 5.0;

/// Whether a road with a crossing at a junction begins where that is mapped: outside of where streets meet, or where only one goes on.
pub(super) fn begins_at_crossing(begin: &Point, junction: &Point, streets: usize) -> bool {
    streets <= 2 || (begin - junction).norm() > OUTSIDE
}

/// A kind of crossing, and whether there is an island.
type Crossing = (CrossingKind, bool);

pub(super) struct CrossingRule<'a> {
    draft: &'a MapDraft,
    given: BTreeMap<(JunctionId, RoadId), Crossing>,
}

/// The facts that decide on crossings at a junction.
pub(super) struct At {
    id: JunctionId,
    control: Control,
    /// The number of its streets, and whether paths end there.
    streets: usize,
    paths: bool,
}

impl<'a> CrossingRule<'a> {
    pub(super) fn new(draft: &'a MapDraft) -> Self {
        let mut given = BTreeMap::new();
        for crossing in &draft.crossings {
            let known: &mut Crossing =
                given.entry((crossing.at, crossing.road)).or_insert((crossing.kind, crossing.island));
            *known = (known.0.min(crossing.kind), known.1 || crossing.island);
        }
        Self { draft, given }
    }

    /// Whether the map has a crossing over a road at a junction.
    pub(super) fn is_given(&self, at: JunctionId, road: RoadId) -> bool {
        self.given.contains_key(&(at, road))
    }

    fn road(&self, id: RoadId) -> &RoadDraft {
        &self.draft.roads[id.index()]
    }

    pub(super) fn at(&self, id: JunctionId, junction: &Junction) -> At {
        let classes = || junction.arms.iter().map(|arm| self.road(arm.road).class);
        let streets = classes().filter(|class| class.is_street()).count();
        let paths = classes().any(|class| !class.is_street() && !class.is_rail());
        At { id, control: junction.draft.control, streets, paths }
    }

    fn too_many(&self, over: &[RoadId]) -> bool {
        let streets = over.iter().filter(|road| !self.road(**road).class.is_rail()).count();
        streets > MOST || over.len() > MOST_WITH_RAILS
    }

    /// How one crosses some roads, if the map has a crossing there.
    pub(super) fn given(&self, at: &At, over: &[RoadId]) -> Option<Crossing> {
        if self.too_many(over) {
            return None;
        }
        let given = *over.iter().filter_map(|road| self.given.get(&(at.id, *road))).min()?;
        Some(Self::lit(at, given))
    }

    /// The crossing that the map has where a street goes on, on whichever side of the junction people come to it.
    pub(super) fn through(&self, at: &At, junction: &Junction) -> Option<Crossing> {
        let given = junction.arms.iter().filter_map(|arm| self.given.get(&(at.id, arm.road))).min();
        given.filter(|_| at.streets == 2).map(|given| Self::lit(at, *given))
    }

    /// A crossing with the lights of its junction.
    fn lit(at: &At, (kind, island): Crossing) -> Crossing {
        let lights = at.control == Control::Signals && kind != CrossingKind::Unmarked;
        (if lights { CrossingKind::Signals } else { kind }, island)
    }

    /// How one crosses some roads by rule, if one does; the first at its junction, or one of several.
    pub(super) fn guess(&self, at: &At, over: &[RoadId], first: bool) -> Option<Crossing> {
        let roads = || over.iter().map(|road| self.road(*road));
        let banned = roads().any(|road| road.class == RoadClass::Motorway);
        let lit = at.control == Control::Signals;
        if self.too_many(over) {
            return None;
        }
        if lit && at.streets > 2 && !banned {
            return Some((CrossingKind::Signals, false));
        }
        let rails = roads().all(|road| road.class.is_rail());
        let width: f64 = roads().map(|road| road.section.carriageway(true) + road.section.carriageway(false)).sum();
        let fast = roads().flat_map(|road| road.section.strips()).any(|(_, strip)| strip.limit > SLOW);
        let easy = rails || (width < NARROW && !fast && !banned);
        // Where two streets only meet end to end, people do not cross for that, and where paths meet them, over one.
        let asked = at.streets > 2 || rails || (first && (at.streets < 2 || at.paths));
        let kind = if lit { CrossingKind::Signals } else { CrossingKind::Unmarked };
        (easy && asked).then_some((kind, false))
    }
}
