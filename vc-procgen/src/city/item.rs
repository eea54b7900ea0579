//! Things along streets: lamps, trees, benches and the like from `data/street_items.txt`, lights, signs and bus stops.

use std::collections::BTreeMap;
use std::sync::LazyLock;

use vc_graph::Seed;
use vc_graph::portable::Portable;
use vc_map::{Control, Lane, LaneId, Point, RoadId, StopKind, StreetMap, StripKind, Users};

use super::convex::left;
use super::near::Near;

/// Things begin this far from the ends of a pavement, lamps nearer, metres.
const CLEAR: f64 = 10.0;
const LAMPS: f64 = 5.0;
/// Between the hulls of two things, and between a tree and a lamp, metres.
const GAP: f64 = 0.4;
const SHADE: f64 = 4.6;
/// Nothing at the rear of a pavement stands nearer to a door, metres.
const DOOR: f64 = 1.6;
/// The radius of a shelter, metres.
const SHELTER: f64 = 0.85;
/// Lamps stand this much closer than they need to, so that each can step aside, metres.
const SPARE: f64 = 2.0;
/// A pavement that is narrower has its lamps at its rear, metres.
const NARROW: f64 = 2.2;
/// The length of a bus stop, metres.
const STOP: f64 = 16.0;
/// Posts stand this far behind the kerb, metres.
const POST: f64 = 0.66;

/// The text of a traffic sign.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum TrafficSign {
    /// Give way.
    GiveWay,
    /// No entry.
    NoEntry,
    /// One way, along the street.
    OneWay,
}

/// A thing that stands outdoors.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct StreetItem {
    /// Its class.
    pub class: &'static str,
    /// The middle of its foot.
    pub at: Point,
    /// The direction that it faces, radians: for most the middle of the street.
    pub heading: f64,
    /// The radius of a circle around its foot, and its height, metres.
    pub radius: f64,
    /// Its height, metres.
    pub height: f64,
    /// The pavement on which it stands.
    pub pavement: Option<LaneId>,
    /// The text on it, if it is a sign.
    pub sign: Option<TrafficSign>,
}

struct Row {
    class: &'static str,
    radius: f64,
    height: f64,
    spacing: f64,
    kerb: f64,
    pavement: f64,
}

static TABLE: LazyLock<Vec<Row>> = LazyLock::new(|| {
    let lines = include_str!("../../data/street_items.txt").lines().filter(|line| !line.starts_with('#'));
    lines.filter_map(row).collect()
});

fn row(line: &'static str) -> Option<Row> {
    let (class, numbers) = line.split_once('|')?;
    let numbers: Vec<f64> = numbers.split('|').filter_map(|word| word.trim().parse().ok()).collect();
    let [radius, height, spacing, kerb, pavement] = <[f64; 5]>::try_from(numbers).ok()?;
    Some(Row { class: class.trim(), radius, height, spacing, kerb, pavement })
}

/// The distance between lamps, metres.
pub(super) fn lamp_spacing() -> f64 {
    TABLE.iter().find(|row| row.class == "street_lamp").map_or(f64::INFINITY, |row| row.spacing)
}

/// Everything along the streets of a map.
pub(super) fn items(map: &StreetMap, seed: Seed) -> Vec<StreetItem> {
    let doors = Near::of(map.entrances().iter().map(|entrance| &entrance.door));
    let mut row = Rows { map, doors, near: Near::default(), taken: BTreeMap::new(), items: Vec::new() };
    row.signals();
    row.signs();
    row.stops();
    // Lamps stand everywhere before trees take their places.
    for lamps in [true, false] {
        for (index, lane) in map.lanes().iter().enumerate().filter(|(_, lane)| lane.kind == StripKind::Pavement) {
            row.pavement(LaneId(index as u32), lane, lamps, seed.child("pavement").nth(index as u64));
        }
    }
    row.items
}

struct Rows<'a> {
    map: &'a StreetMap,
    /// The doors before which nothing stands, and the things that stand already.
    doors: Near,
    near: Near,
    /// Stretches of pavements that are taken: their middles and half their lengths.
    taken: BTreeMap<LaneId, Vec<[f64; 2]>>,
    items: Vec<StreetItem>,
}

