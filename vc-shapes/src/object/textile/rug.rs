//! Rugs and mats.

use crate::material::*;
use crate::solid::{Axis, Build, MeshBuilder, P, blocks, half_dims, ngon};

/// A rug: bordered, striped, with a medallion, checked, or round.
pub(super) fn rug(b: &mut Build<'_>) {
    let (x, y, _) = half_dims(b);
    let ground = if b.rng.chance(0.6) {
        b.style.rug
    } else {
        b.choose(&[WOOL, JUTE, RED_FABRIC, NAVY_FABRIC, TEAL_FABRIC, CHARCOAL_FABRIC])
    };
    let inks = [WOOL, BEIGE_FABRIC, MUSTARD_FABRIC, RUST_FABRIC, NAVY_FABRIC, GREY_FABRIC, ROSE_FABRIC, OLIVE_FABRIC];
    let (first, second) = (b.choose(&inks), b.choose(&inks));
    if x.min(y) / x.max(y) > 0.72 && b.rng.chance(0.6) {
        return round(b, [ground, first, second]);
    }
    let (fx, fy) = fringes(b, WOOL);
    let pile = Pile::new(b, (fx, fy), ground);
    match b.rng.below(4) {
        0 => {
            pile.frame(b, 0.9, 0.82, first);
            pile.frame(b, 0.76, 0.73, second);
        }
        1 => pile.stripes(b, first, second),
        2 => {
            pile.frame(b, 0.92, 0.8, first);
            pile.medallions(b, second, first);
        }
        _ => pile.checks(b, first),
    }
    pile.carry(b);
}

/// Adds fringes at both short ends; returns the remaining half extents.
fn fringes(b: &mut Build<'_>, mat: MaterialId) -> (f32, f32) {
    let (x, y, h) = half_dims(b);
    if b.rng.chance(0.45) {
        return (x, y);
    }
    let long = (x.max(y) * 0.05).min(0.06);
    let (wide, reach) = (x.min(y), x.max(y));
    let count = (wide * 40.0).clamp(8.0, 40.0) as usize;
    let pitch = 2.0 * wide * 0.98 / count as f32;
    let mut list = Vec::new();
    for (i, side) in (0..count).flat_map(|i| [(i, -1.0_f32), (i, 1.0)]) {
        let across = -wide * 0.98 + pitch * (i as f32 + 0.2);
        let (near, far) = (side * reach, side * (reach - long * 1.1));
        let (near, far) = (near.min(far), near.max(far));
        let strand = |a: P, c: P| (a, c);
        list.push(if y >= x {
            strand([across, near, 0.0], [across + pitch * 0.6, far, h * 0.3])
        } else {
            strand([near, across, 0.0], [far, across + pitch * 0.6, h * 0.3])
        });
    }
    blocks(b, "fringe", &list, mat);
    if y >= x { (x, y - long) } else { (x - long, y) }
}

/// The pile of a rug or mat: half extents, and heights of the ground and of the pattern.
struct Pile {
    x: f32,
    y: f32,
    ground: f32,
    top: f32,
}

impl Pile {
    fn new(b: &mut Build<'_>, (x, y): (f32, f32), mat: MaterialId) -> Self {
        let top = b.size.z;
        let ground = top - (top * 0.3).min(0.0012);
        b.rounded_block("pile", [-x, -y, 0.0], [x, y, ground], ground * 0.4, mat);
        Self { x, y, ground, top }
    }

    fn tile(&self, low: (f32, f32), high: (f32, f32)) -> (P, P) {
        ([low.0, low.1, self.ground * 0.5], [high.0, high.1, self.top])
    }

    /// A frame whose outer edge is at a fraction of the narrower half width.
    fn frame(&self, b: &mut Build<'_>, outer: f32, inner: f32, mat: MaterialId) {
        let narrow = self.x.min(self.y);
        let (o, i) = (narrow * (1.0 - outer), narrow * (1.0 - inner));
        let (x0, y0, x1, y1) = (self.x - o, self.y - o, self.x - i, self.y - i);
        let list = [
            self.tile((-x0, -y0), (x0, -y1)),
            self.tile((-x0, y1), (x0, y0)),
            self.tile((-x0, -y1 * 0.999), (-x1, y1 * 0.999)),
            self.tile((x1, -y1 * 0.999), (x0, y1 * 0.999)),
        ];
        blocks(b, "border", &list, mat);
    }

