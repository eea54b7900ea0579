//! Movements: which lane goes on with which, by the marks on the lanes or by rule.

use std::collections::{BTreeMap, BTreeSet};

use super::budget::Budget;
use super::roundabout;
use super::targets::{Target, has, leftward, mark, straighten};
use crate::parts::{Arm, Junction, Lane, Movement, Road, Turn};
use crate::polyline::turn;
use crate::{DrivingSide, JunctionId, LaneId, MapDraft, MapError, MovementId, RoadId, Turns, Users};

/// Turns of less than this are straight on: its sine, for 35 degrees.
const STRAIGHT: f64 = 0.574;
/// Branches that bend by less than this are ahead: its sine, for 70 degrees.
const FORK: f64 = 0.94;
/// The cosine beyond which a turn leads back, for 160 degrees.
const BACK: f64 = -0.94;
/// Trams and trains turn by less than this: its cosine, for 60 degrees.
const SWITCH: f64 = 0.5;
/// The most movements of a junction.
const MOST: usize = 512;

/// Fills in the movements of all junctions, and those of each lane.
pub(super) fn movements(
    draft: &MapDraft,
    junctions: &mut [Junction],
    roads: &[Road],
    lanes: &mut [Lane],
    budget: &mut Budget,
) -> Result<Vec<Movement>, MapError> {
    let mut bans: Bans = BTreeMap::new();
    for ban in &draft.bans {
        let users = bans.entry((ban.from, ban.at, ban.to)).or_default();
        *users = *users | ban.users;
    }
    let mut all = Vec::new();
    for (index, junction) in junctions.iter_mut().enumerate() {
        let id = JunctionId::of(index);
        let at = Crossroads { id, junction, roads, lanes, bans: &bans, side: draft.side };
        let found = at.movements()?;
        // Each stands in its junction's list and in those of two lanes, which have room for four when they begin.
        budget.take_bytes(id, 3 * 4 * found.len() * size_of::<MovementId>())?;
        budget.take(id, &found)?;
        for movement in found {
            let id = MovementId::of(all.len());
            junction.movements.push(id);
            lanes[movement.from.index()].next.push(id);
            lanes[movement.to.index()].before.push(id);
            all.push(movement);
        }
    }
    Ok(all)
}

/// Those who may not turn, by the road that they come from, the junction and the road that they may not go on with.
type Bans = BTreeMap<(RoadId, JunctionId, RoadId), Users>;

struct Crossroads<'a> {
    id: JunctionId,
    junction: &'a Junction,
    roads: &'a [Road],
    lanes: &'a [Lane],
    bans: &'a Bans,
    side: DrivingSide,
}

