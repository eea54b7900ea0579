//! The home for timing rendering: 10 by 8 by 2.7 metres, three rooms, three hundred objects or any other
//! number, each with its own mesh, and sixteen views at eye height.

use std::sync::Arc;

use nalgebra::{Point3, Vector3};
use vc_graph::asset::{Material, Part, Shape};
use vc_graph::{Asset, AssetLibrary, Draft, NodeId, Pose, SceneBuilder, SceneGraph, Seed};
use vc_render::Camera;

/// The home and its lamps.
pub(crate) struct Home {
    pub(crate) graph: SceneGraph,
    pub(crate) lamps: Vec<NodeId>,
}

const NAMES: [(&str, [f32; 3], f32, f32); 10] = [
    ("white_wall_paint", [0.80, 0.78, 0.74], 0.7, 0.0),
    ("oak", [0.45, 0.30, 0.16], 0.4, 0.0),
    ("grey_fabric", [0.30, 0.32, 0.36], 0.9, 0.0),
    ("red_lacquer", [0.55, 0.08, 0.06], 0.2, 0.0),
    ("brushed_steel", [0.60, 0.60, 0.62], 0.3, 1.0),
    ("white_tile", [0.75, 0.78, 0.80], 0.3, 0.0),
    ("green_plastic", [0.12, 0.40, 0.18], 0.4, 0.0),
    ("card", [0.55, 0.45, 0.32], 0.8, 0.0),
    ("marble", [0.75, 0.74, 0.72], 0.25, 0.0),
    ("blue_linen", [0.14, 0.22, 0.45], 0.9, 0.0),
];
const GLASS: u32 = NAMES.len() as u32;
const BULB: u32 = GLASS + 1;

/// Windows in the walls along X: the wall's y, and the range of x.
const WINDOWS: [(f32, f32, f32); 3] = [(4.0, -3.6, -1.4), (4.0, 1.6, 3.4), (-4.0, 1.6, 3.4)];

struct Site {
    library: AssetLibrary,
    builder: SceneBuilder,
    rooms: [NodeId; 3],
    /// Number of cells along an edge of a mesh.
    fine: i32,
    count: usize,
}

fn material((name, colour, roughness, metallic): (&str, [f32; 3], f32, f32)) -> Material {
    Material { roughness, metallic, ..Material::new(name, colour) }
}

/// A cube with `fine` by `fine` cells on each side, each of its vertices mapped by `place`.
fn lattice(fine: i32, place: impl Fn(Vector3<f32>) -> Vector3<f32>) -> Shape {
    let (mut vertices, mut triangles) = (Vec::new(), Vec::new());
    for side in 0..6_usize {
        let first = vertices.len() as u32;
        for (i, j) in (0..=fine).flat_map(|i| (0..=fine).map(move |j| (i, j))) {
            let mut at = Vector3::zeros();
            let sign = if side < 3 { 1 } else { -1 };
            at[side % 3] = sign as f32;
            at[(side + 1) % 3] = (2 * i - fine) as f32 / fine as f32;
            at[(side + 2) % 3] = (sign * (2 * j - fine)) as f32 / fine as f32;
            vertices.push(Point3::from(place(at)));
        }
        let row = fine as u32 + 1;
        for (i, j) in (0..row - 1).flat_map(|i| (0..row - 1).map(move |j| (i, j))) {
            let at = first + i * row + j;
            triangles.extend([[at, at + row, at + row + 1], [at, at + row + 1, at + 1]]);
        }
    }
    Shape::Mesh { vertices, triangles, uvs: Vec::new() }
}

impl Site {
    fn put(&mut self, class: &str, shape: Shape, at: Pose, material: u32) -> NodeId {
        let part = Part { name: class.into(), shape, material, pose: Pose::identity(), joint: None };
        let asset = self.library.add(Asset { name: class.into(), parts: vec![part], ..Asset::default() }).unwrap();
        let p = at.translation.vector;
        let room = if p.x < 0.0 { 0 } else { 1 + usize::from(p.y < 0.0) };
        self.count += 1;
        self.builder.add_in(self.rooms[room], Draft { asset: Some(asset), ..Draft::new(class).at(at) }).unwrap()
    }

