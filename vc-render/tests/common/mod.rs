//! Rooms to render, and an independent ray caster to compare with.
#![allow(dead_code, unreachable_pub, missing_docs, clippy::unwrap_used, reason = "each test file uses a part of this")]
#![allow(unreachable_patterns, reason = "inside of the crate, all modalities are known")]

pub mod caster;

use std::sync::Arc;

use nalgebra::{Point3, UnitQuaternion, Vector3};
use vc_graph::asset::{Joint, JointKind, Material, Part, Shape};
use vc_graph::{Asset, AssetId, AssetLibrary, Draft, NodeId, Pose, SceneBuilder, SceneGraph, Seed, State};
use vc_render::{BoxLabel, Camera, Frame, Mask, Modality};

/// A scene under construction.
pub struct Stage {
    pub library: AssetLibrary,
    pub builder: SceneBuilder,
    pub room: NodeId,
}

pub fn material(name: &str, colour: [f32; 3]) -> Material {
    Material::new(name, colour)
}

pub fn part(name: &str, shape: Shape, at: [f32; 3], material: u32) -> Part {
    Part { name: name.into(), shape, material, pose: Pose::translation(at[0], at[1], at[2]), joint: None }
}

pub fn block(half: [f32; 3]) -> Shape {
    Shape::Box { half: half.into() }
}

impl Stage {
    /// An empty scene with a room and the materials oak, paint, glass, glow and mirror, in this order.
    pub fn new() -> Self {
        let mut library = AssetLibrary::default();
        library.add_material(material("oak", [0.5, 0.3, 0.15])).unwrap();
        library.add_material(material("white_wall_paint", [0.8; 3])).unwrap();
        let glass = Material { transmission: 0.9, roughness: 0.02, ..material("clear_glass", [0.9; 3]) };
        library.add_material(glass).unwrap();
        library.add_material(Material { emission: [30.0; 3], ..material("warm_bulb", [0.9; 3]) }).unwrap();
        let mirror = Material { metallic: 1.0, roughness: 0.01, ..material("mirror", [0.9; 3]) };
        library.add_material(mirror).unwrap();
        let mut builder = SceneBuilder::new("test");
        let room = builder.add(Draft::new("living_room")).unwrap();
        Self { library, builder, room }
    }

    pub fn asset(&mut self, parts: Vec<Part>) -> AssetId {
        self.library.add(Asset { name: "made".into(), parts, ..Asset::default() }).unwrap()
    }

    pub fn put(&mut self, class: &str, asset: AssetId, pose: Pose) -> NodeId {
        let draft = Draft { asset: Some(asset), ..Draft::new(class).at(pose) };
        self.builder.add_in(self.room, draft).unwrap()
    }

    pub fn one(&mut self, class: &str, shape: Shape, pose: Pose, material: u32) -> NodeId {
        let asset = self.asset(vec![part(class, shape, [0.0; 3], material)]);
        self.put(class, asset, pose)
    }

    pub fn build(mut self) -> SceneGraph {
        self.builder.assets(Arc::new(self.library));
        self.builder.build()
    }
}

/// A pose from a position, a rotation about Z, and one about the turned Y axis.
pub fn pose(at: [f32; 3], yaw: f32, pitch: f32) -> Pose {
    let turn = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), yaw)
        * UnitQuaternion::from_axis_angle(&Vector3::y_axis(), pitch);
    Pose::from_parts(Vector3::from(at).into(), turn)
}

/// A room of 6 by 5 metres with a cabinet, whose drawer is open, and sixty shapes.
pub fn furnished() -> SceneGraph {
    crowded(60)
}

/// The same room with any number of shapes.
pub fn crowded(count: usize) -> SceneGraph {
    filled(Stage::new(), count)
}

/// The same room with sixty shapes and a lamp, which is off.
pub fn lamplit() -> SceneGraph {
    let mut stage = Stage::new();
    stage.one("ceiling_lamp", Shape::Sphere { radius: 0.12 }, Pose::translation(0.4, -0.3, 2.2), 3);
    filled(stage, 60)
}

