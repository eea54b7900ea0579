//! glTF 2.0: exporting assets and scenes, importing a user's own models.
//!
//! ```
//! use vc_gltf::{self as gltf, ImportOptions};
//! use vc_graph::asset::{Material, Part, Shape};
//! use vc_graph::{Asset, AssetLibrary, Pose};
//!
//! let mut library = AssetLibrary::default();
//! let red = Material { friction: 0.4, restitution: 0.4, roughness: 0.4, ..Material::new("red", [0.56, 0.03, 0.03]) };
//! let red = library.add_material(red)?;
//! let part = Part {
//!     name: "ball".into(),
//!     shape: Shape::Sphere { radius: 0.11 },
//!     material: red,
//!     pose: Pose::translation(0.0, 0.0, 0.11),
//!     joint: None,
//! };
//! let ball = Asset { name: "ball_1".into(), parts: vec![part], ..Asset::default() };
//! let file = gltf::asset(&ball, &library)?; // std::fs::write("ball.glb", &file)
//!
//! let model = gltf::read(&file, &ImportOptions::default())?;
//! let mut mine = AssetLibrary::default();
//! let id = model.add_to(&mut mine)?;
//! assert_eq!(mine.get(id).map(|a| a.parts.len()), Some(1));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Axes and units
//!
//! Both sides use metres. glTF has Y up and +Z forward; here Z is up and X forward. An exported file keeps our
//! axes below a root node that rotates them; an imported model is rotated, with the centre of its base at the
//! origin.
//!
//! # Annotations
//!
//! glTF cannot express an object's class or its joints. Both directions use the `extras` of nodes and
//! materials, which can be edited in modelling programs (in Blender: custom properties, exported with "Custom
//! Properties" ticked):
//!
//! ```json
//! {"vc": {"class": "kitchen_cabinet"}}
//! {"vc": {"joint": {"kind": "hinge", "axis": [0, 1, 0], "limits": [0, 1.6]}}}
//! {"vc": {"surface": {"hold": "inside", "half": [0.2, 0.4], "clearance": 0.3}}}
//! {"vc": {"physics": {"density": 700, "friction": 0.5, "restitution": 0.2}}}
//! ```
//!
//! - `class`, on any node: the class of the model; the first one found counts.
//! - `joint`, on a node: the node and its descendants move as one link. The axis is in the node's own frame and
//!   passes through its origin; limits are in radians, or in metres for a `slide`. Joints below joints are
//!   refused.
//! - `surface`, on a node: objects can be placed there. The node's origin is the centre of a level rectangle,
//!   `half` its half depth and half width in metres; without `half`, the surface is the top of the node's own
//!   mesh. `hold` is `on`, `inside` or `hook`; `clearance` is the free height, by default unlimited.
//! - `physics`, on a material.
//!
//! # Unsupported features
//!
//! The only images read are those of base colours, and of emission where there is no base colour image (PNG and
//! JPEG; alpha is ignored, and all images repeat). Skins, morph targets, animations, cameras and lights are not
//! read; points and lines are ignored. Where an image cannot be read, the model has a plain colour and
//! [`ImportedModel::missing_images`] has the reason. Compressed vertices, and vertices in separate files, are
//! refused with an error that advises how to export instead.

#![warn(clippy::disallowed_methods)]

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
mod options;
mod paint;
mod stage;
mod write;

pub use error::GltfError;
pub use export::{TOLERANCE, asset, asset_of_class, posed_scene, scene, staged_scene};
pub use import::{ImportedModel, read};
pub use options::{ImportOptions, ModelSize};
pub use stage::{LightPlace, Stage, StageCamera, StageLight};
