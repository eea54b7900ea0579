//! What lies on a thing.

use vc_graph::{Node, State};

/// What lies on a thing and changes how all of it looks: dirt, water, a crust, the flesh of what is cut.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Coat {
    /// Its linear reflectance by colour, 0 to 1.
    pub colour: [f32; 3],
    /// How much of the thing it covers, 0 to 1.
    pub share: f32,
    /// What the thing's roughness is multiplied with: water makes it smoother.
    pub roughness: f32,
}

/// What states look like; of several the first counts.
const STATES: [(State, Coat); 7] = [
    (State::Dirty, Coat { colour: [0.11, 0.075, 0.04], share: 0.45, roughness: 1.4 }),
    (State::Stained, Coat { colour: [0.12, 0.03, 0.02], share: 0.3, roughness: 1.0 }),
    (State::Dusty, Coat { colour: [0.35, 0.33, 0.30], share: 0.4, roughness: 1.5 }),
    (State::Cooked, Coat { colour: [0.16, 0.07, 0.02], share: 0.55, roughness: 1.0 }),
    // The flesh.
    (State::Sliced, Coat { colour: [0.72, 0.62, 0.36], share: 0.5, roughness: 0.7 }),
    (State::Frozen, Coat { colour: [0.75, 0.82, 0.88], share: 0.45, roughness: 1.2 }),
    (State::Wet, Coat { colour: [0.0; 3], share: 0.3, roughness: 0.45 }),
];

impl Coat {
    /// Nothing.
    pub const NONE: Self = Self { colour: [0.0; 3], share: 0.0, roughness: 1.0 };

    /// What a node's states look like: dirty, stained, dusty, cooked, cut, frozen, wet.
    pub fn of(node: &Node) -> Self {
        STATES.iter().find(|(state, _)| node.is(*state)).map_or(Self::NONE, |(_, coat)| *coat)
    }

    /// With sound numbers: what is none is zero.
    pub(crate) fn sound(self) -> Self {
        let unit = |v: f32| if v.is_nan() { 0.0 } else { v.clamp(0.0, 1.0) };
        let roughness = if self.roughness.is_finite() { self.roughness.max(0.0) } else { 1.0 };
        Self { colour: self.colour.map(unit), share: unit(self.share), roughness }
    }

    /// A colour below it.
    #[inline(always)]
    pub(crate) fn over(&self, colour: [f32; 3]) -> [f32; 3] {
        crate::affine::three(|i| colour[i] + (self.colour[i] - colour[i]) * self.share)
    }

    /// A roughness below it.
    #[inline(always)]
    pub(crate) fn rough(&self, roughness: f32) -> f32 {
        if self.share > 0.0 { (roughness * self.roughness).clamp(0.02, 1.0) } else { roughness }
    }
}
