//! Mass, centre of mass and inertia, from the parts as modelled.
//!
//! The integrals of 1, x and x xᵀ over the volume of every shape are known in closed form (for a profile or
//! outline: sums over its edges, by Green's theorem; for triangles: sums over the tetrahedra between them and
//! the origin). They are added up in double precision, and converted to the engine's principal axes once, at
//! the end.

use std::f64::consts::PI;

use nalgebra::{Matrix3, Point3, Vector3};
use rapier3d::dynamics::MassProperties;
use rapier3d::math::{Matrix, Vector};
use vc_graph::Pose;
use vc_graph::asset::Shape;
use vc_graph::portable::Portable;

use super::hull;
use super::piece::{Piece, pieces};
use super::scale;

/// Rows and columns of a matrix's entries on and above its diagonal.
const ABOVE: [(usize, usize); 6] = [(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)];

/// Mass and its moments about the origin: they are additive, and transform under linear maps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Moments {
    mass: f64,
    first: Vector3<f64>,
    second: Matrix3<f64>,
}

impl Default for Moments {
    fn default() -> Self {
        Self { mass: 0.0, first: Vector3::zeros(), second: Matrix3::zeros() }
    }
}

impl std::ops::AddAssign for Moments {
    fn add_assign(&mut self, other: Self) {
        self.mass += other.mass;
        self.first += other.first;
        self.second += other.second;
    }
}

impl std::ops::Mul<f64> for Moments {
    type Output = Self;

    fn mul(self, by: f64) -> Self {
        Self { mass: self.mass * by, first: self.first * by, second: self.second * by }
    }
}

impl Moments {
    /// The moments of a solid shape, per unit of density; those of its pieces if it encloses nothing.
    pub(crate) fn from_shape(shape: &Shape) -> Self {
        if !shape.measures_are_positive() {
            return Self::default();
        }
        let own = match shape {
            Shape::Box { half } | Shape::RoundedBox { half, .. } => Self::cuboid(half),
            Shape::Cylinder { radius, half_height } => {
                Self::turned(&[(*radius, -half_height), (*radius, *half_height)])
            }
            Shape::Cone { radius, half_height } => Self::turned(&[(*radius, -half_height), (0.0, *half_height)]),
            Shape::Capsule { radius, half_height } => Self::capsule(*radius, *half_height),
            Shape::Sphere { radius } => Self::capsule(*radius, 0.0),
            Shape::Lathe { profile } => Self::turned(profile),
            Shape::Extrusion { outline, height } => Self::drawn_up(outline, *height),
            Shape::Mesh { vertices, triangles, .. } => Self::enclosed(vertices, triangles),
            Shape::Hull { points } => {
                hull::triangles(points).map_or_else(Self::default, |t| Self::enclosed(points, &t))
            }
            _ => Self::default(),
        };
        if own.is_sound() { own } else { Self::from_pieces(&pieces(shape, &Vector3::z())) }
    }

    /// The moments of convex pieces, per unit of density.
    pub(crate) fn from_pieces(pieces: &[Piece]) -> Self {
        let mut sum = Self::default();
        for piece in pieces {
            let (vertices, triangles) = scale::mesh(piece);
            sum += Self::enclosed(&vertices, &triangles);
        }
        sum
    }

    fn cuboid(half: &Vector3<f32>) -> Self {
        let half = half.cast::<f64>();
        let mass = 8.0 * half.product();
        let second = Matrix3::from_diagonal(&half.component_mul(&half)) * (mass / 3.0);
        Self { mass, first: Vector3::zeros(), second }
    }

    fn capsule(radius: f32, half_height: f32) -> Self {
        let (r, h) = (f64::from(radius), f64::from(half_height));
        // The two halves of the ball, moved apart.
        let ball = 4.0 / 3.0 * PI * r.raised(3);
        let (across, along) = (ball * r * r / 5.0, ball * (r * r / 5.0 + 0.75 * r * h + h * h));
        let ends = Matrix3::from_diagonal(&Vector3::new(across, across, along));
        let mut sum = Self { mass: ball, first: Vector3::zeros(), second: ends };
        if half_height > 0.0 {
            sum += Self::turned(&[(radius, -half_height), (radius, half_height)]);
        }
        sum
    }

