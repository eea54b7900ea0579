//! Unpackaged toiletries: soap, razors, brushes, cosmetics.

use vc_graph::portable::Portable;

use super::label::{GROWTH, panel};
use super::look::look;
use crate::material::*;
use crate::solid::{
    Axis, Build, CORNERS, P, arch, dims, flat_ring, level_oval, loft_columns, lump, planar_tube, rounded_by_share,
    rounded_ring, sweep, tub, turn, vessel_profile,
};

const BRIGHT: [MaterialId; 7] =
    [WHITE_PLASTIC, BLUE_PLASTIC, GREEN_PLASTIC, PINK_PLASTIC, PURPLE_PLASTIC, ORANGE_PLASTIC, RED_PLASTIC];

/// Bars of soap with an embossed letter; the class `soap` is sometimes a bottle.
pub(super) fn soap(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    if z > 0.07 {
        return super::flask::oval_bottle(b);
    }
    let mat = b.choose(&[SOAP, PETAL_PINK, WAX, LIGHT_LEAF, PETAL_WHITE, PETAL_BLUE]);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let round = b.choose(&[1.0, 0.5, 0.3]);
    let at = |z: f32, k: f32| rounded_ring(z, (hx * k, hy * k), round);
    loft_columns(
        b,
        "soap",
        &[at(0.0, 0.82), at(z * 0.2, 0.96), at(z * 0.5, 1.0), at(z * 0.78, 0.95), at(z * 0.94, 0.8)],
        mat,
    );
    b.prism("stamp", Axis::Z, [0.0, 0.0, z * 0.9], &rounded_by_share((hx * 0.4, hy * 0.5), 1.0), z * 0.1, mat);
}

/// A ribbed soap dish.
pub(super) fn soap_dish(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let mat = b.choose(&[PORCELAIN, b.style.crockery, BAMBOO, WHITE_PLASTIC, STEEL]);
    let t = z * 0.12;
    tub(b, "dish", &[(0.0, hx * 0.75, hy * 0.8), (z * 0.6, hx * 0.95, hy * 0.96), (z, hx, hy)], 0.8, t, mat);
    for i in 0..5 {
        let at = hy * 0.6 * (i as f32 / 2.0 - 1.0);
        b.block("rib", [-hx * 0.5, at - hy * 0.04, t * 0.5], [hx * 0.5, at + hy * 0.04, t * 2.0], mat);
    }
    b.top("top", [0.0, 0.0, t * 2.0], (hx * 0.5, hy * 0.55));
}

/// Standing toothbrushes: a handle, a neck, bristles to the front.
pub(super) fn toothbrush(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let electric = b.class == "electric_toothbrush";
    let (body, tip) = (b.choose(&BRIGHT), b.choose(&[WHITE_PLASTIC, BLUE_PLASTIC, GREEN_PLASTIC]));
    let (hx, hy) = (x / 2.0, y / 2.0);
    let head = z * if electric { 0.95 } else { 0.88 };
    if electric {
        let skin = b.choose(&[WHITE_PLASTIC, BLACK_PLASTIC, PINK_PLASTIC, BLUE_PLASTIC]);
        turn(
            b,
            "handle",
            [0.0; 3],
            (hx.min(hy), z * 0.66),
            &[(0.9, 0.0), (0.85, 0.1), (1.0, 0.3), (0.9, 0.8), (0.6, 0.97), (0.4, 1.0)],
            skin,
        );
        turn(
            b,
            "neck",
            [0.0, 0.0, z * 0.65],
            (hx * 0.35, z * 0.3),
            &[(1.0, 0.0), (0.6, 0.5), (0.5, 1.0)],
            WHITE_PLASTIC,
        );
        b.rod("head", [-hx * 0.3, 0.0, head], [hx * 0.25, 0.0, head], (z - head).min(hy * 0.5), WHITE_PLASTIC);
        b.rod("bristles", [hx * 0.2, 0.0, head], [hx * 0.95, 0.0, head], (z - head).min(hy * 0.45) * 0.85, tip);
        b.rounded_block(
            "button",
            [hx * 0.6, -hy * 0.25, z * 0.4],
            [hx * 0.99, hy * 0.25, z * 0.46],
            hx * 0.1,
            GREY_PLASTIC,
        );
        return;
    }
    let (w, t) = (hy * 0.9, hx * 0.45);
    let at = |k: f32, lean: f32| [-hx + t + lean * hx, 0.0, z * k];
    let path = [
        (at(0.0, 0.1), w * 0.5, t * 0.6),
        (at(0.03, 0.1), w * 0.8, t * 0.9),
        (at(0.25, 0.2), w, t),
        (at(0.5, 0.1), w * 0.85, t),
        (at(0.72, 0.0), w * 0.35, t * 0.6),
        (at(0.8, 0.0), w * 0.45, t * 0.6),
        (at(0.86, 0.0), w, t * 0.6),
        (at(0.97, 0.0), w, t * 0.6),
        (at(1.0, 0.0), w * 0.6, t * 0.5),
    ];
    sweep(b, "handle", &path, [0.0, 1.0, 0.0], body);
    for i in 0..4 {
        let low = z * (0.855 + 0.032 * i as f32);
        b.block(
            "bristles",
            [-hx + t, -w * 0.75, low],
            [hx * (1.0 - 0.1 * (i % 2) as f32), w * 0.75, low + z * 0.025],
            if i % 2 == 0 { WHITE_PLASTIC } else { tip },
        );
    }
}

