//! Cooked or assembled dishes with their plate, bowl or cup.

use std::f32::consts::TAU;

use vc_graph::portable::Portable;

use super::fruit::berry;
use crate::material::*;
use crate::solid::{
    Axis, Build, P, dims, ear, level_oval, loft_columns, lump, planar_tube, rounded_by_share, rounded_ring, spun,
    sweep, tub, turn, vessel_profile,
};

/// Builds a plate that fills the footprint and returns the height of its floor.
fn plate(b: &mut Build<'_>, z: f32) -> f32 {
    let (x, y, _) = dims(b);
    let mat = b.style.crockery;
    let (hx, hy) = (x / 2.0, y / 2.0);
    let t = z * 0.08;
    let ring = |z: f32, k: f32| level_oval([0.0, 0.0, z], (hx * k, hy * k));
    let rings = [
        ring(0.0, 0.6),
        ring(z * 0.3, 0.7),
        ring(z * 0.85, 0.99),
        ring(z, 1.0),
        ring(z * 0.9, 0.97),
        ring(z * 0.3 + t, 0.68),
        ring(t, 0.58),
    ];
    loft_columns(b, "plate", &rings, mat);
    t
}

/// A deep bowl that fills the footprint up to height `h`, with content whose surface is at `fill`.
fn bowl(b: &mut Build<'_>, h: f32, fill: f32, content: MaterialId) {
    let (x, y, _) = dims(b);
    let mat = b.style.crockery;
    let (hx, hy) = (x / 2.0, y / 2.0);
    let ring = |z: f32, k: f32| level_oval([0.0, 0.0, z], (hx * k, hy * k));
    let rings = [
        ring(0.0, 0.5),
        ring(h * 0.08, 0.52),
        ring(h * 0.35, 0.82),
        ring(h, 1.0),
        ring(h, 0.95),
        ring(h * 0.4, 0.77),
        ring(h * 0.12, 0.45),
    ];
    loft_columns(b, "bowl", &rings, mat);
    loft_columns(
        b,
        "content",
        &[ring(h * 0.14, 0.44), ring(h * 0.4, 0.78), ring(fill, 0.8 + 0.17 * (fill / h - 0.4))],
        content,
    );
}

/// Soup, stew, noodles and salad in a bowl.
pub(super) fn bowlful(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let (content, bits): (MaterialId, &[MaterialId]) = match b.class {
        "soup" => (b.choose(&[TOMATO, MUSTARD, LIGHT_LEAF, ORANGE_SKIN]), &[LEAF, ORANGE_SKIN, CREAM_FOOD]),
        "stew" => (b.choose(&[COOKED_MEAT, TOMATO]), &[COOKED_MEAT, ORANGE_SKIN, PALE_FLESH, LEAF]),
        "salad" => (LIGHT_LEAF, &[RED_SKIN, LEAF, LIGHT_LEAF, PETAL_WHITE]),
        _ => (PALE_FLESH, &[PALE_FLESH, HAY]),
    };
    let heap = matches!(b.class, "salad" | "pasta");
    let h = if heap { z * 0.72 } else { z * 0.94 };
    let fill = h * if heap { 0.7 } else { 0.75 };
    bowl(b, h, fill, content);
    let count = match b.class {
        "soup" => 6,
        "pasta" => 9,
        _ => 15,
    };
    if heap {
        lump(b, "heap", [0.0, 0.0, fill], [hx * 0.7, hy * 0.7, (z - fill) * 0.8], 0.06, content);
    }
    for i in 0..count {
        let (s, c) = (2.4 * i as f32).sine_cosine();
        let k = ((i as f32 + 0.4) / count as f32).sqrt();
        let r = hx * if b.class == "soup" { 0.06 } else { 0.14 };
        let top = if heap { z - r * 0.7 - (z - fill) * 0.75 * k } else { (fill + r * 0.2).min(z - r) };
        let centre = [(hx * 0.82 - r) * k * c, (hy * 0.82 - r) * k * s, top];
        let mat = bits[i % bits.len()];
        match b.class {
            "salad" if mat != RED_SKIN => {
                let w = r * 1.6;
                let up = (centre[2] + w * 0.4).min(z);
                b.hull(
                    "leaf",
                    &[
                        [centre[0] - w, centre[1], centre[2] - w * 0.3],
                        [centre[0] + w * c, centre[1] + w * s, up],
                        [centre[0], centre[1] + w, centre[2]],
                        [centre[0] + w * 0.3, centre[1] - w, up],
                        [centre[0], centre[1], centre[2] - w * 0.2],
                    ],
                    mat,
                );
            }
            "pasta" => strand(b, centre, r * 1.6, (i as f32, z), mat),
            _ => berry(b, centre, r, mat),
        }
    }
    if b.class == "pasta" {
        let r = hx * 0.36;
        lump(b, "sauce", [0.0, 0.0, z - z * 0.13], [r, r, z * 0.13], 0.08, TOMATO);
    }
}

