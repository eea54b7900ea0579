//! The materials of objects: one table for all, so that assets of different origin share a library.

use std::sync::LazyLock;

use vc_graph::AssetLibrary;
use vc_graph::asset::Material;
use vc_graph::srgb::to_linear;

/// A material of the [table](ALL): its index in every library that this crate makes.
///
/// ```
/// use vc_shapes::material::{Family, OAK, library};
/// assert_eq!((OAK.name(), OAK.family()), ("oak", Some(Family::Wood)));
/// // The same index in every library of this crate.
/// assert_eq!(library().material(OAK.0).map(|material| &*material.name), Some("oak"));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct MaterialId(pub u32);

/// The kind of a material; the materials of a family share everything but the colour.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Family {
    /// Furniture wood and floor boards.
    Wood,
    /// Lacquer, wall paint, coated board.
    Paint,
    /// Bare metal.
    Metal,
    /// Woven cloth.
    Fabric,
    /// Leather.
    Leather,
    /// Glazed ware and tiles.
    Ceramic,
    /// Plastic.
    Plastic,
    /// Clear or tinted glass.
    Glass,
    /// A mirror.
    Mirror,
    /// Paper and card.
    Paper,
    /// Stone, concrete, plaster.
    Stone,
    /// Leaves, bark, soil, fruit, bread, meat.
    Organic,
    /// Rubber.
    Rubber,
    /// A liquid.
    Liquid,
    /// A surface that emits light while its object is on.
    Glow,
    /// A small lamp or a display, visible while its object is on; it does not light its surroundings.
    Indicator,
    /// Parts of a screen, which show their colour while their object is on, and are black when it is off.
    Screen,
}

/// The colour of screens that are off.
const OFF: u32 = 0x0b0c0f;

/// Density, friction, restitution, roughness, metallic, transmission.
const fn physics(family: Family) -> [f32; 6] {
    match family {
        Family::Wood => [650.0, 0.5, 0.3, 0.45, 0.0, 0.0],
        Family::Paint => [700.0, 0.45, 0.3, 0.5, 0.0, 0.0],
        Family::Metal => [2700.0, 0.4, 0.4, 0.3, 1.0, 0.0],
        Family::Fabric => [200.0, 0.7, 0.1, 0.95, 0.0, 0.0],
        Family::Leather => [400.0, 0.6, 0.2, 0.55, 0.0, 0.0],
        Family::Ceramic => [2300.0, 0.4, 0.3, 0.15, 0.0, 0.0],
        Family::Plastic => [1000.0, 0.4, 0.4, 0.4, 0.0, 0.0],
        Family::Glass => [2500.0, 0.35, 0.3, 0.03, 0.0, 0.9],
        Family::Mirror => [2500.0, 0.35, 0.3, 0.02, 1.0, 0.0],
        Family::Paper => [700.0, 0.5, 0.1, 0.85, 0.0, 0.0],
        Family::Stone => [2400.0, 0.6, 0.2, 0.6, 0.0, 0.0],
        Family::Organic => [800.0, 0.5, 0.2, 0.8, 0.0, 0.0],
        Family::Rubber => [1100.0, 0.9, 0.6, 0.9, 0.0, 0.0],
        Family::Liquid => [1000.0, 0.1, 0.0, 0.02, 0.0, 0.8],
        Family::Glow | Family::Indicator | Family::Screen => [1000.0, 0.4, 0.3, 0.4, 0.0, 0.0],
    }
}

macro_rules! materials {
    ($($name:ident $text:literal $family:ident $colour:literal;)*) => {
        /// Gives every material its index.
        #[allow(non_camel_case_types, clippy::upper_case_acronyms)]
        enum Number { $($name),* }
        $(#[doc = concat!("The material `", $text, "`.")]
        pub const $name: MaterialId = MaterialId(Number::$name as u32);)*
        /// The name, family and sRGB colour of every material.
        pub const ALL: &[(&str, Family, u32)] = &[$(($text, Family::$family, $colour)),*];
    };
}

