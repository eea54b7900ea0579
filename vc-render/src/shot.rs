//! Views and shots: which scene is rendered, from which camera, with which modalities.

use crate::RenderError;
use crate::camera::Camera;
use crate::light::Lighting;
use crate::math::three;
use crate::modality::{Modalities, Modality};
use crate::scene::{Snapshot, Store};

/// A camera and the scene before it.
///
/// ```
/// # use nalgebra::{Point3, Vector3};
/// # use vc_graph::{Bounds, Draft, Pose, SceneBuilder};
/// use vc_render::{Camera, Frame, Modality, Renderer, Shot, View};
/// # let mut scene = SceneBuilder::new("flat");
/// # let kitchen = scene.add(Draft::new("kitchen"))?;
/// # let size = Bounds::standing(Vector3::new(0.6, 0.6, 1.8));
/// # let fridge = scene.add_in(kitchen, Draft::new("fridge").at(Pose::translation(2.0, 0.0, 0.0)).bounds(size))?;
/// # let scene = scene.build();
/// # let mut renderer = Renderer::new();
/// # let snapshot = renderer.snapshot(&scene)?;
/// # let camera = Camera::with_fov(64, 48, 1.0).looking(Point3::new(0.0, 0.0, 1.0), Point3::new(2.0, 0.0, 1.0));
/// // A stereo pair.
/// let other = camera.looking(Point3::new(0.0, -0.065, 1.0), Point3::new(2.0, -0.065, 1.0));
/// let left = Shot::new(&snapshot, &camera, Modality::Depth);
/// let right = Shot { view: View { camera: &other, ..left.view }, ..left };
/// let mut frames = [Frame::new(), Frame::new()];
/// renderer.render_all(&[left, right], &mut frames)?;
/// assert!(frames.iter().all(|frame| (frame.depth[24 * 64 + 32] - 1.7).abs() < 1e-4));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy)]
pub struct View<'a> {
    /// The scene at that moment.
    pub snapshot: &'a Snapshot,
    /// The camera that looks at it.
    pub camera: &'a Camera,
}

/// One picture to render: a view, the views before and after it for optical flow, the light for colours, and
/// the wanted modalities.
///
/// ```
/// # use nalgebra::{Point3, Vector3};
/// # use vc_graph::{Bounds, Draft, Pose, SceneBuilder};
/// use vc_render::{Camera, Frame, Modality, Renderer, Shot};
/// # let mut scene = SceneBuilder::new("flat");
/// # let kitchen = scene.add(Draft::new("kitchen"))?;
/// # let size = Bounds::standing(Vector3::new(0.6, 0.6, 1.8));
/// # let fridge = scene.add_in(kitchen, Draft::new("fridge").at(Pose::translation(2.0, 0.0, 0.0)).bounds(size))?;
/// # let scene = scene.build();
/// # let mut renderer = Renderer::new();
/// # let snapshot = renderer.snapshot(&scene)?;
/// # let camera = Camera::with_fov(64, 48, 1.0).looking(Point3::new(0.0, 0.0, 1.0), Point3::new(2.0, 0.0, 1.0));
/// let mut next = snapshot.clone();
/// next.place(fridge, &Pose::translation(2.0, 0.1, 0.0))?;
/// let wanted = Modality::FlowForward | Modality::Occlusion;
/// let mut frame = Frame::new();
/// renderer.render(&Shot::new(&snapshot, &camera, wanted).after(&next, &camera), &mut frame)?;
/// // A tenth of a metre to the left, 1.7 metres away.
/// let [right, down] = frame.flow_forward[24 * 64 + 32];
/// assert!((right + 2.58).abs() < 0.02 && down.abs() < 0.01);
/// assert_eq!(frame.occluded_forward[24 * 64 + 32], 0);
/// // The views and the light that a modality needs must be given.
/// assert!(renderer.render(&Shot::new(&snapshot, &camera, wanted), &mut frame).is_err());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy)]
pub struct Shot<'a> {
    /// The view to render.
    pub view: View<'a>,
    /// The previous moment, which backward flow needs; of the same scene.
    pub before: Option<View<'a>>,
    /// The next moment, which forward flow needs; of the same scene.
    pub after: Option<View<'a>>,
    /// The light, which colours need.
    pub lighting: Option<&'a Lighting>,
    /// The wanted modalities.
    pub modalities: Modalities,
    /// Supersampling factor of colours: they are rendered this many times finer along each side, then shrunk.
    pub supersampling: u32,
    /// Whether to leave shadows and occlusion out of the colours.
    pub unshadowed: bool,
    /// The exposure that the camera is still adapted to, if it continues from another picture.
    pub adaptation: Option<Adaptation>,
}

