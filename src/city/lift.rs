//! Lifts: cabins that move between stops, and doors that let people in and out.

use std::collections::{BTreeMap, BTreeSet};

use nalgebra::Point3;
use serde::{Deserialize, Serialize};
use vc_graph::clock::{TICKS_PER_SECOND, Tick};
use vc_graph::hash::Digester;
use vc_graph::space::{Portal, Region, RegionFrame, RegionId, Space};

use super::measures::{ACCELERATION, DOOR, OPEN, SPEED};

/// The state of a lift.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[non_exhaustive]
pub enum LiftState {
    /// It stands at a stop, counted from 0, with shut doors.
    Shut(u32),
    /// Its doors are opening at a stop.
    Opening(u32),
    /// It stands at a stop with open doors.
    Open(u32),
    /// Its doors are closing at a stop. A call from there opens them again.
    Closing(u32),
    /// It moves from one stop to another, with shut doors.
    Moving {
        /// The stop that it has left.
        from: u32,
        /// The stop where it goes.
        to: u32,
    },
}

/// A lift. It moves with shut doors only, which shut only while nobody and nothing is between them; it goes on in one direction
/// while there are calls ahead.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct Lift {
    /// Where its stops are, metres.
    #[serde(skip)]
    stops: Vec<Point3<f64>>,
    state: LiftState,
    since: Tick,
    is_upward: bool,
    calls: BTreeSet<u32>,
}

/// The lifts of a city. Those that nobody has called cost nothing.
#[derive(Debug, Clone, Default)]
pub(super) struct Lifts {
    all: BTreeMap<RegionId, Lift>,
    /// The cabins of those that are not idle.
    busy: BTreeSet<RegionId>,
}

impl Lifts {
    /// The lifts of a plan, each at its first stop.
    pub(super) fn new(space: &Space) -> Self {
        let moving = space.regions().filter(|(_, region)| !region.stops.is_empty());
        Self { all: moving.map(|(id, region)| (id, Lift::new(region))).collect(), busy: BTreeSet::new() }
    }

    /// Lifts that were saved; none if they are not those of the plan.
    pub(super) fn restored(saved: BTreeMap<RegionId, Lift>, space: &Space) -> Option<Self> {
        let lift = |(region, lift): (RegionId, Lift)| Some((region, lift.restored(space.region(region)?)?));
        let all = saved.into_iter().map(lift).collect::<Option<BTreeMap<RegionId, Lift>>>()?;
        let busy = all.iter().filter(|(_, lift)| !lift.is_idle()).map(|(region, _)| *region).collect();
        all.keys().eq(Self::new(space).all.keys()).then_some(Self { all, busy })
    }

    /// All of them by their cabins.
    pub(super) fn all(&self) -> &BTreeMap<RegionId, Lift> {
        &self.all
    }

    /// The lift whose cabin is a region.
    pub(super) fn get(&self, cabin: RegionId) -> Option<&Lift> {
        self.all.get(&cabin)
    }

    /// The cabin on a side of a portal, and its lift.
    pub(super) fn at(&self, portal: &Portal) -> Option<(RegionId, &Lift)> {
        portal.sides.iter().find_map(|side| Some((side.region, self.get(side.region)?)))
    }

    /// Calls the lift of a portal to its stop, from outside or inside.
    pub(super) fn call(&mut self, portal: &Portal) {
        let Some((cabin, _)) = self.at(portal) else { return };
        if let Some(lift) = self.all.get_mut(&cabin) {
            lift.call(portal.stop);
            self.busy.insert(cabin);
        }
    }

    /// Whether none moves or is called.
    pub(super) fn are_idle(&self) -> bool {
        self.busy.is_empty()
    }

