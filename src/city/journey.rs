//! Ways from region to region: walks to portals, passages through them, and waiting for lifts.

use std::collections::VecDeque;

use nalgebra::{Point2, Point3, UnitQuaternion, Vector3, distance};
use serde::{Deserialize, Serialize};
use vc_graph::clock::{Span, TICKS_PER_SECOND, Tick};
use vc_graph::hash::Digester;
use vc_graph::portable::Portable;
use vc_graph::space::{Portal, PortalId, PortalKind, RegionId, Space};
use vc_graph::{Action, ChangeSet, NodeId, ObjectNames, Pose, Verb};
use vc_physics::Posture;

use super::time::CityEnding;
use super::{City, CityError, RegionLabel, lift};
use crate::Environment;

/// Speed on level ground and over stairs, along their slope, metres a second.
const LEVEL: f32 = 1.2;
const STAIRS: f32 = 0.6;
/// How far behind a threshold one goes on, metres.
const INWARD: f32 = 0.7;
/// Whoever is as near to a place need not go there, metres.
const THERE: f32 = 0.3;
/// The coordinates that a saved way has at most, metres.
const FARTHEST: f32 = 1e6;
/// How often one tries again where somebody is in the way, and how long one waits before.
const TRIES: u32 = 60;
const PATIENCE: Span = Span(60);

/// An agent's way to another region, and what it does there.
#[derive(Clone, Serialize, Deserialize)]
pub(super) struct Journey {
    /// The walk that it was given; none if it was sent to a region.
    pub(super) action: Option<Action>,
    /// Whether it was ordered: whoever is interrupted between two regions gets through, and nothing more is told of it.
    is_ordered: bool,
    /// The legs that are left; the first goes on, unless it waits.
    legs: VecDeque<Leg>,
    stage: Stage,
    /// How often somebody was in the way of the leg.
    tries: u32,
    #[serde(skip)]
    pub(super) changes: ChangeSet,
}

/// A part of a way.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
enum Leg {
    /// To a portal, within a region.
    Approach(PortalId),
    /// Through it.
    Cross(PortalId),
    /// The action itself.
    Act(Action),
}

#[derive(Clone, Serialize, Deserialize)]
enum Stage {
    /// The next leg has not begun; it is tried from a tick on.
    Waiting(Tick),
    /// An action in the region goes on.
    Acting,
    Crossing(Crossing),
}

/// Somebody on the way through a portal.
#[derive(Clone, Serialize, Deserialize)]
struct Crossing {
    portal: PortalId,
    from: RegionId,
    into: RegionId,
    /// Whether it is in the region beyond by now.
    is_beyond: bool,
    /// The way in the region in which it is, metres.
    way: Vec<Point3<f32>>,
    begun: Tick,
    /// Whether the leaf was shut, so that it is shut again.
    shuts: bool,
}

impl Journey {
    /// Whether a region has to be there for it.
    pub(super) fn needs(&self, region: RegionId) -> bool {
        matches!(&self.stage, Stage::Crossing(crossing) if [crossing.from, crossing.into].contains(&region))
    }

    /// Whether it leads through a portal of a region at the moment.
    pub(super) fn crosses(&self, space: &Space, region: RegionId) -> bool {
        let Stage::Crossing(crossing) = &self.stage else { return false };
        space.portal(crossing.portal).is_some_and(|plan| plan.side(region).is_some())
    }

    /// Whether a saved journey can go on at a tick: its portals join regions of a plan, and its way is one.
    pub(super) fn is_sound(&self, space: &Space, now: Tick) -> bool {
        let portal = |leg: &Leg| match leg {
            Leg::Approach(portal) | Leg::Cross(portal) => Some(*portal),
            Leg::Act(_) => None,
        };
        let legs = self.legs.iter().filter_map(portal).all(|portal| space.portal(portal).is_some());
        legs && match &self.stage {
            Stage::Waiting(_) | Stage::Acting => true,
            Stage::Crossing(crossing) => {
                let joins = |region| space.portal(crossing.portal).is_some_and(|plan| plan.side(region).is_some());
                let near = |point: &Point3<f32>| point.coords.iter().all(|value| value.abs() <= FARTHEST);
                crossing.begun <= now && joins(crossing.from) && joins(crossing.into) && crossing.way.iter().all(near)
            }
        }
    }

