//! Toy cars, trucks, trains, planes and boats, and ride-on cars.

use crate::material::*;
use crate::object::palette::*;
use crate::solid::{Axis, Build, Proportional, SIDES, arc_outline, pitched};

/// Four wheels whose treads touch the floor and whose outer faces touch the sides.
fn wheels(b: &mut Build<'_>, axles: (f32, f32), radius: f32, width: f32, hub: MaterialId) {
    let side = 1.0 - width / b.size.y;
    let z = radius / b.size.z;
    for x in [axles.0, axles.1] {
        b.pole("axle", [x, -side, z], [x, side, z], radius * 0.2, IRON);
    }
    for (x, y) in [axles.0, axles.1].into_iter().flat_map(|x| SIDES.map(|y| (x, y))) {
        b.wheel("wheel", Axis::Y, [x, y * (side - 0.01), z], (radius, width * 0.96), RUBBER);
        b.wheel("hub", Axis::Y, [x, y * side, z], (radius * 0.55, width), hub);
    }
}

/// A toy car or a remote-controlled one: saloon, racing car, off-roader, bubble car.
pub(super) fn car(b: &mut Build<'_>) {
    let remote = b.class == "rc_car";
    let paint = if b.rng.chance(0.25) && !remote { b.one_of(TOY_WOODS) } else { b.one_of(BRIGHT) };
    let share = if remote { 0.3 } else { b.vary(0.19, 0.24) };
    let r = (b.size.z * share).min(b.size.x * 0.16);
    let width = (b.size.y * 0.2).min(r * 1.2);
    let hub = b.choose(&[CHROME, YELLOW_PLASTIC, WHITE_PLASTIC, RED_PLASTIC]);
    wheels(b, (-0.6, 0.6), r, width, hub);
    let sill = r / b.size.z * 0.8;
    let side = if remote { 1.0 - 2.0 * width / b.size.y } else { 0.92 };
    match b.rng.below(if remote { 2 } else { 4 }) {
        0 => racer(b, sill, side.min(0.7), paint),
        1 => shell(b, sill, side, (paint, 0.12), [-0.55, -0.4, 0.15, 0.5]),
        2 => shell(b, sill, side, (paint, 0.2), [-0.9, -0.85, 0.35, 0.5]),
        _ => shell(b, sill, side, (paint, 0.3), [-0.75, -0.35, 0.2, 0.6]),
    }
    if remote {
        b.pole("aerial", [-0.8, 0.5, sill], [-0.8, 0.5, 1.0], 0.002, BLACK_PLASTIC);
        b.pad("bumper", [0.85, -0.6, sill * 0.8], [1.0, 0.6, sill * 1.4], 0.01, BLACK_PLASTIC);
    }
}

/// A closed body: lower part, glazed cabin between four positions along X, lamps. The bonnet slopes
/// down by a fraction.
fn shell(b: &mut Build<'_>, sill: f32, y: f32, (paint, fall): (MaterialId, f32), cabin: [f32; 4]) {
    let waist = sill + (1.0 - sill) * 0.5;
    let nose = waist - (waist - sill) * fall;
    let body = [
        (-0.98, sill),
        (0.97, sill),
        (0.98, nose - 0.05),
        (0.9, nose),
        (cabin[3], waist),
        (-0.9, waist),
        (-0.98, waist - 0.06),
    ];
    b.side_outline("body", (-y, y), &body, paint);
    let [a, c, d, e] = cabin;
    let (low, high) = (waist - 0.01, 0.97);
    let glass = |y0: f32, y1: f32| {
        let (low_end, high_end) = ([(a, y0), (e, y0)], [(c, y1), (d, y1)]);
        let ring = |ends: [(f32, f32); 2], z: f32| ends.into_iter().flat_map(move |(x, y)| [[x, y, z], [x, -y, z]]);
        ring(low_end, low).chain(ring(high_end, high)).collect::<Vec<_>>()
    };
    b.chunk("windows", &glass(y * 0.9, y * 0.74), BLACK_GLASS);
    b.slab("roof", [c, -y * 0.76, high], [d, y * 0.76, 1.0], paint);
    for ((foot, head), s) in [(a, c), (e, d)].into_iter().flat_map(|p| SIDES.map(|s| (p, s))) {
        let (from, to) = ([foot, s * y * 0.88, low], [head, s * y * 0.74, high]);
        let thick = b.size.z * 0.05;
        b.plank("pillar", from, to, (thick, thick), paint);
    }
    let lamp = b.size.z * 0.07;
    for side in SIDES {
        b.wheel("headlamp", Axis::X, [0.97, side * y * 0.7, nose - 0.14], (lamp, b.size.x * 0.01), WARM_BULB);
        b.slab(
            "rear_lamp",
            [-0.99, side * y * 0.7 - 0.1, waist - 0.16],
            [-0.97, side * y * 0.7 + 0.1, waist - 0.08],
            RED_PLASTIC,
        );
    }
    b.slab("grille", [0.97, -y * 0.45, sill + 0.04], [0.99, y * 0.45, nose - 0.12], CHROME);
}

