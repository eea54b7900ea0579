//! Radios, record players and discs.

use super::super::decor::picture::{Canvas, Inks, motif};
use crate::material::*;
use crate::solid::{Axis, Build, MeshBuilder, P, blocks, facing, half_dims, hoop, ngon, oval, spline, tube};

/// A radio or a player with a handle: grilles, dial, knobs, antenna.
pub(super) fn radio(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let wooden = b.rng.chance(0.4) && b.class == "radio";
    let body = if wooden {
        b.style.wood
    } else {
        b.choose(&[RED_PLASTIC, BLACK_PLASTIC, WHITE_PLASTIC, SILVER_METAL, SAGE, SKY])
    };
    if h < 0.05 {
        return portable_player(b, body);
    }
    let (grip, out) = (h * 0.16, (x * 0.16).min(0.014));
    let (top, front) = (h - grip, x - out);
    b.rounded_block("case", [-x, -y, 0.0], [front, y, top], top * 0.15, body);
    let cloth = b.choose(&[BEIGE_FABRIC, BLACK_FABRIC, GREY_FABRIC]);
    let boombox = b.class == "cd_player";
    let r = (top * 0.36).min(y * 0.3);
    let sides: &[f32] = if boombox { &[-1.0, 1.0] } else { &[-1.0] };
    for &s in sides {
        let at = [front, s * (y * 0.93 - r), top * 0.48];
        b.prism("grille", Axis::X, [front - 0.003, at[1], at[2]], &ngon((r, r), 24), 0.0044, cloth);
        hoop(b, "rim", &oval(Axis::X, at, (r, r), 0, 24), out * 0.2, SILVER_METAL);
    }
    let (y0, y1) = if boombox { (-y * 0.93 + 2.2 * r, y * 0.93 - 2.2 * r) } else { (-y * 0.85 + 2.0 * r, y * 0.9) };
    let (mid, half) = ((y0 + y1) / 2.0, ((y1 - y0) / 2.0).max(y * 0.1));
    blocks(
        b,
        "dial",
        &[([front - 0.002, mid - half, top * 0.55], [front + 0.001, mid + half, top * 0.82])],
        CREAM_PAPER,
    );
    blocks(
        b,
        "pointer",
        &[([front, mid + half * 0.2, top * 0.56], [front + 0.0022, mid + half * 0.26, top * 0.81])],
        RED_PLASTIC,
    );
    for s in [-0.6, 0.6] {
        b.rod(
            "knob",
            [front - 0.001, mid + half * s, top * 0.28],
            [x, mid + half * s, top * 0.28],
            (top * 0.13).min(half * 0.35),
            if wooden { BRASS } else { BLACK_PLASTIC },
        );
    }
    let thick = (grip * 0.2).min(x * 0.15);
    let handle = [
        [-x * 0.72, -y * 0.7, top * 0.97],
        [-x * 0.72, -y * 0.6, h - thick * 1.9],
        [-x * 0.72, y * 0.6, h - thick * 1.9],
        [-x * 0.72, y * 0.7, top * 0.97],
    ];
    tube(b, "handle", &spline(&handle, 3), thick, if wooden { BROWN_LEATHER } else { BLACK_PLASTIC });
    if boombox {
        let r = (x * 0.42).min(y * 0.35);
        b.hinge([x * 0.05 - r, 0.0, top], [0.0, -1.0, 0.0], 1.2, |b| {
            b.cylinder("lid", [x * 0.05, 0.0, top * 0.998], r, (grip * 0.35).min(0.02), BLACK_PLASTIC);
        });
    }
}

/// A flat disc player.
fn portable_player(b: &mut Build<'_>, body: MaterialId) {
    let (x, y, h) = half_dims(b);
    let r = x.min(y);
    b.lathe("base", [0.0; 3], &[(r * 0.94, 0.0), (r, h * 0.2), (r, h * 0.6)], BLACK_PLASTIC);
    b.hinge([-r, 0.0, h * 0.6], [0.0, -1.0, 0.0], 1.4, |b| {
        b.lathe("lid", [0.0, 0.0, h * 0.605], &[(r * 0.99, 0.0), (r * 0.97, h * 0.2), (r * 0.85, h * 0.36)], body);
        b.cylinder("window", [0.0, 0.0, h * 0.9], r * 0.4, h * 0.1, SCREEN);
    });
    let keys: Vec<(P, P)> = (0..3)
        .map(|i| -r * 0.3 + r * 0.22 * i as f32)
        .map(|a| ([r * 0.86, a, h * 0.3], [r * 1.0, a + r * 0.14, h * 0.5]))
        .collect();
    blocks(b, "key", &keys, SILVER_METAL);
}

