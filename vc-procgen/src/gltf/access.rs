//! Numbers out of a file's bytes, every range checked.

use super::GltfError;
use super::document::{BYTE, Document, FLOAT, INT, SHORT};

/// The bytes of a buffer view.
pub(super) fn slice<'a>(document: &Document, file: &'a [u8], index: usize) -> Result<&'a [u8], GltfError> {
    let view = document.buffer_views.get(index).ok_or(GltfError::missing("buffer view", index))?;
    let bytes = range(buffer(document, file, view.buffer)?, view.byte_offset, Some(view.byte_length));
    bytes.ok_or(GltfError::BadView(index))
}

/// The elements of an accessor.
pub(super) struct Elements<'a> {
    bytes: &'a [u8],
    stride: usize,
    size: usize,
    component: u32,
    pub(super) count: usize,
}

impl<'a> Elements<'a> {
    fn new(document: &Document, file: &'a [u8], index: usize, kind: &str) -> Result<Self, GltfError> {
        let bad = |reason| GltfError::BadAccessor { index, reason };
        let accessor = document.accessors.get(index).ok_or(GltfError::missing("accessor", index))?;
        if accessor.sparse.is_some() {
            return Err(bad("is sparse: export without sparse accessors"));
        }
        let number = accessor.buffer_view.ok_or(bad("has no buffer view: export without compression"))?;
        let view = document.buffer_views.get(number).ok_or(GltfError::missing("buffer view", number))?;
        let component = accessor.component_type;
        let size = match (kind, component) {
            ("VEC3", FLOAT) => 12,
            ("VEC2", FLOAT) => 8,
            ("VEC2", SHORT) if accessor.normalized => 4,
            ("VEC2", BYTE) if accessor.normalized => 2,
            ("SCALAR", INT) => 4,
            ("SCALAR", SHORT) => 2,
            ("SCALAR", BYTE) => 1,
            _ => return Err(bad("has another type of number: export without quantisation")),
        };
        if accessor.kind != kind {
            return Err(bad("has another shape of element than its use needs"));
        }
        let bytes = range(buffer(document, file, view.buffer)?, view.byte_offset, Some(view.byte_length));
        let bytes = bytes.and_then(|b| range(b, accessor.byte_offset, None)).ok_or(bad("reaches beyond its buffer"))?;
        let stride = view.byte_stride.unwrap_or(size);
        let needed = (accessor.count.saturating_sub(1)).checked_mul(stride).and_then(|n| n.checked_add(size));
        if stride < size || accessor.count == 0 || needed.is_none_or(|needed| needed > bytes.len()) {
            return Err(bad("has more elements than its buffer holds, or none"));
        }
        Ok(Self { bytes, stride, size, component, count: accessor.count })
    }

    pub(super) fn vectors(document: &Document, file: &'a [u8], index: usize) -> Result<Self, GltfError> {
        Self::new(document, file, index, "VEC3")
    }

    pub(super) fn indices(document: &Document, file: &'a [u8], index: usize) -> Result<Self, GltfError> {
        Self::new(document, file, index, "SCALAR")
    }

    /// Pairs of numbers, those of bytes and shorts in shares of their greatest.
    pub(super) fn pairs(document: &Document, file: &'a [u8], index: usize) -> Result<Self, GltfError> {
        Self::new(document, file, index, "VEC2")
    }

    fn element(&self, at: usize) -> Option<&'a [u8]> {
        if at >= self.count {
            return None;
        }
        let start = at * self.stride;
        self.bytes.get(start..start + self.size)
    }

    pub(super) fn vector(&self, at: usize) -> Option<[f32; 3]> {
        let bytes = self.element(at)?;
        let word = |i: usize| Some(f32::from_le_bytes(bytes.get(i * 4..i * 4 + 4)?.try_into().ok()?));
        Some([word(0)?, word(1)?, word(2)?])
    }

    pub(super) fn pair(&self, at: usize) -> Option<[f32; 2]> {
        let bytes = self.element(at)?;
        let part = |i: usize| match self.component {
            FLOAT => Some(f32::from_le_bytes(bytes.get(i * 4..i * 4 + 4)?.try_into().ok()?)),
            SHORT => Some(f32::from(u16::from_le_bytes(bytes.get(i * 2..i * 2 + 2)?.try_into().ok()?)) / 65_535.0),
            _ => bytes.get(i).map(|&b| f32::from(b) / 255.0),
        };
        Some([part(0)?, part(1)?])
    }

    pub(super) fn index(&self, at: usize) -> Option<usize> {
        let bytes = self.element(at)?;
        match self.component {
            INT => Some(u32::from_le_bytes(bytes.try_into().ok()?) as usize),
            SHORT => Some(usize::from(u16::from_le_bytes(bytes.try_into().ok()?))),
            _ => bytes.first().map(|&b| usize::from(b)),
        }
    }
}

fn buffer<'a>(document: &Document, file: &'a [u8], number: Option<usize>) -> Result<&'a [u8], GltfError> {
    let number = number.unwrap_or(usize::MAX);
    let buffer = document.buffers.get(number).ok_or(GltfError::missing("buffer", number))?;
    if number > 0 || buffer.uri.is_some() || file.is_empty() {
        return Err(GltfError::ExternalBuffer(number));
    }
    Ok(file)
}

fn range(bytes: &[u8], start: usize, length: Option<usize>) -> Option<&[u8]> {
    let end = length.map_or(Some(bytes.len()), |n| start.checked_add(n))?;
    bytes.get(start..end)
}
