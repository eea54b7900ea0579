//! Sculptures, figurines, festive decoration and other ornaments.

use std::f32::consts::TAU;

use vc_graph::portable::Portable;

use super::super::tool::pet;
use crate::material::*;
use crate::solid::{Axis, Build, MeshBuilder, P, arc, blocks, half_dims, hoop, loft, mix, ngon, oval, spline, tube};

/// A sculpture: a bust, a knot of rings, a twisted column, stacked stones, a
/// standing figure or an abstract loop.
pub(super) fn sculpture(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let mat = b.choose(&[MARBLE, BRASS, IRON, PLASTER, BLACK_GLAZE, POTTERY, WALNUT, COPPER, GRANITE]);
    let kind = b.rng.below(6);
    let least = if matches!(kind, 0 | 4) { h - 3.2 * x.min(y) } else { 0.0 };
    let plinth = (h * b.vary(0.06, 0.14)).max(least);
    let stone = b.choose(&[BLACK_GRANITE, MARBLE, b.style.wood, WENGE]);
    b.block("plinth", [-x, -y, 0.0], [x, y, plinth], stone);
    let r = x.min(y);
    let at = |t: f32| plinth + (h - plinth) * t;
    match kind {
        0 => bust(b, r, plinth, mat),
        1 => {
            let ring = (h - plinth) / 2.0;
            let thick = (r * 0.22).min(ring * 0.2);
            let reach = y - thick;
            let line = oval(Axis::X, [0.0, 0.0, at(0.5)], (reach, ring - thick), 0, 32);
            hoop(b, "ring", &line, thick, mat);
            let small = oval(Axis::Y, [0.0, 0.0, at(0.45)], (x - thick, ring * 0.7), 0, 28);
            hoop(b, "ring", &small, thick * 0.8, mat);
        }
        2 => {
            let twist = b.vary(1.5, 4.0);
            let rings: Vec<Vec<P>> = (0..=14)
                .map(|i| {
                    let t = i as f32 / 14.0;
                    let s = r * (0.75 - 0.35 * (t * 3.1).sine());
                    let (sin, cos) = (twist * t).sine_cosine();
                    oval(Axis::Z, [0.0; 3], (s, s * 0.5), 1, 12)
                        .iter()
                        .map(|p| [p[0] * cos - p[1] * sin, p[0] * sin + p[1] * cos, at(t)])
                        .collect()
                })
                .collect();
            loft(b, "column", &rings, mat);
        }
        3 => {
            let count = b.rng.count(3, 5);
            let mut z = plinth;
            for i in 0..count {
                let tall = (h - plinth) / count as f32;
                let s = r * (0.95 - 0.14 * i as f32) * b.vary(0.85, 1.0);
                let mut stone = MeshBuilder::default();
                stone.egg([r * b.vary(-0.06, 0.06), 0.0, z + tall * 0.5], [s, s * 0.9, tall * 0.54]);
                let mat = if i % 2 == 0 { mat } else { b.choose(&[ROCK, GRANITE, mat]) };
                stone.put(b, "stone", mat);
                z += tall;
            }
        }
        4 => figure(b, r, plinth, mat),
        _ => {
            let thick = r * 0.16;
            let (reach, top) = (y - thick, h - thick);
            let points = [
                [0.0, -reach * 0.5, plinth],
                [x * 0.5, -reach, at(0.3)],
                [0.0, reach * 0.4, at(0.55)],
                [-x * 0.5, reach * 0.9, at(0.75)],
                [0.0, 0.0, top],
                [x * 0.3, -reach * 0.6, at(0.8)],
            ];
            let mut shell = MeshBuilder::default();
            shell.tapered(&spline(&points, 6), |t| thick * (1.0 - 0.6 * t));
            shell.put(b, "ribbon", mat);
        }
    }
}

