//! Cars, from hatchbacks to vans: sides with wheel arches, a tapering cabin with dark
//! panes, a boot that opens.

use std::f32::consts::{FRAC_PI_2, PI};

use vc_graph::portable::Portable;

use super::wheel::{Rim, axled};
use crate::material::*;
use crate::object::build::{Axis, Build, P};
use crate::object::park::shape::{grown, mix, plate};

/// How the body ends behind.
#[derive(Clone, Copy, PartialEq)]
enum Tail {
    /// A lid over a boot behind the cabin.
    Boot,
    /// A hatch from the roof down.
    Hatch,
    /// Two doors.
    Doors,
    /// An open bed with a flap.
    Bed,
}

/// Shares of length (from the front) and height that draw a car's outline.
struct Shape {
    /// End of the bonnet, front edge and rear edge of the roof, foot of the rear pane.
    stations: [f32; 4],
    /// Heights of the nose, the bonnet's end and the tail under the panes.
    belt: [f32; 3],
    /// Where the boot or bed begins.
    cargo: f32,
    /// Radius of the wheels and clearance below, of the height.
    wheel: f32,
    clear: f32,
    /// How far the roof is drawn in from each side, of the width.
    tuck: f32,
    tail: Tail,
    panes: usize,
    open: bool,
}

const SEDAN: Shape = Shape {
    stations: [0.28, 0.43, 0.68, 0.82],
    belt: [0.5, 0.62, 0.66],
    cargo: 0.82,
    wheel: 0.225,
    clear: 0.13,
    tuck: 0.13,
    tail: Tail::Boot,
    panes: 2,
    open: false,
};

fn shape(class: &str) -> Shape {
    match class {
        "hatchback" | "electric_car" | "car" => Shape {
            stations: [0.27, 0.42, 0.88, 0.985],
            belt: [0.48, 0.61, 0.66],
            cargo: 0.76,
            tail: Tail::Hatch,
            wheel: 0.215,
            ..SEDAN
        },
        "station_wagon" => Shape {
            stations: [0.28, 0.42, 0.92, 0.985],
            belt: [0.48, 0.61, 0.65],
            cargo: 0.7,
            tail: Tail::Hatch,
            panes: 3,
            ..SEDAN
        },
        "suv" => Shape {
            stations: [0.27, 0.4, 0.92, 0.985],
            belt: [0.54, 0.62, 0.66],
            cargo: 0.75,
            wheel: 0.215,
            clear: 0.15,
            tail: Tail::Hatch,
            panes: 3,
            tuck: 0.1,
            ..SEDAN
        },
        "minivan" => Shape {
            stations: [0.2, 0.37, 0.92, 0.985],
            belt: [0.46, 0.58, 0.62],
            cargo: 0.74,
            wheel: 0.185,
            tail: Tail::Hatch,
            panes: 3,
            tuck: 0.1,
            ..SEDAN
        },
        "sports_car" => Shape {
            stations: [0.33, 0.49, 0.63, 0.86],
            belt: [0.5, 0.66, 0.74],
            cargo: 0.87,
            wheel: 0.265,
            panes: 1,
            tuck: 0.16,
            ..SEDAN
        },
        "convertible" => Shape {
            stations: [0.31, 0.42, 0.66, 0.74],
            belt: [0.52, 0.67, 0.7],
            cargo: 0.77,
            wheel: 0.245,
            panes: 1,
            tuck: 0.12,
            open: true,
            ..SEDAN
        },
        "pickup" => Shape {
            stations: [0.25, 0.36, 0.56, 0.6],
            belt: [0.52, 0.57, 0.58],
            cargo: 0.62,
            wheel: 0.2,
            clear: 0.17,
            tail: Tail::Bed,
            tuck: 0.1,
            ..SEDAN
        },
        "van" | "ambulance" => Shape {
            stations: [0.14, 0.3, 0.985, 0.995],
            belt: [0.33, 0.45, 0.5],
            cargo: 0.42,
            wheel: 0.15,
            clear: 0.09,
            tail: Tail::Doors,
            panes: 1,
            tuck: 0.05,
            ..SEDAN
        },
        _ => SEDAN,
    }
}

const PAINTS: &[Mat] = &[
    WHITE_METAL,
    BLACK_METAL,
    SILVER_METAL,
    RED_METAL,
    BLUE_METAL,
    GREEN_METAL,
    ANTHRACITE,
    NAVY,
    GREY,
    CREAM,
    YELLOW_METAL,
    ORANGE,
];

