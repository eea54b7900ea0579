//! Weeks as they come out: everybody leaves when they mean to, or when they have come back, and drives through the queues of all others.

use std::collections::BTreeMap;
use std::sync::Arc;

use vc_graph::Seed;
use vc_graph::clock::DAY;
use vc_map::EntranceId;
use vc_map::route::{Mode, Router};

use super::agenda::Event;
use super::demand::{Errand, Outing, Resident};
use super::kerbs::Kerbs;
use super::pace::Paces;
use super::queue::Queues;
use super::walk::{FootWay, Pavements};
use super::{Activity, Figures, Stage, TICKS};
use crate::VehicleClass;
use crate::depart;
use crate::foot::free_speed;
use crate::network::Network;
use crate::trip::Kerb;

/// One stays at least so long where one has come, and one who finds no room to pull out tries again after this; ticks.
const STAYS: u32 = 60 * 60;
const TRIES: u32 = 2 * 60;
/// A usual speed in towns, metres per second.
const SPEED: f32 = 12.0;

/// Somebody as they are while their week is made.
struct Person {
    door: EntranceId,
    car: EntranceId,
    /// The next journey of the week, and the week's number.
    next: usize,
    week: u32,
    since: u32,
    stages: Vec<Stage>,
}

/// A drive that is to begin: its way, and the stations where it begins and ends.
type Drive = (Arc<[u32]>, [(u32, f32); 2]);

/// All weeks while they are made.
pub(super) struct Schedule<'a> {
    network: Arc<Network>,
    residents: &'a [Resident],
    days: u32,
    class: &'a VehicleClass,
    /// The time that one loses by setting out from a standstill, ticks.
    starts: u32,
    pub(super) queues: Queues,
    pub(super) ways: Vec<FootWay>,
    pub(super) speeds: Vec<f32>,
    pub(super) figures: Figures,
    pavements: Pavements,
    router: Router,
    kerbs: Kerbs,
    people: Vec<Person>,
    walks: BTreeMap<(EntranceId, EntranceId), Option<u32>>,
    to_kerbs: BTreeMap<EntranceId, Option<[u32; 2]>>,
    drives: BTreeMap<(EntranceId, EntranceId), Option<Drive>>,
    /// The drive that each is to make, by person.
    driving: Vec<Option<Drive>>,
}

impl<'a> Schedule<'a> {
    pub(super) fn new(
        network: &Arc<Network>,
        paces: &Arc<Paces>,
        pavements: Pavements,
        residents: &'a [Resident],
        days: u32,
        class: &'a VehicleClass,
        seed: Seed,
    ) -> Self {
        let person = |of: &Resident| Person {
            door: of.home,
            car: of.home,
            next: 0,
            week: 0,
            since: 0,
            stages: vec![Stage { begins: 0, activity: Activity::At(of.home, Errand::Home) }],
        };
        let seed = seed.child("people");
        Self {
            queues: Queues::new(network, paces, class, residents.len()),
            ways: Vec::new(),
            speeds: (0..residents.len() as u64).map(|number| free_speed(seed.nth(number))).collect(),
            figures: Figures::default(),
            router: Router::new(&network.map, Mode::Car),
            kerbs: Kerbs::new(network),
            people: residents.iter().map(person).collect(),
            walks: BTreeMap::new(),
            to_kerbs: BTreeMap::new(),
            drives: BTreeMap::new(),
            driving: vec![None; residents.len()],
            network: network.clone(),
            residents,
            days,
            class,
            starts: (f64::from(SPEED / (2.0 * class.acceleration)) * TICKS) as u32,
            pavements,
        }
    }

    /// Lets everything happen, in the order of its time. The stages of each.
    pub(super) fn run(&mut self) -> Vec<Vec<Stage>> {
        for person in 0..self.people.len() as u32 {
            self.plan(0, person);
        }
        while let Some((now, event)) = self.queues.agenda.pop() {
            match event {
                Event::Enters(person) => self.queues.enter(now, person),
                Event::Goes(lane) => self.queues.go(now, lane),
                Event::Arrives(person) => {
                    if self.queues.arrive(now, person) {
                        self.get_out(now, person);
                    }
                }
                Event::SetsOut(person) => self.set_out(now, person),
                Event::Leaves(person) => self.leave(now, person),
            }
        }
        self.figures.squeezed = self.queues.squeezed;
        self.people.iter_mut().map(|person| std::mem::take(&mut person.stages)).collect()
    }

    /// Sets when somebody leaves next.
    fn plan(&mut self, now: u32, person: u32) {
        let of = &self.people[person as usize];
        let Some(outing) = self.residents[person as usize].week.get(of.next) else { return };
        let day = of.week * 7 + u32::from(outing.day);
        if day < self.days {
            let means = (day * DAY + outing.leaves) * TICKS as u32;
            self.queues.agenda.push(means.max(now), Event::Leaves(person));
        }
    }

    fn outing(&self, person: u32) -> Outing {
        self.residents[person as usize].week[self.people[person as usize].next]
    }

