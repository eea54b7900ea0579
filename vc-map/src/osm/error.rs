//! Errors of files of OpenStreetMap.

/// A file of OpenStreetMap cannot be read.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum OsmError {
    /// Not XML.
    #[error("line {line}: {why}; OpenStreetMap's XML was expected")]
    Xml {
        /// The line, counted from one.
        line: usize,
        /// The reason.
        why: String,
    },
    /// Not PBF, or none that is read.
    #[error("byte {byte}: {why}; OpenStreetMap's PBF was expected")]
    Pbf {
        /// Where the block begins, counted from zero.
        byte: usize,
        /// The reason.
        why: &'static str,
    },
    /// Not OpenStreetMap's XML.
    #[error("line {line}: `<osm>` was expected, found {found}")]
    NotOsm {
        /// The line, counted from one.
        line: usize,
        /// The element or text that was found.
        found: String,
    },
    /// An attribute is missing or not a number.
    #[error("line {line}: `<{element}>` needs `{attribute}`, a number")]
    Attribute {
        /// The line, counted from one.
        line: usize,
        /// The element.
        element: String,
        /// The attribute.
        attribute: &'static str,
    },
    /// A node is not on Earth.
    #[error("node {0} has no latitude of -90 to 90 and longitude of -180 to 180 degrees")]
    Place(i64),
    /// The file ends before its root does.
    #[error("line {0}: the file ends before `</osm>`: is it cut off?")]
    CutOff(usize),
    /// The file is too large.
    #[error("the file has {0} bytes, at most {most} are read: cut out a part, for example with osmium", most = super::LARGEST)]
    TooLarge(usize),
    /// The description of the map would take far more memory than the file, as no file of a real place does.
    #[error("the roads take more than {most} bytes, far more than the file: cut out a part, or give it as XML")]
    TooMuch {
        /// The bytes that they may take.
        most: usize,
    },
    /// The file has no node at which a way could be.
    #[error("the file has no ways with nodes: there is nothing to make a map of")]
    Empty,
}
