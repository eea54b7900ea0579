//! The timetable: where everybody in a city is at any tick, as a function of it.

mod agenda;
mod demand;
mod kerbs;
mod land_use;
mod log;
mod pace;
mod queue;
mod schedule;
mod step;
mod walk;

use std::sync::Arc;

use thiserror::Error;
use vc_graph::clock::{TICKS_PER_SECOND, Tick};
use vc_graph::hash::Digester;
use vc_graph::portable::Portable;
use vc_graph::{Digest, Seed};
use vc_map::{EntranceId, LaneId, MovementId, Point, RoadId, StreetMap};

pub use demand::{Demand, DemandError, Errand, Outing, Resident};
pub use land_use::LandUse;

use crate::ground::{Ground, Links};
use crate::network::{NONE, Network};
use crate::trip::{Kerb, PersonId, Trip, VehicleId, Walk};
use crate::{Pose, VehicleClass};
use pace::Paces;
use schedule::Schedule;
use step::Step;
use walk::{FootWay, Pavements};

const TICKS: f64 = TICKS_PER_SECOND as f64;

/// Settings of a timetable.
#[derive(Debug, Clone, PartialEq)]
pub struct TimetableOptions {
    /// The days that it has, from 1 to 365. Weeks are repeated; after the last day all stay where they are.
    pub days: u32,
    /// The kinds of vehicles, of which the first is that of everybody's car.
    pub classes: Vec<VehicleClass>,
}

impl Default for TimetableOptions {
    /// A week, with the built-in kinds of vehicles.
    fn default() -> Self {
        Self { days: 7, classes: VehicleClass::built_in() }
    }
}

/// Something that a timetable cannot be made of.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum TimetableError {
    /// There are no days, or too many.
    #[error("a timetable of {0} days: give 1 to 365")]
    Days(u32),
    /// There are no kinds of vehicles.
    #[error("no kinds of vehicles: give one at least, that of cars")]
    Classes,
    /// A person's home or week cannot be.
    #[error("{person}: {reason}")]
    Person {
        /// The person.
        person: PersonId,
        /// The reason.
        reason: String,
    },
}

/// Where somebody is at a tick.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Whereabouts {
    /// In a building.
    Indoors {
        /// Its door.
        door: EntranceId,
        /// Their reason to be there.
        errand: Errand,
    },
    /// On the way on foot.
    OnFoot {
        /// The place.
        at: Point,
        /// The direction in which they look, radians from the X axis, counter-clockwise.
        heading: f64,
        /// Their speed, metres per second: 0 where they wait for a light.
        speed: f32,
    },
    /// In their car.
    Driving {
        /// The car.
        vehicle: VehicleId,
        /// Its pose.
        pose: Pose,
    },
}

/// Sums over a timetable.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Figures {
    /// Journeys on foot.
    pub on_foot: usize,
    /// Journeys by car.
    pub by_car: usize,
    /// Those that were to be by car, and were made on foot, as no road leads there or the car was elsewhere.
    pub without_road: usize,
    /// Those that were not made, as no way leads there.
    pub without_way: usize,
    /// How often a vehicle went where there was no room, after three minutes: where lanes in a ring are full, nobody could go else.
    pub squeezed: usize,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Activity {
    At(EntranceId, Errand),
    /// The number of the way.
    Walk(u32),
    /// The number of the drive.
    Drive(u32),
}

/// A part of somebody's time, from a tick on.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Stage {
    begins: u32,
    activity: Activity,
}

