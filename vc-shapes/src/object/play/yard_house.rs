//! Houses of the playground: towers, playhouses, tree houses, castles, kitchens.

use std::f32::consts::FRAC_PI_2;

use crate::material::*;
use crate::object::palette::*;
use crate::solid::{Axis, Build, CORNERS, P, Proportional, SIDES, arc_outline, band};

/// A gabled roof over a rectangle, with the ridge along Y.
fn gable_roof(b: &mut Build<'_>, x: (f32, f32), y: (f32, f32), z: (f32, f32), mat: MaterialId) {
    let middle = (x.0 + x.1) / 2.0;
    let t = (0.03 / b.size.z).min(0.05);
    b.side_outline(
        "roof",
        y,
        &[
            (x.0, z.0),
            (middle, z.1),
            (x.1, z.0),
            (x.1 - 0.04, z.0 - t * 0.2),
            (middle, z.1 - t),
            (x.0 + 0.04, z.0 - t * 0.2),
        ],
        mat,
    );
}

/// A tower with platform, roof, slide, ladder, and a swing if it is wide.
pub(super) fn tower(b: &mut Build<'_>) {
    let (wood, roof, chute) =
        (b.choose(&[PINE, TEAK, OAK]), b.choose(&[GREEN, RED, BLUE, TERRACOTTA]), b.one_of(BRIGHT));
    let wide = b.size.y > 2.6;
    let left = if wide { -1.0 + 2.4 / b.size.y } else { 0.95 };
    let (floor, eaves) = (0.46, 0.82);
    let half = ((0.045 / b.size.x).min(0.05), (0.045 / b.size.y).min(0.05));
    let (x0, x1, y0, y1) = (-0.95, -0.05, -0.95, left);
    for (x, y) in [(x0, y0), (x0, y1), (x1, y0), (x1, y1)] {
        b.slab("post", [x - half.0, y - half.1, 0.0], [x + half.0, y + half.1, eaves], wood);
    }
    b.slab("platform", [x0, y0, floor - 0.02], [x1, y1, floor], wood);
    let centre = [(x0 + x1) / 2.0, (y0 + y1) / 2.0, floor];
    let place = b.p(centre);
    let reach = b.p([(x1 - x0) / 2.0 - 0.08, (y1 - y0) / 2.0 - 0.08, 0.0]);
    b.ledge("platform", place, (reach[0], reach[1]), (eaves - floor) * b.size.z - 0.05);
    gable_roof(b, (-1.0, 0.0), (y0 - 0.05, (y1 + 0.05).min(1.0)), (eaves - 0.01, 0.999), roof);
    for (y, edge) in [(y0, 1.0), (y1, -1.0)] {
        let at = y + edge * half.1 * 0.5;
        for i in 0..6 {
            let x = x0 + (x1 - x0) * (i as f32 + 0.5) / 6.0;
            b.slab("picket", [x - 0.05, at - half.1 * 0.4, floor], [x + 0.05, at + half.1 * 0.4, floor + 0.16], wood);
        }
        b.slab("rail", [x0, at - half.1 * 0.55, floor + 0.13], [x1, at + half.1 * 0.55, floor + 0.15], wood);
    }
    for y in [y0 + (y1 - y0) * 0.15, y0 + (y1 - y0) * 0.45] {
        b.plank("stile", [0.3, y, 0.005], [x1, y, floor], (0.05, 0.04), wood);
    }
    for i in 1..5 {
        let t = i as f32 / 5.0;
        let x = 0.3 + (x1 - 0.3) * t;
        b.pole("rung", [x, y0 + (y1 - y0) * 0.15, floor * t], [x, y0 + (y1 - y0) * 0.45, floor * t], 0.02, wood);
    }
    let (s0, s1) = (y0 + (y1 - y0) * 0.55, y0 + (y1 - y0) * 0.95);
    let curve: Vec<_> = (0..9)
        .map(|i| i as f32 / 8.0)
        .map(|t| (x1 + (1.0 - x1) * t, floor + (0.04 - floor) * t * t * (3.0 - 2.0 * t)))
        .collect();
    b.side_outline("chute", (s0, s1), &band(&curve, (0.0, -0.015)), chute);
    for y in [s0, s1] {
        b.side_outline("chute_side", (y - 0.02, y + 0.02), &band(&curve, (0.0, 0.05)), chute);
    }
    if wide {
        swing_arm(b, (y1, centre[0]), eaves - 0.05, wood);
    }
}