materials! {
    OAK "oak" Wood 0xc19a6b;
    BEECH "beech" Wood 0xd8b48a;
    BIRCH "birch" Wood 0xe3cba4;
    PINE "pine" Wood 0xd9b374;
    ASH "ash" Wood 0xd6c4a5;
    MAPLE "maple" Wood 0xe0c091;
    CHERRY "cherry" Wood 0xa8623a;
    WALNUT "walnut" Wood 0x6b4a32;
    TEAK "teak" Wood 0x9a6a3c;
    MAHOGANY "mahogany" Wood 0x6e3323;
    WENGE "wenge" Wood 0x43342c;
    BAMBOO "bamboo" Wood 0xd4b56a;
    WHITEWASHED "whitewashed_oak" Wood 0xd9d0c1;
    GREY_OAK "grey_oak" Wood 0x9b9185;
    WICKER "wicker" Wood 0xb58e5a;
    CORK "cork" Wood 0xb98a5c;

    WHITE "white_lacquer" Paint 0xf2f1ed;
    CREAM "cream_lacquer" Paint 0xefe6d2;
    LIGHT_GREY "light_grey_lacquer" Paint 0xc9c9c6;
    GREY "grey_lacquer" Paint 0x8a8c8d;
    ANTHRACITE "anthracite_lacquer" Paint 0x3a3d40;
    BLACK "black_lacquer" Paint 0x1c1c1d;
    NAVY "navy_lacquer" Paint 0x27374f;
    SAGE "sage_lacquer" Paint 0x9bab92;
    FOREST "forest_green_lacquer" Paint 0x33503f;
    SKY "sky_blue_lacquer" Paint 0x9fc1d8;
    DUSTY_ROSE "dusty_rose_lacquer" Paint 0xcf9f99;
    TERRACOTTA "terracotta_lacquer" Paint 0xbf6b4b;
    MUSTARD "mustard_lacquer" Paint 0xd3a13b;
    RED "red_lacquer" Paint 0xb3282d;
    BLUE "blue_lacquer" Paint 0x2a5ea8;
    YELLOW "yellow_lacquer" Paint 0xe9c83a;
    GREEN "green_lacquer" Paint 0x4d9a4f;
    ORANGE "orange_lacquer" Paint 0xe07f2c;
    WALL_WHITE "white_wall_paint" Paint 0xf3f1ec;
    WALL_CREAM "cream_wall_paint" Paint 0xefe7d6;
    WALL_GREY "grey_wall_paint" Paint 0xd5d5d2;
    WALL_BLUE "pale_blue_wall_paint" Paint 0xc9d7df;
    WALL_GREEN "pale_green_wall_paint" Paint 0xcfd8c8;
    WALL_ROSE "pale_rose_wall_paint" Paint 0xe5d1ca;
    WALL_OCHRE "pale_ochre_wall_paint" Paint 0xe3d1a9;
    WALL_TAUPE "taupe_wall_paint" Paint 0xcabfb2;

    STEEL "stainless_steel" Metal 0xc6c8ca;
    CHROME "chrome" Metal 0xdfe1e3;
    BRASS "brass" Metal 0xcaa65a;
    COPPER "copper" Metal 0xc07a54;
    IRON "black_iron" Metal 0x2c2c2e;
    ALUMINIUM "aluminium" Metal 0xb7babd;
    GALVANISED "galvanised_steel" Metal 0xa5abae;
    GOLD "gold" Metal 0xd9b64e;
    RUST "rusty_steel" Metal 0x7d4a30;
    WHITE_METAL "white_enamelled_metal" Ceramic 0xf1f2f2;
    BLACK_METAL "black_enamelled_metal" Ceramic 0x222325;
    RED_METAL "red_enamelled_metal" Ceramic 0xb02a2a;
    GREEN_METAL "green_enamelled_metal" Ceramic 0x3d6b4a;
    BLUE_METAL "blue_enamelled_metal" Ceramic 0x2c5282;
    YELLOW_METAL "yellow_enamelled_metal" Ceramic 0xdfb62c;
    SILVER_METAL "silver_coated_metal" Ceramic 0xb4b8bb;

    LINEN "natural_linen" Fabric 0xd8ccb6;
    WHITE_COTTON "white_cotton" Fabric 0xf0eee8;
    GREY_FABRIC "grey_fabric" Fabric 0x8d9092;
    CHARCOAL_FABRIC "charcoal_fabric" Fabric 0x46494c;
    BEIGE_FABRIC "beige_fabric" Fabric 0xc8b79b;
    NAVY_FABRIC "navy_fabric" Fabric 0x2d3f5c;
    BLUE_FABRIC "blue_fabric" Fabric 0x527ba6;
    TEAL_FABRIC "teal_fabric" Fabric 0x3a7173;
    GREEN_FABRIC "green_fabric" Fabric 0x60795a;
    OLIVE_FABRIC "olive_fabric" Fabric 0x777450;
    MUSTARD_FABRIC "mustard_fabric" Fabric 0xc99a3c;
    RUST_FABRIC "rust_fabric" Fabric 0xa95a3a;
    RED_FABRIC "red_fabric" Fabric 0xa2333a;
    ROSE_FABRIC "rose_fabric" Fabric 0xd2a4a0;
    PURPLE_FABRIC "purple_fabric" Fabric 0x6d4d73;
    BROWN_FABRIC "brown_fabric" Fabric 0x6f5442;
    BLACK_FABRIC "black_fabric" Fabric 0x232427;
    DENIM "denim" Fabric 0x3d5575;
    WOOL "undyed_wool" Fabric 0xddd3c0;
    JUTE "jute" Fabric 0xb79c6c;
    TOWEL_WHITE "white_terry" Fabric 0xeeeeea;
    TOWEL_BLUE "blue_terry" Fabric 0x86a3b8;
    TOWEL_GREEN "green_terry" Fabric 0x9db39a;
    TOWEL_ROSE "rose_terry" Fabric 0xd9aaa6;

    BROWN_LEATHER "brown_leather" Leather 0x6d4630;
    TAN_LEATHER "tan_leather" Leather 0xa97142;
    BLACK_LEATHER "black_leather" Leather 0x232021;
    WHITE_LEATHER "white_leather" Leather 0xe6e1d8;

    PORCELAIN "porcelain" Ceramic 0xf6f5f1;
    STONEWARE "stoneware" Ceramic 0xbfae95;
    BLUE_GLAZE "blue_glaze" Ceramic 0x3f6487;
    GREEN_GLAZE "green_glaze" Ceramic 0x6d8c74;
    BLACK_GLAZE "black_glaze" Ceramic 0x2a2b2d;
    RED_GLAZE "red_glaze" Ceramic 0xa33a2f;
    YELLOW_GLAZE "yellow_glaze" Ceramic 0xdfbb4f;
    POTTERY "terracotta" Stone 0xb8653f;
    WHITE_TILE "white_tile" Ceramic 0xeceeec;
    GREY_TILE "grey_tile" Ceramic 0xa9adae;
    SAND_TILE "sand_tile" Ceramic 0xd5c6ab;
    BLUE_TILE "blue_tile" Ceramic 0x8fb0bf;
    SLATE_TILE "slate_tile" Ceramic 0x54595c;

    WHITE_PLASTIC "white_plastic" Plastic 0xeeeeec;
    GREY_PLASTIC "grey_plastic" Plastic 0x8e9193;
    BLACK_PLASTIC "black_plastic" Plastic 0x202123;
    RED_PLASTIC "red_plastic" Plastic 0xc5302f;
    BLUE_PLASTIC "blue_plastic" Plastic 0x2f6fc0;
    GREEN_PLASTIC "green_plastic" Plastic 0x3f9b52;
    YELLOW_PLASTIC "yellow_plastic" Plastic 0xf0c92f;
    ORANGE_PLASTIC "orange_plastic" Plastic 0xe8822b;
    PINK_PLASTIC "pink_plastic" Plastic 0xe58fae;
    PURPLE_PLASTIC "purple_plastic" Plastic 0x7c4f9e;
    BROWN_PLASTIC "brown_plastic" Plastic 0x6e4c33;
    CLEAR_PLASTIC "clear_plastic" Glass 0xe6edee;
    FOAM "foam" Fabric 0xe4e1d6;
    SCREEN "dark_screen" Plastic 0x0b0c0f;
    PICTURE_SKY "picture_sky" Screen 0x7fb2d9;
    PICTURE_LAND "picture_land" Screen 0x5b8a4a;
    PICTURE_SUN "picture_sun" Screen 0xf3d27a;
    PICTURE_DARK "picture_dark" Screen 0x2b3a55;
    LED "led" Indicator 0x7ae08a;
    WARM_BULB "warm_bulb" Glow 0xffe2b0;
    COOL_BULB "cool_bulb" Glow 0xf4f6ff;
    FLAME "flame" Glow 0xff9d3b;
    SIGNAL_RED "signal_red" Glow 0xff3b30;
    SIGNAL_AMBER "signal_amber" Glow 0xffb52e;
    SIGNAL_GREEN "signal_green" Glow 0x3ddc6a;

    GLASS "clear_glass" Glass 0xf2f6f5;
    FROSTED_GLASS "frosted_glass" Glass 0xe9eeed;
    GREEN_GLASS "green_glass" Glass 0x4e7a55;
    BROWN_GLASS "brown_glass" Glass 0x6b4423;
    BLUE_GLASS "blue_glass" Glass 0x5c86ad;
    BLACK_GLASS "black_glass" Plastic 0x111214;
    MIRROR "mirror" Mirror 0xf2f4f4;

    WHITE_PAPER "white_paper" Paper 0xf5f4ef;
    CREAM_PAPER "cream_paper" Paper 0xefe7d2;
    CARDBOARD "cardboard" Paper 0xb58d5e;
    RED_CARD "red_card" Paper 0xb23b35;
    BLUE_CARD "blue_card" Paper 0x3a639b;
    GREEN_CARD "green_card" Paper 0x4a8458;
    YELLOW_CARD "yellow_card" Paper 0xe7c64b;
    ORANGE_CARD "orange_card" Paper 0xd9823a;
    PURPLE_CARD "purple_card" Paper 0x70528a;
    BLACK_CARD "black_card" Paper 0x2a2a2b;
    TEAL_CARD "teal_card" Paper 0x3d8486;
    PINK_CARD "pink_card" Paper 0xdb96a4;

    GRANITE "granite" Stone 0x7d7c7a;
    BLACK_GRANITE "black_granite" Stone 0x333436;
    MARBLE "marble" Stone 0xe6e3de;
    SANDSTONE "sandstone" Stone 0xcbb48c;
    CONCRETE "concrete" Stone 0xa8a7a3;
    ASPHALT "asphalt" Stone 0x4a4a4c;
    BRICK "brick" Stone 0x9c5140;
    PLASTER "plaster" Stone 0xe9e6de;
    GRAVEL "gravel" Stone 0x99938a;
    ROCK "rock" Stone 0x807b74;
    ROOF_TILE "roof_tile" Stone 0x9a4f3a;

    LEAF "leaf" Organic 0x4f7d3b;
    DARK_LEAF "dark_leaf" Organic 0x2f5a30;
    LIGHT_LEAF "light_leaf" Organic 0x83a84d;
    AUTUMN_LEAF "autumn_leaf" Organic 0xc27a2c;
    GRASS "grass" Organic 0x6a8f42;
    BARK "bark" Organic 0x64503d;
    PALE_BARK "pale_bark" Organic 0xc9c2b4;
    SOIL "soil" Organic 0x4d3a2b;
    HAY "hay" Organic 0xcdb25e;
    PETAL_RED "red_petal" Organic 0xc63a46;
    PETAL_WHITE "white_petal" Organic 0xf2efe6;
    PETAL_YELLOW "yellow_petal" Organic 0xefc93b;
    PETAL_PINK "pink_petal" Organic 0xdf8fae;
    PETAL_BLUE "blue_petal" Organic 0x6f7fc8;
    RED_SKIN "red_fruit" Organic 0xb4262b;
    GREEN_SKIN "green_fruit" Organic 0x7fa83c;
    YELLOW_SKIN "yellow_fruit" Organic 0xe8c33a;
    ORANGE_SKIN "orange_fruit" Organic 0xe5862b;
    PURPLE_SKIN "purple_fruit" Organic 0x5a3560;
    BROWN_SKIN "brown_skin" Organic 0x8d6a43;
    PALE_FLESH "pale_flesh" Organic 0xf0e2bf;
    CRUST "bread_crust" Organic 0xb57a3b;
    CRUMB "bread_crumb" Organic 0xeed9ac;
    CHOCOLATE "chocolate" Organic 0x4b2c1c;
    CHEESE "cheese" Organic 0xecc65c;
    CREAM_FOOD "cream" Organic 0xf7f0df;
    MEAT "raw_meat" Organic 0xb5514c;
    COOKED_MEAT "cooked_meat" Organic 0x84512f;
    FISH_SKIN "fish_skin" Organic 0x8f9ba1;
    EGGSHELL "eggshell" Organic 0xe6cdb0;
    RICE "rice" Organic 0xf2eddd;
    TOMATO "tomato_sauce" Organic 0xb83a22;
    WAX "wax" Organic 0xf1e8d0;
    SOAP "soap" Organic 0xe6d9c6;
    SKIN "skin" Organic 0xd9a583;
    FUR "fur" Fabric 0xa97c50;

    RUBBER "black_rubber" Rubber 0x28282a;
    GREY_RUBBER "grey_rubber" Rubber 0x77797b;
    RED_RUBBER "red_rubber" Rubber 0xb8392f;
    WATER "water" Liquid 0xcfe6ee;
    POOL_WATER "pool_water" Liquid 0x6fc3d6;
}

