//! Profiles of (radius, height) for bodies of revolution.

use vc_graph::portable::Portable;

use super::outline::polygon;

/// The lathe profile of a torus: radius of the ring and radius of its section.
///
/// ```
/// use vc_shapes::solid::torus_profile;
/// let profile = torus_profile(0.2, 0.05);
/// assert!(profile.iter().all(|(radius, height)| *radius < 0.251 && *height < 0.101));
/// assert_eq!(profile.first(), profile.last());
/// ```
pub fn torus_profile(radius: f32, section: f32) -> Vec<(f32, f32)> {
    let mut profile: Vec<_> =
        polygon(10, section, 0.0).into_iter().map(|(r, z)| ((radius + r).max(0.0), z + section)).collect();
    profile.extend(profile.first().copied());
    profile
}

/// The profile of a cup: outer radius at the bottom and the top, height, wall.
///
/// ```
/// # use vc_graph::{Seed, nalgebra::Vector3};
/// # use vc_shapes::{Build, Style};
/// # let style = Style::from_seed(Seed(1));
/// # let mut b = Build::new("thing", Vector3::new(1.0, 1.0, 1.0), &style, Seed(1).stream());
/// use vc_shapes::material::POTTERY;
/// use vc_shapes::solid::cup_profile;
/// b.lathe("cup", [0.0; 3], &cup_profile(0.03, 0.04, 0.09, 0.004), POTTERY);
/// assert!((b.finish().1.size().z - 0.09).abs() < 1e-3);
/// ```
pub fn cup_profile(bottom: f32, top: f32, height: f32, wall: f32) -> [(f32, f32); 4] {
    [(bottom, 0.0), (top, height), ((top - wall).max(wall), height), ((bottom - wall).max(wall), wall)]
}

/// The profile of a vessel from its outer outline, foot to rim.
pub fn vessel_profile(outside: &[(f32, f32)], t: f32) -> Vec<(f32, f32)> {
    let floor = outside.first().map_or(0.0, |p| p.1) + t;
    let way = |i: usize| {
        let (a, b) = (outside[i.saturating_sub(1)], outside[(i + 1).min(outside.len() - 1)]);
        let (dr, dz) = (b.0 - a.0, b.1 - a.1);
        let length = dr.hypotenuse(dz).max(1e-9);
        (dr / length, dz / length)
    };
    let last = outside.len().saturating_sub(1);
    let inner = |i: usize| {
        let (r, z) = outside[i];
        let (dr, dz) = way(i);
        let lift = if i == last { 0.0 } else { dr * t };
        ((r - dz.max(0.3) * t).max(r * 0.2), (z + lift).max(floor))
    };
    outside.iter().copied().chain((0..outside.len()).rev().map(inner)).collect()
}
