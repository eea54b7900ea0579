//! Statistics of real homes.

use super::Zone;

/// The source of the values.
pub(super) const SOURCE: &str = "ResPlan (CC BY 4.0), a dataset of real floor plans: 45 apartments of 89 to 191 m² gross, \
                          mostly with two or three bedrooms and as many bathrooms, out of an excerpt of 100 plans; \
                          the living room includes halls";

/// The net area of rooms: 5th percentile, median, 95th percentile, m².
pub(super) const AREAS: [(Zone, [f32; 3]); 6] = [
    (Zone::Living, [22.6, 33.0, 57.4]),
    (Zone::Bedroom, [10.1, 14.6, 22.7]),
    (Zone::Kitchen, [5.5, 8.6, 13.0]),
    (Zone::Bathroom, [2.4, 3.8, 8.7]),
    (Zone::Balcony, [1.4, 4.2, 7.9]),
    (Zone::Storage, [2.0, 2.6, 12.5]),
];

/// The share of plans in which rooms of two kinds share a wall.
pub(super) const WALLS: [(Zone, Zone, f64); 8] = [
    (Zone::Bedroom, Zone::Living, 1.0),
    (Zone::Kitchen, Zone::Living, 1.0),
    (Zone::Bathroom, Zone::Bedroom, 1.0),
    (Zone::Bathroom, Zone::Living, 0.96),
    (Zone::Bedroom, Zone::Bedroom, 0.62),
    (Zone::Bathroom, Zone::Bathroom, 0.53),
    (Zone::Bedroom, Zone::Kitchen, 0.36),
    (Zone::Bathroom, Zone::Kitchen, 0.36),
];

/// The share of plans in which a door connects rooms of two kinds.
pub(super) const DOORS: [(Zone, Zone, f64); 7] = [
    (Zone::Bathroom, Zone::Bedroom, 1.0),
    (Zone::Bedroom, Zone::Living, 1.0),
    (Zone::Bathroom, Zone::Living, 0.67),
    (Zone::Balcony, Zone::Bedroom, 0.67),
    (Zone::Balcony, Zone::Living, 0.58),
    (Zone::Kitchen, Zone::Living, 0.27),
    (Zone::Bedroom, Zone::Bedroom, 0.02),
];

/// The share of plans in which rooms of two kinds are open to each other: kitchens that have no
/// door to the living room.
pub(super) const PASSAGES: [(Zone, Zone, f64); 1] = [(Zone::Kitchen, Zone::Living, 0.73)];

/// The mean number of doors per room.
pub(super) const DOORS_PER_ROOM: [(Zone, f64); 3] = [(Zone::Living, 4.2), (Zone::Bedroom, 2.2), (Zone::Bathroom, 1.04)];

/// The share of bedrooms and of living rooms that should have a window.
pub(super) const WINDOWED: f64 = 0.99;