    /// Takes up what a saved journey does not have itself: the names by which its action calls things, and its changes.
    pub(super) fn take_up(&mut self, called: Option<ObjectNames>, changes: ChangeSet) {
        self.changes = changes;
        let acts = self.legs.iter_mut().filter_map(|leg| match leg {
            Leg::Act(action) => Some(action),
            _ => None,
        });
        for action in self.action.iter_mut().chain(acts) {
            action.called = called.unwrap_or(action.called);
        }
    }

    pub(super) fn feed(&self, agent: NodeId, hash: &mut Digester) {
        hash.words([u64::from(agent.0), u64::from(self.tries), u64::from(self.is_ordered)]);
        self.legs.iter().for_each(|leg| _ = hash.text(&format!("{leg:?}")));
        match &self.stage {
            Stage::Waiting(until) => hash.words([0, until.0]),
            Stage::Acting => hash.word(1),
            Stage::Crossing(crossing) => {
                let flags = u64::from(crossing.is_beyond) + 2 * u64::from(crossing.shuts);
                let at = [u64::from(crossing.portal.0), flags, crossing.begun.0];
                hash.word(2).words(at)
            }
        };
    }
}

impl City {
    /// The region in which the object of a walk is, if it is another one than the agent's.
    pub(super) fn elsewhere(&self, agent: NodeId, action: &Action) -> Option<RegionId> {
        let goes = matches!(action.verb, Verb::Walk | Verb::Run | Verb::Find);
        let region = self.region_of(action.object.filter(|_| goes)?)?;
        (Some(region) != self.begins_at(agent).map(|(here, _)| here)).then_some(region)
    }

    /// Plans a way to another region, and an action there; whoever is between two regions gets through first.
    pub(super) fn set_out(
        &mut self,
        agent: NodeId,
        to: Option<RegionId>,
        action: Option<Action>,
    ) -> Result<(), CityError> {
        let (here, feet) = self.begins_at(agent).ok_or_else(|| CityError::NoSuchAgent(self.label(agent)))?;
        let way = to.filter(|to| *to != here).map_or_else(|| Ok(Vec::new()), |to| self.way(agent, (here, feet), to))?;
        let before = self.break_off(agent);
        let goes_on = before.as_ref().and_then(|before| before.legs.front().copied());
        let legs = way.into_iter().flat_map(|portal| [Leg::Approach(portal), Leg::Cross(portal)]);
        let legs = goes_on.into_iter().chain(legs).chain(action.map(Leg::Act)).collect();
        let stage = before.map_or(Stage::Waiting(self.tick), |before| before.stage);
        let (is_ordered, changes) = (to.is_some() || action.is_some(), ChangeSet::default());
        self.journeys.insert(agent, Journey { action, is_ordered, legs, stage, tries: 0, changes });
        Ok(())
    }

    /// Where an agent is, or will be once it is through the portal in which it is.
    fn begins_at(&self, agent: NodeId) -> Option<(RegionId, Point3<f32>)> {
        match self.journeys.get(&agent).map(|journey| &journey.stage) {
            Some(Stage::Crossing(crossing)) if !crossing.is_beyond => Some((crossing.into, Point3::origin())),
            _ => Some((self.region_of(agent)?, Point3::from(self.feet(agent)?.translation.vector))),
        }
    }

    fn way(&self, agent: NodeId, from: (RegionId, Point3<f32>), to: RegionId) -> Result<Vec<PortalId>, CityError> {
        let own = self.ways.get(&agent);
        let takes = |plan: &Portal| plan.kind != PortalKind::Window && own.is_none_or(|takes| takes(plan));
        let takes = |portal: PortalId| self.space().portal(portal).is_some_and(takes);
        let way = self.space().route(from, (to, Point3::origin()), takes);
        way.ok_or_else(|| CityError::NoWay { from: self.region_label(from.0), to: self.region_label(to) })
    }

