//! Junctions: their arms in order, how far these are cut back, and outlines.

use std::collections::BTreeSet;
use std::f64::consts::TAU;

use nalgebra::Vector2;
use vc_graph::portable::Portable;

use super::crossing_rule::begins_at_crossing;
use super::{MOST_ARMS, roundabout};
use crate::parts::{Arm, Junction, Road};
use crate::polyline::normal;
use crate::signal::ConflictTable;
use crate::{Control, DrivingSide, JunctionId, MapDraft, MapError, Point, Polyline, RoadId, StripKind};

/// The direction of an arm is that of its point at this distance, metres.
const LOOK: f64 = 12.0;
/// No arm is cut back by more, metres.
const FARTHEST_CUT: f64 = 30.0;
/// Every arm is cut back by at least this, metres; where people cross, a crossing has to fit between two arms.
const LEAST: f64 = 0.5;
const CROSSED: f64 = 2.5;
/// Roads are nearly parallel if the sine of the angle between them is less, for 17 degrees.
const PARALLEL: f64 = 0.3;
/// The part of a road that a junction can take, and the least that is left of it, metres.
const LARGEST_PART: f64 = 0.4;
const PATHS_PART: f64 = 0.98;
const LEFT: f64 = 0.01;

pub(super) fn junctions(draft: &MapDraft, lines: &[Polyline]) -> Result<Vec<Junction>, MapError> {
    let mut junctions: Vec<Junction> = draft
        .junctions
        .iter()
        .map(|junction| Junction {
            at: junction.at.into(),
            draft: junction.clone(),
            arms: Vec::new(),
            movements: Vec::new(),
            conflicts: ConflictTable::default(),
            crossings: Vec::new(),
            signal: None,
            outline: Vec::new(),
        })
        .collect();
    for (index, (road, line)) in draft.roads.iter().zip(lines).enumerate() {
        for (start, id) in [(true, road.from), (false, road.to)] {
            junctions[id.index()].arms.push(Arm { road: RoadId::of(index), start, away: away(line, start) });
        }
    }
    for (index, junction) in junctions.iter_mut().enumerate() {
        if junction.arms.len() > MOST_ARMS {
            let (part, count) = (JunctionId::of(index).to_string(), junction.arms.len());
            return Err(MapError::TooMany { part, what: "roads", count, most: MOST_ARMS });
        }
        let middle = junction.at;
        junction.arms.sort_by_cached_key(|arm| (around(&lines[arm.road.index()], arm, &middle), arm.road));
    }
    Ok(junctions)
}

/// The direction in which a road leaves its junction: that to a point a little along it.
fn away(line: &Polyline, start: bool) -> Vector2<f64> {
    let look = LOOK.min(line.length());
    let [begin, point] = [0.0, look].map(|away| line.at(if start { away } else { line.length() - away }));
    let along = if start { line.direction(0.0) } else { -line.direction(line.length()) };
    (point - begin).try_normalize(0.1).unwrap_or(along)
}

/// The place of an arm around the middle of its junction: roads that begin beside each other and leave in one direction
/// have an order, too. The bits of an angle that is not negative are in its order.
fn around(line: &Polyline, arm: &Arm, middle: &Point) -> u64 {
    let look = LOOK.min(line.length());
    let point = line.at(if arm.start { look } else { line.length() - look });
    let seen = (point - middle).try_normalize(0.1).unwrap_or(arm.away);
    (angle(&seen) + TAU).to_bits()
}

fn angle(v: &Vector2<f64>) -> f64 {
    v.y.angle_to(v.x)
}

/// How far the carriageway of a road reaches to each side of its line, which is its middle, metres.
fn reach(draft: &MapDraft, arm: &Arm) -> f64 {
    draft.roads[arm.road.index()].section.surface() / 2.0
}

/// The width of the pavement on the left or the right of an arm, seen away from the junction, metres.
fn pavement(draft: &MapDraft, arm: &Arm, left: bool) -> f64 {
    let forward = ((draft.side == DrivingSide::Right) == arm.start) != left;
    let strips = draft.roads[arm.road.index()].section.side(forward).iter();
    strips.filter(|strip| strip.kind == StripKind::Pavement).map(|strip| strip.width).sum()
}

