//! Domains and problems that parse are written and parse back equal; plans are parsed.
#![no_main]

use libfuzzer_sys::fuzz_target;
use vc_tasks::format::pddl::{Domain, PlanningProblem, read_plan};

fuzz_target!(|text: &str| {
    if let Ok(domain) = text.parse::<Domain>() {
        assert_eq!(domain.to_string().parse().as_ref(), Ok(&domain));
    }
    if let Ok(problem) = text.parse::<PlanningProblem>() {
        assert_eq!(problem.to_string().parse().as_ref(), Ok(&problem));
    }
    let _ = read_plan(text);
});
