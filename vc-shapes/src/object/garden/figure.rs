//! Gnomes, statues and scarecrows.

use crate::material::*;
use crate::solid::{Build, P, at_least, blob, limb, polygon};

/// A gnome: boots, coat, beard, pointed cap, and a spade or lantern.
pub(super) fn gnome(b: &mut Build<'_>) {
    at_least(b, [0.04, 0.05, 0.1]);
    let (r, h) = (b.size.x.min(b.size.y) / 2.0, b.size.z);
    // The head is limited by the available width.
    let k = h.min(r * 6.5);
    let (coat, cap) = (b.choose(&[BLUE, GREEN, RED, MUSTARD, FOREST]), b.choose(&[RED, RED, GREEN, BLUE]));
    let (waist, neck) = (h * b.vary(0.16, 0.2), h * b.vary(0.46, 0.5));
    for side in [-1.0, 1.0] {
        b.rounded_block(
            "boot",
            [-r * 0.35, side * r * 0.4 - r * 0.3, 0.0],
            [r * 0.95, side * r * 0.4 + r * 0.3, h * 0.09],
            r * 0.15,
            BLACK,
        );
        b.cylinder("leg", [0.0, side * r * 0.38, h * 0.05], r * 0.27, waist - h * 0.04, NAVY);
    }
    b.lathe(
        "coat",
        [0.0, 0.0, waist - 0.01],
        &[(r * 0.85, 0.0), (r * 0.8, (neck - waist) * 0.4), (r * 0.5, neck - waist)],
        coat,
    );
    b.lathe("belt", [0.0, 0.0, waist + (neck - waist) * 0.3], &[(r * 0.85, 0.0), (r * 0.83, h * 0.025)], BLACK);
    b.block(
        "buckle",
        [r * 0.7, -r * 0.15, waist + (neck - waist) * 0.3],
        [r * 0.9, r * 0.15, waist + (neck - waist) * 0.3 + h * 0.025],
        GOLD,
    );
    let face = neck + h * 0.09;
    b.ball("head", [0.0, 0.0, face], k * 0.105, SKIN);
    b.ball("nose", [k * 0.11, 0.0, face], k * 0.025, SKIN);
    let beard = [
        [k * 0.1, 0.5, face - h * 0.01],
        [k * 0.02, 0.75, face],
        [k * 0.12, 0.3, face - h * 0.1],
        [k * 0.1, 0.0, face - h * 0.22],
        [k * 0.04, 0.5, face - h * 0.1],
    ];
    b.hull(
        "beard",
        &beard.iter().flat_map(|p| [[p[0], p[1] * k * 0.13, p[2]], [p[0], -p[1] * k * 0.13, p[2]]]).collect::<Vec<P>>(),
        WHITE,
    );
    let droop = b.vary(-0.3, 0.3) * r;
    let brim = face + h * 0.03;
    b.hull(
        "cap",
        &limb([0.0, 0.0, brim], [-droop * 0.4, droop * 0.5, brim + (h - brim) * 0.55], k * 0.12, k * 0.06),
        cap,
    );
    let tip =
        limb([-droop * 0.4, droop * 0.5, brim + (h - brim) * 0.54], [-droop, droop, h - 0.004], k * 0.06, k * 0.006);
    b.hull("cap", &tip.into_iter().map(|p| [p[0], p[1], p[2].min(h)]).collect::<Vec<P>>(), cap);
    for side in [-1.0, 1.0] {
        let hand = [r * 0.55, side * r * 0.76, waist + (neck - waist) * 0.35];
        b.hull("arm", &limb([0.0, side * r * 0.5, neck - h * 0.04], hand, k * 0.045, k * 0.035), coat);
        b.ball("hand", hand, k * 0.035, SKIN);
    }
    let grip = [r * 0.55, r * 0.76];
    match b.rng.below(3) {
        0 => {
            b.cylinder("spade", [grip[0], grip[1], h * 0.1], k * 0.014, h * 0.45, BEECH);
            b.block(
                "spade",
                [grip[0] - k * 0.008, grip[1] - k * 0.035, 0.0],
                [grip[0] + k * 0.008, grip[1] + k * 0.035, h * 0.14],
                STEEL,
            );
        }
        1 => {
            let z = waist + (neck - waist) * 0.35 - h * 0.13;
            b.cylinder("lantern", [grip[0], grip[1], z], k * 0.032, h * 0.09, WARM_BULB);
            b.cone("lantern", [grip[0], grip[1], z + h * 0.085], k * 0.036, h * 0.035, IRON);
        }
        _ => {
            let z = waist + (neck - waist) * 0.35;
            b.rod("rod", [grip[0], grip[1], z - h * 0.08], [grip[0], grip[1], h * 0.85], k * 0.01, BAMBOO);
        }
    }
}

