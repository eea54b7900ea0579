//! Building an asset part by part: the functions in which class generators are written.

use std::f32::consts::FRAC_PI_2;
use std::sync::Arc;

use nalgebra::{Isometry3, Matrix3, Point3, Rotation3, Translation3, UnitQuaternion, Vector3};
use vc_graph::asset::{Hold, Joint, JointKind, Part, Shape, Surface};
use vc_graph::{Asset, Bounds, BoundsFrame, Pose, Stream};

use crate::facts::ClassFacts;
use crate::material::MaterialId;
use crate::style::Style;

/// The capacity reserved for parts.
const PARTS: usize = 16;

/// A point or direction, metres.
pub(crate) type P = [f32; 3];

/// One of the three axes.
///
/// ```
/// # use vc_graph::{Seed, nalgebra::Vector3};
/// # use vc_shapes::{Build, Style};
/// # let style = Style::from_seed(Seed(1));
/// # let mut b = Build::new("thing", Vector3::new(1.0, 1.0, 1.0), &style, Seed(1).stream());
/// use vc_shapes::material::STEEL;
/// use vc_shapes::solid::{Axis, ngon};
/// b.prism("bar", Axis::Y, [0.0, -0.5, 0.1], &ngon((0.02, 0.02), 6), 1.0, STEEL);
/// assert!((b.finish().1.size().y - 1.0).abs() < 1e-3);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Axis {
    /// Forward.
    X,
    /// To the left.
    Y,
    /// Up.
    Z,
}

/// An asset under construction. The origin is at the centre of the base, X forward, Y to the left,
/// Z up; metres. The generated parts stay within `size`.
///
/// ```
/// use vc_graph::{Seed, nalgebra::Vector3};
/// use vc_shapes::material::OAK;
/// use vc_shapes::{Build, Style};
/// let style = Style::from_seed(Seed(1));
/// let mut b = Build::new("stool", Vector3::new(0.4, 0.4, 0.45), &style, Seed(1).stream());
/// b.block("seat", [-0.2, -0.2, 0.42], [0.2, 0.2, 0.45], OAK);
/// b.cylinder("leg", [0.0, 0.0, 0.0], 0.03, 0.42, OAK);
/// let (asset, bounds) = b.finish();
/// assert_eq!(asset.parts.len(), 2);
/// assert!((bounds.size().z - 0.45).abs() < 1e-3);
/// ```
pub struct Build<'a> {
    /// The class to generate, for generators of several classes.
    pub class: &'a str,
    /// The upper bounds of depth (X), width (Y) and height (Z).
    pub size: Vector3<f32>,
    /// Materials by purpose.
    pub style: &'a Style,
    /// The source of random choices.
    pub rng: Stream,
    asset: Asset,
    joint: Option<Joint>,
    frame: Pose,
    anchored: bool,
    /// The parts that are visible but have no collision shape.
    without_collision: Vec<usize>,
    facts: ClassFacts,
}

impl<'a> Build<'a> {
    /// Begins the asset of a class; the built-in class table decides how it collides.
    pub fn new(class: &'a str, size: Vector3<f32>, style: &'a Style, rng: Stream) -> Self {
        Self::with_facts(class, ClassFacts::builtin(class), size, style, rng)
    }

    /// Begins the asset of a class of which some facts are known.
    pub(crate) fn with_facts(
        class: &'a str,
        facts: ClassFacts,
        size: Vector3<f32>,
        style: &'a Style,
        rng: Stream,
    ) -> Self {
        // Most assets have up to this many parts; growing in steps would copy them.
        let asset = Asset { name: class.into(), parts: Vec::with_capacity(PARTS), ..Asset::default() };
        Self {
            class,
            size,
            style,
            rng,
            asset,
            joint: None,
            frame: Pose::identity(),
            anchored: false,
            without_collision: Vec::new(),
            facts,
        }
    }

