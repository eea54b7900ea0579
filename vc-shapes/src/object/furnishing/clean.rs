//! Vacuum cleaners, irons, steamers, sewing machines.

use crate::material::*;
use crate::object::cooker::fitting::*;
use crate::solid::{Axis, Build, P, collar, fit, half_dims};

/// Bright plastics of cleaners.
fn case_mat(b: &mut Build<'_>) -> MaterialId {
    b.choose(&[RED_PLASTIC, BLUE_PLASTIC, BLACK_PLASTIC, GREEN_PLASTIC, PURPLE_PLASTIC, GREY_PLASTIC, YELLOW_PLASTIC])
}

/// A canister with wheels and a hose, or an upright with a handle.
pub(super) fn vacuum_cleaner(b: &mut Build<'_>) {
    let u = fit(b, [0.224, 0.192, 0.192]);
    let (x, y, h) = half_dims(b);
    let mat = case_mat(b);
    if h > 0.6 {
        return upright(b, u, mat);
    }
    let top = h * 0.72;
    b.rounded_block("body", [-x * 0.9, -y * 0.82, h * 0.12], [x * 0.8, y * 0.82, top], h * 0.2, mat);
    b.rounded_block("hood", [-x * 0.5, -y * 0.6, top * 0.8], [x * 0.7, y * 0.6, top * 1.08], h * 0.1, GREY_PLASTIC);
    let r = (h * 0.3).min(x * 0.6);
    for side in [-1.0_f32, 1.0] {
        let (a, c) = (side * y * 0.78, side * y);
        let cx = (r - x).max(h * 0.2 - x * 0.9);
        b.rod("wheel", [cx, a, r], [cx, c, r], r, BLACK_PLASTIC);
    }
    b.ball("castor", [x * 0.5, 0.0, h * 0.07], h * 0.07, BLACK_PLASTIC);
    b.rod("hub", [x * 0.5, 0.0, h * 0.07], [x * 0.5, 0.0, h * 0.2], h * 0.04, BLACK_PLASTIC);
    // The hose rises in front and runs back over the body to its grip.
    let t = 0.016 * u;
    let hose: [P; 6] = [
        [x * 0.7, 0.0, h * 0.5],
        [x - t * 1.45, 0.0, h * 0.6],
        [x * 0.8, y * 0.2, h - t * 1.5],
        [x * 0.3, y * 0.45, h - t * 1.5],
        [-x * 0.3, y * 0.3, h - t * 1.6],
        [-x * 0.5, 0.0, top],
    ];
    b.pipe("hose", &hose, t, BLACK_PLASTIC);
    b.pipe(
        "handle",
        &[
            [-x * 0.2, -y * 0.25, top],
            [-x * 0.1, -y * 0.25, top * 1.18],
            [x * 0.3, -y * 0.25, top * 1.18],
            [x * 0.4, -y * 0.25, top],
        ],
        t * 0.7,
        GREY_PLASTIC,
    );
    b.cylinder("button", [-x * 0.65, -y * 0.4, top - 0.004 * u], h * 0.06, h * 0.04, RED_PLASTIC);
}

