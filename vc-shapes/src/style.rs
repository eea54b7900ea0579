//! The style of a home: the material for each purpose.

use vc_graph::Seed;

use crate::material::*;

/// The materials by purpose; one style applies to a whole home.
///
/// ```
/// use vc_graph::Seed;
/// use vc_shapes::Style;
/// use vc_shapes::material::Family;
/// // One style for a whole home; any purpose may be given another material.
/// let style = Style { wood: vc_shapes::material::OAK, ..Style::from_seed(Seed(3)) };
/// assert_eq!(style.wood.family(), Some(Family::Wood));
/// assert_eq!(Style::from_seed(Seed(3)), Style::from_seed(Seed(3)));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Style {
    /// Wood of tables, chairs, shelves.
    pub wood: MaterialId,
    /// A second, matching wood or lacquer: cabinets, wardrobes.
    pub cabinet: MaterialId,
    /// Fronts of kitchen units.
    pub front: MaterialId,
    /// Worktops.
    pub worktop: MaterialId,
    /// Legs, handles, frames.
    pub metal: MaterialId,
    /// Taps and bathroom fittings.
    pub tap: MaterialId,
    /// Sofas and armchairs.
    pub upholstery: MaterialId,
    /// Cushions, throws, chairs.
    pub accent: MaterialId,
    /// Bed linen.
    pub linen: MaterialId,
    /// Curtains and blinds.
    pub curtain: MaterialId,
    /// Rugs.
    pub rug: MaterialId,
    /// Towels.
    pub towel: MaterialId,
    /// Plates and bowls.
    pub crockery: MaterialId,
    /// Cases of appliances.
    pub appliance: MaterialId,
    /// Doors and skirting.
    pub joinery: MaterialId,
    /// Walls of living rooms and bedrooms.
    pub wall: MaterialId,
    /// A wall colour for one or two rooms.
    pub feature: MaterialId,
    /// Floors of dry rooms.
    pub floor: MaterialId,
    /// Floors of kitchens and baths.
    pub tile: MaterialId,
}

/// Matching woods, lacquers and cloths.
struct Palette {
    woods: &'static [MaterialId],
    cabinets: &'static [MaterialId],
    metals: &'static [MaterialId],
    cloths: &'static [MaterialId],
    accents: &'static [MaterialId],
    walls: &'static [MaterialId],
}

