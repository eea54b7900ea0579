//! Views of a world: what can be read of one body, one agent, one vehicle, the moving parts of a node, and the room
//! for an agent at a place.

mod agent;
mod body;
mod hand;
mod parts;
mod standing;
mod vehicle;

pub use agent::AgentView;
pub use body::BodyView;
pub use hand::GuidedHand;
pub use parts::PartsView;
pub use standing::StandingView;
pub use vehicle::VehicleView;