/// Head, neck and shoulders.
fn bust(b: &mut Build<'_>, r: f32, low: f32, mat: MaterialId) {
    let h = b.size.z;
    let tall = h - low;
    let ring =
        |t: f32, dx: f32, dy: f32, shift: f32| oval(Axis::Z, [r * shift, 0.0, low + tall * t], (r * dx, r * dy), 0, 16);
    let rings = [
        ring(0.0, 0.35, 0.4, 0.0),
        ring(0.08, 0.4, 0.5, 0.0),
        ring(0.2, 0.5, 0.95, 0.0),
        ring(0.33, 0.42, 0.85, 0.0),
        ring(0.4, 0.26, 0.36, 0.0),
        ring(0.48, 0.24, 0.26, 0.03),
        ring(0.56, 0.36, 0.32, 0.1),
        ring(0.68, 0.5, 0.42, 0.08),
        ring(0.82, 0.52, 0.46, 0.0),
        ring(0.93, 0.38, 0.36, -0.05),
        ring(1.0, 0.1, 0.1, -0.08),
    ];
    loft(b, "bust", &rings, mat);
    let mut face = MeshBuilder::default();
    face.tapered(&[[r * 0.5, 0.0, low + tall * 0.74], [r * 0.66, 0.0, low + tall * 0.64]], |t| r * (0.05 + 0.06 * t));
    [-1.0, 1.0].iter().for_each(|s| face.egg([0.0, s * r * 0.44, low + tall * 0.7], [r * 0.1, r * 0.05, tall * 0.06]));
    face.put(b, "face", mat);
}

/// A slim standing person.
fn figure(b: &mut Build<'_>, r: f32, low: f32, mat: MaterialId) {
    let tall = b.size.z - low;
    let at = |x: f32, y: f32, z: f32| [r * x, r * y, low + tall * z];
    let mut shell = MeshBuilder::default();
    let lean = b.vary(-0.2, 0.2);
    let girth = |t: f32| tall * (0.035 + 0.03 * (t * 3.1).sine());
    shell.tapered(&[at(0.0, -0.3, 0.0), at(0.0, -0.2, 0.25), at(0.0, -0.08, 0.48)], |t| tall * (0.02 + 0.025 * t));
    shell.tapered(&[at(0.15, 0.35, 0.0), at(0.2, 0.22, 0.25), at(0.0, 0.08, 0.48)], |t| tall * (0.02 + 0.025 * t));
    shell.tapered(
        &spline(&[at(0.0, 0.0, 0.44), at(0.0, lean * 0.4, 0.58), at(0.05, lean * 0.6, 0.72), at(0.0, lean, 0.84)], 3),
        girth,
    );
    shell
        .tapered(&[at(0.0, lean - 0.25, 0.8), at(0.1, -0.6, 0.65), at(0.3, -0.4, 0.5)], |t| tall * (0.022 - 0.008 * t));
    shell
        .tapered(&[at(0.0, lean + 0.25, 0.8), at(0.0, 0.7, 0.85), at(0.1, 0.75, 0.98)], |t| tall * (0.022 - 0.008 * t));
    shell.egg(at(0.0, lean, 0.92), [tall * 0.05, tall * 0.045, tall * 0.075]);
    shell.put(b, "figure", mat);
}

/// A small figure: a cat, a bird, a person, an elephant of glass.
pub(super) fn figurine(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let glaze = b.choose(&[PORCELAIN, BLUE_GLAZE, GREEN_GLAZE, BRASS, BLACK_GLAZE, WALNUT, GLASS, RED_GLAZE]);
    let r = x.min(y);
    match b.rng.below(3) {
        0 => {
            b.cylinder("base", [0.0; 3], r * 0.95, h * 0.06, glaze);
            figure(b, r, h * 0.06, glaze);
        }
        1 => pet::sitting(b, glaze, glaze),
        _ => {
            b.lathe(
                "base",
                [0.0; 3],
                &[(r * 0.6, 0.0), (r * 0.5, h * 0.1), (r * 0.3, h * 0.15), (r * 0.3, h * 0.3), (r * 0.6, h * 0.36)],
                glaze,
            );
            pet::bird(b, [0.0, 0.0, h * 0.35], h * 0.65, (glaze, glaze, BRASS));
        }
    }
}