    /// Keeps the origin where it is: a door's is the centre of its wall, whatever its handles do.
    ///
    /// ```
    /// # use vc_graph::{Seed, nalgebra::Vector3};
    /// # use vc_shapes::{Build, Style};
    /// # let style = Style::from_seed(Seed(1));
    /// # let mut b = Build::new("thing", Vector3::new(1.0, 1.0, 1.0), &style, Seed(1).stream());
    /// use vc_shapes::material::OAK;
    /// b.anchored();
    /// b.block("leaf", [-0.02, 0.0, 0.0], [0.02, 0.9, 1.0], OAK);
    /// // The origin stays at the hinge, not at the centre of the base.
    /// assert!((b.finish().1.offset.y - 0.45).abs() < 1e-3);
    /// ```
    pub fn anchored(&mut self) {
        self.anchored = true;
    }

    /// The finished asset, moved so that its origin is the centre of its base, and its bounding
    /// box.
    pub fn finish(self) -> (Asset, Bounds) {
        let mut asset = self.asset;
        asset.parts.shrink_to_fit();
        let Some((low, high)) = super::flush::set_back(&mut asset) else { return (asset, Bounds::standing(self.size)) };
        if !self.without_collision.is_empty() {
            let solid = asset.parts.iter().enumerate().filter(|(i, _)| !self.without_collision.contains(i));
            asset.collision.extend(solid.map(|(_, part)| part.clone()));
        }
        super::collision::simplify(&self.facts, &mut asset, high - low);
        let half = (high - low) / 2.0;
        if self.anchored {
            let offset = nalgebra::center(&low, &high).coords;
            return (asset, Bounds { offset, half, frame: BoundsFrame::Object });
        }
        let shift = Vector3::new(-(low.x + high.x) / 2.0, -(low.y + high.y) / 2.0, -low.z);
        let moved = Translation3::from(shift);
        asset.parts.iter_mut().chain(&mut asset.collision).for_each(|p| {
            p.pose = moved * p.pose;
            shift_joint(&mut p.joint, shift);
        });
        asset.surfaces.iter_mut().for_each(|s| {
            s.centre += shift;
            shift_joint(&mut s.joint, shift);
        });
        (asset, Bounds::standing(high - low))
    }

    /// The asset built so far.
    pub(crate) fn asset(&mut self) -> &mut Asset {
        &mut self.asset
    }

    /// Takes away all that was built.
    pub(crate) fn clear(&mut self) {
        self.asset.parts.clear();
        self.asset.collision.clear();
        self.asset.surfaces.clear();
        self.without_collision.clear();
    }

    /// Names the asset, for example by a book's title or a poster's motif.
    pub fn name(&mut self, name: &str) {
        self.asset.name = name.into();
    }

    // --- visual and collision geometry

    /// The parts built are visual only and have no collision shape.
    ///
    /// ```
    /// # use vc_graph::{Seed, nalgebra::Vector3};
    /// # use vc_shapes::{Build, Style};
    /// # let style = Style::from_seed(Seed(1));
    /// # let mut b = Build::new("thing", Vector3::new(1.0, 1.0, 1.0), &style, Seed(1).stream());
    /// use vc_shapes::material::{OAK, STEEL};
    /// b.block("board", [-0.5, -0.5, 0.0], [0.5, 0.5, 0.02], OAK);
    /// b.visual_only(|b| b.block("screw", [0.0, 0.0, 0.02], [0.01, 0.01, 0.03], STEEL));
    /// let (asset, _) = b.finish();
    /// assert_eq!((asset.parts.len(), asset.collision.len()), (2, 1));
    /// ```
    pub fn visual_only(&mut self, build: impl FnOnce(&mut Self)) {
        let from = self.asset.parts.len();
        build(self);
        self.without_collision.extend(from..self.asset.parts.len());
    }

    /// The parts built are collision geometry only, in place of finer visible parts.
    ///
    /// ```
    /// # use vc_graph::{Seed, nalgebra::Vector3};
    /// # use vc_shapes::{Build, Style};
    /// # let style = Style::from_seed(Seed(1));
    /// # let mut b = Build::new("thing", Vector3::new(1.0, 1.0, 1.0), &style, Seed(1).stream());
    /// use vc_shapes::material::{OAK, STEEL};
    /// b.cylinder("wire", [0.0; 3], 0.2, 0.3, STEEL);
    /// b.collision_only(|b| b.block("box", [-0.2, -0.2, 0.0], [0.2, 0.2, 0.3], OAK));
    /// let (asset, _) = b.finish();
    /// assert_eq!((asset.parts.len(), asset.collision.len()), (1, 1));
    /// ```
    pub fn collision_only(&mut self, build: impl FnOnce(&mut Self)) {
        let from = self.asset.parts.len();
        build(self);
        self.asset.collision.extend(self.asset.parts.drain(from..));
    }

