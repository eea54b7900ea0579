//! Framed and unframed pictures, on the wall or on a shelf.

use vc_graph::portable::Portable;

use super::picture::{Canvas, Inks, motif};
use crate::material::*;
use crate::solid::{Axis, Build, P, blocks, facing, sheet};

/// A frame around a picture; a deep one leans on a strut, for a shelf.
pub(super) fn frame(b: &mut Build<'_>) {
    facing(b, |b, t, w, h| {
        let deep = t > h * 0.2 && t > 0.03;
        if !deep {
            return framed(b, [0.0; 3], t, w, h);
        }
        let body = (t * 0.3).min(0.02);
        let lean = ((t - body) * 0.5 / h).min(0.35);
        let tall = (h - body * lean) / (1.0 + lean * lean).sqrt();
        let front = t / 2.0 - body / 2.0;
        let pose = nalgebra::Isometry3::new(
            nalgebra::Vector3::new(front - body * 0.1, 0.0, body * 0.5 * lean.sine()),
            nalgebra::Vector3::y() * -lean,
        );
        b.posed(pose, |b| framed(b, [0.0; 3], body, w, tall * 0.99));
        let (top, foot) = ([front - tall * 0.75 * lean - body, 0.75 * h], -t / 2.0);
        let strut = [(top[0], top[1]), (top[0] + body * 0.4, top[1]), (foot + body * 0.6, 0.0), (foot, 0.0)];
        b.prism("strut", Axis::Y, [0.0, -w * 0.15, 0.0], &strut, w * 0.3, BLACK_CARD);
    });
}

/// Frame, mat, picture and pane, with the centre of the base at `at`.
fn framed(b: &mut Build<'_>, at: P, t: f32, w: f32, h: f32) {
    let digital = b.class == "digital_photo_frame";
    let painting = b.class == "painting";
    let wood =
        if digital { BLACK_PLASTIC } else { b.choose(&[b.style.wood, b.style.metal, BLACK, WHITE, GOLD, WALNUT, OAK]) };
    let bar = w.min(h) * if digital { 0.08 } else { b.vary(0.04, 0.13) };
    let (back, face) = (at[0] - t / 2.0, at[0] + t / 2.0);
    let plain = painting && b.rng.chance(0.3);
    let (y, z0, z1) = (w / 2.0, at[2], at[2] + h);
    let plane = back + t * if plain { 0.85 } else { 0.5 };
    if plain {
        b.block("canvas", [back, -y, z0], [plane, y, z1], WHITE_COTTON);
        let step = (face - plane) / 3.0;
        let inks = Inks::painted(b);
        return motif(b, Canvas { half: (y * 0.998, h * 0.499), step }, [plane, 0.0, z0 + h / 2.0], inks);
    }
    let list = [
        ([back, -y, z0], [face, y, z0 + bar]),
        ([back, -y, z1 - bar], [face, y, z1]),
        ([back, -y, z0 + bar * 0.99], [face, -y + bar, z1 - bar * 0.99]),
        ([back, y - bar, z0 + bar * 0.99], [face, y, z1 - bar * 0.99]),
    ];
    blocks(b, "frame", &list, wood);
    moulding(b, (y - bar, z0 + bar, z1 - bar), (face, t), bar, wood);
    b.block(
        "back",
        [back + t * 0.05, -y + bar * 0.9, z0 + bar * 0.9],
        [plane, y - bar * 0.9, z1 - bar * 0.9],
        if digital { SCREEN } else { WHITE_PAPER },
    );
    let mount = if digital || painting { 0.0 } else { b.choose(&[0.0, 0.1, 0.2]) };
    let half = ((y - bar) * (1.0 - mount), (h / 2.0 - bar) * (1.0 - mount));
    let inks = match b.class {
        "digital_photo_frame" => Inks::screen(),
        "photo_frame" => Inks::photo(),
        _ => Inks::painted(b),
    };
    let step = (t * 0.09).min(0.0015);
    motif(b, Canvas { half, step }, [plane, 0.0, z0 + h / 2.0], inks);
}

