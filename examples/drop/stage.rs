//! The scene: a room with a table, shelves, a chest and a door, a pool behind it, and a road with a ramp in
//! front of it.

use std::sync::Arc;

use nalgebra::{Point3, UnitQuaternion, Vector3};
use virtualcity::graph::asset::{AssetError, Hold, Joint, JointKind, Material, Part, Shape, Surface};
use virtualcity::graph::{
    Asset, AssetId, AssetLibrary, Draft, EditError, NodeId, Pose, SceneBuilder, SceneGraph, Seed,
};

/// Height of the water's surface, metres.
pub(crate) const WATER: f32 = 0.9;

/// The nodes that take part in the events.
pub(crate) struct Cast {
    pub(crate) falling: Vec<NodeId>,
    pub(crate) shelf: NodeId,
    pub(crate) chest: NodeId,
    pub(crate) door: NodeId,
    pub(crate) car: NodeId,
    pub(crate) wood: NodeId,
    pub(crate) stone: NodeId,
    pub(crate) mug: NodeId,
    pub(crate) person: NodeId,
}

impl Cast {
    /// The nodes that leave a trail in the picture.
    pub(crate) fn moving(&self) -> impl Iterator<Item = NodeId> + '_ {
        self.falling.iter().copied().chain([self.car, self.wood, self.stone, self.mug, self.person])
    }
}

/// The reason why the scene cannot be built.
#[derive(Debug)]
pub(crate) struct InputFlaw(String);

impl std::fmt::Display for InputFlaw {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.0)
    }
}

impl From<AssetError> for InputFlaw {
    fn from(error: AssetError) -> Self {
        Self(error.to_string())
    }
}

impl From<EditError> for InputFlaw {
    fn from(error: EditError) -> Self {
        Self(error.to_string())
    }
}

/// Materials by their index in the library.
#[derive(Clone, Copy)]
struct Stuff {
    oak: u32,
    pine: u32,
    plaster: u32,
    stone: u32,
    clay: u32,
    red: u32,
    steel: u32,
    blue: u32,
}

struct Build {
    builder: SceneBuilder,
    library: AssetLibrary,
    stuff: Stuff,
}

pub(crate) fn build(seed: u64, things: u16) -> Result<(SceneGraph, Cast), InputFlaw> {
    let mut library = AssetLibrary::default();
    let mut add = |name: &str, colour: [f32; 3], density: f32, friction: f32, bounce: f32| {
        library.add_material(material(name, colour, density, friction, bounce))
    };
    let stuff = Stuff {
        oak: add("oak", [0.55, 0.38, 0.2], 700.0, 0.5, 0.1)?,
        pine: add("pine", [0.8, 0.65, 0.42], 600.0, 0.5, 0.1)?,
        plaster: add("plaster", [0.86, 0.85, 0.8], 1200.0, 0.6, 0.1)?,
        stone: add("stone", [0.5, 0.5, 0.52], 2500.0, 0.7, 0.1)?,
        clay: add("clay", [0.75, 0.42, 0.3], 1800.0, 0.5, 0.1)?,
        red: add("rubber", [0.8, 0.15, 0.12], 300.0, 0.8, 0.7)?,
        steel: add("steel", [0.25, 0.4, 0.6], 220.0, 0.4, 0.1)?,
        blue: add("plastic", [0.2, 0.45, 0.75], 900.0, 0.4, 0.3)?,
    };
    let mut build = Build { builder: SceneBuilder::new("drop"), library, stuff };
    let cast = build.everything(seed, things)?;
    let Build { mut builder, library, .. } = build;
    builder.assets(Arc::new(library));
    Ok((builder.build(), cast))
}

fn material(name: &str, colour: [f32; 3], density: f32, friction: f32, restitution: f32) -> Material {
    Material { density, friction, restitution, roughness: 0.6, ..Material::new(name, colour) }
}

fn at(x: f32, y: f32, z: f32) -> Pose {
    Pose::translation(x, y, z)
}

