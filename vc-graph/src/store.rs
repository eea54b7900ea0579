//! A persistent map from node number to node, in number order.
//!
//! Nodes are stored in chunks of sixteen behind `Arc`s: cloning copies one pointer for every sixteen numbers,
//! an edit copies one chunk of pointers and one node, and a look-up is two array accesses if numbers are dense.

use std::sync::Arc;

use crate::NodeId;

const BITS: u32 = 4;
const SIZE: usize = 1 << BITS;

type Chunk<T> = [Option<Arc<T>>; SIZE];

#[derive(Debug, Clone)]
pub(crate) struct Store<T> {
    /// Sorted by the chunk's number; dense scenes have `chunks[i].0 == i`.
    chunks: Vec<(u32, Arc<Chunk<T>>)>,
    len: usize,
}

impl<T> Default for Store<T> {
    fn default() -> Self {
        Self { chunks: Vec::new(), len: 0 }
    }
}

fn split(id: NodeId) -> (u32, usize) {
    (id.0 >> BITS, id.0 as usize & (SIZE - 1))
}

impl<T> Store<T> {
    pub(crate) fn len(&self) -> usize {
        self.len
    }

    fn find(&self, chunk: u32) -> Result<usize, usize> {
        match self.chunks.get(chunk as usize) {
            Some(&(number, _)) if number == chunk => Ok(chunk as usize),
            _ => self.chunks.binary_search_by_key(&chunk, |&(number, _)| number),
        }
    }

    pub(crate) fn get(&self, id: NodeId) -> Option<&Arc<T>> {
        let (chunk, offset) = split(id);
        let position = self.find(chunk).ok()?;
        self.chunks[position].1[offset].as_ref()
    }

    /// All values, in number order.
    pub(crate) fn iter(&self) -> impl Iterator<Item = &Arc<T>> {
        self.chunks.iter().flat_map(|(_, chunk)| chunk.iter().flatten())
    }

    /// The numbers at which two maps have values that are not shared, in order, with both values. Chunks that
    /// clones share are skipped.
    pub(crate) fn unshared<'s>(&'s self, other: &'s Self) -> Vec<[Option<&'s Arc<T>>; 2]> {
        let mut found = Vec::new();
        let (mut left, mut right) = (self.chunks.iter().peekable(), other.chunks.iter().peekable());
        loop {
            let first = match (left.peek(), right.peek()) {
                (Some((a, _)), Some((b, _))) => *a.min(b),
                (Some((number, _)), None) | (None, Some((number, _))) => *number,
                (None, None) => return found,
            };
            let here = |(number, _): &&(u32, Arc<Chunk<T>>)| *number == first;
            let (a, b) = (left.next_if(here).map(|(_, chunk)| chunk), right.next_if(here).map(|(_, chunk)| chunk));
            if a.zip(b).is_some_and(|(a, b)| Arc::ptr_eq(a, b)) {
                continue;
            }
            let cell = |chunk: Option<&'s Arc<Chunk<T>>>, offset: usize| chunk.and_then(|chunk| chunk[offset].as_ref());
            let cells = (0..SIZE).map(|offset| [cell(a, offset), cell(b, offset)]);
            let same = |[a, b]: &[Option<&Arc<T>>; 2]| {
                a.zip(*b).map_or(a.is_none() && b.is_none(), |(a, b)| Arc::ptr_eq(a, b))
            };
            found.extend(cells.filter(|cell| !same(cell)));
        }
    }

    pub(crate) fn remove(&mut self, id: NodeId) -> Option<Arc<T>> {
        let (chunk, offset) = split(id);
        let position = self.find(chunk).ok()?;
        self.chunks[position].1[offset].as_ref()?;
        let cells = Arc::make_mut(&mut self.chunks[position].1);
        let removed = cells[offset].take();
        if cells.iter().all(Option::is_none) {
            self.chunks.remove(position);
        }
        self.len -= usize::from(removed.is_some());
        removed
    }

    /// Stores a value under a number and returns the previous value.
    pub(crate) fn insert(&mut self, id: NodeId, value: Arc<T>) -> Option<Arc<T>> {
        let (chunk, offset) = split(id);
        let position = self.find(chunk).unwrap_or_else(|position| {
            self.chunks.insert(position, (chunk, Arc::new([const { None }; SIZE])));
            position
        });
        let old = Arc::make_mut(&mut self.chunks[position].1)[offset].replace(value);
        self.len += usize::from(old.is_none());
        old
    }
}

impl<T: Clone> Store<T> {
    /// Mutable access to the value at a number; the value is copied first if a clone shares it.
    pub(crate) fn get_mut(&mut self, id: NodeId) -> Option<&mut T> {
        let (chunk, offset) = split(id);
        let position = self.find(chunk).ok()?;
        self.chunks[position].1[offset].as_ref()?;
        let cell = Arc::make_mut(&mut self.chunks[position].1)[offset].as_mut()?;
        Some(Arc::make_mut(cell))
    }
}
