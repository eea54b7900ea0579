//! Buildings with their doors, areas and stops.

use std::collections::BTreeMap;

use super::data::Tags;
use super::rings::Shape;
use super::{Element, Guessed, ImportReport, OsmData, Reason};
use crate::index::PointIndex;
use crate::{
    Area, AreaKind, Building, BuildingId, EntranceDraft, MapDraft, Point, Polyline, StopDraft, StopKind, Users,
};

/// The height of a storey where nothing is mapped, metres (B4 of the note on places).
const STOREY: f64 = 3.1;
/// A door is looked for on the side towards a way that is at most this far, metres.
const WAY: f64 = 60.0;

pub(super) fn places(data: &OsmData, points: &[Point], draft: &mut MapDraft, report: &mut ImportReport) {
    let mut doors: BTreeMap<i64, BuildingId> = BTreeMap::new();
    for relation in &data.relations {
        let tags = data.relation_tags(relation);
        if !tags.is("type", "multipolygon|building") || what(tags).is_none() {
            continue;
        }
        let shapes = data.multipolygon(relation, points);
        if shapes.is_empty() {
            report.drop(Element::Relation(relation.id), Reason::CutOff);
        }
        shapes
            .into_iter()
            .for_each(|shape| add(draft, Element::Relation(relation.id), tags, shape, &mut doors, report));
    }
    for way in &data.ways {
        let tags = data.way_tags(way);
        let Some(what) = what(tags) else { continue };
        match data.ring(way, points) {
            Some(shape) => add(draft, Element::Way(way.id), tags, shape, &mut doors, report),
            None if matches!(what, What::Area(AreaKind::Water | AreaKind::Platform)) => {}
            None => report.drop(Element::Way(way.id), Reason::NoShape),
        }
    }
    nodes(data, points, draft, &doors);
    guess_doors(draft, report);
}

enum What {
    Building,
    Area(AreaKind),
}

/// Whether something is a building, or an area of some kind.
fn what(tags: Tags<'_>) -> Option<What> {
    let yes = |key| tags.get(key).is_some_and(|value| value != "no");
    if yes("building") || yes("building:part") {
        return Some(What::Building);
    }
    let green = tags.is("leisure", "park|garden|pitch|playground|golf_course|nature_reserve|common")
        || tags
            .is("landuse", "grass|forest|meadow|recreation_ground|village_green|cemetery|orchard|farmland|flowerbed")
        || tags.is("natural", "wood|grassland|scrub|heath|shrubbery");
    let kind = match () {
        () if tags.is("natural", "water")
            || tags.is("waterway", "riverbank|dock")
            || tags.is("landuse", "basin|reservoir") =>
        {
            AreaKind::Water
        }
        () if tags.is("amenity", "fountain") || tags.is("leisure", "swimming_pool") => AreaKind::Water,
        () if green => AreaKind::Green,
        () if tags.is("amenity", "parking") => AreaKind::Parking,
        () if tags.is("railway", "platform") || tags.is("public_transport", "platform") => AreaKind::Platform,
        () if tags.is("highway", "pedestrian|footway|service") && tags.is("area", "yes") => AreaKind::Square,
        () if tags.is("highway", "pedestrian") && tags.is("type", "multipolygon") => AreaKind::Square,
        () if yes("area:highway") => return None,
        () if tags.is("landuse", "residential|commercial|retail|industrial|construction") => AreaKind::Lot,
        () => return None,
    };
    Some(What::Area(kind))
}

fn add(
    draft: &mut MapDraft,
    element: Element,
    tags: Tags<'_>,
    shape: Shape,
    doors: &mut BTreeMap<i64, BuildingId>,
    report: &mut ImportReport,
) {
    let source = match element {
        Element::Node(id) | Element::Way(id) | Element::Relation(id) => id,
    };
    let plain = |ring: &Vec<Point>| ring.iter().map(|p| [p.x, p.y]).collect::<Vec<_>>();
    let (outline, holes) = (plain(&shape.outline), shape.holes.iter().map(plain).collect());
    match what(tags) {
        Some(What::Building) => {
            let id = BuildingId::of(draft.buildings.len());
            let building = building(element, source, tags, outline, holes, report);
            if !building.part {
                shape.nodes.iter().for_each(|node| _ = doors.entry(*node).or_insert(id));
            }
            draft.buildings.push(building);
        }
        Some(What::Area(kind)) => {
            draft.areas.push(Area { kind, outline, holes, name: tags.get("name").map(str::to_owned), source });
        }
        None => {}
    }
}

