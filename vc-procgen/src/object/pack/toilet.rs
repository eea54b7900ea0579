//! Toiletries that are things of their own: brushes, soap, razors, paper, cosmetics.

use vc_graph::portable::Portable;

use super::super::build::{Axis, Build, P};
use super::super::kitchenware::form::{
    arch, dims, hoop, level, loft, lump, oval, rounded, shell, sweep, tub, tube, turn,
};
use super::label::{GROWTH, panel, wrap};
use super::look::look;
use crate::material::*;

const BRIGHT: [Mat; 7] =
    [WHITE_PLASTIC, BLUE_PLASTIC, GREEN_PLASTIC, PINK_PLASTIC, PURPLE_PLASTIC, ORANGE_PLASTIC, RED_PLASTIC];

/// Bars of soap, with a letter pressed in; `soap` is now and then a bottle.
pub(super) fn soap(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    if z > 0.07 {
        return super::flat::oval_bottle(b);
    }
    let mat = b.one(&[SOAP, PETAL_PINK, WAX, LIGHT_LEAF, PETAL_WHITE, PETAL_BLUE]);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let round = b.one(&[1.0, 0.5, 0.3]);
    let at = |z: f32, k: f32| level(z, (hx * k, hy * k), round);
    loft(b, "soap", &[at(0.0, 0.82), at(z * 0.2, 0.96), at(z * 0.5, 1.0), at(z * 0.78, 0.95), at(z * 0.94, 0.8)], mat);
    b.prism("stamp", Axis::Z, [0.0, 0.0, z * 0.9], &rounded((hx * 0.4, hy * 0.5), 1.0), z * 0.1, mat);
}

/// A dish with ribs for soap.
pub(super) fn soap_dish(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let mat = b.one(&[PORCELAIN, b.style.crockery, BAMBOO, WHITE_PLASTIC, STEEL]);
    let t = z * 0.12;
    tub(b, "dish", &[(0.0, hx * 0.75, hy * 0.8), (z * 0.6, hx * 0.95, hy * 0.96), (z, hx, hy)], 0.8, t, mat);
    for i in 0..5 {
        let at = hy * 0.6 * (i as f32 / 2.0 - 1.0);
        b.block("rib", [-hx * 0.5, at - hy * 0.04, t * 0.5], [hx * 0.5, at + hy * 0.04, t * 2.0], mat);
    }
    b.top("top", [0.0, 0.0, t * 2.0], (hx * 0.5, hy * 0.55));
}

