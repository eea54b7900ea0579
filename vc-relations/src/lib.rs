//! Relations read from geometry: six box traces per object.
//!
//! This crate is reserved: nothing is built here yet, and nothing is public.
//! `ARCHITECTURE.md` says what it will hold.
