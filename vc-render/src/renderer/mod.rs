//! The renderer: it owns uploaded meshes and renders scenes with them.

mod colours;
mod labels;
mod light;
mod reference;
mod scratch;
mod viewpoint;

use rayon::prelude::*;
use vc_graph::asset::Joint;
use vc_graph::{NodeId, SceneGraph};

use self::scratch::{Pool, Scratch};
use crate::RenderError;
use crate::colour::shrink;
use crate::frame::Frame;
use crate::modality::Modality;
use crate::scene::{Snapshot, Store};
use crate::shot::{Shot, View};

/// Owns uploaded meshes and surface materials, and renders with them.
///
/// [`snapshot`](Self::snapshot) uploads meshes, once for each asset. Rendering takes `&self`, so many threads
/// may share a renderer. It runs on the threads of the [rayon](https://docs.rs/rayon) pool it is called in, and
/// its result does not depend on their number.
///
/// ```
/// use nalgebra::{Point3, Vector3};
/// use vc_graph::{Bounds, Draft, Pose, SceneBuilder};
/// use vc_render::{Camera, Frame, Modality, Renderer, Shot};
/// let mut scene = SceneBuilder::new("yard");
/// let size = Bounds::standing(Vector3::new(0.6, 0.6, 1.8));
/// let fridge = scene.add(Draft::new("fridge").at(Pose::translation(2.0, 0.0, 0.0)).bounds(size))?;
///
/// let mut renderer = Renderer::new();
/// let snapshot = renderer.snapshot(&scene.build())?;
/// let camera = Camera::with_fov(64, 48, 1.0).looking(Point3::new(0.0, 0.0, 1.0), Point3::new(2.0, 0.0, 1.0));
/// let mut frame = Frame::new();
/// renderer.render(&Shot::new(&snapshot, &camera, Modality::Depth | Modality::Instance), &mut frame)?;
/// assert_eq!(frame.instance[24 * 64 + 32], fridge);
/// assert!((frame.depth[24 * 64 + 32] - 1.7).abs() < 1e-4);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Renderer {
    pub(crate) store: Store,
    scratch: Pool,
}

impl Default for Renderer {
    fn default() -> Self {
        Self { store: Store::new(0.25), scratch: Pool::default() }
    }
}

impl Renderer {
    /// A renderer without uploaded meshes.
    pub fn new() -> Self {
        Self::default()
    }

    /// Sets the largest screen-space error of a curved outline at which a coarser mesh may be drawn, pixels: a
    /// quarter by default. At zero the finest mesh is always drawn.
    ///
    /// Depth and ids agree with a ray caster on the finest meshes (depth to a relative error of 1e-4) only at
    /// zero: coarser meshes deviate from curves by up to this many pixels in the image, and their depth is off
    /// by more.
    #[must_use]
    pub fn with_detail(mut self, pixels: f32) -> Self {
        self.store.detail = pixels;
        self
    }

    /// Takes a snapshot of a scene in its current state: all nodes with a pose and a shape, or at least a box,
    /// and joints open or closed according to the nodes' states.
    ///
    /// Assets not seen before are uploaded. This takes time proportional to their triangles, most of it for
    /// simplifying meshes; the rest takes about a microsecond for each node. Each asset gets five levels of
    /// detail: curves are tessellated finer or coarser, and meshes are simplified by edge collapse in the order
    /// of the quadric error, the distance to the original planes (Garland and Heckbert 1997). [`Snapshot`] has
    /// an example.
    ///
    /// # Errors
    /// [`RenderError::BadPose`], [`RenderError::NoSuchAsset`], [`RenderError::TooManyClasses`].
    pub fn snapshot(&mut self, graph: &SceneGraph) -> Result<Snapshot, RenderError> {
        self.snapshot_with(graph, |_, _| None)
    }

