//! Doors where none is mapped: in the wall that is nearest to a way on which people walk.

use super::Guessed;
use super::places::Places;
use crate::index::PointIndex;
use crate::{Building, BuildingId, EntranceDraft, Point, Polyline, RoadDraft, Structure, Users};

/// A door is looked for on the side towards a way that is at most this far, metres.
const WAY: f64 = 60.0;
/// No carriageway reaches further from its middle, metres.
const WIDEST: f64 = 30.0;

impl Places<'_> {
    /// A door for each building without one: in the middle of the wall that is nearest to a way on which people walk, and not
    /// over a carriageway.
    pub(super) fn guess_doors(&mut self) {
        let walked = |road: &&crate::RoadDraft| {
            let users = road.section.users(true) | road.section.users(false);
            users.has(Users::FOOT) && road.layer == 0
        };
        let ways = Ways::new(self.draft.roads.iter().filter(walked));
        let streets = self.draft.roads.iter().filter(|road| road.class.is_street() && road.layer == 0);
        let streets = Ways::new(streets.filter(|road| road.structure == Structure::Ground));
        let mut has = vec![false; self.draft.buildings.len()];
        self.draft.entrances.iter().for_each(|entrance| has[entrance.building.index()] = true);
        for (number, building) in self.draft.buildings.iter().enumerate() {
            if has[number] || building.part || building.base > 0.0 {
                continue;
            }
            let Some(at) = door(building, &ways, &streets) else { continue };
            let building = BuildingId::of(number);
            self.draft.entrances.push(EntranceDraft { building, at, kind: "guessed".to_owned(), source: 0 });
            self.report.guess(self.buildings[number], Guessed::Entrance);
        }
    }
}

/// The lines of some roads, by place.
struct Ways {
    lines: Vec<Polyline>,
    /// Half the width of the carriageway of each, metres.
    halves: Vec<f64>,
    index: PointIndex,
}

impl Ways {
    fn new<'a>(roads: impl Iterator<Item = &'a RoadDraft>) -> Self {
        let line = |road: &RoadDraft| Some((Polyline::new(road.line.iter().copied())?, road.section.surface() / 2.0));
        let (lines, halves): (Vec<Polyline>, Vec<f64>) = roads.filter_map(line).unzip();
        let index = PointIndex::new(lines.iter().enumerate().map(|(id, line)| (id as u32, line)));
        Self { lines, halves, index }
    }

    /// Whether a point lies on a carriageway.
    fn carry(&self, point: &Point) -> bool {
        let near = self.index.each(point, WIDEST, |id| &self.lines[id as usize]);
        near.into_iter().any(|(id, near)| near.left.abs() < self.halves[id as usize])
    }
}

fn door(building: &Building, ways: &Ways, streets: &Ways) -> Option<[f64; 2]> {
    let ring = &building.outline;
    let walls = ring.iter().zip(ring.iter().cycle().skip(1));
    let middles = walls
        .filter(|(a, b)| (Point::from(**a) - Point::from(**b)).norm() > 1.5)
        .map(|(a, b)| Point::new((a[0] + b[0]) / 2.0, (a[1] + b[1]) / 2.0));
    let mut best: Option<(f64, Point)> = None;
    // An outline of thousands of walls is tried at some of them.
    for middle in middles.step_by(1 + ring.len() / 64) {
        let least = best.map_or(WAY, |(least, _)| least);
        let mut near = least;
        ways.index.around(&middle, near, |id| {
            near = near.min(ways.lines[id as usize].project(&middle).left.abs());
            near
        });
        if near < least && !streets.carry(&middle) {
            best = Some((near, middle));
        }
    }
    best.map(|(_, at)| [at.x, at.y])
}
