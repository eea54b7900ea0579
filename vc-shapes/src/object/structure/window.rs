//! Windows, and the curtains and blinds in front of them.

use vc_graph::asset::JointKind;

use crate::material::*;
use crate::object::joinery::{Swing, swing};
use crate::solid::{Axis, Build, P, collar, fit, half_dims, plate_with_border, plate_with_hole};

/// A frame with one or two sashes that open into the room, a sill and a lining inside.
///
/// The origin is the centre of the wall at the opening's lower edge.
pub(super) fn window(b: &mut Build<'_>) {
    b.anchored();
    let u = fit(b, [0.03, 0.3, 0.4]);
    let (x, y, h) = half_dims(b);
    let mat = b.choose(&[WHITE_PLASTIC, WHITE_PLASTIC, b.style.joinery, ANTHRACITE]);
    let depth = 0.035_f32.min(x);
    let border = 0.05 * u;
    let bars = b.choose(&[(0, 0), (0, 0), (0, 0), (1, 0), (1, 1)]);
    plate_with_border(b, "frame", [-depth, -y, 0.0], [depth, y, h], border, mat);
    // The stone ledge outside and the board inside.
    if x - depth > 0.005 {
        b.block("outer_sill", [-x, -y, 0.0], [-depth, y, 0.012 * u], ALUMINIUM);
    }
    let reach = x + b.vary(0.05, 0.095);
    let board = 0.024 * u;
    let sill = b.choose(&[b.style.joinery, MARBLE, b.style.wood, WHITE]);
    b.block("sill", [depth, -y, 0.0], [reach, y, board], sill);
    // Lines the opening up to the frame, so that no outer wall is visible inside.
    if x - depth > 0.005 {
        let t = 0.01 * u;
        plate_with_hole(
            b,
            "lining",
            Axis::X,
            ([depth, -y, board], [x, y, h]),
            ((t - y, board), (y - t, h - t)),
            b.style.joinery,
        );
    }
    let free = depth + 0.055 * u;
    if reach - free > 0.03 {
        b.top("sill", [f32::midpoint(free, reach), 0.0, board], ((reach - free) / 2.0 - 0.005, y - 0.02 * u));
    }
    let gap = 0.002;
    let inner = (y - border - gap, border + gap, h - border - gap);
    let (back, front) = (-depth * 0.4, depth + 0.006);
    // A rebate outside the sashes covers the gaps around them.
    let (stop, lap) = (back - 0.001, 0.012 * u);
    plate_with_border(b, "rebate", [-depth + 0.001, -y + border, border], [stop, y - border, h - border], lap, mat);
    let halves: &[(Swing, f32, f32)] = if y > 0.5 {
        b.block("mullion", [-depth, -border * 0.4, border], [depth, border * 0.4, h - border], mat);
        for side in [-1.0_f32, 1.0] {
            let (a, c) = (side * border * 0.4, side * (border * 0.4 + lap));
            let (low, high) = ([-depth + 0.001, a.min(c), border + lap], [stop, a.max(c), h - border - lap]);
            b.block("rebate", low, high, mat);
        }
        let middle = border * 0.4 + gap;
        &[(Swing::Right, -inner.0, -middle), (Swing::Left, middle, inner.0)]
    } else {
        &[(Swing::Left, -inner.0, inner.0)]
    };
    for (at, y0, y1) in halves {
        let (low, high) = ([back, *y0, inner.1], [front, *y1, inner.2]);
        swing(b, *at, low, high, 1.5, |b| sash(b, (low, high), (*at, bars), mat, u));
    }
}

/// A pane in its frame, with glazing bars and a handle at the free edge.
fn sash(b: &mut Build<'_>, (low, high): (P, P), (at, bars): (Swing, (usize, usize)), mat: MaterialId, u: f32) {
    let w = 0.055 * u;
    plate_with_border(b, "sash", low, high, w, mat);
    let middle = f32::midpoint(low[0], high[0]);
    let t = 0.008;
    b.block("pane", [middle - t, low[1] + w, low[2] + w], [middle + t, high[1] - w, high[2] - w], GLASS);
    let bar = 0.011 * u;
    for i in 0..bars.0 {
        let z = low[2] + (high[2] - low[2]) * (i as f32 + 1.0) / (bars.0 as f32 + 1.0);
        b.block("bar", [low[0] + 0.004, low[1] + w, z - bar], [high[0] - 0.004, high[1] - w, z + bar], mat);
    }
    for i in 0..bars.1 {
        let y = low[1] + (high[1] - low[1]) * (i as f32 + 1.0) / (bars.1 as f32 + 1.0);
        b.block("bar", [low[0] + 0.005, y - bar, low[2] + w], [high[0] - 0.005, y + bar, high[2] - w], mat);
    }
    let y = if at == Swing::Left { low[1] + w * 0.5 } else { high[1] - w * 0.5 };
    let z = low[2] + (high[2] - low[2]) * 0.45;
    b.block(
        "plate",
        [high[0] - 0.001, y - 0.013 * u, z - 0.035 * u],
        [high[0] + 0.006, y + 0.013 * u, z + 0.035 * u],
        ALUMINIUM,
    );
    b.rod("neck", [high[0], y, z], [high[0] + 0.036 * u, y, z], 0.007 * u, ALUMINIUM);
    b.block(
        "handle",
        [high[0] + 0.03 * u, y - 0.009 * u, z - 0.11 * u],
        [high[0] + 0.042 * u, y + 0.009 * u, z + 0.01 * u],
        ALUMINIUM,
    );
}