/// An open racing car with wings and a number.
fn racer(b: &mut Build<'_>, sill: f32, y: f32, paint: MaterialId) {
    let trim = b.one_of(BRIGHT);
    let body = [(-0.9, sill), (0.9, sill), (0.98, sill + 0.1), (0.3, sill + 0.28), (-0.1, 0.62), (-0.9, 0.68)];
    b.side_outline("body", (-y * 0.6, y * 0.6), &body, paint);
    b.side_outline("flank", (-y, y), &[(-0.45, sill + 0.02), (0.2, sill + 0.02), (0.1, 0.48), (-0.4, 0.54)], trim);
    b.ellipsoid("driver", [-0.15, 0.0, 0.72], [0.14, y * 0.34, 0.17], trim);
    b.slab("visor", [-0.06, -y * 0.26, 0.72], [0.0, y * 0.26, 0.8], BLACK_GLASS);
    b.slab("wing", [-0.98, -0.9, 0.88], [-0.7, 0.9, 0.94], trim);
    for s in SIDES {
        b.slab("strut", [-0.9, s * y * 0.5 - 0.04, 0.6], [-0.78, s * y * 0.5 + 0.04, 0.89], BLACK_PLASTIC);
    }
    b.slab("wing", [0.82, -0.9, sill * 0.9], [0.99, 0.9, sill * 0.9 + 0.07], trim);
}

/// A ride-on car in which a child sits inside or astride.
pub(super) fn ride_on(b: &mut Build<'_>) {
    let (paint, trim) = (b.one_of(BRIGHT), b.choose(&[BLACK_PLASTIC, WHITE_PLASTIC, YELLOW_PLASTIC]));
    let r = (b.size.z * 0.24).min(b.size.x * 0.16);
    wheels(b, (-0.58, 0.58), r, (b.size.y * 0.2).min(r * 0.9), trim);
    let sill = r / b.size.z * 0.7;
    let high = b.vary(0.6, 0.7);
    let side = [
        (-0.97, sill + 0.1),
        (-0.85, sill),
        (0.9, sill),
        (0.98, sill + 0.12),
        (0.9, high - 0.1),
        (0.35, high),
        (0.2, 0.42),
        (-0.45, 0.42),
        (-0.55, high),
        (-0.9, high - 0.05),
    ];
    b.side_outline("body", (-0.78, 0.78), &side, paint);
    b.pad("seat", [-0.46, -0.5, 0.4], [0.05, 0.5, 0.47], 0.015, trim);
    b.pad("backrest", [-0.62, -0.5, 0.42], [-0.48, 0.5, 0.95], 0.02, trim);
    b.pole("column", [0.4, 0.0, high - 0.08], [0.2, 0.0, 0.86], 0.012, BLACK_PLASTIC);
    b.posed(pitched(b.p([0.19, 0.0, 0.87]), -0.7), |b| {
        let wheel = (b.size.y * 0.22).min(b.size.z * 0.15);
        b.torus("steering_wheel", Axis::Z, [0.0; 3], (wheel * 0.85, wheel * 0.1), BLACK_PLASTIC);
        b.slab("spoke", [-0.02, -0.36, -0.012], [0.02, 0.36, 0.012], BLACK_PLASTIC);
    });
    if b.rng.chance(0.5) {
        b.chunk(
            "windscreen",
            &[
                [0.5, 0.7, high - 0.03],
                [0.5, -0.7, high - 0.03],
                [0.38, 0.62, 0.98],
                [0.38, -0.62, 0.98],
                [0.47, 0.7, high - 0.03],
                [0.47, -0.7, high - 0.03],
                [0.36, 0.62, 0.98],
                [0.36, -0.62, 0.98],
            ],
            CLEAR_PLASTIC,
        );
    } else {
        b.pole("push_bar", [-0.85, 0.5, high - 0.1], [-0.95, 0.5, 0.97], 0.011, trim);
        b.pole("push_bar", [-0.85, -0.5, high - 0.1], [-0.95, -0.5, 0.97], 0.011, trim);
        b.pole("push_bar", [-0.95, 0.55, 0.97], [-0.95, -0.55, 0.97], 0.012, trim);
    }
    for y in SIDES {
        b.ellipsoid("headlamp", [0.9, y * 0.5, high - 0.17], [0.08, 0.14, 0.06], WARM_BULB);
    }
    b.slab("grille", [0.93, -0.3, sill + 0.1], [1.0, 0.3, sill + 0.22], CHROME);
}

