//! Ways of OpenStreetMap as roads: class, users, lanes, pavements.

use super::data::Tags;
use super::lanes::{self, LaneTags};
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
    /// Whether its pavements were guessed: they are taken away where footways lie beside it.
    pub(super) guessed_pavements: bool,
}

/// The class of a way and whether it is a slip road, or why it is none.
fn class(tags: Tags<'_>) -> Result<(RoadClass, bool), Option<Reason>> {
    let rail = || match tags.get("railway")? {
        "tram" => Some(RoadClass::Tram),
        "rail" | "light_rail" | "subway" | "narrow_gauge" | "monorail" | "preserved" | "funicular" => {
            Some(RoadClass::Rail)
        }
        _ => None,
    };
    let Some(highway) = tags.get("highway") else {
        let gone = tags.is("railway", "construction|proposed|abandoned|disused|razed|dismantled");
        return rail().map(|class| (class, false)).ok_or(gone.then_some(Reason::NotThere));
    };
    let class = match highway.strip_suffix("_link").unwrap_or(highway) {
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
        "construction" | "proposed" | "planned" | "abandoned" | "razed" | "disused" => {
            return Err(Some(Reason::NotThere));
        }
        "corridor" | "elevator" => return Err(Some(Reason::Indoors)),
        _ => return Err(Some(Reason::NoUse)),
    };
    Ok((class, highway.ends_with("_link")))
}

/// Whether somebody may use a way, by the most particular of some keys that it has.
fn may(tags: Tags<'_>, keys: &[&str], usual: bool) -> bool {
    match keys.iter().find_map(|key| tags.get(key)) {
        None => usual,
        Some("no" | "agricultural" | "forestry" | "emergency" | "military" | "use_sidepath") => false,
        Some("dismount") => usual,
        Some(_) => true,
    }
}

/// Everybody who may use a way.
fn users(tags: Tags<'_>, class: RoadClass) -> Users {
    use RoadClass::{Cycleway, Motorway, Path, Pedestrian, Steps, Trunk};
    if class.is_rail() {
        return if class == RoadClass::Tram { Users::TRAM } else { Users::TRAIN };
    }
    let busway = tags.is("highway", "busway|bus_guideway");
    let street = class.is_street();
    let path = tags.is("highway", "path");
    let rules: [(Users, &[&str], bool); 4] = [
        (Users::CAR, &["motorcar", "motor_vehicle", "vehicle", "access"], street && !busway),
        (Users::BUS, &["bus", "psv", "motor_vehicle", "vehicle", "access"], street),
        (
            Users::BICYCLE,
            &["bicycle", "vehicle", "access"],
            !matches!(class, Motorway | Pedestrian | Steps | Path) || path,
        ),
        (Users::FOOT, &["foot", "access"], !matches!(class, Motorway | Trunk | Cycleway)),
    ];
    let may = |(_, keys, usual): &&(Users, &[&str], bool)| may(tags, keys, *usual);
    let mut all = rules.iter().filter(may).fold(Users::NONE, |all, (user, ..)| all | *user);
    if !street {
        all = all.without(Users::CAR | Users::BUS);
    }
    if tags.is("railway", "tram") { all | Users::TRAM } else { all }
}

/// The speed limit, metres per second, if it is mapped.
fn limit(tags: Tags<'_>) -> Option<f64> {
    let text = tags.get("maxspeed")?;
    let number: String = text.chars().take_while(|c| c.is_ascii_digit() || *c == '.').collect();
    let speed: f64 = match (number.parse(), text) {
        (Ok(speed), _) => speed,
        (_, "walk") => 6.0,
        (_, "none") => 130.0,
        (_, zone) if zone.ends_with(":urban") => 50.0,
        (_, zone) if zone.ends_with(":rural") => 90.0,
        (_, zone) if zone.ends_with(":living_street") => 7.0,
        _ => return None,
    };
    let kilometres = if text.ends_with("mph") { speed * 1.609_344 } else { speed };
    (1.0..=400.0).contains(&kilometres).then_some(kilometres / 3.6)
}

