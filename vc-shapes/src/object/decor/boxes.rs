//! Boxes and baskets.

use std::f32::consts::PI;

use vc_graph::portable::Portable;

use crate::material::*;
use crate::solid::{Axis, Build, MeshBuilder, P, arc, blocks, half_dims, hoop, loft, oval, spline, walled_tray};

/// A taped carton whose four flaps open outwards, with printed marks.
pub(super) fn carton(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let plain = b.class == "box" && b.rng.chance(0.35);
    let card = if plain { b.choose(&[WHITE_PAPER, BLUE_CARD, BLACK_CARD, GREEN_CARD]) } else { CARDBOARD };
    let t = (x * 0.02).clamp(0.001, 0.005);
    if plain {
        return lidded(b, card, t);
    }
    let rim = h - 2.2 * t;
    walled_tray(b, (x, y), (0.0, rim), t, card);
    b.inside("compartment", [0.0, 0.0, t], (x - 1.5 * t, y - 1.5 * t), rim - t);
    for side in [-1.0_f32, 1.0] {
        let (edge, near) = (side * y, side * y * 0.35);
        b.hinge([0.0, edge, rim], [side, 0.0, 0.0], 3.6, |b| {
            b.block("flap", [-x, edge.min(near), rim], [x, edge.max(near), rim + t], card);
        });
    }
    for side in [-1.0_f32, 1.0] {
        let edge = side * x;
        b.hinge([edge, 0.0, rim + t], [0.0, side, 0.0], 3.6, |b| {
            b.block(
                "flap",
                [edge.min(side * t * 0.3), -y, rim + 1.1 * t],
                [edge.max(side * t * 0.3), y, rim + 2.0 * t],
                card,
            );
        });
    }
    let ink = b.choose(&[BLACK_CARD, RED_CARD, BLUE_CARD]);
    let side = |y0: f32, y1: f32, z0: f32, z1: f32| ([x - t * 0.5, y * y0, h * z0], [x + 0.0006, y * y1, h * z1]);
    blocks(b, "print", &[side(-0.8, -0.45, 0.15, 0.35), side(0.3, 0.8, 0.3, 0.36), side(0.3, 0.7, 0.2, 0.26)], ink);
    if b.rng.chance(0.6) {
        b.block("tape", [x - t * 0.5, -y * 0.08, h * 0.6], [x + 0.0006, y * 0.08, rim * 0.99], BROWN_PLASTIC);
    }
}

/// A box with a hinged lid.
fn lidded(b: &mut Build<'_>, mat: MaterialId, t: f32) {
    let (x, y, h) = half_dims(b);
    let rim = h * b.vary(0.72, 0.85);
    walled_tray(b, (x - 1.2 * t, y - 1.2 * t), (0.0, rim), t, mat);
    b.inside("compartment", [0.0, 0.0, t], (x - 3.0 * t, y - 3.0 * t), rim - t);
    let low = rim - (h * 0.1);
    b.hinge([-x, 0.0, rim], [0.0, -1.0, 0.0], 1.9, |b| {
        b.block("lid", [-x, t * 0.15 - y, h - t], [x - t * 0.15, y - t * 0.15, h], mat);
        let skirt = [
            ([x - t, -y, low], [x, y, h - t * 0.9]),
            ([-x + t * 0.9, -y, low], [x - t * 0.9, -y + t, h - t * 0.9]),
            ([-x + t * 0.9, y - t, low], [x - t * 0.9, y, h - t * 0.9]),
        ];
        blocks(b, "lid", &skirt, mat);
    });
    b.block("label", [x - 1.5 * t, -y * 0.3, rim * 0.35], [x - 0.9 * t, y * 0.3, rim * 0.65], CREAM_PAPER);
}

