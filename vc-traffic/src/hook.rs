//! Vehicles and people who are taken out and given back.

use std::sync::Arc;

use crate::Traffic;
use crate::crowd::{RADIUS, Walker};
use crate::drive::PARTS;
use crate::fleet::{Go, Vehicle};
use crate::follow::HARDEST;
use crate::journey::Journey;
use crate::network::NONE;
use crate::swept::is_long;
use crate::trip::{PersonId, Trip, VehicleId, Walk};

/// A vehicle is given back with such a gap before and behind it, metres.
const GAP: f32 = 0.3;
/// Its body is so far from all others, metres, of which none is longer than half of this.
const BESIDE: f64 = 0.4;
const FAR: f64 = 80.0;

/// A vehicle that was taken out, as it was. On a lane its station and its speed can be changed.
#[derive(Debug, Clone)]
pub struct TakenVehicle {
    id: VehicleId,
    /// Its speed, metres per second.
    pub speed: f32,
    /// The station of its front on its lane or movement, metres.
    pub station: f32,
    vehicle: Vehicle,
    route: Vec<u32>,
    /// The movements that its rear covers, each with the way after which it does not; the links on which its rear may be, each with its way when it
    /// left them; and the lanes from which it went as the last.
    covers: Vec<(u32, f32)>,
    left: Vec<(u32, f32)>,
    last: Vec<u32>,
    wants: Option<u32>,
    step: u64,
    of: Arc<Vec<Trip>>,
}

impl TakenVehicle {
    /// Its number.
    pub fn id(&self) -> VehicleId {
        self.id
    }
}

/// Somebody on foot who was taken out, as they were. Their place and velocity can be changed.
#[derive(Debug, Clone)]
pub struct TakenPerson {
    /// The person.
    pub walker: Walker,
    journey: Journey,
    at: [f32; 2],
    of: Arc<Vec<Walk>>,
}

impl Traffic {
    /// Takes a vehicle out, with its trip; `None` if it is not on the road. Costs a look at each link.
    pub fn take_vehicle(&mut self, id: VehicleId) -> Option<TakenVehicle> {
        let slot = *self.slots.get(&id)?;
        let network = self.network.clone();
        let (i, trip) = (slot as usize, id.0);
        let vehicle = self.fleet.vehicle(slot);
        let covers = self.roads.covers.iter().filter(|of| of.0 == slot).map(|of| (of.1, of.2)).collect();
        let links = 0..network.length.len() as u32;
        let here = |link: &u32| {
            let (who, of, _) = self.roads.left[*link as usize];
            who == slot && of == trip
        };
        let left: Vec<(u32, f32)> = links.filter(here).map(|link| (link, self.roads.left[link as usize].2)).collect();
        let last: Vec<u32> = (0..network.lanes as u32).filter(|lane| self.roads.last[*lane as usize] == slot).collect();
        let wants = self.wanting.iter().find(|(who, _)| *who == slot).map(|(_, lane)| *lane);
        self.wanting.retain(|(who, _)| *who != slot);
        left.iter().for_each(|(link, _)| self.roads.left[*link as usize] = (0, NONE, 0.0));
        last.iter().for_each(|lane| self.roads.last[*lane as usize] = NONE);
        self.unpromise(slot);
        let route = std::mem::take(&mut self.routes[i]);
        self.off_the_road(slot);
        self.slots.remove(&id);
        let (speed, station) = (vehicle.v, vehicle.s);
        Some(TakenVehicle {
            id,
            speed,
            station,
            vehicle,
            route,
            covers,
            left,
            last,
            wants,
            step: self.step,
            of: self.trips.clone(),
        })
    }

    /// Gives back the movement and the room that a vehicle may take or is on.
    fn unpromise(&mut self, slot: u32) {
        let network = self.network.clone();
        let i = slot as usize;
        let next = self.fleet.next[i];
        match self.fleet.go[i] {
            Go::No if !network.is_lane(self.fleet.link[i]) => {
                return self.roads.give(&network, next, self.is_long(slot));
            }
            Go::No => return,
            Go::Inside => self.roads.wait(&network, network.movement(next), false),
            Go::Over => self.roads.give(&network, next, self.is_long(slot)),
        }
        self.roads.promised[network.to[network.movement(next)] as usize] -= self.room(slot);
    }

