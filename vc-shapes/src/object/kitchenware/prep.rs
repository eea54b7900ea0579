//! Tools for measuring, straining, timing and cooling.

use std::f32::consts::{PI, TAU};

use nalgebra::{Isometry3, Vector3};
use vc_graph::portable::Portable;

use super::utensils::{ACROSS, grip, hoop_at, thin_wire};
use crate::material::*;
use crate::solid::{
    Build, arch, dims, ear, flat_ring, loft_columns, planar_tube, rounded_ring, sweep, turn, vessel, vessel_profile,
};

/// A piping bag: a cone of cloth standing on its nozzle.
pub(super) fn piping_bag(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let mat = b.choose(&[WHITE_COTTON, CLEAR_PLASTIC, BLUE_FABRIC]);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let cone = [
        rounded_ring(z * 0.12, (hx * 0.25, hx * 0.25), 1.0),
        rounded_ring(z * 0.7, (hx, hy * 0.75), 1.0),
        rounded_ring(z * 0.98, (hx * 0.6, hy), 1.0),
        rounded_ring(z, (hx * 0.35, hy * 0.97), 1.0),
    ];
    loft_columns(b, "bag", &cone, mat);
    turn(b, "nozzle", [0.0; 3], (hx * 0.3, z * 0.14), &[(0.35, 0.0), (1.0, 1.0)], STEEL);
}

/// A measuring jug with a scale.
pub(super) fn measuring_cup(b: &mut Build<'_>) {
    let (x, y, h) = dims(b);
    let r = (x / 2.0).min(y * 0.4);
    let (mat, ink) = (
        b.choose(&[GLASS, CLEAR_PLASTIC, STEEL, WHITE_PLASTIC]),
        b.choose(&[RED_PLASTIC, BLUE_PLASTIC, BLACK_PLASTIC]),
    );
    vessel(
        b,
        "cup",
        (r - 0.0008, h),
        &[(0.82, 0.0), (0.86, 0.03), (0.95, 0.7), (1.0, 1.0)],
        (r * 0.05).min(0.004),
        mat,
    );
    ear(b, (r * 0.88, y - r * 1.13), (h * 0.25, h * 0.93), r * 0.1, mat);
    let lip = [
        [r * 0.35, -r * 0.92, h * 0.992],
        [-r * 0.35, -r * 0.92, h * 0.992],
        [0.0, -r * 1.12, h * 0.992],
        [0.0, -r * 0.9, h * 0.82],
    ];
    b.hull("lip", &lip, mat);
    for i in 1..6 {
        let z = h * 0.14 * i as f32;
        let wide = r * if i % 2 == 0 { 0.3 } else { 0.18 };
        let face = r * (0.86 + 0.1 * z / h);
        b.block("mark", [face - r * 0.1, -wide, z], [face + 0.0006, wide, z + h * 0.012], ink);
    }
}

/// A small scoop, or a set of them on a ring.
pub(super) fn measuring_spoon(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let mat = b.choose(&[STEEL, WHITE_PLASTIC, COPPER, RED_PLASTIC, BLUE_PLASTIC]);
    let r = x / 2.0;
    let centre = y / 2.0 - r;
    let outside: Vec<_> =
        [(0.5, 0.0), (0.85, 0.25), (0.98, 0.7), (1.0, 1.0)].iter().map(|p| (p.0 * r, p.1 * z)).collect();
    b.lathe("bowl", [0.0, centre, 0.0], &vessel_profile(&outside, (r * 0.08).min(0.0015)), mat);
    b.inside(
        "inside",
        [0.0, centre, (r * 0.08).min(0.0015)],
        ((r * 0.28).max(0.0042), (r * 0.28).max(0.0042)),
        z * 0.9,
    );
    let t = (z * 0.08).min(0.0015);
    let at = |k: f32| [0.0, -y / 2.0 + (centre - r * 0.93 + y / 2.0) * k, z - t];
    let path = [(at(0.0), x * 0.1, t), (at(0.05), x * 0.2, t), (at(0.6), x * 0.16, t), (at(1.0), x * 0.2, t)];
    sweep(b, "handle", &path, ACROSS, mat);
}

