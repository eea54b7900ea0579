//! Cars, from hatchbacks to vans: sides with wheel arches, a tapered cabin with dark windows, and a
//! boot that opens.

mod inside;
mod trim;

use std::f32::consts::PI;

use vc_graph::portable::Portable;

use super::wheel::{Rim, axled};
use crate::material::*;
use crate::solid::{Axis, Build, P, at_least, mix, plate};

/// The rear end of a body.
#[derive(Clone, Copy, PartialEq)]
enum Tail {
    /// A lid over a boot behind the cabin.
    Boot,
    /// A hatch from the roof down.
    Hatch,
    /// Two doors.
    Doors,
    /// An open bed with a tailgate.
    Bed,
}

/// A car's outline as fractions of its length (from the front) and height.
struct Shape {
    /// End of the bonnet, front and rear edges of the roof, base of the rear window.
    stations: [f32; 4],
    /// Heights of the nose, of the bonnet's end and of the tail, below the windows.
    belt: [f32; 3],
    /// Front end of the boot or bed.
    cargo: f32,
    /// Radius of the wheels and ground clearance, as fractions of the height.
    wheel: f32,
    clear: f32,
    /// Inset of the roof from each side, as a fraction of the width.
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

const PAINTS: &[MaterialId] = &[
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

/// Dimensions of one car in metres: front at `front`, rear at `-front`.
struct Car {
    shape: Shape,
    front: f32,
    /// Half the body's width without mirrors.
    half: f32,
    /// Height of the roof.
    roof: f32,
    low: f32,
    /// Thickness of the sides, which contain the wheels.
    side: f32,
    wheel: f32,
    axles: [f32; 2],
    paint: MaterialId,
}

/// A car of any body style.
pub(super) fn car(b: &mut Build<'_>) {
    at_least(b, [1.6, 0.8, 0.55]);
    let class = match b.class {
        "car" => b.choose(&["hatchback", "sedan", "station_wagon", "hatchback"]),
        "electric_car" => b.choose(&["electric_car", "sedan", "suv"]),
        "police_car" => b.choose(&["sedan", "station_wagon", "suv"]),
        "taxi" => b.choose(&["sedan", "station_wagon", "minivan"]),
        other => other,
    };
    let mut shape = shape(class);
    shape.stations = shape.stations.map(|s| s + b.vary(-0.012, 0.012));
    shape.stations[3] = shape.stations[3].min(0.99);
    if shape.tail == Tail::Boot {
        // The lid begins behind the window.
        shape.cargo = shape.cargo.max(shape.stations[3] + 0.004);
    }
    shape.belt = shape.belt.map(|s| s + b.vary(-0.015, 0.02));
    let paint = match b.class {
        "taxi" => b.choose(&[YELLOW_METAL, YELLOW_METAL, BLACK_METAL, CREAM]),
        "police_car" | "ambulance" => WHITE_METAL,
        _ => b.one_of(PAINTS),
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
        inside::cockpit(b, &car)
    } else {
        cabin(b, &car)
    }
    inside::tail(b, &car);
    trim::details(b, &car);
    let rim = Rim::any(b);
    for (name, axle, side) in [("wheel_fl", 0, 1.0), ("wheel_fr", 0, -1.0), ("wheel_rl", 1, 1.0), ("wheel_rr", 1, -1.0)]
    {
        let width = car.side * 0.8;
        let y = side * (car.half - 0.012 - width / 2.0);
        let at = [car.axles[axle], y, car.wheel];
        axled(b, name, at, (car.wheel, width), side, rim, car.half - car.side - 0.002);
    }
    trim::livery(b, &car);
}

impl Car {
    /// The position at a fraction of the length behind the front.
    fn x(&self, share: f32) -> f32 {
        self.front * (1.0 - 2.0 * share)
    }

    /// Height of the body below the windows at a fraction of the length.
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

    /// The fractions of the length at which nose and tail narrow; a van's tail is square.
    fn ends(&self) -> (f32, f32) {
        let square = 1.0 - 0.03 / self.front;
        (0.045, if self.shape.tail == Tail::Doors { square } else { 0.955 })
    }

    /// Height of the tail behind the opening.
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

/// The body below the windows: two sides with arches, the block between them, and nose and tail
/// that narrow in plan.
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

/// Nose (`way` 1) or tail (-1): as wide as the body where they join, narrower at the end.
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

/// The closed cabin with its windows; hollow at the rear if a hatch opens.
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

/// A cabin's side between fractions of the belt and of the roof; counter-clockwise as seen from
/// outside.
fn flank(car: &Car, belt: (f32, f32), roof: (f32, f32), side: f32) -> [P; 4] {
    let quad = [
        car.corner(belt.0, false, side),
        car.corner(belt.1, false, side),
        car.corner(roof.1, true, side),
        car.corner(roof.0, true, side),
    ];
    if side > 0.0 { quad } else { [quad[1], quad[0], quad[3], quad[2]] }
}

/// A slightly raised dark window on part of a face, given by fractions along and up.
pub(super) fn pane(
    b: &mut Build<'_>,
    name: &str,
    face: [P; 4],
    (u0, u1, v0, v1): (f32, f32, f32, f32),
    mat: MaterialId,
) {
    let at = |u: f32, v: f32| mix(mix(face[0], face[1], u), mix(face[3], face[2], u), v);
    // Twice the height above the face, so that half of it lies below.
    let quad = [at(u0, v0), at(u1, v0), at(u1, v1), at(u0, v1)];
    plate(b, name, quad, -0.006, mat);
    plate(b, name, quad, 0.01, mat);
}
