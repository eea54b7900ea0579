#![doc = include_str!("../FRONT.md")]
#![warn(clippy::disallowed_methods)]

mod action;
mod anthropometry;
pub mod asset;
mod builder;
mod bulk;
mod change;
pub mod class;
pub mod clock;
mod digest;
mod edit;
pub mod format;
mod geometry;
pub mod goal;
mod graph;
mod grid;
pub mod hash;
mod id;
pub mod mesh;
mod node;
mod observe;
pub mod portable;
mod property;
mod relation;
mod role;
pub mod rule;
mod seed;
pub mod serial;
mod simulator;
pub mod space;
mod spelling;
pub mod srgb;
mod state;
mod store;
mod texture;
mod validate;
mod visit_order;
mod vocabulary;

pub use nalgebra;

pub use action::{
    Action, ActionTextError, Aim, AimError, AimPart, AimPoint, AimWord, Heading, NameMismatch, ObjectNames,
    ParsedAction, Side, Verb,
};
pub use anthropometry::Anthropometry;
pub use asset::{Asset, AssetId, AssetLibrary};
pub use builder::SceneBuilder;
pub use change::{Change, ChangeMismatch, ChangeSet};
pub use class::{Class, ClassError, ClassTable};
pub use edit::{Edit, EditError};
pub use geometry::{Aabb, Bounds, BoundsFrame, Pose};
pub use goal::Goal;
pub use graph::{NEAR, SceneGraph};
pub use hash::Digest;
pub use id::{Label, LabelError, NodeId};
pub use mesh::TriangleMesh;
pub use node::{Draft, Node, NodeKind, Spec};
pub use observe::{Observation, Scope};
pub use property::{Property, PropertySet};
pub use relation::{Edge, Place, Relation};
pub use role::ObjectRole;
pub use rule::{ActionRule, AimForm, AimRule, Condition, Effect, Motion, Refusal, Semantics};
pub use seed::{Seed, Stream};
pub use simulator::{Event, History, Simulator};
pub use spelling::{clip, did_you_mean, nearest};
pub use state::{State, StateSet};
pub use validate::Violation;
pub use vocabulary::{NameProblem, OwnState, Set, UnknownWord, Vocabulary, VocabularyError, VocabularyProblem, Word};
