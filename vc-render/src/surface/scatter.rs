//! The reflection model of surfaces: a matt base under a microfacet gloss.
//!
//! The light that the gloss does not reflect reaches the base, in both directions (Ashikhmin and Shirley 2000),
//! and the light lost between facets is compensated (Turquin 2019): a white surface reflects all light at any
//! roughness. The roughest surfaces have no gloss at all.

use std::f32::consts::PI;

use vc_graph::portable::Portable;

use super::albedo::{self, Shares};
use crate::colour::luminance;
use crate::math::{basis, cosine_weighted, dot, low_discrepancy, three, unit};

/// Reflectance of glass, lacquer and other dielectrics at normal incidence.
const HEAD_ON: f32 = 0.04;

/// Parameters of a surface's reflection.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Finish {
    pub(crate) colour: [f32; 3],
    pub(crate) metallic: f32,
    pub(crate) roughness: f32,
}

impl Finish {
    /// Albedo: the share of diffuse light that is reflected in all directions, by colour.
    pub(crate) fn reflected(&self) -> [f32; 3] {
        let (coat, means) = (self.coat(), albedo::mean_shares(self.roughness));
        let (matt, metal) = (1.0 - self.metallic, self.metallic);
        let again = metal * (1.0 / (means[0] + means[1]).max(0.05) - 1.0);
        let base = matt * (1.0 - reflected(coat, means));
        three(|i| {
            let head_on = HEAD_ON * coat * matt + self.colour[i] * metal;
            let gloss = head_on * means[0] + (coat * matt + metal) * means[1];
            base * self.colour[i] + (1.0 + head_on * again) * gloss
        })
    }

    /// Strength of the glossy coat: the roughest surfaces have none.
    fn coat(&self) -> f32 {
        ((1.0 - self.roughness) * 10.0).clamp(0.0, 1.0)
    }
}

/// The reflection at a surface point, in its local frame: the normal is up.
pub(crate) struct Scatter {
    /// Reflectance of the matt base, times the light that the gloss lets through, normalized by pi.
    base: [f32; 3],
    /// Reflectance of the gloss at normal incidence and at grazing angles, with compensation for losses between
    /// facets.
    head_on: [f32; 3],
    edge: [f32; 3],
    gloss: Gloss,
    roughness: f32,
    /// Strength of the coat on the base.
    coat: f32,
    /// Axes of the local frame in the world.
    axes: [[f32; 3]; 3],
    /// Direction to where the path came from, in the local frame.
    back: [f32; 3],
    /// Share of paths that sample the gloss.
    by_gloss: f32,
}

impl Scatter {
    /// The reflection at a point. `back` is the direction to where the path came from, unit length.
    pub(crate) fn new(finish: &Finish, normal: [f32; 3], back: [f32; 3]) -> Self {
        let Finish { colour, metallic, roughness } = *finish;
        let axes = basis(normal);
        let mut own = axes.map(|axis| dot(axis, back));
        own[2] = own[2].max(1e-3);
        let back = unit(own);
        let coat = finish.coat();
        let here = albedo::shares(back[2], roughness);
        let passes = 1.0 - reflected(coat, here);
        let mean = 1.0 - reflected(coat, albedo::mean_shares(roughness));
        let all = (here[0] + here[1]).max(0.05);
        let head_on = colour.map(|c| HEAD_ON * coat * (1.0 - metallic) + c * metallic);
        let at_edge = coat * (1.0 - metallic) + metallic;
        // Light that bounces between facets is coloured.
        let given_back = head_on.map(|h| 1.0 + h * metallic * (1.0 / all - 1.0));
        let base = colour.map(|c| c * (1.0 - metallic));
        let shine = three(|i| given_back[i] * (head_on[i] * here[0] + at_edge * here[1]));
        let (matt, shine) = (luminance(base) * passes, luminance(shine));
        let by_gloss = match () {
            () if shine <= 0.0 => 0.0,
            () if matt <= 0.0 => 1.0,
            () => (shine / (shine + matt)).clamp(0.1, 0.9),
        };
        Self {
            base: base.map(|c| c * passes / (PI * mean.max(1e-3))),
            head_on: three(|i| head_on[i] * given_back[i]),
            edge: given_back.map(|g| g * at_edge),
            gloss: Gloss::new(roughness),
            roughness,
            coat,
            axes,
            back,
            by_gloss,
        }
    }

