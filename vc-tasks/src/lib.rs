//! Household tasks: their goals, whether a goal makes sense in a scene, and how well an attempt
//! fulfilled it.
//!
//! A [`Task`] is a goal with a title and a step limit. [`Task::obstacles`] lists the reasons why a
//! goal cannot make sense in a scene before any attempt, an [`Outcome`] says how an attempt ended,
//! and [`household`] is a list of everyday tasks. A [`World`] is the environment in which tasks are
//! executed, symbolic or with bodies; [`GoalProgress`] is the verdict on an episode step by step, and a
//! [`Trial`] executes a task action by action, with observations and rewards. The [`library`] holds
//! the thesis's hundred tasks and the benchmark of 145, and [`initial`] prepares a scene for one of
//! them.
//!
//! [`compile`] turns a goal into a flat program over the atoms that matter, kept up to date while a
//! scene changes. [`score`] says how much of a goal holds, [`explain`] which parts are missing, and
//! [`first_held`] since when the other parts have held. [`report`] summarises many attempts.
//!
//! [`mod@format`] reads and writes the task formats of others: BDDL, PDDL, Watch-And-Help, EAI,
//! ALFRED, the thesis. [`lint`] finds mistakes in a task.
//!
//! ```
//! use vc_graph::{Draft, SceneBuilder};
//! use vc_tasks::Task;
//!
//! let mut scene = SceneBuilder::new("flat");
//! let kitchen = scene.add(Draft::new("kitchen"))?;
//! scene.add_in(kitchen, Draft::new("kitchen_table"))?;
//! scene.add_in(kitchen, Draft::new("character"))?;
//! let task = Task::new("breakfast", "On(apple, kitchen_table), 2".parse()?);
//! let why: Vec<String> = task.obstacles(&scene.build()).iter().map(|o| o.to_string()).collect();
//! assert_eq!(why, ["`On(apple, kitchen_table), 2` needs 2 of `apple`, the scene has 0"]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

#![warn(clippy::disallowed_methods)]

mod attainable;
pub mod compile;
mod explain;
pub mod format;
mod household;
pub mod initial;
pub mod library;
pub mod lint;
mod obstacle;
mod progress;
pub mod report;
pub mod score;
mod task;
mod trial;
mod vacuous;
mod world;

pub use explain::{Bindings, GoalPart, MinimalSets, SETS, Unmet, explain, first_held};
pub use household::household;
pub use obstacle::{BroaderClass, Lost, Obstacle};
pub use progress::GoalProgress;
pub use task::{Outcome, Task, TaskError};
pub use trial::{Feedback, Trial};
pub use world::{World, WorldError, WorldFailure};
