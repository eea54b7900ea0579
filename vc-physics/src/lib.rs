//! Bodies that move: a rapier3d world built from a scene graph.
//!
//! This crate is reserved: nothing is built here yet, and nothing is public.
//! `ARCHITECTURE.md` says what it will hold.
