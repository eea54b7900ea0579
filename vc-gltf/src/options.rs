//! Options for reading a model.

use std::sync::Arc;

use nalgebra::Vector3;

/// The size of an imported model.
///
/// ```
/// # use vc_graph::asset::{Material, Part, Shape};
/// # use vc_graph::{Asset, AssetLibrary, Pose};
/// # let mut library = AssetLibrary::default();
/// # let material = library.add_material(Material::new("red", [0.56, 0.03, 0.03]))?;
/// # let shape = Shape::Sphere { radius: 0.11 };
/// # let part = Part { name: "ball".into(), shape, material, pose: Pose::identity(), joint: None };
/// # let ball = Asset { name: "ball_1".into(), parts: vec![part], ..Asset::default() };
/// use vc_gltf::{ImportOptions, ModelSize};
/// let file = vc_gltf::asset(&ball, &library)?;
/// // The ball of 22 centimetres, scaled to half a metre.
/// let size = ModelSize::Height(0.5);
/// let model = vc_gltf::read(&file, &ImportOptions { size, ..ImportOptions::default() })?;
/// let (low, high) = model.asset.parts[0].shape.extent();
/// assert!((high.z - low.z - 0.5).abs() < 0.01);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[non_exhaustive]
pub enum ModelSize {
    /// As the file says, in metres.
    #[default]
    AsIs,
    /// The file's size times a factor.
    Times(f32),
    /// Scaled to this height, metres.
    Height(f32),
    /// Scaled to fit into this depth, width and height, metres.
    Within(Vector3<f32>),
}

/// Options for reading a model.
///
/// ```
/// # use vc_graph::asset::{Material, Part, Shape};
/// # use vc_graph::{Asset, AssetLibrary, Pose};
/// # let mut library = AssetLibrary::default();
/// # let material = library.add_material(Material::new("red", [0.56, 0.03, 0.03]))?;
/// # let shape = Shape::Sphere { radius: 0.11 };
/// # let part = Part { name: "ball".into(), shape, material, pose: Pose::identity(), joint: None };
/// # let ball = Asset { name: "ball_1".into(), parts: vec![part], ..Asset::default() };
/// use vc_gltf::ImportOptions;
/// let file = vc_gltf::asset(&ball, &library)?;
/// let options = ImportOptions { name: Some("my_ball".into()), hulls: 0, ..ImportOptions::default() };
/// let model = vc_gltf::read(&file, &options)?;
/// assert_eq!(&*model.asset.name, "my_ball");
/// assert!(model.asset.collision.is_empty());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct ImportOptions {
    /// The name of the asset; by default that of the scene or its first part.
    pub name: Option<Arc<str>>,
    /// The size of the asset.
    pub size: ModelSize,
    /// Quarter turns counter-clockwise seen from above, for a model whose front is not where glTF has
    /// it (+Z).
    pub quarter_turns: i32,
    /// Whether to put the centre of its base at the origin; true by default.
    pub recentre: bool,
    /// The greatest number of convex collision pieces for each link; 16 by default, and hollow parts
    /// need at least four. With 0 there are none, and physics uses the triangles.
    pub hulls: usize,
    /// The density of materials without an annotation, kilograms per cubic metre.
    pub density: f32,
    /// The Coulomb friction coefficient of materials without an annotation.
    pub friction: f32,
    /// The coefficient of restitution of materials without an annotation, 0 to 1.
    pub restitution: f32,
}

impl Default for ImportOptions {
    fn default() -> Self {
        Self {
            name: None,
            size: ModelSize::AsIs,
            quarter_turns: 0,
            recentre: true,
            hulls: 16,
            density: 700.0,
            friction: 0.5,
            restitution: 0.2,
        }
    }
}
