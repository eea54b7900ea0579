//! Tests of bodies, agents and navigation, in one program: each program links the physics engine anew.

#[path = "../common/mod.rs"]
mod common;

mod agents;
mod determinism;
mod fitting;
mod guided_hands;
mod joints;
mod known_answers;
mod navigation;
mod reads;
mod recorded;
mod rest;
mod scenes;
mod traps;
mod travellers;
mod water;
