//! Data of the Embodied Agent Interface: programs with the graphs before and after them, and goals.
//! VirtualHome's own files of such graphs are read as scenes.

use std::collections::BTreeMap;
use std::sync::Arc;

use serde::Deserialize;

use super::program::{self, Program};
use super::virtualhome::{EnvironmentGraph, RelationType};
use super::{FormatError, FormatProblem, Source};
use crate::goal::{Goal, Predicate, Term};
use crate::spelling::clip;
use crate::{ClassTable, NodeId, Relation, SceneGraph, State, Verb, Word};

/// A program with its initial and final graphs.
#[derive(Debug, Clone, PartialEq)]
pub struct Record {
    /// Its identifier, `file101_2`.
    pub id: String,
    /// Its title, `Work`.
    pub title: String,
    /// The program.
    pub program: Program,
    /// The graph before the program.
    pub initial: EnvironmentGraph,
    /// The graph after the program, according to VirtualHome's simulator.
    pub last: EnvironmentGraph,
}

#[derive(Deserialize)]
struct RecordFile {
    id: String,
    #[serde(default)]
    title: String,
    program: Vec<String>,
    init_graph: EnvironmentGraph,
    final_graph: EnvironmentGraph,
}

/// Parses one line of a JSON Lines file of programs.
///
/// # Errors
/// [`FormatError`], with the field and the expected form.
pub fn read_record(line: &str) -> Result<Record, FormatError> {
    let source = Source::new("EAI program", line);
    let file: RecordFile = source.json()?;
    let step = |(i, line): (usize, &String)| {
        program::step(line).map_err(|problem| source.error(format!("program[{i}]"), problem))
    };
    let steps = file.program.iter().enumerate().map(step).collect::<Result<_, _>>()?;
    let program = Program { heading: Vec::new(), steps };
    Ok(Record { id: file.id, title: file.title, program, initial: file.init_graph, last: file.final_graph })
}

#[derive(Deserialize)]
struct GraphsFile {
    init_graph: Option<EnvironmentGraph>,
    final_graph: Option<EnvironmentGraph>,
}

/// Reads the scene of a file with graphs before and after a program, with or without the program itself: the
/// graph before, or if there is none the graph after.
///
/// # Errors
/// [`FormatError`], with the field and the expected form.
pub(crate) fn read_start(text: &str, classes: &Arc<ClassTable>) -> Result<SceneGraph, FormatError> {
    let source = Source::new("VirtualHome graphs", text);
    let GraphsFile { init_graph, final_graph } = source.json()?;
    let first = init_graph.map(|g| ("init_graph", g)).or(final_graph.map(|g| ("final_graph", g)));
    let missing = || source.error(String::new(), FormatProblem::Shape("there is no `init_graph`".into()));
    let (key, graph) = first.ok_or_else(missing)?;
    graph.build("VirtualHome", classes).map_err(|(field, problem)| source.error(format!("{key}.{field}"), problem))
}

/// A goal given as states, edges and actions, and also as a formula.
#[derive(Debug, Clone, PartialEq)]
pub struct EaiTask {
    /// Its title, `Wash hands`.
    pub title: String,
    /// The final states and relations, and the actions that must have been performed.
    pub goal: Goal,
    /// The formula that also states the order, if there is one.
    pub formula: Option<Goal>,
}

#[derive(Deserialize)]
struct TaskFile {
    #[serde(default)]
    title: String,
    vh_goal: GoalFile,
    #[serde(default)]
    tl_goal: Option<String>,
}

#[derive(Deserialize)]
struct GoalFile {
    #[serde(default)]
    actions: Vec<String>,
    #[serde(default)]
    goal: Vec<PartFile>,
}

#[derive(Deserialize)]
#[serde(untagged)]
enum PartFile {
    State { id: u32, class_name: String, state: String },
    Edge { from_id: u32, relation_type: RelationType, to_id: u32 },
}

/// Parses goals: a JSON object from identifiers to tasks.
///
/// # Errors
/// [`FormatError`], with the field and the expected form.
pub fn read_tasks(text: &str) -> Result<BTreeMap<String, EaiTask>, FormatError> {
    let source = Source::new("EAI goals", text);
    let file: BTreeMap<String, TaskFile> = source.json()?;
    let mut tasks = BTreeMap::new();
    for (id, task) in file {
        let goal = task.vh_goal.goal().map_err(|problem| source.error(format!("{id}.vh_goal"), problem))?;
        let formula = task.tl_goal.as_deref().map(Goal::from_eai).transpose();
        let formula = formula.map_err(|e| source.error(format!("{id}.tl_goal"), FormatProblem::Goal(e)))?;
        tasks.insert(id, EaiTask { title: task.title, goal, formula });
    }
    Ok(tasks)
}

impl GoalFile {
    fn goal(&self) -> Result<Goal, FormatProblem> {
        let done = self.actions.iter().map(|words| done(words));
        let held = self.goal.iter().map(PartFile::goal);
        let mut parts = done.chain(held).collect::<Result<Vec<_>, _>>()?;
        Ok(if parts.len() == 1 { parts.remove(0) } else { Goal::And(parts) })
    }
}

/// Parses `TOUCH|PUSH`: one of these verbs was performed on any object.
fn done(words: &str) -> Result<Goal, FormatProblem> {
    let read = |word: &str| {
        let unknown = || Verb::parse(word).map_err(FormatProblem::Word);
        let verb = Verb::from_virtualhome(word).map_or_else(unknown, Ok)?;
        Ok(Goal::literal(Predicate::Did(verb), vec![Term::Anything; verb.arity()]))
    };
    let mut parts = words.split('|').map(read).collect::<Result<Vec<Goal>, FormatProblem>>()?;
    Ok(if parts.len() == 1 { parts.remove(0) } else { Goal::Or(parts) })
}

impl PartFile {
    fn goal(&self) -> Result<Goal, FormatProblem> {
        match self {
            Self::State { id, class_name, state } => {
                let state = State::parse(state)?;
                let node = Term::Node(Some(clip(class_name)), NodeId(*id));
                Ok(Goal::literal(Predicate::State(state), vec![node]))
            }
            Self::Edge { from_id, relation_type, to_id } => {
                let relation = match relation_type {
                    RelationType::On => Relation::On,
                    RelationType::Inside => Relation::Inside,
                    RelationType::Between => Relation::Between,
                    RelationType::Close => Relation::Near,
                    RelationType::Facing => Relation::Facing,
                    RelationType::HoldsRh => Relation::HoldsRight,
                    RelationType::HoldsLh => Relation::HoldsLeft,
                    RelationType::Sitting => Relation::SittingOn,
                };
                let terms = [*from_id, *to_id].map(|id| Term::Node(None, NodeId(id))).to_vec();
                Ok(Goal::literal(Predicate::Relation(relation), terms))
            }
        }
    }
}
