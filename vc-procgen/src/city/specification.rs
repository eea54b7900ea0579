//! The specification of a city.

use super::error::CityPlanError;
use super::field::StreetPattern;

/// The land at an edge of a city beyond its outermost street.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Waterside {
    /// A promenade, sand and the sea.
    Beach,
    /// A wall above a river.
    Quay,
}

/// The wishes for a city.
///
/// ```
/// use vc_procgen::city::{CityPlan, CitySpecification, StreetPattern};
/// let wishes = CitySpecification { area: 0.3, pattern: Some(StreetPattern::Radial), ..CitySpecification::default() };
/// let plan = CityPlan::generate(&wishes, vc_graph::Seed(7))?;
/// assert_eq!(plan.pattern(), StreetPattern::Radial);
/// # Ok::<(), vc_procgen::city::CityPlanError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct CitySpecification {
    /// The area within its outermost street, square kilometres, 0.2 to 25; 1 by default.
    pub area: f64,
    /// Residents for each square kilometre, 8,000 to 16,000; 15,000 by default. How many there are in the end depends on the
    /// blocks: a fifth more or less, and fewer if parks take the place of houses.
    pub density: f64,
    /// The pattern of its streets; drawn by default.
    pub pattern: Option<StreetPattern>,
    /// The edge of its water; drawn by default.
    pub waterside: Option<Waterside>,
    /// The share of its blocks that are parks, 0.02 to 0.3; 0.08 by default.
    pub parks: f64,
}

impl Default for CitySpecification {
    fn default() -> Self {
        Self { area: 1.0, density: 15_000.0, pattern: None, waterside: None, parks: 0.08 }
    }
}

impl CitySpecification {
    /// Checks that every number is within its range.
    ///
    /// ```
    /// use vc_procgen::city::CitySpecification;
    /// let error = CitySpecification { area: 400.0, ..CitySpecification::default() }.check().unwrap_err();
    /// assert_eq!(error.to_string(), "area is 400 km², it must be from 0.2 to 25");
    /// ```
    ///
    /// # Errors
    /// [`CityPlanError::OutOfRange`].
    pub fn check(&self) -> Result<(), CityPlanError> {
        let ranges = [
            ("area", " km²", self.area, 0.2, 25.0),
            ("density", " residents for each km²", self.density, 8_000.0, 16_000.0),
            ("parks", "", self.parks, 0.02, 0.3),
        ];
        let wrong = ranges.into_iter().find(|(_, _, value, least, most)| !(*least..=*most).contains(value));
        wrong.map_or(Ok(()), |(what, unit, value, least, most)| {
            Err(CityPlanError::OutOfRange { what, unit, value, least, most })
        })
    }
}
