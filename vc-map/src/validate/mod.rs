//! Checks of maps: every violation, with its place.

mod conflicts;
mod lanes;
mod places;
mod roads;
mod signals;
mod text;
mod violation;
mod walk;

use crate::{JunctionId, StreetMap};

pub use conflicts::{missing_conflicts, short_clearances, unsafe_phases};
pub use violation::MapViolation;

impl StreetMap {
    /// Everything that is wrong with the map, in the order of its parts. A real map has some: streets that the edge cuts off.
    /// Costs a few milliseconds for each square kilometre, most of it for the movements of each junction against each other.
    ///
    /// ```
    /// use vc_map::{Control, CrossSection, MapDraft, RoadClass, Strip};
    /// let mut draft = MapDraft::new("two ends", 0.0, 0.0);
    /// let ends = [[0.0, 0.0], [100.0, 0.0]].map(|at| draft.junction(at, Control::Priority));
    /// let side = vec![Strip::driving(3.0, 8.3)];
    /// draft.road(ends[0], ends[1], RoadClass::Residential, CrossSection { forward: side.clone(), backward: side, median: 0.0 });
    /// assert_eq!(draft.build()?.validate(), []);
    /// # Ok::<(), vc_map::MapError>(())
    /// ```
    pub fn validate(&self) -> Vec<MapViolation> {
        let mut found = roads::violations(self);
        found.extend(lanes::violations(self));
        for (index, junction) in self.junctions().iter().enumerate() {
            let junction_id = JunctionId::of(index);
            let pairs = missing_conflicts(self, junction_id, &junction.conflicts);
            found.extend(pairs.into_iter().map(|pair| MapViolation::MissingConflict { junction: junction_id, pair }));
        }
        found.extend(signals::violations(self));
        found.extend(walk::violations(self));
        found.extend(places::violations(self));
        found
    }
}