/// A wreath of leaves on a ring, with berries and a bow.
pub(super) fn wreath(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let r = y.min(h / 2.0);
    let (thick, mid) = (r * 0.18, h / 2.0);
    let line = oval(Axis::X, [0.0, 0.0, mid], (r * 0.78, r * 0.78), 0, 32);
    hoop(b, "ring", &line, (thick * 0.5).min(x * 0.5), BARK);
    let mut leaves = [MeshBuilder::default(), MeshBuilder::default()];
    let count = b.rng.count(34, 44);
    for i in 0..count {
        let a = TAU * i as f32 / count as f32;
        let reach = b.vary(0.5, 0.98);
        let from = [x * b.vary(-0.5, 0.2), r * 0.78 * a.cosine(), mid + r * 0.78 * a.sine()];
        let ahead = a + 0.28;
        let to = [x * b.vary(-0.3, 0.95), r * reach * ahead.cosine(), mid + r * reach * ahead.sine()];
        let wide = r * 0.06;
        leaves[i % 2].tapered(&[from, mix(from, to, 0.4), to], |t| wide * (0.5 + 1.6 * t - 2.05 * t * t).max(0.05));
    }
    let (first, second) = b.choose(&[(DARK_LEAF, LEAF), (LEAF, LIGHT_LEAF), (DARK_LEAF, AUTUMN_LEAF)]);
    let [a, c] = leaves;
    a.put(b, "leaf", first);
    c.put(b, "leaf", second);
    let mut berries = MeshBuilder::default();
    for _ in 0..9 {
        let (s, c) = b.vary(0.0, TAU).sine_cosine();
        let size = r * 0.05;
        berries.egg([x * 0.4, r * 0.78 * c, mid + r * 0.78 * s], [size, size, size]);
    }
    let berry = b.choose(&[RED_SKIN, PETAL_WHITE, GOLD, PURPLE_SKIN]);
    berries.put(b, "berry", berry);
    if b.rng.chance(0.6) {
        bow(b, [x * 0.5, 0.0, mid - r * 0.72], r * 0.3);
    }
}

/// A ribbon tied in a bow, facing +X.
fn bow(b: &mut Build<'_>, at: P, size: f32) {
    let ribbon = b.choose(&[RED_FABRIC, GOLD, WHITE_COTTON, GREEN_FABRIC]);
    let mut shell = MeshBuilder::default();
    for side in [-1.0, 1.0] {
        let point = |y: f32, z: f32| [at[0], at[1] + side * size * y, at[2] + size * z];
        shell.tapered(
            &spline(&[point(0.0, 0.0), point(0.5, 0.35), point(0.9, 0.2), point(0.6, -0.1), point(0.0, 0.0)], 3),
            |t| size * (0.06 + 0.08 * (t * 3.1).sine()),
        );
        shell.tapered(&[point(0.0, 0.0), point(0.3, -0.5), point(0.35, -0.85)], |_| size * 0.08);
    }
    shell.put(b, "bow", ribbon);
}

/// A Christmas tree: tiers of needles, baubles, a star and lights.
pub(super) fn christmas_tree(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let r = x.min(y);
    let pot = h * 0.1;
    b.lathe("pot", [0.0; 3], &[(r * 0.22, 0.0), (r * 0.3, pot), (r * 0.26, pot), (r * 0.2, pot * 0.3)], RED_METAL);
    b.cylinder("trunk", [0.0, 0.0, pot * 0.3], r * 0.07, h * 0.25, BARK);
    let (tiers, tip) = (b.rng.count(5, 7), h * 0.94);
    let low = h * 0.14;
    let half_width = |z: f32| r * 0.98 * (1.0 - (z - low) / (tip - low)).max(0.0);
    let mut needles = MeshBuilder::default();
    for i in 0..tiers {
        let z0 = low + (tip - low) * i as f32 / tiers as f32;
        let z1 = low + (tip - low) * (i as f32 + 1.35).min(tiers as f32) / tiers as f32;
        let points = 20;
        let turn = b.vary(0.0, 0.3);
        let ring = |z: f32, s: f32, jag: f32| -> Vec<P> {
            (0..points)
                .map(|k| {
                    let (sin, cos) = (TAU * k as f32 / points as f32 + turn).sine_cosine();
                    let s = s * if k % 2 == 0 { 1.0 } else { 1.0 - jag };
                    [s * cos, s * sin, z - s * jag * 0.25]
                })
                .collect()
        };
        let wide = half_width(z0);
        needles.loft(&[
            ring(z0 + (z1 - z0) * 0.25, wide * 0.3, 0.0),
            ring(z0 + wide * 0.08, wide, 0.3),
            ring(z1, (half_width(z1) * 0.35).max(r * 0.01), 0.1),
        ]);
    }
    let green = b.choose(&[DARK_LEAF, DARK_LEAF, LEAF, SAGE]);
    needles.put(b, "needles", green);
    let mut balls = [MeshBuilder::default(), MeshBuilder::default(), MeshBuilder::default()];
    for i in 0..27 {
        let z = low + (tip - low) * (0.05 + 0.8 * i as f32 / 27.0);
        let (s, c) = (i as f32 * 2.4).sine_cosine();
        let size = r * if i % 3 == 2 { 0.022 } else { 0.05 };
        let reach = (half_width(z) * 0.93 - size).max(r * 0.03);
        balls[i % 3].egg([reach * c, reach * s, z], [size, size, size]);
    }
    let colours = b.choose(&[[RED_GLAZE, GOLD], [SILVER_METAL, BLUE_GLAZE], [GOLD, WHITE_METAL]]);
    let [first, second, lights] = balls;
    first.put(b, "bauble", colours[0]);
    second.put(b, "bauble", colours[1]);
    lights.put(b, "light", WARM_BULB);
    let size = h - tip;
    let star: Vec<(f32, f32)> = (0..10)
        .map(|i| (TAU * i as f32 / 10.0, if i % 2 == 0 { 0.52 } else { 0.22 }))
        .map(|(a, s)| (size * s * a.sine(), size * s * a.cosine()))
        .collect();
    b.cylinder("spike", [0.0, 0.0, tip - size], size * 0.05, size * 1.5, GOLD);
    b.prism("star", Axis::X, [-size * 0.06, 0.0, h - size * 0.52], &star, size * 0.12, GOLD);
}

