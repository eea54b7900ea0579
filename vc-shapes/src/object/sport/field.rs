//! Goals, hoops and nets.

use vc_graph::portable::Portable;

use crate::material::*;
use crate::solid::{Axis, Build, P, Proportional, SIDES};

/// A net of cords over a quadrilateral with `cells` along and across; the frame it hangs from runs
/// along the sides.
fn netting(b: &mut Build<'_>, corners: [P; 4], cells: (usize, usize), half: f32, mat: MaterialId) {
    let mix = |a: P, c: P, t: f32| [0, 1, 2].map(|k| a[k] + (c[k] - a[k]) * t);
    let [a, c, d, e] = corners;
    for i in 1..cells.0 {
        let t = i as f32 / cells.0 as f32;
        b.plank("net", mix(a, c, t), mix(e, d, t), (half * 2.0, half * 2.0), mat);
    }
    for i in 0..=cells.1 {
        let t = i as f32 / cells.1 as f32;
        b.plank("net", mix(a, e, t), mix(c, d, t), (half * 1.4, half * 1.4), mat);
    }
}

/// A basketball backboard with hoop and net on a mast with a filled base.
pub(super) fn basketball_hoop(b: &mut Build<'_>) {
    let (mast, board) =
        (b.choose(&[BLACK_METAL, GALVANISED, BLUE_METAL]), b.choose(&[CLEAR_PLASTIC, WHITE_PLASTIC, BLACK_PLASTIC]));
    let line = if board == WHITE_PLASTIC { RED_PLASTIC } else { WHITE_PLASTIC };
    let r = (b.size.x * 0.17).min(0.2286).min(b.size.y * 0.3);
    let ring = 0.99 - 2.0 * (r + 0.01) / b.size.x;
    let face = ring - 2.0 * r / b.size.x - 0.12;
    let tall = (b.size.y * 0.62 / b.size.z).min(0.34);
    let low = 0.995 - tall;
    b.chunk(
        "base",
        &[
            [-1.0, 0.85, 0.0],
            [-1.0, -0.85, 0.0],
            [-0.1, 0.85, 0.0],
            [-0.1, -0.85, 0.0],
            [-0.95, 0.7, 0.07],
            [-0.95, -0.7, 0.07],
            [-0.2, 0.7, 0.05],
            [-0.2, -0.7, 0.05],
        ],
        BLACK_PLASTIC,
    );
    b.plank("mast", [-0.6, 0.0, 0.04], [-0.5, 0.0, low + tall * 0.3], (0.1, 0.1), mast);
    let apart = 0.12 / b.size.y;
    for y in SIDES {
        b.plank(
            "arm",
            [-0.5, y * apart, low + tall * 0.1],
            [face - 0.02, y * apart, low + tall * 0.3],
            (0.03, 0.05),
            mast,
        );
        b.plank("arm", [-0.52, y * apart, low - 0.04], [face - 0.02, y * apart, low + tall * 0.7], (0.03, 0.05), mast);
        b.plank("brace", [-0.95, y * 0.5, 0.06], [-0.55, y * 0.05, 0.4], (0.03, 0.03), mast);
    }
    b.slab("board", [face - 0.03, -0.98, low], [face, 0.98, 0.998], board);
    let z = low + tall * 0.2;
    let mark = |y: (f32, f32), z: (f32, f32)| ([face - 0.01, y.0, z.0], [face + 0.012, y.1, z.1]);
    for (y, h) in [
        ((-0.34, 0.34), (z + tall * 0.45, z + tall * 0.49)),
        ((-0.34, 0.34), (z, z + tall * 0.04)),
        ((-0.34, -0.29), (z + tall * 0.04, z + tall * 0.45)),
        ((0.29, 0.34), (z + tall * 0.04, z + tall * 0.45)),
    ] {
        let (from, to) = mark(y, h);
        b.slab("mark", from, to, line);
    }
    b.torus("rim", Axis::Z, [ring, 0.0, z], (r, 0.01), ORANGE);
    b.slab("bracket", [face, -0.1, z - 0.015], [ring - 2.0 * r / b.size.x + 0.03, 0.1, z + 0.012], ORANGE);
    let drop = 0.4 / b.size.z;
    for i in 0..10 {
        let (rx, ry) = (r * 2.0 / b.size.x, r * 2.0 / b.size.y);
        let place = |k: f32, share: f32, z: f32| {
            let (s, c) = (k * std::f32::consts::TAU / 10.0).sine_cosine();
            [ring + rx * share * c, ry * share * s, z]
        };
        let k = i as f32;
        for turn in SIDES {
            b.plank("net", place(k, 1.0, z), place(k + turn, 0.62, z - drop), (0.006, 0.006), WHITE_COTTON);
        }
    }
}