/// A bent strand of pasta around `centre`, below `top`.
fn strand(b: &mut Build<'_>, centre: P, r: f32, (turn, top): (f32, f32), mat: MaterialId) {
    let w = r * 0.14;
    let points: Vec<P> = (0..7)
        .map(|k| {
            let (s, c) = (turn * 1.3 + 0.8 * k as f32).sine_cosine();
            [centre[0] + r * c, centre[1] + r * s, (centre[2] + w * s).min(top - w)]
        })
        .collect();
    planar_tube(b, "strand", &points, w, [0.0, 0.0, 1.0], mat);
}

/// A plate with a main dish: meat, potatoes or rice, and vegetables.
pub(super) fn meal(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let floor = plate(b, z * 0.42);
    let room = z - floor;
    let main = b.choose(&[COOKED_MEAT, CRUST, ORANGE_SKIN]);
    lump(b, "main", [hx * 0.22, -hy * 0.12, floor + room * 0.32], [hx * 0.38, hy * 0.42, room * 0.33], 0.08, main);
    let side = b.choose(&[RICE, PALE_FLESH, CREAM_FOOD]);
    lump(b, "side", [-hx * 0.3, -hy * 0.25, floor + room * 0.5], [hx * 0.3, hy * 0.32, room * 0.5], 0.1, side);
    let green = b.choose(&[LEAF, ORANGE_SKIN, LIGHT_LEAF]);
    for i in 0..9 {
        let (s, c) = (2.4 * i as f32).sine_cosine();
        let k = (i as f32 / 9.0).sqrt();
        let r = hx.min(hy) * 0.09;
        berry(
            b,
            [-hx * 0.1 + hx * 0.26 * k * c, hy * 0.4 + hy * 0.16 * k * s, floor + r * 0.9 + room * 0.2 * (1.0 - k)],
            r,
            green,
        );
    }
}

/// A pizza: crust, sauce, cheese and slices on top.
pub(super) fn pizza(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let r = x.min(y) / 2.0;
    turn(b, "crust", [0.0; 3], (r, z * 0.8), &[(0.94, 0.0), (1.0, 0.4), (0.98, 0.9), (0.93, 1.0), (0.89, 0.6)], CRUST);
    b.cylinder("sauce", [0.0, 0.0, z * 0.3], r * 0.9, z * 0.22, TOMATO);
    lump(b, "cheese", [0.0, 0.0, z * 0.48], [r * 0.86, r * 0.86, z * 0.14], 0.03, CHEESE);
    let (topping, green) =
        b.choose(&[(RED_SKIN, LEAF), (COOKED_MEAT, LEAF), (PALE_FLESH, DARK_LEAF), (RED_SKIN, BLACK)]);
    for i in 0..11 {
        let (s, c) = (2.4 * i as f32).sine_cosine();
        let k = 0.76 * ((i as f32 + 0.4) / 11.0).sqrt();
        let at = [r * k * c, r * k * s, z * 0.55];
        if i % 3 == 2 {
            let w = r * 0.07;
            b.hull(
                "leaf",
                &[
                    [at[0] - w, at[1], at[2]],
                    [at[0], at[1] + w * 0.5, at[2]],
                    [at[0] + w, at[1], z * 0.75],
                    [at[0], at[1] - w * 0.5, at[2]],
                    [at[0], at[1], z * 0.85],
                ],
                green,
            );
        } else {
            b.cylinder("slice", at, r * 0.1, z * 0.2, topping);
        }
    }
    for i in 0..4 {
        b.at([0.0; 3], TAU * i as f32 / 8.0, |b| {
            b.block("cut", [-r * 0.89, -r * 0.008, z * 0.5], [r * 0.89, r * 0.008, z * (0.6 + 0.02 * i as f32)], TOMATO)
        });
    }
}