/// A toothbrush beaker whose lid has holes for brushes.
pub(super) fn toothbrush_holder(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let mat = b.choose(&[PORCELAIN, b.style.crockery, STEEL, BAMBOO, FROSTED_GLASS]);
    let t = (hx * 0.08).min(0.004);
    let round = b.choose(&[1.0, 0.4]);
    tub(b, "beaker", &[(0.0, hx * 0.9, hy * 0.9), (z * 0.05, hx * 0.95, hy * 0.95), (z, hx, hy)], round, t, mat);
    b.inside("inside", [0.0, 0.0, t], (hx * 0.55, hy * 0.55), z * 0.9);
}

/// Standing razors: a head across the top of a handle.
pub(super) fn razor(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let mat = b.choose(&[STEEL, BLUE_PLASTIC, PINK_PLASTIC, BLACK_PLASTIC, ORANGE_PLASTIC]);
    let r = (hy * 0.3).min(hx * 0.55);
    let back = -hx + r;
    if b.rng.chance(0.4) {
        return safety_razor(b, mat);
    }
    let (grip, waist) = (b.vary(0.22, 0.4), b.vary(0.55, 0.8));
    let path = [
        ([back, 0.0, 0.0], r * 0.7, r * 0.7),
        ([back, 0.0, z * 0.05], r, r),
        ([back, 0.0, z * grip], r, r * 0.9),
        ([back, 0.0, z * 0.6], r * waist, r * 0.7),
        ([back + hx * 0.2, 0.0, z * 0.85], r * 0.5, r * 0.5),
        ([hx * 0.2, 0.0, z * 0.95], r * 0.5, r * 0.5),
    ];
    sweep(b, "handle", &path, [0.0, 1.0, 0.0], mat);
    b.rounded_block("head", [-hx * 0.2, -hy, z * 0.9], [hx * 0.9, hy, z], z * 0.02, BLACK_PLASTIC);
    let blades = b.rng.count(2, 5);
    for i in 0..blades {
        let low = z * (0.918 + 0.07 / blades as f32 * i as f32);
        b.block("blade", [hx * 0.7, -hy * 0.9, low], [hx, hy * 0.9, low + z * 0.008], STEEL);
    }
}

/// A safety razor: one blade between two plates, on a straight handle with rings.
fn safety_razor(b: &mut Build<'_>, mat: MaterialId) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let r = (hy * 0.24).min(hx * 0.5);
    let neck = z * b.vary(0.78, 0.86);
    let handle = [(0.8, 0.0), (1.0, 0.03), (1.0, 0.6), (0.55, 0.75), (0.6, 1.0)];
    turn(b, "handle", [0.0; 3], (r, neck), &handle, mat);
    let rings = b.rng.count(3, 6);
    for i in 0..rings {
        let low = neck * (0.1 + 0.45 * i as f32 / rings as f32);
        flat_ring(b, "ring", (low, low + z * 0.02), (r * 0.9, r * 1.15), CHROME);
    }
    turn(b, "neck", [0.0, 0.0, neck * 0.98], (r * 0.5, z * 0.95 - neck * 0.98), &[(1.0, 0.0), (1.0, 1.0)], CHROME);
    b.rounded_block("plate", [-hx, -hy * 0.96, z * 0.93], [hx, hy * 0.96, z * 0.955], z * 0.008, CHROME);
    b.block("blade", [-hx * 0.97, -hy, z * 0.954], [hx * 0.97, hy, z * 0.962], STEEL);
    b.rounded_block("plate", [-hx * 0.9, -hy * 0.96, z * 0.961], [hx * 0.9, hy * 0.96, z], z * 0.03, CHROME);
}

