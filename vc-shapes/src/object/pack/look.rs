//! The appearance of the packages of a class: colours of their content or skin, of labels, prints
//! and caps.

use crate::material::*;
use crate::solid::Build;

/// Colours of one package.
#[derive(Debug, Clone, Copy)]
pub(super) struct Look {
    /// The skin, or the content if the skin is clear.
    pub(super) body: MaterialId,
    /// The label.
    pub(super) paper: MaterialId,
    /// The print on the label.
    pub(super) ink: MaterialId,
    /// The cap or lid.
    pub(super) cap: MaterialId,
}

impl Look {
    /// Label and print.
    pub(super) fn label(self) -> (MaterialId, MaterialId) {
        (self.paper, self.ink)
    }
}

const CARDS: &[MaterialId] =
    &[RED_CARD, BLUE_CARD, GREEN_CARD, YELLOW_CARD, ORANGE_CARD, PURPLE_CARD, TEAL_CARD, PINK_CARD];
const PLASTICS: &[MaterialId] = &[
    WHITE_PLASTIC,
    BLUE_PLASTIC,
    GREEN_PLASTIC,
    PINK_PLASTIC,
    PURPLE_PLASTIC,
    ORANGE_PLASTIC,
    YELLOW_PLASTIC,
    RED_PLASTIC,
    BLACK_PLASTIC,
];
const LIGHT: &[MaterialId] = &[WHITE_PAPER, CREAM_PAPER, WHITE_PAPER];
const CAPS: &[MaterialId] = &[WHITE_PLASTIC, WHITE_PLASTIC, BLACK_PLASTIC, GREY_PLASTIC];
const TINS: &[MaterialId] = &[STEEL, ALUMINIUM];