/// A window that lies in a roof: frame, flashing, a sash that swings out.
pub(super) fn roof_window(b: &mut Build<'_>) {
    let u = fit(b, [0.05, 0.25, 0.3]);
    let (x, y, h) = half_dims(b);
    let (wood, skin) = (b.choose(&[PINE, WHITE]), ANTHRACITE);
    let border = 0.05 * u;
    plate_with_border(b, "frame", [-x, -y, 0.0], [x * 0.6, y, h], border, wood);
    plate_with_border(b, "flashing", [x * 0.2, -y + 0.001, 0.001], [x * 0.7, y - 0.001, h - 0.001], border * 0.5, skin);
    // The sash closes on the frame from outside.
    let (low, high) = ([x * 0.6 + 0.001, -y + border * 0.6, border * 0.6], [x, y - border * 0.6, h - border * 0.6]);
    swing(b, Swing::Up, low, high, 0.8, |b| {
        plate_with_border(b, "sash", low, high, border, skin);
        let w = border;
        b.block("pane", [x * 0.7, low[1] + w, low[2] + w], [x * 0.85, high[1] - w, high[2] - w], GLASS);
        b.block("bar", [x * 0.1, -y * 0.4, high[2] - w], [x * 0.62, y * 0.4, high[2] - w * 0.6], ALUMINIUM);
    });
}

/// The displacement of cloth over one pleat, from -1 to 1.
const PLEAT: [f32; 12] = [0.0, 0.5, 0.87, 1.0, 0.87, 0.5, 0.0, -0.5, -0.87, -1.0, -0.87, -0.5];

/// The outline of pleated cloth along Y, `t` thick and `deep` to either side.
pub(in crate::object) fn pleated(y: f32, deep: f32, t: f32, count: usize) -> Vec<(f32, f32)> {
    let steps = count * PLEAT.len();
    let at = |i: usize, side: f32| {
        let wave = PLEAT[i % PLEAT.len()] * (deep - t);
        (wave + side * t, -y + 2.0 * y * i as f32 / steps as f32)
    };
    (0..=steps).map(|i| at(i, 1.0)).chain((0..=steps).rev().map(|i| at(i, -1.0))).collect()
}

/// Pleated cloth below a heading, straight or tied to one side.
pub(super) fn curtain(b: &mut Build<'_>) {
    let u = fit(b, [0.02, 0.15, 0.3]);
    let (x, y, h) = half_dims(b);
    let cloth = b.style.curtain;
    let t = (0.004 * u).min(x * 0.3);
    let count = ((y / b.vary(0.055, 0.085)).round().clamp(2.0, 11.0)) as usize;
    let head = 0.05 * u;
    match b.rng.below(3) {
        0 => {
            // Straight down, with a tape and rings.
            let outline = pleated(y, x, t, count);
            b.prism("cloth", Axis::Z, [0.0; 3], &outline, h - head, cloth);
            let top = pleated(y, x * 0.55, t, count);
            b.prism("heading", Axis::Z, [0.0, 0.0, h - head - 0.004], &top, head + 0.004, cloth);
        }
        1 => {
            // With a hem in another cloth.
            let hem = h * b.vary(0.08, 0.16);
            let (outline, wider) = (pleated(y, x * 0.94, t * 0.9, count), pleated(y, x, t, count));
            b.prism("hem", Axis::Z, [0.0; 3], &wider, hem, b.style.accent);
            b.prism("cloth", Axis::Z, [0.0, 0.0, hem - 0.002], &outline, h - head - hem, cloth);
            for i in 0..=count {
                let cy = (-y + 0.012 * u) + (2.0 * y - 0.024 * u) * i as f32 / count as f32;
                b.block("loop", [-x * 0.3, cy - 0.012 * u, h - head - 0.006], [x * 0.3, cy + 0.012 * u, h], cloth);
            }
        }
        _ => {
            // Tied: wide at the top, gathered at the band, falling to a narrower hem.
            let band = h * b.vary(0.38, 0.46);
            let (side, slim) = (b.choose(&[-1.0, 1.0]), y * 0.36);
            let middle = side * (y - slim);
            tied(b, (y, x, 0.0), (slim, x * 0.8, middle), (band, h), count, cloth);
            tied(b, (slim * 1.0, x, middle), (slim, x * 0.8, middle), (band, 0.0), count, cloth);
            let from = [-x, (middle - slim - 0.002).max(-y), band - 0.03 * u];
            b.rounded_block(
                "tie",
                from,
                [x, (middle + slim + 0.002).min(y), band + 0.03 * u],
                0.012 * u,
                b.style.accent,
            );
        }
    }
}