/// A beam from a tower to a trestle, with a swing.
fn swing_arm(b: &mut Build<'_>, (y, x): (f32, f32), z: f32, wood: MaterialId) {
    b.slab("tie", [-0.95, y - 0.03, z - 0.02], [-0.05, y + 0.03, z + 0.02], wood);
    b.pole("beam", [x, y, z], [x, 0.96, z], 0.05, wood);
    for side in SIDES {
        b.plank("leg", [x + side * 0.4, 0.95, 0.01], [x, 0.94, z], (0.08, 0.08), wood);
    }
    let (middle, half) = ((y + 0.95) / 2.0, 0.42 / b.size.y);
    let seat = b.one_of(BRIGHT);
    b.slab("seat", [x - 0.12, middle - half, 0.17], [x + 0.12, middle + half, 0.185], seat);
    for side in SIDES {
        b.pole("rope", [x, middle + side * half * 0.92, 0.18], [x, middle + side * half * 0.92, z], 0.01, JUTE);
    }
}

/// Walls with a doorway and windows, and a door that opens.
struct House {
    x: (f32, f32),
    y: (f32, f32),
    floor: f32,
    eaves: f32,
}

fn walls(b: &mut Build<'_>, at: &House, wall: MaterialId, trim: MaterialId) {
    let &House { x, y, floor, eaves } = at;
    let t = (0.03 / b.size.x, 0.03 / b.size.y);
    let tall = eaves - floor;
    let (door, head) = ((y.1 - y.0) * 0.2, floor + tall * 0.86);
    let middle = (y.0 + y.1) / 2.0 - (y.1 - y.0) * 0.18;
    b.slab("floor", [x.0 + t.0, y.0 + t.1, floor], [x.1 - t.0, y.1 - t.1, floor + 0.02], b.style.wood);
    b.slab("back", [x.0, y.0, floor], [x.0 + t.0, y.1, eaves], wall);
    b.slab("front", [x.1 - t.0, y.0, floor], [x.1, middle - door, eaves], wall);
    b.slab("front", [x.1 - t.0, middle + door, floor], [x.1, y.1, eaves], wall);
    b.slab("threshold", [x.1 - t.0, middle - door, floor], [x.1 - 0.002, middle + door, floor + 0.031], trim);
    b.slab("lintel", [x.1 - t.0, middle - door, head], [x.1, middle + door, eaves], wall);
    let (w0, w1, sill) = (x.0 + (x.1 - x.0) * 0.3, x.0 + (x.1 - x.0) * 0.7, floor + tall * 0.42);
    for (a, c) in [(y.0, y.0 + t.1), (y.1 - t.1, y.1)] {
        let inner = (x.0 + t.0, x.1 - t.0);
        b.slab("side", [inner.0, a, floor], [w0, c, eaves], wall);
        b.slab("side", [w1, a, floor], [inner.1, c, eaves], wall);
        b.slab("side", [w0, a, floor], [w1, c, sill], wall);
        b.slab("side", [w0, a, head], [w1, c, eaves], wall);
        let sash = (a + c) / 2.0;
        b.slab(
            "mullion",
            [(w0 + w1) / 2.0 - 0.015, sash - t.1 * 0.3, sill],
            [(w0 + w1) / 2.0 + 0.015, sash + t.1 * 0.3, head],
            trim,
        );
        b.slab("sill", [w0 - 0.04, a - t.1 * 0.4, sill - 0.015], [w1 + 0.04, c + t.1 * 0.4, sill + 0.002], trim);
    }
    let pane = (middle + door + (y.1 - middle - door) * 0.25, y.1 - (y.1 - middle - door) * 0.2);
    b.slab("window", [x.1 - t.0 * 1.1, pane.0, sill], [x.1 + t.0 * 0.2, pane.1, head - tall * 0.08], BLUE_GLASS);
    b.slab("window_frame", [x.1 - t.0 * 0.5, pane.0 - 0.03, sill - 0.02], [x.1 + t.0 * 0.4, pane.1 + 0.03, sill], trim);
    let (anchor, gap) = (b.p([x.1, middle + door, floor]), 0.005 / b.size.y);
    b.hinge(anchor, [0.0, 0.0, 1.0], FRAC_PI_2 * 1.1, |b| {
        b.slab(
            "door",
            [x.1 - t.0 * 0.8, middle - door + gap, floor + 0.034],
            [x.1 + 0.002, middle + door - gap, head - 0.003],
            trim,
        );
        let knob = b.p([x.1 + 0.01, middle - door * 0.75, floor + tall * 0.45]);
        b.ball("knob", knob, 0.015, b.style.metal);
    });
    let centre = [(x.0 + x.1) / 2.0, (y.0 + y.1) / 2.0, floor + 0.02];
    b.inner_floor("room", centre, ((x.1 - x.0) / 2.0 - 2.5 * t.0, (y.1 - y.0) / 2.0 - 2.5 * t.1), tall - 0.04);
}