    // --- frames and joints

    /// Builds in a frame moved by `offset` and rotated by `yaw` about Z.
    ///
    /// ```
    /// # use vc_graph::{Seed, nalgebra::Vector3};
    /// # use vc_shapes::{Build, Style};
    /// # let style = Style::from_seed(Seed(1));
    /// # let mut b = Build::new("thing", Vector3::new(1.0, 1.0, 1.0), &style, Seed(1).stream());
    /// use vc_shapes::material::OAK;
    /// for x in [-0.4, 0.4] {
    ///     b.at([x, 0.0, 0.0], 0.0, |b| b.block("foot", [-0.05, -0.05, 0.0], [0.05, 0.05, 0.1], OAK));
    /// }
    /// let (_, bounds) = b.finish();
    /// assert!((bounds.size() - Vector3::new(0.9, 0.1, 0.1)).norm() < 2e-3);
    /// ```
    pub fn at(&mut self, offset: P, yaw: f32, build: impl FnOnce(&mut Self)) {
        self.posed(Isometry3::new(Vector3::from(offset), Vector3::z() * yaw), build);
    }

    /// Builds in a frame given relative to the current one.
    pub fn posed(&mut self, pose: Pose, build: impl FnOnce(&mut Self)) {
        let outer = self.frame;
        self.frame = outer * pose;
        build(self);
        self.frame = outer;
    }

    /// The parts built rotate about `axis` through `anchor`, from 0 to `most` radians.
    ///
    /// ```
    /// # use vc_graph::{Seed, nalgebra::Vector3};
    /// # use vc_shapes::{Build, Style};
    /// # let style = Style::from_seed(Seed(1));
    /// # let mut b = Build::new("thing", Vector3::new(1.0, 1.0, 1.0), &style, Seed(1).stream());
    /// use vc_shapes::material::OAK;
    /// b.hinge([0.0, -0.3, 0.0], [0.0, 0.0, 1.0], 1.5, |b| b.block("door", [0.0, -0.3, 0.0], [0.02, 0.3, 0.8], OAK));
    /// let joint = b.finish().0.parts[0].joint.ok_or("no joint")?;
    /// assert_eq!(joint.limits, (0.0, 1.5));
    /// # Ok::<(), &str>(())
    /// ```
    pub fn hinge(&mut self, anchor: P, axis: P, most: f32, build: impl FnOnce(&mut Self)) {
        self.jointed(JointKind::Hinge, anchor, axis, (0.0, most), build);
    }

    /// The parts built slide along `axis`, from 0 to `most` metres.
    ///
    /// ```
    /// # use vc_graph::{Seed, nalgebra::Vector3};
    /// # use vc_shapes::{Build, Style};
    /// # let style = Style::from_seed(Seed(1));
    /// # let mut b = Build::new("thing", Vector3::new(1.0, 1.0, 1.0), &style, Seed(1).stream());
    /// use vc_shapes::material::OAK;
    /// b.slide([1.0, 0.0, 0.0], 0.3, |b| b.block("drawer", [-0.2, -0.2, 0.0], [0.2, 0.2, 0.1], OAK));
    /// assert!(b.finish().0.parts[0].joint.is_some_and(|joint| joint.limits.1 == 0.3));
    /// ```
    pub fn slide(&mut self, axis: P, most: f32, build: impl FnOnce(&mut Self)) {
        self.jointed(JointKind::Slide, [0.0; 3], axis, (0.0, most), build);
    }

    /// The parts built move as one link with a joint.
    pub fn jointed(&mut self, kind: JointKind, anchor: P, axis: P, limits: (f32, f32), build: impl FnOnce(&mut Self)) {
        let outer = self.joint;
        let limits = (limits.0, limits.1.max(limits.0));
        let axis = self.frame.rotation * Vector3::from(axis).normalize();
        self.joint = Some(Joint { kind, anchor: self.frame * Point3::from(anchor), axis, limits });
        build(self);
        self.joint = outer;
    }

