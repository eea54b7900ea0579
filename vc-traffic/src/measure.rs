//! Measures of the field: flow, density, speed, delay and queues of streets, travel times, and near misses.

use std::collections::BTreeMap;
use std::sync::Arc;

use vc_map::{JunctionId, MovementId, RoadId};

use crate::Traffic;
use crate::network::{NONE, Network, meets};
use crate::right_of_way::STANDING;
use crate::trip::{TrafficEvent, VehicleId};

/// Near misses are told below such times to collision and after an encroachment, seconds: three times those that count as serious.
const COLLISION: f32 = 3.0;
const ENCROACHMENT: f32 = 5.0;
/// Those behind one who stands are in the same queue if they stand no further behind, metres.
const NEXT: f32 = 15.0;

/// The measures of one side of a road over some time, by Edie's definitions (1963): sums over all that vehicles went and took there.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
#[non_exhaustive]
pub struct StreetMeasures {
    /// Vehicles an hour.
    pub flow: f64,
    /// Vehicles a kilometre, on all lanes together.
    pub density: f64,
    /// The mean over space of their speeds, metres per second; 0 if there were none.
    pub speed: f64,
    /// The time that they lost against the limit, seconds a vehicle: what each took longer for this length on average.
    pub delay: f64,
    /// The longest queue at its end, metres.
    pub longest_queue: f32,
    /// The mean queue at its end, metres.
    pub mean_queue: f64,
}

/// The kind of a near miss.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Nearness {
    /// The time to collision: after it the one behind would have hit the one ahead, had both kept their speeds; the least while it was below three
    /// seconds, of two in one lane or on one way over a junction.
    Collision,
    /// The post-encroachment time: from when one had left the place where their ways over a junction meet to when the other came there, if that was less
    /// than five seconds.
    Encroachment,
}

/// Two vehicles that came near each other.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct NearMiss {
    /// The kind of its measure.
    pub kind: Nearness,
    /// That measure, seconds.
    pub seconds: f32,
    /// When it was, seconds since the start.
    pub at: f64,
    /// The one ahead, or the one who went first, and the other.
    pub vehicles: [VehicleId; 2],
    /// The junction, if it was on one.
    pub junction: Option<JunctionId>,
}

#[derive(Clone, Copy, Default)]
struct Sums {
    metres: f64,
    seconds: f64,
    delay: f64,
    queue: f64,
    longest: f32,
}

/// Where the way of a movement meets another's, and leaves it, metres.
#[derive(Clone, Copy)]
struct Meeting {
    other: u32,
    begin: f32,
    end: f32,
}

/// A vehicle as it was in the last step: its trip, the movement that it is on or has just left, and how far it is beyond its begin.
#[derive(Clone, Copy)]
struct Seen {
    trip: u32,
    movement: u32,
    beyond: f32,
}

/// Measures of traffic while it goes on. [`Self::add`] takes each step.
///
/// ```
/// # use vc_graph::Seed;
/// # use vc_map::{Control, CrossSection, MapDraft, RoadClass, RoadId, Strip};
/// use vc_traffic::{Kerb, Measures, Traffic, TrafficOptions, Trip};
/// # let mut draft = MapDraft::new("street", 48.1, 11.6);
/// # let ends = [[0.0, 0.0], [200.0, 0.0], [400.0, 0.0]].map(|at| draft.junction(at, Control::Priority));
/// # let side = vec![Strip::driving(3.0, 13.9)];
/// # for pair in ends.windows(2) {
/// #     let section = CrossSection { forward: side.clone(), backward: side.clone(), median: 0.0 };
/// #     draft.road(pair[0], pair[1], RoadClass::Residential, section);
/// # }
/// # let map = draft.build()?; // a street of two roads along X
/// # let kerb = |road, station| Kerb { road: RoadId(road), forward: true, station };
/// let trip = |departs| Trip { class: 0, departs, from: kerb(0, 20.0), to: kerb(1, 150.0) };
/// let trips = vec![trip(0.0), trip(10.0), trip(20.0)];
/// let mut traffic = Traffic::new(&map, trips, &TrafficOptions::default(), Seed(7))?;
/// let mut measures = Measures::new(&traffic);
/// for _ in 0..1200 {
///     traffic.step();
///     measures.add(&traffic);
/// }
/// let street = measures.street(RoadId(1), true).ok_or("a street")?;
/// assert!(street.speed > 8.0 && street.longest_queue == 0.0);
/// assert!((street.flow - 3.6 * street.density * street.speed).abs() < 1e-6);
/// assert_eq!(measures.travel_times().len(), 3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Measures {
    network: Arc<Network>,
    steps: u64,
    seconds: f64,
    sides: Vec<Sums>,
    /// For each movement: the number of vehicles, its meetings, and for each of these who has left it last, and when.
    went: Vec<u32>,
    meetings: Vec<Vec<Meeting>>,
    left: Vec<Vec<(u32, f64)>>,
    seen: Vec<Seen>,
    /// Those who are near the one ahead, by both.
    near: BTreeMap<[u32; 2], NearMiss>,
    misses: Vec<NearMiss>,
    times: Vec<f32>,
}

