//! Direct light from the sun and from lamps, with shadows.

#![allow(clippy::needless_range_loop, reason = "lists of one length go side by side, as vectors do")]

use super::{BATCH, Batch, Lanes};
use crate::colour::luminance;
use crate::light::{Lamp, Lighting, Points};
use crate::scene::NO_ROOM;

impl Batch {
    #[inline(always)]
    pub(super) fn sun(&mut self, lighting: &Lighting, plain: bool) {
        let Some(map) = &lighting.sun else { return };
        let towards: [f32; 3] = lighting.daylight.towards_sun.into();
        for i in 0..self.lanes() {
            for k in 0..3 {
                self.to[k][i] = towards[k];
            }
            self.cosine[i] =
                self.normal[0][i] * towards[0] + self.normal[1][i] * towards[1] + self.normal[2][i] * towards[2];
            // Without shadows the sun would shine in through the roof.
            let inside = plain && self.rooms[i] != NO_ROOM;
            self.power[i] = if inside { 0.0 } else { lighting.sunlight(self.rooms[i]) };
        }
        let sun = lighting.daylight.sun.into();
        self.shadow(
            sun,
            #[inline(always)]
            |points, which, share| if plain { share.fill(1.0) } else { map.light(points, which, share) },
        );
    }

    #[inline(always)]
    pub(super) fn lamp(&mut self, lamp: &Lamp, plain: bool) {
        let [x, y, z] = lamp.axis;
        let narrow = (x * x + y * y + z * z).sqrt().min(1.0);
        // Blends uniform light with cosine-distributed light in a half space.
        let even = (1.0 - narrow) / (4.0 * std::f32::consts::PI);
        for i in 0..self.lanes() {
            let to = [lamp.at[0] - self.at[0][i], lamp.at[1] - self.at[1][i], lamp.at[2] - self.at[2][i]];
            let square = to[0] * to[0] + to[1] * to[1] + to[2] * to[2];
            let over = 1.0 / square.sqrt().max(1e-6);
            let to = [to[0] * over, to[1] * over, to[2] * over];
            let beam = (-(to[0] * x + to[1] * y + to[2] * z)).max(0.0) * (1.0 / std::f32::consts::PI);
            let own = if self.rooms[i] == lamp.room { 1.0 } else { 0.0 };
            self.power[i] = own * (even + beam) / (square + lamp.radius * lamp.radius);
            self.cosine[i] = to[0] * self.normal[0][i] + to[1] * self.normal[1][i] + to[2] * self.normal[2][i];
            for k in 0..3 {
                self.to[k][i] = to[k];
            }
        }
        self.shadow(
            lamp.flux,
            #[inline(always)]
            |points, which, share| {
                if plain { share.fill(1.0) } else { lamp.shadows.light(lamp.at, points, which, share) }
            },
        );
    }

    /// Multiplies with the unshadowed share, and adds the light.
    #[inline(always)]
    fn shadow(&mut self, flux: [f32; 3], shares: impl Fn(&Points<'_, BATCH>, &[u32], &mut Lanes)) {
        let (mut which, mut count) = ([0_u32; BATCH], 0);
        for i in 0..self.lanes() {
            self.share[i] = 0.0;
            which[count % BATCH] = i as u32;
            count += usize::from((i < self.count) & (self.cosine[i] > 0.0) & (self.power[i] > 0.0));
        }
        if count == 0 {
            return;
        }
        shares(&Points { at: &self.at, normal: &self.normal }, &which[..count], &mut self.share);
        let mut sum = 0.0;
        for i in 0..self.lanes() {
            self.power[i] *= self.share[i];
            sum += self.share[i];
        }
        if sum > 0.0 {
            self.add(flux);
        }
    }

    /// Adds light from a direction: Lambert's law, and microfacets by Trowbridge and Reitz with Schlick's
    /// approximations.
    #[inline(always)]
    fn add(&mut self, flux: [f32; 3]) {
        let over = 1.0 / std::f32::consts::PI;
        let bright = luminance(flux);
        for i in 0..self.lanes() {
            let (x, y, z) =
                (self.to[0][i] + self.back[0][i], self.to[1][i] + self.back[1][i], self.to[2][i] + self.back[2][i]);
            let scale = 1.0 / (x * x + y * y + z * z + 1e-12).sqrt();
            let nh = (x * self.normal[0][i] + y * self.normal[1][i] + z * self.normal[2][i]) * scale;
            let vh = (x * self.back[0][i] + y * self.back[1][i] + z * self.back[2][i]) * scale;
            let (nh, vh) = (nh.clamp(0.0, 1.0), vh.clamp(0.0, 1.0));
            let nl = self.cosine[i].max(0.0);
            let alpha = self.roughness[i] * self.roughness[i];
            let square = alpha * alpha;
            let bottom = nh * nh * (square - 1.0) + 1.0;
            let k = 0.5 * alpha;
            let shadowing = 0.25 / ((nl * (1.0 - k) + k) * (self.facing[i] * (1.0 - k) + k));
            let lobe = (square * over / (bottom * bottom) * shadowing).min(40.0);
            let edge = 1.0 - vh;
            let edge = edge * edge * edge * edge * edge;
            let fresnel = self.head_on[i] + (1.0 - self.head_on[i]) * edge;
            let share = self.power[i] * nl;
            for c in 0..3 {
                self.light[c][i] += flux[c] * share * (1.0 - 0.96 * edge);
                self.light[c + 3][i] += flux[c] * share * lobe * fresnel;
                self.drift[c][i] += bright * self.power[i] * self.to[c][i];
            }
        }
    }
}
