//! The search for a free spot on the surfaces of a thing, one way of putting things down after the other.

use nalgebra::{Point3, UnitQuaternion};
use rapier3d::geometry::SharedShape;
use vc_graph::asset::Hold;
use vc_graph::{NodeId, Pose};

use super::raster::{PITCH, is_burner, spots};
use super::way::{ACROSS, Tip, Way};
use super::{AROUND, SpotOrder, SupportSurface};
use crate::displaced::NONE;
use crate::state::Thing;
use crate::world::PhysicsWorld;
use crate::{BodyRole, PhysicsError, convert};

impl PhysicsWorld {
    pub(super) fn spot_by(
        &self,
        ways: &[Way],
        id: NodeId,
        at: NodeId,
        hold: Hold,
        order: SpotOrder,
        admits: &dyn Fn(&Pose) -> bool,
    ) -> Result<Option<Pose>, PhysicsError> {
        let (thing, below) = (self.thing(id)?, self.thing(at)?);
        let mut shelves = self.surfaces_that(below, hold);
        // A thing that is put on a stove goes to a free burner, not beside a thing on another one.
        shelves.sort_by_cached_key(|shelf| is_burner(shelf) && !self.is_bare(shelf));
        let mut spots = ways.iter().flat_map(|way| shelves.iter().map(move |shelf| (way, shelf)));
        Ok(spots.find_map(|(way, shelf)| self.spot_among(thing, shelf, way, order, admits)))
    }

    /// The first free spot on a surface for a thing that is put there in a given way: a spot where the box around
    /// the thing is free too, if there is one, as a plate does not stand under another's rim. On top of things, that
    /// box has to be free at least of loose things.
    fn spot_among(
        &self,
        thing: &Thing,
        shelf: &SupportSurface,
        way: &Way,
        order: SpotOrder,
        admits: &dyn Fn(&Pose) -> bool,
    ) -> Option<Pose> {
        let (low, high) = thing.form.extent;
        let half = (high - low) / 2.0;
        let around = SharedShape::cuboid(half.x + AROUND, half.y + AROUND, half.z);
        let middle = convert::pose(&Pose::from_parts(nalgebra::center(&low, &high).into(), UnitQuaternion::identity()));
        let clear_around = |spot: &Pose, of: &dyn Fn(NodeId) -> bool| {
            self.each_overlap((&around, &(convert::pose(spot) * middle)), thing.id, &NONE, &mut |id| !of(id))
        };
        let clear = |spot: &Pose| self.is_clear(thing, spot);
        let loose = |id| self.is_loose_on(shelf, id);
        let first = |free: &dyn Fn(&Pose) -> bool| self.first_spot(thing, shelf, way, order, free, admits);
        let apart = first(&|spot| clear_around(spot, &|_| true) && clear(spot));
        apart.or_else(|| first(&|spot| clear(spot) && clear_around(spot, &loose)))
    }

    /// Whether a thing is loose, other than the one of a surface on top of which things are put.
    pub(super) fn is_loose_on(&self, shelf: &SupportSurface, id: NodeId) -> bool {
        shelf.hold == Hold::On && id != shelf.id && self.role(id) == Some(BodyRole::Loose)
    }

    /// The first spot that is free and admitted.
    fn first_spot(
        &self,
        thing: &Thing,
        shelf: &SupportSurface,
        way: &Way,
        order: SpotOrder,
        free: &dyn Fn(&Pose) -> bool,
        admits: &dyn Fn(&Pose) -> bool,
    ) -> Option<Pose> {
        let Way { heights, over, across, .. } = way;
        if !way.is_for(thing.form.extent, shelf) {
            return None;
        }
        // A thing that reaches over the edges is balanced, and a burner takes things on its middle.
        let order = if *over > 0.0 || is_burner(shelf) { SpotOrder::Middle } else { order };
        let (low, high) = thing.form.extent;
        let turns = self.turns_of(thing, way);
        // A thing that is heaped higher than the rim is not inside.
        let rim = self.aabb(shelf.id).map_or(f32::INFINITY, |b| b.max.z - shelf.pose.translation.z);
        let within = |height: &&f32| **height == 0.0 || **height < rim;
        heights.iter().filter(within).find_map(|&height| {
            let lifted = |turn| spots((low, high), shelf, turn, (height, *over), PITCH, order);
            let carried = |spot: &Pose| !across || self.is_just_over(thing, spot, shelf.id);
            let found = |mut spots: Vec<Pose>| spots.drain(..).find(|spot| free(spot) && carried(spot) && admits(spot));
            if *over == 0.0 {
                return turns.iter().find_map(|turn| found(lifted(turn)));
            }
            // A thing that has to reach over the edges does so as little as possible.
            let mut all: Vec<Pose> = turns.iter().flat_map(lifted).collect();
            all.sort_by_key(|spot| overhang((low, high), shelf, spot));
            found(all)
        })
    }

    /// The turns by which a thing may be put down in a given way; a laden thing is not tipped.
    pub(super) fn turns_of(&self, thing: &Thing, way: &Way) -> Vec<UnitQuaternion<f32>> {
        let (low, high) = thing.form.extent;
        let laden = self.is_laden(thing);
        let stands = |tip: &&Tip| **tip == Tip::Upright || !laden && tip.stands(high - low, way.slender);
        way.tips.iter().filter(stands).flat_map(|tip| tip.turns()).collect()
    }

    /// Whether a thing at a spot is no more than one step of [`ACROSS`] above another, and above nothing else.
    fn is_just_over(&self, thing: &Thing, spot: &Pose, at: NodeId) -> bool {
        let lower = Pose::translation(0.0, 0.0, -ACROSS[0]) * spot;
        let mut touched = false;
        let only = self.for_overlaps(thing, &lower, &mut |id| {
            touched |= id == at;
            id == at
        });
        touched && only
    }

    /// Whether there is something on or in a thing that would fall off it or run out.
    fn is_laden(&self, thing: &Thing) -> bool {
        let full = self.waters.level(thing.id) > 0.0;
        full || self.is_held_with_load(thing.id) || !self.load_of(thing.state.base).is_empty()
    }
}

/// How far a thing between two corners reaches over an edge of a surface at a spot, at most, centimetres.
fn overhang((low, high): (Point3<f32>, Point3<f32>), shelf: &SupportSurface, spot: &Pose) -> u32 {
    let own = shelf.pose.inverse() * spot;
    let half = own.rotation.to_rotation_matrix().matrix().abs() * (high - low) / 2.0;
    let middle = own * nalgebra::center(&low, &high);
    let over = (middle.x.abs() + half.x - shelf.half.0).max(middle.y.abs() + half.y - shelf.half.1);
    (100.0 * over.max(0.0)).round() as u32
}
