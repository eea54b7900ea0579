//! Building toys: blocks, bricks, stacking rings, sorters, marble runs and beads.

use vc_graph::portable::Portable;

use crate::material::*;
use crate::object::palette::*;
use crate::solid::{Axis, Build, Proportional, SIDES, arc_outline, oval_outline};

/// A small castle of wooden blocks: cubes, arches, pillars, roofs.
pub(super) fn wooden(b: &mut Build<'_>) {
    let plain = b.rng.chance(0.4);
    let wood = b.one_of(TOY_WOODS);
    let paint = |b: &mut Build<'_>| if plain && b.rng.chance(0.7) { wood } else { b.one_of(PAINTS) };
    let columns = 4;
    let step = 2.0 / columns as f32;
    let mut tallest = true;
    for i in 0..columns {
        let y = -1.0 + step * (i as f32 + 0.5);
        let half = step * 0.44;
        let levels = if i == 1 { 3 } else { b.rng.count(1, 2) };
        for level in 0..levels {
            let (z, h) = (level as f32 * 0.26, 0.26);
            let (mat, turn) = (paint(b), b.vary(-0.04, 0.04));
            let (x0, x1) = if level == 0 { (-1.0, 0.3) } else { (-0.62 + turn, 0.1 + turn) };
            match b.rng.below(3) {
                0 if level > 0 => b.pole("cylinder", [-0.25, y, z], [-0.25, y, z + h], radius(b, half), mat),
                1 if level == 0 => arch(b, (y, half), (x0, x1), h, mat),
                _ => b.pad("block", [x0, y - half, z], [x1, y + half, z + h], 0.002, mat),
            }
        }
        let (z, mat) = (levels as f32 * 0.26, paint(b));
        if tallest && levels == 3 {
            tallest = false;
            b.chunk(
                "roof",
                &[[-0.6, y - half, z], [0.1, y - half, z], [-0.6, y + half, z], [0.1, y + half, z], [-0.25, y, 1.0]],
                mat,
            );
        } else {
            let ridge = (z + 0.2).min(1.0);
            b.front_outline("prism", (-0.6, 0.1), &[(y - half, z), (y + half, z), (y, ridge)], mat);
        }
    }
    for (y, z) in [(-0.7, 0.0), (0.1, 0.0), (0.75, 0.0)] {
        let (mat, half) = (paint(b), step * 0.36);
        let x = b.vary(0.62, 0.66);
        if b.rng.chance(0.5) {
            b.pad("block", [x - 0.25, y - half * 0.7, z], [1.0, y + half * 0.7, z + 0.22], 0.002, mat);
        } else {
            b.pole("cylinder", [x, y, z], [x, y, z + 0.25], radius(b, half * 0.7), mat);
        }
    }
}

fn radius(b: &Build<'_>, half: f32) -> f32 {
    (half * b.size.y / 2.0).min(b.size.x * 0.16)
}

/// A block with a half circle cut out at the bottom.
fn arch(b: &mut Build<'_>, (y, half): (f32, f32), x: (f32, f32), h: f32, mat: MaterialId) {
    let mut outline = vec![(y + half, 0.0), (y + half, h), (y - half, h), (y - half, 0.0)];
    outline.extend(arc_outline((y, 0.0), (-half * 0.6, h * 0.7), (0.0, std::f32::consts::PI), 9));
    b.front_outline("arch", x, &outline, mat);
}

/// Interlocking bricks on a base plate: a small house or tower.
pub(super) fn bricks(b: &mut Build<'_>) {
    let base = b.choose(&[GREEN_PLASTIC, GREY_PLASTIC, BLUE_PLASTIC]);
    let plate = (0.006 / b.size.z).min(0.2);
    b.slab("plate", [-1.0, -1.0, 0.0], [1.0, 1.0, plate], base);
    let courses = 4;
    let h = (1.0 - plate - 0.06) / courses as f32;
    for course in 0..courses {
        let z = plate + h * course as f32;
        let inset = if course == 3 { 0.22 } else { 0.0 };
        for (i, side) in SIDES.into_iter().enumerate() {
            let (mat, other) = (b.one_of(BRIGHT), b.one_of(BRIGHT));
            let split = b.vary(-0.25, 0.25);
            let y = side * (0.62 - inset);
            let ends = (y - 0.16, y + 0.16);
            if course % 2 == i % 2 {
                brick(b, ((-0.7, ends.0), (split, ends.1)), (z, z + h), mat);
                brick(b, ((split + 0.01, ends.0), (0.7, ends.1)), (z, z + h), other);
            } else {
                brick(b, ((-0.7, ends.0), (0.7, ends.1)), (z, z + h), mat);
            }
        }
    }
    let mat = b.one_of(BRIGHT);
    brick(b, ((-0.7, -0.45), (-0.4, 0.45)), (plate, plate + h * 2.0), mat);
    let z = plate;
    for (x, y) in [(0.86, -0.85), (0.88, 0.1), (-0.86, 0.8)] {
        let loose = b.one_of(BRIGHT);
        brick(b, ((x - 0.1, y - 0.1), (x + 0.1, y + 0.1)), (z, z + h * 0.7), loose);
    }
}

