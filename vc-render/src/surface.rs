//! What light does at a surface.

use vc_graph::asset::Material;

/// A material as light meets it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Surface {
    pub(crate) colour: [f32; 3],
    pub(crate) roughness: f32,
    pub(crate) metallic: f32,
    pub(crate) transmission: f32,
    pub(crate) emission: [f32; 3],
    pub(crate) shade: bool,
}

impl Surface {
    pub(crate) fn of(material: &Material, shade: bool) -> Self {
        Self {
            colour: material.colour,
            roughness: material.roughness,
            metallic: material.metallic,
            transmission: material.transmission,
            emission: material.emission,
            shade,
        }
    }

    /// Grey, matt.
    pub(crate) fn plain() -> Self {
        Self { colour: [0.5; 3], roughness: 0.7, metallic: 0.0, transmission: 0.0, emission: [0.0; 3], shade: false }
    }

    /// Whether one sees through it.
    pub(crate) fn is_clear(&self) -> bool {
        self.transmission > 0.3
    }
}
