//! The cross-section of a street from its tags.

use super::data::Tags;
use super::{Element, Guessed, ImportReport};
use crate::{CrossSection, DrivingSide, RoadClass, Strip, StripKind, Turns, Users};

/// The width of a lane for bicycles, metres.
const CYCLE: f64 = 1.8;

/// The tags of a street, and what is known of it already.
pub(super) struct LaneTags<'a> {
    pub(super) tags: Tags<'a>,
    pub(super) class: RoadClass,
    pub(super) slip: bool,
    pub(super) one_way: bool,
    pub(super) users: Users,
    pub(super) limit: f64,
    pub(super) side: DrivingSide,
    pub(super) reversed: bool,
}

impl LaneTags<'_> {
    /// The value of a key for a direction: `lanes:forward`, or on one-way streets `lanes`.
    fn of(&self, key: &str, forward: bool) -> Option<&str> {
        let suffix = if forward != self.reversed { "forward" } else { "backward" };
        self.tags.get(&format!("{key}:{suffix}")).or_else(|| self.tags.get(key).filter(|_| self.one_way))
    }

    fn number(&self, key: &str) -> Option<u32> {
        let text = self.tags.get(key)?.split(';').next()?.trim();
        text.parse::<f64>().ok().filter(|n| (0.5..=20.0).contains(n)).map(|n| n.ceil() as u32)
    }

    /// The lanes of one direction. As SUMO's map of types has it, main roads have two where nothing is mapped.
    fn count(&self, forward: bool) -> (u32, bool) {
        if self.one_way && !forward {
            return (0, false);
        }
        let own = if forward != self.reversed { "lanes:forward" } else { "lanes:backward" };
        if let Some(count) = self.number(own) {
            return (count, false);
        }
        let marked = self.of("turn:lanes", forward).map(|text| text.split('|').count() as u32).filter(|n| *n <= 20);
        let usual = if self.class <= RoadClass::Primary && !self.slip { 2 } else { 1 };
        match self.number("lanes") {
            Some(all) if self.one_way => (all, false),
            Some(all) => {
                let other = if forward != self.reversed { "lanes:backward" } else { "lanes:forward" };
                let left = self.number(other).map(|other| all.saturating_sub(other));
                (left.unwrap_or(if forward { all.div_ceil(2) } else { all / 2 }).max(1), false)
            }
            None => (marked.unwrap_or(usual), marked.is_none()),
        }
    }

    /// The width of a lane, metres (B1 of the note on places).
    fn width(&self, lanes: u32) -> f64 {
        let given = self.tags.get("width").and_then(|text| text.trim_end_matches('m').trim().parse::<f64>().ok());
        let usual = match self.class {
            RoadClass::Motorway | RoadClass::Trunk => 3.5,
            RoadClass::Primary | RoadClass::Secondary => 3.25,
            RoadClass::Tertiary => 3.0,
            RoadClass::Service | RoadClass::Living | RoadClass::Track => 2.5,
            _ if self.one_way && lanes == 1 => 3.5,
            _ => 2.75,
        };
        given.map(|width| width / f64::from(lanes.max(1))).filter(|width| (2.0..=4.5).contains(width)).unwrap_or(usual)
    }
}

/// The lanes of both directions, without pavements.
pub(super) fn section(lane: &LaneTags<'_>, element: Element, report: &mut ImportReport) -> CrossSection {
    let (forward, guessed) = lane.count(true);
    let (backward, also) = lane.count(false);
    if guessed || also {
        report.guess(element, Guessed::Lanes(forward + backward));
    }
    let width = lane.width(forward + backward);
    let mut section = CrossSection {
        forward: driving(lane, true, forward, width, element, report),
        backward: driving(lane, false, backward, width, element, report),
        median: 0.0,
    };
    for forward in [true, false] {
        let strips = if forward { &mut section.forward } else { &mut section.backward };
        beside(lane, forward, strips);
    }
    section
}

/// The lanes for vehicles of one direction, from the divider outward.
fn driving(
    lane: &LaneTags<'_>,
    forward: bool,
    count: u32,
    width: f64,
    element: Element,
    report: &mut ImportReport,
) -> Vec<Strip> {
    let users = lane.users.without(Users::FOOT);
    let mut strips = vec![Strip::new(StripKind::Driving, width, users, lane.limit); count as usize];
    if let Some(marks) = lane.of("turn:lanes", forward) {
        let marks: Vec<Turns> = marks.split('|').map(turns).collect();
        if marks.len() == strips.len() {
            ordered(lane.side, &mut strips, marks, |strip, turns| strip.turns = turns);
        } else if count > 0 {
            report.guess(element, Guessed::TurnLanes);
        }
    }
    for (key, user) in [("bus:lanes", Users::BUS), ("psv:lanes", Users::BUS), ("bicycle:lanes", Users::BICYCLE)] {
        listed(lane, key, forward, &mut strips, |strip, value| {
            if value == "designated" {
                strip.users = strip.users.without(Users::CAR) | user;
            }
        });
    }
    for key in ["vehicle:lanes", "motor_vehicle:lanes", "access:lanes"] {
        listed(lane, key, forward, &mut strips, |strip, value| {
            if value == "no" {
                strip.users = strip.users.without(Users::CAR);
            }
        });
    }
    let counted = ["lanes:bus", "lanes:psv"].iter().any(|key| lane.of(key, forward).is_some_and(|n| n != "0"));
    let own = side_key(lane, "busway", forward).is_some_and(|value| value == "lane");
    let is_bus = |strip: &Strip| !strip.users.has(Users::CAR);
    if (counted || own) && strips.len() > 1 && !strips.iter().any(is_bus) {
        let last = strips.len() - 1;
        strips[last].users = strips[last].users.without(Users::CAR);
    }
    strips
}

