//! The reference picture: path tracing from the camera.
//!
//! At every hit, light from the sun, from lamps and through panes is sampled directly ([`direct`]) and combined
//! with chance hits by the balance heuristic (multiple importance sampling, Veach 1997); some paths are sent to
//! drawn blinds and curtains ([`cover`]). Surfaces are Lambertian under microfacets
//! ([`Scatter`](crate::surface::Scatter)). View rays through glass are refracted, and reflections of panes are separate
//! paths ([`glass`]). Remaining noise is smoothed along surfaces ([`denoise`]), separately for the surfaces of a pixel
//! ([`film`]); isolated pixels take light from around them ([`alone`]).

mod alone;
mod cover;
mod denoise;
mod direct;
mod film;
mod glass;
mod lights;
mod path;
mod sampler;
mod source;
mod spots;
mod walk;

use rayon::prelude::*;

use crate::bvh::Ray;
use crate::camera::Camera;
use crate::colour::{displayed, encoded};
use crate::light::{Lighting, Patch, Spot};
use crate::math::{self, Affine, unit};
use crate::picture::Picture;
use crate::scene::Store;
use cover::Covers;
use film::Pixel;
use lights::Lights;
use path::Paths;
use spots::Spots;

/// Settings of a reference picture.
///
/// ```
/// # use nalgebra::{Point3, Vector3};
/// # use vc_graph::{Bounds, Draft, Pose, SceneBuilder};
/// use vc_render::{Camera, Daylight, PathTracing, Renderer};
/// # let mut scene = SceneBuilder::new("flat");
/// # let kitchen = scene.add(Draft::new("kitchen"))?;
/// # let size = Bounds::standing(Vector3::new(0.6, 0.6, 1.8));
/// # let fridge = scene.add_in(kitchen, Draft::new("fridge").at(Pose::translation(2.0, 0.0, 0.0)).bounds(size))?;
/// # let scene = scene.build();
/// # let mut renderer = Renderer::new();
/// # let snapshot = renderer.snapshot(&scene)?;
/// # let lighting = renderer.light(&snapshot, &Daylight::noon());
/// # let camera = Camera::with_fov(16, 12, 1.0).looking(Point3::new(0.0, 0.0, 1.0), Point3::new(2.0, 0.0, 1.0));
/// let quick = PathTracing { samples: 2, bounces: 3, ..PathTracing::default() };
/// let reference_picture = renderer.reference_picture(&lighting, &camera, &quick, |_| true)?;
/// // The same light with different noise.
/// let other = renderer.reference_picture(&lighting, &camera, &PathTracing { seed: 1, ..quick }, |_| true)?;
/// assert_eq!(reference_picture.light.len(), other.light.len());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PathTracing {
    /// Number of paths for each pixel.
    pub samples: u32,
    /// Greatest number of surfaces that reflect light on its way from its source to the camera; panes and
    /// mirrors do not count.
    pub bounces: u32,
    /// Greatest brightness that a path may contribute by way of a second surface, relative to middle grey;
    /// brighter contributions are cut off, as they would only be fireflies. Infinite for no loss at all; a
    /// negative number counts as zero.
    pub brightest: f32,
    /// Random seed: it changes only the noise.
    pub seed: u32,
    /// Whether the final picture is denoised.
    pub denoise: bool,
}

impl Default for PathTracing {
    fn default() -> Self {
        Self { samples: 64, bounces: 12, brightest: 20.0, seed: 0, denoise: true }
    }
}

/// The light of a reference picture, made by [`Renderer::reference_picture`](crate::Renderer::reference_picture).
///
/// ```
/// # use nalgebra::{Point3, Vector3};
/// # use vc_graph::{Bounds, Draft, Pose, SceneBuilder};
/// use vc_render::{Camera, Daylight, PathTracing, Renderer, picture};
/// # let mut scene = SceneBuilder::new("flat");
/// # let kitchen = scene.add(Draft::new("kitchen"))?;
/// # let size = Bounds::standing(Vector3::new(0.6, 0.6, 1.8));
/// # let fridge = scene.add_in(kitchen, Draft::new("fridge").at(Pose::translation(2.0, 0.0, 0.0)).bounds(size))?;
/// # let scene = scene.build();
/// # let mut renderer = Renderer::new();
/// # let snapshot = renderer.snapshot(&scene)?;
/// # let lighting = renderer.light(&snapshot, &Daylight::noon());
/// # let camera = Camera::with_fov(16, 12, 1.0).looking(Point3::new(0.0, 0.0, 1.0), Point3::new(2.0, 0.0, 1.0));
/// let how = PathTracing { samples: 2, ..PathTracing::default() };
/// let reference_picture = renderer.reference_picture(&lighting, &camera, &how, |_| true)?;
/// // Luminance of the sky in the corner, candela per square metre (Rec. 709).
/// let [red, green, blue] = reference_picture.light[0];
/// assert!(5000.0 * (0.2126 * red + 0.7152 * green + 0.0722 * blue) > 100.0);
/// let file = picture::png(&reference_picture.picture())?;
/// assert!(!file.is_empty());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct ReferencePicture {
    /// Pixels across.
    pub width: usize,
    /// Pixels down.
    pub height: usize,
    /// Radiance, linear RGB, rows from the top, in the units of [`Daylight`](crate::Daylight): 5000 candela per
    /// square metre.
    pub light: Vec<[f32; 3]>,
    exposure: [f32; 3],
}

