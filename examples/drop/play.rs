//! The schedule of events.

use nalgebra::{Point2, Point3};
use virtualcity::graph::{Aabb, Pose};
use virtualcity::physics::{
    AgentError, BodyPlan, Floor, FloorOptions, Hand, PhysicsError, PhysicsWorld, SpotOrder, SpotSearch,
    VehicleControls, VehiclePlan, WalkState,
};

use crate::stage::{Cast, WATER};

/// Steps of the simulation: twenty seconds.
pub(crate) const STEPS: u32 = 1200;
/// The car's initial X.
const START: f32 = -6.0;
/// The X at which the car brakes.
const BRAKE: f32 = 3.6;

/// Fills the pool with water and puts wheels on the car.
pub(crate) fn prepare(world: &mut PhysicsWorld, cast: &Cast) -> Result<(), PhysicsError> {
    let pool = Aabb { min: Point3::new(4.1, 1.1, 0.0), max: Point3::new(7.0, 3.9, WATER) };
    world.add_water(&pool)?;
    let mass = world.body(cast.car)?.mass();
    world.add_vehicle(cast.car, &VehiclePlan::car(mass, 2.5, 1.5, 0.32, 0.32))
}

/// Performs the events of a step.
pub(crate) fn act(world: &mut PhysicsWorld, cast: &Cast, step: u32) -> Result<(), AgentError> {
    match step {
        60 => world.drive(cast.chest, 0, 1.0)?,
        120 => world.drive(cast.door, 0, 0.9)?,
        180 => world.steer(cast.car, VehicleControls { throttle: 0.35, ..VehicleControls::default() })?,
        300 => go_to_the_mug(world, cast)?,
        _ => {}
    }
    if step > 180 && world.pose(cast.car).is_some_and(|p| p.translation.x > BRAKE) {
        world.steer(cast.car, VehicleControls { brake: 1.0, ..VehicleControls::default() })?;
    }
    if step > 300 && world.agent(cast.person)?.walk() != WalkState::Walking {
        clear_away(world, cast)?;
    }
    Ok(())
}

/// The distance of the car from its start, metres.
pub(crate) fn driven(world: &PhysicsWorld, cast: &Cast) -> f32 {
    world.pose(cast.car).map_or(0.0, |p| p.translation.x - START)
}

fn at(world: &PhysicsWorld, cast: &Cast) -> Point2<f32> {
    world.pose(cast.person).map_or_else(Point2::origin, |p| p.translation.vector.xy().into())
}

fn go_to_the_mug(world: &mut PhysicsWorld, cast: &Cast) -> Result<(), AgentError> {
    let floor = Floor::new(world, FloorOptions::default());
    let stand = floor.standing_pose(world, &BodyPlan::default(), at(world, cast), cast.mug)?;
    stand.map_or(Ok(()), |stand| world.follow(cast.person, &stand.route.points, false))
}

/// Moves the mug, once it is within reach, from the table to the shelf, or to any free place.
fn clear_away(world: &mut PhysicsWorld, cast: &Cast) -> Result<(), AgentError> {
    if world.held(cast.person, Hand::Right).is_none() {
        let on_the_shelf = world.supports(cast.mug).contains(&cast.shelf);
        let in_reach = world.agent(cast.person)?.in_reach().iter().any(|(id, _)| *id == cast.mug);
        if in_reach && !on_the_shelf {
            world.grab(cast.person, Hand::Right, cast.mug)?;
            let floor = Floor::new(world, FloorOptions::default());
            if let Some(stand) = floor.standing_pose(world, &BodyPlan::default(), at(world, cast), cast.shelf)? {
                world.follow(cast.person, &stand.route.points, false)?;
            }
        }
        return Ok(());
    }
    let feet = world.pose(cast.person).unwrap_or_else(Pose::identity);
    let (there, reach) = (world.standing(cast.person, &feet)?, BodyPlan::default().reach);
    let in_reach = |spot: &Pose| there.put_distance(cast.mug, spot).is_ok_and(|distance| distance <= reach);
    for inside in [false, true] {
        let search = SpotSearch::new(cast.mug, cast.shelf, inside).order(SpotOrder::Near(feet * Point3::origin()));
        if let Some(spot) = search.find_where(world, in_reach)? {
            return world.put(cast.person, Hand::Right, spot).map(drop);
        }
    }
    Ok(())
}