/// Measures of one car, metres: front at `front`, rear at `-front`.
struct Car {
    shape: Shape,
    front: f32,
    /// Half the body's width, mirrors left out.
    half: f32,
    /// Height of the roof.
    roof: f32,
    low: f32,
    /// Thickness of the sides, in which the wheels run.
    side: f32,
    wheel: f32,
    axles: [f32; 2],
    paint: Mat,
}

/// A car of any build.
pub(super) fn car(b: &mut Build<'_>) {
    grown(b, [1.6, 0.8, 0.55]);
    let class = match b.class {
        "car" => b.one(&["hatchback", "sedan", "station_wagon", "hatchback"]),
        "electric_car" => b.one(&["electric_car", "sedan", "suv"]),
        "police_car" => b.one(&["sedan", "station_wagon", "suv"]),
        "taxi" => b.one(&["sedan", "station_wagon", "minivan"]),
        other => other,
    };
    let mut shape = shape(class);
    shape.stations = shape.stations.map(|s| s + b.vary(-0.012, 0.012));
    shape.stations[3] = shape.stations[3].min(0.99);
    if shape.tail == Tail::Boot {
        // The lid begins behind the pane.
        shape.cargo = shape.cargo.max(shape.stations[3] + 0.004);
    }
    shape.belt = shape.belt.map(|s| s + b.vary(-0.015, 0.02));
    let paint = match b.class {
        "taxi" => b.one(&[YELLOW_METAL, YELLOW_METAL, BLACK_METAL, CREAM]),
        "police_car" | "ambulance" => WHITE_METAL,
        _ => b.one(PAINTS),
    };
    let h = b.size.z;
    let extra: f32 = match b.class {
        "taxi" | "police_car" => 0.12,
        "ambulance" => 0.1,
        _ => 0.0,
    };
    let roof = h - extra.min(h * 0.1);
    let (front, half) = (b.size.x / 2.0, b.size.y / 2.0 * 0.92);
    let wheel = (roof * shape.wheel * b.vary(0.96, 1.04)).min(front * 0.2);
    let axles = [front * b.vary(0.6, 0.65), -front * b.vary(0.56, 0.62)];
    let low = roof * shape.clear;
    let mut car = Car { shape, front, half, roof, low, side: half * 0.27, wheel, axles, paint };
    if car.shape.tail == Tail::Doors {
        let tail = car.ends().1;
        (car.shape.stations[2], car.shape.stations[3]) = (tail, tail);
    }
    body(b, &car);
    if car.shape.open {
        cockpit(b, &car)
    } else {
        cabin(b, &car)
    }
    tail(b, &car);
    details(b, &car);
    let rim = Rim::any(b);
    for (name, axle, side) in [("wheel_fl", 0, 1.0), ("wheel_fr", 0, -1.0), ("wheel_rl", 1, 1.0), ("wheel_rr", 1, -1.0)]
    {
        let width = car.side * 0.8;
        let y = side * (car.half - 0.012 - width / 2.0);
        let at = [car.axles[axle], y, car.wheel];
        axled(b, name, at, (car.wheel, width), side, rim, car.half - car.side - 0.002);
    }
    livery(b, &car);
}

impl Car {
    /// The place a share of the length behind the front.
    fn x(&self, share: f32) -> f32 {
        self.front * (1.0 - 2.0 * share)
    }

    /// Height of the body under the panes at a share of the length.
    fn belt(&self, share: f32) -> f32 {
        let [nose, cowl, rear] = self.shape.belt.map(|s| s * self.roof);
        let cowl_at = self.shape.stations[0];
        if share < cowl_at {
            let t = share / cowl_at;
            nose + (cowl - nose) * t * (2.0 - t)
        } else {
            cowl + (rear - cowl) * (share - cowl_at) / (1.0 - cowl_at)
        }
    }

    /// The cabin's corner at the belt or the roof: `side` is 1 on the left.
    fn corner(&self, share: f32, top: bool, side: f32) -> P {
        let tuck = if top { 1.0 - 2.0 * self.shape.tuck } else { 0.97 };
        [self.x(share), side * self.half * tuck, if top { self.roof } else { self.belt(share) - 0.01 }]
    }

    /// The share of the length at which nose and tail narrow; a van's tail is square.
    fn ends(&self) -> (f32, f32) {
        let square = 1.0 - 0.03 / self.front;
        (0.045, if self.shape.tail == Tail::Doors { square } else { 0.955 })
    }

