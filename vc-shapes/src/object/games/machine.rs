//! Arcade machines.

use std::f32::consts::PI;

use crate::material::*;
use crate::object::palette::{BRIGHT, PAINTS};
use crate::solid;
use crate::solid::{Axis, Build, CORNERS, P, Proportional, SIDES, arc_outline};

/// A picture on a slanted screen (sky, ground and figures), on the plane through a lower and an
/// upper line.
fn scene(b: &mut Build<'_>, low: P, high: P, half: f32) {
    let lift = |t: f32, out: f32| -> (f32, f32) {
        let (x, z) = (low[0] + (high[0] - low[0]) * t, low[2] + (high[2] - low[2]) * t);
        (x + out, z + out * 0.3)
    };
    let mut band = |name: &str, y: (f32, f32), t: (f32, f32), out: f32, mat: MaterialId| {
        let outline = [lift(t.0, -0.02), lift(t.1, -0.02), lift(t.1, out), lift(t.0, out)];
        b.side_outline(name, y, &outline, mat);
    };
    band("screen", (-half, half), (0.0, 1.0), 0.006, SCREEN);
    band("picture", (-half * 0.88, half * 0.88), (0.08, 0.92), 0.012, PICTURE_DARK);
    band("ground", (-half * 0.86, half * 0.86), (0.1, 0.25), 0.018, PICTURE_LAND);
    for (i, mat) in [PICTURE_SUN, SIGNAL_RED, PICTURE_SKY, SIGNAL_GREEN].into_iter().enumerate() {
        let at = half * (-0.6 + 0.4 * i as f32);
        band("figure", (at - half * 0.1, at + half * 0.1), (0.62 - 0.1 * (i % 2) as f32, 0.72), 0.018, mat);
    }
}

/// An arcade cabinet with side panels, a slanted screen, a lit sign, a stick and buttons.
pub(super) fn arcade(b: &mut Build<'_>) {
    let side = b.choose(&[BLACK, NAVY, RED, BLUE, ANTHRACITE, YELLOW]);
    let art = b.one_of(PAINTS);
    let body = b.choose(&[BLACK, ANTHRACITE]);
    let desk = b.vary(0.48, 0.53);
    let neck = b.vary(0.1, 0.3);
    let head = b.vary(0.45, 0.7);
    let kick = b.vary(0.75, 0.9);
    let panel = [
        (-1.0, 0.0),
        (kick, 0.0),
        (kick, desk - 0.06),
        (1.0, desk - 0.03),
        (1.0, desk + 0.02),
        (neck + 0.2, desk + 0.07),
        (neck, 0.83),
        (head, 0.88),
        (head, 1.0),
        (-1.0, 1.0),
    ];
    for s in SIDES {
        let (y0, y1) = ((0.93 * s).min(0.985 * s), (0.93 * s).max(0.985 * s));
        b.side_outline("side", (y0, y1), &panel, side);
        let (a, c) = ((0.98 * s).min(s), (0.98 * s).max(s));
        b.side_outline("art", (a, c), &[(-0.8, 0.3), (0.3, 0.3), (-0.1, 0.62), (-0.4, 0.75), (-0.8, 0.8)], art);
    }
    let (front, deck) = (kick - 0.04, desk + 0.005);
    let inner = [
        (-0.98, 0.004),
        (front, 0.004),
        (front, desk - 0.06),
        (0.96, desk - 0.03),
        (0.96, deck),
        (neck + 0.14, desk + 0.05),
        (neck - 0.06, 0.82),
        (head - 0.05, 0.89),
        (head - 0.05, 0.992),
        (-0.98, 0.992),
    ];
    b.side_outline("body", (-0.935, 0.935), &inner, body);
    scene(b, [neck + 0.12, 0.0, desk + 0.075], [neck - 0.04, 0.0, 0.805], 0.88);
    let sign = b.choose(&[PICTURE_SUN, PICTURE_SKY, SIGNAL_AMBER]);
    b.slab("sign", [head - 0.1, -0.92, 0.905], [head - 0.03, 0.92, 0.985], sign);
    b.slab("title", [head - 0.1, -0.6, 0.93], [head - 0.015, 0.6, 0.96], art);
    b.slab("coin_door", [front - 0.05, -0.4, 0.12], [front + 0.02, 0.4, 0.34], GREY);
    for s in SIDES {
        b.slab("slot", [front, 0.18 * s - 0.06, 0.24], [front + 0.035, 0.18 * s + 0.06, 0.3], SIGNAL_AMBER);
    }
    controls(b, [0.62, deck + 0.012], 0.5, b.class.len() % 2);
}

