//! Benches of parks, streets and gardens.

use crate::material::*;
use crate::solid::{Axis, Build, at_least, plate, spaced};

/// The supports of a bench.
#[derive(Clone, Copy, PartialEq)]
enum Frame {
    Wood,
    CastIron,
    Concrete,
    Tube,
}

/// A bench with a back: slats on wood, cast iron, concrete or bent tubes.
pub(in crate::object) fn bench(b: &mut Build<'_>) {
    let frames: &[Frame] = match b.class {
        "garden_bench" => &[Frame::Wood, Frame::Wood, Frame::CastIron, Frame::Tube],
        _ => &[Frame::CastIron, Frame::CastIron, Frame::Concrete, Frame::Tube, Frame::Wood],
    };
    let frame = b.one_of(frames);
    at_least(b, [0.25, 0.55, 0.37]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z - 0.004);
    let seat = (h * 0.52).min(0.45);
    let metal = b.choose(&[IRON, GREEN_METAL, BLACK_METAL, GALVANISED, ANTHRACITE]);
    let (wood, slat) = (b.choose(&[TEAK, OAK, PINE, GREY_OAK, WALNUT, b.style.wood]), 0.028);
    let arms = b.rng.chance(0.6);
    let lean = b.vary(0.25, 0.45) * x;
    // Seat slats fill the depth in front of the leaning back.
    let (front, back) = (x - 0.015, -x + lean + 0.035);
    let slats = b.rng.count(3, 7);
    let pitch = (front - back) / slats as f32;
    for cx in spaced(slats, back + pitch / 2.0, front - pitch / 2.0) {
        let half = pitch / 2.0 - 0.005;
        b.rounded_block("slat", [cx - half, -y, seat - slat], [cx + half, y, seat], 0.006, wood);
    }
    let back_at = |t: f32| [-x + lean * (1.0 - t), seat + 0.05 + (h - seat - 0.05) * t];
    if frame == Frame::Wood && b.rng.chance(0.6) {
        upright_slats(b, &back_at, y, wood);
    } else {
        level_slats(b, &back_at, y, wood);
    }
    let feet = if 2.0 * y > 1.7 && frame != Frame::Wood { 3 } else { 2 };
    for cy in spaced(feet, -y * 0.86, y * 0.86) {
        foot(b, frame, cy, seat - slat, &back_at, if frame == Frame::Wood { wood } else { metal });
        if arms && cy.abs() > y * 0.5 && frame != Frame::Concrete {
            arm(b, frame, cy, seat, &back_at, if frame == Frame::Wood { wood } else { metal });
        }
    }
    let middle = f32::midpoint(front, back + 0.05);
    let side = if arms { (y * 0.86 - 0.04).min(y * 0.8) } else { y * 0.95 };
    b.top("seat", [middle, 0.0, seat], ((front - back) / 2.0 - 0.06, side.max(0.05)));
}

/// The horizontal boards of the back, one above the other.
fn level_slats(b: &mut Build<'_>, back_at: &dyn Fn(f32) -> [f32; 2], y: f32, wood: MaterialId) {
    let slats = b.rng.count(2, 5);
    for i in 0..slats {
        let t = |share: f32| (i as f32 + share) / slats as f32;
        let ([x0, z0], [x1, z1]) = (back_at(t(0.06)), back_at(t(0.88)));
        let quad = [[x0 + 0.026, -y, z0], [x0 + 0.026, y, z0], [x1 + 0.026, y, z1], [x1 + 0.026, -y, z1]];
        plate(b, "back", quad, 0.024, wood);
    }
}