    /// Height of the tail behind what opens.
    fn tail_top(&self) -> f32 {
        let belt = self.belt(0.955);
        match self.shape.tail {
            Tail::Boot => belt,
            Tail::Bed => self.bed() - 0.035,
            Tail::Hatch | Tail::Doors => self.low + (belt - self.low) * 0.55,
        }
    }

    /// Height of the bed's floor.
    fn bed(&self) -> f32 {
        self.low + (self.belt(self.shape.cargo).min(self.belt(0.95)) - self.low) * 0.45
    }

    fn cowl(&self) -> f32 {
        self.shape.stations[0]
    }
}

/// The body below the panes: two sides with arches, the block between them, nose and
/// tail that narrow in plan.
fn body(b: &mut Build<'_>, car: &Car) {
    let (nose, tail) = car.ends();
    let shares = |from: f32, to: f32| (0..=8).map(move |i| from + (to - from) * i as f32 / 8.0);
    let (x0, x1) = (car.x(nose), car.x(tail));
    // Arches are drawn from front to rear along the bottom.
    let arch = |centre: f32| {
        let r = car.wheel * 1.13;
        let start = ((car.low - car.wheel) / r).arc_sine();
        (0..=10)
            .map(move |i| start + (PI - 2.0 * start) * i as f32 / 10.0)
            .map(move |a| (centre + r * a.cosine(), car.wheel + r * a.sine()))
    };
    let mut outline: Vec<(f32, f32)> = shares(nose, tail).map(|s| (car.x(s), car.belt(s))).rev().collect();
    outline.push((x0, car.low));
    outline.extend(car.axles.iter().flat_map(|&c| arch(c)));
    outline.push((x1, car.low));
    for y in [-car.half, car.half - car.side] {
        b.prism("side", Axis::Y, [0.0, y, 0.0], &outline, car.side, car.paint);
    }
    let cargo = car.shape.cargo;
    let mut middle: Vec<(f32, f32)> =
        shares(nose, if car.shape.open { car.cowl() } else { cargo }).map(|s| (car.x(s), car.belt(s))).collect();
    middle.push((middle.last().map_or(0.0, |p| p.0), car.low + 0.02));
    middle.push((x0, car.low + 0.02));
    let inner = car.half - car.side;
    b.prism("middle", Axis::Y, [0.0, -inner, 0.0], &middle, 2.0 * inner, car.paint);
    rounded_end(b, car, 1.0);
    if car.shape.tail != Tail::Doors {
        rounded_end(b, car, -1.0);
    }
}

/// Nose (`way` 1) or tail (-1): as wide as the body where it meets it, narrower at
/// the end.
fn rounded_end(b: &mut Build<'_>, car: &Car, way: f32) {
    let (nose, tail) = car.ends();
    let (root, top) = if way > 0.0 { (car.x(nose), car.belt(nose)) } else { (car.x(tail), car.tail_top()) };
    let end = way * car.front;
    let mut points = Vec::new();
    for side in [-1.0, 1.0] {
        let y = side * car.half;
        points.extend([[root - way * 0.02, y, car.low + 0.01], [root - way * 0.02, y, top - 0.002]]);
        points.extend([
            [end, y * 0.84, car.low + (top - car.low) * 0.25],
            [end, y * 0.84, car.low + (top - car.low) * 0.72],
        ]);
        points.extend([
            [(root + end) / 2.0, y * 0.96, car.low],
            [root + (end - root) * 0.6, y * 0.9, top - (top - car.low) * 0.05],
        ]);
    }
    b.hull("end", &points, car.paint);
    let z = car.low + (top - car.low) * 0.12;
    b.block(
        "bumper",
        [end - way * 0.12 - 0.02, -car.half * 0.8, z],
        [end - way * 0.012 + 0.01 * (1.0 - way) / 2.0, car.half * 0.8, z + (top - car.low) * 0.16],
        ANTHRACITE,
    );
}