impl Rows<'_> {
    /// Puts a thing onto a pavement, if it is free there.
    fn put(&mut self, id: LaneId, station: f64, from_kerb: f64, mut item: StreetItem) -> bool {
        let Some(lane) = self.map.lane(id) else { return false };
        // Where a street bends, a shelter would hide lights behind it.
        let bend = if item.class == "bus_stop" { 40.0 } else { 6.0 };
        let length = lane.line.length();
        let ends = [(station - bend).max(0.0), (station + bend).min(length)].map(|at| lane.line.direction(at));
        // People wait under lamps, too.
        let taken = item.class != "street_lamp"
            && self.taken.entry(id).or_default().iter().any(|[at, half]| (at - station).abs() < half + item.radius);
        if !(0.0..=length).contains(&station) || ends[0].dot(&ends[1]) < 0.999 || taken {
            return false;
        }
        // Posts of a narrow pavement stand at its rear.
        let (from_kerb, radius) = if lane.width < NARROW { (lane.width - 0.12, 0.1) } else { (from_kerb, item.radius) };
        // The carriageway is to the left of those who walk along, where one drives on the right.
        let aside = left(lane.line.direction(station));
        item.at = lane.line.at(station) + aside * (lane.width / 2.0 - from_kerb);
        item.heading = aside.y.angle_to(aside.x);
        item.radius = radius;
        let free = |other: &StreetItem| {
            let shade =
                (item.class == "tree") != (other.class == "tree") && [item.class, other.class].contains(&"street_lamp");
            (other.at - item.at).norm() > if shade { SHADE } else { item.radius + other.radius + GAP }
        };
        let rear = from_kerb + item.radius > lane.width - 0.3;
        let door = rear && self.doors.around(&item.at, DOOR + item.radius).next().is_some();
        if door || !self.near.around(&item.at, SHADE).all(|other| free(&self.items[other])) {
            return false;
        }
        self.near.add(self.items.len(), item.at);
        item.pavement = Some(id);
        self.items.push(item);
        true
    }

    /// Puts a post onto a pavement at a station or a few steps farther, metres.
    fn put_near(&mut self, id: LaneId, station: f64, step: f64, item: StreetItem) {
        let _ = (0..8).any(|i| self.put(id, station + step * f64::from(i), POST, item));
    }

    /// The pavement beside the end of a lane, and the station there.
    fn beside(&self, lane: &Lane, station: f64) -> Option<(LaneId, f64)> {
        let lanes = &self.map.road(lane.road)?.lanes;
        let pavement = |id: &&LaneId| {
            self.map.lane(**id).is_some_and(|other| other.kind == StripKind::Pavement && other.forward == lane.forward)
        };
        let id = *lanes.iter().find(pavement)?;
        let station = self.map.lane(id)?.line.project(&lane.line.at(station)).station;
        Some((id, station))
    }

    /// The lanes for cars that end at junctions, one for each arm.
    fn approaches(&self) -> Vec<Lane> {
        let inner = |lane: &&Lane| lane.kind == StripKind::Driving && lane.index == 0 && lane.users.has(Users::CAR);
        self.map.lanes().iter().filter(inner).cloned().collect()
    }

    fn control(&self, lane: &Lane) -> Option<Control> {
        let movement = self.map.movement(*lane.next.first()?)?;
        Some(self.map.junction(movement.junction)?.draft.control)
    }

    fn signals(&mut self) {
        for lane in self.approaches() {
            if self.control(&lane) != Some(Control::Signals) {
                continue;
            }
            let station = lane.stop_line.unwrap_or(lane.line.length());
            if let Some((id, at)) = self.beside(&lane, station) {
                self.put_near(id, at, -0.7, plain("traffic_light", 0.2, 3.4));
            }
        }
    }

    fn signs(&mut self) {
        for lane in self.approaches() {
            let end = lane.line.length();
            if yields(self.map, &lane).next().is_some()
                && let Some((id, at)) = self.beside(&lane, end)
            {
                self.put_near(id, at - 1.0, -1.0, sign(TrafficSign::GiveWay));
            }
            if self.map.road(lane.road).is_some_and(|road| one_way(self.map, road)) {
                self.one_way(&lane);
            }
        }
    }

    /// A blue arrow where a one-way street begins, and a red disc where it ends.
    fn one_way(&mut self, lane: &Lane) {
        let Some((id, start)) = self.beside(lane, 0.0) else { return };
        self.put_near(id, start + 1.5, 1.0, sign(TrafficSign::OneWay));
        let Some((id, end)) = self.beside(lane, lane.line.length()) else { return };
        self.put_near(id, end - 2.0, -1.0, sign(TrafficSign::NoEntry));
    }

    fn stops(&mut self) {
        for stop in self.map.stops().iter().filter(|stop| stop.kind == StopKind::Bus) {
            let Some(lane) = stop.lane.and_then(|(id, _)| self.map.lane(id)) else { continue };
            let at = lane.line.project(&stop.at).station;
            if let Some((id, station)) = self.beside(lane, at) {
                // Shelters stand at the rear, so that people pass before them, and away from doors.
                let width = self.map.lane(id).map_or(0.0, |lane| lane.width);
                let shelter = plain("bus_stop", SHELTER, 2.5);
                let _ = (0..12).any(|step| {
                    let station = station + f64::from((step + 1) / 2) * if step % 2 == 0 { 1.5 } else { -1.5 };
                    self.put(id, station, width - SHELTER - 0.05, shelter)
                });
                self.taken.entry(id).or_default().push([station, STOP / 2.0]);
            }
        }
    }

    /// Rows of things along a pavement, as far as it is wide enough for them.
    fn pavement(&mut self, id: LaneId, lane: &Lane, lamps: bool, seed: Seed) {
        let mut stream = seed.stream();
        let length = lane.line.length();
        for row in TABLE.iter() {
            let lamp = row.class == "street_lamp";
            if lamp != lamps || (!lamp && lane.width < row.pavement) {
                continue;
            }
            let clear = if lamp { LAMPS.min(length / 3.0) } else { CLEAR };
            let room = length - 2.0 * clear;
            let count = if lamp {
                (room / (row.spacing - SPARE)).ceil().max(0.0) + 1.0
            } else {
                (room / row.spacing + f64::from(stream.unit())).floor()
            };
            for i in 0..count.max(0.0) as usize {
                let share = if lamp && count > 1.0 { i as f64 / (count - 1.0) } else { (i as f64 + 0.5) / count };
                let item = plain(row.class, row.radius, row.height);
                // A little to one side or the other where something stands.
                let steps = (0..if lamp { 14 } else { 7 })
                    .map(|step| f64::from((step + 1) / 2) * if step % 2 == 0 { 1.1 } else { -1.1 });
                let _ = steps.into_iter().any(|step| {
                    let station = clear + room * share + step;
                    (1.0..length - 1.0).contains(&station) && self.put(id, station, row.kerb, item)
                });
            }
        }
    }
}

