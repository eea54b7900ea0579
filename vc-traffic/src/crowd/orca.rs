//! Optimal reciprocal collision avoidance (van den Berg, Guy, Lin and Manocha, Robotics Research 2011): the velocities by which two
//! people do not come together within some time, if each does half of what it takes.

use nalgebra::Vector2;

use super::plane::HalfPlane;

/// The half-plane of the velocities of somebody for another at `away`, who moves by `relative` less, metres per second. They keep a distance
/// in metres for a time in seconds.
pub(super) fn avoid(
    velocity: &Vector2<f32>,
    away: &Vector2<f32>,
    relative: &Vector2<f32>,
    distance: f32,
    time: f32,
) -> HalfPlane {
    let square = away.norm_squared();
    let clear = square - distance * distance;
    // From the middle of the disc of velocities that lead to the other in just that time.
    let from = relative - away / time;
    let toward = from.dot(away);
    let (normal, change) =
        if clear <= 0.0 || (toward < 0.0 && toward * toward > distance * distance * from.norm_squared()) {
            let length = from.norm().max(1e-6);
            (from / length, distance / time - length)
        } else {
            // A side of the cone of those that lead there at any time, the nearer one.
            let leg = clear.sqrt();
            let side = if away.perp(&from) > 0.0 { 1.0 } else { -1.0 };
            let along =
                Vector2::new(away.x * leg - side * away.y * distance, side * away.x * distance + away.y * leg) / square;
            let normal = Vector2::new(-along.y, along.x) * side;
            (normal, -relative.dot(&normal))
        };
    HalfPlane { normal, least: velocity.dot(&normal) + change / 2.0 }
}
