//! Traffic: vehicles that go from place to place on a map, step by step.

use std::collections::{BTreeMap, VecDeque};
use std::sync::Arc;

use thiserror::Error;
use vc_graph::hash::Digester;
use vc_graph::{Digest, Seed};
use vc_map::route::{Mode, Router};
use vc_map::{Light, StreetMap};

use crate::block::Block;
use crate::crowd::Walker;
use crate::fleet::Fleet;
use crate::follow::Driver;
use crate::foot::Foot;
use crate::ground::Links;
use crate::lights;
use crate::network::{NONE, Network};
use crate::roads::Roads;
use crate::swept::{Swept, is_long};
use crate::trip::{PersonId, TrafficEvent, Trip, VehicleId, Waiting, Walk};
use crate::{Obstacle, Pose, VehicleClass};

/// Who stands so near before somebody or something waits for that, metres.
const NEAR: f32 = 5.0;

/// Settings of traffic.
#[derive(Debug, Clone, PartialEq)]
pub struct TrafficOptions {
    /// The time of a step, seconds, from 0.02 to 1.
    pub step: f32,
    /// The kinds of vehicles.
    pub classes: Vec<VehicleClass>,
}

impl Default for TrafficOptions {
    fn default() -> Self {
        Self { step: 0.1, classes: VehicleClass::built_in() }
    }
}

/// Something that traffic cannot be made of.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum TrafficError {
    /// A step is too short or too long.
    #[error("a step of {0} s: give one from 0.02 to 1 s")]
    Step(f32),
    /// There are no kinds of vehicles, or too many.
    #[error("{0} kinds of vehicles: give 1 to 255")]
    Classes(usize),
    /// A trip names a kind of vehicle, a road or a number that there is not.
    #[error("{vehicle}: {reason}")]
    Trip {
        /// The vehicle.
        vehicle: VehicleId,
        /// The reason.
        reason: String,
    },
    /// An obstacle is nowhere, or too small or large.
    #[error("obstacle {number}: {reason}")]
    Obstacle {
        /// Its position in the list.
        number: usize,
        /// The reason.
        reason: String,
    },
    /// A walk names a door or a time that there is not.
    #[error("{person}: {reason}")]
    Walk {
        /// The person.
        person: PersonId,
        /// The reason.
        reason: String,
    },
}

/// Vehicles on a map. They follow each other, change lanes, stop at red lights, give way, and keep junctions free; their bodies
/// never overlap. The same map, trips and seed give the same state, bit for bit.
///
/// ```
/// use vc_traffic::{Kerb, Traffic, TrafficEvent, TrafficOptions, Trip};
/// # use vc_graph::Seed;
/// # use vc_map::{Control, CrossSection, MapDraft, RoadClass, RoadId, Strip};
/// # let mut draft = MapDraft::new("street", 48.1, 11.6);
/// # let ends = [[0.0, 0.0], [200.0, 0.0], [400.0, 0.0]].map(|at| draft.junction(at, Control::Priority));
/// # let side = vec![Strip::driving(3.0, 13.9)];
/// # for pair in ends.windows(2) {
/// #     let section = CrossSection { forward: side.clone(), backward: side.clone(), median: 0.0 };
/// #     draft.road(pair[0], pair[1], RoadClass::Residential, section);
/// # }
/// # let map = draft.build()?; // a street of two roads along X
/// let kerb = |road, station| Kerb { road: RoadId(road), forward: true, station };
/// let trips = vec![Trip { class: 0, departs: 0.0, from: kerb(0, 20.0), to: kerb(1, 150.0) }];
/// let mut traffic = Traffic::new(&map, trips, &TrafficOptions::default(), Seed(7))?;
/// let arrived = (0..600).find(|_| {
///     traffic.step();
///     traffic.events().iter().any(|event| matches!(event, TrafficEvent::Arrived { .. }))
/// });
/// // 330 m, from a standstill.
/// assert!(arrived.is_some_and(|step| (250..400).contains(&step)));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone)]
pub struct Traffic {
    pub(crate) network: Arc<Network>,
    /// The swept paths of long vehicles, if there are such.
    pub(crate) swept: Option<Arc<Swept>>,
    pub(crate) router: Arc<Router>,
    pub(crate) classes: Arc<Vec<VehicleClass>>,
    pub(crate) drivers: Arc<Vec<Driver>>,
    pub(crate) trips: Arc<Vec<Trip>>,
    /// The trips in the order of their departure.
    pub(crate) order: Arc<Vec<u32>>,
    pub(crate) dt: f32,
    pub(crate) seed: Seed,
    pub(crate) step: u64,
    /// The next trip in that order.
    pub(crate) coming: usize,
    /// The trips that wait for room, by the side of the road on which they begin.
    pub(crate) pending: BTreeMap<u32, VecDeque<u32>>,
    pub(crate) fleet: Fleet,
    /// The sides of roads that each vehicle goes along, by slot.
    pub(crate) routes: Vec<Vec<u32>>,
    pub(crate) roads: Roads,
    pub(crate) phases: Vec<usize>,
    /// Those who have to change lanes and have no gap, and the lane that they want.
    pub(crate) wanting: Vec<(u32, u32)>,
    pub(crate) events: Vec<TrafficEvent>,
    /// The slot of each vehicle on the road.
    pub(crate) slots: BTreeMap<VehicleId, u32>,
    pub(crate) foot: Foot,
    /// The parts of links that are taken up, by link; those of obstacles, and these.
    pub(crate) blocks: Vec<Block>,
    pub(crate) obstructed: Vec<Block>,
    pub(crate) obstacles: Vec<Obstacle>,
    pub(crate) links: Option<Arc<Links>>,
}