/// A toy lorry with a tipping bed.
pub(super) fn truck(b: &mut Build<'_>) {
    let (cab, bed) = (b.one_of(BRIGHT), b.choose(&[YELLOW_PLASTIC, GREY_PLASTIC, RED_PLASTIC, GREEN_PLASTIC, BEECH]));
    let r = (b.size.z * 0.17).min(b.size.x * 0.12);
    let hub = b.choose(&[YELLOW_PLASTIC, WHITE_PLASTIC, CHROME]);
    wheels(b, (-0.55, 0.62), r, b.size.y * 0.2, hub);
    let axle = r / b.size.z;
    b.slab("chassis", [-0.9, -0.6, axle * 0.9], [0.97, 0.6, axle * 1.9], BLACK_PLASTIC);
    let base = axle * 1.85;
    let front = [(0.42, base), (0.98, base), (1.0, 0.6), (0.88, 0.62), (0.8, 0.99), (0.42, 0.99)];
    b.side_outline("cab", (-0.86, 0.86), &front, cab);
    b.plank("windscreen", [0.88, 0.0, 0.65], [0.815, 0.0, 0.94], (b.size.y * 0.76, b.size.x * 0.008), BLACK_GLASS);
    for y in SIDES {
        b.slab("window", [0.5, y * 0.865 - 0.01, 0.66], [0.76, y * 0.865 + 0.01, 0.92], BLACK_GLASS);
        b.wheel("headlamp", Axis::X, [0.995, y * 0.6, base + 0.12], (b.size.z * 0.04, b.size.x * 0.01), WARM_BULB);
    }
    let floor = axle * 1.87;
    let anchor = b.p([-0.85, 0.0, floor]);
    b.hinge(anchor, [0.0, -1.0, 0.0], 0.8, |b| {
        b.slab("bed", [-0.98, -0.9, floor], [0.36, 0.9, floor + 0.05], bed);
        for y in SIDES {
            b.slab("bed_side", [-0.98, y * 0.86 - 0.04, floor + 0.05], [0.36, y * 0.86 + 0.04, 0.85], bed);
        }
        b.slab("bed_front", [0.3, -0.82, floor + 0.05], [0.36, 0.82, 0.95], bed);
        b.slab("bed_rear", [-0.98, -0.82, floor + 0.05], [-0.92, 0.82, 0.75], bed);
        b.inner_floor("bed", [-0.31, 0.0, floor + 0.05], (0.58, 0.78), 0.8 - floor);
    });
}

/// A steam engine, with wagons if the size is long enough.
pub(super) fn train(b: &mut Build<'_>) {
    let (paint, trim) =
        (b.choose(&[RED, BLUE, GREEN, BLACK, RED_PLASTIC, BLUE_PLASTIC]), b.choose(&[YELLOW, GOLD, RED]));
    let wagons = ((b.size.x / b.size.y.max(1e-3) - 2.0) / 2.4).floor().clamp(0.0, 3.0);
    let pitch = 2.0 / (wagons + 1.0);
    for i in 0..=(wagons as usize) {
        let high = 1.0 - pitch * i as f32;
        let low = (high - pitch * 0.9).max(-1.0);
        if i > 0 {
            b.pole(
                "coupling",
                [high - pitch * 0.1, 0.0, 0.24],
                [high + pitch * 0.16, 0.0, 0.24],
                b.size.z * 0.04,
                IRON,
            );
            let load = b.one_of(PAINTS);
            b.within([low, -1.0, 0.0], [high, 1.0, 1.0], |b| wagon(b, load));
        } else {
            b.within([low, -1.0, 0.0], [high, 1.0, 1.0], |b| engine(b, paint, trim));
        }
    }
}

