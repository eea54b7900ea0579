//! The actions since the last reset. The states of a search share it as far as it is the same.

use std::sync::Arc;

use vc_graph::{Event, History};

/// The history of an environment, and how much of it the last saved state has.
#[derive(Clone, Default)]
pub(in crate::environment) struct Past {
    history: History,
    saved: Option<Arc<SavedPast>>,
}

/// The events of a saved state: those since an earlier state, after those of that one.
pub(in crate::environment) struct SavedPast {
    before: Option<Arc<Self>>,
    since: Box<[Event]>,
    /// How many there are in all.
    count: usize,
}

impl Past {
    pub(in crate::environment) fn history(&self) -> &History {
        &self.history
    }

    pub(in crate::environment) fn push(&mut self, event: Event) {
        self.history.push(event);
    }

    /// The history, of which the next saved state takes what comes after.
    pub(in crate::environment) fn save(&mut self) -> Option<Arc<SavedPast>> {
        let known = self.saved.as_ref().map_or(0, |saved| saved.count);
        let (count, since) = (self.history.events().len(), self.history.events().get(known..).unwrap_or_default());
        if !since.is_empty() {
            let (before, since) = (self.saved.take(), since.into());
            self.saved = Some(Arc::new(SavedPast { before, since, count }));
        }
        self.saved.clone()
    }

    pub(in crate::environment) fn restored(saved: Option<Arc<SavedPast>>) -> Self {
        let all = std::iter::successors(saved.as_deref(), |saved| saved.before.as_deref());
        let mut history = History::default();
        for part in all.collect::<Vec<_>>().into_iter().rev() {
            part.since.iter().for_each(|event| history.push(*event));
        }
        Self { history, saved }
    }
}

impl SavedPast {
    /// The bytes that an earlier state does not have.
    pub(in crate::environment) fn bytes(&self) -> usize {
        size_of::<Self>() + size_of_val(&*self.since)
    }
}

/// A long line of states is dropped one after the other, not one within the other.
impl Drop for SavedPast {
    fn drop(&mut self) {
        let mut next = self.before.take();
        while let Some(mut last) = next.and_then(Arc::into_inner) {
            next = last.before.take();
        }
    }
}
