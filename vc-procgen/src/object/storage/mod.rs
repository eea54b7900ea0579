//! Cases.

pub(super) mod case;
pub(super) mod chest;

use super::Generator;

pub(super) const GENERATORS: &[Generator] = &[];
