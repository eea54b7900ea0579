//! Processes that go on in time.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::process::Process;
use super::process_table::ProcessTable;
use super::tick::{Span, Tick};
use crate::{ChangeSet, EditError, Node, NodeId, SceneGraph, StateSet};

/// Since when a process goes on.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct Since {
    /// The thing.
    pub node: NodeId,
    /// Name of the process in its table.
    pub process: Arc<str>,
    /// The tick at which it began.
    pub begin: Tick,
    /// How long it takes.
    pub after: Span,
}

impl Since {
    /// The tick of its end.
    pub fn due(&self) -> Tick {
        self.begin + self.after
    }
}

/// The processes that go on in a scene, since when, and the tick. It is all the state that processes have beside the
/// graph, and can be saved with it.
///
/// A process begins at the tick at which its conditions are first found fulfilled, and ends when they no longer are: a
/// machine that is switched off begins anew. So does a process that takes another time than before, as a soup does that
/// comes from the oven into the microwave.
///
/// To advance by many ticks at once gives the same as to advance by each of them. Processes that end in the same tick
/// do so together: each by the states before that tick, so that the order does not matter; if two set the same state
/// of a thing against each other, the larger node number has it and then the later name of the table.
///
/// ```
/// use vc_graph::clock::{ProcessTable, Running, Span};
/// use vc_graph::{Draft, SceneBuilder, State};
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let kettle = scene.add_in(kitchen, Draft::new("kettle"))?;
/// let (table, mut graph, mut running) = (ProcessTable::builtin(), scene.build(), Running::default());
///
/// let mut edit = graph.edit();
/// edit.fill(kettle, Some("water".into()))?;
/// edit.enter_state(kettle, State::On)?;
/// edit.commit();
/// running.notice(&table, &graph);
/// let due = running.next_due().ok_or("it does not boil")?;
/// let changes = running.advance(&table, &mut graph, due - running.tick())?;
/// assert_eq!(changes.changes().len(), 1);
/// assert!(graph.node(kettle).is_some_and(|node| node.is(State::Hot) && node.is(State::Off)));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Running {
    tick: Tick,
    since: BTreeMap<Key, (Tick, Span)>,
}

/// A thing, and the name of a process that goes on with it.
type Key = (NodeId, Arc<str>);

impl Running {
    /// Nothing is known to go on at a tick; [`Running::notice`] finds what does.
    pub fn new(tick: Tick) -> Self {
        Self { tick, since: BTreeMap::new() }
    }

    /// The tick.
    pub fn tick(&self) -> Tick {
        self.tick
    }

