//! The bytes of a file's buffers: from its container, and from data URIs in its text.

use std::borrow::Cow;

use super::GltfError;
use super::document::Document;

/// The document's buffers; `None` for one in another file.
pub(super) struct Buffers<'a>(Vec<Option<Cow<'a, [u8]>>>);

impl<'a> Buffers<'a> {
    /// The first buffer is the container's bytes, unless the buffer has a URI.
    pub(super) fn new(document: &Document, container: &'a [u8]) -> Self {
        let own = Some(Cow::Borrowed(container)).filter(|bytes| !bytes.is_empty());
        let each = document.buffers.iter().zip(std::iter::once(own).chain(std::iter::repeat(None)));
        Self(each.map(|(buffer, own)| buffer.uri.as_deref().map_or(own, |uri| inline(uri).map(Cow::Owned))).collect())
    }

    pub(super) fn get(&self, number: usize) -> Result<&[u8], GltfError> {
        let found = self.0.get(number).ok_or(GltfError::missing("buffer", number))?;
        found.as_deref().ok_or(GltfError::ExternalBuffer(number))
    }
}

/// The bytes in a data URI: `data:[type];base64,...`.
pub(super) fn inline(uri: &str) -> Option<Vec<u8>> {
    let (head, body) = uri.strip_prefix("data:")?.split_once(',')?;
    base64(body.as_bytes()).filter(|_| head.ends_with(";base64"))
}

/// Four letters encode three bytes; the last group may encode fewer.
fn base64(text: &[u8]) -> Option<Vec<u8>> {
    let text = text.trim_ascii_end();
    let end = text.iter().rposition(|&letter| letter != b'=').map_or(0, |last| last + 1);
    let mut bytes = Vec::with_capacity(end / 4 * 3 + 2);
    for letters in text[..end].chunks(4) {
        let bits = letters.iter().try_fold(0u32, |bits, &letter| Some(bits << 6 | sextet(letter)?))?;
        let spare = 4 - letters.len();
        bytes.extend_from_slice(&(bits << (6 * spare)).to_be_bytes()[1..4 - spare.min(2)]);
        if spare == 3 {
            return None;
        }
    }
    Some(bytes)
}

fn sextet(letter: u8) -> Option<u32> {
    Some(u32::from(match letter {
        b'A'..=b'Z' => letter - b'A',
        b'a'..=b'z' => letter - b'a' + 26,
        b'0'..=b'9' => letter - b'0' + 52,
        b'+' | b'-' => 62,
        b'/' | b'_' => 63,
        _ => return None,
    }))
}