impl Measures {
    /// Measures of traffic from now on. Costs a look at each pair of ways that meet.
    pub fn new(traffic: &Traffic) -> Self {
        let network = traffic.network.clone();
        let movements = network.from.len();
        let meetings: Vec<_> = (0..movements).map(|movement| meetings_of(&network, movement)).collect();
        let left = meetings.iter().map(|of| vec![(NONE, 0.0); of.len()]).collect();
        let sides = vec![Sums::default(); network.sides.len()];
        Self {
            network,
            steps: 0,
            seconds: 0.0,
            sides,
            went: vec![0; movements],
            meetings,
            left,
            seen: Vec::new(),
            near: BTreeMap::new(),
            misses: Vec::new(),
            times: Vec::new(),
        }
    }

    /// Takes the last step of the traffic that it was made with. Costs a look at each link and each vehicle, and at the ways that meet its own.
    pub fn add(&mut self, traffic: &Traffic) {
        self.steps += 1;
        self.seconds += f64::from(traffic.dt);
        let arrived = traffic.events().iter().filter_map(|event| match event {
            TrafficEvent::Arrived { seconds, .. } => Some(*seconds),
            _ => None,
        });
        self.times.extend(arrived);
        self.streets(traffic);
        self.queues(traffic);
        self.behind(traffic);
        self.crossing(traffic);
    }

    /// A side of a road, over all steps; `None` for roads that there are not.
    pub fn street(&self, road: RoadId, forward: bool) -> Option<StreetMeasures> {
        let side = road.index() * 2 + usize::from(!forward);
        let sums = self.sides.get(side)?;
        let lanes = &self.network.sides[side];
        let length = lanes.iter().map(|lane| f64::from(self.network.length[*lane as usize])).fold(0.0, f64::max);
        let [space, steps] =
            [length * self.seconds, self.steps as f64].map(|sum| if sum > 0.0 { sum } else { f64::INFINITY });
        let vehicles = sums.metres / length.max(1e-9);
        let share = |of: f64, all: f64| if all > 0.0 { of / all } else { 0.0 };
        Some(StreetMeasures {
            flow: 3600.0 * sums.metres / space,
            density: 1000.0 * sums.seconds / space,
            speed: share(sums.metres, sums.seconds),
            delay: share(sums.delay, vehicles),
            longest_queue: sums.longest,
            mean_queue: sums.queue / steps,
        })
    }

    /// The number of vehicles that have begun a movement.
    pub fn went(&self, movement: MovementId) -> u32 {
        self.went.get(movement.index()).copied().unwrap_or(0)
    }

    /// The times of those who have arrived, seconds, from the least.
    pub fn travel_times(&self) -> Vec<f32> {
        let mut times = self.times.clone();
        times.sort_by(f32::total_cmp);
        times
    }

    /// Those who came near each other, in the order in which that ended.
    pub fn near_misses(&self) -> &[NearMiss] {
        &self.misses
    }

    fn streets(&mut self, traffic: &Traffic) {
        let (network, fleet, dt) = (&self.network, &traffic.fleet, f64::from(traffic.dt));
        for slot in traffic.slots.values() {
            let i = *slot as usize;
            let link = fleet.link[i];
            if !network.is_lane(link) {
                continue;
            }
            let sums = &mut self.sides[network.side[link as usize] as usize];
            let metres = f64::from(fleet.v[i]) * dt;
            sums.metres += metres;
            sums.seconds += dt;
            sums.delay += (dt - metres / f64::from(network.limit[link as usize])).max(0.0);
        }
    }

    fn queues(&mut self, traffic: &Traffic) {
        let (network, fleet) = (&self.network, &traffic.fleet);
        for (sums, lanes) in self.sides.iter_mut().zip(&network.sides) {
            let queue = |lane: &u32| {
                let line = network.stop[*lane as usize];
                let mut rear = line;
                for slot in &traffic.roads.queue[*lane as usize] {
                    let i = *slot as usize;
                    if fleet.s[i] > line {
                        continue;
                    }
                    if fleet.v[i] >= STANDING || rear - fleet.s[i] > NEXT {
                        break;
                    }
                    rear = fleet.s[i] - traffic.length(*slot);
                }
                line - rear
            };
            let longest = lanes.iter().map(queue).fold(0.0, f32::max);
            sums.longest = sums.longest.max(longest);
            sums.queue += f64::from(longest);
        }
    }