/// Toothbrushes, standing: a handle, a neck, bristles to the front.
pub(super) fn toothbrush(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let electric = b.class == "electric_toothbrush";
    let (body, tip) = (b.one(&BRIGHT), b.one(&[WHITE_PLASTIC, BLUE_PLASTIC, GREEN_PLASTIC]));
    let (hx, hy) = (x / 2.0, y / 2.0);
    let head = z * if electric { 0.95 } else { 0.88 };
    if electric {
        let skin = b.one(&[WHITE_PLASTIC, BLACK_PLASTIC, PINK_PLASTIC, BLUE_PLASTIC]);
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
        b.soft("button", [hx * 0.6, -hy * 0.25, z * 0.4], [hx * 0.99, hy * 0.25, z * 0.46], hx * 0.1, GREY_PLASTIC);
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

/// A beaker with a lid of holes for brushes.
pub(super) fn toothbrush_holder(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let mat = b.one(&[PORCELAIN, b.style.crockery, STEEL, BAMBOO, FROSTED_GLASS]);
    let t = (hx * 0.08).min(0.004);
    let round = b.one(&[1.0, 0.4]);
    tub(b, "beaker", &[(0.0, hx * 0.9, hy * 0.9), (z * 0.05, hx * 0.95, hy * 0.95), (z, hx, hy)], round, t, mat);
    b.inside("inside", [0.0, 0.0, t], (hx * 0.55, hy * 0.55), z * 0.9);
}

/// Razors: a head across the top of a handle, standing.
pub(super) fn razor(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let mat = b.one(&[STEEL, BLUE_PLASTIC, PINK_PLASTIC, BLACK_PLASTIC, ORANGE_PLASTIC]);
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
    b.soft("head", [-hx * 0.2, -hy, z * 0.9], [hx * 0.9, hy, z], z * 0.02, BLACK_PLASTIC);
    let blades = b.rng.count(2, 5);
    for i in 0..blades {
        let low = z * (0.918 + 0.07 / blades as f32 * i as f32);
        b.block("blade", [hx * 0.7, -hy * 0.9, low], [hx, hy * 0.9, low + z * 0.008], STEEL);
    }
}

/// A razor for one blade between two plates, on a straight handle with rings.
fn safety_razor(b: &mut Build<'_>, mat: Mat) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let r = (hy * 0.24).min(hx * 0.5);
    let neck = z * b.vary(0.78, 0.86);
    let handle = [(0.8, 0.0), (1.0, 0.03), (1.0, 0.6), (0.55, 0.75), (0.6, 1.0)];
    turn(b, "handle", [0.0; 3], (r, neck), &handle, mat);
    let rings = b.rng.count(3, 6);
    for i in 0..rings {
        let low = neck * (0.1 + 0.45 * i as f32 / rings as f32);
        hoop(b, "ring", (low, low + z * 0.02), (r * 0.9, r * 1.15), CHROME);
    }
    turn(b, "neck", [0.0, 0.0, neck * 0.98], (r * 0.5, z * 0.95 - neck * 0.98), &[(1.0, 0.0), (1.0, 1.0)], CHROME);
    b.soft("plate", [-hx, -hy * 0.96, z * 0.93], [hx, hy * 0.96, z * 0.955], z * 0.008, CHROME);
    b.block("blade", [-hx * 0.97, -hy, z * 0.954], [hx * 0.97, hy, z * 0.962], STEEL);
    b.soft("plate", [-hx * 0.9, -hy * 0.96, z * 0.961], [hx * 0.9, hy * 0.96, z], z * 0.03, CHROME);
}

/// A shaver with round or straight foils, standing.
pub(super) fn electric_shaver(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let body = b.one(&[BLACK_PLASTIC, GREY_PLASTIC, NAVY, WHITE_PLASTIC]);
    let at = |z: f32, kx: f32, ky: f32| level(z, (hx * kx, hy * ky), 0.9);
    loft(
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
    loft(
        b,
        "head",
        &[at(z * 0.77, 0.75, 0.85), at(z * 0.84, 1.0, 1.0), at(z * 0.9, 0.98, 1.0), at(z * 0.93, 0.9, 0.9)],
        STEEL,
    );
    for (dx, dy) in [(0.4, 0.0), (-0.35, 0.45), (-0.35, -0.45)] {
        b.cylinder("foil", [hx * dx, hy * dy, z * 0.92], hx.min(hy) * 0.38, z * 0.05, CHROME);
        b.cylinder("foil", [hx * dx, hy * dy, z * 0.95], hx.min(hy) * 0.2, z * 0.05, BLACK_METAL);
    }
    b.soft("button", [hx * 0.8, -hy * 0.2, z * 0.36], [hx * 0.98, hy * 0.2, z * 0.48], hx * 0.06, LED);
}

/// Flacons: a block of glass, a neck and a cap; aftershave as well.
pub(super) fn flacon(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let look = look(b);
    let (hx, hy) = (x / 2.0 - 0.001_f32.min(x * 0.03), y / 2.0);
    let nail = matches!(b.class, "nail_polish" | "foundation");
    let h = z * if nail { 0.5 } else { b.vary(0.6, 0.72) };
    let neck = hx.min(hy) * 0.4;
    let ring = |z: f32, r: f32| level(z, (r, r), 1.0);
    let round = b.one(&[0.1, 0.4, 1.0]);
    let at = |z: f32, k: f32| level(z, (hx * k, hy * k), round);
    let shoulder = b.one(&[0.95, 0.7, 1.0]);
    loft(
        b,
        "flacon",
        &[at(0.0, 0.93), at(h * 0.05, 1.0), at(h * 0.7, 1.0), at(h * 0.95, shoulder), at(h, shoulder * 0.85)],
        look.body,
    );
    loft(b, "neck", &[ring(h * 0.98, neck * 0.8), ring(h + (z - h) * 0.2, neck * 0.8)], GOLD);
    let (low, wide) = (h + (z - h) * 0.15, neck * if nail { 1.1 } else { 1.5 });
    let cap = match b.rng.below(3) {
        0 => [(low, wide), (z * 0.98, wide), (z, wide * 0.9)],
        1 => [(low, wide * 0.8), (f32::midpoint(low, z), wide), (z, wide * 0.6)],
        _ => [(low, wide), (f32::midpoint(low, z), wide * 0.85), (z, wide * 0.75)],
    };
    let rings: Vec<_> = cap.iter().map(|c| ring(c.0, c.1.min(hx))).collect();
    loft(b, "cap", &rings, look.cap);
    if !nail {
        panel(b, hx, (0.0, hy * 0.45), (h * 0.25, h * 0.6), (look.paper, GOLD));
    }
}

/// Lipstick and mascara: a cylinder of two parts; a lipstick is open now and then.
pub(super) fn stick(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let r = x.min(y) / 2.0;
    let (body, cap) =
        (b.one(&[BLACK_PLASTIC, GOLD, WHITE_PLASTIC, RED_METAL]), b.one(&[GOLD, BLACK_PLASTIC, CHROME, PINK_PLASTIC]));
    if b.class == "lipstick" && b.rng.chance(0.5) {
        b.cylinder("case", [0.0; 3], r, z * 0.5, body);
        b.cylinder("sleeve", [0.0, 0.0, z * 0.49], r * 0.85, z * 0.22, GOLD);
        let colour = b.one(&[RED_SKIN, PETAL_PINK, PURPLE_SKIN, TERRACOTTA]);
        let ring = |z: f32, k: f32| oval([0.0, 0.0, z], (r * 0.7 * k, r * 0.7 * k));
        let slanted: Vec<P> =
            ring(z, 0.95).into_iter().map(|p| [p[0], p[1], z - (p[0] / r * 0.5 + 0.35).max(0.0) * z * 0.12]).collect();
        return loft(b, "lipstick", &[ring(z * 0.7, 1.0), ring(z * 0.86, 1.0), slanted], colour);
    }
    turn(b, "case", [0.0; 3], (r, z * 0.56), &[(0.95, 0.0), (1.0, 0.03), (1.0, 1.0)], body);
    hoop(b, "band", (z * 0.55, z * 0.58), (r * 0.5, r * 0.94), GOLD);
    turn(b, "cap", [0.0, 0.0, z * 0.575], (r, z * 0.425), &[(0.98, 0.0), (0.98, 0.9), (0.85, 1.0)], cap);
}

/// A small box with a lid: dental floss.
pub(super) fn dental_floss(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let body = b.one(&BRIGHT);
    let g = GROWTH.min(x * 0.05);
    b.prism("box", Axis::X, [-hx, 0.0, z * 0.4], &rounded((hy, z * 0.4), 0.6), x - g, WHITE_PLASTIC);
    b.soft("lid", [-hx * 0.9, -hy * 0.8, z * 0.75], [hx * 0.8, hy * 0.8, z], x * 0.15, body);
    panel(b, hx - g, (0.0, hy * 0.6), (z * 0.15, z * 0.65), (body, WHITE_PAPER));
}

/// A comb lying flat: a back, teeth, coarse and fine.
pub(super) fn comb(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let mat = b.one(&[BLACK_PLASTIC, BROWN_PLASTIC, BLUE_PLASTIC, BAMBOO]);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let handled = b.rng.chance(0.4);
    let start = if handled { -hy * 0.2 } else { -hy };
    let count = 26;
    let pitch = (hy - start) / count as f32;
    let mut outline = vec![(-hx, start), (-hx * 0.9, hy), (hx, hy)];
    for i in 0..count {
        let at = hy - pitch * (i as f32 + 0.35);
        outline.extend([
            (hx, at),
            (-hx * 0.25, at - pitch * 0.05),
            (-hx * 0.25, at - pitch * 0.5),
            (hx, at - pitch * 0.55),
        ]);
    }
    outline.push((hx, start));
    b.prism("comb", Axis::Z, [0.0; 3], &outline, z, mat);
    if handled {
        let grip = [
            (-hx * 0.9, start + hy * 0.02),
            (hx * 0.3, start + hy * 0.02),
            (0.0, -hy * 0.95),
            (-hx * 0.4, -hy),
            (-hx * 0.8, -hy * 0.95),
        ];
        b.prism("grip", Axis::Z, [0.0, 0.0, z * 0.1], &grip, z * 0.8, mat);
    }
}

/// Brushes for hair and body, lying on their back, and the scrubbing kind on their
/// bristles.
pub(super) fn brush(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let scrub = b.class == "scrubbing_brush";
    let (back, bristle) = if scrub {
        (b.one(&[BEECH, WHITE_PLASTIC, BLUE_PLASTIC, GREEN_PLASTIC]), b.one(&[HAY, WHITE_PLASTIC, BLACK_PLASTIC]))
    } else {
        (b.one(&[BEECH, BLACK_PLASTIC, PINK_PLASTIC, WALNUT, BAMBOO]), b.one(&[BLACK_PLASTIC, HAY]))
    };
    let (hx, hy) = (x / 2.0, y / 2.0);
    let handled = y > x * 2.6;
    let head = if handled { hy * 0.1 } else { -hy };
    let (mid, half) = (f32::midpoint(head, hy), (hy - head) / 2.0);
    let body = z * 0.42;
    let shift = |ring: Vec<P>| -> Vec<P> { ring.into_iter().map(|p| [p[0], p[1] + mid, p[2]]).collect() };
    let lift = if scrub { z - body } else { 0.0 };
    let at = |z: f32, k: f32| shift(level(z + lift, (hx * k, half * k), 0.9));
    loft(b, "back", &[at(0.0, 0.9), at(body * 0.4, 1.0), at(body * 0.8, 0.98), at(body, 0.88)], back);
    if !scrub {
        let pad = shift(level(body * 0.95, (hx * 0.8, half * 0.85), 1.0));
        let top = shift(level(body * 1.2, (hx * 0.65, half * 0.72), 1.0));
        loft(b, "pad", &[pad, top], RED_RUBBER);
    }
    let (rows, columns) = (4, 7);
    let (low, high) = if scrub { (0.0, lift + body * 0.1) } else { (body, z) };
    for (i, j) in (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j))) {
        let (u, v) = (i as f32 / (rows - 1) as f32 * 2.0 - 1.0, j as f32 / (columns - 1) as f32 * 2.0 - 1.0);
        if u * u * 0.6 + v * v * 0.6 > 1.0 {
            continue;
        }
        let (cx, cy) = (hx * 0.62 * u, mid + half * 0.75 * v);
        let w = if scrub { hx * 0.13 } else { hx * 0.035 };
        b.block("bristle", [cx - w, cy - w, low], [cx + w, cy + w, high], bristle);
    }
    if handled {
        let (r, level_) = ((body * 0.5).min(hx * 0.4), lift + body * 0.5);
        let path = [
            ([0.0, -hy, level_], r * 0.6, r * 0.6),
            ([0.0, -hy * 0.95, level_], r * 1.1, r * 0.9),
            ([0.0, -hy * 0.5, level_], r * 1.3, r * 0.98),
            ([0.0, head - hy * 0.08, level_], r * 0.8, r * 0.8),
            ([0.0, head + half * 0.2, level_], r, r * 0.8),
        ];
        sweep(b, "grip", &path, [1.0, 0.0, 0.0], back);
    }
}

/// A dryer for hair, lying on its side edge: barrel, nozzle and grip.
pub(super) fn hair_dryer(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let body = b.one(&[BLACK_PLASTIC, WHITE_PLASTIC, PINK_PLASTIC, PURPLE_PLASTIC, RED_PLASTIC]);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let r = hx.min(z * 0.24);
    let axis = z - r;
    let barrel: Vec<_> = [(0.65, 0.008), (0.95, 0.1), (1.0, 0.3), (0.9, 0.6), (0.7, 0.75), (0.68, 0.8)]
        .iter()
        .map(|p| (p.0 * r, p.1 * y))
        .collect();
    b.lathe_along("barrel", [0.0, -hy, axis], [0.0, hy, axis], &barrel, body);
    let nozzle: Vec<_> = [(0.6, 0.78), (0.75, 0.8), (0.66, 1.0)].iter().map(|p| (p.0 * r, p.1 * y)).collect();
    b.lathe_along("nozzle", [0.0, -hy, axis], [0.0, hy, axis], &nozzle, BLACK_PLASTIC);
    b.rod("grille", [0.0, -hy, axis], [0.0, -hy + y * 0.015, axis], r * 0.5, GREY_PLASTIC);
    let w = r * 0.42;
    let path = [
        ([0.0, -hy * 0.25, axis - r * 0.5], w, w * 1.2),
        ([0.0, -hy * 0.3, z * 0.45], w * 0.9, w * 1.1),
        ([0.0, -hy * 0.38, z * 0.12], w, w * 1.2),
        ([0.0, -hy * 0.4, 0.0], w * 0.8, w),
    ];
    sweep(b, "grip", &path, [1.0, 0.0, 0.0], body);
    b.block(
        "switch",
        [-w * 0.3, -hy * 0.3 + w * 0.9, z * 0.36],
        [w * 0.3, -hy * 0.3 + w * 1.3, z * 0.46],
        GREY_PLASTIC,
    );
}

/// Two long jaws with plates, lying.
pub(super) fn hair_straightener(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let body = b.one(&[BLACK_PLASTIC, WHITE_PLASTIC, PINK_PLASTIC, PURPLE_PLASTIC]);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let t = z * 0.36;
    for up in [false, true] {
        let arm = |k: f32, open: f32, w: f32, thick: f32| {
            let level_ = if up { t / 2.0 + (z - t) * open } else { t / 2.0 };
            ([0.0, -hy + y * k, level_], hx * w, t / 2.0 * thick)
        };
        let path = [
            arm(0.0, 0.45, 0.6, 0.6),
            arm(0.05, 0.5, 0.9, 1.0),
            arm(0.45, 0.75, 1.0, 1.0),
            arm(0.55, 0.8, 1.0, 1.0),
            arm(0.97, 1.0, 0.95, 0.9),
            arm(1.0, 1.0, 0.6, 0.6),
        ];
        sweep(b, "arm", &path, [1.0, 0.0, 0.0], body);
        let (z0, z1) = if up { (z - t * 1.1, z - t * 0.6) } else { (t * 0.6, t * 1.1) };
        b.block("plate", [-hx * 0.8, hy * 0.2, z0], [hx * 0.8, hy * 0.88, z1], CHROME);
    }
    b.rod("hinge", [-hx * 0.9, -hy * 0.9, z * 0.42], [hx * 0.9, -hy * 0.9, z * 0.42], t * 0.5, GREY_PLASTIC);
}

/// Clippers and tweezers: two strips of steel that meet.
pub(super) fn nippers(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let mat = b.one(&[STEEL, CHROME, GOLD]);
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
    b.soft("lever", [-hx, -hy * 0.985, 0.0], [hx, hy * 0.985, z * 0.05 + t], t * 0.3, mat);
    b.soft("lever", [-hx, -hy * 0.98, z * 0.35], [hx, hy * 0.985, z * 0.35 + t], t * 0.3, mat);
    let slant = [(-hy * 0.9, z * 0.95), (-hy * 0.9, z), (hy * 0.7, z * 0.55), (hy * 0.7, z * 0.48)];
    b.prism("handle", Axis::X, [-hx * 0.9, 0.0, 0.0], &slant, x * 0.9, mat);
    b.cylinder("pin", [0.0, hy * 0.6, 0.0], hx * 0.3, z * 0.75, mat);
    b.block("jaw", [-hx * 0.95, hy * 0.92, z * 0.05], [hx * 0.95, hy, z * 0.46], mat);
}

/// A pouch with a zip.
pub(super) fn makeup_bag(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let mat = b.one(&[ROSE_FABRIC, NAVY_FABRIC, BLACK_LEATHER, b.style.accent, TAN_LEATHER, GREEN_FABRIC]);
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
        let at = |z: f32, k: f32, ky: f32| level(z, (hx * k, hy * ky), 0.5);
        loft(b, "flap", &[at(h + 0.0005, 0.6, 0.95), at(z * 0.9, 0.3, 0.92), at(z * 0.97, 0.1, 0.88)], mat);
        b.block("zip", [-hx * 0.06, -hy * 0.85, z * 0.95], [hx * 0.06, hy * 0.85, z], GOLD);
        b.block("pull", [-hx * 0.03, hy * 0.83, z * 0.8], [hx * 0.03, hy * 0.98, z * 0.985], GOLD);
    });
}