    /// A profile of (radius, height) rotated around Z: discs of thickness dz, integrated along the profile with
    /// three Gauss points per edge, which is exact.
    fn turned(profile: &[(f32, f32)]) -> Self {
        const POINTS: [(f64, f64); 3] =
            [(-0.774_596_669_241_483_4, 5.0 / 18.0), (0.0, 8.0 / 18.0), (0.774_596_669_241_483_4, 5.0 / 18.0)];
        let (mut mass, mut lift, mut across, mut along) = (0.0, 0.0, 0.0, 0.0);
        for edge in profile.windows(2) {
            let [(r0, z0), (r1, z1)] = [edge[0], edge[1]].map(|(r, z)| (f64::from(r), f64::from(z)));
            for (at, weight) in POINTS {
                let (low, high) = (0.5 * (1.0 - at), 0.5 * (1.0 + at));
                let (r, z) = (r0 * low + r1 * high, z0 * low + z1 * high);
                let disc = PI * r * r * (z1 - z0) * weight;
                mass += disc;
                lift += disc * z;
                across += disc * r * r / 4.0;
                along += disc * z * z;
            }
        }
        let second = Matrix3::from_diagonal(&Vector3::new(across, across, along));
        Self { mass, first: Vector3::z() * lift, second }.outward()
    }

    /// An outline extruded along Z.
    fn drawn_up(outline: &[(f32, f32)], height: f32) -> Self {
        let mut flat = Self::default();
        let next = outline.iter().cycle().skip(1);
        for (&from, &to) in outline.iter().zip(next) {
            let [a, b] = [from, to].map(|(x, y)| Vector3::new(f64::from(x), f64::from(y), 0.0));
            let (cross, sum) = (a.x * b.y - b.x * a.y, a + b);
            flat.mass += cross / 2.0;
            flat.first += sum * (cross / 6.0);
            flat.second += (a * a.transpose() + b * b.transpose() + sum * sum.transpose()) * (cross / 24.0);
        }
        let h = f64::from(height);
        let mut sum = flat.outward() * h;
        let lifted = sum.first * (h / 2.0);
        sum.first.z = sum.mass * h / 2.0;
        for axis in 0..2 {
            (sum.second[(axis, 2)], sum.second[(2, axis)]) = (lifted[axis], lifted[axis]);
        }
        sum.second[(2, 2)] = sum.mass * h * h / 3.0;
        sum
    }

    /// The volume that triangles enclose.
    fn enclosed(vertices: &[Point3<f32>], triangles: &[[u32; 3]]) -> Self {
        let Some(origin) = vertices.first().map(|v| v.coords.cast::<f64>()) else { return Self::default() };
        let corner = |v: u32| vertices.get(v as usize).map(|p| p.coords.cast::<f64>() - origin);
        let (mut mass, mut first, mut above) = (0.0, Vector3::zeros(), [0.0; 6]);
        for &[a, b, c] in triangles {
            let (Some(a), Some(b), Some(c)) = (corner(a), corner(b), corner(c)) else { continue };
            let (volume, middle) = (a.dot(&b.cross(&c)) / 6.0, a + b + c);
            mass += volume;
            first += middle * (volume / 4.0);
            // The matrix is symmetric, so half of it is enough.
            for (sum, (i, j)) in above.iter_mut().zip(ABOVE) {
                *sum += (a[i] * a[j] + b[i] * b[j] + c[i] * c[j] + middle[i] * middle[j]) * (volume / 20.0);
            }
        }
        let mut second = Matrix3::zeros();
        for (sum, (i, j)) in above.into_iter().zip(ABOVE) {
            (second[(i, j)], second[(j, i)]) = (sum, sum);
        }
        Self { mass, first, second }.outward().shifted(&origin)
    }

    /// The same moments with a mass that is not negative, whatever the orientation of the surface.
    fn outward(self) -> Self {
        if self.mass < 0.0 { self * -1.0 } else { self }
    }

    fn shifted(self, by: &Vector3<f64>) -> Self {
        let cross = self.first * by.transpose();
        let second = self.second + cross + cross.transpose() + by * by.transpose() * self.mass;
        Self { first: self.first + by * self.mass, second, ..self }
    }

    /// Moved by the part's pose.
    pub(crate) fn moved(self, at: &Pose) -> Self {
        let turn = at.rotation.to_rotation_matrix().matrix().cast::<f64>();
        let turned = Self { first: turn * self.first, second: turn * self.second * turn.transpose(), ..self };
        turned.shifted(&at.translation.vector.cast::<f64>())
    }

    /// Scaled along the axes.
    pub(crate) fn stretched(self, by: &Vector3<f32>) -> Self {
        let by = by.cast::<f64>();
        let (map, volume) = (Matrix3::from_diagonal(&by), by.product().abs());
        Self { mass: self.mass, first: map * self.first, second: map * self.second * map } * volume
    }

    pub(crate) fn mass(&self) -> f32 {
        self.mass as f32
    }

    /// The covariance about the centre, times the mass.
    fn spread(&self) -> Matrix3<f64> {
        self.second - self.first * self.first.transpose() / self.mass
    }

    /// Whether all values are finite, the mass is positive, and it is not all in one plane.
    pub(crate) fn is_sound(&self) -> bool {
        let spread = self.spread();
        let finite = self.first.iter().chain(spread.iter()).all(|v| v.is_finite());
        self.mass.is_finite() && self.mass > 0.0 && finite && (0..3).all(|i| spread[(i, i)] > 0.0)
    }