/// Layers between two slices of toast, cut along the diagonal or whole.
pub(super) fn sandwich(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let layers = [
        (0.0, 0.26, 0.97, CRUST, "bread"),
        (0.27, 0.4, 1.0, LEAF, "lettuce"),
        (0.41, 0.52, 0.95, PETAL_PINK, "ham"),
        (0.53, 0.615, 0.98, CHEESE, "cheese"),
        (0.62, 0.73, 0.92, RED_SKIN, "tomato"),
        (0.74, 1.0, 0.97, CRUST, "bread"),
    ];
    let triangle = b.rng.chance(0.5);
    // Layers shift towards the centre of the triangle.
    let shift = if triangle { 0.05 } else { 0.0 };
    for (low, high, k, mat, name) in layers {
        let plan = if triangle {
            vec![(-hx * k, -hy * k), (hx * k, -hy * k), (hx * k, -hy * k + hy * 0.1), (-hx * k, hy * k)]
        } else {
            rounded_by_share((hx * k, hy * k), 0.2)
        };
        b.prism(name, Axis::Z, [0.0, 0.0, z * low], &plan, z * (high - low), mat);
        if name == "bread" {
            let crumb: Vec<_> = plan.iter().map(|p| (p.0 * 0.9 - shift * hx, p.1 * 0.9 - shift * hy)).collect();
            let t = (z * 0.012).min(0.001);
            let (from, tall) =
                if low > 0.5 { (z * low - t, z * (high - low)) } else { (z * low + t, z * (high - low)) };
            b.prism("crumb", Axis::Z, [0.0, 0.0, from], &crumb, tall, CRUMB);
        }
    }
}

/// A bun with a patty, cheese and leaves.
pub(super) fn hamburger(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let layer =
        |b: &mut Build<'_>, name: &str, (low, high): (f32, f32), k: f32, profile: &[(f32, f32)], mat: MaterialId| {
            spun(b, name, ([-hx * k, -hy * k, z * low], [hx * k, hy * k, z * high]), profile, false, mat);
        };
    let puck: &[(f32, f32)] = &[(0.9, 0.0), (1.0, 0.3), (1.0, 0.7), (0.9, 1.0)];
    layer(b, "bun", (0.0, 0.25), 0.95, puck, CRUST);
    layer(b, "patty", (0.24, 0.42), 1.0, puck, COOKED_MEAT);
    let s = hx * 0.93;
    b.block("cheese", [-s * 0.98, -hy * 0.9, z * 0.415], [s * 0.98, hy * 0.9, z * 0.45], CHEESE);
    layer(b, "tomato", (0.44, 0.51), 0.9, puck, RED_SKIN);
    for i in 0..7 {
        let (s, c) = (TAU * i as f32 / 7.0).sine_cosine();
        let at = |k: f32, turn: f32, h: f32| [hx * (k * c - turn * s), hy * (k * s + turn * c), z * h];
        b.hull(
            "lettuce",
            &[
                at(0.3, -0.2, 0.5),
                at(0.3, 0.2, 0.5),
                at(0.88, -0.35, 0.5),
                at(0.92, 0.0, 0.45),
                at(0.88, 0.35, 0.53),
                at(0.5, 0.0, 0.56),
            ],
            LIGHT_LEAF,
        );
    }
    layer(
        b,
        "bun",
        (0.54, 1.0),
        0.97,
        &[(0.9, 0.0), (1.0, 0.15), (0.98, 0.4), (0.82, 0.7), (0.5, 0.92), (0.0, 1.0)],
        CRUST,
    );
    for i in 0..12 {
        let (s, c) = (2.4 * i as f32).sine_cosine();
        let k = 0.6 * ((i as f32 + 0.4) / 12.0).sqrt();
        let r = hx * 0.035;
        berry(b, [hx * k * c, hy * k * s, z * (0.54 + 0.46 * (1.0 - k * k * 0.75).sqrt()) - r], r, CRUMB);
    }
}

