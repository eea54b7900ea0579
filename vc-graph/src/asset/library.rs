//! Libraries of assets, with their materials and textures, checked when they are added.

use std::sync::Arc;

use super::{Asset, AssetId, Joint, Material, Part, Surface, Texture};
use crate::geometry::is_finite;

/// Assets, materials and textures that scenes share.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct AssetLibrary {
    pub(super) textures: Vec<Arc<Texture>>,
    pub(super) materials: Vec<Material>,
    pub(super) assets: Vec<Arc<Asset>>,
}

/// An error in an asset.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum AssetError {
    /// The library has no such asset.
    #[error("there is no asset {asset}, the library has {count}")]
    NoSuchAsset {
        /// The asset.
        asset: u32,
        /// The number of assets in the library.
        count: usize,
    },
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