/// Joysticks and buttons on a control panel at (x, z).
fn controls(b: &mut Build<'_>, at: [f32; 2], apart: f32, first: usize) {
    for (i, s) in SIDES.into_iter().enumerate() {
        let mat = BRIGHT[(i * 3 + first) % BRIGHT.len()];
        let stick = b.p([at[0], s * apart - 0.12, at[1]]);
        let foot = [stick[0], stick[1], stick[2] - 0.03];
        b.rod("stick", foot, [stick[0], stick[1], stick[2] + 0.05], 0.006, CHROME);
        b.ball("knob", [stick[0], stick[1], stick[2] + 0.055], 0.016, mat);
        for k in 0..4 {
            let button = b.p([at[0] + 0.1 * (k % 2) as f32 - 0.05, s * apart + 0.1 + 0.1 * (k / 2) as f32, at[1]]);
            b.cylinder("button", [button[0], button[1], button[2] - 0.025], 0.012, 0.034, mat);
        }
    }
}

/// A pinball machine: a sloping playfield on legs and a lit head.
pub(super) fn pinball(b: &mut Build<'_>) {
    let case = b.choose(&[BLACK, NAVY, RED, BLUE, WALNUT]);
    let metal = b.choose(&[CHROME, BRASS, BLACK_METAL]);
    let field = b.choose(&[PICTURE_DARK, PICTURE_LAND, PICTURE_SKY]);
    let (front, back) = (b.vary(0.49, 0.52), b.vary(0.56, 0.6));
    b.side_outline(
        "case",
        (-0.92, 0.92),
        &[(-0.95, 0.4), (0.96, 0.36), (0.96, front - 0.02), (-0.95, back - 0.02)],
        case,
    );
    for s in SIDES {
        let (y0, y1) = ((0.88 * s).min(0.96 * s), (0.88 * s).max(0.96 * s));
        b.side_outline(
            "rail",
            (y0, y1),
            &[(-0.6, back - 0.06), (0.97, front - 0.06), (0.97, front), (-0.6, back - 0.012)],
            metal,
        );
    }
    b.slab("bar", [0.93, -0.97, front - 0.07], [1.0, 0.97, front + 0.004], metal);
    let z = |x: f32| front - 0.02 + (back - front) * (0.96 - x) / 1.91;
    b.side_outline(
        "field",
        (-0.86, 0.86),
        &[(-0.5, z(-0.5) - 0.01), (0.9, z(0.9) - 0.01), (0.9, z(0.9) + 0.003), (-0.5, z(-0.5) + 0.003)],
        field,
    );
    for (i, (x, y)) in [(-0.2, -0.3), (-0.2, 0.35), (0.05, 0.0), (-0.38, 0.05)].into_iter().enumerate() {
        let [cx, cy, cz] = b.p([x, y, z(x)]);
        b.cylinder("bumper", [cx, cy, cz - 0.01], 0.028, 0.035, BRIGHT[i]);
        b.cylinder("cap", [cx, cy, cz + 0.024], 0.038, 0.008, WHITE_PLASTIC);
    }
    // The heights at which bars lie on the playfield.
    let on = |x: f32, tall: f32| z(x) + 0.002 + tall / 2.0 / b.size.z;
    let (ends, rails) = ([on(0.66, 0.02), on(0.78, 0.02)], [on(0.2, 0.024), on(0.66, 0.024)]);
    for s in SIDES {
        b.plank("flipper", [0.66, 0.35 * s, ends[0]], [0.78, 0.08 * s, ends[1]], (0.02, 0.02), YELLOW_PLASTIC);
        b.plank("guide", [0.2, 0.78 * s, rails[0]], [0.66, 0.42 * s, rails[1]], (0.012, 0.024), metal);
        b.wheel("button", Axis::Y, [0.8, 0.94 * s, front - 0.09], (0.016, 0.04), RED_PLASTIC);
    }
    b.pole("plunger", [0.94, -0.7, front - 0.1], [1.0, -0.7, front - 0.1], 0.012, CHROME);
    b.slab("coin_door", [0.94, -0.3, 0.38], [0.975, 0.3, front - 0.1], GREY);
    for (x, y) in CORNERS {
        let top = if x > 0.0 { front - 0.06 } else { 0.5 };
        b.pole("leg", [0.92 * x, 0.9 * y, 0.0], [0.9 * x, 0.9 * y, top], 0.022, metal);
    }
    b.slab("neck", [-0.94, -0.8, back - 0.05], [-0.62, 0.8, back + 0.04], case);
    b.slab("head", [-1.0, -1.0, back + 0.03], [-0.58, 1.0, 1.0], case);
    b.slab("glass", [-0.62, -0.92, back + 0.11], [-0.57, 0.92, 0.97], PICTURE_DARK);
    b.slab("sky", [-0.6, -0.86, 0.8], [-0.564, 0.86, 0.95], PICTURE_SUN);
    let hero = b.choose(&[SIGNAL_RED, SIGNAL_GREEN, PICTURE_SKY]);
    b.front_outline(
        "hero",
        (-0.6, -0.558),
        &[(-0.4, back + 0.14), (0.4, back + 0.14), (0.15, 0.9), (-0.1, 0.93)],
        hero,
    );
    b.slab("score", [-0.62, -0.7, back + 0.045], [-0.566, 0.7, back + 0.095], SCREEN);
    b.slab("digits", [-0.6, -0.5, back + 0.057], [-0.56, 0.5, back + 0.083], SIGNAL_AMBER);
}