/// A plastic box with a lid, clips at the sides and a grip rim.
pub(super) fn storage(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let body = b.choose(&[CLEAR_PLASTIC, CLEAR_PLASTIC, GREY_PLASTIC, BLUE_PLASTIC, WHITE_PLASTIC]);
    let lid = b.choose(&[BLUE_PLASTIC, RED_PLASTIC, WHITE_PLASTIC, BLACK_PLASTIC, GREEN_PLASTIC]);
    let t = (x * 0.02).clamp(0.001, 0.004);
    let rim = h * 0.9;
    let (dx, dy, draft) = (x * 0.97, y * 0.94, 0.93);
    let ring = |z: f32, s: f32, t: f32| oval(Axis::Z, [0.0, 0.0, z], (dx * s - t, dy * s - t), 2, 32);
    loft(b, "body", &[ring(0.0, draft, 0.0), ring(rim, 1.0, 0.0), ring(rim, 1.0, t), ring(t, draft, t)], body);
    b.inside("compartment", [0.0, 0.0, t], (dx * draft * 0.88, dy * draft * 0.88), rim - t);
    let edge = oval(Axis::Z, [0.0, 0.0, rim - t * 2.0], (dx, dy), 2, 32);
    hoop(b, "rim", &edge, t * 1.2, body);
    b.hinge([-x, 0.0, rim], [0.0, -1.0, 0.0], 1.9, |b| {
        b.rounded_block("lid", [-x, -y * 0.96, rim], [x, y * 0.96, h - t], (h - rim) * 0.3, lid);
        b.rounded_block("lid", [-x * 0.85, -y * 0.82, rim + t], [x * 0.85, y * 0.82, h], (h - rim) * 0.2, lid);
        for side in [-1.0_f32, 1.0] {
            let (a, c) = (side * y * 0.955, side * y);
            b.block("clip", [-x * 0.3, a.min(c), rim - h * 0.12], [x * 0.3, a.max(c), rim + t], lid);
        }
    });
}

/// A present: wrapped box, ribbon around it and a bow on its lid.
pub(super) fn gift(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let (paper, ribbon) = b.choose(&[
        (RED_CARD, GOLD),
        (BLUE_CARD, SILVER_METAL),
        (GREEN_CARD, RED_FABRIC),
        (WHITE_PAPER, RED_FABRIC),
        (PINK_CARD, WHITE_COTTON),
        (TEAL_CARD, YELLOW_CARD),
        (PURPLE_CARD, GOLD),
        (CARDBOARD, GREEN_FABRIC),
    ]);
    let bow = (x.min(y) * 0.35).min(h * 0.3);
    let (top, t) = (h - bow * 0.75, (x.min(h) * 0.03).min(0.003));
    let rim = top * 0.8;
    let wide = x.min(y) * b.vary(0.08, 0.16);
    walled_tray(b, (x * 0.97, y * 0.97), (0.0, rim), t, paper);
    b.inside("compartment", [0.0, 0.0, t], (x * 0.97 - 1.5 * t, y * 0.97 - 1.5 * t), rim - t);
    let e = 0.001_f32.min(x * 0.01);
    let band = |s: f32| ([x * 0.97 * s - e * (1.0 - s), -wide, h * 0.02], [x * 0.97 + e, wide, rim]);
    let (front, back) = (band(0.99), ([-x * 0.97 - e, -wide, h * 0.02], [-x * 0.96, wide, rim]));
    let (left, right) = (
        ([-wide, y * 0.96, h * 0.02], [wide, y * 0.97 + e, rim]),
        ([-wide, -y * 0.97 - e, h * 0.02], [wide, -y * 0.96, rim]),
    );
    blocks(b, "ribbon", &[front, back, left, right], ribbon);
    b.hinge([-x, 0.0, rim], [0.0, -1.0, 0.0], 1.9, |b| {
        b.block("lid", [e - x, e - y, rim], [x - e, y - e, top], paper);
        blocks(b, "ribbon", &[([-x, -wide, rim + t], [x, wide, top + e])], ribbon);
        b.block("ribbon", [-wide, -y, rim + t], [wide, y, top + e * 0.5], ribbon);
        let mut loops = MeshBuilder::default();
        for i in 0..6 {
            let (s, c) = (i as f32 * 1.047 + 0.4).sine_cosine();
            let out = |r: f32, z: f32| [bow * r * c, bow * r * s, top + bow * z];
            let loop_: Vec<P> =
                spline(&[out(0.0, 0.02), out(0.7, 0.12), out(1.0, 0.4), out(0.6, 0.65), out(0.05, 0.3)], 3);
            loops.leaf(&loop_, |_| wide * 0.7, 0.0);
        }
        loops.put(b, "bow", ribbon);
        b.ball("bow", [0.0, 0.0, top + bow * 0.25], bow * 0.22, ribbon);
    });
}

