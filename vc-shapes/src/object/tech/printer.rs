//! Printers and scanners.

use super::grid;
use crate::material::*;
use crate::solid::{Build, P, blocks, half_dims, tube};

/// A printer: body, paper coming out in front, a panel of keys, a cassette that slides out, and
/// sometimes a scanner on top.
pub(super) fn printer(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let (body, trim) = b.choose(&[
        (WHITE_PLASTIC, GREY_PLASTIC),
        (BLACK_PLASTIC, GREY_PLASTIC),
        (LIGHT_GREY, BLACK_PLASTIC),
        (WHITE_PLASTIC, BLACK_PLASTIC),
    ]);
    let t = (x * 0.03).min(0.006);
    let out = (x * 0.05).min(0.02);
    let front = x - out;
    let scanner = b.class == "multifunction_printer";
    let top = if scanner { h * 0.8 } else { h * 0.993 };
    let (low, high) = (h * 0.24, h * 0.46);
    // The cassette at the bottom, the paper outlet above it, the mechanism on top.
    let walls = [
        ([-x, -y, 0.0], [front, y, t]),
        ([-x, -y, t * 0.9], [front, -y + t, high]),
        ([-x, y - t, t * 0.9], [front, y, high]),
        ([-x, -y + t * 0.9, t * 0.9], [-x + t, y - t * 0.9, high]),
        ([-x + t * 0.9, -y + t * 0.9, low], [front, y - t * 0.9, low + t]),
    ];
    blocks(b, "case", &walls, body);
    b.rounded_block("works", [-x, -y, high - 0.001], [front, y, top], x * 0.06, body);
    b.block("dark", [-x * 0.2, -y + t * 0.9, low + t * 0.9], [x * 0.1, y - t * 0.9, high * 0.99], SCREEN);
    b.inside(
        "compartment",
        [(x * 0.1 + front) / 2.0, 0.0, low + t],
        ((front - x * 0.1) / 2.0 - t, y - 2.0 * t),
        (high - low - t).max(0.0),
    );
    b.slide([1.0, 0.0, 0.0], x, |b| {
        let w = y - 1.3 * t;
        b.block("cassette", [front - t, -w, t * 1.3], [front + out * 0.3, w, low * 0.96], trim);
        b.block("cassette", [-x + 2.0 * t, -w * 0.98, t * 1.5], [front - t * 0.9, w * 0.98, t * 2.2], trim);
        b.block("paper", [-x + 3.0 * t, -w * 0.8, t * 2.1], [front - 2.0 * t, w * 0.8, low * 0.6], WHITE_PAPER);
        b.block("grip", [front + out * 0.2, -y * 0.25, low * 0.4], [x, y * 0.25, low * 0.6], body);
    });
    let panel = (top - high) * 0.5;
    let z = high + panel * 0.55;
    blocks(b, "display", &[([front - 0.003, -y * 0.85, z], [front + out * 0.25, -y * 0.35, z + panel])], SCREEN);
    blocks(
        b,
        "picture",
        &[([front, -y * 0.8, z + panel * 0.2], [front + out * 0.25 + 0.0012, -y * 0.4, z + panel * 0.8])],
        PICTURE_SKY,
    );
    let keys = grid((2, 4), |i, j| {
        (
            [front - 0.003, -y * 0.25 + y * 0.14 * j, z + panel * 0.55 * i],
            [front + out * 0.3, -y * 0.16 + y * 0.14 * j, z + panel * (0.55 * i + 0.35)],
        )
    });
    blocks(b, "key", &keys, trim);
    blocks(b, "light", &[([front - 0.003, y * 0.6, z], [front + out * 0.3, y * 0.66, z + panel * 0.3])], LED);
    if scanner {
        b.hinge([-x, 0.0, top], [0.0, -1.0, 0.0], 1.4, |b| {
            b.rounded_block("lid", [-x, -y, top + h * 0.002], [front, y, top + (h - top) * 0.6], (h - top) * 0.2, body);
            b.rounded_block(
                "feeder",
                [-x * 0.9, -y * 0.8, top + (h - top) * 0.55],
                [x * 0.1, y * 0.3, h],
                (h - top) * 0.2,
                trim,
            );
        });
        b.block("glass", [-x * 0.8, -y * 0.85, top - 0.002], [front * 0.85, y * 0.6, top + h * 0.002], BLACK_GLASS);
    } else {
        b.block("slot", [-x * 0.75, -y * 0.7, h * 0.96], [-x * 0.6, y * 0.7, h], SCREEN);
    }
}

/// A label printer with a strip coming out of it.
pub(super) fn label_printer(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let body = b.choose(&[GREY_PLASTIC, BLACK_PLASTIC, WHITE_PLASTIC, BLUE_PLASTIC]);
    let front = x * 0.85;
    let seam = h * 0.55;
    b.rounded_block("body", [-x, -y, 0.0], [front, y, seam], h * 0.1, body);
    b.hinge([-x, 0.0, seam], [0.0, -1.0, 0.0], 1.4, |b| {
        b.rounded_block("lid", [-x, -y, seam + h * 0.002], [front, y, h * 0.97], h * 0.15, body);
        b.block("window", [-x * 0.4, -y * 0.5, h * 0.9], [x * 0.3, y * 0.5, h], SCREEN);
    });
    b.block("label", [front - x * 0.1, -y * 0.5, h * 0.4], [x, y * 0.5, h * 0.4 + (h * 0.02).min(0.001)], WHITE_PAPER);
    let keys: Vec<(P, P)> = [-0.6, 0.0, 0.4]
        .map(|s| ([front - 0.003, y * s, h * 0.15], [front + 0.002, y * (s + 0.25), h * 0.28]))
        .to_vec();
    blocks(b, "key", &keys, LED);
}

