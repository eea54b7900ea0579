//! Stationary bikes; the user faces the front.

use crate::material::*;
use crate::solid::{Axis, Build, P, Proportional, SIDES, oval_outline, pitched, spare};

/// A seat post with a saddle.
fn saddle(b: &mut Build<'_>, foot: P, seat: P, mat: MaterialId) {
    b.pole("post", foot, seat, 0.02, CHROME);
    let ring = |x: f32, y: f32, z: f32| ([seat[0] + x, 0.0, seat[2] + z], y, 0.022);
    let shape = [
        ring(-0.24, 0.34, 0.012),
        ring(-0.14, 0.42, 0.015),
        ring(0.02, 0.24, 0.012),
        ring(0.18, 0.1, 0.01),
        ring(0.24, 0.06, 0.004),
    ];
    b.skin("saddle", Axis::X, &shape, mat);
}

/// Two cranks with pedals on an axle.
pub(super) fn pedals(b: &mut Build<'_>, at: P, reach: f32, mat: MaterialId) {
    b.wheel("crank_wheel", Axis::Y, at, (reach * 0.55, b.size.y * 0.34), mat);
    b.pole("axle", [at[0], -0.44, at[2]], [at[0], 0.44, at[2]], 0.012, STEEL);
    for y in SIDES {
        let (dx, dz) = (y * reach * 1.5 / b.size.x, y * reach * 0.6 / b.size.z);
        let end = [at[0] + dx, y * 0.42, at[2] + dz];
        b.plank("crank", [at[0], y * 0.4, at[2]], end, (0.012, 0.025), STEEL);
        b.slab(
            "pedal",
            [end[0] - 0.08, y * 0.6 - 0.2, end[2] - 0.01],
            [end[0] + 0.08, y * 0.6 + 0.2, end[2] + 0.012],
            BLACK_PLASTIC,
        );
    }
}

/// A display that leans towards the user.
pub(super) fn display(b: &mut Build<'_>, at: P, half: (f32, f32), lean: f32, case: MaterialId) {
    let (w, h) = half;
    let place = b.p(at);
    b.posed(pitched(place, lean), |b| {
        b.rounded_block("console", [-0.014, -w, -h], [0.02, w, h], 0.012, case);
        b.block("screen", [-0.017, -w * 0.85, -h * 0.4], [-0.01, w * 0.85, h * 0.85], PICTURE_DARK);
        b.block("reading", [-0.019, -w * 0.7, h * 0.1], [-0.012, w * 0.1, h * 0.6], LED);
        for i in 0..3 {
            let y = w * (-0.5 + 0.5 * i as f32);
            b.block("key", [-0.018, y - w * 0.15, -h * 0.8], [-0.01, y + w * 0.15, -h * 0.6], GREY_PLASTIC);
        }
    });
}

/// Feet across the floor at both ends.
pub(super) fn feet(b: &mut Build<'_>, at: (f32, f32), mat: MaterialId) {
    let r = b.size.z * 0.03;
    let z = r / b.size.z;
    for x in [at.0, at.1] {
        b.pole("foot", [x, -0.98, z], [x, 0.98, z], r, mat);
        for y in SIDES {
            b.pole("foot_cap", [x, y, z], [x, y * 0.86, z], r * 0.99, RUBBER);
        }
    }
}

/// Handlebars with grips; their arms point to the front.
fn bars(b: &mut Build<'_>, at: P, mat: MaterialId) {
    let r = 0.013;
    for y in SIDES {
        let bend = [
            at,
            [at[0], y * 0.75, at[2]],
            [at[0] - 0.12, y * 0.82, at[2] + 0.03],
            [at[0] + 0.22, y * 0.7, at[2] + 0.05],
        ];
        b.pole("bar", bend[0], bend[1], r, mat);
        b.pole("grip", bend[1], bend[2], r * 1.5, RUBBER);
        b.pole("grip", bend[1], bend[3], r * 1.4, RUBBER);
    }
}