/// An upright vacuum cleaner: a wide foot, a clear plastic bin, a handle.
fn upright(b: &mut Build<'_>, u: f32, mat: MaterialId) {
    let (x, y, h) = half_dims(b);
    let foot = h * 0.09;
    b.rounded_block("foot", [x * 0.1, -y, 0.0], [x, y, foot], foot * 0.4, mat);
    let wheel = (foot * 0.8).min(x * 0.45);
    b.rod("wheel", [-x * 0.5, -y * 0.5, wheel], [-x * 0.5, y * 0.5, wheel], wheel, BLACK_PLASTIC);
    let hold = y * 0.1;
    b.block("axle", [-x * 0.5, -hold, wheel * 0.6], [x * 0.2, hold, wheel * 1.3], mat);
    b.bar("neck", [x * 0.3, 0.0, foot * 0.8], [-x * 0.3, 0.0, h * 0.2], 0.03 * u, mat);
    let r = (y * 0.55).min(x * 0.5);
    b.cylinder("motor", [-x * 0.35, 0.0, h * 0.14], r, h * 0.12, mat);
    b.cylinder("bin", [-x * 0.35, 0.0, h * 0.255], r * 0.85, h * 0.24, CLEAR_PLASTIC);
    b.lathe(
        "cyclone",
        [-x * 0.35, 0.0, h * 0.26],
        &[(r * 0.2, 0.0), (r * 0.6, h * 0.18), (r * 0.3, h * 0.22)],
        GREY_PLASTIC,
    );
    b.cylinder("head", [-x * 0.35, 0.0, h * 0.49], r * 0.9, h * 0.06, mat);
    let back = -x + 0.025 * u;
    b.block("spine", [back, -0.03 * u, h * 0.15], [-x * 0.35 - r * 0.7, 0.03 * u, h * 0.55], mat);
    b.bar("pole", [back + 0.01 * u, 0.0, h * 0.5], [back + 0.01 * u, 0.0, h * 0.84], 0.016 * u, STEEL);
    let t = 0.015 * u;
    b.pipe(
        "handle",
        &[
            [back + 0.01 * u, 0.0, h * 0.84],
            [back - 0.002 * u, 0.0, h * 0.95],
            [-x * 0.5, 0.0, h - t],
            [-x * 0.25, 0.0, h * 0.93],
        ],
        t,
        mat,
    );
}

/// A low disc with a bumper, a turret and a light.
pub(super) fn robot_vacuum(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let r = x.min(y);
    let mat = b.choose(&[WHITE_PLASTIC, BLACK_PLASTIC, GREY_PLASTIC]);
    let top = h * 0.84;
    b.lathe(
        "body",
        [0.0, 0.0, h * 0.12],
        &[(r * 0.92, 0.0), (r * 0.98, h * 0.1), (r * 0.98, top - h * 0.2), (r * 0.93, top - h * 0.12)],
        mat,
    );
    collar(b, "bumper", ([0.0, 0.0, h * 0.25], [0.0, 0.0, h * 0.6]), (r * 0.9, r), BLACK_PLASTIC);
    b.cylinder("turret", [-r * 0.3, 0.0, top - 0.001], r * 0.26, h - top + 0.001, BLACK_PLASTIC);
    b.cylinder("cap", [-r * 0.3, 0.0, h - 0.002], r * 0.2, 0.002, mat);
    for i in 0..2 {
        let cy = r * 0.2 * (i as f32 * 2.0 - 1.0);
        b.cylinder("button", [r * 0.55, cy, top - 0.001], r * 0.08, h * 0.03, if i == 0 { LED } else { GREY_PLASTIC });
    }
    for side in [-1.0, 1.0] {
        let (cy, w) = (side * r * 0.6, h * 0.2);
        b.rod("wheel", [0.0, cy - r * 0.06, w], [0.0, cy + r * 0.06, w], w, RUBBER);
    }
    b.ball("castor", [r * 0.7, 0.0, h * 0.1], h * 0.1, BLACK_PLASTIC);
    for (c, s) in [(0.8, 0.0), (-0.4, 0.7), (-0.4, -0.7)] {
        b.rod(
            "bristle",
            [r * 0.62, -r * 0.62, h * 0.08],
            [r * (0.62 + 0.15 * c), -r * (0.62 - 0.15 * s), h * 0.06],
            h * 0.03,
            WHITE_PLASTIC,
        );
    }
    b.rod("brush", [r * 0.62, -r * 0.62, h * 0.05], [r * 0.62, -r * 0.62, h * 0.2], h * 0.08, BLACK_PLASTIC);
}

