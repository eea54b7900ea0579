//! OpenStreetMap's XML, read in one pass.

use quick_xml::Reader;
use quick_xml::events::{BytesStart, Event};

use vc_graph::clip;

use super::data::{Element, Open, OsmData};
use super::words::{Full, Room};
use super::{LARGEST, OsmError, is_on_earth};

/// An element that is open.
struct Current {
    kind: Kind,
    id: i64,
    at: [f64; 2],
    /// Whether it was deleted, and is told of only so that it can be told of.
    gone: bool,
    open: Open,
    /// The depth of its own tag.
    depth: usize,
}

#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Node,
    Way,
    Relation,
}

impl OsmData {
    /// Reads OpenStreetMap's XML. Everything but nodes, ways, relations and bounds is passed over, and so are elements that
    /// were deleted. The data takes at most 20 times the bytes of the file.
    ///
    /// ```
    /// use vc_map::osm::OsmData;
    /// let data = OsmData::from_xml(br#"<osm version="0.6"><node id="1" lat="48.1" lon="11.5"/></osm>"#)?;
    /// assert_eq!(data.counts(), [1, 0, 0]);
    /// let error = OsmData::from_xml(b"\n<html>").unwrap_err();
    /// assert_eq!(error.to_string(), "line 2: `<osm>` was expected, found `<html>`");
    /// # Ok::<(), vc_map::osm::OsmError>(())
    /// ```
    ///
    /// # Errors
    /// [`OsmError`] with the line (of a node that is not on Earth with its number): no XML, another root, missing numbers, a
    /// file that is cut off.
    pub fn from_xml(file: &[u8]) -> Result<Self, OsmError> {
        if file.len() > LARGEST {
            return Err(OsmError::TooLarge(file.len()));
        }
        // An element of XML is longer than what is kept of it.
        let data = Self::of_file(file.len(), Room(usize::MAX));
        let mut reader = XmlReader { file, xml: Reader::from_reader(file), data, current: None, depth: 0 };
        reader.root()?;
        reader.all()?;
        let mut data = reader.data;
        data.close().map_err(|Full| OsmError::TooLarge(file.len()))?;
        Ok(data)
    }
}

struct XmlReader<'a> {
    file: &'a [u8],
    xml: Reader<&'a [u8]>,
    data: OsmData,
    current: Option<Current>,
    /// How many tags are open, the root included.
    depth: usize,
}

impl<'a> XmlReader<'a> {
    fn line(&self) -> usize {
        let end = usize::try_from(self.xml.error_position().max(self.xml.buffer_position())).unwrap_or(usize::MAX);
        1 + self.file[..end.min(self.file.len())].iter().filter(|byte| **byte == b'\n').count()
    }