/// A goal with posts, crossbar and a net behind.
pub(super) fn goal(b: &mut Build<'_>) {
    let (post, net) =
        (b.choose(&[WHITE_METAL, WHITE_METAL, RED_METAL, YELLOW_METAL]), b.choose(&[WHITE_COTTON, BLACK_FABRIC]));
    let r = (b.size.z * 0.03).min(0.05);
    let (y, top) = (1.0 - 2.2 * r / b.size.y, 1.0 - r / b.size.z);
    let (x, back) = (1.0 - 2.2 * r / b.size.x, -0.97);
    let slim = r * 0.5;
    let ledge = if b.size.x > 1.0 { 0.3 } else { 0.96 };
    b.pole("crossbar", [x, -y, top], [x, y, top], r, post);
    for s in SIDES.map(|s| s * y) {
        b.pole("post", [x, s, 0.0], [x, s, top], r, post);
        b.pole("ground_bar", [back, s, slim / b.size.z], [x, s, slim / b.size.z], slim, post);
        b.plank(
            "strut",
            [back, s, slim / b.size.z * 2.0],
            [if ledge < 0.9 { ledge } else { x }, s, top * 0.985],
            (slim * 1.6, slim * 1.6),
            post,
        );
        if ledge < 0.9 {
            b.plank("strut", [ledge, s, top * 0.985], [x, s, top * 0.985], (slim * 1.6, slim * 1.6), post);
        }
    }
    b.pole("ground_bar", [back, -y, slim / b.size.z], [back, y, slim / b.size.z], slim, post);
    let cord = (b.size.z * 0.002).clamp(0.002, 0.005);
    let across = (b.size.y / 0.3).clamp(6.0, 16.0) as usize;
    let head = if ledge < 0.9 { ledge } else { x - 0.03 };
    netting(
        b,
        [[back, -y, 0.03], [back, y, 0.03], [head, y, top * 0.98], [head, -y, top * 0.98]],
        (across, 8),
        cord,
        net,
    );
    if ledge < 0.9 {
        netting(
            b,
            [[head + 0.02, -y, top * 0.98], [head + 0.02, y, top * 0.98], [x, y, top * 0.98], [x, -y, top * 0.98]],
            (across, 2),
            cord,
            net,
        );
    }
    for s in SIDES.map(|s| s * y) {
        for i in 1..5 {
            let t = i as f32 / 5.0;
            let (at, z) = (back + (head - back) * t, top * 0.98 * t);
            b.plank("net", [at, s, 0.01], [at, s, z], (cord * 2.0, cord * 2.0), net);
            b.plank("net", [at, s, z], [x, s, z], (cord * 1.4, cord * 1.4), net);
        }
    }
}

/// A net between two posts: high for volleyball, lower for badminton or tennis.
pub(super) fn net(b: &mut Build<'_>) {
    let high = b.class == "volleyball_net";
    let (post, net) =
        (b.choose(&[GALVANISED, BLUE_METAL, YELLOW_METAL, BLACK_METAL]), b.choose(&[BLACK_FABRIC, GREEN_FABRIC]));
    let r = (b.size.x * 0.4).min(0.03);
    let y = 1.0 - 2.2 * r / b.size.y;
    let low = if high { 0.58 } else { 0.5 };
    let wide = b.size.x > 0.3;
    for s in SIDES {
        b.pole("post", [0.0, s * y, 0.0], [0.0, s * y, 0.999], r, post);
        if wide {
            b.slab("foot", [-0.98, s * y - 0.04 / b.size.y, 0.0], [0.98, s * y + 0.04 / b.size.y, 0.025], post);
            for x in SIDES {
                b.plank("brace", [x * 0.8, s * y, 0.02], [0.0, s * y, 0.3], (0.02, 0.02), post);
            }
        } else {
            b.pole("base", [0.0, s * y, 0.0], [0.0, s * y, 0.015], (b.size.x / 2.0).min(r * 2.0), post);
        }
    }
    let tape = 0.05 / b.size.z;
    let t = (0.006 / b.size.x).min(0.4);
    b.slab("tape", [-t, -y, 0.99 - tape], [t, y, 0.99], WHITE_COTTON);
    b.slab("tape", [-t, -y, low - tape * 0.5], [t, y, low], WHITE_COTTON);
    let across = (b.size.y / 0.14).clamp(10.0, 44.0) as usize;
    netting(b, [[0.0, -y, low], [0.0, y, low], [0.0, y, 0.98], [0.0, -y, 0.98]], (across, 7), 0.0018, net);
    if high {
        for s in SIDES {
            b.plank("antenna", [0.0, s * y * 0.9, low], [0.0, s * y * 0.9, 0.995], (0.012, 0.012), RED_PLASTIC);
        }
    }
}
