//! Shapes as plain data, from which physics makes colliders and the renderer makes meshes.

mod merge;

use std::sync::Arc;

use nalgebra::{Point3, UnitQuaternion, Vector3};
use serde::{Deserialize, Serialize};

use crate::Pose;
use crate::geometry::is_finite;
use crate::serial;

pub use crate::texture::Texture;
pub use merge::Merged;

/// Index of an [`Asset`] in its [`AssetLibrary`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(transparent)]
pub struct AssetId(pub u32);

/// A solid shape, centred on its own origin unless stated otherwise; metres.
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

/// Assets, materials and textures that scenes share.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct AssetLibrary {
    textures: Vec<Arc<Texture>>,
    materials: Vec<Material>,
    assets: Vec<Arc<Asset>>,
}

/// An error in an asset.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum AssetError {
    /// A part uses a material that is not in the library.
    #[error("part `{part}` uses material {material}, the library has {count}")]
    NoSuchMaterial {
        /// The part.
        part: Arc<str>,
        /// The material.
        material: u32,
        /// The number of materials in the library.
        count: usize,
    },
    /// A material has an invalid value.
    #[error("material `{0}` has a value that is negative or not finite, or a density that is not positive")]
    BadMaterial(Arc<str>),
    /// A material uses a texture that is not in the library.
    #[error("material `{material}` uses texture {texture}, the library has {count}")]
    NoSuchTexture {
        /// The material.
        material: Arc<str>,
        /// The texture.
        texture: u32,
        /// The number of textures in the library.
        count: usize,
    },
    /// A texture has no pixels, or not width times height of them.
    #[error("texture `{0}` has no pixels, or not as many as its width times its height")]
    BadTexture(Arc<str>),
    /// A measure is not finite, or is negative or zero where it must be positive.
    #[error("part `{0}` has a measure that is not finite or not positive")]
    BadMeasure(Arc<str>),
    /// A triangle of a mesh refers to a vertex that does not exist.
    #[error("part `{0}` has a triangle with a vertex that does not exist")]
    BadTriangle(Arc<str>),
    /// A mesh has texture coordinates for only some of its triangles, or coordinates that are not finite.
    #[error("part `{0}` has texture coordinates that are not finite, or not for each triangle")]
    BadCoordinates(Arc<str>),
    /// A surface's measure is not finite or is negative.
    #[error("surface `{0}` has a measure that is not finite or is negative")]
    BadSurface(Arc<str>),
    /// A joint's axis has no length or its limits are swapped.
    #[error("part `{0}` has a joint without axis or with its limits swapped")]
    BadJoint(Arc<str>),
}

impl AssetLibrary {
    /// Adds a shared texture and returns its index.
    ///
    /// # Errors
    /// [`AssetError::BadTexture`].
    pub fn add_texture(&mut self, texture: Arc<Texture>) -> Result<u32, AssetError> {
        if !texture.is_sound() {
            return Err(AssetError::BadTexture(texture.name.clone()));
        }
        self.textures.push(texture);
        Ok(self.textures.len() as u32 - 1)
    }

    /// Checks and adds a material, and returns its index.
    ///
    /// # Errors
    /// [`AssetError::BadMaterial`], [`AssetError::NoSuchTexture`].
    pub fn add_material(&mut self, material: Material) -> Result<u32, AssetError> {
        if !material.is_sound() {
            return Err(AssetError::BadMaterial(material.name));
        }
        let count = self.textures.len();
        if let Some(texture) = material.texture.filter(|t| *t as usize >= count) {
            return Err(AssetError::NoSuchTexture { material: material.name, texture, count });
        }
        self.materials.push(material);
        Ok(self.materials.len() as u32 - 1)
    }

    /// Checks and adds an asset.
    ///
    /// # Errors
    /// [`AssetError`], which names the part.
    pub fn add(&mut self, asset: Asset) -> Result<AssetId, AssetError> {
        self.share(Arc::new(asset))
    }

    /// Adds a shared asset.
    ///
    /// # Errors
    /// As [`Self::add`].
    pub fn share(&mut self, asset: Arc<Asset>) -> Result<AssetId, AssetError> {
        asset.parts.iter().chain(&asset.collision).try_for_each(|part| self.check(part))?;
        if let Some(bad) = asset.surfaces.iter().find(|s| !s.is_sound()) {
            return Err(AssetError::BadSurface(bad.name.clone()));
        }
        self.assets.push(asset);
        Ok(AssetId(self.assets.len() as u32 - 1))
    }

