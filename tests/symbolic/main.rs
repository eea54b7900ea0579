//! Tests that need neither bodies nor pictures: VirtualHome\'s scenes and programs, goals.

mod goals;
mod replay;
mod scenes;
