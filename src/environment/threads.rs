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
        if !(1..=MOST).contains(&threads) {
            return Err(MakeError::Threads { threads, most: MOST });
        }
        let pool = ThreadPoolBuilder::new().num_threads(threads).build();
        Ok(Self(Some(Arc::new(pool.map_err(|why| MakeError::ThreadPool { threads, why })?))))
    }

    /// Does something on these threads.
    pub(crate) fn run<T: Send>(&self, work: impl FnOnce() -> T + Send) -> T {
        match &self.0 {
            Some(pool) => pool.install(work),
            None => work(),
        }
    }
}
