//! Tests of traffic through its public interface.

#![allow(clippy::unwrap_used, missing_docs, reason = "a test that cannot go on fails")]

mod crowd;
mod extracts;
mod foot;
mod grid;
mod hooks;
mod long;
mod measures;
mod people;
mod rules;
mod streets;
mod timetable;
