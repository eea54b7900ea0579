//! Toilets, basins, baths and showers.

use vc_graph::asset::JointKind;

use crate::material::*;
use crate::object::joinery::{Fitted, Handle, Swing, cupboard_doors, lid, swing};
use crate::solid::{
    Axis, Build, CORNERS, P, case, fit, floor_of, half_dims, loft_levels, oblong, pit, plate_with_hole,
};

/// Points of an oval seen from above, with its straight part at the back: `x` and `y` from -1 to 1.
const BOWL: [(f32, f32); 12] = [
    (-1.0, -0.78),
    (-0.2, -1.0),
    (0.3, -0.96),
    (0.68, -0.78),
    (0.92, -0.45),
    (1.0, -0.12),
    (1.0, 0.12),
    (0.92, 0.45),
    (0.68, 0.78),
    (0.3, 0.96),
    (-0.2, 1.0),
    (-1.0, 0.78),
];

/// The oval between two X coordinates with a half width.
fn oval(x0: f32, x1: f32, y: f32) -> Vec<(f32, f32)> {
    let (middle, half) = (f32::midpoint(x0, x1), (x1 - x0) / 2.0);
    BOWL.iter().map(|p| (middle + p.0 * half, p.1 * y)).collect()
}

/// The hull between ovals at two heights.
fn oval_hull(b: &mut Build<'_>, name: &str, below: (f32, f32, f32, f32), above: (f32, f32, f32, f32), mat: MaterialId) {
    let level = |(x0, x1, y, z): (f32, f32, f32, f32)| oval(x0, x1, y).into_iter().map(move |p| [p.0, p.1, z]);
    let points: Vec<P> = level(below).chain(level(above)).collect();
    b.hull(name, &points, mat);
}

/// A rim between two ovals.
fn oval_rim(
    b: &mut Build<'_>,
    name: &str,
    outer: &[(f32, f32)],
    inner: &[(f32, f32)],
    (z0, z1): (f32, f32),
    mat: MaterialId,
) {
    for i in 0..outer.len() {
        let k = (i + 1) % outer.len();
        b.prism(name, Axis::Z, [0.0, 0.0, z0], &[outer[i], outer[k], inner[k], inner[i]], z1 - z0, mat);
    }
}

/// An open oval bowl that narrows downwards, with a surface inside.
fn oval_bowl(b: &mut Build<'_>, (x0, x1, y): (f32, f32, f32), (z0, z1): (f32, f32), wall: f32, mat: MaterialId) {
    let tall = z1 - z0;
    let outer = |inset: f32, k: f32| oval(x0 + (x1 - x0) * inset * 0.5, x1 - (x1 - x0) * inset, y * k);
    let inner = |inset: f32, k: f32| {
        let (a, c) = (x0 + (x1 - x0) * inset * 0.5 + wall, x1 - (x1 - x0) * inset - wall);
        oval(a, c.max(a + wall), (y * k - wall).max(wall))
    };
    let floor = z0 + wall.min(tall * 0.4);
    let loops = [
        (outer(0.14, 0.84), z0),
        (outer(0.05, 0.94), z0 + tall * 0.45),
        (outer(0.01, 0.985), z1 - tall * 0.12),
        (outer(0.0, 1.0), z1 - tall * 0.06),
        (outer(0.01, 0.985), z1),
        (inner(0.02, 0.97), z1),
        (inner(0.06, 0.92), floor + (z1 - floor) * 0.45),
        (inner(0.16, 0.7), floor),
    ];
    loft_levels(b, "bowl", &loops, mat);
    let bed = inner(0.16, 0.7);
    let (rear, front) = (bed[0].0, bed[5].0);
    let half = ((front - rear) * 0.29, (y * 0.7 - wall).max(wall) * 0.6);
    b.inside("basin", [f32::midpoint(rear, front), 0.0, floor], half, z1 - floor - 0.004);
}