/// Two gables under a roof with the ridge along Y.
fn gables(b: &mut Build<'_>, at: &House, ridge: f32, wall: MaterialId, roof: MaterialId) {
    let over = |v: f32, by: f32| (v + by).clamp(-1.0, 1.0);
    let (x0, x1) = (over(at.x.0, -0.1), over(at.x.1, 0.1));
    let (low, middle) = (at.eaves + 0.002, (x0 + x1) / 2.0);
    let t = (0.03 / b.size.y, 0.009 / b.size.z);
    // The gables extend into the roof.
    let top = |x: f32| low + (ridge - low) * (1.0 - (x - middle).abs() / (x1 - middle)) - t.1;
    let (left, right) = (at.x.0 + 0.001, at.x.1 - 0.001);
    let outline = [(left, at.eaves), (right, at.eaves), (right, top(right)), (middle, top(middle)), (left, top(left))];
    for (a, c) in [(at.y.0 + 0.002, at.y.0 + t.0), (at.y.1 - t.0, at.y.1 - 0.002)] {
        b.side_outline("gable", (a, c), &outline, wall);
    }
    gable_roof(b, (x0, x1), (over(at.y.0, -0.08), over(at.y.1, 0.08)), (low, ridge), roof);
}

/// A playhouse of wood or plastic, with a door that opens.
pub(super) fn playhouse(b: &mut Build<'_>) {
    let plastic = b.rng.chance(0.4);
    let (wall, trim) = if plastic {
        (b.choose(&[CREAM, SKY, WHITE_PLASTIC]), b.one_of(BRIGHT))
    } else {
        (b.choose(&[PINE, OAK, SAGE, SKY, DUSTY_ROSE]), WHITE)
    };
    let roof = if plastic { b.one_of(BRIGHT) } else { b.choose(&[ANTHRACITE, TERRACOTTA, FOREST, NAVY]) };
    let porch = b.rng.chance(0.5) && b.size.x > 1.4;
    let front = if porch { 0.5 } else { 0.9 };
    let house = House { x: (-0.92, front), y: (-0.92, 0.92), floor: 0.0, eaves: b.vary(0.66, 0.72) };
    walls(b, &house, wall, trim);
    gables(b, &house, 0.995, wall, roof);
    if porch {
        let roof_at = house.eaves;
        b.slab("porch", [front, -0.92, 0.0], [0.98, 0.92, 0.03], b.style.wood);
        for y in SIDES {
            b.slab("post", [0.9, y * 0.88 - 0.03, 0.03], [0.96, y * 0.88 + 0.03, roof_at - 0.055], trim);
        }
        b.chunk(
            "porch_roof",
            &[
                [front, -0.98, roof_at - 0.035],
                [front, 0.98, roof_at - 0.035],
                [front, -0.98, roof_at - 0.005],
                [front, 0.98, roof_at - 0.005],
                [1.0, -0.98, roof_at - 0.075],
                [1.0, 0.98, roof_at - 0.075],
                [1.0, -0.98, roof_at - 0.045],
                [1.0, 0.98, roof_at - 0.045],
            ],
            roof,
        );
    }
    b.slab("flower_box", [front, 0.3, 0.2], [(front + 0.1).min(0.97), 0.8, 0.27], trim);
    for (i, y) in [0.38, 0.55, 0.72].into_iter().enumerate() {
        b.ellipsoid("flower", [front + 0.05, y, 0.29], [0.05, 0.08, 0.035], [PETAL_RED, PETAL_YELLOW, PETAL_PINK][i]);
    }
}