/// A record player: platter, record, arm, and a clear hinged lid.
pub(super) fn turntable(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let body = b.choose(&[b.style.wood, WALNUT, BLACK, WHITE]);
    let foot = h * 0.1;
    let base = h * 0.5;
    let mut feet = MeshBuilder::default();
    for (sx, sy) in [(-0.8, -0.8), (-0.8, 0.8), (0.8, -0.8), (0.8, 0.8)] {
        feet.loft(&[0.0, foot * 1.1].map(|z| oval(Axis::Z, [x * sx, y * sy, z], (x * 0.09, x * 0.09), 0, 12)));
    }
    feet.put(b, "foot", RUBBER);
    b.rounded_block("plinth", [-x, -y, foot], [x, y, base], h * 0.03, body);
    let r = (x * 0.86).min(y * 0.72);
    let at = [0.0, -y + r * 1.12, base];
    b.cylinder("platter", [at[0], at[1], base - 0.001], r, h * 0.08, SILVER_METAL);
    let disc = base + h * 0.08;
    b.cylinder("record", [at[0], at[1], disc - 0.001], r * 0.97, h * 0.02 + 0.001, BLACK_PLASTIC);
    let label = b.choose(&[RED_CARD, BLUE_CARD, YELLOW_CARD, ORANGE_CARD]);
    b.cylinder("label", [at[0], at[1], disc], r * 0.33, h * 0.03, label);
    b.cylinder("spindle", [at[0], at[1], disc], r * 0.03, h * 0.09, STEEL);
    let pivot = [-x * 0.6, y * 0.72, base];
    b.cylinder("pivot", [pivot[0], pivot[1], base - 0.001], y * 0.1, h * 0.12, b.style.metal);
    let high = disc + h * 0.07;
    let arm = [
        [pivot[0] - x * 0.15, pivot[1], high],
        [pivot[0], pivot[1], high],
        [x * 0.35, y * 0.72, high],
        [x * 0.6, at[1] + r * 0.62, high - h * 0.03],
    ];
    tube(b, "arm", &arm, h * 0.025, CHROME);
    b.block("head", [x * 0.55, at[1] + r * 0.55, disc + h * 0.02], [x * 0.7, at[1] + r * 0.68, high], BLACK_PLASTIC);
    b.cylinder("knob", [x * 0.78, y * 0.8, base - 0.001], y * 0.06, h * 0.08, SILVER_METAL);
    let t = (x * 0.015).min(0.004);
    b.hinge([-x, 0.0, base], [0.0, -1.0, 0.0], 1.2, |b| {
        let low = base + h * 0.003;
        b.top("top", [0.0, 0.0, h], (x * 0.9, y * 0.9));
        b.block("lid", [-x, -y, h - t], [x, y, h], CLEAR_PLASTIC);
        let walls = [
            ([-x, -y, low], [x, -y + t, h - t * 1.01]),
            ([-x, y - t, low], [x, y, h - t * 1.01]),
            ([-x, -y + t * 1.01, low], [-x + t, y - t * 1.01, h - t * 1.01]),
            ([x - t, -y + t * 1.01, low], [x, y - t * 1.01, h - t * 1.01]),
        ];
        blocks(b, "lid", &walls, CLEAR_PLASTIC);
    });
}