    /// Whether an agent is between two regions.
    pub(super) fn is_crossing(&self, agent: NodeId) -> bool {
        matches!(self.journeys.get(&agent), Some(Journey { stage: Stage::Crossing(_), .. }))
    }

    /// Ends an action of an agent's region, and takes note of it.
    pub(super) fn stop_acting(&mut self, agent: NodeId) {
        let Some(environment) = self.environment_mut(agent) else { return };
        environment.interrupt(agent);
        for ended in environment.step(Span(0)) {
            self.note(ended.tick, ended.agent, ended.action, ended.outcome.map_err(CityError::from));
        }
    }

    /// Ends a journey where it is; returns it if the agent is between two regions.
    pub(super) fn break_off(&mut self, agent: NodeId) -> Option<Journey> {
        let Some(journey) = self.journeys.remove(&agent) else {
            self.stop_acting(agent);
            return None;
        };
        if let Stage::Acting = journey.stage {
            let known = self.endings.len();
            self.stop_acting(agent);
            // The ending is that of a leg: the journey's own tells more.
            if let Some(leg) = (known..self.endings.len()).rfind(|at| self.endings[*at].agent == agent) {
                self.endings.remove(leg);
            }
        }
        if journey.is_ordered {
            let why = CityError::Interrupted(self.label(agent));
            self.endings.push(CityEnding { tick: self.tick, agent, action: journey.action, outcome: Err(why) });
        }
        matches!(journey.stage, Stage::Crossing(_)).then_some(journey)
    }

    pub(super) fn feet(&self, agent: NodeId) -> Option<Pose> {
        self.environment_of(agent)?.world().pose(agent)
    }

    /// Begins the legs that can begin.
    pub(super) fn journeys_begin(&mut self) {
        let now = self.tick;
        let is_due = |stage: &Stage| matches!(stage, Stage::Waiting(until) if *until <= now);
        let waiting = self.journeys.iter().filter(|(_, journey)| is_due(&journey.stage));
        for agent in waiting.map(|(agent, _)| *agent).collect::<Vec<NodeId>>() {
            if let Err(why) = self.begin_leg(agent) {
                self.leg_failed(agent, why);
            }
        }
    }

    fn begin_leg(&mut self, agent: NodeId) -> Result<(), CityError> {
        loop {
            let Some(leg) = self.journeys.get(&agent).map(|journey| journey.legs.front().copied()) else {
                return Ok(());
            };
            let begun = match leg {
                None => {
                    self.end_journey(agent, Ok(()));
                    return Ok(());
                }
                Some(Leg::Act(action)) => self.act(agent, action),
                Some(Leg::Approach(portal)) => match self.approach(agent, portal)? {
                    None => {
                        self.leg_done(agent);
                        continue;
                    }
                    Some(walk) => self.act(agent, walk),
                },
                Some(Leg::Cross(portal)) => self.begin_crossing(agent, portal)?.map(Stage::Crossing),
            };
            if let (Some(stage), Some(journey)) = (begun, self.journeys.get_mut(&agent)) {
                journey.stage = stage;
            }
            return Ok(());
        }
    }

    fn act(&mut self, agent: NodeId, action: Action) -> Option<Stage> {
        self.environment_mut(agent)?.give(agent, action);
        Some(Stage::Acting)
    }

    fn leg_done(&mut self, agent: NodeId) {
        if let Some(journey) = self.journeys.get_mut(&agent) {
            journey.legs.pop_front();
            (journey.stage, journey.tries) = (Stage::Waiting(self.tick), 0);
        }
    }

    /// The action of a leg has ended.
    pub(super) fn leg_ended(&mut self, agent: NodeId, outcome: Result<ChangeSet, CityError>) {
        match outcome {
            Ok(changes) => {
                self.changed(agent, changes);
                self.leg_done(agent);
            }
            Err(why) => self.leg_failed(agent, why),
        }
    }