/// Where everybody in a city is at any tick. People leave home when they mean to, walk or drive, wait at lights and in queues, and come back; all of
/// that is made once, event by event: on each lane vehicles go at its limit, wait in a queue for those ahead, for lights, for those who go
/// first and for room behind the junction, and leave it one by one. A place that is asked for afterwards is a function of the tick, costs nothing while
/// nobody asks, and is the same whoever asks in which order. Tick 0 is midnight before a Monday. Clones share everything.
///
/// ```
/// # use vc_graph::Seed;
/// # use vc_graph::clock::{Span, Tick};
/// # use vc_map::{Building, BuildingId, Control, CrossSection, EntranceDraft, MapDraft, RoadClass, Strip};
/// use vc_traffic::{Demand, Errand, PersonId, Timetable, TimetableOptions, Whereabouts};
/// # let mut draft = MapDraft::new("street", 48.1, 11.6);
/// # let ends = [[0.0, 0.0], [900.0, 0.0]].map(|at| draft.junction(at, Control::Priority));
/// # let side = vec![Strip::driving(3.0, 10.0), Strip::pavement(2.0)];
/// # let section = CrossSection { forward: side.clone(), backward: side, median: 0.0 };
/// # draft.road(ends[0], ends[1], RoadClass::Residential, section);
/// # for x in [50.0, 750.0] {
/// #     draft.buildings.push(Building::new(vec![[x, 6.0], [x + 9.0, 6.0], [x, 16.0]], 3));
/// #     let building = BuildingId(draft.buildings.len() as u32 - 1);
/// #     draft.entrances.push(EntranceDraft { building, at: [x, 6.0], kind: "main".into(), source: 0 });
/// # }
/// # let map = draft.build()?; // a street of 900 m with two houses, 700 m from each other
/// let demand = Demand::read("home 0\nmon-fri 08:00 work 1 foot\nmon-fri 16:00 home 0 foot")?;
/// let timetable = Timetable::new(&map, &demand, &TimetableOptions::default(), Seed(7))?;
/// let at = |hours: f64| timetable.place_at(PersonId(0), Tick::default() + Span::from_seconds(3600.0 * hours));
/// assert!(matches!(at(3.0), Some(Whereabouts::Indoors { errand: Errand::Home, .. })));
/// assert!(matches!(at(8.1), Some(Whereabouts::OnFoot { .. })));
/// assert!(matches!(at(12.0), Some(Whereabouts::Indoors { errand: Errand::Work, .. })));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone)]
pub struct Timetable {
    of: Arc<Table>,
}

struct Table {
    network: Arc<Network>,
    paces: Arc<Paces>,
    ground: Arc<Ground>,
    car: VehicleClass,
    /// The stages of each, one after the other, and where those of each begin.
    stages: Vec<Stage>,
    first: Vec<u32>,
    speeds: Vec<f32>,
    ways: Vec<FootWay>,
    /// The steps of drives, one drive after the other, and where each begins.
    steps: Vec<Step>,
    drives: Vec<u32>,
    figures: Figures,
}

impl Timetable {
    /// The timetable of a demand. Costs a search for each way that somebody goes, some microseconds for each lane that a vehicle passes, and a look
    /// at each half metre of the walkable network.
    ///
    /// # Errors
    /// [`TimetableError`]: days that there are not; a door, a day or a time that there is not, journeys that are not in the order of their times, a car that
    /// somebody does not have or has left elsewhere.
    pub fn new(
        map: &StreetMap,
        demand: &Demand,
        options: &TimetableOptions,
        seed: Seed,
    ) -> Result<Self, TimetableError> {
        if !(1..=365).contains(&options.days) {
            return Err(TimetableError::Days(options.days));
        }
        let car = options.classes.first().ok_or(TimetableError::Classes)?;
        for (number, person) in demand.people.iter().enumerate() {
            let fault = |reason| TimetableError::Person { person: PersonId(number as u32), reason };
            check(map, person).map_err(fault)?;
        }
        let network = Arc::new(Network::new(map));
        let ground = Arc::new(Ground::new(&network, Arc::new(Links::new(&network))));
        let paces = Arc::new(Paces::new(&network, car));
        let pavements = Pavements::new(network.clone(), ground.clone());
        let mut schedule = Schedule::new(&network, &paces, pavements, &demand.people, options.days, car, seed);
        let people = schedule.run();
        let mut first = vec![0];
        first.extend(people.iter().scan(0, |all, stages| {
            *all += stages.len() as u32;
            Some(*all)
        }));
        let Schedule { queues, ways, speeds, figures, .. } = schedule;
        let (steps, drives) = queues.finish();
        let (stages, car) = (people.concat(), car.clone());
        Ok(Self {
            of: Arc::new(Table { network, paces, ground, car, stages, first, speeds, ways, steps, drives, figures }),
        })
    }

