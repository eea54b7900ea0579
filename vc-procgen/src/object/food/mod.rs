//! Food.

use super::Generator;

pub(super) const GENERATORS: &[Generator] = &[];
