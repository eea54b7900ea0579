//! Cooking outdoors: grills and smokers.

use std::f32::consts::{FRAC_PI_2, PI, TAU};

use vc_graph::portable::Portable;

use crate::material::*;
use crate::object::joinery::{Handle, Swing, door};
use crate::solid::{Axis, Build, CORNERS, P, at_least, limb, polar, spaced};

/// A half tube along Y between two positions, closed at both ends.
fn trough(
    b: &mut Build<'_>,
    name: &str,
    [cx, cz]: [f32; 2],
    (r, t): (f32, f32),
    (y0, y1): (f32, f32),
    upper: bool,
    mat: MaterialId,
) {
    let sign = if upper { 1.0 } else { -1.0 };
    let arc = |r: f32| {
        (0..=10)
            .map(move |i| PI * i as f32 / 10.0)
            .map(move |a| (cx + r * a.cosine(), cz + sign * (0.002 + r * a.sine())))
    };
    let shell: Vec<(f32, f32)> = arc(r).chain(arc(r - t).collect::<Vec<_>>().into_iter().rev()).collect();
    b.prism(name, Axis::Y, [0.0, y0, 0.0], &shell, y1 - y0, mat);
    for y in [y0 + 0.001, y1 - t - 0.001] {
        b.prism(name, Axis::Y, [0.0, y, 0.0], &arc(r - t * 0.5).collect::<Vec<_>>(), t, mat);
    }
}

/// A charcoal grill: a kettle or a barrel, with a lid and a shelf at its side.
pub(super) fn barbecue(b: &mut Build<'_>) {
    at_least(b, [0.25, 0.28, 0.45]);
    if b.size.y > 0.95 || b.rng.chance(0.35) { barrel_grill(b) } else { kettle(b) }
}

fn kettle(b: &mut Build<'_>) {
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let enamel = b.choose(&[BLACK_METAL, BLACK_METAL, RED_METAL, GREEN_METAL, ANTHRACITE, BLUE_METAL]);
    let shelf = (2.0 * y - 0.45).clamp(0.08, 0.4);
    let r = (x - 0.05).min(y - shelf / 2.0).min(h * 0.32);
    let cy = y - r;
    let dome = r * b.vary(0.6, 0.75);
    let rim = h - dome - 0.045;
    let bowl = r * b.vary(0.6, 0.75);
    b.at([-x + r + 0.05, cy, 0.0], 0.0, |b| {
        let curve = |r: f32, d: f32, up: f32| {
            [0.2_f32, 0.5, 0.8, 1.0].map(|s| (r * (1.0 - (1.0 - s).raised(2)).sqrt(), up * d * (1.0 - s)))
        };
        let out = curve(r, bowl, -1.0);
        let inner = curve(r - 0.008, bowl - 0.008, -1.0);
        let profile: Vec<(f32, f32)> = [(0.0, rim - bowl)]
            .into_iter()
            .chain(out.map(|(r, z)| (r, rim + z)))
            .chain(inner.into_iter().rev().map(|(r, z)| (r, rim + z)))
            .collect();
        b.lathe("bowl", [0.0; 3], &profile, enamel);
        b.cylinder("grate", [0.0, 0.0, rim - 0.016], r - 0.012, 0.008, STEEL);
        b.cylinder("charcoal", [0.0, 0.0, rim - bowl * 0.7], r * 0.7, bowl * 0.3, BLACK_GRANITE);
        b.hinge([-r, 0.0, rim], [0.0, -1.0, 0.0], FRAC_PI_2, |b| {
            let (out, inner) = (curve(r, dome, 1.0), curve(r - 0.008, dome - 0.008, 1.0));
            let rise = |(r, z): (f32, f32)| (r, rim + 0.003 + z);
            let profile: Vec<(f32, f32)> = out.map(rise).into_iter().rev().chain([(0.0, rim + 0.003 + dome)]).collect();
            let hollow: Vec<(f32, f32)> = [(0.0, rim - 0.005 + dome)].into_iter().chain(inner.map(rise)).collect();
            let ring: Vec<(f32, f32)> = profile.iter().copied().chain(hollow).chain(profile.first().copied()).collect();
            b.lathe("lid", [0.0; 3], &ring, enamel);
            let top = rim + dome;
            b.block("handle", [-0.012, -0.05, top - 0.01], [0.012, -0.035, top + 0.03], IRON);
            b.block("handle", [-0.012, 0.035, top - 0.01], [0.012, 0.05, top + 0.03], IRON);
            b.block("handle", [-0.014, -0.07, top + 0.028], [0.014, 0.07, top + 0.044], BEECH);
        });
        b.block("hinge", [-r - 0.02, -0.03, rim - 0.05], [-r + 0.012, 0.03, rim - 0.002], enamel);
        b.inside("grate", [0.0, 0.0, rim - 0.008], (r * 0.62, r * 0.62), dome * 0.5);
        for i in 0..3 {
            let angle = TAU * i as f32 / 3.0;
            let ((x0, y0), (x1, y1)) = (polar(angle, r * 0.6), polar(angle, r * 0.85));
            b.hull("leg", &limb([x1, y1, 0.012], [x0, y0, rim - bowl * 0.75], 0.012, 0.012), ALUMINIUM);
            if i > 0 {
                b.rod("wheel", [x1, y1 - 0.015, 0.06], [x1, y1 + 0.015, 0.06], 0.06, RUBBER);
            }
        }
        b.lathe(
            "ash_pan",
            [0.0, 0.0, (rim - bowl) * 0.55],
            &[(r * 0.5, 0.0), (r * 0.55, 0.02), (r * 0.5, 0.02), (0.0, 0.005)],
            ALUMINIUM,
        );
        b.cylinder("ash_rod", [0.0, 0.0, (rim - bowl) * 0.55], 0.01, rim * 0.5 - bowl * 0.4, ALUMINIUM);
    });
    let (from, to) = (-y, cy - r + 0.02);
    let z = rim - 0.03;
    let middle = -x + r + 0.05;
    b.block("shelf", [middle - r * 0.6, from, z - 0.02], [middle + r * 0.6, to, z], b.style.wood);
    b.top(
        "shelf",
        [middle, f32::midpoint(from, to - 0.03), z],
        (r * 0.55, ((to - 0.03 - from) / 2.0 - 0.004).max(0.02)),
    );
    b.rod("rail", [middle + r * 0.7, from + 0.01, z - 0.03], [middle + r * 0.5, cy, z - 0.03], 0.006, STEEL);
}

