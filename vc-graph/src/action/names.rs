//! Checking labels: the text `milk.8` may refer to a node that is a knife.

use std::cmp::Ordering;
use std::hash::{Hash, Hasher};
use std::num::NonZeroU32;

use super::Action;
use crate::spelling::{clip, folded, same_word};
use crate::{Label, Node, NodeId, SceneGraph, nearest};

/// A label whose class is not the class of its node.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("`{written}` names a thing that is {found}; write the class and the number of one thing")]
pub struct NameMismatch {
    /// The label as it was written.
    pub written: Label,
    /// The label of the node with that number.
    pub found: Label,
}

impl SceneGraph {
    /// The classes of the scene, by name or alias, nearest to a misspelt name; empty for a name that the class
    /// table has. See [`nearest`].
    ///
    /// ```
    /// use vc_graph::{Draft, SceneBuilder};
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
    /// let apple = scene.add_on(table, Draft::new("apple"))?;
    /// let graph = scene.build();
    /// assert_eq!(graph.nearest_classes("aple"), ["apple"]);
    /// # Ok::<(), vc_graph::EditError>(())
    /// ```
    pub fn nearest_classes(&self, name: &str) -> Vec<&str> {
        let table = self.classes();
        if table.get(name).is_some() {
            return Vec::new();
        }
        let known = self.by_class.keys().filter_map(|class| table.exact(class));
        let aliases = known.flat_map(|class| &class.aliases);
        nearest(name, self.by_class.keys().chain(aliases).map(|name| &**name))
    }

    /// Checks that a text names a node correctly: by its class, an ancestor class, or an alias of these, in any
    /// spelling. A number that no node has passes the check: its use fails later.
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
    /// [`NameMismatch`] with both names.
    pub fn check_name(&self, class: &str, id: NodeId) -> Result<(), NameMismatch> {
        let Some(node) = self.node(id) else { return Ok(()) };
        let spec = node.spec();
        let written = std::iter::once(&*spec.spelling).chain(spec.name.as_deref());
        if written.into_iter().any(|own| same_word(own, class)) || self.classes().is_a(&spec.class, class) {
            return Ok(());
        }
        Err(NameMismatch { written: Label { class: clip(class).into(), id }, found: node.label() })
    }

    /// Checks that a node is of a label's class, as [`Self::check_name`] does.
    ///
    /// ```
    /// use vc_graph::{Draft, SceneBuilder};
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
    /// let apple = scene.add_on(table, Draft::new("apple"))?;
    /// let graph = scene.build();
    /// assert!(graph.check_label(&"apple.3".parse()?).is_ok());
    /// assert!(graph.check_label(&"food.3".parse()?).is_ok(), "an apple is food");
    /// assert!(graph.check_label(&"mug.3".parse()?).is_err());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`NameMismatch`] with both names.
    pub fn check_label(&self, label: &Label) -> Result<(), NameMismatch> {
        self.check_name(&label.class, label.id)
    }
}

/// The names by which a text calls the two objects of an action, as hashes, so that an action stays a few words
/// long. All values compare equal, because the names do not make two actions different.
///
/// ```
/// use vc_graph::{Action, Draft, SceneBuilder, rule};
/// let mut scene = SceneBuilder::new("flat");
/// let room = scene.add(Draft::new("kitchen"))?;
/// let table = scene.add_in(room, Draft::new("kitchen_table"))?;
/// let me = scene.add_in(room, Draft::new("character"))?;
/// let graph = scene.build();
/// let read = |text: String| text.parse::<Action>();
/// assert!(rule::refusals(&graph, me, &read(format!("walk table.{}", table.0))?).is_empty());
/// let wrong = rule::refusals(&graph, me, &read(format!("walk apple.{}", table.0))?);
/// assert!(wrong[0].to_string().starts_with("kitchen_table.2 is not what the action calls it"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, Default, serde::Serialize, serde::Deserialize)]
#[serde(transparent)]
pub struct ObjectNames([Option<NonZeroU32>; 2]);

impl ObjectNames {
    /// No names.
    pub const NOTHING: Self = Self([None; 2]);

    /// The names that labels give to the objects of an action.
    pub(crate) fn from_labels(action: &Action, labels: &[Label]) -> Self {
        let name = |id: NodeId| labels.iter().find(|label| label.id == id).map(|label| mark(&label.class));
        Self([action.object, action.target].map(|id| id.and_then(name)))
    }

    /// The first object of an action whose name does not fit it.
    pub(crate) fn misnamed(self, graph: &SceneGraph, action: &Action) -> Option<Label> {
        let things = [action.object, action.target].into_iter().zip(self.0);
        let nodes = things.filter_map(|(id, name)| Some((graph.node(id?)?, name?)));
        nodes.into_iter().find(|(node, name)| !graph.is_called(node, *name)).map(|(node, _)| node.label())
    }
}

impl SceneGraph {
    /// Whether the hash belongs to a name of the node, of its class or of an ancestor class.
    fn is_called(&self, node: &Node, name: NonZeroU32) -> bool {
        let spec = node.spec();
        let own = std::iter::once(&*spec.spelling).chain(spec.name.as_deref()).chain([&*spec.class]);
        let table = self.classes();
        let is_kind = |ancestor: &&crate::Class| table.is_a(&spec.class, &ancestor.name);
        let names = |class: &crate::Class| std::iter::once(&class.name).chain(&class.aliases).any(|n| mark(n) == name);
        own.into_iter().any(|own| mark(own) == name) || table.iter().filter(|class| names(class)).any(|c| is_kind(&c))
    }
}

/// A hash of a name, the same for all its spellings (FNV-1a).
fn mark(name: &str) -> NonZeroU32 {
    let mix = |sum: u32, c: char| (sum ^ u32::from(c)).wrapping_mul(0x0100_0193);
    NonZeroU32::new(folded(name).fold(0x811c_9dc5, mix)).unwrap_or(NonZeroU32::MAX)
}

impl PartialEq for ObjectNames {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

impl Eq for ObjectNames {}

impl PartialOrd for ObjectNames {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for ObjectNames {
    fn cmp(&self, _: &Self) -> Ordering {
        Ordering::Equal
    }
}

impl Hash for ObjectNames {
    fn hash<H: Hasher>(&self, _: &mut H) {}
}
