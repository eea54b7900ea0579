//! Generates apartments from seeds: a single one with pictures and files, a sheet of floor plans, or a data set
//! of any size.
//!
//! `cargo run --release --example apartment -- --seed 42 --out out/apartment` writes the scene (VirtualCity's
//! JSON and the thesis's), the floor plan (SVG and PNG), the model (glTF) and a report.
//! `--bedrooms 3 --area 95 --open-kitchen` and the like specify the apartment. `--sheet` draws 24 plans in one
//! picture.
//!
//! `--count 100000 --jobs 8` writes a data set: files of a thousand homes each, a manifest, statistics with
//! plots. If it is started again, it continues where it stopped. In an array job, `--shard 3/16` makes every
//! sixteenth file; once all are there, the same command without `--shard` writes the manifest and statistics of
//! the whole set.

#[path = "../support/seed.rs"]
mod seed;
#[path = "../support/mod.rs"]
mod support;

mod manifest;
mod one;
mod record;
mod set;
mod sheet;
mod wishes;

use std::path::PathBuf;

use clap::Parser;
use support::Complaint;
use wishes::Wishes;

/// A home consists of some ten thousand small allocations.
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

/// Generates apartments from seeds.
#[derive(Parser)]
struct Options {
    /// The seed; for several homes the first seed.
    #[arg(long, default_value_t = 42, allow_negative_numbers = true, value_parser = seed::seed)]
    seed: u64,
    /// The output folder; it is created if it does not exist.
    #[arg(long, default_value = "out/apartment")]
    out: PathBuf,
    #[command(flatten)]
    wishes: Wishes,
    /// Draw 24 plans in one picture.
    #[arg(long, conflicts_with = "count")]
    sheet: bool,
    /// Make a data set of this number of homes, from as many seeds.
    #[arg(long, value_parser = clap::value_parser!(u64).range(1..=1_000_000_000))]
    count: Option<u64>,
    /// Number of threads that make a data set; by default the number of processors.
    #[arg(long, value_parser = clap::value_parser!(u16).range(1..=1024))]
    jobs: Option<u16>,
    /// Make only every n-th file of a data set: 0/8, 1/8 ... 7/8.
    #[arg(long, requires = "count")]
    shard: Option<set::Shard>,
    /// Homes per file of a data set.
    #[arg(long, default_value_t = 1000, value_parser = clap::value_parser!(u64).range(1..=1_000_000))]
    per_file: u64,
}

fn main() -> Result<(), Complaint> {
    let options = Options::parse();
    let specification = options.wishes.specification()?;
    let seeds = options.count.unwrap_or(if options.sheet { sheet::PLANS } else { 1 });
    if options.seed.checked_add(seeds.saturating_sub(1)).is_none() {
        return Err(Complaint::new(format!("seeds end at {}: choose a lower --seed", u64::MAX)));
    }
    virtualcity::files::create_folder(&options.out)?;
    match options.count {
        Some(count) => set::run(&set::Set {
            specification,
            recipe: options.wishes.recipe(),
            seed: options.seed,
            count,
            per_file: options.per_file,
            shard: options.shard,
            jobs: options.jobs.map_or_else(processors, usize::from),
            out: options.out,
        }),
        None if options.sheet => sheet::write(&specification, options.seed, &options.out),
        None => one::write(&specification, options.seed, &options.out),
    }
}

fn processors() -> usize {
    std::thread::available_parallelism().map_or(1, usize::from)
}
