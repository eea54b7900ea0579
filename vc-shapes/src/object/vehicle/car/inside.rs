//! A car's cockpit, and its boot or bed.

use std::f32::consts::FRAC_PI_2;

use super::{Car, Tail, flank, pane};
use crate::material::*;
use crate::solid::{Axis, Build, P, plate};

/// An open cockpit: floor, seats, dashboard, wheel and windscreen.
pub(super) fn cockpit(b: &mut Build<'_>, car: &Car) {
    let inner = car.half - car.side;
    let (x0, x1) = (car.x(car.shape.cargo), car.x(car.cowl()));
    let floor = car.low + 0.06;
    let [cowl, roof0, ..] = car.shape.stations;
    b.block("floor", [x0, -inner, car.low + 0.02], [x1, inner, floor], CHARCOAL_FABRIC);
    let seat = b.choose(&[TAN_LEATHER, BLACK_LEATHER, WHITE_LEATHER, BROWN_LEATHER]);
    let belt = car.belt(0.5);
    let (deep, tall) = ((x1 - x0) * 0.22, (belt - floor) * 0.42);
    for (row, share) in [(0, 0.52), (1, 0.08)] {
        let sx = x0 + (x1 - x0) * share;
        for cy in [-inner * 0.5, inner * 0.5] {
            let w = inner * 0.42;
            b.rounded_block("seat", [sx, cy - w, floor - 0.005], [sx + deep, cy + w, floor + tall], 0.05, seat);
            let back = if row == 0 { belt + 0.1_f32.min(car.roof * 0.1) } else { belt };
            b.rounded_block("seat", [sx - deep * 0.3, cy - w, floor], [sx + deep * 0.15, cy + w, back], 0.05, seat);
        }
    }
    let dash = x1 - (x1 - x0) * 0.1;
    b.block("dashboard", [dash, -inner, floor + tall], [x1 + 0.005, inner, belt - 0.01], ANTHRACITE);
    let hub = [dash - 0.1, inner * 0.5, belt - 0.06];
    b.rod("column", [dash + 0.01, hub[1], hub[2] - 0.03], hub, 0.02, IRON);
    let ring =
        [(inner * 0.27, 0.0), (inner * 0.27, 0.02), (inner * 0.23, 0.02), (inner * 0.23, 0.0), (inner * 0.27, 0.0)];
    b.lathe_along("steering_wheel", hub, [hub[0] - 1.0, hub[1], hub[2] + 0.4], &ring, BLACK_LEATHER);
    b.rod(
        "steering_wheel",
        [hub[0], hub[1] - inner * 0.25, hub[2]],
        [hub[0], hub[1] + inner * 0.25, hub[2]],
        0.01,
        BLACK_LEATHER,
    );
    let face = [
        car.corner(cowl, false, -1.0),
        car.corner(cowl, false, 1.0),
        car.corner(roof0, true, 1.0),
        car.corner(roof0, true, -1.0),
    ];
    plate(b, "windscreen", face, 0.008, GLASS);
    for (a, c) in [(0, 3), (1, 2), (3, 2)] {
        let r = 0.018;
        let down = |p: P| [p[0] - r, p[1], p[2] - r * 1.1];
        b.bar("frame", down(face[a]), down(face[c]), r, car.paint);
    }
}

/// The rear boot, load space or bed, and its lid or doors.
pub(super) fn tail(b: &mut Build<'_>, car: &Car) {
    let inner = car.half - car.side;
    let (x0, x1) = (car.x(car.ends().1) + 0.01, car.x(car.shape.cargo));
    let belt = car.belt(car.shape.cargo).min(car.belt(0.95));
    let floor = if car.shape.tail == Tail::Bed { car.bed() } else { car.low + (belt - car.low) * 0.3 };
    let t = 0.02;
    b.block("floor", [x0 - 0.005, -inner, car.low + 0.02], [x1, inner, floor], CHARCOAL_FABRIC);
    let top = match car.shape.tail {
        Tail::Boot => boot_lid(b, car, (x0, x1)),
        Tail::Bed => bed_flap(b, car, (x0, x1, floor)),
        Tail::Hatch | Tail::Doors => hollow(b, car, floor),
    };
    if car.shape.tail == Tail::Boot {
        b.block("wall", [x0 - 0.005, -inner, floor - 0.05], [x0 + t, inner, belt - 0.03], car.paint);
    }
    let half = ((x1 - x0 - t) / 2.0 - 0.03, inner - 0.03);
    b.inside("compartment", [(x0 + t + x1) / 2.0, 0.0, floor], (half.0.max(0.02), half.1), (top - floor).max(0.05));
}

/// Builds a lid over the boot, hinged at the cabin; returns the height of the boot.
fn boot_lid(b: &mut Build<'_>, car: &Car, (x0, x1): (f32, f32)) -> f32 {
    let inner = car.half - car.side;
    let (z0, z1) = (car.belt(0.955), car.belt(car.shape.cargo));
    b.hinge([x1, 0.0, z1], [0.0, 1.0, 0.0], 1.2, |b| {
        let outline = [(x1 - 0.004, z1 - 0.03), (x1 - 0.004, z1), (x0 - 0.005, z0), (x0 - 0.005, z0 - 0.03)];
        b.prism("boot", Axis::Y, [0.0, -inner + 0.003, 0.0], &outline, 2.0 * inner - 0.006, car.paint);
    });
    z0.min(z1) - 0.035
}

