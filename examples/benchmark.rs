//! The thesis's evaluation: random, oracle and both planners on the 145 tasks.
//!
//! `cargo run --release --example benchmark` makes an apartment for each task and seed
//! and lets every policy try it, symbolically, on all cores; it prints the thesis's
//! Table 5.2 beside ours and writes tables and plots. The results do not depend on the
//! number of threads.

#[path = "support/chart.rs"]
mod chart;
#[expect(dead_code, reason = "this example reads no files")]
mod support;

use std::path::{Path, PathBuf};

use chart::{Bars, Line, bars, lines};
use clap::Parser;
use indicatif::{ProgressBar, ProgressStyle};
use rayon::prelude::*;
use support::{Complaint, say};
use vc_graph::{Seed, Simulator};
use vc_planner::{Habitual, Newcomer, Policy, Prior, Random, Resident, Run as Episodes};
use vc_tasks::library::{Activity, Benchmark};
use vc_tasks::report::{By, Report, Run, predicates};
use vc_tasks::{Outcome, World};
use virtualcity::initial::{at_home, generator};

/// Random, oracle and both planners on the 145 tasks.
#[derive(Parser)]
struct Options {
    /// How many apartments for each task.
    #[arg(long, default_value_t = 3)]
    seeds: u64,
    /// After how many actions an attempt is over; the thesis stops after 100.
    #[arg(long, default_value_t = 100)]
    steps: usize,
    /// Only tasks whose id begins so, `put_fridge`.
    #[arg(long, default_value = "")]
    only: String,
    /// How many threads; all cores, if 0.
    #[arg(long, default_value_t = 0)]
    threads: usize,
    /// Where tables and plots go.
    #[arg(long, default_value = "out/benchmark")]
    out: PathBuf,
}

/// Everybody who tries, in the order of the tables.
fn policies() -> [Box<dyn Policy>; 6] {
    [
        Box::new(Random::default()),
        Box::new(Habitual::default()),
        Box::new(Newcomer::faithful()),
        Box::new(Newcomer::best().supposing(Prior::Uniform).named("planner, uniform")),
        Box::new(Newcomer::best()),
        Box::new(Resident::default()),
    ]
}

fn main() -> Result<(), Complaint> {
    let options = Options::parse();
    rayon::ThreadPoolBuilder::new().num_threads(options.threads).build_global().map_err(Complaint::new)?;
    let activities: Vec<Activity> =
        Benchmark::v1().activities.into_iter().filter(|a| a.id.starts_with(&options.only)).collect();
    let jobs: Vec<(&Activity, u64)> = activities.iter().flat_map(|a| (0..options.seeds).map(move |s| (a, s))).collect();
    let style =
        ProgressStyle::with_template("{bar:40} {pos}/{len} environments, {eta} left").map_err(Complaint::new)?;
    let bar = ProgressBar::new(jobs.len() as u64).with_style(style);
    let done = |job: &(&Activity, u64)| {
        let runs = attempt(job.0, job.1, options.steps);
        bar.inc(1);
        runs
    };
    let tried: Vec<Result<Vec<Run>, String>> = jobs.par_iter().map(done).collect();
    bar.finish_and_clear();
    let (runs, unmade): (Vec<_>, Vec<_>) = tried.into_iter().partition(Result::is_ok);
    let report = Report::new(runs.into_iter().flatten().flatten().collect());
    show(&report, jobs.len(), unmade.len());
    write(&report, &options.out)
}

/// All policies in one environment.
fn attempt(activity: &Activity, seed: u64, steps: usize) -> Result<Vec<Run>, String> {
    let made = at_home(activity, Seed(seed), &generator(), |home| Ok(Simulator::new(home)));
    let made = made.map_err(|e| e.to_string())?;
    let (mut world, scene, mut task) = (made.world, made.initial.scene, made.initial.task);
    task.goal = activity.goal.clone();
    task.step_limit = steps;
    let mut runs: Vec<Run> = Vec::new();
    for mut policy in policies() {
        world.reset(&scene).map_err(|e| e.to_string())?;
        let how = Episodes { agent: Some(made.initial.agent), ..Episodes::seeded(seed) };
        let episode = how.episode(policy.as_mut(), &task, &mut world, &mut |_| {});
        runs.push(Run {
            agent: policy.name().to_owned(),
            task: activity.id.clone(),
            seed,
            predicates: predicates(&task.goal),
            outcome: episode.outcome,
            credit: episode.score,
            steps: episode.steps,
            ..Run::default()
        });
    }
    // The last is the oracle: what it needs is the best that is known.
    let best = runs.last().filter(|r| r.outcome == Outcome::Won).map(|r| r.steps);
    runs.iter_mut().for_each(|r| r.best_steps = best);
    Ok(runs)
}

