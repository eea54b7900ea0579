//! Garden houses: sheds, greenhouses, kennels, hutches.

use std::f32::consts::{FRAC_PI_2, PI};

use vc_graph::portable::Portable;

use crate::material::*;
use crate::object::joinery::{Handle, handle};
use crate::solid::{Axis, Build, CORNERS, at_least, spaced};

pub(super) const WOODS: &[MaterialId] = &[PINE, OAK, TEAK, GREY_OAK, FOREST, RED, SKY, SAGE, ANTHRACITE, WALNUT];

/// The walls of a house whose gable is at the front: half depth, half width, floor, eaves, ridge,
/// thickness.
#[derive(Clone, Copy)]
pub(super) struct House {
    pub(super) x: f32,
    pub(super) y: f32,
    pub(super) low: f32,
    pub(super) eaves: f32,
    pub(super) ridge: f32,
    pub(super) t: f32,
}

impl House {
    /// Two sides, the back gable, and the front around an opening that spans `from..to` and is
    /// `high` above the floor.
    pub(super) fn walls(self, b: &mut Build<'_>, (from, to, high): (f32, f32, f32), mat: MaterialId) {
        let Self { x, y, low, eaves, ridge, t } = self;
        for side in [-1.0, 1.0] {
            let cy = side * (y - t / 2.0);
            b.block("wall", [-x + t, cy - t / 2.0, low], [x - t, cy + t / 2.0, eaves], mat);
        }
        let gable = [(-y, low), (y, low), (y, eaves), (0.0, ridge), (-y, eaves)];
        b.prism("wall", Axis::X, [-x, 0.0, 0.0], &gable, t, mat);
        let top = low + high;
        let slope = |at: f32| eaves + (ridge - eaves) * (1.0 - at.abs() / y);
        let left = [(-y, low), (from, low), (from, top.min(slope(from))), (from, slope(from)), (-y, eaves)];
        let right = [(to, low), (y, low), (y, eaves), (to, slope(to)), (to, top.min(slope(to)))];
        b.prism("wall", Axis::X, [x - t, 0.0, 0.0], &left, t, mat);
        b.prism("wall", Axis::X, [x - t, 0.0, 0.0], &right, t, mat);
        let mut lintel = vec![(from, top), (to, top), (to, slope(to))];
        if from < 0.0 && to > 0.0 {
            lintel.push((0.0, ridge));
        }
        lintel.push((from, slope(from)));
        b.prism("wall", Axis::X, [x - t, 0.0, 0.0], &lintel, t, mat);
    }

    /// Two slopes that overhang the walls by `out` within half widths `wide`, with their upper side
    /// at `top`.
    pub(super) fn roof(self, b: &mut Build<'_>, (deep, wide, top): (f32, f32, f32), mat: MaterialId) {
        let Self { y, eaves, ridge, .. } = self;
        let fall = (ridge - eaves) / y;
        let thick = top - ridge;
        for side in [-1.0, 1.0] {
            let edge = ridge - fall * wide;
            let slope = [(0.0, ridge), (side * wide, edge), (side * wide, edge + thick * 0.9), (0.0, top)];
            b.prism("roof", Axis::X, [-deep, 0.0, 0.0], &slope, 2.0 * deep, mat);
        }
    }
}

