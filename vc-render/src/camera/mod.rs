//! A pinhole camera.

mod path;

use nalgebra::{Isometry3, Matrix3, Matrix3x4, Matrix4, Point3, Rotation3, UnitQuaternion, Vector3};
use vc_graph::Pose;
use vc_graph::portable::Portable;

use self::path::Path;
use crate::RenderError;
use crate::math::Affine;

/// Longest side of an image, pixels.
pub const MAX_SIDE: u32 = 8192;

/// How far ahead a camera looks along a path, metres, and the number of points there whose mean it looks at.
const AHEAD: f32 = 1.4;
const POINTS_AHEAD: usize = 8;
/// Number of pixels sampled where a whole picture is not needed.
pub(crate) const SCATTERED_PIXELS: usize = 192;

/// A pinhole camera. Its optical frame has x to the right, y down and z forward.
///
/// Pixel (0, 0) covers the square from (0, 0) to (1, 1) of the image plane, so its
/// centre is at (0.5, 0.5), and an image is cut in half at `width / 2`.
///
/// ```
/// use nalgebra::Point3;
/// use vc_render::Camera;
/// let camera = Camera::with_fov(640, 480, 60_f32.to_radians())
///     .looking(Point3::new(0.0, 0.0, 1.6), Point3::new(2.0, 0.0, 1.6));
/// let seen = camera.project(&Point3::new(4.0, 0.0, 1.6)).ok_or("behind the camera")?;
/// assert!((seen.x - 320.0).abs() < 1e-3 && (seen.y - 240.0).abs() < 1e-3);
/// assert!((seen.z - 4.0).abs() < 1e-5); // depth
/// # Ok::<(), &str>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Camera {
    /// Pixels across.
    pub width: u32,
    /// Pixels down.
    pub height: u32,
    /// Focal lengths across and down, pixels.
    pub focal: (f32, f32),
    /// Principal point, pixels from the top left corner of the image.
    pub centre: (f32, f32),
    /// The optical frame in the world.
    #[serde(with = "vc_graph::serial::pose")]
    pub pose: Pose,
    /// Near plane: surfaces nearer than this along the axis are not seen, metres.
    pub near: f32,
}

impl Camera {
    /// A camera at the origin that looks along X, with a vertical field of view in radians and square pixels.
    /// Rendering fails with [`RenderError::BadCamera`] unless the field of view is above 0 and below half a
    /// turn.
    pub fn with_fov(width: u32, height: u32, vertical: f32) -> Self {
        let vertical = if vertical > 0.0 && vertical < std::f32::consts::PI { vertical } else { f32::NAN };
        let focal = 0.5 * height as f32 / (0.5 * vertical).tangent();
        Self::with_intrinsics(width, height, (focal, focal), (0.5 * width as f32, 0.5 * height as f32))
    }

    /// A camera at the origin that looks along X, with focal lengths and principal
    /// point in pixels.
    pub fn with_intrinsics(width: u32, height: u32, focal: (f32, f32), centre: (f32, f32)) -> Self {
        Self { width, height, focal, centre, pose: Pose::identity(), near: 0.01 }.mounted(&Pose::identity())
    }

    /// The camera mounted on a body: it looks along the pose's X, and its left is the pose's Y.
    #[must_use]
    pub fn mounted(self, on: &Pose) -> Self {
        Self { pose: on * optical_axes(), ..self }
    }

    /// The pose of the body on which the camera is [mounted](Self::mounted): X is the optical axis, Y the camera's
    /// left.
    ///
    /// ```
    /// use vc_graph::Pose;
    /// use vc_render::Camera;
    /// let head = Pose::translation(1.0, 2.0, 1.6);
    /// let body = Camera::with_fov(64, 48, 1.0).mounted(&head).body();
    /// assert!((body.translation.vector - head.translation.vector).norm() < 1e-6 && body.rotation.angle() < 1e-3);
    /// ```
    pub fn body(&self) -> Pose {
        self.pose * optical_axes().inverse()
    }

