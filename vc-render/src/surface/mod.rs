//! What light does at a surface: its material and its texture.

mod coat;
mod mean;
mod noise;
mod pattern;
mod picture;
mod tile;

use std::sync::Arc;

use vc_graph::asset::{Material, Part};

use crate::affine::three;
use crate::photo::Finish;

pub use coat::Coat;
pub(crate) use pattern::Pattern;
pub(crate) use picture::Picture;
pub(crate) use tile::{SPAN, Span, Tile, Touch};

/// A material as light meets it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Surface {
    /// Linear reflectance; of clear things, what share of light passes by colour.
    pub(crate) colour: [f32; 3],
    pub(crate) roughness: f32,
    pub(crate) metallic: f32,
    pub(crate) transmission: f32,
    pub(crate) emission: [f32; 3],
    pub(crate) role: Role,
    pub(crate) pattern: Pattern,
    /// What the colour is multiplied with, where triangles say where they are in it.
    pub(crate) picture: Option<Arc<Picture>>,
}

/// What a part is for, where that changes how it looks.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Role {
    Plain,
    /// Light shines through it.
    Shade,
    /// Wood of it is laid as boards.
    Floor,
    /// A wall or ceiling: its texture goes on from piece to piece.
    Built,
}

impl Role {
    pub(crate) fn of(part: &Part) -> Self {
        match &*part.name {
            "shade" => Self::Shade,
            "floor" => Self::Floor,
            "wall" | "ceiling" => Self::Built,
            _ => Self::Plain,
        }
    }
}

impl Surface {
    pub(crate) fn of(material: &Material, role: Role) -> Self {
        Self {
            // Nothing reflects everything.
            colour: material.colour.map(|c| c.min(0.9)),
            roughness: material.roughness.clamp(0.02, 1.0),
            metallic: material.metallic.min(1.0),
            transmission: material.transmission.min(1.0),
            emission: material.emission,
            role,
            pattern: Pattern::of(material, role),
            picture: None,
        }
    }

    /// With a picture instead of a pattern.
    pub(crate) fn with(self, picture: Arc<Picture>) -> Self {
        Self { pattern: Pattern::Plain, picture: Some(picture), ..self }
    }

    /// Light that it gives as what would have to fall on it to be thrown back as that: its texture colours it.
    pub(crate) fn as_fallen(&self, light: [f32; 3]) -> [f32; 3] {
        three(|c| std::f32::consts::PI * light[c] / (self.colour[c] * (1.0 - self.metallic)).max(1e-3))
    }

    /// What share of light from all sides it throws back on average, by colour, under a coat: its gloss has that of white.
    pub(crate) fn thrown(&self, coat: &Coat) -> [f32; 3] {
        let (tint, roughness) = tile::mean_of(self.pattern);
        let tint = self.picture.as_ref().map_or(tint, |picture| picture.mean());
        let colour = coat.over(three(|i| self.colour[i] * tint[i]));
        let roughness = coat.rough((self.roughness * roughness).clamp(0.02, 1.0));
        Finish { colour, metallic: self.metallic, roughness }.thrown()
    }

    /// Light it gives from afar.
    pub(crate) fn mean_emission(&self) -> [f32; 3] {
        let picture = self.picture.as_ref().map_or([1.0; 3], |p| p.mean());
        three(|i| self.emission[i] * picture[i])
    }

    /// With the mean of a picture, for what does not say where it is in it.
    pub(crate) fn tinted(self, picture: &Picture) -> Self {
        let mean = picture.mean();
        let of = |v: [f32; 3]| three(|i| v[i] * mean[i]);
        Self { colour: of(self.colour), emission: of(self.emission), ..self }
    }

    /// Grey, matt.
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

    /// Whether one sees through it.
    pub(crate) fn is_clear(&self) -> bool {
        self.transmission > 0.3
    }

    /// Whether it shows what is before it sharply.
    pub(crate) fn is_mirror(&self) -> bool {
        self.metallic > 0.9 && self.roughness < 0.06
    }

    /// Whether it can give light.
    pub(crate) fn glows(&self) -> bool {
        self.emission != [0.0; 3]
    }
}
