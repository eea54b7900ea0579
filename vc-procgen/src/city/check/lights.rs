//! Rules 9 to 12 and 14: junctions with lights, right of way, what can be seen, and signs.

use vc_map::{JunctionId, Lane, LaneId, Light, MapViolation, Point, Signal, StripKind, Users};

use super::super::convex::Convex;
use super::super::item::one_way;
use super::super::near::Near;
use super::super::view::{THIN, views};
use super::super::{StreetItem, TrafficSign};
use super::{CityPart, CityPlan, CityRule, Found};

/// The speed of people who cross, metres per second, and the time to begin, seconds.
const WALKING: f64 = 1.07;
const BEGIN: f64 = 7.0;
/// Lights are seen from this far, metres.
const SEEN: f64 = 60.0;

pub(super) fn check(plan: &CityPlan, found: &mut Found) {
    for wrong in plan.map.validate() {
        let at = wrong.place(&plan.map).unwrap_or(Point::origin());
        let rule = match &wrong {
            MapViolation::NoCrossing { .. } | MapViolation::Unlit { .. } => CityRule::CrossingMissing,
            MapViolation::WalkCutOff { .. } => CityRule::PavementsCutOff,
            MapViolation::CutOff { .. } | MapViolation::DeadLane { .. } | MapViolation::Gap { .. } => {
                CityRule::StreetsCutOff
            }
            MapViolation::MissingConflict { .. }
            | MapViolation::UnsafePhase { .. }
            | MapViolation::ShortClearance { .. }
            | MapViolation::NeverGreen { .. }
            | MapViolation::NeverRed { .. } => CityRule::PhasesConflict,
            MapViolation::Aside { .. } | MapViolation::Tangled { .. } | MapViolation::Overlap { .. } => {
                CityRule::StreetsCross
            }
            MapViolation::DoorAway { .. } | MapViolation::DoorWithoutWay { .. } | MapViolation::DoorInLane { .. } => {
                CityRule::EntranceOffPavement
            }
            MapViolation::CrossesNothing { .. } => CityRule::CrossingMissing,
            // Pavements in lanes, buildings on streets.
            _ => CityRule::LaneOnPavement,
        };
        found.add(rule, CityPart::City, at, 0.0);
    }
    for signal in plan.map.signals() {
        greens(plan, signal, found);
    }
    let places: Vec<Point> = plan.items.iter().map(|item| item.at).collect();
    let near = Near::of(&places);
    for (index, lane) in plan.map.lanes().iter().enumerate() {
        if lane.kind == StripKind::Driving && lane.users.has(Users::CAR) && lane.index == 0 {
            approach(plan, LaneId(index as u32), lane, &near, found);
        }
    }
    seen(plan, &near, found);
}

/// The time that people have from the begin of their green until others start.
fn greens(plan: &CityPlan, signal: &Signal, found: &mut Found) {
    let Some(junction) = plan.map.junction(signal.junction) else { return };
    for (place, crossing) in junction.crossings.iter().filter_map(|id| plan.map.crossing(*id)).enumerate() {
        let row = junction.movements.len() + place;
        let needed = crossing.line.length() / WALKING + BEGIN;
        let count = signal.phases.len();
        let light = |phase: usize| signal.phases[phase % count].lights.get(row).copied();
        let Some(start) = (0..count)
            .find(|phase| light(*phase) == Some(Light::Green) && light(phase + count - 1) != Some(Light::Green))
        else {
            continue;
        };
        // Until a movement gets green that is in their way, and did not have it with them.
        let starts = |phase: usize| {
            let lights = &signal.phases[phase % count].lights;
            (0..junction.movements.len())
                .any(|movement| lights[movement] == Light::Green && junction.conflicts.has(movement, row))
        };
        let time: f64 = (start..start + count)
            .take_while(|phase| !starts(*phase) || *phase == start)
            .map(|phase| signal.phases[phase % count].seconds)
            .sum();
        if time + 1e-6 < needed {
            found.add(CityRule::ShortGreen, CityPart::Junction(signal.junction), junction.at, time - needed);
        }
    }
}