/// A claw machine: a glass case of prizes under a crane.
pub(super) fn claw(b: &mut Build<'_>) {
    let case = b.choose(&[RED, BLUE, YELLOW, DUSTY_ROSE, ORANGE]);
    let trim = b.choose(&[CHROME, WHITE_METAL, BRASS]);
    let desk = b.vary(0.38, 0.44);
    b.slab("base", [-0.9, -0.98, 0.0], [0.9, 0.98, desk], case);
    b.slab("head", [-0.9, -0.98, 0.86], [0.9, 0.98, 1.0], case);
    let sign = b.choose(&[PICTURE_SUN, PICTURE_SKY, SIGNAL_AMBER]);
    b.slab("sign", [0.85, -0.85, 0.885], [0.93, 0.85, 0.975], sign);
    b.slab("back", [-0.89, -0.95, desk - 0.01], [-0.86, 0.95, 0.87], case);
    for (x, y) in CORNERS {
        b.slab("post", [0.83 * x - 0.05, 0.92 * y - 0.05, desk - 0.01], [0.83 * x + 0.05, 0.92 * y + 0.05, 0.87], trim);
    }
    b.slab("glass", [0.82, -0.88, desk - 0.005], [0.84, 0.88, 0.865], GLASS);
    for s in SIDES {
        let (y0, y1) = ((0.91 * s).min(0.93 * s), (0.91 * s).max(0.93 * s));
        b.slab("glass", [-0.8, y0, desk - 0.005], [0.8, y1, 0.865], GLASS);
    }
    b.slab("floor", [-0.85, -0.9, desk - 0.01], [0.81, 0.9, desk + 0.01], WHITE_PLASTIC);
    let colours = [PURPLE_FABRIC, ROSE_FABRIC, MUSTARD_FABRIC, BLUE_FABRIC, GREEN_FABRIC];
    for (i, mat) in colours.into_iter().enumerate() {
        let at = [-0.66, -0.66 + 0.33 * i as f32, desk + 0.055 + 0.01 * (i % 2) as f32];
        let size = [0.15, 0.17, 0.055];
        b.ellipsoid("prize", at, size, mat);
        b.ellipsoid("prize", [at[0] + 0.03, at[1], at[2] + 0.075], [0.1, 0.11, 0.036], mat);
    }
    let drop = b.vary(0.68, 0.76);
    b.slab("beam", [-0.1, -0.9, 0.84], [0.06, 0.9, 0.868], trim);
    b.pole("cable", [-0.02, 0.2, drop + 0.03], [-0.02, 0.2, 0.85], 0.006, STEEL);
    b.slab("crane", [-0.1, 0.12, drop], [0.06, 0.28, drop + 0.04], CHROME);
    for (x, y) in [(0.12, 0.0), (-0.07, 0.11), (-0.07, -0.11)] {
        let knee = [-0.02 + x * 1.3, 0.2 + y * 1.3, drop - 0.035];
        b.bent_rod(
            "claw",
            &[[-0.02 + x * 0.5, 0.2 + y * 0.5, drop + 0.005], knee, [-0.02 + x * 0.4, 0.2 + y * 0.4, drop - 0.075]],
            0.006,
            CHROME,
        );
    }
    b.slab("desk", [0.85, -0.7, desk - 0.1], [1.0, 0.7, desk - 0.05], case);
    let stick = b.p([0.95, -0.3, desk - 0.05]);
    b.rod("stick", [stick[0], stick[1], stick[2] - 0.005], [stick[0], stick[1], stick[2] + 0.07], 0.006, CHROME);
    b.ball("knob", [stick[0], stick[1], stick[2] + 0.07], 0.014, RED_PLASTIC);
    let button = b.p([0.94, 0.3, desk - 0.055]);
    b.cylinder("button", button, 0.018, 0.02, GREEN_PLASTIC);
    b.slab("chute", [0.87, 0.3, 0.1], [0.92, 0.8, 0.24], BLACK_PLASTIC);
    b.inner_floor("prizes", [0.12, 0.0, desk + 0.01], (0.55, 0.8), (drop - 0.1 - desk).max(0.02));
}

