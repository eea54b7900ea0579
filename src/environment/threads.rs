//! Threads of an environment's own.

use std::sync::Arc;

use rayon::{ThreadPool, ThreadPoolBuilder};

use super::MakeError;

/// Most threads of an environment.
const MOST: usize = 1024;

/// The threads on which pictures are made: those of the caller's pool, or of an own one that clones share.
#[derive(Debug, Clone, Default)]
pub(crate) struct Threads(Option<Arc<ThreadPool>>);

impl Threads {
    /// A pool of so many.
    pub(super) fn new(threads: usize) -> Result<Self, MakeError> {
        let refused = |why: String| MakeError::Threads { threads, why };
        if !(1..=MOST).contains(&threads) {
            return Err(refused(format!("ask for 1 to {MOST}")));
        }
        let pool = ThreadPoolBuilder::new().num_threads(threads).build().map_err(|e| refused(e.to_string()))?;
        Ok(Self(Some(Arc::new(pool))))
    }

    /// Does something on these threads.
    pub(crate) fn run<T: Send>(&self, work: impl FnOnce() -> T + Send) -> T {
        match &self.0 {
            Some(pool) => pool.install(work),
            None => work(),
        }
    }
}