/// The rails of the back with narrow upright slats between.
fn upright_slats(b: &mut Build<'_>, back_at: &dyn Fn(f32) -> [f32; 2], y: f32, wood: MaterialId) {
    let ([x0, z0], [x1, z1]) = (back_at(0.1), back_at(0.93));
    b.block("rail", [x0, -y, z0 - 0.03], [x0 + 0.03, y, z0 + 0.03], wood);
    let top = (z1 + 0.03).min(b.size.z - 0.002);
    b.rounded_block("rail", [x1 - 0.003, -y, z1 - 0.03], [x1 + 0.03, y, top], 0.008, wood);
    let count = ((2.0 * y / b.vary(0.07, 0.13)) as usize).clamp(5, 24);
    for cy in spaced(count, -y * 0.94, y * 0.94) {
        let w = 0.02;
        let quad =
            [[x0 + 0.024, cy - w, z0], [x0 + 0.024, cy + w, z0], [x1 + 0.024, cy + w, z1], [x1 + 0.024, cy - w, z1]];
        plate(b, "back", quad, 0.016, wood);
    }
}

/// Legs below the seat and the post that supports the back.
fn foot(b: &mut Build<'_>, frame: Frame, cy: f32, seat: f32, back_at: &dyn Fn(f32) -> [f32; 2], mat: MaterialId) {
    let x = b.size.x / 2.0;
    let ([bx, bz], w) = (back_at(0.95), if frame == Frame::Wood { 0.03 } else { 0.022 });
    let low = back_at(0.0)[0];
    let post = |b: &mut Build<'_>, z: f32| {
        let outline = [(low, z), (low + 0.05, z), (bx + 0.012, bz), (bx, bz)];
        b.prism("post", Axis::Y, [0.0, cy - w, 0.0], &outline, 2.0 * w, mat);
    };
    match frame {
        Frame::Concrete => {
            b.taper("foot", [0.02, cy, 0.0], (x * 0.8, 0.06), (x * 0.65, 0.05), seat, CONCRETE);
            post(b, seat * 0.8);
        }
        Frame::Tube => {
            let r = 0.018;
            let (f, k) = (x - 0.05, low + 0.03);
            b.pipe("foot", &[[k, cy, r], [f, cy, r], [f, cy, seat - r]], r, mat);
            b.pipe("foot", &[[k, cy, r], [k, cy, seat - r], [f, cy, seat - r]], r, mat);
            post(b, seat * 0.9);
        }
        Frame::CastIron | Frame::Wood => {
            let leg = if frame == Frame::Wood { 0.03 } else { 0.02 };
            b.block("leg", [x - 0.03 - 2.0 * leg, cy - w, 0.0], [x - 0.03, cy + w, seat], mat);
            b.block("rail", [low, cy - w * 0.8, seat - 0.06], [x - 0.04, cy + w * 0.8, seat - 0.002], mat);
            let outline = [(-x + 0.01, 0.0), (-x + 0.01 + 2.0 * leg, 0.0), (low + 0.05, seat), (low, seat)];
            b.prism("leg", Axis::Y, [0.0, cy - w * 0.9, 0.0], &outline, w * 1.8, mat);
            post(b, seat - 0.01);
        }
    }
}

/// An armrest over the seat and the front post that supports it.
fn arm(b: &mut Build<'_>, frame: Frame, cy: f32, seat: f32, back_at: &dyn Fn(f32) -> [f32; 2], mat: MaterialId) {
    let x = b.size.x / 2.0;
    let z = (seat + 0.22).min(b.size.z * 0.9);
    let share = (z - seat) / (b.size.z - seat);
    let [bx, _] = back_at(share);
    let w = 0.028;
    if frame == Frame::Wood {
        b.rounded_block("arm", [bx, cy - w, z - 0.03], [x - 0.005, cy + w, z], 0.01, mat);
        b.block("arm", [x - 0.08, cy - w * 0.8, seat - 0.03], [x - 0.03, cy + w * 0.8, z - 0.02], mat);
    } else {
        let r = 0.014;
        b.pipe(
            "arm",
            &[[bx + r, cy, z - r], [x - 0.05, cy, z - r], [x - 0.03, cy, z - 0.06], [x - 0.06, cy, seat - 0.03]],
            r,
            mat,
        );
    }
}