impl Traffic {
    /// Traffic at its start, without vehicles. Costs a look at each movement of the map, and a router.
    ///
    /// # Errors
    /// [`TrafficError`]: a step out of its range, no kinds of vehicles, trips of kinds and places that there are not.
    pub fn new(map: &StreetMap, trips: Vec<Trip>, options: &TrafficOptions, seed: Seed) -> Result<Self, TrafficError> {
        if !(0.02..=1.0).contains(&options.step) {
            return Err(TrafficError::Step(options.step));
        }
        if options.classes.is_empty() || options.classes.len() > 255 {
            return Err(TrafficError::Classes(options.classes.len()));
        }
        let mut network = Network::new(map);
        for (number, trip) in trips.iter().enumerate() {
            let fault = |reason| TrafficError::Trip { vehicle: VehicleId(number as u32), reason };
            check(&network, trip, options.classes.len()).map_err(fault)?;
        }
        let swept = longest(&trips, &options.classes).map(|size| Arc::new(Swept::new(&mut network, size)));
        let mut order: Vec<u32> = (0..trips.len() as u32).collect();
        order.sort_by(|a, b| trips[*a as usize].departs.total_cmp(&trips[*b as usize].departs).then(a.cmp(b)));
        let drivers = options.classes.iter().map(Driver::new).collect();
        Ok(Self {
            roads: Roads::new(&network),
            phases: vec![0; map.signals().len()],
            router: Arc::new(Router::new(map, Mode::Car)),
            network: Arc::new(network),
            swept,
            classes: Arc::new(options.classes.clone()),
            drivers: Arc::new(drivers),
            trips: Arc::new(trips),
            order: Arc::new(order),
            dt: options.step,
            seed,
            step: 0,
            coming: 0,
            pending: BTreeMap::new(),
            fleet: Fleet::default(),
            routes: Vec::new(),
            wanting: Vec::new(),
            events: Vec::new(),
            slots: BTreeMap::new(),
            foot: Foot::none(map, options.step),
            blocks: Vec::new(),
            obstructed: Vec::new(),
            obstacles: Vec::new(),
            links: None,
        })
    }

    /// The same with people who walk from door to door: on pavements and paths, beside streets without pavements, over crossings in their green
    /// or where vehicles leave it to them, and where there is none in gaps between vehicles. Costs a router, and a look at each half metre of
    /// the walkable network.
    ///
    /// # Errors
    /// [`TrafficError::Walk`]: doors that the map does not have, a time that is none.
    pub fn with_walks(mut self, walks: Vec<Walk>) -> Result<Self, TrafficError> {
        let doors = self.map().entrances().len();
        for (number, walk) in walks.iter().enumerate() {
            let missing = [walk.from, walk.to].into_iter().find(|door| door.index() >= doors);
            let reason = match missing {
                Some(door) => format!("{door} of {doors}"),
                None if !(0.0..=1e7).contains(&walk.departs) => {
                    format!("departs at {} s: give a time from 0 on", walk.departs)
                }
                None => continue,
            };
            return Err(TrafficError::Walk { person: PersonId(number as u32), reason });
        }
        let links = self.links();
        self.foot.set(&self.network, links, walks);
        Ok(self)
    }

    /// One step: who may go, speeds, ways, lanes, departures. Costs some 0.1 to 0.2 microseconds for each vehicle.
    pub fn step(&mut self) {
        self.events.clear();
        self.signals();
        self.cross();
        self.right_of_way();
        self.accelerate();
        self.advance();
        self.change_lanes();
        self.depart();
        self.walk();
        self.step += 1;
    }

    /// The time since the start, seconds.
    pub fn seconds(&self) -> f64 {
        self.step as f64 * f64::from(self.dt)
    }

    /// The map.
    pub fn map(&self) -> &StreetMap {
        &self.network.map
    }

    /// The events of the last step.
    pub fn events(&self) -> &[TrafficEvent] {
        &self.events
    }

    /// The number of vehicles on the roads.
    pub fn len(&self) -> usize {
        self.fleet.len()
    }

