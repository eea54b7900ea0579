//! Spots close to what is there already, as people make room on a full table.

use nalgebra::{Point2, Point3, UnitQuaternion, Vector3};
use rapier3d::geometry::{Collider, ColliderHandle, SharedShape};
use rapier3d::pipeline::QueryFilter;
use vc_geometry::outline::hull;
use vc_graph::asset::Hold;
use vc_graph::{NodeId, Pose};

use super::raster::spots;
use super::way::{INTO, WITHIN, Way};
use super::{GAP, SpotOrder, SupportSurface};
use crate::displaced::NONE;
use crate::state::Thing;
use crate::world::PhysicsWorld;
use crate::{convert, group};

/// Distance of the spots that are tried, metres.
const PITCH: f32 = 0.02;
/// Room that is left around the outline of a thing, metres.
const AROUND: f32 = 0.002;
/// How much of its half width may be over the edges of a top.
const OVER: f32 = 0.4;
/// Part of its half width within which the corners of what is put on a top lie over it.
const BORNE: f32 = 0.5;
/// How far below what stands on a top the top is looked for, metres.
const BELOW: f32 = 0.004;
/// How things are put on others.
const ONTO: [Way; 1] = [Way { over: OVER, ..WITHIN }];

impl PhysicsWorld {
    /// The first free spot that is close to what is there as it stands.
    pub(super) fn packed_spot(
        &self,
        thing: &Thing,
        below: &Thing,
        hold: Hold,
        order: SpotOrder,
        admits: &dyn Fn(&Pose) -> bool,
    ) -> Option<Pose> {
        let ways = if hold == Hold::Inside { &INTO[..] } else { &ONTO[..] };
        let shelves = self.surfaces_that(below, hold);
        let mut all = ways.iter().flat_map(|way| shelves.iter().map(move |shelf| (way, shelf)));
        all.find_map(|(way, shelf)| self.packed_spot_among(thing, shelf, way, order, admits))
    }

    fn packed_spot_among(
        &self,
        thing: &Thing,
        shelf: &SupportSurface,
        way: &Way,
        order: SpotOrder,
        admits: &dyn Fn(&Pose) -> bool,
    ) -> Option<Pose> {
        let whole = self.whole_top(shelf);
        let borne = |spot: &Pose| shelf.hold != Hold::On || self.is_borne(thing, spot, shelf.id);
        self.turns_of(thing, way).iter().find_map(|turn| {
            let column = column(thing, turn)?;
            let free = |spot: &Pose| {
                let at = convert::pose(spot);
                borne(spot)
                    && self.is_clear(thing, shelf, spot)
                    && self.each_overlap((&column, &at), thing.id, &NONE, &mut |id| !self.is_loose_on(shelf, id))
            };
            spots(thing.form.extent, &whole, turn, (0.0, way.over), PITCH, order)
                .into_iter()
                .find(|spot| free(spot) && admits(spot))
        })
    }

    /// A top as far as the box of its thing reaches; a surface inside is what it is.
    pub(super) fn whole_top(&self, shelf: &SupportSurface) -> SupportSurface {
        let mut whole = shelf.clone();
        let base = self.thing(shelf.id).ok().and_then(|thing| Some((thing, self.engine.pose(thing.state.base)?)));
        if let Some((thing, base)) = base.filter(|_| shelf.hold == Hold::On) {
            let (low, high) = thing.form.extent;
            let centre = Point3::from((base.inverse() * shelf.pose).translation.vector);
            let reach = |axis: usize| (high[axis] - centre[axis]).max(centre[axis] - low[axis]);
            whole.half = (shelf.half.0.max(reach(0)), shelf.half.1.max(reach(1)));
        }
        whole
    }

    /// Whether a thing that stands at a spot is over the top of another: its middle, and points halfway to the
    /// corners of its box.
    pub(super) fn is_borne(&self, thing: &Thing, spot: &Pose, by: NodeId) -> bool {
        let (low, high) = thing.form.extent;
        let (middle, half) = (nalgebra::center(&low, &high), (high - low) * (BORNE / 2.0));
        let filter = |_: ColliderHandle, c: &Collider| group::marked(c.user_data).0 == by;
        let queries = self.engine.queries(QueryFilter::default().exclude_sensors().predicate(&filter));
        [(0.0, 0.0), (1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)].into_iter().all(|(x, y)| {
            let point = spot * Point3::new(middle.x + x * half.x, middle.y + y * half.y, low.z - GAP - BELOW);
            queries.intersect_point(convert::point(point)).next().is_some()
        })
    }
}

/// The room that a thing takes up as it is turned, from above, over all of its height: a hull in its own frame.
fn column(thing: &Thing, turn: &UnitQuaternion<f32>) -> Option<SharedShape> {
    let corners = thing.form.links.iter().flat_map(|link| link.hulls().iter().flatten());
    let points: Vec<Point3<f32>> = corners.map(|corner| turn * corner).collect();
    let (low, high) = points.iter().fold((f32::INFINITY, f32::NEG_INFINITY), |(l, h), p| (l.min(p.z), h.max(p.z)));
    let outline = hull(points.iter().map(Point3::xy));
    let middle = outline.iter().fold(Point2::origin(), |sum, p| sum + p.coords / outline.len() as f32);
    let wider = |p: &Point2<f32>| p + (p - middle).try_normalize(1e-6).unwrap_or_default() * AROUND;
    let wider: Vec<Point2<f32>> = outline.iter().map(wider).collect();
    let end = |z: f32| wider.iter().map(move |p| turn.inverse() * Vector3::new(p.x, p.y, z));
    let corners: Vec<_> = end(low).chain(end(high)).map(convert::vector).collect();
    SharedShape::convex_hull(&corners)
}
