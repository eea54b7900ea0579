//! The edges of a city: water to the south, a railway to the north.

use nalgebra::Vector2;
use vc_graph::Seed;
use vc_map::{
    Area, AreaKind, Control, CrossSection, MapDraft, Point, RoadClass, StopDraft, StopKind, Strip, StripKind, Users,
};

use super::convex::left;
use super::specification::Waterside;
use super::street_class::StreetClass;

/// The depths of a promenade, of sand, and of the water that is drawn, metres.
const PROMENADE: f64 = 8.0;
const SAND: f64 = 34.0;
const WATER: f64 = 110.0;
/// The distance between steps to the sand, or ladders of a quay, metres.
const STEPS: f64 = 60.0;
/// From the building line of the street to the middle of the tracks, the length of platforms and their width, metres.
const TRACKS: f64 = 26.0;
const PLATFORM: [f64; 2] = [120.0, 5.0];
/// How far tracks and water go on beyond the city, metres.
const BEYOND: f64 = 90.0;

/// The land at the water.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Shore {
    /// Its kind.
    pub kind: Waterside,
    /// A way along the water, beside the outermost street.
    pub promenade: Vec<Point>,
    /// The sand of a beach.
    pub sand: Option<Vec<Point>>,
    /// The water, as far as it is drawn.
    pub water: Vec<Point>,
    /// The edge of the promenade: a railing, open at the steps.
    pub railing: [Point; 2],
    /// Steps or ladders down, along the railing.
    pub steps: Vec<Point>,
}

/// A railway with its station.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Railway {
    /// The middle of its two tracks.
    pub tracks: [Point; 2],
    /// Its platform, beside the track on the side of the city.
    pub platform: Vec<Point>,
    /// The hall of the station, between the street and the platform.
    pub hall: Vec<Point>,
    /// The door of the hall to the street.
    pub door: Point,
}

/// A straight side of a city, with the direction out of it.
struct Side {
    from: Point,
    to: Point,
    along: Vector2<f64>,
    out: Vector2<f64>,
}

impl Side {
    /// The side that lies farthest towards a direction.
    fn towards(outline: &[Point], direction: Vector2<f64>) -> Option<Self> {
        let ends = outline.iter().zip(outline.iter().cycle().skip(1));
        let sides = ends.map(|(from, to)| {
            let along = (to - from).normalize();
            Self { from: *from, to: *to, along, out: -left(along) }
        });
        sides.max_by(|a, b| a.out.dot(&direction).total_cmp(&b.out.dot(&direction)))
    }

    fn length(&self) -> f64 {
        (self.to - self.from).norm()
    }

    fn at(&self, along: f64, out: f64) -> Point {
        self.from + self.along * along + self.out * out
    }

    /// A rectangle between two distances along the side, and two out of it, counter-clockwise.
    fn band(&self, [from, to]: [f64; 2], [near, far]: [f64; 2]) -> Vec<Point> {
        vec![self.at(from, far), self.at(to, far), self.at(to, near), self.at(from, near)]
    }
}

pub(super) fn shore(outline: &[Point], wished: Option<Waterside>, seed: Seed) -> Option<Shore> {
    let side = Side::towards(outline, -Vector2::y())?;
    let drawn = if seed.child("shore").stream().chance(0.5) { Waterside::Beach } else { Waterside::Quay };
    let kind = wished.unwrap_or(drawn);
    let (edge, length) = (StreetClass::Avenue.edge(), side.length());
    let rail = edge + PROMENADE;
    let sand = if kind == Waterside::Beach { SAND } else { 0.0 };
    let count = (length / STEPS).floor().max(1.0);
    Some(Shore {
        kind,
        promenade: side.band([0.0, length], [edge, rail]),
        sand: (sand > 0.0).then(|| side.band([0.0, length], [rail, rail + sand])),
        water: side.band([-BEYOND, length + BEYOND], [rail + sand, rail + sand + WATER]),
        railing: [side.at(0.0, rail), side.at(length, rail)],
        steps: (0..count as usize).map(|i| side.at(length * (i as f64 + 0.5) / count, rail)).collect(),
    })
}

pub(super) fn railway(outline: &[Point]) -> Option<Railway> {
    let side = Side::towards(outline, Vector2::y())?;
    let edge = StreetClass::Avenue.edge();
    let middle = side.length() / 2.0;
    let [half, wide] = [PLATFORM[0] / 2.0, PLATFORM[1]];
    let inner = edge + TRACKS - 3.6;
    Some(Railway {
        tracks: [side.at(-BEYOND, edge + TRACKS), side.at(side.length() + BEYOND, edge + TRACKS)],
        platform: side.band([middle - half, middle + half], [inner - wide, inner]),
        hall: side.band([middle - 18.0, middle + 18.0], [edge + 1.0, inner - wide]),
        door: side.at(middle, edge + 1.0),
    })
}

fn plain(ring: &[Point]) -> Vec<[f64; 2]> {
    ring.iter().map(|point| [point.x, point.y]).collect()
}

/// Puts an area onto a map.
pub(super) fn area(draft: &mut MapDraft, kind: AreaKind, ring: &[Point], name: &str) {
    draft.areas.push(Area { kind, outline: plain(ring), holes: Vec::new(), name: Some(name.to_owned()), source: 0 });
}

/// Puts the edges of a city onto its map.
pub(super) fn put(draft: &mut MapDraft, shore: Option<&Shore>, railway: Option<&Railway>) {
    if let Some(shore) = shore {
        area(draft, AreaKind::Water, &shore.water, "water");
        area(draft, AreaKind::Square, &shore.promenade, "promenade");
        shore.sand.iter().for_each(|sand| area(draft, AreaKind::Square, sand, "beach"));
    }
    let Some(railway) = railway else { return };
    area(draft, AreaKind::Platform, &railway.platform, "platform");
    let ends = railway.tracks.map(|at| draft.junction([at.x, at.y], Control::Edge));
    let track = || vec![Strip::new(StripKind::Track, 3.6, Users::TRAIN, 22.0)];
    draft.road(ends[0], ends[1], RoadClass::Rail, CrossSection { forward: track(), backward: track(), median: 0.0 });
    let mut hall = vc_map::Building::new(plain(&railway.hall), 2);
    hall.kind = "train_station".to_owned();
    draft.buildings.push(hall);
    let building = vc_map::BuildingId((draft.buildings.len() - 1) as u32);
    let at = [railway.door.x, railway.door.y];
    draft.entrances.push(vc_map::EntranceDraft { building, at, kind: "main".to_owned(), source: 1 });
    let stop = nalgebra::center(&railway.platform[0], &railway.platform[2]);
    draft.stops.push(StopDraft {
        kind: StopKind::Train,
        at: [stop.x, stop.y],
        name: Some("Central Station".to_owned()),
        source: 0,
    });
}