    /// The times to collision of those behind each other.
    fn behind(&mut self, traffic: &Traffic) {
        let (network, fleet) = (&self.network, &traffic.fleet);
        let mut near = BTreeMap::new();
        for (link, queue) in traffic.roads.queue.iter().enumerate().filter(|(_, queue)| queue.len() > 1) {
            for (ahead, own) in queue.iter().zip(queue.iter().skip(1)) {
                let [a, b] = [*ahead, *own].map(|slot| slot as usize);
                let slower = fleet.v[b] - fleet.v[a];
                let seconds = (fleet.s[a] - traffic.length(*ahead) - fleet.s[b]).max(0.0) / slower.max(1e-6);
                if slower <= 0.0 || seconds >= COLLISION {
                    continue;
                }
                let trips = [fleet.trip[a], fleet.trip[b]];
                let junction = (!network.is_lane(link as u32)).then(|| network.junction[network.movement(link as u32)]);
                let now = NearMiss {
                    kind: Nearness::Collision,
                    seconds,
                    at: traffic.seconds(),
                    vehicles: trips.map(VehicleId),
                    junction: junction.map(JunctionId),
                };
                let before = self.near.remove(&trips).filter(|before| before.seconds <= seconds);
                near.insert(trips, before.unwrap_or(now));
            }
        }
        self.misses.extend(std::mem::replace(&mut self.near, near).into_values());
    }

    /// The post-encroachment times of those whose ways meet.
    fn crossing(&mut self, traffic: &Traffic) {
        let network = self.network.clone();
        let fleet = &traffic.fleet;
        let none = Seen { trip: NONE, movement: NONE, beyond: 0.0 };
        self.seen.resize(fleet.s.len(), none);
        for slot in traffic.slots.values() {
            let i = *slot as usize;
            let link = if network.is_lane(fleet.link[i]) { fleet.behind[i] } else { fleet.link[i] };
            let before = std::mem::replace(&mut self.seen[i], Seen { trip: fleet.trip[i], ..none });
            if link == NONE || network.is_lane(link) {
                continue;
            }
            let movement = network.movement(link);
            let Some(beyond) = traffic.beyond_end(*slot, network.from[movement]) else { continue };
            let same = before.trip == fleet.trip[i] && before.movement == movement as u32;
            self.went[movement] += u32::from(!same);
            let was = if same { before.beyond } else { 0.0 };
            self.seen[i] = Seen { trip: fleet.trip[i], movement: movement as u32, beyond };
            let length = traffic.length(*slot);
            for number in 0..self.meetings[movement].len() {
                let Meeting { other, begin, end } = self.meetings[movement][number];
                if was < begin && beyond >= begin {
                    self.comes(traffic, movement, other as usize, fleet.trip[i]);
                }
                if was - length < end && beyond - length >= end {
                    self.left[movement][number] = (fleet.trip[i], traffic.seconds());
                }
            }
        }
    }

    /// Somebody comes to where their way meets another's.
    fn comes(&mut self, traffic: &Traffic, movement: usize, other: usize, trip: u32) {
        let Some(number) = self.meetings[other].iter().position(|of| of.other as usize == movement) else { return };
        let (first, when) = self.left[other][number];
        let seconds = (traffic.seconds() - when) as f32;
        if first != NONE && first != trip && seconds < ENCROACHMENT {
            self.misses.push(NearMiss {
                kind: Nearness::Encroachment,
                seconds,
                at: traffic.seconds(),
                vehicles: [first, trip].map(VehicleId),
                junction: Some(JunctionId(self.network.junction[movement])),
            });
        }
    }
}

/// Where a movement meets others that come from other lanes.
fn meetings_of(network: &Network, movement: usize) -> Vec<Meeting> {
    let junction = network.junction[movement] as usize;
    let table = &network.map.junctions()[junction].conflicts;
    let line = |movement: usize| &network.map.movements()[movement].line;
    let own = line(movement);
    let rows = network.rows[junction].iter().enumerate();
    let met = rows.filter(|(row, _)| table.has(network.row[movement] as usize, *row));
    let meeting = |(_, link): (usize, &u32)| {
        let other = network.movement(*link);
        if network.from[other] == network.from[movement] {
            return None;
        }
        let begin = meets(own, line(other))?;
        let end = own.length() - meets(&own.reversed(), line(other))?;
        Some(Meeting { other: other as u32, begin: begin as f32, end: end as f32 })
    };
    met.filter_map(meeting).collect()
}