    /// Converts the moments to the engine's mass properties.
    ///
    /// The engine treats a body with an inertia below 1e-5, whatever the unit, as a ball, and the inertia of a
    /// pen in SI units is below that. Therefore the axes are computed in a suitable unit.
    pub(crate) fn properties(&self) -> MassProperties {
        if !self.is_sound() {
            return MassProperties::default();
        }
        let spread = self.spread();
        let inertia = Matrix3::from_diagonal_element(spread.trace()) - spread;
        let unit = inertia.diagonal().max();
        let axes = (inertia / unit).cast::<f32>();
        let centre = (self.first / self.mass).cast::<f32>();
        let own = MassProperties::with_inertia_matrix(
            Vector::new(centre.x, centre.y, centre.z),
            (self.mass / unit) as f32,
            Matrix::from_cols_array(&std::array::from_fn(|i| axes[i])),
        );
        scaled(own, self.mass())
    }
}

/// Whether mass, centre and inertia are finite, and the mass is positive.
pub(crate) fn is_sound(properties: &MassProperties) -> bool {
    let inertia = properties.principal_inertia();
    let positive = |v: f32| v.is_finite() && v > 0.0;
    positive(properties.mass())
        && properties.local_com.is_finite()
        && [inertia.x, inertia.y, inertia.z].into_iter().all(positive)
}

/// The same distribution with another mass.
pub(crate) fn scaled(mut properties: MassProperties, mass: f32) -> MassProperties {
    properties.set_mass(mass, true);
    properties
}

#[cfg(test)]
mod tests {
    use super::*;

    fn same(a: &Moments, b: &Moments, slack: f64) {
        let apart = (a.mass - b.mass).abs() + (a.first - b.first).norm() + (a.second - b.second).norm();
        assert!(apart <= slack * a.mass, "{a:?} {b:?}");
    }

    #[test]
    fn one_box_is_as_heavy_in_every_way_it_is_described() {
        let half = Vector3::new(0.2, 0.3, 0.4);
        let solid = Moments::from_shape(&Shape::Box { half }).moved(&Pose::translation(0.0, 0.0, 0.4));
        let outline = vec![(-0.2, -0.3), (0.2, -0.3), (0.2, 0.3), (-0.2, 0.3)];
        same(&solid, &Moments::from_shape(&Shape::Extrusion { outline, height: 0.8 }), 1e-6);
        let points: Vec<Point3<f32>> =
            (0..8).map(|i| Point3::new([-0.2, 0.2][i & 1], [-0.3, 0.3][i >> 1 & 1], [0.0, 0.8][i >> 2])).collect();
        same(&solid, &Moments::from_shape(&Shape::Hull { points }), 1e-6);
        let stretched =
            Moments::from_shape(&Shape::Box { half: Vector3::repeat(0.1) }).stretched(&Vector3::new(2.0, 3.0, 4.0));
        same(&solid, &stretched.moved(&Pose::translation(0.0, 0.0, 0.4)), 1e-6);
    }

    #[test]
    fn what_is_turned_is_as_heavy_as_known() {
        let (r, h) = (0.3_f64, 0.5_f64);
        let rod = Moments::from_shape(&Shape::Cylinder { radius: 0.3, half_height: 0.5 });
        assert!((rod.mass - PI * r * r * 2.0 * h).abs() < 1e-6);
        let inertia = rod.properties().principal_inertia() / rod.mass();
        let mut all = inertia.to_array().map(f64::from);
        all.sort_by(f64::total_cmp);
        let known = [r * r / 2.0, (3.0 * r * r + 4.0 * h * h) / 12.0];
        assert!((all[0] - known[0]).abs() < 1e-5 && (all[1] - known[1]).abs() < 1e-5, "{all:?} {known:?}");
        // A pipe is a rod without its core, in whichever direction its profile runs.
        let ring = vec![(0.3, -0.5), (0.3, 0.5), (0.2, 0.5), (0.2, -0.5), (0.3, -0.5)];
        let mut whole = Moments::from_shape(&Shape::Lathe { profile: ring.iter().rev().copied().collect() });
        same(&whole, &Moments::from_shape(&Shape::Lathe { profile: ring }), 1e-9);
        whole += Moments::from_shape(&Shape::Cylinder { radius: 0.2, half_height: 0.5 });
        same(&rod, &whole, 1e-6);
        let ball = Moments::from_shape(&Shape::Sphere { radius: 0.2 });
        assert!((ball.mass - 4.0 / 3.0 * PI * 0.008).abs() < 1e-6);
        assert!((f64::from(ball.properties().principal_inertia().x) / ball.mass - 0.016).abs() < 1e-5);
    }
}