/// A colander: a bowl with holes and two grips.
pub(super) fn colander(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let r = (x / 2.0).min(y * 0.44);
    let mat = b.choose(&[STEEL, WHITE_METAL, RED_METAL, WHITE_PLASTIC, GREEN_PLASTIC]);
    let (foot, t) = (z * 0.1, (r * 0.02).min(0.002));
    let h = z - foot;
    b.at([0.0, 0.0, foot], 0.0, |b| {
        vessel(b, "bowl", (r, h), &[(0.4, 0.0), (0.68, 0.2), (0.9, 0.6), (1.0, 1.0)], t, mat)
    });
    flat_ring(b, "foot", (0.0, foot + t * 0.4), (r * 0.36, r * 0.42), mat);
    for row in 0..4 {
        let (k, rise) = ([0.62, 0.76, 0.86, 0.93][row], [0.16, 0.34, 0.5, 0.68][row]);
        let holes = 12;
        for i in 0..holes {
            let angle = TAU * (i as f32 + 0.5 * (row % 2) as f32) / holes as f32;
            b.at([0.0; 3], angle, |b| {
                let (at, z) = (r * k, foot + h * rise);
                b.hull(
                    "hole",
                    &[
                        [at - r * 0.02, -r * 0.03, z],
                        [at - r * 0.02, r * 0.03, z],
                        [at + r * 0.03, 0.0, z - r * 0.02],
                        [at - r * 0.01, 0.0, z + r * 0.05],
                        [at + r * 0.025, 0.0, z + r * 0.03],
                    ],
                    BLACK_PLASTIC,
                );
            });
        }
    }
    for side in [-1.0, 1.0] {
        let w = (r * 0.04).min(0.005);
        let path = arch(
            [0.0, side * r * 0.94, z - w],
            [r * 0.3, 0.0, 0.0],
            [0.0, side * (y / 2.0 - r * 0.94 - w).max(1e-3), 0.0],
        );
        planar_tube(b, "handle", &path, w, [0.0, 0.0, 1.0], mat);
    }
}

/// A sieve: a bowl of mesh in a ring with a handle, for flour, pasta or tea.
pub(super) fn sieve(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let r = (x / 2.0).min(y * 0.35);
    let centre = y / 2.0 - r;
    let handle = b.choose(&[STEEL, BLACK_PLASTIC, BEECH]);
    let h = z * 0.92;
    let outside: Vec<_> =
        [(0.3, 0.0), (0.7, 0.25), (0.92, 0.6), (0.97, 0.95)].iter().map(|p| (p.0 * r, p.1 * z)).collect();
    b.lathe("mesh", [0.0, centre, 0.0], &vessel_profile(&outside, (r * 0.03).min(0.0015)), ALUMINIUM);
    hoop_at(b, [0.0, centre, 0.0], (h, z), (r * 0.9, r), STEEL);
    if b.class == "sieve" {
        b.inside("inside", [0.0, centre, (r * 0.03).min(0.0015).max(r * 0.06)], (r * 0.17, r * 0.17), z * 0.9);
    }
    for i in 0..4 {
        let (s, c) = (PI * i as f32 / 4.0).sine_cosine();
        let point = |k: f32, h: f32| [r * k * c, centre + r * k * s, z * h];
        let points = [
            point(-0.985, 0.95),
            point(-0.94, 0.6),
            point(-0.72, 0.24),
            point(-0.3, 0.005),
            point(0.3, 0.005),
            point(0.72, 0.24),
            point(0.94, 0.6),
            point(0.985, 0.95),
        ];
        thin_wire(b, &points.map(|p| [p[0], p[1], p[2].max(r * 0.008)]), r * 0.008, [-s, c, 0.0]);
    }
    let w = (z - h) / 2.0;
    grip(b, [0.0, -y / 2.0, z - w], [0.0, centre - r * 0.95, z - w], ((r * 0.14).max(w), w), handle);
}

/// A funnel standing on its rim or on its tube.
pub(super) fn funnel(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let r = x.min(y) / 2.0;
    let mat = b.choose(&[STEEL, WHITE_PLASTIC, RED_PLASTIC, BLUE_PLASTIC, GREEN_PLASTIC]);
    let (neck, rise) = (b.vary(0.16, 0.24), b.vary(0.4, 0.5));
    let t = (r * 0.03).min(0.002) / r;
    let (n, w) = (neck * 0.6, rise);
    // The rim points down so that the funnel stands.
    let profile = [
        (1.0, 0.0),
        (1.0, 0.04),
        (neck, 1.0 - w),
        (n, 1.0),
        (n - t, 1.0),
        (neck - t, 1.0 - w),
        (1.0 - t, 0.03),
        (1.0 - t, 0.0),
        (1.0, 0.0),
    ];
    turn(b, "funnel", [0.0; 3], (r, z), &profile, mat);
}

