//! Racks for pots, bottles, papers, shoes, washing and plants.

use crate::material::*;
use crate::object::joinery::BOARD;
use crate::object::table::frame::Four;
use crate::object::table::trolley::castor;
use crate::solid::{Axis, Build, CORNERS, Cut, at_least, disc, leg};

/// A grid with hooks below that hangs from chains or is fixed to a wall.
pub(super) fn pot_rack(b: &mut Build<'_>) {
    at_least(b, [0.14, 0.3, 0.07]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let metal = b.choose(&[BLACK_METAL, STEEL, COPPER, BRASS]);
    let (hang, t) = (0.07_f32.min(h * 0.35), 0.008);
    let z = hang + t;
    for side in [-1.0_f32, 1.0] {
        let (cx, cy) = (side * (x - t), side * (y - t));
        b.rod("frame", [cx, t - y, z], [cx, y - t, z], t, metal);
        b.rod("frame", [t - x, cy, z], [x - t, cy, z], t, metal);
    }
    let bars = (x / 0.045).clamp(3.0, 9.0) as usize;
    let k = 0.97;
    for i in 0..bars {
        let cx = (x * k - 2.0 * t) * (2.0 * (i as f32 + 0.5) / bars as f32 - 1.0);
        b.rod("bar", [cx, -y + t, z], [cx, y - t, z], 0.004, metal);
    }
    let clear = h - z - 0.02;
    b.inside("rack", [0.0, 0.0, z + 0.004], (x * k * 0.7, y * 0.7), clear.max(0.05));
    // Chains from the corners to the ceiling, or a plate at the wall.
    for (sx, sy) in CORNERS {
        let at = [sx * (x * k - t), sy * (y - t), z];
        b.rod("chain", at, [sx * x * 0.45, sy * y * 0.9, h - 0.004], 0.0035, metal);
    }
    for sy in [-1.0, 1.0] {
        b.bar("beam", [-x * 0.5, sy * y * 0.9, h - 0.006], [x * 0.5, sy * y * 0.9, h - 0.006], 0.006, metal);
    }
    let count = ((2.0 * y) / 0.11).clamp(4.0, 10.0) as usize;
    for i in 0..count {
        let cy = (y - 0.05) * (2.0 * (i as f32 + 0.5) / count as f32 - 1.0);
        let cx = if i % 2 == 0 { x - t } else { t - x };
        b.pipe(
            "hook",
            &[[cx, cy, z], [cx, cy, 0.018], [cx, cy + 0.012, 0.004], [cx, cy + 0.022, 0.014]],
            0.0035,
            metal,
        );
        b.hook(&format!("hook_{}", i + 1), [cx, cy + 0.012, 0.008], 0.35);
    }
}

/// A rack in which bottles lie with their necks to the front: a lattice, pigeonholes or scalloped
/// rails.
pub(super) fn wine_rack(b: &mut Build<'_>) {
    at_least(b, [0.11, 0.15, 0.15]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let wood = b.choose(&[b.style.wood, b.style.wood, PINE, BLACK_METAL]);
    let (t, cell) = (0.012, 0.105);
    let across = ((2.0 * y - t) / cell).clamp(1.0, 12.0) as usize;
    let up = ((h - t) / cell).clamp(1.0, 18.0) as usize;
    let (dy, dz) = ((2.0 * y - t) / across as f32, (h - t) / up as f32);
    if b.rng.chance(0.5) || across * up > 40 {
        // Pigeonholes of thin board.
        for i in 0..=across {
            let y0 = -y + dy * i as f32;
            b.block("upright", [-x, y0, 0.0], [x, y0 + t, h], wood);
        }
        for k in 0..=up {
            let z0 = dz * k as f32;
            b.block("board", [0.001 - x, t * 0.5 - y, z0 + 0.001], [x - 0.001, y - t * 0.5, z0 + t - 0.001], wood);
        }
    } else {
        // Rods from front to back between four posts, two below every bottle.
        for (sx, sy) in CORNERS {
            let (cx, cy) = (sx * (x - t), sy * (y - t));
            b.block("post", [cx - t, cy - t, 0.0], [cx + t, cy + t, h], wood);
        }
        for k in 0..=up {
            let z0 = dz * k as f32;
            for cx in [-x + t, x - t] {
                b.block("rail", [cx - t * 0.8, -y + t, z0 + 0.001], [cx + t * 0.8, y - t, z0 + t - 0.001], wood);
            }
            for side in [-1.0, 1.0] {
                let cy = side * (y - t);
                b.block("rail", [-x + t, cy - t * 0.8, z0 + 0.002], [x - t, cy + t * 0.8, z0 + t - 0.002], wood);
            }
        }
        for (i, k) in (0..across).flat_map(|i| (0..up).map(move |k| (i, k))) {
            let (cy, z) = (-y + t / 2.0 + dy * (i as f32 + 0.5), dz * k as f32 + t);
            for cy in [cy - dy * 0.2, cy + dy * 0.2] {
                b.block("slat", [t - x, cy - 0.005, z - 0.01], [x - t, cy + 0.005, z], wood);
            }
        }
    }
    for (i, k) in (0..across).flat_map(|i| (0..up).map(move |k| (i, k))) {
        let centre = [0.0, -y + t / 2.0 + dy * (i as f32 + 0.5), dz * k as f32 + t];
        let name = format!("rack_{}", i * up + k + 1);
        b.inside(&name, centre, (x - 2.0 * t - 0.006, dy / 2.0 - t * 1.6), dz - t * 1.5 - 0.004);
    }
}

/// A magazine rack: a trough of boards, of wire, or of leather in a frame.
pub(super) fn magazine_rack(b: &mut Build<'_>) {
    at_least(b, [0.1, 0.15, 0.15]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (wood, cloth) = (b.style.wood, b.choose(&[b.style.accent, TAN_LEATHER, BLACK_LEATHER, b.style.wood]));
    let t = 0.012;
    let low = h * 0.14;
    for side in [-1.0_f32, 1.0] {
        let y0 = (side * y).min(side * (y - t));
        let outline = [
            (-x * 0.6, 0.0),
            (x * 0.6, 0.0),
            (x, h * 0.8),
            (x * 0.9, h * 0.86),
            (0.02, h * 0.5),
            (-0.02, h * 0.5),
            (-x * 0.9, h * 0.86),
            (-x, h * 0.8),
        ];
        b.prism("end", Axis::Y, [0.0, y0, 0.0], &outline, t, wood);
        let wall = [
            (side * x * 0.62, low),
            (side * (x * 0.98), h * 0.78),
            (side * (x * 0.98 - 0.01), h * 0.78),
            (side * (x * 0.62 - 0.01), low),
        ];
        b.prism("wall", Axis::Y, [0.0, t - y, 0.0], &wall, 2.0 * (y - t), cloth);
    }
    b.block("bottom", [-x * 0.6, t - y, low - 0.008], [x * 0.6, y - t, low + 0.002], wood);
    b.block("middle", [-0.005, t - y + 0.001, low], [0.005, y - t - 0.001, h * 0.9], wood);
    b.block("handle", [-0.009, t - y, h * 0.9], [0.009, y - t, h], wood);
    for (i, side) in [-1.0, 1.0].into_iter().enumerate() {
        let centre = [side * (x * 0.3 + 0.001), 0.0, low + 0.002];
        b.inside(&format!("pocket_{}", i + 1), centre, (x * 0.3 - 0.013, y - t - 0.006), h * 0.8);
    }
}

/// Low shelves of slats or tubes for shoes.
pub(super) fn shoe_rack(b: &mut Build<'_>) {
    at_least(b, [0.13, 0.28, 0.18]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let tubes = b.rng.chance(0.4);
    let frame = if tubes {
        b.choose(&[CHROME, BLACK_METAL, WHITE_METAL])
    } else {
        b.choose(&[b.style.wood, BAMBOO, b.style.cabinet])
    };
    let levels = ((h / 0.2).round() as usize).clamp(2, 4);
    let (first, last) = (0.09, h - if tubes { 0.06 } else { 0.004 });
    let pitch = (last - first) / (levels - 1) as f32;
    let r = if tubes { 0.01 } else { 0.013 };
    if !tubes && b.rng.chance(0.5) {
        for side in [-1.0_f32, 1.0] {
            let (a, c) = (side * y, side * (y - BOARD));
            b.block("side", [-x, a.min(c), 0.0], [x, a.max(c), h - 0.001], frame);
        }
    } else {
        let cut = if tubes { Cut::Round } else { Cut::Square };
        Four::upright((x, y), h - 0.002, (r, r), cut).build(b, frame);
        for side in [-1.0, 1.0] {
            let cy = side * (y - r);
            b.rod("rail", [r - x, cy, h - r - 0.002], [x - r, cy, h - r - 0.002], r * 0.9, frame);
        }
    }
    let inner = y - 2.0 * r - 0.006;
    for i in 0..levels {
        let z = first + pitch * i as f32;
        let count = if tubes { 4 } else { b.rng.count(3, 5) };
        let step = 2.0 * (x - 0.004) / count as f32;
        for k in 0..count {
            let x0 = 0.004 - x + step * k as f32;
            if tubes {
                let cx = x0 + step / 2.0;
                b.rod("tube", [cx, r - y, z - 0.006], [cx, y - r, z - 0.006], 0.006, frame);
            } else {
                b.block("slat", [x0, r - y, z - 0.014], [x0 + step * 0.8, y - r, z], frame);
            }
        }
        for side in [-1.0, 1.0] {
            let cy = side * (y - r);
            b.block("bearer", [0.006 - x, cy - r * 0.8, z - 0.03], [x - 0.006, cy + r * 0.8, z - 0.008], frame);
        }
        let (centre, free) = ([0.0, 0.0, z], (x - 0.008, inner - 0.006));
        if i + 1 == levels {
            let free = if tubes { (free.0 - 0.01, free.1) } else { free };
            b.top("top", centre, free);
        } else {
            b.ledge(&format!("shelf_{}", i + 1), centre, free, (pitch - 0.04).max(0.01));
        }
    }
}

/// An airer: a flat grid of rods on crossed legs, with wings.
pub(super) fn drying_rack(b: &mut Build<'_>) {
    at_least(b, [0.25, 0.5, 0.4]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let metal = b.choose(&[WHITE_METAL, SILVER_METAL, STEEL]);
    let (r, top) = (0.009, h - 0.01);
    let wing = y * 0.42;
    let body = y - wing;
    for side in [-1.0, 1.0] {
        let (cx, lx) = (side * (x - r), side * (x - 2.9 * r));
        b.rod("rail", [cx, -body, top], [cx, body, top], r, metal);
        leg(b, "leg", ([cx, -body, 0.0], r), ([cx, body * 0.75, top], r), Cut::Round, metal);
        leg(b, "leg", ([lx, body, 0.0], r), ([lx, -body * 0.75, top], r), Cut::Round, metal);
        b.hinge([0.0, side * body, top], [-side, 0.0, 0.0], 1.2, |b| {
            for wx in [-1.0, 1.0] {
                let x0 = wx * (x - 3.0 * r);
                b.rod("wing", [x0, side * body, top], [x0, side * (y - r), top], r * 0.8, metal);
            }
            for i in 1..=3 {
                let cy = side * (body + (wing - r) * i as f32 / 3.0);
                b.rod("wire", [3.0 * r - x, cy, top], [x - 3.0 * r, cy, top], 0.003, metal);
            }
        });
        let cy = side * body;
        b.rod("foot", [r - x, cy, r], [x - r, cy, r], r, metal);
    }
    let count = (body / 0.05).clamp(4.0, 12.0) as usize;
    for i in 0..=count {
        let cy = body * (2.0 * i as f32 / count as f32 - 1.0);
        b.rod("wire", [r - x, cy, top], [x - r, cy, top], 0.003, metal);
        if i % 2 == 0 {
            b.hook(&format!("rod_{}", i / 2 + 1), [0.0, cy, top], h * 0.5);
        }
    }
    b.inside("grid", [0.0, 0.0, top + 0.004], (x - 3.0 * r, body - 0.02), 0.4);
}

/// A rail on a frame, with a shelf for shoes near the floor.
pub(super) fn clothes_rail(b: &mut Build<'_>) {
    at_least(b, [0.2, 0.4, 0.6]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let wooden = b.rng.chance(0.4);
    let (mat, r) =
        if wooden { (b.style.wood, 0.016) } else { (b.choose(&[BLACK_METAL, CHROME, WHITE_METAL, BRASS]), 0.012) };
    let (wheels, z) = (!wooden && b.rng.chance(0.5), h - if wooden { 0.05 } else { 0.014 });
    let lift = if wheels { 0.065 } else { 0.0 };
    // Wooden poles cross below the rod, which lies between them.
    let lean = (x + 0.7 * r) * h / (z - 0.03);
    for side in [-1.0, 1.0] {
        let cy = side * (y - r - 0.02);
        if wooden {
            for sx in [-1.0, 1.0] {
                let shift = sx * r * 1.02;
                let head = [sx * (x - r - lean), cy + shift, h];
                leg(b, "pole", ([sx * (x - r), cy + shift, 0.0], r), (head, r), Cut::Round, mat);
            }
        } else {
            b.bar("foot", [r - x, cy, lift + r], [x - r, cy, lift + r], r, mat);
            b.rod("post", [0.0, cy, lift + r], [0.0, cy, z], r, mat);
            for sx in [-1.0, 1.0].into_iter().filter(|_| wheels) {
                castor(b, [sx * (x - 0.03), cy, lift + 0.004], 0.028);
            }
        }
    }
    let end = y - if wooden { 0.0 } else { 0.004 };
    b.rod(
        "rod",
        [0.0, -end, z - if wooden { 0.03 } else { 0.0 }],
        [0.0, end, z - if wooden { 0.03 } else { 0.0 }],
        r,
        mat,
    );
    let rail = z - if wooden { 0.03 } else { 0.0 } - r;
    let shelf = lift + 0.14_f32.min(h * 0.15);
    let half = (if wooden { x - r - lean * shelf / h } else { x * 0.6 }, y - r - 0.02);
    b.block(
        "shelf",
        [-half.0, -half.1, shelf - 0.014],
        [half.0, half.1, shelf],
        if wooden { mat } else { b.style.wood },
    );
    if !wooden {
        b.rod("brace", [0.0, -half.1, shelf - 0.02], [0.0, half.1, shelf - 0.02], r * 0.8, mat);
    }
    b.inside("shelf", [0.0, 0.0, shelf], (half.0 - 0.01, half.1 - 0.05), (rail - shelf) * 0.3);
    let count = ((2.0 * half.1 - 0.1) / 0.1).clamp(2.0, 14.0) as usize;
    for i in 0..count {
        let cy = (half.1 - 0.07) * (2.0 * (i as f32 + 0.5) / count as f32 - 1.0);
        b.hook(&format!("rod_{}", i + 1), [0.0, cy, rail], (rail - shelf) * 0.68);
    }
}

/// A stand for flower pots: a pedestal, a stool of wire, or steps.
pub(super) fn plant_stand(b: &mut Build<'_>) {
    at_least(b, [0.12, 0.12, 0.2]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (wood, metal) = (b.style.wood, b.choose(&[b.style.metal, BLACK_METAL, BRASS]));
    let t = 0.018;
    if y > x * 1.12 || x > y * 1.12 || b.rng.chance(0.2) {
        // Steps between two side frames.
        let steps = if h > 0.7 { 3 } else { 2 };
        let deep = 2.0 * x / steps as f32;
        for side in [-1.0, 1.0] {
            let cy = side * (y - 0.012);
            leg(b, "rail", ([x - 0.014, cy, 0.0], 0.012), ([0.014 - x, cy, h - t], 0.012), Cut::Square, wood);
            leg(b, "post", ([0.014 - x, cy, 0.0], 0.012), ([0.014 - x, cy, h - t], 0.012), Cut::Square, wood);
        }
        for i in 0..steps {
            let z = h * (i as f32 + 1.0) / steps as f32;
            let x1 = x - deep * i as f32;
            b.block("shelf", [-x, -y, z - t], [x1, y, z], wood);
            let from = if i + 1 == steps { -x } else { x1 - deep };
            let name = format!("shelf_{}", i + 1);
            let inset = if i + 1 == steps { 0.0 } else { 0.02 };
            b.top(&name, [f32::midpoint(from + inset, x1), 0.0, z], ((x1 - from - inset) / 2.0 - 0.006, y - 0.03));
        }
        return;
    }
    let r = x.min(y);
    let (mat, leg_mat) = if b.rng.chance(0.5) { (wood, wood) } else { (b.choose(&[wood, metal]), metal) };
    let leg_r = if leg_mat == wood { 0.013 } else { 0.006 };
    let splay = b.vary(0.7, 0.95);
    disc(b, "top", [0.0, 0.0, h], r * 0.96, t, mat);
    b.top("top", [0.0, 0.0, h], (r * 0.64, r * 0.64));
    for (dx, dy) in [(1.0, 0.0), (-0.5, 0.866), (-0.5, -0.866), (0.0, 0.0)].into_iter().take(3) {
        let (foot, head) =
            ([dx * (r - leg_r), dy * (r - leg_r), 0.0], [dx * r * splay * 0.85, dy * r * splay * 0.85, h - t + 0.002]);
        leg(b, "leg", (foot, leg_r * 0.8), (head, leg_r), Cut::Round, leg_mat);
    }
    if h > 0.55 {
        let z = h * 0.35;
        disc(b, "shelf", [0.0, 0.0, z], r * 0.88, 0.012, mat);
        b.ledge("shelf", [0.0, 0.0, z], (r * 0.45, r * 0.45), h - t - z - 0.01);
    }
}
