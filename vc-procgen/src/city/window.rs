//! WindowSlot slots: the places in a facade where the rooms behind may open it.

use nalgebra::Vector2;
use vc_map::Point;

use super::building::CityBuilding;
use super::convex::{Beyond, Convex, left};
use super::unit_kind::{UnitKind, UnitPlace};

/// The distance of windows from the ends of a side, metres.
const EDGE: f64 = 0.5;
/// How far before a window no wing stands, metres.
const AHEAD: [f64; 3] = [0.1, 0.3, 0.6];
/// A window is at least this wide, metres.
const NARROW: f64 = 0.6;

/// A place in a facade where a window may be.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct WindowSlot {
    /// Its storey, counted from the ground.
    pub storey: usize,
    /// Its middle.
    pub at: Point,
    /// The direction out of it, a unit vector.
    pub out: Vector2<f64>,
    /// Its width and height, metres.
    pub size: [f64; 2],
    /// The height of its sill above the floor, metres.
    pub sill: f64,
}

/// The distance between the middles of slots, and the measures of a window: width, height, sill.
fn measures(kind: UnitKind, beyond: Beyond) -> [f64; 4] {
    match (kind.place(), beyond) {
        (UnitPlace::Home, _) => [3.2, 1.3, 1.4, 0.9],
        (UnitPlace::Shop | UnitPlace::Hall, Beyond::Street(_)) => [3.4, 2.8, 2.4, 0.45],
        _ => [3.0, 2.4, 1.6, 0.95],
    }
}

/// The slots of a unit's facades on a storey; none where another wing of the building stands.
pub(super) fn windows(building: &CityBuilding, outline: &Convex, storey: usize, kind: UnitKind) -> Vec<WindowSlot> {
    let mut found = Vec::new();
    for (a, b, beyond) in outline.sides().filter(|side| side.2.is_open()) {
        let (length, along) = ((b - a).norm(), (b - a).normalize());
        let [module, width, height, sill] = measures(kind, beyond);
        let width = width.min(length - 2.0 * EDGE);
        // Bays are stretched until they fill the facade.
        let most = (length / (width + EDGE)).floor();
        let count = (length / module).round().min(most).max(if width > NARROW { 1.0 } else { 0.0 });
        let bay = length / count;
        for i in 0..count.max(0.0) as usize {
            let (at, out) = (a + along * (bay * (i as f64 + 0.5)), -left(along));
            let mut ahead =
                AHEAD.iter().flat_map(|far| [-0.5, 0.0, 0.5].map(|part| at + along * (width * part) + out * *far));
            let here = || building.wings.iter().filter(|wing| wing.from <= storey && storey < wing.to);
            let covered = ahead.any(|point| here().any(|wing| wing.plan.contains(&point, 0.0)));
            if !covered {
                found.push(WindowSlot { storey, at, out, size: [width, height], sill });
            }
        }
    }
    found
}