/// A sausage in a split bun with a wave of mustard.
pub(super) fn hot_dog(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let half = [(0.0, 0.0), (0.6, 0.03), (0.92, 0.15), (1.0, 0.4), (1.0, 0.6), (0.92, 0.85), (0.6, 0.97), (0.0, 1.0)];
    for side in [-1.0_f32, 1.0] {
        let (x0, x1) = if side < 0.0 { (-hx, -hx * 0.05) } else { (hx * 0.05, hx) };
        spun(b, "bun", ([x0, -hy * 0.93, 0.0], [x1, hy * 0.93, z * 0.8]), &half, true, CRUST);
    }
    b.block("bun", [-hx * 0.5, -hy * 0.8, z * 0.02], [hx * 0.5, hy * 0.8, z * 0.3], CRUST);
    let r = (hx * 0.45).min(z * 0.33);
    let at = |k: f32, w: f32| ([0.0, hy * k, z * 0.93 - r], w, w);
    sweep(
        b,
        "sausage",
        &[at(-1.0, r * 0.3), at(-0.94, r * 0.85), at(-0.85, r), at(0.85, r), at(0.94, r * 0.85), at(1.0, r * 0.3)],
        [0.0, 0.0, 1.0],
        COOKED_MEAT,
    );
    let sauce = b.choose(&[YELLOW_SKIN, TOMATO]);
    let w = r * 0.16;
    let points: Vec<P> = (0..13)
        .map(|k| [r * 0.4 * if k % 2 == 0 { 1.0 } else { -1.0 }, hy * 0.85 * (k as f32 / 6.0 - 1.0), z - w])
        .collect();
    planar_tube(b, "sauce", &points, w, [0.0, 0.0, 1.0], sauce);
}

/// Rolls of rice and fish on a board.
pub(super) fn sushi(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let board = b.choose(&[b.style.wood, BAMBOO, SLATE_TILE, BLACK]);
    let low = z * 0.25;
    b.block("board", [-hx, -hy, z * 0.1], [hx, hy, low], board);
    for side in [-0.7, 0.7] {
        b.block("foot", [-hx * 0.9, hy * side - hy * 0.06, 0.0], [hx * 0.9, hy * side + hy * 0.06, z * 0.12], board);
    }
    let (columns, room) = (5, z - low);
    for i in 0..columns {
        let at = hy * 0.8 * (2.0 * i as f32 / (columns - 1) as f32 - 1.0);
        let r = (hy * 0.16).min(hx * 0.3).min(room * 0.8);
        b.cylinder("nori", [hx * 0.5, at, low], r, room * 0.9, BLACK);
        b.cylinder("rice", [hx * 0.5, at, low + room * 0.1], r * 0.88, room * 0.83, RICE);
        b.cylinder(
            "filling",
            [hx * 0.5, at, low + room * 0.2],
            r * 0.38,
            room * 0.78,
            [ORANGE_SKIN, GREEN_SKIN, RED_SKIN][i % 3],
        );
        lump(b, "rice", [-hx * 0.4, at, low + room * 0.33], [hx * 0.42, r * 0.85, room * 0.34], 0.02, RICE);
        b.rounded_block(
            "fish",
            [-hx * 0.86, at - r * 0.8, low + room * 0.55],
            [hx * 0.05, at + r * 0.8, low + room * 0.8],
            room * 0.1,
            [ORANGE_SKIN, PETAL_PINK, PALE_FLESH][(i + 1) % 3],
        );
    }
}