/// Rolls of paper: for the toilet and the kitchen; now and then two lie on each other.
pub(super) fn roll(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let r = x.min(y) / 2.0;
    let kitchen = b.class == "paper_towel";
    let tube_r = if kitchen { r * 0.34 } else { r * 0.38 };
    let paper = b.one(&[WHITE_PAPER, WHITE_PAPER, CREAM_PAPER]);
    let body = r * 0.985;
    let bulge = [
        (body * 0.985, 0.0),
        (body, z * 0.03),
        (body, z * 0.97),
        (body * 0.985, z),
        (tube_r, z),
        (tube_r, 0.0),
        (body * 0.985, 0.0),
    ];
    b.lathe("paper", [0.0; 3], &bulge, paper);
    hoop(b, "core", (z * 0.004, z * 0.996), (tube_r * 0.92, tube_r * 1.01), CARDBOARD);
    // The end of the sheet.
    let flap: Vec<_> = (0..=6)
        .map(|k| {
            let (s, c) = (0.5 + 0.12 * k as f32).sine_cosine();
            (r * c, r * s)
        })
        .chain((0..=6).rev().map(|k| {
            let (s, c) = (0.5 + 0.12 * k as f32).sine_cosine();
            (body * 0.98 * c, body * 0.98 * s)
        }))
        .collect();
    b.prism("end", Axis::Z, [0.0, 0.0, z * 0.01], &flap, z * 0.98, paper);
    if kitchen && b.rng.chance(0.6) {
        let ink = b.one(&[BLUE_CARD, GREEN_CARD, RED_CARD]);
        for i in 0..3 {
            let low = z * (0.2 + 0.28 * i as f32);
            hoop(b, "print", (low, low + z * 0.02), (body * 0.97, body + (r - body) * 0.6), ink);
        }
    }
}

