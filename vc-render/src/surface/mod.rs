//! Surfaces: materials and their textures, as shading sees them.

mod albedo;
mod appearance;
mod coat;
mod matter;
mod mean;
mod noise;
mod pattern;
mod pattern_mean;
mod picture;
mod scatter;
mod tile;

use std::sync::Arc;

use vc_graph::asset::{Material, Part};

use crate::math::three;

pub(crate) use appearance::{Appearance, texture_axes, textured};
pub use coat::Coat;
pub(crate) use pattern::Pattern;
pub(crate) use picture::Picture;
pub(crate) use scatter::{Finish, Scatter};
pub(crate) use tile::{SPAN, Span, Tile, Touch};

/// A material, prepared for shading.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Surface {
    /// Linear reflectance; for clear materials, the transmitted share of each colour.
    pub(crate) colour: [f32; 3],
    pub(crate) roughness: f32,
    pub(crate) metallic: f32,
    pub(crate) transmission: f32,
    pub(crate) emission: [f32; 3],
    pub(crate) role: Role,
    pub(crate) pattern: Pattern,
    /// The texture that the colour is multiplied with, if the mesh has texture coordinates.
    pub(crate) picture: Option<Arc<Picture>>,
}

/// The role of a part, as far as it changes its look.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Role {
    Plain,
    /// A lampshade of cloth, paper or glass: light shines through it.
    Shade,
    /// A floor: its wood is laid as boards.
    Floor,
    /// A wall or ceiling: its texture continues from piece to piece.
    Built,
}

impl Role {
    pub(crate) fn from_part(part: &Part) -> Self {
        match &*part.name {
            "shade" => Self::Shade,
            "floor" => Self::Floor,
            "wall" | "ceiling" => Self::Built,
            _ => Self::Plain,
        }
    }
}

impl Surface {
    pub(crate) fn new(material: &Material, role: Role) -> Self {
        let pattern = Pattern::from_material(material, role);
        // No light shines through a shade of metal.
        let translucent = material.transmission > 0.0 || matches!(pattern, Pattern::Weave | Pattern::Paper);
        let role = if role == Role::Shade && !translucent { Role::Plain } else { role };
        Self {
            // No material reflects all light.
            colour: material.colour.map(|c| c.min(0.9)),
            roughness: material.roughness.clamp(0.02, 1.0),
            metallic: material.metallic.min(1.0),
            transmission: material.transmission.min(1.0),
            emission: material.emission,
            role,
            pattern,
            picture: None,
        }
    }

    /// Replaces the pattern by a texture.
    pub(crate) fn with(self, picture: Arc<Picture>) -> Self {
        Self { pattern: Pattern::Plain, picture: Some(picture), ..self }
    }

    /// Converts emitted light to the irradiance that the surface would reflect as that light, so that its
    /// texture colours it.
    pub(crate) fn as_fallen(&self, light: [f32; 3]) -> [f32; 3] {
        three(|c| std::f32::consts::PI * light[c] / (self.colour[c] * (1.0 - self.metallic)).max(1e-3))
    }

    /// Mean reflectance for diffuse light, by colour, under a coat; the gloss reflects white.
    pub(crate) fn reflected(&self, coat: &Coat) -> [f32; 3] {
        let (tint, roughness) = pattern_mean::mean_of(self.pattern);
        let tint = self.picture.as_ref().map_or(tint, |picture| picture.mean());
        let colour = coat.over(three(|i| self.colour[i] * tint[i]));
        let roughness = coat.rough((self.roughness * roughness).clamp(0.02, 1.0));
        Finish { colour, metallic: self.metallic, roughness }.reflected()
    }

    /// Emission averaged over the texture.
    pub(crate) fn mean_emission(&self) -> [f32; 3] {
        let picture = self.picture.as_ref().map_or([1.0; 3], |p| p.mean());
        three(|i| self.emission[i] * picture[i])
    }

    /// Multiplied with the mean of a texture, for meshes without texture coordinates.
    pub(crate) fn tinted(self, picture: &Picture) -> Self {
        let mean = picture.mean();
        let of = |v: [f32; 3]| three(|i| v[i] * mean[i]);
        Self { colour: of(self.colour), emission: of(self.emission), ..self }
    }

    /// A matt grey surface.
    pub(crate) fn plain() -> Self {
        Self {
            colour: [0.5; 3],
            roughness: 0.7,
            metallic: 0.0,
            transmission: 0.0,
            emission: [0.0; 3],
            role: Role::Plain,
            pattern: Pattern::Plain,
            picture: None,
        }
    }

    /// Whether it is transparent.
    pub(crate) fn is_clear(&self) -> bool {
        self.transmission > 0.3
    }

    /// Whether it is a mirror: its reflections are sharp.
    pub(crate) fn is_mirror(&self) -> bool {
        self.metallic > 0.9 && self.roughness < 0.06
    }

    /// Whether it emits light.
    pub(crate) fn glows(&self) -> bool {
        self.emission != [0.0; 3]
    }
}
