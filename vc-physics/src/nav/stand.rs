//! Standing positions for reaching a thing.

use nalgebra::{Point2, Point3};
use vc_graph::{NodeId, Pose};

use super::{Floor, Route};
use crate::PhysicsError;
use crate::convert::facing;
use crate::state::BodyPlan;
use crate::world::PhysicsWorld;

/// Margin by which an agent stands nearer than its reach, metres: nobody stops exactly on the spot.
const SLACK: f32 = 0.06;
/// Distance between candidate spots, metres.
const PITCH: f32 = 0.1;

/// A standing position.
#[derive(Debug, Clone, PartialEq)]
pub struct StandingPose {
    /// The pose of the feet; X points to the thing to be reached.
    pub feet: Pose,
    /// The path there.
    pub route: Route,
}

impl Floor {
    /// The nearest spot, by path length, from which a body can reach and see a thing, and the path there.
    /// `None` if there is no such spot, or no path to any.
    ///
    /// Costs about a microsecond for each candidate spot, and a path query for the best of them.
    ///
    /// # Errors
    /// [`PhysicsError::NoBody`].
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// use nalgebra::Point2;
    /// use vc_physics::{BodyPlan, Floor, FloorOptions};
    /// let floor = Floor::new(&world, FloorOptions::default());
    /// let stand = floor.standing_pose(&world, &BodyPlan::default(), Point2::new(0.0, -1.0), home.cup)?;
    /// let stand = stand.ok_or("the cup is out of reach")?;
    /// assert!((stand.feet.rotation * nalgebra::Vector3::x()).x > 0.5); // The feet point to the cup.
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn standing_pose(
        &self,
        world: &PhysicsWorld,
        plan: &BodyPlan,
        from: Point2<f32>,
        id: NodeId,
    ) -> Result<Option<StandingPose>, PhysicsError> {
        self.standing_pose_where(world, plan, from, id, |feet| self.sees(world, plan, feet, id))
    }

    /// As [`Self::standing_pose`], at a spot that satisfies a condition, which is tested last; the condition also
    /// decides whether the thing has to be visible from there.
    ///
    /// # Errors
    /// [`PhysicsError::NoBody`].
    pub fn standing_pose_where(
        &self,
        world: &PhysicsWorld,
        plan: &BodyPlan,
        from: Point2<f32>,
        id: NodeId,
        mut admits: impl FnMut(&Pose) -> bool,
    ) -> Result<Option<StandingPose>, PhysicsError> {
        let aabb = world.aabb(id).ok_or(PhysicsError::NoBody(id))?;
        let (low, high) =
            (aabb.min.xy().coords.add_scalar(-plan.stretch()), aabb.max.xy().coords.add_scalar(plan.stretch()));
        let mut spots: Vec<(f32, Point2<f32>)> = raster(low.into(), high.into())
            .filter(|spot| self.is_free(*spot))
            .map(|spot| ((spot - from).norm(), spot))
            .collect();
        spots.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.x.total_cmp(&b.1.x)).then(a.1.y.total_cmp(&b.1.y)));
        let mut best: Option<(Vec<Point2<f32>>, f32, Point2<f32>)> = None;
        for (straight, spot) in spots {
            // No path is shorter than the straight line.
            if best.as_ref().is_some_and(|(_, length, _)| straight >= *length) {
                break;
            }
            if !self.reaches(world, plan, spot, id)? || !admits(&self.feet(spot, &aabb.centre())) {
                continue;
            }
            if let Some((points, length)) = self.corners(from, spot)
                && best.as_ref().is_none_or(|(_, least, _)| length < *least)
            {
                best = Some((points, length, spot));
            }
        }
        let centre = aabb.centre();
        let stand = |(points, length, spot)| StandingPose {
            feet: self.feet(spot, &centre),
            route: self.with_doors(points, length),
        };
        Ok(best.map(stand))
    }

    fn feet(&self, spot: Point2<f32>, towards: &Point3<f32>) -> Pose {
        let turn = facing(towards.x - spot.x, towards.y - spot.y);
        Pose::from_parts(nalgebra::Translation3::new(spot.x, spot.y, self.options.level), turn)
    }

    fn reaches(
        &self,
        world: &PhysicsWorld,
        plan: &BodyPlan,
        spot: Point2<f32>,
        id: NodeId,
    ) -> Result<bool, PhysicsError> {
        let arm = world.arm(plan, Point3::new(spot.x, spot.y, self.options.level), id)?;
        Ok(world.distance_to(id, arm)? <= plan.reach - SLACK)
    }

    /// Whether a thing is visible from the eyes of a body that stands at a pose: a ray to its middle, or to a corner of
    /// a slightly smaller box, hits nothing else first. Agents do not occlude it, and the direction of the gaze is not
    /// considered.
    pub fn sees(&self, world: &PhysicsWorld, plan: &BodyPlan, feet: &Pose, id: NodeId) -> bool {
        let agents: Vec<NodeId> = world.agents().collect();
        world.sees(feet * Point3::new(0.0, 0.0, plan.eye()), id, &agents).unwrap_or(false)
    }
}

/// The points of a grid over a rectangle.
fn raster(low: Point2<f32>, high: Point2<f32>) -> impl Iterator<Item = Point2<f32>> {
    let count = |length: f32| ((length / PITCH).ceil().max(0.0) as usize).min(400);
    let (columns, rows) = (count(high.x - low.x), count(high.y - low.y));
    (0..=rows)
        .flat_map(move |r| (0..=columns).map(move |c| Point2::new(low.x + c as f32 * PITCH, low.y + r as f32 * PITCH)))
}
