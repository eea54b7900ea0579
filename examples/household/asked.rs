//! Options that have no meaning for the requested run.

use crate::Options;
use crate::support::Complaint;

/// Whether a meaningless option was given, its name, and what to do instead.
type Idle = (bool, &'static str, &'static str);

/// Returns an error for options that do not apply, with advice.
pub(crate) fn check(options: &Options) -> Result<(), Complaint> {
    let idle = if options.symbolic { without_bodies(options) } else { with_bodies(options) };
    let list = if options.list { listing(options) } else { Vec::new() };
    let told: Vec<String> = idle
        .into_iter()
        .chain(list)
        .filter(|(given, ..)| *given)
        .map(|(_, option, advice)| format!("{option} does not apply: {advice}"))
        .collect();
    if told.is_empty() { Ok(()) } else { Err(Complaint::new(told.join("\n"))) }
}

fn without_bodies(options: &Options) -> Vec<Idle> {
    const UNSEEN: &str = "no pictures are made without bodies; leave it out, or --symbolic";
    vec![
        (options.dataset, "--dataset", UNSEEN),
        (options.hour.is_some(), "--hour", UNSEEN),
        (options.finer.is_some(), "--finer", UNSEEN),
        (options.width.is_some(), "--width", UNSEEN),
        (options.agents > 1, "--agents", "a team needs bodies here; leave it out, or --symbolic"),
        (options.list && options.seed.is_some(), "--seed", "nobody guesses while --list shows a scene; leave it out"),
    ]
}

fn with_bodies(options: &Options) -> Vec<Idle> {
    vec![(
        options.classes.is_some(),
        "--classes",
        "classes of one's own have no bodies; add --symbolic, or leave it out",
    )]
}

fn listing(options: &Options) -> Vec<Idle> {
    const SHOWN: &str = "--list shows what can be asked and does nothing; leave one of the two out";
    vec![
        (options.goal.is_some(), "--goal", SHOWN),
        (options.task.is_some(), "--task", SHOWN),
        (options.dataset && !options.symbolic, "--dataset", SHOWN),
        (options.hour.is_some() && !options.symbolic, "--hour", SHOWN),
    ]
}