    /// A block between two corners.
    fn block(&mut self, class: &str, (low, high): ([f32; 3], [f32; 3]), material: u32) -> NodeId {
        let (low, high) = (Vector3::from(low), Vector3::from(high));
        let half = (high - low) * 0.5;
        let shape = lattice(self.fine, |p| p.component_mul(&half));
        self.put(class, shape, Pose::from((low + high) * 0.5), material)
    }

    /// A rounded shape with given half lengths, standing on a point.
    fn round(&mut self, class: &str, on: [f32; 3], half: [f32; 3], material: u32) -> NodeId {
        let half = Vector3::from(half);
        let shape = lattice(self.fine, |p| (p.normalize() * 0.75 + p * 0.25).component_mul(&half));
        self.put(class, shape, Pose::translation(on[0], on[1], on[2] + half.z), material)
    }

    /// A wall along X with its windows.
    fn wall(&mut self, y: f32) {
        let thick = [y.min(y + 0.2 * y.signum()), y.max(y + 0.2 * y.signum())];
        let mut from = -5.0;
        for (_, start, end) in WINDOWS.into_iter().filter(|w| w.0 == y) {
            self.block("wall", ([from, thick[0], 0.0], [start, thick[1], 2.7]), 0);
            self.block("wall", ([start, thick[0], 0.0], [end, thick[1], 0.9]), 0);
            self.block("wall", ([start, thick[0], 2.3], [end, thick[1], 2.7]), 0);
            self.block("window", ([start, y + 0.08 * y.signum(), 0.9], [end, y + 0.1 * y.signum(), 2.3]), GLASS);
            from = end;
        }
        self.block("wall", ([from, thick[0], 0.0], [5.0, thick[1], 2.7]), 0);
    }

    fn shell(&mut self) {
        for (x, end, floor) in [(-5.0, 0.0, 1), (0.0, 5.0, 5)] {
            let middles: &[(f32, f32)] = if x < 0.0 { &[(-4.0, 4.0)] } else { &[(-4.0, 0.0), (0.0, 4.0)] };
            for &(y, far) in middles {
                self.block("floor", ([x, y, -0.2], [end, far, 0.0]), floor);
                self.block("ceiling", ([x, y, 2.7], [end, far, 2.9]), 0);
            }
        }
        [-4.0, 4.0].into_iter().for_each(|y| self.wall(y));
        self.block("wall", ([-5.2, -4.2, 0.0], [-5.0, 4.2, 2.7]), 0);
        self.block("wall", ([5.0, -4.2, 0.0], [5.2, 4.2, 2.7]), 0);
        // Inner walls, each with a passage.
        for (from, to) in [(-4.0, -2.2), (-1.3, 1.3), (2.2, 4.0)] {
            self.block("wall", ([-0.05, from, 0.0], [0.05, to, 2.7]), 0);
        }
        self.block("wall", ([0.05, -0.05, 0.0], [3.4, 0.05, 2.7]), 0);
        self.block("wall", ([4.3, -0.05, 0.0], [5.0, 0.05, 2.7]), 0);
    }
}

