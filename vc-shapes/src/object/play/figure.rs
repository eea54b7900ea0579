//! Figures: dolls, puppets, heroes and robots.

use crate::material::*;
use crate::object::palette::*;
use crate::solid::{Axis, Build, Proportional, SIDES, oval_outline};

/// A standing doll in a dress or in trousers.
pub(super) fn doll(b: &mut Build<'_>) {
    let skin = b.choose(&[SKIN, BROWN_SKIN, EGGSHELL]);
    let (cloth, shoe) = (b.one_of(CLOTHS), b.choose(&[BLACK_LEATHER, WHITE_LEATHER, RED_FABRIC]));
    let hair = b.choose(&[CHOCOLATE, BLACK_FABRIC, MUSTARD_FABRIC, RUST_FABRIC]);
    let dress = b.rng.chance(0.6);
    for y in SIDES {
        let leg = if dress { skin } else { DENIM };
        b.skin("leg", Axis::Z, &[([0.0, y * 0.3, 0.03], 0.3, 0.18), ([0.0, y * 0.28, 0.42], 0.4, 0.24)], leg);
        // The doll stands on flat soles.
        b.skin("shoe", Axis::Z, &[([0.1, y * 0.3, 0.0], 0.6, 0.2), ([0.1, y * 0.3, 0.06], 0.5, 0.18)], shoe);
        let arm =
            [([0.0, y * 0.9, 0.36], 0.2, 0.09), ([0.0, y * 0.6, 0.56], 0.3, 0.14), ([0.0, y * 0.4, 0.62], 0.3, 0.12)];
        b.skin("arm", Axis::Z, &arm, if dress { skin } else { cloth });
        b.ellipsoid("hand", [0.0, y * 0.9, 0.345], [0.2, 0.1, 0.035], skin);
    }
    let hem = if dress { (0.22, 0.95, 0.75) } else { (0.38, 0.6, 0.5) };
    let gown = [
        ([0.0, 0.0, hem.0], hem.1, hem.2),
        ([0.0, 0.0, 0.46], 0.5, 0.4),
        ([0.0, 0.0, 0.62], 0.5, 0.45),
        ([0.0, 0.0, 0.67], 0.2, 0.15),
    ];
    b.skin("dress", Axis::Z, &gown, cloth);
    b.within([-1.0, -0.62, 0.64], [1.0, 0.62, 1.0], |b| head(b, skin, hair));
    if b.rng.chance(0.5) {
        let back = [([-0.55, 0.0, 0.5], 0.3, 0.35), ([-0.6, 0.0, 0.8], 0.4, 0.55), ([-0.4, 0.0, 0.92], 0.3, 0.4)];
        b.skin("hair", Axis::Z, &back, hair);
    }
}

/// A head with hair, eyes and mouth that fills the size.
fn head(b: &mut Build<'_>, skin: MaterialId, hair: MaterialId) {
    b.ellipsoid("head", [0.02, 0.0, 0.48], [0.9, 0.86, 0.48], skin);
    b.ellipsoid("hair", [-0.14, 0.0, 0.58], [0.86, 0.97, 0.42], hair);
    for y in SIDES {
        b.ellipsoid("eye", [0.8, y * 0.32, 0.5], [0.12, 0.12, 0.07], BLACK_PLASTIC);
    }
    b.ellipsoid("nose", [0.9, 0.0, 0.4], [0.08, 0.09, 0.05], skin);
    b.ellipsoid("mouth", [0.78, 0.0, 0.25], [0.12, 0.2, 0.03], RED_PLASTIC);
}

/// A glove puppet: a wide gown with head and hands.
pub(super) fn puppet(b: &mut Build<'_>) {
    let (cloth, trim) = (b.one_of(CLOTHS), b.one_of(CLOTHS));
    let skin = b.choose(&[SKIN, BROWN_SKIN, GREEN_FABRIC, GREY_FABRIC]);
    let ring = |z: f32, x: f32, y: f32| ([0.0, 0.0, z], x, y);
    b.skin(
        "gown",
        Axis::Z,
        &[ring(0.0, 0.85, 0.6), ring(0.3, 0.6, 0.42), ring(0.55, 0.45, 0.35), ring(0.62, 0.2, 0.15)],
        cloth,
    );
    b.skin("hem", Axis::Z, &[ring(0.004, 0.95, 0.66), ring(0.06, 0.92, 0.62)], trim);
    for y in SIDES {
        let sleeve = [([0.0, y * 0.2, 0.5], 0.35, 0.07), ([0.1, y * 0.8, 0.58], 0.3, 0.06)];
        b.skin("sleeve", Axis::Y, &sleeve, cloth);
        b.ellipsoid("hand", [0.12, y * 0.87, 0.585], [0.3, 0.13, 0.05], skin);
    }
    b.within([-0.9, -0.5, 0.58], [0.9, 0.5, 0.95], |b| head(b, skin, trim));
    if b.rng.chance(0.5) {
        b.skin("hat", Axis::Z, &[ring(0.84, 0.7, 0.4), ring(0.9, 0.5, 0.28), ring(1.0, 0.0, 0.0)], trim);
    } else {
        b.ellipsoid("bobble", [0.0, 0.0, 0.955], [0.25, 0.16, 0.045], trim);
    }
}