/// The end of a lane: its stop line, its lights, its signs.
fn approach(plan: &CityPlan, id: LaneId, lane: &Lane, near: &Near, found: &mut Found) {
    let map = &plan.map;
    let Some(junction) = lane.next.first().and_then(|id| map.movement(*id)).map(|movement| movement.junction) else {
        return;
    };
    let (part, end) = (CityPart::Lane(id), lane.line.end());
    let crossings =
        map.junction(junction).into_iter().flat_map(|junction| &junction.crossings).filter_map(|id| map.crossing(*id));
    for crossing in crossings.filter(|crossing| crossing.roads.contains(&lane.road)) {
        let edge = lane.line.project(&nalgebra::center(&crossing.line.start(), &crossing.line.end())).station
            - crossing.width / 2.0;
        if lane.stop_line.is_some_and(|line| line > edge.max(0.0) + 0.3) {
            found.add(CityRule::StopLineBeyond, part, end, edge);
        }
    }
    let beside = |class: &str, at: &Point, sign: Option<TrafficSign>| {
        let fits = |item: &StreetItem| item.class == class && item.sign == sign;
        near.around(at, 16.0).map(|index| &plan.items[index]).find(|item| fits(item) && own(plan, item, lane)).copied()
    };
    if map.junction(junction).is_some_and(|junction| junction.signal.is_some()) {
        let line = lane.line.at(lane.stop_line.unwrap_or(lane.line.length()));
        match beside("traffic_light", &line, None) {
            Some(head) => hidden(plan, (id, lane), &head, near, found),
            None => found.add(CityRule::SignalMissing, part, line, 0.0),
        }
    }
    if lower(plan, junction, lane) && beside("traffic_sign", &end, Some(TrafficSign::GiveWay)).is_none() {
        found.add(CityRule::SignMissing, part, end, 0.0);
    }
    if map.road(lane.road).is_some_and(|road| one_way(map, road)) {
        let closed = beside("traffic_sign", &end, Some(TrafficSign::NoEntry)).is_some();
        if !closed || beside("traffic_sign", &lane.line.start(), Some(TrafficSign::OneWay)).is_none() {
            found.add(CityRule::SignMissing, part, end, 0.0);
        }
    }
}

/// Whether a thing stands on a pavement of a lane's road.
fn own(plan: &CityPlan, item: &StreetItem, lane: &Lane) -> bool {
    item.pavement.and_then(|id| plan.map.lane(id)).is_some_and(|pavement| pavement.road == lane.road)
}

/// Whether a lane ends at a street of a higher class, without lights.
fn lower(plan: &CityPlan, junction: JunctionId, lane: &Lane) -> bool {
    let rank = |road| plan.map.road(road).map_or(0, |road| road.draft.class.rank());
    let Some(junction) = plan.map.junction(junction) else { return false };
    junction.signal.is_none() && junction.arms.iter().any(|arm| rank(arm.road) > rank(lane.road))
}

/// Things between the lights and a driver who comes.
fn hidden(plan: &CityPlan, (id, lane): (LaneId, &Lane), head: &StreetItem, near: &Near, found: &mut Found) {
    let line = lane.stop_line.unwrap_or(lane.line.length());
    for away in [0.0, SEEN / 2.0, SEEN].map(|away| line - away).into_iter().filter(|station| *station > 0.0) {
        let eye = lane.line.at(away);
        let (along, far) = ((head.at - eye).normalize(), (head.at - eye).norm());
        let hides = |item: &StreetItem| {
            let gap = item.at - eye;
            let ahead = gap.dot(&along);
            item.at != head.at
                && (0.5..far - 0.5).contains(&ahead)
                && along.perp(&gap).abs() < item.radius
                && item.radius >= THIN
                && item.height > 2.0
        };
        if let Some(item) = near.around(&eye, far).map(|index| &plan.items[index]).find(|item| hides(item)) {
            found.add(CityRule::SignalHidden, CityPart::Lane(id), item.at, (item.at - eye).norm());
        }
    }
}

/// Views along streets from where one gives way: free of cars, houses and things.
fn seen(plan: &CityPlan, near: &Near, found: &mut Found) {
    let cars: Vec<Point> = plan.cars.iter().map(|car| car.at).collect();
    let cars = Near::of(&cars);
    let houses: Vec<(&Convex, Point)> = plan
        .buildings
        .iter()
        .flat_map(|b| &b.wings)
        .filter(|w| w.from == 0)
        .map(|w| (&w.plan, w.plan.middle()))
        .collect();
    let middles = Near::of(houses.iter().map(|(_, middle)| middle));
    for view in views(&plan.map) {
        let mut hides: f64 = view.near(&cars, 6.0).map(|car| view.ground.shared(&plan.cars[car].outline())).sum();
        hides += view.near(&middles, 40.0).map(|house| view.ground.shared(houses[house].0)).sum::<f64>();
        hides += view
            .near(near, 0.0)
            .map(|index| &plan.items[index])
            .filter(|item| view.is_hidden_by(item))
            .map(|item| item.radius)
            .sum::<f64>();
        if hides > 1e-6 {
            found.add(CityRule::ViewHidden, CityPart::City, view.eye, hides);
        }
    }
}
