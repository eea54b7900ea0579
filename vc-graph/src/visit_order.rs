//! The nodes visited on a walk through the graph, in the order of the visits.

use std::collections::BTreeSet;

use crate::NodeId;

/// Number of nodes that are kept without an allocation: support chains are short.
const FEW: usize = 6;

/// An ordered set that is efficient while small and works at any size.
#[derive(Debug, Default)]
pub(crate) struct VisitOrder {
    few: [Option<NodeId>; FEW],
    many: Option<Box<Many>>,
}

/// The nodes beyond the first few.
#[derive(Debug, Default)]
struct Many {
    order: Vec<NodeId>,
    all: BTreeSet<NodeId>,
}

impl VisitOrder {
    /// Adds a node; `false` if it was visited before.
    pub(crate) fn add(&mut self, id: NodeId) -> bool {
        for place in &mut self.few {
            match place {
                Some(met) if *met == id => return false,
                Some(_) => {}
                None => {
                    *place = Some(id);
                    return true;
                }
            }
        }
        let many = self.many.get_or_insert_default();
        let new = many.all.insert(id);
        if new {
            many.order.push(id);
        }
        new
    }

    /// The node at a position in the order of visits.
    pub(crate) fn get(&self, position: usize) -> Option<NodeId> {
        match self.few.get(position) {
            Some(id) => *id,
            None => self.many.as_ref()?.order.get(position - FEW).copied(),
        }
    }

    /// All visited nodes, in order.
    pub(crate) fn into_vec(self) -> Vec<NodeId> {
        let many = self.many.map_or_else(Vec::new, |many| many.order);
        self.few.into_iter().flatten().chain(many).collect()
    }
}