/// A bowl with a hinged seat and lid; the cistern is on it or hidden in the wall.
pub(super) fn toilet(b: &mut Build<'_>) {
    let u = fit(b, [0.48, 0.288, 0.576]);
    let (x, y, h) = half_dims(b);
    let rim = (h * 0.52).min(0.41 * (h / 0.72).max(0.5));
    let cistern = b.rng.chance(0.7);
    let tank = b.vary(0.17, 0.2) * u;
    let back = -x + if cistern { tank } else { 0.1 * u };
    let side = y * 0.93;
    // Foot and bowl.
    let floor = rim * 0.52;
    let slender = b.rng.chance(0.5);
    let (reach, wide) = if slender { (x * 0.35, y * 0.58) } else { (x * 0.75, y * 0.82) };
    oval_hull(
        b,
        "foot",
        (-x + 0.02 * u, reach, wide, 0.0),
        (-x + 0.02 * u, x * 0.72, side * 0.88, floor + 0.002 * u),
        PORCELAIN,
    );
    oval_bowl(b, (back - 0.03 * u, x, side), (floor, rim), 0.035 * u, PORCELAIN);
    b.cylinder("water", [x * 0.25, 0.0, floor + 0.034 * u], side * 0.3, 0.0025 * u, WATER);
    let shelf = [-x, -side * 0.8, floor * 0.9];
    b.rounded_block("mount", shelf, [back + 0.03 * u, side * 0.8, rim], 0.02 * u, PORCELAIN);
    if cistern {
        b.rounded_block(
            "cistern",
            [-x, -y * 0.98, rim - 0.004 * u],
            [-x + tank, y * 0.98, h - 0.035 * u],
            0.025 * u,
            PORCELAIN,
        );
        b.rounded_block(
            "cistern_lid",
            [-x, -y, h - 0.036 * u],
            [-x + tank + 0.006 * u, y, h - 0.006 * u],
            0.012 * u,
            PORCELAIN,
        );
        b.top("cistern", [-x + tank * 0.3, 0.0, h], (tank * 0.28, y * 0.8));
        b.cylinder("button", [-x + tank * 0.7, 0.0, h - 0.008 * u], 0.022 * u, 0.008 * u, CHROME);
    } else {
        b.rounded_block("panel", [-x, -y, rim - 0.05 * u], [-x + 0.1 * u, y, h], 0.008 * u, WHITE_TILE);
        b.rounded_block(
            "plate",
            [-x + 0.098 * u, -0.11 * u, h - 0.19 * u],
            [-x + 0.108 * u, 0.11 * u, h - 0.05 * u],
            0.003 * u,
            CHROME,
        );
        b.top("panel", [-x + 0.05 * u, 0.0, h], (0.04 * u, y * 0.9));
    }
    toilet_seat(b, (back + 0.025 * u, x, side), rim, u);
}

/// Seat and lid, each on its own hinge.
fn toilet_seat(b: &mut Build<'_>, (x0, x1, y): (f32, f32, f32), rim: f32, u: f32) {
    let mat = b.choose(&[WHITE_PLASTIC, WHITE_PLASTIC, WHITE_PLASTIC, b.style.wood, BLACK_PLASTIC]);
    let (t, low) = (0.018 * u, rim + 0.002 * u);
    let anchor = [x0, 0.0, low + t];
    for cy in [-y * 0.4, y * 0.4] {
        b.rod(
            "hinge",
            [x0 - 0.004 * u, cy - 0.02 * u, low + 0.006 * u],
            [x0 - 0.004 * u, cy + 0.02 * u, low + 0.006 * u],
            0.008 * u,
            CHROME,
        );
    }
    let (outer, inner) = (oval(x0 + 0.002 * u, x1, y), oval(x0 + 0.09 * u, x1 - 0.07 * u, y * 0.62));
    lid(b, anchor, 1.5, |b| {
        b.visual_only(|b| oval_rim(b, "seat", &outer, &inner, (low, low + t), mat));
        b.collision_only(|b| seat_bars(b, (x0, x1, y), (low, low + t), u));
    });
    // A tiny offset distinguishes the lid's hinge from the seat's.
    lid(b, [anchor[0], 0.0, anchor[2] + 0.002 * u], 1.55, |b| {
        let under = [0.0, 0.0, low + t + 0.002 * u];
        b.visual_only(|b| b.prism("lid", Axis::Z, under, &outer, t * 0.9, mat));
        // Every second corner of the oval, including those of the straight back.
        let corners: Vec<(f32, f32)> = [0, 1, 3, 5, 6, 8, 10, 11].map(|i| outer[i]).into();
        b.collision_only(|b| b.prism("lid", Axis::Z, under, &corners, t * 0.9, mat));
        b.top("lid", [f32::midpoint(x0, x1), 0.0, low + t * 1.9 + 0.002 * u], ((x1 - x0) * 0.3, y * 0.6));
    });
}

