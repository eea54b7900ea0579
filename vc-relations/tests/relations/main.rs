//! Tests of relations read from geometry, in one program: each program links anew.

#[path = "../shared/mod.rs"]
mod shared;

mod box_trace;
mod explain;
mod geometry;
mod home;
mod peers;
mod rooms;
mod truth;
mod update;
mod upkeep;
mod virtual_home;