fn building(
    element: Element,
    source: i64,
    tags: Tags<'_>,
    outline: Vec<[f64; 2]>,
    courts: Vec<Vec<[f64; 2]>>,
    report: &mut ImportReport,
) -> Building {
    let levels = tags.get("building:levels").and_then(number).map(|n| n.clamp(0.0, 200.0).round() as u32);
    let height = tags.get("height").or_else(|| tags.get("building:height")).and_then(metres);
    let storeys = levels.or_else(|| height.map(|height| ((height / STOREY).round() as u32).max(1)));
    let storeys = storeys.unwrap_or_else(|| {
        let usual = if tags.is("building", "garage|garages|shed|roof|kiosk|hut|carport") { 1 } else { 3 };
        report.guess(element, Guessed::Storeys(usual));
        usual
    });
    let least = tags.get("min_height").and_then(metres);
    let below = tags.get("building:min_level").and_then(number).map(|level| level * STOREY);
    let base = least.or(below).unwrap_or(0.0).clamp(0.0, 900.0);
    let height = height.unwrap_or_else(|| {
        let roof = tags.get("roof:levels").and_then(number).unwrap_or(0.0).clamp(0.0, 20.0);
        let usual = (f64::from(storeys) + roof).max(1.0) * STOREY;
        report.guess(element, Guessed::Height(usual));
        usual
    });
    let kind = tags.get("building").or_else(|| tags.get("building:part")).unwrap_or("yes").to_owned();
    let street = tags.get("addr:street").unwrap_or_default();
    let address = tags.get("addr:housenumber").map(|number| format!("{street} {number}").trim().to_owned());
    Building {
        outline,
        courts,
        height: height.max(base + 0.1),
        base,
        storeys,
        kind,
        name: tags.get("name").map(str::to_owned),
        address,
        part: tags.get("building").is_none(),
        source,
    }
}

fn number(text: &str) -> Option<f64> {
    text.split(';').next()?.trim().replace(',', ".").parse::<f64>().ok().filter(|n| n.is_finite())
}

/// A length: metres without a unit, with `m`, or feet as `12'` or `12 ft`.
fn metres(text: &str) -> Option<f64> {
    let text = text.trim();
    let digits: String = text.chars().take_while(|c| c.is_ascii_digit() || matches!(c, '.' | ',' | '-')).collect();
    let value = number(&digits)?;
    let feet = text[digits.len()..].trim_start().starts_with(['\'', 'f']);
    Some(if feet { value * 0.3048 } else { value }).filter(|metres| (0.0..=1000.0).contains(metres))
}

/// Doors and stops at nodes.
fn nodes(data: &OsmData, points: &[Point], draft: &mut MapDraft, doors: &BTreeMap<i64, BuildingId>) {
    for (node, point) in data.nodes.iter().zip(points) {
        let tags = data.node_tags(node);
        if tags.is_empty() {
            continue;
        }
        let at = [point.x, point.y];
        let door = tags.get("entrance").or_else(|| tags.get("door")).filter(|kind| *kind != "no");
        if let (Some(kind), Some(building)) = (door, doors.get(&node.id)) {
            draft.entrances.push(EntranceDraft { building: *building, at, kind: kind.to_owned(), source: node.id });
        }
        let kind = match () {
            () if tags.is("highway", "bus_stop") => StopKind::Bus,
            () if tags.is("railway", "tram_stop") => StopKind::Tram,
            () if tags.is("railway", "station|halt|subway_entrance") => StopKind::Train,
            () => continue,
        };
        draft.stops.push(StopDraft { kind, at, name: tags.get("name").map(str::to_owned), source: node.id });
    }
}

