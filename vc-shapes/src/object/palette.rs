//! Materials among which generators of several families choose.

use crate::material::*;

/// Bright plastics.
pub(super) const BRIGHT: &[MaterialId] =
    &[RED_PLASTIC, BLUE_PLASTIC, GREEN_PLASTIC, YELLOW_PLASTIC, ORANGE_PLASTIC, PURPLE_PLASTIC, PINK_PLASTIC];
/// Paints of toys and machines.
pub(super) const PAINTS: &[MaterialId] = &[RED, BLUE, GREEN, YELLOW, ORANGE, SKY, DUSTY_ROSE, FOREST, NAVY];
/// Printed card.
pub(super) const CARDS: &[MaterialId] =
    &[RED_CARD, BLUE_CARD, GREEN_CARD, YELLOW_CARD, ORANGE_CARD, PURPLE_CARD, TEAL_CARD, PINK_CARD];
/// Bright fabrics.
pub(super) const CLOTHS: &[MaterialId] =
    &[RED_FABRIC, BLUE_FABRIC, GREEN_FABRIC, MUSTARD_FABRIC, TEAL_FABRIC, ROSE_FABRIC, PURPLE_FABRIC, NAVY_FABRIC];
/// Pale woods of toys.
pub(super) const TOY_WOODS: &[MaterialId] = &[BEECH, BIRCH, MAPLE, PINE];
