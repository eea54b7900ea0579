//! Streets of a plan, and the map that is built from them.

use std::collections::{BTreeMap, BTreeSet};

use vc_graph::Seed;
use vc_map::{Control, CrossingDraft, CrossingKind, JunctionId, MapDraft, Point, RoadId};

use super::net::Net;
use super::street_class::StreetClass;

/// The share of the length of streets that are shopping streets, and of those that are one-way lanes.
const SHOPPING: f64 = 0.1;
const LANES: f64 = 0.12;
/// A lane is at most this long, metres.
const LANE: f64 = 190.0;

/// A street of a plan.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Street {
    /// Its class.
    pub class: StreetClass,
    /// Its name.
    pub name: String,
    /// The middle of its carriageway; that of a ring ends where it begins.
    pub line: Vec<Point>,
    /// Its roads on the map, in the order of its line.
    pub roads: Vec<RoadId>,
}

impl Street {
    /// Its length, metres.
    pub fn length(&self) -> f64 {
        self.line.windows(2).map(|ends| (ends[1] - ends[0]).norm()).sum()
    }
}

fn length(net: &Net, line: usize) -> f64 {
    let along = &net.lines[line].along;
    along.windows(2).map(|ends| (net.points[ends[1]] - net.points[ends[0]]).norm()).sum()
}

/// Gives streets that are not main ones their classes: shopping streets near the centre, lanes between two blocks each.
pub(super) fn classes(net: &mut Net, centre: &Point, seed: Seed) {
    let all: f64 = (0..net.lines.len()).map(|line| length(net, line)).sum();
    let degrees = net.degrees();
    let minor: Vec<usize> = (0..net.lines.len()).filter(|line| !net.lines[*line].class.is_main()).collect();
    let away = |line: &usize| {
        let along = &net.lines[*line].along;
        let sum = along.iter().fold(nalgebra::Vector2::zeros(), |sum, v| sum + (net.points[*v] - centre));
        sum.norm() / along.len() as f64
    };
    let mut near = minor.clone();
    near.sort_by(|a, b| away(a).total_cmp(&away(b)).then(a.cmp(b)));
    let shopping =
        taken(near.into_iter().filter(|line| length(net, *line) > 120.0), |line| length(net, line), SHOPPING * all);
    shopping.iter().for_each(|line| net.lines[*line].class = StreetClass::Shopping);
    let leaf = |line: &usize| {
        let street = &net.lines[*line];
        street.class == StreetClass::Residential
            && street.along.len() == 2
            && length(net, *line) < LANE
            && street.along.iter().all(|v| degrees[*v] == 3)
    };
    let mut leaves: Vec<usize> = minor.into_iter().filter(leaf).collect();
    seed.child("lanes").stream().shuffle(&mut leaves);
    taken(leaves.into_iter(), |line| length(net, line), LANES * all)
        .iter()
        .for_each(|line| net.lines[*line].class = StreetClass::Lane);
}

/// As many of some lines as have a length together.
fn taken(lines: impl Iterator<Item = usize>, length: impl Fn(usize) -> f64, most: f64) -> Vec<usize> {
    let mut sum = 0.0;
    lines
        .take_while(|line| {
            sum += length(*line);
            sum <= most
        })
        .collect()
}

