//! Streets.
//!
//! # Streets of a real place
//!
//! [`map`](crate::map) reads OpenStreetMap's files. The report lists whatever was guessed and dropped, with numbers by
//! which it is found on the map; `validate` lists with places whatever is wrong. Cars, bicycles and people on foot have routes,
//! and drawings are SVG. The example `map` does all of this with a file of your own, and writes it for SUMO and OpenDRIVE.
//!
//! ```
//! # #[cfg(feature = "map")]
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! use virtualcity::map::osm::{ImportOptions, OsmData};
//! use virtualcity::map::picture::Drawing;
//! use virtualcity::map::route::{Mode, Router};
//!
//! // `std::fs::read("place.osm")`, or a file of PBF; here a street with a cross street that has lights.
//! let file = br#"<osm><node id="1" lat="48.100" lon="11.600"/><node id="2" lat="48.101" lon="11.600"/>
//!   <node id="3" lat="48.102" lon="11.600"/><node id="4" lat="48.101" lon="11.602"/>
//!   <way id="7"><nd ref="1"/><nd ref="2"/><nd ref="3"/><tag k="highway" v="secondary"/><tag k="name" v="Long Street"/></way>
//!   <way id="8"><nd ref="2"/><nd ref="4"/><tag k="highway" v="residential"/></way></osm>"#;
//! let (draft, report) = OsmData::read(file)?.draft(&ImportOptions::default())?;
//! let map = draft.build_of_file(file.len())?;
//! assert!(report.to_string().contains("guessed  way 8"));
//! assert_eq!(map.validate(), []);
//!
//! let (south, east) = ([0.0, -80.0].into(), [60.0, 0.0].into());
//! let drive = Router::new(&map, Mode::Car).route(&south, &east).ok_or("no way")?;
//! let walk = Router::new(&map, Mode::Foot).route(&south, &east).ok_or("no way")?;
//! assert!(drive.seconds < walk.seconds);
//! assert!(Drawing::of(&map).svg(2.0).contains("Long Street"));
//! # Ok(())
//! # }
//! # #[cfg(not(feature = "map"))]
//! # fn main() {}
//! ```