/// The usual limit of a class in a town, metres per second (B1 of the note on places).
fn usual_limit(class: RoadClass, slip: bool) -> f64 {
    let kilometres = match class {
        RoadClass::Motorway => {
            if slip {
                60.0
            } else {
                100.0
            }
        }
        RoadClass::Trunk => {
            if slip {
                50.0
            } else {
                70.0
            }
        }
        RoadClass::Primary | RoadClass::Secondary | RoadClass::Tertiary | RoadClass::Minor | RoadClass::Tram => 50.0,
        RoadClass::Residential => 30.0,
        RoadClass::Living => 7.0,
        RoadClass::Rail => 80.0,
        _ => 15.0,
    };
    kilometres / 3.6
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
        return Err(Some(Reason::NoUse));
    }
    let users = users(tags, class);
    if users.is_empty() {
        return Err(Some(Reason::NobodyMayUse));
    }
    let element = Element::Way(id);
    let limit = limit(tags).unwrap_or_else(|| {
        let usual = usual_limit(class, slip);
        if class.is_street() {
            report.guess(element, Guessed::Limit(usual));
        }
        usual
    });
    let roundabout = tags.is("junction", "roundabout|circular");
    let mut street = Street {
        class,
        section: CrossSection::default(),
        name: tags.get("name").map(str::to_owned),
        layer: layer(tags),
        structure: structure(tags),
        roundabout,
        slip,
        private: tags.is("access", "private|customers|delivery|permit")
            || tags.is("motor_vehicle", "private|destination"),
        reversed: tags.is("oneway", "-1|reverse"),
        guessed_pavements: false,
    };
    if class.is_street() {
        let one_way = tags.is("oneway", "yes|true|1|-1|reverse")
            || (!tags.is("oneway", "no|false|0") && (roundabout || tags.is("highway", "motorway|motorway_link")));
        let lane = LaneTags { tags, class, slip, one_way, users, limit, side, reversed: street.reversed };
        street.section = lanes::section(&lane, element, report);
        street.guessed_pavements = lanes::pavements(&lane, &mut street.section);
    } else {
        street.section = path(tags, class, users, limit);
    }
    Ok(street)
}

/// The section of a path or track.
fn path(tags: Tags<'_>, class: RoadClass, users: Users, limit: f64) -> CrossSection {
    let given = tags.get("width").and_then(|text| text.trim_end_matches(" m").parse::<f64>().ok());
    let width = given.filter(|width| (0.5..=50.0).contains(width)).unwrap_or(match class {
        RoadClass::Pedestrian => 5.0,
        RoadClass::Tram | RoadClass::Rail => 3.0,
        _ => 2.0,
    });
    let kind = if class.is_rail() { StripKind::Track } else { StripKind::Path };
    let both = users.has(Users::BICYCLE) && !tags.is("oneway", "yes|-1") && !tags.is("oneway:bicycle", "yes");
    let strip = |width| vec![Strip::new(kind, width, users, limit)];
    if both {
        return CrossSection { forward: strip(width / 2.0), backward: strip(width / 2.0), median: 0.0 };
    }
    CrossSection { forward: strip(width), backward: Vec::new(), median: 0.0 }
}

fn layer(tags: Tags<'_>) -> i8 {
    let given = tags.get("layer").and_then(|text| text.parse::<i8>().ok());
    given.unwrap_or(match structure(tags) {
        Structure::Ground => 0,
        Structure::Bridge => 1,
        Structure::Tunnel => {
            if tags.is("tunnel", "building_passage") || tags.is("covered", "yes") {
                0
            } else {
                -1
            }
        }
    })
}

fn structure(tags: Tags<'_>) -> Structure {
    let yes = |key| tags.get(key).is_some_and(|value| value != "no");
    match () {
        () if yes("bridge") => Structure::Bridge,
        () if yes("tunnel") || yes("covered") => Structure::Tunnel,
        () => Structure::Ground,
    }
}
