//! The state of a world, body by body: things, agents, vehicles and water.
//!
//! These types hold what a clone copies and a snapshot keeps, and change only themselves. The modules above
//! them ([`joints`](crate::joints), [`agent`](crate::agent), [`vehicle`](crate::vehicle),
//! [`water`](crate::water) and others) let a whole world act on them.

mod agent;
mod body_plan;
mod effector;
mod hand;
mod motion;
mod thing;
mod vehicle;
mod watch;
mod water;

pub(crate) use agent::{Agent, upright};
pub(crate) use body_plan::{ADULT, PUSH};
pub use body_plan::{BodyPlan, Posture};
pub use effector::HandGoal;
pub(crate) use effector::{Effector, Grasp};
pub use hand::Hand;
pub(crate) use hand::{Held, Loaded};
pub(crate) use motion::Motion;
pub(crate) use thing::{Moving, Places, Thing, ThingState};
pub(crate) use vehicle::Vehicle;
pub use vehicle::{VehicleControls, VehiclePlan, WheelPlan};
pub(crate) use watch::{ABOUT, Spot};
pub(crate) use water::{Water, Waters};