/// A standing electric shaver with round or straight foils.
pub(super) fn electric_shaver(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let body = b.choose(&[BLACK_PLASTIC, GREY_PLASTIC, NAVY, WHITE_PLASTIC]);
    let at = |z: f32, kx: f32, ky: f32| rounded_ring(z, (hx * kx, hy * ky), 0.9);
    loft_columns(
        b,
        "body",
        &[
            at(0.0, 0.6, 0.6),
            at(z * 0.1, 0.75, 0.72),
            at(z * 0.4, 0.9, 0.8),
            at(z * 0.65, 0.75, 0.7),
            at(z * 0.78, 0.7, 0.75),
        ],
        body,
    );
    loft_columns(
        b,
        "head",
        &[at(z * 0.77, 0.75, 0.85), at(z * 0.84, 1.0, 1.0), at(z * 0.9, 0.98, 1.0), at(z * 0.93, 0.9, 0.9)],
        STEEL,
    );
    for (dx, dy) in [(0.4, 0.0), (-0.35, 0.45), (-0.35, -0.45)] {
        b.cylinder("foil", [hx * dx, hy * dy, z * 0.92], hx.min(hy) * 0.38, z * 0.05, CHROME);
        b.cylinder("foil", [hx * dx, hy * dy, z * 0.95], hx.min(hy) * 0.2, z * 0.05, BLACK_METAL);
    }
    b.rounded_block("button", [hx * 0.8, -hy * 0.2, z * 0.36], [hx * 0.98, hy * 0.2, z * 0.48], hx * 0.06, LED);
}

/// Perfume and aftershave bottles: a block of glass, a neck and a cap.
pub(super) fn flacon(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let look = look(b);
    let (hx, hy) = (x / 2.0 - 0.001_f32.min(x * 0.03), y / 2.0);
    let nail = matches!(b.class, "nail_polish" | "foundation");
    let h = z * if nail { 0.5 } else { b.vary(0.6, 0.72) };
    let neck = hx.min(hy) * 0.4;
    let ring = |z: f32, r: f32| rounded_ring(z, (r, r), 1.0);
    let round = b.choose(&[0.1, 0.4, 1.0]);
    let at = |z: f32, k: f32| rounded_ring(z, (hx * k, hy * k), round);
    let shoulder = b.choose(&[0.95, 0.7, 1.0]);
    loft_columns(
        b,
        "flacon",
        &[at(0.0, 0.93), at(h * 0.05, 1.0), at(h * 0.7, 1.0), at(h * 0.95, shoulder), at(h, shoulder * 0.85)],
        look.body,
    );
    loft_columns(b, "neck", &[ring(h * 0.98, neck * 0.8), ring(h + (z - h) * 0.2, neck * 0.8)], GOLD);
    let (low, wide) = (h + (z - h) * 0.15, neck * if nail { 1.1 } else { 1.5 });
    let cap = match b.rng.below(3) {
        0 => [(low, wide), (z * 0.98, wide), (z, wide * 0.9)],
        1 => [(low, wide * 0.8), (f32::midpoint(low, z), wide), (z, wide * 0.6)],
        _ => [(low, wide), (f32::midpoint(low, z), wide * 0.85), (z, wide * 0.75)],
    };
    let rings: Vec<_> = cap.iter().map(|c| ring(c.0, c.1.min(hx))).collect();
    loft_columns(b, "cap", &rings, look.cap);
    if !nail {
        panel(b, hx, (0.0, hy * 0.45), (h * 0.25, h * 0.6), (look.paper, GOLD));
    }
}