/// A basket: rods woven around stakes, or slatted plastic; with handles.
pub(super) fn basket(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let laundry = b.class == "laundry_basket";
    let mat = match laundry && b.rng.chance(0.5) {
        true => b.choose(&[WHITE_PLASTIC, GREY_PLASTIC, BLUE_PLASTIC]),
        false => b.choose(&[WICKER, WICKER, JUTE, BAMBOO, GREY_OAK]),
    };
    let handles = !laundry && b.rng.chance(0.5);
    let r = (h * 0.035).min(x * 0.05);
    let grip = match (handles, laundry) {
        (true, _) => h * 0.16,
        (false, true) => h * 0.07,
        _ => 0.0,
    };
    let rim = h - grip - r;
    let square = b.rng.below(3);
    let draft = b.vary(0.72, 0.92);
    let size = |z: f32| draft + (1.0 - draft) * (z / rim).clamp(0.0, 1.0);
    let ring = |z: f32, out: f32| {
        let s = size(z);
        oval(Axis::Z, [0.0, 0.0, z], (x * s - r + out, y * s - r + out), square, 20)
    };
    let rows = ((rim / r / 2.2) as usize).clamp(4, 10);
    let mut weave = MeshBuilder::default();
    for i in 0..rows {
        let z = r + (rim - r) * i as f32 / (rows - 1) as f32;
        weave.hoop(&ring(z, 0.0), r * if i + 1 == rows { 1.0 } else { 0.8 });
    }
    // Collision geometry with a wall as thick as the weave.
    let wall = |out: f32| [ring(r * 0.2, out), ring(rim, out), ring(rim, -r * 0.7), ring(r, -r * 0.7)];
    b.visual_only(|b| {
        weave.put(b, "weave", mat);
        loft(b, "wall", &wall(-r * 0.2), mat);
    });
    b.collision_only(|b| loft(b, "wall", &wall(r * 0.8), mat));
    let floor = (x * draft - 2.0 * r, y * draft - 2.0 * r);
    let fit = [0.66, 0.78, 0.86][square];
    b.inside("compartment", [0.0, 0.0, r], (floor.0 * fit, floor.1 * fit), rim - r);
    if handles {
        let mut shell = MeshBuilder::default();
        for side in [-1.0, 1.0] {
            let end = side * (y - r) * 0.94;
            let curve = arc(Axis::Y, [0.0, end, rim], (x * 0.3, h - rim - r * 0.7), (0.0, PI), 10);
            shell.tube(&curve, r * 0.7);
        }
        let accent = b.choose(&[mat, BROWN_LEATHER, JUTE]);
        shell.put(b, "handle", accent);
    } else if laundry {
        // Hinged at the upper edge of its back, so that an open lid stays clear of the wall behind.
        b.hinge([r * 0.15 - x, 0.0, h], [0.0, -1.0, 0.0], 1.5, |b| {
            let low = rim + r * 0.9;
            loft(
                b,
                "lid",
                &[ring(low, r * 0.8), ring(low + (h - low) * 0.5, r * 0.8), ring(h - (h - low) * 0.15, -r)],
                mat,
            );
            b.block("grip", [x * 0.6, -y * 0.15, h - (h - low) * 0.4], [x * 0.7, y * 0.15, h], BROWN_LEATHER);
        });
    }
}

/// A crate of slats; a plastic one has bottle compartments.
pub(super) fn crate_box(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let plastic = b.rng.chance(0.35);
    let mat = if plastic {
        b.choose(&[RED_PLASTIC, YELLOW_PLASTIC, BLUE_PLASTIC, GREEN_PLASTIC])
    } else {
        b.choose(&[PINE, OAK, GREY_OAK, BIRCH])
    };
    let t = (x * 0.05).clamp(0.003, 0.012);
    let rows = b.rng.count(2, 4);
    let pitch = (h - t) / rows as f32;
    let gap = pitch * b.vary(0.12, 0.3);
    let mut slats = MeshBuilder::default();
    for i in 0..rows {
        let (z0, z1) = (t + pitch * i as f32 + gap * 0.5, t + pitch * (i + 1) as f32 - gap * 0.5);
        let z1 = if i + 1 == rows { h } else { z1 };
        for s in [-1.0_f32, 1.0] {
            let (a, c) = (s * x, s * (x - t));
            slats.block([a.min(c), -y, z0], [a.max(c), y, z1]);
            let (a, c) = (s * y, s * (y - t));
            slats.block([-x + t * 0.9, a.min(c), z0], [x - t * 0.9, a.max(c), z1]);
        }
    }
    let boards = 4;
    for i in 0..boards {
        let (y0, step) = (-y, 2.0 * y / boards as f32);
        slats.block([-x, y0 + step * i as f32 + 0.001, 0.0], [x, y0 + step * (i + 1) as f32 - 0.001, t]);
    }
    slats.put(b, "slat", mat);
    let post = |sx: f32, sy: f32| {
        let (px, py) = (sx * (x - 1.9 * t), sy * (y - 1.9 * t));
        ([px - t, py - t, t * 0.9], [px + t, py + t, h * 0.97])
    };
    blocks(b, "post", &[post(-1.0, -1.0), post(-1.0, 1.0), post(1.0, -1.0), post(1.0, 1.0)], mat);
    let inner = (x - 3.2 * t, y - 3.2 * t);
    b.inside("compartment", [0.0, 0.0, t], inner, h - t);
    b.top("bottom", [0.0, 0.0, t], inner);
}