/// A 3D printer: an open frame, a bed, a head on rails, a spool.
pub(super) fn three_d_printer(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let frame = b.choose(&[BLACK_METAL, ALUMINIUM, ORANGE_PLASTIC]);
    let t = (x * 0.1).min(0.022);
    let base = h * 0.14;
    b.rounded_block("base", [-x, -y, 0.0], [x * 0.995, y, base], t * 0.4, BLACK_PLASTIC);
    let top = h - t;
    let post = |sy: f32| {
        ([-x * 0.2 - t * 0.5, sy * (y - t) - t * 0.5, base - 0.002], [-x * 0.2 + t * 0.5, sy * (y - t) + t * 0.5, top])
    };
    blocks(
        b,
        "post",
        &[
            post(-1.0),
            post(1.0),
            ([-x * 0.2 - t * 0.5, -y + t * 0.5, top - 0.001], [-x * 0.2 + t * 0.5, y - t * 0.5, h]),
        ],
        frame,
    );
    let bed = base + t * 1.2;
    b.block("carriage", [-x * 0.2, -y * 0.3, base - 0.002], [x * 0.4, y * 0.3, bed - t * 0.35], ALUMINIUM);
    b.block("bed", [-x * 0.85, -y * 0.75, bed - t * 0.4], [x * 0.9, y * 0.75, bed], BLACK_GLASS);
    let rail = base + (top - base) * b.vary(0.45, 0.7);
    b.rod("rail", [-x * 0.2, -y + t, rail], [-x * 0.2, y - t, rail], t * 0.35, STEEL);
    let at = y * b.vary(-0.3, 0.3);
    b.rounded_block(
        "head",
        [-x * 0.2, at - t * 1.3, rail - t * 1.6],
        [-x * 0.2 + t * 2.6, at + t * 1.3, rail + t],
        t * 0.3,
        frame,
    );
    b.lathe(
        "nozzle",
        [-x * 0.2 + t * 1.3, at, rail - t * 2.2],
        &[(t * 0.08, 0.0), (t * 0.4, t * 0.4), (t * 0.4, t * 0.7)],
        BRASS,
    );
    let colour = b.choose(&[ORANGE_PLASTIC, GREEN_PLASTIC, WHITE_PLASTIC, BLUE_PLASTIC]);
    let r = (y * 0.35).min((top - rail) * 0.6).min(x * 0.5);
    let reel = [-x * 0.62, 0.0, top - r];
    b.rod("reel", [reel[0] - t, 0.0, reel[2]], [reel[0] + t, 0.0, reel[2]], r, colour);
    b.rod("axle", [reel[0], 0.0, reel[2]], [-x * 0.2, 0.0, reel[2]], t * 0.3, BLACK_PLASTIC);
    b.block("arm", [-x * 0.2 - t * 0.45, -t, reel[2] - t * 0.5], [-x * 0.2 + t * 0.45, t, top], frame);
    tube(
        b,
        "filament",
        &[[reel[0], r * 0.9, reel[2]], [-x * 0.3, at + r * 0.2, top - t], [-x * 0.2 + t, at, rail + t * 0.8]],
        t * 0.1,
        colour,
    );
    b.block("panel", [x - t * 0.2, y * 0.2, base * 0.25], [x, y * 0.7, base * 0.8], PICTURE_SKY);
    b.top("bed", [x * 0.55, 0.0, bed], (x * 0.3, y * 0.7));
}

/// A flat-bed scanner with its lid.
pub(super) fn scanner(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let body = b.choose(&[BLACK_PLASTIC, WHITE_PLASTIC, GREY_PLASTIC]);
    let seam = h * 0.62;
    b.rounded_block("body", [-x, -y, 0.0], [x, y, seam], h * 0.15, body);
    b.block("glass", [-x * 0.85, -y * 0.85, seam - 0.003], [x * 0.75, y * 0.85, seam + 0.0003], BLACK_GLASS);
    b.hinge([-x, 0.0, seam], [0.0, -1.0, 0.0], 1.5, |b| {
        b.rounded_block("lid", [-x, -y * 0.98, seam + h * 0.01], [x * 0.88, y * 0.98, h * 0.97], h * 0.15, body);
        b.block("mark", [x * 0.5, -y * 0.2, h * 0.9], [x * 0.62, y * 0.2, h], SILVER_METAL);
    });
    let keys: Vec<(P, P)> = (0..4)
        .map(|i| y * (-0.4 + 0.22 * i as f32))
        .map(|a| ([x * 0.91, a, seam * 0.8], [x * 0.97, a + y * 0.12, seam + h * 0.03]))
        .collect();
    blocks(b, "key", &keys, GREY_PLASTIC);
}
