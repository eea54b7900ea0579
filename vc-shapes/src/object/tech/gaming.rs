//! Game controllers.

use vc_graph::portable::Portable;

use super::super::decor::picture::{Canvas, Inks, motif};
use crate::material::*;
use crate::solid::{Axis, Build, MeshBuilder, P, blocks, facing, half_dims, hoop, loft, oval, spline, tube};

/// A gamepad: two grips, sticks, a directional pad and buttons.
pub(super) fn controller(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let body = b.choose(&[BLACK_PLASTIC, WHITE_PLASTIC, BLUE_PLASTIC, RED_PLASTIC, GREY_PLASTIC, PURPLE_PLASTIC]);
    let dark = if body == BLACK_PLASTIC { GREY_PLASTIC } else { BLACK_PLASTIC };
    let stick = h * 0.2;
    let top = h - stick;
    let ring = |t: f32, cx: f32, half: f32, z: f32| {
        oval(Axis::Y, [x * cx, y * t, top * (1.0 - 0.5 * z)], (x * half, top * 0.5 * z), 1, 16)
    };
    let rings = [
        ring(-1.0, 0.35, 0.3, 0.5),
        ring(-0.9, 0.1, 0.72, 0.85),
        ring(-0.72, -0.08, 0.9, 1.0),
        ring(-0.45, -0.25, 0.68, 0.75),
        ring(0.0, -0.3, 0.6, 0.65),
        ring(0.45, -0.25, 0.68, 0.75),
        ring(0.72, -0.08, 0.9, 1.0),
        ring(0.9, 0.1, 0.72, 0.85),
        ring(1.0, 0.35, 0.3, 0.5),
    ];
    loft(b, "body", &rings, body);
    let mut sticks = MeshBuilder::default();
    let r = x * 0.17;
    let crossed = b.rng.chance(0.5);
    let left = if crossed { (-0.25, -0.64) } else { (0.1, -0.34) };
    for (px, py) in [left, (0.1, 0.34)] {
        let at = |z: f32, s: f32| oval(Axis::Z, [x * px, y * py, z], (r * s, r * s), 0, 14);
        sticks.loft(&[at(top * 0.6, 0.6), at(top + stick * 0.5, 0.6), at(top + stick * 0.6, 1.0), at(h, 0.95)]);
    }
    sticks.put(b, "stick", dark);
    let pad = if crossed { (0.1, -0.34) } else { (-0.25, -0.66) };
    let (cx, cy, arm) = (x * pad.0, y * pad.1, x * 0.2);
    let z = (top * 0.8, top + stick * 0.3);
    blocks(
        b,
        "cross",
        &[
            ([cx - arm, cy - arm * 0.33, z.0], [cx + arm, cy + arm * 0.33, z.1]),
            ([cx - arm * 0.33, cy - arm, z.0], [cx + arm * 0.33, cy + arm, z.1 - h * 0.002]),
        ],
        dark,
    );
    let colours = [GREEN_PLASTIC, RED_PLASTIC, BLUE_PLASTIC, YELLOW_PLASTIC];
    for (i, mat) in colours.into_iter().enumerate() {
        let (s, c) = (i as f32 * std::f32::consts::FRAC_PI_2).sine_cosine();
        b.cylinder(
            "button",
            [x * (-0.25 + 0.22 * c), y * (0.66 + 0.15 * s), top * 0.8],
            x * 0.085,
            z.1 - top * 0.8,
            mat,
        );
    }
    let shoulder = [-1.0_f32, 1.0]
        .map(|s| ([-x, s * y * 0.62 - y * 0.18, top * 0.5], [-x * 0.75, s * y * 0.62 + y * 0.18, top * 0.9]));
    blocks(b, "trigger", &shoulder, dark);
    b.block("light", [-x * 0.5, -y * 0.08, top * 0.8], [-x * 0.35, y * 0.08, top + stick * 0.08], PICTURE_SKY);
}