    /// The camera at `eye`, with `target` in the middle of the image and the world's Z pointing up in it; if it
    /// looks straight up or down, the world's X points up.
    #[must_use]
    pub fn looking(self, eye: Point3<f32>, target: Point3<f32>) -> Self {
        let forward = (target - eye).try_normalize(1e-12).unwrap_or_else(Vector3::x);
        let upright = if forward.xy().norm() > 1e-6 { Vector3::z() } else { Vector3::x() };
        let right = forward.cross(&upright).normalize();
        let axes = Matrix3::from_columns(&[right, forward.cross(&right), forward]);
        let turn = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(axes));
        Self { pose: Isometry3::from_parts(eye.coords.into(), turn), ..self }
    }

    /// The camera above a point, looking down, so that `span` metres of the ground
    /// fit from top to bottom.
    ///
    /// ```
    /// use nalgebra::Point3;
    /// use vc_render::Camera;
    /// // Six metres of the floor fit from top to bottom.
    /// let camera = Camera::with_fov(320, 240, 1.0).overhead(Point3::origin(), 6.0);
    /// let edge = camera.project(&Point3::new(3.0, 0.0, 0.0)).ok_or("behind the camera")?;
    /// assert!(edge.y.abs() < 1e-2);
    /// # Ok::<(), &str>(())
    /// ```
    #[must_use]
    pub fn overhead(self, at: Point3<f32>, span: f32) -> Self {
        let up = span * self.focal.1 / self.height.max(1) as f32;
        self.looking(at + Vector3::new(0.0, 0.0, up), at)
    }

    /// The same view in another number of pixels, with the same field of view.
    #[must_use]
    pub fn resized(self, width: u32, height: u32) -> Self {
        let across = width as f32 / self.width.max(1) as f32;
        let down = height as f32 / self.height.max(1) as f32;
        let scaled = |(x, y): (f32, f32)| (x * across, y * down);
        Self { width, height, focal: scaled(self.focal), centre: scaled(self.centre), ..self }
    }

    /// Projects a point of the world into the image: pixels across and down, and depth along the axis in
    /// metres. None if it is nearer than the near plane.
    pub fn project(&self, point: &Point3<f32>) -> Option<Point3<f32>> {
        let seen = self.pose.inverse_transform_point(point);
        (seen.z >= self.near).then(|| {
            let across = self.focal.0 * seen.x / seen.z + self.centre.0;
            let down = self.focal.1 * seen.y / seen.z + self.centre.1;
            Point3::new(across, down, seen.z)
        })
    }

    /// The point of the world at a place in the image (pixels) and a depth along the
    /// axis (metres).
    ///
    /// ```
    /// use nalgebra::Point3;
    /// use vc_render::Camera;
    /// let camera = Camera::with_fov(320, 240, 1.0).looking(Point3::new(0.0, 0.0, 1.5), Point3::new(2.0, 1.0, 0.5));
    /// let point = Point3::new(2.5, 0.7, 0.9);
    /// let seen = camera.project(&point).ok_or("behind the camera")?;
    /// assert!((camera.unproject(seen.x, seen.y, seen.z) - point).norm() < 1e-4);
    /// # Ok::<(), &str>(())
    /// ```
    pub fn unproject(&self, across: f32, down: f32, depth: f32) -> Point3<f32> {
        self.pose * Point3::from(self.ray(across, down) * depth)
    }

    /// The intrinsic matrix, pixels.
    pub fn intrinsics(&self) -> Matrix3<f32> {
        Matrix3::new(self.focal.0, 0.0, self.centre.0, 0.0, self.focal.1, self.centre.1, 0.0, 0.0, 1.0)
    }

    /// The extrinsic matrix: from the world to the optical frame.
    pub fn extrinsics(&self) -> Matrix4<f32> {
        self.pose.inverse().to_homogeneous()
    }

    /// The projection matrix, from homogeneous world coordinates to homogeneous image coordinates.
    pub fn projection(&self) -> Matrix3x4<f32> {
        self.intrinsics() * self.extrinsics().fixed_rows::<3>(0)
    }

    /// `steps` cameras on a circle around a point, all looking at it.
    ///
    /// `elevation` is the angle above the horizon, radians.
    pub fn around(self, target: Point3<f32>, distance: f32, elevation: f32, steps: usize) -> Vec<Self> {
        let (rise, level) = elevation.sine_cosine();
        let view = |step: usize| {
            let (s, c) = (std::f32::consts::TAU * step as f32 / steps.max(1) as f32).sine_cosine();
            self.looking(target + Vector3::new(level * c, level * s, rise) * distance, target)
        };
        (0..steps).map(view).collect()
    }

    /// `count` cameras evenly spaced along a path. Each looks at the mean of the next points on it, so that the
    /// view turns smoothly. Corners of the path are cut off, three times over (Chaikin 1974).
    ///
    /// The last camera looks at the end of the path from a little over a metre before it, or from halfway along
    /// a short path. On a path of one point all cameras stand there, looking along X; a path without points has
    /// no cameras.
    ///
    /// ```
    /// use nalgebra::Point3;
    /// use vc_render::Camera;
    /// let way = [[0.0, 0.0, 1.5], [3.0, 0.0, 1.5], [3.0, 4.0, 1.5]].map(Point3::from);
    /// let views = Camera::with_fov(320, 240, 1.2).along(&way, 60);
    /// assert_eq!(views.len(), 60);
    /// assert!((views[0].eye() - way[0]).norm() < 1e-5);
    /// assert!(views.windows(2).all(|v| (v[1].eye() - v[0].eye()).norm() < 0.12)); // 5.6 m in 59 steps
    /// ```
    pub fn along(self, way: &[Point3<f32>], count: usize) -> Vec<Self> {
        let way = Path::new(way);
        let Some(length) = way.length() else { return Vec::new() };
        let ahead = AHEAD.min(0.5 * length);
        let view = |i: usize| {
            let gone = (length - ahead) * i as f32 / count.saturating_sub(1).max(1) as f32;
            let next = (1..=POINTS_AHEAD)
                .map(|k| way.at(gone + ahead * k as f32 / POINTS_AHEAD as f32).coords)
                .sum::<Vector3<f32>>();
            self.looking(way.at(gone), (next / POINTS_AHEAD as f32).into())
        };
        (0..count).map(view).collect()
    }

    /// Direction of the ray through a point of the image, in the optical frame, with z = 1.
    pub(crate) fn ray(&self, across: f32, down: f32) -> Vector3<f32> {
        Vector3::new((across - self.centre.0) / self.focal.0, (down - self.centre.1) / self.focal.1, 1.0)
    }

    /// Centres of pixels scattered evenly over the picture (Roberts's sequence), so that a straight edge does
    /// not cross many at once, as it would on a grid of rows and columns.
    pub(crate) fn scattered_pixels(&self) -> impl Iterator<Item = [f32; 2]> + use<> {
        const STEP: [f64; 2] = [0.754_877_666_246_692_7, 0.569_840_290_998_053_2];
        let size = [self.width, self.height];
        let place = move |axis: usize, i: u32| {
            let share = (0.5 + f64::from(i) * STEP[axis]).fract();
            (share * f64::from(size[axis])).floor() as f32 + 0.5
        };
        (0..SCATTERED_PIXELS as u32).map(move |i| [place(0, i), place(1, i)])
    }

    /// Position of the camera in the world.
    pub fn eye(&self) -> Point3<f32> {
        self.pose.translation.vector.into()
    }

    /// The map from the world to the optical frame.
    pub(crate) fn view(&self) -> Affine {
        Affine::from_pose(&self.pose).inverse().unwrap_or(Affine::IDENTITY)
    }

    /// The same view with `times` as many pixels along each side.
    pub(crate) fn finer(&self, times: u32) -> Self {
        let by = times as f32;
        Self {
            width: self.width.saturating_mul(times),
            height: self.height.saturating_mul(times),
            focal: (self.focal.0 * by, self.focal.1 * by),
            centre: (self.centre.0 * by, self.centre.1 * by),
            ..*self
        }
    }

    pub(crate) fn check(&self) -> Result<(), RenderError> {
        let Self { width, height, .. } = *self;
        let side = 1..=MAX_SIDE;
        if !side.contains(&width) || !side.contains(&height) {
            return Err(RenderError::BadSize { width, height, longest: MAX_SIDE });
        }
        let length = |v: f32| v.is_finite() && v > 0.0 && v < 1e9;
        if !length(self.focal.0) || !length(self.focal.1) {
            return Err(RenderError::BadCamera(
                "focal lengths are to be above 0 and below 1e9 pixels, its field of view above 0 and below half a turn",
            ));
        }
        if !(self.centre.0.abs() < 1e6 && self.centre.1.abs() < 1e6) {
            return Err(RenderError::BadCamera("principal point is to be within 1e6 pixels"));
        }
        if !(1e-6..1e6).contains(&self.near) {
            return Err(RenderError::BadCamera("near plane is to be from 1e-6 to 1e6 metres away"));
        }
        let turn = self.pose.rotation.norm();
        if !Affine::from_pose(&self.pose).is_finite() || !(0.99..1.01).contains(&turn) {
            return Err(RenderError::BadCamera(
                "pose is to be finite, within 1e15 metres, and its turn of unit length",
            ));
        }
        Ok(())
    }
}

/// The optical frame in that of a body that looks along X, with its left along Y.
fn optical_axes() -> UnitQuaternion<f32> {
    let axes = Matrix3::new(0.0, 0.0, 1.0, -1.0, 0.0, 0.0, 0.0, -1.0, 0.0);
    UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(axes))
}
