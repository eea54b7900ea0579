//! The search for a free spot on the surfaces of a thing, one way of putting things down after the other.

use nalgebra::{Point3, UnitQuaternion};
use rapier3d::geometry::SharedShape;
use vc_graph::asset::Hold;
use vc_graph::{NodeId, Pose, Seed};

use super::raster::{PITCH, half_sides, is_burner, spots};
use super::way::{ACROSS, HEAP, INTO, ONTO, Tip, Way};
use super::{AROUND, GAP, SupportSurface};
use crate::displaced::NONE;
use crate::state::Thing;
use crate::world::PhysicsWorld;
use crate::{BodyRole, PhysicsError, convert};

/// The order in which the spots of a surface are tried.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum SpotOrder {
    /// The middle first.
    Middle,
    /// Nearest to a point first.
    Near(Point3<f32>),
    /// At random, from a seed.
    Random(Seed),
}

/// How close things are put to those that are there.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Packing {
    /// Apart, so that the boxes around things are clear of each other, and close only if no such spot is left.
    Apart,
    /// Close, as people make room on a full table: room is asked for the outline of a thing, not for the box around it,
    /// on a raster of two centimetres. On top of things it may be anywhere over the top that bears it, also beyond the
    /// rectangle that its asset states: near the edge of a round table.
    Close,
    /// A little above the contents of a container: the thing is let down onto them.
    Heaped,
}

/// A search for a free spot at which a thing can be put on or into another one.
///
/// The first surface of the other thing that has such a spot is taken: an inner one, or one on top. A thing that does
/// not stand in a container is laid on its side; a thing that is wider than a surface is put on the middle of it and
/// reaches over its edges. Spots are tried on a grid of four centimetres or coarser; each costs some microseconds.
///
/// ```
/// # let home = vc_testkit::kitchen::kitchen();
/// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
/// use vc_physics::{SpotOrder, SpotSearch};
/// world.put_open(home.cabinet, None, 1.0)?;
/// let search = SpotSearch::new(home.cup, home.cabinet, true).order(SpotOrder::Middle);
/// let spot = search.find(&world)?.ok_or("the drawer is full")?;
/// world.place(home.cup, spot)?;
/// assert!(world.body(home.cup)?.is_at(home.cabinet, true));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpotSearch {
    pub(super) id: NodeId,
    pub(super) at: NodeId,
    pub(super) inside: bool,
    pub(super) order: SpotOrder,
    packing: Packing,
}

impl SpotSearch {
    /// A search for a spot for a thing at another one: inside it, or on top. The middle is tried first, and things are
    /// put apart.
    pub fn new(id: NodeId, at: NodeId, inside: bool) -> Self {
        Self { id, at, inside, order: SpotOrder::Middle, packing: Packing::Apart }
    }

    /// The same search with the spots tried in another order.
    #[must_use]
    pub fn order(self, order: SpotOrder) -> Self {
        Self { order, ..self }
    }

    /// The same search for a spot that is so close to what is there.
    #[must_use]
    pub fn packing(self, packing: Packing) -> Self {
        Self { packing, ..self }
    }

    /// The first free spot: the pose of the thing, clear of everything. `None` if no spot is free.
    ///
    /// # Errors
    /// [`PhysicsError::NoBody`].
    pub fn find(&self, world: &PhysicsWorld) -> Result<Option<Pose>, PhysicsError> {
        self.find_where(world, |_| true)
    }

    /// As [`Self::find`], at a spot that satisfies a condition, which is tested last.
    ///
    /// # Errors
    /// [`PhysicsError::NoBody`].
    pub fn find_where(
        &self,
        world: &PhysicsWorld,
        admits: impl Fn(&Pose) -> bool,
    ) -> Result<Option<Pose>, PhysicsError> {
        let (thing, below) = (world.thing(self.id)?, world.thing(self.at)?);
        let by = |ways: &[Way]| world.spot_by(ways, (thing, below), self.hold(), self.order, &admits);
        let close = || world.packed_spot(thing, below, self.hold(), self.order, &admits);
        Ok(match self.packing {
            Packing::Apart => by(self.ways()).or_else(close),
            Packing::Close => close(),
            Packing::Heaped => by(&HEAP),
        })
    }

    pub(super) fn hold(&self) -> Hold {
        if self.inside { Hold::Inside } else { Hold::On }
    }

    pub(super) fn ways(&self) -> &'static [Way] {
        if self.inside { &INTO } else { &ONTO }
    }
}

impl PhysicsWorld {
    fn spot_by(
        &self,
        ways: &[Way],
        (thing, below): (&Thing, &Thing),
        hold: Hold,
        order: SpotOrder,
        admits: &dyn Fn(&Pose) -> bool,
    ) -> Option<Pose> {
        let mut shelves = self.surfaces_that(below, hold);
        // A thing that is put on a stove goes to a free burner, not beside a thing on another one.
        shelves.sort_by_cached_key(|shelf| is_burner(shelf) && !self.is_bare(shelf));
        let mut spots = ways.iter().flat_map(|way| shelves.iter().map(move |shelf| (way, shelf)));
        spots.find_map(|(way, shelf)| self.spot_among(thing, shelf, way, order, admits))
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
        let clear = |spot: &Pose| self.is_clear(thing, shelf, spot);
        let loose = |id| self.is_loose_on(shelf, id);
        let first = |free: &dyn Fn(&Pose) -> bool| self.first_spot(thing, shelf, way, order, free, admits);
        let apart = first(&|spot| clear_around(spot, &|_| true) && clear(spot));
        apart.or_else(|| first(&|spot| clear(spot) && clear_around(spot, &loose)))
    }

    /// Whether a thing at a spot of a surface overlaps nothing, and stands on nothing else.
    pub(super) fn is_clear(&self, thing: &Thing, shelf: &SupportSurface, spot: &Pose) -> bool {
        self.for_obstacles(thing, shelf, spot, &mut |_| false)
    }

    /// Calls `found` for each thing that a thing at a spot of a surface would overlap, or stand on: also for a sheet on the
    /// surface that is no thicker than the gap above which things are put. Until it returns false; returns whether it never did.
    pub(super) fn for_obstacles(
        &self,
        thing: &Thing,
        shelf: &SupportSurface,
        spot: &Pose,
        found: &mut dyn FnMut(NodeId) -> bool,
    ) -> bool {
        let down = Pose::translation(0.0, 0.0, -GAP) * spot;
        self.for_overlaps(thing, spot, found)
            && self.for_overlaps(thing, &down, &mut |id| !self.is_loose_on(shelf, id) || found(id))
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
    let half = half_sides((low, high), &own.rotation);
    let middle = own * nalgebra::center(&low, &high);
    let over = (middle.x.abs() + half.x - shelf.half.0).max(middle.y.abs() + half.y - shelf.half.1);
    (100.0 * over.max(0.0)).round() as u32
}
