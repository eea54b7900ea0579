//! To be filled.

use super::Generator;

pub(super) const GENERATORS: &[Generator] = &[];
