//! The playground behind the house: equipment for swinging, sliding, climbing and jumping.

use std::f32::consts::{FRAC_PI_2, PI};

use vc_graph::portable::Portable;

use crate::material::*;
use crate::object::palette::*;
use crate::solid::{Axis, Build, CORNERS, Proportional, SIDES, band, rolled};

/// The material of a frame (timber or painted tube) and its radius.
fn framing(b: &mut Build<'_>) -> (MaterialId, f32) {
    if b.rng.chance(0.5) {
        (b.choose(&[PINE, TEAK, OAK]), 0.045)
    } else {
        (b.choose(&[GREEN_METAL, BLUE_METAL, RED_METAL, GALVANISED]), 0.024)
    }
}

/// A swing's seat at one height, hanging on two ropes from another height.
fn hung_seat(b: &mut Build<'_>, y: f32, half: f32, (low, high): (f32, f32), (seat, rope): (MaterialId, MaterialId)) {
    let r = if rope == GALVANISED { 0.006 } else { 0.01 };
    let reach = (0.17 / b.size.x).min(0.9);
    let plank = 0.03 / b.size.z;
    b.pad("seat", [-reach, y - half, low], [reach, y + half, low + plank], 0.012, seat);
    for s in SIDES {
        let side = y + s * (half - 0.012 / b.size.y * 2.0);
        b.pole("rope", [0.0, side, low + plank * 0.5], [0.0, side, high], r, rope);
    }
}

/// A hanging swing: a board, a baby seat, or a round net.
pub(super) fn swing(b: &mut Build<'_>) {
    let (seat, rope) = (
        b.choose(&[PINE, RED_PLASTIC, BLUE_PLASTIC, GREEN_PLASTIC, RUBBER]),
        b.choose(&[JUTE, GALVANISED, BLACK_FABRIC]),
    );
    let baby = b.rng.chance(0.35);
    hung_seat(b, 0.0, 0.98, (0.0, 0.98), (seat, rope));
    for y in SIDES {
        b.torus("ring", Axis::X, [0.0, y * 0.92, 0.985], (0.018, 0.005), GALVANISED);
    }
    if baby {
        let (x, h) = ((0.17 / b.size.x).min(0.9), 0.25 / b.size.z);
        b.pad("backrest", [-x, -0.86, 0.01], [-x * 0.8, 0.86, h], 0.015, seat);
        b.pole("guard", [x * 0.8, -0.9, h * 0.8], [x * 0.8, 0.9, h * 0.8], 0.014, seat);
        for y in SIDES {
            b.slab("arm", [-x * 0.9, y * 0.9 - 0.04, h * 0.74], [x * 0.85, y * 0.9 + 0.04, h * 0.86], seat);
        }
        b.pole("post", [x * 0.8, 0.0, 0.01], [x * 0.8, 0.0, h * 0.8], 0.012, seat);
    }
}

/// A swing frame with two seats, or with one seat and a bar with rings.
pub(super) fn swing_set(b: &mut Build<'_>) {
    let (mat, r) = framing(b);
    let (ends, high) = (1.0 - 0.1, 1.0 - 1.1 * r / b.size.z);
    b.pole("beam", [0.0, -0.995, high], [0.0, 0.995, high], r, mat);
    for y in SIDES {
        for x in SIDES {
            b.plank("leg", [x * 0.95, y * 0.97, 0.01], [x * 0.02, y * ends, high], (r * 1.8, r * 1.8), mat);
        }
        b.plank("brace", [-0.52, y * 0.94, 0.45], [0.52, y * 0.94, 0.45], (r * 1.3, r * 1.3), mat);
    }
    let rope = b.choose(&[JUTE, GALVANISED]);
    let low = 0.42 / b.size.z.max(0.5);
    let half = 0.45 / b.size.y.max(0.5);
    let count = if b.size.y > 3.0 { 3 } else { 2 };
    let pitch = 1.8 * ends / count as f32;
    for i in 0..count {
        let y = (i as f32 - (count as f32 - 1.0) / 2.0) * pitch;
        let seat = b.choose(&[RED_PLASTIC, BLUE_PLASTIC, YELLOW_PLASTIC, PINE]);
        if i == 2 {
            for s in SIDES {
                b.pole(
                    "rope",
                    [0.0, y + s * half * 0.7, 0.56 + 0.08 / b.size.z],
                    [0.0, y + s * half * 0.7, high],
                    0.01,
                    rope,
                );
                b.torus("ring", Axis::X, [0.0, y + s * half * 0.7, 0.56], (0.08, 0.012), seat);
            }
        } else {
            hung_seat(b, y, half, (low, high), (seat, rope));
        }
    }
}

