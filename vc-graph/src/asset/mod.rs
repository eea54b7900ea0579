//! Shapes as plain data, from which physics makes colliders and the renderer makes meshes.

mod library;
mod measure;
mod merge;

use std::sync::Arc;

use nalgebra::{Point3, UnitQuaternion, Vector3};
use serde::{Deserialize, Serialize};

use crate::Pose;
use crate::serial;

pub use crate::texture::Texture;
pub use library::{AssetError, AssetLibrary};
pub use merge::Merged;

/// Index of an [`Asset`] in its [`AssetLibrary`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(transparent)]
pub struct AssetId(pub u32);

/// A solid shape, centred on its own origin unless stated otherwise; metres.
///
/// ```
/// use vc_graph::asset::Shape;
/// let board = Shape::Box { half: [0.4, 0.3, 0.01].into() };
/// assert_eq!(board.extent().1.x, 0.4);
/// assert!(board.measures_are_positive());
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum Shape {
    /// A box.
    Box {
        /// Half lengths along X, Y and Z.
        #[serde(with = "serial::vector")]
        half: Vector3<f32>,
    },
    /// A box with rounded edges; `half` is the outer size.
    RoundedBox {
        /// Half lengths along X, Y and Z, rounding included.
        #[serde(with = "serial::vector")]
        half: Vector3<f32>,
        /// Radius of the edges.
        radius: f32,
    },
    /// A cylinder along Z.
    Cylinder {
        /// Radius.
        radius: f32,
        /// Half its height.
        half_height: f32,
    },
    /// A cone along Z, its tip up.
    Cone {
        /// Radius of the base.
        radius: f32,
        /// Half its height.
        half_height: f32,
    },
    /// A capsule along Z.
    Capsule {
        /// Radius.
        radius: f32,
        /// Half the length of the straight part.
        half_height: f32,
    },
    /// A sphere.
    Sphere {
        /// Radius.
        radius: f32,
    },
    /// The convex hull of points.
    Hull {
        /// Its points.
        #[serde(with = "serial::points")]
        points: Vec<Point3<f32>>,
    },
    /// A solid of revolution: a profile turned around Z. The profile follows the surface from its bottom and
    /// outside to its top and inside, with the solid on its left: a beaker is
    /// `[(r, 0), (r, h), (r - t, h), (r - t, t)]`. If the profile starts or ends off the axis, a flat disc
    /// closes it to the axis; if it ends in its starting point, it is a ring. The reverse order gives the same
    /// solid.
    Lathe {
        /// Radius and height of each point of the profile.
        profile: Vec<(f32, f32)>,
    },
    /// An outline in the XY plane extruded along Z from zero.
    Extrusion {
        /// The outline, counter-clockwise.
        outline: Vec<(f32, f32)>,
        /// Height of the extrusion.
        height: f32,
    },
    /// A closed triangle mesh.
    Mesh {
        /// Its vertices.
        #[serde(with = "serial::points")]
        vertices: Vec<Point3<f32>>,
        /// Its triangles, counter-clockwise seen from outside.
        triangles: Vec<[u32; 3]>,
        /// For each triangle, the texture coordinates of its corners in the material's [`Texture`]: across and
        /// down, as fractions of its width and height, from its upper left corner. Empty, or one entry for each
        /// triangle.
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        uvs: Vec<[[f32; 2]; 3]>,
    },
}

/// The material of a part.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Material {
    /// Its name, `oak`.
    pub name: Arc<str>,
    /// Linear RGB reflectance.
    pub colour: [f32; 3],
    /// Density, kilograms per cubic metre.
    pub density: f32,
    /// Coulomb friction coefficient.
    pub friction: f32,
    /// Coefficient of restitution, 0 to 1.
    pub restitution: f32,
    /// Surface roughness, 0 (mirror) to 1 (matt).
    pub roughness: f32,
    /// How metallic, 0 to 1.
    pub metallic: f32,
    /// Fraction of the light that passes through, 0 to 1.
    pub transmission: f32,
    /// Emitted radiance when on, watts per square metre and steradian.
    pub emission: [f32; 3],
    /// Index in the library of a texture that `colour` and `emission` are multiplied with.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub texture: Option<u32>,
}

