//! Walks of the timetable: ways along the walkable network, and how far one has come at a time.

use std::sync::Arc;

use vc_map::route::Router;
use vc_map::{EntranceId, Point, Signal, StreetMap, WalkKind};

use super::TICKS;
use crate::ground::Ground;
use crate::journey;
use crate::lights;
use crate::network::Network;

/// The ground of a piece of a way.
#[derive(Debug, Clone, Copy)]
enum On {
    /// An edge of the walkable network, between two of its stations, metres.
    Edge(u32, [f32; 2]),
    /// A straight line.
    Line([Point; 2]),
}

/// A crossing with lights on a way: where one waits, metres, and for which light.
#[derive(Debug, Clone, Copy)]
struct Lit {
    station: f32,
    signal: u32,
    row: u32,
}

/// A way on foot.
#[derive(Debug, Clone, Default)]
pub(super) struct FootWay {
    /// Its pieces with the stations where they begin, metres.
    pieces: Vec<(f32, On)>,
    lit: Vec<Lit>,
    length: f32,
}

/// How far somebody has come on foot: the station, metres, whether they walk, and the time when they were there at the latest, ticks.
pub(super) struct Come {
    station: f32,
    walks: bool,
    pub(super) at: f64,
}

/// The walkable network, for those who walk by the timetable.
pub(super) struct Pavements {
    network: Arc<Network>,
    ground: Arc<Ground>,
    router: Router,
}

impl Pavements {
    pub(super) fn new(network: Arc<Network>, ground: Arc<Ground>) -> Self {
        let router = Router::on_foot(&network.map, |edge| ground.reluctance(edge.index()));
        Self { network, ground, router }
    }

    /// The way from a door to a door; `None` where none leads.
    pub(super) fn between(&self, from: EntranceId, to: EntranceId) -> Option<FootWay> {
        let edges = journey::edges(&self.network, &self.ground, &self.router, from, to)?;
        let mut way = FootWay::default();
        let [first, last] = [self.at_door(from)?, self.at_door(to)?];
        way.add(On::Line(first));
        for (id, [begins, ends]) in edges {
            if let WalkKind::Crossing(id) = self.network.map.walk_edge(id)?.kind {
                let crossing = self.network.crosswalks.get(id.index())?;
                let signal = self.network.map.junctions().get(crossing.junction as usize)?.signal;
                let station = way.length;
                way.lit.extend(signal.map(|signal| Lit { station, signal: signal.0, row: crossing.row }));
            }
            way.add(On::Edge(id.0, [begins as f32, ends as f32]));
        }
        way.add(On::Line([last[1], last[0]]));
        Some(way)
    }

    /// The way from a door to a place at the kerb.
    pub(super) fn to_kerb(&self, from: EntranceId, kerb: Point) -> Option<FootWay> {
        let door = self.at_door(from)?;
        let mut way = FootWay::default();
        way.add(On::Line(door));
        way.add(On::Line([door[1], kerb]));
        Some(way)
    }

    /// The place before a door, on the walkable network.
    pub(super) fn before(&self, door: EntranceId) -> Option<Point> {
        self.at_door(door).map(|ends| ends[1])
    }

    /// A door, and the place before it.
    fn at_door(&self, door: EntranceId) -> Option<[Point; 2]> {
        let map = &self.network.map;
        let (edge, station) = self.ground.before(map, door)?;
        Some([map.entrance(door)?.door, self.ground.paths.get(edge.index())?.line.at(station)])
    }
}

impl FootWay {
    fn add(&mut self, on: On) {
        let length = match on {
            On::Edge(_, [begins, ends]) => (ends - begins).abs(),
            On::Line([begins, ends]) => (ends - begins).norm() as f32,
        };
        if length > 0.0 {
            self.pieces.push((self.length, on));
            self.length += length;
        }
    }

    /// The same way back.
    pub(super) fn reversed(&self) -> Self {
        let mut way = Self::default();
        for (_, on) in self.pieces.iter().rev() {
            way.add(match *on {
                On::Edge(id, [begins, ends]) => On::Edge(id, [ends, begins]),
                On::Line([begins, ends]) => On::Line([ends, begins]),
            });
        }
        way
    }

    /// How far somebody has come at a time in ticks, who set off at a tick and walks at a speed in metres per second. They wait where lights are red.
    pub(super) fn come(&self, map: &StreetMap, departs: u32, speed: f32, time: f64) -> Come {
        let (mut at, mut here) = (f64::from(departs), 0.0_f32);
        let ticks = |metres: f32| f64::from(metres / speed) * TICKS;
        let on = |here: f32, at: f64| here + ((time - at) / TICKS) as f32 * speed;
        for Lit { station, signal, row } in &self.lit {
            let there = at + ticks(station - here);
            if time < there {
                return Come { station: on(here, at), walks: true, at };
            }
            let signal: Option<&Signal> = map.signals().get(*signal as usize);
            let wait = signal.and_then(|signal| lights::wait(signal, *row as usize, there / TICKS));
            (at, here) = (there + wait.unwrap_or(0.0) * TICKS, *station);
            if time < at {
                return Come { station: here, walks: false, at };
            }
        }
        let there = at + ticks(self.length - here);
        if time < there {
            Come { station: on(here, at), walks: true, at }
        } else {
            Come { station: self.length, walks: false, at: there }
        }
    }

    /// Where somebody is who has come so far, their heading in radians, and whether they walk.
    pub(super) fn place(&self, ground: &Ground, come: &Come) -> Option<(Point, nalgebra::Vector2<f64>, bool)> {
        let piece = self.pieces.partition_point(|(station, _)| *station <= come.station).max(1) - 1;
        let (begins, on) = self.pieces.get(piece)?;
        let metres = f64::from(come.station - begins);
        let (at, along) = match *on {
            On::Edge(id, [from, to]) => {
                let line = &ground.paths.get(id as usize)?.line;
                let way = if from <= to { 1.0 } else { -1.0 };
                let station = f64::from(from) + way * metres;
                (line.at(station), line.direction(station) * way)
            }
            On::Line([from, to]) => {
                let along = (to - from).normalize();
                (from + along * metres, along)
            }
        };
        Some((at, along, come.walks))
    }
}
