//! Texture coordinates of triangle corners.

use vc_graph::portable::Portable;

use super::GltfError;
use super::access::{Accessors, Elements};
use super::document::{Material, Primitive, Transform};

/// A primitive's texture coordinates, and their transform.
pub(super) struct TextureMap<'a> {
    pairs: Elements<'a>,
    accessor: usize,
    transform: Transform,
}

impl<'a> TextureMap<'a> {
    /// The texture coordinates of a primitive; `None` if its material has no texture or it has no
    /// coordinates for it.
    pub(super) fn new(accessors: &Accessors<'a>, primitive: &Primitive) -> Result<Option<Self>, GltfError> {
        let material = primitive.material.and_then(|m| accessors.document.materials.get(m));
        let Some(texture) = material.and_then(Material::texture) else { return Ok(None) };
        let transform = texture.extensions.transform.clone().unwrap_or_default();
        let accessor = match transform.tex_coord.unwrap_or(texture.tex_coord) {
            0 => primitive.attributes.first,
            1 => primitive.attributes.second,
            _ => None,
        };
        let Some(accessor) = accessor else { return Ok(None) };
        Ok(Some(Self { pairs: accessors.pairs(accessor)?, accessor, transform }))
    }

    pub(super) fn at(&self, index: usize) -> Result<[f32; 2], GltfError> {
        let bad = |reason| GltfError::BadAccessor { index: self.accessor, reason };
        let pair = self.pairs.numbers(index).ok_or(bad("has fewer texture coordinates than there are vertices"))?;
        let placed = self.transform.apply(pair);
        placed.iter().all(|v| v.is_finite()).then_some(placed).ok_or(bad("has a coordinate that is not finite"))
    }
}

impl Transform {
    /// Applies scale, rotation and offset.
    fn apply(&self, [u, v]: [f32; 2]) -> [f32; 2] {
        let [across, down] = self.scale.unwrap_or([1.0; 2]);
        let (u, v) = (u * across, v * down);
        let (s, c) = self.rotation.sine_cosine();
        [c * u + s * v + self.offset[0], c * v - s * u + self.offset[1]]
    }
}