/// A tyre hanging flat on three ropes or upright on one.
pub(super) fn tire_swing(b: &mut Build<'_>) {
    let rope = b.choose(&[JUTE, GALVANISED]);
    let tube = (b.size.x.min(b.size.y) * 0.14).min(0.11);
    let ring = b.size.x.min(b.size.y) / 2.0 - tube;
    if b.rng.chance(0.6) {
        b.torus("tyre", Axis::Z, [0.0, 0.0, tube / b.size.z], (ring, tube), RUBBER);
        for i in 0..3 {
            let (s, c) = (i as f32 * 2.0944).sine_cosine();
            let foot = [ring * c, ring * s, tube * 1.9];
            b.rod("rope", foot, [0.0, 0.0, b.size.z * 0.62], 0.01, rope);
            b.ball("knot", foot, 0.022, rope);
        }
        b.pole("rope", [0.0, 0.0, 0.61], [0.0, 0.0, 1.0 - 0.04 / b.size.z], 0.014, rope);
    } else {
        b.torus("tyre", Axis::X, [0.0, 0.0, (ring + tube) / b.size.z], (ring, tube), RUBBER);
        let top = 2.0 * (ring + tube) / b.size.z;
        b.pole("rope", [0.0, 0.0, top - 0.06], [0.0, 0.0, 1.0 - 0.04 / b.size.z], 0.014, rope);
        b.torus("knot", Axis::Y, [0.0, 0.0, top - tube / b.size.z], (tube * 1.1, 0.012), rope);
    }
    b.torus("ring", Axis::X, [0.0, 0.0, 1.0 - 0.035 / b.size.z], (0.026, 0.008), GALVANISED);
}

/// A slide that descends to the front: ladder, platform, chute with sides.
pub(super) fn slide(b: &mut Build<'_>) {
    let (chute, rail) = (b.one_of(BRIGHT), b.one_of(BRIGHT));
    let plastic = b.size.z < 1.2;
    let top = if plastic { 0.78 } else { 0.74 };
    let wavy = b.rng.chance(0.5);
    let curve: Vec<(f32, f32)> = (0..11)
        .map(|i| i as f32 / 10.0)
        .map(|t| {
            let s = t * t * (3.0 - 2.0 * t);
            let wave = if wavy { 0.05 * (t * std::f32::consts::TAU * 1.0).sine() * (1.0 - t) } else { 0.0 };
            (-0.5 + 1.5 * t, top + (0.07 - top) * s + wave)
        })
        .collect();
    b.side_outline("chute", (-0.62, 0.62), &band(&curve, (0.0, -0.03)), chute);
    for y in SIDES {
        let lip: Vec<_> = curve.iter().map(|&(x, z)| (x, z - 0.05)).collect();
        b.side_outline("side", (y * 0.68 - 0.06, y * 0.68 + 0.06), &band(&lip, (0.0, 0.15)), chute);
    }
    b.pad("platform", [-0.78, -0.86, top - 0.05], [-0.48, 0.86, top], 0.01, rail);
    let r = if plastic { 0.025 } else { 0.02 };
    for y in SIDES {
        b.plank("stile", [-0.98, y * 0.85, 0.005], [-0.74, y * 0.85, top], (r * 1.6, r * 2.0), rail);
        b.plank("post", [-0.5, y * 0.85, 0.0], [-0.55, y * 0.85, top], (r * 1.6, r * 2.0), rail);
        b.bent_rod(
            "handrail",
            &[
                [-0.76, y * 0.85, top - 0.02],
                [-0.76, y * 0.85, 0.96],
                [-0.5, y * 0.85, 0.96],
                [-0.38, y * 0.85, top - 0.02],
            ],
            r * 0.8,
            rail,
        );
    }
    let rungs = ((top * b.size.z) / 0.22).clamp(2.0, 8.0) as usize;
    for i in 1..=rungs {
        let t = i as f32 / (rungs as f32 + 1.0);
        let (x, z) = (-0.98 + 0.24 * t, top * t);
        b.slab("rung", [x - 0.04, -0.82, z - 0.015], [x + 0.07, 0.82, z + 0.015], rail);
    }
    for y in SIDES {
        b.pole("foot", [0.7, y * 0.5, 0.0], [0.7, y * 0.5, curve[8].1 - 0.02], r, rail);
    }
}

