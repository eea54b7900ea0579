//! Scenes for tests, built by hand.

#![allow(dead_code, clippy::unwrap_used, reason = "each test uses some of it, and tests may unwrap")]

use std::sync::Arc;

use nalgebra::{Isometry3, Point3, UnitQuaternion, Vector3};
use vc_graph::asset::{Hold, Joint, JointKind, Material, Part, Shape, Surface};
use vc_graph::{
    Asset, AssetId, AssetLibrary, Bounds, BoundsFrame, Draft, NodeId, Pose, SceneBuilder, SceneGraph, State,
};
use vc_physics::{PhysicsWorld, Settings, ShapeCache};

/// A scene in the making.
pub(crate) struct Scene {
    pub(crate) builder: SceneBuilder,
    pub(crate) library: AssetLibrary,
    pub(crate) wood: u32,
}

pub(crate) fn material(name: &str, density: f32, friction: f32, restitution: f32) -> Material {
    Material { density, friction, restitution, ..Material::new(name, [0.5; 3]) }
}

pub(crate) fn at(x: f32, y: f32, z: f32) -> Pose {
    Pose::translation(x, y, z)
}

pub(crate) fn turned(x: f32, y: f32, z: f32, axis: Vector3<f32>, angle: f32) -> Pose {
    Isometry3::from_parts(
        Vector3::new(x, y, z).into(),
        UnitQuaternion::from_axis_angle(&nalgebra::Unit::new_normalize(axis), angle),
    )
}

pub(crate) fn part(name: &str, shape: Shape, pose: Pose, material: u32) -> Part {
    Part { name: name.into(), shape, material, pose, joint: None }
}

pub(crate) fn block(half: [f32; 3]) -> Shape {
    Shape::Box { half: half.into() }
}

pub(crate) fn surface(name: &str, hold: Hold, centre: [f32; 3], half: (f32, f32), clearance: Option<f32>) -> Surface {
    Surface { name: name.into(), hold, centre: centre.into(), half, clearance, joint: None }
}

impl Default for Scene {
    fn default() -> Self {
        let mut library = AssetLibrary::default();
        let wood = library.add_material(material("wood", 600.0, 0.5, 0.0)).unwrap();
        Self { builder: SceneBuilder::new("test"), library, wood }
    }
}

impl Scene {
    pub(crate) fn asset(&mut self, asset: Asset) -> AssetId {
        self.library.add(asset).unwrap()
    }

    pub(crate) fn solid(&mut self, name: &str, shape: Shape, material: u32) -> AssetId {
        self.asset(Asset {
            name: name.into(),
            parts: vec![part(name, shape, at(0.0, 0.0, 0.0), material)],
            ..Asset::default()
        })
    }

    pub(crate) fn add(&mut self, class: &str, asset: AssetId, pose: Pose) -> NodeId {
        self.builder.add(Draft { asset: Some(asset), ..Draft::new(class).at(pose) }).unwrap()
    }

    /// A floor whose top is at zero.
    pub(crate) fn floor(&mut self, half: f32, friction: f32) -> NodeId {
        let stone = self.library.add_material(material("stone", 2000.0, friction, 0.0)).unwrap();
        let asset = self.solid("floor", block([half, half, 0.1]), stone);
        self.add("floor", asset, at(0.0, 0.0, -0.1))
    }

    pub(crate) fn wall(&mut self, low: [f32; 3], high: [f32; 3]) -> NodeId {
        let half = [0, 1, 2].map(|i| (high[i] - low[i]) / 2.0);
        let asset = self.solid("wall", block(half), self.wood);
        self.add("wall", asset, at((low[0] + high[0]) / 2.0, (low[1] + high[1]) / 2.0, (low[2] + high[2]) / 2.0))
    }

    pub(crate) fn room(&mut self, low: [f32; 2], high: [f32; 2]) -> NodeId {
        let size = Vector3::new(high[0] - low[0], high[1] - low[1], 2.6);
        let bounds = Bounds { frame: BoundsFrame::World, ..Bounds::standing(size) };
        let pose = at((low[0] + high[0]) / 2.0, (low[1] + high[1]) / 2.0, 0.0);
        self.builder.add(Draft::new("kitchen").at(pose).bounds(bounds)).unwrap()
    }

