//! Signs, signals and posters.

use std::f32::consts::{FRAC_PI_2, FRAC_PI_4, PI, TAU};

use vc_graph::portable::Portable;

use crate::material::*;
use crate::solid::{Axis, Build, P, at_least, polygon, spaced};

/// The drawing on a sign: rectangles (left, low, right, high) in a square from -1 to 1, seen from
/// the front with Y to the right.
type Drawing = &'static [[f32; 4]];

const ARROW_UP: Drawing =
    &[[-0.12, -0.7, 0.12, 0.3], [-0.45, 0.2, 0.45, 0.36], [-0.25, 0.36, 0.25, 0.55], [-0.1, 0.55, 0.1, 0.75]];
const ARROW_RIGHT: Drawing =
    &[[-0.7, -0.12, 0.3, 0.12], [0.2, -0.45, 0.36, 0.45], [0.36, -0.25, 0.55, 0.25], [0.55, -0.1, 0.75, 0.1]];
const BAR: Drawing = &[[-0.75, -0.17, 0.75, 0.17]];
const EXCLAIM: Drawing = &[[-0.11, -0.15, 0.11, 0.55], [-0.11, -0.45, 0.11, -0.25]];
const LETTER_P: Drawing =
    &[[-0.4, -0.7, -0.12, 0.7], [-0.12, 0.45, 0.4, 0.7], [0.15, 0.0, 0.4, 0.45], [-0.12, -0.15, 0.4, 0.1]];
const LETTER_H: Drawing = &[[-0.5, -0.7, -0.22, 0.7], [0.22, -0.7, 0.5, 0.7], [-0.22, -0.14, 0.22, 0.14]];
const STOP: Drawing = &[
    [-0.72, -0.25, -0.44, 0.25],
    [-0.34, 0.12, -0.04, 0.25],
    [-0.25, -0.25, -0.13, 0.12],
    [0.04, -0.25, 0.34, 0.25],
    [0.44, -0.25, 0.54, 0.25],
    [0.54, -0.02, 0.74, 0.25],
];
const THIRTY: Drawing = &[
    [-0.55, 0.32, -0.1, 0.45],
    [-0.22, -0.45, -0.1, 0.32],
    [-0.45, -0.06, -0.22, 0.06],
    [-0.55, -0.45, -0.22, -0.32],
    [0.1, -0.45, 0.22, 0.45],
    [0.43, -0.45, 0.55, 0.45],
    [0.22, 0.32, 0.43, 0.45],
    [0.22, -0.45, 0.43, -0.32],
];
const FIFTY: Drawing = &[
    [-0.55, 0.32, -0.1, 0.45],
    [-0.55, 0.06, -0.43, 0.32],
    [-0.55, -0.06, -0.1, 0.06],
    [-0.22, -0.45, -0.1, -0.06],
    [-0.55, -0.45, -0.22, -0.32],
    [0.1, -0.45, 0.22, 0.45],
    [0.43, -0.45, 0.55, 0.45],
    [0.22, 0.32, 0.43, 0.45],
    [0.22, -0.45, 0.43, -0.32],
];
const WALKER: Drawing = &[
    [-0.1, 0.42, 0.12, 0.64],
    [-0.14, -0.1, 0.14, 0.38],
    [-0.34, -0.02, -0.18, 0.34],
    [0.18, -0.02, 0.34, 0.34],
    [-0.16, -0.6, -0.02, -0.1],
    [0.06, -0.6, 0.2, -0.1],
];
const BIKE: Drawing = &[
    [-0.6, -0.5, -0.2, -0.1],
    [0.2, -0.5, 0.6, -0.1],
    [-0.4, -0.02, 0.4, 0.1],
    [-0.32, 0.1, -0.22, 0.35],
    [0.28, 0.1, 0.38, 0.45],
];
const CROSSING: Drawing =
    &[[-0.6, -0.4, -0.45, 0.3], [-0.25, -0.4, -0.1, 0.3], [0.1, -0.4, 0.25, 0.3], [0.45, -0.4, 0.6, 0.3]];
const WAVES: Drawing = &[[-0.5, -0.4, 0.5, -0.24], [-0.35, -0.14, 0.35, 0.0], [-0.2, 0.1, 0.2, 0.24]];
const TEXT: Drawing = &[[-0.8, 0.2, 0.5, 0.45], [-0.8, -0.2, 0.75, 0.02], [-0.8, -0.6, 0.2, -0.38]];
const TWO_CARS: Drawing =
    &[[-0.55, -0.25, -0.1, 0.2], [0.1, -0.25, 0.55, 0.2], [-0.45, 0.2, -0.2, 0.35], [0.2, 0.2, 0.45, 0.35]];