fn barrel_grill(b: &mut Build<'_>) {
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let enamel = b.choose(&[BLACK_METAL, IRON, RUST, ANTHRACITE]);
    let r = ((x - 0.07) * 0.95).min(h * 0.25);
    let shelf = (2.0 * y * b.vary(0.22, 0.32)).max(0.1);
    let (y0, y1) = (-y + shelf, y - 0.02);
    let rim = h - r - 0.015;
    let cx = -x + r + 0.01;
    barrel(b, [cx, rim], r, (y0, y1), enamel);
    let z = rim - 0.02;
    b.block("shelf", [cx - r * 0.9, -y, z - 0.022], [cx + r * 0.9, y0 + 0.01, z], b.style.wood);
    b.top("shelf", [cx, f32::midpoint(-y, y0), z], (r * 0.8, shelf / 2.0 - 0.015));
    if b.rng.chance(0.5) {
        let low = h * 0.25;
        b.block("rack", [cx - r * 0.8, y0 + 0.02, low], [cx + r * 0.8, y1 - 0.04, low + 0.015], STEEL);
    }
}

/// A barrel with a lid and a grate on four legs, one pair with wheels.
fn barrel(b: &mut Build<'_>, [cx, rim]: [f32; 2], r: f32, (y0, y1): (f32, f32), mat: MaterialId) {
    let t = 0.008;
    trough(b, "drum", [cx, rim], (r, t), (y0, y1), false, mat);
    b.block("grate", [cx - r + 0.012, y0 + t, rim - 0.012], [cx + r - 0.012, y1 - t, rim - 0.006], STEEL);
    b.inside("grate", [cx, f32::midpoint(y0, y1), rim - 0.006], (r * 0.7, (y1 - y0) / 2.0 - 0.03), r * 0.62);
    b.hinge([cx - r, 0.0, rim], [0.0, -1.0, 0.0], FRAC_PI_2, |b| {
        trough(b, "lid", [cx, rim], (r, t), (y0, y1), true, mat);
        let (hx, hz) = (cx + r * 0.87, rim + r * 0.52);
        b.rod("handle", [hx + 0.045, y0 + (y1 - y0) * 0.25, hz], [hx + 0.045, y0 + (y1 - y0) * 0.75, hz], 0.01, BEECH);
        for share in [0.3, 0.7] {
            let hy = y0 + (y1 - y0) * share;
            b.rod("handle", [hx - 0.03, hy, hz], [hx + 0.045, hy, hz], 0.006, STEEL);
        }
        b.rod(
            "gauge",
            [cx + r * 0.9, f32::midpoint(y0, y1), rim + r * 0.25],
            [cx + r + 0.012, f32::midpoint(y0, y1), rim + r * 0.25],
            0.03,
            WHITE_METAL,
        );
    });
    b.block("hinge", [cx - r - 0.004, y0 + 0.05, rim - 0.03], [cx - r + 0.012, y1 - 0.05, rim + 0.004], mat);
    for (i, ly) in [y0 + 0.06, y1 - 0.06].into_iter().enumerate() {
        for side in [-1.0, 1.0] {
            let lx = cx + side * r * 0.75;
            b.cylinder(
                "leg",
                [lx, ly, if i == 0 { 0.0 } else { 0.06 }],
                0.014,
                rim - r * 0.55 - if i == 0 { 0.0 } else { 0.06 },
                IRON,
            );
            if i == 1 {
                b.rod("wheel", [lx, ly + 0.012, 0.08], [lx, ly + 0.04, 0.08], 0.08, RUBBER);
            }
        }
    }
}