/// A house on stilts around a trunk, with a ladder and a crown above.
pub(super) fn tree_house(b: &mut Build<'_>) {
    let (wall, roof) = (b.choose(&[PINE, OAK, TEAK]), b.choose(&[FOREST, TERRACOTTA, ANTHRACITE]));
    let floor = 0.4;
    let leafy = b.rng.chance(0.6);
    let ridge = if leafy { 0.82 } else { 0.99 };
    let r = (b.size.x * 0.1).min(0.2);
    b.pole("trunk", [-0.7, 0.0, 0.0], [-0.7, 0.0, ridge * 0.94], r, BARK);
    b.slab("platform", [-0.98, -0.98, floor - 0.025], [0.98, 0.98, floor], wall);
    for (x, y) in CORNERS {
        b.plank("stilt", [x * 0.8, y * 0.85, 0.0], [x * 0.8, y * 0.85, floor - 0.01], (0.11, 0.11), wall);
        b.plank("brace", [x * 0.75, y * 0.85, floor * 0.55], [x * 0.3, y * 0.85, floor - 0.02], (0.06, 0.06), wall);
    }
    let house = House { x: (-0.5, 0.5), y: (-0.85, 0.85), floor, eaves: ridge - 0.16 };
    walls(b, &house, wall, WHITE);
    gables(b, &house, ridge, wall, roof);
    for y in SIDES {
        b.slab("railing", [0.52, y * 0.94 - 0.02, floor + 0.13], [0.96, y * 0.94 + 0.02, floor + 0.15], wall);
        for x in [0.6, 0.93] {
            b.slab("baluster", [x - 0.02, y * 0.94 - 0.02, floor], [x + 0.02, y * 0.94 + 0.02, floor + 0.132], wall);
        }
        b.plank("stile", [0.96, y * 0.14 + 0.4, 0.0], [0.93, y * 0.14 + 0.4, floor + 0.1], (0.05, 0.03), wall);
    }
    for i in 1..8 {
        let z = floor * i as f32 / 8.0;
        b.pole("rung", [0.95, 0.26, z], [0.95, 0.54, z], 0.018, wall);
    }
    if leafy {
        let leaf = b.choose(&[LEAF, DARK_LEAF, LIGHT_LEAF]);
        for (x, y, z, s) in
            [(-0.5, 0.0, 0.84, 1.0), (-0.3, 0.45, 0.88, 0.8), (-0.4, -0.5, 0.87, 0.85), (0.2, -0.1, 0.9, 0.7)]
        {
            b.ellipsoid("crown", [x, y, z], [0.48 * s, 0.48 * s, 0.1], leaf);
        }
    }
}

/// An inflatable castle: floor and walls of tubes, four towers, a doorway.
pub(super) fn castle(b: &mut Build<'_>) {
    let (a, c, flag) = (b.one_of(BRIGHT), b.one_of(BRIGHT), b.one_of(BRIGHT));
    let r = (b.size.x.min(b.size.y) * 0.1).min(b.size.z * 0.16);
    let (ex, ey) = (1.0 - 2.0 * r / b.size.x, 1.0 - 2.0 * r / b.size.y);
    let front = ex - 0.26;
    b.slab("floor", [-ex, -ey, 0.0], [front, ey, 0.11], a);
    let count = 6;
    for i in 0..count {
        let y = -ey + 2.0 * ey * (i as f32 + 0.5) / count as f32;
        let half = ey / count as f32 * 0.94;
        b.pad("floor_tube", [-ex, y - half, 0.05], [front, y + half, 0.125], 0.08, if i % 2 == 0 { c } else { a });
    }
    b.pad("step", [front - 0.02, -0.5, 0.0], [0.98, 0.5, 0.1], 0.08, c);
    b.inner_floor(
        "floor",
        [(front - ex) / 2.0, 0.0, 0.126],
        ((front + ex) / 2.0 - r / b.size.x * 3.0, ey - r / b.size.y * 3.0),
        0.7,
    );
    for (x, y) in [(-ex, ey), (-ex, -ey), (front, ey), (front, -ey)] {
        let foot = b.p([x, y, 0.0]);
        b.lathe(
            "tower",
            foot,
            &[(r * 0.96, 0.0), (r, b.size.z * 0.1), (r, b.size.z * 0.7), (r * 0.8, b.size.z * 0.74)],
            a,
        );
        b.lathe(
            "spire",
            [foot[0], foot[1], b.size.z * 0.7],
            &[(r * 0.99, 0.0), (r * 0.95, b.size.z * 0.03), (r * 0.1, b.size.z * 0.27), (0.0, b.size.z * 0.28)],
            c,
        );
        b.ball("knob", [foot[0], foot[1], b.size.z * 0.97], b.size.z * 0.022, flag);
    }
    for i in 0..3 {
        let z = 0.14 + 0.13 * i as f32;
        let tube = r * 0.55;
        let mat = if i % 2 == 0 { c } else { a };
        b.pole("wall", [-ex, -ey, z + 0.06], [-ex, ey, z + 0.06], tube, mat);
        for y in SIDES {
            b.pole("wall", [-ex, y * ey, z + 0.05], [front, y * ey, z + 0.05], tube, mat);
        }
    }
    let (gate, flap) = (ey - (r + 0.004) * 2.0 / b.size.y, b.choose(&[GREY_FABRIC, BLACK_FABRIC, WHITE_COTTON]));
    for y in SIDES {
        let anchor = b.p([front + 0.006, y * gate, 0.0]);
        let (near, far) = (y * 0.004, y * gate);
        b.hinge(anchor, [0.0, 0.0, y], 1.5, |b| {
            b.slab("flap", [front - 0.006, near.min(far), 0.135], [front + 0.006, near.max(far), 0.5], flap);
        });
    }
    let arch = arc_outline((0.0, 0.55), (ey, 0.26), (0.0, std::f32::consts::PI), 9);
    let arch: Vec<P> = arch.into_iter().map(|(y, z)| [front, y, z]).collect();
    b.bent_rod("arch", &arch, r * 0.5, flag);
    b.pole("hose", [-0.98, 0.3, 0.06], [-ex, 0.3, 0.06], b.size.z * 0.03, BLACK_FABRIC);
    b.wheel(
        "blower",
        Axis::Y,
        [-ex - r / b.size.x, 0.3, 0.06],
        ((b.size.z * 0.055).min(r * 0.8), b.size.y * 0.05),
        BLACK_PLASTIC,
    );
}

