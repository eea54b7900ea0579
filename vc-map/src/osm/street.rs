//! Ways of OpenStreetMap as roads: class, users, limits, levels.

use super::lanes::{self, LaneTags};
use super::tags::Tags;
use super::units::{metres, speed};
use super::{Element, Guessed, ImportReport, Reason};
use crate::{CrossSection, DrivingSide, RoadClass, Strip, StripKind, Structure, Users};

/// A way as a road.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Street {
    pub(super) class: RoadClass,
    pub(super) section: CrossSection,
    pub(super) name: Option<String>,
    pub(super) layer: i8,
    pub(super) structure: Structure,
    pub(super) roundabout: bool,
    pub(super) slip: bool,
    pub(super) private: bool,
    /// Whether its nodes are in the order against its direction.
    pub(super) reversed: bool,
    /// The guessed pavements along and against it: the part of it that footways accompany if they are those.
    pub(super) guessed_pavements: [Option<f64>; 2],
}

/// The class of a way and whether it is a slip road, or why it is none; `None` without a reason for ways that are no roads at
/// all.
fn class(tags: Tags<'_>) -> Result<(RoadClass, bool), Option<Reason>> {
    if let Some(found) = tags.read("highway", |value| Some(highway(value))) {
        return found.map_err(Some);
    }
    if tags.is("railway", "construction|proposed|abandoned|disused|razed|dismantled") {
        return Err(Some(Reason::NotThere));
    }
    let rail = tags.read("railway", |value| match value {
        "tram" => Some(RoadClass::Tram),
        "rail" | "light_rail" | "subway" | "narrow_gauge" | "monorail" | "preserved" | "funicular" => {
            Some(RoadClass::Rail)
        }
        _ => None,
    });
    rail.map(|class| (class, false)).ok_or(None)
}

fn highway(value: &str) -> Result<(RoadClass, bool), Reason> {
    let class = match value.strip_suffix("_link").unwrap_or(value) {
        "motorway" => RoadClass::Motorway,
        "trunk" => RoadClass::Trunk,
        "primary" => RoadClass::Primary,
        "secondary" => RoadClass::Secondary,
        "tertiary" => RoadClass::Tertiary,
        "unclassified" | "road" => RoadClass::Minor,
        "residential" => RoadClass::Residential,
        "living_street" => RoadClass::Living,
        "service" | "busway" | "bus_guideway" => RoadClass::Service,
        "track" => RoadClass::Track,
        "pedestrian" => RoadClass::Pedestrian,
        "cycleway" => RoadClass::Cycleway,
        "footway" | "path" | "bridleway" => RoadClass::Path,
        "steps" => RoadClass::Steps,
        "construction" | "proposed" | "planned" | "abandoned" | "razed" | "disused" => return Err(Reason::NotThere),
        "corridor" | "elevator" => return Err(Reason::Indoors),
        _ => return Err(Reason::NoUse),
    };
    Ok((class, value.ends_with("_link")))
}

/// Whether a value of a key of access lets people in.
pub(super) fn access(value: &str) -> Option<bool> {
    match value {
        "no"
        | "agricultural"
        | "forestry"
        | "agricultural;forestry"
        | "emergency"
        | "military"
        | "use_sidepath"
        | "dismount" => Some(false),
        "yes" | "designated" | "permissive" | "destination" | "customers" | "private" | "delivery" | "permit"
        | "official" | "public" | "residents" | "discouraged" | "optional_sidepath" => Some(true),
        _ => None,
    }
}

/// Whether somebody may use a way: by a key of their own, which opens and closes, or else by the most particular of the keys
/// for more users, which close only. A path that is open to all is not one for bicycles.
fn may(tags: Tags<'_>, own: &[&str], general: &[&str], usual: bool) -> bool {
    let said = |keys: &[&str]| keys.iter().find_map(|key| tags.read(key, access));
    said(own).unwrap_or_else(|| usual && said(general).unwrap_or(true))
}