impl Crossroads<'_> {
    fn movements(&self) -> Result<Vec<Movement>, MapError> {
        let mut found = Vec::new();
        let mut joined: BTreeSet<(LaneId, LaneId)> = BTreeSet::new();
        for from in 0..self.junction.arms.len() {
            // A way that was found for cars is one for all who may use both lanes; others are for those they were found for.
            for (users, open) in [
                (Users::CAR, Users::TRAFFIC | Users::RAILS),
                (Users::BUS, Users::BUS | Users::BICYCLE),
                (Users::BICYCLE, Users::BICYCLE),
                (Users::TRAM, Users::TRAM),
                (Users::TRAIN, Users::TRAIN),
            ] {
                for (one, other, turn) in self.pairs(from, &self.targets(from, users), users) {
                    let there = found.iter().any(|known: &Movement| self.serves(known, one, other, users));
                    if !there && joined.insert((one, other)) {
                        found.extend(self.movement(one, other, turn, open));
                    }
                }
                if found.len() > MOST {
                    let (part, count) = (self.name(), found.len());
                    return Err(MapError::TooMany { part, what: "movements", count, most: MOST });
                }
            }
        }
        Ok(found)
    }

    /// The junction with the nodes that it was made from.
    fn name(&self) -> String {
        let nodes: Vec<String> = self.junction.draft.source.iter().take(8).map(i64::to_string).collect();
        if nodes.is_empty() { self.id.to_string() } else { format!("{} (of nodes {})", self.id, nodes.join(", ")) }
    }

    /// Whether a movement takes some users from a lane to the road of another already; lanes of their own are always joined.
    fn serves(&self, known: &Movement, from: LaneId, to: LaneId, users: Users) -> bool {
        let (onto, lane) = (&self.lanes[known.to.index()], &self.lanes[to.index()]);
        let own = users == Users::BICYCLE && !lane.users.has(Users::CAR);
        let same = onto.road == lane.road && onto.forward == lane.forward;
        known.from == from && known.users.has(users) && same && users != Users::CAR && !own
    }

    fn movement(&self, from: LaneId, to: LaneId, direction: Turn, open: Users) -> Option<Movement> {
        let (one, other) = (&self.lanes[from.index()], &self.lanes[to.index()]);
        let (end, start) = (one.line.length(), 0.0);
        let around = || roundabout::around(one.line.end(), other.line.start(), direction, self.junction.at, self.side);
        let line = self.is_round().then(around).flatten();
        let turn = || turn(one.line.end(), one.line.direction(end), other.line.start(), other.line.direction(start));
        let line = line.or_else(turn);
        // Lanes that meet have a movement as well, of the smallest length.
        let line = line.or_else(|| {
            let at = one.line.end();
            crate::Polyline::new([at, at + one.line.direction(end) * 0.01])
        })?;
        let users = one.users.and(other.users).and(open).without(self.banned(one.road, other.road));
        Some(Movement { junction: self.id, from, to, turn: direction, line, users, yields: Vec::new() })
    }

    /// Those who may not go from a road to another.
    fn banned(&self, from: RoadId, to: RoadId) -> Users {
        self.bans.get(&(from, self.id, to)).copied().unwrap_or_default()
    }

    /// The lanes of an arm for some users, from the divider outward: those that come in, or those that go out.
    fn ways(&self, arm: &Arm, incoming: bool, users: Users) -> Vec<LaneId> {
        let comes = |lane: &Lane| (lane.forward != arm.start) == incoming;
        let road = &self.roads[arm.road.index()];
        road.lanes
            .iter()
            .copied()
            .filter(|id| {
                let lane = &self.lanes[id.index()];
                comes(lane) && lane.users.any(users)
            })
            .collect()
    }

    /// Whether vehicles can only go back: no other arm leads on for them, whatever paths may, or none that is
    /// allowed.
    fn is_dead_end(&self, from: usize) -> bool {
        let vehicles = Users::CAR | Users::BUS;
        let own = self.junction.arms[from].road;
        let leads =
            |arm: &Arm| !self.ways(arm, false, vehicles).is_empty() && !self.banned(own, arm.road).has(vehicles);
        let others = self.junction.arms.iter().enumerate().filter(|(arm, _)| *arm != from);
        self.junction.draft.control != crate::Control::Edge && !others.map(|(_, arm)| arm).any(leads)
    }

    /// The arms by which some users can go on, from the left to the right.
    fn targets(&self, from: usize, users: Users) -> Vec<Target> {
        let arms = &self.junction.arms;
        let came = -arms[from].away;
        let alone = self.is_dead_end(from);
        let open = |arm: &usize| {
            let banned = self.banned(arms[from].road, arms[*arm].road).any(users);
            !banned && (*arm != from || alone || self.is_round()) && !self.ways(&arms[*arm], false, users).is_empty()
        };
        let target = |arm: usize| {
            let (cosine, sine) = (came.dot(&arms[arm].away), came.perp(&arms[arm].away));
            let turn = match () {
                () if arm == from || cosine < BACK => Turn::Back,
                () if cosine > 0.0 && sine.abs() < STRAIGHT => Turn::Through,
                () if sine > 0.0 => Turn::Left,
                () => Turn::Right,
            };
            Target { arm, turn, leftward: leftward(cosine, sine) }
        };
        let mut targets: Vec<Target> = (0..arms.len()).filter(open).map(target).collect();
        targets.sort_by(|a, b| b.leftward.total_cmp(&a.leftward).then(a.arm.cmp(&b.arm)));
        if self.is_round() { targets } else { straighten(targets, self.used_arms(users) == 2) }
    }

    /// Whether one goes around the middle, also to turn back.
    fn is_round(&self) -> bool {
        self.junction.draft.control == crate::Control::MiniRoundabout
    }

    /// The number of arms that some users come in or go out by.
    fn used_arms(&self, users: Users) -> usize {
        let used = |arm: &&Arm| [true, false].iter().any(|incoming| !self.ways(arm, *incoming, users).is_empty());
        self.junction.arms.iter().filter(used).count()
    }

    /// The pairs of lanes for some users from one arm to all others.
    fn pairs(&self, from: usize, targets: &[Target], users: Users) -> Vec<(LaneId, LaneId, Turn)> {
        let incoming = self.ways(&self.junction.arms[from], true, users);
        let open: Vec<(&Target, Vec<LaneId>)> = targets
            .iter()
            .map(|target| (target, self.ways(&self.junction.arms[target.arm], false, users)))
            .filter(|(target, _)| self.bends(from, target, users))
            .collect();
        if incoming.is_empty() || open.is_empty() {
            return Vec::new();
        }
        if users == Users::BICYCLE {
            return bicycles(self.lanes, &incoming, &open);
        }
        let mut pairs = Vec::new();
        for (target, out) in &open {
            let chosen = self.chosen(&incoming, &open, target);
            pairs.extend(
                matched(&chosen, out, target.turn.crosses_divider(self.side))
                    .into_iter()
                    .map(|(a, b)| (a, b, target.turn)),
            );
        }
        // No lane ends at a junction without a way on.
        for lane in &incoming {
            if !pairs.iter().any(|(from, ..)| from == lane) {
                let nearest = open.iter().min_by(|a, b| a.0.leftward.abs().total_cmp(&b.0.leftward.abs()));
                let position = incoming.iter().position(|other| other == lane).unwrap_or(0);
                pairs.extend(nearest.map(|(target, out)| (*lane, out[position.min(out.len() - 1)], target.turn)));
            }
        }
        pairs
    }

    /// Whether rails can bend that much; vehicles on tyres always can.
    fn bends(&self, from: usize, target: &Target, users: Users) -> bool {
        let arms = &self.junction.arms;
        !users.any(Users::RAILS) || -arms[from].away.dot(&arms[target.arm].away) > SWITCH
    }

    /// The lanes from which one may go to a target: as marked, else by rule.
    fn chosen(&self, incoming: &[LaneId], open: &[(&Target, Vec<LaneId>)], target: &Target) -> Vec<LaneId> {
        let marked: Vec<Turns> = incoming.iter().map(|lane| self.lanes[lane.index()].turns).collect();
        let flag = mark(&marked, open, target);
        let by_mark =
            |lanes: &mut dyn Iterator<Item = usize>| lanes.filter(|i| marked[*i].any(flag)).collect::<Vec<_>>();
        let mut picked = by_mark(&mut (0..incoming.len()));
        let unmarked: Vec<usize> = (0..incoming.len()).filter(|i| marked[*i].is_empty()).collect();
        if !unmarked.is_empty() {
            picked.extend(self.by_rule(&unmarked, open, target, !picked.is_empty()));
            picked.sort_unstable();
        }
        if picked.is_empty() && !open.iter().any(|(other, _)| has(&marked, mark(&marked, open, other))) {
            picked = (0..incoming.len()).collect();
        }
        // A branch for which no lane is marked is taken from the lane on its side: where streets fork all lanes lead ahead.
        if picked.is_empty() && target.leftward.abs() < FORK {
            let lane = if target.turn.crosses_divider(self.side) { 0 } else { incoming.len() - 1 };
            picked.push(lane);
        }
        picked.into_iter().map(|index| incoming[index]).collect()
    }

    /// Straight on from every lane, turns from the lane on their side; without a way straight on, each side takes half.
    fn by_rule(
        &self,
        lanes: &[usize],
        open: &[(&Target, Vec<LaneId>)],
        target: &Target,
        has_marked: bool,
    ) -> Vec<usize> {
        let through = open.iter().any(|(other, _)| other.turn == Turn::Through);
        let towards_divider = target.turn.crosses_divider(self.side);
        let count = lanes.len();
        match target.turn {
            Turn::Through => lanes.to_vec(),
            _ if has_marked => Vec::new(),
            _ if through || open.len() > 2 => {
                let side = if towards_divider { lanes.first() } else { lanes.last() };
                side.copied().into_iter().collect()
            }
            _ if open.len() == 1 => lanes.to_vec(),
            _ if towards_divider => lanes[..count.div_ceil(2)].to_vec(),
            _ => lanes[count / 2..].to_vec(),
        }
    }
}

/// Lanes matched with lanes, both from the divider outward: turns towards the divider from the inside, all others from
/// the outside. Lanes that are too many end in the last one.
fn matched(from: &[LaneId], to: &[LaneId], from_inside: bool) -> Vec<(LaneId, LaneId)> {
    let last = to.len() - 1;
    let inside = |index: usize| to[index.min(last)];
    let outside = |index: usize| to[last - (from.len() - 1 - index).min(last)];
    let pick = |index: usize| if from_inside { inside(index) } else { outside(index) };
    from.iter().enumerate().map(|(index, lane)| (*lane, pick(index))).collect()
}

/// Bicycles go from lanes of their own, or else from the outermost lane, to the like.
fn bicycles(lanes: &[Lane], incoming: &[LaneId], open: &[(&Target, Vec<LaneId>)]) -> Vec<(LaneId, LaneId, Turn)> {
    let own = |ids: &[LaneId]| {
        let own = ids.iter().copied().find(|id| !lanes[id.index()].users.has(Users::CAR));
        own.or(ids.last().copied())
    };
    open.iter().filter_map(|(target, out)| Some((own(incoming)?, own(out)?, target.turn))).collect()
}