/// Gradual adaptation of the exposure: a camera that comes from other light gets used to what it sees little by
/// little.
///
/// ```
/// # use nalgebra::{Point3, Vector3};
/// # use vc_graph::{Bounds, Draft, Pose, SceneBuilder};
/// use vc_render::{Adaptation, Camera, Daylight, Frame, Modality, Renderer, Shot};
/// # let mut scene = SceneBuilder::new("flat");
/// # let kitchen = scene.add(Draft::new("kitchen"))?;
/// # let size = Bounds::standing(Vector3::new(0.6, 0.6, 1.8));
/// # scene.add_in(kitchen, Draft::new("fridge").at(Pose::translation(2.0, 0.0, 0.0)).bounds(size))?;
/// # let scene = scene.build();
/// # let mut renderer = Renderer::new();
/// # let snapshot = renderer.snapshot(&scene)?;
/// let lighting = renderer.light(&snapshot, &Daylight::overcast());
/// let cameras = Camera::with_fov(64, 48, 1.0).around(Point3::new(2.0, 0.0, 1.0), 3.0, 0.3, 8);
/// let (mut frame, mut adaptation) = (Frame::new(), None);
/// for camera in &cameras {
///     let shot = Shot { adaptation, ..Shot::new(&snapshot, camera, Modality::Rgb).lit(&lighting) };
///     renderer.render(&shot, &mut frame)?;
/// // Twelve frames a second.
///     adaptation = Some(Adaptation::after(frame.exposure, 1.0 / 12.0));
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Adaptation {
    /// The exposure that the camera is adapted to: [`Frame::exposure`](crate::Frame::exposure) of the previous
    /// picture.
    pub from: [f32; 3],
    /// How far the exposure goes from there to the one for the light seen now: 0 not at all, 1 all the way. Unless it
    /// is 0, the picture is at most twice too bright and two and a half times too dark.
    pub share: f32,
}

/// Seconds in which the exposure adapts two thirds of the way: quicker than human eyes, as cameras are.
const GETS_USED: f32 = 0.35;
/// Factors by which a picture is at most too bright and too dark while the camera adapts: the rest of a large step, as
/// when a lamp is switched on in the dark, is adapted to at once.
const DAZZLED: f32 = 2.0;
const BLINDED: f32 = 2.5;

impl Adaptation {
    /// The adaptation of a camera whose exposure was `from` some seconds ago; for a film, that of the previous
    /// picture.
    ///
    /// ```
    /// use vc_render::Adaptation;
    /// let quick = Adaptation::after([60.0; 3], 1.0 / 12.0);
    /// assert!((0.2..0.23).contains(&quick.share));
    /// ```
    pub fn after(from: [f32; 3], seconds: f32) -> Self {
        use vc_graph::portable::Portable;
        Self { from, share: 1.0 - (-seconds.max(0.0) / GETS_USED).exponential() }
    }

