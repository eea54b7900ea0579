//! Mirrors for walls, floors and hands.

use vc_graph::portable::Portable;

use crate::material::*;
use crate::solid::{Axis, Build, P, blocks, facing, half_dims, hoop, ngon, oval, tube};

/// A wall mirror: rectangular, round, arched or with lights.
pub(super) fn wall(b: &mut Build<'_>) {
    facing(b, pane);
}

/// A framed pane with the centre of its base at the origin.
fn pane(b: &mut Build<'_>, t: f32, w: f32, h: f32) {
    let frame = b.choose(&[b.style.wood, b.style.metal, GOLD, WHITE, BLACK, WALNUT]);
    let bar = w.min(h) * b.vary(0.02, 0.08);
    let (y, back, face) = (w / 2.0, -t / 2.0, t / 2.0);
    let plane = back + t * 0.6;
    match b.rng.below(3) {
        0 => {
            let at = [0.0, 0.0, h / 2.0];
            let r = (t / 2.0).min(bar);
            let line = oval(Axis::X, at, (y - r, h / 2.0 - r), 0, 40);
            hoop(b, "frame", &line, r, frame);
            let glass = ngon((y - r, h / 2.0 - r), 40);
            b.prism("back", Axis::X, [back, 0.0, h / 2.0], &glass, t * 0.4, BLACK_CARD);
            b.prism("mirror", Axis::X, [back + t * 0.3, 0.0, h / 2.0], &glass, plane - back - t * 0.3, MIRROR);
        }
        1 => {
            let list = [
                ([back, -y, 0.0], [face, y, bar]),
                ([back, -y, h - bar], [face, y, h]),
                ([back, -y, bar * 0.99], [face, -y + bar, h - bar * 0.99]),
                ([back, y - bar, bar * 0.99], [face, y, h - bar * 0.99]),
            ];
            blocks(b, "frame", &list, frame);
            b.block(
                "mirror",
                [back + t * 0.1, -y + bar * 0.9, bar * 0.9],
                [plane, y - bar * 0.9, h - bar * 0.9],
                MIRROR,
            );
        }
        _ => {
            let arch = |s: f32| -> Vec<(f32, f32)> {
                let (w, top) = (y - s, h - s);
                let round = w.min(h * 0.5);
                let curve = (0..=16)
                    .map(|i| i as f32 / 16.0 * std::f32::consts::PI)
                    .map(|a| (w * a.cosine(), top - round + round * a.sine()));
                [(-w, s), (w, s)].into_iter().chain(curve).collect()
            };
            b.prism("frame", Axis::X, [back, 0.0, 0.0], &arch(0.0), t * 0.6, frame);
            b.prism("mirror", Axis::X, [back + t * 0.3, 0.0, 0.0], &arch(bar), t * 0.5, MIRROR);
            let line: Vec<P> = arch(bar * 0.5).iter().map(|&(a, c)| [back + t * 0.6, a, c]).collect();
            hoop(b, "frame", &line, (bar * 0.5).min(t * 0.39), frame);
        }
    }
}

/// A tall mirror: leaning, or turning in a stand.
pub(super) fn standing(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    if x < 0.06 {
        return pane(b, 2.0 * x, 2.0 * y, h);
    }
    let post = (y * 0.06).min(0.018);
    let frame = b.choose(&[b.style.wood, b.style.metal, BLACK, WHITE]);
    for side in [-1.0_f32, 1.0] {
        let at = side * (y - post);
        b.block("post", [-post, at - post, post], [post, at + post, h * 0.72], frame);
        b.taper("foot", [0.0, at, 0.0], (x, post), (x * 0.25, post * 0.8), h * 0.05, frame);
        b.ball("knob", [0.0, at, h * 0.72], post * 0.95, frame);
        b.rod("pivot", [0.0, at, h * 0.55], [0.0, side * (y - 3.2 * post), h * 0.55], post * 0.4, BRASS);
    }
    b.block("brace", [-post * 0.7, -y + post, h * 0.07], [post * 0.7, y - post, h * 0.07 + 1.6 * post], frame);
    let (t, w) = ((x * 0.3).min(0.03), 2.0 * (y - 2.6 * post));
    let (low, tall) = (h * 0.1, h * 0.9);
    b.at([0.0, 0.0, low], 0.0, |b| pane(b, t, w, tall));
}

/// A hand mirror, or a small mirror on a foot.
pub(super) fn hand(b: &mut Build<'_>) {
    facing(b, |b, t, w, h| {
        let frame = b.choose(&[b.style.metal, GOLD, CHROME, PINK_PLASTIC, BLACK_PLASTIC, WHITE_PLASTIC, b.style.wood]);
        let r = (w / 2.0).min(h * 0.35);
        let rim = (t * 0.4).min(r * 0.08);
        let centre = [0.0, 0.0, h - r];
        hoop(b, "frame", &oval(Axis::X, centre, (w / 2.0 - rim, r - rim), 0, 28), rim, frame);
        let glass = ngon((w / 2.0 - rim, r - rim), 28);
        b.prism("back", Axis::X, [centre[0] - rim * 0.8, 0.0, centre[2]], &glass, rim, frame);
        b.prism("mirror", Axis::X, [centre[0] - rim * 0.1, 0.0, centre[2]], &glass, rim * 0.6, MIRROR);
        if t > 0.05 {
            let foot = t / 2.0;
            b.lathe(
                "foot",
                [0.0; 3],
                &[(foot, 0.0), (foot * 0.9, h * 0.03), (rim * 1.4, h * 0.06), (rim, h - 2.0 * r + rim)],
                frame,
            );
        } else {
            let grip = rim * 1.5;
            let thick = (t / 2.0).min(grip);
            tube(b, "grip", &[[0.0, 0.0, thick], [0.0, 0.0, h * 0.12], [0.0, 0.0, h - 2.0 * r + rim]], thick, frame);
        }
    });
}