const TEE: Drawing = &[[-0.55, 0.3, 0.55, 0.55], [-0.13, -0.7, 0.13, 0.3]];

/// A plate shape and its drawings: number of corners, rotation, stretch (width, height), colours of
/// rim, face and drawing, and the drawings.
struct Plate {
    corners: usize,
    turn: f32,
    stretch: (f32, f32),
    rim: MaterialId,
    face: MaterialId,
    ink: MaterialId,
    drawings: &'static [Drawing],
    /// Scale and offset that fit the drawing into the shape.
    inset: (f32, f32),
}

const fn face(
    corners: usize,
    turn: f32,
    rim: MaterialId,
    face: MaterialId,
    ink: MaterialId,
    drawings: &'static [Drawing],
) -> Plate {
    Plate { corners, turn, stretch: (1.0, 1.0), rim, face, ink, drawings, inset: (0.7, 0.0) }
}

const PLATES: &[Plate] = &[
    Plate {
        inset: (0.55, -0.12),
        ..face(3, FRAC_PI_2, RED, WHITE, BLACK, &[EXCLAIM, WALKER, BIKE, TEE, ARROW_UP, WAVES, CROSSING])
    },
    Plate { inset: (0.45, 0.15), ..face(3, -FRAC_PI_2, RED, WHITE, WHITE, &[BAR]) },
    Plate { inset: (0.85, 0.0), ..face(8, FRAC_PI_4 / 2.0, WHITE, RED, WHITE, &[STOP]) },
    face(24, 0.0, RED, WHITE, BLACK, &[THIRTY, FIFTY, BIKE, WALKER, TWO_CARS, ARROW_RIGHT]),
    Plate { inset: (0.9, 0.0), ..face(24, 0.0, WHITE, RED, WHITE, &[BAR]) },
    face(24, 0.0, WHITE, BLUE, WHITE, &[ARROW_UP, ARROW_RIGHT, WALKER, BIKE]),
    Plate {
        inset: (0.95, 0.0),
        stretch: (1.3, 1.3),
        ..face(4, FRAC_PI_4, WHITE, BLUE, WHITE, &[LETTER_P, LETTER_H, WALKER, CROSSING])
    },
    Plate { inset: (0.6, 0.0), ..face(4, 0.0, WHITE, YELLOW, BLACK, &[TEE, ARROW_RIGHT, BIKE]) },
    Plate { stretch: (1.38, 0.62), ..face(4, FRAC_PI_4, WHITE, GREEN, WHITE, &[TEXT, ARROW_RIGHT]) },
    Plate { stretch: (1.38, 0.9), ..face(4, FRAC_PI_4, BLACK, YELLOW, BLACK, &[TEXT, ARROW_RIGHT, WALKER]) },
    Plate { stretch: (1.38, 0.5), ..face(4, FRAC_PI_4, WHITE, NAVY, WHITE, &[TEXT]) },
];

