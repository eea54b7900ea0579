//! Rule 2: carriageways, pavements, parcels and water cover the land, each once; and rule 18, the water's edge.

use vc_map::{LaneId, Point, StripKind, Users};

use super::super::convex::{Beyond, Convex, area};
use super::super::near::Near;
use super::{CityPart, CityPlan, CityRule, Found};

/// Areas that differ by less are equal, square metres.
const SAME: f64 = 0.05;
/// Lengths that differ by less are equal, metres.
const TOUCH: f64 = 0.03;

pub(super) fn check(plan: &CityPlan, found: &mut Found) {
    faces(plan, found);
    parcels(plan, found);
    lanes(plan, found);
    water(plan, found);
}

fn convex(ring: &[Point]) -> Convex {
    Convex::new(ring.to_vec(), vec![Beyond::Inside; ring.len()])
}

/// The faces of the streets cover the city, and kerbs lie within faces, land within kerbs.
fn faces(plan: &CityPlan, found: &mut Found) {
    let all = area(&plan.outline);
    let covered: f64 = plan.blocks.iter().map(|block| block.face.area()).sum();
    // Corners are rounded to a tenth of a millimetre.
    if (all - covered).abs() > SAME + 2e-6 * all {
        found.add(CityRule::LandUncovered, CityPart::City, Point::origin(), all - covered);
    }
    for (index, block) in plan.blocks.iter().enumerate() {
        let kerb = convex(&block.kerb);
        let outside = block.kerb.iter().find(|point| !block.face.contains(point, 0.0));
        let beyond = block.land.corners().iter().find(|point| !kerb.contains(point, 0.0));
        if let Some(at) = outside.or(beyond) {
            found.add(CityRule::LandUncovered, CityPart::Block(index), *at, area(&block.kerb) - block.land.area());
        }
    }
}

/// Parcels cover the land of their block, and none overlap.
fn parcels(plan: &CityPlan, found: &mut Found) {
    let mut of = vec![Vec::new(); plan.blocks.len()];
    for (index, parcel) in plan.parcels.iter().enumerate() {
        if let Some(list) = of.get_mut(parcel.block) {
            list.push(index);
        }
    }
    for (index, (block, own)) in plan.blocks.iter().zip(&of).enumerate() {
        let covered: f64 = own.iter().map(|parcel| plan.parcels[*parcel].land.area()).sum();
        if (covered - block.land.area()).abs() > SAME {
            found.add(
                CityRule::LandUncovered,
                CityPart::Block(index),
                block.land.middle(),
                block.land.area() - covered,
            );
        }
        for (place, one) in own.iter().enumerate() {
            for other in &own[place + 1..] {
                let [a, b] = [one, other].map(|parcel| &plan.parcels[*parcel].land);
                let shared = if apart(a, b) { 0.0 } else { a.shared(b) };
                if shared > SAME {
                    found.add(CityRule::ParcelsOverlap, CityPart::Parcel(*one), a.middle(), shared);
                }
            }
        }
    }
}

/// Whether the boxes around two polygons do not meet.
fn apart(a: &Convex, b: &Convex) -> bool {
    [nalgebra::Vector2::x(), nalgebra::Vector2::y()].iter().any(|axis| {
        let ([low, high], [from, to]) = (a.extent(axis), b.extent(axis));
        high < from || to < low
    })
}

/// Lanes of vehicles stay off the ground within kerbs, pavements on it.
fn lanes(plan: &CityPlan, found: &mut Found) {
    let kerbs: Vec<Convex> = plan.blocks.iter().map(|block| convex(&block.kerb)).collect();
    let middles: Vec<Point> = kerbs.iter().map(Convex::middle).collect();
    let reach = kerbs
        .iter()
        .zip(&middles)
        .flat_map(|(kerb, middle)| kerb.corners().iter().map(move |p| (p - middle).norm()))
        .fold(0.0, f64::max);
    let near = Near::of(&middles);
    for (index, lane) in plan.map.lanes().iter().enumerate() {
        let walked = lane.kind == StripKind::Pavement;
        if lane.users.any(Users::RAILS) {
            continue;
        }
        let edges = [-0.5, 0.0, 0.5].map(|side| lane.line.offset(side * (lane.width - 2.0 * TOUCH)));
        for edge in &edges {
            // Near junctions pavements are cut where their streets meet, and the corners of kerbs are rounded.
            let inner = if walked { 24.0 } else { 0.5 };
            let steps = ((edge.length() - 2.0 * inner) / 4.0).floor();
            for step in 0..=steps.max(-1.0) as i64 {
                let station = inner + 4.0 * step as f64;
                let at = edge.at(station);
                if walked && edge.direction(station - 14.0).dot(&edge.direction(station + 14.0)) < 0.999 {
                    continue;
                }
                let block = near.around(&at, reach).find(|block| kerbs[*block].contains(&at, 0.0));
                let land = block.is_some_and(|block| plan.blocks[block].land.contains(&at, TOUCH));
                let lane = CityPart::Lane(LaneId(index as u32));
                if !walked && block.is_some() {
                    found.add(CityRule::LaneOnPavement, lane, at, edge.length());
                } else if walked && (land || (block.is_none() && outside(&plan.outline, &at) < TOUCH)) {
                    found.add(CityRule::PavementOffGround, lane, at, station);
                }
            }
        }
    }
}

/// How far a point lies outside a convex ring, metres; negative within.
fn outside(ring: &[Point], at: &Point) -> f64 {
    let ends = ring.iter().zip(ring.iter().cycle().skip(1));
    ends.map(|(a, b)| -(b - a).normalize().perp(&(at - a))).fold(f64::NEG_INFINITY, f64::max)
}

fn water(plan: &CityPlan, found: &mut Found) {
    let Some(shore) = &plan.shore else { return };
    let rings: Vec<Convex> =
        std::iter::once(&shore.water).chain(&shore.sand).chain([&shore.promenade]).map(|ring| convex(ring)).collect();
    for (index, block) in plan.blocks.iter().enumerate() {
        let shared: f64 =
            rings.iter().filter(|ring| !apart(ring, &block.face)).map(|ring| ring.shared(&block.face)).sum();
        if shared > SAME {
            found.add(CityRule::WaterOnLand, CityPart::Block(index), block.face.middle(), shared);
        }
    }
    let [from, to] = shore.railing;
    let edge = (to - from).norm();
    let side = shore
        .promenade
        .iter()
        .map(|corner| (to - from).normalize().perp(&(corner - from)).abs())
        .fold(f64::INFINITY, f64::min);
    let reached = shore.promenade.iter().any(|corner| plan.map.pavement_near(corner, 10.0).is_some());
    if side > TOUCH || edge < 1.0 || shore.steps.is_empty() || !reached {
        found.add(CityRule::WaterOpen, CityPart::City, from, side);
    }
}