/// The lengths that junctions take from the start and end of each road.
pub(super) fn cuts(draft: &MapDraft, lines: &[Polyline], junctions: &[Junction]) -> Vec<[f64; 2]> {
    let mut cuts = vec![[0.0; 2]; draft.roads.len()];
    let crossed: BTreeSet<JunctionId> = draft.crossings.iter().map(|crossing| crossing.at).collect();
    let given: BTreeSet<(JunctionId, RoadId)> =
        draft.crossings.iter().map(|crossing| (crossing.at, crossing.road)).collect();
    for (id, junction) in junctions.iter().enumerate().filter(|(_, junction)| junction.arms.len() > 1) {
        let street = |arm: &&Arm| draft.roads[arm.road.index()].class.is_street();
        let walked = junction.arms.iter().any(|arm| !street(&arm)) || crossed.contains(&JunctionId::of(id));
        let streets = junction.arms.iter().filter(street).count();
        let begin = |arm: &Arm| {
            let line = &lines[arm.road.index()];
            if arm.start { line.start() } else { line.end() }
        };
        // Pavements of a street lead up to a crossing that is mapped where it begins.
        let begins = |arm: &Arm| {
            let own = given.contains(&(JunctionId::of(id), arm.road));
            let paths =
                junction.arms.iter().any(|other| !street(&other) && (begin(other) - begin(arm)).norm() <= CROSSED);
            own && !paths && begins_at_crossing(&begin(arm), &junction.at, streets)
        };
        for (index, arm) in junction.arms.iter().enumerate() {
            let round = junction.draft.control == Control::MiniRoundabout;
            let least = match street(&arm) {
                true if round => roundabout::CUT,
                true if walked && !begins(arm) => CROSSED,
                _ => LEAST,
            };
            let cut = cut(draft, lines, junction, index).clamp(least, FARTHEST_CUT);
            cuts[arm.road.index()][usize::from(!arm.start)] = cut;
        }
    }
    let fitted =
        |(index, cuts): (usize, [f64; 2])| fit(cuts, lines[index].length(), draft.roads[index].class.is_street());
    cuts.into_iter().enumerate().map(fitted).collect()
}

/// The cuts of a road that leave something of it. A path may end close to a kerb, so that a crossing leads from kerb to kerb.
fn fit(cuts: [f64; 2], length: f64, street: bool) -> [f64; 2] {
    if street {
        let most = (length * LARGEST_PART).min((length - LEFT) / 2.0).max(0.0);
        return cuts.map(|cut| cut.min(most));
    }
    let most = (length * PATHS_PART).min(length - LEFT).max(0.0);
    let [from, to] = cuts;
    if from + to <= most {
        return cuts;
    }
    // The end at the wider street comes first.
    if from >= to { [from.min(most), most - from.min(most)] } else { [most - to.min(most), to.min(most)] }
}

/// How far from its begin an arm meets none of the others any more: where its edge meets theirs.
fn cut(draft: &MapDraft, lines: &[Polyline], junction: &Junction, index: usize) -> f64 {
    let (arms, arm) = (&junction.arms, &junction.arms[index]);
    let street = |arm: &Arm| draft.roads[arm.road.index()].class.is_street();
    let begin = |arm: &Arm| {
        let line = &lines[arm.road.index()];
        if arm.start { line.start() } else { line.end() }
    };
    // Whether a street begins where the arm does.
    let own = arms.iter().any(|other| street(other) && (begin(other) - begin(arm)).norm() <= LEAST);
    let corner = if arms.iter().filter(|arm| street(arm)).count() > 2 && street(arm) { 1.5 } else { 0.0 };
    let meets = |other: &Arm| {
        // Paths from the nodes of a junction end at the kerbs of the streets there.
        let elsewhere = (begin(other) - begin(arm)).norm() > LEAST;
        if elsewhere && !street(arm) && (!street(other) || own) {
            return 0.0;
        }
        let sine = arm.away.perp(&other.away);
        let rail = draft.roads[other.road.index()].class.is_rail();
        let paved = pavement(draft, arm, sine > 0.0) > 0.0;
        // A pavement ends before rails that it meets, and not where they lie in its street.
        let stops = street(arm) && rail && paved && sine.abs() >= PARALLEL;
        if !street(other) && street(arm) && !stops {
            return 0.0;
        }
        // Roads that go on straight, or nearly lie on each other, do not meet at a corner.
        if sine.abs() < PARALLEL {
            let apart = (begin(other) - begin(arm)).norm() > reach(draft, arm) + reach(draft, other);
            return if arm.away.dot(&other.away) > 0.0 && !apart { FARTHEST_CUT / 2.0 } else { 0.0 };
        }
        // The edges that face each other; at an acute angle a pavement has to end before the other carriageway, too.
        let left = sine.signum();
        let beside = if arm.away.dot(&other.away) > 0.0 { pavement(draft, arm, left > 0.0) } else { 0.0 };
        let mine = begin(arm) + normal(arm.away) * (left * (reach(draft, arm) + beside));
        let theirs = begin(other) - normal(other.away) * (left * reach(draft, other));
        (theirs - mine).perp(&other.away) / sine + corner
    };
    let others = arms.iter().enumerate().filter(|(other, _)| *other != index).map(|(_, other)| other);
    others.map(meets).fold(0.0, f64::max)
}

/// Outlines: the corners of the cut ends, counter-clockwise.
pub(super) fn outlines(junctions: &mut [Junction], roads: &[Road]) {
    for junction in junctions {
        let corners = junction.arms.iter().flat_map(|arm| {
            let road = &roads[arm.road.index()];
            let [left, right] = edges(road, arm.start);
            [right, left]
        });
        let ring: Vec<Point> = corners.collect();
        if ring.len() >= 4 {
            junction.outline = ring;
        }
    }
}

/// The left and right corner of the cut end of a road, seen away from the junction.
fn edges(road: &Road, start: bool) -> [Point; 2] {
    let station = if start { road.cuts[0] } else { road.line.length() - road.cuts[1] };
    let at = road.line.at(station);
    let along = road.line.direction(station) * if start { 1.0 } else { -1.0 };
    let aside = normal(along) * (road.draft.section.surface() / 2.0);
    [at + aside, at - aside]
}
