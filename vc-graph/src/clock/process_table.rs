//! The table of processes: which ones go on in a scene.

use std::sync::{Arc, LazyLock};

use super::error::{ClockError, ClockProblem};
use super::kind::Kinds;
use super::needs::{Signed, Site};
use super::process::{Process, Rule};
use super::text::{Line, lines, name, span};
use crate::class::ClassTable;
use crate::{Node, NodeId, SceneGraph, State};

const COLUMNS: [&str; 9] =
    ["process", "things", "while", "place", "place is", "becomes", "inside", "inside becomes", "after"];

/// Processes that machines and matter go through by themselves: a kettle boils, a washing machine washes, food cools,
/// ice melts.
///
/// The built-in table is `data/processes.txt`; [`ProcessTable::parse`] describes its form and
/// [`ProcessTable::extended`] adds lines. [`Running`](super::Running) lets processes go on in time.
///
/// ```
/// use vc_graph::clock::ProcessTable;
/// use vc_graph::{Draft, SceneBuilder, State};
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let soup = scene.add_in(kitchen, Draft::new("soup").state(State::Hot))?;
/// let processes = ProcessTable::builtin().processes(&scene.build());
/// assert_eq!(processes.len(), 1);
/// assert_eq!((processes[0].node, &*processes[0].name), (soup, "cooling"));
/// # Ok::<(), vc_graph::EditError>(())
/// ```
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ProcessTable {
    rules: Vec<Rule>,
    names: Vec<Arc<str>>,
}

impl ProcessTable {
    /// The built-in processes, read once per process of the machine.
    pub fn builtin() -> Arc<Self> {
        static TABLE: LazyLock<Arc<ProcessTable>> = LazyLock::new(|| {
            let text = include_str!("../../data/processes.txt");
            let table = ProcessTable::parse("processes.txt", text, &ClassTable::builtin());
            // A test reads the built-in text and shows its errors.
            Arc::new(table.unwrap_or_default())
        });
        TABLE.clone()
    }

    /// Parses a table of processes.
    ///
    /// One line each, nine columns separated by `|`; `#` starts a comment line:
    ///
    /// `process | things | while | place | place is | becomes | inside | inside becomes | after`
    ///
    /// - *process*: its name. If several lines of a name apply to a thing, **the last one counts**: first what holds
    ///   for a category, then the exceptions by class. A last line that changes nothing switches those before it off.
    /// - *things*: kinds of things, separated by spaces. `food` are all things of that class and its kinds,
    ///   `category:food` those of a category, `affords:washable` those with an affordance, `*` all. Rooms and agents
    ///   are no things.
    /// - *while*: the states in which it goes on; after a minus sign, those in which it does not: `hot -on`.
    /// - *place*: `in` kinds of things: inside one, directly or through others; `at`: inside or on one; `away`:
    ///   neither. Empty for anywhere.
    /// - *place is*: the states of that place, as in *while*; `running` stands for a place that is on or has no switch.
    /// - *becomes*: the states that the thing enters at the end; after a minus sign, those that it leaves.
    /// - *inside*, *inside becomes*: kinds of things inside the thing, and their states at the end.
    /// - *after*: the time from its begin to its end, a number and `s`, `min`, `h` or `days`.
    ///
    /// ```
    /// use vc_graph::clock::ProcessTable;
    /// use vc_graph::ClassTable;
    /// let text = "washing | washing_machine | on closed | | | off | affords:washable | clean wet | 30 min";
    /// let table = ProcessTable::parse("quick.txt", text, &ClassTable::builtin())?;
    /// assert_eq!(table.names().collect::<Vec<_>>(), ["washing"]);
    /// # Ok::<(), vc_graph::clock::ClockError>(())
    /// ```
    ///
    /// # Errors
    /// [`ClockError`], with line, column and the expected form.
    pub fn parse(file: &str, text: &str, classes: &ClassTable) -> Result<Self, ClockError> {
        Self::default().extended(file, text, classes)
    }

    /// This table extended by the lines of another text: they come last and therefore count before those of this table.
    ///
    /// # Errors
    /// As [`ProcessTable::parse`].
    pub fn extended(&self, file: &str, text: &str, classes: &ClassTable) -> Result<Self, ClockError> {
        let mut table = self.clone();
        for mut rule in lines((file, text), &COLUMNS, classes, rule)? {
            rule.group = table.group(&rule.name);
            table.rules.push(rule);
        }
        Ok(table)
    }

