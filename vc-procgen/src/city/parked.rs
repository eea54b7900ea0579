//! Parked cars: in bays, but not where they would hide who comes.

use vc_graph::Seed;
use vc_map::{Lane, Point, StopKind, StreetMap};

use super::convex::{Beyond, Convex, left};
use super::near::Near;
use super::view::View;

/// The share of bays in which somebody has parked.
const TAKEN: f32 = 0.82;
/// Classes of cars with their weights, lengths and widths, metres.
const CARS: [(&str, f32, [f64; 2]); 7] = [
    ("hatchback", 30.0, [4.1, 1.75]),
    ("sedan", 20.0, [4.75, 1.82]),
    ("station_wagon", 16.0, [4.75, 1.84]),
    ("suv", 18.0, [4.65, 1.88]),
    ("electric_car", 8.0, [4.4, 1.82]),
    ("minivan", 5.0, [4.8, 1.88]),
    ("van", 3.0, [5.2, 1.95]),
];
/// Nobody parks nearer to a stop line or the middle of a bus stop than this, metres.
const UPSTREAM: f64 = 14.0;
const STOP: f64 = 12.0;
/// A parked car.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct ParkedCar {
    /// Its class.
    pub class: &'static str,
    /// Its middle.
    pub at: Point,
    /// Its heading, radians.
    pub heading: f64,
    /// Its length and width, metres.
    pub size: [f64; 2],
}

impl ParkedCar {
    /// The ground under it.
    pub fn outline(&self) -> Convex {
        let (sine, cosine) = vc_graph::portable::Portable::sine_cosine(self.heading);
        let along = nalgebra::Vector2::new(cosine, sine);
        let (u, v) = (along * (self.size[0] / 2.0), left(along) * (self.size[1] / 2.0));
        let corners = vec![self.at - u - v, self.at + u - v, self.at + u + v, self.at - u + v];
        Convex::new(corners, vec![Beyond::Court; 4])
    }
}

/// Cars in the bays of a map.
pub(super) fn parked(map: &StreetMap, views: &[View], seed: Seed) -> Vec<ParkedCar> {
    let stops: Vec<Point> = map.stops().iter().filter(|stop| stop.kind == StopKind::Bus).map(|stop| stop.at).collect();
    let stops = Near::of(&stops);
    let mut cars = Vec::new();
    for (index, bay) in map.bays().enumerate() {
        let mut stream = seed.child("car").nth(index as u64).stream();
        let Some((class, _, size)) = stream.weighted(CARS.iter().map(|car| car.1)).map(|i| CARS[i]) else { continue };
        let upstream = |lane: &Lane| lane.line.length() - lane.line.project(&bay.at).station < UPSTREAM;
        let bent = |lane: &Lane| {
            let at = lane.line.project(&bay.at).station;
            lane.line.direction(at - 4.0).dot(&lane.line.direction(at + 4.0)) < 0.999
        };
        let kept = map.lane(bay.lane).is_some_and(|lane| upstream(lane) || bent(lane))
            || stops.around(&bay.at, STOP).next().is_some();
        let room = bay.size[0] - size[0] - 0.3;
        let shift = f64::from(stream.between(-0.5, 0.5)) * room;
        if stream.chance(TAKEN) && !kept {
            let (sine, cosine) = vc_graph::portable::Portable::sine_cosine(bay.heading);
            cars.push(ParkedCar {
                class,
                at: bay.at + nalgebra::Vector2::new(cosine, sine) * shift,
                heading: bay.heading,
                size,
            });
        }
    }
    let places: Vec<Point> = cars.iter().map(|car| car.at).collect();
    let near = Near::of(&places);
    let mut hides = vec![false; cars.len()];
    for view in views {
        for car in view.near(&near, 6.0) {
            hides[car] = hides[car] || view.ground.shared(&cars[car].outline()) > 0.0;
        }
    }
    let mut hides = hides.into_iter();
    cars.retain(|_| !hides.next().unwrap_or(false));
    cars
}