    /// Whether no vehicle is on the roads.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The number of trips that have not begun: those that wait for room, and those whose time has not come.
    pub fn waiting(&self) -> usize {
        self.pending.values().map(VecDeque::len).sum::<usize>() + self.order.len() - self.coming
    }

    /// The vehicles on the roads, by their numbers. Costs a look at each.
    pub fn vehicles(&self) -> impl Iterator<Item = (VehicleId, Pose)> {
        self.slots.iter().map(|(id, slot)| (*id, self.pose(*slot)))
    }

    /// A vehicle on the road; `None` before it sets out and after it has arrived.
    pub fn vehicle(&self, id: VehicleId) -> Option<Pose> {
        self.slots.get(&id).map(|slot| self.pose(*slot))
    }

    /// The people on foot who are on their way, by their numbers. Costs a look at each.
    pub fn people(&self) -> impl Iterator<Item = Walker> {
        self.foot.crowd.people()
    }

    /// The number of walks that have not begun: those that wait for room at their door, and those whose time has not come.
    pub fn waiting_on_foot(&self) -> usize {
        self.foot.waiting()
    }

    /// A number of everything that decides on what follows: equal for equal states.
    pub fn digest(&self) -> Digest {
        let mut hasher = Digester::new();
        hasher.word(self.step).word(self.coming as u64);
        for (id, slot) in &self.slots {
            let i = *slot as usize;
            hasher.words([u64::from(id.0), u64::from(self.fleet.link[i]), u64::from(self.fleet.next[i])]);
            hasher.reals([self.fleet.s[i], self.fleet.v[i], self.fleet.aside[i], self.fleet.stood[i]]);
        }
        hasher.words(self.pending.values().flatten().map(|trip| u64::from(*trip)));
        hasher.words(self.foot.words());
        hasher.reals(self.obstacles.iter().flat_map(|of| [of.at[0], of.at[1], of.radius, f32::from(of.layer)]));
        hasher.digest()
    }

    /// Sets the phases of the signals.
    fn signals(&mut self) {
        let now = self.step as f64 * f64::from(self.dt);
        for (signal, phase) in self.network.map.signals().iter().zip(&mut self.phases) {
            *phase = lights::phase(signal, now).0;
        }
    }

    /// The light for a movement; `None` at junctions without lights.
    pub(crate) fn light(&self, movement: usize) -> Option<Light> {
        self.light_of(self.network.junction[movement] as usize, self.network.row[movement] as usize)
    }

    /// The light for a row of a junction's table.
    pub(crate) fn light_of(&self, junction: usize, row: usize) -> Option<Light> {
        let id = self.network.map.junctions()[junction].signal?;
        lights::light(self.network.map.signal(id)?, *self.phases.get(id.index())?, row)
    }

    /// The reason for which a vehicle stands.
    pub(crate) fn reason(&self, slot: u32) -> Waiting {
        let (fleet, network) = (&self.fleet, &self.network);
        let i = slot as usize;
        let link = fleet.link[i];
        let first = self.roads.queue[link as usize].front() == Some(&slot);
        if self.gap_to_block(slot, link, fleet.s[i]).is_some_and(|gap| gap < NEAR) {
            return Waiting::Blocked;
        }
        if !first || !network.is_lane(link) {
            return Waiting::Queue;
        }
        if fleet.next[i] == NONE {
            return Waiting::WrongLane;
        }
        let movement = network.movement(fleet.next[i]);
        match self.light(movement) {
            Some(Light::Red | Light::Yellow) => Waiting::Light,
            _ if !self.has_room(slot, movement) => Waiting::NoRoom,
            _ => Waiting::Others,
        }
    }
}

/// The greatest length and width of the long vehicles of some trips.
fn longest(trips: &[Trip], classes: &[VehicleClass]) -> Option<[f32; 2]> {
    let used = |number: &usize| trips.iter().any(|trip| usize::from(trip.class) == *number);
    let long = (0..classes.len()).filter(|number| is_long(classes[*number].length)).filter(used);
    let sizes = long.map(|number| [classes[number].length, classes[number].width]);
    sizes.reduce(|most, size| [most[0].max(size[0]), most[1].max(size[1])])
}

/// Why a trip cannot be made of its numbers.
fn check(network: &Network, trip: &Trip, classes: usize) -> Result<(), String> {
    if usize::from(trip.class) >= classes {
        return Err(format!("kind of vehicle {} of {classes}", trip.class));
    }
    if !(0.0..=1e7).contains(&trip.departs) {
        return Err(format!("departs at {} s: give a time from 0 on", trip.departs));
    }
    for kerb in [&trip.from, &trip.to] {
        if network.sides.get(kerb.side() as usize).is_none_or(Vec::is_empty) {
            return Err(format!("no lane for vehicles on that side of {}", kerb.road));
        }
        if !kerb.station.is_finite() {
            return Err(format!("station {} m on {}", kerb.station, kerb.road));
        }
    }
    Ok(())
}
