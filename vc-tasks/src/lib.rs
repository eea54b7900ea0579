//! Household tasks: what is to be done, whether it makes sense in a scene, and how
//! it came out.
//!
//! A [`Task`] is a goal with a title and a limit of steps. [`Task::obstacles`] says
//! why a goal cannot make sense in a scene before anybody tries, an [`Outcome`]
//! says how an attempt ended, and [`household`] is a list of everyday tasks. A
//! [`World`] is where they are done, symbolic or with bodies; a [`Trial`] does a task
//! action by action, with observations and rewards. The [`library`] has the
//! thesis's hundred tasks and the benchmark of 145, and [`initial`] makes a scene
//! ready for one of them.
//!
//! [`compile`] makes a goal a flat program over the atoms that matter, kept up to
//! date while a scene changes; [`score`] says how much of it holds, [`explain`] and
//! [`first_held`] what is missing and since when the rest has held. [`report`] sums up
//! many attempts.
//!
//! [`mod@format`] reads and writes tasks of others: BDDL, PDDL, Watch-And-Help, EAI,
//! ALFRED, the thesis. [`lint`] says what is wrong with a task.
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

pub mod compile;
mod explain;
pub mod format;
mod household;
pub mod initial;
pub mod library;
pub mod lint;
mod obstacle;
pub mod report;
pub mod score;
mod task;
mod trial;
mod world;

pub use explain::{Bindings, MinimalSets, Part, SETS, Unmet, explain, first_held};
pub use household::household;
pub use obstacle::Obstacle;
pub use task::{Outcome, Task, TaskError};
pub use trial::{Feedback, Trial};
pub use world::{World, WorldError};
