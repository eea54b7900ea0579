//! A verdict kept up to date while the scene changes.

use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::sync::Arc;

use vc_graph::goal::Situation;
use vc_graph::{Change, ChangeSet, NodeId};

use super::scene::{Wake, changed, moves, wake};
use super::{Bits, Gate, GateKind, GoalProgram, Ref};

/// An object, over which the goal's variables may range, was added to the scene or removed from it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("object {0} was added or removed; compile the goal again for the current objects")]
pub struct Stale(pub NodeId);

/// A goal's verdict, updated incrementally: a changed atom triggers only the gates that use it, and
/// these only the gates that depend on them.
///
/// ```
/// use std::sync::Arc;
/// use vc_graph::goal::Situation;
/// use vc_graph::{Draft, History, SceneBuilder, State};
/// use vc_tasks::compile::{GoalProgram, Tracker};
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let fridge = scene.add_in(kitchen, Draft::new("fridge"))?;
/// let me = scene.add_in(kitchen, Draft::new("character"))?;
/// let (mut graph, history) = (scene.build(), History::default());
///
/// let now = Situation::new(&graph, me, &history);
/// let program = Arc::new(GoalProgram::new(&"Open(fridge)".parse()?, &now)?);
/// let mut tracker = Tracker::in_situation(program, &now);
/// assert!(!tracker.holds());
/// let mut edit = graph.edit();
/// edit.enter_state(fridge, State::Open)?;
/// let changes = edit.commit();
/// assert!(tracker.apply(&Situation::new(&graph, me, &history), &changes)?);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct Tracker {
    program: Arc<GoalProgram>,
    watch: Arc<Watch>,
    bits: Bits,
    gates: Bits,
    /// For each gate the number of its true inputs.
    counts: Vec<u32>,
    queue: BinaryHeap<Reverse<u32>>,
    /// The number of events processed.
    events: usize,
}

/// The dependencies between atoms and gates.
#[derive(Debug)]
struct Watch {
    /// For each atom, then for each gate, the start of its watchers.
    starts: Vec<u32>,
    /// The watching gates, each as two times the gate's index, plus one if it reads the input
    /// negated.
    watchers: Vec<u32>,
    /// Pairs of an object and an atom that changes with it, sorted.
    things: Vec<(NodeId, u32)>,
    /// Atoms that the placements and poses of other objects can change.
    places: Vec<u32>,
    /// Atoms about executed actions.
    events: Vec<u32>,
}

impl Watch {
    fn new(program: &GoalProgram) -> Self {
        let atoms = program.atoms().len();
        let place = |r: Ref| if r.is_atom() { r.index() } else { atoms + r.index() };
        let uses = || {
            let gates = program.gates().iter().enumerate();
            gates.flat_map(|(g, &gate)| program.inputs(gate).iter().filter(|r| !r.is_constant()).map(move |&r| (g, r)))
        };
        let mut starts = vec![0; atoms + program.gates().len() + 1];
        uses().for_each(|(_, r)| starts[place(r) + 1] += 1);
        (1..starts.len()).for_each(|i| starts[i] += starts[i - 1]);
        let mut next = starts.clone();
        let mut watchers = vec![0; starts[starts.len() - 1] as usize];
        for (gate, r) in uses() {
            watchers[next[place(r)] as usize] = 2 * gate as u32 + u32::from(r.is_negated());
            next[place(r)] += 1;
        }
        let mut watch = Self { starts, watchers, things: Vec::new(), places: Vec::new(), events: Vec::new() };
        watch.listen(program);
        watch
    }

    fn listen(&mut self, program: &GoalProgram) {
        for (index, atom) in (0..).zip(program.atoms()) {
            match wake(atom) {
                Wake::Things => self.things.extend(atom.things.iter().flatten().map(|&id| (id, index))),
                Wake::Places => self.places.push(index),
                Wake::Events => self.events.push(index),
            }
        }
        self.things.sort_unstable();
    }

    fn of(&self, place: usize) -> std::ops::Range<usize> {
        self.starts[place] as usize..self.starts[place + 1] as usize
    }

    fn atoms_of(&self, id: NodeId) -> impl Iterator<Item = u32> {
        let start = self.things.partition_point(|&(thing, _)| thing < id);
        self.things[start..].iter().take_while(move |(thing, _)| *thing == id).map(|&(_, atom)| atom)
    }
}

impl Tracker {
    /// Starts with these truth values. Costs one visit of every gate.
    pub fn new(program: Arc<GoalProgram>, bits: Bits) -> Self {
        let watch = Arc::new(Watch::new(&program));
        let (gates, counts) = (Bits::none(program.gates().len()), vec![0; program.gates().len()]);
        let mut tracker = Self { program, watch, bits, gates, counts, queue: BinaryHeap::new(), events: 0 };
        tracker.count_all();
        tracker
    }

