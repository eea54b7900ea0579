//! Checking labels: `milk.8` may name a node that is a knife.

use crate::vocabulary::{clip, same_word};
use crate::{Label, NodeId, SceneGraph, nearest};

/// A label whose class is not that of its node.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("`{written}` names a thing that is {found}; write the class and the number of one thing")]
pub struct Misnomer {
    /// The label as it was written.
    pub written: Label,
    /// The node of its number.
    pub found: Label,
}

impl SceneGraph {
    /// The classes of the scene, by name or alias, nearest to a misspelt name; none for a name that the
    /// class table knows. See [`nearest`].
    pub fn nearest_classes(&self, name: &str) -> Vec<&str> {
        let table = self.classes();
        if table.get(name).is_some() {
            return Vec::new();
        }
        let known = self.by_class.keys().filter_map(|class| table.exact(class));
        let aliases = known.flat_map(|class| &class.aliases);
        nearest(name, self.by_class.keys().chain(aliases).map(|name| &**name))
    }

    /// Checks that a node is what a text calls it: its class, a class that it is a kind of, or another
    /// name of these, in any spelling. A number that no node has passes: the use of it fails later.
    ///
    /// ```
    /// use vc_graph::{Draft, SceneBuilder};
    /// let mut scene = SceneBuilder::new("flat");
    /// let table = scene.add(Draft::new("kitchen_table"))?;
    /// let graph = scene.build();
    /// assert!(graph.check_name("KitchenTable", table).is_ok() && graph.check_name("table", table).is_ok());
    /// let error = graph.check_name("milk", table).unwrap_err();
    /// assert!(error.to_string().starts_with("`milk.1` names a thing that is kitchen_table.1"));
    /// # Ok::<(), vc_graph::EditError>(())
    /// ```
    ///
    /// # Errors
    /// [`Misnomer`] with both names.
    pub fn check_name(&self, class: &str, id: NodeId) -> Result<(), Misnomer> {
        let Some(node) = self.node(id) else { return Ok(()) };
        let spec = node.spec();
        let written = std::iter::once(&*spec.spelling).chain(spec.name.as_deref());
        if written.into_iter().any(|own| same_word(own, class)) || self.classes().is_a(&spec.class, class) {
            return Ok(());
        }
        Err(Misnomer { written: Label { class: clip(class).into(), id }, found: node.label() })
    }

    /// Checks that a node is of a label's class, as [`Self::check_name`] does.
    ///
    /// # Errors
    /// [`Misnomer`] with both names.
    pub fn check_label(&self, label: &Label) -> Result<(), Misnomer> {
        self.check_name(&label.class, label.id)
    }
}
