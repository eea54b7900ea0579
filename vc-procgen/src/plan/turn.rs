//! Rotations and mirrorings of plans.

use super::rect;
use super::{FloorPlan, PlanOpening};

impl FloorPlan {
    /// The plan in one of its eight orientations, with its south-west corner at the origin. The
    /// bits of `way`: 1 mirrors X, 2 mirrors Y, 4 then swaps them.
    ///
    /// ```
    /// use vc_graph::Seed;
    /// use vc_procgen::Specification;
    /// use vc_procgen::plan::FloorPlan;
    /// let plan = FloorPlan::generate(&Specification::default(), Seed(3))?;
    /// assert_eq!(plan.turned(1).turned(1), plan.turned(0));
    /// # Ok::<(), vc_procgen::SpecificationError>(())
    /// ```
    #[must_use]
    pub fn turned(&self, way: usize) -> Self {
        let mut plan = self.clone();
        rect::turn(&mut plan.rooms, &mut plan.facades, way);
        let hull = rect::turned(self.hull(), way);
        plan.openings.iter_mut().for_each(|o| o.turn(way, (hull.x0, hull.y0)));
        plan
    }
}

impl PlanOpening {
    /// Applies an orientation, then moves `origin` to zero.
    fn turn(&mut self, way: usize, origin: (i32, i32)) {
        if way & 1 != 0 {
            self.mirror(self.vertical);
        }
        if way & 2 != 0 {
            self.mirror(!self.vertical);
        }
        self.vertical ^= way & 4 != 0;
        let (across, along) = if self.vertical { origin } else { (origin.1, origin.0) };
        self.at -= across;
        self.from -= along;
        self.to -= along;
    }

    /// Mirrors it across its wall, or along it.
    fn mirror(&mut self, across: bool) {
        if across {
            self.at = -self.at;
            std::mem::swap(&mut self.low, &mut self.high);
            self.opens_high ^= true;
        } else {
            (self.from, self.to) = (-self.to, -self.from);
            self.hinge_low ^= true;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Specification;
    use vc_graph::Seed;

    #[test]
    fn openings_stay_in_their_walls() {
        for seed in 0..20 {
            let Ok(plan) = FloorPlan::generate(&Specification::default(), Seed(seed)) else { continue };
            for way in 0..8 {
                let turned = plan.turned(way);
                let edges = turned.boundaries();
                let indoors = turned.openings.iter().filter(|o| o.low.is_some() && o.high.is_some());
                for opening in indoors.filter(|o| o.kind != crate::plan::OpeningKind::BalconyDoor) {
                    let within = |e: &crate::plan::Boundary| {
                        (e.vertical, e.at, e.low, e.high) == (opening.vertical, opening.at, opening.low, opening.high)
                            && e.from <= opening.from
                            && e.to >= opening.to
                    };
                    assert!(edges.iter().any(within), "seed {seed} way {way}: {opening:?}");
                }
            }
        }
    }
}