/// The closed cabin with its panes; hollow behind where a hatch opens.
fn cabin(b: &mut Build<'_>, car: &Car) {
    let [cowl, roof0, roof1, rear] = car.shape.stations;
    let end = if car.shape.tail == Tail::Boot || car.shape.tail == Tail::Bed { rear } else { car.shape.cargo };
    let roof_end = roof1.min(end);
    let four = |share: f32, top: bool| [car.corner(share, top, 1.0), car.corner(share, top, -1.0)];
    let points: Vec<P> = [four(cowl, false), four(roof0, true), four(roof_end, true), four(end, false)].concat();
    b.hull("cabin", &points, car.paint);
    let glass = BLACK_GLASS;
    // Windscreen.
    let face = [
        car.corner(cowl, false, -1.0),
        car.corner(cowl, false, 1.0),
        car.corner(roof0, true, 1.0),
        car.corner(roof0, true, -1.0),
    ];
    pane(b, "windscreen", face, (0.06, 0.94, 0.06, 0.9), glass);
    if end == rear {
        let face = [
            car.corner(end, false, 1.0),
            car.corner(end, false, -1.0),
            car.corner(roof_end, true, -1.0),
            car.corner(roof_end, true, 1.0),
        ];
        pane(b, "rear_window", face, (0.08, 0.92, 0.12, 0.88), glass);
    }
    for side in [1.0, -1.0] {
        let face = flank(car, (cowl, end), (roof0, roof_end), side);
        let panes = if end == rear { car.shape.panes } else { car.shape.panes.min(2) };
        for i in 0..panes {
            let (u0, u1) = (i as f32 / panes as f32, (i + 1) as f32 / panes as f32);
            pane(b, "window", face, (u0 + 0.025, u1 - 0.02, 0.12, 0.88), glass);
        }
    }
}

/// A cabin's flank between shares of the belt and the roof, seen from outside
/// counter-clockwise.
fn flank(car: &Car, belt: (f32, f32), roof: (f32, f32), side: f32) -> [P; 4] {
    let quad = [
        car.corner(belt.0, false, side),
        car.corner(belt.1, false, side),
        car.corner(roof.1, true, side),
        car.corner(roof.0, true, side),
    ];
    if side > 0.0 { quad } else { [quad[1], quad[0], quad[3], quad[2]] }
}

/// Dark glass on part of a face, a little raised: shares along and up.
pub(super) fn pane(b: &mut Build<'_>, name: &str, face: [P; 4], (u0, u1, v0, v1): (f32, f32, f32, f32), mat: Mat) {
    let at = |u: f32, v: f32| mix(mix(face[0], face[1], u), mix(face[3], face[2], u), v);
    // Twice the height above the face, so that half of it lies below.
    let quad = [at(u0, v0), at(u1, v0), at(u1, v1), at(u0, v1)];
    plate(b, name, quad, -0.006, mat);
    plate(b, name, quad, 0.01, mat);
}

