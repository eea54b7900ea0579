//! Agents in each other's way at doors and hands: whoever is in a doorway has it, and a thing belongs to the first hand.

use std::collections::BTreeMap;

use nalgebra::Point2;
use vc_graph::asset::JointKind;
use vc_graph::clock::{Span, Tick};
use vc_graph::{Action, Change, ChangeSet, NodeId, Pose, Refusal, SceneGraph, rule};

use super::Interruption;
use super::passing::{Walk, spot};
use super::schedule::{Phase, Schedule};
use super::track::{Leaf, Passage, Track, Way, is_between_rooms};
use crate::environment::{ActionError, Environment};

/// The longest wait for others, and the steps in which a gap between them is looked for.
pub(super) const WAITS: Span = Span(600);
pub(super) const WAIT: Span = Span(15);
/// Ticks between poses that are compared.
const COARSE: usize = 6;
/// The openness of a door up to which racks behind it stay in.
const BEFORE_RACKS: f32 = 0.8;
/// The openness from which on a door is elsewhere.
const MOVED: f32 = 1e-3;
/// How many openings are tried to find room for a door.
const TRIED: u32 = 20;

impl Environment {
    pub(super) fn others(&self, agent: NodeId) -> impl Iterator<Item = (NodeId, &Schedule)> {
        self.clock.running.iter().filter(move |(other, _)| **other != agent).map(|(other, schedule)| (*other, schedule))
    }

    pub(super) fn ways(&self, agent: NodeId) -> impl Iterator<Item = (NodeId, &Way)> {
        self.others(agent).filter_map(|(other, schedule)| Some((other, schedule.track.way()?)))
    }

    pub(super) fn leaves(&self, agent: NodeId) -> impl Iterator<Item = &Leaf> {
        self.others(agent).filter_map(|(_, schedule)| match &schedule.track {
            Track::Leaf(leaf) => Some(leaf),
            _ => None,
        })
    }

    /// Others who are on their way.
    pub(super) fn walkers(&self, agent: NodeId) -> Vec<NodeId> {
        self.ways(agent).map(|(other, _)| other).collect()
    }

    /// The spots where others are going to stand, those too who wait before they walk.
    pub(super) fn claims(&self, agent: NodeId) -> Vec<Point2<f32>> {
        let goal = |schedule: &Schedule| match schedule.phase {
            Phase::Waits => Walk::of(schedule.motions.front()?).map(|walk| walk.feet),
            _ => schedule.track.way().map(|way| way.to),
        };
        self.others(agent).filter_map(|(_, schedule)| Some(spot(&goal(schedule)?))).collect()
    }

    /// How open a door is by itself: one that somebody moves is as that one leaves it; one that somebody passes, as it
    /// was before that.
    pub(super) fn own_openness(&self, agent: NodeId, passage: &Passage) -> f32 {
        let left = self.leaves(agent).find(|leaf| leaf.id == passage.door).map(Leaf::openness);
        let mut passed = self.ways(agent).flat_map(|(_, way)| &way.doors).filter(|p| p.door == passage.door);
        left.or_else(|| passed.next().map(|p| p.own)).unwrap_or(passage.own)
    }

    /// The tick from which on nobody's way leads through a thing's parts as they are going to be; now, if that takes too
    /// long.
    pub(super) fn after_walkers(&self, agent: NodeId, thing: NodeId, open: f32) -> Tick {
        let now = self.tick();
        let met = |from: Tick| {
            let mut ways = self.ways(agent).filter(|(_, way)| way.in_doorway(thing).is_none());
            ways.any(|(who, way)| self.meets(who, way, thing, open, from))
        };
        let waits = (0..=WAITS.0 / WAIT.0).map(|i| now + WAIT * i);
        waits.into_iter().find(|from| !met(*from)).unwrap_or(now)
    }

    /// Whether a way, from a tick on, leads through a thing's parts when they are open by a fraction.
    pub(super) fn meets(&self, who: NodeId, way: &Way, thing: NodeId, open: f32, from: Tick) -> bool {
        let free = |feet: &Pose, at: &[f32]| {
            self.world.standing(who, feet).and_then(|there| Ok(there.is_free_with_open(thing, at)?)).unwrap_or(true)
        };
        let hit = |feet: Pose| !free(&feet, &[open, 0.5]) && free(&feet, &[]);
        ticks(from, way.end()).any(|tick| hit(way.feet(tick)))
    }

