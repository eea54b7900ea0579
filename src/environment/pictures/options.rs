//! Options for rendering pictures of an environment.

use vc_render::{Adaptation, Daylight};

use crate::Environment;

/// Options for rendering an environment's pictures: daylight, anti-aliasing and the adaptation of the eye.
///
/// ```no_run
/// use virtualcity::render::{Daylight, Modality};
/// use virtualcity::{Environment, PictureOptions, Viewpoint};
/// let mut home = Environment::make("apartment/42", 1)?;
/// // Half past seven in the evening, anti-aliased by four colour samples per pixel.
/// home.set_pictures(PictureOptions { daylight: Daylight::at(19.5), finer: 2, ..PictureOptions::default() });
/// let room = home.graph().rooms()[0];
/// let evening = home.render(Viewpoint::Room(room), Modality::Rgb, 640, 480)?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PictureOptions {
    /// The light outside: [`Daylight::noon`] by default, [`Daylight::at`] an hour, or any other.
    pub daylight: Daylight,
    /// The supersampling factor along each side for colours, which smooths edges (anti-aliasing); 1 by default.
    /// Colours cost the square of this factor; labels stay as they are.
    pub finer: u32,
    /// The light to which the eye is adapted; by default the light of the picture itself. Set it for films, in
    /// which the brightness must not jump.
    pub adapts: Option<Adaptation>,
}

impl Default for PictureOptions {
    fn default() -> Self {
        Self { daylight: Daylight::noon(), finer: 1, adapts: None }
    }
}

impl Environment {
    /// The options with which [`render`](Self::render) makes pictures.
    pub fn pictures(&self) -> &PictureOptions {
        &self.pictures
    }

    /// Sets the options with which [`render`](Self::render) makes pictures from now on, in this environment and
    /// in later clones. Neither the state of the home nor the [`digest`](Self::digest) depends on them. Costs
    /// nothing; light is computed anew for another daylight.
    pub fn set_pictures(&mut self, options: PictureOptions) {
        self.pictures = options;
    }
}
