//! Game tables.

use std::f32::consts::TAU;

use crate::material::*;
use crate::solid;
use crate::solid::{Axis, Build, CORNERS, P, Proportional, SIDES, arc_outline, oval_outline};

const FELTS: &[MaterialId] = &[GREEN_FABRIC, GREEN_FABRIC, BLUE_FABRIC, RED_FABRIC, TEAL_FABRIC, NAVY_FABRIC];
const FINE_WOODS: &[MaterialId] = &[MAHOGANY, WALNUT, CHERRY, OAK, WENGE];

/// Four legs or two broad panels under a table, up to a fraction of its height.
fn stand(b: &mut Build<'_>, inset: (f32, f32), high: f32, mat: MaterialId) {
    let (x, y) = inset;
    match b.rng.below(3) {
        0 => {
            for side in SIDES {
                let at = y * side;
                b.slab("panel", [-x, at - 0.05, 0.04], [x, at + 0.05, high], mat);
                b.slab("foot", [-x * 1.12, at - 0.07, 0.0], [x * 1.12, at + 0.07, 0.05], mat);
            }
            b.slab("stretcher", [-0.06, -y, 0.2], [0.06, y, 0.32], mat);
        }
        1 => {
            let (r, tall) = (b.size.x * 0.05, b.size.z * high);
            for (sx, sy) in CORNERS {
                let [cx, cy, _] = b.p([sx * x, sy * y, 0.0]);
                b.at([cx, cy, 0.0], 0.0, |b| b.taper("leg", [0.0; 3], (r * 0.7, r * 0.7), (r, r), tall, mat));
            }
        }
        _ => {
            let r = b.size.x * 0.045;
            for (sx, sy) in CORNERS {
                let base = b.p([sx * x, sy * y, 0.0]);
                let h = b.size.z * high;
                let turned = [(r * 0.8, 0.0), (r, h * 0.1), (r * 0.6, h * 0.2), (r * 1.1, h * 0.6), (r, h)];
                b.lathe("leg", base, &turned, mat);
            }
        }
    }
}

/// An air hockey table: a white bed between low rails, with goals at its ends.
pub(super) fn air_hockey(b: &mut Build<'_>) {
    let case = b.choose(&[BLACK, BLUE, RED, ANTHRACITE, NAVY]);
    let rail = b.choose(&[BLACK_PLASTIC, BLUE_PLASTIC, RED_PLASTIC, GREY_PLASTIC]);
    let bed = b.choose(&[WHITE_PLASTIC, WHITE_PLASTIC, SKY]);
    let line = b.choose(&[RED_PLASTIC, BLUE_PLASTIC]);
    let goal = b.vary(0.26, 0.36);
    let low = b.vary(0.45, 0.58);
    stand(b, (0.72, 0.74), low + 0.02, case);
    b.slab("case", [-0.92, -0.95, low], [0.92, 0.95, 0.71], case);
    b.slab("bed", [-0.96, -0.978, 0.70], [0.96, 0.978, 0.90], bed);
    for side in SIDES {
        b.slab("rail", [0.94 * side.min(1.06 * side), -1.0, 0.64], [0.94 * side.max(1.06 * side), 1.0, 1.0], rail);
    }
    lines(b, line, goal);
    for (end, score) in SIDES.into_iter().zip([RED_PLASTIC, BLUE_PLASTIC]) {
        let (inner, outer) = (0.962 * end, 0.996 * end);
        let (y0, y1) = (inner.min(outer), inner.max(outer));
        for side in SIDES {
            let (from, to) = (goal * side, 0.95 * side);
            b.slab("rail", [from.min(to), y0, 0.66], [from.max(to), y1, 0.992], rail);
        }
        let (back, deep) = (0.976 * end, 0.988 * end);
        b.slab("goal", [-goal, back.min(deep), 0.72], [goal, back.max(deep), 0.93], score);
        b.slab("lintel", [-goal * 1.1, y0 + 0.006, 0.94], [goal * 1.1, y1 - 0.004, 0.98], rail);
    }
    b.deck("bed", [0.0, 0.0, 0.902], (0.9, 0.93));
}

/// Centre line, circles and goal lines on the bed.
fn lines(b: &mut Build<'_>, mat: MaterialId, goal: f32) {
    b.slab("line", [-0.94, -0.004, 0.89], [0.94, 0.004, 0.9015], mat);
    let ring = |b: &mut Build<'_>, y: f32, r: f32| {
        let [cx, cy, cz] = b.p([0.0, y, 0.8]);
        let radius = r * b.size.x;
        let top = b.size.z * 0.1 + 0.0012;
        b.lathe(
            "ring",
            [cx, cy, cz],
            &[(radius, 0.0), (radius, top), (radius - 0.008, top), (radius - 0.008, 0.0)],
            mat,
        );
    };
    ring(b, 0.0, 0.16);
    let r = goal * 0.42;
    for side in SIDES {
        ring(b, side * 0.62, r);
    }
}