/// Lipstick and mascara: a cylinder of two parts; a lipstick is sometimes open.
pub(super) fn stick(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let r = x.min(y) / 2.0;
    let (body, cap) = (
        b.choose(&[BLACK_PLASTIC, GOLD, WHITE_PLASTIC, RED_METAL]),
        b.choose(&[GOLD, BLACK_PLASTIC, CHROME, PINK_PLASTIC]),
    );
    if b.class == "lipstick" && b.rng.chance(0.5) {
        b.cylinder("case", [0.0; 3], r, z * 0.5, body);
        b.cylinder("sleeve", [0.0, 0.0, z * 0.49], r * 0.85, z * 0.22, GOLD);
        let colour = b.choose(&[RED_SKIN, PETAL_PINK, PURPLE_SKIN, TERRACOTTA]);
        let ring = |z: f32, k: f32| level_oval([0.0, 0.0, z], (r * 0.7 * k, r * 0.7 * k));
        let slanted: Vec<P> =
            ring(z, 0.95).into_iter().map(|p| [p[0], p[1], z - (p[0] / r * 0.5 + 0.35).max(0.0) * z * 0.12]).collect();
        return loft_columns(b, "lipstick", &[ring(z * 0.7, 1.0), ring(z * 0.86, 1.0), slanted], colour);
    }
    turn(b, "case", [0.0; 3], (r, z * 0.56), &[(0.95, 0.0), (1.0, 0.03), (1.0, 1.0)], body);
    flat_ring(b, "band", (z * 0.55, z * 0.58), (r * 0.5, r * 0.94), GOLD);
    turn(b, "cap", [0.0, 0.0, z * 0.575], (r, z * 0.425), &[(0.98, 0.0), (0.98, 0.9), (0.85, 1.0)], cap);
}

/// A small box with a lid: dental floss.
pub(super) fn dental_floss(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let body = b.choose(&BRIGHT);
    let g = GROWTH.min(x * 0.05);
    b.prism("box", Axis::X, [-hx, 0.0, z * 0.4], &rounded_by_share((hy, z * 0.4), 0.6), x - g, WHITE_PLASTIC);
    b.rounded_block("lid", [-hx * 0.9, -hy * 0.8, z * 0.75], [hx * 0.8, hy * 0.8, z], x * 0.15, body);
    panel(b, hx - g, (0.0, hy * 0.6), (z * 0.15, z * 0.65), (body, WHITE_PAPER));
}

/// Clippers and tweezers: two joined strips of steel.
pub(super) fn nippers(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let mat = b.choose(&[STEEL, CHROME, GOLD]);
    if b.class == "tweezers" {
        let t = z * 0.08;
        for up in [-1.0, 1.0] {
            let at = |k: f32, open: f32, w: f32| ([0.0, -hy + y * k, z / 2.0 + up * (z / 2.0 - t) * open], hx * w, t);
            sweep(
                b,
                "arm",
                &[
                    at(if up > 0.0 { 0.004 } else { 0.0 }, 0.15, 0.9),
                    at(0.15, 0.5, 1.0),
                    at(0.6, 1.0, 0.8),
                    at(0.9, 0.7, 0.4),
                    at(1.0, 0.5, 0.3),
                ],
                [1.0, 0.0, 0.0],
                mat,
            );
        }
        return b.block("root", [-hx * 0.9, -hy * 0.97, z * 0.3], [hx * 0.9, -hy * 0.85, z * 0.7], mat);
    }
    let t = z * 0.16;
    b.rounded_block("lever", [-hx, -hy * 0.985, 0.0], [hx, hy * 0.985, z * 0.05 + t], t * 0.3, mat);
    b.rounded_block("lever", [-hx, -hy * 0.98, z * 0.35], [hx, hy * 0.985, z * 0.35 + t], t * 0.3, mat);
    let slant = [(-hy * 0.9, z * 0.95), (-hy * 0.9, z), (hy * 0.7, z * 0.55), (hy * 0.7, z * 0.48)];
    b.prism("handle", Axis::X, [-hx * 0.9, 0.0, 0.0], &slant, x * 0.9, mat);
    b.cylinder("pin", [0.0, hy * 0.6, 0.0], hx * 0.3, z * 0.75, mat);
    b.block("jaw", [-hx * 0.95, hy * 0.92, z * 0.05], [hx * 0.95, hy, z * 0.46], mat);
}

