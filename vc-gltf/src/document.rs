//! The part of glTF's JSON that is read and written. Specification:
//! <https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html>.
//!
//! Fields that are only written are skipped when reading, whatever their values are.

use serde::de::DeserializeOwned;
use serde::{Deserialize, Deserializer, Serialize};
use serde_json::Value;

pub(super) const FLOAT: u32 = 5126;
pub(super) const SIGNED_BYTE: u32 = 5120;
pub(super) const BYTE: u32 = 5121;
pub(super) const SIGNED_SHORT: u32 = 5122;
pub(super) const SHORT: u32 = 5123;
pub(super) const INT: u32 = 5125;

fn absent<T: Default + PartialEq>(value: &T) -> bool {
    *value == T::default()
}

/// A field that is not essential to a model; takes its default where the value violates the specification.
fn lenient<'de, D: Deserializer<'de>, T: DeserializeOwned + Default>(from: D) -> Result<T, D::Error> {
    Ok(T::deserialize(Value::deserialize(from)?).unwrap_or_default())
}

macro_rules! object {
    ($(#[$doc:meta])* $name:ident { $($(#[$attribute:meta])* $field:ident: $type:ty,)* }) => {
        $(#[$doc])*
        #[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
        #[serde(rename_all = "camelCase", default)]
        pub(super) struct $name {
            $($(#[$attribute])* #[serde(skip_serializing_if = "absent")] pub(super) $field: $type,)*
        }
    };
}

object! { Document {
    asset: Head,
    #[serde(skip_deserializing)] extensions_used: Vec<String>,
    extensions_required: Vec<String>,
    #[serde(skip_deserializing)] extensions: Option<DocumentExtensions>,
    scene: Option<usize>,
    scenes: Vec<Scene>,
    #[serde(skip_deserializing)] cameras: Vec<Camera>,
    nodes: Vec<Node>,
    meshes: Vec<Mesh>,
    materials: Vec<Material>,
    textures: Vec<Texture>,
    images: Vec<Image>,
    accessors: Vec<Accessor>,
    buffer_views: Vec<View>,
    buffers: Vec<Buffer>,
}}

object! { Head { version: String, #[serde(skip_deserializing)] generator: String, } }

object! { Scene { #[serde(deserialize_with = "lenient")] name: String, nodes: Vec<usize>, } }

object! { Node {
    #[serde(deserialize_with = "lenient")] name: String,
    children: Vec<usize>,
    mesh: Option<usize>,
    matrix: Option<[f64; 16]>,
    translation: Option<[f32; 3]>,
    rotation: Option<[f32; 4]>,
    scale: Option<[f32; 3]>,
    #[serde(skip_deserializing)] camera: Option<usize>,
    #[serde(skip_deserializing)] extensions: Option<NodeExtensions>,
    extras: Option<Value>,
}}

object! { Camera {
    name: String,
    #[serde(rename = "type")] kind: String,
    perspective: Perspective,
}}

object! { Perspective {
    yfov: f32,
    aspect_ratio: Option<f32>,
    znear: f32,
}}

object! { DocumentExtensions {
    #[serde(rename = "KHR_lights_punctual")] lights: Lights,
}}

object! { Lights { lights: Vec<Light>, } }

/// The extension for lights.
pub(super) const LIGHTS: &str = "KHR_lights_punctual";

/// A light in the form of the extension.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Light {
    pub(super) name: String,
    #[serde(rename = "type")]
    pub(super) kind: String,
    pub(super) color: [f32; 3],
    pub(super) intensity: f32,
}

/// The extensions of a node.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub(super) struct NodeExtensions {
    #[serde(rename = "KHR_lights_punctual")]
    pub(super) light: LightOf,
}

/// The light that a node carries; index zero is written as well.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub(super) struct LightOf {
    pub(super) light: usize,
}

object! { Mesh { #[serde(deserialize_with = "lenient")] name: String, primitives: Vec<Primitive>, } }

object! { Primitive {
    attributes: Attributes,
    indices: Option<usize>,
    material: Option<usize>,
    mode: Option<u32>,
}}

object! { Attributes {
    #[serde(rename = "POSITION")] position: Option<usize>,
    #[serde(rename = "NORMAL", skip_deserializing)] normal: Option<usize>,
    #[serde(rename = "TEXCOORD_0")] first: Option<usize>,
    #[serde(rename = "TEXCOORD_1")] second: Option<usize>,
}}

object! { Material {
    #[serde(deserialize_with = "lenient")] name: String,
    pbr_metallic_roughness: Surface,
    emissive_factor: Option<[f32; 3]>,
    emissive_texture: Option<TextureOf>,
    #[serde(deserialize_with = "lenient")] alpha_mode: Option<String>,
    #[serde(deserialize_with = "lenient")] extensions: Extensions,
    extras: Option<Value>,
}}

impl Material {
    /// The texture used as the material's image: the base colour's, or the emission's if there is none.
    pub(super) fn texture(&self) -> Option<&TextureOf> {
        self.pbr_metallic_roughness.base_color_texture.as_ref().or(self.emissive_texture.as_ref())
    }
}

object! { Surface {
    base_color_factor: Option<[f32; 4]>,
    base_color_texture: Option<TextureOf>,
    metallic_factor: Option<f32>,
    roughness_factor: Option<f32>,
}}

object! {
/// The index of a material's texture, and of the mesh coordinates that it uses.
TextureOf { index: Option<usize>, tex_coord: usize, #[serde(deserialize_with = "lenient")] extensions: TextureExtensions, }}

object! { TextureExtensions {
    #[serde(rename = "KHR_texture_transform")] transform: Option<Transform>,
}}

object! {
/// The transform applied to coordinates.
Transform {
    offset: [f32; 2],
    rotation: f32,
    scale: Option<[f32; 2]>,
    tex_coord: Option<usize>,
}}

object! { Texture { source: Option<usize>, } }

object! { Image {
    #[serde(deserialize_with = "lenient")] name: String,
    uri: Option<String>,
    #[serde(skip_deserializing)] mime_type: Option<String>,
    buffer_view: Option<usize>,
}}

object! { Extensions {
    #[serde(rename = "KHR_materials_emissive_strength")] strength: Option<Strength>,
    #[serde(rename = "KHR_materials_transmission")] transmission: Option<Transmission>,
}}

object! { Strength { emissive_strength: Option<f32>, } }

object! { Transmission { transmission_factor: f32, } }

object! { Accessor {
    buffer_view: Option<usize>,
    byte_offset: usize,
    component_type: u32,
    normalized: bool,
    count: usize,
    #[serde(rename = "type")] kind: String,
    #[serde(skip_deserializing)] min: Option<Vec<f32>>,
    #[serde(skip_deserializing)] max: Option<Vec<f32>>,
    sparse: Option<Value>,
}}

object! {
/// The elements of an accessor that replace those of its buffer view, or zeros where it has none.
Sparse { count: usize, indices: SparsePart, values: SparsePart, }}

object! { SparsePart { buffer_view: Option<usize>, byte_offset: usize, component_type: u32, }}

object! { View {
    buffer: Option<usize>,
    byte_offset: usize,
    byte_length: usize,
    byte_stride: Option<usize>,
    #[serde(skip_deserializing)] target: Option<u32>,
}}

object! { Buffer { byte_length: usize, uri: Option<String>, } }