/// A sandpit of boards with a lid in two halves and sometimes seats along two sides.
pub(super) fn sandbox(b: &mut Build<'_>) {
    let wood = b.choose(&[PINE, TEAK, OAK, BLUE]);
    let t = (0.03 / b.size.x).min(0.1);
    let x = (1.0 - t).min(0.96);
    for s in SIDES {
        b.slab("board", [s * x - t, -x, 0.0], [s * x + t, x, 0.86], wood);
        b.slab("board", [t - x, s * x - t, 0.001], [x - t, s * x + t, 0.855], wood);
    }
    b.slab("sand", [t - x, t - x, 0.0], [x - t, x - t, 0.45], SANDSTONE);
    b.ellipsoid("heap", [0.3, 0.35, 0.45], [0.3, 0.3, 0.25], SANDSTONE);
    b.inner_floor("sand", [-0.35, 0.0, 0.45], (0.3, 0.7), 0.38);
    // The lid's halves are hinged at the sides, or at seats onto which they fold.
    let (edge, fold) = if b.rng.chance(0.5) { (1.0, PI * 0.55) } else { (0.66, PI * 0.85) };
    for y in SIDES {
        let (inner, outer) = (y * 0.005, y * edge);
        if edge < 1.0 {
            b.slab("seat", [-1.0, y.min(outer), 0.855], [1.0, y.max(outer), 0.95], wood);
        }
        let anchor = b.p([0.0, outer, 0.951]);
        b.hinge(anchor, [-y, 0.0, 0.0], fold, |b| {
            b.slab("lid", [-1.0, inner.min(outer), 0.861], [1.0, inner.max(outer), 0.95], wood);
            for x in [-0.6, 0.6] {
                let (near, far) = (outer * 0.08, outer * 0.9);
                b.slab("batten", [x - 0.06, near.min(far), 0.945], [x + 0.06, near.max(far), 1.0], wood);
            }
        });
    }
}

