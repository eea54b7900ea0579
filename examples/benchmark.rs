//! The thesis's evaluation: random, oracle and both planners on the 145 tasks.
//!
//! `cargo run --release --example benchmark` makes an apartment for each task and seed
//! and lets every policy try it, symbolically, on all cores; it prints the thesis's
//! Table 5.2 beside ours and writes tables and plots. The results do not depend on the
//! number of threads.

#[expect(dead_code, reason = "this example reads no files")]
mod support;

use std::path::{Path, PathBuf};

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

fn show(report: &Report, environments: usize, unmade: usize) {
    say!("{environments} environments, {unmade} of them could not be made");
    say!("{:<34}{:>12}{:>12}{:>22}", "", "completed", "steps", "steps when completed");
    let row = |name: &str, [done, steps, won]: [f64; 3]| say!("{name:<34}{done:>11.2}%{steps:>12.2}{won:>22.2}");
    for (name, figures) in THESIS {
        row(name, figures);
    }
    for policy in policies() {
        row(policy.name(), figures(report, policy.name(), |_| true));
    }
    let solvable: Vec<&Run> = report.runs.iter().filter(|r| r.agent == "oracle" && r.best_steps.is_some()).collect();
    say!("\nThe oracle solves {} of {}. Of these:", solvable.len(), environments - unmade);
    for policy in policies() {
        row(policy.name(), figures(report, policy.name(), |r| r.best_steps.is_some()));
    }
    say!(
        "\nSteps as a multiple of the oracle's, by the number of things a goal asks for, where all but random succeed:"
    );
    ratios(report);
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

fn ratios(report: &Report) {
    let names: Vec<String> = policies().iter().skip(1).map(|p| p.name().to_owned()).collect();
    say!("{:>10}{:>14}  {}", "things", "environments", names.iter().map(|n| format!("{n:>18}")).collect::<String>());
    let mut numbers: Vec<usize> = report.runs.iter().map(|r| r.predicates).collect();
    numbers.sort_unstable();
    numbers.dedup();
    for number in numbers {
        let group: Vec<&[Run]> = report.runs.chunks(policies().len()).filter(|g| g[0].predicates == number).collect();
        let all_won: Vec<&&[Run]> =
            group.iter().filter(|g| g[1..].iter().all(|r| r.outcome == Outcome::Won && r.steps > 0)).collect();
        let oracle: usize = all_won.iter().map(|g| g[g.len() - 1].steps).sum();
        let cell = |i: usize| {
            let steps: usize = all_won.iter().map(|g| g[i].steps).sum();
            format!("{:>18.2}", steps as f64 / oracle.max(1) as f64)
        };
        let cells: String = (1..policies().len()).map(cell).collect();
        say!("{number:>10}{:>14}  {cells}", all_won.len());
    }
}

fn write(report: &Report, out: &Path) -> Result<(), Complaint> {
    std::fs::create_dir_all(out).map_err(|e| Complaint::new(format!("{}: {e}", out.display())))?;
    let agents = report.table(By::Agent);
    let by_number = report.table(By::Predicates);
    let files = [
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
