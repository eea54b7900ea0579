//! Whether a thing is inside another: in a cavity of a container, or in the hull of a thing that has none.

use nalgebra::Vector3;
use vc_graph::Aabb;

use crate::body::Body;
use crate::solid::Round;
use crate::threshold::{CORNER_SHARE, CORNERS_WITHIN, RIM_MARGIN, ROUND_CORNER_SHARE, SUPPORT_SINK, SUPPORT_TIE};

/// Whether a container holds a content. The building holds nothing.
pub(crate) fn holds(container: &Body, content: &Body) -> bool {
    let centre = Aabb { min: content.whole.centre.into(), max: content.whole.centre.into() };
    container.region.grown(RIM_MARGIN, RIM_MARGIN).meets(&centre)
        && !container.traits.fixed
        && !content.traits.fixed
        && container.cavity_with(content).is_some()
}

/// Whether one body is in the hull of another, does not begin lower, and is not just a thin layer at its
/// bottom: books in a shelf that nearly reach the board above do not carry it.
pub(crate) fn is_within(inner: &Body, outer: &Body) -> bool {
    let own = outer.whole.axes.tr_mul(&(inner.whole.centre - outer.whole.centre)).abs();
    own.x <= outer.whole.half.x
        && own.y <= outer.whole.half.y
        && own.z <= outer.whole.half.z
        && inner.base() >= outer.base() - SUPPORT_TIE
        && inner.region.max.z >= outer.base() + SUPPORT_SINK
}

impl Body {
    /// The cavity of this body that contains another body: its centre, and half of its corners.
    pub(crate) fn cavity_with(&self, content: &Self) -> Option<usize> {
        let own = Some(self.to_own(&content.whole.centre)).filter(|own| self.form.may_hold(own))?;
        let half = CORNERS_WITHIN as usize;
        (0..self.form.cavities().len())
            .find(|&index| self.has_centre(index, &own) && self.corners_within(index, content).nth(half - 1).is_some())
    }

    /// Whether a point of the asset's frame is in a cavity, or a little above its rim.
    fn has_centre(&self, cavity: usize, own: &Vector3<f32>) -> bool {
        let cavity = &self.form.cavities()[cavity];
        cavity.contains(&self.before_motion(cavity.link, *own), RIM_MARGIN / self.scale.z.max(1e-3))
    }

    /// The corners of a content's box that are in a cavity.
    fn corners_within(&self, cavity: usize, content: &Self) -> impl Iterator<Item = Vector3<f32>> {
        let cavity = &self.form.cavities()[cavity];
        let own = move |c: Vector3<f32>| self.before_motion(cavity.link, self.to_own(&c));
        let corners = content.whole.corners(content.corner_share());
        corners.into_iter().map(own).filter(|own| cavity.admits(own))
    }

    /// For each cavity, whether it contains a content's centre, and how many of its corners.
    pub(crate) fn cavities_with(&self, content: &Self) -> Vec<(bool, u32)> {
        let own = self.to_own(&content.whole.centre);
        let judge = |index| (self.has_centre(index, &own), self.corners_within(index, content).count() as u32);
        (0..self.form.cavities().len()).map(judge).collect()
    }

    fn corner_share(&self) -> f32 {
        let round = self.solids.iter().all(|s| s.round != Round::No);
        if round { ROUND_CORNER_SHARE } else { CORNER_SHARE }
    }
}
