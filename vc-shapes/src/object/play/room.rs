//! Play furniture: houses, kitchens, tents, mats, pens, baby seats, easels.

use std::f32::consts::FRAC_PI_2;

use vc_graph::portable::Portable;

use crate::material::*;
use crate::object::palette::*;
use crate::solid::{Axis, Build, CORNERS, Proportional, SIDES, arc_outline, oval_outline, rounded_between};

/// A furnished dolls' house, open in front or closed by two wings.
pub(super) fn dollhouse(b: &mut Build<'_>) {
    let wall = b.choose(&[WHITE, CREAM, DUSTY_ROSE, SKY, BIRCH]);
    let roof = b.choose(&[RED, NAVY, TERRACOTTA, SAGE]);
    let floors = if b.size.z > 0.85 { 3 } else { 2 };
    let eaves = 0.72;
    let front = 0.86;
    b.slab("base", [-1.0, -1.0, 0.0], [0.97, 1.0, 0.03], b.style.wood);
    b.slab("back", [-0.98, -0.9, 0.03], [-0.92, 0.9, eaves], wall);
    for y in SIDES {
        b.slab("side", [-0.98, y * 0.93 - 0.03, 0.03], [front, y * 0.93 + 0.03, eaves], wall);
    }
    let pitch = (eaves - 0.03) / floors as f32;
    for i in 0..floors {
        let z = 0.03 + pitch * i as f32;
        if i > 0 {
            b.slab("floor", [-0.92, -0.9, z - 0.012], [front - 0.02, 0.9, z], b.style.wood);
        }
        b.slab("wall", [-0.92, -0.02, z], [front - 0.1, 0.02, z + pitch - 0.013], CREAM);
        for side in SIDES {
            let name = format!("room_{}", 2 * i + if side > 0.0 { 1 } else { 2 });
            b.inner_floor(&name, [-0.08, side * 0.32, z], (0.62, 0.26), pitch * 0.85);
            let at = side * 0.72;
            furniture(b, (at, z), pitch, i);
            b.slab("window", [-0.99, at - 0.1, z + pitch * 0.35], [-0.9, at + 0.1, z + pitch * 0.75], GLASS);
        }
    }
    b.slab("ceiling", [-0.99, -0.97, eaves], [front, 0.97, eaves + 0.015], wall);
    let tiles = [[-1.0, -1.0, eaves], [-1.0, 1.0, eaves], [0.97, -1.0, eaves], [0.97, 1.0, eaves]]
        .map(|[x, y, z]| [x, y, z + 0.0145]);
    let ridge = [
        [-0.6, 0.0, 0.96],
        [0.6, 0.0, 0.96],
        [-0.6, 0.6, 0.96],
        [0.6, 0.6, 0.96],
        [-0.6, -0.6, 0.96],
        [0.6, -0.6, 0.96],
    ];
    b.chunk("roof", &[tiles.as_slice(), &ridge].concat(), roof);
    b.slab("chimney", [-0.4, 0.3, 0.9], [-0.1, 0.42, 1.0], BRICK);
    b.deck("roof", [0.0, -0.15, 0.96], (0.55, 0.38));
    for side in SIDES {
        let anchor = b.p([front + 0.01, side * 0.96, 0.0]);
        b.hinge(anchor, [0.0, 0.0, side], 1.8, |b| shutter(b, side, (0.04, eaves - 0.01), floors, wall));
    }
}

/// A front wing with windows and half of the house door.
fn shutter(b: &mut Build<'_>, side: f32, z: (f32, f32), floors: usize, wall: MaterialId) {
    let (near, far) = (side * 0.005, side * 0.96);
    b.slab("front", [0.864, near.min(far), z.0], [0.92, near.max(far), z.1], wall);
    let pitch = (z.1 - z.0) / floors as f32;
    for i in 0..floors {
        let low = z.0 + pitch * (i as f32 + 0.35);
        let y = side * 0.55;
        b.slab("frame", [0.915, y - 0.17, low - 0.01], [0.935, y + 0.17, low + pitch * 0.45 + 0.01], WHITE);
        b.slab("window", [0.92, y - 0.14, low], [0.945, y + 0.14, low + pitch * 0.45], BLUE_GLASS);
    }
    b.slab(
        "door",
        [0.915, (side * 0.01).min(side * 0.18), z.0 + 0.003],
        [0.94, (side * 0.01).max(side * 0.18), z.0 + pitch * 0.75],
        RED,
    );
}

