//! Objects and apartments from a seed.
//!
//! This crate is reserved: nothing is built here yet, and nothing is public. It
//! will make parametric objects with real dimensions and whole apartments with
//! furniture and small things, the same for the same seed on every machine.