/// An open bed between the sides with a tailgate.
fn bed_flap(b: &mut Build<'_>, car: &Car, (x0, x1, floor): (f32, f32, f32)) -> f32 {
    let inner = car.half - car.side;
    let belt = car.belt(0.95);
    b.block(
        "wall",
        [x1 - 0.03, -inner, floor - 0.01],
        [x1 + 0.001, inner, car.belt(car.shape.cargo) - 0.005],
        car.paint,
    );
    b.hinge([x0, 0.0, floor], [0.0, -1.0, 0.0], FRAC_PI_2, |b| {
        b.block("flap", [x0 - 0.02, -inner + 0.004, floor + 0.002], [x0 + 0.015, inner - 0.004, belt], car.paint);
        b.block("handle", [x0 - 0.03, -0.07, belt - 0.12], [x0 - 0.018, 0.07, belt - 0.07], BLACK_PLASTIC);
    });
    belt + 0.5 - floor
}

/// Roof and sides of the load space, and the hatch or doors that close it.
fn hollow(b: &mut Build<'_>, car: &Car, floor: f32) -> f32 {
    let [.., roof1, rear] = car.shape.stations;
    let (start, t) = (car.shape.cargo, 0.025);
    let (x0, x1) = (car.x(roof1), car.x(start));
    let tuck = car.half * (1.0 - 2.0 * car.shape.tuck);
    b.taper(
        "roof",
        [(x0 + x1) / 2.0 + 0.005, 0.0, car.roof - 0.04],
        ((x1 - x0) / 2.0 + 0.005, tuck + 0.014),
        ((x1 - x0) / 2.0 + 0.005, tuck + 0.004),
        0.04,
        car.paint,
    );
    for side in [1.0, -1.0] {
        let face = flank(car, (start, rear), (start, roof1), side);
        let belt = face.map(|p| [p[0], p[1], p[2].max(car.belt(start) - 0.03)]);
        plate(b, "pillar", belt, t, car.paint);
        if car.shape.tail == Tail::Hatch {
            pane(b, "window", face, (0.06, 0.82, 0.14, 0.86), BLACK_GLASS);
        }
    }
    let inner = car.half - car.side;
    let foot = if car.shape.tail == Tail::Hatch { car.low + (car.belt(0.95) - car.low) * 0.56 } else { floor - 0.03 };
    let (rear_x, top_x) = (car.x(rear.min(car.ends().1)) - 0.001, car.x(roof1));
    let belt = car.belt(rear);
    if car.shape.tail == Tail::Hatch {
        hatch(b, car, [foot, belt], [rear_x, top_x], inner);
    } else {
        for side in [1.0, -1.0] {
            let edge = side * inner.max(tuck);
            b.hinge([rear_x - t, edge, 0.0], [0.0, 0.0, -side], FRAC_PI_2 * 1.6, |b| {
                let seam = side * 0.003;
                b.block(
                    "door",
                    [rear_x - t, edge.min(seam), foot],
                    [rear_x, edge.max(seam), car.roof - 0.05],
                    car.paint,
                );
                b.block(
                    "handle",
                    [rear_x - t - 0.02, (side * 0.06).min(side * 0.1), belt * 0.9],
                    [rear_x - t, (side * 0.06).max(side * 0.1), belt * 1.1],
                    BLACK_PLASTIC,
                );
                let (y0, y1) = (edge * 0.85, side * 0.12);
                let (z0, z1) = (car.roof * 0.62, car.roof * 0.9);
                b.block(
                    "window",
                    [rear_x - t - 0.004, y0.min(y1), z0],
                    [rear_x - t + 0.002, y0.max(y1), z1],
                    BLACK_GLASS,
                );
            });
        }
        b.block("step", [-car.front, -inner * 0.9, car.low], [rear_x + 0.05, inner * 0.9, foot - 0.005], ANTHRACITE);
    }
    car.roof - 0.045 - floor
}

/// A hatch hinged at the roof's rear edge: a panel below, a window above.
fn hatch(b: &mut Build<'_>, car: &Car, [foot, belt]: [f32; 2], [rear, top]: [f32; 2], inner: f32) {
    let tuck = car.half * (1.0 - 2.0 * car.shape.tuck) - 0.032;
    let under = car.roof - 0.042;
    b.hinge([top, 0.0, under], [0.0, 1.0, 0.0], 1.3, |b| {
        b.block("hatch", [rear, -inner - car.side * 0.5, foot], [rear + 0.03, inner + car.side * 0.5, belt], car.paint);
        let wide = inner + car.side * 0.5;
        let face = [[rear, wide, belt - 0.01], [rear, -wide, belt - 0.01], [top, -tuck, under], [top, tuck, under]];
        plate(b, "hatch", face, 0.03, car.paint);
        pane(b, "rear_window", face, (0.08, 0.92, 0.12, 0.86), BLACK_GLASS);
        b.block(
            "plate",
            [rear - 0.006, -0.25_f32.max(-inner * 0.4), foot + 0.1],
            [rear + 0.002, 0.25_f32.min(inner * 0.4), foot + 0.2],
            WHITE_PLASTIC,
        );
    });
}