    /// Gives a vehicle back where it was, or at another station of its lane. At once, and as it was, it goes on as if nothing had been.
    ///
    /// # Errors
    /// The vehicle: somebody is there, or too near to stop for it or to be stopped for; others have been let into the junction that it is in;
    /// its station is none of its lane; it is on the road, or of other traffic. Try again after a step.
    pub fn give_vehicle(&mut self, taken: TakenVehicle) -> Result<(), Box<TakenVehicle>> {
        if !self.fits(&taken) {
            return Err(Box::new(taken));
        }
        let network = self.network.clone();
        let TakenVehicle {
            id, speed, station, mut vehicle, route, mut covers, mut left, mut last, wants, step, ..
        } = taken;
        let (later, moved) = (step != self.step, station != vehicle.s);
        let on_lane = network.is_lane(vehicle.link);
        if moved {
            // Somewhere else on its lane.
            (vehicle.behind, covers) = (NONE, Vec::new());
            (left, last) = (Vec::new(), Vec::new());
            vehicle.way += station - vehicle.s;
        }
        (vehicle.s, vehicle.v) = (station, speed);
        if on_lane && vehicle.go != Go::No && !self.may_go(&vehicle) {
            vehicle.go = Go::No;
        }
        let slot = self.fleet.put(&vehicle);
        let i = slot as usize;
        if self.routes.len() <= i {
            self.routes.resize(i + 1, Vec::new());
        }
        self.routes[i] = route;
        self.slots.insert(id, slot);
        self.roads.enter(&mut self.fleet, vehicle.link, slot);
        if vehicle.beside != NONE {
            self.roads.leaving[vehicle.beside as usize].push(slot);
        }
        for (movement, until) in covers {
            self.roads.take(&network, movement, self.is_long(slot));
            self.roads.covers.push((slot, movement, until));
        }
        for (link, way) in left {
            let behind = self.roads.rear_beyond(&network, &self.fleet, &self.drivers, link);
            let own = network.length[link as usize] + vehicle.way - way - self.length(slot);
            if behind.is_none_or(|(rear, _)| rear > own) {
                self.roads.left[link as usize] = (slot, id.0, way);
            }
        }
        for lane in last {
            let beyond = |slot: u32| (slot != NONE).then(|| self.beyond_end(slot, lane)).flatten();
            let other = beyond(self.roads.last[lane as usize]);
            if other.is_none() || other > beyond(slot) {
                self.roads.last[lane as usize] = slot;
            }
        }
        self.wanting.extend(wants.map(|lane| (slot, lane)));
        self.promise(slot);
        // In junctions bodies may be near that are on no way that meets its own.
        if (later || moved) && self.is_beside_another(slot) {
            return self.take_vehicle(id).map_or(Ok(()), |taken| Err(Box::new(TakenVehicle { step, ..taken })));
        }
        Ok(())
    }

