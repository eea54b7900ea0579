//! Looks for what is wrong or odd with tasks.
//!
//! `cargo run --release --example lint -- FILE...` takes activities in BDDL
//! (`.bddl`), lists of tasks (`.txt`) and our task files (`.json`); a folder stands
//! for all such files in it. `--remarks` shows what is no fault as well, `--scene`
//! tells which things there are. It ends with 1 if something is wrong.

mod support;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Parser;
use support::{Complaint, say};
use vc_graph::format::read_scene;
use vc_graph::{ClassTable, SceneGraph};
use vc_tasks::Task;
use vc_tasks::format::bddl::Activity;
use vc_tasks::format::json;
use vc_tasks::lint::{self, Finding, Kind};

/// Looks for what is wrong or odd with tasks.
#[derive(Parser)]
struct Options {
    /// Files of tasks, or folders of them.
    #[arg(required = true)]
    files: Vec<PathBuf>,
    /// Also show what is no fault.
    #[arg(long)]
    remarks: bool,
    /// The scene in which the tasks of .txt and .json files are to be done.
    #[arg(long)]
    scene: Option<PathBuf>,
}

fn main() -> Result<ExitCode, Complaint> {
    let options = Options::parse();
    let read = |file: &PathBuf| read_scene(&support::read(file)?, &ClassTable::builtin()).map_err(Complaint::new);
    let scene = options.scene.as_ref().map(read).transpose()?;
    let mut files = Vec::new();
    options.files.iter().try_for_each(|path| collect(path, &mut files))?;
    let mut hits: BTreeMap<Kind, usize> = BTreeMap::new();
    for file in &files {
        let mut found = findings(file, scene.as_ref())?;
        found.retain(|f| options.remarks || !f.kind.is_remark());
        found.iter().for_each(|finding| say!("{}: {finding}", file.display()));
        let mut kinds: Vec<Kind> = found.into_iter().map(|f| f.kind).collect();
        kinds.sort_unstable();
        kinds.dedup();
        kinds.into_iter().for_each(|kind| *hits.entry(kind).or_default() += 1);
    }
    say!("\n{} files", files.len());
    hits.iter().for_each(|(kind, number)| say!("{number:6} with {kind}"));
    let wrong = hits.keys().any(|kind| !kind.is_remark());
    Ok(if wrong { ExitCode::FAILURE } else { ExitCode::SUCCESS })
}

fn collect(path: &Path, files: &mut Vec<PathBuf>) -> Result<(), Complaint> {
    if !path.is_dir() {
        files.push(path.to_owned());
        return Ok(());
    }
    let located = |e: std::io::Error| Complaint::new(format!("{}: {e}", path.display()));
    let mut entries = Vec::new();
    for entry in std::fs::read_dir(path).map_err(located)? {
        entries.push(entry.map_err(located)?.path());
    }
    entries.sort();
    // Domains are no tasks.
    let task = |p: &&PathBuf| {
        let name = p.file_name().unwrap_or_default().to_string_lossy();
        p.is_dir() || (name.ends_with(".bddl") && !name.starts_with("domain"))
    };
    entries.iter().filter(task).try_for_each(|entry| collect(entry, files))
}

fn findings(file: &Path, scene: Option<&SceneGraph>) -> Result<Vec<Finding>, Complaint> {
    let text = support::read(file)?;
    let located = |e: &dyn std::fmt::Display| Complaint::new(format!("{}: {e}", file.display()));
    let tasks = match file.extension().and_then(|e| e.to_str()) {
        Some("bddl") => {
            let activity = Activity::read(&text).map_err(|e| Complaint::new(e.in_file(file)))?;
            return Ok(lint::activity(&activity));
        }
        Some("json") => json::read(&text).map_err(|e| Complaint::new(e.in_file(file)))?,
        _ => Task::read_list(&text).map_err(|e| located(&e))?,
    };
    let of = |task: &Task| {
        let titled = |f: Finding| Finding { part: format!("{} ({})", f.part, task.title), ..f };
        lint::goal(&task.goal, scene).into_iter().map(titled).collect::<Vec<_>>()
    };
    Ok(tasks.iter().flat_map(of).collect())
}