/// A table football: rods with players above a green field.
pub(super) fn foosball(b: &mut Build<'_>) {
    let wood = b.choose(&[BLACK, WALNUT, OAK, ANTHRACITE, MAHOGANY, BLUE]);
    let edge = b.choose(&[OAK, WALNUT, STEEL, BLACK]);
    let teams = b.choose(&[(RED_PLASTIC, BLUE_PLASTIC), (YELLOW_PLASTIC, BLACK_PLASTIC), (WHITE_PLASTIC, RED_PLASTIC)]);
    let low = b.vary(0.5, 0.6);
    let w = 0.7;
    stand(b, (w * 0.85, 0.84), low + 0.03, wood);
    b.slab("case", [-w, -0.99, low], [w, 0.99, 0.76], wood);
    b.slab("field", [-w + 0.03, -0.88, 0.75], [w - 0.03, 0.88, 0.80], GREEN_PLASTIC);
    for side in SIDES {
        let wall = |a: f32, c: f32| (a * side).min(c * side)..(a * side).max(c * side);
        let (x, y) = (wall(w - 0.04, w), wall(0.87, 0.99));
        b.slab("wall", [x.start, -0.87, 0.755], [x.end, 0.87, 0.97], wood);
        b.slab("end", [-w, y.start, 0.758], [w, y.end, 0.975], wood);
        b.slab("ledge", [-w - 0.01, y.start, 0.974], [w + 0.01, y.end + 0.008 * side.max(0.0), 1.0], edge);
        let goal = wall(0.862, 0.872);
        b.slab("goal", [-0.2, goal.start, 0.79], [0.2, goal.end, 0.9], BLACK_PLASTIC);
        b.top("ledge", b.p([0.0, 0.93 * side, 1.0]), (b.size.x * w / 2.0 - 0.01, b.size.y * 0.024));
    }
    b.slab("line", [-w + 0.035, -0.006, 0.79], [w - 0.035, 0.006, 0.802], WHITE_PLASTIC);
    for (i, count) in [1, 2, 3, 5, 5, 3, 2, 1].into_iter().enumerate() {
        let y = -0.77 + 1.54 * i as f32 / 7.0;
        let (hand, mat) = if matches!(i, 0 | 1 | 3 | 5) { (1.0, teams.0) } else { (-1.0, teams.1) };
        rod(b, y, hand, count, mat);
    }
}

/// A rod across the table with its handle and players.
fn rod(b: &mut Build<'_>, y: f32, hand: f32, count: usize, mat: MaterialId) {
    let z = 0.925;
    b.pole("rod", [-0.86 * hand, y, z], [0.9 * hand, y, z], 0.008, CHROME);
    b.pole("grip", [0.8 * hand, y, z], [hand, y, z], 0.016, RUBBER);
    let (tall, deep) = (b.size.z * 0.1, b.size.y * 0.009);
    let mut boxes: Vec<(P, P)> = Vec::new();
    for k in 0..count {
        let x = (k as f32 - (count - 1) as f32 / 2.0) * 1.0 / (count as f32).max(2.0);
        let [cx, cy, cz] = b.p([x, y, z]);
        let mut part = |half: f32, from: f32, to: f32, thick: f32| {
            boxes.push(([cx - half, cy - thick, cz + from * tall], [cx + half, cy + thick, cz + to * tall]));
        };
        part(0.014, -0.35, 0.3, deep);
        part(0.008, 0.28, 0.62, deep * 0.7);
        part(0.01, -1.1, -0.33, deep * 0.75);
    }
    solid::blocks(b, "players", &boxes, mat);
}