/// A bed, a table or a stove of a dolls' house, against its outer wall.
fn furniture(b: &mut Build<'_>, (y, z): (f32, f32), pitch: f32, kind: usize) {
    let (h, mat) = (pitch * 0.3, b.one_of(CLOTHS));
    let (low, high) = (y - 0.1, y + 0.1);
    match kind {
        0 => b.slab("stove", [-0.9, low, z], [-0.5, high, z + h * 1.2], WHITE),
        1 => {
            b.slab("bed", [-0.9, low, z], [0.1, high, z + h * 0.6], BIRCH);
            b.slab("cover", [-0.5, low - 0.01, z + h * 0.4], [0.08, high + 0.01, z + h * 0.75], mat);
        }
        _ => b.pad("sofa", [-0.9, low, z], [-0.4, high, z + h], 0.01, mat),
    }
}

/// A play kitchen: hob, sink, oven, cupboard and a back panel with a shelf.
pub(super) fn kitchen(b: &mut Build<'_>) {
    let (case, front) = (b.choose(&[WHITE, BIRCH, CREAM, SAGE, SKY]), b.one_of(PAINTS));
    let (top, t) = (0.52, 0.03);
    for y in SIDES {
        b.slab("side", [-0.98, y * 0.96 - 0.03, 0.0], [0.85, y * 0.96 + 0.03, top], case);
    }
    b.slab("divider", [-0.93, -0.02, 0.06], [0.84, 0.02, top], case);
    b.slab("bottom", [-0.93, -0.93, 0.04], [0.84, 0.93, 0.06], case);
    b.slab("back", [-0.98, -0.93, 0.04], [-0.93, 0.93, top], case);
    b.slab("worktop", [-1.0, -1.0, top], [0.95, 1.0, top + t], b.style.wood);
    for (name, y) in [("oven", -0.47), ("cupboard", 0.47)] {
        b.inner_floor(name, [-0.05, y, 0.06], (0.75, 0.4), 0.42);
        let (low, high, side) = (y - 0.44, y + 0.44, y.signum());
        let anchor = b.p([0.93, y + side * 0.44, 0.0]);
        let door = |b: &mut Build<'_>| {
            b.slab(name, [0.843, low, 0.05], [0.93, high, top - 0.02], front);
            b.slab("handle", [0.925, y - side * 0.36 - 0.03, 0.3], [0.98, y - side * 0.36 + 0.03, 0.42], STEEL);
            if name == "oven" {
                b.slab("window", [0.92, low + 0.14, 0.14], [0.94, high - 0.1, 0.36], BLACK_GLASS);
            }
        };
        b.hinge(anchor, [0.0, 0.0, side], FRAC_PI_2, door);
    }
    let z = top + t;
    let r = (b.size.y * 0.1).min(b.size.x * 0.18);
    for x in [-0.45, 0.4] {
        b.pole("hob", [x, -0.55, z - 0.01], [x, -0.55, z + 0.006], r, BLACK_GLASS);
        b.torus("ring", Axis::Z, [x, -0.55, z + 0.006], (r * 0.6, 0.004), SIGNAL_RED);
    }
    b.plan_outline("sink", (z - 0.02, z + 0.004), &rounded_between((-0.6, 0.3), (0.6, 0.85), (0.1, 0.06)), STEEL);
    b.plan_outline("sink", (z, z + 0.006), &rounded_between((-0.5, 0.35), (0.5, 0.8), (0.1, 0.06)), GREY_PLASTIC);
    let tap = [[-0.72, 0.57, z], [-0.72, 0.57, z + 0.1], [-0.3, 0.57, z + 0.1], [-0.25, 0.57, z + 0.07]];
    b.bent_rod("tap", &tap, b.size.z * 0.011, STEEL);
    b.deck("worktop", [0.55, -0.0, z], (0.1, 0.12));
    b.slab("back_panel", [-1.0, -0.98, z], [-0.92, 0.98, 1.0], case);
    b.slab("window", [-0.925, -0.3, z + 0.1], [-0.9, 0.3, z + 0.3], SKY);
    b.slab("shelf", [-0.92, -0.98, 0.92], [-0.3, 0.98, 0.94], b.style.wood);
    b.deck("shelf", [-0.6, 0.0, 0.94], (0.28, 0.9));
    for i in 0..4 {
        let y = -0.85 + 0.17 * i as f32;
        b.wheel("knob", Axis::X, [0.95, y, top + t * 0.5], (b.size.z * 0.012, b.size.x * 0.04), RED_PLASTIC);
    }
}