/// What the thesis reports: completion in percent, steps, steps of successes.
const THESIS: [(&str, [f64; 3]); 3] = [
    ("thesis: random", [16.55, 95.69, 73.96]),
    ("thesis: GPT-4 (sees everything)", [77.93, 21.90, 10.83]),
    ("thesis: planner", [82.07, 27.61, 11.80]),
];

/// Watch-And-Help's planner, run on tasks of five predicates, and the optimum with full
/// knowledge: steps on average.
const WATCH_AND_HELP: (usize, [f64; 2]) = (5, [60.5, 26.9]);

/// The rows of Table 5.2: the thesis's, then ours.
fn table(report: &Report) -> Vec<(String, [f64; 3])> {
    let thesis = THESIS.iter().map(|(name, figures)| ((*name).to_owned(), *figures));
    let ours = policies().map(|p| (p.name().to_owned(), figures(report, p.name(), |_| true)));
    thesis.chain(ours).collect()
}

fn show(report: &Report, environments: usize, unmade: usize) {
    say!("{environments} environments, {unmade} of them could not be made");
    say!("{:<34}{:>12}{:>12}{:>22}", "", "completed", "steps", "steps when completed");
    let row = |name: &str, [done, steps, won]: [f64; 3]| say!("{name:<34}{done:>11.2}%{steps:>12.2}{won:>22.2}");
    table(report).iter().for_each(|(name, figures)| row(name, *figures));
    let solvable: Vec<&Run> = report.runs.iter().filter(|r| r.agent == "oracle" && r.best_steps.is_some()).collect();
    say!("\nThe oracle solves {} of {}. Of these:", solvable.len(), environments - unmade);
    for policy in policies() {
        row(policy.name(), figures(report, policy.name(), |r| r.best_steps.is_some()));
    }
    say!(
        "\nSteps as a multiple of the oracle's, by the number of things a goal asks for, where all but random succeed:"
    );
    let names: Vec<String> = compared().iter().map(|name| format!("{name:>18}")).collect();
    say!("{:>10}{:>14}  {}", "things", "environments", names.concat());
    for Ratios { things, environments, of } in ratios(report) {
        let cells: Vec<String> = of.iter().map(|ratio| format!("{ratio:>18.2}")).collect();
        say!("{things:>10}{environments:>14}  {}", cells.concat());
    }
    let (things, [theirs, best]) = WATCH_AND_HELP;
    say!("Watch-And-Help's planner against the optimum at {things}: {theirs} / {best} = {:.2}", theirs / best);
}

/// Completion in percent, steps (100 where the task is not completed, as in the
/// thesis), steps of successes.
fn figures(report: &Report, name: &str, which: impl Fn(&Run) -> bool) -> [f64; 3] {
    const NOT_COMPLETED: f64 = 100.0;
    let runs: Vec<&Run> = report.runs.iter().filter(|r| r.agent == name && which(r)).collect();
    let won: Vec<f64> = runs.iter().filter(|r| r.outcome == Outcome::Won).map(|r| r.steps as f64).collect();
    let failed = (runs.len() - won.len()) as f64;
    let all = runs.len().max(1) as f64;
    // An empty sum is -0.
    let sum = won.iter().sum::<f64>() + 0.0;
    [100.0 * won.len() as f64 / all, (sum + NOT_COMPLETED * failed) / all, sum / won.len().max(1) as f64]
}

/// All but random, which hardly ever succeeds.
fn compared() -> Vec<String> {
    policies().iter().skip(1).map(|p| p.name().to_owned()).collect()
}