    /// Bands across the longer side.
    fn stripes(&self, b: &mut Build<'_>, first: MaterialId, second: MaterialId) {
        let count = b.rng.count(4, 9);
        let along_y = self.y >= self.x;
        let long = self.x.max(self.y);
        let pitch = 2.0 * long * 0.94 / count as f32;
        for (turn, mat) in [(0, first), (1, second)] {
            let share = b.vary(0.25, 0.6);
            let list: Vec<(P, P)> = (0..count)
                .filter(|i| i % 2 == turn)
                .map(|i| {
                    let a = -long * 0.94 + pitch * (i as f32 + 0.5 - share / 2.0);
                    let c = a + pitch * share;
                    if along_y {
                        self.tile((-self.x * 0.97, a), (self.x * 0.97, c))
                    } else {
                        self.tile((a, -self.y * 0.97), (c, self.y * 0.97))
                    }
                })
                .collect();
            blocks(b, "stripe", &list, mat);
        }
    }

    /// Diamonds in a row with smaller diamonds inside.
    fn medallions(&self, b: &mut Build<'_>, outer: MaterialId, inner: MaterialId) {
        let count = b.rng.count(1, 3);
        let (x, y) = (self.x * 0.66, self.y * 0.66);
        let long_y = self.y >= self.x;
        let (rx, ry) = if long_y { (x, y / count as f32) } else { (x / count as f32, y) };
        let corners = b.choose(&[4, 8, 12]);
        for i in 0..count {
            let step = 2.0 * i as f32 + 1.0 - count as f32;
            let at = if long_y { [0.0, step * ry] } else { [step * rx, 0.0] };
            let low = self.ground * 0.5;
            b.prism(
                "medallion",
                Axis::Z,
                [at[0], at[1], low],
                &ngon((rx * 0.95, ry * 0.95), corners),
                self.ground + (self.top - self.ground) * 0.5 - low,
                outer,
            );
            b.prism(
                "medallion",
                Axis::Z,
                [at[0], at[1], low * 0.8],
                &ngon((rx * 0.5, ry * 0.5), corners),
                self.top - low * 0.8,
                inner,
            );
        }
    }

    /// A field of squares.
    fn checks(&self, b: &mut Build<'_>, mat: MaterialId) {
        let pitch = self.x.min(self.y) / b.vary(2.0, 4.0);
        let (nx, ny) = ((1.8 * self.x / pitch) as usize, (1.8 * self.y / pitch) as usize);
        let (nx, ny) = (nx.clamp(1, 9), ny.clamp(1, 9));
        let (px, py) = (1.8 * self.x / nx as f32, 1.8 * self.y / ny as f32);
        let list: Vec<(P, P)> = (0..nx * ny)
            .map(|k| (k % nx, k / nx))
            .filter(|(i, j)| (i + j) % 2 == 0)
            .map(|(i, j)| {
                let (a, c) = (-0.9 * self.x + px * i as f32, -0.9 * self.y + py * j as f32);
                self.tile((a, c), (a + px * 0.97, c + py * 0.97))
            })
            .collect();
        blocks(b, "check", &list, mat);
    }

    fn carry(&self, b: &mut Build<'_>) {
        b.top("top", [0.0, 0.0, self.top], (self.x * 0.98, self.y * 0.98));
    }
}

/// A round or oval rug of rings.
fn round(b: &mut Build<'_>, mats: [MaterialId; 3]) {
    let (x, y, h) = half_dims(b);
    let rings = b.rng.count(2, 4);
    for i in 0..rings {
        let share = 1.0 - i as f32 / rings as f32;
        let top = h * (0.8 + 0.2 * (i + 1) as f32 / rings as f32);
        b.prism(
            "ring",
            Axis::Z,
            [0.0, 0.0, 0.08 * h * i as f32],
            &ngon((x * share, y * share), 40),
            top - 0.08 * h * i as f32,
            mats[i % 3],
        );
    }
    b.top("top", [0.0, 0.0, h], (x * 0.68, y * 0.68));
}

