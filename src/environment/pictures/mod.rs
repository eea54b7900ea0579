//! Pictures of an environment, and the cache that they are made from.

mod camera;
mod cameras;
mod joined;
mod json_fault;
mod lens;
mod light;
mod mount;
mod options;
mod rays;
mod register;
mod stage;

use std::collections::BTreeMap;
use std::sync::{Mutex, OnceLock};

use vc_graph::{Label, NodeId, Pose};
use vc_render::{Frame, Lighting, Modalities, Modality, RayCaster, RenderError, Renderer, Shot, Snapshot};

pub use self::camera::Viewpoint;
pub(crate) use self::camera::{GLANCE, sight_of};
pub(in crate::environment) use self::cameras::Cameras;
pub use self::cameras::{CameraError, CameraId, NamedCamera, PictureError};
pub(crate) use self::joined::{Beside, JoinedHomes};
pub use self::json_fault::JsonFault;
pub use self::lens::Lens;
use self::light::Lit;
pub use self::mount::Mount;
pub use self::options::PictureOptions;
pub(crate) use self::register::{Named, Register};
pub(crate) use self::stage::Extent;
use self::stage::Stage;
use crate::Environment;

/// By which share of the way rooms seen from above are made as bright as each other.
const EVEN: f32 = 0.9;

/// Uploaded meshes and the light, made when first asked for and shared by clones.
#[derive(Debug, Default)]
pub(crate) struct PictureCache {
    base: OnceLock<Result<Base, RenderError<Label>>>,
    /// Light that was made, the last one first.
    light: Mutex<Vec<(Lit, Lighting)>>,
    /// At which of its places the camera of a room is.
    corners: Mutex<BTreeMap<NodeId, usize>>,
    /// Rays in the home as it begins.
    rays: Mutex<Option<RayCaster>>,
}

#[derive(Debug)]
struct Base {
    renderer: Renderer,
    stage: Stage,
}

impl Environment {
    /// A picture of the environment as it is, made as its [`pictures`](Self::pictures) say: `Renderer::render` of its
    /// [`snapshot`](Self::snapshot). Changes nothing, and does not depend on earlier pictures.
    ///
    /// Things that have moved, were opened or are carried are lit where they are, by the room they are in, and throw
    /// their shadows from there: `Renderer::follow`, some milliseconds where that is in the sun or below a lamp, and
    /// less than one elsewhere. Indirect light is that of the home as it begins. `Renderer::light` makes
    /// it again when something is switched, when a door between rooms or a window comes to stand open or shut, when a
    /// blind or a curtain is drawn, when a lamp that is on is moved, and for another daylight. That takes about a
    /// second of processor time in a home of 450 nodes; the last few results are kept. It does not change because furniture or people moved:
    /// [`render_relit`](Self::render_relit) makes it anew for that, too. `benches/README.md` has the costs.
    ///
    /// From above each room is seen about as bright as it is to a person in it: `Lighting::equalized`. From all other
    /// viewpoints a room without a window whose lamps are off is dim: it has the light that comes through its doorways,
    /// and around doors that are closed. In the evening people have lamps on:
    /// [`switch_lamps`](Self::switch_lamps).
    /// Optical flow needs a second moment: see [`render_until`](Self::render_until).
    ///
    /// # Errors
    /// [`PictureError`]: no such viewpoint, a bad size, no such node, or flow, for which there is no second
    /// moment.
    pub fn render(
        &self,
        view: Viewpoint,
        wanted: impl Into<Modalities>,
        width: u32,
        height: u32,
    ) -> Result<Frame, PictureError> {
        self.picture(&self.pictures, None, (view, wanted.into()), (width, height))
    }