    /// Whether a vehicle can be given back.
    fn fits(&self, taken: &TakenVehicle) -> bool {
        let network = &self.network;
        let (vehicle, length) = (&taken.vehicle, self.drivers[taken.vehicle.class as usize].length);
        let moved = taken.station != vehicle.s;
        let on_lane = network.is_lane(vehicle.link);
        if !Arc::ptr_eq(&taken.of, &self.trips) {
            return false;
        }
        if self.slots.contains_key(&taken.id) || !(taken.speed >= 0.0 && taken.speed.is_finite()) {
            return false;
        }
        if moved {
            let within = length..=network.stop.get(vehicle.link as usize).copied().unwrap_or(0.0);
            if !on_lane || vehicle.beside != NONE || vehicle.go != Go::No || !within.contains(&taken.station) {
                return false;
            }
        }
        let beside = (vehicle.beside != NONE).then_some(vehicle.beside);
        let mut links = [vehicle.link].into_iter().chain(beside);
        let apart = links.all(|link| {
            self.is_apart(link, network.on_or_across(taken.station, vehicle.link, link), taken.speed, length)
        });
        // Nobody is where its rear is.
        let behind = moved
            || taken.left.iter().all(|(link, way)| {
                let rear = network.length[*link as usize] + vehicle.way - way - length;
                let mut on = self.on(*link);
                rear >= network.length[*link as usize]
                    || on.all(|other| self.stops_within(other, rear - self.station_on(other, *link), 0.0))
            });
        let row = |link: u32| {
            (network.junction[network.movement(link)] as usize, network.row[network.movement(link)] as usize)
        };
        let is_clear = |link: u32| {
            let (junction, row) = row(link);
            self.is_clear(junction, row, link, is_long(length))
        };
        let inside = on_lane
            || match vehicle.go {
                Go::Inside => self.can_wait_on(vehicle.link),
                _ => is_clear(vehicle.link),
            };
        let covers = moved || taken.covers.iter().all(|(link, _)| is_clear(*link));
        let line = network.stop.get(vehicle.link as usize).map_or(0.0, |stop| stop - taken.station);
        let stops = !on_lane
            || vehicle.go == Go::No
            || self.may_go(vehicle)
            || line > taken.speed * taken.speed / (2.0 * HARDEST);
        let open = self.is_unblocked(
            vehicle.link,
            taken.station - length,
            taken.station + taken.speed * taken.speed / (2.0 * HARDEST),
        );
        let ways = self.is_apart_from_who_turn_off(vehicle.link, taken.station, length);
        apart && ways && behind && inside && covers && stops && open
    }

    /// Whether the body of a vehicle is less than some way from another.
    fn is_beside_another(&self, slot: u32) -> bool {
        let own = self.pose(slot);
        let mut others = self.slots.values().filter(|other| **other != slot).map(|other| self.pose(*other));
        others.any(|other| (other.at - own.at).norm() < FAR && own.overlap(&other) > -BESIDE)
    }

    /// Whether a vehicle of a length, so far along a lane or a movement from one, is apart from those who go other ways from that lane.
    fn is_apart_from_who_turn_off(&self, link: u32, station: f32, length: f32) -> bool {
        let network = &self.network;
        let (lane, own) = if network.is_lane(link) {
            (link, station - network.length[link as usize])
        } else {
            (network.from[network.movement(link)], station)
        };
        let others = network.next[lane as usize].iter().filter(|other| **other != link);
        others.flat_map(|other| self.on(*other)).all(|slot| {
            let front = self.fleet.s[slot as usize];
            let rear = front - self.length(slot);
            rear > PARTS || own - length > PARTS || rear > own + GAP || front < own - length - GAP
        })
    }

    /// Whether a vehicle on its lane may go over the junction as it could when it was taken out.
    fn may_go(&self, vehicle: &Vehicle) -> bool {
        let network = &self.network;
        let movement = network.movement(vehicle.next);
        let [junction, row] = [network.junction[movement], network.row[movement]].map(|number| number as usize);
        match vehicle.go {
            Go::Inside => self.can_wait_on(vehicle.next),
            _ => self.is_clear(junction, row, vehicle.next, is_long(self.drivers[vehicle.class as usize].length)),
        }
    }

    /// Whether a vehicle of a length with its front at a station of a link is apart from all others there, and nobody has to brake too hard.
    fn is_apart(&self, link: u32, station: f32, speed: f32, length: f32) -> bool {
        let ahead = |slot: u32| {
            let gap = self.station_on(slot, link) - self.length(slot) - station;
            let theirs = self.fleet.v[slot as usize];
            gap > GAP && (speed * speed - theirs * theirs) / (2.0 * HARDEST) < gap
        };
        let gone = self.roads.rear_beyond(&self.network, &self.fleet, &self.drivers, link);
        let clear = gone.is_none_or(|(rear, theirs)| {
            rear - station > GAP && (speed * speed - theirs * theirs) / (2.0 * HARDEST) < rear - station
        });
        clear
            && self.on(link).all(|slot| {
                let behind = station - length - self.station_on(slot, link);
                if self.station_on(slot, link) >= station {
                    ahead(slot)
                } else {
                    self.stops_within(slot, behind, speed)
                }
            })
    }