    /// The cabins of those that move or are called.
    pub(super) fn busy(&self) -> impl Iterator<Item = RegionId> + '_ {
        self.busy.iter().copied()
    }

    /// The cabins that stand with doors that are not shut, and their stops.
    pub(super) fn standing_open(&self) -> Vec<(RegionId, u32)> {
        use LiftState::{Closing, Open, Opening};
        let stop = |cabin: &RegionId| match self.get(*cabin)?.state {
            Opening(at) | Open(at) | Closing(at) => Some((*cabin, at)),
            _ => None,
        };
        self.busy.iter().filter_map(stop).collect()
    }

    /// The cabins that are about to shut their doors or to leave, and their stops.
    pub(super) fn about_to_shut(&self, now: Tick) -> Vec<(RegionId, u32)> {
        let stop = |cabin: &RegionId| Some((*cabin, self.get(*cabin)?.shuts_at(now)?));
        self.busy.iter().filter_map(stop).collect()
    }

    /// Lets a tick pass; returns the cabins of those that change their state. Some doors are kept open, and opened again.
    pub(super) fn pass(&mut self, now: Tick, kept_open: &BTreeSet<RegionId>) -> Vec<RegionId> {
        let mut changed = Vec::new();
        for &cabin in &self.busy {
            let Some(lift) = self.all.get_mut(&cabin) else { continue };
            let before = lift.state;
            lift.pass(now, kept_open.contains(&cabin));
            changed.extend((lift.state != before).then_some(cabin));
        }
        let idle = |cabin: &RegionId| self.all.get(cabin).is_none_or(Lift::is_idle);
        self.busy.retain(|cabin| !idle(cabin));
        changed
    }
}

impl Lift {
    /// A lift at its first stop.
    fn new(cabin: &Region) -> Self {
        let stops = cabin.stops.iter().map(|stop| stop.origin).collect();
        Self { stops, state: LiftState::Shut(0), since: Tick(0), is_upward: true, calls: BTreeSet::new() }
    }

    /// A lift that was saved, in its cabin's plan; none if it is none of that plan.
    fn restored(self, cabin: &Region) -> Option<Self> {
        use LiftState::{Closing, Moving, Open, Opening, Shut};
        let stops = match self.state {
            Shut(at) | Opening(at) | Open(at) | Closing(at) => [at, at],
            Moving { from, to } => [from, to],
        };
        let last = self.calls.iter().copied().chain(stops).max().unwrap_or_default();
        ((last as usize) < cabin.stops.len()).then(|| Self { stops: Self::new(cabin).stops, ..self })
    }

    /// Calls the cabin to a stop.
    fn call(&mut self, stop: u32) {
        if (stop as usize) < self.stops.len() {
            self.calls.insert(stop);
        }
    }

    pub(super) fn state(&self) -> LiftState {
        self.state
    }

    /// Whether it does nothing, and nobody has called it.
    fn is_idle(&self) -> bool {
        matches!(self.state, LiftState::Shut(_)) && self.calls.is_empty()
    }

    /// Whether it is called to a stop.
    pub(super) fn is_called_to(&self, stop: u32) -> bool {
        self.calls.contains(&stop)
    }

    pub(super) fn is_open_at(&self, stop: u32) -> bool {
        self.state == LiftState::Open(stop)
    }

    /// Whether its doors at a stop are not shut.
    pub(super) fn is_standing_open(&self, stop: u32) -> bool {
        use LiftState::{Closing, Open, Opening};
        [Opening(stop), Open(stop), Closing(stop)].contains(&self.state)
    }

    /// Whether its doors are shut, wherever it is.
    pub(super) fn is_all_shut(&self) -> bool {
        matches!(self.state, LiftState::Shut(_) | LiftState::Moving { .. })
    }

    /// Whether it stands at a stop and is going to leave.
    pub(super) fn is_leaving(&self, stop: u32) -> bool {
        self.is_standing_open(stop) || (self.state == LiftState::Shut(stop) && !self.is_idle())
    }

    /// The stop at which it is going to shut its doors at a tick, or which it is going to leave.
    fn shuts_at(&self, now: Tick) -> Option<u32> {
        match self.state {
            LiftState::Open(at) if now.0.saturating_sub(self.since.0) >= OPEN.0 => Some(at),
            LiftState::Shut(at) if !self.is_idle() => Some(at),
            _ => None,
        }
    }