/// An exercise bike: a closed case over its wheel, an upright post and a display.
pub(super) fn upright(b: &mut Build<'_>) {
    spare(b, 0.0, 0.0, 0.01);
    let (case, trim) = (
        b.choose(&[WHITE_PLASTIC, GREY_PLASTIC, BLACK_PLASTIC]),
        b.choose(&[RED_PLASTIC, BLACK_PLASTIC, GREY_PLASTIC, BLUE_PLASTIC]),
    );
    feet(b, (-0.84, 0.84), BLACK_METAL);
    b.plank("frame", [-0.86, 0.0, 0.05], [0.86, 0.0, 0.05], (0.07, 0.05), case);
    let z = b.vary(0.24, 0.28);
    let shape: Vec<_> = oval_outline((0.3, z), (0.5, z - 0.03), 16);
    b.side_outline("case", (-0.26, 0.26), &shape, case);
    let inner: Vec<_> = oval_outline((0.3, z), (0.34, (z - 0.03) * 0.68), 16);
    b.side_outline("cover", (-0.3, 0.3), &inner, trim);
    pedals(b, [0.06, 0.0, z * 0.9], (b.size.z * 0.1).min(0.15), trim);
    b.plank("tube", [-0.1, 0.0, 0.08], [-0.42, 0.0, 0.52], (0.06, 0.08), case);
    saddle(b, [-0.4, 0.0, 0.45], [-0.52, 0.0, 0.66], BLACK_LEATHER);
    b.plank("mast", [0.4, 0.0, z], [0.63, 0.0, 0.9], (0.06, 0.08), case);
    bars(b, [0.6, 0.0, 0.8], BLACK_METAL);
    display(b, [0.6, 0.0, 0.92], ((b.size.y * 0.3).min(0.16), b.size.z * 0.07), 0.35, BLACK_PLASTIC);
}

/// A spin bike: an open flywheel in front and racing handlebars.
pub(super) fn spin(b: &mut Build<'_>) {
    spare(b, 0.0, 0.0, 0.02);
    let (frame, wheel) = (
        b.choose(&[BLACK_METAL, WHITE_METAL, RED_METAL, YELLOW_METAL, SILVER_METAL]),
        b.choose(&[CHROME, RED_METAL, STEEL]),
    );
    feet(b, (-0.82, 0.8), frame);
    let r = (b.size.z * 0.2).min(b.size.x * 0.22);
    let at = [0.98 - 2.0 * r / b.size.x - 0.02, 0.0, r / b.size.z + 0.06];
    let hole = [(r * 0.74, -0.014), (r, -0.014), (r, 0.014), (r * 0.74, 0.014), (r * 0.74, -0.014)];
    let c = b.p(at);
    b.lathe_along("flywheel", c, [c[0], 1.0, c[2]], &hole, wheel);
    b.wheel("web", Axis::Y, at, (r * 0.75, 0.01), BLACK_METAL);
    b.wheel("hub", Axis::Y, at, (r * 0.18, b.size.y * 0.22), STEEL);
    for y in SIDES {
        b.plank("fork", [at[0], y * 0.16, at[2]], [0.3, y * 0.14, 0.56], (0.025, 0.05), frame);
        b.plank("stay", [at[0], y * 0.16, at[2]], [0.8, y * 0.16, 0.04], (0.025, 0.05), frame);
    }
    let hub = [-0.12, 0.0, 0.26];
    b.plank("frame", [-0.82, 0.0, 0.05], [-0.1, 0.0, 0.24], (0.06, 0.07), frame);
    b.plank("frame", [-0.1, 0.0, 0.22], [-0.36, 0.0, 0.58], (0.05, 0.07), frame);
    b.plank("frame", [-0.12, 0.0, 0.24], [0.36, 0.0, 0.6], (0.05, 0.07), frame);
    let guard = [(hub[0] - 0.16, 0.18), (at[0], at[2] - 0.05), (at[0], at[2] + 0.05), (hub[0] - 0.1, 0.35)];
    b.side_outline("chain_guard", (0.2, 0.27), &guard, BLACK_PLASTIC);
    pedals(b, hub, (b.size.z * 0.1).min(0.15), BLACK_METAL);
    saddle(b, [-0.34, 0.0, 0.54], [-0.48, 0.0, 0.84], BLACK_LEATHER);
    b.plank("slide", [-0.66, 0.0, 0.835], [-0.3, 0.0, 0.835], (0.035, 0.03), STEEL);
    b.pole("post", [0.33, 0.0, 0.55], [0.44, 0.0, 0.92], 0.022, CHROME);
    bars(b, [0.44, 0.0, 0.92], BLACK_METAL);
    b.pole("brake", [0.14, 0.0, 0.44], [0.2, 0.0, 0.53], 0.014, RED_PLASTIC);
    let bottle = b.p([0.3, 0.3, 0.86]);
    b.cylinder("bottle", bottle, 0.03, b.size.z * 0.1, BLUE_PLASTIC);
    b.plank("bottle_cage", [0.42, 0.0, 0.88], [0.3, 0.3, 0.88], (0.02, 0.02), BLACK_METAL);
}

