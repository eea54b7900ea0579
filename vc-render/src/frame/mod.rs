//! Frames: typed buffers of a camera's images and labels, reused from picture to picture.

mod boxes;
mod mask;
mod strip;

pub use boxes::{Box3, BoxLabel, PixelBox};
pub(crate) use mask::Masks;
pub use mask::{Mask, Rle};
pub(crate) use strip::Strip;

use vc_graph::NodeId;

use crate::modality::{Modalities, Modality, NOTHING};

/// A rendered view: the wanted modalities in typed buffers. Each buffer holds `height * width` pixels, row by row
/// from the top left; buffers of modalities not requested are empty.
///
/// A frame that is rendered into again keeps its memory. Bytes for each pixel: colours 3, depth and distance 4
/// each, nodes 4, parts and classes 2 each, normals and points 12 each, flow 8 for each direction, occlusion 1
/// for each; masks take a bit for each pixel of an object's box, its rows filled up to 64 bits. The working memory of
/// rendering is kept by the [`Renderer`](crate::Renderer).
///
/// ```
/// # use nalgebra::{Point3, Vector3};
/// # use vc_graph::{Bounds, Draft, Pose, SceneBuilder};
/// use vc_render::{Camera, Frame, Modality, NOTHING, Renderer, Shot};
/// # let mut scene = SceneBuilder::new("flat");
/// # let kitchen = scene.add(Draft::new("kitchen"))?;
/// # let size = Bounds::standing(Vector3::new(0.6, 0.6, 1.8));
/// # let fridge = scene.add_in(kitchen, Draft::new("fridge").at(Pose::translation(2.0, 0.0, 0.0)).bounds(size))?;
/// # let scene = scene.build();
/// # let mut renderer = Renderer::new();
/// # let snapshot = renderer.snapshot(&scene)?;
/// let wanted = Modality::Depth | Modality::Instance | Modality::Position;
/// let mut frame = Frame::new();
/// for step in [0.0, 0.5] {
///     let eye = Point3::new(step, 0.0, 1.0);
///     let camera = Camera::with_fov(64, 48, 1.0).looking(eye, Point3::new(2.0, 0.0, 1.0));
///     renderer.render(&Shot::new(&snapshot, &camera, wanted), &mut frame)?;
///     let middle = 24 * frame.width + 32;
///     assert_eq!(frame.instance[middle], fridge);
///     assert!((frame.depth[middle] - (1.7 - step)).abs() < 1e-4);
///     assert!(frame.instance[0] == NOTHING && frame.depth[0].is_infinite());
///     assert!(frame.points().all(|(_, point)| (point.x - 1.7).abs() < 1e-3));
///     assert!(frame.rgb.is_empty()); // not asked for
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Default)]
pub struct Frame {
    /// Pixels across.
    pub width: usize,
    /// Pixels down.
    pub height: usize,
    /// The modalities in this frame.
    pub modalities: Modalities,
    /// Colours in sRGB.
    pub rgb: Vec<[u8; 3]>,
    /// The exposure: factors by which light was multiplied to give these colours, linear RGB; zero without
    /// colours.
    pub exposure: [f32; 3],
    /// Depth along the optical axis, metres; infinite where nothing is visible.
    pub depth: Vec<f32>,
    /// Distance from the eye, metres; infinite where nothing is visible.
    pub distance: Vec<f32>,
    /// The graph's node; [`NOTHING`] where nothing is visible.
    pub instance: Vec<NodeId>,
    /// Position of the part in the node's asset; [`NO_LABEL`](crate::NO_LABEL) where nothing is visible.
    pub part: Vec<u16>,
    /// Class number, see [`Snapshot::class`](crate::Snapshot::class); [`NO_LABEL`](crate::NO_LABEL) where nothing is
    /// visible.
    pub class: Vec<u16>,
    /// Normal of the surface in the world, unit length; zero where nothing is visible.
    pub normal: Vec<[f32; 3]>,
    /// Point of the surface in the world, metres; infinite where nothing is visible.
    pub position: Vec<[f32; 3]>,
    /// Forward flow: pixels right and down from here to where this surface point is at the next moment; NaN
    /// where nothing is visible or the point is then behind the camera.
    pub flow_forward: Vec<[f32; 2]>,
    /// Backward flow: pixels right and down from here to where this surface point was at the moment before; NaN
    /// as above.
    pub flow_backward: Vec<[f32; 2]>,
    /// 1 where the surface point seen here is not visible at the next moment, because it is occluded or out of
    /// the image, and where nothing is visible now. Surfaces that occlude it by less than a thousandth of its
    /// depth, or only between the centres of pixels, do not count.
    pub occluded_forward: Vec<u8>,
    /// 1 where the surface point seen here was not visible at the moment before.
    pub occluded_backward: Vec<u8>,
    /// Bounding boxes of all visible nodes, in the order of nodes.
    pub boxes: Vec<BoxLabel>,
    pub(crate) visible_masks: Masks,
    pub(crate) whole_masks: Masks,
}

impl Frame {
    /// An empty frame.
    pub fn new() -> Self {
        Self::default()
    }

    /// Masks of the visible pixels, in the order of nodes, if they were requested.
    pub fn masks(&self) -> impl ExactSizeIterator<Item = Mask<'_>> {
        self.visible_masks.iter()
    }

    /// Masks of whole objects as if nothing occluded them, in the order of nodes, if they were requested.
    pub fn amodal_masks(&self) -> impl ExactSizeIterator<Item = Mask<'_>> {
        self.whole_masks.iter()
    }

    /// The world points of all pixels where something is visible, metres, each with its pixel's position in the
    /// buffers. Without [`Modality::Position`] there are none. Costs a step for every pixel, and no memory.
    pub fn points(&self) -> impl Iterator<Item = (usize, nalgebra::Point3<f32>)> + '_ {
        let seen = |(_, p): &(usize, &[f32; 3])| p[0].is_finite();
        self.position.iter().enumerate().filter(seen).map(|(i, p)| (i, (*p).into()))
    }

    /// Resizes the buffers.
    pub(crate) fn prepare(&mut self, width: usize, height: usize, wanted: Modalities, [next, last]: [bool; 2]) {
        (self.width, self.height, self.modalities) = (width, height, wanted);
        let pixels = width * height;
        let count = |of: Modality| if wanted.has(of) { pixels } else { 0 };
        self.rgb.resize(count(Modality::Rgb), [0; 3]);
        self.exposure = [0.0; 3];
        self.depth.resize(count(Modality::Depth), 0.0);
        self.distance.resize(count(Modality::Distance), 0.0);
        self.instance.resize(count(Modality::Instance), NOTHING);
        self.part.resize(count(Modality::Part), 0);
        self.class.resize(count(Modality::Class), 0);
        self.normal.resize(count(Modality::Normal), [0.0; 3]);
        self.position.resize(count(Modality::Position), [0.0; 3]);
        self.flow_forward.resize(count(Modality::FlowForward), [0.0; 2]);
        self.flow_backward.resize(count(Modality::FlowBackward), [0.0; 2]);
        let occluded = count(Modality::Occlusion);
        self.occluded_forward.resize(if next { occluded } else { 0 }, 0);
        self.occluded_backward.resize(if last { occluded } else { 0 }, 0);
        self.boxes.clear();
        self.visible_masks.clear();
        self.whole_masks.clear();
    }
}
