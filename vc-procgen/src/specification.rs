//! The specification of an apartment.

use vc_graph::Seed;
use vc_shapes::Style;
use vc_shapes::material::MaterialId;

use crate::dressing::{Dressing, Household};
use crate::error::SpecificationError;
use crate::plan::FloorPlan;

/// Requirements of an apartment; anything not specified is drawn from the seed.
///
/// ```
/// use vc_procgen::Specification;
/// let two_bedrooms = Specification { bedrooms: Some(2), area: Some(70.0), ..Specification::default() };
/// assert!(two_bedrooms.check().is_ok());
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Specification {
    /// Bedrooms, 0 (a studio) to 6.
    pub bedrooms: Option<usize>,
    /// Bathrooms, 1 to 4 and at most one more than bedrooms.
    pub bathrooms: Option<usize>,
    /// Whether the kitchen is open to the living room.
    pub open_kitchen: Option<bool>,
    /// Whether there is a study.
    pub study: Option<bool>,
    /// Whether there is a laundry.
    pub laundry: Option<bool>,
    /// Whether there is a store room.
    pub storage: Option<bool>,
    /// Whether there is a separate toilet.
    pub wc: Option<bool>,
    /// Balconies, 0 to 3.
    pub balconies: Option<usize>,
    /// Net area of all rooms but balconies, square metres, 15 to 400.
    pub area: Option<f32>,
    /// The style.
    pub style: Option<Style>,
    /// The material of outer walls as seen from outside; drawn without one.
    pub facade: Option<MaterialId>,
    /// The amount of clutter, 0 (tidy and bare) to 1; 0.6 by default.
    pub clutter: Option<f32>,
    /// The table by which rooms are dressed; without one, small things lie where the class table keeps them.
    pub dressing: Option<Dressing>,
    /// Whether kitchens are fitted where there is space: units made to measure, of one design, along up to three walls. Not by default.
    pub fitted_kitchens: bool,
    /// A floor plan that is furnished as it is: of a [site](crate::plan::Site), or one's own. Rooms and areas are the plan's then, and
    /// are not specified beside it.
    pub plan: Option<FloorPlan>,
}

impl Specification {
    /// A studio: one room for living, sleeping and cooking.
    pub fn studio() -> Self {
        Self { bedrooms: Some(0), ..Self::default() }
    }

    /// An apartment with the given number of bedrooms.
    ///
    /// ```
    /// use vc_procgen::Specification;
    /// assert!(Specification::with_bedrooms(3).check().is_ok());
    /// assert_eq!(Specification::studio(), Specification::with_bedrooms(0));
    /// ```
    pub fn with_bedrooms(bedrooms: usize) -> Self {
        Self { bedrooms: Some(bedrooms), ..Self::default() }
    }

    /// Checks that every number is within its range.
    ///
    /// ```
    /// use vc_procgen::Specification;
    /// let error = Specification::with_bedrooms(9).check().unwrap_err();
    /// assert_eq!(error.to_string(), "bedrooms is 9, it must be from 0 to 6");
    /// ```
    ///
    /// # Errors
    /// [`SpecificationError::OutOfRange`] names the number; [`SpecificationError::BadPlan`] and [`SpecificationError::Planned`] where a
    /// plan is given that has a fault or is not alone.
    pub fn check(&self) -> Result<(), SpecificationError> {
        let count = |what, value: Option<usize>, low, high| range(what, value.map(|v| v as f32), low, high);
        count("bedrooms", self.bedrooms, 0.0, 6.0)?;
        let most = self.bedrooms.map_or(4.0, |b| (b as f32 + 1.0).min(4.0));
        count("bathrooms", self.bathrooms, 1.0, most)?;
        count("balconies", self.balconies, 0.0, 3.0)?;
        range("area", self.area, 15.0, 400.0)?;
        range("clutter", self.clutter, 0.0, 1.0)?;
        self.plan.as_ref().map_or(Ok(()), |plan| self.check_plan(plan))
    }

    /// Checks a plan that is given, and that nothing contradicts it.
    fn check_plan(&self, plan: &FloorPlan) -> Result<(), SpecificationError> {
        let specified = [
            ("bedrooms", self.bedrooms.is_some()),
            ("bathrooms", self.bathrooms.is_some()),
            ("open_kitchen", self.open_kitchen.is_some()),
            ("study", self.study.is_some()),
            ("laundry", self.laundry.is_some()),
            ("storage", self.storage.is_some()),
            ("wc", self.wc.is_some()),
            ("balconies", self.balconies.is_some()),
            ("area", self.area.is_some()),
        ];
        match specified.into_iter().find(|(_, is)| *is) {
            Some((what, _)) => Err(SpecificationError::Planned { what }),
            None => plan.fault().map_or(Ok(()), |fault| Err(fault.into())),
        }
    }

    /// The household for whom a plan is dressed.
    pub(crate) fn household(&self, plan: &FloorPlan, style: &Style, seed: Seed) -> Option<Household> {
        self.dressing.as_ref().map(|dressing| Household::draw(dressing, plan, style, seed))
    }
}

fn range(what: &'static str, value: Option<f32>, low: f32, high: f32) -> Result<(), SpecificationError> {
    match value {
        // Written so that NaN is an error, too.
        Some(value) if !(value >= low && value <= high) => {
            Err(SpecificationError::OutOfRange { what, value, low, high })
        }
        _ => Ok(()),
    }
}