    /// Whoever is in the doorway of a door keeps it; whoever would walk into it stops.
    pub(super) fn heed_passers(&mut self, agent: NodeId, leaf: &Leaf) -> Result<(), ActionError> {
        let Some(action) = self.clock.running.get(&agent).map(|schedule| schedule.action) else { return Ok(()) };
        let now = self.tick();
        let met: Vec<_> = self.ways(agent).filter_map(|(who, way)| Some((who, way.in_doorway(leaf.id)?))).collect();
        let door = self.graph.label(leaf.id);
        if let Some((by, _)) = met.iter().find(|(_, (from, to))| *from <= now && now <= *to) {
            let why = Interruption::InDoorway { door, by: self.graph.label(*by) };
            return Err(self.interrupted(&action, why));
        }
        for (by, _) in met.into_iter().filter(|(_, (from, _))| *from > now && *from <= leaf.end()) {
            self.interrupt_for(by, Interruption::Shut { door: door.clone(), by: self.graph.label(agent) });
        }
        let open = leaf.openness();
        for schedule in self.clock.running.values_mut() {
            if let Track::Way(way) = &mut schedule.track {
                way.doors.iter_mut().filter(|p| p.door == leaf.id).for_each(|p| p.own = open);
            }
        }
        Ok(())
    }

    /// How open the doors are in this tick that somebody passes or has passed: as the one who needs it widest has it. One
    /// that a hand moves is with that hand.
    pub(super) fn passed_doors(&self) -> BTreeMap<NodeId, f32> {
        let mut doors: BTreeMap<NodeId, f32> = BTreeMap::new();
        let now = self.tick();
        for way in self.clock.running.values().filter_map(|schedule| schedule.track.way()) {
            for (door, open) in way.passes(now) {
                let widest = doors.entry(door).or_insert(open);
                *widest = widest.max(open);
            }
        }
        for schedule in self.clock.running.values() {
            if let Track::Leaf(leaf) = &schedule.track {
                doors.remove(&leaf.id);
            }
        }
        doors
    }

    /// Puts doors that somebody passes where they are in this tick, as far as there is room for them.
    pub(super) fn put_passed_doors(&mut self) {
        self.passed_doors().into_iter().for_each(|(door, open)| self.move_passed_door(door, open, None));
    }

    /// Moves a door that somebody passes or has passed, past those who walk and one more.
    fn move_passed_door(&mut self, door: NodeId, open: f32, past: Option<NodeId>) {
        let now = self.world.parts(door).openness();
        if now.is_none_or(|now| (now - open).abs() <= MOVED) {
            return;
        }
        let walks = |(agent, schedule): (&NodeId, &Schedule)| schedule.track.way().map(|_| *agent);
        let past: Vec<NodeId> = self.clock.running.iter().filter_map(walks).chain(past).collect();
        // One that is locked, or does not fit in, stays.
        if let Ok(Some(ends)) = self.world.parts(door).plan(open, &past) {
            self.put_parts(door, &ends);
        } else if !is_between_rooms(&self.graph, door) {
            self.put_open_beside(door, open);
        }
    }

    /// Puts the parts of a thing as far open as they are to be, racks no farther than the doors before them allow.
    pub(super) fn put_parts(&mut self, thing: NodeId, ends: &[f32]) {
        let parts = self.world.parts(thing).all();
        let doors = parts.iter().zip(ends).filter(|(part, _)| part.kind == JointKind::Hinge).map(|(_, open)| *open);
        let least = doors.reduce(f32::min).unwrap_or(1.0);
        let out = ((least - BEFORE_RACKS) / (1.0 - BEFORE_RACKS)).clamp(0.0, 1.0);
        for (index, (part, open)) in parts.iter().zip(ends).enumerate() {
            let open = if part.kind == JointKind::Slide { open.min(out) } else { *open };
            // The part is there.
            let _ = self.world.put_open(thing, Some(index), open);
        }
    }