/// A play tent: a teepee of poles and cloth, or a house of cloth.
pub(super) fn tent(b: &mut Build<'_>) {
    let (cloth, trim) =
        (b.choose(&[WHITE_COTTON, LINEN, BLUE_FABRIC, ROSE_FABRIC, GREEN_FABRIC, GREY_FABRIC]), b.one_of(CLOTHS));
    let teepee = b.rng.chance(0.6);
    let r = 0.012;
    let tie = if teepee { 0.84 } else { 0.995 };
    b.plan_outline("floor", (0.0, 0.008), &rounded_between((-0.947, -0.947), (0.947, 0.947), (0.05, 0.05)), trim);
    b.inner_floor("floor", [0.0, 0.0, 0.008], (0.6, 0.6), 0.22);
    let shoulder = |x: f32, y: f32| if teepee { [x * 0.06, y * 0.06, tie] } else { [x * 0.9, y * 0.9, 0.58] };
    for (i, (x, y)) in CORNERS.into_iter().enumerate() {
        let head = shoulder(x, y);
        if teepee {
            b.pole("pole", [x * 0.97, y * 0.97, 0.012], [-x * 0.1, -y * 0.1, 0.985], r, b.style.wood);
        } else {
            b.pole("pole", [x * 0.95, y * 0.95, 0.0], [x * 0.93, y * 0.93, 0.6], r, b.style.wood);
        }
        let (nx, ny) = CORNERS[(i + 1) % 4];
        let next = shoulder(nx, ny);
        let foot = |x: f32, y: f32| [x * 0.95, y * 0.95, 0.004];
        if i == 3 {
            // The front has a doorway between two flaps.
            for (a, side, top) in [((x, y), -1.0, head), ((nx, ny), 1.0, next)] {
                let inner = [0.95, side * 0.4, 0.004];
                sheet(b, &[foot(a.0, a.1), inner, [top[0], top[1] * 0.6, top[2]], top], cloth);
            }
            curtain(b, head, trim);
        } else {
            sheet(b, &[foot(x, y), foot(nx, ny), next, head], cloth);
        }
    }
    if !teepee {
        for y in SIDES {
            sheet(b, &[[-0.97, y * 0.97, 0.57], [0.97, y * 0.97, 0.57], [0.97, 0.0, 0.98], [-0.97, 0.0, 0.98]], trim);
        }
        for x in SIDES {
            b.within([x * 0.9 - 0.01, -1.0, 0.0], [x * 0.9 + 0.01, 1.0, 1.0], |b| {
                b.front_outline("gable", (-1.0, 1.0), &[(-0.9, 0.58), (0.9, 0.58), (0.0, 0.96)], cloth);
            });
        }
    }
    if teepee {
        b.slab("tie", [-0.1, -0.1, tie - 0.015], [0.1, 0.1, tie + 0.015], trim);
    }
}

/// The cloth in front of a tent's doorway, hinged at its left edge; `head` is an upper corner of
/// the front.
fn curtain(b: &mut Build<'_>, head: [f32; 3], mat: MaterialId) {
    let out = 0.012 / b.size.x;
    let (low, top) = ([0.95 + out, 0.43, 0.014], [head[0] + out, head[1].abs() * 0.64, head[2]]);
    let high = [0, 1, 2].map(|k| low[k] + (top[k] - low[k]) * 0.88);
    let mirrored = |[x, y, z]: [f32; 3]| [x, -y, z];
    let (foot, end) = (b.p(low), b.p(high));
    let axis = [0, 1, 2].map(|k| end[k] - foot[k]);
    b.hinge(foot, axis, 2.0, |b| sheet(b, &[low, mirrored(low), mirrored(high), high], mat));
}

/// A thin cloth spanned by three or four corners.
fn sheet(b: &mut Build<'_>, corners: &[[f32; 3]], mat: MaterialId) {
    let t = (0.004 / b.size.x, 0.004 / b.size.y);
    let inner = corners.iter().map(|p| [p[0] - t.0 * p[0].signum(), p[1] - t.1 * p[1].signum(), p[2] - 0.003]);
    let all: Vec<_> = corners.iter().copied().chain(inner).collect();
    b.chunk("cloth", &all, mat);
}