/// A traffic sign: one or two plates on a post.
pub(super) fn traffic_sign(b: &mut Build<'_>) {
    at_least(b, [0.03, 0.2, 0.8]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let post = (x * 0.55).min(0.04);
    let metal = b.choose(&[GALVANISED, GALVANISED, GREY, ANTHRACITE]);
    let base = -x + post;
    b.cylinder("post", [base, 0.0, 0.0], post, h - 0.03, metal);
    b.cylinder("foot", [base, 0.0, 0.0], post * 1.0001 + 0.001, 0.1, metal);
    let kind = &PLATES[b.rng.below(PLATES.len())];
    let (ry, rz) = spread(kind);
    let half = (y / ry).min(h * 0.22 / rz);
    let centre = h - half * reach(kind);
    plate(b, kind, half, [base + post * 0.9, 0.0, centre], x - post * 0.9 - base);
    let below = centre - half * rz - 0.03;
    if b.rng.chance(0.35) {
        let (wide, tall) = (half * ry.min(1.0) * 0.85, half * b.vary(0.22, 0.4));
        let (x0, thick) = (base + post * 0.9, x - post * 0.9 - base);
        let low = [x0, -wide, below - 2.0 * tall];
        b.block("plate", low, [x0 + thick * 0.6, wide, below], WHITE);
        draw(b, TEXT, [x0 + thick * 0.6, 0.0, below - tall], (wide * 0.9, tall * 0.9), thick * 0.15, BLACK);
    }
}

/// Half width and height of a plate of unit radius.
fn spread(kind: &Plate) -> (f32, f32) {
    let corners = polygon(kind.corners, 1.0, kind.turn);
    let most = |f: fn(&(f32, f32)) -> f32| corners.iter().map(f).fold(0.0, f32::max);
    (most(|p| p.0.abs()) * kind.stretch.0, most(|p| p.1.abs()) * kind.stretch.1)
}

/// The upward extent of a plate of unit radius.
fn reach(kind: &Plate) -> f32 {
    polygon(kind.corners, 1.0, kind.turn).iter().map(|p| p.1).fold(0.0, f32::max) * kind.stretch.1
}

/// A plate: rim, face and drawing, one in front of the other.
fn plate(b: &mut Build<'_>, kind: &Plate, half: f32, at: P, thick: f32) {
    let outline = |share: f32| -> Vec<(f32, f32)> {
        let corners = polygon(kind.corners, half * share, kind.turn);
        corners.into_iter().map(|(y, z)| (y * kind.stretch.0, z * kind.stretch.1)).collect()
    };
    b.prism("plate", Axis::X, at, &outline(1.0), thick * 0.5, kind.rim);
    let share = if kind.corners == 3 || kind.rim == RED { 0.8 } else { 0.93 };
    b.prism("face", Axis::X, [at[0] + thick * 0.45, at[1], at[2]], &outline(share), thick * 0.25, kind.face);
    let drawing = b.one_of(kind.drawings);
    let size = (half * kind.inset.0 * kind.stretch.0.min(1.0), half * kind.inset.0 * kind.stretch.1.min(1.0));
    let centre = [at[0] + thick * 0.7, at[1], at[2] + kind.inset.1 * half];
    draw(b, drawing, centre, size, thick * 0.3, kind.ink);
}

/// A drawing made of raised bars.
fn draw(b: &mut Build<'_>, drawing: Drawing, at: P, size: (f32, f32), thick: f32, ink: MaterialId) {
    for (i, [l, lo, r, hi]) in drawing.iter().enumerate() {
        // Neighbouring bars differ in thickness because they may overlap.
        let deep = thick * (0.75 + 0.08 * (i % 4) as f32);
        // Seen from the front, Y runs to the right.
        let (low, high) =
            ([at[0], at[1] + l * size.0, at[2] + lo * size.1], [at[0] + deep, at[1] + r * size.0, at[2] + hi * size.1]);
        b.block("drawing", low, high, ink);
    }
}

/// A traffic light: one or two heads of three lamps, or two heads for pedestrians.
pub(super) fn traffic_light(b: &mut Build<'_>) {
    at_least(b, [0.15, 0.15, 1.4]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let mast = (x * 0.3).min(0.07);
    let metal = b.choose(&[GALVANISED, ANTHRACITE, GREEN_METAL, YELLOW_METAL]);
    let case = b.choose(&[BLACK_PLASTIC, BLACK_PLASTIC, GREEN_METAL, YELLOW_METAL]);
    let back = -x + mast;
    b.lathe(
        "mast",
        [back, 0.0, 0.0],
        &[(mast, 0.0), (mast, h * 0.12), (mast * 0.7, h * 0.14), (mast * 0.6, h * 0.98)],
        metal,
    );
    let tall = (h * 0.27).clamp(0.6, 1.0);
    head(b, [back + mast * 0.5, 0.0, h - tall], (x - back - mast * 0.5, y), tall, 3, case);
    if b.rng.chance(0.5) {
        let low = (h * 0.6).min(h - tall - 0.55).max(h * 0.4);
        head(b, [back + mast * 0.5, 0.0, low], ((x - back - mast * 0.5) * 0.9, y * 0.8), tall * 0.55, 2, case);
    }
    let z = (h * 0.35).min(1.1);
    b.rounded_block(
        "button",
        [back + mast * 0.5, -0.05, z - 0.08],
        [(back + mast + 0.05).min(x), 0.05, z + 0.08],
        0.01,
        YELLOW_PLASTIC,
    );
}

/// A signal head standing on a point at its back: depth, half width, height.
fn head(b: &mut Build<'_>, at: P, (deep, half): (f32, f32), tall: f32, lamps: usize, case: MaterialId) {
    let body = deep * 0.5;
    let half = half.min(tall / lamps as f32 * 0.62);
    b.rounded_block("case", [at[0], -half, at[2]], [at[0] + body, half, at[2] + tall], 0.02, case);
    let pitch = tall / lamps as f32;
    let r = (pitch * 0.38).min(half * 0.72);
    let mats = if lamps == 3 { vec![SIGNAL_GREEN, SIGNAL_AMBER, SIGNAL_RED] } else { vec![SIGNAL_GREEN, SIGNAL_RED] };
    for (i, mat) in mats.into_iter().enumerate() {
        let z = at[2] + pitch * (i as f32 + 0.5);
        let x0 = at[0] + body;
        b.lathe_along("lamp", [x0 - 0.005, 0.0, z], [x0 + 1.0, 0.0, z], &[(r, 0.0), (r, 0.012), (r * 0.6, 0.025)], mat);
        // A visor over each lamp: the upper part of a tube.
        let arc = |radius: f32| {
            (0..=8).map(move |k| (PI * (k as f32 / 8.0), radius)).map(|(a, r)| (r * a.cosine(), r * a.sine()))
        };
        let outline: Vec<(f32, f32)> =
            arc(r * 1.2).chain(arc(r * 1.08).collect::<Vec<_>>().into_iter().rev()).collect();
        b.prism("visor", Axis::X, [x0 - 0.004, 0.0, z], &outline, deep * 0.5, case);
    }
}

/// A billboard: a framed poster on one or two legs, or standing on the ground.
pub(super) fn billboard(b: &mut Build<'_>) {
    at_least(b, [0.07, 0.8, 1.0]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let panel = (2.0 * y * b.vary(0.4, 0.75)).min(h * 0.68);
    let (low, frame) = (h - panel, b.choose(&[ANTHRACITE, IRON, GALVANISED, WHITE_METAL]));
    let legs = b.rng.count(1, 3);
    let reach = if legs == 1 { 0.0 } else { y * b.vary(0.55, 0.8) };
    let r = x * if legs == 1 { 0.8 } else { 0.4 };
    for cy in spaced(legs, -reach, reach) {
        if b.rng.chance(0.5) {
            b.cylinder("leg", [-x + r, cy, 0.0], r, h * 0.97, frame);
        } else {
            b.block("leg", [-x, cy - r, 0.0], [-x + 2.0 * r, cy + r, h * 0.97], frame);
        }
        b.block("foot", [-x, cy - r.max(0.1), 0.0], [x, cy + r.max(0.1), 0.06], CONCRETE);
    }
    b.block("panel", [(2.0 * r - x - 0.005).min(x * 0.1), -y, low], [x * 0.8, y, h], frame);
    let edge = 0.05;
    poster(b, [x * 0.8, 0.0, (low + h) / 2.0], (y - edge, panel / 2.0 - edge), x * 0.18);
    if b.rng.chance(0.4) {
        for cy in spaced(3, -y * 0.7, y * 0.7) {
            b.rod("lamp", [x * 0.5, cy, low - 0.12], [x * 0.9, cy, low - 0.12], 0.03, frame);
            b.rod("arm", [x * 0.5, cy, low - 0.14], [x * 0.5, cy, low + 0.02], 0.015, frame);
        }
    }
}

/// A picture of simple areas, centred at a point of a plane, with half width and half height.
pub(super) fn poster(b: &mut Build<'_>, at: P, half: (f32, f32), thick: f32) {
    let sky = b.choose(&[SKY, MUSTARD, DUSTY_ROSE, NAVY, CREAM, TERRACOTTA]);
    let land = b.choose(&[FOREST, SAGE, RED, BLUE, BLACK, WHITE]);
    let ink = b.choose(&[WHITE, YELLOW, BLACK, RED]);
    let step = thick / 4.0;
    let [x, y, z] = at;
    b.block("poster", [x - 0.002, y - half.0, z - half.1], [x + step, y + half.0, z + half.1], sky);
    let horizon = half.1 * b.vary(-0.6, 0.0);
    let hill = half.1 * b.vary(0.1, 0.5);
    let peak = half.0 * b.vary(-0.6, 0.6);
    let ground = -half.1 * 0.995;
    let outline = [
        (-half.0 * 0.995, ground),
        (half.0 * 0.995, ground),
        (half.0 * 0.995, horizon),
        (peak, hill),
        (-half.0 * 0.995, horizon),
    ];
    b.prism("poster", Axis::X, [x, y, z], &outline, step * 2.0, land);
    let (r, side) = (half.0.min(half.1) * b.vary(0.18, 0.4), half.0 * b.vary(-0.5, 0.5));
    b.prism("poster", Axis::X, [x, y + side, z + half.1 * 0.45], &polygon(18, r, TAU / 36.0), step * 1.5, ink);
    let lines = b.rng.count(1, 3);
    for i in 0..lines {
        let (wide, cz) = (half.0 * b.vary(0.3, 0.8), z - half.1 * (0.35 + 0.22 * i as f32));
        b.block("poster", [x, y - wide, cz - half.1 * 0.07], [x + step * 3.0, y + wide, cz + half.1 * 0.07], ink);
    }
}
