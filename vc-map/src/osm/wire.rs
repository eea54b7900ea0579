//! The encoding of protocol buffers: fields with numbers, whole numbers of variable length.

/// The content of a field.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Content<'a> {
    /// A whole number.
    Number(u64),
    /// Bytes: a text, packed numbers or a message.
    Bytes(&'a [u8]),
    /// A number of fixed size, which no field that is read has.
    Fixed,
}

/// The fields of a message; ends early, with [`Self::broken`], where the bytes are none.
pub(super) struct Fields<'a> {
    bytes: &'a [u8],
    pub(super) broken: bool,
}

impl<'a> Fields<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        Self { bytes, broken: false }
    }

    fn field(&mut self) -> Option<(u64, Content<'a>)> {
        let key = number(&mut self.bytes)?;
        let content = match key & 7 {
            0 => Content::Number(number(&mut self.bytes)?),
            1 => {
                self.bytes = self.bytes.get(8..)?;
                Content::Fixed
            }
            2 => {
                let length = usize::try_from(number(&mut self.bytes)?).ok()?;
                let (bytes, rest) = self.bytes.split_at_checked(length)?;
                self.bytes = rest;
                Content::Bytes(bytes)
            }
            5 => {
                self.bytes = self.bytes.get(4..)?;
                Content::Fixed
            }
            _ => return None,
        };
        Some((key >> 3, content))
    }
}

impl<'a> Iterator for Fields<'a> {
    type Item = (u64, Content<'a>);

    fn next(&mut self) -> Option<Self::Item> {
        if self.bytes.is_empty() || self.broken {
            return None;
        }
        let field = self.field();
        self.broken = field.is_none();
        field
    }
}

/// A whole number at the start of some bytes, which are moved on.
fn number(bytes: &mut &[u8]) -> Option<u64> {
    let mut value = 0;
    for (index, byte) in bytes.iter().take(10).enumerate() {
        value |= u64::from(byte & 0x7f) << (7 * index);
        if byte & 0x80 == 0 {
            *bytes = &bytes[index + 1..];
            return Some(value);
        }
    }
    None
}

/// Packed whole numbers.
pub(super) fn numbers(mut bytes: &[u8]) -> impl Iterator<Item = u64> {
    std::iter::from_fn(move || number(&mut bytes))
}

/// Packed differences as the numbers themselves.
pub(super) fn summed(bytes: &[u8]) -> impl Iterator<Item = i64> {
    numbers(bytes).map(unfolded).scan(0i64, |sum, step| {
        *sum = sum.wrapping_add(step);
        Some(*sum)
    })
}

/// A signed number from the form in which small negative numbers are small.
pub(super) fn unfolded(value: u64) -> i64 {
    (value >> 1) as i64 ^ -((value & 1) as i64)
}
