//! Poses and bounding boxes.

use nalgebra::{Isometry3, Point3, Vector3};

/// Position and orientation of a node: metres, right-handed, Z up, X forward, Y left.
pub type Pose = Isometry3<f32>;

/// The axes that a node's bounding box is aligned with.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BoundsFrame {
    /// The node's own axes: the box rotates with it.
    Object,
    /// The world's axes, whatever the node's rotation.
    World,
}

/// The bounding box of a node, relative to its pose.
///
/// ```
/// use vc_graph::{Bounds, Pose};
/// let chair = Bounds::standing([0.5, 0.5, 0.9].into());
/// let there = chair.aabb(&Pose::translation(2.0, 0.0, 0.0));
/// assert_eq!((there.min.z, there.max.z, there.centre().x), (0.0, 0.9, 2.0));
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds {
    /// From the pose's origin to the centre of the box, in `frame`, metres.
    pub offset: Vector3<f32>,
    /// Half the box's length along each axis of `frame`, metres.
    pub half: Vector3<f32>,
    /// The axes that the box is aligned with.
    pub frame: BoundsFrame,
}

impl Bounds {
    /// A box standing on the node's origin, aligned with the node: `size` is its
    /// full depth (X), width (Y) and height (Z) in metres.
    pub fn standing(size: Vector3<f32>) -> Self {
        let half = size / 2.0;
        Self { offset: Vector3::new(0.0, 0.0, half.z), half, frame: BoundsFrame::Object }
    }

    /// A world-aligned box centred on the node's origin.
    ///
    /// ```
    /// use vc_graph::{Bounds, Pose};
    /// let cube = Bounds::centred([1.0, 1.0, 1.0].into());
    /// assert_eq!(cube.aabb(&Pose::identity()).min.z, -0.5);
    /// assert_eq!(cube.volume(), 1.0);
    /// ```
    pub fn centred(size: Vector3<f32>) -> Self {
        Self { offset: Vector3::zeros(), half: size / 2.0, frame: BoundsFrame::World }
    }

    /// The world-aligned box that contains this one at `pose`.
    pub fn aabb(&self, pose: &Pose) -> Aabb {
        let (offset, half) = match self.frame {
            BoundsFrame::World => (self.offset, self.half),
            BoundsFrame::Object => {
                let turn = pose.rotation.to_rotation_matrix();
                (pose.rotation * self.offset, turn.matrix().abs() * self.half)
            }
        };
        let centre = Point3::from(pose.translation.vector + offset);
        Aabb { min: centre - half, max: centre + half }
    }

    /// Full depth, width and height, metres.
    pub fn size(&self) -> Vector3<f32> {
        self.half * 2.0
    }

    /// Volume in cubic metres.
    pub fn volume(&self) -> f32 {
        8.0 * self.half.x * self.half.y * self.half.z
    }
}

/// A box aligned with the world's axes, metres.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Aabb {
    /// Smallest corner.
    pub min: Point3<f32>,
    /// Largest corner.
    pub max: Point3<f32>,
}

impl Aabb {
    /// The box around nothing: it overlaps no box, and joined with a box it gives that one.
    pub const EMPTY: Self = Self {
        min: Point3::new(f32::INFINITY, f32::INFINITY, f32::INFINITY),
        max: Point3::new(f32::NEG_INFINITY, f32::NEG_INFINITY, f32::NEG_INFINITY),
    };

    /// The box around two points.
    pub fn around(one: &Point3<f32>, other: &Point3<f32>) -> Self {
        Self { min: one.inf(other), max: one.sup(other) }
    }

    /// Centre of the box.
    pub fn centre(&self) -> Point3<f32> {
        nalgebra::center(&self.min, &self.max)
    }

    /// The eight corners: corner `i` is at the box's largest X, Y and Z where bit 0, 1 and 2 of `i` is set, and at the
    /// smallest where it is not.
    ///
    /// ```
    /// use nalgebra::Point3;
    /// use vc_graph::Aabb;
    /// let unit = Aabb::around(&Point3::origin(), &Point3::new(1.0, 1.0, 1.0));
    /// assert_eq!(unit.corners()[0b101], Point3::new(1.0, 0.0, 1.0));
    /// ```
    pub fn corners(&self) -> [Point3<f32>; 8] {
        let at = |corner: usize, axis: usize| if corner >> axis & 1 == 0 { self.min[axis] } else { self.max[axis] };
        std::array::from_fn(|i| Point3::new(at(i, 0), at(i, 1), at(i, 2)))
    }