fn engine(b: &mut Build<'_>, paint: MaterialId, trim: MaterialId) {
    bogie(b, paint);
    let r = (b.size.z * 0.24).min(b.size.y * 0.4);
    b.pole("boiler", [-0.3, 0.0, 0.53], [0.86, 0.0, 0.53], r, paint);
    b.pole("boiler_band", [0.4, 0.0, 0.53], [0.5, 0.0, 0.53], r * 1.05, trim);
    b.pole("smokebox", [0.85, 0.0, 0.53], [0.95, 0.0, 0.53], r * 0.9, BLACK);
    let base = [b.size.x * 0.31, 0.0, b.size.z * 0.53 + r * 0.9];
    let (w, h) = (r * 0.5, b.size.z * 0.995 - base[2]);
    b.lathe("funnel", base, &[(w * 0.6, 0.0), (w * 0.6, h * 0.5), (w, h)], trim);
    b.ellipsoid("dome", [0.15, 0.0, 0.76], [0.16, 0.34, 0.1], trim);
    b.slab("cab", [-0.92, -0.85, 0.28], [-0.3, 0.85, 0.88], paint);
    b.slab("cab_roof", [-0.99, -0.98, 0.88], [-0.24, 0.98, 0.95], trim);
    for y in SIDES {
        b.slab("window", [-0.76, y * 0.855 - 0.012, 0.56], [-0.46, y * 0.855 + 0.012, 0.8], BLACK_GLASS);
    }
    b.chunk(
        "cowcatcher",
        &[[0.8, 0.7, 0.06], [0.8, -0.7, 0.06], [0.8, 0.7, 0.28], [0.8, -0.7, 0.28], [1.0, 0.0, 0.06]],
        trim,
    );
}

/// A frame on four wheels.
fn bogie(b: &mut Build<'_>, paint: MaterialId) {
    b.slab("frame", [-0.93, -0.7, 0.2], [0.88, 0.7, 0.3], paint);
    let r = (b.size.z * 0.15).min(b.size.x * 0.2);
    wheels(b, (-0.55, 0.5), r, b.size.y * 0.12, RED);
}

/// An open wagon with a load, or a coach with windows.
fn wagon(b: &mut Build<'_>, paint: MaterialId) {
    bogie(b, BLACK);
    if b.rng.chance(0.5) {
        b.slab("coach", [-0.95, -0.85, 0.29], [0.95, 0.85, 0.84], paint);
        b.slab("coach_roof", [-1.0, -0.95, 0.84], [1.0, 0.95, 0.92], WHITE);
        b.slab("windows", [-0.8, -0.87, 0.55], [0.8, 0.87, 0.76], BLACK_GLASS);
    } else {
        b.slab("tub", [-0.95, -0.85, 0.29], [0.95, 0.85, 0.6], paint);
        for x in [-0.5, 0.0, 0.5] {
            b.pole("log", [x - 0.2, -0.7, 0.64], [x + 0.2, 0.7, 0.64], b.size.z * 0.1, BARK);
        }
    }
}