/// A handheld console: a screen between sticks and buttons.
pub(super) fn handheld(b: &mut Build<'_>) {
    facing(b, |b, t, w, h| {
        let (x, y) = (t / 2.0, w / 2.0);
        let (left, right) = b.choose(&[
            (RED_PLASTIC, BLUE_PLASTIC),
            (BLACK_PLASTIC, BLACK_PLASTIC),
            (WHITE_PLASTIC, WHITE_PLASTIC),
            (YELLOW_PLASTIC, TEAL_CARD),
        ]);
        let face = x - t * 0.3;
        let wing = y * 0.3;
        b.rounded_block("body", [-x, -y + wing, 0.0], [face, y - wing, h], t * 0.1, BLACK_PLASTIC);
        b.rounded_block("grip", [-x, -y, 0.0], [face - t * 0.01, -y + wing + 0.0008, h], t * 0.3, left);
        b.rounded_block("grip", [-x, y - wing - 0.0008, 0.0], [face - t * 0.01, y, h], t * 0.3, right);
        motif(
            b,
            Canvas { half: ((y - wing) * 0.93, h * 0.42), step: (t * 0.04).min(0.0008) },
            [face, 0.0, h * 0.5],
            Inks::screen(),
        );
        for (s, z) in [(-1.0, 0.66), (1.0, 0.36)] {
            let at = [face - 0.001, s * (y - wing * 0.52), h * z];
            b.lathe_along(
                "stick",
                at,
                [at[0] + 1.0, at[1], at[2]],
                &[(wing * 0.2, 0.0), (wing * 0.2, t * 0.2), (wing * 0.28, t * 0.24), (wing * 0.25, t * 0.3)],
                GREY_PLASTIC,
            );
        }
        let dot = wing * 0.1;
        let mut buttons = Vec::new();
        for (s, z) in [(-1.0, 0.34), (1.0, 0.68)] {
            let (cy, cz) = (s * (y - wing * 0.52), h * z);
            for (a, c) in [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)] {
                let (py, pz) = (cy + a * wing * 0.24, cz + c * wing * 0.24);
                buttons.push(([face - t * 0.06, py - dot, pz - dot], [face + t * 0.08, py + dot, pz + dot]));
            }
        }
        blocks(b, "button", &buttons, SCREEN);
    });
}

/// A flight stick on its base, with a throttle and buttons.
pub(super) fn joystick(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let (body, trim) = b.choose(&[
        (BLACK_PLASTIC, RED_PLASTIC),
        (GREY_PLASTIC, ORANGE_PLASTIC),
        (BLACK_PLASTIC, BLUE_PLASTIC),
        (ANTHRACITE, YELLOW_PLASTIC),
    ]);
    let base = h * 0.24;
    let square = b.rng.below(3);
    let ring = |z: f32, s: f32| oval(Axis::Z, [0.0, 0.0, z], (x * s, y * s), square, 24);
    loft(b, "base", &[ring(0.0, 1.0), ring(base * 0.4, 1.0), ring(base, 0.8)], body);
    b.lathe(
        "boot",
        [0.0, 0.0, base * 0.95],
        &[(x.min(y) * 0.5, 0.0), (x.min(y) * 0.38, h * 0.05), (x.min(y) * 0.42, h * 0.07), (x.min(y) * 0.2, h * 0.14)],
        RUBBER,
    );
    let lean = x * b.vary(0.0, 0.15);
    let r = x.min(y) * 0.24;
    let grip = |z: f32, s: f32, o: f32| {
        oval(Axis::Z, [lean * z - r * 0.2 + r * o, 0.0, base + (h - base) * z], (r * s, r * s * 0.85), 0, 14)
    };
    let rings = [
        grip(0.12, 0.55, 0.0),
        grip(0.25, 0.9, 0.1),
        grip(0.4, 0.75, 0.2),
        grip(0.55, 0.85, 0.0),
        grip(0.7, 0.72, 0.1),
        grip(0.82, 0.95, 0.0),
        grip(0.95, 0.95, 0.1),
        grip(1.0, 0.6, 0.1),
    ];
    loft(b, "grip", &rings, body);
    let high = base + (h - base) * 0.86;
    b.rod(
        "trigger",
        [lean * 0.7 - r * 0.5, 0.0, high - h * 0.12],
        [lean * 0.7 - r * 1.25, 0.0, high - h * 0.14],
        r * 0.3,
        trim,
    );
    let mut buttons = MeshBuilder::default();
    for side in [-0.5, 0.5] {
        buttons.egg([lean + r * 0.75, r * side, high], [r * 0.25, r * 0.25, r * 0.25]);
    }
    for i in 0..4 {
        let (px, py) = (x * 0.62, y * (-0.45 + 0.3 * i as f32));
        buttons.egg([px, py, base * 0.8], [x * 0.08, x * 0.08, base * 0.2]);
    }
    buttons.put(b, "button", trim);
    b.block("throttle", [-x * 0.1, -y * 0.78, base * 0.7], [x * 0.15, -y * 0.62, base * 1.25], trim);
}

