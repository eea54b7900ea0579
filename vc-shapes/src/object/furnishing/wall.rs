//! Small devices on walls and ceilings.

use vc_graph::portable::Portable;

use crate::material::*;
use crate::object::cooker::fitting::*;
use crate::solid::{Build, collar, half_dims};

/// A round dial or a square plate with a figure.
pub(super) fn thermostat(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let mat = b.choose(&[WHITE_PLASTIC, WHITE_PLASTIC, BLACK_PLASTIC, STEEL]);
    let z = h / 2.0;
    if b.rng.chance(0.5) {
        let r = y.min(z);
        b.lathe_along(
            "case",
            [-x, 0.0, z],
            [x, 0.0, z],
            &[(r * 0.9, 0.0), (r, x * 0.6), (r, x * 1.2), (r * 0.85, x * 1.7)],
            mat,
        );
        b.rod("glass", [x * 0.4, 0.0, z], [x - 0.0025, 0.0, z], r * 0.7, BLACK_GLASS);
        display(b, x - 0.0025, (-r * 0.4, z - r * 0.2), (r * 0.4, z + r * 0.2), COOL_BULB);
    } else {
        b.rounded_block("case", [-x, -y, 0.0], [x - 0.0025, y, h], x * 0.5, mat);
        display(b, x - 0.0025, (-y * 0.6, z), (y * 0.6, h * 0.85), LED);
        let r = (h * 0.14).min(y * 0.5);
        b.lathe_along(
            "dial",
            [x - 0.004, 0.0, h * 0.25],
            [x + 1.0, 0.0, h * 0.25],
            &[(r, 0.0), (r * 0.9, 0.004)],
            GREY_PLASTIC,
        );
    }
}

/// A flat round case under the ceiling with slots, a light and a button.
pub(super) fn smoke_detector(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let r = x.min(y);
    let steep = b.vary(0.72, 0.9);
    b.lathe(
        "case",
        [0.0; 3],
        &[(r * 0.5, 0.0), (r * steep * 0.8, h * 0.12), (r * steep, h * 0.5), (r, h * 0.8), (r, h)],
        WHITE_PLASTIC,
    );
    let count = b.rng.count(5, 8);
    for i in 0..count {
        let (s, c) = (std::f32::consts::TAU * i as f32 / count as f32).sine_cosine();
        let k = r * steep * 0.93;
        b.ball("slot", [c * k, s * k, h * 0.36], h * 0.1, BLACK_PLASTIC);
    }
    b.cylinder("button", [0.0, 0.0, -h * 0.0], r * 0.16, h * 0.1, GREY_PLASTIC);
    b.ball("light", [r * 0.42, 0.0, h * 0.06], h * 0.05, SIGNAL_RED);
}

/// A push button on a plate, or one with a camera.
pub(super) fn doorbell(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let mat = b.choose(&[WHITE_PLASTIC, BLACK_PLASTIC, BRASS, STEEL]);
    let round = x * 0.6;
    b.rounded_block("plate", [-x, -y, 0.0], [x * 0.5, y, h], round, mat);
    let r = y * b.vary(0.4, 0.55);
    let low = h * 0.3;
    collar(b, "ring", ([x * 0.45, 0.0, low], [x * 0.8, 0.0, low]), (r * 0.82, (r * 1.05).min(low)), CHROME);
    let button = b.choose(&[WHITE_PLASTIC, LED]);
    b.rod("button", [x * 0.4, 0.0, low], [x, 0.0, low], r * 0.8, button);
    if b.rng.chance(0.5) {
        b.rod("camera", [x * 0.4, 0.0, h * 0.75], [x * 0.7, 0.0, h * 0.75], r * 0.7, BLACK_GLASS);
        b.rod("lens", [x * 0.6, 0.0, h * 0.75], [x * 0.8, 0.0, h * 0.75], r * 0.3, SCREEN);
    } else {
        b.block("name", [x * 0.45, -y * 0.7, h * 0.64], [x * 0.62, y * 0.7, h * 0.84], WHITE_PAPER);
    }
}

/// A handset on a plate, or a plate with a picture and buttons.
pub(super) fn intercom(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let mat = b.choose(&[WHITE_PLASTIC, WHITE_PLASTIC, GREY_PLASTIC, BLACK_PLASTIC]);
    let face = -x + x * 0.7;
    b.rounded_block("plate", [-x, -y, 0.0], [face, y, h], x * 0.2, mat);
    if b.rng.chance(0.5) {
        let hand = (-y * 0.9, -y * 0.25);
        b.rounded_block("handset", [face + x * 0.1, hand.0, h * 0.06], [x * 0.8, hand.1, h * 0.94], x * 0.3, mat);
        for z in [h * 0.08, h * 0.72] {
            b.rounded_block("ear", [face - 0.001, hand.0 * 1.05, z], [x, hand.1 * 0.95, z + h * 0.2], x * 0.3, mat);
        }
    } else {
        b.block("screen", [face - 0.001, -y * 0.85, h * 0.45], [face + x * 0.1, y * 0.85, h * 0.94], SCREEN);
        b.block("picture", [face, -y * 0.75, h * 0.5], [face + x * 0.2, y * 0.75, h * 0.9], PICTURE_DARK);
        for i in 0..5 {
            b.block(
                "slot",
                [face - 0.001, -y * 0.8, h * (0.12 + 0.05 * i as f32)],
                [face + x * 0.06, -y * 0.2, h * (0.14 + 0.05 * i as f32)],
                BLACK_PLASTIC,
            );
        }
        b.rod("lens", [face, y * 0.4, h * 0.2], [x * 1.0, y * 0.4, h * 0.2], y * 0.1, BLACK_GLASS);
    }
    for i in 0..2 {
        let z = h * (0.22 + 0.16 * i as f32);
        b.rod(
            "button",
            [face - 0.001, y * 0.55 + y * 0.1 * i as f32, z],
            [face + x * 0.3, y * 0.55 + y * 0.1 * i as f32, z],
            y * 0.14,
            if i == 0 { LED } else { GREY_PLASTIC },
        );
    }
}
