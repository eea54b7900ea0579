//! Tests of tasks, their formats and scores, in one program: each program links anew.

#[path = "../shared/mod.rs"]
mod bddl_files;
#[path = "../common/mod.rs"]
mod common;
#[path = "../../../vc-graph/tests/shared/mod.rs"]
mod shared;

mod bddl;
mod compile;
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
