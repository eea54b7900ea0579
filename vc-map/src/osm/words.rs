//! Every word of a file once, and lists that grow only as far as the file allows.

use std::hash::{BuildHasher, RandomState};

/// Nothing more fits: a packed file may only unpack to so much, and positions are numbers of 32 bits.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Full;

/// The bytes by which lists may still grow.
#[derive(Debug, Default)]
pub(super) struct Room(pub(super) usize);

impl Room {
    pub(super) fn take(&mut self, bytes: usize) -> Result<(), Full> {
        self.0 = self.0.checked_sub(bytes).ok_or(Full)?;
        Ok(())
    }

    /// Adds to a list. It grows by a quarter, so that little of it stands empty.
    pub(super) fn push<T>(&mut self, list: &mut Vec<T>, item: T) -> Result<(), Full> {
        if list.len() == list.capacity() {
            let more = (list.len() / 4).max(16);
            self.take(more * size_of::<T>())?;
            list.reserve_exact(more);
        }
        list.push(item);
        u32::try_from(list.len()).map(|_| ()).map_err(|_| Full)
    }

    fn text(&mut self, all: &mut String, text: &str) -> Result<(), Full> {
        let missing = (all.len() + text.len()).saturating_sub(all.capacity());
        if missing > 0 {
            let more = missing.max(all.len() / 4).max(64);
            self.take(more)?;
            all.reserve_exact(more + all.capacity() - all.len());
        }
        all.push_str(text);
        u32::try_from(all.len()).map(|_| ()).map_err(|_| Full)
    }
}

/// Words with numbers.
#[derive(Debug, Default)]
pub(super) struct Words {
    text: String,
    /// Where each word ends in the text.
    ends: Vec<u32>,
    /// The numbers of words plus one, each at the first free place behind that of its hash; zero where there is none.
    places: Vec<u32>,
    /// Its key is a secret of this run, so that no file can be made whose words all collide. Numbers do not depend on it.
    hasher: RandomState,
}

impl Words {
    pub(super) fn bytes(&self) -> usize {
        self.text.capacity() + (self.ends.capacity() + self.places.capacity()) * size_of::<u32>()
    }

    /// The number of a word, a new one if it has none.
    pub(super) fn number(&mut self, word: &str, room: &mut Room) -> Result<u32, Full> {
        if 2 * (self.ends.len() + 1) > self.places.len() {
            self.spread(room)?;
        }
        let place = self.place(word);
        if let Some(number) = self.places[place].checked_sub(1) {
            return Ok(number);
        }
        room.text(&mut self.text, word)?;
        let number = self.ends.len() as u32;
        room.push(&mut self.ends, self.text.len() as u32)?;
        self.places[place] = number + 1;
        Ok(number)
    }

    /// Where a word is, or would be.
    fn place(&self, word: &str) -> usize {
        let mask = self.places.len() - 1;
        let mut place = self.hasher.hash_one(word) as usize & mask;
        while self.places[place].checked_sub(1).is_some_and(|number| self.word(number) != word) {
            place = (place + 1) & mask;
        }
        place
    }

    /// Makes twice as many places.
    fn spread(&mut self, room: &mut Room) -> Result<(), Full> {
        let count = (2 * self.places.len()).max(64);
        room.take((count - self.places.len()) * size_of::<u32>())?;
        // The old ones are given back before the new ones are made.
        self.places = Vec::new();
        self.places = vec![0; count];
        for number in 0..self.ends.len() as u32 {
            let place = self.place(self.word(number));
            self.places[place] = number + 1;
        }
        Ok(())
    }

    pub(super) fn word(&self, number: u32) -> &str {
        let number = number as usize;
        let end = self.ends.get(number).map_or(0, |end| *end as usize);
        let start = number.checked_sub(1).and_then(|before| self.ends.get(before)).map_or(0, |end| *end as usize);
        self.text.get(start..end).unwrap_or_default()
    }
}
