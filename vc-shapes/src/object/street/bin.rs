//! Bins and mailboxes.

use std::f32::consts::{FRAC_PI_2, PI};

use vc_graph::portable::Portable;

use crate::material::*;
use crate::solid::{Axis, Build, P, at_least, polar, spaced, tapered_tub};

/// A wheelie bin: a tapered tub on two wheels under a hinged lid.
pub(super) fn wheelie_bin(b: &mut Build<'_>) {
    at_least(b, [0.25, 0.22, 0.45]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let body = b.choose(&[BLACK_PLASTIC, GREY_PLASTIC, GREEN_PLASTIC, BROWN_PLASTIC, BLUE_PLASTIC]);
    let lid = b.choose(&[body, body, YELLOW_PLASTIC, BLUE_PLASTIC, GREEN_PLASTIC, RED_PLASTIC]);
    let (domed, rim) = (b.vary(0.03, 0.08), h * b.vary(0.86, 0.9));
    let wheel = (h * b.vary(0.09, 0.12)).min(x * 0.4);
    let (back, front) = (-x + 0.06, x - 0.015);
    let (middle, half) = ((back + front) / 2.0, (front - back) / 2.0);
    let low = 0.05;
    let shrink = b.vary(0.68, 0.8);
    let bottom = (half * shrink, (y - 0.02) * 0.85);
    tapered_tub(b, "body", [middle, 0.0, low], bottom, (half, y - 0.012), rim - low, 0.012, body);
    b.block(
        "foot",
        [middle + bottom.0 * 0.4, -bottom.1 * 0.8, 0.0],
        [middle + bottom.0 * 0.95, bottom.1 * 0.8, low + 0.003],
        body,
    );
    let axle = (back + half * (1.0 - shrink) * 0.8).max(-x + wheel);
    b.rod("axle", [axle, -y + 0.02, wheel], [axle, y - 0.02, wheel], 0.012, STEEL);
    for side in [-1.0, 1.0] {
        let cy = side * (y - 0.028);
        b.rod("wheel", [axle, cy - 0.024, wheel], [axle, cy + 0.024, wheel], wheel, RUBBER);
        b.rod("hub", [axle, cy - 0.027, wheel], [axle, cy + 0.027, wheel], wheel * 0.45, body);
        b.block(
            "strut",
            [axle - 0.03, side * bottom.1 * 0.9 - 0.02, wheel - 0.02],
            [middle - bottom.0 + 0.012, side * bottom.1 * 0.9 + 0.02, wheel + 0.03],
            body,
        );
    }
    let grip = rim - 0.03;
    b.rod("handle", [-x + 0.016, -y * 0.75, grip], [-x + 0.016, y * 0.75, grip], 0.015, body);
    for cy in [-y * 0.7, y * 0.7] {
        b.block("bracket", [-x + 0.016, cy - 0.015, grip - 0.012], [back + 0.02, cy + 0.015, grip + 0.012], body);
    }
    // The lid opens upwards over the handle.
    b.hinge([back - 0.02, 0.0, rim], [0.0, -1.0, 0.0], FRAC_PI_2 * 1.2, |b| {
        b.block("lid", [back - 0.02, -y, rim], [x, y, rim + 0.025], lid);
        let top = (h - rim - 0.025).min(domed).max(0.01);
        b.taper(
            "lid",
            [(back + x) / 2.0, 0.0, rim + 0.02],
            (half * 0.95, y * 0.93),
            (half * 0.7, y * 0.7),
            top + 0.005,
            lid,
        );
    });
    let room = (rim - low - 0.03).max(0.05);
    b.inside("compartment", [middle, 0.0, low + 0.012], (bottom.0 - 0.03, bottom.1 - 0.03), room);
}

/// A litter bin of streets and parks.
pub(super) fn street_bin(b: &mut Build<'_>) {
    at_least(b, [0.17, 0.17, 0.4]);
    let mat = b.choose(&[ANTHRACITE, GREEN_METAL, GALVANISED, BLACK_METAL, RED_METAL, BLUE_METAL, RUST]);
    match b.rng.below(4) {
        0 => drum(b, mat),
        1 => roofed(b, mat),
        2 => slatted(b, mat),
        _ => hung(b, mat),
    }
}

/// An upright can with a collar, open at the top, sometimes with a roof on posts.
fn drum(b: &mut Build<'_>, mat: MaterialId) {
    let (r, h) = (b.size.x.min(b.size.y) / 2.0, b.size.z);
    let roof = b.rng.chance(0.5);
    let rim = if roof { h * 0.72 } else { h };
    let (foot, wall) = (r * b.vary(0.7, 0.95), 0.008);
    let waist = r * b.vary(0.9, 0.98);
    let profile = [
        (foot, 0.0),
        (waist, rim * 0.9),
        (r, rim * 0.91),
        (r, rim),
        (r - 0.03, rim),
        (waist - wall - 0.012, rim * 0.9),
        (foot - wall, 0.03),
    ];
    b.lathe("can", [0.0; 3], &profile, mat);
    let band = b.choose(&[YELLOW_METAL, STEEL, mat]);
    let at = (foot + waist) / 2.0 + 0.003;
    b.lathe(
        "band",
        [0.0, 0.0, rim * 0.44],
        &[(at, 0.0), (at + 0.002, rim * 0.05), (at - 0.02, rim * 0.05), (at - 0.02, 0.0), (at, 0.0)],
        band,
    );
    if roof {
        for i in 0..3 {
            let (px, py) = polar(2.1 * i as f32, r - 0.02);
            b.cylinder("post", [px, py, rim - 0.01], 0.01, h - rim - 0.02, mat);
        }
        b.lathe("roof", [0.0, 0.0, h * 0.93], &[(r, 0.0), (r * 0.7, h * 0.05), (0.0, h * 0.07)], mat);
    }
    let inner = (foot - wall) * 0.66;
    b.inside("compartment", [0.0, 0.0, 0.03], (inner, inner), rim * 0.9);
}

/// A box with a hood that is open at the front.
fn roofed(b: &mut Build<'_>, mat: MaterialId) {
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (rim, foot) = (h * b.vary(0.62, 0.72), h * b.vary(0.03, 0.1));
    tapered_tub(b, "body", [0.0, 0.0, foot], (x - 0.01, y - 0.01), (x - 0.004, y - 0.004), rim - foot, 0.008, mat);
    b.block("foot", [-x * 0.7, -y * 0.7, 0.0], [x * 0.7, y * 0.7, foot + 0.004], IRON);
    let roof = b.choose(&[mat, STEEL, BLACK_METAL]);
    for side in [-1.0, 1.0] {
        let cy = side * (y - 0.012);
        b.block("cheek", [-x + 0.01, cy - 0.005, rim - 0.01], [x * 0.6, cy + 0.005, h * 0.9], mat);
    }
    b.block("back", [-x + 0.006, -y + 0.01, rim - 0.01], [-x + 0.014, y - 0.01, h * 0.9], mat);
    let rise = h * 0.1;
    let outline: Vec<(f32, f32)> = match b.rng.below(3) {
        0 => vec![(-y, 0.0), (y, 0.0), (0.0, rise)],
        1 => vec![(-y, 0.0), (y, 0.0), (y, rise * 0.3), (-y, rise)],
        _ => (0..=10).map(|i| PI * i as f32 / 10.0).map(|a| (y * a.cosine(), rise * a.sine())).collect(),
    };
    b.prism("roof", Axis::X, [-x, 0.0, h - rise], &outline, 2.0 * x, roof);
    b.block("flap", [x - 0.006, -y * 0.55, rim * 0.75], [x, y * 0.55, rim * 0.95], roof);
    b.inside("compartment", [0.0, 0.0, foot + 0.008], (x * 0.85, y * 0.85), h * 0.88 - foot);
}

/// A can behind upright laths.
fn slatted(b: &mut Build<'_>, mat: MaterialId) {
    let (r, h) = (b.size.x.min(b.size.y) / 2.0, b.size.z);
    let wood = b.choose(&[TEAK, OAK, PINE, WALNUT]);
    let inner = r - 0.03;
    b.lathe(
        "can",
        [0.0, 0.0, 0.04],
        &[(inner, 0.0), (inner, h * 0.94 - 0.04), (inner - 0.006, h * 0.94 - 0.04), (inner - 0.006, 0.01)],
        mat,
    );
    let count = b.rng.count(12, 20);
    for i in 0..count {
        let angle = PI * 2.0 * i as f32 / count as f32;
        let (px, py) = polar(angle, inner + 0.004);
        b.at([px, py, 0.0], angle, |b| {
            let half = inner * PI / count as f32 * 0.8;
            b.block("lath", [0.0, -half, 0.0], [0.017, half, h * 0.9], wood);
        });
    }
    for z in [h * 0.12, h * 0.78] {
        let out = (r - 0.004).max(inner + 0.022);
        b.lathe("hoop", [0.0, 0.0, z], &[(out, 0.0), (out, 0.03), (inner, 0.03), (inner, 0.0), (out, 0.0)], mat);
    }
    let collar = [(r, 0.0), (r, 0.02), (r - 0.045, 0.02), (r - 0.045, 0.0), (r, 0.0)];
    b.lathe("collar", [0.0, 0.0, h - 0.02], &collar, mat);
    for i in 0..4 {
        let (px, py) = polar(1.57 * i as f32 + 0.4, r - 0.025);
        b.cylinder("post", [px, py, h * 0.88], 0.008, h * 0.12 - 0.005, mat);
    }
    b.inside("compartment", [0.0, 0.0, 0.05], (inner * 0.66, inner * 0.66), h * 0.9);
}

/// A bin that hangs on a post.
fn hung(b: &mut Build<'_>, mat: MaterialId) {
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let post = 0.03;
    b.cylinder("post", [-x + post, 0.0, 0.0], post, h, GALVANISED);
    b.cylinder("foot", [-x + post + 0.04, 0.0, 0.0], 0.07_f32.min(x), 0.012, GALVANISED);
    let low = h * b.vary(0.35, 0.48);
    let (back, front) = (-x + 2.0 * post - 0.005, x);
    let (middle, half) = ((back + front) / 2.0, (front - back) / 2.0);
    let top = h * b.vary(0.9, 0.99);
    let shrink = b.vary(0.6, 0.95);
    tapered_tub(b, "body", [middle, 0.0, low], (half * shrink, y * 0.85), (half, y), top - low, 0.01, mat);
    for z in [low + 0.1, top - 0.08] {
        b.block("clamp", [-x + post, -0.045, z], [middle - half * shrink + 0.012, 0.045, z + 0.04], GALVANISED);
    }
    b.inside("compartment", [middle, 0.0, low + 0.01], (half * shrink * 0.8, y * 0.7), top - low - 0.03);
}

/// A mailbox: on the wall, on a post with a flag, or a pillar.
pub(super) fn mailbox(b: &mut Build<'_>) {
    at_least(b, [0.06, 0.125, 0.15]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let mat = b.choose(&[
        RED_METAL,
        WHITE_METAL,
        BLACK_METAL,
        GREEN_METAL,
        BLUE_METAL,
        SILVER_METAL,
        YELLOW_METAL,
        ANTHRACITE,
        COPPER,
    ]);
    if h < 0.65 {
        letter_box(b, [-x, -y, 0.0], [x, y, h], mat);
        return;
    }
    let wood = b.choose(&[PINE, OAK, WHITE, IRON, GALVANISED]);
    if x > 0.16 && b.rng.chance(0.75) {
        tunnel(b, mat, wood);
    } else {
        let low = h * b.vary(0.55, 0.68);
        let post = (x * 0.5).min(0.05);
        b.block("post", [-post, -post, 0.0], [post, post, low + 0.005], wood);
        b.block("foot", [-x * 0.9, -y * 0.6, 0.0], [x * 0.9, y * 0.6, 0.012], wood);
        letter_box(b, [-x, -y, low], [x, y, h], mat);
    }
}

/// A box with a slot, a front door and a sloping roof.
fn letter_box(b: &mut Build<'_>, low: P, high: P, mat: MaterialId) {
    let t = 0.006;
    let roof = ((high[2] - low[2]) * b.vary(0.06, 0.2)).min(0.1);
    let top = high[2] - roof;
    let front = high[0] - 0.012;
    b.block("back", low, [low[0] + t, high[1], top], mat);
    b.block("bottom", [low[0] + t, low[1] + t, low[2]], [front - t, high[1] - t, low[2] + t], mat);
    for cy in [low[1], high[1] - t] {
        b.block("side", [low[0] + t, cy, low[2]], [front - t, cy + t, top], mat);
    }
    let outline = [(low[0], top), (high[0], top), (high[0], top + roof * 0.4), (low[0], high[2])];
    b.prism("roof", Axis::Y, [0.0, low[1], 0.0], &outline, high[1] - low[1], mat);
    let slot = top - 0.05;
    b.block("front", [front - t, low[1], slot - 0.02], [front, high[1], top], mat);
    b.block("slot", [front - 0.001, low[1] + 0.03, slot], [front + 0.004, high[1] - 0.03, slot + 0.022], BLACK_METAL);
    b.hinge([front, low[1], low[2]], [0.0, 0.0, -1.0], FRAC_PI_2 * 1.1, |b| {
        b.block("door", [front - t, low[1] + 0.001, low[2]], [front, high[1] - 0.001, slot - 0.022], mat);
        let z = (low[2] + slot) / 2.0;
        b.rod("lock", [front, high[1] - 0.035, z], [front + 0.006, high[1] - 0.035, z], 0.009, BRASS);
        b.block("name", [front, low[1] + 0.05, z], [front + 0.002, high[1] - 0.07, z + 0.03], WHITE_PAPER);
    });
    let half = ((front - low[0]) / 2.0 - t - 0.004, (high[1] - low[1]) / 2.0 - t - 0.004);
    b.inside(
        "compartment",
        [(low[0] + front) / 2.0, 0.0, low[2] + t],
        (half.0.max(0.005), half.1),
        slot - low[2] - t - 0.03,
    );
}

/// The rounded rural mailbox on a post, with a flag and a front flap.
fn tunnel(b: &mut Build<'_>, mat: MaterialId, wood: MaterialId) {
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let half = (y * 0.8).min(0.14).min(h * 0.2);
    let tall = half * 2.3;
    let (low, t) = (h - tall, 0.006);
    let post = 0.045_f32.min(half * 0.5);
    b.block("post", [-post, -post, 0.0], [post, post, low - 0.015], wood);
    b.block("shelf", [-x, -half, low - 0.02], [x * 0.85, half, low], wood);
    let hood = |radius: f32, foot: f32| -> Vec<(f32, f32)> {
        let spring = tall - half;
        let arc =
            (0..=10).map(move |i| PI * i as f32 / 10.0).map(move |a| (radius * a.cosine(), spring + radius * a.sine()));
        [(-radius, foot), (radius, foot)].into_iter().chain(arc).collect()
    };
    let outer = hood(half, 0.0);
    // The shell: an arch, open at the bottom, over its own floor.
    let inner: Vec<_> = hood(half - t, 0.0).into_iter().skip(1).collect();
    let shell: Vec<(f32, f32)> =
        outer[1..].iter().copied().chain([(-half, 0.0), (-half + t, 0.0)]).chain(inner.into_iter().rev()).collect();
    b.prism("shell", Axis::X, [-x + 0.006, 0.0, low], &shell, 2.0 * x - 0.016, mat);
    b.block("floor", [-x + 0.006, -half + t, low], [x - 0.012, half - t, low + t], mat);
    b.prism("back", Axis::X, [-x, 0.0, low], &outer, 0.008, mat);
    b.hinge([x, 0.0, low], [0.0, 1.0, 0.0], FRAC_PI_2, |b| {
        b.prism("flap", Axis::X, [x - 0.012, 0.0, low], &hood(half * 0.99, 0.002), 0.007, mat);
        b.block("pull", [x - 0.006, -0.015, low + tall * 0.75], [x, 0.015, low + tall * 0.85], STEEL);
    });
    let side = half + 0.004;
    b.hinge([-x * 0.3, side, low + tall * 0.45], [0.0, -1.0, 0.0], FRAC_PI_2, |b| {
        b.block(
            "flag",
            [-x * 0.3 - 0.01, side - 0.005, low + tall * 0.4],
            [x * 0.4, side + 0.003, low + tall * 0.48],
            RED,
        );
        b.block("flag", [x * 0.15, side - 0.004, low + tall * 0.48], [x * 0.4, side + 0.002, low + tall * 0.65], RED);
    });
    b.inside("compartment", [0.0, 0.0, low + t], (x - 0.025, half - 2.0 * t - 0.004), tall - half * 0.6 - 2.0 * t);
    for cy in spaced(2, -half * 0.7, half * 0.7) {
        let brace = [(-post, -0.1), (-post, -0.14), (-x * 0.8, -0.012), (-x * 0.6, -0.012)];
        b.prism("brace", Axis::Y, [0.0, cy - 0.006, low], &brace, 0.012, wood);
    }
}