    /// The processes that go on, by node numbers and then by names.
    pub fn processes(&self) -> impl Iterator<Item = Since> + '_ {
        self.since.iter().map(|((node, process), (begin, after))| Since {
            node: *node,
            process: process.clone(),
            begin: *begin,
            after: *after,
        })
    }

    /// The tick at which the next process ends, not before now; `None` if none goes on.
    pub fn next_due(&self) -> Option<Tick> {
        self.ending().map(|(_, due)| due.max(self.tick)).min()
    }

    /// The processes that end before the last tick that can be counted, and when.
    fn ending(&self) -> impl Iterator<Item = (&Key, Tick)> {
        let ends = self.since.iter().map(|(key, (begin, after))| (key, *begin, *begin + *after));
        ends.filter(|(_, begin, due)| due > begin).map(|(key, _, due)| (key, due))
    }

    /// Takes note of a scene that something else has changed: what can go on begins at this tick, what cannot ends.
    /// Calling it twice is as calling it once. Costs as [`ProcessTable::processes`].
    pub fn notice(&mut self, table: &ProcessTable, graph: &SceneGraph) {
        let before = std::mem::take(&mut self.since);
        for process in table.processes(graph) {
            self.goes_on(&before, process);
        }
    }

    /// Takes note of changes: as [`notice`](Self::notice), where only some nodes have got other states or places since
    /// the last one, or have gone or come.
    ///
    /// Costs some microseconds for each of them, and for what they carry and are on or in; the size of the scene does not
    /// matter.
    pub fn notice_changed(&mut self, table: &ProcessTable, graph: &SceneGraph, nodes: &[NodeId]) {
        // A process depends on a thing's states, and on those of what it is on or in.
        let near = |id: &NodeId| graph.carried_with(*id).into_iter().chain(graph.support_chain(*id)).chain([*id]);
        let all: BTreeSet<NodeId> = nodes.iter().flat_map(near).collect();
        for id in all {
            let known: Vec<_> =
                self.since.range((id, Arc::from(""))..).take_while(|((node, _), _)| *node == id).collect();
            let before: BTreeMap<_, _> = known.into_iter().map(|(key, value)| (key.clone(), *value)).collect();
            before.keys().for_each(|key| _ = self.since.remove(key));
            for process in graph.node(id).into_iter().flat_map(|node| table.processes_of(graph, node)) {
                self.goes_on(&before, process);
            }
        }
    }

    fn goes_on(&mut self, before: &BTreeMap<Key, (Tick, Span)>, process: Process) {
        let key = (process.node, process.name);
        let same = before.get(&key).filter(|(_, after)| *after == process.after);
        let begin = same.map_or(self.tick, |(begin, _)| *begin);
        self.since.insert(key, (begin, process.after));
    }

    /// Lets time pass and returns the changes of all processes that ended. It takes note of the scene first, so it costs
    /// a [`Running::notice`] and then as [`pass`](Self::pass).
    ///
    /// # Errors
    /// [`EditError`] if an edit is refused; then the graph is as before and no time has passed.
    pub fn advance(&mut self, table: &ProcessTable, graph: &mut SceneGraph, by: Span) -> Result<ChangeSet, EditError> {
        self.notice(table, graph);
        self.pass(table, graph, by)
    }

    /// As [`advance`](Self::advance), for a scene that is as noticed before. Costs as [`Running::notice_changed`] for what
    /// each process changes that ends.
    ///
    /// # Errors
    /// As [`Running::advance`].
    pub fn pass(&mut self, table: &ProcessTable, graph: &mut SceneGraph, by: Span) -> Result<ChangeSet, EditError> {
        let until = self.tick + by;
        if self.due_by(until).is_none() {
            self.tick = until;
            return Ok(ChangeSet::default());
        }
        let before = (self.clone(), graph.clone());
        let changes = self.end_until(until, table, graph);
        if changes.is_err() {
            (*self, *graph) = before;
        }
        changes
    }

    fn due_by(&self, until: Tick) -> Option<Tick> {
        self.next_due().filter(|due| *due <= until)
    }

    fn end_until(&mut self, until: Tick, table: &ProcessTable, graph: &mut SceneGraph) -> Result<ChangeSet, EditError> {
        let mut changes = ChangeSet::default();
        while let Some(due) = self.due_by(until) {
            changes = changes.then(self.end_at(due, table, graph)?);
        }
        self.tick = until;
        Ok(changes)
    }

    /// Ends the processes that are due at a tick, and takes note of the scene after them.
    fn end_at(&mut self, due: Tick, table: &ProcessTable, graph: &mut SceneGraph) -> Result<ChangeSet, EditError> {
        let ended: Vec<Key> = self.ending().filter(|(_, end)| *end <= due).map(|(key, _)| key.clone()).collect();
        let nodes: BTreeSet<NodeId> = ended.iter().map(|(node, _)| *node).collect();
        let all = nodes.iter().filter_map(|id| graph.node(*id)).flat_map(|node| table.processes_of(graph, node));
        let ending: Vec<Process> =
            all.filter(|process| ended.contains(&(process.node, process.name.clone()))).collect();
        let changes = carry_out(graph, ending.into_iter().flat_map(|process| process.changes))?;
        self.tick = due;
        ended.iter().for_each(|key| _ = self.since.remove(key));
        let changed: Vec<NodeId> = nodes.into_iter().chain(changes.nodes()).collect();
        self.notice_changed(table, graph, &changed);
        Ok(changes)
    }
}

/// Brings about states that were each found in the graph as it is now: the changes of all come true.
fn carry_out(
    graph: &mut SceneGraph,
    outcomes: impl Iterator<Item = (NodeId, StateSet)>,
) -> Result<ChangeSet, EditError> {
    let before = graph.clone();
    let states = |graph: &SceneGraph, id: NodeId| graph.node(id).map(Node::states).unwrap_or_default();
    let mut edit = graph.edit();
    for (id, after) in outcomes {
        let (was, now) = (states(&before, id), states(edit.graph(), id));
        let left = now.minus(was.minus(after));
        edit.set_states(id, after.minus(was).iter().fold(left, |set, state| before.vocabulary().entering(set, state)))?;
    }
    Ok(edit.commit())
}

/// The form in which it is saved.
#[derive(Serialize, Deserialize)]
struct Saved {
    tick: Tick,
    running: Vec<Since>,
}

impl Serialize for Running {
    fn serialize<S: serde::Serializer>(&self, s: S) -> Result<S::Ok, S::Error> {
        Saved { tick: self.tick, running: self.processes().collect() }.serialize(s)
    }
}

impl<'de> Deserialize<'de> for Running {
    fn deserialize<D: serde::Deserializer<'de>>(d: D) -> Result<Self, D::Error> {
        let saved = Saved::deserialize(d)?;
        let entry = |since: Since| ((since.node, since.process), (since.begin, since.after));
        Ok(Self { tick: saved.tick, since: saved.running.into_iter().map(entry).collect() })
    }
}