    /// A table of five boards with one surface on top, standing on its origin.
    pub(crate) fn table_asset(&mut self) -> AssetId {
        let w = self.wood;
        let mut parts = vec![part("top", block([0.4, 0.7, 0.02]), at(0.0, 0.0, 0.72), w)];
        for (x, y) in [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)] {
            parts.push(part("leg", block([0.03, 0.03, 0.35]), at(0.37 * x, 0.67 * y, 0.35), w));
        }
        let surfaces = vec![surface("top", Hold::On, [0.0, 0.0, 0.74], (0.4, 0.7), None)];
        self.asset(Asset { name: "table".into(), parts, surfaces, ..Asset::default() })
    }

    pub(crate) fn table(&mut self, pose: Pose) -> NodeId {
        let asset = self.table_asset();
        self.add("kitchen_table", asset, pose)
    }

    /// A door leaf of 0.8 by 2 m that turns around Z at its edge. It stands on its origin, which is the middle
    /// of the doorway; the leaf lies along Y.
    pub(crate) fn door_asset(&mut self) -> AssetId {
        let w = self.wood;
        let joint = Joint {
            kind: JointKind::Hinge,
            anchor: Point3::new(0.0, 0.4, 0.0),
            axis: Vector3::z(),
            limits: (0.0, 1.6),
        };
        let mut leaf = part("leaf", block([0.02, 0.4, 1.0]), at(0.0, 0.0, 1.0), w);
        leaf.joint = Some(joint);
        let frame = part("frame", block([0.05, 0.4, 0.02]), at(0.0, 0.0, 2.05), w);
        self.asset(Asset { name: "door".into(), parts: vec![frame, leaf], ..Asset::default() })
    }

    /// A chest with one drawer that slides out 0.3 m along X.
    pub(crate) fn chest_asset(&mut self) -> AssetId {
        let w = self.wood;
        let slide = Joint { kind: JointKind::Slide, anchor: Point3::origin(), axis: Vector3::x(), limits: (0.0, 0.3) };
        let moving = |mut p: Part| {
            p.joint = Some(slide);
            p
        };
        let board = |name: &str, half: [f32; 3], x: f32, y: f32, z: f32| part(name, block(half), at(x, y, z), w);
        let parts = vec![
            board("left", [0.25, 0.01, 0.25], 0.0, 0.29, 0.25),
            board("right", [0.25, 0.01, 0.25], 0.0, -0.29, 0.25),
            board("back", [0.01, 0.28, 0.25], -0.24, 0.0, 0.25),
            board("top", [0.25, 0.3, 0.01], 0.0, 0.0, 0.51),
            board("bottom", [0.25, 0.28, 0.01], 0.0, 0.0, 0.01),
            moving(board("drawer", [0.22, 0.26, 0.01], 0.01, 0.0, 0.2)),
            moving(board("drawer front", [0.01, 0.26, 0.12], 0.24, 0.0, 0.3)),
            moving(board("drawer back", [0.01, 0.26, 0.08], -0.2, 0.0, 0.29)),
            moving(board("drawer side", [0.21, 0.01, 0.08], 0.01, 0.25, 0.29)),
            moving(board("drawer side", [0.21, 0.01, 0.08], 0.01, -0.25, 0.29)),
        ];
        let mut inside = surface("drawer", Hold::Inside, [0.01, 0.0, 0.21], (0.18, 0.22), Some(0.25));
        inside.joint = Some(slide);
        let surfaces = vec![surface("top", Hold::On, [0.0, 0.0, 0.52], (0.25, 0.3), None), inside];
        self.asset(Asset { name: "chest".into(), parts, surfaces, ..Asset::default() })
    }

    pub(crate) fn ball(&mut self, radius: f32, pose: Pose) -> NodeId {
        let asset = self.solid("ball", Shape::Sphere { radius }, self.wood);
        self.add("ball", asset, pose)
    }

    pub(crate) fn cube(&mut self, half: f32, pose: Pose) -> NodeId {
        let asset = self.solid("cube", block([half; 3]), self.wood);
        self.add("toy", asset, pose)
    }

    pub(crate) fn agent(&mut self, pose: Pose) -> NodeId {
        self.builder.add(Draft::new("character").at(pose)).unwrap()
    }

    pub(crate) fn graph(mut self) -> SceneGraph {
        self.builder.assets(Arc::new(self.library));
        self.builder.build()
    }

    pub(crate) fn world(self) -> PhysicsWorld {
        self.world_with(plain())
    }

    pub(crate) fn world_with(self, settings: Settings) -> PhysicsWorld {
        PhysicsWorld::build(&self.graph(), &ShapeCache::new(), settings).unwrap()
    }
}

/// Settings with the masses as modelled.
pub(crate) fn plain() -> Settings {
    Settings { class_masses: false, ..Settings::default() }
}

/// Opens a node in the graph.
pub(crate) fn open(graph: &mut SceneGraph, id: NodeId) {
    let mut edit = graph.edit();
    edit.enter_state(id, State::Open).unwrap();
    edit.commit();
}