/// A billiard table: felt between cushions, six pockets, turned or square legs.
pub(super) fn pool(b: &mut Build<'_>) {
    let (wood, felt) = (b.one_of(FINE_WOODS), b.one_of(FELTS));
    let leather = b.choose(&[BLACK_LEATHER, BROWN_LEATHER, BRASS]);
    let (hx, hy, h) = solid::half_dims(b);
    let r = 0.042 * 2.0 * hx.min(hy);
    let rim = r * 1.45;
    let (px, py) = (hx - rim, hy - rim);
    let bed = h * 0.93;
    let under = b.vary(0.62, 0.72) * h;
    stand(b, ((px - 2.6 * r) / hx, (py - 3.2 * r) / hy), under / h + 0.02, wood);
    b.block("body", [-px + 1.16 * r, -py + 1.16 * r, under], [px - 1.16 * r, py - 1.16 * r, bed - 0.03], wood);
    slate(b, (px, py, r), (bed - 0.04, bed), felt);
    let top = h - 0.004;
    let (in_x, in_y) = (hx - 1.8 * r, hy - 1.8 * r);
    let cushion = (0.6 * r).max(0.004);
    for side in SIDES {
        for half in SIDES {
            let (y0, y1) = (1.25 * r, py - 1.25 * r);
            let (a, c) = ((y0 * half).min(y1 * half), (y0 * half).max(y1 * half));
            let (low, high) = ((in_x * side).min(hx * side), (in_x * side).max(hx * side));
            b.block("rail", [low, a, under + 0.03], [high, c, top], wood);
            wedge(b, side * in_x, side * (in_x - cushion), (a + 0.4 * r, c - 0.4 * r), (bed, top - 0.003), felt);
        }
        let (low, high) = ((in_y * side).min(hy * side), (in_y * side).max(hy * side));
        b.block("rail", [-px + 1.25 * r, low, under + 0.03], [px - 1.25 * r, high, top], wood);
        b.at([0.0; 3], TAU / 4.0, |b| {
            let reach = px - 1.65 * r;
            wedge(b, side * in_y, side * (in_y - cushion), (-reach, reach), (bed, top - 0.003), felt);
        });
    }
    for (x, y) in [(1.0, 1.0), (1.0, 0.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, 0.0), (-1.0, -1.0)] {
        pocket(b, [x * px, y * py], r, h, leather);
    }
    b.top("bed", [0.0, 0.0, bed], (px - 1.48 * r - 0.004, in_y - cushion - 0.01));
}

/// The bed of a billiard table with openings for its pockets.
fn slate(b: &mut Build<'_>, (px, py, r): (f32, f32, f32), (low, high): (f32, f32), felt: MaterialId) {
    let (bx, by) = (px + 0.3 * r, py + 0.3 * r);
    let half = [
        (bx, -py + 1.8 * r),
        (bx, -1.1 * r),
        (px - 1.1 * r, -1.1 * r),
        (px - 1.1 * r, 1.1 * r),
        (bx, 1.1 * r),
        (bx, py - 1.8 * r),
        (px - 1.8 * r, by),
    ];
    let other = half.map(|(x, y)| (-x, -y));
    b.prism("bed", Axis::Z, [0.0, 0.0, low], &[half, other].concat(), high - low, felt);
}

/// A cushion along Y, from the rail at one X to its nose at another.
fn wedge(b: &mut Build<'_>, x: f32, nose: f32, (y0, y1): (f32, f32), (z0, z1): (f32, f32), felt: MaterialId) {
    let short = (x - nose).abs();
    let (a, c) = (y0 + short, y1 - short);
    let deep = z0 + (z1 - z0) * 0.55;
    b.hull(
        "cushion",
        &[
            [x, y0, z1],
            [x, y1, z1],
            [x, y0, z0 - 0.003],
            [x, y1, z0 - 0.003],
            [nose, a, z1],
            [nose, c, z1],
            [nose, a, deep],
            [nose, c, deep],
        ],
        felt,
    );
}

/// A pocket: a cup under a leather rim.
fn pocket(b: &mut Build<'_>, at: [f32; 2], r: f32, top: f32, mat: MaterialId) {
    let tall = (r * 3.0).min(top * 0.4);
    let base = top - tall;
    let profile = [
        (r * 0.9, 0.0),
        (r * 1.12, tall * 0.75),
        (r * 1.45, tall * 0.8),
        (r * 1.45, tall),
        (r, tall),
        (r * 0.8, 0.006),
    ];
    b.lathe("pocket", [at[0], at[1], base], &profile, mat);
    b.inside("pocket", [at[0], at[1], base + 0.006], (r * 0.5, r * 0.5), tall);
}

