//! Reading numbers from a file's bytes, with every range checked.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::rc::Rc;

use super::GltfError;
use super::buffers::Buffers;
use super::document::{Accessor, BYTE, Document, FLOAT, INT, SHORT, SIGNED_BYTE, SIGNED_SHORT, Sparse, View};

/// The bytes of a buffer view.
pub(super) fn slice<'a>(document: &Document, buffers: &'a Buffers<'_>, index: usize) -> Result<&'a [u8], GltfError> {
    viewed(document, buffers, index)?.1.ok_or(GltfError::BadView(index))
}

/// A buffer view and its bytes; `None` if they reach beyond its buffer.
fn viewed<'d, 'a>(
    document: &'d Document,
    buffers: &'a Buffers<'_>,
    index: usize,
) -> Result<(&'d View, Option<&'a [u8]>), GltfError> {
    let view = document.buffer_views.get(index).ok_or(GltfError::missing("buffer view", index))?;
    let buffer = buffers.get(view.buffer.ok_or(GltfError::NoBuffer(index))?)?;
    Ok((view, range(buffer, view.byte_offset, Some(view.byte_length))))
}

/// The accessors of a file. Many primitives may share one, so its sparse part is read once.
pub(super) struct Accessors<'a> {
    pub(super) document: &'a Document,
    buffers: &'a Buffers<'a>,
    replaced: RefCell<BTreeMap<usize, Rc<Replaced<'a>>>>,
}

impl<'a> Accessors<'a> {
    pub(super) fn new(document: &'a Document, buffers: &'a Buffers<'a>) -> Self {
        Self { document, buffers, replaced: RefCell::default() }
    }

    /// Positions, as floats or quantised.
    pub(super) fn vectors(&self, index: usize) -> Result<Elements<'a>, GltfError> {
        self.elements(index, "VEC3", 3)
    }

    /// Indices: unsigned integers.
    pub(super) fn indices(&self, index: usize) -> Result<Elements<'a>, GltfError> {
        let all = self.elements(index, "SCALAR", 1)?;
        let whole = [BYTE, SHORT, INT].contains(&all.component);
        whole.then_some(all).ok_or(GltfError::BadAccessor { index, reason: "has no whole numbers: indices are" })
    }

    /// Texture coordinates, as floats or quantised.
    pub(super) fn pairs(&self, index: usize) -> Result<Elements<'a>, GltfError> {
        self.elements(index, "VEC2", 2)
    }

    fn elements(&self, index: usize, kind: &str, components: usize) -> Result<Elements<'a>, GltfError> {
        let bad = |reason| GltfError::BadAccessor { index, reason };
        let accessor = self.document.accessors.get(index).ok_or(GltfError::missing("accessor", index))?;
        if accessor.kind != kind {
            return Err(bad("has another shape of element than its use needs"));
        }
        let (count, component, normalized) = (accessor.count, accessor.component_type, accessor.normalized);
        let size = components * width(component).ok_or(bad("has another type of number than is read"))?;
        let source = Source { document: self.document, buffers: self.buffers, index };
        let dense = accessor.buffer_view.map(|view| source.run(view, accessor.byte_offset, count, size)).transpose()?;
        let replaced = self.replaced(&source, accessor, size)?;
        if dense.is_none() && accessor.sparse.is_none() {
            return Err(bad("has no buffer view: export without compression"));
        }
        Ok(Elements { count, component, normalized, dense, replaced })
    }

    /// The sparse part of an accessor. The shape of an element, and so its size, is the same at each use.
    fn replaced(&self, source: &Source<'a>, accessor: &Accessor, size: usize) -> Result<Rc<Replaced<'a>>, GltfError> {
        if let Some(read) = self.replaced.borrow().get(&source.index) {
            return Ok(read.clone());
        }
        let read = Rc::new(source.replaced(accessor, size)?);
        self.replaced.borrow_mut().insert(source.index, read.clone());
        Ok(read)
    }
}

/// The elements of an accessor.
pub(super) struct Elements<'a> {
    pub(super) count: usize,
    component: u32,
    normalized: bool,
    /// The elements of the buffer view; without one, all elements but the replaced ones are zero.
    dense: Option<Run<'a>>,
    replaced: Rc<Replaced<'a>>,
}

impl<'a> Elements<'a> {
    /// The numbers of an element; `None` if the index is out of range.
    pub(super) fn numbers<const N: usize>(&self, at: usize) -> Option<[f32; N]> {
        let mut all = [0.0; N];
        let Some(bytes) = self.element(at)? else { return Some(all) };
        for (number, bytes) in all.iter_mut().zip(bytes.chunks_exact(bytes.len() / N)) {
            *number = real(self.component, self.normalized, bytes)?;
        }
        Some(all)
    }

    pub(super) fn index(&self, at: usize) -> Option<usize> {
        self.element(at)?.map_or(Some(0), |bytes| whole(self.component, bytes))
    }