    /// Like [`Self::snapshot`], with joint positions (radians or metres) from a callback, for callers that know
    /// them more exactly than the nodes' states say. Where it returns `None` or a number that is not finite,
    /// the state decides.
    ///
    /// ```
    /// # use std::sync::Arc;
    /// # use nalgebra::{Point3, Vector3};
    /// # use vc_graph::asset::{Joint, JointKind, Material, Part, Shape};
    /// # use vc_graph::{Asset, AssetLibrary, Draft, Pose, SceneBuilder};
    /// use vc_render::{Camera, Frame, Modality, Renderer, Shot};
    /// # let material = Material::new("oak", [0.5, 0.3, 0.15]);
    /// # let mut library = AssetLibrary::default();
    /// # let material = library.add_material(material)?;
    /// # let slide = Joint { kind: JointKind::Slide, anchor: Point3::origin(), axis: Vector3::x(), limits: (0.0, 0.3) };
    /// # let part = |name: &str, half: Vector3<f32>, height: f32, joint: Option<Joint>| Part {
    /// #     name: name.into(),
    /// #     shape: Shape::Box { half },
    /// #     material,
    /// #     pose: Pose::translation(0.0, 0.0, height),
    /// #     joint,
    /// # };
    /// # let body = part("body", Vector3::new(0.2, 0.4, 0.25), 0.25, None);
    /// # let drawer = part("drawer", Vector3::new(0.2, 0.35, 0.1), 0.6, Some(slide));
    /// # let asset = library.add(Asset { name: "dresser".into(), parts: vec![body, drawer], ..Asset::default() })?;
    /// # let mut scene = SceneBuilder::new("flat");
    /// # scene.assets(Arc::new(library));
    /// # let room = scene.add(Draft::new("bedroom"))?;
    /// # let dresser = Draft { asset: Some(asset), ..Draft::new("dresser").at(Pose::identity()) };
    /// # let dresser = scene.add_in(room, dresser)?;
    /// # let scene = scene.build();
    /// # let mut renderer = Renderer::new();
    /// # let camera = Camera::with_fov(64, 48, 1.0).looking(Point3::new(3.0, 0.0, 0.6), Point3::new(0.0, 0.0, 0.6));
    /// // The drawer is 0.2 metres out, whatever the node's state says.
    /// let snapshot = renderer.snapshot_with(&scene, |node, _| (node == dresser).then_some(0.2))?;
    /// let mut frame = Frame::new();
    /// renderer.render(&Shot::new(&snapshot, &camera, Modality::Depth), &mut frame)?;
    /// assert!((frame.depth[24 * 64 + 32] - (3.0 - 0.2 - 0.2)).abs() < 1e-3);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`Self::snapshot`].
    pub fn snapshot_with(
        &mut self,
        graph: &SceneGraph,
        mut joint: impl FnMut(NodeId, &Joint) -> Option<f32>,
    ) -> Result<Snapshot, RenderError> {
        Snapshot::new(&mut self.store, graph, &mut joint)
    }

    /// Number of uploaded triangles of assets at the finest level of detail, and bytes of all levels. Boxes
    /// that stand for nodes without an asset, and the liquids that vessels may be filled with, are not counted.
    pub fn size(&self) -> (usize, usize) {
        self.store.size()
    }

    /// Renders a shot into a frame. Modalities that are not requested cost nothing, and a frame that is reused
    /// for pictures of the same size allocates nothing. The renderer keeps its working memory for the next picture:
    /// 8 bytes for each pixel and more for colours, and with [`Shot::supersampled`] a larger frame of colours, for as
    /// many pictures as were ever rendered at once.
    ///
    /// For 130,000 triangles at 640 by 480 pixels, labels, depth and flow took 3.2 to 4.7 ms on one core and
    /// all six modalities 15.8 to 23 ms, on two shared machines; both times grow about linearly with the number
    /// of pixels. `benches/README.md` has the tables, and these times scaled to the speed of a third machine.
    /// Modalities that need light take it from [`Self::light`]. [`Frame`] and [`Shot`] have examples.
    ///
    /// Labels are read from a visibility buffer (Burns and Hunt 2013), which is filled with edge functions
    /// (Pineda 1988) after clusters have been culled against a coarse depth buffer (Greene, Kass and Miller
    /// 1993). For colours, the widths of penumbrae are found by a blocker search (Fernando 2005) and shadows
    /// filtered by averaging (Reeves, Salesin and Cook 1987); ambient occlusion compares depth with the
    /// surface's plane (after Bavoil and Sainz 2009); reflections of the surroundings use Karis's fit (2014);
    /// the tone curve is that of Naka and Rushton (1966); and edges are smoothed by how far triangles reach
    /// between pixels (after Persson 2011).
    ///
    /// # Errors
    /// [`RenderError::BadSize`], [`RenderError::BadCamera`], [`RenderError::Missing`],
    /// [`RenderError::OtherScene`], [`RenderError::OtherRenderer`], [`RenderError::BadDaylight`]; the frame is
    /// then unchanged.
    pub fn render(&self, shot: &Shot<'_>, frame: &mut Frame) -> Result<(), RenderError> {
        self.scratch.with(|scratch| match shot.supersampling > 1 && shot.modalities.has(Modality::Rgb) {
            true => self.render_finer(shot, frame, scratch),
            false => self.render_plain(shot, frame, scratch),
        })
    }