    // --- solids

    /// A box between two corners.
    ///
    /// ```
    /// # use vc_graph::{Seed, nalgebra::Vector3};
    /// # use vc_shapes::{Build, Style};
    /// # let style = Style::from_seed(Seed(1));
    /// # let mut b = Build::new("thing", Vector3::new(1.0, 1.0, 1.0), &style, Seed(1).stream());
    /// use vc_shapes::material::OAK;
    /// b.block("board", [-0.3, -0.4, 0.0], [0.3, 0.4, 0.02], OAK);
    /// let (_, bounds) = b.finish();
    /// assert!((bounds.size() - Vector3::new(0.6, 0.8, 0.02)).norm() < 2e-3);
    /// ```
    pub fn block(&mut self, name: &str, low: P, high: P, mat: MaterialId) {
        let (centre, half) = between(low, high);
        self.push(name, Shape::Box { half }, Isometry3::from_parts(centre.into(), UnitQuaternion::identity()), mat);
    }

    /// A box with rounded edges between two corners; the radius is limited to what fits.
    ///
    /// ```
    /// # use vc_graph::{Seed, nalgebra::Vector3};
    /// # use vc_shapes::{Build, Style};
    /// # let style = Style::from_seed(Seed(1));
    /// # let mut b = Build::new("thing", Vector3::new(1.0, 1.0, 1.0), &style, Seed(1).stream());
    /// use vc_shapes::material::WHITE;
    /// b.rounded_block("soap", [-0.03, -0.04, 0.0], [0.03, 0.04, 0.03], 0.01, WHITE);
    /// let (_, bounds) = b.finish();
    /// assert!((bounds.size() - Vector3::new(0.06, 0.08, 0.03)).norm() < 2e-3);
    /// ```
    pub fn rounded_block(&mut self, name: &str, low: P, high: P, radius: f32, mat: MaterialId) {
        let (centre, half) = between(low, high);
        let radius = radius.min(half.min() * 0.98);
        let pose = Isometry3::from_parts(centre.into(), UnitQuaternion::identity());
        self.push(name, Shape::RoundedBox { half, radius }, pose, mat);
    }

    /// A cylinder standing on `base`.
    ///
    /// ```
    /// # use vc_graph::{Seed, nalgebra::Vector3};
    /// # use vc_shapes::{Build, Style};
    /// # let style = Style::from_seed(Seed(1));
    /// # let mut b = Build::new("thing", Vector3::new(1.0, 1.0, 1.0), &style, Seed(1).stream());
    /// use vc_shapes::material::STEEL;
    /// b.cylinder("can", [0.0; 3], 0.05, 0.12, STEEL);
    /// let (_, bounds) = b.finish();
    /// assert!((bounds.size() - Vector3::new(0.1, 0.1, 0.12)).norm() < 2e-3);
    /// ```
    pub fn cylinder(&mut self, name: &str, base: P, radius: f32, height: f32, mat: MaterialId) {
        let half_height = height / 2.0;
        self.push(name, Shape::Cylinder { radius, half_height }, up(base, half_height), mat);
    }

    /// A cone standing on `base`, with its tip up.
    pub fn cone(&mut self, name: &str, base: P, radius: f32, height: f32, mat: MaterialId) {
        let half_height = height / 2.0;
        self.push(name, Shape::Cone { radius, half_height }, up(base, half_height), mat);
    }

    /// A sphere.
    pub fn ball(&mut self, name: &str, centre: P, radius: f32, mat: MaterialId) {
        self.push(name, Shape::Sphere { radius }, up(centre, 0.0), mat);
    }

    /// A cylinder from one point to another.
    pub fn rod(&mut self, name: &str, from: P, to: P, radius: f32, mat: MaterialId) {
        let (pose, half_height) = along(from, to);
        self.push(name, Shape::Cylinder { radius, half_height }, pose, mat);
    }

    /// A capsule from one point to another; its ends protrude by the radius.
    pub fn bar(&mut self, name: &str, from: P, to: P, radius: f32, mat: MaterialId) {
        let (pose, half_height) = along(from, to);
        self.push(name, Shape::Capsule { radius, half_height }, pose, mat);
    }

