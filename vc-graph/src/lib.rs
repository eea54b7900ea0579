#![doc = include_str!("../FRONT.md")]
#![warn(clippy::disallowed_methods)]

mod action;
pub mod asset;
mod builder;
mod bulk;
mod change;
pub mod class;
mod digest;
mod edit;
pub mod format;
mod geometry;
pub mod goal;
mod graph;
mod grid;
mod id;
pub mod mesh;
mod met;
mod node;
mod observe;
pub mod portable;
mod property;
mod relation;
pub mod rule;
mod seed;
mod simulator;
mod state;
mod store;
mod texture;
mod validate;
mod vocabulary;

pub use nalgebra;

pub use action::{Action, ActionError, Verb};
pub use asset::{Asset, AssetId, AssetLibrary};
pub use builder::SceneBuilder;
pub use change::{Change, ChangeSet, Misfit};
pub use class::{Class, ClassError, ClassTable};
pub use digest::Digest;
pub use edit::{Edit, EditError};
pub use geometry::{Aabb, Bounds, Frame, Pose};
pub use goal::Goal;
pub use graph::{NEAR, Place, SceneGraph};
pub use id::{BadLabel, Label, NodeId};
pub use mesh::TriangleMesh;
pub use node::{Draft, Kind, Node, Spec};
pub use observe::{Observation, Scope};
pub use property::{Property, PropertySet};
pub use relation::{Edge, Relation};
pub use rule::{Condition, Effect, Refusal, Rule};
pub use seed::{Seed, Stream};
pub use simulator::{Event, History, Simulator};
pub use state::{State, StateSet};
pub use validate::Violation;
pub use vocabulary::{Set, UnknownWord, Word};
