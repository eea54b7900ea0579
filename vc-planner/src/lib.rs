#![doc = include_str!("../FRONT.md")]

mod agenda;
mod agent;
mod belief;
mod bound;
mod compile;
mod demand;
mod episode;
mod few;
mod helper;
mod hunt;
mod known;
pub mod language;
mod look;
mod manners;
mod observation;
mod offline;
mod packed;
mod plan;
mod planner;
mod policy;
mod prior;
mod record;
mod regression;
mod search;
mod shared;
mod subgoal;
mod team;
mod tour;
mod trip;
mod want;

// The crates of scenes and tasks are re-exported, so that one crate is enough to begin with.
pub use vc_graph as graph;
pub use vc_tasks as tasks;

pub use agent::{Agent, Decision};
pub use belief::{Belief, Learned};
pub use episode::{Episode, Run, Step, Summary, run_episode};
pub use helper::{Helper, run_together};
pub use known::Known;
pub use language::LanguageModel;
pub use manners::Manners;
pub use offline::Transition;
#[cfg(feature = "parquet")]
pub use offline::{TableError, write_parquet};
pub use plan::{Horizon, Plan};
pub use planner::{Planner, plan};
pub use policy::{Brief, Newcomer, Policy, Random, Reaction, Resident, Scripted, objects_of_interest};
pub use prior::{Habit, Prior};
pub use record::{Fault, Header, RecordError, Trajectory};
pub use search::Effort;
pub use team::{Team, TeamEpisode, Watcher};
pub use want::{Subgoal, Unreachable, Want};