/// Cloth that narrows from a wide edge at `z.1` to a narrow one at `z.0`, each given by half width,
/// depth and centre.
fn tied(
    b: &mut Build<'_>,
    wide: (f32, f32, f32),
    slim: (f32, f32, f32),
    (z0, z1): (f32, f32),
    count: usize,
    mat: MaterialId,
) {
    let t = 0.003_f32.min(wide.1 * 0.3);
    let outlines = [(slim, z0), (wide, z1)].map(|((y, deep, middle), z)| (pleated(y, deep, t, count), middle, z));
    let n = outlines[0].0.len() as u32;
    let point = |(outline, middle, z): &(Vec<(f32, f32)>, f32, f32)| {
        let (middle, z) = (*middle, *z);
        outline.iter().map(|p| [p.0, p.1 + middle, z]).collect::<Vec<P>>()
    };
    let vertices: Vec<P> = outlines.iter().flat_map(point).collect();
    let half = n / 2;
    let mut triangles = Vec::new();
    let quad = |list: &mut Vec<[u32; 3]>, [a, b, c, d]: [u32; 4]| list.extend([[a, b, c], [a, c, d]]);
    for i in 0..n {
        let k = (i + 1) % n;
        quad(&mut triangles, [i, k, k + n, i + n]);
    }
    for i in 0..half - 1 {
        let k = n - 1 - i;
        quad(&mut triangles, [i + 1, i, k, k - 1]);
        quad(&mut triangles, [i + n, i + 1 + n, k - 1 + n, k + n]);
    }
    // The outline runs up the front and down the back: its normals point outwards if the wide edge
    // is above.
    if z1 < z0 {
        triangles.iter_mut().for_each(|t| t.swap(1, 2));
    }
    b.mesh("cloth", vertices, triangles, mat);
}

/// A rod on brackets with knobs at its ends and rings.
pub(super) fn curtain_rod(b: &mut Build<'_>) {
    let u = fit(b, [0.02, 0.4, 0.015]);
    let (x, y, h) = half_dims(b);
    let mat = b.choose(&[b.style.metal, b.style.wood, IRON, WHITE_METAL]);
    let r = (h * 0.3).min(x * 0.5);
    let (cx, z) = (x - h.min(2.0 * x) / 2.0, h / 2.0);
    let knob = h.min(2.0 * x) / 2.0;
    let end = y - knob * 2.0;
    b.rod("rod", [cx, -end, z], [cx, end, z], r, mat);
    let round = b.rng.chance(0.5);
    for side in [-1.0, 1.0] {
        if round {
            b.ball("knob", [cx, side * (y - knob), z], knob, mat);
        } else {
            let profile = [(knob * 0.6, 0.0), (knob, knob * 0.5), (knob * 0.5, knob * 2.0)];
            b.lathe_along("knob", [cx, side * (end - 0.001), z], [cx, side * y, z], &profile, mat);
        }
        let cy = side * end * 0.92;
        b.rod("bracket", [-x, cy, z], [cx, cy, z], r * 0.6, mat);
        b.rod("rosette", [-x, cy, z], [-x + 0.006 * u, cy, z], h * 0.48, mat);
    }
    for i in 0..5 {
        let cy = end * 0.16 * (i as f32 - 2.0);
        collar(b, "ring", ([cx, cy - 0.003 * u, z], [cx, cy + 0.003 * u, z]), (r * 1.15, (r * 1.5).min(knob)), mat);
    }
}