/// A trampoline: mat in a padded ring on legs, with a net on poles around it.
pub(super) fn trampoline(b: &mut Build<'_>) {
    let pad = b.choose(&[GREEN_FABRIC, BLUE_FABRIC, PURPLE_FABRIC, BLACK_FABRIC]);
    let r = b.size.x.min(b.size.y) / 2.0;
    let h = (b.size.z * 0.36).min(0.9);
    let ring = r * 0.97 - 0.025;
    b.torus("frame", Axis::Z, [0.0, 0.0, (h - 0.04) / b.size.z], (ring, 0.025), GALVANISED);
    b.lathe("mat", [0.0, 0.0, h - 0.02], &[(r * 0.86, 0.0), (r * 0.86, 0.014)], BLACK_FABRIC);
    b.lathe(
        "pad",
        [0.0, 0.0, h - 0.015],
        &[(r * 0.84, 0.0), (r * 0.96, 0.0), (r * 0.96, 0.03), (r * 0.84, 0.03), (r * 0.84, 0.0)],
        pad,
    );
    let legs = 6;
    for i in 0..legs {
        let (s, c) = (i as f32 * 2.0 * PI / legs as f32 + 0.3).sine_cosine();
        let (x, y) = (ring * c, ring * s);
        b.rod("leg", [x, y, 0.0], [x, y, h - 0.03], 0.022, GALVANISED);
        b.rod("pole", [x, y, h], [x, y, b.size.z - 0.02], 0.018, pad);
        b.ball("cap", [x, y, b.size.z - 0.025], 0.025, pad);
    }
    let rim = |z: f32| (z - 0.005, z + 0.005);
    for z in [h + 0.03, (h + b.size.z) / 2.0, b.size.z - 0.06] {
        let band = [
            (ring - 0.008, rim(z).0),
            (ring + 0.001, rim(z).0),
            (ring + 0.001, rim(z).1),
            (ring - 0.008, rim(z).1),
            (ring - 0.008, rim(z).0),
        ];
        b.lathe("net_edge", [0.0; 3], &band, BLACK_FABRIC);
    }
    for i in 0..36 {
        let (s, c) = (i as f32 * PI / 18.0 + 0.05).sine_cosine();
        let at = ring - 0.004;
        b.block(
            "net",
            [at * c - 0.0025, at * s - 0.0025, h + 0.03],
            [at * c + 0.0025, at * s + 0.0025, b.size.z - 0.06],
            BLACK_FABRIC,
        );
    }
    b.top("mat", [0.0, 0.0, h - 0.006], (r * 0.55, r * 0.55));
}

/// A seesaw: a beam on a trestle with two seats and grips.
pub(super) fn seesaw(b: &mut Build<'_>) {
    let (paint, seat) = (b.choose(&[RED, GREEN, BLUE, PINE, YELLOW]), b.one_of(BRIGHT));
    let pivot = 0.62;
    let near = 0.03 / b.size.y;
    for y in SIDES {
        b.plank("trestle", [0.9, y * 0.1, 0.005], [0.12, y * near, pivot], (0.04, 0.05), IRON);
        b.plank("trestle", [-0.9, y * 0.1, 0.005], [-0.12, y * near, pivot], (0.04, 0.05), IRON);
    }
    b.pole("axle", [-0.5, 0.0, pivot], [0.5, 0.0, pivot], 0.025, IRON);
    let tilt = (b.size.z * 0.14 / b.size.y).min(0.2);
    let anchor = b.p([0.0, 0.0, pivot]);
    b.posed(rolled(anchor, tilt), |b| {
        let s = (1.0 + tilt * tilt).sqrt().recip() * 0.97;
        b.slab("beam", [-0.2, -s, 0.03], [0.2, s, 0.12], paint);
        let (reach, top) = (b.size.x * 0.12, b.size.z * 0.03 + 0.006);
        b.block("saddle", [-reach, -0.05, -0.02], [reach, 0.05, top], IRON);
        for y in SIDES {
            b.pad("seat", [-0.75, y * s * 0.88 - 0.1, 0.115], [0.75, y * s * 0.88 + 0.1, 0.17], 0.01, seat);
            let grip = y * s * 0.68;
            b.bent_rod("grip", &[[0.0, grip, 0.11], [0.0, grip, 0.27], [0.0, grip, 0.27]], 0.012, IRON);
            b.pole("grip", [-0.5, grip, 0.27], [0.5, grip, 0.27], 0.014, IRON);
        }
    });
}