/// A mop on a pole, or a small tank with a hose.
pub(super) fn steam_cleaner(b: &mut Build<'_>) {
    let u = fit(b, [0.16, 0.192, 0.24]);
    let (x, y, h) = half_dims(b);
    let mat = case_mat(b);
    if h < 0.6 {
        let r = (h * 0.2).min(x * 0.48);
        b.rounded_block("body", [-x, -y * 0.85, r * 0.6], [x * 0.8, y * 0.85, h * 0.75], 0.05 * u, mat);
        for side in [-1.0_f32, 1.0] {
            let (a, c) = (side * y * 0.8, side * y);
            b.rod("wheel", [-x * 0.5, a, r], [-x * 0.5, c, r], r, BLACK_PLASTIC);
        }
        b.cylinder("cap", [-x * 0.4, 0.0, h * 0.74], 0.03 * u, h * 0.06, BLACK_PLASTIC);
        let t = 0.012 * u;
        b.pipe(
            "hose",
            &[
                [x * 0.7, 0.0, h * 0.5],
                [x - t, 0.0, h * 0.6],
                [x * 0.6, y * 0.4, h * 0.9],
                [0.0, y * 0.2, h - t],
                [-x * 0.3, -y * 0.4, h - t],
            ],
            t,
            BLACK_PLASTIC,
        );
        b.bar("nozzle", [-x * 0.3, -y * 0.4, h - t * 2.2], [-x * 0.7, -y * 0.5, h * 0.74], t * 1.4, mat);
        b.ball("castor", [x * 0.5, 0.0, r * 0.5], r * 0.5, BLACK_PLASTIC);
        return;
    }
    let foot = h * 0.035;
    b.prism(
        "head",
        Axis::Z,
        [0.0; 3],
        &[(-x, -y), (x * 0.5, -y), (x, -y * 0.5), (x, y * 0.5), (x * 0.5, y), (-x, y)],
        foot,
        GREY_FABRIC,
    );
    b.rounded_block("plate", [-x * 0.8, -y * 0.8, foot - 0.002 * u], [x * 0.8, y * 0.8, foot * 1.9], 0.01 * u, mat);
    let lean = -x * 0.5;
    b.bar("neck", [0.0, 0.0, foot * 1.6], [lean, 0.0, h * 0.2], 0.018 * u, mat);
    b.rounded_block("tank", [lean - x * 0.3, -y * 0.4, h * 0.18], [lean + x * 0.5, y * 0.4, h * 0.46], 0.03 * u, mat);
    b.rounded_block(
        "water",
        [lean + x * 0.3, -y * 0.3, h * 0.2],
        [lean + x * 0.65, y * 0.3, h * 0.36],
        0.02 * u,
        BLUE_GLASS,
    );
    b.bar("pole", [lean, 0.0, h * 0.44], [lean, 0.0, h * 0.86], 0.013 * u, STEEL);
    b.pipe(
        "handle",
        &[
            [lean, 0.0, h * 0.86],
            [lean - x * 0.2, 0.0, h * 0.95],
            [lean, 0.0, h - 0.022 * u],
            [lean + x * 0.3, 0.0, h * 0.94],
            [lean + x * 0.05, 0.0, h * 0.86],
        ],
        0.014 * u,
        BLACK_PLASTIC,
    );
}