    /// The number of people.
    pub fn people(&self) -> usize {
        self.of.speeds.len()
    }

    /// Where somebody is at a tick; `None` for numbers beyond the last. Costs two searches in lists, and for those on foot a look
    /// at each light on their way.
    pub fn place_at(&self, person: PersonId, tick: Tick) -> Option<Whereabouts> {
        let table = &*self.of;
        let Stage { begins, activity } = table.stage(person, tick)?;
        match activity {
            Activity::At(door, errand) => Some(Whereabouts::Indoors { door, errand }),
            Activity::Walk(way) => {
                let way = &table.ways[way as usize];
                let speed = table.speeds[person.0 as usize];
                let come = way.come(&table.network.map, begins, speed, tick.0 as f64);
                let (at, along, walks) = way.place(&table.ground, &come)?;
                let speed = if walks { speed } else { 0.0 };
                Some(Whereabouts::OnFoot { at, heading: along.y.angle_to(along.x), speed })
            }
            Activity::Drive(drive) => {
                Some(Whereabouts::Driving { vehicle: VehicleId(person.0), pose: table.pose(drive, tick)? })
            }
        }
    }

    /// A vehicle on the road at a tick; `None` while it is parked, off the road. Costs as [`Self::place_at`].
    pub fn vehicle_at(&self, vehicle: VehicleId, tick: Tick) -> Option<Pose> {
        match self.of.stage(PersonId(vehicle.0), tick)?.activity {
            Activity::Drive(drive) => self.of.pose(drive, tick),
            _ => None,
        }
    }

    /// The journeys that begin in some time as `Traffic` takes them, with their times from its beginning on: by car from kerb to kerb, and on foot from
    /// door to door. So the same people can be moved step by step. Costs a look at all stages.
    pub fn journeys(&self, within: std::ops::Range<Tick>) -> (Vec<Trip>, Vec<Walk>) {
        let table = &*self.of;
        let (mut trips, mut walks) = (Vec::new(), Vec::new());
        for own in table.first.windows(2).map(|ends| &table.stages[ends[0] as usize..ends[1] as usize]) {
            for (number, Stage { begins, activity }) in own.iter().enumerate() {
                let tick = Tick(u64::from(*begins));
                if !within.contains(&tick) {
                    continue;
                }
                let departs = (tick - within.start).seconds() as f32;
                let neighbours = (own.get(number.wrapping_sub(1)), own.get(number + 1));
                let neighbours = (neighbours.0.map(|of| of.activity), neighbours.1.map(|of| of.activity));
                match (activity, neighbours) {
                    (Activity::Drive(drive), _) => trips.extend(table.trip(*drive, departs)),
                    (Activity::Walk(_), (Some(Activity::At(from, _)), Some(Activity::At(to, _)))) => {
                        walks.push(Walk { departs, from, to });
                    }
                    _ => {}
                }
            }
        }
        (trips, walks)
    }

    /// The number of vehicles that begin each movement of the map in some time, by its number. Costs a look at all steps.
    pub fn went(&self, within: std::ops::Range<Tick>) -> Vec<u32> {
        let network = &self.of.network;
        let mut went = vec![0; network.from.len()];
        for pair in self.of.steps.windows(2) {
            let over = pair[1].movement != NONE && within.contains(&Tick(u64::from(pair[0].leaves)));
            if over {
                went[network.movement(pair[1].movement)] += 1;
            }
        }
        went
    }

    /// Sums over all days.
    pub fn figures(&self) -> Figures {
        self.of.figures
    }