/// An outdoor kitchen for mud: worktop with two bowls, shelf, back with hooks.
pub(super) fn mud_kitchen(b: &mut Build<'_>) {
    let (wood, bowl) = (b.choose(&[PINE, TEAK, OAK, GREY_OAK]), b.choose(&[STEEL, GALVANISED, BLUE_METAL]));
    let (top, t) = (0.5, 0.03);
    let leg = (0.045 / b.size.x, 0.045 / b.size.y);
    for (x, y) in CORNERS {
        let high = if x < 0.0 { 0.985 } else { top };
        let at = [x * (1.0 - leg.0), y * (1.0 - leg.1)];
        b.slab("leg", [at[0] - leg.0, at[1] - leg.1, 0.0], [at[0] + leg.0, at[1] + leg.1, high], wood);
    }
    let (ix, iy) = (1.0 - 2.0 * leg.0, 1.0 - 2.0 * leg.1);
    b.slab("shelf", [-ix, -iy, 0.14], [0.98, iy, 0.165], wood);
    let middle = b.p([0.0, 0.0, 0.165]);
    b.ledge("shelf", middle, (b.size.x * 0.42, b.size.y * 0.4), b.size.z * (top - 0.28));
    let r = (b.size.y * 0.14).min(b.size.x * 0.3);
    let (hx, hy) = (r * 2.0 / b.size.x, r * 2.0 / b.size.y);
    let rim = top + t;
    // The worktop leaves two square holes for the bowls.
    b.slab("worktop", [-1.0, -1.0, top], [-hx, 1.0, rim], wood);
    b.slab("worktop", [hx, -1.0, top], [1.0, 1.0, rim], wood);
    for (y0, y1) in [(-1.0, -0.5 - hy), (-0.5 + hy, 0.5 - hy), (0.5 + hy, 1.0)] {
        b.slab("worktop", [-hx, y0, top], [hx, y1, rim], wood);
    }
    for y in [-0.5, 0.5] {
        let h = b.size.z * 0.1;
        let base = b.p([0.0, y, rim]);
        let profile = [
            (r * 0.6, 0.0),
            (r * 0.96, h),
            (r * 1.1, h),
            (r * 1.1, h + 0.004),
            (r * 0.94, h + 0.004),
            (r * 0.58, 0.004),
        ];
        b.lathe("basin", [base[0], base[1], base[2] - h], &profile, bowl);
        b.inside("basin", [base[0], base[1], base[2] - h + 0.005], (r * 0.4, r * 0.4), h * 0.9);
    }
    b.deck("worktop", [0.15, 0.0, rim], (0.6, (0.45 - hy).max(0.05)));
    for z in [0.62, 0.74, 0.9] {
        b.slab("back_board", [-1.0, -iy, z], [-0.96, iy, z + 0.075], wood);
    }
    b.slab("back_shelf", [-0.96, -iy, 0.955], [-0.6, iy, 0.98], wood);
    for (i, y) in [-0.6, -0.2, 0.2, 0.6].into_iter().enumerate() {
        b.pole("hook", [-0.97, y, 0.77], [-0.84, y, 0.79], 0.005, IRON);
        if i % 2 == 0 {
            b.pole("spoon", [-0.9, y, 0.57], [-0.9, y, 0.79], 0.006, STEEL);
            b.ellipsoid("spoon", [-0.9, y, 0.575], [0.03, 0.06, 0.03], STEEL);
        }
    }
    let tap = [[-0.85, 0.5, rim], [-0.85, 0.5, 0.68], [-0.45, 0.5, 0.68], [-0.45, 0.5, 0.65]];
    b.bent_rod("tap", &tap, 0.01, BRASS);
}
