//! A corner of a kitchen, built from parts.

use std::sync::Arc;

use nalgebra::{UnitQuaternion, Vector3};
use vc_graph::asset::{AssetError, Material, Part, Shape};
use vc_graph::{Asset, AssetLibrary, Draft, EditError, Pose, SceneBuilder, SceneGraph};

type P = [f32; 3];

struct Corner {
    scene: SceneBuilder,
    library: AssetLibrary,
}

fn part(shape: Shape, at: P) -> Part {
    let pose = Pose::from_parts(Vector3::from(at).into(), UnitQuaternion::identity());
    Part { name: "part".into(), shape, material: 0, pose, joint: None }
}

/// A box between two corners.
fn block(low: P, high: P) -> Part {
    let (low, high) = (Vector3::from(low), Vector3::from(high));
    part(Shape::Box { half: (high - low) / 2.0 }, ((low + high) / 2.0).into())
}

fn lathe(profile: &[(f32, f32)]) -> Vec<Part> {
    vec![part(Shape::Lathe { profile: profile.to_vec() }, [0.0; 3])]
}

fn upright(x: f32, y: f32, h: f32) -> Vec<Part> {
    vec![block([-x / 2.0, -y / 2.0, 0.0], [x / 2.0, y / 2.0, h])]
}

fn table(x: f32, y: f32, h: f32) -> Vec<Part> {
    let leg = |sx: f32, sy: f32| {
        let (cx, cy) = (sx * (x / 2.0 - 0.05), sy * (y / 2.0 - 0.05));
        block([cx - 0.025, cy - 0.025, 0.0], [cx + 0.025, cy + 0.025, h - 0.03])
    };
    let top = block([-x / 2.0, -y / 2.0, h - 0.03], [x / 2.0, y / 2.0, h]);
    vec![top, leg(-1.0, -1.0), leg(-1.0, 1.0), leg(1.0, -1.0), leg(1.0, 1.0)]
}

fn shelf(x: f32, y: f32, h: f32, boards: usize) -> Vec<Part> {
    let (x, y) = (x / 2.0, y / 2.0);
    let mut parts = vec![
        block([-x, -y, 0.0], [-x + 0.01, y, h]),
        block([-x, -y, 0.0], [x, -y + 0.02, h]),
        block([-x, y - 0.02, 0.0], [x, y, h]),
    ];
    for i in 0..boards {
        let z = (h - 0.02) * i as f32 / (boards - 1) as f32;
        parts.push(block([-x, -y + 0.02, z], [x, y - 0.02, z + 0.02]));
    }
    parts
}

impl Corner {
    fn put(&mut self, class: &str, parts: Vec<Part>, at: P, yaw: f32) -> Result<(), String> {
        let asset = Asset { name: class.into(), parts, ..Asset::default() };
        let asset = self.library.add(asset).map_err(|e: AssetError| e.to_string())?;
        let turn = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), yaw.to_radians());
        let mut draft = Draft::new(class).at(Pose::from_parts(Vector3::from(at).into(), turn));
        draft.asset = Some(asset);
        self.scene.add(draft).map(drop).map_err(|e: EditError| e.to_string())
    }
}

/// The scene: it has only shapes and poses and no relations.
pub(crate) fn build() -> Result<SceneGraph, String> {
    let mut corner = Corner { scene: SceneBuilder::new("kitchen corner"), library: AssetLibrary::default() };
    let wood = Material { density: 600.0, roughness: 0.6, ..Material::new("wood", [0.5, 0.4, 0.3]) };
    corner.library.add_material(wood).map_err(|e| e.to_string())?;
    let bowl = [(0.06, 0.0), (0.1, 0.03), (0.12, 0.09), (0.115, 0.09), (0.095, 0.03), (0.06, 0.005)];
    let mug = [(0.04, 0.0), (0.04, 0.1), (0.036, 0.1), (0.036, 0.004)];
    let plate = [(0.08, 0.0), (0.13, 0.018), (0.13, 0.022), (0.08, 0.006)];
    let ball = |d: f32| vec![part(Shape::Sphere { radius: d / 2.0 }, [0.0, 0.0, d / 2.0])];
    let basket = || {
        let mut parts = vec![block([-0.2, -0.15, 0.0], [0.2, 0.15, 0.01])];
        parts.push(block([-0.2, -0.15, 0.01], [-0.19, 0.15, 0.22]));
        parts.push(block([0.19, -0.15, 0.01], [0.2, 0.15, 0.22]));
        parts.push(block([-0.19, -0.15, 0.01], [0.19, -0.14, 0.22]));
        parts.push(block([-0.19, 0.14, 0.01], [0.19, 0.15, 0.22]));
        parts
    };
    corner.put("floor", vec![block([-1.5, -1.5, -0.1], [1.5, 1.5, 0.0])], [0.0; 3], 0.0)?;
    corner.put("wall", vec![block([-1.6, -1.5, 0.0], [-1.5, 1.5, 2.2])], [0.0; 3], 0.0)?;
    corner.put("rug", upright(1.4, 1.6, 0.01), [0.2, -0.3, 0.0], 0.0)?;
    corner.put("table", table(0.8, 1.2, 0.75), [0.2, -0.3, 0.01], 0.0)?;
    corner.put("chair", table(0.45, 0.45, 0.46), [0.65, -0.3, 0.01], 180.0)?;
    corner.put("shelf", shelf(0.3, 0.8, 1.4, 4), [-1.33, 0.9, 0.0], 0.0)?;
    corner.put("bowl", lathe(&bowl), [0.1, -0.1, 0.76], 0.0)?;
    corner.put("apple", ball(0.08), [0.11, -0.1, 0.765], 0.0)?;
    corner.put("plate", lathe(&plate), [0.25, -0.55, 0.76], 0.0)?;
    corner.put("plate", lathe(&plate), [0.25, -0.55, 0.768], 0.0)?;
    corner.put("mug", lathe(&mug), [0.45, -0.2, 0.759], 30.0)?;
    corner.put("book", upright(0.2, 0.03, 0.25), [-1.32, 0.7, 0.48], 0.0)?;
    corner.put("book", upright(0.2, 0.04, 0.28), [-1.32, 0.736, 0.48], 0.0)?;
    corner.put("book", upright(0.2, 0.25, 0.03), [-1.33, 1.0, 0.48], 0.0)?;
    corner.put("vase", lathe(&mug), [-1.33, 0.9, 1.4], 0.0)?;
    corner.put("picture", upright(0.02, 0.6, 0.4), [-1.485, -0.4, 1.3], 0.0)?;
    corner.put("basket", basket(), [-0.9, -0.9, 0.0], 20.0)?;
    corner.put("ball", ball(0.14), [-0.9, -0.9, 0.01], 0.0)?;
    corner.put("ball", ball(0.2), [0.1, -0.5, 0.01], 0.0)?;
    corner.scene.assets(Arc::new(corner.library));
    Ok(corner.scene.build())
}
