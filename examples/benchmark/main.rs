//! The thesis's evaluation: random, oracle and both planners on the 145 tasks.
//!
//! `cargo run --release --example benchmark` makes an apartment for each task and seed, with bodies that move,
//! and lets random, planner and oracle attempt the task on all cores. It prints the thesis's Table 5.2 beside
//! the results and writes tables and plots, with the reason of every failure. `--symbolic` omits the bodies and
//! runs more policies. The results do not depend on the number of threads. Finished attempts are kept in
//! `unfinished.jsonl` until the tables are written, so that the same command continues an interrupted run.

mod attempt;
#[path = "../support/chart.rs"]
mod chart;
#[path = "../support/mod.rs"]
mod support;
mod tables;

use std::path::{Path, PathBuf};

use attempt::{Attempt, attempt, policies};
use clap::Parser;
use indicatif::{ProgressBar, ProgressStyle};
use rayon::prelude::*;
use support::{Complaint, say};
use tables::{Figures, Ratios, Tables, WATCH_AND_HELP};
use vc_tasks::library::{Activity, Benchmark};
use vc_tasks::report::{GroupBy, Report, Run};
use virtualcity::{FileError, ResumableRun};

/// Random, oracle and both planners on the 145 tasks.
#[derive(Parser)]
struct Options {
    /// Number of apartments for each task.
    #[arg(long, default_value_t = 3, value_parser = clap::value_parser!(u64).range(1..=1_000_000))]
    seeds: u64,
    /// Number of actions after which an attempt ends; the thesis stops after 100.
    #[arg(long, default_value_t = 100)]
    steps: usize,
    /// Run without bodies, and with all policies.
    #[arg(long)]
    symbolic: bool,
    /// Only tasks whose id has this prefix, such as `put_fridge`.
    #[arg(long, default_value = "")]
    only: String,
    /// Number of threads; 0 for all cores.
    #[arg(long, default_value_t = 0, value_parser = clap::value_parser!(u16).range(..=1024))]
    threads: u16,
    /// The output folder for tables and plots.
    #[arg(long, default_value = "out/benchmark")]
    out: PathBuf,
}

fn main() -> Result<(), Complaint> {
    let options = Options::parse();
    rayon::ThreadPoolBuilder::new().num_threads(options.threads.into()).build_global().map_err(Complaint::new)?;
    let activities: Vec<Activity> =
        Benchmark::v1().activities.into_iter().filter(|a| a.id.starts_with(&options.only)).collect();
    if activities.is_empty() {
        return Err(no_such_task(&options.only));
    }
    let jobs: Vec<(&Activity, u64)> = activities.iter().flat_map(|a| (0..options.seeds).map(move |s| (a, s))).collect();
    let style =
        ProgressStyle::with_template("{bar:40} {pos}/{len} environments, {eta} left").map_err(Complaint::new)?;
    let bar = ProgressBar::new(jobs.len() as u64).with_style(style);
    let recipe = (env!("CARGO_PKG_VERSION"), options.steps, options.symbolic);
    let before: ResumableRun<Result<Attempt, String>> =
        ResumableRun::open(options.out.join("unfinished.jsonl"), &recipe)?;
    let done = |(activity, seed): &(&Activity, u64)| {
        let key = format!("{} in home {seed}", activity.id);
        let tried = match before.get(&key) {
            Some(there) => Ok(there.clone()),
            None => before.add(&key, &attempt(activity, *seed, options.steps, options.symbolic)),
        };
        bar.inc(1);
        tried
    };
    let tried: Vec<Result<Attempt, String>> = jobs.par_iter().map(done).collect::<Result<_, FileError>>()?;
    bar.finish_and_clear();
    let (made, unmade): (Vec<_>, Vec<_>) = tried.into_iter().partition(Result::is_ok);
    let mut all = Attempt::default();
    made.into_iter().flatten().for_each(|one| all.append(one));
    let names = policies(options.symbolic).iter().map(|p| p.name().to_owned()).collect();
    let tables = Tables { report: Report::new(all.runs), names };
    show(&tables, jobs.len(), &unmade.into_iter().filter_map(Result::err).collect::<Vec<_>>());
    say!("\n{} homes were passed over{}", all.passed_over.len(), if all.passed_over.is_empty() { "" } else { ":" });
    all.passed_over.iter().for_each(|line| say!("  {line}"));
    if !options.symbolic {
        let done = all.done.max(1) as f64;
        let agreed = 100.0 * (done - all.disagreements.len() as f64) / done;
        say!("\n{} actions done with bodies; rule and bodies agree on {agreed:.2}%", all.done);
        all.disagreements.iter().for_each(|line| say!("  {line}"));
    }
    let failed: Vec<&String> = all.failures.iter().filter(|line| !line.starts_with("random")).collect();
    say!("\n{} failures of others than random{}", failed.len(), if failed.is_empty() { "" } else { ":" });
    failed.iter().for_each(|line| say!("  {line}"));
    write(&tables, &all.failures, &options.out)?;
    Ok(before.remove()?)
}

