//! Identity of nodes.

use std::fmt;
use std::str::FromStr;
use std::sync::Arc;

use serde::{Deserialize, Serialize};

/// A node's number: stable for the life of a scene and never reused after the node is removed.
///
/// Prints as `#12`; with its class it prints as `cup.12`, see [`Label`].
///
/// ```
/// use vc_graph::NodeId;
/// let id: NodeId = serde_json::from_str("12")?;
/// assert_eq!(id.to_string(), "#12");
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(transparent)]
pub struct NodeId(pub u32);

impl fmt::Display for NodeId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "#{}", self.0)
    }
}

/// A node's class and number: how nodes are shown to people, `cup.12`.
///
/// ```
/// use vc_graph::{Label, NodeId};
/// let label: Label = "cup.12".parse()?;
/// assert_eq!(label.id, NodeId(12));
/// assert_eq!(label.to_string(), "cup.12");
/// # Ok::<(), vc_graph::LabelError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Label {
    /// Class of the node.
    pub class: Arc<str>,
    /// Number of the node.
    pub id: NodeId,
}

impl fmt::Display for Label {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}.{}", self.class, self.id.0)
    }
}

impl Serialize for Label {
    fn serialize<S: serde::Serializer>(&self, s: S) -> Result<S::Ok, S::Error> {
        s.collect_str(self)
    }
}

/// Text that is not a label.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("`{0}` names no object; write its class and number, as in `cup.12`")]
pub struct LabelError(pub String);

impl FromStr for Label {
    type Err = LabelError;

    fn from_str(text: &str) -> Result<Self, LabelError> {
        let bad = || LabelError(crate::spelling::clip(text));
        let (class, number) = text.trim().rsplit_once('.').ok_or_else(bad)?;
        if !is_class(class) {
            return Err(bad());
        }
        let id = number.parse().map(NodeId).map_err(|_| bad())?;
        Ok(Self { class: class.into(), id })
    }
}

/// Whether a class may have this name: it consists of class characters and symbols such as emoji, or of signs only.
fn is_class(name: &str) -> bool {
    let visible = !name.chars().any(|c| c.is_whitespace() || c.is_control());
    let signs = !name.chars().any(char::is_alphanumeric);
    !name.is_empty() && visible && (signs || name.chars().all(|c| is_class_char(c) || !c.is_ascii()))
}

/// Characters a class name may contain.
pub(crate) fn is_class_char(c: char) -> bool {
    c.is_alphanumeric() || c == '_' || c == '-'
}