    /// A number of all that it says: equal for equal timetables. Costs one pass over it.
    pub fn digest(&self) -> Digest {
        let mut hasher = Digester::new();
        for Stage { begins, activity } in &self.of.stages {
            let [kind, number] = match activity {
                Activity::At(door, errand) => [*errand as u32, door.0],
                Activity::Walk(way) => [8, *way],
                Activity::Drive(drive) => [9, *drive],
            };
            hasher.words([*begins, kind, number].map(u64::from));
        }
        for step in &self.of.steps {
            hasher.words([step.lane, step.enters, step.leaves].map(u64::from)).reals([
                step.begin,
                step.stands,
                step.end,
            ]);
        }
        hasher.reals(self.of.speeds.iter().copied());
        hasher.digest()
    }
}

impl Table {
    /// The stage of somebody at a tick.
    fn stage(&self, person: PersonId, tick: Tick) -> Option<Stage> {
        let number = person.0 as usize;
        let [from, to] = [*self.first.get(number)?, *self.first.get(number + 1)?];
        let own = &self.stages[from as usize..to as usize];
        let begun = own.partition_point(|stage| u64::from(stage.begins) <= tick.0);
        own.get(begun.max(1) - 1).copied()
    }

    /// The steps of a drive.
    fn drive(&self, drive: u32) -> Option<&[Step]> {
        let [from, to] = [drive, drive + 1].map(|drive| self.drives.get(drive as usize).copied());
        self.steps.get(from? as usize..to? as usize)
    }

    fn trip(&self, drive: u32, departs: f32) -> Option<Trip> {
        let steps = self.drive(drive)?;
        let kerb = |lane: u32, station| {
            let side = self.network.side[lane as usize];
            Kerb { road: RoadId(side / 2), forward: side.is_multiple_of(2), station }
        };
        let (first, last) = (steps.first()?, steps.last()?);
        Some(Trip { class: 0, departs, from: kerb(first.from, first.begin), to: kerb(last.lane, last.end) })
    }

    fn pose(&self, drive: u32, tick: Tick) -> Option<Pose> {
        let steps = self.drive(drive)?;
        let VehicleClass { length, width, .. } = self.car;
        let body = step::body(&self.network, &self.paces, steps, f64::from(length), tick.0 as f64)?;
        let forward = (body.front - body.rear).try_normalize(1e-3).unwrap_or(body.along);
        let on_lane = self.network.is_lane(body.link);
        Some(Pose {
            at: nalgebra::center(&body.front, &body.rear),
            heading: forward.y.angle_to(forward.x),
            speed: body.speed as f32,
            class: 0,
            lane: on_lane.then_some(LaneId(body.link)),
            movement: (!on_lane).then(|| MovementId(self.network.movement(body.link) as u32)),
            station: body.station as f32,
            size: [length, width],
        })
    }
}

/// Why somebody's week cannot be.
fn check(map: &StreetMap, person: &Resident) -> Result<(), String> {
    let doors = map.entrances().len();
    let (mut at, mut car, mut before) = (person.home, person.home, (0, 0));
    let all = std::iter::once(person.home).chain(person.week.iter().map(|outing| outing.to));
    if let Some(door) = all.into_iter().find(|door| door.index() >= doors) {
        return Err(format!("{door} of {doors}"));
    }
    for Outing { day, leaves, to, by_car, .. } in person.week.iter().copied() {
        let time = || format!("day {day}, {:02}:{:02}", leaves / 3600, leaves / 60 % 60);
        if day > 6 || leaves >= vc_graph::clock::DAY {
            return Err(format!("leaves on day {day} at {leaves} s: give days from 0 to 6 and times below a day"));
        }
        if (day, leaves) < before {
            return Err(format!("leaves for {to} ({}) after a later journey: sort them by their times", time()));
        }
        if by_car && !person.car {
            return Err(format!("drives to {to} ({}) without a car: give them one, or let them walk", time()));
        }
        if by_car && car != at {
            return Err(format!(
                "drives from {at} to {to} ({}), and their car is at {car}: let them fetch it on foot",
                time()
            ));
        }
        (before, at) = ((day, leaves), to);
        if by_car {
            car = to;
        }
    }
    if at != person.home {
        return Err(format!("is at {at} when the week ends: let them come home to {}", person.home));
    }
    if car != person.home {
        return Err(format!("their car is at {car} when the week ends: let them drive home"));
    }
    Ok(())
}
