//! Lists that usually hold one element.

use std::ops::Deref;

use vc_graph::NodeId;

/// A list of things that needs no allocation in the usual case of one thing.
#[derive(Debug, Clone)]
pub(crate) enum SmallList {
    One(NodeId),
    Many(Vec<NodeId>),
}

impl SmallList {
    pub(crate) const NONE: Self = Self::Many(Vec::new());

    pub(crate) fn push(&mut self, id: NodeId) {
        match self {
            Self::Many(all) if all.is_empty() => *self = Self::One(id),
            Self::Many(all) => all.push(id),
            Self::One(first) => *self = Self::Many(vec![*first, id]),
        }
    }

    pub(crate) fn truncate(&mut self, number: usize) {
        match self {
            Self::Many(all) => all.truncate(number),
            Self::One(_) if number == 0 => *self = Self::NONE,
            Self::One(_) => {}
        }
    }
}

impl Deref for SmallList {
    type Target = [NodeId];

    fn deref(&self) -> &[NodeId] {
        match self {
            Self::One(id) => std::slice::from_ref(id),
            Self::Many(all) => all,
        }
    }
}

impl FromIterator<NodeId> for SmallList {
    fn from_iter<I: IntoIterator<Item = NodeId>>(ids: I) -> Self {
        let mut list = Self::NONE;
        ids.into_iter().for_each(|id| list.push(id));
        list
    }
}