/// A ring of wooden track with a bridge, signals and, if the height allows it, a train.
pub(super) fn track(b: &mut Build<'_>) {
    let wood = b.one_of(TOY_WOODS);
    let gauge = (b.size.x.min(b.size.y) * 0.08).clamp(0.01, 0.05);
    let (gx, gy) = (2.0 * gauge / b.size.x, 2.0 * gauge / b.size.y);
    let thick = (0.012 / b.size.z).min(0.9);
    let straight = ((b.size.y - b.size.x) / b.size.y).max(0.0);
    let bend = 1.0 - straight;
    for y in SIDES {
        let round = |inset: f32| {
            arc_outline(
                (0.0, y * straight),
                (1.0 - gx * inset, y * (bend - gy * inset)),
                (0.0, std::f32::consts::PI),
                17,
            )
        };
        let ring = |a: f32, c: f32| round(a).into_iter().chain(round(c).into_iter().rev()).collect::<Vec<_>>();
        b.plan_outline("bend", (0.0, thick), &ring(0.0, 1.0), wood);
        for groove in [0.22, 0.68] {
            b.plan_outline("groove", (thick * 0.6, thick * 1.1), &ring(groove, groove + 0.1), WALNUT);
        }
        if straight > 0.0 {
            let edge = if y > 0.0 { (1.0 - gx, 1.0) } else { (-1.0, gx - 1.0) };
            b.slab("straight", [edge.0, -straight, 0.0], [edge.1, straight, thick], wood);
            for share in [0.22, 0.68] {
                let x = edge.0 + gx * share;
                b.slab("groove", [x, -straight, thick * 0.6], [x + gx * 0.1, straight, thick * 1.1], WALNUT);
            }
        }
    }
    if b.size.z > 0.035 {
        scenery(b, (gx, gy), thick);
    }
}

/// A tunnel over the track, a station and two trees in the centre.
fn scenery(b: &mut Build<'_>, (gx, gy): (f32, f32), thick: f32) {
    let paint = b.one_of(PAINTS);
    let arch = |w: f32, top: f32| arc_outline((1.0 - gx * 0.5, 0.0), (gx * w, top), (0.0, std::f32::consts::PI), 9);
    let mut shell = arch(0.5, 0.9);
    shell.extend(arch(0.42, 0.78).into_iter().rev());
    let shell: Vec<_> = shell.into_iter().map(|(x, z)| (x, z.max(thick * 1.05))).collect();
    b.side_outline("tunnel", (-gy * 0.8, gy * 0.8), &shell, paint);
    b.slab("station", [-0.3, -gy * 1.2, 0.0], [0.2, gy * 1.2, 0.55], CREAM);
    b.side_outline("station_roof", (-gy * 1.35, gy * 1.35), &[(-0.38, 0.54), (0.28, 0.54), (-0.05, 0.98)], RED);
    let r = b.size.z * 0.2;
    for (x, y) in [(0.1, 0.35), (-0.25, -0.4)] {
        let foot = b.p([x, y, 0.0]);
        b.cylinder("trunk", foot, r * 0.3, b.size.z * 0.3, BARK);
        b.cone("tree", [foot[0], foot[1], b.size.z * 0.25], r, b.size.z * 0.65, GREEN);
    }
}

/// A toy aeroplane: propeller or jet, with wheels.
pub(super) fn airplane(b: &mut Build<'_>) {
    let (paint, trim) = (b.one_of(BRIGHT), b.choose(&[WHITE_PLASTIC, YELLOW_PLASTIC, RED_PLASTIC, BEECH]));
    let jet = b.rng.chance(0.4);
    let girth = (b.size.z * 0.4 / b.size.y).min(0.2);
    let ring = |x: f32, z: f32, s: f32| ([x, 0.0, z], girth * s, 0.2 * s);
    let tip = if jet { 1.0 } else { 0.88 };
    let hull = [
        ([-0.98, 0.0, 0.62], 0.0, 0.0),
        ring(-0.8, 0.58, 0.4),
        ring(-0.2, 0.52, 0.95),
        ring(0.45, 0.5, 1.0),
        ring(tip - 0.12, 0.48, 0.75),
        ([tip, 0.0, 0.47], 0.0, 0.0),
    ];
    b.skin("fuselage", Axis::X, &hull, paint);
    let level = if jet { 0.44 } else { 0.68 };
    let sweep = if jet { 0.45 } else { 0.0 };
    let wing =
        [(0.4, 0.0), (0.3 - sweep, 1.0), (0.05 - sweep, 1.0), (-0.1, 0.0), (0.05 - sweep, -1.0), (0.3 - sweep, -1.0)];
    b.plan_outline("wing", (level, level + 0.06), &wing, trim);
    let tail = [(-0.7, 0.0), (-0.85, 0.38), (-0.98, 0.38), (-0.95, 0.0), (-0.98, -0.38), (-0.85, -0.38)];
    b.plan_outline("tailplane", (0.6, 0.64), &tail, trim);
    b.side_outline("fin", (-0.03, 0.03), &[(-0.66, 0.6), (-0.98, 0.6), (-1.0, 1.0), (-0.86, 1.0)], trim);
    b.ellipsoid("cockpit", [0.4, 0.0, 0.66], [0.2, girth * 0.7, 0.12], BLACK_GLASS);
    if jet {
        for y in SIDES {
            b.wheel("engine", Axis::X, [0.1, y * 0.42, 0.36], (b.size.z * 0.08, b.size.x * 0.14), GREY_PLASTIC);
        }
    } else {
        b.pole("spinner", [0.84, 0.0, 0.47], [1.0, 0.0, 0.47], b.size.z * 0.05, YELLOW_PLASTIC);
        let span = (0.8 * b.size.z / b.size.y).min(0.6);
        b.slab("propeller", [0.92, -span, 0.43], [0.95, span, 0.51], BLACK_PLASTIC);
    }
    let r = (b.size.z * 0.14).min(b.size.x * 0.06);
    for (x, y) in [(0.35, -0.2), (0.35, 0.2), (-0.8, 0.0)] {
        let small = if y == 0.0 { 0.6 } else { 1.0 };
        let z = r * small / b.size.z;
        b.wheel("wheel", Axis::Y, [x, y, z], (r * small, b.size.y * 0.05), RUBBER);
        b.pole("leg", [x, y, z], [x, y * 0.5, 0.5], r * 0.2, GREY_PLASTIC);
    }
}