/// Steps as a multiple of the oracle's where a goal asks for so many things.
struct Ratios {
    things: usize,
    environments: usize,
    /// In the order of [`compared`].
    of: Vec<f64>,
}

fn ratios(report: &Report) -> Vec<Ratios> {
    let mut numbers: Vec<usize> = report.runs.iter().map(|r| r.predicates).collect();
    numbers.sort_unstable();
    numbers.dedup();
    let row = |things: usize| {
        let group = report.runs.chunks(policies().len()).filter(|g| g[0].predicates == things);
        let all_won: Vec<&[Run]> =
            group.filter(|g| g[1..].iter().all(|r| r.outcome == Outcome::Won && r.steps > 0)).collect();
        let steps = |i: usize| all_won.iter().map(|g| g[i].steps).sum::<usize>() as f64;
        let oracle = steps(policies().len() - 1).max(1.0);
        let of = (1..policies().len()).map(|i| steps(i) / oracle).collect();
        Ratios { things, environments: all_won.len(), of }
    };
    numbers.into_iter().map(row).filter(|row| row.environments > 0).collect()
}

fn table_csv(rows: &[(String, [f64; 3])]) -> String {
    let line = |(name, [done, steps, won]): &(String, [f64; 3])| format!("\"{name}\",{done:.2},{steps:.2},{won:.2}\n");
    "policy,completed_percent,steps,steps_when_completed\n".to_owned() + &rows.iter().map(line).collect::<String>()
}

fn table_svg(rows: &[(String, [f64; 3])]) -> String {
    let group = |(name, values): &(String, [f64; 3])| Bars { name: name.clone(), values: values.to_vec() };
    let groups: Vec<Bars> = rows.iter().map(group).collect();
    let measures = [("completed, %", 100.0), ("steps", 100.0), ("steps when completed", 100.0)];
    bars("Table 5.2: the thesis's rows and ours", &measures, &groups)
}

fn ratios_csv(rows: &[Ratios]) -> String {
    let (things, [theirs, best]) = WATCH_AND_HELP;
    let names: String = compared().iter().map(|name| format!(",\"{name}\"")).collect();
    let mut csv = format!("things,environments{names},Watch-And-Help\n");
    for row in rows {
        let cells: String = row.of.iter().map(|ratio| format!(",{ratio:.3}")).collect();
        let reference = if row.things == things { format!("{:.3}", theirs / best) } else { String::new() };
        csv += &format!("{},{}{cells},{reference}\n", row.things, row.environments);
    }
    csv
}

fn ratios_svg(rows: &[Ratios]) -> String {
    let (things, [theirs, best]) = WATCH_AND_HELP;
    let points = |i: usize| rows.iter().map(|row| (row.things as f64, row.of[i])).collect();
    let ours = compared().into_iter().enumerate().map(|(i, name)| Line { name, points: points(i), joined: true });
    let theirs =
        Line { name: "Watch-And-Help's planner".into(), points: vec![(things as f64, theirs / best)], joined: false };
    let all: Vec<Line> = ours.chain([theirs]).collect();
    lines("Steps as a multiple of the oracle's", "things a goal asks for", "multiple", &all)
}

fn write(report: &Report, out: &Path) -> Result<(), Complaint> {
    std::fs::create_dir_all(out).map_err(|e| Complaint::new(format!("{}: {e}", out.display())))?;
    let agents = report.table(By::Agent);
    let by_number = report.table(By::Predicates);
    let (table, ratios) = (table(report), ratios(report));
    let files = [
        ("table_5_2.csv", table_csv(&table)),
        ("table_5_2.svg", table_svg(&table)),
        ("ratios.csv", ratios_csv(&ratios)),
        ("ratios.svg", ratios_svg(&ratios)),
        ("runs.csv", report.csv()),
        ("agents.csv", agents.csv()),
        ("predicates.csv", by_number.csv()),
        ("groups.csv", report.table(By::Group).csv()),
        ("predicates.svg", by_number.svg("Success by the number of things a goal asks for")),
    ];
    for (name, text) in files {
        let path = out.join(name);
        std::fs::write(&path, text).map_err(|e| Complaint::new(format!("{}: {e}", path.display())))?;
    }
    say!("\ntables and plots written to {}", out.display());
    Ok(())
}
