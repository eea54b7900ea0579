//! OpenStreetMap's PBF, read block by block. A block is unpacked within bounds, so that a small file cannot take much memory.

use super::block::{Block, block, unpacked};
use super::data::{Element, OsmData};
use super::wire::{Content, Fields, numbers, summed, unfolded};
use super::words::{Full, Room};
use super::{LARGEST, OsmError, is_on_earth};

/// The data takes at most this many times the bytes that were read, and this many bytes more.
const DENSE: usize = 12;
const SPARE: usize = 256 << 10;
/// Features of the format that are read.
const FEATURES: [&[u8]; 2] = [b"OsmSchema-V0.6", b"DenseNodes"];

impl OsmData {
    /// Reads OpenStreetMap's XML or PBF, whichever the bytes are. Costs one pass over the file and a sort of its elements.
    ///
    /// ```
    /// use vc_map::osm::OsmData;
    /// let data = OsmData::read(br#"<osm version="0.6"><node id="1" lat="48.1" lon="11.5"/></osm>"#)?;
    /// assert_eq!(data.counts(), [1, 0, 0]);
    /// # Ok::<(), vc_map::osm::OsmError>(())
    /// ```
    ///
    /// # Errors
    /// Those of [`Self::from_xml`] and [`Self::from_pbf`].
    pub fn read(file: &[u8]) -> Result<Self, OsmError> {
        // Text has no byte of zero; the length of a block's header begins with two.
        if file.starts_with(&[0, 0]) { Self::from_pbf(file) } else { Self::from_xml(file) }
    }

    /// Reads OpenStreetMap's PBF, with blocks that are packed by zlib or not at all. The data takes at most 20 times the
    /// bytes of the file.
    ///
    /// ```
    /// let error = vc_map::osm::OsmData::from_pbf(&[0, 0, 0, 200, 1]).unwrap_err();
    /// assert_eq!(error.to_string(), "byte 0: the file ends within a block; OpenStreetMap's PBF was expected");
    /// ```
    ///
    /// # Errors
    /// [`OsmError::Pbf`] with the byte of the block: no PBF, another packing, features that are not read.
    pub fn from_pbf(file: &[u8]) -> Result<Self, OsmError> {
        if file.len() > LARGEST {
            return Err(OsmError::TooLarge(file.len()));
        }
        let mut data = Self::of_file(file.len(), Room::default());
        let (mut at, mut begun) = (0, false);
        while at < file.len() {
            let wrong = |why| OsmError::Pbf { byte: at, why };
            let (kind, blob, next) = block(file, at).map_err(wrong)?;
            // A block brings the room that its elements may take.
            data.room.0 += DENSE * (next - at) + if begun { 0 } else { SPARE };
            match kind {
                b"OSMHeader" => data.header(&unpacked(blob).map_err(wrong)?).map_err(wrong)?,
                b"OSMData" if begun => data.block(blob).map_err(wrong)?,
                _ if !begun => return Err(wrong("the first block is no header")),
                _ => {}
            }
            begun = true;
            at = next;
        }
        if !begun {
            return Err(OsmError::Pbf { byte: 0, why: "the file is empty" });
        }
        data.close().map_err(|full| OsmError::Pbf { byte: at, why: dense(full) })?;
        Ok(data)
    }
}

fn dense(_: Full) -> &'static str {
    "the blocks hold far more than those of a map"
}

/// The lists of an element: by the number of their field.
#[derive(Default)]
struct Lists<'a> {
    id: u64,
    numbers: [u64; 2],
    lists: [&'a [u8]; 12],
}

impl<'a> Lists<'a> {
    fn new(message: &'a [u8]) -> Result<Self, &'static str> {
        let mut lists = Self::default();
        let mut fields = Fields::new(message);
        for (field, content) in &mut fields {
            match (field, content) {
                (1, Content::Number(id)) => lists.id = id,
                (8 | 9, Content::Number(number)) => lists.numbers[field as usize - 8] = number,
                (1..=11, Content::Bytes(bytes)) => lists.lists[field as usize] = bytes,
                _ => {}
            }
        }
        if fields.broken { Err(BROKEN) } else { Ok(lists) }
    }
}

const BROKEN: &str = "a block breaks off";

impl OsmData {
    fn header(&mut self, block: &[u8]) -> Result<(), &'static str> {
        for (field, content) in Fields::new(block) {
            match (field, content) {
                (1, Content::Bytes(bounds)) => {
                    let mut edges = [0.0; 4];
                    for (field, content) in Fields::new(bounds) {
                        // Left, right, top, bottom, in thousand-millionths of a degree.
                        let Content::Number(number) = content else { continue };
                        let Some(edge) = [1, 3, 2, 0].get((field as usize).wrapping_sub(1)).copied() else { continue };
                        edges[edge] = unfolded(number) as f64 * 1e-9;
                    }
                    if edges.iter().all(|edge| edge.abs() <= 180.0) {
                        self.set_bounds(edges);
                    }
                }
                (4, Content::Bytes(feature)) if !FEATURES.contains(&feature) => {
                    return Err("the file needs a feature that is not read: convert with osmium");
                }
                _ => {}
            }
        }
        Ok(())
    }