/// A bookend: an angle with a letter, a ball or a horse's head.
pub(super) fn bookend(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let mat = b.choose(&[IRON, MARBLE, b.style.wood, BRASS, BLACK_GRANITE]);
    let t = (y * 0.12).min(0.012);
    b.block("foot", [-x * 0.98, -y, 0.0], [x * 0.98, y - t * 0.3, t * 0.6], mat);
    b.block("back", [-x, y - t, t * 0.5], [x, y, h], mat);
    match b.rng.below(3) {
        0 => {
            let r = (y - t * 0.5).min(x).min(h * 0.45) * 0.95;
            b.ball("ball", [0.0, y - t - r * 0.9, t * 0.5 + r], r, BRASS);
        }
        1 => {
            let outline = [(y - t * 1.01, t * 0.5), (-y * 0.9, t * 0.5), (y - t * 1.01, h * 0.9)];
            b.prism("wedge", Axis::X, [-x * 0.4, 0.0, 0.0], &outline, x * 0.8, mat);
        }
        _ => {
            let step = |i: f32| {
                (
                    [-x * 0.8, y - t - (2.0 * y - t) * (0.9 - 0.28 * i), t * 0.5],
                    [x * 0.8, y - t * 0.9, t + h * (0.26 * (i + 1.0))],
                )
            };
            blocks(b, "step", &[step(0.0), step(1.0), step(2.0)], mat);
        }
    }
}

/// A piggy bank with a slot in its back.
pub(super) fn piggy_bank(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let skin = b.choose(&[PINK_PLASTIC, PORCELAIN, BLUE_GLAZE, PINK_PLASTIC]);
    b.at([0.0; 3], if y > x { std::f32::consts::FRAC_PI_2 } else { 0.0 }, |b| {
        let (l, w) = (x.max(y), x.min(y));
        let leg = h * 0.2;
        let ring =
            |t: f32, s: f32| oval(Axis::X, [l * t, 0.0, leg + (h - leg) * 0.46], (w * s, (h - leg) * 0.46 * s), 0, 16);
        let outer = [
            (-0.92, 0.1),
            (-0.85, 0.45),
            (-0.6, 0.82),
            (-0.15, 1.0),
            (0.3, 0.92),
            (0.6, 0.66),
            (0.8, 0.4),
            (0.82, 0.34),
            (0.98, 0.34),
        ];
        let inner = [(0.97, 0.26), (0.8, 0.26), (0.58, 0.56), (0.3, 0.82), (-0.15, 0.9), (-0.55, 0.72), (-0.8, 0.35)];
        let rings: Vec<Vec<P>> = outer.iter().chain(&inner).map(|&(t, s)| ring(t, s)).collect();
        loft(b, "body", &rings, skin);
        b.rod(
            "snout",
            [l * 0.9, 0.0, leg + (h - leg) * 0.46],
            [l * 0.97, 0.0, leg + (h - leg) * 0.46],
            w.min((h - leg) * 0.46) * 0.3,
            skin,
        );
        b.inside("slot", [0.0, 0.0, leg + (h - leg) * 0.12], (l * 0.3, w * 0.25), (h - leg) * 0.6);
        let mut bits = MeshBuilder::default();
        for (sx, sy) in [(-0.5, -0.5), (-0.5, 0.5), (0.4, -0.5), (0.4, 0.5)] {
            bits.tapered(&[[l * sx, w * sy, leg * 1.5], [l * sx, w * sy, 0.0]], |_| w * 0.2);
        }
        for side in [-1.0, 1.0] {
            bits.leaf(
                &[
                    [l * 0.5, side * w * 0.4, h * 0.8],
                    [l * 0.55, side * w * 0.55, h * 0.92],
                    [l * 0.68, side * w * 0.6, h * 0.9],
                ],
                |t| w * 0.2 * (1.0 - t * 0.9),
                0.0,
            );
        }
        bits.put(b, "leg", skin);
        let eyes = [-1.0, 1.0]
            .map(|s| ([l * 0.7, s * w * 0.36 - w * 0.05, h * 0.66], [l * 0.77, s * w * 0.36 + w * 0.05, h * 0.72]));
        blocks(b, "eye", &eyes, BLACK_PLASTIC);
        tube(
            b,
            "tail",
            &spline(&[[-l * 0.88, 0.0, h * 0.6], [-l * 0.94, w * 0.1, h * 0.7], [-l * 0.95, -w * 0.1, h * 0.68]], 3),
            w * 0.05,
            skin,
        );
        b.block("slot", [-l * 0.3, -w * 0.05, h * 0.9], [l * 0.15, w * 0.05, leg + (h - leg) * 0.925], SCREEN);
    });
}

