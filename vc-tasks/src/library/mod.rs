//! The task library: the thesis's hundred tasks, and the benchmark of 145.
//!
//! An [`Activity`] is a [`Task`](crate::Task) with its requirements: the objects it needs and where
//! they may be, the conditions at the start, the conditions of a natural end, and the places where
//! it happens. [`thesis_tasks`] returns the hundred tasks of the thesis's appendix B,
//! [`Benchmark::v1`] the 145 that are made from 20 bases. [`Activity::read_list`] reads your own
//! list.

mod activity;
mod benchmark;
mod need;

pub use activity::{Activity, ActivityError};
pub use benchmark::{Benchmark, BenchmarkError, VariantError};
pub use need::{Need, NeedError, NeedProblem, PlacementSpec};

use vc_graph::Verb;

const INDOOR: &str = include_str!("../../data/library/indoor.json");
const OUTDOOR: &str = include_str!("../../data/library/outdoor.json");

/// The verbs of the thesis's environment, including the gestures it names.
///
/// ```
/// use vc_graph::Verb;
/// assert!(vc_tasks::library::THESIS_VERBS.contains(&Verb::PutIn));
/// ```
pub const THESIS_VERBS: [Verb; 18] = [
    Verb::Walk,
    Verb::Run,
    Verb::Grab,
    Verb::Place,
    Verb::PutIn,
    Verb::SwitchOn,
    Verb::SwitchOff,
    Verb::Open,
    Verb::Close,
    Verb::Eat,
    Verb::Drink,
    Verb::Sit,
    Verb::Stand,
    Verb::Dance,
    Verb::Wave,
    Verb::Exercise,
    Verb::PointAt,
    Verb::LookAt,
];

/// One of the two lists in the thesis's appendix B.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum List {
    /// The first list: tasks in the home.
    Indoor,
    /// The second list: outdoor tasks, with some in the home among them.
    Outdoor,
}

impl List {
    /// The prefix of its tasks' identifiers, as in `indoor-4`.
    pub fn as_str(self) -> &'static str {
        match self {
            Self::Indoor => "indoor",
            Self::Outdoor => "outdoor",
        }
    }
}

/// The fifty tasks of one of the thesis's lists, in its order but in our words.
///
/// The thesis prints the heading of its first list as number 1, so that its numbers
/// 2 to 51 are our 1 to 50.
///
/// ```
/// use vc_tasks::library::{List, thesis_tasks};
/// let tasks = thesis_tasks(List::Indoor);
/// assert_eq!(tasks.len(), 50);
/// assert_eq!(tasks[25].id, "indoor-26");
/// assert_eq!(tasks[25].goal.to_string(), "Near(me, fridge) & Open(fridge)");
/// ```
pub fn thesis_tasks(list: List) -> Vec<Activity> {
    let text = match list {
        List::Indoor => INDOOR,
        List::Outdoor => OUTDOOR,
    };
    // A test reads the lists and reports their errors.
    Activity::read_list(list.as_str(), text).unwrap_or_default()
}