    /// The asset with an identifier.
    pub fn get(&self, id: AssetId) -> Option<&Arc<Asset>> {
        self.assets.get(id.0 as usize)
    }

    /// The texture at an index.
    pub fn texture(&self, index: u32) -> Option<&Arc<Texture>> {
        self.textures.get(index as usize)
    }

    /// The material at an index.
    pub fn material(&self, index: u32) -> Option<&Material> {
        self.materials.get(index as usize)
    }

    /// Number of assets.
    pub fn len(&self) -> usize {
        self.assets.len()
    }

    /// Whether there are no assets.
    pub fn is_empty(&self) -> bool {
        self.assets.is_empty()
    }

    fn check(&self, part: &Part) -> Result<(), AssetError> {
        let (name, count) = (part.name.clone(), self.materials.len());
        if part.material as usize >= count {
            return Err(AssetError::NoSuchMaterial { part: name, material: part.material, count });
        }
        if !is_finite(&part.pose) || !part.shape.measures_are_positive() {
            return Err(AssetError::BadMeasure(name));
        }
        if !part.shape.triangles_exist() {
            return Err(AssetError::BadTriangle(name));
        }
        if !part.shape.coordinates_are_sound() {
            return Err(AssetError::BadCoordinates(name));
        }
        match part.joint {
            Some(joint) if !joint.is_sound() => Err(AssetError::BadJoint(name)),
            _ => Ok(()),
        }
    }
}

impl Material {
    /// A material of a name and a linear RGB reflectance, otherwise usual: 1000 kilograms per cubic metre, friction
    /// 0.5, restitution 0.1, half rough, opaque, not metallic, without a texture; it emits no light.
    ///
    /// ```
    /// use vc_graph::asset::Material;
    /// let steel = Material { density: 7800.0, metallic: 1.0, roughness: 0.3, ..Material::new("steel", [0.6; 3]) };
    /// assert_eq!((&*steel.name, steel.friction, steel.emission), ("steel", 0.5, [0.0; 3]));
    /// ```
    pub fn new(name: impl Into<Arc<str>>, colour: [f32; 3]) -> Self {
        Self {
            name: name.into(),
            colour,
            density: 1000.0,
            friction: 0.5,
            restitution: 0.1,
            roughness: 0.5,
            metallic: 0.0,
            transmission: 0.0,
            emission: [0.0; 3],
            texture: None,
        }
    }

    fn is_sound(&self) -> bool {
        let single = [self.friction, self.restitution, self.roughness, self.metallic, self.transmission];
        let mut all = self.colour.iter().chain(&self.emission).chain(&single);
        all.all(|v| v.is_finite() && *v >= 0.0) && self.density.is_finite() && self.density > 0.0
    }
}

impl Surface {
    fn is_sound(&self) -> bool {
        let length = |v: f32| v.is_finite() && v >= 0.0;
        let finite = self.centre.iter().all(|v| v.is_finite());
        let joint = self.joint.is_none_or(Joint::is_sound);
        finite && joint && length(self.half.0) && length(self.half.1) && self.clearance.is_none_or(length)
    }
}

impl Joint {
    fn is_sound(self) -> bool {
        let unit = (self.axis.norm() - 1.0).abs() < 1e-3;
        let (low, high) = self.limits;
        unit && low <= high && low.is_finite() && high.is_finite() && self.anchor.iter().all(|v| v.is_finite())
    }
}

impl Shape {
    /// Whether every measure is finite and positive where it must be, which [`AssetLibrary::add`] requires of a
    /// part's shape.
    pub fn measures_are_positive(&self) -> bool {
        let positive = |v: f32| v.is_finite() && v > 0.0;
        // Checks all of them, without a branch for each.
        let finite = |points: &[Point3<f32>]| {
            points.iter().fold(true, |all, p| all & p.x.is_finite() & p.y.is_finite() & p.z.is_finite())
        };
        match self {
            Self::Box { half } => half.iter().copied().all(positive),
            Self::RoundedBox { half, radius } => half.iter().all(|&h| positive(h) && h >= *radius) && positive(*radius),
            Self::Cylinder { radius, half_height } | Self::Cone { radius, half_height } => {
                positive(*radius) && positive(*half_height)
            }
            Self::Capsule { radius, half_height } => {
                positive(*radius) && (positive(*half_height) || *half_height == 0.0)
            }
            Self::Sphere { radius } => positive(*radius),
            Self::Hull { points } => points.len() >= 4 && finite(points),
            Self::Lathe { profile } => {
                profile.len() >= 2 && profile.iter().all(|(r, z)| r.is_finite() && *r >= 0.0 && z.is_finite())
            }
            Self::Extrusion { outline, height } => {
                let plane = outline.iter().all(|(x, y)| x.is_finite() && y.is_finite());
                outline.len() >= 3 && plane && positive(*height)
            }
            Self::Mesh { vertices, .. } => finite(vertices),
        }
    }

