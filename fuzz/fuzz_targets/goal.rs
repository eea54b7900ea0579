//! A goal that parses is printed, parses back equal, and can be evaluated.
#![no_main]

use libfuzzer_sys::fuzz_target;
use vc_graph::goal::Situation;
use vc_graph::{ClassTable, Goal, History, NodeId, SceneGraph};

fuzz_target!(|text: &str| {
    let Ok(goal) = text.parse::<Goal>() else { return };
    let printed = goal.to_string();
    assert_eq!(printed.parse().as_ref(), Ok(&goal), "{printed}");
    let (nothing, history) = (SceneGraph::new("nothing", ClassTable::builtin()), History::default());
    let now = Situation::new(&nothing, NodeId(1), &history);
    assert_eq!(goal.score(&now) == 1.0, goal.holds(&now), "{printed}");
});