/// A salad spinner: a bowl with a basket in it and a lid with a crank.
pub(super) fn salad_spinner(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let r = x.min(y) / 2.0;
    let (bowl, cap) = (
        b.choose(&[CLEAR_PLASTIC, WHITE_PLASTIC, GREEN_PLASTIC]),
        b.choose(&[WHITE_PLASTIC, GREEN_PLASTIC, RED_PLASTIC, BLACK_PLASTIC]),
    );
    let h = z * 0.8;
    vessel(b, "bowl", (r, h), &[(0.7, 0.0), (0.85, 0.1), (0.97, 0.6), (1.0, 1.0)], (r * 0.025).min(0.003), bowl);
    b.slide([0.0, 0.0, 1.0], z * 1.2, |b| {
        turn(
            b,
            "lid",
            [0.0, 0.0, h + 0.0004],
            (r, (z - h) * 0.6),
            &[(1.0, 0.0), (1.0, 0.3), (0.85, 0.8), (0.4, 1.0)],
            cap,
        );
        b.block(
            "crank",
            [-r * 0.08, -r * 0.1, h + (z - h) * 0.55],
            [r * 0.08, r * 0.6, h + (z - h) * 0.75],
            BLACK_PLASTIC,
        );
        b.cylinder("knob", [0.0, r * 0.5, h + (z - h) * 0.7], r * 0.09, (z - h) * 0.3, BLACK_PLASTIC);
    });
}

/// Timers: an egg, a dial or a box with a display.
pub(super) fn kitchen_timer(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let mat = b.choose(&[WHITE_PLASTIC, RED_PLASTIC, STEEL, YELLOW_PLASTIC, BLACK_PLASTIC]);
    if b.rng.chance(0.4) {
        return dial_timer(b, mat);
    }
    if x > 0.05 {
        let r = x.min(y) / 2.0;
        let (waist, tip) = (b.vary(0.28, 0.45), b.vary(0.6, 0.75));
        turn(
            b,
            "egg",
            [0.0; 3],
            (r, z),
            &[(0.6, 0.0), (0.92, 0.15), (1.0, waist), (0.93, 0.6), (tip, 0.85), (0.35, 0.97), (0.0, 1.0)],
            mat,
        );
        flat_ring(b, "dial", (z * 0.38, z * 0.42), (r * 0.9, r * 1.0), BLACK_PLASTIC);
        return;
    }
    b.rounded_block("case", [-x / 2.0, -y / 2.0, 0.0], [x / 2.0 - x * 0.05, y / 2.0, z], x * 0.3, mat);
    let face = x * 0.45;
    b.block("display", [face - x * 0.2, -y * 0.36, z * 0.55], [face + x * 0.02, y * 0.36, z * 0.85], SCREEN);
    for i in 0..3 {
        let at = y * 0.26 * (i as f32 - 1.0);
        b.rod(
            "button",
            [face - x * 0.2, at, z * 0.28],
            [face + x * 0.05, at, z * 0.28],
            y * 0.09,
            [RED_PLASTIC, GREY_PLASTIC, GREEN_PLASTIC][i],
        );
    }
}

