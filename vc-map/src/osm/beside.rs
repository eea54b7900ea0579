//! Strips beside the lanes for vehicles: lanes for bicycles, parking, pavements.

use super::lanes::{CYCLE, LaneTags};
use super::{Guessed, ImportReport};
use crate::{CrossSection, RoadClass, Strip, StripKind, Users};

/// The width of a strip against a one-way street that nothing marks, metres.
const UNMARKED: f64 = 1.2;

/// The value of a key for the outer edge of one direction: `cycleway:right`, `cycleway:both` or `cycleway`, which on one-way
/// streets is that of their own direction.
pub(super) fn value<T>(
    lane: &LaneTags<'_>,
    key: &str,
    forward: bool,
    understand: impl Fn(&str) -> Option<T>,
) -> Option<T> {
    let own = lane.tags.read(&format!("{key}:{}", lane.hand(forward)), &understand);
    let both = || lane.tags.read(&format!("{key}:both"), &understand);
    let all = || if forward || !lane.one_way { lane.tags.read(key, &understand) } else { None };
    own.or_else(both).or_else(all)
}

/// A lane for bicycles.
pub(super) fn cycle(lane: &LaneTags<'_>, forward: bool) -> Strip {
    Strip::new(StripKind::Cycle, CYCLE, Users::BICYCLE, lane.limit(forward).min(7.0))
}

/// Adds lanes for bicycles and for parking.
pub(super) fn beside(lane: &LaneTags<'_>, section: &mut CrossSection, report: &mut ImportReport) {
    if lane.one_way {
        one_way_cycles(lane, section, report);
    } else {
        for forward in [true, false] {
            let strips = side(section, forward);
            if !has_cycle(strips) && value(lane, "cycleway", forward, own_lane) == Some(true) {
                strips.push(cycle(lane, forward));
            }
        }
    }
    for forward in [true, false] {
        let width = parking(lane, forward);
        side(section, forward).extend(width.map(|width| Strip::new(StripKind::Parking, width, Users::NONE, 2.0)));
    }
}

fn side(section: &mut CrossSection, forward: bool) -> &mut Vec<Strip> {
    if forward { &mut section.forward } else { &mut section.backward }
}

fn has_cycle(strips: &[Strip]) -> bool {
    strips.iter().any(|strip| strip.kind == StripKind::Cycle)
}

/// Whether bicycles have a lane of their own, by a value of `cycleway`.
fn own_lane(value: &str) -> Option<bool> {
    match value {
        "lane" | "track" => Some(true),
        "no" | "none" | "separate" | "shared" | "shared_lane" | "share_busway" => Some(false),
        _ => None,
    }
}

/// On a one-way street a lane on the inner edge goes with the traffic, unless bicycles may go both ways.
fn one_way_cycles(lane: &LaneTags<'_>, section: &mut CrossSection, report: &mut ImportReport) {
    let both_ways = lane.tags.is("oneway:bicycle", "no");
    let listed = has_cycle(&section.forward);
    if !listed && value(lane, "cycleway", true, own_lane) == Some(true) {
        section.forward.push(cycle(lane, true));
    }
    let inner = format!("cycleway:{}:oneway", lane.hand(false));
    let against = lane.tags.read(&inner, |value| match value {
        "no" | "-1" => Some(true),
        "yes" | "1" => Some(false),
        _ => None,
    });
    let has_inner = value(lane, "cycleway", false, own_lane) == Some(true);
    let mut opposite = ["cycleway".to_owned(), format!("cycleway:{}", lane.hand(false))]
        .iter()
        .any(|key| lane.tags.is(key, "opposite|opposite_lane|opposite_track"));
    if has_inner && against.unwrap_or(both_ways) {
        opposite = true;
    } else if has_inner && !listed {
        section.forward.insert(0, cycle(lane, true));
    }
    if opposite {
        section.backward.push(cycle(lane, false));
    } else if both_ways && lane.users.has(Users::BICYCLE) {
        section.backward.push(Strip { width: UNMARKED, ..cycle(lane, false) });
        report.guess(lane.element, Guessed::ContraFlow);
    }
}