/// Whether people on foot are kept off a way, and off the pavements that are mapped along it: by a key of their own, or where
/// there is none by that for everybody.
fn is_closed_on_foot(tags: Tags<'_>) -> bool {
    tags.is("foot", "private|no") || (!tags.has("foot") && tags.is("access", "private|no"))
}

/// Everybody who may use a way.
fn users(tags: Tags<'_>, class: RoadClass) -> Users {
    use RoadClass::{Cycleway, Motorway, Path, Pedestrian, Steps, Trunk};
    if class.is_rail() {
        return if class == RoadClass::Tram { Users::TRAM } else { Users::TRAIN };
    }
    let busway = tags.is("highway", "busway|bus_guideway");
    let street = class.is_street();
    let slow = !tags.is("motorroad", "yes") && class != Motorway;
    let rides = slow && (!matches!(class, Pedestrian | Steps | Path) || tags.is("highway", "path"));
    let walks = slow && !matches!(class, Trunk | Cycleway);
    let rules: [(Users, &[&str], &[&str], bool); 4] = [
        (Users::CAR, &["motorcar", "motor_vehicle"], &["vehicle", "access"], street && !busway),
        (Users::BUS, &["bus", "psv"], &["motor_vehicle", "vehicle", "access"], street),
        (Users::BICYCLE, &["bicycle"], &["vehicle", "access"], rides),
        (Users::FOOT, &["foot"], &["access"], walks),
    ];
    let open = rules.iter().filter(|(_, own, general, usual)| may(tags, own, general, *usual));
    let mut all = open.fold(Users::NONE, |all, (user, ..)| all | *user);
    if is_closed_on_foot(tags) {
        all = all.without(Users::FOOT);
    }
    if !street {
        all = all.without(Users::CAR | Users::BUS);
    }
    if tags.is("railway", "tram") { all | Users::TRAM } else { all }
}

/// The usual limit of a class in a town, metres per second.
fn usual_limit(class: RoadClass, slip: bool) -> f64 {
    let kilometres = match (class, slip) {
        (RoadClass::Motorway, false) => 100.0,
        (RoadClass::Motorway, true) => 60.0,
        (RoadClass::Trunk, false) => 70.0,
        (
            RoadClass::Trunk
            | RoadClass::Primary
            | RoadClass::Secondary
            | RoadClass::Tertiary
            | RoadClass::Minor
            | RoadClass::Tram,
            _,
        ) => 50.0,
        (RoadClass::Residential, _) => 30.0,
        (RoadClass::Living, _) => 7.0,
        (RoadClass::Rail, _) => 80.0,
        _ => 15.0,
    };
    kilometres / 3.6
}

/// Whether a way has one direction: along its nodes or against them.
fn one_way(tags: Tags<'_>, roundabout: bool) -> (bool, bool) {
    let said = tags.read("oneway", |value| match value {
        "yes" | "true" | "1" => Some((true, false)),
        "-1" | "reverse" => Some((true, true)),
        "no" | "false" | "0" => Some((false, false)),
        _ => None,
    });
    said.unwrap_or_else(|| (roundabout || tags.is("highway", "motorway|motorway_link"), false))
}

/// A way as a road, or why it is none; `None` without a reason for ways that are no roads at all.
pub(super) fn street(
    id: i64,
    tags: Tags<'_>,
    side: DrivingSide,
    report: &mut ImportReport,
) -> Result<Street, Option<Reason>> {
    let (class, slip) = class(tags)?;
    if tags.is("area", "yes") && class.is_street() {
        // A square: places have it.
        return Err(None);
    }
    let users = users(tags, class);
    if users.is_empty() {
        return Err(Some(Reason::NobodyMayUse));
    }
    let element = Element::Way(id);
    let roundabout = tags.is("junction", "roundabout|circular");
    let (one_way, reversed) = one_way(tags, roundabout);
    let (structure, layer) = level(tags, element, report);
    let mut street = Street {
        class,
        section: CrossSection::default(),
        name: tags.text("name").map(str::to_owned),
        layer,
        structure,
        roundabout,
        slip,
        private: tags.is("access", "private|customers|delivery|permit")
            || tags.is("motor_vehicle", "private|destination"),
        reversed,
        guessed_pavements: [None; 2],
    };
    let limits = limits(tags, class, slip, reversed, element, report);
    if class.is_street() {
        let lane = LaneTags { tags, element, class, slip, one_way, users, limits, side, reversed };
        street.section = lanes::section(&lane, report);
        street.guessed_pavements = super::beside::pavements(&lane, &mut street.section);
        if roundabout {
            island(&mut street, element, report);
        }
        if is_closed_on_foot(tags) {
            let strips = street.section.forward.iter_mut().chain(&mut street.section.backward);
            strips.for_each(|strip| strip.users = strip.users.without(Users::FOOT));
        }
    } else {
        street.section = path(tags, class, users, limits[0], element, report);
    }
    Ok(street)
}