/// Applies a list of values, from the left to the right, to lanes from the divider outward.
fn ordered<T>(side: DrivingSide, strips: &mut [Strip], values: Vec<T>, mut apply: impl FnMut(&mut Strip, T)) {
    let count = strips.len();
    for (index, value) in values.into_iter().enumerate().take(count) {
        let at = if side == DrivingSide::Right { index } else { count - 1 - index };
        apply(&mut strips[at], value);
    }
}

fn listed(lane: &LaneTags<'_>, key: &str, forward: bool, strips: &mut [Strip], apply: impl FnMut(&mut Strip, &str)) {
    if let Some(text) = lane.of(key, forward) {
        let values: Vec<&str> = text.split('|').map(str::trim).collect();
        if values.len() == strips.len() {
            ordered(lane.side, strips, values, apply);
        }
    }
}

/// The directions of a lane, as in `left;through`.
fn turns(text: &str) -> Turns {
    text.split(';').map(str::trim).fold(Turns::NONE, |all, word| {
        all | match word {
            "through" => Turns::THROUGH,
            "left" | "slight_left" | "sharp_left" => Turns::LEFT,
            "right" | "slight_right" | "sharp_right" => Turns::RIGHT,
            "reverse" => Turns::BACK,
            _ => Turns::NONE,
        }
    })
}

/// The value of a key for the outer edge of one direction: `cycleway:right`, `cycleway:both` or `cycleway`.
fn side_key<'a>(lane: &LaneTags<'a>, key: &str, forward: bool) -> Option<&'a str> {
    let right = ((lane.side == DrivingSide::Right) == forward) != lane.reversed;
    let own = format!("{key}:{}", if right { "right" } else { "left" });
    let both = format!("{key}:both");
    lane.tags
        .get(&own)
        .or_else(|| lane.tags.get(&both))
        .or_else(|| lane.tags.get(key).filter(|_| forward || !lane.one_way))
}

/// Lanes for bicycles and for parking beside those for vehicles.
fn beside(lane: &LaneTags<'_>, forward: bool, strips: &mut Vec<Strip>) {
    let against = lane.one_way && !forward;
    let cycle = side_key(lane, "cycleway", forward).unwrap_or_default();
    let opposite = against && lane.tags.is("cycleway", "opposite|opposite_lane|opposite_track");
    let contra = against && lane.tags.is("oneway:bicycle", "no") && matches!(cycle, "lane" | "track");
    if (matches!(cycle, "lane" | "track") && !against) || opposite || contra {
        strips.push(Strip::new(StripKind::Cycle, CYCLE, Users::BICYCLE, lane.limit.min(7.0)));
    }
    let orientation = |value: &str| match value {
        "perpendicular" => Some(5.0),
        "diagonal" => Some(4.2),
        "parallel" | "lane" | "street_side" | "half_on_kerb" | "marked" => Some(2.1),
        _ => None,
    };
    let old = side_key(lane, "parking:lane", forward).and_then(orientation);
    let new = side_key(lane, "parking", forward).filter(|value| !matches!(*value, "no" | "separate"));
    let way = if ((lane.side == DrivingSide::Right) == forward) != lane.reversed { "right" } else { "left" };
    let stands =
        lane.tags.get(&format!("parking:{way}:orientation")).or_else(|| lane.tags.get("parking:both:orientation"));
    let width = old.or_else(|| new.and_then(|value| stands.and_then(orientation).or_else(|| orientation(value))));
    if let Some(width) = width {
        strips.push(Strip::new(StripKind::Parking, width, Users::NONE, 2.0));
    }
}

/// Adds pavements; true if they were guessed.
pub(super) fn pavements(lane: &LaneTags<'_>, section: &mut CrossSection) -> bool {
    let urban = matches!(
        lane.class,
        RoadClass::Primary | RoadClass::Secondary | RoadClass::Tertiary | RoadClass::Minor | RoadClass::Residential
    );
    let width = match lane.class {
        RoadClass::Trunk | RoadClass::Primary | RoadClass::Secondary => 4.0,
        RoadClass::Tertiary => 3.0,
        _ => 2.4,
    };
    let tagged =
        ["sidewalk", "sidewalk:both", "sidewalk:left", "sidewalk:right"].iter().any(|key| lane.tags.get(key).is_some());
    let has = |forward: bool| {
        let right = ((lane.side == DrivingSide::Right) == forward) != lane.reversed;
        let own = if right { "right" } else { "left" };
        let all = lane.tags.get("sidewalk").is_some_and(|value| value == "both" || value == "yes" || value == own);
        let key = if right { "sidewalk:right" } else { "sidewalk:left" };
        all || lane.tags.is(key, "yes|lane") || lane.tags.is("sidewalk:both", "yes")
    };
    let guessed = !tagged && urban && !lane.slip && lane.users.has(Users::FOOT);
    for forward in [true, false] {
        if has(forward) || guessed {
            let strips = if forward { &mut section.forward } else { &mut section.backward };
            strips.push(Strip::pavement(width));
        }
    }
    let separate = lane.tags.is("sidewalk", "separate") || lane.tags.is("sidewalk:both", "separate");
    let walked = section.strips().any(|(_, strip)| strip.kind == StripKind::Pavement);
    if !walked && !separate && lane.users.has(Users::FOOT) && lane.class >= RoadClass::Tertiary {
        for strip in
            section.forward.iter_mut().chain(&mut section.backward).filter(|strip| strip.kind == StripKind::Driving)
        {
            strip.users = strip.users | Users::FOOT;
        }
    }
    guessed
}
