#![doc = include_str!("../FRONT.md")]
#![warn(clippy::disallowed_methods)]

mod agenda;
mod agent;
mod belief;
mod bound;
mod compile;
mod demand;
mod episode;
mod expansion;
mod goal_recognizer;
mod helper;
mod known;
pub mod language;
mod manners;
mod object_search;
mod observation;
mod offline;
mod open_condition;
mod packed;
mod plan;
mod planner;
mod policy;
mod prior;
mod reason;
mod record;
mod regression;
mod rounds;
mod search;
mod search_step;
mod shared;
mod small_list;
mod subgoal;
mod team;
mod trip;

// The crates of scenes and tasks are re-exported, so that one crate is enough to begin with.
pub use vc_graph as graph;
pub use vc_tasks as tasks;

pub use agent::{Agent, Decision};
pub use belief::{Belief, Learned};
pub use episode::{Episode, EpisodeOptions, Step, Summary, run_episode};
pub use goal_recognizer::GoalRecognizer;
pub use helper::Helper;
pub use known::KnownNodes;
pub use language::LanguageModel;
pub use manners::Manners;
pub use offline::Transition;
#[cfg(feature = "parquet")]
pub use offline::{TableError, write_parquet};
pub use open_condition::{OpenCondition, Unreachable};
pub use plan::{Horizon, Plan};
pub use planner::{Planner, plan};
pub use policy::{
    EpisodeStart, PlannerPolicy, Policy, RandomPolicy, RefusalResponse, ScriptedPolicy, objects_of_interest,
};
pub use prior::{Habit, Prior};
pub use record::{Fault, Header, Trajectory, TrajectoryError};
pub use rounds::run_together;
pub use search::SearchLimits;
pub use team::{Team, TeamEpisode};