/// A hero in boots and cape on a round base.
pub(super) fn action_figure(b: &mut Build<'_>) {
    let (suit, trim, cape) = (b.one_of(BRIGHT), b.one_of(BRIGHT), b.one_of(BRIGHT));
    let ring = |z: f32, x: f32, y: f32| ([0.0, 0.0, z], x, y);
    b.plan_outline("stand", (0.0, 0.025), &oval_outline((0.0, 0.0), (1.0, 0.75), 16), BLACK_PLASTIC);
    for y in SIDES {
        let leg = |z: f32, r: f32| ([0.0, y * (0.34 - z * 0.25), z], r * 1.3, r);
        b.skin("leg", Axis::Z, &[leg(0.2, 0.14), leg(0.34, 0.19), leg(0.48, 0.22)], suit);
        b.skin("boot", Axis::Z, &[leg(0.02, 0.16), leg(0.22, 0.19)], trim);
        b.ellipsoid("toe", [0.35, y * 0.33, 0.045], [0.4, 0.17, 0.03], trim);
        let arm =
            [([0.25, y * 0.9, 0.45], 0.2, 0.09), ([0.0, y * 0.82, 0.62], 0.3, 0.14), ([0.0, y * 0.62, 0.76], 0.4, 0.2)];
        b.skin("arm", Axis::Z, &arm, suit);
        b.ellipsoid("fist", [0.3, y * 0.88, 0.43], [0.28, 0.12, 0.04], trim);
    }
    let torso = [
        ring(0.45, 0.5, 0.38),
        ring(0.55, 0.46, 0.36),
        ring(0.7, 0.7, 0.58),
        ring(0.78, 0.5, 0.48),
        ring(0.82, 0.2, 0.15),
    ];
    b.skin("torso", Axis::Z, &torso, suit);
    b.skin("belt", Axis::Z, &[ring(0.475, 0.58, 0.43), ring(0.51, 0.58, 0.43)], trim);
    b.ellipsoid("badge", [0.62, 0.0, 0.69], [0.12, 0.2, 0.05], trim);
    b.ellipsoid("head", [0.0, 0.0, 0.9], [0.5, 0.3, 0.1], SKIN);
    b.ellipsoid("mask", [0.02, 0.0, 0.93], [0.53, 0.32, 0.068], trim);
    if b.rng.chance(0.6) {
        let corners = [[-0.5, 0.42, 0.77], [-0.5, -0.42, 0.77], [-0.95, 0.7, 0.14], [-0.95, -0.7, 0.14]];
        let inner = corners.map(|[x, y, z]| [x + 0.12, y, z]);
        b.chunk("cape", &[corners, inner].concat(), cape);
    }
}

/// A robot of boxes with a lamp on its head and a panel on its chest.
pub(super) fn robot(b: &mut Build<'_>) {
    let (case, trim) = (b.choose(&[GREY_PLASTIC, WHITE_PLASTIC, BLUE_PLASTIC, RED_PLASTIC, STEEL]), b.one_of(BRIGHT));
    let r = b.size.z * 0.01;
    for y in SIDES {
        b.pad("foot", [-0.95, y * 0.45 - 0.2, 0.0], [0.95, y * 0.45 + 0.2, 0.08], r, trim);
        b.pad("leg", [-0.25, y * 0.42 - 0.13, 0.07], [0.25, y * 0.42 + 0.13, 0.3], r, case);
        b.wheel("shoulder", Axis::Y, [0.0, y * 0.72, 0.6], (b.size.z * 0.05, b.size.y * 0.1), trim);
        b.pad("arm", [-0.25, y * 0.88 - 0.11, 0.36], [0.25, y * 0.88 + 0.11, 0.64], r, case);
        b.slab("claw", [0.0, y * 0.88 - 0.09, 0.3], [0.5, y * 0.88 - 0.03, 0.37], trim);
        b.slab("claw", [0.0, y * 0.88 + 0.03, 0.3], [0.5, y * 0.88 + 0.09, 0.37], trim);
    }
    b.pad("body", [-0.75, -0.68, 0.28], [0.75, 0.68, 0.68], r * 2.0, case);
    b.slab("panel", [0.7, -0.5, 0.36], [0.8, 0.5, 0.6], BLACK_PLASTIC);
    for (i, lamp) in [SIGNAL_RED, SIGNAL_AMBER, SIGNAL_GREEN].into_iter().enumerate() {
        let y = 0.3 - 0.3 * i as f32;
        b.ellipsoid("lamp", [0.8, y, 0.54], [0.08, 0.09, 0.03], lamp);
    }
    b.slab("grille", [0.79, -0.38, 0.4], [0.86, 0.38, 0.45], trim);
    b.pole("neck", [0.0, 0.0, 0.66], [0.0, 0.0, 0.74], b.size.z * 0.035, trim);
    if b.rng.chance(0.4) {
        b.ellipsoid("head", [0.0, 0.0, 0.82], [0.7, 0.55, 0.12], case);
    } else {
        b.pad("head", [-0.65, -0.52, 0.72], [0.65, 0.52, 0.93], r * 2.0, case);
    }
    for y in SIDES {
        b.wheel("eye", Axis::X, [0.64, y * 0.22, 0.85], (b.size.z * 0.032, b.size.x * 0.09), LED);
    }
    b.slab("mouth", [0.5, -0.2, 0.755], [0.68, 0.2, 0.78], BLACK_PLASTIC);
    b.pole("aerial", [0.0, 0.0, 0.9], [0.0, 0.0, 0.97], b.size.z * 0.008, STEEL);
    b.ellipsoid("aerial", [0.0, 0.0, 0.98], [0.14, 0.08, 0.02], SIGNAL_RED);
}
