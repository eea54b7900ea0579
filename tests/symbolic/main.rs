//! Tests that need neither bodies nor pictures: VirtualHome\'s scenes and programs, goals.

#[path = "../common/mod.rs"]
mod common;

mod goals;
mod replay;
mod scenes;
