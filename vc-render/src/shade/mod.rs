//! Fast colours: a picture from the buffer of visible triangles.
//!
//! First every pixel's surface is written down ([`surfel`]), with what is clear in front
//! of it; then, at half the resolution, the light from all sides and how much of it nearby
//! things keep away ([`around`]); then direct light ([`light`]), mirrors and glass; at
//! last edges are smoothed ([`edge`]) and light becomes colours ([`tone`]).

mod around;
mod edge;
mod light;
mod look;
mod surfel;
mod tone;

pub(crate) use around::Around;
pub(crate) use look::{Look, look};
pub(crate) use surfel::{Scratch, Surfel};
pub(crate) use tone::{encoded, film};

use crate::frame::{Band, Frame, Strip};
use crate::light::Lighting;
use crate::renderer::Renderer;
use crate::view::View;

/// Writes down the surfaces of a band, and where its edges are.
pub(crate) fn shade(renderer: &Renderer, view: View<'_>, band: &mut Band, strip: &mut Strip<'_>) {
    crate::simd::widest(
        #[inline(always)]
        || surfel::surfels(renderer, view, &band.layers, &mut band.shading, strip),
    );
    edge::edges(view, &band.layers, &mut band.shading, strip);
}

/// Light on surfaces, and colours.
pub(crate) fn finish(renderer: &Renderer, lighting: &Lighting, view: View<'_>, frame: &mut Frame) {
    around::occlusion(view, frame);
    around::around(lighting, view, frame);
    light::light(renderer, lighting, view, frame);
    for band in &frame.memory.bands {
        let extra = light::Extra { renderer, lighting, view, surfels: &frame.surfels };
        band.shading.mirrors.iter().for_each(|pixel| extra.mirror(*pixel, &mut frame.light));
        band.shading.panes.iter().for_each(|pane| extra.pane(pane, &mut frame.light));
    }
    tone::colours(frame, lighting.exposure(view.camera.eye().into()));
}
