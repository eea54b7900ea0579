//! Small things where people keep them.

use vc_graph::Seed;

use crate::apartment::Apartment;

pub(crate) fn fill(_home: &mut Apartment, _amount: f32, _seed: Seed) {}
