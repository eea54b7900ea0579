//! The bodies that may have moved since somebody last read the world.

use rapier3d::dynamics::RigidBodyHandle;

/// A set of bodies by index. It may name bodies that have not moved, or are no longer there; it misses none.
#[derive(Clone, Default)]
pub(super) enum Moved {
    /// Nobody has read the world yet.
    #[default]
    All,
    /// One bit for each index.
    Some(Vec<u64>),
}

impl Moved {
    pub(super) fn add(&mut self, body: RigidBodyHandle) {
        let Self::Some(words) = self else { return };
        let (word, bit) = (body.into_raw_parts().0 as usize / 64, body.into_raw_parts().0 % 64);
        if words.len() <= word {
            words.resize(word + 1, 0);
        }
        words[word] |= 1 << bit;
    }

    pub(super) fn clear(&mut self) {
        *self = Self::Some(Vec::new());
    }

    /// The indexes, ascending; `None` for all.
    pub(super) fn indexes(&self) -> Option<impl Iterator<Item = u32> + '_> {
        let Self::Some(words) = self else { return None };
        let bits = |(number, word): (u32, &u64)| {
            let word = *word;
            (0..64).filter(move |bit| word >> bit & 1 == 1).map(move |bit| 64 * number + bit)
        };
        Some((0..).zip(words).flat_map(bits))
    }
}