/// Layers of pasta and sauce in a rectangular dish.
pub(super) fn lasagna(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let dish = b.choose(&[PORCELAIN, RED_GLAZE, BLUE_GLAZE, b.style.crockery]);
    tub(
        b,
        "dish",
        &[(0.0, hx * 0.88, hy * 0.9), (z * 0.85, hx * 0.96, hy * 0.96), (z * 0.9, hx, hy)],
        0.25,
        z * 0.07,
        dish,
    );
    b.rounded_block("lasagna", [-hx * 0.89, -hy * 0.91, z * 0.05], [hx * 0.89, hy * 0.91, z * 0.86], z * 0.1, CHEESE);
    for i in 0..12 {
        let (s, c) = (2.4 * i as f32).sine_cosine();
        let k = 0.8 * ((i as f32 + 0.4) / 12.0).sqrt();
        let r = hx * b.vary(0.1, 0.2);
        lump(
            b,
            "crust",
            [(hx - r) * k * c, (hy - r) * k * s, z * 0.86],
            [r, r, z * 0.08],
            0.1,
            if i % 3 == 0 { TOMATO } else { CRUST },
        );
    }
}

/// Potato chips in a heap, on a plate or in a paper bag.
pub(super) fn french_fries(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let floor = plate(b, z * 0.3);
    let w = z * 0.055;
    let mound = (z - floor) * 0.42;
    lump(b, "fries", [0.0, 0.0, floor + mound], [hx * 0.55, hy * 0.55, mound], 0.1, YELLOW_SKIN);
    for i in 0..34 {
        let (s, c) = (2.4 * i as f32).sine_cosine();
        let k = ((i as f32 + 0.5) / 34.0).sqrt();
        let low = floor + w + (z - floor - 3.0 * w) * (1.0 - k);
        let centre = [hx * 0.6 * k * c, hy * 0.6 * k * s, low];
        let (ds, dc) = (4.1 * i as f32).sine_cosine();
        let reach = hx * 0.26;
        let tilt = w * ds;
        let ends: Vec<P> = [-1.0_f32, 1.0]
            .iter()
            .flat_map(|&e| {
                let p = [centre[0] + e * reach * dc, centre[1] + e * reach * ds, centre[2] + e * tilt];
                [
                    [p[0] - w * ds, p[1] + w * dc, p[2] - w * 0.8],
                    [p[0] + w * ds, p[1] - w * dc, p[2] - w * 0.8],
                    [p[0] - w * ds, p[1] + w * dc, p[2] + w],
                    [p[0] + w * ds, p[1] - w * dc, p[2] + w],
                ]
            })
            .collect();
        b.hull("fry", &ends, if i % 4 == 0 { CRUST } else { YELLOW_SKIN });
    }
}