/// A jukebox: a round-topped case with glowing tubes and a grille.
pub(super) fn jukebox(b: &mut Build<'_>) {
    let wood = b.choose(&[WALNUT, CHERRY, MAHOGANY, OAK]);
    let glow = b.choose(&[WARM_BULB, SIGNAL_AMBER, PICTURE_SUN, SIGNAL_RED]);
    let second = b.choose(&[SIGNAL_GREEN, PICTURE_SKY, SIGNAL_RED]);
    let spring = b.vary(0.55, 0.68);
    let arch = |half: f32, foot: f32, rise: f32| -> Vec<(f32, f32)> {
        let mut line = vec![(half, foot)];
        line.extend(arc_outline((0.0, spring), (half, rise), (0.0, PI), 13));
        line.push((-half, foot));
        line
    };
    b.front_outline("case", (-1.0, 0.62), &arch(1.0, 0.0, 1.0 - spring), wood);
    b.front_outline("front", (0.6, 0.7), &arch(0.9, 0.03, 0.93 - spring), BLACK);
    for (inset, mat, r) in [(0.93, glow, 0.028), (0.8, second, 0.02)] {
        let rise = (1.0 - spring) * inset - 0.015;
        let line: Vec<P> = arch(inset - 0.04, 0.05, rise).iter().map(|&(y, z)| b.p([0.74, y, z])).collect();
        solid::tube(b, "tube", &line, r * b.size.y, mat);
    }
    b.front_outline("window", (0.68, 0.76), &arch(0.66, spring - 0.02, (1.0 - spring) * 0.72), PICTURE_DARK);
    for (i, mat) in [BLACK_CARD, RED_CARD, BLACK_CARD, YELLOW_CARD, BLACK_CARD].into_iter().enumerate() {
        let y = -0.4 + 0.2 * i as f32;
        b.wheel("record", Axis::X, [0.765, y, spring + 0.1], (b.size.y * 0.07, 0.006 + 0.003 * i as f32), mat);
    }
    b.slab("titles", [0.68, -0.68, spring - 0.13], [0.8, 0.68, spring - 0.02], CREAM_PAPER);
    for i in 0..3 {
        let z = spring - 0.115 + 0.032 * i as f32;
        b.slab("strip", [0.7, -0.62, z], [0.812, 0.62, z + 0.02], if i == 1 { RED_CARD } else { WHITE_PAPER });
    }
    b.slab("keys", [0.68, -0.66, spring - 0.19], [0.92, 0.66, spring - 0.14], CHROME);
    for i in 0..8 {
        let y = -0.55 + 0.155 * i as f32;
        b.slab(
            "key",
            [0.9, y - 0.05, spring - 0.18],
            [0.96, y + 0.05, spring - 0.15],
            if i < 4 { RED_PLASTIC } else { WHITE_PLASTIC },
        );
    }
    let top = spring - 0.22;
    b.slab("grille", [0.66, -0.62, 0.06], [0.76, 0.62, top], BROWN_FABRIC);
    let bars = b.rng.count(4, 7);
    for i in 0..bars {
        let y = -0.52 + 1.04 * i as f32 / (bars - 1) as f32;
        b.slab("bar", [0.74, y - 0.02, 0.05], [0.8, y + 0.02, top + 0.006], BRASS);
    }
    b.slab("plinth", [0.58, -0.94, 0.005], [1.0, 0.94, 0.045], wood);
}
