//! Scenes by name, and shapes for what has none.

use std::sync::Arc;

use vc_graph::format::read_scene;
use vc_graph::{ClassTable, Draft, Kind, Node, SceneBuilder, SceneGraph, Seed};
use vc_procgen::{Apartment, Style, object};

use super::{MakeError, ShapesError};

/// The scene of a name: `apartment/SEED` is generated, `scene:FILE` is read, packed or not.
pub(super) fn named(name: &str) -> Result<SceneGraph, MakeError> {
    if let Some(seed) = name.strip_prefix("apartment/") {
        let seed = seed.parse().map_err(|_| MakeError::BadSeed(seed.to_owned()))?;
        return Ok(Apartment::from_seed(Seed(seed))?.scene());
    }
    let path = name.strip_prefix("scene:").ok_or_else(|| MakeError::UnknownName(name.to_owned()))?;
    let text = crate::read_text(path)?;
    read_scene(&text, &ClassTable::builtin()).map_err(|error| MakeError::Format { path: path.to_owned(), error })
}

/// The scene with a shape for everything that has neither asset nor box and of whose class
/// there is a generator: an instance of the usual size, the same for the same scene and
/// number. `None` if nothing lacks one.
pub(super) fn shaped(graph: &SceneGraph) -> Result<Option<SceneGraph>, ShapesError> {
    if !graph.nodes().any(|n| lacks_shape(n).is_some()) {
        return Ok(None);
    }
    let mut library = graph.assets().as_ref().clone();
    let offset = match vc_procgen::material::library() {
        own if (0..).map_while(|i| own.material(i)).eq((0..).map_while(|i| library.material(i)).take(count(&own))) => 0,
        own => {
            let offset = count(&library);
            (0..).map_while(|i| own.material(i)).try_for_each(|m| library.add_material(m.clone()).map(drop))?;
            offset
        }
    };
    let seed = Seed(graph.len() as u64).child("shapes");
    let style = Style::from_seed(seed);
    let mut builder = SceneBuilder::with_classes(graph.name(), graph.classes().clone());
    for node in graph.nodes() {
        let mut draft = draft(node);
        if let Some(generator) = lacks_shape(node) {
            let mut made = generator.object(&style, seed.nth(u64::from(node.id().0)));
            let parts = made.asset.parts.iter_mut().chain(&mut made.asset.collision);
            parts.for_each(|part| part.material += offset as u32);
            draft.asset = Some(library.add(made.asset)?);
            draft.bounds = Some(made.bounds);
        }
        builder.add_with_id(node.id(), draft)?;
    }
    builder.link_all(&graph.edges().collect::<Vec<_>>())?;
    builder.assets(Arc::new(library));
    Ok(Some(builder.build()))
}

fn count(library: &vc_graph::AssetLibrary) -> usize {
    (0..).map_while(|i| library.material(i)).count()
}

fn lacks_shape(node: &Node) -> Option<&'static object::Generator> {
    let bare = node.kind() == Kind::Object && node.spec().asset.is_none() && node.spec().bounds.is_none();
    object::generator(node.class()).filter(|_| bare)
}

/// What a node would be built from.
pub(super) fn draft(node: &Node) -> Draft {
    let spec = node.spec();
    Draft {
        class: spec.spelling.clone(),
        name: spec.name.clone(),
        category: Some(spec.category.clone()),
        properties: Some(spec.properties),
        states: Some(node.states()),
        entering: Vec::new(),
        pose: node.pose().copied(),
        bounds: spec.bounds,
        scale: Some(spec.scale),
        slots: Some(spec.slots.to_vec()),
        contents: node.contents().cloned(),
        asset: spec.asset,
    }
}
