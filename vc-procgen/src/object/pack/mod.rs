//! Everything in a package: food, drinks, toiletries and cleaning products.

pub(super) mod label;

use super::Generator;

pub(super) const GENERATORS: &[Generator] = &[];