    /// Starts with the atoms of a situation.
    ///
    /// ```
    /// use vc_graph::goal::Situation;
    /// use vc_graph::{Draft, History, SceneBuilder};
    /// use vc_tasks::compile::{GoalProgram, Tracker};
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
    /// let apple = scene.add_on(table, Draft::new("apple"))?;
    /// let me = scene.add_in(kitchen, Draft::new("character"))?;
    /// let (graph, history) = (scene.build(), History::default());
    /// let now = Situation::new(&graph, me, &history);
    /// let program = GoalProgram::new(&"On(apple, kitchen_table)".parse()?, &now)?;
    /// assert!(Tracker::in_situation(program.into(), &now).holds());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn in_situation(program: Arc<GoalProgram>, now: &Situation<'_>) -> Self {
        let bits = program.read(now);
        Self { events: now.events.len(), ..Self::new(program, bits) }
    }

    fn count_all(&mut self) {
        let program = self.program.clone();
        for (index, &gate) in program.gates().iter().enumerate() {
            self.counts[index] = program.inputs(gate).iter().filter(|&&r| self.value(r)).count() as u32;
            let value = self.gate_value(index, gate);
            self.gates.set(index, value);
        }
    }

    /// The tracked program.
    pub fn program(&self) -> &GoalProgram {
        &self.program
    }

    /// The truth values of the atoms.
    pub fn bits(&self) -> &Bits {
        &self.bits
    }

    /// Whether the goal holds now. Takes constant time.
    pub fn holds(&self) -> bool {
        self.value(self.program.root())
    }

    /// Whether a conjunct, counted from zero, holds now.
    pub fn head_holds(&self, head: usize) -> bool {
        self.program.head(head).is_some_and(|r| self.value(r))
    }

    #[inline]
    fn value(&self, r: Ref) -> bool {
        let value = if r.is_atom() { self.bits.has(r.index()) } else { r.is_constant() || self.gates.has(r.index()) };
        value != r.is_negated()
    }

    fn gate_value(&self, index: usize, gate: Gate) -> bool {
        let count = self.counts[index];
        match gate.kind {
            GateKind::All => count == gate.end - gate.start,
            GateKind::Any => count > 0,
            GateKind::AtLeast(k) => count >= k,
            GateKind::Exactly(k) => count == k,
            GateKind::Pairs(table) => {
                let inputs = self.program.inputs(gate);
                count >= table.need && table.is_met(|cell| self.value(inputs[cell]))
            }
        }
    }

    /// Sets the truth of an atom and returns whether the goal then holds.
    ///
    /// ```
    /// use vc_graph::goal::Situation;
    /// use vc_graph::{Draft, History, SceneBuilder};
    /// use vc_tasks::compile::{GoalProgram, Tracker};
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
    /// let apple = scene.add_on(table, Draft::new("apple"))?;
    /// let me = scene.add_in(kitchen, Draft::new("character"))?;
    /// let (graph, history) = (scene.build(), History::default());
    /// let now = Situation::new(&graph, me, &history);
    /// let program = GoalProgram::new(&"Holds(apple)".parse()?, &now)?;
    /// let mut tracker = Tracker::in_situation(program.into(), &now);
    /// assert!(!tracker.holds());
    /// tracker.set(0, true);
    /// assert!(tracker.holds());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn set(&mut self, atom: usize, value: bool) -> bool {
        if atom < self.program.atoms().len() && self.bits.has(atom) != value {
            self.bits.set(atom, value);
            self.wake(atom, value);
            self.run();
        }
        self.holds()
    }

    /// Passes a new truth value on to the watchers of an atom, or of a gate, whose places follow
    /// those of the atoms.
    fn wake(&mut self, place: usize, value: bool) {
        for at in self.watch.of(place) {
            let watcher = self.watch.watchers[at];
            let (gate, negated) = (watcher >> 1, watcher & 1 != 0);
            let count = &mut self.counts[gate as usize];
            *count = if value != negated { *count + 1 } else { *count - 1 };
            self.queue.push(Reverse(gate));
        }
    }

    /// Updates the queued gates in the order of their indices, so that the inputs of each are
    /// settled first.
    fn run(&mut self) {
        while let Some(Reverse(gate)) = self.queue.pop() {
            while self.queue.peek() == Some(&Reverse(gate)) {
                self.queue.pop();
            }
            let index = gate as usize;
            let value = self.gate_value(index, self.program.gates()[index]);
            if self.gates.has(index) != value {
                self.gates.set(index, value);
                self.wake(self.program.atoms().len() + index, value);
            }
        }
    }

    /// Applies the changes of an edit or action; `now` is the situation after it. Costs one read of
    /// the scene for each atom about a changed object; after a movement also for those about
    /// `Inside` and `Near`.
    ///
    /// # Errors
    /// [`Stale`] if nodes were added or removed; then the tracker is unchanged.
    pub fn apply(&mut self, now: &Situation<'_>, changes: &ChangeSet) -> Result<bool, Stale> {
        for change in changes.changes() {
            if let Change::Add(node) | Change::Remove(node) = change {
                return Err(Stale(node.id()));
            }
        }
        let watch = self.watch.clone();
        for id in changes.changes().iter().flat_map(changed).flatten() {
            watch.atoms_of(id).for_each(|atom| self.reread(now, atom));
        }
        if changes.changes().iter().any(moves) {
            watch.places.iter().for_each(|&atom| self.reread(now, atom));
        }
        if now.events.len() != self.events {
            self.events = now.events.len();
            watch.events.iter().for_each(|&atom| self.reread(now, atom));
        }
        Ok(self.holds())
    }

    fn reread(&mut self, now: &Situation<'_>, atom: u32) {
        let index = atom as usize;
        let at = self.program.atoms()[index];
        self.set(index, now.holds(at.predicate, at.things));
    }
}