    fn block(&mut self, blob: &[u8]) -> Result<(), &'static str> {
        let content = unpacked(blob)?;
        let mut block = Block::new(&content, blob.len())?;
        let mut fields = Fields::new(&content);
        for (field, content) in &mut fields {
            let (2, Content::Bytes(group)) = (field, content) else { continue };
            let mut elements = Fields::new(group);
            for (kind, content) in &mut elements {
                let Content::Bytes(message) = content else { continue };
                match kind {
                    1 => self.node_message(&mut block, message)?,
                    2 => self.dense(&mut block, message)?,
                    3 => self.way_message(&mut block, message)?,
                    4 => self.relation_message(&mut block, message)?,
                    _ => {}
                }
            }
            if elements.broken {
                return Err(BROKEN);
            }
        }
        if fields.broken { Err(BROKEN) } else { Ok(()) }
    }

    fn tag_of(&mut self, block: &mut Block<'_>, key: u64, value: u64) -> Result<(), &'static str> {
        let tag = block.word(self, key).and_then(|key| Ok([key, block.word(self, value)?]));
        tag.and_then(|tag| self.add_tag(tag)).map_err(dense)
    }

    fn tags_of(&mut self, block: &mut Block<'_>, lists: &Lists<'_>) -> Result<(), &'static str> {
        let mut tags = numbers(lists.lists[2]).zip(numbers(lists.lists[3]));
        tags.try_for_each(|(key, value)| self.tag_of(block, key, value))
    }

    fn place(&mut self, id: i64, at: [f64; 2], open: &super::data::Open) -> Result<(), &'static str> {
        if !is_on_earth(at) {
            return Err("a node is not on Earth");
        }
        self.add_node(id, at, open).map_err(dense)
    }

    fn node_message(&mut self, block: &mut Block<'_>, message: &[u8]) -> Result<(), &'static str> {
        let (lists, open) = (Lists::new(message)?, self.open());
        self.tags_of(block, &lists)?;
        self.place(unfolded(lists.id), block.degrees(lists.numbers.map(unfolded)), &open)
    }

    fn dense(&mut self, block: &mut Block<'_>, message: &[u8]) -> Result<(), &'static str> {
        let lists = Lists::new(message)?;
        let mut tags = numbers(lists.lists[10]);
        let places = summed(lists.lists[8]).zip(summed(lists.lists[9]));
        for (id, (latitude, longitude)) in summed(lists.lists[1]).zip(places) {
            let open = self.open();
            // Keys and values in turn, a zero behind those of each node.
            while let Some(key) = tags.next().filter(|key| *key != 0) {
                self.tag_of(block, key, tags.next().unwrap_or(0))?;
            }
            self.place(id, block.degrees([latitude, longitude]), &open)?;
        }
        Ok(())
    }

    fn way_message(&mut self, block: &mut Block<'_>, message: &[u8]) -> Result<(), &'static str> {
        let (lists, open) = (Lists::new(message)?, self.open());
        self.tags_of(block, &lists)?;
        summed(lists.lists[8]).try_for_each(|node| self.add_ref(node)).map_err(dense)?;
        self.add_way(lists.id as i64, &open).map_err(dense)
    }

    fn relation_message(&mut self, block: &mut Block<'_>, message: &[u8]) -> Result<(), &'static str> {
        let (lists, open) = (Lists::new(message)?, self.open());
        self.tags_of(block, &lists)?;
        let members = summed(lists.lists[9]).zip(numbers(lists.lists[10])).zip(numbers(lists.lists[8]));
        for ((id, kind), role) in members {
            let element = match kind {
                0 => Element::Node(id),
                1 => Element::Way(id),
                _ => Element::Relation(id),
            };
            let role = block.word(self, role).map_err(dense)?;
            self.add_member(element, role).map_err(dense)?;
        }
        self.add_relation(lists.id as i64, &open).map_err(dense)
    }
}
