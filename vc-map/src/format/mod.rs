//! File formats of maps.
//!
//! | module | content |
//! |---|---|
//! | [`native`] | VirtualCity's own map JSON, both ways, complete and versioned |
//! | [`sumo`] | SUMO's plain XML: nodes, edges, connections with crossings, traffic lights |
//! | [`opendrive`] | OpenDRIVE 1.7 |
//! | [`geojson`] | GeoJSON, for geographic programs |
//! | [`skeleton`] | the skeleton of places as the thesis's scene JSON |
//!
//! OpenStreetMap's files are read by [`osm`](crate::osm).

pub mod geojson;
pub mod native;
pub mod opendrive;
pub mod skeleton;
pub mod sumo;
pub(crate) mod xml;
