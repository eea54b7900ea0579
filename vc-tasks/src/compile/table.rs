//! An index of distinct values: equal values get the same number.

/// Open addressing with linear probing; the values themselves are stored elsewhere.
#[derive(Debug, Default)]
pub(super) struct Numbers {
    /// Number plus one; 0 is free. The length is a power of two, and at most half of the slots are
    /// used.
    slots: Vec<u32>,
    used: usize,
}

impl Numbers {
    /// Clears the index but keeps its memory.
    pub(super) fn clear(&mut self) {
        self.slots.fill(0);
        self.used = 0;
    }

    /// The number of a value with this key: an existing one that `equal` recognises, or `next`.
    /// `key_of` gives the key of an existing number.
    pub(super) fn number(
        &mut self,
        key: u64,
        next: usize,
        equal: impl Fn(usize) -> bool,
        key_of: impl Fn(usize) -> u64,
    ) -> usize {
        if 2 * (self.used + 1) > self.slots.len() {
            self.grow(key_of);
        }
        let mask = self.slots.len() - 1;
        let mut at = key as usize & mask;
        loop {
            match self.slots[at] {
                0 => {
                    self.slots[at] = next as u32 + 1;
                    self.used += 1;
                    return next;
                }
                number if equal(number as usize - 1) => return number as usize - 1,
                _ => at = (at + 1) & mask,
            }
        }
    }

    fn grow(&mut self, key_of: impl Fn(usize) -> u64) {
        let size = (2 * self.slots.len()).max(32);
        let old = std::mem::replace(&mut self.slots, vec![0; size]);
        for number in old.into_iter().filter(|&n| n != 0) {
            let mut at = key_of(number as usize - 1) as usize & (size - 1);
            while self.slots[at] != 0 {
                at = (at + 1) & (size - 1);
            }
            self.slots[at] = number;
        }
    }
}
