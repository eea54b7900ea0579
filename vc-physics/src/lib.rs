#![doc = include_str!("../FRONT.md")]
#![warn(clippy::disallowed_methods)]

mod agent;
mod body;
mod build;
mod cloth;
mod contact;
mod convert;
mod displaced;
mod engine;
mod error;
mod ground;
mod group;
mod joints;
mod load;
mod nav;
mod place;
mod query;
mod reset;
mod rest;
mod role;
mod rolling;
mod serial;
mod settings;
mod settle;
mod shapes;
mod snapshot;
mod state;
mod step;
mod vehicle;
mod water;
mod world;

pub use agent::{PartsToMoveAside, WalkState};
pub use contact::Contact;
pub use error::{AgentError, PhysicsError, SnapshotError};
pub use joints::MovingPart;
pub use nav::{DoorHandling, Floor, FloorOptions, Occupancy, Route, StandingPose};
pub use place::{SpotFault, SpotOrder, SpotWish, SupportSurface};
pub use reset::Reset;
pub use rest::RestProgress;
pub use role::BodyRole;
pub use settings::{FixedThings, Settings, UnsupportedThings};
pub use settle::{Displacement, Settling};
pub use shapes::ShapeCache;
pub use state::{BodyPlan, Hand, Posture, VehicleControls, VehiclePlan, WheelPlan};
pub use world::PhysicsWorld;
