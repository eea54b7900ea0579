//! Sport.

use super::Generator;

mod gear;
pub(in crate::object) use gear::boot;

pub(super) const GENERATORS: &[Generator] = &[];
