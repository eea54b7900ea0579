//! Where people cross: as the map says, else by rule.

use std::collections::BTreeMap;

use crate::parts::Junction;
use crate::{Control, CrossingKind, JunctionId, MapDraft, RoadClass, RoadDraft, RoadId};

/// People cross without marks where the carriageway is narrower than this, metres, and the limit lower, metres per second.
const NARROW: f64 = 12.0;
const SLOW: f64 = 14.0;

/// The most carriageways in one crossing: two of a road and a slip road. Over more one comes in several.
const MOST: usize = 3;

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

    fn road(&self, id: RoadId) -> &RoadDraft {
        &self.draft.roads[id.index()]
    }

    pub(super) fn at(&self, id: JunctionId, junction: &Junction) -> At {
        let classes = || junction.arms.iter().map(|arm| self.road(arm.road).class);
        let streets = classes().filter(|class| class.is_street()).count();
        let paths = classes().any(|class| !class.is_street() && !class.is_rail());
        At { id, control: junction.draft.control, streets, paths }
    }

    /// How one crosses some roads, if the map has a crossing there.
    pub(super) fn given(&self, at: &At, over: &[RoadId]) -> Option<Crossing> {
        if over.len() > MOST {
            return None;
        }
        let (kind, island) = *over.iter().filter_map(|road| self.given.get(&(at.id, *road))).min()?;
        let lights = at.control == Control::Signals && kind != CrossingKind::Unmarked;
        Some((if lights { CrossingKind::Signals } else { kind }, island))
    }

    /// How one crosses some roads by rule, if one does; the first at its junction, or one of several.
    pub(super) fn guess(&self, at: &At, over: &[RoadId], first: bool) -> Option<Crossing> {
        let roads = || over.iter().map(|road| self.road(*road));
        let banned = roads().any(|road| road.class == RoadClass::Motorway);
        let lit = at.control == Control::Signals;
        if over.len() > MOST {
            return None;
        }
        if lit && at.streets > 2 && !banned {
            return Some((CrossingKind::Signals, false));
        }
        let rails = roads().all(|road| road.class.is_rail());
        let width: f64 = roads().map(|road| road.section.carriageway(true) + road.section.carriageway(false)).sum();
        let fast = roads().flat_map(|road| road.section.strips()).any(|(_, strip)| strip.limit > SLOW);
        let easy = width < NARROW && (rails || !fast) && !banned;
        // Where two streets only meet end to end, people do not cross for that, and where paths meet them, over one.
        let asked = at.streets > 2 || rails || (first && (at.streets < 2 || at.paths));
        let kind = if lit { CrossingKind::Signals } else { CrossingKind::Unmarked };
        (easy && asked).then_some((kind, false))
    }
}