/// The collision geometry of a seat: four bars around its opening, within its oval.
fn seat_bars(b: &mut Build<'_>, (x0, x1, y): (f32, f32, f32), (low, high): (f32, f32), u: f32) {
    let (rear, front) = (x0 + 0.09 * u, x1 - 0.07 * u);
    let bars = [
        ([x0 + 0.002 * u, -y * 0.78], [rear, y * 0.78]),
        ([front, -y * 0.5], [x1, y * 0.5]),
        ([rear, -y * 0.92], [front, -y * 0.62]),
        ([rear, y * 0.62], [front, y * 0.92]),
    ];
    for (from, to) in bars {
        b.block("seat", [from[0], from[1], low], [to[0], to[1], high], PORCELAIN);
    }
}

/// A low bowl like a toilet's with a tap.
pub(super) fn bidet(b: &mut Build<'_>) {
    let u = fit(b, [0.416, 0.272, 0.304]);
    let (x, y, h) = half_dims(b);
    let top = h * 0.82;
    let floor = top * 0.55;
    let wall = 0.04 * u;
    oval_hull(
        b,
        "foot",
        (-x + 0.01 * u, x * 0.5, y * 0.66, 0.0),
        (-x + 0.01 * u, x * 0.8, y * 0.86, floor + 0.002 * u),
        PORCELAIN,
    );
    oval_bowl(b, (-x + 0.1 * u, x, y), (floor, top), wall, PORCELAIN);
    b.rounded_block("deck", [-x, -y * 0.78, floor * 0.8], [-x + 0.15 * u, y * 0.78, top], 0.015 * u, PORCELAIN);
    let tap = b.style.tap;
    b.cylinder("tap", [-x + 0.06 * u, 0.0, top - 0.001 * u], 0.02 * u, (h - top) * 0.7, tap);
    b.bar(
        "spout",
        [-x + 0.06 * u, 0.0, top + (h - top) * 0.5],
        [-x + 0.15 * u, 0.0, top + (h - top) * 0.42],
        0.009 * u,
        tap,
    );
    b.bar("lever", [-x + 0.06 * u, 0.0, top + (h - top) * 0.75], [-x + 0.11 * u, 0.0, h - 0.006 * u], 0.005 * u, tap);
}

