//! Six visual modalities from one camera, on a CPU.
//!
//! This crate is reserved: nothing is built here yet, and nothing is public.
//! `ARCHITECTURE.md` says what it will hold.