/// A racing wheel clamped to a desk's edge.
pub(super) fn racing_wheel(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let trim = b.choose(&[RED_PLASTIC, BLUE_PLASTIC, GREY_PLASTIC]);
    let base = h * 0.42;
    b.rounded_block("base", [-x, -y * 0.55, 0.0], [x * 0.35, y * 0.55, base], h * 0.05, BLACK_PLASTIC);
    let thick = (y * 0.09).min(x * 0.14);
    let r = (y.min(h / 2.0)) - thick;
    let at = [x - thick, 0.0, h - r - thick];
    b.rod("shaft", [x * 0.2, 0.0, base * 0.85], [at[0], 0.0, at[2]], thick * 0.8, STEEL);
    hoop(b, "rim", &oval(Axis::X, at, (r, r), 0, 32), thick, BLACK_LEATHER);
    let hub = r * 0.32;
    b.rod("hub", [at[0] - thick * 0.7, 0.0, at[2]], [at[0] + thick * 0.7, 0.0, at[2]], hub, BLACK_PLASTIC);
    let spoke = |y0: f32, y1: f32, z0: f32, z1: f32| {
        ([at[0] - thick * 0.3, r * y0, at[2] + r * z0], [at[0] + thick * 0.3, r * y1, at[2] + r * z1])
    };
    blocks(
        b,
        "spoke",
        &[spoke(-0.95, -0.2, -0.1, 0.1), spoke(0.2, 0.95, -0.1, 0.1), spoke(-0.12, 0.12, -0.95, -0.2)],
        SILVER_METAL,
    );
    let dots: Vec<(P, P)> = [-0.45, -0.6, 0.45, 0.6]
        .map(|s| {
            ([at[0], r * s - r * 0.05, at[2] - r * 0.05], [at[0] + thick * 0.5, r * s + r * 0.05, at[2] + r * 0.05])
        })
        .to_vec();
    blocks(b, "button", &dots, trim);
    b.block(
        "mark",
        [at[0], -r * 0.04, at[2] + r - thick * 0.4],
        [at[0] + thick * 0.95, r * 0.04, at[2] + r + thick * 0.4],
        trim,
    );
}

/// A headset for virtual reality: visor, face cushion, strap.
pub(super) fn virtual_headset(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let body = b.choose(&[WHITE_PLASTIC, BLACK_PLASTIC, GREY_PLASTIC]);
    let deep = x.min(0.11_f32.max(x * 0.6));
    let (back, tall) = (x - deep, h * 0.62);
    b.rounded_block(
        "visor",
        [back + deep * 0.25, -y * 0.96, 0.0],
        [x, y * 0.96, tall],
        (tall * 0.3).min(deep * 0.2),
        body,
    );
    b.block("plate", [x - deep * 0.1, -y * 0.6, tall * 0.25], [x + 0.0006, y * 0.6, tall * 0.75], BLACK_GLASS);
    b.rounded_block(
        "cushion",
        [back, -y * 0.85, tall * 0.01],
        [back + deep * 0.35, y * 0.85, tall * 0.95],
        tall * 0.25,
        BLACK_FABRIC,
    );
    for s in [-0.38, 0.38] {
        b.rod(
            "lens",
            [back - 0.001, y * s, tall * 0.5],
            [back + deep * 0.1, y * s, tall * 0.5],
            tall * 0.2,
            BLACK_GLASS,
        );
    }
    let r = (h * 0.05).min(x * 0.08);
    let side = y - r * 1.6;
    let strap = [
        [x - deep * 0.6, -side, tall * 0.55],
        [back, -side, tall * 0.6],
        [-x * 0.6, -side * 0.85, tall * 0.5],
        [-x + r, 0.0, tall * 0.42],
        [-x * 0.6, side * 0.85, tall * 0.5],
        [back, side, tall * 0.6],
        [x - deep * 0.6, side, tall * 0.55],
    ];
    let over = [
        [x - deep * 0.5, 0.0, tall * 0.95],
        [back * 0.5, 0.0, h - r * 1.7],
        [-x * 0.55, 0.0, h * 0.83],
        [-x + r, 0.0, tall * 0.45],
    ];
    tube(b, "strap", &spline(&strap, 4), r, BLACK_FABRIC);
    tube(b, "strap", &spline(&over, 4), r * 0.9, BLACK_FABRIC);
    let dots: Vec<(P, P)> = [(-0.75, 0.85), (0.75, 0.85), (-0.75, 0.12), (0.75, 0.12)]
        .map(|(a, c)| {
            (
                [x - deep * 0.15, y * a - y * 0.05, tall * c - y * 0.04],
                [x + h * 0.002, y * a + y * 0.05, tall * c + y * 0.04],
            )
        })
        .to_vec();
    blocks(b, "sensor", &dots, SCREEN);
}