fn plain(class: &'static str, radius: f64, height: f64) -> StreetItem {
    StreetItem { class, at: Point::origin(), heading: 0.0, radius, height, pavement: None, sign: None }
}

fn sign(sign: TrafficSign) -> StreetItem {
    StreetItem { sign: Some(sign), ..plain("traffic_sign", 0.1, 2.6) }
}

/// Whether cars drive on a road in one direction only.
pub(super) fn one_way(map: &StreetMap, road: &vc_map::Road) -> bool {
    let cars = |forward: bool| {
        road.lanes
            .iter()
            .filter_map(|id| map.lane(*id))
            .any(|lane| lane.forward == forward && lane.users.has(Users::CAR))
    };
    cars(true) != cars(false)
}

/// The roads of a higher class to which those give way who come from a lane to a junction without lights.
pub(super) fn yields<'a>(map: &'a StreetMap, lane: &Lane) -> impl Iterator<Item = RoadId> + 'a {
    let road = lane.road;
    let class = map.road(road).map(|road| road.draft.class);
    let movement = lane.next.first().and_then(|id| map.movement(*id));
    let junction = movement
        .and_then(|movement| map.junction(movement.junction))
        .filter(|junction| junction.draft.control == Control::Priority);
    let arms = junction.into_iter().flat_map(|junction| junction.arms.iter().map(|arm| arm.road));
    arms.filter(move |other| {
        map.road(*other).zip(class).is_some_and(|(other, own)| other.draft.class.rank() > own.rank())
    })
}
