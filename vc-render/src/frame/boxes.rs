//! Bounding boxes of visible objects.

use nalgebra::{Point2, Point3, Vector3};
use serde::Serialize;
use vc_graph::serial;
use vc_graph::{NodeId, Pose};

/// A box of whole pixels; it may reach beyond the border of the image.
///
/// ```
/// use vc_render::PixelBox;
/// let cup = PixelBox { x: 10, y: 20, width: 4, height: 5 };
/// let table = PixelBox { x: 0, y: 24, width: 40, height: 10 };
/// let both = cup.joined(&table);
/// assert_eq!(both, PixelBox { x: 0, y: 20, width: 40, height: 14 });
/// assert!(both.contains(&cup) && !table.contains(&cup));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, serde::Deserialize)]
pub struct PixelBox {
    /// First column.
    pub x: i32,
    /// First row.
    pub y: i32,
    /// Columns.
    pub width: i32,
    /// Rows.
    pub height: i32,
}

/// A box in space.
///
/// ```
/// use nalgebra::{Point3, Vector3};
/// use vc_graph::Pose;
/// use vc_render::Box3;
/// let half = Vector3::new(0.3, 0.3, 0.9);
/// let fridge = Box3 { pose: Pose::translation(2.0, 0.0, 0.9), half, corners: [None; 8] };
/// assert!((fridge.corner(0b000) - Point3::new(1.7, -0.3, 0.0)).norm() < 1e-5);
/// assert!((fridge.corner(0b101) - Point3::new(2.3, -0.3, 1.8)).norm() < 1e-5);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Box3 {
    /// Pose of its centre and axes in the world.
    #[serde(with = "serial::pose")]
    pub pose: Pose,
    /// Half its lengths along its own axes, metres.
    #[serde(with = "serial::vector")]
    pub half: Vector3<f32>,
    /// Its corners in the image, pixels; those behind the camera are `None`. Corner number `zyx` in binary lies
    /// on the positive side of the axes whose bit is set.
    #[serde(serialize_with = "corners")]
    pub corners: [Option<Point2<f32>>; 8],
}

fn corners<S: serde::Serializer>(corners: &[Option<Point2<f32>>; 8], s: S) -> Result<S::Ok, S::Error> {
    corners.map(|corner| corner.map(|at| [at.x, at.y])).serialize(s)
}

/// Boxes of one object, in [`Frame::boxes`](crate::Frame::boxes).
///
/// ```
/// # use nalgebra::{Point3, Vector3};
/// # use vc_graph::{Bounds, Draft, Pose, SceneBuilder};
/// use vc_render::{Camera, Frame, Modality, PixelBox, Renderer, Shot};
/// # let mut scene = SceneBuilder::new("flat");
/// # let kitchen = scene.add(Draft::new("kitchen"))?;
/// # let size = Bounds::standing(Vector3::new(0.6, 0.6, 1.8));
/// # let fridge = scene.add_in(kitchen, Draft::new("fridge").at(Pose::translation(2.0, 0.0, 0.0)).bounds(size))?;
/// # let scene = scene.build();
/// # let mut renderer = Renderer::new();
/// # let snapshot = renderer.snapshot(&scene)?;
/// # let camera = Camera::with_fov(64, 48, 1.0).looking(Point3::new(0.0, 0.0, 1.0), Point3::new(2.0, 0.0, 1.0));
/// // The fridge measures 0.6 by 0.6 by 1.8 metres and is two metres away.
/// let mut frame = Frame::new();
/// renderer.render(&Shot::new(&snapshot, &camera, Modality::Boxes), &mut frame)?;
/// let label = &frame.boxes[0];
/// assert_eq!((label.node, label.area), (fridge, 16 * 45));
/// assert_eq!(label.visible, PixelBox { x: 24, y: 3, width: 16, height: 45 });
/// // The amodal box reaches below the border of the image.
/// assert_eq!(label.amodal, PixelBox { height: 47, ..label.visible });
/// assert!((label.oriented.half - Vector3::new(0.3, 0.3, 0.9)).norm() < 1e-4);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct BoxLabel {
    /// The node.
    pub node: NodeId,
    /// Class number, see [`Snapshot::class`](crate::Snapshot::class).
    pub class: u16,
    /// The box around its visible pixels.
    pub visible: PixelBox,
    /// The box around the pixels it would cover if nothing occluded it and the image had no border. Parts
    /// behind the camera's near plane are left out.
    pub amodal: PixelBox,
    /// Number of its visible pixels.
    pub area: u32,
    /// Visible pixels as a share of those that it would cover in the image if nothing occluded it. Only with
    /// [`Modality::Amodal`](crate::Modality::Amodal): to count these pixels the object is drawn alone, which is
    /// the cost of amodal masks.
    pub visible_fraction: Option<f32>,
    /// The oriented bounding box in the world.
    pub oriented: Box3,
}

impl PixelBox {
    /// The box from a first to a last pixel, both included.
    pub(crate) fn between(low: [i32; 2], high: [i32; 2]) -> Self {
        let length = |i: usize| high[i].saturating_sub(low[i]).saturating_add(1);
        Self { x: low[0], y: low[1], width: length(0), height: length(1) }
    }

    /// Whether another box is within this one.
    pub fn contains(&self, other: &Self) -> bool {
        let inside = |at: i32, length: i32, from: i32, all: i32| {
            at >= from && i64::from(at) + i64::from(length) <= i64::from(from) + i64::from(all)
        };
        inside(other.x, other.width, self.x, self.width) && inside(other.y, other.height, self.y, self.height)
    }

    /// The smallest box that contains both.
    #[must_use]
    pub fn joined(&self, other: &Self) -> Self {
        let last = |b: &Self| [b.x.saturating_add(b.width) - 1, b.y.saturating_add(b.height) - 1];
        let (a, b) = (last(self), last(other));
        Self::between([self.x.min(other.x), self.y.min(other.y)], [a[0].max(b[0]), a[1].max(b[1])])
    }

    /// The part of the box within an image of this size, if any.
    pub(crate) fn within(&self, width: usize, height: usize) -> Option<Self> {
        let (x, y) = (self.x.max(0), self.y.max(0));
        let right = self.x.saturating_add(self.width).min(width as i32);
        let bottom = self.y.saturating_add(self.height).min(height as i32);
        (x < right && y < bottom).then(|| Self { x, y, width: right - x, height: bottom - y })
    }
}

impl Box3 {
    /// The corner of a number (0 to 7) in the world, metres. The number's bits `zyx` are as in
    /// [`corners`](Self::corners).
    pub fn corner(&self, number: usize) -> Point3<f32> {
        let sign = |axis: usize| if number >> axis & 1 == 1 { 1.0 } else { -1.0 };
        self.pose * Point3::new(sign(0) * self.half.x, sign(1) * self.half.y, sign(2) * self.half.z)
    }
}
