//! Reports aggregate as documented, and their files can be read.

#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use proptest::prelude::*;
use vc_tasks::Outcome;
use vc_tasks::report::{GroupBy, Report, Run};

const OUTCOMES: [Outcome; 4] = [Outcome::Won, Outcome::Lost, Outcome::TimedOut, Outcome::Aborted];

fn run(agent: &str, task: &str, outcome: Outcome, steps: usize, predicates: usize) -> Run {
    let credit = if outcome == Outcome::Won { 1.0 } else { 0.25 };
    Run { agent: agent.into(), task: task.into(), outcome, credit, steps, predicates, ..Run::default() }
}

#[test]
fn rows_keep_agents_apart_and_numbers_in_order() {
    let report = Report::new(vec![
        run("b", "x-01", Outcome::Won, 4, 10),
        run("a", "x-01", Outcome::Lost, 6, 10),
        run("a", "y-01", Outcome::Won, 2, 9),
    ]);
    let keys = |by| report.table(by).rows.iter().map(|r| format!("{} {}", r.key, r.agent)).collect::<Vec<_>>();
    assert_eq!(keys(GroupBy::Group), ["x a", "x b", "y a"]);
    assert_eq!(keys(GroupBy::Predicates), ["9 a", "10 a", "10 b"]);
    assert_eq!(keys(GroupBy::Agent), ["a a", "b b"]);
}

#[test]
fn path_weighted_success_goes_by_metres_where_both_are_known() {
    let by_steps = Run { best_steps: Some(5), ..run("a", "x-01", Outcome::Won, 10, 1) };
    assert_eq!(by_steps.spl(), Some(0.5));
    let by_metres = Run { best_distance: Some(3.0), distance: Some(4.0), ..by_steps.clone() };
    assert_eq!(by_metres.spl(), Some(0.75));
    assert_eq!(Run { outcome: Outcome::TimedOut, ..by_metres }.spl(), Some(0.0));
    // An attempt shorter than the best known one does not score above the maximum.
    assert_eq!(Run { steps: 2, ..by_steps.clone() }.spl(), Some(1.0));
    assert_eq!(Run { best_steps: None, ..by_steps }.spl(), None);
}

#[test]
fn intervals_are_wilsons() {
    // 8 of 10, the textbook example: 0.490 to 0.943.
    let runs = (0..10).map(|i| run("a", "x-01", if i < 8 { Outcome::Won } else { Outcome::Lost }, 1, 1)).collect();
    let (low, high) = Report::new(runs).overall().interval;
    assert!((low - 0.4902).abs() < 1e-4 && (high - 0.9433).abs() < 1e-4, "{low} {high}");
}

#[test]
fn table_reads_as_text() {
    let report = Report::new(vec![
        run("planner", "x-01", Outcome::Won, 4, 1),
        run("planner", "x-02", Outcome::TimedOut, 100, 1),
    ]);
    let text = report.table(GroupBy::Group).text();
    let lines: Vec<Vec<&str>> = text.lines().map(|l| l.split_whitespace().collect()).collect();
    assert_eq!(lines[1][..7], ["x", "planner", "2", "1", "0", "1", "0"]);
    assert!(!text.contains("distance"), "{text}");
}

#[test]
fn csv_quotes_what_must_be() {
    let report = Report::new(vec![run("one, \"two\"", "x-01", Outcome::Won, 4, 1)]);
    assert!(report.csv().contains("\n\"one, \"\"two\"\"\",x-01,0,1,won,1,4,"), "{}", report.csv());
}

#[test]
fn plots_are_well_formed() {
    let report = Report::new(vec![run("a<b", "x-01", Outcome::Won, 4, 1), run("c", "x-01", Outcome::Lost, 4, 1)]);
    let svg = report.table(GroupBy::Group).svg("tasks & agents");
    assert!(svg.contains("tasks &amp; agents") && svg.contains("a&lt;b"));
    for tag in ["svg", "text"] {
        assert_eq!(svg.matches(&format!("<{tag} ")).count(), svg.matches(&format!("</{tag}>")).count(), "{tag}");
    }
}

fn any_run() -> impl Strategy<Value = Run> {
    let best = proptest::option::of(1_usize..50);
    ("[ab]", "[xy]-0[12]", 0..4_usize, 0..=16_u32, 0..100_usize, 1..5_usize, best).prop_map(
        |(agent, task, outcome, credit, steps, predicates, best_steps)| Run {
            agent,
            task,
            outcome: OUTCOMES[outcome],
            credit: f64::from(credit) / 16.0,
            steps,
            predicates,
            best_steps,
            ..Run::default()
        },
    )
}

proptest! {
    #[test]
    fn every_run_is_in_one_row_and_files_read_back(runs in proptest::collection::vec(any_run(), 0..30)) {
        let report = Report::new(runs);
        for by in [GroupBy::Agent, GroupBy::Group, GroupBy::Predicates] {
            let rows = report.table(by).rows;
            prop_assert_eq!(rows.iter().map(|r| r.runs).sum::<usize>(), report.runs.len());
            for row in rows {
                prop_assert_eq!(row.won + row.lost + row.timed_out + row.aborted, row.runs);
                prop_assert!(row.interval.0 <= row.success && row.success <= row.interval.1);
                prop_assert!(row.spl.is_none_or(|spl| (0.0..=1.0).contains(&spl)));
            }
        }
        prop_assert_eq!(Report::from_json(&report.json()).unwrap(), report.clone());
        prop_assert_eq!(report.csv().lines().count(), report.runs.len() + 1);
    }
}