/// The home with `objects` objects, each a mesh of 12 `fine` squared triangles: with 300 objects, 6 or 7 give
/// 150,000 triangles and 17 a million.
pub(crate) fn home(fine: i32, objects: usize) -> Home {
    let mut library = AssetLibrary::default();
    for known in NAMES {
        library.add_material(material(known)).unwrap();
    }
    let glass = Material { transmission: 0.9, ..material(("clear_glass", [0.95; 3], 0.02, 0.0)) };
    library.add_material(glass).unwrap();
    library.add_material(Material { emission: [30.0, 27.0, 22.0], ..material(("bulb", [0.9; 3], 0.5, 0.0)) }).unwrap();
    let mut builder = SceneBuilder::new("bench");
    let rooms = ["living_room", "kitchen", "bedroom"].map(|r| builder.add(Draft::new(r)).unwrap());
    let mut site = Site { library, builder, rooms, fine, count: 0 };
    site.shell();
    let lamps = [[-2.5, 0.0], [2.5, 2.0], [2.5, -2.0]]
        .map(|[x, y]| site.round("ceiling_lamp", [x, y, 2.45], [0.16, 0.16, 0.08], BULB))
        .to_vec();
    let mut rng = Seed(7).stream();
    let mut piece = 0;
    while site.count < objects {
        // A piece of furniture along the walls or free-standing in a room, with things on it.
        let at = [rng.between(-4.5, 4.5), rng.between(-3.6, 3.6)];
        if at[0].abs() < 0.6 || (at[0] > 0.0 && at[1].abs() < 0.6) {
            continue;
        }
        let (half, high) = ([rng.between(0.2, 0.6), rng.between(0.2, 0.45)], rng.between(0.35, 1.1));
        let (low, top) = ([at[0] - half[0], at[1] - half[1], 0.0], [at[0] + half[0], at[1] + half[1], high]);
        let classes = ["table", "sofa", "cabinet", "bed", "dresser", "desk", "bench", "chest"];
        site.block(classes[piece % classes.len()], (low, top), 1 + (piece % 8) as u32);
        piece += 1;
        for thing in 0..rng.below(9) {
            let on = [at[0] + rng.between(-0.8, 0.8) * half[0], at[1] + rng.between(-0.8, 0.8) * half[1], high];
            let size = [rng.between(0.03, 0.1), rng.between(0.03, 0.1), rng.between(0.02, 0.15)];
            let class = format!("thing_{}", (thing + piece) % 38);
            let material = 1 + rng.below(9) as u32;
            if thing % 3 == 0 {
                let ends =
                    ([0, 1, 2].map(|i| on[i] - if i < 2 { size[i] } else { 0.0 }), [0, 1, 2].map(|i| on[i] + size[i]));
                site.block(&class, ends, material);
            } else {
                site.round(&class, on, size, material);
            }
        }
    }
    site.builder.assets(Arc::new(site.library));
    Home { graph: site.builder.build(), lamps }
}

/// The triangles of a home in the world as an OBJ file for other renderers, with an object for each node;
/// comments give its cameras (eye, target, vertical degrees), its lamps and the direction to the sun.
#[allow(dead_code, reason = "one bench writes it")]
pub(crate) fn obj(home: &Home, towards_sun: Vector3<f32>) -> String {
    use std::fmt::Write;
    let (mut text, mut first) = (String::new(), 1);
    for (eye, target) in eyes() {
        let _ = writeln!(text, "# camera {} {} {} {} {} {} 60", eye.x, eye.y, eye.z, target.x, target.y, target.z);
    }
    let _ = writeln!(text, "# sun {} {} {}", towards_sun.x, towards_sun.y, towards_sun.z);
    for pose in home.lamps.iter().filter_map(|lamp| home.graph.node(*lamp)?.pose()) {
        let at = pose.translation;
        let _ = writeln!(text, "# lamp {} {} {}", at.x, at.y, at.z);
    }
    for node in home.graph.nodes() {
        let (Some(pose), Some(asset)) = (node.pose(), node.spec().asset) else { continue };
        let Some(Shape::Mesh { vertices, triangles, .. }) = home.graph.assets().get(asset).map(|a| &a.parts[0].shape)
        else {
            continue;
        };
        let _ = writeln!(text, "o {}", node.id().0);
        for at in vertices.iter().map(|v| pose * v) {
            let _ = writeln!(text, "v {} {} {}", at.x, at.y, at.z);
        }
        for [a, b, c] in triangles {
            let _ = writeln!(text, "f {} {} {}", a + first, b + first, c + first);
        }
        first += vertices.len() as u32;
    }
    text
}

/// Sixteen views with a vertical field of view of 60 degrees.
pub(crate) fn cameras(width: u32, height: u32) -> Vec<Camera> {
    let camera = Camera::with_fov(width, height, 60_f32.to_radians());
    eyes().map(|(eye, target)| camera.looking(eye, target)).collect()
}

/// Eye and target points of the views.
fn eyes() -> impl Iterator<Item = (Point3<f32>, Point3<f32>)> {
    let eyes = [[-4.3, -3.3], [-4.3, 3.3], [-0.7, 3.0], [-0.7, -3.0], [0.8, 3.4], [4.4, 0.8], [4.4, -3.4], [0.8, -0.8]];
    eyes.into_iter().flat_map(|[x, y]| {
        let middle = if x < 0.0 { [-2.5, 0.0] } else { [2.5, 2.0_f32.copysign(y)] };
        let aside = [middle[0] + 0.6 * (y - middle[1]), middle[1] - 0.6 * (x - middle[0])];
        [middle, aside].map(|[a, b]| (Point3::new(x, y, 1.6), Point3::new(a, b, 0.9)))
    })
}
