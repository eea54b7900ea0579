//! The lanes for vehicles of a street from its tags.

use super::beside;
use super::tags::Tags;
use super::units::metres;
use super::{Element, Guessed, ImportReport};
use crate::{CrossSection, DrivingSide, RoadClass, Strip, StripKind, Turns, Users};

/// The width of a lane for bicycles, metres.
pub(super) const CYCLE: f64 = 1.8;
/// The width of each half of a lane for both directions, metres.
const HALF: f64 = 2.0;
/// The most lanes of one direction.
const MOST: usize = 20;

/// The tags of a street, and what is known of it already.
pub(super) struct LaneTags<'a> {
    pub(super) tags: Tags<'a>,
    pub(super) element: Element,
    pub(super) class: RoadClass,
    pub(super) slip: bool,
    pub(super) one_way: bool,
    pub(super) users: Users,
    /// Along the road and against it, metres per second.
    pub(super) limits: [f64; 2],
    pub(super) side: DrivingSide,
    pub(super) reversed: bool,
}

/// The number of lanes.
struct Count {
    /// Along the road and against it.
    sides: [u32; 2],
    /// For both, in the middle.
    middle: u32,
    guessed: bool,
    /// Whether one lane is for both directions.
    shared: bool,
}

impl<'a> LaneTags<'a> {
    /// The word for a direction in tags, which go by the order of the way's nodes.
    fn word(&self, forward: bool) -> &'static str {
        if forward != self.reversed { "forward" } else { "backward" }
    }

    /// The hand, by the order of the way's nodes, on which the outer edge of a direction lies.
    pub(super) fn hand(&self, forward: bool) -> &'static str {
        if ((self.side == DrivingSide::Right) == forward) != self.reversed { "right" } else { "left" }
    }

    pub(super) fn limit(&self, forward: bool) -> f64 {
        self.limits[usize::from(!forward)]
    }

    /// The value of a key for a direction: `lanes:forward`, or on one-way streets `lanes`.
    fn of<T>(&self, key: &str, forward: bool, understand: impl Fn(&'a str) -> Option<T>) -> Option<T> {
        let own = self.tags.read(&format!("{key}:{}", self.word(forward)), &understand);
        let all = || self.tags.read(key, &understand).filter(|_| self.one_way && forward);
        own.or_else(all)
    }

    fn number(&self, key: &str) -> Option<u32> {
        let count = |text: &str| text.split(';').next()?.trim().parse::<f64>().ok();
        self.tags.read(key, |text| count(text).filter(|n| (0.5..=20.0).contains(n)).map(|n| n.ceil() as u32))
    }

    /// The lanes of both directions. As SUMO's map of types has it, main roads have two where nothing is mapped.
    fn count(&self) -> Count {
        let own = [true, false].map(|forward| self.number(&format!("lanes:{}", self.word(forward))));
        let (all, middle) = (self.number("lanes"), self.number("lanes:both_ways").unwrap_or(0));
        let usual = if self.class <= RoadClass::Primary && !self.slip { 2 } else { 1 };
        let marked = [true, false].map(|forward| {
            let count = |text: &str| Some(text.split('|').count()).filter(|n| *n <= MOST).map(|n| n as u32);
            self.of("turn:lanes", forward, count)
        });
        if self.one_way {
            let against = own[1].unwrap_or_else(|| u32::from(self.buses_against()));
            let along = own[0].or(all.map(|all| all.saturating_sub(against).max(1))).or(marked[0]);
            return Count {
                sides: [along.unwrap_or(usual), against],
                middle: 0,
                guessed: along.is_none(),
                shared: false,
            };
        }
        let left = all.map(|all| all.saturating_sub(middle));
        let half = left.map(|left| [left.div_ceil(2), left / 2]);
        let side = |index: usize| {
            let rest = left.zip(own[1 - index]).map(|(left, other)| left.saturating_sub(other).max(1));
            own[index].or(rest).or(half.map(|half| half[index].max(1))).or(marked[index].filter(|_| all.is_none()))
        };
        let sides = [side(0), side(1)];
        Count {
            sides: sides.map(|count| count.unwrap_or(usual)),
            middle,
            guessed: sides.contains(&None),
            shared: all == Some(1) && own == [None, None],
        }
    }

    /// Whether buses go against a one-way street.
    fn buses_against(&self) -> bool {
        let free = ["oneway:bus", "oneway:psv"].iter().any(|key| self.tags.is(key, "no"));
        self.tags.is("busway", "opposite_lane") || free
    }

    /// The width of each of some lanes, metres. Where it is not mapped, it is that of streets in towns: 2.75 m suffice at 30 km/h,
    /// 3.5 m are usual from 70 km/h on.
    fn width(&self, count: &Count, report: &mut ImportReport) -> f64 {
        let lanes = count.sides[0] + count.sides[1] + count.middle;
        let usual = match self.class {
            _ if count.shared => HALF,
            RoadClass::Motorway | RoadClass::Trunk => 3.5,
            RoadClass::Primary | RoadClass::Secondary => 3.25,
            RoadClass::Tertiary => 3.0,
            RoadClass::Service | RoadClass::Living | RoadClass::Track => 2.5,
            _ if self.one_way && lanes == 1 => 3.5,
            _ => 2.75,
        };
        let each = |text| metres(text).map(|width| width / f64::from(lanes.max(1)));
        let least = if count.shared { 1.25 } else { 2.0 };
        let given = self.tags.read("width", |text| each(text).filter(|width| (least..=4.5).contains(width)));
        given.unwrap_or_else(|| {
            report.guess(self.element, Guessed::Width(usual));
            usual
        })
    }
}