    fn changed(&mut self, agent: NodeId, changes: ChangeSet) {
        if let Some(journey) = self.journeys.get_mut(&agent) {
            journey.changes = std::mem::take(&mut journey.changes).then(changes);
        }
    }

    /// Whether the leg of an agent is a portal of a lift, which has to leave before the next try.
    fn waits_for_lift(&self, agent: NodeId) -> bool {
        let Some(Leg::Cross(portal)) = self.journeys.get(&agent).and_then(|journey| journey.legs.front()) else {
            return false;
        };
        let plan = self.space().portal(*portal);
        plan.is_some_and(|plan| self.lifts.at(plan).is_some())
    }

    /// A leg cannot be done: if somebody is in the way, it is tried again later.
    fn leg_failed(&mut self, agent: NodeId, why: CityError) {
        let patience = if self.waits_for_lift(agent) { lift::ROUND } else { PATIENCE };
        let later = Tick(self.tick.0 + patience.0);
        match self.journeys.get_mut(&agent) {
            Some(journey)
                if why.may_pass() && journey.tries < TRIES && !matches!(journey.legs.front(), Some(Leg::Act(_))) =>
            {
                (journey.tries, journey.stage) = (journey.tries + 1, Stage::Waiting(later));
            }
            _ => self.end_journey(agent, Err(why)),
        }
    }

    fn end_journey(&mut self, agent: NodeId, outcome: Result<(), CityError>) {
        let Some(journey) = self.journeys.remove(&agent) else { return };
        if !journey.is_ordered {
            return;
        }
        let outcome = outcome.map(|()| journey.changes);
        self.endings.push(CityEnding { tick: self.tick, agent, action: journey.action, outcome });
    }

    /// The walk that brings somebody before a portal; none if it is there, or in a cabin.
    fn approach(&self, agent: NodeId, portal: PortalId) -> Result<Option<Action>, CityError> {
        let Some((region, plan)) = self.region_of(agent).zip(self.space().portal(portal)) else { return Ok(None) };
        let (Some(feet), Some(environment)) = (self.feet(agent), self.environment(region)) else { return Ok(None) };
        if self.lifts.get(region).is_some() {
            return Ok(None);
        }
        let before = beside(plan, region);
        let no_floor = || CityError::NoFloor { region: self.region_label(region), within: 1.5 };
        let spot = environment.spot_near(agent, before, &[]).ok_or_else(no_floor)?;
        let stands = environment.posture(agent) == Some(Posture::Standing);
        if stands && distance(&spot, &Point2::from(feet.translation.vector.xy())) < THERE {
            return Ok(None);
        }
        let walk = Action::zero(Verb::Walk).at(f64::from(spot.x), f64::from(spot.y));
        Ok(walk.ok())
    }

    /// Begins to go through a portal, if it lets through; calls the lift if it is one of a lift.
    fn begin_crossing(&mut self, agent: NodeId, portal: PortalId) -> Result<Option<Crossing>, CityError> {
        let space = self.space().clone();
        let Some((from, plan)) = self.region_of(agent).zip(space.portal(portal)) else { return Ok(None) };
        let Some(into) = plan.across(from).map(|side| side.region) else { return Ok(None) };
        let lift = self.lifts.at(plan).map(|(_, lift)| lift);
        let is_of_lift = lift.is_some();
        if lift.is_some_and(|lift| !lift.is_open_at(plan.stop)) {
            self.lifts.call(plan);
            return Ok(None);
        }
        self.wake(into)?;
        let shuts = plan.leaf.is_some_and(|leaf| !is_of_lift && !self.is_open(leaf));
        if shuts {
            self.set_leaf(plan, true)?;
        }
        let Some(feet) = self.feet(agent) else { return Ok(None) };
        let way = way_out(plan, from, &feet);
        Ok(Some(Crossing { portal, from, into, is_beyond: false, way, begun: self.tick, shuts }))
    }

    /// Opens or shuts the leaf of a portal.
    fn set_leaf(&mut self, plan: &Portal, open: bool) -> Result<(), CityError> {
        let Some(leaf) = plan.leaf else { return Ok(()) };
        let region = self.region_of(leaf).unwrap_or(plan.sides[0].region);
        self.wake(region)?.set_leaf(leaf, open)?;
        Ok(())
    }