/// A door for each building without one: in the middle of the wall that is nearest to a way on which people walk.
fn guess_doors(draft: &mut MapDraft, report: &mut ImportReport) {
    let walked = |road: &&crate::RoadDraft| {
        let users = road.section.users(true) | road.section.users(false);
        users.has(Users::FOOT) && road.layer == 0
    };
    let lines: Vec<Polyline> =
        draft.roads.iter().filter(walked).filter_map(|road| Polyline::new(road.line.iter().copied())).collect();
    let index = PointIndex::new(lines.iter().enumerate().map(|(id, line)| (id as u32, line)));
    let mut has = vec![false; draft.buildings.len()];
    draft.entrances.iter().for_each(|entrance| has[entrance.building.index()] = true);
    for (number, building) in draft.buildings.iter().enumerate() {
        if has[number] || building.part || building.base > 0.0 {
            continue;
        }
        let Some(at) = door(building, &lines, &index) else { continue };
        draft.entrances.push(EntranceDraft {
            building: BuildingId::of(number),
            at,
            kind: "guessed".to_owned(),
            source: 0,
        });
        report.guess(Element::Way(building.source), Guessed::Entrance);
    }
}

fn door(building: &Building, lines: &[Polyline], index: &PointIndex) -> Option<[f64; 2]> {
    let ring = &building.outline;
    let walls = ring.iter().zip(ring.iter().cycle().skip(1));
    let middles = walls
        .filter(|(a, b)| (Point::from(**a) - Point::from(**b)).norm() > 1.5)
        .map(|(a, b)| Point::new((a[0] + b[0]) / 2.0, (a[1] + b[1]) / 2.0));
    let mut best: Option<(f64, Point)> = None;
    // An outline of thousands of walls is tried at some of them.
    for middle in middles.step_by(1 + ring.len() / 64) {
        let mut near = best.map_or(WAY, |(least, _)| least);
        index.around(&middle, near, |id| {
            let away = lines[id as usize].project(&middle).left.abs();
            if away < near {
                near = away;
                best = Some((away, middle));
            }
            near
        });
    }
    best.map(|(_, at)| [at.x, at.y])
}

impl OsmData {
    /// Lists what has tags and became nothing.
    pub(super) fn unused(&self, draft: &MapDraft, report: &mut ImportReport) {
        let roads = draft.roads.iter().map(|road| Element::Way(road.source));
        let shapes = draft.buildings.iter().map(|b| b.source).chain(draft.areas.iter().map(|a| a.source));
        let both = shapes.flat_map(|id| [Element::Way(id), Element::Relation(id)]);
        let points = draft.crossings.iter().map(|c| c.source).chain(draft.stops.iter().map(|s| s.source));
        let points = points.chain(draft.entrances.iter().map(|e| e.source)).map(Element::Node);
        let nodes = draft.junctions.iter().flat_map(|junction| junction.source.iter().map(|id| Element::Node(*id)));
        let listed = report.dropped.iter().map(|(element, _)| *element);
        let guessed = report.guessed.iter().map(|(element, _)| *element);
        let used: std::collections::BTreeSet<Element> =
            roads.chain(both).chain(points).chain(nodes).chain(listed).chain(guessed).collect();
        let tagged =
            |element: Element, tags: Tags<'_>| (!tags.is_empty() && !used.contains(&element)).then_some(element);
        let nodes = self.nodes.iter().filter_map(|node| tagged(Element::Node(node.id), self.node_tags(node)));
        let ways = self.ways.iter().filter_map(|way| tagged(Element::Way(way.id), self.way_tags(way)));
        let relations = self.relations.iter().filter_map(|r| tagged(Element::Relation(r.id), self.relation_tags(r)));
        let lost: Vec<Element> = nodes.chain(ways).chain(relations).collect();
        lost.into_iter().for_each(|element| report.drop(element, Reason::NoUse));
    }
}
