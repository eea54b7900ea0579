//! Rooms of 25 objects each, for readers who do not have the scenes with which the peers' figures were
//! measured.

use super::{File, Geometry, Hinge, Object, Piece};

/// Distance between adjacent rooms, metres.
const PITCH: f32 = 3.4;
/// Objects per room.
const EACH: u32 = 25;

/// A file of `objects` objects, in rooms side by side; objects beyond a whole number of rooms are omitted.
pub(super) fn rooms(objects: u32) -> File {
    let count = objects / EACH;
    let columns = (1..).find(|c| c * c >= count).unwrap_or(1);
    let rows = count.div_ceil(columns);
    let mut file = File { objs: Vec::new(), walls: Vec::new(), floor: floor(columns, rows) };
    for room in 0..count {
        let place = |index: u32, of: u32| (index as f32 - (of - 1) as f32 / 2.0) * PITCH;
        furnish(&mut file, [place(room % columns, columns), place(room / columns, rows)]);
    }
    file
}

fn floor(columns: u32, rows: u32) -> ([f32; 3], [f32; 3]) {
    ([0.0, 0.0, -0.1], [columns as f32 * PITCH / 2.0 + 0.5, rows as f32 * PITCH / 2.0 + 0.5, 0.1])
}

/// A box with its centre at `pos`.
fn slab(pos: [f32; 3], half: [f32; 3]) -> Piece {
    Piece { pos, geo: Geometry::Box(half) }
}

/// Four legs at the corners of a rectangle.
fn legs(x: f32, y: f32, thick: f32, half: f32) -> impl Iterator<Item = Piece> {
    let corners = [(x, y), (-x, y), (x, -y), (-x, -y)];
    corners.into_iter().map(move |(x, y)| slab([x, y, half], [thick, thick, half]))
}

/// The four walls of a box without lid, standing on its bottom.
fn sides(x: f32, y: f32, thick: f32, bottom: f32, half: f32) -> impl Iterator<Item = Piece> {
    let (z, inner) = (bottom + half, y - 2.0 * thick);
    let ends = [x - thick, thick - x].map(|at| slab([at, 0.0, z], [thick, y, half]));
    let long = [inner + thick, -inner - thick].map(|at| slab([0.0, at, z], [x - 2.0 * thick, thick, half]));
    ends.into_iter().chain(long)
}

fn furnish(file: &mut File, [x, y]: [f32; 2]) {
    file.walls.push(([x - PITCH / 2.0, y, 1.25], [0.06, PITCH / 2.0 - 0.6, 1.25]));
    file.walls.push(([x, y + PITCH / 2.0, 1.25], [PITCH / 2.0 - 0.6, 0.06, 1.25]));
    let mut add = |class: &str, at: [f32; 3], yaw: f32, density: f32, parts: Vec<Piece>| {
        let id = file.objs.len() as u32;
        let pos = [x + at[0], y + at[1], at[2]];
        file.objs.push(Object { id, class: class.into(), pos, yaw, density, parts, hinge: None });
        id
    };
    let single = |geo: Geometry| vec![Piece { pos: [0.0; 3], geo }];
    let brick = |half: [f32; 3]| single(Geometry::Box(half));
    // Gaps of a millimetre or two, since the peers treat overlaps differently.
    add("rug", [0.0, 0.0, 0.006], 0.0, 250.0, brick([0.9, 0.8, 0.005]));
    let top = slab([0.0, 0.0, 0.73], [0.6, 0.45, 0.02]);
    add("table", [0.0, 0.0, 0.013], 0.0, 600.0, legs(0.56, 0.41, 0.03, 0.355).chain([top]).collect());
    for (side, yaw) in [(-1.0, 0.0), (1.0, std::f32::consts::PI)] {
        let seat = [slab([0.0, 0.0, 0.45], [0.21, 0.21, 0.02]), slab([-0.19, 0.0, 0.7], [0.02, 0.21, 0.23])];
        add("chair", [side * 1.2, 0.0, 0.002], yaw, 600.0, legs(0.18, 0.18, 0.02, 0.215).chain(seat).collect());
    }
    let mut boards = vec![slab([-0.41, 0.0, 0.8], [0.02, 0.14, 0.8]), slab([0.41, 0.0, 0.8], [0.02, 0.14, 0.8])];
    boards.push(slab([0.0, 0.13, 0.8], [0.39, 0.01, 0.8]));
    boards.extend([0.02, 0.55, 1.05, 1.58].map(|z| slab([0.0, -0.01, z], [0.39, 0.13, 0.02])));
    add("shelf", [-0.7, 1.35, 0.002], 0.0, 600.0, boards);
    for i in 0..4 {
        add("book", [-0.95 + 0.06 * i as f32, 1.34, 0.693], 0.0, 550.0, brick([0.02, 0.1, 0.12]));
    }
    for i in 0..4 {
        add("book", [-0.65, 1.34, 1.094 + 0.042 * i as f32], 0.0, 550.0, brick([0.12, 0.1, 0.02]));
    }
    for at in [-0.4, 0.1] {
        add("cup", [at, -0.25, 0.816], 0.0, 800.0, single(Geometry::Cyl { r: 0.04, h: 0.05 }));
    }
    for i in 0..3 {
        add("plate", [0.4, -0.2, 0.776 + 0.022 * i as f32], 0.0, 800.0, single(Geometry::Cyl { r: 0.12, h: 0.01 }));
    }
    let bottom = slab([0.0, 0.0, 0.007], [0.11, 0.11, 0.007]);
    let bowl = sides(0.11, 0.11, 0.006, 0.014, 0.035).chain([bottom]).collect();
    add("bowl", [-0.1, 0.2, 0.766], 0.0, 800.0, bowl);
    add("apple", [-0.1, 0.2, 0.822], 0.0, 700.0, single(Geometry::Ball(0.04)));
    let mut carcass = vec![slab([0.0, 0.28, 0.85], [0.3, 0.03, 0.85])];
    carcass.extend([-0.27, 0.27].map(|x| slab([x, -0.03, 0.85], [0.03, 0.28, 0.85])));
    carcass.extend([0.03, 0.9, 1.67].map(|z| slab([0.0, -0.03, z], [0.24, 0.27, 0.02])));
    let fridge = add("fridge", [0.9, 1.3, 0.002], 0.0, 200.0, carcass);
    add("milk", [0.9, 1.25, 1.024], 0.0, 1000.0, brick([0.04, 0.04, 0.1]));
    let bottom = slab([0.0, 0.0, 0.01], [0.2, 0.15, 0.01]);
    let basket = sides(0.2, 0.15, 0.01, 0.02, 0.12).chain([bottom]).collect();
    add("basket", [-1.2, -1.2, 0.002], 0.4, 400.0, basket);
    add("toy", [-1.2, -1.2, 0.064], 0.4, 400.0, brick([0.05, 0.04, 0.04]));
    // The fridge's door, on the left of its front.
    let door = add("door", [0.9, 0.96, 0.852], 0.0, 200.0, brick([0.29, 0.015, 0.82]));
    let hinge = Hinge { parent: fridge, anchor: [-0.3, -0.34, 0.85], anchor_child: [-0.3, 0.0, 0.0], lim: (-2.0, 0.0) };
    if let Some(leaf) = file.objs.get_mut(door as usize) {
        leaf.hinge = Some(hinge);
    }
}