/// A basin on a pedestal, on the wall over a trap cover, or a bowl for a vanity.
pub(super) fn washbasin(b: &mut Build<'_>) {
    let u = fit(b, [0.288, 0.32, 0.08]);
    let (x, y, h) = half_dims(b);
    if h <= 0.25 {
        return bowl_basin(b, u);
    }
    let deep = (h * 0.45).min(0.19);
    let (rim, ledge, t) = (h, 0.1 * u, 0.025 * u);
    let square = b.rng.chance(0.45);
    if square {
        b.block("ledge", [-x, -y, rim - deep], [-x + ledge, y, rim], PORCELAIN);
        pit(b, "basin", [-x + ledge, -y, rim - deep], [x, y, rim], t, PORCELAIN);
        floor_of(b, "basin", [-x + ledge + t, -y + t, rim - deep + t + 0.0015 * u], [x - t, y - t, rim]);
        b.cylinder("waste", [ledge / 2.0, 0.0, rim - deep - 0.001 * u], 0.03 * u, t + 0.002 * u, CHROME);
    } else {
        oval_bowl(b, (-x + ledge * 0.8, x, y), (rim - deep, rim), t, PORCELAIN);
        b.rounded_block("ledge", [-x, -y * 0.8, rim - deep * 0.8], [-x + ledge, y * 0.8, rim], 0.012 * u, PORCELAIN);
        b.cylinder("waste", [ledge * 0.4, 0.0, rim - deep + t * 0.5], 0.025 * u, t * 0.5 + 0.002 * u, CHROME);
    }
    b.top("ledge", [-x + ledge * 0.44, 0.0, rim], (ledge * 0.4, (y * 0.7).min(0.14)));
    let under = rim - deep + 0.002 * u;
    match b.rng.below(3) {
        0 => {
            let foot = ([-x + 0.02 * u, -y * 0.32], [x * 0.15, y * 0.32]);
            b.rounded_block(
                "foot",
                [foot.0[0], foot.0[1], 0.0],
                [foot.1[0], foot.1[1], 0.05 * u],
                0.015 * u,
                PORCELAIN,
            );
            oval_hull(
                b,
                "pedestal",
                (-x + 0.03 * u, x * 0.05, y * 0.24, 0.04 * u),
                (-x + 0.03 * u, x * 0.3, y * 0.36, under),
                PORCELAIN,
            );
        }
        1 => oval_hull(b, "cover", (-x, -x * 0.1, y * 0.2, 0.0), (-x, x * 0.35, y * 0.34, under), PORCELAIN),
        _ => {
            let t = 0.018 * u;
            let (low, high) = ([-x, -y * 0.9, 0.08 * u], [x * 0.86, y * 0.9, under]);
            b.block("plinth", [-x, -y * 0.86, 0.0], [x * 0.7, y * 0.86, low[2]], b.style.cabinet);
            case(b, low, high, t, b.style.cabinet);
            let look = Fitted::any(b, b.style.cabinet, t);
            let inner = ([low[0] + t, low[1] + t, low[2] + t], [high[0] - 0.002 * u, high[1] - t, high[2] - t]);
            floor_of(b, "cupboard", inner.0, inner.1);
            let look = Fitted { handle: Handle::None, ..look };
            cupboard_doors(b, &look, ([high[0], low[1], low[2]], [high[0] + t, high[1], high[2]]), 0.5, false);
        }
    }
}

/// A round, oval or square bowl that stands on a counter.
fn bowl_basin(b: &mut Build<'_>, u: f32) {
    let (x, y, h) = half_dims(b);
    let mat = b.choose(&[PORCELAIN, PORCELAIN, STONEWARE, MARBLE, GREEN_GLAZE, BLACK_GLAZE]);
    let t = 0.014 * u;
    match b.rng.below(3) {
        0 => {
            let r = x.min(y);
            let profile =
                [(r * 0.5, 0.0), (r * 0.86, h * 0.4), (r, h), (r - t, h), (r * 0.86 - t, h * 0.42), (r * 0.5, t)];
            b.lathe("bowl", [0.0; 3], &profile, mat);
            b.cylinder("waste", [0.0, 0.0, t * 0.5], r * 0.12, t * 0.5 + 0.001 * u, CHROME);
            b.inside("basin", [0.0, 0.0, t + 0.0015 * u], (r * 0.34, r * 0.34), h - t - 0.003 * u);
        }
        1 => {
            oval_hull(b, "foot", (-x * 0.5, x * 0.5, y * 0.5, 0.0), (-x * 0.8, x * 0.8, y * 0.86, h * 0.3), mat);
            oval_bowl(b, (-x, x, y), (h * 0.28, h), t, mat);
        }
        _ => {
            b.block("foot", [-x * 0.8, -y * 0.85, 0.0], [x * 0.8, y * 0.85, h * 0.15], mat);
            pit(b, "bowl", [-x, -y, h * 0.14], [x, y, h], t, mat);
            b.cylinder("waste", [0.0, 0.0, h * 0.14], 0.022 * u, t + 0.001 * u, CHROME);
            floor_of(b, "basin", [-x + t, -y + t, h * 0.14 + t + 0.0015 * u], [x - t, y - t, h]);
        }
    }
}