    /// Moves those who are between two regions.
    pub(super) fn journeys_pass(&mut self) {
        let crossing = |(agent, journey): (&NodeId, &Journey)| match &journey.stage {
            Stage::Crossing(crossing) => Some((*agent, crossing.clone())),
            _ => None,
        };
        let crossings = self.journeys.iter().filter_map(crossing).map(|(agent, _)| agent).collect::<Vec<NodeId>>();
        for agent in crossings {
            let Some((_, mut crossing)) = self.journeys.get_key_value(&agent).and_then(crossing) else { continue };
            match self.go_through(agent, &mut crossing) {
                Ok(false) => {
                    if let Some(journey) = self.journeys.get_mut(&agent) {
                        journey.stage = Stage::Crossing(crossing);
                    }
                }
                Ok(true) => {
                    self.leg_done(agent);
                    self.shut_behind(&crossing);
                }
                Err(why) => {
                    self.leg_failed(agent, why);
                    self.shut_behind(&crossing);
                }
            }
        }
    }

    /// Shuts the leaf that somebody has opened, or leaves that to another one who is passing.
    fn shut_behind(&mut self, passed: &Crossing) {
        if !passed.shuts {
            return;
        }
        let mut others = self.journeys.values_mut().filter_map(|journey| match &mut journey.stage {
            Stage::Crossing(crossing) => Some(crossing).filter(|crossing| crossing.portal == passed.portal),
            _ => None,
        });
        if let Some(other) = others.next() {
            other.shuts = true;
        } else if let Some(plan) = self.space().clone().portal(passed.portal) {
            // A leaf that jams stays open.
            let _ = self.set_leaf(plan, false);
        }
    }

    /// Goes on through a portal; whether that is done.
    fn go_through(&mut self, agent: NodeId, crossing: &mut Crossing) -> Result<bool, CityError> {
        let gone = self.tick.0.saturating_sub(crossing.begun.0) as f32 / TICKS_PER_SECOND as f32;
        let Some(feet) = along(&crossing.way, gone) else {
            if crossing.is_beyond {
                self.come_through(agent, crossing);
                return Ok(true);
            }
            self.hand_over(agent, crossing)?;
            return Ok(false);
        };
        if let Some(environment) = self.environment_mut(agent) {
            environment.place_feet(agent, feet);
        }
        Ok(false)
    }

    /// Takes an agent from the region that it leaves into the one that it enters.
    fn hand_over(&mut self, agent: NodeId, crossing: &mut Crossing) -> Result<(), CityError> {
        let space = self.space().clone();
        let Crossing { portal, from, into, .. } = *crossing;
        let Some((plan, side)) = space.portal(portal).and_then(|plan| Some((plan, plan.side(into)?))) else {
            return Ok(());
        };
        let frames = self.frame(from).zip(self.frame(into));
        let shift = frames.map_or_else(Pose::identity, |(from, to)| from.to(&to));
        let feet = self.feet(agent).unwrap_or_else(Pose::identity);
        let threshold = Pose::from_parts(side.pose.translation, (shift * feet).rotation);
        self.wake(into)?;
        let both = [from, into].into_iter().filter_map(|region| Some((region, self.active.get(&region)?.clone())));
        let before: Vec<(RegionId, Environment)> = both.collect();
        let home = self.active.get_mut(&from).ok_or_else(|| CityError::NoScene(RegionLabel::new(&space, from)))?;
        let departed = home.depart(agent, from);
        let (departure, left) = match departed {
            Ok(departed) => departed,
            Err(why) => {
                self.active.extend(before);
                return Err(CityError::of_travel(&space, why));
            }
        };
        let taken = self.ends_of_ways(into);
        let next = self.active.get_mut(&into).ok_or_else(|| CityError::NoScene(RegionLabel::new(&space, into)))?;
        let room = side.room.or_else(|| next.room_to_enter().map(|(room, _)| room)).unwrap_or(NodeId(0));
        let done = match next.arrive(&departure, (into, room), &shift, threshold, (beside(plan, into), &taken)) {
            Ok((spot, entered)) => {
                for node in departure.nodes() {
                    if self.space().made_in(node) == Some(into) {
                        self.whereabouts.remove(&node);
                    } else {
                        self.whereabouts.insert(node, into);
                    }
                }
                (crossing.is_beyond, crossing.begun) = (true, self.tick);
                crossing.way = way_in(plan, into, spot);
                self.changed(agent, left.then(entered));
                Ok(())
            }
            Err(why) => Err(CityError::of_travel(&space, why)),
        };
        if done.is_err() {
            // Nobody is lost between two regions.
            self.active.extend(before);
        }
        done
    }