    /// The point of the box nearest to `point`, which is `point` itself if it is inside.
    ///
    /// ```
    /// use nalgebra::Point3;
    /// use vc_graph::Aabb;
    /// let unit = Aabb::around(&Point3::origin(), &Point3::new(1.0, 1.0, 1.0));
    /// let above = Point3::new(0.5, 0.5, 3.0);
    /// assert_eq!(unit.nearest(&above).z, 1.0);
    /// assert_eq!(unit.distance(&above), 2.0);
    /// assert!(!unit.contains(&above));
    /// ```
    pub fn nearest(&self, point: &Point3<f32>) -> Point3<f32> {
        Point3::from(point.coords.sup(&self.min.coords).inf(&self.max.coords))
    }

    /// Distance from a point to the box, zero inside, metres.
    pub fn distance(&self, point: &Point3<f32>) -> f32 {
        nalgebra::distance(&self.nearest(point), point)
    }

    /// The distance between two boxes along the axis along which they are farthest apart, metres; at most zero
    /// if they overlap or touch.
    ///
    /// ```
    /// use nalgebra::Point3;
    /// use vc_graph::Aabb;
    /// let unit = Aabb { min: Point3::origin(), max: Point3::new(1.0, 1.0, 1.0) };
    /// let above = Aabb { min: Point3::new(0.0, 0.0, 1.5), max: Point3::new(1.0, 1.0, 2.0) };
    /// assert_eq!(unit.gap(&above), 0.5);
    /// assert_eq!(unit.joined(&above).max.z, 2.0);
    /// ```
    pub fn gap(&self, other: &Self) -> f32 {
        (0..3).map(|i| (self.min[i] - other.max[i]).max(other.min[i] - self.max[i])).fold(f32::NEG_INFINITY, f32::max)
    }

    /// Whether two boxes overlap or touch.
    ///
    /// ```
    /// use nalgebra::Point3;
    /// use vc_graph::Aabb;
    /// let unit = Aabb::around(&Point3::origin(), &Point3::new(1.0, 1.0, 1.0));
    /// let above = Aabb::around(&Point3::new(0.5, 0.5, 1.5), &Point3::new(1.5, 1.5, 2.0));
    /// assert!(!unit.meets(&above) && unit.meets_in_plan(&above) && unit.grown(0.0, 0.5).meets(&above));
    /// assert_eq!(unit.distance_squared(&above), 0.25);
    /// assert!(!unit.meets(&Aabb::EMPTY) && unit.joined(&Aabb::EMPTY) == unit);
    /// ```
    #[inline]
    pub fn meets(&self, other: &Self) -> bool {
        self.meets_in_plan(other) && self.min.z <= other.max.z && self.max.z >= other.min.z
    }

    /// Whether two boxes overlap or touch in plan: seen from above.
    #[inline]
    pub fn meets_in_plan(&self, other: &Self) -> bool {
        (self.min.x <= other.max.x)
            & (self.max.x >= other.min.x)
            & (self.min.y <= other.max.y)
            & (self.max.y >= other.min.y)
    }

    /// Squared distance between two boxes, square metres.
    #[inline]
    pub fn distance_squared(&self, other: &Self) -> f32 {
        // Comparisons of numbers that are no NaN: a single instruction each, unlike `f32::max`.
        let more = |a: f32, b: f32| if b > a { b } else { a };
        let apart = |i: usize| more(more(self.min[i] - other.max[i], other.min[i] - self.max[i]), 0.0);
        let (x, y, z) = (apart(0), apart(1), apart(2));
        x * x + y * y + z * z
    }

    /// The box extended on all sides: by `sides` along X and Y, by `up_and_down` along Z, metres.
    pub fn grown(&self, sides: f32, up_and_down: f32) -> Self {
        let by = Vector3::new(sides, sides, up_and_down);
        Self { min: self.min - by, max: self.max + by }
    }

    /// The smallest box that contains both.
    pub fn joined(&self, other: &Self) -> Self {
        Self { min: self.min.inf(&other.min), max: self.max.sup(&other.max) }
    }

    /// Whether the box contains the point, borders included.
    pub fn contains(&self, point: &Point3<f32>) -> bool {
        self.nearest(point) == *point
    }
}

/// Whether every number of a pose is finite.
pub(crate) fn is_finite(pose: &Pose) -> bool {
    pose.translation.vector.iter().chain(pose.rotation.coords.iter()).all(|v| v.is_finite())
}
