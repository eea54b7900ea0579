//! Processes of machines and matter while time passes.

use std::sync::Arc;

use vc_graph::Action;
use vc_graph::clock::{DayTime, Durations, ProcessTable, Since, Span, Tick};

use crate::environment::Environment;

/// How time goes in an environment.
#[derive(Debug, Clone)]
pub(in crate::environment) struct TimeSettings {
    pub(in crate::environment) processes: Arc<ProcessTable>,
    pub(in crate::environment) durations: Arc<Durations>,
    /// Whether processes end in the tick in which they begin.
    pub(in crate::environment) at_once: bool,
    /// The day and time at tick zero.
    pub(in crate::environment) begin: DayTime,
    /// Whether bodies do the actions; else the rule alone says their outcome.
    pub(in crate::environment) bodies: bool,
}

impl Default for TimeSettings {
    fn default() -> Self {
        let (processes, durations) = (ProcessTable::builtin(), Durations::builtin());
        Self { processes, durations, at_once: false, begin: DayTime::new(0, 12 * 3600), bodies: true }
    }
}

impl Environment {
    /// The processes that go on, since when and until when, as of the last [`step`](Self::step): a machine that washes,
    /// soup that cools.
    ///
    /// ```
    /// use virtualcity::Environment;
    /// use virtualcity::graph::clock::Span;
    /// let mut home = Environment::make("apartment/42", 1)?;
    /// home.step(Span(1));
    /// for since in home.processes() {
    ///     println!("{}: {} until {}", home.graph().label(since.node), since.process, since.due());
    /// }
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn processes(&self) -> impl Iterator<Item = Since> + '_ {
        self.clock.processes.processes()
    }

    /// The day and the time of day.
    pub fn day_time(&self) -> DayTime {
        DayTime::at(self.tick(), self.start.time.begin)
    }

    /// How long an action takes that neither a body's motion nor a process times, by the builder's table: somebody who
    /// reads a book does so for half an hour.
    pub fn duration(&self, action: &Action) -> Option<Span> {
        self.start.time.durations.takes(&self.graph, action)
    }

    /// The tick at which the next process ends, if any goes on.
    pub(super) fn next_process(&mut self) -> Option<Tick> {
        self.notice_processes();
        let due = self.clock.processes.next_due()?;
        Some(if self.start.time.at_once { self.tick() } else { due.max(self.tick()) })
    }

    /// Takes note of what can go on in the scene as it is.
    fn notice_processes(&mut self) {
        let touched = std::mem::take(&mut self.clock.touched);
        let known = std::mem::replace(&mut self.clock.noticed, true);
        if known && touched.is_empty() {
            return;
        }
        self.pass_in_processes(self.tick() - self.clock.processes.tick());
        let table = &self.start.time.processes;
        if known {
            self.clock.processes.notice_changed(table, &self.graph, &touched);
        } else {
            self.clock.processes.notice(table, &self.graph);
        }
    }

    /// Ends the processes that are due.
    pub(super) fn end_processes(&mut self) {
        let now = self.tick();
        let Some(due) = self.next_process().filter(|due| *due <= now) else { return };
        let ahead = if self.start.time.at_once { self.clock.processes.next_due().unwrap_or(due) } else { due };
        self.pass_in_processes(ahead - self.clock.processes.tick());
    }

    fn pass_in_processes(&mut self, span: Span) {
        let table = &self.start.time.processes;
        // States of things that are there can be entered.
        let changes = self.clock.processes.pass(table, &mut self.graph, span).unwrap_or_default();
        self.clock.journal = std::mem::take(&mut self.clock.journal).then(changes);
    }
}