/// A soleplate with a tip, a body with a handle, a dial and a tank.
pub(super) fn iron(b: &mut Build<'_>) {
    let u = fit(b, [0.224, 0.088, 0.104]);
    let (x, y, h) = half_dims(b);
    let mat = b.choose(&[BLUE_PLASTIC, WHITE_PLASTIC, PURPLE_PLASTIC, GREEN_PLASTIC, BLACK_PLASTIC, RED_PLASTIC]);
    let sole = [
        (-1.0, -0.85),
        (-0.95, -0.95),
        (-0.1, -1.0),
        (0.5, -0.66),
        (0.85, -0.25),
        (1.0, 0.0),
        (0.85, 0.25),
        (0.5, 0.66),
        (-0.1, 1.0),
        (-0.95, 0.95),
        (-1.0, 0.85),
    ];
    let outline = |k: f32| sole.iter().map(|p| (p.0 * x * k, p.1 * y * k)).collect::<Vec<_>>();
    b.prism("sole", Axis::Z, [0.0; 3], &outline(1.0), h * 0.06, STEEL);
    let level = |k: f32, z: f32| outline(k).into_iter().map(move |p| [p.0 - x * 0.02, p.1, z]);
    let points: Vec<P> = level(0.96, h * 0.058).chain(level(0.9, h * 0.25)).chain(level(0.6, h * 0.42)).collect();
    b.hull("body", &points, mat);
    let tank: Vec<P> = [(0.94, 0.15), (0.86, 0.3), (0.62, 0.4)]
        .into_iter()
        .flat_map(|(tip, z)| {
            [[x * tip, 0.0, h * z], [x * 0.3, y * 0.7 * (1.2 - z), h * z], [x * 0.3, -y * 0.7 * (1.2 - z), h * z]]
        })
        .collect();
    b.hull("tank", &tank, BLUE_GLASS);
    let r = (y * 0.27).min(h * 0.11);
    let points = [
        [x * 0.4, 0.0, h * 0.36],
        [x * 0.5, 0.0, h - r * 1.6],
        [-x * 0.6, 0.0, h - r * 1.45],
        [-x * 0.82, 0.0, h * 0.36],
    ];
    b.pipe("handle", &points, r, mat);
    b.block("back", [-x, -y * 0.5, h * 0.06], [-x * 0.8, y * 0.5, h * 0.45], mat);
    b.cylinder("dial", [-x * 0.1, 0.0, h * 0.4], y * 0.45, h * 0.06, GREY_PLASTIC);
    b.rounded_block("button", [x * 0.3, -r * 0.4, h - r * 1.3], [x * 0.4, r * 0.4, h], 0.003 * u, GREY_PLASTIC);
}

/// A handset with a head of holes, or a stand with a pole and a tank.
pub(super) fn garment_steamer(b: &mut Build<'_>) {
    let u = fit(b, [0.08, 0.08, 0.192]);
    let (x, y, h) = half_dims(b);
    let mat = b.choose(&[WHITE_PLASTIC, PINK_PLASTIC, BLUE_PLASTIC, GREY_PLASTIC]);
    if h < 0.6 {
        let r = x.min(y) * 0.8;
        b.lathe("grip", [0.0; 3], &[(r * 0.8, 0.0), (r * 0.9, h * 0.08), (r * 0.5, h * 0.3), (r * 0.48, h * 0.6)], mat);
        b.rounded_block("head", [-x, -y, h * 0.58], [x * 0.8, y, h], r * 0.35, mat);
        b.rounded_block("plate", [x * 0.7, -y * 0.8, h * 0.64], [x, y * 0.8, h * 0.96], r * 0.1, STEEL);
        b.rounded_block(
            "trigger",
            [r * 0.4, -r * 0.2, h * 0.42],
            [(r * 0.7).min(x), r * 0.2, h * 0.54],
            r * 0.1,
            GREY_PLASTIC,
        );
        return;
    }
    let base = h * 0.2;
    let (body, wheel) = (x.min(y) / x, (h * 0.03).min(x * 0.3));
    b.rounded_block("base", [-x, -y, h * 0.02], [x, y, base], 0.04 * u * body.max(0.3), mat);
    b.rounded_block(
        "tank",
        [-x * 0.8, -y * 0.7, base - 0.005 * u],
        [x * 0.1, y * 0.7, base * 1.5],
        0.02 * u,
        BLUE_GLASS,
    );
    for cy in [-y * 0.8, y * 0.8] {
        b.rod("wheel", [-x * 0.6, cy - 0.01 * u, wheel], [-x * 0.6, cy + 0.01 * u, wheel], wheel, BLACK_PLASTIC);
        b.rod("wheel", [x * 0.6, cy - 0.01 * u, wheel], [x * 0.6, cy + 0.01 * u, wheel], wheel, BLACK_PLASTIC);
    }
    b.bar("pole", [x * 0.4, 0.0, base], [x * 0.4, 0.0, h - 0.03 * u], 0.011 * u, STEEL);
    let w = y - 0.016 * u;
    b.pipe("hanger", &[[x * 0.4, -w, h * 0.9], [x * 0.4, 0.0, h - 0.012 * u], [x * 0.4, w, h * 0.9]], 0.009 * u, mat);
    b.rounded_block("head", [x * 0.45, -y * 0.35, h * 0.82], [x * 0.8, y * 0.35, h * 0.9], 0.015 * u, mat);
    b.pipe(
        "hose",
        &[
            [x * 0.6, 0.0, h * 0.83],
            [x - 0.017 * u, y * 0.3, h * 0.5],
            [x * 0.75, y * 0.3, h * 0.3],
            [x * 0.5, 0.0, base],
        ],
        0.011 * u,
        GREY_FABRIC,
    );
}

