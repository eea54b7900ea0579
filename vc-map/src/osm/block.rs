//! Blocks of PBF: where they begin, how they are unpacked, their words.

use std::borrow::Cow;

use super::data::OsmData;
use super::wire::{Content, Fields};
use super::words::Full;

/// The largest header and the largest block, unpacked, as the format has them, bytes.
const HEADER: usize = 64 << 10;
const BLOCK: usize = 32 << 20;
/// A block unpacks to at most this many times its bytes, real ones to two or three times, and this many bytes more: small
/// blocks of tags that repeat unpack to more.
const UNPACKED: usize = 6;
const SMALL: usize = 512 << 10;
/// A block has at most one word for so many of its bytes, and this many words more.
const WORD: usize = 8;
const WORDS: usize = 4 << 10;
/// The kind and bytes of the block at a byte, and where the next one begins.
pub(super) fn block(file: &[u8], at: usize) -> Result<(&[u8], &[u8], usize), &'static str> {
    const ENDS: &str = "the file ends within a block";
    let rest = &file[at..];
    let (length, rest) = rest.split_first_chunk::<4>().ok_or(ENDS)?;
    let length = u32::from_be_bytes(*length) as usize;
    if length > HEADER {
        return Err("the header of a block is too large");
    }
    let (header, rest) = rest.split_at_checked(length).ok_or(ENDS)?;
    let (mut kind, mut size): (&[u8], usize) = (&[], 0);
    for (field, content) in Fields::new(header) {
        match (field, content) {
            (1, Content::Bytes(bytes)) => kind = bytes,
            (3, Content::Number(number)) => size = usize::try_from(number).unwrap_or(usize::MAX),
            _ => {}
        }
    }
    let blob = rest.get(..size).ok_or(ENDS)?;
    Ok((kind, blob, at + 4 + length + size))
}

/// The content of a blob.
pub(super) fn unpacked(blob: &[u8]) -> Result<Cow<'_, [u8]>, &'static str> {
    for (field, content) in Fields::new(blob) {
        match (field, content) {
            (1, Content::Bytes(raw)) if raw.len() > BLOCK => return Err("a block is larger than the format has them"),
            (1, Content::Bytes(raw)) => return Ok(Cow::Borrowed(raw)),
            (3, Content::Bytes(packed)) => {
                let most = (UNPACKED * packed.len() + SMALL).min(BLOCK);
                let unpacked = miniz_oxide::inflate::decompress_to_vec_zlib_with_limit(packed, most);
                let wrong = "a block is not packed by zlib, or unpacks to far more than one of a map";
                return unpacked.map(Cow::Owned).map_err(|_| wrong);
            }
            (4..=7, Content::Bytes(_)) => {
                return Err("only blocks that are packed by zlib are read: convert with osmium");
            }
            _ => {}
        }
    }
    Err("a block has no content")
}

/// The words of a block.
fn words(table: &[u8], most: usize) -> Result<Vec<&str>, &'static str> {
    let count = Fields::new(table).count();
    if count > most {
        return Err("a block has far more words than one of a map");
    }
    let mut words = Vec::with_capacity(count);
    words.extend(Fields::new(table).filter_map(|(field, content)| match content {
        Content::Bytes(word) if field == 1 => Some(std::str::from_utf8(word).unwrap_or_default()),
        _ => None,
    }));
    Ok(words)
}

/// A block of data: its words and how its places are written.
pub(super) struct Block<'a> {
    words: Vec<&'a str>,
    /// The number of each word, once an element has named it.
    numbers: Vec<Option<u32>>,
    granularity: i64,
    offset: [i64; 2],
}

impl<'a> Block<'a> {
    /// The content of a block that had so many bytes when it was packed.
    pub(super) fn new(content: &'a [u8], packed: usize) -> Result<Self, &'static str> {
        let mut block = Self { words: Vec::new(), numbers: Vec::new(), granularity: 100, offset: [0; 2] };
        for (field, content) in Fields::new(content) {
            match (field, content) {
                (1, Content::Bytes(table)) => block.words = words(table, packed / WORD + WORDS)?,
                (17, Content::Number(number)) => block.granularity = number as i64,
                (19, Content::Number(number)) => block.offset[0] = number as i64,
                (20, Content::Number(number)) => block.offset[1] = number as i64,
                _ => {}
            }
        }
        block.numbers = vec![None; block.words.len()];
        Ok(block)
    }

    /// The number in the data of a word of this block; words that it does not have are empty.
    pub(super) fn word(&mut self, data: &mut OsmData, number: u64) -> Result<u32, Full> {
        let index = usize::try_from(number).unwrap_or(usize::MAX);
        if let Some(Some(known)) = self.numbers.get(index) {
            return Ok(*known);
        }
        let found = data.number(self.words.get(index).copied().unwrap_or_default())?;
        if let Some(known) = self.numbers.get_mut(index) {
            *known = Some(found);
        }
        Ok(found)
    }

    /// Degrees of latitude and longitude.
    pub(super) fn degrees(&self, place: [i64; 2]) -> [f64; 2] {
        let nano = |axis: usize| self.offset[axis].wrapping_add(self.granularity.wrapping_mul(place[axis]));
        [0, 1].map(|axis| nano(axis) as f64 * 1e-9)
    }
}
