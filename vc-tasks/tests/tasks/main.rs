//! Tests of tasks, their formats and scores, in one program: each program links anew.

#[path = "../common/mod.rs"]
mod common;

mod bddl;
mod behavior;
mod compile;
mod derived;
mod eai;
mod formats;
mod hostile;
mod household;
mod initial;
mod library;
mod lint;
mod pddl;
mod report;
mod scores;