    /// Capsules through several points, such as a tap's spout or a bent tube.
    pub fn pipe(&mut self, name: &str, points: &[P], radius: f32, mat: MaterialId) {
        points.windows(2).for_each(|pair| self.bar(name, pair[0], pair[1], radius, mat));
    }

    /// A profile of (radius, height) revolved about the vertical through `base`; see
    /// [`Shape::Lathe`].
    ///
    /// ```
    /// # use vc_graph::{Seed, nalgebra::Vector3};
    /// # use vc_shapes::{Build, Style};
    /// # let style = Style::from_seed(Seed(1));
    /// # let mut b = Build::new("thing", Vector3::new(1.0, 1.0, 1.0), &style, Seed(1).stream());
    /// use vc_shapes::material::POTTERY;
    /// b.lathe("bowl", [0.0; 3], &[(0.05, 0.0), (0.1, 0.06), (0.09, 0.06), (0.04, 0.01)], POTTERY);
    /// assert!((b.finish().1.size().z - 0.06).abs() < 1e-3);
    /// ```
    pub fn lathe(&mut self, name: &str, base: P, profile: &[(f32, f32)], mat: MaterialId) {
        self.push(name, Shape::Lathe { profile: profile.to_vec() }, up(base, 0.0), mat);
    }

    /// A profile revolved about an axis that points from `from` towards `to`.
    pub fn lathe_along(&mut self, name: &str, from: P, to: P, profile: &[(f32, f32)], mat: MaterialId) {
        let (mut pose, _) = along(from, to);
        pose.translation = Vector3::from(from).into();
        self.push(name, Shape::Lathe { profile: profile.to_vec() }, pose, mat);
    }

    /// An outline extruded along an axis from `base` by `length`. The outline is in (y, z) for X,
    /// (x, z) for Y and (x, y) for Z, relative to `base`, in either orientation.
    ///
    /// ```
    /// # use vc_graph::{Seed, nalgebra::Vector3};
    /// # use vc_shapes::{Build, Style};
    /// # let style = Style::from_seed(Seed(1));
    /// # let mut b = Build::new("thing", Vector3::new(1.0, 1.0, 1.0), &style, Seed(1).stream());
    /// use vc_shapes::material::OAK;
    /// use vc_shapes::solid::{Axis, star};
    /// b.prism("star", Axis::Z, [0.0; 3], &star(5, 0.1, 0.04), 0.01, OAK);
    /// assert!((b.finish().1.size().z - 0.01).abs() < 1e-4);
    /// ```
    pub fn prism(&mut self, name: &str, axis: Axis, base: P, outline: &[(f32, f32)], length: f32, mat: MaterialId) {
        let (x, y, z) = (Vector3::x(), Vector3::y(), Vector3::z());
        let (columns, swap) = match axis {
            Axis::X => ([y, z, x], false),
            Axis::Y => ([z, x, y], true),
            Axis::Z => ([x, y, z], false),
        };
        let mut outline: Vec<(f32, f32)> = outline.iter().map(|&(a, b)| if swap { (b, a) } else { (a, b) }).collect();
        if signed_area(&outline) < 0.0 {
            outline.reverse();
        }
        let turn = Rotation3::from_matrix_unchecked(Matrix3::from_columns(&columns));
        let pose = Isometry3::from_parts(Vector3::from(base).into(), UnitQuaternion::from_rotation_matrix(&turn));
        self.push(name, Shape::Extrusion { outline, height: length }, pose, mat);
    }

    /// A block whose bottom and top rectangles differ, given by the half lengths of both.
    ///
    /// ```
    /// # use vc_graph::{Seed, nalgebra::Vector3};
    /// # use vc_shapes::{Build, Style};
    /// # let style = Style::from_seed(Seed(1));
    /// # let mut b = Build::new("thing", Vector3::new(1.0, 1.0, 1.0), &style, Seed(1).stream());
    /// use vc_shapes::material::OAK;
    /// b.taper("foot", [0.0; 3], (0.1, 0.1), (0.05, 0.05), 0.2, OAK);
    /// let (_, bounds) = b.finish();
    /// assert!((bounds.size() - Vector3::new(0.2, 0.2, 0.2)).norm() < 2e-3);
    /// ```
    pub fn taper(&mut self, name: &str, base: P, bottom: (f32, f32), top: (f32, f32), height: f32, mat: MaterialId) {
        let corners = |(x, y): (f32, f32), z: f32| [[x, y, z], [-x, y, z], [-x, -y, z], [x, -y, z]];
        let points = corners(bottom, 0.0).into_iter().chain(corners(top, height));
        let points: Vec<P> = points.map(|p| [p[0] + base[0], p[1] + base[1], p[2] + base[2]]).collect();
        self.hull(name, &points, mat);
    }

