//! The rule that decides.

/// A rule by which relations are read from geometry.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum Rule {
    /// The repaired traces, as defined on the front page.
    #[default]
    Repaired,
    /// The thesis's six box traces, to the letter.
    BoxTrace,
    /// VirtualHome's definitions, on world-aligned boxes.
    VirtualHome,
}
