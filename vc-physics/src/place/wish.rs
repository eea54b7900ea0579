//! Spots that somebody asks for: at a point, turned so, on one of the surfaces.

use nalgebra::{Point2, UnitQuaternion, Vector3};
use vc_graph::Pose;
use vc_graph::asset::Hold;

use super::raster::{PITCH, fits, half_sides, spots};
use super::way::Way;
use super::{GAP, SpotFault, SpotOrder, SpotSearch, SupportSurface};
use crate::PhysicsError;
use crate::state::Thing;
use crate::world::PhysicsWorld;

/// How far from a stated height a surface may be, metres: less than shelves are apart.
const LEVEL: f32 = 0.05;
/// How far a thing may stick out over the border of a surface inside a container, metres.
const OUT: f32 = 0.005;

/// A spot that is asked for, as far as it is.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SpotWish {
    /// The point at which the thing's origin is to be, seen from above, metres: on the highest of the surfaces there that
    /// has room, unless a height is stated.
    pub point: Option<Point2<f32>>,
    /// The height of the surface, metres.
    pub height: Option<f32>,
    /// The rotation of the thing.
    pub rotation: Option<UnitQuaternion<f32>>,
    /// The position of the surface among those that hold things the same way.
    pub surface: Option<usize>,
}

impl SpotSearch {
    /// The spot that is asked for, or the reason why there is none. Without a point it is the first free one that a
    /// condition admits, on the surfaces that are meant.
    ///
    /// # Errors
    /// [`PhysicsError::NoBody`].
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// use vc_physics::{SpotFault, SpotSearch, SpotWish};
    /// let at = |x, y| SpotWish { point: Some([x, y].into()), ..SpotWish::default() };
    /// let spot = |wish| SpotSearch::new(home.cup, home.table, false).wished(&world, &wish, |_| true);
    /// let found = spot(at(1.1, 0.3))?.map_err(|fault| format!("{fault:?}"))?;
    /// assert_eq!((found.translation.x, found.translation.y), (1.1, 0.3));
    /// assert_eq!(spot(at(3.0, 0.3))?, Err(SpotFault::OffSurface));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn wished(
        &self,
        world: &PhysicsWorld,
        wish: &SpotWish,
        admits: impl Fn(&Pose) -> bool,
    ) -> Result<Result<Pose, SpotFault>, PhysicsError> {
        let (thing, below) = (world.thing(self.id)?, world.thing(self.at)?);
        let shelves = world.surfaces_that(below, self.hold()).into_iter().enumerate();
        let is_meant = |(index, shelf): &(usize, SupportSurface)| {
            let far = |height: f32| (shelf.pose.translation.z - height).abs();
            wish.surface.is_none_or(|asked| asked == *index) && wish.height.is_none_or(|height| far(height) <= LEVEL)
        };
        let mut shelves: Vec<SupportSurface> = shelves.filter(is_meant).map(|(_, shelf)| shelf).collect();
        if wish.point.is_some() {
            let height = |shelf: &SupportSurface| shelf.pose.translation.z;
            shelves.sort_by(|a, b| height(b).total_cmp(&height(a)));
        }
        let ways = self.ways().iter().filter(|way| !way.across);
        let mut fault = SpotFault::OffSurface;
        for (way, shelf) in ways.flat_map(|way| shelves.iter().map(move |shelf| (way, shelf))) {
            for turn in world.wished_turns(thing, way, shelf, wish) {
                match world.wished_on(thing, shelf, (way, &turn), wish, self.order, &admits) {
                    Ok(spot) => return Ok(Ok(spot)),
                    Err(found) => fault = fault.max(found),
                }
            }
        }
        Ok(Err(fault))
    }
}

impl PhysicsWorld {
    /// The turns against a surface by which a thing may be put down.
    fn wished_turns(
        &self,
        thing: &Thing,
        way: &Way,
        shelf: &SupportSurface,
        wish: &SpotWish,
    ) -> Vec<UnitQuaternion<f32>> {
        let turned = wish.rotation.map(|rotation| vec![shelf.pose.rotation.inverse() * rotation]);
        turned.unwrap_or_else(|| self.turns_of(thing, way))
    }

    fn wished_on(
        &self,
        thing: &Thing,
        shelf: &SupportSurface,
        (way, turn): (&Way, &UnitQuaternion<f32>),
        wish: &SpotWish,
        order: SpotOrder,
        admits: &dyn Fn(&Pose) -> bool,
    ) -> Result<Pose, SpotFault> {
        if let Some(point) = wish.point {
            let spot = self.spot_at(thing, shelf, &point, turn)?;
            return if admits(&spot) { Ok(spot) } else { Err(SpotFault::NotAdmitted) };
        }
        fits(thing.form.extent, shelf, turn, (0.0, way.over))?;
        let all = spots(thing.form.extent, shelf, turn, (0.0, way.over), PITCH, order);
        let rests = |spot: &Pose| shelf.hold != Hold::On || self.is_borne(thing, spot, shelf.id);
        // A pan is wider than the burner that bears it.
        let (borne, other): (Vec<Pose>, Vec<Pose>) = all.into_iter().partition(rests);
        let free = borne.into_iter().chain(other).filter(|spot| self.is_clear(thing, shelf, spot));
        let mut fault = SpotFault::Taken(Vec::new());
        for spot in free {
            if admits(&spot) {
                return Ok(spot);
            }
            fault = SpotFault::NotAdmitted;
        }
        Err(fault)
    }

    /// The pose of a thing with its origin at a point of a surface.
    fn spot_at(
        &self,
        thing: &Thing,
        shelf: &SupportSurface,
        point: &Point2<f32>,
        turn: &UnitQuaternion<f32>,
    ) -> Result<Pose, SpotFault> {
        let (low, high) = thing.form.extent;
        let (rotation, middle) = (shelf.pose.rotation * turn, nalgebra::center(&low, &high));
        let up = half_sides((low, high), &rotation).z;
        let height = shelf.pose.translation.z + GAP + up - (rotation * middle.coords).z;
        let spot = Pose::from_parts(Vector3::new(point.x, point.y, height).into(), rotation);
        let (own, half) = (shelf.pose.inverse_transform_point(&(spot * middle)), half_sides((low, high), turn));
        let whole = self.whole_top(shelf);
        let is_over = |room: (f32, f32)| own.x.abs() <= room.0 && own.y.abs() <= room.1;
        if !is_over(whole.half) {
            return Err(SpotFault::OffSurface);
        }
        if shelf.clearance.is_some_and(|clearance| 2.0 * up + GAP > clearance) {
            return Err(SpotFault::TooLow);
        }
        let rests = match shelf.hold {
            Hold::On => self.is_borne(thing, &spot, shelf.id),
            _ => is_over((shelf.half.0 - half.x + OUT, shelf.half.1 - half.y + OUT)),
        };
        if !rests {
            return Err(SpotFault::Unsupported);
        }
        let mut there = Vec::new();
        self.for_obstacles(thing, shelf, &spot, &mut |id| {
            there.push(id);
            true
        });
        there.sort_unstable();
        there.dedup();
        if there.is_empty() { Ok(spot) } else { Err(SpotFault::Taken(there)) }
    }
}
