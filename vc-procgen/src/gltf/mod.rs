//! glTF 2.0: assets and scenes out, a user's own models in.
//!
//! ```
//! use vc_graph::AssetLibrary;
//! use vc_graph::asset::{Part, Shape};
//! use vc_graph::{Asset, Pose};
//! use vc_procgen::gltf::{self, Options};
//! use vc_procgen::material;
//!
//! let library = material::library();
//! let part = Part {
//!     name: "ball".into(),
//!     shape: Shape::Sphere { radius: 0.11 },
//!     material: material::RED_PLASTIC.0,
//!     pose: Pose::translation(0.0, 0.0, 0.11),
//!     joint: None,
//! };
//! let ball = Asset { name: "ball_1".into(), parts: vec![part], ..Asset::default() };
//! let file = gltf::asset(&ball, &library)?; // std::fs::write("ball.glb", &file)
//!
//! let model = gltf::read(&file, &Options::default())?;
//! let mut mine = AssetLibrary::default();
//! let id = model.add_to(&mut mine)?;
//! assert_eq!(mine.get(id).map(|a| a.parts.len()), Some(1));
//! # Ok::<(), gltf::GltfError>(())
//! ```
//!
//! # Axes and units
//!
//! Metres on both sides. glTF has Y up and +Z in front; here Z is up and X in front.
//! A written file keeps our axes below a root node that turns them; a model that is
//! read is turned, and set down with the centre of its base at the origin.
//!
//! # Annotations
//!
//! glTF has no word for what a thing is and how it moves. Both directions use the
//! `extras` of nodes and materials, which modelling programs let one edit (in
//! Blender: custom properties, exported with "Custom Properties" ticked):
//!
//! ```json
//! {"vc": {"class": "kitchen_cabinet"}}
//! {"vc": {"joint": {"kind": "hinge", "axis": [0, 1, 0], "limits": [0, 1.6]}}}
//! {"vc": {"surface": {"hold": "inside", "half": [0.2, 0.4], "clearance": 0.3}}}
//! {"vc": {"physics": {"density": 700, "friction": 0.5, "restitution": 0.2}}}
//! ```
//!
//! - `class`, on any node: what the model is; the first one met counts.
//! - `joint`, on a node: it and what is below it move as one link. The axis is in
//!   the node's own frame and goes through its origin; limits in radians, or in
//!   metres for a `slide`. Joints below joints are refused.
//! - `surface`, on a node: things can be kept there. The node's origin is the middle
//!   of a level rectangle, `half` its half depth and half width in metres; without
//!   `half`, the surface is the top of the node's own mesh. `hold` is `on`, `inside`
//!   or `hook`; `clearance` is the free height, by default unlimited.
//! - `physics`, on a material.
//!
//! # What is not read
//!
//! Pictures but those of base colours, and of what glows where there is none (PNG and JPEG; their alpha is passed over,
//! and all of them repeat), skins, morph targets, animations, cameras and lights. Points and lines are passed over.
//! Where a picture cannot be read the model is plain, and [`Imported::missing_pictures`] says why. Compressed
//! vertices and vertices in files beside the file are refused with an error that says how to export instead.

mod access;
mod buffers;
mod collision;
mod coordinates;
mod document;
mod error;
mod export;
mod gather;
mod glb;
mod image;
mod import;
mod note;
mod paint;
mod stage;
mod write;

pub use error::GltfError;
pub use export::{TOLERANCE, asset, asset_of_class, posed_scene, scene, staged_scene};
pub use import::{Imported, Options, Size, read};
pub use stage::{LightPlace, Stage, StageCamera, StageLight};