    /// As [`render`](Self::render), with light that is made for where everything is now: indirect light follows furniture
    /// and people too. Takes about a second of processor time for every picture with colours, and nothing is kept; without
    /// colours it does the same as `render`.
    ///
    /// ```no_run
    /// use virtualcity::{Environment, Viewpoint, render::Modality};
    /// let home = Environment::make("apartment/42", 1)?;
    /// let room = home.graph().rooms()[0];
    /// let still = home.render_relit(Viewpoint::Room(room), Modality::Rgb, 640, 480)?;
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`render`](Self::render).
    pub fn render_relit(
        &self,
        view: Viewpoint,
        wanted: impl Into<Modalities>,
        width: u32,
        height: u32,
    ) -> Result<Frame, PictureError> {
        let anew = |now: &Snapshot| Ok(self.base()?.renderer.light(now, &self.pictures.daylight));
        self.picture_lit(&self.pictures, None, (view, wanted.into()), (width, height), anew)
    }

    /// As [`render`](Self::render), with the optical flow from this moment to a later one of
    /// the same environment: of the camera, of bodies and of every limb.
    ///
    /// # Errors
    /// As [`render`](Self::render); [`RenderError::OtherScene`] if things were added or
    /// removed in between.
    pub fn render_until(
        &self,
        later: &Self,
        view: Viewpoint,
        wanted: impl Into<Modalities>,
        width: u32,
        height: u32,
    ) -> Result<Frame, PictureError> {
        self.picture(&self.pictures, Some(later), (view, wanted.into()), (width, height))
    }

    /// A picture by these options.
    pub(crate) fn picture(
        &self,
        how: &PictureOptions,
        later: Option<&Self>,
        what: (Viewpoint, Modalities),
        size: (u32, u32),
    ) -> Result<Frame, PictureError> {
        self.picture_lit(how, later, what, size, |now| self.lighting(&how.daylight, now))
    }

    fn picture_lit(
        &self,
        how: &PictureOptions,
        later: Option<&Self>,
        (view, wanted): (Viewpoint, Modalities),
        (width, height): (u32, u32),
        light: impl Fn(&Snapshot) -> Result<Lighting, RenderError<Label>> + Send,
    ) -> Result<Frame, PictureError> {
        let drawn = self.threads.run(|| self.drawn(how, later, (view, wanted), (width, height), light));
        drawn.map_err(|error| match error {
            PictureError::Render(error) => self.named(error).into(),
            other => other,
        })
    }

    fn drawn(
        &self,
        how: &PictureOptions,
        later: Option<&Self>,
        (view, wanted): (Viewpoint, Modalities),
        (width, height): (u32, u32),
        light: impl Fn(&Snapshot) -> Result<Lighting, RenderError<Label>>,
    ) -> Result<Frame, PictureError> {
        let base = self.base()?;
        let (snapshot, camera) = (self.snapshot()?, self.camera(view, width, height)?);
        let then = later.map(|l| Ok::<_, PictureError>((l.snapshot()?, l.camera(view, width, height)?))).transpose()?;
        let lighting = if wanted.has(Modality::Rgb) { Some(light(&snapshot)?) } else { None };
        let lighting = lighting.map(|light| if self.is_plan(view) { light.equalized(EVEN) } else { light });
        let mut shot = Shot::new(&snapshot, &camera, wanted).supersampled(how.finer);
        (shot.lighting, shot.adaptation) = (lighting.as_ref(), how.adapts);
        if let Some((snapshot, camera)) = &then {
            shot = shot.after(snapshot, camera);
        }
        let mut frame = Frame::new();
        base.renderer.render(&shot, &mut frame)?;
        Ok(frame)
    }

    /// The environment as it is for the renderer: `Renderer::snapshot_with` once, then
    /// `Snapshot::place`, `enter`, `articulate`, `arrange`, `switch`, `coat`, `fill`, `draw` and `hide` of what differs.
    ///
    /// # Errors
    /// [`RenderError`] if something has no sound pose or no shape.
    pub fn snapshot(&self) -> Result<Snapshot, RenderError<Label>> {
        self.as_now().map_err(|e| self.named(e))
    }

    /// A renderer's error with the labels of the scene.
    fn named(&self, error: impl Into<RenderError<Label>>) -> RenderError<Label> {
        error.into().named(&|label: Label| self.graph().label(label.id))
    }

    fn as_now(&self) -> Result<Snapshot, RenderError<Label>> {
        Ok(self.base()?.stage.now(self)?)
    }

    /// The room around a thing's new place; over no floor, the room that the graph has it in.
    fn room_of_place(&self, id: NodeId, at: &Pose) -> Option<NodeId> {
        self.room_at(at.translation.vector.xy().into()).or_else(|| self.graph().room_of(id))
    }

    fn base(&self) -> Result<&Base, RenderError<Label>> {
        let base = self.picture_cache().base.get_or_init(|| Base::of(self).map_err(|e| self.named(e)));
        base.as_ref().map_err(Clone::clone)
    }
}

impl Base {
    fn of(environment: &Environment) -> Result<Self, RenderError> {
        let mut renderer = Renderer::new();
        let stage = Stage::new(environment, &mut renderer, Extent::Whole)?;
        Ok(Self { renderer, stage })
    }
}