    /// The bytes of an element, or an inner `None` where it is zero.
    fn element(&self, at: usize) -> Option<Option<&'a [u8]>> {
        let there = at < self.count;
        there.then(|| self.replaced.element(at).or_else(|| self.dense.as_ref()?.element(at)))
    }
}

/// The elements of a sparse accessor, which replace those of its buffer view.
#[derive(Default)]
struct Replaced<'a> {
    values: Option<Run<'a>>,
    /// For the index of an element, its index among the values.
    places: BTreeMap<usize, usize>,
}

impl<'a> Replaced<'a> {
    fn element(&self, at: usize) -> Option<&'a [u8]> {
        self.values.as_ref()?.element(*self.places.get(&at)?)
    }
}

/// A sequence of elements of one size.
struct Run<'a> {
    bytes: &'a [u8],
    stride: usize,
    size: usize,
}

impl<'a> Run<'a> {
    fn element(&self, at: usize) -> Option<&'a [u8]> {
        range(self.bytes, at.checked_mul(self.stride)?, Some(self.size))
    }
}

/// The source of an accessor's elements.
struct Source<'a> {
    document: &'a Document,
    buffers: &'a Buffers<'a>,
    index: usize,
}

impl<'a> Source<'a> {
    fn bad(&self, reason: &'static str) -> GltfError {
        GltfError::BadAccessor { index: self.index, reason }
    }

    fn run(&self, view: usize, offset: usize, count: usize, size: usize) -> Result<Run<'a>, GltfError> {
        let (view, bytes) = viewed(self.document, self.buffers, view)?;
        let bytes = bytes.and_then(|b| range(b, offset, None)).ok_or_else(|| self.bad("reaches beyond its buffer"))?;
        let stride = view.byte_stride.unwrap_or(size);
        let needed = (count.saturating_sub(1)).checked_mul(stride).and_then(|n| n.checked_add(size));
        if stride < size || count == 0 || needed.is_none_or(|needed| needed > bytes.len()) {
            return Err(self.bad("has more elements than its buffer holds, or none"));
        }
        Ok(Run { bytes, stride, size })
    }

    fn replaced(&self, accessor: &Accessor, size: usize) -> Result<Replaced<'a>, GltfError> {
        let Some(sparse) = accessor.sparse.clone() else { return Ok(Replaced::default()) };
        let unread = || self.bad("has a sparse part that cannot be read");
        let sparse: Sparse = serde_json::from_value(sparse).map_err(|_| unread())?;
        let (which, values) = (&sparse.indices, &sparse.values);
        let narrow = width(which.component_type).ok_or_else(unread)?;
        let run = |view: Option<usize>, offset, size| self.run(view.ok_or_else(unread)?, offset, sparse.count, size);
        let indices = run(which.buffer_view, which.byte_offset, narrow)?;
        let place = |at| Some((whole(which.component_type, indices.element(at)?)?, at));
        let places = (0..sparse.count).map(place).collect::<Option<_>>().ok_or_else(unread)?;
        Ok(Replaced { values: Some(run(values.buffer_view, values.byte_offset, size)?), places })
    }
}

/// The number of bytes of a component.
fn width(component: u32) -> Option<usize> {
    match component {
        BYTE | SIGNED_BYTE => Some(1),
        SHORT | SIGNED_SHORT => Some(2),
        INT | FLOAT => Some(4),
        _ => None,
    }
}

/// A number as it is or, if normalised, as a fraction of its type's maximum.
fn real(component: u32, normalized: bool, bytes: &[u8]) -> Option<f32> {
    let (value, most) = match component {
        FLOAT => return Some(f32::from_le_bytes(bytes.try_into().ok()?)),
        SIGNED_BYTE => (f32::from(i8::from_le_bytes(bytes.try_into().ok()?)), f32::from(i8::MAX)),
        SIGNED_SHORT => (f32::from(i16::from_le_bytes(bytes.try_into().ok()?)), f32::from(i16::MAX)),
        BYTE => (f32::from(*bytes.first()?), f32::from(u8::MAX)),
        SHORT => (f32::from(u16::from_le_bytes(bytes.try_into().ok()?)), f32::from(u16::MAX)),
        _ => (whole(component, bytes)? as f32, u32::MAX as f32),
    };
    Some(if normalized { (value / most).max(-1.0) } else { value })
}

fn whole(component: u32, bytes: &[u8]) -> Option<usize> {
    match component {
        INT => Some(u32::from_le_bytes(bytes.try_into().ok()?) as usize),
        SHORT => Some(usize::from(u16::from_le_bytes(bytes.try_into().ok()?))),
        BYTE => bytes.first().map(|&b| usize::from(b)),
        _ => None,
    }
}

fn range(bytes: &[u8], start: usize, length: Option<usize>) -> Option<&[u8]> {
    let end = length.map_or(Some(bytes.len()), |n| start.checked_add(n))?;
    bytes.get(start..end)
}