/// A pouch with a zip.
pub(super) fn makeup_bag(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let mat = b.choose(&[ROSE_FABRIC, NAVY_FABRIC, BLACK_LEATHER, b.style.accent, TAN_LEATHER, GREEN_FABRIC]);
    let t = (x * 0.03).min(0.003);
    let h = z * 0.72;
    tub(
        b,
        "pouch",
        &[
            (0.0, hx * 0.85, hy * 0.9),
            (z * 0.08, hx, hy * 0.98),
            (z * 0.5, hx * 0.9, hy * 0.97),
            (h, hx * 0.6, hy * 0.95),
        ],
        0.5,
        t,
        mat,
    );
    b.inside("inside", [0.0, 0.0, t], (hx * 0.4, hy * 0.7), h * 0.9);
    b.hinge([-hx * 0.6, 0.0, h], [0.0, -1.0, 0.0], 1.4, |b| {
        let at = |z: f32, k: f32, ky: f32| rounded_ring(z, (hx * k, hy * ky), 0.5);
        loft_columns(b, "flap", &[at(h + 0.0005, 0.6, 0.95), at(z * 0.9, 0.3, 0.92), at(z * 0.97, 0.1, 0.88)], mat);
        b.block("zip", [-hx * 0.06, -hy * 0.85, z * 0.95], [hx * 0.06, hy * 0.85, z], GOLD);
        b.block("pull", [-hx * 0.03, hy * 0.83, z * 0.8], [hx * 0.03, hy * 0.98, z * 0.985], GOLD);
    });
}

/// A bathroom scale: a plate with a display, on feet.
pub(super) fn bathroom_scale(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let plate = b.choose(&[GLASS, BLACK_GLASS, WHITE_PLASTIC, STEEL, BAMBOO]);
    let low = z * 0.45;
    for (sx, sy) in CORNERS {
        b.cylinder("foot", [hx * 0.72 * sx, hy * 0.72 * sy, 0.0], hx * 0.12, low * 1.1, GREY_PLASTIC);
    }
    b.prism(
        "plate",
        Axis::Z,
        [0.0, 0.0, low],
        &rounded_by_share((hx, hy), 0.2),
        z - low - 0.001_f32.min(z * 0.1),
        plate,
    );
    b.block("display", [-hx * 0.8, -hy * 0.3, z * 0.85], [-hx * 0.5, hy * 0.3, z], SCREEN);
    b.top("top", [hx * 0.15, 0.0, z - 0.001_f32.min(z * 0.1)], (hx * 0.6, hy * 0.85));
}

/// A mesh bath sponge with a loop.
pub(super) fn loofah(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let mat = b.choose(&[TOWEL_ROSE, TOWEL_BLUE, TOWEL_GREEN, HAY, PURPLE_FABRIC]);
    let r = [x * 0.36, y * 0.36, z * 0.36];
    for i in 0..7 {
        let k = (i as f32 + 0.5) / 7.0 * 2.0 - 1.0;
        let (s, c) = (2.4 * i as f32).sine_cosine();
        let out = (1.0 - k * k).sqrt();
        // No two have equal sizes, so that they share no plane.
        let r = r.map(|r| r * (1.0 - 0.02 * i as f32));
        lump(b, "net", [x * 0.14 * out * c, y * 0.14 * out * s, z / 2.0 + z * 0.14 * k], r, 0.14, mat);
    }
}

/// An upright fever thermometer with a display.
pub(super) fn thermometer(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let body = b.choose(&[WHITE_PLASTIC, BLUE_PLASTIC, GREEN_PLASTIC]);
    let at = |z: f32, kx: f32, ky: f32| rounded_ring(z, (hx * 0.85 * kx, hy * ky), 0.6);
    loft_columns(
        b,
        "body",
        &[
            at(0.0, 0.8, 0.8),
            at(z * 0.03, 1.0, 1.0),
            at(z * 0.55, 1.0, 1.0),
            at(z * 0.75, 0.45, 0.4),
            at(z * 0.9, 0.35, 0.3),
        ],
        body,
    );
    turn(b, "tip", [0.0, 0.0, z * 0.89], (hx.min(hy) * 0.3, z * 0.11), &[(1.0, 0.0), (1.0, 0.7), (0.4, 1.0)], STEEL);
    b.block("display", [hx * 0.6, -hy * 0.6, z * 0.25], [hx * 0.97, hy * 0.6, z * 0.45], SCREEN);
    b.block("button", [hx * 0.6, -hy * 0.4, z * 0.08], [hx, hy * 0.4, z * 0.15], GREY_PLASTIC);
}

