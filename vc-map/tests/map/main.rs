//! Tests of vc-map through its public API.
#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

mod formats;
mod junctions;
mod lines;
mod osm;
mod pictures;
mod readers;
mod real;
mod routes;
mod town;