/// A table tennis table: two halves with lines, a net, legs on wheels.
pub(super) fn ping_pong(b: &mut Build<'_>) {
    let top = b.choose(&[BLUE, FOREST, GREEN, NAVY, ANTHRACITE]);
    let metal = b.choose(&[BLACK_METAL, SILVER_METAL, BLUE_METAL]);
    let leg = b.vary(0.25, 0.8);
    let (low, high) = (0.795, 0.833);
    for side in SIDES {
        let span = |a: f32, c: f32| ((a * side).min(c * side), (a * side).max(c * side));
        let (y0, y1) = span(0.0015, 1.0);
        b.slab("top", [-0.985, y0, low], [0.985, y1, high], top);
        let (e0, e1) = span(0.982, 0.9985);
        b.slab("line", [-0.984, e0, low + 0.005], [0.984, e1, high + 0.0015], WHITE);
        b.slab(
            "line",
            [-0.002, y0.min(y1 * 0.97).max(-0.98), low + 0.005],
            [0.002, y1.min(0.98), high + 0.0012],
            WHITE,
        );
        for edge in SIDES {
            let (x0, x1) = ((0.958 * edge).min(0.984 * edge), (0.958 * edge).max(0.984 * edge));
            b.slab("line", [x0, (y0 + 0.001).max(-0.98), low + 0.006], [x1, y1.min(0.98), high + 0.0009], WHITE);
            b.pole("leg", [0.7 * edge, leg * side, 0.05], [0.7 * edge, leg * side, low + 0.01], 0.022, metal);
            b.wheel("wheel", Axis::Y, [0.7 * edge, leg * side, 0.0], (b.size.z * 0.06, 0.025), RUBBER);
        }
        b.slab("apron", [-0.93, side * leg - 0.012, low - 0.06], [0.93, side * leg + 0.012, low + 0.005], metal);
        b.pole("brace", [-0.7, leg * side, 0.28], [0.7, leg * side, 0.28], 0.014, metal);
        b.pole("post", [0.992 * side, 0.0, low - 0.03], [0.992 * side, 0.0, 1.0], 0.006, metal);
        let (n0, n1) = (b.size.x * 0.25, b.size.y / 4.0);
        b.top("half", b.p([0.0, 0.5 * side, high + 0.0015]), (n0 * 1.9, n1 * 0.93));
    }
    b.pole("rail", [0.0, -leg, low - 0.05], [0.0, leg, low - 0.05], 0.014, metal);
    b.slab("net", [-0.995, -0.0011, high - 0.004], [0.995, 0.0011, 0.98], b.style.metal);
    b.slab("tape", [-0.996, -0.0016, 0.975], [0.996, 0.0016, 0.998], WHITE_COTTON);
}

/// A poker table: long and oval, with felt, a padded rail and cup holders.
pub(super) fn poker(b: &mut Build<'_>) {
    let (felt, wood) = (b.one_of(FELTS), b.one_of(FINE_WOODS));
    let leather = b.choose(&[BLACK_LEATHER, BROWN_LEATHER, TAN_LEATHER]);
    let (hx, hy, h) = solid::half_dims(b);
    let pad = 0.05 * hx;
    let bow = (hx / hy).min(1.0);
    let outline = |shrink: f32| {
        let (x, y) = (1.0 - shrink / hx, 1.0 - shrink / hy);
        let ends = [(1.0, 0.0), (-1.0, TAU / 2.0)];
        let half = |(end, from): (f32, f32)| {
            arc_outline((0.0, end * (y - bow * x)), (x, bow * x), (from, from + TAU / 2.0), 11)
        };
        ends.into_iter().flat_map(half).collect::<Vec<_>>()
    };
    let high = h - 2.0 * pad;
    b.plan_outline("table", (0.88, high / h), &outline(pad), wood);
    b.plan_outline("felt", (0.9, (high + pad * 0.6) / h), &outline(pad * 2.2), felt);
    let rail: Vec<P> = outline(pad).iter().map(|&(x, y)| [x * hx, y * hy, h - pad]).collect();
    solid::hoop(b, "rail", &rail, pad * 0.995, leather);
    let seats = b.rng.count(8, 10);
    for (x, y) in oval_outline((0.0, 0.0), (1.0 - 5.0 * pad / hx, 1.0 - 5.0 * pad / hy), seats) {
        let z = high + pad * 0.6;
        let r = 0.035 * hx;
        b.lathe(
            "cup_holder",
            [x * hx, y * hy, z - 0.01],
            &[(r * 1.3, 0.0), (r * 1.3, 0.013), (r, 0.013), (r, 0.004)],
            BRASS,
        );
    }
    if b.rng.chance(0.5) {
        stand(b, (0.6, 0.62), 0.885, wood);
    } else {
        for side in SIDES {
            b.slab("pillar", [-0.2, 0.5 * side - 0.09, 0.06], [0.2, 0.5 * side + 0.09, 0.885], wood);
            b.pad("foot", [-0.62, 0.5 * side - 0.12, 0.0], [0.62, 0.5 * side + 0.12, 0.08], 0.01, wood);
        }
        b.slab("stretcher", [-0.05, -0.5, 0.2], [0.05, 0.5, 0.3], wood);
    }
    b.top("felt", [0.0, 0.0, high + pad * 0.6], (hx * 0.45, (hy - hx).max(hx * 0.3)));
}
