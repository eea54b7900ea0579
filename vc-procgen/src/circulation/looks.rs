//! The materials of a building.

use vc_graph::Seed;
use vc_shapes::Style;
use vc_shapes::material::*;

use super::rail;

/// The materials of a building, and the style of what is generated for it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Looks {
    pub(crate) style: Style,
    /// Slabs and stairs.
    pub(crate) slab: MaterialId,
    /// The floor of galleries.
    pub(crate) floor: MaterialId,
    /// The shaft.
    pub(crate) shaft: MaterialId,
    /// The cabin: walls and floor.
    pub(crate) cabin: (MaterialId, MaterialId),
    /// Handrails, and the bars of railings.
    pub(crate) rails: (MaterialId, MaterialId),
}

impl Looks {
    pub(crate) fn new(seed: Seed) -> Self {
        let (style, mut rng) = (Style::from_seed(seed), seed.child("looks").stream());
        let mut one_of = |all: &[MaterialId]| rng.pick(all).copied().unwrap_or(CONCRETE);
        Self {
            slab: CONCRETE,
            floor: one_of(&[CONCRETE, GREY_TILE, SLATE_TILE, SAND_TILE]),
            shaft: one_of(&[BRICK, PLASTER, CONCRETE, SANDSTONE]),
            cabin: (one_of(&[STEEL, ALUMINIUM, WHITE, style.wood]), one_of(&[GREY_RUBBER, SLATE_TILE, GRANITE])),
            rails: (one_of(&[style.wood, STEEL, IRON]), one_of(&[IRON, GALVANISED, WHITE_METAL])),
            style,
        }
    }

    pub(crate) fn rail(&self) -> rail::Looks {
        rail::Looks { hand: self.rails.0, bars: self.rails.1 }
    }
}