/// A brick with studs.
fn brick(b: &mut Build<'_>, (low, high): ((f32, f32), (f32, f32)), z: (f32, f32), mat: MaterialId) {
    b.slab("brick", [low.0, low.1, z.0], [high.0, high.1, z.1], mat);
    let length = (high.0 - low.0) * b.size.x;
    let count = (length / ((high.1 - low.1) * b.size.y)).round().clamp(1.0, 4.0);
    let r = ((high.1 - low.1) * b.size.y * 0.16).min(length * 0.2);
    let y = (low.1 + high.1) / 2.0;
    for i in 0..count as usize {
        let x = low.0 + (high.0 - low.0) * (i as f32 + 0.5) / count;
        b.pole("stud", [x, y, z.1 - 0.01], [x, y, z.1 + 0.045], r, mat);
    }
}

/// Stacking rings of decreasing size on a post, with a ball on top.
pub(super) fn rings(b: &mut Build<'_>) {
    let wood = b.one_of(TOY_WOODS);
    let r = b.size.x.min(b.size.y) / 2.0;
    b.pole("base", [0.0; 3], [0.0, 0.0, 0.08], r * 0.9, wood);
    b.pole("post", [0.0, 0.0, 0.07], [0.0, 0.0, 0.88], r * 0.14, wood);
    let count = b.rng.count(4, 6);
    let h = 0.78 / count as f32;
    for i in 0..count {
        let share = i as f32 / count as f32;
        let thick = (h * b.size.z / 2.0).min(r * 0.2);
        let outer = r * (1.0 - share * 0.58);
        let mat = BRIGHT[i % BRIGHT.len()];
        b.torus("ring", Axis::Z, [0.0, 0.0, 0.08 + h * (i as f32 + 0.5)], (outer - thick, thick), mat);
        let inner = (outer - thick) * 1.02;
        let base = b.p([0.0, 0.0, 0.08 + h * i as f32]);
        let tall = b.size.z * h;
        b.cylinder("core", base, inner, tall, mat);
    }
    let top = b.size.z * 0.08;
    let centre = b.p([0.0, 0.0, 1.0]);
    b.ball("ball", [0.0, 0.0, centre[2] - top], top, RED);
}

/// A shape sorter: a box with holes of several shapes in its lid, the shapes beside them.
pub(super) fn sorter(b: &mut Build<'_>) {
    let (case, lid) = (b.choose(&[BEECH, BIRCH, WHITE_PLASTIC, BLUE_PLASTIC, YELLOW_PLASTIC]), b.one_of(BRIGHT));
    let t = 0.06;
    b.slab("bottom", [-0.98, -0.98, 0.0], [0.98, 0.98, t], case);
    for s in SIDES {
        b.slab("wall", [-0.98, s * 0.93 - 0.05, t], [0.98, s * 0.93 + 0.05, 0.934], case);
        b.slab("wall", [s * 0.93 - 0.05, -0.88, t], [s * 0.93 + 0.05, 0.88, 0.934], case);
    }
    b.inner_floor("inside", [0.0, 0.0, t], (0.84, 0.84), 0.85);
    let anchor = b.p([-1.0, 0.0, 0.93]);
    b.hinge(anchor, [0.0, -1.0, 0.0], 1.8, |b| {
        b.slab("lid", [-1.0, -1.0, 0.935], [1.0, 1.0, 0.985], lid);
        let holes = [
            oval_outline((0.45, 0.45), (0.26, 0.26), 12),
            oval_outline((-0.45, 0.45), (0.3, 0.3), 4),
            oval_outline((-0.45, -0.45), (0.3, 0.3), 3),
            oval_outline((0.45, -0.45), (0.28, 0.28), 6),
        ];
        for hole in holes {
            b.plan_outline("hole", (0.97, 0.99), &hole, BLACK_PLASTIC);
        }
    });
    let shapes = [
        oval_outline((0.0, 0.5), (0.24, 0.2), 12),
        oval_outline((0.0, 0.5), (0.27, 0.26), 4),
        oval_outline((0.0, 0.5), (0.27, 0.24), 6),
    ];
    for (i, shape) in shapes.iter().enumerate() {
        let y = -0.58 + 0.58 * i as f32;
        let moved: Vec<_> = shape.iter().map(|&(a, z)| (a + y, z)).collect();
        b.front_outline("sign", (0.97, 1.0), &moved, BRIGHT[i]);
        b.front_outline("sign", (-1.0, -0.97), &moved, BRIGHT[i + 2]);
    }
}