/// A recumbent bike: a chair behind the pedals with handles beside it.
pub(super) fn recumbent(b: &mut Build<'_>) {
    spare(b, 0.0, 0.0, 0.01);
    let (case, trim) = (
        b.choose(&[WHITE_PLASTIC, GREY_PLASTIC, BLACK_PLASTIC]),
        b.choose(&[BLACK_PLASTIC, RED_PLASTIC, BLUE_PLASTIC]),
    );
    feet(b, (-0.88, 0.88), BLACK_METAL);
    b.plank("frame", [-0.9, 0.0, 0.07], [0.9, 0.0, 0.07], (0.1, 0.07), case);
    b.side_outline(
        "case",
        (-0.3, 0.3),
        &[(0.25, 0.06), (0.95, 0.06), (0.96, 0.3), (0.75, 0.52), (0.45, 0.52), (0.25, 0.34)],
        case,
    );
    b.side_outline("cover", (-0.33, 0.33), &[(0.45, 0.16), (0.85, 0.16), (0.85, 0.3), (0.7, 0.42), (0.48, 0.42)], trim);
    pedals(b, [0.36, 0.0, 0.32], (b.size.z * 0.11).min(0.15), trim);
    b.plank("mast", [0.62, 0.0, 0.5], [0.5, 0.0, 0.9], (0.06, 0.08), case);
    display(b, [0.48, 0.0, 0.92], ((b.size.y * 0.28).min(0.18), b.size.z * 0.075), 0.3, BLACK_PLASTIC);
    b.plank("rail", [-0.8, 0.0, 0.18], [0.2, 0.0, 0.24], (0.08, 0.05), STEEL);
    b.slab("support", [-0.6, -0.2, 0.08], [-0.3, 0.2, 0.36], case);
    b.pad("seat", [-0.68, -0.62, 0.34], [-0.14, 0.62, 0.42], 0.03, BLACK_LEATHER);
    b.plank("backrest", [-0.64, 0.0, 0.4], [-0.86, 0.0, 0.86], (b.size.y * 0.6, 0.06), BLACK_LEATHER);
    b.plank("spine", [-0.55, 0.0, 0.36], [-0.8, 0.0, 0.36], (0.06, 0.04), case);
    b.plank("spine", [-0.79, 0.0, 0.35], [-0.92, 0.0, 0.8], (0.06, 0.04), case);
    b.plank("spine", [-0.9, 0.0, 0.72], [-0.79, 0.0, 0.72], (0.06, 0.04), case);
    for y in SIDES {
        b.pole("handle", [-0.5, y * 0.62, 0.36], [-0.28, y * 0.86, 0.52], 0.014, BLACK_METAL);
        b.pole("grip", [-0.28, y * 0.86, 0.52], [-0.16, y * 0.86, 0.55], 0.02, RUBBER);
    }
}
