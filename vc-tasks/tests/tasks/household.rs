//! The list of everyday tasks is well formed.

#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use vc_tasks::Task;

#[test]
fn the_list_reads_and_its_titles_differ() {
    let text = include_str!("../../data/household.txt");
    let tasks = Task::read_list(text).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(tasks, vc_tasks::household());
    let titles: std::collections::BTreeSet<&str> = tasks.iter().map(|t| t.title.as_str()).collect();
    assert_eq!(titles.len(), tasks.len());
    for task in &tasks {
        assert_eq!(task.goal, task.goal.to_string().parse().unwrap(), "{}", task.goal);
    }
}
