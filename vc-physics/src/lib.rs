#![doc = include_str!("../FRONT.md")]
#![warn(clippy::disallowed_methods)]

mod agent;
mod contact;
mod contact_completion;
mod contact_reduction;
mod convert;
mod crowd;
mod engine;
mod error;
mod ground;
mod group;
mod joints;
mod lower;
mod nav;
mod place;
mod reset;
mod role;
mod rolling;
mod serial;
mod settings;
mod settle;
mod shapes;
mod snapshot;
mod vehicle;
mod water;
mod world;

pub use agent::{BodyPlan, Hand, PartsToMoveAside, Posture, Walk};
pub use contact::Contact;
pub use error::{AgentError, PhysicsError, SnapshotError};
pub use joints::MovingPart;
pub use nav::{Doors, Floor, FloorOptions, Occupancy, Route, Stand};
pub use place::{Order, Shelf};
pub use reset::Reset;
pub use role::BodyRole;
pub use settings::{Fixing, Settings, UnsupportedThings};
pub use settle::{Moved, Settling};
pub use shapes::Shapes;
pub use vehicle::{Controls, VehiclePlan, WheelPlan};
pub use world::PhysicsWorld;