/// A dome of bars, or a cube of bars with a net and holds.
pub(super) fn climbing_frame(b: &mut Build<'_>) {
    let mat = b.choose(&[GREEN_METAL, BLUE_METAL, RED_METAL, YELLOW_METAL, GALVANISED]);
    let other = b.choose(&[YELLOW_METAL, RED_METAL, BLUE_METAL]);
    let r = 0.017;
    let half = (1.0 - 2.5 * r / b.size.x, 1.0 - 2.5 * r / b.size.y);
    if b.rng.chance(0.5) {
        let sides = 8;
        let foot = 1.6 * r / b.size.z;
        let crown = 0.985 - r / b.size.z - foot;
        let ring = |level: usize| {
            let turn = [0.0, 0.5, 1.0, 1.42][level];
            let (s, c) = turn.sine_cosine();
            let z = foot + s / 1.42_f32.sine() * crown;
            (0..sides)
                .map(move |i| {
                    let (sy, cx) = ((i as f32 + 0.5 * (level % 2) as f32) * 2.0 * PI / sides as f32).sine_cosine();
                    [half.0 * c * cx, half.1 * c * sy, z]
                })
                .collect::<Vec<_>>()
        };
        for level in 0..4 {
            let here = ring(level);
            for i in 0..sides {
                b.pole("bar", here[i], here[(i + 1) % sides], r, if level % 2 == 0 { mat } else { other });
                if level == 0 {
                    b.pole("foot", [here[i][0], here[i][1], 0.0], here[i], r * 2.0, mat);
                }
            }
            if level > 0 {
                let below = ring(level - 1);
                for i in 0..sides {
                    let next = if level % 2 == 1 { (i + 1) % sides } else { (i + sides - 1) % sides };
                    b.pole("bar", here[i], below[i], r, mat);
                    b.pole("bar", here[i], below[next], r, mat);
                }
            }
        }
        return;
    }
    let top = 0.99 - r / b.size.z;
    let levels = 4;
    for (x, y) in [-1.0, 0.0, 1.0].into_iter().flat_map(|x| [-1.0, 0.0, 1.0].map(|y| (x, y))) {
        b.pole("post", [x * half.0, y * half.1, 0.0], [x * half.0, y * half.1, top], r * 1.2, mat);
    }
    for level in 1..=levels {
        let z = top * level as f32 / levels as f32;
        for s in [-1.0, 0.0, 1.0] {
            b.pole("bar", [s * half.0, -half.1, z], [s * half.0, half.1, z], r, other);
            b.pole("bar", [-half.0, s * half.1, z - 0.015], [half.0, s * half.1, z - 0.015], r, other);
        }
    }
}

/// A ladder overhead between two upright ones.
pub(super) fn monkey_bars(b: &mut Build<'_>) {
    let (mat, r) = framing(b);
    let rung = b.choose(&[GALVANISED, RED_METAL, YELLOW_METAL]);
    let (high, x) = (1.0 - 1.2 * r / b.size.z, 0.6);
    for s in SIDES {
        b.pole("rail", [s * x, -0.99, high], [s * x, 0.99, high], r, mat);
        for y in SIDES {
            b.plank("post", [s * 0.94, y * 0.94, 0.01], [s * x, y * 0.9, high], (r * 1.9, r * 1.9), mat);
        }
    }
    for y in SIDES {
        for i in 1..6 {
            let z = high * i as f32 / 6.0;
            let (reach, at) = (0.94 - 0.34 * z / high, 0.94 - 0.04 * z / high);
            b.pole("step", [-reach, y * at, z], [reach, y * at, z], r * 0.6, rung);
        }
    }
    let count = (b.size.y / 0.3).clamp(4.0, 12.0) as usize;
    for i in 0..count {
        let y = -0.8 + 1.6 * i as f32 / (count as f32 - 1.0);
        b.pole("rung", [-x, y, high], [x, y, high], 0.016, rung);
    }
}

