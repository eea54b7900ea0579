//! VirtualCity: a headless, deterministic simulator of homes for embodied-AI research.
//!
//! This crate is the front door. It re-exports the crates that do the work:
//!
//! | module | crate | what |
//! |---|---|---|
//! | [`graph`] | `vc-graph` | scenes, object classes, actions, goals, file formats |
//! | [`tasks`] | `vc-tasks` | tasks, and how attempts at them end |
//! | [`planner`] | `vc-planner` | belief, regression planner, agents, episodes |
//! | [`relations`] | `vc-relations` | what is on, in, under and near what, read from poses and shapes |
//! | `physics` | `vc-physics` | bodies, agents, navigation, vehicles, water (feature `physics`, on by default) |
//! | `render` | `vc-render` | what cameras see: six modalities (feature `render`, on by default) |
//! | `procgen` | `vc-procgen` | objects and apartments from a seed (feature `procgen`, on by default) |
//! | `initial` | here | environments for tasks in generated homes (feature `procgen`) |
//!
//! An agent that sees only its room brings the milk:
//!
//! ```
//! use virtualcity::graph::{Draft, SceneBuilder, Simulator};
//! use virtualcity::planner::{Newcomer, run_episode};
//! use virtualcity::tasks::{Outcome, Task};
//!
//! let mut scene = SceneBuilder::new("flat");
//! let kitchen = scene.add(Draft::new("kitchen"))?;
//! let fridge = scene.add_in(kitchen, Draft::new("fridge"))?;
//! scene.add_in(fridge, Draft::new("milk"))?;
//! scene.add_in(kitchen, Draft::new("character"))?;
//!
//! let task = Task::new("fetch the milk", "Holds(milk) & Closed(fridge)".parse()?);
//! let mut world = Simulator::new(scene.build());
//! let episode = run_episode(&mut Newcomer::best(), &task, &mut world);
//! assert_eq!(episode.outcome, Outcome::Won);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # What is not here yet
//!
//! The environment with its five endpoints (make, reset, render, observation, set
//! action) and batches. Until then
//! [`Simulator`](graph::Simulator) is the environment: symbolic, with poses that
//! follow actions only roughly. Bodies are in `physics`, and not tied to its actions.

#[cfg(feature = "procgen")]
pub mod initial;

pub use vc_graph as graph;
#[cfg(feature = "physics")]
pub use vc_physics as physics;
pub use vc_planner as planner;
#[cfg(feature = "procgen")]
pub use vc_procgen as procgen;
pub use vc_relations as relations;
#[cfg(feature = "render")]
pub use vc_render as render;
pub use vc_tasks as tasks;