/// A tub: panelled, free-standing or on feet.
pub(super) fn bathtub(b: &mut Build<'_>) {
    let u = fit(b, [0.56, 1.12, 0.4]);
    let (x, y, h) = half_dims(b);
    let (rim, floor) = (0.07 * u, h * 0.24);
    let free = b.rng.chance(0.5);
    let feet = free && b.rng.chance(0.5);
    let mat = b.choose(&[WHITE_METAL, WHITE_METAL, PORCELAIN]);
    let base = if feet { floor * 0.6 } else { 0.0 };
    let (mouth, bed) = ((x - rim, y - rim), ((x - rim) * 0.84, (y - rim) * 0.86));
    let round = x * if free { 0.9 } else { 0.35 };
    let hollow = [
        (oblong(mouth, round * 0.9), h),
        (oblong((mouth.0 * 0.95, mouth.1 * 0.95), round * 0.85), floor + (h - floor) * 0.3),
        (oblong(bed, round * 0.75), floor),
    ];
    let outer = if free {
        let skirt = (x * 0.74, y * 0.84);
        vec![
            (oblong(skirt, round * 0.7), base),
            (oblong((x * 0.9, y * 0.94), round * 0.85), h * 0.55),
            (oblong((x * 0.95, y * 0.97), round), h - 0.03 * u),
            (oblong((x, y), round), h - 0.025 * u),
            (oblong((x, y), round), h),
        ]
    } else {
        let edge = oblong((x, y), 0.02 * u);
        vec![(oblong((x - 0.02 * u, y - 0.004 * u), 0.02 * u), 0.0), (edge.clone(), h - 0.03 * u), (edge, h)]
    };
    let loops: Vec<_> = outer.into_iter().chain(hollow).collect();
    loft_levels(b, "tub", &loops, mat);
    if feet {
        for (sx, sy) in CORNERS {
            let at = [sx * x * 0.52, sy * y * 0.66, 0.0];
            b.lathe(
                "foot",
                at,
                &[(0.035 * u, 0.0), (0.022 * u, base * 0.4), (0.045 * u, base + 0.004 * u)],
                b.style.tap,
            );
        }
    }
    if !free {
        let panel = b.choose(&[WHITE, WHITE, b.style.tile, b.style.wood]);
        b.block("panel", [x - 0.03 * u, -y + 0.012 * u, 0.0], [x - 0.005 * u, y - 0.012 * u, h - 0.04 * u], panel);
    }
    b.cylinder("waste", [0.0, -bed.1 * 0.8, floor - 0.01], 0.03 * u, 0.0115, CHROME);
    b.inside(
        "basin",
        [0.0, 0.0, floor + 0.002 * u],
        ((bed.0 - round * 0.26).max(bed.0 * 0.3), bed.1 - (round * 0.26).min(bed.1 * 0.5)),
        h - floor - 0.004 * u,
    );
    let shelf = if free { x * 0.3 } else { x * 0.8 };
    b.top("rim", [0.0, mouth.1 + rim * 0.5, h], (shelf, rim * 0.42));
    let z = h * 0.8;
    b.rod("overflow", [0.0, -mouth.1 - 0.01 * u, z], [0.0, -mouth.1 * 0.97 + 0.012 * u, z], 0.028 * u, CHROME);
}