    /// The convex hull of points.
    ///
    /// ```
    /// # use vc_graph::{Seed, nalgebra::Vector3};
    /// # use vc_shapes::{Build, Style};
    /// # let style = Style::from_seed(Seed(1));
    /// # let mut b = Build::new("thing", Vector3::new(1.0, 1.0, 1.0), &style, Seed(1).stream());
    /// use vc_shapes::material::OAK;
    /// b.hull("wedge", &[[0.0, 0.0, 0.0], [0.2, 0.0, 0.0], [0.0, 0.1, 0.0], [0.0, 0.0, 0.05]], OAK);
    /// let (_, bounds) = b.finish();
    /// assert!((bounds.size() - Vector3::new(0.2, 0.1, 0.05)).norm() < 2e-3);
    /// ```
    pub fn hull(&mut self, name: &str, points: &[P], mat: MaterialId) {
        let points = points.iter().map(|&p| Point3::from(p)).collect();
        self.push(name, Shape::Hull { points }, Pose::identity(), mat);
    }

    /// A closed triangle mesh.
    pub fn mesh(&mut self, name: &str, vertices: Vec<P>, triangles: Vec<[u32; 3]>, mat: MaterialId) {
        let vertices = vertices.into_iter().map(Point3::from).collect();
        self.push(name, Shape::Mesh { vertices, triangles, uvs: Vec::new() }, Pose::identity(), mat);
    }

    /// Adds a part; a part too small to have positive dimensions is left out.
    fn push(&mut self, name: &str, shape: Shape, pose: Pose, mat: MaterialId) {
        if !shape.measures_are_positive() {
            return;
        }
        let name = self.shared(name);
        let part = Part { name, shape, material: mat.0, pose: self.frame * pose, joint: self.joint };
        self.asset.parts.push(part);
    }

    /// Reuses the name of one of the last parts if it is the same, because many parts form rows.
    fn shared(&self, name: &str) -> Arc<str> {
        const LAST: usize = 6;
        let last = self.asset.parts.iter().rev().take(LAST).find(|part| *part.name == *name);
        last.map_or_else(|| name.into(), |part| part.name.clone())
    }

    // --- surfaces for objects

    /// A surface for objects, open above.
    ///
    /// ```
    /// # use vc_graph::{Seed, nalgebra::Vector3};
    /// # use vc_shapes::{Build, Style};
    /// # let style = Style::from_seed(Seed(1));
    /// # let mut b = Build::new("thing", Vector3::new(1.0, 1.0, 1.0), &style, Seed(1).stream());
    /// use vc_shapes::material::OAK;
    /// b.block("board", [-0.5, -0.5, 0.7], [0.5, 0.5, 0.72], OAK);
    /// b.block("leg", [-0.05, -0.05, 0.0], [0.05, 0.05, 0.7], OAK);
    /// b.top("board", [0.0, 0.0, 0.72], (0.5, 0.5));
    /// let (asset, _) = b.finish();
    /// assert!(asset.surfaces[0].clearance.is_none());
    /// ```
    pub fn top(&mut self, name: &str, centre: P, half: (f32, f32)) {
        self.surface(name, Hold::On, centre, half, None);
    }

    /// A surface for objects, with part of the asset above it.
    pub fn ledge(&mut self, name: &str, centre: P, half: (f32, f32), clearance: f32) {
        self.surface(name, Hold::On, centre, half, Some(clearance));
    }

