//! The set of nodes that an agent has seen.

use vc_graph::NodeId;

/// A set of nodes, stored as bits by node number.
///
/// ```
/// use vc_graph::NodeId;
/// use vc_planner::KnownNodes;
/// let mut known = KnownNodes::default();
/// assert!(known.insert(NodeId(3)) && !known.insert(NodeId(3)));
/// assert!(known.contains(NodeId(3)) && !known.contains(NodeId(4)));
/// ```
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct KnownNodes {
    bits: Vec<u64>,
    /// Numbers too large for the bits.
    rest: Vec<NodeId>,
}

/// Numbers below this are stored as bits: 512 KiB at most.
const DENSE: u32 = 1 << 22;

impl KnownNodes {
    /// Whether a node has been seen.
    pub fn contains(&self, id: NodeId) -> bool {
        if id.0 >= DENSE {
            return self.rest.binary_search(&id).is_ok();
        }
        self.bits.get(id.0 as usize / 64).is_some_and(|word| word >> (id.0 % 64) & 1 == 1)
    }

    /// Adds a node; `false` if it was present.
    pub fn insert(&mut self, id: NodeId) -> bool {
        if id.0 >= DENSE {
            let Err(position) = self.rest.binary_search(&id) else { return false };
            self.rest.insert(position, id);
            return true;
        }
        let word = id.0 as usize / 64;
        if word >= self.bits.len() {
            self.bits.resize(word + 1, 0);
        }
        let before = self.bits[word];
        self.bits[word] |= 1 << (id.0 % 64);
        before != self.bits[word]
    }
}

impl KnownNodes {
    /// Removes a node.
    pub(crate) fn remove(&mut self, id: NodeId) {
        if let Some(word) = self.bits.get_mut(id.0 as usize / 64) {
            *word &= !(1 << (id.0 % 64));
        }
        self.rest.retain(|other| *other != id);
    }
}

impl FromIterator<NodeId> for KnownNodes {
    fn from_iter<I: IntoIterator<Item = NodeId>>(ids: I) -> Self {
        let mut known = Self::default();
        for id in ids {
            known.insert(id);
        }
        known
    }
}