    /// The spots of a region to which those go who are coming in.
    fn ends_of_ways(&self, region: RegionId) -> Vec<Point2<f32>> {
        let end = |journey: &Journey| match &journey.stage {
            Stage::Crossing(crossing) if crossing.is_beyond && crossing.into == region => {
                crossing.way.last().map(|end| end.xy())
            }
            _ => None,
        };
        self.journeys.values().filter_map(end).collect()
    }

    fn come_through(&mut self, agent: NodeId, crossing: &Crossing) {
        let last = crossing.way.last().copied().unwrap_or_else(Point3::origin);
        if let Some(environment) = self.environment_mut(agent) {
            let rotation = environment.world().pose(agent).map_or_else(UnitQuaternion::identity, |pose| pose.rotation);
            environment.place_feet(agent, Pose::from_parts(last.coords.into(), rotation));
        }
    }
}

/// Whether the stairs of a portal lead up to it from a region.
fn leads_up(plan: &Portal, from: RegionId) -> bool {
    !plan.stairs.is_empty() && plan.sides[0].region == from
}

/// The point of a region from which one goes through a portal, or to which one comes: the foot of its stairs, or a step
/// behind its threshold.
fn beside(plan: &Portal, region: RegionId) -> Point2<f32> {
    let foot = plan.stairs.first().filter(|_| leads_up(plan, region));
    let inside = plan.side(region).map(|side| side.pose * Point3::new(-INWARD, 0.0, 0.0));
    foot.copied().or(inside).map_or_else(Point2::origin, |point| point.xy())
}

/// The way from where somebody stands to the threshold of a portal.
fn way_out(plan: &Portal, from: RegionId, feet: &Pose) -> Vec<Point3<f32>> {
    let threshold = plan.side(from).map(|side| Point3::from(side.pose.translation.vector));
    let stairs = plan.stairs.iter().copied().filter(|_| leads_up(plan, from));
    std::iter::once(Point3::from(feet.translation.vector)).chain(stairs).chain(threshold).collect()
}

/// The way from the threshold of a portal to a free place behind it.
fn way_in(plan: &Portal, into: RegionId, spot: Point2<f32>) -> Vec<Point3<f32>> {
    let threshold = plan.side(into).map(|side| Point3::from(side.pose.translation.vector));
    let stairs: Vec<Point3<f32>> = plan.stairs.iter().rev().copied().filter(|_| leads_up(plan, into)).collect();
    let level = stairs.last().or(threshold.as_ref()).map_or(0.0, |point| point.z);
    threshold.into_iter().chain(stairs).chain([Point3::new(spot.x, spot.y, level)]).collect()
}

/// The pose of feet after some seconds on a way; none once it is at its end.
fn along(way: &[Point3<f32>], seconds: f32) -> Option<Pose> {
    let mut left = seconds;
    for step in way.windows(2) {
        let between = step[1] - step[0];
        let slope = between.z.abs() > 0.1 * between.xy().norm();
        let takes = between.norm() / if slope { STAIRS } else { LEVEL };
        if left < takes {
            let at = step[0] + between * (left / takes);
            let heading = between.y.angle_to(between.x);
            return Some(Pose::from_parts(
                at.coords.into(),
                UnitQuaternion::from_axis_angle(&Vector3::z_axis(), heading),
            ));
        }
        left -= takes;
    }
    None
}