/// A fish tank: glass, water, gravel, plants and a lit lid.
pub(super) fn aquarium(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let frame = b.choose(&[BLACK_PLASTIC, b.style.wood, SILVER_METAL]);
    let (t, lid) = ((x * 0.04).min(0.008), h * 0.08);
    let rim = h - lid;
    b.block("base", [-x, -y, 0.0], [x, y, h * 0.04], frame);
    let bottom = h * 0.04;
    let panes = [
        ([x - 2.0 * t, -y + t, bottom], [x - t, y - t, rim]),
        ([-x + t, -y + t, bottom], [-x + 2.0 * t, y - t, rim]),
        ([-x + 2.01 * t, -y + t, bottom], [x - 2.01 * t, -y + 2.0 * t, rim]),
        ([-x + 2.01 * t, y - 2.0 * t, bottom], [x - 2.01 * t, y - t, rim]),
    ];
    blocks(b, "pane", &panes, GLASS);
    let (ix, iy) = (x - 2.2 * t, y - 2.2 * t);
    let gravel = bottom + h * 0.07;
    b.block("gravel", [-ix, -iy, bottom], [ix, iy, gravel], SANDSTONE);
    b.block("water", [-ix * 0.995, -iy * 0.995, gravel], [ix * 0.995, iy * 0.995, rim * 0.93], WATER);
    let mut weeds = MeshBuilder::default();
    for i in 0..12 {
        let (px, py) = (ix * b.vary(-0.85, -0.35), iy * (-0.9 + 1.8 * i as f32 / 11.0));
        let high = (rim - gravel) * b.vary(0.35, 0.8);
        let sway = ix * b.vary(-0.08, 0.08);
        weeds.leaf(
            &[[px, py, gravel], [px + sway, py, gravel + high * 0.5], [px - sway, py + sway, gravel + high]],
            |t| x * 0.04 * (1.02 - t),
            0.1,
        );
    }
    weeds.put(b, "weed", LEAF);
    let mut rocks = MeshBuilder::default();
    rocks.egg([-ix * 0.3, iy * 0.5, gravel + h * 0.06], [ix * 0.3, iy * 0.18, h * 0.12]);
    rocks.egg([-ix * 0.4, -iy * 0.4, gravel + h * 0.09], [ix * 0.25, iy * 0.12, h * 0.16]);
    rocks.put(b, "rock", ROCK);
    b.inside("basin", [ix * 0.45, 0.0, gravel], (ix * 0.45, iy * 0.9), (rim * 0.9 - gravel).max(0.0));
    b.rounded_block("lid", [-x, -y, rim], [x, y, h], lid * 0.2, frame);
    b.block("lamp", [-x * 0.3, -iy * 0.9, rim - t], [x * 0.3, iy * 0.9, rim + t * 0.5], COOL_BULB);
}

