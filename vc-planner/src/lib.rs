#![doc = include_str!("../FRONT.md")]

mod agent;
mod belief;
mod bound;
mod compile;
mod demand;
mod episode;
mod known;
mod packed;
mod plan;
mod regression;
mod search;
mod subgoal;
mod tour;
mod want;
mod weigh;

pub use agent::{Agent, Decision};
pub use belief::{Belief, Learned};
pub use compile::Manners;
pub use episode::{Episode, Step, Summary, run_episode};
pub use known::Known;
pub use plan::{Horizon, Plan, Planner, plan};
pub use search::Effort;
pub use want::{Subgoal, Unreachable, Want};
