#![doc = include_str!("../FRONT.md")]

mod agent;
mod belief;
mod episode;
mod known;
mod plan;
mod subgoal;
mod want;
mod weigh;

pub use agent::{Agent, Decision};
pub use belief::{Belief, Learned};
pub use episode::{Episode, Step, Summary, run_episode};
pub use known::Known;
pub use plan::{Horizon, Plan, plan};
pub use want::{Subgoal, Unreachable, Want};