/// The lanes of both directions, without pavements.
pub(super) fn section(lane: &LaneTags<'_>, report: &mut ImportReport) -> CrossSection {
    let count = lane.count();
    let guesses = [
        (count.guessed, Guessed::Lanes(count.sides[0] + count.sides[1])),
        (count.shared, Guessed::SharedLane),
        (count.middle > 0, Guessed::MiddleLane),
    ];
    guesses.into_iter().filter(|(made, _)| *made).for_each(|(_, guessed)| report.guess(lane.element, guessed));
    let width = lane.width(&count, report);
    let mut section = CrossSection {
        forward: driving(lane, true, count.sides[0], width, report),
        backward: driving(lane, false, count.sides[1], width, report),
        median: f64::from(count.middle) * width,
    };
    beside::beside(lane, &mut section, report);
    section
}

/// The lanes for vehicles of one direction, from the divider outward.
fn driving(lane: &LaneTags<'_>, forward: bool, count: u32, width: f64, report: &mut ImportReport) -> Vec<Strip> {
    let against = lane.one_way && !forward;
    let users = if against { Users::BUS } else { lane.users.without(Users::FOOT) };
    let mut strips = vec![Strip::new(StripKind::Driving, width, users, lane.limit(forward)); count as usize];
    cycle_lanes(lane, forward, &mut strips);
    let marked = listed(lane, "turn:lanes", forward, &mut strips, |strip, text| strip.turns = turns(text));
    if !marked && count > 0 && lane.of("turn:lanes", forward, |_| Some(())).is_some() {
        report.guess(lane.element, Guessed::TurnLanes);
    }
    let closed = [
        ("access:lanes", Users::TRAFFIC),
        ("vehicle:lanes", Users::TRAFFIC),
        ("motor_vehicle:lanes", Users::CAR | Users::BUS),
        ("motorcar:lanes", Users::CAR),
    ];
    for (key, users) in closed {
        listed(lane, key, forward, &mut strips, |strip, value| {
            if value == "no" {
                strip.users = strip.users.without(users);
            }
        });
    }
    // A lane for bicycles is one for buses as well only if a list of theirs says so, which comes later.
    let opened = [
        ("bicycle:lanes", Users::BICYCLE, Users::CAR | Users::BUS),
        ("bus:lanes", Users::BUS, Users::CAR),
        ("psv:lanes", Users::BUS, Users::CAR),
    ];
    for (key, user, others) in opened {
        listed(lane, key, forward, &mut strips, |strip, value| match value {
            "yes" | "permissive" => strip.users = strip.users | user,
            "designated" => strip.users = strip.users.without(others) | user,
            "no" => strip.users = strip.users.without(user),
            _ => {}
        });
    }
    bus_lane(lane, forward, &mut strips);
    strips
}

/// The last lane is one for buses where their number is given, not their place.
fn bus_lane(lane: &LaneTags<'_>, forward: bool, strips: &mut [Strip]) {
    let some = |text: &str| Some(text != "0");
    let counted = ["lanes:bus", "lanes:psv"].iter().any(|key| lane.of(key, forward, some) == Some(true));
    let own = beside::value(lane, "busway", forward, |value| (value == "lane").then_some(())).is_some();
    let driven = strips.iter().filter(|strip| strip.kind == StripKind::Driving).count();
    let has = strips.iter().any(|strip| strip.users.has(Users::BUS) && !strip.users.has(Users::CAR));
    if let Some(last) = strips.iter_mut().rfind(|strip| strip.kind == StripKind::Driving)
        && (counted || own)
        && driven > 1
        && !has
    {
        last.users = last.users.without(Users::CAR);
    }
}

/// Lanes for bicycles between those for others: `lanes` does not count them, and lists of lanes have them.
fn cycle_lanes(lane: &LaneTags<'_>, forward: bool, strips: &mut Vec<Strip>) {
    let count = strips.len();
    let marks = lane.of("bicycle:lanes", forward, |text| {
        let mut marks: Vec<bool> = text.split('|').map(|value| value.trim() == "designated").collect();
        let own = marks.iter().filter(|own| **own).count();
        if lane.side == DrivingSide::Left {
            marks.reverse();
        }
        (own > 0 && marks.len() == count + own && marks.len() <= MOST).then_some(marks)
    });
    for (index, _) in marks.unwrap_or_default().into_iter().enumerate().filter(|(_, own)| *own) {
        strips.insert(index, beside::cycle(lane, forward));
    }
}

/// Applies a list of values, which go from the left to the right, to lanes, which go from the divider outward: to all of them, or
/// to those for motor vehicles. False if the list is of neither number.
fn listed(
    lane: &LaneTags<'_>,
    key: &str,
    forward: bool,
    strips: &mut [Strip],
    mut apply: impl FnMut(&mut Strip, &str),
) -> bool {
    let mut values = lane.of(key, forward, |text| {
        let values: Vec<&str> = text.split('|').map(str::trim).collect();
        let motor = strips.iter().filter(|strip| strip.kind == StripKind::Driving).count();
        (values.len() == strips.len() || values.len() == motor).then_some(values)
    });
    let Some(values) = &mut values else { return false };
    if lane.side == DrivingSide::Left {
        values.reverse();
    }
    let all = values.len() == strips.len();
    let meant = strips.iter_mut().filter(|strip| all || strip.kind == StripKind::Driving);
    meant.zip(values).for_each(|(strip, value)| apply(strip, value));
    true
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