/// A rotating round platform with rails or a wheel in the centre.
pub(super) fn carousel(b: &mut Build<'_>) {
    let (paint, rail) =
        (b.choose(&[RED_METAL, BLUE_METAL, GREEN_METAL, YELLOW_METAL]), b.choose(&[STEEL, YELLOW_METAL, RED_METAL]));
    let r = b.size.x.min(b.size.y) / 2.0;
    let h = b.size.z;
    let deck = (h * 0.2).min(0.14);
    b.cylinder("foot", [0.0; 3], r * 0.3, deck * 0.6, IRON);
    b.hinge([0.0; 3], [0.0, 0.0, 1.0], 2.0 * PI, |b| {
        b.lathe(
            "platform",
            [0.0, 0.0, deck * 0.5],
            &[(r * 0.96, 0.0), (r, deck * 0.2), (r * 0.99, deck * 0.5), (0.0, deck * 0.51)],
            paint,
        );
        b.lathe(
            "tread",
            [0.0, 0.0, deck * 0.9],
            &[(r * 0.94, 0.0), (r * 0.94, deck * 0.13), (0.0, deck * 0.14)],
            GREY_RUBBER,
        );
        b.cylinder("hub", [0.0, 0.0, deck], r * 0.07, h * 0.62 - deck, IRON);
        b.torus("wheel", Axis::Z, [0.0, 0.0, 0.62], (r * 0.3, 0.016), rail);
        for i in 0..4 {
            let (s, c) = (i as f32 * FRAC_PI_2 + 0.4).sine_cosine();
            b.rod("spoke", [r * 0.06 * c, r * 0.06 * s, h * 0.62], [r * 0.3 * c, r * 0.3 * s, h * 0.62], 0.012, rail);
            let place = |u: f32, v: f32, z: f32| [r * (u * c - v * s), r * (u * s + v * c), z];
            b.pipe(
                "rail",
                &[
                    place(0.9, -0.25, deck),
                    place(0.9, -0.25, h * 0.98 - 0.018),
                    place(0.9, 0.25, h * 0.98 - 0.018),
                    place(0.9, 0.25, deck),
                ],
                0.016,
                rail,
            );
            let seat = [
                place(0.5, -0.3, h * 0.42),
                place(0.5, 0.3, h * 0.42),
                place(0.78, 0.3, h * 0.42),
                place(0.78, -0.3, h * 0.42),
            ];
            let below = seat.map(|[x, y, z]| [x, y, z - 0.03]);
            b.hull("seat", &[seat, below].concat(), BRIGHT[i % 4]);
            b.rod("seat_post", place(0.62, 0.0, deck), place(0.62, 0.0, h * 0.42 - 0.01), 0.02, rail);
        }
    });
}

/// A ladder of ropes with wooden rungs, or a knotted rope.
pub(super) fn rope_ladder(b: &mut Build<'_>) {
    let (rope, rung) =
        (b.choose(&[JUTE, WHITE_COTTON, BLUE_FABRIC]), b.choose(&[PINE, BEECH, RED_PLASTIC, YELLOW_PLASTIC]));
    let r = (b.size.x * 0.2).min(0.016);
    let steps = (b.size.z / 0.3).clamp(3.0, 10.0) as usize;
    for y in SIDES {
        b.pole("rope", [0.0, y * 0.82, 0.0], [0.0, y * 0.82, 0.95], r * 0.6, rope);
        b.pole("rope", [0.0, y * 0.82, 0.94], [0.0, 0.0, 0.99], r * 0.6, rope);
    }
    b.torus("ring", Axis::X, [0.0, 0.0, 1.0 - 1.9 * r / b.size.z], (r * 1.3, r * 0.4), GALVANISED);
    let half = (b.size.x / 2.0).min(0.02);
    for i in 0..steps {
        let z = (0.03 + 0.86 * i as f32 / (steps as f32 - 1.0)) * b.size.z;
        let y = b.size.y / 2.0;
        b.rod("rung", [0.0, -y, z], [0.0, y, z], half, rung);
    }
}

