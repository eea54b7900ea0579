//! OpenStreetMap in: XML and PBF to a [`MapDraft`], with an account of everything that was guessed, dropped or not used.
//!
//! | not mapped | rule |
//! |---|---|
//! | lanes | two a direction on motorways, trunk and primary roads, else one; as SUMO's map of types has it |
//! | width of a lane | 3.5 m on motorways and trunk roads, 3.25 m to secondary, 3 m on tertiary roads, 2.75 m on minor and residential ones, 2.5 m on drives; 3.5 m for a single lane of a one-way street |
//! | limit | 100, 70, 50 km/h on motorways, trunk roads and streets, 30 km/h on residential ones, 7 and 15 km/h in living streets and drives |
//! | pavements | on both sides of primary to residential streets, where no footway accompanies them: 4, 3 or 2.4 m wide; so also where they are said to be mapped apart and are not |
//! | ways to a crossing | a path to the nearest footway within 25 m, on each side without a pavement; a crossing that has none stays away |
//! | paths | 2 m wide, streets for people on foot 5 m |
//! | buildings | three storeys of 3.1 m; a door on the wall nearest to a way |
//! | direction of a sign | for those who come to the nearest junction, within 60 m |
//! | who passes a gate | those with two wheels and people; cars where the gate or its way lets them in by a key of access |
//!
//! ```
//! use vc_map::osm::{ImportOptions, OsmData};
//! let file = br#"<osm version="0.6">
//!   <node id="1" lat="48.1000" lon="11.5000"/>
//!   <node id="2" lat="48.1010" lon="11.5000"/>
//!   <way id="7"><nd ref="1"/><nd ref="2"/><tag k="highway" v="residential"/></way>
//! </osm>"#;
//! let (draft, report) = OsmData::from_xml(file)?.draft(&ImportOptions::default())?;
//! let map = draft.build()?;
//! // A lane and a pavement in each direction.
//! assert_eq!(map.lanes().len(), 4);
//! assert!(report.to_string().contains("guessed  way 7: limit 30 km/h"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

// The rules for what is not mapped are in `street`, `lanes` and `beside`.
mod beside;
mod block;
mod clusters;
mod data;
mod doors;
mod emit;
mod error;
mod kerbs;
mod lanes;
mod links;
mod marks;
mod merge;
mod network;
mod pavements;
mod pbf;
mod places;
mod report;
mod restrictions;
mod rings;
mod side;
mod signals;
mod signs;
mod street;
mod tags;
mod units;
mod wire;
mod words;
mod xml;

pub use data::{Element, OsmData};
pub use error::OsmError;
pub use report::{Guessed, ImportReport, Reason};

use self::tags::Source;
use self::words::{Full, Room};
use crate::{DrivingSide, MapDraft};

/// The roads of a description and the tags that are told may take this many bytes, and this many for each byte of the file.
const LEAST_BYTES: usize = 8 << 20;
const OF_DESCRIPTION: usize = 8;

/// The largest file that is read, bytes.
pub const LARGEST: usize = 1 << 30;

/// How a map is made of OpenStreetMap's data.
///
/// ```
/// use vc_map::DrivingSide;
/// use vc_map::osm::{ImportOptions, OsmData};
/// # let file = br#"<osm version="0.6"><node id="1" lat="48.1" lon="11.5"/><node id="2" lat="48.2" lon="11.5"/>
/// #   <way id="7"><nd ref="1"/><nd ref="2"/><tag k="highway" v="residential"/></way></osm>"#;
/// let options = ImportOptions { name: "street".into(), side: Some(DrivingSide::Left) };
/// let (draft, _) = OsmData::from_xml(file)?.draft(&options)?;
/// assert_eq!((draft.name.as_str(), draft.side), ("street", DrivingSide::Left));
/// # Ok::<(), vc_map::osm::OsmError>(())
/// ```
#[derive(Debug, Clone, Default)]
pub struct ImportOptions {
    /// The map's name.
    pub name: String,
    /// The side on which vehicles drive; without one it is guessed, from roundabouts or else from the place.
    pub side: Option<DrivingSide>,
}

impl OsmData {
    /// A map of this data, and the account of whatever was guessed, dropped or not used. Costs a few passes over
    /// the data; the same data gives the same map.
    ///
    /// # Errors
    /// [`OsmError::Empty`] if no way has nodes, [`OsmError::TooMuch`] if the description takes far more memory than the file.
    pub fn draft(&self, options: &ImportOptions) -> Result<(MapDraft, ImportReport), OsmError> {
        let most = OF_DESCRIPTION.saturating_mul(self.size).saturating_add(LEAST_BYTES);
        let (mut report, mut room) = (ImportReport::default(), Room(most));
        let too_much = |Full| OsmError::TooMuch { most };
        let mut source = Source::new(self);
        let frame = source.frame().ok_or(OsmError::Empty)?;
        source.lay_out(&frame);
        let side = source.side(options.side, frame.origin, &mut report);
        let mut draft = MapDraft::new(options.name.clone(), frame.origin.latitude, frame.origin.longitude);
        draft.side = side;
        let mut network = network::Network::new(&source, side, &mut report);
        let (clusters, signals) = signals::signals(&mut network, &mut report);
        emit::emit(&network, &clusters, &signals, &mut draft, &mut room, &mut report).map_err(too_much)?;
        restrictions::bans(&network, &mut draft, &mut report);
        places::places(&source, &mut draft, &mut report);
        report.close(&source, &mut room).map_err(too_much)?;
        Ok((draft, report))
    }
}

/// Whether degrees of latitude and longitude are a place on Earth.
fn is_on_earth([latitude, longitude]: [f64; 2]) -> bool {
    latitude.abs() <= 90.0 && longitude.abs() <= 180.0
}