/// A reference picture in the making, which [`Renderer::reference_picture`](crate::Renderer::reference_picture) passes
/// on after each round.
///
/// ```
/// # use nalgebra::{Point3, Vector3};
/// # use vc_graph::{Bounds, Draft, Pose, SceneBuilder};
/// use vc_render::{Camera, Daylight, PathTracing, Renderer};
/// # let mut scene = SceneBuilder::new("flat");
/// # let kitchen = scene.add(Draft::new("kitchen"))?;
/// # let size = Bounds::standing(Vector3::new(0.6, 0.6, 1.8));
/// # let fridge = scene.add_in(kitchen, Draft::new("fridge").at(Pose::translation(2.0, 0.0, 0.0)).bounds(size))?;
/// # let scene = scene.build();
/// # let mut renderer = Renderer::new();
/// # let snapshot = renderer.snapshot(&scene)?;
/// # let lighting = renderer.light(&snapshot, &Daylight::noon());
/// # let camera = Camera::with_fov(16, 12, 1.0).looking(Point3::new(0.0, 0.0, 1.0), Point3::new(2.0, 0.0, 1.0));
/// let how = PathTracing { samples: 64, denoise: false, ..PathTracing::default() };
/// let mut sketch = None;
/// let made = renderer.reference_picture(&lighting, &camera, &how, |so_far| {
///     sketch = Some(so_far.reference_picture());
///     so_far.rounds < 2 // that is enough
/// })?;
/// assert_eq!(sketch, Some(made));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct RenderProgress<'a> {
    /// Number of paths for each pixel so far.
    pub rounds: u32,
    traced: &'a [Pixel],
    width: usize,
    exposure: [f32; 3],
}

impl RenderProgress<'_> {
    /// The picture so far, not denoised. Linear in the pixels; a path costs far more.
    pub fn reference_picture(&self) -> ReferencePicture {
        let light: Vec<[f32; 3]> = self.traced.iter().map(Pixel::light).collect();
        let height = light.len() / self.width.max(1);
        ReferencePicture { width: self.width, height, light, exposure: self.exposure }
    }
}

impl ReferencePicture {
    /// The displayable picture: exposed for the rooms in view, with bright light compressed like fast colours
    /// (Naka and Rushton 1966). Costs two powers for each pixel.
    pub fn picture(&self) -> Picture {
        let pixels = self.light.iter().map(|c| encoded(displayed(*c, self.exposure))).collect();
        Picture { width: self.width, height: self.height, pixels }
    }
}

/// Meters the light at pixels scattered over a picture, of opaque surfaces, including those seen through glass.
fn metered<'a>(store: &'a Store, lighting: &'a Lighting, camera: &Camera) -> impl Iterator<Item = Spot> + 'a {
    let (pose, eye) = (Affine::from_pose(&camera.pose).narrow(), camera.eye().into());
    let rays: Vec<[f32; 3]> =
        camera.scattered_pixels().map(|[x, y]| math::vector(&pose, camera.ray(x, y).into())).collect();
    rays.into_iter().filter_map(move |ray| {
        let along = unit(ray);
        let hit = lighting.tracer.first(&Ray { from: eye, along, end: 1e4 })?.facing(along.map(|v| -v));
        Some(lighting.metered(&Patch {
            surface: &store.surfaces[usize::from(hit.face.surface)],
            coat: &hit.instance.coat,
            body: hit.instance.body,
            at: hit.at,
            normal: hit.normal,
            room: spots::room(lighting, &hit),
        }))
    })
}

/// Traces the reference picture of a lighting's scene; `progress` is called after each round of one path for every
/// pixel.
pub(crate) fn traced(
    store: &Store,
    lighting: &Lighting,
    camera: &Camera,
    how: &PathTracing,
    mut progress: impl FnMut(&RenderProgress<'_>) -> bool,
) -> ReferencePicture {
    let (width, height) = (camera.width as usize, camera.height as usize);
    let lights = Lights::new(store, lighting);
    let spots = Spots::new(store, lighting, &lights);
    let covers = Covers::new(lighting);
    let exposure = lighting.exposure(camera.eye().into(), metered(store, lighting, camera));
    let paths = Paths {
        store,
        lighting,
        camera,
        lights: &lights,
        spots: &spots,
        covers: &covers,
        how,
        most: how.brightest.max(0.0) / exposure[1],
    };
    let eye = camera.eye().into();
    let mut traced = vec![Pixel::default(); width * height];
    for round in 0..how.samples.max(1) {
        traced.par_chunks_mut(width).enumerate().for_each(|(y, row)| {
            row.iter_mut().enumerate().for_each(|(x, pixel)| pixel.add(&paths.path((x, y), round), eye));
        });
        if !progress(&RenderProgress { rounds: round + 1, traced: &traced, width, exposure }) {
            break;
        }
    }
    let light = match how.denoise {
        true => denoise::denoised(&traced, width, eye),
        false => traced.iter().map(Pixel::light).collect(),
    };
    ReferencePicture { width, height, light, exposure }
}