/// A gas grill: a cabinet with doors, knobs, a lid, tables at both sides.
pub(super) fn gas_grill(b: &mut Build<'_>) {
    at_least(b, [0.28, 0.55, 0.5]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let mat = b.choose(&[BLACK_METAL, STEEL, ANTHRACITE, SILVER_METAL, RED_METAL]);
    let body = y * b.vary(0.48, 0.58);
    let (back, front) = (-x + 0.02, x - 0.06);
    let r = (front - back) / 2.0;
    let rim = h - r * 0.75 - 0.02;
    let (low, panel) = (0.08, rim - 0.16_f32.min(h * 0.15));
    let t = 0.012;
    for (from, to) in [
        ([back, -body, low], [front - 0.02, -body + t, panel]),
        ([back, body - t, low], [front - 0.02, body, panel]),
        ([back, -body + t, low], [back + t, body - t, panel]),
        ([back + t, -body + t, low], [front - 0.02, body - t, low + t]),
    ] {
        b.block("cabinet", from, to, mat);
    }
    let metal = b.style.metal;
    door(b, "door_left", [front - 0.02, 0.0, low], [front, body, panel], Swing::Left, Handle::Bar, (mat, metal));
    door(b, "door_right", [front - 0.02, -body, low], [front, 0.0, panel], Swing::Right, Handle::Bar, (mat, metal));
    let middle = (back + front) / 2.0;
    b.inside("compartment", [middle, 0.0, low + t], (r - 0.04, body - 0.03), panel - low - 0.03);
    // The firebox with burner knobs.
    b.block("firebox", [back, -body, panel], [front, body, rim - 0.05], mat);
    for (from, to) in [
        ([back, -body], [front, -body + t]),
        ([back, body - t], [front, body]),
        ([back, -body + t], [back + t, body - t]),
        ([front - t, -body + t], [front, body - t]),
    ] {
        b.block("firebox", [from[0], from[1], rim - 0.051], [to[0], to[1], rim], mat);
    }
    let knobs = b.rng.count(2, 5);
    let z = f32::midpoint(panel, rim - 0.04);
    for cy in spaced(knobs, -body * 0.75, body * 0.75) {
        b.rod("knob", [front - 0.005, cy, z], [front + 0.03, cy, z], 0.022, STEEL);
    }
    for i in 0..9 {
        let cy = body * (i as f32 / 4.0 - 1.0) * 0.92;
        b.block("grate", [back + t, cy - 0.008, rim - 0.03], [front - t, cy + 0.008, rim - 0.02], IRON);
    }
    b.inside("grate", [middle, 0.0, rim - 0.02], (r * 0.72, body * 0.9), r * 0.5);
    let (dome, sides) = (h - rim - 0.002, 10);
    let arc = |k: f32, rise: f32| {
        (0..=sides)
            .map(move |i| PI * i as f32 / sides as f32)
            .map(move |a| (middle + (r - k) * a.cosine(), rim + 0.002 + (rise - k).max(0.01) * a.sine()))
    };
    b.hinge([back, 0.0, rim], [0.0, -1.0, 0.0], FRAC_PI_2 * 0.9, |b| {
        let shell: Vec<(f32, f32)> = arc(0.0, dome).chain(arc(t, dome).collect::<Vec<_>>().into_iter().rev()).collect();
        b.prism("lid", Axis::Y, [0.0, -body, 0.0], &shell, 2.0 * body, mat);
        for cy in [-body + 0.001, body - t - 0.001] {
            b.prism("lid", Axis::Y, [0.0, cy, 0.0], &arc(t * 0.5, dome).collect::<Vec<_>>(), t, mat);
        }
        let (hx, hz) = (middle + r * 0.87, rim + dome * 0.5);
        b.rod("handle", [hx + 0.045, -body * 0.7, hz], [hx + 0.045, body * 0.7, hz], 0.012, STEEL);
        for cy in [-body * 0.6, body * 0.6] {
            b.rod("handle", [hx - 0.03, cy, hz], [hx + 0.045, cy, hz], 0.008, STEEL);
        }
    });
    for side in [-1.0, 1.0] {
        let (from, to) = (side * (body - 0.002), side * y);
        let z = rim - 0.03;
        b.block("table", [back + 0.02, from.min(to), z - 0.03], [front - 0.01, from.max(to), z], b.style.metal);
        let cy = (side * body + to) / 2.0;
        if side > 0.0 && y - body > 0.16 {
            let (out, hole) = (0.07_f32.min(r * 0.3), 0.05_f32.min(r * 0.22));
            b.lathe(
                "burner",
                [middle - r * 0.45, cy, z - 0.001],
                &[(out, 0.0), (out, 0.012), (hole, 0.012), (hole, 0.0), (out, 0.0)],
                IRON,
            );
            b.top("table", [middle + r * 0.35, cy, z], (r * 0.45, (y - body) / 2.0 - 0.01));
        } else {
            b.top(
                if side > 0.0 { "table_left" } else { "table_right" },
                [middle, cy, z],
                (r * 0.85, (y - body) / 2.0 - 0.01),
            );
        }
    }
    for (sx, sy) in CORNERS {
        let (cx, cy) = (middle + sx * (r - 0.06), sy * (body - 0.04));
        b.rod("caster", [cx, cy - 0.015, 0.04], [cx, cy + 0.015, 0.04], 0.04, RUBBER);
        b.block("caster", [cx - 0.012, cy - 0.02, 0.045], [cx + 0.012, cy + 0.02, low + 0.005], IRON);
    }
}

/// A smoker: a barrel with a fire box and a chimney, or an upright drum.
pub(super) fn smoker(b: &mut Build<'_>) {
    at_least(b, [0.22, 0.22, 0.42]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let mat = b.choose(&[IRON, BLACK_METAL, RUST, ANTHRACITE]);
    if 2.0 * y > 0.9 {
        let r = (x - 0.06).min(h * 0.22);
        let (rim, cx) = (h * 0.72, -x + r + 0.01);
        let split = -y + 2.0 * y * 0.28;
        barrel(b, [cx, rim], r, (split, y - 0.094), mat);
        b.rod("fire_box", [cx, -y, rim - r * 0.75], [cx, split + 0.01, rim - r * 0.75], r * 0.72, mat);
        b.rod(
            "fire_box_door",
            [cx + r * 0.6, -y + (split + y) * 0.5, rim - r * 0.75],
            [cx + r * 0.76, -y + (split + y) * 0.5, rim - r * 0.75],
            r * 0.35,
            mat,
        );
        // The chimney stands in front of the barrel's end, clear of the lid.
        let stack = y - 0.047;
        b.cylinder("chimney", [cx, stack, rim - r * 0.6], 0.03, h - rim + r * 0.6 - 0.01, mat);
        b.rod("flue", [cx, y - 0.098, rim - r * 0.4], [cx, stack, rim - r * 0.4], 0.024, mat);
        b.lathe("chimney", [cx, stack, h - 0.03], &[(0.045, 0.0), (0.045, 0.005), (0.01, 0.03)], mat);
    } else {
        let r = x.min(y) - 0.04;
        let (rim, low, t) = (h * 0.78, h * 0.14, 0.008);
        b.lathe("drum", [0.0; 3], &[(r, low), (r, rim), (r - t, rim), (r - t, low + 0.02), (0.0, low + 0.02)], mat);
        b.cylinder("grate", [0.0, 0.0, rim * 0.8], r - t * 0.5, 0.006, STEEL);
        b.inside("rack_2", [0.0, 0.0, rim * 0.8 + 0.006], (r * 0.62, r * 0.62), rim * 0.2);
        b.inside("rack_1", [0.0, 0.0, low + 0.02], (r * 0.62, r * 0.62), rim * 0.8 - low - 0.03);
        b.hinge([-r, 0.0, rim], [0.0, -1.0, 0.0], FRAC_PI_2, |b| {
            let top = h - rim - 0.03;
            b.lathe(
                "lid",
                [0.0, 0.0, rim + 0.002],
                &[
                    (r + 0.006, 0.0),
                    (r * 0.8, top * 0.7),
                    (r * 0.3, top),
                    (0.0, top),
                    (0.0, top - t),
                    (r * 0.78, top * 0.7 - t),
                    (r - t, 0.0),
                    (r + 0.006, 0.0),
                ],
                mat,
            );
            b.block("handle", [-0.015, -0.06, h - 0.035], [0.015, 0.06, h], BEECH);
        });
        b.block("hinge", [-r - 0.015, -0.03, rim - 0.04], [-r + 0.005, 0.03, rim + 0.008], mat);
        b.rod("gauge", [r - 0.01, 0.0, rim * 0.9], [r + 0.015, 0.0, rim * 0.9], 0.03, WHITE_METAL);
        b.block("door", [r - 0.02, -r * 0.35, low + 0.05], [r + 0.012, r * 0.35, low + h * 0.17], mat);
        for i in 0..3 {
            let (px, py) = polar(TAU * i as f32 / 3.0 + 0.5, r * 0.85);
            b.cylinder("leg", [px, py, 0.0], 0.012, low + 0.04, mat);
        }
    }
}

/// Barbecue tongs: two sprung arms, upright.
pub(super) fn grill_tongs(b: &mut Build<'_>) {
    at_least(b, [0.012, 0.014, 0.15]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (steel, grip) = (b.choose(&[STEEL, BLACK_METAL]), b.choose(&[BLACK_PLASTIC, BEECH, RED_PLASTIC, STEEL]));
    let wide = x * 0.6;
    for side in [-1.0, 1.0] {
        let at = |share: f32, z: f32, t: f32| {
            [
                [-wide, side * y * share, z],
                [wide, side * y * share, z],
                [wide, side * (y * share - t), z],
                [-wide, side * (y * share - t), z],
            ]
        };
        let t = (y * 0.16).min(0.003);
        b.hull("arm", &[at(0.96, h * 0.1, t), at(0.55, h * 0.98, t)].concat(), steel);
        let scoop = at(0.99, h * 0.12, t).into_iter().chain([
            [-x, side * y, 0.0],
            [x, side * y, 0.0],
            [x, side * (y - t), 0.0],
            [-x, side * (y - t), 0.0],
            [-x, side * y, h * 0.05],
            [x, side * y, h * 0.05],
        ]);
        b.hull("scoop", &scoop.collect::<Vec<P>>(), steel);
        b.hull("grip", &[at(0.8, h * 0.5, 2.5 * t), at(0.66, h * 0.85, 2.5 * t)].concat(), grip);
    }
    b.block("spring", [-wide, -y * 0.56, h * 0.975], [wide, y * 0.56, h], steel);
}