/// The width of the strip in which vehicles stand, metres, if there is one.
fn parking(lane: &LaneTags<'_>, forward: bool) -> Option<f64> {
    let width = |value: &str| match value {
        "perpendicular" => Some(Some(5.0)),
        "diagonal" => Some(Some(4.2)),
        "parallel" | "lane" | "street_side" | "half_on_kerb" | "marked" => Some(Some(2.1)),
        "no" | "none" | "separate" | "no_parking" | "no_stopping" | "no_standing" | "fire_lane" => Some(None),
        _ => None,
    };
    let old = value(lane, "parking:lane", forward, width).flatten();
    let new = value(lane, "parking", forward, width).flatten();
    let stands = [lane.hand(forward), "both"]
        .iter()
        .find_map(|hand| lane.tags.read(&format!("parking:{hand}:orientation"), width).flatten());
    old.or(new.map(|usual| stands.unwrap_or(usual)))
}

/// Adds pavements, and tells for those along the street and those against it if they were guessed: by the part of the street that
/// a footway accompanies if it is that pavement. Where nothing is said that is half of it; where pavements are said to be mapped
/// apart, which not all are, any.
pub(super) fn pavements(lane: &LaneTags<'_>, section: &mut CrossSection) -> [Option<f64>; 2] {
    use RoadClass::{Minor, Primary, Residential, Secondary, Tertiary, Trunk};
    let urban = matches!(lane.class, Primary | Secondary | Tertiary | Minor | Residential);
    let width = match lane.class {
        Trunk | Primary | Secondary => 4.0,
        Tertiary => 3.0,
        _ => 2.4,
    };
    let keys = ["sidewalk", "sidewalk:both", "sidewalk:left", "sidewalk:right"];
    let tagged = keys.iter().any(|key| lane.tags.has(key));
    let separate = keys.iter().any(|key| lane.tags.is(key, "separate"));
    let usual = urban && !lane.slip && lane.users.has(Users::FOOT);
    let guessed = [true, false].map(|forward| match () {
        () if usual && !tagged => Some(0.5),
        // A one-way street may be a carriageway with another beside it.
        () if usual && is_apart(lane, forward) && (forward || !lane.one_way) => Some(0.0),
        () => None,
    });
    for (forward, guessed) in [true, false].into_iter().zip(guessed) {
        if has_pavement(lane, forward) || guessed.is_some() {
            side(section, forward).push(Strip::pavement(width));
        }
    }
    let walked = section.strips().any(|(_, strip)| strip.kind == StripKind::Pavement);
    let open = lane.class >= Tertiary || lane.tags.is("foot", "yes|designated|permissive");
    if !walked && !separate && lane.users.has(Users::FOOT) && open {
        let strips = section.forward.iter_mut().chain(&mut section.backward);
        strips
            .filter(|strip| strip.kind == StripKind::Driving && strip.users.has(Users::CAR))
            .for_each(|strip| strip.users = strip.users | Users::FOOT);
    }
    guessed
}

/// Whether the pavement at the outer edge of a direction is mapped as a way of its own.
fn is_apart(lane: &LaneTags<'_>, forward: bool) -> bool {
    let own = format!("sidewalk:{}", lane.hand(forward));
    ["sidewalk", "sidewalk:both", &own].iter().any(|key| lane.tags.is(key, "separate"))
}

/// Whether the outer edge of a direction has a pavement of the street.
fn has_pavement(lane: &LaneTags<'_>, forward: bool) -> bool {
    let hand = lane.hand(forward);
    let all = lane.tags.read("sidewalk", |value| match value {
        "both" | "yes" => Some(true),
        "left" | "right" => Some(value == hand),
        "no" | "none" | "separate" | "lane" => Some(false),
        _ => None,
    });
    let yes = |value: &str| match value {
        "yes" | "lane" => Some(true),
        "no" | "none" | "separate" => Some(false),
        _ => None,
    };
    let own = lane.tags.read(&format!("sidewalk:{hand}"), yes).or_else(|| lane.tags.read("sidewalk:both", yes));
    own.or(all).unwrap_or(false)
}