/// The joint between a moving part and its asset.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Joint {
    /// Hinge or slide.
    pub kind: JointKind,
    /// A point of the axis, in the asset's frame, metres.
    #[serde(with = "serial::point")]
    pub anchor: Point3<f32>,
    /// Direction of the axis, unit length, in the asset's frame.
    #[serde(with = "serial::vector")]
    pub axis: Vector3<f32>,
    /// Lower and upper limit of the position: radians or metres; the closed position is zero.
    pub limits: (f32, f32),
}

impl Joint {
    /// The motion, in the asset's frame, of a part from joint position zero to `position` (radians or metres):
    /// a part at `pose` is then at `joint.motion(position) * pose`.
    pub fn motion(&self, position: f32) -> Pose {
        match self.kind {
            JointKind::Slide => {
                Pose::translation(self.axis.x * position, self.axis.y * position, self.axis.z * position)
            }
            JointKind::Hinge => {
                let turn = UnitQuaternion::new(self.axis * position);
                let held = self.anchor.coords - turn * self.anchor.coords;
                Pose::from_parts(held.into(), turn)
            }
        }
    }
}

/// Kind of a [`Joint`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum JointKind {
    /// Turns around its axis.
    Hinge,
    /// Slides along its axis.
    Slide,
}

/// One part of an asset. Parts whose joints are equal move together, as one link.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Part {
    /// Its name, `drawer_2`.
    pub name: Arc<str>,
    /// Its shape.
    pub shape: Shape,
    /// Index of its material in the library.
    pub material: u32,
    /// Pose in the asset's frame with its joint at zero.
    #[serde(with = "serial::pose")]
    pub pose: Pose,
    /// Its joint; `None` if the part is fixed.
    pub joint: Option<Joint>,
}

/// Greatest distance between a hook and the box of a thing that hangs on it, metres.
pub const HOOK_REACH: f32 = 0.05;

/// How a [`Surface`] supports objects.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Hold {
    /// Objects rest on it: relation `on`.
    On,
    /// Objects rest on it within walls or under a roof: relation `inside`.
    Inside,
    /// Objects hang from its centre: relation `on`.
    Hook,
}

/// A place of an asset that holds objects: a level rectangle and the free space above it, or a hook.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Surface {
    /// Its name, `shelf_2`.
    pub name: Arc<str>,
    /// How it supports objects.
    pub hold: Hold,
    /// Centre of the supporting rectangle, in the asset's frame, with joints at zero.
    #[serde(with = "serial::point")]
    pub centre: Point3<f32>,
    /// Half lengths along the asset's X and Y, metres.
    pub half: (f32, f32),
    /// Free height above it (below it for a hook), metres; `None` if no part of the asset is above it.
    pub clearance: Option<f32>,
    /// The joint it moves with, such as a drawer's; `None` if it is fixed.
    pub joint: Option<Joint>,
}

/// An object's shape. Origin at the centre of its base, X towards its front.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Asset {
    /// Its name, `chair_17`.
    pub name: Arc<str>,
    /// Its parts.
    pub parts: Vec<Part>,
    /// The surfaces that hold objects.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub surfaces: Vec<Surface>,
    /// Collision shapes, if they differ from the parts: convex pieces that move with the joints they name.
    /// Empty if the parts themselves serve as collision shapes.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub collision: Vec<Part>,
}

impl Asset {
    /// Smallest and largest corner of the bounding box of all parts, in the asset's frame, with joints at zero,
    /// metres.
    pub fn extent(&self) -> Option<(Point3<f32>, Point3<f32>)> {
        self.parts.iter().map(Part::extent).reduce(|a, b| (a.0.inf(&b.0), a.1.sup(&b.1)))
    }
}

impl Part {
    /// Smallest and largest corner of the bounding box, in the asset's frame, metres.
    ///
    /// Exact, however the part is rotated; costs some operations, for hulls and meshes some per point.
    pub fn extent(&self) -> (Point3<f32>, Point3<f32>) {
        let (low, high) = if self.pose.rotation == UnitQuaternion::identity() {
            self.shape.extent()
        } else {
            self.shape.extent_turned(&self.pose.rotation)
        };
        (low + self.pose.translation.vector, high + self.pose.translation.vector)
    }
}