/// A bed, a column, an arm with a needle, a wheel at the side.
pub(super) fn sewing_machine(b: &mut Build<'_>) {
    let u = fit(b, [0.128, 0.304, 0.224]);
    let (x, y, h) = half_dims(b);
    let mat = b.choose(&[WHITE_PLASTIC, WHITE_METAL, BLACK_METAL, SAGE, SKY, PINK_PLASTIC]);
    let bed = h * 0.24;
    let inner = y - y * 0.5;
    let round = 0.015 * u;
    let wheel = y * 0.06;
    b.rounded_block("bed", [-x, -y, 0.0], [x, y - wheel, bed], round, mat);
    b.rounded_block("column", [-x * 0.85, inner, bed - round], [x * 0.7, y - wheel, h], round, mat);
    b.rounded_block("arm", [-x * 0.75, -y * 0.8, h * 0.62], [x * 0.6, inner + round * 2.0, h - 0.006 * u], round, mat);
    b.rounded_block("head", [-x * 0.75, -y * 0.85, h * 0.5], [x * 0.65, -y * 0.5, h - 0.008 * u], round, mat);
    let needle = -y * 0.68;
    b.cylinder("needle", [0.0, needle, bed + 0.004 * u], 0.0015 * u, h * 0.3, STEEL);
    b.cylinder("bar", [0.0, needle, h * 0.4], 0.005 * u, h * 0.14, STEEL);
    b.block(
        "foot",
        [-x * 0.1, needle - 0.008 * u, bed + 0.002 * u],
        [x * 0.15, needle + 0.008 * u, bed + 0.006 * u],
        STEEL,
    );
    b.block("plate", [-x * 0.5, -y * 0.85, bed - 0.001 * u], [x * 0.5, -y * 0.5, bed + 0.001 * u], STEEL);
    b.ledge("bed", [0.0, (inner - y * 0.46) / 2.0, bed], (x * 0.6, (inner + y * 0.46) / 2.0 * 0.9), h * 0.36);
    b.rod("wheel", [0.0, y - wheel * 1.1, h * 0.75], [0.0, y, h * 0.75], h * 0.13, GREY_PLASTIC);
    for i in 0..2 {
        knob(
            b,
            [x * 0.7 - 0.001 * u, inner + (y - inner) * 0.45, h * (0.45 + 0.25 * i as f32)],
            h * 0.07,
            x * 0.2,
            (GREY_PLASTIC, BLACK),
        );
    }
    b.rod("light", [x * 0.2, -y * 0.55, h * 0.49], [x * 0.2, -y * 0.55, h * 0.52], 0.01 * u, WARM_BULB);
}