/// A jewelry box: a drawer below, a hinged lid with a mirror above.
pub(super) fn jewelry(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let wood = b.choose(&[WALNUT, CHERRY, WHITE_LEATHER, ROSE_FABRIC, b.style.wood, BLACK_LEATHER]);
    let (t, foot) = ((h * 0.05).min(0.006), h * 0.05);
    let (split, rim) = (h * 0.42, h * 0.74);
    let knob = (x * 0.08).min(0.008);
    let front = x - knob;
    let feet = [(-1.0, -1.0), (-1.0, 1.0), (1.0, -1.0), (1.0, 1.0)]
        .map(|(sx, sy)| ([sx * x * 0.8 - t, sy * y * 0.85 - t, 0.0], [sx * x * 0.8 + t, sy * y * 0.85 + t, foot]));
    blocks(b, "foot", &feet, BRASS);
    let list = [
        ([-x, -y, foot], [front, y, foot + t]),
        ([-x, -y, split - t], [front, y, split]),
        ([-x, -y, foot + t * 0.9], [front, -y + t, rim]),
        ([-x, y - t, foot + t * 0.9], [front, y, rim]),
        ([-x, -y + t * 0.9, foot + t * 0.9], [-x + t, y - t * 0.9, rim]),
        ([front - t, -y + t * 0.9, split * 0.99], [front, y - t * 0.9, rim]),
    ];
    blocks(b, "case", &list, wood);
    b.inside("compartment", [0.0, 0.0, split], (front.min(x) - 2.0 * t, y - 2.0 * t), rim - split);
    b.slide([1.0, 0.0, 0.0], x, |b| {
        let (z0, z1) = (foot + 1.2 * t, split - 1.2 * t);
        let (y0, back) = (y - 1.3 * t, -x + 1.5 * t);
        let walls = [
            ([back, -y0, z0], [front - t, y0, z0 + t * 0.6]),
            ([front - t * 1.1, -y0, z0], [front - 0.0002, y0, z1]),
            ([back, -y0, z0 + t * 0.5], [front - t, -y0 + t * 0.6, z1 * 0.98]),
            ([back, y0 - t * 0.6, z0 + t * 0.5], [front - t, y0, z1 * 0.98]),
        ];
        blocks(b, "drawer", &walls, wood);
        b.inside(
            "drawer",
            [(back + front - t) / 2.0, 0.0, z0 + t * 0.6],
            ((front - t - back) / 2.0 - t, y0 - t),
            (z1 - z0 - t).max(0.0),
        );
        b.rod("knob", [front - 0.001, 0.0, f32::midpoint(z0, z1)], [x, 0.0, f32::midpoint(z0, z1)], knob * 0.6, BRASS);
    });
    b.hinge([-x, 0.0, rim], [0.0, -1.0, 0.0], 1.7, |b| {
        let flat = rim + (h - rim) * 0.4;
        b.block("lid", [-x, -y, rim + h * 0.002], [front, y, flat], wood);
        b.rounded_block(
            "lid",
            [-x * 0.97, -y * 0.98, flat - t * 0.5],
            [front * 0.97, y * 0.98, h],
            (h - rim) * 0.4,
            wood,
        );
        b.block(
            "mirror",
            [-x * 0.7, -y * 0.75, rim - (h * 0.015).min(0.001)],
            [front * 0.7, y * 0.75, rim + t * 0.5],
            MIRROR,
        );
    });
}
