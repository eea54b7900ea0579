//! Changes of a scene read back from their JSON: those of whole nodes need the class table.

use std::sync::Arc;

use serde::Deserialize;

use super::{FormatError, FormatProblem, NodeFile, Source};
use crate::{Change, ChangeSet, ClassTable, Node};

#[derive(Deserialize)]
#[serde(rename_all = "snake_case")]
enum NodeChange {
    Add(NodeFile),
    Remove(NodeFile),
}

/// Reads a change set as serde writes it, nodes that were added or removed included.
///
/// ```
/// use vc_graph::{ClassTable, Draft, SceneBuilder, format::native};
/// let mut scene = SceneBuilder::new("flat");
/// let duvet = scene.add(Draft::new("duvet"))?;
/// let mut edit = scene.edit();
/// edit.set_scale(duvet, [0.5, 0.5, 2.0].into())?;
/// let folded = edit.commit();
/// let text = serde_json::to_string(&folded)?;
/// assert_eq!(native::read_changes(&text, &ClassTable::builtin())?, folded);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`FormatError`]: another format, a node with an invalid number; it names the change.
pub fn read_changes(text: &str, classes: &ClassTable) -> Result<ChangeSet, FormatError> {
    let source = Source::new("changes", text);
    let changes: Vec<serde_json::Value> = source.json()?;
    let read = |(index, change): (usize, serde_json::Value)| {
        let shape = |e: serde_json::Error| source.error(format!("[{index}]"), FormatProblem::Shape(e.to_string()));
        if change.get("add").or_else(|| change.get("remove")).is_none() {
            return Change::deserialize(change).map_err(shape);
        }
        let (node, changed): (NodeFile, fn(Arc<Node>) -> Change) =
            match NodeChange::deserialize(change).map_err(shape)? {
                NodeChange::Add(node) => (node, Change::Add),
                NodeChange::Remove(node) => (node, Change::Remove),
            };
        let change = node.into_node(classes).map(|node| changed(node.into()));
        change.map_err(|field| source.error(format!("[{index}]{field}"), FormatProblem::Number(field[1..].to_owned())))
    };
    changes.into_iter().enumerate().map(read).collect()
}