    /// Whether a vehicle can keep behind one of a speed that is so far ahead, metres.
    fn stops_within(&self, slot: u32, gap: f32, speed: f32) -> bool {
        let v = self.fleet.v[slot as usize];
        gap > GAP && (v * v - speed * speed) / (2.0 * HARDEST) < gap
    }

    /// Takes somebody on foot out, with their walk; `None` if they are not on their way.
    pub fn take_person(&mut self, id: PersonId) -> Option<TakenPerson> {
        let walker = self.foot.crowd.remove(id)?;
        let journey = self.foot.journeys.remove(&id)?;
        self.count_on(&journey, false);
        Some(TakenPerson { at: walker.at, walker, journey, of: self.foot.walks.clone() })
    }

    /// Gives somebody back where they were, or at another place of their way where no vehicles go. At once, and as they were, they go on as if
    /// nothing had been.
    ///
    /// # Errors
    /// The person: somebody is there; vehicles have come where they cross; the place is not on their way, or where vehicles go; they are on
    /// their way, or of other traffic. Try again after a step.
    pub fn give_person(&mut self, taken: TakenPerson) -> Result<(), Box<TakenPerson>> {
        let TakenPerson { mut walker, mut journey, at, of } = taken.clone();
        let known = Arc::ptr_eq(&of, &self.foot.walks);
        let placed = walker.at == at || self.place(&mut walker, &mut journey);
        let open = !journey.on || self.is_still_open(&journey);
        if !(known && placed && open && self.foot.crowd.add(walker.clone())) {
            return Err(Box::new(taken));
        }
        self.count_on(&journey, true);
        self.foot.journeys.insert(walker.id, journey);
        Ok(())
    }

    /// Finds the piece of a way on which somebody is, and the next passage; false if they are beside the way or on a passage.
    fn place(&self, walker: &mut Walker, journey: &mut Journey) -> bool {
        if !walker.is_put_on_way() {
            return false;
        }
        let station = walker.station();
        let next = journey.passages.iter().position(|passage| station < passage.over.to + RADIUS);
        journey.next = next.unwrap_or(journey.passages.len());
        (journey.on, journey.waits) = (false, 0.0);
        let passage = journey.passages.get(journey.next);
        walker.stop = passage.map_or(f32::INFINITY, |passage| passage.over.from);
        walker.back = f32::NEG_INFINITY;
        station + RADIUS <= walker.stop
    }

    /// Whether somebody who crosses can go on doing so.
    fn is_still_open(&self, journey: &Journey) -> bool {
        let passage = &journey.passages[journey.next];
        let free = |c: &u32| {
            let walk = self.network.crosswalks[*c as usize];
            self.foot.on(*c) > 0 || self.is_clear(walk.junction as usize, walk.row as usize, NONE, false)
        };
        let stop = |span: &crate::ground::Span| {
            self.on(span.link).all(|slot| {
                let away = span.from - self.station_on(slot, span.link);
                away < 0.0 || self.stops_within(slot, away + GAP, 0.0)
            })
        };
        let spans = &passage.over.spans;
        passage.crossings.iter().all(free) && self.is_empty_on(spans) && spans.iter().all(stop)
    }

    /// Counts somebody among those who cross, or no more.
    fn count_on(&mut self, journey: &Journey, more: bool) {
        let Some(passage) = journey.passages.get(journey.next).filter(|_| journey.on) else { return };
        for c in &passage.crossings {
            let walk = self.network.crosswalks[*c as usize];
            let on = self.foot.count(*c, more);
            self.roads.cross(walk.junction as usize, walk.row, on > 0);
        }
    }
}
