//! Hats and caps, lying on their brims.

use crate::material::*;
use crate::solid::{Axis, Build, MeshBuilder, P, half_dims, hoop, loft, oval};

/// A hat: with a brim and a pinched crown, a straw hat, a bowler, or a bobble hat.
pub(super) fn hat(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let cloth = b.choose(&[BROWN_FABRIC, BLACK_FABRIC, GREY_FABRIC, BEIGE_FABRIC, NAVY_FABRIC, JUTE, OLIVE_FABRIC]);
    let trim = b.choose(&[BLACK_FABRIC, BROWN_LEATHER, RED_FABRIC, WHITE_COTTON]);
    let small = x.min(y) < 0.115;
    if small || b.rng.chance(0.25) {
        return bobble(b);
    }
    let crown = b.vary(0.58, 0.68);
    let ring = |z: f32, s: f32| oval(Axis::Z, [0.0, 0.0, z * h], (x * s, y * s), 0, 24);
    let curl = b.vary(0.1, 0.3);
    let brim = vec![
        ring(0.02, crown),
        ring(curl * 0.5, 0.92),
        ring(curl, 1.0),
        ring(curl + 0.03, 0.99),
        ring(curl * 0.5 + 0.06, 0.9),
        ring(0.07, crown),
    ];
    let mut shell = MeshBuilder::default();
    shell.torus(&brim);
    shell.put(b, "brim", cloth);
    let pinched = b.rng.chance(0.6);
    let top = |z: f32, s: f32| -> Vec<P> {
        let pinch = |p: P| if pinched && p[0] > 0.0 { [p[0] * 0.92, p[1] * 0.82, p[2]] } else { p };
        ring(z, s).into_iter().map(pinch).collect()
    };
    let mut rings = vec![
        ring(0.0, crown),
        ring(0.1, crown),
        ring(0.5, crown * 0.95),
        top(0.88, crown * 0.84),
        top(0.98, crown * 0.7),
    ];
    rings.push(if pinched { top(0.84, crown * 0.3) } else { top(1.0, crown * 0.3) });
    loft(b, "crown", &rings, cloth);
    loft(b, "band", &[ring(0.1, crown * 1.012), ring(0.3, crown * 0.99)], trim);
}

/// A knitted hat with a turned-up edge and a bobble.
fn bobble(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let (cloth, trim) = b.choose(&[
        (RED_FABRIC, WHITE_COTTON),
        (NAVY_FABRIC, MUSTARD_FABRIC),
        (GREY_FABRIC, GREY_FABRIC),
        (TEAL_FABRIC, WOOL),
        (MUSTARD_FABRIC, CHARCOAL_FABRIC),
    ]);
    let knob = h * 0.14;
    let ring = |z: f32, s: f32| oval(Axis::Z, [0.0, 0.0, z * h], (x * s, y * s), 0, 20);
    loft(b, "hat", &[ring(0.03, 0.9), ring(0.3, 0.94), ring(0.55, 0.82), ring(0.72, 0.55), ring(0.8, 0.2)], cloth);
    let edge = vec![ring(0.0, 0.9), ring(0.04, 1.0), ring(0.26, 1.0), ring(0.3, 0.92)];
    loft(b, "edge", &edge, trim);
    b.ball("bobble", [0.0, 0.0, h - knob], knob, trim);
}

/// A cap with panels, a peak in front and a button on top.
pub(super) fn cap(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let (cloth, trim) = (
        b.choose(&[RED_FABRIC, NAVY_FABRIC, BLACK_FABRIC, GREEN_FABRIC, BEIGE_FABRIC, DENIM]),
        b.choose(&[WHITE_COTTON, BLACK_FABRIC, RED_FABRIC, NAVY_FABRIC]),
    );
    let long = x * 0.7;
    let at = -x + long;
    let ring = |z: f32, s: f32| oval(Axis::Z, [at, 0.0, z * h], (long * s, y * s), 0, 20);
    loft(
        b,
        "crown",
        &[ring(0.0, 0.96), ring(0.3, 1.0), ring(0.6, 0.9), ring(0.82, 0.66), ring(0.94, 0.35), ring(0.975, 0.05)],
        cloth,
    );
    let mut knob = MeshBuilder::default();
    knob.egg([at, 0.0, h * 0.97], [y * 0.07, y * 0.07, h * 0.03]);
    knob.put(b, "button", trim);
    let mut peak = MeshBuilder::default();
    peak.sheet((6, 10), |u, v| {
        let side = 2.0 * v - 1.0;
        let reach = (1.0 - side * side * 0.9).max(0.0).sqrt();
        let from = at + long * 0.94 * (1.0 - side * side * 0.6).max(0.0).sqrt() * 0.9;
        let px = from + (x - from) * u * reach;
        let z = h * (0.1 + 0.1 * (1.0 - side * side) - 0.06 * u);
        ([px, y * 0.9 * side, z + h * 0.025], [px, y * 0.9 * side, z])
    });
    peak.put(b, "peak", trim);
    let line: Vec<P> = oval(Axis::Z, [at, 0.0, h * 0.03], (long * 0.955, y * 0.955), 0, 20);
    hoop(b, "edge", &line, h * 0.02, cloth);
}