const PALETTES: [Palette; 5] = [
    // Nordic: pale woods, white, muted cloth.
    Palette {
        woods: &[BIRCH, ASH, BEECH, OAK, WHITEWASHED],
        cabinets: &[WHITE, WHITE, CREAM, BIRCH, LIGHT_GREY],
        metals: &[IRON, STEEL, BRASS],
        cloths: &[GREY_FABRIC, LINEN, BEIGE_FABRIC, BLUE_FABRIC, GREEN_FABRIC],
        accents: &[MUSTARD_FABRIC, ROSE_FABRIC, TEAL_FABRIC, NAVY_FABRIC, OLIVE_FABRIC],
        walls: &[WALL_WHITE, WALL_WHITE, WALL_GREY, WALL_BLUE, WALL_GREEN],
    },
    // Modern: grey oak, anthracite, leather.
    Palette {
        woods: &[GREY_OAK, WENGE, WALNUT, OAK],
        cabinets: &[ANTHRACITE, WHITE, GREY, LIGHT_GREY, BLACK],
        metals: &[STEEL, CHROME, IRON, ALUMINIUM],
        cloths: &[CHARCOAL_FABRIC, GREY_FABRIC, BLACK_LEATHER, WHITE_LEATHER, NAVY_FABRIC],
        accents: &[TEAL_FABRIC, RUST_FABRIC, MUSTARD_FABRIC, BLACK_FABRIC, WHITE_COTTON],
        walls: &[WALL_WHITE, WALL_GREY, WALL_TAUPE],
    },
    // Classic: dark woods, cream, warm cloth.
    Palette {
        woods: &[CHERRY, MAHOGANY, WALNUT, TEAK],
        cabinets: &[CHERRY, WALNUT, CREAM, MAHOGANY],
        metals: &[BRASS, GOLD, IRON],
        cloths: &[BROWN_LEATHER, RED_FABRIC, BEIGE_FABRIC, GREEN_FABRIC, BROWN_FABRIC],
        accents: &[RED_FABRIC, MUSTARD_FABRIC, OLIVE_FABRIC, PURPLE_FABRIC, RUST_FABRIC],
        walls: &[WALL_CREAM, WALL_OCHRE, WALL_WHITE, WALL_ROSE],
    },
    // Country: pine, sage, linen.
    Palette {
        woods: &[PINE, OAK, BEECH, MAPLE],
        cabinets: &[SAGE, CREAM, PINE, WHITE, SKY],
        metals: &[BRASS, IRON, COPPER],
        cloths: &[LINEN, BLUE_FABRIC, GREEN_FABRIC, BEIGE_FABRIC, ROSE_FABRIC],
        accents: &[RED_FABRIC, BLUE_FABRIC, MUSTARD_FABRIC, ROSE_FABRIC, GREEN_FABRIC],
        walls: &[WALL_CREAM, WALL_WHITE, WALL_GREEN, WALL_OCHRE],
    },
    // Mid-century: teak and walnut, saturated cloth.
    Palette {
        woods: &[TEAK, WALNUT, OAK],
        cabinets: &[TEAK, WALNUT, WHITE, NAVY, FOREST],
        metals: &[BRASS, IRON, STEEL],
        cloths: &[MUSTARD_FABRIC, TEAL_FABRIC, OLIVE_FABRIC, TAN_LEATHER, RUST_FABRIC],
        accents: &[TEAL_FABRIC, RUST_FABRIC, MUSTARD_FABRIC, BLUE_FABRIC, PURPLE_FABRIC],
        walls: &[WALL_WHITE, WALL_CREAM, WALL_TAUPE, WALL_BLUE],
    },
];

impl Style {
    /// Draws a style from a seed: one of five palettes, and materials within it.
    pub fn from_seed(seed: Seed) -> Self {
        let mut rng = seed.child("style").stream();
        let palette = &PALETTES[rng.below(PALETTES.len())];
        let mut of = |list: &[MaterialId]| list[rng.below(list.len())];
        Self {
            wood: of(palette.woods),
            cabinet: of(palette.cabinets),
            front: of(palette.cabinets),
            worktop: of(&[GRANITE, BLACK_GRANITE, MARBLE, OAK, BEECH, CONCRETE]),
            metal: of(palette.metals),
            tap: of(&[CHROME, CHROME, STEEL, BRASS, IRON]),
            upholstery: of(palette.cloths),
            accent: of(palette.accents),
            linen: of(&[WHITE_COTTON, LINEN, BLUE_FABRIC, ROSE_FABRIC, GREY_FABRIC, WHITE_COTTON]),
            curtain: of(&[WHITE_COTTON, LINEN, GREY_FABRIC, BEIGE_FABRIC, BLUE_FABRIC, GREEN_FABRIC]),
            rug: of(&[WOOL, JUTE, GREY_FABRIC, RED_FABRIC, NAVY_FABRIC, BEIGE_FABRIC]),
            towel: of(&[TOWEL_WHITE, TOWEL_BLUE, TOWEL_GREEN, TOWEL_ROSE]),
            crockery: of(&[PORCELAIN, PORCELAIN, STONEWARE, BLUE_GLAZE, GREEN_GLAZE]),
            appliance: of(&[WHITE_METAL, WHITE_METAL, SILVER_METAL, BLACK_METAL]),
            joinery: of(&[WHITE, WHITE, CREAM, OAK, BEECH]),
            wall: of(palette.walls),
            feature: of(&[WALL_BLUE, WALL_GREEN, WALL_ROSE, WALL_OCHRE, WALL_TAUPE, WALL_GREY]),
            floor: of(&[OAK, BEECH, WALNUT, GREY_OAK, PINE, WHITEWASHED, MAPLE]),
            tile: of(&[WHITE_TILE, GREY_TILE, SAND_TILE, BLUE_TILE, SLATE_TILE]),
        }
    }
}
