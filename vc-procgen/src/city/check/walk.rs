//! Rules 8, 17 and 19: pavements wide enough and lit, bus stops and the station within reach.

use vc_map::{LaneId, Point, StopKind, StripKind};

use super::super::item::lamp_spacing;
use super::super::near::Near;
use super::{CityPart, CityPlan, CityRule, Found};

const CLEAR: f64 = 1.5;
const WIDE: f64 = 1.8;
/// The share of pavements that is wide.
const SHARE: f64 = 0.95;
/// Lamps are this many of their distances away at most.
const LIT: f64 = 0.6;
const STOPS: f64 = 500.0;
/// The station's door is at most this far from where people walk, metres.
const STATION: f64 = 12.0;
/// Pavements are looked at this often, metres.
const STEP: f64 = 3.0;

pub(super) fn check(plan: &CityPlan, found: &mut Found) {
    widths(plan, found);
    lamps(plan, found);
    stops(plan, found);
    if let Some(railway) = &plan.railway
        && plan.map.walk_near(&railway.door, STATION).is_none()
    {
        found.add(CityRule::StationCutOff, CityPart::City, railway.door, STATION);
    }
}

fn widths(plan: &CityPlan, found: &mut Found) {
    let mut length = [0.0, 0.0];
    for lane in plan.map.lanes().iter().filter(|lane| lane.kind == StripKind::Pavement) {
        length[0] += lane.line.length();
        length[1] += if lane.width >= WIDE { lane.line.length() } else { 0.0 };
    }
    for (index, item) in plan.items.iter().enumerate() {
        let Some(lane) = item.pavement.and_then(|id| plan.map.lane(id)) else { continue };
        let aside = lane.line.project(&item.at).left;
        // Beside it, on the wider side.
        let clear = (lane.width / 2.0 + aside.abs()) - item.radius;
        if clear < WIDE {
            length[1] -= 2.0 * item.radius;
        }
        if clear < CLEAR {
            found.add(CityRule::NarrowPavement, CityPart::Item(index), item.at, clear);
        }
    }
    let share = length[1] / length[0].max(1.0);
    if share < SHARE {
        found.add(CityRule::NarrowPavements, CityPart::City, Point::origin(), share);
    }
}

fn lamps(plan: &CityPlan, found: &mut Found) {
    let lamps: Vec<Point> = plan.items.iter().filter(|item| item.class == "street_lamp").map(|item| item.at).collect();
    let near = Near::of(&lamps);
    let most = LIT * lamp_spacing();
    for (index, lane) in plan.map.lanes().iter().enumerate().filter(|(_, lane)| lane.kind == StripKind::Pavement) {
        for side in [-0.5, 0.5] {
            let edge = lane.line.offset(side * lane.width);
            for step in 0..=(edge.length() / STEP) as usize {
                let at = edge.at(STEP * step as f64);
                if near.around(&at, most).next().is_none() {
                    let away = near.around(&at, 200.0).map(|lamp| (lamps[lamp] - at).norm()).fold(200.0, f64::min);
                    found.add(CityRule::PavementDark, CityPart::Lane(LaneId(index as u32)), at, away);
                }
            }
        }
    }
}

/// Along a main street there is a stop on some side every so often.
fn stops(plan: &CityPlan, found: &mut Found) {
    let stops: Vec<Point> =
        plan.map.stops().iter().filter(|stop| stop.kind == StopKind::Bus).map(|stop| stop.at).collect();
    for (index, street) in plan.streets.iter().enumerate().filter(|(_, street)| street.class.is_main()) {
        let Some(line) = vc_map::Polyline::new(street.line.iter().copied()) else { continue };
        let on = stops.iter().map(|stop| line.project(stop)).filter(|near| near.left.abs() < street.class.edge() + 1.0);
        let mut stations: Vec<f64> = on.map(|near| near.station).collect();
        stations.sort_by(f64::total_cmp);
        stations.push(line.length());
        let mut last = 0.0;
        for station in stations {
            if station - last > STOPS {
                found.add(CityRule::BusStopsApart, CityPart::Street(index), line.at(last), station - last);
            }
            last = station;
        }
    }
}