    /// Reflectance times the cosine for light from a world direction, by colour; and the probability density
    /// over solid angle that [`Self::sample`] chooses it.
    pub(crate) fn evaluate(&self, towards: [f32; 3]) -> ([f32; 3], f32) {
        let to = self.axes.map(|axis| dot(axis, towards));
        if to[2] <= 1e-4 {
            return ([0.0; 3], 0.0);
        }
        let half = unit(three(|i| to[i] + self.back[i]));
        let reaches = 1.0 - reflected(self.coat, albedo::shares(to[2], self.roughness));
        let seen = self.gloss.spread(half[2]) * self.gloss.masking(self.back[2]) / (4.0 * self.back[2]);
        let lobe = seen * self.gloss.masking(to[2]);
        let edge = (1.0 - dot(half, to).clamp(0.0, 1.0)).raised(5);
        let value =
            three(|i| self.base[i] * reaches * to[2] + lobe * (self.head_on[i] * (1.0 - edge) + self.edge[i] * edge));
        (value, self.by_gloss * seen + (1.0 - self.by_gloss) * to[2] / PI)
    }

    /// Samples a world direction to continue in.
    pub(crate) fn sample(&self, choice: f32, square: [f32; 2]) -> [f32; 3] {
        let own = if choice < self.by_gloss { self.gloss.bounced(self.back, square) } else { cosine_weighted(square) };
        three(|i| own[0] * self.axes[0][i] + own[1] * self.axes[1][i] + own[2] * self.axes[2][i])
    }
}

/// Share of light that a coat reflects, given the shares of its gloss.
fn reflected(coat: f32, [head_on, edge]: Shares) -> f32 {
    coat * (HEAD_ON * head_on + edge)
}

/// Microfacets by Trowbridge and Reitz (GGX).
#[derive(Debug, Clone, Copy)]
pub(super) struct Gloss {
    alpha: f32,
}

impl Gloss {
    pub(crate) fn new(roughness: f32) -> Self {
        Self { alpha: (roughness * roughness).max(2e-3) }
    }

    /// Density of facet normals at a cosine to up.
    fn spread(self, cosine: f32) -> f32 {
        let square = self.alpha * self.alpha;
        let bottom = cosine * cosine * (square - 1.0) + 1.0;
        square / (PI * bottom * bottom)
    }

    /// Smith's masking function of one direction.
    fn masking(self, cosine: f32) -> f32 {
        let square = self.alpha * self.alpha;
        2.0 * cosine / (cosine + (square + (1.0 - square) * cosine * cosine).sqrt())
    }

    /// Reflects off a facet sampled from those visible from `back` (Heitz 2018).
    fn bounced(self, back: [f32; 3], [a, b]: [f32; 2]) -> [f32; 3] {
        let [x, y, z] = back;
        let stretched = unit([self.alpha * x, self.alpha * y, z]);
        // One tangent axis is level, the other completes the frame.
        let level = stretched[0] * stretched[0] + stretched[1] * stretched[1];
        let t1 = if level > 1e-12 { unit([-stretched[1], stretched[0], 0.0]) } else { [1.0, 0.0, 0.0] };
        let [sx, sy, sz] = stretched;
        let t2 = [sy * t1[2] - sz * t1[1], sz * t1[0] - sx * t1[2], sx * t1[1] - sy * t1[0]];
        let (s, c) = (2.0 * PI * b).sine_cosine();
        let r = a.sqrt();
        let p = r * c;
        let share = 0.5 * (1.0 + stretched[2]);
        let q = (1.0 - share) * (1.0 - p * p).max(0.0).sqrt() + share * r * s;
        let up = (1.0 - p * p - q * q).max(0.0).sqrt();
        let bent = three(|i| p * t1[i] + q * t2[i] + up * stretched[i]);
        let half = unit([self.alpha * bent[0], self.alpha * bent[1], bent[2].max(1e-6)]);
        let twice = 2.0 * dot(back, half);
        three(|i| twice * half[i] - back[i])
    }

