//! Tests of vc-map through its public API.
#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

mod account;
mod apart;
mod bounds;
mod broken;
mod checks;
mod control;
mod formats;
mod hostile;
mod junctions;
mod lanes;
mod lines;
mod memory;
mod opendrive;
mod osm;
mod pbf;
mod pictures;
mod readers;
mod real;
mod right_of_way;
mod routes;
mod signs;
mod town;
mod whole;
mod world;
