//! Bodies, agents and navigation.
//!
//! This crate is reserved: nothing is built here yet, and nothing is public. It
//! will build a rapier3d world from a scene graph and its assets: furniture, doors
//! and drawers on joints, agents with two hands, paths, settling, snapshots. Types
//! of the physics engine will stay private.