    /// Opens furniture in whose door's way somebody stands, as far as there is room for its door beside that one.
    fn put_open_beside(&mut self, thing: NodeId, open: f32) {
        let all: Vec<(NodeId, Pose)> =
            self.world.agents().filter_map(|agent| Some((agent, self.world.pose(agent)?))).collect();
        let agents: Vec<NodeId> = all.iter().map(|(agent, _)| *agent).collect();
        let has_room = |agent: NodeId, feet: &Pose, open: f32| {
            self.world.standing(agent, feet).is_ok_and(|there| there.is_free_with_open(thing, &[open]).unwrap_or(false))
        };
        let fits = |open: f32| all.iter().all(|(agent, feet)| has_room(*agent, feet, open));
        let shares = (0..TRIED).map(|i| open * (TRIED - i) as f32 / TRIED as f32);
        let ends =
            shares.filter(|open| fits(*open)).find_map(|open| self.world.parts(thing).plan(open, &agents).ok()?);
        ends.into_iter().for_each(|ends| self.put_parts(thing, &ends));
    }

    /// Doors that a walker has passed, or was about to, are as open as by themselves, if nobody else passes them; one in
    /// whose doorway the walker has been stopped is as open as it was by then. Returns those that are not, as somebody
    /// stands there.
    pub(super) fn leave_doors(&mut self, agent: NodeId, way: &Way) -> Vec<NodeId> {
        let now = self.tick();
        let is_passed = |door| self.ways(agent).any(|(_, theirs)| theirs.in_doorway(door).is_some());
        let left: Vec<&Passage> = way.doors.iter().filter(|passage| !is_passed(passage.door)).collect();
        for passage in &left {
            let inside = |(from, to)| from <= now && now <= to && now < way.end();
            if is_between_rooms(&self.graph, passage.door) && way.in_doorway(passage.door).is_some_and(inside) {
                self.move_passed_door(passage.door, passage.open(way, now), Some(agent));
            } else {
                self.move_passed_door(passage.door, passage.own, None);
            }
        }
        let stays = |passage: &&&Passage| {
            self.world.parts(passage.door).openness().is_some_and(|now| (now - passage.own).abs() > MOVED)
        };
        let stay = left.iter().filter(stays).map(|passage| passage.door).collect();
        let passed: Vec<NodeId> = left.iter().map(|passage| passage.door).collect();
        self.clock.about_to_change(&self.graph);
        let written: Vec<NodeId> = self.write_open(&passed).nodes().collect();
        // Nobody else answers for them.
        self.excuse(&written);
        self.clock.unseen |= !written.is_empty();
        self.clock.changed.extend(written);
        stay
    }

    /// Ends the actions that the rule allows no longer since something came true in this tick: a door has been shut before
    /// the hand, a tap turned off, a switch pressed. Nearness is not asked for, as whoever is on the way is not there yet.
    pub(super) fn heed_effects(&mut self, before: &SceneGraph) {
        let tells = |change: &Change| !matches!(change, Change::Pose { .. });
        if self.clock.running.is_empty() || !ChangeSet::between(before, &self.graph).changes().iter().any(tells) {
            return;
        }
        let refused = |graph: &SceneGraph, agent: NodeId, action: &Action| {
            let refusals = rule::refusals(graph, agent, action);
            refusals.iter().any(|refusal| !matches!(refusal, Refusal::NotNear { .. } | Refusal::PointOutOfReach { .. }))
        };
        let pending = self.clock.running.iter().filter(|(_, schedule)| schedule.truth.is_none());
        let lost = pending.filter(|(agent, schedule)| {
            refused(&self.graph, **agent, &schedule.action) && !refused(before, **agent, &schedule.action)
        });
        for agent in lost.map(|(agent, _)| *agent).collect::<Vec<NodeId>>() {
            if let Err(error) = self.still_allowed(agent) {
                self.stop(agent, error);
            }
        }
    }

    /// Ends the actions of others that were to take what an agent has taken.
    pub(in crate::environment) fn tell_taken(&mut self, by: NodeId, thing: NodeId) {
        let needs = |schedule: &Schedule| schedule.truth.is_none() && schedule.action.object == Some(thing);
        let losers: Vec<NodeId> = self.others(by).filter(|(_, s)| needs(s)).map(|(other, _)| other).collect();
        for other in losers {
            let (thing, by) = (self.graph.label(thing), self.graph.label(by));
            self.interrupt_for(other, Interruption::Taken { thing, by });
        }
    }
}

pub(super) fn ticks(from: Tick, to: Tick) -> impl Iterator<Item = Tick> {
    (from.0..to.0.max(from.0 + 1)).step_by(COARSE).map(Tick)
}