/// A mat: of coir for the door, of terry cloth or pebbles for the bath, or woven.
pub(super) fn mat(b: &mut Build<'_>) {
    let (x, y, _) = half_dims(b);
    let ground = match b.class {
        "doormat" => b.choose(&[JUTE, CHARCOAL_FABRIC, BROWN_FABRIC, JUTE]),
        "bath_mat" => b.choose(&[b.style.towel, b.style.towel, TOWEL_WHITE, GREY_FABRIC]),
        _ => b.choose(&[b.style.rug, JUTE, GREY_FABRIC, BLUE_FABRIC]),
    };
    let ink = if b.class == "bath_mat" {
        ground
    } else {
        b.choose(&[BLACK_FABRIC, BROWN_FABRIC, RED_FABRIC, NAVY_FABRIC, WOOL])
    };
    let pile = Pile::new(b, (x, y), ground);
    match b.rng.below(4) {
        0 => pile.frame(b, 0.88, 0.76, ink),
        1 => pile.ribs(b, ink),
        2 if b.class == "doormat" => {
            pile.frame(b, 0.94, 0.88, ink);
            pile.letters(b, ink);
        }
        2 => pile.checks(b, ink),
        _ => pile.pebbles(b, ink),
    }
    pile.carry(b);
}

impl Pile {
    /// Narrow ribs from side to side.
    fn ribs(&self, b: &mut Build<'_>, mat: MaterialId) {
        let count = b.rng.count(6, 14);
        let pitch = 1.84 * self.x / count as f32;
        let list: Vec<(P, P)> = (0..count)
            .map(|i| {
                let a = -0.92 * self.x + pitch * i as f32;
                self.tile((a, -self.y * 0.92), (a + pitch * 0.55, self.y * 0.92))
            })
            .collect();
        blocks(b, "rib", &list, mat);
    }

    /// A word of greeting, readable from the front.
    fn letters(&self, b: &mut Build<'_>, mat: MaterialId) {
        let hello = [["#.#", "###", "#.#"], ["###", "##.", "###"], ["#..", "#..", "###"], ["#..", "#..", "###"]];
        let letters: Vec<_> = hello.into_iter().chain([["###", "#.#", "###"]]).collect();
        let cell = (self.y * 1.3 / (letters.len() * 4) as f32).min(self.x * 0.3);
        let mut list = Vec::new();
        for (n, letter) in letters.iter().enumerate() {
            for (row, line) in letter.iter().enumerate() {
                for (column, _) in line.bytes().enumerate().filter(|(_, c)| *c == b'#') {
                    let px = (row as f32 - 1.5) * cell * 1.3;
                    let py = (n as f32 * 4.0 + column as f32 - letters.len() as f32 * 2.0 + 0.5) * cell;
                    list.push(self.tile((px, py), (px + cell * 1.28, py + cell * 0.98)));
                }
            }
        }
        blocks(b, "letter", &list, mat);
    }

    /// Round knobs over the whole mat.
    fn pebbles(&self, b: &mut Build<'_>, mat: MaterialId) {
        let mut shell = MeshBuilder::default();
        let (nx, ny) = (5, 8);
        let (px, py) = (1.8 * self.x / nx as f32, 1.8 * self.y / ny as f32);
        for (i, j) in (0..nx).flat_map(|i| (0..ny).map(move |j| (i, j))) {
            let at = [-0.9 * self.x + px * (i as f32 + 0.5), -0.9 * self.y + py * (j as f32 + 0.5)];
            let size = b.vary(0.34, 0.45);
            let ring = |z: f32, s: f32| {
                let half = (px * size * s, py * size * s);
                crate::solid::oval(Axis::Z, [at[0], at[1], z], half, 0, 10)
            };
            shell.loft(&[ring(self.ground * 0.5, 1.0), ring(self.top, 0.8)]);
        }
        shell.put(b, "pebble", mat);
    }
}
