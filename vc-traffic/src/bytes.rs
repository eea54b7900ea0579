//! Numbers as bytes, little-endian, and back.

use crate::save::SaveError;

/// Larger numbers of metres or seconds there are not.
const LARGEST: f32 = 1e8;

/// Numbers one after the other.
#[derive(Default)]
pub(crate) struct Writer(pub(crate) Vec<u8>);

impl Writer {
    pub(crate) fn word(&mut self, value: u32) {
        self.0.extend(value.to_le_bytes());
    }

    pub(crate) fn long(&mut self, value: u64) {
        self.0.extend(value.to_le_bytes());
    }

    pub(crate) fn reals<const N: usize>(&mut self, values: [f32; N]) {
        values.into_iter().for_each(|value| self.word(value.to_bits()));
    }

    /// A list: its length, then its items.
    pub(crate) fn list<T>(&mut self, items: impl ExactSizeIterator<Item = T>, mut write: impl FnMut(&mut Self, T)) {
        self.word(items.len() as u32);
        items.for_each(|item| write(self, item));
    }
}

/// Reads what a writer has written.
pub(crate) struct Reader<'a>(pub(crate) &'a [u8]);

impl Reader<'_> {
    fn take<const N: usize>(&mut self) -> Result<[u8; N], SaveError> {
        let (first, rest) = self.0.split_first_chunk().ok_or(SaveError::Ends)?;
        self.0 = rest;
        Ok(*first)
    }

    pub(crate) fn word(&mut self) -> Result<u32, SaveError> {
        self.take().map(u32::from_le_bytes)
    }

    pub(crate) fn long(&mut self) -> Result<u64, SaveError> {
        self.take().map(u64::from_le_bytes)
    }

    /// A number below a bound.
    pub(crate) fn below(&mut self, bound: usize, name: &'static str) -> Result<u32, SaveError> {
        let value = self.word()?;
        if (value as usize) < bound { Ok(value) } else { Err(SaveError::Wrong(name)) }
    }

    /// The same, or [`crate::network::NONE`].
    pub(crate) fn below_or_none(&mut self, bound: usize, name: &'static str) -> Result<u32, SaveError> {
        let value = self.word()?;
        let good = value == crate::network::NONE || (value as usize) < bound;
        if good { Ok(value) } else { Err(SaveError::Wrong(name)) }
    }

    /// Real numbers, none of which is larger than any that traffic has.
    pub(crate) fn reals<const N: usize>(&mut self, name: &'static str) -> Result<[f32; N], SaveError> {
        let mut values = [0.0; N];
        for value in &mut values {
            *value = f32::from_bits(self.word()?);
        }
        if values.iter().all(|value| value.abs() <= LARGEST) { Ok(values) } else { Err(SaveError::Wrong(name)) }
    }

    /// A real number that may be infinite.
    pub(crate) fn bound(&mut self, name: &'static str) -> Result<f32, SaveError> {
        let value = f32::from_bits(self.word()?);
        if value.is_nan() { Err(SaveError::Wrong(name)) } else { Ok(value) }
    }

    /// A list.
    pub(crate) fn list<T>(
        &mut self,
        mut read: impl FnMut(&mut Self) -> Result<T, SaveError>,
    ) -> Result<Vec<T>, SaveError> {
        let length = self.word()?;
        // Each item takes a byte at least, so that no length takes more memory than the save.
        if length as usize > self.0.len() {
            return Err(SaveError::Ends);
        }
        (0..length).map(|_| read(self)).collect()
    }
}
