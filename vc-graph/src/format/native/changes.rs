//! Changes of a scene read back from their JSON: those of whole nodes need the class table.

use serde::Deserialize;

use super::{FormatError, FormatProblem, NodeFile, Source};
use crate::{Change, ChangeSet, ClassTable};

#[derive(Deserialize)]
#[serde(untagged)]
enum ChangeFile {
    Node(NodeChange),
    Other(Change),
}

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
/// [`FormatError`]: another format, a node with an invalid number.
pub fn read_changes(text: &str, classes: &ClassTable) -> Result<ChangeSet, FormatError> {
    let source = Source::new("changes", text);
    let changes: Vec<ChangeFile> = source.json()?;
    let read = |(index, change): (usize, ChangeFile)| {
        let change = match change {
            ChangeFile::Other(change) => Ok(change),
            ChangeFile::Node(NodeChange::Add(node)) => node.into_node(classes).map(|node| Change::Add(node.into())),
            ChangeFile::Node(NodeChange::Remove(node)) => {
                node.into_node(classes).map(|node| Change::Remove(node.into()))
            }
        };
        change.map_err(|field| source.error(format!("[{index}]{field}"), FormatProblem::Number(field[1..].to_owned())))
    };
    changes.into_iter().enumerate().map(read).collect()
}