/// The usual skins and caps of a class.
fn usual(class: &str) -> (&'static [MaterialId], &'static [MaterialId]) {
    match class {
        "milk" => (&[WHITE_PAPER, WHITE_PAPER, SKY], &[BLUE_PLASTIC, RED_PLASTIC, GREEN_PLASTIC]),
        "juice" | "orange_juice" => {
            (&[ORANGE_CARD, YELLOW_CARD, GREEN_CARD, WHITE_PAPER], &[ORANGE_PLASTIC, GREEN_PLASTIC, WHITE_PLASTIC])
        }
        "cream" | "yogurt" | "cream_cheese" | "hummus" => {
            (&[WHITE_PLASTIC], &[ALUMINIUM, RED_PLASTIC, BLUE_PLASTIC, WHITE_PLASTIC])
        }
        "whipped_cream" => (&[WHITE_METAL, BLUE_METAL, RED_METAL], &[WHITE_PLASTIC]),
        "flour" | "sugar" => (&[WHITE_PAPER, CREAM_PAPER, BLUE_CARD], CAPS),
        "salt" => (&[BLUE_CARD, WHITE_PAPER, RED_CARD], &[STEEL, WHITE_PLASTIC]),
        "pepper" => (&[WALNUT, OAK, BLACK_PLASTIC, STEEL], &[STEEL, WALNUT]),
        "rice" | "dry_pasta" => (&[RICE, HAY, BLUE_CARD, RED_CARD], CAPS),
        "olives" => (&[GREEN_SKIN, DARK_LEAF], &[GOLD, GREEN_METAL]),
        "pickles" => (&[LEAF, GREEN_SKIN], &[GOLD, RED_METAL]),
        "beans" | "canned_food" | "canned_soup" | "canned_tuna" => (TINS, TINS),
        "soda" => (&[RED_METAL, BLUE_METAL, GREEN_METAL, ORANGE_PLASTIC], &[RED_PLASTIC, BLUE_PLASTIC, BLACK_PLASTIC]),
        "energy_drink" => (&[SILVER_METAL, BLUE_METAL, BLACK_METAL, GREEN_METAL], TINS),
        "ketchup" => (&[RED_PLASTIC], &[WHITE_PLASTIC, RED_PLASTIC]),
        "mustard" => (&[YELLOW_PLASTIC, MUSTARD], &[YELLOW_PLASTIC, RED_PLASTIC, GOLD]),
        "mayonnaise" => (&[CREAM_FOOD, WHITE_PLASTIC], &[BLUE_PLASTIC, YELLOW_PLASTIC, WHITE_PLASTIC]),
        "soy_sauce" => (&[CHOCOLATE], &[RED_PLASTIC, GREEN_PLASTIC]),
        "tomato_sauce" => (&[TOMATO], &[GOLD, RED_METAL, GREEN_METAL]),
        "oil" => (&[YELLOW_SKIN, MUSTARD, GREEN_GLASS], &[YELLOW_PLASTIC, GREEN_PLASTIC, BLACK_PLASTIC]),
        "vinegar" => (&[BROWN_GLASS, CLEAR_PLASTIC, RED_SKIN], &[RED_PLASTIC, BLACK_PLASTIC]),
        "salad_dressing" | "condiment_bottle" => {
            (&[CREAM_FOOD, MUSTARD, TOMATO, LIGHT_LEAF], &[WHITE_PLASTIC, GREEN_PLASTIC, RED_PLASTIC])
        }
        "jam" | "jelly" => {
            (&[RED_SKIN, PURPLE_SKIN, ORANGE_SKIN, RED_SKIN], &[RED_METAL, GOLD, WHITE_METAL, GREEN_METAL])
        }
        "honey" => (&[MUSTARD, ORANGE_SKIN], &[GOLD, YELLOW_PLASTIC]),
        "peanut_butter" => (&[BROWN_SKIN, CRUST], &[RED_PLASTIC, BLUE_PLASTIC, GREEN_PLASTIC]),
        "chocolate_spread" | "chocolate_syrup" => (&[CHOCOLATE], &[WHITE_PLASTIC, BROWN_PLASTIC]),
        "maple_syrup" => (&[BROWN_GLASS, COOKED_MEAT], &[RED_PLASTIC, BROWN_PLASTIC]),
        "baby_food" => (&[ORANGE_SKIN, LIGHT_LEAF, MUSTARD, PALE_FLESH], &[WHITE_METAL, BLUE_METAL, GREEN_METAL]),
        "spices" => (&[TOMATO, MUSTARD, BROWN_SKIN, LEAF, CHOCOLATE], &[BLACK_PLASTIC, RED_PLASTIC, GREEN_PLASTIC]),
        "ground_coffee" => (&[CHOCOLATE, RED_CARD, GOLD, BLACK_CARD], &[BROWN_PLASTIC, BLACK_PLASTIC, GOLD]),
        "coffee_beans" => (&[BLACK_CARD, CARDBOARD, GOLD, BROWN_PLASTIC], CAPS),
        "bottled_water" => {
            (&[CLEAR_PLASTIC, CLEAR_PLASTIC, BLUE_GLASS, GREEN_GLASS], &[BLUE_PLASTIC, WHITE_PLASTIC, GREEN_PLASTIC])
        }
        "iced_tea" => (&[ORANGE_SKIN, MUSTARD, BROWN_GLASS], &[YELLOW_PLASTIC, GREEN_PLASTIC, BLUE_PLASTIC]),
        "lemonade" => (&[PETAL_YELLOW, CLEAR_PLASTIC, PETAL_PINK], &[YELLOW_PLASTIC, GREEN_PLASTIC]),
        "beer" => (&[BROWN_GLASS, GREEN_GLASS, BROWN_GLASS], &[GOLD, RED_METAL, STEEL]),
        "wine" => (&[GREEN_GLASS, BLACK_GLASS, GREEN_GLASS], &[RED_CARD, BLACK_CARD, GOLD, PURPLE_CARD]),
        "champagne" => (&[GREEN_GLASS, BLACK_GLASS], &[GOLD, GOLD, SILVER_METAL]),
        "whiskey" => (&[ORANGE_SKIN, BROWN_GLASS, MUSTARD], &[BLACK_PLASTIC, CORK, GOLD]),
        "vodka" => (&[GLASS, FROSTED_GLASS], &[SILVER_METAL, RED_PLASTIC, BLUE_PLASTIC]),
        "alcohol" => (&[GREEN_GLASS, BROWN_GLASS, GLASS, MUSTARD], &[BLACK_PLASTIC, GOLD, RED_PLASTIC]),
        "hand_soap" => (
            &[PETAL_PINK, CLEAR_PLASTIC, GREEN_GLASS, WHITE_PLASTIC, PETAL_BLUE],
            &[WHITE_PLASTIC, BLACK_PLASTIC, CHROME],
        ),
        "dish_soap" => (&[GREEN_PLASTIC, YELLOW_PLASTIC, ORANGE_PLASTIC, BLUE_PLASTIC], &[WHITE_PLASTIC, RED_PLASTIC]),
        "bleach" => (&[WHITE_PLASTIC, YELLOW_PLASTIC, BLUE_PLASTIC], &[RED_PLASTIC, BLUE_PLASTIC]),
        "toilet_cleaner" => (&[BLUE_PLASTIC, GREEN_PLASTIC, WHITE_PLASTIC], &[RED_PLASTIC, WHITE_PLASTIC]),
        "all_purpose_cleaner" | "stain_remover" => (
            &[CLEAR_PLASTIC, BLUE_GLASS, WHITE_PLASTIC, GREEN_GLASS, PINK_PLASTIC],
            &[RED_PLASTIC, BLUE_PLASTIC, WHITE_PLASTIC],
        ),
        "mouthwash" => (&[GREEN_GLASS, BLUE_GLASS, PETAL_BLUE], &[WHITE_PLASTIC, BLACK_PLASTIC]),
        "cough_syrup" => (&[BROWN_GLASS], &[WHITE_PLASTIC]),
        "vitamins" | "painkillers" => (&[BROWN_GLASS, WHITE_PLASTIC, GREEN_PLASTIC], &[WHITE_PLASTIC, YELLOW_PLASTIC]),
        "sunscreen" => {
            (&[YELLOW_PLASTIC, ORANGE_PLASTIC, WHITE_PLASTIC], &[ORANGE_PLASTIC, WHITE_PLASTIC, BLUE_PLASTIC])
        }
        "tooth_paste" => (&[WHITE_PLASTIC, RED_PLASTIC, BLUE_PLASTIC], &[WHITE_PLASTIC, BLUE_PLASTIC]),
        "face_cream" | "foundation" | "hand_cream" => {
            (&[WHITE_PLASTIC, FROSTED_GLASS, SKIN, PINK_PLASTIC], &[GOLD, WHITE_PLASTIC, BLACK_PLASTIC])
        }
        "nail_polish" => {
            (&[RED_SKIN, PETAL_PINK, PURPLE_SKIN, PETAL_BLUE, BLACK], &[BLACK_PLASTIC, WHITE_PLASTIC, GOLD])
        }
        "perfume" | "after_shave" => {
            (&[GLASS, PETAL_PINK, BLUE_GLASS, MUSTARD, GREEN_GLASS], &[GOLD, CHROME, BLACK_PLASTIC])
        }
        "shaving_cream" | "deodorant" | "air_freshener" | "hair_product" => {
            (&[WHITE_METAL, BLUE_METAL, BLACK_METAL, GREEN_METAL, RED_METAL], CAPS)
        }
        "butter" => (&[GOLD, WHITE_PAPER, SILVER_METAL], CAPS),
        _ => (CARDS, CAPS),
    }
}

/// Draws the colours for the class of the object under construction.
pub(super) fn look(b: &mut Build<'_>) -> Look {
    let (bodies, caps) = usual(b.class);
    let plastic = matches!(
        b.class,
        "shampoo"
            | "conditioner"
            | "shower_gel"
            | "lotion_bottle"
            | "laundry_detergent"
            | "detergent"
            | "fabric_softener"
            | "wet_wipes"
            | "dishwasher_tablets"
    );
    let body = b.one_of(if plastic { PLASTICS } else { bodies });
    let cap = b.one_of(if plastic { PLASTICS } else { caps });
    let paper = b.one_of(LIGHT);
    let paper = if paper == body || b.rng.chance(0.3) { b.one_of(CARDS) } else { paper };
    let ink = b.one_of(CARDS);
    let ink = if ink == paper { WHITE_PAPER } else { ink };
    Look { body, paper, ink, cap }
}
