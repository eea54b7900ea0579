//! Options for rendering pictures of an environment.

use vc_render::{Adaptation, Daylight};

use super::camera::FIELD;
use crate::Environment;

/// Options for rendering an environment's pictures: daylight, anti-aliasing, the adaptation of the eye, and the lenses of
/// its viewpoints.
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
    /// The vertical field of view of agents' eyes and of cameras in rooms, radians; 1.15 by default. A picture fails with
    /// [`RenderError::BadCamera`](vc_render::RenderError::BadCamera) unless it is above 0 and below half a turn.
    pub field_of_view: f32,
    /// The height of a standing agent's eyes above the floor, metres, such as that of a robot's camera; by default that
    /// of its head. Only pictures follow it; bodies see and reach as they did. A picture through eyes fails with
    /// [`RenderError::BadCamera`](vc_render::RenderError::BadCamera) unless it is above 0 and at most 10.
    pub eye_height: Option<f32>,
}

impl Default for PictureOptions {
    fn default() -> Self {
        Self { daylight: Daylight::noon(), finer: 1, adapts: None, field_of_view: FIELD, eye_height: None }
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
