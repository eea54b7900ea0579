//! Files of several parts with a checksum: saved environments and cities.

use vc_graph::hash::Digester;

/// The bytes with which a kind of file begins.
pub(crate) type Magic = [u8; 8];

/// The fault of bytes that are to be a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum PartsFault {
    /// They are no such file, or end too early.
    Foreign,
    /// Bytes follow the last part.
    More(usize),
    /// Some have changed since they were written.
    Damaged,
}

/// The parts as bytes.
pub(crate) fn joined(magic: &Magic, parts: &[&[u8]]) -> Vec<u8> {
    let length = |length: usize| (length as u64).to_le_bytes();
    let mut content = length(parts.len()).to_vec();
    for part in parts {
        content.extend(length(part.len()));
        content.extend(*part);
    }
    [magic.as_slice(), &checksum(&content).to_le_bytes(), &content].concat()
}

/// The parts of bytes that [`joined`] has made.
pub(crate) fn split<'a>(magic: &Magic, bytes: &'a [u8]) -> Result<Vec<&'a [u8]>, PartsFault> {
    let (sum, content) = number(bytes.strip_prefix(magic).ok_or(PartsFault::Foreign)?)?;
    let (count, mut rest) = number(content)?;
    let mut parts = Vec::new();
    for _ in 0..count {
        let (length, after) = number(rest)?;
        let length = usize::try_from(length).map_err(|_| PartsFault::Foreign)?;
        let (part, after) = after.split_at_checked(length).ok_or(PartsFault::Foreign)?;
        parts.push(part);
        rest = after;
    }
    match rest.len() {
        0 if checksum(content) == sum => Ok(parts),
        0 => Err(PartsFault::Damaged),
        more => Err(PartsFault::More(more)),
    }
}

/// A number of eight bytes, and what follows.
pub(crate) fn number(bytes: &[u8]) -> Result<(u64, &[u8]), PartsFault> {
    let (head, rest) = bytes.split_first_chunk::<8>().ok_or(PartsFault::Foreign)?;
    Ok((u64::from_le_bytes(*head), rest))
}

fn checksum(content: &[u8]) -> u64 {
    let mut hash = Digester::new();
    hash.words(content.iter().map(|byte| u64::from(*byte)));
    hash.digest().0
}
