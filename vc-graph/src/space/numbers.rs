//! Blocks of node numbers.

use crate::NodeId;

/// Consecutive node numbers. Each region has a block, fixed when the world is planned; a number says in which region a
/// node was made, not where it is.
///
/// ```
/// use vc_graph::NodeId;
/// use vc_graph::space::NumberBlock;
/// let block = NumberBlock { first: 100, count: 50 };
/// assert!(block.has(NodeId(149)) && !block.has(NodeId(150)));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize)]
pub struct NumberBlock {
    /// The first number.
    pub first: u32,
    /// How many numbers there are.
    pub count: u32,
}

impl NumberBlock {
    /// All numbers: those of a scene that stands alone.
    pub const ALL: Self = Self { first: 1, count: u32::MAX };
    /// The numbers that go to regions whose block is full.
    pub const OVERFLOW: Self = Self { first: 0xC000_0000, count: 0x2000_0000 };

    /// The numbers of agents, who go from region to region.
    pub const TRAVELLERS: Self = Self { first: 0xE000_0000, count: 0x1000_0000 };

    /// Whether a number is in the block.
    pub fn has(self, id: NodeId) -> bool {
        self == Self::ALL || id.0.checked_sub(self.first).is_some_and(|place| place < self.count)
    }

    /// The number after the last.
    pub fn end(self) -> u32 {
        self.first.saturating_add(self.count)
    }
}
