//! Tests of vc-map through its public API.
#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

mod bounds;
mod formats;
mod junctions;
mod lines;
mod opendrive;
mod osm;
mod pictures;
mod readers;
mod real;
mod right_of_way;
mod routes;
mod town;