/// A garden shed: boarded walls, a gabled or lean-to roof, a door, shelf and hooks.
pub(super) fn garden_shed(b: &mut Build<'_>) {
    at_least(b, [0.75, 0.9, 0.95]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (mat, trim) = (b.one_of(WOODS), b.choose(&[WHITE, PINE, OAK, ANTHRACITE]));
    let roof = b.choose(&[ASPHALT, ROOF_TILE, ANTHRACITE, GREEN_METAL, GALVANISED]);
    let (out, t, low) = (b.vary(0.04, 0.12), 0.03, 0.06);
    let eaves = h * b.vary(0.74, 0.84);
    let house = House { x: x - out, y: y - out, low, eaves, ridge: h - 0.03, t };
    b.block("floor", [-house.x, -house.y, 0.0], [house.x, house.y, low], b.style.wood);
    let wide = (house.y * b.vary(0.35, 0.5)).min(0.55);
    let cy = b.vary(-0.25, 0.25) * (house.y - wide);
    let high = (eaves - low) * 0.95;
    house.walls(b, (cy - wide, cy + wide, high), mat);
    house.roof(b, (x, y, h), roof);
    planks(b, house, mat);
    let (dx, bottom) = (house.x - t, low + 0.006);
    b.hinge([house.x, cy + wide, 0.0], [0.0, 0.0, 1.0], FRAC_PI_2 * 1.3, |b| {
        b.block(
            "door",
            [dx + 0.004, cy - wide + 0.004, bottom],
            [house.x - 0.002, cy + wide - 0.004, low + high - 0.004],
            trim,
        );
        for z in [0.2, 0.8] {
            let z = low + high * z;
            b.block(
                "batten",
                [house.x - 0.003, cy - wide + 0.05, z - 0.05],
                [house.x + 0.012, cy + wide - 0.05, z + 0.05],
                trim,
            );
        }
        handle(b, Handle::Bar, [house.x, cy - wide + 0.07, low + high * 0.5], 0.14, true, IRON);
    });
    for side in [-1.0, 1.0] {
        let wy = side * (house.y - t / 2.0);
        let (w, z) = (house.x * 0.3, eaves * 0.62);
        b.block("window", [-w, wy - t / 2.0 - 0.008, z - 0.2], [w, wy + t / 2.0 + 0.008, z + 0.18], trim);
        b.block(
            "glass",
            [-w + 0.04, wy - t / 2.0 - 0.011, z - 0.16],
            [w - 0.04, wy + t / 2.0 + 0.011, z + 0.14],
            BLUE_GLASS,
        );
    }
    let (ix, iy) = (house.x - t, house.y - t);
    let level = (eaves * 0.55).max(low + 0.3);
    let deep = 0.3_f32.min(ix * 0.4);
    b.block("shelf", [-ix - 0.002, -iy - 0.002, level - 0.02], [-ix + deep, iy + 0.002, level], PINE);
    b.inside("shelf_1", [-ix + deep / 2.0, 0.0, level], (deep / 2.0 - 0.01, iy - 0.01), (eaves - level) * 0.7);
    b.inside("compartment", [deep / 2.0, 0.0, low], (ix - deep / 2.0 - 0.02, iy - 0.04), eaves - low - 0.02);
    for (i, hy) in spaced(8, -iy * 0.85, iy * 0.85).enumerate() {
        let at = [-ix + 0.03, hy, eaves - 0.06];
        b.rod("hook", [-ix - 0.005, hy, eaves - 0.06], at, 0.005, IRON);
        b.hook(&format!("hook_{}", i + 1), at, at[2] - level - 0.01);
    }
}

/// Cover strips on the long walls, and corner posts.
fn planks(b: &mut Build<'_>, house: House, mat: MaterialId) {
    let strips = b.rng.count(4, 8);
    for side in [-1.0, 1.0] {
        let cy = side * house.y;
        for x in spaced(strips, -house.x + 0.02, house.x - 0.02) {
            b.block("strip", [x - 0.02, cy - 0.006, house.low + 0.01], [x + 0.02, cy + 0.006, house.eaves - 0.01], mat);
        }
    }
}

/// A greenhouse: a frame with glass, a door, a bench for pots.
pub(super) fn greenhouse(b: &mut Build<'_>) {
    at_least(b, [0.6, 0.65, 0.9]);
    // The door's handle protrudes in front.
    let (x, y, h) = (b.size.x / 2.0 - 0.011, b.size.y / 2.0, b.size.z);
    let frame = b.choose(&[ALUMINIUM, GREEN_METAL, WHITE_METAL, ANTHRACITE, PINE]);
    let glass = b.choose(&[GLASS, GLASS, CLEAR_PLASTIC]);
    let (eaves, r) = (h * b.vary(0.62, 0.75), 0.02);
    let base = h * b.vary(0.03, 0.15);
    let stone = b.choose(&[BRICK, CONCRETE, frame]);
    b.block("floor", [-x + 0.02, -y + 0.02, 0.0], [x - 0.02, y - 0.02, 0.02], GRAVEL);
    let half = (y * 0.55).min(0.42);
    for side in [-1.0, 1.0] {
        b.block("base", [-x, side * (y - r) - r, 0.0], [x, side * (y - r) + r, base], stone);
        let cy = side * (half + (y - 2.0 * r - half) / 2.0);
        let w = ((y - 2.0 * r - half) / 2.0).max(0.005);
        b.block("base", [x - 2.0 * r, cy - w, 0.0], [x, cy + w, base], stone);
    }
    b.block("base", [-x, -y + 2.0 * r, 0.0], [-x + 2.0 * r, y - 2.0 * r, base], stone);
    let bays = ((2.0 * x / 0.7) as usize).clamp(2, 6);
    let step = (2.0 * x - 2.0 * r) / bays as f32;
    let ridge = h - r;
    for cx in spaced(bays + 1, -x + r, x - r) {
        for side in [-1.0, 1.0] {
            let cy = side * (y - r);
            b.block("post", [cx - r, cy - r, base - 0.005], [cx + r, cy + r, eaves], frame);
            b.rod("rafter", [cx, cy, eaves], [cx, 0.0, ridge - r * 0.4], r * 0.7, frame);
        }
    }
    b.block("ridge", [-x, -r, h - 2.0 * r], [x, r, h], frame);
    for side in [-1.0, 1.0] {
        let cy = side * (y - r);
        b.block("eaves", [-x + 0.002, cy - r * 0.8, eaves - r], [x - 0.002, cy + r * 0.8, eaves + r * 0.6], frame);
        for cx in spaced(bays, -x + r + step / 2.0, x - r - step / 2.0) {
            b.block(
                "pane",
                [cx - step / 2.0 + r, cy - 0.003, base],
                [cx + step / 2.0 - r, cy + 0.003, eaves - r],
                glass,
            );
            let slope =
                [(cy, eaves), (cy - side * 0.006, eaves - 0.003), (-side * 0.0, ridge - 0.02), (0.0, ridge - 0.012)];
            b.prism("pane", Axis::X, [cx - step / 2.0 + r, 0.0, 0.0], &slope, step - 2.0 * r, glass);
        }
    }
    let gable = |low: f32| [(-y + r, low), (y - r, low), (y - r, eaves), (0.0, ridge - 0.02), (-y + r, eaves)];
    b.prism("pane", Axis::X, [-x + r - 0.003, 0.0, 0.0], &gable(base), 0.006, glass);
    let top = eaves * 0.97;
    b.prism("pane", Axis::X, [x - r - 0.003, 0.0, 0.0], &gable(top + r), 0.006, glass);
    for side in [-1.0, 1.0] {
        let (from, to) = (side * half, side * (y - 2.0 * r));
        b.block("pane", [x - r - 0.003, from.min(to), base], [x - r + 0.003, from.max(to), top], glass);
        b.block("post", [x - 2.0 * r, side * half - r, 0.0], [x, side * half + r, top + r], frame);
    }
    b.block("lintel", [x - 2.0 * r + 0.001, -y + 2.0 * r, top], [x - 0.001, y - 2.0 * r, top + 2.0 * r], frame);
    b.hinge([x, half - r, 0.0], [0.0, 0.0, 1.0], FRAC_PI_2, |b| {
        let w = half - r - 0.003;
        b.block("door", [x - r - 0.003, -w, 0.05], [x - r + 0.003, w, top - 0.01], glass);
        for cy in [-w + 0.015, w - 0.015] {
            b.block("door", [x - 1.6 * r, cy - 0.015, 0.03], [x - 0.4 * r, cy + 0.015, top - 0.006], frame);
        }
        for z in [0.03, top * 0.45, top - 0.04] {
            b.block("door", [x - 1.55 * r, -w + 0.01, z], [x - 0.45 * r, w - 0.01, z + 0.03], frame);
        }
        handle(b, Handle::Bar, [x - 0.4 * r, -w + 0.015, top * 0.5], 0.1, true, frame);
    });
    let (level, inner) = ((h * 0.34).max(base + 0.1), y - 2.0 * r);
    let deep = (inner * 0.6).min(0.5);
    b.block("bench", [-x + 2.0 * r, inner - deep, level - 0.02], [x - 2.0 * r, inner + 0.005, level], PINE);
    for cx in [-x * 0.8, x * 0.75] {
        b.block("leg", [cx - 0.02, inner - deep + 0.01, 0.018], [cx + 0.02, inner - deep + 0.05, level - 0.018], PINE);
    }
    b.inside(
        "shelf_1",
        [0.0, inner - deep / 2.0, level],
        (x - 2.0 * r - 0.02, deep / 2.0 - 0.01),
        (eaves - level) * 0.9,
    );
    let free = 2.0 * inner - deep;
    b.inside("compartment", [0.0, -inner + free / 2.0, 0.02], (x - 2.0 * r - 0.05, free / 2.0 - 0.03), eaves - 0.05);
}

/// A dog's house with an arched or square doorway.
pub(super) fn kennel(b: &mut Build<'_>) {
    at_least(b, [0.35, 0.3, 0.32]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (mat, roof) = (b.one_of(WOODS), b.choose(&[RED, ASPHALT, ROOF_TILE, FOREST, ANTHRACITE]));
    let (out, t, low) = (0.05, 0.018, 0.04);
    let eaves = h * b.vary(0.6, 0.7);
    let house = House { x: x - out, y: y - out, low, eaves, ridge: h - 0.025, t };
    b.block("floor", [-house.x, -house.y, 0.0], [house.x, house.y, low], mat);
    let wide = house.y * b.vary(0.45, 0.6);
    let high = (eaves - low) * b.vary(0.8, 0.95);
    house.walls(b, (-wide, wide, high), mat);
    house.roof(b, (x, y, h), roof);
    if b.rng.chance(0.6) {
        let bow = wide - 0.004;
        let arch: Vec<(f32, f32)> = (0..=8)
            .map(|i| PI * i as f32 / 8.0)
            .map(|a| (bow * a.cosine(), low + high - wide * 0.6 * (1.0 - a.sine())))
            .collect();
        // Both spandrels as one frame around the arch.
        let mut frame: Vec<(f32, f32)> = vec![
            (-wide - 0.03, low),
            (-wide - 0.03, low + high + 0.02),
            (wide + 0.03, low + high + 0.02),
            (wide + 0.03, low),
            (bow, low),
        ];
        frame.extend(arch);
        frame.push((-bow, low));
        b.prism("frame", Axis::X, [house.x - 0.004, 0.0, 0.0], &frame, 0.018, WHITE);
    }
    b.block(
        "name",
        [house.x - 0.004, -wide * 0.6, eaves + 0.01],
        [house.x + 0.008, wide * 0.6, eaves + (h - eaves) * 0.3],
        WHITE,
    );
    b.inside("compartment", [0.0, 0.0, low], (house.x - t - 0.01, house.y - t - 0.01), eaves - low - 0.01);
}

/// A rabbit hutch on legs: a closed and a wire-fronted compartment under one roof.
pub(super) fn rabbit_hutch(b: &mut Build<'_>) {
    at_least(b, [0.25, 0.45, 0.35]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (mat, roof) = (b.one_of(WOODS), b.choose(&[ASPHALT, GREEN_METAL, ROOF_TILE, ANTHRACITE]));
    let (floor, t) = (h * b.vary(0.28, 0.4), 0.018);
    let (back, front) = (-x + 0.03, x - 0.05);
    let (rear, fore) = (h - 0.09, h - 0.05);
    let split = y * b.vary(-0.3, 0.3);
    let iy = y - 0.04;
    b.block("floor", [back, -iy, floor - t], [front, iy, floor], mat);
    b.block("wall", [back, -iy, floor], [back + t, iy, rear], mat);
    for cy in [-iy, iy - t, split - t / 2.0] {
        b.prism(
            "wall",
            Axis::Y,
            [0.0, cy, 0.0],
            &[(back + t, floor), (front - t, floor), (front - t, fore - 0.005), (back + t, rear)],
            t,
            mat,
        );
    }
    b.prism(
        "roof",
        Axis::Y,
        [0.0, -y, 0.0],
        &[(-x, rear - 0.01), (x, fore), (x, h), (-x, rear + 0.025)],
        2.0 * y,
        roof,
    );
    for (sx, sy) in CORNERS {
        let cx = if sx > 0.0 { front - t - 0.025 } else { back + 0.025 };
        let cy = sy * (iy - 0.025);
        b.block("leg", [cx - 0.024, cy - 0.024, 0.0], [cx + 0.024, cy + 0.024, floor - t + 0.003], mat);
    }
    let high = fore - floor - 0.02;
    let rooms = [("door_left", split + t / 2.0, iy, 1.0), ("door_right", -iy, split - t / 2.0, -1.0)];
    let wire = b.rng.below(2);
    for (i, (name, from, to, side)) in rooms.into_iter().enumerate() {
        let hinge = if side > 0.0 { to } else { from };
        b.hinge([front, hinge, 0.0], [0.0, 0.0, side], FRAC_PI_2 * 1.2, |b| {
            let (y0, y1, z0, z1) = (from + 0.004, to - 0.004, floor + 0.004, floor + high);
            if i == wire {
                for (low, top) in [
                    ([y0, z0], [y1, z0 + 0.035]),
                    ([y0, z1 - 0.035], [y1, z1]),
                    ([y0, z0 + 0.035], [y0 + 0.035, z1 - 0.035]),
                    ([y1 - 0.035, z0 + 0.035], [y1, z1 - 0.035]),
                ] {
                    b.block(name, [front - t, low[0], low[1]], [front, top[0], top[1]], mat);
                }
                for wy in spaced(7, y0 + 0.06, y1 - 0.06) {
                    b.cylinder("wire", [front - t / 2.0, wy, z0 + 0.03], 0.002, z1 - z0 - 0.06, GALVANISED);
                }
                for wz in spaced(4, z0 + 0.07, z1 - 0.07) {
                    b.rod(
                        "wire",
                        [front - t / 2.0 + 0.004, y0 + 0.03, wz],
                        [front - t / 2.0 + 0.004, y1 - 0.03, wz],
                        0.002,
                        GALVANISED,
                    );
                }
            } else {
                b.block(name, [front - t, y0, z0], [front, y1, z1], mat);
            }
            b.rod(
                "knob",
                [front - 0.004, hinge - side * (to - from - 0.03), floor + high * 0.5],
                [front + 0.02, hinge - side * (to - from - 0.03), floor + high * 0.5],
                0.012,
                IRON,
            );
        });
        let half = (to - from) / 2.0;
        let centre = [(back + front) / 2.0, f32::midpoint(from, to), floor];
        let depth = (front - back) / 2.0 - t - 0.005;
        b.inside(&format!("compartment_{}", i + 1), centre, (depth, half - t - 0.004), rear - floor - 0.03);
    }
}
