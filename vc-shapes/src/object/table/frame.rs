//! Legs, bent boards, shells and outlines: supports and backs of furniture.

use nalgebra::{Isometry3, Vector3};
use vc_graph::portable::Portable;

use crate::material::MaterialId;
use crate::solid::{Build, CORNERS, Cut, P, leg};

/// The directions of a five-armed base.
pub(in crate::object) const STAR: [(f32, f32); 5] =
    [(1.0, 0.0), (0.309_017, 0.951_057), (-0.809_017, 0.587_785), (-0.809_017, -0.587_785), (0.309_017, -0.951_057)];

/// Four legs whose feet and heads stay within rectangles of the given half lengths.
pub(in crate::object) struct Four {
    /// The half lengths of the rectangle around the feet.
    pub(in crate::object) feet: (f32, f32),
    /// The half lengths of the rectangle around the heads.
    pub(in crate::object) heads: (f32, f32),
    /// The height of their upper ends.
    pub(in crate::object) height: f32,
    /// The half widths at the floor and at the top.
    pub(in crate::object) radii: (f32, f32),
    /// The cross section.
    pub(in crate::object) cut: Cut,
}

impl Four {
    /// Upright legs in the corners of a rectangle.
    pub(in crate::object) fn upright(half: (f32, f32), height: f32, radii: (f32, f32), cut: Cut) -> Self {
        let foot = (half.0 - radii.1 + radii.0, half.1 - radii.1 + radii.0);
        Self { feet: foot, heads: half, height, radii, cut }
    }

    /// Builds the legs.
    pub(in crate::object) fn build(&self, b: &mut Build<'_>, mat: MaterialId) {
        let (r0, r1) = self.radii;
        for (sx, sy) in CORNERS {
            let foot = [sx * (self.feet.0 - r0), sy * (self.feet.1 - r0), 0.0];
            let head = [sx * (self.heads.0 - r1), sy * (self.heads.1 - r1), self.height];
            leg(b, "leg", (foot, r0), (head, r1), self.cut, mat);
        }
    }

    /// The centre of a leg at a height; the signs give its corner.
    pub(in crate::object) fn middle(&self, corner: (f32, f32), z: f32) -> P {
        let k = z / self.height;
        let mix = |foot: f32, head: f32| (foot - self.radii.0) * (1.0 - k) + (head - self.radii.1) * k;
        [corner.0 * mix(self.feet.0, self.heads.0), corner.1 * mix(self.feet.1, self.heads.1), z]
    }

    /// A rod between two legs at a height.
    pub(in crate::object) fn rung(
        &self,
        b: &mut Build<'_>,
        from: usize,
        to: usize,
        z: f32,
        radius: f32,
        mat: MaterialId,
    ) {
        b.rod("rung", self.middle(CORNERS[from], z), self.middle(CORNERS[to], z), radius, mat);
    }
}

/// A padded board that leans back, given by its rearmost X, its heights, its thickness and its
/// tilt.
pub(in crate::object) struct Lean {
    /// The least X.
    pub(in crate::object) back: f32,
    /// The heights of its lower and its upper front edge.
    pub(in crate::object) z: (f32, f32),
    /// The distance from its front to its back.
    pub(in crate::object) thickness: f32,
    /// The angle from upright, radians.
    pub(in crate::object) tilt: f32,
}

impl Lean {
    fn length(&self) -> f32 {
        (self.z.1 - self.z.0) / self.tilt.cosine()
    }

    /// The X of its front at a height.
    pub(in crate::object) fn front(&self, z: f32) -> f32 {
        self.back + self.thickness * self.tilt.cosine() + (self.z.1 - z) * self.tilt.tangent()
    }

    /// Builds one with rounded edges from `y.0` to `y.1`.
    pub(in crate::object) fn pad(&self, b: &mut Build<'_>, name: &str, y: (f32, f32), radius: f32, mat: MaterialId) {
        self.posed(b, |b, length, thickness| {
            b.rounded_block(name, [-thickness, y.0, 0.0], [0.0, y.1, length], radius, mat)
        });
    }

    /// Builds in its frame: Z along it, X forward from its front.
    pub(in crate::object) fn posed(&self, b: &mut Build<'_>, build: impl FnOnce(&mut Build<'_>, f32, f32)) {
        let at = Vector3::new(self.front(self.z.0), 0.0, self.z.0);
        let (length, thickness) = (self.length(), self.thickness);
        b.posed(Isometry3::new(at, Vector3::y() * -self.tilt), |b| build(b, length, thickness));
    }
}

/// A turned leg with beads and a vase shape, with radius `r` at its widest.
pub(in crate::object) fn baluster(b: &mut Build<'_>, name: &str, base: P, r: f32, height: f32, mat: MaterialId) {
    const PROFILE: [(f32, f32); 13] = [
        (0.55, 0.0),
        (0.7, 0.04),
        (0.45, 0.09),
        (0.5, 0.12),
        (0.85, 0.35),
        (0.9, 0.5),
        (0.6, 0.66),
        (0.5, 0.7),
        (0.9, 0.73),
        (0.9, 0.77),
        (0.55, 0.8),
        (1.0, 0.83),
        (1.0, 1.0),
    ];
    let profile = PROFILE.map(|(x, z)| (x * r, z * height));
    b.lathe(name, base, &profile, mat);
}