    fn group(&mut self, name: &Arc<str>) -> usize {
        let known = self.names.iter().position(|other| other == name);
        known.unwrap_or_else(|| {
            self.names.push(name.clone());
            self.names.len() - 1
        })
    }

    /// The names of the processes, in the order in which they first occur.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.names.iter().map(|name| &**name)
    }

    /// The processes that go on in a scene, in the order of node numbers and then of names in the table. A process that
    /// would change nothing does not go on.
    ///
    /// Costs, for each node, a comparison of states for each line, and a look-up of the class for the few lines whose
    /// states fit.
    pub fn processes(&self, graph: &SceneGraph) -> Vec<Process> {
        graph.nodes().flat_map(|node| self.processes_of(graph, node)).collect()
    }

    /// Whether some process brings things into a state.
    pub fn brings_about(&self, state: State) -> bool {
        self.rules.iter().any(|rule| rule.enters(state) || rule.enters_inside(state))
    }

    /// Whether some process could bring a thing of a scene into a state, now or after actions: the scene has the machine
    /// or the place that it takes, and the thing is there or can be carried there. The states that it needs as well, as
    /// that the machine is on, are not asked for.
    ///
    /// Costs, for each line that enters the state, a look at all nodes.
    ///
    /// ```
    /// use vc_graph::clock::ProcessTable;
    /// use vc_graph::{Draft, SceneBuilder, State};
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let juice = scene.add_in(kitchen, Draft::new("juice"))?;
    /// let processes = ProcessTable::builtin();
    /// assert!(!processes.brings_into(scene.graph(), juice, State::Frozen));
    /// scene.add_in(kitchen, Draft::new("freezer"))?;
    /// assert!(processes.brings_into(scene.graph(), juice, State::Frozen));
    /// # Ok::<(), vc_graph::EditError>(())
    /// ```
    pub fn brings_into(&self, graph: &SceneGraph, thing: NodeId, state: State) -> bool {
        let Some(thing) = graph.node(thing) else { return false };
        // The last line of a name counts.
        let counts = |index: usize, rule: &Rule| !self.rules[index + 1..].iter().any(|r| r.covers(rule, graph, thing));
        self.rules.iter().enumerate().any(|(index, rule)| {
            rule.brings_inside_into(graph, thing, state) || rule.brings_into(graph, thing, state) && counts(index, rule)
        })
    }

    /// The processes of one thing.
    pub(super) fn processes_of(&self, graph: &SceneGraph, node: &Node) -> Vec<Process> {
        let mut last: Vec<&Rule> = Vec::new();
        for rule in self.rules.iter().rev() {
            if last.iter().all(|other| other.group != rule.group) && rule.applies(graph, node) {
                last.push(rule);
            }
        }
        last.sort_unstable_by_key(|rule| rule.group);
        let process = |rule: &Rule| Process {
            node: node.id(),
            name: rule.name.clone(),
            after: rule.after,
            changes: rule.changes(graph, node),
        };
        last.into_iter().map(process).filter(|process| !process.changes.is_empty()).collect()
    }
}

fn rule(line: &Line<'_, 9>) -> Result<Rule, ClockError> {
    let kinds = |text: &str| Kinds::parse(text, line.classes);
    let rule = Rule {
        group: 0,
        name: line.read(0, name)?,
        kinds: line.read(1, kinds)?,
        needs: line.read(2, Signed::parse)?,
        site: site(line)?,
        becomes: line.read(5, Signed::parse)?,
        inside: inside(line)?,
        after: line.read(8, span)?,
    };
    if rule.becomes.is_empty() && rule.inside.is_none() {
        return Err(line.error(5, ClockProblem::NoResult));
    }
    Ok(rule)
}

fn site(line: &Line<'_, 9>) -> Result<Option<Site>, ClockError> {
    match (line.is_empty(3), line.is_empty(4)) {
        (true, true) => Ok(None),
        (true, false) => Err(line.error(4, ClockProblem::NoPlace)),
        (false, _) => {
            let site = line.read(3, |text| Site::parse(text, line.classes))?;
            line.read(4, |text| site.in_states(text)).map(Some)
        }
    }
}

fn inside(line: &Line<'_, 9>) -> Result<Option<(Kinds, Signed)>, ClockError> {
    match (line.is_empty(6), line.is_empty(7)) {
        (true, true) => Ok(None),
        (false, false) => {
            let kinds = line.read(6, |text| Kinds::parse(text, line.classes))?;
            Ok(Some((kinds, line.read(7, Signed::parse)?)))
        }
        (empty, _) => Err(line.error(if empty { 6 } else { 7 }, ClockProblem::Half)),
    }
}
