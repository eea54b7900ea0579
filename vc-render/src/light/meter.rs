//! The exposure of pictures, metered from the light in view.

use arrayvec::ArrayVec;
use vc_graph::portable::Portable;

use super::Lighting;
use crate::camera::SCATTERED_PIXELS;
use crate::colour::{luminance, night};
use crate::math::three;
use crate::surface::{Coat, Surface};

/// How far the white balance goes towards the colour of the room's light: lamplight stays warm, but does not
/// turn everything yellow.
const BALANCE: f32 = 0.6;
/// Greatest factor by which a room counts as brighter than the mean of all rooms in view.
const BRIGHTER: f32 = 4.0;
/// Light levels below which the exposure does not adapt: in rooms, and outside.
const DARK: [f32; 2] = [1e-7, 5e-4];
/// The light level below which the exposure adapts only partly, so that dim rooms look dim, and the exponent of
/// this adaptation.
const DIM: f32 = 0.01;
const PART: f32 = 0.75;
/// The light level below which the exposure adapts fully again: pictures of darkness are displayed darker
/// instead, windows included.
const GLOOM: f32 = 1e-4;
/// Light levels below this share of the mean in view count as black: the exposure does not adapt to them.
const BLACK: f32 = 1e-3;
/// Exposure times light level: the display of a grey surface in the room's light.
const GREY: f32 = 0.8;
/// Luminance of what is usually in view, relative to the room's light level.
const USUAL: f32 = 0.8;
/// Greatest factor by which a spot of the view counts as brighter or darker than the room.
const SPREAD: f32 = 50.0;
/// How far the exposure goes from the one for the room to the one for what is in view: a dark bookcase stays darker
/// than a white wall, but is readable.
const METERED: f32 = 0.45;
/// Limits of the factor by which it changes the exposure.
const LIMITS: [f32; 2] = [0.5, 2.5];

/// A spot of a view at which its light is metered.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Spot {
    /// The room whose light falls on it.
    pub(crate) room: u16,
    pub(crate) luminance: f32,
}

/// A surface at a spot of a view.
pub(crate) struct Patch<'a> {
    pub(crate) surface: &'a Surface,
    pub(crate) coat: &'a Coat,
    pub(crate) body: u32,
    pub(crate) at: [f32; 3],
    /// Unit normal on the side that is seen.
    pub(crate) normal: [f32; 3],
    pub(crate) room: u16,
}

impl Lighting {
    /// Meters the light of a surface, without its gloss and the details of its texture.
    pub(crate) fn metered(&self, patch: &Patch<'_>) -> Spot {
        let &Patch { surface, coat, body, at, normal, room } = patch;
        let (around, direct) = (self.around(at, normal, room), self.direct(at, normal, room, self.sunlight(room)));
        let colour = surface.reflected(coat);
        let falls = three(|i| colour[i] * (around[i] + direct[i]));
        let own = self.glow(surface, body);
        Spot { room, luminance: luminance(falls) * std::f32::consts::FRAC_1_PI + luminance(own) }
    }

    /// The exposure: factors that bring the light in view to a picture's middle grey, and its colour part of
    /// the way to white. They are computed from the light of the rooms in view, weighted by the visible share
    /// of each, so that they change with the view and do not jump in a doorway; if no room is in view, from the
    /// light of the camera's own room. In dim light they go part of the way only. The view makes a picture
    /// that would be darker or brighter than usual lighter or darker, by the larger part.
    pub(crate) fn exposure(&self, eye: [f32; 3], seen: impl IntoIterator<Item = Spot>) -> [f32; 3] {
        // Seen from inside, the outside does not count, so that a piece of sunny balcony does not darken the
        // room.
        let outdoors = self.room_for(eye) + 1 == self.rooms.len();
        let number = |spot: &Spot| usize::from(spot.room).min(self.rooms.len() - 1);
        let inside = |spot: &Spot| outdoors || number(spot) + 1 < self.rooms.len();
        let spots: ArrayVec<Spot, SCATTERED_PIXELS> = seen.into_iter().filter(inside).take(SCATTERED_PIXELS).collect();
        let mut levels: ArrayVec<_, SCATTERED_PIXELS> = spots.iter().map(|spot| self.level(number(spot))).collect();
        if levels.is_empty() {
            levels.push(self.level(self.room_for(eye)));
        }
        let level = mean(&levels, DARK[usize::from(outdoors)]);
        let adapted = adapted(level);
        let count = levels.len() as f32;
        let colour = levels.iter().fold([0.0; 3], |sum, (_, c)| {
            let share = 1.0 / luminance(*c);
            three(|i| sum[i] + share * c[i])
        });
        // In darkness eyes see little colour, and the sky's blue tells of the night.
        let balance = BALANCE * night(GREY / adapted);
        let metered = looks(level, &spots).power(-METERED).clamp(LIMITS[0], LIMITS[1]);
        three(|c| metered * GREY / adapted / (colour[c] / count).max(0.1).power(balance))
    }

