//! Tests of vc-map through its public API.
#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

mod account;
mod control;
mod formats;
mod hostile;
mod junctions;
mod lanes;
mod lines;
mod memory;
mod osm;
mod pbf;
mod pictures;
mod readers;
mod real;
mod routes;
mod town;
mod world;
