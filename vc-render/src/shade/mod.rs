//! Fast colours.
use crate::frame::{Frame, Strip};
use crate::raster::Layers;
use crate::renderer::Renderer;
use crate::view::View;

/// Light.
#[derive(Debug, Clone)]
pub struct Lighting {}

#[derive(Default)]
pub(crate) struct Scratch {}

pub(crate) fn shade(_: &Renderer, _: &Lighting, _: View<'_>, _: &mut Layers, _: &mut Scratch, _: &mut Strip<'_>) {}
pub(crate) fn finish(_: &Lighting, _: View<'_>, _: &mut Frame) {}