/// A play mat: puzzle squares, a printed street, or a padded blanket.
pub(super) fn mat(b: &mut Build<'_>) {
    let h = 1.0 - (0.003 / b.size.z).min(0.3);
    match b.rng.below(3) {
        0 => {
            let (nx, ny) = ((b.size.x / 0.32).round().max(1.0) as usize, (b.size.y / 0.32).round().max(1.0) as usize);
            let first = b.rng.below(4);
            let (gx, gy) = (0.003 / b.size.x, 0.003 / b.size.y);
            for (i, j) in (0..nx.min(8)).flat_map(|i| (0..ny.min(8)).map(move |j| (i, j))) {
                let (w, d) = (2.0 / ny.min(8) as f32, 2.0 / nx.min(8) as f32);
                let (x, y) = (-1.0 + d * i as f32, -1.0 + w * j as f32);
                b.slab("tile", [x + gx, y + gy, 0.0], [x + d - gx, y + w - gy, 1.0], BRIGHT[(first + i + 2 * j) % 5]);
            }
        }
        1 => {
            b.slab("mat", [-1.0, -1.0, 0.0], [1.0, 1.0, h], GREEN_FABRIC);
            let road = [(-0.6, -0.7), (0.5, -0.8), (0.7, 0.1), (0.2, 0.75), (-0.7, 0.6)];
            for (i, a) in road.iter().enumerate() {
                let c = road[(i + 1) % road.len()];
                let z = h + 0.3 * (1.0 - h) + 0.05 * (1.0 - h) * i as f32;
                b.plank(
                    "road",
                    [a.0, a.1, z],
                    [c.0, c.1, z],
                    (b.size.x * 0.09, (b.size.z * (1.0 - h)).min(0.002)),
                    CHARCOAL_FABRIC,
                );
            }
            for (x, y) in [(-0.1, -0.25), (0.0, 0.3), (-0.82, -0.1), (0.8, 0.75)] {
                let (roof, half) = (b.one_of(CLOTHS), b.vary(0.08, 0.13));
                b.slab("house", [x - half, y - half, h * 0.9], [x + half, y + half, 1.0 - 0.3 * (1.0 - h)], roof);
            }
        }
        _ => {
            let (cloth, trim) = (b.one_of(CLOTHS), b.one_of(CLOTHS));
            b.plan_outline("mat", (0.0, h), &rounded_between((-1.0, -1.0), (1.0, 1.0), (0.2, 0.2)), cloth);
            for (i, r) in [0.75, 0.5, 0.25].into_iter().enumerate() {
                let z = h + (1.0 - h) * 0.3 * (i + 1) as f32;
                let mat = if i == 1 { WHITE_COTTON } else { trim };
                b.plan_outline("ring", (h * (0.5 - 0.1 * i as f32), z), &oval_outline((0.0, 0.0), (r, r), 20), mat);
            }
        }
    }
    b.deck("mat", [0.0, 0.0, 1.0], (0.95, 0.95));
}

/// A playpen with bars or netting and a padded floor.
pub(super) fn playpen(b: &mut Build<'_>) {
    let cot = b.rng.chance(0.5);
    let wood = b.style.wood;
    let r = 0.018;
    let (ix, iy) = (1.0 - 2.0 * r / b.size.x, 1.0 - 2.0 * r / b.size.y);
    let floor = if cot { 0.1 } else { 0.06 };
    b.pad("floor", [-ix, -iy, floor - 0.05], [ix, iy, floor], 0.01, b.style.accent);
    b.inner_floor("floor", [0.0, 0.0, floor], (ix * 0.9, iy * 0.9), 0.85);
    let rail = if cot { wood } else { b.style.upholstery };
    for (x, y) in CORNERS {
        b.pole("post", [x * ix, y * iy, 0.0], [x * ix, y * iy, 0.97], r, rail);
    }
    for turn in 0..2 {
        b.quarters(turn, |b| {
            let (ix, iy) = (1.0 - 2.0 * r / b.size.x, 1.0 - 2.0 * r / b.size.y);
            for x in SIDES.map(|s| s * ix) {
                let half = r * 0.9 / b.size.z;
                for z in [half.max(0.04), 0.97_f32.min(1.0 - half)] {
                    let deep = r * 1.8 / b.size.x;
                    b.pad("rail", [x - deep, -iy, z - half], [x + deep, iy, z + half], r * 0.8, rail);
                }
                if cot {
                    let count = (b.size.y / 0.1).clamp(3.0, 18.0) as usize;
                    for i in 1..count {
                        let y = -iy + 2.0 * iy * i as f32 / count as f32;
                        b.pole("bar", [x, y, 0.04], [x, y, 0.96], 0.007, wood);
                    }
                } else {
                    b.slab("net", [x - 0.004, -iy * 0.99, 0.3], [x + 0.004, iy * 0.99, 0.94], CLEAR_PLASTIC);
                    b.slab("skirt", [x - 0.008, -iy, 0.06], [x + 0.008, iy, 0.31], rail);
                }
            }
        });
    }
}