/// A mixing console: a sloping panel with faders and knobs in rows.
pub(super) fn mixer(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let key = h * 0.12;
    let (low, high) = (h * 0.35, h - key);
    let end = x * 0.985;
    let outline = [(-end, h * 0.03), (end, h * 0.03), (end, low), (-end, high)];
    b.prism("body", Axis::Y, [0.0, -y * 0.96, 0.0], &outline, 1.92 * y, ANTHRACITE);
    let wood = b.choose(&[WALNUT, BLACK_PLASTIC, OAK]);
    for s in [-1.0_f32, 1.0] {
        let (a, c) = (s * y * 0.955, s * y);
        b.prism(
            "side",
            Axis::Y,
            [0.0, a.min(c), 0.0],
            &[(-x, 0.0), (x, 0.0), (x, low + h * 0.06), (-x, high + h * 0.08)],
            (c - a).abs(),
            wood,
        );
    }
    let at = |px: f32| low + (high - low) * (x - px) / (2.0 * x);
    let count = ((2.0 * y / 0.045) as usize).clamp(4, 10);
    let pitch = 1.8 * y / count as f32;
    let (mut faders, mut knobs, mut caps) = (MeshBuilder::default(), MeshBuilder::default(), MeshBuilder::default());
    for i in 0..count {
        let py = -0.9 * y + pitch * (i as f32 + 0.5);
        let (a, c) = (x * 0.3, x * 0.85);
        let outline = [(a, at(a) - key * 0.3), (c, at(c) - key * 0.3), (c, at(c) + key * 0.1), (a, at(a) + key * 0.1)];
        b.prism("slot", Axis::Y, [0.0, py - pitch * 0.06, 0.0], &outline, pitch * 0.12, SCREEN);
        let f = x * b.vary(0.35, 0.75);
        faders.block([f, py - pitch * 0.25, at(f) - key * 0.5], [f + x * 0.1, py + pitch * 0.25, at(f) + key * 0.6]);
        for k in 0..4 {
            let px = x * (-0.8 + 0.27 * k as f32);
            let ring = |z: f32| oval(Axis::Z, [px, py, z], (pitch * 0.25, pitch * 0.25), 0, 10);
            let shell = if k == 0 { &mut caps } else { &mut knobs };
            shell.loft(&[ring(at(px) - key * 0.6), ring(at(px) + key * 0.7)]);
        }
    }
    faders.put(b, "fader", WHITE_PLASTIC);
    knobs.put(b, "knob", GREY_PLASTIC);
    let colour = b.choose(&[RED_PLASTIC, BLUE_PLASTIC, ORANGE_PLASTIC]);
    caps.put(b, "knob", colour);
}

/// A disc's case or a record's sleeve with a printed front.
pub(super) fn sleeve(b: &mut Build<'_>) {
    facing(b, |b, t, w, h| {
        let (x, y) = (t / 2.0, w / 2.0);
        let step = (t * 0.1).min(0.0008);
        let face = x - step * 4.0;
        let record = b.class == "vinyl_record";
        let shell = if record {
            b.choose(&[BLACK_CARD, WHITE_PAPER, RED_CARD])
        } else {
            b.choose(&[BLACK_PLASTIC, BLUE_PLASTIC, GREEN_PLASTIC, RED_PLASTIC])
        };
        b.block("case", [-x, -y, 0.0], [face, y, h], shell);
        let share = if record { 0.995 } else { 0.94 };
        let inks = Inks::printed(b);
        motif(b, Canvas { half: (y * share, h / 2.0 * share), step }, [face, 0.0, h / 2.0], inks);
        let ink = b.choose(&[WHITE_PAPER, BLACK_CARD, YELLOW_CARD]);
        blocks(b, "title", &[([face, -y * 0.77, h * 0.86], [x, y * 0.3, h * 0.92])], ink);
        if record {
            b.rod(
                "record",
                [-x * 0.45, y * 0.02, h * 0.5],
                [-x * 0.1, y * 0.02, h * 0.5],
                (y * 0.98).min(h * 0.499),
                BLACK_PLASTIC,
            );
        }
    });
}

/// A disc, or one in its flat case if thick.
pub(super) fn disc(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let r = x.min(y) * if h > 0.004 { 0.94 } else { 1.0 };
    let low = if h > 0.004 { h * 0.3 } else { 0.0 };
    let hole = r * 0.13;
    let thick = (h - low) * 0.7;
    b.lathe("disc", [0.0, 0.0, low], &[(r, 0.0), (r, thick), (hole, thick), (hole, 0.0), (r, 0.0)], CHROME);
    let label = b.choose(&[RED_CARD, BLUE_CARD, WHITE_PAPER, TEAL_CARD]);
    b.lathe(
        "label",
        [0.0, 0.0, low + thick * 0.5],
        &[(r * 0.75, 0.0), (r * 0.75, thick * 0.9), (r * 0.38, thick * 0.9), (r * 0.38, 0.0), (r * 0.75, 0.0)],
        label,
    );
    if low > 0.0 {
        b.block("case", [-x, -y, 0.0], [x, y, low * 0.95], CLEAR_PLASTIC);
        b.block("spine", [-x, -y, low * 0.9], [x, -y * 0.95, h], BLACK_PLASTIC);
        b.cylinder("hub", [0.0, 0.0, low * 0.9], hole * 0.9, h - low * 0.9, BLACK_PLASTIC);
    }
}