/// An open cockpit: floor, seats, dashboard, wheel and windscreen.
fn cockpit(b: &mut Build<'_>, car: &Car) {
    let inner = car.half - car.side;
    let (x0, x1) = (car.x(car.shape.cargo), car.x(car.cowl()));
    let floor = car.low + 0.06;
    let [cowl, roof0, ..] = car.shape.stations;
    b.block("floor", [x0, -inner, car.low + 0.02], [x1, inner, floor], CHARCOAL_FABRIC);
    let seat = b.one(&[TAN_LEATHER, BLACK_LEATHER, WHITE_LEATHER, BROWN_LEATHER]);
    let belt = car.belt(0.5);
    let (deep, tall) = ((x1 - x0) * 0.22, (belt - floor) * 0.42);
    for (row, share) in [(0, 0.52), (1, 0.08)] {
        let sx = x0 + (x1 - x0) * share;
        for cy in [-inner * 0.5, inner * 0.5] {
            let w = inner * 0.42;
            b.soft("seat", [sx, cy - w, floor - 0.005], [sx + deep, cy + w, floor + tall], 0.05, seat);
            let back = if row == 0 { belt + 0.1_f32.min(car.roof * 0.1) } else { belt };
            b.soft("seat", [sx - deep * 0.3, cy - w, floor], [sx + deep * 0.15, cy + w, back], 0.05, seat);
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

/// The boot, load space or bed behind, and what closes it.
fn tail(b: &mut Build<'_>, car: &Car) {
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

/// A lid over the boot, hinged at the cabin; returns how high the boot is.
fn boot_lid(b: &mut Build<'_>, car: &Car, (x0, x1): (f32, f32)) -> f32 {
    let inner = car.half - car.side;
    let (z0, z1) = (car.belt(0.955), car.belt(car.shape.cargo));
    b.hinge([x1, 0.0, z1], [0.0, 1.0, 0.0], 1.2, |b| {
        let outline = [(x1 - 0.004, z1 - 0.03), (x1 - 0.004, z1), (x0 - 0.005, z0), (x0 - 0.005, z0 - 0.03)];
        b.prism("boot", Axis::Y, [0.0, -inner + 0.003, 0.0], &outline, 2.0 * inner - 0.006, car.paint);
    });
    z0.min(z1) - 0.035
}

/// An open bed between the sides with a flap behind.
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

/// A hatch hinged at the roof's rear edge: a leaf below, a pane above.
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

/// Lights, grille, mirrors, doors' outlines and handles.
fn details(b: &mut Build<'_>, car: &Car) {
    let nose = car.belt(0.045);
    let (z, tall) = (car.low + (nose - car.low) * 0.62, (nose - car.low) * b.vary(0.12, 0.22));
    let wide = car.half * b.vary(0.18, 0.28);
    let tail_top = car.tail_top();
    for side in [-1.0, 1.0] {
        let y = |share: f32| side * car.half * share;
        let (outer, inner) = (y(0.86), y(0.86) - side * wide);
        let (back, front) = (car.front - 0.08, car.front - 0.004);
        let lamp = [
            [back, outer, z],
            [back, outer, z + tall],
            [front, inner, z],
            [front, inner, z + tall],
            [front, outer * 0.96, z],
            [front, outer * 0.96, z + tall],
            [back, inner, z + tall * 0.5],
        ];
        b.hull("headlight", &lamp.map(|p| [p[0] + 0.004, p[1], p[2]]), COOL_BULB);
        b.block(
            "fog_light",
            [car.front - 0.05, y(0.7) - 0.05, car.low + (nose - car.low) * 0.3],
            [car.front - 0.006, y(0.7) + 0.05, car.low + (nose - car.low) * 0.38],
            SIGNAL_AMBER,
        );
        if car.shape.tail != Tail::Doors {
            let rear = -car.front;
            let (z0, z1) = (car.low + (tail_top - car.low) * 0.6, car.low + (tail_top - car.low) * 0.85);
            let lamp = [outer, inner].into_iter().flat_map(|y| {
                [[rear + 0.001, y, z0], [rear + 0.001, y, z1 - 0.02], [rear + 0.06, y, z1], [rear + 0.06, y, z0]]
            });
            b.hull("tail_light", &lamp.collect::<Vec<P>>(), SIGNAL_RED);
        } else {
            b.block(
                "tail_light",
                [car.x(car.ends().1) - 0.02, y(0.915).min(y(0.985)), car.low + 0.2],
                [car.x(car.ends().1) + 0.02, y(0.915).max(y(0.985)), car.low + 0.45],
                SIGNAL_RED,
            );
        }
        mirror(b, car, side);
        doors(b, car, side);
    }
    let grille = car.half * b.vary(0.3, 0.5);
    if b.class != "electric_car" {
        b.block(
            "grille",
            [car.front - 0.06, -grille, z - tall * 0.8],
            [car.front - 0.001, grille, z + tall * 0.7],
            BLACK_PLASTIC,
        );
    }
    b.block(
        "plate",
        [car.front - 0.05, -0.26_f32.max(-car.half * 0.3), car.low + (nose - car.low) * 0.36],
        [car.front, 0.26_f32.min(car.half * 0.3), car.low + (nose - car.low) * 0.46],
        WHITE_PLASTIC,
    );
}

fn mirror(b: &mut Build<'_>, car: &Car, side: f32) {
    let share = car.cowl() + 0.06;
    let z = car.belt(share);
    let (x, y) = (car.x(share), side * b.size.y / 2.0);
    let (near, far) = (y.min(side * car.half * 0.985), y.max(side * car.half * 0.985));
    let (a, c) = if side > 0.0 { (near - 0.005, y) } else { (y, far + 0.005) };
    b.soft("mirror", [x - 0.05, a.min(c), z - 0.02], [x + 0.05, a.max(c), z + 0.1], 0.025, car.paint);
    b.block(
        "mirror",
        [x - 0.02, side * car.half * 0.9 - 0.05, z - 0.03],
        [x + 0.02, side * car.half * 0.9 + 0.05, z + 0.02],
        BLACK_PLASTIC,
    );
}

/// Seams and handles of the doors on a side.
fn doors(b: &mut Build<'_>, car: &Car, side: f32) {
    let y = side * car.half;
    let sill = car.low + 0.06;
    let seams: &[f32] = match car.shape.tail {
        Tail::Doors => &[0.2, 0.41, 0.62],
        _ if car.shape.panes > 1 => &[0.32, 0.53, 0.7],
        _ => &[0.36, 0.64],
    };
    let block = |b: &mut Build<'_>, name: &str, low: [f32; 2], high: [f32; 2], out: f32, mat: Mat| {
        b.block(
            name,
            [low[0], y.min(y + side * out) - 0.004, low[1]],
            [high[0], y.max(y + side * out) + 0.004, high[1]],
            mat,
        );
    };
    let clear = |x: f32| car.axles.iter().map(|a| (x - a).abs() - car.wheel * 1.13).fold(f32::INFINITY, f32::min);
    for pair in seams.windows(2) {
        for &share in pair {
            let x = car.x(share);
            let low = if clear(x) < 0.01 { car.wheel * 2.2 } else { sill };
            block(b, "seam", [x - 0.004, low], [x + 0.004, car.belt(share) - 0.02], -0.002, BLACK_PLASTIC);
        }
        let x = car.x(pair[1]) + 0.06;
        let z = car.belt(pair[1]) - (car.belt(pair[1]) - car.low) * 0.18;
        block(b, "handle", [x, z], [x + 0.16_f32.min(car.front * 0.08), z + 0.025], 0.012, car.paint);
    }
    let (f, r) = (car.axles[0] - car.wheel * 1.2, car.axles[1] + car.wheel * 1.2);
    block(b, "sill", [r, car.low + 0.003], [f, sill - 0.01], 0.0, ANTHRACITE);
}

/// What tells a taxi, a police car and an ambulance.
fn livery(b: &mut Build<'_>, car: &Car) {
    let roof = car.x((car.shape.stations[1] + car.shape.stations[2].min(0.7)) / 2.0);
    let top = b.size.z;
    let stripe = |b: &mut Build<'_>, z0: f32, z1: f32, mat: Mat| {
        for side in [-1.0, 1.0] {
            let y = side * car.half;
            let (from, to) = (car.axles[1] + car.wheel * 1.25, car.axles[0] - car.wheel * 1.25);
            b.block("stripe", [from, y - 0.003, z0], [to, y + 0.003, z1], mat);
        }
    };
    let waist = car.low + (car.belt(0.5) - car.low) * 0.5;
    match b.class {
        "taxi" => {
            b.taper(
                "sign",
                [roof, 0.0, car.roof - 0.005],
                (0.08, car.half * 0.3),
                (0.05, car.half * 0.28),
                top - car.roof + 0.005,
                WARM_BULB,
            );
            let stripes = b.one(&[BLACK, WHITE, car.paint]);
            stripe(b, waist, waist + 0.06, stripes);
        }
        "police_car" => {
            beacons(b, car, roof, top);
            let colour = b.one(&[BLUE, NAVY, GREEN, BLACK]);
            stripe(b, waist - 0.06, waist + 0.1, colour);
            stripe_text(b, car, waist);
        }
        "ambulance" => {
            beacons(b, car, car.x(0.34), top);
            stripe(b, waist - 0.1, waist + 0.12, RED);
            for side in [-1.0, 1.0] {
                let (x, y, z) = (car.x(0.7), side * car.half * (1.0 - 2.0 * car.shape.tuck), car.roof * 0.75);
                let out = car.half * 0.97;
                let face = (y.abs() + out) / 2.0 * side;
                let r = car.roof * 0.1;
                for (dx, dz, t) in [(r, r * 0.33, 0.022), (r * 0.33, r, 0.024)] {
                    b.block("cross", [x - dx, face - t, z - dz], [x + dx, face + t, z + dz], RED);
                }
            }
        }
        _ => {}
    }
}

/// A bar of blue lights on the roof.
fn beacons(b: &mut Build<'_>, car: &Car, x: f32, top: f32) {
    let half = car.half * 0.6;
    b.block("bar", [x - 0.1, -half, car.roof - 0.005], [x + 0.1, half, car.roof + 0.02], BLACK_PLASTIC);
    for (from, to, mat) in [(-0.98, -0.3, BLUE_PLASTIC), (-0.3, 0.3, WHITE_PLASTIC), (0.3, 0.98, BLUE_PLASTIC)] {
        b.soft("beacon", [x - 0.09, half * from, car.roof + 0.015], [x + 0.09, half * to, top], 0.02, mat);
    }
}

/// White lettering on the doors.
fn stripe_text(b: &mut Build<'_>, car: &Car, z: f32) {
    for side in [-1.0, 1.0] {
        let y = side * car.half;
        for i in 0..6 {
            let x = car.x(0.38 + 0.03 * i as f32);
            b.block("letter", [x - 0.03, y - 0.005, z - 0.02], [x + 0.03, y + 0.005, z + 0.06], WHITE);
        }
    }
}
