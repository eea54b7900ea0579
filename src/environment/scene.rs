//! Scenes by name, and shapes for what has none.

use vc_graph::format::read_scene;
use vc_graph::{ClassTable, SceneGraph, Seed};
use vc_procgen::dress::{self, DressError};
use vc_procgen::Apartment;

use super::MakeError;

/// How a scene by name becomes an environment: [`Environment::make_with`](super::Environment::make_with).
///
/// ```
/// use virtualcity::{Assets, SceneOptions};
/// assert_eq!(SceneOptions::default().assets, Assets::Generated);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct SceneOptions {
    /// The shapes of what has a box and none.
    pub assets: Assets,
}

/// Which shapes things get that have a class and a box alone, as in VirtualHome's scenes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Assets {
    /// None: they stay boxes.
    None,
    /// Those their classes' generators make in their sizes: [`vc_procgen::dress`].
    #[default]
    Generated,
}

/// The scene of a name: `apartment/SEED` is generated, `scene:FILE` is read.
pub(super) fn named(name: &str, options: &SceneOptions) -> Result<SceneGraph, MakeError> {
    if let Some(seed) = name.strip_prefix("apartment/") {
        let seed = seed.parse().map_err(|_| MakeError::BadSeed(seed.to_owned()))?;
        return Ok(Apartment::from_seed(Seed(seed))?.scene());
    }
    let path = name.strip_prefix("scene:").ok_or_else(|| MakeError::UnknownName(name.to_owned()))?;
    let text = std::fs::read_to_string(path).map_err(|error| MakeError::File { path: path.to_owned(), error })?;
    let scene = read_scene(&text, &ClassTable::builtin());
    let scene = scene.map_err(|error| MakeError::Format { path: path.to_owned(), error })?;
    Ok(match options.assets {
        Assets::None => scene,
        Assets::Generated => dress::dressed(&scene, dress::seed_of(&scene))?,
    })
}

/// The scene with a shape for everything that has neither asset nor box and of whose class
/// there is a generator. `None` if nothing lacks one.
pub(super) fn shaped(graph: &SceneGraph) -> Result<Option<SceneGraph>, DressError> {
    dress::shaped(graph, Seed(graph.len() as u64).child("shapes"))
}
