//! Checks whether a house is sound: every violation, with the regions and nodes it concerns.

use super::House;
use crate::building::{BuildingViolation, overlaps, sound};

impl House {
    /// Lists every violation; a house that was generated has none. Makes all its scenes.
    ///
    /// Overlaps with the facade are not looked for: a thing of the street that is askew to the corridor has a larger box than it takes
    /// up.
    ///
    /// ```
    /// use vc_graph::Seed;
    /// use vc_procgen::House;
    /// assert_eq!(House::from_seed(Seed(7))?.violations(), []);
    /// # Ok::<(), vc_procgen::HouseError>(())
    /// ```
    pub fn violations(&self) -> Vec<BuildingViolation> {
        let (mut made, mut found) = sound(self.space(), &self.measures.frame, |region| self.scene(region));
        made.retain(|this| this.region != self.street());
        found.extend(overlaps(&made));
        found
    }
}