/// The streets of a network, and the description of their map.
pub(super) fn draft(net: &Net, name: String, seed: Seed) -> (MapDraft, Vec<Street>) {
    let mut draft = MapDraft::new(name, 48.0, 11.0);
    let degrees = net.degrees();
    let mut classes = vec![Vec::new(); net.points.len()];
    for line in &net.lines {
        line.along.iter().for_each(|v| classes[*v].push(line.class));
    }
    // Bends of the outermost street are no junctions.
    let mut ids: BTreeMap<usize, JunctionId> = BTreeMap::new();
    for vertex in (0..net.points.len()).filter(|v| degrees[*v] > 2) {
        let at = net.points[vertex];
        ids.insert(vertex, draft.junction([at.x, at.y], control(&classes[vertex], degrees[vertex])));
    }
    // Somewhere one crosses the outermost street.
    let ring =
        net.lines.iter().filter(|line| line.closed).flat_map(|line| &line.along).filter_map(|vertex| ids.get(vertex));
    let ring: Vec<JunctionId> = ring.copied().collect();
    if !ring.iter().any(|id| draft.junctions[id.index()].control == Control::Signals) {
        ring.first().into_iter().for_each(|id| draft.junctions[id.index()].control = Control::Signals);
    }
    let names = names(net, seed);
    let streets = net.lines.iter().zip(names).map(|(line, name)| {
        let closing = if line.closed { line.along.first() } else { None };
        let mut along: Vec<usize> = line.along.iter().chain(closing).copied().collect();
        // A ring begins at a junction.
        if let Some(first) = along.iter().position(|v| ids.contains_key(v)).filter(|_| line.closed) {
            along.pop();
            along.rotate_left(first);
            along.push(along[0]);
        }
        let roads = roads(&mut draft, net, &along, &ids, line.class, &name);
        let points = along.iter().map(|v| net.points[*v]).collect();
        Street { class: line.class, name, line: points, roads }
    });
    let streets: Vec<Street> = streets.collect();
    zebras(&mut draft);
    (draft, streets)
}

/// The right of way: lights where two main streets meet, or a main street and a shopping street, or four arms with a main one.
fn control(classes: &[StreetClass], degree: usize) -> Control {
    let main = classes.iter().filter(|class| class.is_main()).count();
    let busy = classes.iter().filter(|class| **class <= StreetClass::Shopping).count();
    if main > 0 && (busy > 1 || degree > 3) { Control::Signals } else { Control::Priority }
}

/// A road for each part of a street between two junctions.
fn roads(
    draft: &mut MapDraft,
    net: &Net,
    along: &[usize],
    ids: &BTreeMap<usize, JunctionId>,
    class: StreetClass,
    name: &str,
) -> Vec<RoadId> {
    let mut roads = Vec::new();
    let mut begun: Option<(JunctionId, Vec<[f64; 2]>)> = None;
    for vertex in along {
        let at = [net.points[*vertex].x, net.points[*vertex].y];
        if let Some((_, line)) = &mut begun {
            line.push(at);
        }
        let Some(id) = ids.get(vertex) else { continue };
        if let Some((from, line)) = begun.take() {
            let road = draft.road(from, *id, class.road(), class.section());
            draft.roads[road.index()].line = line;
            draft.roads[road.index()].name = Some(name.to_owned());
            roads.push(road);
        }
        begun = Some((*id, vec![at]));
    }
    roads
}

/// Zebras over the arms of shopping streets where there are no lights.
fn zebras(draft: &mut MapDraft) {
    let shopping = StreetClass::Shopping.road();
    let mut ends = BTreeSet::new();
    for (index, road) in draft.roads.iter().enumerate().filter(|(_, road)| road.class == shopping) {
        ends.extend([(road.from, RoadId(index as u32)), (road.to, RoadId(index as u32))]);
    }
    for (at, road) in
        ends.into_iter().filter(|(at, _)| draft.junctions[at.index()].control != Control::Signals).collect::<Vec<_>>()
    {
        draft.crossings.push(CrossingDraft { at, road, kind: CrossingKind::Marked, island: false, source: 0 });
    }
}

/// A name for each street, none twice.
fn names(net: &Net, seed: Seed) -> Vec<String> {
    let lines = include_str!("../../data/street_names.txt").lines().filter(|line| !line.starts_with('#'));
    let mut words: Vec<&str> = lines.flat_map(str::split_whitespace).collect();
    seed.child("names").stream().shuffle(&mut words);
    let name = |(index, line): (usize, &super::net::Line)| {
        let kind = match line.class {
            StreetClass::Boulevard => "Boulevard",
            StreetClass::Avenue => "Avenue",
            StreetClass::Lane => "Lane",
            StreetClass::Shopping | StreetClass::Residential => "Street",
        };
        let kind = if line.closed { "Ring" } else { kind };
        let round = index / words.len();
        let number = if round == 0 { String::new() } else { format!(" {}", round + 1) };
        format!("{} {kind}{number}", words[index % words.len()])
    };
    net.lines.iter().enumerate().map(name).collect()
}
