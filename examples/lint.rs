//! Checks tasks for errors and oddities.
//!
//! `cargo run --release --example lint -- FILE...` takes activities in BDDL (`.bddl`), lists of tasks (`.txt`)
//! and VirtualCity's task files (`.json`); for PDDL (`.pddl`) it reports whether the file can be parsed; a
//! folder stands for all activities in it and in its folders, links aside. `--remarks` also shows remarks that are not errors, `--scene` gives
//! the scene with the objects. Unreadable files and lines are named, and the rest is checked. The exit status
//! is 1 if there are errors, and 2 if something could not be read.

mod support;

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Display;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Parser;
use support::{Complaint, say};
use vc_graph::{ClassTable, SceneGraph};
use vc_tasks::format::bddl::ActivityDefinition;
use vc_tasks::format::json;
use vc_tasks::format::pddl::{Domain, PlanningProblem};
use vc_tasks::lint::{self, Finding, FindingKind};
use vc_tasks::{Task, TaskError};

/// Checks tasks for errors and oddities.
#[derive(Parser)]
struct Options {
    /// Files of tasks, or folders of activities.
    #[arg(required = true)]
    files: Vec<PathBuf>,
    /// Also show remarks that are not errors.
    #[arg(long)]
    remarks: bool,
    /// The scene for the tasks in .txt and .json files.
    #[arg(long)]
    scene: Option<PathBuf>,
}

fn main() -> Result<ExitCode, Complaint> {
    let options = Options::parse();
    let read = |file: &PathBuf| virtualcity::read_scene(file, &ClassTable::builtin());
    let scene = options.scene.as_ref().map(read).transpose()?;
    let mut tally = Tally::default();
    let mut files = Vec::new();
    options.files.iter().for_each(|path| collect(path, &mut files, &mut tally));
    for file in &files {
        let mut found = findings(file, scene.as_ref(), &mut tally);
        found.retain(|f| options.remarks || !f.kind.is_remark());
        found.iter().for_each(|finding| say!("{}: {finding}", file.display()));
        let kinds: BTreeSet<FindingKind> = found.into_iter().map(|f| f.kind).collect();
        kinds.into_iter().for_each(|kind| *tally.hits.entry(kind).or_default() += 1);
    }
    say!("\n{} {}", files.len(), if files.len() == 1 { "file" } else { "files" });
    tally.hits.iter().for_each(|(kind, number)| say!("{number:6} with {kind}"));
    if tally.unread > 0 {
        say!("{:6} files or lines could not be read", tally.unread);
    }
    Ok(tally.code())
}

/// The number of files for each kind of finding, and the number of files and lines that could not be read.
#[derive(Default)]
struct Tally {
    hits: BTreeMap<FindingKind, usize>,
    unread: usize,
}

impl Tally {
    /// Prints and counts an unreadable file or line.
    fn cannot_read(&mut self, why: impl Display) {
        say!("{why}");
        self.unread += 1;
    }

    fn code(&self) -> ExitCode {
        match () {
            () if self.unread > 0 => ExitCode::from(2),
            () if self.hits.keys().any(|kind| !kind.is_remark()) => ExitCode::FAILURE,
            () => ExitCode::SUCCESS,
        }
    }
}

fn collect(path: &Path, files: &mut Vec<PathBuf>, tally: &mut Tally) {
    if !path.is_dir() {
        return files.push(path.to_owned());
    }
    let entries = std::fs::read_dir(path).and_then(|entries| entries.map(|e| Ok(e?.path())).collect());
    let mut entries: Vec<PathBuf> = match entries {
        Ok(entries) => entries,
        Err(why) => return tally.cannot_read(format!("{}: {why}", path.display())),
    };
    let before = files.len();
    entries.sort();
    // Domain files are not tasks.
    let task = |p: &&PathBuf| {
        let name = p.file_name().unwrap_or_default().to_string_lossy();
        // A link to a folder above would lead round and round.
        (p.is_dir() && !p.is_symlink()) || (name.ends_with(".bddl") && !name.starts_with("domain"))
    };
    entries.iter().filter(task).for_each(|entry| collect(entry, files, tally));
    if files.len() == before {
        tally.cannot_read(format!(
            "{}: no activity (.bddl) is in this folder; name other files one by one",
            path.display()
        ));
    }
}

fn findings(file: &Path, scene: Option<&SceneGraph>, tally: &mut Tally) -> Vec<Finding> {
    let text = match virtualcity::read_text(file) {
        Ok(text) => text,
        Err(why) => {
            tally.cannot_read(format_args!("{why}"));
            return Vec::new();
        }
    };
    if file.extension().is_some_and(|e| e == "pddl") {
        return planning(file, &text, tally);
    }
    if file.extension().is_some_and(|e| e == "bddl") {
        let activity = ActivityDefinition::read(&text).map_err(|why| tally.cannot_read(why.in_file(file)));
        return activity.map(|activity| lint::activity(&activity)).unwrap_or_default();
    }
    let of = |task: &Task| {
        let titled = |f: Finding| Finding { part: format!("{} ({})", f.part, task.title), ..f };
        lint::goal(&task.goal, scene).into_iter().map(titled).collect::<Vec<_>>()
    };
    tasks(file, &text, tally).iter().flat_map(of).collect()
}

/// Only checks that planning domains and problems can be parsed.
fn planning(file: &Path, text: &str, tally: &mut Tally) -> Vec<Finding> {
    let domain = |d: Domain| format!("the PDDL domain {}, with {} operators", d.name, d.operators.len());
    let problem = |p: PlanningProblem| format!("the PDDL problem {}, with {} things", p.name, p.objects.len());
    let read = if is_problem(text) { text.parse().map(problem) } else { text.parse().map(domain) };
    match read {
        Ok(about) => say!("{}: {about}; PDDL is read here, and looked at no further", file.display()),
        Err(why) => tally.cannot_read(why.in_file(file)),
    }
    Vec::new()
}

/// Whether a PDDL file is meant as a problem: `(define (problem ...`.
fn is_problem(text: &str) -> bool {
    let lines = text.lines().map(|line| line.split(';').next().unwrap_or_default());
    let mut words = lines.flat_map(|line| line.split(|c: char| c.is_whitespace() || "()".contains(c)));
    words.by_ref().any(|word| word.trim_start_matches('\u{feff}').eq_ignore_ascii_case("define"))
        && words.find(|word| !word.is_empty()).is_some_and(|word| word.eq_ignore_ascii_case("problem"))
}

/// The tasks of a list or of a task file of VirtualCity.
fn tasks(file: &Path, text: &str, tally: &mut Tally) -> Vec<Task> {
    if file.extension().is_some_and(|e| e == "json") {
        return json::read(text).map_err(|why| tally.cannot_read(why.in_file(file))).unwrap_or_default();
    }
    let told = |task: Result<Task, _>| {
        task.map_err(|why: TaskError| tally.cannot_read(format!("{}: {why}", file.display()))).ok()
    };
    Task::read_lines(text).filter_map(told).collect()
}
