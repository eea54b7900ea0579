//! How pictures of an environment are made.

use vc_render::{Adaptation, Daylight};

use crate::Environment;

/// How an environment's pictures are made: the light outside, smooth edges, and what the eye is used to.
///
/// ```no_run
/// use virtualcity::render::{Daylight, Modality};
/// use virtualcity::{Environment, PictureOptions, Viewpoint};
/// let mut home = Environment::make("apartment/42", 1)?;
/// // Half past seven in the evening, edges smoothed by four colours for each pixel.
/// home.set_pictures(PictureOptions { daylight: Daylight::at(19.5), finer: 2, ..PictureOptions::default() });
/// let room = home.graph().rooms()[0];
/// let evening = home.render(Viewpoint::Room(room), Modality::Rgb, 640, 480)?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PictureOptions {
    /// The light outside: [`Daylight::noon`] by default, [`Daylight::at`] an hour, or any other.
    pub daylight: Daylight,
    /// How many times finer colours are made along each side before they are shrunk, which smooths edges
    /// (anti-aliasing); 1 by default. Colours cost that number's square times as much; labels stay as they are.
    pub finer: u32,
    /// The light that the eye is used to; by default the light that it sees. For films, in which light is not to
    /// jump.
    pub adapts: Option<Adaptation>,
}

impl Default for PictureOptions {
    fn default() -> Self {
        Self { daylight: Daylight::noon(), finer: 1, adapts: None }
    }
}

impl Environment {
    /// How [`render`](Self::render) makes pictures.
    pub fn pictures(&self) -> &PictureOptions {
        &self.pictures
    }

    /// Sets how [`render`](Self::render) makes pictures from now on, here and in clones made later. Neither the state
    /// of the home nor the [`digest`](Self::digest) depends on it. Costs nothing; light is made anew for another
    /// daylight.
    pub fn set_pictures(&mut self, options: PictureOptions) {
        self.pictures = options;
    }
}
