//! The specification of an apartment on the command line.

use clap::Args;
use virtualcity::procgen::Specification;

use crate::support::Complaint;

/// Properties of the apartment; unspecified ones are sampled from the seed.
#[derive(Args, Clone, Default, serde::Serialize)]
pub(crate) struct Wishes {
    /// One room for living, sleeping and cooking: as --bedrooms 0.
    #[arg(long, conflicts_with = "bedrooms")]
    #[serde(skip)]
    pub(crate) studio: bool,
    /// Bedrooms, 0 to 6.
    #[arg(long)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) bedrooms: Option<usize>,
    /// Bathrooms, 1 to 4.
    #[arg(long)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) bathrooms: Option<usize>,
    /// Net area of all rooms except balconies, square metres.
    #[arg(long)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) area: Option<f32>,
    /// Balconies, 0 to 3.
    #[arg(long)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) balconies: Option<usize>,
    /// A kitchen open to the living room; =false for a closed one.
    #[arg(long, num_args = 0..=1, require_equals = true, default_missing_value = "true")]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) open_kitchen: Option<bool>,
    /// A study; =false for none.
    #[arg(long, num_args = 0..=1, require_equals = true, default_missing_value = "true")]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) study: Option<bool>,
    /// A laundry; =false for none.
    #[arg(long, num_args = 0..=1, require_equals = true, default_missing_value = "true")]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) laundry: Option<bool>,
    /// A store room; =false for none.
    #[arg(long, num_args = 0..=1, require_equals = true, default_missing_value = "true")]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) storage: Option<bool>,
    /// A separate toilet; =false for none.
    #[arg(long, num_args = 0..=1, require_equals = true, default_missing_value = "true")]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) wc: Option<bool>,
    /// Amount of clutter: small objects lying around, 0 to 1.
    #[arg(long)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) clutter: Option<f32>,
}

impl Wishes {
    /// The specification.
    ///
    /// # Errors
    /// If a property is out of range; the error names it.
    pub(crate) fn specification(&self) -> Result<Specification, Complaint> {
        let specification = Specification {
            bedrooms: if self.studio { Some(0) } else { self.bedrooms },
            bathrooms: self.bathrooms,
            open_kitchen: self.open_kitchen,
            study: self.study,
            laundry: self.laundry,
            storage: self.storage,
            wc: self.wc,
            balconies: self.balconies,
            area: self.area,
            style: None,
            clutter: self.clutter,
            dressing: None,
            fitted_kitchens: false,
            facade: None,
            plan: None,
        };
        specification.check().map_err(Complaint::new)?;
        Ok(specification)
    }

    /// The data from which the homes of a set can be reproduced.
    pub(crate) fn recipe(&self) -> Recipe {
        let bedrooms = if self.studio { Some(0) } else { self.bedrooms };
        Recipe { virtualcity: env!("CARGO_PKG_VERSION"), wishes: Self { bedrooms, ..self.clone() } }
    }
}

/// The version and the specification.
#[derive(Clone, serde::Serialize)]
pub(crate) struct Recipe {
    virtualcity: &'static str,
    wishes: Wishes,
}