/// Hot and cold drinks: a full glass or cup.
pub(super) fn drink(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let r = x.min(y) / 2.0;
    let (cup, liquid): (MaterialId, MaterialId) = match b.class {
        "water" => (GLASS, WATER),
        "coffee" => (b.choose(&[b.style.crockery, PORCELAIN, WHITE_PAPER]), CHOCOLATE),
        "tea" => (b.choose(&[b.style.crockery, GLASS, PORCELAIN]), b.choose(&[BROWN_GLASS, MUSTARD])),
        "hot_chocolate" => (b.choose(&[b.style.crockery, RED_GLAZE, STONEWARE]), BROWN_SKIN),
        _ => (GLASS, b.choose(&[PETAL_PINK, GREEN_SKIN, PURPLE_SKIN, ORANGE_SKIN])),
    };
    let straw = b.class == "smoothie";
    let h = if straw { z * 0.8 } else { z };
    let eared = matches!(b.class, "coffee" | "tea" | "hot_chocolate") && cup != WHITE_PAPER;
    let r = if eared { r * 0.8 } else { r };
    let shape: [(f32, f32); 4] = if eared {
        b.choose(&[
            [(0.65, 0.0), (0.8, 0.2), (0.95, 0.6), (1.0, 1.0)],
            [(0.9, 0.0), (1.0, 0.08), (1.0, 0.5), (1.0, 1.0)],
        ])
    } else {
        [(0.78, 0.0), (0.82, 0.1), (0.92, 0.6), (1.0, 1.0)]
    };
    let outside: Vec<_> = shape.iter().map(|p| (p.0 * r, p.1 * h)).collect();
    let t = r * 0.07;
    b.lathe("cup", [0.0; 3], &vessel_profile(&outside, t), cup);
    let level_ = h * if straw { 0.93 } else { 0.85 };
    let inner = [
        (outside[0].0 - t, t * 0.9),
        (outside[2].0 - t * 0.9, h * 0.6),
        (outside[2].0 + (outside[3].0 - outside[2].0) * 0.6 - t * 0.8, level_),
    ];
    b.lathe("drink", [0.0; 3], &inner, liquid);
    if eared {
        ear(b, (outside[2].0 * 0.96, r * 1.5), (h * 0.25, h * 0.85), r * 0.1, cup);
    }
    match b.class {
        "hot_chocolate" => (0..5).for_each(|i| {
            let (s, c) = (TAU * i as f32 / 5.0).sine_cosine();
            berry(b, [r * 0.42 * c, r * 0.42 * s, level_], r * 0.2, PETAL_WHITE);
        }),
        "coffee" if b.rng.chance(0.5) => b.cylinder("foam", [0.0, 0.0, level_ - h * 0.01], r * 0.78, h * 0.03, CRUMB),
        "tea" => {
            planar_tube(
                b,
                "string",
                &[[r * 0.4, -r * 0.3, level_], [r * 0.8, -r * 0.55, h * 0.99]],
                r * 0.02,
                [0.0, 0.0, 1.0],
                WHITE_PAPER,
            );
        }
        "smoothie" => {
            let w = r * 0.1;
            let top = r * 0.6;
            planar_tube(
                b,
                "straw",
                &[[-r * 0.3, 0.0, h * 0.3], [top * 0.6, 0.0, z * 0.9], [top, 0.0, z - w]],
                w,
                [0.0, 1.0, 0.0],
                RED_PLASTIC,
            );
            berry(b, [-r * 0.8, 0.0, h], r * 0.18, RED_SKIN);
        }
        _ => {}
    }
}

/// A cube of ice.
pub(super) fn ice(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let round = z * b.vary(0.15, 0.25);
    b.rounded_block("ice", [-x / 2.0, -y / 2.0, 0.0], [x / 2.0, y / 2.0, z], round, FROSTED_GLASS);
}

/// An upright tea bag with its string and label.
pub(super) fn tea_bag(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let ring = |z: f32, kx: f32, ky: f32| rounded_ring(z, (hx * kx, hy * ky), 0.2);
    loft_columns(
        b,
        "bag",
        &[ring(0.0, 0.3, 1.0), ring(z * 0.3, 1.0, 1.0), ring(z * 0.6, 0.8, 1.0), ring(z * 0.8, 0.25, 0.85)],
        CREAM_PAPER,
    );
    let t = (hx * 0.2).min(hy * 0.02);
    b.rod("string", [0.0, 0.0, z * 0.78], [0.0, hy * 0.3, z * 0.97], t, WHITE_PAPER);
    let tag = b.choose(&[RED_CARD, GREEN_CARD, YELLOW_CARD]);
    b.block("tag", [-hx * 0.3, hy * 0.1, z * 0.84], [hx * 0.3, hy * 0.5, z], tag);
}