/// A tray, one or two glass panes, a riser with a head, and a mixer.
pub(super) fn shower(b: &mut Build<'_>) {
    let u = fit(b, [0.64, 0.64, 1.6]);
    let (x, y, h) = half_dims(b);
    let tray = tray(b, u);
    let (t, tap) = (0.008 * u, b.style.tap);
    let pane = b.choose(&[GLASS, GLASS, FROSTED_GLASS]);
    let top = h * 0.96;
    let edge = y - t * 2.0;
    b.block("pane", [-x + 0.02 * u, edge - t, tray - 0.001 * u], [x - 0.02 * u, edge, top], pane);
    b.block("profile", [-x, edge - t * 1.6, tray - 0.001 * u], [-x + 0.02 * u, edge + t * 0.6, top], tap);
    b.block("profile", [x - 0.02 * u, edge - t * 1.6, tray - 0.001 * u], [x, edge + t * 0.6, top], tap);
    if b.rng.chance(0.5) {
        let half = -y * b.vary(0.0, 0.3);
        b.block("pane", [x - 0.02 * u, half, tray - 0.001 * u], [x - 0.012 * u, edge - t * 1.6, top], pane);
    }
    let panel = [-x, -y * 0.9, tray - 0.001 * u];
    b.block("back_panel", panel, [-x + 0.012 * u, edge - t * 1.6, h], b.style.tile);
    riser(b, [-x + 0.012 * u, -y * 0.05, 0.0], h, u);
}

/// A tray on the floor with a drain; returns its height.
fn tray(b: &mut Build<'_>, u: f32) -> f32 {
    let (x, y, _) = half_dims(b);
    let tall = b.vary(0.04, 0.14) * u;
    let rim = 0.045 * u;
    let floor = tall * 0.6;
    let mat = b.choose(&[WHITE_METAL, WHITE_METAL, SLATE_TILE]);
    b.block("tray", [-x, -y, 0.0], [x, y, floor], mat);
    plate_with_hole(
        b,
        "tray",
        Axis::Z,
        ([-x, -y, floor], [x, y, tall]),
        ((-x + rim, -y + rim), (x - rim, y - rim)),
        mat,
    );
    b.cylinder("waste", [0.0, 0.0, floor - 0.001 * u], 0.05 * u, 0.004 * u, CHROME);
    tall
}

/// A mixer and a pole with a shower head, on the wall at `at[0]`.
fn riser(b: &mut Build<'_>, at: P, h: f32, u: f32) {
    let (x, y) = (at[0], at[1]);
    let tap = b.style.tap;
    let out = 0.06 * u;
    let (mixer, top) = (h * 0.52, h * 0.94);
    b.rod("mixer", [x + out, y - 0.13 * u, mixer], [x + out, y + 0.13 * u, mixer], 0.02 * u, tap);
    for cy in [-0.075, 0.075] {
        b.rod("mixer", [x - 0.001 * u, y + cy * u, mixer], [x + out, y + cy * u, mixer], 0.014 * u, tap);
    }
    b.rod("pole", [x + out, y, mixer], [x + out, y, top], 0.01 * u, tap);
    b.rod("bracket", [x - 0.001 * u, y, top - 0.05 * u], [x + out, y, top - 0.05 * u], 0.01 * u, tap);
    if b.rng.chance(0.5) {
        let reach = x + (b.size.x * 0.42).min(0.4);
        b.pipe("arm", &[[x + out, y, top], [reach, y, top]], 0.01 * u, tap);
        b.cylinder("rose", [reach, y, top - 0.035 * u], 0.1 * u, 0.012 * u, tap);
        b.rod("neck", [reach, y, top - 0.024 * u], [reach, y, top], 0.012 * u, tap);
    } else {
        let holder = h * 0.86;
        let (from, to) = ([x + out, y, holder], [x + out + 0.14 * u, y, holder + 0.05 * u]);
        b.bar("handset", from, to, 0.014 * u, tap);
        let face = [to[0] + 0.02 * u, y, to[2] - 0.04 * u];
        b.lathe_along("rose", to, face, &[(0.025 * u, -0.01 * u), (0.05 * u, 0.012 * u), (0.05 * u, 0.018 * u)], tap);
        let hose = [
            [x + out, y + 0.03 * u, mixer],
            [x + out + 0.04 * u, y + 0.06 * u, mixer * 0.86],
            [x + out + 0.02 * u, y + 0.04 * u, holder * 0.8],
            [x + out + 0.01 * u, y, holder],
        ];
        b.pipe("hose", &hose, 0.006 * u, CHROME);
    }
}

