//! VirtualCity's own map JSON: the description of a map, complete, the same bytes for the same map.
//!
//! ```json
//! {"virtualcity_map": 1, "map": {"name": "street", "origin": {"latitude": 48.1, "longitude": 11.5}, "side": "right",
//!  "junctions": [{"at": [0.0, 0.0]}, {"at": [80.0, 0.0], "control": "signals"}],
//!  "roads": [{"from": 0, "to": 1, "line": [[0.0, 0.0], [80.0, 0.0]], "class": "residential",
//!    "section": {"forward": [{"kind": "driving", "width": 3.0, "users": ["car"], "limit": 8.3}]}}]}}
//! ```
//!
//! Metres and metres per second; [`MapDraft`] has the keys. Lanes, movements, conflicts, phases and the walkable network
//! follow from the description and are not written.

use serde::{Deserialize, Serialize};

use crate::{MapDraft, MapError, StreetMap};

/// The version that this program writes, and the latest that it reads.
pub const VERSION: u32 = 1;
/// Largest text that is read, bytes.
pub const LARGEST: usize = 256 << 20;

/// A text is not a map.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MapFileError {
    /// Not JSON, or not of the structure of a map.
    #[error("line {line}: {field}: {why}")]
    Shape {
        /// The line, counted from one.
        line: usize,
        /// The field, as a path.
        field: String,
        /// The reason.
        why: String,
    },
    /// Written by a newer version.
    #[error("the map has version {0}, at most {VERSION} is read: use a newer program")]
    Version(u32),
    /// Too large.
    #[error("the text has {0} bytes, at most {LARGEST} are read")]
    TooLarge(usize),
    /// The map cannot be built.
    #[error(transparent)]
    Map(#[from] MapError),
}

#[derive(Deserialize)]
struct Version {
    virtualcity_map: u32,
}

#[derive(Serialize)]
struct Written<'a> {
    virtualcity_map: u32,
    map: &'a MapDraft,
}

/// Writes a map.
///
/// ```
/// use vc_map::format::native;
/// use vc_map::MapDraft;
/// let map = MapDraft::new("nowhere", 48.1, 11.5).build()?;
/// assert_eq!(native::read(&native::write(&map))?, map);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write(map: &StreetMap) -> String {
    let written = Written { virtualcity_map: VERSION, map: map.draft() };
    // Numbers and words of plain types: writing them cannot fail.
    let mut text = serde_json::to_string(&written).unwrap_or_default();
    // One junction, road or building on a line.
    for key in [
        "{\"at\":",
        "{\"from\":",
        "{\"outline\":",
        "{\"building\":",
        "{\"kind\":\"bus\"",
        "],\"buildings\"",
        "],\"areas\"",
    ] {
        text = text.replace(&format!(",{key}"), &format!(",\n{key}"));
    }
    text.push('\n');
    text
}

/// Reads a map, which takes at most 16 MiB and twenty times the bytes of the text. Costs two passes over the text and the
/// building of the map.
///
/// ```
/// use vc_map::format::native;
/// let map = native::read(r#"{"virtualcity_map": 1, "map": {"name": "x", "origin": {"latitude": 48.1, "longitude": 11.5}}}"#)?;
/// assert_eq!(map.name(), "x");
/// let error = native::read("{\n\"virtualcity_map\": true}").unwrap_err();
/// assert!(error.to_string().starts_with("line 2: virtualcity_map: invalid type"));
/// # Ok::<(), native::MapFileError>(())
/// ```
///
/// # Errors
/// [`MapFileError`]: the line and field of what is no map, a newer version, a map that cannot be built.
pub fn read(text: &str) -> Result<StreetMap, MapFileError> {
    if text.len() > LARGEST {
        return Err(MapFileError::TooLarge(text.len()));
    }
    let version: Version = parse(text)?;
    if version.virtualcity_map > VERSION {
        return Err(MapFileError::Version(version.virtualcity_map));
    }
    Ok(parse::<Whole>(text)?.map.build_of_file(text.len())?)
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Whole {
    #[serde(rename = "virtualcity_map")]
    _version: u32,
    map: MapDraft,
}

fn parse<'a, T: Deserialize<'a>>(text: &'a str) -> Result<T, MapFileError> {
    let mut reader = serde_json::Deserializer::from_str(text);
    let value = serde_path_to_error::deserialize(&mut reader).map_err(|error| MapFileError::Shape {
        line: error.inner().line(),
        field: error.path().to_string(),
        why: error.inner().to_string(),
    })?;
    reader.end().map_err(|error| MapFileError::Shape {
        line: error.line(),
        field: "end".to_owned(),
        why: error.to_string(),
    })?;
    Ok(value)
}