    fn begin(&mut self, tick: u32, person: u32, activity: Activity) {
        self.people[person as usize].stages.push(Stage { begins: tick, activity });
    }

    /// Somebody leaves their door for the next.
    fn leave(&mut self, now: u32, person: u32) {
        let Outing { to, by_car, errand, .. } = self.outing(person);
        let Person { door: from, car, .. } = self.people[person as usize];
        if from == to {
            self.begin(now, person, Activity::At(to, errand));
            return self.go_on(now, person);
        }
        let drive = if by_car && car == from { self.drive(from, to) } else { None };
        if by_car && drive.is_none() {
            self.figures.without_road += 1;
        }
        if let (Some(drive), Some([out, _])) = (drive, self.ways_to_car(from)) {
            self.figures.by_car += 1;
            self.driving[person as usize] = Some(drive);
            let there = self.walk(now, person, out);
            // It takes longer to get going than the pace of a lane says.
            let gets_in = there + self.starts;
            self.people[person as usize].since = gets_in;
            return self.queues.agenda.push(gets_in, Event::SetsOut(person));
        }
        let Some(way) = self.on_foot(from, to) else {
            self.figures.without_way += 1;
            return self.go_on(now, person);
        };
        self.figures.on_foot += 1;
        let there = self.walk(now, person, way);
        self.come(there, person);
    }

    /// Somebody walks; the tick in which they are there.
    fn walk(&mut self, now: u32, person: u32, way: u32) -> u32 {
        self.begin(now, person, Activity::Walk(way));
        let come = self.ways[way as usize].come(&self.network.map, now, self.speeds[person as usize], f64::INFINITY);
        come.at.ceil() as u32
    }

    /// Somebody is at the door of their errand.
    fn come(&mut self, now: u32, person: u32) {
        let Outing { to, errand, .. } = self.outing(person);
        self.people[person as usize].door = to;
        self.begin(now, person, Activity::At(to, errand));
        self.go_on(now + STAYS, person);
    }

    /// On to the next journey of the week, or of the next week.
    fn go_on(&mut self, now: u32, person: u32) {
        let of = &mut self.people[person as usize];
        of.next += 1;
        if of.next == self.residents[person as usize].week.len() {
            (of.next, of.week) = (0, of.week + 1);
        }
        self.plan(now, person);
    }

    fn set_out(&mut self, now: u32, person: u32) {
        let Some((route, ends)) = self.driving[person as usize].clone() else { return };
        let since = self.people[person as usize].since;
        match self.queues.set_out(now, since, person, &route, ends) {
            Some(drive) => self.begin(now, person, Activity::Drive(drive)),
            None => self.queues.agenda.push(now + TRIES, Event::SetsOut(person)),
        }
    }

    /// Somebody gets out of their car, and walks to the door.
    fn get_out(&mut self, now: u32, person: u32) {
        let to = self.outing(person).to;
        self.people[person as usize].car = to;
        let there = match self.ways_to_car(to) {
            Some([_, back]) => self.walk(now, person, back),
            None => now,
        };
        self.come(there, person);
    }

    /// The way from a door to a door.
    fn on_foot(&mut self, from: EntranceId, to: EntranceId) -> Option<u32> {
        if let Some(known) = self.walks.get(&(from, to)) {
            return *known;
        }
        let way = self.pavements.between(from, to);
        let number = way.map(|way| self.add(way));
        self.walks.insert((from, to), number);
        number
    }

    fn add(&mut self, way: FootWay) -> u32 {
        self.ways.push(way);
        self.ways.len() as u32 - 1
    }

    /// The ways from a door to the car, and back.
    fn ways_to_car(&mut self, door: EntranceId) -> Option<[u32; 2]> {
        if let Some(known) = self.to_kerbs.get(&door) {
            return *known;
        }
        let (lane, kerb) = self.kerb(door)?;
        let at = self.network.line(lane).at(f64::from(kerb.station - self.class.length / 2.0));
        let ways = self.pavements.to_kerb(door, at).map(|way| [self.add(way.clone()), self.add(way.reversed())]);
        self.to_kerbs.insert(door, ways);
        ways
    }

    fn kerb(&mut self, door: EntranceId) -> Option<(u32, Kerb)> {
        self.kerbs.of(&self.network, &self.pavements, door, self.class)
    }

    /// The way of a car from a door to a door; `None` where none leads.
    fn drive(&mut self, from: EntranceId, to: EntranceId) -> Option<Drive> {
        if let Some(known) = self.drives.get(&(from, to)) {
            return known.clone();
        }
        let drive = self.find_drive(from, to);
        self.drives.insert((from, to), drive.clone());
        drive
    }

    fn find_drive(&mut self, from: EntranceId, to: EntranceId) -> Option<Drive> {
        let [(first, begin), (last, end)] = [self.kerb(from)?, self.kerb(to)?];
        let route = depart::way(&self.network, &self.router, first, begin.station, &end)?;
        let route = Some(route).filter(|route| self.queues.is_open(route))?;
        Some((route.into(), [(first, begin.station), (last, end.station)]))
    }
}
