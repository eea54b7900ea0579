//! A walk as it is gone: its way from door to door, and the parts of it on which vehicles go.

use std::sync::Arc;

use vc_map::route::{Leg, Router};
use vc_map::{EntranceId, Polyline, WalkEdgeId, WalkKind};

use crate::bytes::{Reader, Writer};
use crate::crowd::{RADIUS, Way};
use crate::ground::{Ground, Over, Path};
use crate::network::Network;
use crate::save::SaveError;
use crate::trip::Walk;

/// A part of somebody's way on which vehicles go: crossings with no room to wait between them, or one where there is none.
#[derive(Debug, Clone)]
pub(crate) struct Passage {
    pub(crate) crossings: Vec<u32>,
    /// Between two stations: one waits before the first, and has left it behind the second.
    pub(crate) over: Over,
    /// Where vehicles go from, metres.
    pub(crate) kerb: f32,
}

/// Somebody's way, as it is gone.
#[derive(Debug, Clone)]
pub(crate) struct Journey {
    pub(crate) passages: Arc<[Passage]>,
    pub(crate) next: usize,
    /// Whether they may cross the next, or do.
    pub(crate) on: bool,
    /// For how long they have waited to, seconds.
    pub(crate) waits: f32,
    pub(crate) since: f32,
    pub(crate) speed: f32,
}

impl Journey {
    pub(crate) fn save(&self, to: &mut Writer) {
        to.word(self.next as u32);
        to.word(u32::from(self.on));
        to.reals([self.waits, self.since, self.speed]);
    }

    pub(crate) fn read(passages: Arc<[Passage]>, from: &mut Reader) -> Result<Self, SaveError> {
        let next = from.below(passages.len() + 1, "passage")? as usize;
        let on = from.below(2, "passage")? == 1;
        let [waits, since, speed] = from.reals("number of a person")?;
        if on && next == passages.len() {
            return Err(SaveError::Wrong("passage"));
        }
        Ok(Self { passages, next, on, waits, since, speed })
    }
}

/// A way that is put together.
#[derive(Default)]
struct Parts {
    lines: Vec<(Polyline, f32)>,
    passages: Vec<Passage>,
    length: f32,
}

impl Parts {
    /// Adds the part of a path between two stations in metres, backward if it ends before it begins; of a crossing with its kerbs.
    fn add(&mut self, path: &Path, [from, to]: [f64; 2], crossing: Option<(u32, [f32; 2])>) {
        let [low, high] = [from.min(to), from.max(to)];
        let Some(line) = path.line.part(low, high) else { return };
        let (low, high) = (low as f32, high as f32);
        let ahead = |at: f32| self.length + if from <= to { at - low } else { high - at };
        let over = crossing.map(|(id, kerbs)| (Some(id), kerbs.map(|kerb| kerb + path.before), Vec::new()));
        let roads = path.over.iter().filter(|over| over.from < high && over.to > low);
        let roads = roads.map(|over| (None, [over.from.max(low), over.to.min(high)], over.spans.clone()));
        let mut passages: Vec<Passage> = over
            .into_iter()
            .chain(roads)
            .map(|(crossing, ends, spans)| {
                let [a, b] = ends.map(ahead);
                let (from, to) = (a.min(b), a.max(b));
                Passage { crossings: crossing.into_iter().collect(), over: Over { from, to, spans }, kerb: from }
            })
            .collect();
        passages.sort_by(|a, b| a.over.from.total_cmp(&b.over.from));
        passages.into_iter().for_each(|passage| self.pass(passage));
        self.length += line.length() as f32;
        self.lines.push((if from <= to { line } else { line.reversed() }, path.width));
    }

    /// Adds a passage; parts of the way on which nobody would wait between two of them belong to one.
    fn pass(&mut self, passage: Passage) {
        if let Some(last) = self.passages.last_mut()
            && last.over.join(&passage.over)
        {
            return last.crossings.extend(passage.crossings);
        }
        self.passages.push(passage);
    }
}

/// The edges of a way from door to door, each with the stations where one begins to go along it and where one leaves it, metres. `None` where no
/// way leads.
pub(crate) fn edges(
    network: &Network,
    ground: &Ground,
    router: &Router,
    from: EntranceId,
    to: EntranceId,
) -> Option<Vec<(WalkEdgeId, [f64; 2])>> {
    let route = router.between_entrances(from, to)?;
    let [first, last] = [ground.before(&network.map, from)?, ground.before(&network.map, to)?];
    let count = route.legs.len();
    let edge = |(number, leg): (usize, &Leg)| {
        let Leg::Walk(id, forward) = leg else { return None };
        let length = ground.paths.get(id.index())?.line.length();
        let mut range = if *forward { [0.0, length] } else { [length, 0.0] };
        if number == 0 && first.0 == *id {
            range[0] = first.1;
        }
        if number + 1 == count && last.0 == *id {
            range[1] = last.1;
        }
        Some((*id, range))
    };
    route.legs.iter().enumerate().map(edge).collect()
}

/// The way of a walk, and where vehicles go on it. `None` where no way leads.
pub(crate) fn way(
    network: &Network,
    ground: &Ground,
    router: &Router,
    walk: &Walk,
) -> Option<(Arc<Way>, Arc<[Passage]>)> {
    let map = &network.map;
    let edges = edges(network, ground, router, walk.from, walk.to)?;
    let [(first, _), (last, _)] = [ground.door(map, walk.from)?, ground.door(map, walk.to)?];
    let mut parts = Parts::default();
    if let Some(path) = first {
        parts.add(&path, [0.0, path.line.length()], None);
    }
    for (id, range) in edges {
        let path = ground.paths.get(id.index())?;
        let crossing = match map.walk_edge(id)?.kind {
            WalkKind::Crossing(id) => Some((id.0, network.crosswalks.get(id.index())?.kerbs)),
            _ => None,
        };
        parts.add(path, range, crossing);
    }
    if let Some(path) = last {
        parts.add(&path, [path.line.length(), 0.0], None);
    }
    let way = Way::new(std::mem::take(&mut parts.lines))?;
    // Nobody waits in a bend, or has left a passage there.
    for mut passage in std::mem::take(&mut parts.passages) {
        let over = &mut passage.over;
        for [from, to] in way.bends() {
            if from - RADIUS < over.from && over.from - RADIUS < to {
                over.from = from - RADIUS;
            }
            if from - RADIUS < over.to && over.to < to {
                over.to = to;
            }
        }
        over.from = over.from.max(0.0);
        parts.pass(passage);
    }
    Some((Arc::new(way), parts.passages.into()))
}
