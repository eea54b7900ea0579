//! A small kitchen with shapes, for the examples in the documentation of the crates.

use std::sync::Arc;

use nalgebra::{Point3, Vector3};
use vc_graph::asset::{Hold, Joint, JointKind, Material, Part, Shape, Surface};
use vc_graph::{
    Anthropometry, Asset, AssetLibrary, Bounds, BoundsFrame, Draft, NodeId, Pose, SceneBuilder, SceneGraph,
};

/// A kitchen of 4 by 4 m around the origin with a few things and a person; X is the front of each thing.
#[derive(Debug, Clone)]
pub struct Kitchen {
    /// The scene.
    pub graph: SceneGraph,
    /// The room.
    pub room: NodeId,
    /// The floor, whose top is at height zero.
    pub floor: NodeId,
    /// A table with its top at 0.74 m, at (1, 0).
    pub table: NodeId,
    /// A cup on the middle of the table.
    pub cup: NodeId,
    /// A cabinet with one drawer that slides out 0.3 m, at (-1.5, 0).
    pub cabinet: NodeId,
    /// A chair with its seat at 0.45 m, at (0, 1.5).
    pub chair: NodeId,
    /// A person that stands at (0, 0) and looks along X, at the table.
    pub person: NodeId,
}

/// The kitchen.
pub fn kitchen() -> Kitchen {
    let mut library = AssetLibrary::default();
    let wood = library.add_material(material()).unwrap();
    let mut shapes = |asset: Asset| library.add(asset).unwrap();
    let (floor, table, cup) = (shapes(floor(wood)), shapes(table(wood)), shapes(cup(wood)));
    let (cabinet, chair) = (shapes(cabinet(wood)), shapes(chair(wood)));
    let mut scene = SceneBuilder::new("kitchen");
    let size = Bounds { frame: BoundsFrame::World, ..Bounds::standing(Vector3::new(4.0, 4.0, 2.6)) };
    let room = scene.add(Draft::new("kitchen").at(Pose::identity()).bounds(size)).unwrap();
    let mut put = |class: &str, asset, x: f32, y: f32, z: f32| {
        let draft = Draft { asset: Some(asset), ..Draft::new(class).at(Pose::translation(x, y, z)) };
        scene.add_in(room, draft).unwrap()
    };
    let floor = put("floor", floor, 0.0, 0.0, 0.0);
    let table = put("kitchen_table", table, 1.0, 0.0, 0.0);
    let cup = put("cup", cup, 1.0, 0.0, 0.741);
    let cabinet = put("kitchen_cabinet", cabinet, -1.5, 0.0, 0.0);
    let chair = put("kitchen_chair", chair, 0.0, 1.5, 0.0);
    let Anthropometry { depth, breadth, stature, .. } = Anthropometry::ADULT;
    let body = Bounds::standing(Vector3::new(depth, breadth, stature));
    let body = Draft::new("character").at(Pose::identity()).bounds(body);
    let person = scene.add_in(room, body).unwrap();
    scene.assets(Arc::new(library));
    Kitchen { graph: scene.build(), room, floor, table, cup, cabinet, chair, person }
}

fn material() -> Material {
    Material {
        name: "wood".into(),
        colour: [0.6, 0.4, 0.2],
        density: 600.0,
        friction: 0.5,
        restitution: 0.0,
        roughness: 0.6,
        metallic: 0.0,
        transmission: 0.0,
        emission: [0.0; 3],
        texture: None,
    }
}

/// A board by its name, its half lengths and its middle, metres.
fn board(material: u32, name: &str, half: [f32; 3], [x, y, z]: [f32; 3]) -> Part {
    let shape = Shape::Box { half: half.into() };
    Part { name: name.into(), shape, material, pose: Pose::translation(x, y, z), joint: None }
}

fn surface(name: &str, hold: Hold, height: f32, half: (f32, f32)) -> Surface {
    let centre = Point3::new(0.0, 0.0, height);
    Surface { name: name.into(), hold, centre, half, clearance: None, joint: None }
}

fn floor(wood: u32) -> Asset {
    Asset {
        name: "floor".into(),
        parts: vec![board(wood, "boards", [2.0, 2.0, 0.1], [0.0, 0.0, -0.1])],
        ..Asset::default()
    }
}

fn table(wood: u32) -> Asset {
    let mut parts = vec![board(wood, "top", [0.4, 0.7, 0.02], [0.0, 0.0, 0.72])];
    for (x, y) in [(0.37, 0.67), (0.37, -0.67), (-0.37, 0.67), (-0.37, -0.67)] {
        parts.push(board(wood, "leg", [0.03, 0.03, 0.35], [x, y, 0.35]));
    }
    let surfaces = vec![surface("top", Hold::On, 0.74, (0.4, 0.7))];
    Asset { name: "table".into(), parts, surfaces, ..Asset::default() }
}

fn cup(wood: u32) -> Asset {
    let mut side = board(wood, "side", [0.0; 3], [0.0, 0.0, 0.05]);
    side.shape = Shape::Cylinder { radius: 0.04, half_height: 0.05 };
    Asset { name: "cup".into(), parts: vec![side], ..Asset::default() }
}

fn chair(wood: u32) -> Asset {
    let seat = board(wood, "seat", [0.22, 0.22, 0.225], [0.0, 0.0, 0.225]);
    let back = board(wood, "back", [0.02, 0.22, 0.2], [-0.2, 0.0, 0.65]);
    let surfaces = vec![surface("seat", Hold::On, 0.45, (0.22, 0.22))];
    Asset { name: "chair".into(), parts: vec![seat, back], surfaces, ..Asset::default() }
}

fn cabinet(wood: u32) -> Asset {
    let slide = Joint { kind: JointKind::Slide, anchor: Point3::origin(), axis: Vector3::x(), limits: (0.0, 0.3) };
    let drawer = |part: Part| Part { joint: Some(slide), ..part };
    let parts = vec![
        board(wood, "left", [0.25, 0.01, 0.25], [0.0, 0.29, 0.25]),
        board(wood, "right", [0.25, 0.01, 0.25], [0.0, -0.29, 0.25]),
        board(wood, "back", [0.01, 0.28, 0.25], [-0.24, 0.0, 0.25]),
        board(wood, "top", [0.25, 0.3, 0.01], [0.0, 0.0, 0.51]),
        board(wood, "bottom", [0.25, 0.28, 0.01], [0.0, 0.0, 0.01]),
        drawer(board(wood, "drawer", [0.22, 0.26, 0.01], [0.01, 0.0, 0.2])),
        drawer(board(wood, "drawer front", [0.01, 0.26, 0.12], [0.24, 0.0, 0.3])),
        drawer(board(wood, "drawer back", [0.01, 0.26, 0.08], [-0.2, 0.0, 0.29])),
        drawer(board(wood, "drawer left", [0.21, 0.01, 0.08], [0.01, 0.25, 0.29])),
        drawer(board(wood, "drawer right", [0.21, 0.01, 0.08], [0.01, -0.25, 0.29])),
    ];
    let inside =
        Surface { clearance: Some(0.25), joint: Some(slide), ..surface("drawer", Hold::Inside, 0.21, (0.18, 0.22)) };
    let surfaces = vec![surface("top", Hold::On, 0.52, (0.25, 0.3)), inside];
    Asset { name: "cabinet".into(), parts, surfaces, ..Asset::default() }
}