/// A first-aid box or bag with a cross; its lid is hinged at the back.
pub(super) fn first_aid_kit(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let (body, cross) =
        b.choose(&[(RED_PLASTIC, WHITE_PLASTIC), (WHITE_METAL, RED_PLASTIC), (GREEN_PLASTIC, WHITE_PLASTIC)]);
    let t = (x * 0.05).min(0.004);
    let (h, face) = (z * 0.88, hx * 0.97);
    // The box stands on its edge; its door is the front half.
    let split = 0.0_f32;
    b.block("back", [-hx, -hy, 0.0], [-hx + t, hy, h], body);
    b.block("wall", [-hx + t, -hy, 0.0], [split, -hy + t, h], body);
    b.block("wall", [-hx + t, hy - t, 0.0], [split, hy, h], body);
    b.block("floor", [-hx + t, -hy + t, 0.0], [split, hy - t, t], body);
    b.block("roof", [-hx + t, -hy + t, h - t], [split, hy - t, h], body);
    b.inside(
        "inside",
        [(-hx + t + split) / 2.0, 0.0, t],
        ((split + hx - t) / 2.0 * 0.9, hy * 0.9 - t),
        (h - 2.0 * t - 0.002).max(0.0),
    );
    b.hinge([split, -hy, 0.0], [0.0, 0.0, -1.0], 1.9, |b| {
        b.rounded_block("door", [split + 0.001_f32.min(x * 0.01), -hy, 0.0], [face, hy, h], t, body);
        let (long, wide) = (z * 0.26, z * 0.09);
        b.block("cross", [face - t, -long, h / 2.0 - wide], [hx, long, h / 2.0 + wide], cross);
        b.block("cross", [face - t, -wide, h / 2.0 - long], [hx - (x * 0.01).min(0.0005), wide, h / 2.0 + long], cross);
        b.block("latch", [face * 0.6, hy * 0.9, h * 0.4], [hx * 0.98, hy * 0.97, h * 0.6], BLACK_PLASTIC);
    });
    let w = (z - h) * 0.2;
    let grip = arch([-hx * 0.5, 0.0, h - w], [0.0, hy * 0.35, 0.0], [0.0, 0.0, z - h]);
    planar_tube(b, "grip", &grip, w, [1.0, 0.0, 0.0], BLACK_PLASTIC);
}

/// A toilet brush in its pot with the handle upright.
pub(super) fn toilet_brush(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let r = x.min(y) / 2.0;
    let mat = b.choose(&[WHITE_PLASTIC, STEEL, PORCELAIN, BLACK_METAL]);
    let h = z * b.vary(0.3, 0.45);
    let outside: Vec<_> =
        [(0.95, 0.0), (1.0, 0.03), (0.9, 0.8), (0.85, 1.0)].iter().map(|p| (p.0 * r, p.1 * h)).collect();
    b.lathe("pot", [0.0; 3], &vessel_profile(&outside, r * 0.06), mat);
    turn(
        b,
        "bristles",
        [0.0, 0.0, r * 0.05],
        (r * 0.6, h * 0.85),
        &[(0.6, 0.0), (1.0, 0.25), (1.0, 0.8), (0.4, 1.0)],
        WHITE_PLASTIC,
    );
    b.cylinder("rod", [0.0, 0.0, h * 0.8], r * 0.09, z * 0.97 - h * 0.8, STEEL);
    turn(b, "lid", [0.0, 0.0, h], (r * 0.83, h * 0.06), &[(1.0, 0.0), (0.9, 0.6), (0.2, 1.0)], mat);
    turn(
        b,
        "grip",
        [0.0, 0.0, z * 0.78],
        (r * 0.2, z * 0.22),
        &[(0.6, 0.0), (0.9, 0.1), (1.0, 0.7), (0.9, 0.95), (0.4, 1.0)],
        mat,
    );
}

/// A plunger: a rubber cup on a stick.
pub(super) fn plunger(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let r = x.min(y) / 2.0;
    let (cup, stick) = (b.choose(&[RED_RUBBER, RUBBER]), b.choose(&[BEECH, PINE, WHITE_PLASTIC]));
    let h = (z * 0.24).min(r * 1.3);
    let outside: Vec<_> =
        [(1.0, 0.0), (0.95, 0.3), (0.7, 0.65), (0.3, 0.8), (0.24, 1.0)].iter().map(|p| (p.0 * r, p.1 * h)).collect();
    b.lathe("cup", [0.0; 3], &outside, cup);
    turn(
        b,
        "stick",
        [0.0, 0.0, h * 0.8],
        (r * 0.16, z - h * 0.8),
        &[(1.0, 0.0), (0.95, 0.9), (1.0, 0.95), (0.7, 1.0)],
        stick,
    );
}
