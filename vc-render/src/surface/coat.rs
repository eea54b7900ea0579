//! Coats on things: dirt, water and the like.

use vc_graph::{Node, State};

/// A coat that covers a thing evenly and changes its look: dirt, water, a crust, or the flesh of sliced food.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Coat {
    /// Linear reflectance of the coat by colour, 0 to 1.
    pub colour: [f32; 3],
    /// Share of the thing that it covers, 0 to 1.
    pub share: f32,
    /// Factor for the thing's roughness: water makes it smoother.
    pub roughness: f32,
}

/// Coats for states; if a node has several, the first counts.
const STATES: [(State, Coat); 7] = [
    (State::Dirty, Coat { colour: [0.11, 0.075, 0.04], share: 0.45, roughness: 1.4 }),
    (State::Stained, Coat { colour: [0.12, 0.03, 0.02], share: 0.3, roughness: 1.0 }),
    (State::Dusty, Coat { colour: [0.35, 0.33, 0.30], share: 0.4, roughness: 1.5 }),
    (State::Cooked, Coat { colour: [0.16, 0.07, 0.02], share: 0.55, roughness: 1.0 }),
    // The flesh of sliced food.
    (State::Sliced, Coat { colour: [0.72, 0.62, 0.36], share: 0.5, roughness: 0.7 }),
    (State::Frozen, Coat { colour: [0.75, 0.82, 0.88], share: 0.45, roughness: 1.2 }),
    (State::Wet, Coat { colour: [0.0; 3], share: 0.3, roughness: 0.45 }),
];

impl Coat {
    /// No coat.
    pub const NONE: Self = Self { colour: [0.0; 3], share: 0.0, roughness: 1.0 };

    /// The coat for a node's states: dirty, stained, dusty, cooked, sliced, frozen, wet.
    pub fn from_node(node: &Node) -> Self {
        STATES.iter().find(|(state, _)| node.is(*state)).map_or(Self::NONE, |(_, coat)| *coat)
    }

    /// The coat with its numbers clamped to their ranges; a NaN becomes zero.
    pub(crate) fn sound(self) -> Self {
        let unit = |v: f32| if v.is_nan() { 0.0 } else { v.clamp(0.0, 1.0) };
        let roughness = if self.roughness.is_finite() { self.roughness.max(0.0) } else { 1.0 };
        Self { colour: self.colour.map(unit), share: unit(self.share), roughness }
    }

    /// The colour of a surface under this coat.
    #[inline(always)]
    pub(crate) fn over(&self, colour: [f32; 3]) -> [f32; 3] {
        crate::math::three(|i| colour[i] + (self.colour[i] - colour[i]) * self.share)
    }

    /// The roughness of a surface under this coat.
    #[inline(always)]
    pub(crate) fn rough(&self, roughness: f32) -> f32 {
        if self.share > 0.0 { (roughness * self.roughness).clamp(0.02, 1.0) } else { roughness }
    }
}