impl MaterialId {
    /// The material's name.
    pub fn name(self) -> &'static str {
        ALL.get(self.0 as usize).map_or("", |m| m.0)
    }

    /// The material's family.
    pub fn family(self) -> Option<Family> {
        ALL.get(self.0 as usize).map(|m| m.1)
    }
}

/// A library of all materials, still without assets.
///
/// Costs a copy of the table, a few microseconds.
pub fn library() -> AssetLibrary {
    static LIBRARY: LazyLock<AssetLibrary> = LazyLock::new(|| {
        let mut library = AssetLibrary::default();
        for (name, family, colour) in ALL {
            // A test adds them one by one and reports errors.
            let _ = library.add_material(material(name, *family, *colour));
        }
        library
    });
    LIBRARY.clone()
}

fn material(name: &str, family: Family, colour: u32) -> Material {
    let [density, friction, restitution, roughness, metallic, transmission] = physics(family);
    let of = |colour: u32| [16, 8, 0].map(|shift: u32| to_linear(((colour >> shift) & 0xff) as f32 / 255.0));
    let shines = |by: f32| of(colour).map(|c| c * by);
    let (colour, emission) = match family {
        Family::Glow => (of(colour), shines(40.0)),
        Family::Indicator => (of(colour), shines(4.0)),
        Family::Screen => (of(OFF), shines(40.0)),
        _ => (of(colour), [0.0; 3]),
    };
    Material {
        density,
        friction,
        restitution,
        roughness,
        metallic,
        transmission,
        emission,
        ..Material::new(name, colour)
    }
}
