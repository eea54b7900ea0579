//! Scenes by name, and shapes for things that have none.

use std::sync::Arc;

use vc_graph::{ClassTable, SceneGraph, Seed};
use vc_procgen::Apartment;
use vc_procgen::dress::{self, DressError};

use super::MakeError;

/// The shapes for things that have only a class and a box, as in VirtualHome's scenes:
/// [`EnvironmentBuilder::assets`](super::EnvironmentBuilder::assets).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Assets {
    /// Plain shapes, sufficient for walking and for placing things on them: [`vc_geometry`].
    None,
    /// The shapes that the class generators make in the size of the boxes: [`vc_procgen::dress`].
    #[default]
    Generated,
}

/// The scene with a name: `apartment/SEED` is generated, `scene:FILE` is read, gzipped or not.
pub(super) fn named(name: &str, classes: &Arc<ClassTable>) -> Result<SceneGraph, MakeError> {
    if let Some(seed) = name.strip_prefix("apartment/") {
        let seed = seed.parse().map_err(|_| MakeError::BadSeed(seed.to_owned()))?;
        return Ok(Apartment::from_seed(Seed(seed))?.scene());
    }
    let path = name.strip_prefix("scene:").filter(|path| !path.is_empty());
    let path = path.ok_or_else(|| MakeError::UnknownName(name.to_owned()))?;
    Ok(crate::read_scene(path, classes)?)
}

/// The scene with a shape for every thing that has neither asset nor box and whose class has a generator.
/// `None` if nothing lacks one.
pub(super) fn shaped(graph: &SceneGraph) -> Result<Option<SceneGraph>, DressError> {
    dress::shaped(graph, Seed(graph.len() as u64).child("shapes"))
}