/// An aroma diffuser: a drop shape of wood or glaze with a glowing ring.
pub(super) fn diffuser(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let r = x.min(y);
    let body = b.choose(&[b.style.wood, PORCELAIN, BAMBOO, BLACK_PLASTIC, STONEWARE]);
    let split = h * 0.35;
    b.lathe("base", [0.0; 3], &[(r * 0.8, 0.0), (r * 0.97, split * 0.4), (r, split)], body);
    b.lathe("light", [0.0, 0.0, split - h * 0.005], &[(r * 0.97, 0.0), (r * 0.97, h * 0.03)], WARM_BULB);
    let cap = h - split - h * 0.02;
    b.slide([0.0, 0.0, 1.0], h, |b| {
        b.lathe(
            "cap",
            [0.0, 0.0, split + h * 0.02],
            &[
                (r, 0.0),
                (r * 0.9, cap * 0.35),
                (r * 0.4, cap * 0.75),
                (r * 0.18, cap),
                (r * 0.1, cap),
                (r * 0.1, cap * 0.8),
            ],
            body,
        );
    });
}

/// An ashtray with rests in its rim.
pub(super) fn ashtray(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let r = x.min(y);
    let mat = b.choose(&[GLASS, BROWN_GLASS, STEEL, BLACK_GLAZE, STONEWARE]);
    b.lathe("bowl", [0.0; 3], &[(r * 0.85, 0.0), (r, h * 0.75), (r * 0.8, h * 0.75), (r * 0.7, h * 0.25)], mat);
    let mut rests = MeshBuilder::default();
    for i in 0..3 {
        let curve = arc(
            Axis::Z,
            [0.0, 0.0, h * 0.8],
            (r * 0.89, r * 0.89),
            (2.094 * i as f32 + 0.2, 2.094 * i as f32 + 1.9),
            8,
        );
        rests.tube(&curve, (h * 0.19).min(r * 0.1));
    }
    rests.put(b, "rest", mat);
}

/// A globe with continents, tilted in a half ring.
pub(super) fn globe(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let stand = b.choose(&[b.style.wood, BRASS, BLACK_PLASTIC, b.style.metal]);
    let r = (x.min(y) * 0.92).min(h * 0.38);
    let at = [0.0, 0.0, h - r * 1.1];
    let sea = b.choose(&[BLUE, SKY, WALL_OCHRE]);
    let land = if sea == WALL_OCHRE { BROWN_SKIN } else { b.choose(&[GREEN, SAGE, MUSTARD]) };
    b.ball("sea", at, r * 0.98, sea);
    let mut shell = MeshBuilder::default();
    for (centre, wide, tall) in
        [(0.2_f32, 0.55_f32, 0.9_f32), (1.9, 0.8, 0.5), (3.1, 0.5, 0.7), (4.4, 0.7, 0.8), (5.3, 0.35, 0.4)]
    {
        let (up, turn) = (b.vary(-0.35, 0.5), centre + b.vary(-0.15, 0.15));
        let (a, c) = (b.vary(0.0, 6.0), b.vary(0.0, 6.0));
        shell.sheet((8, 8), |u, v| {
            let edge = 1.0 + 0.25 * (a + 9.0 * v).sine();
            let lon = turn + wide * (u - 0.5) * edge * (1.0 - (2.0 * v - 1.0).raised(2)).max(0.03).sqrt();
            let lat = up + tall * (v - 0.5) * (1.0 + 0.15 * (c + 7.0 * u).sine());
            let point = |s: f32| {
                [
                    at[0] + s * r * lat.cosine() * lon.cosine(),
                    at[1] + s * r * lat.cosine() * lon.sine(),
                    at[2] + s * r * lat.sine(),
                ]
            };
            (point(1.0), point(0.95))
        });
    }
    shell.put(b, "land", land);
    let ring = arc(Axis::X, at, (r * 1.05, r * 1.05), (1.15, 4.7124 + 0.4), 20);
    tube(b, "meridian", &ring, r * 0.04, stand);
    let foot = r * b.vary(0.55, 0.7);
    let neck = at[2] - r * 1.0;
    b.lathe(
        "foot",
        [0.0; 3],
        &[(foot, 0.0), (foot * 0.95, neck * 0.15), (r * 0.1, neck * 0.3), (r * 0.08, neck)],
        stand,
    );
    b.prism(
        "pole",
        Axis::Z,
        [at[0], at[1] + r * 0.42, at[2] + r * 0.9],
        &ngon((r * 0.04, r * 0.04), 8),
        r * 0.12,
        stand,
    );
}
