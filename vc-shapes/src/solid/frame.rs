//! The size to fill, and frames to build in.

use nalgebra::{Isometry3, Vector3};

use super::build::{Build, P};

/// Depth, width and height to fill.
pub(crate) fn dims(b: &Build<'_>) -> (f32, f32, f32) {
    (b.size.x.max(1e-3), b.size.y.max(1e-3), b.size.z.max(1e-3))
}

/// Half depth, half width and height of the object.
pub(crate) fn half_dims(b: &Build<'_>) -> (f32, f32, f32) {
    (b.size.x / 2.0, b.size.y / 2.0, b.size.z)
}

/// Enlarges the build's size to at least `least`: an object far below the usual size of its class
/// would have no room for its boards and tubes.
///
/// ```
/// # use vc_graph::{Seed, nalgebra::Vector3};
/// # use vc_shapes::{Build, Style};
/// # let style = Style::from_seed(Seed(1));
/// # let mut b = Build::new("thing", Vector3::new(1.0, 1.0, 1.0), &style, Seed(1).stream());
/// use vc_shapes::solid::at_least;
/// at_least(&mut b, [0.2, 0.2, 1.5]);
/// assert_eq!(b.size, Vector3::new(1.0, 1.0, 1.5));
/// ```
pub fn at_least(b: &mut Build<'_>, least: P) {
    b.size = b.size.sup(&Vector3::from(least));
}

/// The factor by which fixed dimensions shrink: one if the size is at least `least`.
///
/// ```
/// # use vc_graph::{Seed, nalgebra::Vector3};
/// # use vc_shapes::{Build, Style};
/// # let style = Style::from_seed(Seed(1));
/// # let mut b = Build::new("thing", Vector3::new(1.0, 1.0, 1.0), &style, Seed(1).stream());
/// use vc_shapes::solid::fit;
/// assert_eq!(fit(&b, [0.5, 0.5, 2.0]), 0.5);
/// ```
pub fn fit(b: &Build<'_>, least: P) -> f32 {
    (b.size.x / least[0]).min(b.size.y / least[1]).min(b.size.z / least[2]).min(1.0)
}

/// Reserves a margin for round parts: reduces every side and the top by the given metres, but keeps
/// at least six tenths of the size.
pub(crate) fn spare(b: &mut Build<'_>, x: f32, y: f32, z: f32) {
    let least = b.size * 0.6;
    b.size = (b.size - Vector3::new(2.0 * x, 2.0 * y, z)).sup(&least);
}

/// Builds an object lying on its back: +X of the frame points up, +Z away from the front.
pub fn lying(b: &mut Build<'_>, at: P, build: impl FnOnce(&mut Build<'_>)) {
    let pose = Isometry3::new(Vector3::from(at), Vector3::y() * -std::f32::consts::FRAC_PI_2);
    b.posed(pose, build);
}

/// Builds a flat object that faces +X from its thickness, width and height, with the centre of its
/// base at the origin; it lies on its back if the size is lowest along Z.
pub fn facing(b: &mut Build<'_>, build: impl FnOnce(&mut Build<'_>, f32, f32, f32)) {
    let s = b.size;
    if s.z < s.x.min(s.y) {
        lying(b, [s.x / 2.0, 0.0, s.z / 2.0], |b| build(b, s.z, s.y, s.x));
    } else {
        build(b, s.x, s.y, s.z);
    }
}

/// Builds with +Y of the frame along the longest horizontal side of the size; `build` receives half
/// depth, half length and height.
pub(crate) fn lengthwise(b: &mut Build<'_>, build: impl FnOnce(&mut Build<'_>, f32, f32, f32)) {
    let (x, y, h) = half_dims(b);
    if x > y {
        b.at([0.0; 3], std::f32::consts::FRAC_PI_2, |b| build(b, y, x, h));
    } else {
        build(b, x, y, h);
    }
}

/// Builds with +Z of the frame along the longest side of the size, which may lie along Y or X;
/// `build` receives thickness, width and length.
pub(crate) fn longwise(b: &mut Build<'_>, build: impl FnOnce(&mut Build<'_>, f32, f32, f32)) {
    let s = b.size;
    let quarter = std::f32::consts::FRAC_PI_2;
    if s.z >= s.y.max(s.x) {
        build(b, s.x, s.y, s.z);
    } else if s.y >= s.x {
        let pose = Isometry3::new(Vector3::new(0.0, s.y / 2.0, s.z / 2.0), Vector3::x() * quarter);
        b.posed(pose, |b| build(b, s.x, s.z, s.y));
    } else {
        let pose = Isometry3::new(Vector3::new(-s.x / 2.0, 0.0, s.z / 2.0), Vector3::y() * quarter);
        b.posed(pose, |b| build(b, s.z, s.y, s.x));
    }
}

/// A frame rotated around Y: a positive pitch tips the front down.
pub(crate) fn pitched(at: P, pitch: f32) -> vc_graph::Pose {
    Isometry3::new(Vector3::from(at), Vector3::y() * pitch)
}

/// A frame rotated around X: a positive roll tips the left side up.
pub(crate) fn rolled(at: P, roll: f32) -> vc_graph::Pose {
    Isometry3::new(Vector3::from(at), Vector3::x() * roll)
}
