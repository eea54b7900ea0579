//! Departures: a route for each trip, and room on the road for its vehicle.

use vc_map::Point;
use vc_map::route::{Leg, Router};

use crate::Traffic;
use crate::network::{NONE, Network};
use crate::trip::{Kerb, TrafficEvent, VehicleId};

/// A vehicle that waits for room tries once in so many seconds.
const TRIES: f32 = 1.0;
/// The gap that it needs behind and before it, metres; and behind also the way that the next one needs to stop.
const GAP: f32 = 3.0;
/// Nobody sets out nearer to the start of a lane to which somebody may come over a junction, metres.
const START: f32 = 25.0;

impl Traffic {
    pub(crate) fn depart(&mut self) {
        let now = (self.step + 1) as f32 * self.dt;
        while let Some(trip) = self.order.get(self.coming).copied().filter(|t| self.trips[*t as usize].departs <= now) {
            self.coming += 1;
            let side = self.trips[trip as usize].from.side();
            self.pending.entry(side).or_default().push_back(trip);
        }
        let every = (TRIES / self.dt).round().max(1.0) as u64;
        let sides: Vec<u32> =
            self.pending.keys().copied().filter(|s| (self.step + u64::from(*s)).is_multiple_of(every)).collect();
        for side in sides {
            while let Some(trip) = self.pending.get(&side).and_then(|queue| queue.front().copied()) {
                if !self.set_out(trip, side) {
                    break;
                }
                if let Some(queue) = self.pending.get_mut(&side) {
                    queue.pop_front();
                }
            }
            if self.pending.get(&side).is_some_and(std::collections::VecDeque::is_empty) {
                self.pending.remove(&side);
            }
        }
    }

    /// Puts the vehicle of a trip on the road, or tells that no way leads there. False if there is no room yet.
    fn set_out(&mut self, number: u32, side: u32) -> bool {
        let network = self.network.clone();
        let trip = self.trips[number as usize];
        let class = &self.classes[trip.class as usize];
        let vehicle = VehicleId(number);
        let open: Vec<u32> = network.sides[side as usize]
            .iter()
            .copied()
            .filter(|lane| network.users[*lane as usize].has(class.users))
            .collect();
        // Nobody begins on a crossing.
        let rear = |lane: u32| network.begin[lane as usize];
        let last = |lane: u32| (network.length[lane as usize] - GAP).min(network.stop[lane as usize]);
        let place = |lane: u32| trip.from.station.max(rear(lane) + class.length + 0.2).min(last(lane));
        let fits = |lane: &u32| place(*lane) >= class.length + rear(*lane);
        let Some(first) = open.iter().copied().find(fits) else {
            self.events.push(TrafficEvent::NoWay { vehicle });
            return true;
        };
        let Some(route) = self.way(first, place(first), &trip.to) else {
            self.events.push(TrafficEvent::NoWay { vehicle });
            return true;
        };
        let leads = |lane: &u32| route.len() == 1 || self.choose(*lane, &route, 0, class.users) != NONE;
        let good: Vec<u32> = open.iter().copied().filter(fits).filter(leads).collect();
        let lanes = if good.is_empty() { open.into_iter().filter(fits).collect() } else { good };
        let Some(lane) = lanes.into_iter().find(|lane| self.is_free(*lane, place(*lane), class.length)) else {
            return false;
        };
        let share =
            class.share + class.deviation * self.seed.nth(u64::from(number)).stream().normal(0.0, 1.0).clamp(-2.0, 2.0);
        let users = class.users;
        let slot = self.fleet.add(number, trip.class, share);
        let i = slot as usize;
        if self.routes.len() <= i {
            self.routes.resize(i + 1, Vec::new());
        }
        self.fleet.s[i] = place(lane);
        self.fleet.since[i] = self.step as f32 * self.dt;
        self.fleet.next[i] = self.choose(lane, &route, 0, users);
        self.routes[i] = route;
        self.roads.enter(&mut self.fleet, lane, slot);
        self.slots.insert(vehicle, slot);
        self.events.push(TrafficEvent::Departed { vehicle });
        true
    }

    /// Whether a vehicle of some length can begin with its front at a station of a lane.
    fn is_free(&self, lane: u32, station: f32, length: f32) -> bool {
        let (network, fleet) = (&self.network, &self.fleet);
        let rear = station - length;
        let comes = self.roads.promised[lane as usize] > 0
            || network.before[lane as usize].iter().any(|link| {
                let movement = network.movement(*link);
                self.roads.taken[movement] > 0
                    || (network.free[movement] && !self.roads.queue[network.from[movement] as usize].is_empty())
            });
        if (comes && rear < START) || !self.is_unblocked(lane, rear - GAP, station + GAP) {
            return false;
        }
        let clear = |slot: &u32| {
            let i = *slot as usize;
            let at = network.across(fleet.s[i], fleet.link[i], lane);
            let driver = &self.drivers[fleet.class[i] as usize];
            let v = fleet.v[i];
            at - driver.length > station + GAP || at + GAP + v * driver.time_gap + driver.stopping(v) < rear
        };
        // Whoever went over the junction may still be in the lane.
        let last = self.roads.last[lane as usize];
        let gone = last == NONE || fleet.trip[last as usize] == NONE || {
            let i = last as usize;
            let front =
                if network.is_lane(fleet.link[i]) { f32::INFINITY } else { network.length[lane as usize] + fleet.s[i] };
            front - self.drivers[fleet.class[i] as usize].length > station + GAP
        };
        gone && self.roads.queue[lane as usize].iter().all(clear) && self.roads.leaving[lane as usize].iter().all(clear)
    }

    /// The sides of roads by which one comes from a place on a lane to another place.
    pub(crate) fn way(&self, lane: u32, station: f32, to: &Kerb) -> Option<Vec<u32>> {
        way(&self.network, &self.router, lane, station, to)
    }
}

/// The sides of roads by which one comes from a place on a lane to another place.
pub(crate) fn way(network: &Network, router: &Router, lane: u32, station: f32, to: &Kerb) -> Option<Vec<u32>> {
    let end = to.side() as usize;
    let last = *network.sides.get(end)?.first()?;
    let at = |lane: u32, station: f32| -> Point {
        let line = network.line(lane);
        line.at(f64::from(station).clamp(0.1, line.length() - 0.1))
    };
    let route = router.route(&at(lane, station), &at(last, to.station))?;
    let sides: Vec<u32> = route
        .legs
        .iter()
        .filter_map(|leg| match leg {
            Leg::Road(road, forward) => Some(road.0 * 2 + u32::from(!forward)),
            _ => None,
        })
        .collect();
    (sides.first() == Some(&network.side[lane as usize]) && sides.last() == Some(&(end as u32))).then_some(sides)
}