    fn triangles_exist(&self) -> bool {
        match self {
            Self::Mesh { vertices, triangles, .. } => {
                triangles.iter().flatten().all(|&v| (v as usize) < vertices.len())
            }
            _ => true,
        }
    }

    fn coordinates_are_sound(&self) -> bool {
        match self {
            Self::Mesh { triangles, uvs, .. } => {
                let finite = uvs.iter().flatten().flatten().all(|v| v.is_finite());
                finite && (uvs.is_empty() || uvs.len() == triangles.len())
            }
            _ => true,
        }
    }

    /// Smallest and largest corner of the bounding box in the shape's own frame, metres.
    pub fn extent(&self) -> (Point3<f32>, Point3<f32>) {
        let around = |half: Vector3<f32>| (Point3::from(-half), Point3::from(half));
        let round = |radius: f32, half: f32| around(Vector3::new(radius, radius, half));
        match self {
            Self::Box { half } | Self::RoundedBox { half, .. } => around(*half),
            Self::Cylinder { radius, half_height } | Self::Cone { radius, half_height } => round(*radius, *half_height),
            Self::Capsule { radius, half_height } => round(*radius, half_height + radius),
            Self::Sphere { radius } => round(*radius, *radius),
            Self::Hull { points } => corners(points.iter().copied()),
            Self::Lathe { profile } => {
                corners(profile.iter().flat_map(|&(r, z)| [Point3::new(-r, -r, z), Point3::new(r, r, z)]))
            }
            Self::Extrusion { outline, height } => {
                corners(outline.iter().flat_map(|&(x, y)| [Point3::new(x, y, 0.0), Point3::new(x, y, *height)]))
            }
            Self::Mesh { vertices, .. } => corners(vertices.iter().copied()),
        }
    }
}

impl Shape {
    /// Smallest and largest corner of the bounding box of the shape rotated about its origin, metres.
    fn extent_turned(&self, turn: &UnitQuaternion<f32>) -> (Point3<f32>, Point3<f32>) {
        let matrix = turn.to_rotation_matrix().into_inner();
        let axis = matrix.column(2).into_owned();
        // The extent of a flat ring around the axis along each world axis, per unit of its radius.
        let flat = axis.map(|a| (1.0 - a * a).max(0.0).sqrt());
        let around = |half: Vector3<f32>| (Point3::from(-half), Point3::from(half));
        let ring = |&(radius, z): &(f32, f32)| [axis * z - flat * radius, axis * z + flat * radius].map(Point3::from);
        match self {
            Self::Box { half } => around(matrix.abs() * half),
            Self::RoundedBox { half, radius } => around((matrix.abs() * half.add_scalar(-radius)).add_scalar(*radius)),
            Self::Cylinder { radius, half_height } => around(flat * *radius + axis.abs() * *half_height),
            Self::Cone { radius, half_height } => {
                corners([(*radius, -half_height), (0.0, *half_height)].iter().flat_map(ring))
            }
            Self::Capsule { radius, half_height } => around((axis.abs() * *half_height).add_scalar(*radius)),
            Self::Sphere { .. } => self.extent(),
            Self::Lathe { profile } => corners(profile.iter().flat_map(ring)),
            Self::Extrusion { outline, height } => {
                let both = |&(x, y): &(f32, f32)| [Point3::new(x, y, 0.0), Point3::new(x, y, *height)];
                corners(outline.iter().flat_map(both).map(|p| matrix * p))
            }
            Self::Hull { points } | Self::Mesh { vertices: points, .. } => corners(points.iter().map(|p| matrix * p)),
        }
    }
}

fn corners(points: impl Iterator<Item = Point3<f32>>) -> (Point3<f32>, Point3<f32>) {
    let (mut low, mut high) = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
    for p in points {
        // Plain comparisons take one operation each, whereas `min` also handles NaN.
        for k in 0..3 {
            low[k] = if p[k] < low[k] { p[k] } else { low[k] };
            high[k] = if p[k] > high[k] { p[k] } else { high[k] };
        }
    }
    (low.into(), high.into())
}
