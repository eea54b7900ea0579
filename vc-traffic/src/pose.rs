//! Where vehicles are, and whether their bodies overlap.

use std::collections::BTreeMap;

use nalgebra::Vector2;
use vc_graph::portable::Portable;
use vc_map::{LaneId, MovementId, Point};

use crate::Traffic;
use crate::network::NONE;
use crate::swept::is_long;
use crate::trip::VehicleId;

/// Bodies overlap if they do by more than this, metres.
const OVERLAP: f64 = 0.01;

/// Bodies are compared with those in cells around theirs, of this size, metres.
const CELL: f64 = 16.0;

/// A vehicle as it is.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Pose {
    /// The middle of its body.
    pub at: Point,
    /// The direction of its body, radians from the X axis, counter-clockwise.
    pub heading: f64,
    /// Its speed, metres per second.
    pub speed: f32,
    /// Its kind: the position in the table of classes.
    pub class: u8,
    /// The lane that its front is on; `None` within a junction.
    pub lane: Option<LaneId>,
    /// The movement that its front is on; `None` in a lane.
    pub movement: Option<MovementId>,
    /// The station of its front there, metres.
    pub station: f32,
    /// Its length and width, metres.
    pub size: [f32; 2],
}

impl Pose {
    /// A body of a size, with nothing else known.
    pub(crate) fn of((at, forward): (Point, Vector2<f64>), size: [f32; 2]) -> Self {
        let heading = forward.y.angle_to(forward.x);
        Self { at, heading, speed: 0.0, class: 0, lane: None, movement: None, station: 0.0, size }
    }

    /// The corners of its body, counter-clockwise from the front left.
    pub fn corners(&self) -> [Point; 4] {
        let [forward, left] = self.axes();
        let [length, width] = self.size.map(|metres| f64::from(metres) / 2.0);
        [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)]
            .map(|(x, y): (f64, f64)| self.at + forward * (length * x) + left * (width * y))
    }

    /// The middle of its front.
    pub fn front(&self) -> Point {
        let [forward, _] = self.axes();
        self.at + forward * f64::from(self.size[0] / 2.0)
    }

    fn axes(&self) -> [Vector2<f64>; 2] {
        let (sine, cosine) = self.heading.sine_cosine();
        [Vector2::new(cosine, sine), Vector2::new(-sine, cosine)]
    }

    /// By how much two bodies overlap along the axis on which they do least, metres; negative if they are apart.
    pub(crate) fn overlap(&self, other: &Self) -> f64 {
        let half = |pose: &Self, axis: &Vector2<f64>| {
            let [forward, left] = pose.axes();
            let [length, width] = pose.size.map(|metres| f64::from(metres) / 2.0);
            length * forward.dot(axis).abs() + width * left.dot(axis).abs()
        };
        let between = other.at - self.at;
        let axes = self.axes().into_iter().chain(other.axes());
        axes.map(|axis| half(self, &axis) + half(other, &axis) - between.dot(&axis).abs()).fold(f64::INFINITY, f64::min)
    }
}

/// The middle and the direction of a body of a length, metres, whose front is at a station of a way. In turns it swings out by half of what its middle
/// would cut off; a long one does not, as its rear would come to those beside it.
pub(crate) fn body(at: impl Fn(f64) -> Point, station: f64, length: f32) -> (Point, Vector2<f64>) {
    let length = f64::from(length);
    let [front, middle, rear] = [0.0, length / 2.0, length].map(|behind| at(station - behind));
    let along = at(station + 0.1) - at(station - 0.1);
    let forward = (front - rear).try_normalize(1e-3).or(along.try_normalize(1e-6)).unwrap_or_else(Vector2::x);
    let swing =
        if is_long(length as f32) { Vector2::zeros() } else { (middle - nalgebra::center(&front, &rear)) / 2.0 };
    (front - forward * (length / 2.0) + swing, forward)
}

impl Traffic {
    pub(crate) fn pose(&self, slot: u32) -> Pose {
        let (network, fleet) = (&self.network, &self.fleet);
        let i = slot as usize;
        let class = &self.classes[fleet.class[i] as usize];
        let link = fleet.link[i];
        let station = fleet.s[i];
        let (middle, forward) = body(|station| self.rear(slot, station), f64::from(station), class.length);
        let aside = Vector2::new(-forward.y, forward.x) * f64::from(fleet.aside[i]);
        Pose {
            at: middle + aside,
            heading: forward.y.angle_to(forward.x),
            speed: fleet.v[i],
            class: fleet.class[i],
            lane: network.is_lane(link).then_some(LaneId(link)),
            movement: (!network.is_lane(link)).then(|| MovementId(network.movement(link) as u32)),
            station,
            size: [class.length, class.width],
        }
    }

    /// The point at a station that its front has passed, on the way that a vehicle came.
    fn rear(&self, slot: u32, station: f64) -> Point {
        let (network, fleet) = (&self.network, &self.fleet);
        let i = slot as usize;
        let link = fleet.link[i];
        if station >= 0.0 {
            return network.line(link).at(station);
        }
        let before = if network.is_lane(link) { fleet.behind[i] } else { network.from[network.movement(link)] };
        if before == NONE {
            return network.line(link).start() + network.line(link).direction(0.0) * station;
        }
        let line = network.line(before);
        let station = line.length() + station;
        if station >= 0.0 || network.is_lane(before) {
            return if station >= 0.0 { line.at(station) } else { line.start() + line.direction(0.0) * station };
        }
        let lane = network.line(network.from[network.movement(before)]);
        lane.at((lane.length() + station).max(0.0))
    }

    /// The pairs of vehicles whose bodies overlap by more than a centimetre; none at any time. Costs a look at each vehicle and its
    /// neighbours.
    pub fn overlaps(&self) -> Vec<(VehicleId, VehicleId)> {
        let layer = |pose: &Pose| {
            let map = self.map();
            let road =
                |lane: LaneId| map.lane(lane).and_then(|lane| map.road(lane.road)).map_or(0, |road| road.draft.layer);
            let from = pose.movement.and_then(|id| map.movement(id)).map(|movement| movement.from);
            pose.lane.or(from).map_or(0, road)
        };
        let all: Vec<(VehicleId, Pose, i8)> = self.vehicles().map(|(id, pose)| (id, pose, layer(&pose))).collect();
        let mut cells: BTreeMap<(i64, i64), Vec<usize>> = BTreeMap::new();
        let cell = |at: &Point| ((at.x / CELL).floor() as i64, (at.y / CELL).floor() as i64);
        all.iter().enumerate().for_each(|(number, (_, pose, _))| cells.entry(cell(&pose.at)).or_default().push(number));
        let mut found = Vec::new();
        for (number, (id, pose, level)) in all.iter().enumerate() {
            let (x, y) = cell(&pose.at);
            for place in (x - 1..=x + 1).flat_map(|x| (y - 1..=y + 1).map(move |y| (x, y))) {
                for other in cells.get(&place).into_iter().flatten().filter(|other| **other > number) {
                    let (theirs, there, height) = &all[*other];
                    if level == height && pose.overlap(there) > OVERLAP {
                        found.push((*id, *theirs));
                    }
                }
            }
        }
        found
    }
}
