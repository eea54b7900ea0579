//! Small vehicles: quad bikes, golf carts and trailers.

use std::f32::consts::{FRAC_PI_2, PI};

use super::wheel::{Rim, axled, fender};
use crate::material::*;
use crate::solid::{Axis, Build, P, at_least, spaced, tapered_tub};

const PAINTS: &[MaterialId] =
    &[RED_METAL, BLUE_METAL, GREEN_METAL, YELLOW_METAL, WHITE_METAL, ORANGE, BLACK_METAL, FOREST];

/// Four wheels: positions of the axles, half the track's outer width, wheel radius and width, and
/// the lateral distance of the body in which the axles end.
fn four_wheels(b: &mut Build<'_>, [fore, rear]: [f32; 2], half: f32, (r, width): (f32, f32), body: f32) {
    let rim = Rim::any(b);
    for (name, x, side) in
        [("wheel_fl", fore, 1.0), ("wheel_fr", fore, -1.0), ("wheel_rl", rear, 1.0), ("wheel_rr", rear, -1.0)]
    {
        axled(b, name, [x, side * (half - width / 2.0), r], (r, width), side, rim, body - 0.002);
    }
}

/// A quad bike: wide tyres, mudguards, a saddle and racks; a locker under the saddle.
pub(super) fn quad_bike(b: &mut Build<'_>) {
    at_least(b, [0.9, 0.5, 0.55]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (paint, r) = (b.one_of(PAINTS), (h * b.vary(0.23, 0.26)).min(x * 0.3));
    let width = y * b.vary(0.38, 0.46);
    let axles = [x - r - 0.01, -x + r + 0.01];
    four_wheels(b, axles, y, (r, width), y * 0.3);
    let (waist, low) = (r * 2.1, r * 0.75);
    b.block("frame", [axles[1], -y * 0.3, low], [axles[0], y * 0.3, waist], IRON);
    for axle in axles {
        for side in [-1.0, 1.0] {
            let at = [axle, side * y * 0.645, r];
            fender(b, at, (r, y * 0.345), (0.45, PI - 0.45), paint);
            let (a, c) = (side * y * 0.28, side * y * 0.9);
            let (low, high) = ([axle - r * 0.5, a.min(c), r * 2.0 + 0.02], [axle + r * 0.5, a.max(c), waist + 0.05]);
            b.rounded_block("mudguard", low, high, 0.02, paint);
        }
        let z = waist + 0.12;
        for cy in spaced(4, -y * 0.6, y * 0.6) {
            b.rod("rack", [axle - r * 0.8, cy, z], [axle + r * 0.8, cy, z], 0.011, IRON);
        }
        for dx in [-0.8, 0.8] {
            b.rod("rack", [axle + r * dx, -y * 0.6, z], [axle + r * dx, y * 0.6, z], 0.011, IRON);
        }
        for side in [-1.0, 1.0] {
            b.rod("rack", [axle, side * y * 0.6, waist], [axle, side * y * 0.6, z], 0.011, IRON);
        }
    }
    let seat = (h * 0.75).max(waist + 0.14);
    let (x0, x1, half, deep) = (axles[1] + r * 0.95, axles[0] - r * 1.2, y * 0.26, 0.1_f32.min(h * 0.1));
    tapered_tub(
        b,
        "locker",
        [(x0 + x1) / 2.0, 0.0, waist - 0.01],
        ((x1 - x0) / 2.0, half),
        ((x1 - x0) / 2.0, half),
        seat - deep - waist + 0.01,
        0.012,
        paint,
    );
    b.inside(
        "compartment",
        [(x0 + x1) / 2.0, 0.0, waist + 0.002],
        ((x1 - x0) / 2.0 - 0.02, half - 0.02),
        (seat - deep - waist - 0.01).max(0.02),
    );
    b.hinge([x1, 0.0, seat], [0.0, 1.0, 0.0], 1.2, |b| {
        b.rounded_block("seat", [x0, -half, seat - deep + 0.002], [x1, half, seat], 0.04, BLACK_LEATHER);
        b.top("seat", [(x0 + x1) / 2.0, 0.0, seat], ((x1 - x0) / 2.0 * 0.85, half * 0.8));
    });
    let head = [x1 + r * 0.3, 0.0, h - 0.05];
    b.hull(
        "tank",
        &[
            [x1 + 0.003, half, waist],
            [x1 + 0.003, -half, waist],
            [x1 + 0.003, half * 0.8, seat - 0.01],
            [x1 + 0.003, -half * 0.8, seat - 0.01],
            [axles[0] - r * 0.1, half, waist],
            [axles[0] - r * 0.1, -half, waist],
            [head[0] + 0.1, half * 0.7, seat + 0.02],
            [head[0] + 0.1, -half * 0.7, seat + 0.02],
        ],
        paint,
    );
    b.rod("column", [head[0] + 0.06, 0.0, seat - 0.02], head, 0.025, IRON);
    for side in [-1.0, 1.0] {
        b.pipe("handlebar", &[head, [head[0] - 0.06, side * y * 0.68, head[2] + 0.02]], 0.014, IRON);
        b.rod(
            "grip",
            [head[0] - 0.04, side * y * 0.45, head[2] + 0.014],
            [head[0] - 0.062, side * y * 0.72, head[2] + 0.021],
            0.02,
            RUBBER,
        );
        let lamp = [axles[0] + r * 0.35, side * y * 0.36, waist - 0.08];
        b.rod("headlight", lamp, [(lamp[0] + 0.12).min(x - 0.01), lamp[1], lamp[2]], 0.05_f32.min(y * 0.1), COOL_BULB);
        let (tx, ty, tz) = (axles[1] - (r + 0.024) * 0.825, side * y * 0.5, r + (r + 0.024) * 0.565);
        b.block("tail_light", [tx - 0.012, ty - 0.06, tz - 0.02], [tx + 0.012, ty + 0.06, tz + 0.02], SIGNAL_RED);
    }
    b.rod("bumper", [x - 0.025, -y * 0.4, r * 1.1], [x - 0.025, y * 0.4, r * 1.1], 0.02, IRON);
    for side in [-1.0, 1.0] {
        b.rod("bumper", [x - 0.025, side * y * 0.2, r * 1.1], [axles[0] - 0.02, side * y * 0.2, r * 1.1], 0.016, IRON);
    }
}

/// A golf cart: a bench under a roof on posts, and a bag well with a flap at the rear.
pub(super) fn golf_cart(b: &mut Build<'_>) {
    at_least(b, [1.2, 0.6, 0.9]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (paint, r) = (b.choose(&[WHITE_METAL, CREAM, GREEN_METAL, RED_METAL, NAVY]), h * b.vary(0.115, 0.13));
    let axles = [x - r * 1.6, -x + r * 1.9];
    four_wheels(b, axles, y, (r, y * 0.3), y * 0.6);
    let (floor, seat) = (r * 1.35, h * 0.4);
    let inner = y * 0.97;
    b.block("frame", [axles[1] - r, -y * 0.6, r * 0.8], [axles[0], y * 0.6, floor - 0.005], IRON);
    b.block("floor", [axles[1] + r * 1.2, -inner, floor - 0.05], [axles[0] - r * 1.15, inner, floor], GREY_RUBBER);
    let cowl = [
        (axles[0] - r * 1.2, floor - 0.06),
        (axles[0] - r * 1.2, h * 0.46),
        (axles[0] - r * 0.9, h * 0.46),
        (x - 0.06, floor + r * 1.3),
        (x - 0.02, floor + 0.02),
        (axles[0] + r * 1.1, floor - 0.05),
        (axles[0] + r * 1.1, r * 2.15),
        (axles[0] - r * 1.1, r * 2.15),
    ];
    b.prism("cowl", Axis::Y, [0.0, -inner, 0.0], &cowl, 2.0 * inner, paint);
    b.block("bumper", [x - 0.06, -y * 0.7, floor - 0.06], [x, y * 0.7, floor + 0.04], BLACK_PLASTIC);
    let bench = [axles[1] + r * 1.3, axles[1] + r * 1.3 + x * 0.42];
    b.block("base", [bench[0], -inner, floor - 0.02], [bench[1] - 0.06, inner, seat - 0.1], paint);
    let leather = b.choose(&[WHITE_LEATHER, TAN_LEATHER, BLACK_LEATHER]);
    b.rounded_block("seat", [bench[0], -inner, seat - 0.105], [bench[1], inner, seat], 0.04, leather);
    b.rounded_block("back", [bench[0] - 0.09, -inner, seat - 0.04], [bench[0] + 0.02, inner, h * 0.62], 0.04, leather);
    b.ledge(
        "seat",
        [(bench[0] + bench[1]) / 2.0 + 0.02, 0.0, seat],
        ((bench[1] - bench[0]) / 2.0 - 0.05, inner * 0.7),
        h * 0.2,
    );
    // The well for bags.
    let (w0, w1, t) = (-x + 0.03, bench[0] - 0.02, 0.015);
    let rim = floor + r * 2.2;
    let deck = r * 2.15;
    let under = deck - 0.06_f32.min(r * 0.1);
    b.block("well", [w0, -inner, under], [w1 + 0.03, inner, deck], paint);
    for side in [-1.0, 1.0] {
        let (near, far) = (side * (inner - 0.004), side * (inner + 2.0 * t).min(y));
        b.block("well", [w0, near.min(far), deck - 0.002], [w1, near.max(far), rim], paint);
    }
    b.block("well", [w1 - t, -inner + t, deck], [w1 + 0.02, inner - t, seat], paint);
    b.hinge([w0 - 0.002, 0.0, deck - 0.02], [0.0, -1.0, 0.0], FRAC_PI_2, |b| {
        b.block("flap", [w0 - 0.012, -inner, deck - 0.02], [w0 - 0.002, inner, rim], paint);
        b.block("handle", [w0 - 0.025, -0.08, rim - 0.05], [w0 - 0.01, 0.08, rim - 0.02], BLACK_PLASTIC);
        for cy in [-y * 0.8, y * 0.8] {
            let (low, high) = ([w0 - 0.022, cy - 0.05, deck + 0.03], [w0 - 0.011, cy + 0.05, deck + 0.06]);
            b.block("tail_light", low, high, SIGNAL_RED);
        }
    });
    b.inside(
        "compartment",
        [(w0 + bench[0] - 0.13) / 2.0, 0.0, deck],
        ((bench[0] - 0.13 - w0) / 2.0 - 0.01, inner - 0.03),
        h * 0.6 - deck,
    );
    let roof = h - 0.06;
    let post = 0.018;
    for side in [-1.0, 1.0] {
        let cy = side * (y - 0.06);
        b.rod("post", [axles[0] - r * 0.95, cy, h * 0.44], [axles[0] - r * 1.7, cy, roof + 0.01], post, IRON);
        b.rod("post", [bench[0] - 0.06, cy, deck - 0.02], [bench[0] - 0.1, cy, roof + 0.01], post, IRON);
        b.block(
            "headlight",
            [x - 0.14, side * y * 0.7 - 0.08, floor + r * 0.7],
            [x - 0.03, side * y * 0.7 + 0.08, floor + r * 1.1],
            COOL_BULB,
        );
    }
    b.rounded_block(
        "roof",
        [bench[0] - 0.25_f32.min(x * 0.2), -y, roof],
        [axles[0] - r * 1.2, y, h],
        0.025,
        b.style.appliance,
    );
    let hub = [bench[1] + 0.14, y * 0.45, h * 0.52];
    b.rod("column", [axles[0] - r * 1.15, hub[1], h * 0.42], hub, 0.015, IRON);
    b.lathe_along(
        "steering_wheel",
        hub,
        [hub[0] - 0.8, hub[1], hub[2] + 0.6],
        &[(0.16, 0.0), (0.16, 0.02), (0.13, 0.02), (0.13, 0.0), (0.16, 0.0)],
        BLACK_LEATHER,
    );
    b.rod("steering_wheel", [hub[0], hub[1] - 0.14, hub[2]], [hub[0], hub[1] + 0.14, hub[2]], 0.01, BLACK_LEATHER);
}

/// A car trailer: an open box with a tailgate, two wheels, a drawbar.
pub(super) fn car_trailer(b: &mut Build<'_>) {
    at_least(b, [1.2, 0.65, 0.4]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let r = (h * b.vary(0.26, 0.3)).min(x * 0.2);
    let width = y * 0.2;
    let (x0, x1) = (-x + 0.03, x - x * b.vary(0.5, 0.62));
    let half = y - width - 0.03;
    let (deck, mat) = (r * 1.25, b.choose(&[GALVANISED, ALUMINIUM, PINE, ANTHRACITE, BLUE_METAL]));
    let axle = (x0 + x1) / 2.0 - 0.05;
    let rim = Rim::plain(b);
    for (name, side) in [("wheel_l", 1.0), ("wheel_r", -1.0)] {
        axled(b, name, [axle, side * (y - width / 2.0), r], (r, width), side, rim, half * 0.6 - 0.002);
        let cy = side * (y - width / 2.0);
        let guard: Vec<P> = [-1.0, 1.0]
            .into_iter()
            .flat_map(|s| {
                [
                    [axle - r * 1.05, cy + s * width * 0.5, r * 1.6],
                    [axle - r * 0.6, cy + s * width * 0.5, r * 2.18],
                    [axle + r * 0.6, cy + s * width * 0.5, r * 2.18],
                    [axle + r * 1.05, cy + s * width * 0.5, r * 1.6],
                ]
            })
            .collect();
        let lift = |p: P, dz: f32| [p[0], p[1], p[2] + dz];
        // The mudguard has three plates so that the wheel stays free.
        for i in 0..3 {
            let strip: Vec<P> = [guard[i], guard[i + 1], guard[i + 4], guard[i + 5]]
                .into_iter()
                .flat_map(|p| [p, lift(p, 0.014)])
                .collect();
            b.hull("mudguard", &strip, BLACK_PLASTIC);
        }
        b.block(
            "stay",
            [axle - 0.03, (side * (half - 0.01)).min(cy), r * 2.185],
            [axle + 0.03, (side * (half - 0.01)).max(cy), r * 2.185 + 0.012],
            BLACK_PLASTIC,
        );
        b.block(
            "tail_light",
            [x0 - 0.01, side * half * 0.85 - 0.07, deck - 0.07],
            [x0 + 0.02, side * half * 0.85 + 0.07, deck - 0.012],
            SIGNAL_RED,
        );
    }
    b.block(
        "spring",
        [axle - 0.05, -half * 0.6, r * 0.85],
        [axle + 0.05, half * 0.6, deck - 0.03_f32.min(r * 0.09)],
        IRON,
    );
    b.block("floor", [x0, -half, deck - 0.035_f32.min(r * 0.1)], [x1, half, deck], b.style.wood);
    let covered = b.rng.chance(0.4);
    let side = if covered { deck + (h - deck) * b.vary(0.45, 0.6) } else { h - 0.003 };
    let t = 0.02;
    for s in [-1.0, 1.0] {
        b.block(
            "board",
            [x0 + t, s * (half - t / 2.0) - t / 2.0, deck],
            [x1, s * (half - t / 2.0) + t / 2.0, side],
            mat,
        );
        for share in [0.25, 0.75] {
            let cx = x0 + (x1 - x0) * share;
            b.block(
                "rib",
                [cx - 0.025, s * (half + 0.006) - 0.012, deck - 0.02],
                [cx + 0.025, s * (half + 0.006) + 0.012, side - 0.01],
                GALVANISED,
            );
        }
    }
    b.block("front", [x1 - t, -half + t, deck], [x1 - 0.001, half - t, side], mat);
    b.hinge([x0, 0.0, deck], [0.0, -1.0, 0.0], FRAC_PI_2 * 1.5, |b| {
        b.block("flap", [x0, -half + 0.003, deck + 0.003], [x0 + t - 0.002, half - 0.003, side - 0.003], mat);
        b.block(
            "plate",
            [x0 - 0.006, -0.25_f32.max(-half * 0.6), deck + 0.05],
            [x0 + 0.002, 0.25_f32.min(half * 0.6), deck + 0.15_f32.min((side - deck) * 0.6)],
            WHITE_PLASTIC,
        );
    });
    if covered {
        let cloth = b.choose(&[NAVY_FABRIC, GREY_FABRIC, GREEN_FABRIC, BLUE_FABRIC]);
        let lid = 0.02;
        b.block("cover", [x0, -half, h - lid], [x1, half, h], cloth);
        for s in [-1.0, 1.0] {
            b.block(
                "cover",
                [x0, s * (half - 0.007) - 0.006, side - 0.003],
                [x1, s * (half - 0.007) + 0.006, h - lid],
                cloth,
            );
        }
        b.block("cover", [x1 - 0.014, -half + 0.02, side - 0.002], [x1 - 0.002, half - 0.02, h - lid], cloth);
    }
    let room = if covered { h - deck - 0.03 } else { h };
    b.inside("compartment", [(x0 + x1) / 2.0, 0.0, deck], ((x1 - x0) / 2.0 - 0.03, half - 0.03), room);
    let (hitch, bar) = (r * 1.1, 0.03_f32.min(r * 0.12));
    for s in [-1.0, 1.0] {
        b.rod("drawbar", [x1 - 0.1, s * half * 0.6, hitch], [x - 0.25, 0.0, hitch], bar * 0.8, GALVANISED);
    }
    b.rod("drawbar", [x1 - 0.2, 0.0, hitch], [x - 0.06, 0.0, hitch], bar, GALVANISED);
    b.block("beam", [x1 - 0.14, -half * 0.7, hitch - 0.03], [x1 - 0.06, half * 0.7, deck - 0.02], GALVANISED);
    b.ball("coupling", [x - 0.055, 0.0, hitch], 0.05, IRON);
    let jack = x1 + (x - x1) * 0.6;
    let cy = bar + 0.02;
    b.cylinder("jack", [jack, cy, 0.05], 0.022, hitch, GALVANISED);
    b.rod("jack", [jack, cy - 0.02, 0.05], [jack, cy + 0.02, 0.05], 0.05, RUBBER);
}