/// A cable between two trestles, with a seat on a trolley.
pub(super) fn zip_line(b: &mut Build<'_>) {
    let (mat, r) = framing(b);
    let end = 1.0 - 1.2 / b.size.x.max(2.0);
    let (low, high) = (0.84, 1.0 - 0.06 / b.size.z);
    for (x, top) in [(-end, high), (end, low)] {
        for y in SIDES {
            b.plank("post", [x, y * 0.9, 0.01], [x, y * 0.2, top], (r * 1.8, r * 1.8), mat);
            b.plank(
                "stay",
                [x + x.signum() * (1.0 - end) * 0.9, y * 0.9, 0.01],
                [x, y * 0.25, top * 0.97],
                (r * 1.5, r * 1.5),
                mat,
            );
        }
        let beam = top - r / b.size.z;
        b.plank("crossbar", [x, -0.4, beam], [x, 0.4, beam], (r * 2.0, r * 2.0), mat);
    }
    b.slab("platform", [-end - 0.02, -0.8, 0.16], [-end + 0.06, 0.8, 0.19], mat);
    let at = -end + 0.14;
    let z = high + (low - high) * 0.08;
    b.pole("cable", [-end, 0.0, high], [end, 0.0, low], 0.008, STEEL);
    let trolley = b.p([at, 0.0, z]);
    b.block(
        "trolley",
        [trolley[0] - 0.1, -0.025, trolley[2] - 0.05],
        [trolley[0] + 0.1, 0.025, trolley[2] + 0.04],
        RED_PLASTIC,
    );
    b.rod("rope", [trolley[0], 0.0, trolley[2] - 0.04], [trolley[0], 0.0, b.size.z * 0.18], 0.012, JUTE);
    let r = (b.size.y * 0.4).min(0.16);
    b.cylinder("seat", [trolley[0], 0.0, b.size.z * 0.18], r, 0.05, BLACK_PLASTIC);
}

/// A crawling tunnel: cloth on hoops.
pub(super) fn tunnel(b: &mut Build<'_>) {
    let (a, c) = (b.one_of(CLOTHS), b.one_of(CLOTHS));
    let r = b.size.y.min(b.size.z) / 2.0;
    let segments = 6;
    let step = 2.0 / segments as f32;
    let long = b.size.x / segments as f32;
    for i in 0..segments {
        let x = -1.0 + step * i as f32;
        let at = b.p([x, 0.0, 0.0]);
        let wall = [
            (r - 0.008, 0.0),
            (r - 0.008 - r * 0.06, long * 0.5),
            (r - 0.008, long),
            (r - 0.014, long),
            (r - 0.014 - r * 0.06, long * 0.5),
            (r - 0.014, 0.0),
            (r - 0.008, 0.0),
        ];
        let mat = if i % 2 == 0 { a } else { c };
        b.lathe_along("cloth", [at[0], 0.0, r], [at[0] + long, 0.0, r], &wall, mat);
    }
    for i in 0..=segments {
        let x = (-1.0 + step * i as f32) * (1.0 - 0.014 / b.size.x);
        b.torus("hoop", Axis::X, [x, 0.0, r / b.size.z], (r - 0.007, 0.006), BLACK_FABRIC);
    }
    let half = r * 0.5;
    b.inside("tunnel", [0.0, 0.0, r * 0.3], (b.size.x * 0.45, half * 0.9), r * 1.1);
    b.block("floor", [-b.size.x * 0.47, -half * 1.05, r * 0.27], [b.size.x * 0.47, half * 1.05, r * 0.3], a);
}

/// Croquet: mallets and balls on a stand, hoops and a peg.
pub(super) fn croquet(b: &mut Build<'_>) {
    let wood = b.choose(&[BEECH, OAK, CHERRY]);
    let colours = [BLUE, RED, BLACK, YELLOW];
    for y in SIDES {
        b.slab("stand", [-0.95, y * 0.9 - 0.03, 0.0], [0.95, y * 0.9 + 0.03, 0.07], wood);
        b.slab("stand", [-0.12, y * 0.9 - 0.03, 0.07], [0.12, y * 0.9 + 0.03, 0.85], wood);
    }
    for z in [0.12, 0.78] {
        b.slab("rail", [-0.1, -0.9, z], [0.1, 0.9, z + 0.06], wood);
    }
    let (ball, head) = ((b.size.x * 0.2).min(b.size.y * 0.05), b.size.z * 0.09);
    for (i, mat) in colours.into_iter().enumerate() {
        let y = -0.66 + 0.44 * i as f32;
        b.pole("shaft", [0.3, y, 0.2], [0.3, y, 1.0], head * 0.25, wood);
        b.pole("head", [-0.35, y, 0.11], [0.95, y, 0.11], head, wood);
        b.pole("band", [0.7, y, 0.11], [0.85, y, 0.11], head * 1.05, mat);
        let at = b.p([-0.55, y + 0.2, 0.0]);
        b.ball("ball", [at[0], at[1], ball], ball, mat);
        let gate = [0.1, 0.9, 0.9, 0.1].map(|z| [-0.13, y, z]);
        let gate = [(gate[0], -0.12), (gate[1], -0.12), (gate[2], 0.12), (gate[3], 0.12)]
            .map(|(p, dy)| [p[0], p[1] + dy, p[2]]);
        b.bent_rod("hoop", &gate, b.size.z * 0.012, WHITE_METAL);
    }
    for (i, mat) in colours.into_iter().enumerate() {
        let z = 0.61 + 0.08 * i as f32;
        b.pole("peg", [0.0, 0.9, z], [0.0, 0.9, z + 0.08], b.size.z * 0.035, mat);
    }
}

