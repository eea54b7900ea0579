//! Sheds, boxes and roofs of the garden.

use std::f32::consts::{FRAC_PI_2, PI, TAU};

use crate::material::*;
use crate::object::build::{Axis, Build};
use crate::object::joinery::{Handle, handle};
use crate::object::park::shape::{grown, polar, spaced, tub};
use vc_graph::portable::Portable;

const WOODS: &[Mat] = &[PINE, OAK, TEAK, GREY_OAK, FOREST, RED, SKY, SAGE, ANTHRACITE, WALNUT];

/// Walls of a house whose gable faces the front: half depth, half width, floor,
/// eaves, ridge, thickness.
#[derive(Clone, Copy)]
struct House {
    x: f32,
    y: f32,
    low: f32,
    eaves: f32,
    ridge: f32,
    t: f32,
}

impl House {
    /// Two sides, the back gable and the front around an opening `from..to` wide and
    /// `high` above the floor.
    fn walls(self, b: &mut Build<'_>, (from, to, high): (f32, f32, f32), mat: Mat) {
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

    /// Two slopes that reach out over the walls by `out` within half widths `wide`,
    /// their upper side at `top`.
    fn roof(self, b: &mut Build<'_>, (deep, wide, top): (f32, f32, f32), mat: Mat) {
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
    grown(b, [0.75, 0.9, 0.95]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (mat, trim) = (b.one(WOODS), b.one(&[WHITE, PINE, OAK, ANTHRACITE]));
    let roof = b.one(&[ASPHALT, ROOF_TILE, ANTHRACITE, GREEN_METAL, GALVANISED]);
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
fn planks(b: &mut Build<'_>, house: House, mat: Mat) {
    let strips = b.rng.count(4, 8);
    for side in [-1.0, 1.0] {
        let cy = side * house.y;
        for x in spaced(strips, -house.x + 0.02, house.x - 0.02) {
            b.block("strip", [x - 0.02, cy - 0.006, house.low + 0.01], [x + 0.02, cy + 0.006, house.eaves - 0.01], mat);
        }
    }
}

/// A box for cushions and toys; its lid is hinged behind.
pub(super) fn storage_box(b: &mut Build<'_>) {
    grown(b, [0.2, 0.4, 0.22]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let mat = b.one(&[GREY_PLASTIC, BROWN_PLASTIC, BLACK_PLASTIC, WICKER, TEAK, PINE, GREY_OAK]);
    let (lid, t) = (h * b.vary(0.06, 0.12), 0.02);
    let rim = h - lid;
    let lean = b.vary(0.92, 0.97);
    tub(b, "box", [0.0, 0.0, 0.0], (x * lean, y * 0.97), (x - 0.012, y - 0.012), rim - 0.002, t, mat);
    let ribs = b.rng.count(0, 7);
    for cy in spaced(ribs, -y * 0.85, y * 0.85) {
        b.block("rib", [x * 0.9, cy - 0.02, 0.03], [x - 0.004, cy + 0.02, rim - 0.03], mat);
    }
    b.hinge([-x, 0.0, rim], [0.0, -1.0, 0.0], FRAC_PI_2, |b| {
        b.soft("lid", [-x, -y, rim], [x, y, h], 0.015, mat);
        b.top("lid", [0.0, 0.0, h], (x - 0.03, y - 0.03));
    });
    for side in [-1.0, 1.0] {
        b.block(
            "handle",
            [-0.08, side * (y - 0.012) - 0.011, rim * 0.7],
            [0.08, side * (y - 0.012) + 0.011, rim * 0.76],
            mat,
        );
    }
    b.inside("compartment", [0.0, 0.0, t], (x * 0.92 - t - 0.01, y * 0.97 - t - 0.01), rim - t - 0.01);
}

/// A carport: posts, beams and a flat, leaning or gabled roof over paved ground.
pub(super) fn carport(b: &mut Build<'_>) {
    grown(b, [2.4, 1.4, 1.1]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let mat = b.one(&[PINE, OAK, GREY_OAK, ANTHRACITE, WHITE_METAL, GALVANISED]);
    let roof = b.one(&[ROOF_TILE, ANTHRACITE, ASPHALT, CLEAR_PLASTIC, GALVANISED]);
    let post = b.vary(0.05, 0.08);
    let design = b.rng.below(3);
    let eaves = h - 0.1 - if design == 0 { 0.0 } else { h * 0.12 };
    b.block("ground", [-x + 0.1, -y + 0.1, 0.0], [x - 0.1, y - 0.1, 0.02], GRAVEL);
    let count = b.rng.count(2, 4);
    for cx in spaced(count, -x + 0.2, x - 0.2) {
        for side in [-1.0, 1.0] {
            let cy = side * (y - 0.16);
            b.block("post", [cx - post, cy - post, 0.0], [cx + post, cy + post, eaves + 0.01], mat);
            if b.rng.chance(0.6) {
                let brace = [(cx, eaves - 0.5), (cx + 0.06, eaves - 0.5), (cx + 0.56, eaves), (cx + 0.5, eaves)];
                if cx + 0.56 < x - 0.2 {
                    b.prism("brace", Axis::Y, [0.0, cy - 0.03, 0.0], &brace, 0.06, mat);
                }
            }
        }
    }
    for side in [-1.0, 1.0] {
        let cy = side * (y - 0.16);
        b.block("beam", [-x + 0.03, cy - 0.05, eaves], [x - 0.03, cy + 0.05, eaves + 0.08], mat);
    }
    let rafters = ((2.0 * x / 0.9) as usize).clamp(3, 8);
    match design {
        0 => b.block("roof", [-x, -y, eaves + 0.06], [x, y, h], roof),
        1 => {
            let fall = h - eaves - 0.1;
            let slope = [(-y, eaves + 0.07), (y, eaves + 0.07 + fall), (y, h), (-y, eaves + 0.1)];
            b.prism("roof", Axis::X, [-x, 0.0, 0.0], &slope, 2.0 * x, roof);
            b.block("beam", [-x + 0.03, y - 0.21, eaves + 0.07], [x - 0.03, y - 0.11, eaves + 0.02 + fall], mat);
        }
        _ => {
            let house = House { x, y: y - 0.11, low: 0.0, eaves: eaves + 0.06, ridge: h - 0.04, t: 0.0 };
            house.roof(b, (x, y, h), roof);
        }
    }
    for cx in spaced(rafters, -x + 0.15, x - 0.15) {
        b.block("rafter", [cx - 0.03, -y + 0.12, eaves + 0.02], [cx + 0.03, y - 0.12, eaves + 0.075], mat);
    }
    b.inside("compartment", [0.0, 0.0, 0.02], (x - 0.3, y - 0.3), eaves - 0.06);
}

/// A greenhouse: a frame with glass, a door, a bench for pots.
pub(super) fn greenhouse(b: &mut Build<'_>) {
    grown(b, [0.6, 0.65, 0.9]);
    // The door's handle stands out in front.
    let (x, y, h) = (b.size.x / 2.0 - 0.011, b.size.y / 2.0, b.size.z);
    let frame = b.one(&[ALUMINIUM, GREEN_METAL, WHITE_METAL, ANTHRACITE, PINE]);
    let glass = b.one(&[GLASS, GLASS, CLEAR_PLASTIC]);
    let (eaves, r) = (h * b.vary(0.62, 0.75), 0.02);
    let base = h * b.vary(0.03, 0.15);
    let stone = b.one(&[BRICK, CONCRETE, frame]);
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

/// A composter: slatted wood, or tapered plastic with a lid.
pub(super) fn composter(b: &mut Build<'_>) {
    grown(b, [0.3, 0.3, 0.4]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    if b.rng.chance(0.5) {
        let mat = b.one(&[PINE, OAK, GREY_OAK, TEAK]);
        let post = 0.025;
        for (sx, sy) in [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)] {
            let (cx, cy) = (sx * (x - post - 0.015), sy * (y - post - 0.015));
            b.block("post", [cx - post, cy - post, 0.0], [cx + post, cy + post, h - 0.035], mat);
        }
        let rows = b.rng.count(5, 8);
        let pitch = (h - 0.06) / rows as f32;
        for z in spaced(rows, pitch * 0.5 + 0.02, h - 0.04 - pitch * 0.5) {
            let half = pitch * 0.36;
            for side in [-1.0, 1.0] {
                b.block(
                    "slat",
                    [side * (x - 0.009) - 0.009, -y + 0.002, z - half],
                    [side * (x - 0.009) + 0.009, y - 0.002, z + half],
                    mat,
                );
                b.block(
                    "slat",
                    [-x + 0.018, side * (y - 0.009) - 0.009, z - half],
                    [x - 0.018, side * (y - 0.009) + 0.009, z + half],
                    mat,
                );
            }
        }
        b.hinge([-x, 0.0, h - 0.034], [0.0, -1.0, 0.0], FRAC_PI_2, |b| {
            b.block("lid", [-x, -y, h - 0.034], [x, y, h - 0.012], mat);
            b.block("handle", [x * 0.7, -0.08, h - 0.014], [x * 0.76, 0.08, h], mat);
        });
        let soil = h * 0.3;
        b.block("compost", [-x + 0.02, -y + 0.02, 0.0], [x - 0.02, y - 0.02, soil], SOIL);
        b.inside("compartment", [0.0, 0.0, soil], (x - 0.09, y - 0.09), h - 0.05 - soil);
    } else {
        let mat = b.one(&[GREEN_PLASTIC, BLACK_PLASTIC, FOREST, BROWN_PLASTIC]);
        let lid = h * b.vary(0.08, 0.14);
        let rim = h - lid;
        let small = b.vary(0.68, 0.82);
        tub(b, "bin", [0.0; 3], (x - 0.004, y), (x * small, y * small), rim, 0.012, mat);
        for z in spaced(4, rim * 0.25, rim * 0.85) {
            let share = 1.0 - (1.0 - small) * z / rim;
            for side in [-1.0, 1.0] {
                b.block(
                    "rib",
                    [-x * share * 0.8, side * y * share - 0.006, z],
                    [x * share * 0.8, side * y * share + 0.003, z + 0.02],
                    mat,
                );
            }
        }
        b.hinge([-x * small, 0.0, rim], [0.0, -1.0, 0.0], FRAC_PI_2, |b| {
            b.taper(
                "lid",
                [0.0, 0.0, rim + 0.001],
                (x * small * 1.02, y * small * 1.02),
                (x * small * 0.6, y * small * 0.6),
                lid - 0.02,
                mat,
            );
            b.soft("knob", [-0.04, -0.06, h - 0.022], [0.04, 0.06, h], 0.01, mat);
        });
        b.block("hatch", [x * 0.9, -y * 0.45, 0.03], [x, y * 0.45, rim * 0.1], GREY_PLASTIC);
        b.inside("compartment", [0.0, 0.0, 0.012], (x * small - 0.02, y * small - 0.02), rim - 0.03);
    }
}

/// A rain barrel with a tap and a lid.
pub(super) fn rain_barrel(b: &mut Build<'_>) {
    grown(b, [0.2, 0.2, 0.35]);
    let (r, h) = (b.size.x.min(b.size.y) / 2.0 - 0.03, b.size.z);
    let mat = b.one(&[GREEN_PLASTIC, BLUE_PLASTIC, GREY_PLASTIC, OAK, BROWN_PLASTIC, POTTERY]);
    let (stand, lid) = (if b.rng.chance(0.5) { h * 0.15 } else { 0.0 }, 0.025);
    let rim = h - lid;
    let waist = b.vary(0.8, 0.95);
    let inner = r * waist - 0.012;
    let profile = [
        (r * waist, stand),
        (r, stand + (rim - stand) * 0.4),
        (r, stand + (rim - stand) * 0.6),
        (r * waist, rim),
        (inner, rim),
        (inner, stand + 0.02),
        (0.0, stand + 0.02),
    ];
    b.lathe("barrel", [0.0; 3], &profile, mat);
    for share in [0.14, 0.86] {
        let z = stand + (rim - stand) * share;
        let out = r * (waist + (1.0 - waist) * 0.36) + 0.004;
        b.lathe(
            "hoop",
            [0.0, 0.0, z - 0.02],
            &[(out, 0.0), (out, 0.04), (out - 0.02, 0.04), (out - 0.02, 0.0), (out, 0.0)],
            if mat == OAK { IRON } else { mat },
        );
    }
    if stand > 0.0 {
        for i in 0..4 {
            let (px, py) = polar(TAU * i as f32 / 4.0 + 0.78, r * waist * 0.75);
            b.block("foot", [px - 0.05, py - 0.05, 0.0], [px + 0.05, py + 0.05, stand + 0.003], CONCRETE);
        }
    }
    let z = stand + (rim - stand) * 0.18;
    b.rod("tap", [r * waist * 0.9, 0.0, z], [r + 0.025, 0.0, z], 0.014, BRASS);
    b.cylinder("tap", [r + 0.015, 0.0, z - 0.04], 0.01, 0.04, BRASS);
    b.block("tap", [r + 0.005, -0.025, z + 0.012], [r + 0.02, 0.025, z + 0.022], RED_PLASTIC);
    b.hinge([-r * waist, 0.0, rim], [0.0, -1.0, 0.0], FRAC_PI_2, |b| {
        b.lathe(
            "lid",
            [0.0, 0.0, rim],
            &[(r * waist + 0.012, 0.0), (r * waist + 0.012, lid * 0.5), (r * 0.2, lid)],
            mat,
        );
    });
    b.inside("water", [0.0, 0.0, stand + 0.02], (inner * 0.68, inner * 0.68), rim - stand - 0.03);
}

/// A dog's house with an arched or square doorway.
pub(super) fn kennel(b: &mut Build<'_>) {
    grown(b, [0.35, 0.3, 0.32]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (mat, roof) = (b.one(WOODS), b.one(&[RED, ASPHALT, ROOF_TILE, FOREST, ANTHRACITE]));
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
        // Both spandrels in one frame around the arch.
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

/// A rabbit hutch on legs: a closed and a wire-fronted room under one roof.
pub(super) fn rabbit_hutch(b: &mut Build<'_>) {
    grown(b, [0.25, 0.45, 0.35]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (mat, roof) = (b.one(WOODS), b.one(&[ASPHALT, GREEN_METAL, ROOF_TILE, ANTHRACITE]));
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
    for (sx, sy) in [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)] {
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

/// A gazebo: posts under a tent or a hipped roof.
pub(super) fn gazebo(b: &mut Build<'_>) {
    grown(b, [1.2, 1.2, 1.1]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let cloth = b.rng.chance(0.4);
    let mat = b.one(if cloth { &[WHITE_METAL, ANTHRACITE, GALVANISED] } else { &[PINE, OAK, TEAK, WHITE] });
    let roof = b.one(if cloth {
        &[WHITE_COTTON, GREEN_FABRIC, BEIGE_FABRIC, NAVY_FABRIC]
    } else {
        &[ROOF_TILE, ASPHALT, PINE, ANTHRACITE]
    });
    let open = !cloth && b.rng.chance(0.35);
    let eaves = h * if open { b.vary(0.88, 0.92) } else { b.vary(0.68, 0.78) };
    let post = if cloth { 0.025 } else { b.vary(0.045, 0.07) };
    for (sx, sy) in [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)] {
        let (cx, cy) = (sx * (x - 0.12), sy * (y - 0.12));
        b.block("post", [cx - post, cy - post, 0.0], [cx + post, cy + post, eaves + 0.01], mat);
        b.block("foot", [cx - post - 0.02, cy - post - 0.02, 0.0], [cx + post + 0.02, cy + post + 0.02, 0.03], mat);
    }
    let beam = if open { h - 0.085 } else { eaves + 0.1_f32.min(h - eaves - 0.06) };
    for side in [-1.0, 1.0] {
        b.block("beam", [-x + 0.05, side * (y - 0.12) - 0.04, eaves], [x - 0.05, side * (y - 0.12) + 0.04, beam], mat);
    }
    if open {
        // A pergola: rafters across the beams.
        for cx in spaced(b.rng.count(6, 11), -x + 0.04, x - 0.04) {
            b.block("rafter", [cx - 0.025, -y, h - 0.09], [cx + 0.025, y, h], mat);
        }
        return;
    }
    for side in [-1.0, 1.0] {
        b.block(
            "beam",
            [side * (x - 0.12) - 0.035, -y + 0.06, eaves + 0.002],
            [side * (x - 0.12) + 0.035, y - 0.06, eaves + 0.07],
            mat,
        );
    }
    let knob = h * 0.03;
    b.taper("roof", [0.0, 0.0, eaves + 0.04], (x, y), (x * 0.12, y * 0.12), h - eaves - 0.04 - knob, roof);
    b.taper("roof", [0.0, 0.0, h - knob - 0.01], (x * 0.14, y * 0.14), (0.01, 0.01), knob + 0.01, roof);
    if cloth {
        for side in [-1.0, 1.0] {
            b.block(
                "valance",
                [side * (x - 0.004) - 0.003, -y, eaves - 0.12],
                [side * (x - 0.004) + 0.003, y, eaves + 0.045],
                roof,
            );
            b.block(
                "valance",
                [-x + 0.008, side * (y - 0.004) - 0.003, eaves - 0.12],
                [x - 0.008, side * (y - 0.004) + 0.003, eaves + 0.045],
                roof,
            );
        }
    }
}

/// An awning: a roller at the wall, and as far as it is deep, cloth on folding arms.
pub(super) fn awning(b: &mut Build<'_>) {
    grown(b, [0.1, 1.0, 0.07]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let cloth = b.one(&[RED_FABRIC, BEIGE_FABRIC, NAVY_FABRIC, GREEN_FABRIC, MUSTARD_FABRIC, GREY_FABRIC]);
    let second = b.one(&[WHITE_COTTON, cloth, WHITE_COTTON, BEIGE_FABRIC]);
    let (case, deep) = (b.one(&[WHITE_METAL, ANTHRACITE, SILVER_METAL]), 0.16_f32.min(2.0 * x * 0.8));
    let box_z = h - deep.min(h * 0.7);
    b.soft("case", [-x, -y, box_z], [-x + deep, y, h], 0.03, case);
    let (from, low) = (-x + deep, 0.0);
    let reach = 2.0 * x - deep;
    if reach < 0.25 {
        b.slide([1.0, 0.0, 0.0], 0.02, |b| {
            b.soft(
                "bar",
                [from - 0.01, -y + 0.02, box_z + 0.01],
                [x, y - 0.02, box_z + 0.06_f32.min(h - box_z - 0.01)],
                0.01,
                case,
            )
        });
        return;
    }
    let stripes = b.rng.count(6, 12);
    let (z0, z1) = (box_z + 0.04, low + 0.09_f32.min(h * 0.3));
    let half = (y - 0.03) / stripes as f32;
    for (i, cy) in spaced(stripes, -y + 0.03 + half, y - 0.03 - half).enumerate() {
        let mat = if i % 2 == 0 { cloth } else { second };
        b.prism(
            "cloth",
            Axis::Y,
            [0.0, cy - half, 0.0],
            &[(from - 0.02, z0), (from - 0.02, z0 + 0.006), (x - 0.02, z1 + 0.006), (x - 0.02, z1)],
            2.0 * half - 0.001,
            mat,
        );
    }
    b.slide([1.0, 0.0, 0.0], 0.01, |b| {
        b.block("bar", [x - 0.05, -y + 0.01, z1 - 0.01], [x - 0.011, y - 0.01, z1 + 0.025], case);
        for (i, cy) in spaced(stripes, -y + 0.03 + half, y - 0.03 - half).enumerate() {
            let mat = if i % 2 == 0 { cloth } else { second };
            b.block("valance", [x - 0.012, cy - half, low], [x - 0.006, cy + half - 0.001, z1 + 0.02], mat);
        }
    });
    for side in [-1.0, 1.0] {
        let (root, elbow, tip) = (
            [from - 0.01, side * y * 0.85, box_z + 0.015],
            [(from + x) / 2.0, side * y * 0.45, f32::midpoint(box_z, z1)],
            [x - 0.063, side * y * 0.85, z1],
        );
        b.pipe("arm", &[root, elbow, tip], 0.015, case);
    }
}

/// A clothesline: a rotary dryer, or lines between two posts.
pub(super) fn clothesline(b: &mut Build<'_>) {
    grown(b, [0.8, 0.8, 0.8]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let metal = b.one(&[ALUMINIUM, GALVANISED, GREEN_METAL, PINE]);
    let cord = b.one(&[WHITE_PLASTIC, BLUE_PLASTIC, GREEN_PLASTIC]);
    let thin = 0.004;
    if b.rng.chance(0.6) {
        b.lathe("pole", [0.0; 3], &[(0.035, 0.0), (0.035, 0.2), (0.024, 0.22), (0.024, h)], metal);
        let level = h - 0.05;
        let corners: Vec<(f32, f32)> =
            [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)].map(|(a, c)| (a * (x - 0.02), c * (y - 0.02))).to_vec();
        b.jointed(vc_graph::asset::JointKind::Hinge, [0.0; 3], [0.0, 0.0, 1.0], (-PI, PI), |b| {
            for &(cx, cy) in &corners {
                // They end at the pole, around which they turn.
                let share = 0.031 / (cx.abs() + cy.abs());
                b.rod("arm", [cx * share, cy * share, h * 0.7], [cx, cy, level], 0.012, metal);
                b.rod(
                    "brace",
                    [cx * share * 0.87, cy * share * 0.87, level],
                    [cx * 0.5, cy * 0.5, h * 0.7 + (level - h * 0.7) * 0.49],
                    0.008,
                    metal,
                );
            }
            for (i, share) in [0.35, 0.55, 0.75, 0.97].into_iter().enumerate() {
                let z = h * 0.7 + (level - h * 0.7) * share;
                for k in 0..4 {
                    let ((x0, y0), (x1, y1)) = (corners[k], corners[(k + 1) % 4]);
                    b.rod("line", [x0 * share, y0 * share, z], [x1 * share, y1 * share, z], thin, cord);
                }
                b.hook(&format!("rod_{}", i + 1), [x * share * 0.5, y * share * 0.5, z], z - 0.1);
            }
            let z = level - (level - h * 0.7) * 0.03 + thin;
            b.inside("line", [-x * 0.47, y * 0.47, z], (0.06, 0.06), 0.2);
        });
    } else {
        for side in [-1.0, 1.0] {
            let cy = side * (y - 0.04);
            b.cylinder("post", [0.0, cy, 0.0], 0.035, h - 0.03, metal);
            b.rod("arm", [-x, cy, h - 0.05], [x, cy, h - 0.05], 0.022, metal);
        }
        let top = h - 0.05 + 0.02;
        for (i, cx) in spaced(4, -x + 0.05, x - 0.05).enumerate() {
            b.rod("line", [cx, -y + 0.04, top], [cx, y - 0.04, top], thin, cord);
            b.hook(&format!("rod_{}", i + 1), [cx, 0.0, top], top - 0.1);
        }
        b.inside("line", [-x + 0.05, 0.0, top + thin], (0.04, y * 0.5), 0.2);
        let cx = (x - 0.05) / 3.0;
        b.jointed(vc_graph::asset::JointKind::Hinge, [cx, 0.0, top], [0.0, 1.0, 0.0], (-0.5, 0.5), |b| {
            let bag = [(cx - 0.008, top), (cx + 0.008, top), (cx + 0.03, top - 0.18), (cx - 0.03, top - 0.18)];
            let bag = bag.map(|p| (p.0, p.1 - thin));
            b.prism("peg_bag", Axis::Y, [0.0, -y + 0.12, 0.0], &bag, 0.2, JUTE);
        });
    }
}