    /// Renders a shot without supersampling.
    fn render_plain(&self, shot: &Shot<'_>, frame: &mut Frame, scratch: &mut Scratch) -> Result<(), RenderError> {
        shot.check(&self.store)?;
        let camera = shot.view.camera;
        let moments = [shot.after, shot.before].map(|view| view.is_some());
        frame.prepare(camera.width as usize, camera.height as usize, shot.modalities, moments);
        self.labels(shot, frame, scratch);
        if let (true, Some(lighting)) = (shot.modalities.has(Modality::Rgb), shot.lighting) {
            self.colours(lighting, shot, frame, scratch);
        }
        Ok(())
    }

    /// Renders labels at the shot's size and colours at a finer one, which are then shrunk.
    fn render_finer(&self, shot: &Shot<'_>, frame: &mut Frame, scratch: &mut Scratch) -> Result<(), RenderError> {
        let View { snapshot, camera } = shot.view;
        let camera = camera.finer(shot.supersampling);
        let view = View { snapshot, camera: &camera };
        let colours =
            Shot { view, before: None, after: None, modalities: Modality::Rgb.into(), supersampling: 1, ..*shot };
        shot.check(&self.store)?;
        colours.check(&self.store)?;
        let labels = Shot { modalities: shot.modalities.without(Modality::Rgb), supersampling: 1, ..*shot };
        self.render_plain(&labels, frame, scratch)?;
        let mut fine = std::mem::take(&mut scratch.finer);
        self.render_plain(&colours, &mut fine, scratch)?;
        shrink(&fine.rgb, shot.supersampling as usize, (frame.width, &mut frame.rgb));
        frame.modalities = shot.modalities;
        frame.exposure = fine.exposure;
        scratch.finer = fine;
        Ok(())
    }

    /// Renders several shots in parallel, each into its own frame. Each takes the time of [`Self::render`];
    /// many small pictures rendered side by side keep threads busier than one after the other.
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
    /// let cameras = Camera::with_fov(32, 24, 1.0).around(Point3::new(2.0, 0.0, 1.0), 3.0, 0.3, 4);
    /// let shot = |camera| Shot::new(&snapshot, camera, Modality::Instance);
    /// let shots: Vec<Shot<'_>> = cameras.iter().map(shot).collect();
    /// let mut frames: Vec<Frame> = shots.iter().map(|_| Frame::new()).collect();
    /// renderer.render_all(&shots, &mut frames)?;
    /// assert!(frames.iter().all(|frame| frame.instance[12 * 32 + 16] == fridge));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// Those of [`Self::render`], for the first shot that fails; [`RenderError::FrameCount`].
    pub fn render_all(&self, shots: &[Shot<'_>], frames: &mut [Frame]) -> Result<(), RenderError> {
        if shots.len() != frames.len() {
            return Err(RenderError::FrameCount { shots: shots.len(), frames: frames.len() });
        }
        let results: Vec<_> = shots.par_iter().zip(frames).map(|(shot, frame)| self.render(shot, frame)).collect();
        results.into_iter().collect()
    }
}