/// A bead along the inner edge of a frame.
fn moulding(b: &mut Build<'_>, (y, z0, z1): (f32, f32, f32), (face, deep): (f32, f32), bar: f32, wood: MaterialId) {
    if b.rng.chance(0.5) {
        return;
    }
    let bead = (bar * 0.2).min(deep * 0.3);
    let (x0, x1) = (face - bead, face - bead * 0.25);
    let gold = if wood == GOLD { BRASS } else { b.choose(&[GOLD, wood, SILVER_METAL]) };
    let list = [
        ([x0, -y, z0 - 1e-4], [x1, y, z0 + bead]),
        ([x0, -y, z1 - bead], [x1, y, z1 + 1e-4]),
        ([x0, -y - 1e-4, z0 + bead], [x1, -y + bead, z1 - bead]),
        ([x0, y - bead, z0 + bead], [x1, y + 1e-4, z1 - bead]),
    ];
    blocks(b, "bead", &list, gold);
}

/// A sheet with a picture: a photograph, a poster, a child's drawing.
pub(super) fn print(b: &mut Build<'_>) {
    facing(b, |b, t, w, h| {
        let framed_one = t > 0.012 && b.class != "drawing";
        if framed_one {
            return framed(b, [0.0; 3], t, w, h);
        }
        let plane = -t / 2.0 + t * 0.3;
        b.block("paper", [-t / 2.0, -w / 2.0, 0.0], [plane, w / 2.0, h], WHITE_PAPER);
        let border = b.choose(&[0.86, 0.94, 0.998]);
        let half = (w / 2.0 * border, h / 2.0 * border);
        let inks = match b.class {
            "picture" => Inks::photo(),
            _ => Inks::printed(b),
        };
        motif(b, Canvas { half, step: t * 0.23 }, [plane, 0.0, h / 2.0], inks);
    });
}

/// A woven hanging on a rod, with diamonds or stripes and a fringe.
pub(super) fn tapestry(b: &mut Build<'_>) {
    facing(b, |b, t, w, h| {
        let (cloth, ink) = (
            b.choose(&[WOOL, LINEN, RUST_FABRIC, NAVY_FABRIC, b.style.accent]),
            b.choose(&[RED_FABRIC, MUSTARD_FABRIC, TEAL_FABRIC, BROWN_FABRIC]),
        );
        let r = t * 0.45;
        let (low, high) = (h * 0.12, h - r);
        b.rod("rod", [0.0, -w / 2.0, high], [0.0, w / 2.0, high], r, b.style.wood);
        let plane = t * 0.1;
        let cloth_width = w * 0.94;
        let hang = |u: f32, v: f32| {
            let (py, pz) = (cloth_width * (u - 0.5), low + (high - low) * v);
            let wave = t * 0.4 * (u * 25.0).sine() * v * (1.0 - v);
            ([plane + wave, py, pz], [plane + wave - t * 0.3, py, pz])
        };
        sheet(b, "cloth", (24, 4), hang, cloth);
        let mut fringe: Vec<(P, P)> = Vec::new();
        for i in 0..30 {
            let y0 = cloth_width * (i as f32 / 30.0 - 0.5);
            fringe.push((
                [plane - t * 0.2, y0 + cloth_width * 0.004, 0.0],
                [plane - t * 0.1, y0 + cloth_width * 0.022, low * 1.1],
            ));
        }
        blocks(b, "fringe", &fringe, cloth);
        let rows = b.rng.count(2, 4);
        for i in 0..rows {
            let z = low + (high - low) * (i as f32 + 0.6) / (rows as f32 + 0.2);
            let tall = (high - low) / rows as f32 * 0.36;
            let count = b.rng.count(1, 5);
            for j in 0..count {
                let (wide, y0) =
                    (cloth_width / count as f32 * 0.45, cloth_width * ((j as f32 + 0.5) / count as f32 - 0.5));
                b.prism(
                    "motif",
                    Axis::X,
                    [plane - t * 0.06, y0, z],
                    &[(-wide, 0.0), (0.0, -tall), (wide, 0.0), (0.0, tall)],
                    t * 0.41,
                    ink,
                );
            }
        }
    });
}
