//! Annotations that glTF has no fields for, in the `extras` of nodes and materials.

use serde::{Deserialize, Serialize};
use serde_json::Value;
use vc_graph::asset::{Hold, JointKind};

use super::GltfError;

/// The annotation of a node, under `vc`.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub(super) struct NodeNote {
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) class: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) joint: Option<JointNote>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) surface: Option<SurfaceNote>,
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct JointNote {
    pub(super) kind: JointKind,
    pub(super) axis: [f32; 3],
    pub(super) limits: (f32, f32),
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct SurfaceNote {
    pub(super) hold: Hold,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(super) half: Option<(f32, f32)>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(super) clearance: Option<f32>,
}

/// The annotation of a material, under `vc`.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub(super) struct MaterialNote {
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) physics: Option<Physics>,
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Physics {
    pub(super) density: f32,
    #[serde(default = "half")]
    pub(super) friction: f32,
    #[serde(default)]
    pub(super) restitution: f32,
}

fn half() -> f32 {
    0.5
}

/// Wraps an annotation as `extras`; `None` if it is empty.
pub(super) fn written<T: Serialize + Default + PartialEq>(note: &T) -> Option<Value> {
    (*note != T::default()).then(|| serde_json::json!({ "vc": note }))
}

/// The annotation in `extras`, or an empty one.
pub(super) fn noted<T>(extras: Option<&Value>, place: impl FnOnce() -> String) -> Result<T, GltfError>
where
    T: Default + for<'a> Deserialize<'a>,
{
    let Some(note) = extras.and_then(|e| e.get("vc")) else { return Ok(T::default()) };
    T::deserialize(note).map_err(|e| GltfError::BadNote { place: place(), reason: format!("cannot be read: {e}") })
}
