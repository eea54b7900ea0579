//! All that is due while a timetable is made, in the order of its time.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Something that is due, in the order in which those of one tick happen.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Event {
    /// Somebody's vehicle comes to its next lane.
    Enters(u32),
    /// It comes to where it is going.
    Arrives(u32),
    /// The first on a lane may go.
    Goes(u32),
    /// Somebody pulls out.
    SetsOut(u32),
    /// Somebody leaves a door.
    Leaves(u32),
}

/// All that is due.
#[derive(Default)]
pub(super) struct Agenda(BinaryHeap<Reverse<(u32, Event)>>);

impl Agenda {
    pub(super) fn push(&mut self, tick: u32, event: Event) {
        self.0.push(Reverse((tick, event)));
    }

    pub(super) fn pop(&mut self) -> Option<(u32, Event)> {
        self.0.pop().map(|Reverse(next)| next)
    }
}