/// A water table: two basins on legs, a mill and cups.
pub(super) fn water_table(b: &mut Build<'_>) {
    let (case, leg) = (
        b.choose(&[BLUE_PLASTIC, GREEN_PLASTIC, ORANGE_PLASTIC, YELLOW_PLASTIC, PINE]),
        b.choose(&[WHITE_PLASTIC, YELLOW_PLASTIC, PINE]),
    );
    let tall = b.rng.chance(0.6);
    let rim = if tall { 0.68 } else { 0.96 };
    let (low, t) = (rim - 0.2, 0.04);
    for (x, y) in CORNERS {
        b.pad("leg", [x * 0.85 - 0.09, y * 0.9 - 0.06, 0.0], [x * 0.85 + 0.09, y * 0.9 + 0.06, low + 0.02], 0.012, leg);
    }
    b.slab("bottom", [-0.98, -0.98, low], [0.98, 0.98, low + 0.03], case);
    for s in SIDES {
        b.slab("wall", [s * 0.96 - t, -1.0, low + 0.03], [s * 0.96 + t, 1.0, rim], case);
        b.slab("wall", [-0.92, s * 0.96 - t, low + 0.03], [0.92, s * 0.96 + t, rim - 0.004], case);
    }
    b.slab("divider", [-0.92, -t * 0.7, low + 0.03], [0.92, t * 0.7, rim - 0.01], case);
    b.slab("water", [-0.92, t * 0.7, low + 0.03], [0.92, 0.92, low + 0.1], POOL_WATER);
    b.slab("sand", [-0.92, -0.92, low + 0.03], [0.92, -t * 0.7, low + 0.1], SANDSTONE);
    b.inner_floor("water", [0.3, 0.48, low + 0.1], (0.55, 0.38), 0.08);
    b.inner_floor("sand", [0.3, -0.48, low + 0.1], (0.55, 0.38), 0.08);
    b.deck("rim", [0.6, 0.0, rim - 0.01], (0.3, t * 0.5));
    if tall {
        let r = b.size.z * 0.09;
        b.pole("post", [-0.7, 0.45, low + 0.01], [-0.7, 0.45, 0.94], b.size.z * 0.02, leg);
        b.within([-0.98, 0.15, 0.9], [-0.42, 0.75, 1.0], |b| {
            b.chunk(
                "funnel",
                &[
                    [-0.5, -0.3, 0.0],
                    [0.5, -0.3, 0.0],
                    [0.5, 0.3, 0.0],
                    [-0.5, 0.3, 0.0],
                    [-1.0, -1.0, 1.0],
                    [1.0, -1.0, 1.0],
                    [1.0, 1.0, 1.0],
                    [-1.0, 1.0, 1.0],
                ],
                RED_PLASTIC,
            )
        });
        for i in 0..4 {
            let (s, c) = (i as f32 * PI / 4.0).sine_cosine();
            let (dx, dz) = (c * r * 2.0 / b.size.x, s * r / b.size.z);
            b.plank(
                "blade",
                [-0.7 - dx, 0.45, 0.79 - dz],
                [-0.7 + dx, 0.45, 0.79 + dz],
                (b.size.y * (0.08 - 0.005 * i as f32), 0.006),
                YELLOW_PLASTIC,
            );
        }
    }
}
