//! The way of a vehicle of the timetable along one lane, as a function of the time.

use nalgebra::Vector2;
use vc_map::{Point, Polyline};

use super::TICKS;
use super::pace::Paces;
use crate::network::{NONE, Network};

/// Vehicles change lanes over such a part of their lane, metres.
const ASIDE: f64 = 40.0;

/// A lane of a vehicle's way, with when it comes and goes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Step {
    /// The movement by which it comes; `NONE` where it sets out.
    pub(super) movement: u32,
    /// The lane on which it comes or sets out, and the one at whose end it leaves.
    pub(super) from: u32,
    pub(super) lane: u32,
    /// The ticks in which its front comes to `begin` and leaves `end`.
    pub(super) enters: u32,
    pub(super) leaves: u32,
    /// Stations on the lane, metres: where it begins, where it stands in the queue until those ahead have gone, and where it ends.
    pub(super) begin: f32,
    pub(super) stands: f32,
    pub(super) end: f32,
}

impl Step {
    /// The station of its front at a time in ticks, metres: it goes at its lane's pace, waits in the queue, and goes on at
    /// that pace. This is Newell's
    /// model (Transportation Research B 36, 2002): behind one that keeps this rule another does, too, without coming nearer than
    /// their places in the queue are.
    pub(super) fn station(&self, speed: f64, time: f64) -> f64 {
        let come = f64::from(self.begin) + speed * (time - f64::from(self.enters)).max(0.0);
        let left = f64::from(self.end) - speed * (f64::from(self.leaves) - time).max(0.0);
        come.min(left.max(f64::from(self.stands)))
    }

    /// The point of its way at a station of its lane; before it comes there on the movement by which it does.
    fn point(&self, network: &Network, station: f64) -> Option<Point> {
        let line = network.line(self.lane);
        if station < 0.0 && self.movement != NONE {
            let before = network.line(self.movement);
            let station = before.length() + station;
            return (station >= 0.0).then(|| before.at(station));
        }
        if self.from == self.lane {
            return Some(on(line, station));
        }
        // It changes lanes in an S.
        let begin = f64::from(self.begin);
        let share = ((station - begin) / ASIDE.min((line.length() - begin) / 2.0).max(1.0)).clamp(0.0, 1.0);
        let share = share * share * (3.0 - 2.0 * share);
        let other = network.line(self.from);
        let beside = on(other, station * other.length() / line.length());
        Some(beside + (on(line, station) - beside) * share)
    }
}

/// The point of a line at a station, which may lie before it.
fn on(line: &Polyline, station: f64) -> Point {
    if station < 0.0 { line.start() + line.direction(0.0) * station } else { line.at(station) }
}

/// The front and the rear of a vehicle, and where its front is.
pub(super) struct Body {
    pub(super) front: Point,
    pub(super) rear: Point,
    pub(super) along: Vector2<f64>,
    pub(super) link: u32,
    pub(super) station: f64,
    /// Metres per second.
    pub(super) speed: f64,
}

/// The body of a vehicle of a length at a time in ticks, by the steps of its way.
pub(super) fn body(network: &Network, paces: &Paces, steps: &[Step], length: f64, time: f64) -> Option<Body> {
    let number = steps.partition_point(|step| f64::from(step.enters) <= time).max(1) - 1;
    let step = steps.get(number)?;
    let (link, station, back, speed) = match steps.get(number + 1) {
        // On the movement to the next lane.
        Some(next) if time > f64::from(step.leaves) => {
            let whole = network.line(next.movement).length();
            let pace = whole / f64::from(next.enters - step.leaves).max(1.0);
            let station = (time - f64::from(step.leaves)) * pace;
            (next.movement, station, number + 1, pace)
        }
        _ => {
            let pace = paces.of(step.lane);
            let [station, after] = [time, time + 1.0].map(|time| step.station(pace, time));
            (step.lane, station, number, (after - station).max(0.0))
        }
    };
    // Stations on the lane of the step `back`, negative on the movement before it.
    let on_lane = if back == number { station } else { station - network.line(link).length() };
    let front = point(network, steps, back, on_lane);
    let rear = point(network, steps, back, on_lane - length);
    let line = network.line(link);
    Some(Body { front, rear, along: line.direction(station), link, station, speed: speed * TICKS })
}

/// The point of a way at a station of the lane of a step; negative ones lie on the links before it.
fn point(network: &Network, steps: &[Step], mut number: usize, mut station: f64) -> Point {
    loop {
        if let Some(point) = steps[number].point(network, station) {
            return point;
        }
        station += network.line(steps[number].movement).length();
        let Some(before) = number.checked_sub(1) else { return network.line(steps[number].movement).start() };
        number = before;
        station += network.line(steps[number].lane).length();
    }
}