/// Slats on cords, a roller with cloth, or cloth in folds.
pub(super) fn blinds(b: &mut Build<'_>) {
    let u = fit(b, [0.015, 0.3, 0.4]);
    let (x, y, h) = half_dims(b);
    let cloth = b.style.curtain;
    let box_high = 0.045 * u;
    let top = h - box_high;
    match b.rng.below(3) {
        0 => {
            let mat = b.choose(&[WHITE_METAL, ALUMINIUM, b.style.wood, b.style.joinery]);
            b.block("headrail", [-x, -y, top], [x, y, h], mat);
            let deep = x * 0.9;
            let count = (top / (deep * 1.7)).clamp(6.0, 34.0) as usize;
            let step = (top - 0.03 * u) / count as f32;
            let tilt = step * b.vary(0.1, 0.5);
            let t = (0.003 * u).min(step * 0.2);
            let slat = [(-deep, tilt), (deep, -tilt), (deep, t - tilt), (-deep, t + tilt)];
            for i in 0..count {
                let z = 0.03 * u + step * (i as f32 + 0.5);
                b.prism("slat", Axis::Y, [0.0, -y * 0.99, z], &slat, y * 1.98, mat);
            }
            b.block("bottom_rail", [-deep, -y * 0.99, 0.0], [deep, y * 0.99, 0.018 * u], mat);
            for cy in [-y * 0.7, y * 0.7] {
                b.rod("cord", [0.0, cy, 0.01 * u], [0.0, cy, top + 0.002], 0.0015, WHITE_COTTON);
            }
        }
        1 => {
            let r = x * 0.9;
            b.rod("roller", [0.0, -y * 0.98, h - x], [0.0, y * 0.98, h - x], r, cloth);
            for side in [-1.0_f32, 1.0] {
                let (a, c) = (side * y * 0.97, side * y);
                b.block("bracket", [-x, a.min(c), h - 2.0 * x], [x, a.max(c), h], WHITE_PLASTIC);
            }
            b.block("cloth", [r - 0.004 * u, -y * 0.96, 0.02 * u], [r - 0.002 * u, y * 0.96, h - x], cloth);
            b.block("bottom_rail", [r - 0.012 * u, -y * 0.965, 0.0], [r + 0.001, y * 0.965, 0.022 * u], WHITE_PLASTIC);
            for cx in [r * 0.2, r * 0.5] {
                b.rod("cord", [cx, -y * 0.985, h * 0.35], [cx, -y * 0.985, h - x], 0.0015, WHITE_PLASTIC);
            }
        }
        _ => {
            b.block("headrail", [-x, -y, top], [x, y, h], b.style.joinery);
            let folds = (h / 0.28).round().clamp(2.0, 6.0) as usize;
            let step = top / folds as f32;
            for i in 0..folds {
                let z = step * i as f32;
                let outline = [(-x * 0.4, 0.0), (x, -0.0), (x * 0.8, step * 0.3), (-x * 0.1, step), (-x * 0.4, step)];
                b.prism("fold", Axis::Y, [0.0, -y, z], &outline, 2.0 * y, cloth);
            }
        }
    }
}

/// A box with a curtain of slats between rails; the curtain slides up into the box by half.
pub(super) fn roller_shutter(b: &mut Build<'_>) {
    let u = fit(b, [0.02, 0.3, 0.4]);
    let (x, y, h) = half_dims(b);
    let mat = b.choose(&[WHITE_PLASTIC, GREY_PLASTIC, ALUMINIUM, BROWN_PLASTIC]);
    let head = (h * 0.14).min(0.2);
    // Hollow, so that the slats go up into it.
    let wall = x * 0.15;
    for (from, to) in [([-x, -y], [-x + wall, y]), ([x - wall, -y], [x, y])] {
        b.block("box", [from[0], from[1], h - head], [to[0], to[1], h], mat);
    }
    b.block("box", [-x + wall, -y, h - wall], [x - wall, y, h], mat);
    for (y0, y1) in [(-y, -y + wall), (y - wall, y)] {
        b.block("box", [-x + wall, y0, h - head], [x - wall, y1, h - wall], mat);
    }
    let rail = 0.04 * u;
    let deep = x.min(0.025);
    for cy in [(-y, -y + rail), (y - rail, y)] {
        b.block("rail", [-deep, cy.0, 0.0], [deep, cy.1, h - head], mat);
    }
    let closed = b.vary(0.35, 1.0);
    let drop = (h - head) * closed;
    let slats = (drop / 0.05).clamp(3.0, 30.0) as usize;
    let step = drop / slats as f32;
    let t = deep * 0.3;
    b.jointed(JointKind::Slide, [0.0; 3], [0.0, 0.0, 1.0], (0.0, (head * 0.7).min(drop * 0.5)), |b| {
        for i in 0..slats {
            let z = h - head - step * (i as f32 + 1.0);
            let outline = [(-t, 0.0), (t * 0.6, 0.0), (t, step * 0.3), (t, step * 0.7), (t * 0.6, step), (-t, step)];
            b.prism("slat", Axis::Y, [0.0, -y + rail * 0.9, z], &outline, 2.0 * y - rail * 1.8, mat);
        }
    });
}
