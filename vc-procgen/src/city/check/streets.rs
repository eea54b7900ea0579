//! Rule 1: the graph of streets.

use std::collections::BTreeMap;

use vc_graph::portable::Portable;
use vc_map::{Control, JunctionId, Point, RoadId};

use super::super::near::Near;
use super::{CityPart, CityPlan, CityRule, Found};

const DEAD_END: f64 = 60.0;
const ARM: f64 = 12.0;
const ANGLE: f64 = 40.0;

pub(super) fn check(plan: &CityPlan, found: &mut Found) {
    crossings(plan, found);
    components(plan, found);
    for (index, junction) in plan.map.junctions().iter().enumerate() {
        let id = JunctionId(index as u32);
        let headings: Vec<f64> = junction.arms.iter().map(|arm| arm.away.y.angle_to(arm.away.x).to_degrees()).collect();
        for (place, heading) in headings.iter().enumerate().filter(|_| headings.len() > 1) {
            let next = headings[(place + 1) % headings.len()];
            let between = (next - heading).rem_euclid(360.0);
            if between < ANGLE {
                found.add(CityRule::SharpAngle, CityPart::Junction(id), junction.at, between);
            }
        }
    }
    for (index, road) in plan.map.roads().iter().enumerate().filter(|(_, road)| road.draft.class.is_street()) {
        let id = RoadId(index as u32);
        let free = road.line.length() - road.cuts[0] - road.cuts[1];
        if free < ARM {
            found.add(CityRule::ShortArm, CityPart::Road(id), road.line.at(road.line.length() / 2.0), free);
        }
        for end in [road.draft.from, road.draft.to] {
            let Some(junction) = plan.map.junction(end) else { continue };
            let open = junction.arms.len() < 2 && junction.draft.control != Control::Edge;
            if open && road.line.length() > DEAD_END {
                found.add(CityRule::DeadEnd, CityPart::Road(id), junction.at, road.line.length());
            }
        }
    }
}

/// Straight pieces of roads that cross within both.
fn crossings(plan: &CityPlan, found: &mut Found) {
    let mut pieces: Vec<(RoadId, Point, Point)> = Vec::new();
    for (index, road) in plan.map.roads().iter().enumerate() {
        let points = road.line.points();
        pieces.extend(points.windows(2).map(|ends| (RoadId(index as u32), ends[0], ends[1])));
    }
    // Long pieces are found by points along them.
    let mut near = Near::default();
    for (number, (_, a, b)) in pieces.iter().enumerate() {
        let steps = ((b - a).norm() / 20.0).ceil() as usize;
        (0..=steps).for_each(|step| near.add(number, a + (b - a) * (step as f64 / steps.max(1) as f64)));
    }
    for (number, (road, a, b)) in pieces.iter().enumerate() {
        let steps = ((b - a).norm() / 20.0).ceil().max(1.0) as usize;
        let mut others: Vec<usize> = (0..=steps)
            .flat_map(|step| near.around(&(a + (b - a) * (step as f64 / steps as f64)), 24.0))
            .filter(|other| *other > number)
            .collect();
        others.sort_unstable();
        others.dedup();
        for (_, c, d) in others.into_iter().filter_map(|other| pieces.get(other)) {
            let side = |p: &Point, q: &Point, r: &Point| (q - p).perp(&(r - p)) / (q - p).norm();
            let (one, two, three, four) = (side(a, b, c), side(a, b, d), side(c, d, a), side(c, d, b));
            let depth = one.abs().min(two.abs()).min(three.abs()).min(four.abs());
            if one * two < 0.0 && three * four < 0.0 && depth > 1e-3 {
                found.add(CityRule::StreetsCross, CityPart::Road(*road), *c, depth);
            }
        }
    }
}

/// Parts of the streets that are not joined.
fn components(plan: &CityPlan, found: &mut Found) {
    let mut next: BTreeMap<JunctionId, Vec<JunctionId>> = BTreeMap::new();
    for road in plan.map.roads().iter().filter(|road| road.draft.class.is_street()) {
        next.entry(road.draft.from).or_default().push(road.draft.to);
        next.entry(road.draft.to).or_default().push(road.draft.from);
    }
    let Some(first) = next.keys().next().copied() else { return };
    let mut open = vec![first];
    let mut reached = std::collections::BTreeSet::from([first]);
    while let Some(at) = open.pop() {
        open.extend(next[&at].iter().copied().filter(|to| reached.insert(*to)));
    }
    if reached.len() < next.len() {
        let lost = next.keys().find(|id| !reached.contains(id)).copied().unwrap_or(first);
        let at = plan.map.junction(lost).map_or(Point::origin(), |junction| junction.at);
        found.add(CityRule::StreetsCutOff, CityPart::Junction(lost), at, (next.len() - reached.len()) as f64);
    }
}
