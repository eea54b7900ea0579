//! An allocator that counts, for each thread on its own, as tests run beside each other.
#![allow(unsafe_code, reason = "an allocator that counts")]

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

struct Counting;

thread_local! {
    /// Bytes in use, and the most of them so far.
    static BYTES: Cell<[isize; 2]> = const { Cell::new([0; 2]) };
}

fn count(more: isize) {
    // A thread that ends has no counter any more.
    let _ = BYTES.try_with(|bytes| {
        let [now, most] = bytes.get();
        bytes.set([now + more, most.max(now + more)]);
    });
}

// SAFETY: everything is passed on to the system's allocator unchanged.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        count(layout.size() as isize);
        // SAFETY: guaranteed by the caller.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, at: *mut u8, layout: Layout) {
        count(-(layout.size() as isize));
        // SAFETY: guaranteed by the caller.
        unsafe { System.dealloc(at, layout) }
    }

    unsafe fn realloc(&self, at: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        // Large blocks are moved by the system without a copy beside them.
        count(size as isize - layout.size() as isize);
        // SAFETY: guaranteed by the caller.
        unsafe { System.realloc(at, layout, size) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// The most bytes that this thread had more than before, while a function ran, and its result.
pub(crate) fn most<T>(done: impl FnOnce() -> T) -> (usize, T) {
    let before = BYTES.with(|bytes| {
        let [now, _] = bytes.get();
        bytes.set([now, now]);
        now
    });
    let made = done();
    let [_, most] = BYTES.with(Cell::get);
    (usize::try_from(most - before).unwrap_or(0), made)
}
