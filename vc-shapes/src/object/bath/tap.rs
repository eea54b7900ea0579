//! Taps and shower heads.

use crate::material::*;
use crate::solid::{Build, P, fit, half_dims};

/// A mixer or a tap with two handles; with a high bent or a low spout, or with a hose.
pub(super) fn faucet(b: &mut Build<'_>) {
    let u = fit(b, [0.112, 0.048, 0.128]);
    let (x, y, h) = half_dims(b);
    let tap = b.style.tap;
    let r = (0.022 * u).min(y * 0.8);
    let (root, reach) = (-x + r, x);
    b.lathe("base", [root, 0.0, 0.0], &[(r, 0.0), (r, h * 0.02), (r * 0.8, h * 0.04)], tap);
    let pipe = r * b.vary(0.45, 0.6);
    let body = h * if h > 0.25 { b.vary(0.3, 0.45) } else { b.vary(0.4, 0.55) };
    let end = reach - pipe * 1.45;
    let top = h - pipe * 1.45;
    let aerator = pipe * 1.15;
    match b.rng.below(3) {
        0 => {
            // A gooseneck.
            b.cylinder("body", [root, 0.0, 0.0], r * 0.8, body, tap);
            let span = (end - root) / 2.0;
            let arc: Vec<P> =
                ARC.iter().map(|&(c, s)| [root + span - span * c, 0.0, top - span.min(h * 0.3) * (1.0 - s)]).collect();
            let mut points = vec![[root, 0.0, body * 0.9]];
            points.extend(arc);
            points.push([end, 0.0, (top - span.min(h * 0.3)) * 0.86]);
            b.pipe("spout", &points, pipe, tap);
            b.rod(
                "aerator",
                [end, 0.0, points[points.len() - 1][2] - pipe * 1.4],
                points[points.len() - 1],
                aerator,
                tap,
            );
        }
        1 => {
            // Square: up, out and down.
            b.cylinder("body", [root, 0.0, 0.0], r * 0.8, body, tap);
            let points = [[root, 0.0, body * 0.9], [root, 0.0, top], [end, 0.0, top], [end, 0.0, top - h * 0.08]];
            b.pipe("spout", &points, pipe, tap);
            b.rod("aerator", [end, 0.0, top - h * 0.08 - pipe * 1.3], [end, 0.0, top - h * 0.08], aerator, tap);
        }
        _ => {
            // A stout body with its spout near the top and a lever above.
            let neck = h * 0.8;
            b.cylinder("body", [root, 0.0, 0.0], r * 0.95, neck, tap);
            let tip = [end - pipe * 0.3, 0.0, neck * 0.8];
            b.bar("spout", [root, 0.0, neck * 0.72], tip, pipe * 1.15, tap);
            b.rod("aerator", [tip[0], 0.0, tip[2] - pipe * 2.2], tip, aerator * 0.9, tap);
            b.cylinder("cap", [root, 0.0, neck - 0.001 * u], r * 0.8, h * 0.08, tap);
            let from = [root, 0.0, neck + h * 0.08];
            b.bar("lever", from, [root + (end - root) * 0.4, 0.0, h - r * 0.42], r * 0.28, tap);
            if y <= 0.07 * u {
                return;
            }
        }
    }
    handles(b, [root, r, body], (y, h), u, tap);
}

/// Half a circle, from one end over the top to the other.
const ARC: [(f32, f32); 7] =
    [(1.0, 0.0), (0.866, 0.5), (0.5, 0.866), (0.0, 1.0), (-0.5, 0.866), (-0.866, 0.5), (-1.0, 0.0)];

/// A lever at the side, or a cross handle at either side where there is space.
fn handles(b: &mut Build<'_>, [root, r, body]: P, (y, h): (f32, f32), u: f32, tap: MaterialId) {
    if y > 0.07 * u {
        let out = y - 0.02 * u;
        b.rod("bridge", [root, -out, body * 0.4], [root, out, body * 0.4], r * 0.45, tap);
        for (cy, dot) in [(-out, BLUE_METAL), (out, RED_METAL)] {
            b.cylinder("valve", [root, cy, 0.0], r * 0.6, body * 0.7, tap);
            b.rod("cross", [root - 0.02 * u, cy, body * 0.75], [root + 0.02 * u, cy, body * 0.75], 0.005 * u, tap);
            b.rod("cross", [root, cy - 0.02 * u, body * 0.75], [root, cy + 0.02 * u, body * 0.75], 0.005 * u, tap);
            b.cylinder("dot", [root, cy, body * 0.7], r * 0.4, body * 0.07 + 0.004 * u, dot);
        }
    } else {
        let z = body * 0.75;
        b.rod("valve", [root, 0.0, z], [root, (y - 0.004 * u).max(r * 0.5), z], r * 0.6, tap);
        let cy = (y - 0.006 * u).max(r * 0.45);
        b.bar("lever", [root, cy, z], [root + 0.03 * u, cy, (z + h * 0.2).min(h * 0.8)], 0.0055 * u, tap);
    }
}

/// A round or square shower head on an arm, or a handset in its holder.
pub(super) fn shower_head(b: &mut Build<'_>) {
    let u = fit(b, [0.048, 0.064, 0.04]);
    let (x, y, h) = half_dims(b);
    let tap = b.style.tap;
    let r = y.min(x * 0.9);
    let flat = (h * 0.2).min(0.022 * u);
    if b.rng.chance(0.6) && x > 0.05 {
        let cx = x - r;
        if b.rng.chance(0.5) {
            b.lathe("rose", [cx, 0.0, 0.0], &[(r * 0.94, 0.0), (r, flat * 0.5), (r * 0.3, flat)], tap);
        } else {
            b.rounded_block("rose", [cx - r, -y, 0.0], [x, y, flat * 0.8], 0.004 * u, tap);
        }
        b.cylinder("joint", [cx, 0.0, flat * 0.7], 0.014 * u, h * 0.35, tap);
        let z = h - 0.013 * u;
        b.pipe("arm", &[[cx, 0.0, flat + h * 0.1], [cx, 0.0, z], [-x + 0.013 * u, 0.0, z]], 0.0105 * u, tap);
        b.rod("flange", [-x, 0.0, z - 0.012 * u], [-x + 0.006 * u, 0.0, z - 0.012 * u], 0.025 * u, tap);
    } else {
        let grip = 0.013 * u;
        b.block("holder", [-x, -0.02 * u, 0.0], [-x + 0.012 * u, 0.02 * u, h * 0.5], tap);
        let out = (x * 0.6).min(h * 0.26).min(r);
        let cx = x - out * 0.72 - 0.009 * u;
        b.bar("handle", [-x + grip + 0.008 * u, 0.0, grip], [cx - x * 0.1, 0.0, h * 0.72], grip * 0.9, tap);
        let centre = [cx, 0.0, h * 0.74];
        b.lathe_along(
            "rose",
            centre,
            [cx + 0.4, 0.0, h * 0.74 - 0.4],
            &[(out * 0.9, -0.008 * u), (out, 0.004 * u), (out * 0.94, 0.012 * u)],
            tap,
        );
    }
}