    /// The exposure of a picture with this adaptation, from the exposure that the picture would have by itself.
    pub(crate) fn towards(&self, now: [f32; 3]) -> [f32; 3] {
        use vc_graph::portable::Portable;
        let share = self.share.clamp(0.0, 1.0);
        let between = |from: f32, to: f32| from * (to / from).power(share);
        let sound = self.from.iter().all(|v| v.is_finite() && *v > 0.0) && share.is_finite();
        match sound {
            true if share > 0.0 => three(|c| between(self.from[c], now[c]).clamp(now[c] / BLINDED, now[c] * DAZZLED)),
            true => self.from,
            false => now,
        }
    }
}

impl<'a> Shot<'a> {
    /// A picture of one moment.
    pub fn new(snapshot: &'a Snapshot, camera: &'a Camera, modalities: impl Into<Modalities>) -> Self {
        let view = View { snapshot, camera };
        Self {
            view,
            before: None,
            after: None,
            lighting: None,
            modalities: modalities.into(),
            supersampling: 1,
            unshadowed: false,
            adaptation: None,
        }
    }

    /// Adds the previous moment, for backward flow and occlusion.
    #[must_use]
    pub fn before(self, snapshot: &'a Snapshot, camera: &'a Camera) -> Self {
        Self { before: Some(View { snapshot, camera }), ..self }
    }

    /// Adds the next moment, for forward flow and occlusion.
    #[must_use]
    pub fn after(self, snapshot: &'a Snapshot, camera: &'a Camera) -> Self {
        Self { after: Some(View { snapshot, camera }), ..self }
    }

    /// Adds the light, for colours.
    #[must_use]
    pub fn lit(self, lighting: &'a Lighting) -> Self {
        Self { lighting: Some(lighting), ..self }
    }

    /// Supersamples colours: they are rendered `times` finer along each side and then shrunk. Seams and bars
    /// thinner than a pixel, which otherwise break up into dashes, stay whole. Colours cost the square of
    /// `times` as much; labels stay as they are.
    #[must_use]
    pub fn supersampled(self, times: u32) -> Self {
        Self { supersampling: times.max(1), ..self }
    }

    /// Leaves shadows and occlusion out of the colours, for learning from many pictures that need not look
    /// real. Indirect light stays; lamps light every surface that faces them in their rooms; the sun lights
    /// only surfaces that are in no room. Colours then take four fifths to nine tenths of the time.
    #[must_use]
    pub fn unshadowed(self) -> Self {
        Self { unshadowed: true, ..self }
    }

    /// The same shot by a camera that is still adapting to the light.
    #[must_use]
    pub fn with_adaptation(self, adaptation: Adaptation) -> Self {
        Self { adaptation: Some(adaptation), ..self }
    }

    pub(crate) fn check(&self, store: &Store) -> Result<(), RenderError> {
        let View { snapshot, camera } = self.view;
        camera.check()?;
        if !snapshot.is_in(store) {
            return Err(RenderError::OtherRenderer("snapshot"));
        }
        for (what, other) in [("moment before", self.before), ("next moment", self.after)] {
            let Some(other) = other else { continue };
            other.camera.check()?;
            snapshot.with(what, other.snapshot)?;
        }
        if let (Some(lighting), true) = (self.lighting, self.modalities.has(Modality::Rgb)) {
            lighting.check(store)?;
            snapshot.with("light", &lighting.tracer.snapshot)?;
        }
        let needs = [
            (Modality::Rgb, "colour", "light (Shot::lit)", self.lighting.is_some()),
            (Modality::FlowForward, "forward flow", "a next moment (Shot::after)", self.after.is_some()),
            (Modality::FlowBackward, "backward flow", "a moment before (Shot::before)", self.before.is_some()),
            (
                Modality::Occlusion,
                "occlusion",
                "a next moment or one before (Shot::after, Shot::before)",
                self.before.is_some() || self.after.is_some(),
            ),
        ];
        match needs.into_iter().find(|(modality, .., there)| self.modalities.has(*modality) && !there) {
            Some((_, wanted, needs, _)) => Err(RenderError::Missing { wanted, needs }),
            None => Ok(()),
        }
    }
}