/// A standing round timer: a plate with marks and a grip across its dial.
fn dial_timer(b: &mut Build<'_>, mat: MaterialId) {
    let (x, y, z) = dims(b);
    let (r, hx) = (y.min(z) / 2.0, x / 2.0);
    let at = |px: f32| [px, 0.0, r];
    b.lathe_along("case", at(-hx), at(hx), &[(r * 0.95, 0.0), (r, x * 0.1), (r, x * 0.45), (r * 0.9, x * 0.6)], mat);
    let dial = r * b.vary(0.66, 0.8);
    b.rod("dial", at(hx * 0.1), at(hx * 0.4), dial, WHITE_PLASTIC);
    for i in 0..12 {
        b.posed(Isometry3::new(Vector3::new(0.0, 0.0, r), Vector3::x() * (TAU * i as f32 / 12.0)), |b| {
            let wide = r * if i % 3 == 0 { 0.04 } else { 0.02 };
            b.block("mark", [hx * 0.3, -wide, dial * 0.78], [hx * 0.45, wide, dial * 0.94], BLACK_PLASTIC);
        });
    }
    b.rod("knob", at(hx * 0.3), at(hx * 0.6), dial * 0.55, mat);
    b.rounded_block(
        "grip",
        [hx * 0.4, -dial * 0.12, r - dial * 0.5],
        [hx, dial * 0.12, r + dial * 0.5],
        dial * 0.1,
        mat,
    );
}

/// A meat thermometer: a dial on a needle.
pub(super) fn meat_thermometer(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let r = x.min(z) / 2.0;
    let (from, to) = ([0.0, -y / 2.0, r], [0.0, y / 2.0, r]);
    let depth = (y * 0.08).min(r);
    b.lathe_along(
        "dial",
        from,
        to,
        &[(r * 0.95, depth * 0.08), (r, depth * 0.2), (r, depth), (r * 0.5, depth * 1.5), (r * 0.15, depth * 2.5)],
        STEEL,
    );
    b.rod("face", [0.0, -y / 2.0 - 0.0, r], [0.0, -y / 2.0 + depth * 0.2, r], r * 0.82, WHITE_PAPER);
    b.lathe_along("needle", from, to, &[(r * 0.12, depth), (r * 0.12, y * 0.92), (0.0, y)], STEEL);
}

/// An ice bucket with a lid and a bail.
pub(super) fn ice_bucket(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let r = (x / 2.0).min(y * 0.44);
    let mat = b.choose(&[STEEL, CHROME, COPPER, CLEAR_PLASTIC]);
    let h = z * 0.8;
    vessel(b, "bucket", (r, h), &[(0.78, 0.0), (0.8, 0.03), (0.97, 0.95), (1.0, 1.0)], (r * 0.04).min(0.004), mat);
    for side in [-1.0, 1.0] {
        let w = (r * 0.06).min(0.006);
        let path = arch(
            [0.0, side * r * 0.92, h * 0.75],
            [0.0, 0.0, h * 0.12],
            [0.0, side * (y / 2.0 - r * 0.92 - w).max(1e-3), 0.0],
        );
        planar_tube(b, "handle", &path, w, ACROSS, BRASS);
    }
    b.slide([0.0, 0.0, 1.0], z, |b| {
        turn(
            b,
            "lid",
            [0.0, 0.0, h + 0.0004],
            (r * 0.99, z * 0.1),
            &[(1.0, 0.0), (1.0, 0.2), (0.6, 0.9), (0.1, 1.0)],
            mat,
        );
        turn(b, "knob", [0.0, 0.0, h + z * 0.09], (r * 0.16, z * 0.11), super::dishes::KNOB, BRASS);
    });
}

/// An ice cube tray with a row of cups.
pub(super) fn ice_cube_tray(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let mat = b.choose(&[WHITE_PLASTIC, BLUE_PLASTIC, CLEAR_PLASTIC, PINK_PLASTIC]);
    let t = (x * 0.02).min(z * 0.1);
    crate::solid::tub(b, "tray", &[(0.0, hx * 0.92, hy * 0.95), (z, hx, hy)], 0.15, t, mat);
    let columns = ((y / x * 2.2).round() as usize).clamp(3, 7);
    b.block("rib", [-t, -hy * 0.95, t * 0.5], [t, hy * 0.95, z * 0.9], mat);
    for i in 1..columns {
        let at = hy * (2.0 * i as f32 / columns as f32 - 1.0) * 0.95;
        b.block("rib", [-hx * 0.93, at - t, t * 0.5], [hx * 0.93, at + t, z * 0.92], mat);
    }
    let cell = (hx * 0.92 - 3.0 * t, hy * 1.9 / columns as f32 - 4.0 * t);
    let first = -hy * 0.95 + hy * 0.95 / columns as f32;
    b.inside("cup_1", [hx * 0.46, first, t * 1.01], ((cell.0 * 0.4).max(1e-4), (cell.1 * 0.3).max(1e-4)), z * 0.85);
}