/// A toy boat with a flat keel: a steamer, a sailing boat or a tug.
pub(super) fn boat(b: &mut Build<'_>) {
    let (paint, deck) = (b.one_of(BRIGHT), b.choose(&[WHITE_PLASTIC, BEECH, YELLOW_PLASTIC]));
    let sail = b.rng.chance(0.5);
    let rim = if sail { 0.24 } else { 0.42 };
    let side = |x: f32, y: f32, z: f32| [[x, y, z], [x, -y, z]];
    let points = [
        side(-0.85, 0.6, 0.0),
        side(0.55, 0.5, 0.0),
        side(-0.98, 0.95, rim),
        side(0.3, 0.98, rim),
        side(0.75, 0.55, rim),
    ];
    let mut points: Vec<_> = points.concat();
    points.push([1.0, 0.0, rim]);
    b.chunk("hull", &points, paint);
    let plan = [(-0.92, 0.84), (0.28, 0.86), (0.7, 0.46), (0.92, 0.0), (0.7, -0.46), (0.28, -0.86), (-0.92, -0.84)];
    b.plan_outline("deck", (rim - 0.02, rim + 0.012), &plan, deck);
    if sail {
        let r = b.size.z * 0.012;
        b.pole("mast", [0.1, 0.0, rim], [0.1, 0.0, 1.0], r, BEECH);
        b.pole("boom", [0.1, 0.0, rim + 0.08], [-0.85, 0.0, rim + 0.08], r, BEECH);
        let cloth = b.choose(&[WHITE_COTTON, RED_FABRIC, BLUE_FABRIC, LINEN]);
        b.side_outline("sail", (-0.02, 0.02), &[(0.1, rim + 0.1), (-0.85, rim + 0.1), (0.1, 0.97)], cloth);
        b.side_outline("jib", (-0.02, 0.02), &[(0.1, rim + 0.1), (0.88, rim + 0.01), (0.1, 0.85)], WHITE_COTTON);
        return;
    }
    b.slab("cabin", [-0.55, -0.55, rim], [0.3, 0.55, 0.68], deck);
    b.slab("bridge", [-0.15, -0.42, 0.67], [0.22, 0.42, 0.84], paint);
    b.slab("bridge_window", [0.05, -0.36, 0.72], [0.235, 0.36, 0.8], BLACK_GLASS);
    for x in [-0.4, -0.1, 0.15] {
        b.wheel("porthole", Axis::Y, [x, 0.0, 0.56], (b.size.z * 0.05, b.size.y * 0.57), BLUE_GLASS);
    }
    b.pole("funnel", [-0.35, 0.0, 0.66], [-0.35, 0.0, 0.96], b.size.y * 0.12, RED_PLASTIC);
    b.pole("funnel", [-0.35, 0.0, 0.95], [-0.35, 0.0, 1.0], b.size.y * 0.125, BLACK_PLASTIC);
}