/// A marble run: a zigzag of sloping channels between posts, with marbles on it.
pub(super) fn marble_run(b: &mut Build<'_>) {
    let wood = b.rng.chance(0.5);
    let post = if wood { b.one_of(TOY_WOODS) } else { b.one_of(BRIGHT) };
    let count = 4;
    let r = b.size.x * 0.07;
    b.pad("tray", [-0.95, -1.0, 0.0], [0.95, 1.0, 0.05], 0.004, post);
    for y in SIDES {
        b.pole("post", [0.0, y * 0.84, 0.04], [0.0, y * 0.84, 0.96], r, post);
        b.pole("cap", [0.0, y * 0.84, 0.955], [0.0, y * 0.84, 1.0], r * 1.4, RED_PLASTIC);
    }
    for i in 0..count {
        let side = if i % 2 == 0 { 1.0 } else { -1.0 };
        let z = 0.9 - 0.2 * i as f32;
        let mat = if wood { post } else { BRIGHT[(i + 1) % BRIGHT.len()] };
        let (from, to) = ([0.42, side * 0.9, z], [0.42, side * -0.8, z - 0.15]);
        let w = b.size.x * 0.2;
        b.plank("channel", from, to, (w, b.size.z * 0.015), mat);
        for x in [0.33, 0.51] {
            let lift = |p: [f32; 3]| [x, p[1], p[2] + 0.022];
            b.plank("channel_side", lift(from), lift(to), (b.size.x * 0.02, b.size.z * 0.05), mat);
        }
        b.slab("bracket", [0.0, side * 0.84 - 0.04, z - 0.03], [0.45, side * 0.84 + 0.04, z - 0.01], mat);
        b.slab("bracket", [0.0, side * -0.78 - 0.04, z - 0.175], [0.45, side * -0.78 + 0.04, z - 0.155], mat);
        let marble = b.p([0.42, side * 0.1, z - 0.05]);
        b.ball("marble", marble, b.size.x * 0.05, BRIGHT[i + 2]);
    }
    b.torus("bowl", Axis::Z, [-0.45, 0.0, 0.055], (b.size.x * 0.2, b.size.z * 0.012), YELLOW_PLASTIC);
}

/// Several glass marbles in a net or a dish.
pub(super) fn marbles(b: &mut Build<'_>) {
    let r = b.size.x.min(b.size.y) / 2.0;
    let marble = (r * 0.24).min(b.size.z * 0.3);
    let (t, rim) = (r * 0.04, b.size.z * 0.55);
    let dish = [(r * 0.6, 0.0), (r * 0.99, rim), (r * 0.95, rim), (r * 0.58, t)];
    let mat = b.choose(&[BEECH, BLUE_GLAZE, CLEAR_PLASTIC]);
    b.lathe("dish", [0.0; 3], &dish, mat);
    let glass = [GREEN_GLASS, BLUE_GLASS, BROWN_GLASS, GLASS, RED_GLAZE, YELLOW_GLAZE];
    for i in 0..7 {
        let (s, c) = (i as f32 * std::f32::consts::FRAC_PI_3).sine_cosine();
        // The seventh marble lies in the hollow between the others.
        let (out, lift) = if i == 6 { (0.0, 1.52) } else { (marble * 1.92, 1.02) };
        let z = (t + marble * lift).min(b.size.z - marble);
        b.ball("marble", [out * c, out * s, z], marble, glass[i % glass.len()]);
    }
}

/// Beads on bars in a frame.
pub(super) fn abacus(b: &mut Build<'_>) {
    let wood = b.one_of(TOY_WOODS);
    let rows = b.rng.count(5, 8);
    for y in SIDES {
        b.slab("post", [-0.3, y * 0.95 - 0.05, 0.04], [0.3, y * 0.95 + 0.05, 0.97], wood);
        b.slab("foot", [-1.0, y * 0.95 - 0.045, 0.0], [1.0, y * 0.95 + 0.045, 0.05], wood);
    }
    for (low, high) in [(0.05, 0.1), (0.94, 0.999)] {
        b.slab("rail", [-0.28, -0.91, low], [0.28, 0.91, high], wood);
    }
    let pitch = 0.84 / rows as f32;
    let r = (pitch * b.size.z * 0.46).min(b.size.x * 0.45);
    for row in 0..rows {
        let z = 0.1 + pitch * (row as f32 + 0.5);
        b.pole("bar", [0.0, -0.92, z], [0.0, 0.92, z], r * 0.15, STEEL);
        let (mat, moved) = (PAINTS[row % PAINTS.len()], b.rng.count(0, 5));
        for (side, count) in [(-1.0, 5 - moved), (1.0, moved)] {
            let end = side * 0.88;
            let other = end - side * 0.14 * count as f32;
            if count > 0 {
                b.pole("beads", [0.0, end, z], [0.0, other, z], r * 0.8, mat);
            }
            for i in 0..count {
                let y = end - side * 0.14 * (i as f32 + 0.5);
                b.wheel("bead", Axis::Y, [0.0, y, z], (r, b.size.y * 0.035), mat);
            }
        }
    }
}
