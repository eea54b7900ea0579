//! Random states of BEHAVIOR's activities with our verdicts, as JSON Lines, for comparison by
//! `peers/bddl_verdicts.py`.
//!
//! `cargo run --release -p vc-tasks --example bddl_verdicts -- FOLDER [STATES [SEED]]` prints for
//! each activity under the folder a number of lines (10): the file, the facts of the goal that
//! hold, and the conjuncts of the goal that are fulfilled, `marginal` with pairs evaluated as in
//! the reference implementation and `matching` strictly.

use std::error::Error;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use vc_graph::Seed;
use vc_graph::goal::Pairing;
use vc_tasks::format::bddl::{ActivityDefinition, Facts};

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let folder = arguments.next().ok_or("say where the activities are")?;
    let states: u64 = arguments.next().map_or(Ok(10), |n| n.parse())?;
    let seed: u64 = arguments.next().map_or(Ok(1), |n| n.parse())?;
    let mut files = Vec::new();
    collect(Path::new(&folder), &mut files)?;
    files.sort();
    let mut out = io::BufWriter::new(io::stdout().lock());
    for (number, file) in files.iter().enumerate() {
        let located = |e: vc_tasks::format::ReadError| e.in_file(file);
        let activity = ActivityDefinition::read(&std::fs::read_to_string(file)?).map_err(located)?;
        let marginal = Facts::from_activity(&activity, Pairing::Marginal).map_err(located)?;
        let matching = Facts::from_activity(&activity, Pairing::Matching).map_err(located)?;
        for state in 0..states {
            let mut dice = Seed(seed).nth(number as u64).nth(state).stream();
            // The probability rises from states where nearly nothing holds to states where nearly
            // everything does.
            let often = (state + 1) as f32 / (states + 1) as f32;
            let holds: Vec<bool> = marginal.names().iter().map(|_| dice.unit() < often).collect();
            let met = |facts: &Facts| facts.heads(|i| holds.get(i).copied().unwrap_or(false));
            let facts: Vec<&String> =
                marginal.names().iter().zip(&holds).filter(|(_, h)| **h).map(|(n, _)| n).collect();
            let (marginal, matching) = (met(&marginal), met(&matching));
            let line = serde_json::json!({ "file": file, "facts": facts, "marginal": marginal, "matching": matching });
            writeln!(out, "{line}")?;
        }
    }
    Ok(())
}

fn collect(folder: &Path, files: &mut Vec<PathBuf>) -> io::Result<()> {
    for entry in std::fs::read_dir(folder)? {
        let entry = entry?.path();
        let name = entry.file_name().unwrap_or_default().to_string_lossy().into_owned();
        if entry.is_dir() {
            collect(&entry, files)?;
        } else if name.starts_with("problem") && name.ends_with(".bddl") {
            files.push(entry);
        }
    }
    Ok(())
}
