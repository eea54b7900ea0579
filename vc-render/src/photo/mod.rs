//! The reference picture: paths of light, followed backwards from the eye.
//!
//! At every point light from the sun, from lamps and through panes is looked for directly
//! ([`direct`]), and what a path meets by chance counts with the balance of both ways (multiple
//! importance sampling, Veach 1997); some paths are sent to drawn blinds and curtains ([`cover`]).
//! Surfaces are Lambert's under microfacets ([`scatter`]); what
//! the eye sees through glass is refracted, and what panes reflect is a path of its own
//! ([`glass`]). What noise is left is smoothed along surfaces ([`denoise`]), and pixels at their edges are put together
//! from both sides ([`bridge`]).

mod albedo;
mod bridge;
mod cover;
mod denoise;
mod direct;
mod film;
mod glass;
mod lights;
mod path;
mod sampler;
mod scatter;
mod source;
mod spots;

use rayon::prelude::*;

use crate::RenderError;
use crate::affine::{self, Affine, three};
use crate::camera::Camera;
use crate::label::unit;
use crate::light::Lighting;
use crate::picture::Picture;
use crate::renderer::Renderer;
use crate::shade::{encoded, film};
use crate::trace::Ray;
use cover::Covers;
use film::Traced;
use lights::Lights;
use path::Paths;
use spots::Spots;

pub(crate) use sampler::lattice;
pub(crate) use scatter::{Finish, cosine, frame};

/// How a reference picture is made.
///
/// ```
/// use vc_render::Exposure;
/// let quick = Exposure { samples: 4, ..Exposure::default() };
/// assert!(quick.denoise);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Exposure {
    /// Paths for each pixel.
    pub samples: u32,
    /// Surfaces that throw light at most, from its source to the eye; panes and mirrors do not count.
    pub bounces: u32,
    /// Brightest light that a path may bring by way of a second surface, against middle grey:
    /// brighter is cut off, as it would only be specks. Infinite for no loss at all.
    pub brightest: f32,
    /// Chooses among pictures that differ in their noise.
    pub seed: u32,
    /// Whether noise is smoothed at the end.
    pub denoise: bool,
}

impl Default for Exposure {
    fn default() -> Self {
        Self { samples: 64, bounces: 12, brightest: 20.0, seed: 0, denoise: true }
    }
}

/// A picture by its light.
#[derive(Debug, Clone, PartialEq)]
pub struct Photograph {
    /// Pixels across.
    pub width: usize,
    /// Pixels down.
    pub height: usize,
    /// Radiance, linear RGB, rows from the top, in the units of [`Daylight`](crate::Daylight): 5000 candela per
    /// square metre.
    pub light: Vec<[f32; 3]>,
    exposure: [f32; 3],
}

/// A reference picture in the making.
pub struct Progress<'a> {
    /// Paths for each pixel so far.
    pub rounds: u32,
    traced: &'a [Traced],
    width: usize,
    exposure: [f32; 3],
}

impl Progress<'_> {
    /// The picture so far, not smoothed. Costs some nanoseconds a pixel.
    pub fn photograph(&self) -> Photograph {
        let light: Vec<[f32; 3]> = self.traced.iter().map(Traced::light).collect();
        let height = light.len() / self.width.max(1);
        Photograph { width: self.width, height, light, exposure: self.exposure }
    }
}

impl Photograph {
    /// The picture as film would have it.
    pub fn picture(&self) -> Picture {
        let pixels = self.light.iter().map(|c| encoded(three(|i| film(c[i] * self.exposure[i])))).collect();
        Picture { width: self.width, height: self.height, pixels }
    }
}

/// Rooms of what is seen at places strewn over a picture, through glass.
fn seen_rooms(lighting: &Lighting, camera: &Camera) -> impl Iterator<Item = u16> {
    let pose = Affine::of(&camera.pose).narrow();
    camera.strewn().filter_map(move |[x, y]| {
        let along = unit(affine::vector(&pose, camera.ray(x, y).into()));
        let met = lighting.tracer.first(&Ray { from: camera.eye().into(), along, end: 1e4 })?;
        Some(spots::room(lighting, &met))
    })
}

impl Renderer {
    /// The reference picture of the scene that a lighting was made for.
    ///
    /// `progress` hears after each round of one path for every pixel how many are done, may look at the picture
    /// so far, and may end it by returning false. The picture is the same for any number of
    /// threads. Costs a microsecond or two for each path and surface met.
    ///
    /// # Errors
    /// [`RenderError::BadSize`], [`RenderError::BadCamera`], [`RenderError::OtherRenderer`],
    /// [`RenderError::BadDaylight`].
    pub fn photograph(
        &self,
        lighting: &Lighting,
        camera: &Camera,
        how: &Exposure,
        mut progress: impl FnMut(&Progress<'_>) -> bool,
    ) -> Result<Photograph, RenderError> {
        camera.check()?;
        lighting.check(&self.store)?;
        let (width, height) = (camera.width as usize, camera.height as usize);
        let lights = Lights::of(self, lighting);
        let spots = Spots::of(self, lighting, &lights);
        let covers = Covers::of(lighting);
        let exposure = lighting.exposure(camera.eye().into(), seen_rooms(lighting, camera));
        let paths = Paths {
            renderer: self,
            lighting,
            camera,
            lights: &lights,
            spots: &spots,
            covers: &covers,
            how,
            most: how.brightest / exposure[1],
        };
        let mut traced = vec![Traced::default(); width * height];
        for round in 0..how.samples.max(1) {
            traced.par_chunks_mut(width).enumerate().for_each(|(y, row)| {
                row.iter_mut().enumerate().for_each(|(x, pixel)| pixel.add(&paths.path((x, y), round)));
            });
            if !progress(&Progress { rounds: round + 1, traced: &traced, width, exposure }) {
                break;
            }
        }
        let light = match how.denoise {
            true => denoise::denoised(&traced, width, camera.eye().into()),
            false => traced.iter().map(Traced::light).collect(),
        };
        Ok(Photograph { width, height, light, exposure })
    }
}
