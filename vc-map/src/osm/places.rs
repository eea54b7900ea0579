//! Buildings with their doors, areas and stops.

use std::collections::BTreeMap;

use super::rings::Surface;
use super::tags::{Source, Tags};
use super::units::{metres, number};
use super::{Element, Guessed, ImportReport, Reason};
use crate::{Area, AreaKind, Building, BuildingId, EntranceDraft, MapDraft, Point, StopDraft, StopKind};

/// The height of a storey where nothing is mapped, metres.
const STOREY: f64 = 3.1;
/// Multipolygons have at most so many points for each that the ways of the file have: a way is part of some areas, not of all.
const SHARED: usize = 4;

pub(super) fn places(source: &Source<'_>, draft: &mut MapDraft, report: &mut ImportReport) {
    let mut places = Places { source, draft, report, doors: BTreeMap::new(), buildings: Vec::new() };
    places.relations();
    places.ways();
    places.nodes();
    places.guess_doors();
}

pub(super) struct Places<'a> {
    source: &'a Source<'a>,
    pub(super) draft: &'a mut MapDraft,
    pub(super) report: &'a mut ImportReport,
    /// The buildings on whose outlines nodes lie.
    doors: BTreeMap<i64, BuildingId>,
    /// The element that each building was made from.
    pub(super) buildings: Vec<Element>,
}

/// The use that a map has for an area.
#[derive(Clone, Copy)]
enum Place {
    Building,
    Area(AreaKind),
}

impl Places<'_> {
    fn relations(&mut self) {
        let source = self.source;
        let mut room = SHARED * source.ways.iter().map(|way| source.refs(way).len()).sum::<usize>();
        for relation in &source.relations {
            let (tags, element) = (source.relation_tags(relation), Element::Relation(relation.id));
            let Some(place) = place(tags).filter(|_| tags.is("type", "multipolygon|building")) else { continue };
            if is_underground(tags) {
                self.report.drop(element, Reason::Underground);
                continue;
            }
            let found = source.multipolygon(relation);
            let none = found.areas.is_empty();
            let reason = |reason: &Reason| if none { *reason } else { in_part(*reason) };
            found.lacks.iter().for_each(|lack| self.report.drop(element, reason(lack)));
            if none {
                self.report.drop(element, found.lacks.first().copied().unwrap_or(Reason::CutOff));
                continue;
            }
            let size = found.areas.iter().map(Surface::size).sum();
            let Some(left) = room.checked_sub(size) else {
                self.report.drop(element, Reason::NamedTooOften);
                continue;
            };
            room = left;
            found.ways.iter().for_each(|way| source.keep(Element::Way(*way)));
            found.areas.into_iter().for_each(|area| self.add(element, place, tags, area));
        }
    }

    fn ways(&mut self) {
        for way in &self.source.ways {
            let (tags, element) = (self.source.way_tags(way), Element::Way(way.id));
            let Some(place) = place(tags) else { continue };
            match self.source.ring(way) {
                Ok(_) if is_underground(tags) => self.report.drop(element, Reason::Underground),
                Ok(area) => self.add(element, place, tags, area),
                // A street can have the tags of an area as well.
                Err(_) if self.source.is_kept(element) => {}
                Err(reason) => self.report.drop(element, reason),
            }
        }
    }

    fn add(&mut self, element: Element, place: Place, tags: Tags<'_>, area: Surface) {
        self.source.keep(element);
        let plain = |ring: &Vec<Point>| ring.iter().map(|p| [p.x, p.y]).collect::<Vec<_>>();
        let (outline, holes) = (plain(&area.outline), area.holes.iter().map(plain).collect());
        match place {
            Place::Building => {
                let id = BuildingId::of(self.draft.buildings.len());
                let building = building(element, tags, outline, holes, self.report);
                if !building.part {
                    area.nodes.iter().for_each(|node| _ = self.doors.entry(*node).or_insert(id));
                }
                self.draft.buildings.push(building);
                self.buildings.push(element);
            }
            Place::Area(kind) => {
                let name = tags.text("name").map(str::to_owned);
                self.draft.areas.push(Area { kind, outline, holes, name, source: element.id() });
            }
        }
    }
}