fn filled(mut stage: Stage, count: usize) -> SceneGraph {
    let flat = |half: [f32; 3], at: [f32; 3]| part("slab", block(half), at, 1);
    let shell = vec![
        flat([3.0, 2.5, 0.1], [0.0, 0.0, -0.1]),
        flat([3.0, 2.5, 0.1], [0.0, 0.0, 2.7]),
        flat([0.1, 2.5, 1.3], [3.1, 0.0, 1.3]),
        flat([0.1, 2.5, 1.3], [-3.1, 0.0, 1.3]),
        flat([3.0, 0.1, 1.3], [0.0, 2.6, 1.3]),
        flat([3.0, 0.1, 1.3], [0.0, -2.6, 1.3]),
    ];
    for wall in shell {
        let asset = stage.asset(vec![wall]);
        stage.put("wall", asset, Pose::identity());
    }
    let slide = Joint { kind: JointKind::Slide, anchor: Point3::origin(), axis: Vector3::x(), limits: (0.0, 0.3) };
    let mut drawer = part("drawer", block([0.2, 0.35, 0.1]), [0.02, 0.0, 0.6], 0);
    drawer.joint = Some(slide);
    let cabinet = stage.asset(vec![
        part("body", block([0.2, 0.4, 0.25]), [0.0, 0.0, 0.25], 0),
        drawer,
        part("top", Shape::RoundedBox { half: Vector3::new(0.25, 0.45, 0.02), radius: 0.01 }, [0.0, 0.0, 0.75], 0),
    ]);
    let made = stage.put("dresser", cabinet, pose([2.0, 1.0, 0.0], 3.0, 0.0));
    let mut rng = Seed(5).stream();
    for index in 0..count {
        let size = rng.between(0.04, 0.25);
        let shape = match index % 7 {
            0 => Shape::Sphere { radius: size },
            1 => Shape::Cylinder { radius: size * 0.5, half_height: size },
            2 => Shape::Cone { radius: size, half_height: size },
            3 => Shape::Capsule { radius: size * 0.5, half_height: size },
            4 => {
                Shape::Lathe { profile: vec![(size, 0.0), (size, size), (size * 0.9, size), (size * 0.9, size * 0.1)] }
            }
            5 => Shape::RoundedBox { half: Vector3::new(size, size * 0.5, size), radius: size * 0.2 },
            _ => block([size, size * 0.3, size * 0.6]),
        };
        let at = [rng.between(-2.5, 2.5), rng.between(-2.0, 2.0), rng.between(0.2, 2.2)];
        let place = pose(at, rng.between(0.0, 6.0), rng.between(0.0, 3.0));
        stage.one(
            ["ball", "cup", "vase", "bottle", "bowl", "cushion", "book"][index % 7],
            shape,
            place,
            (index % 3) as u32,
        );
    }
    let mut graph = stage.build();
    let mut edit = graph.edit();
    edit.enter_state(made, State::Open).unwrap();
    edit.commit();
    graph
}

/// Cameras in that room.
pub fn cameras(width: u32, height: u32) -> Vec<Camera> {
    let views = [
        ([-2.6, -2.2, 1.6], [2.0, 1.0, 0.8]),
        ([2.7, -2.0, 2.3], [-1.0, 1.0, 0.4]),
        ([0.0, 0.0, 0.4], [1.0, 0.7, 0.9]),
        ([-2.9, 2.4, 0.1], [0.0, 0.0, 1.9]),
    ];
    let camera = Camera::with_fov(width, height, 1.1);
    views.iter().map(|(eye, target)| camera.looking(Point3::from(*eye), Point3::from(*target))).collect()
}

/// A frame's buffer of a modality as integers, which differ wherever it differs; empty if the frame does not
/// have the modality.
pub fn contents(frame: &Frame, of: Modality) -> Vec<u32> {
    match of {
        Modality::Rgb => frame.rgb.as_flattened().iter().map(|v| u32::from(*v)).collect(),
        Modality::Depth => bits(&frame.depth),
        Modality::Distance => bits(&frame.distance),
        Modality::Instance => frame.instance.iter().map(|n| n.0).collect(),
        Modality::Part => frame.part.iter().map(|v| u32::from(*v)).collect(),
        Modality::Class => frame.class.iter().map(|v| u32::from(*v)).collect(),
        Modality::Normal => bits(frame.normal.as_flattened()),
        Modality::Position => bits(frame.position.as_flattened()),
        Modality::FlowForward => bits(frame.flow_forward.as_flattened()),
        Modality::FlowBackward => bits(frame.flow_backward.as_flattened()),
        Modality::Occlusion => {
            frame.occluded_forward.iter().chain(&frame.occluded_backward).map(|v| u32::from(*v)).collect()
        }
        // The visible fraction belongs to amodal masks.
        Modality::Boxes => {
            let text = |b: &BoxLabel| {
                let mut label = b.clone();
                label.visible_fraction = None;
                format!("{label:?}").into_bytes()
            };
            frame.boxes.iter().flat_map(text).map(u32::from).collect()
        }
        Modality::Masks => frame.masks().flat_map(|mask| pixels(&mask)).collect(),
        Modality::Amodal => {
            let fractions = frame.boxes.iter().filter_map(|b| b.visible_fraction).map(f32::to_bits);
            fractions.chain(frame.amodal_masks().flat_map(|mask| pixels(&mask))).collect()
        }
        other => panic!("{other:?} is new: say here where it is"),
    }
}

fn bits(list: &[f32]) -> Vec<u32> {
    list.iter().map(|v| v.to_bits()).collect()
}

/// The node of a mask, and its pixels in the image.
fn pixels(mask: &Mask<'_>) -> Vec<u32> {
    std::iter::once(mask.node().0).chain(mask.bitmap().into_iter().map(u32::from)).collect()
}