/// Four glass walls on a tray, one of them a sliding or hinged door.
pub(super) fn shower_stall(b: &mut Build<'_>) {
    let u = fit(b, [0.64, 0.64, 1.6]);
    let (x, y, h) = half_dims(b);
    let low = tray(b, u) - 0.001 * u;
    let (t, post, tap) = (0.008 * u, 0.03 * u, b.style.tap);
    let pane = b.choose(&[GLASS, GLASS, FROSTED_GLASS]);
    let roof = b.rng.chance(0.4);
    let top = h - if roof { 0.06 * u } else { 0.0 };
    for (cx, cy) in [(-x, -y), (-x, y - post), (x - post, -y), (x - post, y - post)] {
        b.block("post", [cx, cy, low], [cx + post, cy + post, top], tap);
    }
    b.block("back", [-x + 0.004 * u, -y + post, low], [-x + 0.012 * u, y - post, top], WHITE_PLASTIC);
    let inset = post * 0.4;
    for cy in [-y + inset, y - inset - t] {
        b.block("pane", [-x + post, cy, low], [x - post, cy + t, top], pane);
        b.block("rail", [-x + post, cy - t * 0.5, top - post], [x - post, cy + t * 1.5, top - 0.001 * u], tap);
    }
    b.block("rail", [x - post * 0.9, -y + post, top - post], [x - post * 0.1, y - post, top - 0.001 * u], tap);
    let face = x - post * 0.5;
    let (y0, y1, z1) = (-y + post, y - post, top - post);
    let middle = f32::midpoint(y0, y1);
    let grip = |b: &mut Build<'_>, cy: f32| {
        let z = h * 0.5;
        b.block(
            "grip",
            [face + t * 0.4, cy - 0.008 * u, z - 0.1 * u],
            [x - 0.001 * u, cy + 0.008 * u, z + 0.1 * u],
            tap,
        );
    };
    if b.rng.chance(0.5) {
        let (dl, dh) =
            ([face - t * 0.5, y0 + 0.003 * u, low + 0.006 * u], [face + t * 0.5, y1 - 0.003 * u, z1 - 0.003 * u]);
        swing(b, Swing::Left, dl, dh, 1.5, |b| {
            b.block("door", dl, dh, pane);
            grip(b, y0 + 0.06 * u);
        });
    } else {
        b.block("pane", [face - t * 1.7, middle - 0.02 * u, low], [face - t * 0.7, y1, z1], pane);
        let (from, to) = ([face - t * 0.5, y0, low + 0.006 * u], [face + t * 0.5, middle, z1 - 0.003 * u]);
        b.jointed(JointKind::Slide, from, [0.0, 1.0, 0.0], (0.0, (y1 - middle) * 0.9), |b| {
            b.block("door", from, to, pane);
            grip(b, middle - 0.05 * u);
        });
    }
    if roof {
        b.rounded_block("roof", [-x, -y, top - 0.001 * u], [x, y, h], 0.02 * u, WHITE_PLASTIC);
    }
    riser(b, [-x + 0.012 * u, 0.0, 0.0], top * 0.98, u);
}