    /// The shares of diffuse light reflected towards a cosine if facets were perfect mirrors: for the
    /// reflectance at normal incidence, and the addition at grazing angles.
    pub(super) fn shares(self, cosine: f32, directions: usize) -> Shares {
        let back = [(1.0 - cosine * cosine).max(0.0).sqrt(), 0.0, cosine];
        let mut sums = [0.0; 2];
        for index in 0..directions {
            let to = self.bounced(back, low_discrepancy(index as u32));
            if to[2] > 0.0 {
                let half = unit(three(|i| to[i] + back[i]));
                let edge = (1.0 - dot(half, to).clamp(0.0, 1.0)).raised(5);
                let lit = self.masking(to[2]) / directions as f32;
                sums = [sums[0] + lit * (1.0 - edge), sums[1] + lit * edge];
            }
        }
        sums
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Share of diffuse light reflected towards a cosine: by [`Scatter::evaluate`] on a regular grid of
    /// directions, and by sampling.
    fn thrown(finish: &Finish, cosine: f32) -> [f32; 2] {
        let back = [(1.0 - cosine * cosine).sqrt(), 0.0, cosine];
        let scatter = Scatter::new(finish, [0.0, 0.0, 1.0], back);
        let (rows, columns) = (300, 300);
        let mut even = 0.0_f64;
        for i in 0..rows * columns {
            let z = ((i / columns) as f32 + 0.5) / rows as f32;
            let (s, c) = (2.0 * PI * ((i % columns) as f32 + 0.5) / columns as f32).sine_cosine();
            let level = (1.0 - z * z).sqrt();
            even += f64::from(scatter.evaluate([level * c, level * s, z]).0[0]);
        }
        let count = 20_000;
        let mut followed = 0.0_f64;
        for i in 0..count {
            let towards = scatter.sample((i as f32 * 0.618_034).fract(), low_discrepancy(i));
            let (value, chance) = scatter.evaluate(towards);
            if chance > 0.0 {
                followed += f64::from(value[0] / chance);
            }
        }
        [(even * f64::from(2.0 * PI) / f64::from(rows * columns)) as f32, (followed / f64::from(count)) as f32]
    }

    #[test]
    fn a_white_surface_throws_back_everything_and_none_throws_back_more() {
        for metallic in [0.0, 1.0] {
            for roughness in [0.3, 0.5, 0.7, 0.95, 1.0] {
                for cosine in [0.15, 0.4, 0.7, 1.0] {
                    let finish = Finish { colour: [1.0; 3], metallic, roughness };
                    let [even, followed] = thrown(&finish, cosine);
                    let place = format!("metallic {metallic}, roughness {roughness}, cosine {cosine}");
                    assert!((even - 1.0).abs() < 0.02, "{place}: {even}");
                    assert!((followed - 1.0).abs() < 0.03, "{place}: {followed}");
                }
            }
        }
    }

    #[test]
    fn what_is_thrown_on_the_whole_is_the_mean_over_all_directions() {
        for (metallic, roughness, share) in [(0.0, 0.3, 0.05), (0.0, 0.7, 0.6), (0.0, 1.0, 0.4), (1.0, 0.5, 0.6)] {
            let finish = Finish { colour: [share; 3], metallic, roughness };
            // Stratified by the square of the cosine, so that all strata count the same.
            let rows: Vec<f32> = (0..8).map(|i| thrown(&finish, ((i as f32 + 0.5) / 8.0).sqrt())[1]).collect();
            let (mean, all) = (rows.iter().sum::<f32>() / 8.0, finish.reflected()[0]);
            assert!(
                (all - mean).abs() < 0.012,
                "metallic {metallic}, roughness {roughness}, {share}: {all}, not {mean}"
            );
        }
    }

    #[test]
    fn a_matt_surface_is_lamberts() {
        let finish = Finish { colour: [0.5; 3], metallic: 0.0, roughness: 1.0 };
        for towards in [[0.0, 0.0, 1.0], [0.6, 0.0, 0.8], [-0.8, 0.0, 0.6]] {
            let (value, _) = Scatter::new(&finish, [0.0, 0.0, 1.0], [0.6, 0.0, 0.8]).evaluate(towards);
            assert!((value[0] - 0.5 / PI * towards[2]).abs() < 1e-5);
        }
    }

    #[test]
    fn light_goes_the_same_way_back() {
        let finish = Finish { colour: [0.6, 0.3, 0.2], metallic: 0.0, roughness: 0.4 };
        let (a, b) = ([0.6, 0.0, 0.8], unit([-0.3, 0.5, 0.4]));
        let there = Scatter::new(&finish, [0.0, 0.0, 1.0], a).evaluate(b).0[0] / b[2];
        let back = Scatter::new(&finish, [0.0, 0.0, 1.0], b).evaluate(a).0[0] / a[2];
        assert!((there - back).abs() < 1e-5 * there, "{there} and {back}");
    }
}