fn no_such_task(only: &str) -> Complaint {
    let all = Benchmark::v1().activities;
    let groups: std::collections::BTreeSet<&str> = all.iter().map(Activity::group).collect();
    let groups: Vec<&str> = groups.into_iter().collect();
    Complaint::new(format!("no task's id begins with `{only}`; groups of tasks are {}", groups.join(", ")))
}

fn show(tables: &Tables, environments: usize, unmade: &[String]) {
    let report = &tables.report;
    say!("{environments} environments, {} of them could not be made", unmade.len());
    unmade.iter().for_each(|why| say!("  {why}"));
    say!("{:<34}{:>12}{:>12}{:>22}", "", "completed", "steps", "steps when completed");
    let row = |name: &str, (done, steps, won): Figures| {
        let won = won.map_or_else(|| "-".to_owned(), |won| format!("{won:.2}"));
        say!("{name:<34}{done:>11.2}%{steps:>12.2}{won:>22}");
    };
    tables.rows().iter().for_each(|(name, figures)| row(name, *figures));
    let solvable: Vec<&Run> = report.runs.iter().filter(|r| r.agent == "oracle" && r.best_steps.is_some()).collect();
    say!("\nThe oracle solves {} of {}. Of these:", solvable.len(), environments - unmade.len());
    for name in &tables.names {
        row(name, tables.figures(name, |r| r.best_steps.is_some()));
    }
    say!(
        "\nSteps as a multiple of the oracle's, by the number of things a goal asks for, where all but random succeed:"
    );
    let names: Vec<String> = tables.compared().iter().map(|name| format!("{name:>18}")).collect();
    say!("{:>10}{:>14}  {}", "things", "environments", names.concat());
    for Ratios { things, environments, of } in tables.ratios() {
        let cells: Vec<String> = of.iter().map(|ratio| format!("{ratio:>18.2}")).collect();
        say!("{things:>10}{environments:>14}  {}", cells.concat());
    }
    let (things, [theirs, best]) = WATCH_AND_HELP;
    say!("Watch-And-Help's planner against the optimum at {things}: {theirs} / {best} = {:.2}", theirs / best);
}

fn write(tables: &Tables, failures: &[String], out: &Path) -> Result<(), Complaint> {
    virtualcity::files::create_folder(out)?;
    let report = &tables.report;
    let agents = report.table(GroupBy::Agent);
    let by_number = report.table(GroupBy::Predicates);
    let failures: String = failures.iter().map(|line| format!("{line}\n")).collect();
    let files = [
        ("table_5_2.csv", tables.table_csv()),
        ("table_5_2.svg", tables.table_svg()),
        ("ratios.csv", tables.ratios_csv()),
        ("ratios.svg", tables.ratios_svg()),
        ("runs.csv", report.csv()),
        ("failures.txt", failures),
        ("agents.csv", agents.csv()),
        ("predicates.csv", by_number.csv()),
        ("groups.csv", report.table(GroupBy::Group).csv()),
        ("predicates.svg", by_number.svg("Success by the number of things a goal asks for")),
    ];
    for (name, text) in files {
        let path = out.join(name);
        virtualcity::files::write(&path, text)?;
    }
    say!("\ntables and plots written to {}", out.display());
    Ok(())
}
