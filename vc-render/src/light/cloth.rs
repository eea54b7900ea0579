//! What goes through blinds and curtains that are drawn: light that comes out on all sides.

use super::room::Seen;
use super::{Lighting, dot};
use crate::affine::three;
use crate::renderer::Renderer;
use crate::surface::{Pattern, Surface};
use crate::trace::{Met, Ray};

/// Shares of light that go on through one face: of cloth, and of slats, between which there are gaps.
const CLOTH: f32 = 0.4;
const SLATS: f32 = 0.15;
/// Width of what is one point of them, metres: as in reference pictures, as threads are darker than cloth from afar.
const NEAR: f32 = 0.002;
/// Faces of a cover that light behind it is looked for through, at most.
const FOLDS: usize = 16;

/// The share of light that goes on through a face that was met; none but of what is drawn over an opening.
pub(crate) fn through(met: &Met<'_>, surface: &Surface) -> f32 {
    match surface.pattern {
        _ if !met.instance.covers() => 0.0,
        Pattern::Weave => CLOTH,
        _ => SLATS,
    }
}

/// What shares of light on one side are thrown back and come out of the other, by colour: through faces, and between
/// them as often as it is thrown back there.
pub(crate) fn parted(met: &Met<'_>, surface: &Surface) -> [[f32; 3]; 2] {
    let (share, colour) = (through(met, surface), met.look(surface, NEAR).colour);
    let (goes, back) = (colour.map(|c| share * c), colour.map(|c| (1.0 - share) * c));
    let out = three(|i| goes[i] * goes[i] / (1.0 - back[i] * back[i]).max(1e-3));
    [three(|i| back[i] + out[i] * back[i]), out]
}

impl Lighting {
    /// What is seen of a cover that is drawn over an opening: what it throws back, and what goes through it of the
    /// light behind it, of which that from about one direction stands for all.
    pub(super) fn past(
        &self,
        renderer: &Renderer,
        (cover, ray): (&Met<'_>, &Ray),
        about: [f32; 3],
        room: usize,
    ) -> Seen {
        let surface = &renderer.store.surfaces[usize::from(cover.face.surface)];
        let ([thrown, share], mean) = (parted(cover, surface), surface.mean());
        let own = self.seen(renderer, cover, room).behind(three(|i| thrown[i] / mean[i].max(1e-3)));
        let behind = self.outside(renderer, (cover, self.far_side(cover, ray)), about, room);
        Seen { direct: three(|i| own.direct[i] + share[i] * behind[i]), ..own }
    }

    /// A place at the far side of a cover that a ray goes through.
    fn far_side(&self, cover: &Met<'_>, ray: &Ray) -> [f32; 3] {
        let step = |at: [f32; 3]| three(|i| at[i] + 1e-3 * ray.along[i]);
        let mut at = step(cover.at);
        for _ in 0..FOLDS {
            let met = self.tracer.first(&Ray { from: at, ..*ray });
            let Some(met) = met.filter(|met| met.instance.body == cover.instance.body) else { break };
            at = step(met.at);
        }
        at
    }

    /// Light that falls on the far side of a cover, over pi: what is seen in a direction, or the one against it, as if
    /// it came from all; and the sun.
    fn outside(
        &self,
        renderer: &Renderer,
        (cover, from): (&Met<'_>, [f32; 3]),
        about: [f32; 3],
        room: usize,
    ) -> [f32; 3] {
        let away = dot(cover.flat, about);
        let along = if away < 0.0 { about } else { about.map(|v| -v) };
        let beyond = self.tracer.first(&Ray { from, along, end: 1e4 });
        let end = beyond.map_or(1e4, |met| met.t);
        let panes = super::pane::passes(renderer, &self.tracer, Ray { from, along, end });
        let light = match beyond {
            Some(met) if dot(met.flat, along) < 0.0 => self.seen(renderer, &met, room).direct,
            Some(_) => [0.0; 3],
            None => self.daylight.radiance(along),
        };
        let towards: [f32; 3] = self.daylight.towards_sun.into();
        let facing = -dot(cover.flat, towards);
        let sunny = facing > 0.0 && !self.tracer.blocked(&Ray { from, along: towards, end: 1e4 });
        let sun = if sunny { self.panes_from(renderer, from) * facing / std::f32::consts::PI } else { 0.0 };
        three(|i| 2.0 * away.abs() * light[i] * panes[i] + self.daylight.sun[i] * sun)
    }
}
