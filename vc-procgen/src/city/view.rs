//! Views that have to be free: of drivers who give way, along the street of a higher class.

use vc_map::{Junction, Lane, Point, RoadId, StreetMap, StripKind, Users};

use super::convex::{Beyond, Convex};
use super::item::{StreetItem, yields};
use super::near::Near;

/// A driver who gives way looks from this far behind the edge of the carriageway, metres.
const EYE: f64 = 3.0;
/// Posts that are thinner hide nobody, nor do things that are lower: radius and height in metres.
pub(super) const THIN: f64 = 0.32;
pub(super) const LOW: f64 = 0.6;

/// A view from an eye to whoever comes along a street.
pub(super) struct View {
    pub(super) eye: Point,
    pub(super) target: Point,
    /// The triangle between the two and the junction.
    pub(super) ground: Convex,
}

impl View {
    /// The numbers of points that may be in it, or so many metres beyond.
    pub(super) fn near<'a>(&self, points: &'a Near, beyond: f64) -> impl Iterator<Item = usize> + use<'a> {
        let middle = self.ground.middle();
        let reach = self.ground.corners().iter().map(|corner| (corner - middle).norm()).fold(0.0, f64::max);
        points.around(&middle, reach + beyond)
    }

    /// Whether a thing hides a part of it.
    pub(super) fn is_hidden_by(&self, item: &StreetItem) -> bool {
        item.radius >= THIN && item.height > LOW && self.ground.contains(&item.at, 0.0)
    }
}

/// Things without those that stand in a view.
pub(super) fn without(mut items: Vec<StreetItem>, views: &[View]) -> Vec<StreetItem> {
    let places: Vec<Point> = items.iter().map(|item| item.at).collect();
    let near = Near::of(&places);
    let mut hides = vec![false; items.len()];
    for view in views {
        view.near(&near, 0.0).for_each(|index| hides[index] |= view.is_hidden_by(&items[index]));
    }
    let mut hides = hides.into_iter();
    items.retain(|_| !hides.next().unwrap_or(false));
    items
}

/// The views of a map that have to be free.
pub(super) fn views(map: &StreetMap) -> Vec<View> {
    let mut found = Vec::new();
    for lane in map.lanes().iter().filter(|lane| lane.kind == StripKind::Driving && lane.users.has(Users::CAR)) {
        let Some(junction) = lane.next.first().and_then(|id| map.movement(*id)).and_then(|m| map.junction(m.junction))
        else {
            continue;
        };
        for road in yields(map, lane) {
            if let Some((eye, target)) = eye(map, lane, junction, road).zip(target(map, junction, road)) {
                found.extend(triangle(eye, junction.at, target).map(|ground| View { eye, target, ground }));
            }
        }
    }
    found
}

/// The place of a driver who gives way: behind the edge of the street's carriageway, along the lane.
fn eye(map: &StreetMap, lane: &Lane, junction: &Junction, road: RoadId) -> Option<Point> {
    let arm = junction.arms.iter().find(|arm| arm.road == road)?;
    let kerb = map.road(road)?.draft.section.surface() / 2.0;
    let (end, along) = (lane.line.end(), lane.line.direction(lane.line.length()));
    let sine = arm.away.perp(&along).abs().max(0.3);
    let to_kerb = (arm.away.perp(&(end - junction.at)).abs() - kerb) / sine;
    Some(end + along * (to_kerb - EYE))
}

/// The point of a street from which somebody who comes must be seen: 45 m away at 30 km/h, 70 m at 50.
fn target(map: &StreetMap, junction: &Junction, road: RoadId) -> Option<Point> {
    let arm = junction.arms.iter().find(|arm| arm.road == road)?;
    let road = map.road(road)?;
    let limit = road.draft.section.strips().map(|(_, strip)| strip.limit).fold(0.0, f64::max);
    let far = if limit > 10.0 { 70.0 } else { 45.0 };
    // Along the street as it leaves the junction: it goes on straight behind the next one.
    let length = road.line.length().min(far);
    Some(road.line.at(if arm.start { length } else { road.line.length() - length }))
}

fn triangle(a: Point, b: Point, c: Point) -> Option<Convex> {
    let corners = if (b - a).perp(&(c - a)) > 0.0 { vec![a, b, c] } else { vec![a, c, b] };
    let ground = Convex::new(corners, vec![Beyond::Court; 3]);
    (ground.area() > 1.0).then_some(ground)
}
