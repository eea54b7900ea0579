//! The memory that a map may take.

use std::fmt::Display;

use crate::MapError;
use crate::size::Holds;

/// The bytes that are left for the parts of a map. Each part is counted when it has been made, so that at most one is beyond.
pub(super) struct Budget {
    most: usize,
    left: usize,
}

impl Budget {
    pub(super) fn new(most: usize) -> Self {
        Self { most, left: most }
    }

    /// Takes the bytes of things that belong to a part of the map.
    pub(super) fn take<T: Holds>(&mut self, of: impl Display, things: &[T]) -> Result<(), MapError> {
        self.take_bytes(of, things.iter().map(T::bytes).sum())
    }

    /// Finds that some bytes are left, for work that is about to be done.
    pub(super) fn has(&self, of: impl Display, bytes: usize) -> Result<(), MapError> {
        if bytes <= self.left { Ok(()) } else { Err(MapError::TooLarge { part: of.to_string(), most: self.most }) }
    }

    pub(super) fn take_bytes(&mut self, of: impl Display, bytes: usize) -> Result<(), MapError> {
        self.left =
            self.left.checked_sub(bytes).ok_or_else(|| MapError::TooLarge { part: of.to_string(), most: self.most })?;
        Ok(())
    }
}
