//! Activities that parse are written and parse back equal; they are evaluated and linted.
#![no_main]

use libfuzzer_sys::fuzz_target;
use vc_graph::goal::Pairing;
use vc_tasks::format::bddl::{ActivityDefinition, Facts, condition};
use vc_tasks::lint;

fuzz_target!(|text: &str| {
    let Ok(activity) = ActivityDefinition::read(text) else { return };
    assert_eq!(ActivityDefinition::read(&activity.to_string()).as_ref(), Ok(&activity));
    lint::activity(&activity);
    if let Ok(facts) = Facts::from_activity(&activity, Pairing::Marginal) {
        facts.heads(|fact| fact % 2 == 0);
    }
    if let Ok(goal) = activity.to_goal() {
        let names: Vec<&str> = activity.objects().map(|o| o.name).collect();
        let _ = condition(&goal, &names);
    }
});