/// A baby walker: a seat in a ring on castors with a tray of toys in front.
pub(super) fn walker(b: &mut Build<'_>) {
    let (frame, cloth) = (b.choose(&[WHITE_PLASTIC, GREY_PLASTIC, BLUE_PLASTIC, PINK_PLASTIC]), b.one_of(CLOTHS));
    let r = b.size.x.min(b.size.y) / 2.0;
    (b.size.x, b.size.y) = (2.0 * r, 2.0 * r);
    let castor = (b.size.z * 0.05).min(r * 0.08);
    let ring = r * 0.07;
    let level = (castor * 1.4 + ring) / b.size.z;
    b.torus("base", Axis::Z, [0.0, 0.0, level], (r * 0.92, ring), frame);
    for i in 0..6 {
        let (s, c) = (i as f32 * std::f32::consts::FRAC_PI_3 + std::f32::consts::FRAC_PI_6).sine_cosine();
        b.ball("castor", [r * 0.9 * c, r * 0.9 * s, castor], castor, BLACK_PLASTIC);
    }
    for (x, y) in CORNERS {
        let foot = [x * 0.64, y * 0.64, level];
        b.pole("leg", foot, [x * 0.45, y * 0.45, 0.78], 0.012, STEEL);
    }
    let plate = |inner: f32, outer: f32| vec![(inner, 0.0), (outer, 0.0), (outer, 0.03), (inner, 0.03), (inner, 0.0)];
    let rim = b.p([0.0, 0.0, 0.78]);
    b.lathe("rim", rim, &plate(r * 0.4, r * 0.72), frame);
    let z = rim[2];
    b.lathe(
        "seat",
        [0.0, 0.0, z - b.size.z * 0.3],
        &[(r * 0.3, 0.0), (r * 0.44, b.size.z * 0.31), (r * 0.4, b.size.z * 0.31), (r * 0.26, 0.02)],
        cloth,
    );
    b.pad("backrest", [-0.62, -0.35, 0.76], [-0.44, 0.35, 1.0], 0.03, cloth);
    b.plan_outline("tray", (0.8, 0.845), &rounded_between((0.3, -0.62), (0.98, 0.62), (0.2, 0.2)), frame);
    for (i, y) in [-0.4, 0.0, 0.4].into_iter().enumerate() {
        let toy = b.p([0.66, y, 0.84]);
        b.ball("toy", [toy[0], toy[1], toy[2] + r * 0.05], r * 0.1, BRIGHT[i]);
    }
}