/// A stack of cotton pads in a sleeve.
pub(super) fn cotton_pads(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let r = x.min(y) / 2.0;
    let sleeve = b.one(&[BLUE_PLASTIC, PINK_PLASTIC, GREEN_PLASTIC]);
    let count = ((z / 0.012) as usize).clamp(5, 8);
    let mut profile = vec![];
    for i in 0..count {
        let (low, t) = (z * 0.94 * i as f32 / count as f32, z * 0.94 / count as f32);
        profile.extend([
            (r * 0.86, low),
            (r * 0.92, low + t * 0.3),
            (r * 0.92, low + t * 0.7),
            (r * 0.86, low + t * 0.95),
        ]);
    }
    b.lathe("pads", [0.0; 3], &profile, WHITE_COTTON);
    wrap(b, r - GROWTH.min(r * 0.1), (z * 0.12, z * 0.55), (sleeve, WHITE_PAPER));
    let grip = arch([0.0, 0.0, z * 0.9], [0.0, r * 0.5, 0.0], [0.0, 0.0, z * 0.09]);
    tube(b, "string", &grip, z * 0.006, [1.0, 0.0, 0.0], sleeve);
}

/// A box with tissues that stand out of its slot.
pub(super) fn tissue_box(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let look = look(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let h = z * 0.75;
    let skin = b.one(&[look.body, b.style.wood, WHITE_PAPER, look.ink]);
    let g = GROWTH.min(x * 0.01);
    b.soft("box", [-hx, -hy, 0.0], [hx - g, hy, h], 0.0015, skin);
    b.prism("slot", Axis::Z, [0.0, 0.0, h - z * 0.01], &rounded((hx * 0.35, hy * 0.55), 1.0), z * 0.03, BLACK_CARD);
    let fold = |s: f32| {
        [
            [s * hx * 0.05, -hy * 0.4, h * 0.97],
            [s * hx * 0.05, hy * 0.4, h * 0.97],
            [s * hx * 0.4, hy * 0.3, z * 0.98],
            [s * hx * 0.25, -hy * 0.35, z * 0.94],
            [s * hx * 0.15, hy * 0.05, z],
            [0.0, -hy * 0.3, h],
            [0.0, hy * 0.3, h],
        ]
    };
    b.hull("tissue", &fold(1.0), WHITE_PAPER);
    b.hull("tissue", &fold(-1.0), WHITE_PAPER);
    if skin == look.body {
        panel(b, hx - g, (0.0, hy * 0.8), (h * 0.2, h * 0.8), look.label());
    }
}

/// A soft pack of wipes with a lid on top.
pub(super) fn wet_wipes(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let look = look(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let at = |z: f32, kx: f32, ky: f32| level(z, (hx * kx, hy * ky), 0.35);
    loft(
        b,
        "pack",
        &[at(0.0, 0.9, 0.9), at(z * 0.15, 1.0, 0.96), at(z * 0.7, 1.0, 0.96), at(z * 0.86, 0.88, 0.9)],
        look.body,
    );
    for side in [-1.0_f32, 1.0] {
        let (y0, y1) = if side < 0.0 { (-hy, -hy * 0.9) } else { (hy * 0.9, hy) };
        b.block("seam", [-hx * 0.95, y0, z * 0.42], [hx * 0.95, y1, z * 0.48], look.body);
    }
    b.hinge([-hx * 0.5, 0.0, z * 0.88], [0.0, -1.0, 0.0], 1.9, |b| {
        b.soft("lid", [-hx * 0.5, -hy * 0.45, z * 0.845], [hx * 0.5, hy * 0.45, z], z * 0.05, look.cap);
    });
}

/// A diaper, folded and upright.
pub(super) fn diaper(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let at = |z: f32, kx: f32, ky: f32| level(z, (hx * kx, hy * ky), 0.7);
    loft(
        b,
        "diaper",
        &[
            at(0.0, 0.6, 0.55),
            at(z * 0.06, 0.95, 0.7),
            at(z * 0.35, 1.0, 0.75),
            at(z * 0.7, 0.9, 0.95),
            at(z * 0.95, 0.75, 1.0),
            at(z, 0.6, 0.98),
        ],
        WHITE_COTTON,
    );
    let ink = b.one(&[BLUE_FABRIC, ROSE_FABRIC, GREEN_FABRIC, MUSTARD_FABRIC]);
    for side in [-1.0, 1.0] {
        b.block(
            "tape",
            [hx * 0.5, side * hy * 0.7 - hy * 0.18, z * 0.8],
            [hx * 0.9, side * hy * 0.7 + hy * 0.18, z * 0.92],
            ink,
        );
    }
    b.block("band", [hx * 0.4, -hy * 0.5, z * 0.82], [hx * 0.86, hy * 0.5, z * 0.9], ink);
}

/// A bathroom scale: a plate with a display, on feet.
pub(super) fn bathroom_scale(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let plate = b.one(&[GLASS, BLACK_GLASS, WHITE_PLASTIC, STEEL, BAMBOO]);
    let low = z * 0.45;
    for (sx, sy) in [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)] {
        b.cylinder("foot", [hx * 0.72 * sx, hy * 0.72 * sy, 0.0], hx * 0.12, low * 1.1, GREY_PLASTIC);
    }
    b.prism("plate", Axis::Z, [0.0, 0.0, low], &rounded((hx, hy), 0.2), z - low - 0.001_f32.min(z * 0.1), plate);
    b.block("display", [-hx * 0.8, -hy * 0.3, z * 0.85], [-hx * 0.5, hy * 0.3, z], SCREEN);
    b.top("top", [hx * 0.15, 0.0, z - 0.001_f32.min(z * 0.1)], (hx * 0.6, hy * 0.85));
}

/// A ball of net to wash with, and a loop.
pub(super) fn loofah(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let mat = b.one(&[TOWEL_ROSE, TOWEL_BLUE, TOWEL_GREEN, HAY, PURPLE_FABRIC]);
    let r = [x * 0.36, y * 0.36, z * 0.36];
    for i in 0..7 {
        let k = (i as f32 + 0.5) / 7.0 * 2.0 - 1.0;
        let (s, c) = (2.4 * i as f32).sine_cosine();
        let out = (1.0 - k * k).sqrt();
        // No two of one size, so that they share no plane.
        let r = r.map(|r| r * (1.0 - 0.02 * i as f32));
        lump(b, "net", [x * 0.14 * out * c, y * 0.14 * out * s, z / 2.0 + z * 0.14 * k], r, 0.14, mat);
    }
}

/// A fever thermometer with a display, upright.
pub(super) fn thermometer(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let body = b.one(&[WHITE_PLASTIC, BLUE_PLASTIC, GREEN_PLASTIC]);
    let at = |z: f32, kx: f32, ky: f32| level(z, (hx * 0.85 * kx, hy * ky), 0.6);
    loft(
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

/// A box or bag with a cross, its lid hinged at the back.
pub(super) fn first_aid_kit(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let (body, cross) =
        b.one(&[(RED_PLASTIC, WHITE_PLASTIC), (WHITE_METAL, RED_PLASTIC), (GREEN_PLASTIC, WHITE_PLASTIC)]);
    let t = (x * 0.05).min(0.004);
    let (h, face) = (z * 0.88, hx * 0.97);
    // It stands on its edge; its door is the front half.
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
        b.soft("door", [split + 0.001_f32.min(x * 0.01), -hy, 0.0], [face, hy, h], t, body);
        let (long, wide) = (z * 0.26, z * 0.09);
        b.block("cross", [face - t, -long, h / 2.0 - wide], [hx, long, h / 2.0 + wide], cross);
        b.block("cross", [face - t, -wide, h / 2.0 - long], [hx - (x * 0.01).min(0.0005), wide, h / 2.0 + long], cross);
        b.block("latch", [face * 0.6, hy * 0.9, h * 0.4], [hx * 0.98, hy * 0.97, h * 0.6], BLACK_PLASTIC);
    });
    let w = (z - h) * 0.2;
    let grip = arch([-hx * 0.5, 0.0, h - w], [0.0, hy * 0.35, 0.0], [0.0, 0.0, z - h]);
    tube(b, "grip", &grip, w, [1.0, 0.0, 0.0], BLACK_PLASTIC);
}

/// A brush in its pot, the handle upright.
pub(super) fn toilet_brush(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let r = x.min(y) / 2.0;
    let mat = b.one(&[WHITE_PLASTIC, STEEL, PORCELAIN, BLACK_METAL]);
    let h = z * b.vary(0.3, 0.45);
    let outside: Vec<_> =
        [(0.95, 0.0), (1.0, 0.03), (0.9, 0.8), (0.85, 1.0)].iter().map(|p| (p.0 * r, p.1 * h)).collect();
    b.lathe("pot", [0.0; 3], &shell(&outside, r * 0.06), mat);
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

/// A rubber cup on a stick.
pub(super) fn plunger(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let r = x.min(y) / 2.0;
    let (cup, stick) = (b.one(&[RED_RUBBER, RUBBER]), b.one(&[BEECH, PINE, WHITE_PLASTIC]));
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
