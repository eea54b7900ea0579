//! The reasons why there is no scene of a place.

/// A place of which no scene can be made.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum OutdoorsError {
    /// The reach is no distance, or too far.
    #[error("a scene cannot reach {0} m: use a distance up to 2,000 m")]
    Reach(f64),
    /// The place is on no map.
    #[error("there is no place ({0}, {1}): coordinates are metres from the origin of the city's map")]
    Place(f64, f64),
}