    /// Light level of a room: mean radiance of grey surfaces, indirect and straight from its lamps; and the
    /// colour of this light.
    pub(super) fn level(&self, room: usize) -> (f32, [f32; 3]) {
        let lamps = self.lamps.iter().filter(|l| usize::from(l.room) == room);
        let own = lamps.fold([0.0; 3], |sum, lamp| three(|c| sum[c] + lamp.flux[c]));
        let (grid, share) = (&self.grids[room], 0.25 / (self.floor(room) * 4.0).max(1.0));
        (grid.middling + luminance(own) * share, three(|c| grid.colour[c] + own[c] * share + 1e-6))
    }

    /// The room for whose light a picture is exposed: the one that the camera is in; seen from above, the one
    /// below if it fills half of the view, otherwise the largest.
    fn room_for(&self, eye: [f32; 3]) -> usize {
        if let Some(around) = self.room_around(eye) {
            return around;
        }
        let outside = self.rooms.len() - 1;
        let over = |i: &usize| {
            let (low, high) = self.rooms[*i];
            (0..2).all(|k| eye[k] >= low[k] && eye[k] <= high[k])
        };
        let by_floor = |a: &usize, b: &usize| self.floor(*a).total_cmp(&self.floor(*b));
        let fills = |i: &usize| {
            let (low, high) = self.rooms[*i];
            (high[0] - low[0]).max(high[1] - low[1]) >= 0.65 * (eye[2] - high[2])
        };
        let under = || (0..outside).filter(|i| over(i) && fills(i)).min_by(by_floor);
        let is_above = (0..outside).any(|i| over(&i) && eye[2] > self.rooms[i].1[2]);
        let seen = if is_above { under().or_else(|| (0..outside).max_by(by_floor)) } else { None };
        seen.unwrap_or(outside)
    }
}

/// The mean of the light levels in view, at least `dark`.
fn mean(levels: &[(f32, [f32; 3])], dark: f32) -> f32 {
    let count = levels.len() as f32;
    let dark = dark.max(BLACK * levels.iter().map(|(level, _)| level / count).sum::<f32>());
    let first = levels[0].0.max(dark);
    // Taken relative to the first level, so that the mean of equal levels is exactly that level.
    let off = levels.iter().map(|(level, _)| (level.max(dark) / first).logarithm()).sum::<f32>() / count;
    let most = BRIGHTER * first * off.exponential();
    (levels.iter().map(|(level, _)| level.min(most)).sum::<f32>() / count).max(dark)
}

/// The light level that eyes adapt to in a room's light.
fn adapted(level: f32) -> f32 {
    let part = |level: f32| DIM * (level / DIM).power(PART);
    match level {
        l if l < GLOOM => part(GLOOM) * l / GLOOM,
        l if l < DIM => part(l),
        l => l,
    }
}

/// How bright the view is, relative to what is usual in rooms of this light level.
fn looks(level: f32, spots: &[Spot]) -> f32 {
    let bright = |spot: &Spot| (spot.luminance / level).clamp(1.0 / SPREAD, SPREAD).logarithm();
    let sum = spots.iter().map(bright).sum::<f32>();
    if spots.is_empty() { 1.0 } else { (sum / spots.len() as f32).exponential() / USUAL }
}
