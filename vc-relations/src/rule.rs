//! The rule that decides.

/// A rule by which relations are read from geometry.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum RelationRule {
    /// The traces of parts, joints and contacts, as defined on the front page.
    #[default]
    Contacts,
    /// The thesis's six box traces, to the letter.
    BoxTrace,
    /// VirtualHome's definitions, on world-aligned boxes.
    VirtualHome,
}