/// Nobody walks around the island in the middle of a ring, whose inner side is that against its direction.
fn island(street: &mut Street, element: Element, report: &mut ImportReport) {
    let guessed = street.guessed_pavements[1].take().is_some();
    let inner = &mut street.section.backward;
    let count = inner.len();
    inner.retain(|strip| strip.kind != StripKind::Pavement);
    if inner.len() < count && !guessed {
        report.drop(element, Reason::IslandPavement);
    }
}

/// The speed limits along the road and against it, metres per second.
fn limits(
    tags: Tags<'_>,
    class: RoadClass,
    slip: bool,
    reversed: bool,
    element: Element,
    report: &mut ImportReport,
) -> [f64; 2] {
    let all = tags.read("maxspeed", speed);
    let mut own = ["maxspeed:forward", "maxspeed:backward"].map(|key| tags.read(key, speed).or(all));
    if reversed {
        own.reverse();
    }
    let usual = usual_limit(class, slip);
    if class.is_street() && own == [None, None] {
        report.guess(element, Guessed::Limit(usual));
    }
    own.map(|limit| limit.unwrap_or(usual))
}

/// The section of a path or track.
fn path(
    tags: Tags<'_>,
    class: RoadClass,
    users: Users,
    limit: f64,
    element: Element,
    report: &mut ImportReport,
) -> CrossSection {
    let given = tags.read("width", |text| metres(text).filter(|width| (0.5..=50.0).contains(width)));
    let width = given.unwrap_or_else(|| {
        let usual = match class {
            RoadClass::Pedestrian => 5.0,
            RoadClass::Tram | RoadClass::Rail => 3.0,
            _ => 2.0,
        };
        report.guess(element, Guessed::Width(usual));
        usual
    });
    let kind = if class.is_rail() { StripKind::Track } else { StripKind::Path };
    let both = users.has(Users::BICYCLE) && !tags.is("oneway", "yes|-1") && !tags.is("oneway:bicycle", "yes");
    let strip = |width| vec![Strip::new(kind, width, users, limit)];
    if both {
        return CrossSection { forward: strip(width / 2.0), backward: strip(width / 2.0), median: 0.0 };
    }
    CrossSection { forward: strip(width), backward: Vec::new(), median: 0.0 }
}

/// Whether a way is a bridge or a tunnel, and its level.
fn level(tags: Tags<'_>, element: Element, report: &mut ImportReport) -> (Structure, i8) {
    let structure = match () {
        () if tags.yes("bridge") => Structure::Bridge,
        () if tags.yes("tunnel") || tags.yes("covered") => Structure::Tunnel,
        () => Structure::Ground,
    };
    let given = tags.read("layer", |text| text.parse::<i8>().ok());
    let layer = given.unwrap_or_else(|| {
        let passage = tags.is("tunnel", "building_passage") || tags.yes("covered");
        let usual = match structure {
            Structure::Bridge => 1,
            Structure::Tunnel if !passage => -1,
            _ => 0,
        };
        if structure != Structure::Ground {
            report.guess(element, Guessed::Layer(usual));
        }
        usual
    });
    (structure, layer)
}
