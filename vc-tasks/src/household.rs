//! Everyday tasks.

use crate::Task;

/// The text of the list.
const TEXT: &str = include_str!("../data/household.txt");

/// A fixed list of everyday tasks for homes of any origin. Not every task makes sense in every
/// scene; [`Task::obstacles`] lists the reasons.
///
/// ```
/// assert!(vc_tasks::household().len() >= 40);
/// ```
pub fn household() -> Vec<Task> {
    // A test reads the list and reports its errors.
    Task::read_list(TEXT).unwrap_or_default()
}
