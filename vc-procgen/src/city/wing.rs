//! Wings: the convex masses of which buildings consist.

use std::collections::{BTreeMap, BTreeSet};

use vc_map::Point;

use super::building_type::{BuildingType, Measures};
use super::convex::{Beyond, Convex, area};

/// A court is at least this wide and large, metres and square metres.
const COURT: f64 = 5.0;
const COURT_AREA: f64 = 45.0;
/// A wing is at least this wide, metres.
const NARROW: f64 = 4.0;
/// A wing along a further street is at least this long, metres: a stair and a room fit.
const SHORT: f64 = 8.0;
/// The side of a tower, metres.
const TOWER: f64 = 24.0;

/// A mass of a building between two storeys.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Wing {
    /// Its floor plan.
    pub plan: Convex,
    /// Its lowest storey.
    pub from: usize,
    /// The storey above its highest.
    pub to: usize,
}

/// The wings of a building of a type on a parcel; none where it is too small.
pub(super) fn wings(parcel: &Convex, kind: BuildingType, storeys: usize) -> Vec<Wing> {
    let Measures { setback: [front, side], depth, .. } = *kind.measures();
    let away = |beyond: Beyond| if matches!(beyond, Beyond::Street(_)) { front } else { side };
    let Some(site) = parcel.inset(None, away) else { return Vec::new() };
    let site = if side > 0.0 {
        site.relabelled(|beyond| if beyond == Beyond::Neighbour { Beyond::Court } else { beyond })
    } else {
        site
    };
    let plans = if kind.turns_corners() { along_streets(site.clone(), depth) } else { front_of(&site, depth) };
    let low = if kind == BuildingType::Tower { 2.min(storeys) } else { storeys };
    let mut wings: Vec<Wing> = plans.into_iter().map(|plan| Wing { plan, from: 0, to: low }).collect();
    if kind == BuildingType::Tower
        && let Some(plan) = tower(&site)
    {
        wings.push(Wing { plan, from: low, to: storeys });
    }
    wings
}

fn is_street(beyond: Beyond) -> bool {
    matches!(beyond, Beyond::Street(_))
}

/// Whether a polygon is wide enough in all directions.
pub(super) fn is_wide(plan: &Convex, least: f64) -> bool {
    plan.sides().all(|(a, b, _)| plan.length(&super::convex::left((b - a).normalize())) >= least)
}

/// The front of a site, along its longest street.
fn front_of(site: &Convex, depth: f64) -> Vec<Convex> {
    let Some(street) = site.longest(is_street) else { return Vec::new() };
    site.strip(street, depth, [Beyond::Court, Beyond::Inside])
        .0
        .filter(|plan| is_wide(plan, NARROW))
        .into_iter()
        .collect()
}

/// A wing along each street, the longest first, and the court behind them if there is room for one.
fn along_streets(site: Convex, depth: f64) -> Vec<Convex> {
    let mut wings = Vec::new();
    let mut rest = Some(site.clone());
    while let Some(land) = rest.take() {
        let Some(street) = land.longest(is_street) else {
            // A court that is too small is part of the house, if it can be.
            if !(is_wide(&land, COURT) && land.area() > COURT_AREA) && wings.len() == 1 {
                wings = vec![site.clone()];
            }
            break;
        };
        let (wing, behind) = land.strip(street, depth, [Beyond::Court, Beyond::Inside]);
        wings.extend(
            wing.filter(|plan| is_wide(plan, NARROW) && plan.length(&(street.1 - street.0).normalize()) >= SHORT),
        );
        rest = behind;
    }
    wings
}

/// A square in the middle of a site, as its longest side lies.
fn tower(site: &Convex) -> Option<Convex> {
    let (a, b, beyond) = site.longest(is_street)?;
    let along = (b - a).normalize();
    let across = super::convex::left(along);
    let middle = site.middle();
    let half = [-0.5, 0.5].map(|share| share * TOWER);
    let corner = |x: f64, y: f64| middle + along * x + across * y;
    let corners =
        vec![corner(half[0], half[0]), corner(half[1], half[0]), corner(half[1], half[1]), corner(half[0], half[1])];
    let open = [beyond, Beyond::Court, Beyond::Court, Beyond::Court];
    let plan = Convex::new(corners, open.to_vec());
    plan.corners().iter().all(|corner| site.contains(corner, 0.0)).then_some(plan)
}

/// The rings around some polygons that touch each other along sides: the outer ring first, then the holes.
pub(super) fn rings(plans: &[&Convex]) -> Vec<Vec<Point>> {
    type Key = (i64, i64);
    let key = |p: &Point| ((p.x * 1e3).round() as i64, (p.y * 1e3).round() as i64);
    let corners: BTreeMap<Key, Point> = plans.iter().flat_map(|plan| plan.corners()).map(|p| (key(p), *p)).collect();
    let mut edges: BTreeSet<(Key, Key)> = BTreeSet::new();
    for (a, b, _) in plans.iter().flat_map(|plan| plan.sides()) {
        let along = (b - a).normalize();
        let on = |p: &&Point| {
            along.perp(&(**p - a)).abs() < 2e-3 && along.dot(&(**p - a)) > 1e-3 && along.dot(&(b - **p)) > 1e-3
        };
        let mut between: Vec<Point> = corners.values().filter(on).copied().collect();
        between.sort_by(|p, q| along.dot(&(p - a)).total_cmp(&along.dot(&(q - a))));
        let line: Vec<Key> = [a].iter().chain(&between).chain(&[b]).map(key).collect();
        for pair in line.windows(2).filter(|pair| pair[0] != pair[1]) {
            if !edges.remove(&(pair[1], pair[0])) {
                edges.insert((pair[0], pair[1]));
            }
        }
    }
    let mut found: Vec<Vec<Point>> = Vec::new();
    while let Some((start, mut at)) = edges.pop_first() {
        let mut ring = vec![corners[&start]];
        while at != start {
            ring.push(corners[&at]);
            let Some(next) = edges.range((at, (i64::MIN, i64::MIN))..).next().copied().filter(|edge| edge.0 == at)
            else {
                break;
            };
            edges.remove(&next);
            at = next.1;
        }
        found.push(ring);
    }
    found.sort_by(|a, b| area(b).total_cmp(&area(a)));
    found
}