    /// A surface within walls: a shelf in a cupboard, the bottom of a drawer.
    ///
    /// ```
    /// # use vc_graph::{Seed, nalgebra::Vector3};
    /// # use vc_shapes::{Build, Style};
    /// # let style = Style::from_seed(Seed(1));
    /// # let mut b = Build::new("thing", Vector3::new(1.0, 1.0, 1.0), &style, Seed(1).stream());
    /// use vc_shapes::material::OAK;
    /// use vc_shapes::solid::case;
    /// case(&mut b, [-0.2, -0.3, 0.0], [0.2, 0.3, 0.4], 0.02, OAK);
    /// b.inside("shelf", [0.0, 0.0, 0.02], (0.17, 0.27), 0.36);
    /// assert_eq!(b.finish().0.surfaces[0].clearance, Some(0.36));
    /// ```
    pub fn inside(&mut self, name: &str, centre: P, half: (f32, f32), clearance: f32) {
        self.surface(name, Hold::Inside, centre, half, Some(clearance));
    }

    /// A point that objects hang from, with the free height below it.
    pub fn hook(&mut self, name: &str, at: P, drop: f32) {
        self.surface(name, Hold::Hook, at, (0.0, 0.0), Some(drop));
    }

    /// A surface keeps its axes: frames rotated by other than right angles cannot contain surfaces.
    fn surface(&mut self, name: &str, hold: Hold, centre: P, half: (f32, f32), clearance: Option<f32>) {
        let size = self.frame.rotation * Vector3::new(half.0, half.1, 0.0);
        if half.0 < 0.0 || half.1 < 0.0 {
            return;
        }
        let (half, clearance) = ((size.x.abs(), size.y.abs()), clearance.map(|c| c.max(0.0)));
        let centre = self.frame * Point3::from(centre);
        let name: Arc<str> = name.into();
        self.asset.surfaces.push(Surface { name, hold, centre, half, clearance, joint: self.joint });
    }

    // --- random choices

    /// A random number between two.
    pub fn vary(&mut self, low: f32, high: f32) -> f32 {
        self.rng.between(low, high)
    }

    /// One of several materials or other small values.
    ///
    /// ```
    /// # use vc_graph::{Seed, nalgebra::Vector3};
    /// # use vc_shapes::{Build, Style};
    /// # let style = Style::from_seed(Seed(1));
    /// # let mut b = Build::new("thing", Vector3::new(1.0, 1.0, 1.0), &style, Seed(1).stream());
    /// use vc_shapes::material::{BEECH, OAK};
    /// let wood = b.choose(&[OAK, BEECH]);
    /// assert!([OAK, BEECH].contains(&wood));
    /// ```
    ///
    /// Nothing can be chosen from an empty array: that does not compile.
    pub fn choose<T: Copy, const N: usize>(&mut self, of: &[T; N]) -> T {
        const { assert!(N > 0, "nothing to choose from") };
        of[self.rng.below(N)]
    }

    /// One of a list of this crate, which has at least one entry.
    pub(crate) fn one_of<T: Copy>(&mut self, list: &[T]) -> T {
        list[self.rng.below(list.len())]
    }
}

fn shift_joint(joint: &mut Option<Joint>, shift: Vector3<f32>) {
    if let Some(joint) = joint.as_mut().filter(|j| j.kind == JointKind::Hinge) {
        joint.anchor += shift;
    }
}

fn between(low: P, high: P) -> (Vector3<f32>, Vector3<f32>) {
    let (low, high) = (Vector3::from(low), Vector3::from(high));
    ((low + high) / 2.0, (high - low) / 2.0)
}

fn up(base: P, by: f32) -> Pose {
    Isometry3::translation(base[0], base[1], base[2] + by)
}

/// The pose at the midpoint of two points, with Z from one to the other, and half their distance.
fn along(from: P, to: P) -> (Pose, f32) {
    let (from, to) = (Vector3::from(from), Vector3::from(to));
    let way = to - from;
    let turn = UnitQuaternion::rotation_between(&Vector3::z(), &way)
        .unwrap_or_else(|| UnitQuaternion::from_axis_angle(&Vector3::x_axis(), 2.0 * FRAC_PI_2));
    (Isometry3::from_parts(((from + to) / 2.0).into(), turn), way.norm() / 2.0)
}

fn signed_area(outline: &[(f32, f32)]) -> f32 {
    let next = outline.iter().cycle().skip(1);
    outline.iter().zip(next).map(|(a, b)| a.0 * b.1 - b.0 * a.1).sum::<f32>() / 2.0
}
