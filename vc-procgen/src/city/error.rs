//! The reasons why a city cannot be generated.

use vc_map::MapError;

/// A city that cannot be generated.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CityPlanError {
    /// A number of the specification is out of its range.
    #[error("{what} is {value}{unit}, it must be from {least} to {most}")]
    OutOfRange {
        /// The quantity.
        what: &'static str,
        /// Its unit, with a space before it.
        unit: &'static str,
        /// Its value.
        value: f64,
        /// The least that is allowed.
        least: f64,
        /// The most.
        most: f64,
    },
    /// The streets do not make a map.
    #[error(transparent)]
    Map(#[from] MapError),
}