    fn event(&mut self) -> Result<Event<'a>, OsmError> {
        self.xml.read_event().map_err(|error| {
            let why = match error {
                quick_xml::Error::Encoding(_) => "the text is not UTF-8: convert it, for example with iconv".to_owned(),
                other => other.to_string(),
            };
            OsmError::Xml { line: self.line(), why }
        })
    }

    /// Goes on to the root, which has to be `<osm>`.
    fn root(&mut self) -> Result<(), OsmError> {
        loop {
            let found = match self.event()? {
                Event::Start(tag) if tag.name().as_ref() == "osm" => {
                    self.depth = 1;
                    return Ok(());
                }
                Event::Empty(tag) if tag.name().as_ref() == "osm" => return Ok(()),
                Event::Start(tag) | Event::Empty(tag) => format!("`<{}>`", clip(tag.name().as_ref())),
                Event::Text(text) if !text.trim().is_empty() => format!("`{}`", clip(text.trim())),
                Event::Eof => "the end of the file".to_owned(),
                _ => continue,
            };
            return Err(OsmError::NotOsm { line: self.line(), found });
        }
    }

    fn all(&mut self) -> Result<(), OsmError> {
        while self.depth > 0 {
            match self.event()? {
                Event::Start(tag) => {
                    self.depth += 1;
                    self.start(&tag)?;
                }
                Event::Empty(tag) => {
                    self.depth += 1;
                    self.start(&tag)?;
                    self.end()?;
                }
                Event::End(_) => self.end()?,
                Event::Eof => return Err(OsmError::CutOff(self.line())),
                _ => {}
            }
        }
        Ok(())
    }

    fn start(&mut self, tag: &BytesStart<'a>) -> Result<(), OsmError> {
        match (tag.name().as_ref(), self.current.is_some()) {
            ("node", false) => self.open(tag, Kind::Node),
            ("way", false) => self.open(tag, Kind::Way),
            ("relation", false) => self.open(tag, Kind::Relation),
            ("tag", true) => self.tag(tag),
            ("nd", true) => {
                let id = self.whole(tag, "ref")?;
                self.data.add_ref(id).map_err(|full| self.full(full))
            }
            ("member", true) => self.member(tag),
            ("bounds", false) => {
                self.bounds(tag);
                Ok(())
            }
            _ => Ok(()),
        }
    }

    fn open(&mut self, tag: &BytesStart<'a>, kind: Kind) -> Result<(), OsmError> {
        let id = self.whole(tag, "id")?;
        let said = |name, value| attribute(tag, name).as_deref() == Some(value);
        // As the database and as an editor tell of it. A deleted node has no place.
        let gone = said("visible", "false") || said("action", "delete");
        let at = if kind == Kind::Node && !gone { self.place(tag, id)? } else { [f64::NAN; 2] };
        self.current = Some(Current { kind, id, at, gone, open: self.data.open(), depth: self.depth });
        Ok(())
    }

    fn end(&mut self) -> Result<(), OsmError> {
        if let Some(current) = self.current.take_if(|current| current.depth == self.depth && !current.gone) {
            let done = match current.kind {
                Kind::Node => self.data.add_node(current.id, current.at, &current.open),
                Kind::Way => self.data.add_way(current.id, &current.open),
                Kind::Relation => self.data.add_relation(current.id, &current.open),
            };
            done.map_err(|full| self.full(full))?;
        }
        self.current.take_if(|current| current.depth == self.depth);
        self.depth -= 1;
        Ok(())
    }

    fn tag(&mut self, tag: &BytesStart<'a>) -> Result<(), OsmError> {
        let (Some(key), Some(value)) = (attribute(tag, "k"), attribute(tag, "v")) else {
            return Err(OsmError::Attribute { line: self.line(), element: "tag".to_owned(), attribute: "k" });
        };
        let tag = [&key, &value].map(|word| self.data.number(word));
        let [key, value] = tag;
        let added = key.and_then(|key| self.data.add_tag([key, value?]));
        added.map_err(|full| self.full(full))
    }

    fn member(&mut self, tag: &BytesStart<'a>) -> Result<(), OsmError> {
        let id = self.whole(tag, "ref")?;
        let element = match attribute(tag, "type").as_deref() {
            Some("node") => Element::Node(id),
            Some("relation") => Element::Relation(id),
            _ => Element::Way(id),
        };
        let role = attribute(tag, "role").unwrap_or_default();
        let added = self.data.number(&role).and_then(|role| self.data.add_member(element, role));
        added.map_err(|full| self.full(full))
    }

    /// Degrees of latitude and longitude.
    fn place(&self, tag: &BytesStart<'a>, id: i64) -> Result<[f64; 2], OsmError> {
        let at = [self.number(tag, "lat")?, self.number(tag, "lon")?];
        if is_on_earth(at) { Ok(at) } else { Err(OsmError::Place(id)) }
    }

    fn full(&self, _: Full) -> OsmError {
        OsmError::TooLarge(self.file.len())
    }

    fn bounds(&mut self, tag: &BytesStart<'a>) {
        let edge = |name: &str| attribute(tag, name)?.parse::<f64>().ok().filter(|edge| edge.abs() <= 180.0);
        let edges = ["minlat", "minlon", "maxlat", "maxlon"].map(edge);
        if let [Some(south), Some(west), Some(north), Some(east)] = edges {
            self.data.set_bounds([south, west, north, east]);
        }
    }

    fn whole(&self, tag: &BytesStart<'a>, name: &'static str) -> Result<i64, OsmError> {
        attribute(tag, name).and_then(|text| text.parse().ok()).ok_or_else(|| self.missing(tag, name))
    }

    fn number(&self, tag: &BytesStart<'a>, name: &'static str) -> Result<f64, OsmError> {
        let number = attribute(tag, name).and_then(|text| text.parse::<f64>().ok());
        number.filter(|number| number.is_finite()).ok_or_else(|| self.missing(tag, name))
    }

    fn missing(&self, tag: &BytesStart<'a>, attribute: &'static str) -> OsmError {
        OsmError::Attribute { line: self.line(), element: clip(tag.name().as_ref()), attribute }
    }
}

/// An attribute with its entities resolved.
fn attribute(tag: &BytesStart<'_>, name: &str) -> Option<String> {
    let mut attributes = tag.attributes();
    let found = attributes.with_checks(false).filter_map(Result::ok).find(|found| found.key.as_ref() == name)?;
    // Entities that XML does not have stay as they are.
    Some(quick_xml::escape::unescape(&found.value).map_or_else(|_| found.value.to_string(), |plain| plain.into_owned()))
}
