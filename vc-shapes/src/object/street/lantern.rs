//! Street lamps.

use crate::material::*;
use crate::solid::{Build, CORNERS, P, at_least};
use std::f32::consts::FRAC_PI_2;
use vc_graph::portable::Portable;

/// A street lamp: an arm over the road, or a lantern, globe or disc on the post.
pub(super) fn street_lamp(b: &mut Build<'_>) {
    at_least(b, [0.08, 0.08, 1.5]);
    let metal = b.choose(&[ANTHRACITE, IRON, GREEN_METAL, GALVANISED, BLACK_METAL]);
    if b.size.x > 0.75 { arm_lamp(b, metal) } else { post_lamp(b, metal) }
}

/// A tapering mast up to height `top`, with a thicker foot.
fn mast(b: &mut Build<'_>, at: f32, radius: f32, top: f32, metal: MaterialId) {
    let foot = top * b.vary(0.1, 0.2);
    let profile = match b.rng.below(3) {
        0 => vec![(radius, 0.0), (radius, foot), (radius * 0.7, foot * 1.05), (radius * 0.45, top)],
        1 => vec![(radius, 0.0), (radius * 0.5, top)],
        _ => vec![
            (radius, 0.0),
            (radius, foot * 0.3),
            (radius * 0.75, foot * 0.4),
            (radius * 0.7, foot * 0.9),
            (radius * 0.9, foot * 0.95),
            (radius * 0.55, foot * 1.1),
            (radius * 0.5, top),
        ],
    };
    b.lathe("mast", [at, 0.0, 0.0], &profile, metal);
}

fn arm_lamp(b: &mut Build<'_>, metal: MaterialId) {
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let radius = (0.05 + h * 0.008).min(y);
    let base = -x + radius;
    let (arm, bulb) = (radius * 0.45, b.choose(&[WARM_BULB, COOL_BULB]));
    let head = (x * b.vary(0.35, 0.55)).clamp(0.12, 0.4);
    let wide = y.min(head * 0.5);
    let tip = x - 2.0 * head;
    let curved = b.rng.chance(0.6);
    let bend = (2.0 * x * 0.5).min(h * 0.2);
    let top = if curved { h - bend } else { h - 0.12 };
    mast(b, base, radius, top, metal);
    let level = h - arm - 0.016;
    if curved {
        let steps = 4;
        let points: Vec<P> = (0..=steps)
            .map(|i| FRAC_PI_2 * i as f32 / steps as f32)
            .map(|a| [base + (tip - base) * (1.0 - a.cosine()), 0.0, top - 0.02 + (level - top + 0.02) * a.sine()])
            .collect();
        b.pipe("arm", &points, arm, metal);
    } else {
        b.pipe("arm", &[[base, 0.0, top - 0.08], [tip, 0.0, level]], arm, metal);
        b.rod(
            "brace",
            [base, 0.0, top - 0.5_f32.min(h * 0.1)],
            [base + (tip - base) * 0.5, 0.0, (top + level) / 2.0 - 0.03],
            arm * 0.6,
            metal,
        );
    }
    let lamp = [x - head, 0.0, level];
    match b.rng.below(3) {
        0 => {
            b.taper(
                "head",
                [lamp[0], 0.0, level - 0.05],
                (head, wide),
                (head * 0.7, wide * 0.6),
                0.05 + arm * 0.9,
                metal,
            );
            b.block(
                "lamp",
                [x - 1.8 * head, -wide * 0.7, level - 0.062],
                [x - 0.2 * head, wide * 0.7, level - 0.045],
                bulb,
            );
        }
        1 => {
            b.rounded_block("head", [x - 2.0 * head, -wide, level - 0.035], [x, wide, level + arm], 0.015, metal);
            b.block(
                "lamp",
                [x - 1.7 * head, -wide * 0.75, level - 0.042],
                [x - 0.3 * head, wide * 0.75, level - 0.033],
                bulb,
            );
        }
        _ => {
            let r = head.min(wide * 1.5).min(y);
            b.lathe(
                "head",
                [x - r, 0.0, level - 0.1],
                &[(r, 0.0), (r * 0.7, 0.06), (r * 0.25, 0.1 + arm * 0.9)],
                metal,
            );
            b.lathe(
                "lamp",
                [x - r, 0.0, level - 0.1 - r * 0.4],
                &[(r * 0.1, 0.0), (r * 0.5, r * 0.1), (r * 0.7, r * 0.405)],
                bulb,
            );
            b.bar("arm", [tip, 0.0, level], [x - r, 0.0, level], arm, metal);
        }
    }
}

fn post_lamp(b: &mut Build<'_>, metal: MaterialId) {
    let (r, h) = (b.size.x.min(b.size.y) / 2.0, b.size.z);
    let bulb = b.choose(&[WARM_BULB, COOL_BULB]);
    let foot = r.min(0.04 + h * 0.014);
    let design = b.rng.below(4);
    let tall = (r * b.vary(2.2, 3.0)).max(0.2).min(h * 0.2);
    let top = h - tall;
    mast(b, 0.0, foot, top + 0.01, metal);
    match design {
        0 => {
            // A four-sided lantern: panes that widen upwards under a roof.
            b.taper("base", [0.0, 0.0, top], (r * 0.3, r * 0.3), (r * 0.5, r * 0.5), tall * 0.1, metal);
            b.taper(
                "pane",
                [0.0, 0.0, top + tall * 0.1],
                (r * 0.45, r * 0.45),
                (r * 0.8, r * 0.8),
                tall * 0.52,
                FROSTED_GLASS,
            );
            for (sx, sy) in CORNERS {
                let at = |share: f32, z: f32| [sx * r * share, sy * r * share, top + tall * z];
                b.rod("corner", at(0.46, 0.1), at(0.81, 0.62), 0.008, metal);
            }
            b.cylinder("lamp", [0.0, 0.0, top + tall * 0.11], r * 0.2, tall * 0.4, bulb);
            b.taper(
                "roof",
                [0.0, 0.0, top + tall * 0.62],
                (r * 0.98, r * 0.98),
                (r * 0.25, r * 0.25),
                tall * 0.25,
                metal,
            );
            b.cone("finial", [0.0, 0.0, top + tall * 0.86], r * 0.16, tall * 0.14, metal);
        }
        1 => {
            let globe = r.min(tall * 0.48);
            let cup = h - 1.8 * globe - top;
            let profile = [(globe * 0.35, 0.0), (globe * 0.6, cup), (globe * 0.2, cup)];
            b.lathe("cup", [0.0, 0.0, top], &profile, metal);
            b.ball("lamp", [0.0, 0.0, h - globe], globe, bulb);
        }
        2 => {
            b.cylinder("neck", [0.0, 0.0, top], r * 0.22, tall * 0.75, metal);
            b.cylinder("lamp", [0.0, 0.0, top + tall * 0.15], r * 0.55, tall * 0.55, bulb);
            b.lathe("disc", [0.0, 0.0, h - tall * 0.3], &[(r, 0.0), (r, tall * 0.06), (r * 0.4, tall * 0.3)], metal);
        }
        _ => {
            b.cylinder("lamp", [0.0, 0.0, top], r * 0.8, tall * 0.8, bulb);
            for i in 0..4 {
                let z = top + tall * (0.1 + 0.2 * i as f32);
                b.cylinder("fin", [0.0, 0.0, z], r * 0.97, tall * 0.03, metal);
            }
            b.lathe("cap", [0.0, 0.0, top + tall * 0.79], &[(r, 0.0), (r, tall * 0.1), (r * 0.5, tall * 0.21)], metal);
        }
    }
}