fn yawed(x: f32, y: f32, z: f32, yaw: f32) -> Pose {
    Pose::from_parts(Vector3::new(x, y, z).into(), UnitQuaternion::from_axis_angle(&Vector3::z_axis(), yaw))
}

fn board(name: &str, low: [f32; 3], high: [f32; 3], material: u32) -> Part {
    let half = [0, 1, 2].map(|i| (high[i] - low[i]) / 2.0);
    let pose = at((low[0] + high[0]) / 2.0, (low[1] + high[1]) / 2.0, (low[2] + high[2]) / 2.0);
    Part { name: name.into(), shape: Shape::Box { half: half.into() }, material, pose, joint: None }
}

fn surface(name: &str, hold: Hold, centre: [f32; 3], half: (f32, f32), clearance: Option<f32>) -> Surface {
    Surface { name: name.into(), hold, centre: centre.into(), half, clearance, joint: None }
}

impl Build {
    fn asset(&mut self, name: &str, parts: Vec<Part>, surfaces: Vec<Surface>) -> Result<AssetId, InputFlaw> {
        Ok(self.library.add(Asset { name: name.into(), parts, surfaces, ..Asset::default() })?)
    }

    fn add(&mut self, class: &str, asset: AssetId, pose: Pose) -> Result<NodeId, InputFlaw> {
        Ok(self.builder.add(Draft { asset: Some(asset), ..Draft::new(class).at(pose) })?)
    }

    fn block(&mut self, class: &str, low: [f32; 3], high: [f32; 3], material: u32) -> Result<NodeId, InputFlaw> {
        let asset = self.asset(class, vec![board(class, low, high, material)], Vec::new())?;
        self.add(class, asset, at(0.0, 0.0, 0.0))
    }

    fn everything(&mut self, seed: u64, things: u16) -> Result<Cast, InputFlaw> {
        self.building()?;
        self.table()?;
        let (shelf, chest, door) = (self.shelf()?, self.chest()?, self.door()?);
        let falling = self.falling(seed, things)?;
        let (car, wood, stone) = self.outdoors()?;
        let mug = self.thing("mug", mug(), self.stuff.blue, at(-0.25, 0.45, 0.745))?;
        let person = self.builder.add(Draft::new("character").at(at(-1.2, 0.6, 0.0)))?;
        Ok(Cast { falling, shelf, chest, door, car, wood, stone, mug, person })
    }

    /// A floor, three walls (one with a doorway), the road and the pool.
    fn building(&mut self) -> Result<(), InputFlaw> {
        let Stuff { plaster, stone, oak, .. } = self.stuff;
        self.block("floor", [-9.0, -5.0, -0.2], [9.0, 4.6, 0.0], stone)?;
        self.block("wall", [-2.2, 2.4, 0.0], [2.6, 2.5, 1.6], plaster)?;
        self.block("wall", [-2.2, -0.4, 0.0], [-2.1, 2.4, 1.6], plaster)?;
        self.block("wall", [-2.2, -2.0, 0.0], [-2.1, -1.2, 1.6], plaster)?;
        for (low, high) in [
            ([4.0, 1.0, 0.0], [4.1, 4.0, 1.1]),
            ([7.0, 1.0, 0.0], [7.1, 4.0, 1.1]),
            ([4.1, 1.0, 0.0], [7.0, 1.1, 1.1]),
            ([4.1, 3.9, 0.0], [7.0, 4.0, 1.1]),
        ] {
            self.block("wall", low, high, plaster)?;
        }
        // Kerbs, so that balls do not roll off the world.
        for (low, high) in [
            ([-9.0, -5.0, 0.0], [-8.9, 4.6, 0.15]),
            ([8.9, -5.0, 0.0], [9.0, 4.6, 0.15]),
            ([-8.9, -5.0, 0.0], [8.9, -4.9, 0.15]),
            ([-8.9, 4.5, 0.0], [8.9, 4.6, 0.15]),
        ] {
            self.block("wall", low, high, stone)?;
        }
        let half = Vector3::new(3.0, 1.3, 0.05);
        let ramp = Part {
            name: "ramp".into(),
            shape: Shape::Box { half },
            material: oak,
            pose: Pose::identity(),
            joint: None,
        };
        let ramp = self.asset("ramp", vec![ramp], Vec::new())?;
        let tilt = UnitQuaternion::from_axis_angle(&Vector3::y_axis(), -0.12);
        self.add("floor", ramp, Pose::from_parts(Vector3::new(5.0, -3.6, 0.3).into(), tilt))?;
        Ok(())
    }