/// A statue on a plinth: a bust, a figure, an urn, or an animal of stone.
pub(super) fn statue(b: &mut Build<'_>) {
    at_least(b, [0.1, 0.1, 0.2]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (r, mat) = (x.min(y), b.choose(&[MARBLE, SANDSTONE, CONCRETE, COPPER, GRANITE, PLASTER]));
    let foot = h * b.vary(0.12, 0.4);
    b.block("plinth", [-r, -r, 0.0], [r, r, foot * 0.2], mat);
    b.block("plinth", [-r * 0.85, -r * 0.85, foot * 0.2], [r * 0.85, r * 0.85, foot * 0.85], mat);
    b.block("plinth", [-r * 0.97, -r * 0.97, foot * 0.85], [r * 0.97, r * 0.97, foot], mat);
    let tall = h - foot;
    let at = |share: f32| foot + tall * share;
    // A slim statue is always a figure.
    let design = b.rng.below(4);
    match if tall > 5.0 * r { 1 } else { design } {
        0 => {
            let head = (tall * 0.24).min(r * 0.7);
            b.lathe(
                "bust",
                [0.0, 0.0, foot],
                &[
                    (r * 0.45, 0.0),
                    (r * 0.3, tall * 0.12),
                    (r * 0.85, tall * 0.4),
                    (r * 0.8, tall * 0.5),
                    (r * 0.28, tall * 0.6),
                    (r * 0.26, (tall * 0.75).max(tall - head)),
                ],
                mat,
            );
            let points = blob(b, [r * 0.05, 0.0, h - head], [head * 0.85, head * 0.72, head], 40, 0.03);
            b.hull("head", &points, mat);
            b.hull(
                "nose",
                &[
                    [head * 0.8, head * 0.1, h - head * 1.2],
                    [head * 0.8, -head * 0.1, h - head * 1.2],
                    [head * 1.05, 0.0, h - head * 1.2],
                    [head * 0.75, 0.0, h - head * 0.8],
                ],
                mat,
            );
        }
        1 => {
            // A robed figure with one arm raised.
            let head = (tall * 0.085).min(r * 0.4);
            b.lathe(
                "robe",
                [0.0, 0.0, foot - 0.002],
                &[
                    (r * 0.75, 0.0),
                    (r * 0.55, tall * 0.3),
                    (r * 0.42, tall * 0.5),
                    (r * 0.5, tall * 0.7),
                    (r * 0.15, tall * 0.8),
                    (r * 0.14, (tall * 0.86).max(tall - head)),
                ],
                mat,
            );
            b.ball("head", [0.0, 0.0, h - head], head, mat);
            let up = b.rng.chance(0.5);
            for side in [-1.0, 1.0] {
                let elbow = [r * 0.2, side * r * 0.75, at(0.55)];
                let hand = if side > 0.0 && up {
                    [r * 0.4, side * r * 0.6, at(0.92)]
                } else {
                    [r * 0.55, side * r * 0.25, at(0.5)]
                };
                b.hull("arm", &limb([0.0, side * r * 0.42, at(0.7)], elbow, r * 0.16, r * 0.13), mat);
                b.hull("arm", &limb(elbow, hand, r * 0.13, r * 0.1), mat);
            }
        }
        2 => {
            let profile = [
                (r * 0.5, 0.0),
                (r * 0.5, tall * 0.06),
                (r * 0.2, tall * 0.14),
                (r * 0.8, tall * 0.5),
                (r * 0.85, tall * 0.65),
                (r * 0.6, tall * 0.8),
                (r * 0.8, tall * 0.97),
                (r * 0.8, tall),
                (r * 0.7, tall),
                (r * 0.5, tall * 0.8),
            ];
            b.lathe("urn", [0.0, 0.0, foot - 0.002], &profile, mat);
        }
        _ => {
            // A lion or dog, seated.
            let head = (tall * 0.16).min(r * 0.5);
            let neck = at(0.72).max(h - head * 1.7);
            let chest = limb([-r * 0.1, 0.0, at(0.1)], [r * 0.25, 0.0, neck], r * 0.45, r * 0.34);
            b.hull("body", &chest, mat);
            let points = blob(b, [-r * 0.3, 0.0, at(0.18)], [r * 0.55, r * 0.6, tall * 0.2], 26, 0.1);
            b.hull("body", &points.into_iter().map(|p| [p[0], p[1], p[2].max(foot - 0.002)]).collect::<Vec<P>>(), mat);
            let points = blob(b, [r * 0.35, 0.0, h - head], [head * 0.9, head, head], 30, 0.08);
            b.hull("head", &points, mat);
            b.hull(
                "muzzle",
                &limb(
                    [r * 0.35 + head * 0.5, 0.0, h - head * 1.15],
                    [(r * 0.35 + head * 1.3).min(r * 0.95), 0.0, h - head * 1.2],
                    head * 0.5,
                    head * 0.35,
                ),
                mat,
            );
            for side in [-1.0, 1.0] {
                b.hull(
                    "leg",
                    &limb([r * 0.5, side * r * 0.25, foot], [r * 0.35, side * r * 0.22, at(0.5)], r * 0.13, r * 0.15),
                    mat,
                );
                b.hull(
                    "ear",
                    &limb(
                        [r * 0.3, side * head * 0.6, h - head * 0.5],
                        [r * 0.28, side * head * 0.75, h - head * 0.1],
                        head * 0.22,
                        head * 0.08,
                    ),
                    mat,
                );
            }
        }
    }
}

/// A scarecrow: a cross of poles, a coat, a straw head with a hat.
pub(super) fn scarecrow(b: &mut Build<'_>) {
    at_least(b, [0.1, 0.4, 0.6]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let coat = b.choose(&[RED_FABRIC, BLUE_FABRIC, BROWN_FABRIC, GREEN_FABRIC, DENIM]);
    let (hat, legs) = (b.choose(&[HAY, BLACK_FABRIC, BROWN_FABRIC]), b.choose(&[DENIM, BROWN_FABRIC, JUTE]));
    b.cylinder("pole", [0.0; 3], 0.02_f32.min(x * 0.4), h * 0.78, PINE);
    let arms = h * b.vary(0.66, 0.71);
    b.rod("cross", [0.0, -y + 0.03, arms], [0.0, y - 0.03, arms], 0.016_f32.min(x * 0.3), PINE);
    let wide = (y * 0.32).min(x * 1.4);
    let skirt: Vec<P> = [(h * 0.4, 1.1), (arms + h * 0.035, 0.85)]
        .into_iter()
        .flat_map(|(z, s)| polygon(8, 1.0, 0.39).into_iter().map(move |(px, py)| [px * x * 0.75, py * wide * s, z]))
        .collect();
    b.hull("coat", &skirt, coat);
    for side in [-1.0, 1.0] {
        let cuff = side * (y - 0.1_f32.min(y * 0.2));
        b.hull(
            "sleeve",
            &limb(
                [0.0, side * wide * 0.6, arms],
                [0.0, cuff, arms - h * 0.01],
                (h * 0.05).min(x * 0.6),
                (h * 0.042).min(x * 0.55),
            ),
            coat,
        );
        for i in 0..4 {
            let tip = [x * 0.4 * (i as f32 / 1.5 - 1.0), side * (y - 0.004), arms + h * 0.025 * (i as f32 - 1.8)];
            b.hull(
                "straw",
                &limb([0.0, cuff - side * 0.03, arms], tip, 0.008, 0.003)
                    .into_iter()
                    .map(|p| [p[0], p[1].max(-y).min(y), p[2]])
                    .collect::<Vec<P>>(),
                HAY,
            );
        }
        b.hull(
            "leg",
            &limb(
                [0.0, side * wide * 0.4, h * 0.42],
                [0.0, side * wide * 0.55, h * 0.14],
                (h * 0.05).min(x * 0.5),
                (h * 0.045).min(x * 0.5),
            ),
            legs,
        );
        let patch = b.choose(&[MUSTARD_FABRIC, RED_FABRIC, GREEN_FABRIC]);
        b.block(
            "patch",
            [x * 0.4, side * wide * 0.35 - 0.03, h * 0.5 + 0.05 * side],
            [x * 0.76, side * wide * 0.35 + 0.03, h * 0.5 + 0.05 * side + 0.06],
            patch,
        );
    }
    let head = (h * 0.075).min(x * 0.75);
    let face = arms + h * 0.04 + head;
    let points = blob(b, [0.0, 0.0, face], [head * 0.95, head, head * 1.1], 36, 0.06);
    b.hull("head", &points, JUTE);
    for side in [-1.0, 1.0] {
        b.ball("eye", [head * 0.85, side * head * 0.35, face + head * 0.25], head * 0.12, BLACK);
    }
    b.block("mouth", [head * 0.7, -head * 0.4, face - head * 0.35], [head * 0.95, head * 0.4, face - head * 0.25], RED);
    let brim = face + head * 0.6;
    b.lathe(
        "hat",
        [0.0, 0.0, brim],
        &[
            (x.min(head * 1.9), 0.0),
            (x.min(head * 1.9), 0.008),
            (head * 0.95, 0.02),
            (head * 0.6, (h - brim) * 0.75),
            (head * 0.1, h - brim),
        ],
        hat,
    );
    b.lathe("band", [0.0, 0.0, brim + 0.015], &[(head, 0.0), (head * 0.93, 0.03_f32.min(h * 0.02))], coat);
}