/// A bouncer: a cloth seat on a springy frame, with a bow of toys.
pub(super) fn bouncer(b: &mut Build<'_>) {
    let (cloth, trim) = (b.style.upholstery, b.style.accent);
    let r = 0.011;
    let (side, low) = (1.0 - 4.0 * r / b.size.y, 1.7 * r / b.size.z);
    for side in [side, -side] {
        b.bent_rod(
            "frame",
            &[[-0.8, side, low], [0.7, side, low], [0.95, side * 0.9, 0.1 + low], [0.5, side * 0.8, 0.3]],
            r,
            STEEL,
        );
        b.bent_rod("frame", &[[0.5, side * 0.8, 0.3], [-0.2, side * 0.86, 0.4], [-0.93, side * 0.8, 0.94]], r, STEEL);
    }
    for x in [-0.8, 0.6] {
        b.pole("crossbar", [x, -0.99, low], [x, 0.99, low], r, STEEL);
        for y in SIDES {
            b.wheel("foot", Axis::Y, [x, y * 0.8, low], (r * 1.7, 0.03), RUBBER);
        }
    }
    let seat = [
        (0.72, 0.36),
        (0.5, 0.3),
        (-0.2, 0.37),
        (-0.93, 0.93),
        (-0.98, 0.99),
        (-0.85, 0.99),
        (-0.1, 0.5),
        (0.45, 0.42),
        (0.7, 0.45),
    ];
    b.side_outline("seat", (-side * 0.82, side * 0.82), &seat, cloth);
    b.plank("cushion", [-0.9, 0.0, 0.98], [-0.5, 0.0, 0.74], (b.size.y * 0.5, 0.03), trim);
    b.plank("belt", [0.35, 0.0, 0.44], [-0.1, 0.0, 0.52], (b.size.y * 0.2, 0.02), trim);
    let bow = arc_outline((0.0, 0.35), (side * 0.83, 0.47), (0.0, std::f32::consts::PI), 9);
    let bow: Vec<_> = bow.into_iter().map(|(y, z)| [0.15 + (z - 0.35) * 0.4, y, z]).collect();
    b.bent_rod("bow", &bow, r * 0.8, WHITE_PLASTIC);
    for (i, k) in [3, 4, 5].into_iter().enumerate() {
        let at = bow[k];
        b.ellipsoid("toy", [at[0], at[1], at[2] - 0.06], [0.07, 0.1, 0.055], BRIGHT[i + 1]);
    }
}

/// An easel with a blackboard on one side and a whiteboard on the other.
pub(super) fn easel(b: &mut Build<'_>) {
    let wood = b.choose(&[PINE, BEECH, WHITE, BIRCH]);
    let (t, drawing) = ((0.03 / b.size.y).min(0.2), b.one_of(CARDS));
    let lean = |z: f32| 0.96 - 0.88 * z;
    for (x, y) in CORNERS {
        b.plank(
            "leg",
            [x * lean(0.012), y * (1.0 - t), 0.012],
            [x * lean(0.985), y * (1.0 - t), 0.985],
            (0.03, 0.022),
            wood,
        );
    }
    for x in SIDES {
        let (low, high) = (0.42, 0.94);
        let board = if x > 0.0 { SCREEN } else { WHITE_PLASTIC };
        let place = |z: f32, out: f32| [x * (lean(z) + out), 0.0, z];
        b.plank("board", place(low, 0.0), place(high, 0.0), (b.size.y * (1.0 - 2.2 * t), 0.012), board);
        for z in [low, high] {
            b.plank("frame", place(z - 0.015, 0.0), place(z + 0.015, 0.0), (b.size.y * (1.0 - 1.9 * t), 0.03), wood);
        }
        let tray = lean(low - 0.06);
        let (near, far) = (x * (tray - 0.02), x * 1.0);
        b.slab("tray", [near.min(far), t - 0.98, low - 0.07], [near.max(far), 0.98 - t, low - 0.045], wood);
        let chalk = if x > 0.0 { WHITE_PAPER } else { drawing };
        let slope = 0.44 * b.size.x / b.size.z;
        let out = (0.006 * (1.0 + slope * slope).sqrt() + 0.002) * 2.0 / b.size.x;
        let line = |b: &mut Build<'_>, from: (f32, f32), to: (f32, f32)| {
            let at = |(y, z): (f32, f32)| [x * (lean(z) + out), y, z];
            b.bent_rod("line", &[at(from), at(to)], 0.004, chalk);
        };
        let (base, eaves) = (0.52, 0.68);
        for pair in
            [(-0.35, base), (0.25, base), (0.25, eaves), (-0.05, 0.82), (-0.35, eaves), (-0.35, base)].windows(2)
        {
            line(b, pair[0], pair[1]);
        }
        line(b, (-0.35, eaves), (0.25, eaves));
    }
    for (i, y) in [-0.4, -0.1, 0.2, 0.5].into_iter().enumerate() {
        let z = 0.375 + 0.005 / b.size.z;
        b.pole("chalk", [0.9, y, z], [0.9, y + 0.15, z], 0.006, BRIGHT[i]);
    }
    for y in SIDES {
        b.slab("hinge", [-0.16, y * (1.0 - t) - t * 0.4, 0.94], [0.16, y * (1.0 - t) + t * 0.4, 0.975], STEEL);
    }
    b.pole("paper_roll", [0.0, -0.97, 0.955], [0.0, 0.97, 0.955], 0.018, WHITE_PAPER);
}