    fn table(&mut self) -> Result<(), InputFlaw> {
        let oak = self.stuff.oak;
        let mut parts = vec![board("top", [-0.45, -0.8, 0.7], [0.45, 0.8, 0.74], oak)];
        for (x, y) in [(-0.42, -0.77), (0.36, -0.77), (-0.42, 0.71), (0.36, 0.71)] {
            parts.push(board("leg", [x, y, 0.0], [x + 0.06, y + 0.06, 0.7], oak));
        }
        let top = surface("top", Hold::On, [0.0, 0.0, 0.74], (0.45, 0.8), None);
        let asset = self.asset("table", parts, vec![top])?;
        self.add("dining_table", asset, at(0.0, 0.0, 0.0))?;
        Ok(())
    }

    fn shelf(&mut self) -> Result<NodeId, InputFlaw> {
        let pine = self.stuff.pine;
        let mut parts = vec![
            board("side", [-0.16, -0.6, 0.0], [0.16, -0.57, 1.3], pine),
            board("side", [-0.16, 0.57, 0.0], [0.16, 0.6, 1.3], pine),
            board("back", [-0.16, -0.57, 0.0], [-0.15, 0.57, 1.3], pine),
        ];
        let mut surfaces = Vec::new();
        for (i, z) in [0.1, 0.5, 0.9, 1.27].into_iter().enumerate() {
            parts.push(board("board", [-0.15, -0.57, z], [0.16, 0.57, z + 0.03], pine));
            let (name, clearance) = (format!("board {i}"), (i < 3).then_some(0.35));
            let hold = if i < 3 { Hold::Inside } else { Hold::On };
            surfaces.push(surface(&name, hold, [0.0, 0.0, z + 0.03], (0.14, 0.55), clearance));
        }
        let asset = self.asset("shelf", parts, surfaces)?;
        self.add("shelf", asset, yawed(0.6, 2.2, 0.0, -std::f32::consts::FRAC_PI_2))
    }

    fn chest(&mut self) -> Result<NodeId, InputFlaw> {
        let (pine, oak) = (self.stuff.pine, self.stuff.oak);
        let slide = Joint { kind: JointKind::Slide, anchor: Point3::origin(), axis: Vector3::x(), limits: (0.0, 0.32) };
        let moving = |part: Part| Part { joint: Some(slide), ..part };
        let parts = vec![
            board("side", [-0.22, -0.4, 0.0], [0.22, -0.38, 0.5], oak),
            board("side", [-0.22, 0.38, 0.0], [0.22, 0.4, 0.5], oak),
            board("back", [-0.22, -0.38, 0.0], [-0.2, 0.38, 0.5], oak),
            board("bottom", [-0.2, -0.38, 0.0], [0.22, 0.38, 0.02], oak),
            board("top", [-0.22, -0.4, 0.5], [0.22, 0.4, 0.52], oak),
            moving(board("drawer", [-0.19, -0.36, 0.2], [0.2, 0.36, 0.21], pine)),
            moving(board("drawer", [0.2, -0.37, 0.19], [0.23, 0.37, 0.45], pine)),
            moving(board("drawer", [-0.19, -0.36, 0.21], [-0.18, 0.36, 0.36], pine)),
            moving(board("drawer", [-0.18, 0.35, 0.21], [0.2, 0.36, 0.36], pine)),
            moving(board("drawer", [-0.18, -0.36, 0.21], [0.2, -0.35, 0.36], pine)),
        ];
        let surfaces = vec![surface("top", Hold::On, [0.0, 0.0, 0.52], (0.22, 0.4), None)];
        let asset = self.asset("chest", parts, surfaces)?;
        self.add("kitchen_cabinet", asset, yawed(-1.5, 2.1, 0.0, -std::f32::consts::FRAC_PI_2))
    }

