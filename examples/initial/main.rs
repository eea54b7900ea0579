//! Initial environments of the benchmark, in numbers and pictures.
//!
//! `cargo run --release --example initial -- --out out/initial` makes an environment for each of the 145 tasks
//! in a generated home, lists them as JSON Lines with the added objects and their places, and draws the added
//! objects on contact sheets. `--seeds 20` makes twenty environments per task, `--task put_fridge-01` those of
//! one task alone, `--distractors 5` adds five more objects to each.

#[path = "../support/seed.rs"]
mod seed;
mod sheet;
#[path = "../support/mod.rs"]
mod support;

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::time::Instant;

use clap::Parser;
use indicatif::ProgressBar;
use support::{Complaint, say};
use vc_graph::{SceneGraph, Seed, Simulator, did_you_mean};
use vc_tasks::initial::{Added, InitialGenerator, Purpose};
use vc_tasks::library::{Activity, Benchmark};
use vc_tasks::report::predicates;
use virtualcity::initial::{AtHome, Catalogue, at_home};

/// Initial environments of the benchmark, in numbers and pictures.
#[derive(Parser)]
struct Options {
    /// The output folder; it is created if it does not exist.
    #[arg(long, default_value = "out/initial")]
    out: PathBuf,
    /// Only the tasks whose ids have this prefix.
    #[arg(long, default_value = "")]
    task: String,
    /// Number of environments per task.
    #[arg(long, default_value_t = 1, value_parser = clap::value_parser!(u64).range(1..=1_000_000))]
    seeds: u64,
    /// The first seed.
    #[arg(long, default_value_t = 0, allow_negative_numbers = true, value_parser = seed::seed)]
    seed: u64,
    /// Number of distractors to add, objects irrelevant to the task; at most a thousand.
    #[arg(long, default_value_t = 0, value_parser = distractors)]
    distractors: usize,
    /// Number of added objects to draw.
    #[arg(long, default_value_t = 40)]
    pictures: usize,
}

/// More than a thousand would take minutes, and would not fit in a home.
fn distractors(text: &str) -> Result<usize, String> {
    let number = text.parse().ok().filter(|number| *number <= 1000);
    number.ok_or_else(|| "a whole number from 0 to 1000: a home has no place for more".to_owned())
}

type Home = AtHome<Simulator>;

/// The results for one base task.
#[derive(Default)]
struct Sum {
    environments: usize,
    homes: usize,
    tries: usize,
    added: usize,
    credit: f64,
    seconds: f64,
}

fn main() -> Result<(), Complaint> {
    let options = Options::parse();
    let benchmark = Benchmark::v1();
    let chosen: Vec<&Activity> = benchmark.activities.iter().filter(|a| a.id.starts_with(&options.task)).collect();
    if chosen.is_empty() {
        let near = did_you_mean(&options.task, benchmark.activities.iter().map(Activity::group));
        return Err(Complaint::new(format!("no task begins with `{}`{near}", options.task)));
    }
    let path = |name: &str| options.out.join(name);
    virtualcity::files::create_folder(&options.out)?;
    let mut list = String::new();
    let mut sums: BTreeMap<&str, Sum> = BTreeMap::new();
    let mut tiles = Vec::new();
    let mut failed = Vec::new();
    if options.seed.checked_add(options.seeds).is_none() {
        return Err(Complaint::new(format!("seeds end at {}: choose a lower --seed", u64::MAX)));
    }
    let catalogue = Catalogue::default();
    let bar = ProgressBar::new(chosen.len() as u64 * options.seeds);
    for (activity, seed) in chosen.iter().flat_map(|a| (0..options.seeds).map(move |i| (*a, options.seed + i))) {
        bar.inc(1);
        let start = Instant::now();
        let generator = InitialGenerator::new(&catalogue).distractors(options.distractors);
        match at_home(activity, Seed(seed), &generator, |home| Ok(Simulator::new(home))) {
            Ok(made) => {
                sums.entry(activity.group()).or_default().add(&made, start.elapsed().as_secs_f64());
                list.push_str(&format!("{}\n", line(activity, seed, &made)));
                if tiles.len() < options.pictures {
                    tiles.extend(sheet::tiles(activity, &made));
                }
            }
            Err(error) => failed.push(format!("{} {seed}: {error}", activity.id)),
        }
    }
    bar.finish_and_clear();
    virtualcity::files::write(path("environments.jsonl"), list)?;
    table(&sums);
    tiles.truncate(options.pictures);
    sheet::write(&tiles, &path("added.png"))?;
    say!("\n{} written to {}", benchmark.version, options.out.display());
    if failed.is_empty() { Ok(()) } else { Err(Complaint::new(failed.join("\n"))) }
}

impl Sum {
    fn add(&mut self, made: &Home, seconds: f64) {
        self.environments += 1;
        self.homes += made.homes;
        self.tries += made.initial.tries;
        self.added += made.initial.added.len();
        self.credit += made.initial.credit;
        self.seconds += seconds;
    }
}

fn table(sums: &BTreeMap<&str, Sum>) {
    say!(
        "{:<16} {:>6} {:>6} {:>6} {:>6} {:>7} {:>8}",
        "base",
        "number",
        "homes",
        "tries",
        "added",
        "credit",
        "ms each"
    );
    let all = sums.values().fold(Sum::default(), |all, s| Sum {
        environments: all.environments + s.environments,
        homes: all.homes + s.homes,
        tries: all.tries + s.tries,
        added: all.added + s.added,
        credit: all.credit + s.credit,
        seconds: all.seconds + s.seconds,
    });
    for (base, sum) in sums.iter().map(|(base, sum)| (*base, sum)).chain([("all", &all)]) {
        let number = sum.environments.max(1) as f64;
        let each = |value: usize| value as f64 / number;
        say!(
            "{base:<16} {:>6} {:>6.2} {:>6.2} {:>6.2} {:>7.3} {:>8.1}",
            sum.environments,
            each(sum.homes),
            each(sum.tries),
            each(sum.added),
            sum.credit / number,
            1000.0 * sum.seconds / number
        );
    }
}

/// The list entry of an environment.
fn line(activity: &Activity, seed: u64, made: &Home) -> serde_json::Value {
    let scene = &made.initial.scene;
    serde_json::json!({
        "task": activity.id,
        "title": activity.title,
        "goal": made.initial.task.goal,
        "predicates": predicates(&made.initial.task.goal),
        "seed": seed,
        "home": made.home,
        "homes": made.homes,
        "tries": made.initial.tries,
        "credit": made.initial.credit,
        "added": made.initial.added.iter().map(|a| added(scene, a)).collect::<Vec<_>>(),
        "digest": scene.digest().to_string(),
    })
}

/// Describes an added object: `apple.612 on dining_table.88 in kitchen.1`.
fn added(scene: &SceneGraph, added: &Added) -> String {
    let label = |id| scene.label(id);
    let place = added.place.map_or_else(String::new, |p| format!(" {} {}", p.relation, label(p.at)));
    let what = if added.purpose == Purpose::Distractor { " (distractor)" } else { "" };
    format!("{}{place} in {}{what}", label(added.id), label(added.room))
}
