//! Goals of the Embodied Agent Interface that parse are printed and parse back equal.
#![no_main]

use libfuzzer_sys::fuzz_target;
use vc_graph::Goal;
use vc_graph::format::eai;

fuzz_target!(|text: &str| {
    if let Ok(goal) = Goal::from_eai(text) {
        assert_eq!(goal.to_string().parse(), Ok(goal));
    }
    for task in eai::read_tasks(text).unwrap_or_default().into_values() {
        for goal in [Some(task.goal), task.formula].into_iter().flatten() {
            assert_eq!(goal.to_string().parse(), Ok(goal));
        }
    }
});