/// Whether a building or area lies below the ground.
fn is_underground(tags: Tags<'_>) -> bool {
    let below = tags.read("layer", number).is_some_and(|layer| layer < 0.0);
    tags.is("location", "underground") || tags.is("parking", "underground") || below
}

/// The reason for which an element is there in part only.
fn in_part(reason: Reason) -> Reason {
    match reason {
        Reason::CutOff | Reason::TooFar => Reason::Shortened,
        Reason::NoShape => Reason::OpenRing,
        other => other,
    }
}

/// Whether something is a building, or an area of some kind.
fn place(tags: Tags<'_>) -> Option<Place> {
    if tags.yes("building") || tags.yes("building:part") {
        return Some(Place::Building);
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
        () if tags.yes("area:highway") => return None,
        () if tags.is("landuse", "residential|commercial|retail|industrial|construction") => AreaKind::Lot,
        () => return None,
    };
    Some(Place::Area(kind))
}

/// The storeys of a building and the height of its top, metres: each follows from the other, or both are guessed.
fn storeys(element: Element, tags: Tags<'_>, report: &mut ImportReport) -> (u32, f64) {
    let levels = tags.read("building:levels", number).map(|n| n.clamp(0.0, 200.0).round() as u32);
    let height = tags.read("height", metres).or_else(|| tags.read("building:height", metres));
    let storeys = levels.or_else(|| height.map(|height| ((height / STOREY).round() as u32).max(1)));
    let storeys = storeys.unwrap_or_else(|| {
        let usual = if tags.is("building", "garage|garages|shed|roof|kiosk|hut|carport") { 1 } else { 3 };
        report.guess(element, Guessed::Storeys(usual));
        usual
    });
    let height = height.unwrap_or_else(|| {
        let roof = tags.read("roof:levels", number).unwrap_or(0.0).clamp(0.0, 20.0);
        let usual = (f64::from(storeys) + roof).max(1.0) * STOREY;
        report.guess(element, Guessed::Height(usual));
        usual
    });
    (storeys, height)
}

fn building(
    element: Element,
    tags: Tags<'_>,
    outline: Vec<[f64; 2]>,
    courts: Vec<Vec<[f64; 2]>>,
    report: &mut ImportReport,
) -> Building {
    let (storeys, height) = storeys(element, tags, report);
    let least = tags.read("min_height", metres);
    let below = tags.read("building:min_level", number).map(|level| level * STOREY);
    let base = least.or(below).unwrap_or(0.0).clamp(0.0, 900.0);
    let kind = tags.text("building").or_else(|| tags.text("building:part")).unwrap_or("yes").to_owned();
    let street = tags.text("addr:street").unwrap_or_default();
    let address = tags.text("addr:housenumber").map(|number| format!("{street} {number}").trim().to_owned());
    Building {
        outline,
        courts,
        height: height.max(base + 0.1),
        base,
        storeys,
        kind,
        name: tags.text("name").map(str::to_owned),
        address,
        part: !tags.has("building"),
        source: element.id(),
    }
}

impl Places<'_> {
    /// Doors and stops at nodes.
    fn nodes(&mut self) {
        for (position, node) in self.source.nodes.iter().enumerate() {
            let tags = self.source.node_tags(node);
            if tags.is_empty() || !self.source.is_near(position) {
                continue;
            }
            let at = self.source.points[position].into();
            let building = self.doors.get(&node.id).copied();
            let kind = |key| tags.text(key).filter(|kind| *kind != "no");
            if let Some((building, kind)) = building.and_then(|b| Some((b, kind("entrance").or_else(|| kind("door"))?)))
            {
                self.source.keep(Element::Node(node.id));
                self.draft.entrances.push(EntranceDraft { building, at, kind: kind.to_owned(), source: node.id });
            }
            if let Some(kind) = stop(tags) {
                self.source.keep(Element::Node(node.id));
                let name = tags.text("name").map(str::to_owned);
                self.draft.stops.push(StopDraft { kind, at, name, source: node.id });
            }
        }
    }
}

fn stop(tags: Tags<'_>) -> Option<StopKind> {
    match () {
        () if tags.is("highway", "bus_stop") => Some(StopKind::Bus),
        () if tags.is("railway", "tram_stop") => Some(StopKind::Tram),
        () if tags.is("railway", "station|halt|subway_entrance") => Some(StopKind::Train),
        () => None,
    }
}