    /// Goes on at a tick; its doors are kept open if somebody or something is between them.
    fn pass(&mut self, now: Tick, kept_open: bool) {
        use LiftState::{Closing, Moving, Open, Opening, Shut};
        let passed = now.0.saturating_sub(self.since.0);
        let next = match self.state {
            Shut(at) if kept_open || self.calls.contains(&at) => Some(Opening(at)),
            Shut(at) => self.next_call(at).map(|to| Moving { from: at, to }),
            Opening(at) => (passed >= DOOR.0).then_some(Open(at)),
            Open(at) if kept_open || self.calls.remove(&at) => Some(Open(at)),
            Open(at) => (passed >= OPEN.0).then_some(Closing(at)),
            Closing(at) if kept_open || self.calls.contains(&at) => Some(Opening(at)),
            Closing(at) => (passed >= DOOR.0).then_some(Shut(at)),
            Moving { from, to } => (passed >= self.ticks(from, to)).then_some(Shut(to)),
        };
        if let Some(next) = next {
            if let Open(at) = next {
                self.calls.remove(&at);
            }
            (self.state, self.since) = (next, now);
        }
    }

    /// The next stop to which it is called: on in the same direction, or else back.
    fn next_call(&mut self, at: u32) -> Option<u32> {
        let above = self.calls.range(at + 1..).next().copied();
        let below = self.calls.range(..at).next_back().copied();
        let next = if self.is_upward { above.or(below) } else { below.or(above) };
        self.is_upward = next.map_or(self.is_upward, |to| to > at);
        next
    }

    /// Where the cabin is.
    pub(super) fn frame(&self, plan: &Region, now: Tick) -> RegionFrame {
        use LiftState::{Closing, Moving, Open, Opening, Shut};
        match self.state {
            Shut(at) | Opening(at) | Open(at) | Closing(at) => plan.frame_at(at as usize),
            Moving { from, to } => {
                let (start, end) = (plan.frame_at(from as usize), plan.frame_at(to as usize));
                let length = self.length(from, to);
                let share = if length > 0.0 { way(now.0.saturating_sub(self.since.0), length) / length } else { 1.0 };
                let between = start.origin + (end.origin - start.origin) * share;
                RegionFrame { origin: between, heading: start.heading }
            }
        }
    }

    fn length(&self, from: u32, to: u32) -> f64 {
        nalgebra::distance(&self.stops[from as usize], &self.stops[to as usize])
    }

    /// The ticks that it takes from one stop to another.
    fn ticks(&self, from: u32, to: u32) -> u64 {
        let length = self.length(from, to);
        let ramp = SPEED * SPEED / ACCELERATION;
        let seconds =
            if length < ramp { 2.0 * (length / ACCELERATION).sqrt() } else { length / SPEED + SPEED / ACCELERATION };
        (seconds * TICKS_PER_SECOND as f64).ceil() as u64
    }

    pub(super) fn feed(&self, hash: &mut Digester) {
        hash.text(&format!("{:?}", self.state)).words([self.since.0, u64::from(self.is_upward)]);
        hash.words(self.calls.iter().map(|stop| u64::from(*stop)));
    }
}

/// The way that a cabin has gone after some ticks of so many metres: it speeds up, goes on, and slows down.
fn way(ticks: u64, length: f64) -> f64 {
    let time = ticks as f64 / TICKS_PER_SECOND as f64;
    let ramp = (SPEED * SPEED / ACCELERATION).min(length);
    let top = (ACCELERATION * ramp).sqrt();
    let (speeding, total) = (top / ACCELERATION, (length - ramp) / top + 2.0 * top / ACCELERATION);
    let left = (total - time).max(0.0);
    if time < speeding {
        0.5 * ACCELERATION * time * time
    } else if left < speeding {
        length - 0.5 * ACCELERATION * left * left
    } else {
        0.5 * ramp + top * (time - speeding)
    }
}