    fn door(&mut self) -> Result<NodeId, InputFlaw> {
        let hinge = Joint {
            kind: JointKind::Hinge,
            anchor: Point3::new(0.0, 0.4, 0.0),
            axis: Vector3::z(),
            limits: (0.0, 1.7),
        };
        let leaf = Part { joint: Some(hinge), ..board("leaf", [-0.02, -0.4, 0.0], [0.02, 0.4, 1.58], self.stuff.oak) };
        let asset = self.asset("door", vec![leaf], Vec::new())?;
        self.add("door", asset, at(-2.15, -0.8, 0.0))
    }

    fn thing(&mut self, class: &str, shape: Shape, material: u32, pose: Pose) -> Result<NodeId, InputFlaw> {
        let part = Part { name: class.into(), shape, material, pose: Pose::identity(), joint: None };
        let asset = self.asset(class, vec![part], Vec::new())?;
        self.add(class, asset, pose)
    }

    /// Objects of five kinds, high above table and shelf.
    fn falling(&mut self, seed: u64, count: u16) -> Result<Vec<NodeId>, InputFlaw> {
        let Stuff { clay, red, pine, steel, blue, .. } = self.stuff;
        let kinds = [
            ("book", Shape::Box { half: Vector3::new(0.1, 0.07, 0.02) }, blue),
            ("ball", Shape::Sphere { radius: 0.06 }, red),
            ("bowl", bowl(), clay),
            ("can", Shape::Cylinder { radius: 0.035, half_height: 0.055 }, steel),
            ("toy_block", Shape::Box { half: Vector3::repeat(0.04) }, pine),
        ];
        let mut rng = Seed(seed).child("falling").stream();
        let mut all = Vec::new();
        for i in 0..usize::from(count) {
            let (class, shape, material) = kinds[i % kinds.len()].clone();
            let (x, y) = if i % 3 == 0 { (0.6, 2.1) } else { (0.0, 0.0) };
            let spot = Vector3::new(x + rng.between(-0.4, 0.4), y + rng.between(-0.5, 0.3), 1.6 + 0.12 * i as f32);
            let axis = Vector3::new(rng.between(-1.0, 1.0), rng.between(-1.0, 1.0), rng.between(-1.0, 1.0));
            let turn = UnitQuaternion::new(axis * 2.0);
            all.push(self.thing(class, shape, material, Pose::from_parts(spot.into(), turn))?);
        }
        Ok(all)
    }

    fn outdoors(&mut self) -> Result<(NodeId, NodeId, NodeId), InputFlaw> {
        let Stuff { steel, blue, pine, stone, .. } = self.stuff;
        let parts = vec![
            board("body", [-2.0, -0.85, 0.25], [2.0, 0.85, 0.75], steel),
            board("cabin", [-1.3, -0.75, 0.75], [0.6, 0.75, 1.3], blue),
        ];
        let car = self.asset("car", parts, Vec::new())?;
        let car = self.add("car", car, at(-6.0, -3.6, 0.0))?;
        // Their class is not in the table, so that their masses follow from their volumes.
        let half = Vector3::new(0.25, 0.2, 0.1);
        let wood = self.thing("driftwood", Shape::Box { half }, pine, at(5.2, 2.5, 1.8))?;
        let stone = self.thing("cobblestone", Shape::Sphere { radius: 0.12 }, stone, at(6.2, 2.3, 2.4))?;
        Ok((car, wood, stone))
    }
}

fn bowl() -> Shape {
    Shape::Lathe { profile: vec![(0.05, 0.0), (0.1, 0.07), (0.092, 0.07), (0.045, 0.008)] }
}

fn mug() -> Shape {
    Shape::Lathe { profile: vec![(0.045, 0.0), (0.045, 0.1), (0.04, 0.1), (0.04, 0.006)] }
}
