//! How a surface throws light: a matt base under a gloss of microfacets.

use std::f32::consts::PI;

use vc_graph::portable::Portable;

use crate::label::unit;
use crate::light::dot;

/// A point of a surface, in its own frame: the normal is up.
pub(super) struct Scatter {
    pub(super) colour: [f32; 3],
    pub(super) metallic: f32,
    alpha: f32,
    /// Axes of the frame in the world.
    axes: [[f32; 3]; 3],
    /// To where the path came from, in the frame.
    back: [f32; 3],
    /// Share of paths that go by the gloss.
    gloss: f32,
}

impl Scatter {
    /// `back` leads to where the path came from, unit length.
    pub(super) fn new(colour: [f32; 3], metallic: f32, roughness: f32, normal: [f32; 3], back: [f32; 3]) -> Self {
        let axes = frame(normal);
        let mut own = axes.map(|axis| dot(axis, back));
        own[2] = own[2].max(1e-3);
        let fresnel = 0.04 + 0.96 * (1.0 - own[2]).max(0.0).raised(5);
        let gloss = (metallic + (1.0 - metallic) * (0.15 + fresnel)).clamp(0.1, 1.0);
        let alpha = (roughness * roughness).max(2e-3);
        Self { colour, metallic, alpha, axes, back: unit(own), gloss }
    }

    pub(super) fn inwards(&self, world: [f32; 3]) -> [f32; 3] {
        self.axes.map(|axis| dot(axis, world))
    }

    /// What share of light from a direction of the world is thrown back, times the cosine, by
    /// colour; and the chance for each unit of solid angle that [`Self::sample`] goes there.
    pub(super) fn evaluate(&self, towards: [f32; 3]) -> ([f32; 3], f32) {
        let to = self.inwards(towards);
        if to[2] <= 1e-4 {
            return ([0.0; 3], 0.0);
        }
        let half = unit([0, 1, 2].map(|i: usize| to[i] + self.back[i]));
        let square = self.alpha * self.alpha;
        let bottom = half[2] * half[2] * (square - 1.0) + 1.0;
        let spread = square / (PI * bottom * bottom);
        let (seen, lit) = (self.masking(self.back[2]), self.masking(to[2]));
        let lobe = spread * seen * lit / (4.0 * self.back[2]);
        let edge = (1.0 - dot(half, to).clamp(0.0, 1.0)).raised(5);
        let value = [0, 1, 2].map(|i: usize| {
            let head_on = 0.04 + (self.colour[i] - 0.04) * self.metallic;
            let fresnel = head_on + (1.0 - head_on) * edge;
            let dull = 0.04 + 0.96 * edge;
            self.colour[i] * (1.0 - self.metallic) * (1.0 - dull) * to[2] / PI + fresnel * lobe
        });
        let by_gloss = spread * seen / (4.0 * self.back[2]);
        (value, self.gloss * by_gloss + (1.0 - self.gloss) * to[2] / PI)
    }

    /// Smith's masking of one direction.
    fn masking(&self, cosine: f32) -> f32 {
        let square = self.alpha * self.alpha;
        2.0 * cosine / (cosine + (square + (1.0 - square) * cosine * cosine).sqrt())
    }

    /// A direction of the world to go on to.
    pub(super) fn sample(&self, choice: f32, [a, b]: [f32; 2]) -> [f32; 3] {
        let own = if choice < self.gloss { self.facet([a, b]) } else { cosine([a, b]) };
        [0, 1, 2].map(|i: usize| own[0] * self.axes[0][i] + own[1] * self.axes[1][i] + own[2] * self.axes[2][i])
    }

    /// Off a facet, of those that are seen from where the path came (Heitz 2018).
    fn facet(&self, [a, b]: [f32; 2]) -> [f32; 3] {
        let [x, y, z] = self.back;
        let stretched = unit([self.alpha * x, self.alpha * y, z]);
        let [t1, t2, _] = frame(stretched);
        let (s, c) = (2.0 * PI * b).sine_cosine();
        let r = a.sqrt();
        let p = r * c;
        let share = 0.5 * (1.0 + stretched[2]);
        let q = (1.0 - share) * (1.0 - p * p).max(0.0).sqrt() + share * r * s;
        let up = (1.0 - p * p - q * q).max(0.0).sqrt();
        let bent = [0, 1, 2].map(|i: usize| p * t1[i] + q * t2[i] + up * stretched[i]);
        let half = unit([self.alpha * bent[0], self.alpha * bent[1], bent[2].max(1e-6)]);
        let twice = 2.0 * dot(self.back, half);
        [0, 1, 2].map(|i: usize| twice * half[i] - self.back[i])
    }
}

/// A direction by the cosine to up (Malley's method).
fn cosine([a, b]: [f32; 2]) -> [f32; 3] {
    let (s, c) = (2.0 * PI * b).sine_cosine();
    let r = a.sqrt();
    [r * c, r * s, (1.0 - a).max(0.0).sqrt()]
}

/// Three axes, the last one given (Duff and others 2017).
pub(super) fn frame(n: [f32; 3]) -> [[f32; 3]; 3] {
    let sign = 1.0_f32.copysign(n[2]);
    let a = -1.0 / (sign + n[2]);
    let b = n[0] * n[1] * a;
    [[1.0 + sign * n[0] * n[0] * a, sign * b, -sign * n[0]], [b, sign + n[1] * n[1] * a, -n[1]], n]
}
